"""Answers about the constraints: the number of degrees of freedom, the classification, and the constraints themselves.

A problem that asks for its constraints alone may be answered by equations between coordinates, velocities, or
displacements. Such an equation is right if it holds in every state, or for every displacement, that the constraints
admit. Each gives a row of coefficients of displacements: A δq = 0. The answer is complete if the rows bind as many
displacements as the constraints do. A relation f = const, and one with dq or dt, is compared by its rate.

Degrees of freedom and classification, as they are written in sentences.

    6 - 1 = 5 degrees of freedom      DOF = 2      f = 6 - 1 = 5      Freiheitsgrade: 5
    holonomic, scleronomic            not holonomic                   nicht holonom

Numbers are added and subtracted; of several numbers of degrees of freedom the last one counts.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.algebra.exact.expression_graph import DivisionByZeroError
from lagrange.algebra.exact.points import Point
from lagrange.answers.limits import LONGEST_IN_WORDS
from lagrange.answers.readings import GivenEquation, displaced_coordinates, without_displacements
from lagrange.answers.verdicts import DIVIDES_BY_ZERO, MIXED_CHOICES, UNDECIDED, AnswerVerdict, EquationVerdict, Verdict
from lagrange.answers.written.names import has_word, spelled_out
from lagrange.answers.written.reading import read_as_written
from lagrange.core.diagnostics import Diagnostic, Fragment
from lagrange.core.symbols import CONSTANT, base, differential, prime, symbols_in, variation
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.comparison import Standing, System, agreed_in_motion, compare
from lagrange.mechanics.results import InCoordinates, Solution
from lagrange.problem.model import Answers

if TYPE_CHECKING:
    from lagrange.answers.written.working import Working

_NOT_REQUIRED = "the constraints do not require it"
_IDENTITY = "it is an identity"
_INTEGRATED = "it holds up to a constant, which the initial position determines"
_DIFFERENTIALS = "`dx` is read as a differential"
_UNDECLARED = re.compile(r"`(\w+)` is not declared")
_Stated = tuple[str, tuple[sp.Expr, ...], tuple[sp.Expr, ...]]
"""The text of an equation, its components, and those in its other reading; none if it has no other."""
_ORDER = (Verdict.WRONG, Verdict.UNREADABLE, Verdict.UNDECIDED)


def about_constraints(solution: Solution | None) -> bool:
    """Whether a problem asks for its constraints alone."""
    if solution is None or solution.impact is not None or solution.own.motion is not None:
        return False
    return all(v.equilibrium is None and v.at_rest is None and v.impending is None for v in solution.views)


def check_constraints(working: Working, solution: Solution) -> AnswerVerdict:
    """The verdict on equations that state constraints, between coordinates, velocities or displacements."""
    judged: list[EquationVerdict] = []
    stated: list[sp.Expr] = []
    integrals, unread = with_constants(working, solution)
    readings, eliminating = _without_unknowns([*_readings(working, solution)], working)
    for text, components, other in [*readings, *integrals]:
        try:
            verdict, why = _judged(components, solution)
            if verdict is Verdict.WRONG and other and _judged(other, solution)[0] is Verdict.EQUIVALENT:
                verdict, why, components = Verdict.EQUIVALENT, _DIFFERENTIALS, other
            elif verdict is Verdict.WRONG and (up_to_constant := _up_to_a_constant(components, solution)):
                verdict, why, components = Verdict.EQUIVALENT, _INTEGRATED, up_to_constant
            elif verdict is Verdict.WRONG and (change := _changed(components, solution)):
                why = f"{why}; {change}"
        except DivisionByZeroError:
            verdict, why = Verdict.UNREADABLE, DIVIDES_BY_ZERO
        judged.append(EquationVerdict.of(text, verdict, why))
        stated += components if verdict is Verdict.EQUIVALENT else ()
    unreadable = [f for f in unread if f.reading.error and not is_about_freedom(f)]
    errors = tuple(d for f in unreadable if f.reading.error for d in f.reading.error.diagnostics)
    verdicts = {e.verdict for e in judged}
    whole = next((v for v in _ORDER if v in verdicts), Verdict.EQUIVALENT if stated else Verdict.TRIVIAL)
    missing = _missing(stated, solution) if whole is Verdict.EQUIVALENT else 0
    if missing:
        whole = Verdict.INCOMPLETE
    if unreadable and whole in (Verdict.INCOMPLETE, Verdict.TRIVIAL):
        whole = Verdict.UNREADABLE
    judged += [
        EquationVerdict(f.reading.text, Verdict.UNREADABLE, f.reading.error.diagnostics[0].message)
        for f in unreadable
        if f.reading.error
    ]
    diagnosis = "" if not missing else f"{missing} independent equation{'s are' if missing > 1 else ' is'} missing"
    notes = (*working.notes, *eliminating)
    return AnswerVerdict(whole, tuple(judged), missing, unreadable=errors, notes=notes, diagnosis=diagnosis)


def _without_unknowns(readings: list[_Stated], working: Working) -> tuple[list[_Stated], list[Diagnostic]]:
    """The statements with what one of them says about a name in the others: of x' = v cos θ, y' = v sin θ the second.

    The name, a speed or an angular velocity that nobody declared, occurs in each of them as a factor.
    """
    notes = []
    for unknown in working.unknowns:
        slopes = [[e.diff(unknown) for e in components] for _, components, _ in readings]
        with_it = [n for n, each in enumerate(slopes) if any(c != 0 for c in each)]
        if len(with_it) < 2 or any(len(slopes[n]) != 1 or slopes[n][0].has(unknown) for n in with_it):
            continue
        pivot = min(with_it, key=lambda n: sp.count_ops(slopes[n][0]))
        [solved], [of_solved] = readings[pivot][1], slopes[pivot]
        kept: list[_Stated] = []
        for n, (text, components, other) in enumerate(readings):
            if n in with_it and n != pivot:
                components, other = (sp.expand(components[0] * of_solved - solved * slopes[n][0]),), ()
            kept += [(text, components, other)] if n != pivot else []
        message = f"`{readings[pivot][0]}` says what `{unknown}` is, which is put into the other equations"
        notes.append(Diagnostic("read-as", message, working.judged[0].whole).as_note())
        readings = kept
    return readings, notes


def _readings(working: Working, solution: Solution) -> Iterator[_Stated]:
    """The equations of an answer, with their other reading where `dx` is a product: a differential."""
    scope = solution.problem.scope
    names = "|".join(re.escape(q.name) for q in scope.slots.coordinates)
    differential_ = re.compile(rf"(?<![A-Za-z0-9_\\])d\s?(?P<name>{names}|t)(?![A-Za-z0-9_'(])")
    for fragment in working.judged:
        if not isinstance(fragment, GivenEquation):
            continue
        reading = fragment.reading
        other: tuple[sp.Expr, ...] = ()
        if scope.scalar("d") is not None and "'" not in reading.text:
            text = differential_.sub(lambda m: "1" if m["name"] == "t" else f"{m['name']}'", reading.text)
            if text != reading.text:
                again = read_as_written(Fragment.of(text), scope)
                other = () if again.error else again.components
        yield reading.text, reading.components, other


def _occurs_in(name: str, text: str) -> bool:
    """Whether a name, or its rate, occurs in a text."""
    return has_word(name, re.sub(r"[\u0307\u0308{}]|\\d?dot", "", unicodedata.normalize("NFD", spelled_out(text))))


def with_constants(working: Working, solution: Solution) -> tuple[list[_Stated], list[GivenEquation]]:
    """Integrated constraints with a constant that the problem does not declare, and what remains unreadable.

    x^2 + y^2 + z^2 = R^2, x = v t - v/k + C exp(-k t): of the name that stands for a constant the rate is zero.
    """
    constraints: list[_Stated] = []
    rest: list[GivenEquation] = []
    moving = {q for v in solution.views for q in v.configuration.slots.coordinates}
    for name, value in working.defined.items():
        used = symbols_in(value)
        if any(isinstance(f, GivenEquation) and _occurs_in(name, f.reading.text) for f in working.judged):
            continue  # x_A = x - a cos(theta), of which another equation makes use
        if used & moving and all(base(s) == s for s in used) and not displaced_coordinates([value], tuple(moving)):
            constraints.append((f"{name} = ...", (value - CONSTANT,), ()))
    for f in working.unreadable:
        names = (
            {m[1] for d in f.reading.error.diagnostics if (m := _UNDECLARED.match(d.message))}
            if f.reading.error
            else {}
        )
        if (relation := _from_initial_values(f, names, solution)) is not None:
            constraints.append((f.reading.text, (relation,), ()))
            continue
        constant = sp.Symbol("arbitrary constant", real=True)
        if len(names) == 1:
            scope = solution.problem.scope
            wider = replace(scope, scalars={**scope.scalars, next(iter(names)): constant})
            again = read_as_written(Fragment.of(f.reading.text), wider)
            if not again.error and len(again.components) == 1:
                [e] = again.components
                slope = e.diff(constant)
                used = symbols_in(e)
                if slope != 0 and not slope.has(constant) and used & moving and all(base(s) == s for s in used):
                    constraints.append((f.reading.text, (sp.cancel(constant - e / slope) - CONSTANT,), ()))
                    continue
        rest.append(f)
    return constraints, rest


def _from_initial_values(f: GivenEquation, names: Collection[str], solution: Solution) -> sp.Expr | None:
    """`x - x0 = R*(phi - phi0)` as x - R*phi = const, where it holds at the start, x = x0 and phi = phi0."""
    scope = solution.problem.scope
    coordinates = {q.name: q for q in scope.slots.coordinates}
    starts = {n: coordinates.get(n.removeprefix("var").removesuffix("0").rstrip("_")) for n in names if n[-1] == "0"}
    if not starts or len(starts) < len(names) or None in starts.values():
        return None
    symbols = {n: sp.Symbol(n, real=True) for n in starts}
    reading = read_as_written(Fragment.of(f.reading.text), replace(scope, scalars={**scope.scalars, **symbols}))
    if reading.error or len(reading.components) != 1 or any(base(s) != s for s in symbols_in(reading.components[0])):
        return None
    [e] = reading.components
    fixed = {*symbols.values()}
    if sp.expand(e.xreplace({symbols[n]: q for n, q in starts.items()})) != 0:
        return None
    # nothing but a sum of both, so that what is left is the same constant in every motion
    if any(symbols_in(e.diff(s)) & ({*coordinates.values()} | fixed) for s in fixed):
        return None
    return sp.Add(e.xreplace(dict.fromkeys(fixed, sp.S.Zero)), -CONSTANT)


def _up_to_a_constant(components: Sequence[sp.Expr], solution: Solution) -> tuple[sp.Expr, ...]:
    """A finite relation as one with an arbitrary constant, if constraints, all of them on velocities, require that."""
    configuration = solution.own.configuration
    used = {s for e in components for s in symbols_in(e)}
    moving = {*configuration.slots.coordinates}
    if configuration.finite_constraints or not used & moving or any(base(s) != s for s in used):
        return ()
    if displaced_coordinates(components, tuple(moving)) or CONSTANT in used:
        return ()
    stated = tuple(e - CONSTANT for e in components)
    return stated if _judged(stated, solution)[0] is Verdict.EQUIVALENT else ()


def _judged(components: Sequence[sp.Expr], solution: Solution) -> tuple[Verdict, str]:
    """The verdict on one statement, with a diagnosis or a remark."""
    if all(e == 0 for e in components):
        return Verdict.TRIVIAL, _IDENTITY
    view = _view(components, solution)
    if view is None:
        return Verdict.UNREADABLE, MIXED_CHOICES
    configuration = view.configuration
    conditions = [c for e in components for c in _conditions(e, configuration)]
    result = compare(conditions, System(configuration, ()))
    if result is None:
        return Verdict.UNDECIDED, UNDECIDED
    right = all(s is Standing.CONSTRAINT for s in result.standings)
    return (Verdict.EQUIVALENT, "") if right else (Verdict.WRONG, _NOT_REQUIRED)


def _changed(components: Sequence[sp.Expr], solution: Solution) -> str:
    """Which one change makes a wrong statement right, in a sentence; empty if none does."""
    from lagrange.answers.results.constraints import explained_constraint

    moving = [q for v in solution.views for q in v.configuration.slots.coordinates]
    configuration = solution.own.configuration
    rows = [row.velocity_form(configuration.slots) for row in configuration.rows if row.nonlinear is None]

    def holds(e: sp.Expr) -> bool:
        return _judged((e,), solution)[0] is Verdict.EQUIVALENT or bool(_up_to_a_constant((e,), solution))

    return explained_constraint(components, moving, rows, holds)


def _conditions(e: sp.Expr, configuration: Configuration) -> Sequence[sp.Expr]:
    """The conditions that a statement imposes on states: without displacements, with f = const differentiated."""
    e = configuration.rewritten(e)
    if CONSTANT in e.free_symbols:
        return (configuration.slots.time_derivative(e.xreplace({CONSTANT: sp.S.Zero})),)
    return without_displacements(e, configuration)


def _view(components: Sequence[sp.Expr], solution: Solution) -> InCoordinates | None:
    """The coordinates in which a statement is: the file's own, or those of a choice, with which it may be mixed."""
    moving = {q for v in solution.views for q in v.configuration.slots.coordinates}
    used = {base(s) for e in components for s in symbols_in(e)} & moving
    used |= displaced_coordinates(components, tuple(moving))
    for view in solution.views:
        if used <= {*view.configuration.slots.coordinates, *view.configuration.expressed}:
            return view
    return None


def _missing(components: Sequence[sp.Expr], solution: Solution) -> int:
    """How many independent equations are missing between the displacements of the coordinates that occur."""
    view = _view(components, solution)
    if view is None:
        return 0
    configuration = view.configuration
    slots = configuration.slots
    own = {*solution.own.configuration.slots.coordinates}
    used = {base(s) for e in components for s in symbols_in(e)} & {*slots.coordinates, *configuration.expressed}
    used |= displaced_coordinates(components, (*slots.coordinates, *configuration.expressed))
    columns = [*slots.coordinates]
    if used & own - {*columns}:
        columns += [q for q in configuration.expressed if q not in columns]
    rows = [[configuration.rewritten(c) for c in _coefficients(e, columns)] for e in components]

    def at(point: Point) -> int:
        return point.rank(point.matrix(rows))

    rank = agreed_in_motion(configuration, at, [c for row in rows for c in row])
    free = len(view.elimination.independent)
    return 0 if rank is None else max(0, len(columns) - free - rank)


def _coefficients(e: sp.Expr, columns: Sequence[sp.Symbol]) -> list[sp.Expr]:
    """The coefficients of the displacements in a statement about them."""
    used = symbols_in(e)
    for kind in (variation, differential, prime):
        if any(kind(q) in used for q in columns):
            return [e.diff(kind(q)) for q in columns]
    return [e.diff(q) for q in columns]


# In words


_FREEDOM = (
    r"(?:\bD\.?O\.?F\.?s?\b|\bdof\b|degrees?[- ]of[- ]freedom"
    r"|Freiheitsgrade?n?|degrés?\s+de\s+liberté|grados?\s+de\s+libertad)"
)
_WORDS = {"one": 1, "two": 2, "three": 3, "four": 4, "five": 5, "six": 6, "single": 1, "zero": 0, "no": 0}
_WORDS |= {
    "ein": 1,
    "einen": 1,
    "zwei": 2,
    "drei": 3,
    "vier": 4,
    "fünf": 5,
    "sechs": 6,
    "deux": 2,
    "trois": 3,
    "cinq": 5,
}
_COUNT = rf"(?:[0-9]{{1,2}}|\b(?:{'|'.join(_WORDS)})\b)"
_BEFORE = re.compile(
    rf"(?<![\^\w.{{])(?P<count>{_COUNT})[ \t]*(?:\$|\\\))?\s*(?:(?:independent|Stück)\s+)?{_FREEDOM}", re.IGNORECASE
)
_AFTER = re.compile(
    rf"{_FREEDOM}\W{{0,4}}\s*(?:\([^()]{{0,20}}\)\s*)?(?:[:=]|is|are|ist|sind|beträgt|est)?\s*"
    rf"(?P<sum>(?:(?!{_FREEDOM})[^\n.;,]){{0,60}}?=\s*)?(?:\$|\\\()?\s*(?:f\s*=\s*)?(?P<count>{_COUNT}(?:\s*[-−–+]\s*[0-9]{{1,2}})*)(?P<result>\s*=\s*[0-9]{{1,2}})?(?![0-9]|\.[0-9])",
    re.IGNORECASE,
)
_LETTER = re.compile(
    r"(?<![A-Za-z\\_])(?:f|n|s)\s*=\s*(?P<chain>[0-9]{1,2}(?:\s*(?:\\cdot|[-−–+·*=])\s*[0-9]{1,2})*)(?![0-9.A-Za-z/*^])"
)
_CLASS = re.compile(
    r"(?P<not>\b(?:not|nicht|non|no|pas)\b[\s-]*|\b(?:an|nicht|non)-?)?(?P<word>holonom|scleronom|skleronom|rheonom|catastati|acatastati|akatastati|katastati)",
    re.IGNORECASE,
)
_NAMES = {
    "holonom": ("holonomic", "nonholonomic"),
    "scleronom": ("scleronomic", "rheonomic"),
    "skleronom": ("scleronomic", "rheonomic"),
    "rheonom": ("rheonomic", "scleronomic"),
    "catastati": ("catastatic", "acatastatic"),
    "katastati": ("catastatic", "acatastatic"),
    "acatastati": ("acatastatic", "catastatic"),
    "akatastati": ("acatastatic", "catastatic"),
}
_MOVING = re.compile(r"['\u0307\u0308δ^²]|dot|[xyz]_?[0-9]")


def stated_in_words(text: str) -> Answers:
    """The number of degrees of freedom and the classes that a text states."""
    text = text[:LONGEST_IN_WORDS]
    classes: dict[str, None] = {}
    for m in _CLASS.finditer(text):
        positive, negative = _NAMES[m["word"].lower()]
        classes[negative if m["not"] else positive] = None
    for pair in (("holonomic", "nonholonomic"), ("scleronomic", "rheonomic"), ("catastatic", "acatastatic")):
        if all(word in classes for word in pair):  # `z = R is the only holonomic one` is about single constraints
            classes = {word: None for word in classes if word not in pair}
    return Answers(degrees_of_freedom=_freedom(text), classification=tuple(classes))


def is_about_freedom(fragment: Fragment) -> bool:
    """Whether an equation is about numbers of degrees of freedom, of coordinates or of constraints alone."""
    beside = f"{fragment.text} {getattr(fragment, 'beside', '')}"
    turned = f"{getattr(fragment, 'beside', '')} {fragment.text}"
    counts = _freedom(beside) is not None or _freedom(turned) is not None
    return counts and _MOVING.search(fragment.text) is None and _NUMBER_AFTER.search(fragment.text) is not None


_NUMBER_AFTER = re.compile(r"=[\s$&({]*[-+]?[0-9]")


def _freedom(text: str) -> int | None:
    counts = counts_of_freedom(text)
    if not counts:
        counts = [(m.start(), _sum(m["chain"].split("=")[-1])) for m in _LETTER.finditer(text)]
    return max(counts)[1] if counts else None


def counts_of_freedom(text: str) -> list[tuple[int, int]]:
    """Where a text says how many degrees of freedom there are, and how many."""
    counts: list[tuple[int, int]] = []
    for m in _BEFORE.finditer(text):
        counts.append((m.start(), _number(m["count"])))
    for m in _AFTER.finditer(text):
        if not any(abs(at - m.start()) < len(m[0]) and at < m.start() for at, _ in counts):
            counted = _sum(m["count"])
            counts.append((m.start(), int(m["result"].strip(" =")) if m["result"] else counted))
    return counts


def _number(word: str) -> int:
    return int(word) if word.isdigit() else _WORDS[word.lower()]


def _sum(text: str) -> int:
    """The value of `6 - 1`."""
    signs = re.split(r"\s*([-−–+])\s*", text.strip())
    value = _number(signs[0]) if signs[0].isdigit() or signs[0].lower() in _WORDS else 0
    for sign, number in zip(signs[1::2], signs[2::2], strict=True):
        value += int(number) if sign == "+" else -int(number)
    return value
