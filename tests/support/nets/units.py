"""Values with units: a motion whose parameters are given in g, cm, kN/m, lb, deg, min, ... against numbers in SI units.

The factors are written down here as in tables (BIPM; NIST SP 811), and nothing of `lagrange` is used. The numerical check that is
printed must have these values, and its accelerations must be those that the system has at that state; the same holds of the file with
bare numbers.
"""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Iterator
from dataclasses import replace

import numpy as np

from tests.support.nets import motion_systems
from tests.support.nets.evaluate import NotReadError, evaluate, python_name
from tests.support.nets.motions import State, accelerated
from tests.support.nets.run import Finding, Printed, printed, wrong_names
from tests.support.nets.statics_systems import letters, whole
from tests.support.nets.system import System

Rng = random.Random
FOOT, POUND = 0.3048, 0.45359237 * 9.80665
MASS = {"kg": 1.0, "g": 1e-3, "mg": 1e-6, "t": 1e3, "slug": POUND / FOOT}
LENGTH = {"m": 1.0, "cm": 1e-2, "mm": 1e-3, "km": 1e3, "ft": FOOT, "in": FOOT / 12}
FORCE = {"N": 1.0, "kN": 1e3, "mN": 1e-3, "lb": POUND, "kg m/s^2": 1.0, "g cm/s^2": 1e-5}
UNITS: dict[str, dict[str, float]] = {
    **dict.fromkeys(("m", "M"), MASS),
    **dict.fromkeys(("l", "R", "a", "b", "c", "L"), LENGTH),
    **dict.fromkeys(("F", "T"), FORCE),
    "g": {"m/s^2": 1.0, "cm/s^2": 1e-2, "ft/s^2": FOOT, "km/h^2": 1e3 / 3600**2, "m/min^2": 1 / 3600, "N/kg": 1.0},
    "k": {"N/m": 1.0, "kN/m": 1e3, "N/cm": 1e2, "N/mm": 1e3, "lb/in": 12 * POUND / FOOT, "kg/min^2": 1 / 3600},
    "J": {"kg m^2": 1.0, "g cm^2": 1e-7, "kg cm^2": 1e-4, "slug ft^2": POUND * FOOT, "t mm^2": 1e-3},
    "w": {"rad/s": 1.0, "1/s": 1.0, "rpm": math.pi / 30, "deg/s": math.pi / 180, "rev/min": math.pi / 30, "Hz": 1.0},
    "alpha": {"rad": 1.0, "deg": math.pi / 180, "°": math.pi / 180, "%": 1e-2},
    "tau": {"s": 1.0, "ms": 1e-3, "min": 60.0, "h": 3600.0},
}


def incline(rng: Rng) -> System:
    s = System("block on an incline", ["x"])
    p = letters(s, rng, 1, m=whole(rng), g=whole(rng), alpha="pi/6", F=whole(rng))
    s.particle("P", p["m"], "x*cos(alpha)", "x*sin(alpha)")
    s.weigh(p["g"])
    s.push("P", p["F"], "0")
    return s


def driven(rng: Rng) -> System:
    s = System("mass on a spring, driven", ["x"])
    p = letters(s, rng, 1, m=whole(rng), k=whole(rng), a=whole(rng), w=whole(rng), tau=whole(rng))
    s.particle("P", p["m"], "x", "0")
    s.field("k*(x - a*sin(w*tau))^2/2")
    return s


FAMILIES: list[Callable[[Rng], System]] = [
    incline, driven, incline, driven, motion_systems.pendulum_cartesian, motion_systems.spherical, motion_systems.rolling,
    motion_systems.atwood, motion_systems.cart, motion_systems.rotating, motion_systems.disc_and_cord,
]  # fmt: skip


def findings(seed: int) -> list[Finding]:
    """One random motion with values in random units, and in SI units."""
    rng = random.Random(seed)
    system = rng.choice(FAMILIES)(rng)
    system = replace(system, find="[motion]", choices={})
    true: dict[str, float] = {}
    given, plain = {}, {}
    for name in system.parameters:
        unit = rng.choice([*UNITS[name]])
        factor = UNITS[name][unit]
        size = rng.uniform(0.2, 1.2) if name == "alpha" else rng.uniform(0.5, 3)
        number = f"{size / factor:.4g}"
        number = number if "e" in number or rng.random() < 0.7 else f"{float(number):e}"
        true[name] = float(number) * factor
        given[name] = rng.choice([f"'{number} {unit}'", f"{number}, unit: '{unit}'"])
        plain[name] = repr(true[name])
    found: list[Finding] = []
    for values in (given, plain) if seed % 4 == 0 else (given,):
        shown = printed(replace(system, values=values).text)
        found += [shown] if isinstance(shown, Finding) else [*wrong_names(shown), *_spot(system, shown, true)]
    return found


def _spot(system: System, shown: Printed, true: dict[str, float]) -> Iterator[Finding]:
    spot = shown.json.get("spot")
    if spot is None:
        return
    values = {name: float(evaluate(v, {})) for name, v in spot["values"].items()}
    for name, value in true.items():
        if name in values and abs(values[name] - value) > 6e-6 * abs(value):
            yield Finding("value", f"{name} = {values[name]:.7g}", f"{value:.7g} in SI units", shown.text)
    coordinates = system.coordinates
    if not {*coordinates} <= {*values}:
        return
    q = np.array([values[x] for x in coordinates])
    v = np.array([values.get(f"{x}'", 0.0) for x in coordinates])
    try:
        state: State | None = accelerated(system, q, v, true, values.get("t", 1.0))
    except NotReadError:
        return
    if state is None:
        return
    for x, text in spot["accelerations"].items():
        true_value = state.scope[python_name(f"{x}''")]
        size = 1 + abs(true_value) + float(np.abs(state.accelerations).max())
        if abs(evaluate(text, {}) - true_value) > 1e-3 * size:
            yield Finding("spot value", f"{x}'' = {text}", f"{true_value:.7g}", shown.text)
