"""The equations of motion as a page derives them."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.diagnostics import Source
from lagrange.document.builders import math
from lagrange.document.derivation import Display, Rule
from lagrange.explain.report import report
from lagrange.problem.loader import read_problem
from tests.support.derivation_text import said_in


@pytest.mark.parametrize(
    ("name", "rule", "said"),
    [
        ("ex10-double-pendulum", Rule.EQUATIONS_OF_MOTION, "The accelerations and the virtual displacements are"),
        ("ex11-ideal-pendulum", Rule.EQUATIONS_OF_MOTION, "The acceleration and the virtual displacement are"),
        ("ex10-double-pendulum", Rule.EQUATIONS_OF_MOTION, "Written out, the principle reads"),
    ],
)
def test_kinematics_stand_before_the_equations(name: str, rule: Rule, said: str) -> None:
    assert said in said_in(name, rule, on_page=True)


POLAR = """
title: A point in the plane, the angle first
parameters: [m, k]
coordinates: [phi, r]
particles: {P: {mass: m, position: r*cos(phi)*i + r*sin(phi)*j}}
forces: {pull: {potential: k*r^2/2}}
"""


def test_a_condition_stands_at_the_equation_that_it_belongs_to() -> None:
    found = report(read_problem(Source("polar.yaml", POLAR)))
    boxes = [b for s in found.derivation.page if s.rule is Rule.EQUATIONS_OF_MOTION for b in s.body
             if isinstance(b, Display) and b.boxed]  # fmt: skip
    [about, along] = boxes[0].equations
    r = sp.Symbol("r", real=True)
    assert about.condition == ("where ", math(r, sp.S.Zero, relation="≠"))
    assert not along.condition
