"""Equilibrium in a text that says other things too: positions, virtual work, the forces of supports.

Positions of equilibrium in a text that is also about motion or frequencies, and names of quantities in it.

Equilibrium: x1 = (c l + kappa (L - l))/(c + 2 kappa), x2 = L - x1
theta = 0: omega = sqrt(g/R - Omega^2);   theta = arccos(g/(R Omega^2)): omega = ...
T = 2 pi sqrt(l cos(theta)/g)                   phi' = 2 pi/(...), a period of a steady motion
cos(theta_0) = g/(l phi'^2)                     cos(theta) = g/(l phi'^2)

Virtual work as an answer about equilibrium: W δy − 2 P y/√(b² + y²) δy = 0.

It vanishes for all virtual displacements, so that the coefficient of each independent one is zero: these are the
conditions of equilibrium that it states. In statics dy is written for δy as well.

The forces of two smooth supports of a rod, N_A and N_B, as the page calls them, among the lines of an answer.

No constraint of the file has them; they are right if they hold at every equilibrium:  R_1 n_1 + R_2 n_2 + Σ F = 0.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

import sympy as sp

from lagrange.algebra.exact.expression_graph import DivisionByZeroError
from lagrange.algebra.exact.zero_test import is_zero
from lagrange.answers.questions.named_values import worst
from lagrange.answers.readings import GivenEquation, displaced_coordinates, without_displacements
from lagrange.answers.references import Reference, reference_of_solution
from lagrange.answers.verdicts import DIVIDES_BY_ZERO, UNDECIDED, AnswerVerdict, EquationVerdict, Verdict
from lagrange.answers.written.decimals import as_written
from lagrange.answers.written.lines import in_pairs
from lagrange.answers.written.reading import read_as_written
from lagrange.answers.written.working import Working, understood
from lagrange.core.diagnostics import Fragment, ProblemError
from lagrange.core.symbols import base, differential, prime, variation
from lagrange.expressions.edits import Draft
from lagrange.expressions.latex_layout import is_latex
from lagrange.expressions.syntax_tree import Role
from lagrange.mechanics.equilibrium.stability import on_branch
from lagrange.mechanics.results import Solution
from lagrange.mechanics.supports import supports

_GOOD = (Verdict.EQUIVALENT, Verdict.INCOMPLETE)
_SAID = re.compile(r"equilibri|at rest|gleichgewicht|ruhelage|équilibre|stationary", re.IGNORECASE)
_NONE_DERIVED = "no position of equilibrium is derived with which it could be compared"
_PERIOD = re.compile(r"[\s$&]*(?:T|\\tau|tau|τ|P)(?:_\{?\w{1,8}\}?)?\s*&?=(?!=)")


def positions_of(answer: Sequence[Fragment], solution: Solution) -> tuple[AnswerVerdict, list[Fragment]] | None:
    """The verdict on positions of equilibrium, and the other lines; None if there are none.

    Wrong ones among other lines are only taken for positions where the text says so.
    """
    from lagrange.answers.equilibria import alternatives_of, with_both_signs
    from lagrange.answers.questions.own_answers import compared_equilibrium
    from lagrange.answers.written.working import understood

    reference = reference_of_solution(solution)
    stated: list[Fragment] = []
    rest: list[Fragment] = []
    for f in answer:
        both = with_both_signs(f)
        listed = [understood(a, reference, moving=False).judged for g in both for a in alternatives_of([g])]
        is_position = all(listed) and all(_is_position(g, reference) for judged in listed for g in judged)
        (stated if is_position else rest).append(f)
    if not stated:
        return None
    try:
        together = [tuple(understood(a, reference, moving=False).judged) for a in alternatives_of(stated)]
        each = [tuple(understood(a, reference, moving=False).judged) for f in stated for a in alternatives_of([f])]
        verdicts = [compared_equilibrium(solution, alternatives) for alternatives in (together, each)]
    except ProblemError:
        return None
    about = [v.linearization.equilibrium for v in solution.views if v.linearization is not None]
    if about and not any(e.branches for e in about):
        # it may be at rest relative to what moves
        verdicts = [AnswerVerdict(Verdict.UNDECIDED, diagnosis=_NONE_DERIVED)]
    order = (*_GOOD, Verdict.UNDECIDED, Verdict.WRONG)
    verdict = min(verdicts, key=lambda v: order.index(v.verdict) if v.verdict in order else len(order))
    said = any(_SAID.search(f"{getattr(f, 'beside', '')} {f.whole.source.text[: f.whole.end]}"[-400:]) for f in stated)
    if verdict.verdict not in _GOOD and not said and (rest or not about):
        return None
    return replace(verdict, name="equilibrium"), rest


def at_stated_positions(
    answer: Sequence[Fragment], stated: Sequence[Fragment], verdict: AnswerVerdict, solution: Solution
) -> AnswerVerdict:
    """The verdict on frequencies of which some are right: wrong if one is given for a position that has another."""
    from lagrange.answers.questions.frequencies import check_frequencies
    from lagrange.answers.written.working import understood

    reference = reference_of_solution(solution)
    after: list[tuple[list[sp.Expr], Fragment]] = []
    where: list[list[sp.Expr]] = []  # the positions since the frequency before
    for f in answer:
        if any(f is s for s in stated):
            after.append((where[0] if len(where) == 1 else [], f))
            where = []
            continue
        judged = understood([f], reference, moving=False).judged
        if judged and all(_is_position(g, reference) for g in judged):
            where.append([e for g in judged if isinstance(g, GivenEquation) for e in g.reading.components])
    for position, f in after:
        there = check_frequencies([[f]], solution, only_at=position) if position else verdict
        if there.verdict is Verdict.WRONG and verdict.verdict is Verdict.UNDECIDED:
            return there
        if there.verdict is Verdict.WRONG and check_frequencies([[f]], solution).verdict is not Verdict.WRONG:
            why = f"not right there: {f.text.strip()}; it is the frequency at another equilibrium"
            return replace(verdict, verdict=Verdict.WRONG, diagnosis=why)
    return verdict


def _is_position(fragment: Fragment, reference: Reference) -> bool:
    """Whether an equation is one between coordinates and parameters."""
    if not isinstance(fragment, GivenEquation) or fragment.reading.error:
        return False
    used = {s for e in fragment.reading.components for s in e.free_symbols}
    coordinates = {*reference.scope.slots.coordinates}
    allowed = coordinates | {*reference.parameters.values()}
    return not used.isdisjoint(coordinates) and used <= allowed and all(base(s) == s for s in used)


def with_rate_as_omega(reference: Reference, cyclic: Sequence[sp.Symbol]) -> Reference:
    """omega, and Omega, as the constant rate of the angle of a steady motion, where the problem declares neither."""
    names = {"omega", "Omega"} - {*reference.declared}
    if len(cyclic) != 1 or len(names) < 2:
        return reference
    rate = prime(cyclic[0])
    scope = replace(reference.scope, scalars={**reference.scope.scalars, **dict.fromkeys(names, rate)})
    return replace(reference, scope=scope, declared=reference.declared | names)


_KEPT = re.compile(r"=\s*\$?\s*\\?(?:text\{|mathrm\{)?\s*(?:const|konst|cst)", re.IGNORECASE)


def is_kept(fragment: Fragment) -> bool:
    """Whether a line says that something is constant, `theta = const`: no more than that the motion is steady."""
    return _KEPT.search(fragment.text) is not None


def definition_of_kept(fragment: Fragment) -> Fragment | None:
    """`p = A` of the chain `p = A = const`."""
    pairs = in_pairs(fragment) if is_kept(fragment) else []
    return pairs[0].finished(latex=is_latex(fragment)) if len(pairs) > 1 else None


def says_steady(fragment: Fragment, cyclic: Sequence[sp.Symbol], reference: Reference) -> bool:
    """Whether a line says only that the motion is steady: theta' = 0, where theta is not cyclic, or phi'' = 0."""
    reading = read_as_written(fragment, reference.scope)
    if reading.error is not None or len(reading.components) != 1:
        return False
    slots = reference.scope.slots
    still = {*slots.accelerations, *(prime(q) for q in slots.coordinates if q not in cyclic)}
    return any(e in still for e in (reading.components[0], -reading.components[0]))


def period_as_rate(fragment: Fragment, cyclic: Sequence[sp.Symbol], reference: Reference) -> Fragment:
    """The period of a steady motion, `T = value`, as the rate of its angle, where there is one cyclic angle."""
    match = _PERIOD.match(fragment.text)
    if (
        match is None
        or len(cyclic) != 1
        or (reference.scope.role("T") is not Role.UNDECLARED and "T" in reference.declared)
    ):
        return fragment
    [angle] = cyclic
    latex = is_latex(fragment)
    rate, turn = (rf"\dot{{\{angle.name}}}", r"2\pi") if latex and len(angle.name) > 1 else (f"{angle.name}'", "2*pi")
    if latex and len(angle.name) == 1:
        rate = rf"\dot{{{angle.name}}}"
    draft = Draft(fragment)
    end = len(fragment.text.rstrip(" $.,;"))
    between = " " if latex else "*"
    draft.apply(
        [
            (0, match.end(), f"{'$' if fragment.text.lstrip().startswith('$') else ''} {rate}{between}("),
            (end, end, f") = {turn}"),
        ]
    )
    return draft.finished(latex=latex)


# Virtual work


def with_stated_conditions(working: Working, solution: Solution) -> Working:
    """The answer with the conditions that its equations between virtual displacements state."""
    return replace(working, judged=tuple(_conditions(f, solution) for f in working.judged))


def _conditions(fragment: Fragment, solution: Solution) -> Fragment:
    if not isinstance(fragment, GivenEquation):
        return fragment
    components = fragment.reading.components
    for view in (v for v in solution.views if not v.configuration.rows):  # where the displacements are independent
        coordinates = (*view.configuration.slots.coordinates, *view.configuration.expressed)
        displaced = displaced_coordinates(components, coordinates)
        if not displaced:
            continue
        virtual = [e.xreplace({differential(q): variation(q) for q in displaced}) for e in components]
        conditions = tuple(
            c for e in virtual for c in without_displacements(view.configuration.rewritten(e), view.configuration)
        )
        if any(c != 0 for c in conditions) and conditions != tuple(virtual):
            reading = replace(fragment.reading, components=conditions, sides=())
            return replace(fragment, reading=reading)
    return fragment


# Forces of supports


_WRONG = "it does not hold at every equilibrium"


def supports_of(answer: Sequence[Fragment], solution: Solution) -> tuple[AnswerVerdict, list[Fragment]] | None:
    """The verdict on the lines with forces of supports, and the other lines; None if there are none."""
    if not any("N" in f.text for f in answer):
        return None
    derived = supports(solution)
    if derived is None:
        return None
    reference = reference_of_solution(solution)
    names = {f"N_{s.point}": s.size for s in derived.at if f"N_{s.point}" not in reference.scope.names()}
    forces = {sp.Symbol(n, real=True): size for n, size in names.items()}
    scope = replace(reference.scope, scalars={**reference.scope.scalars, **{s.name: s for s in forces}})
    wider = replace(reference, scope=scope, declared=reference.declared | names.keys())
    working = understood(answer, wider, moving=False)
    parts: list[EquationVerdict] = []
    rest: list[Fragment] = []
    for f in working.written:
        about = isinstance(f, GivenEquation) and any(e.free_symbols & forces.keys() for e in f.reading.components)
        if about and isinstance(f, GivenEquation):
            parts.append(_judged(f, forces, solution))
        elif f in working.judged:
            rest.append(f)
        else:
            rest += [g for g in answer if g.whole == f.whole][:1]
    if not parts:
        return None
    return AnswerVerdict(worst(parts), tuple(parts), notes=working.notes, name="reactions"), rest


def _judged(line: GivenEquation, forces: dict[sp.Symbol, sp.Expr], solution: Solution) -> EquationVerdict:
    """The verdict on one line: whether it holds at every equilibrium."""
    text = line.reading.text
    chosen = solution.chosen
    rest = chosen.equilibrium
    assert rest is not None
    holds: set[bool | None] = set()
    try:
        for e in line.reading.components:
            stated = chosen.configuration.rewritten(as_written(e).xreplace(forces))
            for b in rest.branches:
                value = on_branch(b, stated, rest)
                holds.add(None if value is None else is_zero(value))
    except DivisionByZeroError:
        return EquationVerdict.of(text, Verdict.UNREADABLE, DIVIDES_BY_ZERO)
    if False in holds:
        return EquationVerdict.of(text, Verdict.WRONG, _WRONG)
    if None in holds or not holds:
        return EquationVerdict.of(text, Verdict.UNDECIDED, UNDECIDED)
    return EquationVerdict.of(text, Verdict.EQUIVALENT, "")
