"""The shipped problems of motion (`problems/motion/*.yaml`), each with its equations by a second route.

As in `textbook_systems` and `body_systems`: SymPy's LagrangesMethod and KanesMethod on energies and positions that are
typed from the drawing, Newton's and Euler's law in fixed components, or equations derived on paper. Where a problem has
a reaction to show, one of its routes has multipliers.
"""

from __future__ import annotations

from collections.abc import Callable

import sympy as sp
from sympy import Rational, cos, diff, sin, sqrt

from tests.support.second_route import (
    Rigid,
    Route,
    constants,
    kane,
    lagrange,
    literature,
    moving,
    newton,
    newton_euler,
    rotation,
    t,
)
from tests.truth import body_systems as bodies
from tests.truth.body_systems import flat
from tests.truth.textbook_systems import HOLONOMIC, NONHOLONOMIC, RHEONOMIC, Textbook, d, speed2

HALF = Rational(1, 2)
Vector3 = tuple[sp.Expr, sp.Expr, sp.Expr]


# -- pendulums -------------------------------------------------------------------------------------------------------


def kapitza_pendulum() -> tuple[Route, ...]:
    x, y = moving("x y")
    m, l, a, omega, g = constants("m l a Omega g")
    rod = {"rod": x**2 + (y - a * cos(omega * t)) ** 2 - l**2}
    return (newton("x y", [(m, (x, y), (0, -m * g))], rod),)


def shortening_pendulum() -> tuple[Route, ...]:
    r, phi, l = moving("r phi l")
    m, g = constants("m g")
    at = (r * cos(phi), r * sin(phi))
    return (newton("r phi", [(m, at, (m * g, 0))], {"rope": r - l}),)


def pole_on_cart() -> tuple[Route, ...]:
    """Newton and Euler; Kane's method with the pole as two particles of the same mass, centre and inertia."""
    x, theta, force = moving("x theta F")
    big, m, l, b, g = constants("M m l b g")
    push = force - b * d(x)
    pole = flat(m, (x + l * sin(theta), l * cos(theta)), m * l**2 / 3, -theta, force=(0, -m * g, 0))
    cart = Rigid(big, (x, 0, 0), sp.eye(3), (0, 0, 0), force=(push, 0, 0))
    halves = [l * (1 + s / sqrt(3)) for s in (-1, 1)]
    points = [(big, (x, sp.S.Zero, sp.S.Zero), (push, 0, 0))]
    points += [(m / 2, (x + h * sin(theta), h * cos(theta), sp.S.Zero), (0, -m * g / 2, 0)) for h in halves]
    return (newton_euler("x theta", [cart, pole]), kane("x theta", points))


def three_link_chain() -> tuple[Route, ...]:
    names = "x1 y1 x2 y2 x3 y3"
    x1, y1, x2, y2, x3, y3 = moving(names)
    m, l, g = constants("m l g")
    rods = {
        "upper": x1**2 + y1**2 - l**2,
        "middle": (x2 - x1) ** 2 + (y2 - y1) ** 2 - l**2,
        "lower": (x3 - x2) ** 2 + (y3 - y2) ** 2 - l**2,
    }
    masses = [(m, r, (0, m * g)) for r in ((x1, y1), (x2, y2), (x3, y3))]
    kinetic = m * speed2(x1, y1, x2, y2, x3, y3) / 2
    return (newton(names, masses, rods), lagrange(names, kinetic, -m * g * (y1 + y2 + y3), geometric=rods))


def particle_in_bowl() -> tuple[Route, ...]:
    x, y, z = moving("x y z")
    m, l, g = constants("m l g")
    bowl = {"bowl": x**2 + y**2 + z**2 - l**2}
    point = [(m, (x, y, z), (0, 0, -m * g))]
    return (newton("x y z", point, bowl), kane("x y z", point, "z", bowl))


def foucault_pendulum() -> tuple[Route, ...]:
    """Newton's law in the fixed frame; and relative to the earth, a = a_rel + 2 Omega x v + Omega x (Omega x r)."""
    x, y = moving("x y")
    m, w, turn, lat = constants("m w Omega lambda")
    east = (-sin(turn * t), cos(turn * t), sp.S.Zero)
    north = (-sin(lat) * cos(turn * t), -sin(lat) * sin(turn * t), cos(lat))
    r = tuple(x * e + y * n for e, n in zip(east, north, strict=True))
    omega, here = sp.Matrix([0, turn * cos(lat), turn * sin(lat)]), sp.Matrix([x, y, 0])
    relative = d(here, 2) + 2 * omega.cross(d(here)) + omega.cross(omega.cross(here)) + w**2 * here
    return (
        newton("x y", [(m, r, tuple(-m * w**2 * c for c in r))]),
        literature("x y", (relative[0], relative[1])),
    )


def spring_pendulum() -> tuple[Route, ...]:
    r, phi = moving("r phi")
    m, c, l, g = constants("m c l g")
    kinetic = m * (d(r) ** 2 + r**2 * d(phi) ** 2) / 2
    return (lagrange("r phi", kinetic, c * (r - l) ** 2 / 2 - m * g * r * cos(phi)),)


def bell_and_clapper() -> tuple[Route, ...]:
    alpha, beta = moving("alpha beta")
    big, m, i1, i2, a, b, l, g = constants("M m I_1 I_2 a b l g")
    pin = (l * cos(alpha), l * sin(alpha))
    bell = flat(big, (a * cos(alpha), a * sin(alpha)), i1, alpha, force=(big * g, 0, 0))
    clapper = flat(m, (pin[0] + b * cos(beta), pin[1] + b * sin(beta)), i2, beta, force=(m * g, 0, 0))
    return (newton_euler("alpha beta", [bell, clapper]),)


# -- strings, wires, wedges ------------------------------------------------------------------------------------------


def turning_parabola() -> tuple[Route, ...]:
    rho, phi, z = moving("rho phi z")
    m, c, turn, g = constants("m c Omega g")
    wire = {"wire": z - c * rho**2, "turning": phi - turn * t}
    at = (rho * cos(phi), rho * sin(phi), z)
    return (newton("rho phi z", [(m, at, (0, 0, -m * g))], wire),)


def swinging_atwood() -> tuple[Route, ...]:
    r, theta, y = moving("r theta y")
    big, m, length, g = constants("M m L g")
    points = [(m, (r * cos(theta), r * sin(theta)), (m * g, 0)), (big, (y, sp.S.Zero), (big * g, 0))]
    return (newton("r theta y", points, {"string": length - r - y}),)


def double_atwood() -> tuple[Route, ...]:
    """Each weight, each pulley: m y'' = m g - tension, and I alpha'' from the difference of two tensions."""
    names = "y1 p y2 y3 alpha beta"
    y1, p, y2, y3, alpha, beta = moving(names)
    m1, m2, m3, big, i1, i2, radius, r, depth, g = constants("m1 m2 m3 M I_1 I_2 R r d g")
    f1, f, f2, f3 = (sp.Symbol(f"lambda_{n}") for n in ("S1", "S", "S2", "S3"))
    equations = (
        m1 * d(y1, 2) - m1 * g + f1,
        big * d(p, 2) - big * g + f - f2 - f3,
        m2 * d(y2, 2) - m2 * g + f2,
        m3 * d(y3, 2) - m3 * g + f3,
        i1 * d(alpha, 2) - radius * (f1 - f),
        i2 * d(beta, 2) - r * (f3 - f2),
    )
    strings = {
        "S1": y1 - depth - radius * alpha, "S": p - depth + radius * alpha, "S2": y2 - p + r * beta, "S3": y3 - p - r * beta
    }  # fmt: skip
    return (literature(names, equations, strings, multipliers="lambda_S1 lambda_S lambda_S2 lambda_S3"),)


def slope_of(X: sp.Expr, s: sp.Expr, h: sp.Expr, alpha: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    return (X + s * cos(alpha) + h * sin(alpha), -s * sin(alpha) + h * cos(alpha))


def cylinder_on_wedge() -> tuple[Route, ...]:
    X, s, h, psi = moving("X s h psi")
    big, m, radius, alpha, g = constants("M m R alpha g")
    cylinder = flat(m, slope_of(X, s, h, alpha), m * radius**2 / 2, -psi, force=(0, -m * g, 0))
    wedge = Rigid(big, (X, 0, 0), sp.eye(3), (0, 0, 0), force=(0, -big * g, 0))
    bound = {"rolling": d(s) - h * d(psi)}
    return (newton_euler("X s h psi", [wedge, cylinder], {"contact": h - radius}, bound),)


def bowling_ball() -> tuple[Route, ...]:
    """Newton and Euler: the lane's force N, and mu N against the slip, to the left at the lowest point."""
    x, y, theta = moving("x y theta")
    m, radius, mu, g = constants("m R mu g")
    normal = sp.Symbol("lambda_lane")
    equations = [
        m * d(x, 2) + mu * normal,
        m * d(y, 2) - normal + m * g,
        Rational(2, 5) * m * radius**2 * d(theta, 2) + radius * mu * normal,
    ]
    return (literature("x y theta", equations, {"lane": y - radius}, multipliers="lambda_lane"),)


def rough_ladder() -> tuple[Route, ...]:
    """Free body: from the floor N and mu N toward the wall, from the wall its N and nu N upward."""
    x, y, theta = moving("x y theta")
    m, l, mu, nu, g = constants("m l mu nu g")
    floor, wall = sp.symbols("lambda_floor lambda_wall")
    equations = [
        m * d(x, 2) - wall + mu * floor,
        m * d(y, 2) - floor - nu * wall + m * g,
        m * l**2 / 3 * d(theta, 2)
        - l * floor * (sin(theta) - mu * cos(theta))
        + l * wall * (cos(theta) + nu * sin(theta)),
    ]
    bound = {"wall": x - l * sin(theta), "floor": y - l * cos(theta)}
    return (literature("x y theta", equations, bound, multipliers="lambda_wall lambda_floor"),)


def cylinder_on_rough_incline() -> tuple[Route, ...]:
    """The energies of a cylinder that rolls."""
    x, y, theta = moving("x y theta")
    m, radius, alpha, g = constants("m R alpha g")
    kinetic = HALF * m * (d(x) ** 2 + d(y) ** 2) + m * radius**2 / 4 * d(theta) ** 2
    height = m * g * (y * cos(alpha) - x * sin(alpha))
    bound, rolling = {"plane": y - radius}, {"rolling": d(x) - radius * d(theta)}
    return (lagrange("x y theta", kinetic, height, geometric=bound, kinematic=rolling),)


def disc_in_a_corner() -> tuple[Route, ...]:
    """Free body: N_1 from the floor with mu N_1 toward the wall, N_2 from the wall with mu N_2 upward."""
    x, y, theta = moving("x y theta")
    m, radius, mu, g = constants("m R mu g")
    up, back = sp.symbols("lambda_floor lambda_wall")
    equations = [
        m * d(x, 2) - mu * up - back,
        m * d(y, 2) - up + m * g + mu * back,
        m * radius**2 / 2 * d(theta, 2) + mu * radius * (up - back),
    ]
    return (
        literature("x y theta", equations, {"floor": y - radius, "wall": x}, multipliers="lambda_floor lambda_wall"),
    )


def ball_on_a_string() -> tuple[Route, ...]:
    x, y = moving("x y")
    m, l, g = constants("m l g")
    return (newton("x y", [(m, (x, y), (0, -m * g))], {"string": x**2 + y**2 - l**2}),)


def rough_wedge() -> tuple[Route, ...]:
    """Free bodies: on the block N along the normal and mu N up the face, on the wedge their opposites and the floor."""
    X, Y, s, h = moving("X Y s h")
    big, m, mu, alpha, g = constants("M m mu alpha g")
    normal, floor = sp.Symbol("lambda_face"), sp.Symbol("lambda_floor")
    away, down = sp.Matrix([sin(alpha), cos(alpha)]), sp.Matrix([cos(alpha), -sin(alpha)])
    weight, block = sp.Matrix([0, -g]), sp.Matrix([X, Y]) + s * down + h * away
    on_block = m * d(block, 2) - m * weight - normal * away + mu * normal * down
    on_wedge = big * d(sp.Matrix([X, Y]), 2) - big * weight + normal * away - mu * normal * down
    on_wedge -= sp.Matrix([0, floor])
    bound = {"floor": Y, "face": h}
    equations = (*on_block, *on_wedge)
    return (literature("X Y s h", equations, bound, multipliers="lambda_floor lambda_face"),)


def mass_on_belt() -> tuple[Route, ...]:
    x, y = moving("x y")
    m, c, v, mu, g = constants("m c v mu g")
    normal = sp.Symbol("lambda_belt")
    equations = (m * d(x, 2) + c * x - mu * normal * sp.sign(v - d(x)), m * d(y, 2) + m * g - normal)
    return (literature("x y", equations, {"belt": y}, multipliers="lambda_belt"),)


def coupled_oscillators() -> tuple[Route, ...]:
    x1, x2 = moving("x1 x2")
    m, c, kappa, b, l, length = constants("m c kappa b l L")
    between, closing = kappa * (x2 - x1 - l), b * (d(x2) - d(x1))
    book = (
        m * d(x1, 2) + c * (x1 - l) - between - closing,
        m * d(x2, 2) + between + closing - c * (length - x2 - l),
    )
    return (literature("x1 x2", book),)


def wheel_suspension() -> tuple[Route, ...]:
    z1, z2, u = moving("z1 z2 u")
    big, m, c, tyre, b = constants("M m c c_T b")
    pull = c * (z1 - z2) + b * (d(z1) - d(z2))
    return (literature("z1 z2", (big * d(z1, 2) + pull, m * d(z2, 2) - pull + tyre * (z2 - u))),)


# -- rolling ---------------------------------------------------------------------------------------------------------


def swinging_yo_yo() -> tuple[Route, ...]:
    """The force of the thread is along the thread and acts where it touches the drum."""
    s, phi, psi = moving("s phi psi")
    m, inertia, r, g = constants("m I_G r g")
    along, across = sp.Matrix([cos(phi), sin(phi)]), sp.Matrix([-sin(phi), cos(phi)])
    tension = sp.Symbol("lambda_thread")
    newtons = m * d(s * along + r * across, 2) - sp.Matrix([m * g, 0]) + tension * along
    euler = inertia * d(psi, 2) + tension * r  # (-r across) x (-T along), along k
    bound = {"thread": d(s) - r * d(phi) + r * d(psi)}
    return (literature("s phi psi", (*newtons, euler), kinematic=bound, multipliers="lambda_thread"),)


def cylinder_in_cylinder() -> tuple[Route, ...]:
    phi, psi = moving("phi psi")
    m, big, r, g = constants("m R r g")
    roller = flat(m, ((big - r) * cos(phi), (big - r) * sin(phi)), m * r**2 / 2, psi, force=(m * g, 0, 0))
    return (newton_euler("phi psi", [roller], kinematic={"rolling": (big - r) * d(phi) + r * d(psi)}),)


def hoop_on_incline() -> tuple[Route, ...]:
    x, y, theta = moving("x y theta")
    m, radius, alpha, g = constants("m R alpha g")
    hoop = flat(m, (x, y), m * radius**2, -theta, force=(m * g * sin(alpha), -m * g * cos(alpha), 0))
    return (newton_euler("x y theta", [hoop], {"contact": y - radius, "rolling": x - radius * theta}),)


def rocking_half_cylinder() -> tuple[Route, ...]:
    x, theta = moving("x theta")
    m, inertia, radius, h, g = constants("m I_G R h g")
    centre = (x - h * sin(theta), radius - h * cos(theta))
    kinetic = (m * speed2(*centre) + inertia * d(theta) ** 2) / 2
    return (lagrange("x theta", kinetic, m * g * centre[1], geometric={"rolling": x - radius * theta}),)


def sliding_ladder() -> tuple[Route, ...]:
    x, y, theta = moving("x y theta")
    m, l, g = constants("m l g")
    ladder = flat(m, (x, y), m * l**2 / 3, -theta, force=(0, -m * g, 0))
    return (newton_euler("x y theta", [ladder], {"floor": y - l * sin(theta), "wall": x - l * cos(theta)}),)


def sleigh() -> tuple[Route, ...]:
    x, y, theta = moving("x y theta")
    m, inertia, a = constants("m I_G a")
    board = flat(m, (x + a * cos(theta), y + a * sin(theta)), inertia, theta)
    return (newton_euler("x y theta", [board], kinematic={"blade": -d(x) * sin(theta) + d(y) * cos(theta)}),)


def ball_in_a_pipe() -> tuple[Route, ...]:
    """Newton and Euler; and on paper, with w the spin about the outward normal: phi'' = 0, 7 z'' + 2 b w phi' + 5 g = 0."""
    phi, z, alpha, beta, gamma = moving("phi z alpha beta gamma")
    m, b, a, g = constants("m b a g")
    names = "phi z alpha beta gamma"
    turned = rotation("z", alpha) * rotation("x", beta) * rotation("z", gamma)
    ball = Rigid(m, (a * cos(phi), a * sin(phi), z), turned, [Rational(2, 5) * m * b**2] * 3, force=(0, 0, -m * g))
    omega = ball.omega
    out, along = sp.Matrix([cos(phi), sin(phi), 0]), sp.Matrix([-sin(phi), cos(phi), 0])
    slip = sp.Matrix([diff(c, t) for c in ball.at]) + omega.cross(b * out)
    bound = {"round": slip.dot(along), "upward": slip[2]}
    spin = omega.dot(out)
    book = (d(phi, 2), 7 * d(z, 2) + 2 * b * spin * d(phi) + 5 * g, b * d(spin) - d(phi) * d(z))
    return (newton_euler(names, [ball], kinematic=bound), literature(names, book, kinematic=bound))


def coin_on_incline() -> tuple[Route, ...]:
    x, y, theta, psi = moving("x y theta psi")
    m, radius, a, c, alpha, g = constants("m R A C alpha g")
    turned = rotation("z", theta) * rotation("y", psi)
    force = (m * g * sin(alpha), 0, -m * g * cos(alpha))
    coin = Rigid(m, (x, y, radius), turned, (a, c, a), force=force)
    rolling = {"rolling.1": d(x) - radius * d(psi) * cos(theta), "rolling.2": d(y) - radius * d(psi) * sin(theta)}
    book = (d(theta, 2), (c + m * radius**2) * d(psi, 2) - m * g * radius * sin(alpha) * cos(theta))
    return (
        newton_euler("x y theta psi", [coin], kinematic=rolling),
        literature("x y theta psi", book, kinematic=rolling),
    )


# -- in space --------------------------------------------------------------------------------------------------------


def central_motion() -> tuple[Route, ...]:
    """The field of U(r) = r^3 - 2/r + sin r stands for any."""
    r, phi = moving("r phi")
    (m,) = constants("m")
    kinetic = m * (d(r) ** 2 + r**2 * d(phi) ** 2) / 2
    return (lagrange("r phi", kinetic, r**3 - 2 / r + sin(r)),)


def penning_trap() -> tuple[Route, ...]:
    x, y, z = moving("x y z")
    m, sigma, q, field, w = constants("m sigma q B w")
    pull = (m * w**2 * x / 2, m * w**2 * y / 2, -m * w**2 * z)
    lorentz = (sigma * q * field * d(y), -sigma * q * field * d(x), sp.S.Zero)
    force = tuple(a + b for a, b in zip(pull, lorentz, strict=True))
    return (newton("x y z", [(m, (x, y, z), force)]), kane("x y z", [(m, (x, y, z), force)]))


def governor() -> tuple[Route, ...]:
    phi, theta, z = moving("phi theta z")
    inertia, m, sleeve, l, g, moment = constants("J m M l g L")
    kinetic = HALF * inertia * d(phi) ** 2 + m * l**2 * (d(theta) ** 2 + sin(theta) ** 2 * d(phi) ** 2)
    kinetic += sleeve * d(z) ** 2 / 2
    potential = -2 * m * g * l * cos(theta) - sleeve * g * z
    bound = {"arms": z - 2 * l * cos(theta)}
    return (lagrange("phi theta z", kinetic, potential, {phi: moment}, bound),)


def gimbals() -> tuple[Route, ...]:
    """Newton and Euler for three bodies; and the energy of Magnus, in the angles."""
    phi, theta, psi = moving("phi theta psi")
    outer, a, b, c, across, axial = constants("J a b c A C")
    frame = rotation("z", phi) * rotation("x", theta)
    zero, origin = sp.S.Zero, (0, 0, 0)
    parts = [
        Rigid(zero, origin, rotation("z", phi), (0, 0, outer)),
        Rigid(zero, origin, frame, (a, b, c)),
        Rigid(zero, origin, frame * rotation("z", psi), (across, across, axial)),
    ]
    kinetic = (outer + (across + b) * sin(theta) ** 2 + c * cos(theta) ** 2) * d(phi) ** 2
    kinetic += (across + a) * d(theta) ** 2 + axial * (d(psi) + d(phi) * cos(theta)) ** 2
    return (newton_euler("phi theta psi", parts), lagrange("phi theta psi", kinetic / 2))


def skewed_disc() -> tuple[Route, ...]:
    """In the principal axes of the disc, which are turned by beta in the shaft: no product of inertia occurs."""
    alpha, gamma, phi = moving("alpha gamma phi")
    m, R, beta, motor = constants("m R beta M_0")
    turned = rotation("x", alpha) * rotation("y", gamma) * rotation("z", phi) * rotation("y", beta)
    disc = Rigid(m, (0, 0, 0), turned, (m * R**2 / 4, m * R**2 / 4, m * R**2 / 2), moment=(0, 0, motor))
    return (newton_euler("alpha gamma phi", [disc], {"bearings_i": alpha, "bearings_j": gamma}),)


def gyrocompass() -> tuple[Route, ...]:
    """Euler's law for the rotor, its axes carried around by the earth."""
    theta, psi = moving("theta psi")
    a, c, turn, lat = constants("A C Omega lat")
    east = sp.Matrix([-sin(turn * t), cos(turn * t), 0])
    up = sp.Matrix([cos(lat) * cos(turn * t), cos(lat) * sin(turn * t), sin(lat)])
    north = up.cross(east)
    axis = cos(theta) * north - sin(theta) * east
    frame = sp.Matrix.hstack(up.cross(axis), up, axis)
    rotor = Rigid(sp.S.Zero, (0, 0, 0), frame * rotation("z", psi), (a, a, c))
    return (newton_euler("theta psi", [rotor]),)


def double_pendulum() -> tuple[Route, ...]:
    """The Lagrangian that books print."""
    a, b = moving("theta1 theta2")
    m, l, g = constants("m l g")
    kinetic = m * l**2 * (d(a) ** 2 + d(b) ** 2 / 2 + d(a) * d(b) * cos(a - b))
    return (lagrange("theta1 theta2", kinetic, -m * g * l * (2 * cos(a) + cos(b))),)


def coupled_pendulums() -> tuple[Route, ...]:
    a, b = moving("theta1 theta2")
    m, l, g, c, apart = constants("m l g c a")
    length = sqrt((apart + l * sin(b) - l * sin(a)) ** 2 + l**2 * (cos(b) - cos(a)) ** 2)
    potential = c * (length - apart) ** 2 / 2 - m * g * l * (cos(a) + cos(b))
    return (lagrange("theta1 theta2", m * l**2 * (d(a) ** 2 + d(b) ** 2) / 2, potential),)


def bead_on_rotating_hoop() -> tuple[Route, ...]:
    x, y, z = moving("x y z")
    m, radius, turn, g = constants("m R Omega g")
    hoop = {"sphere": x**2 + y**2 + z**2 - radius**2, "plane": x * sin(turn * t) - y * cos(turn * t)}
    return (newton("x y z", [(m, (x, y, z), (0, 0, -m * g))], hoop),)


def bead_in_a_turning_tube() -> tuple[Route, ...]:
    r = moving("r")[0]
    m, k, a, turn = constants("m k a Omega")
    along = (cos(turn * t), sin(turn * t))
    at, pull = tuple(r * e for e in along), tuple(-k * (r - a) * e for e in along)
    return (newton("r", [(m, at, pull)]),)


def spherical_pendulum_by_routh() -> tuple[Route, ...]:
    theta, phi = moving("theta phi")
    m, l, g = constants("m l g")
    at = (l * sin(theta) * cos(phi), l * sin(theta) * sin(phi), -l * cos(theta))
    return (newton("theta phi", [(m, at, (0, 0, -m * g))]),)


def marble_in_a_cone() -> tuple[Route, ...]:
    r, phi = moving("r phi")
    m, alpha, g = constants("m alpha g")
    at = (r * sin(alpha) * cos(phi), r * sin(alpha) * sin(phi), r * cos(alpha))
    return (newton("r phi", [(m, at, (0, 0, -m * g))]),)


def triatomic_molecule() -> tuple[Route, ...]:
    x1, x2, x3 = moving("x1 x2 x3")
    m, big, c, b = constants("m M c b")
    kinetic = (m * d(x1) ** 2 + big * d(x2) ** 2 + m * d(x3) ** 2) / 2
    return (lagrange("x1 x2 x3", kinetic, c * ((x2 - x1 - b) ** 2 + (x3 - x2 - b) ** 2) / 2),)


def euler_rigid_body() -> tuple[Route, ...]:
    phi, theta, psi = moving("phi theta psi")
    turned = rotation("z", phi) * rotation("x", theta) * rotation("z", psi)
    body = Rigid(sp.S.Zero, (0, 0, 0), turned, constants("A B C"))
    return (newton_euler("phi theta psi", [body]),)


def two_wheeled_carriage() -> tuple[Route, ...]:
    names = "x y theta phi_1 phi_2"
    x, y, theta, left, right = moving(names)
    big, m, inertia, about, across, a, b, radius, one, two = constants("M m I K J a b R tau_1 tau_2")
    s, n = sp.Matrix([cos(theta), sin(theta), 0]), sp.Matrix([-sin(theta), cos(theta), 0])
    axle = sp.Matrix([x, y, 0])
    frame = flat(big, tuple(axle + a * s)[:2], inertia, theta, moment=tuple(-(one + two) * n))
    wheels = [
        Rigid(m, tuple(axle + side * b * n), rotation("z", theta) * rotation("y", turned), (across, about, across),
              moment=tuple(torque * n))
        for side, turned, torque in ((1, left, one), (-1, right, two))
    ]  # fmt: skip
    ahead = d(x) * cos(theta) + d(y) * sin(theta)
    rolling = {
        "sideways": d(y) * cos(theta) - d(x) * sin(theta),
        "left_wheel": ahead - b * d(theta) - radius * d(left),
        "right_wheel": ahead + b * d(theta) - radius * d(right),
    }
    return (newton_euler(names, [frame, *wheels], kinematic=rolling),)


def aircraft() -> tuple[Route, ...]:
    names = "x y z psi theta phi"
    x, y, z, psi, theta, phi = moving(names)
    m, a, b, c, g, push = constants("m A B C g F")
    turned = rotation("z", psi) * rotation("y", theta) * rotation("x", phi)
    force = push * turned[:, 0] + sp.Matrix([0, 0, m * g])
    return (newton_euler(names, [Rigid(m, (x, y, z), turned, (a, b, c), force=tuple(force))]),)


def of_bodies(name: str) -> Callable[[], tuple[Route, ...]]:
    """The routes that `body_systems` has for the same problem."""
    return bodies.BODIES[name].routes


ROLLING = ("rolling.1", "rolling.2")

SHIPPED: dict[str, Textbook] = {
    "aircraft": Textbook(aircraft, HOLONOMIC, 6, 0),
    "bead-in-a-turning-tube": Textbook(bead_in_a_turning_tube, "holonomic rheonomic catastatic", 1, 0),
    "spherical-pendulum-by-routh": Textbook(spherical_pendulum_by_routh, HOLONOMIC, 2, 0),
    "conical-pendulum": Textbook(spherical_pendulum_by_routh, HOLONOMIC, 2, 0),
    "marble-in-a-cone": Textbook(marble_in_a_cone, HOLONOMIC, 2, 0),
    "bead-on-rotating-hoop": Textbook(bead_on_rotating_hoop, RHEONOMIC, 1, 2),
    "coupled-pendulums": Textbook(coupled_pendulums, HOLONOMIC, 2, 0),
    "double-pendulum-small-oscillations": Textbook(double_pendulum, HOLONOMIC, 2, 0),
    "euler-rigid-body": Textbook(euler_rigid_body, HOLONOMIC, 3, 0),
    "triatomic-molecule": Textbook(triatomic_molecule, HOLONOMIC, 3, 0),
    "two-wheeled-carriage": Textbook(
        two_wheeled_carriage, NONHOLONOMIC, 2, 1, ("sideways", "left_wheel", "right_wheel")
    ),
    "ball-in-a-pipe": Textbook(ball_in_a_pipe, NONHOLONOMIC, 3, 0, ("round", "upward")),
    "ball-on-turntable": Textbook(
        of_bodies("ball_on_turntable"), "nonholonomic scleronomic acatastatic", 3, 0, ROLLING
    ),
    "bell-and-clapper": Textbook(bell_and_clapper, HOLONOMIC, 2, 0),
    "central-motion": Textbook(central_motion, HOLONOMIC, 2, 0, functions={"U": ("r", "r**3 - 2/r + sin(r)")}),
    "coin-on-incline": Textbook(coin_on_incline, NONHOLONOMIC, 2, 0, ROLLING),
    "coupled-oscillators": Textbook(coupled_oscillators, HOLONOMIC, 2, 0),
    "cylinder-in-cylinder": Textbook(cylinder_in_cylinder, HOLONOMIC, 1, 1),
    "cylinder-on-wedge": Textbook(cylinder_on_wedge, HOLONOMIC, 2, 2),
    "double-atwood": Textbook(double_atwood, HOLONOMIC, 2, 4),
    "foucault-pendulum": Textbook(foucault_pendulum, "holonomic rheonomic catastatic", 2, 0),
    "gimbals": Textbook(gimbals, HOLONOMIC, 3, 0),
    "governor": Textbook(governor, HOLONOMIC, 2, 1),
    "gyrocompass": Textbook(gyrocompass, "holonomic rheonomic catastatic", 2, 0),
    "skewed-disc": Textbook(skewed_disc, HOLONOMIC, 1, 2),
    "heavy-top": Textbook(of_bodies("heavy_top"), HOLONOMIC, 3, 0),
    "precessing-top": Textbook(of_bodies("heavy_top"), HOLONOMIC, 3, 0),
    "hoop-on-incline": Textbook(hoop_on_incline, HOLONOMIC, 1, 2),
    "kapitza-pendulum": Textbook(kapitza_pendulum, RHEONOMIC, 1, 1, ranges={"l": (3, 4)}),
    "ball-on-a-string": Textbook(ball_on_a_string, HOLONOMIC, 1, 1),
    "bowling-ball": Textbook(bowling_ball, HOLONOMIC, 2, 1),
    "cylinder-on-rough-incline": Textbook(cylinder_on_rough_incline, HOLONOMIC, 1, 2),
    "disc-in-a-corner": Textbook(disc_in_a_corner, HOLONOMIC, 1, 2),
    "rough-ladder": Textbook(rough_ladder, HOLONOMIC, 1, 2),
    "mass-on-belt": Textbook(mass_on_belt, HOLONOMIC, 1, 1),
    "particle-in-bowl": Textbook(particle_in_bowl, HOLONOMIC, 2, 1, ranges={"l": (2, 3)}),
    "penning-trap": Textbook(penning_trap, HOLONOMIC, 3, 0, ranges={"sigma": (-1, 1)}),
    "pole-on-cart": Textbook(pole_on_cart, HOLONOMIC, 2, 0),
    "rocking-half-cylinder": Textbook(rocking_half_cylinder, HOLONOMIC, 1, 1),
    "rolling-disc": Textbook(of_bodies("rolling_disc"), NONHOLONOMIC, 3, 0, ROLLING),
    "disc-that-rolls-steadily": Textbook(lambda: bodies.rolling_disc(uniform=True), NONHOLONOMIC, 3, 0, ROLLING),
    "rough-wedge": Textbook(rough_wedge, HOLONOMIC, 2, 2),
    "shortening-pendulum": Textbook(shortening_pendulum, RHEONOMIC, 1, 1),
    "sleigh": Textbook(sleigh, NONHOLONOMIC, 2, 0, ("blade",)),
    "sliding-ladder": Textbook(sliding_ladder, HOLONOMIC, 1, 2),
    "spring-pendulum": Textbook(spring_pendulum, HOLONOMIC, 2, 0),
    "swinging-atwood": Textbook(swinging_atwood, HOLONOMIC, 2, 1),
    "swinging-yo-yo": Textbook(swinging_yo_yo, HOLONOMIC, 2, 1),
    "three-link-chain": Textbook(three_link_chain, HOLONOMIC, 3, 3),
    "turning-parabola": Textbook(turning_parabola, RHEONOMIC, 1, 2),
    "wheel-suspension": Textbook(wheel_suspension, HOLONOMIC, 2, 0),
}
