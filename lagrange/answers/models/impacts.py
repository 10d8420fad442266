"""Wrong velocities just after an impact, impulses and losses of energy: what they are instead."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError, NoPointError, UnsupportedError
from lagrange.answers.models.meanings import other_meanings
from lagrange.answers.models.questions import explained_value
from lagrange.mechanics.momenta.impact import ImpulsiveMotion


def explained_impact(
    name: str, claim: sp.Expr, value: sp.Expr, found: ImpulsiveMotion, vanishes: Callable[[sp.Expr], bool | None]
) -> str:
    """What a stated velocity, impulse or loss of energy is, in a sentence; empty if that is not found.

    value     the right one
    vanishes  whether an expression is zero in the position of the impact
    """
    try:
        return next(_reasons(name, claim, value, found, vanishes), "")
    except (DivisionByZeroError, NoPointError, UnsupportedError, ZeroDivisionError):
        return ""


def _reasons(
    name: str, claim: sp.Expr, value: sp.Expr, found: ImpulsiveMotion, vanishes: Callable[[sp.Expr], bool | None]
) -> Iterator[str]:
    before, after = found.kinetic
    plain = name.strip().removesuffix("'")
    velocities = {q.name: v for q, v in zip(found.slots.coordinates, found.before, strict=True)}
    if name == "energy_lost":
        for energy, when in ((before, "before"), (after, "after")):
            if energy != 0 and vanishes(claim - energy):
                yield f"this is the whole kinetic energy just {when} the impact, and not what is lost"
        if vanishes(claim + value):
            yield "its sign is wrong: what is lost is positive"
    elif plain in velocities:
        if vanishes(claim - velocities[plain]):
            yield "this is the velocity just before the impact"
        if before != 0 and value != 0 and vanishes(claim**2 * after - value**2 * before) and not vanishes(before - after):
            yield "the kinetic energy is taken to be conserved, and in this impact some of it is lost"
    if value != 0 and vanishes(claim + value):
        yield "its sign is wrong"
    if why := explained_value(claim, value, set()):
        yield why
    for meaning in other_meanings(value.free_symbols, claim.free_symbols):
        if vanishes(claim - value.xreplace(dict(meaning.rule))):
            yield f"this is the result {meaning.clause}"
    for p in sorted(value.free_symbols - claim.free_symbols, key=str):
        if vanishes(claim - value.xreplace({p: sp.S.One})):
            yield f"this is the result for {p} = 1"
