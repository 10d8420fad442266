"""The linear equations about a steady motion, with the constraints eliminated numerically.

    M ζ + D η + K ξ = Σ λ a ,     a η + b ξ = 0 ,     G ξ = 0 ,     ζ = η', η = ξ' ,

with constant tables: the motion must be steady, so that all of them are what they are at one moment. With u the
independent ones among the η, and ξ_P the independent ones among the ξ,

    η = S u + P ξ ,  a S = 0 ,  a P = −b ;     ξ = N ξ_P ;

    Sᵀ M S u' + Sᵀ (M P + D) S u + Sᵀ [(M P + D) P + K] N ξ_P = 0 .

Coordinates that do not occur in the last term, such as the heading of a bicycle, are ignorable; where all but the
independent ones are, these are equations of second order, and they fall apart into blocks that are not coupled.

A parameter without a value stays a letter: the tables are polynomials in it, which are found from their values at a few
numbers, and tried at others.

For which values of a parameter the solutions of linear equations decay: a bicycle between two speeds.

det(M p² + D p + K) = a_0 p^n + ... + a_n, with coefficients that are polynomials in the parameter. As it changes, an
exponent p can pass to the other side of the imaginary axis only where a_n = 0 (p = 0), where the last but one of
Hurwitz' determinants vanishes (p = ±iω), or where a_0 = 0 (Orlando). Between such places the number of exponents on
either side is constant, and one value tells which it is.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cached_property
from itertools import combinations_with_replacement, pairwise
from random import Random
from typing import Any

import sympy as sp
from mpmath.libmp.libhyper import NoConvergence

from lagrange.algebra.exact.linear_algebra import solution
from lagrange.core.diagnostics import Diagnostic, NotCoveredError, ProblemError
from lagrange.core.records import record
from lagrange.core.symbols import prime
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.limits import (
    CLEARLY_REAL,
    CLEARLY_ZERO,
    HIGHEST_DEGREE,
    LARGEST_DENOMINATOR,
    MOST_LETTERS,
    MOST_ROOT_STEPS,
    SHOWN_DIGITS,
    SPARE_VALUES,
)
from lagrange.mechanics.nearby.linear_equations import (
    Expansions,
    FirstOrderTerms,
    ReferenceState,
    RoundedReals,
    first_order,
    reference,
)
from lagrange.problem.model import Problem

CoefficientTable = list[list[Any]]


@record
class LinearBlock:
    """M ξ'' + D ξ' + K ξ = 0 for coordinates that are coupled with each other and with no others."""

    coordinates: tuple[sp.Symbol, ...]
    mass: Entries
    damping: Entries
    stiffness: Entries

    @property
    def equations(self) -> tuple[sp.Expr, ...]:
        """The left sides, each zero."""
        tables = zip(self.mass, self.damping, self.stiffness, strict=True)
        return tuple(
            sp.Add(
                *(
                    m * prime(q, 2) + d * prime(q) + k * q
                    for q, m, d, k in zip(self.coordinates, ms, ds, ks, strict=True)
                )
            )
            for ms, ds, ks in tables
        )

    @cached_property
    def exponents(self) -> tuple[sp.Expr, ...]:
        """The p of solutions e^(pt), det(M p² + D p + K) = 0, except p = 0; none if a letter has no value."""
        tables = [sp.Matrix(m) for m in (self.mass, self.damping, self.stiffness)]
        if any(m.free_symbols for m in tables):
            return ()
        p = sp.Dummy("p")
        polynomial = sp.Poly((tables[0] * p**2 + tables[1] * p + tables[2]).det(method="berkowitz"), p)
        lowest = min(power for (power,), _ in polynomial.terms())
        polynomial = sp.Poly(sp.expand(polynomial.as_expr() / p**lowest), p)
        try:
            roots = polynomial.nroots(n=SHOWN_DIGITS, maxsteps=MOST_ROOT_STEPS) if polynomial.degree() else []
        except NoConvergence:  # roots that are several at one place
            return ()
        return tuple(sp.N(r, SHOWN_DIGITS - 1, chop=True) for r in roots)

    @cached_property
    def stable_ranges(self) -> tuple[StableRange, ...] | None:
        """Where a parameter has no value: those of its positive values for which every solution decays."""
        return stable_ranges(self.mass, self.damping, self.stiffness)


@record
class LinearMotion:
    """The linear equations about a steady motion.

    state      the coordinates and velocities there, by symbol
    letters    the parameters without values
    blocks     of the independent coordinates
    ignorable  the other coordinates: they follow from these, and do not act on them
    bound      those among them that the finite relations determine
    """

    state: Mapping[sp.Symbol, sp.Expr]
    letters: tuple[sp.Symbol, ...]
    blocks: tuple[LinearBlock, ...]
    ignorable: tuple[sp.Symbol, ...]
    bound: tuple[sp.Symbol, ...]


@record
class Reduced:
    """Sᵀ M S and so on at one set of numbers; the state, and the columns of the stiffness."""

    about: ReferenceState
    mass: CoefficientTable
    damping: CoefficientTable
    stiffness: CoefficientTable
    state: list[Any]


def linear_motion(problem: Problem, configuration: Configuration) -> LinearMotion:
    """The linear equations about the motion that begins as `initial` says. Raises ProblemError, NotCoveredError."""
    stated = {i.symbol: i.value for i in problem.initial}
    if not stated:
        raise ProblemError(
            Diagnostic(
                "no-reference-motion",
                "the file does not say about which motion its equations are to be linearized",
                help="give a state in `initial`: `initial: {theta: 0, x': v}`",
            )
        )
    given = problem.given_values
    letters = tuple(p.symbol for p in problem.parameters if p.value is None)
    if len(letters) > MOST_LETTERS:
        names = ", ".join(f"`{s.name}`" for s in letters)
        raise ProblemError(
            Diagnostic(
                "values-needed",
                f"linear equations in numbers need the values of all parameters but {MOST_LETTERS}; {names} have none",
                help="give values in the file, or with `--set`",
            )
        )
    places = (dict(zip(letters, place, strict=True)) for place in _places(letters))
    samples = [reduced_at(configuration, stated, given | place) for place in places]
    first = samples[0]
    if any((s.about.independent, s.about.placed) != (first.about.independent, first.about.placed) for s in samples):
        raise NotCoveredError("a motion whose independent coordinates change with a parameter")
    return _in_blocks(configuration, letters, samples)


def reduced_at(configuration: Configuration, stated: Mapping[sp.Symbol, sp.Expr], numbers: dict[Any, Any]) -> Reduced:
    """The reduced tables, all parameters being numbers."""
    slots = configuration.slots
    about = reference(configuration, stated, numbers)
    expansions = Expansions(slots, about.values)
    rates = [expansions.number(v) for v in slots.velocities]
    linear = first_order(configuration, expansions, rates)
    independent, placed = about.independent, about.placed
    size = expansions.size
    a = [linear.rows[r] for r in about.used]
    b = [linear.changes[r] for r in about.used]
    dependent = [k for k in range(size) if k not in independent]
    _check_steady(linear, about)
    multipliers = _solved(expansions, [[row[k] for row in a] for k in range(size)], linear.balance)
    if multipliers is None:
        raise not_steady()
    stiffness = [
        [
            linear.stiffness[k][l]
            - sum(m * linear.slope[r][k][l] for m, r in zip(multipliers, about.used, strict=True))
            for l in range(size)
        ]
        for k in range(size)
    ]
    square = [[row[k] for k in dependent] for row in a]
    S = _carried(expansions, square, dependent, [[-row[k] for row in a] for k in independent], independent)
    P = _carried(expansions, square, dependent, [[-row[k] for row in b] for k in range(size)], ())
    N = _placement(expansions, configuration, placed)
    coupled = _plus(_times(linear.mass, P), linear.damping)
    St = _transposed(S)
    return Reduced(
        about,
        _times(_times(St, linear.mass), S),
        _times(_times(St, coupled), S),
        _times(_times(St, _plus(_times(coupled, P), stiffness)), N),
        [expansions.number(s) for s in (*slots.coordinates, *slots.velocities)],
    )


def not_steady() -> ProblemError:
    """The error for a motion that does not go on as it begins."""
    return ProblemError(
        Diagnostic(
            "not-steady",
            "the motion that begins as `initial` says is not steady: its velocities do not stay as they are",
            help="give the state of a steady motion or of an equilibrium, and its constraints in directions that turn "
            "with it",
        )
    )


def _check_steady(linear: FirstOrderTerms, state: ReferenceState) -> None:
    """The constraints must hold with velocities that stay as they are."""
    if any(abs(linear.misfit[r]) > CLEARLY_ZERO for r in state.used):
        raise not_steady()


def _solved(about: Expansions, rows: CoefficientTable, right: Sequence[Any]) -> list[Any] | None:
    """x with rows x = right; None if there is none."""
    if not rows or not rows[0]:
        return [] if all(abs(b) < CLEARLY_ZERO for b in right) else None
    return solution(about.reals, rows, right)


def _carried(
    about: Expansions,
    square: CoefficientTable,
    dependent: Sequence[int],
    rights: CoefficientTable,
    independent: Sequence[int],
) -> CoefficientTable:
    """Columns of all coordinates: the dependent ones solved for each right side, unit ones for the independent."""
    zero, one = about.reals.number(0), about.reals.number(1)
    columns = []
    for place, right in enumerate(rights):
        column = [zero] * about.size
        if independent:
            column[independent[place]] = one
        carried = _solved(about, square, right)
        assert carried is not None
        for k, x in zip(dependent, carried, strict=True):
            column[k] = x
        columns.append(column)
    return _transposed(columns)


def _placement(about: Expansions, configuration: Configuration, placed: Sequence[int]) -> CoefficientTable:
    """N: ξ = N ξ_P on the finite relations."""
    gradients = [about.gradient(about.jet(f, 1)) for f in configuration.finite_constraints]
    bound = [k for k in range(about.size) if k not in placed]
    return _carried(
        about, [[g[k] for k in bound] for g in gradients], bound, [[-g[k] for g in gradients] for k in placed], placed
    )


def _times(a: CoefficientTable, b: CoefficientTable) -> CoefficientTable:
    columns = _transposed(b)
    return [[sum(x * y for x, y in zip(row, column, strict=True)) for column in columns] for row in a]


def _plus(a: CoefficientTable, b: CoefficientTable) -> CoefficientTable:
    return [[x + y for x, y in zip(r, s, strict=True)] for r, s in zip(a, b, strict=True)]


def _transposed(a: CoefficientTable) -> CoefficientTable:
    return [list(column) for column in zip(*a, strict=True)]


def _monomials(letters: Sequence[sp.Symbol]) -> list[tuple[sp.Symbol, ...]]:
    return [m for d in range(HIGHEST_DEGREE + 1) for m in combinations_with_replacement(letters, d)]


def _places(letters: Sequence[sp.Symbol]) -> Iterator[tuple[sp.Expr, ...]]:
    """Numbers for the letters at which a polynomial is determined, and some more."""
    count = len(_monomials(letters)) + (SPARE_VALUES if letters else 0)
    for n in range(count):
        yield tuple(sp.Rational((7 * n * n + 11 * n * (k + 1) + 13 * k) % 97 + 20, 31) for k in range(len(letters)))


class _Fit:
    """Polynomials in the letters through the values at `_places`."""

    def __init__(self, letters: Sequence[sp.Symbol]) -> None:
        self.reals = RoundedReals(Random(0))
        self.monomials = _monomials(letters)
        self.rows = []
        for point in _places(letters):
            value = dict(zip(letters, point, strict=True))
            row = []
            for m in self.monomials:
                x = sp.Mul(*(value[s] for s in m))
                row.append(self.reals.number(x.p, x.q))
            self.rows.append(row)

    def polynomial(self, values: Sequence[Any]) -> sp.Expr:
        """The polynomial with these values. Raises NotCoveredError if there is none."""
        scale = max(map(abs, values))
        if scale < CLEARLY_ZERO:
            return sp.S.Zero
        count = len(self.monomials)
        coefficients = solution(self.reals, self.rows[:count], values[:count])
        assert coefficients is not None
        for row, value in zip(self.rows[count:], values[count:], strict=True):
            if abs(sum(c * x for c, x in zip(coefficients, row, strict=True)) - value) > CLEARLY_ZERO * scale:
                raise NotCoveredError("linear equations that are no polynomials in a parameter without a value")
        terms = zip(coefficients, self.monomials, strict=True)
        return sp.Add(*(_rounded(c) * sp.Mul(*m) for c, m in terms if abs(c) > CLEARLY_ZERO * scale))


def _rounded(x: Any) -> sp.Expr:
    """A number of eighty digits: the rational that it is to fifty digits, if that is short, or its first digits."""
    near = Fraction(str(sp.Float(x, 50))).limit_denominator(LARGEST_DENOMINATOR)
    if abs(x - near.numerator / type(x)(near.denominator)) < CLEARLY_ZERO:
        return sp.Rational(near.numerator, near.denominator)
    return sp.Float(x, SHOWN_DIGITS)


def _in_blocks(
    configuration: Configuration, letters: tuple[sp.Symbol, ...], samples: Sequence[Reduced]
) -> LinearMotion:
    slots = configuration.slots
    fit = _Fit(letters)
    independent, placed = samples[0].about.independent, samples[0].about.placed

    def polynomials(tables: Sequence[CoefficientTable]) -> list[list[sp.Expr]]:
        return [
            [fit.polynomial([t[i][j] for t in tables]) for j in range(len(tables[0][0]))] for i in range(len(tables[0]))
        ]

    mass, damping = polynomials([s.mass for s in samples]), polynomials([s.damping for s in samples])
    stiffness = polynomials([s.stiffness for s in samples])
    others = [k for k, q in enumerate(placed) if q not in independent]
    if any(row[k] != 0 for row in stiffness for k in others):
        raise NotCoveredError(
            "linear equations about a motion that depend on more coordinates than there are degrees of freedom"
        )
    at = [placed.index(q) for q in independent]
    stiffness = [[row[k] for k in at] for row in stiffness]
    size = len(independent)
    blocks = []
    for group in _groups(size, (mass, damping, stiffness)):
        parts = (tuple(tuple(m[i][j] for j in group) for i in group) for m in (mass, damping, stiffness))
        blocks.append(LinearBlock(tuple(slots.coordinates[independent[i]] for i in group), *parts))
    values = zip(*(s.state for s in samples), strict=True)
    state = dict(zip((*slots.coordinates, *slots.velocities), map(_state(fit), values), strict=True))
    used = {slots.coordinates[k] for k in independent}
    bound = tuple(q for k, q in enumerate(slots.coordinates) if k not in placed)
    return LinearMotion(state, letters, tuple(blocks), tuple(q for q in slots.coordinates if q not in used), bound)


def _state(fit: _Fit) -> Any:
    def value(values: Sequence[Any]) -> sp.Expr:
        return fit.polynomial(values)

    return value


def _groups(size: int, tables: Sequence[Sequence[Sequence[sp.Expr]]]) -> list[list[int]]:
    """Indices that are coupled by any of the tables, together."""
    groups: list[set[int]] = []
    for i in range(size):
        joined = {i, *(j for j in range(size) for t in tables if t[i][j] != 0 or t[j][i] != 0)}
        for g in [g for g in groups if g & joined]:
            joined |= g
            groups.remove(g)
        groups.append(joined)
    return [sorted(g) for g in sorted(groups, key=min)]


# For which parameters it is stable


Entries = tuple[tuple[sp.Expr, ...], ...]


@record
class StableRange:
    """low < letter < high: all solutions decay there. `high` is infinity where there is no end; an end at which two
    exponents reach the imaginary axis together is one of `oscillating`.
    """

    letter: sp.Symbol
    low: sp.Expr
    high: sp.Expr
    oscillating: tuple[sp.Expr, ...]


def stable_ranges(*tables: Entries) -> tuple[StableRange, ...] | None:
    """The positive values of the only letter in M, D, K for which every solution decays; None if that is open."""
    rational = [sp.Matrix(t).applyfunc(_exact) for t in tables]
    letters = {s for t in rational for s in t.free_symbols}
    if len(letters) != 1:
        return None
    [letter] = letters
    p = sp.Dummy("p")
    mass, damping, stiffness = rational
    a = sp.Poly((mass * p**2 + damping * p + stiffness).det(method="berkowitz"), p).all_coeffs()
    if len(a) < 2 or a[-1] == 0:
        return ()
    try:
        ends = {x: n == 1 for n, e in enumerate((a[-1], _last_but_one(a), a[0])) for x in _positive_roots(e, letter)}
        ranges = [
            (low, high)
            for low, high in pairwise([sp.S.Zero, *sorted(ends), sp.oo])
            if _decays(a, letter, 2 * low + 1 if high is sp.oo else (low + high) / 2)
        ]
    except NoConvergence:
        return None
    return tuple(StableRange(letter, *f, tuple(x for x in f if ends.get(x))) for f in ranges)


def _exact(e: sp.Expr) -> sp.Expr:
    """With fractions for decimals."""
    return e.xreplace({x: sp.Rational(x) for x in e.atoms(sp.Float)})


def _last_but_one(a: list[sp.Expr]) -> sp.Expr:
    """Hurwitz' determinant of order n − 1."""
    n = len(a) - 1
    rows = [[a[2 * j - i + 1] if 0 <= 2 * j - i + 1 <= n else sp.S.Zero for j in range(n - 1)] for i in range(n - 1)]
    return sp.expand(sp.Matrix(rows).det(method="berkowitz")) if n > 1 else sp.S.One


def _positive_roots(e: sp.Expr, letter: sp.Symbol) -> Iterator[sp.Expr]:
    polynomial = sp.Poly(e, letter)
    if polynomial.is_zero:
        raise NoConvergence  # an exponent is on the axis for all values
    for root in sp.Poly(polynomial.sqf_part(), letter).nroots(n=2 * SHOWN_DIGITS, maxsteps=MOST_ROOT_STEPS):
        real, imaginary = root.as_real_imag()
        if abs(imaginary) < CLEARLY_REAL * abs(root) and real > 0:
            yield real


def _decays(a: list[sp.Expr], letter: sp.Symbol, value: sp.Expr) -> bool:
    """Whether all exponents have negative real parts at one value."""
    p = sp.Dummy("p")
    at = sp.Poly([c.subs(letter, value) for c in a], p)
    roots = at.nroots(n=SHOWN_DIGITS, maxsteps=MOST_ROOT_STEPS)
    return all(sp.re(r) < 0 for r in roots)
