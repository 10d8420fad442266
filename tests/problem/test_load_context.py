"""How expressions of a file are read."""

from __future__ import annotations

import sympy as sp

from lagrange.core.diagnostics import Fragment
from lagrange.core.symbols import prime
from lagrange.problem.load_context import expanded_size, place_of_symbol

x = sp.Symbol("x", real=True)


def test_the_place_of_a_symbol_with_its_primes() -> None:
    fragment = Fragment.of("a + x'' - b")
    span = place_of_symbol(prime(prime(x)), fragment)
    assert fragment.text[span.start : span.end] == "x''"
    elsewhere = place_of_symbol(sp.Symbol("w", real=True), fragment)
    assert (elsewhere.start, elsewhere.end) == (0, len(fragment.text))


def test_the_size_counts_what_is_written_out() -> None:
    assert expanded_size(x) < expanded_size(x + 1) < expanded_size((x + 1) ** 2 * (x + 1))
