"""SymPy's arithmetic under a work budget: operations that would take too long are refused before they begin.

The operations that a text asks for are carried out one by one. Each is charged before it begins, in units of about
0.1 ms, and a text has a budget of them: SymPy takes milliseconds for a new sin(...), for |...| a time that grows with
the argument, and a derivative is estimated before it is taken. Each result is measured: its size and depth, the length
of its numbers, the height of its powers. So reading takes a bounded time whatever the text, and its value is small
enough for the rest of the program. The texts of one file share a second budget.

Constants such as sqrt(2) - pi/3 need care of their own. SymPy decides whether one is zero, and its sign, by evaluating
it with as many digits as it takes: forever for sin(exp(exp(exp(3)))), and with a minimal polynomial of any degree for a
sum of roots that is zero. So each constant in a text is evaluated here first, to eighty digits, and refused if it is
huge, not real, or zero to half of these digits without being written as 0. Those that remain are finite, real, and of
known sign.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import lru_cache
from typing import Any

import mpmath
import sympy as sp

from lagrange.core.expression_size import Sizes
from lagrange.core.symbols import Slots, prime, t
from lagrange.core.vectors import Components, Vector
from lagrange.expressions.limits import (
    CONSTANT_DIGITS,
    HIGHEST_PRESCRIBED_RATE,
    HIGHEST_RATE,
    MAX_ANGLE_DIGITS,
    MAX_BITS,
    MAX_CONSTANT_SIZE,
    MAX_DENOMINATOR,
    MAX_EXPANDED_DIVISOR,
    MAX_EXPONENT,
    MAX_LAYERS,
    MAX_LOGARITHM,
    MAX_NESTED_EXPONENT,
    MAX_SIZE,
    MAX_TERMS,
    MAX_TERMS_OF_PRODUCTS,
    MAX_WORK,
    MAX_WORK_OF_FILE,
    SMALL_POWER,
)

_NUMBERS = mpmath.MPContext()
_NUMBERS.dps = CONSTANT_DIGITS
_NEGLIGIBLE = _NUMBERS.mpf(10) ** (-CONSTANT_DIGITS // 2)
_LARGEST_ANGLE = _NUMBERS.mpf(10) ** MAX_ANGLE_DIGITS

_OF_ANGLES: dict[Any, Any] = {
    sp.sin: _NUMBERS.sin, sp.cos: _NUMBERS.cos, sp.tan: _NUMBERS.tan, sp.cot: _NUMBERS.cot,
    sp.sec: _NUMBERS.sec, sp.csc: _NUMBERS.csc,
}  # fmt: skip
_POLES: dict[Any, Any] = {
    sp.tan: _NUMBERS.cos, sp.sec: _NUMBERS.cos, sp.cot: _NUMBERS.sin, sp.csc: _NUMBERS.sin,
}  # fmt: skip
_EXPONENTIALS: dict[Any, Any] = {sp.exp: _NUMBERS.exp, sp.sinh: _NUMBERS.sinh, sp.cosh: _NUMBERS.cosh}
_OTHERS: dict[Any, Any] = {
    sp.asin: _NUMBERS.asin, sp.acos: _NUMBERS.acos, sp.atan: _NUMBERS.atan, sp.atan2: _NUMBERS.atan2,
    sp.tanh: _NUMBERS.tanh, sp.log: _NUMBERS.log, sp.Abs: abs, sp.sign: _NUMBERS.sign,
}  # fmt: skip
_ANGLES = (sp.asin, sp.acos, sp.atan, sp.atan2)


class TooExpensiveError(Exception):
    """An operation that is refused. `{}` in the message is replaced by its text."""

    def __init__(self, code: str, message: str, help_: str) -> None:
        super().__init__(message)
        self.code = code
        self.message = message
        self.help = help_


class Constants:
    """The values of constants, each computed once."""

    def __init__(self) -> None:
        self._values: dict[sp.Expr, Any] = {sp.pi: +_NUMBERS.pi, sp.E: +_NUMBERS.e}

    def value(self, constant: sp.Expr) -> Any:
        """The value. Raises TooExpensiveError if it is not finite, not real, or hard to tell from 0."""
        value = self._values.get(constant)
        if value is None:
            value = self._values[constant] = self._evaluated(constant)
        return value

    def applied(self, function: Any, arguments: tuple[sp.Expr, ...]) -> sp.Expr:
        """A function of constants, as SymPy writes it. Raises TooExpensiveError as `value`."""
        values = [self.value(a) for a in arguments]
        _check_domain(function, values)
        if function in (sp.Abs, sp.sign):
            sign = sp.Integer(int(_NUMBERS.sign(values[0])))
            return sign if function is sp.sign else sign * arguments[0]
        if function in _ANGLES and any(a.has(sp.Function) for a in arguments):
            help_ = "write the angle itself"
            raise TooExpensiveError("constant-too-involved", "`{}` inverts a function of a constant", help_)
        result = function(*arguments)
        self.value(result)
        return result

    def root(self, base: sp.Expr, exponent: sp.Expr) -> sp.Expr:
        """A power of constants, as SymPy writes it. Raises TooExpensiveError as `value`."""
        _power(self.value(base), self.value(exponent))
        result = base**exponent
        self.value(result)
        return result

    def _evaluated(self, constant: sp.Expr) -> Any:
        if constant.is_Rational:
            return _NUMBERS.mpf(int(constant.p)) / int(constant.q)
        values = [self.value(a) for a in constant.args]
        if constant.is_Add:
            return _definite(_NUMBERS.fsum(values), max(abs(v) for v in values))
        if constant.is_Mul:
            return _of_moderate_size(_NUMBERS.fprod(values))
        if constant.is_Pow:
            return _power(*values)
        return _function(constant.func, values)


def not_finite() -> TooExpensiveError:
    """The error for a value that is not finite."""
    return TooExpensiveError("not-finite", "`{}` has no finite value", "check its argument")


def not_real(help_: str) -> TooExpensiveError:
    """The error for a root or a logarithm of a negative number."""
    return TooExpensiveError("not-real", "`{}` is not a real number", help_)


def _too_large() -> TooExpensiveError:
    return TooExpensiveError("number-too-large", "`{}` is too large a number", "declare a parameter instead")


def _definite(value: Any, scale: Any) -> Any:
    if abs(value) < _NEGLIGIBLE * scale:
        raise TooExpensiveError(
            "indefinite-constant", "`{}` is 0, or too close to it to tell", "write 0, or a simpler form"
        )
    return value


def _of_moderate_size(value: Any) -> Any:
    if abs(_NUMBERS.mag(value)) > 1.5 * MAX_LOGARITHM:
        raise _too_large()
    return value


def _power(base: Any, exponent: Any) -> Any:
    if base < 0 and not _NUMBERS.isint(exponent):
        raise not_real("roots need positive numbers: the cube root of -8 is `-8^(1/3)`")
    if abs(exponent * _NUMBERS.log(abs(base))) > MAX_LOGARITHM:
        raise _too_large()
    return base**exponent


def _function(function: Any, values: list[Any]) -> Any:
    _check_domain(function, values)
    if function in _EXPONENTIALS:
        return _EXPONENTIALS[function](*values)
    return _definite((_OF_ANGLES | _OTHERS)[function](*values), 1)


def _check_domain(function: Any, values: list[Any]) -> None:
    value = values[0]
    if function in _OF_ANGLES and abs(value) > _LARGEST_ANGLE:
        raise _too_large()
    if function in _POLES and abs(_POLES[function](value)) < _NEGLIGIBLE:
        raise not_finite()
    if function in _EXPONENTIALS and abs(value) > MAX_LOGARITHM:
        raise _too_large()
    if function in (sp.asin, sp.acos) and abs(value) > 1:
        raise not_real("sines and cosines are between -1 and 1")
    if function is sp.log and value < 0:
        raise not_real("logarithms need positive numbers")
    if (function is sp.log and value == 0) or (function is sp.atan2 and values == [0, 0]):
        raise not_finite()


SCALAR_FUNCTIONS: dict[str, type[sp.Expr]] = {
    "sin": sp.sin, "cos": sp.cos, "tan": sp.tan, "cot": sp.cot, "sec": sp.sec, "csc": sp.csc, "asin": sp.asin,
    "acos": sp.acos, "atan": sp.atan, "atan2": sp.atan2, "sinh": sp.sinh, "cosh": sp.cosh, "tanh": sp.tanh,
    "exp": sp.exp, "log": sp.log, "abs": sp.Abs, "sign": sp.sign,
}  # fmt: skip
"""The functions of the language in SymPy; `sqrt` is a power."""


class WorkBudget:
    """The work that is left for all texts of one file together."""

    def __init__(self) -> None:
        self.left = float(MAX_WORK_OF_FILE)


class BoundedArithmetic:
    """The operations of one text. All of them raise TooExpensiveError.

    budget   what the text may cost together with the others of its file
    """

    def __init__(self, slots: Slots, budget: WorkBudget | None = None) -> None:
        self._slots = slots
        self._budget = budget
        self._spent = 0.0
        self._sizes = Sizes()
        self._constants = Constants()
        self._results: dict[tuple[Any, ...], sp.Expr] = {}

    # -- operations ------------------------------------------------------------------------------------------

    def sum(self, terms: Sequence[sp.Expr]) -> sp.Expr:
        """a + b + ..."""
        self._spend(0.3 * sum(len(a.args) if a.is_Add else 1 for a in terms))
        return self.checked(sp.Add(*terms))

    def product(self, factors: Sequence[sp.Expr]) -> sp.Expr:
        """a b ..."""
        self._spend(0.4 * sum(max(1, len(a.args)) for a in factors))
        return self.checked(sp.Mul(*factors) if all(a != 0 for a in factors) else sp.S.Zero)

    def inverse(self, divisor: sp.Expr) -> sp.Expr:
        """1/a. A sum is expanded, if that is cheap, to see whether it is 0."""
        if divisor.is_Add and self._sizes.of(divisor).terms < MAX_EXPANDED_DIVISOR:
            self._spend(10 + self._sizes.of(divisor).terms)
            divisor_or_zero = sp.expand(divisor)
        else:
            divisor_or_zero = divisor
        if divisor_or_zero == 0:
            raise TooExpensiveError("division-by-zero", "this divides by zero", "`{}` is exactly 0")
        return self.power(divisor, sp.S.NegativeOne)

    def power(self, base: sp.Expr, exponent: sp.Expr) -> sp.Expr:
        """a^b."""
        self._check_exponent(exponent)
        if base == 0:
            return _power_of_zero(exponent)
        if exponent.is_Integer:
            self._spend(1 + 0.4 * len(base.args))
            return self.checked(base**exponent)
        return self._once(("^", base, exponent), lambda: self._root(base, exponent))

    def apply(self, name: str, arguments: Sequence[sp.Expr]) -> sp.Expr:
        """A scalar function of the language."""
        if name == "sqrt":
            return self.power(arguments[0], sp.S.Half)
        return self._once((name, *arguments), lambda: self._applied(name, tuple(arguments)))

    def partial(self, value: sp.Expr, symbol: sp.Symbol) -> sp.Expr:
        """∂a/∂q."""
        self._spend_on_derivative([value], {symbol})
        return self.checked(_between_jumps(value.diff(symbol)))

    def rate(self, value: sp.Expr) -> sp.Expr:
        """The total time derivative."""
        if value.is_Symbol and value in _rates(self._slots):
            return _rates(self._slots)[value]
        self._before_rate([value])
        return self.checked(_between_jumps(self._slots.time_derivative(value)))

    def partial_of_vector(self, vector: Vector, symbol: sp.Symbol) -> Vector:
        """∂a/∂q."""
        self._spend_on_derivative(vector.components, {symbol})
        return self.checked_vector(vector.partial(symbol).map(_between_jumps))

    def rate_of_vector(self, vector: Vector) -> Vector:
        """The total time derivative."""
        self._before_rate(vector.components)
        return self.checked_vector(vector.time_derivative(self._slots).map(_between_jumps))

    def change_of_vector(self, vector: Vector, rates: Mapping[sp.Symbol, sp.Expr]) -> Vector:
        """Σ (∂a/∂s) rate(s), over the symbols that change."""
        self._spend_on_derivative(vector.components, set(rates))
        changed = vector.change(lambda symbol: rates.get(symbol, sp.S.Zero))
        return self.checked_vector(changed.map(_between_jumps))

    def sum_of_vectors(self, vectors: Sequence[Vector]) -> Vector:
        """a + b + ..., those of one triad added first."""
        by_triad: dict[Any, list[Components]] = {}
        for vector in vectors:
            if not vector.is_zero:
                by_triad.setdefault(vector.triad, []).append(vector.components)
        total = Vector.zero()
        for triad, rows in by_triad.items():
            a, b, c = (self.sum(column) for column in zip(*rows, strict=True))
            total = total + Vector((a, b, c), triad)
        return self.checked_vector(total)

    def scaled(self, vector: Vector, factor: sp.Expr) -> Vector:
        """c a."""
        a, b, c = (self.product([factor, x]) for x in vector.components)
        return Vector((a, b, c), vector.triad)

    def norm(self, vector: Vector) -> sp.Expr:
        """The length."""
        return self.power(self.dot(vector, vector), sp.S.Half)

    def dot(self, a: Vector, b: Vector) -> sp.Expr:
        """The scalar product."""
        self._spend_on_vectors(a, b)
        return self.checked(a.dot(b))

    def cross(self, a: Vector, b: Vector) -> Vector:
        """The vector product."""
        self._spend_on_vectors(a, b)
        return self.checked_vector(a.cross(b))

    # -- checks ----------------------------------------------------------------------------------------------

    def checked(self, value: sp.Expr) -> sp.Expr:
        """Return the value if it is finite, real and of moderate size; raise TooExpensiveError if it is not."""
        size = self._sizes.of(value)
        if not size.is_finite:
            raise not_finite()
        if not size.is_real:
            raise not_real("a negative number has no roots: its exponents must be integers")
        if size.bits > MAX_BITS:
            raise TooExpensiveError("number-too-large", "`{}` is too large a number", "declare a parameter instead")
        if size.power > MAX_NESTED_EXPONENT or size.denominator > MAX_DENOMINATOR:
            raise _exponent_too_large(f"powers may be up to {MAX_NESTED_EXPONENT}, nested ones multiplied")
        if size.layers > MAX_LAYERS:
            message = f"written out, this has more than {MAX_LAYERS} layers"
            raise TooExpensiveError("nested-too-deep", message, "nest fewer functions and powers")
        if size.size > MAX_SIZE:
            message = f"written out, this has more than {MAX_SIZE:,} parts"
            raise TooExpensiveError("expression-too-large", message, "write it shorter")
        most = MAX_TERMS if size.power > SMALL_POWER else MAX_TERMS_OF_PRODUCTS
        if size.widest > most:
            message = f"multiplied out, this has more than {most:,} terms"
            raise TooExpensiveError("expression-too-large", message, "use lower powers or fewer factors")
        if size.is_constant and not value.is_Rational:
            self._check_constant(value)
        return value

    def checked_vector(self, vector: Vector) -> Vector:
        """Return the vector if its components are finite, real and of moderate size."""
        for component in vector.components:
            self.checked(component)
        return vector

    def _check_constant(self, value: sp.Expr) -> None:
        if self._sizes.of(value).size > MAX_CONSTANT_SIZE:
            message = f"a constant may have {MAX_CONSTANT_SIZE} parts"
            raise TooExpensiveError("constant-too-involved", message, "declare a parameter instead")
        self._constants.value(value)

    def _check_exponent(self, exponent: sp.Expr) -> None:
        if exponent.is_Integer and abs(exponent.p) <= MAX_EXPONENT:
            return
        numbers = exponent.atoms(sp.Rational)
        constant = self._sizes.of(exponent).is_constant
        if any(abs(n) > MAX_EXPONENT or n.q > MAX_DENOMINATOR for n in numbers) or (
            constant and abs(self._constants.value(exponent)) > MAX_EXPONENT
        ):
            raise _exponent_too_large(f"a number in an exponent may be at most {MAX_EXPONENT}")

    def _spend(self, units: float) -> None:
        self._spent += units
        if self._spent > MAX_WORK:
            message = "this takes too long to evaluate"
            help_ = "write it shorter, with fewer different functions and derivatives"
            raise TooExpensiveError("expression-too-large", message, help_)
        if self._budget is not None:
            self._budget.left -= units
            if self._budget.left < 0:
                message = "the file up to here takes too long to evaluate"
                help_ = "split it into two problems, or write it shorter"
                raise TooExpensiveError("expression-too-large", message, help_)

    # -- helpers ---------------------------------------------------------------------------------------------

    def _once(self, key: tuple[Any, ...], work: Callable[[], sp.Expr]) -> sp.Expr:
        result = self._results.get(key)
        if result is None:
            result = self._results[key] = self.checked(work())
        return result

    def _root(self, base: sp.Expr, exponent: sp.Expr) -> sp.Expr:
        """A power whose exponent is not an integer."""
        sizes = self._sizes.of(base), self._sizes.of(exponent)
        if all(s.is_constant for s in sizes):
            self._spend(40 + sizes[0].bits / 20 + 3 * sizes[0].size)
            return self._constants.root(base, exponent)
        self._spend(15 + sizes[0].size / 5 + sizes[1].size + sum(s.doubt for s in sizes))
        return base**exponent

    def _applied(self, name: str, arguments: tuple[sp.Expr, ...]) -> sp.Expr:
        function = SCALAR_FUNCTIONS[name]
        sizes = [self._sizes.of(a) for a in arguments]
        size, doubt = sum(s.size for s in sizes), sum(s.doubt for s in sizes)
        if all(s.is_constant for s in sizes):
            self._spend(80 + 3 * size)
            return self._constants.applied(function, arguments)
        argument = arguments[0]
        if name in ("abs", "sign"):
            self._spend(20 + 15 * size + doubt)
            return function(argument) if argument.is_extended_real else _of_doubtful(name, argument)
        self._spend(25 * len(arguments) + size / 3 + doubt + 40 * any(a.has(sp.pi) for a in arguments))
        if name == "exp" and argument.has(sp.log):
            self._spend(3 * size)
            self._check_exponent(argument)
        if name == "log" and argument.is_extended_negative:
            raise not_real("logarithms need positive numbers")
        return function(*arguments)

    def _before_rate(self, values: Sequence[sp.Expr]) -> None:
        """Refuse a third derivative of a coordinate, and a fifth of a prescribed motion."""
        rates = _rates(self._slots)
        highest = set(rates.values()) - set(rates)
        for value in values:
            for symbol in sorted(value.free_symbols & highest, key=str):
                message = f"this requires a time derivative of `{symbol}`"
                help_ = "equations of motion have second derivatives at most"
                raise TooExpensiveError("too-many-primes", message, help_)
        self._spend_on_derivative(values, {*self._slots.coordinates, *self._slots.prescribed, t})

    def _spend_on_derivative(self, values: Sequence[sp.Expr], moving: set[sp.Symbol]) -> None:
        self._spend(self._sizes.derivative_cost(values, moving))

    def _spend_on_vectors(self, a: Vector, b: Vector) -> None:
        self._spend(1 + 0.4 * sum(len(c.args) for c in (*a.components, *b.components)))


def _power_of_zero(exponent: sp.Expr) -> sp.Expr:
    if exponent.is_positive:
        return sp.S.Zero
    if exponent.is_negative:
        raise TooExpensiveError("division-by-zero", "`{}` divides by zero", "0 can only be raised to a positive number")
    raise TooExpensiveError("not-finite", "`{}` has no value", "0 can only be raised to a positive number")


@lru_cache(maxsize=64)
def _rates(slots: Slots) -> Mapping[sp.Symbol, sp.Symbol]:
    """Each slot, and the slot of its time derivative."""
    highest = [*((q, HIGHEST_RATE) for q in slots.coordinates)]
    highest += [(q, HIGHEST_PRESCRIBED_RATE) for q in slots.prescribed]
    return {prime(q, n): prime(q, n + 1) for q, limit in highest for n in range(limit)}


def _exponent_too_large(message: str) -> TooExpensiveError:
    return TooExpensiveError("exponent-too-large", message, "is this the intended power?")


def _of_doubtful(name: str, argument: sp.Expr) -> sp.Expr:
    """|a| and sign a of an argument with roots: real only where they are, so that SymPy would take it for complex."""
    size = sp.Pow(sp.Pow(argument, 2), sp.S.Half, evaluate=False)
    return size if name == "abs" else argument / size


def _between_jumps(derivative: sp.Expr) -> sp.Expr:
    """A derivative of sign(x), which is constant, without the DiracDelta that SymPy puts at its jump."""
    return derivative.xreplace(dict.fromkeys(derivative.atoms(sp.DiracDelta), sp.S.Zero))
