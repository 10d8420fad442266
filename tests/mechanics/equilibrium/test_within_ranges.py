"""Acute angles and ranges: what they decide, and which equilibria they leave out."""

from __future__ import annotations

import math

import pytest

from lagrange.core.diagnostics import Source
from lagrange.explain.report import Report, report
from lagrange.mechanics.equilibrium.stability import StabilityVerdict
from lagrange.problem.loader import read_problem
from lagrange.render import terminal
from lagrange.render.json import as_object
from tests.support.problem_texts import places

PENDULUM = """title: Pendulum
axes: {{i: right, j: down}}
parameters: {{m: positive, l: positive, g: positive{more}}}
coordinates: {{theta: {{range: {range}}}}}
particles: {{P: {{mass: m, position: l*sin(theta)*i + l*cos(theta)*j}}}}
gravity: g*j
forces: {forces}
find: equilibrium
"""
SPRING = """title: Mass on a spring
axes: {{j: down}}
parameters: {{m: {{value: 1 kg}}, g: {{value: 10 m/s^2}}, k: {{value: {k}}}, a: {{value: 1 m}}}}
coordinates: {{x: {{range: {range}, unit: m}}}}
particles: {{P: {{mass: m, position: x*j}}}}
gravity: g*j
forces: {{s: {{potential: k*x^2/2}}}}
find: equilibrium
"""


def solved(text: str) -> Report:
    result = report(read_problem(Source("p.yaml", text)))
    assert result.holds, result.shortcomings
    return result


def equilibria(result: Report) -> list[list[str]]:
    found: list[list[str]] = as_object(result)["equilibrium"]
    return found


@pytest.mark.parametrize(
    ("limits", "inside"),
    [
        ("[-90 deg, 90 deg]", ["theta = 0"]),
        ("[90 deg, 270 deg]", ["theta = pi"]),
        ("[-180 deg, 180 deg]", ["theta = 0", "theta = pi"]),
        ("[-pi/3, 4*pi/3]", ["theta = 0", "theta = pi"]),
        ("[10 deg, 200 deg]", ["theta = pi"]),
        ("[-3, 3]", ["theta = 0"]),
        ("[1, 2]", []),
        ("[0, pi]", ["theta = 0", "theta = pi"]),
        ("[2*pi, 3*pi]", ["theta = 0", "theta = pi"]),  # modulo 2π
    ],
)
def test_equilibria_outside_of_the_range_are_left_out(limits: str, inside: list[str]) -> None:
    result = solved(PENDULUM.format(more="", range=limits, forces="{}").replace("forces: {}\n", ""))
    assert [e for [e] in equilibria(result)] == inside
    text = terminal.text(result.derivation, result.notation, 200)
    assert ("outside of the range" in text) == (len(inside) < 2)
    left_out = as_object(result).get("equilibrium_outside_ranges", [])
    assert len(left_out) + len(inside) == 2


def test_a_range_settles_the_stability() -> None:
    text = PENDULUM.format(more=", F: positive", range="[-90 deg, 90 deg]", forces="{push: {on: P, vector: F*i}}")
    result = solved(text)
    assert result.solution.own.stability is not None
    [verdict] = result.solution.own.stability.verdicts
    assert verdict.verdict is StabilityVerdict.STABLE
    without = solved(text.replace("{theta: {range: [-90 deg, 90 deg]}}", "[theta]"))
    assert without.solution.own.stability is not None
    assert without.solution.own.stability.verdicts[0].verdict is StabilityVerdict.CONDITIONAL


@pytest.mark.parametrize(("k", "limits", "number"), [("50 N/m", "[0, a]", 1), ("5 N/m", "[0, a]", 0),
                                                     ("50 N/m", "[0, 10 cm]", 0), ("5 N/m", "[1, 3]", 1)])  # fmt: skip
def test_lengths_within_their_range(k: str, limits: str, number: int) -> None:
    result = solved(SPRING.format(k=k, range=limits))
    found = as_object(result).get("equilibrium_in_numbers", [])
    assert len(found) == number
    if found:
        assert math.isclose(found[0]["coordinates"]["x"]["number"], 10 / float(k.split()[0]))


def test_a_range_that_depends_on_a_parameter_is_a_condition() -> None:
    result = solved(SPRING.format(k="50 N/m", range="[0, a]"))
    assert as_object(result)["equilibrium_conditions"] == [["a*k >= m*g"]]


def test_the_conditions_of_a_branch_tell_on_which_side_it_lies() -> None:
    """On a table that turns, (k − m w²) r = k l for r > 0; k l/(m w² − k) has r < 0 where k > m w²."""
    result = solved("""title: Mass on a turning table
parameters: {m: positive, k: positive, l: positive, w: positive}
coordinates: {r: {range: [0, 10]}}
particles: {P: {mass: m, position: r*cos(w*t)*i + r*sin(w*t)*j}}
forces: {s: {spring: k, between: [O, P], length: l}}
find: linearization
""")
    [branch] = result.solution.own.linearization.branches
    assert [str(r.rhs) for r in branch.relations] == ["k*l/(k - m*w**2)"]
    conditions = {f"{c.lhs} {c.relation} {c.rhs}" for c in branch.conditions}
    assert conditions == {"k > m*w**2", "10*k ≥ k*l + 10*m*w**2"}


@pytest.mark.parametrize("assume", ["acute", "{range: [1 deg, 89 deg]}"])
def test_an_acute_angle_needs_no_conditions(assume: str) -> None:
    text = f"""title: Block on a wedge
axes: {{i: right, j: up}}
parameters: {{m: positive, g: positive, mu: positive, alpha: {assume}}}
coordinates: [s, n]
particles: {{P: {{mass: m, position: "(s*cos(alpha) + n*sin(alpha))*i + (n*cos(alpha) - s*sin(alpha))*j"}}}}
constraints: {{plane: {{equation: n = 0, reaction: N}}}}
gravity: -g*j
forces: {{rub: {{friction: mu, constraint: plane, on: P}}}}
"""
    page = terminal.text(*(lambda r: (r.derivation, r.notation))(solved(text)), 100)
    assert "|cos α|" not in page
    assert "|cos α|" in terminal.text(
        *(lambda r: (r.derivation, r.notation))(solved(text.replace(assume, "positive"))), 100
    )


@pytest.mark.parametrize(
    ("declared", "code"),
    [
        ("parameters: {a: {range: [1]}}\ncoordinates: [x]", "bad-range"),
        ("parameters: {a: {range: [2, 1]}}\ncoordinates: [x]", "bad-range"),
        ("parameters: {a: {range: [-2, -1], assume: positive}}\ncoordinates: [x]", "bad-range"),
        ("parameters: {a: {range: [0 m, 1 kg], unit: m}}\ncoordinates: [x]", "unit-mismatch"),
        ("parameters: {a: {range: [0, 1], value: 2}}\ncoordinates: [x]", "value-against-assumption"),
        ("parameters: {a: {assume: acute, value: 100 deg}}\ncoordinates: [x]", "value-against-assumption"),
        ("parameters: [l]\ncoordinates: {x: {range: [0, q]}}", "unknown-symbol"),
        ("parameters: {l: acut}\ncoordinates: [x]", "unknown-assumption"),
    ],
)
def test_ranges_that_cannot_be_used(declared: str, code: str) -> None:
    assert [found for found, *_ in places(f"title: T\n{declared}\n")] == [code]


def test_an_answer_in_letters_is_right_whatever_the_values() -> None:
    """With P = 150 N > k l the stated branch has no position, and the answer in letters is right all the same."""
    solved(
        "title: Column\naxes: {j: up}\ncoordinates: [theta]\nfind: equilibrium\n"
        "parameters: {k: {value: 200 N/m}, l: {value: 50 cm}, P: {value: 150 N}}\n"
        "particles: {A: {position: l*sin(theta)*i + l*cos(theta)*j}}\n"
        "forces: {load: {on: A, vector: -P*j}, spring: {potential: k*l^2*sin(theta)^2/2}}\n"
        'answers: {equilibrium: [["theta = 0"], ["theta = pi"], ["cos(theta) = P/(k*l)"]]}\n'
    )
