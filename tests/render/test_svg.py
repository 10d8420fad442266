"""Drawings on a web page.

Pictures in files: SVG by itself, with its colours in it, without scripts.
"""

from __future__ import annotations

from xml.etree import ElementTree

import pytest

from lagrange.document.derivation import Picture
from lagrange.document.math_writer import UNICODE, Writer
from lagrange.document.scene import Label, Scene
from lagrange.render.html import CSS
from lagrange.render.svg import MARK, STYLE, Figures, content_of, figure, spans, svg_file
from lagrange.render.tikz import picture
from tests.support.drawings import DRAWN, scenes
from tests.support.shared import reported


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


def test_text_in_a_figure_steers_nothing_and_is_no_markup() -> None:
    words = "m\x1b[2J\x9b\u202e <b>\\input{x}"
    assert content_of(words, str) == "m[2J &lt;b&gt;\\input{x}"
    scene = Scene((), (), (Label(words, (0.0, 0.0), 1.0, 1.0),))
    [drawn] = [line for line in picture(scene, str) if "node" in line]
    assert r"{\small m[2J <b>\textbackslash{}input\{x\}}" in drawn.replace("$<$", "<").replace("$>$", ">")


def test_letters_are_slanted_and_indices_lowered() -> None:
    assert spans("x₁") == '<tspan class="i">x</tspan><tspan dy="4" font-size="75%">1</tspan>'
    assert spans("T_rod g") == (
        '<tspan class="i">T</tspan><tspan dy="4" font-size="75%">rod</tspan><tspan dy="-4"> </tspan><tspan class="i">g</tspan>'
    )


# Svg file


SVG = "{http://www.w3.org/2000/svg}"


def pictures(name: str) -> list[str]:
    found = reported(name)
    blocks = [b for s in found.derivation.steps for b in s.body if isinstance(b, Picture)]
    writer = Writer(UNICODE, found.notation)
    scenes = [(b.draw(), b.alt) for b in blocks]
    return [svg_file(scene, alt, writer.plain) for scene, alt in scenes if scene is not None]


def test_the_file_stands_by_itself() -> None:
    for text in pictures("ex11-ideal-pendulum"):
        assert text.startswith(MARK)
        root = ElementTree.fromstring(text)
        assert root.tag == f"{SVG}svg"
        assert root.find(f"{SVG}rect[@class='paper']") is not None
        assert not [e for e in root.iter() if e.tag in (f"{SVG}script", f"{SVG}image", f"{SVG}foreignObject")]


def test_programs_for_print_understand_its_colours() -> None:
    assert "var(" not in STYLE
    assert "color-mix" not in STYLE
    assert "currentColor" not in STYLE


def test_every_kind_of_line_that_the_pages_colour_has_its_style() -> None:
    kinds = {c for c in CSS.replace(",", " ").split() if c.startswith(".picture")}
    assert kinds
    for kind in (
        "guide",
        "axis",
        "curve",
        "reference",
        "ground",
        "hatch",
        "grid",
        "angle",
        "dimension",
        "face",
        "force",
    ):
        assert f".picture .{kind}" in CSS
        assert f".{kind}" in STYLE


def test_the_same_picture_is_one_file() -> None:
    figures = Figures("a")
    assert [figures.add(text) for text in ("x", "y", "x", "z")] == ["a.svg", "a-2.svg", "a.svg", "a-3.svg"]
