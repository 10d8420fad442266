"""A Lagrangian whose momenta are not linear in the velocities."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.mechanics.solution import solve
from tests.support.problem_texts import read


@pytest.mark.parametrize(
    ("lagrangian", "expected"),
    [
        ("-m*c^2*sqrt(1 - (r'^2 + r^2*phi'^2)/c^2) + K/r", "sqrt(m^2*c^4 + c^2*(p_r^2 + p_phi^2/r^2)) - K/r"),
        (
            "-m*c^2*sqrt(1 - (r'^2 + r^2*phi'^2)/c^2) + K*r^2*phi'",
            "c*sqrt(m^2*c^2 + p_r^2 + (p_phi - K*r^2)^2/r^2)",
        ),
    ],
)
def test_a_fast_particle(lagrangian: str, expected: str) -> None:
    """Goldstein, § 8.4: T + m c² = √(p² c² + m² c⁴), in a central field and with a potential linear in the velocity."""
    solution = solve(
        read(f"title: T\ncoordinates: [r, phi]\nparameters: [m, c, K]\nlagrangian: {lagrangian}\nfind: hamiltonian\n")
    )
    found = solution.own.hamiltonian
    assert found is not None
    assert solution.holds
    assert [found.coordinates[k].name for k in found.cyclic] == ["phi"]
    names = {s.name: s for s in found.function.free_symbols}
    wanted = sp.sympify(expected.replace("^", "**"), locals=names)
    values = {s: sp.Rational(n + 3, 7) for n, s in enumerate(sorted(found.function.free_symbols, key=str))}
    assert abs(float((found.function - wanted).xreplace(values))) < 1e-12
