"""Coupled linear equations in time, against the exponential of their matrix in numbers.

Motions q'' = A(t) + B(t) q', differentiated.
"""

from __future__ import annotations

import mpmath
import pytest
import sympy as sp

from lagrange.core.symbols import prime, t
from lagrange.mechanics.questions import closed_motions as closed
from lagrange.mechanics.questions.closed_motions import closed_motions
from lagrange.mechanics.questions.linear_motions import coupled_with, of_rates_in_time

x, y, z = sp.symbols("x y z", real=True)
a, c, k, w, W, f, h, O = sp.symbols("a c k w W f h O", positive=True)
NUMBERS = {a: 0.7, c: 0.6, k: 2.1, w: 1.3, W: 0.45, f: 0.8, h: 0.35, O: 0.9}

SYSTEMS = {
    "two oscillators": ((-k * x - c * (x - y), -k * y - c * (y - x)), {x: a}),
    "different stiffnesses": ((-3 * k * x + 2 * k * y, 2 * k * (x - y)), {y: a, prime(x): h}),
    "crossed fields": ((w * prime(y), f - w * prime(x)), {prime(y): h}),
    "Foucault": ((-(w**2) * x + 2 * W * prime(y), -(w**2) * y - 2 * W * prime(x)), {x: a, prime(y): h}),
    "one force on two": ((f - k * (x - y), k * (x - y)), {x: a}),
    "shaken": ((f * sp.cos(O * t) - 2 * x + y, x - 2 * y), {}),
    "crossed fields by components": ((w * sp.cos(c) * prime(y), f - w * sp.cos(c) * prime(x)), {prime(y): h}),
    "saddle": ((w**2 * y, w**2 * x), {x: a}),
}


def in_numbers(accelerations: tuple[sp.Expr, ...], start: dict[sp.Symbol, sp.Expr], time: float) -> list[mpmath.mpf]:
    """x and y by Taylor's method."""
    rates = [sp.lambdify((x, y, prime(x), prime(y), t), e.subs(NUMBERS), "mpmath") for e in accelerations]
    first = [mpmath.mpf(float(sp.sympify(start.get(s, 0)).subs(NUMBERS))) for s in (x, y, prime(x), prime(y))]
    solution = mpmath.odefun(lambda u, s: [s[2], s[3], rates[0](*s, u), rates[1](*s, u)], 0, first)
    return list(solution(time)[:2])


@pytest.mark.parametrize("name", SYSTEMS)
def test_the_solution_is_that_in_numbers(name: str) -> None:
    accelerations, start = SYSTEMS[name]
    known = {prime(x, 2): accelerations[0], prime(y, 2): accelerations[1]}
    initial = {s: start.get(s, sp.S.Zero) for s in (x, y, prime(x), prime(y))}
    [motion] = closed_motions(known, initial, {x, y})
    for q, expected in zip((x, y), in_numbers(accelerations, start, 1.7), strict=True):
        assert float(motion.solutions[q].subs(NUMBERS).subs(t, 1.7)) == pytest.approx(float(expected), rel=1e-9)


def test_frequencies_of_foucault_are_written_without_nested_roots() -> None:
    accelerations, start = SYSTEMS["Foucault"]
    known = {prime(x, 2): accelerations[0], prime(y, 2): accelerations[1]}
    [motion] = closed_motions(known, {s: start.get(s, sp.S.Zero) for s in (x, y, prime(x), prime(y))}, {x, y})
    for wave in motion.solutions[x].atoms(sp.cos, sp.sin):
        assert sp.expand(wave.args[0].diff(t) ** 2 - (w**2 + 2 * W**2)).has(sp.sqrt(w**2 + W**2))
        assert not any(p.base.has(sp.Pow(w**2 + W**2, sp.S.Half)) for p in wave.atoms(sp.Pow) if p.exp == sp.S.Half)


def test_what_is_not_linear_or_not_elementary_is_left() -> None:
    initial = dict.fromkeys((x, y, z, prime(x), prime(y), prime(z)), sp.S.One)
    nonlinear = {prime(x, 2): -x * y, prime(y, 2): -x}
    assert closed_motions(nonlinear, initial, {x}) == []
    cubic = {prime(x, 2): -x + c * y, prime(y, 2): c * x - 2 * y + k * z, prime(z, 2): k * y - 3 * z}
    assert closed_motions(cubic, initial, {x}) == []


def test_a_group_is_what_depends_on_each_other() -> None:
    known = {prime(x, 2): -x + y, prime(y, 2): -prime(x), prime(z, 2): -z}
    assert coupled_with(x, known) == [x, y]
    assert coupled_with(z, known) == [z]


def test_what_the_drawn_points_leave_open_once_is_asked_again(monkeypatch: pytest.MonkeyPatch) -> None:
    """The points of a field in which a nested root does not exist decide nothing; those of the next may."""
    verdicts = iter([None, None, True, None, True, False])
    monkeypatch.setattr(closed, "is_zero", lambda _: next(verdicts))
    assert closed._is_certainly_zero(x) is True
    assert closed._is_certainly_zero(x) is True
    assert closed._is_certainly_zero(x) is False


# Linear in speed


x_linear_in_speed = sp.Symbol("x", real=True)
a_linear_in_speed, b, g, place, speed = sp.symbols("a b g x_0 v_0", positive=True)


@pytest.mark.parametrize(
    "acceleration",
    [
        a_linear_in_speed * t - g,
        a_linear_in_speed / (1 + b * t) - g,
        g - b * prime(x_linear_in_speed) * t**0 / (1 + b * t),
        (a_linear_in_speed - g * prime(x_linear_in_speed)) / (1 - b * t),  # a rocket with drag
    ],
)
def test_the_solution_satisfies_the_equation_and_begins_as_it_should(acceleration: sp.Expr) -> None:
    found = of_rates_in_time(x_linear_in_speed, acceleration, place, speed)
    assert found is not None
    way, rate = found
    numbers = {a_linear_in_speed: sp.Rational(3, 2), b: sp.Rational(1, 3), g: 2, place: 5, speed: 7}
    assert way.xreplace({t: sp.S.Zero}).subs(numbers).evalf() == pytest.approx(5)
    for at in (0.3, 1.7):
        values = {**numbers, t: at}
        assert float(way.diff(t).subs(values)) == pytest.approx(float(rate.subs(values)))
        assert float(rate.diff(t).subs(values)) == pytest.approx(
            float(acceleration.subs(prime(x_linear_in_speed), rate).subs(values))
        )


@pytest.mark.parametrize(
    "acceleration",
    [
        -x_linear_in_speed * t,
        -t * prime(x_linear_in_speed) ** 2,
        -g * prime(x_linear_in_speed),
        a_linear_in_speed * t - g * prime(x_linear_in_speed) / (1 - b * t),
    ],
)
def test_other_equations_are_left(acceleration: sp.Expr) -> None:
    assert of_rates_in_time(x_linear_in_speed, acceleration, place, speed) is None


def test_the_squares_of_components_are_added() -> None:
    """A stone that falls at the latitude c: the solution has the frequency 2W, not 2W sqrt(cos^2 + sin^2)."""
    accelerations = {
        prime(x, 2): 2 * W * (prime(y) * sp.sin(c) - prime(z) * sp.cos(c)),
        prime(y, 2): -2 * W * prime(x) * sp.sin(c),
        prime(z, 2): 2 * W * prime(x) * sp.cos(c) - f,
    }
    still = dict.fromkeys((x, y, z, prime(x), prime(y), prime(z)), sp.S.Zero)
    [motion] = closed_motions(accelerations, still, {x})
    expected = f * sp.cos(c) * (2 * W * t - sp.sin(2 * W * t)) / (4 * W**2)
    assert sp.expand(motion.solutions[x] - expected) == 0
