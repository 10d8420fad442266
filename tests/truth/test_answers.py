"""Answers to shipped problems, right and wrong, with their verdicts by a second route (`answer_truth`)."""

from __future__ import annotations

from pathlib import Path

import pytest

from lagrange.answers.equations import Reference, check_equations
from lagrange.core.diagnostics import Fragment
from tests.support.answer_truth import RANGES, read, route, truth
from tests.support.paths import ROOT
from tests.support.shared import reference_of

EQUIVALENT, WRONG, INCOMPLETE = "equivalent", "wrong", "incomplete"

ANSWERS = [
    ("ex11", "l*theta'' = -g*sin(theta)", EQUIVALENT),
    ("ex11", "theta'' + g/l*sin(theta) + (sin(theta)^2 + cos(theta)^2 - 1)*theta'^2 = 0", EQUIVALENT),
    ("ex11", "m*l^2*theta''*cos(theta) + m*g*l*sin(theta)*cos(theta) = 0", EQUIVALENT),
    ("ex11", "theta'' - theta'^2*sin(theta) + g/l*sin(theta) = 0", WRONG),
    ("ex11", "theta'' + g/l*tan(theta) = 0", WRONG),
    ("ex11 in x, y", "y*x'' - x*y'' + g*x = 0", EQUIVALENT),
    ("ex11 in x, y", "x''*l^2 + g*x*y + x*(x'^2 + y'^2) = 0", EQUIVALENT),
    ("ex11 in x, y", "y''*l^2 - g*x^2 + y*(x'^2 + y'^2) = 0", EQUIVALENT),
    ("ex11 in x, y", "y''*l^2 - g*(l^2 - y^2) + y*(x'^2 + y'^2) = 0", EQUIVALENT),
    ("ex11 in x, y", "y''*l^2 + g*x^2 + y*(x'^2 + y'^2) = 0", WRONG),
    ("ex11 in x, y", "x'' + g*x/l = 0", WRONG),
    ("ex11 in x, y", "y*x'' + x*y'' = g*x", WRONG),
    ("ex11 in x, y", "m*x'' = 2*lambda_rod*x ; m*y'' = 2*lambda_rod*y + m*g", EQUIVALENT),
    ("ex11 in x, y", "m*x'' = 2*lambda_rod*x ; m*y'' = 2*lambda_rod*y - m*g", WRONG),
    ("ex11 in x, y", "m*x'' = lambda_rod*x ; m*y'' = lambda_rod*y + m*g", WRONG),
    ("ex11 in x, y", "x*x'' + y*y'' + x'^2 + y'^2 = 0", INCOMPLETE),
    ("ex11 in x, y", "m*(x'^2 + y'^2) + m*g*y + 2*l^2*lambda_rod = 0", INCOMPLETE),
    ("ex14", "m1*x1'' + m2*x2'' = 0 ; m1*y1'' + m2*y2'' = 0 ; m1*z1'' + m2*z2'' + (m1 + m2)*g = 0", INCOMPLETE),
    (
        "ex14",
        "m1*x1'' + m2*x2'' = 0 ; m1*y1'' + m2*y2'' = 0 ; m1*z1'' + m2*z2'' + (m1 + m2)*g = 0"
        " ; (x2 - x1)*(y2'' - y1'') = (y2 - y1)*(x2'' - x1'') ; (x2 - x1)*(z2'' - z1'') = (z2 - z1)*(x2'' - x1'')",
        EQUIVALENT,
    ),
    (
        "ex14",
        "m1*x1'' + m2*x2'' = 0 ; m1*y1'' + m2*y2'' = 0 ; m1*z1'' + m2*z2'' + (m1 + m2)*g = 0"
        " ; (x2 - x1)*(y2'' + y1'') = (y2 - y1)*(x2'' + x1'') ; (x2 - x1)*(z2'' + z1'') = (z2 - z1)*(x2'' + x1'')",
        WRONG,
    ),
    ("ex14", "2*l^2*(m1 + m2)*lambda_rod = -m1*m2*((x2' - x1')^2 + (y2' - y1')^2 + (z2' - z1')^2)", INCOMPLETE),
    ("ex14", "2*l^2*(m1 + m2)*lambda_rod = m1*m2*((x2' - x1')^2 + (y2' - y1')^2 + (z2' - z1')^2)", WRONG),
    ("ex15-rough-incline", "x'' = g*(sin(alpha) - mu*cos(alpha))", EQUIVALENT),
    ("ex15-rough-incline", "x''/cos(alpha) = g*(tan(alpha) - mu)", EQUIVALENT),
    ("ex15-rough-incline", "x'' = g*(sin(alpha) + mu*cos(alpha))", WRONG),
    ("ex15-rough-incline", "x'' = g*sin(alpha)", WRONG),
    ("ex15-rough-incline", "x'' = g*(sin(alpha) - mu)", WRONG),
    (
        "ex17",
        "r*theta'' + 2*r'*theta' - r*phi'^2*sin(theta)*cos(theta) = g*sin(theta)"
        " ; r*phi''*sin(theta) + 2*r'*phi'*sin(theta) + 2*r*theta'*phi'*cos(theta) = 0",
        EQUIVALENT,
    ),
    (
        "ex17",
        "(a + b*cos(omega*t))*theta'' - 2*b*omega*sin(omega*t)*theta' - (a + b*cos(omega*t))*phi'^2*sin(theta)*cos(theta)"
        " = g*sin(theta) ; phi''*sin(theta)*(a + b*cos(omega*t)) - 2*b*omega*sin(omega*t)*phi'*sin(theta)"
        " + 2*(a + b*cos(omega*t))*theta'*phi'*cos(theta) = 0",
        EQUIVALENT,
    ),
    (
        "ex17",
        "r*theta'' - r*phi'^2*sin(theta)*cos(theta) = g*sin(theta)"
        " ; r*phi''*sin(theta) + 2*r'*phi'*sin(theta) + 2*r*theta'*phi'*cos(theta) = 0",
        WRONG,
    ),
    ("ex17", "r*theta'' + 2*r'*theta' - r*phi'^2*sin(theta)*cos(theta) = g*sin(theta) ; r'' = -b*omega^2*cos(omega*t)",
     INCOMPLETE),
    ("ex17", "r'' = b*omega^2*cos(omega*t)", WRONG),
    ("ex17", "lambda_length = m*(r'' - r*theta'^2 - r*phi'^2*sin(theta)^2) + m*g*cos(theta)", INCOMPLETE),
    ("ex17", "lambda_length = m*(r'' - r*theta'^2 - r*phi'^2*sin(theta)^2) - m*g*cos(theta)", WRONG),
    (
        "ex18",
        "(m1 + m2*sin(phi1 - phi2)^2)*l1*phi1'' = -m2*l1*phi1'^2*sin(phi1 - phi2)*cos(phi1 - phi2)"
        " - m2*l2*phi2'^2*sin(phi1 - phi2) - (m1 + m2)*g*sin(phi1) + m2*g*sin(phi2)*cos(phi1 - phi2)"
        " ; l2*phi2'' + l1*phi1''*cos(phi1 - phi2) - l1*phi1'^2*sin(phi1 - phi2) + g*sin(phi2) = 0",
        EQUIVALENT,
    ),
    (
        "ex18",
        "(m1 + m2*sin(phi1 - phi2)^2)*l1*phi1'' = -m2*l1*phi1'^2*sin(phi1 - phi2)*cos(phi1 - phi2)"
        " - m2*l2*phi2'^2*sin(phi1 - phi2) - (m1 + m2)*g*sin(phi1) - m2*g*sin(phi2)*cos(phi1 - phi2)"
        " ; l2*phi2'' + l1*phi1''*cos(phi1 - phi2) - l1*phi1'^2*sin(phi1 - phi2) + g*sin(phi2) = 0",
        WRONG,
    ),
    (
        "ex18",
        "(m1 + m2)*l1*phi1'' + m2*l2*phi2''*cos(phi1 - phi2) + m2*l2*phi2'^2*sin(phi1 - phi2) + (m1 + m2)*g*sin(phi1) = 0"
        " ; l2*phi2'' + l1*phi1''*cos(phi1 - phi2) - l1*phi1'^2*sin(phi2 - phi1) + g*sin(phi2) = 0",
        WRONG,
    ),
    (
        "ex18",
        "m1*l1*phi1'' + m2*l2*phi2''*cos(phi1 - phi2) + m2*l2*phi2'^2*sin(phi1 - phi2) + (m1 + m2)*g*sin(phi1) = 0"
        " ; l2*phi2'' + l1*phi1''*cos(phi1 - phi2) - l1*phi1'^2*sin(phi1 - phi2) + g*sin(phi2) = 0",
        WRONG,
    ),
    ("ex18", "l2*phi2'' + l1*phi1''*cos(phi1 - phi2) - l1*phi1'^2*sin(phi1 - phi2) + g*sin(phi2) = 0", INCOMPLETE),
    (
        "bell-and-clapper",
        "(M*a^2 + I_1 + m*l^2)*alpha'' + m*l*b*beta''*cos(alpha - beta) = -m*l*b*beta'^2*sin(alpha - beta)"
        " - (M*a + m*l)*g*sin(alpha)"
        " ; (m*b^2 + I_2)*beta'' + m*l*b*(alpha''*cos(alpha - beta) - alpha'^2*sin(alpha - beta)) + m*g*b*sin(beta) = 0",
        EQUIVALENT,
    ),
    (
        "bell-and-clapper",
        "(M*a^2 + I_1)*alpha'' + m*l*b*(beta''*cos(alpha - beta) + beta'^2*sin(alpha - beta)) + (M*a + m*l)*g*sin(alpha) = 0"
        " ; (m*b^2 + I_2)*beta'' + m*l*b*(alpha''*cos(alpha - beta) - alpha'^2*sin(alpha - beta)) + m*g*b*sin(beta) = 0",
        WRONG,
    ),
    (
        "bell-and-clapper",
        "(M*a^2 + I_1 + m*l^2)*alpha'' + m*l*b*(beta''*cos(alpha - beta) - beta'^2*sin(alpha - beta))"
        " + (M*a + m*l)*g*sin(alpha) = 0",
        WRONG,
    ),
    (
        "heavy-top",
        "psi'' + phi''*cos(theta) - phi'*theta'*sin(theta) = 0"
        " ; (A + m*l^2)*(theta'' - phi'^2*sin(theta)*cos(theta)) + C*(psi' + phi'*cos(theta))*phi'*sin(theta) = m*g*l*sin(theta)"
        " ; (A + m*l^2)*(phi''*sin(theta) + 2*phi'*theta'*cos(theta)) = C*theta'*(psi' + phi'*cos(theta))",
        EQUIVALENT,
    ),
    (
        "heavy-top",
        "psi'' + phi''*cos(theta) - phi'*theta'*sin(theta) = 0"
        " ; (A + m*l^2)*(theta'' - phi'^2*sin(theta)*cos(theta)) + C*(psi' + phi'*cos(theta))*phi'*sin(theta) = m*g*l*sin(theta)"
        " ; (A + m*l^2)*(phi''*sin(theta) + phi'*theta'*cos(theta)) = C*theta'*(psi' + phi'*cos(theta))",
        WRONG,
    ),
    ("heavy-top", "psi'' + phi''*cos(theta) - phi'*theta'*sin(theta) = 0", INCOMPLETE),
    ("heavy-top", "psi'' + phi''*cos(theta) + phi'*theta'*sin(theta) = 0", WRONG),
    ("heavy-top", "A*theta'' = m*g*l*sin(theta) ; phi'' = 0 ; psi'' = 0", WRONG),
    (
        "rocking-half-cylinder",
        "(I_G + m*(R^2 + h^2 - 2*R*h*cos(theta)))*theta'' + m*R*h*theta'^2*sin(theta) + m*g*h*sin(theta) = 0",
        EQUIVALENT,
    ),
    (
        "rocking-half-cylinder",
        "(I_G + m*(R^2 + h^2 - 2*R*h*cos(theta)))*x'' + m*h*x'^2*sin(theta) + m*g*h*R*sin(theta) = 0",
        EQUIVALENT,
    ),
    (
        "rocking-half-cylinder",
        "(I_G + m*(R^2 + h^2 - 2*R*h*cos(theta)))*theta'' + m*g*h*sin(theta) = 0",
        WRONG,
    ),
    (
        "rocking-half-cylinder",
        "(I_G + m*(R^2 + h^2 + 2*R*h*cos(theta)))*theta'' + m*R*h*theta'^2*sin(theta) + m*g*h*sin(theta) = 0",
        WRONG,
    ),
    ("rocking-half-cylinder", "x'' = R*theta''", INCOMPLETE),
    (
        "sleigh",
        "x''*cos(theta) + y''*sin(theta) = a*theta'^2 ; (I_G + m*a^2)*theta'' = -m*a*theta'*(x'*cos(theta) + y'*sin(theta))",
        EQUIVALENT,
    ),
    ("sleigh", "x'' = a*theta'^2*cos(theta) - y'*theta' ; (I_G + m*a^2)*theta''*cos(theta) + m*a*theta'*x' = 0", EQUIVALENT),
    ("sleigh", "x'' = a*theta'^2*cos(theta) + y'*theta' ; (I_G + m*a^2)*theta''*cos(theta) + m*a*theta'*x' = 0", WRONG),
    ("sleigh", "x''*cos(theta) + y''*sin(theta) = a*theta'^2", INCOMPLETE),
    ("sleigh", "x''*cos(theta) + y''*sin(theta) = 0 ; (I_G + m*a^2)*theta'' = -m*a*theta'*(x'*cos(theta) + y'*sin(theta))",
     WRONG),
    ("sleigh", "I_G*theta'' = -m*a*theta'*(x'*cos(theta) + y'*sin(theta)) ; x''*cos(theta) + y''*sin(theta) = a*theta'^2", WRONG),
    (
        "sleigh",
        "m*(x'' - a*theta''*sin(theta) - a*theta'^2*cos(theta)) = -lambda_blade*sin(theta)"
        " ; m*(y'' + a*theta''*cos(theta) - a*theta'^2*sin(theta)) = lambda_blade*cos(theta) ; I_G*theta'' = -a*lambda_blade",
        EQUIVALENT,
    ),
    (
        "sleigh",
        "m*(x'' - a*theta''*sin(theta) - a*theta'^2*cos(theta)) = -lambda_blade*sin(theta)"
        " ; m*(y'' + a*theta''*cos(theta) - a*theta'^2*sin(theta)) = lambda_blade*cos(theta) ; I_G*theta'' = a*lambda_blade",
        WRONG,
    ),
    ("spring-pendulum", "r'' = r*phi'^2 - c*(r - l)/m + g*cos(phi) ; phi'' = -(2*r'*phi' + g*sin(phi))/r", EQUIVALENT),
    ("spring-pendulum", "r'' = r*phi'^2 - c*r/m + g*cos(phi) ; phi'' = -(2*r'*phi' + g*sin(phi))/r", WRONG),
    ("spring-pendulum", "r'' = r*phi'^2 - c*(r - l)/m + g*cos(phi) ; phi'' = -(r'*phi' + g*sin(phi))/r", WRONG),
    ("spring-pendulum", "r'' = r*phi'^2 - c*(r - l)/m + g*cos(phi) ; r'' + c*(r - l)/m = r*phi'^2 + g*cos(phi)", INCOMPLETE),
    (
        "spring-pendulum",
        "r''*cos(phi) - r*phi''*sin(phi) - r*phi'^2*cos(phi) - 2*r'*phi'*sin(phi) = g - c*(r - l)*cos(phi)/m"
        " ; r''*sin(phi) + r*phi''*cos(phi) - r*phi'^2*sin(phi) + 2*r'*phi'*cos(phi) = -c*(r - l)*sin(phi)/m",
        EQUIVALENT,
    ),
    ("wheel-suspension", "M*z1'' + m*z2'' + c_T*(z2 - u) = 0 ; M*z1'' = b*(z2' - z1') + c*(z2 - z1)", EQUIVALENT),
    ("wheel-suspension", "M*z1'' + m*z2'' + c_T*z2 = 0 ; M*z1'' = b*(z2' - z1') + c*(z2 - z1)", WRONG),
    ("wheel-suspension", "M*z1'' + m*z2'' + c_T*(z2 - u) = 0 ; M*z1'' = b*(z1' - z2') + c*(z2 - z1)", WRONG),
    ("wheel-suspension", "M*z1'' + m*z2'' + c_T*(z2 - u) = 0", INCOMPLETE),
]  # fmt: skip


def file_of(name: str) -> Path:
    """The shipped problem of a name such as `ex11 in x, y`."""
    word = name.split()[0]
    (found,) = (p for p in ROOT.glob("problems/*/*.yaml") if p.stem == word or p.stem.startswith(f"{word}-"))
    return found


def derived(name: str) -> Reference:
    """What answers to a shipped problem are compared with."""
    return reference_of(file_of(name))


def test_there_are_enough() -> None:
    assert len(ANSWERS) >= 60
    assert len({a for _, a, _ in ANSWERS}) == len(ANSWERS)


@pytest.mark.parametrize(("name", "answer", "expected"), ANSWERS)
def test_the_verdict_is_that_of_the_second_route(name: str, answer: str, expected: str) -> None:
    equations = [e.strip() for e in answer.split(";")]
    assert truth(route(name), [read(e) for e in equations], RANGES.get(name)) == expected
    found = check_equations([Fragment.of(e) for e in equations], derived(name))
    assert found.verdict.value == expected
