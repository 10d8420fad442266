"""The results for a problem, as `solution.solve` finds them stage by stage.

The file's own coordinates and each choice of generalized coordinates have one record, `InCoordinates`, of the same
fields; `Solution` has what does not depend on coordinates.

The values of a solved problem, with the units of the forces that it names.

A named reaction is a force (`dynamics.newton`), whatever the dimension of its constraint. It is in N even where a
number in a question, `x = 2 m`, hides the unit of its formula. Nothing is said of a name that stands for a multiplier.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import sympy as sp

from lagrange.core.records import record
from lagrange.core.symbols import Sign
from lagrange.core.units import unit_of
from lagrange.mechanics.constraints.classification import Classification
from lagrange.mechanics.constraints.coordinates import GeneralizedCoordinates
from lagrange.mechanics.constraints.displacements import Elimination
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.checks import Check
from lagrange.mechanics.dynamics.conservation import Conserved
from lagrange.mechanics.dynamics.equations import EquationsOfMotion
from lagrange.mechanics.dynamics.motion import Motion, NewtonLaw
from lagrange.mechanics.dynamics.newton import Normal, WorkOfReaction
from lagrange.mechanics.dynamics.spot_values import SpotValue
from lagrange.problem.model import ENERGY, KINETIC_ENERGY, Problem
from lagrange.problem.values import values_of

if TYPE_CHECKING:
    from lagrange.algebra.closed_forms.signs import SignCondition
    from lagrange.mechanics.dynamics.quasi_equations import QuasiVelocityForm
    from lagrange.mechanics.equilibrium.equilibrium import Equilibrium
    from lagrange.mechanics.equilibrium.friction.friction_at_rest import AtRest
    from lagrange.mechanics.equilibrium.friction.impending_motion import ImpendingMotion
    from lagrange.mechanics.equilibrium.friction.rolling import Rolling
    from lagrange.mechanics.equilibrium.in_numbers import EquilibriaInNumbers
    from lagrange.mechanics.equilibrium.linearization import Linearization
    from lagrange.mechanics.equilibrium.response import ForcedEquations, Response
    from lagrange.mechanics.equilibrium.stability import SecondVariation
    from lagrange.mechanics.equilibrium.static_reactions import StaticReactions
    from lagrange.mechanics.momenta.hamiltonian import Hamiltonian
    from lagrange.mechanics.momenta.impact import ImpulsiveMotion
    from lagrange.mechanics.momenta.steady_motions import SteadyMotions
    from lagrange.mechanics.nearby.linear_motion import LinearMotion
    from lagrange.mechanics.nearby.long_equations import LongEquations, LongReactions
    from lagrange.mechanics.nearby.one_state import RestInNumbers, StateInNumbers
    from lagrange.mechanics.questions.closed_motions import FromStart
    from lagrange.mechanics.questions.results import Asked
    from lagrange.values.quantities import Values


@record
class InCoordinates:
    """The results in one set of coordinates: the file's own, or a choice of generalized coordinates.

    coordinates        the verified choice; for the file's own coordinates it has no name
    configuration      the system in these coordinates; with |λ| in its friction once the motion is known
    elimination        the dependent virtual displacements in terms of the independent ones
    dynamics           the motion and the reactions
    spot               numbers to try the equations of motion with
    equilibrium        the equilibria
    reactions_at_rest  the reactions there, if there are constraints
    stability          of the equilibria, if there is a potential
    in_speeds          the velocities, and the equations of motion, in the quasi-velocities of the file
    conserved          the conserved quantities
    linearization      small oscillations
    hamiltonian        Hamilton's function and equations
    steady             steady motions
    forced             the linear equations under a harmonic drive, or a prescribed motion
    response           the steady state under a harmonic drive
    in_numbers         the equilibria, with the frequencies if they are requested, where the parameters have values
    at_rest            where the system can be at rest with friction
    rolling            the conditions under which what rolls does not slip
    impending          the equilibria with friction at its limit, for each direction of slip

    A result that is not requested, or is given in another set of coordinates, is None.
    """

    coordinates: GeneralizedCoordinates
    configuration: Configuration
    elimination: Elimination
    dynamics: Motion | None = None
    spot: SpotValue | None = None
    equilibrium: Equilibrium | None = None
    reactions_at_rest: StaticReactions | None = None
    stability: SecondVariation | None = None
    in_speeds: QuasiVelocityForm | None = None
    conserved: Conserved | None = None
    linearization: Linearization | None = None
    hamiltonian: Hamiltonian | None = None
    steady: SteadyMotions | None = None
    forced: ForcedEquations | None = None
    response: Response | None = None
    in_numbers: EquilibriaInNumbers | None = None
    at_rest: AtRest | None = None
    rolling: Rolling | None = None
    impending: tuple[ImpendingMotion, ...] | None = None

    @property
    def name(self) -> str:
        """The name of the choice; empty for the file's own coordinates."""
        return self.configuration.name

    @property
    def motion(self) -> EquationsOfMotion | None:
        """The equations of motion."""
        return self.dynamics.equations if self.dynamics else None

    @property
    def signs(self) -> tuple[Sign, ...]:
        """The signs ±1 of the square roots in which a choice gives the file's coordinates."""
        return self.coordinates.signs

    @property
    def is_about_rest(self) -> bool:
        """Whether there are results about rest, steady motion or small oscillations."""
        results = (self.equilibrium, self.at_rest, self.rolling, self.impending, self.steady, self.linearization)
        return any(r is not None for r in results)

    @property
    def cannot_rest(self) -> bool:
        """Whether no friction that the contacts admit holds the system at rest."""
        return self.at_rest is not None and not self.at_rest.cases

    @property
    def is_own(self) -> bool:
        """Whether these are the file's own coordinates."""
        return not self.name


@record
class Solution:
    """All results for a problem.

    own              in the file's own coordinates
    choices          in each choice of generalized coordinates
    transport_rates  shape (n,): rates w that moving constraints impose on the file's coordinates, dq = δq + w dt
    normals          gradients of the geometric constraints on one particle, unless the motion is requested
    law              Newton's law in the file's coordinates, if the motion or the reactions at rest are requested
    works            the work of the reactions
    asked            the answers to the questions of the file
    from_start       the motion from the initial state, where nothing is asked
    impact           the velocities after an impact, and the impulses
    after            the motion after it, where something is asked
    long_equations   the equations of motion in abbreviations, where nothing is eliminated because it would fill pages
    at_start         accelerations and reactions at t = 0, in numbers, for such a system
    linear_motion    the linear equations about the motion that the file gives, in numbers, for such a system
    rest_in_numbers  a position of equilibrium, in numbers, for such a system
    long_reactions   reactions that are too long as functions of position and velocity
    given_up         the stage at which the work was given up, and why; later results are missing
    """

    problem: Problem
    classification: Classification
    own: InCoordinates
    choices: tuple[InCoordinates, ...]
    transport_rates: tuple[sp.Expr, ...]
    normals: tuple[Normal, ...] = ()
    law: NewtonLaw | None = None
    works: tuple[WorkOfReaction, ...] = ()
    checks: tuple[Check, ...] = ()
    asked: tuple[Asked, ...] = ()
    from_start: FromStart | None = None
    impact: ImpulsiveMotion | None = None
    after: Solution | None = None
    long_equations: LongEquations | None = None
    at_start: StateInNumbers | None = None
    linear_motion: LinearMotion | None = None
    rest_in_numbers: RestInNumbers | None = None
    long_reactions: LongReactions | None = None
    given_up: str = ""

    @property
    def views(self) -> tuple[InCoordinates, ...]:
        """The system in every set of coordinates, the file's own first."""
        return (self.own, *self.choices)

    def view(self, name: str) -> InCoordinates:
        """The system in one set of coordinates, by the name of the choice; `""` is the file's own."""
        return next(v for v in self.views if v.name == name)

    def with_views(self, views: Iterable[InCoordinates], **changes: Any) -> Solution:
        """The solution with other results in each set of coordinates, and with other fields."""
        own, *choices = views
        return replace(self, own=own, choices=tuple(choices), **changes)

    @property
    def chosen(self) -> InCoordinates:
        """The system in the coordinates that are chosen first; in the file's own where none are."""
        return self.choices[0] if self.choices else self.own

    @property
    def views_by_page(self) -> tuple[InCoordinates, ...]:
        """The same in the order in which a page takes its numbers from one of them: a choice without signs first."""
        choices = sorted(self.choices, key=lambda c: bool(c.signs))
        return (*choices[:1], self.own, *choices[1:])

    @property
    def holds(self) -> bool:
        """Whether every check passed and nothing is undecided."""
        c = self.classification
        decided = None not in (c.holonomic, c.scleronomic, c.catastatic)
        return decided and not self.given_up and all(check.passed for check in self.checks)


# Solution values


def with_known_values(solution: Solution, values: Values) -> Solution:
    """The solution without the conditions, for equilibria and for single answers, that the values fulfil."""
    equilibria = (e for v in solution.views for e in (v.equilibrium, *(m.equilibrium for m in v.impending or ())))
    stated = [b.conditions for e in equilibria if e is not None for b in e.branches]
    rest = (there for v in solution.views if v.reactions_at_rest is not None for there in v.reactions_at_rest.at)
    stated += [tuple(there.contact.values()) for there in rest if there is not None]
    if not any(stated) and not any(b.conditions for a in solution.asked for b in a.branches):
        return solution
    from lagrange.mechanics.equilibrium.in_numbers import open_conditions, without_known_conditions

    def kept(c: SignCondition) -> bool:
        return bool(open_conditions([c], values))

    def known(view: InCoordinates) -> InCoordinates:
        if view.impending:
            limits = (replace(m, equilibrium=without_known_conditions(m.equilibrium, values)) for m in view.impending)
            view = replace(view, impending=tuple(limits))
        if view.reactions_at_rest is not None:
            at = tuple(there and there.with_contact(kept) for there in view.reactions_at_rest.at)
            view = replace(view, reactions_at_rest=replace(view.reactions_at_rest, at=at))
        before = view.equilibrium
        if before is None or (after := without_known_conditions(before, values)) is before:
            return view
        linear = view.linearization
        if linear is not None and linear.branches == before.branches:
            linear = replace(linear, branches=after.branches)
        return replace(view, equilibrium=after, linearization=linear)

    def single(asked: Asked) -> Asked:
        if len(asked.branches) != 1:
            return asked  # several are told apart by their conditions
        [b] = asked.branches
        return replace(asked, branches=(replace(b, conditions=open_conditions(b.conditions, values)),))

    asked = tuple(map(single, solution.asked))
    return replace(solution, own=known(solution.own), choices=tuple(map(known, solution.choices)), asked=asked)


def values_in(solution: Solution) -> Values | None:
    """The values of the problem that was solved; None if it has none."""
    values, newton = values_of(solution.problem), unit_of("N")
    if values is None or newton is None or not values.units:
        return values
    values = values.with_energies(KINETIC_ENERGY, ENERGY)
    if solution.law is None:
        return values
    forces = {f: newton.dimension for r in solution.law.newton.reactions if (f := r.symbol_of_force) is not None}
    return replace(values, units={**forces, **values.units})
