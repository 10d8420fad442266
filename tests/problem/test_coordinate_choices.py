"""Unknowns, speeds and choices of coordinates.

Frames and their unit vectors.
"""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.symbols import t
from lagrange.core.vectors import Vector
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


# Frames


x_frames, y_frames, theta_frames = (sp.Symbol(n_frames, real=True) for n_frames in ("x", "y", "theta"))


def vector(*components: sp.Expr | int) -> Vector:
    p, q, r = (sp.sympify(e) for e in components)
    return Vector((p, q, r))


@pytest.mark.parametrize(
    ("frame", "coordinates", "first"),
    [
        ("{type: cartesian}", "[x, y, z]", (1, 0, 0)),
        ("{type: polar, coordinates: [r, phi]}", "[r, phi]", ("cos(phi)", "sin(phi)", 0)),
        ("{type: cylindrical, coordinates: [rho, phi, z]}", "[rho, phi, z]", ("cos(phi)", "sin(phi)", 0)),
        (
            "{type: spherical, coordinates: [r, theta, phi]}",
            "[r, theta, phi]",
            ("sin(theta)*cos(phi)", "sin(theta)*sin(phi)", "cos(theta)"),
        ),
    ],
)
def test_frames(frame: str, coordinates: str, first: tuple[object, ...]) -> None:
    names = coordinates.strip("[]").split(", ")
    unit = "i" if "cartesian" in frame else f"e_{names[0]}"
    problem = read(f"title: T\ncoordinates: {coordinates}\nframe: {frame}\nlet: {{n: {unit}}}\n")
    symbols = {n: sp.Symbol(n, real=True) for n in ("theta", "phi")}
    expected = vector(*(sp.sympify(e, symbols) for e in first))
    assert problem.scope.vectors["n"].fixed() == expected
