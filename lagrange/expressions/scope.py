"""The declared names: the only ones that have a meaning in an expression.

Coordinates and prescribed motions are slots; parameters, abbreviations and reactions are scalars; undefined functions
and vectors have tables of their own. `i`, `j`, `k` are the fixed unit vectors unless a file declares them; `e_x`,
`e_y`, `e_z` always are. Apart from these only `t`, `pi` and the functions of the language are known.

Errors and notes at the places of syntax trees, with suggestions for names that are not declared.

A name that is not declared is usually a derivative in another notation (`xdot`, `dx`), a product without spaces (`ml`),
a letter confused with another (`w` for omega), a function in another spelling (`tg`, `arcsin`) or a typing error. The
patterns are tried in this order, the more specific ones first; every suggestion consists of declared names. If nothing
resembles the name, the declared names are listed.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import field
from functools import cached_property

import sympy as sp

from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError, Severity, nearest
from lagrange.core.records import record
from lagrange.core.symbols import Slots, t
from lagrange.core.vectors import Vector
from lagrange.expressions.bounded_arithmetic import TooExpensiveError, WorkBudget
from lagrange.expressions.characters import GREEK, VARIANTS
from lagrange.expressions.limits import MAX_LISTED, MAX_NAME, MAX_SPLIT
from lagrange.expressions.syntax_tree import DEGREES, FUNCTIONS, OPERATIONS, Call, Name, Role, Tree

UNITS = {
    "i": Vector((sp.S.One, sp.S.Zero, sp.S.Zero)),
    "j": Vector((sp.S.Zero, sp.S.One, sp.S.Zero)),
    "k": Vector((sp.S.Zero, sp.S.Zero, sp.S.One)),
}
"""The fixed unit vectors, unless these names are declared otherwise."""

ALWAYS_UNITS = {f"e_{axis}": unit for axis, unit in zip("xyz", UNITS.values(), strict=True)}
"""The fixed unit vectors under reserved names."""

ORIGIN = Vector((sp.S.Zero,) * 3)
"""The position of O, where nothing else is called so."""

RESERVED = frozenset({"t", "pi", *FUNCTIONS, *OPERATIONS, *ALWAYS_UNITS})
"""Names that a file cannot declare."""

_CONSTANTS = {"t": t, "pi": sp.pi}
_OF_BODIES = re.compile(r"(?:e[123]|omega)_.")
_ENERGIES = ("T_kinetic", "energy")
"""What no problem file declares itself: axes and angular velocities of bodies, energies in questions."""


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
        if name == "O" and self.scalar(name) is None and name not in self.functions:
            return self.vectors.get(name, ORIGIN)
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


# Suggestions


_OTHER_NAMES = {
    "ln": "log", "arcsin": "asin", "arccos": "acos", "arctan": "atan", "arctan2": "atan2", "arctg": "atan",
    "tg": "tan", "ctg": "cot", "cotan": "cot", "cosec": "csc", "sh": "sinh", "ch": "cosh",
    "th": "tanh", "sgn": "sign", "signum": "sign", "root": "sqrt", "Derivative": "diff", "derivative": "diff",
    "grad": "diff",
}  # fmt: skip
_ALIKE = tuple(
    group.split()
    for group in (
        "l I ell", "O o omicron", "v nu V upsilon", "w omega varpi", "u mu", "p rho", "a alpha", "k kappa varkappa K",
        "x chi X", "n eta", "t tau", "y gamma", "B beta", "E epsilon varepsilon", "phi varphi", "theta vartheta",
        "rho varrho", "sigma varsigma", "i iota", "d delta", "W omega",
    )
)  # fmt: skip
"""Letters that are easily confused."""
_RATES = (("ddot", 2), ("dot", 1), ("dd", 2), ("d", 1))


def help_for_symbol(name: str, scope: Scope) -> str:
    """A suggestion for a symbol that is not declared."""
    names = scope.names()
    if name in OPERATIONS or name in FUNCTIONS:
        return f"write `{name}(...)`"
    if name == "e":
        return "the exponential function is `exp(x)`; any other `e` must be declared"
    if scope.scalar("e") is not None and name[0] in "eE" and name[1:].isdigit():
        return f"`e` is a symbol here: a power of ten is written `10^{name[1:]}`"
    if name in ("d", "delta"):
        return f"a differential is written `{name}(x)`; any other `{name}` must be declared"
    if rate := _rate(name, scope):
        return f"did you mean `{rate}`? A prime is a time derivative"
    if differential := _differential(name, scope):
        return f"did you mean `{differential}`?"
    if force := scope.reactions.get(name):
        named = "" if force.startswith("lambda") else " force"
        return f"`{name}` is a constraint; its reaction{named} is `{force}`".replace("reaction force", "force")
    if name in DEGREES:
        return "degrees follow a number, `30 deg`; symbols and functions have radians"
    if (split := _split(name, scope)) and name not in GREEK.values():
        return f"did you mean `{split}`? Symbols are multiplied with a space or `*` between them"
    near = nearest(name[:MAX_NAME], names)
    if (near is None or near.casefold() != name.casefold()) and (alike := _alike(name, scope)):
        return f"did you mean `{alike}`?"
    if near and len(name) == 1 and near.casefold() != name.casefold():
        # A letter by itself is seldom a misprint: a mass `m` beside a coefficient of friction `mu` is another quantity.
        return f"a quantity of its own goes under `parameters` of the problem file; or did you mean `{near}`?"
    if near:
        return f"did you mean `{near}`?"
    own = (n for n in names if n not in (*RESERVED, *_ENERGIES) and not (n in scope.vectors and _OF_BODIES.match(n)))
    declared = [f"`{n}`" for n in own]
    if len(declared) > MAX_LISTED:
        declared[MAX_LISTED:] = ["..."]
    return f"the declared names are {', '.join(declared)}" if declared else "no symbol is declared here"


def help_for_function(name: str, scope: Scope) -> str:
    """A suggestion for a name before a parenthesis that is neither a function nor a symbol."""
    functions = [*FUNCTIONS, *OPERATIONS, *scope.functions]
    if name in _OTHER_NAMES:
        return f"did you mean `{_OTHER_NAMES[name]}`?"
    if split := _split(name, scope):
        return f"did you mean `{split}(...)`? Symbols are multiplied with a space or `*` between them"
    symbol = nearest(name[:MAX_NAME], scope.names())
    if symbol and symbol.casefold() == name.casefold():
        return f"did you mean `{symbol}`?"
    if near := nearest(name[:MAX_NAME], functions):
        return f"did you mean `{near}`?"
    return f"the functions are {', '.join(functions)}; any other name must be declared"


def _alike(name: str, scope: Scope) -> str:
    """The declared name that looks like this one: l for \\ell, omega for w; with the same index."""
    letter, joint, index = name.partition("_")
    for group in _ALIKE:
        if letter in group:
            for other in group:
                if other != letter and scope.role(other + joint + index) is not Role.UNDECLARED:
                    return other + joint + index
    return ""


def _rate(name: str, scope: Scope) -> str:
    """x' for x_dot, xdot, x_ddot; for a coordinate also for xd and xdd."""
    for suffix, order in _RATES:
        stem = name.removesuffix(suffix).rstrip("_")
        known = scope.scalar(stem) is not None if "o" in suffix else scope.role(stem) is Role.COORDINATE
        if name.endswith(suffix) and known:
            return stem + "'" * order
    return ""


def _differential(name: str, scope: Scope) -> str:
    """d(x) for dx."""
    for operator in ("delta", "d"):
        stem = name.removeprefix(operator)
        if stem != name and scope.role(stem) is Role.COORDINATE:
            return f"{operator}({stem})"
    return ""


def _split(name: str, scope: Scope) -> str:
    """A run of letters as a product of known names, if it is one: `ml` -> m l. The fewest names win."""
    if len(name) > MAX_SPLIT:
        return ""
    names = {*scope.names(), *UNITS}
    best: list[list[str] | None] = [[]]
    for end in range(1, len(name) + 1):
        ways = [
            [*before, name[start:end]]
            for start in range(end)
            if (before := best[start]) is not None and name[start:end] in names
        ]
        best.append(min(ways, key=len) if ways else None)
    factors = best[-1]
    return " ".join(factors) if factors and len(factors) > 1 else ""


class TreeReport:
    """The errors and notes of one text; `notes` are about surprising readings."""

    def __init__(self, fragment: Fragment, scope: Scope) -> None:
        self.fragment = fragment
        self.scope = scope
        self.notes: list[Diagnostic] = []

    def undeclared(self, tree: Name | Call) -> Diagnostic:
        """The error for a name that is not declared."""
        if isinstance(tree, Call):
            name, end = tree.name, tree.name_end
            code, message = (
                "unknown-function",
                f"`{_short(name)}` is neither a function nor a declared symbol",
            )
            help_ = help_for_function(name, self.scope)
        else:
            name, end = tree.text, tree.end
            code, message = "unknown-symbol", f"`{_short(name)}` is not declared"
            if name in OPERATIONS:
                code, message = "no-argument", f"`{name}` has no argument"
            help_ = help_for_symbol(name, self.scope)
        return Diagnostic(code, message, self.fragment.span(tree.start, end), help=help_, about=name)

    def error(self, code: str, message: str, tree: Tree, help_: str) -> ProblemError:
        """An error at the place of a tree."""
        return ProblemError(Diagnostic(code, message, self.fragment.span(tree.start, tree.end), help=help_))

    @contextmanager
    def blaming(self, tree: Tree) -> Iterator[None]:
        """Turn an operation that is refused inside into an error at the place of a tree."""
        try:
            yield
        except TooExpensiveError as refused:
            text = _short(" ".join(self.fragment.text[tree.start : tree.end].split()))
            raise self.error(refused.code, refused.message.format(text), tree, refused.help.format(text)) from None

    def note(self, message: str, tree: Tree, help_: str) -> None:
        """Report once how something was read."""
        if message not in (n.message for n in self.notes):
            span = self.fragment.span(tree.start, tree.end)
            self.notes.append(Diagnostic("read-as", message, span, help=help_, level=Severity.NOTE))


def _short(text: str) -> str:
    return text if len(text) <= 40 else text[:37] + "..."
