"""Values without a sign of equality."""

from __future__ import annotations

import pytest

from lagrange.answers.questions.texts.values_alone import as_asked, is_expressions, with_sign_after_names
from lagrange.core.diagnostics import Fragment
from tests.support.shared import solved


@pytest.mark.parametrize(
    ("line", "read"),
    [
        ("range: v^2/g", "range= v^2/g"),
        ("  - range: v^2/g", "  - range= v^2/g"),
        ("range: v^2 = g", "range: v^2 = g"),
        ("range: v < g", "range: v < g"),
        ("width: v^2/g", "width: v^2/g"),
    ],
)
def test_the_colon_after_the_name_of_a_question_is_a_sign_of_equality(line: str, read: str) -> None:
    assert with_sign_after_names(line, {"range"}) == read
    assert len(read) == len(line)  # every place stays where it is


@pytest.mark.parametrize(
    ("text", "whether"), [(r"0, \sqrt{c/m}", True), ("F/sqrt(c)", True), ("the mass is large", False)]
)
def test_words_are_no_expressions(text: str, whether: bool) -> None:
    assert is_expressions(text) is whether


def test_expressions_alone_are_no_answer_where_only_equations_are_asked_for() -> None:
    assert as_asked([Fragment.of("m*g")], solved("ex11-ideal-pendulum")) is None
