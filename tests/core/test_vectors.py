"""Vectors in turning triads, against the same vectors in i, j, k.

The triads of textbooks are orthonormal, and turn as they should.
"""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core import vectors
from lagrange.core.symbols import Slots, prime, t
from lagrange.core.vectors import FIXED, Triad, Vector, cylindrical, polar, spherical
from tests.support.work import units

r, theta, phi, z = sp.symbols("r theta phi z", real=True)
SLOTS = Slots((r, theta, phi, z))
TRIADS = {"polar": polar(r, phi), "cylindrical": cylindrical(r, phi, z), "spherical": spherical(r, theta, phi)}
POINT = {s: sp.Rational(n, 7) for n, s in enumerate((r, theta, phi, z), start=2)}
POINT |= {prime(s, k): sp.Rational(n + 3 * k, 5) for n, s in enumerate((r, theta, phi, z)) for k in (1, 2)}


def same(a: Vector, b: Vector) -> bool:
    return all(
        abs((p - q).xreplace(POINT).evalf(30)) < sp.Float(10) ** -25
        for p, q in zip(a.fixed().components, b.fixed().components, strict=True)
    )


@pytest.fixture(params=TRIADS, ids=str)
def triad(request: pytest.FixtureRequest) -> Triad:
    return TRIADS[request.param]


def test_a_triad_is_orthonormal_and_right_handed(triad: Triad) -> None:
    rows = triad.directions
    assert rows is not None
    assert sp.trigsimp(rows * rows.T) == sp.eye(3)
    assert sp.trigsimp(rows.det()) == 1


def test_second_derivatives_in_a_triad_are_those_of_its_fixed_components(triad: Triad) -> None:
    vector = Vector((r**2, sp.sin(theta) * z, r * z + phi), triad)
    moved = vector.time_derivative(SLOTS).time_derivative(SLOTS)
    assert moved.triad == triad
    assert same(moved, vector.fixed().time_derivative(SLOTS).time_derivative(SLOTS))


def test_partial_derivatives_in_a_triad(triad: Triad) -> None:
    vector = Vector((r * z, theta, r), triad)
    for q in SLOTS.coordinates:
        assert same(vector.partial(q), vector.fixed().partial(q))


def test_products_across_triads(triad: Triad) -> None:
    a, b = Vector((r, z, theta), triad), Vector((phi, r, sp.S.One), FIXED)
    assert abs((a.dot(b) - a.fixed().dot(b)).xreplace(POINT).evalf(30)) < sp.Float(10) ** -25
    assert same(a.cross(b), a.fixed().cross(b))
    assert same(a + b, a.fixed() + b)
    assert same(b.along(triad), b)


def test_spherical_acceleration_as_the_chapter_prints_it() -> None:
    """Ex. 17: a = (r'' − r θ'² − r φ'² sin²θ) e_r + ..."""
    triad = TRIADS["spherical"]
    acceleration = Vector((r, sp.S.Zero, sp.S.Zero), triad).time_derivative(SLOTS).time_derivative(SLOTS)
    rd, td, fd = (prime(q) for q in (r, theta, phi))
    s, c = sp.sin(theta), sp.cos(theta)
    expected = (
        prime(r, 2) - r * td**2 - r * fd**2 * s**2,
        r * prime(theta, 2) + 2 * rd * td - r * fd**2 * s * c,
        r * prime(phi, 2) * s + 2 * rd * fd * s + 2 * r * td * fd * c,
    )
    assert [sp.expand(a - b) for a, b in zip(acceleration.components, expected, strict=True)] == [0, 0, 0]


def test_a_driven_triad_turns_with_time() -> None:
    omega = sp.Symbol("omega", positive=True)
    s, c = sp.sin(omega * t), sp.cos(omega * t)
    turning = Triad(
        ("a", "b", "c"), sp.ImmutableMatrix([[c, s, 0], [-s, c, 0], [0, 0, 1]]), ((t, (sp.S.Zero, sp.S.Zero, omega)),)
    )
    vector = Vector((r, z, sp.S.Zero), turning)
    assert same_at(
        vector.time_derivative(SLOTS), vector.fixed().time_derivative(SLOTS), {t: sp.Rational(1, 3), omega: 2}
    )
    assert same_at(vector.frozen_derivative(SLOTS), vector.fixed().frozen_derivative(SLOTS), {t: sp.S.One, omega: 3})


def same_at(a: Vector, b: Vector, more: dict[sp.Symbol, sp.Expr]) -> bool:
    rule = POINT | more
    return all(
        abs((p - q).xreplace(rule).evalf(30)) < sp.Float(10) ** -25
        for p, q in zip(a.fixed().components, b.fixed().components, strict=True)
    )


def test_replacing_an_angle_leaves_the_turning_triad() -> None:
    vector = Vector((r, sp.S.Zero, sp.S.Zero), TRIADS["polar"]).xreplace({phi: z**2})
    assert vector.triad == FIXED
    assert vector.components == (r * sp.cos(z**2), r * sp.sin(z**2), 0)


def test_a_vector_is_rewritten_with_its_triad(triad: Triad) -> None:
    """Where φ is Ω t, e_φ is no unit vector of φ any more: the vector is then written in i, j, k."""
    vector, rule = Vector((r**2, z, phi), triad), {phi: 2 * z}
    rewritten = vector.rewritten(lambda e: e.xreplace(rule))
    assert all(phi not in c.free_symbols for c in (*rewritten.components, *rewritten.fixed().components))
    assert rewritten == vector.fixed().xreplace(rule)
    assert vector.rewritten(lambda e: e.xreplace({z: r})).triad == triad


# Triads


r_triads, theta_triads, phi_triads, z_triads = sp.symbols("r theta phi z", real=True)


@pytest.mark.parametrize(
    "triad",
    [
        vectors.polar(r_triads, phi_triads),
        vectors.cylindrical(r_triads, phi_triads, z_triads),
        vectors.spherical(r_triads, theta_triads, phi_triads),
    ],
    ids=["polar", "cylindrical", "spherical"],
)
def test_unit_vectors_are_orthonormal_and_right_handed(triad: object) -> None:
    e = sp.Matrix([list(vectors.unit_vector(triad, n).fixed().components) for n in range(3)])  # type: ignore[arg-type]
    assert sp.simplify(e * e.T - sp.eye(3)) == sp.zeros(3)
    assert sp.simplify(e.det()) == 1


def test_the_first_vector_points_from_the_origin() -> None:
    radial = vectors.unit_vector(vectors.spherical(r_triads, theta_triads, phi_triads), 0)
    assert isinstance(radial, Vector)
    assert radial.fixed().components[2] == sp.cos(theta_triads)


def test_names_of_axes() -> None:
    assert vectors.axis_names("top")[0] != vectors.names_before_last("top")[0]


def test_the_sum_of_many_vectors(triad: Triad) -> None:
    """As added one by one; zero vectors do not count, also not for the triad."""
    turning = [Vector((sp.Integer(k), r**k, sp.sin(k * theta)), triad) for k in range(1, 5)]
    fixed = Vector((r, theta, phi))
    for some in (turning, [fixed, *turning], [Vector.zero(), *turning, fixed], turning[:1]):
        one_by_one = Vector.zero()
        for v in some:
            one_by_one = one_by_one + v
        assert Vector.total(some) == one_by_one
    assert Vector.total([Vector.zero(), turning[0]]).triad == triad
    assert Vector.total([], triad) == Vector.zero(triad)


def test_the_sum_of_many_vectors_takes_one_addition() -> None:
    directions = [Vector((a, 2 * a, -a)) for a in sp.symbols("a1:101")]
    assert units(lambda: Vector.total(directions)) < 1000
