"""Circles and oscillations whose plane turns, against the equations with turned coordinates put in."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp

import lagrange
from lagrange.core.symbols import t
from lagrange.explain.report import report
from lagrange.mechanics.circular_motion import turning
from lagrange.render import terminal
from tests.support.shared import solved


def test_foucaults_plane_turns_against_the_earth() -> None:
    found = turning(solved("foucault-pendulum").own)
    assert found is not None
    assert found.small is not None
    assert found.stiffness is not None
    omega, latitude, w = (sp.Symbol(n, real=True) for n in ("O", "L", "W"))
    names = {"Omega": omega, "lambda": latitude, "w": w}

    def plain(e: sp.Expr) -> sp.Expr:
        return e.xreplace({s: names[s.name] for s in e.free_symbols if s.name in names})

    assert sp.simplify(plain(found.rate) + omega * sp.sin(latitude)) == 0
    # x = A cos(k t) cos(nu t), y = A cos(k t) sin(nu t): along a line that turns at the rate nu
    rate = plain(found.rate)
    k = sp.sqrt(plain(found.stiffness))
    x, y = sp.cos(k * t) * sp.cos(rate * t), sp.cos(k * t) * sp.sin(rate * t)
    s = sp.sin(latitude)
    left = (
        x.diff(t, 2) - 2 * omega * s * y.diff(t) + (w**2 - omega**2) * x,
        y.diff(t, 2) + 2 * omega * s * x.diff(t) + (w**2 - omega**2 * s**2) * y,
    )
    values = {latitude: 0.6, w: 3, t: 0.8}
    for e in left:  # of second order in the rotation of the earth
        sizes = [abs(float(e.subs(values | {omega: o}))) for o in (1e-2, 1e-3)]
        assert sizes[1] <= sizes[0] / 50
        assert sizes[0] < 1e-4


def test_a_ball_on_a_turntable_runs_in_circles() -> None:
    found = turning(solved("ball-on-turntable").own)
    assert found is not None
    assert found.stiffness is None
    assert found.rate == sp.Rational(2, 7) * sp.Symbol("Omega", positive=True)


@pytest.mark.parametrize("name", ["coupled-oscillators", "thrown-stone"])
def test_nothing_turns_in_other_systems(name: str) -> None:
    assert turning(solved(name).own) is None


def test_a_circle_in_vectors() -> None:
    """r'' = (2/7) Ω k × r', whose sign is that of the turning."""
    made = report(
        lagrange.loads("""title: Charge in a magnetic field
parameters: [m, q, B]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
forces: {magnetic: {on: P, vector: "q*B*(y'*i - x'*j)"}}
""")
    )
    page = " ".join(terminal.text(made.derivation, made.notation, 200).split())
    assert "on a circle; in vectors, 𝐯̇ = −(B q/m) (𝐤 × 𝐯)." in page or "𝐯̇ = −(q B/m) (𝐤 × 𝐯)." in page, page


def test_an_ion_is_held_by_a_strong_field_only() -> None:
    """The bound of the text against the eigenvalues of the two linear equations in numbers."""
    found = turning(solved("penning-trap").chosen)
    assert found is not None
    assert found.bounded is not None
    more, less = found.bounded
    for field in (1.3, 1.5):
        values = {"m": 1.0, "q": 1.0, "B": field, "w": 1.0, "sigma": 1.0}
        system = np.array([[0, 0, 1, 0], [0, 0, 0, 1], [0.5, 0, 0, field], [0, 0.5, -field, 0]])
        held = bool(np.abs(np.linalg.eigvals(system).real).max() < 1e-9)
        numbers = [float(e.subs({s: values[s.name] for s in e.free_symbols})) for e in (more, less)]
        assert (numbers[0] > numbers[1]) is held
