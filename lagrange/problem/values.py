"""Values of parameters: numbers with units, converted to units of SI; on the command line, `--set l=30cm`.

A value's own unit must have the dimension of the `unit` stated apart from it, and the dimension that its parameter has
in the problem: a mass is in kg, a position in m, a force in N. That dimension follows from the places where the
parameter is used, as far as these determine it.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, assert_never

import sympy as sp

from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError, Severity, Span, suggestion
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import Bounded, Sign, prime
from lagrange.core.units import NO_DIMENSION, Dimension, Unit, near_unit, si_unit, split_number, unit_called, unit_of
from lagrange.core.vectors import Vector
from lagrange.expressions.reader import Scope, canonical_name, read_scalar
from lagrange.problem.keys import Assumption
from lagrange.problem.limits import LONGEST_PLACE
from lagrange.problem.model import (
    AppliedForce,
    AppliedMoment,
    Belt,
    Coordinate,
    Damper,
    Friction,
    GeneralizedForce,
    Measured,
    Parameter,
    Potential,
    Problem,
    Range,
    Spring,
)
from lagrange.problem.sections import items_of, scalar_of
from lagrange.problem.yaml.nodes import Node, Scalar

if TYPE_CHECKING:
    from lagrange.values.quantities import Values

IN_WORDS = {
    Assumption.POSITIVE: "positive",
    Assumption.NONNEGATIVE: "not negative",
    Assumption.SIGN: "a sign, +1 or -1",
    Assumption.ACUTE: "an acute angle",
}


@record
class ValueRead:
    """A value in SI units, its unit there, and where it stands. `measured`: whether the file gives it a unit."""

    number: sp.Expr
    unit: str
    span: Span
    measured: bool


def read_number_with_unit(
    fragment: Fragment, stated: Fragment | None, symbol: sp.Symbol, assume: Assumption | None
) -> ValueRead:
    """`30 cm`, or 30 with the unit `stated` apart. The value's own unit must have the dimension of the one stated.

    symbol, assume  the parameter, and what is assumed of it (None: it could not be read), with which the value agrees
    """
    read = _measured(fragment, stated)
    if assume is not None:
        _check_assumption(read.number, symbol, assume, fragment)
    return read


def with_value(parameter: Parameter, read: ValueRead) -> Parameter:
    """The parameter with a value; an angle of 30 deg is acute, unless the file says what is assumed."""
    unit = unit_of(read.unit)
    is_angle = read.measured and unit is not None and unit.is_angle and unit.dimension == NO_DIMENSION
    if is_angle and not parameter.is_stated and read.number > 0 and read.number < sp.pi / 2:
        symbol = parameter_symbol(parameter.symbol.name, Assumption.ACUTE)
        parameter = replace(parameter, symbol=symbol, assume=Assumption.ACUTE)
    return replace(parameter, unit=read.unit, value=read.number, value_span=read.span, measured=read.measured)


def without_value(parameter: Parameter) -> Parameter:
    """The parameter as the file assumes it to be, whatever its value."""
    if parameter.is_stated or parameter.assume is Assumption.POSITIVE:
        return parameter
    symbol = parameter_symbol(parameter.symbol.name, Assumption.POSITIVE)
    return replace(parameter, symbol=symbol, assume=Assumption.POSITIVE)


def parameter_symbol(name: str, assume: Assumption) -> sp.Symbol:
    """The symbol of a parameter under its assumption."""
    match assume:
        case Assumption.POSITIVE:
            return sp.Symbol(name, positive=True)
        case Assumption.NONNEGATIVE:
            return sp.Symbol(name, nonnegative=True)
        case Assumption.REAL:
            return sp.Symbol(name, real=True)
        case Assumption.SIGN:
            return Sign(name)
        case Assumption.ACUTE:
            return Bounded(name, sp.S.Zero, sp.pi / 2, (True, True))


def _measured(fragment: Fragment, stated: Fragment | None) -> ValueRead:
    parts = split_number(fragment.text)
    if parts is None:
        number = _number(fragment, fragment.text)
        if stated is None:
            return ValueRead(number, "", fragment.whole, False)
        unit, text = _known_unit(stated), stated.text
    else:
        text = parts[1]
        unit = _known_unit(replace(fragment, text=text))
        number = _number(fragment, parts[0])
        expected = unit if stated is None else _known_unit(stated)
        if stated is not None and unit.dimension != expected.dimension:
            message = f"`{text}` does not fit the unit `{stated.text}`"
            help_ = f"one is {si_unit(unit)} in SI units, the other {si_unit(expected)}"
            help_ += _weight_for_mass(unit, expected)
            raise ProblemError(Diagnostic("unit-mismatch", message, fragment.whole, help=help_))
    return ValueRead(number * unit.factor, text if unit.factor == 1 else si_unit(unit), fragment.whole, True)


def _weight_for_mass(given: Unit | None, expected: Unit) -> str:
    """What to do where a mass is given as a weight, 12 lb."""
    kilogram, newton = unit_of("kg"), unit_of("N")
    assert kilogram is not None
    assert newton is not None
    if given is None or (given.dimension, expected.dimension) != (newton.dimension, kilogram.dimension):
        return ""
    return "; `lb` is a force: declare the weight, `W: 12 lb`, and write `mass: W/g`, or give the mass in `slug`"


def _known_unit(fragment: Fragment) -> Unit:
    unit = unit_of(fragment.text)
    if unit is None:
        message, near = f"`{fragment.text}` is not a known unit", near_unit(fragment.text)
        help_ = f"did you mean `{near}`? Units" if near else "units"
        help_ += " are products of `kg`, `m`, `s`, `N`, `deg`, `rpm`, `ft`, `lb` and the like: `kg m^2/s`, `J/(kg K)`"
        raise ProblemError(Diagnostic("unknown-unit", message, fragment.whole, help=help_))
    return unit


def _number(fragment: Fragment, text: str) -> sp.Expr:
    """The number that a part of a fragment says, exactly: 9.81, 2/3, 2*pi."""
    help_ = "write a number such as `9.81`, `1e-3`, `2/3` or `2*pi`, and its unit after it: `30 cm`"
    try:
        part = fragment if text == fragment.text else replace(fragment, text=text, start=None)
        number = read_scalar(part, Scope())
    except ProblemError as error:
        if error.diagnostics[0].code not in _NO_NUMBER:
            raise
        number = None
    if number is None or not number.is_number or not (number.is_Rational or number.is_real):
        message = f"`{fragment.text}` is not a number"
        raise ProblemError(Diagnostic("not-a-number", message, fragment.whole, help=help_))
    return number


def _check_assumption(number: sp.Expr, symbol: sp.Symbol, assume: Assumption, fragment: Fragment) -> None:
    """Raises ProblemError if a value contradicts the assumption, or lies outside the range."""
    wrong = {
        Assumption.POSITIVE: not number.is_positive,
        Assumption.NONNEGATIVE: number.is_negative,
        Assumption.REAL: False,
        Assumption.SIGN: number not in (1, -1),
        Assumption.ACUTE: not (number > 0 and number < sp.pi / 2),
    }
    if wrong[assume]:
        message = f"the value {fragment.text} contradicts the assumption that the parameter is {IN_WORDS[assume]}"
        help_ = f"change the value, or say `assume: {'nonnegative' if number == 0 else 'real'}`"
        raise ProblemError(Diagnostic("value-against-assumption", message, fragment.whole, help=help_))
    if isinstance(symbol, Bounded) and (number < symbol.low or number > symbol.high):
        message = f"the value {fragment.text} is not in the range of the parameter"
        help_ = "change the value, or the range"
        raise ProblemError(Diagnostic("value-against-assumption", message, fragment.whole, help=help_))


def measured_in(fragment: Fragment, scope: Scope) -> Measured | None:
    """`30 deg` or `2.5 m/s`, where an expression may occur, in SI units; None if the text is not of this form."""
    parts = split_number(fragment.text)
    if parts is None or (unit := unit_of(parts[1])) is None or split_number(parts[0]) is not None:
        return None
    letters = tuple(dict.fromkeys(re.findall(r"[^\W\d_]+", parts[1])))
    is_product = all(name in scope.names() for name in letters)
    if is_product and "*" in fragment.text:
        return None
    return Measured(_measured(fragment, None).number, unit.dimension, fragment, letters if is_product else ())


# -- ranges ------------------------------------------------------------------------------------------------------------


def read_range(node: Node, name: str, unit: str, scope: Scope) -> Range:
    """Two ends, each a number with a unit, or an expression in the scope. Raises ProblemError."""
    items = items_of(node, f"the range of `{name}`", f"{name}: {{range: [0, 1]}}")
    help_ = "write the least and the greatest value, `range: [0, 60 deg]`"
    if len(items) != 2:
        message = f"the range of `{name}` has two ends, not {len(items)}"
        raise ProblemError(Diagnostic("bad-range", message, node.span, help=help_))
    low, high = (_end(scalar_of(item, "an end of a range"), unit, scope) for item in items)
    if (high - low).is_number and not high > low:
        message = f"the range of `{name}` is empty"
        raise ProblemError(Diagnostic("bad-range", message, node.span, help=help_))
    return Range(low, high)


def _end(scalar: Scalar, unit: str, scope: Scope) -> sp.Expr:
    fragment = scalar.fragment
    stated = Fragment(unit, fragment.whole) if unit and unit_of(unit) else None
    if split_number(fragment.text) is not None and not _is_product(fragment.text, scope):
        try:
            return _measured(fragment, stated).number
        except ProblemError as error:
            first = error.diagnostics[0]
            if first.code != "unknown-unit":
                raise
            cure = f"{first.help}; the name of a parameter is declared under `parameters`"
            raise ProblemError(replace(first, help=cure)) from error
    value = read_scalar(fragment, scope)
    if value.is_number and stated is not None:
        return _measured(fragment, stated).number
    return value


def _is_product(text: str, scope: Scope) -> bool:
    """Whether what follows a number is an expression in declared names, `2*l`, and no unit: `2 m` is two metres."""
    if (parts := split_number(text)) is None:
        return False
    known = [name in scope.names() for name in re.findall(r"[^\W\d]\w*", parts[1])]
    return any(known) if unit_of(parts[1]) is None else all(known) and "*" in text


def bounded_symbol(name: str, within: Range, assume: Assumption, span: Span) -> sp.Symbol:
    """The parameter with a range, and what is assumed besides."""
    low, high, strict = within.low, within.high, [False, False]
    least = {Assumption.POSITIVE: 0, Assumption.NONNEGATIVE: 0, Assumption.ACUTE: 0}.get(assume)
    if least is not None and low <= 0:
        low, strict[0] = sp.S.Zero, assume is not Assumption.NONNEGATIVE
    if assume is Assumption.ACUTE and high >= sp.pi / 2:
        high, strict[1] = sp.pi / 2, True
    if assume is Assumption.SIGN or not high > low:
        message = f"the range of `{name}` contradicts that it is {IN_WORDS[assume]}"
        raise ProblemError(Diagnostic("bad-range", message, span, help="change the range, or leave `assume` out"))
    return Bounded(name, low, high, (strict[0], strict[1]))


_NO_NUMBER = ("unknown-symbol", "unknown-function", "unexpected-character", "missing-operator", "vector-for-scalar")
"""Errors of a text that was not meant as an expression: `12:30`, `~`, `3 m`."""


def values_of(problem: Problem) -> Values | None:
    """The values of a problem; None if it has none, so that nothing is loaded for them."""
    numbers = problem.given_values
    return None if not numbers else _values(problem, numbers)


def units_of(problem: Problem) -> dict[sp.Symbol, str]:
    """The units of parameters and coordinates that a file gives, and those that follow where it has values."""
    known = values_of(problem)
    inferred = {} if known is None else {s: u for s, d in known.units.items() if (u := unit_called(d))}
    declared = {p.symbol: p.unit for p in problem.parameters if p.unit}
    return inferred | declared | {q.symbol: q.unit for q in problem.coordinates if q.unit}


def no_values(problem: Problem) -> Values:
    """The values of a problem without any, for conditions that have no parameters."""
    return _values(problem, {})


def _values(problem: Problem, numbers: Mapping[sp.Symbol, sp.Expr]) -> Values:
    from lagrange.values.dimensions import dimension
    from lagrange.values.quantities import Values

    known = _all_known(problem)
    coordinates = {*problem.slots.coordinates}.union(*(c.coordinates for c in problem.choices))
    angles = {q for q in coordinates if known.get(q) == NO_DIMENSION}
    angles |= {p.symbol for p in problem.parameters if (unit := unit_of(p.unit)) is not None and unit.is_angle}
    of_speeds = {u: dimension(u.definition, known) for u in problem.speeds}
    rates = {prime(q) for q in angles}
    angles |= {u.symbol for u in problem.speeds if u.definition in rates}
    known = {**{u.symbol: d for u, d in of_speeds.items() if d is not None}, **known}
    return Values(numbers, frozenset(p.symbol for p in problem.parameters), known, frozenset(angles))


# -- the command line --------------------------------------------------------------------------------------------------


def with_settings(
    parameters: Sequence[Parameter], coordinates: Sequence[Coordinate], settings: Sequence[Fragment]
) -> tuple[Parameter, ...]:
    """The parameters with the values that `NAME=VALUE` gives them; of two for one name the later counts.

    Raises ProblemError with everything that is wrong with the settings.
    """
    by_name = {p.symbol.name: p for p in parameters}
    errors: list[Diagnostic] = []
    for setting in settings:
        try:
            name, value = _setting(setting, by_name, [q.symbol.name for q in coordinates])
            p = by_name[name]
            unit = p.unit if split_number(value.text) else p.stated_unit  # a bare number is in the file's unit
            stated = Fragment(unit, setting.whole) if unit and unit_of(unit) else None
            p = without_value(p)
            read = read_number_with_unit(value, stated, p.symbol, p.assume)
            by_name[name] = with_value(p, replace(read, unit=read.unit or p.unit))
        except ProblemError as error:
            errors += error.diagnostics
    if errors:
        raise ProblemError(errors)
    return tuple(by_name.values())


def _setting(setting: Fragment, known: Mapping[str, Parameter], coordinates: Sequence[str]) -> tuple[str, Fragment]:
    """The name and the text of the value."""
    written, equals, value = setting.text.partition("=")
    help_ = "write the name of a parameter and its value: `--set l=0.3`, `--set 'l=30 cm'`"
    if not equals or not written.strip() or not value.strip():
        raise ProblemError(
            Diagnostic("bad-setting", f"`{setting.text}` does not give a value", setting.whole, help=help_)
        )
    name = canonical_name(written) or written.strip()
    at = len(setting.text) - len(value.lstrip())
    text = value.strip()
    if name not in known:
        what = "a coordinate, not a parameter," if name in coordinates else "not a parameter"
        message = f"`{name}` is {what} of this problem".replace(", of", " of")
        help_ = suggestion(name, list(known), "parameters")
        raise ProblemError(Diagnostic("unknown-parameter", message, setting.span(0, len(written)), help=help_))
    return name, Fragment(text, setting.span(at, at + len(text)), at)


# -- the dimensions that the problem needs -----------------------------------------------------------------------------


def _dimension(unit: str) -> Dimension:
    known = unit_of(unit)
    return NO_DIMENSION if known is None else known.dimension


def check_dimensions(problem: Problem) -> None:
    """Raises ProblemError if the unit of a value does not fit the place of its parameter in the problem."""
    measured = [p for p in problem.parameters if p.measured and p.value_span is not None]
    if not measured:
        return
    from lagrange.values.dimensions import dimensions_needed

    stated = [(e, _dimension(unit)) for e, unit in _places(problem) if count_operations(e) <= LONGEST_PLACE]
    if dimensions_needed(stated, _known(problem)) is not None:
        return
    for p in measured:
        needed = dimensions_needed(stated, _known(problem, p.symbol))
        if needed is None or p.symbol not in needed:
            continue
        expected = si_unit(Unit(sp.S.One, needed[p.symbol]))
        if expected == "1":
            expected = "a number or an angle"
        message = f"the unit of `{p.symbol}` does not fit its place in the problem"
        given = unit_of(p.unit)
        help_ = f"`{p.symbol}` has to be {expected} in SI units, but this is {si_unit(given) if given else p.unit}"
        help_ += _weight_for_mass(given, Unit(sp.S.One, needed[p.symbol]))
        raise ProblemError(Diagnostic("unit-mismatch", message, p.value_span, help=help_))


def note_inertia(problem: Problem, report: Callable[[Diagnostic], None]) -> None:
    """A note where a moment of inertia is no mass times the square of a length: m l/12, m l^3/12."""
    composed = [b for b in problem.bodies if any(not moment.is_number and not moment.is_Symbol for moment in b.inertia)]
    if not composed:
        return
    from lagrange.values.dimensions import dimensions_needed

    known = _known(problem)
    for body in composed:
        angles = ((a, "1") for a in (body.angle, *body.angles) if a is not None)
        size = [(body.mass, "kg"), *_components(body.position, "m"), *angles]
        moments = [(moment, "kg m^2") for moment in body.inertia if count_operations(moment) <= LONGEST_PLACE]
        stated = [[(e, _dimension(unit)) for e, unit in places] for places in (size, [*size, *moments])]
        without, whole = (dimensions_needed(places, known) for places in stated)
        if without is not None and whole is None:
            message = (
                f"the moment of inertia of `{body.name}` does not have the dimension of a mass times a length squared"
            )
            help_ = "check its formula: that of a rod of length l is m*l^2/12, of a disc m*R^2/2"
            report(Diagnostic("inertia-dimension", message, body.span, help=help_, level=Severity.NOTE))


def _known(problem: Problem, but: sp.Symbol | None = None) -> dict[sp.Symbol, Dimension]:
    """The dimensions of the symbols whose unit the file gives."""
    units = {p.symbol: p.unit for p in problem.parameters} | {q.symbol: q.unit for q in problem.coordinates}
    known = {s: unit.dimension for s, text in units.items() if text and (unit := unit_of(text)) is not None}
    return {symbol: dimension for symbol, dimension in known.items() if symbol != but}


def _all_known(problem: Problem) -> dict[sp.Symbol, Dimension]:
    """The dimensions that the units of the file give, and those that other symbols then need in their places."""
    return known_dimensions(problem) if _known(problem) else {}


def known_dimensions(problem: Problem) -> dict[sp.Symbol, Dimension]:
    """The same, also where the file gives no units: a position is a length, the argument of a sine an angle."""
    from lagrange.values.dimensions import dimensions_needed

    known = _known(problem)
    places = [(e, _dimension(unit)) for e, unit in _places(problem) if count_operations(e) <= LONGEST_PLACE]
    waves = {w.args[0] for e, _ in places for w in e.atoms(sp.sin, sp.cos, sp.tan)}
    angles = {angle: NO_DIMENSION for angle in waves if angle.is_Symbol and angle not in known}
    return {**(dimensions_needed(places, {**angles, **known}) or {}), **angles, **known}


def _places(problem: Problem) -> Iterator[tuple[sp.Expr, str]]:
    """Expressions, each with the unit of SI of what it stands for."""
    for body in problem.masses:
        yield body.mass, "kg"
        yield from _components(body.position, "m")
    for particle in problem.particles:
        yield from _components(particle.exchange.velocity if particle.exchange is not None else None, "m/s")
    for body in problem.bodies:
        yield from ((moment, "kg m^2") for moment in (*body.inertia, *body.products) if moment != 0)
        yield from ((angle, "1") for angle in (body.angle, *body.angles) if angle is not None)
    yield from _components(problem.gravity, "m/s^2")
    sides = [(c.lhs, c.rhs) for c in problem.constraints]
    for choice in problem.choices:
        sides += [*(choice.substitute or {}).items()]
    yield from ((left / right, "1") for left, right in sides if not left.is_number and not right.is_number)
    for f in problem.forces:
        match f:
            case AppliedForce():
                yield from _components(f.vector, "N")
                yield from _components(f.at, "m")
            case AppliedMoment():
                yield from _components(f.moment, "N m")
            case Spring():
                yield f.stiffness, "N/m"
                yield f.length, "m"
                yield from (place for end in f.ends for place in _components(end, "m"))
            case Damper():
                yield f.coefficient, "N s/m"
            case Potential():
                yield f.energy, "N m"
            case GeneralizedForce():
                pass  # its unit is that of an energy divided by the coordinate's
            case Friction():
                yield from ((e, "1") for e in (f.coefficient, f.static) if e is not None)
                yield from _components(f.surface_velocity, "m/s")
            case Belt():
                yield from ((f.coefficient, "1"), (f.angle, "1"), (f.tight, "N"), (f.slack, "N"))
            case unreachable:
                assert_never(unreachable)
    if problem.impact is not None:
        yield from ((e, "1") for e in problem.impact.restitution.values())
        for blow in problem.impact.impulses:
            strength, unit = (blow.vector, "N s") if isinstance(blow, AppliedForce) else (blow.moment, "N m s")
            yield from _components(strength, unit)
            yield from _components(blow.at if isinstance(blow, AppliedForce) else None, "m")


def _components(vector: Vector | None, unit: str) -> Iterator[tuple[sp.Expr, str]]:
    if vector is not None:
        yield from ((c, unit) for c in vector.components if c != 0)
