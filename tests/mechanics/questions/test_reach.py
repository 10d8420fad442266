"""Whether a motion along one coordinate gets to a place, against potentials whose barriers are known."""

from __future__ import annotations

import mpmath
import pytest
import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.core.symbols import Bounded, sign_in_range
from lagrange.mechanics.questions.reach import Path, Reached
from lagrange.mechanics.solution import solve
from tests.mechanics.questions.test_questions import Read

x, theta = sp.symbols("x theta", real=True)
a, b, g, k, l, v, K, R = sp.symbols("a b g k l v K R", positive=True)
alpha = Bounded("alpha", sp.S.Zero, sp.pi / 2, (True, True))


def holds(path: Path, end: sp.Expr, numbers: dict[sp.Symbol, float]) -> bool:
    """Whether the place is reached with these numbers."""
    reach = path.to(end)
    assert reach.verdict is Reached.YES
    relations = {">": lambda e: e > 0, "≥": lambda e: e >= 0, "≠": lambda e: e != 0, "≤": lambda e: e <= 0}
    return all(relations[c.relation](float((c.lhs - c.rhs).subs(numbers))) for c in reach.conditions)


def in_steps(square: sp.Expr, q: sp.Symbol, start: float, end: float, numbers: dict[sp.Symbol, float]) -> bool:
    """The same by looking at q'^2 at many places between."""
    f = sp.lambdify(q, square.subs(numbers), "math")
    return all(f(start + (end - start) * n / 1000) > -1e-12 for n in range(1, 1001))


@pytest.mark.parametrize("speed", [1.0, 3.0, 4.3, 4.5, 6.2, 6.3, 9.0])
@pytest.mark.parametrize("end", [sp.pi / 2, sp.pi, 2 * sp.pi, 9 * sp.pi])
def test_a_pendulum_gets_as_far_as_its_energy_takes_it(speed: float, end: sp.Expr) -> None:
    square = (v**2 - 2 * g * l * (1 - sp.cos(theta))) / l**2
    numbers = {g: 9.8, l: 1.0, v: speed}
    path = Path(theta, square, sp.S.Zero, 1)
    assert holds(path, end, numbers) == in_steps(square, theta, 0, float(end), numbers)


@pytest.mark.parametrize("speed", [0.5, 1.3, 1.5, 3.0])
def test_the_hill_between_two_wells(speed: float) -> None:
    bottom = sp.sqrt(a / b)
    square = v**2 + 2 * (a * x**2 / 2 - b * x**4 / 4) - a**2 / (2 * b)
    numbers = {a: 2.0, b: 1.0, v: speed}
    path = Path(x, square, -bottom, 1)
    assert holds(path, bottom, numbers) == in_steps(square, x, -(2**0.5), 2**0.5, numbers)


def test_a_pendulum_that_is_let_go_below_the_horizontal_never_gets_there() -> None:
    square = 2 * g / l * (sp.cos(theta) - sp.cos(alpha))
    assert sign_in_range(sp.cos(alpha)) == 1
    assert Path(theta, square, alpha, -1, rest=True).to(sp.pi / 2).verdict is Reached.NEVER
    assert Path(theta, square, alpha, -1, rest=True).to(sp.S.Zero).verdict is Reached.YES


def test_what_is_thrown_away_comes_back_where_it_does_not_escape() -> None:
    square = v**2 + 2 * K / x - 2 * K / R
    path = Path(x, square, R, 1)
    for speed, comes_back in ((1.9, True), (2.1, False)):  # the escape speed is 2
        assert holds(path, R / 2, {K: 2.0, R: 1.0, v: speed}) is comes_back


def test_a_boat_gets_only_as_far_as_its_momentum_takes_it() -> None:
    path = Path(x, (v - k * x) ** 2, sp.S.Zero, 1)
    for place, reached in ((0.9, True), (1.1, False)):
        assert holds(path, a, {v: 2.0, k: 2.0, a: place}) is reached


def test_what_is_let_go_stays_on_its_side() -> None:
    square = k * (a**2 - x**2)
    assert Path(x, square, a, -1, rest=True).to(2 * a).verdict is Reached.NEVER
    assert Path(x, square, a, -1, rest=True).to(-a).verdict is Reached.YES


def test_an_unknown_direction_is_left_open() -> None:
    assert Path(x, v**2 - k * x**2, sp.S.Zero, None).to(a).verdict is Reached.OPEN


def test_values_decide_what_letters_leave_open() -> None:
    square = v**2 - k * (10 * x - 12 * x**2 + x**6)  # no closed form for the zeros of its derivative
    assert Path(x, square, sp.S.Zero, 1).to(sp.S.One).verdict is Reached.OPEN
    for speed in (1.2, 1.4, 1.5, 2.0):  # the hill is 2.095 high
        numbers = {k: 1.0, v: speed}
        path = Path(x, square, sp.S.Zero, 1, values={s: sp.Float(n) for s, n in numbers.items()})
        reached = path.to(sp.S.One).verdict is Reached.YES
        assert reached == in_steps(square, x, 0, 1, numbers)


def test_of_two_families_of_turning_points_values_say_which_exists() -> None:
    """A bead on a hoop that turns, sent up from 40°: it turns at 41.7°, and passes the lowest place on its way back."""
    speed, begin = sp.Symbol("Omega", positive=True), 2 * sp.pi / 9
    square = v**2 + speed**2 * (sp.sin(theta) ** 2 - sp.sin(begin) ** 2) + 2 * g * (sp.cos(theta) - sp.cos(begin)) / R
    numbers = {R: 0.5, g: 9.81, speed: 3.0, v: 0.7}
    path = Path(theta, square, begin, 1, values={s: sp.Float(n) for s, n in numbers.items()})
    assert holds(path, sp.S.Zero, numbers)
    assert in_steps(square, theta, float(begin), 0, numbers)
    f = sp.lambdify(theta, square.subs(numbers), "math")
    assert f(0.726) > 0 > f(0.731)  # the turning point ahead


def test_what_goes_on_round_does_not_come_back_the_same_way() -> None:
    numbers = {g: 9.8, l: 1.0, v: 9.0}
    square = (v**2 - 2 * g * l * (1 - sp.cos(theta))) / l**2
    path = Path(theta, square, sp.pi / 4, 1, values={s: sp.Float(n) for s, n in numbers.items()})
    assert path.to(sp.S.Zero).verdict is Reached.NEVER


STARS = """title: Two stars
parameters: {m: positive, M: positive, G: positive, d: positive, b: positive}
coordinates: [x, y]
particles: {A: {mass: m, position: x*i}, B: {mass: M, position: y*i}}
forces: {attraction: {potential: -G*m*M/(y - x)}}
initial: {x: 0, y: d, x': 0, y': 0}
"""


def test_two_stars_fall_together(problem: Read) -> None:
    """They meet in their mass centre after π √(d³/(8 G (m + M))); against the integral, in numbers."""
    text = (
        STARS
        + """ask:
  time: {quantity: t, when: y = x}
  half: {quantity: t, when: y - x = d/2}
  place: {quantity: x, when: y = x}
  speed: {quantity: "x'", when: y - x = d/2}
"""
    )
    m, M, G, d = (sp.Symbol(n, positive=True) for n in ("m", "M", "G", "d"))
    found = {a.question.name: a for a in solve(problem(text), complete=False).asked}
    [time], [half], [place], [speed] = (found[n].branches for n in ("time", "half", "place", "speed"))
    assert is_zero(time.rhs - sp.pi * sp.sqrt(d**3 / (8 * G * (m + M)))) is True
    assert is_zero(place.rhs - M * d / (m + M)) is True
    assert is_zero(speed.rhs - M * sp.sqrt(2 * G / (d * (m + M)))) is True  # towards the other one
    numbers = {m: 2, M: 3, G: 1, d: 5}
    integral = mpmath.quad(lambda u: 1 / mpmath.sqrt(2 * 5 * (1 / u - mpmath.mpf(1) / 5)), [2.5, 5])
    assert float(half.rhs.subs(numbers)) == pytest.approx(float(integral))


def test_a_repulsion_does_not_bring_two_bodies_together(problem: Read) -> None:
    """Neither "never" nor a time: whether they meet is not known where the energy is infinite."""
    text = STARS.replace("-G*m*M", "G*m*M") + "ask: {time: {quantity: t, when: y = x}}\n"
    [asked] = solve(problem(text), complete=False).asked
    assert not asked.answered


def test_a_force_as_the_inverse_distance_and_the_ratio_of_two_velocities(problem: Read) -> None:
    """(m M/(m + M)) u²/2 = C log 2 at half the distance; the velocities are as the other masses, from rest too."""
    text = STARS.replace("-G*m*M/(y - x)", "G*log(y - x)")
    text += 'ask: {speed: {quantity: "x\'", when: y - x = d/2}, ratio: {quantity: "x\'/y\'", when: y - x = d/2}}\n'
    m, M, G = (sp.Symbol(n, positive=True) for n in ("m", "M", "G"))
    [speed], [ratio] = (a.branches for a in solve(problem(text), complete=False).asked)
    assert is_zero(speed.rhs**2 - 2 * M * G * sp.log(2) / (m * (m + M))) is True
    assert is_zero(ratio.rhs + M / m) is True
