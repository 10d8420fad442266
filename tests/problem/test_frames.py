"""Frames and their unit vectors."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.vectors import Vector
from tests.support.problem_texts import read

x, y, theta = (sp.Symbol(n, real=True) for n in ("x", "y", "theta"))


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
