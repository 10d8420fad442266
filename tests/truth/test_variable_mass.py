"""Masses that vary, against a balance of momentum in numbers: mass leaves or joins in small lumps, one after another.

Each lump leaves or joins in an instant, in which the momentum of the particle and the lump together does not change;
between two of them the particle has a constant mass. Nothing of `lagrange` is used but the printed answers.
"""

from __future__ import annotations

from math import cosh, log, sqrt

import pytest
import sympy as sp

from tests.support.paths import PROBLEMS
from tests.support.shared import solved

MOTION = PROBLEMS / "motion"
G = 9.5


def answers(name: str, values: dict[str, float]) -> dict[str, float]:
    """The answers to the questions of a shipped problem, in numbers."""
    solution = solved(MOTION / f"{name}.yaml", complete=False)
    rule = {sp.Symbol(k): v for k, v in values.items()}
    found = {}
    for a in solution.asked:
        [b] = a.branches
        named = b.rhs.xreplace({s: sp.Symbol(s.name) for s in b.rhs.free_symbols})
        found[a.question.name] = float(named.subs(rule))
    return found


def test_a_rocket_that_throws_out_lumps_of_gas() -> None:
    m, u, q, end, lumps = 5.0, 20.0, 0.4, 8.0, 10_000
    dt, y, v = end / lumps, 0.0, 0.0
    for _ in range(lumps):
        v, y = v - G * dt, y + v * dt
        lump = q * dt
        v = (m * v - lump * (v - u)) / (m - lump)
        m -= lump
    values = {"m_0": 5.0, "m_1": m, "u": u, "q": q, "g": G, "t": end}
    found = answers("rocket", values)
    assert found["speed"] == pytest.approx(v, rel=1e-3)
    assert found["at_burnout"] == pytest.approx(v, rel=1e-3)
    assert v == pytest.approx(u * log(5.0 / m) - G * end, rel=1e-3)


def test_a_drop_that_strikes_lumps_of_mist() -> None:
    k, b, lumps = 3.0, 0.5, 10_000
    dx = b / lumps
    x, square = b, 0.0
    for _ in range(lumps):  # energy between two lumps, momentum at each
        square += 2 * G * dx
        square *= ((x / (x + dx)) ** 3) ** 2
        x += dx
    found = answers("raindrop", {"k": k, "b": b, "g": G, "x": x})
    assert found["speed"] == pytest.approx(sqrt(square), rel=1e-3)
    assert found["acceleration"] == pytest.approx(G - 3 * square / x, rel=1e-3)


def test_a_load_that_jerks_up_a_chain_link_by_link() -> None:
    M, density, links = 2.0, 1.5, 10_000
    top = sqrt(3) * M / density
    dx = top / links
    x, square, halfway = 0.0, 0.0, 0.0
    for n in range(links - 1):
        moved = M + density * x
        square += 2 * (M - density * x) * G * dx / moved
        square *= (moved / (moved + density * dx)) ** 2
        x += dx
        halfway = square if n == links // 2 else halfway
    found = answers("load-that-lifts-a-chain", {"M": M, "rho": density, "h": 9.0, "g": G, "x": top / 2})
    assert found["lowest"] == pytest.approx(top)
    assert found["speed"] == pytest.approx(halfway, rel=5e-3)
    assert abs(square) < 1e-2 * halfway


def test_a_chain_of_links_that_all_have_the_same_speed() -> None:
    l, a, links, dt = 2.0, 0.4, 4000, 1e-4
    x, v, time = a, 0.0, 0.0
    while x < l:
        hanging = round(x / l * links) / links
        v += G * hanging * dt
        x, time = x + v * dt, time + dt
    found = answers("chain-off-a-table", {"l": l, "a": a, "g": G, "t": time, "rho": 1.0})
    assert found["speed"] == pytest.approx(v, rel=5e-3)
    assert found["length"] == pytest.approx(x, rel=5e-3)
    assert a * cosh(sqrt(G / l) * time) == pytest.approx(x, rel=5e-3)
