"""V along its valleys in numbers: the check holds for what is right, and sees what is not."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import pytest

from lagrange.core.diagnostics import Source
from lagrange.mechanics.equilibrium.searched.valleys_in_numbers import check_minima, check_valleys
from lagrange.mechanics.equilibrium.stability import SecondVariation, StabilityVerdict
from lagrange.mechanics.results import InCoordinates
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import read_problem

STABLE, UNSTABLE = StabilityVerdict.STABLE, StabilityVerdict.UNSTABLE


@cache
def own(coordinates: str, potential: str, constraint: str = "") -> InCoordinates:
    constraints = f"constraints: {{c: '{constraint}'}}\n" if constraint else ""
    text = f"title: V\nparameters: [a, b, c]\ncoordinates: [{coordinates}]\n{constraints}"
    return solve(
        read_problem(Source("p", f"{text}forces: {{v: {{potential: '{potential}'}}}}\nfind: equilibrium\n"))
    ).own


def passed(view: InCoordinates, verdict: StabilityVerdict | None = None, order: int | None = None) -> list[bool | None]:
    """The outcome, with another verdict or another order where the second variation vanishes."""
    assert view.equilibrium is not None
    assert view.stability is not None
    verdicts = [
        replace(s, verdict=verdict or s.verdict, order=order or s.order) if s.order != 2 else s
        for s in view.stability.verdicts
    ]
    second = SecondVariation(view.stability.coordinates, view.stability.matrix, tuple(verdicts))
    return [c.passed for c in check_valleys(view.equilibrium, second)]


@pytest.mark.parametrize(
    ("coordinates", "potential", "constraint", "stable"),
    [
        ("theta", "a*(theta^2/2 + cos(theta))", "", True),
        ("theta", "-a*(theta^2/2 + cos(theta))", "", False),
        ("x, y", "a*x^4 + b*x^2*y^2 + c*y^4", "", True),
        ("x, y", "a*(x^4 + y^4 - 3*x^2*y^2)", "", False),
        ("x, y", "a*(x^2 - y)^2 + b*y^3", "", True),  # the valley y = x²: b x⁶
        ("x, y", "a*(y - x^2)^2 - b*x^4", "", False),
        ("x, theta", "c*(x - a*sin(theta))^2", "x = a*theta", True),  # of order 6
    ],
)
def test_minima_and_others(coordinates: str, potential: str, constraint: str, stable: bool) -> None:
    view = own(coordinates, potential, constraint)
    assert passed(view) == [True]
    wrong = passed(view, UNSTABLE if stable else STABLE)
    assert wrong == [None if stable else False]  # where V falls nowhere, a narrow cone may have been missed


def test_a_term_of_lower_order_is_seen() -> None:
    assert passed(own("theta", "a*(theta^2/2 + cos(theta))"), order=6) == [None]


def test_at_the_limit_of_a_condition() -> None:
    """k θ²/2 + W l cos θ at k = W l: of order 4, and stable."""
    view = own("theta", "a*theta^2/2 + b*c*cos(theta)")
    assert view.equilibrium is not None
    assert view.stability is not None
    [s, *_] = view.stability.verdicts
    assert s.at_limit is not None
    assert [c.passed for c in check_minima(view.equilibrium, view.stability)] == [True, True]
    false = replace(s, at_limit=replace(s.at_limit, verdict=UNSTABLE))
    changed = replace(view.stability, verdicts=(false, *view.stability.verdicts[1:]))
    assert [c.passed for c in check_valleys(view.equilibrium, changed)] == [None]
