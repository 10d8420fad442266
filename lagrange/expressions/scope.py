"""The declared names: the only ones that have a meaning in an expression.

Coordinates and prescribed motions are slots; parameters, abbreviations and reactions are scalars; undefined functions
and vectors have tables of their own. `i`, `j`, `k` are the fixed unit vectors unless a file declares them; `e_x`,
`e_y`, `e_z` always are. Apart from these only `t`, `pi` and the functions of the language are known.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from functools import cached_property

import sympy as sp

from lagrange.core.records import record
from lagrange.core.symbols import Slots, t
from lagrange.core.vectors import Vector
from lagrange.expressions.bounded_arithmetic import WorkBudget
from lagrange.expressions.characters import VARIANTS
from lagrange.expressions.syntax_tree import FUNCTIONS, OPERATIONS, Role

UNITS = {
    "i": Vector((sp.S.One, sp.S.Zero, sp.S.Zero)),
    "j": Vector((sp.S.Zero, sp.S.One, sp.S.Zero)),
    "k": Vector((sp.S.Zero, sp.S.Zero, sp.S.One)),
}
"""The fixed unit vectors, unless these names are declared otherwise."""

ALWAYS_UNITS = {f"e_{axis}": unit for axis, unit in zip("xyz", UNITS.values(), strict=True)}
"""The fixed unit vectors under reserved names."""

RESERVED = frozenset({"t", "pi", *FUNCTIONS, *OPERATIONS, *ALWAYS_UNITS})
"""Names that a file cannot declare."""

_CONSTANTS = {"t": t, "pi": sp.pi}


@record
class FunctionDeclaration:
    """An undefined function and the names of its arguments.

    standard  the arguments of the bare name, where the names of the arguments do not determine them
    """

    name: str
    arguments: tuple[str, ...]
    standard: tuple[sp.Expr, ...] | None = None

    def __str__(self) -> str:
        return f"{self.name}({', '.join(self.arguments)})"


@record
class Scope:
    """The declared names.

    reactions  the names of the reactions, by those of their constraints, for advice
    budget    the work that is left for reading the texts of the file
    decimals  if not None, decimals that may have been rounded are read as symbols (`Decimal`), with this in their names
    """

    scalars: Mapping[str, sp.Expr] = field(default_factory=dict)
    slots: Slots = field(default_factory=lambda: Slots(()))
    functions: Mapping[str, FunctionDeclaration] = field(default_factory=dict)
    vectors: Mapping[str, Vector] = field(default_factory=dict)
    reactions: Mapping[str, str] = field(default_factory=dict, compare=False, repr=False)
    budget: WorkBudget | None = field(default=None, compare=False, repr=False)
    decimals: str | None = None

    def scalar(self, name: str) -> sp.Expr | None:
        """The scalar that a name means, if any."""
        if name in self.scalars:
            return self.scalars[name]
        return self._moving.get(name, _CONSTANTS.get(name))

    def vector(self, name: str) -> Vector | None:
        """The vector that a name means, if any; `i`, `j`, `k` only where no symbol has that name."""
        if name in UNITS:
            return self.unit(name) if self.scalar(name) is None and name not in self.functions else None
        return self.vectors.get(name, ALWAYS_UNITS.get(name))

    def unit(self, name: str) -> Vector | None:
        """The unit vector `i`, `j` or `k`, even if a symbol has that name."""
        return self.vectors.get(name, UNITS[name]) if name in UNITS else None

    def role(self, name: str) -> Role:
        """The role of a name in the grammar."""
        value = self.scalar(name)
        if value is not None:
            return self._roles.get(value, Role.SCALAR)
        if name in self.functions:
            return Role.FUNCTION
        return Role.UNDECLARED if self.vector(name) is None else Role.VECTOR

    def spelling(self, name: str) -> str:
        """The declared spelling of a loose name: θ₁ is theta_1 or theta1, ϑ is vartheta or theta."""
        head, _, digits = name.rpartition("_")
        stem = head or name
        tail = digits if head else ""
        for letter in (stem, *([VARIANTS[stem]] if stem in VARIANTS else [])):
            for candidate in (f"{letter}_{tail}", f"{letter}{tail}") if tail else (letter,):
                if self.role(candidate) is not Role.UNDECLARED:
                    return candidate
        return name

    def names(self) -> tuple[str, ...]:
        """All names, those of the file first."""
        declared = [*self._moving, *self.scalars, *self.functions, *self.vectors]
        return tuple(dict.fromkeys([*declared, *_CONSTANTS, *FUNCTIONS, *OPERATIONS]))

    @cached_property
    def _moving(self) -> dict[str, sp.Symbol]:
        return {s.name: s for s in (*self.slots.coordinates, *self.slots.prescribed)}

    @cached_property
    def _roles(self) -> dict[sp.Expr, Role]:
        coordinates = dict.fromkeys(self.slots.coordinates, Role.COORDINATE)
        return coordinates | dict.fromkeys(self.slots.prescribed, Role.PRESCRIBED)
