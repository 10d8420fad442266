"""The whole system of constraints: rank, hidden finite relations, classification, degrees of freedom.

    degrees of freedom        n − rank A               independent virtual displacements
    configuration dimension   n − integrable_rank      reachable configurations

`integrable_rank` is the rank of the last derived system: the number of finite relations that the constraints hold
together, some of them perhaps shown by none alone. The system is holonomic when all of them come to finite relations.
A constraint that is a finite relation makes it rheonomic by t in that relation, one that is not by t in its form.

Constraints that are not linear in the velocities count in A by Chetaev's rule, a = ∂φ/∂q'. They hold no finite relation
beyond those of the others where the admitted velocities bend enough (`bending`); where they do not, it is undecided.

Shapes: A (m, n), a_t (m,). All ranks are taken at generic points where the geometric constraints hold, and at
velocities that the constraints admit where A depends on these.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import sympy as sp

from lagrange.bending import bending_rank
from lagrange.constraints import ConstraintAnalysis, analysis, constraint_row
from lagrange.diagnostics import Diagnostic, ProblemError, UndecidedError
from lagrange.exact import NoPointError, Surface
from lagrange.integrability import Flag, derived_flag
from lagrange.kinematics import Row, admitted_states, is_pfaffian
from lagrange.notation import Slots, base, t
from lagrange.problem import Constraint, Problem


@dataclass(frozen=True)
class Classification:
    """What the constraints are together. What is None could not be decided.

    rank       of A
    flag       the ranks of the derived flag
    redundant  names of constraints that follow from those before them
    moving     names of particles and bodies whose position contains t
    driven     names of bodies that time turns
    """

    constraints: tuple[ConstraintAnalysis, ...]
    rank: int
    flag: Flag
    redundant: tuple[str, ...]
    moving: tuple[str, ...]
    driven: tuple[str, ...]
    coordinates: int

    @property
    def integrable_rank(self) -> int | None:
        """The number of independent finite relations in the constraints."""
        return self.flag.integrable_rank

    @property
    def holonomic(self) -> bool | None:
        """Whether all constraints come to finite relations."""
        return None if self.integrable_rank is None else self.integrable_rank == self.rank

    @property
    def scleronomic(self) -> bool | None:
        """Whether neither the constraints nor the positions contain t."""
        verdicts = [c.depends_on_time for c in self.constraints]
        if self.moving or self.driven or True in verdicts:
            return False
        return None if None in verdicts else True

    @property
    def catastatic(self) -> bool | None:
        """Whether a_t = 0 in all constraints."""
        verdicts = [c.catastatic for c in self.constraints]
        return False if False in verdicts else None if None in verdicts else True

    @property
    def degrees_of_freedom(self) -> int:
        """The number of independent virtual displacements."""
        return self.coordinates - self.rank

    @property
    def configuration_dimension(self) -> int | None:
        """The dimension of the reachable configurations."""
        return None if self.integrable_rank is None else self.coordinates - self.integrable_rank

    @property
    def rows(self) -> tuple[Row, ...]:
        """The differential forms."""
        return tuple(c.row for c in self.constraints)


def classify(problem: Problem) -> Classification:
    """Analyses the constraints of a problem.

    Raises ProblemError where they contradict one another, UndecidedError where their rank could not be found.
    """
    slots = problem.slots
    rows = tuple(constraint_row(c, slots) for c in problem.constraints)
    geometric = [r for r in rows if r.finite is not None]
    surface = Surface([r.finite for r in geometric], slots.coordinates)
    _check_consistent(problem.constraints, rows, surface)
    states = surface if is_pfaffian(rows) else admitted_states(rows, slots)
    _check_curved(problem.constraints, rows, states)
    redundant = _redundant(problem.constraints, rows, states, slots)
    independent = [r for r in geometric if r.name not in redundant]
    rank = _rank(rows, states)
    return Classification(
        constraints=tuple(
            analysis(c, row, independent, surface, slots) for c, row in zip(problem.constraints, rows, strict=True)
        ),
        rank=rank,
        flag=_flag(rows, rank, slots, surface, states),
        redundant=redundant,
        moving=_moving_positions(problem),
        driven=_driven_rotations(problem),
        coordinates=len(slots.coordinates),
    )


def _flag(rows: Sequence[Row], rank: int, slots: Slots, surface: Surface, states: Surface) -> Flag:
    """The derived flag of the Pfaffian rows, which is that of all rows if the others bend enough.

    Where the constraints leave no freedom, q' is a function of q and t, and all of them together are finite relations.
    """
    pfaffian = [r for r in rows if r.nonlinear is None]
    forms = [(*r.coefficients, r.drift) for r in pfaffian]
    flag = derived_flag(forms, slots, surface.constraints) if forms else Flag((0,), 0)
    if len(pfaffian) == len(rows):
        return flag
    if rank == len(slots.coordinates):
        return Flag((rank,), rank)
    if flag.integrable_rank is None:
        return flag
    straight = surface.rank([r.coefficients for r in pfaffian]) if pfaffian else 0
    bent = bending_rank(rows, slots, states)
    if straight is None or bent is None or straight + bent != rank:
        return Flag(flag.ranks, None, "the velocities that are admitted at one position may lie in a plane")
    return flag


def _rank(rows: Sequence[Row], surface: Surface) -> int:
    found = surface.rank([r.coefficients for r in rows]) if rows else 0
    if found is None:
        raise UndecidedError("how many of the constraints are independent")
    return found


def _check_consistent(constraints: Sequence[Constraint], rows: Sequence[Row], surface: Surface) -> None:
    """Refuses constraints that exclude one another: f = 0 with f = 1, or a_t outside the range of A."""
    pfaffian = [(c, r) for c, r in zip(constraints, rows, strict=True) if r.nonlinear is None]
    constraints, rows = [c for c, _ in pfaffian], [r for _, r in pfaffian]
    geometric = [c for c in constraints if not c.kinematic]
    clash = [geometric[k] for k in surface.contradictory()]
    if not clash or has_real_point(surface):
        _check_regular(geometric, rows, surface)
        clash = _clash_of_rates(constraints, rows, surface)
    if clash:
        raise _contradiction(clash)


def _contradiction(clash: Sequence[Constraint]) -> ProblemError:
    listed = " and ".join(f"`{c.name}`" for c in clash)
    message = f"{listed} contradict each other" if len(clash) > 1 else f"{listed} cannot be satisfied"
    help_ = "no position or velocity satisfies them; correct or remove one"
    return ProblemError(Diagnostic("contradictory-constraints", message, clash[-1].span, help=help_))


def _check_curved(constraints: Sequence[Constraint], rows: Sequence[Row], states: Surface) -> None:
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


def has_real_point(surface: Surface) -> bool:
    """Whether a real configuration satisfies the constraints; found by Newton's iteration, so that True is certain."""
    try:
        surface.real_point()
    except NoPointError:
        return False
    return True


def _check_regular(geometric: Sequence[Constraint], rows: Sequence[Row], surface: Surface) -> None:
    """Refuses constraints such as sin x = 1, whose differential vanishes where they hold and binds nothing."""
    finite = [r for r in rows if r.finite is not None]
    for constraint, row in zip(geometric, finite, strict=True):
        if surface.rank([row.coefficients]) == 0:
            message = f"the differential of `{constraint.name}` vanishes wherever the constraint holds"
            help_ = "write it so that it changes sign there: `x = pi/2` and not `sin(x) = 1`"
            raise ProblemError(Diagnostic("singular-constraint", message, constraint.span, help=help_))


def _clash_of_rates(constraints: Sequence[Constraint], rows: Sequence[Row], surface: Surface) -> list[Constraint]:
    """The first constraint whose velocity form excludes those before it, with them."""
    for count in range(1, len(rows) + 1):
        some = rows[:count]
        a = surface.rank([r.coefficients for r in some])
        whole = surface.rank([(*r.coefficients, r.drift) for r in some])
        if a is not None and whole is not None and whole > a:
            return _smallest_clash(constraints[:count], some, surface)
    return []


def _smallest_clash(constraints: Sequence[Constraint], rows: Sequence[Row], surface: Surface) -> list[Constraint]:
    """Without those constraints that the contradiction does not need."""
    kept = list(zip(constraints, rows, strict=True))
    for pair in list(kept):
        fewer = [p for p in kept if p is not pair]
        a = surface.rank([r.coefficients for _, r in fewer]) if fewer else 0
        whole = surface.rank([(*r.coefficients, r.drift) for _, r in fewer]) if fewer else 0
        if a is not None and whole is not None and whole > a:
            kept = fewer
    return [c for c, _ in kept]


def _redundant(
    constraints: Sequence[Constraint], rows: Sequence[Row], surface: Surface, slots: Slots
) -> tuple[str, ...]:
    """The rows that raise the rank of those before them by nothing."""
    found = []
    before = 0
    for count, row in enumerate(rows, start=1):
        now = surface.rank([r.coefficients for r in rows[:count]])
        if now is None:
            raise UndecidedError(f"whether the constraint `{row.name}` follows from the others")
        if now == before:
            _check_follows(constraints[count - 1], rows[:count], slots)
            found.append(row.name)
        before = now
    return tuple(found)


def _check_follows(constraint: Constraint, rows: Sequence[Row], slots: Slots) -> None:
    """Refuses a constraint that only touches those before it: x' = 1 touches x'² + y'² = 1 where y' = 0."""
    if is_pfaffian(rows):
        return
    follows = admitted_states(rows[:-1], slots).is_zero(rows[-1].velocity_form(slots))
    if follows is None:
        raise UndecidedError(f"whether the constraint `{constraint.name}` follows from the others", constraint.span)
    if not follows:
        raise _singular(constraint)


def _moving_positions(problem: Problem) -> tuple[str, ...]:
    """The particles and bodies whose position contains t, explicitly or through a prescribed motion."""
    return tuple(p.name for p in problem.masses if _contains_time(p.position.fixed().components, problem))


def _driven_rotations(problem: Problem) -> tuple[str, ...]:
    """The bodies whose orientation contains t, or whose angular velocity has a part without velocities."""
    rest: dict[sp.Basic, sp.Basic] = dict.fromkeys(problem.slots.velocities, sp.S.Zero)
    found = []
    for b in problem.bodies:
        turned = [*b.angles, *(c for axis in b.axes for c in axis.fixed().components), b.angle or sp.S.Zero]
        own = () if b.angular_velocity is None else b.angular_velocity.components
        if _contains_time(turned, problem) or any(w.xreplace(rest) != 0 for w in own):
            found.append(b.name)
    return tuple(found)


def _contains_time(parts: Iterable[sp.Expr], problem: Problem) -> bool:
    return any(s == t or base(s) in problem.slots.prescribed for c in parts for s in c.free_symbols)
