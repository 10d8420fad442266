"""Derivations as texts: every reference has its equation, and no equation is referred to before it stands."""

from __future__ import annotations

import pytest
from conftest import PROBLEMS

from lagrange.derivation import CheckMark, Derivation, Display, Part, Prose, Ref, Rule, Table
from lagrange.loader import load
from lagrange.report import report

SHIPPED = sorted(PROBLEMS.rglob("*.yaml"))


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


@pytest.mark.parametrize("path", SHIPPED, ids=lambda p: p.stem)
def test_references_point_back_to_equations(path: object) -> None:
    derivation = report(load(path)).derivation  # type: ignore[arg-type]
    labels: set[str] = set()
    for kind, name in reading(derivation):
        if kind == "label":
            assert name not in labels, f"{name} stands twice"
            labels.add(name)
        else:
            assert name in labels, f"{name} is referred to before it stands"


@pytest.mark.parametrize("path", SHIPPED, ids=lambda p: p.stem)
def test_steps_come_in_the_order_of_the_textbook(path: object) -> None:
    steps = report(load(path)).derivation.steps  # type: ignore[arg-type]
    order = list(Rule)
    again = (Rule.GENERALIZED_COORDINATES, Rule.EQUATIONS_OF_MOTION, Rule.SOLVED_REACTIONS)  # one for each choice
    first = [order.index(s.rule) for s in steps if s.rule not in again]
    assert first == sorted(first)
    assert steps[0].rule is Rule.STATEMENT
    assert steps[-1].rule is Rule.CHECKS
    assert all(s.title and s.body for s in steps)
