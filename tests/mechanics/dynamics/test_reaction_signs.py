"""What the name of a reaction stands for: the force, whatever the constraint's equation looks like.

The truth is independent of the program: the force on a particle is m r'' − F, from Lagrange's equations with a
multiplier solved in numbers, and a tension pulls along the line from one end to the other.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from math import asin, tan

import pytest
import sympy as sp
from sympy.parsing.sympy_parser import parse_expr

from lagrange.core.diagnostics import Source
from lagrange.core.symbols import Sign
from lagrange.core.vectors import Vector
from lagrange.explain.report import report
from lagrange.mechanics.constraints.classification import classify
from lagrange.mechanics.constraints.constrained_system import Row
from lagrange.mechanics.constraints.kinematics import Configuration, file_configuration
from lagrange.mechanics.dynamics.newton import Newton, newton_equations
from lagrange.mechanics.dynamics.reaction_signs import ForceKind
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import load, read_problem
from lagrange.problem.model import Constraint, Friction, Problem
from lagrange.render import terminal
from lagrange.render.json import as_object
from tests.support.paths import PROBLEMS

Read = Callable[[str], Problem]


# -- forces on one particle in numbers ---------------------------------------------------------------------------------

x, y, v, w = sp.symbols("x y x' y'", real=True)
NUMBERS = {name: value for value, name in enumerate(["m", "g", "l", "a", "alpha"], start=1)}
NUMBERS["alpha"] = sp.Rational(1, 2)
NUMBERS["l"], NUMBERS["a"] = 5, 2


def force_on_particle(curve: sp.Expr, state: Mapping[sp.Symbol, float]) -> sp.Matrix:
    """m r'' − m g of a particle of mass 1 on a plane curve f(x, y) = 0 in the gravity −2j, at a state on the curve."""
    gradient = sp.Matrix([curve.diff(x), curve.diff(y)])
    bending = sp.Matrix([v, w]).T * sp.hessian(curve, (x, y)) * sp.Matrix([v, w])
    gravity = sp.Matrix([0, -2])
    left = sp.eye(2).row_join(-gradient).col_join(gradient.T.row_join(sp.zeros(1)))
    right = gravity.col_join(-bending)
    solution = left.subs(state).LUsolve(right.subs(state))
    return (solution[:2, :] - gravity).evalf()


def along(direction: Vector, size: sp.Expr, rule: Mapping[sp.Basic, object]) -> sp.Matrix:
    first, second, _ = (c.subs(rule) for c in direction.fixed().components)
    return (sp.Matrix([first, second]) * size.subs(rule)).evalf()


SLOPE = y + x * sp.tan(sp.Rational(1, 2))
PARABOLA = y - x**2 / 2
CIRCLE = x**2 + y**2 - 25
ON_SLOPE = {x: 2, y: -2 * sp.tan(sp.Rational(1, 2)), v: 3, w: -3 * sp.tan(sp.Rational(1, 2))}
ON_PARABOLA = {x: 1, y: sp.Rational(1, 2), v: 2, w: 2}
ON_CIRCLE = {x: 3, y: 4, v: 4, w: -3}


@pytest.mark.parametrize(
    ("equation", "curve", "state", "outward"),
    [
        ("y = -x*tan(alpha)", SLOPE, ON_SLOPE, (sp.sin(0.5), sp.cos(0.5))),
        ("x*sin(alpha) + y*cos(alpha) = 0", SLOPE, ON_SLOPE, (sp.sin(0.5), sp.cos(0.5))),
        ("m*y*cos(alpha)/3 = -m*x*sin(alpha)/3", SLOPE, ON_SLOPE, (sp.sin(0.5), sp.cos(0.5))),
        ("-x*tan(alpha) = y", SLOPE, ON_SLOPE, (-sp.sin(0.5), -sp.cos(0.5))),
        ("y = x^2/a", PARABOLA, ON_PARABOLA, (-1 / sp.sqrt(2), 1 / sp.sqrt(2))),
        ("a*y = x^2", PARABOLA, ON_PARABOLA, (-1 / sp.sqrt(2), 1 / sp.sqrt(2))),
        ("x^2 = a*y", PARABOLA, ON_PARABOLA, (1 / sp.sqrt(2), -1 / sp.sqrt(2))),
        ("x^2 + y^2 = l^2", CIRCLE, ON_CIRCLE, (-0.6, -0.8)),
        ("l^2 = x^2 + y^2", CIRCLE, ON_CIRCLE, (-0.6, -0.8)),
        ("norm(r_P) = l", CIRCLE, ON_CIRCLE, (-0.6, -0.8)),
        ("-m*dot(r_P, r_P) = -m*l^2", CIRCLE, ON_CIRCLE, (-0.6, -0.8)),
        ("x^2 + y^2 = l^2, by: surface", CIRCLE, ON_CIRCLE, (0.6, 0.8)),
        ("l = norm(r_P), by: surface", CIRCLE, ON_CIRCLE, (-0.6, -0.8)),
    ],
)
def test_the_force_on_a_particle(
    problem: Read, equation: str, curve: sp.Expr, state: Mapping[sp.Symbol, float], outward: tuple[float, float]
) -> None:
    """N n is m r'' − F, n the unit normal from the equation, or toward the other end of what keeps a distance."""
    text, _, by = equation.partition(", by: ")
    solution = solve(
        problem(
            "title: Example\nparameters: [m, g, l, a, alpha]\ncoordinates: [x, y]\n"
            "particles: {P: {mass: m, position: x*i + y*j}}\n"
            f"constraints: {{c: {{equation: '{text}', reaction: N{f', by: {by}' if by else ''}}}}}\ngravity: -g*j\n"
        )
    )
    numbers = {sp.Symbol(n, positive=True): value for n, value in NUMBERS.items()}
    rule = {**numbers, **state}
    assert solution.own.dynamics is not None
    reactions = solution.own.dynamics.reactions
    assert reactions is not None
    direction = along(reactions.units["c"], sp.S.One, rule)
    assert (direction - sp.Matrix(outward)).norm() < 1e-12
    found = along(reactions.units["c"], reactions.sizes["c"], rule)
    assert (found - force_on_particle(curve, state)).norm() < 1e-12
    assert solution.holds


# -- tensions of strings -----------------------------------------------------------------------------------------------

PULLEY = """title: Example
axes: {j: down}
parameters: [m1, m2, g, L]
coordinates: [a, b]
particles: {A: {mass: m1, position: a*j}, B: {mass: m2, position: b*j}}
gravity: g*j
"""


@pytest.mark.parametrize(
    ("constraint", "gravity", "tension"),
    [
        ("equation: a + b = L", "g*j", "2*m1*m2*g/(m1 + m2)"),
        ("equation: L = a + b", "g*j", "2*m1*m2*g/(m1 + m2)"),
        ("equation: 3*L - 3*a = 3*b", "g*j", "2*m1*m2*g/(m1 + m2)"),
        ("equation: a + b = L", "-g*j", "2*m1*m2*g/(m1 + m2)"),  # heights: the string pulls up all the same
        ("equation: a + 2*b = L, by: string", "g*j", "3*m1*m2*g/(4*m1 + m2)"),
        ("equation: L = 2*b + a, by: string", "g*j", "3*m1*m2*g/(4*m1 + m2)"),
        ("equation: L/2 - a/2 = b, by: string", "g*j", "3*m1*m2*g/(4*m1 + m2)"),
        ("equation: 2*b = -a, by: string", "g*j", "3*m1*m2*g/(4*m1 + m2)"),  # displacements
        ("equation: a' + 2*b' = 0, by: string", "g*j", "3*m1*m2*g/(4*m1 + m2)"),
        ("equation: 2*a + 2*b = L, by: string", "g*j", "m1*m2*g/(m1 + m2)"),  # four parts of one string
    ],
)
def test_the_tension_of_a_string_over_pulleys(problem: Read, constraint: str, gravity: str, tension: str) -> None:
    """m1 a'' = m1 g − T, m2 b'' = m2 g − n T, a'' = −n b''."""
    text = PULLEY.replace("gravity: g*j", f"gravity: {gravity}")
    found = as_object(report(problem(f"{text}constraints: {{s: {{{constraint}, reaction: T}}}}\n")))["reactions"]["s"]
    assert sp.simplify(sp.sympify(found["force"]) - sp.sympify(tension)) == 0
    assert found["tension"] == found["force"]


def test_a_string_that_unrolls(problem: Read) -> None:
    """A yo-yo: T = m g J/(J + m R²), upward, on whichever side of the equation the length is."""
    for equation in ("y = R*theta", "R*theta = y", "y' = R*theta'", "R*theta' = y'"):
        text = f"""title: Example
parameters: [m, J, R, g]
coordinates: [y, theta]
bodies: {{b: {{mass: m, inertia: J, position: y*j, angle: theta}}}}
constraints: {{thread: {{equation: {equation}, reaction: T, by: string}}}}
gravity: g*j
"""
        found = as_object(report(problem(text)))["reactions"]["thread"]
        assert (found["force"], found["direction"]) == ("m*g*J/(m*R^2 + J)", "-j")


# -- forces for a unit of the name: without solving anything -----------------------------------------------------------


def newton_of(problem: Problem, configuration: Configuration, constraints: Sequence[Constraint]) -> Newton:
    rough = frozenset(f.constraint for f in problem.forces if isinstance(f, Friction))
    return newton_equations(configuration, constraints, 0, frozenset(problem.scope.names()), rough=rough)


def kinematics(problem: Problem) -> Configuration:
    return file_configuration(problem, classify(problem).constrained)


def same(a: Vector | None, b: Vector | None, configuration: Configuration) -> bool:
    if a is None or b is None:
        return a is b
    return all(configuration.states.is_zero(c) is True for c in (a.fixed() - b.fixed()).components)


CORD = """title: Example
parameters: [m, J, a, g, h, c, l]
coordinates: [x, y, theta]
bodies: {rod: {mass: m, inertia: J, position: x*i + y*j, angle: theta}}
let: {end: r_rod + a*e1_rod, peg: c*i + h*j}
gravity: -g*j
"""


@pytest.mark.parametrize(
    "equation",
    [
        "3*l = 3*norm(end - peg)",
        "l^2 = dot(end - peg, end - peg)",
        "m*l^2/2 = m*((x + a*cos(theta) - c)^2 + (y + a*sin(theta) - h)^2)/2",
        "norm(end - peg) = l', by: 'string",
    ],
)
def test_a_cord_to_a_point_of_a_body_pulls_toward_its_other_end(problem: Read, equation: str) -> None:
    """On the rod T acts at its end, along the line to the peg, and turns it about the mass centre accordingly."""
    read = problem(f"{CORD}constraints: {{cord: {{equation: '{equation}', reaction: T}}}}\n")
    configuration = kinematics(read)
    [reaction] = newton_of(read, configuration, read.constraints).reactions
    names = read.scope.scalars
    x, y, theta, a, c, h, l = (names[n] for n in ("x", "y", "theta", "a", "c", "h", "l"))
    arm = Vector((a * sp.cos(theta), a * sp.sin(theta), sp.S.Zero))
    pull = (Vector((c - x, h - y, sp.S.Zero)) - arm) / l
    assert reaction.tension == sp.Symbol("T", real=True)
    assert same(reaction.per_unit("rod"), pull, configuration)
    assert same(reaction.moment_per_unit("rod"), arm.cross(pull), configuration)


def test_a_rod_between_points_of_two_bodies(problem: Read) -> None:
    read = problem(
        """title: Example
parameters: [m, J, a, b, l]
coordinates: [x, y, theta, u, v, phi]
bodies:
  A: {mass: m, inertia: J, position: x*i + y*j, angle: theta}
  B: {mass: m, inertia: J, position: u*i + v*j, angle: phi}
let: {d: r_A + a*e1_A - r_B - b*e2_B}
constraints: {rod: {equation: "l^2 = dot(d, d)", reaction: S}}
"""
    )
    configuration = kinematics(read)
    [reaction] = newton_of(read, configuration, read.constraints).reactions
    names = read.scope.scalars
    x, y, theta, u, v, phi, a, b, l = (names[n] for n in ("x", "y", "theta", "u", "v", "phi", "a", "b", "l"))
    end = (x + a * sp.cos(theta) - u + b * sp.sin(phi), y + a * sp.sin(theta) - v - b * sp.cos(phi))
    pull = Vector((-end[0] / l, -end[1] / l, sp.S.Zero))
    assert same(reaction.per_unit("A"), pull, configuration)
    assert same(reaction.per_unit("B"), -pull, configuration)


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("{equation: R1*a = -R2*b, reaction: F}", "has a moment"),
        ("{equation: R1*a = -R2*b, reaction: F, by: gear}", "has a moment"),
    ],
)
def test_a_moment_is_no_force(problem: Read, text: str, why: str) -> None:
    read = problem(
        "title: Example\nparameters: [J, R1, R2, M]\ncoordinates: [a, b]\n"
        "bodies: {A: {inertia: J, position: 0*i, angle: a}, B: {inertia: J, position: (R1 + R2)*i, angle: b}}\n"
        f"constraints: {{teeth: {text}}}\nforces: {{drive: {{on: A, moment: M*k}}}}\n"
    )
    found = report(read)
    [reaction] = found.solution.law.newton.reactions if found.solution.law else ()
    assert (reaction.single, reaction.multiplier.name) == (None, "F")
    assert "force" not in as_object(found)["reactions"]["teeth"]
    prose = " ".join(str(b.get("prose")) for s in as_object(found)["steps"] for b in s["body"])
    assert f"It {why} and is no single force: F is the multiplier." in prose


def test_a_curve_that_also_acts_elsewhere_is_no_single_force(problem: Read) -> None:
    """x + y + u = l on three particles: neither a string that is seen in the equation nor one force."""
    read = problem(
        "title: Example\nparameters: [m, l]\ncoordinates: [x, y, u]\nparticles: {A: {mass: m, position: x*i}, "
        "B: {mass: m, position: y*j}, C: {mass: m, position: u*k}}\n"
        "constraints: {c: {equation: x + 2*y - u = l, reaction: F}}\n"
    )
    configuration = kinematics(read)
    [reaction] = newton_of(read, configuration, read.constraints).reactions
    assert (reaction.single, reaction.force.name) == (None, "F")


# -- every shipped problem with a named reaction, written in other ways ------------------------------------------------

NAMED = sorted(
    str(path.relative_to(PROBLEMS).with_suffix(""))
    for path in PROBLEMS.glob("*/*.yaml")
    if "reaction:" in path.read_text()
)


WITHOUT_A_SINGLE_FORCE = {
    *("impacts/ball-on-a-wedge", "impacts/rod-falls-on-an-edge"),  # of the impact
    *("motion/four-bar-linkage", "motion/governor", "motion/planetary-gear"),  # between angles
    *("motion/skewed-disc", "motion/suslov-body"),  # moments
}
"""Shipped problems whose named reactions are multipliers."""


def rewritten(row: Row, lhs: sp.Expr, rhs: sp.Expr, configuration: Configuration) -> Row:
    """The row of another equation for the same constraint."""
    slots, f = configuration.slots, lhs - rhs
    variables = slots.coordinates if row.finite is not None else slots.velocities
    coefficients = tuple(f.diff(s) for s in variables)
    if row.finite is not None:
        return replace(row, coefficients=coefficients, drift=slots.frozen_derivative(f), finite=f)
    return replace(row, coefficients=coefficients, drift=f.xreplace(dict.fromkeys(slots.velocities, sp.S.Zero)))


@pytest.mark.parametrize("name", NAMED)
def test_two_ways_of_writing_a_constraint_give_one_force(name: str) -> None:
    """Multiplied by a positive factor, with squared lengths for lengths or the converse: the same force for N = 1.

    With the sides exchanged, or a negative factor, a tension is the same, and so is N of a one-sided constraint, whose
    normal points to the permitted side; another unit normal, and N with it, change their signs.
    """
    problem = load(PROBLEMS / f"{name}.yaml")
    configuration = kinematics(problem)
    before = newton_of(problem, configuration, problem.constraints)
    tried = 0
    for n, (c, reaction) in enumerate(zip(problem.constraints, before.reactions, strict=True)):
        if c.reaction == reaction.row.multiplier or reaction.single is None or reaction.row.nonlinear is not None:
            continue
        is_tension = reaction.single.kind is ForceKind.TENSION
        exchanged = 1 if is_tension or c.side is not None else -1
        if not any(reaction.per_unit(body) is not None for body in reaction.acts_on):
            assert is_tension  # of a string between points that coordinates do not place: its direction is not known
            tried += 1
            continue
        tried += 1
        other_ways = [(3 * c.lhs, 3 * c.rhs, 1), (c.rhs, c.lhs, exchanged), (-2 * c.lhs, -2 * c.rhs, exchanged)]
        if reaction.rod is not None:
            power = sp.Rational(1, 2) if c.rhs.is_Pow else sp.Integer(2)
            other_ways.append((c.lhs**power, c.rhs**power, 1))
        for lhs, rhs, sign in other_ways:
            rows = list(configuration.rows)
            rows[n] = rewritten(rows[n], lhs, rhs, configuration)
            other = replace(configuration, constrained=configuration.constrained.with_rows(rows))
            is_exchanged = lhs == c.rhs or lhs == -2 * c.lhs != 0 or rhs == -2 * c.rhs != 0
            side = -c.side if c.side is not None and is_exchanged else c.side
            constraints = [replace(d, lhs=lhs, rhs=rhs, side=side) if d is c else d for d in problem.constraints]
            after = newton_of(problem, other, constraints).reactions[n]
            assert after.force == reaction.force
            assert after.single is not None
            assert after.single.kind is reaction.single.kind
            for body in reaction.acts_on:
                # λ ∂f/∂r is N times the direction that belongs to N: otherwise the size of N is another one.
                by_multiplier = after.on(body)
                scaled = None if by_multiplier is None else by_multiplier * after.per_force
                opposite = body == reaction.single.opposite  # of a body that is held, λ has only the part that works
                if not opposite and not after.per_force.atoms(Sign):  # r² = l(t)²: σ is the sign of r, and varies
                    assert same(scaled, after.per_unit(body), configuration), (c.name, body)
                for one, two in (
                    (reaction.per_unit(body), after.per_unit(body)),
                    (reaction.moment_per_unit(body), after.moment_per_unit(body)),
                ):
                    assert same(one, None if two is None else two * sp.Integer(sign), configuration), (c.name, body)
    assert bool(tried) is (name not in WITHOUT_A_SINGLE_FORCE)


# -- what keeps two points apart on a line; strings counted from what moves ---------------------------------------------

NUMBERS_OF_WAGONS = {"m": 2, "M": 3, "F": 10, "d": 4}
WAGONS = """title: Two wagons
parameters: [m, M, F, d]
coordinates: [x, y]
particles: {front: {mass: m, position: x*i}, rear: {mass: M, position: y*i + h*j}}
constraints: {coupling: {equation: "%s", reaction: T, by: rod}}
forces: {pull: {on: front, vector: F*i}}
let: {h: "%s"}
"""


@pytest.mark.parametrize("equation", ["x - y = d", "y = x - d", "2*(y - x) + 2*d = 0", "d = x - y"])
@pytest.mark.parametrize("height", ["0", "d"])
def test_a_bar_between_two_points_of_a_line_pulls(problem: Read, equation: str, height: str) -> None:
    """The rear wagon of mass M is pulled with M a."""
    reactions = as_object(report(problem(WAGONS % (equation, height))))["reactions"]
    tension = sp.Rational(3 * 10, 2 + 3) * (sp.sqrt(2) if height == "d" else 1)  # an oblique bar is pulled along itself
    force = parse_expr(reactions["coupling"]["force"], {n: sp.Integer(v) for n, v in NUMBERS_OF_WAGONS.items()})
    assert sp.simplify(force - tension) == 0


ATWOOD = """title: Three weights on two pulleys
axes: {j: down}
parameters: {m_1: {value: 4}, m_2: {value: 3}, m_3: {value: 2}, g: {value: 10}, L: positive, l: positive}
coordinates: [x, p, y, z]
gravity: g*j
"""
FROM_THE_PULLEY = """particles:
  A: {mass: m_1, position: x*j}
  P: {position: p*j}
  B: {mass: m_2, position: (p + y)*j}
  C: {mass: m_3, position: (p + z)*j}
constraints: {upper: {equation: L = x + p, reaction: T_1}, lower: {equation: y + z = l, reaction: T_2}}
"""
FROM_ABOVE = """particles: {A: {mass: m_1, position: x*j}, B: {mass: m_2, position: y*j}, C: {mass: m_3, position: z*j}}
constraints:
  upper: {equation: %s, reaction: T_1}
  lower: {equation: %s, reaction: T_2}
"""


@pytest.mark.parametrize(
    "weights",
    [
        FROM_THE_PULLEY,
        FROM_ABOVE % ("x + p = L", "(y - p) + (z - p) = l"),  # p moves no particle: a pulley without mass
        FROM_ABOVE % ("L = x + p", "l/2 = y/2 + z/2 - p"),
    ],
)
def test_tensions_of_a_double_atwood_machine(problem: Read, weights: str) -> None:
    """m a = T − m g for each weight by hand: T_1 = 2 T_2 = 8 m_1 m_2 m_3 g/(4 m_2 m_3 + m_1 (m_2 + m_3))."""
    found = as_object(report(problem(ATWOOD + weights)))
    expected = 8 * 4 * 3 * 2 * 10 / (4 * 3 * 2 + 4 * 5)
    assert found["reactions"]["upper"]["number"] == pytest.approx(expected)
    assert found["reactions"]["lower"]["number"] == pytest.approx(expected / 2)
    assert all(c["passed"] for c in found["checks"])


@pytest.mark.parametrize(
    "cable",
    ["norm(r_B - h*j) = c", "c = norm(r_B - h*j)", "norm(r_B - h*j) <= c", "2*norm(h*j - r_B) = 2*c"],
)
def test_a_boom_held_by_a_cable(problem: Read, cable: str) -> None:
    """Moments about the foot, with the lever arm h l cos θ/c of the cable: T = (W + G/2) c/h."""
    text = f"""title: A boom
parameters: {{W: positive, G: positive, l: positive, h: positive, c: positive}}
coordinates: {{theta: {{range: [-90 deg, 90 deg]}}}}
let: {{e: "cos(theta)*i + sin(theta)*j"}}
particles: {{B: {{position: l*e}}}}
bodies: {{boom: {{position: l/2*e, angle: theta}}}}
constraints: {{cable: {{equation: "{cable}", reaction: T}}}}
forces: {{load: {{on: B, vector: -W*j}}, own: {{on: boom, vector: -G*j}}}}
find: [equilibrium]
"""
    found = report(problem(text))
    force = parse_expr(as_object(found)["reactions"]["cable"]["force"])
    W, G, h, c = sp.symbols("W G h c")
    assert sp.simplify(force - (W + G / 2) * c / h) == 0
    page = terminal.text(found.derivation, found.notation, 100)
    factor = {"n": "tension T = −λ", "c": "tension T", "2": "tension T = −2λ"}[cable[0]]
    assert f"{factor}, positive" in " ".join(page.split())
    assert "(h l T cos θ/" in page  # the work of the reaction in δθ, positive for T > 0
    assert "−(h l T cos θ/" not in page


@pytest.mark.parametrize("name", ["cord", "cords", "threads", "cord_A", "rope_2"])
def test_what_is_called_a_string_pulls_also_where_it_is_wound_up(problem: Read, name: str) -> None:
    """A cylinder that unwinds from threads: T = m g/3, upward."""
    found = as_object(
        report(
            problem(f"""
title: Cylinder on two threads
axes: {{j: up}}
parameters: [m, g, R]
coordinates: [y, theta]
bodies: {{cylinder: {{mass: m, inertia: m*R^2/2, position: -y*j, angle: theta}}}}
constraints: {{{name}: {{equation: y = R*theta, reaction: T}}}}
gravity: -g*j
ask: {{T: {{quantity: T}}}}
""")
        )
    )
    assert found["asked"][0]["value"] == "m*g/3"


FRAME = """
title: Two rods that stand on a smooth floor, their feet tied
parameters: {W: positive, l: positive, c: positive}
coordinates: {theta: {range: [0, pi/2]}}
bodies:
  left: {mass: 0, inertia: 0, position: -l/2*sin(theta)*i + l/2*cos(theta)*j, angle: -theta}
  right: {mass: 0, inertia: 0, position: l/2*sin(theta)*i + l/2*cos(theta)*j, angle: theta}
particles:
  A: {mass: 0, position: -l*sin(theta)*i}
  B: {mass: 0, position: l*sin(theta)*i}
constraints:
  tie: {equation: "EQUATION", reaction: T, by: string}
forces:
  w1: {on: left, vector: -W*j}
  w2: {on: right, vector: -W*j}
find: equilibrium
"""


@pytest.mark.parametrize(
    "equation",
    ["norm(r_B - r_A) = c", "c = norm(r_B - r_A)", "norm(r_B - r_A) <= c", "2*l*sin(theta) = c",
     "dot(r_B - r_A, r_B - r_A) = c^2", "c^2 >= 4*l^2*sin(theta)^2"],
)  # fmt: skip
def test_a_length_between_points_that_the_coordinates_do_not_place(equation: str) -> None:
    """By moments about the hinge at the top, with the floor's force W on each foot: T = (W/2) tan θ, a pull."""
    text = FRAME.replace("EQUATION", equation)
    written = as_object(report(read_problem(Source("frame.yaml", text))))
    tension = parse_expr(written["reactions"]["tie"]["force"].replace("^", "**"))
    sizes = {"c": 1.1, "W": 3, "l": 2}
    assert float(tension.subs(sizes)) == pytest.approx(3 / 2 * tan(asin(1.1 / 4)))


BOOM = """
title: A boom without weight, its end held
parameters: {W: positive, l: positive, c: positive}
coordinates: {theta: {range: [0, pi/2]}}
particles:
  B: {mass: 0, position: l*sin(theta)*i + l*cos(theta)*j}
  A: {mass: 0, position: l*j}
constraints:
  keeper: {EQUATION, reaction: T}
forces: {load: {on: B, vector: -W*j}}
find: equilibrium
"""


@pytest.mark.parametrize(
    ("equation", "force"),
    [
        ("equation: norm(r_B - l*j) = c, by: string", "W*c/l"),  # about O: W l sin(theta) = T l cos(theta/2)
        ("equation: c >= norm(r_B - l*j)", "W*c/l"),
        ("equation: norm(r_B - l*j) = c", "W*c/l"),
        ("equation: 3*norm(r_B - r_A) = 3*c", "W*c/l"),
        ("equation: 2*l*sin(theta/2) = c, by: string", "W*c/l"),
        ("equation: 'dot(r_B - l*j, r_B - l*j) = c^2', by: rod", "W*c/l"),
        ("equation: norm(r_B - 2*l*j) = c", "W*c/(2*l)"),  # area of the triangle with sides l, 2 l, c: T = W c/(2 l)
        ("equation: norm(r_B - l*j) + norm(r_B) = c, by: string", "W*(c - l)/l"),
        ("equation: l*sin(theta) = c", "-W*c/sqrt(l^2 - c^2)"),  # a horizontal force: W l sin(theta) = -T l cos(theta)
    ],
)
def test_a_body_that_a_coordinate_leads_along_a_curve(equation: str, force: str) -> None:
    """The part along the curve is all that enters, and no tension: of a rope it is T times a cosine."""
    text = BOOM.replace("EQUATION", equation)
    written = as_object(report(read_problem(Source("boom.yaml", text))))["reactions"]["keeper"]
    [there] = written["at_equilibrium"][:1]
    found = parse_expr((there.get("force") or there["multiplier"]).replace("^", "**"))
    sizes = {"c": 3.1 if "+" in equation else 1.1, "W": 3, "l": 2}
    assert float(found.subs(sizes)) == pytest.approx(float(parse_expr(force.replace("^", "**")).subs(sizes)))
    made = report(read_problem(Source("boom.yaml", text)))
    page = " ".join(terminal.text(made.derivation, made.notation, 100).split())
    is_partial = "direction" not in written
    assert ("only the part along the path that the coordinates leave to B enters" in page) is is_partial
    assert ("B from moving along sin θ 𝐢 + cos θ 𝐣 is W" in page) is not is_partial  # the boom takes a part of the pull
    assert written.get("direction") in (None, "-l*sin(theta)*i/c + c*j/(2*l)")  # from B to A, if that is seen


HUNG_BAR = """
title: Bar that hangs by one end from a string and rests with the other
parameters: [m, g, l]
coordinates: [y, theta]
bodies: {bar: {mass: m, inertia: m*l^2/12, position: y*j, angle: theta}}
constraints:
  left: {equation: EQUATION, by: string, reaction: T}
  right: {equation: y + l/2*sin(theta) = 0, reaction: N}
gravity: -g*j
find: equilibrium
"""


@pytest.mark.parametrize("equation", ["y - l/2*sin(theta) = 0", "l/2*sin(theta) = y", "3*y = 3*l/2*sin(theta)"])
def test_a_string_without_a_length_pulls_against_the_weight(equation: str) -> None:
    """T = N = ½ m g at either end, on whichever side the height stands."""
    written = as_object(report(read_problem(Source("bar.yaml", HUNG_BAR.replace("EQUATION", equation)))))["reactions"]
    assert written["left"]["at_equilibrium"][0]["force"] == "m*g/2"


COLLAR = """
title: A collar on a straight guide, tied to a point beside it
parameters: {P: positive, h: positive, c: positive}
coordinates: {x: {range: [0, c]}}
particles: {B: {mass: 0, position: x*i}}
constraints: {tie: {EQUATION, reaction: T}}
forces: {pull: {on: B, vector: P*i}}
find: equilibrium
"""


@pytest.mark.parametrize(
    "equation",
    ["equation: norm(r_B - h*j) = c, by: string", "equation: norm(r_B - h*j) <= c", "equation: c = sqrt(x^2 + h^2)",
     "equation: 'dot(r_B - h*j, r_B - h*j) = c^2'", "equation: x^2 + h^2 = c^2, by: rod", "equation: norm(r_B - h*k) = c"],
)  # fmt: skip
def test_a_tie_beside_a_straight_guide(equation: str) -> None:
    """Along the guide: P = T x/c, x² = c² − h²; not T = P, as if the tie went along the guide."""
    written = as_object(report(read_problem(Source("collar.yaml", COLLAR.replace("EQUATION", equation)))))
    tension = parse_expr(written["reactions"]["tie"]["at_equilibrium"][0]["force"].replace("^", "**"))
    sizes = {"c": 1.1, "P": 2.2, "h": 0.7}
    assert float(tension.subs(sizes)) == pytest.approx(2.2 * 1.1 / (1.21 - 0.49) ** 0.5)


def test_a_string_at_the_end_of_a_body_placed_by_three_coordinates() -> None:
    """A ladder on smooth floor and wall: T = (W/2) tan θ, a pull, though x + (l/2) sin θ is no length by itself."""
    text = """
title: Ladder
parameters: {W: positive, l: positive, c: positive}
coordinates: {x: , y: , theta: {range: [0, pi/2]}}
bodies: {L: {mass: 0, inertia: 0, position: x*i + y*j, angle: -theta}}
constraints:
  wall: {equation: "x - l/2*sin(theta) >= 0", reaction: A}
  floor: {equation: "y - l/2*cos(theta) >= 0", reaction: B}
  rope: {equation: x + l/2*sin(theta) = c, reaction: T, by: string}
forces: {w: {on: L, vector: -W*j}}
find: equilibrium
"""
    reactions = as_object(report(read_problem(Source("ladder.yaml", text))))["reactions"]
    sizes = {"c": 1.1, "W": 3, "l": 2}
    found = [float(parse_expr(reactions[n]["force"].replace("^", "**")).subs(sizes)) for n in ("wall", "floor", "rope")]
    thrust = 3 / 2 * tan(asin(1.1 / 2))
    assert found == pytest.approx([thrust, 3, thrust])


BEAD = """
title: A bead on a parabola, stopped by a wall
parameters: {W: positive, P: positive, a: positive, c: positive}
coordinates: [COORDINATES]
particles: {B: {mass: 0, position: PLACE}}
constraints: {CURVE wall: {equation: EQUATION, reaction: S}}
forces: {weight: {on: B, vector: -W*j}, pull: {on: B, vector: P*i}}
find: equilibrium
"""


@pytest.mark.parametrize(
    ("coordinates", "place", "curve"),
    [("x", "x*i + x^2/a*j", ""), ("x, y", "x*i + y*j", "curve: {equation: a*y = x^2, reaction: N},")],
)
@pytest.mark.parametrize("equation", ["x <= c", "c >= x", "2*x <= 2*c"])
def test_a_wall_on_a_curve(coordinates: str, place: str, curve: str, equation: str) -> None:
    """The force of the curve is (−2c/a, 1) W, so that the wall has to push with S = P − 2 W c/a, and not away from O."""
    text = BEAD.replace("COORDINATES", coordinates).replace("PLACE", place).replace("CURVE", curve)
    made = report(read_problem(Source("bead.yaml", text.replace("EQUATION", equation))))
    reactions = as_object(made)["reactions"]
    sizes = {"W": 1.3, "P": 2.2, "a": 1.5, "c": 0.7}
    times = 2 if equation.startswith("2") and not curve else 1
    [wall] = reactions["wall"]["at_equilibrium"]
    push = float(parse_expr(wall.get("force") or wall["multiplier"]).subs(sizes))
    assert push * times == pytest.approx(2.2 - 2 * 1.3 * 0.7 / 1.5)
    if curve:
        normal = reactions["curve"]["at_equilibrium"][0]["force"].replace("^", "**")
        assert abs(float(parse_expr(normal).subs(sizes))) == pytest.approx(1.3 * (1 + (1.4 / 1.5) ** 2) ** 0.5)
    page = " ".join(terminal.text(made.derivation, made.notation, 100).split())
    assert "at the distance" not in page


# -- ends that the coordinates guide -----------------------------------------------------------------------------------

SLIDER_CRANK = """
title: Slider-crank
parameters: [r, l, F]
unknowns: [M]
coordinates: [phi, x]
bodies: {crank: {position: 0*i, angle: phi}}
particles: {piston: {position: x*i}}
constraints: {link: {equation: EQUATION, reaction: S}}
forces: {push: {on: piston, vector: -F*i}, turn: {on: crank, moment: M*k}}
find: equilibrium
"""


@pytest.mark.parametrize(
    "equation",
    [
        "(x - r*cos(phi))^2 + (r*sin(phi))^2 = l^2",
        "l^2 = (x - r*cos(phi))^2 + (r*sin(phi))^2",
        "3*x^2 - 6*r*x*cos(phi) + 3*r^2 = 3*l^2",
    ],
)
def test_tension_of_a_link_between_a_slider_and_a_crank(problem: Read, equation: str) -> None:
    """F + S (x − r cos φ)/l = 0 on the piston, whose guide takes the force across."""
    read = problem(SLIDER_CRANK.replace("EQUATION", equation))
    configuration = kinematics(read)
    [reaction] = newton_of(read, configuration, read.constraints).reactions
    phi, x, r, l = (read.scope.scalars[n] for n in ("phi", "x", "r", "l"))
    assert reaction.single is not None
    assert reaction.single.kind is ForceKind.TENSION
    assert configuration.states.is_zero(
        reaction.row.coefficients[1] - reaction.single.factor * -(x - r * sp.cos(phi)) / l
    )


SYMMETRIC = """
title: Two charges on a rail, kept apart by a string between them
coordinates: [x]
parameters: [m, r, K]
particles: {A: {mass: m, position: x*i}, B: {mass: m, position: -x*i}}
constraints: {string: {equation: EQUATION, reaction: T, by: string}}
forces: {repulsion: {potential: K/(2*x)}}
find: equilibrium
"""


@pytest.mark.parametrize("equation", ["2*x <= 2*r", "x = r", "3*r = 3*x", "x^2 = r^2", "4*x^2 = 4*r^2"])
def test_a_string_between_two_particles_that_share_a_coordinate(problem: Read, equation: str) -> None:
    """Each pulls with K/(2r)²: λ ∂f/∂x = −2T."""
    read = problem(SYMMETRIC.replace("EQUATION", equation))
    configuration = kinematics(read)
    [reaction] = newton_of(read, configuration, read.constraints).reactions
    assert reaction.single is not None
    # Squared, as x² = r² admits x = −r, where the tension is the same.
    assert configuration.states.is_zero(reaction.row.coefficients[0] ** 2 - 4 * reaction.single.factor**2)


TAPE = """
title: Cylinder that slides down while a tape unwinds, kept as a condition on velocities of its points
coordinates: [x, y, theta]
parameters: [m, R, g, mu]
bodies: {cyl: {mass: m, inertia: m*R^2/2, position: x*i + y*j, angle: theta}}
constraints:
  incline: {equation: y >= R, reaction: N}
  tape: {equation: "dot(r_cyl' + cross(omega_cyl, R*j), i) = 0", reaction: T, by: string}
gravity: 3*g/5*i - 4*g/5*j
forces: {rub: {friction: mu, constraint: incline, on: cyl, at: r_cyl - R*j, slip: i}}
ask: {a: {quantity: "x''", when: t = 0}, tension: {quantity: T, when: t = 0}}
"""


def test_a_string_kept_by_velocities_alone(problem: Read) -> None:
    """Newton along the incline and moments about the axis: |T| = m g (sin α + μ cos α)/3, and the rest accelerates."""
    read = problem(TAPE)
    a, tension = (q.branches[0].rhs for q in solve(read).asked)
    numbers = {read.scope.scalars[n]: v for n, v in {"m": 8, "R": 1, "g": 10, "mu": sp.Rational(1, 5)}.items()}
    force = sp.Rational(8 * (6 + 8 / sp.Integer(5)), 3)
    assert abs(tension.xreplace(numbers)) == force
    assert a.xreplace(numbers) == 6 - sp.Rational(8, 5) - force / 8
