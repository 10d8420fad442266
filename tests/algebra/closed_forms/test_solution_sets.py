"""What a set of solutions states: signs that a root decides, equations that are left."""

from __future__ import annotations

from functools import partial

import pytest
import sympy as sp

from lagrange.algebra.closed_forms.branching import solutions
from lagrange.algebra.closed_forms.solution_sets import Branch, parts, plain_sides
from lagrange.algebra.exact.zero_test import is_zero
from tests.support.found_solutions import ALPHA, POSITIVE
from tests.support.work import units

ANGLES = {n: sp.Symbol(n, real=True) for n in ["theta", "phi", "psi"]}
PLAIN = {n: sp.Symbol(n, real=True) for n in ["x", "y", "z", "u", "v", "P", "Q"]}
PLAIN |= {"F": sp.Symbol("F", positive=True)}
NAMES = {**POSITIVE, **ANGLES, **PLAIN, **ALPHA}


def read(text: str) -> sp.Expr:
    return sp.sympify(text.replace("^", "**"), locals=NAMES)


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


def stated(text: str, unknowns: str) -> list[dict[str, str]]:
    found = solutions([read(e) for e in text.split(";")], [read(u) for u in unknowns.split()])
    assert found.verified
    return [{str(r.lhs): str(r.rhs) for r in b.relations} for b in found.branches]


def test_signs_of_two_angles_that_belong_together() -> None:
    """cos θ (cos φ + sin φ) = sin θ: of the four points with tan θ = √2 and tan φ = 1 two are solutions."""
    branches = stated("cos(theta)*(cos(phi) + sin(phi)) - sin(theta); (cos(phi) - sin(phi))*sin(theta)", "theta phi")
    assert {"tan(theta)": "sqrt(2)", "phi": "pi/4"} in branches
    assert {"tan(theta)": "-sqrt(2)", "phi": "-3*pi/4"} in branches
    assert {"theta": "0", "tan(phi)": "-1"} in branches  # both signs: nothing to distinguish


def test_an_angle_given_by_sine_and_cosine() -> None:
    """Forces a and b across: φ is neither of the two angles with tan φ = b/a, but one."""
    branches = stated("W*sin(theta) - cos(theta)*(a*cos(phi) + b*sin(phi)); a*sin(phi) - b*cos(phi)", "theta phi")
    assert [set(b) for b in branches] == [{"tan(theta)", "sin(phi)", "cos(phi)"}] * 2


def test_signs_that_do_not_belong_together_stay_open() -> None:
    assert stated("a*sin(theta) - b*cos(theta); c*sin(phi) - b*cos(phi)", "theta phi") == [
        {"tan(theta)": "b/a", "tan(phi)": "b/c"}
    ]


@pytest.mark.parametrize(
    ("text", "origin", "pole"),
    [
        ("sin(theta)*(1 - 3*sqrt(1 - cos(theta)))", "sin(theta)*(1/sqrt(1 - cos(theta)) - 3)", {"theta": "0"}),
        ("sin(theta)*(a - b*(1 + cos(theta))^2)", "sin(theta)*(a/(1 + cos(theta))^2 - b)", {"theta": "pi"}),
        ("x*(a*x^2 - b)", "(a*x^2 - b)/x", {"x": "0"}),
        ("k*x*sqrt(x^2) - l*x", "k*x - l*x/sqrt(x^2)", {"x": "0"}),
    ],
)
def test_where_an_equation_has_no_value(text: str, origin: str, pole: dict[str, str]) -> None:
    unknown = [NAMES["x" if "x" in pole else "theta"]]
    found = solutions([read(text)], unknown, origin=[read(origin)])
    [place] = found.excluded
    assert {str(r.lhs): str(r.rhs) for r in place.relations} == pole
    assert all({str(r.lhs): str(r.rhs) for r in b.relations} != pole for b in found.branches)


def test_the_border_of_a_condition_may_be_a_pole() -> None:
    """k (x − l sign x) = −F has the root x = l − F/k where k l > F; for k l = F it would be x = 0."""
    found = solutions([read("k*x - k*l*x/sqrt(x^2) + F")], [NAMES["x"]])
    conditions = [(c.lhs, c.relation, c.rhs) for b in found.branches for c in b.conditions]
    assert conditions == [(NAMES["k"] * NAMES["l"], ">", NAMES["F"])]


def test_branches_within_others_are_dropped_with_what_is_left() -> None:
    """A circle contains its points with θ = 0; a condition is no part of a branch without it."""
    found = solutions(
        [read("(x^2 + y^2 - a^2)*sin(theta)"), read("(x^2 + y^2 - a^2)*(x - 5)")], symbols_of("x y theta")
    )
    assert sum(bool(b.left) for b in found.branches) == 1


def symbols_of(names: str) -> list[sp.Symbol]:
    return [NAMES[n] for n in names.split()]


def test_an_expression_at_a_point_is_put_together_once() -> None:
    """The value is that of all letters substituted in the whole; the work is not that of walking through it each time."""
    theta, x, b = ANGLES["theta"], PLAIN["x"], POSITIVE["b"]
    found = solutions([read("a*sin(theta) - b*cos(theta)"), read("x^2 - a*b")], [theta, x])
    harmonics = [sp.Symbol(f"s{k}") * (k * sp.sin(theta) + b * sp.cos(theta) * sp.cos(2 * theta)) for k in range(1, 40)]
    e = sp.Add(*harmonics, x**3, sp.sqrt(1 + sp.sin(theta)) / (2 + sp.tan(theta)))
    for point in [p for branch in found.branches for p in branch.points]:
        in_the_whole = partial(found._part_at, point, e)
        value = found.at(point, e)
        assert theta not in value.free_symbols
        assert x not in value.free_symbols
        assert is_zero(value - in_the_whole()) is True
        assert units(partial(found.at, point, e)) < units(in_the_whole) / 1.5


def test_the_parts_of_an_expression() -> None:
    theta, x, a = ANGLES["theta"], PLAIN["x"], POSITIVE["a"]
    e = (a + 3 * sp.sin(theta) ** 2) ** -2 * sp.sqrt(x + a) + sp.pi + sp.sin(theta) * abs(x)
    assert {*parts(e)} == {a, sp.sin(theta), sp.sqrt(x + a), abs(x)}


def test_sides_of_a_relation_between_positive_letters() -> None:
    h, r, x = sp.Symbol("h", positive=True), sp.Symbol("r", positive=True), sp.Symbol("x", real=True)
    assert plain_sides(3 * r**2 - h**2) == (h, sp.sqrt(3) * r)
    assert plain_sides(r**2 - x**2) == (r**2, x**2), "x may be negative"
    assert plain_sides(r**2 - 2 * h) == (r**2, 2 * h)
    assert plain_sides(r**2 + h**2 - 4 * x) == (r**2 + h**2, 4 * x)


def test_an_equation_between_two_angles_that_is_left_is_stated_by_their_tangents() -> None:
    a, b = ANGLES["theta"], ANGLES["phi"]
    length, c, w, q = sp.symbols("l c W Q", positive=True)
    closed = length * sp.cos(a) + length * sp.cos(b) - c

    def stated(e: sp.Expr, *others: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
        relation = Branch((), left=(*others, e)).equations[-1]
        return relation.lhs, relation.rhs

    chain = 3 * sp.cos(a) * sp.sin(b) - sp.sin(a) * sp.cos(b)
    assert stated(chain, closed) == (sp.tan(a), 3 * sp.tan(b))
    assert stated(chain.xreplace({a: b, b: a}), closed) == (sp.tan(b), 3 * sp.tan(a))
    weighted = (w + 2 * q) * sp.sin(a) * sp.cos(b) - q * sp.cos(a) * sp.sin(b)
    assert stated(sp.expand(weighted), closed) == (sp.tan(b), (w + 2 * q) / q * sp.tan(a))
    assert stated(chain) == (chain, 0), "both cosines may vanish"
    assert stated(sp.cos(a) * sp.cos(b) - sp.sin(a) * sp.sin(b), closed)[1] == 0
    difference = (w - q) * sp.sin(a) * sp.cos(b) - q * sp.cos(a) * sp.sin(b)
    assert stated(difference, closed) == (difference, 0), "the coefficient may vanish"
