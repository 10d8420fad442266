"""Reading the initial state, the questions, and an impact.

    initial: {theta: 0, theta': 0}
    ask:
      leaves: {quantity: theta, when: "N = 0"}
      force:  {quantity: N, by: theta}

The state at t = 0 is given by expressions in parameters; a coordinate or velocity that is omitted is free. A question
asks for a quantity at the state in which its `when` holds, or as a function of one coordinate or of t (`by`). Both may
contain coordinates of the file and of its choices, velocities, accelerations, t, parameters, the names of reactions,
`T_kinetic` and `energy`.

    impact:
      before: {x': v, theta: 0}
      impulses: {blow: {on: rod, vector: J*i, at: r_A}}
      constraints: {peg: "x + l*cos(theta) = 0"}
      restitution: {peg: e}

`before` has velocities, and coordinates where the position in which the impact occurs is known. The names of new
constraints differ from those of the others, which go on.

Dimensions in the initial state and in questions: what cannot be equal, and what `2 m` means beside a parameter m.

The dimensions of symbols follow from the units of the file and from the places where they are used: a position is a
length, a mass is in kg. A number with a unit has the dimension of its unit. A bare number is not judged, since it may
hide a unit, and neither is a term whose dimension is not known.

Where all the letters of a unit are names of the file, `2 m` may be 2 metres, or twice the mass m. Where only one of
them has the dimension of the other side, that is meant, which a note says. Otherwise the file has to be clearer.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from dataclasses import replace
from functools import partial

import sympy as sp

from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError, Span, suggestion
from lagrange.core.records import record
from lagrange.core.symbols import UnitSymbol, base, t
from lagrange.core.units import Dimension, Unit, si_unit, split_number, unit_of
from lagrange.core.vectors import Vector
from lagrange.expressions.reader import EquationRead, Value, read_scalar, read_value
from lagrange.expressions.scope import Scope
from lagrange.problem import keys
from lagrange.problem.constraints import read_constraints
from lagrange.problem.forces import read_impulses
from lagrange.problem.limits import MOST_QUESTIONS
from lagrange.problem.load_context import LoadContext, Namespace, canonical, names_in
from lagrange.problem.model import (
    ENERGY,
    KINETIC_ENERGY,
    Choice,
    Condition,
    Constraint,
    Impact,
    InitialValue,
    Measured,
    Problem,
    Question,
)
from lagrange.problem.sections import (
    CONSTANT,
    STATE,
    AllowedQuantity,
    Section,
    entries_of,
    kind_of_symbol,
    mapping_of,
    scalar_of,
    wrong_kind,
)
from lagrange.problem.values import known_dimensions, measured_in
from lagrange.problem.yaml.nodes import ListNode, Node, Scalar
from lagrange.values.limits import LARGEST_COEFFICIENT

_EXAMPLE = 'ask: {leaves: {quantity: theta, when: "N = 0"}}'


@record
class Instant:
    """What messages call a section with a state, that state, and a value in it; an example of the section."""

    section: str
    state: str
    value: str
    example: str


_AT_START = Instant("`initial`", "the state at t = 0", "initial value", "initial: {theta: 0, theta': 0}")


def scope_of_questions(scope: Scope, constraints: Iterable[Constraint], choices: Iterable[Choice]) -> Scope:
    """The names that questions may use: those of the file, of its choices and its reactions, and of the energies."""
    old = scope.slots.coordinates
    new = [q for c in choices for q in c.coordinates if q not in old]
    slots = replace(scope.slots, coordinates=tuple(dict.fromkeys((*old, *new))))
    energies = {s.name: s for s in (KINETIC_ENERGY, ENERGY) if s.name not in scope.names()}
    added: dict[str, sp.Expr] = {
        **energies,
        **{q.name: q for q in new},
        **{c.reaction.name: c.reaction for c in constraints},
    }
    reactions = {c.name: c.reaction.name for c in constraints}
    return replace(scope, scalars={**scope.scalars, **added}, slots=slots, reactions=reactions)


def read_initial(node: Node | None, context: LoadContext, scope: Scope) -> tuple[InitialValue, ...]:
    """coordinate or velocity -> its value at t = 0."""
    return read_state(node, context, scope, _AT_START)


def read_state(node: Node | None, context: LoadContext, scope: Scope, at: Instant) -> tuple[InitialValue, ...]:
    """coordinate or velocity -> its value at one instant."""
    if node is None:
        return ()
    values: dict[sp.Symbol, InitialValue] = {}
    entries = context.diagnostics.attempt(lambda: entries_of(node, at.section, at.example))
    for key, value in entries or ():
        read = context.diagnostics.attempt(partial(_value_at, key, value, context, scope, at))
        if read is None:
            continue
        if read.symbol in values:  # once as `θ`, once as `theta`
            message = f"the {at.value} of `{read.symbol}` is given twice"
            context.diagnostics.report(Diagnostic("declared-twice", message, key.span, help="keep one of the two"))
            continue
        values[read.symbol] = read
    divided = (partial(_divided, v, values, scope.slots.coordinates) for v in values.values())
    read_all = (context.diagnostics.attempt(v) for v in divided)
    return tuple(v for v in read_all if v is not None)


def _divided(
    stated: InitialValue, values: Mapping[sp.Symbol, InitialValue], coordinates: Collection[sp.Symbol]
) -> InitialValue:
    """The velocity itself where a multiple of it is given, r φ' = v. Raises ProblemError."""
    if stated.factor == 1:
        return stated
    factor = stated.factor.xreplace({q: v.value for q, v in values.items() if v.factor == 1})
    if missing := sorted(stated.factor.free_symbols & {*coordinates} - values.keys(), key=str):
        message = f"the value of `{missing[0]}` is needed for that of `{stated.symbol}`"
        help_ = f"add it: `{missing[0]}: ...`"
        raise ProblemError(Diagnostic("velocity-multiple", message, stated.span, help=help_))
    if factor == 0:
        message = f"this does not give `{stated.symbol}`: its factor `{stated.factor}` is 0 then"
        help_ = f"state `{stated.symbol}` itself"
        raise ProblemError(Diagnostic("velocity-multiple", message, stated.span, help=help_))
    return replace(stated, value=stated.value / factor)


def _value_at(key: Scalar, node: Node, context: LoadContext, scope: Scope, at: Instant) -> InitialValue:
    factor, symbol = _multiple_of_velocity(context.read_quietly(read_scalar, key.fragment, scope, []), scope)
    kind = kind_of_symbol(symbol, scope.slots, context.unknowns) if symbol.is_Symbol else None
    if kind not in (AllowedQuantity.COORDINATE, AllowedQuantity.VELOCITY):
        message = f"`{key.text}` is neither a coordinate nor a velocity"
        help_ = f"{at.state} has coordinates and velocities: `{at.example}`"
        raise ProblemError(Diagnostic("no-state", message, key.span, help=help_))
    measured = measured_in(node.fragment, scope) if isinstance(node, Scalar) else None
    if measured is not None and not measured.names:
        return InitialValue(symbol, measured.number, key.span, measured, factor)
    what = f"the {at.value} of `{symbol}`"
    value = context.scalar(node, what, CONSTANT, _with_units(scalar_of(node, what).fragment, scope))
    return InitialValue(symbol, value, key.span, measured if factor == 1 else None, factor)


def _multiple_of_velocity(e: sp.Expr, scope: Scope) -> tuple[sp.Expr, sp.Expr]:
    """r and φ' of r φ'; 1 and the expression where it is no such product."""
    for v in scope.slots.velocities:
        factor = e.diff(v)
        if e != v and factor != 0 and v not in factor.free_symbols and sp.expand(e - factor * v) == 0:
            return factor, v
    return sp.S.One, e


def read_questions(node: Node | None, context: LoadContext, scope: Scope) -> tuple[Question, ...]:
    """name -> {quantity, when, by}."""
    if node is None:
        return ()
    questions: dict[str, Question] = {}
    entries = context.diagnostics.attempt(lambda: entries_of(node, "`ask`", _EXAMPLE)) or ()
    if len(entries) > MOST_QUESTIONS:
        message = f"a problem may ask at most {MOST_QUESTIONS} questions; this one asks {len(entries)}"
        raise ProblemError(Diagnostic("too-many-questions", message, node.span, help="write two problem files"))
    for key, value in entries:
        question = context.diagnostics.attempt(partial(_question, key, value, context, scope))
        if question is None:
            context.names.fail(key.text)
        else:
            questions[key.text] = question
    return tuple(questions.values())


def _question(key: Scalar, node: Node, context: LoadContext, scope: Scope) -> Question:
    name = context.names.spelled(key, "a question")
    what = f"the question `{key.text}`"
    section = Section(mapping_of(node, what, _EXAMPLE), what, keys.QUESTION, context.diagnostics)
    asked = section.required("quantity", key.span)
    written = scalar_of(asked, f"the quantity of {what}").fragment
    value = context.scalar(asked, f"the quantity of {what}", STATE, _with_units(written, scope))
    if value.free_symbols == set():
        message = f"{what} asks for a number"
        help_ = "ask for a coordinate, a velocity, a force, a parameter, or an expression in these"
        raise ProblemError(Diagnostic("nothing-asked", message, asked.span, help=help_))
    when = section.get("when")
    by = section.get("by")
    variable = None if by is None else _variable(scalar_of(by, "`by`"), scope, context)
    conditions = () if when is None else _conditions(when, what, context, scope)
    if name is None:
        raise ProblemError(())
    return Question(name, value, written, conditions, variable, key.span)


def _conditions(node: Node, what: str, context: LoadContext, scope: Scope) -> tuple[Condition, ...]:
    if not isinstance(node, Scalar | ListNode):
        raise ProblemError(wrong_kind(node, "`when` is an equation or a list of them", 'write `when: "N = 0"`'))
    items = node.items if isinstance(node, ListNode) else (node,)
    written = [f for i in items for f in _parts_joined_by_and(scalar_of(i, f"the `when` of {what}").fragment)]
    read: list[Condition] = context.diagnostics.all_of(
        *(lambda f=f: _condition(f, what, context, scope) for f in written)
    )
    return tuple(read)


def _parts_joined_by_and(fragment: Fragment) -> list[Fragment]:
    """The equations of `x = 0 and t = 0`."""
    text = fragment.text
    joints = [joint.span() for joint in re.finditer(r"\s+and\s+", text)]
    starts, stops = [0, *(end for _, end in joints)], [*(start for start, _ in joints), len(text)]
    return [_part(fragment, text[a:b], a) for a, b in zip(starts, stops, strict=True)]


def _condition(fragment: Fragment, what: str, context: LoadContext, scope: Scope) -> Condition:
    span = fragment.span(0, len(fragment.text))
    if sign := re.search("[<>≤≥]", fragment.text):
        message = f"the `when` of {what} takes equations only, not `{sign[0]}`"
        help_ = (
            "leave it out: the initial state is no answer, and of several states that which is reached first is given"
        )
        raise ProblemError(Diagnostic("inequality", message, span, help=help_))
    lhs, rhs, measured = _sides(fragment, what, context, scope)
    if isinstance(lhs, Vector) or isinstance(rhs, Vector):
        message = f"the `when` of {what} is an equation between vectors"
        help_ = "write an equation for each component"
        raise ProblemError(Diagnostic("vector-for-scalar", message, span, help=help_))
    return Condition(lhs, rhs, span, measured)


def _sides(fragment: Fragment, what: str, context: LoadContext, scope: Scope) -> tuple[Value, Value, Measured | None]:
    """The sides of a condition; the right one may be a number with its unit, `theta = 30 deg`."""
    left, equals, right = fragment.text.partition("=")
    measured = None
    if equals and "=" not in right:
        start = len(left) + 1 + len(right) - len(right.lstrip())
        measured = measured_in(_part(fragment, right.strip(), start), scope)
    if measured is not None and not measured.names:
        quantity = _part(fragment, left.strip(), len(left) - len(left.lstrip()))
        value = context.read_quietly(read_value, quantity, scope, [])
        context.check(EquationRead(value, sp.S.Zero), quantity, f"the `when` of {what}", STATE)
        return value, measured.number, measured
    equation = context.equation(fragment, _with_units(fragment, scope))
    context.check(equation, fragment, f"the `when` of {what}", STATE)
    return equation.lhs, equation.rhs, measured


def _part(fragment: Fragment, text: str, start: int) -> Fragment:
    at = None if fragment.start is None else fragment.start + start
    return Fragment(text, fragment.span(start, start + len(text)), at)


def _variable(scalar: Scalar, scope: Scope, context: LoadContext) -> sp.Symbol:
    """The coordinate, or t, of which the quantity is to be a function."""
    symbol = context.read_quietly(read_scalar, scalar.fragment, scope, [])
    if symbol == t or (symbol.is_Symbol and base(symbol) == symbol and symbol in scope.slots.coordinates):
        return symbol
    message = f"`{scalar.text}` is neither a coordinate nor `t`"
    help_ = "`by` names a coordinate, or `t`, as a function of which the quantity is wanted"
    raise ProblemError(Diagnostic("no-variable", message, scalar.span, help=help_))


_EXAMPLE_OF_IMPACT = "impact: {before: {x': v}, constraints: {wall: x = 0}, restitution: {wall: e}}"

_BEFORE = Instant("`before`", "the state just before", "value before the impact", "before: {x': v, theta: 0}")


def read_impact(node: Node | None, context: LoadContext, scope: Scope, old: Iterable[Constraint]) -> Impact | None:
    """The section `impact`; None if there is none.

    scope  the names that the state before may use
    old    the constraints that act before and after
    """
    if node is None:
        return None
    mapping = context.diagnostics.attempt(lambda: mapping_of(node, "`impact`", _EXAMPLE_OF_IMPACT))
    if mapping is None:
        return None
    section = Section(mapping, "the impact", keys.IMPACT, context.diagnostics)
    before = read_state(section.section("before"), context, scope, _BEFORE)
    impulses = read_impulses(section.section("impulses"), context)
    names = Namespace(context.names)
    for constraint in old:
        names.reserve(constraint.name, "a constraint", constraint.span)
    constraints = read_constraints(section.section("constraints"), context, names)
    declared = [*dict.fromkeys(c.name.partition(".")[0] for c in constraints)]
    restitution = _restitution(section.section("restitution"), context, declared)
    if not section.has("impulses") and not section.has("constraints"):
        message = "nothing happens in this impact: there is neither an impulse nor a new constraint"
        help_ = "give `impulses`, or `constraints` that begin to act"
        context.diagnostics.report(Diagnostic("empty-impact", message, section.node.span, help=help_))
    of_components = {c.name: restitution.get(c.name.partition(".")[0], sp.S.Zero) for c in constraints}
    return Impact(section.node.span, before, impulses, constraints, of_components)


def with_initial_before(problem: Problem) -> Problem:
    """The problem with `initial` as part of the state before its impact: time begins with the impact.

    Raises ProblemError if the two contradict each other.
    """
    impact = problem.impact
    assert impact is not None
    before = {v.symbol: v for v in impact.before}
    for v in problem.initial:
        if v.value != before.setdefault(v.symbol, v).value:
            message = f"`{v.symbol}` has different values at t = 0 and just before the impact"
            help_ = "the motion begins with the impact: give its state once, as `before` under `impact`"
            raise ProblemError(Diagnostic("two-starts", message, v.span, help=help_))
    return replace(problem, initial=(), impact=replace(impact, before=tuple(before.values())))


def _restitution(node: Node | None, context: LoadContext, declared: list[str]) -> Mapping[str, sp.Expr]:
    """name of a new constraint -> its coefficient."""
    if node is None:
        return {}
    coefficients: dict[str, sp.Expr] = {}
    for key, value in context.diagnostics.attempt(lambda: entries_of(node, "`restitution`", "{peg: e}")) or ():
        name = canonical(key.text, declared)
        if name not in declared:
            if not context.names.has_failed(key.text):
                message = f"`{key.text}` is not a constraint that begins to act"
                help_ = suggestion(name, declared, "new constraints")
                context.diagnostics.report(Diagnostic("unknown-name", message, key.span, help=help_))
            continue
        read = context.diagnostics.attempt(
            lambda v=value, n=name: context.scalar(v, f"the restitution of `{n}`", CONSTANT)  # type: ignore[misc]
        )
        if read is None:
            continue
        if read.is_negative or (read - 1).is_positive:
            message = f"the coefficient of restitution of `{name}` is not between 0 and 1"
            help_ = "0 is a perfectly inelastic impact, 1 an elastic one"
            context.diagnostics.report(Diagnostic("bad-restitution", message, value.span, help=help_))
            continue
        coefficients[name] = read
    return coefficients


# Question units


_NUMBERS_WITH_UNITS = re.compile(
    r"(?<![\w.])(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?(?P<unit>(?:\s*[*·⋅/]?\s*[^\W\d]\w*(?:\s*\^\s*-?\d+|[²³])?)+)"
)


def _with_units(fragment: Fragment, scope: Scope) -> Scope:
    """The scope with the units that follow numbers in an expression, as symbols: km of `R + 500 km`.

    A name of the file is that name. Behind a division a number with its unit would be read as a quotient and a factor,
    R/5 times km, so that no unit is found there.
    """
    units: list[str] = []
    for number in _NUMBERS_WITH_UNITS.finditer(fragment.text):
        if re.search(r"(?:[^\d.\s]\s*/|\^|\*\*)\s*$", fragment.text[: number.start()]):
            continue
        for name in re.findall(r"[^\W\d]\w*", number["unit"]):
            if name in scope.names() or unit_of(name) is None:
                break
            units.append(name)
    everywhere = names_in(fragment.text)
    found = {name: UnitSymbol(name, positive=True) for name in units if everywhere.count(name) == units.count(name)}
    found.pop("deg", None)  # degrees after a number belong to the language
    return replace(scope, scalars={**scope.scalars, **found}) if found else scope


def _in_si(e: sp.Expr) -> sp.Expr:
    """The expression, each unit replaced by its number in SI units."""
    units = {u: unit.factor for u in e.atoms(UnitSymbol) if (unit := unit_of(u.name)) is not None}
    return e.xreplace(units)


def _has_units(e: sp.Expr) -> bool:
    """Whether a number has a unit with a dimension, so that the number alone does not show it."""
    return any(any(dimension) for dimension in _units_in(e).values())


def _units_in(e: sp.Expr) -> dict[sp.Symbol, Dimension]:
    return {u: unit.dimension for u in e.atoms(UnitSymbol) if (unit := unit_of(u.name)) is not None}


Known = Mapping[sp.Symbol, Dimension]
Note = Callable[[Diagnostic], None]
TermWithUnit = tuple[sp.Expr | str, Dimension]


def with_dimensions_compared(problem: Problem, note: Note) -> Problem:
    """The problem, with each `2 m` read as its place demands, and units as numbers.

    Raises ProblemError if two sides cannot be equal.
    """
    before = () if problem.impact is None else problem.impact.before
    conditions = [c for q in problem.questions for c in q.when]
    stated: list[InitialValue | Condition] = [*problem.initial, *before, *conditions]
    units = [*(p.unit for p in problem.parameters), *(q.unit for q in problem.coordinates)]
    values = [v.value for v in (*problem.initial, *before)] + [side for c in conditions for side in (c.lhs, c.rhs)]
    within: dict[sp.Symbol, Dimension] = {}
    for e in (*values, *(q.quantity for q in problem.questions)):
        within |= _units_in(e)
    if not (stated or problem.questions) or not (any(s.measured for s in stated) or any(units) or within):
        return problem
    energy = unit_of("J")
    assert energy is not None
    energies = dict.fromkeys((KINETIC_ENERGY, ENERGY), energy.dimension)
    reader = _Reader({**energies, **known_dimensions(problem), **within}, note)
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
        is_multiple = stated.factor != 1 and stated.measured is not None
        left = stated.factor * stated.symbol if is_multiple else stated.symbol
        value = self._compared(left, stated.value, stated.measured, stated.span, what)
        kept = replace(stated, value=_in_si(value), hides_units=is_multiple or _has_units(value))
        return replace(kept, measured=None) if is_multiple else kept

    def question(self, asked: Question) -> Question:
        """The conditions of a question, and the terms of its quantity."""
        self._compared(asked.quantity, sp.S.Zero, None, asked.span, "a term of the quantity")
        return replace(asked, quantity=_in_si(asked.quantity), when=tuple(self._condition(c) for c in asked.when))

    def _condition(self, stated: Condition) -> Condition:
        value = self._compared(stated.lhs, stated.rhs, stated.measured, stated.span, "a side of this equation")
        hidden = _has_units(stated.lhs) or _has_units(value)
        return replace(stated, lhs=_in_si(stated.lhs), rhs=_in_si(value), hides_units=hidden)

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
        hides_unit = not number.is_Rational or abs(number.p) > LARGEST_COEFFICIENT
        if term.is_number or (hides_unit and not term.has(UnitSymbol)):
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
