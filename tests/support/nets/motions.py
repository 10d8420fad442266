"""Motions: what is printed of equations, accelerations, reactions and integrals, at random consistent states.

In numbers, with r(q, t) of every particle, t being one more variable that moves with velocity 1,

    M q″ + Σ m ∂rᵀ (q′ᵀ ∂²r q′) = −∂V + Q_dampers + Aᵀ λ ,     A q″ = b ,

is solved for q″ and λ. Everything that is printed is evaluated at the same state.
"""

from __future__ import annotations

import math
import random
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from tests.support.nets.evaluate import NotReadError, difference, evaluate, python_name
from tests.support.nets.motion_systems import random_system
from tests.support.nets.rest import newton
from tests.support.nets.run import Finding, Printed, printed, wrong_names
from tests.support.nets.statics import rewritten
from tests.support.nets.system import System
from tests.support.nets.taylor import Taylor, variables

Array = Any
STATES = 2
TOLERANCE = 1e-6


@dataclass
class State:
    """A consistent state and its motion.

    rows         the rows of A, of finite constraints and then of kinematic ones, by name
    multipliers  λ of each, in Q + Aᵀ λ
    scope        names of q, q′, q″, t and the parameters with their numbers
    """

    q: Array
    velocities: Array
    accelerations: Array
    rows: dict[str, Array]
    multipliers: dict[str, float]
    parameters: dict[str, float]
    time: float
    scope: dict[str, float]


def findings(seed: int) -> list[Finding]:
    """One random motion, and the same written in another way."""
    rng = random.Random(seed)
    system = random_system(rng)
    states = random_states(system, random.Random(seed))
    found, values = check_system(system, states, states[0] if states else None)
    if seed % 3 == 1 and (system.constraints or system.forms):
        other = rewritten(system, rng)
        again, others = check_system(other, random_states(other, random.Random(seed)), states[0] if states else None)
        found += [replace(f, kind=f"{f.kind} (rewritten)") for f in again]
        sided = {name for c, name in system.named.items() if c not in system.anchors}
        for name in {*values} & {*others}:
            a, b = values[name], others[name]
            if name in sided:  # n is along the gradient of left minus right, which exchanging the sides turns over
                a, b = abs(a), abs(b)
            if abs(a - b) > 1e-6 * (1 + abs(a)):
                said = f"{name} = {values[name]:.6g}, and {others[name]:.6g} as {other.constraints or other.forms}"
                found.append(Finding("named reaction", said, "one force", system.text))
    return found


def _series(system: System, q: Sequence[float], time: float, parameters: dict[str, float]) -> dict[str, Any]:
    """Coordinates and t as variables of second order."""
    return parameters | dict(zip([*system.coordinates, "t"], variables([*q, time], 2), strict=True))


def _second(f: Taylor, moving: Array) -> float:
    return float(moving @ f.hessian @ moving)


def state(system: System, rng: random.Random) -> State | None:
    """A random consistent state; None where none was found, or where the constraints are not independent."""
    n = len(system.coordinates)
    parameters = {p: rng.uniform(0.5, 2.5) for p in system.parameters}
    time = rng.uniform(0.3, 1.5)

    def broken(q: Array) -> tuple[Array, Array]:
        names = _series(system, q, time, parameters)
        fs = [difference(c, names) for c in system.constraints.values()]
        return np.array([f.value for f in fs]), np.array([f.gradient[:n] for f in fs]).reshape(len(fs), n)

    start = np.array([rng.uniform(0.3, 1.7) for _ in range(n)])
    result = newton(broken, start) if system.constraints else (start, None)
    if result is None:
        return None
    return accelerated(system, result[0], np.array([rng.uniform(-1.5, 1.5) for _ in range(n)]), parameters, time)


def accelerated(system: System, q: Array, velocities: Array, parameters: dict[str, float], time: float) -> State | None:
    """The motion at a position, with the nearest velocities that the constraints admit; None where it is not determined."""
    n = len(q)
    names = _series(system, q, time, parameters)
    zero = names["t"] * 0
    fs = [zero + difference(c, names) for c in system.constraints.values()]
    rows = {name: f.gradient for name, f in zip(system.constraints, fs, strict=True)}
    forms = {
        name: [zero + evaluate(form.get(x, "0"), names) for x in [*system.coordinates, "t"]]
        for name, form in system.forms.items()
    }
    rows |= {name: np.array([a.value for a in form]) for name, form in forms.items()}
    a = np.array([*rows.values()]).reshape(len(rows), n + 1)
    if len(rows) and np.linalg.svd(a[:, :n])[1][-1] < 1e-3:
        return None
    v = velocities
    if len(rows):
        v = v - np.linalg.lstsq(a[:, :n], a @ np.append(v, 1), rcond=None)[0]
    moving = np.append(v, 1)
    mass, force = _mass_and_force(system, names, moving, parameters)
    bias = [-_second(f, moving) for f in fs]
    bias += [-sum(float(x.gradient @ moving) * s for x, s in zip(form, moving, strict=True)) for form in forms.values()]
    k = len(rows)
    matrix = np.block([[mass, -a[:, :n].T], [a[:, :n], np.zeros((k, k))]])
    if not np.isfinite(matrix).all() or np.linalg.cond(matrix) > 1e9:
        return None
    solution = np.linalg.solve(matrix, np.concatenate([force, bias]))
    scope = parameters | {"t": time}
    for x, p, s, w in zip(system.coordinates, q, v, solution, strict=False):
        scope |= {x: float(p), python_name(x + "'"): float(s), python_name(x + "''"): float(w)}
    multipliers = dict(zip(rows, map(float, solution[n:]), strict=True))
    return State(q, v, solution[:n], {c: r[:n] for c, r in rows.items()}, multipliers, parameters, time, scope)


def _mass_and_force(
    system: System, names: dict[str, Any], moving: Array, parameters: dict[str, float]
) -> tuple[Array, Array]:
    """M, and the generalized forces with the terms in velocities on their side."""
    n = len(system.coordinates)
    zero = names["t"] * 0
    mass, force = np.zeros((n, n)), np.zeros(n)
    parts = [(m, c) for m, r in system.particles.values() for c in r]
    for m, inertia, r, angle in system.bodies.values():
        parts += [*((m, c) for c in r), (inertia, angle)]
    for m, component in parts:
        weight, c = float(evaluate(m, parameters)), zero + evaluate(component, names)
        g = c.gradient[:n]
        mass += weight * np.outer(g, g)
        force -= weight * _second(c, moving) * g
    for term in system.terms:
        force -= (zero + evaluate(term, names)).gradient[:n]
    for strength, a, b in system.dampers:
        square = zero
        for x, y in zip(a, b, strict=False):
            square = square + (zero + evaluate(x, names) - evaluate(y, names)) ** 2
        distance = square**0.5
        force -= float(evaluate(strength, parameters)) * float(distance.gradient @ moving) * distance.gradient[:n]
    return mass, force


# What is printed


def random_states(system: System, rng: random.Random) -> list[State]:
    """A few consistent states."""
    return [s for s in (state(system, rng) for _ in range(4)) if s is not None][:STATES]


def check_system(
    system: System, states: Sequence[State], reference: State | None
) -> tuple[list[Finding], dict[str, float]]:
    """All that is not true of what is printed, and the values of the named reactions at the state `reference`."""
    shown = printed(system.text)
    if isinstance(shown, Finding):
        return [shown], {}
    found = wrong_names(shown)
    values: dict[str, float] = {}
    try:
        for s in states:
            found += _at(system, shown, s)
        for name, (chart, _) in system.choices.items():
            for s in random_states(chart, random.Random(len(system.text))):
                found += _at(chart, shown.in_choice(name), s)
        if states:
            found += list(_integrals_missing(system, shown))
        if reference is not None:
            values = _named(system, shown, reference)
        if states:
            found += list(_named_forces(system, _named(system, shown, states[0]), states[0]))
    except NotReadError as error:
        found.append(Finding("not read back", str(error), "what is printed can be read", ""))
    return list({f.kind: replace(f, text=system.text) for f in reversed(found)}.values()), values


def _at(system: System, shown: Printed, s: State) -> Iterator[Finding]:
    found, scope = shown.json, dict(s.scope)
    n, k = len(system.coordinates), len(s.rows)
    if found.get("degrees_of_freedom", n - k) != n - k:
        yield Finding("degrees of freedom", str(found["degrees_of_freedom"]), str(n - k))
    for c in found["constraints"]:
        if "pfaffian" not in c:
            continue
        row = np.array([evaluate(c["pfaffian"][x], scope) for x in system.coordinates])
        true = s.rows[c["name"]]
        factor = float(row @ true / (true @ true))
        if np.abs(row - factor * true).max() > 1e-7 * (1 + abs(factor)):
            yield Finding("Pfaffian form", f"{c['pfaffian']} = {row}", f"a multiple of {true}")
        scope[f"lambda_{c['name']}"] = s.multipliers[c["name"]] / factor
        if c["name"] in system.named:
            scope.setdefault(system.named[c["name"]], s.multipliers[c["name"]] / factor)
    for x, text in (found.get("accelerations") or {}).items():
        yield from _close("acceleration", f"{x}'' = {text}", evaluate(text, scope), scope[python_name(x + "''")])
    for key in ("equations", "newton", "equations_with_multipliers"):
        for text in found.get(key) or []:
            if key == "newton" and system.named:
                continue
            value, size = _terms(text, scope)
            if not abs(value) < TOLERANCE * size:
                yield Finding(key, text, f"left − right = {value:.6g}, terms of size {size:.3g}")
                break
    yield from _matrices(found, s, scope)
    yield from _reactions(system, found, s, scope)
    for c in found.get("conserved") or []:
        rate, size = _rate(system, c["expression"], s)
        stated = c.get("rate", "0")
        if stated is not None and not abs(rate - evaluate(stated, scope)) < TOLERANCE * size:
            yield Finding("conserved", f"{c['kind']}: the rate of {c['expression']} is {stated}", f"it is {rate:.6g}")


def _close(kind: str, said: str, a: float, b: float) -> Iterator[Finding]:
    if not abs(a - b) < TOLERANCE * (1 + abs(b)) * 10:
        yield Finding(kind, f"{said} = {a:.8g}", f"{b:.8g}")


def _terms(text: str, scope: dict[str, float]) -> tuple[float, float]:
    """Left minus right, and its size for changed accelerations, with which it is compared."""
    value = difference(text, scope)
    changed = {n: v + 1.3 if n.endswith("__2") or n.startswith("lambda_") else v for n, v in scope.items()}
    return value, 1 + abs(difference(text, changed))


def _matrices(found: dict[str, Any], s: State, scope: dict[str, float]) -> Iterator[Finding]:
    if not found.get("mass_matrix"):
        return
    mass, force = (np.array(_numbers(found[key], scope)) for key in ("mass_matrix", "force_vector"))
    left = mass @ s.accelerations - force
    if rows := found.get("constraint_matrix"):
        a, b = np.array(_numbers(rows, scope)), np.array(_numbers(found["constraint_vector"], scope))
        if np.abs(a @ s.accelerations - b).max() > 1e-6 * (1 + np.abs(b).max()):
            yield Finding(
                "constraint matrix", f"A = {rows}, b = {found['constraint_vector']}", "A q″ = b does not hold"
            )
        left = left - a.T @ np.linalg.lstsq(a.T, left, rcond=None)[0]
    if np.abs(left).max() > 1e-6 * (1 + np.abs(force).max()):
        yield Finding(
            "mass matrix", f"M = {found['mass_matrix']}, f = {found['force_vector']}", f"M q″ − f − Aᵀλ = {left}"
        )


def _numbers(value: Any, scope: dict[str, float]) -> Any:
    return [_numbers(v, scope) for v in value] if isinstance(value, list) else evaluate(value, scope)


def _reactions(system: System, found: dict[str, Any], s: State, scope: dict[str, float]) -> Iterator[Finding]:
    """Multipliers; and the forces on particles and moments on bodies, as generalized forces: Σ F·∂r = λ A."""
    names = _series(system, s.q, s.time, s.parameters)
    n, zero = len(system.coordinates), names["t"] * 0
    places = {name: r for name, (_, r) in system.particles.items()} | {name: b[2] for name, b in system.bodies.items()}
    axes = dict(zip("ijk", np.eye(3), strict=True))
    for name, stated in (found.get("reactions") or {}).items():
        if name not in s.rows or "choice" in stated:
            continue
        if stated.get("multiplier") is not None:
            value = evaluate(stated["multiplier"], scope)
            yield from _close("multiplier", f"λ of {name}: {stated['multiplier']}", value, scope[f"lambda_{name}"])
        if "on" not in stated:
            continue
        total = np.zeros(n)
        for on, text in stated["on"].items():
            force = evaluate(text, axes | scope) + np.zeros(3)
            for f, component in zip(force, places[on], strict=False):
                total += f * (zero + evaluate(component, names)).gradient[:n]
        for on, text in stated.get("moment_on", {}).items():
            moment = evaluate(text, axes | scope) + np.zeros(3)
            total += moment[2] * (zero + evaluate(system.bodies[on][3], names)).gradient[:n]
        true = s.multipliers[name] * s.rows[name]
        if np.abs(total - true).max() > 1e-6 * (1 + np.abs(true).max()):
            yield Finding(
                "reaction", f"{name}: {stated['on']} {stated.get('moment_on', '')} works as {total}", f"{true}"
            )


def _rate(system: System, expression: str, s: State) -> tuple[float, float]:
    """The time derivative of a function of q, q′, t along the motion, and its size."""
    n = len(system.coordinates)
    series = variables([*s.q, *s.velocities, s.time], 1)
    names: dict[str, Any] = dict(s.parameters) | {"t": series[-1]}
    for k, x in enumerate(system.coordinates):
        names |= {x: series[k], python_name(x + "'"): series[n + k]}
    gradient = (series[0] * 0 + evaluate(expression, names)).gradient
    along = np.concatenate([s.velocities, s.accelerations, [1]])
    return float(gradient @ along), 1 + float(np.abs(gradient * along).sum())


def _integrals_missing(system: System, shown: Printed) -> Iterator[Finding]:
    """Energy, where nothing depends on time and nothing rubs."""
    stated = shown.json.get("conserved")
    timed = any(name == "t" for text in system.text.splitlines() for name in _words(text))
    if stated is None or timed or system.dampers:
        return
    if not any(c["kind"] == "energy" for c in stated) and "energy" not in shown.page().lower():
        yield Finding("no energy", f"conserved: {[c['expression'] for c in stated]}", "the energy is constant")


def _words(text: str) -> list[str]:
    return "".join(c if c.isalnum() or c == "_" else " " for c in text).split()


def _named(system: System, shown: Printed, s: State) -> dict[str, float]:
    """The named reactions in the boxes that JSON has as forces."""
    values = {}
    reactions = shown.json.get("reactions") or {}
    for constraint, name in system.named.items():
        stated = reactions.get(constraint, reactions.get(name, {}))
        text = None if "choice" in stated else stated.get("force", stated.get("tension"))
        if isinstance(text, str):
            value = evaluate(text, s.scope)
            if math.isfinite(value):
                values[name] = value
    return values


def _named_forces(system: System, values: dict[str, float], s: State) -> Iterator[Finding]:
    """A named reaction is λ ∂f/∂r on its particle: its part towards the other end, if it keeps a distance, otherwise
    along ∇f/|∇f| with f the left side minus the right side."""
    names = _series(system, s.q, s.time, s.parameters)
    zero = names["t"] * 0
    for constraint, name in system.named.items():
        if name not in values:
            continue
        total = s.multipliers[constraint] * s.rows[constraint]
        on, anchor = system.anchors.get(constraint, (next(iter(system.particles)), ()))
        places = [zero + evaluate(c, names) for c in system.particles[on][1]]
        rows = np.array([c.gradient[: len(s.q)] for c in places])
        pinned = np.linalg.pinv(rows.T)
        force, normal = pinned @ total, pinned @ s.rows[constraint]
        if anchor:
            towards = np.array(
                [float((zero + evaluate(a, names)).value - c.value) for a, c in zip(anchor, places, strict=True)]
            )
            true = float(force @ towards / np.linalg.norm(towards))
            what = "the part of the force towards the other end"
        else:
            true, what = float(force @ normal / np.linalg.norm(normal)), "the part of the force along the gradient"
        if abs(values[name] - true) > 1e-6 * (1 + abs(true)):
            yield Finding("named reaction", f"{name} = {values[name]:.8g}", f"{what} is {true:.8g}")
