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

import sympy as sp

from lagrange.algebra.exact.exact import Surface
from lagrange.algebra.forms.combinations import combination
from lagrange.algebra.forms.hidden_relations import HiddenRelations, differential_of, hidden_relations
from lagrange.algebra.forms.integrability import Flag, derived_flag
from lagrange.core.diagnostics import UndecidedError
from lagrange.core.records import record
from lagrange.core.symbols import Slots, base, t
from lagrange.mechanics.constraints.bending import bending_rank
from lagrange.mechanics.constraints.consistency import check_consistent, check_curved, check_follows
from lagrange.mechanics.constraints.constraints import ConstraintAnalysis, analysis, constraint_row
from lagrange.mechanics.constraints.kinematics import Row, admitted_states, is_pfaffian
from lagrange.mechanics.constraints.quasi_coordinates import QuasiCoordinates, quasi_coordinates
from lagrange.mechanics.constraints.rank_loss import RankLoss, rank_losses
from lagrange.problem.model import Constraint, Problem


@record
class Redundancy:
    """A constraint that follows from those before it.

    combination  (name, c) for ω = Σ c ω_name; None where it is too long to be shown, or there is no form
    """

    name: str
    combination: tuple[tuple[str, sp.Expr], ...] | None


@record
class Classification:
    """What the constraints are together. What is None could not be decided.

    rank       of A
    flag       the ranks of the derived flag
    redundancies  constraints that follow from those before them
    hidden     the finite relations that no single constraint shows, as far as they were found
    losses     special configurations where the constraints are not independent, as far as they were found
    moving     names of particles and bodies whose position contains t
    driven     names of bodies that time turns
    """

    constraints: tuple[ConstraintAnalysis, ...]
    rank: int
    flag: Flag
    redundancies: tuple[Redundancy, ...]
    hidden: HiddenRelations
    losses: tuple[RankLoss, ...]
    moving: tuple[str, ...]
    driven: tuple[str, ...]
    coordinates: int

    @property
    def redundant(self) -> tuple[str, ...]:
        """The names of the constraints that follow from those before them."""
        return tuple(r.name for r in self.redundancies)

    @property
    def independent(self) -> tuple[ConstraintAnalysis, ...]:
        """The constraints that are not redundant."""
        return tuple(c for c in self.constraints if c.row.name not in self.redundant)

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
    check_consistent(problem.constraints, rows, surface)
    states = surface if is_pfaffian(rows) else admitted_states(rows, slots)
    check_curved(problem.constraints, rows, states)
    redundant = _redundant(problem.constraints, rows, states, slots)
    names = {r.name for r in redundant}
    independent = [r for r in rows if r.name not in names]
    finite = [r for r in independent if r.finite is not None]
    quasi = quasi_coordinates(problem) if any(r.finite is None for r in rows) else None
    constraints = tuple(
        analysis(c, row, finite, surface, slots, quasi) for c, row in zip(problem.constraints, rows, strict=True)
    )
    rank = _rank(rows, states)
    true = [r for r in rows if quasi is None or not quasi.used_by(r.form, slots)]
    flag = _flag(rows, rank, slots, surface, states, None if len(true) == len(rows) else quasi)
    return Classification(
        constraints=constraints,
        rank=rank,
        flag=flag,
        redundancies=redundant,
        hidden=_hidden(constraints, [r for r in independent if r in true], flag, surface, slots),
        losses=rank_losses(independent, surface, slots) if is_pfaffian(rows) else (),
        moving=_moving_positions(problem),
        driven=_driven_rotations(problem),
        coordinates=len(slots.coordinates),
    )


def _flag(
    rows: Sequence[Row],
    rank: int,
    slots: Slots,
    surface: Surface,
    states: Surface,
    quasi: QuasiCoordinates | None = None,
) -> Flag:
    """The derived flag of the Pfaffian rows, which is that of all rows if the others bend enough.

    Of rows with quasi-coordinates it is that of the forms in true ones.

    Where the constraints leave no freedom, q' is a function of q and t, and all of them together are finite relations.
    """
    pfaffian = [r for r in rows if r.nonlinear is None]
    forms = [(*r.coefficients, r.drift) for r in pfaffian]
    if quasi is not None:
        turned = [quasi.in_angles(form, slots) for form in forms]
        if len(pfaffian) < len(rows) or None in turned:
            return Flag((rank,), None, "some coordinates are quasi-coordinates")
        return derived_flag([f for f in turned if f is not None], quasi.slots, surface.constraints)
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


def _redundant(
    constraints: Sequence[Constraint], rows: Sequence[Row], surface: Surface, slots: Slots
) -> tuple[Redundancy, ...]:
    """The rows that raise the rank of those before them by nothing, as combinations of these."""
    if rows and surface.rank([r.coefficients for r in rows]) == len(rows):
        return ()
    found: list[Redundancy] = []
    independent: list[Row] = []
    for count, (constraint, row) in enumerate(zip(constraints, rows, strict=True), start=1):
        now = surface.rank([r.coefficients for r in (*independent, row)])
        if now is None:
            raise UndecidedError(f"whether the constraint `{row.name}` follows from the others")
        if now > len(independent):
            independent.append(row)
            continue
        check_follows(constraint, rows[:count], slots)
        found.append(Redundancy(row.name, _combination(row, independent, surface)))
    return tuple(found)


def _combination(row: Row, others: Sequence[Row], surface: Surface) -> tuple[tuple[str, sp.Expr], ...] | None:
    """The terms of ω = Σ c ω_name; None where they are long or there are no forms."""
    if not is_pfaffian([*others, row]):
        return None
    values = combination(row.form, [r.form for r in others], surface) if others else ()
    return None if values is None else tuple((r.name, c) for r, c in zip(others, values, strict=True) if c != 0)


def _hidden(
    constraints: Sequence[ConstraintAnalysis], independent: Sequence[Row], flag: Flag, surface: Surface, slots: Slots
) -> HiddenRelations:
    """The finite relations beyond the geometric constraints and the kinematic ones whose integral is known."""
    known = [c.row.form for c in constraints if c.row.finite is not None]
    integrals = [c.integral for c in constraints if c.row.finite is None and c.integral is not None]
    known += [differential_of(f, slots) for f in integrals]
    forms = [r.form for r in independent if r.nonlinear is None]
    return hidden_relations(forms, known, flag.integrable_rank, surface, slots, flag.bound)


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
