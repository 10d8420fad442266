"""The system of constraints as a whole: rank, hidden finite relations, classification, degrees of freedom.

    degrees of freedom        n − rank A               independent virtual displacements
    configuration dimension   n − integrable_rank      reachable configurations

`integrable_rank` is the rank of the last derived system: the number of finite relations that the constraints imply
together, even if no single one shows them. The system is holonomic if and only if integrable_rank = rank A. It is
rheonomic if t occurs in a position, in the finite relation of an integrable constraint, or in the form of one that is
not integrable.

Constraints that are not linear in the velocities enter A by Chetaev's rule, a = ∂φ/∂q'. They imply no finite relation
beyond those of the others where the admissible velocities are curved enough (`bending_rank`); otherwise the question is
undecided.

Shapes: A (m, n), a_t (m,). All ranks are taken at generic points where the geometric constraints hold and, where A
depends on the velocities, at velocities that satisfy the constraints.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import fields
from itertools import chain
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.algebra.exact.zero_test import Surface
from lagrange.algebra.forms.hidden_relations import (
    CombinedRelation,
    Flag,
    HiddenRelations,
    combination,
    combined_relations,
    differential_of,
    hidden_relations,
)
from lagrange.core.diagnostics import UndecidedError
from lagrange.core.records import all_hold, record
from lagrange.core.symbols import base, t
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.constrained_system import ConstrainedSystem, Row, is_pfaffian
from lagrange.mechanics.constraints.constraints import ConstraintAnalysis, analysis, bending_rank, constraint_row
from lagrange.mechanics.constraints.degeneracies import (
    RankLoss,
    check_consistent,
    check_curved,
    check_follows,
    rank_losses,
)
from lagrange.problem.model import Constraint, Force, Problem

if TYPE_CHECKING:
    from lagrange.algebra.forms.derived_flag import Manoeuvre
    from lagrange.mechanics.constraints.rigid_bodies import QuasiCoordinates


@record
class Redundancy:
    """A constraint that follows from earlier ones.

    combination  (name, c) for ω = Σ c ω_name; None if it is too long to be shown, or there is no form
    """

    name: str
    combination: tuple[tuple[str, sp.Expr], ...] | None


@record
class Classification:
    """The classification of all constraints together; None means undecided.

    rank       of A
    flag       the ranks of the derived flag
    redundancies  constraints that follow from earlier ones
    hidden     the finite relations that no single constraint implies, as far as they were found
    losses     special configurations where the constraints are not independent, as far as they were found
    moving     names of particles and bodies whose position contains t
    driven     names of bodies whose rotation contains t
    weighed    names of particles whose mass contains t, which makes no difference to the classification
    forced     whether a force contains t, which makes no difference either
    further_angles  how many more numbers than quasi-coordinates determine the orientation of bodies
    """

    constrained: ConstrainedSystem
    constraints: tuple[ConstraintAnalysis, ...]
    rank: int
    flag: Flag
    redundancies: tuple[Redundancy, ...]
    hidden: HiddenRelations
    losses: tuple[RankLoss, ...]
    moving: tuple[str, ...]
    driven: tuple[str, ...]
    weighed: tuple[str, ...] = ()
    forced: bool = False
    further_angles: int = 0

    @property
    def coordinates(self) -> int:
        """The number of coordinates, n."""
        return self.constrained.size

    @property
    def redundant(self) -> tuple[str, ...]:
        """The names of the redundant constraints."""
        return tuple(r.name for r in self.redundancies)

    @property
    def independent(self) -> tuple[ConstraintAnalysis, ...]:
        """The constraints that are not redundant."""
        return tuple(c for c in self.constraints if c.row.name not in self.redundant)

    @property
    def integrals(self) -> tuple[tuple[str, sp.Expr], ...]:
        """The functions that kinematic constraints keep constant, after their names, then the hidden ones, without."""
        kinematic = ((c.row.name, c.integral) for c in self.constraints if c.row.finite is None)
        single = ((name, f) for name, f in kinematic if f is not None)
        return (*single, *(("", r.function) for r in self.hidden.found))

    @property
    def combined(self) -> tuple[CombinedRelation, ...]:
        """What two of `integrals` say together with fewer coordinates than either."""
        return combined_relations([f for _, f in self.integrals], self.constrained.slots.coordinates)

    @property
    def manoeuvre(self) -> Manoeuvre | None:
        """Steps that lead where the only constraint, which is no integrable one, forbids a single step to go."""
        from lagrange.algebra.forms.derived_flag import manoeuvre

        [row] = self.constrained.rows
        if row.drift != 0 or row.nonlinear is not None or t in {s for a in row.coefficients for s in a.free_symbols}:
            return None
        return manoeuvre(row.coefficients, self.constrained.slots.coordinates)

    @property
    def integrable_rank(self) -> int | None:
        """The number of independent finite relations in the constraints."""
        return self.flag.integrable_rank

    @property
    def holonomic(self) -> bool | None:
        """Whether all constraints are equivalent to finite relations."""
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
        return all_hold(verdicts)

    @property
    def rheonomic_with(self) -> sp.Symbol | None:
        """The parameter that may be zero, and without which the system would be scleronomic."""
        timed = {c.row.moves_with(self.constrained.slots) for c in self.constraints if c.depends_on_time}
        return timed.pop() if len(timed) == 1 and not self.moving and not self.driven else None

    @property
    def degrees_of_freedom(self) -> int:
        """The number of independent virtual displacements."""
        return self.coordinates - self.rank

    @property
    def configuration_dimension(self) -> int | None:
        """The dimension of the reachable configurations, a quasi-coordinate counted as a coordinate."""
        return None if self.integrable_rank is None else self.coordinates - self.integrable_rank

    @property
    def reachable_dimension(self) -> int | None:
        """The dimension of the reachable configurations; the orientation of a body with quasi-coordinates counts 3."""
        dimension = self.configuration_dimension
        return None if dimension is None else dimension + self.further_angles - self.flag.beside

    @property
    def rows(self) -> tuple[Row, ...]:
        """The differential forms."""
        return self.constrained.rows


def classify(problem: Problem) -> Classification:
    """Analyse the constraints of a problem.

    Raises ProblemError if they contradict each other, UndecidedError if their rank could not be found.
    """
    slots = problem.slots
    system = ConstrainedSystem(slots, tuple(constraint_row(c, slots) for c in problem.constraints))
    check_consistent(problem.constraints, system)
    check_curved(problem.constraints, system)
    redundant = _redundant(problem.constraints, system)
    independent = system.without({r.name for r in redundant})
    quasi = _quasi_coordinates(problem) if len(system.geometric) < len(system.rows) else None
    constraints = tuple(
        analysis(c, row, independent, quasi) for c, row in zip(problem.constraints, system.rows, strict=True)
    )
    rank = _rank(system)
    in_quasi_coordinates = {r.name for r in system.rows if quasi is not None and quasi.used_by(r.form, slots)}
    flag = _flag(system, rank, quasi if in_quasi_coordinates else None)
    return Classification(
        constrained=system,
        constraints=constraints,
        rank=rank,
        flag=flag,
        redundancies=redundant,
        hidden=_hidden(constraints, independent.without(in_quasi_coordinates), flag),
        losses=rank_losses(independent) if system.is_pfaffian else (),
        moving=_moving_positions(problem),
        driven=_driven_rotations(problem),
        weighed=tuple(p.name for p in problem.particles if {t, *problem.slots.prescribed} & p.mass.free_symbols),
        forced=any({t, *problem.slots.prescribed} & _symbols_of(f) for f in problem.forces),
        further_angles=len(quasi.slots.coordinates) - len(slots.coordinates) if quasi and in_quasi_coordinates else 0,
    )


def _symbols_of(force: Force) -> set[sp.Symbol]:
    """The symbols that an applied force depends on."""
    symbols: set[sp.Symbol] = set()
    parts = [getattr(force, f.name) for f in fields(force)]
    for part in chain.from_iterable(p if isinstance(p, tuple) else (p,) for p in parts):
        if isinstance(part, sp.Expr):
            symbols |= part.free_symbols
        elif isinstance(part, Vector):
            symbols |= set().union(*(c.free_symbols for c in part.fixed().components))
    return symbols


def _quasi_coordinates(problem: Problem) -> QuasiCoordinates | None:
    from lagrange.mechanics.constraints.rigid_bodies import quasi_coordinates

    return quasi_coordinates(problem)


def _flag(system: ConstrainedSystem, rank: int, quasi: QuasiCoordinates | None) -> Flag:
    """The derived flag of the Pfaffian rows; it is that of all rows if the others are curved enough.

    Rows with quasi-coordinates are rewritten in true coordinates first. If the constraints leave no freedom, q' is a
    function of q and t, and all of them together are equivalent to finite relations.
    """
    rows, slots, finite = system.rows, system.slots, system.surface.constraints
    if rows and all(r.finite is not None for r in rows):
        return Flag((rank,), rank)  # differentials of the finite relations, whose derived system is the same
    from lagrange.algebra.forms.derived_flag import derived_flag

    pfaffian = [r for r in rows if r.nonlinear is None]
    forms = [r.form for r in pfaffian]
    if quasi is not None:
        turned = [quasi.in_angles(form, slots) for form in forms]
        if len(pfaffian) < len(rows) or None in turned:
            return Flag((rank,), None, "some coordinates are quasi-coordinates")
        known = [f for f in turned if f is not None]
        return derived_flag(known, quasi.slots, finite, modulo=quasi.restrictions)
    flag = derived_flag(forms, slots, finite) if forms else Flag((0,), 0)
    if len(pfaffian) == len(rows):
        return flag
    if rank == system.size:
        return Flag((rank,), rank)
    if flag.integrable_rank is None:
        return flag
    linear = system.surface.rank([r.coefficients for r in pfaffian]) if pfaffian else 0
    curvature = bending_rank(system)
    # The admissible velocities span at least n − rank + curvature dimensions; n − linear exclude a finite relation.
    if linear is None or curvature is None or linear + curvature != rank:
        return Flag(flag.ranks, None, "the velocities that are admitted at one position may lie in a plane")
    return flag


def _rank(system: ConstrainedSystem) -> int:
    rank = system.rank
    if rank is None:
        raise UndecidedError("how many of the constraints are independent")
    return rank


def _redundant(constraints: Sequence[Constraint], system: ConstrainedSystem) -> tuple[Redundancy, ...]:
    """The rows that do not raise the rank of earlier ones, as combinations of these."""
    rows, states = system.rows, system.states
    if system.rank == len(rows):
        return ()
    redundant: list[Redundancy] = []
    independent: list[Row] = []
    for count, (constraint, row) in enumerate(zip(constraints, rows, strict=True), start=1):
        rank = states.rank([r.coefficients for r in (*independent, row)])
        if rank is None:
            raise UndecidedError(f"whether the constraint `{row.name}` follows from the others")
        if rank > len(independent):
            independent.append(row)
            continue
        check_follows(constraint, system.with_rows(rows[: count - 1]), row)
        redundant.append(Redundancy(row.name, _combination(row, independent, states)))
    return tuple(redundant)


def _combination(row: Row, others: Sequence[Row], surface: Surface) -> tuple[tuple[str, sp.Expr], ...] | None:
    """The terms of ω = Σ c ω_name; None if they are long or there are no forms."""
    if not is_pfaffian([*others, row]):
        return None
    values = combination(row.form, [r.form for r in others], surface) if others else ()
    return None if values is None else tuple((r.name, c) for r, c in zip(others, values, strict=True) if c != 0)


def _hidden(constraints: Sequence[ConstraintAnalysis], independent: ConstrainedSystem, flag: Flag) -> HiddenRelations:
    """The finite relations beyond the geometric constraints and the kinematic ones whose integral is known."""
    known = [c.row.form for c in constraints if c.row.finite is not None]
    integrals = [c.integral for c in constraints if c.row.finite is None and c.integral is not None]
    known += [differential_of(f, independent.slots) for f in integrals]
    forms = [r.form for r in independent.rows if r.nonlinear is None]
    return hidden_relations(forms, known, flag.integrable_rank, independent.surface, independent.slots, flag.bound)


def _moving_positions(problem: Problem) -> tuple[str, ...]:
    """The particles and bodies whose position contains t, explicitly or through a prescribed motion."""
    return tuple(p.name for p in problem.masses if _contains_time(p.position.fixed().components, problem))


def _driven_rotations(problem: Problem) -> tuple[str, ...]:
    """The bodies whose orientation contains t, or whose angular velocity has a part without velocities."""
    at_rest: dict[sp.Basic, sp.Basic] = dict.fromkeys(problem.slots.velocities, sp.S.Zero)
    driven = []
    for b in problem.bodies:
        orientation = [*b.angles, *(c for axis in b.axes for c in axis.fixed().components), b.angle or sp.S.Zero]
        spin = () if b.angular_velocity is None else b.angular_velocity.components
        if _contains_time(orientation, problem) or any(w.xreplace(at_rest) != 0 for w in spin):
            driven.append(b.name)
    return tuple(driven)


def _contains_time(parts: Iterable[sp.Expr], problem: Problem) -> bool:
    return any(s == t or base(s) in problem.slots.prescribed for c in parts for s in c.free_symbols)
