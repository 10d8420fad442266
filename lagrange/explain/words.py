"""English shared by all parts of a derivation: names as nouns, numbers with their nouns, titles, standing clauses."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.core.units import NO_DIMENSION, split_number, unit_of
from lagrange.document.derivation import Detail, Math, Part, Phrase, Prose, Purpose, listed, math, prose
from lagrange.explain.limits import DECIMALS, DIGITS_AS_STATED, MOST_PARTS_OF_PI
from lagrange.mechanics.constraints.variable_mass import REACTIVE
from lagrange.problem.load_context import SpokenName

if TYPE_CHECKING:
    from lagrange.algebra.closed_forms.signs import SignCondition
    from lagrange.algebra.closed_forms.solution_sets import Branch
    from lagrange.mechanics.questions.results import Substituted
    from lagrange.problem.model import Condition, Measured

NORMAL_FORCES = frozenset({"N", "R"})
"""Letters of a reaction that is not called a tension."""

WITH_VALUES = Phrase("with the given values ", Purpose.GIVEN_VALUES)
"""The start of what the values of the file decide, where the letters leave it open."""


_NUMBERED = re.compile(r"\b([a-z]{3,})(\d+)\b")
_ADJECTIVES = ("left", "right", "middle", "single", "upper", "lower", "inner", "outer", "front", "rear", "one", "other")


def spoken(name: str) -> str:
    """A name of the file in a label: `upper_rod` is upper rod, `no_slip.2` is no slip 2."""
    return name.replace("_", " ").replace(".", " ").strip()


def the(name: str) -> str:
    """A particle or body as a noun: `P1`, but the ball, the left body, and the words that the file gives for it."""
    if isinstance(name, SpokenName) and name.words:
        return _with_article(name.words)
    words = spoken(name)
    if not words.islower() or len(words) == 1:
        return words
    return f"the {words} body" if words in _ADJECTIVES else f"the {words}"


def bare(name: str) -> str:
    """The same without an article, for a list: `upper particle`, `P1`."""
    return name.words if isinstance(name, SpokenName) and name.words else spoken(name)


def introduced(name: str) -> str:
    """The same where it is first mentioned, with the letter of its symbols: the upper particle P1."""
    letter, called = spoken(name), the(name)
    is_letter = isinstance(name, SpokenName) and (len(letter) == 1 or not letter.islower())
    return f"{called} {letter}" if is_letter and called.startswith("the ") and letter not in called.split() else called


def _with_article(words: str) -> str:
    """`the upper particle`, `the T-shaped rod`; but Earth, Foucault's bob, body A, and an article that is there."""
    first, *more = words.split()
    if first.lower() in ("the", "a", "an") and more:
        return " ".join(("the", *more))
    possessive = first.endswith(("'s", "’s"))
    is_label = bool(more) and len(more[-1]) == 1 and more[-1].isupper()
    proper = first[:1].isupper() and "-" not in first and (not more or is_label)
    return words if possessive or proper or (is_label and len(more) == 1) else f"the {words}"


_AFTER_THE_NOUN = frozenset(["below", "above", "beside", "ahead", "behind", "away", "aside", "across", "along", "down"])
_FORCES = frozenset(["drag", "drive", "lift", "load", "pull", "push", "resistance", "thrust"])
"""Names that say themselves that they are forces."""


def qualified(noun: str, name: str) -> str:
    """A noun with the name of the file: `left spring`, but `force P`, `friction below`, and `load` for a force."""
    words = spoken(name)
    first, *_, last = words.split() if " " in words else (words, words)
    if noun in (first, last) or (noun == "force" and last in _FORCES):
        return words
    is_word = words.replace(" ", "").isalpha() and words.islower() and len(words) > 1
    return f"{words} {noun}" if is_word and last not in _AFTER_THE_NOUN else f"{noun} {words}"


def load_called(name: str, kind: str = "force") -> str:
    """An applied force with its article: `the weight`, `the reactive force`, `the wind force`."""
    if name == "weight":
        return "the weight"
    return "the reactive force" if name == REACTIVE else f"the {qualified(kind, name)}"


def friction_called(name: str, among: Collection[str]) -> str:
    """A friction force with its article: `the friction` if it is the only one, otherwise `the friction below`."""
    return "the friction" if len(among) == 1 else f"the friction {spoken(name)}"


_ORDINALS = ("first", "second", "third")


def _component(name: str) -> tuple[str, str]:
    """The name of a vector constraint and the ordinal of one of its components; a plain name and nothing."""
    whole, _, number = name.partition(".")
    is_component = number.isdigit() and 0 < int(number) <= len(_ORDINALS)
    return (whole, _ORDINALS[int(number) - 1]) if is_component else (name, "")


def constraints_called(names: Iterable[str]) -> str:
    """`the rod constraint`, `the upper-rod and first no-slip constraints`, `the plane 1 constraint` for plane1."""
    ordinals: dict[str, list[str]] = {}
    for name in names:
        whole, ordinal = _component(name)
        one = ordinals.setdefault(_NUMBERED.sub(r"\1 \2", re.sub(r" (?=\D)", "-", spoken(whole))), [])
        one += [ordinal] if ordinal else []
    called = [f"{joined(numbers)} {whole}".strip() for whole, numbers in ordinals.items()]
    number = sum(len(numbers) or 1 for numbers in ordinals.values())
    return f"the {joined(called)} {plural(number, 'constraint', 'constraints')}"


def capital(words: str) -> str:
    """The words as the beginning of a sentence."""
    return words[:1].upper() + words[1:]


def joined(words: Iterable[str]) -> str:
    """`a, b and c`."""
    return "".join(str(part) for part in listed(words))


def title_in(title: str, choice: str) -> str:
    """The title of a step in a choice of coordinates: `Equation of motion (choice angle)`."""
    return f"{title} (choice {spoken(choice)})" if choice else title


def suffix_of(choice: str) -> str:
    """The end of a label in a choice of coordinates; nothing in the file's own, whose name is empty."""
    return f"-{choice}" if choice else ""


def brief(block: Prose, short: Prose) -> Prose:
    """A paragraph that is shown at every level of detail, with `short` replacing it at low levels."""
    return replace(block, detail=Detail.BRIEF, short=short.parts)


def plural(number: int, one: str, more: str) -> str:
    """The word for one, or for more."""
    return one if number == 1 else more


def are(members: Collection[object]) -> str:
    """` is ` or ` are `, for as many as there are members."""
    return plural(len(members), " is ", " are ")


_WORDS = ("no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve")


def in_words(number: int, what: str) -> str:
    """`one relation`, `two relations`, `no relation`."""
    word = _WORDS[number] if number < len(_WORDS) else str(number)
    return f"{word} {what}{'s' if number > 1 else ''}"


def counted(number: int, what: str) -> str:
    """`1 coordinate`, `2 coordinates`."""
    return f"{number} {what}{'' if number == 1 else 's'}"


def sign_conditions(conditions: Iterable[SignCondition], last: str = " and ") -> tuple[Part, ...]:
    """`a > b and c ≥ d`."""
    return listed((math(c.lhs, c.rhs, relation=c.relation) for c in conditions), last)


def branch_conditions(b: Branch) -> tuple[Part, ...]:
    """`where b ≤ a`; whether the equilibria of the branch are special or left open."""
    words: list[Part] = [Phrase("where ", Purpose.WHERE), *sign_conditions(b.conditions)] if b.conditions else []
    if b.special:
        words.append("; every such position is then an equilibrium" if words else "in any position")
    if b.left:
        words.append("; not solved in closed form" if words else "not solved in closed form")
    return tuple(words)


def existence_left_open(places: Iterable[tuple[Part, Branch]]) -> Iterator[Prose]:
    """That unsolved equations may have no real solution at all, where that is not known."""
    unsolved = [(place, b) for place, b in places if b.left and not b.occupied]
    if not unsolved:
        return
    yield prose(
        "Any real solution of ", *listed((place for place, _ in unsolved), " or "),
        " is an equilibrium; whether there is one is left open.",
        detail=Detail.BRIEF, purpose=Purpose.EXISTENCE_OPEN,
    )  # fmt: skip


# -- clauses common to d'Alembert's principle and the principle of virtual work ----------------------------------------


def substituting(displacements: Iterable[Part], equation: Part) -> Prose:
    """`Substituting for δx, (13) becomes`."""
    return prose("Substituting for ", *listed(displacements), ", ", equation, " becomes")


def must_vanish(free: Sequence[Part], clauses: Sequence[Part], *, ending: str = "independent") -> Prose:
    """`δθ is arbitrary, so its coefficient must vanish (dividing by m l):`."""
    one = " is arbitrary, so its coefficient must vanish"
    more = f" are {ending}, so the coefficient of each must vanish"
    return prose(*listed(free), plural(len(free), one, more), *in_brackets(clauses), ":")


def in_brackets(clauses: Sequence[Part]) -> tuple[Part, ...]:
    """` (dividing by m l)`; nothing if there are no clauses."""
    return (" (", *clauses, ")") if clauses else ()


def as_stated(condition: Condition) -> Math:
    """A condition of a question; a number with a unit as the file has it: x = 30 ft, 25°, but π/6 for 30°."""
    given = condition.measured
    is_plain = given is not None and given.dimension == NO_DIMENSION
    if given is None or (is_plain and (given.number / sp.pi * MOST_PARTS_OF_PI).is_Integer):
        return math(condition.lhs, in_decimals(condition.rhs))
    return math(condition.lhs, as_given(given, condition.rhs) or condition.rhs)


def as_given(given: Measured, value: sp.Expr | None = None) -> sp.Expr | None:
    """A number with its unit, as the file has it: 0.7 m, 40°; None if its letters may be names.

    value  as which it was read, if that is known
    """
    parts = split_number(given.fragment.text)
    unit = None if parts is None else unit_of(parts[1])
    if (
        (given.names and value != given.number)
        or parts is None
        or unit is None
        or (given.dimension == NO_DIMENSION and not unit.is_angle)
    ):
        return None
    from lagrange.values.quantities import rounded, with_unit

    return with_unit(rounded(given.number / unit.factor, DIGITS_AS_STATED), parts[1].replace("deg", "°"))


def at_start(state: Iterable[Substituted]) -> tuple[Part, ...]:
    """`x = 0.7 m and ẋ = 0`: the state at t = 0."""
    given = ((v.symbol, as_given(v.measured, v.value) if v.measured else None, v.value) for v in state)
    return listed(math(symbol, measured or in_decimals(value)) for symbol, measured, value in given)


def in_decimals(value: sp.Expr) -> sp.Expr:
    """0.7 for 7/10, as the state at t = 0 is usually written; 1/2 and 2/3 as they are."""
    if not isinstance(value, sp.Rational) or value.q % 5 or DECIMALS % value.q:
        return value
    from lagrange.values.quantities import rounded

    return rounded(value, DIGITS_AS_STATED)
