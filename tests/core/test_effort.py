"""The allowance of work.

Work in which SymPy puts no sums and products together.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

import pytest
import sympy as sp
from sympy.core import random

from lagrange.core.diagnostics import GaveUpError
from lagrange.core.effort import (
    Attempts,
    GivenUpError,
    allowed,
    allowed_for,
    allowed_for_a_search,
    ensure,
    kept_result,
    spend,
    unlimited,
    within,
)
from tests.support.work import units


def expanded(letters: str) -> sp.Expr:
    a, b, c = sp.symbols(letters)
    return sp.expand((a + b + c) ** 40)


def test_work_beyond_the_allowance_is_given_up() -> None:
    with pytest.raises(GivenUpError), allowed(10):
        [spend(n) for n in (6, 6)]


def test_a_factorization_takes_the_same_work_each_time() -> None:
    x, y, z, w = sp.symbols("x y z w")
    p = sp.expand(
        (x**2 * y - z**2 * w + 3 * x * w**2) * (x**2 * w + y**2 * z**2 - 2 * w**2) * (x**2 + y**2 + z**2 * w**2 + 1)
    )
    taken = []
    for seed in range(5):
        random.rng.seed(seed)
        with allowed(10**6) as allowance:
            sp.Poly(p, x, y, z, w).factor_list()
        taken.append(round(allowance.units - allowance.left))
    assert len({*taken[1:]}) == 1  # the first also fills SymPy's caches


def test_what_sympy_does_is_counted() -> None:
    with allowed(10**6) as allowance:
        expanded("a0 b0 c0")
    assert 800 < allowance.units - allowance.left < 10**5
    with pytest.raises(GivenUpError), allowed(500):
        expanded("a1 b1 c1")


def test_nothing_takes_it_for_an_error_of_its_own() -> None:
    assert not issubclass(GivenUpError, Exception)


def test_without_an_allowance_nothing_is_counted() -> None:
    spend(1e12)
    expanded("a2 b2 c2")


def test_an_allowance_within_another_has_its_own_units() -> None:
    with allowed(10):
        with allowed(100):
            spend(50)
        spend(9)


def test_the_stage_is_named() -> None:
    with (
        pytest.raises(GaveUpError, match="given up at: the middle, the work allowed") as caught,
        allowed_for("the middle", 1),
    ):
        spend(2)
    assert caught.value.diagnostics[0].code == "given-up"
    with pytest.raises(GaveUpError, match="the end, there is not enough memory"), allowed_for("the end", 1):
        raise MemoryError


def test_allowances_can_be_lifted() -> None:
    with unlimited(), allowed(1):
        spend(1e12)


def test_what_a_search_takes_is_taken_from_the_allowance_around_it() -> None:
    with allowed(100) as allowance:
        with allowed_for_a_search(100):
            spend(90)
        assert allowance.left == 10


def fill_memory() -> None:
    kept: list[object] = []
    for _ in range(100):
        kept.append([(n, -n) for n in range(1_000)])
        with allowed(10**9):  # what is within another begins with what is in use already
            spend(5_000)


def test_more_memory_than_is_allowed_is_given_up(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("lagrange.core.effort.MOST_BLOCKS", 20_000)
    with pytest.raises(GivenUpError, match="memory"), allowed(10**9):
        fill_memory()


def test_too_much_is_refused_before_it_is_begun() -> None:
    with allowed(100):
        ensure(100)
        ensure(100)
    with pytest.raises(GivenUpError), allowed(100):
        ensure(101)


def test_results_are_kept_for_one_object_within_one_allowance() -> None:
    calls = []

    @kept_result
    def length(of: list[int]) -> int:
        calls.append(of)
        return len(of)

    a, b = [1, 2], [1, 2]
    with allowed(10):
        assert [length(a), length(a), length(b)] == [2, 2, 2]
        assert len(calls) == 2
    length(a), length(a)
    assert len(calls) == 4, "without an allowance nothing is kept"


def test_attempts_leave_out_what_takes_too_much() -> None:
    """What comes after it is done, in what is left or in the least that each piece has."""
    make = Attempts(1_000, 50)

    def work(units: float) -> float:
        spend(units)
        return units

    assert [make(work, u) for u in (400, 400, 60, 200, 40)] == [400, None, 60, None, 40]
    assert make.why_not == "the work allowed for one problem is used up"


def test_things_that_are_made_one_after_the_other_end_with_one_that_takes_too_much() -> None:
    def things() -> Iterator[int]:
        for n in range(1, 5):
            spend(10**n)
            yield n

    make = Attempts(2_000, 50)
    assert [*make.each(things)] == [1, 2]
    assert make.why_not


# Counted steps


x, y = sp.symbols("x y", positive=True)


def twice(depth: int) -> sp.Expr:
    """An expression of few parts, of which each occurs twice in the next."""
    e = x
    for _ in range(depth):
        e = sp.Function("f")(e, e)
    return e


def test_walks_are_counted_by_occurrences() -> None:
    small, large = (units(partial(twice(n).replace, sp.sin, sp.cos)) for n in (10, 12))
    assert 3 < large / small < 5
    assert large > 300
    with pytest.raises(GivenUpError), allowed(1_000):
        twice(40).replace(sp.sin, sp.cos)


def test_polynomials_are_counted() -> None:
    short, long = (sp.Poly((x + y + 1) ** n * (x - y) ** 3, x, y) for n in (1, 12))
    assert units(lambda: long.sqf_list()) > 4 * units(lambda: short.sqf_list()) > 100


def test_long_numbers_are_counted() -> None:
    ones = sp.Poly([1] * 200, x)
    short, long = (units(lambda a=a: ones.eval(a)) for a in (3, 2**4000))
    assert long > 10 * short


def test_signs_and_numbers_are_counted() -> None:
    a, b = sp.symbols("a b", real=True)
    assert units(lambda: [((a + n) ** 2 + b * n).is_positive for n in range(200)]) > 500
    number = sum(sp.sqrt(n) for n in range(2, 400))
    assert units(lambda: number.evalf(50)) > 300


def test_a_search_that_takes_too_much_has_no_result() -> None:
    with allowed(1_000) as outer:
        assert within(10, lambda: spend(20)) is None
        assert within(10, lambda: 5) == 5
        assert 0 < outer.left < 1_000
