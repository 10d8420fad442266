"""One-sided constraints: forces to the permitted side, as long as what contact lasts, against formulas by hand.

The prose about forces that coordinates alone imply, and about supports that can only push.
"""

from __future__ import annotations

import json
from collections.abc import Callable

import pytest
import sympy as sp

from lagrange.document.derivation import Detail
from lagrange.explain.report import report
from lagrange.mechanics.results import Solution
from lagrange.mechanics.solution import solve
from lagrange.problem.model import Problem
from lagrange.render import json as in_json
from lagrange.render import terminal
from tests.support import shared

Read = Callable[[str], Problem]

BEAD = """title: Bead
parameters: [m, g, l, alpha]
coordinates: [x, y]
particles: {{P: {{mass: m, position: x*i + y*j}}}}
constraints: {{c: {{equation: "{equation}"{more}}}}}
gravity: -g*j
"""
PLACE = {"m": 2, "g": 10, "l": 5, "alpha": sp.pi / 3, "x": 3, "y": 4, "x'": 4, "y'": -3}


def solved(problem: Read, equation: str, more: str = ", reaction: N") -> Solution:
    solution = solve(problem(BEAD.format(equation=equation, more=more)))
    assert [c.name for c in solution.checks if c.passed is not True] == []
    return solution


def number(e: sp.Expr, values: dict[str, object]) -> sp.Expr:
    return sp.nsimplify(e.xreplace({s: sp.sympify(values[s.name]) for s in e.free_symbols}))


# On the circle at (3, 4) with v² = 25, the force along the outward normal is m (g·4/5 − v²/l) = 2 (8 − 5) = 6.
@pytest.mark.parametrize(
    ("equation", "force", "direction", "pulls"),
    [
        ("x^2 + y^2 <= l^2", -6, (-0.6, -0.8), True),
        ("l^2 >= x^2 + y^2", -6, (-0.6, -0.8), True),
        ("sqrt(x^2 + y^2) <= l", -6, (-0.6, -0.8), True),
        ("l ≥ sqrt(x^2 + y^2)", -6, (-0.6, -0.8), True),
        ("l - norm(r_P) >= 0", -6, (-0.6, -0.8), True),
        ("x^2 + y^2 >= l^2", 6, (0.6, 0.8), False),
        ("l^2 ⩽ x^2 + y^2", 6, (0.6, 0.8), False),
        ("l <= norm(r_P)", 6, (0.6, 0.8), False),
        ("y >= 0", 20, (0, 1), False),
        ("0 <= y", 20, (0, 1), False),
        ("3*y >= 0", 20, (0, 1), False),
        ("y <= 0", -20, (0, -1), False),
        ("y >= x*tan(alpha)", 10, (-sp.sqrt(3) / 2, 0.5), False),
        ("x*sin(alpha) - y*cos(alpha) <= 0", 10, (-sp.sqrt(3) / 2, 0.5), False),
    ],
)
def test_the_force_points_to_the_permitted_side(
    problem: Read, equation: str, force: int, direction: tuple[float, float], pulls: bool
) -> None:
    solution = solved(problem, equation)
    assert solution.own.dynamics is not None
    reactions = solution.own.dynamics.reactions
    assert reactions is not None
    assert number(reactions.sizes["c"], PLACE) == force
    assert number(reactions.contacts["c"], PLACE) == force
    assert ("c" in reactions.pulling) is pulls
    for component, wanted in zip(reactions.units["c"].components, direction, strict=False):
        assert abs(number(component, PLACE) - wanted) < 1e-12


def test_without_a_name_the_multiplier_has_the_sign_of_the_side(problem: Read) -> None:
    reactions = solved(problem, "y <= 0", "").own.dynamics.reactions
    assert reactions.multipliers["c"] == -reactions.contacts["c"]
    assert number(reactions.contacts["c"], PLACE) == -20


def test_inside_a_bowl_it_is_a_surface(problem: Read) -> None:
    reactions = solved(problem, "x^2 + y^2 <= l^2", ", reaction: N, by: surface").own.dynamics.reactions
    assert number(reactions.contacts["c"], PLACE) == -6
    assert not reactions.pulling


def test_a_string_over_a_pulley(problem: Read) -> None:
    solution = solve(
        problem(
            "title: Atwood\nparameters: [m, M, g, L]\ncoordinates: [a, b]\naxes: {j: down}\n"
            "particles: {P: {mass: m, position: a*j}, Q: {mass: M, position: b*j}}\n"
            "constraints: {s: {equation: a + b <= L, reaction: T}}\ngravity: g*j\n"
        )
    )
    reactions = solution.own.dynamics.reactions
    assert number(reactions.contacts["s"], {"m": 1, "M": 3, "g": 10}) == 15
    assert reactions.pulling == {"s"}


def test_what_is_written(problem: Read) -> None:
    explained = report(problem(BEAD.format(equation="x^2 + y^2 >= l^2", more=", reaction: N")))
    page = terminal.text(explained.derivation, explained.notation, 120)
    for words in (
        "x² + y² ≥ l² (c)",
        "is one-sided",
        "The c constraint can only push: it stays in contact as long as N ≥ 0.",
    ):
        assert words in " ".join(page.split())
    complete = terminal.text(explained.derivation, explained.notation, 120, detail=Detail.FULL)
    said = "(3) is one-sided. As long as there is contact, the two sides are equal, and the equation is used below."
    assert said in " ".join(complete.split())
    strict = (
        "The c constraint is an inequality, which, strictly speaking, is not a holonomic constraint; it acts as one"
    )
    assert strict in " ".join(complete.split())
    assert strict not in " ".join(page.split())
    written = in_json.as_object(explained)
    assert written["constraints"][0]["one_sided"] == "x^2 + y^2 - l^2 >= 0"
    contact = written["reactions"]["c"]["contact"]
    assert contact == f"{written['reactions']['c']['force']} >= 0"
    assert json.dumps(written)


@pytest.mark.parametrize(
    ("equation", "words"),
    [
        ("y >= 0", "lasts, because N is positive"),
        ("y <= 0", "could hold contact only by pulling, which it cannot: there is no contact"),
    ],
)
def test_what_needs_no_condition(problem: Read, equation: str, words: str) -> None:
    explained = report(problem(BEAD.format(equation=equation, more=", reaction: N")))
    assert words in terminal.text(explained.derivation, explained.notation, 120)


def test_at_rest_each_equilibrium_has_its_condition(problem: Read) -> None:
    explained = report(problem(BEAD.format(equation="x^2 + y^2 <= l^2", more=", reaction: T") + "find: equilibrium\n"))
    rest = in_json.as_object(explained)["reactions"]["c"]["at_equilibrium"]
    assert sorted(r["contact"] for r in rest) == ["-m*g >= 0", "m*g >= 0"]


# Held bodies


SAID = {
    "cylinder-on-wedge": "moving along 𝐣 is M g − F sin α + N cos α in this direction; it does no virtual",
    "ball-on-a-ball": "m (g cos θ − a θ̇² − a φ̇² sin²θ) It does no virtual work and is in none of the equations above.",
    "ex01-horizontal-surface": "A support that can only push requires λ > 0 where P is on the side to which 𝐤 points",
    "ex02-fixed-surface": "requires λ > 0 where P is on the side to which ∇f points, λ < 0 where it is on the other.",
    "bead-on-rotating-hoop": "The sphere and plane constraints together keep P on a wire",
    "bifilar-suspension": "On the bar act its weight, the twist moment and",
}


def page(name: str) -> str:
    found = shared.reported(name, complete=False)
    return " ".join(terminal.text(found.derivation, found.notation, 80).split())


@pytest.mark.parametrize("name", SAID)
def test_words(name: str) -> None:
    assert SAID[name] in page(name)


@pytest.mark.parametrize("name", ["slide-off-a-dome", "turning-parabola"])
def test_what_presses_or_holds_from_both_sides_is_no_support_that_only_pushes(name: str) -> None:
    assert "can only push" not in page(name)


def test_what_keeps_a_radius_small_may_pull_or_push(problem: Read) -> None:
    """ρ ≤ l − b with a force T: a string, or a circle around; with `by`, or a force N, it is one of them."""
    text = (
        "title: T\nparameters: [m, l, b, g]\ncoordinates: [rho, theta]\naxes: {{i: right, j: up}}\n"
        "particles: {{P: {{mass: m, position: rho*sin(theta)*i - rho*cos(theta)*j}}}}\n"
        "constraints: {{c: {{equation: rho <= l - b, reaction: {force}{by}}}}}\ngravity: -g*j\n"
        "generalized_coordinates: {{angle: {{coordinates: [theta]}}}}\n"
    )
    said = {("T", ""): "only act to the permitted side", ("N", ""): "only push", ("T", ", by: surface"): "only push"}
    for (force, by), words in said.items():
        explained = report(problem(text.format(force=force, by=by)))
        page = " ".join(terminal.text(explained.derivation, explained.notation, 120).split())
        assert f"The c constraint can {words}: it" in page
