"""The page from the full derivation: which steps come first, are joined, or are folded.

The full derivation has a step for each idea, in the order of the chapter. On the page the result comes first. Geometric
constraints that are independent and free of time need no separate sections on form, exactness, classification and
freedom: they share one. Displacements appear where they are used, with the work of the reactions. Of several choices of
coordinates the first is shown; the others are folded. All other steps are those of the derivation.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.core.expression_size import count_operations
from lagrange.core.symbols import t
from lagrange.document.derivation import (
    Block,
    Detail,
    Display,
    Equation,
    Math,
    Part,
    Prose,
    Purpose,
    Rule,
    Step,
    Table,
    has_purpose,
    index_of,
    listed,
    math,
    paragraph,
    prose,
)
from lagrange.explain.checks import in_one_line
from lagrange.explain.consequences import explain_at_rest
from lagrange.explain.constraints import explain_classification
from lagrange.explain.displacements import explain_displacements
from lagrange.explain.limits import LONGEST_BEFORE, LONGEST_BESIDE_CHOICE
from lagrange.explain.newton import explain_works
from lagrange.explain.page import linked_particles
from lagrange.explain.page.constraints import (
    explain_geometric,
    explain_short_displacements,
    explain_short_forms,
    explain_short_integrability,
    explain_without,
    in_chosen_coordinates,
    is_plainly_geometric,
    on_nonlinear_constraint,
    with_only_coordinate,
    without_component,
    without_division,
    without_solution,
    without_test,
)
from lagrange.explain.page.economy import (
    freedom_in_one,
    in_one_name,
    in_pairs,
    lagrangian_once,
    likewise_in_a_line,
    questions_shortly,
    remaining_shortly,
    said_before,
    together_shortly,
    without_momenta,
    without_unused,
)
from lagrange.explain.page.laws import (
    along_named,
    contact_once,
    explain_laws,
    explain_laws_of_bodies,
    explain_work,
    has_vector_laws,
    in_forces,
    reaction_along_normal,
    shares_shortly,
    without_idle,
    work_by_forms,
)
from lagrange.explain.page.meaning import explain_meaning
from lagrange.explain.page.motion import (
    displacements_of_geometric,
    displacements_shortly,
    ends_with_speeds,
    in_one_step,
    in_speeds_only,
    principle_shortly,
    reaction_as_a_whole,
    short_in_speeds,
    with_conditions,
    with_displacements,
    with_kinematics,
    without_detour,
    without_lecture,
    without_long_sum,
    without_multipliers,
)
from lagrange.explain.page.names import with_named_denominators
from lagrange.explain.page.result import explain_result, rest_has_roots
from lagrange.explain.page.shorter.constraints import explain_at_sight, in_few_lines, integrates_at_sight, with_one_list
from lagrange.explain.page.shorter.held import put_in, with_held_values, with_values_put_in
from lagrange.explain.page.shorter.oscillations import in_one_box, response_shortly
from lagrange.explain.page.shorter.reactions import (
    counted_shortly,
    in_accelerations,
    in_directions,
    with_stated_forces,
    with_sums_along_axes,
)
from lagrange.explain.page.shorter.sentences import in_fewer_words, with_lengths, with_symbol_first
from lagrange.explain.page.statics import said_once, with_supports
from lagrange.explain.page.surfaces import in_vectors, on_surface, work_of_surface
from lagrange.explain.page.system import alike_about_all_axes, explain_independence, explain_measures, explain_system
from lagrange.explain.reactions import explain_reactions, title_of_reactions
from lagrange.explain.words import capital, plural, spoken
from lagrange.mechanics.dynamics.equations import DalembertMotion
from lagrange.mechanics.dynamics.newton import Newton, works_of_reactions
from lagrange.mechanics.meaning import meaning
from lagrange.mechanics.results import InCoordinates, Solution
from lagrange.mechanics.rewriting.constraint_forms import common_number, with_short_forms, without_common_number
from lagrange.mechanics.rewriting.factors import has_one_sign
from lagrange.mechanics.rewriting.held_coordinates import held_together
from lagrange.mechanics.rewriting.quasi_velocities import StatedEquations, in_names
from lagrange.mechanics.rewriting.readable_forms import are_same_formulas

_FOLLOWING = (Rule.EQUATIONS_OF_MOTION, Rule.EQUILIBRIUM)
"""What comes under one title with the coordinates in which it is."""
ABOUT_CONSTRAINTS = (
    Rule.CONSTRAINT,
    Rule.PFAFFIAN_FORM,
    Rule.INTEGRABILITY,
    Rule.CLASSIFICATION,
    Rule.DEGREES_OF_FREEDOM,
)


def steps_of_page(
    solution: Solution,
    steps: Iterable[Step],
    stated: StatedEquations = (),
    forces: StatedEquations = (),
    *,
    every_choice: bool = False,
) -> Iterator[Step]:
    """The steps of the page.

    steps         of the full derivation
    stated        the equations of motion in the form of the file's answers, if these are right
    forces        likewise the reactions
    every_choice  whether no choice of coordinates is folded
    """
    solution = _with_best_choice_first(solution)
    arranged = in_one_name(solution, _arranged(solution, steps, stated, forces, every_choice=every_choice))
    arranged = in_directions(solution, short_in_speeds(solution, arranged))
    arranged = with_held_values(solution, [*with_one_list([*arranged])])
    arranged = counted_shortly(solution, [*in_one_box([*in_few_lines([*arranged])])])
    arranged = with_lengths(solution, [*response_shortly(solution, [*with_symbol_first([*arranged])])])
    arranged = in_fewer_words([*arranged])
    yield from in_pairs([*without_unused(solution, [*said_before([*arranged])])])


def _with_best_choice_first(solution: Solution) -> Solution:
    """The solution with choices in closed form before those with square roots of either sign."""
    return replace(solution, choices=tuple(sorted(solution.choices, key=lambda c: bool(c.signs))))


def _arranged(
    solution: Solution, steps: Iterable[Step], stated: StatedEquations, forces: StatedEquations, *, every_choice: bool
) -> Iterator[Step]:
    """The steps in the order of the page, the result first, those last that are folded."""
    first = solution.choices[0].name if solution.choices and not rest_has_roots(solution) else ""
    surface, speeds = on_surface(solution), ends_with_speeds(solution)
    link = linked_particles.linked(solution)
    stated = in_names(solution, stated)
    named = in_names(solution, forces)
    shortened = with_supports(solution, said_once(solution, _shortened(solution, steps)))
    shortened = (alike_about_all_axes(solution, s) for s in shortened)
    about = (Rule.SOLVED_REACTIONS, Rule.CONSERVED, Rule.WORKLESS)
    shortened = (on_nonlinear_constraint(solution, s) if s.rule in about else s for s in shortened)
    if surface is not None:
        shortened, stated = in_vectors(surface, shortened), ()
    if link is not None:
        shortened, stated = linked_particles.in_vectors(link, shortened), ()
    if speeds:
        shortened = in_speeds_only(solution, shortened)
    open_, folded = [], []
    shortened = without_idle(solution, shortened)
    arranged = list(freedom_in_one(_without_bodies(solution, shortened)))
    if not every_choice:
        arranged = without_detour(solution, arranged, lambda step: _is_detour(solution, step))
    for step in _in_pairs(arranged):
        if every_choice or (step.choice in ("", first) and not _is_detour(solution, step)):
            open_.append(step)
        elif not step.choice:
            folded.append(replace(step, folded=(step.title,)))
        else:
            folded.append(replace(step, folded=_summary(solution, step.choice)))
    if not every_choice:
        open_, tested = without_test(solution, open_)
        folded += tested
        open_ = [*with_sums_along_axes(solution, with_stated_forces(solution, open_, named, stated))]
        open_ = [*with_values_put_in(solution, open_)]
    # Of the reaction of a surface the box would need the abbreviations of its step.
    solved = [s for s in open_ if surface is None or s.rule is not Rule.SOLVED_REACTIONS]
    work = () if surface is None or solution.law is None else work_of_surface(surface)
    yield from explain_result(solution, solved, stated, work if link is None else linked_particles.work_of_link(link))
    shown = open_ if every_choice else [*_conserved_once(open_, first)]
    for step in _with_meaning(solution, shown, stated):
        yield step if link is None or step.rule is not Rule.MEANING else linked_particles.meaning_of_link(link, step)
    yield from folded


def without_names_of_choices(steps: Iterable[Step]) -> Iterator[Step]:
    """The steps with plain titles, where those of one choice of coordinates are shown: they need no name."""
    steps = tuple(steps)
    shown = {s.choice for s in steps if s.choice and not s.folded}
    ending = f" (choice {spoken(next(iter(shown)))})" if len(shown) == 1 else None
    return (replace(s, title=s.title.removesuffix(ending)) if ending and not s.folded else s for s in steps)


def _in_pairs(steps: Iterable[Step]) -> Iterator[Step]:
    """The steps, with coordinates and the equations of motion, or the equilibrium, in them under one title."""
    waiting: Step | None = None
    for step in steps:
        follows = waiting is not None and step.rule in _FOLLOWING and step.choice == waiting.choice
        if waiting is not None and not follows:
            yield waiting
        if waiting is not None and follows:
            yield from in_one_step(waiting, step)
        elif step.rule is not Rule.GENERALIZED_COORDINATES:
            yield step
        waiting = step if step.rule is Rule.GENERALIZED_COORDINATES else None
    if waiting is not None:
        yield waiting


def _conserved_once(steps: Sequence[Step], first: str) -> Iterator[Step]:
    """The steps, without what is conserved in the file's coordinates where it follows in those of the first choice."""
    again = bool(first) and any(s.rule is Rule.CONSERVED and s.choice == first for s in steps)
    yield from (s for s in steps if not (again and s.rule is Rule.CONSERVED and not s.choice))


def _with_meaning(solution: Solution, steps: Sequence[Step], stated: StatedEquations) -> Iterator[Step]:
    """The steps, with what the result says before questions and checks, and the conserved quantities in it."""
    said = meaning(solution)
    if said is None:
        yield from _before_checks(steps, explain_at_rest(solution.chosen))
        return
    conserved = next((s for s in steps if s.rule is Rule.CONSERVED and s.choice == said.view.name), None)
    shown = {e.label for s in steps for b in s.body if isinstance(b, Display) for e in b.equations}
    at_sight = integrates_at_sight(solution)
    step = explain_meaning(said, conserved, stated, shown, solution.problem, finite=at_sight)
    step = step and put_in(held_together(solution), step)
    yield from _before_checks((s for s in steps if s is not conserved), step)


def _before_checks(steps: Iterable[Step], step: Step | None) -> Iterator[Step]:
    """The steps, with another before questions and checks."""
    for s in steps:
        if step is not None and s.rule in (Rule.QUESTION, Rule.CHECKS):
            yield step
            step = None
        yield s


def _is_detour(solution: Solution, step: Step) -> bool:
    """Whether equations in the file's coordinates are long or follow a second time, where better coordinates follow."""
    own, first = solution.own.motion, solution.choices[0] if solution.choices else None
    if step.rule is Rule.EQUATIONS_OF_MOTION and ends_with_speeds(solution):
        return True
    if step.choice or step.rule is not Rule.EQUATIONS_OF_MOTION or own is None or first is None or not first.motion:
        return False
    if integrates_at_sight(solution) and not first.configuration.rows:
        return True  # dependent coordinates are only in the way
    if own.expressions == first.motion.expressions:  # a choice of some of the coordinates, the others constant
        return True
    turning = bool(solution.own.configuration.rotations)  # what turns has long laws enough
    moving = {*solution.own.configuration.slots.coordinates, *first.configuration.slots.coordinates, t}
    if all(not e.free_symbols & moving for e in first.configuration.expressed.values()):
        return True  # the others are constant
    return turning or sum(count_operations(e) for e in own.expressions) > LONGEST_BESIDE_CHOICE


def _summary(solution: Solution, choice: str) -> tuple[Part, ...]:
    """`Other coordinate (choice depth): y`."""
    view = next(v for v in solution.choices if v.name == choice)
    coordinates = view.coordinates.choice.coordinates
    words = capital(plural(len(coordinates), "other coordinate", "other coordinates"))
    return (f"{words} (choice {spoken(choice)}): ", *listed(math(q) for q in coordinates))


def _shortened(solution: Solution, steps: Iterable[Step]) -> Iterator[Step]:
    """The steps one by one, shorter where the page says them shortly."""
    classification, law = solution.classification, solution.law
    geometric = is_plainly_geometric(classification)
    free = not classification.constraints
    at_sight = not free and not geometric and integrates_at_sight(solution)
    laws = has_vector_laws(solution)
    vectors = geometric and laws
    newton = law.newton if law is not None else None
    if newton is not None and law is not None and not law.all_frictions:
        newton = newton.in_tensions
    short = None if geometric or free else with_short_forms(classification)
    shown: set[str] = set()
    known = False
    written = None if solution.own.dynamics is None else solution.own.dynamics.written
    own = written if isinstance(written, DalembertMotion) else None
    for step in steps:
        if (geometric or free or at_sight) and step.rule in ABOUT_CONSTRAINTS:
            if at_sight and step.rule is Rule.CONSTRAINT:
                yield without_component(solution.problem, explain_at_sight(solution))
            elif geometric and step.rule is Rule.CONSTRAINT:
                yield explain_geometric(classification, solution.problem.slots)
            elif free and step.rule is Rule.DEGREES_OF_FREEDOM:
                yield explain_without(classification, solution.own.configuration.satisfies_constraints_itself)
        elif short is not None and step.rule is Rule.PFAFFIAN_FORM:
            made = explain_short_forms(short, solution.problem.slots)
            tabulated = (b for b in made.body if own is None or not isinstance(b, Table))
            yield replace(made, body=tuple(tabulated))
        elif short is not None and step.rule is Rule.INTEGRABILITY:
            made = in_chosen_coordinates(solution, explain_short_integrability(solution, short))
            yield with_only_coordinate(solution, _integrability_shortly(solution, made))
        elif short is not None and step.rule is Rule.DISPLACEMENTS and not step.choice and own is None:
            yield without_division(solution, displacements_shortly(explain_short_displacements(solution)))
        elif step.rule is Rule.CONSTRAINT:
            yield without_component(solution.problem, step)
        elif step.rule is Rule.CLASSIFICATION:
            names = {*solution.problem.scope.names(), *solution.problem.scope.vectors}
            yield explain_classification(classification, names, excluded=False)
        elif step.rule is Rule.STATEMENT:
            system = explain_system(solution, step)
            yield without_momenta(system) if ends_with_speeds(solution) else system
        elif step.rule is Rule.GENERALIZED_COORDINATES:
            yield _with_measures(solution, step)
        elif step.rule is Rule.LAGRANGE:
            yield without_lecture(step)
        elif step.rule is Rule.DISPLACEMENTS and solution.impact is not None and own is None:
            continue  # those in the position of the impact are all that it needs
        elif step.rule is Rule.DISPLACEMENTS and not vectors and not step.choice:
            made = _of_forms(solution, step) if geometric or _are_same(solution) or short is not None else step
            yield without_division(solution, without_solution(solution, displacements_shortly(made)))
        elif vectors and step.rule is Rule.DISPLACEMENTS:
            continue
        elif step.rule is Rule.REACTIONS and newton is not None and newton.bodies is not None:
            step = (
                explain_laws(solution, newton)
                if laws
                else explain_laws_of_bodies(solution, along_named(solution, step))
            )
            known = own is not None
            yield step if own is None else with_kinematics(step, own)
        elif vectors and step.rule is Rule.WORKLESS and newton is not None:
            yield explain_work(solution, newton)
        elif laws and step.rule is Rule.WORKLESS and newton is not None:
            own_ = solution.own
            works = works_of_reactions(newton, own_.configuration, own_.elimination)
            yield work_by_forms(solution, explain_works(works, own_.configuration))
        elif step.rule is Rule.WORKLESS:
            yield work_by_forms(solution, shares_shortly(solution, step))
        elif laws and step.rule is Rule.CONSERVED and newton is not None:
            yield in_forces(step, newton)
        elif step.rule is Rule.PFAFFIAN_FORM and own is not None:
            yield replace(step, body=tuple(b for b in step.body if not isinstance(b, Table)))
        elif step.rule is Rule.PRINCIPLE:
            yield principle_shortly(step, frozenset(solution.problem.slots.accelerations), known=known)
        elif step.rule is Rule.EQUATIONS_OF_MOTION:
            view = next(v for v in solution.views if v.name == step.choice)
            motion = None if view.dynamics is None else view.dynamics.written
            first = step.choice not in shown
            shown.add(step.choice)
            if first and motion is not None:
                step = with_conditions(step, motion)
            if newton is not None and newton.equations is not None:
                step = without_multipliers(step)
            if first and isinstance(motion, DalembertMotion):
                step = without_long_sum(step, motion)
                step = with_displacements(step, motion) if vectors and not step.choice else step
            yield step
        elif step.rule is Rule.SOLVED_REACTIONS and newton is not None:
            names = {*solution.problem.scope.names(), *solution.problem.scope.vectors}
            view = next(v for v in solution.views if v.name == step.choice)
            named = (with_named_denominators(contact_once(s), names) for s in _reactions(solution, step, newton))
            shorter = (in_accelerations(solution, s, view) for s in named)
            yield from (s for s in shorter if any(isinstance(b, Display) for b in s.body))
        elif step.rule is Rule.INTEGRABILITY:
            yield with_only_coordinate(solution, _integrability_shortly(solution, step))
        elif step.rule is Rule.ENERGIES and solution.own.configuration.is_outright and not step.choice:
            yield lagrangian_once(step)
        elif step.rule is Rule.RESPONSE:
            yield with_named_denominators(step, {*solution.problem.scope.names()})
        elif step.rule is Rule.QUESTION:
            yield questions_shortly(solution, step)
        elif step.rule is Rule.CHECKS:
            yield in_one_line(step, solution)
        else:
            yield step


def _integrability_shortly(solution: Solution, step: Step) -> Step:
    shortly = (together_shortly(solution.classification, b) for b in step.body if b.detail < Detail.FULL)
    return replace(step, body=tuple(likewise_in_a_line([b for b in shortly if b != prose()])))


def _without_bodies(solution: Solution, steps: Iterable[Step]) -> Iterator[Step]:
    """The steps, with what reactions are, where they are no forces on single bodies, beside their work."""
    waiting: Step | None = None
    for step in steps:
        if waiting is not None and step.rule is Rule.WORKLESS:
            step, waiting = replace(step, body=_joined(waiting.body, step.body)), None
        if waiting is not None:
            yield waiting
            waiting = None
        if step.rule is Rule.REACTIONS and solution.law is not None and solution.law.newton.bodies is None:
            waiting = step
        else:
            yield step
    if waiting is not None:
        yield waiting


def _joined(first: tuple[Block, ...], second: tuple[Block, ...]) -> tuple[Block, ...]:
    """Both, with the paragraphs at which they meet in one."""
    last, begin = first[-1:], second[:1]
    if last and begin and isinstance(last[0], Prose) and isinstance(begin[0], Prose):
        return (*first[:-1], paragraph(last[0], begin[0]), *second[1:])
    return (*first, *second)


def _with_measures(solution: Solution, step: Step) -> Step:
    """Generalized coordinates after what they are; at the end, that they are independent."""
    view = next(v for v in solution.choices if v.name == step.choice)
    step = remaining_shortly(step, view.configuration.slots)
    independent = explain_independence(solution, view)
    step = step if independent is None else replace(step, body=(*step.body, independent))
    measures = explain_measures(solution, view)
    first = step.body[0] if step.body else None
    if measures is None or not isinstance(first, Prose):
        return step
    noun = index_of(Purpose.NOUN, first.parts)
    chosen = view.configuration.slots.coordinates
    measured = {s for p in measures.parts if isinstance(p, Math) for s in p.sides}
    if noun is not None and {*chosen} <= measured:
        first = prose(f"With {plural(len(chosen), 'it', 'them')}", *first.parts[noun + 1 :])
    return replace(step, body=(paragraph(measures, first), *step.body[1:]))


def _are_same(solution: Solution) -> bool:
    """Whether possible and virtual displacements are the same, on a page that only uses them to derive a motion."""
    own = solution.own
    moving = {t, *solution.problem.slots.prescribed}
    rows = own.configuration.rows
    plain = all(r.nonlinear is None and r.drift == 0 for r in rows)
    timeless = not any(a.free_symbols & moving for r in rows for a in r.coefficients)
    derived = own.dynamics is not None or solution.impact is not None
    return bool(rows) and derived and plain and timeless and not solution.classification.redundancies


def _of_forms(solution: Solution, step: Step) -> Step:
    """Displacements of geometric constraints, from the forms without common factors; shortly before a law of motion."""
    own = solution.own
    rows = tuple(without_common_number(r) if r.finite is not None else r for r in own.configuration.rows)
    configuration = replace(own.configuration, constrained=replace(own.configuration.constrained, rows=rows))
    at_rest = own.equilibrium is not None or any(v.at_rest is not None for v in solution.views)
    derived = own.dynamics is not None or at_rest or solution.impact is not None
    if derived and not any(r.drift != 0 for r in rows):
        return displacements_of_geometric(configuration, own.elimination)
    normals = tuple(replace(n, gradient=n.gradient * (1 / common_number(n.row))) for n in solution.normals)
    made = explain_displacements(configuration, own.elimination, solution.transport_rates, normals)
    return replace(made, title=step.title)


def _reactions(solution: Solution, step: Step, newton: Newton) -> Iterator[Step]:
    """Tensions instead of multipliers; in the file's coordinates and those of the first choice at once."""
    view = next(v for v in solution.views if v.name == step.choice)
    if view.dynamics is None or view.dynamics.reactions is None or view.equilibrium is not None:
        yield step
        return
    if _needs_no_force(view, newton):
        normal = reaction_along_normal(solution)
        last = view is solution.chosen
        yield from [] if normal is None or not last else [normal]
        return
    first = solution.choices[0] if solution.choices else None
    follows = first is not None and first.dynamics is not None and first.dynamics.reactions is not None
    if view.is_own and follows:
        return  # they come with those of the choice
    own = solution.own.dynamics
    before = view is first or view.is_own
    whole = reaction_as_a_whole(solution)
    if whole is not None:
        yield whole
        return
    made = explain_reactions(view.dynamics, newton, step.choice, first=before, lost_ones=solution.long_reactions)
    if made is None:
        return
    made = replace(made, choice=step.choice, body=tuple(_without_certain_contact(made.body, newton, view)))
    shown = solution.own.motion is not None and not _is_detour(
        solution, replace(step, rule=Rule.EQUATIONS_OF_MOTION, choice="")
    )
    if view is first and shown and own is not None and own.reactions is not None:
        sizes = {
            r.force: own.reactions.sizes.get(r.name) if r.named else own.reactions.multipliers.get(r.name)
            for r in newton.reactions
        }
        rule = view.configuration.expressed
        body = tuple(_chained(b, sizes, rule) for b in made.body)
        made = replace(made, title=title_of_reactions(newton), body=body)
    yield made


def _needs_no_force(view: InCoordinates, newton: Newton) -> bool:
    """Whether no constraint exerts a force: one that only defines a coordinate, as an arc length, has λ = 0."""
    reactions = None if view.dynamics is None else view.dynamics.reactions
    multipliers = () if reactions is None else [reactions.multipliers.get(r.name) for r in newton.reactions]
    return bool(multipliers) and all(m == 0 for m in multipliers) and all(r.given is None for r in newton.reactions)


def _without_certain_contact(body: Iterable[Block], newton: Newton, view: InCoordinates) -> Iterator[Block]:
    """The blocks, without how long contact lasts where every normal force is known to keep its sign."""
    sizes = {} if view.dynamics is None or view.dynamics.reactions is None else view.dynamics.reactions.sizes
    normal = [sizes.get(r.name) for r in newton.reactions if r.is_normal and r.constraint.side is None]
    certain = bool(normal) and all(s is not None and has_one_sign(s) for s in normal)
    for block in body:
        if not certain or not has_purpose(block, Purpose.ONLY_PUSHES):
            yield block


def _chained(block: Block, sizes: Mapping[sp.Symbol, sp.Expr | None], rule: Mapping[sp.Symbol, sp.Expr]) -> Block:
    """T = (in the file's coordinates) = (in the chosen ones), on a page with the motion in both, if that is short."""
    if not isinstance(block, Display) or not block.boxed:
        return block
    return replace(block, equations=tuple(_chain(e, sizes, rule) for e in block.equations))


def _chain(
    equation: Equation, sizes: Mapping[sp.Symbol, sp.Expr | None], rule: Mapping[sp.Symbol, sp.Expr]
) -> Equation:
    before = sizes.get(equation.sides[0])
    last = equation.sides[-1]
    if before is None or count_operations(before) > LONGEST_BEFORE or not isinstance(last, sp.Expr) or before == last:
        return equation
    if are_same_formulas(before, last, dict(rule)):
        return equation
    return replace(equation, sides=(equation.sides[0], before, *equation.sides[1:]))
