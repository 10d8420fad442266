"""Questions about motions with one degree of freedom: what is answered, against the motion integrated numerically up to the event.

Starts towards the place and away from it, from rest and with either velocity; with friction, whose sense changes where the motion turns.
"""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp

from tests.support.nets.evaluate import NotReadError, evaluate, holds
from tests.support.nets.run import Finding, printed, wrong_names

Rng = random.Random
LONGEST = 40.0


@dataclass
class Asked:
    """A motion q'' = acceleration(q, q'), its start, and a question.

    text      the problem file
    numbers   of its parameters
    event     what becomes zero at the state that is asked for
    quantity  what is asked for, of t, q, q'
    """

    text: str
    numbers: dict[str, float]
    acceleration: Callable[[float, float], float]
    start: tuple[str, str]
    event: Callable[[float, float], float]
    quantity: Callable[[float, float, float], float]

    def number(self, text: str) -> float:
        return float(evaluate(text, self.numbers | {"pi": math.pi}))

    def value(self) -> float | None:
        """What is asked for, at the first time that the event occurs after the start.

        None: it does not occur. nan: it only does at the start, or the motion turns there, so that it may or may not.
        """

        def rates(_: float, y: list[float]) -> list[float]:
            return [y[1], self.acceleration(y[0], y[1])]

        def event(_: float, y: list[float]) -> float:
            return self.event(y[0], y[1])

        event.terminal = True  # type: ignore[attr-defined]
        close = {"rtol": 1e-10, "atol": 1e-12, "max_step": 0.02}
        begun = solve_ivp(rates, (0, 1e-6), [*map(self.number, self.start)], **close)
        found = solve_ivp(rates, (1e-6, LONGEST), begun.y[:, -1], events=event, **close)
        if len(found.t_events[0]):
            return self.quantity(float(found.t_events[0][0]), *map(float, found.y_events[0][0]))
        nearest = min(abs(event(0, y)) for y in (*begun.y.T, *found.y.T))
        return math.nan if nearest < 1e-3 else None


def place(
    rng: Rng, q: str, places: dict[str, float], quantities: list[str]
) -> tuple[str, str, Callable[[float, float], float]]:
    """A quantity and the state at which it is asked for: at a place, or at rest."""
    if rng.random() < 0.3:
        return rng.choice([q, "t"]), f"{q}' = 0", lambda _, v: v
    where = rng.choice([*places])
    return rng.choice(quantities), f"{q} = {where}", lambda x, _: x - places[where]


def asked(text: str, quantity: str, when: str, start: tuple[str, str], q: str) -> str:
    return f"""{text}initial: {{{q}: '{start[0]}', {q}': '{start[1]}'}}
ask: {{z: {{quantity: "{quantity}", when: "{when}"}}}}
"""


def pendulum(rng: Rng) -> Asked:
    m, l, g, w = 1.3, 0.7, 9.81, rng.uniform(0.3, 8)
    start = rng.choice(["pi/3", "-pi/3", "pi/2", "0", "-pi/6"]), rng.choice(["0", "w", "-w"])
    quantity, when, event = place(
        rng, "theta", {"0": 0, "pi/6": math.pi / 6, "-pi/4": -math.pi / 4}, ["theta'", "T", "theta''"]
    )
    text = """title: pendulum
parameters: {m: positive, l: positive, g: positive, w: positive}
coordinates: [x, y]
particles: {P: {mass: m, position: "x*i + y*j"}}
constraints: {rod: {equation: "x^2 + y^2 = l^2", reaction: T}}
gravity: g*j
generalized_coordinates: {a: {coordinates: [theta], substitute: {x: l*sin(theta), y: l*cos(theta)}}}
"""

    def value(t: float, x: float, v: float) -> float:
        return {
            "theta": x,
            "theta'": v,
            "t": t,
            "T": m * (g * math.cos(x) + l * v * v),
            "theta''": -g / l * math.sin(x),
        }[quantity]

    numbers = {"m": m, "l": l, "g": g, "w": w}
    return Asked(
        asked(text, quantity, when, start, "theta"), numbers, lambda x, _: -g / l * math.sin(x), start, event, value
    )


def on_axis(rng: Rng) -> Asked:
    """A force that depends on the place: a spring, one that hardens, gravity, an attraction."""
    m, k, a, u = 1.2, 3.0, 1.4, rng.uniform(0.5, 4)
    potential, force = rng.choice([("k*x^2/2", lambda x: -k * x), ("k*x^4/4", lambda x: -k * x**3), ("k*x", lambda _: -k),
                                   ("k*exp(x)", lambda x: -k * math.exp(x))])  # fmt: skip
    start = rng.choice(["0", "a", "-a"]), rng.choice(["0", "u", "-u"])
    quantity, when, event = place(rng, "x", {"0": 0, "a/2": a / 2, "-a": -a, "-a/3": -a / 3}, ["x'", "x'", "t"])
    text = f"""title: a mass on a line
parameters: {{m: positive, k: positive, a: positive, u: positive}}
coordinates: [x]
particles: {{P: {{mass: m, position: x*i}}}}
forces: {{f: {{potential: "{potential}"}}}}
"""
    numbers = {"m": m, "k": k, "a": a, "u": u}
    return Asked(asked(text, quantity, when, start, "x"), numbers, lambda x, _: force(x) / m, start, event,
                 lambda t, x, v: {"x": x, "x'": v, "t": t}[quantity])  # fmt: skip


def rough(rng: Rng) -> Asked:
    """A block on a rough incline or plane, perhaps on a spring; or drag with the square of the speed."""
    m, g, alpha, mu, u, length, k = (
        1.0,
        9.81,
        0.6,
        rng.choice([0.2, 0.4]),
        rng.uniform(1, 4),
        2.0,
        rng.choice([0.0, 0.0, 5.0]),
    )
    sign, drag = rng.choice([1, -1]), rng.random() < 0.3
    start = "0", rng.choice(["u", "-u"])
    quantity, when, event = place(rng, "x", {"0": 0, "L": length, "-L": -length, "L/4": length / 4}, ["x'", "x'", "t"])
    rub = "{on: P, vector: \"-mu*m*abs(x')*x'*i\"}" if drag else "{friction: mu, constraint: floor, on: P}"
    text = f"""title: a block on a rough incline
parameters: {{m: positive, g: positive, alpha: acute, mu: positive, u: positive, L: positive, k: positive}}
coordinates: [x, y]
particles: {{P: {{mass: m, position: x*i + y*j}}}}
constraints: {{floor: {{equation: y >= 0, reaction: N}}}}
gravity: "{"-" if sign < 0 else ""}g*sin(alpha)*i - g*cos(alpha)*j"
forces: {{rub: {rub}{', spring: {potential: "k*x^2/2"}' if k else ""}}}
"""

    def acceleration(x: float, v: float) -> float:
        resisting = mu * v * abs(v) if drag else mu * g * math.cos(alpha) * np.sign(v)
        applied = sign * g * math.sin(alpha) - k * x / m
        if not drag and abs(v) < 1e-9:
            return float(np.sign(applied) * max(0.0, abs(applied) - mu * g * math.cos(alpha)))
        return float(applied - resisting)

    numbers = {"m": m, "g": g, "alpha": alpha, "mu": mu, "u": u, "L": length, "k": k}
    return Asked(asked(text, quantity, when, start, "x"), numbers, acceleration, start, event,
                 lambda t, x, v: {"x": x, "x'": v, "t": t}[quantity])  # fmt: skip


FAMILIES: list[Callable[[Rng], Asked]] = [pendulum, on_axis, on_axis, rough, rough]


def findings(seed: int) -> list[Finding]:
    """One random question. Where nothing is answered, or a condition excludes it, nothing false is said."""
    rng = random.Random(seed)
    question = rng.choice(FAMILIES)(rng)
    shown = printed(question.text)
    if isinstance(shown, Finding):
        true = question.value()
        never = true is None or math.isnan(true)
        return [] if never and "never-holds" in shown.said else [shown]
    names = [f for f in wrong_names(shown) if "integral" not in f.said]
    return [*names, *_compared(question, shown.json.get("asked") or [])]


def _compared(question: Asked, answers: list[dict[str, Any]]) -> Iterator[Finding]:
    scope = question.numbers | {"pi": math.pi}
    for a in answers:
        conditions = a.get("conditions") or []
        if a.get("value") is None or any("provided" in c or holds(c, scope) is False for c in conditions):
            continue
        try:
            said = [float(evaluate(v, scope)) for v in a["value"].split(" or ")]
        except NotReadError:
            continue  # an integral, or a number with its unit
        true = question.value()
        if not any(map(math.isfinite, said)) or (true is not None and math.isnan(true)):
            continue
        if not any(true is not None and abs(v - true) < 1e-4 * (1 + abs(true)) for v in said):
            yield Finding("answer", f"{a['value']} = {said}, conditions {conditions}", f"{true}", question.text)
