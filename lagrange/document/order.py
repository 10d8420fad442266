"""The order of factors and of terms in which mechanics is written by hand.

Factors stand in the order of `Slot`: m r φ'^2 sin θ cos θ. Within a slot, parameters are alphabetic, Latin
before Greek; what moves keeps the declared order; functions follow their coordinate, sine before cosine.

Terms stand in the order of `Class`, each class by the declared order of the coordinates and descending
degree. A constant goes first where only functions follow (a + b cos ωt), and no sum begins with a minus
that could begin with a plus (l^2 - y^2). Terms with differentials or unit vectors keep the order of these.
"""

from __future__ import annotations

from collections.abc import Iterable
from enum import IntEnum

import sympy as sp

from lagrange.core.symbols import Dot, Inert, Partial, UnitVector, Unspecified, VectorSymbol, Wedge, counting
from lagrange.document.names import Name
from lagrange.document.notation import MOVING, Kind, Notation, Place, alphabetic
from lagrange.document.products import Factor, factors, is_negative

Key = tuple[object, ...]
Degrees = dict[Kind, dict[Place, float]]

FUNCTIONS = ("exp", "log", "sinh", "cosh", "tanh", "sin", "cos", "tan", "cot", "sec", "csc")
MASSES = frozenset({"m", "M"})
_END = ((1 << 30,),)  # after everything: x y stands before x, as a longer word after a shorter one


class Slot(IntEnum):
    """Where a factor stands."""

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


class Class(IntEnum):
    """Where a term stands."""

    ACCELERATION = 0
    VELOCITY = 1
    COORDINATE = 2
    FUNCTION = 3  # of coordinates
    CONSTANT = 4
    TIME = 5  # and functions of parameters
    FORCE = 6


_USUAL = {kind: int(kind) for kind in Class}
_CONSTANT_FIRST = _USUAL | {Class.CONSTANT: 3, Class.TIME: 4, Class.FUNCTION: 5}  # a + b cos ωt + l sin θ
_ARGUMENT = _USUAL | {Class.FUNCTION: 3, Class.TIME: 4, Class.CONSTANT: 5}  # cos(ωt + α)


class Order:
    """The sort keys of one notation. Remembers what it has seen."""

    def __init__(self, notation: Notation) -> None:
        self.notation = notation
        self._kinds: dict[sp.Basic, frozenset[Kind]] = {}
        self._signatures: dict[sp.Basic, str] = {}
        self._symbol_places: dict[sp.Basic, frozenset[Place]] = {}
        self._term_degrees: dict[sp.Expr, Degrees] = {}
        self._factor_keys: dict[tuple[Factor, bool], Key] = {}

    def kinds(self, expression: sp.Basic) -> frozenset[Kind]:
        """The kinds of symbols that occur."""
        found = self._kinds.get(expression)
        if found is None:
            if isinstance(expression, sp.Symbol):
                found = frozenset({self.notation.kind(expression)})
            else:
                found = frozenset().union(*(self.kinds(a) for a in expression.args))
            self._kinds[expression] = found
        return found

    def is_constant(self, expression: sp.Basic) -> bool:
        """Whether it is made of numbers and parameters."""
        return self.kinds(expression) <= {Kind.PARAMETER, Kind.SIGN}

    # Factors

    def factors(self, given: Iterable[Factor]) -> list[Factor]:
        """The factors of a product in the order of writing."""
        listed = list(given)
        open_ended = any(isinstance(base, sp.Function) or _is_slope(base) for base, _ in listed)
        return sorted(listed, key=lambda factor: self._factor_key(factor, open_ended))

    def _factor_key(self, factor: Factor, open_ended: bool) -> Key:
        """`open_ended`: whether there is a function, behind which a force would look like its argument."""
        key = self._factor_keys.get((factor, open_ended))
        if key is None:
            key = self._factor_keys[factor, open_ended] = self._new_factor_key(factor, open_ended)
        return key

    def _new_factor_key(self, factor: Factor, open_ended: bool) -> Key:
        base, exponent = factor
        root = exponent.is_Rational and not exponent.is_Integer
        if isinstance(base, sp.Symbol) and not (root and (exponent.q == 2 or not self.is_constant(base))):
            return self._symbol_key(base, open_ended)
        tie = (self.signature(base), self.signature(exponent))
        if isinstance(base, sp.Number):
            return (Slot.NUMBER if exponent == 1 else Slot.IRRATIONAL, 0, *tie)
        if isinstance(base, sp.NumberSymbol):
            return (Slot.IRRATIONAL, 1, *tie)
        if _is_slope(base):
            return (Slot.SLOPE, *_slope_key(base), *tie)
        if root:
            return (Slot.CONSTANTS if self.is_constant(base) else Slot.FUNCTION, 0, self._places(base), *tie)
        if isinstance(base, sp.Add):
            return (self._bracket_slot(base), -1, self._places(base), *tie)
        if isinstance(base, Wedge | Inert):
            return (Slot.WEDGE if isinstance(base, Wedge) else Slot.INERT, *tie)
        if isinstance(base, Unspecified):
            return (Slot.FUNCTION, 1, *tie)
        name = type(base).__name__
        places = self._places(base)
        which = FUNCTIONS.index(name) if name in FUNCTIONS else -1
        return (Slot.FUNCTION, 2, places[:1], len(places), places, which, *tie)

    def _bracket_slot(self, bracket: sp.Add) -> Slot:
        kinds = self.kinds(bracket)
        if kinds & {Kind.DIFFERENTIAL, Kind.VECTOR}:
            return Slot.DIFFERENTIALS
        if not self.is_constant(bracket):
            positions = kinds <= {Kind.PARAMETER, Kind.SIGN, Kind.TIME, Kind.COORDINATE}
            return Slot.COORDINATES if positions else Slot.BRACKET
        massive = all(any(_is_mass(s) for s in term.free_symbols) for term in bracket.args)
        return Slot.MASSES if massive else Slot.CONSTANTS

    def _symbol_key(self, symbol: sp.Symbol, open_ended: bool) -> Key:
        kind = self.notation.kind(symbol)
        if symbol in self.notation.frequencies:
            return (Slot.FREQUENCY, *alphabetic(symbol.name))
        if kind in MOVING:
            return (Slot[kind.name], self.notation.place(symbol.name))
        if kind is Kind.DIFFERENTIAL:
            return (Slot.DIFFERENTIAL, self.notation.place(symbol.name))
        if kind is Kind.VECTOR:
            return (Slot.VECTOR, self._vector_place(symbol))
        if kind is Kind.PARAMETER:
            friction = Name.of(symbol.name).letter == "mu"
            slot = Slot.FRICTION if friction else Slot.MASS if _is_mass(symbol) else Slot.PARAMETER
        elif kind is Kind.FORCE and open_ended:
            slot = Slot.FORCE_FIRST
        else:
            slot = Slot[kind.name]
        return (slot, *alphabetic(symbol.name))

    # Terms

    def terms(self, given: Iterable[sp.Expr], argument: bool = False) -> list[sp.Expr]:
        """The terms of a sum in the order of writing; `argument`: of a function, as in cos(ωt + α)."""
        terms = list(given)
        classes = [self._class(term) for term in terms]
        only_functions = all(c >= Class.FUNCTION for c in classes)
        order = _ARGUMENT if argument else _CONSTANT_FIRST if only_functions else _USUAL
        keys = {term: self._term_key(term, order[c]) for term, c in zip(terms, classes, strict=True)}
        terms.sort(key=keys.__getitem__)
        if all(keys[term][0] == () for term in terms):
            positive = (n for n, term in enumerate(terms) if not is_negative(term))
            terms.insert(0, terms.pop(next(positive, 0)))
        return terms

    def _class(self, term: sp.Expr) -> Class:
        kinds = self.kinds(term)
        if Kind.ACCELERATION in kinds:
            return Class.ACCELERATION
        if Kind.VELOCITY in kinds:
            return Class.VELOCITY
        if Kind.FORCE in kinds:
            return Class.FORCE
        if Kind.COORDINATE in kinds:
            return Class.COORDINATE if self._degrees(term)[Kind.COORDINATE] else Class.FUNCTION
        return Class.TIME if Kind.TIME in kinds or term.has(sp.Function) else Class.CONSTANT

    def _term_key(self, term: sp.Expr, place: int) -> Key:
        parts = [(base, e) for base, e in factors(term) if not base.is_number]
        plain = [(base, e) for base, e in parts if isinstance(base, sp.Symbol)]
        others = [(base, e) for base, e in parts if not isinstance(base, sp.Symbol)]
        constants = [(base, e) for base, e in plain if self.is_constant(base)]
        degrees = self._degrees(term)
        return (
            self._direction(base for base, _ in plain),
            place,
            _leading(degrees),
            sum(isinstance(base, sp.Add) and not self.is_constant(base) for base, _ in others),
            degrees[Kind.TIME].get(self.notation.place("t"), 0),
            not parts,  # a bare number stands last
            self._places(term),
            sum(_degree(e) for _, e in constants) if others else 0,  # sin α + μ cos α
            (*sorted((self._symbol_key(base, False), -_degree(e)) for base, e in constants), _END),
            sum(_is_rotation(base) for base, _ in others),  # R·δr + Γ·δπ
            repr(sorted((self._factor_key(factor, False) for factor in others), key=repr)),
        )

    def _direction(self, symbols: Iterable[sp.Symbol]) -> Key:
        """The differentials and unit vectors of a term: they come before all else."""
        places: list[Key] = []
        for symbol in symbols:
            if isinstance(symbol, UnitVector):
                places.append((1, self._vector_place(symbol)))
            elif self.notation.kind(symbol) is Kind.DIFFERENTIAL:
                places.append((0, self.notation.place(symbol.name)))
        return tuple(sorted(places))

    def _degrees(self, term: sp.Expr) -> Degrees:
        """How often each coordinate, velocity, ... is a factor; of a bracket, what its first term has."""
        degrees = self._term_degrees.get(term)
        if degrees is None:
            degrees = self._term_degrees[term] = self._new_degrees(term)
        return degrees

    def _new_degrees(self, term: sp.Expr) -> Degrees:
        degrees: Degrees = {kind: {} for kind in Kind}
        for base, exponent in factors(term):
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

    def _places(self, expression: sp.Basic) -> tuple[Place, ...]:
        """The places of the coordinates that occur, whatever their derivative."""
        return tuple(sorted(self._unsorted_places(expression)))

    def _unsorted_places(self, expression: sp.Basic) -> frozenset[Place]:
        found = self._symbol_places.get(expression)
        if found is None:
            if isinstance(expression, sp.Symbol):
                moves = self.notation.kind(expression) in MOVING
                found = frozenset({self.notation.place(expression.name)} if moves else ())
            else:
                found = frozenset().union(*(self._unsorted_places(a) for a in expression.args))
            self._symbol_places[expression] = found
        return found

    def _vector_place(self, symbol: sp.Symbol) -> Key:
        """i, j, k; then e_r, e_theta, ... in the order of the coordinates; then e1_B, e2_B, ..."""
        name = Name.of(symbol.name)
        if isinstance(symbol, VectorSymbol) and not isinstance(symbol, UnitVector):
            return (3, *alphabetic(symbol.name))  # M q'', whatever the problem calls M
        if name.letter == "e" and len(name.indices) == 1:
            return (1, self.notation.place(name.indices[0]))
        return (2 if name.indices else 0, self.notation.place(symbol.name))

    def signature(self, expression: sp.Basic) -> str:
        """A name for an expression that does not depend on hashes: the last resort of sorting."""
        found = self._signatures.get(expression)
        if found is None:
            parts = [self.signature(a) for a in expression.args]
            if isinstance(expression, sp.Add | sp.Mul):
                parts.sort()
            name = type(expression).__name__ if parts else counting(str(expression))
            found = self._signatures[expression] = f"{name}({','.join(parts)})" if parts else name
        return found


def _is_rotation(factor: sp.Expr) -> bool:
    """Whether it is the work of a moment, in a virtual rotation."""
    return isinstance(factor, Dot) and any(s.name.startswith("delta(pi_") for s in factor.free_symbols)


def _leading(degrees: Degrees) -> Key:
    """Descending degree, then coordinate by coordinate: of accelerations, velocities, coordinates."""
    return tuple(
        (-sum(degrees[kind].values()), *sorted((place, -n) for place, n in degrees[kind].items()), _END)
        for kind in MOVING
    )


def _degree(exponent: sp.Expr) -> float:
    return float(exponent) if exponent.is_Rational else 1.0


def _is_slope(base: sp.Expr) -> bool:
    """Whether it is a partial derivative, written before what it multiplies: λ ∂f/∂X, (∂f/∂X) x'."""
    return isinstance(base, Partial) or (isinstance(base, Unspecified) and any(base.orders))


def _slope_key(base: sp.Expr) -> Key:
    """By X before by Y."""
    return (base.name, tuple(-n for n in base.orders)) if isinstance(base, Unspecified) else ("", ())


def _is_mass(symbol: sp.Symbol) -> bool:
    return Name.of(symbol.name).letter in MASSES
