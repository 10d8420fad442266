"""The system as a page introduces it.

Which coordinates are independent, and how many.

Bodies introduced together.
"""

from __future__ import annotations

import pytest
import sympy as sp

import lagrange
from lagrange.document.derivation import Display, Equation, Rule, Step
from lagrange.explain.limits import SHORT_SIDE
from lagrange.explain.page.system import are_short, explain_independence, line
from lagrange.explain.report import report
from lagrange.render import terminal
from tests.support.derivation_text import said_in, words
from tests.support.shared import reported

x = sp.Symbol("x")


def test_two_short_equations_share_a_line() -> None:
    assert are_short([Equation((x, sp.S.One)), Equation((x, sp.S.Zero))])
    long = sp.Add(*(sp.sin(k * x) for k in range(1, 4 * SHORT_SIDE)))
    assert not are_short([Equation((x, long)), Equation((x, long))])


def test_positions_and_forces_are_in_one_display() -> None:
    [step] = [s for s in reported("ex11-ideal-pendulum").derivation.page if s.rule is Rule.STATEMENT]
    assert len([b for b in step.body if isinstance(b, Display)]) == 1


# Coordinates


@pytest.mark.parametrize(
    ("name", "sentence"),
    [
        ("ex04-dumbbell", "These five coordinates are independent, with no relation between them; the six above are"),
        ("ex06-two-particle-skate", "These three coordinates are independent, with no finite relation between them;"),
        ("ex11-ideal-pendulum", ""),
        ("statics/crate-tips-or-slides", ""),
    ],
)
def test_how_many_coordinates_are_independent(name: str, sentence: str) -> None:
    solution = reported(name).solution
    said = explain_independence(solution, solution.choices[0])
    if not sentence:
        assert said is None  # motion or rest is the question
        return
    assert said is not None
    assert words(Step(Rule.GENERALIZED_COORDINATES, "", (said,))).startswith(sentence)


def test_a_line_is_called_by_two_letters_where_both_can_be_read() -> None:
    assert [line("", "P"), line("P1", "P2")] == ["OP", "P1P2"]
    assert line("", "AB") == "the line from O to AB"


# Bodies


@pytest.mark.parametrize(
    ("name", "rule", "said"),
    [
        ("three-struck-rods", Rule.STATEMENT, "The bodies are rigid: "),
        ("furuta-pendulum", Rule.STATEMENT, "The applied moments are"),
    ],
)
def test_bodies_are_introduced_together(name: str, rule: Rule, said: str) -> None:
    assert said in said_in(name, rule, on_page=True)


def test_a_cart_given_as_a_body_does_not_turn() -> None:
    text = (
        "title: T\nparameters: [M, m, a, g]\ncoordinates: [x, theta]\nbodies:\n"
        "  cart: {mass: M, inertia: 0, position: x*i, angle: 0}\n"
        "  rod: {mass: m, inertia: m*a^2/3, position: (x + a*sin(theta))*i - a*cos(theta)*j, angle: theta}\n"
        "gravity: -g*j\n"
    )
    explained = report(lagrange.loads(text), None, complete=False)
    page = terminal.text(explained.derivation, explained.notation, 80)
    assert "the cart (not turned, of mass M)" in page
    assert "𝛚_cart" not in page
    assert "𝛑_cart" not in page


def test_a_range_is_stated_where_all_parameters_are_positive() -> None:
    """Without it a reader misses the equilibrium θ = π of the post."""
    made = reported("inverted-pendulum-springs")
    page = " ".join(terminal.text(made.derivation, made.notation, 80).split())
    assert "all positive. Range: −π/2 ≤ θ ≤ π/2." in page
