"""dy/dt = f(t, y), by second routes: SymPy's equations, conserved quantities, motions that are known in closed form."""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Sequence
from functools import cache, partial
from typing import Any

import mpmath
import pytest
import sympy as sp
from sympy.physics.mechanics import LagrangesMethod, dynamicsymbols

import lagrange
from lagrange.api.numerical import _solved

t = sp.Symbol("t")


@cache
def solved(name: str) -> lagrange.Result:
    return lagrange.solve(lagrange.load(name))


def integrated(f: Callable[[float, Sequence[float]], Any], y: Sequence[float], end: float, steps: int) -> list[float]:
    """The state at the end, by the classical Runge-Kutta method."""
    h, now, state = end / steps, 0.0, [*y]
    for _ in range(steps):
        k1 = f(now, state)
        k2 = f(now + h / 2, [a + h / 2 * b for a, b in zip(state, k1, strict=True)])
        k3 = f(now + h / 2, [a + h / 2 * b for a, b in zip(state, k2, strict=True)])
        k4 = f(now + h, [a + h * b for a, b in zip(state, k3, strict=True)])
        state = [a + h / 6 * (p + 2 * q + 2 * r + s) for a, p, q, r, s in zip(state, k1, k2, k3, k4, strict=True)]
        now += h
    return state


def close(a: Sequence[float], b: Sequence[float], tolerance: float = 1e-9) -> bool:
    return len(a) == len(b) and all(
        math.isclose(x, y, rel_tol=tolerance, abs_tol=tolerance) for x, y in zip(a, b, strict=True)
    )


# against SymPy


DOUBLE = {"m1": 1.5, "m2": 0.7, "l1": 1.1, "l2": 0.6, "g": 9.81}


@pytest.mark.parametrize("y", [(0.3, -0.4, 1.0, 2.0), (2.0, 1.0, -0.5, 0.25), (0.0, 3.0, 4.0, 0.0)])
def test_the_double_pendulum_is_that_of_sympy(y: tuple[float, ...]) -> None:
    q1, q2 = dynamicsymbols("q1 q2")
    m1, m2, l1, l2, g = sp.symbols("m1 m2 l1 l2 g")
    a = sp.Matrix([l1 * sp.sin(q1), l1 * sp.cos(q1)])
    b = a + sp.Matrix([l2 * sp.sin(q2), l2 * sp.cos(q2)])
    kinetic = sum(m * v.diff(t).dot(v.diff(t)) / 2 for m, v in ((m1, a), (m2, b)))
    method = LagrangesMethod(kinetic + m1 * g * a[1] + m2 * g * b[1], [q1, q2])
    method.form_lagranges_equations()
    state = dict(zip((q1, q2, q1.diff(t), q2.diff(t)), y, strict=True))
    rule = {**state, **{sp.Symbol(k): v for k, v in DOUBLE.items()}}
    at = lambda matrix: sp.Matrix(matrix.subs(rule)).evalf()  # noqa: E731
    expected = at(method.mass_matrix).LUsolve(at(method.forcing))
    found = solved("ex18")["angles"].right_hand_side(DOUBLE)(0.0, y)
    assert close(found, [*y[2:], *map(float, expected)])


def test_dependent_coordinates_give_the_same_motion() -> None:
    result = solved("ex18")
    angles = result["angles"].right_hand_side(DOUBLE)
    y = (0.3, -0.4, 1.0, 2.0)
    own = result.own.right_hand_side({sp.Symbol(k): v for k, v in DOUBLE.items()})
    configuration = result["angles"].configuration
    names = [q.name + "'" * order for q in result.own.coordinates for order in range(3)]
    written = {n: configuration.rewritten(sp.Symbol(n, real=True)) for n in names}
    values = {n: angles.function(e)(0.0, y) for n, e in written.items()}
    state = own.state({k: v for k, v in values.items() if not k.endswith("''")})
    assert close(own.violation(0.0, state), [0.0] * 4)
    assert close(own(0.0, state)[4:], [values[f"{q}''"] for q in result.own.coordinates])
    for name, value in own.multipliers(0.0, state).items():
        found = result["angles"].reactions[name.removeprefix("lambda_")]
        assert math.isclose(value, angles.function(found)(0.0, y))


# what is conserved, and motions that are known


ENERGIES = [
    ("ex18", "angles", False, [0.5, 1.0, 0.0, 1.0]),
    ("heavy-top", "", False, [0.1, 0.9, 0.2, 0.5, 0.3, 4.0]),
    ("euler-rigid-body", "", True, [0.1, 0.9, 0.2, 0.5, 1.3, 0.2]),
    ("sleigh", "", True, [0.0, 0.0, 0.3, 1.0, 2.0]),
    ("swinging-atwood", "swing", False, [1.0, 0.4, 0.0, 0.0]),
]


@pytest.mark.parametrize(("name", "choice", "speeds", "y"), ENERGIES, ids=[e[0] for e in ENERGIES])
def test_what_is_conserved_stays(name: str, choice: str, speeds: bool, y: list[float]) -> None:
    here = solved(name)[choice]
    values = {p.symbol: 1 + 0.2 * k for k, p in enumerate(here.problem.parameters)}
    f = here.right_hand_side(values, speeds=speeds)
    after = integrated(f, y, 1.0, 200)
    assert here.conserved
    assert not close(after, y, 1e-3)
    for integral in here.conserved:
        value = f.function(integral.expression)
        assert math.isclose(value(0.0, y), value(1.0, after), rel_tol=1e-7)


def test_the_period_of_a_pendulum() -> None:
    amplitude, l, g = 1.2, 0.8, 9.81
    period = float(4 * math.sqrt(l / g) * mpmath.ellipk(math.sin(amplitude / 2) ** 2))
    f = solved("ex11")["angle"].right_hand_side({"l": l, "g": g, "m": 3})
    start = f.state({"theta": amplitude})
    assert close(integrated(f, start, period, 400), start, 1e-7)


def test_the_sleigh_of_chaplygin() -> None:
    here, m, inertia, a = solved("sleigh").own, 2.0, 0.7, 0.4
    values = {"m": m, "I_G": inertia, "a": a}
    f = here.right_hand_side(values, speeds=True)
    assert f.names == ("x", "y", "theta", "u", "omega")
    theta, u, omega = 0.4, 1.3, -0.7
    expected = [
        u * math.cos(theta),
        u * math.sin(theta),
        omega,
        a * omega**2,
        -m * a * u * omega / (inertia + m * a**2),
    ]
    assert close(f(0.0, [0.2, 0.1, theta, u, omega]), expected)
    g = here.right_hand_side(values)  # the same motion with the multiplier of the blade
    y = [0.2, 0.1, theta, u * math.cos(theta), u * math.sin(theta), omega]
    assert close(g.violation(0.0, y), [0.0])
    by_speeds, by_multiplier = integrated(f, [0.2, 0.1, theta, u, omega], 1.0, 100), integrated(g, y, 1.0, 100)
    assert close(by_speeds[:3], by_multiplier[:3], 1e-7)
    assert set(g.multipliers(0.0, y)) == {"lambda_blade"}


def test_what_is_lost_of_a_constraint_dies_out() -> None:
    own = solved("ex11").own
    values = {"m": 1, "l": 1, "g": 9.81}
    plain, pulled = own.right_hand_side(values), own.right_hand_side(values, stabilised=5.0)
    off = plain.state({"x": 0.61, "y": 0.8})  # 0.01 beside the circle
    start = plain.violation(0.0, off)[0]
    assert abs(plain.violation(1.0, integrated(plain, off, 1.0, 200))[0]) > start / 2
    # g'' + 2α g' + α² g = 0 with g'(0) = 0
    expected = start * (1 + 5.0) * math.exp(-5.0)
    assert math.isclose(pulled.violation(1.0, integrated(pulled, off, 1.0, 200))[0], expected, rel_tol=1e-4)
    skate = solved("sleigh").own
    given = {"m": 1, "I_G": 1, "a": 1}
    f = skate.right_hand_side(given, stabilised=3.0)
    start = f.violation(0.0, sideways := f.state({"y'": 0.1}))[0]
    assert math.isclose(f.violation(1.0, integrated(f, sideways, 1.0, 100))[0], start * math.exp(-3.0), rel_tol=1e-6)


def test_constraints_that_follow_from_others_do_no_harm() -> None:
    twice = lagrange.loads(
        "title: p\nparameters: [m, g, l]\ncoordinates: [x, y]\nparticles: {P: {mass: m, position: x*i + y*j}}\n"
        "constraints: {rod: x^2 + y^2 = l^2, again: x*x' + y*y' = 0}\ngravity: g*j\n"
    )
    f = lagrange.solve(twice).own.right_hand_side({"m": 1, "g": 9.81, "l": 1})
    g = solved("ex11").own.right_hand_side({"m": 1, "g": 9.81, "l": 1})
    assert close(f(0, [0.6, 0.8, 0.8, -0.6]), g(0, [0.6, 0.8, 0.8, -0.6]))


# undefined functions, prescribed motions, unknown forces


LIFT = """
title: Pendulum in a lift
parameters: {m: {value: 2}, l: {value: 1/2}, g: {value: 9.81}}
coordinates: [theta]
functions: {u: [t]}
particles: {P: {mass: m, position: l*sin(theta)*i + (l*cos(theta) - u)*j}}
gravity: g*j
"""
MOTIONS: dict[str, Any] = {
    "expression": sp.Rational(1, 10) * sp.sin(3 * sp.Symbol("t")),
    "with a parameter": sp.Symbol("l") / 5 * sp.sin(3 * t),
    "function of SymPy": lambda time: sp.sin(3 * time) / 10,
    "functions of numbers": (
        lambda s: 0.1 * math.sin(3 * s),
        lambda s: 0.3 * math.cos(3 * s),
        lambda s: -0.9 * math.sin(3 * s),
    ),
    "by orders": {(2,): lambda s: -0.9 * math.sin(3 * s)},
}


@pytest.mark.parametrize("motion", MOTIONS.values(), ids=MOTIONS)
def test_a_prescribed_motion_is_given(motion: Any) -> None:
    f = lagrange.solve(lagrange.loads(LIFT)).own.right_hand_side(functions={"u": motion})
    time, theta = 0.4, 0.3
    lifted = -0.9 * math.sin(3 * time)
    assert close(f(time, [theta, 1.0]), [1.0, -(9.81 + lifted) / 0.5 * math.sin(theta)])


def test_what_is_not_given_is_asked_for() -> None:
    own = lagrange.solve(lagrange.loads(LIFT)).own
    for functions, said in [
        ({}, "u(t), which is not given"),
        ({"u": (math.sin,)}, "the derivative of `u` of order 2"),
        ({"u": lambda s: math.sin(s)}, "cannot be differentiated.*SymPy's functions"),
        ({"v": t}, "there is no function `v`; those of the problem are u"),
        ({"u": sp.Symbol("amplitude") * sp.sin(t)}, "a number is needed for `amplitude`"),
    ]:
        with pytest.raises(ValueError, match=said.replace("(", r"\(").replace(")", r"\)")):
            own.right_hand_side(functions=functions)
    g = own.right_hand_side({"amplitude": 0}, functions={"u": sp.Symbol("amplitude") * sp.sin(t)})
    assert close(g(0.0, [0.1, 0.0]), [0.0, -9.81 / 0.5 * math.sin(0.1)])


def test_an_undefined_surface_is_given() -> None:
    """f = x² + y² + z², by an expression and by functions of numbers: N = −m(v² + r·F/m)/r², along 2r."""

    def doubled(n: int, *place: float) -> float:
        return 2 * place[n]

    x, y, z = sp.symbols("X Y Z")
    squares = {
        (0, 0, 0): lambda a, b, c: a * a + b * b + c * c,
        **{tuple(int(k == n) for k in range(3)): partial(doubled, n) for n in range(3)},
        **{tuple(2 * int(k == n) for k in range(3)): (lambda *_: 2.0) for n in range(3)},
        **{tuple(int(k != n) for k in range(3)): (lambda *_: 0.0) for n in range(3)},
    }
    state = [0.6, 0.0, 0.8, 0.8, 0.5, -0.6]
    for given in (x**2 + y**2 + z**2, squares):
        weight = {"F_x": sp.S.Zero, "F_y": sp.S.Zero, "F_z": -19.62}
        f = solved("ex12").own.right_hand_side({"m": 2, "c": 1}, functions={"f": given, **weight})
        assert close(f.violation(0.0, state), [0.0, 0.0])
        pull = -(0.8**2 + 0.5**2 + 0.6**2) + 9.81 * 0.8
        expected = [0.6 * pull, 0.0, 0.8 * pull - 9.81]
        assert close(f(0.0, state)[3:], expected)
        assert math.isclose(f.multipliers(0.0, state)["lambda_surface"], pull)  # m r'' = F + 2 λ r with m = 2


def test_an_unknown_force_is_given_a_law() -> None:
    problem = lagrange.loads(
        "title: p\nparameters: {m: {value: 1}}\ncoordinates: [x]\nparticles: {P: {mass: m, position: x*i}}\n"
        "unknowns: [P]\nforces: {push: {on: P, vector: P*i}}\n"
    )
    own = lagrange.solve(problem).own
    f = own.right_hand_side({"k": 4}, functions={"P": -sp.Symbol("k") * sp.Symbol("x") - 2 * sp.Symbol("x'")})
    assert close(f(0.0, [0.5, 0.25]), [0.25, -2.5])
    assert close(own.right_hand_side({"P": 3})(0.0, [0.5, 0.25]), [0.25, 3.0])


def test_friction_and_its_sense() -> None:
    f = solved("mass-on-belt")["along"].right_hand_side({"m": 1, "c": 2, "v": 1, "mu": 0.5, "g": 10})
    assert [f(0.0, [0.1, v])[1] for v in (0.0, 1.0, 2.0)] == pytest.approx([4.8, -0.2, -5.2])


def test_time_stands_in_the_equations() -> None:
    values = {"m": 1, "l": 0.5, "a": 0.1, "Omega": 20, "g": 9.81}
    f = solved("kapitza-pendulum")["angle"].right_hand_side(values)
    expected = (9.81 - 0.1 * 400 * math.cos(20 * 0.3)) * math.sin(0.2) / 0.5
    assert close(f(0.3, [0.2, 0.0]), [0.0, expected])


# numbers that are missing, or are none


def test_numbers_that_do_not_fit() -> None:
    angle, depth = solved("ex11")["angle"], solved("ex11")["depth"]
    for values, said in [
        ({"m": 1, "g": 9.81}, r"a number is needed for `l` \(length of the rod\): right_hand_side\({'l': ...}\)"),
        ({}, "`g` .*, `l` .*, `m`"),
        ({"m": 1, "g": 9.81, "L": 1}, "there is no parameter `L`; did you mean `l`"),
        ({"m": 1, "g": 9.81, "l": -1}, "`l` is positive in the problem, and -1 is not; declare it as `l: real`"),
        ({"m": 1, "g": 9.81, "l": "long"}, "`l` needs a number, and 'long' is none"),
        ({"m": 1, "g": 9.81, "l": math.nan}, "`l` needs a number, and nan is none"),
        ({"m": 1, "g": 9.81, "l": 1j}, "needs a number"),
    ]:
        with pytest.raises(ValueError, match=said):
            angle.right_hand_side(values)
    values = {"m": 1, "g": 9.81, "l": 1}
    assert depth.right_hand_side({**values, "sigma_1": -1})(0.0, [0.5, 0.0])  # which does not occur
    with pytest.raises(ValueError, match="no quasi-velocities"):
        angle.right_hand_side(values, speeds=True)
    with pytest.raises(ValueError, match="`stabilised` is a rate"):
        angle.right_hand_side(values, stabilised=-1)
    with pytest.raises(ValueError, match="one of 'math', 'numpy'"):
        angle.right_hand_side(values, module="cupy")


def test_the_branch_of_a_square_root_is_asked_for() -> None:
    text = (
        "title: p\nparameters: [m, g, l]\ncoordinates: [x, y]\nparticles: {P: {mass: m, position: x*i + y*j}}\n"
        "constraints: {rod: x^2 + y^2 = l^2}\ngravity: g*(i + j)\ngeneralized_coordinates: {depth: {coordinates: [y]}}\n"
    )
    depth, values = lagrange.solve(lagrange.loads(text))["depth"], {"m": 1, "g": 10, "l": 1}
    with pytest.raises(ValueError, match=r"`sigma_1` \(\+1 or -1: the branch of a square root\)"):
        depth.right_hand_side(values)
    with pytest.raises(ValueError, match=r"`sigma_1` is \+1 or -1 in the problem, and 2 is not"):
        depth.right_hand_side({**values, "sigma_1": 2})
    for sign in (1, -1):  # x = ±0.6, y = 0.8, at rest: the acceleration is g along the tangent (−y, x)
        found = depth.right_hand_side({**values, "sigma_1": sign})(0.0, [0.8, 0.0])[1]
        assert math.isclose(found, 10 * (0.6 * sign - 0.8) * 0.6 * sign)


def test_values_of_the_file_are_defaults() -> None:
    own = lagrange.solve(lagrange.loads(LIFT)).own
    assert own.right_hand_side(functions={"u": 0 * t}).values == {"m": 2.0, "l": 0.5, "g": 9.81}
    assert own.right_hand_side({"l": 3}, functions={"u": 0 * t}).values["l"] == 3.0


def test_states_that_do_not_fit() -> None:
    f = solved("ex11").own.right_hand_side({"m": 1, "g": 9.81, "l": 1})
    assert f.state({"y": 1, sp.Symbol("x'"): 2}) == [0.0, 1.0, 2.0, 0.0]
    assert repr(f) == "<f(t, y) with y = (x, y, x', y'); m=1, g=9.81, l=1>"
    with pytest.raises(ValueError, match="`z` is no component of y, which has x, y, x', y'"):
        f.state({"z": 1})
    with pytest.raises(ValueError, match="y has 4 components, and 2 are given"):
        f(0.0, [0.0, 1.0])
    with pytest.raises(ArithmeticError, match="at t = 2 the accelerations are not determined"):
        f(2.0, [0.0, 0.0, 1.0, 0.0])
    with pytest.raises(ArithmeticError):
        f(0.0, [math.nan, 1.0, 0.0, 0.0])
    names = "x', x'', lambda_rod, g, t"
    value = f.function(sum(10**n * s for n, s in enumerate(map(sp.Symbol, names.split(", ")))))
    assert math.isclose(value(2.0, [0.0, 1.0, 3.0, 0.0]), 3 + 100 * (-9 - 9.81) / 2 + 1000 * 9.81 + 20000)
    with pytest.raises(ValueError, match="a number is needed for `w`"):
        f.function(sp.Symbol("w"))
    sleigh = solved("sleigh").own.right_hand_side({"m": 1, "I_G": 1, "a": 1}, speeds=True)
    with pytest.raises(ValueError, match="is not known in this state, which has x, y, theta, u, omega"):
        sleigh.function(sp.Symbol("x''", real=True))


def test_names_of_a_file_are_never_code() -> None:
    problem = lagrange.loads(
        "title: p\nparameters: [lambda, print, exec, y0, call0]\ncoordinates: [def, y1]\nfunctions: {import: [t]}\n"
        "particles: {P: {mass: lambda, position: (def + import)*i + exec*print*y1*j}}\ngravity: y0*call0*j\n"
    )
    values = {"lambda": 2, "print": 3, "exec": 5, "y0": 7, "call0": 11}
    f = lagrange.solve(problem).own.right_hand_side(values, functions={"import": (None, None, lambda s: s)})
    assert close(f(4.0, [0.0, 0.0, 0.1, 0.2]), [0.1, 0.2, -4.0, 77 / 15])


def test_linear_equations_are_solved_with_pivots() -> None:
    matrix = [[0.0, 2.0, 1.0], [1e-9, 1e-9, 0.0], [3e9, 0.0, -1e9]]
    right = [5.0, 3e-9, 0.0]
    assert close(_solved(matrix, right), _exact(matrix, right))
    with pytest.raises(ZeroDivisionError):
        _solved([[1.0, 2.0], [0.5, 1.0]], [1.0, 1.0])
    with pytest.raises(ZeroDivisionError):
        _solved([[0.0]], [1.0])


def _exact(matrix: list[list[float]], right: list[float]) -> list[float]:
    exact = sp.Matrix([[sp.Rational(x) for x in row] for row in matrix])
    return [float(x) for x in exact.LUsolve(sp.Matrix([sp.Rational(x) for x in right]))]


def test_numpy_where_it_is_installed() -> None:
    numpy = pytest.importorskip("numpy")
    values = {"m": 1, "g": 9.81, "l": 1}
    for here in (solved("ex11").own, solved("ex11")["angle"]):
        f, g = here.right_hand_side(values), here.right_hand_side(values, module="numpy")
        y = [0.6, 0.8, 0.8, -0.6][: len(f.names)]
        found = g(0.0, numpy.array(y))
        assert isinstance(found, numpy.ndarray)
        assert found.shape == (len(y),)
        assert close(f(0.0, numpy.array(y)), [*map(float, found)])


def test_numpy_is_not_needed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "numpy", None)
    values = {"m": 1, "g": 9.81, "l": 1}
    assert solved("ex11")["angle"].right_hand_side(values)(0.0, [0.1, 0.0])
    with pytest.raises(ImportError):
        solved("ex11")["angle"].right_hand_side(values, module="numpy")


def test_functions_broadcast_over_arrays() -> None:
    import numpy as np

    f = solved("ex18")["angles"].right_hand_side(DOUBLE, module="numpy")
    states = np.array([[0.1, 0.7, 2.0], [0.3, -0.2, 1.0], [0.0, 1.0, -1.0], [2.0, 0.5, 0.0]])
    together = f(0.0, states)
    assert together.shape == (4, 3)
    assert np.allclose(together[:, 1], f(0.0, states[:, 1]))
    energy = f.function(solved("ex18")["angles"].conserved[0].expression)
    assert np.allclose(energy(0.0, states), [energy(0.0, states[:, k]) for k in range(3)])
