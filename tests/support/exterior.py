"""Exterior algebra and vector fields on plain SymPy expressions: the slow second route of other tests.

A form is a dictionary from sorted tuples of symbols to coefficients. Undefined functions and prescribed
motions are replaced by concrete ones first, so that nothing here knows about slots, jets or prime fields.
"""

from __future__ import annotations

import random
from collections.abc import Mapping, Sequence
from itertools import combinations

import sympy as sp
from mpmath import mp

from lagrange.core.symbols import Unspecified, base, t

Form = dict[tuple[sp.Symbol, ...], sp.Expr]
DIGITS = 40


def wedge(a: Form, b: Form) -> Form:
    result: Form = {}
    for u, p in a.items():
        for v, q in b.items():
            both = (*u, *v)
            if len(set(both)) == len(both):
                key = tuple(sorted(both, key=str))
                inversions = sum(str(i) > str(j) for i, j in combinations(both, 2))
                result[key] = result.get(key, 0) + (-1) ** inversions * p * q
    return result


def d(a: Form, variables: Sequence[sp.Symbol]) -> Form:
    result: Form = {}
    for u, p in a.items():
        for v in variables:
            for key, c in wedge({(v,): sp.diff(p, v)}, {u: sp.S.One}).items():
                result[key] = result.get(key, 0) + c
    return result


def concrete(e: sp.Expr, prescribed: Sequence[sp.Symbol] = ()) -> sp.Expr:
    """Undefined functions and prescribed motions replaced by definite ones with no symmetry."""
    e = sp.sympify(e)
    for s in list(e.free_symbols):
        if base(s) in prescribed:
            motion = sp.exp(t / 3) + t**3 / 2 + t
            e = e.xreplace({s: sp.diff(motion, t, s.name.count("'"))})
    while functions := e.atoms(Unspecified):
        f = next(iter(functions))
        slots = [sp.Dummy(n, real=True) for n in f.argument_names]
        body = sum((s + 2) ** 3 / (k + 3) for k, s in enumerate(slots)) + sp.prod([s + 3 for s in slots])
        body += sp.exp(sum(s * (k + 1) for k, s in enumerate(slots)) / 9)
        for s, n in zip(slots, f.orders, strict=True):
            body = sp.diff(body, s, n)
        e = e.xreplace({f: body.xreplace(dict(zip(slots, f.arguments, strict=True)))})
    return e


def real_point(
    equations: Sequence[sp.Expr], unknowns: Sequence[sp.Symbol], symbols: Sequence[sp.Symbol], seed: int
) -> Mapping[sp.Symbol, sp.Expr]:
    """Values in (0.4, 1.6) for all symbols, of which `unknowns` are solved from `equations`."""
    for attempt in range(30):
        rng = random.Random(1000 * seed + attempt)
        values = {s: sp.Rational(rng.randrange(400, 1600), 1000) for s in sorted(symbols, key=str)}
        if not equations:
            return values
        fixed = {s: v for s, v in values.items() if s not in unknowns}
        try:
            there = [e.xreplace(fixed) for e in equations]
            start = [values[s] for s in unknowns]
            root = sp.nsolve(there, list(unknowns), start, prec=DIGITS + 10)
            return {**fixed, **dict(zip(unknowns, root, strict=True))}
        except (ValueError, ZeroDivisionError, TypeError):
            continue
    raise AssertionError("no real point")


def is_frobenius(
    form: Sequence[sp.Expr],
    variables: Sequence[sp.Symbol],
    geometric: Sequence[sp.Expr],
    solved: Sequence[sp.Symbol],
    seed: int,
) -> bool:
    """Whether ω ∧ dω ∧ df_1 ∧ ... vanishes at a real point with f = 0."""
    omega: Form = {(v,): a for v, a in zip(variables, form, strict=True)}
    product = wedge(omega, d(omega, variables))
    for f in geometric:
        product = wedge(product, {(v,): sp.diff(f, v) for v in variables})
    free = {*variables}.union(*(sp.sympify(a).free_symbols for a in (*form, *geometric)))
    point = real_point(geometric, solved, list(free), seed)
    return all(abs(sp.N(c.xreplace(point), DIGITS)) < sp.Float(10) ** -25 for c in product.values())


def flag_by_brackets(
    forms: Sequence[Sequence[sp.Expr]], variables: Sequence[sp.Symbol], seed: int = 1
) -> tuple[int, ...]:
    """The ranks of the derived flag from symbolic brackets of a null space, taken at a real point."""
    fields = [list(v) for v in sp.Matrix([list(f) for f in forms]).nullspace(simplify=False)]
    free = {*variables}.union(*(sp.sympify(a).free_symbols for f in forms for a in f))
    point = real_point((), (), list(free), seed)
    there = _Span(point)
    ranks = [len(variables) - sum(map(there.grows, fields))]
    while ranks[-1]:
        fields += [v for a, b in combinations(fields, 2) if there.grows(v := _bracket(a, b, variables))]
        ranks.append(len(variables) - len(there.basis))
        if ranks[-1] == ranks[-2]:
            return tuple(ranks[:-1])
    return tuple(ranks)


class _Span:
    """What vectors span at a point, as orthonormal numbers."""

    def __init__(self, point: Mapping[sp.Symbol, sp.Expr]) -> None:
        self.point, self.basis = point, list[list[mp.mpf]]()

    def grows(self, vector: Sequence[sp.Expr]) -> bool:
        """Takes a vector in; whether it is independent of those before."""
        with mp.workdps(DIGITS):
            left = _numbers(vector, self.point)
            whole = mp.norm(left)
            for unit in self.basis:
                share = mp.fdot(left, unit)
                left = [x - share * u for x, u in zip(left, unit, strict=True)]
            size = mp.norm(left)
            if size <= mp.mpf(10) ** -20 * (1 + whole):
                return False
            self.basis.append([x / size for x in left])
            return True


def _numbers(row: Sequence[sp.Expr], point: Mapping[sp.Symbol, sp.Expr]) -> list[mp.mpf]:
    return [mp.mpf(str(sp.N(e.xreplace(point), DIGITS))) for e in row]


def _bracket(a: Sequence[sp.Expr], b: Sequence[sp.Expr], variables: Sequence[sp.Symbol]) -> list[sp.Expr]:
    return [
        sum(a[j] * sp.diff(b[k], q) - b[j] * sp.diff(a[k], q) for j, q in enumerate(variables))
        for k in range(len(variables))
    ]


def rank(rows: Sequence[Sequence[sp.Expr]], point: Mapping[sp.Symbol, sp.Expr]) -> int:
    with mp.workdps(DIGITS):
        numbers = mp.matrix([_numbers(row, point) for row in rows])
        singular = mp.svd_r(numbers, compute_uv=False)
    return sum(1 for s in singular if s > mp.mpf(10) ** -20)
