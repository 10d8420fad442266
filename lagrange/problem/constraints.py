"""Reading the constraints: equations between coordinates, velocities and time.

A constraint may be written in differentials, `sin(theta)*d(x) - cos(theta)*d(y) = 0`; divided by dt it is one in
velocities. A vector equation counts as its components, `no_slip.1`, `no_slip.2`, ... An equation that
restricts nothing is refused, and so is a reaction whose name means something else.

A one-sided constraint, r >= R, is read as the equation r = R with the side that it permits: it acts as long as there is
contact, and then the equation holds.

A constraint that is not linear in the velocities is reduced (`algebra.forms.nonlinear_constraints`): (x' − y')² = 0 is
x' − y' = 0, and x'² + y'² = 0 is x' = 0 and y' = 0, two constraints. One that has several alternatives is refused: a
system is one of them.
"""

from __future__ import annotations

from collections.abc import Set
from dataclasses import replace
from functools import partial

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError
from lagrange.algebra.forms.velocity_polynomials import Alternative, Alternatives, Why, is_affine
from lagrange.algebra.fourier.vector_cleanup import tidied
from lagrange.core.diagnostics import Diagnostic, ProblemError, Severity, Span, nearest
from lagrange.core.symbols import Slots, differential, multiplier, prime, t
from lagrange.core.vectors import Vector
from lagrange.expressions.reader import limit_of
from lagrange.problem import keys
from lagrange.problem.limits import MOST_ALTERNATIVES_SHOWN
from lagrange.problem.load_context import LoadContext, Namespace
from lagrange.problem.model import Constraint, Given, Keeper
from lagrange.problem.sections import CONSTRAINT, Section, entries_of, scalar_of
from lagrange.problem.yaml.nodes import MappingNode, Node, Scalar

_EXAMPLE = "constraints: {rod: x^2 + y^2 = l^2}"


def read_constraints(node: Node | None, context: LoadContext, names: Namespace | None = None) -> tuple[Constraint, ...]:
    """name -> equation, or name -> {equation, note, reaction, by}; a vector equation gives one for each component.

    names  of constraints; those of the context by default
    """
    if node is None:
        return ()
    constraints: list[Constraint] = []
    for key, value in context.diagnostics.attempt(lambda: entries_of(node, "`constraints`", _EXAMPLE)) or ():
        name = (names or context.constraints).declare(key, "a constraint")
        if name is not None:
            read = partial(_constraint, name, key, value, context)
            constraints += context.diagnostics.attempt(read) or ()
    return tuple(constraints)


def _constraint(name: str, key: Scalar, node: Node, context: LoadContext) -> tuple[Constraint, ...]:
    what = f"the constraint `{name}`"
    if not isinstance(node, MappingNode):
        return _equations(name, key.span, node, "", None, context)
    section = Section(node, what, keys.CONSTRAINT, context.diagnostics)
    reaction = section.get("reaction")
    named = context.diagnostics.attempt(lambda: scalar_of(reaction, "`reaction`")) if reaction else None
    called = context.names.symbol(named, "a reaction") if named else None
    equation = section.required("equation", key.span)
    place = key.span if reaction is None else reaction.span
    keeper = section.get("by")
    by = context.diagnostics.attempt(lambda: _keeper(scalar_of(keeper, "`by`"))) if keeper else None
    try:
        constraints = _equations(name, place, equation, section.text("note"), called, context)
    except ProblemError:
        context.names.fail(*([called] if called else []))
        raise
    if by is not None and keeper is not None and any(c.side is not None for c in constraints):
        _check_one_sided_keeper(name, by, keeper.span)
    return tuple(replace(c, by=by) for c in constraints)


def _check_one_sided_keeper(name: str, by: Keeper, span: Span) -> None:
    """Refuse what keeps a constraint from both sides. Raises ProblemError."""
    if by not in (Keeper.STRING, Keeper.SURFACE):
        message = f"a {by} acts in both senses, but `{name}` is one-sided"
        help_ = "write `by: string` or `by: surface`, or an equation with `=`"
        raise ProblemError(Diagnostic("one-sided", message, span, help=help_))


def _keeper(scalar: Scalar) -> Keeper:
    """What keeps a constraint. Raises ProblemError if it is none of the known words."""
    if scalar.text in set(Keeper):
        return Keeper(scalar.text)
    near = nearest(scalar.text, [*Keeper])
    help_ = f"did you mean `{near}`?" if near else f"write {', '.join(f'`{k}`' for k in Keeper)}, or leave it out"
    message = f"`{scalar.text}` is not one of the things that can keep a constraint"
    raise ProblemError(Diagnostic("unknown-keeper", message, scalar.span, help=help_))


def _equations(
    name: str, place: Span, node: Node, note: str, reaction: str | None, context: LoadContext
) -> tuple[Constraint, ...]:
    """The scalar constraints of an equation. `place` is blamed for the names of their reactions."""
    what = f"the constraint `{name}`"
    scalar = scalar_of(node, what)
    in_contact, side = limit_of(scalar.fragment, f"`{name}`")
    equation = context.equation(in_contact)
    context.check(equation, scalar.fragment, what, CONSTRAINT)
    lhs, rhs = equation.lhs, equation.rhs
    sides: list[tuple[str, sp.Expr, sp.Expr]]
    if isinstance(lhs, Vector) and isinstance(rhs, Vector):
        triad = (lhs - rhs).triad
        pairs = zip(lhs.along(triad).components, rhs.along(triad).components, strict=True)
        sides = [(f".{n}", a, b) for n, (a, b) in enumerate(pairs, start=1) if not _is_identity(a, b, context)]
    else:
        sides = [("", lhs, rhs)]
    if not sides:
        raise ProblemError(_restricts_nothing(name, scalar.span))
    if side is not None and isinstance(lhs, Vector):
        help_ = "write one scalar constraint for each direction that is barred"
        raise ProblemError(Diagnostic("one-sided", f"`{name}` compares vectors", scalar.span, help=help_))
    constraints = []
    for suffix, a, b in sides:
        left, right, kinematic = _restricting(name + suffix, *_divided_by_dt(a, b, scalar, context), scalar, context)
        if side is not None and kinematic:
            message = f"the one-sided constraint `{name}` contains velocities"
            help_ = "contact is a condition on positions: write it without velocities, or an equation with `=`"
            raise ProblemError(Diagnostic("one-sided", message, scalar.span, help=help_))
        parts, given = _reduced(name + suffix, left, right, kinematic, scalar, context)
        for number, (f, g, moves) in enumerate(parts, start=1):
            part = suffix if len(parts) == 1 else f"{suffix}.{number}"
            symbol = _reaction(name, part, reaction, place, context)
            constraints.append(
                Constraint(name + part, tidied(f), tidied(g), moves, symbol, scalar.span, note, given, side=side)
            )
    return tuple(constraints)


def _is_identity(lhs: sp.Expr, rhs: sp.Expr, context: LoadContext) -> bool:
    """Whether a component holds identically, as 0 = 0 across the plane."""
    try:
        return lhs - rhs == 0 or context.is_zero(lhs - rhs) is True
    except DivisionByZeroError:
        return False  # `_restricting` reports it


def _reaction(name: str, suffix: str, reaction: str | None, place: Span, context: LoadContext) -> sp.Symbol:
    """The name of the multiplier of a constraint; reported where it means something else."""
    suffix = suffix.replace(".", "_")
    symbol = sp.Symbol(reaction + suffix, real=True) if reaction else multiplier(name + suffix)
    context.names.add(symbol.name, f"the reaction of the constraint `{name}`", place)
    return symbol


def _restricting(
    name: str, lhs: sp.Expr, rhs: sp.Expr, scalar: Scalar, context: LoadContext
) -> tuple[sp.Expr, sp.Expr, bool]:
    """Both sides, and whether a velocity occurs. Raises ProblemError if the equation restricts nothing."""
    slots = context.scope.slots
    function = lhs - rhs
    used = function.free_symbols
    velocities = used.intersection(slots.velocities)
    try:
        if used.isdisjoint((*slots.coordinates, *slots.velocities)) or context.is_zero(function):
            raise ProblemError(_restricts_nothing(name, scalar.span))
        if velocities and all(context.is_zero(function.diff(v)) for v in velocities):  # (x' + 1)*x - x'*x
            return function.xreplace(dict.fromkeys(velocities, sp.S.Zero)), sp.S.Zero, False
    except DivisionByZeroError:
        message = f"the constraint `{name}` divides by an expression that is exactly zero"
        raise ProblemError(Diagnostic("division-by-zero", message, scalar.span, help="correct the divisor")) from None
    return lhs, rhs, bool(velocities)


def _reduced(
    name: str, lhs: sp.Expr, rhs: sp.Expr, kinematic: bool, scalar: Scalar, context: LoadContext
) -> tuple[list[tuple[sp.Expr, sp.Expr, bool]], Given | None]:
    """Both sides of each constraint to which this one reduces, with whether a velocity occurs, and what the file has.

    The latter is None if nothing had to be reduced. Raises ProblemError if there are several alternatives, or
    none.
    """
    slots, function = context.scope.slots, lhs - rhs
    if not kinematic:
        _check_no_sum_of_squares(name, function, scalar.span, context)
    if not kinematic or is_affine(function, slots) or not context.may_reduce(function):
        return [(lhs, rhs, kinematic)], None
    from lagrange.algebra.forms.nonlinear_constraints import alternatives

    try:
        meanings = alternatives(function, slots)
    except DivisionByZeroError:
        message = f"the constraint `{name}` divides by an expression that is exactly zero"
        raise ProblemError(Diagnostic("division-by-zero", message, scalar.span, help="correct the divisor")) from None
    if len(meanings.members) != 1 or meanings.endless:
        raise ProblemError(_not_one(name, meanings, scalar.span, slots))
    [only] = meanings.members
    if only.forms == (function,):
        return [(lhs, rhs, kinematic)], None
    if excluded := _excluded(meanings):
        zeros = " or ".join(f"`{_text(e, slots)} = 0`" for e in excluded)
        message = f"the constraint `{name}` admits more velocities where {zeros}: this is excluded here"
        help_ = f"divide by the factor to say so, or write {zeros} where that is meant"
        context.diagnostics.report_all(
            [Diagnostic("factor-excluded", message, scalar.span, help=help_, level=Severity.NOTE)]
        )
    parts = [(f, sp.S.Zero, not f.free_symbols.isdisjoint(slots.velocities)) for f in only.forms]
    return parts, Given(lhs, rhs, only.steps)


def _excluded(meanings: Alternatives) -> list[sp.Expr]:
    """The factors whose zeros satisfy the constraint as well."""
    return [*dict.fromkeys(e for a in meanings.members for step in a.steps for e in step.excluded)]


def _check_no_sum_of_squares(name: str, function: sp.Expr, span: Span, context: LoadContext) -> None:
    """Raises ProblemError for a geometric constraint such as x² + y² = 0, which is a point and has no normal there."""
    # Likely terms first: SymPy knows at once that x² is not negative, and whether it is positive after many questions.
    terms = sorted(sp.Add.make_args(function), key=lambda a: a.could_extract_minus_sign())
    if not function.is_Add or (any(a.is_nonnegative for a in terms) and any(a.is_nonpositive for a in terms[::-1])):
        return
    slots = context.scope.slots
    linear = all(function.diff(q).free_symbols.isdisjoint(slots.coordinates) for q in slots.coordinates)
    if linear or not context.may_reduce(function):
        return
    from lagrange.algebra.forms.nonlinear_constraints import in_configuration

    meanings = in_configuration(function, slots)
    if meanings.endless or len(meanings.members) != 1:
        return
    [only] = meanings.members
    if only.steps and only.steps[0].why is Why.SQUARES:
        message = f"`{name}` is a sum of terms of one sign: it holds only where all of them vanish"
        parts = " and ".join(f"`{_text(f, slots)} = 0`" for f in only.forms)
        help_ = f"its differential vanishes there; write {parts} instead"
        raise ProblemError(Diagnostic("singular-constraint", message, span, help=help_))


def _not_one(name: str, meanings: Alternatives, span: Span, slots: Slots) -> Diagnostic:
    """A constraint that nothing satisfies, or one of several branches."""
    if not meanings.members:
        message = f"`{name}` cannot be satisfied"
        help_ = "no real velocity satisfies it; correct or remove it"
        return Diagnostic("contradictory-constraints", message, span, help=help_)
    if excluded := _excluded(meanings):
        meanings = Alternatives((*meanings.members, *(Alternative((e,)) for e in excluded)), meanings.endless)
    count = "infinitely many" if meanings.endless else str(len(meanings.members))
    message = f"the constraint `{name}` leaves {count} alternatives"
    shown = [_written(a, slots) for a in meanings.members[:MOST_ALTERNATIVES_SHOWN]]
    more = "" if len(meanings.members) <= MOST_ALTERNATIVES_SHOWN and not meanings.endless else ", ..."
    help_ = f"a system is one of them; write {' or '.join(shown)}{more}"
    signs = {e for a in meanings.members for step in a.steps for e, relation in step.conditions if relation == "≥"}
    if signs:
        help_ += f", which is real where {' and '.join(sorted(f'`{_text(e, slots)}`' for e in signs))} is not negative"
    return Diagnostic("several-branches", message, span, help=help_)


def _written(alternative: Alternative, slots: Slots) -> str:
    """An alternative in the language of problem files."""
    return " with ".join(f"`{_text(f, slots)} = 0`" for f in alternative.forms)


def _text(expression: sp.Expr, slots: Slots) -> str:
    """An expression in the language of problem files, the terms with velocities first: `x' - c*y'`."""
    places = {s: n for n, s in enumerate((*slots.velocities, *slots.coordinates))}

    def first(term: sp.Expr) -> int:
        return min((places[s] for s in term.free_symbols if s in places), default=len(places))

    terms = map(str, sorted(sp.Add.make_args(expression), key=first))
    return " + ".join(terms).replace("+ -", "- ").replace("**", "^").replace("Abs(", "abs(")


def _restricts_nothing(name: str, span: Span) -> Diagnostic:
    help_ = "a constraint is an equation that not all positions and velocities satisfy"
    return Diagnostic("restricts-nothing", f"the constraint `{name}` restricts no coordinate", span, help=help_)


def _divided_by_dt(lhs: sp.Expr, rhs: sp.Expr, scalar: Scalar, context: LoadContext) -> tuple[sp.Expr, sp.Expr]:
    """A constraint in differentials, rewritten in velocities: d(x) -> x', d(t) -> 1."""
    slots = context.scope.slots
    moving = (*slots.coordinates, *slots.prescribed)
    rule = {differential(q): prime(q) for q in moving} | {differential(t): sp.S.One}
    if rule.keys().isdisjoint(lhs.free_symbols | rhs.free_symbols):
        return lhs, rhs
    if not all(_is_form(side, rule.keys(), context) for side in (lhs, rhs)):
        message = "a constraint in differentials must be linear and homogeneous in them"
        help_ = "give every term one differential, as in `sin(theta)*d(x) - cos(theta)*d(y) = 0`, or write `x'`"
        raise ProblemError(Diagnostic("not-a-form", message, scalar.span, help=help_))
    return lhs.xreplace(rule), rhs.xreplace(rule)


def _is_form(side: sp.Expr, differentials: Set[sp.Symbol], context: LoadContext) -> bool:
    """Whether an expression is linear and homogeneous in differentials, perhaps only when multiplied out."""
    used = sorted(side.free_symbols & differentials, key=lambda s: str(s.name))
    rest = side.xreplace(dict.fromkeys(used, sp.S.Zero))
    second = [side.diff(a).diff(b) for n, a in enumerate(used) for b in used[n:]]
    if rest.has(sp.zoo, sp.nan):
        return False
    try:
        return all(e == 0 or context.is_zero(e) for e in (rest, *second))
    except DivisionByZeroError:
        return False
