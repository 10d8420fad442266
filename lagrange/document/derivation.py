"""A derivation is data: steps of prose, equations, tables and checks, with SymPy in them and never strings of it.

Stages make steps, renderers format them; neither knows the other. A label is an id; the renderer gives the number.

References to equations: under other labels, where another step displays them; in words, where none does.

What a paragraph is for in its step, or a few words in their paragraph, as data beside the words.

The full derivation says everything; a page says the same in fewer words. It finds what it shortens by these purposes,
which are given where a sentence is made, and never by its wording: the words may change without a page noticing.

Short ways to build the blocks of a derivation: `prose("With ", math(x), ", ", Ref("motion"), " becomes")`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import field, replace
from enum import Enum, IntEnum, StrEnum, auto
from functools import cached_property
from typing import TYPE_CHECKING, TypeAlias, TypeGuard, overload

import sympy as sp

from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.vectors import Vector

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
    """A paragraph; `short` replaces it at low levels of detail, `purpose` is its function on the page."""

    parts: tuple[Part, ...]
    detail: Detail = Detail.STEPS
    short: tuple[Part, ...] = ()
    purpose: Purpose | None = field(default=None, compare=False)


class EquationKind(StrEnum):
    """What a displayed equation is; beside each an example. A page finds equations by these, never by their labels."""

    POSITION = "position"  # r_P = x i + y j
    FORCE = "force"  # F_P = m g j, or λ = m x''
    MOMENT = "moment"  # M_disc = τ k, applied
    SPIN = "spin"  # ω_disc = φ' k
    MOMENTUM = "momentum"  # H_disc = J φ' k, or p = m x'
    HIDDEN = "hidden"  # x - R φ = const, which several constraints imply together
    ONLY = "only"  # y = 0, which a constraint leaves
    VIRTUAL = "virtual"  # x δx + y δy = 0
    POSSIBLE = "possible"  # dx = δx + u dt
    DELTA = "delta"  # δr_P = l δθ e
    ROTATION = "rotation"  # δπ_disc = δφ k
    NEWTON = "newton"  # m x'' = N
    TURNING = "turning"  # J φ'' = R F
    REACTION = "reaction"  # R_P = N n
    COUPLE = "couple"  # Γ_disc = R F k
    SHARE = "share"  # N n·δr_P, the work of a reaction at one of its particles
    POSSIBLE_WORK = "possible-work"  # λ u dt
    SUM_ALONG_AXES = "sum-along-axes"  # R_P = m g cos θ e_r + ..., along unit vectors that turn
    ACCELERATION = "acceleration"  # r_P'' = x'' i + y'' j
    MOMENTUM_RATE = "momentum-rate"  # H_disc' = J φ'' k
    REDUCED = "reduced"  # the principle without dependent displacements
    MOTION = "motion"  # l θ'' + g sin θ = 0
    COMPLETING = "completing"  # x² + y² = l², beside equations of motion that need it
    CHOICE = "choice"  # x = l sin θ
    REMAINING_RATE = "remaining-rate"  # x' - R φ' = 0, in coordinates that are chosen
    SPEED = "speed"  # u = x' cos θ + y' sin θ
    KINEMATIC = "kinematic"  # x' = u cos θ
    QUASI_VARIATION = "quasi-variation"  # δπ_u = δx cos θ + δy sin θ
    MOTION_IN_SPEEDS = "motion-in-speeds"  # u' = a ω²
    CONSERVED = "conserved"  # m x' = const
    ENERGY_RATE = "energy-rate"  # d(T + V)/dt = -k x'²
    LINEAR = "linear"  # l ξ'' + g ξ = 0
    FORCED = "forced"  # m ξ'' + c ξ = F cos ωt
    RESONANCE = "resonance"  # ω² = c/m
    BEFORE = "before"  # x' = v before an impact


@record
class Equation:
    """A displayed equation a = b = c, followed by its `condition` ("where y ≠ 0").

    label   an id, for references only
    second  the label of an equation that follows in the same line, under the same number
    about   the name of the constraint or body that its kind is about, where a page needs it
    """

    sides: tuple[Mathematics, ...]
    label: str | None = None
    relation: str = "="
    condition: tuple[Part, ...] = ()
    second: str | None = None
    kind: EquationKind | None = field(default=None, compare=False)
    about: str = field(default="", compare=False)

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

    def is_of(self, *kinds: EquationKind) -> bool:
        """Whether all equations are of these kinds."""
        return all(e.kind in kinds for e in self.equations)

    def map(self, change: Callable[[Equation], Equation]) -> Display:
        """The display with `change` applied to each of its equations."""
        return replace(self, equations=tuple(map(change, self.equations)))


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
    """A picture, drawn on demand; None if it cannot be drawn sensibly.

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

    def map(self, change: Callable[[Equation], Equation]) -> Step:
        """The step with `change` applied to each of its displayed equations."""
        return replace(self, body=tuple(b.map(change) if isinstance(b, Display) else b for b in self.body))


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
    """A whole derivation. No format shows both lists of steps; the one that is not shown need not be built.

    steps  everything, in the order of the chapter: what JSON and `--detail full` have
    page   what is printed by default: the result first, then the shortest way to it; empty if it is `steps`
    """

    title: str
    source: str
    steps: Sequence[Step]
    page: Sequence[Step] = ()

    def at(self, detail: Detail) -> Sequence[Step]:
        """The steps of a level of detail."""
        return self.steps if detail is Detail.FULL or not self.page else self.page


# References


def referring_to(blocks: Iterable[Block], labels: Mapping[str, str]) -> Iterator[Block]:
    """The blocks with the labels in their references replaced, including those in conditions beside equations."""

    def part(p: Part) -> Part:
        return Ref(labels[p.label]) if isinstance(p, Ref) and p.label in labels else p

    for b in blocks:
        if isinstance(b, Prose):
            yield replace(b, parts=tuple(map(part, b.parts)), short=tuple(map(part, b.short)))
        elif isinstance(b, Display):
            equations = (replace(e, condition=tuple(map(part, e.condition))) for e in b.equations)
            yield replace(b, equations=tuple(equations))
        else:
            yield b


def labels_in(steps: Iterable[Step]) -> set[str]:
    """The labels of all equations that are displayed."""
    return {e.label for s in steps for b in s.body if isinstance(b, Display) for e in b.equations if e.label}


def not_referring(block: Block, is_missing: Callable[[str], bool]) -> Block:
    """A block whose references to equations that are omitted are words."""

    def named(parts: Iterable[Part]) -> tuple[Part, ...]:
        return tuple("an equation left out here" if isinstance(p, Ref) and is_missing(p.label) else p for p in parts)

    if isinstance(block, Prose):
        return replace(block, parts=named(block.parts), short=named(block.short))
    return replace(block, name=named(block.name)) if isinstance(block, CheckMark) else block


# Purposes


class Purpose(Enum):
    """What words are for; beside each an example."""

    # of paragraphs
    DEFINITIONS = auto()  # For brevity, write
    CONSTANT_RATES = auto()  # Accelerations, all of them constant:
    FRICTION_INSIDE = auto()  # The friction contains N, the reaction of rod, found below.
    FORMS_TOGETHER = auto()  # Taken together, the constraints may imply finite relations
    NOT_EXACT_EITHER = auto()  # (7) is not exact either: ∂a/∂x = 1 ≠ 0 = ∂b/∂y.
    NEXT_PRODUCT = auto()  # With ω now for the form (7),
    NEXT_NOT_INTEGRABLE = auto()  # This does not vanish: (7) is not integrable.
    TIMELESS = auto()  # Time does not appear in (2): virtual displacements satisfy it too,
    DRIFT = auto()  # Possible and virtual displacements differ, because ...
    SOLVING = auto()  # Solving for δx, where x ≠ 0, gives
    FREE = auto()  # δy remains free.
    VIRTUAL = auto()  # In a virtual displacement
    ACTING = auto()  # On P acts its weight.
    LAW = auto()  # Newton's law, mass times acceleration ..., have the components
    COUNT = auto()  # The 2 components ... are 3 equations for 4 unknowns
    ONLY_SUM = auto()  # Only the sum need vanish
    KINEMATICS = auto()  # The acceleration and the rate of change of the angular momentum are
    WRITTEN_OUT = auto()  # Written out, it reads
    PRINCIPLE = auto()  # and d'Alembert's principle (4) reads
    ELIMINATED = auto()  # ψ is eliminated through its velocity.
    RATES = auto()  # Solving (5) for the velocities, and differentiating, gives
    MULTIPLIERS = auto()  # With multipliers instead, nothing is eliminated.
    NOT_SUBSTITUTED = auto()  # The constraint restricts velocities and is not substituted into T before ...
    MAY_PUSH = auto()  # A rod may also push
    CONTACT = auto()  # The floor can only push: it stays in contact as long as N ≥ 0, that is,
    ONLY_PUSHES = auto()  # A support that can only push requires N > 0
    WAVES = auto()  # There are solutions proportional to cos(ω t), with a constant amplitude, where
    RESONANCE = auto()  # The denominator vanishes at a frequency of free oscillations
    IN_TERMS_OF = auto()  # In terms of position and velocity,
    AS_BEFORE = auto()  # As before, (17) holds.
    # of paragraphs on what a result says
    IN_SHORT = auto()
    CONSERVED = auto()
    MOMENTUM = auto()  # conserved, linear or angular
    AT_REST = auto()
    SMALL_MOTION = auto()
    EXISTENCE_OPEN = auto()  # Any real solution of (2) is an equilibrium; whether there is one is left open.
    EXISTS = auto()  # By (24), such a position exists if
    LIMIT = auto()
    UNITS = auto()
    # of words in a paragraph
    SUBJECT = auto()  # The accelerations
    VERB = auto()  # is, are
    WHERE = auto()  # , where
    NOUN = auto()  # as generalized coordinates
    CONCLUSION = auto()  # , so the system is
    REASON = auto()  # the end of the first reason
    MOMENTA = auto()  # and its angular momentum about the mass centre
    REACHED = auto()  # The space of reachable configurations has dimension 3. ...
    SUM_AND_MOMENT = auto()  # On the disc act ... In terms of the forces, their sum and their moment are
    NO_TIME = auto()  # Time appears in none of them.
    COMPONENTS = auto()  # the components
    ALONG = auto()  # Along the motion
    THAT_IS = auto()  # , that is,
    LEFT_SIDES = auto()  # the colon after `N times the left side of (3)`
    EVERY_COORDINATE = auto()  # so for every coordinate
    GIVEN_VALUES = auto()  # with the given values
    AFTERMATH = auto()  # : at resonance there is no steady state


class Phrase(str):
    """Words of a paragraph with a purpose of their own.

    instead  what a page says in their place where it says less
    """

    purpose: Purpose | None
    instead: str

    def __new__(cls, words: str, purpose: Purpose | None = None, instead: str = "") -> Phrase:
        """The words with their purpose."""
        phrase = super().__new__(cls, words)
        phrase.purpose, phrase.instead = purpose, instead
        return phrase


# Builders


def prose(*parts: Part, detail: Detail = Detail.STEPS, purpose: Purpose | None = None) -> Prose:
    """A paragraph from text and mathematics."""
    return Prose(parts, detail, purpose=purpose)


def has_purpose(block: Block | None, purpose: Purpose) -> TypeGuard[Prose]:
    """Whether it is a paragraph of that purpose."""
    return isinstance(block, Prose) and block.purpose is purpose


def parts_of(block: Block) -> Iterator[Part]:
    """The parts of a paragraph, or of the conditions of displayed equations."""
    if isinstance(block, Prose):
        yield from block.parts
    elif isinstance(block, Display):
        yield from (p for e in block.equations for p in e.condition)


def index_of(purpose: Purpose, parts: Sequence[Part]) -> int | None:
    """Where the first words of that purpose are; None if there are none."""
    return next((n for n, part in enumerate(parts) if isinstance(part, Phrase) and part.purpose is purpose), None)


def math(*sides: Mathematics, relation: str = "=") -> Math:
    """Inline mathematics a = b = c."""
    return Math(sides, relation)


def paragraph(*sentences: Prose) -> Prose:
    """Sentences as one paragraph, with the purpose of the first."""
    parts: list[Part] = []
    for n, sentence in enumerate(sentences):
        parts += [" ", *sentence.parts] if n else sentence.parts
    return Prose(tuple(parts), min(s.detail for s in sentences), purpose=sentences[0].purpose)


def display(*equations: Equation, boxed: bool = False, detail: Detail = Detail.STEPS) -> Display:
    """Displayed equations."""
    return Display(equations, boxed, detail)


def paired(equations: Sequence[Equation]) -> tuple[Equation, ...]:
    """Equations two in a line, the second as what follows the first, which has the number."""
    pairs = [equations[n : n + 2] for n in range(0, len(equations), 2)]
    return tuple(_in_one_line(*pair) if len(pair) == 2 else pair[0] for pair in pairs)


def _in_one_line(first: Equation, second: Equation) -> Equation:
    return replace(first, condition=(Math(second.sides),), second=second.label)


def listed(parts: Iterable[Part], last: str = " and ") -> tuple[Part, ...]:
    """`a, b and c`, as parts of a paragraph."""
    return series(((part,) for part in parts), last)


def series(items: Iterable[Sequence[Part]], last: str = " and ") -> tuple[Part, ...]:
    """`a of b, c of d and e of f`: a list of which each item has several parts."""
    clauses = list(items)
    parts: list[Part] = []
    for n, clause in enumerate(clauses):
        if n:
            parts.append(last if n == len(clauses) - 1 else ", ")
        parts += clause
    return tuple(parts)
