"""A problem file -> a `Problem`, with every mistake of the file found in one reading.

The sections are read in the order in which they can refer to one another: symbols, frame, abbreviations with particles
and bodies, constraints, forces, choices, answers; each has a module of its own. What is wrong is noted and left out,
and reading goes on; the findings are shown together in the order of the file.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import replace
from pathlib import Path

import sympy as sp

from lagrange.core.diagnostics import Diagnostic, ProblemError, Source, suggestion
from lagrange.core.symbols import CONSTANT
from lagrange.expressions.reader import Scope
from lagrange.problem.answer_key import AnswerReader
from lagrange.problem.constraints import read_constraints
from lagrange.problem.coordinate_choices import read_choices, read_speeds
from lagrange.problem.declarations import first_scope, read_coordinates, read_functions, read_parameters, read_unknowns
from lagrange.problem.findings import EnoughError, Findings
from lagrange.problem.forces import read_forces, read_gravity
from lagrange.problem.model import Choice, Constraint, Find, Problem, Speed
from lagrange.problem.nodes import Node, Scalar
from lagrange.problem.particles import read_things
from lagrange.problem.reading import Reading
from lagrange.problem.reference_frame import read_frame
from lagrange.problem.sections import Section, entries_of, items_of, scalar_of
from lagrange.problem.undefined_functions import with_standard_arguments
from lagrange.problem.yaml_nodes import MAX_BYTES, decode, parse

SECTIONS = (
    "title", "source", "description", "axes", "parameters", "coordinates", "functions", "let", "frame", "particles",
    "bodies", "constraints", "gravity", "forces", "unknowns", "speeds", "generalized_coordinates", "equations", "find",
    "answers",
)  # fmt: skip
"""The keys of a problem file."""


def load(path: str | Path) -> Problem:
    """The problem of a file.

    Raises ProblemError with all its mistakes, or where there is no such file.
    """
    return read_problem(read_source(Path(path)))


def read_source(path: Path) -> Source:
    """The text of a file. Raises ProblemError where it cannot be read."""
    try:
        with path.open("rb") as file:
            return decode(file.read(MAX_BYTES + 1), str(path))
    except FileNotFoundError:
        help_ = "check the name; `-` reads standard input"
        found = Diagnostic("no-such-file", f"there is no file {path}", help=help_)
    except IsADirectoryError:
        found = Diagnostic("is-a-folder", f"{path} is a folder", help="name a problem file in it")
    except (OSError, ValueError) as error:  # ValueError: a NUL in the name
        reason = getattr(error, "strerror", None) or str(error)
        help_ = "check the name, and that you may read it"
        found = Diagnostic("unreadable-file", f"{path} cannot be read: {reason}", help=help_)
    raise ProblemError(found)


def read_problem(source: Source) -> Problem:
    """The problem that a text states. Raises ProblemError with all its mistakes."""
    findings = Findings()
    problem = None
    with suppress(EnoughError):
        problem = findings.attempt(lambda: _problem(source, findings))
    findings.stop_if_any()
    assert problem is not None  # otherwise something was found
    return with_standard_arguments(replace(problem, notes=findings.notes()))


def _problem(source: Source, findings: Findings) -> Problem:
    """All sections, in the order in which they can refer to one another."""
    node = parse(source, findings)
    root = Section(node, "the problem", SECTIONS, findings)
    reading = Reading(findings)
    for value in root.strange:
        reading.names.fail_all(value)  # it may have been meant to declare something
    parameters = read_parameters(root.section("parameters"), reading.names)
    listed = findings.attempt(lambda: _required(root, "coordinates", "[x, y]"))
    coordinates = read_coordinates(listed, reading.names)
    functions = read_functions(root.section("functions"), reading.names)
    reading.unknowns = read_unknowns(root.section("unknowns"), reading.names)
    reading.values = {p.symbol: p.value for p in parameters if p.value is not None}
    reading.scope = first_scope(parameters, coordinates, functions, reading.unknowns)
    frame = read_frame(root.section("frame"), reading)
    things = read_things(root, reading)
    constraints = read_constraints(root.section("constraints"), reading)
    gravity = read_gravity(root.get("gravity"), reading)
    forces = read_forces(root.section("forces"), reading)
    speeds = read_speeds(root.section("speeds"), reading)
    choices = read_choices(root.section("generalized_coordinates"), reading)
    scope = _scope_of_answers(reading.scope, constraints, choices, speeds)
    answers = AnswerReader(reading, constraints, choices, scope)
    problem = Problem(
        title=findings.attempt(lambda: _title(root)) or "",
        source=root.text("source"),
        description=root.text("description"),
        axes=_axes(root.section("axes"), findings),
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
        forces=forces,
        unknowns=reading.unknowns,
        speeds=speeds,
        choices=choices,
        equations=answers.equations(root.section("equations"), "`equations`"),
        answers=answers.answers(root.section("answers")),
    )
    _check_whole(problem, root, findings)
    return replace(problem, find=_find(root.get("find"), problem, findings))


def _required(root: Section, key: str, example: str) -> Node:
    return root.required(key, root.node.span, example)


def _title(root: Section) -> str:
    scalar = scalar_of(_required(root, "title", "..."), "`title`")
    title = " ".join(scalar.text.split())
    if not title:
        raise ProblemError(Diagnostic("empty-value", "`title` is empty", scalar.span, help="write its value"))
    return title


def _axes(node: Node | None, findings: Findings) -> Mapping[str, str]:
    """Words for the directions of i, j, k."""
    words: dict[str, str] = {}
    if node is None:
        return words
    for name, value in findings.attempt(lambda: entries_of(node, "`axes`", "axes: {i: right, j: up}")) or ():
        if name.text not in ("i", "j", "k"):
            help_ = "the axes are `i`, `j`, `k`, and each has a word: `i: right`"
            found = Diagnostic("unknown-key", f"`{name.text}` is not an axis", name.span, help=help_)
            findings.report(found)
            continue
        word = findings.attempt(lambda n=name, v=value: scalar_of(v, f"the word for `{n.text}`").text)  # type: ignore[misc]
        words[name.text] = " ".join((word or "").split())
    return words


def _find(node: Node | None, problem: Problem, findings: Findings) -> tuple[Find, ...]:
    """What is asked; by default what the contents of the file suggest."""
    if node is None:
        return (_suggested(problem),)
    items = (node,) if isinstance(node, Scalar) else findings.attempt(lambda: items_of(node, "`find`", "find: motion"))
    asked = (findings.attempt(lambda i=i: _question(i)) for i in items or ())  # type: ignore[misc]
    return tuple(dict.fromkeys(q for q in asked if q is not None)) or (_suggested(problem),)


def _question(node: Node) -> Find:
    scalar = scalar_of(node, "`find`")
    if scalar.text not in set(Find):
        help_ = suggestion(scalar.text, [*Find], "questions")
        several = [q for q in Find if q.value in scalar.text.lower()]
        if len(several) > 1:
            help_ = f"several questions are a list: `find: [{', '.join(several)}]`"
        message = f"`{scalar.text}` is not something to find"
        raise ProblemError(Diagnostic("unknown-question", message, scalar.span, help=help_))
    return Find(scalar.text)


def _suggested(problem: Problem) -> Find:
    """Motion where there are masses, equilibrium where there are forces without masses, constraints otherwise."""
    masses = [p.mass for p in problem.particles] + [m for b in problem.bodies for m in (b.mass, *b.inertia)]
    if any(m != 0 for m in masses) or problem.equations:
        return Find.MOTION
    return Find.EQUILIBRIUM if problem.forces else Find.CONSTRAINTS


def _scope_of_answers(
    scope: Scope, constraints: tuple[Constraint, ...], choices: tuple[Choice, ...], speeds: tuple[Speed, ...]
) -> Scope:
    """The scope of the finished problem: reactions, the coordinates of the choices, quasi-velocities and `const` are
    known there.
    """
    old = scope.slots.coordinates
    new: dict[str, sp.Expr] = {q.name: q for c in choices for q in c.coordinates if q not in old}
    reactions = {c.reaction.name: c.reaction for c in constraints}
    quasi = {s.symbol.name: s.definition for s in speeds}
    return replace(scope, scalars={CONSTANT.name: CONSTANT, **scope.scalars, **reactions, **new, **quasi})


def _check_whole(problem: Problem, root: Section, findings: Findings) -> None:
    """What no section can know alone."""
    if problem.equations and (problem.particles or problem.bodies):
        message = "the equations are given outright, and there are masses to derive them from"
        help_ = "keep `equations` (to check answers against) or the particles and bodies (to derive them)"
        findings.report(Diagnostic("two-systems", message, root.span_of("equations"), help=help_))
    open_choices = [c for c in problem.choices if c.substitute is None]
    for p in problem.parameters:
        if open_choices and re.fullmatch(r"sigma_[0-9]+", p.symbol.name):
            choice = open_choices[0]
            message = f"`{p.symbol}` is a parameter, and what a sign in the choice `{choice.name}` may be called"
            help_ = "rename the parameter: a choice without `substitute` solves for roots, with signs sigma_1, ..."
            findings.report(Diagnostic("declared-twice", message, choice.span, help=help_))
