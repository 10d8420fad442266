"""How the work grows with a system: counts that are the same on every machine."""

from __future__ import annotations

from collections import Counter
from functools import cache

import pytest
import sympy as sp

from lagrange.algebra.exact import sampler
from lagrange.algebra.exact.points import Point
from lagrange.algebra.exact.prime_field import Fields, PrimeField
from lagrange.answers import equations as answers
from lagrange.answers.equations import check_equations
from lagrange.answers.examiner import reference
from lagrange.core import symbols as notation
from lagrange.core.diagnostics import Fragment, Source
from lagrange.document.derivation import (
    Derivation,
    Display,
    Matrices,
    Prose,
    Rule,
    Step,
)
from lagrange.explain.report import Report, report
from lagrange.problem.loader import load, read_problem
from tests.support.families import FAMILIES
from tests.support.paths import PROBLEMS


@cache
def solved(family: str, n: int) -> Report:
    return report(read_problem(Source(f"{family}-{n}", FAMILIES[family](n))))


def derivation(*blocks: Display | Prose | Matrices) -> Derivation:
    return Derivation("Large", "", (Step(Rule.EQUATIONS_OF_MOTION, "Equations", blocks),))


def count(counts: Counter[str], monkeypatch: pytest.MonkeyPatch, place: object, name: str, what: str) -> None:
    """Counts how often a function is called."""
    original = getattr(place, name)

    def counting(*args: object, **kwargs: object) -> object:
        counts[what] += 1
        return original(*args, **kwargs)

    monkeypatch.setattr(place, name, counting)


@pytest.fixture
def counted(monkeypatch: pytest.MonkeyPatch) -> Counter[str]:
    """How often the slow things are done, at the same points each time: how many meet all signs is chance."""
    fields = Fields(1)
    monkeypatch.setattr(sampler, "process_fields", lambda: fields)
    counts: Counter[str] = Counter()
    count(counts, monkeypatch, notation, "_by_chain_rule", "derivatives")
    count(counts, monkeypatch, sp.Expr, "diff", "derivatives of SymPy")
    count(counts, monkeypatch, Point, "at", "values at points")
    count(counts, monkeypatch, PrimeField, "less", "rows reduced")
    return counts


def work(family: str, n: int, counts: Counter[str]) -> dict[str, int]:
    """The counts of one derivation with its checks, nothing remembered from before."""
    from sympy.core.cache import clear_cache

    clear_cache()
    notation.partial.cache_clear()
    counts.clear()
    found = report(read_problem(Source(f"{family}-{n}", FAMILIES[family](n))))
    assert found.holds
    return dict(counts)


MOST = {  # of n = 8; what they are today, and a tenth more
    "links": {"derivatives": 6100, "derivatives of SymPy": 10, "values at points": 5500, "rows reduced": 1600},
    # with the signs of all lengths, which are read at every state (1552 without)
    "springs": {"derivatives": 2200, "derivatives of SymPy": 620, "values at points": 2250, "rows reduced": 240},
    # with the forty points that a surface of several components needs (28,000 values and 10,000 rows without)
    "necklace": {"derivatives": 11600, "derivatives of SymPy": 3600, "values at points": 47000, "rows reduced": 24800},
}


@pytest.mark.parametrize("family", MOST)
def test_no_more_work_than_before(family: str, counted: Counter[str]) -> None:
    """A count that grows needs an explanation; raise the number here together with the reason."""
    found = work(family, 8, counted)
    assert {what: found.get(what, 0) <= most for what, most in MOST[family].items()} == dict.fromkeys(
        MOST[family], True
    )


@pytest.mark.parametrize("family", MOST)
def test_twice_the_size_is_less_than_eight_times_the_work(family: str, counted: Counter[str]) -> None:
    small, large = work(family, 5, counted), work(family, 10, counted)
    for what in MOST[family]:
        few, many = small.get(what, 0), large.get(what, 0)
        assert many < 6 * max(few, 10), (what, few, many)


@pytest.mark.parametrize(("n", "operations"), [(2, 36), (4, 200), (8, 1040)])
def test_the_equations_of_a_chain_are_short(n: int, operations: int) -> None:
    motion = solved("links", n).solution.own.motion
    assert motion is not None
    assert sum(int(e.count_ops()) for e in motion.expressions) <= operations


VERDICTS = {  # on answers to ex. 18 in its angles: what they take today, and a tenth more
    "phi1'' + (g/l1)*sin(phi1) = 0": {"values at points": 60, "rows reduced": 18, "comparisons": 1},
    "(m1 + m2)*l1*phi1'' + m2*l2*phi2''*cos(phi1 - phi2) + m2*l2*phi2'^2*sin(phi1 - phi2) + (m1 + m2)*g*sin(phi1) = 0": {
        "values at points": 85,
        "rows reduced": 22,
        "comparisons": 1,
    },
}


@pytest.mark.parametrize("answer", VERDICTS, ids=["wrong", "right"])
def test_a_verdict_takes_no_more_than_before(
    answer: str, counted: Counter[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """In the one set of coordinates that it is written in, with the reference warm."""
    against = reference(load(PROBLEMS / "chapter6" / "ex18-double-pendulum.yaml"))
    check_equations([Fragment.of("0 = 0")], against)
    count(counted, monkeypatch, answers, "compare", "comparisons")
    counted.clear()
    check_equations([Fragment.of(answer)], against, diagnosing=False)
    found = {what: counted[what] for what in VERDICTS[answer]}
    assert all(found[what] <= most for what, most in VERDICTS[answer].items()), found
