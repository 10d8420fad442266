"""Definitions on a page: one name for equal unit vectors, in the order of their use, none that is not used."""

from __future__ import annotations

import sympy as sp

from lagrange.core.symbols import UnitVector
from lagrange.document.derivation import Equation, Purpose, Rule, Step, display, prose
from lagrange.explain.page.definitions import defined_in_order
from lagrange.render import terminal
from tests.support.shared import reported


def printed(name: str, width: int = 80) -> str:
    r = reported(name, complete=False)
    return terminal.text(r.derivation, r.notation, width)


def test_equal_unit_vectors_have_one_name_and_what_is_not_used_is_not_stated() -> None:
    said = printed("two-wheeled-carriage")
    assert said.count("𝐬 = cos θ 𝐢 + sin θ 𝐣") == 1
    assert "𝛚_left = φ̇₁ 𝐧 + θ̇ 𝐤" in said
    assert "_left = 𝐤" not in said
    assert "The velocities of the mass centres, the angular velocities" in " ".join(said.split())
    used = printed("struck-sleigh")
    assert used.count("𝐧 = −sin θ 𝐢 + cos θ 𝐣") == 1
    assert "(ẋ 𝐢 + ẏ 𝐣)·𝐧 = 0" in used


def test_unit_vectors_are_defined_before_they_are_used() -> None:
    i, across, e = (UnitVector(n) for n in ("i", "across", "e"))
    of_body = (
        prose("The unit vectors of the body are", purpose=Purpose.DEFINITIONS),
        display(Equation((e, 2 * across))),
    )
    of_file = (prose("For brevity, write", purpose=Purpose.DEFINITIONS), display(Equation((across, 3 * i))))
    [step] = defined_in_order([Step(Rule.STATEMENT, "", (*of_body, *of_file))])
    assert step.body == (*of_file, *of_body)
    [same] = defined_in_order([step])
    assert same == step
    page = printed("furuta-pendulum")
    assert page.index("𝐚𝐜𝐫𝐨𝐬𝐬 = ") < page.index("− sin θ 𝐤")
    assert "𝐞₁" not in page  # it is 𝐨𝐮𝐭 everywhere, in the displacements too
    assert sp.Symbol("e3_rod").name not in page
