"""Combinations of given functions that stay constant under the constraints: linear algebra at random points.

φ = Σ c_k φ_k stays constant if dφ vanishes in every direction X that the constraints admit,

    Σ_k c_k (X φ_k) = 0      at every point, for every X with ω_j(X) = 0.

The c_k are constants: numbers, or functions of the parameters. The parameters therefore keep their random values in a
prime field (`Trial`) while points are drawn; the null space of the rows (X φ_1, X φ_2, ...) gives the values of the c_k
there, and several trials give them as polynomials of the lowest degree possible in the parameters, with rational
coefficients. Nothing here is certain: what comes out is verified in `hidden_relations`.

The φ_k come from a bounded dictionary. If Σ a_i dq_i = df, every term of f is an antiderivative of a term of some a_i,
and a combination of forms only mixes these terms. So there are three stages, the simplest functions first:

    1  coordinates, t and prescribed motions; squares of the linear sums that occur, (x1 − x2)²; ∫ (term of a_i) dq_i
    2  the functions that occur, sin θ, and the products of two coordinates
    3  ∫ (a_i/a_j) dq_i; functions times coordinates or functions, φ cos θ; and logarithms of coordinates.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import combinations_with_replacement, product

import sympy as sp

from lagrange.algebra.exact.expression_graph import Graph
from lagrange.algebra.exact.limits import DRAWS
from lagrange.algebra.exact.linear_algebra import row_reduced
from lagrange.algebra.exact.triangular import SolutionOrder
from lagrange.algebra.exact.zero_test import FieldPoint, InadmissibleError, Surface, UnsupportedError
from lagrange.algebra.forms.antiderivatives import antiderivative, multiplied_out
from lagrange.algebra.forms.exact_forms import differentiated
from lagrange.algebra.forms.limits import (
    HIGHEST_CONSTANT_DEGREE,
    LARGEST_EXPANDED,
    LONGEST_TERM,
    MOST_CANDIDATES,
    MOST_CONSTANT_UNKNOWNS,
    MOST_FAILED_POINTS,
    MOST_INTEGRATED_TERMS,
    MOST_RATIO_ENTRIES,
)
from lagrange.core.expression_size import count_operations
from lagrange.core.symbols import Slots, Unspecified, base, t

Form = Sequence[sp.Expr]


def integral_candidates(
    forms: Sequence[Form], slots: Slots, rules: Mapping[sp.Symbol, sp.Expr]
) -> Iterator[tuple[sp.Expr, ...]]:
    """The dictionary after each stage, each time with more at its end; at most `MOST_CANDIDATES` functions.

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
    functions_so_far: dict[sp.Expr, None] = {}
    for stage, most in zip(stages, MOST_CANDIDATES, strict=True):
        for e in stage:
            if len(functions_so_far) >= most:
                break
            functions_so_far[e] = None
        yield tuple(functions_so_far)


def is_variable(e: sp.Expr, slots: Slots) -> bool:
    """Whether an expression contains a coordinate, t or a prescribed motion: whether it is not a constant."""
    return any(_moving(s, slots) for s in e.free_symbols)


def without_constants(e: sp.Expr, slots: Slots) -> sp.Expr:
    """A product without its constant factors."""
    return sp.Mul(*(f for f in sp.Mul.make_args(e) if is_variable(f, slots)))


def _moving(s: sp.Symbol, slots: Slots) -> bool:
    return s == t or s in slots.coordinates or base(s) in slots.prescribed


def _plain(forms: Sequence[Form], slots: Slots) -> list[sp.Symbol]:
    """The coordinates, t if it or a dt occurs, and the prescribed motions that occur."""
    symbols = {s for form in forms for a in form for s in a.free_symbols}
    timed = t in symbols or any(form[-1] != 0 for form in forms)
    return [*slots.coordinates, *([t] if timed else []), *(u for u in slots.prescribed if _occurs(u, symbols))]


def _occurs(u: sp.Symbol, symbols: set[sp.Symbol]) -> bool:
    return any(base(s) == u for s in symbols)


def _squares(forms: Sequence[Form], slots: Slots) -> list[sp.Expr]:
    """(x1 - x2)² for the sums and differences of coordinates that occur, of either sign once."""
    squares: dict[sp.Expr, None] = {}
    for form in forms:
        for a in form:
            for e in sp.preorder_traversal(a):
                if e.is_Add and all(term in slots.coordinates or -term in slots.coordinates for term in e.args):
                    squares[(-e if e.could_extract_minus_sign() else e) ** 2] = None
    return sorted(squares, key=_weight)


def _antiderivatives(terms: Iterable[tuple[sp.Symbol, sp.Expr]], slots: Slots) -> Iterator[sp.Expr]:
    """∫ (term) dv, the shortest terms first."""
    varying = dict.fromkeys((v, without_constants(term, slots)) for v, term in terms if term != 0)
    short = [pair for pair in varying if count_operations(pair[1]) <= LONGEST_TERM]
    for v, term in sorted(short, key=lambda pair: _weight(pair[1]))[:MOST_INTEGRATED_TERMS]:
        integral = _integral(term, v, slots)
        if integral is not None:
            yield without_constants(integral, slots)


def _terms(forms: Sequence[Form], slots: Slots) -> Iterator[tuple[sp.Symbol, sp.Expr]]:
    """The terms of all coefficients, multiplied out, each with the variable of its differential."""
    for form in forms:
        for v, a in zip((*slots.coordinates, t), form, strict=True):
            expanded = multiplied_out(a) if count_operations(a) <= LARGEST_EXPANDED else a
            yield from ((v, term) for term in sp.Add.make_args(expanded))


def _ratios(
    forms: Sequence[Form], slots: Slots, rules: Mapping[sp.Symbol, sp.Expr]
) -> Iterator[tuple[sp.Symbol, sp.Expr]]:
    """The ratios of two coefficients of short forms, on the constraint surface as far as it is given explicitly."""
    for form in forms:
        entries = [(v, a) for v, a in _pulled_back(form, slots, rules).items() if a != 0]
        if len(entries) <= MOST_RATIO_ENTRIES and all(count_operations(a) <= LONGEST_TERM // 2 for _, a in entries):
            yield from ((v, a / b) for v, a in entries for w, b in entries if w != v and is_variable(b, slots))


def _pulled_back(form: Form, slots: Slots, rules: Mapping[sp.Symbol, sp.Expr]) -> dict[sp.Symbol, sp.Expr]:
    """A form with the coordinates that are given explicitly, and their differentials, replaced."""
    substituted = {v: a.xreplace(rules) for v, a in zip((*slots.coordinates, t), form, strict=True)}
    pulled = {v: a for v, a in substituted.items() if v not in rules}
    for s, e in rules.items():
        if substituted.get(s, 0) != 0:
            pulled |= {v: a + substituted[s] * differentiated(e, v, slots) for v, a in pulled.items()}
    return pulled


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
    functions: dict[sp.Expr, None] = {}
    for form in forms:
        for a in form:
            for e in sp.preorder_traversal(a):
                if not isinstance(e, sp.Function | Unspecified) or not is_variable(e, slots):
                    continue
                if isinstance(e, sp.sin | sp.cos | sp.tan):
                    functions |= {sp.sin(e.args[0]): None, sp.cos(e.args[0]): None}
                elif isinstance(e, Unspecified):
                    functions[e.func(e.args[0], e.args[1], sp.Tuple(*(0 for _ in e.orders)), *e.arguments)] = None
                else:
                    functions[e] = None
    return sorted(functions, key=_weight)


def _weight(e: sp.Expr) -> tuple[int, str]:
    return count_operations(e), str(e)


ResidueValues = dict[int, int]


class NoTrialError(Exception):
    """There are no points with these values of the parameters."""


class SampledForms:
    """Forms on a surface and functions, ready to be evaluated at points of one prime field.

    forms      (m, n + 1): coefficients of dq_1 ... dq_n, dt; the differentials of the geometric constraints among them
    """

    def __init__(self, forms: Sequence[Form], order: SolutionOrder, surface: Surface, slots: Slots) -> None:
        self.slots = slots
        self.order = order
        self.fields = surface.fields
        self.graph = Graph(order.rules)
        self.functions: list[sp.Expr] = []
        self.forms = [[self.graph.node(a) for a in form] for form in forms]
        for f in surface.constraints:
            self.graph.node(f)
        self.constants = _constants([a for form in forms for a in form], slots)
        self.constant_nodes = [self.graph.node(c) for c in self.constants]
        self._gradients: list[list[tuple[int, int]]] = []
        self._known: list[list[int]] = []

    def add(self, function: sp.Expr) -> None:
        """One more function, unless it cannot be evaluated."""
        gradient = ((i, differentiated(function, v, self.slots)) for i, v in enumerate((*self.slots.coordinates, t)))
        try:
            nodes = [(i, self.graph.node(d)) for i, d in gradient if d != 0]
        except UnsupportedError:
            return
        self.functions.append(function)
        self._gradients.append(nodes)

    def know(self, form: Form) -> None:
        """The differential of a relation that is known."""
        self._known.append([self.graph.node(a) for a in form])

    def gradient(self, point: FieldPoint, function: int) -> list[tuple[int, int]]:
        """The components of a gradient that are not identically zero, at a point, with their indices."""
        return [(i, point.at(n)) for i, n in self._gradients[function]]

    def is_new(self, point: FieldPoint, values: ResidueValues) -> bool:
        """Whether the gradient of a combination is independent of those of the known relations, at a point."""
        total = [0] * (len(self.slots.coordinates) + 1)
        for k, c in values.items():
            for i, d in self.gradient(point, k):
                total[i] = point.arithmetic.reduce(total[i] + c * d)
        known = [[point.at(n) for n in form] for form in self._known]
        return any(total) and point.rank([*known, total]) > point.rank(known)

    def parameters(self) -> list[sp.Symbol]:
        """The constants that occur anywhere."""
        return [s for s in self.graph.bits if not is_variable(s, self.slots)]

    def moving(self) -> list[sp.Symbol]:
        """All other symbols."""
        return [s for s in self.graph.bits if is_variable(s, self.slots)]


class Trial:
    """Random values of the parameters, and the points that have them."""

    def __init__(self, space: SampledForms, base: FieldPoint | None = None) -> None:
        self.space = space
        if base is None:
            field = space.fields.field(0, space.graph.squares)
            blank = FieldPoint(space.graph, field, space.fields.random.getrandbits(16))
            # The parameters are fixed values from here on; redrawing points leaves them.
            base = blank.with_values({p: blank.input(p) for p in space.parameters()})
        self.base = base
        self.arithmetic = base.field

    def varied(self, parameter: sp.Symbol) -> Trial:
        """The same with another value of one parameter."""
        other = FieldPoint(self.space.graph, self.base.field, ~self.base.signs)
        return Trial(self.space, self.base.with_values({parameter: other.input(parameter)}))

    def constants(self) -> list[int]:
        """The values of `SampledForms.constants`. Raises InadmissibleError."""
        return [self.base.at(n) for n in self.space.constant_nodes]

    def points(self) -> Iterator[FieldPoint]:
        """Points without end. Raises NoTrialError."""
        moving = self.space.moving()
        while True:
            point = self.space.order.drawn(lambda: self.base.redrawn(moving), DRAWS)
            if point is None:
                raise NoTrialError
            yield point

    def is_new(self, values: ResidueValues) -> bool:
        """Whether a combination is no function of the known relations. Raises NoTrialError."""
        points = self.points()
        for _ in range(MOST_FAILED_POINTS):
            try:
                return self.space.is_new(next(points), values)
            except InadmissibleError:
                continue
        raise NoTrialError

    def combinations(self, functions: Sequence[int]) -> list[ResidueValues]:
        """The combinations that stay constant: the last function of each has the coefficient 1.

        Raises NoTrialError.
        """
        reduced: list[list[int]] = []
        pivots: list[int] = []
        points, failures, number = self.points(), 0, 1
        while True:
            rows = list(reduced)
            while number:
                try:
                    new = self._rows(next(points), functions)
                    number -= 1
                except InadmissibleError:
                    failures += 1
                    if failures > MOST_FAILED_POINTS * (1 + len(functions)):
                        raise NoTrialError from None
                    continue
                if not rows and new:
                    number = len(functions) // len(new) + 2
                rows += new
            # New points until they add no row: then the null space is that of all points, up to a chance of 1/p.
            before = len(reduced)
            reduced, pivots = row_reduced(self.arithmetic, rows)
            if len(reduced) == before:
                break
            number = 2
        combinations = []
        for free in (k for k in range(len(functions)) if k not in pivots):
            others = {functions[p]: -row[free] for p, row in zip(pivots, reduced, strict=True) if row[free]}
            combinations.append({k: self.arithmetic.reduce(v) for k, v in others.items()} | {functions[free]: 1})
        return combinations

    def _rows(self, point: FieldPoint, functions: Sequence[int]) -> list[list[int]]:
        """Xφ_k for a basis of the directions X that the forms admit, shape (directions, functions)."""
        width = len(self.space.slots.coordinates) + 1
        directions = point.nullspace([[point.at(n) for n in form] for form in self.space.forms], width)
        gradients = [self.space.gradient(point, k) for k in functions]
        reduce = self.arithmetic.reduce
        return [[reduce(sum(x[i] * d for i, d in gradient)) for gradient in gradients] for x in directions]


def combination_constants(space: SampledForms, trial: Trial, values: ResidueValues) -> dict[int, sp.Expr] | None:
    """The constants c_k of a combination whose values in one trial are known, up to a common factor; None: not found.

    Raises NoTrialError.
    """
    support = list(values)
    numbers = _rational(values, trial)
    if numbers is not None and _values(Trial(space), support) == values:
        return numbers
    # Only parameters on which some c_k depends enter the polynomials: varied one by one.
    relevant = {p for p in space.parameters() if _values(trial.varied(p), support) != values}
    places = [n for n, c in enumerate(space.constants) if c.free_symbols & relevant]
    for degree in range(1, HIGHEST_CONSTANT_DEGREE + 1):
        powers = [m for d in range(degree + 1) for m in combinations_with_replacement(places, d)]
        if len(powers) * len(support) > MOST_CONSTANT_UNKNOWNS:
            break
        polynomials = _polynomials(space, support, powers)
        if polynomials:
            return polynomials
    return None


def _polynomials(
    space: SampledForms, support: list[int], powers: Sequence[tuple[int, ...]]
) -> dict[int, sp.Expr] | None:
    """Polynomials P_k with P_k = c_k P_last in every trial; `powers` are products of constants, by their places."""
    rows: list[list[int]] = []
    unknowns, last = len(powers) * len(support), len(support) - 1
    trial = Trial(space)
    field, monomials = trial.arithmetic, list[int]()
    for _ in range(unknowns // max(last, 1) + 3):
        trial = Trial(space)
        values = _values(trial, support)
        if values is None:
            raise NoTrialError
        known = trial.constants()
        monomials = [_product(known, m, field.p) for m in powers]
        for n, k in enumerate(support[:-1]):
            row = [0] * unknowns
            row[n * len(powers) : (n + 1) * len(powers)] = monomials
            row[last * len(powers) :] = [-values[k] * m % field.p for m in monomials]
            rows.append(row)
    reduced, pivots = row_reduced(field, rows)
    for free in (k for k in range(unknowns) if k not in pivots):
        solution = {p: field.reduce(-row[free]) for p, row in zip(pivots, reduced, strict=True) if row[free]} | {
            free: 1
        }
        weights = [solution.get(last * len(powers) + m, 0) for m in range(len(powers))]
        # An identity between the constants, cos² α + sin² α − 1, solves the equations too, and means nothing.
        if not field.vanishes(sum(w * m for w, m in zip(weights, monomials, strict=True)) % field.p):
            return _written_out(space, trial, solution, support, powers)
    return None


def _written_out(
    space: SampledForms, trial: Trial, solution: ResidueValues, support: list[int], powers: Sequence[tuple[int, ...]]
) -> dict[int, sp.Expr] | None:
    coefficients = dict.fromkeys(support, sp.S.Zero)
    for place, residue in solution.items():
        number = trial.base.reconstructed(residue)
        if number is None:
            return None
        n, m = divmod(place, len(powers))
        coefficients[support[n]] += number * sp.Mul(*(space.constants[c] for c in powers[m]))
    return coefficients


def _rational(values: ResidueValues, trial: Trial) -> dict[int, sp.Expr] | None:
    numbers = {k: trial.base.reconstructed(v) for k, v in values.items()}
    return None if None in numbers.values() else {k: n for k, n in numbers.items() if n is not None}


def _values(trial: Trial, support: Sequence[int]) -> ResidueValues | None:
    """The values of the c_k in another trial, None if the functions do not have just one such combination."""
    combinations = trial.combinations(support)
    return combinations[0] if len(combinations) == 1 else None


def _product(values: Sequence[int], places: Sequence[int], p: int) -> int:
    result = 1
    for n in places:
        result = result * values[n] % p
    return result


def _constants(entries: Sequence[sp.Expr], slots: Slots) -> list[sp.Expr]:
    """The constants that occur: parameters, and functions and roots of them."""
    constants: dict[sp.Expr, None] = {}

    def visit(e: sp.Expr) -> None:
        if e.is_number:
            return
        composite = e.is_Add or e.is_Mul or (isinstance(e, sp.Pow) and e.exp.is_Integer)
        if not composite and not is_variable(e, slots):
            constants[e] = None
        for a in e.args:
            if isinstance(a, sp.Expr):
                visit(a)

    for e in entries:
        visit(e)
    return sorted(constants, key=lambda e: (count_operations(e), str(e)))


def combined(functions: Sequence[sp.Expr], coefficients: Mapping[int, sp.Expr]) -> sp.Expr:
    """Σ c_k φ_k, functions with the same coefficient in brackets: R (φ1 - φ2) - 2 b θ."""
    groups: dict[sp.Expr, list[sp.Expr]] = {}
    for k, c in coefficients.items():
        number, constant = c.as_coeff_Mul()
        groups.setdefault(constant, []).append(number * functions[k])
    return sp.Add(*(_bracket(c, terms) for c, terms in groups.items()))


def _bracket(constant: sp.Expr, terms: Sequence[sp.Expr]) -> sp.Expr:
    """constant · Σ terms, the first term positive within the bracket."""
    sign = -1 if terms[0].as_coeff_Mul()[0].is_negative else 1
    return sign * constant * sp.Add(*(sign * term for term in terms))
