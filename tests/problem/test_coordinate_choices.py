"""Unknowns, speeds and choices of coordinates."""

from __future__ import annotations

import sympy as sp

from tests.support.problem_texts import ALL, read

x, y, theta = (sp.Symbol(n, real=True) for n in ("x", "y", "theta"))
v, w, om = (sp.Symbol(n, real=True) for n in ("x'", "y'", "theta'"))
m, l, g, k, c, F, R, mu, A, C, I_G = sp.symbols("m l g k c F R mu A C I_G", positive=True)


def test_unknowns_speeds_and_choices() -> None:
    problem = read(
        ALL
        + """unknowns: [P]
forces: {hold: {on: P, vector: P*i}}
speeds: {u1: "x'*cos(theta) + y'*sin(theta)"}
generalized_coordinates:
  angle: {coordinates: [s, theta], substitute: {x: l*sin(s), y: l*cos(s)}}
  depth: {coordinates: [y, theta]}
"""
    )
    assert problem.unknowns == (sp.Symbol("P", real=True),)
    assert [s.definition for s in problem.speeds] == [v * sp.cos(theta) + w * sp.sin(theta)]
    angle, depth = problem.choices
    s = sp.Symbol("s", real=True)
    assert angle.coordinates == (s, theta)
    assert angle.substitute == {x: l * sp.sin(s), y: l * sp.cos(s)}
    assert (depth.coordinates, depth.substitute) == ((y, theta), None)
