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
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import replace
from functools import partial

import sympy as sp

from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError, suggestion
from lagrange.core.records import record
from lagrange.core.symbols import base, t
from lagrange.core.vectors import Vector
from lagrange.expressions.reader import EquationRead, Scope, Value, read_scalar, read_value
from lagrange.problem import keys
from lagrange.problem.constraints import read_constraints
from lagrange.problem.declared_names import Namespace, canonical
from lagrange.problem.forces import read_impulses
from lagrange.problem.limits import MOST_QUESTIONS
from lagrange.problem.load_context import LoadContext
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
from lagrange.problem.values import measured_in
from lagrange.problem.yaml.nodes import ListNode, Node, Scalar

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
    return tuple(values.values())


def _value_at(key: Scalar, node: Node, context: LoadContext, scope: Scope, at: Instant) -> InitialValue:
    symbol = context.read_quietly(read_scalar, key.fragment, scope, [])
    kind = kind_of_symbol(symbol, scope.slots, context.unknowns) if symbol.is_Symbol else None
    if kind not in (AllowedQuantity.COORDINATE, AllowedQuantity.VELOCITY):
        message = f"`{key.text}` is neither a coordinate nor a velocity"
        help_ = f"{at.state} has coordinates and velocities: `{at.example}`"
        raise ProblemError(Diagnostic("no-state", message, key.span, help=help_))
    measured = measured_in(node.fragment, scope) if isinstance(node, Scalar) else None
    if measured is not None and not measured.names:
        return InitialValue(symbol, measured.number, key.span, measured)
    value = context.scalar(node, f"the {at.value} of `{symbol}`", CONSTANT, scope)
    return InitialValue(symbol, value, key.span, measured)


def read_questions(node: Node | None, context: LoadContext, scope: Scope) -> tuple[Question, ...]:
    """name -> {quantity, when, by}."""
    if node is None:
        return ()
    questions: dict[str, Question] = {}
    entries = context.diagnostics.attempt(lambda: entries_of(node, "`ask`", _EXAMPLE)) or ()
    if len(entries) > MOST_QUESTIONS:
        message = f"a problem may ask {MOST_QUESTIONS} questions, and this one asks {len(entries)}"
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
    value = context.scalar(asked, f"the quantity of {what}", STATE, scope)
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
    return Question(name, value, scalar_of(asked, "`quantity`").fragment, conditions, variable, key.span)


def _conditions(node: Node, what: str, context: LoadContext, scope: Scope) -> tuple[Condition, ...]:
    if not isinstance(node, Scalar | ListNode):
        raise ProblemError(wrong_kind(node, "`when` is an equation or a list of them", 'write `when: "N = 0"`'))
    items = node.items if isinstance(node, ListNode) else (node,)
    read: list[Condition] = context.diagnostics.all_of(
        *(lambda i=i: _condition(scalar_of(i, f"the `when` of {what}"), what, context, scope) for i in items)
    )
    return tuple(read)


def _condition(scalar: Scalar, what: str, context: LoadContext, scope: Scope) -> Condition:
    if sign := re.search("[<>≤≥]", scalar.text):
        message = f"the `when` of {what} has equations only, and no `{sign[0]}`"
        help_ = (
            "leave it out: the initial state is no answer, and of several states that which is reached first is given"
        )
        raise ProblemError(Diagnostic("inequality", message, scalar.span, help=help_))
    lhs, rhs, measured = _sides(scalar.fragment, what, context, scope)
    if isinstance(lhs, Vector) or isinstance(rhs, Vector):
        message = f"the `when` of {what} is an equation between vectors"
        help_ = "write an equation for each component"
        raise ProblemError(Diagnostic("vector-for-scalar", message, scalar.span, help=help_))
    return Condition(lhs, rhs, scalar.span, measured)


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
    equation = context.equation(fragment, scope)
    context.check(equation, fragment, f"the `when` of {what}", STATE)
    return equation.lhs, equation.rhs, measured


def _part(fragment: Fragment, text: str, start: int) -> Fragment:
    at = None if fragment.start is None else fragment.start + start
    return Fragment(text, fragment.span(start, start + len(text)), at)


def _variable(scalar: Scalar, scope: Scope, context: LoadContext) -> sp.Symbol:
    """The coordinate, or t, as a function of which the quantity is wanted."""
    symbol = context.read_quietly(read_scalar, scalar.fragment, scope, [])
    if symbol == t or (symbol.is_Symbol and base(symbol) == symbol and symbol in scope.slots.coordinates):
        return symbol
    message = f"`{scalar.text}` is neither a coordinate nor `t`"
    help_ = "`by` names a coordinate, or `t`, as a function of which the quantity is wanted"
    raise ProblemError(Diagnostic("no-variable", message, scalar.span, help=help_))


_EXAMPLE_OF_IMPACT = "impact: {before: {x': v}, constraints: {wall: x = 0}, restitution: {wall: e}}"

_BEFORE = Instant("`before`", "the state just before", "value before the impact", "before: {x': v, theta: 0}")


def read_impact(node: Node | None, context: LoadContext, scope: Scope, old: Iterable[Constraint]) -> Impact | None:
    """The section `impact`; None where there is none.

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

    Raises ProblemError where the two contradict each other.
    """
    impact = problem.impact
    assert impact is not None
    before = {v.symbol: v for v in impact.before}
    for v in problem.initial:
        if v.value != before.setdefault(v.symbol, v).value:
            message = f"`{v.symbol}` has another value just before the impact, at t = 0"
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
