"""The kind of a symbol, and its place in the order of its kind.

Most of this follows from the name: x' is a velocity, d(x) a differential, lambda_rod a multiplier. The rest is declared
by a problem and collected in its `Notation`: the coordinates in their order, prescribed motions, quasi-velocities,
unknown forces, and scalars that have the names of the unit vectors.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import field
from enum import IntEnum
from functools import cached_property

import sympy as sp

from lagrange.core.records import record
from lagrange.core.symbols import FormSymbol, Sign, UnitSymbol, UnitVector, VectorSymbol, counting
from lagrange.document.names import GREEK, WrittenName

SortPlace = tuple[int, str, tuple[str, ...]]  # declared order, then alphabetic
CONVENTIONAL = frozenset({"x", "y", "z", "q", "r", "s", "theta", "phi", "psi", "rho", "varphi"})
"""Letters that are coordinates where a notation declares none."""
_NAMED = re.compile(r"((?:d|delta)\(|)(.*?)('*\)?)", re.DOTALL)


class SymbolKind(IntEnum):
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


MOVING = (SymbolKind.ACCELERATION, SymbolKind.VELOCITY, SymbolKind.COORDINATE)


@record
class Notation:
    """What the writer has to know about the symbols of a problem; every field is optional.

    coordinates     in declared order, those of the choices after those of the file
    prescribed      prescribed motions u(t)
    speeds          quasi-velocities
    frequencies     the unknowns ω or p of small oscillations: their terms come first, but the factor in ω t
    parameters      needed only if the name suggests another kind
    forces          multipliers and unknown forces, except for names with the prefix lambda_
    scalar_names    declared scalars; with i, j or k among them the unit vectors are e_x, e_y, e_z
    ambiguous       undefined functions that occur with several lists of arguments
    directions      unit vectors that the file names, in declared order
    page_names      names that are shorter on a printed page, where there is one body or constraint: r_P -> r
    """

    coordinates: tuple[sp.Symbol, ...] = ()
    prescribed: tuple[sp.Symbol, ...] = ()
    speeds: tuple[sp.Symbol, ...] = ()
    frequencies: tuple[sp.Symbol, ...] = ()
    parameters: tuple[sp.Symbol, ...] = ()
    forces: tuple[sp.Symbol, ...] = ()
    scalar_names: frozenset[str] = frozenset()
    ambiguous: frozenset[str] = frozenset()
    directions: tuple[str, ...] = ()
    page_names: Mapping[str, str] = field(default_factory=dict)

    @property
    def shadows_unit_vectors(self) -> bool:
        """Whether i, j, k must be written e_x, e_y, e_z."""
        return bool(self.scalar_names & {"i", "j", "k"})

    def kind(self, symbol: sp.Symbol) -> SymbolKind:
        """The kind of a symbol; for an undeclared one it follows from the name."""
        if isinstance(symbol, FormSymbol):
            return SymbolKind.DIFFERENTIAL
        if isinstance(symbol, UnitVector | VectorSymbol):
            return SymbolKind.VECTOR
        if isinstance(symbol, UnitSymbol):
            return SymbolKind.PARAMETER
        name = symbol.name
        if name in self._declared:
            return self._declared[name]
        if isinstance(symbol, Sign):
            return SymbolKind.SIGN
        if name.endswith(")"):
            return SymbolKind.DIFFERENTIAL
        if name.endswith("'"):
            stem = name.rstrip("'")
            order = len(name) - len(stem) + (self._declared.get(stem) == SymbolKind.VELOCITY)
            return SymbolKind.VELOCITY if order == 1 else SymbolKind.ACCELERATION
        if name.startswith("lambda_"):
            return SymbolKind.FORCE
        if not self.coordinates and WrittenName.of(name).letter in CONVENTIONAL:
            return SymbolKind.COORDINATE
        return SymbolKind.PARAMETER

    def on_page(self, name: str) -> str:
        """The name as a printed page has it: delta(r_P) is delta(r) where P is the only body."""
        if not self.page_names:
            return name
        before, stem, after = _NAMED.fullmatch(name).groups()  # type: ignore[union-attr]
        return f"{before}{self.page_names.get(stem, stem)}{after}"

    def place(self, name: str) -> SortPlace:
        """The place of a coordinate, or of its velocity, differential, ..., among the others; t comes last."""
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
    def _declared(self) -> dict[str, SymbolKind]:
        declared = [
            (self.forces, SymbolKind.FORCE),
            (self.parameters, SymbolKind.PARAMETER),
            ((*self.speeds, *self.frequencies), SymbolKind.VELOCITY),
            ((*self.prescribed, *self.coordinates), SymbolKind.COORDINATE),
        ]
        return {"t": SymbolKind.TIME} | {s.name: kind for symbols, kind in declared for s in symbols}


def alphabetic(name: str) -> tuple[str, tuple[str, ...]]:
    """Sort key of a name: Latin before Greek, otherwise as in a dictionary, but x_2 before x_10."""
    parts = WrittenName.of(name)
    greek = "1" if parts.letter in GREEK and parts.letter != "ell" else "0"
    return f"{greek}{parts.letter.lower()}{parts.letter}", tuple(map(counting, parts.indices))
