"""What answers and equations say beside what was asked for: a way fallen, a velocity, reactions, momenta, orbits."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from lagrange.core.symbols import TimeDerivative, prime
from lagrange.document.derivation import Block, Detail, Emphasis, Equation, display, listed, math, prose
from lagrange.explain.words import plural, the
from lagrange.mechanics.consequences.answers import (
    closing_ratio,
    driven_momenta,
    fallen_way,
    steady_reactions,
    velocity_before,
)
from lagrange.mechanics.questions.results import Asked
from lagrange.mechanics.results import InCoordinates, Solution


def beside_answer(solution: Solution, asked: Asked, *, first: bool) -> Iterator[Block]:
    """What follows the answer to a question; `first`: the first of several about the same state."""
    fallen = fallen_way(solution, asked) if first else None
    if fallen is not None:
        what = f"The mass centre of {the(fallen.name)}" if fallen.is_body else the(fallen.name)
        yield prose(f"{what[:1].upper()}{what[1:]} has then fallen by ", math(fallen.way), ".", detail=Detail.BRIEF)
    inverted = velocity_before(solution, asked)
    if inverted is not None:
        yield prose("Solved for ", math(inverted.velocity), ", this is the velocity before the impact:",
                    detail=Detail.BRIEF)  # fmt: skip
        yield display(Equation((inverted.velocity, inverted.value)), detail=Detail.BRIEF)
    steady = [*steady_reactions(solution, asked)]
    if steady:
        yield prose("In such a state ", *listed(math(*pair) for pair in steady), ", whatever ",
                    *listed((math(asked.question.by),) if asked.question.by is not None else ("the position",)),
                    " is.", detail=Detail.BRIEF)  # fmt: skip


def explain_driven_momenta(view: InCoordinates) -> Iterator[Block]:
    """`φ appears in neither T nor V, so its equation of motion is d/dt [...] = L.`"""
    lines = [*driven_momenta(view)]
    if lines:
        names = listed(math(q) for q, _, _ in lines)
        appear = plural(len(lines), " itself appears", " themselves appear")
        its = plural(len(lines), "its equation of motion says", "their equations of motion say")
        yield prose(Emphasis(plural(len(lines), "Momentum", "Momenta")), ": ", *names, appear,
                    f" in neither the kinetic nor the potential energy, so {its} that")  # fmt: skip
        yield display(*(Equation((TimeDerivative(p), force)) for _, p, force in lines))


def explain_closing(view: InCoordinates) -> Iterator[Block]:
    """`ω/φ' = √3 sin α: to first order the disturbed motion closes if this is rational.`"""
    ratio = closing_ratio(view)
    if ratio is not None:
        phi, value = ratio
        omega = view.steady.families[0].about.omega if view.steady is not None else sp.Symbol("omega")
        yield prose(Emphasis("Closed orbits"), ": ", math(omega / sp.Abs(prime(phi)), value), ". To first order the "
                    "disturbed motion is closed if this is a rational number.")  # fmt: skip
