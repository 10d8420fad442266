"""Claims tried at random values of the parameters, on both sides of their limits.

`A if B` is meant to be decisive: A is false where B does not hold. A claim is refuted by values at which it clearly
fails, and confirmed by many at which it holds; the values are drawn around the limit, so that one that is wrong by a
thousandth is found out.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from enum import Enum, auto

import sympy as sp

from lagrange.answers.limits import CLAIM_SAMPLES, CLEAR_STABILITY, DECIDED_CLAIMS, FEWEST_DECIDED
from lagrange.answers.results.at_random import approximate, beside_limit
from lagrange.core.symbols import Bounded
from lagrange.mechanics.equilibrium.searched.newton import random_value
from lagrange.mechanics.results import Solution

Values = dict[sp.Symbol, float]
Trial = Callable[[Values], Iterator[bool | None]]
"""Whether a claim holds at values of the parameters, at each place that it may be about; None is no outcome."""


class Outcome(Enum):
    """What trying a claim has shown."""

    TRUE = auto()
    FALSE = auto()
    SOMETIMES = auto()  # true and false
    OPEN = auto()


def drawn(symbols: Collection[sp.Symbol], angles: Collection[sp.Symbol], draw: random.Random) -> Values:
    """Random values of parameters: acute angles, other parameters of order one."""
    values = {}
    for s in sorted(symbols, key=str):
        if isinstance(s, Bounded):
            values[s] = random_value(s, 1, draw)
        else:
            values[s] = draw.uniform(0.05, 1.5) if s in angles else draw.lognormvariate(0, 0.8)
            values[s] = -values[s] if s.is_nonpositive else values[s]
    return values


def samples(
    symbols: Collection[sp.Symbol], limits: Sequence[sp.Expr], known: Mapping[sp.Symbol, sp.Expr], seed: int = 11
) -> Iterator[Values]:
    """Values of the parameters, and the same moved to both sides of the limits."""
    angles = {s for e in limits for f in e.atoms(sp.sin, sp.cos, sp.tan) for s in f.args[0].free_symbols}
    draw = random.Random(seed)
    for _ in range(CLAIM_SAMPLES):
        values = drawn(symbols, angles, draw) | {s: float(v) for s, v in known.items() if s in symbols}
        yield values
        state = {s: sp.Float(v) for s, v in values.items()}
        for limit in limits:
            for moved in beside_limit(limit, state, known):
                yield {s: float(v) for s, v in moved.items()}


def tried(trials: Iterator[Values], trial: Trial, enough: int = DECIDED_CLAIMS) -> Outcome:
    """What trying a claim at some values has shown."""
    true = false = 0
    for values in trials:
        for right in trial(values):
            true, false = true + (right is True), false + (right is False)
        if true + false >= enough:
            break
    if true + false < FEWEST_DECIDED:
        return Outcome.OPEN
    return Outcome.SOMETIMES if true and false else Outcome.TRUE if true else Outcome.FALSE


def holds(conditions: Sequence[sp.Expr], values: Mapping[sp.Symbol, float]) -> bool | None:
    """Whether all conditions are positive; None if that is not clear."""
    numbers = [approximate(c, values) for c in conditions]
    if any(not abs(n) >= CLEAR_STABILITY for n in numbers):
        return None
    return all(n > 0 for n in numbers)


def agree(condition: Sequence[sp.Expr], truth: sp.Expr, solution: Solution, where: Sequence[sp.Expr] = ()) -> Outcome:
    """Whether conditions hold exactly where the truth is positive. where: what must be positive for all this."""
    symbols = {s for e in (*condition, truth, *where) for s in e.free_symbols}
    known = {p.symbol: sp.Rational(p.value) for p in solution.problem.parameters if p.value is not None}

    def trial(values: Values) -> Iterator[bool | None]:
        stated, right = holds(condition, values), holds([truth], values)
        meant = holds(where, values) if where else True
        yield None if stated is None or right is None or meant is not True else stated is right

    return tried(samples(symbols, [*condition, truth], known), trial)
