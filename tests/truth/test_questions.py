"""The answers to questions against the motion in numbers.

The equations of motion are typed by hand, in floating point, and integrated by the classical method of Runge and Kutta
until the condition of the question changes its sign; that instant is found by bisection of the last step. Nothing of the
program is used but its answer.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from math import cos, cosh, exp, inf, pi, sin, sqrt

import pytest

from lagrange.mechanics.questions.results import Asked
from tests.support.paths import PROBLEMS
from tests.support.shared import reported

State = list[float]
Law = Callable[[State, float], State]
STEP = 1e-3


def step(law: Law, s: State, t: float, h: float) -> State:
    a = law(s, t)
    b = law([x + h / 2 * k for x, k in zip(s, a, strict=True)], t + h / 2)
    c = law([x + h / 2 * k for x, k in zip(s, b, strict=True)], t + h / 2)
    e = law([x + h * k for x, k in zip(s, c, strict=True)], t + h)
    return [x + h / 6 * (k + 2 * l + 2 * m + n) for x, k, l, m, n in zip(s, a, b, c, e, strict=True)]


def until(law: Law, start: State, event: Callable[[State, float], float], longest: float = 60) -> tuple[State, float]:
    """The state and the time at which the event changes its sign for the first time."""
    s, t, before = start, 0.0, 0.0
    while t < longest:
        after = step(law, s, t, STEP)
        value = event(after, t + STEP)
        if before * value < 0:
            low, high = 0.0, STEP
            for _ in range(50):
                middle = (low + high) / 2
                if event(step(law, s, t, middle), t + middle) * before > 0:
                    low = middle
                else:
                    high = middle
            return step(law, s, t, low), t + low
        s, t, before = after, t + STEP, value
    raise AssertionError("the event does not happen")


@dataclass
class Case:
    """A question with numbers for the parameters, and how the quantity is found from the motion in numbers.

    by  the value of the coordinate or of t as a function of which it is asked for
    """

    problem: str
    question: str
    values: dict[str, float]
    law: Law
    start: State
    event: Callable[[State, float], float]
    quantity: Callable[[State, float], float]
    by: dict[str, float] = field(default_factory=dict)


def circle(g: float, R: float) -> Law:
    """On a circle, the angle from the top."""
    return lambda s, _: [s[1], g / R * sin(s[0])]


def hanging(g: float, R: float) -> Law:
    """On a circle, the angle from the lowest point."""
    return lambda s, _: [s[1], -g / R * sin(s[0])]


def central(K: float) -> Law:
    return lambda s, _: [s[1], -K / s[0] ** 2]


def straight(a: float) -> Law:
    return lambda s, _: [s[1], a]


def stone(g: float) -> Law:
    return lambda s, _: [s[2], s[3], 0.0, -g]


def drag(g: float, ratio: float) -> Law:
    return lambda s, _: [s[1], g - ratio * abs(s[1]) * s[1]]


SMALL = 1e-7  # of a particle that is disturbed at the top
V, A = 9.0, 0.7
THROWN = [0.0, 0.0, V * cos(A), V * sin(A)]
SLOPE = {"mu": 0.3, "alpha": 0.4, "g": 9.8, "v": 5.0, "m": 1.0, "s": 2.0}
SLOWED = -9.8 * (sin(0.4) + 0.3 * cos(0.4))
SHAKEN = {"m": 1.5, "k": 4.0, "F": 0.7, "w": 1.1}
TUNED = {"m": 1.0, "k": 4.0, "F": 0.7, "w": 2.0}

HOOP = {"m": 2.0, "a": 0.3, "R": 1.2, "g": 9.8}
THROWN_UP = {"m": 2.0, "c": 0.1, "g": 9.8, "v": 15.0}
FIELDS = {"m": 2.0, "q": 1.5, "E": 1.7, "B": 1.6}
SPRINGS = {"m": 1.5, "k": 4.0, "c": 0.9, "a": 0.1}
LADDER = {"m": 2.0, "l": 1.5, "g": 9.8, "alpha": 0.4}


def hoop(s: State, _: float) -> State:
    return [s[1], 9.8 / (2 * 1.5) * sin(s[0])]


def drag_upwards(s: State, _: float) -> State:
    return [s[1], -9.8 - 0.05 * abs(s[1]) * s[1]]


def crossed(s: State, _: float) -> State:
    return [s[2], s[3], 1.2 * s[3], 1.5 * 1.7 / 2 - 1.2 * s[2]]


def joined(s: State, _: float) -> State:
    return [s[2], s[3], (-4 * s[0] - 0.9 * (s[0] - s[1])) / 1.5, (-4 * s[1] + 0.9 * (s[0] - s[1])) / 1.5]


def ladder(s: State, _: float) -> State:
    return [s[1], 3 * 9.8 / (4 * 1.5) * sin(s[0])]


def pressed(s: State, _: float) -> float:
    """x'' of the centre: the wall presses as long as it is positive."""
    return ladder(s, 0)[1] * cos(s[0]) - s[1] ** 2 * sin(s[0])


BOWLED = {"m": 5.0, "R": 0.1, "mu": 0.2, "g": 9.8, "v": 7.0}
BOWLED_AT = [0.0, 0.0, 7.0, 0.0]


def bowled(s: State, _: float) -> State:
    """While it slips, friction slows it down and turns it clockwise."""
    return [s[2], s[3], -0.2 * 9.8, -0.2 * 9.8 * 0.1 / (0.4 * 0.1**2)]


def no_slip(s: State, _: float) -> float:
    return s[2] + 0.1 * s[3]


def hill(a: float, g: float) -> Law:
    """On the parabola y = h − x²/(2a): x'' from Newton's law along it."""
    return lambda s, _: [s[1], s[0] * (a * g - s[1] ** 2) / (a**2 + s[0] ** 2)]


def backspin(s: State, _: float) -> State:
    """Friction to the left slows it down, and turns it clockwise, the sense in which its angle is counted."""
    return [s[2], s[3], -0.2 * 9.8, 0.2 * 9.8 * 0.1 / (0.4 * 0.1**2)]


THROWN_BACK = {"m": 5.0, "R": 0.1, "mu": 0.2, "g": 9.8, "v": 3.0, "w": 20.0}
DRAGGED = {"m": 0.5, "c": 0.2, "v": 12.0, "g": 9.8}


def dragged(s: State, _: float) -> State:
    return [s[1], -9.8 - 0.2 / 0.5 * s[1]]


CASES = [
    Case("crest-of-a-hill", "pressure", {"m": 900.0, "a": 40.0, "v": 15.0, "g": 9.8}, hill(40.0, 9.8), [-0.02, 15.0],
         lambda s, _: s[0], lambda s, _: 900.0 * (9.8 - s[1] ** 2 / 40.0)),
    Case("crest-of-a-hill", "fastest", {"m": 900.0, "a": 40.0, "g": 9.8}, hill(40.0, 9.8), [-0.03, sqrt(40 * 9.8)],
         lambda s, _: s[0], lambda s, _: s[1]),
    Case("ball-with-backspin", "rolls", THROWN_BACK, backspin, [0.0, 0.0, 3.0, -20.0],
         lambda s, _: s[2] - 0.1 * s[3], lambda _, t: t),
    Case("ball-with-backspin", "speed", THROWN_BACK, backspin, [0.0, 0.0, 3.0, -20.0],
         lambda s, _: s[2] - 0.1 * s[3], lambda s, _: s[2]),
    Case("stone-in-linear-drag", "height", DRAGGED, dragged, [0.0, 12.0], lambda s, _: s[1], lambda s, _: s[0]),
    Case("stone-in-linear-drag", "time", DRAGGED, dragged, [0.0, 12.0], lambda s, _: s[1], lambda _, t: t),
    Case("leaving-a-sphere", "leaves", {"R": 1.3, "g": 9.8, "m": 2.0}, circle(9.8, 1.3), [SMALL, 0.0],
         lambda s, _: 9.8 * cos(s[0]) - 1.3 * s[1] ** 2, lambda s, _: s[0]),
    Case("leaving-a-sphere", "speed", {"R": 1.3, "g": 9.8, "m": 2.0}, circle(9.8, 1.3), [SMALL, 0.0],
         lambda s, _: 9.8 * cos(s[0]) - 1.3 * s[1] ** 2, lambda s, _: 1.3 * s[1]),
    Case("leaving-a-sphere", "pressure", {"R": 1.3, "g": 9.8, "m": 2.0}, circle(9.8, 1.3), [SMALL, 0.0],
         lambda s, _: s[0] - 0.5, lambda s, _: 2.0 * (9.8 * cos(s[0]) - 1.3 * s[1] ** 2), {"theta": 0.5}),
    Case("loop-the-loop", "speed_at_the_top", {"R": 1.2, "g": 9.8, "m": 2.0, "h": 4.0}, hanging(9.8, 1.2),
         [0.0, sqrt(2 * 9.8 * 4) / 1.2], lambda s, _: s[0] - pi, lambda s, _: 1.2 * s[1]),
    Case("loop-the-loop", "least_height", {"R": 1.2, "g": 9.8, "m": 2.0}, hanging(9.8, 1.2),
         [0.0, sqrt(2 * 9.8 * 3.0) / 1.2], lambda s, _: s[0] - pi,  # 5/2 of 1.2 is 3: the weight alone holds it there
         lambda s, _: 3.0 * 1.2 * s[1] ** 2 / 9.8),
    Case("released-pendulum", "speed", {"l": 0.8, "g": 9.8, "m": 2.0, "alpha": 1.1}, hanging(9.8, 0.8), [1.1, 0.0],
         lambda s, _: s[0], lambda s, _: 0.8 * s[1]),
    Case("released-pendulum", "lowest_tension", {"l": 0.8, "g": 9.8, "m": 2.0, "alpha": 1.1}, hanging(9.8, 0.8), [1.1, 0.0],
         lambda s, _: s[0], lambda s, _: 2.0 * (9.8 * cos(s[0]) + 0.8 * s[1] ** 2)),
    Case("released-pendulum", "tension", {"l": 0.8, "g": 9.8, "m": 2.0, "alpha": 1.1}, hanging(9.8, 0.8), [1.1, 0.0],
         lambda s, _: s[0] - 0.3, lambda s, _: 2.0 * (9.8 * cos(s[0]) + 0.8 * s[1] ** 2), {"theta": 0.3}),
    Case("released-pendulum", "other_side", {"l": 0.8, "g": 9.8, "m": 2.0, "alpha": 1.1}, hanging(9.8, 0.8), [1.1, 0.0],
         lambda s, _: s[1], lambda s, _: s[0]),
    Case("escape-from-a-planet", "highest", {"K": 3.0, "R": 1.0, "m": 1.0, "v": 2.1}, central(3.0), [1.0, 2.1],
         lambda s, _: s[1], lambda s, _: s[0]),
    Case("escape-from-a-planet", "speed", {"K": 3.0, "R": 1.0, "m": 1.0, "v": 2.1}, central(3.0), [1.0, 2.1],
         lambda s, _: s[0] - 1.7, lambda s, _: s[1], {"r": 1.7}),
    Case("coasting-away", "time", {"K": 3.0, "R": 1.0, "m": 1.0}, central(3.0), [1.0, sqrt(6)],
         lambda s, _: s[0] - 4, lambda _, t: t),
    Case("coasting-away", "speed", {"K": 3.0, "R": 1.0, "m": 1.0}, central(3.0), [1.0, sqrt(6)],
         lambda s, _: s[0] - 4, lambda s, _: s[1]),
    Case("sledge-up-a-slope", "distance", SLOPE, straight(SLOWED), [0.0, 5.0], lambda s, _: s[1], lambda s, _: s[0]),
    Case("sledge-up-a-slope", "time", SLOPE, straight(SLOWED), [0.0, 5.0], lambda s, _: s[1], lambda _, t: t),
    Case("sledge-up-a-slope", "roughness", {**SLOPE, "s": 25 / (2 * -SLOWED)}, straight(SLOWED), [0.0, 5.0],
         lambda s, _: s[1], lambda s, _: 0.3 * s[0] / (25 / (2 * -SLOWED))),
    Case("bead-slowed-on-a-ring", "speed", {"m": 1.0, "R": 0.5, "mu": 0.2, "v": 3.0},
         lambda s, _: [s[1], -0.2 * s[1] ** 2], [0.0, 6.0], lambda s, _: s[0] - 2.5, lambda s, _: 0.5 * s[1], {"theta": 2.5}),
    Case("bead-slowed-on-a-ring", "after_a_turn", {"m": 1.0, "R": 0.5, "mu": 0.2, "v": 3.0},
         lambda s, _: [s[1], -0.2 * s[1] ** 2], [0.0, 6.0], lambda s, _: s[0] - 2 * pi, lambda s, _: 0.5 * s[1]),
    Case("bead-slowed-on-a-ring", "turned", {"m": 1.0, "R": 0.5, "mu": 0.2, "v": 3.0},
         lambda s, _: [s[1], -0.2 * s[1] ** 2], [0.0, 6.0], lambda _, t: t - 1.3, lambda s, _: s[0], {"t": 1.3}),
    Case("weight-let-go-on-a-spring", "lowest", {"m": 2.0, "k": 30.0, "g": 9.8}, lambda s, _: [s[1], 9.8 - 15 * s[0]],
         [0.0, 0.0], lambda s, _: s[1], lambda s, _: s[0]),
    Case("weight-let-go-on-a-spring", "time", {"m": 2.0, "k": 30.0, "g": 9.8}, lambda s, _: [s[1], 9.8 - 15 * s[0]],
         [0.0, 0.0], lambda s, _: s[1], lambda _, t: t),
    Case("weight-let-go-on-a-spring", "fastest", {"m": 2.0, "k": 30.0, "g": 9.8}, lambda s, _: [s[1], 9.8 - 15 * s[0]],
         [0.0, 0.0], lambda s, _: 9.8 - 15 * s[0], lambda s, _: s[1]),
    Case("weight-let-go-on-a-spring", "motion", {"m": 2.0, "k": 30.0, "g": 9.8}, lambda s, _: [s[1], 9.8 - 15 * s[0]],
         [0.0, 0.0], lambda _, t: t - 0.9, lambda s, _: s[0], {"t": 0.9}),
    Case("thrown-stone", "height", {"v": V, "alpha": A, "g": 9.8, "m": 1.0}, stone(9.8), THROWN, lambda s, _: s[3], lambda s, _: s[1]),
    Case("thrown-stone", "range", {"v": V, "alpha": A, "g": 9.8, "m": 1.0}, stone(9.8), THROWN, lambda s, _: s[1], lambda s, _: s[0]),
    Case("thrown-stone", "time", {"v": V, "alpha": A, "g": 9.8, "m": 1.0}, stone(9.8), THROWN, lambda s, _: s[1], lambda _, t: t),
    Case("thrown-stone", "path", {"v": V, "alpha": A, "g": 9.8, "m": 1.0}, stone(9.8), THROWN, lambda s, _: s[0] - 3, lambda s, _: s[1],
         {"x": 3.0}),
    Case("fall-through-air", "speed", {"m": 2.0, "c": 0.6, "g": 9.8, "h": 5.0}, drag(9.8, 0.3), [0.0, 0.0],
         lambda s, _: s[0] - 5, lambda s, _: s[1]),
    Case("fall-through-air", "time", {"m": 2.0, "c": 0.6, "g": 9.8, "h": 5.0}, drag(9.8, 0.3), [0.0, 0.0],
         lambda s, _: s[0] - 5, lambda _, t: t),
    Case("fall-through-air", "speed_in_time", {"m": 2.0, "c": 0.6, "g": 9.8, "h": 5.0}, drag(9.8, 0.3), [0.0, 0.0],
         lambda _, t: t - 0.7, lambda s, _: s[1], {"t": 0.7}),
    Case("boat-that-drifts", "half", {"m": 2.0, "b": 3.0, "v": 5.0}, lambda s, _: [s[1], -1.5 * s[1]], [0.0, 5.0],
         lambda s, _: s[1] - 2.5, lambda _, t: t),
    Case("boat-that-drifts", "in_all", {"m": 2.0, "b": 3.0, "v": 5.0}, lambda s, _: [s[1], -1.5 * s[1]], [0.0, 5.0],
         lambda _, t: t - 20, lambda s, _: s[0]),
    Case("boat-that-drifts", "motion", {"m": 2.0, "b": 3.0, "v": 5.0}, lambda s, _: [s[1], -1.5 * s[1]], [0.0, 5.0],
         lambda _, t: t - 0.4, lambda s, _: s[0], {"t": 0.4}),
    Case("shaken-into-resonance", "motion", SHAKEN, lambda s, t: [s[1], (0.7 * cos(1.1 * t) - 4 * s[0]) / 1.5], [0.0, 0.0],
         lambda _, t: t - 3.3, lambda s, _: s[0], {"t": 3.3}),
    Case("shaken-into-resonance", "motion", TUNED, lambda s, t: [s[1], 0.7 * cos(2 * t) - 4 * s[0]], [0.0, 0.0],
         lambda _, t: t - 3.3, lambda s, _: s[0], {"t": 3.3}),
    Case("rolling-without-slip", "speed", {"m": 1.0, "R": 1.0, "alpha": 0.4, "g": 9.8, "s": 3.0, "mu_s": 1.0},
         straight(2 / 3 * 9.8 * sin(0.4)), [0.0, 0.0], lambda s, _: s[0] - 3, lambda s, _: s[1]),
    Case("hoop-off-a-cylinder", "leaves", HOOP, hoop, [SMALL, 0.0], lambda s, _: 9.8 * cos(s[0]) - 1.5 * s[1] ** 2, lambda s, _: s[0]),
    Case("hoop-off-a-cylinder", "speed", HOOP, hoop, [SMALL, 0.0], lambda s, _: 9.8 * cos(s[0]) - 1.5 * s[1] ** 2,
         lambda s, _: 1.5 * s[1]),
    Case("hoop-off-a-cylinder", "pressure", HOOP, hoop, [SMALL, 0.0], lambda s, _: s[0] - 0.6,
         lambda s, _: 2 * (9.8 * cos(s[0]) - 1.5 * s[1] ** 2), {"theta": 0.6}),
    Case("ball-thrown-up", "height", THROWN_UP, drag_upwards, [0.0, 15.0], lambda s, _: s[1], lambda s, _: s[0]),
    Case("ball-thrown-up", "rise", THROWN_UP, drag_upwards, [0.0, 15.0], lambda s, _: s[1], lambda _, t: t),
    Case("ball-thrown-up", "back", THROWN_UP, drag_upwards, [0.0, 15.0], lambda s, _: s[0], lambda s, _: s[1]),
    Case("charge-in-crossed-fields", "along", FIELDS, crossed, [0.0] * 4, lambda _, t: t - 2.3, lambda s, _: s[0], {"t": 2.3}),
    Case("charge-in-crossed-fields", "across", FIELDS, crossed, [0.0] * 4, lambda _, t: t - 2.3, lambda s, _: s[1], {"t": 2.3}),
    Case("charge-in-crossed-fields", "farthest", FIELDS, crossed, [0.0] * 4, lambda s, _: s[3], lambda s, _: s[1]),
    Case("charge-in-crossed-fields", "drift", FIELDS, crossed, [0.0] * 4, lambda _, t: t - pi / 0.6, lambda s, _: s[0]),
    Case("wandering-energy", "first", SPRINGS, joined, [0.1, 0.0, 0.0, 0.0], lambda _, t: t - 3.1, lambda s, _: s[0], {"t": 3.1}),
    Case("wandering-energy", "second", SPRINGS, joined, [0.1, 0.0, 0.0, 0.0], lambda _, t: t - 3.1, lambda s, _: s[1], {"t": 3.1}),
    Case("ladder-leaves-the-wall", "leaves", LADDER, ladder, [0.4, 0.0], pressed, lambda s, _: s[0]),
    Case("ladder-leaves-the-wall", "height", LADDER, ladder, [0.4, 0.0], pressed, lambda s, _: 2 * 1.5 * cos(s[0])),
    Case("over-the-top", "a_turn_later", {"m": 1.0, "l": 1.0, "g": 9.8, "v": 6.5}, hanging(9.8, 1.0), [0.0, 6.5],
         lambda s, _: s[0] - 2 * pi, lambda s, _: s[1]),
    Case("over-the-top", "at_the_side", {"m": 1.0, "l": 1.0, "g": 9.8, "v": 5.0}, hanging(9.8, 1.0), [0.0, 5.0],
         lambda s, _: s[0] - pi / 2, lambda s, _: s[1]),
    Case("bowling-ball", "rolls", BOWLED, bowled, BOWLED_AT, no_slip, lambda _, t: t),
    Case("bowling-ball", "speed", BOWLED, bowled, BOWLED_AT, no_slip, lambda s, _: s[2]),
    Case("bowling-ball", "distance", BOWLED, bowled, BOWLED_AT, no_slip, lambda s, _: s[0]),
]  # fmt: skip


def test_a_pendulum_does_not_get_over_the_top_where_the_condition_fails() -> None:
    solution = reported(PROBLEMS / "motion" / "over-the-top.yaml").solution
    once_round, aside, _ = solution.asked
    slow = {"m": 1.0, "l": 1.0, "g": 9.8, "v": 6.2}  # v² < 4 g l = 39.2
    assert answer(once_round, slow) == []
    assert answer(aside, slow) == [pytest.approx(sqrt(6.2**2 - 2 * 9.8))]
    with pytest.raises(AssertionError, match="does not happen"):
        until(hanging(9.8, 1.0), [0.0, 6.2], lambda s, _: s[0] - 2 * pi, longest=10)


def test_the_rod_that_is_cut_loose_turns_about_the_string() -> None:
    """By hand: m a = T − m g and I α = −T l/2 for the centre, and the end at the string is not accelerated."""
    solution = reported(PROBLEMS / "motion" / "rod-cut-loose.yaml").solution
    tension, turning, falling = (answer(a, {"m": 2.0, "l": 1.2, "b": 0.7, "g": 9.8})[0] for a in solution.asked)
    assert 2.0 * falling == pytest.approx(tension - 2.0 * 9.8)
    assert 2.0 * 1.2**2 / 12 * turning == pytest.approx(-tension * 0.6)
    assert falling - turning * 0.6 == pytest.approx(0)


def test_the_wheels_of_a_car_carry_its_weight_and_the_moment_of_the_drive() -> None:
    solution = reported(PROBLEMS / "motion" / "rear-wheel-drive.yaml").solution
    car = {"m": 1200.0, "J": 1500.0, "b": 1.4, "c": 1.2, "h": 0.5, "F": 3000.0, "g": 9.8, "mu": 0.8}
    greatest, behind, in_front = (answer(a, car)[0] for a in solution.asked)
    assert behind + in_front == pytest.approx(1200 * 9.8)
    assert 1.4 * behind - 1.2 * in_front == pytest.approx(0.5 * 3000)
    [limit] = answer(solution.asked[1], {**car, "F": greatest})
    assert greatest == pytest.approx(0.8 * limit)


def answer(asked: Asked, values: dict[str, float]) -> list[float]:
    """The answers whose conditions hold, in numbers."""
    found = []
    for b in asked.branches:
        for v in b.values:
            numbers = {s: values[s.name] for e in (v, *(c.lhs - c.rhs for c in b.conditions)) for s in e.free_symbols}
            holds = {
                "≥": lambda x: x >= 0,
                ">": lambda x: x > 0,
                "≠": lambda x: abs(x) > 1e-9,
                "=": lambda x: abs(x) < 1e-9,
            }
            if all(holds[c.relation](float((c.lhs - c.rhs).subs(numbers))) for c in b.conditions):
                found.append(float(v.subs(numbers)))
    return found


EITHER_SIDE = (("leaving-a-sphere", "leaves"), ("hoop-off-a-cylinder", "leaves"))
"""Where the answer is the cosine of an angle whose sign is free."""


@pytest.mark.parametrize("case", CASES, ids=lambda c: f"{c.problem}-{c.question}")
def test_the_answer_is_that_of_the_motion_in_numbers(case: Case) -> None:
    solution = reported(PROBLEMS / "motion" / f"{case.problem}.yaml").solution
    [asked] = (a for a in solution.asked if a.question.name == case.question)
    state, time = until(case.law, case.start, case.event)
    expected = case.quantity(state, time)
    found = answer(asked, {**case.values, **case.by})
    nearest = min(found, key=lambda x: abs(x - expected), default=inf)
    assert nearest == pytest.approx(expected, rel=1e-5)
    assert len(found) == (2 if asked.mirrored or (case.problem, case.question) in EITHER_SIDE else 1)


def test_the_escape_speed_and_the_least_roughness_are_those_of_the_book() -> None:
    escape = reported(PROBLEMS / "motion" / "escape-from-a-planet.yaml").solution.asked[0]
    assert answer(escape, {"K": 3.0, "R": 1.5}) == [pytest.approx(2.0)]
    rough = reported(PROBLEMS / "motion" / "rolling-without-slip.yaml").solution.asked[0]
    assert answer(rough, {"alpha": 0.4}) == [pytest.approx(sin(0.4) / cos(0.4) / 3)]


def test_the_method_in_numbers_is_one_of_the_fourth_order() -> None:
    state, _ = until(lambda s, _: [s[1], s[0]], [1.0, 0.0], lambda _, t: t - 1)
    assert state[0] == pytest.approx(cosh(1), rel=1e-11)
    assert until(lambda s, _: [-s[0]], [1.0], lambda s, _: s[0] - 0.5)[1] == pytest.approx(0.6931471805599453)
    assert exp(-0.6931471805599453) == pytest.approx(0.5)
