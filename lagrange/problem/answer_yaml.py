"""Somebody's answers to all the questions of a problem, in a YAML file with the keys of a problem's `answers`.

    degrees_of_freedom: 1
    classification: [holonomic, scleronomic]
    equations: ["theta'' + g/l*sin(theta) = 0"]

The keys may stand under `answers:` as well. Mistakes of the file (an unknown key, a list where a value belongs) are
errors; an equation that cannot be read is not, because the verdict on it says so and the others still count.
"""

from __future__ import annotations

from contextlib import suppress

from lagrange.core.diagnostics import Diagnostic, ProblemError, Source
from lagrange.problem.answer_key import AnswerReader
from lagrange.problem.findings import EnoughError, Findings
from lagrange.problem.model import Answers, Problem
from lagrange.problem.nodes import Mapping, Node
from lagrange.problem.reading import Reading
from lagrange.problem.sections import mapping_of
from lagrange.problem.yaml_nodes import parse

EXAMPLE = "equations: [\"theta'' + g/l*sin(theta) = 0\"]"


def read_answers(source: Source, problem: Problem) -> Answers:
    """The answers that a text gives to a problem. Raises ProblemError with all its mistakes."""
    findings = Findings()
    answers = None
    with suppress(EnoughError):
        answers = findings.attempt(lambda: _answers(source, problem, findings))
    findings.stop_if_any()
    if answers is None or answers == Answers():
        help_ = f"give one, such as `{EXAMPLE}`"
        raise ProblemError(Diagnostic("no-answer", f"there is no answer in {source.name}", help=help_))
    return answers


def _answers(source: Source, problem: Problem, findings: Findings) -> Answers | None:
    root = parse(source, findings, what="an answer file", needs=f"the keys are those of `answers`: `{EXAMPLE}`")
    reader = AnswerReader(Reading(findings), problem.constraints, problem.choices, problem.scope, tries=False)
    return reader.answers(_inside(root))


def _inside(root: Mapping) -> Node:
    """What stands under `answers`, where that is the only key."""
    if len(root.entries) == 1 and root.entries[0][0].text == "answers":
        return mapping_of(root.entries[0][1], "`answers`", f"answers: {{{EXAMPLE}}}")
    return root
