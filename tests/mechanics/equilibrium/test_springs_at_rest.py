"""The forces of springs at equilibria, against the balance of forces and lengths measured at numbers."""

from __future__ import annotations

from collections.abc import Callable
from math import isclose, sqrt

import sympy as sp

from lagrange.explain.report import report
from lagrange.mechanics.solution import solve
from lagrange.problem.model import Problem
from lagrange.render import json as in_json
from lagrange.render import terminal
from tests.support.shared import solved

Read = Callable[[str], Problem]

HUNG = """title: Weight on a spring and a rod
parameters: {W: positive, l: positive, k: positive, h: positive, b: positive}
coordinates: [x, y]
particles: {P: {position: x*i + y*j}}
axes: {i: right, j: down}
constraints: {rod: {equation: x^2 + y^2 = l^2, reaction: T}}
forces:
  weight: {on: P, vector: W*j}
  tie: {spring: k, between: [P, -h*j], length: b}
generalized_coordinates: {angle: {coordinates: [theta], substitute: {x: l*sin(theta), y: l*cos(theta)}}}
find: equilibrium
"""


def at(e: sp.Expr, values: dict[str, float]) -> float:
    return float(e.xreplace({s: sp.Float(values[s.name]) for s in e.free_symbols}))


def test_a_weight_on_a_spring_and_a_rod(problem: Read) -> None:
    """Above or below the pivot the spring is h ± l long; with the rod's tension it carries the weight."""
    solution = solve(problem(HUNG))
    v = {"W": 5.0, "l": 2.0, "k": 7.0, "h": 3.0, "b": 0.4}
    seen = set()
    for view in solution.views:
        assert view.equilibrium is not None
        for b, pulls in zip(view.equilibrium.branches, view.equilibrium.pulls, strict=True):
            for p in b.points if pulls else ():
                if any(c.relation != "≠" for c in b.conditions):
                    continue  # with these values there is no such position
                place = {s.name: at(view.equilibrium.solution.at(p, view.configuration.rewritten(s)), v)
                         for s in solution.own.configuration.slots.coordinates}  # fmt: skip
                length = sqrt(place["x"] ** 2 + (place["y"] + v["h"]) ** 2)
                assert isclose(at(pulls["tie"], v), v["k"] * (length - v["b"]), rel_tol=1e-9)
                seen.add((view.name, round(place["y"], 9)))
    assert seen >= {("", 2.0), ("", -2.0), ("angle", 2.0), ("angle", -2.0)}


def test_the_post_leans_on_its_spring() -> None:
    """Moments about the foot: F b cos θ = W l sin θ where the post leans, with the spring b sin θ long."""
    e = solved("inverted-pendulum-springs").own.equilibrium
    assert e is not None
    upright, leaning = e.pulls
    assert upright["spring"] == 0
    values = {"l": 2.0, "b": 1.5, "c": 10.0, "W": 4.0}
    cosine = values["W"] * values["l"] / (values["c"] * values["b"] ** 2)
    force = at(leaning["spring"], values)
    moment = force * values["b"] * cosine
    assert isclose(moment, values["W"] * values["l"] * sqrt(1 - cosine**2))


def test_what_is_written(problem: Read) -> None:
    found = report(problem(HUNG))
    written = in_json.as_object(found)
    assert written["spring_forces"][:2] == [{"tie": "k*(h + l - b)"}, {"tie": "k*(abs(h - l) - b)"}]
    assert found.solution.own.equilibrium is not None
    values = [v for b in found.solution.own.equilibrium.branches for p in (b.common, *b.points) for v in p.values()]
    assert any(v.has(sp.Abs) for v in values)
    assert not any(
        p.exp == sp.S.Half and p.base.is_Add for v in values for p in sp.factor(v).atoms(sp.Pow) if v.has(sp.Abs)
    )
    page = " ".join(terminal.text(found.derivation, found.notation, 100).split())
    assert "pulls its ends together with the force" in page
