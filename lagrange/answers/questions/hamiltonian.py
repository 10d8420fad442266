"""Is the stated Hamilton's function right?

It is an expression in the coordinates, the momenta p_θ and time, or an equation `H = ...`. It must equal the derived
one, exactly; a function that differs by a constant gives the same equations, and counts as right with a remark.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError
from lagrange.answers.questions.asked_quantities import read_stated
from lagrange.answers.references import Reference, reference_of_solution
from lagrange.answers.verdicts import DIVIDES_BY_ZERO, UNDECIDED, AnswerVerdict, EquationVerdict, Verdict
from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError
from lagrange.core.symbols import partial, t
from lagrange.core.verdicts import all_hold
from lagrange.expressions.reader import Scope
from lagrange.mechanics.momenta.hamiltonian import Hamiltonian
from lagrange.mechanics.results import Solution

_NOT_DERIVED = "the problem does not ask for Hamilton's function"
_CONSTANT = "it differs from the derived function by a constant, which changes no equation"
_TIME = "it differs from the derived function by a function of time, which changes no equation"
_VELOCITIES = "it contains velocities: Hamilton's function is one of coordinates and momenta"


def check_hamiltonian_answer(stated: Fragment, solution: Solution) -> AnswerVerdict:
    """The verdict on the stated Hamilton's function, in the coordinates in which it is right if there are any."""
    derived = [v.hamiltonian for v in solution.views if v.hamiltonian is not None]
    if not derived:
        return AnswerVerdict(Verdict.UNDECIDED, name="hamiltonian", diagnosis=_NOT_DERIVED)
    reference = reference_of_solution(solution)
    try:
        scope = _scope(reference.scope, derived, frozenset(solution.problem.scope.names()))
        claim, _ = read_stated(stated, scope, "H")
        if claim is None:
            message = "this is an equation, not an expression for Hamilton's function"
            help_ = "write the expression, or `H = ...`"
            raise ProblemError(Diagnostic("unexpected-equation", message, stated.whole, help=help_))
    except ProblemError as error:
        part = EquationVerdict(stated.text, Verdict.UNREADABLE, error.diagnostics[0].message)
        return AnswerVerdict(Verdict.UNREADABLE, (part,), unreadable=tuple(error.diagnostics), name="hamiltonian")
    order = (Verdict.EQUIVALENT, Verdict.UNDECIDED, Verdict.WRONG, Verdict.UNREADABLE)
    verdict, remark = min((_verdict(claim, d, reference) for d in derived), key=lambda pair: order.index(pair[0]))
    return AnswerVerdict(verdict, (EquationVerdict.of(stated.text, verdict, remark),), name="hamiltonian")


def _verdict(claim: sp.Expr, derived: Hamiltonian, reference: Reference) -> tuple[Verdict, str]:
    """The verdict on an expression, with a remark or a diagnosis."""
    slots, states = derived.configuration.slots, derived.configuration.states
    if claim.free_symbols & {*slots.velocities, *slots.accelerations}:
        return Verdict.WRONG, _VELOCITIES
    by_momenta = dict(zip(derived.momenta, derived.energies.momenta, strict=True))
    difference = (claim - derived.function).xreplace(dict(reference.values))

    def vanish(expressions: Sequence[sp.Expr]) -> bool | None:
        return all_hold(states.is_zero(e.xreplace(by_momenta)) for e in expressions)

    try:
        if (same := vanish([difference])) is not False:
            return (Verdict.EQUIVALENT, "") if same else (Verdict.UNDECIDED, UNDECIDED)
        same = vanish([partial(difference, s) for s in (*slots.coordinates, *derived.momenta)])
    except DivisionByZeroError:
        return Verdict.UNREADABLE, DIVIDES_BY_ZERO
    if same:
        return Verdict.EQUIVALENT, _TIME if difference.has(t) else _CONSTANT
    if same is None:
        return Verdict.UNDECIDED, UNDECIDED
    return Verdict.WRONG, _explained(claim, derived, lambda e: vanish([e - derived.function]) is True)


def _explained(claim: sp.Expr, derived: Hamiltonian, right: Callable[[sp.Expr], bool]) -> str:
    """What a wrong function is instead, in a sentence; empty if that is not found."""
    from lagrange.answers.models.letters import letter_variations
    from lagrange.answers.models.questions import explained_value

    slots = derived.configuration.slots
    moving = derived.function.free_symbols & {*derived.momenta}
    potential = derived.function.xreplace(dict.fromkeys(derived.momenta, sp.S.Zero))
    if moving and right(claim + 2 * potential) and potential != 0:
        return "this is T - V in the momenta: the Lagrangian, and not T + V"
    if why := explained_value(claim, derived.function, {*slots.coordinates, *derived.momenta}):
        return why
    for variation in letter_variations([claim], [derived.function], slots, derived.momenta):
        if variation.rule and right(claim.xreplace(dict(variation.rule))):
            return f"this is the function {variation.clause}"
    return ""


def _scope(scope: Scope, derived: Sequence[Hamiltonian], declared: frozenset[str]) -> Scope:
    """The names that an answer may use, with the momenta, and without the derived H unless the file has one."""
    momenta = {p.name: p for d in derived for p in d.momenta}
    momenta |= {n.replace("phi", "varphi"): p for n, p in momenta.items() if n.startswith("p_phi")}
    if len(momenta) == 1 and "p" not in declared:
        momenta |= {"p": next(iter(momenta.values()))}
    return replace(scope, scalars={n: e for n, e in scope.scalars.items() if n != "H" or n in declared} | momenta)
