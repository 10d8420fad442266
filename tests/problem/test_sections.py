"""What a file asks for."""

from __future__ import annotations

import pytest

from lagrange.core.diagnostics import ProblemError
from lagrange.problem.model import Find
from tests.support.problem_texts import HEAD, read

PARTICLES = "particles: {P: {mass: m, position: x*i + y*j}, Q: {mass: m, position: y*i}}\n"
BODY = "bodies: {B: {mass: m, inertia: I_G, position: x*i, angle: theta}}\n"
ROD = "constraints: {rod: x^2 + y^2 = l^2}\n"


FIND = {
    "": (Find.MOTION,),
    "find: constraints": (Find.CONSTRAINTS,),
    "find: [motion, equilibrium]": (Find.MOTION, Find.EQUILIBRIUM),
    "find: linearization": (Find.LINEARIZATION,),
}


@pytest.mark.parametrize("text", FIND)
def test_find(text: str) -> None:
    assert read(HEAD + PARTICLES + text).find == FIND[text]


def test_find_by_default() -> None:
    massless = "particles: {P: {position: x*i}}\n"
    assert read(HEAD + massless).find == (Find.CONSTRAINTS,)
    assert read(HEAD + ROD).find == (Find.CONSTRAINTS,)
    assert read(HEAD + massless + "forces: {a: {on: P, vector: F*i}}\n").find == (Find.EQUILIBRIUM,)
    assert read(HEAD + BODY).find == (Find.MOTION,)
    assert read(HEAD + "equations: [\"x'' = 0\"]\n").find == (Find.MOTION,)
    assert read(HEAD + "bodies: {B: {inertia: I_G, position: 0, angle: theta}}\n").find == (Find.MOTION,)


def test_a_place_among_the_marks_of_an_answer() -> None:
    with pytest.raises(ProblemError) as caught:
        read(HEAD + PARTICLES + "points: {A: l*i}\n")
    assert "let: {r_A: l*i}" in caught.value.diagnostics[0].help
