"""The right side of a wrong equation for an equilibrium, turned upside down or multiplied: f(q) = 1/a for f(q) = a."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.answers.limits import MAX_SIDE_FACTORS
from lagrange.answers.readings import Reading
from lagrange.core.vectors import Vector
from lagrange.document.math_writer import text
from lagrange.document.names import Notation

INVERTED = "the ratio is the other way round"


def other_sides(wrong: Sequence[Sequence[Reading]]) -> Iterator[tuple[str, list[tuple[Reading, ...]]]]:
    """One equation f(q) = a of one alternative with 1/a, or with a factor more or less, instead of a."""
    if len(wrong) != 1 or len(wrong[0]) != 1 or len(wrong[0][0].components) != 1 or len(wrong[0][0].sides) != 2:
        return
    [reading] = wrong[0]
    lhs, rhs = reading.sides
    if isinstance(lhs, Vector) or isinstance(rhs, Vector) or rhs == 0 or lhs == 0:
        return

    def with_side(side: sp.Expr) -> list[tuple[Reading, ...]]:
        return [(replace(reading, components=(lhs - side,), sides=(lhs, side)),)]

    yield INVERTED, with_side(1 / rhs)
    for f in (f for f in sp.Mul.make_args(rhs) if f.is_Symbol):  # P/W of b P/W
        yield INVERTED, with_side(f**2 / rhs)
    waving = [f for f in sp.Mul.make_args(rhs) if f.has(sp.sin, sp.cos, sp.tan)]
    if waving:  # M/m of M/m tan β
        yield INVERTED, with_side(sp.Mul(*waving) ** 2 / rhs)
    waves = {w for e in (lhs, rhs) for w in e.atoms(sp.sin, sp.cos, sp.tan)}
    angles = sorted({w.args[0] for w in waves}, key=str)
    factors: list[sp.Expr] = [sp.Integer(2)]
    factors += [f(a) for a in angles for f in (sp.sin, sp.cos)]
    factors += sorted(rhs.free_symbols, key=str)
    for factor in factors[:MAX_SIDE_FACTORS]:
        yield f"a factor {text(factor, Notation())} is missing on its right side", with_side(rhs * factor)
        yield f"a factor {text(factor, Notation())} is missing on its left side", with_side(rhs / factor)
