"""Times ∫ dq/√f(q) by a substitution S(q), where (dS/dt)² = S'(q)² f is a quadratic in S or such a quotient of them.

    S = sin(c q)     S'² = c² (1 − S²)         f rational in S and cos²(c q): the well U_0 tan²(a x)
    S = sinh(c q)    S'² = c² (1 + S²)         −U_0/cosh²(a x)
    S = exp(c q)     S'² = c² S²               Morse's potential A (e^{−2ax} − 2 e^{−ax})

S increases with c q where that lies between −π/2 and π/2, for sin, and everywhere for the others. The integral over S
is that of `quadrature`. (Landau and Lifshitz, Mechanics, § 11.)
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

import sympy as sp

from lagrange.algebra.closed_forms.signs import sign_of
from lagrange.core.operations import count_operations
from lagrange.core.records import record
from lagrange.mechanics.questions.limits import LONGEST_INTEGRATED


@record
class Substitution:
    """S, its values at both ends, and (dS/dt)² as a function of S."""

    letter: sp.Symbol
    square: sp.Expr
    ends: tuple[sp.Expr, sp.Expr]
    way: int


def substitutions(q: sp.Symbol, square: sp.Expr, start: sp.Expr, end: sp.Expr, way: int) -> Iterator[Substitution]:
    """The substitutions by which q'² = f(q) becomes a rational function of the new variable."""
    if count_operations(square) > LONGEST_INTEGRATED:
        return
    for function, inside, in_letter, slope in _KINDS:
        rates = {f.args[0].coeff(q, 1) for f in square.atoms(*inside) if q in f.free_symbols}
        if not rates:
            continue
        least = min(rates, key=lambda r: (count_operations(r), abs(r.as_coeff_Mul()[0]), str(r)))
        rate = least if sign_of(least) == 1 else -least
        letter = sp.Dummy("S", positive=function is sp.exp, real=True)
        rational = in_letter(square, rate * q, letter)
        if rational is None or q in rational.free_symbols or sign_of(rate) != 1:
            continue
        if function is sp.sin and any(sign_of(sp.cos(rate * x)) not in (0, 1) for x in (start, end)):
            continue
        changed = sp.factor(sp.together(rate**2 * slope(letter) * rational))
        yield Substitution(letter, changed, (function(rate * start), function(rate * end)), way)


def _in_sine(e: sp.Expr, angle: sp.Expr, letter: sp.Symbol) -> sp.Expr | None:
    cosine = sp.Dummy()
    plain = sp.expand_trig(e).replace(sp.tan, lambda x: sp.sin(x) / sp.cos(x))
    plain = plain.replace(sp.cot, lambda x: sp.cos(x) / sp.sin(x)).xreplace({sp.sin(angle): letter})
    return _without_square(plain.xreplace({sp.cos(angle): cosine}), cosine, 1 - letter**2)


def _in_hyperbolic_sine(e: sp.Expr, angle: sp.Expr, letter: sp.Symbol) -> sp.Expr | None:
    cosine = sp.Dummy()
    plain = e.replace(sp.tanh, lambda x: sp.sinh(x) / sp.cosh(x)).xreplace({sp.sinh(angle): letter})
    return _without_square(plain.xreplace({sp.cosh(angle): cosine}), cosine, 1 + letter**2)


def _in_exponential(e: sp.Expr, exponent: sp.Expr, letter: sp.Symbol) -> sp.Expr | None:
    def power(f: sp.Expr) -> sp.Expr:
        ratio = sp.cancel(f.args[0] / exponent)
        return letter**ratio if ratio.is_Integer else f

    return e.replace(lambda f: isinstance(f, sp.exp), power)


def _without_square(e: sp.Expr, cosine: sp.Symbol, square: sp.Expr) -> sp.Expr | None:
    """A rational function in which the cosine has even powers only, without it; None where it has not."""
    parts = []
    for part in sp.fraction(sp.together(e)):
        if not part.is_polynomial(cosine):
            return None
        terms = sp.Poly(part, cosine).terms()
        if any(n % 2 for (n,), _ in terms):
            return None
        parts.append(sp.Add(*(c * square ** (n // 2) for (n,), c in terms)))
    return parts[0] / parts[1]


_Kind = tuple[
    Callable[[sp.Expr], sp.Expr],
    tuple[type[sp.Function], ...],
    Callable[[sp.Expr, sp.Expr, sp.Symbol], sp.Expr | None],
    Callable[[sp.Symbol], sp.Expr],
]
_KINDS: tuple[_Kind, ...] = (
    (sp.sin, (sp.sin, sp.cos, sp.tan, sp.cot), _in_sine, lambda s: 1 - s**2),
    (sp.sinh, (sp.sinh, sp.cosh, sp.tanh), _in_hyperbolic_sine, lambda s: 1 + s**2),
    (sp.exp, (sp.exp,), _in_exponential, lambda s: s**2),
)
