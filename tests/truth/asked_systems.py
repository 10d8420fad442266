"""The shipped problems of motion that ask questions, each with its equations by a second route.

As in `shipped_systems`. The answers to their questions have a second route of their own, in `test_questions`.
"""

from __future__ import annotations

import sympy as sp
from sympy import cos, sin

from tests.support.second_route import Route, constants, lagrange, literature, moving, newton, newton_euler, t
from tests.truth.body_systems import flat
from tests.truth.textbook_systems import HOLONOMIC, Textbook, d


def leaving_a_sphere() -> tuple[Route, ...]:
    r, theta = moving("r theta")
    m, radius, g = constants("m R g")
    at = (r * sin(theta), r * cos(theta))
    return (newton("r theta", [(m, at, (0, -m * g))], {"sphere": r - radius}),)


def loop_the_loop() -> tuple[Route, ...]:
    r, theta = moving("r theta")
    m, radius, g = constants("m R g")
    at = (r * sin(theta), -r * cos(theta))
    return (newton("r theta", [(m, at, (0, -m * g))], {"track": r - radius}),)


def released_pendulum() -> tuple[Route, ...]:
    x, y = moving("x y")
    m, l, g = constants("m l g")
    return (newton("x y", [(m, (x, y), (0, m * g))], {"string": x**2 + y**2 - l**2}),)


def radial() -> tuple[Route, ...]:
    r = moving("r")[0]
    m, strength = constants("m K")
    return (newton("r", [(m, (r, sp.S.Zero), (-m * strength / r**2, 0))]),)


def sledge_up_a_slope() -> tuple[Route, ...]:
    x, y = moving("x y")
    m, mu, alpha, g = constants("m mu alpha g")
    normal = sp.Symbol("lambda_slope")
    along = m * d(x, 2) + m * g * sin(alpha) + mu * normal
    away = m * d(y, 2) + m * g * cos(alpha) - normal
    return (literature("x y", (along, away), {"slope": y}, multipliers="lambda_slope"),)


def bead_slowed_on_a_ring() -> tuple[Route, ...]:
    """The ring presses inwards: its multiplier is negative, and friction is mu times its opposite."""
    r, theta = moving("r theta")
    m, radius, mu = constants("m R mu")
    outward = sp.Symbol("lambda_ring")
    radial_law = m * (d(r, 2) - r * d(theta) ** 2) - outward
    around = m * (r * d(theta, 2) + 2 * d(r) * d(theta)) - mu * outward
    return (literature("r theta", (radial_law, around), {"ring": r - radius}, multipliers="lambda_ring"),)


def weight_let_go_on_a_spring() -> tuple[Route, ...]:
    x = moving("x")[0]
    m, k, g = constants("m k g")
    return (lagrange("x", m * d(x) ** 2 / 2, k * x**2 / 2 - m * g * x),)


def thrown_stone() -> tuple[Route, ...]:
    x, y = moving("x y")
    m, g = constants("m g")
    return (newton("x y", [(m, (x, y), (0, -m * g))]),)


def fall_through_air() -> tuple[Route, ...]:
    y = moving("y")[0]
    m, c, g = constants("m c g")
    return (literature("y", (m * d(y, 2) - m * g + c * sp.Abs(d(y)) * d(y),)),)


def boat_that_drifts() -> tuple[Route, ...]:
    x = moving("x")[0]
    m, b = constants("m b")
    return (literature("x", (m * d(x, 2) + b * d(x),)),)


def shaken_into_resonance() -> tuple[Route, ...]:
    x = moving("x")[0]
    m, k, force, w = constants("m k F w")
    return (newton("x", [(m, (x, sp.S.Zero), (-k * x + force * cos(w * t), 0))]),)


def rolling_without_slip() -> tuple[Route, ...]:
    x, y, theta = moving("x y theta")
    m, radius, alpha, g = constants("m R alpha g")
    weight = (m * g * sin(alpha), -m * g * cos(alpha), 0)
    cylinder = flat(m, (x, y), m * radius**2 / 2, -theta, force=weight)
    return (newton_euler("x y theta", [cylinder], {"contact": y - radius}, {"rolling": radius * d(theta) - d(x)}),)


def hoop_off_a_cylinder() -> tuple[Route, ...]:
    r, theta, phi = moving("r theta phi")
    m, a, radius, g = constants("m a R g")
    hoop = flat(m, (r * sin(theta), r * cos(theta)), m * a**2, -phi, force=(0, -m * g, 0))
    rolling = a * d(phi) - (radius + a) * d(theta)
    return (newton_euler("r theta phi", [hoop], {"contact": r - radius - a}, {"rolling": rolling}),)


def ball_thrown_up() -> tuple[Route, ...]:
    y = moving("y")[0]
    m, c, g = constants("m c g")
    return (literature("y", (m * d(y, 2) + m * g + c * sp.Abs(d(y)) * d(y),)),)


def charge_in_crossed_fields() -> tuple[Route, ...]:
    x, y = moving("x y")
    m, charge, electric, magnetic = constants("m q E B")
    along = m * d(x, 2) - charge * magnetic * d(y)
    return (literature("x y", (along, m * d(y, 2) + charge * magnetic * d(x) - charge * electric)),)


def wandering_energy() -> tuple[Route, ...]:
    x, y = moving("x y")
    m, k, c = constants("m k c")
    kinetic = m * (d(x) ** 2 + d(y) ** 2) / 2
    return (lagrange("x y", kinetic, k * (x**2 + y**2) / 2 + c * (x - y) ** 2 / 2),)


def rod_cut_loose() -> tuple[Route, ...]:
    x, y, theta = moving("x y theta")
    m, l, b, g = constants("m l b g")
    rod = flat(m, (x, y), m * l**2 / 12, theta, force=(0, -m * g, 0))
    end = (x - l / 2 * cos(theta)) ** 2 + (y - l / 2 * sin(theta)) ** 2
    return (newton_euler("x y theta", [rod], {"string": end - b**2}),)


def ladder_leaves_the_wall() -> tuple[Route, ...]:
    x, y, theta = moving("x y theta")
    m, l, g = constants("m l g")
    ladder = flat(m, (x, y), m * l**2 / 3, theta, force=(0, -m * g, 0))
    contacts = {"wall": x - l * sin(theta), "floor": y - l * cos(theta)}
    return (newton_euler("x y theta", [ladder], contacts),)


def over_the_top() -> tuple[Route, ...]:
    theta = moving("theta")[0]
    m, l, g = constants("m l g")
    return (lagrange("theta", m * l**2 * d(theta) ** 2 / 2, -m * g * l * cos(theta)),)


def rear_wheel_drive() -> tuple[Route, ...]:
    """The drive acts at the rear wheel, with the moment about the centre of the force at (−b, −h), turned with the car."""
    x, y, phi = moving("x y phi")
    m, inertia, b, c, h, drive, g = constants("m J b c h F g")
    arm = -b * sin(phi) - h * cos(phi)
    car = flat(m, (x, y), inertia, phi, force=(drive, -m * g, 0), moment=(0, 0, -arm * drive))
    rear, front = (y + s * sin(phi) - h * cos(phi) for s in (-b, c))
    return (newton_euler("x y phi", [car], {"rear": rear, "front": front}),)


def crest_of_a_hill() -> tuple[Route, ...]:
    x, y = moving("x y")
    m, a, h, g = constants("m a h g")
    return (newton("x y", [(m, (x, y), (0, -m * g))], {"road": y - h + x**2 / (2 * a)}),)


def ball_with_backspin() -> tuple[Route, ...]:
    """Newton and Euler: friction mu N to the left at the lowest point, against the slip to the right."""
    x, y, theta = moving("x y theta")
    m, radius, mu, g = constants("m R mu g")
    normal = sp.Symbol("lambda_lane")
    equations = (
        m * d(x, 2) + mu * normal,
        m * d(y, 2) + m * g - normal,
        sp.Rational(2, 5) * m * radius**2 * d(theta, 2) - mu * normal * radius,
    )
    return (literature("x y theta", equations, {"lane": y - radius}, multipliers="lambda_lane"),)


def stone_in_linear_drag() -> tuple[Route, ...]:
    y = moving("y")[0]
    m, c, g = constants("m c g")
    return (newton("y", [(m, (sp.S.Zero, y), (0, -m * g - c * d(y)))]),)


ASKED: dict[str, Textbook] = {
    "ball-with-backspin": Textbook(ball_with_backspin, HOLONOMIC, 2, 1),
    "crest-of-a-hill": Textbook(crest_of_a_hill, HOLONOMIC, 1, 1),
    "stone-in-linear-drag": Textbook(stone_in_linear_drag, HOLONOMIC, 1, 0),
    "ball-thrown-up": Textbook(ball_thrown_up, HOLONOMIC, 1, 0),
    "bead-slowed-on-a-ring": Textbook(bead_slowed_on_a_ring, HOLONOMIC, 1, 1),
    "boat-that-drifts": Textbook(boat_that_drifts, HOLONOMIC, 1, 0),
    "charge-in-crossed-fields": Textbook(charge_in_crossed_fields, HOLONOMIC, 2, 0),
    "coasting-away": Textbook(radial, HOLONOMIC, 1, 0),
    "escape-from-a-planet": Textbook(radial, HOLONOMIC, 1, 0),
    "fall-through-air": Textbook(fall_through_air, HOLONOMIC, 1, 0),
    "hoop-off-a-cylinder": Textbook(hoop_off_a_cylinder, HOLONOMIC, 1, 2),
    "ladder-leaves-the-wall": Textbook(ladder_leaves_the_wall, HOLONOMIC, 1, 2),
    "leaving-a-sphere": Textbook(leaving_a_sphere, HOLONOMIC, 1, 1),
    "loop-the-loop": Textbook(loop_the_loop, HOLONOMIC, 1, 1),
    "over-the-top": Textbook(over_the_top, HOLONOMIC, 1, 0),
    "rear-wheel-drive": Textbook(rear_wheel_drive, HOLONOMIC, 1, 2),
    "released-pendulum": Textbook(released_pendulum, HOLONOMIC, 1, 1, ranges={"l": (2, 3)}),
    "rod-cut-loose": Textbook(rod_cut_loose, HOLONOMIC, 2, 1),
    "rolling-without-slip": Textbook(rolling_without_slip, HOLONOMIC, 1, 2),
    "shaken-into-resonance": Textbook(shaken_into_resonance, HOLONOMIC, 1, 0),
    "sledge-up-a-slope": Textbook(sledge_up_a_slope, HOLONOMIC, 1, 1),
    "thrown-stone": Textbook(thrown_stone, HOLONOMIC, 2, 0),
    "wandering-energy": Textbook(wandering_energy, HOLONOMIC, 2, 0),
    "weight-let-go-on-a-spring": Textbook(weight_let_go_on_a_spring, HOLONOMIC, 1, 0),
}
