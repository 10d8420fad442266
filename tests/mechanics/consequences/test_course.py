"""How motions go on, against hand calculations."""

from __future__ import annotations

import math
from functools import cache

import pytest
import sympy as sp

from lagrange.core.diagnostics import Source
from lagrange.mechanics.consequences.course import swinging_rate
from lagrange.mechanics.meaning import ResultMeaning, meaning
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import load, read_problem
from tests.support.shared import SHIPPED


@cache
def of(name: str) -> ResultMeaning:
    found = meaning(solve(load(str(SHIPPED[name]))))
    assert found is not None
    return found


def test_a_block_speeds_up_on_a_steep_plane() -> None:
    sense = of("ex15-rough-incline").sense
    assert sense is not None
    assert {type(sense.more), type(sense.less)} == {sp.tan, sp.Symbol}
    assert sense.more == sp.tan(next(iter(sense.more.free_symbols)))
    assert str(sense.less) == "mu"


def test_a_ladder_leaves_the_wall_at_two_thirds_of_its_height() -> None:
    [place] = of("sliding-ladder").released
    assert place.force.name == "W"
    assert place.wave == sp.sin(place.coordinate)
    assert place.place == sp.Rational(2, 3) * sp.sin(place.start)
    assert place.provided is None
    assert place.exact
    assert [s.name for s in place.others] == ["N"]
    assert (place.heavy, place.is_body, place.fallen) == ("ladder", True, sp.Rational(1, 3))


def test_the_floor_does_not_let_go_before_the_wall() -> None:
    """N = m g [(3 u − u_0)² + 1 − u_0²]/4 with u = sin θ, against its value with the energy, in numbers."""
    for first in (0.3, 0.9, 1.5):
        for share in (1, 0.9, 0.7):
            u, u_0 = share * math.sin(first), math.sin(first)
            square = 3 / 2 * (u_0 - u)  # m = g = l = 1
            force = (1 + 3 * u**2) / 4 - square * u
            assert force == pytest.approx(((3 * u - u_0) ** 2 + 1 - u_0**2) / 4)
            assert force >= 0


PENDULUM = """
title: Bob on a string
parameters: [m, l, g]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
constraints: {string: {equation: x^2 + y^2 SIDE l^2, reaction: T}}
gravity: g*j
generalized_coordinates: {angle: {coordinates: [theta], substitute: {x: l*sin(theta), y: SIGN*l*cos(theta)}}}
"""


@pytest.mark.parametrize(("side", "sign", "leaves"), [("<=", "", False), (">=", "-1", True)])
def test_a_string_stays_taut_and_a_dome_is_left(side: str, sign: str, leaves: bool) -> None:
    """T = m g (3 cos θ − 2 cos θ_0) grows on the way down; on a dome cos θ = ⅔ cos θ_0 is reached."""
    text = PENDULUM.replace("SIDE", side).replace("SIGN*", f"{sign}*" if sign else "")
    found = meaning(solve(read_problem(Source("p.yaml", text))))
    assert found is not None
    assert bool(found.released) is leaves
    for place in found.released:
        assert place.place == sp.Rational(2, 3) * sp.cos(place.start)
        assert place.exact
        assert place.heavy == "P"
        assert place.provided == sp.cos(place.start)


def test_a_ball_in_a_pipe_swings() -> None:
    """7 v' = −2 b Ω w − 5 g and b w' = Ω v give v'' = −(2/7) Ω² v."""
    view = of("ball-in-a-pipe").view
    from lagrange.core.symbols import DotProduct, TimeDerivative, VectorSymbol, prime

    slots = view.configuration.slots
    q = {s.name: s for s in slots.coordinates}
    b, g = sp.symbols("b g", positive=True)
    w = DotProduct(VectorSymbol("omega"), VectorSymbol("out"))
    rate, v = prime(q["phi"]), prime(q["z"])
    stated = (
        (prime(q["phi"], 2), sp.S.Zero),
        (7 * prime(q["z"], 2) + 2 * b * rate * w + 5 * g, sp.S.Zero),
        (b * TimeDerivative(w), rate * v),
    )
    found = swinging_rate(stated, view)
    assert found is not None
    assert (found.rate, found.constants) == (v, (rate,))
    assert sp.expand(found.square - sp.Rational(2, 7) * rate**2) == 0
    assert swinging_rate((stated[1], (b * TimeDerivative(w), -rate * v)), view) is None
