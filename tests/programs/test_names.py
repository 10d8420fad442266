"""Names of a problem as names of a programming language."""

from __future__ import annotations

import sympy as sp

from lagrange.programs.names import RESERVED, ProgramNames, legal_name


def test_names_are_legal_and_differ() -> None:
    assert [legal_name(n) for n in ("theta'", "θ''", "x_1", "2x", "π", "ξ₁")] == [
        "theta_dot", "theta_ddot", "x_1", "", "pi", "xi",
    ]  # fmt: skip
    names = ProgramNames()
    made = [names.readable(sp.Symbol(n)) for n in ("lambda", "x'", "x_dot", "I", "sin", "é", "f", "a", "a")]
    assert made == ["lambda_", "x_dot", "x_dot_1", "I_", "sin_", "s", "f_", "a", "a"]
    assert not set(made) & RESERVED
