"""References under other labels, in prose and beside equations."""

import sympy as sp

from lagrange.document.builders import display, prose
from lagrange.document.derivation import Display, Equation, Prose, Ref
from lagrange.document.references import referring_to


def test_references_are_relabelled_in_prose_and_conditions() -> None:
    x = sp.Symbol("x")
    blocks = [
        prose("By ", Ref("old"), " and ", Ref("kept"), "."),
        display(Equation((x, x), condition=("by ", Ref("old")))),
    ]
    said, shown = referring_to(blocks, {"old": "new"})
    assert isinstance(said, Prose)
    assert said.parts == ("By ", Ref("new"), " and ", Ref("kept"), ".")
    assert isinstance(shown, Display)
    assert shown.equations[0].condition == ("by ", Ref("new"))
