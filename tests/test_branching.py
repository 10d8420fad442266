"""Systems solved in closed form, against brute force at random values of the parameters (`solution_counts`)."""

from __future__ import annotations

import math
from random import Random

import mpmath
import pytest
import sympy as sp
from solution_counts import function, newton_solutions, roots

from lagrange.algebra.closed_forms.branching import solutions
from lagrange.algebra.closed_forms.solution_sets import Branch, SolutionSet

POSITIVE = {
    n: sp.Symbol(n, positive=True)
    for n in ["a", "b", "c", "d", "f", "g", "h", "k", "l", "m", "n", "p", "r", "w", "W", "M"]
}
ANGLES = {n: sp.Symbol(n, real=True) for n in ["theta", "phi", "psi"]}
PLAIN = {n: sp.Symbol(n, real=True) for n in ["x", "y", "z", "u", "v", "P", "Q"]}
ALPHA = {n: sp.Symbol(n, positive=True) for n in ("alpha", "beta")}
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
SYSTEMS = [
    (("theta - phi", "k*(2*theta - phi) - p*sin(theta - phi)"), "theta phi"),  # Ziegler's column: θ = φ is put in
    (("theta + phi", "a*sin(theta) + b*cos(phi) - c"), "theta phi"),
    (("theta - 2*phi", "a*sin(theta) - b*sin(phi)"), "theta phi"),
    (("y", "x*(k/(x^2 + y^2)^(3/2) - 3*n^2)"), "x y"),  # Hill's moon: y = 0 is put in under the root
    (("y - a", "x*(sqrt(x^2 + y^2) - b)"), "x y"),
    (("a*sin(theta) - P*cos(theta)", "b*sin(phi) - P*cos(phi)"), "theta phi"),
    (("k*x - k*(y - x) - a", "k*(y - x) - b"), "x y"),
    (("x - l*sin(theta)", "sin(theta)*(a*cos(theta) - b)"), "x theta"),
    (("l*cos(theta) - (u + v)*cos(alpha)", "l*sin(theta) - (v - u)*sin(alpha)", "a*sin(theta) - b*cos(theta)"),
     "u v theta"),
    (("2*x*u", "m*g + 2*y*u", "x^2 + y^2 - l^2"), "x y u"),
    (("x*y - a*x", "a*x - b*y"), "x y"),
    (("x^2 + y^2 - a^2 - b^2", "x - a"), "x y"),
    (("sin(theta)*cos(phi)*a", "b*sin(phi)"), "theta phi"),
    (("a*sin(theta) - b*sin(phi)", "phi*0 + sin(phi)*cos(phi)"), "theta phi"),
    (("u*x + a", "u*y + b", "u*z + c", "x^2 + y^2 + z^2 - l^2"), "x y z u"),
]  # fmt: skip


def read(text: str) -> sp.Expr:
    return sp.sympify(text.replace("^", "**"), locals=NAMES)


def values_of(expressions: list[sp.Expr], unknowns: list[sp.Symbol], random: Random) -> dict[sp.Symbol, sp.Rational]:
    symbols = sorted({s for e in expressions for s in e.free_symbols} - {*unknowns}, key=str)
    found = {s: sp.Rational(random.randint(20, 300), 100) for s in symbols}
    return found | {s: sp.Rational(random.randint(20, 130), 100) for s in symbols if s.name in ALPHA}


def coordinates(found: SolutionSet, b: Branch, unknowns: list[sp.Symbol], values: dict[sp.Symbol, sp.Rational]):
    """The unknowns at the real points of a branch: (cos, sin) of an angle, the number of another."""
    for point in b.points:
        numbers = []
        for u in unknowns:
            of_u = (sp.cos(u), sp.sin(u)) if found.letters.angle_of(u) else (u,)
            numbers += [found.at(point, e).xreplace(values).evalf(30) for e in of_u]
        if all(n.is_number and abs(sp.im(n)) < 1e-20 for n in numbers):
            yield [mpmath.mpf(str(sp.re(n))) for n in numbers]


def is_met(b: Branch, values: dict[sp.Symbol, sp.Rational]) -> bool:
    """Whether the conditions of a branch hold."""
    relations = {"≥": lambda a: a >= 0, "≤": lambda a: a <= 0, ">": lambda a: a > 0, "≠": lambda a: a != 0}
    differences = ((c.relation, (c.lhs - c.rhs).xreplace(values).evalf(30)) for c in b.conditions)
    return all(d.is_real and relations[r](d) for r, d in differences)


def apart(points: list[list[mpmath.mpf]]) -> list[list[mpmath.mpf]]:
    kept: list[list[mpmath.mpf]] = []
    for p in points:
        if not any(near(p, q) for q in kept):
            kept.append(p)
    return kept


def near(p: list[mpmath.mpf], q: list[mpmath.mpf]) -> bool:
    return all(abs(a - b) < 1e-5 * (1 + abs(a)) for a, b in zip(p, q, strict=True))


def predicted(found: SolutionSet, unknowns: list[sp.Symbol], values: dict[sp.Symbol, sp.Rational]) -> list:
    """The real points of all branches; a branch has some exactly where its conditions hold."""
    points = []
    for b in found.branches:
        if b.special:
            continue
        there = list(coordinates(found, b, unknowns, values))
        assert bool(there) == is_met(b, values), (b.relations, b.conditions, values)
        points += there
    return apart(points)


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


@pytest.mark.parametrize(("texts", "names"), SYSTEMS, ids=[", ".join(t) for t, _ in SYSTEMS])
def test_systems(texts: tuple[str, ...], names: str) -> None:
    """Newton's iteration finds no solution that is not there, and all that are there are solutions."""
    unknowns = [NAMES[n] for n in names.split()]
    equations = [read(t) for t in texts]
    found = solutions(equations, unknowns)
    assert found.solved
    assert found.verified
    random = Random(names)
    for _ in range(2):
        values = values_of(equations, unknowns, random)
        numeric = [e.xreplace(values) for e in equations]
        theirs = []
        for solution in newton_solutions(numeric, unknowns, random):
            point = []
            for u, v in zip(unknowns, solution, strict=True):
                point += [mpmath.cos(v), mpmath.sin(v)] if found.letters.angle_of(u) else [v]
            theirs.append(point)
        mine = predicted(found, unknowns, values)
        assert agree(mine, apart(theirs)), (found.branches, values, mine, theirs)


@pytest.mark.parametrize(
    ("text", "relation"),
    [("(W*a - M*b)*cos(theta)", "W*a = M*b"), ("W*a - M*b", "W*a = M*b"), ("(k*l - m*g)*sin(theta)", "k*l = m*g")],
)
def test_parameters_that_balance_in_every_position(text: str, relation: str) -> None:
    found = solutions([read(text)], [ANGLES["theta"]])
    [special] = [b for b in found.branches if b.special]
    [r] = special.relations
    lhs, rhs = map(read, relation.split(" = "))
    assert {r.lhs, r.rhs} == {lhs, rhs}


def test_a_sign_that_a_root_decides_is_stated() -> None:
    """a cos θ = √(b + c + b sin θ): of the two angles with that sine, the one with cos θ > 0, by its cosine."""
    found = solutions([read("a*cos(theta) - sqrt(b + c + b*sin(theta))")], [ANGLES["theta"]])
    for b in found.branches:
        assert {r.lhs for r in b.relations} == {sp.sin(ANGLES["theta"]), sp.cos(ANGLES["theta"])}


@pytest.mark.parametrize("text", ["W*a + M*b", "a*cos(theta) + a + b", "a*sin(theta) - a*2", "k*x^2 + m*g", "a"])
def test_no_solution(text: str) -> None:
    found = solutions([read(text)], [ANGLES["theta"], PLAIN["x"]])
    assert found.solved
    assert found.branches == ()


@pytest.mark.parametrize("text", ["k*theta - m*g*l*sin(theta)", "a*x - tan(x)*b", "a*theta*cos(theta) - b*sin(theta)"])
def test_what_is_seen_at_once_and_what_is_left(text: str) -> None:
    e = read(text)
    [u] = e.free_symbols - {*POSITIVE.values()}
    found = solutions([e], [u])
    assert not found.solved
    zero, rest = found.branches
    assert [(r.lhs, r.rhs) for r in zero.relations] == [(u, 0)]
    assert rest.left == (e,) or sp.expand(rest.left[0] - e) == 0 or rest.left[0].has(sp.sin(u))


@pytest.mark.parametrize("text", ["a*sin(theta) - b*cos(theta)^2 - c*sin(theta)*cos(theta)", "x^5 - a*x - b"])
def test_what_is_not_solved_stays_an_equation(text: str) -> None:
    e = read(text)
    [u] = e.free_symbols - {*POSITIVE.values()}
    found = solutions([e], [u])
    assert not found.solved
    [b] = found.branches
    assert b.relations == ()
    [left] = b.left
    assert sp.simplify(left / e).is_number


def test_work_is_bounded() -> None:
    """Ten coupled equations of high degree: refused soon, not worked at without end."""
    unknowns = sp.symbols("q0:10", real=True)
    equations = [
        sum(unknowns[(n + k) % 10] ** (k + 2) for k in range(5)) - sp.Symbol(f"c{n}", positive=True) for n in range(10)
    ]
    found = solutions(equations, unknowns)
    assert not found.solved
