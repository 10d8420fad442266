"""The normal force comes before the principle that contains it."""

from __future__ import annotations

from lagrange.document.derivation import Rule
from lagrange.explain.report import report
from lagrange.problem.loader import load
from tests.support.shared import SHIPPED


def order(name: str) -> list[Rule]:
    page = report(load(str(SHIPPED[name])), None, complete=False).derivation.page
    return [s.rule for s in page if not s.folded and s.rule in (Rule.PRINCIPLE, Rule.SOLVED_REACTIONS)]


def test_friction_has_its_normal_force_before_the_principle() -> None:
    assert order("ex15-rough-incline") == [Rule.SOLVED_REACTIONS, Rule.PRINCIPLE]


def test_without_friction_the_reaction_comes_last() -> None:
    assert order("ex11-ideal-pendulum") == [Rule.PRINCIPLE, Rule.SOLVED_REACTIONS]
