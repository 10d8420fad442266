"""What a symbol is, and where it stands among those of its kind.

Most of it can be read off a name: x' is a velocity, d(x) a differential, lambda_rod a multiplier. The rest
is declared by a problem and told by its `Notation`: the coordinates in their order, prescribed motions,
quasi-velocities, unknown forces, and the scalars that take the names of the unit vectors.
"""

from __future__ import annotations

from enum import IntEnum
from functools import cached_property

import sympy as sp

from lagrange.core.records import record
from lagrange.core.symbols import FormSymbol, Sign, UnitVector, VectorSymbol, counting
from lagrange.document.names import GREEK, Name

Place = tuple[int, str, tuple[str, ...]]  # declared order, then alphabetic
CONVENTIONAL = frozenset({"x", "y", "z", "q", "r", "s", "theta", "phi", "psi", "rho", "varphi"})


class Kind(IntEnum):
    """What a symbol is."""

    SIGN = 0
    PARAMETER = 1
    TIME = 2
    COORDINATE = 3
    VELOCITY = 4
    ACCELERATION = 5
    FORCE = 6
    DIFFERENTIAL = 7
    VECTOR = 8


MOVING = (Kind.ACCELERATION, Kind.VELOCITY, Kind.COORDINATE)


@record
class Notation:
    """What writing has to know of a problem's symbols. Everything may be left out.

    coordinates     in declared order, those of the choices after those of the file
    prescribed      prescribed motions u(t)
    speeds          quasi-velocities
    frequencies     the unknowns ω or p of small oscillations: first among the terms, but ω t
    parameters      needed only for those that would be taken for something else
    forces          multipliers and unknown forces; names that begin with lambda_ are known to be some
    scalar_names    declared scalars; with i, j or k among them the unit vectors are e_x, e_y, e_z
    ambiguous       undefined functions that occur with several lists of arguments
    """

    coordinates: tuple[sp.Symbol, ...] = ()
    prescribed: tuple[sp.Symbol, ...] = ()
    speeds: tuple[sp.Symbol, ...] = ()
    frequencies: tuple[sp.Symbol, ...] = ()
    parameters: tuple[sp.Symbol, ...] = ()
    forces: tuple[sp.Symbol, ...] = ()
    scalar_names: frozenset[str] = frozenset()
    ambiguous: frozenset[str] = frozenset()

    @property
    def shadows_unit_vectors(self) -> bool:
        """Whether i, j, k have to be written e_x, e_y, e_z."""
        return bool(self.scalar_names & {"i", "j", "k"})

    def kind(self, symbol: sp.Symbol) -> Kind:
        """What a symbol is; an undeclared one is judged by its name."""
        if isinstance(symbol, FormSymbol):
            return Kind.DIFFERENTIAL
        if isinstance(symbol, UnitVector | VectorSymbol):
            return Kind.VECTOR
        name = symbol.name
        if name in self._declared:
            return self._declared[name]
        if isinstance(symbol, Sign):
            return Kind.SIGN
        if name.endswith(")"):
            return Kind.DIFFERENTIAL
        if name.endswith("'"):
            stem = name.rstrip("'")
            order = len(name) - len(stem) + (self._declared.get(stem) == Kind.VELOCITY)
            return Kind.VELOCITY if order == 1 else Kind.ACCELERATION
        if name.startswith("lambda_"):
            return Kind.FORCE
        if not self.coordinates and Name.of(name).letter in CONVENTIONAL:
            return Kind.COORDINATE
        return Kind.PARAMETER

    def place(self, name: str) -> Place:
        """Where a coordinate, or what is made of it, stands among the others; t comes last."""
        inner = name.partition("(")[2].removesuffix(")") or name
        stem = inner.rstrip("'")
        if stem not in self._ranks and stem.startswith("pi_"):  # δπ_u of a quasi-velocity u
            stem = stem.removeprefix("pi_")
        if stem in self._ranks:
            return self._ranks[stem], "", ()
        if stem == "t":
            return len(self._ranks) + 1, "", ()
        return len(self._ranks), *alphabetic(stem)

    @cached_property
    def _ranks(self) -> dict[str, int]:
        moving = (*self.coordinates, *self.prescribed, *self.speeds, *self.frequencies, *self.forces)
        return {s.name: n for n, s in reversed(list(enumerate(moving)))}

    @cached_property
    def _declared(self) -> dict[str, Kind]:
        declared = [
            (self.forces, Kind.FORCE),
            (self.parameters, Kind.PARAMETER),
            ((*self.speeds, *self.frequencies), Kind.VELOCITY),
            ((*self.prescribed, *self.coordinates), Kind.COORDINATE),
        ]
        return {"t": Kind.TIME} | {s.name: kind for symbols, kind in declared for s in symbols}


def alphabetic(name: str) -> tuple[str, tuple[str, ...]]:
    """Latin before Greek, and otherwise as in a dictionary; x_2 before x_10."""
    parts = Name.of(name)
    greek = "1" if parts.letter in GREEK and parts.letter != "ell" else "0"
    return f"{greek}{parts.letter.lower()}{parts.letter}", tuple(map(counting, parts.indices))
