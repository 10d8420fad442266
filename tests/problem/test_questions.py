"""Reading the initial state and the questions.

Dimensions in the initial state and in questions.
"""

from __future__ import annotations

from collections.abc import Callable

import pytest
import sympy as sp

from lagrange.core.diagnostics import ProblemError
from lagrange.problem.model import Problem
from tests.support.problem_texts import readings

START = """
title: Example
parameters: [m, l, g, x_0]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
constraints: {rod: {equation: x^2 + y^2 = l^2, reaction: T}}
generalized_coordinates: {angle: {coordinates: [theta], substitute: {x: l*sin(theta), y: l*cos(theta)}}}
"""


def test_the_state_and_the_questions_are_read(problem: Callable[[str], Problem]) -> None:
    text = """
initial: {x: x_0, θ': 2*g/l}
ask:
  one: {quantity: T, when: theta = pi/2}
  two: {quantity: "T_kinetic + energy", when: ["x'' = 0", "t = 1"], by: theta}
answers: {ask: {one: T = 3*m*g}}
"""
    read = problem(START + text)
    assert [(v.symbol.name, str(v.value)) for v in read.initial] == [("x", "x_0"), ("theta'", "2*g/l")]
    one, two = read.questions
    assert (one.name, str(one.quantity), [str(c.function) for c in one.when], one.by) == (
        "one",
        "T",
        ["theta - pi/2"],
        None,
    )
    assert (len(two.when), two.by) == (2, sp.Symbol("theta", real=True))
    assert read.answers is not None
    assert read.answers.ask["one"].text == "T = 3*m*g"


def test_conditions_may_be_joined_by_and(problem: Callable[[str], Problem]) -> None:
    text = "ask: {one: {quantity: T, when: \"x'' = 0 and t = 0\"}, two: {quantity: T, when: [\"x'' = 0\", t = 0]}}\n"
    one, two = problem(START + text).questions
    assert [c.function for c in one.when] == [c.function for c in two.when]
    with pytest.raises(ProblemError) as caught:
        problem(START + "ask: {one: {quantity: T, when: x = 0 and z = 0}}\n")
    [error] = caught.value.diagnostics
    assert error.span is not None
    assert error.span.source.text[error.span.start : error.span.end] == "z"


def test_the_words_of_a_name_are_joined(problem: Callable[[str], Problem]) -> None:
    with pytest.raises(ProblemError) as caught:
        problem(START + "ask: {time of flight: {quantity: t, when: y = 0}}\n")
    assert caught.value.diagnostics[0].help == "write `time_of_flight`"


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("initial: {x: y}", "not-constant"),
        ("initial: {x'': 0}", "no-state"),
        ("initial: {2*x: 0}", "no-state"),
        ("initial: {x: 0, x : 1}", "duplicate-key"),
        ("initial: {z: 0}", "unknown-symbol"),
        ("ask: {a: {when: x = 0}}", "missing-key"),
        ("ask: {a: x}", "wrong-kind"),
        ("ask: {a: {quantity: x, wenn: y = 0}}", "unknown-key"),
        ("ask: {a: {quantity: N}}", "unknown-symbol"),
        ("ask: {a: {quantity: d(x)}}", "not-allowed-here"),
        ("ask: {a: {quantity: x, when: x}}", "no-equals-sign"),
        ("ask: {a: {quantity: x, when: [x' = 0, 't > 0']}}", "inequality"),
        ("ask: {a: {quantity: x, when: r_P = 0}}", None),
        ("ask: {a: {quantity: x, by: m}}", "no-variable"),
        ("ask: {a: {quantity: x}}\nanswers: {ask: {b: 1}}", "unknown-name"),
        ("ask: {a: {quantity: x}}\nanswers: {ask: {a: 2*q}}", "unknown-symbol"),
        ("ask: {" + ", ".join(f"a{n}: {{quantity: x}}" for n in range(21)) + "}", "too-many-questions"),
    ],
)
def test_a_mistake_is_an_error_with_its_place(text: str, code: str | None, problem: Callable[[str], Problem]) -> None:
    with pytest.raises(ProblemError) as error:
        problem(f"{START}{text}\n")
    assert all(d.span is not None for d in error.value.diagnostics)
    assert code is None or code in [d.code for d in error.value.diagnostics]


# Question units


START_QUESTION_UNITS = """
title: Example
parameters: {m: positive, l: positive, g: positive, s: positive, tau: {value: 20 s}, v: {unit: m/s}}
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
constraints: {rod: {equation: x^2 + y^2 = l^2, reaction: T}}
generalized_coordinates: {angle: {coordinates: [theta], substitute: {x: l*sin(theta), y: l*cos(theta)}}}
"""


@pytest.mark.parametrize(
    ("text", "help_"),
    [
        ("initial: {x: 20 kg}", "`x` is in m, and `20 kg` is in kg"),
        ("initial: {theta: 20 cm}", "`theta` is a number or an angle, and `20 cm` is in m"),
        ("initial: {theta': v}", "`theta'` is in 1/s, and `v` is in m/s"),
        ("initial: {x: v*tau + l, y: v}", "`y` is in m, and `v` is in m/s"),
        ("ask: {a: {quantity: x, when: x = tau}}", "`x` is in m, and `tau` is in s"),
        ("ask: {a: {quantity: x, when: x = v}}", "`x` is in m, and `v` is in m/s"),
        ("ask: {a: {quantity: x, when: t = 3 m}}", ""),
        ("ask: {a: {quantity: x, when: T_kinetic = 3 N}}", "`T_kinetic` is in N m, and `3 N` is in N"),
        ("ask: {a: {quantity: x + tau, when: y = 0}}", "`x` is in m, and `tau` is in s"),
        ('ask: {a: {quantity: x, when: [y = 0, "x\' = 2 cm/s^2"]}}', "`x'` is in m/s, and `2 cm/s^2` is in m/s^2"),
    ],
)
def test_what_cannot_be_equal_is_refused(text: str, help_: str, problem: Callable[[str], Problem]) -> None:
    with pytest.raises(ProblemError) as error:
        problem(f"{START_QUESTION_UNITS}{text}\n")
    [found] = error.value.diagnostics
    assert found.code in ("unit-mismatch", "two-readings")
    assert found.span is not None
    assert help_ in found.help


@pytest.mark.parametrize(
    "text",
    [
        "initial: {x: 20 cm, theta': 30 rpm}",
        "initial: {x: 3, y: l + 2, theta: pi/3}",  # bare numbers may hide a unit
        "ask: {a: {quantity: T, when: T = 10*m}}",  # so may a factor
        "ask: {a: {quantity: x, when: T = 2*m*g}}",  # of a reaction it is not known
        "ask: {a: {quantity: T/m, when: [t = 2*tau, y = v*tau]}}",
    ],
)
def test_what_may_be_equal_is_not(text: str, problem: Callable[[str], Problem]) -> None:
    assert not readings(problem(f"{START_QUESTION_UNITS}{text}\n"))


def test_the_dimension_says_whether_a_letter_is_a_unit(problem: Callable[[str], Problem]) -> None:
    """Beside a mass m, `x: 2 m` is 2 metres; beside an unknown s, `T = 2 m g` is a product."""
    read = problem(START_QUESTION_UNITS + "initial: {x: 2 m}\nask: {one: {quantity: x, when: T = 2 m g}}\n")
    assert [str(v.value) for v in read.initial] == ["2"]
    assert [str(c.rhs) for q in read.questions for c in q.when] == ["2*g*m"]
    assert [(n.code, n.message.partition(" is read")[0]) for n in readings(read)] == [
        ("read-as", "`2 m`"),
        ("read-as", "`2 m g`"),
    ]
    assert not readings(problem(START_QUESTION_UNITS + "initial: {x: 2*l, y: 20 cm}\n"))
    scaled = "title: Example\ncoordinates: [x]\nparameters: [m, c]\nparticles: {P: {mass: m, position: c*x*i}}\n"
    with pytest.raises(ProblemError) as error:
        problem(scaled + "initial: {x: 2 m}\n")
    assert [d.code for d in error.value.diagnostics] == ["two-readings"]
    assert "`2*m`" in error.value.diagnostics[0].help


def test_a_number_with_a_unit_is_a_term_of_an_expression(problem: Callable[[str], Problem]) -> None:
    text = """
initial: {x: l + 20 cm, y: "3 km/h*tau"}
ask:
  one: {quantity: x - 2.5 cm, when: [y + 1 mm = l/2, "y' = v + 2 km/h"]}
"""
    read = problem(START_QUESTION_UNITS + text)
    [one] = read.questions
    assert [str(v.value) for v in read.initial] == ["l + 1/5", "5*tau/6"]
    assert [str(one.quantity), *(str(c.function) for c in one.when)] == [
        "x - 1/40",
        "-l/2 + y + 1/1000",
        "-v + y' - 5/9",
    ]


@pytest.mark.parametrize(
    ("value", "code"),
    [
        ("l + 20 kg", "unit-mismatch"),
        ("l + 2000 kg", "unit-mismatch"),  # a large bare number may hide a unit, this does not
        ("l/20 cm", "unknown-symbol"),  # (l/20) cm
        ("cm + l", "unknown-symbol"),  # not behind a number
        ("l + 2 cm + l*cm", "unknown-symbol"),
    ],
)
def test_a_term_with_a_unit_is_judged(value: str, code: str, problem: Callable[[str], Problem]) -> None:
    with pytest.raises(ProblemError) as error:
        problem(f"{START_QUESTION_UNITS}initial: {{x: {value}}}\n")
    assert [d.code for d in error.value.diagnostics] == [code]


def test_where_a_number_with_a_unit_belongs(problem: Callable[[str], Problem]) -> None:
    with pytest.raises(ProblemError) as error:
        problem(START_QUESTION_UNITS.replace("mass: m", "mass: 2 kg"))
    [found] = error.value.diagnostics
    assert (found.code, "parameters: {a: {value: 2 kg}}" in found.help) == ("unknown-symbol", True)


POLAR = """
title: Orbit
parameters: {m: {unit: kg}, k: {unit: N m^2}, a: 7000 km, v: 9 km/s}
coordinates: {r: {unit: m}, phi: {unit: rad}}
frame: {type: polar, coordinates: [r, phi]}
particles: {P: {mass: m, position: r*e_r}}
"""


@pytest.mark.parametrize("given", ["v", "9 km/s", "9*km/s"])
def test_a_multiple_of_a_velocity_gives_the_velocity(problem: Callable[[str], Problem], given: str) -> None:
    read = problem(POLAR + f"initial: {{r*phi': {given}, r: a, r': 0, phi: 0}}\n")
    [spin] = [v for v in read.initial if v.symbol.name == "phi'"]
    numbers = {p.symbol: p.value for p in read.parameters if p.value is not None}
    assert float(spin.value.xreplace(numbers)) == pytest.approx(9e3 / 7e6)
    assert spin.measured is None
    assert spin.hides_units == (given != "v")


@pytest.mark.parametrize(
    ("initial", "code", "words"),
    [
        ("{r*phi': v, r': 0}", "velocity-multiple", "the value of `r` is needed"),
        ("{r*phi': v, r: 0}", "velocity-multiple", "is 0 then"),
        ("{r*phi': 9 km, r: a}", "unit-mismatch", "wrong dimension"),
        ("{r*phi': v, phi': v/a, r: a}", "declared-twice", "given twice"),
        ("{r + phi': v, r: a}", "no-state", "neither a coordinate nor a velocity"),
    ],
)
def test_multiples_of_velocities_that_give_none(
    problem: Callable[[str], Problem], initial: str, code: str, words: str
) -> None:
    with pytest.raises(ProblemError) as caught:
        problem(POLAR + f"initial: {initial}\n")
    assert caught.value.diagnostics[0].code == code
    assert words in caught.value.diagnostics[0].message
