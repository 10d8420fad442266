"""Reads a problem file into a `Problem`, and finds all its mistakes in one pass.

The sections are read in the order in which they can refer to one another: symbols, frame, abbreviations with particles
and bodies, constraints, forces, choices, answers; each has a module of its own. Anything wrong is reported and omitted,
and reading goes on; the diagnostics are shown together in file order.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from pathlib import Path

import sympy as sp

from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError, Source, suggestion
from lagrange.core.effort import allowed_for
from lagrange.core.symbols import CONSTANT
from lagrange.expressions.reader import Scope
from lagrange.problem.constraints import read_constraints
from lagrange.problem.coordinate_choices import choice_relative_to_motion, read_choices, read_frame, read_speeds
from lagrange.problem.declarations import (
    first_scope,
    note_unused,
    read_coordinates,
    read_functions,
    read_parameters,
    read_unknowns,
    with_standard_arguments,
)
from lagrange.problem.diagnostic_collector import Diagnostics, EnoughError
from lagrange.problem.figures import read_figure
from lagrange.problem.forces import read_forces, read_gravity
from lagrange.problem.keys import AXES, PROBLEM, Find
from lagrange.problem.limits import UNITS_OF_READING
from lagrange.problem.load_context import LoadContext
from lagrange.problem.masses import read_things
from lagrange.problem.model import ENERGY, KINETIC_ENERGY, Choice, Constraint, Problem, Speed
from lagrange.problem.questions import (
    read_impact,
    read_initial,
    read_questions,
    scope_of_questions,
    with_dimensions_compared,
    with_initial_before,
)
from lagrange.problem.sections import OTHER_QUESTIONS, RATE, Section, entries_of, items_of, scalar_of
from lagrange.problem.sources import read_source
from lagrange.problem.stated_answers import AnswerReader
from lagrange.problem.values import check_dimensions, note_inertia, with_settings
from lagrange.problem.variants.vary import read_vary
from lagrange.problem.yaml.composer import parse
from lagrange.problem.yaml.nodes import Node, Scalar


def load(path: str | Path, settings: Sequence[Fragment] = ()) -> Problem:
    """The problem of a file, with `settings` as those of `read_problem`.

    Raises ProblemError with all its mistakes, or where there is no such file.
    """
    return read_problem(read_source(Path(path)), settings)


def read_problem(source: Source, settings: Sequence[Fragment] = ()) -> Problem:
    """The problem that a text states. Raises ProblemError with all its mistakes.

    settings  texts NAME=VALUE that give or replace values of parameters
    """
    diagnostics = Diagnostics()
    problem = None
    with suppress(EnoughError), allowed_for("reading the problem", UNITS_OF_READING):
        problem = diagnostics.attempt(lambda: _problem(source, diagnostics, settings))
    diagnostics.stop_if_any()
    assert problem is not None  # otherwise a diagnostic was raised
    return with_standard_arguments(replace(problem, notes=diagnostics.notes()))


def _problem(source: Source, diagnostics: Diagnostics, settings: Sequence[Fragment]) -> Problem:
    """All sections, in the order in which they can refer to one another."""
    node = parse(source, diagnostics)
    root = Section(node, "the problem", PROBLEM, diagnostics)
    context = LoadContext(diagnostics)
    for value in root.strange:
        context.names.fail_all(value)  # it may have been meant to declare something
    parameters = read_parameters(root.section("parameters"), context.names)
    context.names.parameters = tuple(p.symbol for p in parameters)
    listed = diagnostics.attempt(lambda: root.required("coordinates", node.span))
    coordinates = read_coordinates(listed, context.names)
    if settings:
        given = parameters
        parameters = diagnostics.attempt(lambda: with_settings(given, coordinates, settings)) or given
    functions = read_functions(root.section("functions"), context.names)
    context.unknowns = read_unknowns(root.section("unknowns"), context.names, root.section("forces"))
    context.values = {p.symbol: p.value for p in parameters if p.value is not None}
    context.scope = first_scope(parameters, coordinates, functions, context.unknowns)
    frame = read_frame(root.section("frame"), context)
    things = read_things(root, context)
    constraints = read_constraints(root.section("constraints"), context)
    gravity = read_gravity(root.get("gravity"), context)
    forces = read_forces(root.section("forces"), context, constraints)
    speeds = read_speeds(root.section("speeds"), context)
    choices = read_choices(root.section("generalized_coordinates"), context)
    asking = scope_of_questions(context.scope, constraints, choices)
    initial = read_initial(root.section("initial"), context, asking)
    impact = read_impact(root.section("impact"), context, asking, constraints)
    if impact is not None:
        asking = scope_of_questions(context.scope, (*constraints, *impact.constraints), choices)
    questions = read_questions(root.section("ask"), context, asking)
    scope = _scope_of_answers(context.scope, constraints, choices, speeds)
    if questions:
        energies = {s.name: s for s in (KINETIC_ENERGY, ENERGY) if s.name not in scope.names()}
        scope = replace(scope, scalars={**energies, **scope.scalars})
    answers = AnswerReader(context, constraints, choices, scope, questions)
    function = root.get("lagrangian")
    lagrangian = (
        None if function is None else diagnostics.attempt(lambda: context.scalar(function, "`lagrangian`", RATE))
    )
    problem = Problem(
        title=diagnostics.attempt(lambda: _title(root)) or "",
        source=root.text("source"),
        description=root.text("description"),
        axes=_axes(root.section("axes"), diagnostics),
        coordinates=coordinates,
        slots=scope.slots,
        scope=scope,
        frame=frame,
        parameters=parameters,
        functions=functions.undefined,
        abbreviations=things.abbreviations,
        particles=things.particles,
        bodies=things.bodies,
        constraints=constraints,
        gravity=gravity,
        gravity_span=field.span if (field := root.get("gravity")) else None,
        forces=forces,
        unknowns=context.unknowns,
        speeds=speeds,
        choices=choices,
        initial=initial,
        questions=questions,
        impact=impact,
        lagrangian=lagrangian,
        equations=answers.equations(root.section("equations"), "`equations`"),
        answers=answers.answers(root.section("answers")),
        points=answers.points(root.section("points")),
        figure=read_figure(root, context, choices),
        vary=read_vary(root.section("vary"), parameters, diagnostics),
    )
    _check_whole(problem, root, diagnostics)
    read = problem
    problem = diagnostics.attempt(lambda: with_dimensions_compared(read, diagnostics.report)) or problem
    find = _find(root.get("find"), problem, diagnostics)
    if Find.LINEARIZATION in find and not choices and (relative := choice_relative_to_motion(constraints, scope.slots)):
        problem = replace(problem, choices=(relative,))
    if Find.IMPACT in find and impact is None and not root.has("impact"):
        message = "an impact is asked for, but the file has no `impact`"
        help_ = "say what happens: `impact: {constraints: {wall: x = 0}}`, or `impulses: {blow: {on: P, vector: J*i}}`"
        diagnostics.report(Diagnostic("missing-key", message, root.span_of("find"), help=help_))
    if {*find} - {Find.CONSTRAINTS, Find.EQUILIBRIUM, Find.IMPENDING}:
        for name, span in context.without_inertia.items():
            help_ = "add `inertia: I_G`"
            diagnostics.report(Diagnostic("missing-key", f"the body `{name}` has no `inertia`", span, help=help_))
    problem = replace(problem, find=find)
    if impact is not None and Find.MOTION not in find:
        problem = diagnostics.attempt(lambda: with_initial_before(problem)) or problem
    return problem


def _title(root: Section) -> str:
    scalar = scalar_of(root.required("title", root.node.span), "`title`")
    title = " ".join(scalar.text.split())
    if not title:
        raise ProblemError(Diagnostic("empty-value", "`title` is empty", scalar.span, help="write its value"))
    return title


def _axes(node: Node | None, diagnostics: Diagnostics) -> Mapping[str, str]:
    """Words for the directions of i, j, k."""
    words: dict[str, str] = {}
    if node is None:
        return words
    for name, value in diagnostics.attempt(lambda: entries_of(node, "`axes`", "axes: {i: right, j: up}")) or ():
        if name.text not in AXES.names:
            help_ = "the axes are `i`, `j`, `k`, and each has a word: `i: right`"
            diagnostics.report(Diagnostic("unknown-key", f"`{name.text}` is not an axis", name.span, help=help_))
            continue
        word = diagnostics.attempt(lambda n=name, v=value: scalar_of(v, f"the word for `{n.text}`").text)  # type: ignore[misc]
        words[name.text] = " ".join((word or "").split())
    return words


def _find(node: Node | None, problem: Problem, diagnostics: Diagnostics) -> tuple[Find, ...]:
    """The questions asked; by default the one that the contents of the file suggest."""
    if node is None:
        return (_suggested(problem),)
    items = (
        (node,) if isinstance(node, Scalar) else diagnostics.attempt(lambda: items_of(node, "`find`", "find: motion"))
    )
    asked = (diagnostics.attempt(lambda i=i: _question(i)) for i in items or ())  # type: ignore[misc]
    return tuple(dict.fromkeys(q for q in asked if q is not None)) or (_suggested(problem),)


def _question(node: Node) -> Find:
    scalar = scalar_of(node, "`find`")
    if scalar.text not in set(Find):
        meant = OTHER_QUESTIONS.get(re.sub("[^a-z]+", " ", scalar.text.lower()).strip())
        help_ = f"write `{meant}`" if meant else suggestion(scalar.text, [*Find], "questions")
        several = [q for q in Find if q.value in scalar.text.lower()]
        if len(several) > 1:
            help_ = f"several questions are a list: `find: [{', '.join(several)}]`"
        message = f"`{scalar.text}` is not something to find"
        raise ProblemError(Diagnostic("unknown-question", message, scalar.span, help=help_))
    return Find(scalar.text)


def _suggested(problem: Problem) -> Find:
    """An impact where the file has one; motion where there are masses, equilibrium where there are forces without
    masses, constraints otherwise.
    """
    if problem.impact is not None:
        return Find.IMPACT
    if problem.lagrangian is not None:
        return Find.MOTION
    masses = [p.mass for p in problem.particles] + [m for b in problem.bodies for m in (b.mass, *b.inertia)]
    if any(m != 0 for m in masses) or problem.equations:
        return Find.MOTION
    return Find.EQUILIBRIUM if problem.forces else Find.CONSTRAINTS


def _scope_of_answers(
    scope: Scope, constraints: tuple[Constraint, ...], choices: tuple[Choice, ...], speeds: tuple[Speed, ...]
) -> Scope:
    """The scope of the finished problem, with reactions, coordinates of the choices, quasi-velocities and `const`."""
    old = scope.slots.coordinates
    new: dict[str, sp.Expr] = {q.name: q for c in choices for q in c.coordinates if q not in old}
    reactions = {c.reaction.name: c.reaction for c in constraints}
    quasi = {s.symbol.name: s.definition for s in speeds}
    return replace(scope, scalars={CONSTANT.name: CONSTANT, **scope.scalars, **reactions, **new, **quasi})


def _check_whole(problem: Problem, root: Section, diagnostics: Diagnostics) -> None:
    """Reports contradictions between sections."""
    diagnostics.attempt(lambda: check_dimensions(problem))
    note_inertia(problem, diagnostics.report)
    note_unused(problem, root.get("parameters"), diagnostics.report)
    if problem.equations and (problem.particles or problem.bodies):
        message = "the equations are given, but there are also masses to derive them from"
        help_ = "keep `equations` (to check answers against) or the particles and bodies (to derive them)"
        diagnostics.report(Diagnostic("two-systems", message, root.span_of("equations"), help=help_))
    if root.get("lagrangian") is not None and (problem.particles or problem.bodies or problem.gravity is not None):
        message = "the Lagrangian is given, but there are also masses or gravity to derive it from"
        help_ = "keep `lagrangian`, or the particles, bodies and gravity; massless points are `let` names"
        diagnostics.report(Diagnostic("two-systems", message, root.span_of("lagrangian"), help=help_))
    open_choices = [c for c in problem.choices if c.substitute is None]
    for p in problem.parameters:
        if open_choices and re.fullmatch(r"sigma_[0-9]+", p.symbol.name):
            choice = open_choices[0]
            message = f"`{p.symbol}` is a parameter, but the choice `{choice.name}` may need this name for a sign"
            help_ = "rename the parameter: a choice without `substitute` solves for roots, with signs sigma_1, ..."
            diagnostics.report(Diagnostic("declared-twice", message, choice.span, help=help_))
