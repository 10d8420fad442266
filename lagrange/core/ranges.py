"""Signs of functions of parameters that have a range: the sine and the cosine of an acute angle are positive.

A sine, cosine or tangent of Σ c_i α_i + b keeps its sign between two neighbouring zeros, and Σ c_i α_i + b itself is
considered over the whole range. At an end of the range where the function vanishes it has no sign.
"""

from __future__ import annotations

import sympy as sp

from lagrange.core.records import record
from lagrange.core.symbols import Bounded

FIRST_ZERO = {sp.sin: sp.S.Zero, sp.cos: -sp.pi / 2}
"""Where a function of period 2π begins to be positive for half of it."""


@record
class Ends:
    """The values between which an expression lies; `strict`: whether it is never the lower, and never the higher."""

    low: sp.Expr
    high: sp.Expr
    strict: tuple[bool, bool]


def sign_in_range(f: sp.Expr) -> int | None:
    """+1 or −1 where a function has this sign in the whole range of its parameters; None elsewhere."""
    symbols = f.free_symbols
    if not symbols or not all(isinstance(s, Bounded) for s in symbols):
        return None
    if isinstance(f, sp.sin | sp.cos):
        ends = range_of(f.args[0])
        return None if ends is None else sign_between(f.func, ends.low, ends.high, ends.strict)
    if isinstance(f, sp.tan | sp.cot):
        signs = [sign_in_range(g(f.args[0])) for g in (sp.sin, sp.cos)]
        return None if signs[0] is None or signs[1] is None else signs[0] * signs[1]
    if isinstance(f, sp.sec | sp.csc):
        return sign_in_range((sp.cos if isinstance(f, sp.sec) else sp.sin)(f.args[0]))
    ends = range_of(f)
    if ends is None:
        return None
    if ends.low > 0 or (ends.low == 0 and ends.strict[0]):
        return 1
    return -1 if ends.high < 0 or (ends.high == 0 and ends.strict[1]) else None


def without_known_magnitudes(e: sp.Expr) -> sp.Expr:
    """|cos α| as cos α for an acute angle α."""
    signs = {a: sign_in_range(a.args[0]) for a in e.atoms(sp.Abs)}
    return e.xreplace({a: sign * a.args[0] for a, sign in signs.items() if sign is not None})


def range_of(e: sp.Expr) -> Ends | None:
    """The range of a linear expression in parameters that have one; None for any other."""
    low = high = sp.S.Zero
    below = above = False
    for term in sp.Add.make_args(e):
        if term.is_number:
            low, high = low + term, high + term
            continue
        constant, symbol = term.as_independent(*term.free_symbols, as_Add=False)
        if not isinstance(symbol, Bounded):
            return None
        ends, strict = (symbol.low, symbol.high), symbol.strict
        if constant.is_negative:
            ends, strict = ends[::-1], strict[::-1]
        low, high = low + constant * ends[0], high + constant * ends[1]
        below, above = below or strict[0], above or strict[1]
    return Ends(low, high, (below, above))


def sign_between(f: type[sp.Function], low: sp.Expr, high: sp.Expr, strict: tuple[bool, bool]) -> int | None:
    """The sign of sine or cosine between two angles; `strict`: whether the angle is never the lower, the higher one."""
    first = FIRST_ZERO[f]
    half = sp.floor((low - first) / sp.pi)
    begin, end = first + half * sp.pi, first + (half + 1) * sp.pi
    if high > end or (low == begin and not strict[0]) or (high == end and not strict[1]):
        return None
    return 1 if half % 2 == 0 else -1


def never_vanishes(f: sp.Expr) -> bool:
    """Whether a factor is known to be different from zero: m, or the sine of an acute angle."""
    return bool(f.is_nonzero) or sign_in_range(f) is not None
