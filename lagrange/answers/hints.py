"""What is said of a wrong equation, in three degrees of frankness, and never the equation asked for.

    1  it does not follow from the equations of motion
    2  ... ; look at a velocity term of it
    3  ... ; one change makes it right: the sign of the term m*l*sin(theta)

Terms are shown on the side on which they stand in the answer.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from lagrange.answers.conventions import Convention
from lagrange.answers.diagnosis import Diagnosis, Group
from lagrange.answers.dimensions import Mismatch, written
from lagrange.answers.edits import Slip, terms_of
from lagrange.core.symbols import Slots
from lagrange.core.vectors import Vector
from lagrange.document.math_writer import text
from lagrange.document.notation import Notation

FRANKEST = 3
_GROUPS = {
    Group.INERTIA: "a term with an acceleration",
    Group.VELOCITY: "a velocity term",
    Group.FORCE: "a force term, one without velocities and accelerations,",
}
_DIFFERS = {
    Group.INERTIA: "its terms with accelerations differ from those asked for",
    Group.VELOCITY: "its terms with velocities are not right; the others are",
    Group.FORCE: "its terms without velocities are not right; the others are",
}
_WHY = {
    Slip.FUNCTION: "sine and cosine",
    Slip.SMALL_ANGLE: "the angle is not small",
    Slip.EXACT_ANGLE: "",
    Slip.ANGLE: "another angle",
    Slip.COORDINATE: "another coordinate",
    Slip.PARAMETER: "another parameter",
    Slip.DOT: "another time derivative",
}


class Advisor:
    """Words about wrong equations, in the notation of a problem."""

    def __init__(self, slots: Slots) -> None:
        self.notation = Notation(coordinates=slots.coordinates, prescribed=slots.prescribed)

    def hints(
        self,
        why: str,
        change: Diagnosis | None,
        units: Mismatch | None,
        convention: Convention | None,
        sides: Sequence[sp.Expr | Vector],
    ) -> tuple[str, ...]:
        """What is said in each degree; `why` is what is said in any case."""
        vague = ["its terms are not of one dimension" if units else "", self._vague(change)]
        frank = [
            self._units(units) if units else "",
            self._change(change, sides),
            self._convention(convention) if convention else "",
        ]
        return why, *("; ".join(filter(None, [why, *said])) for said in (vague, frank))

    def _vague(self, change: Diagnosis | None) -> str:
        if change is None:
            return ""
        if change.slip is None:
            return _DIFFERS[change.group] if change.group else ""
        group = _GROUPS[change.group] if change.group else "a term"
        return f"{group} is missing" if change.slip is Slip.MISSING else f"look at {group} of it"

    def _change(self, change: Diagnosis | None, sides: Sequence[sp.Expr | Vector]) -> str:
        if change is None:
            return ""
        if change.slip is None:
            return self._vague(change)
        said = self._one_change(change, sides)
        times = f", once it is multiplied by {self._text(change.times)}," if change.times != 1 else ""
        return f"one change{times} makes it right: {said}"

    def _one_change(self, change: Diagnosis, sides: Sequence[sp.Expr | Vector]) -> str:
        term, right = change.term, change.right
        if term is None:
            assert right is not None
            return f"{self._text(right)} is missing on its left side"
        if _is_on_the_right(term, sides):
            term, right = -term, None if right is None else -right
        if right is None:
            return f"the term {self._text(term)} does not belong there"
        if change.slip is Slip.SIGN:
            return f"the sign of the term {self._text(_unsigned(term))}"
        if change.slip is Slip.NUMBER and change.factor is not None:
            return self._number(term, right)
        said = f"{self._text(right)} in place of {self._text(term)}"
        if change.factor is not None:
            return f"{said} ({self._factor(change)})"
        reason = _WHY.get(change.slip, "") if change.slip else ""
        return f"{said} ({reason})" if reason else said

    def _factor(self, change: Diagnosis) -> str:
        factor = change.factor
        assert factor is not None
        if change.slip is Slip.INVERTED:
            root = sp.sqrt(factor)
            return f"{self._text(root)} and not {self._text(1 / root)}"
        above, below = sp.fraction(factor)
        if below == 1:
            return f"a factor {self._text(above)} is missing"
        if above in (1, -1):
            below = above * below
            return f"a factor {self._text(below)} too many" if below.is_number else f"divided by {self._text(below)}"
        return f"a factor {self._text(factor)} is missing"

    def _number(self, term: sp.Expr, right: sp.Expr) -> str:
        """0.33 is not 1/3; 9.81 stands where g is asked for."""
        mine, theirs = abs(term.as_coeff_Mul()[0]), abs(right.as_coeff_Mul()[0])
        letters = sorted(right.free_symbols - term.free_symbols, key=str)
        if letters:
            return f"{_decimal(mine)} stands where {' '.join(map(str, letters))} is asked for"
        return f"{_decimal(mine)} is not {self._text(theirs)}"

    def _units(self, found: Mismatch) -> str:
        first, second = (self._text(_unsigned(term)) for term in (found.term, found.other))
        units = f"{first} is in {written(found.dimension)}, {second} in {written(found.expected)}"
        return f"its terms are not of one dimension: {units}"

    def _convention(self, found: Convention) -> str:
        q = self._text(found.coordinate)
        return f"it would be right if {q} were measured {found.turn.value}: {self._text(found.meant)} for {q}"

    def _text(self, expression: sp.Expr) -> str:
        return text(expression, self.notation)


def _is_on_the_right(term: sp.Expr, sides: Sequence[sp.Expr | Vector]) -> bool:
    """Whether a term of left side − right side stands on the right side."""
    if len(sides) != 2 or not isinstance(sides[1], sp.Expr):
        return False
    return -term in (terms_of(sides[1]) or ())


def _unsigned(term: sp.Expr) -> sp.Expr:
    return -term if term.could_extract_minus_sign() else term


def _decimal(number: sp.Expr) -> str:
    """A number as somebody has written it: 0.33, where it has a short decimal fraction."""
    shown = f"{float(number):.12g}"
    return shown if sp.Rational(shown) == number else str(number)
