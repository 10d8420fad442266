"""solve(): the stages in their order.

Classification of the constraints, displacements, choices of generalized coordinates; then, as the file asks, Newton's
law, the equations of motion with reactions and conserved quantities in each set of coordinates, quasi-velocities, small
oscillations, equilibria. The checks of a stage follow it. (The page has its own order: `explain/report.py`, `_steps`.)

Each stage is a function in a module of its own, and its result a field of `Solution` or, where it depends on the
coordinates, of `InCoordinates`. The file's own coordinates and each choice of generalized coordinates have one such
record, made by the same functions.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from lagrange.core.diagnostics import GaveUpError, NotCoveredError
from lagrange.core.effort import GivenUpError, allowed, reason
from lagrange.mechanics.constraints.classification import classify
from lagrange.mechanics.constraints.coordinates import GeneralizedCoordinates, generalized_coordinates, own_coordinates
from lagrange.mechanics.constraints.definedness import check_defined, explained_failures
from lagrange.mechanics.constraints.displacements import not_driven, transport_rates, virtual_displacements
from lagrange.mechanics.constraints.kinematics import file_configuration
from lagrange.mechanics.coverage import chosen_coordinates, refuse_what_is_not_covered
from lagrange.mechanics.dynamics.checks import (
    Check,
    check_choice,
    check_constant_inertia,
    check_displacements,
    check_finite_forms,
    check_hidden,
    check_integrability,
    check_motion,
    check_reactions,
    check_reality,
    check_substitutions,
    check_workless,
)
from lagrange.mechanics.dynamics.conservation import check_conserved, conserved
from lagrange.mechanics.dynamics.equations import check_inertia
from lagrange.mechanics.dynamics.motion import Method, NewtonLaw, law_of_motion, motion
from lagrange.mechanics.dynamics.newton import normals, works_of_reactions
from lagrange.mechanics.dynamics.spot_values import spot_of_motion
from lagrange.mechanics.limits import UNITS_OF_SOLVING
from lagrange.mechanics.results import InCoordinates, Solution
from lagrange.problem.model import Belt, Find, Friction, Problem
from lagrange.problem.values import no_values, values_of

if TYPE_CHECKING:
    from lagrange.mechanics.dynamics.reactions import Reactions
    from lagrange.mechanics.equilibrium.equilibrium import Equilibrium
    from lagrange.mechanics.equilibrium.friction.rolling import Rolling


OnStage = Callable[[str], None]
"""Called with the name of each stage when it begins."""


def silent(_: str) -> None:
    """Announce nothing."""


def solve(
    problem: Problem,
    choice: str | None = None,
    *,
    complete: bool = True,
    method: Method = Method.DALEMBERT,
    on_stage: OnStage = silent,
) -> Solution:
    """Solve a problem; with `choice`, in that choice of generalized coordinates only.

    method    by which the equations of motion are derived; statics always uses the principle of virtual work
    complete  include long results that are not shown by default: several reactions, and conserved quantities, in
              dependent coordinates, if a choice has them
    on_stage  called with the name of each stage when it begins

    A stage that takes more work than is allowed (`UNITS_OF_SOLVING`) is given up, and so are those after it.

    Raises ProblemError if the problem contradicts itself, UndecidedError or NotCoveredError if it cannot be solved,
    GaveUpError if not even its constraints can be classified with the work allowed.
    """
    with explained_failures(problem), allowed(UNITS_OF_SOLVING):
        return _solved(problem, choice, complete, method, on_stage)


def kinematics_and_law(problem: Problem) -> Solution:
    """Kinematics and, if motion is asked for, Newton's law: all that a figure needs (sheets of figures, and tests)."""
    solution = _kinematics(problem, None, silent)
    if Find.MOTION not in problem.find:
        return solution
    law = _law(solution)
    return replace(solution, problem=law.problem, law=law)


def _solved(problem: Problem, choice: str | None, complete: bool, method: Method, on_stage: OnStage) -> Solution:
    refuse_what_is_not_covered(problem)
    if problem.lagrangian is not None:
        method = Method.LAGRANGE  # there are no masses and forces for d'Alembert's principle
    asks_of_motion = problem.questions and problem.impact is None and not _asks_at_rest(problem)
    needs_motion = {Find.LINEARIZATION, Find.RESPONSE, Find.HAMILTONIAN, Find.STEADY} & {
        *problem.find
    } or asks_of_motion
    if needs_motion and Find.MOTION not in problem.find:
        problem = replace(problem, find=(Find.MOTION, *problem.find))
    running = ""

    def begin(stage: str) -> None:
        nonlocal running
        running = stage
        on_stage(stage)

    try:
        solution = blank = _kinematics(problem, choice, begin)
    except (GivenUpError, MemoryError) as stop:
        raise GaveUpError(f"{running}, {reason(stop)}") from None
    if blank.own.elimination.is_closed:
        stages = _stages(problem, blank, complete, method, begin)
    else:
        from lagrange.mechanics.large_systems import stages_of_large

        stages = stages_of_large(problem, begin)
    try:
        for stage in stages:
            solution = stage(solution)
    except (GivenUpError, MemoryError) as stop:
        return replace(solution, given_up=f"{running}, {reason(stop)}")
    return solution


def _asks_at_rest(problem: Problem) -> bool:
    """Whether the questions of a file are about a system at rest."""
    if Find.MOTION in problem.find or not {Find.EQUILIBRIUM, Find.IMPENDING} & {*problem.find} or not problem.questions:
        return False
    from lagrange.mechanics.questions.at_rest import are_about_rest

    return are_about_rest(problem)


def _stages(
    problem: Problem, blank: Solution, complete: bool, method: Method, on_stage: OnStage
) -> Iterator[Callable[[Solution], Solution]]:
    """The stages after the constraints, as the file asks for them. blank: the solution before them."""
    rough = any(isinstance(f, Friction | Belt) for f in problem.forces)
    rough = rough and not _only_rolls(problem, blank)
    if {Find.EQUILIBRIUM, Find.IMPENDING} & {*problem.find}:
        from lagrange.mechanics.equilibrium.checks import require_statics

        require_statics(problem, blank.own.configuration)
    if Find.MOTION in problem.find:
        yield lambda s: _with_motion(s, complete, method, on_stage)
    if problem.speeds:
        yield lambda s: _with_speeds(s, on_stage)
    if Find.RESPONSE in problem.find:
        yield lambda s: _with_response(s, on_stage)
    elif Find.LINEARIZATION in problem.find:
        yield lambda s: _with_linearization(s, on_stage)
    if {Find.HAMILTONIAN, Find.STEADY} & {*problem.find}:
        yield lambda s: _with_momenta(s, on_stage)
    if Find.IMPACT in problem.find:
        yield lambda s: _with_impact(s, on_stage)
    if Find.EQUILIBRIUM in problem.find and not rough:
        yield lambda s: _with_equilibrium(s, on_stage)
    if rough and {Find.EQUILIBRIUM, Find.IMPENDING} & {*problem.find}:
        yield lambda s: _with_rest(s, blank, on_stage)
    if problem.questions and _asks_at_rest(problem):
        yield lambda s: _with_questions_at_rest(s, on_stage)
    elif (problem.questions and problem.impact is None) or (problem.initial and Find.MOTION in problem.find):
        yield lambda s: _with_questions(s, on_stage)
    yield _with_numbers


def _kinematics(problem: Problem, choice: str | None, on_stage: OnStage) -> Solution:
    """The constraints, the displacements that they allow, and the choices of generalized coordinates."""
    on_stage("classifying the constraints")
    classification = classify(problem)
    check_defined(problem, classification.constrained)
    configuration = file_configuration(problem, classification.constrained)
    on_stage("displacements")
    own = _in_coordinates(problem, own_coordinates(configuration))
    rates = transport_rates(configuration.constrained, own.elimination)
    on_stage("choices of coordinates")
    choices = tuple(
        _in_coordinates(problem, generalized_coordinates(c, configuration)) for c in chosen_coordinates(problem, choice)
    )
    on_stage("checks")
    checks = [
        *check_reality(configuration),
        *check_integrability(classification),
        *check_finite_forms(classification),
        *check_displacements(configuration, own.elimination, rates),
        *check_hidden(classification, own.elimination, configuration),
        *check_substitutions([c.coordinates for c in choices]),
    ]
    return Solution(
        problem,
        classification,
        own,
        choices,
        rates,
        normals=() if Find.MOTION in problem.find else normals(configuration),
        checks=tuple(checks),
    )


def _in_coordinates(problem: Problem, chosen: GeneralizedCoordinates) -> InCoordinates:
    """Coordinates with their virtual displacements, those known through velocities solved for first."""
    constrained = chosen.configuration.constrained
    first = [constrained.slots.coordinates.index(q) for q in chosen.through_rates] or not_driven(problem, constrained)
    return InCoordinates(chosen, chosen.configuration, virtual_displacements(constrained, first))


def _stage(name: str, view: InCoordinates) -> str:
    return name if view.is_own else f"{name}, choice {view.name}"


def _law(solution: Solution, at_rest: bool = False, method: Method = Method.DALEMBERT) -> NewtonLaw:
    """Newton's law in the file's coordinates."""
    own, rank = solution.own, solution.classification.rank
    return law_of_motion(solution.problem, own.configuration, own.elimination, rank, at_rest, method)


def _with_motion(solution: Solution, complete: bool, method: Method, on_stage: OnStage) -> Solution:
    """The solution with the equations of motion in every set of coordinates."""
    on_stage("Newton's law")
    law, configuration = _law(solution, method=method), solution.own.configuration
    check_constant_inertia(law.problem, configuration)
    works = tuple(works_of_reactions(law.newton, configuration, solution.own.elimination))
    checks = [*solution.checks, *check_workless(works, configuration)]
    moving: list[InCoordinates] = []
    for view in solution.views:
        on_stage(_stage("equations of motion and reactions", view))
        view = _in_motion(view, solution, law, complete)
        on_stage(_stage("checks", view))
        checks += _checks_of_motion(view, moving[0] if moving else view, law)
        moving.append(view)
    moved = solution.with_views(moving, problem=law.problem, law=law, works=works, checks=tuple(checks))
    are_short = all(v.dynamics is None or v.dynamics.reactions is None or v.dynamics.reactions.complete for v in moving)
    moved = _with_spots(moved, every=complete or not are_short)
    if not are_short:
        from lagrange.mechanics.large_systems import with_long_reactions

        moved = with_long_reactions(moved)
    return moved


def _with_spots(solution: Solution, every: bool) -> Solution:
    """The solution with spot values: in every set of coordinates, or in that of the page only."""
    with_spot: dict[str, InCoordinates] = {}
    for view in solution.views_by_page:
        if view.dynamics is not None:
            with_spot[view.name] = view = replace(view, spot=spot_of_motion(view.dynamics, solution.problem))
        if view.spot is not None and not every:
            break
    return solution.with_views(with_spot.get(v.name, v) for v in solution.views)


def _in_motion(view: InCoordinates, solution: Solution, law: NewtonLaw, complete: bool) -> InCoordinates:
    """The motion in one set of coordinates, and what it conserves."""
    # Several reactions in dependent coordinates are long; a choice without square roots gives the same in fewer terms.
    left_to_choice = (
        view.is_own and len(law.used) > 1 and not law.frictions and any(not c.signs for c in solution.choices)
    )
    dynamics = motion(law, view.configuration, view.elimination, complete or not left_to_choice)
    dynamics = dynamics.closed(view.coordinates.through_rates)
    if view.is_own:
        check_inertia(dynamics.equations, solution.problem.bodies)
    dynamics = dynamics.with_accelerations() if complete else dynamics
    frictions = {f.name for f in law.frictions}
    is_shown = complete or _is_preferred(view, solution)
    return replace(
        view,
        configuration=dynamics.shown,
        dynamics=dynamics,
        conserved=conserved(dynamics, law.newton.multipliers_by_name, frictions) if is_shown else None,
        rolling=_rolling(law, dynamics.reactions, view) if law.rolling else None,
    )


def _rolling(law: NewtonLaw, reactions: Reactions | None, view: InCoordinates) -> Rolling | None:
    """The conditions under which what rolls does not slip."""
    from lagrange.mechanics.equilibrium.friction.rolling import rolling

    return rolling(law.problem, law, reactions, view.configuration)


def _only_rolls(problem: Problem, blank: Solution) -> bool:
    """Whether friction acts only where constraints keep what touches from slipping: then it does no work."""
    rubbing = [f for f in problem.forces if isinstance(f, Friction | Belt)]
    if not all(isinstance(f, Friction) and f.at is not None for f in rubbing) or [*problem.find] != [Find.EQUILIBRIUM]:
        return False
    from lagrange.mechanics.equilibrium.friction.rolling import nothing_slips

    return nothing_slips(_law(blank, at_rest=True))


def _checks_of_motion(view: InCoordinates, own: InCoordinates, law: NewtonLaw) -> list[Check]:
    """The equations of motion, reactions and conserved quantities in one set of coordinates, by second routes."""
    equations, original, reactions = view.motion, own.motion, law.newton.multipliers_by_name
    if view.dynamics is None or equations is None or original is None:
        return []
    checks = [] if view is own else check_displacements(view.configuration, view.elimination)
    checks += check_motion(equations, reactions, law.method)
    checks += [] if view is own else [check_choice(original, equations)]
    multipliers = tuple(reactions.values())
    checks += check_reactions(original.configuration, multipliers, view.dynamics.reactions, law.method)
    return [*checks, *(check_conserved(view.conserved) if view.conserved else [])]


def _is_preferred(view: InCoordinates, solution: Solution) -> bool:
    """Whether results are given in these coordinates by default.

    In the choices without square roots if there are any, otherwise in all choices; without choices, in the file's own
    coordinates.
    """
    if view.is_own:
        return not solution.choices
    return not view.signs or all(c.signs for c in solution.choices)


def _with_speeds(solution: Solution, on_stage: OnStage) -> Solution:
    """The solution with quasi-velocities: in every choice, and in the own coordinates unless a choice is free."""
    from lagrange.mechanics.dynamics.quasi_equations import check_speeds, in_speeds

    on_stage("equations in quasi-velocities")
    problem, own = solution.problem, solution.own
    checks = [*solution.checks]
    left_out = solution.choices and own.configuration.finite_constraints
    views = []
    for view in solution.views:
        if view is not own or not left_out:
            form = in_speeds(problem.speeds, view.configuration, view.motion)
            checks += check_speeds(form, problem)
            view = replace(view, in_speeds=form)
        views.append(view)
    return solution.with_views(views, checks=tuple(checks))


def _with_linearization(solution: Solution, on_stage: OnStage) -> Solution:
    """The solution with small oscillations, in every choice without square roots, else in the file's coordinates."""
    from lagrange.mechanics.equilibrium.checks import check_linearization
    from lagrange.mechanics.equilibrium.linearization import linearization
    from lagrange.mechanics.equilibrium.sampled_checks import check_oscillations

    on_stage("small oscillations")
    taken = _names(solution.problem)
    if _is_driven(solution):
        return _with_response(solution, on_stage)
    checks = [*solution.checks]

    def linearized(view: InCoordinates) -> InCoordinates:
        if view.motion is None or view.signs:
            return view
        equations = linearization(view.motion, taken)
        checks.extend((*check_linearization(equations), *check_oscillations(equations)))
        return replace(view, linearization=equations)

    choices = tuple(linearized(c) for c in solution.choices)
    is_solved_in_choice = any(at for c in choices if c.linearization for at in c.linearization.at)
    own = solution.own if is_solved_in_choice else linearized(solution.own)
    return replace(solution, own=own, choices=choices, checks=tuple(checks))


def _is_driven(solution: Solution) -> bool:
    """Whether harmonic or prescribed motions are left in the equations of motion of every set of coordinates."""
    from lagrange.mechanics.equilibrium.drives import harmonics
    from lagrange.mechanics.equilibrium.relative_equilibrium import is_time

    problem = solution.problem
    if not harmonics(problem) and not problem.slots.prescribed:
        return False
    motions = [v for v in solution.views if v.motion is not None and not v.signs]
    return all(
        any(is_time(s, v.configuration) for e in v.motion.expressions for s in e.free_symbols)
        for v in motions
        if v.motion is not None
    )


def _with_response(solution: Solution, on_stage: OnStage) -> Solution:
    """The solution with the forced linear equations in free coordinates and, for a harmonic drive, the steady state."""
    from lagrange.mechanics.equilibrium.drives import forced_systems
    from lagrange.mechanics.equilibrium.linearization import linearization
    from lagrange.mechanics.equilibrium.response import check_forced, check_response, forced_equations, response

    on_stage("forced oscillations")
    problem, taken = solution.problem, _names(solution.problem)
    systems = forced_systems(problem, Find.RESPONSE in problem.find)
    checks = [*solution.checks]
    at_rest, moved = (_kinematics(p, None, silent) for p in (systems.still, systems.moved))
    law = _law(at_rest, method=Method.LAGRANGE if problem.lagrangian is not None else Method.DALEMBERT)
    moving = {v.name: v for v in moved.views}
    resting = {v.name: v for v in at_rest.views}

    def forced(view: InCoordinates) -> InCoordinates:
        if view.configuration.rows or view.signs or view.coordinates.through_rates:
            return view
        still = resting[view.name]
        configuration = moving[view.name].configuration
        linear = linearization(law.equations(still.configuration, still.elimination), taken)
        equations = forced_equations(linear, configuration, systems.small)
        checks.extend(check_forced(equations, configuration, systems.small))
        steady = response(equations, systems.drive, taken) if systems.drive is not None else None
        checks.extend(check_response(steady) if steady is not None else ())
        return replace(view, forced=equations, response=steady)

    views = [*map(forced, solution.views)]
    if all(v.forced is None for v in views):
        raise NotCoveredError("forced oscillations without a choice of free coordinates")
    return solution.with_views(views, checks=tuple(checks))


def _with_momenta(solution: Solution, on_stage: OnStage) -> Solution:
    """The solution with Hamilton's function and steady motions, in every set of free coordinates without roots."""
    from lagrange.mechanics.momenta.hamiltonian import check_hamiltonian, hamiltonian
    from lagrange.mechanics.momenta.steady_motions import check_steady, steady_motions

    taken, find = _names(solution.problem), solution.problem.find
    checks = [*solution.checks]
    free = {v.name for v in solution.views if not v.configuration.rows and not v.signs} or {solution.views[-1].name}

    def in_momenta(view: InCoordinates) -> InCoordinates:
        equations = view.motion
        if equations is None or view.name not in free:
            return view
        if Find.HAMILTONIAN in find:
            on_stage(_stage("Hamilton's equations", view))
            view = replace(view, hamiltonian=hamiltonian(equations, taken))
            checks.extend(check_hamiltonian(view.hamiltonian) if view.hamiltonian else ())
        if Find.STEADY in find:
            on_stage(_stage("steady motions", view))
            view = replace(view, steady=steady_motions(equations, taken, solution.problem.radius))
            checks.extend(check_steady(view.steady) if view.steady else ())
        return view

    moved = solution.with_views(map(in_momenta, solution.views))
    return replace(moved, checks=tuple(checks))


def _with_impact(solution: Solution, on_stage: OnStage) -> Solution:
    """The solution with the velocities after the impact of the file, the impulses, the answers to its questions."""
    from lagrange.mechanics.through_impact import with_impact

    on_stage("the impact")
    return with_impact(
        solution, _names(solution.problem), lambda p: _solved(p, None, False, Method.DALEMBERT, on_stage)
    )


def _names(problem: Problem) -> frozenset[str]:
    """The names that a problem uses, for letters of results that must differ from them."""
    return frozenset({*problem.scope.names(), *(q.name for c in problem.choices for q in c.coordinates)})


def _with_equilibrium(solution: Solution, on_stage: OnStage) -> Solution:
    """The solution with the equilibria in every set of coordinates."""
    from lagrange.mechanics.equilibrium.checks import check_equilibrium, check_reactions_at_rest
    from lagrange.mechanics.equilibrium.equilibrium import equilibrium, without_poles
    from lagrange.mechanics.equilibrium.friction.rolling import rolling_at_rest
    from lagrange.mechanics.equilibrium.linear_stability import stability_at_rest
    from lagrange.mechanics.equilibrium.searched.places import with_search
    from lagrange.mechanics.equilibrium.searched.valleys_in_numbers import check_minima
    from lagrange.mechanics.equilibrium.static_reactions import in_contact, static_reactions, with_spring_forces

    problem, own = solution.problem, solution.own
    on_stage("equilibria")
    original = with_spring_forces(with_search(equilibrium(own.configuration, own.elimination, problem.unknowns)))
    law = solution.law or (_law(solution, at_rest=True) if problem.constraints else None)
    works = solution.works or (works_of_reactions(law.newton, own.configuration, own.elimination) if law else ())
    checks, known = [*solution.checks], values_of(problem)
    views = []
    for view in solution.views:
        on_stage(_stage("equilibria", view))
        resting = original
        if view is not own:
            resting = without_poles(equilibrium(view.configuration, view.elimination, problem.unknowns), original)
            resting = with_spring_forces(with_search(resting))
        on_stage(_stage("reactions at rest", view))
        reactions = static_reactions(resting, original, law.newton, law.used) if law else None
        checks += [*check_equilibrium(resting, original), *check_reactions_at_rest(reactions)]
        if view is own and solution.law is None:
            checks += check_workless(works, own.configuration)
        on_stage(_stage("stability", view))
        resting = in_contact(resting, reactions, law, known)
        stability = stability_at_rest(resting)
        checks += check_minima(resting, stability)
        slip = rolling_at_rest(law, reactions) if law and law.rolling and not solution.law else view.rolling
        views.append(replace(view, equilibrium=resting, stability=stability, reactions_at_rest=reactions, rolling=slip))
    problem = law.problem if law else problem
    return solution.with_views(views, problem=problem, law=law, works=tuple(works), checks=tuple(checks))


def _with_numbers(solution: Solution) -> Solution:
    """The solution with the equilibria in numbers, where the problem has values."""
    values = values_of(solution.problem)
    unsolved = any(e is not None and not e.solution.solved for v in solution.views for e in _equilibria(v))
    if not unsolved and (values is None or all(not any(_equilibria(v)) for v in solution.views)):
        return solution
    values = values or no_values(solution.problem)
    from lagrange.mechanics.equilibrium.in_numbers import equilibria_in_numbers, oscillations_in_numbers
    from lagrange.mechanics.equilibrium.searched.reactions_found import with_reactions

    def in_numbers(view: InCoordinates) -> InCoordinates:
        numbers = None
        if view.linearization is not None:
            numbers = oscillations_in_numbers(view.linearization, values, view.equilibrium, view.stability)
        elif view.equilibrium is not None:
            numbers = equilibria_in_numbers(view.equilibrium, view.stability, values)
        resting = solution.own.equilibrium
        return replace(view, in_numbers=with_reactions(numbers, view.configuration, resting, solution.law, values))

    return replace(solution, own=in_numbers(solution.own), choices=tuple(map(in_numbers, solution.choices)))


def _equilibria(view: InCoordinates) -> tuple[Equilibrium | None, ...]:
    """The equilibria of a view, in statics and in motion."""
    return view.equilibrium, view.linearization.equilibrium if view.linearization is not None else None


def _with_questions(solution: Solution, on_stage: OnStage) -> Solution:
    """The solution with the answers to the questions of the file."""
    from lagrange.mechanics.questions.checks import check_questions
    from lagrange.mechanics.questions.questions import answers_to_questions
    from lagrange.mechanics.questions.states import MotionView

    on_stage("questions")
    law = solution.law
    if law is None:  # a reference system, which has an initial state and no motion of its own
        return solution
    frictions = {f.name for f in law.frictions}
    places = []
    for view in sorted(solution.views, key=lambda v: (v.is_own, bool(v.signs))):
        if view.dynamics is None:
            continue
        integrals = view.conserved or conserved(view.dynamics, law.newton.multipliers_by_name, frictions)
        dynamics = view.dynamics
        if dynamics.reactions is None and law.used:
            dynamics = motion(law, view.coordinates.configuration, view.elimination)
        places.append(MotionView(dynamics, integrals, law))
    configurations = [v.configuration for v in solution.views]
    if not solution.problem.questions:
        from lagrange.mechanics.questions.closed_motions import motion_from_start

        return replace(solution, from_start=motion_from_start(solution.problem, places, configurations))
    asked = answers_to_questions(solution.problem, places, configurations)
    return replace(solution, asked=asked, checks=(*solution.checks, *check_questions(asked, places)))


def _with_questions_at_rest(solution: Solution, on_stage: OnStage) -> Solution:
    """The solution with the answers to questions about positions of equilibrium."""
    from lagrange.mechanics.questions.at_rest import answers_at_rest, law_of_rest

    on_stage("questions")
    problem, own = solution.problem, solution.own
    newton = solution.law.newton if solution.law else None
    law = law_of_rest(problem, own.configuration, own.equilibrium, own.impending, newton)
    asked, checks = answers_at_rest(problem, law, newton, own.stability)
    return replace(solution, asked=asked, checks=(*solution.checks, *checks))


def _with_rest(solution: Solution, blank: Solution, on_stage: OnStage) -> Solution:
    """The solution with the conditions under which friction holds the system at rest, in each choice of coordinates
    without square roots, otherwise in the file's coordinates.

    blank  the solution before the motion was found, whose configurations have no kinetic friction
    """
    from lagrange.mechanics.equilibrium.checks import check_impending
    from lagrange.mechanics.equilibrium.equilibrium import virtual_work
    from lagrange.mechanics.equilibrium.friction.friction_at_rest import rest_within
    from lagrange.mechanics.equilibrium.friction.impending_motion import impending_motions

    problem, own = blank.problem, blank.own
    law = _law(blank, at_rest=True)
    works = solution.works or works_of_reactions(law.newton, own.configuration, own.elimination)
    checks = [*solution.checks] if solution.works else [*solution.checks, *check_workless(works, own.configuration)]
    work = virtual_work(own.configuration)
    in_choices = any(not c.signs for c in solution.choices)
    views, given_up = [], solution.given_up
    for view, before in zip(solution.views, blank.views, strict=True):
        if not (view.signs or (in_choices and view.is_own)):
            on_stage(_stage("friction at rest", view))
            if Find.IMPENDING in problem.find:  # first, as it takes less work
                file = (own.configuration, own.elimination, work)
                motions = impending_motions(problem, law.newton, file, before.configuration, before.elimination)
                checks += check_impending(motions)
                view = replace(view, impending=motions)
            if Find.EQUILIBRIUM in problem.find and not given_up:
                resting, given_up = rest_within(problem, law.newton, own.configuration, before.configuration, work)
                view = replace(view, at_rest=resting)
                if resting is not None and resting.verified is not None:
                    name = "the forces at rest satisfy Lagrange's equations"
                    checks.append(Check(name, resting.verified, "exact, by substitution", view.name))
        views.append(view)
    problem = law.problem if solution.law is None else solution.problem
    law = solution.law or law
    return solution.with_views(
        views, problem=problem, law=law, works=tuple(works), checks=tuple(checks), given_up=given_up
    )
