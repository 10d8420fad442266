"""Harmonic driving: the time dependence cos ωt of forces and supports as a prescribed motion u(t).

cos(ω t + φ) and sin(ω t + φ) are expressed by u = cos ωt and u' = −ω sin ωt (u = sin ωt and u' = ω cos ωt
where no cosine occurs). With u a prescribed motion, u, u' and u'' are small of first order together with the
displacements, and u = 0 is the system at rest. In the end u'' = −ω² u.

The system without its drive, and with the drive as a prescribed motion.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import fields, is_dataclass, replace
from typing import Any, TypeVar

import sympy as sp

from lagrange.core.diagnostics import NotCoveredError, Span
from lagrange.core.records import record
from lagrange.core.symbols import Slots, prime, t
from lagrange.core.vectors import Vector
from lagrange.problem.model import Problem

T = TypeVar("T")


@record
class Drive:
    """One harmonic motion.

    symbol     u
    frequency  ω
    law        u(t): cos ωt or sin ωt
    """

    symbol: sp.Symbol
    frequency: sp.Expr
    law: sp.Expr

    @property
    def slots(self) -> dict[sp.Symbol, sp.Expr]:
        """u and its first three derivatives as functions of t; with a phase, a position contains u' already."""
        rate, square = sp.diff(self.law, t), self.frequency**2
        laws = (self.law, rate, -square * self.law, -square * rate)
        return {prime(self.symbol, order) if order else self.symbol: law for order, law in enumerate(laws)}


def harmonics(problem: Problem) -> set[sp.Expr]:
    """The frequencies of the sines and cosines of time in a problem; those that are no frequencies of t as `nan`."""
    frequencies: set[sp.Expr] = set()
    for e in _expressions(problem):
        for f in e.atoms(sp.sin, sp.cos):
            if f.args[0].has(t):
                slope = sp.diff(f.args[0], t)
                moving = {t, *problem.slots.coordinates, *problem.slots.velocities}
                frequencies.add(sp.nan if not slope.free_symbols.isdisjoint(moving) else _positive(slope))
    return frequencies


def time_beside_harmonics(problem: Problem) -> bool:
    """Whether time occurs otherwise than in sines and cosines."""
    for e in _expressions(problem):
        hidden = {f: sp.Dummy() for f in e.atoms(sp.sin, sp.cos) if f.args[0].has(t)}
        if e.xreplace(hidden).has(t):
            return True
    return False


def _positive(slope: sp.Expr) -> sp.Expr:
    return -slope if slope.could_extract_minus_sign() else slope


def drive_of(problem: Problem, frequency: sp.Expr, taken: frozenset[str]) -> Drive:
    """The drive with a frequency: cosine, or sine where no cosine of time occurs."""
    name = next(n for n in ("u", "drive", "u_drive", "drive_u") if n not in taken)
    used = {f.func for e in _expressions(problem) for f in _split(e).atoms(sp.sin, sp.cos) if f.args[0].has(t)}
    law = sp.sin(frequency * t) if used == {sp.sin} else sp.cos(frequency * t)
    return Drive(sp.Symbol(name, real=True), frequency, law)


def driven(problem: Problem, drive: Drive) -> Problem:
    """The problem with u substituted for the sines and cosines of time."""
    u, rate = drive.symbol, prime(drive.symbol) / drive.frequency
    is_cosine = drive.law.func is sp.cos
    rule = {
        sp.cos(drive.frequency * t): u if is_cosine else rate,
        sp.sin(drive.frequency * t): -rate if is_cosine else u,
    }
    slots = Slots(problem.slots.coordinates, (*problem.slots.prescribed, u))
    changed = _mapped(problem, lambda e: _split(e).xreplace(rule))
    return replace(changed, slots=slots, scope=replace(problem.scope, slots=slots))


def undriven(problem: Problem, drive: Drive) -> Problem:
    """The problem without the drive."""
    rule = {sp.cos(drive.frequency * t): sp.S.Zero, sp.sin(drive.frequency * t): sp.S.Zero}
    return _mapped(problem, lambda e: _split(e).xreplace(rule))


def without_prescribed(problem: Problem) -> Problem:
    """The problem with its prescribed motions at zero."""
    rule = {prime(u, order) if order else u: sp.S.Zero for u in problem.slots.prescribed for order in range(3)}
    slots = Slots(problem.slots.coordinates)
    changed = _mapped(problem, lambda e: e.xreplace(rule))
    return replace(changed, slots=slots, scope=replace(problem.scope, slots=slots))


def _split(e: sp.Expr) -> sp.Expr:
    """cos(ω t + φ) as cos ωt cos φ − sin ωt sin φ."""
    rule: dict[sp.Basic, sp.Expr] = {}
    for f in e.atoms(sp.sin, sp.cos):
        angle = f.args[0]
        if not angle.has(t):
            continue
        moving, rest = sp.expand(angle).as_independent(t, as_Add=True)[::-1]
        sign = -1 if sp.diff(moving, t).could_extract_minus_sign() else 1
        c, s = sp.cos(sign * moving), sign * sp.sin(sign * moving)
        if f.func is sp.cos:
            rule[f] = c * sp.cos(rest) - s * sp.sin(rest)
        else:
            rule[f] = s * sp.cos(rest) + c * sp.sin(rest)
    return e.xreplace(rule)


_PARTS = ("particles", "bodies", "constraints", "forces", "gravity", "lagrangian", "choices", "speeds")
"""The fields of a problem in which time may occur."""


def _expressions(problem: Problem) -> Iterator[sp.Expr]:
    expressions: list[sp.Expr] = []
    for name in _PARTS:
        _walked(getattr(problem, name), lambda e: expressions.append(e) or e)  # type: ignore[func-returns-value]
    yield from expressions


def _mapped(problem: Problem, change: Callable[[sp.Expr], sp.Expr]) -> Problem:
    return replace(problem, **{name: _walked(getattr(problem, name), change) for name in _PARTS})


def _walked(value: Any, change: Callable[[sp.Expr], sp.Expr]) -> Any:
    """A value of a problem with all expressions in it changed."""
    if isinstance(value, Vector):
        return value.fixed().map(change)
    if isinstance(value, sp.Expr):
        return value if value.is_Symbol else change(value)
    if isinstance(value, tuple):
        return tuple(_walked(v, change) for v in value)
    if isinstance(value, Mapping):
        return {k: _walked(v, change) for k, v in value.items()}
    if is_dataclass(value) and not isinstance(value, type | Span):
        changed = {f.name: _walked(getattr(value, f.name), change) for f in fields(value) if f.init}
        return replace(value, **changed)
    return value


# Forced systems


@record
class ForcedSystems:
    """A driven system.

    still  without the drive
    moved  with the drive as prescribed motions
    small  the slots of these, and what they are as functions of time
    drive  None if they have no law
    """

    still: Problem
    moved: Problem
    small: Mapping[sp.Symbol, sp.Expr]
    drive: Drive | None


def forced_systems(problem: Problem, steady: bool) -> ForcedSystems:
    """The systems of a driven problem; `steady`: the steady state is asked for, which needs one harmonic drive.

    Raises NotCoveredError if there is none, or it is of another kind.
    """
    frequencies = harmonics(problem)
    if sp.nan in frequencies or time_beside_harmonics(problem):
        raise NotCoveredError("forced oscillations under a drive that is not harmonic, F*cos(w*t),")
    if len(frequencies) > 1:
        raise NotCoveredError(
            "forced oscillations under drives of several frequencies: one file for each, as they add up,"
        )
    if problem.slots.prescribed:
        if steady or frequencies:
            names = ", ".join(f"`{u}(t)`" for u in problem.slots.prescribed)
            raise NotCoveredError(f"the response to {names}, which has no law: write a*cos(w*t) instead, otherwise it")
        small = {prime(u, k) if k else u: prime(u, k) if k else u for u in problem.slots.prescribed for k in range(4)}
        return ForcedSystems(without_prescribed(problem), problem, small, None)
    if not frequencies:
        raise NotCoveredError(
            "the response of a system that nothing drives: give a force or a support cos(w*t), otherwise it"
        )
    [frequency] = frequencies
    drive = drive_of(problem, frequency, frozenset(problem.scope.names()))
    return ForcedSystems(undriven(problem, drive), driven(problem, drive), drive.slots, drive)
