"""Reading the equations of an answer, displacements in them, and radii among its coordinates.

An equation is a text, or comes from SymPy and needs no reading. Its components are zero; what cannot be read is part of
the result, because the other equations still count.

In x = r cos φ, y = r sin φ nothing makes r positive: (−r, φ + π) is the same place as (r, φ), the distance from the
origin is |r|, and Newton's attraction G/(r |r|). Books take r > 0, which excludes no place, and write G/r². So an
answer that is right for r > 0 is right, with a remark. A coordinate r is a radius if every place with r < 0 is also one
with r > 0: positions do not change when r changes sign and one or two angles become φ + π or π − θ. No body may be
turned by that.

Equations between displacements are δz = λ δφ, x dx + y dy = 0, and d'Alembert's principle. Such an equation is linear
and homogeneous in the displacements. With possible displacements dq, dt it states what it states of the velocities,
for dq = q' dt. With virtual displacements, A δq = 0, the dependent ones are substituted first; then it holds for all
virtual displacements if and only if the coefficient of each independent one vanishes,

    δz = λ δφ                     0 = 0                          if z = λ φ is a constraint: this is restated
    (m x'' + k x) δx = 0          m x'' + k x = 0                if x is free

and these coefficients are compared like any other equations.

What the name of a reaction may stand for in an answer.

In the derivation it is a force, where the reaction is a single one (`reaction_signs`). A textbook may take the opposite
force as positive, and with R = λ ∂f/∂r in mind the name may be that of the multiplier, with either sign in front of it.
So a name N may stand for ρ N of the derivation,

    ρ = 1, −1, 1/factor, −1/factor        (N = factor · λ; the last two where the factor is not ±1),

with one ρ for each name in the whole answer.
"""

from __future__ import annotations

import re
from collections import deque
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import field, replace
from functools import cached_property
from itertools import combinations, islice, product

import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.answers.limits import MAX_ANGLES, MOST_MEANINGS
from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError
from lagrange.core.records import record
from lagrange.core.symbols import Decimal, differential, prime, symbols_in, t, variation
from lagrange.core.vectors import Vector
from lagrange.document.math_writer import text
from lagrange.expressions.latex_layout import OneEquation
from lagrange.expressions.limits import MAX_ANSWER_CHARACTERS
from lagrange.expressions.reader import read_equation
from lagrange.expressions.scope import Scope
from lagrange.mechanics.constraints.displacements import virtual_displacements
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.comparison import System
from lagrange.mechanics.dynamics.newton import Newton, Reaction
from lagrange.mechanics.dynamics.reaction_signs import ForceKind, SingleForce

NOT_FOR_ALL = "it does not hold for all displacements that the constraints admit"


@record
class Reading:
    """One equation of an answer: its two sides and its components, each zero; or the error in reading it.

    other   the same text as it might also be read; None if there is no other way
    source  the text that was read, and the names in it, with those that have decimals in their definitions; None if
            there are no decimals that may have been rounded
    """

    text: str
    components: tuple[sp.Expr, ...] = ()
    error: ProblemError | None = None
    notes: list[Diagnostic] = field(default_factory=list)
    sides: tuple[sp.Expr | Vector, ...] = ()
    other: Reading | None = None
    source: tuple[Fragment, Scope] | None = None

    @cached_property
    def with_decimals(self) -> tuple[sp.Expr, ...]:
        """The components with symbols for the decimals that may have been rounded; none if there are no such decimals.

        See `lagrange.answers.written.decimals`.
        """
        if self.source is None:
            return ()
        reading = read_answer(*self.source)
        return reading.components if any(decimals_in(reading.components)) else ()

    @property
    def surprising(self) -> tuple[sp.Expr | Vector, ...]:
        """The two sides, if they may have been misread or were written in LaTeX; otherwise empty."""
        return self.sides if self.notes or set(self.text) & {"\\", "$"} else ()


@record
class GivenEquation(OneEquation):
    """An equation of an answer that is not a text, with its reading."""

    reading: Reading = field(default_factory=lambda: Reading(""))

    @classmethod
    def of_reading(cls, reading: Reading, name: str) -> GivenEquation:
        """The equation with this name in messages."""
        plain = Fragment.of(reading.text, name)
        return cls(plain.text, plain.whole, plain.start, reading)

    @classmethod
    def of_reading_at(cls, reading: Reading, place: Fragment) -> GivenEquation:
        """The equation that was read at a place."""
        beside = getattr(place, "beside", "")
        return cls(reading.text, place.span(0, len(place.text)), None, beside=beside, reading=reading)


def read_answer(fragment: Fragment, scope: Scope) -> Reading:
    """One equation of an answer, or its error; what was read last is remembered, since several questions read it."""
    if isinstance(fragment, GivenEquation):
        return fragment.reading
    for known, with_scope, reading in _LATEST:
        if known is fragment and with_scope is scope:
            return replace(reading, notes=[*reading.notes])
    reading = _read(fragment, scope)
    _LATEST.append((fragment, scope, reading))
    return replace(reading, notes=[*reading.notes])


_LATEST: deque[tuple[Fragment, Scope, Reading]] = deque(maxlen=32)
"""The fragments that were read last: the same object in the same scope has the same meaning."""


def _read(fragment: Fragment, scope: Scope) -> Reading:
    notes: list[Diagnostic] = []
    text = fragment.text.strip()
    try:
        equation = read_equation(fragment, scope, notes, MAX_ANSWER_CHARACTERS, latex=True)
    except ProblemError as error:
        return Reading(text, error=error)
    lhs, rhs = equation.lhs, equation.rhs
    if isinstance(lhs, Vector) and isinstance(rhs, Vector):
        parts = tuple(c for c in (lhs - rhs).components if c != 0) or (sp.S.Zero,)
        return Reading(text, parts, notes=notes, sides=(lhs, rhs))
    source = (fragment, replace(scope, decimals="")) if scope.decimals is None and has_decimals(text) else None
    return Reading(text, (sp.Add(lhs, -rhs),), notes=notes, sides=(lhs, rhs), source=source)


_DECIMAL = re.compile(r"[0-9](?:\.|\{,\})[0-9]|\.[0-9][0-9]|[0-9]{3}")


def has_decimals(text: str) -> bool:
    """Whether a text has numbers that may have been rounded."""
    return _DECIMAL.search(text) is not None


def decimals_in(expressions: Iterable[sp.Expr]) -> list[Decimal]:
    """The decimals that may have been rounded, in a fixed order."""
    return sorted({s for e in expressions for s in symbols_in(e) if isinstance(s, Decimal)}, key=lambda d: d.name)


def radii(system: System) -> tuple[sp.Symbol, ...]:
    """The radii on whose signs the equations of a system depend."""
    signed = {s for e in system.equations for part in _magnitudes(e) for s in part.free_symbols}
    coordinates = system.configuration.slots.coordinates
    return tuple(q for q in coordinates if q in signed and is_radius(q, system.configuration))


def with_positive_radii(e: sp.Expr, positive: Sequence[sp.Symbol]) -> sp.Expr:
    """An expression for positive values of some coordinates: |r| and √(r² cos² φ + r² sin² φ) become r."""
    symbols = {q: sp.Symbol(q.name, positive=True) for q in positive}
    e = e.xreplace(symbols)
    roots = [p for p in _magnitudes(e) if not p.free_symbols.isdisjoint(symbols.values())]
    e = e.xreplace({p: textbook_form(p) for p in roots if not isinstance(p, sp.sign)})
    return e.xreplace({symbol: q for q, symbol in symbols.items()})


def _magnitudes(e: sp.Expr) -> Iterator[sp.Expr]:
    """The parts of an expression that depend on a sign: magnitudes and roots."""
    yield from e.atoms(sp.Abs, sp.sign)
    yield from (p for p in e.atoms(sp.Pow) if p.exp.is_Rational and not p.exp.is_Integer)


def is_radius(r: sp.Symbol, configuration: Configuration) -> bool:
    """Whether every place with r < 0 is also one with r > 0."""
    others = [q for q in configuration.slots.coordinates if q != r]
    places = [c for p in configuration.points for c in p.position.fixed().components]
    if len(others) > MAX_ANGLES or not any(r in c.free_symbols for c in places):
        return False
    coordinates = configuration.slots.coordinates
    turning = {
        q for b in configuration.rotations for q, w in zip(coordinates, b.partials, strict=True) if not w.is_zero
    }
    angles = [q for q in others if q not in turning and any(_is_turned_by(c, q) for c in places)]
    return r not in turning and any(_unchanged(places, {r: -r, **turned}) for turned in _turns(angles))


def _is_turned_by(e: sp.Expr, q: sp.Symbol) -> bool:
    return any(q in w.free_symbols for w in e.atoms(sp.sin, sp.cos))


def _turns(angles: Sequence[sp.Symbol]) -> Iterator[dict[sp.Symbol, sp.Expr]]:
    """φ + π or π − θ, of one angle or two."""
    for number in (1, 2):
        for chosen in combinations(angles, number):
            for signs in product((1, -1), repeat=number):
                yield {q: sp.pi + sign * q for q, sign in zip(chosen, signs, strict=True)}


def _unchanged(places: Sequence[sp.Expr], rule: Mapping[sp.Symbol, sp.Expr]) -> bool:
    return all(is_zero(c.xreplace(dict(rule)) - c) is True for c in places)


# Displacements


def displaced_coordinates(expressions: Sequence[sp.Expr], coordinates: Sequence[sp.Symbol]) -> frozenset[sp.Symbol]:
    """The coordinates whose displacements, dq or δq, occur in expressions."""
    used = {s for e in expressions for s in symbols_in(e)}
    return frozenset(q for q in coordinates if used & {variation(q), differential(q)})


def without_displacements(equation: sp.Expr, configuration: Configuration) -> tuple[sp.Expr, ...]:
    """The equations, each zero, that state the same without displacements; the equation itself if it has none.

    One that is not linear and homogeneous in them is returned as it is, too.
    """
    slots = configuration.slots
    present = (*slots.coordinates, *configuration.expressed)
    used = symbols_in(equation)
    virtual = [variation(q) for q in present if variation(q) in used]
    possible = {d: rate for q in present if (d := differential(q)) in used for rate in [prime(q)]}
    if differential(t) in used:
        possible[differential(t)] = sp.S.One
    if bool(virtual) == bool(possible) or not _is_linear(equation, [*virtual, *possible]):
        return (equation,)
    if possible:
        return (configuration.rewritten(equation.xreplace(possible)),)
    chain = {
        variation(q): sp.Add(*(e.diff(p) * variation(p) for p in slots.coordinates))
        for q, e in configuration.expressed.items()
    }
    elimination = virtual_displacements(configuration.constrained)
    reduced = equation.xreplace(chain).xreplace(dict(elimination.solved(slots)))
    independent = [variation(slots.coordinates[k]) for k in elimination.independent]
    return tuple(reduced.diff(d) for d in independent if d in reduced.free_symbols) or (sp.S.Zero,)


def _is_linear(equation: sp.Expr, displacements: Sequence[sp.Symbol]) -> bool:
    """Whether an expression is linear and homogeneous in displacements."""
    rates = [equation.diff(d) for d in displacements]
    if any(not r.free_symbols.isdisjoint(displacements) for r in rates):
        return False
    return bool(equation.xreplace(dict.fromkeys(displacements, sp.S.Zero)) == 0)


# Force names


@record
class ForceMeaning:
    """ρ, and a description of what the name is taken to mean; empty if it agrees with the derivation."""

    ratio: sp.Expr
    remark: str


def meanings_of_force(reaction: Reaction) -> tuple[ForceMeaning, ...]:
    """The possible meanings of the name of one reaction, that of the derivation first."""
    name, single = reaction.force.name, reaction.single
    same = ForceMeaning(sp.S.One, "")
    opposite = ForceMeaning(sp.S.NegativeOne, _opposite(name, single))
    if single is None or abs(single.factor) == 1:
        return same, opposite
    what = "tension" if single.kind is ForceKind.TENSION else "force"
    remark = f"`{name}` is taken as the multiplier of the constraint; in the derivation it is the {what}"
    negative = f"`{name}` is taken as minus the multiplier of the constraint; in the derivation it is the {what}"
    per_force = 1 / single.factor
    return same, opposite, ForceMeaning(per_force, remark), ForceMeaning(-per_force, negative)


def _opposite(name: str, single: SingleForce | None) -> str:
    if single is None:
        return f"`{name}` is taken with the opposite sign; in the derivation it is the multiplier λ in R = λ ∂f/∂r"
    if single.kind is ForceKind.TENSION:
        return f"`{name}` is taken as a force that pushes; in the derivation it is a tension, positive if it pulls"
    if single.direction is None:
        return f"`{name}` is taken in the opposite direction"
    along, against = _along(single.direction), _along(-single.direction)
    return f"`{name}` is taken along {against} on `{single.on}`; in the derivation it acts along {along}"


def _along(direction: Vector) -> str:
    return f"`{text(direction.as_sum())}`"


@record
class NameReading:
    """One meaning for each name of reactions in an answer: `ratios` ρ by symbol, and remarks by name."""

    ratios: Mapping[sp.Symbol, sp.Expr]
    remarks: Mapping[str, str]


def other_readings(newton: Newton | None, used: Collection[str]) -> Iterator[NameReading]:
    """All readings of the names that an answer uses, except that of the derivation; `MOST_MEANINGS` at most.

    First those in which all names have the same kind of meaning, then those in which fewer of them differ.
    """
    named = [r for r in newton.reactions if r.given is not None and r.force.name in used] if newton else []
    kinds = [meanings_of_force(r) for r in named]
    choices = sorted(product(*(range(len(k)) for k in kinds)), key=_order)
    for choice in islice((c for c in choices if any(c)), MOST_MEANINGS):
        taken = {r.force: k[n] for r, k, n in zip(named, kinds, choice, strict=True) if n}
        yield NameReading({s: m.ratio for s, m in taken.items()}, {s.name: m.remark for s, m in taken.items()})


def _order(choice: Sequence[int]) -> tuple[bool, int, tuple[int, ...]]:
    return len(set(choice)) > 1, sum(n > 0 for n in choice), tuple(choice)
