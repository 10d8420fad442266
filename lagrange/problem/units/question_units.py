"""Dimensions in the initial state and in questions: what cannot be equal, and what `2 m` means beside a parameter m.

The dimensions of symbols follow from the units of the file and from the places where they are used: a position is a
length, a mass is in kg. A number with a unit has the dimension of its unit. A bare number is not judged, since it may
hide a unit, and neither is a term whose dimension is not known.

Where all the letters of a unit are names of the file, `2 m` may be 2 metres, or twice the mass m. Where only one of
them has the dimension of the other side, that is meant, which a note says. Otherwise the file has to be clearer.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace

import sympy as sp

from lagrange.core.diagnostics import Diagnostic, ProblemError, Span
from lagrange.core.units import Dimension, Unit, si_unit, split_number, unit_of
from lagrange.problem.model import ENERGY, KINETIC_ENERGY, Condition, InitialValue, Measured, Problem, Question
from lagrange.problem.values import known_dimensions
from lagrange.values.limits import LARGEST_COEFFICIENT

Known = Mapping[sp.Symbol, Dimension]
Note = Callable[[Diagnostic], None]
TermWithUnit = tuple[sp.Expr | str, Dimension]


def with_dimensions_compared(problem: Problem, note: Note) -> Problem:
    """The problem, with each `2 m` read as its place demands. Raises ProblemError where two sides cannot be equal."""
    before = () if problem.impact is None else problem.impact.before
    conditions = [c for q in problem.questions for c in q.when]
    stated: list[InitialValue | Condition] = [*problem.initial, *before, *conditions]
    units = [*(p.unit for p in problem.parameters), *(q.unit for q in problem.coordinates)]
    if not (stated or problem.questions) or not (any(s.measured for s in stated) or any(units)):
        return problem
    energy = unit_of("J")
    assert energy is not None
    energies = dict.fromkeys((KINETIC_ENERGY, ENERGY), energy.dimension)
    reader = _Reader({**energies, **known_dimensions(problem)}, note)
    initial = tuple(reader.value(v) for v in problem.initial)
    questions = tuple(reader.question(q) for q in problem.questions)
    impact = problem.impact
    if impact is not None:
        impact = replace(impact, before=tuple(reader.value(v) for v in before))
    if reader.errors:
        raise ProblemError(reader.errors)
    return replace(problem, initial=initial, questions=questions, impact=impact)


class _Reader:
    """Compares the two sides of what is stated; collects what is wrong."""

    def __init__(self, known: Known, note: Note) -> None:
        self.known = known
        self.note = note
        self.errors: list[Diagnostic] = []

    def value(self, stated: InitialValue) -> InitialValue:
        """An initial value."""
        what = f"the value of `{stated.symbol}`"
        value = self._compared(stated.symbol, stated.value, stated.measured, stated.span, what)
        return replace(stated, value=value)

    def question(self, asked: Question) -> Question:
        """The conditions of a question, and the terms of its quantity."""
        self._compared(asked.quantity, sp.S.Zero, None, asked.span, "a term of the quantity")
        return replace(asked, when=tuple(self._condition(c) for c in asked.when))

    def _condition(self, stated: Condition) -> Condition:
        value = self._compared(stated.lhs, stated.rhs, stated.measured, stated.span, "a side of this equation")
        return replace(stated, rhs=value)

    def _compared(self, left: sp.Expr, right: sp.Expr, measured: Measured | None, span: Span, what: str) -> sp.Expr:
        """The right side, in the reading that fits the left."""
        others = [*_terms(left, self.known)]
        if measured is None or not measured.names:
            terms = [*_terms(right, self.known)] if measured is None else [_term(measured)]
            self._report([*others, *terms], span, what)
            return right
        expected = others[0][1] if others else None
        as_product = next((d for _, d in _terms(right, self.known)), None)
        is_product, is_measured = (None if None in (expected, d) else d == expected
                                   for d in (as_product, measured.dimension))  # fmt: skip
        if is_product is False and is_measured is False:
            self._report([*others, _term(measured)], span, what)
            return right
        if is_measured is False or (is_product and is_measured is not True) or len(measured.names) > 1:
            self.note(_read_as(measured, product=True))
            return right
        if is_product is False:
            self.note(_read_as(measured, product=False))
            return measured.number
        self.errors.append(_two_readings(measured))
        return right

    def _report(self, terms: list[TermWithUnit], span: Span, what: str) -> None:
        if terms and (other := next((term for term in terms if term[1] != terms[0][1]), None)) is not None:
            message = f"{what} has the wrong dimension"
            (first, own), (second, differing) = ((_called(e), d) for e, d in (terms[0], other))
            help_ = f"`{first}` is {_in_words(own)}, and `{second}` is {_in_words(differing)}: correct one of them"
            self.errors.append(Diagnostic("unit-mismatch", message, span, help=help_))


def _terms(e: sp.Expr, known: Known) -> Iterator[TermWithUnit]:
    """The terms of a sum whose dimension is known, and what they are called."""
    from lagrange.values.dimensions import dimension

    for term in sp.Add.make_args(e):
        number = term.as_coeff_Mul()[0]
        if term.is_number or not number.is_Rational or abs(number.p) > LARGEST_COEFFICIENT:
            continue
        unit = dimension(term, known)
        if unit is not None:
            yield term, unit


def _called(term: sp.Expr | str) -> str:
    from lagrange.document.math_writer import text

    return term if isinstance(term, str) else text(term)


def _term(measured: Measured) -> TermWithUnit:
    return measured.fragment.text, measured.dimension


def _in_words(dimension: Dimension) -> str:
    unit = si_unit(Unit(sp.S.One, dimension))
    return "a number or an angle" if unit == "1" else f"in {unit}"


def _names(measured: Measured) -> str:
    return ", ".join(f"`{name}`" for name in measured.names)


def _written_as_product(measured: Measured) -> str:
    parts = split_number(measured.fragment.text)
    return measured.fragment.text if parts is None else "*".join((parts[0].strip(), parts[1]))


def _read_as(measured: Measured, *, product: bool) -> Diagnostic:
    """A note: which of two readings was taken."""
    written, names = measured.fragment.text, _names(measured)
    if product:
        message = f"`{written}` is read as a product with {names}, which the file declares, not as a unit"
    else:
        message = f"`{written}` is read as a number with its unit, not as a product with {names}"
    help_ = f"write `{_written_as_product(measured)}` for the product; for a unit give {names} another name"
    return Diagnostic("read-as", message, measured.fragment.whole, help=help_).as_note()


def _two_readings(measured: Measured) -> Diagnostic:
    written, product = measured.fragment.text, _written_as_product(measured)
    message = f"`{written}` may be a number with its unit, or the product `{product}`"
    help_ = f"write `{product}` for the product; for a unit give {_names(measured)} another name"
    return Diagnostic("two-readings", message, measured.fragment.whole, help=help_)
