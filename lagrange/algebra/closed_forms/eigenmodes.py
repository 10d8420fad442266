"""Small oscillations as algebra: det(K − w M) = 0, its roots w = ω², and the modes a with (K − w M) a = 0.

The matrices are square, of rational functions of the parameters; anything else in them (√2, cos α) is a letter. The
determinant is a polynomial in w and is factored; a factor of the first or second degree gives its roots in closed form,
any other is left as an equation. A mode is found in the field of the rational functions of w modulo its factor, where
zero is 0 and nothing has to be decided; the root is substituted at the end. The work is bounded by the size of the
matrices and of what is factored.

Letters have relations that such a factorization does not see: with p = √14, w² − 2 p w + 14 is (w − p)², and
sin² α and 1 − cos² α are one root. So where there are letters, common divisors of the factors and of their derivatives
are split off, and modes that are not as many as the multiplicity are sought again at the root itself.

    K = k ( 2 −1 ; −1 2 ), M = m      (k − m w)(3k − m w) = 0,  w = k/m: (1, 1),  w = 3k/m: (1, −1)

Shapes: M, K (n, n); a (n,).
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import combinations
from typing import Any

import sympy as sp
from sympy.polys.domains.domain import Domain
from sympy.polys.matrices import DomainMatrix
from sympy.polys.polyerrors import NotInvertible

from lagrange.algebra.closed_forms.limits import (
    HIGHEST_DEGREE,
    LARGEST_FACTORED,
    LARGEST_MATRIX,
    LONGEST_ROOT,
    LONGEST_SOLVED_FACTOR,
    MOST_MATRIX_ROWS,
    MOST_MATRIX_SYMBOLS,
)
from lagrange.algebra.closed_forms.polynomial_roots import square_root
from lagrange.algebra.closed_forms.shortest_form import shortest_form
from lagrange.algebra.closed_forms.signs import SignCondition, different_from_zero, sign_of
from lagrange.algebra.exact.linear_algebra import nullspace
from lagrange.algebra.exact.prime_field import InadmissibleError
from lagrange.algebra.exact.zero_test import DivisionByZeroError, is_zero
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record

Matrix = tuple[tuple[sp.Expr, ...], ...]


@record
class Frequency:
    """A root w of the characteristic equation.

    square        w = ω²; None if it is not found in closed form
    factor        the irreducible polynomial in `letter` that has this root
    multiplicity  of the root
    modes         a basis of the a with (K − w M) a = 0, each with first component 1 where it has one
    """

    square: sp.Expr | None
    factor: sp.Expr
    letter: sp.Symbol
    multiplicity: int
    modes: tuple[tuple[sp.Expr, ...], ...] = ()

    @property
    def presupposed(self) -> tuple[SignCondition, ...]:
        """The denominators of the modes, which must not vanish: y ≠ 0."""
        below = {f for mode in self.modes for a in mode for f in sp.Mul.make_args(sp.fraction(sp.together(a))[1])}
        short = sorted((f.as_base_exp()[0] for f in below if count_operations(f) <= LARGEST_FACTORED), key=str)
        return tuple(dict.fromkeys(c for f in short for c in different_from_zero(f)))


def letters_for(expressions: Iterable[sp.Expr]) -> dict[sp.Expr, sp.Symbol]:
    """A letter for each part that is no rational function of symbols: a root, a sine."""
    letters: dict[sp.Expr, sp.Symbol] = {}

    def visit(e: sp.Expr) -> None:
        if e.is_Symbol or e.is_Rational:
            return
        if e.is_Add or e.is_Mul or (e.is_Pow and e.exp.is_Integer):
            for a in e.args:
                visit(a)
            return
        letters.setdefault(e, sp.Dummy(f"part_{len(letters)}", real=True))

    for e in expressions:
        visit(e)
    return letters


def determinant(rows: Sequence[Sequence[sp.Expr]]) -> sp.Expr | None:
    """The determinant, multiplied out, up to the denominators of the rows; None: too large."""
    entries = [e for row in rows for e in row]
    symbols = {s for e in entries for s in e.free_symbols}
    if (
        len(rows) > MOST_MATRIX_ROWS
        or len(symbols) > MOST_MATRIX_SYMBOLS
        or sum(count_operations(e) for e in entries) > LARGEST_MATRIX
    ):
        return None
    letters = letters_for(entries)
    cleared = []
    for row in rows:
        parts = [sp.fraction(sp.together(e.xreplace(letters))) for e in row]
        below = sp.Integer(1)
        for _, d in parts:
            below = sp.lcm(below, d)
        cleared.append([sp.expand(n * sp.cancel(below / d)) for n, d in parts])
    # The last coefficient of the characteristic polynomial: no divisions, hence no quotients of polynomials.
    matrix = DomainMatrix.from_Matrix(sp.Matrix(cleared))
    value = matrix.domain.to_sympy(matrix.charpoly()[-1]) * (-1) ** len(rows)
    back = {v: e for e, v in letters.items()}
    return sp.expand(value).xreplace(back)


def letter_factors(polynomial: sp.Expr, letter: sp.Symbol) -> list[tuple[sp.Expr, int]]:
    """The factors that contain the letter, each with its multiplicity, the coefficient of the highest power positive.

    The polynomial as it is, where it is too large to be factored.
    """
    if count_operations(polynomial) > 2 * LARGEST_FACTORED:
        return [(polynomial, 1)]
    letters = letters_for([polynomial])
    lettered = polynomial.xreplace(letters)
    if any(p.exp.is_negative for p in lettered.atoms(sp.Pow)):  # divisors without the letter, which change no root
        lettered, below = sp.fraction(sp.together(lettered))
        if letter in below.free_symbols:
            return [(polynomial, 1)]
    _, powers = sp.factor_list(lettered)
    back = {v: e for e, v in letters.items()}
    pieces = [(f.xreplace(back), int(n)) for f, n in powers if letter in f.free_symbols]
    if letters:
        pieces = with_repeated_roots_apart(pieces, letter)
    return [(_with_positive_lead(f, letter), n) for f, n in pieces]


def _with_positive_lead(f: sp.Expr, letter: sp.Symbol) -> sp.Expr:
    first = sp.Poly(f, letter).LC()
    return -f if sign_of(first) == -1 or (sign_of(first) is None and first.could_extract_minus_sign()) else f


def closed_roots(factor: sp.Expr, letter: sp.Symbol) -> list[sp.Expr] | None:
    """Its roots, the smaller one first where that is known; None if they are not in closed form, or long."""
    parts = _parts_of_roots(factor, letter) if count_operations(factor) <= LONGEST_SOLVED_FACTOR else None
    if parts is None:
        return None
    centre, half = parts
    roots = [without_minus(centre)] if half == 0 else [_sum(centre, -half), _sum(centre, half)]
    roots = [shortest_form(r) for r in roots]
    return None if any(count_operations(r) > LONGEST_ROOT for r in roots) else roots


def _parts_of_roots(factor: sp.Expr, letter: sp.Symbol) -> tuple[sp.Expr, sp.Expr] | None:
    """p, h with the roots p ± h."""
    coefficients = sp.Poly(factor, letter).all_coeffs()
    if len(coefficients) == 2:
        a, b = coefficients
        return sp.factor(-b / a), sp.S.Zero
    if len(coefficients) != 3:
        return None
    a, b, c = coefficients
    # h is positive where its sign is known, so that p − h, the smaller root, comes first.
    half = _factored_roots(_root_of_discriminant(a, b, c)) / sp.factor(2 * a)
    return sp.factor(-b / (2 * a)), -half if sign_of(half) == -1 else half


def _root_of_discriminant(a: sp.Expr, b: sp.Expr, c: sp.Expr) -> sp.Expr:
    """√(b² − 4 a c): with the square as it is, where multiplied out it has no factor and is longer."""
    root = square_root(b**2 - 4 * a * c)
    kept = sp.factor(b) ** 2 - 4 * sp.factor(a * c)
    is_bare = root.is_Pow and root.exp == sp.S.Half and root.base.is_Add
    return sp.sqrt(kept) if is_bare and count_operations(kept) < count_operations(root.base) else root


def without_minus(e: sp.Expr) -> sp.Expr:
    """−(a − b) c as (b − a) c."""
    if e.as_coeff_Mul()[0].is_negative:
        for f in sp.Mul.make_args(e):
            base, exponent = f.as_base_exp()
            if base.is_Add and exponent.is_odd and len({term.could_extract_minus_sign() for term in base.args}) == 2:
                return sp.Mul(-1, e / f, sp.Add(*(-term for term in base.args)) ** exponent)
    return e


def _factored_roots(e: sp.Expr) -> sp.Expr:
    """√(m² + m M) as √(m (m + M)), where that is shorter."""
    rule = {p: sp.sqrt(f) for p in e.atoms(sp.Pow) if p.exp == sp.S.Half and (f := sp.factor(p.base)) != p.base}
    shorter = e.xreplace(rule)
    return shorter if count_operations(shorter) < count_operations(e) else e


def _sum(p: sp.Expr, h: sp.Expr) -> sp.Expr:
    """p + h over one denominator, common factors in front: (2 − √2) g/l."""
    if p == 0 or h == 0:
        return p + h
    return sp.factor_terms(sp.together(sp.factor_terms(sp.together(p + h))))


class Field:
    """Numbers a_0 + a_1 w + ... modulo a factor, with coefficients rational functions of the parameters.

    A `NumberField` of `linear_algebra`: exact, so that what is zero is 0.
    """

    exact = True

    def __init__(self, factor: sp.Expr, letter: sp.Symbol, entries: Iterable[sp.Expr]) -> None:
        self.letter = letter
        self.letters = letters_for([factor, *entries])
        symbols = {s for e in (factor, *entries) for s in e.xreplace(self.letters).free_symbols} - {letter}
        rationals = sp.QQ
        domain: Domain = rationals.frac_field(*sorted(symbols, key=str)) if symbols else rationals
        self.domain = domain
        self.modulus = self._poly(factor)

    def _poly(self, e: sp.Expr) -> sp.Poly:
        return sp.Poly(e.xreplace(self.letters), self.letter, domain=self.domain)

    def read(self, e: sp.Expr) -> sp.Poly:
        """A polynomial in w, or a rational function of parameters."""
        above, below = sp.fraction(sp.together(e.xreplace(self.letters)))
        number = sp.Poly(above, self.letter, domain=self.domain).rem(self.modulus)
        return self.reduce(number * self.inverse(sp.Poly(below, self.letter, domain=self.domain)))

    def number(self, numerator: int, denominator: int = 1) -> sp.Poly:
        """A rational number."""
        return sp.Poly(sp.Rational(numerator, denominator), self.letter, domain=self.domain)

    def reduce(self, x: Any) -> sp.Poly:
        """The remainder modulo the factor."""
        return x.rem(self.modulus)

    def less(self, row: Sequence[Any], factor: Any, other: Sequence[Any]) -> list[sp.Poly]:
        """row − factor · other."""
        return [self.reduce(x - factor * y) for x, y in zip(row, other, strict=True)]

    def inverse(self, x: Any) -> sp.Poly:
        """1/x. Raises NotInvertible."""
        return x.invert(self.modulus)

    def vanishes(self, x: Any) -> bool:
        """Whether x is 0."""
        return bool(x.is_zero)

    def at(self, x: sp.Poly, centre: sp.Expr, half: sp.Expr) -> sp.Expr:
        """The value at w = p + h, of a factor of degree two at most."""
        back = {v: e for e, v in self.letters.items()}
        coefficients = [c.xreplace(back) for c in reversed(x.all_coeffs())]
        constant = coefficients[0]
        slope = coefficients[1] if len(coefficients) > 1 else sp.S.Zero
        moving = sp.factor_terms(sp.together(sp.factor(slope) * half))
        return shortest_form(_sum(sp.factor(constant + slope * centre), moving))


def modes(
    mass: Matrix, stiffness: Matrix, factor: sp.Expr, letter: sp.Symbol
) -> list[tuple[tuple[sp.Expr, ...], ...]] | None:
    """For each root of `closed_roots` a basis of the a with (K − w M) a = 0; None if that did not succeed."""
    entries = [k - letter * m for ks, ms in zip(stiffness, mass, strict=True) for k, m in zip(ks, ms, strict=True)]
    parts = _parts_of_roots(factor, letter)
    if parts is None:
        return None
    size = len(mass)
    try:
        numbers = Field(factor, letter, entries)
        read = [numbers.read(e) for e in entries]
        basis = nullspace(numbers, [read[n : n + size] for n in range(0, size * size, size)], size)  # type: ignore[arg-type]
        basis = [_with_leading_one(v, numbers) for v in basis]
    except (NotInvertible, ZeroDivisionError, sp.PolynomialError):
        return None
    centre, half = parts
    halves = [half] if half == 0 else [-half, half]
    return [tuple(tuple(numbers.at(x, centre, h) for x in v) for v in basis) for h in halves]


def _are_modes(basis: Sequence[Sequence[sp.Expr]], multiplicity: int) -> bool:
    """Whether there are as many modes as the root is multiple, all finite."""
    return len(basis) == multiplicity and not any(a.has(sp.zoo, sp.nan, sp.oo) for mode in basis for a in mode)


class Expressions:
    """Expressions as the numbers of `linear_algebra`: what is zero by the exact test is 0. None of them is guessed."""

    exact = True
    random = None

    def number(self, numerator: int, denominator: int = 1) -> sp.Expr:
        """A rational number."""
        return sp.Rational(numerator, denominator)

    def reduce(self, x: sp.Expr) -> sp.Expr:
        """The expression over one denominator, or 0. Raises InadmissibleError if that is undecided."""
        return reduced_by_zero_test(x)

    def less(self, row: Sequence[sp.Expr], factor: sp.Expr, other: Sequence[sp.Expr]) -> list[sp.Expr]:
        """row − factor · other."""
        return [self.reduce(x - factor * y) for x, y in zip(row, other, strict=True)]

    def inverse(self, x: sp.Expr) -> sp.Expr:
        """1/x."""
        return 1 / x

    def vanishes(self, x: sp.Expr) -> bool:
        """Whether x is 0."""
        return bool(x == 0)

    def root(self, x: sp.Expr) -> sp.Expr:
        """√x."""
        return sp.sqrt(x)

    def sample(self) -> sp.Expr:
        """Not random: 1."""
        return sp.S.One


def modes_at(root: sp.Expr, mass: Matrix, stiffness: Matrix) -> tuple[tuple[sp.Expr, ...], ...]:
    """A basis of the a with (K − w M) a = 0 at one root w; none if that is not decided."""
    numbers = Expressions()
    rows = [[k - root * m for k, m in zip(ks, ms, strict=True)] for ks, ms in zip(stiffness, mass, strict=True)]
    try:
        basis = nullspace(numbers, rows, len(mass))
        basis = [_with_leading_one(v, numbers) for v in basis]
    except InadmissibleError:
        return ()
    return tuple(tuple(shortest_form(a) for a in v) for v in basis)


def _with_leading_one(vector: Sequence[Any], numbers: Field | Expressions) -> list[Any]:
    """The vector divided by its first component that is not zero."""
    first = next(x for x in vector if not numbers.vanishes(x))
    scale = numbers.inverse(first)
    return [numbers.reduce(x * scale) for x in vector]


def frequencies(
    mass: Matrix, stiffness: Matrix, pieces: Sequence[tuple[sp.Expr, int]], letter: sp.Symbol, with_modes: bool
) -> tuple[Frequency, ...]:
    """The roots of det(K − w M), from its factors with their multiplicities; those known to be smaller first."""
    unordered: list[Frequency] = []
    for factor, multiplicity in pieces:
        roots = closed_roots(factor, letter)
        if roots is None:
            unordered.append(Frequency(None, factor, letter, multiplicity))
            continue
        vectors = modes(mass, stiffness, factor, letter) if with_modes else None
        for n, root in enumerate(roots):
            basis = vectors[n] if vectors else ()
            if with_modes and not _are_modes(basis, multiplicity):
                basis = modes_at(root, mass, stiffness)
                basis = basis if _are_modes(basis, multiplicity) else ()
            unordered.append(Frequency(root, factor, letter, multiplicity, basis))
    return tuple(_ordered(unordered))


def _ordered(frequencies: Sequence[Frequency]) -> list[Frequency]:
    """The frequencies in ascending order where this is known; those without a closed form come last."""
    ordered: list[Frequency] = []
    for f in frequencies:
        place = len(ordered)
        while place and _is_less(f, ordered[place - 1]):
            place -= 1
        ordered.insert(place, f)
    return ordered


def _is_less(a: Frequency, b: Frequency) -> bool:
    if a.square is None or b.square is None:
        return a.square is not None
    difference = sp.expand(b.square - a.square)
    return count_operations(difference) <= LARGEST_FACTORED and sign_of(difference) == 1


# -- Multiple and common roots of polynomials whose coefficients are related: w² − 2√14 w + 14 = (w − √14)² ------------
#
# A factorization over the rational functions of the parameters takes √14, sin α and their like for letters without
# relations, and misses a factor that exists by p² = 14 only. Euclid's algorithm with the exact zero test finds it:
# the
# greatest common divisor of f and f' has the roots of f that are multiple, that of f and g those they share. Degrees
# and
# sizes are bounded, and where a coefficient is undecided, the factors stay as they are.
#
# Reference: D. Y. Y. Yun, On square-free decomposition algorithms, 1976.


Coefficients = list[sp.Expr]


def with_repeated_roots_apart(pieces: Sequence[tuple[sp.Expr, int]], letter: sp.Symbol) -> list[tuple[sp.Expr, int]]:
    """Factors with multiplicities as factors without multiple roots, no two of which have a root in common."""
    try:
        separated = [part for f, n in pieces for part in _square_free(_coefficients(f, letter), n)]
        separated = _without_common_roots(separated)
    except (InadmissibleError, DivisionByZeroError):
        return [*pieces]
    if sorted((len(f) - 1, n) for f, n in separated) == sorted((int(sp.degree(f, letter)), n) for f, n in pieces):
        return [*pieces]
    return [(_written(f, letter), n) for f, n in separated]


def reduced_by_zero_test(x: sp.Expr) -> sp.Expr:
    """An expression over one denominator; 0 if it is zero. Raises InadmissibleError if that is undecided."""
    if x == 0 or x.is_Rational:
        return x
    vanishes = is_zero(x)
    if vanishes is None:
        raise InadmissibleError
    return sp.S.Zero if vanishes else _shortened(x)


def _shortened(x: sp.Expr) -> sp.Expr:
    above, below = sp.fraction(sp.together(x))
    if count_operations(above) + count_operations(below) > LARGEST_FACTORED:
        raise InadmissibleError
    shortened: sp.Expr = sp.cancel(sp.expand(above) / sp.expand(below))
    return sp.radsimp(shortened) if not shortened.free_symbols else shortened


def _coefficients(f: sp.Expr, letter: sp.Symbol) -> Coefficients:
    """The coefficients, that of the highest power first. Raises InadmissibleError beyond the highest degree."""
    coefficients: Coefficients = sp.Poly(f, letter).all_coeffs()
    if len(coefficients) > HIGHEST_DEGREE + 1:
        raise InadmissibleError
    return coefficients


def _written(f: Coefficients, letter: sp.Symbol) -> sp.Expr:
    """The polynomial without denominators."""
    terms = (c * letter**n for n, c in enumerate(reversed(f)))
    return sp.expand(sp.fraction(sp.together(sp.Add(*terms)))[0])


def _square_free(f: Coefficients, n: int) -> list[tuple[Coefficients, int]]:
    """The factors of fⁿ without multiple roots: those that f has once, twice, ..."""
    if len(f) < 3:
        return [(f, n)]
    top = len(f) - 1
    repeated = _common_divisor(f, [c * (top - k) for k, c in enumerate(f[:-1])])
    once = _divided(f, repeated)[0]
    parts = []
    times = 1
    while len(once) > 1:
        more = _common_divisor(once, repeated)
        part = _divided(once, more)[0]
        if len(part) > 1:
            parts.append((part, n * times))
        once, repeated, times = more, _divided(repeated, more)[0], times + 1
    return parts


def _without_common_roots(pieces: list[tuple[Coefficients, int]]) -> list[tuple[Coefficients, int]]:
    """The factors with their common divisors split off as separate factors, whose multiplicities add up."""
    for (k, (f, m)), (j, (g, n)) in combinations(enumerate(pieces), 2):
        common = _common_divisor(f, g)
        if len(common) > 1:
            others = [p for i, p in enumerate(pieces) if i not in (k, j)]
            rest = [(_divided(f, common)[0], m), (_divided(g, common)[0], n), (common, m + n)]
            return _without_common_roots([*others, *(p for p in rest if len(p[0]) > 1)])
    return pieces


def _common_divisor(f: Coefficients, g: Coefficients) -> Coefficients:
    """The greatest common divisor, with leading coefficient 1; [1] for polynomials without a common root."""
    while g:
        f, g = g, _divided(f, g)[1]
    return [reduced_by_zero_test(c / f[0]) for c in f]


def _divided(f: Coefficients, g: Coefficients) -> tuple[Coefficients, Coefficients]:
    """Quotient and remainder; the remainder without leading zeros."""
    rest = [*f]
    quotient = []
    while len(rest) >= len(g):
        factor = reduced_by_zero_test(rest[0] / g[0])
        quotient.append(factor)
        padded = [*g, *[sp.S.Zero] * (len(rest) - len(g))]
        rest = [reduced_by_zero_test(a - factor * b) for a, b in zip(rest[1:], padded[1:], strict=True)]
    while rest and rest[0] == 0:
        rest = rest[1:]
    return quotient, rest
