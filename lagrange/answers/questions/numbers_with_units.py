"""Values with units in answers: v = 5.78 m/s, compression: 7.5 cm, F = 60 N.

Where the parameters of a problem have values, a number is the answer, and its unit belongs to it. It is converted to
SI, in which the derived value is. A letter of the unit may be that of a parameter, as in 2 m beside a mass m: the unit
is meant if it has the dimension of what is asked for.
"""

from __future__ import annotations

import re

import sympy as sp

from lagrange.answers.limits import LONGEST_NUMBER_WITH_UNIT
from lagrange.answers.references import Reference
from lagrange.answers.written.notation.units import in_one_number, plain_unit
from lagrange.core.diagnostics import Fragment
from lagrange.core.units import NO_DIMENSION, Dimension, has_unit, split_number, unit_of
from lagrange.expressions.edits import Draft
from lagrange.expressions.latex_layout import is_latex
from lagrange.mechanics.questions.results import Asked
from lagrange.values.dimensions import dimension, dimensions_of_units

_SIDE = re.compile(r"=(?![=>])|≈|\\approx(?![A-Za-z])")
_SPACES = re.compile(r"\\[,;:! ]|~|\$|\\q?quad(?![A-Za-z])|\\left(?![A-Za-z])|\\right(?![A-Za-z])")
_TEXTS = re.compile(r"\\(?:text|mathrm|mbox|rm|si|unit)\s*\{([^{}]*)\}")
_FRACTION = re.compile(r"\\[dt]?frac\s*\{([^{}]*)\}\s*\{([^{}]*)\}")
_NUMBER = re.compile(r"[-+−]?[0-9]{1,12}\.[0-9]{1,12}")


def text_in_si(fragment: Fragment, asked: Asked, reference: Reference) -> tuple[Fragment, bool]:
    """A text whose last side is a number with a unit, with the number in SI; the text itself in all other cases.

    Second, whether the unit has the dimension of what is asked for, as far as that is known.
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
    expected = _dimensions(asked, reference)
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
    """`v = sqrt(2*a*d) = 5.78 m/s` as v = 5.78 m/s, and v = sqrt(2*a*d); None where the last side is no such number.

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
    """The dimensions of the derived values; none where the file has too few units for them."""
    known = dict.fromkeys(reference.values, NO_DIMENSION)  # a value without a unit is a number
    known |= dimensions_of_units(reference.units)
    values = [v for b in asked.branches for v in b.values if v.free_symbols]
    if asked.has_bare_numbers or not values:  # `y = 1 m` hides a unit of the value; or it was found numerically
        values = [asked.question.quantity]
    return {d for v in values if (d := dimension(v, known)) is not None}
