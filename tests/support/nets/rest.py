"""All equilibria of a system in a box, in numbers: Newton's method from many places on the virtual work with multipliers.

∇V = Aᵀ λ ,   f = 0 ;      stable where  ∇²(V − λ·f)  is positive on the displacements with A δq = 0
"""

from __future__ import annotations

import random
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from tests.support.nets.system import System, turned

Array = Any
STEPS, CLOSE, STILL = 60, 1e-9, 1e-7


@dataclass
class Rest:
    """A place of rest.

    lowest      the lowest eigenvalue of the second variation over its largest size, or None where it is not defined
    squares     ω² of the small oscillations in rising order, where all that moves has a mass
    degenerate  whether Newton's equations are nearly singular there, so that it is known to few digits only
    """

    q: Array
    multipliers: Array
    parameters: dict[str, float]
    lowest: float | None
    squares: list[float] | None
    degenerate: bool

    @property
    def stable(self) -> bool | None:
        if self.lowest is None or abs(self.lowest) < (1e-3 if self.degenerate else 1e-6):
            return None
        return self.lowest > 0


def newton(
    system: Callable[[Array], tuple[Array, Array]], start: Array, steps: int = STEPS, longest: float = 1.0
) -> tuple[Array, Array] | None:
    """A zero near a place, and the Jacobian there; of several, the one of least distance. None: it does not converge.

    system  gives value and Jacobian
    """
    z = np.array(start, dtype=float)
    with np.errstate(all="ignore"):
        for _ in range(steps):
            value, jacobian = system(z)
            if not (np.isfinite(value).all() and np.isfinite(jacobian).all()):
                return None
            step = np.linalg.lstsq(jacobian, -value, rcond=1e-10)[0]
            size = np.abs(step).max(initial=0)
            off = np.abs(value).max(initial=0)
            if (size < CLOSE and off < STILL) or (size < 1e-6 and off < 1e-12):  # the second at a multiple root
                return z, jacobian
            z = z + step * min(1, longest / size if size else 1)
    return None


def start_in(system: System, rng: random.Random) -> Array:
    return np.array([rng.uniform(-np.pi, np.pi) if q in system.angles else rng.uniform(-1, 1) * system.box
                     for q in system.coordinates])  # fmt: skip


def gradients(system: System, q: Sequence[float], parameters: Mapping[str, float]) -> Array:
    """The rows of A: of finite constraints, then kinematic ones."""
    rows = [f.gradient for f in system.finite(q, parameters)]
    rows += [np.array([a.value for a in row]) for row in system.rows(q, parameters)]
    return np.array(rows).reshape(len(rows), len(q))


def _balance(system: System, parameters: Mapping[str, float]) -> Callable[[Array], tuple[Array, Array]]:
    n, m = len(system.coordinates), len(system.constraints)
    k = m + len(system.forms)

    def at(z: Array) -> tuple[Array, Array]:
        q, multipliers = z[:n], z[n:]
        v, finite, rows = system.energy(q, parameters), system.finite(q, parameters), system.rows(q, parameters)
        value, jacobian = np.zeros(n + m), np.zeros((n + m, n + k))
        value[:n], jacobian[:n, :n] = v.gradient, v.hessian
        for c, f in enumerate(finite):
            value[:n] -= multipliers[c] * f.gradient
            value[n + c] = f.value
            jacobian[:n, :n] -= multipliers[c] * f.hessian
            jacobian[:n, n + c] = -f.gradient
            jacobian[n + c, :n] = f.gradient
        for c, row in enumerate(rows, start=m):
            a = np.array([x.value for x in row])
            value[:n] -= multipliers[c] * a
            jacobian[:n, :n] -= multipliers[c] * np.array([x.gradient for x in row])
            jacobian[:n, n + c] = -a
        return value, jacobian

    return at


def imbalance(system: System, q: Sequence[float], parameters: Mapping[str, float]) -> tuple[float, float]:
    """What no reaction balances, and by how much constraints are broken; nan where a force has no value."""
    force = system.energy(q, parameters).gradient
    broken = max((abs(f.value) for f in system.finite(q, parameters)), default=0.0)
    rows = gradients(system, q, parameters)
    if not np.isfinite(force).all() or not np.isfinite(rows).all():
        return float("nan"), broken
    if len(rows):
        force = force - rows.T @ np.linalg.lstsq(rows.T, force, rcond=1e-9)[0]
    return float(np.abs(force).max(initial=0)), broken


def null_space(rows: Array, n: int, least: float = 1e-7) -> Array:
    """An orthonormal basis of the displacements with A δq = 0, in columns."""
    if not len(rows):
        return np.eye(n)
    _, sizes, basis = np.linalg.svd(rows)
    return basis[int((sizes > least * max(1, sizes[0])).sum()) :].T


def is_kink(system: System, q: Sequence[float], parameters: Mapping[str, float]) -> bool:
    """Whether the forces jump at a place, as that of a spring with a length does where it loses its length."""
    step = 1e-6 * np.cos(1 + np.arange(len(q)))
    with np.errstate(all="ignore"):
        a, b = (system.energy(np.asarray(q) + s * step, parameters).gradient for s in (1, -1))
    return not bool(np.abs(a - b).max() < 1e-3 * (1 + np.abs(a).max()))


def is_singular(system: System, q: Sequence[float], parameters: Mapping[str, float]) -> bool:
    """Whether constraints lose their rank at a place, so that multipliers may not exist there."""
    rows = gradients(system, q, parameters)
    return bool(len(rows) and np.linalg.svd(rows)[1][-1] < 1e-5)


def is_pole(system: System, q: Sequence[float], parameters: Mapping[str, float]) -> Array | None:
    """Displacements that move no particle there, in columns, where others do elsewhere; None: there are none."""
    rows = [c.gradient for _, r in system.positions(q, parameters) for c in r]
    still = null_space(np.array(rows), len(q), 1e-6) if rows else np.zeros((len(q), 0))
    nearby = [x + 0.37 * np.cos(n) for n, x in enumerate(q)]
    rows = [c.gradient for _, r in system.positions(nearby, parameters) for c in r]
    elsewhere = null_space(np.array(rows), len(q), 1e-6) if rows else still
    return still if still.shape[1] > elsewhere.shape[1] else None


def rests_at_pole(system: System, q: Array, parameters: Mapping[str, float]) -> bool:
    """Whether there is equilibrium for every value of the coordinates that move nothing, so that it is not an artefact of the chart."""
    still = is_pole(system, q, parameters)
    assert still is not None
    shifted = (q + still @ (s * np.ones(still.shape[1])) for s in (0.7, 1.9, 3.3, 5.1))
    return all(imbalance(system, p, parameters)[0] < 1e-6 for p in shifted)


def described(system: System, q: Array, multipliers: Array, parameters: dict[str, float]) -> Rest:
    """The second variation and the small oscillations at a place of rest."""
    n, m = len(q), len(system.constraints)
    second = system.energy(q, parameters).hessian
    for c, f in enumerate(system.finite(q, parameters)):
        second = second - multipliers[c] * f.hessian
    jacobian = _balance(system, parameters)(np.concatenate([q, multipliers]))[1]
    sizes = np.linalg.svd(jacobian)[1]
    degenerate = bool(sizes[min(jacobian.shape) - 1] < 1e-4 * max(1, sizes[0]))
    lowest: float | None = None
    squares: list[float] | None = None
    if not system.forms:
        free = null_space(gradients(system, q, parameters), n)
        reduced = free.T @ second @ free
        values = np.linalg.eigvalsh(reduced) if free.shape[1] else np.array([1.0])
        lowest = float(values[0] / max(1e-2, np.abs(values).max()))
        mass = free.T @ system.mass_matrix(q, parameters) @ free
        if free.shape[1] and np.linalg.eigvalsh(mass)[0] > 1e-9:
            lower = np.linalg.inv(np.linalg.cholesky(mass))
            squares = sorted(np.linalg.eigvalsh(lower @ reduced @ lower.T).tolist())
    assert m == len(system.constraints)
    return Rest(q, multipliers, parameters, lowest, squares, degenerate)


def rests(
    system: System, parameters: dict[str, float], rng: random.Random, starts: int = 30, most: int = 16
) -> list[Rest]:
    """The places of rest that Newton's method finds from random places, each once; angles in (−π, π]."""
    n = len(system.coordinates)
    balance = _balance(system, parameters)
    found: list[Array] = []
    for _ in range(starts):
        q = start_in(system, rng)
        with np.errstate(all="ignore"):
            rows = gradients(system, q, parameters)
            force = system.energy(q, parameters).gradient
            if not np.isfinite(force).all():
                continue
            multipliers = np.linalg.lstsq(rows.T, force, rcond=None)[0] if len(rows) else np.zeros(0)
        result = newton(balance, np.concatenate([q, multipliers]))
        if result is None:
            continue
        z = result[0]
        for k, name in enumerate(system.coordinates):
            if name in system.angles:
                z[k] = turned(z[k])
        if any(abs(z[k]) > 3 * system.box for k in range(n)) or any(_same(system, z, other) for other in found):
            continue
        found.append(z)
        if len(found) >= most:
            break
    return [described(system, z[:n], z[n:], parameters) for z in found]


def _same(system: System, a: Array, b: Array) -> bool:
    return all(
        abs(turned(a[k] - b[k]) if q in system.angles else a[k] - b[k]) < 1e-4 for k, q in enumerate(system.coordinates)
    )
