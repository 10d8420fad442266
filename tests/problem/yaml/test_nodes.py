"""The nodes of a file, with their places."""

from __future__ import annotations

from lagrange.core.diagnostics import Source
from lagrange.problem.diagnostic_collector import Diagnostics
from lagrange.problem.yaml.composer import parse
from lagrange.problem.yaml.nodes import MappingNode, scalars


def test_scalars_are_in_the_order_of_the_file() -> None:
    text = "a: 1\nb: [x, {c: 'y'}]\nd: \n"
    root = parse(Source("file", text), Diagnostics())
    assert isinstance(root, MappingNode)
    found = [*scalars(root)]
    assert [s.text for s in found] == ["a", "1", "b", "x", "c", "y", "d", ""]
    assert [s.quoted for s in found if s.text == "y"] == [True]
    assert found[-1].is_empty
    assert text[found[3].span.start : found[3].span.end] == "x"
