"""Answers and their verdicts: the table of the contract, through problem files and through reference systems.

Each answer is judged twice: against a problem that is solved, and against the same equations given under `equations`.
"""

from __future__ import annotations

from functools import cache

import pytest

from lagrange.answers.equations import Reference, check_equations
from lagrange.answers.examiner import Judgement, check_answer, reference
from lagrange.core.diagnostics import Fragment, Source
from lagrange.problem.loader import read_problem
from lagsolve.exit_statuses import status_of_verdict

EQUIVALENT, WRONG, INCOMPLETE, TRIVIAL, UNREADABLE = "equivalent", "wrong", "incomplete", "trivial", "unreadable"

SOLVED = {
    "pendulum": """
title: Pendulum
parameters: [m, l, g]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
constraints: {rod: x^2 + y^2 = l^2}
gravity: g*j
generalized_coordinates:
  angle: {coordinates: [theta], substitute: {x: l*sin(theta), y: l*cos(theta)}}
  depth: {coordinates: [y]}
""",
    "spherical": """
title: Spherical pendulum
parameters: [m, l, g]
coordinates: [x, y, z]
particles: {P: {mass: m, position: "[x, y, z]"}}
constraints: {rod: x^2 + y^2 + z^2 = l^2}
gravity: g*k
generalized_coordinates:
  angles:
    coordinates: [theta, phi]
    substitute: {x: l*sin(theta)*cos(phi), y: l*sin(theta)*sin(phi), z: l*cos(theta)}
""",
    "atwoodI": """
title: Atwood's machine with a pulley whose mass is a particle on its rim
parameters: [m1, m2, g, I, R]
coordinates: [x]
particles:
  A: {mass: m1, position: x*j}
  B: {mass: m2, position: -x*j}
  rim: {mass: I/R^2, position: R*cos(x/R)*i + R*sin(x/R)*k}
gravity: g*j
""",
    "beadwire": """
title: Bead on a turning wire
parameters: [m, omega]
coordinates: [r, phi]
frame: {type: polar, coordinates: [r, phi]}
particles: {P: {mass: m, position: r*e_r}}
constraints: {wire: phi = omega*t}
""",
    "cart": """
title: Cart with pendulum
parameters: [M, m, l, g]
coordinates: [x, theta]
particles:
  cart: {mass: M, position: x*i}
  bob: {mass: m, position: x*i + l*sin(theta)*i + l*cos(theta)*j}
gravity: g*j
""",
    "kepler": """
title: Kepler
parameters: [m, k, L]
coordinates: [r, phi]
frame: {type: polar, coordinates: [r, phi]}
particles: {P: {mass: m, position: r*e_r}}
forces: {sun: {potential: -k/r}}
""",
    "incl": """
title: Incline
parameters: [m, g, alpha]
coordinates: [x, y]
particles: {P: {mass: m, position: "[x, y]"}}
constraints: {plane: y = x*tan(alpha)}
gravity: g*j
generalized_coordinates:
  slope: {coordinates: [s], substitute: {x: s*cos(alpha), y: s*sin(alpha)}}
""",
}

GIVEN = {
    "pendulum": ("theta", "m, g, l", ["m*l^2*theta'' + m*g*l*sin(theta) = 0"]),
    "spherical": (
        "theta, phi",
        "m, g, l",
        [
            "m*l^2*theta'' - m*l^2*sin(theta)*cos(theta)*phi'^2 + m*g*l*sin(theta) = 0",
            "m*l^2*sin(theta)^2*phi'' + 2*m*l^2*sin(theta)*cos(theta)*theta'*phi' = 0",
        ],
    ),
    "atwoodI": ("x", "m1, m2, g, I, R", ["(m1+m2+I/R^2)*x'' - (m1-m2)*g = 0"]),
    "beadwire": ("r", "m, omega", ["m*r'' - m*omega^2*r = 0"]),
    "cart": (
        "x, theta",
        "M, m, l, g",
        [
            "(M+m)*x'' + m*l*theta''*cos(theta) - m*l*theta'^2*sin(theta)=0",
            "m*l^2*theta'' + m*l*x''*cos(theta) + m*g*l*sin(theta)=0",
        ],
    ),
    "kepler": ("r, phi", "m, k, L", ["m*r'' - m*r*phi'^2 + k/r^2 = 0", "m*r^2*phi'' + 2*m*r*r'*phi'=0"]),
    "incl": ("s", "m, g, alpha", ["m*s'' - m*g*sin(alpha)=0"]),
}

TABLE = {
    "1": ("pendulum", "theta'' + (g/l)*sin(theta) = 0", EQUIVALENT),
    "2": ("pendulum", "m*l*theta'' = -m*g*sin(theta)", EQUIVALENT),
    "3": ("pendulum", "theta'' + 2*(g/l)*sin(theta/2)*cos(theta/2) = 0", EQUIVALENT),
    "4": ("pendulum", "theta'*(m*l^2*theta'' + m*g*l*sin(theta)) = 0", EQUIVALENT),
    "5": ("pendulum", "l*theta'' = g*sin(theta)", WRONG),
    "6": ("pendulum", "theta'' + (g/l)*cos(theta) = 0", WRONG),
    "7": ("pendulum", "theta'' + (l/g)*sin(theta) = 0", WRONG),
    "8": ("pendulum", "theta'' + (g/l)*theta = 0", WRONG),
    "9": ("pendulum", "theta'' + g*sin(theta) = 0", WRONG),
    "10": ("pendulum", "2*theta'' + (g/l)*sin(theta) = 0", WRONG),
    "11": ("pendulum", "theta'' = 0", WRONG),
    "12": ("pendulum", "0 = 0", TRIVIAL),
    "13": ("pendulum", "sin(theta)^2 + cos(theta)^2 - 1 = 0", TRIVIAL),
    "14": (
        "spherical",
        "theta'' - sin(theta)*cos(theta)*phi'^2 + g/l*sin(theta)=0 ; phi''*sin(theta) + 2*theta'*phi'*cos(theta)=0",
        EQUIVALENT,
    ),
    "15": (
        "spherical",
        "theta'' = sin(2 theta)/2*phi'^2 - g/l*sin(theta) ; phi'' = -2*theta'*phi'*cos(theta)/sin(theta)",
        EQUIVALENT,
    ),
    "16": ("spherical", "theta'' - sin(theta)*cos(theta)*phi'^2 + g/l*sin(theta)=0", INCOMPLETE),
    "17": (
        "spherical",
        "theta'' + sin(theta)*cos(theta)*phi'^2 + g/l*sin(theta)=0 ; phi''*sin(theta) + 2*theta'*phi'*cos(theta)=0",
        WRONG,
    ),
    "18": (
        "spherical",
        "theta'' - sin(theta)*cos(theta)*phi'^2 + g/l*sin(theta)=0 ; phi''*sin(theta) + theta'*phi'*cos(theta)=0",
        WRONG,
    ),
    "19": (
        "spherical",
        "theta'' + g/l*sin(theta)=0 ; phi''*sin(theta)^2 + 2*theta'*phi'*sin(theta)*cos(theta)=0",
        WRONG,
    ),
    "20": (
        "spherical",
        "theta'' - sin(theta)*cos(theta)*phi'^2 - g/l*sin(theta)=0 ; phi''*sin(theta) + 2*theta'*phi'*cos(theta)=0",
        WRONG,
    ),
    "30": ("atwoodI", "x'' = (m1-m2)*g/(m1+m2)", WRONG),
    "31": ("atwoodI", "(m1 R^2 + m2 R^2 + I) x'' = (m1 - m2) g R^2", EQUIVALENT),
    "36": ("beadwire", "r'' = omega^2*r", EQUIVALENT),
    "37": ("beadwire", "m*r'' + m*omega^2*r = 0", WRONG),
    "38": (
        "cart",
        "(M+m*sin(theta)^2)*x'' = m*l*theta'^2*sin(theta) + m*g*sin(theta)*cos(theta)"
        " ; l*theta'' = -x''*cos(theta) - g*sin(theta)",
        EQUIVALENT,
    ),
    "39": (
        "cart",
        "M*x'' + m*l*theta''*cos(theta) - m*l*theta'^2*sin(theta)=0 ; l*theta'' + x''*cos(theta) + g*sin(theta)=0",
        WRONG,
    ),
    "40": ("cart", "(M+m)*x'' + m*l*theta''*cos(theta) = 0 ; l*theta'' + x''*cos(theta) + g*sin(theta)=0", WRONG),
    "41": (
        "cart",
        "(M+m)*x'' + m*l*theta''*cos(theta) - m*l*theta'^2*sin(theta)=0"
        " ; (M+m)*x'' + m*l*theta''*cos(theta) - m*l*theta'^2*sin(theta)=0",
        INCOMPLETE,
    ),
    "42": ("kepler", "r'' - r*phi'^2 = -k/(m*r^2) ; r*phi'' + 2*r'*phi' = 0", EQUIVALENT),
    "43": ("kepler", "r'' - r*phi'^2 = k/(m*r^2) ; r*phi'' + 2*r'*phi' = 0", WRONG),
    "44": ("kepler", "r'' - r*phi'^2 = -k/(m*r) ; r*phi'' + 2*r'*phi' = 0", WRONG),
    "48": ("incl", "s'' = g*sin(alpha)", EQUIVALENT),
    "49": ("incl", "s'' = g*cos(alpha)", WRONG),
    # decided once
    "square": ("pendulum", "(theta'' + g/l*sin(theta))^2 = 0", WRONG),
    "divided by sine": ("pendulum", "theta''/sin(theta) + g/l = 0", EQUIVALENT),
    "energy rate": ("pendulum", "theta'*theta'' + g/l*sin(theta)*theta' = 0", EQUIVALENT),
    "second redundant": ("pendulum", "l*theta'' + g*sin(theta) = 0 ; theta'' = -g/l*sin(theta)", EQUIVALENT),
    "a wrong extra": ("pendulum", "l*theta'' + g*sin(theta) = 0 ; theta'' = 0", WRONG),
    "number for g": ("pendulum", "theta'' + 9.81/l*sin(theta) = 0", WRONG),
    "capital letter": ("pendulum", "Theta'' + g/l*sin(theta) = 0", UNREADABLE),
    "capital L": ("pendulum", "theta'' + g/L*sin(theta) = 0", UNREADABLE),
    "other orientation": ("pendulum", "theta'' - g/l*sin(theta) = 0", WRONG),
    "intermediate name": ("pendulum", "alpha = theta'' ; alpha + g/l*sin(theta) = 0", UNREADABLE),
    "false": ("pendulum", "1 = 0", WRONG),
    "right and false": ("pendulum", "theta'' + g/l*sin(theta) = 0 ; 1 = 0", WRONG),
    "right and trivial": ("pendulum", "theta'' + g/l*sin(theta) = 0 ; 0 = 0", EQUIVALENT),
    "trivial twice": ("pendulum", "0 = 0 ; theta = theta", TRIVIAL),
    "a state": ("pendulum", "theta = 0", WRONG),
    "rest": ("pendulum", "theta' = 0", WRONG),
    "zero times the equation": ("pendulum", "0*(theta'' + g/l*sin(theta)) = 0", TRIVIAL),
    "equation times zero written long": (
        "pendulum",
        "(sin(theta)^2 + cos(theta)^2 - 1)*theta'' = 0",
        TRIVIAL,
    ),
    "divided by zero": ("pendulum", "theta''/(sin(theta)^2 + cos(theta)^2 - 1) = 0", UNREADABLE),
    "divided by plain zero": ("pendulum", "theta''/0 = 0", UNREADABLE),
    "divided by l - l": ("pendulum", "theta''/(l - l) = 0", UNREADABLE),
    "d/dt of the momentum": ("pendulum", "diff(m*l^2*theta', t) = -m*g*l*sin(theta)", EQUIVALENT),
    "momentum of the spherical pendulum": (
        "spherical",
        "theta'' - sin(theta)*cos(theta)*phi'^2 + g/l*sin(theta) = 0 ; diff(m*l^2*sin(theta)^2*phi', t) = 0",
        EQUIVALENT,
    ),
    "rate of the energy": (
        "spherical",
        "theta'*theta'' + sin(theta)*cos(theta)*theta'*phi'^2 + sin(theta)^2*phi'*phi'' + g/l*sin(theta)*theta' = 0",
        INCOMPLETE,
    ),
    "energy rate and momentum": (
        "spherical",
        "diff(theta'^2/2 + sin(theta)^2*phi'^2/2 - g/l*cos(theta), t) = 0 ; diff(sin(theta)^2*phi', t) = 0",
        EQUIVALENT,
    ),
    "first integral": ("pendulum", "theta'^2/2 - g/l*cos(theta) = m", WRONG),
    "angular momentum": ("kepler", "r'' - r*phi'^2 = -k/(m*r^2) ; m*r^2*phi' = L", WRONG),
    "as Binet": ("kepler", "r''*r + r'^2 + k/(m*r) = r'^2 + r^2*phi'^2 ; phi''/phi' = -2*r'/r", EQUIVALENT),
    "combination with state": (
        "cart",
        "(M+m)*x'' + m*l*theta''*cos(theta) - m*l*theta'^2*sin(theta) = x*(l*theta'' + x''*cos(theta) + g*sin(theta))"
        " ; exp(theta)*(l*theta'' + x''*cos(theta) + g*sin(theta)) = 0",
        EQUIVALENT,
    ),
    "difference of the two": (
        "cart",
        "(M+m)*x'' + m*l*theta''*cos(theta) - m*l*theta'^2*sin(theta) = l*theta'' + x''*cos(theta) + g*sin(theta)",
        INCOMPLETE,
    ),
    "unicode": ("pendulum", "θ̈ + (g/l)·sin θ = 0", EQUIVALENT),
    "function of t": ("pendulum", "theta''(t) + g/l*sin(theta(t)) = 0", EQUIVALENT),
    "sine without brackets": ("cart", "(M + m) x'' + m l theta'' cos theta - m l theta'^2 sin theta = 0 ; "
                              "l theta'' + x'' cos theta + g sin theta = 0", EQUIVALENT),
    "third derivative": ("pendulum", "diff(l*theta'' + g*sin(theta), t) = 0", UNREADABLE),
}  # fmt: skip


@cache
def solved_reference(system: str) -> Reference:
    return reference(read_problem(Source(system, SOLVED[system])))


@cache
def given_reference(system: str) -> Reference:
    coordinates, parameters, equations = GIVEN[system]
    listed = "".join(f'  - "{e}"\n' for e in equations)
    text = f"title: {system}\ncoordinates: [{coordinates}]\nparameters: [{parameters}]\nequations:\n{listed}"
    return reference(read_problem(Source(system, text)))


def fragments(answer: str) -> tuple[Fragment, ...]:
    return tuple(Fragment.of(e.strip(), f"equation {n}") for n, e in enumerate(answer.split(";"), start=1))


def verdict_on(answer: str, against: Reference) -> Judgement:
    problem = read_problem(Source("pendulum", SOLVED["pendulum"]))  # a verdict needs one only to be written
    return Judgement(check_equations(fragments(answer), against), problem=problem)


STATUS = {EQUIVALENT: 0, WRONG: 1, INCOMPLETE: 1, TRIVIAL: 1, UNREADABLE: 2, "undecided": 3}


@pytest.mark.parametrize("row", TABLE)
@pytest.mark.parametrize("way", ["solved", "given"])
def test_verdict(way: str, row: str) -> None:
    system, answer, expected = TABLE[row]
    found = verdict_on(answer, solved_reference(system) if way == "solved" else given_reference(system))
    assert found.verdict.value == expected
    assert status_of_verdict(found.verdict) == STATUS[expected]
    assert len(found.equations.equations) == len(answer.split(";"))


def test_each_equation_has_its_own_verdict() -> None:
    found = verdict_on(TABLE["a wrong extra"][1], solved_reference("pendulum")).equations
    assert [e.verdict.value for e in found.equations] == [EQUIVALENT, WRONG]
    found = verdict_on(TABLE["16"][1], solved_reference("spherical")).equations
    assert [e.verdict.value for e in found.equations] == [EQUIVALENT]
    assert found.missing == 1
    found = verdict_on(TABLE["18"][1], solved_reference("spherical")).equations
    assert [e.verdict.value for e in found.equations] == [EQUIVALENT, WRONG]
    found = verdict_on("theta'' + q*theta = 0 ; theta'' = -g/l*sin(theta)", solved_reference("pendulum")).equations
    assert [e.verdict.value for e in found.equations] == [UNREADABLE, EQUIVALENT]
    assert found.verdict.value == UNREADABLE


def test_an_equation_not_linear_in_the_accelerations_says_so() -> None:
    found = verdict_on(TABLE["square"][1], solved_reference("pendulum")).equations
    assert "linear" in found.equations[0].diagnosis


# -- dependent coordinates, restated constraints, multipliers ----------------------------------------------------------


DEPENDENT = [
    ("x*(y'' - g) - y*x'' = 0", EQUIVALENT),
    ("x*(y'' - g) - y*x'' = 0 ; x^2 + y^2 = l^2", EQUIVALENT),
    ("x*(y'' - g) - y*x'' = 0 ; x*x' + y*y' = 0", EQUIVALENT),
    ("x*(y'' - g) - y*x'' = 0 ; x*x'' + y*y'' + x'^2 + y'^2 = 0", EQUIVALENT),
    ("x^2 + y^2 = l^2", INCOMPLETE),
    ("x*x' + y*y' = 0", INCOMPLETE),
    ("x'^2 + x*x'' + y*y'' + y'^2 = 0", INCOMPLETE),
    ("x^2 + y^2 = l^2 ; 0 = 0", INCOMPLETE),
    ("x^2 + y^2 = 2*l^2 ; x*(y'' - g) - y*x'' = 0", WRONG),
    ("x*x' = y*y' ; x*(y'' - g) - y*x'' = 0", WRONG),
    ("x*(y'' - g) + y*x'' = 0", WRONG),
    ("x'' = 0", WRONG),
    ("l^2*x'' = -x*(x'^2 + y'^2) - g*x*y", EQUIVALENT),
    ("l^2*y'' = -y*(x'^2 + y'^2) + g*x^2", EQUIVALENT),
    ("(x^2 + y^2)*x'' = -x*(x'^2 + y'^2) - g*x*y", EQUIVALENT),
    ("sqrt(x^2 + y^2)*x'' = -x*(x'^2 + y'^2)/l - g*x*y/l", EQUIVALENT),
    # multipliers: m r'' = F + lambda grad(x^2 + y^2 - l^2)
    ("m*x'' = 2*x*lambda_rod ; m*y'' = m*g + 2*y*lambda_rod", EQUIVALENT),
    ("m*x'' = 2*x*lambda_rod ; m*y'' = m*g + 2*y*lambda_rod ; x^2 + y^2 = l^2", EQUIVALENT),
    ("m*x'' = -2*x*lambda_rod ; m*y'' = m*g - 2*y*lambda_rod", WRONG),
    ("m*x'' = 2*x*lambda_rod", INCOMPLETE),
    ("2*l^2*lambda_rod = -m*(x'^2 + y'^2) - m*g*y", INCOMPLETE),
    ("x*(y'' - g) - y*x'' = 0 ; 2*l^2*lambda_rod = -m*(x'^2 + y'^2) - m*g*y", EQUIVALENT),
    ("x*(y'' - g) - y*x'' = 0 ; 2*l^2*lambda_rod = m*(x'^2 + y'^2) - m*g*y", WRONG),
    # coordinates of the file and of a choice together
    ("x'' = -g*sin(theta)*cos(theta) - l*sin(theta)*theta'^2", EQUIVALENT),
    ("theta'' + g*x/l^2 = 0", EQUIVALENT),
    ("theta'' + g*y/l^2 = 0", WRONG),
    ("theta'' + g/l*sin(theta) = 0 ; x = l*sin(theta) ; y = l*cos(theta)", EQUIVALENT),
    ("theta'' + g/l*sin(theta) = 0 ; x = l*cos(theta)", WRONG),
    ("x = l*sin(theta) ; y = l*cos(theta)", INCOMPLETE),
    ("y*theta'' + x'*theta' + g*x/l - x'*y'/y = 0", WRONG),
    ("l*theta'' + g*sin(theta) = 0 ; 2*l*lambda_rod = -m*g*cos(theta) - m*l*theta'^2", EQUIVALENT),
    ("l*theta'' + g*sin(theta) = 0 ; 2*l*lambda_rod = -m*g*cos(theta) + m*l*theta'^2", WRONG),
    ("m*(l*cos(theta)*theta'' - l*sin(theta)*theta'^2) = 2*lambda_rod*l*sin(theta) ; "
     "m*(-l*sin(theta)*theta'' - l*cos(theta)*theta'^2) = m*g + 2*lambda_rod*l*cos(theta)", EQUIVALENT),
    # the choice of y: both branches
    ("y''*l^2 + y*y'^2*l^2/(l^2 - y^2) = g*(l^2 - y^2)", EQUIVALENT),
    ("y''*l^2 + y*y'^2*l^2/(l^2 + y^2) = g*(l^2 - y^2)", WRONG),
]  # fmt: skip


@pytest.mark.parametrize(("answer", "expected"), DEPENDENT)
def test_dependent_coordinates_and_multipliers(answer: str, expected: str) -> None:
    assert verdict_on(answer, solved_reference("pendulum")).verdict.value == expected


SKATE = """
title: Dumbbell with a blade
parameters: [m, l, g]
coordinates: [x, y, theta]
particles:
  A: {mass: m, position: "[x + l*cos(theta), y + l*sin(theta)]"}
  B: {mass: m, position: "[x - l*cos(theta), y - l*sin(theta)]"}
constraints:
  blade: {equation: "x'*sin(theta) - y'*cos(theta) = 0", reaction: N}
gravity: g*j
"""

NONHOLONOMIC = [
    ("theta'' = 0 ; x''*cos(theta) + y''*sin(theta) = g*sin(theta)", EQUIVALENT),
    ("theta'' = 0 ; x''*cos(theta) + y''*sin(theta) = g*sin(theta) ; x'*sin(theta) = y'*cos(theta)", EQUIVALENT),
    ("theta'' = 0 ; 2*m*x'' = N*sin(theta) ; 2*m*y'' = 2*m*g - N*cos(theta)", EQUIVALENT),
    ("theta'' = 0 ; 2*m*x'' = -N*sin(theta) ; 2*m*y'' = 2*m*g + N*cos(theta)", EQUIVALENT),  # the opposite force
    ("theta'' = 0 ; 2*m*x'' = N*sin(theta) ; 2*m*y'' = 2*m*g + N*cos(theta)", WRONG),
    ("theta'' = 0 ; x'*sin(theta) = y'*cos(theta)", INCOMPLETE),
    ("x'*sin(theta) = y'*cos(theta)", INCOMPLETE),
    ("theta'' = 0 ; x'' = 0 ; y'' = g", WRONG),
    ("theta'' = 0 ; x'' = g*sin(theta)*cos(theta) - theta'*y' ; y'' = g*sin(theta)^2 + theta'*x'", EQUIVALENT),
    ("theta'' = 0 ; x''*y' = y''*x' - theta'*(x'^2 + y'^2)", INCOMPLETE),
    ("theta'' = 0 ; x''*sin(theta) - y''*cos(theta) + theta'*(x'*cos(theta) + y'*sin(theta)) = 0", INCOMPLETE),
]


@pytest.mark.parametrize(("answer", "expected"), NONHOLONOMIC)
def test_nonholonomic(answer: str, expected: str) -> None:
    found = check_answer(read_problem(Source("skate", SKATE)), fragments(answer))
    assert found.verdict.value == expected


ATWOOD = """
title: Atwood
parameters: [m1, m2, g, c]
coordinates: [x1, x2]
particles: {{A: {{mass: m1, position: x1*j}}, B: {{mass: m2, position: x2*j}}}}
constraints: {{string: {{equation: "c - x1 - x2 = 0"{reaction}}}}}
gravity: g*j
{unknowns}
"""

TENSIONS = [
    ("m1*g - {T} = m1*x1'' ; m2*g - {T} = m2*x2''", EQUIVALENT),
    ("m1*g + {T} = m1*x1'' ; m2*g - {T} = m2*x2''", WRONG),
    ("m1*g - {T} = m1*x1'' ; {T} - m2*g = m2*x1''", EQUIVALENT),
    ("m1*g - {T} = m1*x1''", INCOMPLETE),
    ("{T}*(m1 + m2) = 2*m1*m2*g", INCOMPLETE),
    ("{T}*(m1 + m2) = 2*m1*m2*g ; (m1 + m2)*x1'' = (m1 - m2)*g", EQUIVALENT),
    ("{T}*(m1 + m2) = m1*m2*g ; (m1 + m2)*x1'' = (m1 - m2)*g", WRONG),
]


@pytest.mark.parametrize(("answer", "expected"), TENSIONS)
@pytest.mark.parametrize("name", ["T", "lambda_string"])
def test_tension_as_the_reaction(name: str, answer: str, expected: str) -> None:
    text = ATWOOD.format(reaction=", reaction: T" if name == "T" else "", unknowns="")
    found = check_answer(read_problem(Source("atwood", text)), fragments(answer.format(T=name)))
    assert found.verdict.value == expected


@pytest.mark.parametrize(("name", "expected"), [("T", EQUIVALENT), ("lambda_string", WRONG)])
def test_only_a_name_that_the_file_gives_may_stand_for_the_opposite_force(name: str, expected: str) -> None:
    text = ATWOOD.format(reaction=", reaction: T" if name == "T" else "", unknowns="")
    answer = "m1*g + {T} = m1*x1'' ; m2*g + {T} = m2*x2''"
    found = check_answer(read_problem(Source("atwood", text)), fragments(answer.format(T=name)))
    assert found.verdict.value == expected


@pytest.mark.parametrize("answer", [TENSIONS[0][0], TENSIONS[2][0]])
def test_tension_as_a_declared_unknown(answer: str) -> None:
    """A reader's own name for a force, declared under `unknowns`, is eliminated."""
    text = ATWOOD.format(reaction="", unknowns="unknowns: [S]")
    found = check_answer(read_problem(Source("atwood", text)), fragments(answer.format(T="S")))
    assert found.verdict.value == EQUIVALENT


def test_a_wrong_system_with_a_declared_unknown() -> None:
    text = ATWOOD.format(reaction="", unknowns="unknowns: [S]")
    answer = "m1*g - S = m1*x1'' ; S + m2*g = m2*x1''"
    assert check_answer(read_problem(Source("atwood", text)), fragments(answer)).verdict.value == WRONG


def test_a_lone_equation_with_a_declared_unknown_is_incomplete() -> None:
    text = ATWOOD.format(reaction="", unknowns="unknowns: [S]")
    found = check_answer(read_problem(Source("atwood", text)), fragments("m1*g - S = m1*x1''"))
    assert found.verdict.value == INCOMPLETE


# -- numbers -----------------------------------------------------------------------------------------------------------


# -- limits and exit statuses ------------------------------------------------------------------------------------------


WHEEL = """
title: Wheel on a slope
parameters: [m, R, g, alpha]
coordinates: [x, phi]
particles: {P: {mass: m, position: x*i}, Q: {mass: m, position: "[R*cos(phi), R*sin(phi)]"}}
constraints: {rolling: x' = R*phi'}
gravity: g*sin(alpha)*i
"""


@pytest.mark.parametrize(
    ("answer", "expected"),
    [
        ("x - R*phi = const", INCOMPLETE),
        ("phi = x/R + const", INCOMPLETE),
        ("x - 2*R*phi = const", WRONG),
        ("x - R*phi = 3", WRONG),  # holds for one motion only
        ("x*const = R*phi", WRONG),
        ("phi' = const", WRONG),
        ("x = const", WRONG),
    ],
)
def test_an_integrated_constraint_with_its_constant(answer: str, expected: str) -> None:
    """x − R φ keeps a value that nobody knows: the relation restates the constraint, and is not asked for."""
    checked = check_answer(read_problem(Source("wheel", WHEEL)), (Fragment.of(answer),))
    assert checked.verdict.value == expected
    if expected == INCOMPLETE:
        assert checked.equations.equations[0].remarks == ("it restates a constraint",)


# -- what the program prints is its own right answer -------------------------------------------------------------------
