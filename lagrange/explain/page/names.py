"""Shorter names on a printed page, where nothing else could be meant.

With a single particle or body P the index says nothing: m r'' = F + R. With a single constraint the reaction needs none
either: T, N or λ. With several, words that all names share are dropped: T_upper for the tension of the upper rod, if
the other is the lower rod. Programs see the full names, JSON and the labels of equations for screen readers too.

A long denominator that several results share gets a letter: F_1 = .../Δ, F_2 = .../Δ, with Δ in the same box.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterator
from dataclasses import replace

import sympy as sp

from lagrange.core.expression_size import count_operations
from lagrange.core.symbols import free_letter
from lagrange.core.vectors import FIXED
from lagrange.document.derivation import Block, Display, Equation, Step
from lagrange.explain.limits import SHORTEST_NAMED, SHORTEST_OF_MANY
from lagrange.mechanics.dynamics.newton import short_reactions
from lagrange.mechanics.results import Solution
from lagrange.mechanics.rewriting.factors import letter_for

VECTORS = ("r", "v", "F", "R", "omega", "H", "M", "Gamma", "pi", "Phi")
"""Position, velocity, forces, angular velocity and momentum, moments, virtual rotation, reactive force."""


def short_names(solution: Solution, taken: Collection[str]) -> dict[str, str]:
    """The shorter names by the full ones; `taken`: letters that the page uses for something else."""
    used = {*solution.problem.scope.names(), *taken}
    used |= {q.name for c in solution.choices for q in c.configuration.slots.coordinates}
    return {
        **dict(_of_vectors(solution, used)),
        **_of_reactions(solution, used),
        **_of_quasi_coordinates(solution, used),
        **_of_frictions(solution, used),
    }


def _of_frictions(solution: Solution, used: Collection[str]) -> dict[str, str]:
    """F_1 and F_2 for the friction forces F_rub_1 and F_rub_2, where all names begin alike."""
    rests = (v.at_rest for v in solution.views if v.at_rest is not None)
    forces = dict.fromkeys(f.name for rest in rests for c in rest.contacts for f in c.components)
    parts = [name.split("_") for name in forces]
    if len(parts) < 2 or any(len(p) != 3 for p in parts) or len({p[1] for p in parts}) > 1:
        return {}
    short = {name: f"{letter}_{end}" for name, (letter, _, end) in zip(forces, parts, strict=True)}
    return short if not {*used}.intersection(short.values()) else {}


def _of_quasi_coordinates(solution: Solution, used: Collection[str]) -> dict[str, str]:
    """δπ_1 for δπ_ω_1, where all quasi-velocities are ω_1, ω_2, ..., each with a number of its own."""
    form = solution.own.in_speeds
    names = () if form is None else tuple(u.name for u in form.velocities.symbols)
    numbers = [name.partition("_")[2] for name in names]
    if len({*numbers}) < len(names) or not all(n.isdigit() for n in numbers):
        return {}
    short = {f"pi_{name}": f"pi_{n}" for name, n in zip(names, numbers, strict=True)}
    return short if not {*used}.intersection(short.values()) else {}


def _of_vectors(solution: Solution, used: Collection[str]) -> Iterator[tuple[str, str]]:
    """Of the only particle or body, of its axes, and of bodies called one and other: r_1 and r_2.

    A scalar of the same letter is not bold: r = r e_r.
    """
    configuration = solution.own.configuration
    names = {p.name for p in configuration.points} | {r.name for r in configuration.rotations}
    scope = solution.problem.scope
    if names >= {"one", "other"}:
        numbered = {
            f"{letter}_{name}": f"{letter}_{n}" for letter in VECTORS for n, name in enumerate(("one", "other"), 1)
        }
        yield from numbered.items() if not {*used}.intersection(numbered.values()) else ()
    turning = [r for r in configuration.rotations if r.angular_velocity.triad != FIXED or len(names) == 1]
    if len(turning) == 1:  # the axes of the only body that has any
        [rotation] = turning
        for unit in dict.fromkeys(
            (*rotation.angular_velocity.triad.names, *(f"e{n}_{rotation.name}" for n in (1, 2, 3)))
        ):
            stem = unit.removesuffix(f"_{rotation.name}")
            if stem not in scope.vectors and stem not in used:
                yield unit, stem
    if len(names) != 1 or any(f.elsewhere for f in configuration.loads):
        return
    [name] = names
    if not any(letter in scope.vectors for letter in VECTORS):
        yield from ((f"{letter}_{name}", letter) for letter in VECTORS)


def _of_reactions(solution: Solution, used: Collection[str]) -> dict[str, str]:
    if solution.law is None:
        return {}
    return {symbol.name: short for symbol, short in short_reactions(solution.law.newton, used)}


# Denominators


def with_named_denominators(step: Step, taken: Collection[str]) -> Step:
    """The step with a letter for the denominator that lines of a box share."""
    return replace(step, body=tuple(_named(b, taken) for b in step.body))


def _named(block: Block, taken: Collection[str]) -> Block:
    if not isinstance(block, Display) or not block.boxed or len(block.equations) < 2:
        return block
    counts = Counter(base for e in block.equations for base in {*_below(e)})
    shared = [
        b
        for b, n in counts.items()
        if n > 1 and count_operations(b) >= (SHORTEST_NAMED if n == 2 else SHORTEST_OF_MANY)
    ]
    if len(shared) != 1:
        return block
    [base] = shared
    name = free_letter("Delta", "D", "D_0", taken=taken)
    letter = letter_for(base, name)
    lines = tuple(replace(e, sides=tuple(_with_letter(s, base, letter) for s in e.sides)) for e in block.equations)
    return replace(block, equations=(*lines, Equation((letter, base))))


def _below(equation: Equation) -> Iterator[sp.Expr]:
    """The sums in the denominators of its sides."""
    for side in equation.sides:
        if isinstance(side, sp.Expr):
            bases = (f.base for f in sp.Mul.make_args(side) if f.is_Pow and f.exp == -1)
            inside = (b.args[0] if isinstance(b, sp.Abs) else b for b in bases)
            yield from (b for b in inside if b.is_Add)


def _with_letter(side: object, base: sp.Expr, letter: sp.Symbol) -> object:
    if not isinstance(side, sp.Expr) or not side.is_Mul:
        return side
    short = {base: letter, sp.Abs(base): sp.Abs(letter)}
    factors = [1 / short[f.base] if f.is_Pow and f.exp == -1 and f.base in short else f for f in side.args]
    return sp.Mul(*factors, evaluate=False) if factors != list(side.args) else side
