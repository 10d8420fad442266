"""Stability of equilibria."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.answers.examiner import check_answer
from lagrange.answers.verdicts import Judgement
from lagrange.core.diagnostics import Fragment, Source
from lagrange.mechanics.equilibrium.stability import StabilityVerdict as Stable
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import read_problem
from lagrange.problem.model import Problem
from tests.support.statics_texts import ATWOOD, BEAD, CHAIN, PENDULUM, SPRINGS


def read(text: str) -> Problem:
    return read_problem(Source("problem.yaml", text))


def symbols(names: str, **assumptions: bool) -> tuple[sp.Symbol, ...]:
    return tuple(sp.Symbol(n, **assumptions) for n in names.split())


@pytest.mark.parametrize(
    ("text", "verdicts"),
    [
        (BEAD, [Stable.CONDITIONAL, Stable.UNSTABLE, Stable.STABLE]),
        (CHAIN, [Stable.CONDITIONAL]),
        (ATWOOD, [Stable.UNDECIDED]),
        (SPRINGS, [Stable.CONDITIONAL, Stable.STABLE, Stable.STABLE]),
    ],
    ids=["bead", "chain", "atwood", "spring"],
)
def test_stability(text: str, verdicts: list[Stable]) -> None:
    stability = solve(read(text)).own.stability
    assert stability is not None
    assert [s.verdict for s in stability.verdicts] == verdicts


def test_stability_conditions() -> None:
    a, b = symbols("a b", positive=True)
    stability = solve(read(BEAD)).own.stability
    assert stability is not None
    [c] = stability.verdicts[0].conditions
    assert (c.lhs, c.relation, c.rhs) == (b, ">", a)


def test_stability_in_a_choice() -> None:
    angle = solve(read(PENDULUM)).choices[0]
    assert angle.stability is not None
    assert [s.verdict for s in angle.stability.verdicts] == [Stable.STABLE, Stable.UNSTABLE]


def test_no_stability_without_a_potential() -> None:
    """A force that turns with the last rod has no potential."""
    text = CHAIN.replace("vector: P*i", "vector: P*cos(phi)*i + P*sin(phi)*j")
    assert solve(read(text)).own.stability is None


def verdict(problem: Problem, *equations: str) -> Judgement:
    return check_answer(problem, tuple(Fragment.of(e) for e in equations))


@pytest.mark.parametrize(
    ("potential", "verdict", "order"),
    [
        ("a*theta^2/2 + a*cos(theta)", Stable.STABLE, 4),
        ("-a*theta^2/2 - a*cos(theta)", Stable.UNSTABLE, 4),
        ("a*theta - a*sin(theta)", Stable.UNSTABLE, 3),
        ("a*theta^2/2 + a*cos(theta) - a*theta^4/24", Stable.UNSTABLE, 6),
        ("b*(1 - cos(theta))^4", Stable.UNDECIDED, 2),
    ],
)
def test_higher_derivatives_where_the_second_is_zero(potential: str, verdict: Stable, order: int) -> None:
    text = f"title: v\nparameters: [a, b]\ncoordinates: [theta]\nforces: {{v: {{potential: '{potential}'}}}}\n"
    stability = solve(read(text)).own.stability
    assert stability is not None
    assert (stability.verdicts[0].verdict, stability.verdicts[0].order) == (verdict, order)


WIRE = """
title: Bead on an elliptic wire
parameters: [m, a, b, g]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
constraints: {wire: x^2/a^2 + y^2/b^2 = 1}
gravity: -g*j
find: equilibrium
"""


def test_stability_where_other_displacements_are_free() -> None:
    """δx = −(a² y/(b² x)) δy fails at x = 0, where y = ∓b (1 − x²/(2a²)) gives V'' = ± m g b/a²."""
    solution = solve(read(WIRE))
    assert solution.own.equilibrium is not None
    assert solution.own.stability is not None
    m, a, b, g = symbols("m a b g", positive=True)
    for branch, s in zip(solution.own.equilibrium.branches, solution.own.stability.verdicts, strict=True):
        below = {str(r.lhs): r.rhs for r in branch.relations}["y"] == -b
        assert s.verdict is (Stable.STABLE if below else Stable.UNSTABLE)
        assert [str(q) for q in s.free] == ["x"]
        assert sp.cancel(s.minors[0] - (1 if below else -1) * m * g * b / a**2) == 0


def test_the_second_derivative_of_a_modulus_is_shown_without_its_jump() -> None:
    """V = k |x − a| + c x²: V'' = 2 c where x ≠ a; a Dirac delta stood on the page."""
    text = (
        "title: Modulus\nparameters: [k, a, c]\ncoordinates: [x]\n"
        "forces: {f: {potential: k*abs(x - a) + c*x^2}}\nfind: equilibrium\n"
    )
    found = solve(read(text))
    second = found.own.stability
    assert second is not None
    assert not any(v.has(sp.DiracDelta) for row in second.matrix for v in row)
    assert len(second.jumps) == 1
