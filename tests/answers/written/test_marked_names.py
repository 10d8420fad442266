"""Names with a prime, and letters behind a Greek one."""

from __future__ import annotations

from lagrange.answers.written.marked_names import with_indices_of_greek, with_primed_names
from lagrange.core.diagnostics import Fragment
from tests.support.scopes import PENDULUM


def test_a_letter_behind_a_greek_one_is_an_index_where_that_is_defined() -> None:
    lines = [Fragment.of(t) for t in ("ωc = q/m", "x'' = ωc y'", "2ωcx = 3")]
    assert [f.text for f in with_indices_of_greek(lines, PENDULUM)] == ["ω_c = q/m", "x'' = ω_c y'", "2ωcx = 3"]


def test_a_letter_of_the_problem_is_a_factor() -> None:
    lines = [Fragment.of(t) for t in ("ωl = v", "x'' = ωc y'")]  # l is the length; no line defines ωc
    assert [f.text for f in with_indices_of_greek(lines, PENDULUM)] == [f.text for f in lines]


def test_a_constant_with_a_prime_is_another_constant() -> None:
    lines = [Fragment.of(t) for t in ("A' = A + m l^2", "A' theta'' = 0")]
    assert [f.text for f in with_primed_names(lines, {"A"})] == ["A_prime = A + m l^2", "A_prime theta'' = 0"]
    assert [f.text for f in with_primed_names(lines, {"B"})] == [f.text for f in lines]
