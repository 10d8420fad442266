"""Names and pieces of code: the atoms and the building blocks of written mathematics.

The name of a symbol is its text form and determines its spelling: theta_1'' is the letter theta with index 1 and two
dots, d(x) the differential of x, delta(r_P) the variation of the vector r_P. A trailing number is an index too, so that
theta1 and theta_1 look alike. Dots go on the letter, not on the index: θ̈₁. A name of several letters that is not Greek
stays a word, with primes instead of dots: pos″.

A `Piece` is the code of an expression with its precedence, from which the walker sees where brackets are needed. The
code of a sum is marked: START, BREAK before each sign but the first, END. From the marks a layout finds where a long
equation can be broken, and how deep each place is; `plain` removes them. The marks are from the private use area of
Unicode, so that no name contains them.

The kind of a symbol, and its place in the order of its kind.

Most of this follows from the name: x' is a velocity, d(x) a differential, lambda_rod a multiplier. The rest is declared
by a problem and collected in its `Notation`: the coordinates in their order, prescribed motions, quasi-velocities,
unknown forces, and scalars that have the names of the unit vectors.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Mapping
from dataclasses import field
from enum import IntEnum
from functools import cached_property, lru_cache

import sympy as sp

from lagrange.core.records import record
from lagrange.core.symbols import FormSymbol, Sign, UnitSymbol, UnitVector, VectorSymbol, counting

# name: (letter, LaTeX). Capitals that look Latin have no command in LaTeX; ℓ is here because it is treated alike.
GREEK: dict[str, tuple[str, str]] = {
    "alpha": ("α", r"\alpha"),
    "beta": ("β", r"\beta"),
    "gamma": ("γ", r"\gamma"),
    "delta": ("δ", r"\delta"),
    "epsilon": ("ε", r"\epsilon"),
    "varepsilon": ("ϵ", r"\varepsilon"),
    "zeta": ("ζ", r"\zeta"),
    "eta": ("η", r"\eta"),
    "theta": ("θ", r"\theta"),
    "vartheta": ("ϑ", r"\vartheta"),
    "iota": ("ι", r"\iota"),
    "kappa": ("κ", r"\kappa"),
    "varkappa": ("ϰ", r"\varkappa"),
    "lambda": ("λ", r"\lambda"),
    "mu": ("μ", r"\mu"),
    "nu": ("ν", r"\nu"),
    "xi": ("ξ", r"\xi"),
    "omicron": ("ο", "o"),
    "pi": ("π", r"\pi"),
    "varpi": ("ϖ", r"\varpi"),
    "rho": ("ρ", r"\rho"),
    "varrho": ("ϱ", r"\varrho"),
    "sigma": ("σ", r"\sigma"),
    "varsigma": ("ς", r"\varsigma"),
    "tau": ("τ", r"\tau"),
    "upsilon": ("υ", r"\upsilon"),
    "phi": ("φ", r"\phi"),
    "varphi": ("ϕ", r"\varphi"),
    "chi": ("χ", r"\chi"),
    "psi": ("ψ", r"\psi"),
    "omega": ("ω", r"\omega"),
    "Alpha": ("Α", r"\mathrm{A}"),
    "Beta": ("Β", r"\mathrm{B}"),
    "Gamma": ("Γ", r"\Gamma"),
    "Delta": ("Δ", r"\Delta"),
    "Epsilon": ("Ε", r"\mathrm{E}"),
    "Zeta": ("Ζ", r"\mathrm{Z}"),
    "Eta": ("Η", r"\mathrm{H}"),
    "Theta": ("Θ", r"\Theta"),
    "Iota": ("Ι", r"\mathrm{I}"),
    "Kappa": ("Κ", r"\mathrm{K}"),
    "Lambda": ("Λ", r"\Lambda"),
    "Mu": ("Μ", r"\mathrm{M}"),
    "Nu": ("Ν", r"\mathrm{N}"),
    "Xi": ("Ξ", r"\Xi"),
    "Omicron": ("Ο", r"\mathrm{O}"),
    "Pi": ("Π", r"\Pi"),
    "Rho": ("Ρ", r"\mathrm{P}"),
    "Sigma": ("Σ", r"\Sigma"),
    "Tau": ("Τ", r"\mathrm{T}"),
    "Upsilon": ("Υ", r"\Upsilon"),
    "Phi": ("Φ", r"\Phi"),
    "Chi": ("Χ", r"\mathrm{X}"),
    "Psi": ("Ψ", r"\Psi"),
    "Omega": ("Ω", r"\Omega"),
    "ell": ("ℓ", r"\ell"),
}

SUBSCRIPTS = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")
SMALL = dict(zip("aehijklmnoprstuvx", "ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓ", strict=True))
SUPERSCRIPTS = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")

_DOTS = ("", "\u0307", "\u0308")
_OPERATED = re.compile(r"(d|delta|nabla)\((.+)\)\Z")
_MIXED = re.compile(r"(\d+)([aehijklmnoprstuvx])\Z")  # a_1t
_BEFORE = re.compile(r"([^']+)('+)_(\d+)\Z")  # x'_0, a velocity at one instant
_NUMBERED = re.compile(r"([^\W\d_]+)(\d+)\Z")


@record
class WrittenName:
    """A name in its parts.

    operator    "", "d", "delta" or "nabla"
    letter      "theta", "x", "pos"
    indices     ("1",), ("rod",), ("1", "B")
    primes      how many time derivatives
    """

    operator: str
    letter: str
    indices: tuple[str, ...]
    primes: int

    @classmethod
    @lru_cache(maxsize=1 << 12)
    def of(cls, name: str) -> WrittenName:
        """Parse a name."""
        if operated := _OPERATED.match(name):
            inner = cls.of(operated[2])
            return cls(operated[1], inner.letter, inner.indices, inner.primes)
        if instant := _BEFORE.match(name):
            inner = cls.of(instant[1])
            return cls("", inner.letter, (*inner.indices[:-1], ",".join((*inner.indices[-1:], instant[3]))),
                       len(instant[2]))  # fmt: skip
        stem = name.rstrip("'")
        letter, _, label = stem.partition("_")
        indices = (label,) if label else ()
        if numbered := _NUMBERED.match(letter):
            letter, indices = numbered[1], (numbered[2], *indices)
        return cls("", letter, indices, len(name) - len(stem))

    @property
    def is_letter(self) -> bool:
        """Whether it is written with one letter, so that a product of such names needs no sign."""
        return len(self.letter) == 1 or self.letter in GREEK

    @property
    def is_tight(self) -> bool:
        """Whether a letter after it without a space is read as another factor: ωt, but not kx or λ_rod x."""
        return self.letter in GREEK and not self.primes and all(index.isdigit() for index in self.indices)


def unicode_name(name: WrittenName, bold: bool = False) -> str:
    """`θ̈₁`, `dx`, `δr_P`, `λ_rod`, `pos″`; a bold letter from the mathematical alphabets of Unicode."""
    letter = _letter(name.letter)
    if bold and name.operator != "nabla":
        letter = "".join(map(_bold, letter))
    dotted = len(letter) == 1 and name.primes < len(_DOTS)
    body = unicodedata.normalize("NFC", letter + _DOTS[name.primes]) if dotted else letter
    body += "".join(_unicode_index(index) for index in name.indices)
    if not dotted:
        body += {1: "′", 2: "″", 3: "‴"}.get(name.primes, "′" * name.primes)
    return {"": "", "d": "d", "delta": "δ", "nabla": "∇"}[name.operator] + body


def latex_name(name: WrittenName, bold: bool = False) -> str:
    r"""`\ddot{\theta}_{1}`, `\mathrm{d}x`, `\delta \mathbf{r}_{P}`, `\lambda_{\text{rod}}`."""
    body = _latex_letter(name.letter, bold and name.operator != "nabla")
    if 0 < name.primes < 4:
        body = "\\" + "d" * (name.primes - 1) + "dot{" + body + "}"
    if name.indices:
        body += "_{" + ",".join(_latex_index(index) for index in name.indices) + "}"
    if name.primes > 3:
        body += "^{(" + str(name.primes) + ")}"
    return {"": "", "d": r"\mathrm{d}", "delta": r"\delta ", "nabla": r"\nabla "}[name.operator] + body


_BOLD = ((65, 90, 0x1D400), (97, 122, 0x1D41A), (0x391, 0x3A9, 0x1D6A8), (0x3B1, 0x3C9, 0x1D6C2))
"""Latin and Greek letters, capital and small: the first, the last, the bold first."""


def _bold(letter: str) -> str:
    """𝐫 for r; a letter without a bold form as it is."""
    return next((chr(ord(letter) - a + bold) for a, z, bold in _BOLD if a <= ord(letter) <= z), letter)


def _letter(word: str) -> str:
    return GREEK[word][0] if word in GREEK else word


def _unicode_index(index: str) -> str:
    if "," in index:
        return ",".join(map(_unicode_index, index.split(",")))
    if mixed := _MIXED.match(index):
        return mixed[1].translate(SUBSCRIPTS) + SMALL[mixed[2]]
    return index.translate(SUBSCRIPTS) if index.isdigit() else "_" + unicode_name(WrittenName.of(index))


_COMMANDS = dict(GREEK.values())


def _latex_letter(word: str, bold: bool) -> str:
    command = GREEK[word][1] if word in GREEK else _COMMANDS.get(word)
    if command is not None:
        return rf"\boldsymbol{{{command}}}" if bold else command
    if bold:
        return rf"\mathbf{{{word}}}"
    if len(word) == 1 and word.isascii():
        return word
    if word == "const":
        return r"\mathrm{const}"
    return rf"\mathit{{{word}}}" if word.isascii() else rf"\text{{{word}}}"


def _latex_index(index: str) -> str:
    if "," in index:
        return ",".join(map(_latex_index, index.split(",")))
    if _MIXED.match(index):
        return index
    inner = WrittenName.of(index)
    if index.isdigit() or (inner.is_letter and all(i.isdigit() or len(i) == 1 or i in GREEK for i in inner.indices)):
        return index if index.isdigit() else latex_name(inner)
    words = [word for word in re.split(r"[_.]", index) if word]
    numbers = [word for word in words if word.isdigit()]
    return ",".join([r"\text{" + " ".join(w for w in words if not w.isdigit()) + "}", *numbers])


START, BREAK, END = "\ue000", "\ue001", "\ue002"
_MARKS = re.compile(f"[{START}{BREAK}{END}]")


def plain(code: str) -> str:
    """The code without marks."""
    return _MARKS.sub("", code)


class Precedence(IntEnum):
    """How tightly a piece binds: lower ones need brackets in higher ones."""

    SUM = 0  # a + b, -a
    DIVISION = 1  # a/b
    PRODUCT = 2  # a b
    APPLICATION = 3  # sin θ, without parentheses
    POWER = 4  # x², √(a + b)
    ATOM = 5  # x, f(x), (a + b)


@record
class Piece:
    """The code of an expression. `tight`: a number before it needs no space, as in 2x."""

    code: str
    level: Precedence = Precedence.ATOM
    tight: bool = False


def brackets(code: str, brace: str = "{") -> tuple[str, str]:
    """Round brackets; square ones around a sum or bracket that contains round ones, then braces."""
    if not code.startswith((START, "(", "−", "-")) or "(" not in code:
        return "(", ")"
    return ("{", "}") if "[" in code and brace not in code else ("[", "]")


# Notation


SortPlace = tuple[int, str, tuple[str, ...]]  # declared order, then alphabetic
CONVENTIONAL = frozenset({"x", "y", "z", "q", "r", "s", "theta", "phi", "psi", "rho", "varphi"})
"""Letters that are coordinates where a notation declares none."""
_NAMED = re.compile(r"((?:d|delta)\(|)(.*?)('*\)?)", re.DOTALL)


class SymbolKind(IntEnum):
    """The role of a symbol."""

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
