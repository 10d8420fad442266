"""Whether the positions, written in the coordinates, satisfy constraints by themselves."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from lagrange.mechanics.constraints.classification import classify
from lagrange.mechanics.constraints.kinematics import file_configuration
from lagrange.problem.model import Problem

Read = Callable[[str], Problem]

HEAD = "title: Example\nparameters: [m, l, J]\n"
BODY = "bodies: {{B: {{mass: m, inertia: J, position: {position}, angle: phi}}}}\n"


@pytest.mark.parametrize(
    ("text", "built_in"),
    [
        ("coordinates: [x]\nparticles: {P: {mass: m, position: x*i}}", False),  # on a line, along which all is free
        ("coordinates: [x, y]\nparticles: {P: {mass: m, position: '[x, y]'}}", False),
        ("coordinates: [phi]\nparticles: {P: {mass: m, position: l*sin(phi)*i - l*cos(phi)*j}}", True),
        ("coordinates: [x]\nparticles: {P: {mass: m, position: x*(i + j)}}", True),  # on an incline
        ("coordinates: [x, y]\nparticles: {P: {mass: m, position: x*i + y*j + x*y*k}}", True),
        ("coordinates: [x, u]\nparticles: {P: {mass: m, position: x*i}, Q: {mass: m, position: u*i}}", False),
        ("coordinates: [x, y, phi]\n" + BODY.format(position="x*i + y*j"), False),
        ("coordinates: [phi]\n" + BODY.format(position="0*i"), True),  # a bearing
        (
            "coordinates: [phi, theta, psi]\nbodies: {top: {mass: m, inertia: [J, J, J], position: l*e3_top, "
            "orientation: {axes: 313, angles: [phi, theta, psi]}}}",
            True,
        ),
    ],
)
def test_constraints_that_the_coordinates_satisfy(problem: Read, text: str, built_in: bool) -> None:
    read = problem(f"{HEAD}{text}\n")
    assert file_configuration(read, classify(read).constrained).satisfies_constraints_itself is built_in
