"""Pictures in files: SVG by itself, with its colours in it, without scripts."""

from __future__ import annotations

from xml.etree import ElementTree

from lagrange.document.derivation import Picture
from lagrange.document.math_writer import UNICODE, Writer
from lagrange.render.html import CSS
from lagrange.render.notes.svg_file import MARK, STYLE, Figures, svg_file
from tests.support.shared import reported

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
