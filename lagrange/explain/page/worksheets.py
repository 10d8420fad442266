"""A worksheet and its solution, from the page: the statement, then one numbered part for each thing to be worked out.

The steps of the page are gathered in parts: what the constraints are, the forces, the principle and the equations of
motion in each set of coordinates, the reactions, what the result means, each question of the file. On the worksheet a
part says what to do and leaves room; the solution has the steps themselves under the same numbers. What the page folds
(other choices of coordinates) is in neither.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import groupby

from lagrange.core.records import record
from lagrange.document.derivation import (
    Block,
    Derivation,
    Detail,
    Display,
    Emphasis,
    Equation,
    EquationKind,
    Matrices,
    Part,
    Prose,
    Purpose,
    Rule,
    Step,
    Task,
    display,
    listed,
    math,
    prose,
)
from lagrange.explain.limits import LEAST_ROOM, LINES_OF_EQUATION, MOST_ROOM
from lagrange.explain.page.arrangement import ABOUT_CONSTRAINTS
from lagrange.explain.words import as_stated, constraints_called, plural, spoken
from lagrange.mechanics.results import InCoordinates, Solution
from lagrange.problem.model import Find, Problem, Question

_FORCES = (Rule.REACTIONS, Rule.WORKLESS)
_PRINCIPLE = (
    Rule.PRINCIPLE,
    Rule.ENERGIES,
    Rule.LAGRANGE,
    Rule.GENERALIZED_COORDINATES,
    Rule.EQUATIONS_OF_MOTION,
)
_NOT_ASKED = (Rule.RESULT, Rule.STATEMENT, Rule.CHECKS)


@record
class _Exercise:
    """One part: the steps of the page that answer it."""

    title: str
    task: tuple[Part, ...]
    steps: tuple[Step, ...]

    @property
    def room(self) -> int:
        """The lines that its answer takes, by that of the solution."""
        blocks = [b for s in self.steps for b in s.body]
        equations = sum(len(b.equations) for b in blocks if isinstance(b, Display))
        others = sum(isinstance(b, Prose | Matrices) for b in blocks)
        return min(max(LINES_OF_EQUATION * equations + others, LEAST_ROOM), MOST_ROOM)


def worksheet(solution: Solution, derivation: Derivation) -> Derivation:
    """The statement with its figure, and the parts with room for each."""
    [statement] = [s for s in derivation.at(Detail.STEPS) if s.rule is Rule.STATEMENT]
    body = (*_without_labels(statement.body), *given_constraints(solution.problem))
    steps = [replace(statement, title="", body=body)]
    for e in _exercises(solution, derivation):
        steps.append(Step(e.steps[0].rule, e.title, (Task(e.task, e.room),)))
    return replace(derivation, page=tuple(steps))


def worked_solution(solution: Solution, derivation: Derivation) -> Derivation:
    """The solution, with the numbers of the worksheet."""
    steps = []
    for e in _exercises(solution, derivation):
        body: list[Block] = []
        for step in e.steps:
            if len(e.steps) > 1 and step.title:
                body.append(prose(Emphasis(f"{step.title}."), detail=Detail.BRIEF))
            body += step.body
        steps.append(Step(e.steps[0].rule, e.title, tuple(body)))
    return replace(derivation, title=f"{derivation.title}: solution", page=tuple(steps))


def given_constraints(problem: Problem) -> tuple[Block, ...]:
    """The constraints as the file gives them."""
    if not problem.constraints:
        return ()
    given = [(c.given or c, c) for c in problem.constraints]
    lines = dict.fromkeys(
        Equation((g.lhs, g.rhs), None, c.relation, (f"({spoken(c.name.partition('.')[0] if c.given else c.name)})",))
        for g, c in given
    )
    return prose(plural(len(lines), "The constraint is", "The constraints are")), display(*lines)


def _without_labels(body: Iterable[Block]) -> Iterator[Block]:
    """Blocks whose equations have no numbers: those of the solution begin at 1."""
    for block in body:
        if isinstance(block, Display):
            block = replace(block, equations=tuple(replace(e, label=None) for e in block.equations))
        yield block


def _exercises(solution: Solution, derivation: Derivation) -> Iterator[_Exercise]:
    asked = [
        replace(s, body=body)
        for s in derivation.at(Detail.STEPS)
        if s.rule not in _NOT_ASKED and not s.folded and (body := tuple(b for b in s.body if b.detail <= Detail.STEPS))
    ]
    bound = bool(solution.problem.constraints)
    for _, together in groupby(asked, key=lambda step: _part(step, bound)):
        steps = tuple(together)
        title, task = _task(solution, steps)
        if task:
            yield _Exercise(title, task, steps)


def _part(step: Step, bound: bool) -> tuple[str, str]:
    """What is the same for the steps of one part; `bound` by constraints."""
    if step.rule in ABOUT_CONSTRAINTS or (step.rule is Rule.DISPLACEMENTS and not bound):
        return "constraints", ""
    if step.rule in _FORCES:
        return "forces", ""
    if step.rule in _PRINCIPLE:
        return "principle", step.choice
    return step.rule.value, step.choice + step.title * (step.rule is Rule.QUESTION)


def _task(solution: Solution, steps: Sequence[Step]) -> tuple[str, tuple[Part, ...]]:
    """The title of a part and what is to be done in it, nothing where only the solution has something to say.

    A rule that has no words here is asked for by its title.
    """
    rules = {s.rule for s in steps}
    view = solution.view(steps[0].choice)
    if rules & {*ABOUT_CONSTRAINTS}:
        return _about_constraints(solution, rules)
    if rules & {*_FORCES}:
        return _about_forces(solution, rules)
    if rules & {*_PRINCIPLE}:
        return _about_motion(view, rules)
    [rule] = rules
    if rule is Rule.QUESTION:
        return _about_question(solution.problem.questions, steps[0])
    if rule is Rule.MEANING:
        return "What it says", _about_meaning(steps[0])
    if rule in _TASKS:
        title, task = _TASKS[rule]
        return title, task(solution, view)
    return steps[0].title, (f"{steps[0].title}: work it out.",)


def _about_constraints(solution: Solution, rules: set[Rule]) -> tuple[str, tuple[Part, ...]]:
    number = len(solution.problem.constraints)
    if not number:
        return "Degrees of freedom", (
            "How many degrees of freedom has the system? What are its virtual displacements?",
        )
    words = [
        plural(number, "Is the constraint", "Is each constraint") + " geometric or kinematic? ",
        plural(number, "Write it as a condition", "Write them as conditions"),
        " on the differentials of the coordinates. ",
    ]
    if Rule.INTEGRABILITY in rules or any(c.kinematic for c in solution.problem.constraints):
        words.append(plural(number, "Can it be integrated? ", "Can they be integrated, one by one and together? "))
    words.append("Is the system holonomic? Is it scleronomic? How many degrees of freedom does it have?")
    title = plural(number, "The constraint and the degrees of freedom", "The constraints and the degrees of freedom")
    return title, ("".join(words),)


def _about_forces(solution: Solution, rules: set[Rule]) -> tuple[str, tuple[Part, ...]]:
    words = ""
    if Rule.REACTIONS in rules:
        bodies = len(solution.problem.masses)
        free = plural(bodies, "Draw the free body", "Draw the free bodies")
        law = "the conditions of rest" if solution.own.dynamics is None else "Newton's law"
        words = f"{free} with all forces, reactions among them, and write down {law}. "
        words += "How many unknowns and how many equations are there? "
    if Rule.WORKLESS in rules:
        words += "How much work do the reactions do in a virtual displacement?"
    return "Forces and reactions", (words.strip(),)


def _about_motion(view: InCoordinates, rules: set[Rule]) -> tuple[str, tuple[Part, ...]]:
    coordinates = [math(q) for q in view.configuration.slots.coordinates]
    several = len(coordinates) > 1
    named: list[Part] = [plural(len(coordinates), "the coordinate ", "the coordinates "), *listed(coordinates)]
    ending = "s" if view.motion is not None and len(view.motion.final) > 1 else ""
    words: list[Part] = []
    if not view.is_own:
        words += ["Take ", *listed(coordinates), " as generalized coordinate", "s" * several]
        replaced = [math(q, e) for q, e in view.configuration.expressed.items()]
        words += [", with ", *listed(replaced), ". "] if replaced and not view.signs else [". "]
    by_lagrange = bool(rules & {Rule.ENERGIES, Rule.LAGRANGE})
    if Rule.EQUATIONS_OF_MOTION not in rules and view.motion is None:
        return "Generalized coordinates", tuple(words)
    if by_lagrange:
        words += ["Find the kinetic energy, the potential energy or the generalized forces, and from them "
                  "by Lagrange's equations the equation", ending, " of motion in ", *named, "."]  # fmt: skip
    elif Rule.PRINCIPLE in rules and Rule.EQUATIONS_OF_MOTION not in rules:
        words += ["State d'Alembert's principle for the system."]
        return "D'Alembert's principle", tuple(words)
    elif Rule.PRINCIPLE in rules:
        words += ["State d'Alembert's principle for the system, and derive from it the equation", ending,
                  " of motion in ", *named, "."]  # fmt: skip
    else:
        words += ["Derive the equation", ending, " of motion."]
    title = "Equations of motion" if ending else "Equation of motion"
    if Rule.GENERALIZED_COORDINATES in rules or not view.is_own:
        title = plural(len(coordinates), "Generalized coordinate", "Generalized coordinates")
    elif by_lagrange:
        title = "Lagrange's equations"
    elif Rule.PRINCIPLE in rules:
        title = f"D'Alembert's principle and the equation{ending} of motion"
    return title, tuple(words)


def _about_question(questions: Sequence[Question], step: Step) -> tuple[str, tuple[Part, ...]]:
    for q in questions:
        if step.about == q.name:
            by: tuple[Part, ...] = () if q.by is None else (" as a function of ", math(q.by))
            when = (" when ", *listed(map(as_stated, q.when))) if q.when else ()
            return step.title, ("Find ", math(q.quantity), *by, *when, ".")
    return step.title, ("Integrate the equations of motion from the initial state as far as you can.",)


_OF_MEANING = {
    Purpose.AT_REST: "Where can the system stay at rest, and is it stable there?",
    Purpose.SMALL_MOTION: "How long is the period of small oscillations?",
    Purpose.LIMIT: "Check a limit in which the result is plain.",
    Purpose.UNITS: "Check the units.",
}
"""What is asked where there is a paragraph of that purpose."""


def _about_meaning(step: Step) -> tuple[Part, ...]:
    purposes = {b.purpose for b in step.body if isinstance(b, Prose)}
    kinds = {e.kind for b in step.body if isinstance(b, Display) for e in b.equations}
    conserved = purposes & {Purpose.CONSERVED, Purpose.MOMENTUM} or EquationKind.CONSERVED in kinds
    sentences = ["Which quantities does the motion conserve?"] if conserved else []
    sentences += [sentence for purpose, sentence in _OF_MEANING.items() if purpose in purposes]
    return (" ".join(sentences),) if sentences else ()


def _equilibrium(solution: Solution, view: InCoordinates) -> tuple[Part, ...]:
    unknown = [math(u) for u in solution.problem.unknowns]
    sought: tuple[Part, ...] = ("find ", *listed(unknown)) if unknown else ("find the positions of equilibrium",)
    stable = ". Are they stable?" if view.stability is not None and not unknown else "."
    return ("Write down the principle of virtual work, and ", *sought, " by it", stable)


def _speeds(solution: Solution, _view: InCoordinates) -> tuple[Part, ...]:
    defined = [math(s.symbol, s.definition) for s in solution.problem.speeds]
    return ("Write the equations of motion in the quasi-velocities ", *listed(defined), ".")


def _reactions(solution: Solution, _view: InCoordinates) -> tuple[Part, ...]:
    named = [c.name for c in solution.problem.constraints]
    moving = Find.MOTION in solution.problem.find
    depend = " in terms of position and velocity" if moving else ""
    return (f"Find the {plural(len(named), 'reaction', 'reactions')} of {constraints_called(named)}{depend}.",)


def _says(text: str) -> Callable[[Solution, InCoordinates], tuple[Part, ...]]:
    return lambda _solution, _view: (text,)


_TASKS: dict[Rule, tuple[str, Callable[[Solution, InCoordinates], tuple[Part, ...]]]] = {
    Rule.DISPLACEMENTS: (
        "Virtual displacements",
        _says("Which conditions do virtual displacements satisfy? Solve them for the dependent ones."),
    ),
    Rule.QUASI_VELOCITIES: ("Quasi-velocities", _speeds),
    Rule.LINEARIZATION: (
        "Small oscillations",
        _says("Linearize the equations of motion about equilibrium, and find the frequencies."),
    ),
    Rule.SOLVED_REACTIONS: ("The reactions", _reactions),
    Rule.CONSERVED: ("Conserved quantities", _says("Which quantities are conserved? Show it for one of them.")),
    Rule.STEADY: ("Steady motions", _says("Find the steady motions and their conditions. Are they stable?")),
    Rule.HAMILTON: (
        "Hamilton's equations",
        _says("Find the momenta, Hamilton's function and the canonical equations. Is Hamilton's function the energy?"),
    ),
    Rule.FRICTION_AT_REST: (
        "Friction at rest",
        _says("Under which conditions can the system stay at rest? Draw the forces at the limit."),
    ),
    Rule.EQUILIBRIUM: ("Virtual work and equilibrium", _equilibrium),
}
