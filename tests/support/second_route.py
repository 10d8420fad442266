"""Equations of motion by a second route, which shares no code with `lagrange`.

A route is a set of equations that are affine in the accelerations and in unknown forces, made with SymPy's functions of
time: Newton's law with multipliers, written out by hand (`newton`); `LagrangesMethod` (`lagrange`); `KanesMethod`
(`kane`); or equations copied from the literature (`literature`). States are drawn on the constraint surface, in numbers
of sixty digits, and accelerations are compared as numbers. Symbols are known by their names, `theta''` as in problem
files, so that one state serves both routes.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property, lru_cache

import sympy as sp
from mpmath import mp, mpf
from sympy.physics.mechanics import (
    KanesMethod,
    LagrangesMethod,
    Particle,
    Point,
    ReferenceFrame,
    RigidBody,
    Vector,
    dynamicsymbols,
)
from sympy.physics.mechanics import inertia as sp_inertia
from sympy.simplify.cse_main import tree_cse

t = dynamicsymbols._t

DIGITS = 60
TINY = 10**-45  # what counts as zero when nothing but rounding is left
AGREED = 10**-30

State = Mapping[str, mpf]


def moving(names: str) -> tuple[sp.Expr, ...]:
    """Functions of time, one for each name."""
    return tuple(sp.Function(n)(t) for n in names.split())


def constants(names: str) -> tuple[sp.Symbol, ...]:
    """Constants, one for each name."""
    return tuple(sp.Symbol(n) for n in names.split())


def slots(expression: sp.Expr) -> sp.Expr:
    """The expression with plain symbols x, x', x'' in place of functions of time and their derivatives."""
    rule: dict[sp.Basic, sp.Basic] = {}
    for d in expression.atoms(sp.Derivative):
        if isinstance(d.expr, sp.core.function.AppliedUndef) and d.expr.args == (t,):
            rule[d] = sp.Symbol(d.expr.func.__name__ + "'" * d.derivative_count)
    for f in expression.atoms(sp.core.function.AppliedUndef):
        if f.args == (t,):
            rule[f] = sp.Symbol(f.func.__name__)
    return expression.xreplace(rule).xreplace({t: sp.Symbol("t")})


@dataclass(frozen=True)
class Route:
    """Equations that are zero, in functions of time.

    coordinates  names of the coordinates
    equations    the dynamics, without the constraints
    geometric    f(q, t) by the name of the constraint
    kinematic    phi(q, q', t) by the name of the constraint
    multipliers  names of unknown forces whose values this route gives
    """

    coordinates: tuple[str, ...]
    equations: tuple[sp.Expr, ...]
    geometric: Mapping[str, sp.Expr] = field(default_factory=dict)
    kinematic: Mapping[str, sp.Expr] = field(default_factory=dict)
    multipliers: tuple[str, ...] = ()
    given: tuple[tuple[str, sp.Expr], ...] = ()

    @cached_property
    def unknowns(self) -> tuple[str, ...]:
        """Accelerations, then multipliers; those of LagrangesMethod are called lam1, lam2, ..."""
        found = [f"{q}''" for q in self.coordinates]
        names = {s.name for e in self.system for s in e.free_symbols}
        hidden = sorted(n for n in names if n.startswith("lam") and n[3:].isdigit())
        return (*found, *self.multipliers, *hidden)

    @cached_property
    def system(self) -> tuple[sp.Expr, ...]:
        """Dynamics, and the constraints differentiated until accelerations occur."""
        twice = [sp.diff(f, t, 2) for f in self.geometric.values()]
        once = [sp.diff(f, t) for f in self.kinematic.values()]
        return tuple(slots(sp.sympify(e)) for e in (*self.equations, *twice, *once))

    @cached_property
    def rates(self) -> tuple[sp.Expr, ...]:
        """The constraints on velocities."""
        return tuple(slots(e) for e in (*(sp.diff(f, t) for f in self.geometric.values()), *self.kinematic.values()))

    @cached_property
    def positions(self) -> tuple[sp.Expr, ...]:
        """The constraints on positions."""
        return tuple(slots(sp.sympify(f)) for f in self.geometric.values())

    @cached_property
    def names(self) -> frozenset[str]:
        """All symbols that occur."""
        return frozenset(s.name for e in (*self.system, *self.rates, *self.positions) for s in e.free_symbols)


# -- the routes ------------------------------------------------------------------------------------------------------


def newton(
    coordinates: str,
    points: Sequence[tuple[sp.Expr, Sequence[sp.Expr], Sequence[sp.Expr]]],
    geometric: Mapping[str, sp.Expr] | None = None,
    kinematic: Mapping[str, sp.Expr] | None = None,
    loads: Sequence[tuple[Sequence[sp.Expr], Sequence[sp.Expr]]] = (),
) -> Route:
    """m r'' = F + reactions, dotted with every dr/dq_k: J^T (m r'' - F) = A^T lambda.

    points  (mass, Cartesian position, applied force); `loads`: (point of application, force)
    """
    q = moving(coordinates)
    geometric, kinematic = dict(geometric or {}), dict(kinematic or {})
    velocity = [sp.diff(x, t) for x in q]
    lam = {n: sp.Symbol(f"lambda_{n}") for n in (*geometric, *kinematic)}
    equations = []
    for k, x in enumerate(q):
        total = sp.S.Zero
        for mass, r, force in points:
            for c, f in zip(r, force, strict=True):
                total += (mass * sp.diff(c, t, 2) - f) * sp.diff(c, x)
        for r, force in loads:
            total -= sum(f * sp.diff(c, x) for c, f in zip(r, force, strict=True))
        total -= sum(lam[n] * sp.diff(f, x) for n, f in geometric.items())
        total -= sum(lam[n] * sp.diff(f, velocity[k]) for n, f in kinematic.items())
        equations.append(total)
    names = tuple(s.name for s in lam.values())
    return Route(tuple(coordinates.split()), tuple(equations), geometric, kinematic, names)


def lagrange(
    coordinates: str,
    kinetic: sp.Expr,
    potential: sp.Expr = sp.S.Zero,
    forces: Mapping[sp.Expr, sp.Expr] | None = None,
    geometric: Mapping[str, sp.Expr] | None = None,
    kinematic: Mapping[str, sp.Expr] | None = None,
) -> Route:
    """SymPy's LagrangesMethod; `forces` are generalized forces by coordinate."""
    q = moving(coordinates)
    geometric, kinematic = dict(geometric or {}), dict(kinematic or {})
    method = LagrangesMethod(
        kinetic - potential, list(q), hol_coneqs=list(geometric.values()) or None, nonhol_coneqs=list(kinematic.values()) or None
    )  # fmt: skip
    left = method.form_lagranges_equations()
    forces = dict(forces or {})
    equations = tuple(e - forces.get(x, 0) for e, x in zip(left, q, strict=True))
    return Route(tuple(coordinates.split()), equations, geometric, kinematic)


def kane(
    coordinates: str,
    points: Sequence[tuple[sp.Expr, Sequence[sp.Expr], Sequence[sp.Expr]]],
    dependent: str = "",
    geometric: Mapping[str, sp.Expr] | None = None,
    kinematic: Mapping[str, sp.Expr] | None = None,
) -> Route:
    """SymPy's KanesMethod with u = q'; the speeds of the coordinates `dependent` are the dependent ones."""
    q = moving(coordinates)
    geometric, kinematic = dict(geometric or {}), dict(kinematic or {})
    u = dynamicsymbols(" ".join(f"speed_{n}" for n in coordinates.split()) + " speed_")[: len(q)]
    as_speed = {sp.diff(x, t): s for x, s in zip(q, u, strict=True)}
    frame, origin = ReferenceFrame("N"), Point("O")
    origin.set_vel(frame, 0)
    bodies, loads = [], []
    for n, (mass, r, force) in enumerate(points):
        at = origin.locatenew(f"P{n}", r[0] * frame.x + r[1] * frame.y + r[2] * frame.z)
        rate = [sp.diff(c, t).xreplace(as_speed) for c in r]
        at.set_vel(frame, rate[0] * frame.x + rate[1] * frame.y + rate[2] * frame.z)
        bodies.append(Particle(f"body{n}", at, mass))
        force = [sp.sympify(f).xreplace(as_speed) for f in force]
        loads.append((at, force[0] * frame.x + force[1] * frame.y + force[2] * frame.z))
    bound = dependent.split()
    names = coordinates.split()
    free = [n for n in range(len(q)) if names[n] not in bound]
    tied = [n for n in range(len(q)) if names[n] in bound]
    velocity = [e.xreplace(as_speed) for e in (*(sp.diff(f, t) for f in geometric.values()), *kinematic.values())]
    bound_positions = tied[: len(geometric)]
    method = KanesMethod(
        frame,
        q_ind=[x for n, x in enumerate(q) if n not in bound_positions],
        u_ind=[u[n] for n in free],
        kd_eqs=[s - sp.diff(x, t) for x, s in zip(q, u, strict=True)],
        q_dependent=[q[n] for n in bound_positions] or None,
        configuration_constraints=list(geometric.values()) or None,
        u_dependent=[u[n] for n in tied] or None,
        velocity_constraints=velocity or None,
    )
    fr, frstar = method.kanes_equations(bodies, loads)
    back = {sp.diff(s, t): sp.diff(x, t, 2) for x, s in zip(q, u, strict=True)}
    rates = {s: sp.diff(x, t) for x, s in zip(q, u, strict=True)}
    equations = tuple(e.xreplace(back).xreplace(rates) for e in fr + frstar)
    return Route(tuple(names), equations, geometric, kinematic)


@dataclass(frozen=True)
class Rigid:
    """A rigid body: mass centre, matrix whose columns are its principal axes, principal moments, what acts on it.

    `moment` is about the mass centre; `spin`, the angular velocity, follows from the matrix where it is not given.
    """

    mass: sp.Expr
    at: Sequence[sp.Expr]
    turned: sp.Matrix
    inertia: Sequence[sp.Expr]
    force: Sequence[sp.Expr] = (0, 0, 0)
    moment: Sequence[sp.Expr] = (0, 0, 0)
    spin: Sequence[sp.Expr] | None = None

    @property
    def omega(self) -> sp.Matrix:
        """The angular velocity, from the skew matrix R' R^T."""
        if self.spin is not None:
            return sp.Matrix(self.spin)
        skew = sp.diff(self.turned, t) * self.turned.T
        return sp.Matrix([skew[2, 1], skew[0, 2], skew[1, 0]])


def rotation(axis: str, angle: sp.Expr) -> sp.Matrix:
    """Rodrigues' formula about x, y or z."""
    n = sp.Matrix([int(axis == a) for a in "xyz"])
    skew = sp.Matrix([[0, -n[2], n[1]], [n[2], 0, -n[0]], [-n[1], n[0], 0]])
    return sp.eye(3) + sp.sin(angle) * skew + (1 - sp.cos(angle)) * skew * skew


def newton_euler(
    coordinates: str,
    bodies: Sequence[Rigid],
    geometric: Mapping[str, sp.Expr] | None = None,
    kinematic: Mapping[str, sp.Expr] | None = None,
) -> Route:
    """(m r'' - F) . dr/dq_k + (dH/dt - M) . d omega/dq_k' = A^T lambda, all in fixed components."""
    q = moving(coordinates)
    geometric, kinematic = dict(geometric or {}), dict(kinematic or {})
    lam = {n: sp.Symbol(f"lambda_{n}") for n in (*geometric, *kinematic)}
    equations = []
    for x in q:
        total = -sum(lam[n] * sp.diff(f, x) for n, f in geometric.items())
        total -= sum(lam[n] * sp.diff(f, sp.diff(x, t)) for n, f in kinematic.items())
        for body in bodies:
            r, force = sp.Matrix([*body.at, 0][:3]), sp.Matrix([*body.force, 0][:3])
            total += (body.mass * sp.diff(r, t, 2) - force).dot(sp.diff(r, x))
            omega = body.omega
            momentum = body.turned * sp.diag(*body.inertia) * body.turned.T * omega
            total += (sp.diff(momentum, t) - sp.Matrix(body.moment)).dot(sp.diff(omega, sp.diff(x, t)))
        equations.append(total)
    names = tuple(s.name for s in lam.values())
    return Route(tuple(coordinates.split()), tuple(equations), geometric, kinematic, names)


def kane_of_bodies(
    coordinates: str,
    order: str,
    angles: Sequence[sp.Expr],
    inertia: Sequence[sp.Expr],
    mass: sp.Expr,
    centre: Sequence[sp.Expr],
    force: Sequence[sp.Expr],
) -> Route:
    """SymPy's KanesMethod for a body with a fixed point, its mass centre at `centre` in the body; u = q'."""
    q = moving(coordinates)
    u = dynamicsymbols(" ".join(f"speed_{n}" for n in coordinates.split()))
    rates = {sp.diff(x, t): s for x, s in zip(q, u, strict=True)}
    frame, origin = ReferenceFrame("N"), Point("O")
    origin.set_vel(frame, 0)
    own = frame.orientnew("B", "Body", angles, order)
    own.set_ang_vel(frame, own.ang_vel_in(frame).subs(rates))
    at = origin.locatenew("G", sum((c * e for c, e in zip(centre, own, strict=True)), Vector(0)))
    at.v2pt_theory(origin, frame, own)
    body = RigidBody("body", at, own, mass, (sp_inertia(own, *inertia), at))
    load = (at, sum((c * e for c, e in zip(force, frame, strict=True)), Vector(0)))
    method = KanesMethod(frame, list(q), list(u), [s - sp.diff(x, t) for x, s in zip(q, u, strict=True)])
    fr, frstar = method.kanes_equations([body], [load])
    back = {sp.diff(s, t): sp.diff(x, t, 2) for x, s in zip(q, u, strict=True)}
    speeds = {s: sp.diff(x, t) for x, s in zip(q, u, strict=True)}
    return Route(tuple(coordinates.split()), tuple(e.xreplace(back).xreplace(speeds) for e in fr + frstar))


def literature(
    coordinates: str,
    equations: Iterable[sp.Expr],
    geometric: Mapping[str, sp.Expr] | None = None,
    kinematic: Mapping[str, sp.Expr] | None = None,
    multipliers: str = "",
) -> Route:
    """Equations (each zero) copied by hand."""
    return Route(
        tuple(coordinates.split()), tuple(equations), dict(geometric or {}), dict(kinematic or {}), tuple(multipliers.split())
    )  # fmt: skip


# -- numbers ---------------------------------------------------------------------------------------------------------


WAVES = {"sin": lru_cache(mp.sin), "cos": lru_cache(mp.cos)}
"""Of the same angle at each trial of an unknown. Only `number` uses them, in sixty digits."""


@lru_cache(maxsize=4096)
def _compiled(expression: sp.Expr) -> tuple[tuple[str, ...], Callable[..., mpf]]:
    symbols = sorted(expression.free_symbols, key=lambda s: s.name)
    stand_ins = [sp.Symbol(f"v{n}") for n in range(len(symbols))]
    plain = expression.xreplace(dict(zip(symbols, stand_ins, strict=True)))
    return tuple(s.name for s in symbols), sp.lambdify(stand_ins, [plain], ["mpmath", WAVES], cse=once)


def once(expressions: Sequence[sp.Expr]) -> tuple[list[tuple[sp.Symbol, sp.Expr]], list[sp.Expr]]:
    """What occurs several times in expressions, by names; then the expressions with these names. For `lambdify(cse=...)`."""
    found: tuple[list[tuple[sp.Symbol, sp.Expr]], list[sp.Expr]] = tree_cse(expressions, sp.numbered_symbols("w"))
    return found


def number(expression: sp.Expr, state: State) -> mpf:
    """The value of an expression at a state, to sixty digits. Raises ValueError where it is not real."""
    with mp.workdps(DIGITS):
        names, function = _compiled(sp.sympify(expression))
        [found] = function(*(state[n] for n in names))
        value = mp.mpmathify(found)
        if isinstance(value, mp.mpc):
            if abs(value.imag) > TINY * (1 + abs(value.real)):
                raise ValueError("not a real number")
            value = value.real
        return value


@dataclass(frozen=True)
class Solved:
    """What a linear system determines; `consistent` is false where it has no solution."""

    values: Mapping[str, mpf]
    consistent: bool


def solved(rows: Sequence[Sequence[mpf]], names: Sequence[str]) -> Solved:
    """The unknowns that rows [A | b], each A x + b = 0, determine; (m, n + 1) -> at most n values."""
    with mp.workdps(DIGITS):
        work = [[mp.mpmathify(x) for x in row] for row in rows]
        work = [[x / s for x in row] for row in work if (s := max(abs(x) for x in row)) > 0]
        pivots: list[tuple[int, int]] = []
        done: set[int] = set()
        for _ in range(min(len(work), len(names))):
            _, r, c = max(
                ((abs(work[r][c]), r, c) for r in range(len(work)) if r not in done for c in range(len(names)) if c not in {p for _, p in pivots}),
                default=(mpf(0), 0, 0),
            )  # fmt: skip
            if abs(work[r][c]) < TINY:
                break
            work[r] = [x / work[r][c] for x in work[r]]
            for n, row in enumerate(work):
                if n != r and row[c] != 0:
                    work[n] = [a - row[c] * b for a, b in zip(row, work[r], strict=True)]
            done.add(r)
            pivots.append((r, c))
        consistent = all(abs(work[r][-1]) < 10**-35 for r in range(len(work)) if r not in done)
        free = [c for c in range(len(names)) if c not in {p for _, p in pivots}]
        values = {names[c]: -work[r][-1] for r, c in pivots if all(abs(work[r][f]) < 10**-35 for f in free)}
        return Solved(values, consistent)


def affine(expressions: Sequence[sp.Expr], names: Sequence[str], state: State) -> list[list[mpf]]:
    """Rows [A | b] of expressions that are affine in the named unknowns, read off at 0 and at unit vectors."""
    rows = []
    with mp.workdps(DIGITS):
        zero = {**state, **dict.fromkeys(names, mpf(0))}
        trial = {n: mpf(3 * k + 2) / 7 for k, n in enumerate(names)}
        for e in expressions:
            own = {s.name for s in e.free_symbols}
            constant = number(e, zero)
            slopes = [number(e, {**zero, n: mpf(1)}) - constant if n in own else mpf(0) for n in names]
            expected = constant + mp.fsum(c * trial[n] for n, c in zip(names, slopes, strict=True))
            size = 1 + abs(constant) + max((abs(c) for c in slopes), default=0)
            assert abs(number(e, {**zero, **trial}) - expected) < 10**-40 * size, "not affine in the unknowns"
            rows.append([*slopes, constant])
    return rows


def accelerations(route: Route, state: State) -> Solved:
    """What the route gives at a state."""
    return solved(affine(route.system, route.unknowns, state), route.unknowns)


# -- states ----------------------------------------------------------------------------------------------------------


def rational(source: random.Random, low: float, high: float) -> mpf:
    """A random number with a small denominator."""
    with mp.workdps(DIGITS):
        return mpf(round((low + (high - low) * source.random()) * 24)) / 24 + mpf(1) / source.randint(50, 99)


def least_change(rows: Sequence[Sequence[mpf]], right: Sequence[mpf]) -> list[mpf]:
    """The smallest x with A x = b, dependent rows left out; A (m, n), b (m,)."""
    with mp.workdps(DIGITS):
        basis: list[tuple[list[mpf], mpf]] = []
        for row, b in zip(rows, right, strict=True):
            row, b = list(row), b
            size = max((abs(x) for x in row), default=mpf(0))
            for other, c in basis:
                share = mp.fdot(row, other)
                row, b = [x - share * y for x, y in zip(row, other, strict=True)], b - share * c
            length = mp.sqrt(mp.fdot(row, row))
            if length > mpf(10) ** -25 * (1 + size):
                basis.append(([x / length for x in row], b / length))
        width = len(rows[0]) if rows else 0
        return [mp.fsum(c * v[k] for v, c in basis) for k in range(width)]


def _linear(expressions: Sequence[sp.Expr], names: Sequence[str], state: State) -> list[list[mpf]]:
    return [
        [number(e.diff(s), state) if (s := next((s for s in e.free_symbols if s.name == n), None)) else mpf(0) for n in names]
        for e in expressions
    ]  # fmt: skip


def placed(route: Route, start: Mapping[str, mpf]) -> dict[str, mpf] | None:
    """The state moved on the surface of the geometric constraints by Newton's method, or None."""
    state = dict(start)
    with mp.workdps(DIGITS):
        for _ in range(40):
            try:
                values = [number(f, state) for f in route.positions]
                if all(abs(v) < mpf(10) ** -55 for v in values):
                    return state
                change = least_change(_linear(route.positions, route.coordinates, state), [-v for v in values])
            except (ValueError, ZeroDivisionError):
                return None
            for q, dq in zip(route.coordinates, change, strict=True):
                state[q] += dq
    return None


def with_velocities(route: Route, start: Mapping[str, mpf]) -> dict[str, mpf]:
    """The state with its velocities changed so that they satisfy the constraints."""
    state = dict(start)
    names = [f"{q}'" for q in route.coordinates]
    with mp.workdps(DIGITS):
        values = [number(e, state) for e in route.rates]
        change = least_change(_linear(route.rates, names, state), [-v for v in values])
        for n, dv in zip(names, change, strict=False):
            state[n] += dv
        assert all(abs(number(e, state)) < mpf(10) ** -50 for e in route.rates), "no velocities"
    return state


def drawn(source: random.Random, names: Iterable[str], ranges: Mapping[str, tuple[float, float]]) -> dict[str, mpf]:
    """Random numbers for symbols; velocities are of either sign."""
    found = {}
    for n in sorted(names):
        default = (-1.5, 1.5) if n.endswith("'") else (0.2, 1.4)
        found[n] = rational(source, *ranges.get(n, default))
        if ranges.get(n) == (-1, 1) and n.startswith("sigma"):
            found[n] = mpf(source.choice((-1, 1)))
    return found


def states(
    route: Route, extra: Iterable[str], ranges: Mapping[str, tuple[float, float]], seed: int, count: int
) -> Iterator[dict[str, mpf]]:
    """Random states on the constraint surface; `extra` are further symbols that need a value."""
    source = random.Random(seed)
    moving_names = {n + p for n in route.coordinates for p in ("", "'")}
    names = {n for n in (*route.names, *extra, *moving_names, "t") if n not in route.unknowns}
    found = 0
    for _ in range(60 * count):
        state = placed(route, drawn(source, names, ranges))
        if state is None:
            continue
        yield with_velocities(route, state)
        found += 1
        if found == count:
            return
    raise AssertionError("no states were found")
