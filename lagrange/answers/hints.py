"""Hints about a wrong equation at three levels of detail; the expected equation is never revealed.

    1  it does not follow from the equations of motion
    2  Look at a force term (without velocities and accelerations).
    3  This is the equation for gravity that acts the other way. One change makes it right: the sign of the term m*g.

At most two things are said, the cause and then the place. The cause is the first that applies of: terms of different
dimensions; a wrong model (the first of its table that makes these equations); another way of measuring a coordinate;
what the equation is instead. If gravity or a force that acts the other way makes the same equations as a coordinate
measured the other way, there is no telling which was meant, and both are named. The place is the one term whose change
makes the equation right, with the sign that it has on its side of the answer.

Answers that are right for a coordinate measured in another way: θ from the upward vertical, x to the left.

The answer is rewritten with q = −q*, q* + π, π − q*, q* ± π/2 or ±π/2 − q* for one coordinate q, and compared
again. Only an angle, which occurs in sines and cosines, can be measured from another direction.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from enum import Enum

import sympy as sp

from lagrange.algebra.exact.expression_graph import DivisionByZeroError, UnsupportedError
from lagrange.algebra.exact.prime_field import InadmissibleError
from lagrange.algebra.exact.sampler import NoPointError
from lagrange.answers.diagnosis import Diagnosis, Group
from lagrange.answers.limits import MOST_OPERATIONS_LEFT
from lagrange.answers.models.residues import Residues, follows
from lagrange.answers.models.search import Explanation
from lagrange.answers.slips import Slip, terms_of
from lagrange.answers.verdicts import DOES_NOT_FOLLOW
from lagrange.core.records import record
from lagrange.core.symbols import Slots, prime
from lagrange.core.units import unit_of_dimension
from lagrange.core.vectors import Vector
from lagrange.document.math_writer import text
from lagrange.document.names import Notation
from lagrange.values.dimensions import Mismatch

_GROUPS = {
    Group.INERTIA: "a term with an acceleration",
    Group.VELOCITY: "a velocity term",
    Group.FORCE: "a force term (without velocities and accelerations)",
    Group.MOTION: "the terms with accelerations and velocities",
}
_TERMS = {
    Group.INERTIA: "terms with accelerations",
    Group.VELOCITY: "terms with velocities",
    Group.FORCE: "terms without velocities and accelerations",
    Group.MOTION: "terms with accelerations and with velocities",
}
_DIMENSIONS = "its terms have different dimensions"
_SLIPS = {
    Slip.SIGN: "the sign",
    Slip.FACTOR: "a factor",
    Slip.INVERTED: "a ratio inverted",
    Slip.POWER: "a power",
    Slip.MISSING: "missing",
    Slip.EXTRA: "one too many",
    Slip.FUNCTION: "sine and cosine",
    Slip.SMALL_ANGLE: "a small angle",
    Slip.EXACT_ANGLE: "a small angle",
    Slip.ANGLE: "another angle",
    Slip.COORDINATE: "another coordinate",
    Slip.PARAMETER: "another parameter",
    Slip.DOT: "another time derivative",
    Slip.NUMBER: "a number",
}
_WHY = {s: _SLIPS[s] for s in (Slip.FUNCTION, Slip.ANGLE, Slip.COORDINATE, Slip.PARAMETER, Slip.DOT)}
_WHY |= {Slip.SMALL_ANGLE: "the angle is not small", Slip.EXACT_ANGLE: ""}


_CAUSES = {Slip.MISSING: "{} is missing", Slip.EXTRA: "{} too many", Slip.SIGN: "the sign of {}"}
_SHORT = {
    Group.INERTIA: "a term with an acceleration",
    Group.VELOCITY: "a velocity term",
    Group.FORCE: "a force term",
    Group.MOTION: "the kinetic energy",
}


def cause_of(change: Diagnosis | None) -> str:
    """The kind of mistake that a change mends, in a few words; empty if it is not known."""
    if change is None or change.group is None:
        return ""
    if change.slip is None:
        return f"something in {_TERMS[change.group]}"
    return _CAUSES.get(change.slip, f"{_SLIPS[change.slip]} in {{}}").format(_SHORT[change.group])


class Advisor:
    """Writes hints about wrong equations, in the notation of a problem."""

    def __init__(self, slots: Slots) -> None:
        self.notation = Notation(coordinates=slots.coordinates, prescribed=slots.prescribed)

    def hints(
        self,
        why: str,
        change: Diagnosis | None,
        units: Mismatch | None,
        convention: Convention | None,
        sides: Sequence[sp.Expr | Vector],
        model: Explanation | None = None,
    ) -> tuple[str, ...]:
        """The hint at each level; `why` explains the verdict without a search for the mistake."""
        if differing := self._written_out(sides):
            return why, f"{why}: compare its two sides", differing
        if change is None and units is None and convention is None and model is None:
            return (why,) * 3
        causes = (
            self._units(units) if units else "",
            self._model(model, convention) if model is not None else "",
            self._convention(convention) if convention else "",
            why if why != DOES_NOT_FOLLOW else "",
        )
        place = self._place(change) or (f"look at {model.place}" if model is not None else "")
        first = _DIMENSIONS if units else causes[-1] if not any(causes[:-1]) else ""
        cause = next(filter(None, causes), "")
        second = self._change(change, sides, model is not None) or (causes[1] if units else "")
        return why, _sentences(first, place) or why, _sentences(cause, second) or why

    def _written_out(self, sides: Sequence[sp.Expr | Vector]) -> str:
        """By what the sides of an equation differ if their accelerations cancel: one is meant to be the other, written
        out. A sentence; empty for other equations."""
        if len(sides) != 2:
            return ""
        lhs, rhs = sides
        if isinstance(lhs, Vector) or isinstance(rhs, Vector):
            return ""
        accelerations = {prime(q, 2) for q in self.notation.coordinates}
        if not lhs.free_symbols & rhs.free_symbols & accelerations:
            return ""
        rest = sp.expand(lhs - rhs)
        if rest == 0 or rest.free_symbols & accelerations or sp.count_ops(rest) > MOST_OPERATIONS_LEFT:
            return ""
        shown = self._text(-rest if rest.could_extract_minus_sign() else rest)
        return f"the accelerations on its two sides cancel, and {shown} is left: is the derivative carried out rightly?"

    def _place(self, change: Diagnosis | None) -> str:
        if change is None:
            return ""
        if change.slip is None:
            return self._differing(change)
        group = _GROUPS[change.group] if change.group else "a term"
        return f"{group} is missing" if change.slip is Slip.MISSING else f"look at {group}"

    def _differing(self, change: Diagnosis) -> str:
        """Which terms are not right, if they are of one kind."""
        if change.group is None:
            return ""
        terms = _TERMS[change.group]
        if change.group is Group.VELOCITY and self.notation.prescribed:
            terms = "terms with velocities or derivatives of a given motion"
        if change.group is Group.MOTION:
            return f"what the forces contribute to it is right, and not its {terms}: look at the kinetic energy"
        if change.absent:
            return f"its terms are right, but {terms} are missing"
        return f"something is wrong in its {terms}" + ("" if change.alone else "; the others are right")

    def _change(self, change: Diagnosis | None, sides: Sequence[sp.Expr | Vector], explained: bool) -> str:
        if change is None:
            return ""
        if change.slip is None:
            return "" if explained else self._place(change)
        times = f", once it is multiplied by {self._text(change.times)}," if change.times != 1 else ""
        return f"one change{times} makes it right: {self._one_change(change, sides, explained)}"

    def _one_change(self, change: Diagnosis, sides: Sequence[sp.Expr | Vector], explained: bool) -> str:
        """The change; the term probably intended is named only if no cause has been found."""
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
        exchange = f"{self._text(right)} in place of {self._text(term)}"
        if change.factor is not None:
            return f"{exchange} ({self._factor(change)})"
        reason = _WHY.get(change.slip, "") if change.slip and not explained else ""
        if change.slip is Slip.SMALL_ANGLE and isinstance(right / term, sp.cos):
            reason = f"a factor {self._text(right / term)} is missing"
        return f"{exchange} ({reason})" if reason else exchange

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
        """0.33 is not 1/3; g in place of 9.81."""
        wrong, exact = abs(term.as_coeff_Mul()[0]), abs(right.as_coeff_Mul()[0])
        letters = sorted(right.free_symbols - term.free_symbols, key=str)
        if letters:
            return f"{' '.join(map(str, letters))} in place of {_decimal(wrong)}"
        return f"{_decimal(wrong)} is not {self._text(exact)}"

    def _units(self, mismatch: Mismatch) -> str:
        first, second = (self._text(_unsigned(term)) for term in (mismatch.term, mismatch.other))
        units = (
            f"{first} is in {unit_of_dimension(mismatch.dimension)}, {second} in {unit_of_dimension(mismatch.expected)}"
        )
        return f"{_DIMENSIONS}: {units}"

    def _model(self, model: Explanation, convention: Convention | None) -> str:
        if convention is None:
            return model.sentence
        return f"{model.sentence}, or for {self._text(convention.coordinate)} measured {convention.turn.value}"

    def _convention(self, convention: Convention) -> str:
        q, meant = self._text(convention.coordinate), self._text(convention.meant)
        return f"it would be right if {q} were measured {convention.turn.value}: {meant} for {q}"

    def _text(self, expression: sp.Expr) -> str:
        return text(_with_short_denominator(expression), self.notation)


def _sentences(*parts: str) -> str:
    """The nonempty parts, each as a sentence."""
    return " ".join(f"{part[0].upper()}{part[1:]}." for part in parts if part)


def _with_short_denominator(e: sp.Expr) -> sp.Expr:
    """(u^2 + v^2)^(3/2), where multiplying out has made a sum of two roots of it."""
    if not any(f.is_Pow and _has_roots(f.base) for f in sp.Mul.make_args(e)):
        return e
    above, below = sp.fraction(e)
    return above / sp.factor(below) if sp.count_ops(below) <= MOST_OPERATIONS_LEFT else e


def _has_roots(e: sp.Expr) -> bool:
    return e.is_Add and any(p.exp.is_Rational and not p.exp.is_Integer for p in e.atoms(sp.Pow))


def _is_on_the_right(term: sp.Expr, sides: Sequence[sp.Expr | Vector]) -> bool:
    """Whether a term of left side − right side comes from the right side."""
    if len(sides) != 2 or not isinstance(sides[1], sp.Expr):
        return False
    return -term in (terms_of(sides[1]) or ()) or -term in sp.Add.make_args(sides[1])


def _unsigned(term: sp.Expr) -> sp.Expr:
    return -term if term.could_extract_minus_sign() else term


def _decimal(number: sp.Expr) -> str:
    """A number as it was probably written: 0.33 if it has a short decimal fraction."""
    decimal = f"{float(number):.12g}"
    return decimal if sp.Rational(decimal) == number else str(number)


# Conventions


class Turn(Enum):
    """How a coordinate may have been measured instead."""

    REVERSED = "the other way"
    OPPOSITE = "from the opposite direction"
    SUPPLEMENT = "from the opposite direction, the other way"
    RIGHT_ANGLE = "from the perpendicular direction"
    COMPLEMENT = "from the perpendicular direction, the other way"


@record
class Convention:
    """A coordinate measured differently: the answer's q is `meant` in terms of the problem's q."""

    coordinate: sp.Symbol
    turn: Turn
    meant: sp.Expr


def other_convention(equations: Sequence[sp.Expr], residues: Residues) -> Convention | None:
    """The other way of measuring one coordinate with which all the equations follow; None if there is none."""
    try:
        states = residues.states(equations)
        for convention in _conventions(equations, residues.system.configuration.slots):
            if all(follows(_in_convention(e, convention), states) for e in equations):
                return convention
    except (NoPointError, UnsupportedError, DivisionByZeroError, InadmissibleError):
        pass
    return None


def _conventions(equations: Sequence[sp.Expr], slots: Slots) -> Iterator[Convention]:
    used = set().union(*(e.free_symbols for e in equations))
    waves = set().union(*(w.free_symbols for e in equations for w in e.atoms(sp.sin, sp.cos, sp.tan)))
    for q in sorted(slots.coordinates, key=lambda q: q not in waves):  # a distance is hardly measured the other way
        if not used & {q, prime(q), prime(q, 2)}:
            continue
        yield Convention(q, Turn.REVERSED, -q)
        if q in waves:
            yield Convention(q, Turn.OPPOSITE, q + sp.pi)
            yield Convention(q, Turn.SUPPLEMENT, sp.pi - q)
            for quarter in (sp.pi / 2, -sp.pi / 2):
                yield Convention(q, Turn.RIGHT_ANGLE, q + quarter)
                yield Convention(q, Turn.COMPLEMENT, quarter - q)


def _in_convention(equation: sp.Expr, convention: Convention) -> sp.Expr:
    q = convention.coordinate
    sign = convention.meant.diff(q)
    rule = {q: convention.meant, prime(q): sign * prime(q), prime(q, 2): sign * prime(q, 2)}
    return equation.xreplace(rule)
