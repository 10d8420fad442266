"""Feedback on wrong equations: the one change, the group of terms, dimensions, other conventions.

Every row is an answer with one slip in it and the words that name the slip. That an equation is wrong, and that the
change makes it right, does not rest on the table: both systems are solved for the accelerations.
"""

from __future__ import annotations

import re
from functools import cache

import pytest
import sympy as sp
from click.testing import CliRunner

from lagrange.answers.diagnosis import Group, diagnosed
from lagrange.answers.equations import Verdict, check_equations
from lagrange.answers.examiner import check_answer, reference
from lagrange.answers.readings import read_answer
from lagrange.answers.references import Reference
from lagrange.answers.slips import Slip
from lagrange.core.diagnostics import Fragment, Source
from lagrange.problem.loader import read_problem
from lagrange.values.dimensions import mismatch
from lagsolve.main import main
from tests.answers.models.slips import feedback_on
from tests.answers.test_equations import GIVEN
from tests.support.shared import reference_of

SYSTEMS = {
    **GIVEN,
    "double": (
        "a, b",
        "m1, m2, l1, l2, g",
        [
            "(m1+m2)*l1*a'' + m2*l2*b''*cos(a-b) + m2*l2*b'^2*sin(a-b) + (m1+m2)*g*sin(a) = 0",
            "l2*b'' + l1*a''*cos(a-b) - l1*a'^2*sin(a-b) + g*sin(b) = 0",
        ],
    ),
    "spring": (
        "r, theta",
        "m, k, l, g",
        [
            "m*r'' - m*r*theta'^2 + k*(r - l) - m*g*cos(theta) = 0",
            "r*theta'' + 2*r'*theta' + g*sin(theta) = 0",
        ],
    ),
    "damped": ("x", "m, c, k, F, omega", ["m*x'' + c*x' + k*x = F*cos(omega*t)"]),
    "coupled": ("x, y", "m, k, c", ["m*x'' + k*x + c*(x - y) = 0", "m*y'' + k*y + c*(y - x) = 0"]),
    "rolling": ("s", "m, I, R, g, alpha", ["(m + I/R^2)*s'' = m*g*sin(alpha)"]),
    "hoop": ("theta", "R, g, omega", ["R*theta'' - R*omega^2*sin(theta)*cos(theta) + g*sin(theta) = 0"]),
    "ladder": ("theta", "l, g", ["2*l*theta'' - 3*g*cos(theta)/2 = 0"]),
    "drag": ("x", "m, k, b, c", ["m*x'' + b*x' + c*x'^2 + k*x = 0"]),
    "lifted": ("X, h", "M, m, F", ["(M + m)*X'' = F", "m*h'' = 0"]),
    "sphere": (
        "theta, phi",
        "l, g",
        [
            "l*theta'' - l*phi'^2*sin(theta)*cos(theta) + g*sin(theta) = 0",
            "phi''*sin(theta) + 2*phi'*theta'*cos(theta) = 0",
        ],
    ),
}

# system, equation, slip, group, words of the advice
TABLE = [
    ("pendulum", "l*theta'' = g*sin(theta)", Slip.SIGN, "force", "the sign of the term g*sin(theta)"),
    ("pendulum", "theta'' + (g/l)*cos(theta) = 0", Slip.FUNCTION, "force", "g*sin(theta)/l in place of g*cos(theta)/l"),
    ("pendulum", "theta'' + (l/g)*sin(theta) = 0", Slip.INVERTED, "force", "g/l and not l/g"),
    ("pendulum", "theta'' + (g/l)*theta = 0", Slip.SMALL_ANGLE, "force", "the angle is not small"),
    ("pendulum", "theta'' + g*sin(theta) = 0", Slip.FACTOR, "force", "divided by l"),
    ("pendulum", "2*theta'' + (g/l)*sin(theta) = 0", Slip.FACTOR, "inertia", "a factor 2 too many"),
    ("pendulum", "theta'' = 0", Slip.MISSING, "force", "g*sin(theta)/l is missing"),
    ("pendulum", "theta'' + 9.81/l*sin(theta) = 0", Slip.NUMBER, "force", "g in place of 9.81"),
    ("pendulum", "theta'' + 10*sin(theta)/l = 0", Slip.NUMBER, "force", "g in place of 10"),
    ("pendulum", "0.34*theta'' + g*sin(theta)/(3*l) = 0", Slip.NUMBER, "inertia", "0.34 is not 1/3"),
    (
        "pendulum",
        "theta'' + theta' + g/l*sin(theta) = 0",
        Slip.EXTRA,
        "velocity",
        "the term theta' does not belong there",
    ),
    ("pendulum", "m*theta'' + m*g*l*sin(theta) = 0", Slip.FACTOR, "force", "l"),
    ("pendulum", "theta' + g/l*sin(theta) = 0", Slip.DOT, "velocity", "theta'' in place of theta'"),
    ("pendulum", "theta'' + g/l*sin(2*theta) = 0", Slip.ANGLE, "force", "g*sin(theta)/l in place of g*sin(2*theta)/l"),
    ("pendulum", "theta'' + g/l*tan(theta) = 0", Slip.FUNCTION, "force", "g*sin(theta)/l in place of g*tan(theta)/l"),
    (
        "pendulum",
        "theta'' + g/(2*l)*sin(theta) = 0",
        Slip.FACTOR,
        "force",
        "g*sin(theta)/l in place of g*sin(theta)/(2*l)",
    ),
    (
        "spherical",
        "theta'' + sin(theta)*cos(theta)*phi'^2 + g/l*sin(theta)=0",
        Slip.SIGN,
        "velocity",
        "the sign of the term",
    ),
    ("spherical", "phi''*sin(theta) + theta'*phi'*cos(theta)=0", Slip.FACTOR, "velocity", "a factor 2 is missing"),
    ("spherical", "theta'' + g/l*sin(theta)=0", Slip.MISSING, "velocity", "is missing"),
    (
        "spherical",
        "theta'' - sin(theta)*cos(theta)*phi'^2 - g/l*sin(theta)=0",
        Slip.SIGN,
        "force",
        "the sign of the term",
    ),
    ("spherical", "theta'' - sin(theta)*cos(theta)*phi' + g/l*sin(theta)=0", Slip.POWER, "velocity", "phi'"),
    ("spherical", "theta'' - sin(theta)*cos(theta)*theta'^2 + g/l*sin(theta)=0", Slip.COORDINATE, "velocity", "phi'^2"),
    ("spherical", "theta'' - sin(theta)^2*phi'^2 + g/l*sin(theta)=0", Slip.FUNCTION, "velocity", "cos(theta)"),
    ("spherical", "phi''*sin(theta) - 2*theta'*phi'*cos(theta)=0", Slip.SIGN, "velocity", "the sign of the term"),
    ("spherical", "phi''*sin(theta) + 2*theta'*phi'*sin(theta)=0", Slip.FUNCTION, "velocity", "cos(theta)"),
    ("spherical", "phi''*sin(theta) = 0", Slip.MISSING, "velocity", "2*theta'*phi'*cos(theta) is missing"),
    ("atwoodI", "x'' = (m1-m2)*g/(m1+m2)", Slip.MISSING, "inertia", "is missing"),
    ("atwoodI", "(m1+m2+I/R^2)*x'' = (m1+m2)*g", Slip.SIGN, "force", "the sign of the term m2*g"),
    ("atwoodI", "(m1+m2+I/R)*x'' = (m1-m2)*g", Slip.FACTOR, "inertia", "divided by R"),
    ("atwoodI", "(m1+m2+I/R^2)*x'' = m1*g", Slip.MISSING, "force", "m2*g is missing"),
    ("atwoodI", "(m1+m2+I/R^2)*x'' = (m2-m1)*g", None, None, "x were measured the other way"),
    ("beadwire", "m*r'' + m*omega^2*r = 0", Slip.SIGN, "force", "the sign of the term"),
    ("beadwire", "r'' = omega*r", Slip.FACTOR, "force", "omega"),
    ("beadwire", "r'' = 0", Slip.MISSING, "force", "-omega^2*r is missing"),
    ("cart", "M*x'' + m*l*theta''*cos(theta) - m*l*theta'^2*sin(theta)=0", Slip.MISSING, "inertia", "m*x'' is missing"),
    ("cart", "(M+m)*x'' + m*l*theta''*cos(theta) = 0", Slip.MISSING, "velocity", "is missing"),
    ("cart", "(M+m)*x'' + m*l*theta'' - m*l*theta'^2*sin(theta) = 0", Slip.SMALL_ANGLE, "inertia", "cos(theta)"),
    (
        "cart",
        "(M+m)*x'' + m*l*theta''*sin(theta) - m*l*theta'^2*sin(theta) = 0",
        Slip.FUNCTION,
        "inertia",
        "cos(theta)",
    ),
    ("cart", "(M+m)*x'' + m*l*theta''*cos(theta) + m*l*theta'^2*sin(theta) = 0", Slip.SIGN, "velocity", "the sign"),
    (
        "cart",
        "l*theta'' - x''*cos(theta) + g*sin(theta) = 0",
        Slip.SIGN,
        "inertia",
        "the sign of the term x''*cos(theta)",
    ),
    ("cart", "l*theta'' + g*sin(theta) = 0", Slip.MISSING, "inertia", "x''*cos(theta) is missing"),
    ("kepler", "r'' - r*phi'^2 = k/(m*r^2)", Slip.SIGN, "force", "the sign of the term k/(m*r^2)"),
    ("kepler", "r'' - r*phi'^2 = -k/(m*r)", Slip.FACTOR, "force", "divided by r"),
    ("kepler", "r'' = -k/(m*r^2)", Slip.MISSING, "velocity", "is missing"),
    ("kepler", "r*phi'' + r'*phi' = 0", Slip.FACTOR, "velocity", "a factor 2 is missing"),
    ("kepler", "r'' - r*phi'^2 = -k/r^2", Slip.FACTOR, "force", "divided by m"),
    ("kepler", "r'' - r^2*phi'^2 = -k/(m*r^2)", Slip.FACTOR, "velocity", "divided by r"),
    ("incl", "s'' = g*cos(alpha)", Slip.FUNCTION, "force", "g*sin(alpha) in place of g*cos(alpha)"),
    ("incl", "s'' = g", Slip.FACTOR, "force", "sin(alpha)"),
    ("incl", "s'' = g*alpha", Slip.SMALL_ANGLE, "force", "sin(alpha)"),
    (
        "double",
        "l2*b'' + l1*a''*cos(a-b) + l1*a'^2*sin(a-b) + g*sin(b) = 0",
        Slip.SIGN,
        "velocity",
        "the sign of the term",
    ),
    ("double", "l2*b'' + l1*a''*cos(a+b) - l1*a'^2*sin(a-b) + g*sin(b) = 0", Slip.ANGLE, "inertia", "cos(a - b)"),
    ("double", "l2*b'' + l1*a''*cos(a-b) - l1*a'^2*sin(a-b) + g*sin(a) = 0", Slip.COORDINATE, "force", "g*sin(b)"),
    ("double", "l2*b'' + l1*a''*cos(a-b) - l2*a'^2*sin(a-b) + g*sin(b) = 0", Slip.PARAMETER, "velocity", "l1*a'^2"),
    ("double", "l2*b'' + l1*a'' - l1*a'^2*sin(a-b) + g*sin(b) = 0", Slip.SMALL_ANGLE, "inertia", "cos(a - b)"),
    ("double", "l2*b'' + l1*a''*cos(a-b) + g*sin(b) = 0", Slip.MISSING, "velocity", "is missing"),
    (
        "double",
        "m1*l1*a'' + m2*l2*b''*cos(a-b) + m2*l2*b'^2*sin(a-b) + (m1+m2)*g*sin(a) = 0",
        Slip.MISSING,
        "inertia",
        "m2*l1*a'' is missing",
    ),
    (
        "double",
        "(m1+m2)*l1*a'' + m2*l2*b''*cos(a-b) + m2*l2*b'^2*sin(a-b) + m1*g*sin(a) = 0",
        Slip.MISSING,
        "force",
        "is missing",
    ),
    (
        "double",
        "(m1+m2)*l1*a'' + m2*l2*b''*cos(a-b) + m2*l2*b'*sin(a-b) + (m1+m2)*g*sin(a) = 0",
        Slip.POWER,
        "velocity",
        "b'",
    ),
    (
        "double",
        "(m1+m2)*l1*a'' + m2*l2*b''*sin(a-b) + m2*l2*b'^2*sin(a-b) + (m1+m2)*g*sin(a) = 0",
        Slip.FUNCTION,
        "inertia",
        "cos(a - b)",
    ),
    ("spring", "m*r'' - m*r*theta'^2 + k*r - m*g*cos(theta) = 0", Slip.MISSING, "force", "-k*l is missing"),
    ("spring", "m*r'' - m*r*theta'^2 - k*(r - l) - m*g*cos(theta) = 0", Slip.SIGN, "force", "the term k*(r - l)"),
    (
        "spring",
        "m*r'' = m*r*theta'^2 + k*(r - l) + m*g*cos(theta)",
        Slip.SIGN,
        "force",
        "the sign of the term k*(r - l)",
    ),
    ("coupled", "m*x'' + k*x - c*(x - y) = 0", Slip.SIGN, "force", "the sign of the term c*(x - y)"),
    ("coupled", "m*x'' + k*x + 2*c*(x - y) = 0", Slip.FACTOR, "force", "c*(x - y) in place of 2*c*(x - y)"),
    ("spring", "m*r'' + k*(r - l) - m*g*cos(theta) = 0", Slip.MISSING, "velocity", "is missing"),
    ("spring", "m*r'' - m*r*theta'^2 + k*(r - l) - m*g*sin(theta) = 0", Slip.FUNCTION, "force", "cos(theta)"),
    ("spring", "r*theta'' + r'*theta' + g*sin(theta) = 0", Slip.FACTOR, "velocity", "a factor 2 is missing"),
    ("spring", "r*theta'' + 2*r'*theta' + g/r*sin(theta) = 0", Slip.FACTOR, "force", "r"),
    ("spring", "r*theta'' + 2*r'*theta'^2 + g*sin(theta) = 0", Slip.POWER, "velocity", "theta'"),
    ("damped", "m*x'' - c*x' + k*x = F*cos(omega*t)", Slip.SIGN, "velocity", "the sign of the term c*x'"),
    ("damped", "m*x'' + c*x' + k*x = 0", Slip.MISSING, "force", "is missing"),
    (
        "damped",
        "m*x'' + c*x' + k*x = F*sin(omega*t)",
        Slip.FUNCTION,
        "force",
        "F*cos(omega*t) in place of F*sin(omega*t)",
    ),
    ("damped", "m*x'' + c*x + k*x = F*cos(omega*t)", Slip.DOT, "force", "c*x' in place of c*x"),
    ("damped", "m*x'' + c*x' + k*x^2 = F*cos(omega*t)", Slip.FACTOR, "force", "divided by x"),
    ("damped", "x'' + c*x' + k*x/m = F/m*cos(omega*t)", Slip.FACTOR, "velocity", "divided by m"),
    ("coupled", "m*x'' + k*x + c*(x + y) = 0", Slip.SIGN, "force", "the sign of the term c*y"),
    ("coupled", "m*x'' + k*x + c*x = 0", Slip.MISSING, "force", "-c*y is missing"),
    ("coupled", "m*x'' + k*x - c*y = 0", Slip.MISSING, "force", "c*x is missing"),
    ("rolling", "m*s'' = m*g*sin(alpha)", Slip.MISSING, "inertia", "I*s''/R^2 is missing"),
    ("rolling", "(m + I)*s'' = m*g*sin(alpha)", Slip.FACTOR, "inertia", "divided by R^2"),
    ("rolling", "(m + I/R^2)*s'' = m*g*cos(alpha)", Slip.FUNCTION, "force", "sin(alpha)"),
    ("hoop", "R*theta'' + R*omega^2*sin(theta)*cos(theta) + g*sin(theta) = 0", Slip.SIGN, "force", "the sign"),
    ("hoop", "R*theta'' - omega^2*sin(theta)*cos(theta) + g*sin(theta) = 0", Slip.FACTOR, "force", "R"),
    ("hoop", "R*theta'' - R*omega^2*sin(theta) + g*sin(theta) = 0", Slip.FACTOR, "force", "cos(theta)"),
    ("hoop", "R*theta'' + g*sin(theta) = 0", Slip.MISSING, "force", "is missing"),
    ("ladder", "4*l*theta'' = 3*g*sin(theta)", Slip.FUNCTION, "force", "3*g*cos(theta)"),
    ("ladder", "4*l*theta'' = 3*g", Slip.SMALL_ANGLE, "force", "cos(theta)"),
    ("ladder", "l*theta'' = 3*g*cos(theta)", Slip.FACTOR, "force", "a factor 4 too many"),
    ("sphere", "l*theta'' - l*phi'^2*cos(theta) + g*sin(theta) = 0", Slip.FACTOR, "velocity", "sin(theta)"),
    ("sphere", "l*theta'' - l*phi'^2*sin(theta)*cos(theta) + g*cos(theta) = 0", Slip.FUNCTION, "force", "g*sin(theta)"),
]


@cache
def system(key: str) -> Reference:
    coordinates, parameters, equations = SYSTEMS[key]
    text = f"title: T\nparameters: [{parameters}]\ncoordinates: [{coordinates}]\nequations: {equations}\n"
    return reference(read_problem(Source("problem.yaml", text)))


@pytest.mark.parametrize(("key", "equation", "slip", "group", "words"), TABLE, ids=[r[1] for r in TABLE])
def test_the_table(key: str, equation: str, slip: Slip | None, group: str | None, words: str) -> None:
    found = check_equations([Fragment.of(equation)], system(key))
    assert found.equations[0].verdict is Verdict.WRONG
    assert words in found.equations[0].diagnosis
    [candidate] = system(key).candidates
    change = diagnosed(
        candidate.read(read_answer(Fragment.of(equation), system(key).scope).components[0]), candidate.system
    )
    if slip is not None:
        assert change is not None
        assert change.slip is slip
        assert change.group is Group(group)


@pytest.mark.parametrize(
    ("key", "equation"), [r[:2] for r in TABLE if r[2] is not None], ids=[r[1] for r in TABLE if r[2]]
)
def test_the_change_makes_the_equation_right(key: str, equation: str) -> None:
    """By solving: with the accelerations that the system gives, the changed equation is zero at rational states."""
    [candidate] = system(key).candidates
    wrong = candidate.read(read_answer(Fragment.of(equation), system(key).scope).components[0])
    change = diagnosed(wrong, candidate.system)
    assert change is not None
    right = wrong * change.times - (change.term or 0) + (change.right or 0)
    accelerations = candidate.configuration.slots.accelerations
    solved = sp.solve(candidate.system.equations, accelerations, dict=True)[0]
    for e, zero in ((right, True), (wrong, False)):
        symbols = sorted(e.xreplace(solved).free_symbols, key=str)
        values = {s: sp.Rational(n + 3, 2 * n + 5) for n, s in enumerate(symbols)}
        value = sp.sympify(e.xreplace(solved).xreplace(values)).evalf(40)
        assert bool(abs(value) < 1e-30) is zero


def turned_spring() -> Reference:
    text = "title: T\nparameters: [b, g]\ncoordinates: [s, phi]\nequations: "
    equations = ["s'' = s*phi'^2 - g*cos(b)", "s*phi'' + 2*s'*phi' = 0"]
    return reference(read_problem(Source("problem.yaml", f"{text}{equations}\n")))


@pytest.mark.parametrize(
    ("equation", "words"),
    [
        (
            "s'' = s*phi'^2 - g*sqrt(1 - sin(b)^2)",
            "Something is wrong in its terms without velocities and accelerations; the others are right.",
        ),
        ("s'' = abs(s)*phi'^2 - g*cos(b)", "Something is wrong in its terms with velocities; the others are right."),
    ],
)
def test_a_root_is_not_right_on_one_branch(equation: str, words: str) -> None:
    """It may be on the right branch at a state or two: then what differs seemed to be something else, or a sign."""
    for _ in range(12):
        [found] = check_equations([Fragment.of(equation)], turned_spring()).equations
        assert words in found.diagnosis
        assert "measured" not in found.diagnosis


NOTHING = "it does not follow from the equations of motion"
IN_FORCES = "Something is wrong in its terms without velocities and accelerations; the others are right."
IN_VELOCITIES = "Something is wrong in its terms with velocities; the others are right."
IN_INERTIA = "Something is wrong in its terms with accelerations; the others are right."
IN_MOTION = (
    "What the forces contribute to it is right, and not its terms with accelerations and with velocities: look at the "
    "kinetic energy."
)


@pytest.mark.parametrize(
    ("key", "equation", "said"),
    [
        ("pendulum", "theta'' - 3*(g/l)*cos(theta)^3 = 0", IN_FORCES),
        ("hoop", "R*theta'' - R*omega^2*sin(theta) + g*cos(theta) = 0", IN_FORCES),
        ("coupled", "m*x'' + 2*k*x + c*(x + y) = 0", IN_FORCES),
        ("kepler", "r*phi'' - r'*phi' + phi'^2 = 0", IN_VELOCITIES),
        ("pendulum", "theta'' + theta'^2*sin(theta) + theta'*cos(theta) + g/l*sin(theta) = 0", IN_VELOCITIES),
        # Scaled so that the accelerations agree, its forces would differ; but they are right, and the inertia is wrong.
        ("atwoodI", "(m1 - m2 - I/R^2)*x'' = (m1 - m2)*g", IN_INERTIA),
        # Two wrong signs on the one scale, and two others on the other.
        ("double", "l2*b'' + l1*a''*cos(a-b) + l1*a'^2*sin(a-b) - g*sin(b) = 0", NOTHING),
        ("cart", "(M-m)*x'' - m*l*theta''*cos(theta) - m*l*theta'^2*sin(theta) = 0", NOTHING),
        # Wrong in two groups.
        ("atwoodI", "(m1 + m2)*x'' = (m1 + m2)*g", NOTHING),
        ("damped", "2*m*x'' + c*x' + 3*k*x = F*cos(omega*t)", NOTHING),
        ("spring", "r*theta'' + r'*theta' - g*sin(theta) = 0", NOTHING),
        # No velocities occur, and two terms with velocities are missing.
        ("drag", "m*x'' + k*x = 0", "Its terms are right, but terms with velocities are missing."),
    ],
)
def test_a_group_is_named_only_if_the_others_are_right(key: str, equation: str, said: str) -> None:
    [found] = check_equations([Fragment.of(equation)], system(key)).equations
    assert found.diagnosis == said


def test_a_wrong_kinetic_energy_beside_right_forces() -> None:
    """The speed of a bead on a cycloid taken as a phi'."""
    [found] = check_equations([Fragment.of("a*phi'' + g*sin(phi) = 0")], reference_of("cycloidal-pendulum")).equations
    assert found.diagnosis == IN_MOTION


def test_a_given_motion_makes_terms_without_velocities() -> None:
    """With the sine of the latitude for its cosine what looks like a force comes from T."""
    wrong = "A*theta'' + C*(psi' + Omega*sin(lat)*cos(theta))*Omega*sin(lat)*sin(theta)"
    wrong += " - A*Omega^2*sin(lat)^2*sin(theta)*cos(theta) = 0"
    [found] = check_equations([Fragment.of(wrong)], reference_of("gyrocompass")).equations
    assert "forces" not in found.diagnosis


def test_a_change_into_a_term_that_vanishes_explains_nothing() -> None:
    """h'' = 0 follows, so that any term may be replaced by a multiple of it."""
    [found] = check_equations([Fragment.of("M*X'' + m*X'' + m*h'' = F + M*X''*cos(X)")], system("lifted")).equations
    assert found.diagnosis.endswith("the term M*X''*cos(X) does not belong there.")


def test_a_missing_term_is_preferred_to_an_odd_factor() -> None:
    """F = m s''/2 holds as well, so that 3 F in place of F would also be right."""
    equations = "[\"m*s'' = m*g*sin(alpha) - F\", \"m*s''/2 = F\"]"
    text = f"title: T\nparameters: [m, g, alpha]\ncoordinates: [s]\nunknowns: [F]\nequations: {equations}\n"
    rolling = reference(read_problem(Source("problem.yaml", text)))
    [found] = check_equations([Fragment.of("F = m*g*sin(alpha)")], rolling).equations
    assert found.diagnosis.endswith("m*s'' is missing on its left side.")


def test_several_slips_are_not_explained_away() -> None:
    found = check_equations([Fragment.of("3*theta'' + theta'^2 = m*g*cos(theta)^2")], system("pendulum"))
    assert "One change" not in found.equations[0].diagnosis


UNITS = "{m: {unit: kg}, l: {unit: m}, g: {unit: m/s^2}}"


@cache
def measured(equations: str = "[\"m*l^2*theta'' + m*g*l*sin(theta) = 0\"]") -> Reference:
    text = f"title: T\nparameters: {UNITS}\ncoordinates: [theta]\nequations: {equations}\n"
    return reference(read_problem(Source("problem.yaml", text)))


def test_a_sum_inside_a_term_is_looked_into() -> None:
    m, l, x = sp.symbols("m l x", positive=True)
    found = mismatch([x * (m + l)], {m: "kg", l: "m", x: "1"})
    assert found is not None
    assert {found.term, found.other} == {m, l}


# Hints


def said(*arguments: str) -> str:
    """What is printed, its long lines put together again."""
    shown = CliRunner().invoke(main, ["check", "ex11-ideal-pendulum", *arguments], env={"COLUMNS": "200"}).stdout
    return re.sub(r"\n {6}(?! )", " ", shown)


# -- parameters with numbers -------------------------------------------------------------------------------------------

WITH_VALUES = """
title: Double pendulum
parameters: {m: positive, g: positive, l: {assume: positive, value: 1}, L: {assume: positive, value: 2}}
coordinates: [phi, psi]
let: {out: sin(phi)*i + cos(phi)*j, further: sin(psi)*i + cos(psi)*j}
particles: {A: {mass: m, position: L*out}, B: {mass: m, position: L*out + l*further}}
gravity: g*j
"""


@pytest.mark.parametrize(
    ("velocities", "said"),
    [
        ("- l*psi'^2*sin(phi - psi)", "the sign of the term l*psi'^2*sin(phi - psi)"),
        ("- psi'^2*sin(phi - psi)", "the sign of the term psi'^2*sin(phi - psi)"),
        ("+ 2*l*psi'^2*sin(phi - psi)", "l*psi'^2*sin(phi - psi) in place of 2*l*psi'^2*sin(phi - psi)"),
        ("+ L*psi'^2*sin(phi - psi)", "L*psi'^2*sin(phi - psi)/2 in place of L*psi'^2*sin(phi - psi)"),
        ("+ l*psi'^2*cos(phi - psi)", "l*psi'^2*sin(phi - psi) in place of l*psi'^2*cos(phi - psi)"),
        ("+ l*psi'^2*sin(phi - psi) + m*L*cos(psi)", "the term m*L*cos(psi) does not belong there"),
    ],
)
def test_a_term_is_named_as_it_was_written(velocities: str, said: str) -> None:
    """The file gives l = 1 and L = 2; the answer has letters, and so has the feedback."""
    answer = Fragment.of(f"2*L*phi'' + l*psi''*cos(phi - psi) {velocities} + 2*g*sin(phi) = 0")
    found = check_answer(read_problem(Source("problem", WITH_VALUES)), (answer,))
    assert said in found.equations.equations[0].diagnosis


SHAKEN = """
title: A pendulum whose support is moved up and down
parameters: [m, l, g]
functions: {h: [t]}
coordinates: [theta]
particles: {P: {mass: m, position: l*sin(theta)*i + (h - l*cos(theta))*j}}
gravity: -g*j
"""


def test_nothing_is_called_coriolis_where_a_support_is_accelerated() -> None:
    """m l h' θ' sin θ in T gives h'' sin θ alone, which is no term with velocities either."""
    problem = read_problem(Source("problem.yaml", SHAKEN))
    for equation, said in (
        ("l*theta'' + (g - h'')*sin(theta) = 0", "with the wrong sign of the terms of T that are linear in"),
        ("l*theta'' + (g + h')*sin(theta) = 0", "wrong in its terms with velocities or derivatives of a given motion;"),
    ):
        [found] = check_answer(problem, (Fragment.of(equation),)).equations.equations
        assert said in found.diagnosis


@pytest.mark.parametrize(
    ("problem", "stated", "said"),
    [
        ("shortening-pendulum", "T = m*g*cos(phi) + m*l*phi'^2 + m*l''", "the sign of the term m*l''"),
        (
            "ladder-leaves-the-wall",
            "x'' = l*cos(theta)*theta''; 4*l*theta'' = 3*g*sin(theta)",
            "l*theta'^2*sin(theta) is missing",
        ),
    ],
)
def test_one_term_of_a_reaction_or_of_a_constraint(problem: str, stated: str, said: str) -> None:
    assert said in feedback_on(problem, stated)


@pytest.mark.parametrize(
    ("problem", "stated", "said"),
    [
        ("fall-through-air", "m*y'' = m*g - c*y'", "a factor abs(y') is missing"),
        (
            "two-body-problem",
            "X'' = 0;Y'' = 0;u'' = -G*(m1 + m2)*u/(u^2 + v^2);v'' = -G*(m1 + m2)*v/(u^2 + v^2)",
            "-(m1 + m2)*G*u/(u^2 + v^2)^(3/2) in place of -(m1 + m2)*G*u/(u^2 + v^2) (divided by sqrt(u^2 + v^2))",
        ),
    ],
)
def test_a_speed_or_a_distance_may_be_the_factor(problem: str, stated: str, said: str) -> None:
    assert said in feedback_on(problem, stated)


def test_a_factor_of_the_only_acceleration_is_not_said_beside_a_cause() -> None:
    said = feedback_on("ex14-two-particles", "m1*x1'' = lambda_rod*(x1 - x2)")
    assert "half of the reaction" in said
    assert "in place of m1*x1''" not in said
