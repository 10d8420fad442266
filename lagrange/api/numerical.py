"""Equations of motion as a function for numerical integration: dy/dt = f(t, y).

In coordinates q, which may be subject to constraints, y = (q, q') and

    M q'' − Aᵀ λ = f ,     A q'' = b .

The constraints are differentiated until accelerations occur: a motion satisfies them if its initial state does, up to
the errors of the integration. With `stabilised` α, for a finite relation g = 0 and for a kinematic constraint φ = 0,

    A q'' = b − 2α dg/dt − α² g ,     A q'' = b − α φ ,

so that errors decay like exp(−α t) (J. Baumgarte, Stabilization of constraints and integrals of motion, 1972). In
quasi-velocities y = (q, u), with q' = B u + b and the equations of motion for u'; kinematic constraints then hold
identically. The linear equations are solved numerically at each call, never symbolically. The code that Python compiles
(`sympy.lambdify`) contains no name from a file: every symbol has been replaced by y0, y1, ... before.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Any, SupportsFloat

import sympy as sp

from lagrange.api.limits import SMALLEST_PIVOT
from lagrange.api.time_functions import Given, with_given
from lagrange.core.diagnostics import nearest
from lagrange.core.symbols import Slots, t
from lagrange.mechanics.constraints.constrained_system import Row
from lagrange.mechanics.dynamics.motion import Motion
from lagrange.problem.model import Assumption, Parameter
from lagrange.programs import first_order
from lagrange.programs.first_order import FirstOrderEquations


def in_coordinates(motion: Motion, stabilised: float = 0) -> FirstOrderEquations:
    """The equations in coordinates and velocities; α pulls back what is lost of the constraints."""
    equations = first_order.in_coordinates(motion)
    if not stabilised:
        return equations
    configuration = motion.matrices.configuration
    used = (r for n, r in enumerate(configuration.rows) if n not in motion.equations.elimination.unused)
    pulls = (_pull(row, configuration.slots, stabilised) for row in used)
    return replace(equations, bias=tuple(b - p for b, p in zip(equations.bias, pulls, strict=True)))


def _pull(row: Row, slots: Slots, stabilised: float) -> sp.Expr:
    """2α dg/dt + α² g, or α φ."""
    rate = row.velocity_form(slots)
    return stabilised * rate if row.finite is None else 2 * stabilised * rate + stabilised**2 * row.finite


MODULES = ("math", "numpy")
Values = Mapping[str | sp.Symbol, SupportsFloat]
FloatVector = Sequence[float]
Solve = Callable[[list[list[float]], list[float]], Any]


class RightHandSide:
    """f(t, y) = dy/dt, for `scipy.integrate.solve_ivp` or any other integrator.

    names       the names of the components of y: ("theta", "theta'"), shape (n + p,)
    values      the values of parameters, by name

    Called with t and y of shape (n + p,) it returns dy/dt of that shape: a list of floats, or with `module="numpy"` an
    array; y may then have the shape (n + p, N), for N states at once, and t the shape (N,).

    Raises ArithmeticError if the accelerations are not determined, or not finite.
    """

    def __init__(
        self,
        equations: FirstOrderEquations,
        parameters: Sequence[Parameter],
        values: Values,
        functions: Mapping[str, Given],
        module: str = "math",
        unknowns: Sequence[sp.Symbol] = (),
    ) -> None:
        if module not in MODULES:
            raise ValueError(f"`module` is one of {', '.join(map(repr, MODULES))}, and not {module!r}")
        self.names: tuple[str, ...] = tuple(s.name for s in equations.state)
        self._equations = equations
        size = len(equations.unknowns)
        flat = [e for row in equations.matrix for e in row]
        expressions = [*equations.rates, *flat, *equations.right, *equations.kept]
        self._code = _Code(equations, functions, parameters, values, module, unknowns)
        run = self._code.compiled(expressions)
        self.values: Mapping[str, float] = self._code.values
        n = len(equations.rates)

        def parts(time: float, y: FloatVector) -> tuple[list[float], list[list[float]], list[float], list[float]]:
            numbers = run(time, y)
            matrix = [numbers[k : k + size] for k in range(n, n + size * size, size)]
            right = numbers[n + size * size : n + size * size + size]
            return numbers[:n], matrix, right, numbers[n + size * size + size :]

        self._parts = parts
        self._in_numpy = module == "numpy"
        self._solved, self._listed = (_in_arrays if module == "numpy" else _in_lists)()

    def __call__(self, time: float, y: FloatVector) -> Any:
        """dy/dt, shape (n + p,), or (n + p, N) for N states at once."""
        if self._in_numpy and _is_table(y):
            return _for_each(self, time, y)
        rates, matrix, right, _ = self._parts(time, y)
        speeds = len(self._equations.speeds)
        return self._listed([float(x) for x in (*rates, *self._unknowns(time, matrix, right)[:speeds])])

    def __repr__(self) -> str:
        listed = ", ".join(f"{name}={value:g}" for name, value in self.values.items())
        return f"<f(t, y) with y = ({', '.join(self.names)}); {listed}>"

    def state(self, values: Mapping[str | sp.Symbol, SupportsFloat]) -> list[float]:
        """y from values by name; missing ones are 0. Raises ValueError if a name is not in y."""
        given = {str(k): float(v) for k, v in values.items()}
        for name in given:
            if name not in self.names:
                raise ValueError(f"`{name}` is no component of y, which has {', '.join(self.names)}")
        return [given.get(name, 0.0) for name in self.names]

    def multipliers(self, time: float, y: FloatVector) -> dict[str, float]:
        """The multipliers of the constraints that these coordinates do not satisfy identically, by name."""
        _, matrix, right, _ = self._parts(time, y)
        speeds = len(self._equations.speeds)
        multipliers = self._unknowns(time, matrix, right)[speeds:]
        return {s.name: float(v) + 0.0 for s, v in zip(self._equations.unknowns[speeds:], multipliers, strict=True)}

    def violation(self, time: float, y: FloatVector) -> list[float]:
        """The errors in the constraints: g of finite relations g = 0, then dg/dt of these and φ of the others, φ = 0.

        It should vanish in the initial state of an integration.
        """
        return [float(x) for x in self._parts(time, y)[3]]

    def function(self, expression: sp.Expr) -> Callable[[float, FloatVector], float]:
        """An expression of coordinates, velocities, accelerations, multipliers, t and parameters, as a function (t, y).

        Symbols are identified by their names: `Symbol("theta'")` is the velocity. With `module="numpy"` y may have the
        shape (n + p, N); the values then have the shape (N,).

        Raises ValueError if there are other symbols in it.
        """
        equations = self._equations
        slots = equations.slots
        meant = {s.name: s for s in (t, *equations.state, *slots.velocities, *equations.unknowns)}
        written = sp.sympify(expression, strict=True)
        written = written.xreplace({s: meant[s.name] for s in written.free_symbols if s.name in meant})
        written = written.xreplace(dict(zip(slots.velocities, equations.rates, strict=True)))
        wanted = written.free_symbols & set(equations.unknowns)
        run = self._code.compiled([written], equations.unknowns)

        def value(time: Any, y: Any) -> Any:
            if self._in_numpy and _is_table(y):
                return _for_each(value, time, y)
            unknowns: Sequence[float] = [0.0] * len(equations.unknowns)
            if wanted:
                _, matrix, right, _ = self._parts(time, y)
                unknowns = self._unknowns(time, matrix, right)
            return float(run(time, y, unknowns)[0])

        return value

    def _unknowns(self, time: float, matrix: list[list[float]], right: list[float]) -> Any:
        try:
            unknowns = self._solved(matrix, right)
        except ZeroDivisionError:
            raise ArithmeticError(f"at t = {float(time):g} the accelerations are not determined") from None
        if not all(map(math.isfinite, unknowns)):
            raise ArithmeticError(f"at t = {float(time):g} the accelerations are not finite")
        return unknowns


def _is_table(y: Any) -> bool:
    return getattr(y, "ndim", 1) > 1


def _for_each(function: Callable[[float, Any], Any], time: Any, y: Any) -> Any:
    """The values of a function for each column of y, as columns."""
    import numpy

    times = numpy.broadcast_to(numpy.asarray(time, dtype=float), y.shape[1:])
    return numpy.stack([function(float(s), column) for s, column in zip(times, y.T, strict=True)], axis=-1)


class _Code:
    """Compiles expressions to functions of t, y and the unknowns, with numbers for parameters.

    Raises ValueError if a number is missing or contradicts the problem.
    """

    def __init__(
        self,
        equations: FirstOrderEquations,
        functions: Mapping[str, Given],
        parameters: Sequence[Parameter],
        values: Values,
        module: str,
        forces: Sequence[sp.Symbol],
    ) -> None:
        self._equations, self._functions, self._module = equations, functions, module
        self._forces = forces
        self._parameters = {p.symbol.name: p for p in parameters}
        given = {str(name): _number(str(name), v) for name, v in values.items()}
        defaults = {p.symbol.name: float(p.value) for p in parameters if p.value is not None}
        self.values = {**defaults, **given}
        self._given = set(given)
        self._known: set[str] = {*self._parameters}
        for name, number in given.items():
            if name in self._parameters:
                _check_assumption(self._parameters[name], number)

    def compiled(
        self, expressions: Sequence[sp.Expr], unknowns: Sequence[sp.Symbol] = ()
    ) -> Callable[..., list[float]]:
        """A function run(t, y) or run(t, y, unknowns) that returns a list of numbers."""
        first = not unknowns
        written, calls = with_given(expressions, self._functions, self._equations.slots, self._forces)
        arguments = [t, *self._equations.state, *unknowns]
        used = set().union(*(e.free_symbols for e in written)) if written else set()
        others = sorted(used - set(arguments), key=lambda s: str(s.name))
        self._check_values(others, first)
        stand_ins = {s: sp.Symbol(f"y{k}", real=True) for k, s in enumerate((*arguments, *others))}
        plain = [e.xreplace(stand_ins) for e in written]
        compiled = sp.lambdify([*stand_ins.values()], plain, [calls, self._module], cse=True)
        constants = [self.values[s.name] for s in others]
        size = len(self._equations.state)

        def run(time: float, y: FloatVector, solved: FloatVector = ()) -> list[float]:
            if len(y) != size:
                raise ValueError(f"y has {size} components, and {len(y)} are given")
            numbers: list[float] = compiled(time, *y, *solved, *constants)
            return numbers

        return run

    def _check_values(self, needed: Sequence[sp.Symbol], all_known: bool) -> None:
        """Checks that every parameter in the equations has a number, and every number a parameter of the problem."""
        names = {s.name for s in needed}
        known = self._known | names
        strange = sorted(self._given - known) if all_known else []
        if strange:
            near = nearest(strange[0], known)
            listed = f"did you mean `{near}`?" if near else f"known are {', '.join(sorted(known))}"
            raise ValueError(f"there is no parameter `{strange[0]}`; {listed}")
        moving = {*self._equations.slots.velocities, *self._equations.slots.accelerations}
        foreign = [s for s in needed if s in moving]
        missing = [s for s in needed if s.name not in self.values and s not in foreign]
        if foreign:
            raise ValueError(f"`{foreign[0]}` is not known in this state, which has {', '.join(self._names)}")
        if missing:
            what = ", ".join(_described(s, self._parameters) for s in missing)
            raise ValueError(f"a number is needed for {what}: right_hand_side({{{missing[0].name!r}: ...}})")
        self._known |= names

    @property
    def _names(self) -> list[str]:
        return [s.name for s in self._equations.state]


def _described(symbol: sp.Symbol, parameters: Mapping[str, Parameter]) -> str:
    parameter = parameters.get(symbol.name)
    return f"`{symbol}` ({parameter.meaning})" if parameter and parameter.meaning else f"`{symbol}`"


def _number(name: str, value: SupportsFloat) -> float:
    try:
        number = float(value)
    except (TypeError, ValueError):
        raise ValueError(f"`{name}` needs a number, and {value!r} is none") from None
    if not math.isfinite(number):
        raise ValueError(f"`{name}` needs a number, and {value!r} is none")
    return number


def _check_assumption(parameter: Parameter, number: float) -> None:
    """Raises ValueError if a number contradicts an assumption of the derivation."""
    allowed = {
        Assumption.POSITIVE: number > 0,
        Assumption.NONNEGATIVE: number >= 0,
        Assumption.SIGN: abs(number) == 1,
        Assumption.REAL: True,
        Assumption.ACUTE: 0 < number < math.pi / 2,
    }
    if not allowed[parameter.assume]:
        is_sign = parameter.assume is Assumption.SIGN
        what = "+1 or -1" if is_sign else parameter.assume.value
        help_ = "" if is_sign else f"; declare it as `{parameter.symbol}: real`"
        raise ValueError(f"`{parameter.symbol}` is {what} in the problem, and {number:g} is not{help_}")


def _solved(matrix: list[list[float]], right: list[float]) -> list[float]:
    """x of matrix · x = right, by elimination with partial pivoting. Raises ZeroDivisionError if there is no such x."""
    rows = []
    for row, b in zip(matrix, right, strict=True):
        size = max(map(abs, row))
        rows.append([x / size for x in (*row, b)])
    count = len(rows)
    for k in range(count):
        best = max(range(k, count), key=lambda r: abs(rows[r][k]))
        if not abs(rows[best][k]) > SMALLEST_PIVOT:
            raise ZeroDivisionError
        rows[k], rows[best] = rows[best], rows[k]
        pivot = rows[k]
        for r in range(k + 1, count):
            share = rows[r][k] / pivot[k]
            if share:
                rows[r] = [a - share * b for a, b in zip(rows[r], pivot, strict=True)]
    x = [0.0] * count
    for k in reversed(range(count)):
        known = math.fsum(rows[k][j] * x[j] for j in range(k + 1, count))
        x[k] = (rows[k][-1] - known) / rows[k][k]
    return x


def _in_lists() -> tuple[Solve, Callable[[list[float]], Any]]:
    return _solved, list


def _in_arrays() -> tuple[Solve, Callable[[list[float]], Any]]:
    """Raises ImportError if NumPy is not installed."""
    import numpy

    def solved(matrix: list[list[float]], right: list[float]) -> Any:
        try:
            return numpy.linalg.solve(numpy.array(matrix, dtype=float), numpy.array(right, dtype=float))
        except numpy.linalg.LinAlgError:
            raise ZeroDivisionError from None

    return solved, numpy.array
