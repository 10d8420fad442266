"""Functions of which finite relations may be made: a bounded dictionary, the simplest first.

If Σ a_i dq_i = df, every term of f is an antiderivative of a term of some a_i, and a combination of forms only mixes
these terms. So the candidates for f are, in three stages,

    1  coordinates, t and prescribed motions; squares of the linear sums that occur, (x1 - x2)²; ∫ (term of a_i) dq_i
    2  the functions that occur, sin θ, and the products of two coordinates
    3  ∫ (a_i/a_j) dq_i; functions times coordinates or functions, φ cos θ; and logarithms of coordinates.

Constants, numbers or parameters, are left out: they are what the search finds (`hidden_relations`).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import combinations_with_replacement, product

import sympy as sp

from lagrange.algebra.forms.antiderivatives import antiderivative, multiplied_out
from lagrange.algebra.forms.potentials import differentiated
from lagrange.core.symbols import Slots, Unspecified, base, t

MOST = (70, 110, 150)
MOST_TERMS = 120
LONGEST_TERM = 40
MOST_EXPANDED = 400
LONGEST_FORM = 4

Form = Sequence[sp.Expr]


def candidates(
    forms: Sequence[Form], slots: Slots, rules: Mapping[sp.Symbol, sp.Expr]
) -> Iterator[tuple[sp.Expr, ...]]:
    """The dictionary after each stage, each time with more at its end; at most `MOST` functions.

    forms      (m, n + 1): coefficients of dq_1 ... dq_n, dt
    rules      coordinates that geometric constraints give in terms of others
    """
    plain = _plain(forms, slots)
    functions = _functions(forms, slots)
    coordinates = [q for q in plain if q != t]
    stages: tuple[Iterable[sp.Expr], ...] = (
        (*plain, *_squares(forms, slots), *_antiderivatives(_terms(forms, slots), slots)),
        (*functions, *(a * b for a, b in combinations_with_replacement(plain, 2))),
        (
            *_antiderivatives(_ratios(forms, slots, rules), slots),
            *(a * b for a, b in product(functions, plain)),
            *(a * b for a, b in combinations_with_replacement(functions, 2)),
            *(sp.log(q if q.is_positive else sp.Abs(q)) for q in coordinates),
        ),
    )
    found: dict[sp.Expr, None] = {}
    for stage, most in zip(stages, MOST, strict=True):
        for e in stage:
            if len(found) >= most:
                break
            found[e] = None
        yield tuple(found)


def moves(e: sp.Expr, slots: Slots) -> bool:
    """Whether an expression contains a coordinate, t or a prescribed motion: whether it is not a constant."""
    return any(_moving(s, slots) for s in e.free_symbols)


def without_constants(e: sp.Expr, slots: Slots) -> sp.Expr:
    """A product without its constant factors."""
    return sp.Mul(*(f for f in sp.Mul.make_args(e) if moves(f, slots)))


def _moving(s: sp.Symbol, slots: Slots) -> bool:
    return s == t or s in slots.coordinates or base(s) in slots.prescribed


def _plain(forms: Sequence[Form], slots: Slots) -> list[sp.Symbol]:
    """The coordinates; t where there is a dt or it occurs; the prescribed motions that occur."""
    symbols = {s for form in forms for a in form for s in a.free_symbols}
    timed = t in symbols or any(form[-1] != 0 for form in forms)
    return [*slots.coordinates, *([t] if timed else []), *(u for u in slots.prescribed if _occurs(u, symbols))]


def _occurs(u: sp.Symbol, symbols: set[sp.Symbol]) -> bool:
    return any(base(s) == u for s in symbols)


def _squares(forms: Sequence[Form], slots: Slots) -> list[sp.Expr]:
    """(x1 - x2)² for the sums and differences of coordinates that occur, of either sign once."""
    found: dict[sp.Expr, None] = {}
    for form in forms:
        for a in form:
            for e in sp.preorder_traversal(a):
                if e.is_Add and all(term in slots.coordinates or -term in slots.coordinates for term in e.args):
                    found[(-e if e.could_extract_minus_sign() else e) ** 2] = None
    return sorted(found, key=_weight)


def _antiderivatives(terms: Iterable[tuple[sp.Symbol, sp.Expr]], slots: Slots) -> Iterator[sp.Expr]:
    """∫ (term) dv, the shortest terms first."""
    varying = dict.fromkeys((v, without_constants(term, slots)) for v, term in terms if term != 0)
    short = [pair for pair in varying if pair[1].count_ops() <= LONGEST_TERM]
    for v, term in sorted(short, key=lambda pair: _weight(pair[1]))[:MOST_TERMS]:
        found = _integral(term, v, slots)
        if found is not None:
            yield without_constants(found, slots)


def _terms(forms: Sequence[Form], slots: Slots) -> Iterator[tuple[sp.Symbol, sp.Expr]]:
    """The terms of all coefficients, multiplied out, each with the variable of its differential."""
    for form in forms:
        for v, a in zip((*slots.coordinates, t), form, strict=True):
            expanded = multiplied_out(a) if a.count_ops() <= MOST_EXPANDED else a
            yield from ((v, term) for term in sp.Add.make_args(expanded))


def _ratios(
    forms: Sequence[Form], slots: Slots, rules: Mapping[sp.Symbol, sp.Expr]
) -> Iterator[tuple[sp.Symbol, sp.Expr]]:
    """The ratios of two coefficients of short forms, on the constraint surface as far as it is given explicitly."""
    for form in forms:
        entries = [(v, a) for v, a in _pulled_back(form, slots, rules).items() if a != 0]
        if len(entries) <= LONGEST_FORM and all(a.count_ops() <= LONGEST_TERM // 2 for _, a in entries):
            yield from ((v, a / b) for v, a in entries for w, b in entries if w != v and moves(b, slots))


def _pulled_back(form: Form, slots: Slots, rules: Mapping[sp.Symbol, sp.Expr]) -> dict[sp.Symbol, sp.Expr]:
    """A form with the coordinates that are given explicitly, and their differentials, replaced."""
    there = {v: a.xreplace(rules) for v, a in zip((*slots.coordinates, t), form, strict=True)}
    found = {v: a for v, a in there.items() if v not in rules}
    for s, e in rules.items():
        if there.get(s, 0) != 0:
            found |= {v: a + there[s] * differentiated(e, v, slots) for v, a in found.items()}
    return found


def _integral(term: sp.Expr, v: sp.Symbol, slots: Slots) -> sp.Expr | None:
    """∫ term dv; over t, of a prescribed motion only c(q) u' dt = d(c u) - ...."""
    motions = [s for s in term.free_symbols if base(s) in slots.prescribed] if v == t else []
    if not motions:
        return antiderivative(term, v)
    if len(motions) > 1 or t in term.free_symbols or motions[0] not in (term, *term.args):
        return None
    [u] = motions
    return term.xreplace({u: sp.Symbol(u.name[:-1], real=True)}) if u.name.endswith("'") else None


def _functions(forms: Sequence[Form], slots: Slots) -> list[sp.Expr]:
    """The functions that occur, sines and cosines in pairs, and those whose derivatives do, shortest first."""
    found: dict[sp.Expr, None] = {}
    for form in forms:
        for a in form:
            for e in sp.preorder_traversal(a):
                if not isinstance(e, sp.Function | Unspecified) or not moves(e, slots):
                    continue
                if isinstance(e, sp.sin | sp.cos | sp.tan):
                    found |= {sp.sin(e.args[0]): None, sp.cos(e.args[0]): None}
                elif isinstance(e, Unspecified):
                    found[e.func(e.args[0], e.args[1], sp.Tuple(*(0 for _ in e.orders)), *e.arguments)] = None
                else:
                    found[e] = None
    return sorted(found, key=_weight)


def _weight(e: sp.Expr) -> tuple[int, str]:
    return int(e.count_ops()), str(e)
