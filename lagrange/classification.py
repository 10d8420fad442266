"""The whole system of constraints: rank, hidden finite relations, classification, degrees of freedom.

    degrees of freedom        n − rank A               independent virtual displacements
    configuration dimension   n − integrable_rank      reachable configurations

`integrable_rank` is the rank of the last derived system: the number of finite relations that the constraints hold
together, some of them perhaps shown by none alone. The system is holonomic when all of them come to finite relations.
A constraint that is a finite relation makes it rheonomic by t in that relation, one that is not by t in its form.

Shapes: A (m, n), a_t (m,). All ranks are taken at generic points where the geometric constraints hold.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp

from lagrange.combinations import combination
from lagrange.consistency import check_consistent
from lagrange.constraints import ConstraintAnalysis, analysis, pfaffian_form
from lagrange.diagnostics import UndecidedError
from lagrange.exact import Surface
from lagrange.hidden_relations import HiddenRelations, differential_of, hidden_relations
from lagrange.integrability import Flag, derived_flag
from lagrange.kinematics import Row
from lagrange.notation import Slots, base, t
from lagrange.problem import Problem
from lagrange.rank_loss import RankLoss, rank_losses


@dataclass(frozen=True)
class Redundancy:
    """A constraint that follows from those before it.

    combination  (name, c) for ω = Σ c ω_name; None where it is too long to be shown
    """

    name: str
    combination: tuple[tuple[str, sp.Expr], ...] | None


@dataclass(frozen=True)
class Classification:
    """What the constraints are together. What is None could not be decided.

    rank       of A
    flag       the ranks of the derived flag
    redundancies  constraints that follow from those before them
    hidden     the finite relations that no single constraint shows, as far as they were found
    losses     special configurations where the constraints are not independent, as far as they were found
    moving     names of particles whose position contains t
    """

    constraints: tuple[ConstraintAnalysis, ...]
    rank: int
    flag: Flag
    redundancies: tuple[Redundancy, ...]
    hidden: HiddenRelations
    losses: tuple[RankLoss, ...]
    moving: tuple[str, ...]
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
        if self.moving or True in verdicts:
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

    Raises ProblemError where they contradict one another, UndecidedError where their rank could not be found,
    NotCoveredError where one is not linear in the velocities.
    """
    slots = problem.slots
    rows = tuple(pfaffian_form(c, slots) for c in problem.constraints)
    geometric = [r for r in rows if r.finite is not None]
    surface = Surface([r.finite for r in geometric], slots.coordinates)
    check_consistent(problem.constraints, rows, surface)
    redundant = _redundant(rows, surface)
    names = {r.name for r in redundant}
    independent = [r for r in rows if r.name not in names]
    finite = [r for r in independent if r.finite is not None]
    constraints = tuple(
        analysis(c, row, finite, surface, slots) for c, row in zip(problem.constraints, rows, strict=True)
    )
    flag = derived_flag([r.form for r in rows], slots, surface.constraints) if rows else Flag((0,), 0)
    return Classification(
        constraints=constraints,
        rank=_rank(rows, surface),
        flag=flag,
        redundancies=redundant,
        hidden=_hidden(constraints, independent, flag, surface, slots),
        losses=rank_losses(independent, surface, slots),
        moving=_moving_positions(problem),
        coordinates=len(slots.coordinates),
    )


def _rank(rows: Sequence[Row], surface: Surface) -> int:
    found = surface.rank([r.coefficients for r in rows]) if rows else 0
    if found is None:
        raise UndecidedError("how many of the constraints are independent")
    return found


def _redundant(rows: Sequence[Row], surface: Surface) -> tuple[Redundancy, ...]:
    """The rows that raise the rank of those before them by nothing, as combinations of these."""
    found: list[Redundancy] = []
    independent: list[Row] = []
    for row in rows:
        now = surface.rank([r.coefficients for r in (*independent, row)])
        if now is None:
            raise UndecidedError(f"whether the constraint `{row.name}` follows from the others")
        if now > len(independent):
            independent.append(row)
            continue
        names = [r.name for r in independent]
        values = combination(row.form, [r.form for r in independent], surface) if names else ()
        terms = None if values is None else tuple((n, c) for n, c in zip(names, values, strict=True) if c != 0)
        found.append(Redundancy(row.name, terms))
    return tuple(found)


def _hidden(
    constraints: Sequence[ConstraintAnalysis], independent: Sequence[Row], flag: Flag, surface: Surface, slots: Slots
) -> HiddenRelations:
    """The finite relations beyond the geometric constraints and the kinematic ones whose integral is known."""
    known = [c.row.form for c in constraints if c.row.finite is not None]
    integrals = [c.integral for c in constraints if c.row.finite is None and c.integral is not None]
    known += [differential_of(f, slots) for f in integrals]
    forms = [r.form for r in independent]
    return hidden_relations(forms, known, flag.integrable_rank, surface, slots, flag.bound)


def _moving_positions(problem: Problem) -> tuple[str, ...]:
    """The particles and bodies whose position contains t, explicitly or through a prescribed motion."""
    prescribed = set(problem.slots.prescribed)
    positions = [(p.name, p.position) for p in problem.particles] + [(b.name, b.position) for b in problem.bodies]
    return tuple(
        name
        for name, r in positions
        if any(s == t or base(s) in prescribed for c in r.components for s in c.free_symbols)
    )
