"""One allowance of work for everything that a solve or a check does, counted in operations and not in seconds.

    with allowed(UNITS):
        ...             # raises GivenUpError after so many units

What is counted is the same on every machine: a unit is one operand of a sum or a product that SymPy puts together, ten
nodes of an expression evaluated at a random point, or two terms of a Fourier sum. Whatever expands, differentiates,
solves or substitutes ends up in these; 10,000 to 20,000 units take a second. SymPy has no such count, so its
`Add.flatten` and `Mul.flatten`, through which every sum and product passes, report here from the first allowance on;
outside of one their reports are ignored.

GivenUpError is not an `Exception`, so that no handler on the way catches it by mistake; the stages of `solve` catch it,
and keep what is known by then. A limit of time (`--timeout`) raises the same.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from typing import Any

import sympy as sp

from lagrange.core.diagnostics import GaveUpError


class GivenUpError(BaseException):
    """The work has exceeded its allowance. The message says which: "after 20 seconds"."""


class Allowance:
    """The units that are left.

    remembered  what functions keep until the allowance ends: the work to be done then depends on nothing before it
    """

    def __init__(self, units: float) -> None:
        self.units = units
        self.left = units
        self.remembered: dict[object, Any] = {}

    def spend(self, units: float) -> None:
        """Takes units away. Raises GivenUpError where there are none left."""
        self.left -= units
        if self.left < 0:
            raise GivenUpError("the work allowed for one problem is used up")


_current: ContextVar[Allowance | None] = ContextVar("allowance", default=None)
_lifted: ContextVar[bool] = ContextVar("lifted", default=False)
_counting = False


class allowed:  # noqa: N801, used as a function is
    """The allowance for what is done within the block; one that is within another has units of its own."""

    def __init__(self, units: float) -> None:
        _count_arithmetic()
        self.allowance = Allowance(float("inf") if _lifted.get() else units)

    def __enter__(self) -> Allowance:
        self.token = _current.set(self.allowance)
        return self.allowance

    def __exit__(self, error: type[BaseException] | None, *_: object) -> None:
        if error is MemoryError:
            spare_memory.clear()
        _current.reset(self.token)


spare_memory: list[bytearray] = []
"""Freed when memory runs out: without any, Python 3.11 cannot even raise a MemoryError again (it ends the process)."""


@contextmanager
def unlimited() -> Iterator[None]:
    """Lifts all allowances within the block, for users who would rather wait."""
    token = _lifted.set(True)
    try:
        yield
    finally:
        _lifted.reset(token)


@contextmanager
def allowed_for(stage: str, units: float) -> Iterator[None]:
    """`allowed`, for work of which no part is kept. Raises GaveUpError, also where memory runs out."""
    try:
        with allowed(units):
            yield
    except (GivenUpError, MemoryError) as stop:
        raise GaveUpError(stage, reason(stop)) from None


def reason(stop: BaseException) -> str:
    """Why a stage was given up, in words."""
    return "there is not enough memory" if isinstance(stop, MemoryError) else str(stop)


def spend(units: float) -> None:
    """Takes units from the current allowance, if there is one. Raises GivenUpError."""
    allowance = _current.get()
    if allowance is not None:
        allowance.spend(units)


def remembered() -> dict[object, Any]:
    """What is kept until the current allowance ends; forgotten at once where there is none."""
    allowance = _current.get()
    return {} if allowance is None else allowance.remembered


def _count_arithmetic() -> None:
    global _counting
    if not _counting:
        _counting = True
        for operation in (sp.Add, sp.Mul):
            operation.flatten = classmethod(_counted(vars(operation)["flatten"].__func__))


def _counted(flatten: Callable[..., Any]) -> Callable[..., Any]:
    def counting(cls: type, operands: Any) -> Any:
        spend(len(operands))
        return flatten(cls, operands)

    return counting
