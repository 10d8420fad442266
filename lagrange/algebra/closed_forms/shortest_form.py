"""The shortest of a few forms of a value: with its radicands in textbook form, as a quotient, with tangents.

sin α/cos α = tan α,    cos α/sin α = 1/tan α.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations

import sympy as sp

from lagrange.algebra.closed_forms.limits import INNER_FRACTION, LONGEST_REWRITTEN
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.expression_size import count_operations
from lagrange.core.symbols import sign_in_range


def shortest_form(e: sp.Expr) -> sp.Expr:
    """The expression in the shortest of its forms."""
    e = without_moduli(e) if e.has(sp.Abs) else e
    if e.is_Atom or count_operations(e) > LONGEST_REWRITTEN:
        return e
    forms = [e]
    roots = [p for p in e.atoms(sp.Pow) if p.exp.is_Rational and not p.exp.is_Integer]
    forms += [_with_radicands(e, roots)] if roots else []
    if not roots and e.has(sp.sin, sp.cos):
        above, below = sp.fraction(sp.together(e))
        forms.append(textbook_form(above) / textbook_form(below))
        factors = (f.as_base_exp() for f in sp.Mul.make_args(e))
        forms.append(sp.Mul(*(textbook_form(base) ** exponent for base, exponent in factors)))
    if not roots and (e.is_Add or e.has(sp.sin, sp.cos)):
        forms.append(textbook_form(e))
    candidates = [_as_tangents(f) for f in forms]
    return min(candidates, key=lambda f: (reading_length(f), forms.index(f) if f in forms else 0))


def without_moduli(e: sp.Expr) -> sp.Expr:
    """sin α for |sin α| of an acute angle."""
    signs = {f: sign_in_range(f.args[0]) for f in e.atoms(sp.Abs)}
    return e.xreplace({f: sign * f.args[0] for f, sign in signs.items() if sign is not None})


def reading_length(e: sp.Expr) -> int:
    """Operations, with a surcharge for each fraction within a fraction: (a² + g²)/(g l), not (a²/g + g)/l."""
    quotients = (product for product in e.atoms(sp.Mul) if sp.fraction(product)[1] != 1)
    sums = (f.as_base_exp()[0] for product in quotients for f in product.args)
    inner = {a for s in sums if s.is_Add for a in s.args if not sp.fraction(a)[1].is_number}
    return count_operations(e) + INNER_FRACTION * len(inner)


def by_stated_root(e: sp.Expr, power: sp.Expr, value: sp.Expr) -> sp.Expr:
    """∛2 ∛a l^(2/3)/2 as ½ l cos θ where cos³ θ = 2a/l is stated and this is shorter; `power` is cos³ θ, `value` 2a/l.

    An odd power of a positive value has one real root; of cos² θ the sign would be open.
    """
    base, exponent = power.as_base_exp()
    has_root = any(not p.exp.is_Integer for p in (e if exponent != 1 else value).atoms(sp.Pow))
    if not (has_root and value.is_positive and exponent.is_Integer and exponent % 2 == 1) or e.has(base):
        return e
    if e.is_number or count_operations(e) > LONGEST_REWRITTEN:
        return e  # sin α = −2/√5 beside cos α = 1/√5
    root = sp.expand_power_base(value ** (1 / exponent))
    terms = [_by_root(term, base, root, int(exponent)) for term in sp.Add.make_args(sp.expand(e))]
    if any(term is None for term in terms):
        return e
    whole = sp.Add(*(term for term in terms if term is not None))
    return min((e, shortest_form(whole), shortest_form(sp.factor_terms(whole))), key=reading_length)


def _by_root(term: sp.Expr, base: sp.Expr, root: sp.Expr, most: int) -> sp.Expr | None:
    """A product with a power of `base` for that of its root with which no other roots are left; None without one."""
    forms = []
    for n in sorted(range(-most, most + 1), key=lambda n: (abs(n), n < 0)):
        rest = sp.expand_power_base(term * sp.expand_power_base(root**-n))
        if all(p.exp.is_Integer for p in rest.atoms(sp.Pow)):
            forms.append(rest * base**n)
    # ½ l cos θ rather than a/cos² θ, which has as many operations
    return min(forms, key=lambda form: count_operations(form) + sp.fraction(form)[1].has(base), default=None)


def in_sines(e: sp.Expr) -> sp.Expr:
    """The expression with tan and cot as the quotients that they are."""
    return e.replace(sp.tan, lambda x: sp.sin(x) / sp.cos(x)).replace(sp.cot, lambda x: sp.cos(x) / sp.sin(x))


def _with_radicands(e: sp.Expr, roots: Sequence[sp.Expr]) -> sp.Expr:
    """Sines and cosines under roots in textbook form, where that is shorter."""
    shorter = {}
    for p in roots:
        if (p.base.is_Add or p.base.is_Mul) and p.base.has(sp.sin, sp.cos):
            form = textbook_form(p.base)
            if count_operations(form) < count_operations(p.base) and not p.base.atoms(sp.Pow) & {*roots}:
                shorter[p] = form**p.exp
    return e.xreplace(shorter)


def _as_tangents(e: sp.Expr) -> sp.Expr:
    """Products of sines and cosines of one angle as tangents: cos α/sin α is 1/tan α."""
    if e.is_Add:
        return sp.Add(*(_as_tangents(a) for a in e.args))
    powers: dict[sp.Expr, list[sp.Integer]] = {}
    rest = []
    for factor in sp.Mul.make_args(e):
        base, exponent = factor.as_base_exp()
        if isinstance(base, sp.sin | sp.cos) and exponent.is_Integer:
            entry = powers.setdefault(base.args[0], [sp.S.Zero, sp.S.Zero])
            entry[isinstance(base, sp.cos)] += exponent
        else:
            rest.append(factor)
    for angle, (sines, cosines) in powers.items():
        if sines * cosines < 0:
            both = sp.Min(abs(sines), abs(cosines)) * sp.sign(sines)
            rest.append(sp.tan(angle) ** both)
            sines, cosines = sines - both, cosines + both
        rest.append(sp.sin(angle) ** sines * sp.cos(angle) ** cosines)
    return sp.Mul(*rest)


# -- Signs as a book writes them: 2 μ/(1 − μ ν), and not −2 μ/(μ ν − 1) ------------------------------------------------


def without_leading_minus(e: sp.Expr) -> sp.Expr:
    """A product with a minus sign before it and a sum in it, without the sign: (R − h)/R for −(h − R)/R."""
    if e.is_Add:
        return sp.Add(*(without_leading_minus(a) for a in e.args))
    if not e.is_Mul:
        return e
    factors = [_turned(f) for f in e.args]
    if not e.could_extract_minus_sign():
        return sp.Mul(*factors)
    for n, f in enumerate(factors):
        base, exponent = f.as_base_exp()
        if base.is_Add and exponent.is_Integer and exponent % 2 and _negative(base) >= _negative(-base):
            rest = [*factors[:n], *factors[n + 1 :]]
            return sp.Mul(sp.S.NegativeOne, *rest) * sp.Pow(sp.Add(*(-a for a in base.args)), exponent)
    return sp.Mul(*factors)


def _negative(e: sp.Expr) -> int:
    return sum(a.could_extract_minus_sign() for a in sp.Add.make_args(sp.expand_mul(e)))


def _turned(f: sp.Expr) -> sp.Expr:
    base, exponent = f.as_base_exp()
    if base.is_Mul and exponent.is_Rational:
        return sp.Pow(without_leading_minus(base), exponent)
    return f


def with_whole_contents(e: sp.Expr) -> sp.Expr:
    """A product with the common numbers of its sums before it: 4 a (1 − M/m) for 2 a (2 − 2 M/m)."""
    number, factors = sp.S.One, []
    for f in sp.Mul.make_args(e):
        base, exponent = f.as_base_exp()
        if base.is_Add and exponent.is_Integer:
            content, rest = base.primitive()
            if content.is_Integer:  # not that of decimals, 0.3 x + 9.81
                number, f = number * content**exponent, rest**exponent
        factors.append(f)
    return e if number == 1 or len(factors) < 2 else sp.Mul(number, *factors)


def with_differences_of_squares(e: sp.Expr) -> sp.Expr:
    """A product with r² − a² for its factors (r − a) (r + a), as books print it; roots of such products too."""
    roots = [p for p in e.atoms(sp.Pow) if p.exp.is_Rational and not p.exp.is_Integer and p.base.is_Mul]
    products = [m for m in e.atoms(sp.Mul) if m != e and any(f.is_Pow and not f.exp.is_Integer for f in m.args)]
    shorter = {p: base for p in roots if (base := with_differences_of_squares(p.base)) != p.base}
    e = e.xreplace({p: sp.Pow(base, p.exp) for p, base in shorter.items()})  # the others stay as they are written
    e = e.xreplace({m: form for m in products if (form := with_differences_of_squares(m)) != m})
    if not e.is_Mul:
        return e
    factors = list(e.args)
    for one, other in combinations(e.args, 2):
        (a, n), (b, m) = one.as_base_exp(), other.as_base_exp()
        if n != m or not (a.is_Add and b.is_Add and len(a.args) == len(b.args) == 2) or other not in factors:
            continue
        total, difference = (a + b) / 2, (a - b) / 2
        is_plain = not total.is_number or (difference**2).as_base_exp()[0].is_Symbol  # 1 − μ², but not 1 − cos² θ
        if one in factors and not total.is_Add and not difference.is_Add and is_plain:
            factors.remove(one)
            factors[factors.index(other)] = (total**2 - difference**2) ** n
    return e if len(factors) == len(e.args) else sp.Mul(*factors, evaluate=False)
