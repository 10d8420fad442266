"""What holds for every figure: labels are on nothing, everything is in its box, and no line ends in mid-air."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import combinations

import pytest

import lagrange
from lagrange.document.scene import FAINT, Box, PagePoint, Polyline, Scene, StrokeKind
from lagrange.mechanics.solution import kinematics_and_law
from lagrange.pictures.loads import as_words
from lagrange.pictures.sketch import Sketch
from tests.support.drawings import figures
from tests.support.figure_sheet import figures_of, solution_for_figures
from tests.support.letters import labels_of, names_of, of_forces, of_geometry, written
from tests.support.shared import SHIPPED
from tests.support.unpictured import UNPICTURED

WITHOUT = {"contact-form", "contact-form-with-fixed-slope", "form-in-two-variables", "form-in-three-variables"}
WITHOUT |= {"oscillating-circuit", "relativistic-oscillator"}
"""Forms in variables that are no places of anything, and Lagrangians without masses."""
FREE = {StrokeKind.AXIS, StrokeKind.FORCE, StrokeKind.REACTION, StrokeKind.REFERENCE, StrokeKind.HATCH}
FREE |= {
    StrokeKind.DAMPER,
    StrokeKind.GROUND,
    StrokeKind.CURVE,
    StrokeKind.ANGLE,
    StrokeKind.DIMENSION,
    StrokeKind.BODY,
    StrokeKind.ROD,
    *FAINT,
}
"""What may end anywhere: arrows, thin lines along a direction, bars, the cylinder of a damper, and what goes on outside."""


@pytest.mark.parametrize("name", SHIPPED)
def test_a_figure_is_drawn_and_everything_is_in_its_box(name: str) -> None:
    scenes = figures(name)
    assert bool(scenes) == (name not in WITHOUT)
    for scene in scenes:
        (left, bottom), (right, top) = scene.box.corners
        for x, y in (p for line in scene.lines for p in line.points):
            assert left <= x <= right
            assert bottom <= y <= top
        assert scene.box.width < 16
        assert scene.box.height < 18


@pytest.mark.parametrize("name", SHIPPED)
def test_labels_are_on_nothing(name: str) -> None:
    for scene in figures(name):
        for a, b in combinations(scene.labels, 2):
            assert not a.box.overlaps(b.box), (a, b)
        for label in scene.labels:
            lines = [line for line in scene.lines if line.kind not in FAINT]
            assert not any(label.box.is_crossed(*piece) for line in lines for piece in line.pieces), label
            assert not any(label.box.overlaps(Box(*d.at, *d.at).grown(d.radius * 0.99)) for d in scene.dots), label


@pytest.mark.parametrize("name", SHIPPED)
def test_no_line_ends_in_mid_air(name: str) -> None:
    for scene in figures(name)[:1]:
        assert [end for end in _ends(scene) if not _is_held(end, scene)] == []


NOT_SHOWN = {
    "a constant of the function of a surface, of a curve, or of a given motion": {
        **{key: {"c"} for key in ("ex02-fixed-surface", "ex08-displacements-on-a-surface", "ex09-moving-surface")},
        **{key: {"c"} for key in ("ex12-smooth-surface", "ex13-moving-surface", "turning-parabola")},
        "ex17-spherical-pendulum": {"a", "b", "omega"},
        "pendulum-on-a-shaken-pivot": {"a", "w"},
        "rotating-unbalance": {"w"},
        "kapitza-pendulum": {"Omega", "a"},
        "gyrocompass": {"Omega"},
        "bead-on-lemniscate": {"a"},
        "crest-of-a-hill": {"a", "h"},
    },
    "the length of a whole string": {
        **{key: {"L"} for key in ("swinging-atwood", "drawbridge", "three-weights")},
        "double-atwood": {"d"},
    },
    "there is no room": {
        "whipple-bicycle": {"h_B", "h_H", "x_B", "x_H"},
        "coin-on-shaken-table": {"R"},  # seen along its plane
    },
    "a force inside of a rope": {"hawser-on-a-bollard": {"T"}},
}
"""Letters that no figure has, by the reason and the problem."""


@pytest.mark.parametrize("name", [n for n in SHIPPED if n not in WITHOUT])
def test_a_figure_has_the_letters_of_the_text_and_no_others(name: str) -> None:
    """Lengths of what is drawn anywhere, applied forces in the first figure, where they act."""
    solution, scenes = solution_for_figures(name), figures(name)
    excused = set().union(*(problems.get(name, set()) for problems in NOT_SHOWN.values()))
    assert of_geometry(solution) - written(scenes) - excused == set()
    assert of_forces(solution) - written(scenes[:1]) - excused == set()
    known = names_of(solution)
    assert labels_of(scenes) - known - {*map(as_words, known)} == set()


@pytest.mark.parametrize("name", UNPICTURED)
def test_a_problem_that_says_nothing_of_its_figure_has_a_true_one(name: str) -> None:
    text, expected = UNPICTURED[name]
    scene, *others = figures_of(kinematics_and_law(lagrange.loads(text)))
    assert {kind: sum(line.kind is kind for line in scene.lines) for kind in expected} == expected
    assert [end for end in _ends(scene) if not _is_held(end, scene)] == []
    for drawn in (scene, *others):
        assert not any(a.box.overlaps(b.box) for a, b in combinations(drawn.labels, 2))
        pieces = [piece for line in drawn.lines if line.kind not in FAINT for piece in line.pieces]
        assert not any(label.box.is_crossed(*piece) for label in drawn.labels for piece in pieces)
        assert drawn.box.width < 16


def _ends(scene: Scene) -> Iterator[tuple[Polyline, PagePoint]]:
    for line in scene.lines:
        if line.kind not in FREE and not line.closed:
            yield line, line.points[0]
            yield line, line.points[-1]


def _is_held(end: tuple[Polyline, PagePoint], scene: Scene) -> bool:
    """Whether the end of a line is on a dot, or on another line or face."""
    own, (x, y) = end
    near = Box(x, y, x, y).grown(0.12)
    if any(math.dist(d.at, (x, y)) < d.radius + 0.1 for d in scene.dots):
        return True
    return any(near.is_crossed(*piece) for line in scene.lines if line is not own for piece in line.pieces)


def test_a_box_is_crossed() -> None:
    box = Box(0, 0, 2, 1)
    assert box.is_crossed((-1, 0.5), (3, 0.5))
    assert box.is_crossed((0.5, 0.5), (0.6, 0.6))
    assert not box.is_crossed((-1, 0.5), (-0.5, 0.5))
    assert not box.is_crossed((-1, 1), (1, 2.5))


def test_ground_is_hatched_to_the_right_of_the_way() -> None:
    sketch = Sketch()
    sketch.ground([(0.0, 0.0), (2.0, 0.0), (2.0, 2.0)])
    strokes = [line for line in sketch.lines if line.kind is StrokeKind.HATCH]
    assert len(strokes) > 20
    assert all(s.points[1][1] < 0 or s.points[1][0] > 2 for s in strokes)


def test_grounds_that_overlap_on_a_line_are_one() -> None:
    sketch = Sketch()
    sketch.ground([(0.0, 0.0), (2.0, 0.0)])
    sketch.ground([(1.0, 0.0), (3.0, 0.0)])
    sketch.ground([(1.0, 1.0), (3.0, 1.0)])  # on another line
    sketch.ground([(3.5, 0.0), (4.0, 0.0)])  # after a gap
    sketch.ground([(2.0, 0.0), (1.0, 0.0)])  # hatched on the other side
    grounds = [line.points for line in sketch.lines if line.kind is StrokeKind.GROUND]
    assert ((0.0, 0.0), (3.0, 0.0)) in grounds
    assert len(grounds) == 4
    feet = [line.points[0] for line in sketch.lines if line.kind is StrokeKind.HATCH and line.points[1][1] < 0]
    assert len(feet) == len(set(feet))


def test_a_wall_and_a_floor_meet_in_their_corner() -> None:
    sketch = Sketch()
    sketch.ground([(0.0, 3.0), (0.0, 2.0)][::-1])
    sketch.ground([(4.0, 0.0), (2.0, 0.0)])
    sketch.join_corner()
    grounds = {line.points for line in sketch.lines if line.kind is StrokeKind.GROUND}
    assert grounds == {((0.0, 0.0), (0.0, 3.0)), ((4.0, 0.0), (0.0, 0.0))}


def test_grounds_that_cross_are_cut_where_nothing_is_beyond() -> None:
    sketch = Sketch()
    sketch.ground([(-2.0, 0.0), (2.0, 0.0)])
    sketch.ground([(0.0, 2.0), (0.0, -2.0)])
    sketch.cut_grounds([(1.0, 0.0), (0.0, 1.0), (0.0, -1.0)])
    ends = [line.points for line in sketch.lines if line.kind is StrokeKind.GROUND]
    assert {frozenset(p) for p in ends} == {frozenset({(0.0, 0.0), (2.0, 0.0)}), frozenset({(0.0, 2.0), (0.0, -2.0)})}
    assert all(min(x for x, _ in line.points) > -0.3 for line in sketch.lines if abs(line.points[0][1]) < 1e-9)
