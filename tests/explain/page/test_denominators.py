"""A denominator that several results share has a letter, and the same value."""

from __future__ import annotations

import sympy as sp

from lagrange.document.builders import display
from lagrange.document.derivation import Display, Equation, Rule, Step
from lagrange.explain.page.denominators import with_named_denominators
from lagrange.mechanics.meaning import meaning
from tests.support.shared import reported

a, b, c, d, x, y = sp.symbols("a b c d x y", real=True)
LONG = a * b * c + a**2 * d + b**2 * d + c * d * (a + b)


def box(*equations: Equation, taken: tuple[str, ...] = ()) -> tuple[Equation, ...]:
    step = with_named_denominators(Step(Rule.SOLVED_REACTIONS, "", (display(*equations, boxed=True),)), taken)
    [block] = step.body
    assert isinstance(block, Display)
    return block.equations


def test_a_shared_denominator_is_named_and_stands_in_the_box() -> None:
    lines = (Equation((x, a / LONG)), Equation((y, b * (a + c) / LONG)))
    named = box(*lines)
    letter, value = named[-1].sides
    assert (letter.name, value) == ("Delta", LONG)
    assert [e.sides[1].xreplace({letter: value}) for e in named[:-1]] == [e.sides[1] for e in lines]


def test_a_short_one_or_one_that_is_not_shared_is_not_named() -> None:
    for lines in (
        (Equation((x, a / (b + c))), Equation((y, b / (b + c)))),
        (Equation((x, a / LONG)), Equation((y, b / (LONG + 1)))),
    ):
        assert box(*lines) == lines


def test_the_letter_is_free() -> None:
    assert box(Equation((x, a / LONG)), Equation((y, b / LONG)), taken=("Delta",))[-1].sides[0].name == "D"


def test_constant_accelerations_solve_the_equations() -> None:
    said = meaning(reported("double-atwood", complete=False).solution)
    assert said is not None
    assert said.view.motion is not None
    assert len(said.constant) == 2
    assert all(sp.cancel(e.expression.xreplace(dict(said.constant))) == 0 for e in said.view.motion.final)


def test_nothing_is_solved_where_accelerations_depend_on_the_position() -> None:
    said = meaning(reported("ex10-double-pendulum", complete=False).solution)
    assert said is not None
    assert not said.constant
