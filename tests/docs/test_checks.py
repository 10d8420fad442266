"""docs/checks.md names every check that is made, and the numbers in it are those of the program."""

from __future__ import annotations

import ast
import re
from collections.abc import Callable, Iterator

import pytest

from lagrange.algebra.exact import prime_field
from lagrange.algebra.exact.points_needed import (
    AGREEMENT_POINTS,
    ZERO_POINTS,
    ZERO_POINTS_AFTER_ROOTS,
    ZERO_REAL_POINTS,
)
from lagrange.mechanics.solution import solve
from lagrange.problem.model import Problem
from tests.support.paths import ROOT
from tests.support.shared import solved

SOURCE = (ROOT / "docs" / "checks.md").read_text(encoding="utf-8")
PAGE = " ".join(SOURCE.replace("**", "").split())
BOLD = {" ".join(b.split()) for b in re.findall(r"\*\*(.+?)\*\*", SOURCE, re.DOTALL)}


def literal_names() -> Iterator[str]:
    """The names of checks that are written as they are: the first argument of `Check`."""
    texts = [path.read_text(encoding="utf-8") for path in sorted((ROOT / "lagrange").rglob("*.py"))]
    for text in (t for t in texts if "Check(" in t):
        for node in ast.walk(ast.parse(text)):
            if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "Check":
                match node.args[0]:
                    case ast.Constant(value=str(name)):
                        yield name
                    case ast.JoinedStr(values=[ast.Constant(value=str(beginning)), *_]):
                        yield beginning.strip(" :")


NAMES = sorted(set(literal_names()))


def test_there_are_names() -> None:
    assert len(NAMES) >= 15


@pytest.mark.parametrize("name", NAMES)
def test_the_page_names_the_check(name: str) -> None:
    assert any(name in b for b in BOLD)


@pytest.mark.parametrize(
    "name", ["chapter6/ex05-ice-skate", "chapter6/ex11-ideal-pendulum", "motion/sleigh", "statics/ladder"]
)
def test_the_page_names_what_is_checked(name: str) -> None:
    for check in solved(name).checks:
        bare = re.sub(r"(holds|fails) for .*|: .*|(?<=makes ).*|(?<=proportional to ).*", "", check.name).strip()
        assert any(bare in b or b in bare for b in BOLD), check.name
        assert bare in PAGE or bare.removeprefix("the ") in PAGE, check.name


def test_the_numbers_of_the_field() -> None:
    assert f"{prime_field.M:,}".replace(",", " ") in PAGE
    p = prime_field.Fields(seed=1).field().p
    assert 2**88 < p < 2**89
    assert (p + 1) // prime_field.M > 2**54


def test_the_numbers_of_points() -> None:
    assert (ZERO_POINTS, ZERO_POINTS_AFTER_ROOTS, AGREEMENT_POINTS) == (2, 10, 3)
    assert (
        "two points at least (ten where roots were taken to solve the constraints), every comparison of systems on three"
        in PAGE
    )
    assert ZERO_REAL_POINTS == 12


NEWTON = """
title: A wire that no closed formula places
parameters: [m, b, g]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
constraints: {wire: x*exp(x/b) + y*exp(2*y/b) + b*sin(x*y/b^2) = b}
gravity: -g*j
"""


def test_nothing_is_called_exact_at_points_of_newtons_iteration(problem: Callable[[str], Problem]) -> None:
    """Such points have eighty digits: the page says so, and so do the checks."""
    checks = solve(problem(NEWTON)).checks
    assert len(checks) >= 7
    assert all(c.passed for c in checks)
    assert not any("exact" in c.how for c in checks)
    assert sum("sixty digits" in c.how for c in checks) == len(checks)
    assert 'and the checks say "to sixty digits" where they otherwise say "exact"' in PAGE
