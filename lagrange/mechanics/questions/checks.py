"""Checks of the answers to questions.

Every point of an answer has been substituted back into the equations that it was found from, exactly. The second route
uses neither d'Alembert's principle nor the solved reactions: at sampled values of the parameters, the state of an
answer is put into Lagrange's equations with multipliers in the file's coordinates, these are solved for accelerations
and multipliers in numbers, and the conditions and the quantity of the question are evaluated with them.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import sympy as sp

from lagrange.core.records import all_hold, record
from lagrange.core.symbols import Sign, Unspecified, t
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.checks import Check, multiplier_system
from lagrange.mechanics.dynamics.lagrangian import kinetic_energy, lagrange_equations
from lagrange.mechanics.questions.limits import DIGITS, MOST_SAMPLED_STATES, SAMPLES, SAMPLES_TRIED
from lagrange.mechanics.questions.results import AnswerBranch, Asked, How
from lagrange.mechanics.questions.states import MotionView
from lagrange.problem.model import ENERGY, KINETIC_ENERGY

Numbers = Mapping[sp.Symbol, sp.Expr]
_TOLERANCE = sp.Float(10) ** (-DIGITS // 2)
_PRIMES = (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31)


def check_questions(asked: Sequence[Asked], places: Sequence[MotionView]) -> list[Check]:
    """That the answers satisfy their equations, and the conditions by another route."""
    exact = [a for a in asked if a.answered and a.how is How.EXACT]
    if not exact:
        return []
    verdicts = [a.verified for a in exact]
    satisfied = all_hold(verdicts)
    checks = [Check("the answers to the questions satisfy the equations they were found from", satisfied, "exact")]
    own = next((p for p in places if not p.name), None)
    if own is None or not own.configuration.constrained.is_pfaffian:
        return checks
    second = _SecondRoute(own)
    named = {p.name: p for p in places}
    results = [r for a in exact for r in second.of(a, named[a.choice].configuration)]
    if results:
        name = "the conditions and quantities of the questions, from Lagrange's equations in numbers"
        checks.append(Check(name, all(results), f"at sampled values, {len(results)} states"))
    return checks


@record
class _System:
    rows: tuple[tuple[sp.Expr, ...], ...]
    right: tuple[sp.Expr, ...]
    unknowns: tuple[sp.Symbol, ...]


class _SecondRoute:
    """Lagrange's equations with multipliers in the file's coordinates, solved numerically at states of answers."""

    def __init__(self, own: MotionView) -> None:
        self.own = own
        configuration = own.configuration
        by_name = own.law.newton.multipliers_by_name
        used = tuple(by_name[row.name] for row in configuration.rows)
        lagrange = lagrange_equations(configuration)
        system = multiplier_system(configuration, lagrange.left, used)
        equations = [*system.equations, *system.accelerated_constraints]
        unknowns = (*configuration.slots.accelerations, *used)
        rest = dict.fromkeys(unknowns, sp.S.Zero)
        self.system = _System(
            tuple(tuple(e.diff(u) for u in unknowns) for e in equations),
            tuple(-e.xreplace(rest) for e in equations),
            unknowns,
        )
        problem = own.law.problem
        self.parameters = (*(p.symbol for p in problem.parameters), *problem.unknowns)
        self.values = problem.given_values
        self.meanings = dict(own.law.newton.single_forces)
        self.energies = {KINETIC_ENERGY: kinetic_energy(configuration)}

    def of(self, asked: Asked, configuration: Configuration) -> Iterator[bool]:
        """Whether conditions and quantity agree at each state that could be evaluated."""
        question = asked.question
        expressions = [question.quantity, *(c.function for c in question.when)]
        if any(e.has(Unspecified) or ENERGY in e.free_symbols for e in expressions):
            return
        for b in asked.branches:
            if any(c.relation == "=" for c in b.conditions):
                continue
            for state in b.states[:MOST_SAMPLED_STATES]:
                value = b.values[0] if len(b.values) == 1 else question.quantity
                symbols = self.parameters if question.by is None else (*self.parameters, question.by)
                for numbers in _samples(b, symbols, self.values):
                    agreed = self._agrees(asked, configuration, state, value, numbers)
                    if agreed is not None:
                        yield agreed

    def _agrees(
        self,
        asked: Asked,
        configuration: Configuration,
        state: Numbers,
        value: sp.Expr,
        numbers: dict[sp.Symbol, sp.Expr],
    ) -> bool | None:
        """Whether all holds at one state; None if the state is not known in full."""
        question = asked.question
        at = dict(numbers)
        if question.quantity in self.parameters:
            number = _number(value, numbers)
            if number is None:
                return None
            at[question.quantity] = number
        for v, sense in asked.senses.items():  # the equations of motion hold for this sense of the slip alone
            speed = _number(state[v], at) if v in state else None
            if speed is not None and speed * sense < 0:
                return None
        verdicts = {self._holds_at(asked, configuration, state, value, at, sp.Rational(filled, 7)) for filled in (3, 5)}
        return verdicts.pop() if len(verdicts) == 1 else None

    def _holds_at(
        self,
        asked: Asked,
        configuration: Configuration,
        state: Numbers,
        value: sp.Expr,
        at: dict[sp.Symbol, sp.Expr],
        filled: sp.Expr,
    ) -> bool | None:
        """Whether everything holds at one state, with numbers for coordinates neither given nor constrained."""
        own, present = self.own.configuration.slots, configuration.slots
        question = asked.question
        bound = {s for row in configuration.rows for s in (row.finite or sp.S.Zero).free_symbols}
        place: dict[sp.Symbol, sp.Expr] = {
            q: filled for q in present.coordinates if q not in {*state, *bound, question.by}
        }
        for s, e in state.items():
            if s in (t, *present.coordinates, *present.velocities) and s != question.by:
                number = _number(e, at)
                if number is None:
                    return None
                place[s] = number
        for s in (*own.coordinates, *own.velocities):
            number = _number(configuration.rewritten(s), {**at, **place})
            if number is None:
                return None
            place[s] = number
        full = {**at, **place}
        # Slip that only begins has no sign yet: that in which it begins.
        begins = {sp.sign(v): sp.Integer(s) for v, s in asked.senses.items() if _number(v, full) == 0}
        matrix = [[_number(e.xreplace(begins), full) for e in row] for row in self.system.rows]
        right = [_number(e.xreplace(begins), full) for e in self.system.right]
        if None in right or any(None in row for row in matrix):
            return None
        rows = [[e for e in (*row, b) if e is not None] for row, b in zip(matrix, right, strict=True)]
        solved = _solved(rows)
        if solved is None:
            return None
        full |= dict(zip(self.system.unknowns, solved, strict=True))
        differences = [c.function for c in question.when]
        differences += [question.quantity - value] if question.quantity not in self.parameters else []
        for e in differences:
            residual = _number(e.xreplace(self.energies).xreplace(self.meanings), full)
            if residual is None:
                return None
            if abs(residual) > _TOLERANCE * 1000:
                return False
        return True


def _solved(rows: list[list[sp.Expr]]) -> list[sp.Expr] | None:
    """The solution of A x = b, rows [A | b], with the largest pivot of each column; None if there is none, or many."""
    size = len(rows[0]) - 1
    if len(rows) != size:
        return None
    for k in range(size):
        at = max(range(k, size), key=lambda n: abs(rows[n][k]))
        rows[k], rows[at] = rows[at], rows[k]
        if abs(rows[k][k]) < _TOLERANCE:
            return None
        rows[k] = [e / rows[k][k] for e in rows[k]]
        for n in range(size):
            if n != k and rows[n][k] != 0:
                rows[n] = [a - rows[n][k] * b for a, b in zip(rows[n], rows[k], strict=True)]
    return [row[-1] for row in rows]


def _samples(b: AnswerBranch, symbols: Sequence[sp.Symbol], values: Numbers) -> Iterator[dict[sp.Symbol, sp.Expr]]:
    """Numbers for the symbols with which the conditions of a branch hold, those of the file first."""
    taken = 0
    for trial in range(SAMPLES_TRIED):
        numbers = {s: _sample(s, trial) for s in symbols} | (dict(values) if trial == 0 else {})
        if all(_holds(c.lhs - c.rhs, c.relation, numbers) for c in b.conditions):
            yield numbers
            taken += 1
        if taken == SAMPLES:
            return


def _sample(symbol: sp.Symbol, trial: int) -> sp.Expr:
    """A positive number that depends on the name and on the trial."""
    if isinstance(symbol, Sign):
        return sp.S.One
    place = sum(ord(c) for c in symbol.name) + 3 * trial
    return sp.Rational(_PRIMES[place % 11], _PRIMES[(5 * place + trial + 3) % 11])


def _holds(difference: sp.Expr, relation: str, numbers: Numbers) -> bool:
    value = _number(difference, numbers)
    if value is None:
        return False
    return bool({"≥": value > 0, ">": value > 0, "≤": value < 0, "<": value < 0, "≠": value != 0}[relation])


def _number(e: sp.Expr, numbers: Numbers) -> sp.Expr | None:
    """An expression in numbers; None if it is not real, or a symbol has none."""
    if not e.free_symbols <= numbers.keys():
        return None
    value = sp.N(e.xreplace(dict(numbers)), DIGITS)
    return value if value.is_Float or value.is_Rational else None
