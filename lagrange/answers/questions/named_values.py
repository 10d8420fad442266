"""Values that are stated by name: their labels, chains of them, their units, the verdicts on them.

Verdicts on values that are stated by name: answers to questions, velocities and impulses, amplitudes.

Values with units in answers: v = 5.78 m/s, compression: 7.5 cm, F = 60 N.

Where the parameters of a problem have values, a number is the answer, and its unit belongs to it. It is converted to
SI, in which the derived value is. A letter of the unit may be that of a parameter, as in 2 m beside a mass m: the unit
is meant if it has the dimension of what is asked for.

Labels of values: the names on the left of `h_min = ...`, as they are written.

Chains of values, `v = sqrt(2 a d) = sqrt(2*3*4) = 4.9 m/s`: whether their sides agree.

Sides that contain only parameters are numbers once these have values; without values they are expressions, which must
be equal. A decimal stands for all numbers that round to it.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.algebra.exact.expression_graph import DivisionByZeroError
from lagrange.algebra.exact.zero_test import is_zero
from lagrange.answers.limits import LONGEST_NUMBER_WITH_UNIT, MOST_IN_CHAIN
from lagrange.answers.readings import decimals_in
from lagrange.answers.references import Reference
from lagrange.answers.verdicts import DIVIDES_BY_ZERO, AnswerVerdict, EquationVerdict, Verdict
from lagrange.answers.written.decimals import as_written, numbers_rounding_to
from lagrange.answers.written.notation.numbers import in_one_number, plain_unit
from lagrange.answers.written.reading import tried
from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError
from lagrange.core.symbols import Decimal
from lagrange.core.units import NO_DIMENSION, Dimension, has_unit, split_number, unit_of
from lagrange.core.vectors import Vector
from lagrange.expressions.characters import GREEK, SUBSCRIPTS
from lagrange.expressions.edits import Draft, cut, cuts
from lagrange.expressions.latex_layout import is_latex
from lagrange.expressions.reader import read_value
from lagrange.mechanics.questions.results import Asked
from lagrange.values.dimensions import dimension, dimensions_of_units

Judged = tuple[Verdict, str]
"""A verdict, with its diagnosis or remark."""

WRONG_UNIT = "its unit is not one of what is asked for"

_ORDER = (Verdict.UNREADABLE, Verdict.WRONG, Verdict.UNDECIDED, Verdict.INCOMPLETE, Verdict.TRIVIAL)


def worst(parts: list[EquationVerdict]) -> Verdict:
    """The verdict on all together: the first of these that one of them has, otherwise that they are right."""
    return next((v for v in _ORDER if any(p.verdict is v for p in parts)), Verdict.EQUIVALENT)


def check_each(key: str, stated: Mapping[str, Fragment], judged: Callable[[str, Fragment], Judged]) -> AnswerVerdict:
    """The verdict on all entries of a key; `judged` may raise ProblemError and DivisionByZeroError."""
    parts: list[EquationVerdict] = []
    errors: list[Diagnostic] = []
    for name, fragment in stated.items():
        try:
            verdict, comment = judged(name, fragment)
        except ProblemError as error:
            errors += error.diagnostics
            verdict, comment = Verdict.UNREADABLE, error.diagnostics[0].message if error.diagnostics else ""
        except DivisionByZeroError:
            verdict, comment = Verdict.UNREADABLE, DIVIDES_BY_ZERO
        parts.append(EquationVerdict.of(f"{name}: {fragment.text}", verdict, comment))
    return AnswerVerdict(worst(parts), tuple(parts), unreadable=tuple(errors), name=key)


# Numbers with units


_SIDE = re.compile(r"=(?![=>])|≈|\\approx(?![A-Za-z])")
_SPACES = re.compile(r"\\[,;:! ]|~|\$|\\q?quad(?![A-Za-z])|\\left(?![A-Za-z])|\\right(?![A-Za-z])")
_TEXTS = re.compile(r"\\(?:text|mathrm|mbox|rm|si|unit)\s*\{([^{}]*)\}")
_FRACTION = re.compile(r"\\[dt]?frac\s*\{([^{}]*)\}\s*\{([^{}]*)\}")
_NUMBER = re.compile(r"[-+−]?[0-9]{1,12}\.[0-9]{1,12}")


def text_in_si(fragment: Fragment, asked: Asked, reference: Reference) -> tuple[Fragment, bool]:
    """A text whose last side is a number with a unit, with the number in SI, and whether the unit fits; see `in_si`."""
    return in_si(fragment, _dimensions(asked, reference), reference)


def dimensions_of_value(value: sp.Expr, reference: Reference) -> set[Dimension]:
    """The dimension of a derived value; empty if the file has too few units for it."""
    known = dict.fromkeys(reference.values, NO_DIMENSION) | dimensions_of_units(reference.units)
    found = dimension(value, known)
    return set() if found is None else {found}


def in_si(fragment: Fragment, expected: Collection[Dimension], reference: Reference) -> tuple[Fragment, bool]:
    """A text whose last side is a number with a unit, with the number in SI; the text itself in all other cases.

    Second, whether the unit has one of the dimensions that are expected, which may be none if they are not known.
    """
    if not reference.values:
        return fragment, True
    text = fragment.text
    start = max((m.end() for m in _SIDE.finditer(text)), default=0)
    if len(text) - start > LONGEST_NUMBER_WITH_UNIT:
        return fragment, True
    parts = split_number(_plain(text[start:]))
    unit = unit_of(parts[1]) if parts else None
    if parts is None or unit is None or unit.is_angle:
        return fragment, True
    fits = tuple(sp.Integer(n) for n in unit.dimension) in expected if expected else True
    own = not {*re.findall(r"[A-Za-z]+", parts[1])}.isdisjoint(reference.scope.scalars)
    if own and not (fits and expected) and not _TEXTS.search(text, start):
        return fragment, True  # 2 m is twice a mass
    latex = is_latex(fragment)
    number = f" {in_one_number(parts[0], unit.factor, latex)}"
    draft = Draft(fragment)
    sign = [(m.start(), m.end(), "=") for m in _SIDE.finditer(text) if m.end() == start]  # v ≈ 5.78 m/s
    draft.apply([*sign, (start, len(text), number)])
    return draft.finished(latex=latex), fits


def stated_in_numbers(fragment: Fragment) -> tuple[Fragment, Fragment | None] | None:
    """`v = sqrt(2*a*d) = 5.78 m/s` as v = 5.78 m/s, and v = sqrt(2*a*d); None if the last side is no such number.

    The last of three sides may lack its unit, which in LaTeX is often taken for a word.
    """
    text, latex = fragment.text, is_latex(fragment)
    signs = [*_SIDE.finditer(text)]
    if not signs or len(text) - signs[-1].end() > LONGEST_NUMBER_WITH_UNIT:
        return None
    last = _plain(text[signs[-1].end() :])
    if not has_unit(last) and (len(signs) == 1 or not _NUMBER.fullmatch(last)):
        return None
    number, front = Draft(fragment), Draft(fragment)
    number.apply([(signs[0].start(), signs[-1].end(), "=")])
    front.keep(0, signs[-1].start())
    return number.finished(latex=latex), front.finished(latex=latex) if len(signs) > 1 else None


def _plain(text: str) -> str:
    r"""`9.81\,\text{m/s}^2` as 9.81 m/s^2."""
    text = _SPACES.sub(" ", text).strip().rstrip(".,;").rstrip()
    return plain_unit(_FRACTION.sub(r"\1/\2", text))


def _dimensions(asked: Asked, reference: Reference) -> set[Dimension]:
    """The dimensions of the derived values; none if the file has too few units for them."""
    known = dict.fromkeys(reference.values, NO_DIMENSION)  # a value without a unit is a number
    known |= dimensions_of_units(reference.units)
    values = [v for b in asked.branches for v in b.values if v.free_symbols]
    if asked.has_bare_numbers or not values:  # `y = 1 m` hides a unit of the value; or it was found numerically
        values = [asked.question.quantity]
    return {d for v in values if (d := dimension(v, known)) is not None}


# Labels


_LABEL = re.compile(
    r"[\s$&]*(?!\\?(?:sin|cos|tan)(?![A-Za-z]))(?P<written>\\?(?P<name>[^\W\d_]+)(?:_\{?\s*(?:\\(?:text|mathrm|rm)\s*\{)?\\?(?P<index>\w{1,12})[\s}]*|(?P<digits>\d{1,2}))?)\s*(?:\([^()=]{0,20}\))?\s*&?="
)


_NAME = (
    r"\A(?P<name>[\s$&]*(?:\\?[^\W\d_]\w{0,12}['\u0307\u0308]{0,2}|\\d{1,2}ot\s*(?:\{\s*\\?\w{1,12}\s*\}|\\?\w{1,12})))"
)
_AT_A_PLACE = re.compile(
    rf"{_NAME}\s*(?:\\left\s*)?"
    r"(?:\(\s*\\?\w{1,12}\s*=\s*[^()=]{1,16}\)|\|?\s*_\s*\{\s*\\?\w{1,12}\s*=\s*[^{}=]{1,16}\})(?=\s*&?=(?!=))"
)


_AT_A_PARAMETER = re.compile(
    r"\A(?P<name>[\s$&]*(?:\\dot\s*\{?\s*)?\\?[^\W\d_]\w{0,12}\}?['\u0307]?)\s*\(\s*(?P<place>\w{1,12})\s*\)(?=\s*&?=(?!=))"
)
_EXTREME_RATE = re.compile(
    r"\A(?P<name>[\s$&]*(?:\\dot\s*(?:\{\s*\\?\w+\s*\}|\\?\w)|[^\W\d_]\w{0,12}?'))\s*_\{?\s*\\?(?:(?:text|mathrm)\s*\{\s*)?(?:max|min)"
    r"(?:\s*\})*(?=\s*&?=(?!=))"
)


def without_place(fragment: Fragment, parameters: Collection[str] = ()) -> Fragment:
    """`N(θ=0) = ...` as N = ..., `v(h) = ...` as v = ..., `x'_max` as x': place and time are those of a question."""
    draft = Draft(fragment)
    changed = draft.replace(_AT_A_PLACE, lambda m: m["name"])
    changed = draft.replace(_AT_A_PARAMETER, lambda m: m["name"] if m["place"] in parameters else None) or changed
    changed = draft.replace(_EXTREME_RATE, lambda m: m["name"]) or changed
    return draft.finished(latex=is_latex(fragment)) if changed else fragment


_AT_A_VALUE = re.compile(
    rf"{_NAME}\s*(?:\\left\s*)?"
    r"\(\s*(?P<value>0|\\?(?:pi|π)(?:\s*/\s*[1-9])?|-?[1-9])\s*(?:\\right\s*)?\)"
    r"(?=\s*&?=(?!=))"
)


def at_a_value(fragment: Fragment) -> tuple[Fragment, sp.Expr] | None:
    """`N(0) = ...` as N = ..., and the 0, which is the place; None if a line has no such label."""
    match = _AT_A_VALUE.match(fragment.text)
    if match is None:
        return None
    whole, _, part = match["value"].replace("π", "pi").lstrip("\\").partition("/")
    value = (sp.pi if whole.strip() == "pi" else sp.Integer(whole)) / sp.Integer(part.strip() or 1)
    draft = Draft(fragment)
    draft.replace(_AT_A_VALUE, lambda m: m["name"])
    return draft.finished(latex=is_latex(fragment)), value


def label_of(fragment: Fragment) -> str:
    """The name on the left, spelled out: `theta_max` of `\\theta_{\\max} = ...`; empty if there is none."""
    match = _LABEL.match(fragment.text)
    if match is None:
        return ""
    name = "".join(GREEK.get(c, c) for c in match["name"])
    index = "".join(SUBSCRIPTS.get(c, c) for c in match["index"] or match["digits"] or "")
    return f"{name}_{index}" if index else name


def written_label(fragment: Fragment) -> str:
    """The name on the left as it is written; empty if there is none."""
    match = _LABEL.match(fragment.text)
    return match["written"].strip() if match else ""


def is_used_beside(fragment: Fragment, answer: Sequence[Fragment], reference: Reference) -> bool:
    """Whether the label of a line is no name of the problem and occurs in another line, which it then defines."""
    match = _LABEL.match(_SQUARE.sub(r"\1", fragment.text))
    if match is None or label_of(fragment) in reference.declared or match["name"] in reference.declared:
        return False
    start = fragment.span(0, len(fragment.text)).start
    if _DEFINES.search(fragment.whole.source.text[max(0, start - 30) : start]):
        return True
    name = match["written"].strip()
    written = re.escape(name)
    before = (
        "" if name[:1] in GREEK or name[:1] == "\\" else r"(?<![A-Za-z_\\])(?<![A-Za-z_][0-9])"
    )  # of Rω, ω is a factor
    used = re.compile(rf"{before}{written}(?![A-Za-z0-9_{{])")
    rate = re.compile(rf"(?<![A-Za-z\\])d\s?{written}\s*(?:/|\}}\s*\{{)\s*d|\\dot\s*\{{?\s*{written}(?![A-Za-z0-9_])")
    others = (f.text for f in answer if f is not fragment and not rate.search(f.text))  # of dv/dt, v is the velocity
    return any(used.search(re.sub(r"\A[^=]*=", "", text)) for text in others)


_SQUARE = re.compile(r"\A([^=]{1,30}?)(?:\^\s*\{?\s*2\s*\}?|²)(?=\s*&?=)")
_DEFINES = re.compile(
    r"\b(?:let|where|with|set|put|define|writing|wobei|mit|sei|avec|où|soit)(?:\s|[$}:,&\\]|\\[,;:! ])*\Z",
    re.IGNORECASE,
)
"""What says that a name is defined: `where w^2 = g/l`."""


# Chains


_SIGN = re.compile(r"(?<![<>!=:])==?(?![=>])|≈|\\approx(?![A-Za-z])")
NOT_EQUAL = "its sides are not equal to one another"


def sides_agree(fragment: Fragment, reference: Reference, asked: Collection[sp.Symbol] = ()) -> bool | None:
    """Whether the sides of a chain that are values agree; None if there are not two of them, or it is not known.

    asked  parameters in which the chain is an equation, `m g h = 2 m g R + m v^2/2 = 5/2 m g R`, and no value
    """
    places = cuts(fragment.text, _SIGN)
    if not 2 < len(places) <= MOST_IN_CHAIN:
        return None
    scope, parameters = replace(reference.scope, decimals=""), {*reference.parameters.values()}
    values: list[sp.Expr] = []
    for place in places:
        try:
            value = tried(cut(fragment, *place), scope, lambda f: read_value(f, scope, [], latex=True))
        except ProblemError:
            continue
        if not isinstance(value, Vector) and as_written(value).free_symbols <= parameters and not _is_name(value):
            if not value.free_symbols.isdisjoint(asked):
                continue
            values.append(value.xreplace(dict(reference.values)))
    agree = [_same(a, values[-1]) for a in values[:-1]]
    return None if not agree or None in agree else all(agree)


def _is_name(value: sp.Expr) -> bool:
    return isinstance(value, sp.Symbol) and not isinstance(value, Decimal)


def _same(a: sp.Expr, b: sp.Expr) -> bool | None:
    if decimals_in([a, b]) and numbers_rounding_to([a - b]) is not None:
        return True
    try:
        return is_zero(as_written(a - b))
    except DivisionByZeroError:
        return None
