"""The textbook form: what classic systems must look like, that the value is kept, and Lagrange's equations by SymPy."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import permutations

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from sympy.physics.mechanics import LagrangesMethod, dynamicsymbols

from lagrange.algebra.fourier.ring import Element, FourierRing
from lagrange.algebra.fourier.textbook_form import Textbook, common_factor, common_factor_of, textbook_form
from lagrange.core.effort import allowed
from lagrange.core.symbols import Slots, prime, t, variation
from tests.support.chance import examples

x, y, r, s, x1, x2, z = sp.symbols("x y r s x1 x2 z", real=True)
theta, phi, psi, theta1, theta2, phi1, phi2 = sp.symbols("theta phi psi theta1 theta2 phi1 phi2", real=True)
alpha = sp.Symbol("alpha", real=True)
m, m1, m2, M, l, l0, l1, l2, g, a, b, k, k1, k2, R, omega, mu = sp.symbols(
    "m m1 m2 M l l0 l1 l2 g a b k k1 k2 R omega mu", positive=True
)
I1, I3 = sp.symbols("I1 I3", positive=True)
N = sp.Symbol("lambda_rod", real=True)
sin, cos, tan, sqrt = sp.sin, sp.cos, sp.tan, sp.sqrt


def dot(q: sp.Symbol) -> sp.Symbol:
    return prime(q)


def ddot(q: sp.Symbol) -> sp.Symbol:
    return prime(q, 2)


def equations(kinetic: sp.Expr, potential: sp.Expr, coordinates: Sequence[sp.Symbol]) -> list[sp.Expr]:
    """d/dt ∂T/∂q' - ∂T/∂q + ∂V/∂q for the given coordinates, not simplified."""
    slots = Slots((r, s, x, y, x1, x2, theta, phi, psi, theta1, theta2, phi1, phi2))
    return [slots.time_derivative(kinetic.diff(dot(q))) - kinetic.diff(q) + potential.diff(q) for q in coordinates]


def kinetic(*particles: tuple[sp.Expr, Sequence[sp.Expr]], moving: Sequence[sp.Symbol]) -> sp.Expr:
    slots = Slots(tuple(moving))
    return sum((mass / 2 * slots.time_derivative(c) ** 2 for mass, position in particles for c in position), sp.S.Zero)


def pendulum(length: sp.Expr, angle: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    return length * sin(angle), -length * cos(angle)


def spherical(radius: sp.Expr) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    return radius * sin(theta) * cos(phi), radius * sin(theta) * sin(phi), radius * cos(theta)


first = pendulum(l1, theta1)
second = [u + v for u, v in zip(first, pendulum(l2, theta2), strict=True)]
relative = [u + v for u, v in zip(pendulum(l1, phi1), pendulum(l2, phi1 + phi2), strict=True)]
on_hoop = (R * sin(theta) * cos(omega * t), R * sin(theta) * sin(omega * t))

SYSTEMS = {
    "double pendulum": (
        equations(
            kinetic((m1, first), (m2, second), moving=(theta1, theta2)),
            m1 * g * first[1] + m2 * g * second[1],
            (theta1, theta2),
        ),
        [
            (m1 + m2) * l1**2 * ddot(theta1)
            + m2 * l1 * l2 * ddot(theta2) * cos(theta1 - theta2)
            + m2 * l1 * l2 * dot(theta2) ** 2 * sin(theta1 - theta2)
            + (m1 + m2) * g * l1 * sin(theta1),
            m2 * l1 * l2 * ddot(theta1) * cos(theta1 - theta2)
            + m2 * l2**2 * ddot(theta2)
            - m2 * l1 * l2 * dot(theta1) ** 2 * sin(theta1 - theta2)
            + m2 * g * l2 * sin(theta2),
        ],
    ),
    "double pendulum, relative angle": (
        equations(kinetic((m1, pendulum(l1, phi1)), (m2, relative), moving=(phi1, phi2)), sp.S.Zero, (phi1, phi2)),
        [
            ((m1 + m2) * l1**2 + 2 * m2 * l1 * l2 * cos(phi2) + m2 * l2**2) * ddot(phi1)
            + m2 * l2 * (l1 * cos(phi2) + l2) * ddot(phi2)
            - 2 * m2 * l1 * l2 * dot(phi1) * dot(phi2) * sin(phi2)
            - m2 * l1 * l2 * dot(phi2) ** 2 * sin(phi2),
            m2 * l2 * (l1 * cos(phi2) + l2) * ddot(phi1)
            + m2 * l2**2 * ddot(phi2)
            + m2 * l1 * l2 * dot(phi1) ** 2 * sin(phi2),
        ],
    ),
    "spherical pendulum of variable length": (
        equations(kinetic((m, spherical(r)), moving=(r, theta, phi)), m * g * r * cos(theta), (r, theta, phi)),
        [
            m * ddot(r) - m * r * dot(theta) ** 2 - m * r * dot(phi) ** 2 * sin(theta) ** 2 + m * g * cos(theta),
            m * r**2 * ddot(theta)
            + 2 * m * r * dot(r) * dot(theta)
            - m * r**2 * dot(phi) ** 2 * sin(theta) * cos(theta)
            - m * g * r * sin(theta),
            m * r**2 * ddot(phi) * sin(theta) ** 2
            + 2 * m * r * dot(r) * dot(phi) * sin(theta) ** 2
            + 2 * m * r**2 * dot(theta) * dot(phi) * sin(theta) * cos(theta),
        ],
    ),
    "bead on a turning hoop": (
        equations(kinetic((m, (*on_hoop, -R * cos(theta))), moving=(theta,)), -m * g * R * cos(theta), (theta,)),
        [
            m * R**2 * ddot(theta) - m * R**2 * omega**2 * sin(theta) * cos(theta) + m * g * R * sin(theta),
        ],
    ),
    "block on a sliding wedge": (
        equations(
            kinetic((M, (x,)), (m, (x + s * cos(alpha), -s * sin(alpha))), moving=(x, s)),
            -m * g * s * sin(alpha),
            (x, s),
        ),
        [
            (M + m) * ddot(x) + m * ddot(s) * cos(alpha),
            m * ddot(s) + m * ddot(x) * cos(alpha) - m * g * sin(alpha),
        ],
    ),
    "Atwood's machine": (
        equations(kinetic((m1, (x,)), (m2, (l - x,)), moving=(x,)), -m1 * g * x - m2 * g * (l - x), (x,)),
        [(m1 + m2) * ddot(x) - (m1 - m2) * g],
    ),
    "elastic pendulum": (
        equations(
            kinetic((m, pendulum(l + x, theta)), moving=(x, theta)),
            -m * g * (l + x) * cos(theta) + k * x**2 / 2,
            (x, theta),
        ),
        [
            m * ddot(x) - m * (l + x) * dot(theta) ** 2 + k * x - m * g * cos(theta),
            m * (l + x) ** 2 * ddot(theta) + 2 * m * (l + x) * dot(x) * dot(theta) + m * g * (l + x) * sin(theta),
        ],
    ),
    "elastic pendulum, length": (
        equations(
            kinetic((m, pendulum(r, theta)), moving=(r, theta)),
            -m * g * r * cos(theta) + k * (r - l0) ** 2 / 2,
            (r,),
        ),
        [m * ddot(r) - m * r * dot(theta) ** 2 + k * (r - l0) - m * g * cos(theta)],
    ),
    "bead on a parabola": (
        equations(kinetic((m, (x, a * x**2)), moving=(x,)), m * g * a * x**2, (x,)),
        [m * (4 * a**2 * x**2 + 1) * ddot(x) + 4 * a**2 * m * x * dot(x) ** 2 + 2 * m * g * a * x],
    ),
    "pendulum on a cart": (
        equations(
            kinetic((M, (x,)), (m, (x + l * sin(theta), -l * cos(theta))), moving=(x, theta)),
            -m * g * l * cos(theta),
            (x, theta),
        ),
        [
            (M + m) * ddot(x) + m * l * ddot(theta) * cos(theta) - m * l * dot(theta) ** 2 * sin(theta),
            m * l**2 * ddot(theta) + m * l * ddot(x) * cos(theta) + m * g * l * sin(theta),
        ],
    ),
    "two masses, two springs": (
        equations(
            kinetic((m1, (x1,)), (m2, (x2,)), moving=(x1, x2)),
            k1 * x1**2 / 2 + k2 * (x2 - x1) ** 2 / 2,
            (x1, x2),
        ),
        [m1 * ddot(x1) + k1 * x1 + k2 * (x1 - x2), m2 * ddot(x2) - k2 * (x1 - x2)],
    ),
    "heavy top": (
        equations(
            I1 / 2 * (dot(theta) ** 2 + dot(phi) ** 2 * sin(theta) ** 2)
            + I3 / 2 * (dot(psi) + dot(phi) * cos(theta)) ** 2,
            M * g * l * cos(theta),
            (theta, psi),
        ),
        [
            I1 * ddot(theta)
            - (I1 - I3) * dot(phi) ** 2 * sin(theta) * cos(theta)
            + I3 * dot(phi) * dot(psi) * sin(theta)
            - M * g * l * sin(theta),
            I3 * ddot(psi) + I3 * ddot(phi) * cos(theta) - I3 * dot(phi) * dot(theta) * sin(theta),
        ],
    ),
    "point on a torus": (
        equations(
            kinetic(
                (m, ((a + b * cos(theta)) * cos(phi), (a + b * cos(theta)) * sin(phi), b * sin(theta))),
                moving=(theta, phi),
            ),
            sp.S.Zero,
            (phi,),
        ),
        [
            m * (a + b * cos(theta)) ** 2 * ddot(phi)
            - 2 * m * b * (a + b * cos(theta)) * dot(theta) * dot(phi) * sin(theta)
        ],
    ),
    "catenary": (
        equations(kinetic((m, (x, a * sp.cosh(x / a))), moving=(x,)), m * g * a * sp.cosh(x / a), (x,)),
        [
            m * ddot(x) * sp.cosh(x / a) ** 2
            + m / a * dot(x) ** 2 * sp.sinh(x / a) * sp.cosh(x / a)
            + m * g * sp.sinh(x / a)
        ],
    ),
}


@pytest.mark.parametrize("name", SYSTEMS)
def test_equations_of_classic_systems(name: str) -> None:
    derived, expected = SYSTEMS[name]
    textbook = Textbook(FourierRing())
    assert [textbook.form(e) for e in derived] == expected


X = ddot(x)

FORMS = [
    (l**2 * dot(theta) ** 2 * sin(theta) ** 2 + l**2 * dot(theta) ** 2 * cos(theta) ** 2, l**2 * dot(theta) ** 2),
    (x * (ddot(y) - g) - y * X, x * ddot(y) - y * X - g * x),
    (m * g * l * (1 - cos(theta)), m * g * l * (1 - cos(theta))),
    (X * (M + m - m * cos(theta) ** 2), X * (M + m * sin(theta) ** 2)),
    (X / (M + m - m * cos(theta) ** 2), X / (M + m * sin(theta) ** 2)),
    (X + sin(alpha) / cos(alpha) * g, X + g * tan(alpha)),
    (X * tan(alpha) * cos(alpha), X * sin(alpha)),
    (g * sin(alpha) - mu * g * cos(alpha), g * sin(alpha) - mu * g * cos(alpha)),
    (ddot(y) + y**2 * ddot(y) / (l**2 - y**2), l**2 * ddot(y) / (l**2 - y**2)),
    (k * (1 - l0 / sqrt(x**2 + y**2)) * x, k * x * (1 - l0 / sqrt(x**2 + y**2))),
    (m * X + k * x / (l**2 - x**2) ** 2, m * X + k * x / (l**2 - x**2) ** 2),
    ((l**4 - 2 * l**2 * x**2 + x**4) * X, (l**2 - x**2) ** 2 * X),
    (X * (1 + sin(theta) ** 2 * cos(phi) ** 2), X * (1 + sin(theta) ** 2 * cos(phi) ** 2)),
    (X * (cos(theta) + sin(phi) * cos(psi)) ** 2, X * (cos(theta) + sin(phi) * cos(psi)) ** 2),
    (X * (cos(theta) + cos(phi) * cos(theta - phi)), X * (cos(theta) + cos(phi) * cos(theta - phi))),
    (variation(x) * (x / (M + m * sin(theta) ** 2) + 2 * y), variation(x) * (x / (M + m * sin(theta) ** 2) + 2 * y)),
    (X * x * (l**2 - y**2) + sqrt(y**2 - l**2), sqrt(y**2 - l**2) - X * x * (y**2 - l**2)),
    (X / sqrt(2) + x / sqrt(6), sqrt(2) * X / 2 + sqrt(6) * x / 6),
    ((R**2 / r**2 + 1) * X, X * (R**2 + r**2) / r**2),
    (X * (x / sin(alpha) + y), X * (x + y * sin(alpha)) / sin(alpha)),
    (X / (l**2 - y**2) + X, X * (1 / (l**2 - y**2) + 1)),
    (
        g * (m1 * x / (x - y) - m1 * x * y / (x - y) + m2),
        m2 * g - m1 * g * x * (y - 1) / (x - y),
    ),
    (k / r**2 - m * g, k / r**2 - m * g),
    (X * cos(2 * theta), X * cos(2 * theta)),
    (X * sin(2 * theta), 2 * X * sin(theta) * cos(theta)),
    (X * cos(theta) ** 3, X * cos(theta) ** 3),
    (X * (1 + 3 * cos(theta) ** 2), X * (1 + 3 * cos(theta) ** 2)),
    (X * sin(theta1) * cos(theta2) * sin(phi), X * sin(theta1) * cos(theta2) * sin(phi)),
    (X * cos(theta1 - theta2 + phi), X * cos(theta1 - theta2 + phi)),
    (X * cos(theta) * cos(theta - phi), X * cos(theta) * cos(theta - phi)),
    (X * (cos(theta) + cos(phi)), X * (cos(theta) + cos(phi))),
    (X * (sin(theta) ** 2 + cos(phi) ** 2), X * (sin(theta) ** 2 + cos(phi) ** 2)),
    (
        X * (sin(theta1) * sin(theta2) + cos(theta1) * cos(theta2) * cos(phi1 - phi2)),
        X * (sin(theta1) * sin(theta2) + cos(theta1) * cos(theta2) * cos(phi1 - phi2)),
    ),
    (
        m * X * variation(x) + m * (ddot(y) - g) * variation(y),
        m * X * variation(x) + m * (ddot(y) - g) * variation(y),
    ),
    (
        (m * r**2 * ddot(theta) - m * g * r * sin(theta)) * variation(theta) + m * ddot(r) * variation(r),
        m * r * (r * ddot(theta) - g * sin(theta)) * variation(theta) + m * ddot(r) * variation(r),
    ),
    (X / sqrt((x1 - x2) ** 2 + (x - y) ** 2), X / sqrt((x1 - x2) ** 2 + (x - y) ** 2)),
    (X * (x**2 / y**2 + 2 * x / y + g), X * (g * y**2 + x * (x + 2 * y)) / y**2),
    (X * (4 * x**2 + 4 * x + 1 + g), X * ((2 * x + 1) ** 2 + g)),
    (x * (2 * k * r - l * s + 2 * k * s), x * (2 * k * (r + s) - l * s)),
    (X * sp.exp(a * (x1 - x2)), X * sp.exp(a * (x1 - x2))),
    (X * sp.exp(a * x1) / sp.exp(b * x2 / 2), X * sp.exp(a * x1 - b * x2 / 2)),
    (sp.S.Zero * X, sp.S.Zero),
    (sp.Rational(3, 2) * m + m / 2, 2 * m),
    (sin(alpha) * cos(alpha - theta) / sin(2 * alpha) * k, k * cos(alpha - theta) / (2 * cos(alpha))),
]


@pytest.mark.parametrize(("expression", "expected"), FORMS, ids=[str(e) for e, _ in FORMS])
def test_forms(expression: sp.Expr, expected: sp.Expr) -> None:
    assert textbook_form(expression) == expected


def test_one_product_of_sines_has_one_coefficient() -> None:
    """(R - l) cos θ, and not R cos θ - l cos θ; what may have either sign stays apart."""
    joined = textbook_form(l * cos(theta) - R * cos(theta))
    assert joined.is_Mul
    assert sp.expand(joined - (l - R) * cos(theta)) == 0
    assert textbook_form((m * g + N) * cos(theta)) == m * g * cos(theta) + N * cos(theta)


def test_roots_of_sums_with_negative_exponents() -> None:
    """Their numerators were divided by 1 + x²/y² without end."""
    for base in (1 + x**2 / y**2, l**4 / r**2 + 1, m / x**4 - 1 / (l**2 * y**2), 1 / x + 1 / y):
        expression = X * (x**2 + y**2) * (r**2 + l**4) / sqrt(base) + (x + y) ** 2 * sqrt(base) / base**2
        values = {s: sp.Rational(n, 7) for n, s in enumerate(sorted(expression.free_symbols, key=str), 3)}
        assert abs((textbook_form(expression) - expression).xreplace(values).evalf(30)) < 1e-20


def test_hidden_zeros_are_found() -> None:
    radical = y**2 / (l**2 - y**2) + 1 - l**2 / (l**2 - y**2)
    partial_fractions = 1 / ((l - x) * (l - y)) - (1 / (l - x) - 1 / (l - y)) / (x - y)
    pythagoras = 1 / cos(theta) ** 2 - tan(theta) ** 2 - 1
    for zero in (radical, partial_fractions, pythagoras):
        assert zero != 0
        assert textbook_form(zero * X) == 0
        assert textbook_form(zero) == 0
        assert textbook_form(zero * X + zero * dot(x) + g) == g
        assert textbook_form(zero * variation(x)) == 0


def test_unknowns_are_kept_apart() -> None:
    expression = (N + m * g) * cos(theta)
    assert textbook_form(expression) == m * g * cos(theta) + N * cos(theta)
    assert textbook_form((N + m) * cos(theta)) == N * cos(theta) + m * cos(theta)
    assert textbook_form((a + b) * N * cos(theta), unknowns=(N,)) == (a + b) * N * cos(theta)
    assert textbook_form(N * sin(theta) + N * x, unknowns=(N,)) == N * (sin(theta) + x)


def test_merge_joins_the_terms_of_equal_parameters() -> None:
    moving = m * l * (ddot(theta) * cos(phi) + dot(theta) ** 2 * sin(phi))
    expression = sp.expand(moving) + m * g * sin(theta)
    assert textbook_form(expression, merge=True) == moving + m * g * sin(theta)
    assert textbook_form(expression) == expression


ANGLES = [theta, phi, theta - phi, 2 * theta, omega * t, psi / 2]
atoms = [f(w) for f in (sin, cos) for w in ANGLES] + [x, y, m, l, dot(theta), X, sp.Integer(-2), sp.Rational(1, 3)]
rational = [1 / (l**2 + y**2), sqrt(l**2 + y**2), 1 / (m + M * sin(theta) ** 2), tan(phi), 1 / x, 1 / sin(2 * theta)]
quick = settings(deadline=None, max_examples=examples(40))


def sums(factors: list[sp.Expr], most: int = 5) -> st.SearchStrategy[sp.Expr]:
    products = st.lists(st.sampled_from(factors), max_size=most).map(lambda fs: sp.Mul(*fs))
    brackets = st.lists(products, max_size=3).map(lambda ps: sp.Add(*ps))
    return st.builds(lambda p, q, s: p * q + s, brackets, brackets, products)


def value(expression: sp.Expr) -> sp.Expr:
    symbols = sorted(expression.free_symbols, key=str)
    point = {s: sp.Rational(sum(map(ord, s.name)) % 37 + 5, 17 + len(s.name)) for s in symbols}
    return sp.N(expression.xreplace(point), 50)


def same(one: sp.Expr, two: sp.Expr) -> bool:
    return abs(value(one - two)) <= sp.Float("1e-40") * (1 + abs(value(one)))


@quick
@given(sums(atoms))
def test_the_value_of_a_trigonometric_polynomial_is_kept(expression: sp.Expr) -> None:
    form = textbook_form(expression)
    assert same(form, expression)
    assert textbook_form(form) == form


@quick
@given(sums(atoms + rational))
def test_the_value_of_a_quotient_is_kept(expression: sp.Expr) -> None:
    form = textbook_form(expression)
    assert same(form, expression)
    assert textbook_form(form) == form


@pytest.mark.parametrize(
    "expression",
    [
        (sin(theta) + cos(theta) / sin(2 * theta)) * (sin(theta) + 1 / sin(2 * theta)) + 1,
        (sin(theta) + cos(theta) / sin(2 * theta)) * (sin(theta) + 1 / sin(2 * theta)),
        (cos(theta) + sin(theta) / sin(2 * theta)) * (cos(theta) + 1 / sin(2 * theta)) + 1,
        (sin(phi) + cos(phi) / sin(2 * phi)) * (sin(phi) + 1 / sin(2 * phi)) + x,
        (2 * x + sin(phi)) * (sin(theta) / sin(2 * theta) + cos(theta) / sin(2 * theta)) + 1 / cos(theta),
        (m + sin(phi)) * (sin(theta) + cos(theta)) / sin(2 * theta) + 1 / cos(theta),
        (sin(theta) + cos(theta) / sin(2 * theta)) * (m + 1 / sin(2 * theta)) + x,
        (sin(theta) + cos(theta) / cos(2 * theta)) * (sin(theta) + 1 / cos(2 * theta)) + 1,
        (sin(theta) + cos(theta) / sin(2 * theta)) ** 2 + 1 / cos(theta),
        (tan(theta) + 1 / sin(2 * theta)) * (sin(theta) + 1 / sin(2 * theta)) + 1 / sin(theta),
        (sin(phi) / sin(2 * theta) + cos(theta)) * (1 / sin(2 * theta) + sin(theta)) + 1,
    ],
)
def test_the_form_of_a_quotient_of_double_angles_is_its_own_form(expression: sp.Expr) -> None:
    form = textbook_form(expression)
    assert same(form, expression)
    assert textbook_form(form) == form


@quick
@given(sums(atoms, 2))  # SymPy multiplies out: six factors with sums of angles have a million terms
def test_equal_expressions_have_one_form(expression: sp.Expr) -> None:
    assert textbook_form(sp.expand(expression, trig=True)) == textbook_form(expression)


@quick
@given(sums(atoms), st.permutations([theta, phi, psi, x, y, m, l]))
def test_the_order_in_which_symbols_turn_up_does_not_matter(expression: sp.Expr, order: list[sp.Symbol]) -> None:
    ring = FourierRing()
    for symbol in order:
        ring.from_sympy(symbol * cos(symbol))
    assert Textbook(ring).form(expression) == textbook_form(expression)


@pytest.mark.parametrize(
    "expression",
    [
        (2 * sin(theta) * cos(psi) + 2 * sin(psi + theta) - sin(2 * phi - theta) * sin(psi)) * sin(theta - phi),
        (sin(phi) - sin(phi - theta) * cos(psi)) * cos(2 * theta) * (sin(psi) + 2 * cos(phi + theta)),
        -sin(psi) - 2 * sin(2 * phi - psi) + cos(phi - theta) * cos(phi - psi + theta),
        2 * sin(psi) + 2 * sin(2 * theta) * cos(phi - psi) + sin(2 * phi - psi),
        -2 * sin(phi) + sin(phi - psi) * cos(psi) - 2 * cos(theta) * cos(2 * theta),
    ],
    ids=str,
)
def test_one_form_for_every_order_of_the_angles(expression: sp.Expr) -> None:
    forms = set()
    for order in permutations((theta, phi, psi)):
        ring = FourierRing()
        for angle in order:
            ring.from_sympy(cos(angle))
        forms.add(Textbook(ring).form(expression))
    assert len(forms) == 1


def lagranges_method(kinetic_energy: sp.Expr, potential: sp.Expr, coordinates: Sequence[sp.Symbol]) -> list[sp.Expr]:
    """SymPy's equations, in slots."""
    functions = {q: dynamicsymbols(q.name) for q in coordinates}
    rates = {dot(q): f.diff(dynamicsymbols._t) for q, f in functions.items()}
    lagrangian = (kinetic_energy - potential).xreplace(rates).xreplace(functions)
    method = LagrangesMethod(lagrangian, list(functions.values()))
    found = list(method.form_lagranges_equations())
    for q, f in functions.items():
        time = dynamicsymbols._t
        found = [e.xreplace({f.diff(time, 2): ddot(q)}).xreplace({f.diff(time): dot(q)}) for e in found]
    return [e.xreplace({f: q for q, f in functions.items()}) for e in found]


def dalembert(
    ring: FourierRing, particles: Sequence[tuple[sp.Expr, Sequence[sp.Expr]]], forces: Sequence[sp.Expr], slots: Slots
) -> list[Element]:
    """Σ (m r'' - F)·∂r/∂q_k, in the ring."""
    rate = ring.time_derivative(slots)
    positions = [[ring.from_sympy(c) for c in position] for _, position in particles]
    excess = [
        [ring.from_sympy(mass) * rate(rate(c)) - ring.from_sympy(f) for c, f in zip(position, force, strict=True)]
        for (mass, _), position, force in zip(particles, positions, forces, strict=True)
    ]
    return [
        ring.total(
            ring.dot(e, [ring.partial(q)(c) for c in position]) for e, position in zip(excess, positions, strict=True)
        )
        for q in slots.coordinates
    ]


BY_SYMPY = {
    "double pendulum": ([(m1, first), (m2, second)], 1, (theta1, theta2)),
    "spherical": ([(m, spherical(r))], 2, (r, theta, phi)),
    "cart": ([(M, (x, sp.S.Zero)), (m, (x + l * sin(theta), -l * cos(theta)))], 1, (x, theta)),
    "sphere": ([(m, (x, y, sqrt(9 * l**2 - x**2 - y**2)))], 2, (x, y)),
    "spiral": ([(m, (a * sp.exp(theta) * cos(theta), a * sp.exp(theta) * sin(theta)))], 1, (theta,)),
}


@pytest.mark.parametrize("name", BY_SYMPY)
def test_dalembert_in_the_ring_against_lagranges_method(name: str) -> None:
    particles, up, coordinates = BY_SYMPY[name]
    slots, ring = Slots(coordinates), FourierRing()
    forces = [[-mass * g if n == up else sp.S.Zero for n in range(len(p))] for mass, p in particles]
    textbook = Textbook(ring)
    forms = [textbook.form(e) for e in dalembert(ring, particles, forces, slots)]
    potential = sum((mass * g * p[up] for mass, p in particles), sp.S.Zero)
    expected = lagranges_method(kinetic(*particles, moving=coordinates), potential, coordinates)
    assert len(forms) == len(expected)
    for form, equation in zip(forms, expected, strict=True):
        assert form != 0
        assert same(form, equation)


def chain(n: int) -> tuple[FourierRing, list[Element]]:
    """The pendulum of n links, by d'Alembert in the ring."""
    q = sp.symbols(f"q1:{n + 1}", real=True)
    masses, lengths = sp.symbols(f"m1:{n + 1}", positive=True), sp.symbols(f"l1:{n + 1}", positive=True)
    links = [(lengths[i] * sin(q[i]), lengths[i] * cos(q[i])) for i in range(n)]
    positions = [[sp.Add(*(link[c] for link in links[: i + 1])) for c in range(2)] for i in range(n)]
    ring = FourierRing()
    particles = list(zip(masses, positions, strict=True))
    return ring, dalembert(ring, particles, [(sp.S.Zero, mass * g) for mass in masses], Slots(q))


@pytest.mark.parametrize(("n", "apart", "merged"), [(2, 48, 42), (4, 240, 196), (8, 1184, 904)])
def test_operations_of_the_chain_are_those_of_hand_written_equations(n: int, apart: int, merged: int) -> None:
    ring, coefficients = chain(n)
    assert sp.count_ops([Textbook(ring).form(e) for e in coefficients]) == apart
    assert sp.count_ops([Textbook(ring, merge=True).form(e) for e in coefficients]) == merged


def test_every_equation_of_the_chain_is_written_by_hand() -> None:
    n = 3
    q = sp.symbols("q1:4", real=True)
    masses, lengths = sp.symbols("m1:4", positive=True), sp.symbols("l1:4", positive=True)
    ring, coefficients = chain(n)
    for i, coefficient in enumerate(coefficients):
        hanging = [sp.Add(*masses[max(i, j) :]) for j in range(n)]
        expected = hanging[i] * g * lengths[i] * sin(q[i]) + sp.Add(
            *(
                hanging[j] * lengths[i] * lengths[j] * motion
                for j in range(n)
                for motion in (ddot(q[j]) * cos(q[i] - q[j]), dot(q[j]) ** 2 * sin(q[i] - q[j]))
            )
        )
        assert Textbook(ring).form(coefficient) == expected


def test_a_long_sum_is_left_in_one_piece() -> None:
    many = sp.symbols("c1:40", positive=True)
    expression = sp.Add(*(c**2 for c in many)) * X
    assert textbook_form(expression) == expression


def test_what_was_read_before_does_not_show() -> None:
    """Reciprocals are kept for no other expression: 1/(a − b) after 1/(b − a)."""
    form = x / (a - b)
    alone = textbook_form(form)
    with allowed(10**6):
        textbook_form(y / (b - a))
        assert textbook_form(form) == alone


def test_work_is_the_form_of_the_sum() -> None:
    textbook = Textbook(FourierRing())
    read = textbook.ring.from_sympy
    coefficients = {
        variation(x): read(m * l * ddot(x) - m * g * sin(theta) + a / (a + b) * x),
        variation(y): textbook.ring.zero,
        variation(theta): read(m * l**2 * ddot(theta) + m * l * ddot(x) * cos(theta - phi) - x / (a + b)),
    }
    total = sum((d * read(v) for v, d in coefficients.items()), textbook.ring.zero)
    assert textbook.work(coefficients) == Textbook(textbook.ring).form(total)


@pytest.mark.parametrize(
    "expression",
    [
        m * l**2 * ddot(theta) + (m + M) * l * ddot(x) * cos(theta - phi) - m * g * l * sin(theta),
        (m + M) * ddot(x) + m * l * dot(theta) ** 2 * sin(theta),
        2 * (m + M) * g + m * ddot(x),  # SymPy multiplies 2 (M + m) out where nothing else stands beside it
        m * ddot(x) / x + m * g,
    ],
)
def test_summands_are_those_of_the_form(expression: sp.Expr) -> None:
    textbook = Textbook(FourierRing())
    terms = textbook.summands(textbook.ring.from_sympy(expression))
    form = textbook.form(expression)
    if terms is None:
        assert "/x" in str(expression)
        return
    assert sp.Add(*(p.to_sympy() for p in terms)) == form
    assert len(terms) == len(sp.Add.make_args(form))
    slow, fast = common_factor(form), common_factor_of(terms)
    assert (slow.number, dict(slow.powers)) == (fast.number, dict(fast.powers))
    assert slow.divide(form) == fast.divide_terms(terms)


def test_a_phase_with_pi_is_not_halved() -> None:
    """sin(2π v t/L) of a drive stays what it is; of half the phase it is still twice the product."""
    v, L = sp.symbols("v L", positive=True)
    drive = sp.sin(2 * sp.pi * v * t / L)
    assert textbook_form(3 * drive) == 3 * drive
    half = sp.pi * v * t / L
    assert textbook_form(drive - 2 * sp.sin(half) * sp.cos(half)) == 0
