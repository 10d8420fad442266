"""Integration of y' = f(t, y) by the method of Dormand and Prince of order 8, with dense output.

    y_{n+1} = y_n + h Σ b_i k_i ,     k_i = f(t_n + c_i h, y_n + h Σ_j a_ij k_j) ,

with twelve stages, an error estimate that combines embedded methods of orders 5 and 3, and interpolation of order 7.
A step function with the sums written out for the components of y is made from the table of coefficients that SciPy has
of the method; that is several times as fast as arrays are for the few components of a mechanical system.
Reference: Hairer, Nørsett and Wanner, Solving Ordinary Differential Equations I, section II.5 and II.6.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from functools import lru_cache
from typing import Any

from lagrange.core.records import record
from lagrange.programs.compiled import Compiled, compiled_text
from lagrange.programs.limits import MOST_STEPS, PACE, SLOWEST_PACE, SMALLEST_STEP

RateFunction = Callable[..., Sequence[float]]
"""f(t, y_0, y_1, ...)."""
State = tuple[float, ...]

_SAFETY, _LEAST_FACTOR, _LARGEST_FACTOR, _ORDER = 0.9, 0.2, 10.0, 8


class IntegrationStoppedError(Exception):
    """The integration cannot go on, at a time, for a reason that can be shown."""

    def __init__(self, time: float, reason: str) -> None:
        super().__init__(reason)
        self.time, self.reason = time, reason


@record
class IntegrationStep:
    """One step, from t to t + h; `slopes` are k_1, ..., k_13."""

    time: float
    length: float
    before: State
    after: State
    slopes: tuple[State, ...]
    rate: RateFunction

    @property
    def end(self) -> float:
        """t + h."""
        return self.time + self.length

    def interpolation(self) -> tuple[State, ...]:
        """The coefficients of the interpolating polynomial, shape (7, n). Evaluates f three times."""
        made: tuple[State, ...] = _functions(len(self.before))[1](
            self.rate, self.time, self.length, self.before, self.after, self.slopes
        )
        return made


def interpolated(before: Any, coefficients: Sequence[Any], x: Any) -> Any:
    """The state at t + x h, 0 ≤ x ≤ 1, of numbers or of arrays."""
    y = 0.0
    for n, c in enumerate(reversed(coefficients)):
        y = (y + c) * (x if n % 2 == 0 else 1 - x)
    return before + y


def at(step: IntegrationStep, coefficients: Sequence[State], time: float) -> State:
    """The state at a time of the step."""
    x = (time - step.time) / step.length
    return tuple(interpolated(y, [c[k] for c in coefficients], x) for k, y in enumerate(step.before))


def steps(
    rate: RateFunction,
    start: float,
    state: State,
    end: float,
    relative: float,
    absolute: float,
    longest: float = math.inf,
) -> Iterator[IntegrationStep]:
    """The steps from the start to the end; a state that is sent back replaces the one at the end of the step.

    Raises StoppedError if steps become too short or too many.
    """
    make_step = _functions(len(state))[0]
    time, slope = start, _first(rate, start, state)
    length = min(_first_length(rate, time, state, slope, relative, absolute), longest, end - start)
    taken, looked = 0, start
    while time < end:
        if taken > MOST_STEPS:
            raise IntegrationStoppedError(time, f"more than {MOST_STEPS:,} steps are needed")
        taken += 1
        if taken % PACE == 0:
            if time - looked < SLOWEST_PACE * (end - start):
                raise IntegrationStoppedError(time, f"more than {MOST_STEPS:,} steps would be needed")
            looked = time
        last = time + length >= end * (1 - 1e-14)
        length = end - time if last else length
        if length < SMALLEST_STEP * max(abs(time), 1e-3):
            raise IntegrationStoppedError(
                time, "it comes to a singular place: a collision, or a pole of the coordinates"
            )
        try:
            after, slopes, error = make_step(rate, time, length, state, slope, relative, absolute)
        except (ArithmeticError, ValueError):
            error = math.inf
        if not error < 1:  # also where it is not a number
            factor = _SAFETY * error ** (-1 / _ORDER) if math.isfinite(error) else 0.0
            length *= max(_LEAST_FACTOR, factor)
            continue
        step = IntegrationStep(time, length, state, after, slopes, rate)
        corrected = yield step
        time = end if last else time + length
        state, slope = after, slopes[-1]
        if corrected is not None:
            state = corrected
            slope = _first(rate, time, state)
        factor = _LARGEST_FACTOR if error == 0 else min(_LARGEST_FACTOR, _SAFETY * error ** (-1 / _ORDER))
        length = min(length * factor, longest)


def _first(rate: RateFunction, time: float, state: State) -> State:
    try:
        slope = tuple(rate(time, *state))
    except (ArithmeticError, ValueError):
        slope = (math.nan,)
    if not all(map(math.isfinite, slope)):
        raise IntegrationStoppedError(time, "the accelerations are not determined")
    return slope


def _first_length(
    rate: RateFunction, time: float, state: State, slope: State, relative: float, absolute: float
) -> float:
    """The length of the first step (Hairer, Nørsett and Wanner, section II.4)."""
    scale = [absolute + relative * abs(y) for y in state]
    size = _norm(state, scale)
    speed = _norm(slope, scale)
    h = 1e-6 if size < 1e-5 or speed < 1e-5 else 0.01 * size / speed
    try:
        later = rate(time + h, *(y + h * k for y, k in zip(state, slope, strict=True)))
        change = _norm([a - b for a, b in zip(later, slope, strict=True)], scale) / h
    except (ArithmeticError, ValueError):
        return h
    if max(speed, change) <= 1e-15:
        return max(1e-6, h * 1e-3)
    return min(100 * h, float((0.01 / max(speed, change)) ** (1 / _ORDER)))


def _norm(values: Sequence[float], scale: Sequence[float]) -> float:
    return math.sqrt(sum((v / s) ** 2 for v, s in zip(values, scale, strict=True)) / max(1, len(scale)))


@lru_cache(maxsize=64)
def _functions(size: int) -> tuple[Compiled, Compiled]:
    """The step and the interpolation for so many components."""
    from scipy.integrate import DOP853

    a = [[float(x) for x in row] for row in DOP853.A]
    b = [float(x) for x in DOP853.B]
    return (
        compiled_text("\n".join(_step_text(size, a, [float(c) for c in DOP853.C], b, DOP853.E3, DOP853.E5)), "step"),
        compiled_text("\n".join(_dense_text(size, DOP853.A_EXTRA, DOP853.C_EXTRA, DOP853.D)), "dense"),
    )


def _sum(coefficients: Sequence[float], component: int) -> str:
    return " + ".join(f"{float(c)!r}*k{j}_{component}" for j, c in enumerate(coefficients) if c != 0) or "0.0"


def _names(letter: str, size: int) -> str:
    return "".join(f"{letter}{k}, " for k in range(size))


def _step_text(
    size: int, a: Sequence[Sequence[float]], c: Sequence[float], b: Sequence[float], e3: Any, e5: Any
) -> Iterator[str]:
    """step(f, t, h, y, k, relative, absolute) -> y at t + h, the slopes, the error."""
    stages = len(b)
    yield "def step(f, t, h, y, k, relative, absolute):"
    yield f"    {_names('y', size)}= y"
    yield f"    {_names('k0_', size)}= k"
    for i in range(1, stages):
        arguments = ", ".join(f"y{n} + h*({_sum(a[i][:i], n)})" for n in range(size))
        yield f"    {_names(f'k{i}_', size)}= f(t + {c[i]!r}*h, {arguments})"
    for n in range(size):
        yield f"    z{n} = y{n} + h*({_sum(b, n)})"
    yield f"    {_names(f'k{stages}_', size)}= f(t + h, {_names('z', size)})"
    yield "    five = three = 0.0"
    for n in range(size):
        yield f"    s = absolute + relative*(abs(y{n}) if abs(y{n}) > abs(z{n}) else abs(z{n}))"
        yield f"    e = ({_sum(e5, n)})/s"
        yield "    five += e*e"
        yield f"    e = ({_sum(e3, n)})/s"
        yield "    three += e*e"
    slopes = ", ".join(f"({_names(f'k{i}_', size)})" for i in range(stages + 1))
    yield f"    error = h*five/sqrt((five + 0.01*three)*{size}) if five else 0.0"
    yield f"    return ({_names('z', size)}), ({slopes}), error"


def _dense_text(size: int, a: Any, c: Any, d: Any) -> Iterator[str]:
    """dense(f, t, h, y, z, k) -> the coefficients of the polynomial between y and z."""
    yield "def dense(f, t, h, y, z, k):"
    yield f"    {_names('y', size)}= y"
    yield f"    {_names('z', size)}= z"
    unpacked = ", ".join(f"({_names(f'k{i}_', size)})" for i in range(13))
    yield f"    {unpacked} = k"
    for i, row in enumerate(a, start=13):
        arguments = ", ".join(f"y{n} + h*({_sum(row[:i], n)})" for n in range(size))
        yield f"    {_names(f'k{i}_', size)}= f(t + {float(c[i - 13])!r}*h, {arguments})"
    for n in range(size):
        yield f"    d{n} = z{n} - y{n}"
    rows = [
        "".join(f"d{n}, " for n in range(size)),
        "".join(f"h*k0_{n} - d{n}, " for n in range(size)),
        "".join(f"2*d{n} - h*(k12_{n} + k0_{n}), " for n in range(size)),
        *("".join(f"h*({_sum(row, n)}), " for n in range(size)) for row in d),
    ]
    yield f"    return ({', '.join(f'({row})' for row in rows)})"
