"""Constraints that exclude one another are an error, which names them and no others.

    f = 0 with f = 1             no position satisfies both
    φ' = 1 with φ' = 2           no velocity: a_t is outside the range of A at generic points
    x = 0 with x' = y            a velocity only where y = 0: a condition that the file has to state

The last kind is a relation hidden in a geometric and a kinematic constraint together. Hidden finite relations are met
here too: if dφ is a combination of the forms, φ = t leaves A q' = -a_t without solution.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from lagrange.algebra.exact.exact import DivisionByZeroError, Surface, has_real_point
from lagrange.algebra.forms.combinations import combination
from lagrange.algebra.fourier.textbook import textbook_form
from lagrange.core.diagnostics import Diagnostic, ProblemError, UndecidedError
from lagrange.core.symbols import Slots
from lagrange.mechanics.constraints.kinematics import Row, admitted_states, is_pfaffian
from lagrange.problem.model import Constraint

Pairs = list[tuple[Constraint, Row]]


def check_consistent(constraints: Sequence[Constraint], rows: Sequence[Row], surface: Surface) -> None:
    """Raises ProblemError where constraints exclude one another or bind nothing.

    surface  of all the geometric constraints; `rows` are the forms of the constraints
    """
    linear = [(c, row) for c, row in zip(constraints, rows, strict=True) if row.nonlinear is None]
    constraints, rows = [c for c, _ in linear], [row for _, row in linear]
    geometric = [c for c in constraints if not c.kinematic]
    clash = [geometric[k] for k in surface.contradictory()]
    if not clash or has_real_point(surface):
        _check_regular(geometric, rows, surface)
        pairs = _clash_of_rates(linear, surface)
        _check_no_condition(pairs, surface.coordinates)
        clash = [c for c, _ in pairs]
    if clash:
        raise _contradiction(clash)


def _contradiction(clash: Sequence[Constraint]) -> ProblemError:
    message = f"{_named(clash)} contradict each other" if len(clash) > 1 else f"{_named(clash)} cannot be satisfied"
    help_ = "no position or velocity satisfies them; correct or remove one"
    return ProblemError(Diagnostic("contradictory-constraints", message, clash[-1].span, help=help_))


def _named(constraints: Sequence[Constraint]) -> str:
    *first, last = (f"`{c.name}`" for c in constraints)
    return f"{', '.join(first)} and {last}" if first else last


def _check_regular(geometric: Sequence[Constraint], rows: Sequence[Row], surface: Surface) -> None:
    """Refuses constraints such as sin x = 1, whose differential vanishes where they hold and binds nothing."""
    finite = [r for r in rows if r.finite is not None]
    for constraint, row in zip(geometric, finite, strict=True):
        if surface.rank([row.coefficients]) == 0:
            message = f"the differential of `{constraint.name}` vanishes wherever the constraint holds"
            help_ = "write it so that it changes sign there: `x = pi/2` and not `sin(x) = 1`"
            raise ProblemError(Diagnostic("singular-constraint", message, constraint.span, help=help_))


def _clash_of_rates(pairs: Pairs, surface: Surface) -> Pairs:
    """The first constraint whose velocity form excludes those before it, with those that it needs for that."""
    if not _clash([row for _, row in pairs], surface):
        return []  # what excludes some of them excludes all
    for count in range(1, len(pairs) + 1):
        if _clash([row for _, row in pairs[:count]], surface):
            later = [(c, row) for c, row in pairs[count:] if row.finite is not None]
            return _smallest_clash([*pairs[:count], *later], surface)
    return []


def _clash(rows: Sequence[Row], surface: Surface) -> bool:
    """Whether A q' = -a_t has no solution at generic points of a surface."""
    a = surface.rank([r.coefficients for r in rows]) if rows else 0
    whole = surface.rank([r.form for r in rows]) if rows else 0
    return a is not None and whole is not None and whole > a


def _smallest_clash(pairs: Pairs, surface: Surface) -> Pairs:
    """Without those constraints that the contradiction does not need, on their surface or beside it."""
    for pair in list(pairs):
        fewer = [p for p in pairs if p is not pair]
        if _clash([row for _, row in fewer], _surface(fewer, surface.coordinates)):
            pairs = fewer
    return pairs


def _surface(pairs: Pairs, coordinates: Sequence[sp.Symbol]) -> Surface:
    return Surface([row.finite for _, row in pairs if row.finite is not None], coordinates)


def _check_no_condition(clash: Pairs, coordinates: Sequence[sp.Symbol]) -> None:
    """Refuses constraints that leave velocities only where one more relation between the coordinates holds."""
    condition = _condition(clash, coordinates)
    if condition is not None:
        written = str(condition).replace("**", "^")
        message = f"{_named([c for c, _ in clash])} together require {written} = 0, which the file does not state"
        help_ = f"add the constraint `{written} = 0`, or correct one of them"
        raise ProblemError(Diagnostic("unstated-condition", message, clash[-1][0].span, help=help_))


def _condition(clash: Pairs, coordinates: Sequence[sp.Symbol]) -> sp.Expr | None:
    """g(q, t), where the clash is g = 0 and can be met: Σ c_j A_j = 0 with Σ c_j a_tj = g."""
    surface = _surface(clash, coordinates)
    for n, (_, row) in enumerate(clash):
        others = [r for k, (_, r) in enumerate(clash) if k != n]
        if row.finite is not None or surface.rank([r.coefficients for r in others]) != len(others):
            continue
        values = combination(row.coefficients, [r.coefficients for r in others], surface) if others else None
        if values is None:
            continue
        rest = textbook_form(row.drift - sp.Add(*(c * r.drift for c, r in zip(values, others, strict=True))))
        condition, _ = sp.fraction(sp.factor_terms(rest))
        condition = sp.Mul(*(f for f in sp.Mul.make_args(condition) if f.free_symbols & {*coordinates}))
        try:
            if condition != 1 and has_real_point(Surface([*surface.constraints, condition], coordinates)):
                return condition
        except DivisionByZeroError:
            continue
    return None


def check_curved(constraints: Sequence[Constraint], rows: Sequence[Row], states: Surface) -> None:
    """Refuses constraints, not linear in the velocities, that exclude others, or whose ∂φ/∂q' vanish where φ = 0."""
    curved = [(c, r) for c, r in zip(constraints, rows, strict=True) if r.nonlinear is not None]
    if not curved:
        return
    clash = states.contradictory()
    if clash and not has_real_point(states):
        finite = [c for c, r in zip(constraints, rows, strict=True) if r.finite is not None]
        ordered = [*finite, *constraints]
        raise _contradiction(list(dict.fromkeys(ordered[k] for k in clash)))
    for constraint, row in curved:
        if states.rank([row.coefficients]) == 0:
            raise _singular(constraint)


def _singular(constraint: Constraint) -> ProblemError:
    message = f"the derivatives of `{constraint.name}` by the velocities vanish wherever the constraints hold"
    help_ = "write it so that it changes sign there, as a product without squares"
    return ProblemError(Diagnostic("singular-constraint", message, constraint.span, help=help_))


def check_follows(constraint: Constraint, rows: Sequence[Row], slots: Slots) -> None:
    """Refuses a constraint that only touches those before it: x' = 1 touches x'² + y'² = 1 where y' = 0."""
    if is_pfaffian(rows):
        return
    follows = admitted_states(rows[:-1], slots).is_zero(rows[-1].velocity_form(slots))
    if follows is None:
        raise UndecidedError(f"whether the constraint `{constraint.name}` follows from the others", constraint.span)
    if not follows:
        raise _singular(constraint)
