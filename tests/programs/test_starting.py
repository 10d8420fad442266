"""Where a simulation starts, and what it is refused for."""

from __future__ import annotations

import math

import pytest

from lagrange.core.diagnostics import Fragment, ProblemError, Source
from lagrange.problem.loader import read_problem
from lagrange.programs.prepared import longest_time, prepared
from lagrange.programs.simulation import simulated
from lagrange.programs.starting import settings_of
from tests.api.test_motion import solved
from tests.programs.test_simulation import made_of, of
from tests.support.shared import loaded


def test_an_equilibrium_is_left_by_a_small_push() -> None:
    made = prepared(loaded("leaving-a-sphere"))
    assert made.start.pushed
    motion = simulated(made.states, made.start, longest_time(made.states, made.start), questions=made.problem.questions)
    [leaves] = [e for e in motion.events if e.name == "leaves"]
    assert math.isclose(math.cos(leaves.value or 0), 2 / 3, rel_tol=1e-6)


def test_initial_values_of_other_coordinates_are_carried_over() -> None:
    made = made_of(loaded("ex11-ideal-pendulum"), "x=0.3", "y'=0.2")
    motion = simulated(made.states, made.start, 0.1, samples=2)
    assert math.isclose(of(motion, "x")[0], 0.3, rel_tol=1e-9)
    assert math.isclose(of(motion, "y'")[0], 0.2, rel_tol=1e-9)


@pytest.mark.parametrize(
    ("settings", "code", "place"),
    [
        (("theta=",), None, ""),
        (("theta=blue",), "unknown-symbol", "1:7"),
        (("theta=3 kg*",), "unknown-unit", ""),
        (("theta''=1",), "unknown-parameter", "1:1"),
        (("phi'=1",), "unknown-parameter", "1:1"),
        (("x=1", "y=100"), "initial-contradicts", ""),
    ],
)
def test_settings_that_cannot_be_are_refused_at_their_place(
    settings: tuple[str, ...], code: str | None, place: str
) -> None:
    if code is None:
        assert settings_of(loaded("ex11-ideal-pendulum"), [Fragment.of(settings[0])]).parameters  # refused later
        return
    with pytest.raises(ProblemError) as error:
        made_of(loaded("ex11-ideal-pendulum"), *settings)
    assert error.value.diagnostics[0].code == code
    assert place in str(error.value)
    assert error.value.diagnostics[0].help


def test_names_that_do_not_exist_are_refused() -> None:
    with pytest.raises(ValueError, match="did you mean `theta'`"):
        solved().simulate(1.0, initial={"thta'": 1})
    with pytest.raises(ValueError, match="parameters"):
        solved().simulate(1.0, values={"mass": 1})
    with pytest.raises(KeyError, match="angle"):
        solved().simulate(1.0, choice="angel")
    with pytest.raises(TypeError, match="expression of SymPy"):
        solved().simulate(1.0, functions={"u": "t^2"})  # type: ignore[dict-item]


def test_an_impact_in_a_position_that_is_left_open() -> None:
    text = """
title: a bead on a parabola is hit
parameters: {m: positive, a: positive, g: positive, F: positive}
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
constraints: {wire: y = a*x^2}
gravity: -g*j
find: [motion]
impact: {before: {x': F/m}, impulses: {blow: {on: P, vector: F*i}}}
"""
    made = prepared(read_problem(Source("hit.yaml", text)), complete=True)
    places = dict(zip(map(str, made.states.state), made.start.state, strict=True))
    a = next(v for s, v in made.start.values.items() if s.name == "a")
    assert math.isclose(places["y"], a * places["x"] ** 2, rel_tol=1e-9)
    assert math.isclose(places["y'"], 2 * a * places["x"] * places["x'"], rel_tol=1e-9)
