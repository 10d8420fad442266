"""One equation in one unknown, against brute force."""

from __future__ import annotations

import math
from random import Random

import mpmath
import pytest
import sympy as sp

from lagrange.algebra.closed_forms.branching import solutions
from lagrange.algebra.closed_forms.single_equation import Relation, parallel_angles
from lagrange.algebra.closed_forms.unit_circle import TrigLetters
from tests.support.found_solutions import ALPHA, POSITIVE, apart, near, predicted, values_of
from tests.support.solution_counts import function, roots

ANGLES = {n: sp.Symbol(n, real=True) for n in ["theta", "phi", "psi"]}
PLAIN = {n: sp.Symbol(n, real=True) for n in ["x", "y", "z", "u", "v", "P", "Q"]}
NAMES = {**POSITIVE, **ANGLES, **PLAIN, **ALPHA}
ONE_ANGLE = [
    "sin(theta)",
    "cos(theta)",
    "a*sin(theta)*(b*cos(theta) - c)",
    "tan(theta) - (2*k - 1)/tan(alpha)",
    "k*cos(theta) - sin(alpha)*cos(alpha - theta)/sin(2*alpha)",
    "a*sin(theta) - b*cos(theta)",
    "a*sin(theta) + b*cos(theta) - c",
    "a*sin(theta - alpha) + b*cos(theta)",
    "a*cos(2*theta) - b*cos(theta)",
    "a*cos(2*theta) - b*sin(theta)",
    "a*sin(2*theta) - b*cos(theta)",
    "a*sin(2*theta) - b*sin(theta)",
    "a*sin(theta)*cos(theta) + b*cos(theta)^2 - c",
    "a*sin(theta)^2 - b*cos(theta)^2",
    "a*sin(theta)^2 - b",
    "a*cos(theta)^3 - b",
    "a*tan(theta)^3 - b",
    "a*cos(theta)^2*sin(theta) - b*sin(theta)^3",
    "a*(1 - cos(theta)) - b*sin(theta)",
    "a*sin(theta) - b*sin(theta/2)",
    "a*cos(theta/2) - b*sin(theta)",
    "a*sin(theta/2)^2 - b*cos(theta/2)^2",
    "a*sin(3*theta)",
    "cos(theta)*(a*sin(theta) - b)*(a*cos(theta) + 2*a)",
    "(cos(theta) - 1)*(a*cos(theta) - b)",
    "a*sin(theta) - b*tan(theta)",
    "a*sin(theta)*(sqrt(2*l^2 - 2*l^2*cos(theta)) - d) - b*sin(theta)*sqrt(2*l^2 - 2*l^2*cos(theta))",
    "a*sin(theta)/sqrt(b + c + b*cos(theta)) - k*sin(theta)",
    "a*cos(theta) - b*sin(theta)*cos(theta) + a*sin(theta)*cos(theta)",
    "a*sin(theta) + a*cos(theta) - a",
    "a*sin(2*theta) + b*cos(2*theta)",
    "a*cos(theta) - sqrt(b + c + b*sin(theta))",
    "a*sin(theta) - sqrt(b + c - b*cos(theta))",
    "a*cos(theta) + b*sqrt(c + d + c*cos(theta))",
    "a + b + c*cos(theta) + (a + b)*cos(theta)",
]
ONE_PLAIN = [
    "k*x - m*g",
    "k*x^2 - m*g",
    "k*x^2 + m*g",
    "a*x^2 - b*x - c",
    "a*x^3 - b*x",
    "x^4 - 3*a*x^2 + 2*a^2",
    "a*x^3 + b",
    "k*x - W*x/sqrt(x^2 + a^2)",
    "W - 2*a*x/sqrt(x^2 + b^2)",
    "W - a*x/sqrt(x^2 + b^2) - k*x*0",
    "k*(sqrt(x^2 + a^2) - l)*x/sqrt(x^2 + a^2)",
    "a/x^2 - b*x",
    "a/x - b*x",
    "(x - a)*(x + b)*(x^2 + c)",
    "(a + k)*x - (b - c)*a",
]


def read(text: str) -> sp.Expr:
    return sp.sympify(text.replace("^", "**"), locals=NAMES)


def agree(mine: list, theirs: list) -> bool:
    return len(mine) == len(theirs) and all(any(near(p, q) for q in theirs) for p in mine)


@pytest.mark.parametrize("text", ONE_ANGLE)
def test_all_angles(text: str) -> None:
    theta = ANGLES["theta"]
    e = read(text)
    found = solutions([e], [theta])
    assert found.solved
    assert found.verified
    random = Random(text)
    met = 0
    for _ in range(4):
        values = values_of([e], [theta], random)
        f = function(e.xreplace(values), [theta])
        turns = 2 if "theta/2" in text else 1
        brute = roots(f, -math.pi * turns, math.pi * turns)
        theirs = apart([[mpmath.cos(x), mpmath.sin(x)] for x in brute])
        assert agree(predicted(found, [theta], values), theirs), (found.branches, values, brute)
        met += len(theirs)
    assert met > 0 or not found.branches


@pytest.mark.parametrize("text", ONE_PLAIN)
def test_all_numbers(text: str) -> None:
    x = PLAIN["x"]
    e = read(text)
    found = solutions([e], [x])
    assert found.solved
    assert found.verified
    random = Random(text)
    for _ in range(4):
        values = values_of([e], [x], random)
        brute = roots(function(e.xreplace(values), [x]), -37, 37, 4000)
        mine = [p for p in predicted(found, [x], values) if abs(p[0]) < 37]
        assert agree(mine, [[r] for r in brute]), (found.branches, values, brute)


@pytest.mark.parametrize("text", ["k*theta - m*g*l*sin(theta)", "a*x - tan(x)*b", "a*theta*cos(theta) - b*sin(theta)"])
def test_what_is_seen_at_once_and_what_is_left(text: str) -> None:
    e = read(text)
    [u] = e.free_symbols - {*POSITIVE.values()}
    found = solutions([e], [u])
    assert not found.solved
    zero, rest = found.branches
    assert [(r.lhs, r.rhs) for r in zero.relations] == [(u, 0)]
    assert rest.left == (e,) or sp.expand(rest.left[0] - e) == 0 or rest.left[0].has(sp.sin(u))


def test_parallel_angles() -> None:
    a, b, c = sp.symbols("a b c", real=True)
    letters = TrigLetters([sp.cos(a), sp.cos(b), sp.cos(c)], (a, b, c))
    for e, expected in {
        3 * sp.sin(a) * sp.cos(b) - 3 * sp.cos(a) * sp.sin(b): (a, b, 1),
        sp.cos(a) * sp.sin(c) + sp.sin(a) * sp.cos(c): (a, c, -1),
        2 * sp.sin(a) * sp.cos(b) - sp.cos(a) * sp.sin(b): None,
        sp.cos(a) * sp.cos(b) - sp.sin(a) * sp.sin(b): None,
    }.items():
        assert parallel_angles(letters.read(e), (a, b, c), letters) == expected


def test_what_the_square_of_a_rate_makes_positive() -> None:
    m, k = sp.symbols("m k", positive=True)
    v, r, n = sp.symbols("v r n", real=True)
    assert Relation(v**2, k / (m * r**3)).positive == (r,)
    assert Relation(v**2, k * (1 + k / r**2) / r**3).positive == (r,)
    assert Relation(v**2, k * r ** (n - 1) / m).positive == (r,)
    assert Relation(v**2, k / (m * r**2)).positive == ()
    assert Relation(v**2, k * (n - m) / r).positive == ()
    assert Relation(v, k / r).positive == ()
