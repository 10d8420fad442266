"""The steps of a derivation, in JSON: prose as sentences, equations and conditions as text that can be read back."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING, Any

import sympy as sp

from lagrange.core.symbols import FormSymbol, Wedge
from lagrange.core.vectors import Vector
from lagrange.document.derivation import (
    Block,
    CheckMark,
    Display,
    Emphasis,
    Equation,
    Math,
    Matrices,
    Part,
    Picture,
    Prose,
    Ref,
    Table,
    Task,
)
from lagrange.document.math_writer import TEXT

if TYPE_CHECKING:
    from lagrange.algebra.closed_forms.signs import SignCondition
    from lagrange.mechanics.equilibrium.stability import Stability

Write = Callable[[Any], str]


def condition(c: SignCondition, write: Write) -> str:
    """A condition in the language of problem files: a >= b."""
    return f"{write(c.lhs)} {TEXT.relation(c.relation)} {write(c.rhs)}"


def stability_conditions(s: Stability, write: Write) -> dict[str, Any]:
    """The conditions that go with a verdict; none if it holds for all parameters.

    `stable_where` is a list of conditions, all of which must hold. `unstable_where` is a list of alternatives, each of
    them such a list. A conditional equilibrium is unstable elsewhere; otherwise the second variation does not decide.
    """
    stable: tuple[SignCondition, ...] = ()
    unstable: tuple[tuple[SignCondition, ...], ...] = ()
    match s.verdict.value:
        case "stable":
            stable = s.presupposed
        case "conditional":
            stable = s.conditions
        case "unstable":
            unstable = (s.presupposed,) if s.presupposed else ()
        case _:
            unstable = tuple((c,) for c in s.unstable)
    entries: dict[str, Any] = {"stable_where": [condition(c, write) for c in stable]} if stable else {}
    if unstable:
        entries["unstable_where"] = [[condition(c, write) for c in alternative] for alternative in unstable]
    return entries


def block(block: Block, write: Write) -> dict[str, Any]:
    """A block; a picture says nothing that the words of its step do not say."""
    match block:
        case Prose(parts=parts):
            return {"prose": _sentence(parts, write)}
        case Display(equations=equations, boxed=boxed):
            return {"equations": [_equation(e, write) for e in equations], "result": boxed}
        case Table(header=header, rows=rows):
            cells = [[_sentence((cell,), write) for cell in row] for row in rows]
            return {"table": {"header": [_sentence((h,), write) for h in header], "rows": cells}}
        case Matrices(named=named):
            return {"matrices": {name.name: [[write(e) for e in row] for row in rows] for name, rows in named}}
        case CheckMark(name=name, passed=passed, how=how):
            return {"check": _sentence(name, write), "passed": passed, "how": how}
        case Picture() | Task():
            return {}


def _equation(equation: Equation, write: Write) -> dict[str, Any]:
    """An equation; `text` can be read back; an equation between exterior forms cannot, and its key is `form`."""
    of_forms = any(isinstance(s, sp.Expr) and s.has(Wedge, FormSymbol) for s in equation.sides)
    text = f" {equation.relation} ".join(write(side_as_sum(s)) for s in equation.sides)
    result: dict[str, Any] = {"form" if of_forms else "text": text}
    if equation.label:
        result["label"] = equation.label
    if equation.condition:
        result["condition"] = _sentence(equation.condition, write)
    return result


def side_as_sum(side: Any) -> Any:
    """A side of an equation: vectors as sums."""
    return side.as_sum() if isinstance(side, Vector) else side


def _sentence(parts: Sequence[Part], write: Write) -> str:
    return "".join(_words(parts, write))


def _words(parts: Sequence[Part], write: Write) -> Iterator[str]:
    for part in parts:
        match part:
            case str():
                yield part
            case Math(sides=sides, relation=relation):
                yield f" {relation} ".join(write(side_as_sum(s)) for s in sides)
            case Ref(label=label):
                yield f"[{label}]"
            case Emphasis(word=word):
                yield word
