"""Drawings on a web page."""

from __future__ import annotations

from xml.etree import ElementTree

import pytest

from lagrange.document.math_writer import UNICODE, Writer
from lagrange.document.scene import Label, Scene
from lagrange.render.svg import content_of, figure, spans
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
