"""Conserved quantities with their proofs, and the energy balance where energy is not conserved."""

from __future__ import annotations

from collections.abc import Collection, Sequence

import sympy as sp

from lagrange.core.expression_size import count_operations
from lagrange.core.symbols import CONSTANT, TimeDerivative, Unspecified, variation
from lagrange.document.derivation import (
    Block,
    Detail,
    Equation,
    EquationKind,
    Part,
    Phrase,
    Purpose,
    Ref,
    Rule,
    Step,
    display,
    listed,
    math,
    prose,
    series,
)
from lagrange.explain.limits import LONGEST_INTEGRAL, MOST_MULTIPLES
from lagrange.explain.motion import label_from_principle
from lagrange.explain.words import are, constraints_called, plural, suffix_of, title_in
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.conservation import (
    Because,
    Conserved,
    ConservedQuantity,
    EnergyRate,
    Integral,
    quantity_of,
)

SMALL = ("epsilon", "eta", "delta", "zeta")
"""Letters for a small number; the first that the problem does not use is taken."""


def explain_conserved(
    conserved: Conserved, choice: str = "", taken: Collection[str] = (), *, proofs: bool = True
) -> Step | None:
    """The integrals with their proofs, and the rate of the energy; None if there is neither.

    taken   names that the problem uses
    proofs  whether the equations of motion of which they are integrals are on the page
    """
    body: list[Block] = []
    small = sp.Symbol(next((n for n in SMALL if n not in taken), SMALL[0]), real=True)
    for because in Because:
        members = [i for i in conserved.integrals if i.because is because]
        body += _shown(conserved, members, choice, small, proofs=proofs) if members else []
    if conserved.bound:
        body.append(_bound(tuple(conserved.bound)))
    if conserved.undecided:
        names = listed(math(q) for q in conserved.undecided)
        whose = plural(len(conserved.undecided), "the momentum of ", "the momenta of ")
        body.append(prose("It could not be decided whether ", whose, *names, are(conserved.undecided), "conserved."))
    quantities = "Conserved quantities" if body else ""
    if conserved.energy is not None:
        body += _of_energy(conserved.energy, choice, conserved.motion.configuration)
        quantities = f"{quantities} and energy balance" if quantities else "Energy balance"
    return Step(Rule.CONSERVED, title_in(quantities, choice), tuple(body)) if body else None


def _shown(
    conserved: Conserved, integrals: Sequence[Integral], choice: str, small: sp.Symbol, *, proofs: bool
) -> list[Block]:
    """Integrals for one reason: why, the proof, and the equations."""
    suffix = suffix_of(choice)
    lines = [
        Equation(
            (i.expression, CONSTANT),
            label=f"conserved{suffix}-{conserved.integrals.index(i) + 1}",
            kind=EquationKind.CONSERVED,
        )
        for i in integrals
    ]
    long = any(count_operations(i.expression) > LONGEST_INTEGRAL for i in integrals)
    ending = "." if long else ":"
    return [
        prose(*_reason(conserved, integrals, small), ". ", *_conclusion(conserved, integrals, proofs=proofs), ending),
        display(*lines, boxed=True, detail=Detail.FULL if long else Detail.STEPS),
    ]


def _reason(conserved: Conserved, integrals: Sequence[Integral], small: sp.Symbol) -> tuple[Part, ...]:
    first = integrals[0]
    coordinates = [i.coordinate for i in integrals if i.coordinate is not None]
    names = listed(math(q) for q in coordinates)
    cyclic = f"{are(coordinates)}cyclic"
    match first.because:
        case Because.CYCLIC:
            return (*names, f"{cyclic}, and the forces do no net work in ", *_varied(coordinates))
        case Because.NO_REACTION:
            return (*names, f"{cyclic}, and in the end no reaction does work in ", *_varied(coordinates))
        case Because.GAUGE:
            forces = plural(len(coordinates), "the force along it is the", "the forces along them are the")
            rates = plural(len(coordinates), "rate of change of a function", "rates of change of functions")
            return (*names, f"{cyclic}, and {forces} {rates} of the position")
        case Because.RATE:
            moved = [(" ", *_displaced(i, small)) for i in integrals]
            return (plural(len(integrals), "In the displacement", "In each of the displacements"), *_joined(moved),
                    " the change of the kinetic minus the potential energy, together with the work of the other "
                    "forces, is ", math(small), " times the rate of change of a function of the position")  # fmt: skip
        case Because.TIME_RATE:
            return ("Time appears only in such a way that the power it brings in is the rate of change of a function "
                    "of position and time",)  # fmt: skip
        case Because.DEPENDENT:
            return ("The prescribed motions turn out to supply no net power",)
        case Because.SCREW:
            moved = [(" ", *_displaced(i, small)) for i in integrals]
            screws = plural(len(integrals), "The screw displacement", "The screw displacements")
            return (screws, *_joined(moved), _NOTHING_MORE if len(integrals) > 1 else _NOTHING)
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
            if not conserved.potential:
                return ("No force does work",)
            return ("Every force that does work derives from a time-independent potential",)
        case Because.TIME_FREE:
            others = (
                "every force that does work derives from a potential" if conserved.potential else "no force does work"
            )
            return (f"Time appears in the positions but in neither energy, and {others}",)
        case Because.CARRIED:
            return ("A shift of time by ", math(small), ", together with the displacement ",
                    *_displaced(first, small), ", changes nothing")  # fmt: skip


_NOTHING = " changes neither energy, and the forces do no net work in it"
_NOTHING_MORE = " change neither energy, and the forces do no net work in them"


def _joined(items: Sequence[tuple[Part, ...]]) -> list[Part]:
    """`x and y`; with semicolons where an item is a list itself: `in x and y; in y and z; and in z and x`."""
    nested = any(len(item) > 2 for item in items)
    between, last = (";", "; and") if nested else (",", " and")
    separators = ["", *[between] * (len(items) - 2), last]
    return [part for separator, item in zip(separators, items, strict=False) for part in (separator, *item)]


def _varied(coordinates: Sequence[sp.Symbol]) -> tuple[Part, ...]:
    return listed((math(variation(q)) for q in coordinates), " or ")


def _displaced(integral: Integral, small: sp.Symbol) -> tuple[Part, ...]:
    """δx₁ = δx₂ = ε, or δx = −ε y and δy = ε x."""
    moved = integral.displacement or {}
    if set(moved.values()) == {sp.S.One}:
        return (math(*(variation(q) for q in moved), small),)
    return listed(math(variation(q), small * x) for q, x in moved.items())


_CALLED = {
    ConservedQuantity.MOMENTUM: ("the momentum", "the momenta"),
    ConservedQuantity.ANGULAR_MOMENTUM: ("the angular momentum", "the angular momenta"),
    ConservedQuantity.ENERGY: ("the energy", "the energies"),
    ConservedQuantity.JACOBI: ("Jacobi's integral", "Jacobi's integrals"),
}


_COMBINED = ("the combined momentum along and about the axis", "the combined momenta along and about the axes")


def _conclusion(conserved: Conserved, integrals: Sequence[Integral], *, proofs: bool) -> tuple[Part, ...]:
    """`Therefore (11) and (13) times C are the rates of change of the momenta, which are constant`."""
    several, first = len(integrals) > 1, integrals[0]
    configuration = conserved.motion.configuration
    quantities = {quantity_of(i, configuration) for i in integrals}
    quantity = quantities.pop() if len(quantities) == 1 else first.quantity
    one, more = _COMBINED if first.because is Because.SCREW else _CALLED[quantity]
    named = [proof_of(conserved, i) for i in integrals] if proofs else []
    if not named or not all(named):
        return (f"Along the motion {more if several else one} {'are' if several else 'is'} constant",)
    if several and first.because is Because.RATE:
        return ("Therefore combinations of the equations of motion can be integrated",)
    if several and any(len([m for m in i.multipliers if m != 0]) > 1 for i in integrals):
        return (
            f"Therefore combinations of the equations of motion are the rates of change of {more}, which are constant",
        )
    words = series(named)
    if first.because in (Because.GAUGE, Because.RATE):
        return ("Therefore ", *words, " can be integrated")
    rate = f" are the rates of change of {more}, which are" if several else f" is the rate of change of {one}, which is"
    return ("Therefore ", *words, f"{rate} constant")


def proof_of(conserved: Conserved, integral: Integral) -> tuple[Part, ...]:
    """`the sum of θ̇ times (11) and φ̇ times (12)`: the combination of equations that is the rate of an integral."""
    used = [(m, e) for m, e in zip(integral.multipliers, conserved.motion.equations, strict=False) if m != 0]
    terms: list[tuple[Part, ...]] = []
    for m, e in used:
        reference = Ref(label_from_principle(conserved.motion, e))
        factor: tuple[Part, ...] = ("(", math(m), ")") if m.is_Add else (math(m),)
        terms.append((reference,) if m == 1 else (*factor, " times ", reference))
    if len(terms) < 2:
        return terms[0] if terms else ()
    if len(terms) > MOST_MULTIPLES:
        return ("a combination of the equations of motion",)
    return ("the sum of ", *series(terms))


def _bound(coordinates: tuple[sp.Symbol, ...]) -> Block:
    names = listed(math(q) for q in coordinates)
    what = plural(len(coordinates), "its momentum is", "their momenta are")
    return prose("Although ", *names, f"{are(coordinates)}cyclic, {what} not conserved: reactions do work in ",
                 *_varied(coordinates), ".")  # fmt: skip


def _of_energy(energy: EnergyRate, choice: str, configuration: Configuration) -> list[Block]:
    if energy.rate is None:
        return [prose("It could not be decided whether the energy is conserved.")]
    moving = plural(len(energy.driven), "moves, and its reaction does work", "move, and their reactions do work")
    why = f": {constraints_called(energy.driven)} {moving}" if energy.driven else ""
    if energy.driven and all(r.nonlinear is not None for r in configuration.rows if r.name in energy.driven):
        why = f": the {plural(len(energy.driven), 'reaction', 'reactions')} of {constraints_called(energy.driven)} "
        why += plural(len(energy.driven), "does work", "do work")
    line = Equation(
        (TimeDerivative(energy.expression), energy.rate),
        label=f"energy-rate{suffix_of(choice)}",
        kind=EquationKind.ENERGY_RATE,
    )
    if energy.hidden:
        return [
            prose("The forces that depend on position alone have a potential, which was not found; without it the "
                  "energy changes at the rate"),
            display(line, boxed=True),
        ]  # fmt: skip
    if energy.rate.has(Unspecified):  # the forces may, or may not, have a potential
        return [prose("Along the motion the energy changes at the rate"), display(line)]
    along = Phrase(" Along the motion", Purpose.ALONG)
    slots = configuration.slots
    rate = None if energy.driven else energy.vanishes_with({*slots.coordinates, *slots.velocities, *slots.prescribed})
    unless: tuple[Part, ...] = () if rate is None else (" unless ", math(rate, sp.S.Zero))
    return [prose("The energy is not conserved", *unless, f"{why}.", along), display(line, boxed=True)]
