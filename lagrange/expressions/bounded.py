"""SymPy's arithmetic, refused where it would not come to an end soon.

The operations that a text asks for are carried out one by one. Each is charged before it is begun, in units
of about 0.1 ms, and a text has so many of them to spend: SymPy takes milliseconds for a new sin(...), for
|...| a time that grows with what stands inside, and a derivative is estimated before it is taken. Each result
is measured: its size and depth, the length of its numbers, the height of its powers. So whatever a text says,
reading it takes a bounded time, and what has been read is small enough for the rest of the program. The texts
of one file share a purse besides.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import lru_cache
from typing import Any

import sympy as sp

from lagrange.core.expression_size import Measures
from lagrange.core.symbols import Slots, prime, t
from lagrange.core.vectors import Components, Vector
from lagrange.expressions.constants import Constants, RefusedError, not_finite, not_real

MAX_WORK = 6_000
MAX_WORK_OF_FILE = 60_000
MAX_SIZE = 12_000
MAX_LAYERS = 70
MAX_TERMS = 20_000
MAX_BITS = 4_400
MAX_EXPONENT = 20
MAX_DENOMINATOR = 1_000
MAX_NESTED_EXPONENT = 40
MAX_CONSTANT = 150
HIGHEST_RATE = 2
HIGHEST_PRESCRIBED_RATE = 4

SCALAR_FUNCTIONS: dict[str, type[sp.Expr]] = {
    "sin": sp.sin, "cos": sp.cos, "tan": sp.tan, "cot": sp.cot, "sec": sp.sec, "csc": sp.csc, "asin": sp.asin,
    "acos": sp.acos, "atan": sp.atan, "atan2": sp.atan2, "sinh": sp.sinh, "cosh": sp.cosh, "tanh": sp.tanh,
    "exp": sp.exp, "log": sp.log, "abs": sp.Abs, "sign": sp.sign,
}  # fmt: skip
"""Those of the language, as SymPy has them; `sqrt` is a power."""


class Purse:
    """The work that all texts of one file may cost together."""

    def __init__(self) -> None:
        self.left = float(MAX_WORK_OF_FILE)


class Arithmetic:
    """The operations of one text. All of them raise RefusedError.

    purse   what the text may cost together with others, where it is one of many
    """

    def __init__(self, slots: Slots, purse: Purse | None = None) -> None:
        self._slots = slots
        self._purse = purse
        self._spent = 0.0
        self._measures = Measures()
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
        """1/a."""
        if divisor.is_Add and self._measures.of(divisor).terms < 200:
            self._spend(10 + self._measures.of(divisor).terms)
            divisor_or_zero = sp.expand(divisor)
        else:
            divisor_or_zero = divisor
        if divisor_or_zero == 0:
            raise RefusedError("division-by-zero", "this divides by zero", "`{}` is exactly 0")
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
        """The value, if it is finite, real and of moderate size."""
        measure = self._measures.of(value)
        if not measure.is_finite:
            raise not_finite()
        if not measure.is_real:
            raise not_real("a negative number has no roots, and whole numbers as exponents only")
        if measure.bits > MAX_BITS:
            raise RefusedError("number-too-large", "`{}` is too large a number", "declare a parameter in its place")
        if measure.power > MAX_NESTED_EXPONENT or measure.denominator > MAX_DENOMINATOR:
            raise _exponent_too_large(f"powers may be up to {MAX_NESTED_EXPONENT}, nested ones multiplied")
        if measure.layers > MAX_LAYERS:
            message = f"written out, this has more than {MAX_LAYERS} layers"
            raise RefusedError("nested-too-deep", message, "nest fewer functions and powers")
        if measure.size > MAX_SIZE:
            message = f"written out, this has more than {MAX_SIZE:,} parts"
            raise RefusedError("expression-too-large", message, "write it shorter")
        if measure.widest > MAX_TERMS:
            message = f"multiplied out, this has more than {MAX_TERMS:,} terms"
            raise RefusedError("expression-too-large", message, "use lower powers or fewer factors")
        if measure.is_constant and not value.is_Rational:
            self._check_constant(value)
        return value

    def checked_vector(self, vector: Vector) -> Vector:
        """The vector, if its components are finite, real and of moderate size."""
        for component in vector.components:
            self.checked(component)
        return vector

    def _check_constant(self, value: sp.Expr) -> None:
        if self._measures.of(value).size > MAX_CONSTANT:
            message = f"a constant may have {MAX_CONSTANT} parts"
            raise RefusedError("constant-too-involved", message, "declare a parameter in its place")
        self._constants.value(value)

    def _check_exponent(self, exponent: sp.Expr) -> None:
        if exponent.is_Integer and abs(exponent.p) <= MAX_EXPONENT:
            return
        numbers = exponent.atoms(sp.Rational)
        constant = self._measures.of(exponent).is_constant
        if any(abs(n) > MAX_EXPONENT or n.q > MAX_DENOMINATOR for n in numbers) or (
            constant and abs(self._constants.value(exponent)) > MAX_EXPONENT
        ):
            raise _exponent_too_large(f"numbers in an exponent may be up to {MAX_EXPONENT}")

    def _spend(self, units: float) -> None:
        self._spent += units
        if self._spent > MAX_WORK:
            message = "this takes too long to work out"
            help_ = "write it shorter, with fewer different functions and derivatives"
            raise RefusedError("expression-too-large", message, help_)
        if self._purse is not None:
            self._purse.left -= units
            if self._purse.left < 0:
                message = "all of the file up to here takes too long to work out"
                raise RefusedError("expression-too-large", message, "make two problems of it, or write it shorter")

    # -- helpers ---------------------------------------------------------------------------------------------

    def _once(self, key: tuple[Any, ...], work: Callable[[], sp.Expr]) -> sp.Expr:
        found = self._results.get(key)
        if found is None:
            found = self._results[key] = self.checked(work())
        return found

    def _root(self, base: sp.Expr, exponent: sp.Expr) -> sp.Expr:
        """A power that is no whole one."""
        measures = self._measures.of(base), self._measures.of(exponent)
        if all(m.is_constant for m in measures):
            self._spend(40 + measures[0].bits / 20 + 3 * measures[0].size)
            return self._constants.root(base, exponent)
        self._spend(15 + measures[0].size / 5 + measures[1].size + sum(m.doubt for m in measures))
        return base**exponent

    def _applied(self, name: str, arguments: tuple[sp.Expr, ...]) -> sp.Expr:
        function = SCALAR_FUNCTIONS[name]
        measures = [self._measures.of(a) for a in arguments]
        size, doubt = sum(m.size for m in measures), sum(m.doubt for m in measures)
        if all(m.is_constant for m in measures):
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
            raise not_real("logarithms are taken of positive numbers")
        return function(*arguments)

    def _before_rate(self, values: Sequence[sp.Expr]) -> None:
        """A third derivative of a coordinate is refused, and a fifth of a prescribed motion."""
        rates = _rates(self._slots)
        highest = set(rates.values()) - set(rates)
        for value in values:
            for symbol in sorted(value.free_symbols & highest, key=str):
                message = f"a time derivative of `{symbol}` arises here"
                help_ = "equations of motion have second derivatives at most"
                raise RefusedError("too-many-primes", message, help_)
        self._spend_on_derivative(values, {*self._slots.coordinates, *self._slots.prescribed, t})

    def _spend_on_derivative(self, values: Sequence[sp.Expr], moving: set[sp.Symbol]) -> None:
        self._spend(self._measures.derivative_cost(values, moving))

    def _spend_on_vectors(self, a: Vector, b: Vector) -> None:
        self._spend(1 + 0.4 * sum(len(c.args) for c in (*a.components, *b.components)))


def _power_of_zero(exponent: sp.Expr) -> sp.Expr:
    if exponent.is_positive:
        return sp.S.Zero
    if exponent.is_negative:
        raise RefusedError("division-by-zero", "`{}` divides by zero", "0 has positive numbers as exponents only")
    raise RefusedError("not-finite", "`{}` has no value", "0 has positive numbers as exponents only")


@lru_cache(maxsize=64)
def _rates(slots: Slots) -> Mapping[sp.Symbol, sp.Symbol]:
    """Each slot, and the slot of its time derivative."""
    highest = [*((q, HIGHEST_RATE) for q in slots.coordinates)]
    highest += [(q, HIGHEST_PRESCRIBED_RATE) for q in slots.prescribed]
    return {prime(q, n): prime(q, n + 1) for q, limit in highest for n in range(limit)}


def _exponent_too_large(message: str) -> RefusedError:
    return RefusedError("exponent-too-large", message, "is this the power that is meant?")


def _of_doubtful(name: str, argument: sp.Expr) -> sp.Expr:
    """|a| and sign a of something that is real only where its roots are: SymPy would take it for complex."""
    size = sp.Pow(sp.Pow(argument, 2), sp.S.Half, evaluate=False)
    return size if name == "abs" else argument / size


def _between_jumps(derivative: sp.Expr) -> sp.Expr:
    """sign(x) is constant between its jumps."""
    return derivative.xreplace(dict.fromkeys(derivative.atoms(sp.DiracDelta), sp.S.Zero))
