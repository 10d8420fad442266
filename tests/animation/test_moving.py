"""The data of a moving figure: coordinates, values, reactions, assumed undefined functions."""

import re

import pytest
import sympy as sp

from lagrange.animation.figure import MovingFigure
from lagrange.animation.moving import moving_figure
from lagrange.core.diagnostics import Fragment, Source
from lagrange.explain.report import report
from lagrange.problem.loader import read_problem
from lagrange.programs.prepared import prepared
from lagrange.programs.simulation import simulated
from lagrange.programs.starting import settings_of
from tests.support.shared import asking, in_numbers, loaded, reported

OWN = re.compile(
    r"(?:[yzpu]|c\d+|const|return|own|eq|con|rea|ene|act|fig|sta|ini|sli|car|cur\d+|tra\d+|eql\d+|"
    r"Math|sin|cos|tan|asin|acos|atan|atan2|sinh|cosh|tanh|exp|log|abs|sign|sqrt|pow)$"
)


def figure_of(name):
    figure = moving_figure(reported(name, complete=False).solution)
    assert isinstance(figure, MovingFigure)
    return figure


def values(figure):
    return {str(s.label): s.value for s in figure.parameters}


def test_a_pendulum_moves_in_its_angle_and_has_the_values_of_a_pendulum():
    figure = figure_of("ex11-ideal-pendulum")
    assert [str(s.label) for s in figure.coordinates] == ["theta"]
    assert values(figure)["g"] == 9.81
    assert [s.given for s in figure.parameters] == [False] * 3
    assert [str(r) for r in figure.reactions] == ["T_rod"]
    assert figure.data["conserved"] == [1]
    assert figure.moves
    assert not figure.released


def test_a_disc_keeps_the_coordinates_of_the_file_with_their_constraints():
    figure = figure_of("rolling-disc")
    assert len(figure.coordinates) == 5
    assert figure.data["shape"]["eq"] == [5, 2]
    assert figure.data["y"][9] == pytest.approx(5)  # the spin


def test_an_initial_state_of_the_file_is_taken():
    figure = figure_of("bowling-ball")
    assert figure.released
    assert "v" in values(figure)  # the speed with which it is thrown is in no equation, but in the state


def test_what_is_taken_for_an_open_function_is_said():
    figure = figure_of("ex13-moving-surface")
    taken = {f.name: e for f, e in figure.assumed}
    X, Y, Z = sp.symbols("X Y Z", real=True)
    assert taken["f"] == Z - (X**2 + Y**2) / 4
    assert figure.data["rheonomic"]


PARABOLA = """title: Skier in a dip
parameters: {m: 80 kg, g: 9.81 m/s^2, R: 30 m}
axes: {i: right, j: up}
coordinates: [x, y]
particles: {skier: {mass: m, position: x*i + y*j}}
constraints: {snow: {equation: y >= x^2/(2*R), reaction: N}}
gravity: -g*j
generalized_coordinates: {place: {coordinates: [x], substitute: {y: x^2/(2*R)}}}
"""


def test_a_curve_is_followed_along_the_coordinates_of_the_file():
    """x is a coordinate of the file and of the choice: the page varies z[0] and z[1] and needs f to depend on them."""
    figure = moving_figure(report(read_problem(Source("x.yaml", PARABOLA))).solution)
    assert isinstance(figure, MovingFigure)
    assert figure.data["traced"] == [[0, 1]]
    traced = figure.code.split("tra0(")[1].split("}")[0]
    assert {*re.findall(r"z\[(\d+)\]", traced)} == {"0", "1"}


def test_equilibria_in_closed_form_have_buttons():
    figure = figure_of("bead-on-rotating-hoop")
    assert [str(e.relations[0][0]) for e in figure.equilibria] == ["theta", "theta", "cos(theta)"]


@pytest.mark.parametrize("name", ["ex13-moving-surface", "ex18-double-pendulum", "rolling-disc", "roberval-balance"])
def test_no_name_of_a_file_is_in_a_program(name):
    words = set(re.findall(r"[A-Za-z_]\w*", figure_of(name).code))
    assert {w for w in words if not OWN.match(w)} == set()


@pytest.mark.parametrize("name", ["ex11-ideal-pendulum", "heavy-top", "rolling-disc", "bead-on-rotating-hoop"])
def test_a_page_begins_where_a_simulation_does(name):
    figure, start = figure_of(name), in_numbers(name)
    e, numbers = start.states.equations, {s.name: x for s, x in start.start.values.items()}
    assert values(figure) == {n: numbers[n] for n in values(figure)}
    at = dict(zip(e.state, start.start.state, strict=True))
    count = len(e.slots.coordinates)
    assert figure.data["y"][:count] == pytest.approx([at[q] for q in e.slots.coordinates], abs=1e-15)
    expected = [float(sp.N(rate.xreplace({**at, **start.start.values}))) for rate in e.rates]
    assert figure.data["y"][count : 2 * count] == pytest.approx(expected, abs=1e-14)


def test_functions_of_the_command_line_move_the_page():
    problem = loaded("pole-on-cart")
    given = settings_of(problem, [Fragment.of("F=0.2*cos(2*t)", "--set")])
    made = prepared(problem, None, given)
    figure = moving_figure(reported("pole-on-cart", complete=False).solution, simulated(made.states, made.start, 0.1))
    assert isinstance(figure, MovingFigure)
    assert "Math.cos(2.0*y[4])" in figure.code
    assert not any(s.meaning.startswith("amplitude") for s in figure.parameters)
    assert figure.data["motion"][0] == pytest.approx(figure.data["y"], rel=1e-8)
    assert figure.data["motion"][-1][-1] == 0.1


def test_a_force_that_no_position_changes_is_why_there_is_no_rest():
    figure = figure_of("motion/furuta-pendulum")
    tau = next(s.label for s in figure.parameters if str(s.label) == "tau")
    [force] = figure.needed
    assert (figure.data["rest"], figure.data["never"]) == (1, [0])
    assert force in (tau, -tau)
    assert not figure_of("ex11-ideal-pendulum").needed


@pytest.mark.parametrize("name", asking("motion"))
def test_every_shipped_motion_plays(name):
    figure = moving_figure(reported(name).solution)
    assert isinstance(figure, MovingFigure)
    assert figure.moves


def test_a_page_of_an_impact_moves_from_the_velocities_that_it_leaves():
    assert figure_of("ballistic-pendulum").moves  # which asks about the motion after it
    figure = figure_of("rod-falls-on-an-edge")
    assert figure.moves
    assert figure.released
    known = values(figure) | {str(s.label): s.value for s in figure.coordinates}
    n = len(figure.coordinates)
    rates = dict(zip((str(s.label) for s in figure.coordinates), figure.data["y"][n : 2 * n], strict=True))
    expected = 3 * known["a"] * known["v"] / (known["l"] ** 2 + 3 * known["a"] ** 2)  # angular momentum about the edge
    assert rates["theta"] == pytest.approx(expected)
