"""A derivation is data: steps of prose, equations, tables and checks, with SymPy in them and never strings of it.

Stages make steps, renderers format them; neither knows the other. A label is an id; the renderer gives the number.
Short ways to build the blocks are in `builders`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import field
from enum import IntEnum, StrEnum
from functools import cached_property
from typing import TYPE_CHECKING, TypeAlias, overload

import sympy as sp

from lagrange.core.operations import count_operations
from lagrange.core.records import record
from lagrange.core.vectors import Vector
from lagrange.document.purposes import Purpose

if TYPE_CHECKING:
    from lagrange.document.scene import Scene

Mathematics: TypeAlias = sp.Expr | Vector


class Rule(StrEnum):
    """What a step does. Stable: programs rely on these names."""

    RESULT = "result"  # one degree of freedom, l θ'' + g sin θ = 0: at the head of the page
    STATEMENT = "statement"  # a particle P of mass m at x i + y j, with its weight m g j
    CONSTRAINT = "constraint"  # x² + y² = l²: no velocity occurs, geometric
    PFAFFIAN_FORM = "pfaffian-form"  # 2x dx + 2y dy = 0
    INTEGRABILITY = "integrability"  # ∂(2x)/∂y = 0 = ∂(2y)/∂x: exact
    CLASSIFICATION = "classification"  # holonomic, scleronomic
    DEGREES_OF_FREEDOM = "degrees-of-freedom"  # 2 - 1 = 1
    DISPLACEMENTS = "displacements"  # x δx + y δy = 0, δx = -(y/x) δy
    REACTIONS = "reactions"  # m x'' = 2 x λ
    WORKLESS = "workless"  # R·δr = 0
    PRINCIPLE = "principle"  # (m r'' - F)·δr = 0
    ENERGIES = "energies"  # T = m l² θ'²/2, V = −m g l cos θ
    LAGRANGE = "lagrange-equations"  # p_θ = m l² θ', d/dt p_θ = ∂L/∂θ
    GENERALIZED_COORDINATES = "generalized-coordinates"  # x = l sin θ, y = l cos θ
    EQUATIONS_OF_MOTION = "equations-of-motion"  # l θ'' + g sin θ = 0
    QUASI_VELOCITIES = "quasi-velocities"  # u = x' cos θ + y' sin θ: u' = a ω²
    LINEARIZATION = "linearization"  # l ξ'' + g ξ = 0, ω² = g/l
    RESPONSE = "forced-oscillations"  # m ξ'' + c ξ' + k ξ = F cos ωt, A = F/√((k − m ω²)² + c² ω²)
    SOLVED_REACTIONS = "solved-reactions"  # T = m g cos θ + m l θ'²
    CONSERVED = "conserved"  # m l² θ'²/2 − m g l cos θ = const
    HAMILTON = "hamilton-equations"  # H = p_θ²/(2 m l²) − m g l cos θ, p_θ' = −∂H/∂θ
    STEADY = "steady-motions"  # cos θ = g/(l φ'²)
    IMPACT = "impact"  # Σ (m Δv − J)·δr = 0: x' = J/m, energy lost m v²/4
    QUESTION = "question"  # N = 0: cos θ = 2/3
    FRICTION_AT_REST = "friction-at-rest"  # |F| ≤ μ_s N: tan α ≤ μ_s
    EQUILIBRIUM = "equilibrium"  # tan θ = (2k - 1)/tan α
    MEANING = "meaning"  # small θ: period 2π √(l/g)
    CHECKS = "checks"  # Lagrange's equations give the same


class Detail(IntEnum):
    """The level of detail from which on a block is shown."""

    BRIEF = 0
    STEPS = 1
    FULL = 2


@record
class Math:
    """Mathematics in running text. With several sides it reads a = b = c."""

    sides: tuple[Mathematics, ...]
    relation: str = "="


@record
class Ref:
    """The number of a labelled equation."""

    label: str


@record
class Emphasis:
    """A word that is being defined or concluded: set in italics or bold."""

    word: str


Part = str | Math | Ref | Emphasis


@record
class Prose:
    """A paragraph; `short` replaces it where little detail is wanted, `purpose` says what it is for."""

    parts: tuple[Part, ...]
    detail: Detail = Detail.STEPS
    short: tuple[Part, ...] = ()
    purpose: Purpose | None = field(default=None, compare=False)


@record
class Equation:
    """A displayed equation a = b = c, followed by its `condition` ("where y ≠ 0")."""

    sides: tuple[Mathematics, ...]
    label: str | None = None
    relation: str = "="
    condition: tuple[Part, ...] = ()

    @property
    def operations(self) -> int:
        """How long the sides are to read, vectors aside."""
        return sum(count_operations(s) for s in self.sides if isinstance(s, sp.Expr))


@record
class Display:
    """Equations that belong together; boxed when they are a result."""

    equations: tuple[Equation, ...]
    boxed: bool = False
    detail: Detail = Detail.STEPS

    @property
    def operations(self) -> int:
        """Those of all equations."""
        return sum(e.operations for e in self.equations)


@record
class Table:
    """A table: cells are text or mathematics; the first column names the rows."""

    header: tuple[Part, ...]
    rows: tuple[tuple[Part, ...], ...]
    detail: Detail = Detail.STEPS


@record
class Matrices:
    """Named matrices, M = (a b; c d), side by side where there is room; a column has rows of one entry."""

    named: tuple[tuple[sp.Symbol, tuple[tuple[sp.Expr, ...], ...]], ...]
    detail: Detail = Detail.STEPS


@record
class CheckMark:
    """A check, whether it held (None: undecided), and how it was made."""

    name: tuple[Part, ...]
    passed: bool | None
    how: str
    detail: Detail = Detail.BRIEF


@record
class Picture:
    """A picture, drawn on demand; None where it cannot be drawn sensibly.

    caption  the line below it
    alt      a description in words
    """

    draw: Callable[[], Scene | None] = field(compare=False)
    caption: tuple[Part, ...]
    alt: str
    detail: Detail = Detail.STEPS


@record
class Task:
    """What is to be done on a worksheet, and room for it: so many lines of handwriting."""

    parts: tuple[Part, ...]
    lines: int
    detail: Detail = Detail.BRIEF


Block = Prose | Display | Table | Matrices | CheckMark | Picture | Task


@record
class Step:
    """One step of the derivation; one without a title, such as the result at the head, has no number either.

    choice  the choice of coordinates to which it belongs; empty for the file's own
    folded  what a page says in its place, where it shows it only on request: `Other coordinate: y`
    about   the name of the question that it answers
    """

    rule: Rule
    title: str
    body: tuple[Block, ...]
    choice: str = ""
    folded: tuple[Part, ...] = ()
    about: str = field(default="", compare=False)


class MadeWhenRead(Sequence[Step]):
    """Steps that are made when they are first read, and then once."""

    def __init__(self, make: Callable[[], Iterable[Step]]) -> None:
        self._make = make

    @cached_property
    def _steps(self) -> tuple[Step, ...]:
        return tuple(self._make())

    @overload
    def __getitem__(self, place: int) -> Step: ...
    @overload
    def __getitem__(self, place: slice) -> tuple[Step, ...]: ...
    def __getitem__(self, place: int | slice) -> Step | tuple[Step, ...]:
        return self._steps[place]

    def __len__(self) -> int:
        return len(self._steps)

    def __eq__(self, other: object) -> bool:
        return self._steps == tuple(other) if isinstance(other, Sequence) else NotImplemented

    def __hash__(self) -> int:
        return hash(self._steps)


@record
class Derivation:
    """A whole derivation. No format shows both lists of steps; that which is not shown need not be made.

    steps  everything, in the order of the chapter: what JSON and `--detail full` have
    page   what is printed by default: the result first, then the shortest way to it; empty where it is `steps`
    """

    title: str
    source: str
    steps: Sequence[Step]
    page: Sequence[Step] = ()

    def at(self, detail: Detail) -> Sequence[Step]:
        """The steps of a level of detail."""
        return self.steps if detail is Detail.FULL or not self.page else self.page
