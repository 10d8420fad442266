"""Questions about a system at rest: the couple that holds a crank at 60°, the force in a bar in a given position.

At rest the forces balance for each coordinate of the file,

    Q_k + Σ_j λ_j a_jk = 0 ,

with the multipliers λ of all constraints. Together with the constraints and the conditions of the question, these are
equations for coordinates, unknown forces and multipliers, from which the quantity is eliminated. Conditions on
parameters alone, a = 3 h/2 or tan β = μ, are put in before that. Positions outside of
the ranges of the coordinates do not count. Friction at its limit is part of Q, and the law of a belt is one equation
more; friction at rest that is not at its limit is one unknown force more in each contact.

The second route puts each position into Lagrange's equations at rest, in numbers.

The critical value of a parameter: a column is in equilibrium upright under any load P. Asked for P in that position, a
book means the load under which it buckles. The conditions of stability are the signs of minors of V_kj, functions f(P)
in which P has at most the second power; between neighbouring roots of all of them no sign changes. The root at which
stability ends, or begins, is the critical value if it is the only one. Signs and the order of the roots are decided
exactly, for all values of the other parameters, or there is no answer.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cmp_to_key
from itertools import pairwise

import sympy as sp

from lagrange.algebra.closed_forms.conditions import NeverPositiveError, conditions_for, positive_part
from lagrange.algebra.closed_forms.polynomial_roots import numerator
from lagrange.algebra.closed_forms.shortest_form import shortest_form
from lagrange.algebra.closed_forms.signs import SignCondition, sign_of, sign_on
from lagrange.algebra.closed_forms.unit_circle import NotAlgebraicError
from lagrange.algebra.exact.expression_graph import DivisionByZeroError
from lagrange.algebra.exact.zero_test import is_zero
from lagrange.core.diagnostics import Diagnostic, ProblemError
from lagrange.core.records import all_hold, record
from lagrange.core.symbols import base, t
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.checks import Check
from lagrange.mechanics.dynamics.lagrangian import lagrange_equations
from lagrange.mechanics.dynamics.newton import Newton, Reaction
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium, virtual_work
from lagrange.mechanics.equilibrium.friction.impending_motion import ImpendingMotion
from lagrange.mechanics.equilibrium.friction.rough_contacts import rough_contacts
from lagrange.mechanics.equilibrium.stability import SecondVariation, StabilityVerdict
from lagrange.mechanics.questions.elimination import Eliminated, eliminated
from lagrange.mechanics.questions.forms import joined_conditions, settled
from lagrange.mechanics.questions.limits import DIGITS
from lagrange.mechanics.questions.ranges import in_ranges
from lagrange.mechanics.questions.results import AnswerBranch, Asked, How, Reason, Route, Substituted
from lagrange.mechanics.questions.setting import may_equal, related_parameters
from lagrange.problem.keys import Find
from lagrange.problem.model import Problem, Question

_TOLERANCE = sp.Float(10) ** (-DIGITS // 2)
_PRIMES = (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37)


def are_about_rest(problem: Problem) -> bool:
    """Whether no question mentions time, a velocity or an acceleration."""
    symbols = {
        s for q in problem.questions for e in (q.quantity, *(c.function for c in q.when)) for s in e.free_symbols
    }
    return not problem.initial and t not in symbols and all(base(s) == s for s in symbols)


@record
class RestLaw:
    """The equations of rest in the file's coordinates, without the reactions.

    forces       shape (n,): Q_k, with the friction
    laws         further equations, each zero
    friction     the unknown forces of friction among them
    equilibrium  with friction the one at its limit; None where friction is not at its limit
    """

    configuration: Configuration
    forces: tuple[sp.Expr, ...]
    laws: tuple[sp.Expr, ...] = ()
    friction: tuple[sp.Symbol, ...] = ()
    equilibrium: Equilibrium | None = None

    def shares_of_friction(self) -> list[sp.Expr]:
        """The parts of Q_k that are friction not at its limit."""
        smooth = dict.fromkeys(self.friction, sp.S.Zero)
        return [q - q.xreplace(smooth) for q in self.forces]


def law_of_rest(
    problem: Problem,
    configuration: Configuration,
    equilibrium: Equilibrium | None,
    impending: Sequence[ImpendingMotion] | None,
    newton: Newton | None,
) -> RestLaw:
    """The equations of rest in the file's coordinates; with `find: impending`, with friction at its limit.

    Raises ProblemError where friction at its limit may act in several senses, or was found in other coordinates.
    """
    if equilibrium is None and Find.IMPENDING not in problem.find and newton is not None:
        touching = rough_contacts(problem, newton, configuration, configuration)
        contacts = [c for c in touching if not c.keeping]  # of the others the reaction is in the balance already
        friction = [
            [f * row[k] for c in contacts for f, row in zip(c.components, c.generalized, strict=True)]
            for k in range(len(configuration.slots.coordinates))
        ]
        forces = tuple(sp.Add(q, *f) for q, f in zip(virtual_work(configuration).forces, friction, strict=True))
        return RestLaw(configuration, forces, friction=tuple(f for c in contacts for f in c.components))
    resting = equilibrium or _at_its_limit(impending, problem.questions[0])
    return RestLaw(resting.configuration, resting.work.forces, resting.laws, equilibrium=resting)


def _at_its_limit(impending: Sequence[ImpendingMotion] | None, first: Question) -> Equilibrium:
    """The only equilibrium with friction at its limit. Raises ProblemError naming the first question."""
    if impending is not None and len(impending) == 1:
        return impending[0].equilibrium
    if impending:
        message = f"the question `{first.name}` has several answers: nothing says which way things are about to slip"
        help_ = "give `slip` to each friction, a vector: `slip: -i`"
    else:
        message = f"the question `{first.name}` is about rest with friction, in the file's own coordinates"
        help_ = "leave `generalized_coordinates` out, or the question"
    raise ProblemError(Diagnostic("not-determined", message, first.span, help=help_))


def answers_at_rest(
    problem: Problem, law: RestLaw, newton: Newton | None, second: SecondVariation | None = None
) -> tuple[tuple[Asked, ...], list[Check]]:
    """The answers to all questions, and the checks of these.

    newton   the reactions; None without constraints
    second   the stability of the branches of equilibrium

    Raises ProblemError if nothing determines the quantity, or the conditions hold in no position of equilibrium.
    """
    reactions = () if newton is None else newton.reactions
    balance = [sp.Add(q, *(r.multiplier * r.row.coefficients[k] for r in reactions)) for k, q in enumerate(law.forces)]
    balance += [e.xreplace({r.force: r.multiplier / r.per_force for r in reactions}) for e in law.laws]
    asked = tuple(_answer(q, problem, law, reactions, balance, second) for q in problem.questions)
    return asked, _checks(asked, problem, law, newton)


def _answer(
    question: Question,
    problem: Problem,
    law: RestLaw,
    reactions: Sequence[Reaction],
    balance: list[sp.Expr],
    second: SecondVariation | None,
) -> Asked:
    configuration = law.configuration
    sizes = {r.force: r.single.factor * r.multiplier for r in reactions if r.single is not None and r.named}
    sizes |= {
        r.symbol: r.single.factor * r.multiplier for r in reactions if r.single is not None and r.symbol is not None
    }

    def applied(e: sp.Expr) -> sp.Expr:
        return configuration.rewritten(e).xreplace(sizes)

    quantity = applied(question.quantity)
    conditions = tuple((applied(c.lhs), applied(c.rhs)) for c in question.when)
    parameters = {p.symbol for p in problem.parameters}
    wanted = sorted(question.quantity.free_symbols & parameters, key=str)
    is_parameter = bool(wanted) and question.quantity.free_symbols <= parameters
    unknowns = [*configuration.slots.coordinates, *problem.unknowns, *(r.multiplier for r in reactions), *law.friction]
    unknowns += wanted[:1] if is_parameter else []
    if question.by is not None:
        unknowns.remove(question.by)
    values = problem.given_values
    between = [a - b for a, b in conditions if (a - b).free_symbols <= parameters.difference(unknowns)]
    related = related_parameters(between, values)
    if related is None:
        return Asked(question, configuration.name, None, Route.REST, conditions=conditions, quantity=quantity)
    rule, real_where = related
    if any(not may_equal(p, e) for p, e in rule.items()):
        raise ProblemError(_never_holds(question))
    equations = [*(a - b for a, b in conditions if a - b not in between), *configuration.finite_constraints, *balance]
    equations = [e.xreplace(rule) for e in equations]
    elimination = eliminated(equations, quantity.xreplace(rule), unknowns, (), question.quantity)
    branches = [
        replace(
            b,
            conditions=(*b.conditions, *real_where),
            states=tuple({**rule, **_limiting(state, equations, parameters, values), **state} for state in b.states),
        )
        for b in elimination.branches
    ]
    kept = [b for b in (in_ranges(b, configuration, values) for b in branches) if b is not None]
    if question.quantity.is_positive:  # √(μ g/r) for a speed of rotation that the file takes to be positive
        kept = [b for b in kept if not b.values or any(sign_of(v) != -1 for v in b.values)]
    kept = [b for b in (_where_pressed(b, reactions) for b in kept) if b is not None]
    kept, opposite = _without_opposite(question.quantity, kept, equations)
    kept = _with_places(kept, configuration.slots.coordinates)
    if elimination.never or (elimination.solved and not elimination.free and not kept):
        raise ProblemError(_never_holds(question))
    if elimination.solved and elimination.free:
        limit = critical_value(wanted[0], conditions, law, second) if wanted == [question.quantity] else None
        if limit is None:
            raise ProblemError(_not_determined(question, elimination, law))
        return Asked(
            question,
            configuration.name,
            How.EXACT,
            Route.STABILITY,
            conditions=conditions,
            quantity=quantity,
            branches=(limit,),
            verified=True,
        )
    used = [
        s
        for s in sizes
        if s in question.quantity.free_symbols | set().union(*(c.function.free_symbols for c in question.when))
    ]
    return Asked(
        question,
        configuration.name,
        How.EXACT if kept and elimination.solved else None,
        Route.REST,
        used=tuple(Substituted(s, sizes[s]) for s in sorted(used, key=str) if sizes[s] != s),
        conditions=conditions,
        quantity=quantity,
        related={**rule, **_shared(kept, parameters)},
        branches=tuple(kept) if elimination.solved else (),
        dropped=tuple((b, Reason.OPPOSITE) for b in opposite) if elimination.solved else (),
        verified=elimination.verified,
    )


def _shared(branches: Sequence[AnswerBranch], parameters: Collection[sp.Symbol]) -> dict[sp.Symbol, sp.Expr]:
    """The parameters in terms of others that are the same in all states: at the limit the slope gives μ."""
    states = [s for b in branches for s in b.states]
    first = states[0] if states else {}
    return {p: e for p, e in first.items() if p in parameters and all(s.get(p) == e for s in states)}


def _limiting(
    state: Mapping[sp.Symbol, sp.Expr],
    equations: Sequence[sp.Expr],
    parameters: Collection[sp.Symbol],
    values: Mapping[sp.Symbol, sp.Expr],
) -> dict[sp.Symbol, sp.Expr]:
    """Parameters without values, where the equations relate them in a position: how far the man gets up a ladder.

    A ladder whose constraints hold it, with friction at its limit, slips for one place of the man alone, whatever the
    quantity that is asked for there.
    """
    there = [sp.expand(e.xreplace(dict(state))) for e in equations]
    related = related_parameters([e for e in there if e.free_symbols <= {*parameters}], values)
    return {} if related is None or not values.keys().isdisjoint(related[0]) else related[0]


def _where_pressed(branch: AnswerBranch, reactions: Sequence[Reaction]) -> AnswerBranch | None:
    """The branch with the conditions under which what is one-sided presses or pulls there; None if it cannot.

    The edge of a kerb presses on a wheel of radius r with R = W r/(r − h): there is no such position for h > r.
    """
    forces = [r.single.factor * r.multiplier for r in reactions if r.constraint.side is not None and r.single]
    known = [positive_part(c) for c in branch.conditions if c.relation in "<>"]
    found: list[tuple[SignCondition, ...]] = []
    states = []
    for state in branch.states:
        there = [shortest_form(f.xreplace(dict(state))) for f in forces]
        asked = [f for f in there if f.free_symbols.isdisjoint(state) and sign_of(f) not in (0, 1)]
        try:
            found.append(conditions_for(asked, known) or ())
        except NeverPositiveError:
            continue
        states.append(state)
    if branch.states and not states:
        return None
    branch = branch.at(states)
    if not found or not found[0] or any(set(f) != set(found[0]) for f in found):
        return branch
    pressing = [replace(c, relation={">": "≥", "<": "≤"}.get(c.relation, c.relation)) for c in found[0]]
    conditions = settled(joined_conditions((*branch.conditions, *pressing)), branch.rhs)
    above = [positive_part(c) for c in conditions if c.relation in "<>"]
    weaker = [c for c in conditions if c.relation in "≤≥" and sign_on(_not_negative(c), above) in (0, 1)]
    return replace(branch, conditions=tuple(c for c in conditions if c not in weaker))


def _not_negative(c: SignCondition) -> sp.Expr:
    return c.lhs - c.rhs if c.relation == "≥" else c.rhs - c.lhs


def _with_places(branches: list[AnswerBranch], coordinates: Sequence[sp.Symbol]) -> list[AnswerBranch]:
    """Several answers, each with the coordinates in which its position differs from the others: where y = √3 r."""
    if len(branches) < 2 or any(len(b.states) != 1 for b in branches):
        return branches
    states = [b.states[0] for b in branches]
    differing = [q for q in coordinates if len({s.get(q) for s in states}) > 1 and all(q in s for s in states)]
    return [
        replace(b, conditions=(*b.conditions, *(SignCondition(q, "=", b.states[0][q]) for q in differing)))
        for b in branches
    ]


def _without_opposite(
    quantity: sp.Expr, branches: list[AnswerBranch], equations: Sequence[sp.Expr]
) -> tuple[list[AnswerBranch], list[AnswerBranch]]:
    """The branches, and apart the negative one of two opposite values of what occurs in even powers only: a charge."""
    if len(branches) != 2 or not quantity.is_Symbol or any(len(b.values) != 1 for b in branches):
        return branches, []
    one, other = (b.values[0] for b in branches)
    even = all(is_zero(e - e.xreplace({quantity: -quantity})) for e in equations)
    signs = [sign_of(b.values[0]) for b in branches]
    if not even or not is_zero(one + other) or {*signs} != {1, -1}:
        return branches, []
    return [branches[signs.index(1)]], [branches[signs.index(-1)]]


def _never_holds(question: Question) -> Diagnostic:
    first = question.when[0].span if question.when else question.span
    message = f"the `when` of the question `{question.name}` holds in no position of equilibrium"
    help_ = "check the condition: the constraints and the balance of the forces exclude it"
    return Diagnostic("never-holds", message, first, help=help_)


def _not_determined(question: Question, elimination: Eliminated, law: RestLaw) -> Diagnostic:
    listed = ", ".join(f"`{s}`" for s in sorted(elimination.free, key=str))
    message = f"the quantity of the question `{question.name}` is not determined: it depends on {listed}"
    help_ = "say in which position it is wanted, with `when`"
    if question.when and elimination.free == {question.quantity}:
        help_ = "there the forces balance for every value; what is stable is said with the equilibria, so leave it out"
    if law.friction:
        help_ = (
            "friction that is not at its limit may have several values: `find: impending` asks for those at the limit"
        )
    return Diagnostic("not-determined", message, question.written.whole, help=help_)


def _checks(asked: Sequence[Asked], problem: Problem, law: RestLaw, newton: Newton | None) -> list[Check]:
    """That the answers satisfy their equations, and that Lagrange's equations hold at rest with them."""
    exact = [a for a in asked if a.answered]
    if not exact:
        return []
    verdicts = [a.verified for a in exact]
    satisfied = all_hold(verdicts)
    checks = [Check("the answers to the questions satisfy the equations they were found from", satisfied, "exact")]
    results = [r for a in exact for r in _at_sampled_values(a, problem, law, newton)]
    if results:
        name = "the conditions and quantities of the questions, from Lagrange's equations in numbers"
        checks.append(Check(name, all(results), f"at sampled values, {len(results)} states"))
    return checks


def _at_sampled_values(asked: Asked, problem: Problem, law: RestLaw, newton: Newton | None) -> Iterator[bool]:
    """Whether Lagrange's equations can be satisfied at rest in the positions of an answer, and give its value."""
    configuration = law.configuration
    slots = configuration.slots
    still = dict.fromkeys((*slots.velocities, *slots.accelerations), sp.S.Zero)
    reactions = () if newton is None else newton.reactions
    equations = [
        sp.Add(left.xreplace(still), -share, *(-r.multiplier * r.row.coefficients[k] for r in reactions))
        for k, (left, share) in enumerate(
            zip(lagrange_equations(configuration).left, law.shares_of_friction(), strict=True)
        )
    ]
    numbers = problem.given_values
    open_ = [p.symbol for p in problem.parameters if p.value is None]
    numbers |= {s: sp.Rational(_PRIMES[n % len(_PRIMES)], 7) for n, s in enumerate(open_)}
    for b in asked.branches:
        for n, state in enumerate(b.states):
            value = b.values[n] if len(b.values) == len(b.states) else b.values[0]
            related = {s: e.xreplace(numbers) for s, e in state.items() if s in numbers}  # μ of two coefficients
            known = {s: e.xreplace({**numbers, **related}).evalf(DIGITS) for s, e in state.items()} | related
            own = {**numbers, **known}
            if not all(e.is_number and e.is_real for e in known.values()):
                continue
            left = [e.xreplace(own).evalf(DIGITS) for e in equations]
            if any(e.free_symbols for e in left):
                continue
            scale = 1 + max((abs(e) for e in known.values()), default=0)
            balanced = all(abs(e) < _TOLERANCE * scale for e in left)
            quantity = (asked.quantity - value).xreplace(own).evalf(DIGITS)
            yield bool(balanced and (quantity.free_symbols or abs(quantity) < _TOLERANCE * scale))


# -- critical values ----------------------------------------------------------------------------------------------

Condition = tuple[sp.Expr, sp.Expr]


class _OpenError(Exception):
    """A sign or an order depends on the parameters."""


def critical_value(
    parameter: sp.Symbol, when: Sequence[Condition], law: RestLaw, second: SecondVariation | None
) -> AnswerBranch | None:
    """The value of a parameter at which the equilibrium that `when` names becomes unstable; None if not found."""
    there = [] if law.equilibrium is None else [*_branches_where(when, law.equilibrium)]
    if second is None or len(there) != 1:
        return None
    [(n, state)] = there
    stability = second.verdicts[n]
    if stability.verdict is not StabilityVerdict.CONDITIONAL:
        return None
    wanted = [_positive_where_stable(c) for c in stability.conditions]
    try:
        value = _limit_of_stability(wanted, parameter)
    except _OpenError:
        return None
    return None if value is None else AnswerBranch(parameter, value, (value,), ({**state, parameter: value},))


def _branches_where(when: Sequence[Condition], resting: Equilibrium) -> Iterator[tuple[int, dict[sp.Symbol, sp.Expr]]]:
    """The branches with one point, at which the conditions hold, and the values of the coordinates there."""
    coordinates = resting.configuration.slots.coordinates
    for n, b in enumerate(resting.branches):
        state = {r.lhs: r.rhs for r in b.equations if isinstance(r.lhs, sp.Symbol)}
        if b.left or b.special or len(b.points) != 1 or not {*coordinates} <= state.keys():
            continue
        try:
            if all(is_zero((left - right).xreplace(state)) for left, right in when):
                yield n, {q: state[q] for q in coordinates}
        except (NotAlgebraicError, DivisionByZeroError):
            continue


def _positive_where_stable(c: SignCondition) -> sp.Expr:
    return c.lhs - c.rhs if c.relation in (">", "≥") else c.rhs - c.lhs


def _limit_of_stability(wanted: Sequence[sp.Expr], parameter: sp.Symbol) -> sp.Expr | None:
    """The only positive value at which it changes whether all expressions are positive. Raises _OpenError."""
    roots: list[sp.Expr] = []
    for e in wanted:
        roots += [r for r in _positive_roots(e, parameter) if not any(is_zero(r - known) for known in roots)]
    roots.sort(key=cmp_to_key(_order))
    if not roots:
        return None
    between = [roots[0] / 2, *((a + b) / 2 for a, b in pairwise(roots)), 2 * roots[-1]]
    stable = [all(_sign(e.xreplace({parameter: p})) == 1 for e in wanted) for p in between]
    limits = [r for r, before, after in zip(roots, stable, stable[1:], strict=False) if before != after]
    return limits[0] if len(limits) == 1 else None


def _positive_roots(e: sp.Expr, parameter: sp.Symbol) -> Iterator[sp.Expr]:
    if e.coeff(parameter) in (1, -1) and not (rest := e - e.coeff(parameter) * parameter).has(parameter):
        value = -rest * e.coeff(parameter)  # as it is written: P < K (3/2 − √5/2)/l
        yield from [value] if _sign(value) == 1 else ()
        return
    parts = numerator(e)
    if parts is None or not parts[0].is_polynomial(parameter):
        raise _OpenError
    poly = sp.Poly(parts[0], parameter)
    if poly.degree() == 0:
        return
    if poly.degree() > 2:
        raise _OpenError
    a, b, c = poly.nth(2), poly.nth(1), poly.nth(0)
    if a == 0:
        found = [-c / b]
    else:
        square = sp.factor(b**2 - 4 * a * c)
        if _sign(square) != 1:
            raise _OpenError
        found = [(-b + s * sp.sqrt(square)) / (2 * a) for s in (1, -1)]
    yield from (shortest_form(sp.factor(sp.expand(r))) for r in found if _sign(r) == 1)


def _order(a: sp.Expr, b: sp.Expr) -> int:
    return _sign(a - b)


def _sign(e: sp.Expr) -> int:
    sign = sign_of(sp.factor(sp.expand(e)))
    if sign is None:
        raise _OpenError
    return sign
