"""The result at the head of the page: degrees of freedom and whatever the problem asks, each in a few lines.

Equations of motion, reactions, Hamilton's function, equilibria with their stability, rest with friction, steady
motions, frequencies of small oscillations, and answers to questions: in the coordinates that the page ends with, and
only as far as they are short.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.core.expression_size import count_operations
from lagrange.core.symbols import CONSTANT, DotProduct, VectorSymbol, prime
from lagrange.document.derivation import (
    Block,
    Detail,
    Display,
    Equation,
    EquationKind,
    Math,
    Part,
    Prose,
    Purpose,
    Rule,
    Step,
    display,
    has_purpose,
    listed,
    math,
    paragraph,
    prose,
)
from lagrange.explain.constraints import only_if
from lagrange.explain.limits import (
    LONGER_ACCELERATIONS,
    LONGEST_ACCELERATION,
    LONGEST_ANSWER,
    LONGEST_ANSWER_CONDITIONS,
    LONGEST_ASKED,
    LONGEST_BESIDE_REST,
    LONGEST_FREQUENCY,
    LONGEST_RADICAND,
    LONGEST_RESULT,
    MOST_RESULTS,
)
from lagrange.explain.page.meaning import are_solved, operations_of_equations
from lagrange.explain.page.names import with_named_denominators
from lagrange.explain.page.system import explain_independence
from lagrange.explain.words import as_stated, constraints_called, in_words, joined, plural, spoken, the
from lagrange.mechanics.energy_symbols import energy_symbols
from lagrange.mechanics.results import InCoordinates, Solution, values_in
from lagrange.mechanics.rewriting.constant_accelerations import constant_accelerations
from lagrange.mechanics.rewriting.held_coordinates import (
    given_rates,
    held_values,
    where_held,
    without_given_rates,
)
from lagrange.mechanics.rewriting.quasi_velocities import StatedEquations, by_one_velocity
from lagrange.mechanics.rewriting.readable_forms import are_same_equations, are_same_formulas
from lagrange.problem.values import no_values

if TYPE_CHECKING:
    from lagrange.mechanics.equilibrium.response import Response
    from lagrange.mechanics.questions.results import AnswerBranch, Asked
    from lagrange.values.quantities import Values


_CALLED = {
    Rule.EQUATIONS_OF_MOTION: "the motion",
    Rule.EQUILIBRIUM: "the equilibrium",
    Rule.FRICTION_AT_REST: "the conditions of rest",
    Rule.SOLVED_REACTIONS: "the reactions",
    Rule.WORKLESS: "its work",
    Rule.HAMILTON: "Hamilton's function",
    Rule.STEADY: "steady motions",
    Rule.LINEARIZATION: "small oscillations",
    Rule.RESPONSE: "the steady state",
    Rule.IMPACT: "the impact",
    Rule.QUESTION: "what is asked",
}
"""What the box may contain, in this order."""


def explain_result(
    solution: Solution, steps: list[Step], stated: StatedEquations = (), work: Sequence[Equation] = ()
) -> Iterator[Step]:
    """The results together, at the head; nothing if there are none.

    steps   of the page, without those that are folded
    stated  the equations of motion in another form, known to be right, for where they are shorter so
    work    of the reactions, where the page is about it
    """
    kept = dict(_from_steps(solution, steps, stated))
    kept[Rule.WORKLESS] = [*work]
    roots = rest_has_roots(solution)
    for view in (solution.own, *solution.choices[: 0 if roots else 1]):  # the last: in chosen coordinates, and shorter
        kept |= {rule: lines for rule, lines in _from_view(solution, view) if lines}
    if kept.get(Rule.EQUILIBRIUM):
        kept[Rule.EQUILIBRIUM] = _where_it_exists(kept[Rule.EQUILIBRIUM], steps)
    if roots and Rule.EQUILIBRIUM in kept:
        related = [Equation((c.lhs, c.rhs)) for c in solution.problem.constraints]
        kept[Rule.EQUILIBRIUM] = [*kept[Rule.EQUILIBRIUM], *related]
    kept[Rule.IMPACT] = [*_impact(solution)]
    kept[Rule.QUESTION] = [e for asked in solution.asked for e in _answers(solution, asked)]
    kept = {rule: kept[rule] for rule in _CALLED if kept.get(rule)}
    if Rule.LINEARIZATION in kept and _has_long_roots(kept.get(Rule.EQUATIONS_OF_MOTION, ())):
        kept.pop(Rule.EQUATIONS_OF_MOTION)
    _shorten(solution, kept)
    freedom = solution.classification.degrees_of_freedom
    if Rule.EQUILIBRIUM in kept and not _is_short(kept.values()):
        kept[Rule.EQUILIBRIUM] = _in_free_coordinates(solution.chosen, kept[Rule.EQUILIBRIUM])
    while kept and not _is_short(kept.values()):
        # What is asked stays to the last.
        others: list[Rule] = [rule for rule in kept if rule is not Rule.QUESTION] or [*kept]
        longest = max(others, key=lambda rule: (len(kept[rule]) > MOST_RESULTS, sum(e.operations for e in kept[rule])))
        held = freedom == 0 and Rule.EQUILIBRIUM in kept  # then the reactions are what is sought
        kept.pop(Rule.EQUILIBRIUM if held else Rule.SOLVED_REACTIONS if Rule.SOLVED_REACTIONS in kept else longest)
    words: list[Part] = [f"{in_words(freedom, 'degree').capitalize()} of freedom"]
    if any(v.cannot_rest for v in solution.views):
        words.append("; the system cannot be at rest")
        if not kept:
            yield Step(Rule.RESULT, "", (prose(*words, "."),))
            return
    if not kept:
        yield from _of_constraints(solution, steps)
        return
    names = [_called(rule, kept[rule], solution) for rule in kept if rule is not Rule.WORKLESS]
    if Rule.WORKLESS in kept:
        names += [*(["the reaction"] if Rule.SOLVED_REACTIONS not in kept else []), "its work"]
    called = listed(names)
    words += ["; ", *called, ":"]
    lines = [replace(e, label=None) for es in kept.values() for e in es]
    body: tuple[Block, ...] = (prose(*words), display(*lines, boxed=True, detail=Detail.BRIEF))
    step = Step(Rule.RESULT, "", body)
    yield with_named_denominators(step, {*solution.problem.scope.names()}) if Rule.RESPONSE in kept else step


def _where_it_exists(lines: list[Equation], steps: Iterable[Step]) -> list[Equation]:
    """The only equilibrium with the condition for its existence, as the page finds it from the forces of supports."""
    said = [b for s in steps for b in s.body if has_purpose(b, Purpose.EXISTS)]
    if len(lines) != 1 or len(said) != 1:
        return lines
    bounds = [p for p in said[0].parts if isinstance(p, Math)]
    after = lines[0].condition
    return [replace(lines[0], condition=("where ", *bounds, *(("; ", *after) if after else ())))]


def _in_free_coordinates(view: InCoordinates, lines: list[Equation]) -> list[Equation]:
    """The equilibria without the coordinates that the constraints give; all of it if a condition would be lost."""
    e = view.equilibrium
    free = {view.configuration.slots.coordinates[k] for k in e.elimination.independent} if e is not None else set()
    given = {*view.configuration.slots.coordinates} - free
    kept = [line for line in lines if line.sides[0] not in given]
    return kept if all(line in kept for line in lines if line.condition) else lines


def rest_has_roots(solution: Solution) -> bool:
    """Whether forces at rest are shorter in the file's own coordinates than with a root of either sign for one of them.

    P = Q (x − r cos θ)/(x sin θ) of a crank, with x² − 2r x cos θ + r² = l².
    """
    view, choice = solution.own, solution.choices[0] if solution.choices else None
    if choice is None or not choice.signs or view.equilibrium is None or choice.equilibrium is None:
        return False
    own, chosen = (
        sum(count_operations(r.rhs) for b in e.branches for r in b.equations)
        for e in (view.equilibrium, choice.equilibrium)
    )
    given = view.equilibrium.given and choice.equilibrium.given
    return given and len(view.equilibrium.branches) == 1 and 0 < own < chosen and len(solution.problem.constraints) == 1


def _has_long_roots(lines: Sequence[Equation]) -> bool:
    """Whether equations of motion contain long roots: the lengths of springs in large motions."""
    roots = {p for e in lines for s in e.sides if isinstance(s, sp.Expr) for p in s.atoms(sp.Pow) if p.exp.is_Rational}
    return any(p.exp.q == 2 and count_operations(p.base) > LONGEST_RADICAND for p in roots)


_MOTION = (EquationKind.MOTION, EquationKind.MOTION_IN_SPEEDS, EquationKind.COMPLETING)


def _shorten(solution: Solution, kept: dict[Rule, list[Equation]]) -> None:
    """Constant accelerations instead of equations for them; quantities asked for are stated once."""
    asked = [e.sides for e in kept.get(Rule.QUESTION, ())]
    view = solution.chosen
    equations = kept.get(Rule.EQUATIONS_OF_MOTION)
    freed = without_given_rates(view) if equations else None
    if freed is not None and all(e.kind in _MOTION for e in equations or ()):
        constraints = [e for e in equations or () if e.kind is EquationKind.COMPLETING]
        kept[Rule.EQUATIONS_OF_MOTION] = [Equation((e.expression, sp.S.Zero)) for e in freed.equations] + constraints
    held = held_values(view.configuration) | given_rates(view.configuration)
    for rule in (Rule.EQUATIONS_OF_MOTION, Rule.SOLVED_REACTIONS):
        kept[rule] = _where_held(kept.get(rule, []), held)
    equations = kept[Rule.EQUATIONS_OF_MOTION]
    if equations and view.motion is not None and view.motion.final:
        values = constant_accelerations(view)
        whole = len(values) == len(view.configuration.slots.accelerations)
        box = Step(Rule.RESULT, "", (display(*(Equation(pair) for pair in values.items()), boxed=True),))
        [block] = with_named_denominators(box, {*solution.problem.scope.names()}).body
        solved = [*block.equations] if isinstance(block, Display) else []
        through_rates = () if view.is_own else view.coordinates.through_rates  # the angle of a rolling wheel
        known = {*held, *(prime(q, 2) for q in through_rates)}
        unknown = [e for e in solved if e.sides[0] not in known] or solved
        longer = LONGER_ACCELERATIONS if len(equations) > solution.classification.degrees_of_freedom else 1
        short = sum(e.operations for e in solved) <= longer * sum(e.operations for e in equations)
        if whole and (short or all(e.operations <= LONGEST_ACCELERATION for e in unknown)):
            kept[Rule.EQUATIONS_OF_MOTION] = unknown
    for rule in (Rule.EQUATIONS_OF_MOTION, Rule.SOLVED_REACTIONS):
        others = [e for e in kept.get(rule, ()) if not any(_say_the_same(e.sides, a) for a in asked)]
        if rule is Rule.SOLVED_REACTIONS:  # T = ¼ m g in the state that is asked for, and not what is long in general
            others = [e for e in others if e.operations <= LONGEST_ANSWER or all(e.sides[0] != a[0] for a in asked)]
        if others:
            kept[rule] = others
        else:
            kept.pop(rule, None)


def _say_the_same(sides: Sequence[object], others: Sequence[object]) -> bool:
    """Whether two lines give one quantity the same value, in whatever form."""
    if sides == others:
        return True
    (left, *values), (same, *wanted) = sides, others
    if left != same or not isinstance(left, sp.Symbol) or not len(values) == len(wanted) == 1:
        return False
    [a], [b] = values, wanted
    return isinstance(a, sp.Expr) and isinstance(b, sp.Expr) and are_same_formulas(a, b, {})


def _where_held(lines: list[Equation], held: Mapping[sp.Symbol, sp.Expr]) -> list[Equation]:
    """The lines with constant coordinates substituted, r = R, and without that line itself.

    Where such a coordinate occurs in no other line, they are as they were.
    """
    substituted = []
    for e in lines:
        sides = tuple(where_held(s, held) if isinstance(s, sp.Expr) else s for s in e.sides)
        substituted.append(e if sides == e.sides else replace(e, sides=sides, condition=()))
    left = [e for e in substituted if len({*e.sides}) > 1]
    return left if any(e not in lines for e in left) else lines


def _of_constraints(solution: Solution, steps: Sequence[Step]) -> Iterator[Step]:
    """The result if only constraints are asked for: freedom, class, displacements on a surface, hidden relations."""
    classification = solution.classification
    if solution.own.motion is not None or not solution.problem.constraints or classification.degrees_of_freedom is None:
        return
    if classification.holonomic is None or classification.scleronomic is None:
        return
    free = [c.row.name for c in classification.constraints if c.integrable is False]
    kind = "holonomic" if classification.holonomic else "nonholonomic"
    unless = () if classification.scleronomic else only_if(classification)
    time = "scleronomic" if classification.scleronomic else "rheonomic"
    because = f", because of {constraints_called(free)}," if len(free) == 1 < len(classification.constraints) else ""
    words = (
        f"{in_words(classification.degrees_of_freedom, 'degree').capitalize()} of freedom; {kind}{because}"
        f"{',' if unless and not because else ''} and {time}"
    )
    functions = (*(f for _, f in classification.integrals), *(c.function for c in classification.combined[:1]))
    lines = [Equation((f, CONSTANT)) for f in functions if count_operations(f) <= LONGEST_ANSWER][:MOST_RESULTS]
    displays = (b for s in steps for b in s.body if isinstance(b, Display))
    solved = [e for b in displays for e in b.equations if e.kind is EquationKind.ONLY]
    lines = [replace(e, label=None) for e in solved] or lines
    vectors = [*_displacements(steps)]
    also = ""
    if vectors and not lines:
        same = "" if len(vectors) > 1 else " are the same"
        lines, also = vectors, f"; virtual and possible displacements{same}"
    described = _described(solution)
    if lines:
        after = [] if described is None else [described]
        yield Step(
            Rule.RESULT,
            "",
            (prose(words, *unless, f"{also}:"), display(*lines, boxed=True, detail=Detail.BRIEF), *after),
        )
        return
    sentence = prose(words, *unless, ".")
    yield Step(Rule.RESULT, "", (sentence if described is None else paragraph(sentence, described),))


def _displacements(steps: Sequence[Step]) -> Iterator[Equation]:
    """∇f·δr = 0 and dr = δr + u dt, where the page has them as vectors."""
    shown = [
        e for s in steps if s.rule is Rule.DISPLACEMENTS for b in s.body if isinstance(b, Display) for e in b.equations
    ]
    virtual = [e for e in shown if e.kind is EquationKind.VIRTUAL]
    if len(virtual) == 1 and isinstance(virtual[0].sides[0], DotProduct):
        moved = [e for e in shown if e.kind is EquationKind.POSSIBLE]
        yield from (replace(e, label=None) for e in (*virtual, *moved))


def _described(solution: Solution) -> Prose | None:
    """With which coordinates: those of the file and their relations, and independent ones."""
    view = solution.choices[0] if solution.choices else None
    if view is None or explain_independence(solution, view) is None:
        return None
    kind = "finite relation" if view.configuration.rows else "relation"
    own, chosen = (listed(map(math, slots.coordinates)) for slots in (solution.problem.slots, view.configuration.slots))
    related = in_words(len(view.coordinates.satisfied), kind)
    return prose("Described by ", *own, f", with {related} between them, or by ", *chosen, ", with none.")


def _called(rule: Rule, lines: Sequence[Equation], solution: Solution) -> str:
    letters = [e.sides[0] for e in lines if isinstance(e.sides[0], sp.Symbol)]
    views = solution.views
    if rule is Rule.FRICTION_AT_REST and all(v.at_rest is None and v.impending is None for v in views):
        return "the condition for rolling"
    if rule is Rule.SOLVED_REACTIONS and letters and all(s.name.startswith("lambda") for s in letters):
        return plural(len(lines), "the multiplier", "the multipliers")
    if rule is Rule.SOLVED_REACTIONS and any(v.at_rest is not None for v in views):
        return plural(len(lines), "the force", "the forces")
    if rule is Rule.SOLVED_REACTIONS and solution.law is not None and len(solution.law.newton.reactions) == 1:
        return "the reaction"
    if rule is Rule.HAMILTON and len(lines) > 1:
        return "Hamilton's and Routh's functions"
    branches = [v.equilibrium.branches for v in solution.views if v.equilibrium is not None]
    unknown = {s for e in lines if isinstance(e.sides[0], sp.Expr) for s in e.sides[0].free_symbols}
    found = [len(v.in_numbers.positions) for v in solution.views if v.in_numbers is not None]
    many = any(n > 1 for n in (*map(len, branches), *found))
    several = rule is Rule.EQUILIBRIUM and len(lines) > min(1, len(unknown)) and many
    several = several and not (len(lines) == len(unknown) == len({e.sides[0] for e in lines}))
    return "the equilibria" if several else _CALLED[rule]


def _from_steps(
    solution: Solution, steps: list[Step], stated: StatedEquations
) -> Iterator[tuple[Rule, list[Equation]]]:
    """The equations of motion and the reactions, as the last of the steps has them."""
    for rule in (Rule.EQUATIONS_OF_MOTION, Rule.SOLVED_REACTIONS):
        boxes = [
            [b for b in s.body if isinstance(b, Display) and b.boxed and b.detail < Detail.FULL]
            for s in steps
            if s.rule is rule
        ]
        last = next((b for b in reversed(boxes) if b), [])
        if rule is Rule.EQUATIONS_OF_MOTION and not last:
            yield from _in_speeds(steps, stated)
        if solution.own.equilibrium is not None:  # beside the forces, their sum as a vector
            last = [b for b in last if not all(isinstance(e.sides[0], VectorSymbol) for e in b.equations)] or last
        if not last or (len(last) > 1 and solution.own.equilibrium is not None):
            continue  # reactions that differ from one equilibrium to the next
        lines = [e for e in last[-1].equations if not isinstance(e.sides[0], VectorSymbol) or _is_sum(e)]
        lines = [
            replace(e, sides=(e.sides[0], e.sides[-1])) if isinstance(e.sides[0], DotProduct) else e for e in lines
        ]
        if rule is Rule.SOLVED_REACTIONS:
            lines = [
                _as_vector(solution, e if _are_equal(e) else replace(e, sides=(e.sides[0], e.sides[-1]))) for e in lines
            ]
        if not lines or (rule is Rule.SOLVED_REACTIONS and any(_has_accelerations(e, solution) for e in lines)):
            continue  # a reaction as a whole, or in terms of accelerations
        if rule is Rule.SOLVED_REACTIONS and any(e.label is None for e in lines):
            continue  # with a denominator that has a letter of its own
        if rule is Rule.SOLVED_REACTIONS and solution.law is not None:
            unnamed = {r.multiplier for r in solution.law.newton.reactions if not r.named and r.given is None}
            lines = [e for e in lines if e.sides[0] not in unnamed or e.sides[1] != 0]
            lines = [e for e in lines if e.sides[0] not in unnamed] or lines
        if rule is Rule.EQUATIONS_OF_MOTION and stated and is_better(solution.chosen, stated, lines):
            lines = [Equation(sides) for sides in stated]
        yield rule, lines


def _are_equal(e: Equation) -> bool:
    """Whether it gives several forces one value: N_A = N_B = W/2."""
    return len(e.sides) > 2 and all(isinstance(s, sp.Symbol) for s in e.sides[:-1])


def _is_sum(e: Equation) -> bool:
    """Whether it is the sum of reactions along unit vectors that turn."""
    return e.kind is EquationKind.SUM_ALONG_AXES


def is_better(view: InCoordinates, stated: StatedEquations, lines: Sequence[Equation]) -> bool:
    """Whether the form of the answers is shorter; or as short, and the same with a term on the right: m x'' = F.

    Or whether it is solved for the accelerations, and so needs no exception.
    """
    before, after = sum(e.operations for e in lines), operations_of_equations(stated)
    if any(e.condition for e in lines) and are_solved(view, stated, before):
        return True
    if after != before or len(lines) != len(stated):
        return after < before
    plain = all(e.sides[-1] == 0 and isinstance(e.sides[0], sp.Expr) and not e.condition for e in lines)
    return plain and are_same_equations(stated, [e.sides[0] for e in lines if isinstance(e.sides[0], sp.Expr)])


def _as_vector(solution: Solution, e: Equation) -> Equation:
    """R = −F_z k instead of a multiplier λ, which the page introduces later, where the direction is constant."""
    newton = None if solution.law is None else solution.law.newton
    bodies = () if newton is None or newton.bodies is None else newton.bodies
    for body in bodies if len(bodies) == 1 else ():
        [direction] = (d for _, d in body.reactions) if len(body.reactions) == 1 else (None,)
        reaction = body.bound[0] if body.bound else None
        if direction is None or reaction is None or reaction.given is not None or e.sides[0] != reaction.multiplier:
            continue
        if not any(c.free_symbols for c in direction.fixed().components) and isinstance(e.sides[1], sp.Expr):
            return replace(e, sides=(VectorSymbol(f"R_{body.name}"), direction * e.sides[1]))
    return e


def _has_accelerations(e: Equation, solution: Solution) -> bool:
    """Whether an unknown acceleration occurs in it; the second derivative of a given function of time is none."""
    functions = {f"{name}''" for name in solution.problem.scope.names()} - {
        a.name for view in solution.views for a in view.configuration.slots.accelerations
    }
    symbols = (s for side in e.sides if isinstance(side, sp.Expr) for s in side.free_symbols)
    return any(s.name.endswith("''") and s.name not in functions for s in symbols)


def _in_speeds(steps: list[Step], stated: StatedEquations) -> Iterator[tuple[Rule, list[Equation]]]:
    """The motion where the page has it in quasi-velocities only: as the answers have it, or as the page has."""
    boxes = [b for s in steps if s.rule is Rule.QUASI_VELOCITIES for b in s.body if isinstance(b, Display) and b.boxed]
    if boxes and stated:
        yield Rule.EQUATIONS_OF_MOTION, [Equation(sides) for sides in stated]
    elif boxes:
        moving = [e for e in boxes[-1].equations if e.kind is EquationKind.MOTION_IN_SPEEDS]
        yield Rule.EQUATIONS_OF_MOTION, [replace(e, condition=()) for e in moving]


def _from_view(solution: Solution, view: InCoordinates) -> Iterator[tuple[Rule, list[Equation]]]:
    """The results asked for, in one set of coordinates."""
    if view.hamiltonian is not None:
        letters = energy_symbols(solution)
        lines = [Equation((letters.hamiltonian, view.hamiltonian.function))]
        if view.hamiltonian.routhian is not None:
            lines.append(Equation((letters.routhian, view.hamiltonian.routhian)))
        yield Rule.HAMILTON, lines
    if view.is_about_rest:
        from lagrange.explain.page.result_at_rest import (
            reactions_of_only_root,
            result_at_rest,
            with_units_of_numbers,
        )

        values = solution.problem.given_values
        newton = None if solution.law is None else solution.law.newton
        held = solution.classification.degrees_of_freedom == 0
        known = no_values(solution.problem)
        for rule, lines in result_at_rest(view, values, newton, held=held, sought=solution.problem.unknowns):
            yield rule, [with_units_of_numbers(e, known) for e in lines]
        if view.is_own and (found := reactions_of_only_root(view)):
            yield Rule.SOLVED_REACTIONS, found
    if view.response is not None:
        pairs = zip(view.response.letters, view.response.amplitudes, strict=True)
        w, coordinates = view.response.drive.frequency, view.configuration.slots.coordinates
        still = [
            Equation((q, sp.S.Zero), condition=(*_beside_rest(view.response, place), "where ", math(w**2, place)))
            for q, places in zip(coordinates, view.response.rests, strict=True)
            for place in places
            if place.is_positive and count_operations(place) <= LONGEST_ANSWER_CONDITIONS
        ]
        drive, lags = view.response.drive.law, zip(view.response.lags, view.response.phases, strict=True)
        behind = [
            Equation((lag, phase), condition=("behind ", math(drive)))
            for lag, phase in (lags if view.response.is_damped else ())
            if phase is not None and count_operations(phase) <= LONGEST_FREQUENCY
        ]
        at_resonance = [
            Equation(sides, condition=("at resonance",))
            for sides in view.response.at_resonance
            if count_operations(sides[1]) <= LONGEST_FREQUENCY
        ]
        yield Rule.RESPONSE, [*(Equation(pair) for pair in pairs), *at_resonance, *behind, *still]
    elif view.forced is not None:
        yield Rule.LINEARIZATION, [Equation(sides) for sides in view.forced.sides]


def _impact(solution: Solution) -> Iterator[Equation]:
    """The velocities after an impact, the impulses, the energy lost."""
    motion = solution.impact
    if motion is None:
        return
    after = {prime(q): v for q, v in zip(motion.slots.coordinates, motion.velocities, strict=True)}
    given = {i.symbol: i.value for i in motion.impulses if i.value is not None}
    for n, pair in enumerate(by_one_velocity(after).items()):
        yield Equation(pair, condition=("just after",) if n == 0 else ())
    called = {i.symbol: spoken(i.name) for i in motion.impulses}
    singles = [(i.symbol, i.reaction.single) for i in motion.impulses]
    along = {s: (the(single.on), single.direction) for s, single in singles
             if single is not None and single.direction is not None
             and all(c.is_number for c in single.direction.components)}  # fmt: skip
    acting = {s: ("the impulse on ", on, " along ", math(u.as_sum())) for s, (on, u) in along.items()}
    none = [s for s, value in given.items() if value == 0]
    backwards = {s: ("the impulse on ", on, " along ", math((-u).as_sum())) for s, (on, u) in along.items()}
    for symbol, value in given.items():
        if value.is_negative and symbol in backwards:
            yield Equation((-symbol, -value), condition=backwards[symbol])
        elif value != 0:
            yield Equation((symbol, value), condition=acting.get(symbol, ("the impulse of ", called[symbol])))
    if none:
        of = joined(called[s] for s in none)
        these = (plural(len(none), "the impulse of ", "the impulses of "), of)
        yield Equation((*none, sp.S.Zero), condition=acting.get(none[0], these) if len(none) == 1 else these)
    struck = motion.full.loads or motion.full.torques
    if not motion.is_driven and not struck and motion.energy_lost != 0:
        letters = energy_symbols(solution)
        line = Equation((letters.before - letters.kinetic, motion.energy_lost))
        yield from [replace(line, condition=("the energy lost",))] if line.operations <= LONGEST_ANSWER else []


def _answers(solution: Solution, asked: Asked) -> Iterator[Equation]:
    """The short answers to a question, with what they are in degrees."""
    from lagrange.explain.questions import angle_of, answer_line, where_it_holds

    values = values_in(solution)
    branches: Sequence[AnswerBranch] = asked.branches
    if values is not None:
        from lagrange.mechanics.questions.ranges import branches_with

        branches = branches_with(asked, values)
    if asked.mirrored and len(branches) == 2 and branches[0].rhs == -branches[1].rhs:
        size = branches[0].rhs if branches[0].rhs.is_nonnegative else branches[1].rhs
        branches = [replace(branches[0], lhs=sp.Abs(branches[0].lhs), rhs=size)]
    if asked.integral is not None and not branches:
        line = Equation((asked.question.quantity, asked.integral))
        if line.operations <= LONGEST_ANSWER:
            yield replace(line, condition=("when ", *listed(map(as_stated, asked.question.when))))
    for b in branches:
        line, conditions = answer_line(b), b.conditions
        too_long = line.operations > LONGEST_ASKED
        if values is not None and (too_long or _hides_units(asked, b, values)):
            number = _in_numbers(asked, b, values)
            if number is not None:
                line, too_long = number, False
                conditions = tuple(c for c in conditions if not values.covers(c.lhs, c.rhs))  # the others hold
        if too_long:
            continue
        clauses: list[tuple[Part, ...]] = []
        if asked.question.when:
            clauses.append(("when ", *listed(map(as_stated, asked.question.when))))
        if conditions and sum(count_operations(c.lhs - c.rhs) for c in b.beyond_square) > LONGEST_ANSWER_CONDITIONS:
            clauses.append(("under conditions that are given below",))
        elif where := where_it_holds(replace(b, conditions=conditions), asked.divided_by):
            clauses.append(where)
        angle = angle_of(asked, b)
        if angle is not None:
            clauses.append(("that is ", angle))
        words: list[Part] = []
        for clause in clauses:
            words += [", " if words else "", *clause]
        yield replace(line, condition=tuple(words))


def _hides_units(asked: Asked, b: AnswerBranch, values: Values) -> bool:
    """Whether numbers in a formula have units, so that its dimension is not that of the quantity: 9 m/2, an energy."""
    if not asked.has_bare_numbers or not b.rhs.free_symbols:
        return False
    from lagrange.values.dimensions import dimension

    return dimension(b.lhs, values.units) not in (None, dimension(b.rhs, values.units))


def _in_numbers(asked: Asked, b: AnswerBranch, values: Values) -> Equation | None:
    """An answer as a number with its unit; None where letters are left in it."""
    from lagrange.values.quantities import is_exact

    quantity = values.quantity(b.rhs)
    if quantity is None or not quantity.is_number:
        return None
    unit = values.unit_of(b.lhs) or ("" if asked.has_bare_numbers else quantity.unit)
    relation = "=" if is_exact(quantity.formula, quantity.formula_shown()) else "≈"
    return Equation((b.lhs, replace(quantity, unit=unit).shown()), relation=relation)


def _is_short(parts: Iterable[Sequence[Equation]]) -> bool:
    lines = [e for es in parts for e in es]
    return len(lines) <= MOST_RESULTS and sum(e.operations for e in lines) <= LONGEST_RESULT


def _beside_rest(response: Response, place: sp.Expr) -> tuple[Part, ...]:
    """`and y = −(F/c_2) cos ωt, `: what moves where another coordinate is at rest, if it is one and short."""
    others = [*response.beside(place).items()]
    short = len(others) == 1 and count_operations(others[0][1]) <= LONGEST_BESIDE_REST
    return ("and ", math(*others[0]), " ") if short else ()
