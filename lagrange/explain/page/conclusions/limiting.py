"""Limits of the motion in words: each with the name of what is left, or with its solved form."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from lagrange.core.symbols import CONSTANT, prime
from lagrange.document.derivation import Block, Emphasis, Part, Purpose, listed, math, prose, series
from lagrange.explain.words import plural
from lagrange.mechanics.consequences.limiting_cases import LimitingCase, MasslessBodies, Named, NamedMotion


def explain_limit(limit: LimitingCase) -> Block:
    """`g → 0: uniform motion in a circle, with T = m l θ'².` Of several equations, those that change."""
    changed, same = limit.changed, len(limit.equations) - len(limit.changed)
    where = math(limit.parameter, limit.to, relation="=" if limit.to.is_Symbol else "→")
    says: list[tuple[Part, ...]] = (
        [_named(m, e) for m, e in zip(limit.named, changed, strict=True)]
        if len(limit.named) == len(changed) and limit.named[0].named not in (Named.INVERSE_SQUARE, Named.FREE)
        else [(*listed(math(e, sp.S.Zero) for e in changed), *_together(m)) for m in limit.named]
    )
    rest = plural(same, " (the other equation unchanged)", " (the others unchanged)") if same else ""
    forces: tuple[Part, ...] = ()
    if limit.reactions:
        forces = (", with ", *listed(math(s, e) for s, e in limit.reactions.items()))
    words = (*series(says), rest, *forces)
    return prose(Emphasis("Limit"), " ", where, ": ", *words, ".", purpose=Purpose.LIMIT)


def _named(m: NamedMotion, e: sp.Expr) -> tuple[Part, ...]:
    """`x' is constant`, `x'' = −μ g`, `x'' + (k/m) x = 0, an oscillation with the period 2π √(m/k)`."""
    q = m.coordinate
    match m.named:
        case Named.UNIFORM:
            return (math(prime(q)), " is constant")
        case Named.CIRCLE:
            return ("uniform motion in a circle, ", math(prime(q), CONSTANT))
        case Named.ACCELERATED:
            return (math(prime(q, 2), m.value),)
        case Named.OSCILLATION:
            return (math(e, sp.S.Zero), ", an oscillation with the period ", math(period_of(m.value)))
        case _:
            return (math(e, sp.S.Zero), ", the equation of a simple pendulum")


def _together(m: NamedMotion) -> tuple[Part, ...]:
    """Of the inverse square: Kepler's problem where it attracts."""
    called = "Kepler's problem" if m.value.is_positive else m.named.value
    return (", ", called)


def explain_massless(massless: MasslessBodies | None) -> Iterator[Block]:
    """`Without the inertia of the bodies that turn, I = 0: x'' = (m1 − m2) g/(m1 + m2).`"""
    if massless is None:
        return
    values = (": ", *listed(math(*pair) for pair in massless.accelerations.items()), ".")
    if massless.keeps_shape:
        light = listed(math(s, sp.S.Zero, relation="→") for s in massless.vanishing)
        yield prose(Emphasis("Limit"), " ", *light, *values, purpose=Purpose.LIMIT)
        return
    words = (" of the bodies that turn, ", math(*massless.vanishing, sp.S.Zero), *values)
    yield prose(Emphasis("Without the inertia"), *words, purpose=Purpose.LIMIT)


def period_of(square: sp.Expr) -> sp.Expr:
    """2π √(1/ω²)."""
    root = sp.Pow(1 / square, sp.S.Half, evaluate=False)
    return sp.Mul(2 * sp.pi, root, evaluate=False)
