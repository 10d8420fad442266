"""What the equations of motion conserve, and how the energy changes where it is not conserved."""

from __future__ import annotations

from collections.abc import Collection, Sequence

import sympy as sp

from lagrange.core.symbols import CONSTANT, Rate, variation
from lagrange.document.derivation import Block, Detail, Equation, Part, Ref, Rule, Step, display, listed, math, prose
from lagrange.explain.motion import label_of
from lagrange.explain.words import plural, spoken
from lagrange.mechanics.dynamics.conservation import Because, Conserved, EnergyRate, Integral, Quantity

SMALL = ("epsilon", "eta", "delta", "zeta")
"""What a small number may be called; the first that the problem does not use."""
LONGEST = 150
"""Operations of an integral that is still shown without being asked for."""
MOST_TERMS = 6
"""Equations of motion whose multiples are named, where they add up to the rate of an integral."""


def explain_conserved(found: Conserved, choice: str = "", taken: Collection[str] = ()) -> Step | None:
    """The integrals with their proofs, and the rate of the energy; None where there is nothing to say.

    taken  names that the problem uses
    """
    body: list[Block] = []
    small = sp.Symbol(next((n for n in SMALL if n not in taken), SMALL[0]), real=True)
    for because in Because:
        members = [i for i in found.integrals if i.because is because]
        body += _shown(found, members, choice, small) if members else []
    if found.bound:
        body.append(_bound(tuple(found.bound)))
    if found.undecided:
        names = listed(math(q) for q in found.undecided)
        whose = plural(len(found.undecided), "the momentum that belongs to ", "the momenta that belong to ")
        body.append(prose("Whether ", whose, *names, plural(len(found.undecided), " is", " are"),
                          " conserved could not be decided."))  # fmt: skip
    body += _of_energy(found.energy, choice) if found.energy is not None else []
    title = f"What is conserved: {spoken(choice)}" if choice else "What is conserved"
    return Step(Rule.CONSERVED, title, tuple(body)) if body else None


def _shown(found: Conserved, integrals: Sequence[Integral], choice: str, small: sp.Symbol) -> list[Block]:
    """Integrals for one reason: why, the proof, and the equations."""
    suffix = f"-{choice}" if choice else ""
    lines = [
        Equation((i.expression, CONSTANT), label=f"conserved{suffix}-{found.integrals.index(i) + 1}") for i in integrals
    ]
    long = any(i.expression.count_ops() > LONGEST for i in integrals)
    ending = "." if long else ":"
    return [
        prose(*_reason(found, integrals, small), ". ", *_conclusion(found, integrals), ending),
        display(*lines, boxed=True, detail=Detail.FULL if long else Detail.STEPS),
    ]


def _reason(found: Conserved, integrals: Sequence[Integral], small: sp.Symbol) -> tuple[Part, ...]:
    first = integrals[0]
    coordinates = [i.coordinate for i in integrals if i.coordinate is not None]
    names = listed(math(q) for q in coordinates)
    occur = plural(len(coordinates), " does not occur", " do not occur")
    match first.because:
        case Because.CYCLIC:
            return (*names, f"{occur} in the energies, and nothing else does work in ", *_varied(coordinates))
        case Because.NO_REACTION:
            return (*names, f"{occur} in the energies, and of the reactions nothing is left that does work in ",
                    *_varied(coordinates))  # fmt: skip
        case Because.GAUGE:
            forces = plural(len(coordinates), "the force along it is the", "the forces along them are the")
            rates = plural(len(coordinates), "rate of change of a function", "rates of change of functions")
            return (*names, f"{occur} in the energies, and {forces} {rates} of the position")
        case Because.RATE:
            moved = [(" ", *_displaced(i, small)) for i in integrals]
            return (plural(len(integrals), "In the displacement", "In each of the displacements"), *_joined(moved),
                    " the change of the kinetic less the potential energy and the work of the other forces add up to ",
                    math(small), " times the rate of change of a function of the position")  # fmt: skip
        case Because.TIME_RATE:
            return ("Time occurs only in such a way that the power that it brings in is the rate of change of a "
                    "function of the position and time",)  # fmt: skip
        case Because.DEPENDENT:
            return ("What moves by itself turns out to have no power in sum",)
        case Because.ROTATION if len(integrals) > 1:
            planes = [(" in ", *listed(math(q) for q in i.displacement or ())) for i in integrals]
            return ("The rotations", *_joined(planes), _NOTHING_MORE)
        case Because.TRANSLATION | Because.ADMITTED if len(integrals) > 1:
            moved = [(" ", *_displaced(i, small)) for i in integrals]
            return ("The displacements", *_joined(moved), _NOTHING_MORE)
        case Because.ROTATION:
            return ("The rotation ", *_displaced(first, small), _NOTHING)
        case Because.TRANSLATION | Because.ADMITTED:
            return ("The displacement ", *_displaced(first, small), _NOTHING)
        case Because.CONSERVATIVE:
            if not found.potential:
                return ("Nothing does work",)
            return ("All that does work has a potential in which time does not occur",)
        case Because.TIME_FREE:
            else_ = "all else that does work has a potential" if found.potential else "nothing else does work"
            return (f"Time occurs in the positions, but in neither energy, and {else_}",)
        case Because.CARRIED:
            return ("A delay ", math(small), " together with the displacement ", *_displaced(first, small),
                    " changes nothing")  # fmt: skip


_NOTHING = " changes neither energy, and nothing else does work in it"
_NOTHING_MORE = " change neither energy, and nothing else does work in them"


def _joined(items: Sequence[tuple[Part, ...]]) -> list[Part]:
    """Items that may be lists themselves: `in x and y; in y and z; and in z and x`."""
    last = len(items) - 1
    return [
        part for n, item in enumerate(items) for part in (*((("; and" if n == last else ";"),) if n else ()), *item)
    ]


def _varied(coordinates: Sequence[sp.Symbol]) -> tuple[Part, ...]:
    return listed((math(variation(q)) for q in coordinates), " or ")


def _displaced(integral: Integral, small: sp.Symbol) -> tuple[Part, ...]:
    """δx₁ = δx₂ = ε, or δx = −ε y and δy = ε x."""
    moved = integral.displacement or {}
    if set(moved.values()) == {sp.S.One}:
        return (math(*(variation(q) for q in moved), small),)
    return listed(math(variation(q), small * x) for q, x in moved.items())


_CALLED = {
    Quantity.MOMENTUM: ("the momentum", "the momenta"),
    Quantity.ANGULAR_MOMENTUM: ("the angular momentum", "the angular momenta"),
    Quantity.ENERGY: ("the energy", "the energies"),
    Quantity.JACOBI: ("Jacobi's integral", "Jacobi's integrals"),
}


def _conclusion(found: Conserved, integrals: Sequence[Integral]) -> tuple[Part, ...]:
    """`Therefore (11) and (13) times C are the rates of change of the momenta, which are constant`."""
    several, first = len(integrals) > 1, integrals[0]
    one, more = _CALLED[first.quantity]
    proofs = [_proof(found, i) for i in integrals]
    if not all(proofs):
        return (f"Along the motion {more if several else one} {'stay' if several else 'stays'} constant",)
    if several and first.because is Because.RATE:
        return ("Therefore combinations of the equations of motion can be integrated",)
    if several and any(len([m for m in i.multipliers if m != 0]) > 1 for i in integrals):
        return (
            f"Therefore combinations of the equations of motion are the rates of change of {more}, which are constant",
        )
    words = [part for n, proof in enumerate(proofs) for part in (*((_between(n, len(proofs)),) if n else ()), *proof)]
    if first.because in (Because.GAUGE, Because.RATE):
        return ("Therefore ", *words, " can be integrated")
    rate = f" are the rates of change of {more}, which are" if several else f" is the rate of change of {one}, which is"
    return ("Therefore ", *words, f"{rate} constant")


def _between(n: int, number: int) -> str:
    return " and " if n == number - 1 else ", "


def _proof(found: Conserved, integral: Integral) -> tuple[Part, ...]:
    """`the sum of θ̇ times (11) and φ̇ times (12)`: what of the equations of motion is the rate of an integral."""
    used = [(m, e) for m, e in zip(integral.multipliers, found.motion.equations, strict=False) if m != 0]
    terms: list[tuple[Part, ...]] = []
    for m, e in used:
        reference = Ref(label_of(found.motion, e))
        factor: tuple[Part, ...] = ("(", math(m), ")") if m.is_Add else (math(m),)
        terms.append((reference,) if m == 1 else (*factor, " times ", reference))
    if len(terms) < 2:
        return terms[0] if terms else ()
    if len(terms) > MOST_TERMS:
        return ("a combination of the equations of motion",)
    parts = [part for n, term in enumerate(terms) for part in (*((_between(n, len(terms)),) if n else ()), *term)]
    return ("the sum of ", *parts)


def _bound(coordinates: tuple[sp.Symbol, ...]) -> Block:
    names = listed(math(q) for q in coordinates)
    occur = plural(len(coordinates), " does not occur", " do not occur")
    what = plural(len(coordinates), "its momentum is", "their momenta are")
    return prose("Although ", *names, f"{occur} in the energies, {what} not conserved: reactions do work in ",
                 *listed((math(variation(q)) for q in coordinates), " or "), ".")  # fmt: skip


def _of_energy(energy: EnergyRate, choice: str) -> list[Block]:
    if energy.rate is None:
        return [prose("Whether the energy is conserved could not be decided.")]
    names = listed(spoken(n) for n in energy.driven)
    moving = plural(len(energy.driven), "moves, and its reaction does work", "move, and their reactions do work")
    why: tuple[Part, ...] = ("; ", *names, f" {moving}") if energy.driven else ()
    line = Equation((Rate(energy.expression), energy.rate), label=f"energy-rate{f'-{choice}' if choice else ''}")
    if energy.hidden:
        return [
            prose("Forces that depend on the position only have a potential, which was not found; without it, ",
                  "the energy changes at the rate"),
            display(line, boxed=True),
        ]  # fmt: skip
    return [prose("The energy is not conserved", *why, ". Along the motion"), display(line, boxed=True)]
