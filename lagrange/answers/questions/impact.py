"""Are the stated velocities, impulses and losses of energy of an impact right?

Each entry is an expression, or an equation with its name on the left: a velocity just after (`x'`), the impulse of a
reaction under the name of its constraint or of its force, or `energy_lost`. It must have the derived value in the
position of the impact, exactly, with decimals that may be rounded. An impulse may be stated for the opposite force, or
for the multiplier; a remark says so.

An impact as it is worked out on paper: velocities after it, impulses, and the laws that lead to them.

    m x' + M X' = 0          (x' - X') sin(alpha) + y' cos(alpha) = e v cos(alpha)          N = m (v + y')/cos(alpha)

An equation between velocities just after the impact and impulses is right if the derived ones satisfy it in the
position of the impact. The answer is complete if it determines all velocities that the impact changes, together with
the constraints, which need not be restated. The name of a reaction may stand for the opposite impulse, in the whole
answer alike. A letter that the problem does not declare, V = m v/(m + M), may be one of the results, or a speed.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import product

import sympy as sp

from lagrange.algebra.exact.expression_graph import DivisionByZeroError
from lagrange.answers.limits import MOST_IMPULSES
from lagrange.answers.questions.asked_quantities import read_stated
from lagrange.answers.questions.named_values import (
    WRONG_UNIT,
    Judged,
    check_each,
    dimensions_of_value,
    in_si,
    worst,
)
from lagrange.answers.readings import GivenEquation, Reading, decimals_in
from lagrange.answers.references import Reference, reference_of_solution
from lagrange.answers.verdicts import DIVIDES_BY_ZERO, UNDECIDED, AnswerVerdict, EquationVerdict, Verdict
from lagrange.answers.written.decimals import as_written, numbers_rounding_to
from lagrange.answers.written.working import Working
from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError, suggestion
from lagrange.core.symbols import prime, velocity_before
from lagrange.expressions.characters import GREEK
from lagrange.expressions.edits import Draft
from lagrange.expressions.latex_layout import is_latex
from lagrange.mechanics.momenta.impact import ImpulsiveMotion
from lagrange.mechanics.results import Solution
from lagrange.problem.model import Problem

ENERGY_LOST = "energy_lost"
_NOT_DERIVED = "the problem does not ask for an impact"
_OPEN = "the impulse is not determined: the constraints depend on one another"
_OPPOSITE = "it is taken as the opposite force"
_MULTIPLIER = "it is taken as the impulse of the multiplier"
_ROUNDED = "it is taken as a rounded number"


def check_impact_answers(stated: Mapping[str, Fragment], solution: Solution) -> AnswerVerdict:
    """The verdict on all entries together."""
    motion = solution.impact
    if motion is None:
        return AnswerVerdict(Verdict.UNDECIDED, name="impact", diagnosis=_NOT_DERIVED)
    reference = reference_of_solution(solution)
    return check_each(
        "impact", stated, lambda name, fragment: _judged_entry(name, fragment, motion, solution.problem, reference)
    )


def _judged_entry(
    name: str, fragment: Fragment, motion: ImpulsiveMotion, problem: Problem, reference: Reference
) -> Judged:
    """The verdict on one entry. Raises ProblemError, DivisionByZeroError."""
    values = [*_values(name, fragment, motion)]
    scope = replace(reference.scope, decimals="")
    if values:
        fragment, unit_fits = in_si(fragment, dimensions_of_value(values[0][0], reference), reference)
        if not unit_fits:
            return Verdict.WRONG, WRONG_UNIT
    expression, equation = read_stated(fragment, scope, name)
    if expression is None:
        assert equation is not None
        expression = _solved(equation, name, motion)
        if expression is None:
            help_ = f"write the expression, or `{name} = ...`"
            message = f"this equation does not give `{name}`"
            raise ProblemError(Diagnostic("unexpected-equation", message, fragment.whole, help=help_))
    if not values:
        return Verdict.UNDECIDED, _OPEN
    undecided = False
    for value, remark in values:
        same = _same(expression, value, motion, reference)
        if same is None:
            undecided = True
        elif same:
            rounding = _ROUNDED if decimals_in([expression]) else ""
            return Verdict.EQUIVALENT, "; ".join(filter(None, [remark, rounding]))
    if undecided:
        return Verdict.UNDECIDED, UNDECIDED
    from lagrange.answers.results.impacts import explained_impact

    before = dict(zip(motion.slots.velocities, motion.velocities, strict=True))
    claim = motion.at(as_written(expression)).xreplace(before)
    values_ = dict(reference.values)
    why = explained_impact(
        name, claim, values[0][0], motion, problem, lambda e: motion.surface.is_zero(e.xreplace(values_))
    )
    if not why and not (reference.values and claim.is_number):  # a number alone is in SI units
        from lagrange.answers.results.meanings import wrong_dimension

        why = wrong_dimension(claim, reference.units, values[0][0])
    return Verdict.WRONG, why


def _values(name: str, fragment: Fragment, motion: ImpulsiveMotion) -> Iterator[tuple[sp.Expr, str]]:
    """The derived value under a name, and what an impulse may be instead; none if it is not determined.

    Raises ProblemError if the name means nothing.
    """
    velocities = {q.name: v for q, v in motion.all_velocities.items()}
    plain = name.strip().replace("′", "'").removesuffix("'")
    impulses = {n: i for i in motion.impulses for n in (i.name, str(i.symbol), str(i.reaction.constraint.reaction))}
    if plain in velocities:
        yield velocities[plain], ""
    elif name == ENERGY_LOST:
        yield motion.energy_lost, ""
    elif name in impulses:
        i = impulses[name]
        if i.value is not None and i.multiplier is not None:
            yield i.value, ""
            others = ((-i.value, _OPPOSITE), (i.multiplier, _MULTIPLIER))
            yield from ((value, remark) for value, remark in others if value != i.value)
    else:
        known = [*(f"{q}'" for q in velocities), *(i.name for i in motion.impulses), ENERGY_LOST]
        message = f"`{name}` is neither a velocity nor an impulse of this impact"
        help_ = suggestion(name, known, "results")
        raise ProblemError(Diagnostic("unknown-name", message, fragment.whole, help=help_))


def _solved(equation: sp.Expr, name: str, motion: ImpulsiveMotion) -> sp.Expr | None:
    """The named velocity or impulse solved from an equation that is linear in it."""
    plain = name.strip().removesuffix("'")
    coordinate = next((q for q in motion.all_velocities if q.name == plain), None)
    impulse = next((i.symbol for i in motion.impulses if name in (i.name, str(i.symbol))), None)
    unknown = prime(coordinate) if coordinate is not None else impulse
    if unknown is None:
        return None
    slope = equation.diff(unknown)
    if slope == 0 or slope.has(unknown):
        return None
    return sp.cancel(unknown - equation / slope)


def _same(claim: sp.Expr, value: sp.Expr, motion: ImpulsiveMotion, reference: Reference) -> bool | None:
    """Whether a claim has a value in the position of the impact, its decimals being numbers that round to them."""
    before = dict(zip(motion.slots.velocities, motion.velocities, strict=True))
    difference = (motion.at(claim).xreplace(before) - value).xreplace(dict(reference.values))
    exact = motion.surface.is_zero(as_written(difference))
    if exact is not False or not decimals_in([difference]):
        return exact
    return numbers_rounding_to([difference]) is not None


# An impact with its working


_WRONG = "it does not hold for the velocities just after the impact"
_IDENTITY = "it says nothing about the impact"
_ACCELERATION = "accelerations have no meaning during an impact"
_OTHERWISE = "it is right with `a/b c` read as `a/(b c)`, and `sin x^2` as `sin(x^2)`"
_SPEED = "it is taken as the magnitude of {}"
_MISSING = "the answer does not determine {}"


def check_impact_in_text(
    working: Working, motion: ImpulsiveMotion, reference: Reference, problem: Problem
) -> AnswerVerdict:
    """The verdict on equations between velocities and impulses."""
    judged = [f for f in working.judged if isinstance(f, GivenEquation)]
    readings = [f.reading for f in judged]
    names = sorted(
        {s for r in readings for e in r.components for s in e.free_symbols} & _impulses(motion).keys(), key=str
    )
    best: list[EquationVerdict] | None = None
    rows: list[sp.Expr] = []
    for signs in product((1, -1), repeat=min(len(names), MOST_IMPULSES)):
        turned = {s: -s for s, sign in zip(names, signs, strict=False) if sign < 0}
        each = [_judged_either_way(r, motion, reference, turned) for r in readings]
        if best is None or _right(each) > _right(best):
            best = each
            rows = [
                e.xreplace(turned)
                for r, v in zip(readings, each, strict=True)
                if v.verdict is Verdict.EQUIVALENT
                for e in r.components
            ]
    parts = [_explained(r, p, motion, reference, problem) for r, p in zip(readings, best or [], strict=bool(best))]
    if all(p.verdict is Verdict.TRIVIAL for p in parts):  # what it calls by names of its own
        speeds = [_named(name, value, motion, reference) for name, value in working.defined.items()]
        parts += [named[0] for named in speeds if named is not None]
        rows += [named[1] for named in speeds if named is not None]
    parts += [
        EquationVerdict(f.reading.text, Verdict.UNREADABLE, f.reading.error.diagnostics[0].message)
        for f in working.unreadable
        if f.reading.error
    ]
    errors = tuple(d for f in working.unreadable if f.reading.error for d in f.reading.error.diagnostics)
    verdict, why = worst([p for p in parts if p.verdict is not Verdict.TRIVIAL] or parts), ""
    if verdict is Verdict.EQUIVALENT and (missing := _missing(rows, motion)):
        verdict, why = Verdict.INCOMPLETE, _MISSING.format(", ".join(f"{q}'" for q in missing))
    if not parts:
        verdict, why = Verdict.UNDECIDED, "there is nothing in it that could be compared with the impact"
    return AnswerVerdict(verdict, tuple(parts), unreadable=errors, notes=working.notes, diagnosis=why)


_JUST_AFTER = re.compile(
    r"(?P<rate>\\dot\s*(?:\{\s*\\?\w{1,12}\s*\}|\\?\w{1,12})|[^\W\d]\w{0,12}['′])\s*(?:[_^]\s*(?:\{\s*\+\s*\}|\+(?=\s*=))|⁺)"
    r"|(?P<dotted>\\dot\s*(?:\{\s*\\?\w{1,12}\s*\}|\\?[A-Za-z]{1,12})(?:_\w)?|[^\W\d_]\u0307|[ẋẏżẊẎŻṙṡ])\s*['′⁺]"
)
"""A velocity just after, with a sign: `\\dot\\theta^+ = ...`, `\\dot x' = ...`."""
_LETTER_AFTER = re.compile(
    r"(?<![A-Za-z_\\])(?P<name>(?:\\?(?:omega|Omega)|[wvuVωΩ])(?:_\w{1,2}|_\{\w{1,2}\})?)['′](?!['′])"
)
"""A letter for a velocity just after, ω'."""
_OMEGA_AFTER = ("prime", "1", "2", "f", "after", "new")
"""The index of ω just after an impact, where ω is that before."""


def without_primes_after(answer: Sequence[Fragment], declared: Collection[str]) -> list[Fragment]:
    """`w' = ...` as w = ..., for a letter that the problem does not declare and that occurs with its prime only."""
    found = {m["name"] for f in answer for m in _LETTER_AFTER.finditer(f.text)}
    bare = {
        n
        for n in found
        if re.sub(r"[{}]", "", "".join(GREEK.get(c, c) for c in n.lstrip("\\"))) not in declared
        and not any(re.search(rf"(?<![A-Za-z_\\]){re.escape(n)}(?![A-Za-z0-9_'′])", f.text) for f in answer)
    }
    made = []
    for f in answer:
        draft = Draft(f)
        changed = draft.replace(_LETTER_AFTER, lambda m: m["name"] if m["name"] in bare else None)
        made.append(draft.finished(latex=is_latex(f)) if changed else f)
    return made


def without_sign_after(fragment: Fragment) -> Fragment:
    """`\\dot\\theta^+` as the velocity just after, which is what velocities mean in an answer."""
    draft = Draft(fragment)
    changed = draft.replace(_JUST_AFTER, lambda m: m["rate"] or m["dotted"])
    return draft.finished(latex=is_latex(fragment)) if changed else fragment


_INDEX_OF_LOSS = r"\{?\s*(?:\\(?:text|mathrm)\s*\{)?"
_LOSS = re.compile(
    rf"[\s$&]*(?:(?:\\Delta\s*|Δ\s*)(?P<change>[ETKWU])(?:_{_INDEX_OF_LOSS}\w{{1,12}}[}}\s]*)?"
    rf"|(?P<lost>[EWQTK])_{_INDEX_OF_LOSS}(?:lost|loss|diss|verl|Verl|perdue)\w{{0,10}}[}}\s]*"
    r"|energy[ _](?:lost|loss)\s*)"
    r"\s*&?=(?!=)"
)


def with_losses(answer: Sequence[Fragment]) -> list[tuple[Fragment, bool]]:
    """Each line, and whether it states the energy that is lost: `ΔE = ...`, `E_lost = ...`."""
    return [(f, _LOSS.match(f.text) is not None) for f in answer]


def check_loss(stated: Fragment, solution: Solution) -> AnswerVerdict:
    """The verdict on the energy that is lost; ΔE may be the change, which is its opposite."""

    match = _LOSS.match(stated.text)
    assert match is not None
    losses = []
    latex, end = is_latex(stated), len(stated.text.rstrip(" $.,;"))
    for sign in ("", "-") if match["change"] else ("",):
        draft = Draft(stated)
        draft.keep(match.end(), end)
        draft.apply([(0, 0, f"{sign}("), (len(draft.text), len(draft.text), ")")])
        losses.append(check_impact_answers({ENERGY_LOST: draft.finished(latex=latex)}, solution))
    return next((v for v in losses if v.verdict is Verdict.EQUIVALENT), losses[0])


def _right(parts: Sequence[EquationVerdict]) -> int:
    return sum(p.verdict is Verdict.EQUIVALENT for p in parts)


def _impulses(motion: ImpulsiveMotion) -> dict[sp.Symbol, sp.Expr]:
    """The impulses that are determined, under each of their names."""
    values = {i.symbol: i.value for i in motion.impulses if i.value is not None}
    return values | {i.reaction.multiplier: i.multiplier for i in motion.impulses if i.multiplier is not None}


def _state(motion: ImpulsiveMotion) -> dict[sp.Symbol, sp.Expr]:
    """Velocities and impulses, and the velocities just before under their own names."""
    before = dict(zip(map(velocity_before, motion.slots.coordinates), motion.before, strict=True))
    return {**before, **dict(zip(motion.slots.velocities, motion.velocities, strict=True)), **_impulses(motion)}


def _judged_equation(
    reading: Reading,
    motion: ImpulsiveMotion,
    reference: Reference,
    turned: Mapping[sp.Symbol, sp.Expr],
) -> EquationVerdict:
    """The verdict on one equation."""
    text, components = reading.text, reading.with_decimals or reading.components
    if any(e.free_symbols & {*motion.slots.accelerations, *motion.full.slots.accelerations} for e in components):
        return EquationVerdict.of(text, Verdict.WRONG, _ACCELERATION)
    if not any(e.free_symbols & {*_state(motion), *turned} for e in components):
        return EquationVerdict.of(text, Verdict.TRIVIAL, _IDENTITY)  # a case: where a = 2*l/3
    remarks = [_OPPOSITE] if any(e.free_symbols & turned.keys() for e in components) else []
    try:
        claims = [motion.at(e.xreplace(dict(turned))) for e in components]
        residuals = [e.xreplace(_state(motion)).xreplace(dict(reference.values)) for e in claims]
        if all(motion.surface.is_zero(as_written(e)) is True for e in claims):
            return EquationVerdict.of(text, Verdict.TRIVIAL, _IDENTITY)
        holds = {motion.surface.is_zero(as_written(e)) for e in residuals}
    except DivisionByZeroError:
        return EquationVerdict.of(text, Verdict.UNREADABLE, DIVIDES_BY_ZERO)
    if False in holds and decimals_in(residuals) and numbers_rounding_to(residuals) is not None:
        holds, remarks = {True}, [*remarks, _ROUNDED]
    if False in holds:
        return EquationVerdict.of(text, Verdict.WRONG, _WRONG)
    if None in holds:
        return EquationVerdict.of(text, Verdict.UNDECIDED, UNDECIDED)
    return EquationVerdict.of(text, Verdict.EQUIVALENT, "; ".join(remarks))


def _judged_either_way(
    reading: Reading, motion: ImpulsiveMotion, reference: Reference, turned: Mapping[sp.Symbol, sp.Expr]
) -> EquationVerdict:
    """The verdict on an equation in its usual reading, or in the other one if it is right so: `2h/3R` as 2h/(3R)."""
    judged = _judged_equation(reading, motion, reference, turned)
    if judged.verdict is not Verdict.WRONG or reading.other is None:
        return judged
    other = _judged_equation(reading.other, motion, reference, turned)
    return replace(other, remarks=(*other.remarks, _OTHERWISE)) if other.verdict is Verdict.EQUIVALENT else judged


def _explained(
    reading: Reading, judged: EquationVerdict, motion: ImpulsiveMotion, reference: Reference, problem: Problem
) -> EquationVerdict:
    """The verdict on a wrong equation, with what it states instead."""
    if judged.verdict is not Verdict.WRONG or judged.diagnosis != _WRONG or len(reading.components) != 1:
        return judged
    from lagrange.answers.results.impacts import explained_statement

    why = explained_statement(as_written(reading.components[0]), motion, problem, reference.values)
    return replace(judged, diagnosis=why, hints=(_WRONG, _WRONG, why), cause=why) if why else judged


def _named(
    name: str, value: sp.Expr, motion: ImpulsiveMotion, reference: Reference
) -> tuple[EquationVerdict, sp.Expr] | None:
    """The verdict on a value under a name that the problem does not declare, and the equation that it states.

    None if it is none of the results.
    """
    for symbol, derived in (*motion.all_velocities.items(), *_impulses(motion).items()):
        what = f"{symbol}'" if symbol in motion.all_velocities else str(symbol)
        for sign in (1, -1):
            if (
                derived != 0
                and motion.surface.is_zero((value - sign * derived).xreplace(dict(reference.values))) is True
            ):
                unknown = prime(symbol) if symbol in motion.all_velocities else symbol
                return EquationVerdict.of(name, Verdict.EQUIVALENT, _SPEED.format(what)), unknown - sign * value
    return None


def _missing(claims: Sequence[sp.Expr], motion: ImpulsiveMotion) -> list[str]:
    """The coordinates whose velocities just after the impact are not determined by the equations."""
    velocities, impulses = motion.slots.velocities, list(_impulses(motion))
    columns = [*velocities, *impulses]
    unchanged = [motion.surface.is_zero(a - b) is True for a, b in zip(motion.velocities, motion.before, strict=True)]
    rows = [[motion.at(e).diff(c).xreplace(_state(motion)) for c in columns] for e in claims]
    rows += [[*row.coefficients, *[0] * len(impulses)] for row in motion.rows]
    rows += [[int(c is v) for c in columns] for v, same in zip(velocities, unchanged, strict=True) if same]
    rank = motion.surface.rank(rows) if rows else 0
    missing = []
    for q, v in zip(motion.slots.coordinates, velocities, strict=True):
        with_it = motion.surface.rank([*rows, [int(c is v) for c in columns]])
        if rank is not None and with_it is not None and with_it > rank:
            missing.append(q.name)
    return missing


def with_omega(answer: Sequence[Fragment], reference: Reference, motion: ImpulsiveMotion) -> list[Reference]:
    """The names that an answer may use, with ω for the only angular velocity just after the impact, in either sense.

    Where the problem has ω for that before, it is the one with an index or a prime.
    """
    angles = [q for q in motion.slots.coordinates if reference.units.get(q, "") in ("", "rad", "deg")]
    names = {n for n in ("omega", "w", "Omega") if n not in reference.declared and reference.scope.scalar(n) is None}
    if "omega" in reference.declared:
        names = {*filter(None, [_omega_with_index(answer, reference.declared)])}
    if len(angles) != 1 or not names:
        return []
    declared = reference.declared | names
    return [
        replace(
            reference,
            scope=replace(reference.scope, scalars={**reference.scope.scalars, **dict.fromkeys(names, rate)}),
            declared=declared,
        )
        for rate in (prime(angles[0]), -prime(angles[0]))
    ]


def _omega_with_index(answer: Sequence[Fragment], declared: Collection[str]) -> str:
    """The name of ω with an index that occurs in an answer and is not declared; empty if none does."""
    for index in _OMEGA_AFTER:
        mark = "['′]" if index == "prime" else rf"_\{{?\s*{index}\s*\}}?(?![A-Za-z0-9])"
        written = re.compile(rf"(?:\\?omega|ω){mark}")
        if f"omega_{index}" not in declared and any(written.search(f.text) for f in answer):
            return f"omega_{index}"
    return ""


def with_impulses(reference: Reference, motion: ImpulsiveMotion) -> Reference:
    """The names that an answer may use, with those of the impulses and without those of the kinetic energies."""
    names = {s.name: s for s in _impulses(motion)}
    hidden = {n for n in ("T", "T_0", "K", "K_0") if n not in reference.declared}
    scalars = {n: e for n, e in reference.scope.scalars.items() if n not in hidden} | names
    return replace(
        reference, scope=replace(reference.scope, scalars=scalars), declared=reference.declared | names.keys()
    )
