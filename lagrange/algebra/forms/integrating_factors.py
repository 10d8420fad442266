"""Integrating factors, and the finite relation that follows: not exact is not the same as not integrable.

A form ω = Σ a_i dq_i with ω ∧ dω = 0 has, locally, a factor μ that makes it the differential of a function,

    d(μω) = 0,      μω = dF,      ω = 0  <=>  F = const  where μ is finite and not 0.

Such factors are sought in a bounded class, in this order: products of powers of the functions in the coefficients;
those beside a function of one variable; 1/ω(X) for an affine symmetry X; functions of x + y, x y, ...; powers with
exponents that contain parameters (`factor_methods`). A factor found is proved on the form: d(μω) = 0, dF ∧ ω = 0, both
exactly. Where none is found one may still exist.

If dF = μω, any function of F will do as well, with another factor: d(Φ(F)) = Φ'(F) μω. F = const is therefore written
as a person would: fractional and negative powers are cleared (3 x^{1/3} y^{2/3} z: x y² z³ = const), sums of logarithms
become products, an inverse function alone is removed, and constants are dropped.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import replace
from functools import reduce
from itertools import combinations
from math import gcd, lcm

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError, NoPointError, UnsupportedError, is_zero
from lagrange.algebra.forms.exact_forms import Exactness, exactness, potential, without_constant_factor
from lagrange.algebra.forms.factor_candidates import (
    FactorCandidate,
    OneForm,
    common_divisor,
    factor_candidates,
    factored,
)
from lagrange.algebra.forms.factor_methods import (
    FactorExponents,
    exponents_beside,
    factor_beside,
    factors_of_combinations,
    in_shortest_forms,
    is_never_positive,
    parametric_exponents,
    rational_exponents,
    shortened,
    symmetry_fields,
    unbarred,
)
from lagrange.algebra.forms.limits import (
    LARGEST_FACTOR,
    LARGEST_FORM,
    LARGEST_RELATION_POWER,
    MOST_BESIDE,
    MOST_FORM_VARIABLES,
    MOST_PROPOSED_FACTORS,
    MOST_RELATION_FACTORS,
    MOST_WITH_PARAMETERS,
    MOST_WITHOUT_POTENTIAL,
    RELATION_STEPS,
)
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import Slots, Unspecified, base

_MONOTONIC = (sp.log, sp.exp, sp.atan, sp.asin, sp.sinh, sp.tanh, sp.tan, sp.asinh)


def tidy_relation(
    f: sp.Expr, variables: Sequence[sp.Symbol], slots: Slots, angles: Collection[sp.Symbol] = ()
) -> tuple[sp.Expr, sp.Expr]:
    """(F, Φ'): the relation F = Φ(f) in a simple form, and Φ' up to a constant factor.

    angles  variables that no exponential is made of: log x + ψ = const stays
    """
    moving = {*variables, *slots.prescribed}
    factor = sp.S.One
    for _ in range(RELATION_STEPS):
        f = without_constant_factor(_without_constants(_shorter(f), moving), variables, slots)
        step = _freed(f) or _of_logarithms(f, moving, angles) or _of_powers(f, moving)
        if step is None:
            break
        f, rate = step
        factor *= rate
    return f, factor


def depends_on(e: sp.Expr, moving: Collection[sp.Symbol]) -> bool:
    """Whether an expression contains something of `moving`, a rate of it, or an undefined function."""
    return any(base(s) in moving for s in e.free_symbols) or bool(e.has(Unspecified))


def _without_constants(f: sp.Expr, moving: set[sp.Symbol]) -> sp.Expr:
    return sp.Add(*(term for term in sp.Add.make_args(f) if depends_on(term, moving)))


def _shorter(f: sp.Expr) -> sp.Expr:
    """The function as one fraction in factors, if that is shorter."""
    if not f.is_Add:
        return f
    product = factored(f)
    return product if product.is_Mul and count_operations(product) <= count_operations(f) else f


def _freed(f: sp.Expr) -> tuple[sp.Expr, sp.Expr] | None:
    """h(g) = const, for a monotonic h alone: g = const."""
    if isinstance(f, _MONOTONIC):
        g = unbarred(f.args[0])
        return g, 1 / f.func(g).fdiff()
    return None


def _of_logarithms(f: sp.Expr, moving: set[sp.Symbol], angles: Collection[sp.Symbol]) -> tuple[sp.Expr, sp.Expr] | None:
    """Σ c_k log g_k + Σ b_i q_i = const: Π g_k^{c_k} · exp Σ b_i q_i = const."""
    product: dict[sp.Expr, sp.Expr] = {}
    growth = sp.S.Zero
    for term in sp.Add.make_args(f):
        if _is_linear(term, moving) and not term.free_symbols & {*angles}:
            growth += term
            continue
        logs = [a for a in sp.Mul.make_args(term) if isinstance(a, sp.log)]
        if len(logs) != 1 or depends_on(term / logs[0], moving):
            return None
        g = unbarred(logs[0].args[0])
        product[g] = product.get(g, sp.S.Zero) + term / logs[0]
    if not product or len(product) > MOST_RELATION_FACTORS:
        return None
    scale = _clearing(list(product.values()))
    if scale is None:
        return None
    relation = sp.Mul(*(g ** sp.cancel(c * scale) for g, c in product.items())) * sp.exp(sp.expand(scale * growth))
    return relation, relation


def _is_linear(term: sp.Expr, moving: set[sp.Symbol]) -> bool:
    """Whether a term is a constant times a coordinate."""
    constant, rest = term.as_independent(*moving, as_Add=False)
    return bool(rest in moving and not depends_on(constant, moving))


def _of_powers(f: sp.Expr, moving: set[sp.Symbol]) -> tuple[sp.Expr, sp.Expr] | None:
    """Π g_k^{e_k} = const with exponents that are not whole, have a common divisor, or are mostly negative."""
    powers: dict[sp.Expr, sp.Expr] = {}
    growth = sp.S.Zero
    for factor in sp.Mul.make_args(f):
        if not depends_on(factor, moving):
            continue
        if isinstance(factor, sp.exp):
            growth += factor.args[0]
        else:
            g, e = factor.as_base_exp()
            g = unbarred(g)
            powers[g] = powers.get(g, sp.S.Zero) + e
    if not powers or any(depends_on(e, moving) for e in powers.values()) or len(powers) > MOST_RELATION_FACTORS:
        return None
    scale = _clearing(list(powers.values()))
    if scale is None:
        return None
    scale = -scale if _is_upside_down(powers, growth) else scale
    if scale == 1:
        return None
    relation = sp.Mul(*(g ** sp.cancel(e * scale) for g, e in powers.items())) * sp.exp(scale * growth)
    return relation, relation / f


def _is_upside_down(powers: dict[sp.Expr, sp.Expr], growth: sp.Expr) -> bool:
    """Whether all factors are in the denominator, or more than in the numerator."""
    below = [g for g, e in powers.items() if _is_negative(e)]
    above = [g for g in powers if g not in below]
    if not above:
        return True
    lengths = [sum(count_operations(g) + 1 for g in part) for part in (below, above)]
    return bool(growth == 0) and lengths[0] > lengths[1]


def _is_negative(e: sp.Expr) -> bool:
    return bool(e.could_extract_minus_sign())


def _clearing(exponents: Sequence[sp.Expr]) -> sp.Expr | None:
    """The number that makes all exponents whole and coprime, or polynomials in the parameters."""
    fractions = [sp.fraction(sp.together(e)) for e in exponents]
    if all(n.is_Integer and d.is_Integer for n, d in fractions):
        denominator = lcm(*(int(d) for _, d in fractions))
        common = reduce(gcd, (int(n) * denominator // int(d) for n, d in fractions), 0)
        largest = max((abs(int(n) * denominator // int(d)) // (common or 1) for n, d in fractions), default=0)
        return sp.Rational(denominator, common) if common and largest <= LARGEST_RELATION_POWER else None
    denominators = [d for _, d in fractions]
    return reduce(sp.lcm, denominators, sp.S.One)


@record
class IntegratingFactor:
    """μ for a form ω.

    factor     μ
    variables  (k,)
    form       the coefficients of μω, shape (k,)
    exactness  its pairs of partial derivatives, all equal
    integral   F with dF = μω times a constant; None if it was not found in closed form
    nonzero    expressions that must not vanish for μ to be finite and not 0
    positive   expressions that must be positive for μ to be real
    """

    factor: sp.Expr
    variables: tuple[sp.Symbol, ...]
    form: tuple[sp.Expr, ...]
    exactness: Exactness
    integral: sp.Expr | None
    nonzero: tuple[sp.Expr, ...]
    positive: tuple[sp.Expr, ...]


def integrating_factor(
    form: Sequence[sp.Expr],
    variables: Sequence[sp.Symbol],
    slots: Slots,
    angles: Collection[sp.Symbol] = (),
) -> IntegratingFactor | None:
    """A factor that makes a form exact, proved; None: none was found.

    form       (k,) coefficients of the differentials of `variables` (k,), t among them if there is a dt
    angles     variables that stay outside exponentials in the relation
    """
    omega = OneForm.of(form, variables, slots)
    if not omega.size or omega.size > MOST_FORM_VARIABLES or sum(count_operations(a) for a in form) > LARGEST_FORM:
        return None
    # A factor without a finite relation proves integrability but tells a reader less: the next one may have both.
    without_potential: IntegratingFactor | None = None
    failures = 0
    for proposed in _distinct(_proposed(omega)):
        factor = _proved(proposed, form, variables, slots, angles)
        if factor is None:
            continue
        if factor.integral is not None:
            return factor
        without_potential = without_potential or factor
        failures += 1
        if failures >= MOST_WITHOUT_POTENTIAL:
            break
    return without_potential


def _proposed(omega: OneForm) -> Iterator[sp.Expr]:
    """Factors that are likely to do, the simplest kinds first."""
    if omega.size == 1:
        yield 1 / omega.coefficients[0]
        return
    # A common factor hides what is simple: (x² + y²)(y dx − x dy) is treated as y dx − x dy.
    common = common_divisor(omega)
    if common != 1:
        omega = OneForm(in_shortest_forms(omega.times(1 / common)), omega.variables, omega.slots)
        yield 1 / common
    # Cheapest and most readable first. Powers settle most textbook forms, in 10 to 70 ms, and give algebraic relations;
    # a function of one variable takes an antiderivative; 1/ω(X) is longer as a rule; exponents with parameters have
    # the most unknowns.
    ways = (_products, _beside_one_variable, _of_symmetries, factors_of_combinations, _with_parameters)
    for way in ways:
        try:
            yield from (factor / common for factor in way(omega))
        except (UnsupportedError, DivisionByZeroError, NoPointError):
            continue


def _distinct(proposed: Iterator[sp.Expr]) -> Iterator[sp.Expr]:
    seen: set[sp.Expr] = set()
    for e in proposed:
        if len(seen) >= MOST_PROPOSED_FACTORS:
            return
        if e not in seen and count_operations(e) <= LARGEST_FACTOR:
            seen.add(e)
            yield e


def _products(omega: OneForm) -> Iterator[sp.Expr]:
    trials = factor_candidates(omega)
    yield from (_product(e, trials) for e in rational_exponents(omega, trials))


def _beside_one_variable(omega: OneForm) -> Iterator[sp.Expr]:
    """Π g^e · exp ∫ h dv."""
    trials = factor_candidates(omega)
    for k, v in enumerate(omega.variables):
        beside = [c for c in trials if not _depends_only_on(c.function, v, omega)]
        for n, exponents in enumerate(exponents_beside(omega, beside, k)):
            factor = factor_beside(omega, _product(exponents, beside), k)
            if factor is not None:
                yield factor
            if n + 1 >= MOST_BESIDE:
                break


def _depends_only_on(e: sp.Expr, v: sp.Symbol, omega: OneForm) -> bool:
    return not e.has(Unspecified) and not e.free_symbols & omega.moving - {v}


def _of_symmetries(omega: OneForm) -> Iterator[sp.Expr]:
    """1/ω(X)."""
    for field in symmetry_fields(omega):
        across = sp.Add(*(a * x for a, x in zip(omega.coefficients, field, strict=True)))
        # Fields along the surfaces are symmetries too, but ω(X) = 0.
        if is_zero(across) is False:
            yield 1 / factored(across)


def _with_parameters(omega: OneForm) -> Iterator[sp.Expr]:
    """Powers with exponents that contain parameters, of the simplest candidates."""
    if omega.parameters:
        trials = factor_candidates(omega)
        trials = sorted(trials, key=lambda c: count_operations(c.function))[:MOST_WITH_PARAMETERS]
        yield from (_product(e, trials) for e in parametric_exponents(omega, trials))


def _product(exponents: FactorExponents, trials: Sequence[FactorCandidate]) -> sp.Expr:
    return sp.Mul(*(trials[k].power(e) for k, e in exponents.items()))


def _proved(
    proposed: sp.Expr,
    form: Sequence[sp.Expr],
    variables: Sequence[sp.Symbol],
    slots: Slots,
    angles: Collection[sp.Symbol],
) -> IntegratingFactor | None:
    """The proposed factor, or one that leads to a simpler relation, if it is proved to be one."""
    first = _closed(proposed, form, variables, slots)
    if first is None:
        return None
    f = potential(first.form, variables, slots)
    if f is None:
        return first
    relation, rate = tidy_relation(f, variables, slots, angles)
    if not is_proportional(relation, form, variables, slots):
        relation, rate = f, sp.S.One
        if not is_proportional(relation, form, variables, slots):
            return first
    # The tidier relation F = Φ(f) belongs to another factor, Φ'(f) μ, which is proved anew.
    better = first if rate == 1 else _closed(shortened(proposed * rate), form, variables, slots)
    if better is None or not _has_differential(relation, better.form, variables, slots):
        better, relation = first, f
    return replace(better, integral=relation)


def _closed(
    factor: sp.Expr, form: Sequence[sp.Expr], variables: Sequence[sp.Symbol], slots: Slots
) -> IntegratingFactor | None:
    """The factor with the multiplied form, if that is exact."""
    if factor == 0:
        return None
    moving = {*variables, *slots.prescribed}
    # Numbers and parameters change nothing in a factor.
    factor = sp.Mul(*(g for g in sp.Mul.make_args(factor) if depends_on(g, moving)))
    if factor.has(sp.exp) or any(not p.exp.is_Rational for p in factor.atoms(sp.Pow)):
        factor = sp.powsimp(factor)
    multiplied = in_shortest_forms([factor * a for a in form])
    try:
        pairs = exactness(multiplied, variables, slots)
        same = all(is_zero(m - factor * a) for m, a in zip(multiplied, form, strict=True))
    except DivisionByZeroError:
        return None
    if pairs.exact is not True or not same:
        return None
    nonzero, positive = _conditions(factor)
    return IntegratingFactor(factor, tuple(variables), multiplied, pairs, None, nonzero, positive)


def is_proportional(f: sp.Expr, form: Sequence[sp.Expr], variables: Sequence[sp.Symbol], slots: Slots) -> bool:
    """Whether df ∧ ω = 0 and df is not 0: f = const is the relation."""
    omega = OneForm.of((*form,), (*variables,), slots)
    rates = [omega.rate(f, k) for k in range(omega.size)]
    a = omega.coefficients
    try:
        across = (rates[i] * a[j] - rates[j] * a[i] for i, j in combinations(range(omega.size), 2))
        return not all(is_zero(r) for r in rates) and all(is_zero(x) for x in across)
    except DivisionByZeroError:
        return False


def _has_differential(f: sp.Expr, form: Sequence[sp.Expr], variables: Sequence[sp.Symbol], slots: Slots) -> bool:
    """Whether df is the form times a constant."""
    omega = OneForm.of((*form,), (*variables,), slots)
    k = next((k for k, a in enumerate(omega.coefficients) if a != 0), None)
    if k is None:
        return False
    ratio = omega.rate(f, k) / omega.coefficients[k]
    try:
        return all(is_zero(omega.rate(ratio, n)) for n in range(omega.size))
    except DivisionByZeroError:
        return False


def _conditions(factor: sp.Expr) -> tuple[tuple[sp.Expr, ...], tuple[sp.Expr, ...]]:
    """The factors required to be nonzero, and those required to be positive."""
    nonzero: list[sp.Expr] = []
    positive: list[sp.Expr] = []
    for part in _parts(factor):
        g, e = part.as_base_exp()
        if isinstance(part, sp.exp) or g.is_number or g.is_positive:
            continue
        g, power = g.as_base_exp() if g.is_Pow and g.exp.is_Integer else (g, sp.S.One)
        (nonzero if e.is_Integer or power.is_even or is_never_positive(-g) or g.is_nonnegative else positive).append(g)
    return tuple(g for g in dict.fromkeys(nonzero) if g not in positive), tuple(dict.fromkeys(positive))


def _parts(factor: sp.Expr) -> Iterable[sp.Expr]:
    for part in sp.Mul.make_args(factor):
        g, e = (part, sp.S.One) if isinstance(part, sp.exp) else part.as_base_exp()
        if g.is_Mul:
            yield from (p**e for p in sp.Mul.make_args(g))
        else:
            yield part
