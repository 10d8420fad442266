"""Newton's law along one reaction, by hand."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.mechanics.rewriting.projections import projections
from tests.support.shared import solved


@pytest.mark.parametrize(
    ("name", "stated"),
    [
        ("ex11-ideal-pendulum", {"T_rod": ("m*l*theta'^2", "T_rod - m*g*cos(theta)")}),
        ("loop-the-loop", {"N": ("m*R*theta'^2", "N - m*g*cos(theta)")}),
        ("cylinder-on-rough-incline", {"N": ("0", "N - m*g*cos(alpha)"), "F": ("m*x''", "F + m*g*sin(alpha)")}),
        (
            "cylinder-on-wedge",  # along the slope's normal; the wedge itself is held by the table too
            {"N": ("m*X''*sin(alpha)", "N - m*g*cos(alpha)"), "F": ("m*(s'' + X''*cos(alpha))", "F + m*g*sin(alpha)")},
        ),
        (
            "ex18-double-pendulum",  # the lower rod pulls the upper particle down by its share along the upper rod
            {
                "T_lower_rod": (
                    "m2*l2*phi2'^2 + m2*l1*phi1'^2*cos(phi1 - phi2) + m2*l1*phi1''*sin(phi1 - phi2)",
                    "T_lower_rod - m2*g*cos(phi2)",
                ),
                "T_upper_rod": (
                    "m1*l1*phi1'^2",
                    "T_upper_rod - m1*g*cos(phi1) - T_lower_rod*cos(phi1 - phi2)",
                ),
            },
        ),
    ],
)
def test_the_law_along_each_reaction(name: str, stated: dict[str, tuple[str, str]]) -> None:
    solution = solved(name, complete=False)
    assert solution.law is not None
    found = projections(solution.law.newton.in_tensions, solution.chosen)
    letters = {s.name: s for p in found for e in (p.inertia, p.right) for s in e.free_symbols}
    assert len(found) == len(stated)
    for p in found:
        for value, written in zip((p.inertia, p.right), stated[p.force.name], strict=True):
            assert sp.simplify(value - _read(written, letters)) == 0


def _read(written: str, letters: dict[str, sp.Symbol]) -> sp.Expr:
    """The expression; a prime is written as a letter for SymPy."""
    names = {name.replace("'", "_d"): s for name, s in letters.items()}
    return sp.sympify(written.replace("^", "**").replace("'", "_d"), locals=names)


@pytest.mark.parametrize("name", ["rolling-disc", "ex16-rod-on-two-planes"])
def test_none_where_it_gives_no_single_force(name: str) -> None:
    """Several reactions along one line, and forces at rest."""
    solution = solved(name, complete=False)
    assert solution.law is not None
    assert not projections(solution.law.newton, solution.chosen)
