"""Springs and dampers between two points at the distance d.

    spring   V = k (d − l)²/2 ,  pulls both ends with k (d − l)
    damper   pulls both ends with c d' , power −c d'²

A positive pull draws the ends together. On a straight line d = |s|. There the file may give the sign of s (`sense`,
that of r_2 − r_1), as a drawing does, or ranges of the coordinates that leave one sign only; otherwise |s| remains, and
sign s in the force. A damper needs no sign: −c d' along the line is −c s' along s.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import sympy as sp

from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.records import record
from lagrange.core.symbols import Slots, sign_between
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.limits import MOST_SQUARE_TERMS
from lagrange.problem.model import Damper, Problem, Range, Spring


class Link:
    """A spring or damper: an element between two points."""

    name: str

    @property
    def length_symbol(self) -> sp.Symbol:
        """The symbol for the distance of the ends: d_tie."""
        return sp.Symbol(f"d_{self.name}", real=True)


@record
class StretchedSpring(Link):
    """A spring in a configuration.

    ends      each end by the name of its particle or body, or else by its position
    apart     the vector from the second end to the first
    distance  d
    """

    name: str
    stiffness: sp.Expr
    length: sp.Expr
    ends: tuple[str | Vector, str | Vector]
    apart: Vector
    distance: sp.Expr

    @property
    def energy(self) -> sp.Expr:
        """k (d − l)²/2, written without a root if l = 0, and without |s|²."""
        d, l = self.distance, self.length
        if d.has(sp.Abs):
            return self.stiffness * (d**2 - 2 * l * d + l**2) / 2
        stretch = d - l
        negative = all(term.could_extract_minus_sign() for term in sp.Add.make_args(stretch))
        return self.stiffness * (-stretch if negative else stretch) ** 2 / 2

    @property
    def pull(self) -> sp.Expr:
        """The force with which it pulls its ends together."""
        return self.stiffness * (self.distance - self.length)


@record
class DamperForce(Link):
    """A damper in a configuration; fields as of a spring. On a straight line `distance` is s, whatever its sign.

    rate  d'
    """

    name: str
    coefficient: sp.Expr
    ends: tuple[str | Vector, str | Vector]
    apart: Vector
    distance: sp.Expr
    rate: sp.Expr

    @property
    def pull(self) -> sp.Expr:
        """The force with which it pulls its ends together."""
        return self.pull_at(self.rate)

    def pull_at(self, rate: sp.Expr) -> sp.Expr:
        """The same at another rate, as d' where it is only a letter."""
        return self.coefficient * rate


def stretched_springs(problem: Problem) -> tuple[StretchedSpring, ...]:
    """The springs in the coordinates of the file."""
    springs = []
    for f in problem.forces:
        if isinstance(f, Spring):
            apart = f.ends[0] - f.ends[1]
            length = _signed(_distance(apart), problem) if f.sense is None else -f.sense * sp.Add(*apart.components)
            springs.append(StretchedSpring(f.name, f.stiffness, f.length, _named(f.ends, problem), apart, length))
    return tuple(springs)


def damper_forces(problem: Problem) -> tuple[DamperForce, ...]:
    """The dampers in the coordinates of the file."""
    dampers = []
    for f in problem.forces:
        if isinstance(f, Damper):
            apart = f.ends[0] - f.ends[1]
            parts = [c for c in apart.components if c != 0]
            length = -parts[0] if len(parts) == 1 else _unsigned(_root(textbook_form(apart.dot(apart))))
            rate = textbook_form(problem.slots.time_derivative(length))
            dampers.append(DamperForce(f.name, f.coefficient, _named(f.ends, problem), apart, length, rate))
    return tuple(dampers)


def rewritten_spring(spring: StretchedSpring, rule: dict[sp.Basic, sp.Basic]) -> StretchedSpring:
    """The spring in other coordinates."""
    return replace(
        spring,
        stiffness=spring.stiffness.xreplace(rule),
        length=spring.length.xreplace(rule),
        ends=_rewritten(spring.ends, rule),
        apart=spring.apart.xreplace(rule),
        distance=_root(textbook_form(spring.distance.xreplace(rule) ** 2))
        if spring.distance.is_Pow
        else spring.distance.xreplace(rule),
    )


def rewritten_damper(damper: DamperForce, rule: dict[sp.Basic, sp.Basic], slots: Slots) -> DamperForce:
    """The damper in other coordinates."""
    squared = textbook_form(damper.distance.xreplace(rule) ** 2) if damper.distance.is_Pow else None
    length = damper.distance.xreplace(rule) if squared is None else _unsigned(_root(squared))
    return replace(
        damper,
        coefficient=damper.coefficient.xreplace(rule),
        ends=_rewritten(damper.ends, rule),
        apart=damper.apart.xreplace(rule),
        distance=length,
        rate=textbook_form(slots.time_derivative(length)),
    )


def _rewritten(
    ends: tuple[str | Vector, str | Vector], rule: dict[sp.Basic, sp.Basic]
) -> tuple[str | Vector, str | Vector]:
    first, second = (e if isinstance(e, str) else e.xreplace(rule) for e in ends)
    return first, second


def _named(ends: tuple[Vector, Vector], problem: Problem) -> tuple[str | Vector, str | Vector]:
    """The ends, particles and mass centres by name; a point pinned at the origin is the origin."""
    places: Mapping[Vector, str] = {p.position: p.name for p in problem.masses if not p.position.is_zero}
    first, second = (places.get(e, e) for e in ends)
    return first, second


def _signed(length: sp.Expr, problem: Problem) -> sp.Expr:
    """A length without the moduli whose sign the ranges of the coordinates decide: 2R cos θ for −80° ≤ θ ≤ 80°."""
    ranges = {q.symbol: q.range for q in problem.coordinates if q.range is not None}
    moduli = {m: sp.expand(m.args[0]) for m in length.atoms(sp.Abs)} if ranges else {}
    known = {m: e for m, x in moduli.items() for e in (-x, x) if _is_positive_within(e, ranges)}
    return length.xreplace(known) if known else length


def _is_positive_within(e: sp.Expr, ranges: Mapping[sp.Symbol, Range]) -> bool:
    """Whether an expression is not negative where the coordinates are in their ranges."""
    least = e.xreplace({q: r.low if e.coeff(q).is_nonnegative else r.high for q, r in ranges.items()})
    linear = all(e.diff(q).is_number for q in ranges)
    return _is_never_negative(e, ranges) or bool(linear and least.is_finite is not False and least.is_nonnegative)


def _is_never_negative(e: sp.Expr, ranges: Mapping[sp.Symbol, Range]) -> bool:
    """Whether a product of positive factors and of sines and cosines of angles in their ranges is not negative: its
    zeros may be at the ends, 2l cos θ for θ from 0 to 90°.
    """
    ends = []
    for f in sp.Mul.make_args(sp.factor_terms(e)):
        if f.is_nonnegative:
            continue
        within = ranges.get(f.args[0]) if isinstance(f, sp.sin | sp.cos) and f.args[0].is_Symbol else None
        if within is None or not within.low.is_number or not within.high.is_number:
            return False
        if sign_between(f.func, within.low, within.high, (True, True)) != 1:
            return False
        ends.append(f)
    return bool(ends)


def _distance(apart: Vector) -> sp.Expr:
    parts = [c for c in apart.components if c != 0]
    if len(parts) == 1:
        return sp.Abs(parts[0])
    return _root(textbook_form(apart.dot(apart)))


def _root(squared: sp.Expr) -> sp.Expr:
    """The square root; |s| for s² even if multiplied out."""
    if squared.is_Add and len(squared.args) <= MOST_SQUARE_TERMS and squared.is_polynomial(*squared.free_symbols):
        squared = sp.factor(squared)
    return sp.sqrt(squared)


def _unsigned(length: sp.Expr) -> sp.Expr:
    """s instead of |s|, 2 s instead of 2 |s|."""
    return sp.Mul(*(f.args[0] if isinstance(f, sp.Abs) else f for f in sp.Mul.make_args(length)))
