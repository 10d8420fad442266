"""All mistakes of a file, each at its place and once."""

from __future__ import annotations

import pytest

from lagrange.core.diagnostics import ProblemError
from tests.support.problem_texts import HEAD, mistakes, places, read


def test_all_mistakes_of_a_file_are_told_at_once_in_its_order() -> None:
    text = """titel: Example
parameters: {m: positiv, g: }
coordinates: [x, 2y]
let: {a: sin(x}
particles: {P: {mass: x', position: x}}
constraints: {rod: x > 0}
gravity: g*z
forces: {push: {on: Q, vector: g*i}}
find: movement
answers: {degrees_of_freedom: one}
"""
    assert places(text) == [
        ("unknown-key", 1, 1),
        ("unknown-assumption", 2, 17),
        ("bad-name", 3, 18),
        ("not-closed", 4, 13),
        ("not-allowed-here", 5, 23),
        ("scalar-for-vector", 5, 37),
        ("inequality", 6, 22),
        ("unknown-symbol", 7, 12),
        ("unknown-name", 8, 21),
        ("unknown-question", 9, 7),
        ("not-a-number", 10, 31),
    ]


def test_a_mistake_is_shown_with_file_line_column_and_caret() -> None:
    with pytest.raises(ProblemError) as caught:
        read(HEAD + "constraints: {rod: x^2 = L^2}\n")
    assert caught.value.show() == (
        "error[unknown-symbol]: `L` is not declared\n --> problem.yaml:4:26\n  |\n"
        "4 | constraints: {rod: x^2 = L^2}\n  |                          ^\n  = help: did you mean `l`?"
    )


def test_a_mistake_is_not_repeated_where_its_name_is_used() -> None:
    assert places(HEAD + "let: {a: q, b: a, c1: b*i}\nparticles: {P: {mass: m, position: c1}}\n") == [
        ("unknown-symbol", 4, 10)
    ]
    found = mistakes(HEAD + "let: {a: q, b: q + 1}\nconstraints: {rod: x = q}\n")
    assert [d.code for d in found] == ["unknown-symbol"]
    assert found[0].label == "also on line 5"


def test_the_hundred_first_mistake_is_not_told() -> None:
    found = mistakes(HEAD + "constraints:\n" + "".join(f"  a{n}: q{n} = 0\n" for n in range(900)))
    assert len(found) == 101
    assert found[-1].code == "more-mistakes"
