"""The names that tests of the expression language declare, and what they compare."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError
from lagrange.core.symbols import Slots, Unspecified
from lagrange.core.vectors import Vector
from lagrange.expressions.reader import (
    FunctionDeclaration,
    Scope,
    read_scalar,
)

x, y, theta, phi, theta_1, x1 = (sp.Symbol(n, real=True) for n in ("x", "y", "theta", "phi", "theta_1", "x1"))
a, b, al, al_1 = (sp.Symbol(n, real=True) for n in ("x''", "y''", "theta''", "theta_1''"))
u, du, ddu = (sp.Symbol(n, real=True) for n in ("u", "u'", "u''"))
m, l, g, R, c = (sp.Symbol(n, positive=True) for n in ("m", "l", "g", "R", "c"))
dx, dy, dtheta, dt = (sp.Symbol(f"d({n})", real=True) for n in ("x", "y", "theta", "t"))
delta_x = sp.Symbol("delta(x)", real=True)
lambda_rod = sp.Symbol("lambda_rod", real=True)
sin, cos, tan, sqrt, pi, half = sp.sin, sp.cos, sp.tan, sp.sqrt, sp.pi, sp.Rational(1, 2)


def f(*arguments: sp.Expr) -> Unspecified:
    return Unspecified.of("f", ("X", "Y"), *arguments)


def vector(*components: sp.Expr | int) -> Vector:
    p, q, r = (sp.sympify(c) for c in components)
    return Vector((p, q, r))


def scope(*more: str) -> Scope:
    """Coordinates x, y, theta, phi, theta_1, x1, a prescribed u, parameters m, l, g, R, c and more, f(X, Y)."""
    names = {s.name: s for s in (m, l, g, R, c, lambda_rod)}
    names |= {n: sp.Symbol(n, positive=True) for n in more}
    functions = {"f": FunctionDeclaration("f", ("X", "Y"))}
    vectors = {"r_P": vector(l * sin(theta), -l * cos(theta), 0), "n": vector(sin(theta), -cos(theta), 0)}
    return Scope(names, Slots((x, y, theta, phi, theta_1, x1), (u,)), functions, vectors)


def same(found: sp.Expr | Vector, expected: sp.Expr | Vector) -> bool:
    if isinstance(found, Vector) or isinstance(expected, Vector):
        assert isinstance(found, Vector)
        assert isinstance(expected, Vector)
        return all(same(p, q) for p, q in zip(found.fixed().components, expected.fixed().components, strict=True))
    return found == expected or sp.expand(found - expected) == 0


EQUATIONS: dict[str, tuple[sp.Expr | int, sp.Expr | int]] = {
    "theta'' + g/l*sin(theta) = 0": (al + g / l * sin(theta), 0),
    "theta'' == 0": (al, 0),
    "0 = 0": (0, 0),
    "sin(theta)^2+cos(theta)^2 = 1": (sin(theta) ** 2 + cos(theta) ** 2, 1),
    "0*theta'' = 0": (0, 0),
    "m x'' = -m g": (m * a, -m * g),
    "m(x''+g) = 0": (m * (a + g), 0),
    "x=-y": (x, -y),
    "m*x'' = 2*x*lambda_rod": (m * a, 2 * x * lambda_rod),
    "2*x*d(x) + 2*y*d(y) = 0": (2 * x * dx + 2 * y * dy, 0),
    "2*x*delta(x) = 0": (2 * x * delta_x, 0),
}


def refused(text: str, known: Scope | None = None, limit: int = 10_000) -> tuple[Diagnostic, ...]:
    with pytest.raises(ProblemError) as caught:
        read_scalar(Fragment.of(text), known or scope(), limit=limit)
    return caught.value.diagnostics
