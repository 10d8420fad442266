"""Linear equations with a coordinate instead of the root that is its value, tried in numbers."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.mechanics.rewriting.equilibrium_values import by_coordinates
from tests.mechanics.rewriting.test_combinations import view_of


def test_hills_moon() -> None:
    view = view_of("hill-moon")
    short = by_coordinates(view)
    assert short is not None
    assert view.linearization is not None
    assert short.linearization is not None
    old, new = view.linearization.at[0], short.linearization.at[0]
    assert old is not None
    assert new is not None
    names = {s.name: s for e in (*old.equations, *new.equations) for s in e.free_symbols}
    values = {s: sp.Float(0.3 + 0.17 * k) for k, s in enumerate(names.values()) if s.name != "r"}
    values[names["r"]] = (values[names["K"]] / (3 * values[names["n"]] ** 2)) ** sp.Rational(1, 3)
    for a, b in zip(new.equations, old.equations, strict=True):
        assert sp.count_ops(a) < sp.count_ops(b)
        assert not any(p.exp.is_Rational and not p.exp.is_Integer for p in a.atoms(sp.Pow))
        ratios = [float(e.xreplace(values)) for e in (a, b)]
        other = values | {s: 2 * v for s, v in values.items() if s.name.startswith("xi_1")}
        again = [float(e.xreplace(other)) for e in (a, b)]
        assert ratios[0] / ratios[1] == pytest.approx(again[0] / again[1])


def test_nothing_changes_without_roots() -> None:
    assert by_coordinates(view_of("coupled-oscillators")) is None
    assert by_coordinates(view_of("ex11-ideal-pendulum")) is None
