"""What a figure that moves brings along: coordinates, values, reactions, what it takes for open functions."""

import sympy as sp

from lagrange.animation.figure import MovingFigure, Still
from lagrange.animation.moving import moving_figure
from lagrange.animation.values import angles_in
from tests.support.shared import reported


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
    assert figure.data["kept"] == 4  # the spin


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


def test_equilibria_in_closed_form_have_buttons():
    figure = figure_of("bead-on-rotating-hoop")
    assert [str(e.relations[0][0]) for e in figure.equilibria] == ["theta", "theta", "cos(theta)"]


def test_what_cannot_be_drawn_stays_still_and_says_why():
    still = moving_figure(reported("form-in-two-variables", complete=False).solution)
    assert isinstance(still, Still)
    assert still.reason


def test_angles_are_what_is_turned():
    a, b, c = sp.symbols("a b c", real=True)
    assert angles_in([sp.sin(2 * a + b) * c]) == {a, b}
