"""Wrong conditions of rest: which changed problem has them.

A condition is slack s ≥ 0, and its limit is s = 0. A stated one is compared with each derived one, changed in the usual
wrong ways: the sense of the inequality, another meaning of a letter (`meanings`), two contacts whose limits are added
up, a factor of one side, one term of the balance. Limits are the same where the value of a letter in which the changed
one is linear makes the stated one vanish: at random numbers first, then exactly.

Wrong conditions of rest and limits of friction where several contacts have one coefficient: which contact is it?

With one letter μ for two contacts a condition does not tell what the friction of each contributes. So the problem is
solved once more, each contact with a coefficient of its own; then the friction of one contact alone may act the other
way, or be omitted: μ_1 → −μ or 0, and μ_k → μ for all others.

Wrong limits of a rope on a rough drum: which of the slips with T = S exp(mu beta) was made.

The coefficient and the angle of contact occur as the product mu beta alone. So the common slips all give mu another
factor: ln for log to base ten, degrees or turns for radians, an angle twice or half as large. Without the exponential,
T = S (1 + mu beta) is the law of a short arc, used for the whole one.
"""

from __future__ import annotations

import random
from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from functools import cached_property, lru_cache

import sympy as sp

from lagrange.algebra.exact.expression_graph import DivisionByZeroError, UnsupportedError
from lagrange.algebra.exact.sampler import NoPointError
from lagrange.algebra.exact.zero_test import is_zero
from lagrange.answers.limits import (
    CLOSE_LIMIT,
    LIMIT_SAMPLES,
    MOST_CONDITION_TERMS,
    MOST_OTHER_CONTACTS,
    UNITS_OF_OTHER_CONTACTS,
)
from lagrange.answers.references import Identical
from lagrange.answers.results.at_random import approximate, root_near
from lagrange.answers.results.meanings import LetterMeaning, other_meanings, with_waves_exchanged
from lagrange.core.diagnostics import ProblemError
from lagrange.core.effort import allowed_for
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.document.math_writer import text
from lagrange.document.names import Notation
from lagrange.mechanics.results import Solution
from lagrange.mechanics.solution import solve
from lagrange.problem.model import AppliedForce, Assumption, Find, Force, Friction, Parameter, Problem


@record
class StatedCondition:
    """A stated condition that is none of the derived ones: its text and its slack; an equation where it vanishes."""

    text: str
    slack: sp.Expr
    equation: bool


def explained_conditions(
    stated: Sequence[StatedCondition], derived: Sequence[sp.Expr], coefficients: Collection[sp.Expr]
) -> str:
    """What the stated conditions are instead, in a sentence; empty if that is not found.

    derived       the slacks of the derived conditions, all of which have to hold
    coefficients  those of friction
    """
    if not stated or not derived:
        return ""
    try:
        for meaning in belt_meanings(derived, coefficients):
            slacks = [d.xreplace(dict(meaning.rule)) for d in derived]
            changed = [_Limit(e) for slack in slacks for e in dict.fromkeys((slack, in_logarithms(slack)))]
            if all(any(limit.is_of(s.slack) for limit in changed) for s in stated):
                return f"this is the condition {meaning.clause}"
    except _unknown:
        pass
    try:
        if (together := _of_all(stated, derived, coefficients)) is not None:
            return together
    except _unknown:
        pass
    reasons: dict[str, dict[str, None]] = {}
    for s in stated:
        try:
            reason = next(_reasons(s, derived, coefficients), "")
        except _unknown:
            continue
        if reason and not any(s.text in texts for texts in reasons.values()):
            reasons.setdefault(reason, {})[s.text] = None
    if len(reasons) == 1 and len({s.text for s in stated}) == len(*reasons.values()):
        return next(iter(reasons))  # all of them have it
    return "; ".join(f"{', '.join(f'`{t}`' for t in texts)}: {reason}" for reason, texts in reasons.items())


_unknown = (NoPointError, UnsupportedError, DivisionByZeroError, ZeroDivisionError, sp.PolynomialError)


def _of_all(
    stated: Sequence[StatedCondition], derived: Sequence[sp.Expr], coefficients: Collection[sp.Expr]
) -> str | None:
    """The one meaning of the letters, or the sense of the inequalities, that makes all stated conditions right."""
    limits = [_Limit(d) for d in derived]
    if any(s.equation for s in stated):
        return None
    if all(any(limit.is_of(s.slack) for limit in limits) for s in stated):
        return _REVERSED
    if len(stated) < 2:
        return None
    for meaning in _meanings(stated, derived, coefficients):
        changed = [_Limit(d.slack.xreplace(dict(meaning.rule))) for d in limits]
        if all(any(c.is_of(s.slack) and c.sense(s.slack) > 0 for c in changed) for s in stated):
            return _scaled_limit(meaning, stated[0].slack) or f"these are the conditions {meaning.clause}"
    return None


def _scaled_limit(meaning: LetterMeaning, slack: sp.Expr) -> str:
    """P <= 2 W for P <= W: with P/2 instead of P; empty for other changes."""
    [(letter, value), *others] = meaning.rule.items()
    factor = value / letter
    if others or not factor.is_Rational or factor <= 0 or not isinstance(letter, sp.Symbol):
        return ""
    rate = sp.diff(slack, letter)
    if letter in rate.free_symbols or rate == 0:
        return ""
    return f"{ONLY_A_NUMBER}{letter} is {_TIMES.get(1 / factor, f'{1 / factor} times')} what it should be"


def _meanings(
    stated: Sequence[StatedCondition], derived: Sequence[sp.Expr], coefficients: Collection[sp.Expr]
) -> list[LetterMeaning]:
    letters, used = (set().union(*map(_symbols, es)) for es in (derived, [s.slack for s in stated]))
    return [*with_waves_exchanged(derived), *other_meanings(letters, used, coefficients)]


def explained_limits(
    stated: Sequence[StatedCondition], derived: Sequence[sp.Expr], coefficients: Collection[sp.Expr]
) -> str:
    """The same for limits that are stated as equations: friction is about to give way."""
    reasons = explained_conditions([replace(s, equation=False) for s in stated], derived, coefficients)
    if _REVERSED in reasons or _AND_REVERSED in reasons:
        return ""
    return reasons.replace("this is the condition", "this is the limit").replace(
        "these are the conditions", "these are the limits"
    )


def is_limit(slack: sp.Expr, stated: sp.Expr) -> bool:
    """Whether a stated slack vanishes at the limit of another."""
    try:
        return _Limit(slack).is_of(stated)
    except _unknown:
        return False


def is_other_sense(missing: sp.Expr, stated: sp.Expr, coefficients: Collection[sp.Expr]) -> bool:
    """Whether a condition is another one for friction that acts the other way."""
    rule = {mu: -mu for mu in coefficients}
    return bool(rule) and _Limit(missing.xreplace(rule)).is_of(stated)


def _reasons(stated: StatedCondition, derived: Sequence[sp.Expr], coefficients: Collection[sp.Expr]) -> Iterator[str]:
    known = [_Limit(d) for d in derived]
    for limit in known:
        if limit.is_of(stated.slack):
            yield _AN_EQUATION if stated.equation else _REVERSED
    for meaning in with_waves_exchanged(derived):
        exchanged = (_without_cotangents(limit.slack.xreplace(dict(meaning.rule))) for limit in known)
        if any(_Limit(e).is_of(_without_cotangents(stated.slack)) for e in exchanged):
            yield f"this is the condition {meaning.clause}"
    angles = {
        w: w.xreplace({mu: sp.atan(mu) for mu in coefficients}) for w in stated.slack.atoms(sp.sin, sp.cos, sp.tan)
    }
    with_angles = stated.slack.xreplace(angles)
    if with_angles != stated.slack and any(limit.is_of(_in_tangents(with_angles)) for limit in known):
        named = ", ".join(sorted(mu.name for mu in coefficients if mu in stated.slack.free_symbols))
        yield f"{named} is taken for the angle of friction, which is atan({named})"
    for limit in known:
        yield from _of_sides(stated.slack, limit.slack)
    meanings = _meanings([stated], derived, coefficients)
    for limit in known:
        for meaning in meanings:
            if limit.slack.free_symbols.isdisjoint(meaning.rule):
                continue
            changed = _Limit(limit.slack.xreplace(dict(meaning.rule)))
            if changed.is_of(stated.slack):
                reversed_ = not stated.equation and changed.sense(stated.slack) < 0
                said = _scaled_limit(meaning, stated.slack) or f"this is the condition {meaning.clause}"
                yield f"{said}{_AND_REVERSED if reversed_ else ''}"
    for n, a in enumerate(known):
        for b in known[:n]:
            if (total := a.added(b)) is not None and total.is_of(stated.slack):
                yield _ADDED
    for limit in known:
        yield from _of_terms(stated.slack, limit.slack, coefficients)
    for limit in known:
        yield from _of_directions(stated.slack, limit.slack)


_REVERSED = "the limit is right, but the inequality has the wrong sense"
_AND_REVERSED = ", and with the wrong sense of the inequality"
_AN_EQUATION = "this is the limit, and not the range in which the system rests"
_ADDED = "the limits of two contacts are added: each of them has to hold by itself"


@record
class _Limit:
    """slack = 0."""

    slack: sp.Expr

    @cached_property
    def solved(self) -> tuple[sp.Symbol, sp.Expr] | None:
        """A letter in which the limit is linear, and its value there; None if there is none."""
        for form in (self.slack, _cleared(self.slack)):
            for s in sorted(_symbols(form), key=str):
                rate = sp.diff(form, s)
                if s not in rate.free_symbols and rate != 0:
                    return s, s - form / rate
        return None

    def is_of(self, other: sp.Expr) -> bool:
        """Whether another slack vanishes at this limit: at random numbers, then exactly."""
        shared = sorted(_symbols(self.slack) & _symbols(other), key=str)
        if shared and _cleared(self.slack) in (_cleared(other), _cleared(-other)):
            return True
        if not shared or not all(self._seems_of(other, shared, seed) for seed in range(LIMIT_SAMPLES)):
            return False
        if self.solved is None or self.solved[0] not in other.free_symbols:
            return False
        letter, value = self.solved
        return is_zero(sp.expand(other.xreplace({letter: value}))) is True

    def _seems_of(self, other: sp.Expr, letters: Sequence[sp.Symbol], seed: int) -> bool:
        """Whether another slack vanishes where this one does, all letters but one having random values."""
        point = _point(sp.Add(self.slack, other, evaluate=False), seed)
        for letter in letters:
            root = root_near(lambda v, s=letter: approximate(self.slack, {**point, s: v}), point[letter])  # type: ignore[misc]
            if root is not None:
                near = [abs(approximate(other, {**point, letter: root + d})) for d in (0.0, 0.1)]
                return near[0] <= CLOSE_LIMIT * (1 + near[1])
        return False

    def sense(self, other: sp.Expr) -> int:
        """1 if the other slack has the sign of this one, −1 if it has the opposite one."""
        points = [_point(sp.Add(self.slack, other, evaluate=False), seed) for seed in range(LIMIT_SAMPLES)]
        signs = {1 if approximate(self.slack, p) * approximate(other, p) > 0 else -1 for p in points}
        return signs.pop() if len(signs) == 1 else 1

    def added(self, other: _Limit) -> _Limit | None:
        """s ≤ f + g, of s ≤ f and s ≤ g."""
        for s in sorted(_symbols(self.slack) & _symbols(other.slack), key=str):
            rates = [sp.diff(x, s) for x in (self.slack, other.slack)]
            if all(s not in r.free_symbols and approximate(r, _point(r, 0)) < 0 for r in rates):
                bounds = [s - x / r for x, r in zip((self.slack, other.slack), rates, strict=True)]
                if all(sp.expand(b) != 0 for b in bounds):
                    return _Limit(sp.Add(*bounds) - s)
        return None


def _in_tangents(e: sp.Expr) -> sp.Expr:
    """tan(alpha + atan(mu)) as (tan(alpha) + mu)/(1 - mu*tan(alpha))."""
    return e.replace(sp.tan, lambda x: sp.expand_trig(sp.tan(x)))


def _without_cotangents(e: sp.Expr) -> sp.Expr:
    return e.replace(sp.cot, lambda x: sp.cos(x) / sp.sin(x)).replace(sp.tan, lambda x: sp.sin(x) / sp.cos(x))


@lru_cache(maxsize=512)
def _cleared(e: sp.Expr) -> sp.Expr:
    """A slack without denominators, tangents by sines and cosines, multiplied out."""
    plain = e.replace(sp.tan, lambda x: sp.sin(x) / sp.cos(x)).replace(sp.cot, lambda x: sp.cos(x) / sp.sin(x))
    return sp.expand(sp.fraction(sp.together(plain))[0])


def _of_sides(stated: sp.Expr, right: sp.Expr) -> Iterator[str]:
    """The limit of a letter that is a multiple of the right one."""
    own, other = (sp.Add.make_args(_cleared(e)) for e in (stated, right))
    if len(own) != 2 or len(other) != 2:
        return
    ratios = [(a / b) / (other[0] / other[1]) for a, b in (own, own[::-1])]
    for ratio in (r for r in ratios if r.is_Rational and r > 0 and r != 1):
        of_term = [{s for s in _symbols(term) if sp.diff(term, s, 2) == 0} for term in other]
        alone = [[s for s in of_term[n] if s not in of_term[1 - n]] for n in (0, 1)]
        n = min((n for n in (0, 1) if alone[n]), key=lambda n: count_operations(other[n]), default=None)
        if n is None:
            return
        letter = min(alone[n], key=str)
        factor = ratio if n == 1 else 1 / ratio
        yield f"the limit of {letter} is {_TIMES.get(factor, f'{factor} times')} what it should be"
        return


_TIMES = {sp.Integer(2): "twice", sp.Rational(1, 2): "half of"}


def _of_terms(stated: sp.Expr, right: sp.Expr, coefficients: Collection[sp.Expr] = ()) -> Iterator[str]:
    """One term of the balance that is missing, has the wrong sign, or is another one."""
    own, other = ([*sp.Add.make_args(_cleared(e))] for e in (stated, right))
    if not 1 < len(other) <= MOST_CONDITION_TERMS or len(own) > MOST_CONDITION_TERMS:
        return
    for scale in dict.fromkeys(a / b for a in own for b in other):
        scaled = [sp.powsimp(scale * b) for b in other]
        lost, gained = [a for a in own if a not in scaled], [b for b in scaled if b not in own]
        if max(len(lost), len(gained)) != 1 or len(gained) == len(other):
            continue
        term = gained[0] / scale if gained else None
        if not lost and term is not None:
            of_friction = [mu for mu in coefficients if (term / mu).free_symbols.isdisjoint({*coefficients})]
            what = f", {of_friction[0]} times a part of the normal force" if of_friction else ""
            yield f"the term {_written(term)} is missing{what}"
        elif term is None:
            yield f"the term {_written(lost[0] / scale)} does not belong there"
        elif sp.expand(lost[0] + gained[0]) == 0:
            yield f"the sign of the term {_written(term)} is wrong"
        elif isinstance(lost[0] / gained[0], sp.exp):
            sides = ("tight", "slack") if _point_value(lost[0] / gained[0]) > 1 else ("slack", "tight")
            yield f"the tension of the {sides[0]} side of the belt stands where that of the {sides[1]} side belongs"
        elif len(other) > 2:
            yield f"{_written(lost[0] / scale)} stands where {_written(term)} belongs"


def _point_value(e: sp.Expr) -> float:
    return approximate(e, _point(e, 0))


def _of_directions(stated: sp.Expr, right: sp.Expr) -> Iterator[str]:
    """A force with the coefficient 1, as if it acted along the direction of slipping, and not at an angle to it."""
    own, other = _cleared(stated), _cleared(right)
    for force in sorted(_symbols(own) & _symbols(other), key=str):
        slopes = [sp.diff(e, force) for e in (own, other)]
        if any(s == 0 or force in _symbols(s) for s in slopes) or not slopes[1].has(sp.sin, sp.cos):
            continue
        rest = [e.xreplace({force: sp.S.Zero}) for e in (own, other)]
        if slopes[0] ** 2 == 1 and all(r != 0 for r in rest) and is_zero(rest[0] ** 2 - rest[1] ** 2) is True:
            sign = 1 if is_zero(rest[0] - rest[1]) is True else -1
            share = text(sp.factor_terms(sign * slopes[1] / slopes[0]), Notation())
            said = f"{force} is taken along the direction of slipping, and it acts at an angle to it"
            yield f"{said}: its factor {share} is missing"


def _written(term: sp.Expr) -> str:
    return text(-term if term.could_extract_minus_sign() else term, Notation())


def _symbols(e: sp.Expr) -> set[sp.Symbol]:
    return {s for s in e.free_symbols if isinstance(s, sp.Symbol)}


def _point(e: sp.Expr, seed: int) -> dict[sp.Symbol, float]:
    """Random numbers of order one for all letters: acute angles."""
    draw = random.Random(seed)
    return {s: draw.uniform(0.3, 1.3) for s in sorted(_symbols(e), key=str)}


# Contacts


def explained_by_another_solution(stated: Sequence[StatedCondition], solution: Solution) -> str:
    """What wrong conditions or limits are in a problem that is solved once more, in a sentence; empty if not found."""
    return explained_by_arms(stated, solution) or explained_by_contacts(stated, solution)


def explained_by_contacts(stated: Sequence[StatedCondition], solution: Solution) -> str:
    """Which friction is reversed or omitted in wrong conditions or limits, in a sentence; empty if that is not found.

    All stated ones have to be those of the same changed problem.
    """
    separate = _with_own_coefficients(solution.problem)
    if separate is None or not stated:
        return ""
    rest = _needs_conditions(stated, solution)
    solved = _by_contacts(Identical(solution), rest)
    common = separate[1]
    limits = [] if solved is None else list(_limits(solved, rest=rest))
    for friction, own, mu in common:
        others = {o: m for _, o, m in common if o != own}
        for value, clause in ((-mu, "acts the other way"), (sp.S.Zero, "")):
            rule = {**others, own: value}
            changed = [e.xreplace(rule) for e in limits]
            if all(any(is_limit(c, s.slack) for c in changed) for s in stated):
                how = (
                    f"for the friction `{friction}` acting the other way"
                    if clause
                    else f"without the friction `{friction}`"
                )
                return f"{'these are the limits' if len(stated) > 1 else 'this is the limit'} {how}"
    return ""


def explained_by_arms(stated: Sequence[StatedCondition], solution: Solution) -> str:
    """Whether forces at the middle of bodies act at another distance from where these touch something, in a sentence;
    empty if not."""
    rough = {f.on: f for f in reversed(solution.problem.forces) if isinstance(f, Friction) and f.at is not None}
    moved = _movable(solution.problem)
    rest = bool(stated) and _needs_conditions(stated, solution)
    solved = _by_arms(Identical(solution), rest) if moved and stated else None
    if solved is None:
        return ""
    limits = list(_limits(solved, rest=rest))
    names = ", ".join(f"`{f.name}`" for f in moved)
    contacts = ", ".join(dict.fromkeys(f"`{rough[f.on].name}`" for f in moved))
    these = "these are the limits" if len(stated) > 1 else "this is the limit"
    for value, where in ((-1, "at twice the distance from where"), (1, "where")):
        changed = [e.xreplace({_SHIFT: sp.Integer(value)}) for e in limits]
        if all(any(is_limit(c, s.slack) for c in changed) for s in stated):
            return f"{these} for {names} acting {where} the friction {contacts} acts"
    return ""


def _needs_conditions(stated: Sequence[StatedCondition], solution: Solution) -> bool:
    """Whether all conditions of rest have to be found again, because the problem does not ask for their limits."""
    return not stated[0].equation and Find.IMPENDING not in solution.problem.find


_SHIFT = sp.Symbol("shift_of_forces", real=True)


def _movable(problem: Problem) -> tuple[AppliedForce, ...]:
    """The forces at the middle of bodies, each moved by a share of the way to the point where its body touches."""
    touched = {f.on: f.at for f in reversed(problem.forces) if isinstance(f, Friction) and f.at is not None}
    centres = {b.name: b.position for b in problem.bodies}
    return tuple(
        replace(f, at=centres[f.on] + (touched[f.on] - centres[f.on]) * _SHIFT)
        for f in problem.forces
        if isinstance(f, AppliedForce) and f.at is None and f.on in touched and f.on in centres
    )


@lru_cache(maxsize=8)
def _by_arms(same: Identical, rest: bool) -> Solution | None:
    problem: Problem = same.solution.problem
    moved = {f.name: f for f in _movable(problem)}
    forces = tuple(moved.get(f.name, f) for f in problem.forces)
    parameters = (*problem.parameters, Parameter(_SHIFT, assume=Assumption.REAL))
    return _solved_again(replace(problem, parameters=parameters, forces=forces, answers=None), rest)


@lru_cache(maxsize=8)
def _by_contacts(same: Identical, rest: bool) -> Solution | None:
    separate = _with_own_coefficients(same.solution.problem)
    return None if separate is None else _solved_again(separate[0], rest)


def _solved_again(problem: Problem, rest: bool) -> Solution | None:
    """The solution of a changed problem; None if there is none within the work allowed.

    rest  whether all conditions of rest are wanted: otherwise the limits are enough, which take a tenth of the time
    """
    if not rest and Find.IMPENDING in problem.find:
        problem = replace(problem, find=(Find.IMPENDING,))
    try:
        with allowed_for("comparing answers", UNITS_OF_OTHER_CONTACTS):
            return solve(problem)
    except ProblemError:
        return None


ONLY_A_NUMBER = "the limit of "
"""What is said of conditions that are wrong by a number, where nothing better is known."""


Common = list[tuple[str, sp.Symbol, sp.Symbol]]
"""The name of each friction, its own coefficient, and the one that it shares."""


def _with_own_coefficients(problem: Problem) -> tuple[Problem, Common] | None:
    """The problem with a coefficient for each contact; None if none is shared."""
    rough = [f for f in problem.forces if isinstance(f, Friction) and f.static is not None]
    shared = {f.static for f in rough if isinstance(f.static, sp.Symbol)}
    if len(shared) == len(rough) or len(rough) > MOST_OTHER_CONTACTS or any(f.static not in shared for f in rough):
        return None
    known = {p.symbol: p for p in problem.parameters}
    if not shared <= known.keys() or any(known[mu].value is not None for mu in shared):
        return None
    common: Common = []
    parameters = list(problem.parameters)
    forces: list[Force] = []
    for f in problem.forces:
        if isinstance(f, Friction) and isinstance(f.static, sp.Symbol):
            own = sp.Symbol(f"{f.static.name}_of_{f.name}", positive=True)
            common.append((f.name, own, f.static))
            parameters.append(replace(known[f.static], symbol=own))
            forces.append(replace(f, static=own))
        else:
            forces.append(f)
    return replace(problem, parameters=tuple(parameters), forces=tuple(forces), answers=None), common


def _limits(solution: Solution, *, rest: bool) -> Iterator[sp.Expr]:
    """The slacks of the conditions of rest, or what vanishes where friction is at its limit."""
    for v in solution.views:
        if rest and v.at_rest is not None and len(v.at_rest.cases) == 1:
            for slack in (c.right - c.left for c in v.at_rest.cases[0]):
                sizes = slack.atoms(sp.Abs)
                yield from (slack.xreplace({a: sign * a.args[0] for a in sizes}) for sign in (1, -1)[: 1 + len(sizes)])
        if not rest:
            yield from (r.lhs - r.rhs for m in v.impending or () for b in m.equilibrium.branches for r in b.relations)


# Belts


_SLIPS = (
    ("with the logarithm to base ten in place of the natural one", sp.log(10)),
    ("with the angle of contact in degrees, and not in radians", 180 / sp.pi),
    ("with the number of turns in place of the angle of contact in radians", 1 / (2 * sp.pi)),
    ("for twice the angle of contact", sp.Integer(2)),
    ("for half of the angle of contact", sp.Rational(1, 2)),
    ("for four times the angle of contact", sp.Integer(4)),
    ("for a quarter of the angle of contact", sp.Rational(1, 4)),
)


def belt_meanings(derived: Collection[sp.Expr], coefficients: Collection[sp.Expr]) -> Iterator[LetterMeaning]:
    """Misreadings of a belt's coefficient or law; none if there is no belt."""
    powers = {w for e in derived for w in e.atoms(sp.exp)}
    logarithms = {w for e in derived for w in e.atoms(sp.log)}
    short = {w: 1 + w.args[0] for w in powers} | {w: w.args[0] - 1 for w in logarithms}
    for mu in sorted(coefficients, key=str):
        linear = any(mu in e.free_symbols for e in derived if e.atoms(sp.log) & logarithms)
        if linear or any(mu in w.free_symbols for w in powers):
            for clause, factor in _SLIPS:
                yield LetterMeaning(clause, {mu: factor * mu})
            yield LetterMeaning("with 1 + mu*beta in place of exp(mu*beta), as for a short arc", short)
    for letter in sorted({s for w in powers for s in w.args[0].free_symbols if len(powers) == 1}, key=str):
        clause = f"for a friction {letter} times the tension, as of a block, in place of the law of the belt"
        yield LetterMeaning(clause, dict.fromkeys(powers, 1 + letter))
    without = {w: w + 1 for w in powers if any(_has_difference(e, w) for e in derived)}
    if without:
        yield LetterMeaning("without the tension of the slack side on the drum", without)


def _has_difference(slack: sp.Expr, power: sp.Expr) -> bool:
    """Whether a slack has a term with exp(mu*beta) - 1, the difference of the tensions over that of the slack side."""
    letter = sp.Dummy(positive=True)
    linear = sp.expand(_cleared(slack).xreplace({power: letter}))
    rate, rest = linear.coeff(letter, 1), linear.coeff(letter, 0)
    return bool(rate != 0 and {*sp.Add.make_args(-rate)} < {*sp.Add.make_args(rest)})


def in_logarithms(slack: sp.Expr) -> sp.Expr:
    """A slack a exp(u) - b as u - log(b/a), in which the coefficient of a belt is linear; others as they are."""
    powers = sorted(slack.atoms(sp.exp), key=str)
    if len(powers) != 1:
        return slack
    letter = sp.Dummy(positive=True)
    linear = sp.expand(slack.xreplace({powers[0]: letter}))
    rate, rest = linear.coeff(letter, 1), linear.coeff(letter, 0)
    ratio = -rest / rate if rate != 0 else sp.S.Zero
    if ratio == 0 or letter in (rate.free_symbols | rest.free_symbols) or sp.expand(linear - rate * letter - rest) != 0:
        return slack
    return powers[0].args[0] - sp.log(ratio)
