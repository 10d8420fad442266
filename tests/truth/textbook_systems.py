"""Problems of particles (`systems/*.yaml`), each with its equations of motion by a second route and what is known of it.

The routes are typed from the drawing, not from the problem file: positions in Cartesian components, kinetic energies,
or equations as the literature has them. `freedom` is the number of independent virtual displacements, `integrable` the
number of independent finite relations in the constraints.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

import sympy as sp
from sympy import Rational, cos, cosh, diff, sin, sqrt, tan

from tests.support.second_route import Route, constants, kane, lagrange, literature, moving, newton, t

Function = tuple[str, sp.Expr]


@dataclass(frozen=True)
class Textbook:
    """What is known of one problem.

    classification  words that hold, in the order of the file format
    not_integrable  names of constraints that are no finite relation on their own
    redundant       names of constraints that follow from those before them
    ranges          from where symbols are drawn
    functions       undefined functions: names of the arguments, and the expression to put for the function
    """

    routes: Callable[[], tuple[Route, ...]]
    classification: str
    freedom: int
    integrable: int
    not_integrable: tuple[str, ...] = ()
    redundant: tuple[str, ...] = ()
    ranges: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    functions: Mapping[str, Function] = field(default_factory=dict)


def d(e: sp.Expr, order: int = 1) -> sp.Expr:
    return diff(e, t, order)


def dot(a: tuple[sp.Expr, ...], b: tuple[sp.Expr, ...]) -> sp.Expr:
    return sum(x * y for x, y in zip(a, b, strict=True))


def square(a: tuple[sp.Expr, ...]) -> sp.Expr:
    return dot(a, a)


def speed2(*r: sp.Expr) -> sp.Expr:
    return sum(d(c) ** 2 for c in r)


HALF = Rational(1, 2)
HOLONOMIC = "holonomic scleronomic catastatic"
NONHOLONOMIC = "nonholonomic scleronomic catastatic"


# -- free particles --------------------------------------------------------------------------------------------------


def projectile_with_drag() -> tuple[Route, ...]:
    x, y, z = moving("x y z")
    m, g, c = constants("m g c")
    force = (-c * d(x), -c * d(y), -c * d(z) - m * g)
    return (newton("x y z", [(m, (x, y, z), force)]), kane("x y z", [(m, (x, y, z), force)]))


def charged_particle() -> tuple[Route, ...]:
    """Landau and Lifshitz, The Classical Theory of Fields, section 22."""
    x, y, z = moving("x y z")
    m, q, sigma, e_field, b_field = constants("m q sigma E B")
    charge = sigma * q
    equations = (
        m * d(x, 2) - charge * b_field * d(y),
        m * d(y, 2) - charge * e_field + charge * b_field * d(x),
        d(z, 2),
    )
    return (literature("x y z", equations),)


def charged_pendulum() -> tuple[Route, ...]:
    x, y, z = moving("x y z")
    m, l, g, q, b_field = constants("m l g q B")
    force = (q * b_field * d(y), -q * b_field * d(x), m * g)
    rod = {"rod": x**2 + y**2 + z**2 - l**2}
    return (newton("x y z", [(m, (x, y, z), force)], rod), kane("x y z", [(m, (x, y, z), force)], "z", rod))


def kepler() -> tuple[Route, ...]:
    r, phi = moving("r phi")
    m, kappa = constants("m kappa")
    kinetic = m * (d(r) ** 2 + r**2 * d(phi) ** 2) / 2
    return (lagrange("r phi", kinetic, -kappa / r),)


def two_body() -> tuple[Route, ...]:
    x1, y1, x2, y2 = moving("x1 y1 x2 y2")
    m1, m2, gamma = constants("m1 m2 G")
    distance = sqrt((x2 - x1) ** 2 + (y2 - y1) ** 2)
    pull = [gamma * m1 * m2 * c / distance**3 for c in (x2 - x1, y2 - y1)]
    points = [(m1, (x1, y1, 0), (*pull, 0)), (m2, (x2, y2, 0), (-pull[0], -pull[1], 0))]
    return (newton("x1 y1 x2 y2", points),)


def central_force_in_space() -> tuple[Route, ...]:
    r, theta, phi = moving("r theta phi")
    (m,) = constants("m")
    n = (sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta))
    force = 1 / r**2 - 3 * r + sin(r)
    return (newton("r theta phi", [(m, tuple(r * c for c in n), tuple(force * c for c in n))]),)


def undefined_forces() -> tuple[Route, ...]:
    x, y, z = moving("x y z")
    (m,) = constants("m")
    force = (d(x) ** 2 * x - sin(t), x * y**2 + 1, 3 * d(z) - 7)
    return (newton("x y z", [(m, (x, y, z), force)], {"ground": z}),)


def foucault() -> tuple[Route, ...]:
    """Sommerfeld, Mechanics, section 31, with the centrifugal terms kept; and Newton's law in the fixed frame."""
    x, y = moving("X Y")
    m, w, turn = constants("m w Omega")
    book = (
        d(x, 2) - 2 * turn * d(y) - turn**2 * x + w**2 * x,
        d(y, 2) + 2 * turn * d(x) - turn**2 * y + w**2 * y,
    )
    r = (x * cos(turn * t) - y * sin(turn * t), x * sin(turn * t) + y * cos(turn * t), sp.S.Zero)
    return (literature("X Y", book), newton("X Y", [(m, r, tuple(-m * w**2 * c for c in r))]))


def elastic_pendulum() -> tuple[Route, ...]:
    r, phi = moving("r phi")
    m, g, kappa, l0 = constants("m g kappa l0")
    kinetic = m * (d(r) ** 2 + r**2 * d(phi) ** 2) / 2
    return (lagrange("r phi", kinetic, kappa * (r - l0) ** 2 / 2 - m * g * r * cos(phi)),)


def spherical_pendulum() -> tuple[Route, ...]:
    theta, phi = moving("theta phi")
    m, g, l = constants("m g l")
    r = (l * sin(theta) * cos(phi), l * sin(theta) * sin(phi), -l * cos(theta))
    return (kane("theta phi", [(m, r, (0, 0, -m * g))]),)


# -- prescribed motions, independent coordinates ---------------------------------------------------------------------


def moved_support() -> tuple[Route, ...]:
    (theta,) = moving("theta")
    (u,) = moving("u")
    m, g, l = constants("m g l")
    r = (u + l * sin(theta), l * cos(theta))
    return (lagrange("theta", m * speed2(*r) / 2, -m * g * r[1]),)


def kapitza() -> tuple[Route, ...]:
    x, y = moving("x y")
    m, g, l, a, omega = constants("m g l a omega")
    rod = {"rod": x**2 + (y - a * cos(omega * t)) ** 2 - l**2}
    return (newton("x y", [(m, (x, y), (0, m * g))], rod),)


def driven_wire() -> tuple[Route, ...]:
    r, phi, psi = moving("r phi psi")
    m, g = constants("m g")
    kinetic = m * (d(r) ** 2 + r**2 * d(phi) ** 2) / 2
    return (lagrange("r phi", kinetic, m * g * r * sin(phi), geometric={"wire": phi - psi}),)


def pendulum_between_planes() -> tuple[Route, ...]:
    r, theta, phi, u = moving("r theta phi u")
    m, g, l = constants("m g l")
    at = (r * sin(theta) * cos(phi), r * sin(theta) * sin(phi), r * cos(theta))
    return (newton("r theta phi", [(m, at, (0, 0, m * g))], {"rod": r - l, "turning": phi - u}),)


def lever() -> tuple[Route, ...]:
    (theta,) = moving("theta")
    m, l, g, force, omega = constants("m l g F Omega")
    torque = 2 * l * cos(theta) * force * cos(omega * t) - m * g * l * sin(theta)
    return (literature("theta", [m * l**2 * d(theta, 2) - torque]),)


def cycloid() -> tuple[Route, ...]:
    """Arc length s = 4 R sin(psi/2) oscillates harmonically: s'' = -(g/4R) s (Huygens)."""
    (psi,) = moving("psi")
    g, radius = constants("g R")
    s = 4 * radius * sin(psi / 2)
    return (literature("psi", [d(s, 2) + g / (4 * radius) * s]),)


# -- pendulums and chains --------------------------------------------------------------------------------------------


def cart_with_pendulum() -> tuple[Route, ...]:
    cart, x, y = moving("X x y")
    big, m, l, g = constants("M m l g")
    rod = {"rod": (x - cart) ** 2 + y**2 - l**2}
    points = [(big, (cart, 0, 0), (0, 0, 0)), (m, (x, y, 0), (0, m * g, 0))]
    kinetic = (big * d(cart) ** 2 + m * speed2(x, y)) / 2
    return (newton("X x y", points, rod), lagrange("X x y", kinetic, -m * g * y, geometric=rod))


def triple_pendulum() -> tuple[Route, ...]:
    a, b, c = moving("a b c")
    m, g, l = constants("m g l")
    x, y, points = sp.S.Zero, sp.S.Zero, []
    for q in (a, b, c):
        x, y = x + l * sin(q), y + l * cos(q)
        points.append((m, (x, y, 0), (0, m * g, 0)))
    return (kane("a b c", points),)


def chain_of_four() -> tuple[Route, ...]:
    names = "x1 y1 x2 y2 x3 y3 x4 y4"
    q = moving(names)
    m = constants("m1 m2 m3 m4")
    l = constants("l1 l2 l3 l4")
    (g,) = constants("g")
    points = [(m[n], (q[2 * n], q[2 * n + 1]), (0, m[n] * g)) for n in range(4)]
    rods = {"rod1": q[0] ** 2 + q[1] ** 2 - l[0] ** 2}
    for n in (1, 2, 3):
        dx, dy = q[2 * n] - q[2 * n - 2], q[2 * n + 1] - q[2 * n - 1]
        rods[f"rod{n + 1}"] = dx**2 + dy**2 - l[n] ** 2
    return (newton(names, points, rods),)


def charged_or_plain_sphere(force: str) -> Callable[[], tuple[Route, ...]]:
    def sphere() -> tuple[Route, ...]:
        x, y, z = moving("x y z")
        m, g, l = constants("m g l")
        return (newton("x y z", [(m, (x, y, z), (0, 0, m * g))], {force: x**2 + y**2 + z**2 - l**2}),)

    return sphere


def sphere_with_moving_centre() -> tuple[Route, ...]:
    x, y, z, u, w = moving("x y z u w")
    m, g, l = constants("m g l")
    rod = {"rod": (x - u) ** 2 + y**2 + (z - w) ** 2 - l**2}
    return (newton("x y z", [(m, (x, y, z), (0, 0, m * g))], rod),)


# -- curves and surfaces ---------------------------------------------------------------------------------------------


def bead_on_parabola() -> tuple[Route, ...]:
    x, y = moving("x y")
    m, g, a = constants("m g a")
    wire = {"wire": y - a * x**2}
    return (newton("x y", [(m, (x, y), (0, -m * g))], wire), kane("x y", [(m, (x, y, 0), (0, -m * g, 0))], "y", wire))


def bead_on_helix() -> tuple[Route, ...]:
    rho, phi, z = moving("rho phi z")
    m, g, radius, h = constants("m g R h")
    at = (rho * cos(phi), rho * sin(phi), z)
    return (newton("rho phi z", [(m, at, (0, 0, -m * g))], {"cylinder": rho - radius, "pitch": z - h * phi}),)


def bead_on_helix_cartesian() -> tuple[Route, ...]:
    x, y, z = moving("x y z")
    m, g, radius, h = constants("m g R h")
    wire = {"first": x - radius * cos(z / h), "second": y - radius * sin(z / h)}
    return (newton("x y z", [(m, (x, y, z), (0, 0, -m * g))], wire),)


def rotating_hoop() -> tuple[Route, ...]:
    x, y, z = moving("x y z")
    m, g, radius, turn = constants("m g R Omega")
    hoop = {"hoop": x**2 + y**2 + z**2 - radius**2, "plane": x * sin(turn * t) - y * cos(turn * t)}
    return (newton("x y z", [(m, (x, y, z), (0, 0, m * g))], hoop),)


def particle_in_cone() -> tuple[Route, ...]:
    rho, phi, z = moving("rho phi z")
    m, g, alpha = constants("m g alpha")
    kinetic = m * (d(rho) ** 2 + rho**2 * d(phi) ** 2 + d(z) ** 2) / 2
    return (lagrange("rho phi z", kinetic, m * g * z, geometric={"cone": rho - z * tan(alpha)}),)


def cartesian_cone() -> tuple[Route, ...]:
    x, y, z = moving("x y z")
    m, g, c = constants("m g c")
    return (newton("x y z", [(m, (x, y, z), (0, 0, -m * g))], {"cone": z**2 - c**2 * (x**2 + y**2)}),)


def paraboloid() -> tuple[Route, ...]:
    x, y, z = moving("x y z")
    m, g, a, b = constants("m g a b")
    bowl = {"bowl": z - x**2 / (2 * a) - y**2 / (2 * b)}
    return (newton("x y z", [(m, (x, y, z), (0, 0, -m * g))], bowl),)


def torus() -> tuple[Route, ...]:
    x, y, z = moving("x y z")
    m, g, big, a = constants("m g R a")
    return (newton("x y z", [(m, (x, y, z), (0, 0, -m * g))], {"torus": (sqrt(x**2 + y**2) - big) ** 2 + z**2 - a**2}),)


def torus_with_angles() -> tuple[Route, ...]:
    rho, phi, z = moving("rho phi z")
    m, g, big, a = constants("m g R a")
    at = (rho * cos(phi), rho * sin(phi), z)
    return (newton("rho phi z", [(m, at, (0, 0, -m * g))], {"torus": (rho - big) ** 2 + z**2 - a**2}),)


def moving_incline() -> tuple[Route, ...]:
    x, y, z, u = moving("x y z u")
    m, g, alpha = constants("m g alpha")
    return (newton("x y z", [(m, (x, y, z), (0, 0, -m * g))], {"incline": z - x * tan(alpha) - u}),)


SURFACE = "X**2 + 2*Y*Z + sin(X)*Y + Z**2/3"


def moving_surface() -> tuple[Route, ...]:
    x, y, z = moving("x y z")
    m, g, v, c = constants("m g v c")
    f = sp.sympify(SURFACE, locals={"X": x - v * t, "Y": y, "Z": z})
    return (newton("x y z", [(m, (x, y, z), (0, 0, -m * g))], {"surface": f - c}),)


def growing_circle() -> tuple[Route, ...]:
    x, y = moving("x y")
    m, a, b, c = constants("m a b c")
    return (newton("x y", [(m, (x, y), (0, 0))], {"circle": x**2 + y**2 - (a + b * t + c * t**2) ** 2}),)


def two_spheres() -> tuple[Route, ...]:
    x, y, z = moving("x y z")
    m, g, one, two, b = constants("m g R S b")
    spheres = {"first": x**2 + y**2 + z**2 - one**2, "second": (x - b) ** 2 + y**2 + z**2 - two**2}
    return (newton("x y z", [(m, (x, y, z), (0, 0, -m * g))], spheres),)


def catenary() -> tuple[Route, ...]:
    x, y = moving("x y")
    m, g, a = constants("m g a")
    return (newton("x y", [(m, (x, y), (0, -m * g))], {"wire": y - a * cosh(x / a)}),)


def knotted_space_curve() -> tuple[Route, ...]:
    x, y, z = moving("x y z")
    m, g, a, c = constants("m g a c")
    return (newton("x y z", [(m, (x, y, z), (0, 0, -m * g))], {"first": y - a * x**2, "second": z - c * x * y}),)


def rod_twice() -> tuple[Route, ...]:
    x, y, z = moving("x y z")
    m, l, g = constants("m l g")
    return (newton("x y z", [(m, (x, y, z), (0, m * g, 0))], {"rod": x**2 + y**2 - l**2, "plane": z}),)


# -- machines --------------------------------------------------------------------------------------------------------


def atwood() -> tuple[Route, ...]:
    y1, y2 = moving("y1 y2")
    m1, m2, g, length = constants("m1 m2 g L")
    tension = sp.Symbol("lambda_string")
    equations = (m1 * d(y1, 2) - m1 * g - tension, m2 * d(y2, 2) - m2 * g - tension)
    return (literature("y1 y2", equations, {"string": y1 + y2 - length}, multipliers="lambda_string"),)


def double_atwood() -> tuple[Route, ...]:
    """Two tensions, the massless pulley in equilibrium between them: T1 = 2 T2."""
    y1, p, y2, y3 = moving("y1 p y2 y3")
    m1, m2, m3, g, long, short = constants("m1 m2 m3 g L1 L2")
    upper, lower = constants("T1 T2")
    equations = (
        m1 * d(y1, 2) - m1 * g + upper,
        -upper + 2 * lower,
        m2 * d(y2, 2) - m2 * g + lower,
        m3 * d(y3, 2) - m3 * g + lower,
    )
    strings = {"upper_string": y1 + p - long, "lower_string": y2 + y3 - 2 * p - short}
    return (literature("y1 p y2 y3", equations, strings, multipliers="T1 T2"),)


def block_on_wedge() -> tuple[Route, ...]:
    wedge, x, y = moving("X x y")
    big, m, alpha, g = constants("M m alpha g")
    face = {"face": y - (x - wedge) * tan(alpha)}
    kinetic = big * d(wedge) ** 2 / 2 + m * speed2(x, y) / 2
    return (lagrange("X x y", kinetic, m * g * y, geometric=face),)


def circles_with_common_point() -> tuple[Route, ...]:
    x1, y1, x2, y2 = moving("x1 y1 x2 y2")
    m1, m2, g, a, b, l = constants("m1 m2 g a b l")
    constraints = {
        "first": x1**2 + y1**2 - 2 * a * x1,
        "second": x2**2 + y2**2 - 2 * b * y2,
        "rod": (x1 - x2) ** 2 + (y1 - y2) ** 2 - l**2,
    }
    return (newton("x1 y1 x2 y2", [(m1, (x1, y1), (0, m1 * g)), (m2, (x2, y2), (0, m2 * g))], constraints),)


def four_bar() -> tuple[Route, ...]:
    x1, y1, x2, y2 = moving("x1 y1 x2 y2")
    m1, m2, g, a, b, c, e = constants("m1 m2 g a b c d")
    bars = {
        "crank": x1**2 + y1**2 - a**2,
        "coupler": (x2 - x1) ** 2 + (y2 - y1) ** 2 - b**2,
        "rocker": (x2 - e) ** 2 + y2**2 - c**2,
    }
    return (newton("x1 y1 x2 y2", [(m1, (x1, y1), (0, m1 * g)), (m2, (x2, y2), (0, m2 * g))], bars),)


def slider_crank() -> tuple[Route, ...]:
    x1, y1, x2, y2 = moving("x1 y1 x2 y2")
    m1, m2, g, a, b, force = constants("m1 m2 g a b F")
    bars = {"crank": x1**2 + y1**2 - a**2, "coupler": (x2 - x1) ** 2 + (y2 - y1) ** 2 - b**2, "guide": y2}
    points = [(m1, (x1, y1), (0, -m1 * g)), (m2, (x2, y2), (-force, -m2 * g))]
    return (newton("x1 y1 x2 y2", points, bars),)


def trammel() -> tuple[Route, ...]:
    x, y = moving("x y")
    m1, m2, g, l = constants("m1 m2 g l")
    kinetic = (m1 * d(x) ** 2 + m2 * d(y) ** 2) / 2
    return (lagrange("x y", kinetic, m2 * g * y, geometric={"rod": x**2 + y**2 - l**2}),)


def swinging_atwood() -> tuple[Route, ...]:
    """Tufillaro, Abbott and Griffiths, Am. J. Phys. 52 (1984) 895, with the weight's coordinate kept."""
    r, phi, y = moving("r phi y")
    big, m, g, length = constants("M m g L")
    kinetic = m * (d(r) ** 2 + r**2 * d(phi) ** 2) / 2 + big * d(y) ** 2 / 2
    potential = -m * g * r * cos(phi) - big * g * y
    return (lagrange("r phi y", kinetic, potential, geometric={"string": r + y - length}),)


def hole_in_table() -> tuple[Route, ...]:
    x, y, z = moving("x y z")
    m, big, g, l = constants("m M g l")
    points = [(m, (x, y, 0), (0, 0, -m * g)), (big, (0, 0, z), (0, 0, -big * g))]
    return (newton("x y z", points, {"string": sqrt(x**2 + y**2) - z - l}),)


def three_on_a_ring() -> tuple[Route, ...]:
    a, b, c = moving("alpha beta gamma")
    m, radius, length = constants("m R a")
    at = [(radius * cos(q), radius * sin(q)) for q in (a, b, c)]
    push = tuple(m * radius * t * (at[0][n] - at[2][n]) for n in (0, 1))
    rod = {"rod": (at[0][0] - at[1][0]) ** 2 + (at[0][1] - at[1][1]) ** 2 - length**2}
    points = [(m, at[0], (0, 0)), (2 * m, at[1], (0, 0)), (3 * m, at[2], push)]
    return (newton("alpha beta gamma", points, rod),)


# -- constraints on velocities ---------------------------------------------------------------------------------------


def dumbbell(*, middle: tuple[sp.Expr, ...], half: sp.Expr, theta: sp.Expr) -> list[tuple[sp.Expr, ...]]:
    e = (cos(theta), sin(theta))
    return [tuple(c + s * half * u for c, u in zip(middle, e, strict=True)) for s in (-1, 1)]


def skate_with_masses() -> tuple[Route, ...]:
    x, y, theta = moving("x y theta")
    m, l = constants("m l")
    ends = dumbbell(middle=(x, y), half=l, theta=theta)
    blade = {"blade": d(x) * sin(theta) - d(y) * cos(theta)}
    kinetic = sum(m * speed2(*r) / 2 for r in ends)
    return (
        newton("x y theta", [(m, r, (0, 0)) for r in ends], kinematic=blade),
        lagrange("x y theta", kinetic, kinematic=blade),
        kane("x y theta", [(m, (*r, sp.S.Zero), (0, 0, 0)) for r in ends], "y", kinematic=blade),
    )


def knife_edge() -> tuple[Route, ...]:
    """Neimark and Fufaev, Dynamics of Nonholonomic Systems: the edge turns uniformly and drifts across the slope."""
    x, y, theta = moving("x y theta")
    m, a, g, alpha = constants("m a g alpha")
    ends = dumbbell(middle=(x, y), half=a, theta=theta)
    edge = {"edge": sin(theta) * d(x) - cos(theta) * d(y)}
    weight = (0, m * g * sin(alpha))
    book = (d(theta, 2), cos(theta) * d(x, 2) + sin(theta) * d(y, 2) - g * sin(alpha) * sin(theta))
    return (
        newton("x y theta", [(m, r, weight) for r in ends], kinematic=edge),
        literature("x y theta", book, kinematic=edge),
    )


def chaplygin_sleigh() -> tuple[Route, ...]:
    x, y, theta = moving("x y theta")
    m1, m2, a, b = constants("m1 m2 a b")
    e, n = (cos(theta), sin(theta)), (-sin(theta), cos(theta))
    first = tuple(c + a * u + b * w for c, u, w in zip((x, y), e, n, strict=True))
    second = tuple(c + a * u - b * w for c, u, w in zip((x, y), e, n, strict=True))
    blade = {"blade": -d(x) * sin(theta) + d(y) * cos(theta)}
    kinetic = m1 * speed2(*first) / 2 + m2 * speed2(*second) / 2
    return (lagrange("x y theta", kinetic, kinematic=blade),)


def heisenberg() -> tuple[Route, ...]:
    x, y, z = moving("x y z")
    m, g, c = constants("m g c")
    climb = {"climb": d(z) - c * (x * d(y) - y * d(x))}
    return (
        newton("x y z", [(m, (x, y, z), (0, 0, -m * g))], kinematic=climb),
        kane("x y z", [(m, (x, y, z), (0, 0, -m * g))], "z", kinematic=climb),
    )


def pars() -> tuple[Route, ...]:
    """Pars: (1 + y^2) x'' + y x' y' = X + y Z, y'' = Y, for m = 1."""
    x, y, z = moving("x y z")
    (m,) = constants("m")
    fx, fy, fz = x * y - z, z**2 + x, x - 2 * y + sin(z)
    slope = {"slope": d(z) - y * d(x)}
    book = (m * ((1 + y**2) * d(x, 2) + y * d(x) * d(y)) - fx - y * fz, m * d(y, 2) - fy)
    return (
        literature("x y z", book, kinematic=slope),
        newton("x y z", [(m, (x, y, z), (fx, fy, fz))], kinematic=slope),
    )


def pursuit() -> tuple[Route, ...]:
    x, y = moving("x y")
    m, v = constants("m v")
    return (newton("x y", [(m, (x, y), (0, 0))], kinematic={"aim": (v * t - x) * d(y) + y * d(x)}),)


def turning_rail() -> tuple[Route, ...]:
    x, y = moving("x y")
    m, omega, force = constants("m omega F")
    blade = {"blade": cos(omega * t) * d(y) - sin(omega * t) * d(x)}
    return (newton("x y", [(m, (x, y), (force, 0))], kinematic=blade),)


def drifting_skate() -> tuple[Route, ...]:
    x, y, theta = moving("x y theta")
    m, l, v = constants("m l v")
    ends = dumbbell(middle=(x, y), half=l, theta=theta)
    blade = {"blade": (d(x) - v) * sin(theta) - d(y) * cos(theta)}
    return (newton("x y theta", [(m, r, (0, 0)) for r in ends], kinematic=blade),)


def sphere_by_velocities() -> tuple[Route, ...]:
    x, y, z = moving("x y z")
    m, g = constants("m g")
    sphere = {"sphere": x * d(x) + y * d(y) + z * d(z)}
    return (newton("x y z", [(m, (x, y, z), (0, 0, -m * g))], kinematic=sphere),)


def line_in_disguise() -> tuple[Route, ...]:
    x, y = moving("x y")
    m, g = constants("m g")
    return (newton("x y", [(m, (x, y), (0, -m * g))], kinematic={"ray": y * d(x) - x * d(y)}),)


def integrable_together() -> tuple[Route, ...]:
    x, y, z = moving("x y z")
    m, g = constants("m g")
    return (newton("x y z", [(m, (x, y, z), (0, 0, -m * g))], kinematic={"slope": d(z) - y * d(x), "lane": d(y)}),)


def rack_and_arm() -> tuple[Route, ...]:
    y, phi = moving("y phi")
    big, m, radius, b, g = constants("M m R b g")
    kinetic = big * d(y) ** 2 / 2 + m * b**2 * d(phi) ** 2 / 2
    potential = -big * g * y - m * g * b * sin(phi)
    return (lagrange("y phi", kinetic, potential, kinematic={"thread": d(y) - radius * d(phi)}),)


def stretched_dumbbell() -> tuple[Route, ...]:
    x1, y1, x2, y2, s = moving("x1 y1 x2 y2 s")
    m, l = constants("m l")
    rod = {"rod": (x2 - x1) ** 2 + (y2 - y1) ** 2 - (l + s) ** 2}
    blade = {"blade": (d(x1) + d(x2)) * (y2 - y1) - (d(y1) + d(y2)) * (x2 - x1)}
    return (newton("x1 y1 x2 y2", [(m, (x1, y1), (0, 0)), (m, (x2, y2), (0, 0))], rod, blade),)


def dumbbell_with_blade_at_end() -> tuple[Route, ...]:
    x1, y1, x2, y2 = moving("x1 y1 x2 y2")
    m1, m2, l, force = constants("m1 m2 l F")
    rod = {"rod": (x2 - x1) ** 2 + (y2 - y1) ** 2 - l**2}
    blade = {"blade": d(x1) * (y2 - y1) - d(y1) * (x2 - x1)}
    return (newton("x1 y1 x2 y2", [(m1, (x1, y1), (0, 0)), (m2, (x2, y2), (force, 0))], rod, blade),)


def two_wheels() -> tuple[Route, ...]:
    x, y, theta, one, two = moving("x y theta phi1 phi2")
    m, mu, radius, b = constants("m mu R b")
    along = d(x) * cos(theta) + d(y) * sin(theta)
    constraints = {
        "side": d(x) * sin(theta) - d(y) * cos(theta),
        "roll1": along - b * d(theta) - radius * d(one),
        "roll2": along + b * d(theta) - radius * d(two),
    }
    kinetic = m * (speed2(x, y) + b**2 * d(theta) ** 2) + mu * radius**2 * (d(one) ** 2 + d(two) ** 2) / 2
    return (lagrange("x y theta phi1 phi2", kinetic, kinematic=constraints),)


def bicycle() -> tuple[Route, ...]:
    x, y, theta, delta = moving("x y theta delta")
    m1, m2, l, c, mu = constants("m1 m2 l c mu")
    front = (x + l * cos(theta), y + l * sin(theta))
    handle = (front[0] + c * cos(theta + delta), front[1] + c * sin(theta + delta))
    constraints = {
        "rear_wheel": d(x) * sin(theta) - d(y) * cos(theta),
        "front_wheel": d(front[0]) * sin(theta + delta) - d(front[1]) * cos(theta + delta),
    }
    points = [(m1, (x, y), (0, 0)), (m2, front, (0, 0)), (mu, handle, (0, 0))]
    return (newton("x y theta delta", points, kinematic=constraints),)


def hidden_by_a_plane() -> tuple[Route, ...]:
    x, y, z = moving("x y z")
    m, g, c = constants("m g c")
    track = {"track": d(x) + z * d(y) - c * y * d(y)}
    return (newton("x y z", [(m, (x, y, z), (0, -m * g, 0))], {"plane": z}, track),)


def conveyor() -> tuple[Route, ...]:
    x, y = moving("x y")
    m, c, e, v = constants("m c d v")
    return (newton("x y", [(m, (x, y), (0, 0))], kinematic={"belt": d(y) - c * d(x) - v * t + e}),)


RHEONOMIC = "holonomic rheonomic acatastatic"

SYSTEMS: dict[str, Textbook] = {
    "projectile_with_drag": Textbook(projectile_with_drag, HOLONOMIC, 3, 0),
    "charged_particle": Textbook(charged_particle, HOLONOMIC, 3, 0, ranges={"sigma": (-1, 1)}),
    "charged_pendulum": Textbook(charged_pendulum, HOLONOMIC, 2, 1),
    "kepler": Textbook(kepler, HOLONOMIC, 2, 0),
    "two_body": Textbook(two_body, HOLONOMIC, 4, 0),
    "central_force_in_space": Textbook(
        central_force_in_space, HOLONOMIC, 3, 0, functions={"f": ("r", "1/r**2 - 3*r + sin(r)")}
    ),
    "undefined_forces": Textbook(
        undefined_forces, HOLONOMIC, 2, 1,
        functions={"F_x": ("a b c", "b**2*a - sin(c)"), "F_y": ("a b", "a*b**2 + 1"), "F_z": ("a", "3*a - 7")},
    ),
    "foucault": Textbook(foucault, "holonomic rheonomic catastatic", 2, 0),
    "elastic_pendulum": Textbook(elastic_pendulum, HOLONOMIC, 2, 0),
    "spherical_pendulum": Textbook(spherical_pendulum, HOLONOMIC, 2, 0),
    "moved_support": Textbook(moved_support, "holonomic rheonomic catastatic", 1, 0),
    "kapitza": Textbook(kapitza, RHEONOMIC, 1, 1, ranges={"l": (3, 4)}),
    "driven_wire": Textbook(driven_wire, RHEONOMIC, 1, 1),
    "pendulum_between_planes": Textbook(pendulum_between_planes, RHEONOMIC, 1, 2),
    "lever": Textbook(lever, HOLONOMIC, 1, 0),
    "cycloid": Textbook(cycloid, HOLONOMIC, 1, 0),
    "cart_with_pendulum": Textbook(cart_with_pendulum, HOLONOMIC, 2, 1),
    "triple_pendulum": Textbook(triple_pendulum, HOLONOMIC, 3, 0),
    "chain_of_four": Textbook(chain_of_four, HOLONOMIC, 4, 4),
    "sphere": Textbook(charged_or_plain_sphere("sphere"), HOLONOMIC, 2, 1, ranges={"l": (2, 3)}),
    "sphere_with_moving_centre": Textbook(sphere_with_moving_centre, RHEONOMIC, 2, 1),
    "bead_on_parabola": Textbook(bead_on_parabola, HOLONOMIC, 1, 1),
    "bead_on_helix": Textbook(bead_on_helix, HOLONOMIC, 1, 2),
    "bead_on_helix_cartesian": Textbook(bead_on_helix_cartesian, HOLONOMIC, 1, 2),
    "rotating_hoop": Textbook(rotating_hoop, RHEONOMIC, 1, 2),
    "particle_in_cone": Textbook(particle_in_cone, HOLONOMIC, 2, 1),
    "cartesian_cone": Textbook(cartesian_cone, HOLONOMIC, 2, 1),
    "paraboloid": Textbook(paraboloid, HOLONOMIC, 2, 1),
    "torus": Textbook(torus, HOLONOMIC, 2, 1, ranges={"R": (2, 3), "a": (0.8, 1.5)}),
    "torus_with_angles": Textbook(torus_with_angles, HOLONOMIC, 2, 1),
    "moving_incline": Textbook(moving_incline, RHEONOMIC, 2, 1),
    "moving_surface": Textbook(moving_surface, RHEONOMIC, 2, 1, functions={"f": ("X Y Z", SURFACE)}),
    "growing_circle": Textbook(growing_circle, RHEONOMIC, 1, 1),
    "two_spheres": Textbook(two_spheres, HOLONOMIC, 1, 2, ranges={"R": (2, 2.5), "S": (2, 2.5), "z": (0.1, 0.6)}),
    "catenary": Textbook(catenary, HOLONOMIC, 1, 1),
    "knotted_space_curve": Textbook(knotted_space_curve, HOLONOMIC, 1, 2),
    "rod_twice": Textbook(rod_twice, HOLONOMIC, 1, 2, redundant=("again", "rate")),
    "atwood": Textbook(atwood, HOLONOMIC, 1, 1),
    "double_atwood": Textbook(double_atwood, HOLONOMIC, 2, 2),
    "block_on_wedge": Textbook(block_on_wedge, HOLONOMIC, 2, 1),
    "circles_with_common_point": Textbook(circles_with_common_point, HOLONOMIC, 1, 3),
    "four_bar": Textbook(four_bar, HOLONOMIC, 1, 3, ranges={"a": (1, 1.4), "b": (2, 2.5), "c": (2, 2.5), "d": (2, 2.5)}),
    "slider_crank": Textbook(slider_crank, HOLONOMIC, 1, 3, ranges={"a": (0.5, 1), "b": (2, 3)}),
    "trammel": Textbook(trammel, HOLONOMIC, 1, 1, ranges={"l": (2, 3)}),
    "swinging_atwood": Textbook(swinging_atwood, HOLONOMIC, 2, 1),
    "hole_in_table": Textbook(hole_in_table, HOLONOMIC, 2, 1),
    "three_on_a_ring": Textbook(three_on_a_ring, HOLONOMIC, 2, 1, ranges={"R": (1, 2), "a": (0.5, 1)}),
    "skate_with_masses": Textbook(skate_with_masses, NONHOLONOMIC, 2, 0, ("blade",)),
    "knife_edge": Textbook(knife_edge, NONHOLONOMIC, 2, 0, ("edge",)),
    "chaplygin_sleigh": Textbook(chaplygin_sleigh, NONHOLONOMIC, 2, 0, ("blade",)),
    "heisenberg": Textbook(heisenberg, NONHOLONOMIC, 2, 0, ("climb",)),
    "pars": Textbook(
        pars, NONHOLONOMIC, 2, 0, ("slope",),
        functions={"X": ("x y z", "x*y - z"), "Y": ("x y z", "z**2 + x"), "Z": ("x y z", "x - 2*y + sin(z)")},
    ),
    "pursuit": Textbook(pursuit, "nonholonomic rheonomic catastatic", 1, 0, ("aim",)),
    "turning_rail": Textbook(turning_rail, "nonholonomic rheonomic catastatic", 1, 0, ("blade",)),
    "drifting_skate": Textbook(drifting_skate, "nonholonomic scleronomic acatastatic", 2, 0, ("blade",)),
    "sphere_by_velocities": Textbook(sphere_by_velocities, HOLONOMIC, 2, 1),
    "line_in_disguise": Textbook(line_in_disguise, HOLONOMIC, 1, 1),
    "integrable_together": Textbook(integrable_together, HOLONOMIC, 1, 2, ("slope",)),
    "rack_and_arm": Textbook(rack_and_arm, HOLONOMIC, 1, 1),
    "stretched_dumbbell": Textbook(stretched_dumbbell, "nonholonomic rheonomic acatastatic", 2, 1, ("blade",)),
    "dumbbell_with_blade_at_end": Textbook(dumbbell_with_blade_at_end, NONHOLONOMIC, 2, 1, ("blade",)),
    "two_wheels": Textbook(two_wheels, NONHOLONOMIC, 2, 1, ("side", "roll1", "roll2")),
    "bicycle": Textbook(bicycle, NONHOLONOMIC, 2, 0, ("rear_wheel", "front_wheel")),
    "hidden_by_a_plane": Textbook(hidden_by_a_plane, HOLONOMIC, 1, 2),
    "conveyor": Textbook(conveyor, RHEONOMIC, 1, 1),
}  # fmt: skip
