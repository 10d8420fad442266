"""Pictures: what they show is where it is, labels are on nothing, and what would be wrong is left out."""

from __future__ import annotations

import math
import shutil
import subprocess
from functools import cache
from itertools import combinations
from xml.etree import ElementTree

import pytest
import sympy as sp
from conftest import PROBLEMS

from lagrange.document.derivation import Picture
from lagrange.document.math_writer import UNICODE, Writer
from lagrange.document.scene import Box, Kind, Line, Scene
from lagrange.explain.report import Report, report
from lagrange.pictures.configurations import configuration_scene
from lagrange.pictures.free_bodies import free_body_scene
from lagrange.pictures.loads import acting_on
from lagrange.pictures.marks import angle_mark, is_distance
from lagrange.pictures.systems import System, system_in_file
from lagrange.pictures.views import view
from lagrange.problem.loader import load
from lagrange.render import html, json, latex
from lagrange.render import terminal as pretty
from lagrange.render.svg import figure, spans

SHIPPED = sorted(p.relative_to(PROBLEMS).with_suffix("").as_posix() for p in PROBLEMS.glob("*/*.yaml"))
DRAWN = (
    "chapter6/ex03-double-pendulum",
    "chapter6/ex10-double-pendulum",
    "chapter6/ex14-two-particles",
    "chapter6/ex15-rough-incline",
    "chapter6/ex17-spherical-pendulum",
    "motion/bell-and-clapper",
    "motion/coupled-oscillators",
    "motion/hoop-on-incline",
    "motion/sliding-ladder",
    "motion/spring-pendulum",
    "statics/slider-crank",
)
LEFT_OUT = ("chapter6/ex02-fixed-surface", "chapter6/ex05-ice-skate", "statics/rocking-plank", "statics/lazy-tongs")
CLOSE = 1e-6


@cache
def reported(name: str) -> Report:
    return report(load(PROBLEMS / f"{name}.yaml"))


def system_of(name: str) -> System:
    found = system_in_file(reported(name).solution)
    assert found is not None
    return found


def scenes(name: str) -> list[Scene]:
    pictures = (b for s in reported(name).derivation.steps for b in s.body if isinstance(b, Picture))
    return [scene for p in pictures if (scene := p.draw()) is not None]


def evaluated(expression: sp.Expr, system: System) -> float:
    """By SymPy, not by the evaluator of the pictures."""
    values = {s: sp.Float(v) for s, v in system.pose.values.items()}
    return float(sp.sympify(expression, strict=True).evalf(15, subs=values))


def lines_of(scene: Scene, kind: Kind) -> list[Line]:
    return [line for line in scene.lines if line.kind is kind]


def near(a: tuple[float, float], b: tuple[float, float], within: float = CLOSE) -> bool:
    return math.dist(a, b) < within


# Positions


@pytest.mark.parametrize("name", DRAWN)
def test_a_pose_satisfies_the_constraints(name: str) -> None:
    system = system_of(name)
    for f in system.configuration.finite_constraints:
        assert abs(evaluated(f, system)) < 1e-8


def test_rods_end_at_their_particles() -> None:
    system = system_of("chapter6/ex03-double-pendulum")
    [scene, _] = scenes("chapter6/ex03-double-pendulum")
    x1, y1, x2, y2 = (evaluated(sp.Symbol(n, real=True), system) for n in ("x1", "y1", "x2", "y2"))
    scale = system.page.scale
    places = [(0.0, 0.0), (x1 * scale, -y1 * scale), (x2 * scale, -y2 * scale)]  # j points down
    upper, lower = lines_of(scene, Kind.ROD)
    assert near(upper.points[0], places[0])
    assert near(upper.points[1], places[1])
    assert {True} == {any(near(p, q) for q in places[1:]) for p in lower.points}
    assert [any(near(d.at, p) for d in scene.dots) for p in places] == [True] * 3


def test_the_length_of_a_rod_is_that_of_its_parameter() -> None:
    system = system_of("statics/slider-crank")
    scene = scenes("statics/slider-crank")[0]
    [rod] = lines_of(scene, Kind.ROD)
    length = evaluated(sp.Symbol("l", positive=True), system)
    assert math.isclose(math.dist(*rod.points), length * system.page.scale)


# Forces


def labelled_tip(scene: Scene, label: str, notation) -> Line:
    """The arrow whose tip is nearest to a label."""
    write = Writer(UNICODE, notation)
    [found] = [x for x in scene.labels if not isinstance(x.content, str) and write.plain(x.content) == label]
    tips = [line for line in scene.lines if line.tip]
    return min(tips, key=lambda line: math.dist(line.points[-1], found.at))


def test_arrows_of_a_pendulum() -> None:
    name = "chapter6/ex11-ideal-pendulum"
    system, notation = system_of(name), reported(name).notation
    scene = free_body_scene(system, notation)
    assert scene is not None
    x, y = (evaluated(sp.Symbol(n, real=True), system) for n in "xy")
    (a, b), (c, d) = (labelled_tip(scene, label, notation).points for label in ("m g", "T_rod"))
    weight, pull = (b[0] - a[0], b[1] - a[1]), (d[0] - c[0], d[1] - c[1])
    assert abs(weight[0]) < CLOSE
    assert weight[1] < 0
    length = math.hypot(*pull)
    assert near((pull[0] / length, pull[1] / length), (-x / math.hypot(x, y), y / math.hypot(x, y)))


@pytest.mark.parametrize("name", SHIPPED)
def test_the_arrows_add_up_to_what_acts(name: str) -> None:
    """Each label times the direction of its arrow; the sum is the right side of Newton's law."""
    system = system_in_file(reported(name).solution)
    if system is None or not system.newton.bodies or free_body_scene(system, reported(name).notation) is None:
        return
    for body in system.newton.bodies:
        drawn = acting_on(system, body)
        pushing = [a for a in drawn if not a.is_moment]
        reactions = [v * r.force for r, v in body.reactions]
        total = [sum((v.fixed().components[n] for v in (body.applied, *reactions)), sp.S.Zero) for n in range(3)]
        labels = [a.label for a in pushing]
        if any(isinstance(x, str) for x in labels) or not _sizes_are_written(system, body, pushing):
            continue
        symbols = sorted(set().union(*(sp.sympify(e).free_symbols for e in (*total, *labels))), key=str)
        known = dict(system.pose.values) | {
            s: 0.7 + 0.2 * n for n, s in enumerate(symbols) if s not in system.pose.values
        }
        named = {
            r.tension: r.rod.factor * r.multiplier for r, _ in body.reactions if r.rod and r.tension and not r.named
        }
        for n in range(3):
            parts = []
            for a in pushing:
                size = sp.sympify(a.label).xreplace(named).subs(known)
                parts.append(float(size) * a.vector[n] / math.hypot(*a.vector))
            expected = float(sp.sympify(total[n]).subs(known))
            assert math.isclose(math.fsum(parts), expected, abs_tol=1e-7), (name, body.name)


def _sizes_are_written(system: System, body, pushing) -> bool:
    """Whether every label is a size: not where a reaction λ∇f is labelled λ alone."""
    for r, v in body.reactions:
        if r.rod is not None and r.tension is not None:
            continue
        length = math.sqrt(sum(evaluated(c, system) ** 2 for c in v.fixed().components)) if _is_static(system, v) else 0
        if abs(length - 1) > CLOSE:
            return False
    return bool(pushing)


def _is_static(system: System, v) -> bool:
    return all(c.free_symbols <= set(system.pose.values) for c in v.fixed().components)


def test_a_damper_pulls_towards_its_other_end() -> None:
    """The force of the damper on the body of the suspension is b(z1' − z2') downwards: its work is −b(z1' − z2')²."""
    system = system_of("motion/wheel-suspension")
    body = next(b for b in system.newton.bodies or () if b.name == "body")
    [damper] = [a for a in acting_on(system, body) if sp.Symbol("b", positive=True) in sp.sympify(a.label).free_symbols]
    z1, z2, b = sp.Symbol("z1'", real=True), sp.Symbol("z2'", real=True), sp.Symbol("b", positive=True)
    assert damper.vector[0] < 0
    assert sp.expand(damper.label - b * (z1 - z2)) == 0


# Shapes


def test_a_ladder_is_held_at_its_ends_and_a_hoop_is_a_wheel() -> None:
    ladder = system_of("motion/sliding-ladder")
    half = evaluated(sp.Symbol("l", positive=True), ladder)
    held = sorted(ladder.shapes["ladder"].held)
    assert near(held[0], (-half, 0))
    assert near(held[1], (half, 0))
    hoop = system_of("motion/hoop-on-incline")
    assert math.isclose(hoop.shapes["hoop"].radius, evaluated(sp.Symbol("R", positive=True), hoop))


def test_the_clapper_hangs_from_the_bell() -> None:
    system = system_of("motion/bell-and-clapper")
    alpha, l = (evaluated(s, system) for s in (sp.Symbol("alpha", real=True), sp.Symbol("l", positive=True)))
    [pin] = system.joints["clapper"]
    assert near(pin[:2], (l * math.cos(alpha), l * math.sin(alpha)))
    assert len(system.joints["bell"]) == 2


def test_a_curve_is_where_its_constraint_holds(problem) -> None:
    text = """
title: Bead on a wire
axes: {i: right, j: up}
parameters: [m, g, a]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
constraints: {wire: a*y = x^2}
gravity: -g*j
"""
    found = report(problem(text))
    system = system_in_file(found.solution)
    assert system is not None
    scene = configuration_scene(system, found.notation, with_loads=False)
    assert scene is not None
    [curve] = lines_of(scene, Kind.CURVE)
    a = system.pose.values[sp.Symbol("a", positive=True)]
    assert len(curve.points) > 20
    for u, v in curve.points:
        x, y = u / system.page.scale, v / system.page.scale
        assert abs(a * y - x**2) < 1e-7


# Coordinates


def test_angles_and_distances_are_recognised_by_what_they_do() -> None:
    system = system_of("motion/spring-pendulum")
    [point] = system.configuration.points
    r, phi = (next(q for q in system.pose.coordinates if q.name == name) for name in ("r", "phi"))
    mark = angle_mark(system.pose, phi, point.position)
    assert mark is not None
    assert math.hypot(*mark.centre) < CLOSE
    assert angle_mark(system.pose, r, point.position) is None
    assert is_distance(system.pose, r, point.position)
    assert not is_distance(system.pose, phi, point.position)
    doubled = point.position.fixed().xreplace({phi: 2 * phi})
    assert angle_mark(system.pose, phi, doubled) is None


@pytest.mark.parametrize("name", DRAWN)
def test_every_coordinate_of_a_known_problem_is_marked(name: str) -> None:
    marked = {label.content for scene in scenes(name) for label in scene.labels}
    assert set(reported(name).solution.configuration.slots.coordinates) - {sp.Symbol("y", real=True)} <= marked


# Views


def test_axes_point_as_the_words_say() -> None:
    down = view({"i": "right", "j": "down"}, frozenset({0, 1}))
    assert down.flat((1.0, 2.0, 0.0)) == (1.0, -2.0)
    assert view({"i": "down", "j": "right"}, frozenset({0, 1})).flat((1.0, 2.0, 0.0)) == (2.0, -1.0)
    assert view({"i": "down the incline", "j": "away from it"}, frozenset({0, 1})).flat((1.0, 2.0, 0.0)) == (1.0, 2.0)
    assert view({"i": "up"}, frozenset({0})).flat((2.0, 0.0, 0.0)) == (0.0, 2.0)
    assert view({"k": "up"}, frozenset({0, 2})).flat((1.0, 0.0, 2.0)) == (1.0, 2.0)


@pytest.mark.parametrize(
    "axes", [{}, {"k": "up"}, {"k": "down"}, {"i": "north", "j": "east", "k": "down"}, {"j": "up"}]
)
def test_space_is_right_handed(axes: dict[str, str]) -> None:
    """The third axis points at the reader where the other two turn counterclockwise."""
    found = view(axes, frozenset({0, 1, 2}))
    i, j, k = found.units
    depth = [
        next((sign for slant, sign in (((-0.45, -0.36), 1), ((0.45, 0.36), -1)) if u == slant), 0) for u in (i, j, k)
    ]
    rows = [[*u, d] if d == 0 else [0, 0, d] for u, d in zip(found.units, depth, strict=True)]
    assert float(sp.Matrix(rows).det()) == 1


# Labels


@pytest.mark.parametrize("name", SHIPPED)
def test_labels_are_on_nothing(name: str) -> None:
    for scene in scenes(name):
        for a, b in combinations(scene.labels, 2):
            assert not a.box.overlaps(b.box), (a, b)
        for label in scene.labels:
            assert not any(label.box.is_crossed(*piece) for line in scene.lines for piece in line.pieces), label
            assert not any(label.box.overlaps(Box(*d.at, *d.at).grown(d.radius * 0.99)) for d in scene.dots), label


def test_a_box_is_crossed() -> None:
    box = Box(0, 0, 2, 1)
    assert box.is_crossed((-1, 0.5), (3, 0.5))
    assert box.is_crossed((0.5, 0.5), (0.6, 0.6))
    assert not box.is_crossed((-1, 0.5), (-0.5, 0.5))
    assert not box.is_crossed((-1, 1), (1, 2.5))


# What is left out


@pytest.mark.parametrize("name", LEFT_OUT)
def test_what_cannot_be_drawn_is_left_out(name: str) -> None:
    assert scenes(name) == []
    assert "tikzpicture" not in latex.render([(reported(name).derivation, reported(name).notation)])


def test_nothing_is_drawn_for_the_terminal_and_for_programs(monkeypatch: pytest.MonkeyPatch) -> None:
    found = report(load(PROBLEMS / "chapter6/ex11-ideal-pendulum.yaml"))
    monkeypatch.setattr("lagrange.pictures.systems.general_pose", lambda *_: pytest.fail("a picture is drawn"))
    assert any(isinstance(b, Picture) for s in found.derivation.steps for b in s.body)
    pretty.text(found.derivation, found.notation, 80)
    json.render([found])
    with pytest.raises(pytest.fail.Exception):
        latex.render([(found.derivation, found.notation)])


# Renderers


@pytest.mark.parametrize("name", DRAWN)
def test_svg_is_well_formed_and_inside_its_box(name: str) -> None:
    for scene in scenes(name):
        element = ElementTree.fromstring(
            "\n".join(figure(scene, "P & Q", Writer(UNICODE, reported(name).notation).plain))
        )
        width, height = (float(n) for n in element.attrib["viewBox"].split()[2:])
        assert element[0].text == "P & Q"
        assert element.attrib["role"] == "img"
        assert len(element.findall("text")) == len(scene.labels)
        for path in element.findall("path"):
            numbers = [float(n) for n in path.attrib["d"].replace("M", " ").replace("L", " ").replace("Z", " ").split()]
            assert all(0 <= x <= width for x in numbers[::2])
            assert all(0 <= y <= height for y in numbers[1::2])


def test_letters_are_slanted_and_indices_lowered() -> None:
    assert spans("x₁") == '<tspan class="i">x</tspan><tspan dy="4" font-size="75%">1</tspan>'
    assert spans("T_rod g") == (
        '<tspan class="i">T</tspan><tspan dy="4" font-size="75%">rod</tspan><tspan dy="-4"> </tspan><tspan class="i">g</tspan>'
    )


@pytest.mark.skipif(shutil.which("pdflatex") is None, reason="there is no pdflatex")
def test_pictures_compile(tmp_path) -> None:
    document = latex.render([(reported(n).derivation, reported(n).notation) for n in DRAWN])
    (tmp_path / "a.tex").write_text(document, encoding="utf-8")
    call = ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "a.tex"]
    done = subprocess.run(call, cwd=tmp_path, capture_output=True, stdin=subprocess.DEVNULL, check=False)
    assert done.returncode == 0
    assert "Overfull" not in (tmp_path / "a.log").read_text(encoding="latin-1")


def test_a_page_has_figures_with_words() -> None:
    name = "motion/coupled-oscillators"
    page = html.render([(reported(name).derivation, reported(name).notation)])
    assert page.count("<figure>") == page.count("<figcaption>") == 2
    assert "<title>Drawing of the system: P, Q; left, middle, right, oil.</title>" in page
