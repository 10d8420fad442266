"""Half discs, half cylinders and hemispheres, told by where their mass centre is."""

from __future__ import annotations

import math

import pytest

from lagrange.document.scene import StrokeKind
from lagrange.pictures.implied.halves import half_disc, halves, level_of
from tests.support.drawings import drawing_of, lines_of, sketched

HALF = """
parameters: [m, R, g]
coordinates: [phi]
bodies:
  body: {{mass: m, inertia: m*R^2/4, position: (-R*phi + {d}*sin(phi))*i + (R - {d}*cos(phi))*j, angle: phi}}
gravity: -g*j
"""


@pytest.mark.parametrize(
    ("title", "d"), [("A hemisphere", "3*R/8"), ("A half cylinder", "4*R/(3*pi)"), ("A semicircular ring", "2*R/pi")]
)
def test_a_half_rests_with_its_round_side_on_the_ground(title: str, d: str) -> None:
    scene = sketched(f"{title} on a table", HALF.format(d=d))
    [ground] = lines_of(scene, StrokeKind.GROUND)
    [half] = [line for line in lines_of(scene, StrokeKind.BODY) if line.closed]
    assert min(y for _, y in half.points) == pytest.approx(ground.points[0][1], abs=0.01)


def test_no_half_without_the_words_or_the_place_of_the_mass_centre() -> None:
    for title, d in (("A cylinder", "4*R/(3*pi)"), ("A half cylinder", "R/7")):
        system = drawing_of(title, HALF.format(d=d))
        assert half_disc(system, system.configuration.points[0]) is None
        assert [*halves(system)] == []


def test_what_rolls_in_one_direction_has_a_level() -> None:
    assert level_of([(0.0, 1.0, 0.0), (2.0, 1.0, 0.0), (-1.0, 1.0, 0.0)]) == pytest.approx((1.0, 0.0, 0.0))
    assert level_of([(math.cos(a), math.sin(a), 0.0) for a in (0.1, 0.5, 0.9)]) is None
    assert level_of([(1.0, 1.0, 0.0)] * 3) is None
