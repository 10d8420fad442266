"""Problems of rigid bodies, springs and dampers (`systems/*.yaml`), each with its equations of motion by a second route.

As in `textbook_systems`: the routes are typed from the drawing or copied from the literature. For bodies the first route is
Newton's and Euler's law in fixed components, with rotation matrices by Rodrigues' formula (`newton_euler`), or kinetic
energies written by hand.
"""

from __future__ import annotations

import sympy as sp
from sympy import cos, sin, sqrt

from tests.support.second_route import (
    Rigid,
    Route,
    constants,
    kane_of_bodies,
    lagrange,
    literature,
    moving,
    newton_euler,
    rotation,
    t,
)
from tests.truth.textbook_systems import HOLONOMIC, NONHOLONOMIC, Textbook, d, speed2

# -- in the plane ----------------------------------------------------------------------------------------------------


def flat(
    mass: sp.Expr, at: tuple[sp.Expr, ...], inertia: sp.Expr, angle: sp.Expr, **acting: tuple[sp.Expr, ...]
) -> Rigid:
    """A body that turns about z."""
    return Rigid(mass, (*at, 0), rotation("z", angle), (0, 0, inertia), **acting)


def compound_pendulum() -> tuple[Route, ...]:
    (theta,) = moving("theta")
    m, g, a, inertia = constants("m g a I_G")
    return (literature("theta", [(inertia + m * a**2) * d(theta, 2) + m * g * a * sin(theta)]),)


def rolling_cylinder() -> tuple[Route, ...]:
    x, y, theta = moving("x y theta")
    m, g, radius, inertia, alpha = constants("m g R I_G alpha")
    kinetic = (m * speed2(x, y) + inertia * d(theta) ** 2) / 2
    potential = -m * g * x * sin(alpha) + m * g * y * cos(alpha)
    bound = {"contact": y - radius, "rolling": x - radius * theta}
    return (lagrange("x y theta", kinetic, potential, geometric=bound),)


def rolling_cylinder_by_velocities() -> tuple[Route, ...]:
    x, y, theta = moving("x y theta")
    m, g, radius, inertia, alpha = constants("m g R I_G alpha")
    kinetic = (m * speed2(x, y) + inertia * d(theta) ** 2) / 2
    potential = -m * g * x * sin(alpha) + m * g * y * cos(alpha)
    bound = {"across": d(y), "rolling": d(x) - radius * d(theta)}
    return (lagrange("x y theta", kinetic, potential, kinematic=bound),)


def cylinder_in_cylinder() -> tuple[Route, ...]:
    """(3/2) (R - r) phi'' + g sin phi = 0 (Hauger, Schnell and Gross; any book of problems)."""
    phi, psi = moving("phi psi")
    g, big, small = constants("g R r")
    book = [sp.Rational(3, 2) * (big - small) * d(phi, 2) + g * sin(phi)]
    return (literature("phi psi", book, kinematic={"rolling": (big - small) * d(phi) + small * d(psi)}),)


def yo_yo() -> tuple[Route, ...]:
    y, theta = moving("y theta")
    m, g, r, inertia = constants("m g r I_G")
    tension = sp.Symbol("lambda_string")
    equations = (m * d(y, 2) - m * g - tension, inertia * d(theta, 2) + tension * r)
    return (literature("y theta", equations, {"string": y - r * theta}, multipliers="lambda_string"),)


def sliding_ladder() -> tuple[Route, ...]:
    x, y, theta = moving("x y theta")
    m, g, l = constants("m g l")
    bound = {"foot": y - l * sin(theta), "head": x + l * cos(theta)}
    ladder = flat(m, (x, y), m * l**2 / 3, theta, force=(0, -m * g, 0))
    return (newton_euler("x y theta", [ladder], bound),)


def double_physical_pendulum() -> tuple[Route, ...]:
    alpha, beta = moving("alpha beta")
    m1, m2, i1, i2, a, b, l, g = constants("m1 m2 I1 I2 a b l g")
    kinetic = ((m1 * a**2 + i1 + m2 * l**2) * d(alpha) ** 2 + (m2 * b**2 + i2) * d(beta) ** 2) / 2
    kinetic += m2 * l * b * d(alpha) * d(beta) * cos(alpha - beta)
    potential = -(m1 * a + m2 * l) * g * cos(alpha) - m2 * g * b * cos(beta)
    return (lagrange("alpha beta", kinetic, potential),)


def heavy_atwood() -> tuple[Route, ...]:
    """(m1 + m2 + I/R^2) y2'' = (m2 - m1) g."""
    y1, y2, theta = moving("y1 y2 theta")
    m1, m2, inertia, radius, g, length = constants("m1 m2 I_0 R g L")
    book = [(m1 + m2 + inertia / radius**2) * d(y2, 2) - (m2 - m1) * g]
    return (literature("y1 y2 theta", book, {"string": y1 + y2 - length, "no_slip": y2 - radius * theta}),)


def heavy_slider_crank() -> tuple[Route, ...]:
    theta, x, y, phi, s = moving("theta x y phi s")
    m1, m2, m3, a, b, g, moment, c = constants("m1 m2 m3 a b g M_0 c")
    pin, bolt = (2 * a * cos(theta), 2 * a * sin(theta)), (x + b * cos(phi), y + b * sin(phi))
    bound = {
        "pin1": pin[0] - x + b * cos(phi), "pin2": pin[1] - y + b * sin(phi), "bolt1": bolt[0] - s, "bolt2": bolt[1]
    }  # fmt: skip
    kinetic = 2 * m1 * a**2 * d(theta) ** 2 / 3 + m2 * (speed2(x, y) + b**2 * d(phi) ** 2 / 3) / 2 + m3 * d(s) ** 2 / 2
    potential = m1 * g * a * sin(theta) + m2 * g * y
    return (lagrange("theta x y phi s", kinetic, potential, {theta: moment, s: -c * d(s)}, bound),)


def pushed_plate() -> tuple[Route, ...]:
    x, y, theta = moving("x y theta")
    m, inertia, force, a, b, c, moment = constants("m I_G F a b c M_0")
    book = (
        m * d(x, 2) - force * (cos(theta) - 2 * sin(theta)) - force * x + c * d(x),
        m * d(y, 2) - force * (sin(theta) + 2 * cos(theta)) + c * d(y),
        inertia * d(theta, 2) + force * (b - 2 * a) - force * x * y - moment + c * d(theta),
    )
    return (literature("x y theta", book),)


def heavy_sleigh() -> tuple[Route, ...]:
    """Neimark and Fufaev: m (u' - a w^2) = 0, (I + m a^2) w' + m a u w = 0."""
    x, y, theta = moving("x y theta")
    m, inertia, a = constants("m I_G a")
    u = d(x) * cos(theta) + d(y) * sin(theta)
    book = (d(u) - a * d(theta) ** 2, (inertia + m * a**2) * d(theta, 2) + m * a * u * d(theta))
    centre = (x + a * cos(theta), y + a * sin(theta))
    blade = {"blade": -d(x) * sin(theta) + d(y) * cos(theta)}
    return (
        literature("x y theta", book, kinematic=blade),
        newton_euler("x y theta", [flat(m, centre, inertia, theta)], kinematic=blade),
    )


# -- in space --------------------------------------------------------------------------------------------------------


def euler_angles() -> tuple[tuple[sp.Expr, ...], sp.Matrix]:
    phi, theta, psi = moving("phi theta psi")
    return (phi, theta, psi), rotation("z", phi) * rotation("x", theta) * rotation("z", psi)


def heavy_top() -> tuple[Route, ...]:
    """Whittaker, section 71: the momenta of phi and psi are constant; Kane's method; Newton and Euler."""
    (phi, theta, psi), turned = euler_angles()
    m, g, l, a, c = constants("m g l A C")
    total = a + m * l**2
    spin = c * (d(psi) + d(phi) * cos(theta))
    momentum = total * d(phi) * sin(theta) ** 2 + spin * cos(theta)
    kinetic = (total * (d(theta) ** 2 + d(phi) ** 2 * sin(theta) ** 2) + spin**2 / c) / 2
    third = d(kinetic.diff(d(theta))) - kinetic.diff(theta) - m * g * l * sin(theta)
    body = Rigid(m, turned[:, 2] * l, turned, (a, a, c), force=(0, 0, -m * g))
    return (
        newton_euler("phi theta psi", [body]),
        literature("phi theta psi", (d(momentum), third, d(spin))),
        kane_of_bodies("phi theta psi", "ZXZ", (phi, theta, psi), (a, a, c), m, (0, 0, l), (0, 0, -m * g)),
    )


def heavy_top_cardan() -> tuple[Route, ...]:
    alpha, beta, gamma = moving("alpha beta gamma")
    m, g, l, a, c = constants("m g l A C")
    turned = rotation("x", alpha) * rotation("y", beta) * rotation("z", gamma)
    body = Rigid(m, turned[:, 2] * l, turned, (a, a, c), force=(0, 0, -m * g))
    angles = (alpha, beta, gamma)
    return (
        newton_euler("alpha beta gamma", [body]),
        kane_of_bodies("alpha beta gamma", "XYZ", angles, (a, a, c), m, (0, 0, l), (0, 0, -m * g)),
    )


def free_top() -> tuple[Route, ...]:
    """Euler: A p' = (B - C) q r, and cyclically."""
    (phi, theta, psi), _ = euler_angles()
    a, b, c = constants("A B C")
    p = d(phi) * sin(theta) * sin(psi) + d(theta) * cos(psi)
    q = d(phi) * sin(theta) * cos(psi) - d(theta) * sin(psi)
    r = d(phi) * cos(theta) + d(psi)
    book = (a * d(p) - (b - c) * q * r, b * d(q) - (c - a) * r * p, c * d(r) - (a - b) * p * q)
    return (
        literature("phi theta psi", book),
        kane_of_bodies("phi theta psi", "ZXZ", (phi, theta, psi), (a, b, c), sp.Symbol("m"), (0, 0, 0), (0, 0, 0)),
    )


def free_top_quasi() -> tuple[Route, ...]:
    """Euler's equations again, p', q' and r' being rates of quasi-coordinates."""
    phi, theta, psi, p, q, r = moving("phi theta psi p q r")
    a, b, c, moment = constants("A B C M_0")
    book = (
        a * d(p, 2) - (b - c) * d(q) * d(r),
        b * d(q, 2) - (c - a) * d(r) * d(p),
        c * d(r, 2) - (a - b) * d(p) * d(q) - moment,
    )
    rates = {
        "first": d(p) - d(phi) * sin(theta) * sin(psi) - d(theta) * cos(psi),
        "second": d(q) - d(phi) * sin(theta) * cos(psi) + d(theta) * sin(psi),
        "third": d(r) - d(phi) * cos(theta) - d(psi),
    }
    return (literature("phi theta psi p q r", book, kinematic=rates),)


def rolling_disc(uniform: bool = False) -> tuple[Route, ...]:
    """Neimark and Fufaev (heading phi, tilt theta, spin psi): moments about the point of contact.

    With w1 = theta', w2 = phi' sin theta, w3 = phi' cos theta + psi' about the horizontal diameter, the steepest radius and
    the axis, and v = -R w3 e1 + R w1 e3 for the centre:

        (A + m R^2) w1' + (C + m R^2) w3 w2 - A w2^2 cot theta = -m g R cos theta
        A w2' + A w1 w2 cot theta - C w1 w3 = 0
        (C + m R^2) w3' - m R^2 w1 w2 = 0
    """
    x, y, phi, theta, psi = moving("x y phi theta psi")
    m, g, radius, a, c = constants("m g R A C")
    if uniform:
        a, c = m * radius**2 / 4, m * radius**2 / 2
    w1, w2, w3 = d(theta), d(phi) * sin(theta), d(phi) * cos(theta) + d(psi)
    k = m * radius**2
    tilt = cos(theta) / sin(theta)
    book = (
        (a + k) * d(w1) + (c + k) * w3 * w2 - a * w2**2 * tilt + m * g * radius * cos(theta),
        a * d(w2) + a * w1 * w2 * tilt - c * w1 * w3,
        (c + k) * d(w3) - k * w1 * w2,
    )
    spin = d(psi) + d(phi) * cos(theta)
    rolling = {
        "rolling.1": d(x) + radius * (cos(phi) * spin - sin(phi) * sin(theta) * d(theta)),
        "rolling.2": d(y) + radius * (sin(phi) * spin + cos(phi) * sin(theta) * d(theta)),
    }
    turned = rotation("z", phi) * rotation("x", theta) * rotation("z", psi)
    body = Rigid(m, (x, y, radius * sin(theta)), turned, (a, a, c), force=(0, 0, -m * g))
    return (
        newton_euler("x y phi theta psi", [body], kinematic=rolling),
        literature("x y phi theta psi", book, kinematic=rolling),
    )


def ball_on_turntable() -> tuple[Route, ...]:
    """Neimark and Fufaev; Weckesser, Am. J. Phys. 65 (1997) 736: circles, with 2/7 of the angular velocity of the table."""
    x, y, alpha, beta, gamma = moving("x y alpha beta gamma")
    radius, turn = constants("R Omega")
    book = (
        d(x, 2) + sp.Rational(2, 7) * turn * d(y),
        d(y, 2) - sp.Rational(2, 7) * turn * d(x),
        d(gamma, 2),
    )
    rolling = {
        "along": d(x) - radius * d(beta) + turn * y,
        "across": d(y) + radius * d(alpha) - turn * x,
    }
    return (literature("x y alpha beta gamma", book, kinematic=rolling),)


def driven_plate() -> tuple[Route, ...]:
    theta, u = moving("theta u")
    m, a, b, c, l, g, turn = constants("m A B C l g Omega")
    turned = rotation("z", turn * t) * rotation("x", theta)
    at = sp.Matrix([0, 0, u]) - turned[:, 2] * l
    return (newton_euler("theta", [Rigid(m, at, turned, (a, b, c), force=(0, 0, -m * g))]),)


def driven_wheel() -> tuple[Route, ...]:
    (theta,) = moving("theta")
    a, c, m, g, l, turn = constants("A C m g l Omega")
    turned = rotation("z", theta) * rotation("x", sp.pi / 2) * rotation("z", turn * t)
    wheel = Rigid(m, (l * cos(theta), l * sin(theta), 0), turned, (a, a, c), force=(m * g, 0, 0))
    return (newton_euler("theta", [wheel]),)


# -- springs and dampers ---------------------------------------------------------------------------------------------


def spring_pendulum() -> tuple[Route, ...]:
    x, y = moving("x y")
    m, g, c, l = constants("m g c l")
    potential = c * (sqrt(x**2 + y**2) - l) ** 2 / 2 - m * g * y
    return (lagrange("x y", m * speed2(x, y) / 2, potential),)


def damped_oscillator() -> tuple[Route, ...]:
    x, u = moving("x u")
    m, c, b = constants("m c b")
    return (literature("x", [m * d(x, 2) + b * (d(x) - d(u)) + c * x]),)


def three_springs() -> tuple[Route, ...]:
    """The middle spring keeps its length where the masses change places."""
    x1, x2 = moving("x1 x2")
    m1, m2, c1, c2, c3, l1, l2, l3, length = constants("m1 m2 c1 c2 c3 l1 l2 l3 L")
    middle = c2 * (x2 - x1) * (1 - l2 / sqrt((x2 - x1) ** 2))
    book = (m1 * d(x1, 2) + c1 * (x1 - l1) - middle, m2 * d(x2, 2) + middle - c3 * (length - x2 - l3))
    return (literature("x1 x2", book),)


def braced_rods() -> tuple[Route, ...]:
    alpha, beta = moving("alpha beta")
    m, a, b, c, k, l, g = constants("m a b c k l g")

    def end(angle: sp.Expr, far: int, side: sp.Expr) -> sp.Matrix:
        return sp.Matrix([far * a * cos(angle), side + far * a * sin(angle), 0])

    spring = end(alpha, 1, 0) - end(beta, 2, b)
    damper = end(alpha, 2, 0) - end(beta, 1, b)
    length = sqrt(spring.dot(spring))
    closing = damper.dot(d(damper)) / damper.dot(damper)
    kinetic = 2 * m * a**2 * (d(alpha) ** 2 + d(beta) ** 2) / 3
    potential = k * (length - l) ** 2 / 2 - m * g * a * (cos(alpha) + cos(beta))
    forces = {q: -c * closing * damper.dot(damper.diff(q)) for q in (alpha, beta)}
    return (lagrange("alpha beta", kinetic, potential, forces),)


BODIES: dict[str, Textbook] = {
    "compound_pendulum": Textbook(compound_pendulum, HOLONOMIC, 1, 0),
    "rolling_cylinder": Textbook(rolling_cylinder, HOLONOMIC, 1, 2),
    "rolling_cylinder_by_velocities": Textbook(rolling_cylinder_by_velocities, HOLONOMIC, 1, 2),
    "cylinder_in_cylinder": Textbook(cylinder_in_cylinder, HOLONOMIC, 1, 1),
    "yo_yo": Textbook(yo_yo, HOLONOMIC, 1, 1),
    "sliding_ladder": Textbook(sliding_ladder, HOLONOMIC, 1, 2),
    "double_physical_pendulum": Textbook(double_physical_pendulum, HOLONOMIC, 2, 0),
    "heavy_atwood": Textbook(heavy_atwood, HOLONOMIC, 1, 2),
    "heavy_slider_crank": Textbook(heavy_slider_crank, HOLONOMIC, 1, 4, ranges={"a": (0.3, 0.5), "b": (2, 3)}),
    "pushed_plate": Textbook(pushed_plate, HOLONOMIC, 3, 0),
    "heavy_sleigh": Textbook(heavy_sleigh, NONHOLONOMIC, 2, 0, ("blade",)),
    "heavy_top": Textbook(heavy_top, HOLONOMIC, 3, 0),
    "heavy_top_without_spin": Textbook(heavy_top, HOLONOMIC, 3, 0),
    "heavy_top_cardan": Textbook(heavy_top_cardan, HOLONOMIC, 3, 0),
    "free_top": Textbook(free_top, HOLONOMIC, 3, 0),
    # p, q and r say nothing of the position: how the top is turned has three dimensions, and no velocity of it is bound.
    "free_top_quasi": Textbook(free_top_quasi, HOLONOMIC, 3, 3, ("first", "second", "third")),
    "rolling_disc": Textbook(rolling_disc, NONHOLONOMIC, 3, 0, ("rolling.1", "rolling.2")),
    "ball_on_turntable": Textbook(
        ball_on_turntable, "nonholonomic scleronomic acatastatic", 3, 0, ("rolling.1", "rolling.2")
    ),
    "driven_plate": Textbook(driven_plate, "holonomic rheonomic catastatic", 1, 0),
    "driven_wheel": Textbook(driven_wheel, "holonomic rheonomic catastatic", 1, 0),
    "spring_pendulum": Textbook(spring_pendulum, HOLONOMIC, 2, 0),
    "damped_oscillator": Textbook(damped_oscillator, HOLONOMIC, 1, 0),
    "three_springs": Textbook(three_springs, HOLONOMIC, 2, 0),
    "braced_rods": Textbook(braced_rods, HOLONOMIC, 2, 0),
}  # fmt: skip
