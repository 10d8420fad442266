"""solve(): the stages in order.

statement -> constraints -> classification -> displacements -> Newton's law -> workless constraints -> d'Alembert's
principle -> generalized coordinates -> equations of motion -> reactions -> what is conserved -> checks. Each stage is a
function of its own in a module of its own; what each of them finds is a field of the result.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import field, replace
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.core.diagnostics import Diagnostic, NotCoveredError, ProblemError, suggestion
from lagrange.core.records import record
from lagrange.mechanics.constraints.classification import Classification, classify
from lagrange.mechanics.constraints.coordinates import GeneralizedCoordinates, generalized_coordinates
from lagrange.mechanics.constraints.displacements import Elimination, carrying_rates, eliminate
from lagrange.mechanics.constraints.kinematics import Configuration, file_configuration
from lagrange.mechanics.dynamics.comparison import System
from lagrange.mechanics.dynamics.conservation import Conserved, check_conserved, conserved
from lagrange.mechanics.dynamics.constant_inertia import check_constant_inertia
from lagrange.mechanics.dynamics.equations import EquationsOfMotion, check_inertia
from lagrange.mechanics.dynamics.matrix_form import solved_accelerations
from lagrange.mechanics.dynamics.motion import Law, Method, Motion, law_of_motion, motion
from lagrange.mechanics.dynamics.newton import Normal, normals
from lagrange.mechanics.dynamics.spot_values import Spot, spot_value
from lagrange.mechanics.dynamics.verification import (
    Check,
    check_choice,
    check_displacements,
    check_finite_forms,
    check_hidden,
    check_integrability,
    check_motion,
    check_reactions,
    check_reality,
    check_workless,
)
from lagrange.mechanics.dynamics.workless import WorkOfReaction, works_of_reactions
from lagrange.problem.model import Choice, Find, Friction, Problem

if TYPE_CHECKING:
    from lagrange.mechanics.dynamics.quasi_verification import InSpeeds
    from lagrange.mechanics.equilibrium.equilibrium import Equilibrium
    from lagrange.mechanics.equilibrium.linearization import Linearization
    from lagrange.mechanics.equilibrium.stability import SecondVariation
    from lagrange.mechanics.equilibrium.static_reactions import StaticReactions


@record
class ChoiceSolution:
    """The problem in one choice of generalized coordinates; what is not asked for is None."""

    coordinates: GeneralizedCoordinates
    dynamics: Motion | None = None
    spot: Spot | None = None
    equilibrium: Equilibrium | None = None
    reactions_at_rest: StaticReactions | None = None
    stability: SecondVariation | None = None
    in_speeds: InSpeeds | None = None
    conserved: Conserved | None = None
    linearization: Linearization | None = None

    @property
    def motion(self) -> EquationsOfMotion | None:
        """The equations of motion."""
        return self.dynamics.equations if self.dynamics else None

    @property
    def name(self) -> str:
        """The choice's name."""
        return self.coordinates.choice.name


@record
class Solution:
    """Everything that is found.

    configuration  the system in the file's own coordinates
    elimination    of the dependent virtual displacements there
    carried        shape (n,): rates w with which moving constraints carry the coordinates along, dq = δq + w dt
    normals        gradients of the geometric constraints on one particle, where no motion is asked
    law            Newton's law there, where motion is asked, or the reactions of a system at rest
    works          the work of the reactions
    dynamics       the motion and the reactions there
    equilibrium    its equilibria, where these are asked for; their stability, where there is a potential
    reactions_at_rest  the reactions there, where there are constraints
    in_speeds    the velocities, and the equations of motion, by the quasi-velocities of the file
    conserved      what the motion conserves; None where it is found in a choice only
    linearization  small oscillations in the file's coordinates, where no choice serves
    """

    problem: Problem
    classification: Classification
    configuration: Configuration
    elimination: Elimination
    carried: tuple[sp.Expr, ...]
    normals: tuple[Normal, ...] = ()
    law: Law | None = None
    works: tuple[WorkOfReaction, ...] = ()
    dynamics: Motion | None = None
    spot: Spot | None = None
    choices: tuple[ChoiceSolution, ...] = ()
    checks: tuple[Check, ...] = field(default=())
    equilibrium: Equilibrium | None = None
    reactions_at_rest: StaticReactions | None = None
    stability: SecondVariation | None = None
    in_speeds: InSpeeds | None = None
    conserved: Conserved | None = None
    linearization: Linearization | None = None

    @property
    def motion(self) -> EquationsOfMotion | None:
        """The equations of motion in the file's coordinates."""
        return self.dynamics.equations if self.dynamics else None

    @property
    def holds(self) -> bool:
        """Whether every check held and nothing is undecided."""
        c = self.classification
        decided = None not in (c.holonomic, c.scleronomic, c.catastatic)
        return decided and all(check.passed for check in self.checks)


def solve(
    problem: Problem, choice: str | None = None, *, complete: bool = True, method: Method = Method.DALEMBERT
) -> Solution:
    """Solves a problem; with `choice`, in that choice of generalized coordinates only.

    method    by what equations of motion are derived; statics knows only the principle of virtual work
    complete  also what is long and not shown unasked: several reactions, and what is conserved, in dependent
              coordinates, if a choice has them

    Raises ProblemError where the problem contradicts itself, UndecidedError and NotCoveredError where it cannot be
    solved.
    """
    _refuse_what_is_not_covered(problem)
    if Find.LINEARIZATION in problem.find and Find.MOTION not in problem.find:
        problem = replace(problem, find=(Find.MOTION, *problem.find))
    classification = classify(problem)
    configuration = file_configuration(problem, classification.rows)
    elimination = eliminate(configuration.rows, len(problem.coordinates), configuration.states)
    carried = carrying_rates(configuration.rows, elimination, len(problem.coordinates), configuration.surface)
    chosen = [generalized_coordinates(c, configuration) for c in _choices(problem, choice)]
    checks = [
        *check_reality(configuration),
        *check_integrability(classification),
        *check_finite_forms(classification, problem.slots, configuration.surface),
        *check_displacements(configuration, elimination, carried),
        *check_hidden(classification, elimination, configuration),
    ]
    solution = Solution(
        problem,
        classification,
        configuration,
        elimination,
        carried,
        normals=() if Find.MOTION in problem.find else normals(configuration),
        choices=tuple(ChoiceSolution(c) for c in chosen),
        checks=(*checks, *_substitutions(chosen)),
    )
    if Find.EQUILIBRIUM in problem.find:
        from lagrange.mechanics.equilibrium.statics import check_statics

        check_statics(problem, configuration)
    if Find.MOTION in problem.find:
        solution = _with_motion(solution, complete, method)
    if problem.speeds:
        solution = _with_speeds(solution)
    if Find.LINEARIZATION in problem.find:
        solution = _with_linearization(solution)
    return _with_equilibrium(solution) if Find.EQUILIBRIUM in problem.find else solution


def _with_linearization(solution: Solution) -> Solution:
    """The solution with small oscillations, in every choice without square roots, else in the file's coordinates."""
    from lagrange.mechanics.equilibrium.linearization import linearization
    from lagrange.mechanics.equilibrium.linearization_checks import check_linearization

    problem = solution.problem
    taken = frozenset({*problem.scope.names(), *(q.name for c in problem.choices for q in c.coordinates)})
    checks = [*solution.checks]
    choices = []
    for c in solution.choices:
        if c.dynamics is not None and not c.coordinates.signs:
            found = linearization(c.dynamics.equations, taken)
            checks += check_linearization(found)
            c = replace(c, linearization=found)
        choices.append(c)
    here = None
    if solution.dynamics is not None and not any(s for c in choices if c.linearization for s in c.linearization.at):
        here = linearization(solution.dynamics.equations, taken)
        checks += check_linearization(here)
    return replace(solution, linearization=here, choices=tuple(choices), checks=tuple(checks))


def _with_equilibrium(solution: Solution) -> Solution:
    """The solution with the equilibria, in the file's coordinates and in every choice."""
    from lagrange.mechanics.equilibrium.equilibrium import equilibrium
    from lagrange.mechanics.equilibrium.stability import second_variation
    from lagrange.mechanics.equilibrium.static_reactions import static_reactions
    from lagrange.mechanics.equilibrium.statics import check_equilibrium, check_reactions_at_rest

    problem = solution.problem
    original = equilibrium(solution.configuration, solution.elimination, problem.unknowns)
    law = solution.law or (_law(solution, at_rest=True) if problem.constraints else None)
    works = solution.works or (
        works_of_reactions(law.newton, solution.configuration, solution.elimination) if law else ()
    )
    reactions = static_reactions(original, original, law.newton, law.used) if law else None
    checks = [*solution.checks, *check_equilibrium(original, original), *check_reactions_at_rest(reactions)]
    if solution.law is None:
        checks += check_workless(works, solution.configuration)
    choices = []
    for c in solution.choices:
        configuration = c.coordinates.configuration
        found = equilibrium(configuration, _elimination_in(c), problem.unknowns)
        there = static_reactions(found, original, law.newton, law.used) if law else None
        checks += [*check_equilibrium(found, original), *check_reactions_at_rest(there)]
        choices.append(replace(c, equilibrium=found, stability=second_variation(found), reactions_at_rest=there))
    return replace(
        solution,
        problem=law.problem if law else problem,
        law=law,
        works=tuple(works),
        reactions_at_rest=reactions,
        equilibrium=original,
        stability=second_variation(original),
        choices=tuple(choices),
        checks=tuple(checks),
    )


def small_displacements(solution: Solution) -> tuple[sp.Symbol, ...]:
    """The letters ξ of all linear equations."""
    found = [solution.linearization, *(c.linearization for c in solution.choices)]
    return tuple(dict.fromkeys(x for f in found if f is not None for x in f.displacements))


def letters_of_oscillations(solution: Solution) -> tuple[sp.Symbol, ...]:
    """The letters for frequencies, exponents and damping ratios."""
    found = [f for f in (solution.linearization, *(c.linearization for c in solution.choices)) if f is not None]
    names = {f"{f.omega}{i}" for f in found for i in ("", *(f"_{n}" for n in range(len(f.displacements) + 1)))}
    names |= {f.exponent.name for f in found} | ({"zeta"} if found else set())
    return tuple(sp.Symbol(n, real=True) for n in sorted(names))


def _law(solution: Solution, at_rest: bool = False, method: Method = Method.DALEMBERT) -> Law:
    """Newton's law in the file's coordinates."""
    rank = solution.classification.rank
    return law_of_motion(solution.problem, solution.configuration, solution.elimination, rank, at_rest, method)


def _elimination_in(c: ChoiceSolution) -> Elimination:
    """The dependent virtual displacements of a choice, those known through velocities first."""
    configuration = c.coordinates.configuration
    coordinates = configuration.slots.coordinates
    first = [coordinates.index(q) for q in c.coordinates.through_rates]
    return eliminate(configuration.rows, len(coordinates), configuration.states, first)


def _with_motion(solution: Solution, complete: bool, method: Method) -> Solution:
    """The solution with the equations of motion, in the file's coordinates and in every choice."""
    original = solution.configuration
    law = _law(solution, method=method)
    problem = law.problem
    reactions = law.newton.multipliers_by_name
    given = {p.symbol: p.value for p in problem.parameters if p.value is not None}
    check_constant_inertia(problem, original)
    works = works_of_reactions(law.newton, original, solution.elimination)
    elsewhere = any(not c.coordinates.signs for c in solution.choices)
    with_reactions = complete or not elsewhere or len(law.used) < 2 or bool(law.frictions)
    dynamics = motion(law, original, solution.elimination, with_reactions)
    found = dynamics.equations
    check_inertia(found)
    if complete and not dynamics.accelerations:
        dynamics = replace(dynamics, solved=solved_accelerations(dynamics.matrices))
    multipliers = tuple(reactions.values())
    checks = [*solution.checks, *check_workless(works, original), *check_motion(found, reactions, method)]
    checks += check_reactions(found.configuration, multipliers, dynamics.reactions, method)
    frictions = {f.name for f in law.frictions}
    kept = conserved(dynamics, reactions, frictions) if complete or not solution.choices else None
    checks += check_conserved(kept) if kept else []
    choices = []
    for c in solution.choices:
        configuration = c.coordinates.configuration
        elimination = _elimination_in(c)
        there = motion(law, configuration, elimination)
        there = there.closed(c.coordinates.through_rates)
        if complete:
            there = replace(there, solved=solved_accelerations(there.matrices))
        checks += check_displacements(configuration, elimination)
        checks += check_motion(there.equations, reactions, method)
        checks.append(check_choice(found, there.equations))
        checks += check_reactions(found.configuration, multipliers, there.reactions, method)
        spot = spot_value(System(there.equations.configuration, there.equations.expressions), given)
        integrals = conserved(there, reactions, frictions) if complete or _is_short(c, solution.choices) else None
        checks += check_conserved(integrals) if integrals else []
        choices.append(replace(c, dynamics=there, spot=spot, conserved=integrals))
    spot = spot_value(System(found.configuration, found.expressions), given)
    return replace(
        solution,
        problem=problem,
        configuration=dynamics.shown,
        law=law,
        works=tuple(works),
        dynamics=dynamics,
        spot=spot,
        choices=tuple(choices),
        checks=tuple(checks),
        conserved=kept,
    )


def _with_speeds(solution: Solution) -> Solution:
    """The solution with the quasi-velocities: in every choice of coordinates, and in the file's own coordinates unless
    a choice rids these of geometric constraints.
    """
    from lagrange.mechanics.dynamics.quasi_verification import check_speeds, in_speeds

    problem = solution.problem
    checks = [*solution.checks]
    own = None
    if not (solution.choices and solution.configuration.finite_constraints):
        own = in_speeds(problem.speeds, solution.configuration, solution.motion)
        checks += check_speeds(own, problem)
    choices = []
    for c in solution.choices:
        there = in_speeds(problem.speeds, c.coordinates.configuration, c.motion)
        checks += check_speeds(there, problem)
        choices.append(replace(c, in_speeds=there))
    return replace(solution, in_speeds=own, choices=tuple(choices), checks=tuple(checks))


def _is_short(choice: ChoiceSolution, choices: Sequence[ChoiceSolution]) -> bool:
    """Whether a choice has no square roots, or all have."""
    return not choice.coordinates.signs or all(c.coordinates.signs for c in choices)


def _substitutions(chosen: list[GeneralizedCoordinates]) -> list[Check]:
    """What `generalized_coordinates` has verified, as checks."""
    found = []
    for c in chosen:
        if c.satisfied:
            listed = ", ".join(c.satisfied)
            found.append(Check(f"satisfied identically: {listed}", True, "exact, at random states", c.choice.name))
    return found


def _choices(problem: Problem, name: str | None) -> list[Choice]:
    if name is None:
        return list(problem.choices)
    found = [c for c in problem.choices if c.name == name]
    if not found:
        names = [c.name for c in problem.choices]
        help_ = suggestion(name, names, "choices")
        raise ProblemError(Diagnostic("no-such-choice", f"the problem has no choice `{name}`", help=help_))
    return found


def _refuse_what_is_not_covered(problem: Problem) -> None:
    bodies = {b.name for b in problem.bodies}
    for force in (f for f in problem.forces if isinstance(f, Friction)):
        if Find.EQUILIBRIUM in problem.find:
            what = f"equilibrium with dry friction, `{force.name}`, which at rest is any force up to a limit,"
            raise NotCoveredError(what, force.span)
        if Find.LINEARIZATION in problem.find:
            raise NotCoveredError(f"small oscillations with dry friction, `{force.name}`,", force.span)
        if Find.MOTION in problem.find and force.on in bodies:  # where it touches, nobody says
            raise NotCoveredError(f"friction on a rigid body, `{force.name}`,", force.span)
    if problem.equations:
        raise NotCoveredError("a reference system given by `equations`: it can only be checked against; solving it")
    if Find.LINEARIZATION in problem.find and problem.unknowns:
        raise NotCoveredError("small oscillations with unknown forces, which have no law,")
