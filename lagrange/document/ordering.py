"""The order of factors and terms in which textbooks write mechanics.

SymPy sorts by its own rules, in which x'' may come after g. Textbooks write what a reader looks for first: in a sum
the accelerations, then velocities, coordinates, constants, unknown forces, l θ'' + g sin θ; in a product numbers,
masses, other parameters, then what moves, m r φ'^2 sin θ cos θ. `FactorOrder` and `TermOrder` list these classes.

Within a class of factors, parameters are alphabetic, Latin before Greek; what moves keeps the declared order;
functions follow their coordinate, sine before cosine. Within a class of terms, a higher degree comes first, then the
declared order of the coordinates. A constant comes first if only functions follow (a + b cos ωt), and a sum begins
with a plus if it can (l^2 - y^2); where it would begin with a minus, all constants, or all forces, with a plus come
first (a + b - μ h). Terms with differentials or unit vectors keep the order of these.

Nothing is multiplied out and nothing cancels; only signs are collected: -(-a - b) c is written (a + b) c. Sort keys
never depend on hashes, so that every run prints the same.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from enum import IntEnum

import sympy as sp

from lagrange.core.symbols import DotProduct, Inert, Partial, UnitVector, Unspecified, VectorSymbol, Wedge, counting
from lagrange.document.names import MOVING, Notation, SortPlace, SymbolKind, WrittenName, alphabetic

BasePower = tuple[sp.Expr, sp.Expr]  # base and exponent


@dataclass
class OrderedProduct:
    """A term split as it will be written: sign, numbers, factors above and below the fraction line.

    The numbers are positive and not 1; no exponent is negative.
    """

    negative: bool = False
    numbers: list[sp.Number] = field(default_factory=list)
    divisors: list[sp.Number] = field(default_factory=list)
    above: list[BasePower] = field(default_factory=list)
    below: list[BasePower] = field(default_factory=list)


def split_term(term: sp.Expr) -> OrderedProduct:
    """Split a term."""
    parts = OrderedProduct()
    for factor in flat(term):
        if isinstance(factor, sp.Rational | sp.Float):
            _number(factor, parts)
        elif isinstance(factor, sp.Add) and factor is not term and _all_negative(factor):
            parts.negative = not parts.negative
            parts.above.append((sp.Add(*(-a for a in factor.args)), sp.S.One))
        elif isinstance(factor, sp.Pow):
            base, exponent = factor.args
            if is_negative(exponent):
                parts.below.append((base, -exponent))
            else:
                parts.above.append((base, exponent))
        else:
            parts.above.append((factor, sp.S.One))
    return parts


def factors_with_exponents(term: sp.Expr) -> list[BasePower]:
    """All factors with their exponents, positive or negative."""
    return [part.args if isinstance(part, sp.Pow) else (part, sp.S.One) for part in flat(term)]


def flat(term: sp.Expr) -> Iterator[sp.Expr]:
    """The factors of nested products."""
    if isinstance(term, sp.Mul):
        for part in term.args:
            yield from flat(part)
    else:
        yield term


def is_negative(term: sp.Expr) -> bool:
    """Whether a term is written with a minus sign."""
    negative = False
    for factor in flat(term):
        if isinstance(factor, sp.Rational | sp.Float):
            negative ^= bool(factor < 0)
        elif isinstance(factor, sp.Add) and factor is not term and _all_negative(factor):
            negative = not negative
    return negative


def _all_negative(total: sp.Add) -> bool:
    return all(is_negative(a) for a in total.args)


def _number(number: sp.Number, parts: OrderedProduct) -> None:
    if number < 0:
        parts.negative = not parts.negative
        number = -number
    if isinstance(number, sp.Float):
        parts.numbers.append(number)
        return
    if number.p != 1:
        parts.numbers.append(sp.Integer(number.p))
    if number.q != 1:
        parts.divisors.append(sp.Integer(number.q))


SortKey = tuple[object, ...]
Degrees = dict[SymbolKind, dict[SortPlace, float]]

FUNCTIONS = ("exp", "log", "sinh", "cosh", "tanh", "sin", "cos", "tan", "cot", "sec", "csc")
MASSES = frozenset({"m", "M"})
_END = ((1 << 30,),)  # greater than any key: x y sorts before x, unlike a longer word in a dictionary


class FactorOrder(IntEnum):
    """The classes of factors, in the order of writing."""

    NUMBER = 0
    IRRATIONAL = 1  # √2, π
    SIGN = 2
    FRICTION = 3  # μ m g
    MASS = 4
    MASSES = 5  # (m_1 + m_2)
    PARAMETER = 6
    CONSTANTS = 7  # (a + b)
    FREQUENCY = 8  # ω t
    TIME = 9
    FORCE_FIRST = 10  # λ cos θ, λ ∂f/∂x
    SLOPE = 11  # ∂f/∂x
    COORDINATE = 12
    COORDINATES = 13  # (x_2 - x_1)
    VELOCITY = 14
    ACCELERATION = 15
    FUNCTION = 16
    BRACKET = 17  # (y'' - g)
    FORCE = 18  # 2 x λ
    INERT = 19
    DIFFERENTIAL = 20
    DIFFERENTIALS = 21  # (x dx + y dy)
    WEDGE = 22
    VECTOR = 23


class TermOrder(IntEnum):
    """The classes of terms, in the order of writing."""

    ACCELERATION = 0
    VELOCITY = 1
    COORDINATE = 2
    FUNCTION = 3  # of coordinates
    CONSTANT = 4
    TIME = 5  # and functions of parameters
    FORCE = 6


_USUAL = {kind: int(kind) for kind in TermOrder}
_CONSTANT_FIRST = _USUAL | {TermOrder.CONSTANT: 3, TermOrder.TIME: 4, TermOrder.FUNCTION: 5}  # a + b cos ωt + l sin θ
_ARGUMENT = _USUAL | {TermOrder.FUNCTION: 3, TermOrder.TIME: 4, TermOrder.CONSTANT: 5}  # cos(ωt + α)


class WritingOrder:
    """The sort keys of one notation, with a cache."""

    def __init__(self, notation: Notation) -> None:
        self.notation = notation
        self._kinds: dict[sp.Basic, frozenset[SymbolKind]] = {}
        self._signatures: dict[sp.Basic, str] = {}
        self._symbol_places: dict[sp.Basic, frozenset[SortPlace]] = {}
        self._term_degrees: dict[sp.Expr, Degrees] = {}
        self._factor_keys: dict[tuple[BasePower, bool], SortKey] = {}

    def kinds(self, expression: sp.Basic) -> frozenset[SymbolKind]:
        """The kinds of symbols that occur."""
        kinds = self._kinds.get(expression)
        if kinds is None:
            if isinstance(expression, sp.Symbol):
                kinds = frozenset({self.notation.kind(expression)})
            else:
                kinds = frozenset().union(*(self.kinds(a) for a in expression.args))
            self._kinds[expression] = kinds
        return kinds

    def is_constant(self, expression: sp.Basic) -> bool:
        """Whether it contains only numbers and parameters."""
        return self.kinds(expression) <= {SymbolKind.PARAMETER, SymbolKind.SIGN}

    # Factors

    def factors(self, given: Iterable[BasePower]) -> list[BasePower]:
        """The factors of a product in the order of writing."""
        listed = list(given)
        open_ended = any(isinstance(base, sp.Function) or _is_slope(base) for base, _ in listed)
        return sorted(listed, key=lambda factor: self._factor_key(factor, open_ended))

    def _factor_key(self, factor: BasePower, open_ended: bool) -> SortKey:
        """`open_ended`: whether the product has a function; a force after it would look like its argument: cos θ λ."""
        key = self._factor_keys.get((factor, open_ended))
        if key is None:
            key = self._factor_keys[factor, open_ended] = self._new_factor_key(factor, open_ended)
        return key

    def _new_factor_key(self, factor: BasePower, open_ended: bool) -> SortKey:
        base, exponent = factor
        root = exponent.is_Rational and not exponent.is_Integer
        if isinstance(base, sp.Symbol) and not (root and (exponent.q == 2 or not self.is_constant(base))):
            return self._symbol_key(base, open_ended)
        tie = (self.signature(base), self.signature(exponent))
        if isinstance(base, sp.Number):
            return (FactorOrder.NUMBER if exponent == 1 else FactorOrder.IRRATIONAL, 0, *tie)
        if isinstance(base, sp.NumberSymbol):
            return (FactorOrder.IRRATIONAL, 1, *tie)
        if _is_slope(base):
            return (FactorOrder.SLOPE, *_slope_key(base), *tie)
        if root:
            return (
                FactorOrder.CONSTANTS if self.is_constant(base) else FactorOrder.FUNCTION,
                0,
                self._places(base),
                *tie,
            )
        if isinstance(base, sp.Add):
            return (self._bracket_slot(base), -1, self._places(base), *tie)
        if isinstance(base, Wedge | Inert):
            return (FactorOrder.WEDGE if isinstance(base, Wedge) else FactorOrder.INERT, *tie)
        if isinstance(base, Unspecified):
            return (FactorOrder.FUNCTION, 1, *tie)
        name = type(base).__name__
        places = self._places(base)
        which = FUNCTIONS.index(name) if name in FUNCTIONS else -1
        return (FactorOrder.FUNCTION, 2, places[:1], len(places), places, which, *tie)

    def _bracket_slot(self, bracket: sp.Add) -> FactorOrder:
        kinds = self.kinds(bracket)
        if kinds & {SymbolKind.DIFFERENTIAL, SymbolKind.VECTOR}:
            return FactorOrder.DIFFERENTIALS
        if not self.is_constant(bracket):
            positions = kinds <= {SymbolKind.PARAMETER, SymbolKind.SIGN, SymbolKind.TIME, SymbolKind.COORDINATE}
            return FactorOrder.COORDINATES if positions else FactorOrder.BRACKET
        massive = all(any(_is_mass(s) for s in term.free_symbols) for term in bracket.args)
        return FactorOrder.MASSES if massive else FactorOrder.CONSTANTS

    def _symbol_key(self, symbol: sp.Symbol, open_ended: bool) -> SortKey:
        kind = self.notation.kind(symbol)
        if symbol in self.notation.frequencies:
            return (FactorOrder.FREQUENCY, *alphabetic(symbol.name))
        if kind in MOVING:
            return (FactorOrder[kind.name], self.notation.place(symbol.name))
        if kind is SymbolKind.DIFFERENTIAL:
            return (FactorOrder.DIFFERENTIAL, self.notation.place(symbol.name))
        if kind is SymbolKind.VECTOR:
            return (FactorOrder.VECTOR, self._vector_place(symbol))
        if kind is SymbolKind.PARAMETER:
            friction = WrittenName.of(symbol.name).letter == "mu"
            slot = FactorOrder.FRICTION if friction else FactorOrder.MASS if _is_mass(symbol) else FactorOrder.PARAMETER
        elif kind is SymbolKind.FORCE and open_ended:
            slot = FactorOrder.FORCE_FIRST
        else:
            slot = FactorOrder[kind.name]
        return (slot, *alphabetic(symbol.name))

    # Terms

    def terms(self, given: Iterable[sp.Expr], argument: bool = False) -> list[sp.Expr]:
        """The terms of a sum in the order of writing; `argument`: of a function, as in cos(ωt + α)."""
        terms = list(given)
        classes = [self._class(term) for term in terms]
        only_functions = all(c >= TermOrder.FUNCTION for c in classes)
        order = _ARGUMENT if argument else _CONSTANT_FIRST if only_functions else _USUAL
        keys = {term: self._term_key(term, order[c]) for term, c in zip(terms, classes, strict=True)}
        terms.sort(key=keys.__getitem__)
        # A sum begins with a plus if it can, unless differentials or unit vectors fix the order.
        if all(keys[term][0] == () for term in terms):
            first = next((term for term in terms if not is_negative(term)), None)
            if first is not None and first is not terms[0]:
                forces = self._class(first) is TermOrder.FORCE
                plain = not any(a.has(sp.Function) or _has_root(a) for a in terms)
                together = forces or (plain and all(map(self.is_constant, terms)))  # N_A + N_B - m g, a + b - μ h
                front = [term for term in terms if not is_negative(term)] if together else [first]
                terms = [*front, *(term for term in terms if term not in front)]
        return terms

    def _class(self, term: sp.Expr) -> TermOrder:
        kinds = self.kinds(term)
        if SymbolKind.ACCELERATION in kinds:
            return TermOrder.ACCELERATION
        if SymbolKind.VELOCITY in kinds:
            return TermOrder.VELOCITY
        if SymbolKind.FORCE in kinds:
            return TermOrder.FORCE
        if SymbolKind.COORDINATE in kinds:
            return TermOrder.COORDINATE if self._degrees(term)[SymbolKind.COORDINATE] else TermOrder.FUNCTION
        return TermOrder.TIME if SymbolKind.TIME in kinds or term.has(sp.Function) else TermOrder.CONSTANT

    def _term_key(self, term: sp.Expr, place: int) -> SortKey:
        parts = [(base, e) for base, e in factors_with_exponents(term) if not base.is_number]
        plain = [(base, e) for base, e in parts if isinstance(base, sp.Symbol)]
        others = [(base, e) for base, e in parts if not isinstance(base, sp.Symbol)]
        constants = [(base, e) for base, e in plain if self.is_constant(base)]
        degrees = self._degrees(term)
        # Most significant first; each entry decides only between terms that agree in all before it.
        return (
            self._direction(base for base, _ in plain),
            place,
            _leading(degrees),
            sum(
                isinstance(base, sp.Add) and not self.is_constant(base) for base, _ in others
            ),  # terms without brackets first
            degrees[SymbolKind.TIME].get(self.notation.place("t"), 0),
            not parts,  # a bare number is last
            any(base.is_Add and e.is_Rational and not e.is_Integer for base, e in parts),  # (M + m) g - √(...)
            self._places(term),
            sum(_degree(e) for _, e in constants) if others else 0,  # sin α + μ cos α
            (*sorted((self._symbol_key(base, False), -_degree(e)) for base, e in constants), _END),
            sum(_is_rotation(base) for base, _ in others),  # R·δr + Γ·δπ
            # Keys of functions differ in shape and cannot be compared; their text can, and is the same in every run.
            repr(sorted((self._factor_key(factor, False) for factor in others), key=repr)),
        )

    def _direction(self, symbols: Iterable[sp.Symbol]) -> SortKey:
        """The differentials and unit vectors of a term: they come before all else."""
        places: list[SortKey] = []
        for symbol in symbols:
            if isinstance(symbol, UnitVector):
                places.append((1, self._vector_place(symbol)))
            elif self.notation.kind(symbol) is SymbolKind.DIFFERENTIAL:
                places.append((0, self.notation.place(symbol.name)))
        return tuple(sorted(places))

    def _degrees(self, term: sp.Expr) -> Degrees:
        """The degree in each coordinate, velocity, ...; a bracket counts with its leading term."""
        degrees = self._term_degrees.get(term)
        if degrees is None:
            degrees = self._term_degrees[term] = self._new_degrees(term)
        return degrees

    def _new_degrees(self, term: sp.Expr) -> Degrees:
        degrees: Degrees = {kind: {} for kind in SymbolKind}
        for base, exponent in factors_with_exponents(term):
            if isinstance(base, sp.Symbol):
                inner: Degrees = {self.notation.kind(base): {self.notation.place(base.name): 1}}
            elif isinstance(base, sp.Add):
                inner = min((self._degrees(a) for a in base.args), key=_leading)
            else:
                continue
            for kind, counts in inner.items():
                for place, n in counts.items():
                    degrees[kind][place] = degrees[kind].get(place, 0) + n * _degree(exponent)
        return degrees

    def _places(self, expression: sp.Basic) -> tuple[SortPlace, ...]:
        """The places of the coordinates that occur, in themselves or in their derivatives."""
        return tuple(sorted(self._unsorted_places(expression)))

    def _unsorted_places(self, expression: sp.Basic) -> frozenset[SortPlace]:
        places = self._symbol_places.get(expression)
        if places is None:
            if isinstance(expression, sp.Symbol):
                moves = self.notation.kind(expression) in MOVING
                places = frozenset({self.notation.place(expression.name)} if moves else ())
            else:
                places = frozenset().union(*(self._unsorted_places(a) for a in expression.args))
            self._symbol_places[expression] = places
        return places

    def _vector_place(self, symbol: sp.Symbol) -> SortKey:
        """i, j, k; then e_r, e_theta, ... as the coordinates; then e1_B, e2_B, ...; then those of `let` as declared."""
        name = WrittenName.of(symbol.name)
        if symbol.name in self.notation.directions:
            return (3, "", (self.notation.directions.index(symbol.name),))
        if isinstance(symbol, VectorSymbol) and not isinstance(symbol, UnitVector):
            return (3, *alphabetic(symbol.name))  # M q'', whatever the problem calls M
        if name.letter == "e" and len(name.indices) == 1:
            return (1, self.notation.place(name.indices[0]))
        return (2 if name.indices else 0, self.notation.place(symbol.name))

    def signature(self, expression: sp.Basic) -> str:
        """A text that represents an expression independently of hashes, for deciding ties."""
        signature = self._signatures.get(expression)
        if signature is None:
            parts = [self.signature(a) for a in expression.args]
            if isinstance(expression, sp.Add | sp.Mul):
                parts.sort()
            name = type(expression).__name__ if parts else counting(str(expression))
            signature = self._signatures[expression] = f"{name}({','.join(parts)})" if parts else name
        return signature


def _is_rotation(factor: sp.Expr) -> bool:
    """Whether it is the work of a moment, in a virtual rotation."""
    return isinstance(factor, DotProduct) and any(s.name.startswith("delta(pi_") for s in factor.free_symbols)


def _leading(degrees: Degrees) -> SortKey:
    """Descending degree, then coordinate by coordinate: of accelerations, velocities, coordinates."""
    return tuple(
        (-sum(degrees[kind].values()), *sorted((place, -n) for place, n in degrees[kind].items()), _END)
        for kind in MOVING
    )


def _degree(exponent: sp.Expr) -> float:
    return float(exponent) if exponent.is_Rational else 1.0


def _has_root(term: sp.Expr) -> bool:
    return any(p.exp.is_Rational and not p.exp.is_Integer for p in term.atoms(sp.Pow))


def _is_slope(base: sp.Expr) -> bool:
    """Whether it is a partial derivative, which comes before velocities and after forces: λ ∂f/∂X, (∂f/∂X) x'."""
    return isinstance(base, Partial) or (isinstance(base, Unspecified) and any(base.orders))


def _slope_key(base: sp.Expr) -> SortKey:
    """Derivatives by X before those by Y."""
    return (base.name, tuple(-n for n in base.orders)) if isinstance(base, Unspecified) else ("", ())


def _is_mass(symbol: sp.Symbol) -> bool:
    return WrittenName.of(symbol.name).letter in MASSES
