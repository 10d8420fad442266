"""Equilibria found numerically, where the conditions have no solution in closed form.

The conditions have numbers in them and up to four unknowns. All their roots in a stated box are enclosed
(`values.numerical_roots`); an angle that occurs in sines and cosines alone is searched once round the circle. Stability
is read off the signs of the minors of the second variation over the enclosure of each root.

The multipliers of constraints are eliminated first, since the conditions Q + Aᵀ λ = 0 are linear in them: there is a
solution λ where all minors of order m + 1 of the matrix (Q, Aᵀ) vanish. Those with m given rows suffice where the minor
of Aᵀ in these rows does not vanish; what they admit elsewhere is excluded by the others.

How far points held by rods of given lengths can be, and their angles: where equilibria of linkages are sought.

A constraint x₁² + y₁² = l₁² bounds x₁ and y₁, and (x₂ − x₁)² + (y₂ − y₁)² = l₂² then bounds x₂ and y₂. In general let
a constraint be a quadratic function whose squares are completed one after another,

    Σ_k d_k (u_k − s_k)² = c ,     d_k > 0 ,     s_k linear in the unknowns after u_k .

Then |u_1 − s_1| ≤ √(c/d_1), and u_1 is bounded where the unknowns in s_1 are. Where each constraint has two squares
with the same d, and s in unknowns of those before it, as in a chain of rods in a plane, u_1 − s_1 = ρ cos φ and
u_2 − s_2 = ρ sin φ: the constraints hold for any angles φ, and every position has one set of them. Cosine and sine of
an angle count as two unknowns with c² + s² = 1.

The roots of lengths are no obstacle to the search: √S = l is S = l², and of √A + √B = L, a string over a nail, both
lengths follow from L and A − B.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import combinations, islice, product

import sympy as sp

from lagrange.algebra.closed_forms.unit_circle import CIRCULAR
from lagrange.algebra.exact.zero_test import is_zero
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import Bounded, sign_in_range
from lagrange.core.units import unit_called, unit_of
from lagrange.mechanics.dynamics.free_bodies import without_root
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium
from lagrange.mechanics.equilibrium.limits import (
    BEYOND_PI,
    LONGEST_LINK,
    MOST_CHARTS,
    MOST_UNKNOWNS,
    USUAL_SIZE,
    WITHOUT_LENGTHS,
)
from lagrange.mechanics.equilibrium.stability import SecondVariation, StabilityVerdict
from lagrange.values.limits import WORKING_DIGITS
from lagrange.values.numerical_roots import NumericalRoot, real_roots, sign_at, signs_of_minors
from lagrange.values.quantities import NotRealError, Quantity, Values, real_value

ROUND_A_CIRCLE = tuple((2 * n + 1) / 26 for n in range(13))  # parts of it from which positions of rods are sought
"""A little more than π: a root at π is found from both sides."""


@record
class Searched:
    """Between which numbers an unknown was searched.

    is_circle  all angles, −π < θ ≤ π
    is_whole   it can have no other values: those of a range or circle, or all that the constraints admit
    """

    low: sp.Expr
    high: sp.Expr
    is_circle: bool = False
    is_whole: bool = False


@record
class NumericalEquilibrium:
    """A root of the conditions: the unknowns, and the verdict on stability."""

    coordinates: dict[sp.Symbol, Quantity]
    stability: StabilityVerdict | None


@record
class NumericalEquilibria:
    """The roots in the box that was searched, and whether these are proved to be all."""

    found: tuple[NumericalEquilibrium, ...]
    searched: dict[sp.Symbol, Searched]
    complete: bool

    @property
    def is_exhaustive(self) -> bool:
        """Whether there are no others anywhere."""
        return self.complete and all(s.is_whole for s in self.searched.values())


def numerical_equilibria(e: Equilibrium, second: SecondVariation | None, values: Values) -> NumericalEquilibria | None:
    """All equilibria by numbers; None if they are known in closed form, or there are too many unknowns."""
    if e.given or all(not b.left for b in e.branches):
        return None
    unknowns = (*e.configuration.slots.coordinates, *e.forces)
    if len(unknowns) > MOST_UNKNOWNS:
        return None
    values = replace(values, numbers={**values.numbers, **dict.fromkeys(_scales(e, values), sp.S.One)})
    forces = [values.put_in(f) for f in e.work.forces]
    slots = e.configuration.slots
    rows = [without_root(row, slots) for row in e.configuration.rows]
    finite = [values.put_in(row.finite) for row in rows if row.finite is not None]
    lengths = [two for f in finite if (two := two_lengths(f, slots.coordinates)) is not None]
    others = [*map(values.put_in, e.laws), *(without_lengths(f, lengths) for f in finite)]
    binding = [without_root(row, slots) for row in e.binding]
    columns = [
        [with_lengths(values.put_in(row.coefficients[k]), lengths) for row in binding] for k in range(len(forces))
    ]
    if not e.binding:
        return _searched([values.put_in(x) for x in e.required], [], unknowns, e, second, values)
    links = None if e.laws or e.forces or e.configuration.ranges else angles_of_links(others, unknowns)
    if links is not None:
        return _by_angles(links, forces, unknowns, e, second, values)
    best = None
    for chart in islice(combinations(range(len(forces)), len(e.binding)), MOST_CHARTS):
        balance = [x for k in range(len(forces)) if k not in chart and (x := _minor(forces, columns, (*chart, k))) != 0]
        rest = [_minor(forces, columns, c) for c in combinations(range(len(forces)), len(chart) + 1)]
        searched = _searched([*balance, *others], rest, unknowns, e, second, values)
        if searched is not None and (best is None or searched.complete or len(searched.found) > len(best.found)):
            best = searched
        if best is not None and best.complete:
            break
    return best


def _scales(e: Equilibrium, values: Values) -> Iterator[sp.Symbol]:
    """The positive parameters without a value to which all forces are proportional: they change no position."""
    forces = [values.put_in(f) for f in e.work.forces]
    for s in sorted({s for f in forces for s in f.free_symbols} & values.parameters, key=str):
        if s.is_positive and all(is_zero(s * f.diff(s) - f) for f in forces):
            yield s


def _by_angles(
    links: Mapping[sp.Symbol, sp.Expr],
    forces: Sequence[sp.Expr],
    unknowns: Sequence[sp.Symbol],
    e: Equilibrium,
    second: SecondVariation | None,
    values: Values,
) -> NumericalEquilibria:
    """The equilibria of a chain of rods, searched round the circle of the angle of each."""
    angles = sorted({s for x in links.values() for s in x.free_symbols}, key=str)
    at = [f.xreplace(dict(links)) for f in forces]
    # without denominators: they vanish where a spring has no length, and beside that place equilibria are likely
    equations = [
        sp.numer(sp.together(sp.Add(*(f * links[q].diff(a) for f, q in zip(at, unknowns, strict=True)))))
        for a in angles
    ]
    roots = real_roots(equations, angles, [(-BEYOND_PI, BEYOND_PI)] * len(angles), ROUND_A_CIRCLE)
    round_: dict[sp.Symbol, Searched] = {a: Searched(-sp.pi, sp.pi, is_circle=True, is_whole=True) for a in angles}
    constraints = [values.put_in(f) for f in e.configuration.finite_constraints]
    searched = {u: Searched(-size, size, is_whole=True) for u, size in reach_of_links(constraints, unknowns).items()}
    matrix = [] if second is None else [[values.put_in(x) for x in row] for row in second.matrix]
    positions = []
    for root in _distinct(roots.roots, angles, round_):
        turned = dict(zip(angles, root.values, strict=True))
        places = tuple(links[u].xreplace(turned).evalf(WORKING_DIGITS) for u in unknowns)
        there = NumericalRoot(places, tuple((float(p), float(p)) for p in places))
        if all(_is_finite(f.xreplace(dict(zip(unknowns, places, strict=True)))) for f in forces):
            positions.append(NumericalEquilibrium(_quantities(there, unknowns, searched, e, values),
                                                  _verdict(matrix, unknowns, there)))  # fmt: skip
    return NumericalEquilibria(tuple(positions), searched, roots.complete)


def _minor(forces: Sequence[sp.Expr], columns: Sequence[Sequence[sp.Expr]], rows: Sequence[int]) -> sp.Expr:
    """The determinant of these rows of (Q, Aᵀ), without denominators that do not matter."""
    return sp.numer(sp.together(sp.Matrix([[forces[k], *columns[k]] for k in rows]).det(method="berkowitz")))


def _searched(
    equations: Sequence[sp.Expr],
    others: Sequence[sp.Expr],
    unknowns: Sequence[sp.Symbol],
    e: Equilibrium,
    second: SecondVariation | None,
    values: Values,
) -> NumericalEquilibria | None:
    """The roots of the equations at which the others may vanish too; None if the equations are too few or many."""
    used = {s for x in equations for s in x.free_symbols}
    if len(equations) != len(unknowns) or used != {*unknowns}:
        return None
    finite = [values.put_in(f) for f in e.configuration.finite_constraints]
    lengths = [two for f in finite if (two := two_lengths(f, e.configuration.slots.coordinates)) is not None]
    reach = reach_of_links([*equations, *(bound for two in lengths for bound in two.bounds)], unknowns)
    searched = {u: _search(u, equations, e, values, reach) for u in unknowns}
    forces = [values.put_in(f) for f in e.work.forces]
    matrix = [] if second is None else [[values.put_in(x) for x in row] for row in second.matrix]
    positions: list[NumericalEquilibrium] = []
    complete = True
    for part in _parts(equations, searched):
        box = [(-BEYOND_PI, BEYOND_PI) if s.is_circle else _outward(s) for s in part.values()]
        roots = real_roots([_with_known_signs(x, part) for x in equations], unknowns, box)
        complete = complete and roots.complete
        for root in _distinct(roots.roots, unknowns, part):
            place = dict(zip(unknowns, root.values, strict=True))
            at_a_jump = any(part[u] != searched[u] and _is_tiny(v) for u, v in place.items())
            if at_a_jump or any(sign_at(x, unknowns, root) in (1, -1) for x in others):
                continue
            if any(sign_at(x, unknowns, root) == -1 for two in lengths for x in two.values.values()):
                continue
            if all(_is_finite(f.xreplace(place)) for f in forces):
                signed = [[_with_known_signs(x, part) for x in row] for row in matrix]
                positions.append(NumericalEquilibrium(_quantities(root, unknowns, searched, e, values),
                                                  _verdict(signed, unknowns, root)))  # fmt: skip
    return NumericalEquilibria(tuple(positions), searched, complete)


def _parts(equations: Sequence[sp.Expr], searched: Mapping[sp.Symbol, Searched]) -> Iterator[dict[sp.Symbol, Searched]]:
    """The search in parts, in each of which sgn x and |x| of an unknown x are x's own sign and size."""
    jumping = {f.args[0] for x in equations for f in x.atoms(sp.Abs, sp.sign)}
    halves = {
        u: (replace(s, high=sp.S.Zero), replace(s, low=sp.S.Zero))
        if u in jumping and not s.is_circle and s.low < 0 < s.high
        else (s,)
        for u, s in searched.items()
    }
    return (dict(zip(halves, part, strict=True)) for part in product(*halves.values()))


def _with_known_signs(x: sp.Expr, searched: Mapping[sp.Symbol, Searched]) -> sp.Expr:
    """The expression with cos θ for |cos θ| where θ is searched between 0 and π/2."""
    inner = {u: Bounded(u.name, s.low, s.high, (True, True)) for u, s in searched.items() if not s.is_circle}
    rule: dict[sp.Expr, sp.Expr] = {}
    for f in x.atoms(sp.Abs, sp.sign, sp.DiracDelta):
        sign = sign_in_range(f.args[0].xreplace(inner))
        if sign is not None:
            size = sign * f.args[0]
            rule[f] = size if isinstance(f, sp.Abs) else sp.Integer(sign) if isinstance(f, sp.sign) else sp.S.Zero
    return x.xreplace(rule)


def _search(
    u: sp.Symbol, equations: Sequence[sp.Expr], e: Equilibrium, values: Values, reach: Mapping[sp.Symbol, sp.Expr]
) -> Searched:
    """Where an unknown is searched."""
    limits = e.configuration.ranges.get(u)
    if limits is not None:
        low, high = values.put_in(limits.low), values.put_in(limits.high)
        if low.is_number and high.is_number:
            return Searched(low, high, is_whole=True)
    if all(_is_periodic(x, u) for x in equations):
        return Searched(-sp.pi, sp.pi, is_circle=True, is_whole=True)
    if u in e.solution.letters.angles:
        return Searched(-4 * sp.pi, 4 * sp.pi)
    if u in reach:
        return Searched(-reach[u], reach[u], is_whole=True)
    size = USUAL_SIZE * sum(_lengths(values)) or sp.Integer(WITHOUT_LENGTHS)
    size = sp.Integer(10) ** sp.ceiling(sp.log(size, 10).evalf())
    return Searched(-size, size)


def _is_periodic(x: sp.Expr, u: sp.Symbol) -> bool:
    """Whether an expression has the period 2π: the unknown occurs in sines and cosines of its integer multiples."""
    waves = [f for f in x.atoms(*CIRCULAR) if u in f.free_symbols]
    rest = x.xreplace({f: sp.Dummy() for f in waves})
    rates = [f.args[0].diff(u) for f in waves]
    return u not in rest.free_symbols and all(r.is_Integer for r in rates)


def _lengths(values: Values) -> Iterator[sp.Expr]:
    """The lengths in the problem, and the quotients of its forces by its stiffnesses."""
    of = {text: unit.dimension for text in ("m", "N", "N/m") if (unit := unit_of(text)) is not None}
    sizes = {text: [abs(n) for s, n in values.numbers.items() if values.units.get(s) == d] for text, d in of.items()}
    yield from sizes["m"]
    yield from (f / k for f in sizes["N"] for k in sizes["N/m"] if k != 0)


def _outward(s: Searched) -> tuple[float, float]:
    low, high = float(s.low), float(s.high)
    margin = 1e-3 * (high - low)
    return low - margin, high + margin


def _distinct(
    roots: Sequence[NumericalRoot], unknowns: Sequence[sp.Symbol], searched: dict[sp.Symbol, Searched]
) -> Iterator[NumericalRoot]:
    """The roots in the search, with angles in (−π, π], each once."""
    circles = [searched[u].is_circle for u in unknowns]
    seen: list[NumericalRoot] = []
    for root in roots:
        if not all(_is_within(v, searched[u]) for v, u in zip(root.values, unknowns, strict=True)):
            continue
        if not any(_is_same(root, other, circles) for other in seen):
            seen.append(root)
            yield root


def _is_within(value: sp.Float, s: Searched) -> bool:
    return s.is_circle or bool(s.low.evalf(30) <= value <= s.high.evalf(30))


def _is_same(root: NumericalRoot, other: NumericalRoot, circles: Sequence[bool]) -> bool:
    """Whether a root lies, up to full turns, in the box in which another one is the only root."""
    turns = product(*((-1, 0, 1) if circle else (0,) for circle in circles))
    return any(
        all(
            low <= v + 2 * sp.pi.evalf(30) * n <= high
            for v, n, (low, high) in zip(root.values, turn, other.box, strict=True)
        )
        for turn in turns
    )


def _quantities(
    root: NumericalRoot,
    unknowns: Sequence[sp.Symbol],
    searched: dict[sp.Symbol, Searched],
    e: Equilibrium,
    values: Values,
) -> dict[sp.Symbol, Quantity]:
    quantities = {}
    for u, value in zip(unknowns, root.values, strict=True):
        angle = searched[u].is_circle or u in e.solution.letters.angles
        unit = "rad" if angle else unit_called(values.units[u]) if u in values.units else ""
        number: sp.Expr = value
        if searched[u].is_circle and abs(value) > sp.pi:
            number = value - 2 * sp.pi.evalf(40) * sp.sign(value)
        quantities[u] = Quantity(sp.S.Zero if _is_tiny(number) else number, unit)
    return quantities


def _is_tiny(number: sp.Expr) -> bool:
    """Whether a root is 0 to all digits computed: it is printed as 0, and no digit of it would be right."""
    return bool(abs(number) < sp.Float(10) ** -25)


def _is_finite(value: sp.Expr) -> bool:
    """Whether a force has a value at a root; one with a parameter that has no value has one unless a pole shows."""
    if value.free_symbols:
        return not value.has(sp.zoo, sp.nan, sp.oo)
    try:
        real_value(value)
    except NotRealError:
        return False
    return True


def _verdict(
    matrix: Sequence[Sequence[sp.Expr]], unknowns: Sequence[sp.Symbol], root: NumericalRoot
) -> StabilityVerdict | None:
    """From the principal minors of the second variation; None if there is none."""
    if not matrix:
        return None
    signs = signs_of_minors(matrix, unknowns, root)
    if -1 in signs.values():
        return StabilityVerdict.UNSTABLE
    leading = [signs[tuple(range(n))] for n in range(1, len(matrix) + 1)]
    return StabilityVerdict.STABLE if all(s == 1 for s in leading) else StabilityVerdict.UNDECIDED


# Two lengths with a given sum


@record
class TwoLengths:
    """a √A + b √B = L without roots: of u = a √A and v = b √B, u + v and u² − v² = a² A − b² B are known.

    values  √A and √B
    square  what is zero instead of the constraint
    bounds  a² A − L² and b² B − L², not positive if a and b are positive
    """

    values: Mapping[sp.Expr, sp.Expr]
    square: sp.Expr
    bounds: tuple[sp.Expr, ...]


def two_lengths(constraint: sp.Expr, coordinates: Sequence[sp.Symbol]) -> TwoLengths | None:
    """The lengths of both parts of a string that runs over a nail; None if a constraint, zero, is of another kind."""
    roots = sorted((r for r in constraint.atoms(sp.Pow) if r.exp == sp.S.Half and r.has(*coordinates)), key=str)
    rest = -constraint.xreplace(dict.fromkeys(roots, sp.S.Zero))
    shares = [constraint.coeff(r) for r in roots]
    if len(roots) != 2 or not all(x.is_number and x != 0 for x in (*shares, rest)):
        return None
    if sp.expand(constraint + rest - sp.Add(*(a * r for a, r in zip(shares, roots, strict=True)))) != 0:
        return None
    squares = [sp.expand(a**2 * r.base) for a, r in zip(shares, roots, strict=True)]
    between = (squares[0] - squares[1]) / rest
    parts = [sp.expand((rest + between) / 2), sp.expand((rest - between) / 2)]
    values = {r: part / a for a, r, part in zip(shares, roots, parts, strict=True)}
    bounds = tuple(x - rest**2 for x in squares) if all((a * rest).is_positive for a in shares) else ()
    return TwoLengths(values, sp.expand(parts[0] ** 2 - squares[0]), bounds)


def without_lengths(constraint: sp.Expr, lengths: Sequence[TwoLengths]) -> sp.Expr:
    """A constraint as it is, or without the roots of two lengths."""
    return next((two.square for two in lengths if two.values.keys() <= constraint.atoms(sp.Pow)), constraint)


def with_lengths(e: sp.Expr, lengths: Sequence[TwoLengths]) -> sp.Expr:
    """An expression with the values of such lengths for their roots, also for 1/√A."""
    known = {r.base: value for two in lengths for r, value in two.values.items()}
    powers = [p for p in e.atoms(sp.Pow) if p.base in known and (2 * p.exp).is_Integer]
    return e.xreplace({p: known[p.base] ** (2 * p.exp) for p in powers})


# Reach of links


def reach_of_links(constraints: Sequence[sp.Expr], unknowns: Sequence[sp.Symbol]) -> dict[sp.Symbol, sp.Expr]:
    """The greatest size of each unknown that constraints, each zero, with numbers for the parameters, bound."""
    waves = {
        f: sp.Dummy(f.func.__name__) for e in constraints for f in e.atoms(sp.cos, sp.sin) if f.args[0] in unknowns
    }
    circles = [
        (waves[f] ** 2, 1 - waves[g] ** 2) for f in waves if f.func is sp.sin and (g := sp.cos(*f.args)) in waves
    ]
    symbols = (*unknowns, *waves.values())
    quadratic = [
        plain
        for e in constraints
        if count_operations(e) <= LONGEST_LINK
        and (plain := sp.expand(e).xreplace(waves)).is_polynomial(*symbols)
        and sp.Poly(plain, *symbols).total_degree() == 2
    ]
    reach: dict[sp.Symbol, sp.Expr] = dict.fromkeys(waves.values(), sp.S.One)
    for _ in unknowns:
        for e in quadratic:
            for u in unknowns:
                if u in reach or u not in e.free_symbols:
                    continue
                if (size := _size(e, u, symbols, reach, circles)) is not None:
                    reach[u] = size
    return {u: size for u, size in reach.items() if u in unknowns}


def angles_of_links(constraints: Sequence[sp.Expr], unknowns: Sequence[sp.Symbol]) -> dict[sp.Symbol, sp.Expr] | None:
    """All unknowns as functions of one angle for each constraint; None where these are no chain of rods in a plane."""
    short = all(count_operations(e) <= LONGEST_LINK and e.is_polynomial(*unknowns) for e in constraints)
    if len(unknowns) != 2 * len(constraints) or not short:
        return None
    placed: dict[sp.Symbol, sp.Expr] = {}
    waiting = [*constraints]
    while waiting:
        for e in waiting:
            new = [u for u in unknowns if u in e.free_symbols and u not in placed]
            rod = _rod(sp.expand(e), new, unknowns) if len(new) == 2 else None
            if rod is None:
                continue
            length, middles = rod
            angle = sp.Dummy(f"phi_{len(placed) // 2}", real=True)
            waves = (sp.cos(angle), sp.sin(angle))
            placed |= {u: m.xreplace(placed) + length * w for u, m, w in zip(new, middles, waves, strict=True)}
            waiting.remove(e)
            break
        else:
            return None
    return placed


def _rod(
    e: sp.Expr, new: Sequence[sp.Symbol], unknowns: Sequence[sp.Symbol]
) -> tuple[sp.Expr, tuple[sp.Expr, ...]] | None:
    """ρ and s of (u_1 − s_1)² + (u_2 − s_2)² = ρ²; None if a constraint is not of this form."""
    square = e.coeff(new[0], 2)
    if sp.Poly(e, *unknowns).total_degree() != 2 or not square.is_number or square == 0:
        return None
    middles = tuple(sp.expand(-e.coeff(u, 1) / (2 * square)) for u in new)
    if any(not m.free_symbols.isdisjoint(new) for m in middles):
        return None
    rest = sp.expand(e / square - sp.Add(*((u - m) ** 2 for u, m in zip(new, middles, strict=True))))
    return (sp.sqrt(-rest), middles) if rest.is_number and rest.is_negative else None


def _size(
    e: sp.Expr,
    u: sp.Symbol,
    unknowns: Sequence[sp.Symbol],
    reach: dict[sp.Symbol, sp.Expr],
    circles: Sequence[tuple[sp.Expr, sp.Expr]],
) -> sp.Expr | None:
    """The greatest |u| where e = 0; None if the bounds of the other unknowns give none.

    circles  sin² θ = 1 − cos² θ of angles, whose waves are unknowns
    """
    rest, first, shift = sp.expand(e), sp.S.Zero, sp.S.Zero
    if rest.coeff(u, 2).is_negative:  # l² = x² + y²
        rest = -rest
    for v in (u, *(w for w in unknowns if w != u)):
        square, linear = rest.coeff(v, 2), rest.coeff(v, 1)
        if not square.is_number or square.is_negative:
            return None
        if square == 0:
            if linear != 0:
                return None
            continue
        middle = sp.expand(-linear / (2 * square))
        if v == u:
            first, shift = square, middle
        rest = sp.expand(sp.expand(rest - square * (v - middle) ** 2).subs(circles))
    if first == 0 or not rest.is_number or not rest.is_nonpositive:
        return None
    size = sp.sqrt(-rest / first)
    for v in shift.free_symbols:
        if v not in reach:
            return None
        size += abs(shift.coeff(v, 1)) * reach[v]
    return size + abs(shift.xreplace(dict.fromkeys(shift.free_symbols, sp.S.Zero)))
