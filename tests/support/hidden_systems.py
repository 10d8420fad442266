"""Systems with hidden finite relations, and traps."""

from __future__ import annotations

import random
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import sympy as sp
from mpmath import fp

from lagrange.core.symbols import t
from lagrange.problem.model import Problem
from tests.support.exterior import rank, real_point

Values = dict[sp.Symbol, float]
STEPS = 60
STEP = 0.01


@dataclass(frozen=True)
class System:
    """Constraints on velocities and positions.

    hidden   functions that must be found, up to functions of them and of what single constraints show
    total    the number of independent finite relations in the constraints
    missing  how many of them are in no dictionary
    start    values that satisfy the geometric constraints; others are random
    """

    name: str
    coordinates: str
    constraints: Sequence[str]
    hidden: Sequence[str] = ()
    total: int = 0
    missing: int = 0
    start: Mapping[str, float] = field(default_factory=dict)
    functions: str = "{}"

    @property
    def text(self) -> str:
        listed = ", ".join(f'c{n}: "{c}"' for n, c in enumerate(self.constraints, start=1))
        return (
            f"title: {self.name}\nparameters: {{R: positive, b: positive, omega: positive, alpha: real, k: real}}\n"
            f"functions: {self.functions}\ncoordinates: [{self.coordinates}]\nconstraints: {{{listed}}}\n"
        )


SKATE = "sin(theta)*x' - cos(theta)*y' = 0"
LEFT = "cos(theta)*x' + sin(theta)*y' + b*theta' = R*p'"
RIGHT = "cos(theta)*x' + sin(theta)*y' - b*theta' = R*q'"
DISC = ("x' = R*phi'*cos(theta)", "y' = R*phi'*sin(theta)")
FOUND = [
    System("two wheels on an axle", "x, y, theta, p, q", (SKATE, LEFT, RIGHT), ("R*(p - q) - 2*b*theta",), 1),
    System("dz - y dx with dy", "x, y, z", ("z' = y*x'", "y' = 0"), ("z - x*y",), 2),
    System("disc that keeps its heading", "x, y, phi, theta", (*DISC, "theta' = 0"),
           ("x - R*phi*cos(theta)", "y - R*phi*sin(theta)"), 3),
    System("sphere by velocities, with a follower", "x, y, z, w, s", ("x*x' + y*y' + z*z' + s*w' = 0", "(2 + y)*w' = 0"),
           ("x^2 + y^2 + z^2",), 2),
    System("rod by velocities, mixed", "x1, y1, x2, y2, s",
           ("(x1 - x2)*(x1' - x2') + (y1 - y2)*(y1' - y2') + x1*s' = 0", "s' = y2*(x1 - x2)*(x1' - x2')"
            " + y2*(y1 - y2)*(y1' - y2') + x1*y2*s'"), ("(x1 - x2)^2 + (y1 - y2)^2", "s"), 2),
    System("mixed by functions", "x, y, phi, theta",
           ("x' - R*phi'*cos(theta) + (y + sin(x))*theta' = 0",
            "y' - R*phi'*sin(theta) + x*(x' - R*phi'*cos(theta)) = theta'*x", "(2 + sin(y))*theta' = 0"),
           ("x - R*phi*cos(theta)", "y - R*phi*sin(theta)"), 3),
    System("heading given by a parameter", "x, y, phi",
           ("x' + y*y' = R*phi'*(cos(alpha) + y*sin(alpha))", "x*x' + y' = R*phi'*(x*cos(alpha) + sin(alpha))"),
           ("x - R*phi*cos(alpha)", "y - R*phi*sin(alpha)"), 2),
    System("screw", "x, z, phi", ("z' = b*phi'/(2*pi) + x*x'*z", "z*x' = 0"), ("z - b*phi/(2*pi)",), 2),
    System("wheels on moving ground", "x, y, theta, p, q",
           (SKATE, "cos(theta)*x' + sin(theta)*y' + b*theta' = R*p' + omega",
            "cos(theta)*x' + sin(theta)*y' - b*theta' = R*q' - k*t"),
           ("2*b*theta - R*(p - q) - omega*t - k*t^2/2",), 1),
    System("driven", "x, y, z", ("x' = sin(omega*t)*y' + omega*y*cos(omega*t)", "z' = (x' - sin(omega*t)*y')*x + k*t"
           " - omega*x*y*cos(omega*t)"), ("z - k*t^2/2",), 2),
    System("driven, hidden", "x, y, z", ("x' + z*z' = sin(omega*t)*y' + omega*y*cos(omega*t) + k*t*z",
                                         "y*x' + z' = y*sin(omega*t)*y' + omega*y^2*cos(omega*t) + k*t"),
           ("x - y*sin(omega*t)", "z - k*t^2/2"), 2),
    System("prescribed motion", "x, y, z", ("x' + y*z' = u*y' + u'*y", "z*x' - z' = z*u*y' + z*u'*y"),
           ("x - u*y", "z"), 2, functions="{u: [t]}"),
    System("skate on a sphere, heading kept", "x, y, z, theta",
           ("x^2 + y^2 + z^2 = R^2", SKATE, "(2 + z)*theta' = 0"), ("x*sin(theta) - y*cos(theta)",), 3,
           start={"x": 0.6, "y": 0.48, "z": 0.64, "R": 1.0}),
    System("two forms and their sum", "x, y, z, w", ("x' = z*w'", "y' = -z*w'"), ("x + y",), 1),
    System("only together", "x, y, z, w", ("z' = y*x'", "y' = w*x'", "w' = 0"), ("w*x - y", "w*z - y^2/2"), 3),
    System("ratios", "x, y, z", ("y*x' - x*y' + z*(z*y' - y*z') = 0", "z*y' = y*z'"), ("x/y", "y/z"), 2),
    System("a product in disguise", "x, y, z, w", ("x' + y*z*w' = 0", "y' = z*w'"), ("x + y^2/2",), 1),
]  # fmt: skip
TRAPS = [
    System("skate", "x, y, theta", (SKATE,)),
    System("upright disc", "x, y, phi, theta", DISC),
    System("car", "x, y, theta, phi", (SKATE, "sin(theta + phi)*x' - cos(theta + phi)*y' = b*cos(phi)*theta'")),
    System("ball that does not spin", "x, y, theta, phi, psi",
           ("x' = R*(theta'*sin(psi) - phi'*sin(theta)*cos(psi))",
            "y' = -R*(theta'*cos(psi) + phi'*sin(theta)*sin(psi))", "psi' + phi'*cos(theta) = 0")),
    System("Engel", "x, y, z, w", ("y' = z*x'", "z' = w*x'")),
    System("wheels on a telescope", "x, y, theta, p, q, s",
           (SKATE, "cos(theta)*x' + sin(theta)*y' + s*theta' = R*p'", "cos(theta)*x' + sin(theta)*y' - s*theta' = R*q'")),
    System("sphere by velocities", "x, y, z", ("x*x' + y*y' + z*z' = 0",), total=1),
    System("rod twice", "x, y", ("x^2 + y^2 = R^2", "x*x' + y*y' = 0"), total=1, start={"x": 0.6, "y": 0.8, "R": 1.0}),
    System("relation given", "x, y, theta, p, q", (SKATE, LEFT, RIGHT, "R*(p - q) = 2*b*theta"), total=1,
           start={"p": 0.9, "q": 0.5, "R": 1.0, "b": 0.5, "theta": 0.4}),
    System("pursuit at frozen time", "x, y", ("cos(omega*t)*y' = sin(omega*t)*x'",)),
    System("time drives two", "x, y, z", ("x' = z", "y' = x")),
    System("one known, one nonintegrable", "x, y, z, w", ("w' = x*x'", "z' = y*x'"), total=1),
    System("seen only on a plane that is not there", "x, y, z, w", ("x' + y*z*w' = 0",)),
    System("Riccati", "x, y", ("y' = y^2 + t", "x' = y"), total=2, missing=2),
    System("integral of a prescribed motion", "x, y, z", ("y' + z*x' = u + z*u'", "x' - u' = (y' - u)*z"), ("x - u",), 2,
           missing=1, functions="{u: [t]}"),
]  # fmt: skip
SYSTEMS = [*FOUND, *TRAPS]
PRESCRIBED = sp.exp(t / 2) + t**2


def forms_of(problem: Problem) -> list[list[sp.Expr]]:
    """The differential forms, by differentiation here."""
    rows = []
    for c in problem.constraints:
        f = c.function
        over = problem.slots.velocities if c.kinematic else problem.slots.coordinates
        rest = f.xreplace(dict.fromkeys(problem.slots.velocities, sp.S.Zero)) if c.kinematic else sp.diff(f, t)
        rows.append([plain(sp.diff(f, v)) for v in over] + [plain(rest)])
    return rows


def plain(e: sp.Expr) -> sp.Expr:
    """With a definite function of t for the prescribed motion."""
    u, rate = sp.Symbol("u", real=True), sp.Symbol("u'", real=True)
    return e.xreplace({u: PRESCRIBED, rate: sp.diff(PRESCRIBED, t)})


def admissible_motion(system: System, problem: Problem, seed: int) -> list[Values]:
    """Coordinates along a motion that satisfies the constraints, by Runge and Kutta.

    q' = w - Aᵀ (A Aᵀ)⁻¹ (A w + a_t) with a random smooth w(t), the projection that is nearest to w.
    """
    rng = random.Random(f"{system.name}{seed}")
    rows = independent(forms_of(problem), system.name)
    symbols = sorted({s for row in rows for a in row for s in a.free_symbols} | {*problem.slots.coordinates}, key=str)
    symbols += [p.symbol for p in problem.parameters if p.symbol not in symbols]
    values = {s: system.start.get(s.name, rng.uniform(0.5, 1.2)) for s in symbols if s != t}
    coordinates = list(problem.slots.coordinates)
    fixed = [s for s in values if s not in coordinates]
    matrix = sp.lambdify([t, *coordinates, *fixed], rows, "math")
    waves = [(rng.uniform(-1, 1), rng.uniform(1, 4), rng.uniform(0, 6)) for _ in coordinates]
    constants = [values[s] for s in fixed]

    def rate(time: float, q: list[float]) -> list[float]:
        table = matrix(time, *q, *constants)
        a, drift = fp.matrix([row[:-1] for row in table]), fp.matrix([row[-1] for row in table])
        w = fp.matrix([size * fp.sin(speed * time + phase) + size for size, speed, phase in waves])
        return list(w - a.T * fp.lu_solve(a * a.T, a * w + drift))

    def moved(q: list[float], k: list[float], h: float) -> list[float]:
        return [x + h * v for x, v in zip(q, k, strict=True)]

    q, time, path = [values[s] for s in coordinates], 0.3, list[Values]()
    for _ in range(STEPS):
        path.append(values | dict(zip(coordinates, q, strict=True)) | {t: time})
        k1 = rate(time, q)
        k2 = rate(time + STEP / 2, moved(q, k1, STEP / 2))
        k3 = rate(time + STEP / 2, moved(q, k2, STEP / 2))
        k4 = rate(time + STEP, moved(q, k3, STEP))
        q = [x + STEP / 6 * (a + 2 * b + 2 * c + d) for x, a, b, c, d in zip(q, k1, k2, k3, k4, strict=True)]
        time += STEP
    return path


def independent(rows: list[list[sp.Expr]], seed: str) -> list[list[sp.Expr]]:
    """The rows without those that depend on others where all symbols are random: the redundant ones of these tests."""
    kept: list[list[sp.Expr]] = []
    point = somewhere(rows, seed)
    for row in rows:
        if rank([*kept, row], point) > len(kept):
            kept.append(row)
    return kept


def somewhere(rows: list[list[sp.Expr]], seed: str) -> Mapping[sp.Symbol, sp.Expr]:
    return real_point((), (), list({s for row in rows for a in row for s in a.free_symbols}), sum(map(ord, seed)))
