"""Whether everything a file states exists where its constraints hold.

A potential c/y has no value on y = 0, and no force there; a spring between two points that coincide pulls in no
direction. A problem with such a statement has no equations of motion. Each expression is evaluated on the surface of
the finite constraints: an expression with a denominator that vanishes everywhere there is an error at its place in the
file. One that is singular at single points only, c/y for a particle that may cross y = 0, is not.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import contextmanager

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError, NoPointError, Surface, UnsupportedError
from lagrange.core.diagnostics import Diagnostic, ProblemError, Span, UndecidedError
from lagrange.core.symbols import Slots, partial
from lagrange.core.vectors import Vector
from lagrange.document.math_writer import text
from lagrange.mechanics.constraints.constrained_system import ConstrainedSystem
from lagrange.problem.model import (
    AppliedForce,
    AppliedMoment,
    Belt,
    Damper,
    Force,
    Friction,
    GeneralizedForce,
    Potential,
    Problem,
    Spring,
)

_MAY_DIVIDE = (sp.tan, sp.cot, sp.sec, sp.csc, sp.log, sp.atan2)
_HELP = "correct the divisor, or describe the system with other coordinates or constraints"

CheckedStatement = tuple[str, Span | None, tuple[sp.Expr, ...]]
"""What a file states: in words, its place, and the expressions that must exist."""


def check_defined(problem: Problem, constrained: ConstrainedSystem) -> None:
    """Refuse a statement that does not exist where the constraints hold.

    Raises ProblemError with all of them.
    """
    surface = constrained.surface
    where = "wherever the constraints hold" if constrained.finite_constraints else "everywhere"
    stated = [(statement, surface, where) for statement in _statements(problem)]
    # A substitution is in coordinates of its own, which no constraint restricts.
    stated += [(statement, Surface(), "everywhere") for statement in _substitutions(problem)]
    findings = [
        Diagnostic("division-by-zero", f"{what} divides by `{text(divisor)}`, which is zero {place}", span, help=_HELP)
        for (what, span, expressions), points, place in stated
        if (divisor := _vanishing_divisor(expressions, points)) is not None
    ]
    findings += [
        Diagnostic(
            "no-direction",
            f"the ends of the spring `{f.name}` coincide {where}, and its force has no direction",
            f.span,
            help="correct the ends, or leave out the spring: one of constant length does no work",
        )
        for f in problem.forces
        if isinstance(f, Spring) and f.length != 0 and _coincide(f, surface)
    ]
    if findings:
        raise ProblemError(findings)


@contextmanager
def explained_failures(problem: Problem) -> Iterator[None]:
    """Raises what the exact algebra raises as an error about the file: DivisionByZeroError as ProblemError, and
    UnsupportedError and NoPointError as UndecidedError.
    """
    try:
        yield
    except DivisionByZeroError as error:
        raise ProblemError(_division(error.denominator, problem)) from None
    except (UnsupportedError, NoPointError) as error:
        reason = f" ({error})" if str(error) else ""
        raise UndecidedError(f"what the equations amount to{reason}") from None


def _division(divisor: sp.Expr, problem: Problem) -> Diagnostic:
    """The error for a divisor that shows up later, at the first statement that contains its symbols."""
    symbols = divisor.free_symbols
    spans = (span for _, span, es in _statements(problem) if symbols and symbols <= _symbols(es) and span is not None)
    message = f"the equations divide by `{text(divisor)}`, which is zero wherever the constraints hold"
    return Diagnostic("division-by-zero", message, next(spans, None), help=_HELP)


def _symbols(expressions: Iterable[sp.Expr]) -> set[sp.Basic]:
    return {s for e in expressions for s in e.free_symbols}


def _statements(problem: Problem) -> Iterator[CheckedStatement]:
    """The statements of a file that contain coordinates; constraints are tested when they are read."""
    for p in problem.masses:
        yield f"the position of `{p.name}`", p.span, _components(p.position)
    for b in problem.bodies:
        spin = _components(b.angular_velocity) if b.angular_velocity is not None else ()
        axes = tuple(c for a in b.axes for c in _components(a))
        angles = (b.angle,) if b.angle is not None else b.angles
        yield f"the orientation of `{b.name}`", b.span, (*angles, *axes, *spin)
    if problem.gravity is not None:
        yield "`gravity`", problem.gravity_span, _components(problem.gravity)
    for f in problem.forces:
        yield f"the force `{f.name}`", f.span, _of_force(f, problem.slots)
    for u in problem.speeds:
        yield f"the quasi-velocity `{u.symbol}`", u.span, (u.definition,)


def _substitutions(problem: Problem) -> Iterator[CheckedStatement]:
    for c in problem.choices:
        for q, value in (c.substitute or {}).items():
            yield f"the substitution for `{q}` in the choice `{c.name}`", c.span, (value,)


def _components(vector: Vector) -> tuple[sp.Expr, ...]:
    return vector.components


def _of_force(f: Force, slots: Slots) -> tuple[sp.Expr, ...]:
    match f:
        case AppliedForce():
            return (*_components(f.vector), *(_components(f.at) if f.at is not None else ()))
        case AppliedMoment():
            return _components(f.moment)
        case Spring():
            return (f.stiffness, f.length, *(c for end in f.ends for c in _components(end)))
        case Damper():
            return (f.coefficient, *(c for end in f.ends for c in _components(end)))
        case Potential():
            return (f.energy, *(partial(f.energy, q) for q in slots.coordinates))
        case GeneralizedForce():
            return tuple(f.components.values())
        case Friction():
            vectors = [v for v in (f.surface_velocity, f.at, f.toward) if v is not None]
            static = () if f.static is None else (f.static,)
            return (f.coefficient, *static, *(c for v in vectors for c in _components(v)))
        case Belt():
            return (f.coefficient, f.angle, f.tight, f.slack)


def _vanishing_divisor(expressions: Iterable[sp.Expr], surface: Surface) -> sp.Expr | None:
    """A divisor that is zero everywhere on the surface."""
    for e in expressions:
        if not _divides(e):
            continue
        try:
            surface.is_zero(e)
        except DivisionByZeroError as error:
            return error.denominator
    return None


def _divides(e: sp.Expr) -> bool:
    """Whether an expression has a divisor that may vanish."""
    return e.has(*_MAY_DIVIDE) or any(p.exp.is_negative and not p.base.is_positive for p in e.atoms(sp.Pow))


def _coincide(spring: Spring, surface: Surface) -> bool:
    apart = (spring.ends[1] - spring.ends[0]).fixed()
    try:
        return all(surface.is_zero(c) is True for c in apart.components)
    except DivisionByZeroError:
        return False  # reported as a division
