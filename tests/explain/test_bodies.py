"""The prose about springs and bodies."""

from __future__ import annotations

import pytest

from lagrange.core.diagnostics import Source
from lagrange.document.derivation import Detail
from lagrange.explain.report import report
from lagrange.problem.loader import read_problem
from lagrange.render import terminal

PINNED_BEAM = """
title: Bead on a beam
parameters: [J, m, k]
coordinates: [s, phi]
bodies: {beam: {inertia: J, position: 0*i, angle: phi}}
particles: {B: {mass: m, position: "s*cos(phi)*i + s*sin(phi)*j"}}
forces: {tie: {spring: k, between: [B, 0*i], length: 0}}
"""


def test_a_spring_fastened_at_a_hinge_is_fastened_at_the_origin() -> None:
    found = report(read_problem(Source("beam.yaml", PINNED_BEAM)))
    page = " ".join(terminal.text(found.derivation, found.notation, 80, Detail.STEPS).split())
    assert "The tie spring, of stiffness k, joins B and O." in page
    assert "k d_tie = k |s|" in page


@pytest.mark.parametrize(
    ("angles", "sentence"),
    [
        ("phi, 0, 0", "It is turned by φ about its third axis. Its moments"),
        ("0, 0, phi", "It is turned by φ about its third axis. Its moments"),
        (
            "0, phi, pi/2",
            "It is turned by φ about its first axis and then by π/2 about the new third axis. Its moments",
        ),
        ("0, 0, 0", "It is not turned. Its moments"),
    ],
)
def test_a_turn_by_zero_is_not_mentioned(angles: str, sentence: str) -> None:
    text = f"title: T\nparameters: [A, B, C]\ncoordinates: [phi, x]\nbodies:\n  top: {{mass: A, inertia: [A, B, C], position: x*i, orientation: {{axes: 313, angles: [{angles}]}}}}\n"
    if "phi" not in angles:
        text = text.replace("[phi, x]", "[x]")
    found = report(read_problem(Source("top.yaml", text)))
    page = " ".join(terminal.text(found.derivation, found.notation, 200, Detail.STEPS).split())
    assert sentence in page, page[:1500]
