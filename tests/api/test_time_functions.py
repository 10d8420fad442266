"""Functions of time as SymPy has them, in both directions."""

from __future__ import annotations

import pytest
import sympy as sp
from sympy.physics.mechanics import dynamicsymbols

import lagrange
from lagrange.api.time_functions import SympyReader, in_functions_of_time

t = sp.Symbol("t")
l, m, g = sp.symbols("l m g")


@pytest.fixture(scope="module")
def pendulum() -> lagrange.Result:
    return lagrange.solve(lagrange.load("ex11"))


def test_functions_of_time_are_those_of_sympy(pendulum: lagrange.Result) -> None:
    theta = dynamicsymbols("theta")
    [equation] = pendulum["angle"].equations_in_time()
    names = {s: sp.Symbol(s.name) for s in equation.free_symbols}
    assert equation.xreplace(names) == sp.Eq(l * theta.diff(t, 2) + g * sp.sin(theta), 0)
    assert len(pendulum.own.equations_in_time()) == 2  # the constraint is one of them
    s = sp.Symbol("s")
    assert pendulum["angle"].in_time(pendulum["angle"].velocities[0], s) == sp.Function("theta")(s).diff(s)


@pytest.mark.parametrize(
    "name", ["ex09", "ex11", "ex13", "kapitza-pendulum", "sleigh", "foucault-pendulum", "mass-on-belt"]
)
def test_functions_of_time_are_read_back(name: str) -> None:
    problem = lagrange.load(name)
    reader = SympyReader(problem.scope)
    for c in problem.constraints:
        rate = problem.slots.time_derivative(c.function)
        for e in (c.function, rate if c.kinematic else problem.slots.time_derivative(rate)):
            written = in_functions_of_time(e, problem.slots)
            assert not any(str(s).endswith("'") for s in written.free_symbols)
            assert sp.expand(reader.expression(written) - e) == 0


def test_a_prescribed_motion_has_the_rates_that_a_text_may_have() -> None:
    scope = lagrange.loads("title: p\ncoordinates: [x]\nfunctions: {u: [t]}\n").scope
    u = dynamicsymbols("u")
    assert str(SympyReader(scope).expression(sp.Derivative(u.diff(t, 3), t))) == "u''''"
    with pytest.raises(lagrange.ProblemError, match="too-many-primes"):
        SympyReader(scope).expression(u.diff(t, 5))


theta = dynamicsymbols("theta")
