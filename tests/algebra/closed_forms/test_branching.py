"""Systems solved in closed form, against brute force at random values of the parameters (`solution_counts`)."""

from __future__ import annotations

from random import Random

import mpmath
import pytest
import sympy as sp

from lagrange.algebra.closed_forms.branching import solutions
from tests.support.found_solutions import ALPHA, POSITIVE, apart, near, predicted, values_of
from tests.support.solution_counts import newton_solutions

ANGLES = {n: sp.Symbol(n, real=True) for n in ["theta", "phi", "psi"]}
PLAIN = {n: sp.Symbol(n, real=True) for n in ["x", "y", "z", "u", "v", "P", "Q"]}
x, y = PLAIN["x"], PLAIN["y"]
NAMES = {**POSITIVE, **ANGLES, **PLAIN, **ALPHA}

SYSTEMS = [
    (("theta - phi", "k*(2*theta - phi) - p*sin(theta - phi)"), "theta phi"),  # Ziegler's column: θ = φ is put in
    (("theta + phi", "a*sin(theta) + b*cos(phi) - c"), "theta phi"),
    (("theta - 2*phi", "a*sin(theta) - b*sin(phi)"), "theta phi"),
    (("y", "x*(k/(x^2 + y^2)^(3/2) - 3*n^2)"), "x y"),  # Hill's moon: y = 0 is put in under the root
    (("y - a", "x*(sqrt(x^2 + y^2) - b)"), "x y"),
    (("x*sin(theta)*(sqrt(x^2 + 2*l*x*cos(theta) + l^2) - sqrt(x^2 - 2*l*x*cos(theta) + l^2))", "x - a"), "x theta"),
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
    (("sin(theta) + sin(phi) - a", "sin(theta - phi)"), "theta phi"),  # θ = φ or φ + π
    (("a*sin(theta) + b*cos(phi) - c", "sin(theta + phi)"), "theta phi"),
    (("u*x + a", "u*y + b", "u*z + c", "x^2 + y^2 + z^2 - l^2"), "x y z u"),
]  # fmt: skip


def read(text: str) -> sp.Expr:
    return sp.sympify(text.replace("^", "**"), locals=NAMES)


def agree(mine: list, theirs: list) -> bool:
    return len(mine) == len(theirs) and all(any(near(p, q) for q in theirs) for p in mine)


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


def test_work_is_bounded() -> None:
    """Ten coupled equations of high degree: refused soon, not worked at without end."""
    unknowns = sp.symbols("q0:10", real=True)
    equations = [
        sum(unknowns[(n + k) % 10] ** (k + 2) for k in range(5)) - sp.Symbol(f"c{n}", positive=True) for n in range(10)
    ]
    found = solutions(equations, unknowns)
    assert not found.solved


def test_a_divisor_that_vanishes_later() -> None:
    """The multipliers of a linkage: u = v cot φ in the branch sin φ = 0 would be 0/0, and was kept as a number."""
    texts = [
        "a*v*cos(theta) - a*u*sin(theta) - M", "v*cos(phi) - u*sin(phi)", "W + c*u*sin(psi) - c*v*cos(psi)",
        "a*cos(theta) + b*cos(phi) - c*cos(psi) - d", "a*sin(theta) + b*sin(phi) - c*sin(psi)",
    ]  # fmt: skip
    multipliers = [PLAIN["u"], PLAIN["v"]]
    found = solutions([read(e) for e in texts], [*ANGLES.values(), *multipliers], multipliers)
    assert all(not v.has(sp.nan, sp.zoo) for b in found.branches for p in b.points for v in p.values())


def test_the_root_of_several_unknowns() -> None:
    """√(x² + y²) = l is x² + y² = l²; √(x² + y²) = −l has no solution, and neither has √(x² + y²) = 0 with = l."""
    x, y = PLAIN["x"], PLAIN["y"]
    [branch] = solutions([read("sqrt(x^2 + y^2) - l")], [x, y]).branches
    assert [sp.expand(e) for e in branch.left] == [x**2 + y**2 - POSITIVE["l"] ** 2]
    assert solutions([read("sqrt(x^2 + y^2) + l")], [x, y]).branches == ()
    assert solutions([read("sqrt(x^2 + y^2)"), read("sqrt(x^2 + y^2) - l")], [x, y]).branches == ()


def test_what_was_divided_by_and_cancels_is_no_condition() -> None:
    """Two beads on a turning rod, joined by a spring: x = y = 2a k/(2k - m w²), where k = m w² too."""
    a, k, m, w = sp.symbols("a k m w", positive=True)
    x, y = sp.symbols("x y", real=True)
    pull = k * (x + y - 2 * a)
    [b] = solutions([m * w**2 * x - pull, m * w**2 * y - pull], [x, y]).branches
    assert [(c.lhs, c.relation, c.rhs) for c in b.conditions] == [(m * w**2, "≠", 2 * k)]
    for r in b.relations:
        assert sp.cancel(r.rhs - 2 * a * k / (2 * k - m * w**2)) == 0
    [c] = solutions([(k - m) * x, x * y - a * x, y - m], [x, y]).branches[:1]
    assert {r.lhs: r.rhs for r in c.relations} == {x: 0, y: m}


def test_three_spheres_meet_where_their_differences_are_planes() -> None:
    x, y, z = sp.symbols("x y z", real=True)
    l, b, c = sp.symbols("l b c", positive=True)
    side = [x**2 + (y + s * b) ** 2 + (z - c) ** 2 - l**2 - b**2 - c**2 for s in (1, -1)]
    found = solutions([x**2 + y**2 + z**2 - l**2, *map(sp.expand, side)], [x, y, z])
    values = [{r.lhs: r.rhs for r in branch.relations} for branch in found.branches]
    assert not any(branch.left for branch in found.branches)
    assert sorted(str(v[x]) for v in values) == ["-l", "l"]


def test_no_branch_repeats_the_origin() -> None:
    """Of V = x⁴ + y⁴ + x² y² the origin is the only place of rest: 2x² + y² = 0 = x² + 2y² is no other one."""
    found = solutions([x * (2 * x**2 + y**2), y * (x**2 + 2 * y**2)], [x, y])
    assert [{str(r.lhs): r.rhs for r in b.relations} for b in found.branches] == [{"x": 0, "y": 0}]
    assert found.solved


def test_an_angle_without_letters_may_still_be_zero() -> None:
    """sin θ = c sin((1 + b/a) θ), of a rocking stone: θ = 0 is a solution, and others are left to numbers."""
    a, b = sp.symbols("a b", positive=True)
    theta = ANGLES["theta"]
    found = solutions([(a + b) * sp.sin(theta) - b * (1 + b / a) * sp.sin(theta * (1 + b / a))], [theta])
    assert [([(r.lhs, r.rhs) for r in br.relations], len(br.left)) for br in found.branches] == [
        ([(theta, 0)], 0),
        ([], 1),
    ]
    assert [(c.lhs, c.relation, c.rhs) for c in found.branches[1].conditions] == [(theta, "≠", 0)]
    [other] = solutions([sp.cos(theta) - b * sp.cos(theta * (1 + b / a))], [theta]).branches
    assert other.left


def test_a_root_whose_radicand_is_known_is_a_number() -> None:
    """|r| is b where r = −b: cos θ = k (l − b)/w follows."""
    r, theta = sp.symbols("r theta", real=True)
    b, k, l, w = sp.symbols("b k l w", positive=True)
    found = solutions([(r + b) * sp.sin(theta), w * sp.cos(theta) - k * (r - l * sp.sign(r))], [r, theta])
    assert found.solved
    assert any(
        q.lhs == sp.cos(theta) and sp.expand(q.rhs * w - k * (l - b)) == 0 for e in found.branches for q in e.relations
    )
