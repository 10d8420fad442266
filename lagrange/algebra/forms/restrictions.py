"""A form restricted to the surface of geometric constraints, where these can be solved by hand.

A form may be integrable on a surface only: there it is a form in fewer coordinates. Two kinds of constraints are
solved,

    linear in a coordinate q:             q = E, with E free of q
    p and q on a circle:                  (p − α)² + (q − β)² = ρ²,    p = α + ρ cos ψ,    q = β + ρ sin ψ

with α, β, ρ that do not contain p and q (a sphere is a circle whose ρ depends on z). The differentials dE,
dα + cos ψ dρ − ρ sin ψ dψ and dβ + sin ψ dρ + ρ cos ψ dψ are substituted into the form, and the relation that is found
is written in the old coordinates again.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import combinations

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError, Surface, is_zero
from lagrange.algebra.forms.exact_forms import differentiated
from lagrange.algebra.forms.factor_candidates import is_quick_to_factor
from lagrange.algebra.forms.factor_methods import shortened
from lagrange.algebra.forms.frobenius import is_integrable
from lagrange.algebra.forms.integrating_factors import IntegratingFactor, integrating_factor
from lagrange.algebra.forms.limits import LARGEST_SOLVED_CONSTRAINT
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import Slots, t

ANGLES = ("psi", "chi", "eta", "zeta")


@record
class PolarAngle:
    """ψ with p - α = ρ cos ψ, q - β = ρ sin ψ."""

    symbol: sp.Symbol
    across: sp.Expr
    along: sp.Expr
    radius: sp.Expr

    def undone(self, e: sp.Expr) -> sp.Expr:
        """An expression without ψ."""
        if self.symbol not in e.free_symbols:
            return e
        e = e.replace(sp.tan, lambda a: sp.sin(a) / sp.cos(a))
        e = sp.expand_trig(e) if is_quick_to_factor(e) else e
        cosine, sine = self.across / self.radius, self.along / self.radius
        e = e.xreplace({sp.cos(self.symbol): cosine, sp.sin(self.symbol): sine})
        return e.xreplace({self.symbol: sp.atan2(self.along, self.across)})


@record
class Restriction:
    """A form on the surface of geometric constraints.

    rules      the coordinates that were replaced, with their values
    angles     those introduced
    form       the coefficients, shape (k,), of the differentials of `variables` (k,)
    slots      with the coordinates that are left
    """

    rules: tuple[tuple[sp.Symbol, sp.Expr], ...]
    angles: tuple[PolarAngle, ...]
    form: tuple[sp.Expr, ...]
    variables: tuple[sp.Symbol, ...]
    slots: Slots

    def in_old_coordinates(self, e: sp.Expr) -> sp.Expr:
        """An expression without the angles that were introduced."""
        for angle in reversed(self.angles):
            e = angle.undone(e)
        return e


def restriction(form: Sequence[sp.Expr], geometric: Sequence[sp.Expr], slots: Slots) -> Restriction | None:
    """The form on the surface, as far as it is solved by hand; None if no constraint is.

    form       (n + 1,) coefficients of dq_1 ... dq_n, dt
    geometric  functions f(q, t) whose vanishing is the geometric constraints
    """
    left = slots
    rules: dict[sp.Symbol, sp.Expr] = {}
    angles: list[PolarAngle] = []
    for f in geometric:
        constraint = f.xreplace(rules)
        names = {s.name for e in (*form, *geometric) for s in e.free_symbols} | {q.name for q in left.coordinates}
        solution = _linear(constraint, left) or _circle(constraint, left, names)
        if solution is None:
            continue
        solved, angle = solution
        # Earlier rules may contain a coordinate that is replaced only now.
        rules = {q: e.xreplace(solved) for q, e in rules.items()} | dict(solved)
        kept = [q for q in left.coordinates if q not in solved]
        if angle is not None:
            angles.append(angle)
            kept.append(angle.symbol)
        left = Slots(tuple(kept), slots.prescribed)
    if not rules:
        return None
    variables = (*left.coordinates, t)
    replaced = [shortened(a.xreplace(rules)) for a in form]
    old = [rules.get(q, q) for q in (*slots.coordinates, t)]
    pulled = []
    for v in variables:
        terms = (a * differentiated(e, v, left) for a, e in zip(replaced, old, strict=True))
        pulled.append(shortened(sp.Add(*terms)))
    return Restriction(tuple(rules.items()), tuple(angles), tuple(pulled), variables, left)


@record
class FiniteForm:
    """How a form that is not exact becomes the differential of a function.

    found        the factor, for the form itself or for its restriction
    restriction  to the geometric constraints, where only that is integrable
    """

    found: IntegratingFactor
    restriction: Restriction | None = None

    @property
    def factor(self) -> sp.Expr:
        """μ, in the coordinates of the file."""
        return self._written(self.found.factor)

    @property
    def integral(self) -> sp.Expr | None:
        """F, in the coordinates of the file; F stays constant."""
        return None if self.found.integral is None else shorter_relation(self._written(self.found.integral))

    def _written(self, e: sp.Expr) -> sp.Expr:
        return e if self.restriction is None else self.restriction.in_old_coordinates(e)


def finite_form(form: Sequence[sp.Expr], surface: Surface, slots: Slots) -> FiniteForm | None:
    """A factor for a form, or for its restriction to the geometric constraints; None: not found.

    form     (n + 1,) coefficients of dq_1 ... dq_n, dt
    surface  where the geometric constraints hold
    """
    geometric = surface.constraints
    if not geometric or is_integrable(form, slots):
        factor = integrating_factor(form, (*slots.coordinates, t), slots)
        if factor is not None and _is_valid(factor, surface):
            return FiniteForm(factor)
        if not geometric:
            return None
    restricted = restriction(form, geometric, slots)
    if restricted is None or not is_integrable(restricted.form, restricted.slots):
        return None
    factor = integrating_factor(
        restricted.form, restricted.variables, restricted.slots, [a.symbol for a in restricted.angles]
    )
    return None if factor is None else FiniteForm(factor, restricted)


def _is_valid(factor: IntegratingFactor, surface: Surface) -> bool:
    """Whether the factor is finite and not 0 on the surface: with z = 0, 1/z is not."""
    return all(surface.is_zero(g) is False for g in (*factor.nonzero, *factor.positive))


Solved = tuple[Mapping[sp.Symbol, sp.Expr], PolarAngle | None]


def _linear(f: sp.Expr, slots: Slots) -> Solved | None:
    """q = E, for the coordinate with the simplest slope."""
    best: tuple[tuple[bool, int], sp.Symbol, sp.Expr] | None = None
    for q in slots.coordinates:
        slope = sp.diff(f, q)
        if q in slope.free_symbols or slope == 0 or count_operations(f) > LARGEST_SOLVED_CONSTRAINT:
            continue
        moving = bool(slope.free_symbols & {*slots.coordinates, t, *slots.prescribed})
        # A slope of parameters alone excludes no configuration; one that moves excludes where it vanishes.
        rank = (moving, count_operations(slope))
        if (best is None or rank < best[0]) and _is_nonzero(slope):
            best = rank, q, slope
    if best is None:
        return None
    _, q, slope = best
    return {q: shortened(-f.xreplace({q: sp.S.Zero}) / slope)}, None


def _circle(f: sp.Expr, slots: Slots, taken: set[str]) -> Solved | None:
    """p = α + ρ cos ψ, q = β + ρ sin ψ."""
    if not is_quick_to_factor(f):
        return None
    for p, q in combinations(slots.coordinates, 2):
        if {p, q} - f.free_symbols or not f.is_polynomial(p, q):
            continue
        powers = sp.Poly(sp.expand(f), p, q).as_dict()
        scale = powers.get((2, 0), sp.S.Zero)
        if set(powers) - {(2, 0), (0, 2), (1, 0), (0, 1), (0, 0)} or scale == 0 or powers.get((0, 2)) != scale:
            continue
        alpha, beta = (-powers.get(k, sp.S.Zero) / (2 * scale) for k in ((1, 0), (0, 1)))
        square = shortened(alpha**2 + beta**2 - powers.get((0, 0), sp.S.Zero) / scale)
        name = next((n for n in ANGLES if n not in taken), None)
        if name is None or not _is_nonzero(square):
            return None
        psi = sp.Symbol(name, real=True)
        rho = sp.sqrt(square)
        solved = {p: alpha + rho * sp.cos(psi), q: beta + rho * sp.sin(psi)}
        return solved, PolarAngle(psi, p - alpha, q - beta, rho)
    return None


def _is_nonzero(e: sp.Expr) -> bool:
    try:
        return is_zero(e) is False
    except DivisionByZeroError:
        return False


def shorter_relation(e: sp.Expr) -> sp.Expr:
    """l ((a − x)/l + ln(l |(1 − (a − x)/l)/y|)) + x as a + l ln|(l − a + x)/y|: terms joined."""

    def joined(argument: sp.Expr) -> sp.Expr:
        constant, rest = argument.as_independent(sp.Abs, as_Add=False)
        if not constant.is_positive or not isinstance(rest, sp.Abs):
            return sp.log(argument)
        return sp.log(sp.Abs(sp.cancel(sp.together(constant * rest.args[0]))))

    if not e.has(sp.log):
        return e
    shorter = sp.Add(*(sp.expand_mul(term, deep=False) for term in sp.Add.make_args(e.replace(sp.log, joined))))
    return shorter if count_operations(shorter) < count_operations(e) else e
