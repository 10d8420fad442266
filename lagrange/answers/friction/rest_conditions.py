"""The conditions of rest of an answer: are they those that were derived?

Two conditions a ≥ 0 and b ≥ 0 are the same if a/b has a positive sign where angles are acute. If the conditions are not
the same one by one, both sets are tried at random numbers: a clear difference anywhere is an error. Sets that agree at
all of them are equivalent if each limit that is stated, `alpha = atan(mu)`, is exactly one that was derived, and
undecided otherwise.
"""

from __future__ import annotations

import math
import random
import re
from collections.abc import Iterator, Mapping, Sequence, Set
from dataclasses import replace
from itertools import islice, product

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError, is_zero
from lagrange.answers.friction.related_coordinates import dependent, on_relations, relations, restates_constraints
from lagrange.answers.limits import BESIDE_REST, CLEAR_SLACK, FIRST_REST_SAMPLES, MOST_WAYS_TO_REST, REST_SAMPLES
from lagrange.answers.readings import decimals_in
from lagrange.answers.references import Reference
from lagrange.answers.results.at_random import approximate, root_near
from lagrange.answers.verdicts import AnswerVerdict, EquationVerdict, Verdict
from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError
from lagrange.core.records import all_hold, any_holds, record
from lagrange.expressions.edits import Draft, closings, cut, cuts
from lagrange.expressions.latex_layout import is_latex
from lagrange.expressions.reader import limit_of
from lagrange.mechanics.equilibrium.friction.balance import RoughContact
from lagrange.mechanics.equilibrium.friction.friction_at_rest import AtRest
from lagrange.mechanics.equilibrium.friction.linear_inequalities import Signs, shortest
from lagrange.mechanics.equilibrium.friction.rolling import Rolling
from lagrange.mechanics.results import Solution


@record
class _Stated:
    """slack ≥ 0, or slack = 0.

    rounded  the slack with symbols for its decimals; None if it has none
    """

    text: str
    slack: sp.Expr
    equation: bool
    rounded: sp.Expr | None = None


def check_rest_answers(
    stated: Sequence[Fragment], rests: Sequence[AtRest | Rolling], reference: Reference, solution: Solution
) -> AnswerVerdict:
    """The verdict on conditions; the best one in any set of coordinates."""
    try:
        if any(_OR.search(f.text) for f in stated):
            alternatives = [[_read(c, reference) for f in way for c in _each(f)] for way in _ways(stated)]
            compared = [_compared_alternatives(alternatives, r, reference.values) for r in rests]
            best = min(compared, key=[*_BEST_FIRST].index)
            return AnswerVerdict(best, name="rest")
        read = [_read(c, reference) for f in stated for c in _each(f)]
    except ProblemError as error:
        equations = tuple(EquationVerdict(f.text, Verdict.UNREADABLE) for f in stated)
        return AnswerVerdict(Verdict.UNREADABLE, equations, unreadable=tuple(error.diagnostics), name="rest")
    verdicts = [_compared(read, r, reference.values) for r in rests]
    if Verdict.EQUIVALENT not in verdicts and (in_tangents := [*map(_in_tangents, read)]) != read:
        verdicts += [_compared(in_tangents, r, reference.values) for r in rests]
    best = next(v for v in _BEST_FIRST if v in verdicts)
    diagnosis = ""
    if best is Verdict.INCOMPLETE:
        diagnosis = next((why for r in rests if (why := _other_limit(read, r, reference.values))), "")
        diagnosis = diagnosis or "some conditions are missing"
    one = any(_are_of_one_case(*_in_parts(read, r, reference.values)) for r in rests)
    if best is Verdict.INCOMPLETE and one:
        diagnosis = "this is one of several cases in which it can be at rest"
    elif best in (Verdict.WRONG, Verdict.INCOMPLETE):
        diagnosis = next(
            filter(None, (_explained(read, r, best, solution, reference.values) for r in rests)), diagnosis
        )
    return AnswerVerdict(best, name="rest", diagnosis=diagnosis)


_BEST_FIRST = (Verdict.EQUIVALENT, Verdict.INCOMPLETE, Verdict.UNDECIDED, Verdict.WRONG)
_OR = re.compile(r"(?<![\w\\])or(?!\w)|\\(?:text|mathrm|mbox)\s*\{\s*or\s*\}")


def _ways(stated: Sequence[Fragment]) -> list[list[Fragment]]:
    """The sets of conditions that are stated with `or` between them. Raises ProblemError if there are too many."""
    ways = [[*way] for way in islice(product(*(pieces(f, _OR) for f in stated)), MOST_WAYS_TO_REST + 1)]
    if len(ways) > MOST_WAYS_TO_REST:
        message = f"an answer may have {MOST_WAYS_TO_REST} sets of conditions"
        raise ProblemError(Diagnostic("too-many-equations", message, stated[0].whole))
    return ways


def _in_tangents(s: _Stated) -> _Stated:
    """θ ≤ atan(u) as tan θ ≤ u, the same for −π/2 < θ < π/2, and atan v ≤ atan u as v ≤ u: divisors are seen there."""
    terms = sp.Add.make_args(s.slack)
    (c, first), (d, second) = (terms[0].as_coeff_Mul(), terms[-1].as_coeff_Mul())
    if len(terms) == 2 and c == -d and isinstance(first, sp.atan) and isinstance(second, sp.atan):
        return replace(s, slack=sp.sign(c) * (first.args[0] - second.args[0]), rounded=None)
    for term, other in (terms, terms[::-1]) if len(terms) == 2 else ():
        factor, inverse = term.as_coeff_Mul()
        if isinstance(inverse, sp.atan) and factor != 0 and (angle := -other / factor).is_Symbol:
            return replace(s, slack=sp.sign(factor) * (inverse.args[0] - sp.tan(angle)), rounded=None)
    return s


def _explained(
    stated: Sequence[_Stated],
    rest: AtRest | Rolling,
    verdict: Verdict,
    solution: Solution,
    values: Mapping[sp.Symbol, sp.Rational],
) -> str:
    """What wrong conditions are instead, or which sense of friction is missing; empty if that is not found, or one of
    several cases has to hold."""
    from lagrange.answers.results import conditions
    from lagrange.answers.results.conditions import belt_meanings

    given, cases = _in_parts(stated, rest, values)
    if len(cases) != 1:
        return ""
    derived = [c for c in without_implied_conditions(cases[0]) if not c.equation]
    wrong = [s for s in given if not any(_are_same(s, c) or _rounds_to(s, c) for c in derived)]
    if any(_rounds_to(replace(s, slack=-s.slack, rounded=s.rounded and -s.rounded), c) for s in wrong for c in derived):
        return "the inequality has the wrong sense: its limit is right"
    missing = [c.slack for c in derived if not any(_are_same(s, c) for s in given)]
    laws = [c.coefficient if isinstance(c, RoughContact) else c.friction.coefficient for c in rest.contacts]
    laws += [b.belt.coefficient for b in rest.belts] if isinstance(rest, AtRest) else []
    if verdict is Verdict.WRONG:
        if isinstance(rest, Rolling) and (reason := _of_another_body(wrong, solution)):
            return reason
        parts = [conditions.StatedCondition(s.text, s.slack, s.equation) for s in wrong]
        reason = conditions.explained_conditions(parts, missing, laws)
        if reason and conditions.ONLY_A_NUMBER not in reason:
            return reason
        for meaning in belt_meanings(missing, laws) if any(s.rounded is not None for s in wrong) else ():
            changed = [_Stated("", m.xreplace(dict(meaning.rule)), False) for m in missing]
            if all(any(_rounds_to(s, c) for c in changed) for s in wrong):
                return f"this is the condition {meaning.clause}"
        if any(s.equation for s in wrong):
            return reason
        return conditions.explained_by_another_solution(parts, solution) or reason
    other_sense = missing and all(any(conditions.is_other_sense(m, s.slack, laws) for s in given) for m in missing)
    return "some conditions are missing: friction may act the other way as well" if other_sense else ""


_RELATION = re.compile(r"[<>]=?|[≤≥⩽⩾]|\\[gl]e(?:q(?:slant)?)?(?![A-Za-z])|(?<![<>])=|≈|\\approx(?![A-Za-z])")
_EQUAL = re.compile(r"=|≈|\\approx")
_AND = re.compile(
    r"(?<!\\)[,;]|\b(?:and|und)\b|(?<=\s)et(?=\s)|∧|\\(?:land|wedge)(?![A-Za-z])|\\(?:text|mathrm|mbox)\s*\{\s*(?:and|und|et)\s*\}|\\q?quad(?![A-Za-z])"
)
_EXTREME = re.compile(r"\s*\\?(?P<which>min|max|Min|Max)\s*(?:\\left\s*)?(?P<open>[({\[]|\\\{)")


def _each(fragment: Fragment) -> Iterator[Fragment]:
    """The conditions in a text: a <= b <= c is two, and so are `a and b` and a <= min(b, c)."""
    parts = pieces(fragment, _AND)
    if not all(_RELATION.search(p.text) for p in parts):
        parts = [fragment]
    for part in parts:
        signs = [*_RELATION.finditer(part.text)]
        bounds = [0, *(m.end() for m in signs), len(part.text)]
        for n in range(max(1, len(signs))):
            start, end = bounds[n], signs[n + 1].start() if n + 1 < len(signs) else len(part.text)
            draft = Draft(part)
            bound = next((k for k in range(n, -1, -1) if not _EQUAL.fullmatch(signs[k][0])), n) if signs else n
            if bound < n:  # mu >= log(50)/(4 pi) = 0.311 is also mu >= 0.311
                start = bounds[bound]
                draft.apply([(signs[bound].end(), signs[n].end(), " ")])
            draft.keep(start, end - len(part.text) + len(draft.text))
            yield from _without_extremes(draft.finished(latex=is_latex(part)))


def pieces(fragment: Fragment, separator: re.Pattern[str]) -> list[Fragment]:
    """What stands between separators, as far as there is anything."""
    return [cut(fragment, *place) for place in cuts(fragment.text, separator) if fragment.text[slice(*place)].strip()]


def _without_extremes(condition: Fragment) -> list[Fragment]:
    """`a <= min(b, c) d` as a <= (b) d and a <= (c) d: a minimum as an upper bound, a maximum as a lower one."""
    sign = _RELATION.search(condition.text)
    if sign is None or sign[0] == "=":
        return [condition]
    less = sign[0] in ("<", "<=", "≤", "⩽") or sign[0].startswith("\\l")
    for start, end, bound in ((0, sign.start(), not less), (sign.end(), len(condition.text), less)):
        extreme = _EXTREME.search(condition.text, start, end)
        if extreme is None or (extreme["which"].lower() == "min") is not bound:
            continue
        close = closings(condition.text).get(extreme.end() - 1)
        if close is None or close >= end:
            continue
        within = _CLOSES.sub("", condition.text[extreme.end() : close])
        inside = [(extreme.end() + a, extreme.end() + b) for a, b in cuts(within, _COMMA)]
        drafts = []
        for a, b in inside:
            draft = Draft(condition)
            draft.apply([(extreme.start(), close + 1, f" ({condition.text[a:b]})")])
            drafts.append(draft.finished(latex=is_latex(condition)))
        return drafts
    return [condition]


_COMMA = re.compile(",")
_CLOSES = re.compile(r"(?:\\right\s*)?\\?\Z")
"""What belongs to a closing bracket of LaTeX, before it."""


def _read(fragment: Fragment, reference: Reference) -> _Stated:
    from lagrange.answers.written.reading import read_as_written
    from lagrange.answers.written.values import with_value_in_si

    limit, side = limit_of(fragment, "a condition", strict=True)
    limit = with_value_in_si(limit, reference)
    reading = read_as_written(limit, reference.scope)
    if reading.error is not None:
        raise reading.error
    [difference] = reading.components
    rounded = reading.with_decimals[0] * (side or 1) if reading.with_decimals else None
    return _Stated(fragment.text.strip(), difference * (side or 1), side is None, rounded)


def _of_another_body(stated: Sequence[_Stated], solution: Solution) -> str:
    """The conditions of rolling for another moment of inertia, as a sentence; empty if they are none."""
    from lagrange.answers.results.conditions import is_limit
    from lagrange.answers.results.meanings import other_bodies

    others = other_bodies(solution)
    if others is None or not stated:
        return ""
    solved, changes = others
    limits = [c.right - c.left for v in solved.views if v.rolling for case in v.rolling.cases for c in case]
    for clause, rule in changes:
        changed = [e.xreplace(dict(rule)) for e in limits]
        if all(any(is_limit(c, s.slack) for c in changed) for s in stated):
            return f"this is the condition {clause}"
    return ""


def _in_parts(
    stated: Sequence[_Stated], rest: AtRest | Rolling, values: Mapping[sp.Symbol, sp.Rational]
) -> tuple[list[_Stated], list[list[_Stated]]]:
    """The stated conditions and those of each case, in the same coordinates and without absolute values."""
    numbers = dict(values)
    forces = dict(rest.forces) if isinstance(rest, AtRest) else {}  # |F| <= mu*N, with N as it is at rest

    def valued(e: sp.Expr) -> sp.Expr:
        return rest.configuration.rewritten(e.xreplace(forces)).xreplace(numbers)

    given = [
        part
        for s in stated
        for part in _without_modulus(
            _multiplied_out(_Stated(s.text, valued(s.slack), s.equation, s.rounded and valued(s.rounded)))
        )
    ]
    always = [s for s in given if not s.equation and Signs(_symbols(s.slack)).of(s.slack) == 1]  # 0 <= P
    given = [s for s in given if s not in always] or given
    given = [
        s for s in given if not (s.equation and restates_constraints(s.slack, rest.configuration, values))
    ] or given
    cases = [
        [
            *(
                part
                for c in case
                for part in _without_modulus(_Stated("", valued(c.right - c.left), c.relation == "="))
            ),
            *(_Stated("", valued(e), True) for e in rest.equations),
        ]
        for case in rest.cases
    ]
    return given, cases


def _other_limit(stated: Sequence[_Stated], rest: AtRest | Rolling, values: Mapping[sp.Symbol, sp.Rational]) -> str:
    """Which limit is missing where one is stated: P <= ... of P_min <= P <= P_max; empty if that is not all."""
    given, cases = _in_parts(stated, rest, values)
    sides = [_side_of_one(given, [s]) for s in given]
    [first, *others] = sides or [None]
    if len(cases) != 1 or first is None or any(o != first for o in others):
        return ""
    symbol, upper = first
    if not any(_side_of_one(given, [c]) == (symbol, not upper) for c in cases[0]):
        return ""
    return f"{symbol.name} has {'a lower' if upper else 'an upper'} limit as well"


def _side_of_one(given: Sequence[_Stated], parts: Sequence[_Stated]) -> tuple[sp.Symbol, bool] | None:
    """The stated letter that a condition bounds, and whether from above; None if there is no such letter."""
    [part] = parts
    for s in sorted(set.intersection(*(_symbols(g.slack) for g in given)), key=str):
        rate = part.slack.diff(s)
        sense = Signs(_symbols(rate)).of(rate) if s not in rate.free_symbols else None
        if sense in (1, -1) and not part.equation:
            return s, sense == -1
    return None


def _compared(stated: Sequence[_Stated], rest: AtRest | Rolling, values: Mapping[sp.Symbol, sp.Rational]) -> Verdict:
    given, cases = _in_parts(stated, rest, values)
    if len(cases) == 1:
        cases = [without_implied_conditions(cases[0])]
        same = [{n for n, c in enumerate(cases[0]) if _are_same(s, c) or _rounds_to(s, c)} for s in given]
        matched = set().union(*same) if same else set()
        if all(same) and len(matched) == len(cases[0]):
            return Verdict.EQUIVALENT
        if given and all(same) and _holds_if_positive([c for n, c in enumerate(cases[0]) if n not in matched], given):
            return Verdict.EQUIVALENT
    return _at_random([given], cases, rest, values)


def _compared_alternatives(
    alternatives: Sequence[Sequence[_Stated]], rest: AtRest | Rolling, values: Mapping[sp.Symbol, sp.Rational]
) -> Verdict:
    """The verdict on sets of conditions one of which is to hold."""
    parts = [_in_parts(a, rest, values) for a in alternatives]
    return _at_random([given for given, _ in parts], parts[0][1], rest, values)


def _at_random(
    alternatives: Sequence[Sequence[_Stated]],
    cases: Sequence[Sequence[_Stated]],
    rest: AtRest | Rolling,
    values: Mapping[sp.Symbol, sp.Rational],
) -> Verdict:
    given = [c for a in alternatives for c in a]
    weaker = stronger = False
    seen = set()
    conditions = [c for case in (*cases, given) for c in case]
    constraints = relations([c.slack for c in conditions], rest.configuration, values)
    for drawn in _points(conditions, constraints):
        point = on_relations(drawn, constraints)
        if point is None:
            continue
        derived = _any_case(cases, point)
        claimed = _any_case(alternatives, point)
        if derived is None or claimed is None:
            continue
        seen.add(derived)
        weaker = weaker or (claimed and not derived)
        stronger = stronger or (derived and not claimed)
    if stronger:
        return Verdict.INCOMPLETE if not weaker and _are_of_one_case(given, cases) else Verdict.WRONG
    if weaker:
        known = cases[0] if len(cases) == len(alternatives) == 1 else []
        partly = known and given and all(any(_are_same(s, c) or _rounds_to(s, c) for c in known) for s in given)
        return Verdict.INCOMPLETE if partly else Verdict.WRONG
    rule = dependent(constraints)

    def put_in(c: _Stated) -> _Stated:
        return replace(c, slack=c.slack.xreplace(rule), rounded=c.rounded and c.rounded.xreplace(rule))

    needed, stated_ones = ([*map(put_in, cs)] for cs in ([c for case in cases for c in case], given))

    def is_exact(s: _Stated) -> bool:
        return any(
            _are_same(s, c) or _has_limit(s, c) or _has_limit(c, s) or _rounds_to(s, c) or _are_same(s, _squared(c))
            for c in needed
        ) or (len(alternatives) > 1 and _is_a_case(s, needed))

    exact = all(map(is_exact, stated_ones))
    return Verdict.EQUIVALENT if seen == {True, False} and exact else Verdict.UNDECIDED


def _are_of_one_case(given: Sequence[_Stated], cases: Sequence[Sequence[_Stated]]) -> bool:
    """Whether conditions are those of one of several cases: P ≤ μ (W − P) of P ≤ μ |W − P|, or μν ≥ 1."""
    if given and any(all(_is_a_case(s, case) for s in given) for case in cases):
        return True
    single = [one for case in cases for one in _by_signs(case)]
    return len(single) > 1 and any(
        all(any(_are_same(s, c) for c in case) for s in given)
        and all(any(_are_same(s, c) for s in given) for c in case)
        for case in single
    )


def _is_a_case(s: _Stated, case: Sequence[_Stated]) -> bool:
    """Whether the sign of a factor in a derived condition is stated, of 1 − μν in (1 − μν) tan θ ≤ 2μ."""
    factors = {f for c in case for term in sp.Add.make_args(c.slack) for f in sp.Mul.make_args(term) if f.is_Add}
    return any(sp.cancel(f / s.slack).is_number for f in factors if f.free_symbols == s.slack.free_symbols)


def _squared(c: _Stated) -> _Stated:
    """P² ≤ μ² (W − P)² for P ≤ μ |W − P|, where both sides are positive."""
    terms = sp.Add.make_args(c.slack)
    if len(terms) != 2 or sorted(Signs(_symbols(e)).of(e) or 0 for e in terms) != [-1, 1]:
        return c
    greater, less = sorted(terms, key=lambda e: Signs(_symbols(e)).of(e) or 0, reverse=True)
    return replace(c, slack=sp.expand(greater**2 - less**2), rounded=None)


def _by_signs(case: Sequence[_Stated]) -> Iterator[Sequence[_Stated]]:
    """A case that contains an absolute value as two cases, one for each sign of its argument."""
    moduli = set[sp.Expr]().union(*(c.slack.atoms(sp.Abs) for c in case))
    if len(moduli) != 1:
        yield case
        return
    [modulus] = moduli
    for sign in (1, -1):
        yield [replace(c, slack=c.slack.xreplace({modulus: sign * modulus.args[0]})) for c in case]


def without_implied_conditions(case: Sequence[_Stated]) -> list[_Stated]:
    """The conditions without those that another one implies, where they limit one letter in numbers: P <= 117.7 makes
    P <= 137.3 needless."""
    limits = [_in_numbers(c) for c in case]
    return [
        c
        for n, (c, own) in enumerate(zip(case, limits, strict=True))
        if own is None
        or not any(
            other is not None
            and other[:2] == own[:2]
            and k != n
            and (
                own[2] - other[2] > CLEAR_SLACK * abs(own[2])
                or (k < n and abs(own[2] - other[2]) <= CLEAR_SLACK * abs(own[2]))
            )
            for k, other in enumerate(limits)
        )
    ]


def _in_numbers(c: _Stated) -> tuple[sp.Symbol, int, float] | None:
    """The letter, the sense, and the limit times the sense, of sense (limit - letter) >= 0 in numbers."""
    symbols = _symbols(c.slack)
    rate = c.slack.diff(*symbols) if len(symbols) == 1 and not c.equation else sp.S.Zero
    if rate == 0 or not rate.is_number:
        return None
    [s] = symbols
    sense = -1 if approximate(rate, {}) > 0 else 1
    return s, sense, sense * approximate(c.slack, {s: 0.0}) / -approximate(rate, {})


def _holds_if_positive(missing: Sequence[_Stated], given: Sequence[_Stated]) -> bool:
    """Whether conditions that are not stated hold for any positive force: -P_max <= P beside P <= P_max, where P is the
    size of the force that the book asks for."""
    stated = set[sp.Symbol]().union(*(_symbols(g.slack) for g in given))
    letters = {s for s in stated if not s.is_positive}
    positive = {s: sp.Dummy(positive=True) for s in letters}
    return bool(missing) and all(
        not c.equation
        and _symbols(c.slack) & letters
        and Signs({s for s in _symbols(c.slack) if s not in letters}).of(c.slack.xreplace(positive)) in (0, 1)
        for c in missing
    )


def _multiplied_out(s: _Stated) -> _Stated:
    """P ≤ W (tan α + μ)/(1 − μ tan α) as (1 − μ tan α) P ≤ W (tan α + μ), which assumes a positive divisor."""
    slack = sp.expand_trig(s.slack) if s.slack.has(sp.atan) else s.slack
    divisors = {p.base for p in slack.atoms(sp.Pow) if p.exp == -1 and p.base.is_Add}  # as they are written
    open_ = [f for f in divisors if Signs(_symbols(f)).of(f) is None]
    if not open_ or s.equation:
        return s
    return replace(s, slack=sp.cancel(sp.together(slack * sp.Mul(*open_))))


def _symbols(e: sp.Expr) -> set[sp.Symbol]:
    return {x for x in e.free_symbols if isinstance(x, sp.Symbol)}


def _without_modulus(s: _Stated) -> tuple[_Stated, ...]:
    """B ≥ |A| as B ≥ A and B ≥ −A."""
    moduli = [m for m in s.slack.atoms(sp.Abs) if not m.args[0].has(sp.Abs)]
    if s.equation or len(moduli) != 1:
        return (s,)
    [modulus] = moduli
    rate = sp.expand(s.slack).coeff(modulus, 1)
    rest = sp.expand(s.slack - rate * modulus)
    if rest.has(modulus) or rate.has(modulus) or Signs(_symbols(rate)).of(rate) != -1:
        return (s,)
    return tuple(replace(s, slack=rest + sign * rate * modulus.args[0]) for sign in (1, -1))


def _are_same(a: _Stated, b: _Stated) -> bool:
    if a.equation is not b.equation or a.slack == 0 or b.slack == 0:
        return False
    if not a.equation and _differ(a.slack, b.slack):
        return False
    symbols = a.slack.free_symbols | b.slack.free_symbols
    try:
        sign = Signs({s for s in symbols if isinstance(s, sp.Symbol)}).of(shortest(a.slack / b.slack))
    except ZeroDivisionError:
        return False
    return sign is not None and (sign == 1 or a.equation)


def _differ(a: sp.Expr, b: sp.Expr) -> bool:
    """Whether one is positive where the other is negative, clearly: soon found, unlike the sign of their ratio."""
    letters = sorted(_symbols(a) | _symbols(b), key=str)
    draw = random.Random(7)
    points = ({s: draw.uniform(0.1, 1.5) for s in letters} for _ in range(FIRST_REST_SAMPLES))
    return any(approximate(a, p) * approximate(b, p) < -CLEAR_SLACK for p in points)


def _rounds_to(a: _Stated, b: _Stated) -> bool:
    """Whether the limit of a condition with one decimal is, rounded, that of another: μ ≥ 0.31 for μ ≥ 0.3113.

    At the limit of the other, the number that would make the stated one exact must round to the decimal.
    """
    if a.rounded is None or a.equation or b.equation:
        return False
    decimals = sorted(decimals_in([a.rounded]), key=str)
    names = sorted(_symbols(b.slack) & _symbols(a.slack), key=str)
    if len(decimals) != 1 or not names:
        return False
    [decimal], unknown = decimals, names[0]
    slope = a.rounded.diff(decimal)
    if decimal in slope.free_symbols:
        return False
    exact = (decimal * slope - a.rounded) / slope
    is_angle = any(unknown in f.free_symbols for f in b.slack.atoms(sp.sin, sp.cos, sp.tan, sp.cot))
    seen = 0
    for point in islice(_points([_Stated("", b.slack * a.slack, False)]), 8):
        root = root_near(lambda v, at=point: approximate(b.slack, {**at, unknown: v}), point[unknown])  # type: ignore[misc]
        if root is None or (is_angle and not 0 < root < math.pi / 2):
            continue
        at, near = {**point, unknown: root}, {**point, unknown: root + BESIDE_REST}
        number = approximate(sp.expand(exact), {**at, decimal: 0.0})
        rises = [approximate(e, near) - approximate(e, at) for e in (a.slack, b.slack)]
        rounds = abs(number - float(decimal.written)) <= float(decimal.half_width) * (1 + CLEAR_SLACK)
        if not rounds or not rises[0] * rises[1] > 0:
            return False
        seen += 1
    return seen > 0


def _has_limit(a: _Stated, b: _Stated) -> bool:
    """Whether the limit `s = ...` of one is a limit of the other, exactly."""
    for s in sorted(a.slack.free_symbols, key=str):
        rate = a.slack.diff(s)
        if rate.free_symbols or rate == 0:
            continue
        value = s - a.slack / rate
        try:
            limit = b.slack.xreplace({s: value})
            if is_zero(sp.expand_trig(limit) if value.has(sp.atan) else limit) is True:
                return True
        except (DivisionByZeroError, ZeroDivisionError):
            continue
    return False


def _points(conditions: Sequence[_Stated], related: Sequence[sp.Expr] = ()) -> Iterator[dict[sp.Symbol, float]]:
    """Random numbers: acute angles, positive parameters, other symbols of either sign; also those in relations."""
    symbols = sorted({s for e in (*(c.slack for c in conditions), *related) for s in e.free_symbols}, key=str)
    angles = {
        s for c in conditions for f in c.slack.atoms(sp.sin, sp.cos, sp.tan, sp.cot) for s in f.args[0].free_symbols
    }
    draw = random.Random(20)
    for number in range(REST_SAMPLES):
        point: dict[sp.Symbol, float] = {}
        for s in symbols:
            value = draw.uniform(0.02, 1.55) if s in angles else draw.lognormvariate(0, 0.8)
            if not s.is_positive and s not in angles and draw.random() < 0.5:
                value = -value
            point[s] = value
        yield _near_a_limit(point, conditions, angles, draw) if number % 2 else point


def _near_a_limit(
    point: dict[sp.Symbol, float], conditions: Sequence[_Stated], angles: Set[sp.Symbol], draw: random.Random
) -> dict[sp.Symbol, float]:
    """The point with one letter moved to about its limit: forces are not of order one where weights have values.

    An angle stays acute.
    """
    condition = draw.choice(conditions)
    for s in sorted(_symbols(condition.slack), key=str):
        rate = condition.slack.diff(s)
        if s in rate.free_symbols or rate == 0:
            continue
        slope = approximate(rate, point)
        limit = point[s] - approximate(condition.slack, point) / slope if slope else math.nan
        moved = limit * draw.uniform(0.5, 1.5)
        if math.isfinite(limit) and (limit > 0 or not s.is_positive) and (s not in angles or 0 < moved < math.pi / 2):
            return {**point, s: moved}
    return point


def _any_case(cases: Sequence[Sequence[_Stated]], point: Mapping[sp.Symbol, float]) -> bool | None:
    verdicts = [_all_hold(case, point) for case in cases]
    return any_holds(verdicts)


def _all_hold(conditions: Sequence[_Stated], point: Mapping[sp.Symbol, float]) -> bool | None:
    def holds(c: _Stated) -> bool | None:
        if c.equation:
            return None
        value = approximate(c.slack, point)
        if math.isnan(value):  # a function that is not known in floating point
            exact = c.slack.xreplace({s: sp.Float(v) for s, v in point.items()}).evalf()
            value = float(exact) if exact.is_real else math.nan
        return None if not math.isfinite(value) or abs(value) < CLEAR_SLACK else value > 0

    return all_hold(map(holds, conditions))
