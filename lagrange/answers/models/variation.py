"""A variation: one way in which a problem may have been changed, with its words."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field

import sympy as sp

from lagrange.answers.models.mechanics import Mechanics
from lagrange.core.records import record
from lagrange.core.symbols import Slots
from lagrange.document.math_writer import text
from lagrange.document.notation import Notation


@record
class Variation:
    """A changed problem.

    clause     continues "these are the equations"
    place      continues "look at"
    mechanics  the changed system; None if it is the meaning of letters that changes
    rule       what the answer's symbols would have to mean for it to be right
    values     the special case in which the answer, which does not contain these symbols, is right
    """

    clause: str
    place: str
    mechanics: Mechanics | None = None
    rule: Mapping[sp.Basic, sp.Basic] = field(default_factory=dict)
    values: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)


def called(name: str) -> str:
    """The name of a particle, body or force in a sentence."""
    return f"`{name}`"


def written(expression: sp.Expr, slots: Slots) -> str:
    """An expression as it may be typed."""
    return text(expression, Notation(coordinates=slots.coordinates, prescribed=slots.prescribed))
