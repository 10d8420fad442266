"""What is found to be conserved, and compared with what is expected."""

from __future__ import annotations

import re

import sympy as sp

from lagrange.core.diagnostics import Source
from lagrange.mechanics.dynamics.conservation import Conserved
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import read_problem


def read(text: str) -> sp.Expr:
    """An expression of the table; v_q is q'."""
    names = set(re.findall(r"[A-Za-z_]\w*", text)) - {"sin", "cos", "sqrt"}
    local = {n: sp.Symbol(n.removeprefix("v_") + "'" if n.startswith("v_") else n, real=True) for n in names}
    return sp.sympify(text.replace("^", "**"), locals=local)


def of(text: str) -> Conserved:
    found = solve(read_problem(Source("p.yaml", text)), complete=True).own.conserved
    assert found is not None
    return found


GIVEN_FORCE = """
title: Central force, given
parameters: [m, kappa, c]
coordinates: [x, y]
particles:
  P: {mass: m, position: x*i + y*j}
forces:
  pull: {on: P, vector: "-kappa*(x*i + y*j)/(x^2 + y^2)^(3/2)"}
"""


def differences(found: Conserved, *expected: str) -> list[sp.Expr]:
    """The integrals less the expected ones, in the symbols of the table."""
    plain = [i.expression.xreplace({s: sp.Symbol(s.name, real=True) for s in i.expression.free_symbols})
             for i in found.integrals]  # fmt: skip
    return [sp.expand(p - read(e)) for p, e in zip(plain, expected, strict=True)]
