"""The size and the sign of constants such as sqrt(2) - pi/3, before SymPy asks for them.

SymPy decides about a constant by evaluating it with as many digits as it takes: forever for
sin(exp(exp(exp(3)))), and with a minimal polynomial of any degree for a sum of roots that is zero. So each
constant in a text is evaluated here first, to eighty digits, and refused if it is huge, not real, or zero to
half of these digits without being written 0. What is left is finite, real, and of known sign.
"""

from __future__ import annotations

from typing import Any

import mpmath
import sympy as sp

_NUMBERS = mpmath.MPContext()
_NUMBERS.dps = 80
_NOTHING = _NUMBERS.mpf(10) ** -40
_LARGEST_LOGARITHM = 3_000
_LARGEST_ANGLE = _NUMBERS.mpf(10) ** 31

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


class RefusedError(Exception):
    """Something that is not worked out. `{}` in the message stands for its text."""

    def __init__(self, code: str, message: str, help_: str) -> None:
        super().__init__(message)
        self.code = code
        self.message = message
        self.help = help_


class Constants:
    """The values of constants, each found once."""

    def __init__(self) -> None:
        self._values: dict[sp.Expr, Any] = {sp.pi: +_NUMBERS.pi, sp.E: +_NUMBERS.e}

    def value(self, constant: sp.Expr) -> Any:
        """The number itself. Raises RefusedError where it is not finite, not real, or hard to tell from 0."""
        value = self._values.get(constant)
        if value is None:
            value = self._values[constant] = self._evaluated(constant)
        return value

    def applied(self, function: Any, arguments: tuple[sp.Expr, ...]) -> sp.Expr:
        """A function of constants, as SymPy writes it. Raises RefusedError as `value`."""
        values = [self.value(a) for a in arguments]
        _check_domain(function, values)
        if function in (sp.Abs, sp.sign):
            sign = sp.Integer(int(_NUMBERS.sign(values[0])))
            return sign if function is sp.sign else sign * arguments[0]
        if function in _ANGLES and any(a.has(sp.Function) for a in arguments):
            help_ = "write the angle itself"
            raise RefusedError("constant-too-involved", "`{}` takes an angle back out of a function", help_)
        result = function(*arguments)
        self.value(result)
        return result

    def root(self, base: sp.Expr, exponent: sp.Expr) -> sp.Expr:
        """A power of constants, as SymPy writes it. Raises RefusedError as `value`."""
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


def not_finite() -> RefusedError:
    """There is no such number."""
    return RefusedError("not-finite", "`{}` has no finite value", "check its argument")


def not_real(help_: str) -> RefusedError:
    """A root or a logarithm of something negative."""
    return RefusedError("not-real", "`{}` is not a real number", help_)


def _too_large() -> RefusedError:
    return RefusedError("number-too-large", "`{}` is too large a number", "declare a parameter in its place")


def _definite(value: Any, scale: Any) -> Any:
    if abs(value) < _NOTHING * scale:
        raise RefusedError("indefinite-constant", "`{}` is 0, or too close to it to tell", "write 0, or a simpler form")
    return value


def _of_moderate_size(value: Any) -> Any:
    if abs(_NUMBERS.mag(value)) > 1.5 * _LARGEST_LOGARITHM:
        raise _too_large()
    return value


def _power(base: Any, exponent: Any) -> Any:
    if base < 0 and not _NUMBERS.isint(exponent):
        raise not_real("roots are taken of positive numbers: a cube root of -8 is `-8^(1/3)`")
    if abs(exponent * _NUMBERS.log(abs(base))) > _LARGEST_LOGARITHM:
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
    if function in _POLES and abs(_POLES[function](value)) < _NOTHING:
        raise not_finite()
    if function in _EXPONENTIALS and abs(value) > _LARGEST_LOGARITHM:
        raise _too_large()
    if function in (sp.asin, sp.acos) and abs(value) > 1:
        raise not_real("sines and cosines are between -1 and 1")
    if function is sp.log and value < 0:
        raise not_real("logarithms are taken of positive numbers")
    if (function is sp.log and value == 0) or (function is sp.atan2 and values == [0, 0]):
        raise not_finite()
