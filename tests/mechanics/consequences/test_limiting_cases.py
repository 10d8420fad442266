"""Limits with a name: the equations in numbers, the names against what the books say."""

from __future__ import annotations

from functools import cache

import sympy as sp

from lagrange.mechanics.consequences.limiting_cases import Named
from lagrange.mechanics.meaning import ResultMeaning, meaning
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import load
from tests.support.shared import SHIPPED


@cache
def of(name: str) -> ResultMeaning:
    found = meaning(solve(load(str(SHIPPED[name]))))
    assert found is not None
    return found


def named(name: str, parameter: str) -> list[Named]:
    return [m.named for x in of(name).limits if x.parameter.name == parameter for m in x.named]


def symbol(e: sp.Expr, name: str) -> sp.Symbol:
    return next(s for s in e.free_symbols if s.name == name)


def test_limits_have_names() -> None:
    assert named("ex11-ideal-pendulum", "g") == [Named.CIRCLE]
    assert named("hill-moon", "n") == [Named.INVERSE_SQUARE]
    assert named("ex18-double-pendulum", "m2") == [Named.PENDULUM]
    assert named("oscillating-circuit", "R") == [Named.OSCILLATION]


def test_an_equation_with_a_term_less_is_no_limit() -> None:
    assert not of("ex10-double-pendulum").limits
    assert not of("boat-that-drifts").limits


def test_a_fast_light_leaves_the_oscillator() -> None:
    """For c → ∞ the relativistic oscillator has ω² = k/m, by Newton's law."""
    [limit] = [x for x in of("relativistic-oscillator").limits if x.parameter.name == "c"]
    [motion] = limit.named
    assert limit.to == sp.oo
    assert motion.named is Named.OSCILLATION
    assert motion.value == symbol(motion.value, "k") / symbol(motion.value, "m")


def test_pulleys_without_inertia() -> None:
    """The single weight m1 against m2 and m3 on a moving pulley, from Newton's law with equal tensions in numbers.

    With T in the upper string and T/2 in the lower one: m1 a = m1 g − T, m2 a2 = m2 g − T/2, m3 a3 = m3 g − T/2, and
    2a + a2 + a3 = 0.
    """
    massless = of("double-atwood").massless
    assert massless is not None
    assert {s.name for s in massless.vanishing} == {"I_1", "I_2", "M"}
    m1, m2, m3, g, R = 5.0, 2.0, 3.0, 10.0, 0.5
    a, a2, a3, tension = sp.symbols("a a2 a3 T")
    laws = [m1 * a - m1 * g + tension, m2 * a2 - m2 * g + tension / 2, m3 * a3 - m3 * g + tension / 2, 2 * a + a2 + a3]
    [(expected, *_)] = sp.linsolve(laws, a, a2, a3, tension)
    [alpha] = [e for q, e in massless.accelerations.items() if q.name == "alpha''"]
    values = {"m1": m1, "m2": m2, "m3": m3, "g": g, "R": R}
    assert abs(float(alpha.xreplace({s: sp.Float(values[s.name]) for s in alpha.free_symbols}) * R - expected)) < 1e-12


def test_what_may_grow_is_not_neglected() -> None:
    """In a narrow cone r φ'² sin² α is p²/(m² r³ sin² α) by the momentum; a flat cone is a table."""
    assert [x.to for x in of("marble-in-a-cone").limits] == [sp.pi / 2]
    assert named("marble-in-a-cone", "alpha") == [Named.FREE]
