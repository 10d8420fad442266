"""A long length of a spring is written by its letter, that of the file if it has one."""

from __future__ import annotations

from types import SimpleNamespace

import sympy as sp

from lagrange.document.builders import display
from lagrange.document.derivation import Display, Equation, Rule, Step
from lagrange.explain.page.shorter.springs import with_lengths

a, l, c = sp.symbols("a l c", positive=True)
u, v = sp.symbols("u v", real=True)
RADICAND = a**2 - 2 * a * l * (sp.sin(u) - sp.sin(v)) + 2 * l**2 * (1 - sp.cos(u - v))
NAME = sp.Symbol("d_spring", real=True)
STATEMENT = Step(Rule.STATEMENT, "", (display(Equation((NAME, sp.sqrt(RADICAND)), label="length")),))
MOTION = Step(Rule.EQUATIONS_OF_MOTION, "", (display(Equation((c * (1 - a / sp.sqrt(RADICAND)) * sp.sin(u), 0 * a))),))


def lines(abbreviations: dict[str, sp.Expr], *steps: Step) -> list[Equation]:
    solution = SimpleNamespace(problem=SimpleNamespace(abbreviations=abbreviations))
    made = with_lengths(solution, steps)  # type: ignore[arg-type]
    return [e for s in made for b in s.body if isinstance(b, Display) for e in b.equations]


def test_the_letter_of_the_statement() -> None:
    stated, moving = lines({}, STATEMENT, MOTION)
    assert stated.sides == (NAME, sp.sqrt(RADICAND))
    letter = sp.Symbol("d_spring", positive=True)
    assert moving.sides[0] == c * (1 - a / letter) * sp.sin(u)


def test_the_letter_of_the_file_though_it_is_written_otherwise() -> None:
    own = sp.sqrt((a - l * sp.sin(u) + l * sp.sin(v)) ** 2 + l**2 * (sp.cos(v) - sp.cos(u)) ** 2)
    stated, moving = lines({"d": own, "e": sp.sqrt(a * l)}, STATEMENT, MOTION)
    letter = sp.Symbol("d", positive=True)
    assert stated.sides == (letter,)
    assert moving.sides[0] == c * (1 - a / letter) * sp.sin(u)


def test_a_short_length_is_written_out() -> None:
    short = Step(Rule.STATEMENT, "", (display(Equation((NAME, sp.sqrt(a**2 + l**2)))),))
    motion = Step(Rule.EQUATIONS_OF_MOTION, "", (display(Equation((c / sp.sqrt(a**2 + l**2), sp.S.Zero))),))
    assert [e.sides for e in lines({}, short, motion)] == [e.sides for e in lines({}, short)] + [
        (c / sp.sqrt(a**2 + l**2), sp.S.Zero)
    ]


def test_twice_the_radicand_is_the_same_length() -> None:
    double = Step(Rule.EQUATIONS_OF_MOTION, "", (display(Equation((a / sp.sqrt(sp.expand(2 * RADICAND)), sp.S.Zero))),))
    _, moving = lines({}, STATEMENT, double)
    assert moving.sides[0] == a / (sp.sqrt(2) * sp.Symbol("d_spring", positive=True))


def test_the_head_says_what_the_letter_is() -> None:
    head = Step(Rule.RESULT, "", MOTION.body)
    moving, defined, *_ = lines({}, head, STATEMENT)
    letter = sp.Symbol("d_spring", positive=True)
    assert moving.sides[0] == c * (1 - a / letter) * sp.sin(u)
    assert defined.sides == (letter**2, RADICAND)


def test_a_spring_and_a_damper_of_one_length_share_its_letter() -> None:
    oil, rate = sp.Symbol("d_oil", real=True), sp.Symbol("d_oil'", real=True)
    both = Step(
        Rule.STATEMENT, "", (*STATEMENT.body, display(Equation((oil, sp.sqrt(RADICAND))), Equation((c * rate, c))))
    )
    _, second, pull = lines({}, both)
    assert second.sides == (sp.Symbol("d_spring", positive=True),)
    assert pull.sides[0] == c * sp.Symbol("d_spring'", real=True)
