"""Coulomb friction: known formulas, Newton's equations solved by hand at numbers, what is refused."""

from __future__ import annotations

from collections.abc import Callable

import pytest
import sympy as sp

from lagrange.answers.equations import Verdict, check_equations
from lagrange.answers.questions.own_answers import compared_answers
from lagrange.answers.references import reference_of_solution
from lagrange.core.diagnostics import Fragment, NotCoveredError, ProblemError
from lagrange.core.symbols import Sign
from lagrange.explain.report import report
from lagrange.mechanics.results import Solution
from lagrange.mechanics.solution import solve
from lagrange.problem.model import Problem
from lagrange.render import terminal
from lagsolve.exit_statuses import status_of_error

Read = Callable[[str], Problem]

INCLINE = """parameters: [m, g, alpha, mu]
coordinates: [x, y]
let: {{down: "cos(alpha)*i - sin(alpha)*j", away: "sin(alpha)*i + cos(alpha)*j"}}
particles: {{block: {{mass: m, position: x*down + y*away}}}}
constraints: {{plane: {{equation: y = 0, reaction: N}}}}
gravity: -g*j
forces: {{rub: {{friction: mu, constraint: plane, on: block{more}}}}}
"""


def solution(problem: Read, text: str) -> Solution:
    found = solve(problem(f"title: Example\n{text}"))
    assert [(c.name, c.choice) for c in found.checks if c.passed is not True] == []
    return found


def verdict(found: Solution, *equations: str) -> Verdict:
    return check_equations([Fragment.of(e) for e in equations], reference_of_solution(found)).verdict


# -- known formulas ----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("more", "right", "wrong"),
    [
        (", slip: positive, contact: positive", "x'' = g*sin(alpha) - mu*g*cos(alpha)", "x'' = g*sin(alpha) + mu*g*cos(alpha)"),
        (", slip: negative, contact: positive", "x'' = g*sin(alpha) + mu*g*cos(alpha)", "x'' = g*sin(alpha) - mu*g*cos(alpha)"),
        (", contact: positive", "x'' = g*sin(alpha) - mu*g*cos(alpha)*sign(x')", "x'' = g*sin(alpha) - mu*g*cos(alpha)"),
        (", slip: positive", "x'' = g*sin(alpha) - mu*g*abs(cos(alpha))", "x'' = g*sin(alpha) - mu*g*cos(alpha)"),
        ("", "x'' = g*sin(alpha) - mu*g*abs(cos(alpha))*sign(x')", "x'' = g*sin(alpha) - mu*g*cos(alpha)*sign(x')"),
    ],
    ids=["down", "up", "contact only", "slip only", "open"],
)  # fmt: skip
def test_block_on_an_incline(problem: Read, more: str, right: str, wrong: str) -> None:
    found = solution(problem, INCLINE.format(more=more))
    assert verdict(found, right) is Verdict.EQUIVALENT
    assert verdict(found, wrong) is Verdict.WRONG
    assert verdict(found, "x'' = g*sin(alpha)") is Verdict.WRONG


def test_an_answer_with_the_magnitude_of_the_reaction(problem: Read) -> None:
    found = solution(problem, INCLINE.format(more=""))
    assert verdict(found, "m*x'' = m*g*sin(alpha) - mu*abs(N)*sign(x')") is Verdict.EQUIVALENT
    assert verdict(found, "m*x'' = m*g*sin(alpha) - 2*mu*abs(N)*sign(x')") is Verdict.WRONG


@pytest.mark.parametrize(
    ("text", "equations"),
    [
        (  # the same incline in horizontal and vertical coordinates
            "parameters: [m, g, alpha, mu]\ncoordinates: [x, y]\nparticles: {P: {mass: m, position: '[x, y]'}}\n"
            "constraints: {plane: y*cos(alpha) + x*sin(alpha) = 0}\ngravity: '[0, -g]'\n"
            "forces: {rub: {friction: mu, constraint: plane, on: P}}\n"
            "generalized_coordinates: {down: {coordinates: [s], substitute: {x: s*cos(alpha), y: -s*sin(alpha)}}}\n",
            ["s'' = g*sin(alpha) - mu*g*abs(cos(alpha))*sign(s')"],
        ),
        (  # a belt
            "parameters: [m, g, c, mu, V]\ncoordinates: [x, y]\nparticles: {P: {mass: m, position: '[x, y]'}}\n"
            "constraints: {belt: y = 0}\ngravity: '[0, -g]'\nforces:\n  pull: {on: P, vector: '[-c*x, 0]'}\n"
            "  rub: {friction: mu, constraint: belt, on: P, surface_velocity: '[V, 0]'}\n",
            ["m*x'' = -c*x - mu*m*g*sign(x' - V)"],
        ),
        (  # a floor that rises
            "parameters: [m, g, mu]\nfunctions: {u: [t]}\ncoordinates: [x, y]\n"
            "particles: {P: {mass: m, position: '[x, y]'}}\nconstraints: {floor: y = u}\ngravity: '[0, -g]'\n"
            "forces: {rub: {friction: mu, constraint: floor, on: P}}\n",
            ["x'' = -mu*abs(g + u'')*sign(x')"],
        ),
        (  # a puck on a table
            "parameters: [m, g, mu]\ncoordinates: [x, y, z]\nparticles: {P: {mass: m, position: '[x, y, z]'}}\n"
            "constraints: {table: z = 0}\ngravity: '[0, 0, -g]'\nforces: {rub: {friction: mu, constraint: table, on: P}}\n"
            "generalized_coordinates: {polar: {coordinates: [r, phi], substitute: {x: r*cos(phi), y: r*sin(phi), z: 0}}}\n",
            ["r'' - r*phi'^2 = -mu*g*r'/sqrt(r'^2 + r^2*phi'^2)", "r*phi'' + 2*r'*phi' = -mu*g*r*phi'/sqrt(r'^2 + r^2*phi'^2)"],
        ),
        (  # a rough hoop in a vertical plane
            "parameters: [m, g, R, mu]\ncoordinates: [x, y]\nparticles: {P: {mass: m, position: '[x, y]'}}\n"
            "constraints: {hoop: x^2 + y^2 = R^2}\ngravity: '[0, g]'\n"
            "forces: {rub: {friction: mu, constraint: hoop, on: P}}\n"
            "generalized_coordinates: {angle: {coordinates: [theta], substitute: {x: R*sin(theta), y: R*cos(theta)}}}\n",
            ["R*theta'' = -g*sin(theta) - mu*abs(g*cos(theta) + R*theta'^2)*sign(theta')"],
        ),
    ],
    ids=["incline", "belt", "rising floor", "puck", "hoop"],
)  # fmt: skip
def test_known_equations(problem: Read, text: str, equations: list[str]) -> None:
    found = solution(problem, text)
    assert verdict(found, *equations) is Verdict.EQUIVALENT
    backwards = [e.replace("mu", "(-mu)") for e in equations]
    assert verdict(found, *backwards) is Verdict.WRONG


# -- by hand, at numbers -----------------------------------------------------------------------------------------------

WEDGE = """parameters: [M, m, alpha, g, mu]
coordinates: [X, Y, x, y]
particles: {wedge: {mass: M, position: "[X, Y]"}, block: {mass: m, position: "[x, y]"}}
constraints: {floor: Y = 0, face: y - Y = (x - X)*tan(alpha)}
gravity: "[0, -g]"
forces:
  rub: {friction: mu, constraint: face, on: block, surface_velocity: r_wedge'}
  back: {friction: mu, constraint: face, on: wedge, surface_velocity: r_block'}
"""


@pytest.mark.parametrize("downhill", [True, False])
def test_a_reaction_that_depends_on_its_own_friction(problem: Read, downhill: bool) -> None:
    """Block on a rough wedge that moves: five equations for X'', x'', y'', N, F, written from the free bodies."""
    found = solution(problem, WEDGE)
    [(sign, value)] = found.own.dynamics.signs.items()
    assert isinstance(sign, Sign)
    big, small, alpha, g, mu = 4, 3, sp.Rational(3, 5), sp.Rational(49, 5), sp.Rational(1, 4)
    ax_wedge, ax, ay, normal, along = sp.symbols("A a b N F")
    sense = 1 if downhill else -1  # friction on the block points up the face while it slides down
    cos, sin = sp.cos(alpha), sp.sin(alpha)
    by_hand = sp.solve(
        [
            small * ax - (-normal * sin + along * cos),
            small * ay - (normal * cos + along * sin - small * g),
            big * ax_wedge - (normal * sin - along * cos),
            along - sense * mu * normal,
            ay * cos - (ax - ax_wedge) * sin,
        ],
        [ax_wedge, ax, ay, normal, along],
        dict=True,
    )[0]
    names = {
        "M": big,
        "m": small,
        "alpha": alpha,
        "g": g,
        "mu": mu,
        "X'": 0,
        "x'": -sense,
        "Y'": 0,
        "y'": 0,
        sign.name: 1,
    }
    wanted = {"X": ax_wedge, "x": ax, "y": ay}

    def number(e: sp.Expr) -> sp.Expr:
        return e.xreplace({s: sp.Integer(0) + names[s.name] for s in e.free_symbols}).evalf(30)

    accelerations = {s.name.rstrip("'"): v for s, v in found.own.dynamics.reactions.accelerations.items()}
    for name, unknown in wanted.items():
        assert abs(number(accelerations[name]) - by_hand[unknown].evalf(30)) < 1e-25
    assert abs(number(value) / cos - by_hand[normal].evalf(30)) < 1e-25  # N = λ |∂f/∂r| = λ/cos α
    assert number(value) > 0  # the sign is the one that was put in


def test_a_sphere_in_space_by_hand(problem: Read) -> None:
    """m r'' = −m g k + N n − μ |N| v/|v| at one state, N from n·r'' = −v²/R."""
    found = solution(
        problem,
        "parameters: [m, g, R, mu]\ncoordinates: [x, y, z]\nparticles: {P: {mass: m, position: '[x, y, z]'}}\n"
        "constraints: {ball: x^2 + y^2 + z^2 = R^2}\ngravity: '[0, 0, -g]'\n"
        "forces: {rub: {friction: mu, constraint: ball, on: P}}\n",
    )
    r, v, radius, mass, g, mu = sp.Matrix([2, 3, 6]), sp.Matrix([3, -2, 0]), 7, 2, 10, sp.Rational(1, 3)
    n = r / radius
    normal = mass * (g * n[2] - v.dot(v) / radius)
    wanted = sp.Matrix([0, 0, -g]) + normal / mass * n - mu * abs(normal) / mass * v / v.norm()
    values = dict(
        zip(("x", "y", "z", "x'", "y'", "z'", "R", "m", "g", "mu"), (*r, *v, radius, mass, g, mu), strict=True)
    )
    for expected, value in zip(wanted, found.own.dynamics.reactions.accelerations.values(), strict=True):
        here = value.xreplace({s: sp.sympify(values[s.name]) for s in value.free_symbols})
        assert abs((here - expected).evalf(30)) < 1e-25


def test_a_curve_in_space_by_hand(problem: Read) -> None:
    """m r'' = −m g k + R − μ |R| v/|v|, R being the part of m r'' + m g k across the curve (x, x², x³)."""
    found = solution(
        problem,
        "parameters: [m, g, mu]\ncoordinates: [x, y, z]\nparticles: {P: {mass: m, position: '[x, y, z]'}}\n"
        "constraints: {wall: y = x^2, floor: z = x*y}\ngravity: '[0, 0, -g]'\n"
        "forces: {rub: {friction: mu, constraint: [wall, floor], on: P}}\n"
        "generalized_coordinates: {one: {coordinates: [x]}}\n",
    )
    x, rate, mass, g, mu = sp.Rational(1, 2), sp.Rational(-3, 4), 2, 10, sp.Rational(1, 3)
    along, bend = sp.Matrix([1, 2 * x, 3 * x**2]), sp.Matrix([0, 2, 6 * x]) * rate**2
    square = along.dot(along)
    load = bend + sp.Matrix([0, 0, g])
    across = load - along * load.dot(along) / square
    expected = -load.dot(along) / square - mu * across.norm() * sp.sign(rate) / sp.sqrt(square)
    values = {"x": x, "y": x**2, "z": x**3, "m": mass, "g": g, "mu": mu}
    values |= {"x'": rate, "y'": 2 * x * rate, "z'": 3 * x**2 * rate}
    [equation] = found.choices[0].dynamics.equations.expressions
    values["x''"] = expected
    here = equation.xreplace({s: sp.sympify(values[s.name]) for s in equation.free_symbols})
    assert abs(here.evalf(30)) < 1e-25


def test_friction_does_virtual_work(problem: Read) -> None:
    """The generalized force of x: m g sin α and the friction."""
    found = solution(problem, INCLINE.format(more=", slip: positive, contact: positive"))
    names = {s.name: s for f in found.own.motion.principle.forces for s in f.free_symbols}
    m, g, alpha, mu = (names[n] for n in ("m", "g", "alpha", "mu"))
    assert sp.expand(found.own.motion.principle.forces[0] - m * g * (sp.sin(alpha) - mu * sp.cos(alpha))) == 0
    assert [w.vanishes for w in found.works] == [True]


# -- what is refused ---------------------------------------------------------------------------------------------------

PLANE = """parameters: [m, g, mu]
coordinates: [x, y, z]
particles: {{P: {{mass: m, position: '[x, y, z]'}}, Q: {{mass: m, position: '[0, 0, 0]'}}}}
constraints: {{floor: z = 0, again: 2*z = 0, wall: x = 0}}
gravity: '[0, 0, -g]'
forces: {{rub: {{friction: mu, {rest}}}}}
"""


@pytest.mark.parametrize(
    ("rest", "code", "says"),
    [
        ("constraint: ceiling, on: P", "unknown-name", "ceiling"),
        ("constraint: wall, on: Q", "friction-place", "does not act on `Q`"),
        ("constraint: floor, on: P", "friction-undetermined", "not determined"),
        ("constraint: [wall, floor], on: P", "friction-undetermined", "not determined"),
        ("constraint: [wall, wall], on: P", "declared-twice", "occurs twice"),
        ("constraint: [], on: P", "empty-value", "is empty"),
    ],
)
def test_what_is_refused(problem: Read, rest: str, code: str, says: str) -> None:
    with pytest.raises(ProblemError) as caught:
        solve(problem("title: Example\n" + PLANE.format(rest=rest)))
    [found] = caught.value.diagnostics
    assert found.code == code
    assert says in str(found)
    assert status_of_error(caught.value) == 2


ROD_ON_A_FLOOR = """title: Rod that slides on a rough floor
parameters: [m, J, l, g, mu]
coordinates: [x, y, theta]
bodies: {rod: {mass: m, inertia: J, position: x*i + y*j, angle: theta}}
particles: {P: {mass: m, position: x*i + y*j}}
constraints: {floor: y = l*cos(theta)}
gravity: -g*j
forces: {rub: {friction: mu, constraint: floor, on: rod}}
"""


def test_friction_at_rest_has_no_law(problem: Read) -> None:
    with pytest.raises(NotCoveredError, match="`rub`, which has no coefficient of friction at rest"):
        solve(problem("title: Example\n" + INCLINE.format(more="") + "find: equilibrium\n"))


def test_where_a_body_is_touched_is_not_known(problem: Read) -> None:
    """The mass centre is not where it slides. What does not need the force is found; a particle beside it may slide."""
    with pytest.raises(ProblemError, match="does not say which point of `rod` touches") as caught:
        solve(problem(ROD_ON_A_FLOOR.replace("particles: {P: {mass: m, position: x*i + y*j}}\n", "")))
    assert status_of_error(caught.value) == 2
    assert solve(problem(ROD_ON_A_FLOOR + "find: constraints\n")).classification.degrees_of_freedom == 2
    beside = ROD_ON_A_FLOOR.replace("y = l*cos(theta)", "y = 0").replace("on: rod", "on: P")
    assert solve(problem(beside.replace("mass: m, inertia: J, position: x*i + y*j", "inertia: J, position: 0*i")))


def test_a_sense_where_there_is_no_line(problem: Read) -> None:
    text = PLANE.format(rest="constraint: floor, on: P, slip: positive").replace(", again: 2*z = 0, wall: x = 0", "")
    with pytest.raises(ProblemError) as caught:
        solve(problem(f"title: Example\n{text}"))
    assert caught.value.diagnostics[0].code == "friction-slip"


def test_a_particle_that_its_coordinates_keep_on_a_line(problem: Read) -> None:
    """The wedge without its height: the floor bears a part of the face's reaction on it, which no form shows."""
    text = (
        WEDGE.replace("X, Y,", "X,").replace('"[X, Y]"', '"[X, 0]"').replace("floor: Y = 0, ", "").replace("y - Y", "y")
    )
    with pytest.raises(ProblemError) as caught:
        solve(problem(f"title: Example\n{text}"))
    assert caught.value.diagnostics[0].code == "friction-place"
    assert "`wedge`" in str(caught.value.diagnostics[0])


def test_the_derivation_says_when_the_law_holds(problem: Read) -> None:
    said = str(report(problem("title: Example\n" + INCLINE.format(more=""))).derivation)
    assert "This holds while " in said
    assert "the slip is not zero" in said


# -- a surface that keeps a distance -----------------------------------------------------------------------------------

DOME = """parameters: [m, R, mu, g]
coordinates: [{coordinate}, theta]
let: {{out: sin(theta)*i + cos(theta)*j}}
particles: {{block: {{mass: m, position: {radius}*out}}}}
constraints: {{dome: {{equation: {dome}, reaction: N}}}}
gravity: -g*j
forces: {{rub: {{friction: mu, constraint: dome, on: block, slip: positive, contact: positive}}}}
generalized_coordinates: {{angle: {{coordinates: [theta]}}}}
"""


def test_a_rough_surface_has_no_tension(problem: Read) -> None:
    """N is what `contact` is the sign of: the page has it positive, and has no other name for it."""
    found = solution(problem, DOME.format(coordinate="r", radius="r", dome="r = R"))
    assert found.law is not None
    [reaction] = found.law.newton.reactions
    assert (reaction.rod, reaction.tension, reaction.multiplier.name, reaction.is_normal) == (None, None, "N", True)
    shown = report(problem("title: Example\n" + DOME.format(coordinate="r", radius="r", dome="r = R")))
    page = terminal.text(shown.derivation, shown.notation, 120)
    assert "N = m g cos θ − m R θ̇²" in page
    assert "R θ̈ − μ R θ̇² − g sin θ + μ g cos θ = 0" in page
    for word in ("tension", "λ", "|"):
        assert word not in page.replace("│", "").replace("|R|", "")
    assert verdict(found, "r*theta'' + 2*r'*theta' = g*sin(theta) - mu*N/m") is Verdict.EQUIVALENT


@pytest.mark.parametrize(
    ("stated", "expected", "remarks"),
    [
        ("N = m*g*cos(theta) - m*R*theta'^2", Verdict.EQUIVALENT, 0),
        ("N = m*R*theta'^2 - m*g*cos(theta)", Verdict.EQUIVALENT, 1),
        ("N = m*g*cos(theta) + m*R*theta'^2", Verdict.WRONG, 0),
    ],
)
def test_the_opposite_of_a_force_of_contact_is_right_with_a_remark(
    problem: Read, stated: str, expected: Verdict, remarks: int
) -> None:
    text = DOME.format(coordinate="r", radius="r", dome="r = R") + f'answers: {{reactions: {{dome: "{stated}"}}}}\n'
    [answer] = compared_answers(solution(problem, text))
    assert (answer.verdict, len(answer.equations[0].remarks)) == (expected, remarks)


def test_the_distance_may_be_negative(problem: Read) -> None:
    """Below the centre, as s = -R says it: |s| is -s there."""
    found = solution(problem, DOME.format(coordinate="s", radius="(s)", dome="s = -R"))
    assert verdict(found, "s*theta'' = g*sin(theta) + mu*(g*cos(theta) + R*theta'^2)") is Verdict.EQUIVALENT
    assert found.own.motion is not None
    assert not any(e.atoms(sp.Abs) for e in found.own.motion.expressions)


def test_what_a_surface_keeps_constant_is_put_into_the_normal_force(problem: Read) -> None:
    """Inside a rough pipe: |R| = m (x'² + y'²)/R and not √(x² + y²) times something."""
    found = solution(
        problem,
        "parameters: [m, g, R, mu]\ncoordinates: [x, y, z]\nparticles: {P: {mass: m, position: '[x, y, z]'}}\n"
        "constraints: {pipe: x^2 + y^2 = R^2}\ngravity: '[0, 0, -g]'\n"
        "forces: {rub: {friction: mu, constraint: pipe, on: P, contact: negative}}\n",
    )
    x, y = (sp.Symbol(n, real=True) for n in "xy")
    assert not any(e.has(sp.sqrt(x**2 + y**2)) for e in found.own.motion.expressions)
    assert verdict(
        found, "z'' = -g - mu*(x'^2 + y'^2)*z'/(R*sqrt(x'^2 + y'^2 + z'^2))", "x*y'' - y*x'' = "
        "-mu*(x'^2 + y'^2)*(x*y' - y*x')/(R*sqrt(x'^2 + y'^2 + z'^2))",
    ) is Verdict.EQUIVALENT  # fmt: skip


def test_block_on_a_rough_circular_track(problem: Read) -> None:
    """On top, x = R sin θ: R θ'' = g sin θ − μ (g cos θ − R θ'²). The run did not end, dividing by 1 + x²/y²."""
    found = solution(
        problem,
        "parameters: [m, g, R, mu]\ncoordinates: [x, y]\nparticles: {P: {mass: m, position: '[x, y]'}}\n"
        "constraints: {c: x^2 + y^2 = R^2}\ngravity: '[0, -g]'\n"
        "forces: {rub: {friction: mu, constraint: c, on: P, slip: positive, contact: positive}}\n",
    )
    assert found.own.dynamics is not None
    values = dict(
        zip(
            ["x", "y", "x'", "y'", "g", "R", "mu", "m"],
            map(sp.Rational, ["3", "4", "4/5", "-3/5", "10", "5", "1/2", "1"]),
            strict=True,
        )
    )
    x, y = found.own.dynamics.accelerations.values()
    state = {s: values[s.name] for e in (x, y) for s in e.free_symbols}
    turned = (10 * sp.Rational(3, 5) - (8 - sp.Rational(1, 5)) / 2) / 5
    assert x.xreplace(state) == 4 * turned - sp.Rational(3, 25)
    assert y.xreplace(state) == -3 * turned - sp.Rational(4, 25)


@pytest.mark.parametrize(
    ("coefficient", "choice", "right"),
    [
        ("y", "{coordinates: [x]}", "x'' = g*sin(alpha)"),  # y = 0: the plane is smooth
        ("mu*x", "{coordinates: [s], substitute: {x: 2*s, y: 0}}", "2*s'' = g*sin(alpha) - 2*mu*s*g*cos(alpha)"),
        ('"mu*x\'"', "{coordinates: [s], substitute: {x: 2*s, y: 0}}", "2*s'' = g*sin(alpha) - 2*mu*s'*g*cos(alpha)"),
    ],
)
def test_a_coefficient_that_varies_is_rewritten_in_a_choice(
    problem: Read, coefficient: str, choice: str, right: str
) -> None:
    text = INCLINE.format(more=", slip: positive, contact: positive").replace(
        "friction: mu", f"friction: {coefficient}"
    )
    found = solution(problem, f"{text}generalized_coordinates: {{c: {choice}}}\n")
    [chosen] = found.choices
    assert chosen.motion is not None
    eliminated = {*found.own.configuration.slots.coordinates} - {*chosen.configuration.slots.coordinates}
    assert all(e.free_symbols.isdisjoint(eliminated) for e in chosen.motion.expressions)
    assert verdict(found, right) is Verdict.EQUIVALENT


def test_a_sense_of_slip_along_x_turns_with_the_position_on_a_circle(problem: Read) -> None:
    """Where x' < 0 the bead goes with theta in the upper half and against it in the lower: friction opposes both."""
    found = solve(
        problem(
            "title: Rough hoop\nparameters: {m: positive, R: positive, g: positive, mu: positive}\ngravity: -g*j\n"
            "coordinates: [x, y]\nparticles: {ring: {mass: m, position: x*i + y*j}}\n"
            "constraints: {hoop: {equation: x^2 + y^2 = R^2, reaction: N, by: wire}}\n"
            "forces: {rub: {friction: mu, constraint: hoop, on: ring, slip: negative}}\n"
            "generalized_coordinates:\n"
            "  angle: {coordinates: [theta], substitute: {x: R*cos(theta), y: -R*sin(theta)}}\n"
        )
    )
    assert all(check.passed for check in found.checks)
    [chosen] = found.choices
    assert chosen.motion is not None
    [equation] = chosen.motion.expressions
    names = {s.name: s for s in equation.free_symbols}
    at = {names["R"]: 2, names["g"]: 10, names["mu"]: sp.Rational(1, 2), names["theta'"]: 3}
    for angle in (sp.Rational(1, 2), -sp.Rational(1, 2)):
        here = {**at, names["theta"]: angle}
        [value] = sp.solve(equation.xreplace(here), names["theta''"])
        normal = abs(2 * 9 + 10 * sp.sin(angle))
        by_hand = (10 * sp.cos(angle) - sp.sign(angle) * normal / 2) / 2
        assert abs((value - by_hand).evalf(20)) < 1e-15


@pytest.mark.parametrize(("slip", "sign"), [("negative", -1), ("positive", 1)])
def test_the_sense_of_slip_is_that_of_the_coordinate_of_the_file(problem: Read, slip: str, sign: int) -> None:
    """x_A + x_B = 0: the block B that slides to −x is held back to +x, and so is A to −x, in every coordinate."""
    text = f"""title: Two blocks on a cable
axes: {{i: right, j: up}}
parameters: [m_A, m_B, F, mu, g]
coordinates: [x_A, x_B, y_B]
particles: {{A: {{mass: m_A, position: x_A*i}}, B: {{mass: m_B, position: x_B*i + y_B*j}}}}
constraints: {{cable: x_A + x_B = 0, floor: {{equation: y_B >= 0, reaction: N}}}}
gravity: -g*j
forces: {{push: {{on: A, vector: F*i}}, rub: {{friction: mu, constraint: floor, on: B, slip: {slip}}}}}
generalized_coordinates: {{A: {{coordinates: [x_A]}}, B: {{coordinates: [x_B]}}}}
answers: {{equations: ["(m_A + m_B)*x_A'' = F + {sign}*mu*m_B*g"]}}
"""
    solution = solve(problem(text))
    assert [c.name for c in solution.checks if c.passed is not True] == []
    assert [a.verdict for a in compared_answers(solution)] == [Verdict.EQUIVALENT]


@pytest.mark.parametrize("constraint", ['"dot(r_block - r_plank, j) >= 0"', '"dot(r_plank, j) <= dot(r_block, j)"'])
def test_a_block_drags_the_plank_on_which_it_slides(problem: Read, constraint: str) -> None:
    """Friction has its opposite on what a constraint names, though the plank cannot move along the normal."""
    text = f"""axes: {{i: right, j: up}}
parameters: [m, M, g, mu]
coordinates: [x, y, s]
particles: {{block: {{mass: m, position: x*i + y*j}}, plank: {{mass: M, position: s*i}}}}
constraints: {{top: {{equation: {constraint}, reaction: N}}}}
gravity: -g*j
forces: {{rub: {{friction: mu, constraint: top, on: block, slip: i}}}}
"""
    assert verdict(solution(problem, text), "x'' = -mu*g", "M*s'' = mu*m*g") is Verdict.EQUIVALENT


ROUND = """
parameters: [m, g, R, mu]
coordinates: [x, y]
particles: {{P: {{mass: m, position: x*i + y*j}}}}
constraints: {{c: x^2 + y^2 = R^2}}
gravity: -g*j
forces: {{f: {{friction: mu, constraint: c, on: P, slip: {slip}, contact: negative}}}}
generalized_coordinates: {{angle: {{coordinates: [phi], substitute: {{x: R*sin(phi), y: -R*cos(phi)}}}}}}
"""


def test_a_sense_as_a_vector_round_a_circle_holds_in_every_choice(problem: Read) -> None:
    found = solution(problem, ROUND.format(slip='"[-y, x]"'))
    assert all(check.passed for check in found.checks)
