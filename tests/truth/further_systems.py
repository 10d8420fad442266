"""More shipped problems of motion (`problems/motion/*.yaml`), each with its equations by a second route.

As in `shipped_systems`. Where the literature has the equations in a form of its own (Borisov, Kilin and Mamaev on
Suslov's problem, Hill's equations, Huygens' law of the cycloid), that form is a route beside Newton's and Euler's laws.
"""

from __future__ import annotations

import sympy as sp
from sympy import Rational, cos, diff, exp, sin, sqrt

from tests.support.second_route import (
    Rigid,
    Route,
    constants,
    lagrange,
    literature,
    moving,
    newton,
    newton_euler,
    rotation,
    t,
)
from tests.truth.body_systems import flat
from tests.truth.textbook_systems import HOLONOMIC, NONHOLONOMIC, Textbook, d, speed2

HALF = Rational(1, 2)


# -- particles -------------------------------------------------------------------------------------------------------


def two_body_problem() -> tuple[Route, ...]:
    x1, y1, x2, y2 = moving("x1 y1 x2 y2")
    m1, m2, gravitation = constants("m1 m2 G")
    way = sp.Matrix([x2 - x1, y2 - y1])
    pull = gravitation * m1 * m2 * way / way.dot(way) ** Rational(3, 2)
    return (newton("x1 y1 x2 y2", [(m1, (x1, y1), tuple(pull)), (m2, (x2, y2), tuple(-pull))]),)


def toda_lattice() -> tuple[Route, ...]:
    x1, x2, x3 = moving("x1 x2 x3")
    m, a, b = constants("m a b")
    potential = a / b * (exp(b * (x1 - x2)) + exp(b * (x2 - x3)))
    return (lagrange("x1 x2 x3", m * speed2(x1, x2, x3) / 2, potential),)


def ballistic_curve() -> tuple[Route, ...]:
    """The resistance v^2 + 3 v + sin v stands for any."""
    x, y = moving("x y")
    m, g = constants("m g")
    speed = sqrt(d(x) ** 2 + d(y) ** 2)
    share = (speed**2 + 3 * speed + sin(speed)) / speed
    return (newton("x y", [(m, (x, y), (-share * d(x), -share * d(y) - m * g))]),)


def charge_and_monopole() -> tuple[Route, ...]:
    r, theta, phi = moving("r theta phi")
    m, kappa = constants("m kappa")
    out = sp.Matrix([sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta)])
    force = kappa / r**2 * d(r * out).cross(out)
    return (newton("r theta phi", [(m, tuple(r * out), tuple(force))]),)


def bead_on_lemniscate() -> tuple[Route, ...]:
    x, y = moving("x y")
    m, a, g = constants("m a g")
    wire = (x**2 + y**2) ** 2 - a**2 * (x**2 - y**2)
    return (newton("x y", [(m, (x, y), (0, -m * g))], {"wire": wire}),)


def bead_on_any_wire() -> tuple[Route, ...]:
    """The wire sin x + x^2 stands for any."""
    x, y = moving("x y")
    m, g = constants("m g")
    return (newton("x y", [(m, (x, y), (0, -m * g))], {"wire": y - sin(x) - x**2}),)


def cycloidal_pendulum() -> tuple[Route, ...]:
    """Lagrange's equations with the arc as a constraint; and Huygens: along the arc the motion is harmonic."""
    phi, s = moving("phi s")
    m, a, g = constants("m a g")
    arc = {"arc": s - 4 * a * sin(phi / 2)}
    centre = (a * (phi + sin(phi)), -a * (1 + cos(phi)))
    return (
        lagrange("phi s", m * speed2(*centre) / 2, m * g * centre[1], geometric=arc),
        literature("phi s", [d(s, 2) + g / (4 * a) * s], arc),
    )


def clockwork_skate() -> tuple[Route, ...]:
    x, y = moving("x y")
    m, turn, alpha, g = constants("m Omega alpha g")
    blade = {"blade": d(y) * cos(turn * t) - d(x) * sin(turn * t)}
    return (newton("x y", [(m, (x, y), (m * g * sin(alpha), 0))], kinematic=blade),)


def slide_off_a_dome() -> tuple[Route, ...]:
    """On the block its weight, N outward, and mu N up the slope."""
    r, theta = moving("r theta")
    m, radius, mu, g = constants("m R mu g")
    normal = sp.Symbol("lambda_dome")
    outward = m * (d(r, 2) - r * d(theta) ** 2) + m * g * cos(theta) - normal
    down = m * (r * d(theta, 2) + 2 * d(r) * d(theta)) - m * g * sin(theta) + mu * normal
    return (literature("r theta", (outward, down), {"dome": r - radius}, multipliers="lambda_dome"),)


def ziegler_column() -> tuple[Route, ...]:
    """Lagrange's equations, the follower's generalized forces from the velocity of the top."""
    theta, psi = moving("theta psi")
    m, l, c, load = constants("m l c P")
    lower, upper = (sp.Matrix([cos(a), sin(a)]) for a in (theta, theta + psi))
    joint, top = l * lower, l * lower + l * upper
    kinetic = m * speed2(*joint) + m * speed2(*top) / 2
    forces = {q: (-load * upper).dot(top.diff(q)) for q in (theta, psi)}
    return (lagrange("theta psi", kinetic, c * (theta**2 + psi**2) / 2, forces),)


def hill_moon() -> tuple[Route, ...]:
    """Newton's law seen from the earth, which falls; and Hill's equations, x = r cos phi and y = r sin phi."""
    r, phi = moving("r phi")
    m, attraction, n = constants("m K n")
    x, y = r * cos(phi), r * sin(phi)
    sun, ahead = sp.Matrix([cos(n * t), sin(n * t)]), sp.Matrix([-sin(n * t), cos(n * t)])
    tide = n**2 * (2 * x * sun - y * ahead)
    force = m * (tide - attraction / r**3 * (x * sun + y * ahead))
    first = d(x, 2) - 2 * n * d(y) - 3 * n**2 * x + attraction * x / r**3
    second = d(y, 2) + 2 * n * d(x) + attraction * y / r**3
    return (
        newton("r phi", [(m, tuple(x * sun + y * ahead), tuple(force))]),
        literature("r phi", (first, second)),
    )


# -- bodies in the plane ---------------------------------------------------------------------------------------------


def door_closer() -> tuple[Route, ...]:
    (theta,) = moving("theta")
    inertia, a, h, c, l, b = constants("J a h c l b")
    end = sp.Matrix([a * cos(theta) - h, a * sin(theta)])
    length = sqrt(end.dot(end))
    pull = c * (length - l) + b * end.dot(d(end)) / length
    moment = -pull / length * end.dot(end.diff(theta))
    return (literature("theta", [inertia * d(theta, 2) - moment]),)


def planetary_gear() -> tuple[Route, ...]:
    alpha, phi, psi = moving("alpha phi psi")
    r, s, sun, m, planet, arm, drive, load = constants("r s J_0 m J_1 J_2 M_0 L")
    centre = ((r + s) * cos(phi), (r + s) * sin(phi))
    zero, origin = sp.S.Zero, (sp.S.Zero, sp.S.Zero)
    bodies = [
        flat(zero, origin, sun, alpha, moment=(0, 0, drive)),
        flat(m, centre, planet, psi),
        flat(zero, origin, arm, phi, moment=(0, 0, -load)),
    ]
    rolling = {
        "on_the_sun": (r + s) * d(phi) - s * d(psi) - r * d(alpha),
        "in_the_ring": (r + s) * d(phi) + s * d(psi),
    }
    return (newton_euler("alpha phi psi", bodies, kinematic=rolling),)


def four_bar_linkage() -> tuple[Route, ...]:
    alpha, beta, gamma = moving("alpha beta gamma")
    a, b, c, apart, crank, m, coupler, rocker, drive = constants("a b c d J_1 m J_2 J_3 M_0")
    zero, origin = sp.S.Zero, (sp.S.Zero, sp.S.Zero)
    middle = (a * cos(alpha) + b / 2 * cos(beta), a * sin(alpha) + b / 2 * sin(beta))
    bodies = [
        flat(zero, origin, crank, alpha, moment=(0, 0, drive)),
        flat(m, middle, coupler, beta),
        flat(zero, (apart, sp.S.Zero), rocker, gamma),
    ]
    closure = {
        "closure.1": a * cos(alpha) + b * cos(beta) - apart - c * cos(gamma),
        "closure.2": a * sin(alpha) + b * sin(beta) - c * sin(gamma),
    }
    return (newton_euler("alpha beta gamma", bodies, closure),)


def trolley_on_three_wheels() -> tuple[Route, ...]:
    x, y, phi = moving("x y phi")
    m, inertia, a, h, pull, g = constants("m J a h F g")
    trolley = flat(m, (x - h * sin(phi), y + h * cos(phi)), inertia, phi, force=(pull, -m * g, 0))
    return (newton_euler("x y phi", [trolley], {"middle": y, "front": y + a * sin(phi)}),)


def skate_on_springs() -> tuple[Route, ...]:
    x, y, theta = moving("x y theta")
    m, inertia, c, kappa = constants("m J c kappa")
    skate = flat(m, (x, y), inertia, theta, force=(-c * x, -c * y, 0), moment=(0, 0, -kappa * theta))
    return (newton_euler("x y theta", [skate], kinematic={"blade": d(y) * cos(theta) - d(x) * sin(theta)}),)


def snakeboard() -> tuple[Route, ...]:
    """Newton and Euler for four bodies; and on paper, v along the board, l theta' cos phi = v sin phi."""
    x, y, theta, psi, phi = moving("x y theta psi phi")
    m, board, rotor, axle, l, swing, turn = constants("m J J_r J_w l M_r M_w")
    zero, ahead = sp.S.Zero, sp.Matrix([cos(theta), sin(theta)])
    at = sp.Matrix([x, y])
    bodies = [
        flat(m, (x, y), board, theta, moment=(0, 0, -swing)),
        flat(zero, (x, y), rotor, theta + psi, moment=(0, 0, swing)),
        flat(zero, tuple(at + l * ahead), axle, theta + phi, moment=(0, 0, turn)),
        flat(zero, tuple(at - l * ahead), axle, theta - phi, moment=(0, 0, -turn)),
    ]

    def across(side: int) -> sp.Expr:
        velocity, angle = d(at + side * l * ahead), theta + side * phi
        return -velocity[0] * sin(angle) + velocity[1] * cos(angle)

    wheels = {"front_wheels": across(1), "rear_wheels": across(-1)}
    speed, whole = d(x) * cos(theta) + d(y) * sin(theta), board + rotor + 2 * axle
    book = (
        m * l * d(speed) * cos(phi) + (whole * d(theta, 2) + rotor * d(psi, 2)) * sin(phi),
        rotor * (d(theta, 2) + d(psi, 2)) - swing,
        axle * d(phi, 2) - turn,
    )
    names = "x y theta psi phi"
    return (newton_euler(names, bodies, kinematic=wheels), literature(names, book, kinematic=wheels))


# -- bodies in space -------------------------------------------------------------------------------------------------


def furuta_pendulum() -> tuple[Route, ...]:
    phi, theta = moving("phi theta")
    inertia, m, across, big, l, b1, b2, tau, g = constants("J m I_G L l b_1 b_2 tau g")
    out, side = sp.Matrix([cos(phi), sin(phi), 0]), sp.Matrix([-sin(phi), cos(phi), 0])
    along = sin(theta) * side - cos(theta) * sp.Matrix([0, 0, 1])
    frame = sp.Matrix.hstack(out, along.cross(out), along)
    hinge = -b2 * d(theta) * out
    motor = sp.Matrix([0, 0, tau - b1 * d(phi)])
    arm = Rigid(sp.S.Zero, (0, 0, 0), rotation("z", phi), (0, 0, inertia), moment=tuple(motor - hinge))
    rod = Rigid(m, big * out + l * along, frame, (across, across, 0), (0, 0, -m * g), tuple(hinge))
    return (newton_euler("phi theta", [arm, rod]),)


def suslov_body() -> tuple[Route, ...]:
    """Newton and Euler; and Borisov, Kilin and Mamaev in axes with n as the third: I11 u' = -I13 u q, I22 q' = I13 u^2."""
    phi, theta, psi = moving("phi theta psi")
    a, c, tilt = constants("A C delta_0")
    turned = rotation("z", phi) * rotation("x", theta) * rotation("z", psi)
    top = Rigid(sp.S.Zero, (0, 0, 0), turned, (a, a, c))
    p, q, r = (top.omega.dot(turned[:, k]) for k in range(3))
    bound = {"no_spin": p * sin(tilt) + r * cos(tilt)}
    u = p * cos(tilt) - r * sin(tilt)
    first, mixed = a * cos(tilt) ** 2 + c * sin(tilt) ** 2, (a - c) * sin(tilt) * cos(tilt)
    book = (first * d(u) + mixed * u * q, a * d(q) - mixed * u**2)
    names = "phi theta psi"
    return (newton_euler(names, [top], kinematic=bound), literature(names, book, kinematic=bound))


def ball_on_a_ball() -> tuple[Route, ...]:
    """Newton and Euler; and Routh: with n the spin about the line of centres, n' = 0 and two equations of the centre."""
    names = "theta phi alpha beta gamma"
    theta, phi, alpha, beta, gamma = moving(names)
    m, b, a, g = constants("m b a g")
    omega = sp.Matrix([d(alpha), d(beta), d(gamma)])
    out = sp.Matrix([sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta)])
    down = out.diff(theta)
    around = sp.Matrix([-sin(phi), cos(phi), 0])
    inertia = Rational(2, 5) * m * b**2
    ball = Rigid(m, tuple(a * out), sp.eye(3), [inertia] * 3, force=(0, 0, -m * g), spin=tuple(omega))
    slip = d(a * out) - omega.cross(b * out)
    bound = {"downward": slip.dot(down), "sideways": slip.dot(around)}
    spin = omega.dot(out)
    book = (
        7 * a * (d(theta, 2) - d(phi) ** 2 * sin(theta) * cos(theta)) + 2 * b * spin * d(phi) * sin(theta) - 5 * g * sin(theta),
        7 * a * (d(phi, 2) * sin(theta) + 2 * d(theta) * d(phi) * cos(theta)) - 2 * b * spin * d(theta),
        d(spin),
    )  # fmt: skip
    return (newton_euler(names, [ball], kinematic=bound), literature(names, book, kinematic=bound))


def coin_on_shaken_table() -> tuple[Route, ...]:
    names = "x y theta psi"
    x, y, theta, psi, u = moving(f"{names} u")
    m, radius, a, c = constants("m R A C")
    coin = Rigid(m, (x, y, radius), rotation("z", theta) * rotation("y", psi), (a, c, a))
    rolling = {
        "rolling.1": d(x) - radius * d(psi) * cos(theta) - d(u),
        "rolling.2": d(y) - radius * d(psi) * sin(theta),
    }
    book = (d(theta, 2), (c + m * radius**2) * d(psi, 2) + m * radius * d(u, 2) * cos(theta))
    return (newton_euler(names, [coin], kinematic=rolling), literature(names, book, kinematic=rolling))


# -- masses that vary --------------------------------------------------------------------------------------------------


def balance(mass: sp.Expr, velocity: sp.Expr, exchanged: sp.Expr, force: sp.Expr) -> sp.Expr:
    """d(m v)/dt - (dm/dt) u - F: momentum changes by what the exchanged mass brings and by the force."""
    return diff(mass * velocity, t) - diff(mass, t) * exchanged - force


def rocket() -> tuple[Route, ...]:
    [y] = moving("y")
    m_0, q, u, g = constants("m_0 q u g")
    m = m_0 - q * t
    return (literature("y", (balance(m, d(y), d(y) - u, -m * g),)),)


def chain_off_a_table() -> tuple[Route, ...]:
    """The energy of the whole chain, whose mass does not vary."""
    [x] = moving("x")
    density, l, g = constants("rho l g")
    return (lagrange("x", HALF * density * l * d(x) ** 2, -HALF * density * g * x**2),)


def raindrop() -> tuple[Route, ...]:
    [x] = moving("x")
    k, g = constants("k g")
    return (literature("x", (balance(k * x**3, d(x), 0, k * x**3 * g),)),)


def load_that_lifts_a_chain() -> tuple[Route, ...]:
    """The string pulls both up with the same tension: its multiplier is the force down on each."""
    x, y = moving("x y")
    big, density, h, g = constants("M rho h g")
    pull = sp.Symbol("lambda_string")
    m = density * (h - y)
    laws = (balance(big, d(x), 0, big * g + pull), balance(m, d(y), 0, m * g + pull))
    return (literature("x y", laws, {"string": x + y - h}, multipliers="lambda_string"),)


ROLLING = ("rolling.1", "rolling.2")

FURTHER: dict[str, Textbook] = {
    "ball-on-a-ball": Textbook(ball_on_a_ball, NONHOLONOMIC, 3, 0, ("downward", "sideways")),
    "ballistic-curve": Textbook(ballistic_curve, HOLONOMIC, 2, 0, functions={"D": ("v", "v**2 + 3*v + sin(v)")}),
    "bead-on-any-wire": Textbook(bead_on_any_wire, HOLONOMIC, 1, 1, functions={"f": ("x", "sin(x) + x**2")}),
    "bead-on-lemniscate": Textbook(bead_on_lemniscate, HOLONOMIC, 1, 1, ranges={"a": (2, 3)}),
    "chain-off-a-table": Textbook(chain_off_a_table, HOLONOMIC, 1, 0),
    "charge-and-monopole": Textbook(charge_and_monopole, HOLONOMIC, 3, 0),
    "clockwork-skate": Textbook(clockwork_skate, "nonholonomic rheonomic catastatic", 1, 0, ("blade",)),
    "coin-on-shaken-table": Textbook(coin_on_shaken_table, "nonholonomic rheonomic acatastatic", 2, 0, ROLLING),
    "cycloidal-pendulum": Textbook(cycloidal_pendulum, HOLONOMIC, 1, 1),
    "door-closer": Textbook(door_closer, HOLONOMIC, 1, 0),
    "four-bar-linkage": Textbook(
        four_bar_linkage, HOLONOMIC, 1, 2, ranges={"a": (0.3, 0.5), "b": (2, 2.5), "c": (2, 2.5), "d": (1, 1.5)}
    ),
    "furuta-pendulum": Textbook(furuta_pendulum, HOLONOMIC, 2, 0),
    "hill-moon": Textbook(hill_moon, "holonomic rheonomic catastatic", 2, 0),
    "load-that-lifts-a-chain": Textbook(load_that_lifts_a_chain, HOLONOMIC, 1, 1),
    "planetary-gear": Textbook(planetary_gear, HOLONOMIC, 1, 2),
    "raindrop": Textbook(raindrop, HOLONOMIC, 1, 0),
    "rocket": Textbook(rocket, HOLONOMIC, 1, 0),
    "skate-on-springs": Textbook(skate_on_springs, NONHOLONOMIC, 2, 0, ("blade",)),
    "slide-off-a-dome": Textbook(slide_off_a_dome, HOLONOMIC, 1, 1),
    "snakeboard": Textbook(snakeboard, NONHOLONOMIC, 3, 0, ("front_wheels", "rear_wheels")),
    "suslov-body": Textbook(suslov_body, NONHOLONOMIC, 2, 0, ("no_spin",)),
    "toda-lattice": Textbook(toda_lattice, HOLONOMIC, 3, 0),
    "trolley-on-three-wheels": Textbook(trolley_on_three_wheels, HOLONOMIC, 1, 2, redundant=("rear",)),
    "two-body-problem": Textbook(two_body_problem, HOLONOMIC, 4, 0),
    "ziegler-column": Textbook(ziegler_column, HOLONOMIC, 2, 0),
}
