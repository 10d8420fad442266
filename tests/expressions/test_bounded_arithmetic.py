"""Arithmetic that would take too long is refused."""

from __future__ import annotations

from dataclasses import replace

import pytest
import sympy as sp

from lagrange.core.diagnostics import Fragment, ProblemError
from lagrange.expressions.reader import (
    read_scalar,
)
from tests.support.expression_texts import (
    refused,
    scope,
    x,
    y,
)


def symbol(name: str) -> sp.Symbol:
    return sp.Symbol(name, positive=True)


LIMITS: dict[str, tuple[str, str]] = {
    "length": ("theta+" * 20_000 + "theta", "expression-too-long"),
    "nesting of brackets": ("(" * 61 + "x" + ")" * 61, "nested-too-deep"),
    "nesting of powers": ("x**" * 200 + "x", "nested-too-deep"),
    "nesting of functions": ("sin " * 200 + "x", "nested-too-deep"),
    "nesting of lists": ("[" * 200 + "x" + "]" * 200, "nested-too-deep"),
    "nesting of bars": ("|(" * 100 + "x" + ")|" * 100, "nested-too-deep"),
    "nesting of roots": ("√" * 200 + "x", "nested-too-deep"),
    "digits": ("1" * 31, "number-too-long"),
    "digits and decimals": ("1." + "1" * 30, "number-too-long"),
    "power of ten": ("1e41", "number-too-long"),
    "power of ten with zeros": ("1e000041", "number-too-long"),
    "negative power of ten": ("1e-400", "number-too-long"),
    "long power of ten": ("1e" + "9" * 400, "number-too-long"),
    "superscript digits": ("x" + "¹" * 31, "number-too-long"),
    "exponent": ("x^21", "exponent-too-large"),
    "negative exponent": ("x^-21", "exponent-too-large"),
    "exponent of a number": ("2^100", "exponent-too-large"),
    "exponent of a function": ("sin^21(x)", "exponent-too-large"),
    "exponent with a symbol": ("2^(20000*x)", "exponent-too-large"),
    "computed exponent": ("theta''^(10^10)", "exponent-too-large"),
    "large exponent": ("theta'' + x^(10^18)", "exponent-too-large"),
    "tower": ("9**9**9", "exponent-too-large"),
    "decimal tower": ("10.0**10.0**10.0", "exponent-too-large"),
    "nested": ("(x^7)^6", "exponent-too-large"),
    "nested in sums": ("((x^5 + 1)^3 + 1)^3", "exponent-too-large"),
    "fine denominators": ("x^(1/100003)", "exponent-too-large"),
    "huge value": ("sin(sin(exp(exp(exp(3)))+3))", "number-too-large"),
    "many terms": ("(x + y + m + g + l + theta)^20 * (x + y + m + g + l + phi)^20", "expression-too-large"),
}


@pytest.mark.parametrize("what", LIMITS)
def test_limit(what: str) -> None:
    text, code = LIMITS[what]
    found = refused(text)
    assert [d.code for d in found] == [code]
    assert found[0].help
    assert found[0].span is not None


@pytest.mark.parametrize(
    "text",
    ["(" * 59 + "x" + ")" * 59, "1" * 30, "x^20", "x^-20", "(x^20)^2", "(x^8)^5", "x^(1/2)", "x + " * 2_499 + "x"],
    ids=lambda text: text[:12],
)
def test_just_within_the_limits(text: str) -> None:
    assert read_scalar(Fragment.of(text), scope()) is not None


def test_messages_of_limits_name_the_limit() -> None:
    assert "20" in refused("x^21")[0].message
    assert "20" in refused("2^100")[0].message
    assert "40" in refused("(x^20)^3")[0].message
    assert "60" in refused("(" * 61 + "x" + ")" * 61)[0].message
    assert "30" in refused("1" * 31)[0].message
    assert "10,000" in refused("x+" * 6_000 + "x")[0].message
    assert "2,000" in refused("x+" * 1_500 + "x", limit=2_000)[0].message


def test_abbreviations_do_not_get_around_the_limits() -> None:
    """Each name is an expression ten times as large as the one before."""
    value: sp.Expr = x + y
    known = scope()
    for step in range(60):
        known = replace(known, scalars={**known.scalars, "z": value})
        try:
            value = read_scalar(Fragment.of(f"sin(z) + z*cos(z + {step}) + z"), known)
        except ProblemError as error:
            codes = {d.code for d in error.diagnostics}
            break
    else:
        pytest.fail("no limit")
    assert codes <= {"expression-too-large", "nested-too-deep"}
