"""Linear equations A x = b with symbolic coefficients, solved within bounds.

Gauss–Jordan elimination; the pivot is always the entry that is cheapest to divide by: a number, then what cannot
vanish, such as a mass, then short expressions in sparse rows. Every entry is brought to its textbook form as it arises.
A pivot is not zero at generic points of the constraint surface. The computation is abandoned where an entry grows
beyond `MOST_ENTRY_OPERATIONS`: a result that fills pages is of no use.

With a constant block M, as the masses in M y + B x = h, A y + C x = c, the other unknowns come first, from
(C − A M⁻¹ B) x = c − A M⁻¹ h; one or two of them by Cramer's rule in the ring of Fourier sums.

Shapes: A (m, n), b (m,), x (n,).

Quotients of Fourier sums in lowest terms.

With u = tan(θ/2) a Fourier sum is a polynomial in u over a power of 1 + u²:

    cos θ = (1 − u²)/(1 + u²) ,    sin θ = 2u/(1 + u²) ,

so that the greatest common divisor of two sums is one of polynomials with whole coefficients. The cofactors are
translated back by u²/(1 + u²) = ½ (1 − cos θ), u/(1 + u²) = ½ sin θ and 1/(1 + u²) = ½ (1 + cos θ). SymPy's `cancel`
treats sin θ and cos θ as independent and does not see that C + m R² − m R² sin²θ divides by C + m R² cos²θ.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any, Protocol

import sympy as sp

from lagrange.algebra.fourier.division import exact_quotient
from lagrange.algebra.fourier.elements import Basis, Element
from lagrange.algebra.fourier.limits import (
    HIGHEST_HALF_ANGLE,
    LONGEST_CANCELLED,
    MOST_BY_DETERMINANTS,
    MOST_CANCELLED,
    MOST_COUPLED,
    MOST_ENTRY_OPERATIONS,
    MOST_HALF_ANGLE_TERMS,
    MOST_QUOTIENT_OPERATIONS,
    MOST_WORK,
    MULTIPLIED_IN_A_UNIT,
)
from lagrange.algebra.fourier.polynomials import lowest, pack, polynomials_in, unpack
from lagrange.algebra.fourier.ring import FourierRing
from lagrange.algebra.fourier.terms import PowerProduct, common_factor
from lagrange.algebra.fourier.textbook_form import Textbook, textbook_form
from lagrange.core.effort import remembered, spend
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record

Tidy = Callable[[sp.Expr], sp.Expr]


class Decides(Protocol):
    """Anything that decides whether an expression is zero, such as `zero_test.Surface`."""

    def is_zero(self, expression: sp.Expr) -> bool | None:
        """Whether an expression is zero; None: undecided."""


class TooLargeError(Exception):
    """The equations are beyond `MOST_ENTRY_OPERATIONS` or `MOST_WORK`."""


class _Bounded:
    """Tidies entries, and counts what that takes. Raises TooLargeError."""

    def __init__(self, tidy: Tidy) -> None:
        self.tidy = tidy
        self.work = 0

    def __call__(self, entry: sp.Expr) -> sp.Expr:
        operations = count_operations(entry)
        self.work += operations
        if operations > MOST_ENTRY_OPERATIONS or self.work > MOST_WORK:
            raise TooLargeError
        return self.tidy(entry)


def solved_linear(
    rows: Sequence[Sequence[sp.Expr]], right: Sequence[sp.Expr], surface: Decides, tidy: Tidy | None = None
) -> list[sp.Expr | None] | None:
    """The x with A x = b. An entry of x is None if the equations do not determine it; None if they are too large.

    The equations must not contradict one another.
    """
    tidied = _Bounded(tidy or tidy_quotient)
    x: list[sp.Expr | None] = [None] * (len(rows[0]) if rows else 0)
    try:
        work = [[tidied(e) for e in row] for row in rows]
        for block in _blocks(work):
            part = [[*(work[r][c] for c in block.columns), tidied(right[r])] for r in block.rows]
            width = len(block.columns)
            for r, c in _reduce(part, width, surface, tidied).items():
                if all(part[r][k] == 0 for k in range(width) if k != c):
                    x[block.columns[c]] = part[r][width]
    except TooLargeError:
        return None
    return x


@record
class _Block:
    """Equations that have unknowns in common, and all of these unknowns."""

    rows: tuple[int, ...]
    columns: tuple[int, ...]


def _blocks(rows: Sequence[Sequence[sp.Expr]]) -> list[_Block]:
    """Equations that can be solved apart from the others: those of each particle, where nothing ties them."""
    tied: list[tuple[set[int], set[int]]] = []
    for r, row in enumerate(rows):
        columns = {c for c, e in enumerate(row) if e != 0}
        together = [t for t in tied if not t[1].isdisjoint(columns)]
        tied = [t for t in tied if t[1].isdisjoint(columns)]
        tied.append(({r}.union(*(t[0] for t in together)), columns.union(*(t[1] for t in together))))
    return [_Block(tuple(sorted(r)), tuple(sorted(c))) for r, c in tied if c]


def solved_in_blocks(
    rows: Sequence[Sequence[sp.Expr]],
    right: Sequence[sp.Expr],
    size: int,
    surface: Decides,
    tidy: Tidy,
    constant: Callable[[sp.Expr], bool],
    leading: bool,
) -> list[sp.Expr | None] | None:
    """As `solved_linear`, where the first `size` equations have a constant block M in the first `size` unknowns,

        M y + B x = h ,   A y + C x = c ,     that is   (C − A M⁻¹ B) x = c − A M⁻¹ h ,   y = M⁻¹ (h − B x) .

    constant  whether an entry is constant
    leading   whether y is needed too; else it is None

    Far fewer entries arise than by elimination of all unknowns. Where M is not constant, `solved_linear` is used.
    """
    # A constant M, diagonal for particles in Cartesian coordinates, costs next to nothing to invert, and what remains
    # has one row a constraint. Elimination of all unknowns at once would spread the angles of A and B over every row.
    block = [list(row[:size]) for row in rows[:size]]
    inverse = _inverse(block, surface) if all(constant(e) for row in block for e in row) else None
    if not inverse:
        return solved_linear(rows, right, surface, tidy)
    width = len(rows[0]) - size
    if 0 < width <= MOST_BY_DETERMINANTS and len(rows) == size + width and not leading and tidy is tidy_quotient:
        return _by_determinants(rows, right, inverse, surface)
    others = [[*row[size:], b] for row, b in zip(rows[:size], right, strict=False)]
    tidied = _Bounded(tidy)
    try:
        moved = [[tidied(_dot(row, column)) for column in zip(*others, strict=True)] for row in inverse]
        columns = list(zip(*moved, strict=True))
        lower = [(*row[size:], b) for row, b in zip(rows[size:], right[size:], strict=True)]
        left = [
            [e - _dot(row[:size], column) for e, column in zip(entries, columns, strict=True)]
            for row, entries in zip(rows[size:], lower, strict=True)
        ]
        # Counted before the entries are tidied, which is what takes the time.
        if _most_coupled([row[:-1] for row in left], constant, surface) > MOST_COUPLED:
            return None
        reduced = [[tidied(e) for e in row] for row in left]
    except TooLargeError:
        return None
    x = solved_linear([row[:-1] for row in reduced], [row[-1] for row in reduced], surface, tidy)
    if x is None:
        return None
    return [*(_leading(row, x, tidied) if leading else None for row in moved), *x]


def _most_coupled(rows: Sequence[Sequence[sp.Expr]], constant: Callable[[sp.Expr], bool], surface: Decides) -> int:
    """The number of unknowns in the largest set that rows with entries that vary tie together."""
    sets: list[set[int]] = []
    for row in rows:
        tied = {c for c, e in enumerate(row) if e != 0 and surface.is_zero(e) is not True}
        if all(constant(row[c]) for c in tied):
            continue
        apart = [s for s in sets if s.isdisjoint(tied)]
        sets = [*apart, tied.union(*(s for s in sets if s not in apart))]
    return max(map(len, sets), default=0)


def _by_determinants(
    rows: Sequence[Sequence[sp.Expr]],
    right: Sequence[sp.Expr],
    inverse: Sequence[Sequence[sp.Expr]],
    surface: Decides,
) -> list[sp.Expr | None] | None:
    """One or two x by Cramer's rule in the ring of Fourier sums, y being None. None if the determinant is zero."""
    size = len(inverse)
    if sum(count_operations(e) for row in rows for e in row) + sum(count_operations(b) for b in right) > MOST_WORK:
        return None
    # In the ring nothing has to be tidied on the way: a tenth of the time of an elimination with quotients.
    ring = FourierRing()
    read = ring.from_sympy
    others = [[read(e) for e in (*row[size:], b)] for row, b in zip(rows[:size], right, strict=False)]
    moved = [[ring.dot([read(e) for e in row], column) for column in zip(*others, strict=True)] for row in inverse]
    reduced = [
        [
            read(e) - ring.dot([read(a) for a in row[:size]], column)
            for e, column in zip((*row[size:], b), zip(*moved, strict=True), strict=True)
        ]
        for row, b in zip(rows[size:], right[size:], strict=True)
    ]
    if len(reduced) == 1:
        [(determinant, p)] = reduced
        numerators = [p]
    else:
        (a, b, p), (c, d, q) = reduced
        determinant, numerators = a * d - b * c, [p * d - b * q, a * q - p * c]
    textbook = Textbook(ring)
    below = textbook.form(determinant)
    if surface.is_zero(below) is not False and not below.is_nonzero:
        return None
    return [*([None] * size), *(_quotient(n, determinant, textbook) for n in numerators)]


def _quotient(numerator: Element, denominator: Element, textbook: Textbook) -> sp.Expr:
    """A quotient without common factors of the terms; a polynomial where the denominator divides."""
    exact = exact_quotient(numerator, denominator)
    if exact is not None:
        return textbook.form(exact)
    reduced = lowest_terms(numerator, denominator)
    if reduced is not None:
        numerator, denominator = reduced
    written = one_quotient(numerator, denominator, textbook)
    if written is not None:
        return written
    below = textbook.form(denominator)
    above = textbook.form(numerator)
    if above == 0:
        return sp.S.Zero
    over, under = common_factor(above), common_factor(below)
    rest = over.divide(above) / under.divide(below)
    return textbook_form(over.expression / under.expression * rest)


def _leading(row: Sequence[sp.Expr], x_found: Sequence[sp.Expr | None], tidied: Tidy) -> sp.Expr | None:
    """b − Σ row_j x_j; None if an x_j that it needs is open, or it is too large."""
    total = row[-1]
    for e, x in zip(row, x_found, strict=False):
        if e != 0:
            if x is None:
                return None
            total = total - e * x
    try:
        return tidied(total)
    except TooLargeError:
        return None


def _inverse(matrix: Sequence[Sequence[sp.Expr]], surface: Decides) -> list[list[sp.Expr]] | None:
    """M⁻¹ of a constant matrix, block by block; None if it is singular or large."""
    inverse = [[sp.S.Zero] * len(matrix) for _ in matrix]
    tidied = _Bounded(tidy_quotient)
    blocks = _blocks(matrix)
    if any(len(b.rows) != len(b.columns) for b in blocks) or sum(len(b.rows) for b in blocks) < len(matrix):
        return None
    for block in blocks:
        size = len(block.rows)
        work = [[*(matrix[r][c] for c in block.columns), *(sp.Integer(k == r) for k in block.rows)] for r in block.rows]
        try:
            pivot_of = _reduce(work, size, surface, tidied)
        except TooLargeError:
            return None
        if len(pivot_of) < size:
            return None
        for r, c in pivot_of.items():
            for k, e in zip(block.rows, work[r][size:], strict=True):
                inverse[block.columns[c]][k] = e
    return inverse


def _dot(row: Sequence[sp.Expr], column: Sequence[sp.Expr]) -> sp.Expr:
    return sp.Add(*(a * b for a, b in zip(row, column, strict=True) if a != 0 and b != 0))


def tidy_quotient(entry: sp.Expr) -> sp.Expr:
    """A quotient in lowest terms, in textbook form."""
    if entry.is_number or entry.is_Symbol:
        return entry
    formed = textbook_form(entry)
    if count_operations(formed) > MOST_CANCELLED or formed.is_polynomial() or _is_reduced(formed):
        return formed
    return in_lowest_terms(textbook_form(sp.cancel(formed)))


def shorter_product(e: sp.Expr) -> sp.Expr:
    """The textbook form, or a product as it stands where that is shorter: x (2r² − a²)/(a² r), not x (2r²/a² − 1)/r."""
    formed = textbook_form(e)
    return e if e.is_Mul and count_operations(e) < count_operations(formed) else formed


def _is_reduced(formed: sp.Expr) -> bool:
    """Whether nothing can cancel that textbook form does not cancel itself: only powers of symbols are divided by."""
    return all(p.exp.is_Integer and (p.exp > 0 or p.base.is_Symbol) for p in formed.atoms(sp.Pow))


def _reduce(work: list[list[sp.Expr]], width: int, surface: Decides, tidy: Tidy) -> dict[int, int]:
    """Reduces the rows [A | b] in place; the column of the pivot of each row that has one."""
    pivot_of: dict[int, int] = {}
    while True:
        place = _pivot(work, width, pivot_of, surface)
        if place is None:
            return pivot_of
        r, c = place
        pivot = work[r][c]
        work[r] = [sp.S.One if k == c else tidy(e / pivot) if e != 0 else e for k, e in enumerate(work[r])]
        for other, row in enumerate(work):
            factor = row[c]
            if other != r and factor != 0:
                work[other] = [
                    sp.S.Zero if k == c else tidy(a - factor * b) if b != 0 else a
                    for k, (a, b) in enumerate(zip(row, work[r], strict=True))
                ]
        pivot_of[r] = c


def _pivot(
    work: Sequence[Sequence[sp.Expr]], width: int, pivot_of: dict[int, int], surface: Decides
) -> tuple[int, int] | None:
    """The place of the next pivot; None where only zeros are left."""
    rows = [r for r in range(len(work)) if r not in pivot_of]
    columns = [c for c in range(width) if c not in pivot_of.values()]
    ranked = []
    for r in rows:
        filled = sum(work[r][c] != 0 for c in columns)
        for c in columns:
            entry = work[r][c]
            if entry != 0:
                # Markowitz: a pivot fills in at most (entries in its row − 1)(entries in its column − 1) places.
                below = sum(work[k][c] != 0 for k in rows)
                cheap = 0 if entry.is_number else 1 if entry.is_nonzero else 2
                ranked.append((cheap, (filled - 1) * (below - 1), count_operations(entry), r, c))
    for *_, r, c in sorted(ranked):
        if work[r][c].is_nonzero or surface.is_zero(work[r][c]) is False:
            return r, c
    return None


# Fractions


def lowest_terms(numerator: Element, denominator: Element) -> tuple[Element, Element] | None:
    """Two elements with the same quotient and nothing in common; None if nothing is, or they are too long."""
    if not numerator or max(len(numerator), len(denominator)) > LONGEST_CANCELLED:
        return None
    # Without the monomials no negative power is left for the polynomials; they are put back at the end.
    low = [lowest(m for m, _ in e.terms) for e in (numerator, denominator)]
    pair = [e.over_monomial(m) for e, m in zip((numerator, denominator), low, strict=True)]
    tangents = _HalfAngles(pair)
    if max(tangents.highest, default=0) > HIGHEST_HALF_ANGLE:
        return None
    left = [tangents.polynomial(e) for e in pair]
    if max(map(len, left)) > MOST_HALF_ANGLE_TERMS:
        return None
    common, *left = left[0].cofactors(left[1])
    if common.is_ground and not tangents.is_lower(left):
        return None
    above, below = tangents.elements(left)
    number = Fraction(pair[1].denominator, pair[0].denominator)
    return (above * number).over_monomial(-low[0]), below.over_monomial(-low[1])


def in_lowest_terms(value: sp.Expr) -> sp.Expr:
    """A quotient, in textbook form, without common factors that only show by sin² + cos² = 1; the value itself where
    there are none, or where the result were no shorter.
    """
    if not any(e.has(sp.sin, sp.cos) for e in _denominators(value)):
        return value
    ring = FourierRing()
    above, below = _fraction(value, ring)
    reduced = None if below is None else lowest_terms(above, below)
    if reduced is None:
        return value
    textbook = Textbook(ring)
    n, d = (textbook.form(e) for e in reduced)
    shorter: sp.Expr = textbook.form(ring.from_sympy(n) / ring.from_sympy(d))
    return shorter if count_operations(shorter) < count_operations(value) else value


def as_one_quotient(value: sp.Expr) -> sp.Expr:
    """A value with sums below the line as one quotient of two sums; itself where that were no shorter."""
    if not _denominators(value) or value in remembered().get(one_quotient, ()):
        return value
    ring = FourierRing()
    above, below = _fraction(value, ring)
    if below is None:
        return value
    reduced = lowest_terms(above, below)
    shorter = _written(*(reduced or (above, below)), Textbook(ring), turn=reduced is None)
    return shorter if count_operations(shorter) < count_operations(value) else value


def one_quotient(above: Element, below: Element, textbook: Textbook) -> sp.Expr | None:
    """Two elements that have nothing in common as one quotient of two sums, where there are several velocities above.

    None where their coefficients, each over the denominator, may be shorter. As long as the allowance lasts,
    `as_one_quotient` knows that it is one.
    """
    coefficients = textbook.coefficients(above)
    if len(coefficients) < 2 or not _are_without_roots((above, below)):
        return None
    low = lowest(m for e in (above, below) for m, _ in e.terms)
    above, below = above.over_monomial(low), below.over_monomial(low)
    sums = [f for f in textbook.product(below).factors if f.is_Add]
    if len(sums) != 1 or any(exact_quotient(c, below) for c in coefficients):
        return None
    written = _written(above, below, textbook, turn=True)
    if count_operations(written) > MOST_QUOTIENT_OPERATIONS:
        return None
    remembered().setdefault(one_quotient, set()).add(written)
    return written


def _written(above: Element, below: Element, textbook: Textbook, turn: bool) -> sp.Expr:
    numerator = textbook.form(above)
    factor = common_factor(numerator)
    rest = factor.divide(numerator)
    terms = sp.Add.make_args(rest)
    sign = -1 if all(term.could_extract_minus_sign() for term in terms) else 1
    denominator = textbook.product(below)
    if turn:
        denominator = _with_its_sign(denominator)
    front = PowerProduct(sign * Fraction(factor.number.p, factor.number.q), dict(factor.powers)) / denominator
    return front.to_sympy() * sp.Add(*(sign * term for term in terms))


def _with_its_sign(product: PowerProduct) -> PowerProduct:
    """−(a − b − c) as b + c − a: a determinant has the sign that it came with, which often is that of its value."""
    turned = next((f for f, e in product.factors.items() if f.is_Add and e == 1), None)
    if product.number > 0 or turned is None:
        return product
    factors = {sp.Add(*(-term for term in f.args)) if f is turned else f: e for f, e in product.factors.items()}
    return PowerProduct(-product.number, factors)


def _fraction(value: sp.Expr, ring: FourierRing) -> tuple[Element, Element | None]:
    """Numerator and denominator as elements; the latter None if there are roots, or they are too long."""
    if count_operations(value) > MOST_QUOTIENT_OPERATIONS:
        return ring.zero, None
    above, below = (ring.from_sympy(e) for e in sp.fraction(sp.together(value)))
    return above, below if below and _are_without_roots((above, below)) else None


def _are_without_roots(elements: Sequence[Element]) -> bool:
    """Whether elements of one ring divide by nothing but symbols."""
    related = elements[0].basis.related
    return all(e > 0 for element in elements for m, _ in element.terms for i, e in unpack(m) if i in related)


def is_quotient_of_sums(value: sp.Expr) -> bool:
    """Whether there is a sum below its line."""
    return value.is_Mul and any(f.is_Pow and f.base.is_Add and f.exp.is_negative for f in value.args)


def _denominators(value: sp.Expr) -> list[sp.Expr]:
    """The sums that are divided by."""
    return [p.base for p in value.atoms(sp.Pow) if p.exp.is_negative and p.base.is_Add]


class _HalfAngles:
    """The generators of some elements and the tangents u of half their angles, as variables of polynomials."""

    def __init__(self, elements: list[Element]) -> None:
        keys = [key for e in elements for key in e.terms]
        self._basis: Basis = elements[0].basis
        self._generators = sorted({i for m, _ in keys for i, _ in unpack(m)})
        self._angles = sorted({i for _, w in keys for i, _ in unpack(w)})
        self.highest = [max(abs(self._turns(w)[k]) for _, w in keys) for k in range(len(self._angles))]
        self._ring = polynomials_in(len(self._generators) + len(self._angles), sp.ZZ)
        self._tangents = self._ring.gens[len(self._generators) :]

    def _turns(self, frequency: int) -> list[int]:
        """A frequency as whole multiples of the angles."""
        places = dict(unpack(frequency))
        return [places.get(i, 0) // self._basis.steps[i] for i in self._angles]

    def polynomial(self, element: Element) -> Any:
        """The element times its denominator and the highest powers of all 1 + u²."""
        total = self._ring.zero
        for (monomial, frequency), (a, b) in element.terms.items():
            powers = dict(unpack(monomial))
            cosine, sine = self._wave(self._turns(frequency))
            place = (*(powers.get(i, 0) for i in self._generators), *(0 for _ in self._angles))
            total += self._ring.from_dict({place: sp.ZZ(1)}) * (a * cosine + b * sine)
            spend((len(cosine) + len(sine)) / MULTIPLIED_IN_A_UNIT)
        return total

    def _wave(self, turns: list[int]) -> tuple[Any, Any]:
        """cos w and sin w: the parts of Π (1 ± i u)^2|n| (1 + u²)^(highest − |n|)."""
        re, im = self._ring.one, self._ring.zero
        for n, u, highest in zip(turns, self._tangents, self.highest, strict=True):
            turned = u if n > 0 else -u
            for _ in range(2 * abs(n)):
                re, im = re - im * turned, im + re * turned
            left = (1 + u**2) ** (highest - abs(n))
            re, im = re * left, im * left
        return re, im

    def elements(self, polynomials: list[Any]) -> list[Element]:
        """Polynomials, divided by the same powers of 1 + u², as elements."""
        over = self._over(polynomials)
        return [self._element(p, over) for p in polynomials]

    def is_lower(self, polynomials: list[Any]) -> bool:
        """Whether the elements share a power of 1 + cos θ, which is only 2/(1 + u²) in disguise."""
        return any(n < highest for n, highest in zip(self._over(polynomials), self.highest, strict=True))

    def _over(self, polynomials: list[Any]) -> list[int]:
        """The least powers of 1 + u² over which both are Fourier sums."""
        return [(max(p.degree(u) for p in polynomials) + 1) // 2 for u in self._tangents]

    def _element(self, polynomial: Any, over: list[int]) -> Element:
        cut = len(self._generators)
        summands = []
        for exponents, number in polynomial.terms():
            summand = self._basis.number(int(number)).over_monomial(
                -pack(zip(self._generators, exponents[:cut], strict=True))
            )
            for i, e, n in zip(self._angles, exponents[cut:], over, strict=True):
                turn = pack([(i, self._basis.steps[i])])
                cosine, sine = self._basis.circle(turn), self._basis.circle(turn, sine=True)
                half = Fraction(1, 2)
                minus, plus = (1 - cosine) * half, (1 + cosine) * half
                summand = summand * (sine * half) ** (e % 2) * minus ** (e // 2) * plus ** (n - (e + 1) // 2)
            summands.append(summand)
        return self._basis.total(summands)
