"""Redundant constraints with their combination, places where the rank drops, constraints that exclude one another.

Combinations are multiplied out at random points, ranks at special places are taken by SymPy at such a place.
"""

from __future__ import annotations

from collections.abc import Callable

import pytest
import sympy as sp

from lagrange.core.diagnostics import ProblemError
from lagrange.core.symbols import Slots, t
from lagrange.explain.report import report
from lagrange.mechanics.constraints import degeneracies
from lagrange.mechanics.constraints.classification import classify
from lagrange.mechanics.constraints.degeneracies import RankLoss
from lagrange.mechanics.solution import solve
from lagrange.problem.model import Problem
from lagrange.render.json import as_object
from tests.support.exterior import rank, real_point
from tests.support.work import units

Read = Callable[[str], Problem]


def text(coordinates: str, constraints: str, parameters: str = "[R, l, b, omega]") -> str:
    return f"title: T\nparameters: {parameters}\ncoordinates: [{coordinates}]\nconstraints: {{{constraints}}}\n"


SKATE_A = "p: \"sin(a)*x' - cos(a)*y' = 0\""
SKATE_C = "q: \"sin(c)*x' - cos(c)*y' = 0\""
SIDE = "s: \"sin(theta)*x' - cos(theta)*y' = 0\""
WHEELS = (
    f"{SIDE}, f: \"cos(theta)*x' + sin(theta)*y' + b*theta' = R*u'\", "
    "g: \"cos(theta)*x' + sin(theta)*y' - b*theta' = R*v'\""
)

# Redundancy.

REDUNDANT = {
    "sum": ("x, y, z", "p: x = y, q: y = z, r: x = z", {"r": {"p": "1", "q": "1"}}),
    "numbers": ("x, y, z", "p: \"x' + z*y' = 0\", q: \"y' = z'\", r: \"x' + (z + 2)*y' - 2*z' = 0\"",
                {"r": {"p": "1", "q": "2"}}),
    "functions": ("x, y, z", "p: \"x' + sin(x)*y' = 0\", q: \"z' = y'\", r: \"x'*z + sin(x)*z'*z + z' = y'\"",
                  {"r": {"p": "z", "q": "z*sin(x) + 1"}}),
    "parameters": ("x, y", "p: \"x' = R*y'\", q: \"l*x' - l*R*y' = 0\"", {"q": {"p": "l"}}),
    "drift": ("x, y, z", "p: \"x' = y*t\", q: \"z' = 2*t\", r: \"z' + x'*y = y^2*t + 2*t\"", {"r": {"p": "y", "q": "1"}}),
    "a hidden relation, given": ("x, y, theta, u, v", f"{WHEELS}, r: R*(u - v) = 2*b*theta", {"r": {"f": "-1", "g": "1"}}),
    "twice": ("x, y", "p: x^2 + y^2 = l^2, q: 2*x^2 + 2*y^2 = 2*l^2, r: \"x*x' + y*y' = 0\"",
              {"q": {"p": "2"}, "r": {"p": "1/2"}}),
    "on the surface": ("x, y, z", "p: z = 0, q: \"x' = 0\", r: \"x' + z*y' + 3*z' = 0\"", {"r": {"p": "3", "q": "1"}}),
    "on no surface": ("x, y, z", "q: \"x' = 0\", r: \"x' + z*y' = 0\"", {}),
    "off by a little": ("x, y, z", "p: \"x' + z*y' = 0\", q: \"y' = z'\", r: \"x' + (z + 2)*y' - 3*z' = 0\"", {}),
}  # fmt: skip


@pytest.mark.parametrize("name", REDUNDANT)
def test_redundant_constraints_have_their_combination(problem: Read, name: str) -> None:
    coordinates, constraints, expected = REDUNDANT[name]
    read = problem(text(coordinates, constraints))
    found = solve(read).classification
    assert found.redundant == tuple(expected)
    symbols = {s.name: s for c in found.constraints for a in c.row.form for s in a.free_symbols}
    symbols |= {q.name: q for q in read.slots.coordinates}
    forms = {c.row.name: c.row.form for c in found.constraints}
    for r in found.redundancies:
        assert r.combination is not None
        assert dict(r.combination) == {n: sp.sympify(c, locals=symbols) for n, c in expected[r.name].items()}
        surface = {read.slots.coordinates[2]: sp.S.Zero} if name == "on the surface" else {}
        for k, a in enumerate(forms[r.name]):
            assert sp.expand((a - sum(c * forms[n][k] for n, c in r.combination)).xreplace(surface)) == 0


def test_a_long_combination_is_only_named(problem: Read) -> None:
    rows = [f"(2 + sin(x + {n}*y))*x' + {n}*z*y' + w^{n}*z' + {n}*y*w'" for n in range(1, 4)]
    total = " + ".join(f"(y^{n} + cos(w + {n}*z))*({row})" for n, row in enumerate(rows, start=1))
    listed = ", ".join(f'{name}: "{row} = 0"' for name, row in zip("pqsr", [*rows, total], strict=True))
    found = solve(problem(text("x, y, z, w", listed))).classification
    [r] = found.redundancies
    assert (r.name, r.combination) == ("r", None)


def test_the_combination_is_in_the_prose_and_the_names_in_json(problem: Read) -> None:
    found = as_object(report(problem(text(*REDUNDANT["numbers"][:2]))))
    assert found["classification"]["redundant"] == ["r"]
    assert "eta_3 = eta_1 + 2*eta_2" in str(found["steps"])


# Loss of rank: where it is, and what the rank is there; (), [] where nothing is to be said.

LOSSES = {
    "rod by velocities": ("x, y", "p: \"x*x' + y*y' = 0\"", [("x, y", 0)]),
    "two blades at one point": ("x, y, a, c", f"{SKATE_A}, {SKATE_C}", [("sin(a - c)", 1)]),
    "cone": ("x, y, z", "p: x^2 + y^2 = z^2", [("x, y, z", 0)]),
    "said by the others": ("x, y, z", "p: \"x*y' - y*x' = (x^2 + y^2)*z'\"", [("x, y", 0)]),
    "figure of eight": ("x, y", "p: (x^2 + y^2)^2 = b^2*(x^2 - y^2)", [("x, y", 0)]),
    "crossed lines": ("x, y", "p: x*y = 0", [("x, y", 0)]),
    "three axes": ("x, y, z", "p: \"y*z*x' + 2*x*z*y' + 3*x*y*z' = 0\"", [("x, y", 0), ("y, z", 0), ("x, z", 0)]),
    "slot": ("x, y, z", "p: \"x*y' = z'*x\", q: \"y' = x'\"", [("x", 1)]),
    "turned": ("x, y, z", "p: \"x' = y*z'\", q: \"x' = -y*z'\"", [("y", 1)]),
    "not to be solved": ("x, y, z", "p: \"x' = (y + 1)*z'\", q: \"x' = (exp(y) - x)*z'\"", None),
    "skate": ("x, y, theta", SIDE, []),
    "car": ("x, y, theta, phi", f"{SIDE}, q: \"sin(theta + phi)*x' - cos(theta + phi)*y' = b*cos(phi)*theta'\"", []),
    "never zero": ("x, y", "p: \"(x^2 + 1)*x' + exp(x)*y' = 0\"", []),
    "square and one": ("x, y", "p: \"(x^2 + 1)*x' + (x^2 + 1)*y' = 0\"", []),
    "blades at a right angle": ("x, y, a, c", f"r: a = c + pi/2, {SKATE_A}, {SKATE_C}", []),
    "blades at a fixed angle": ("x, y, a", f"{SKATE_A}, q: \"sin(a + b)*x' - cos(a + b)*y' = 0\"", []),
    "plane": ("x, y, z", "p: x + y = b, q: z = 0", []),
}  # fmt: skip


@pytest.mark.parametrize("name", LOSSES)
def test_places_where_the_rank_drops(problem: Read, name: str) -> None:
    coordinates, constraints, expected = LOSSES[name]
    read = problem(text(coordinates, constraints))
    found = solve(read).classification
    symbols = {q.name: q for q in read.slots.coordinates}

    def written(losses: tuple[RankLoss, ...]) -> list[tuple[tuple[sp.Expr, ...], int | None]]:
        return [(loss.conditions, loss.rank) for loss in losses if not loss.excluded]

    if expected is None:
        assert all(loss.rank is None or loss.rank < found.rank for loss in found.losses)
        return
    wanted = [(tuple(sp.sympify(c, locals=symbols) for c in some.split(",")), fewer) for some, fewer in expected]
    assert written(found.losses) in (wanted, [((-c[0], *c[1:]), r) for c, r in wanted])
    rows = [list(c.row.coefficients) for c in found.constraints]
    constants = {s for row in rows for a in row for s in a.free_symbols}
    for conditions, fewer in wanted:
        place = {s: sp.S.Zero for s in conditions if s.is_Symbol}
        if not place:
            [condition] = conditions
            place = {symbols["a"]: symbols["c"]} if condition.has(symbols.get("a", t)) else {symbols["y"]: sp.S.Zero}
        there = [[a.xreplace(place) for a in row] for row in rows]
        point = real_point((), (), list(constants | {*symbols.values()}), 3)
        assert rank(there, point) == fewer < rank(rows, point)


EXCLUDED = {
    "pendulum": ("x, y", "rod: x^2 + y^2 = l^2", [("x, y", "rod", ("rod",))]),
    "two rods": ("x, y, u, v", "one: x^2 + y^2 = l^2, two: (x - u)^2 + (y - v)^2 = b^2",
                 [("x, y", "one", ("one",)), ("u - x, v - y", "two", ("two",))]),
    "circle by two surfaces": ("x, y, z", "ball: x^2 + y^2 + z^2 = l^2, pipe: x^2 + y^2 = R^2",
                               [("x, y, z", "ball", ("ball",)), ("x, y", "pipe", ("pipe",))]),
}  # fmt: skip


@pytest.mark.parametrize("name", EXCLUDED)
def test_places_that_constraints_exclude(problem: Read, name: str) -> None:
    coordinates, constraints, expected = EXCLUDED[name]
    read = problem(text(coordinates, constraints))
    found = solve(read).classification.losses
    symbols = {q.name: q for q in read.slots.coordinates}
    functions = {c.name: c.function for c in read.constraints}
    assert [(loss.vanishing, loss.excluded, loss.rank) for loss in found] == [(v, by, None) for _, v, by in expected]
    for loss, (conditions, *_) in zip(found, expected, strict=True):
        wanted = {sp.sympify(c, locals=symbols) for c in conditions.split(",")}
        assert {c if c in wanted else -c for c in loss.conditions} == wanted
        place = sp.solve(list(loss.conditions), list(symbols.values()), dict=True)
        for by in loss.excluded:
            assert all(sp.expand(functions[by].subs(p)).is_negative for p in place)


def test_special_configurations_are_said(problem: Read) -> None:
    def classified(*some: str) -> str:
        steps = as_object(report(problem(text(*some))))["steps"]
        return str(next(s for s in steps if s["rule"] == "classification"))

    assert "only where x = y = 0, which the rod constraint excludes" in classified(*EXCLUDED["pendulum"][:2])
    assert "Where x = y = 0, y = z = 0 or x = z = 0, the form" in classified(*LOSSES["three axes"][:2])
    field_line = classified("r, theta", "p: \"r'*sin(theta) = 2*r*theta'*cos(theta)\"")
    assert "Where sin(theta) = r = 0, the form" in field_line  # cos(theta) = 0 goes with no sin(theta) = 0
    said = classified(*LOSSES["two blades at one point"][:2])
    assert "Where sin(a - c) = 0, the constraints are not independent: the rank is 1 there, not 2." in said
    assert "Where" not in classified(*LOSSES["skate"][:2])


# Contradictions.


@pytest.mark.parametrize(
    ("coordinates", "constraints", "named"),
    [
        ("x, y", 'p: "x\' = 1 + y^2", q: "x\' = 0", r: "y\' = 0"', "pq"),
        ("x, y", 'p: x = 0, q: "x*y\' = 1"', "pq"),
        ("x, y, z", "k: y = 3, p: z = 3, q: x = 0, r: \"x*y' + z' = 1\"", "pqr"),
        ("x, y, z", 'p: "z\' = y*x\'", q: "y\' = 0", r: z = x*y + t', "pqr"),
        ("x, y, theta, u, v", f"{WHEELS}, k: theta = 0, r: u = v + omega*t", "fgkr"),
        ("x, y, z", 'p: "x\' = R", q: "y\' = x\'", k: "z\' = y\'", r: "y\' = l"', "pqr"),
        ("x, y", 'p: "x\' = t", q: "x\' = 0"', "pq"),
    ],
)
def test_contradictions_name_what_they_need_and_no_more(
    problem: Read, coordinates: str, constraints: str, named: str
) -> None:
    with pytest.raises(ProblemError) as caught:
        solve(problem(text(coordinates, constraints)))
    [found] = caught.value.diagnostics
    assert found.code == "contradictory-constraints"
    assert sorted(part for part in found.message.split("`")[1::2]) == sorted(named)


@pytest.mark.parametrize(
    ("coordinates", "constraints", "condition", "independent"),
    [
        ("x, y", 'p: x = 0, q: "x\' = y"', "y", 2),
        ("x, y, z", 'p: "x\' = y*t", q: "z\' = 2*t", r: "z\' + x\'*y = 2*t"', "y", 3),
        ("x, y, z", 'p: "x\' = sin(y)", q: "x\' = cos(y)"', None, 0),
    ],
)
def test_constraints_that_need_one_more(
    problem: Read, coordinates: str, constraints: str, condition: str | None, independent: int
) -> None:
    """x = 0 with x' = y is no contradiction: it holds where y = 0, and once that is stated all is well."""
    with pytest.raises(ProblemError) as caught:
        solve(problem(text(coordinates, constraints)))
    [found] = caught.value.diagnostics
    assert found.code == "unstated-condition"
    if condition:
        assert f"require {condition} = 0" in found.message
        assert (
            solve(problem(text(coordinates, f"{constraints}, more: {condition} = 0"))).classification.rank
            == independent
        )


def test_a_factor_in_many_cases_is_multiplied_out_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where y z, x z and x y vanish: eight choices of factors, which are three."""
    x, y, z = sp.symbols("x y z", real=True)
    factors = [q**2 + q - 1 for q in (x, y, z)]
    asked: list[sp.Expr] = []
    real = degeneracies.multiplied_out

    def multiplied_out(e: sp.Expr) -> sp.Expr:
        asked.append(e)
        return real(e)

    monkeypatch.setattr(degeneracies, "multiplied_out", multiplied_out)
    pairs = [factors[1] * factors[2], factors[0] * factors[2], factors[0] * factors[1]]
    cases = degeneracies._cases(pairs, Slots((x, y, z)))
    assert {frozenset(c) for c in cases} == {frozenset(factors) - {f} for f in factors}
    assert sorted(asked, key=str) == sorted(factors, key=str)


def test_nested_functions_are_differentiated_only_where_a_derivative_decides(problem: Read) -> None:
    """f(f(... f(x + y, y) ..., y), y) = l: both derivatives are products of many functions, none of which is zero at 0."""
    nested = "x + y"
    for _ in range(10):
        nested = f"f({nested}, y)"
    read = problem(text("x, y", f"c: '{nested} = l'", "[l]") + "functions: {f: [X, Y]}\n")
    assert units(lambda: classify(read)) < 150_000
