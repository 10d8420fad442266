"""Which combinations of given functions stay constant: linear algebra at random points, with constants as coefficients.

φ = Σ c_k φ_k stays constant under the constraints if dφ vanishes in every direction X that they admit,

    Σ_k c_k (X φ_k) = 0      at every point, for every X with ω_j(X) = 0.

The c_k are constants: numbers, or functions of the parameters. So the parameters get random values in a prime field
that are kept (`Trial`) while points are drawn. The null space of the rows (X φ_1, X φ_2, ...) gives the values that the
c_k have there, one combination for each function that depends on simpler ones before it. How they depend on the
parameters is found from several trials: as polynomials of the lowest degree that will do, with rational coefficients.

Nothing here is certain: what comes out is to be verified (`hidden_relations`).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import combinations_with_replacement

import sympy as sp

from lagrange.algebra.exact.evaluation import Graph
from lagrange.algebra.exact.exact import FieldPoint, InadmissibleError, Surface, UnsupportedError
from lagrange.algebra.exact.linear_algebra import row_reduced
from lagrange.algebra.exact.triangular import DRAWS, Order
from lagrange.algebra.forms.candidates import moves
from lagrange.algebra.forms.potentials import differentiated
from lagrange.core.symbols import Slots, t

HIGHEST_DEGREE = 4
MOST_UNKNOWNS = 200
FAILURES = 20

Form = Sequence[sp.Expr]
Values = dict[int, int]


class NoTrialError(Exception):
    """There are no points with these values of the parameters."""


class Space:
    """Forms on a surface and functions, ready to be evaluated at points of one prime field.

    forms      (m, n + 1): coefficients of dq_1 ... dq_n, dt; the differentials of the geometric constraints among them
    """

    def __init__(self, forms: Sequence[Form], order: Order, surface: Surface, slots: Slots) -> None:
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
        """The places and values of what is not written as 0 in a gradient."""
        return [(i, point.at(n)) for i, n in self._gradients[function]]

    def is_new(self, point: FieldPoint, values: Values) -> bool:
        """Whether the gradient of a combination is independent of those of the known relations, at a point."""
        total = [0] * (len(self.slots.coordinates) + 1)
        for k, c in values.items():
            for i, d in self.gradient(point, k):
                total[i] = point.arithmetic.reduce(total[i] + c * d)
        known = [[point.at(n) for n in form] for form in self._known]
        return any(total) and point.rank([*known, total]) > point.rank(known)

    def parameters(self) -> list[sp.Symbol]:
        """The constants that occur anywhere."""
        return [s for s in self.graph.bits if not moves(s, self.slots)]

    def moving(self) -> list[sp.Symbol]:
        """All other symbols."""
        return [s for s in self.graph.bits if moves(s, self.slots)]


class Trial:
    """Random values of the parameters, and the points that have them."""

    def __init__(self, space: Space, base: FieldPoint | None = None) -> None:
        self.space = space
        if base is None:
            field = space.fields.field(0, space.graph.squares)
            blank = FieldPoint(space.graph, field, space.fields.random.getrandbits(16))
            base = blank.with_values({p: blank.input(p) for p in space.parameters()})
        self.base = base
        self.arithmetic = base.field

    def varied(self, parameter: sp.Symbol) -> Trial:
        """The same with another value of one parameter."""
        other = FieldPoint(self.space.graph, self.base.field, ~self.base.signs)
        return Trial(self.space, self.base.with_values({parameter: other.input(parameter)}))

    def constants(self) -> list[int]:
        """The values of `Space.constants`. Raises InadmissibleError."""
        return [self.base.at(n) for n in self.space.constant_nodes]

    def points(self) -> Iterator[FieldPoint]:
        """Points without end. Raises NoTrialError."""
        moving = self.space.moving()
        while True:
            point = self.space.order.drawn(lambda: self.base.redrawn(moving), DRAWS)
            if point is None:
                raise NoTrialError
            yield point

    def is_new(self, values: Values) -> bool:
        """Whether a combination is no function of the known relations. Raises NoTrialError."""
        points = self.points()
        for _ in range(FAILURES):
            try:
                return self.space.is_new(next(points), values)
            except InadmissibleError:
                continue
        raise NoTrialError

    def combinations(self, functions: Sequence[int]) -> list[Values]:
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
                    if failures > FAILURES * (1 + len(functions)):
                        raise NoTrialError from None
                    continue
                if not rows and new:
                    number = len(functions) // len(new) + 2
                rows += new
            before = len(reduced)
            reduced, pivots = row_reduced(self.arithmetic, rows)
            if len(reduced) == before:
                break
            number = 2
        found = []
        for free in (k for k in range(len(functions)) if k not in pivots):
            others = {functions[p]: -row[free] for p, row in zip(pivots, reduced, strict=True) if row[free]}
            found.append({k: self.arithmetic.reduce(v) for k, v in others.items()} | {functions[free]: 1})
        return found

    def _rows(self, point: FieldPoint, functions: Sequence[int]) -> list[list[int]]:
        """Xφ_k for a basis of the directions X that the forms admit, shape (directions, functions)."""
        width = len(self.space.slots.coordinates) + 1
        directions = point.nullspace([[point.at(n) for n in form] for form in self.space.forms], width)
        gradients = [self.space.gradient(point, k) for k in functions]
        reduce = self.arithmetic.reduce
        return [[reduce(sum(x[i] * d for i, d in gradient)) for gradient in gradients] for x in directions]


def coefficients(space: Space, trial: Trial, values: Values) -> dict[int, sp.Expr] | None:
    """The constants c_k of a combination whose values in one trial are known, up to a common factor; None: not found.

    Raises NoTrialError.
    """
    support = list(values)
    numbers = _rational(values, trial)
    if numbers is not None and _values(Trial(space), support) == values:
        return numbers
    relevant = {p for p in space.parameters() if _values(trial.varied(p), support) != values}
    places = [n for n, c in enumerate(space.constants) if c.free_symbols & relevant]
    for degree in range(1, HIGHEST_DEGREE + 1):
        powers = [m for d in range(degree + 1) for m in combinations_with_replacement(places, d)]
        if len(powers) * len(support) > MOST_UNKNOWNS:
            break
        found = _polynomials(space, support, powers)
        if found:
            return found
    return None


def _polynomials(space: Space, support: list[int], powers: Sequence[tuple[int, ...]]) -> dict[int, sp.Expr] | None:
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
        # What is zero as it stands, such as cos² α + sin² α - 1, is a solution too.
        if not field.vanishes(sum(w * m for w, m in zip(weights, monomials, strict=True)) % field.p):
            return _written_out(space, trial, solution, support, powers)
    return None


def _written_out(
    space: Space, trial: Trial, solution: Values, support: list[int], powers: Sequence[tuple[int, ...]]
) -> dict[int, sp.Expr] | None:
    found = dict.fromkeys(support, sp.S.Zero)
    for place, residue in solution.items():
        number = trial.base.reconstructed(residue)
        if number is None:
            return None
        n, m = divmod(place, len(powers))
        found[support[n]] += number * sp.Mul(*(space.constants[c] for c in powers[m]))
    return found


def _rational(values: Values, trial: Trial) -> dict[int, sp.Expr] | None:
    found = {k: trial.base.reconstructed(v) for k, v in values.items()}
    return None if None in found.values() else {k: n for k, n in found.items() if n is not None}


def _values(trial: Trial, support: Sequence[int]) -> Values | None:
    """The values of the c_k in another trial, None where the functions do not have just one such combination."""
    found = trial.combinations(support)
    return found[0] if len(found) == 1 else None


def _product(values: Sequence[int], places: Sequence[int], p: int) -> int:
    result = 1
    for n in places:
        result = result * values[n] % p
    return result


def _constants(entries: Sequence[sp.Expr], slots: Slots) -> list[sp.Expr]:
    """What constants are made of: parameters, and functions and roots of them."""
    found: dict[sp.Expr, None] = {}

    def visit(e: sp.Expr) -> None:
        if e.is_number:
            return
        whole = e.is_Add or e.is_Mul or (isinstance(e, sp.Pow) and e.exp.is_Integer)
        if not whole and not moves(e, slots):
            found[e] = None
        for a in e.args:
            if isinstance(a, sp.Expr):
                visit(a)

    for e in entries:
        visit(e)
    return sorted(found, key=lambda e: (e.count_ops(), str(e)))


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
