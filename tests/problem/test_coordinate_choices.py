"""Unknowns, speeds and choices of coordinates."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.symbols import t
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


TURNING = """title: A bead on a wire that turns
parameters: [m, a, w, g]
coordinates: [x, z, phi]
particles: {P: {mass: m, position: x*cos(phi)*i + x*sin(phi)*j + z*k}}
gravity: -g*k
"""


@pytest.mark.parametrize(
    ("constraints", "find", "kept"),
    [
        ("{wire: z = a*x^2, drive: phi = w*t}", "linearization", "x"),
        ("{drive: w*t = phi, wire: a*x^2 = z}", "[motion, linearization]", "x"),
        ("{wire: z = a*x^2*cos(phi), drive: phi = w*t}", "linearization", "x"),
        ("{wire: z = a*x^2, drive: phi = w*t}", "motion", None),
        ("{wire: z = a*x^2, drive: phi = a}", "linearization", None),  # nothing moves
        ("{wire: z^2 = a*x^2, drive: phi = w*t}", "linearization", None),
        ("{wire: z >= a*x^2, drive: phi = w*t}", "linearization", None),
    ],
)
def test_small_oscillations_relative_to_what_moves(constraints: str, find: str, kept: str | None) -> None:
    """Rest relative to a moving constraint is rest in the coordinates that it leaves."""
    problem = read(f"{TURNING}constraints: {constraints}\nfind: {find}\n")
    assert [[str(q) for q in c.coordinates] for c in problem.choices] == ([[kept]] if kept else [])
    for choice in problem.choices:
        assert choice.substitute is not None
        assert t in choice.substitute[sp.Symbol("phi", real=True)].free_symbols
