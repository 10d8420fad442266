"""Integrating factors: not exact is not the same as not integrable.

A form ω = Σ a_i dq_i with ω ∧ dω = 0 has, locally, a factor μ that makes it the differential of a function,

    d(μω) = 0,      μω = dF,      ω = 0  <=>  F = const  where μ is finite and not 0.

Such factors are looked for in a bounded class, in this order: products of powers of what the coefficients are made of
(`exponents`); those beside a function of one variable (`one_variable`); 1/ω(X) for an affine symmetry X
(`symmetries`); functions of x + y, x y, ...; powers with exponents that contain parameters. What is found is proved on
the form: d(μω) = 0, dF ∧ ω = 0, both exactly. Where nothing is found a factor may still exist.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import combinations

import sympy as sp

from lagrange.algebra.exact.exact import DivisionByZeroError, NoPointError, UnsupportedError, is_zero
from lagrange.algebra.forms.exponents import (
    Exponents,
    exponents_beside,
    parametric_exponents,
    rational_exponents,
)
from lagrange.algebra.forms.factor_candidates import Candidate, candidates, common_factor, factored
from lagrange.algebra.forms.integrability import Exactness, exactness
from lagrange.algebra.forms.one_forms import OneForm
from lagrange.algebra.forms.one_variable import factor_beside, factors_of_combinations, shortened, shortest
from lagrange.algebra.forms.potentials import potential
from lagrange.algebra.forms.relations import moves, tidy_relation
from lagrange.algebra.forms.symmetries import symmetries
from lagrange.core.records import record
from lagrange.core.symbols import Slots, Unspecified

LARGEST_FORM = 200
MOST_VARIABLES = 8
MOST_BESIDE = 3
MOST_WITHOUT_POTENTIAL = 5
MOST_PROPOSED = 24
MOST_WITH_PARAMETERS = 6
LARGEST_FACTOR = 150


@record
class IntegratingFactor:
    """μ for a form ω.

    factor     μ
    variables  (k,)
    form       the coefficients of μω, shape (k,)
    exactness  its pairs of partial derivatives, all equal
    integral   F with dF = μω times a constant; None where it was not found in closed form
    nonzero    what must not vanish for μ to be finite and not 0
    positive   what must be positive for μ to be real
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
    if not omega.size or omega.size > MOST_VARIABLES or sum(sp.count_ops(a) for a in form) > LARGEST_FORM:
        return None
    without_potential: IntegratingFactor | None = None
    failures = 0
    for proposed in _distinct(_proposed(omega)):
        found = _proved(proposed, form, variables, slots, angles)
        if found is None:
            continue
        if found.integral is not None:
            return found
        without_potential = without_potential or found
        failures += 1
        if failures >= MOST_WITHOUT_POTENTIAL:
            break
    return without_potential


def _proposed(omega: OneForm) -> Iterator[sp.Expr]:
    """Factors that are likely to do, the simplest kinds first."""
    if omega.size == 1:
        yield 1 / omega.coefficients[0]
        return
    common = common_factor(omega)
    if common != 1:
        omega = OneForm(shortest(omega.times(1 / common)), omega.variables, omega.slots)
        yield 1 / common
    ways = (_products, _beside_one_variable, _of_symmetries, factors_of_combinations, _with_parameters)
    for way in ways:
        try:
            yield from (found / common for found in way(omega))
        except (UnsupportedError, DivisionByZeroError, NoPointError):
            continue


def _distinct(proposed: Iterator[sp.Expr]) -> Iterator[sp.Expr]:
    seen: set[sp.Expr] = set()
    for e in proposed:
        if len(seen) >= MOST_PROPOSED:
            return
        if e not in seen and sp.count_ops(e) <= LARGEST_FACTOR:
            seen.add(e)
            yield e


def _products(omega: OneForm) -> Iterator[sp.Expr]:
    trials = candidates(omega)
    yield from (_product(e, trials) for e in rational_exponents(omega, trials))


def _beside_one_variable(omega: OneForm) -> Iterator[sp.Expr]:
    """Π g^e · exp ∫ h dv."""
    trials = candidates(omega)
    for k, v in enumerate(omega.variables):
        beside = [c for c in trials if not _depends_only_on(c.function, v, omega)]
        for n, exponents in enumerate(exponents_beside(omega, beside, k)):
            found = factor_beside(omega, _product(exponents, beside), k)
            if found is not None:
                yield found
            if n + 1 >= MOST_BESIDE:
                break


def _depends_only_on(e: sp.Expr, v: sp.Symbol, omega: OneForm) -> bool:
    return not e.has(Unspecified) and not e.free_symbols & omega.moving - {v}


def _of_symmetries(omega: OneForm) -> Iterator[sp.Expr]:
    """1/ω(X)."""
    for field in symmetries(omega):
        across = sp.Add(*(a * x for a, x in zip(omega.coefficients, field, strict=True)))
        if is_zero(across) is False:
            yield 1 / factored(across)


def _with_parameters(omega: OneForm) -> Iterator[sp.Expr]:
    """Powers with exponents that contain parameters, of the simplest candidates."""
    if omega.parameters:
        trials = candidates(omega)
        trials = sorted(trials, key=lambda c: sp.count_ops(c.function))[:MOST_WITH_PARAMETERS]
        yield from (_product(e, trials) for e in parametric_exponents(omega, trials))


def _product(exponents: Exponents, trials: Sequence[Candidate]) -> sp.Expr:
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
    factor = sp.Mul(*(g for g in sp.Mul.make_args(factor) if moves(g, moving)))
    if factor.has(sp.exp) or any(not p.exp.is_Rational for p in factor.atoms(sp.Pow)):
        factor = sp.powsimp(factor)
    multiplied = shortest([factor * a for a in form])
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
    """What must not vanish, and what must be positive."""
    nonzero: list[sp.Expr] = []
    positive: list[sp.Expr] = []
    for part in _parts(factor):
        g, e = part.as_base_exp()
        if isinstance(part, sp.exp) or g.is_number or g.is_positive:
            continue
        (nonzero if e.is_Integer or g.is_nonnegative else positive).append(g)
    return tuple(dict.fromkeys(nonzero)), tuple(dict.fromkeys(positive))


def _parts(factor: sp.Expr) -> Iterable[sp.Expr]:
    for part in sp.Mul.make_args(factor):
        g, e = (part, sp.S.One) if isinstance(part, sp.exp) else part.as_base_exp()
        if g.is_Mul:
            yield from (p**e for p in sp.Mul.make_args(g))
        else:
            yield part
