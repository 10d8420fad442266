"""Systems too large to be read: what is printed of them, and that JSON has everything; how the work grows.

One walk over the blocks of a step for every format.
"""

from __future__ import annotations

import json
import re
from collections import Counter
from collections.abc import Iterator, Sequence
from functools import cache
from typing import Any

import pytest
import sympy as sp

from lagrange.core.diagnostics import Source
from lagrange.document.derivation import (
    Derivation,
    Detail,
    Display,
    Equation,
    Math,
    Matrices,
    Prose,
    Ref,
    Rule,
    Step,
    Table,
    display,
    paired,
    prose,
)
from lagrange.document.names import Notation
from lagrange.explain.report import Report, report
from lagrange.problem.loader import read_problem
from lagrange.render import html, latex, markdown, terminal
from lagrange.render import json as as_json
from lagrange.render.limits import BEGINNING, LARGEST_STEP
from lagrange.render.selection import block_lines, shown
from tests.support.families import FAMILIES

ZERO = sp.S.Zero


@cache
def solved(family: str, n: int) -> Report:
    return report(read_problem(Source(f"{family}-{n}", FAMILIES[family](n))))


def sums(count: int, length: int) -> list[Equation]:
    """Equations of `length` operations each."""
    letters = sp.symbols(f"a:{length + 1}")
    return [Equation((sp.Add(*letters) + sp.Symbol(f"b{n}") - letters[0], ZERO), label=f"e{n}") for n in range(count)]


def derivation(*blocks: Display | Prose | Matrices) -> Derivation:
    return Derivation("Large", "", (Step(Rule.EQUATIONS_OF_MOTION, "Equations", blocks),))


# What is printed


def test_a_step_that_can_be_read_is_shown_whole() -> None:
    equations = sums(LARGEST_STEP // 100, 100)
    found = shown(derivation(prose("They are"), display(*equations)), Detail.STEPS)
    assert found.steps[0].body[1] == display(*equations)


def test_of_a_larger_one_the_beginning_is_shown_and_the_rest_counted() -> None:
    equations = sums(30, 100)
    large = derivation(
        prose("They are"), display(*equations, boxed=True), prose("By ", Ref("e0"), " and ", Ref("e29"), ".")
    )
    found = shown(large, Detail.STEPS)
    words, kept, rest, last = found.steps[0].body
    assert kept == display(*equations[: BEGINNING // 100], boxed=True)
    assert rest == prose(
        "25 more equations of 2,500 operations in all are left out here as too long to read; `--format json` has them."
    )
    assert words == prose("They are")
    assert last == prose("By ", Ref("e0"), " and ", "an equation left out here", ".")
    assert list(found.numbers) == ["e0", "e1", "e2", "e3", "e4"]


def test_what_introduces_nothing_goes_too() -> None:
    large = derivation(prose("Written out, it reads"), display(*sums(1, 3000)), prose("That is all."))
    assert [b.parts for b in shown(large, Detail.STEPS).steps[0].body if isinstance(b, Prose)] == [
        ("One equation of 3,000 operations is left out here as too long to read; `--format json` has it.",),
        ("That is all.",),
    ]


def test_what_introduces_equations_comes_with_them() -> None:
    """Also after others that were left out, which it must not precede."""
    long, short = sums(1, 3000), sums(1, 10)
    large = derivation(prose("It is"), display(*long), prose("The force is"), display(*short), prose("and"))
    left, words, kept, last = shown(large, Detail.STEPS).steps[0].body
    assert isinstance(left, Prose)
    assert str(left.parts[0]).startswith("One equation of 3,000 operations is left out here")
    assert [words, kept, last] == [prose("The force is"), display(*short), prose("and")]


def test_large_matrices_are_counted() -> None:
    name, entry = sp.Symbol("M", real=True), sp.Add(*sp.symbols("a:9"))
    large = derivation(Matrices(((name, ((entry,) * 20,) * 20),)))
    [block] = shown(large, Detail.FULL).steps[0].body
    assert block == prose(
        Math((name,)),
        ", 400 entries of 3,200 operations, are left out here as too long to read; `--format json` has them.",
    )


def test_references_one_after_the_other_are_a_range() -> None:
    refs = [Ref(f"e{n}") for n in range(6)]
    words = prose(*(p for r in refs[:3] for p in (r, ", ")), refs[3], " and ", refs[5], " differ from ", refs[4])
    found = shown(derivation(display(*sums(6, 2)), words), Detail.STEPS)
    assert found.steps[0].body[1] == prose(refs[0], " to ", refs[3], " and ", refs[5], " differ from ", refs[4])
    three = prose(refs[0], ", ", refs[1], " and ", refs[2])
    assert shown(derivation(display(*sums(6, 2)), three), Detail.STEPS).steps[0].body[1] == three


def test_two_equations_in_a_line_have_one_number_that_a_list_gives_once() -> None:
    lines = paired([*sums(3, 2)])
    refs = [Ref(f"e{n}") for n in range(3)]
    words = prose("Solving ", refs[0], ", ", refs[1], " and ", refs[2], "; by ", refs[1])
    found = shown(derivation(display(*lines), words), Detail.STEPS)
    assert found.steps[0].body[1] == prose("Solving ", refs[0], " and ", refs[2], "; by ", refs[1])
    assert [found.numbers[r.label] for r in refs] == [1, 1, 2]
    both = prose("Solving ", refs[0], " and ", refs[1])
    assert shown(derivation(display(*lines), both), Detail.STEPS).steps[0].body[1] == prose("Solving ", refs[0])


def test_a_chain_too_long_to_read_is_complete_in_json() -> None:
    found = solved("links", 14)
    assert found.holds
    page = terminal.text(found.derivation, found.notation, 80, Detail.STEPS)
    assert "more equations of" in page
    assert "`--format json` has them" in page
    assert page.count("\n") < 400
    assert "Numerical check" not in page
    assert re.search(r"m₉\s+=\s+\d+,\s+m₁₀", terminal.text(found.derivation, found.notation, 80, Detail.FULL))
    whole = json.loads(as_json.render([found]))
    assert len(whole["equations"]) == 14
    assert len(whole["mass_matrix"]) == 14
    blocks = [b for s in whole["steps"] if s["rule"] == "equations-of-motion" for b in s["body"]]
    assert sum(len(b.get("equations", ())) for b in blocks) == 14
    assert "left out here" not in json.dumps(whole)


def test_every_renderer_leaves_out_the_same() -> None:
    large, notation_ = derivation(display(*sums(30, 100))), Notation()
    pages = [
        terminal.text(large, notation_, 80, Detail.STEPS),
        latex.render([(large, notation_)], True, Detail.STEPS),
        markdown.render([(large, notation_)], Detail.STEPS),
        html.render([(large, notation_)], Detail.STEPS),
    ]
    for page in pages:
        assert re.search(r"25\s+more\s+equations\s+of\s+2,500\s+operations", page), page[:2000]


# How the work grows: counts, which are the same on every machine


def count(counts: Counter[str], monkeypatch: pytest.MonkeyPatch, place: object, name: str, what: str) -> None:
    """Counts how often a function is called."""
    original = getattr(place, name)

    def counting(*args: object, **kwargs: object) -> object:
        counts[what] += 1
        return original(*args, **kwargs)

    monkeypatch.setattr(place, name, counting)


# Walk


x = sp.Symbol("x")


class Named:
    """Writes the name of each kind of block, and of how many it is."""

    def paragraphs(self, run: Sequence[Any]) -> Iterator[str]:
        yield f"paragraphs {len(run)}"

    def display(self, block: Any) -> Iterator[str]:
        yield f"display {len(block.equations)}"

    def table(self, block: Any) -> Iterator[str]:
        yield f"table {len(block.rows)}"


def test_paragraphs_that_follow_one_another_are_one_run() -> None:
    blocks = [prose("a"), prose("b"), display(Equation((x, x))), Table(("h",), (("c",),)), prose("d")]
    assert [*block_lines(blocks, Named())] == ["paragraphs 2", "display 1", "table 1", "paragraphs 1"]  # type: ignore[arg-type]
