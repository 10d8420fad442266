"""The kinds of broken inputs, by name."""

from __future__ import annotations

from collections.abc import Callable

from tests.support.fuzzers import inputs, parts

KINDS: dict[str, Callable[[int], str]] = {
    "problems": inputs.mutated_problem,
    "grammar": inputs.problem_by_grammar,
    "parts": parts.problem_by_parts,
    "simulations": parts.simulation,
    "files": inputs.read_file,
    "texts": inputs.read_text,
    "answers": inputs.answer,
    "replies": parts.reply,
    "submissions": inputs.submission,
    "journals": inputs.journal,
}
