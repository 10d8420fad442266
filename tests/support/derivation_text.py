"""What a derivation says, for tests of its words: its labels and references, its formulas, its sentences."""

from __future__ import annotations

from lagrange.document.derivation import CheckMark, Derivation, Display, Math, Part, Prose, Ref, Rule, Step, Table
from lagrange.document.math_writer import unicode
from tests.support.shared import reported


def reading(derivation: Derivation) -> list[tuple[str, str]]:
    """("label", x) and ("ref", x) in the order in which they are read."""
    found: list[tuple[str, str]] = []

    def parts(several: tuple[Part, ...]) -> None:
        found.extend(("ref", p.label) for p in several if isinstance(p, Ref))

    for step in derivation.steps:
        for block in step.body:
            match block:
                case Prose(parts=p):
                    parts(p)
                case Display(equations=equations):
                    for e in equations:
                        if e.label:
                            found.append(("label", e.label))
                        parts(e.condition)
                case Table(header=header, rows=rows):
                    parts(header)
                    for row in rows:
                        parts(row)
                case CheckMark(name=name):
                    parts(name)
    return found


def mathematics(step: Step) -> list[object]:
    """All that is written in formulas in a step."""
    found: list[object] = []
    for block in step.body:
        if isinstance(block, Display):
            found += [side for e in block.equations for side in e.sides]
        if isinstance(block, Prose):
            found += [side for p in block.parts if isinstance(p, Math) for side in p.sides]
    return found


def words(step: Step) -> str:
    """The sentences of a step, with the formulas in the text."""
    texts = []
    for block in step.body:
        if isinstance(block, Prose):
            texts += [
                p if isinstance(p, str) else unicode(p.sides[0]) if isinstance(p, Math) else "" for p in block.parts
            ]
    return "".join(texts)


def said_in(name: str, rule: Rule, *, on_page: bool = False) -> str:
    """The sentences of a shipped problem's steps of one kind: of all steps, or of those that a page shows."""
    derivation = reported(name).derivation
    return " ".join(words(s) for s in (derivation.page if on_page else derivation.steps) if s.rule is rule)
