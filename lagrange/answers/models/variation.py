"""A variation: one way in which a problem may have been changed, with its words."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field

import sympy as sp

from lagrange.answers.models.mechanics import Inertia, Mechanics
from lagrange.core.records import record
from lagrange.core.symbols import Slots
from lagrange.document.math_writer import text
from lagrange.document.notation import Notation


@record
class VariedQuasiEquations:
    """Equations in quasi-velocities, with a factor of the terms with products of these.

    parts     the kinetic energies whose terms have the factor
    kinetic   d/dt ∂T*/∂u_s − Σ_k B_ks ∂T*/∂q_k: what these give without such terms, shape (p,)
    partials  B_ks, shape (n, p)
    """

    parts: tuple[Inertia, ...]
    kinetic: tuple[sp.Expr, ...]
    partials: tuple[tuple[sp.Expr, ...], ...]
    factor: sp.Expr


@record
class Variation:
    """A changed problem.

    clause     continues "these are the equations"
    place      continues "look at"
    mechanics  the changed system; None if it is the meaning of letters that changes
    rule       what the answer's symbols would have to mean for it to be right
    values     the special case in which the answer, which does not contain these symbols, is right
    quasi      the equations in quasi-velocities, if these are what changes; `mechanics` is unchanged then
    """

    clause: str
    place: str
    mechanics: Mechanics | None = None
    rule: Mapping[sp.Basic, sp.Basic] = field(default_factory=dict)
    values: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)
    quasi: VariedQuasiEquations | None = None

    @property
    def is_reduced(self) -> bool:
        """Whether it has fewer equations than coordinates: then one of them alone tells little."""
        m = self.mechanics
        return self.quasi is None and m is not None and len(m.kept) < len(m.slots.coordinates)


def called(name: str) -> str:
    """The name of a particle, body or force in a sentence."""
    return f"`{name}`"


def written(expression: sp.Expr, slots: Slots) -> str:
    """An expression as it may be typed."""
    return text(expression, Notation(coordinates=slots.coordinates, prescribed=slots.prescribed))
