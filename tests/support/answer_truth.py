"""The verdict on an answer by a second route, which shares no code with `lagrange`.

A system is written down by hand (`second_route`); an answer is read by SymPy's own parser. At states on the constraint
surface, in numbers of sixty digits, the system is solved for accelerations and multipliers:

    an equation follows      where it holds with these values,
    an answer is complete    where it determines all accelerations, together with the constraints.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from functools import cache

import sympy as sp
from mpmath import mp, mpf

from tests.support.second_route import (
    Rigid,
    Route,
    affine,
    lagrange,
    literature,
    moving,
    newton,
    newton_euler,
    number,
    rotation,
    solved,
    states,
    t,
)
from tests.support.second_route import constants as letters

HELD = mpf(10) ** -35
COUNT = 2
FUNCTIONS = {f.__name__: f for f in (sp.sin, sp.cos, sp.tan, sp.cot, sp.exp, sp.sqrt, sp.log)}
_NAME = re.compile(r"([A-Za-z_][A-Za-z_0-9]*)('*)")

Ranges = Mapping[str, tuple[float, float]]


def read(text: str) -> sp.Expr:
    """One side of an equation, or an equation as what is zero. Every name is a plain symbol, with its primes."""
    if "=" in text:
        left, right = text.split("=")
        return read(left) - read(right)
    known: dict[str, object] = dict(FUNCTIONS)

    def stand_in(match: re.Match[str]) -> str:
        name, primes = match.groups()
        if name in FUNCTIONS:
            return name
        known[f"s_{name}_{len(primes)}"] = sp.Symbol(name + primes)
        return f"s_{name}_{len(primes)}"

    return sp.sympify(_NAME.sub(stand_in, text.replace("^", "**")), locals=known)


def written(e: sp.Expr) -> str:
    """An expression in the language of answers."""
    return str(e).replace("**", "^")


def truth(route: Route, answer: Sequence[sp.Expr], ranges: Ranges | None = None, seed: int = 1) -> str:
    """The verdict on equations, each zero and affine in the unknowns."""
    names = {s.name for e in answer for s in e.free_symbols}
    constraints = route.system[len(route.equations) :]
    found = set()
    for state in states(route, names, dict(ranges or {}), seed, COUNT):
        solution = solved(affine(route.system, route.unknowns, state), route.unknowns)
        assert solution.consistent
        moving_names = [f"{q}''" for q in route.coordinates]
        assert {*moving_names, *(names & {*route.unknowns})} <= {*solution.values}
        there = {**state, **solution.values}
        follows = [_holds(e, there) for e in answer]
        if not all(follows):
            found.add("wrong")
            continue
        rows = affine([*answer, *constraints], route.unknowns, state)
        found.add("equivalent" if {*moving_names} <= {*solved(rows, route.unknowns).values} else "incomplete")
    assert len(found) == 1, "no generic verdict"
    return found.pop()


def _holds(e: sp.Expr, there: Mapping[str, mpf]) -> bool:
    with mp.workdps(60):
        terms = [abs(number(term, there)) for term in sp.Add.make_args(e)]
        value = abs(number(e, there))
        size = max(terms, default=mpf(0)) + mpf(1) / 10**6
        assert value < HELD * size or value > size / 10**20, "too close to tell"
        return bool(value < HELD * size)


# -- the shipped problems, by hand -------------------------------------------------------------------------------------


def _pendulum_in_x_y() -> Route:
    x, y = moving("x y")
    m, l, g = letters("m l g")
    return newton("x y", [(m, (x, y, 0), (0, m * g, 0))], {"rod": x**2 + y**2 - l**2})


def _pendulum() -> Route:
    (theta,) = moving("theta")
    m, l, g = letters("m l g")
    return lagrange("theta", m * l**2 * theta.diff(t) ** 2 / 2, -m * g * l * sp.cos(theta))


def _driven() -> Route:
    r, theta, phi = moving("r theta phi")
    m, g, a, b, omega = letters("m g a b omega")
    kinetic = m * (r.diff(t) ** 2 + r**2 * theta.diff(t) ** 2 + r**2 * sp.sin(theta) ** 2 * phi.diff(t) ** 2) / 2
    length = {"length": r - a - b * sp.cos(omega * t)}
    base = lagrange("r theta phi", kinetic, m * g * r * sp.cos(theta))
    lam = sp.Symbol("lambda_length")
    equations = tuple(e - lam * int(n == 0) for n, e in enumerate(base.equations))
    return Route(base.coordinates, equations, length, multipliers=("lambda_length",))


def _two_particles() -> Route:
    q = moving("x1 y1 z1 x2 y2 z2")
    m1, m2, l, g = letters("m1 m2 l g")
    rod = sum((b - a) ** 2 for a, b in zip(q[:3], q[3:], strict=True)) - l**2
    points = [(m1, q[:3], (0, 0, -m1 * g)), (m2, q[3:], (0, 0, -m2 * g))]
    return newton("x1 y1 z1 x2 y2 z2", points, {"rod": rod})


def _rough_incline() -> Route:
    (x,) = moving("x")
    g, alpha, mu = letters("g alpha mu")
    return literature("x", [x.diff(t, 2) - g * sp.sin(alpha) + mu * g * sp.cos(alpha)])


def _double_pendulum() -> Route:
    a, b = moving("phi1 phi2")
    m1, m2, l1, l2, g = letters("m1 m2 l1 l2 g")
    first = (l1 * sp.sin(a), l1 * sp.cos(a), 0)
    second = (first[0] + l2 * sp.sin(b), first[1] + l2 * sp.cos(b), 0)
    return newton("phi1 phi2", [(m1, first, (0, m1 * g, 0)), (m2, second, (0, m2 * g, 0))])


def _sleigh() -> Route:
    x, y, theta = moving("x y theta")
    m, a, inertia = letters("m a I_G")
    at = (x + a * sp.cos(theta), y + a * sp.sin(theta), 0)
    body = Rigid(m, at, rotation("z", theta), (0, 0, inertia), spin=(0, 0, theta.diff(t)))
    blade = -x.diff(t) * sp.sin(theta) + y.diff(t) * sp.cos(theta)
    return newton_euler("x y theta", [body], kinematic={"blade": blade})


def _spring_pendulum() -> Route:
    r, phi = moving("r phi")
    m, c, l, g = letters("m c l g")
    kinetic = m * (r.diff(t) ** 2 + r**2 * phi.diff(t) ** 2) / 2
    return lagrange("r phi", kinetic, c * (r - l) ** 2 / 2 - m * g * r * sp.cos(phi))


def _bell() -> Route:
    alpha, beta = moving("alpha beta")
    M, m, a, b, l, g, one, two = letters("M m a b l g I_1 I_2")
    kinetic = (M * a**2 + one) * alpha.diff(t) ** 2 / 2 + two * beta.diff(t) ** 2 / 2
    at = (l * sp.cos(alpha) + b * sp.cos(beta), l * sp.sin(alpha) + b * sp.sin(beta))
    kinetic += m * sum(c.diff(t) ** 2 for c in at) / 2
    return lagrange("alpha beta", kinetic, -M * g * a * sp.cos(alpha) - m * g * at[0])


def _suspension() -> Route:
    z1, z2 = moving("z1 z2")
    M, m, c, tyre, b = letters("M m c c_T b")
    u = sp.Function("u")(t)
    rate = z1.diff(t) - z2.diff(t)
    potential = c * (z1 - z2) ** 2 / 2 + tyre * (z2 - u) ** 2 / 2
    kinetic = M * z1.diff(t) ** 2 / 2 + m * z2.diff(t) ** 2 / 2
    return lagrange("z1 z2", kinetic, potential, {z1: -b * rate, z2: b * rate})


def _top() -> Route:
    phi, theta, psi = moving("phi theta psi")
    m, l, g, A, C = letters("m l g A C")
    spin = psi.diff(t) + phi.diff(t) * sp.cos(theta)
    kinetic = (A + m * l**2) * (theta.diff(t) ** 2 + phi.diff(t) ** 2 * sp.sin(theta) ** 2) / 2 + C * spin**2 / 2
    return lagrange("phi theta psi", kinetic, m * g * l * sp.cos(theta))


def _half_cylinder() -> Route:
    x, theta = moving("x theta")
    m, R, h, g, inertia = letters("m R h g I_G")
    at = (x - h * sp.sin(theta), R - h * sp.cos(theta), 0)
    turned = rotation("z", -theta)
    body = Rigid(m, at, turned, (0, 0, inertia), (0, -m * g, 0), spin=(0, 0, -theta.diff(t)))
    return newton_euler("x theta", [body], {"rolling": x - R * theta})


ROUTES = {
    "ex11": _pendulum,
    "ex11 in x, y": _pendulum_in_x_y,
    "ex14": _two_particles,
    "ex15-rough-incline": _rough_incline,
    "ex17": _driven,
    "ex18": _double_pendulum,
    "bell-and-clapper": _bell,
    "heavy-top": _top,
    "rocking-half-cylinder": _half_cylinder,
    "sleigh": _sleigh,
    "spring-pendulum": _spring_pendulum,
    "wheel-suspension": _suspension,
}
"""name of a shipped problem, and words after it -> the system in some coordinates."""

RANGES: dict[str, Ranges] = {"ex17": {"a": (2, 3), "b": (0.2, 0.9)}}


@cache
def route(name: str) -> Route:
    """The system of a name, made once."""
    return ROUTES[name]()
