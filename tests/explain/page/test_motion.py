"""The equations of motion as a page derives them.

Pages that end with quasi-velocities: short, without dangling references, and nothing lost in what is folded.
"""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.diagnostics import Source
from lagrange.document.derivation import Detail, Display, Rule, math
from lagrange.explain.report import EVERY_CHOICE, report
from lagrange.problem.loader import load, read_problem
from lagrange.render import html, terminal
from tests.support.derivation_text import said_in
from tests.support.shared import SHIPPED, reported


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


# Quasi velocities


LONGEST = {"rolling-disc": 150, "sleigh": 130, "snakeboard": 200}


@pytest.mark.parametrize("name", LONGEST)
def test_a_page_with_quasi_velocities_is_short_and_refers_to_what_it_shows(name: str) -> None:
    r = reported(name, complete=False)
    written = terminal.text(r.derivation, r.notation, 80)
    assert len(written.splitlines()) <= LONGEST[name]
    assert "(?)" not in written
    assert "(?)" not in html.render([(r.derivation, r.notation)])  # what is folded is on a web page
    folded = {s.rule for s in r.derivation.page if s.folded}
    assert folded == {Rule.EQUATIONS_OF_MOTION, Rule.PFAFFIAN_FORM, Rule.INTEGRABILITY}


def test_the_motion_stands_at_the_head_though_its_equations_are_folded() -> None:
    first = reported("rolling-disc", complete=False).derivation.page[0]
    box = [e for b in first.body if isinstance(b, Display) for e in b.equations]
    assert len(box) == 3
    assert all(e.sides[0].has(sp.Symbol("phi'", real=True)) for e in box)


def test_the_whole_reaction_of_a_body_stands_for_long_multipliers() -> None:
    r = reported("rolling-disc", complete=False)
    assert "𝐑 = m 𝐫̈ − 𝐅 = m 𝐫̈ + m g 𝐤" in terminal.text(r.derivation, r.notation, 80)
    full = reported("rolling-disc").derivation.at(Detail.FULL)
    boxes = [b for s in full if s.rule is Rule.SOLVED_REACTIONS for b in s.body if isinstance(b, Display)]
    assert [e.label for b in boxes for e in b.equations] == ["multiplier-rolling.1", "multiplier-rolling.2"]


def test_everything_is_shown_where_all_is_asked_for() -> None:
    r = report(load(str(SHIPPED["sleigh"])), EVERY_CHOICE, complete=False)
    assert not any(s.folded for s in r.derivation.page)
