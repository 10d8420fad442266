"""One constraint at a time: geometric or kinematic, its differential form, exact or not, integrable or not.

    geometric   f(q, t) = 0          a_i = ∂f/∂q_i     a_t = ∂f/∂t
    kinematic   φ(q, q', t) = 0      a_i = ∂φ/∂q_i'    a_t = φ at q' = 0     (φ linear in q')

ω = Σ a_i dq_i + a_t dt is exact if its mixed partial derivatives agree; then ω = dF, and the constraint is the finite
relation F = const. A form that is not exact may still be integrable: by Frobenius' theorem if and only if ω ∧ dω = 0,
with dt among the differentials, where the geometric constraints hold.

If φ is not linear in q', there is no form, and a_i are Chetaev's coefficients of δq_i (`Row.by_chetaev`). Such a
constraint depends on time if ∂φ/∂t ≠ 0 where φ = 0, and is catastatic if Σ (∂φ/∂q_i') q_i' = 0 there. It implies no
finite relation where its admissible velocities are curved: f(q, t) = 0 would confine them to the plane
Σ (∂f/∂q) q' + ∂f/∂t = 0. Along a curve in the surface of admissible velocities, with tangent v and second derivative w,

    a·v = 0 ,      a·w = −Σ (∂²φ/∂q_i'∂q_k') v_i v_k ,      a = ∂φ/∂q' ,

so that the velocities span at least n − rank a dimensions plus the rank of the numbers on the right over all pairs of
tangents, the second fundamental form. If that is all that the linear constraints leave, the others add no linear
condition. The converse does not hold: less curvature leaves the question undecided.

Shapes: a (m, n). Reference: Kobayashi and Nomizu, Foundations of Differential Geometry II.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations, combinations_with_replacement
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError, NoPointError, Point, Surface, UnsupportedError
from lagrange.algebra.forms.antiderivatives import multiplied_out
from lagrange.algebra.forms.exact_forms import Exactness, ExteriorForm, exactness, one_form, potential, wedge
from lagrange.algebra.forms.velocity_polynomials import is_affine
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.algebra.fourier.vector_cleanup import cleaned_up, in_differences, is_many_waves, tidied
from lagrange.core.records import all_hold, record
from lagrange.core.symbols import Slots, base, t
from lagrange.mechanics.constraints.constrained_system import ConstrainedSystem, Row
from lagrange.mechanics.constraints.limits import CURVATURE_POINTS
from lagrange.problem.model import Constraint

if TYPE_CHECKING:
    from lagrange.algebra.forms.restrictions import FiniteForm
    from lagrange.mechanics.constraints.rigid_bodies import QuasiCoordinates


@record
class Bending:
    """Σ (∂²φ/∂q_i'∂q_k') v_i v_k = `value`, not zero, in a direction v in which φ does not change to first order.

    velocities  the two that change
    direction   v, which is (∂φ/∂q_k', −∂φ/∂q_i')
    """

    velocities: tuple[sp.Symbol, sp.Symbol]
    direction: tuple[sp.Expr, sp.Expr]
    value: sp.Expr


def bending_rank(system: ConstrainedSystem) -> int | None:
    """The rank of the second fundamental form of the admissible velocities, at generic states. None: undecided."""
    rows, slots = system.rows, system.slots
    gradients = [r.coefficients for r in rows]
    curved = [r for r in rows if r.nonlinear is not None]
    hessians = [[[a.diff(v) for v in slots.velocities] for a in r.coefficients] for r in curved]

    def at(point: Point) -> int:
        tangents = point.nullspace(point.matrix(gradients), len(slots.velocities))
        values = [point.matrix(h) for h in hessians]
        pairs = combinations_with_replacement(tangents, 2)
        second = [[_form(point, h, v, w) for h in values] for v, w in pairs]
        return point.rank(second) if second else 0

    try:
        ranks = system.states.sampled(at, CURVATURE_POINTS)
    except (NoPointError, UnsupportedError, DivisionByZeroError):
        return None
    return ranks[0] if len(set(ranks)) == 1 else None


def _form(point: Point, matrix: list[list[object]], v: list[object], w: list[object]) -> object:
    """Σ M_ik v_i w_k."""
    terms = (x * a * y for x, row in zip(v, matrix, strict=True) for a, y in zip(row, w, strict=True))  # type: ignore[operator]
    return point.arithmetic.reduce(sum(terms))


def bending(row: Row, system: ConstrainedSystem) -> Bending | None:
    """A direction, in the plane of two velocities, in which a constraint is curved: to be shown."""
    phi, slots, states = row.coefficients, system.slots, system.states
    for i, k in combinations(range(len(phi)), 2):
        if phi[i] == 0 or phi[k] == 0:
            continue
        v, w = slots.velocities[i], slots.velocities[k]
        value = phi[k] ** 2 * phi[i].diff(v) - 2 * phi[i] * phi[k] * phi[i].diff(w) + phi[i] ** 2 * phi[k].diff(w)
        if states.is_zero(value) is False:
            return Bending((v, w), (phi[k], -phi[i]), textbook_form(value))
    return None


@record
class FrobeniusComponent:
    """coefficient · dq_i ∧ dq_j ∧ ...; `nonzero` where the geometric constraints hold, None: undecided."""

    variables: tuple[sp.Symbol, ...]
    coefficient: sp.Expr
    nonzero: bool | None


@record
class ConstraintAnalysis:
    """The analysis of one constraint.

    row              its differential form
    exactness        the pairs of partial derivatives
    integrable       whether it is a finite relation, on its own and where the geometric constraints hold
    integral         F, if the finite form is given or was found; F stays constant
    finite_form      the factor that makes the form exact, if it is not exact and one was found
    quasi            the quasi-coordinates in its form, which make the test of mixed partial derivatives meaningless
    restricted       whether the angular velocities restrict the rotation by themselves, having fewer than three of them
    frobenius        the components of ω ∧ dω ∧ df_1 ∧ ... that are not written as 0, if the form is not exact; the f
                     are the geometric constraints, so that ω ∧ dω counts only along their surface
    depends_on_time  t occurs: in the finite relation if it is one, otherwise in the form
    catastatic       a_t = 0
    contains_time    t or a prescribed motion is written in the constraint
    bending          a direction in which it is curved, if it is not linear in the velocities
    """

    constraint: Constraint
    row: Row
    exactness: Exactness
    integrable: bool | None
    integral: sp.Expr | None
    frobenius: tuple[FrobeniusComponent, ...]
    depends_on_time: bool | None
    catastatic: bool | None
    contains_time: bool
    bending: Bending | None = None
    finite_form: FiniteForm | None = None
    quasi: tuple[sp.Symbol, ...] = ()
    restricted: bool = False

    @property
    def pfaffian(self) -> bool:
        """Whether it is linear in the velocities, and has a differential form."""
        return self.row.nonlinear is None

    @property
    def factor(self) -> sp.Expr | None:
        """The factor that makes the form exact: 1, or an integrating factor; None if none is known."""
        if self.exactness.exact:
            return sp.S.One
        return None if self.finite_form is None else self.finite_form.factor


def constraint_row(constraint: Constraint, slots: Slots) -> Row:
    """The differential form of a constraint, or Chetaev's coefficients if it is not linear in the velocities."""
    f = constraint.function
    if not constraint.kinematic:
        gradient = tuple(cleaned_up(f.diff(q)) for q in slots.coordinates)
        return Row(constraint.name, gradient, cleaned_up(slots.frozen_derivative(f)), f)
    at_rest = dict.fromkeys(slots.velocities, sp.S.Zero)
    coefficients = tuple(_coefficient(f, v, slots) for v in slots.velocities)
    if any(c is None for c in coefficients):
        return Row.by_chetaev(constraint.name, f, slots)
    return Row(constraint.name, tuple(tidied(c) for c in coefficients if c is not None), tidied(f.xreplace(at_rest)))


def _coefficient(f: sp.Expr, velocity: sp.Symbol, slots: Slots) -> sp.Expr | None:
    """∂f/∂q', free of velocities; None if f is not linear in them."""
    derivative = f.diff(velocity)
    if not derivative.free_symbols & set(slots.velocities):
        return derivative
    expanded = multiplied_out(derivative)
    if expanded is derivative and is_affine(f, slots):
        expanded = sp.expand(derivative)
    return None if expanded.free_symbols & set(slots.velocities) else expanded


def analysis(
    constraint: Constraint,
    row: Row,
    independent: ConstrainedSystem,
    quasi: QuasiCoordinates | None = None,
) -> ConstraintAnalysis:
    """Analyse a constraint where the geometric ones among the `independent` constraints hold."""
    slots, surface = independent.slots, independent.surface
    if row.nonlinear is not None:
        return _of_nonlinear(constraint, row, row.nonlinear, independent)
    if quasi is not None and row.finite is None and quasi.used_by(row.form, slots):
        return _in_quasi_coordinates(constraint, row, independent, quasi)
    form, variables = row.form, (*slots.coordinates, t)
    pairs = exactness(form, variables, slots)
    integral = _integral(row, pairs.exact, slots)
    integrable: bool | None = True
    frobenius: tuple[FrobeniusComponent, ...] = ()
    solved_form: FiniteForm | None = None
    if row.finite is None and pairs.exact is not True:
        from lagrange.algebra.forms.frobenius import is_integrable
        from lagrange.algebra.forms.restrictions import finite_form

        integrable = is_integrable(form, slots, surface.constraints)
        if not any(map(is_many_waves, form)):  # the components of such a form would fill pages
            frobenius = _frobenius(row, independent.geometric, surface, slots)
        solved_form = finite_form(form, surface, slots) if integrable is not False else None
        # A finite form is verified when it is found, and so decides where the jets of Frobenius' test could not.
        integrable = integrable if solved_form is None else True
        integral = None if solved_form is None else solved_form.integral
    return ConstraintAnalysis(
        constraint=constraint,
        row=row,
        exactness=pairs,
        integrable=integrable,
        integral=integral,
        frobenius=frobenius,
        depends_on_time=_depends_on_time(row, integrable, None if solved_form is None else integral, surface, slots),
        catastatic=surface.is_zero(row.drift),
        contains_time=_contains_time(constraint.function, slots),
        finite_form=solved_form,
    )


def _in_quasi_coordinates(
    constraint: Constraint,
    row: Row,
    independent: ConstrainedSystem,
    quasi: QuasiCoordinates,
) -> ConstraintAnalysis:
    """Analyse a constraint with quasi-coordinates: whether it is integrable is decided in true ones."""
    from lagrange.algebra.forms.derived_flag import derived_flag
    from lagrange.algebra.forms.frobenius import is_integrable

    slots, surface = independent.slots, independent.surface
    true_form = quasi.in_angles(row.form, slots)
    integrable: bool | None = None
    frobenius: tuple[FrobeniusComponent, ...] = ()
    if true_form is not None and quasi.restrictions:
        # Frobenius' condition for one form is not enough: the rotation is restricted by others, integrable or not.
        flag = derived_flag([true_form], quasi.slots, surface.constraints, modulo=quasi.restrictions)
        integrable = None if flag.integrable_rank is None else flag.integrable_rank == 1
    elif true_form is not None:
        integrable = is_integrable(true_form, quasi.slots, surface.constraints)
        rewritten = Row(row.name, true_form[:-1], true_form[-1])
        frobenius = _frobenius(rewritten, independent.geometric, surface, quasi.slots)
    contains_time = _contains_time(constraint.function, slots)
    may_depend_on_time = row.drift != 0 or contains_time
    return ConstraintAnalysis(
        constraint=constraint,
        row=row,
        exactness=Exactness((), False if integrable is False else None),
        integrable=integrable,
        integral=None,
        frobenius=frobenius,
        depends_on_time=_depends_on_time(row, integrable, None, surface, slots) if may_depend_on_time else False,
        catastatic=surface.is_zero(row.drift),
        contains_time=contains_time,
        quasi=quasi.used_by(row.form, slots),
        restricted=bool(quasi.restrictions),
    )


def _of_nonlinear(
    constraint: Constraint, row: Row, function: sp.Expr, independent: ConstrainedSystem
) -> ConstraintAnalysis:
    """Analyse a constraint that is not linear in the velocities, together with the geometric constraints only."""
    slots = independent.slots
    system = independent.with_rows((*independent.geometric, row))
    states = system.states
    integrable = _is_integrable(system)
    # t occurs in φ = 0 if ∂φ/∂t ≠ 0 there, and in a finite relation F with dF = a dq + a_t dt if a_t ≠ 0
    is_scleronomic = states.is_zero(row.drift if integrable else slots.frozen_derivative(function))
    return ConstraintAnalysis(
        constraint=constraint,
        row=row,
        exactness=Exactness((), None),
        integrable=integrable,
        integral=None,
        frobenius=(),
        depends_on_time=None if is_scleronomic is None or integrable is None else not is_scleronomic,
        catastatic=states.is_zero(row.drift),
        contains_time=_contains_time(constraint.function, slots),
        bending=bending(row, system) if integrable is False and not independent.geometric else None,
    )


def _is_integrable(system: ConstrainedSystem) -> bool | None:
    """Whether the last row, which is not Pfaffian, is a finite relation where the others, which are finite, hold."""
    if system.rank == system.size:
        return True  # q' is a function of q and t, and so q one of t
    return False if bending_rank(system) else None


def _frobenius(row: Row, geometric: Sequence[Row], surface: Surface, slots: Slots) -> tuple[FrobeniusComponent, ...]:
    """ω ∧ dω ∧ df_1 ∧ ..., its components where the geometric constraints hold."""
    from lagrange.algebra.forms.frobenius import component_writer, frobenius_form

    variables = (*slots.coordinates, t)
    form: ExteriorForm = {
        tuple(variables.index(v) for v in c.variables): c.coefficient
        for c in frobenius_form((*row.coefficients, row.drift), variables, slots)
    }
    for other in geometric:
        form = wedge(form, one_form((*other.coefficients, other.drift)))
    components = []
    written = component_writer(row.form)
    for indices, coefficient in sorted(form.items()):
        short = in_differences(written(coefficient), slots.coordinates)
        if short == 0:
            continue
        zero = surface.is_zero(short)
        nonzero = None if zero is None else not zero
        components.append(FrobeniusComponent(tuple(variables[i] for i in indices), short, nonzero))
    return tuple(components)


def _integral(row: Row, exact: bool | None, slots: Slots) -> sp.Expr | None:
    """The function that stays constant, without its additive constant."""
    if row.finite is None:
        return potential((*row.coefficients, row.drift), (*slots.coordinates, t), slots) if exact else None
    moving = {*slots.coordinates, *slots.prescribed, t}
    terms = sp.Add.make_args(sp.expand(row.finite) if row.finite.is_Mul else row.finite)
    return sp.Add(*(term for term in terms if any(base(s) in moving for s in term.free_symbols)))


def _contains_time(expression: sp.Expr, slots: Slots) -> bool:
    return any(s == t or base(s) in slots.prescribed for s in expression.free_symbols)


def _depends_on_time(
    row: Row, integrable: bool | None, integral: sp.Expr | None, surface: Surface, slots: Slots
) -> bool | None:
    """Whether t occurs, explicitly or through a prescribed motion.

    A finite relation F = const contains t if and only if ∂F/∂t ≠ 0 or, if F is not known, its form has a dt. A form
    that is not integrable contains t if the ratio of two of its coefficients does: a common factor makes no difference.
    """
    if row.finite is not None:
        return _contains_time(row.finite, slots)
    if integrable is None:
        return None
    if integrable:
        at_rest = surface.is_zero(row.drift if integral is None else slots.frozen_derivative(integral))
        return None if at_rest is None else not at_rest
    form = (*row.coefficients, row.drift)
    pivot = next((a for a in form if surface.is_zero(a) is False), None)
    if pivot is None:
        return None
    rate = slots.frozen_derivative
    verdicts = [surface.is_zero(rate(a) * pivot - a * rate(pivot)) for a in form]
    stays = all_hold(verdicts)
    return None if stays is None else not stays
