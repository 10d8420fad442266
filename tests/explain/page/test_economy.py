"""A page says nothing twice: one name for a unit vector, no unused abbreviations, short lines in pairs."""

from __future__ import annotations

from dataclasses import replace

import pytest
import sympy as sp

from lagrange.core.symbols import CONSTANT, UnitVector, VectorSymbol
from lagrange.core.vectors import Vector
from lagrange.document.derivation import (
    Block,
    Display,
    Emphasis,
    Equation,
    EquationKind,
    Phrase,
    Prose,
    Purpose,
    Ref,
    Rule,
    Step,
    display,
    math,
    prose,
)
from lagrange.explain.page.economy import (
    freedom_in_one,
    in_pairs,
    joined,
    lagrangian_once,
    likewise_in_a_line,
    said_before,
)
from lagrange.render import terminal
from tests.support.shared import reported

x, y, z = sp.symbols("x y z", real=True)
D = sp.Symbol("Delta", real=True)
IN_SHORT = prose(Emphasis("In short"), ",", purpose=Purpose.IN_SHORT)


def step(*blocks: Block, rule: Rule = Rule.MEANING, title: str = "") -> Step:
    return Step(rule, title, blocks)


def printed(name: str, width: int = 80) -> str:
    r = reported(name, complete=False)
    return terminal.text(r.derivation, r.notation, width)


def test_a_letter_is_defined_once_and_the_head_is_not_repeated() -> None:
    head = step(display(Equation((x, y)), Equation((y, z)), boxed=True), rule=Rule.RESULT)
    first = step(display(Equation((x, y / D)), Equation((D, z)), boxed=True))
    again = step(display(Equation((z, x / D)), Equation((D, z)), boxed=True))
    other = step(display(Equation((z, x / D)), Equation((D, x)), boxed=True))
    short = step(IN_SHORT, display(Equation((x, y)), Equation((y, z)), boxed=True))
    _, a, b, c, d = said_before([head, first, again, other, short])
    assert a == first
    [box] = b.body
    assert isinstance(box, Display)
    assert box.equations == (Equation((z, x / D), condition=("with ", math(D), " as above")),)
    assert c == other
    assert len(d.body) == 1  # a sentence that refers to the head


def test_constant_accelerations_that_the_head_has_are_not_displayed_again() -> None:
    rates = display(Equation((x, y)), Equation((y, z)), boxed=True)
    says = prose(Emphasis("Accelerations"), ", all of them constant:", purpose=Purpose.CONSTANT_RATES)
    head = step(rates, rule=Rule.RESULT)
    _, shortly = said_before([head, step(says, rates)])
    assert shortly.body == (replace(says, parts=(*says.parts, " those at the head of the page.")),)
    others = step(says, display(Equation((x, z)), Equation((y, x)), boxed=True))
    assert [*said_before([head, others])][1] == others


def test_a_single_acceleration_that_the_head_has_gets_no_sentence() -> None:
    rate = display(Equation((x, y)), boxed=True)
    says = prose(Emphasis("Acceleration"), ", which is constant:", purpose=Purpose.CONSTANT_RATES)
    before = prose("It falls.")
    _, shortly = said_before([step(rate, rule=Rule.RESULT), step(before, says, rate)])
    assert shortly.body == (before,)


def test_a_velocity_that_is_asked_to_be_zero_is_zero_in_the_condition() -> None:
    asked = " ".join(printed("turning-parabola").split("Asked for")[1].split("Checks")[0].split())
    assert "With ρ̇ = 0, the equations of motion give ρ̈ = (Ω² − 2c g) ρ/(4c² ρ² + 1)" in asked
    assert "ρ̇²" not in asked


def test_a_form_in_short_that_the_head_does_not_have_stays() -> None:
    short = step(IN_SHORT, display(Equation((x, y)), Equation((y, CONSTANT)), boxed=True))
    assert [*said_before([short])] == [short]


def test_a_second_question_does_not_state_the_condition_again() -> None:
    blocks = (prose("The condition becomes"), display(Equation((x, sp.S.Zero), label="one")))
    first, second = said_before([step(*blocks, rule=Rule.QUESTION), step(*blocks, prose("So"), rule=Rule.QUESTION)])
    assert first.body == blocks
    assert second.body == (prose("As before, ", Ref("one"), " holds.", purpose=Purpose.AS_BEFORE), prose("So"))


def test_what_earlier_questions_found_is_recalled_in_one_sentence() -> None:
    force = step(display(Equation((x, y, z), label="force"), boxed=True), rule=Rule.SOLVED_REACTIONS)
    integral = prose("Throughout the motion, as before, ", Ref("energy"), " holds.", purpose=Purpose.AS_BEFORE)
    again = step(prose("In terms of position,"), display(Equation((x, z))), integral, prose("So"), rule=Rule.QUESTION)
    _, question = said_before([force, again])
    together = prose("As before, ", Ref("force"), " and ", Ref("energy"), " hold.", purpose=Purpose.AS_BEFORE)
    assert question.body == (together, prose("So"))


def test_short_lines_of_one_kind_are_paired_unless_something_refers_to_the_second() -> None:
    a, b = (
        Equation((VectorSymbol(f"F_{n}"), x * UnitVector("i")), label=f"force-{n}", kind=EquationKind.FORCE)
        for n in "AB"
    )
    [paired] = in_pairs([step(display(a, b))])
    [block] = paired.body
    assert isinstance(block, Display)
    assert [e.label for e in block.equations] == ["force-A"]
    kept = [step(display(a, b)), step(prose("By ", Ref("force-B")))]
    assert [*in_pairs(kept)] == kept
    long = Equation(
        (VectorSymbol("F_B"), Vector((x * y + z, x * y - z, x + y))), label="force-B", kind=EquationKind.FORCE
    )
    assert [*in_pairs([step(display(a, long))])] == [step(display(a, long))]


def test_classification_and_freedom_are_one_section() -> None:
    [one] = freedom_in_one(
        [step(prose("holonomic"), rule=Rule.CLASSIFICATION), step(prose("2"), rule=Rule.DEGREES_OF_FREEDOM)]
    )
    assert one.title == "Classification and degrees of freedom"
    assert one.body == (prose("holonomic"), prose("2"))


def test_successive_steps_are_joined_and_none_is_lost() -> None:
    names = ["a", "b", "b", "b", "c"]

    def join(first: Step, second: Step) -> Step | None:
        return step(*first.body, *second.body, title=first.title) if first.title == second.title else None

    found = [*joined([step(prose(str(n)), title=name) for n, name in enumerate(names)], join)]
    assert [(s.title, len(s.body)) for s in found] == [("a", 1), ("b", 3), ("c", 1)]
    assert [*joined([], join)] == []


def test_a_further_form_that_is_not_integrable_takes_one_paragraph() -> None:
    first, question, end = (
        prose(Ref("form-b"), " is not"),
        prose("With ", math(x), ", ", purpose=Purpose.NEXT_PRODUCT),
        prose(Phrase("This does", Purpose.SUBJECT), " not vanish.", purpose=Purpose.NEXT_NOT_INTEGRABLE),
    )
    [said] = likewise_in_a_line([first, question, display(Equation((x, y * z))), end])
    assert isinstance(said, Prose)
    assert math(x, y * z) in said.parts
    apart = [first, question, display(Equation((x, y), condition=("a",)), Equation((y, z))), end]
    assert [*likewise_in_a_line(apart)] == apart


def test_a_given_lagrangian_is_displayed_once() -> None:
    again = step(prose("The Lagrangian is given."), display(Equation((x, y), label="lagrangian")), rule=Rule.ENERGIES)
    [begins] = lagrangian_once(again).body
    assert isinstance(begins, Prose)
    assert Ref("given-lagrangian") in begins.parts


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("ex06-two-particle-skate", "ẋ sin θ − ẏ cos θ = 0"),
        ("ex07-constant-coefficients", "One degree of freedom; holonomic, and rheonomic if a₁ₜ ≠ 0:"),
        ("ex14-two-particles", "(𝐫_P₁ − 𝐫_P₂)·(δ𝐫_P₁ − δ𝐫_P₂) = 0"),
        ("south-pointing-chariot", "θ + ψ = const"),
        ("bicycle", "leaves 2 independent combinations ω of the 3 forms; repeated with these, it leaves 1, which passes again"),
    ],
)  # fmt: skip
def test_a_page_has_the_short_form(name: str, said: str) -> None:
    assert said in " ".join(printed(name, 100).split()).replace("( ", "(")


def test_what_the_reaction_is_a_question_does_not_display_again() -> None:
    found = step(display(Equation((x, y, z), label="force"), boxed=True), rule=Rule.SOLVED_REACTIONS)
    asked = step(prose("In terms of position and velocity,"), display(Equation((x, z))), rule=Rule.QUESTION)
    _, question = said_before([found, asked])
    assert question.body == (prose("As before, ", Ref("force"), " holds.", purpose=Purpose.AS_BEFORE),)


def test_accelerations_that_a_choice_leaves_as_they_are_stand_once() -> None:
    def kinematics(label: str) -> Step:
        line = Equation((VectorSymbol("r''"), x), label=label, kind=EquationKind.ACCELERATION)
        return step(prose("The acceleration is", purpose=Purpose.KINEMATICS), display(line))

    first, second = said_before([kinematics("acceleration-P"), kinematics("acceleration-choice-P")])
    assert first == kinematics("acceleration-P")
    assert second.body == (prose("The acceleration is", " given by ", Ref("acceleration-P"), "."),)
