"""Wrong equations about forces: one stated reaction, friction in one sense of the motion only.

A wrong equation that states one force of constraint, N = m g cos(theta): what that force would be.

Such an equation is compared as the value of a reaction is: with that at rest, with what balances the other forces as if
nothing were accelerated, with that of a changed problem, with a multiple of the right one.

A wrong equation that is right for one sense of the motion: friction turns with the velocity.

m x'' = −k x − μ m g is right while x' > 0. In the derived equations the sign of x' is put to +1 and to −1 (and |x'| to
x' and −x'); if the equation follows from one of the two systems, it holds while the velocity has that sign. Where the
answer says so itself, it is right as far as it goes.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.algebra.exact.expression_graph import DivisionByZeroError, UnsupportedError
from lagrange.algebra.exact.prime_field import InadmissibleError
from lagrange.algebra.exact.sampler import NoPointError
from lagrange.answers.limits import LONGEST_COMPARED_REACTION, MOST_SENSES
from lagrange.answers.readings import GivenEquation
from lagrange.answers.references import Reference, ReferenceCandidate
from lagrange.answers.verdicts import AnswerVerdict, EquationVerdict, Verdict
from lagrange.answers.written.cases import single_condition
from lagrange.core.diagnostics import Fragment, ProblemError
from lagrange.core.symbols import base
from lagrange.document.math_writer import text
from lagrange.expressions.reader import read_value
from lagrange.mechanics.dynamics.comparison import Standing, System, compare
from lagrange.problem.model import InitialValue

if TYPE_CHECKING:
    from lagrange.mechanics.dynamics.newton import Reaction
    from lagrange.mechanics.results import Solution

RATIOS = tuple(sp.Rational(p, q) for p, q in ((2, 1), (1, 2), (3, 2), (2, 3), (3, 1), (1, 3), (4, 3), (3, 4)))
_NUMBER = "only a number is wrong in it: the force is {} times as large"


def explained_force(
    equation: sp.Expr, candidate: ReferenceCandidate, reference: Reference, *, moving: bool = False
) -> str:
    """What the stated force is, in a sentence; empty if the equation states none, or that is not found.

    An equation with accelerations is one of motion, and no value of a force; `moving`: then forces that it has
    eliminated are tried.
    """
    if moving and equation.free_symbols & {*candidate.configuration.slots.accelerations}:
        from lagrange.answers.results.taken_forces import with_taken_forces

        return with_taken_forces(equation, reference)
    forces = [s for s in equation.free_symbols if s in candidate.multipliers]
    slots = candidate.configuration.slots
    if len(forces) != 1 or equation.free_symbols & {*slots.accelerations}:
        return ""
    [force] = forces
    slope = equation.diff(force)
    if force in slope.free_symbols or any(base(s) != s and base(s) in slots.coordinates for s in slope.free_symbols):
        return ""
    from lagrange.answers.models.letters import explained_reaction
    from lagrange.answers.models.one_body import explained_by_one_body

    opposite = equation.xreplace({force: -force})  # its name may stand for the opposite force
    for stated in (equation, opposite):
        if why := explained_by_one_body(stated, candidate, reference):
            return why
    for stated in (equation, opposite):
        if why := explained_reaction(stated, candidate.models) or _multiple(stated, force, candidate):
            return why
    return ""


def _multiple(equation: sp.Expr, force: sp.Symbol, candidate: ReferenceCandidate) -> str:
    """The simple ratio of the right force to the stated one, in a sentence; empty if there is none."""
    from lagrange.answers.models.letters import claim_holds
    from lagrange.answers.models.mechanics import Variation

    try:
        states = candidate.models.states([equation])
        equations = candidate.models.system.equations
        waves = sorted({w for e in equations for w in e.atoms(sp.sin, sp.cos) if w.args[0].is_Symbol}, key=str)
        factors = {ratio: _NUMBER.format(ratio) for ratio in RATIOS}
        for wave in waves:
            factors |= {wave: f"a factor {wave} is missing", 1 / wave: f"there is a factor {wave} too many"}
        for factor, said in factors.items():
            if all(claim_holds(equation, Variation("", "", rule={force: force / factor}), at) for at in states):
                return said
    except (NoPointError, UnsupportedError, DivisionByZeroError, InadmissibleError):
        pass
    return ""


def explained_size(claims: Sequence[sp.Expr], reaction: Reaction, reference: Reference, solution: Solution) -> str:
    """How a stated reaction differs from the derived one: by a term, a factor, a sign; empty if not found.

    claims  what may be meant, as expressions that are zero
    """
    from lagrange.answers.models.questions import NO_DEPENDENCE, explained_value

    forces = {reaction.multiplier, reaction.force, reaction.symbol}
    for view in solution.views:
        reactions = view.dynamics.reactions if view.dynamics is not None else None
        candidate = next((c for c in reference.candidates if c.choice == view.name), None)
        if reactions is None or candidate is None:
            continue
        right = reactions.sizes.get(reaction.name, reactions.multipliers.get(reaction.name))
        slots = view.configuration.slots
        moving = {*slots.coordinates, *slots.velocities, *slots.prescribed}
        if right is None or sp.count_ops(right) > LONGEST_COMPARED_REACTION:
            continue
        for zero in claims[:1]:
            if not {base(s).name for s in zero.free_symbols} & reference.moving <= candidate.known:
                continue
            value = candidate.read(-zero.xreplace(dict.fromkeys(forces, sp.S.Zero)))
            if any(base(s) != s and s not in moving and s not in right.free_symbols for s in value.free_symbols):
                continue
            resting = right.xreplace(dict.fromkeys(slots.velocities, sp.S.Zero))
            for whole, beside in ((right, ""), *([(resting, "it is that at rest, and ")] if resting != right else [])):
                for signed in (sp.expand(whole), -sp.expand(whole)):
                    why = explained_value(value, signed, moving)
                    if why and not why.startswith(NO_DEPENDENCE):
                        return f"{beside}{why}"
    return ""


# One sense


_BAD = (Standing.CONTRADICTS, Standing.NOT_LINEAR)


def one_sense(equation: sp.Expr, system: System) -> str:
    """For which sense of the motion a wrong equation is right, in a sentence; empty if for none."""
    for condition in _senses(equation, system):
        return f"it holds only while {text(condition)} > 0: what depends on the sign of a velocity turns with it"
    return ""


def _senses(equation: sp.Expr, system: System) -> Iterator[sp.Expr]:
    """What is positive where the equation follows from the system."""
    velocities = {*system.configuration.slots.velocities}
    signs = {w for e in system.equations for w in e.atoms(sp.sign, sp.Abs) if w.args[0].free_symbols & velocities}
    for u in sorted({w.args[0] for w in signs}, key=sp.default_sort_key)[:MOST_SENSES]:
        for s in (sp.S.One, sp.S.NegativeOne):
            rule = {sp.sign(u): s, sp.Abs(u): s * u}
            one = System(system.configuration, tuple(e.xreplace(rule) for e in system.equations), system.multipliers)
            try:
                result = compare([equation.xreplace(rule)], one)
            except DivisionByZeroError:
                continue
            if result is not None and not {*_BAD} & {*result.standings}:
                yield s * u


def kept_from_start(
    equations: Sequence[Fragment], verdict: AnswerVerdict, initial: Sequence[InitialValue], reference: Reference
) -> AnswerVerdict:
    """The verdict, in which an equation for one sense of the motion is right if the motion keeps this sense.

    A ball that is dropped falls: it starts with y' ≥ 0, and where y' vanishes y'' > 0, so that y' never changes its
    sign. It is asked of a system with one velocity and no multipliers, whose acceleration at rest has one sign.
    """
    if verdict.verdict is not Verdict.WRONG or not initial or len(verdict.equations) != len(equations):
        return verdict
    start = {s.symbol: s.value for s in initial}
    judged = [*verdict.equations]
    for n, e in enumerate(judged):
        if e.verdict is not Verdict.WRONG:
            continue
        fragment = equations[n]
        if not isinstance(fragment, GivenEquation) or len(fragment.reading.components) != 1:
            continue
        [equation] = fragment.reading.components
        kept = next(filter(None, (_kept_sense(c, equation, start) for c in reference.candidates)), None)
        if kept is None:
            continue
        remark = f"{text(kept)} > 0 from the start on, and for this sense it is right"
        judged[n] = EquationVerdict(e.text, Verdict.EQUIVALENT, remarks=(remark,))
    if any(e.verdict is Verdict.WRONG for e in judged):  # something else, as a solution y = f(t)
        return replace(verdict, equations=tuple(judged))
    return replace(verdict, verdict=Verdict.EQUIVALENT, equations=tuple(judged), missing=0, diagnosis="")


def _kept_sense(candidate: ReferenceCandidate, equation: sp.Expr, start: Mapping[sp.Symbol, sp.Expr]) -> sp.Expr | None:
    """The velocity, with a sign, that stays positive after the start, and for which an equation is right; None if
    there is none, or that is not seen."""
    slots = candidate.configuration.slots
    if len(slots.velocities) != 1 or candidate.multipliers or len(candidate.system.equations) != 1:
        return None
    [v], [a], [derived] = slots.velocities, slots.accelerations, candidate.system.equations
    for positive in _senses(candidate.read(equation), candidate.system):
        sense = positive.coeff(v)
        first = start.get(v)
        if positive != sense * v or first is None or not (sense * first).is_nonnegative:
            continue
        at_rest = derived.xreplace({sp.sign(v): sense, sp.Abs(v): sense * v}).xreplace({v: sp.S.Zero})
        slope = at_rest.diff(a)
        if slope != 0 and (-sense * at_rest.xreplace({a: sp.S.Zero}) / slope).is_positive:
            return positive
    return None


def right_as_far_as_stated(
    equations: list[Fragment], verdict: AnswerVerdict, reference: Reference
) -> AnswerVerdict | None:
    """The verdict if each wrong equation is correct under the condition stated with it; None if one is not."""
    judged = [*verdict.equations]
    for n, e in enumerate(judged):
        if e.verdict is not Verdict.WRONG:
            continue
        stated = single_condition(getattr(equations[n], "beside", ""))
        if stated is None or not _holds_where(equations[n], stated, reference):
            return None
        greater, less = stated
        judged[n] = e.__class__(
            e.text,
            Verdict.EQUIVALENT,
            remarks=(f"right while {greater} > {less}; another equation holds while {greater} < {less}",),
        )
    return AnswerVerdict(
        Verdict.INCOMPLETE, tuple(judged), max(1, verdict.missing), verdict.choice, notes=verdict.notes
    )


def _holds_where(equation: Fragment, stated: tuple[str, str], reference: Reference) -> bool:
    if not isinstance(equation, GivenEquation) or len(equation.reading.components) != 1:
        return False
    try:
        greater, less = (read_value(Fragment.of(side), reference.scope, latex=True) for side in stated)
    except ProblemError:
        return False
    if not isinstance(greater, sp.Expr) or not isinstance(less, sp.Expr):
        return False
    (e,) = equation.reading.components
    for c in reference.candidates_for({s.name for s in e.free_symbols}):
        for positive in _senses(c.read(e), c.system):
            ratio = sp.cancel(c.read(greater - less) / positive)
            if ratio.is_positive:
                return True
    return False
