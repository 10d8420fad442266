"""The steps of the full derivation, each in the shorter form that it has on the page.

What a step is on the page depends on the kind of the system: geometric constraints that are independent and free of
time need one step for all that is said of them; where laws hold for whole vectors, these take the place of components;
displacements are shown where they are used. `Shortening` asks once for what decides this.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
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
    Prose,
    Purpose,
    Rule,
    Step,
    Table,
    has_purpose,
    index_of,
    paragraph,
    prose,
)
from lagrange.explain.checks import in_one_line
from lagrange.explain.constraints import explain_classification
from lagrange.explain.displacements import explain_displacements
from lagrange.explain.limits import LONGEST_BEFORE, LONGEST_BESIDE_CHOICE
from lagrange.explain.newton import explain_works
from lagrange.explain.page.constraints import (
    explain_geometric,
    explain_short_displacements,
    explain_short_forms,
    explain_short_integrability,
    explain_without,
    in_chosen_coordinates,
    is_plainly_geometric,
    with_only_coordinate,
    without_component,
    without_division,
    without_solution,
)
from lagrange.explain.page.economy import (
    lagrangian_once,
    likewise_in_a_line,
    questions_shortly,
    remaining_shortly,
    together_shortly,
    without_momenta,
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
    work_by_forms,
)
from lagrange.explain.page.motion import (
    displacements_of_geometric,
    displacements_shortly,
    ends_with_speeds,
    principle_shortly,
    reaction_as_a_whole,
    with_conditions,
    with_displacements,
    with_kinematics,
    without_lecture,
    without_long_sum,
    without_multipliers,
)
from lagrange.explain.page.names import with_named_denominators
from lagrange.explain.page.shorter.constraints import explain_at_sight, integrates_at_sight
from lagrange.explain.page.shorter.reactions import by_projection, in_accelerations
from lagrange.explain.page.system import explain_independence, explain_measures, explain_system
from lagrange.explain.reactions import explain_reactions, title_of_reactions
from lagrange.explain.words import plural
from lagrange.mechanics.dynamics.equations import DalembertMotion
from lagrange.mechanics.dynamics.newton import Newton, works_of_reactions
from lagrange.mechanics.results import InCoordinates, Solution
from lagrange.mechanics.rewriting.constraint_forms import common_number, with_short_forms, without_common_number
from lagrange.mechanics.rewriting.factors import has_one_sign
from lagrange.mechanics.rewriting.readable_forms import are_same_formulas


class Shortening:
    """What decides how shortly the steps of one page are written.

    newton  Newton's law as the page has it: in tensions, without multipliers, where there is no friction
    own     the motion in the file's coordinates by d'Alembert's principle, as it is written out
    short   the constraints in short forms, where they are neither all geometric nor absent
    vectors whether laws for whole vectors take the place of components, and displacements are shown with their use
    """

    def __init__(self, solution: Solution) -> None:
        law, written = solution.law, None if solution.own.dynamics is None else solution.own.dynamics.written
        newton = law.newton if law is not None else None
        self.solution = solution
        self.newton = newton.in_tensions if newton is not None and law is not None and not law.all_frictions else newton
        self.own = written if isinstance(written, DalembertMotion) else None
        self.is_geometric = is_plainly_geometric(solution.classification)
        self.is_free = not solution.classification.constraints
        self.is_at_sight = not self.is_free and not self.is_geometric and integrates_at_sight(solution)
        self.short = None if self.is_geometric or self.is_free else with_short_forms(solution.classification)
        self.has_laws = has_vector_laws(solution)
        self.vectors = self.is_geometric and self.has_laws
        self.names = {*solution.problem.scope.names(), *solution.problem.scope.vectors}
        self._accelerations_known = False
        self._choices_with_equations: set[str] = set()

    def shortened(self, steps: Iterable[Step]) -> Iterator[Step]:
        """The steps one by one, each in the form of its rule; some disappear."""
        for step in steps:
            form = _FORMS.get(step.rule)
            yield from (step,) if form is None else form(self, step)

    @property
    def _in_one(self) -> bool:
        """Whether all that is said of the constraints is in one step."""
        return self.is_geometric or self.is_free or self.is_at_sight

    def _statement(self, step: Step) -> Iterator[Step]:
        system = explain_system(self.solution, step)
        yield without_momenta(system) if ends_with_speeds(self.solution) else system

    def _constraint(self, step: Step) -> Iterator[Step]:
        problem = self.solution.problem
        if self.is_at_sight:
            yield without_component(problem, explain_at_sight(self.solution))
        elif self.is_geometric:
            yield explain_geometric(self.solution.classification, problem.slots)
        elif not self.is_free:
            yield without_component(problem, step)

    def _pfaffian_form(self, step: Step) -> Iterator[Step]:
        if self._in_one:
            return
        if self.short is not None:
            step = explain_short_forms(self.short, self.solution.problem.slots)
        yield step if self.own is None else replace(step, body=tuple(b for b in step.body if not isinstance(b, Table)))

    def _integrability(self, step: Step) -> Iterator[Step]:
        if self._in_one:
            return
        if self.short is not None:
            step = in_chosen_coordinates(self.solution, explain_short_integrability(self.solution, self.short))
        yield with_only_coordinate(self.solution, _integrability_shortly(self.solution, step))

    def _classification(self, _step: Step) -> Iterator[Step]:
        if not self._in_one:
            yield explain_classification(self.solution.classification, self.names, excluded=False)

    def _degrees_of_freedom(self, step: Step) -> Iterator[Step]:
        if self.is_free:
            satisfied = self.solution.own.configuration.satisfies_constraints_itself
            yield explain_without(self.solution.classification, satisfied)
        elif not self._in_one:
            yield step

    def _displacements(self, step: Step) -> Iterator[Step]:
        solution = self.solution
        if self.short is not None and not step.choice and self.own is None:
            yield without_division(solution, displacements_shortly(explain_short_displacements(solution)))
        elif solution.impact is not None and self.own is None:
            return  # those in the position of the impact are all that it needs
        elif not self.vectors and not step.choice:
            of_forms = self.is_geometric or _are_same(solution) or self.short is not None
            made = displacements_shortly(_of_forms(solution, step) if of_forms else step)
            yield without_division(solution, without_solution(solution, made))
        elif not self.vectors:
            yield step

    def _reactions(self, step: Step) -> Iterator[Step]:
        if self.newton is None or self.newton.bodies is None:
            yield step
            return
        if self.has_laws:
            step = explain_laws(self.solution, self.newton)
        else:
            step = explain_laws_of_bodies(self.solution, along_named(self.solution, step))
        self._accelerations_known = self.own is not None
        yield step if self.own is None else with_kinematics(step, self.own)

    def _work(self, step: Step) -> Iterator[Step]:
        solution, own = self.solution, self.solution.own
        if self.newton is None or not self.has_laws:
            yield work_by_forms(solution, shares_shortly(solution, step))
        elif self.vectors:
            yield explain_work(solution, self.newton)
        else:
            works = works_of_reactions(self.newton, own.configuration, own.elimination)
            yield work_by_forms(solution, explain_works(works, own.configuration))

    def _conserved(self, step: Step) -> Iterator[Step]:
        yield in_forces(step, self.newton) if self.has_laws and self.newton is not None else step

    def _principle(self, step: Step) -> Iterator[Step]:
        accelerations = frozenset(self.solution.problem.slots.accelerations)
        yield principle_shortly(step, accelerations, known=self._accelerations_known)

    def _equations_of_motion(self, step: Step) -> Iterator[Step]:
        view = self.solution.view(step.choice)
        motion = None if view.dynamics is None else view.dynamics.written
        first = step.choice not in self._choices_with_equations
        self._choices_with_equations.add(step.choice)
        if first and motion is not None:
            step = with_conditions(step, motion)
        if self.newton is not None and self.newton.equations is not None:
            step = without_multipliers(step)
        if first and isinstance(motion, DalembertMotion):
            step = without_long_sum(step, motion)
            step = with_displacements(step, motion) if self.vectors and not step.choice else step
        yield step

    def _solved_reactions(self, step: Step) -> Iterator[Step]:
        if self.newton is None:
            yield step
            return
        view = self.solution.view(step.choice)
        for made in _reactions(self.solution, step, self.newton):
            named = with_named_denominators(contact_once(made), self.names)
            shorter = in_accelerations(self.solution, named, view)
            shorter = by_projection(shorter, view, self.newton) if shorter is named else shorter
            if any(isinstance(b, Display) for b in shorter.body):
                yield shorter

    def _energies(self, step: Step) -> Iterator[Step]:
        outright = self.solution.own.configuration.is_outright and not step.choice
        yield lagrangian_once(step) if outright else step

    def _response(self, step: Step) -> Iterator[Step]:
        yield with_named_denominators(step, {*self.solution.problem.scope.names()})

    def _generalized_coordinates(self, step: Step) -> Iterator[Step]:
        yield _with_measures(self.solution, step)

    def _lagrange(self, step: Step) -> Iterator[Step]:
        yield without_lecture(step)

    def _question(self, step: Step) -> Iterator[Step]:
        yield questions_shortly(self.solution, step)

    def _checks(self, step: Step) -> Iterator[Step]:
        yield in_one_line(step, self.solution)


_FORMS: Mapping[Rule, Callable[[Shortening, Step], Iterator[Step]]] = {
    Rule.STATEMENT: Shortening._statement,
    Rule.CONSTRAINT: Shortening._constraint,
    Rule.PFAFFIAN_FORM: Shortening._pfaffian_form,
    Rule.INTEGRABILITY: Shortening._integrability,
    Rule.CLASSIFICATION: Shortening._classification,
    Rule.DEGREES_OF_FREEDOM: Shortening._degrees_of_freedom,
    Rule.DISPLACEMENTS: Shortening._displacements,
    Rule.REACTIONS: Shortening._reactions,
    Rule.WORKLESS: Shortening._work,
    Rule.PRINCIPLE: Shortening._principle,
    Rule.LAGRANGE: Shortening._lagrange,
    Rule.ENERGIES: Shortening._energies,
    Rule.GENERALIZED_COORDINATES: Shortening._generalized_coordinates,
    Rule.EQUATIONS_OF_MOTION: Shortening._equations_of_motion,
    Rule.SOLVED_REACTIONS: Shortening._solved_reactions,
    Rule.CONSERVED: Shortening._conserved,
    Rule.RESPONSE: Shortening._response,
    Rule.QUESTION: Shortening._question,
    Rule.CHECKS: Shortening._checks,
}
"""How the page has the steps of a rule; those of the other rules are as in the full derivation."""


def _integrability_shortly(solution: Solution, step: Step) -> Step:
    shortly = (together_shortly(solution.classification, b) for b in step.body if b.detail < Detail.FULL)
    return replace(step, body=tuple(likewise_in_a_line([b for b in shortly if b != prose()])))


def is_detour(solution: Solution, step: Step) -> bool:
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
    view = solution.view(step.choice)
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
    shown = solution.own.motion is not None and not is_detour(
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
    return block.map(lambda e: _chain(e, sizes, rule))


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
