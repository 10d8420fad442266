"""Newton's law and the work of the reactions, as a page puts them."""

from __future__ import annotations

import pytest

from lagrange.core.diagnostics import Source
from lagrange.document.derivation import Rule
from lagrange.explain.report import report
from lagrange.problem.loader import read_problem
from lagrange.render import terminal
from tests.support.derivation_text import said_in


@pytest.mark.parametrize(
    ("name", "rule", "said"),
    [
        ("ex10-double-pendulum", Rule.REACTIONS, ", and its reaction acts along it. With the tensions "),
        ("ex10-double-pendulum", Rule.WORKLESS, " work: what one loses, the other gains."),
        ("ball-on-a-ball", Rule.WORKLESS, "the work of the reactions is the sum of "),
    ],
)
def test_what_is_said_of_reactions(name: str, rule: Rule, said: str) -> None:
    assert said in said_in(name, rule, on_page=True)


TABLE = """title: A string through a hole in a table
parameters: [m, M, L, g]
coordinates: [r, phi, z]
frame: {type: polar, coordinates: [r, phi]}
particles: {A: {mass: m, position: r*e_r}, B: {mass: M, position: -z*k}}
constraints: {string: {equation: r + z = L, by: string, reaction: S}}
gravity: -g*k
"""


def test_a_weight_that_a_table_balances_is_accounted_for() -> None:
    """Newton's law of A has a component along k that no coordinate moves along, and no reaction shown has one."""
    found = report(read_problem(Source("table.yaml", TABLE)), complete=False)
    page = " ".join(terminal.text(found.derivation, found.notation, 80).split())
    assert "The force that keeps A from moving along 𝐤 is m g in this direction" in page
    assert "The string constraint keeps a length constant: its reaction is the tension S" in page


ARMS = """title: Two rods, one on the other
parameters: [m, M, a, b, g]
coordinates: [r, phi, s, psi]
axes: {i: down, j: right}
let: {e: "cos(phi)*i + sin(phi)*j", u: "cos(psi)*i + sin(psi)*j"}
particles: {A: {mass: m, position: r*e}, B: {mass: M, position: r*e + s*u}}
constraints: {upper: {equation: r = a, reaction: S}, lower: {equation: s = b, reaction: T}}
gravity: g*i
"""
BEADS = """title: Two beads on a turning rod, joined by a rod
parameters: [m, M, a, g]
coordinates: [r, phi, s]
frame: {type: polar, coordinates: [r, phi]}
particles: {A: {mass: m, position: r*e_r}, B: {mass: M, position: s*e_r}}
constraints: {link: {equation: s - r = a, by: rod, reaction: S}}
"""


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (TABLE, "𝐑_A = −S 𝐞_r 𝐑_B = S 𝐤"),
        (ARMS, "𝐑_A = T 𝐮 − S 𝐞 𝐑_B = −T 𝐮"),  # and no T/b (r_B − r_A)
        (BEADS, "S (δr − δs)"),  # the work of a tension, which pulls A outwards and B inwards
    ],
)
def test_reactions_along_the_unit_vectors_of_the_file(text: str, said: str) -> None:
    found = report(read_problem(Source("along.yaml", text)), complete=False)
    assert said in " ".join(terminal.text(found.derivation, found.notation, 120).split())
