"""Reactions that an answer states, and what a stated reaction is taken for."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace

import pytest
import sympy as sp

from lagrange.answers import reactions as stated
from lagrange.answers.equations import Verdict, check_equations
from lagrange.answers.examiner import check_answer
from lagrange.answers.questions.own_answers import compared_answers
from lagrange.answers.references import reference_of_solution
from lagrange.core.diagnostics import Fragment
from lagrange.explain.report import report
from lagrange.mechanics.results import Solution
from lagrange.mechanics.solution import solve
from lagrange.problem.model import Problem
from lagrange.render import terminal

Read = Callable[[str], Problem]
PENDULUM = """parameters: [m, l, g]
coordinates: [x, y]
particles: {P: {mass: m, position: '[x, y]'}}
constraints: {rod: {equation: x^2 + y^2 = l^2, reaction: T}}
gravity: '[0, g]'
generalized_coordinates: {angle: {coordinates: [theta], substitute: {x: l*sin(theta), y: l*cos(theta)}}}
"""


def solution(problem: Read, text: str) -> Solution:
    return solve(problem(f"title: Example\n{text}"))


@pytest.mark.parametrize(
    ("stated", "verdict"),
    [
        ("m*g*cos(theta) + m*l*theta'^2", "equivalent"),
        ("m*(x'^2 + y'^2 + g*y)/l", "equivalent"),
        ("-(m*g*cos(theta) + m*l*theta'^2)/(2*l)", "equivalent"),  # the multiplier
        ("T = m*g*cos(theta) + m*l*theta'^2", "equivalent"),
        ("m*g*cos(theta) - m*l*theta'^2", "wrong"),
        ("m*g*cos(theta)", "wrong"),
        ("2*(m*g*cos(theta) + m*l*theta'^2)", "wrong"),
        ("[0, 1]", "unreadable"),
        (r"m g \\cos\\theta + m l \\dot\\theta^2", "equivalent"),  # in YAML's quotes a backslash is written twice
        (r"T = m g \\cos\\theta + m l \\dot\\theta^2", "equivalent"),
        (r"T = m g \\cos\\theta", "wrong"),
    ],
)
def test_stated_reactions(problem: Read, stated: str, verdict: str) -> None:
    found = solution(problem, f'{PENDULUM}answers: {{reactions: {{rod: "{stated}"}}}}\n')
    assert [(a.name, a.verdict.value) for a in compared_answers(found)] == [("reactions", verdict)]


OPPOSITE = "a force that pushes"
MULTIPLIER = "the multiplier"


@pytest.mark.parametrize(
    ("stated", "taken_for"),
    [
        ("m*g*cos(theta) + m*l*theta'^2", ""),
        ("T = m*g*cos(theta) + m*l*theta'^2", ""),
        ("-(m*g*cos(theta) + m*l*theta'^2)", OPPOSITE),
        ("T = -m*g*cos(theta) - m*l*theta'^2", OPPOSITE),
        ("-(m*g*cos(theta) + m*l*theta'^2)/(2*l)", MULTIPLIER),
        ("T = -(m*g*cos(theta) + m*l*theta'^2)/(2*l)", MULTIPLIER),
    ],
)
def test_the_remark_says_what_a_stated_reaction_is_taken_for(problem: Read, stated: str, taken_for: str) -> None:
    """Of two contradictory statements, at most one is right without a remark."""
    found = solution(problem, f'{PENDULUM}answers: {{reactions: {{rod: "{stated}"}}}}\n')
    [answer] = compared_answers(found)
    [said] = answer.equations
    assert (said.verdict, len(said.remarks)) == (Verdict.EQUIVALENT, 1 if taken_for else 0)
    assert taken_for in "".join(said.remarks)
    shown = report(problem(f'title: Example\n{PENDULUM}answers: {{reactions: {{rod: "{stated}"}}}}\n'))
    page = terminal.text(shown.derivation, shown.notation, 1000)
    assert ("In the answer for the rod constraint" in page) == bool(taken_for)


@pytest.mark.parametrize(
    ("stated", "verdict", "taken_for"),
    [
        ("T = m*g*r/l", Verdict.EQUIVALENT, ""),
        ("m*g", Verdict.EQUIVALENT, ""),
        ("T = -m*g", Verdict.EQUIVALENT, OPPOSITE),
        ("-m*g", Verdict.EQUIVALENT, OPPOSITE),
        ("T = 2*m*g", Verdict.WRONG, ""),
    ],
)
def test_at_rest_the_remark_says_it_too(problem: Read, stated: str, verdict: Verdict, taken_for: str) -> None:
    text = f"""parameters: [m, g, l, k]
coordinates: [r, x]
particles: {{P: {{mass: m, position: r*j}}, Q: {{position: x*i}}}}
constraints: {{rod: {{equation: r = l, reaction: T}}}}
gravity: g*j
forces: {{spring: {{potential: k*x^2/2}}}}
find: equilibrium
answers: {{reactions: {{rod: "{stated}"}}}}
"""
    [answer] = compared_answers(solution(problem, text))
    [said] = answer.equations
    assert (said.verdict, len(said.remarks)) == (verdict, 1 if taken_for else 0)
    assert taken_for in "".join(said.remarks)


@pytest.mark.parametrize(
    ("equations", "remarks"),
    [
        (("m*x'' = -T*x/l", "m*y'' = m*g - T*y/l"), ""),
        (("m*x'' = 2*T*x", "m*y'' = m*g + 2*T*y"), MULTIPLIER),
        (("m*x'' = T*x/l", "m*y'' = m*g + T*y/l"), OPPOSITE),
        (("m*x'' = T*x/l", "m*y'' = m*g - T*y/l"), ""),
    ],
)
def test_equations_say_what_a_tension_is_taken_for(problem: Read, equations: tuple[str, ...], remarks: str) -> None:
    said = check_answer(problem(f"title: Example\n{PENDULUM}"), tuple(map(Fragment.of, equations))).equations
    for e in said.equations:
        assert [remarks in r for r in e.remarks] == ([True] if remarks else [])


@pytest.mark.parametrize(
    ("equations", "verdict"),
    [
        (("m*x'' = -T*x/l", "m*y'' = m*g - T*y/l"), Verdict.EQUIVALENT),
        (("m*x'' = 2*T*x", "m*y'' = m*g + 2*T*y"), Verdict.EQUIVALENT),  # R = λ ∂f/∂r with λ called T
        (("m*x'' = T*x/l", "m*y'' = m*g + T*y/l"), Verdict.EQUIVALENT),  # a strut's thrust
        (("m*x'' = -T*x/l", "m*y'' = m*g + T*y/l"), Verdict.WRONG),
        (("m*x'' = -T*x", "m*y'' = m*g - T*y"), Verdict.WRONG),
        (("m*x'' = 2*lambda_rod*x", "m*y'' = m*g + 2*lambda_rod*y"), Verdict.EQUIVALENT),
        (("m*x'' = lambda_rod*x", "m*y'' = m*g + lambda_rod*y"), Verdict.WRONG),
        (("m*x'' = -T*x/l",), Verdict.INCOMPLETE),
        (("l*theta'' + g*sin(theta) = 0", "T = m*g*cos(theta) + m*l*theta'^2"), Verdict.EQUIVALENT),
        (("l*theta'' + g*sin(theta) = 0", "T = m*g*cos(theta)"), Verdict.WRONG),
    ],
)
def test_equations_with_a_tension(problem: Read, equations: tuple[str, ...], verdict: Verdict) -> None:
    reference = reference_of_solution(solution(problem, PENDULUM))
    assert check_equations([Fragment.of(e) for e in equations], reference).verdict is verdict


# -- names of other reactions ------------------------------------------------------------------------------------------

INCLINE = """parameters: [m, g, alpha]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
gravity: -g*j
"""
WRITINGS = [
    "y = -x*tan(alpha)",
    "-x*tan(alpha) = y",
    "x*sin(alpha) + y*cos(alpha) = 0",
    "-3*x*sin(alpha) = 3*y*cos(alpha)",
]


@pytest.mark.parametrize("writing", WRITINGS)
@pytest.mark.parametrize(
    ("stated", "verdict"),
    [
        ("m*g*cos(alpha)", Verdict.EQUIVALENT),
        ("N = m*g*cos(alpha)", Verdict.EQUIVALENT),
        ("N = -m*g*cos(alpha)", Verdict.EQUIVALENT),
        ("N = 2*m*g*cos(alpha)", Verdict.WRONG),
        ("N = m*g*sin(alpha)", Verdict.WRONG),
    ],
)
def test_the_normal_force_does_not_depend_on_the_writing(
    problem: Read, writing: str, stated: str, verdict: Verdict
) -> None:
    text = f"{INCLINE}constraints: {{plane: {{equation: '{writing}', reaction: N}}}}\n"
    [answer] = compared_answers(solution(problem, f"{text}answers: {{reactions: {{plane: '{stated}'}}}}\n"))
    assert answer.verdict is verdict


@pytest.mark.parametrize("writing", WRITINGS)
@pytest.mark.parametrize(
    ("stated", "verdict"),
    [("N = W*cos(alpha)", Verdict.EQUIVALENT), ("-W*cos(alpha)", Verdict.EQUIVALENT), ("N = W", Verdict.WRONG)],
)
def test_a_normal_force_at_rest(problem: Read, writing: str, stated: str, verdict: Verdict) -> None:
    text = f"""parameters: [W, alpha]
coordinates: [x, y]
particles: {{P: {{position: x*i + y*j}}}}
constraints: {{plane: {{equation: '{writing}', reaction: N}}}}
forces:
  weight: {{on: P, vector: -W*j}}
  pull: {{on: P, vector: P*(-cos(alpha)*i + sin(alpha)*j)}}
unknowns: [P]
find: equilibrium
answers: {{reactions: {{plane: '{stated}'}}}}
"""
    [answer] = compared_answers(solution(problem, text))
    assert answer.verdict is verdict


BLOCK = """parameters: [m, g, mu, F]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
constraints: {floor: {equation: y = 0, reaction: N}}
gravity: -g*j
forces:
  push: {on: P, vector: F*i}
  rub: {friction: mu, constraint: floor, on: P, slip: positive, contact: positive}
"""


@pytest.mark.parametrize(
    ("stated", "verdict", "remarked"),
    [
        ("m*x'' = F - mu*N; N = m*g", Verdict.EQUIVALENT, False),
        ("m*x'' = F - mu*abs(N); N = m*g", Verdict.EQUIVALENT, False),
        ("m*x'' = F + mu*N; N = -m*g", Verdict.EQUIVALENT, True),
        ("m*x'' = F - mu*abs(N); N = -m*g", Verdict.EQUIVALENT, True),
        ("m*x'' = F + mu*N; N = m*g", Verdict.WRONG, False),
        ("m*x'' = F - mu*N; N = -m*g", Verdict.WRONG, False),
        ("m*x'' = F + mu*abs(N); N = -m*g", Verdict.WRONG, False),
        ("m*x'' = F + mu*m*g", Verdict.WRONG, False),
    ],
)
def test_with_a_contact_given_the_name_may_be_the_opposite_force_too(
    problem: Read, stated: str, verdict: Verdict, remarked: bool
) -> None:
    """One meaning of N in the whole answer: with N along −j, μ|N| is −μ N."""
    judged = check_equations([Fragment.of(e) for e in stated.split("; ")], reference_of_solution(_block(problem)))
    assert judged.verdict is verdict
    remarks = [r for e in judged.equations for r in e.remarks]
    if verdict is Verdict.EQUIVALENT:
        assert any("`N` is taken along `-j` on `P`" in r for r in remarks) is remarked


_solved: list[Solution] = []


def _block(problem: Read) -> Solution:
    if not _solved:
        _solved.append(solution(problem, BLOCK))
    return _solved[0]


@pytest.mark.parametrize(("known", "expected"), [(True, Verdict.INCOMPLETE), (False, Verdict.WRONG)])
def test_reactions_beside_an_equilibrium_that_is_not_solved(
    known: bool, expected: Verdict, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The folded position of a three-hinged frame has no closed form: the position in which it is drawn decides."""
    branches = iter([stated._AtBranch([[known]], [False]), stated._AtBranch([[None]], [False])])
    monkeypatch.setattr(stated._AtBranch, "of", lambda *_: next(branches))
    configuration = SimpleNamespace(slots=SimpleNamespace(coordinates=()), expressed=(), rewritten=lambda e: e)
    reactions = SimpleNamespace(configuration=configuration, at=(None, None))
    reference = SimpleNamespace(values={}, scope=SimpleNamespace(slots=SimpleNamespace(coordinates=())))
    judge = SimpleNamespace(reference=reference, _possible=lambda reactions: reactions.at)
    assert stated.StatedReactionsAtRest._holds(judge, [sp.Symbol("A_x") + 1], {}, reactions, ()) is expected  # type: ignore[arg-type]


SPHERES = """parameters: {r: 20 cm, b: 70 cm, W: 100 N}
coordinates: [x_1, y_1, x_2, y_2]
particles: {lower: {position: x_1*i + y_1*j}, upper: {position: x_2*i + y_2*j}}
constraints:
  left: {equation: x_1 >= r, reaction: N_1}
  floor: {equation: y_1 >= r, reaction: N}
  right: {equation: x_2 <= b - r, reaction: N_2}
  contact: {equation: norm(r_upper - r_lower) >= 2*r, reaction: R}
forces: {w1: {on: lower, vector: -W*j}, w2: {on: upper, vector: -W*j}}
find: equilibrium
"""


@pytest.mark.parametrize(("stated", "verdict"), [("{N_1: 113.4, R: 151.2 N}", "equivalent"), ("{R: 150.2}", "wrong")])
def test_a_position_at_which_contacts_would_pull_does_not_count(problem: Read, stated: str, verdict: str) -> None:
    """The second sphere below the first satisfies the constraints as well."""
    found = solution(problem, f"{SPHERES}answers: {{reactions: {stated}}}\n")
    assert [a.verdict.value for a in compared_answers(found)] == [verdict]


PULLEY_ON_CABLE = """parameters: {a: 4 m, h: 1 m, L: 5 m, W: 90 N}
coordinates: {x: {range: [0, 4 m]}, y: {range: [-5 m, 0]}}
particles: {P: {position: x*i + y*j}}
constraints: {cable: {equation: "sqrt(x^2 + y^2) + sqrt((a - x)^2 + (h - y)^2) = L", reaction: T, by: string}}
forces: {weight: {on: P, vector: -W*j}}
find: equilibrium
"""


@pytest.mark.parametrize(
    ("stated", "verdicts"),
    [
        ("{equilibrium: [x = 4/3, y = -1], reactions: {T: 75 N}}", ["equivalent", "equivalent"]),
        ("{equilibrium: [x = 1.33], reactions: {T: 0.0751 kN}}", ["equivalent", "wrong"]),
    ],
)
def test_forces_and_places_found_in_numbers(problem: Read, stated: str, verdicts: list[str]) -> None:
    found = solve(problem(f"title: Pulley\n{PULLEY_ON_CABLE}answers: {stated}\n"))
    assert [a.verdict.value for a in compared_answers(found)] == verdicts
