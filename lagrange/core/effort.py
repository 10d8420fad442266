"""One allowance of work for everything that a solve or a check does, counted in operations and not in seconds.

    with allowed(UNITS):
        ...             # raises GivenUpError after so many units

What is counted is the same on every machine: a unit is one operand of a sum or a product that SymPy puts together, ten
nodes of an expression evaluated at a random point, or two terms of a Fourier sum. SymPy has no such count, so its
`Add.flatten` and `Mul.flatten`, through which every sum and product passes, report here from the first allowance on;
outside of one their reports are ignored.

Much of SymPy's work puts nothing together: it walks through an expression, whose parts it visits as often as they
occur in it, although they exist once (`replace`, `free_symbols`, `has`, substitution); it multiplies polynomials as
lists of numbers (gcd, factors); it evaluates numbers; it asks whether something is positive. Of these every *step* is
counted, several of them as a unit: each look at the parts of a node (`Basic.args`), each coefficient that a
polynomial's routine goes over, each node of a number that is evaluated. With them, some 50,000 units take a second.

Memory is counted in the blocks that Python has handed out since the outermost allowance began, which no machine's
speed changes either.

GivenUpError is not an `Exception`, so that no handler on the way catches it by mistake; the stages of `solve` catch it,
and keep what is known by then. A limit of time (`--timeout`) raises the same.

Where the steps of SymPy's own work are counted, as `effort` describes them.

SymPy counts nothing itself, so a handful of its functions are replaced, once, by ones that count and call them. They
were chosen because everything of their kind passes through them, whatever is called from outside:

    walks through expressions    `Basic.args`, a look at the parts of a node
    polynomials as lists         `dup_strip` and `dmp_zero_p` end or begin nearly every routine; products and values,
                                 which take longer than their results are long, by the lengths of what goes into them
    polynomials as dictionaries  products of `PolyElement`, by their terms
    numbers                      `evalf`, which calls itself for every node
    signs                        `_ask`, which calls itself for every assumption that it tries

Nothing of what they return is changed. The random numbers with which polynomials are factored are the same each time,
so that the same problem takes the same number of units.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from functools import wraps
from importlib import import_module
from random import Random
from typing import Any, ParamSpec, TypeVar

import sympy as sp
import sympy.polys.densearith
import sympy.polys.densebasic
import sympy.polys.densetools
import sympy.polys.factortools
import sympy.polys.galoistools
from sympy.core.basic import Basic
from sympy.polys.rings import PolyElement

from lagrange.core.diagnostics import GaveUpError
from lagrange.core.limits import (
    BITS_PER_STEP,
    MOST_BLOCKS,
    STEPS_AT_ONCE,
    STEPS_OF_A_NUMBER,
    STEPS_OF_A_QUESTION,
    STEPS_PER_UNIT,
    STEPS_PER_UNIT_OF_A_SEARCH,
    UNITS_BETWEEN_LOOKS,
)

Argument = TypeVar("Argument")
Result = TypeVar("Result")
P = ParamSpec("P")
T = TypeVar("T")


class GivenUpError(BaseException):
    """The work has exceeded its allowance. The message says which: "after 20 seconds"."""


class Allowance:
    """The units that are left.

    steps       how many of them are a unit
    blocks      of memory, in use when the outermost allowance began
    remembered  what functions keep until the allowance ends: the work to be done then depends on nothing before it
    """

    def __init__(self, units: float, steps: int = STEPS_PER_UNIT, blocks: int = 0) -> None:
        self.units = units
        self.left = units
        self.steps = steps
        self.remembered: dict[object, Any] = {}
        self.blocks = blocks or _blocks()
        self._next_look = max(units - UNITS_BETWEEN_LOOKS, 0)

    def spend(self, units: float) -> None:
        """Takes units away. Raises GivenUpError if there are none left, or too much memory is in use."""
        self.left -= units
        if self.left < self._next_look:
            if self.left < 0:
                raise GivenUpError("the work allowed for one problem is used up")
            self._next_look = max(self.left - UNITS_BETWEEN_LOOKS, 0)
            if self.units < float("inf") and _blocks() - self.blocks > MOST_BLOCKS:
                raise GivenUpError("the memory allowed for one problem is used up")


def _blocks() -> int:
    """Blocks of memory that are in use, where Python tells."""
    count = getattr(sys, "getallocatedblocks", None)
    return int(count()) if count else 0


_current: ContextVar[Allowance | None] = ContextVar("allowance", default=None)
_lifted: ContextVar[bool] = ContextVar("lifted", default=False)
_counting = False


class allowed:  # noqa: N801, used as a function is
    """The allowance for work within the block; a nested one has units of its own."""

    def __init__(self, units: float, *, steps: int = STEPS_PER_UNIT) -> None:
        _count_work()
        outer = _current.get()
        self.allowance = Allowance(float("inf") if _lifted.get() else units, steps, outer.blocks if outer else 0)

    def __enter__(self) -> Allowance:
        self.token = _current.set(self.allowance)
        self.outer_steps, _steps.left = _steps.left, STEPS_AT_ONCE
        return self.allowance

    def __exit__(self, error: type[BaseException] | None, *_: object) -> None:
        if error is MemoryError:
            spare_memory.clear()
        _current.reset(self.token)
        self.allowance.left -= (STEPS_AT_ONCE - _steps.left) / self.allowance.steps
        _steps.left = self.outer_steps


spare_memory: list[bytearray] = []
"""Freed when memory runs out: without any, Python 3.11 cannot even raise a MemoryError again (it ends the process)."""


@contextmanager
def allowed_for_a_search(units: float) -> Iterator[Allowance]:
    """The allowance for one of many searches: what it takes is taken from the current allowance, too.

    Most of its work are steps, signs of conditions above all, of which more are a unit.
    """
    outer = _current.get()
    with allowed(units, steps=STEPS_PER_UNIT_OF_A_SEARCH) as allowance:
        try:
            yield allowance
        finally:
            if outer is not None and allowance.units < float("inf"):
                outer.left -= allowance.units - allowance.left


def within(units: float, work: Callable[[], T]) -> T | None:
    """The result of one of many searches; None if it takes more than so many units. `allowed_for_a_search` counts."""
    with allowed_for_a_search(units) as allowance:
        try:
            return work()
        except GivenUpError:
            if allowance.left >= 0:
                raise  # the time is over, and not this allowance used up
            return None


@contextmanager
def unlimited() -> Iterator[None]:
    """Lifts all allowances within the block, for users who would rather wait."""
    token = _lifted.set(True)
    try:
        yield
    finally:
        _lifted.reset(token)


class Attempts:
    """Consecutive pieces of work: one that takes too long is skipped, and those after it are still done.

    Together they have so many units, and none has more than half of what is left; each has `least`, at least.
    why_not   of the last piece that was left out; empty if there is none
    """

    def __init__(self, units: float, least: float) -> None:
        self.left, self.least, self.why_not = units, least, ""

    def __call__(self, work: Callable[P, T], *values: P.args, **named: P.kwargs) -> T | None:
        """The result of `work`; None if it is skipped."""
        attempt = allowed(max(self.left / 2, self.least))
        try:
            with attempt:
                return work(*values, **named)
        except (GivenUpError, MemoryError) as stop:
            self.why_not = reason(stop)
            return None
        finally:
            if self.left < float("inf"):
                self.left -= attempt.allowance.units - attempt.allowance.left

    def each(self, work: Callable[P, Iterable[T]], *values: P.args, **named: P.kwargs) -> Iterator[T]:
        """The things that `work` makes, until one of them takes too much."""
        things = iter(self(work, *values, **named) or ())
        while (thing := self(lambda: next(things, None))) is not None:
            yield thing


@contextmanager
def allowed_for(stage: str, units: float) -> Iterator[None]:
    """`allowed`, for work whose partial results are discarded. Raises GaveUpError, also if memory runs out."""
    try:
        with allowed(units):
            yield
    except (GivenUpError, MemoryError) as stop:
        raise GaveUpError(f"{stage}, {reason(stop)}") from None


def reason(stop: BaseException) -> str:
    """Why a stage was given up, in words."""
    return "there is not enough memory" if isinstance(stop, MemoryError) else str(stop)


def spend(units: float) -> None:
    """Deducts units from the current allowance, if any. Raises GivenUpError."""
    allowance = _current.get()
    if allowance is not None:
        allowance.spend(units)


def remembered() -> dict[object, Any]:
    """A store that lasts until the current allowance ends; an empty one without an allowance."""
    allowance = _current.get()
    return {} if allowance is None else allowance.remembered


def kept_result(function: Callable[[Argument], Result]) -> Callable[[Argument], Result]:
    """Has a function keep its result for the same object, not an equal one, until the current allowance ends."""

    @wraps(function)
    def kept(argument: Argument) -> Result:
        results = remembered()
        key = function, id(argument)
        if key not in results:
            results[key] = argument, function(argument)  # held, so that no other object gets its id
        result: Result = results[key][1]
        return result

    return kept


def ensure(units: float) -> None:
    """Raises GivenUpError if so many units would be too many, before what takes them is begun."""
    allowance = _current.get()
    if allowance is not None and units > allowance.left:
        allowance.spend(units)


class _Steps:
    """Steps counted one by one and charged to the allowance many at a time."""

    left = STEPS_AT_ONCE


_steps = _Steps()


def take_steps(number: int) -> None:
    """Counts steps."""
    _steps.left -= number
    if _steps.left < 0:
        taken, _steps.left = STEPS_AT_ONCE - _steps.left, STEPS_AT_ONCE
        allowance = _current.get()
        if allowance is not None:
            allowance.spend(taken / allowance.steps)


def _count_work() -> None:
    global _counting
    if not _counting:
        _counting = True
        for operation in (sp.Add, sp.Mul):
            operation.flatten = classmethod(_counted(vars(operation)["flatten"].__func__))
        _count_looks()
        count_steps(take_steps)
        for module in (sympy.polys.factortools, sympy.polys.galoistools):
            vars(module)["_randint"] = _FromOneSeed


def _counted(flatten: Callable[..., Any]) -> Callable[..., Any]:
    def counting(cls: type, operands: Any) -> Any:
        spend(len(operands))
        return flatten(cls, operands)

    return counting


def _count_looks() -> None:
    """Each look at the parts of a node is a step: all ways through an expression have it in common."""
    steps = _steps

    def args(self: Basic) -> tuple[Basic, ...]:
        steps.left -= 1
        if steps.left < 0:
            take_steps(0)
        parts: tuple[Basic, ...] = self._args
        return parts

    Basic.args = property(args, doc=Basic.args.__doc__)


# Counted steps


Count = Callable[[int], None]


class _FromOneSeed:
    """In place of SymPy's source of random numbers in factorization: the same numbers each time.

    Its Hensel lifting takes a hundred times as long from some points of evaluation as from others.
    """

    def __init__(self, seed: int | None = None) -> None:
        self._numbers = Random(0 if seed is None else seed)

    def __call__(self, least: int, most: int) -> int:
        return self._numbers.randint(least, most)


def count_steps(take: Count) -> None:
    """Has SymPy report its steps to `take`."""
    _count_polynomials(take)
    _count_numbers_and_signs(take)


def _count_polynomials(take: Count) -> None:
    basic, arithmetic, tools = sympy.polys.densebasic, sympy.polys.densearith, sympy.polys.densetools
    _everywhere(basic.dup_strip, lambda f, *_: len(f), take)
    _everywhere(basic.dmp_zero_p, lambda *_: 1, take)
    _everywhere(arithmetic.dup_mul, lambda f, g, *_: len(f) * len(g), take)
    _everywhere(arithmetic.dup_sqr, lambda f, *_: len(f) * len(f), take)
    _everywhere(tools.dup_eval, lambda f, a, *_: _of_value(f, a), take)
    _everywhere(tools._rec_eval_tail, lambda *_: 1, take)
    product = PolyElement.__mul__

    def counted_product(self: Any, other: Any) -> Any:
        take(len(self) * (len(other) if isinstance(other, PolyElement) else 1))
        return product(self, other)

    PolyElement.__mul__ = counted_product


def _of_value(f: list[Any], a: Any) -> int:
    """The steps of a polynomial's value: long numbers take more steps, at each power."""
    bits = int(a).bit_length() if isinstance(a, int) else 0
    return len(f) + len(f) ** 2 * bits // BITS_PER_STEP


def _count_numbers_and_signs(take: Count) -> None:
    # `sympy.core` has functions of the same names as these modules.
    numbers, signs = import_module("sympy.core.evalf"), import_module("sympy.core.assumptions")
    evaluate, ask = numbers.evalf, signs._ask

    def counted_evaluation(x: Any, prec: int, options: Any) -> Any:
        take(STEPS_OF_A_NUMBER + prec // BITS_PER_STEP)
        return evaluate(x, prec, options)

    def counted_question(fact: str, obj: Basic) -> Any:
        take(STEPS_OF_A_QUESTION)
        return ask(fact, obj)

    vars(numbers)["evalf"] = counted_evaluation
    vars(signs)["_ask"] = counted_question


def _everywhere(function: Callable[..., Any], steps: Callable[..., int], take: Count) -> None:
    """Replaces a function of SymPy's polynomials wherever one of their modules has it under its name."""

    def counted(*args: Any) -> Any:
        take(steps(*args))
        return function(*args)

    name = function.__name__
    for module in [m for n, m in sys.modules.items() if n.startswith("sympy.polys.")]:
        if vars(module).get(name) is function:
            setattr(module, name, counted)
