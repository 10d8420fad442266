"""One constraint at a time: geometric or kinematic, its differential form, whether that is exact or integrable.

    geometric   f(q, t) = 0          a_i = ∂f/∂q_i     a_t = ∂f/∂t
    kinematic   φ(q, q', t) = 0      a_i = ∂φ/∂q_i'    a_t = φ at q' = 0     (φ linear in q')

Where φ is not linear in q', there is no differential form, and nothing of what follows: a_i are Chetaev's coefficients
of δq_i (`kinematics.Row`), it is no finite relation where the admitted velocities bend (`bending`), it depends on time
when ∂φ/∂t ≠ 0 where φ = 0, and it is catastatic when the motion itself is a virtual displacement, Σ (∂φ/∂q_i') q_i' = 0
where φ = 0, as a_t = 0 says of a form. Otherwise:

ω = Σ a_i dq_i + a_t dt is exact if its partial derivatives agree in pairs, and then ω = dF: the constraint is the
finite relation F = const. A form that is not exact may still be integrable; Frobenius' condition ω ∧ dω = 0, with dt
among the differentials, decides. It is taken where the geometric constraints hold.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.algebra.exact.exact import Surface
from lagrange.algebra.forms.exterior import Form, one_form, wedge
from lagrange.algebra.forms.integrability import Exactness, exactness, frobenius_form, is_integrable, writer
from lagrange.algebra.forms.potentials import potential
from lagrange.algebra.fourier.textbook import textbook_form
from lagrange.algebra.fourier.vector_cleanup import in_differences, tidied
from lagrange.core.records import record
from lagrange.core.symbols import Slots, base, t
from lagrange.mechanics.constraints.bending import Bending, bending, bending_rank
from lagrange.mechanics.constraints.kinematics import Row, admitted_states
from lagrange.mechanics.constraints.quasi_coordinates import QuasiCoordinates
from lagrange.problem.model import Constraint

if TYPE_CHECKING:
    from lagrange.algebra.forms.restrictions import FiniteForm


@record
class FrobeniusComponent:
    """coefficient · dq_i ∧ dq_j ∧ ...; `nonzero` where the geometric constraints hold, None: undecided."""

    variables: tuple[sp.Symbol, ...]
    coefficient: sp.Expr
    nonzero: bool | None


@record
class ConstraintAnalysis:
    """What one constraint is.

    row              its differential form
    exactness        the pairs of partial derivatives
    integrable       whether it is a finite relation, on its own and where the geometric constraints hold
    integral         F, where the finite form is given or was found; F stays constant
    finite_form      the factor that makes the form exact, where it is not and one was found
    quasi            the quasi-coordinates in its form, because of which partial derivatives say nothing of it
    frobenius        the components of ω ∧ dω ∧ df_1 ∧ ... that are not written as 0, where the form is not exact; the f
                     are the geometric constraints, so that only what is seen on their surface counts
    depends_on_time  t occurs: in the finite relation if it is one, in the form otherwise
    catastatic       a_t = 0
    contains_time    t or a prescribed motion is written in the constraint
    bending          a direction in which it bends, where it is not linear in the velocities
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

    @property
    def pfaffian(self) -> bool:
        """Whether it is linear in the velocities, and has a differential form."""
        return self.row.nonlinear is None

    @property
    def factor(self) -> sp.Expr | None:
        """The factor that makes the form exact: 1, or an integrating factor; None where none is known."""
        if self.exactness.exact:
            return sp.S.One
        return None if self.finite_form is None else self.finite_form.factor


def constraint_row(constraint: Constraint, slots: Slots) -> Row:
    """The differential form of a constraint, or Chetaev's coefficients where it is not linear in the velocities."""
    f = constraint.function
    if not constraint.kinematic:
        gradient = tuple(textbook_form(f.diff(q)) for q in slots.coordinates)
        return Row(constraint.name, gradient, textbook_form(slots.frozen_derivative(f)), f)
    at_rest = dict.fromkeys(slots.velocities, sp.S.Zero)
    coefficients = tuple(_coefficient(f, v, slots) for v in slots.velocities)
    if any(c is None for c in coefficients):
        return Row.by_chetaev(constraint.name, f, slots)
    return Row(constraint.name, tuple(tidied(c) for c in coefficients if c is not None), tidied(f.xreplace(at_rest)))


def _coefficient(f: sp.Expr, velocity: sp.Symbol, slots: Slots) -> sp.Expr | None:
    """∂f/∂q', free of velocities; None where f is not linear."""
    derivative = f.diff(velocity)
    if not derivative.free_symbols & set(slots.velocities):
        return derivative
    expanded = sp.expand(derivative)
    return None if expanded.free_symbols & set(slots.velocities) else expanded


def analysis(
    constraint: Constraint,
    row: Row,
    geometric: Sequence[Row],
    surface: Surface,
    slots: Slots,
    quasi: QuasiCoordinates | None = None,
) -> ConstraintAnalysis:
    """What a constraint is. `geometric` are the rows of the geometric constraints, `surface` is where they hold."""
    if row.nonlinear is not None:
        return _of_nonlinear(constraint, row, row.nonlinear, geometric, slots)
    if quasi is not None and row.finite is None and quasi.used_by(row.form, slots):
        return _in_quasi_coordinates(constraint, row, geometric, surface, slots, quasi)
    form, variables = (*row.coefficients, row.drift), (*slots.coordinates, t)
    pairs = exactness(form, variables, slots)
    integral = _integral(row, pairs.exact, slots)
    integrable: bool | None = True
    frobenius: tuple[FrobeniusComponent, ...] = ()
    found: FiniteForm | None = None
    if row.finite is None and pairs.exact is not True:
        integrable = is_integrable(form, slots, surface.constraints)
        frobenius = _frobenius(row, geometric, surface, slots)
        from lagrange.algebra.forms.restrictions import finite_form

        found = finite_form(form, surface, slots) if integrable is not False else None
        integrable = integrable if found is None else True
        integral = None if found is None else found.integral
    return ConstraintAnalysis(
        constraint=constraint,
        row=row,
        exactness=pairs,
        integrable=integrable,
        integral=integral,
        frobenius=frobenius,
        depends_on_time=_depends_on_time(row, integrable, None if found is None else integral, surface, slots),
        catastatic=surface.is_zero(row.drift),
        contains_time=_contains_time(constraint.function, slots),
        finite_form=found,
    )


def _in_quasi_coordinates(
    constraint: Constraint,
    row: Row,
    geometric: Sequence[Row],
    surface: Surface,
    slots: Slots,
    quasi: QuasiCoordinates,
) -> ConstraintAnalysis:
    """What a constraint is that has quasi-coordinates: whether it is integrable is decided in true ones."""
    turned = quasi.in_angles(row.form, slots)
    integrable: bool | None = None
    frobenius: tuple[FrobeniusComponent, ...] = ()
    if turned is not None:
        integrable = is_integrable(turned, quasi.slots, surface.constraints)
        frobenius = _frobenius(Row(row.name, turned[:-1], turned[-1]), geometric, surface, quasi.slots)
    timed = row.drift != 0 or _contains_time(constraint.function, slots)
    return ConstraintAnalysis(
        constraint=constraint,
        row=row,
        exactness=Exactness((), False if integrable is False else None),
        integrable=integrable,
        integral=None,
        frobenius=frobenius,
        depends_on_time=_depends_on_time(row, integrable, None, surface, slots) if timed else False,
        catastatic=surface.is_zero(row.drift),
        contains_time=_contains_time(constraint.function, slots),
        quasi=quasi.used_by(row.form, slots),
    )


def _of_nonlinear(
    constraint: Constraint, row: Row, function: sp.Expr, geometric: Sequence[Row], slots: Slots
) -> ConstraintAnalysis:
    """What a constraint is that is not linear in the velocities, on its own with the geometric constraints."""
    rows = [*geometric, row]
    states = admitted_states(rows, slots)
    integrable = _is_integrable(rows, slots, states)
    # t occurs in φ = 0 if ∂φ/∂t ≠ 0 there, and in a finite relation F with dF = a dq + a_t dt if a_t ≠ 0
    still = states.is_zero(row.drift if integrable else slots.frozen_derivative(function))
    return ConstraintAnalysis(
        constraint=constraint,
        row=row,
        exactness=Exactness((), None),
        integrable=integrable,
        integral=None,
        frobenius=(),
        depends_on_time=None if still is None or integrable is None else not still,
        catastatic=states.is_zero(row.drift),
        contains_time=_contains_time(constraint.function, slots),
        bending=bending(row, slots, states) if integrable is False and not geometric else None,
    )


def _is_integrable(rows: Sequence[Row], slots: Slots, states: Surface) -> bool | None:
    """Whether the last row, which is not Pfaffian, is a finite relation where the others, which are finite, hold."""
    if states.rank([r.coefficients for r in rows]) == len(slots.coordinates):
        return True  # q' is a function of q and t, and so q one of t
    return False if bending_rank(rows, slots, states) else None


def _frobenius(row: Row, geometric: Sequence[Row], surface: Surface, slots: Slots) -> tuple[FrobeniusComponent, ...]:
    """ω ∧ dω ∧ df_1 ∧ ..., its components where the geometric constraints hold."""
    variables = (*slots.coordinates, t)
    form: Form = {
        tuple(variables.index(v) for v in c.variables): c.coefficient
        for c in frobenius_form((*row.coefficients, row.drift), variables, slots)
    }
    for other in geometric:
        form = wedge(form, one_form((*other.coefficients, other.drift)))
    found = []
    written = writer(row.form)
    for indices, coefficient in sorted(form.items()):
        short = in_differences(written(coefficient), slots.coordinates)
        if short == 0:
            continue
        zero = surface.is_zero(short)
        nonzero = None if zero is None else not zero
        found.append(FrobeniusComponent(tuple(variables[i] for i in indices), short, nonzero))
    return tuple(found)


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

    A finite relation F = const contains t just when ∂F/∂t is not 0, or, where F is not known, its form has a dt. A form
    that is no finite relation contains t when the ratio of two of its coefficients does, so that a common factor makes
    no difference.
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
    return True if False in verdicts else None if None in verdicts else False
