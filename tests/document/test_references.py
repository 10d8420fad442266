"""References under other labels, in prose and beside equations."""

import sympy as sp

from lagrange.document.builders import display, prose
from lagrange.document.derivation import Display, Equation, Prose, Ref, Rule, Step
from lagrange.document.references import labels_in, not_referring, referring_to


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


def test_references_to_missing_equations_are_words() -> None:
    x = sp.Symbol("x")
    shown = Step(Rule.PRINCIPLE, "Principle", (display(Equation((x, x), label="kept")),))
    assert labels_in([shown]) == {"kept"}
    said = not_referring(prose("By ", Ref("lost"), " and ", Ref("kept"), "."), lambda label: label not in {"kept"})
    assert said == prose("By ", "an equation left out here", " and ", Ref("kept"), ".")
