"""Choices of generalized coordinates.

A choice expresses the old coordinates by new ones, q = q(s, t). It is verified, not believed: the geometric constraints
must hold identically in s, and the columns of ∂q/∂s must be independent, as many as there are degrees of freedom under
the constraints that the substitution satisfies. The kinematic constraints that it does not satisfy remain, rewritten in
s: a' = a ∂q/∂s, a_t' = a_t + a ∂q/∂t.

A choice may also name some of the old coordinates. The geometric constraints are then solved for the others, with a
sign ±1 for each square root, so that all branches are kept at once; coordinates known only through a constraint on
velocities (φ' = y'/R) are eliminated through it.

What the coordinates of a choice measure: angles of lines between points, the position of the mass centre.

For two points with the difference d = r_B − r_A in the coordinates of the choice, q is an angle of d if

    d = |d| (cos q e_0 + sin q e_1)

with constant perpendicular unit vectors: e_0 is where d points at q = 0, e_1 where it points at q = π/2. In space the
angle from e_0 has an e_1 that depends on one more angle p, that of e_1 in the plane normal to e_0. Each equation is
decided as an identity.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import combinations

import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero, vanishes
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.diagnostics import Diagnostic, ProblemError, UndecidedError
from lagrange.core.expression_size import Sizes, count_operations
from lagrange.core.records import record
from lagrange.core.symbols import Sign, Slots, Unspecified, partial, prime
from lagrange.core.vectors import FIXED, Vector
from lagrange.mechanics.constraints.constrained_system import Row
from lagrange.mechanics.constraints.kinematics import Configuration, MassPoint, substituted_configuration
from lagrange.mechanics.constraints.limits import (
    LONGEST_EXPANDED,
    LONGEST_SHOWN,
    LONGEST_SOLVED,
    MOST_MEASURED_POINTS,
    MOST_SOLVED_TERMS,
)
from lagrange.problem.model import Choice


@record
class GeneralizedCoordinates:
    """A verified choice; the file's own coordinates are the choice without a name.

    configuration  the system in its coordinates
    satisfied      names of the constraints that it satisfies identically
    signs          the signs ±1 of square roots; there are 2^len(signs) branches
    through_rates  old coordinates known only through their velocities
    radicands      the radicands of the roots: not negative
    jacobian       ∂q/∂s, shape (number of old coordinates, number of chosen ones)
    """

    choice: Choice
    configuration: Configuration
    satisfied: tuple[str, ...]
    signs: tuple[Sign, ...]
    through_rates: tuple[sp.Symbol, ...]
    radicands: tuple[sp.Expr, ...]
    jacobian: sp.ImmutableMatrix

    @property
    def branches(self) -> int:
        """The number of branches of the square roots."""
        return 1 << len(self.signs)


def own_coordinates(configuration: Configuration) -> GeneralizedCoordinates:
    """The file's own coordinates as the choice without a name: nothing is replaced, and no constraint is satisfied."""
    coordinates = configuration.slots.coordinates
    identity = sp.ImmutableMatrix(sp.eye(len(coordinates)))
    return GeneralizedCoordinates(Choice("", coordinates, {}), configuration, (), (), (), (), identity)


def generalized_coordinates(choice: Choice, original: Configuration) -> GeneralizedCoordinates:
    """Verify a choice and rewrite the system in it.

    Raises ProblemError if the substitution violates a constraint, or the coordinates are dependent or too few;
    UndecidedError if this could not be decided.
    """
    old = original.slots.coordinates
    if choice.substitute is None:
        solution = solved_constraints(original.rows, [q for q in old if q not in choice.coordinates])
        expressed, signs = solution.expressed, solution.signs
        through_rates = tuple(q for q in old if q not in choice.coordinates and q not in expressed)
    else:
        expressed, signs, through_rates = choice.substitute, (), ()
    coordinates = (*choice.coordinates, *through_rates)
    slots = Slots(coordinates, original.slots.prescribed)
    jacobian = sp.ImmutableMatrix([[partial(expressed.get(q, q), s) for s in coordinates] for q in old])
    satisfied: list[str] = []
    kept: list[Row] = []
    rule = dict(expressed)
    for row in original.rows:
        pulled = pulled_back(row, old, expressed, jacobian, slots)
        if (row.finite is not None and row.finite.xreplace(rule) == 0) or _holds(choice, row, pulled, through_rates):
            satisfied.append(row.name)
        else:
            kept.append(pulled)
    configuration = substituted_configuration(original, choice.name, coordinates, expressed, tuple(kept))
    radicands = _radicands(expressed.values()) if signs else ()
    result = GeneralizedCoordinates(choice, configuration, tuple(satisfied), signs, through_rates, radicands, jacobian)
    _check_independent(result, original)
    return result


def _radicands(expressions: Iterable[sp.Expr]) -> tuple[sp.Expr, ...]:
    """The radicands of the square roots, each once."""
    roots = (p for e in expressions for p in e.atoms(sp.Pow) if p.exp == sp.S.Half and p.base.free_symbols)
    return tuple(dict.fromkeys(p.base for p in sorted(roots, key=lambda p: p.sort_key())))


def pulled_back(
    row: Row,
    old: Sequence[sp.Symbol],
    expressed: Mapping[sp.Symbol, sp.Expr],
    jacobian: sp.Matrix,
    slots: Slots,
) -> Row:
    """The row in the new coordinates: a' = a ∂q/∂s, a_t' = a_t + a ∂q/∂t."""
    rule: dict[sp.Basic, sp.Basic] = dict(expressed)
    if row.nonlinear is not None:
        rates = {prime(q): slots.time_derivative(e) for q, e in expressed.items()}
        return Row.by_chetaev(row.name, textbook_form(row.nonlinear.xreplace(rule | rates)), slots)
    a = [c.xreplace(rule) for c in row.coefficients]
    coefficients = tuple(
        textbook_form(sp.Add(*(a[k] * jacobian[k, s] for k in range(len(old)) if a[k] != 0 != jacobian[k, s])))
        for s in range(len(slots.coordinates))
    )
    transport = sp.Add(
        *(a[k] * slots.frozen_derivative(expressed[q]) for k, q in enumerate(old) if q in expressed and a[k] != 0)
    )
    finite = None if row.finite is None else row.finite.xreplace(rule)
    return Row(row.name, coefficients, textbook_form(row.drift.xreplace(rule) + transport), finite)


def _holds(choice: Choice, row: Row, pulled: Row, through_rates: Sequence[sp.Symbol]) -> bool:
    """Whether the choice satisfies a constraint identically; a geometric one must be satisfied."""
    if row.finite is not None:
        if any(q in pulled.finite.free_symbols for q in through_rates):  # type: ignore[union-attr]
            return False
        verdict = is_zero(pulled.finite)
        if verdict is None:
            raise UndecidedError(
                f"whether the choice `{choice.name}` satisfies the constraint `{row.name}`", choice.span
            )
        if verdict is False:
            message = f"the choice `{choice.name}` does not satisfy the constraint `{row.name}`"
            becomes = "with the substitution it"
            if (
                pulled.finite is not None
                and not pulled.finite.has(Unspecified)
                and count_operations(pulled.finite) <= LONGEST_SHOWN
            ):
                left = str(pulled.finite).replace("**", "^")
                becomes += f" becomes `{left} = 0`, which"
            help_ = (
                f"{becomes} does not hold for all values of the coordinates: correct `substitute`, or the constraint"
            )
            if _holds_for_positive(pulled):
                help_ = (
                    "it is satisfied for positive coordinates only: sqrt(r^2) is |r|; write the constraint in squares"
                )
            raise ProblemError(Diagnostic("choice-against-constraint", message, choice.span, help=help_))
        return True
    verdicts = [is_zero(e) for e in (*pulled.coefficients, pulled.drift)]
    if None in verdicts and False not in verdicts:
        raise UndecidedError(f"whether the choice `{choice.name}` satisfies the constraint `{row.name}`", choice.span)
    return all(verdicts)


def _holds_for_positive(row: Row) -> bool:
    """Whether the constraint would hold if all coordinates were positive."""
    assert row.finite is not None
    positive = {s: sp.Symbol(s.name, positive=True) for s in row.finite.free_symbols if not s.is_positive}
    return is_zero(row.finite.xreplace(positive)) is True


def _check_independent(result: GeneralizedCoordinates, original: Configuration) -> None:
    choice = result.choice
    chosen = len(choice.coordinates) + len(result.through_rates)
    rank = result.configuration.surface.rank(result.jacobian)
    names = ", ".join(f"`{q}`" for q in choice.coordinates)
    if rank is None:
        raise UndecidedError(f"whether the coordinates {names} of `{choice.name}` are independent", choice.span)
    if rank < chosen:
        message = f"the coordinates {names} of `{choice.name}` are not independent"
        spare = chosen - rank
        directions = f"{rank} direction{'' if rank == 1 else 's'}"
        help_ = f"these {chosen} move the old coordinates in {directions} only; leave {spare} out"
        raise ProblemError(Diagnostic("dependent-coordinates", message, choice.span, help=help_))
    rows = [list(r.coefficients) for r in original.rows if r.name in result.satisfied]
    satisfied = original.states.rank(rows)
    if satisfied is None:
        raise UndecidedError("the rank of the constraints", choice.span)
    needed = len(original.slots.coordinates) - satisfied
    if chosen < needed:
        message = (
            f"the choice `{choice.name}` has {chosen} coordinate{'' if chosen == 1 else 's'}, "
            f"but the positions need {needed}"
        )
        help_ = "it would add a constraint that the file does not have; choose more coordinates"
        raise ProblemError(Diagnostic("too-few-coordinates", message, choice.span, help=help_))


@record
class SolvedConstraints:
    """Coordinates in terms of the others, and the signs of the square roots in them."""

    expressed: Mapping[sp.Symbol, sp.Expr]
    signs: tuple[Sign, ...]


def solved_constraints(rows: Sequence[Row], unknown: Sequence[sp.Symbol]) -> SolvedConstraints:
    """Solve the geometric constraints for the unknown coordinates, one after the other, linear ones first.

    A linear difference of two constraints is tried before their roots. If it leads to an equation that cannot be
    solved (for a crank and slider it gives x in terms of s, and s in terms of y is of degree four), the constraints are
    solved as they are written. An equation that nested roots have made too long stays unsolved.
    """
    finite = [r.finite for r in rows if r.finite is not None]
    solution, remaining = _solved_in_turn(finite, unknown, differences=True)
    unsolved = [q for q in unknown if q not in solution.expressed]
    if any(not f.free_symbols.isdisjoint(unsolved) for f in remaining):
        return _solved_in_turn(finite, unknown, differences=False)[0]
    return solution


def _solved_in_turn(
    finite: Sequence[sp.Expr], unknown: Sequence[sp.Symbol], differences: bool
) -> tuple[SolvedConstraints, list[sp.Expr]]:
    """The coordinates that can be solved for, with or without differences of constraints, and the constraints left."""
    waiting, expressed = list(finite), dict[sp.Symbol, sp.Expr]()
    roots: list[Sign] = []
    solving = True
    while solving and unknown:
        solving = False
        for degree in (1, 2):
            for used, f in _candidates(waiting, unknown, differences and degree == 1):
                solved = solved_for_one(f.xreplace(expressed), unknown, degree, len(roots) + 1)
                if solved is None:
                    continue
                q, value, sign = solved
                expressed = {p: e.xreplace({q: value}) for p, e in expressed.items()} | {q: value}
                roots.extend(sign)
                unknown = [u for u in unknown if u != q]
                waiting = [g for n, g in enumerate(waiting) if n != used]
                solving = True
                break
    return SolvedConstraints(expressed, tuple(roots)), [f.xreplace(expressed) for f in waiting]


def _candidates(
    waiting: Sequence[sp.Expr], unknown: Sequence[sp.Symbol], differences: bool
) -> Iterator[tuple[int, sp.Expr]]:
    """Equations that may be solved next, each with the index of the constraint that it uses up.

    Two circles or spheres have a linear difference: x² + y² = a² and (x − b)² + y² = c² give x.
    """
    yield from enumerate(waiting)
    if not differences:
        return
    squares = [_squares(f, unknown) for f in waiting]
    for (m, f), (n, g) in combinations(enumerate(waiting), 2):
        for q in squares[m]:
            if q in squares[n]:
                yield n, sp.expand(g * squares[m][q] - f * squares[n][q])


def _squares(f: sp.Expr, unknown: Sequence[sp.Symbol]) -> dict[sp.Symbol, sp.Expr]:
    """The unknowns whose squares occur in f with numerical coefficients, and these; none if f is long."""
    if _is_long(f):
        return {}
    expanded, symbols = sp.expand(f), f.free_symbols
    coefficients = {q: expanded.coeff(q, 2) for q in unknown if q in symbols}
    return {q: a for q, a in coefficients.items() if a.is_number and a != 0}


def solved_for_one(
    f: sp.Expr, unknown: Sequence[sp.Symbol], degree: int, number: int
) -> tuple[sp.Symbol, sp.Expr, tuple[Sign, ...]] | None:
    """q, its value and the sign of its root, for the first unknown in which f = 0 has the given degree.

    None if there is none, or the equation is too long.
    """
    if _is_long(f):
        return None
    for q in unknown:
        if q not in f.free_symbols:
            continue
        coefficients = _polynomial(f, q, degree)
        if coefficients is None:
            continue
        if degree == 1:
            c, b = coefficients
            return q, sp.expand(-c / b), ()
        c, b, a = coefficients
        sign = Sign(f"sigma_{number}")
        half = sp.expand(b / (2 * a))
        radicand = half**2 - c / a
        if Sizes().of(radicand).widest > MOST_SOLVED_TERMS:
            continue
        return q, sign * sp.sqrt(sp.expand(radicand)) - half, (sign,)
    return None


def _is_long(f: sp.Expr) -> bool:
    """Whether an equation is too long to be differentiated and multiplied out in reasonable time."""
    sizes = Sizes().of(f)
    return sizes.size > LONGEST_SOLVED or sizes.widest > MOST_SOLVED_TERMS


def _polynomial(f: sp.Expr, q: sp.Symbol, degree: int) -> list[sp.Expr] | None:
    """The coefficients of f as a polynomial of exactly this degree in q, lowest first; None if it is not one.

    A short expression may become a polynomial when multiplied out; a long one must be a polynomial as it is written.
    """
    if Sizes().of(f).size > LONGEST_EXPANDED and not f.is_polynomial(q):
        return None
    coefficients = []
    derivative = f
    for order in range(degree + 1):
        coefficients.append(sp.expand(derivative.xreplace({q: sp.S.Zero})) / sp.factorial(order))
        derivative = derivative.diff(q)
        if _is_long(derivative):  # of tanh(tanh(... q)), a product that grows with every tanh
            return None
    if sp.expand(derivative) != 0 or coefficients[-1] == 0 or any(c.has(sp.zoo, sp.nan) for c in coefficients):
        return None
    return coefficients


# Measures


@record
class Angle:
    """The angle q of the line from `start` (empty: the fixed point O) to `end`.

    zero       the axis along which the line, or its projection, points at q = 0
    towards    where it turns as q grows; None for an angle from an axis in space
    projected  the axis on whose normal plane the line is projected; None if it lies in the plane itself
    """

    symbol: sp.Symbol
    start: str
    end: str
    zero: Vector
    towards: Vector | None
    projected: Vector | None = None


def angles(configuration: Configuration, symbols: Sequence[sp.Symbol]) -> tuple[Angle, ...]:
    """The given coordinates that are angles of lines between points, each once."""
    written = [c for p in configuration.points[:MOST_MEASURED_POINTS] for c in p.position.fixed().components]
    waves = [w for c in written for w in c.atoms(sp.sin, sp.cos)]
    sought = [q for q in symbols if any(w.args[0] == q for w in waves)]
    measured: dict[sp.Symbol, Angle] = {}
    for start, end, d in _lines(configuration) if sought else ():
        for angle in _angles_of(d, start, end, sought):
            measured.setdefault(angle.symbol, angle)
        if len(measured) == len(sought):
            break
    return tuple(measured[q] for q in symbols if q in measured)


def of_mass_centre(configuration: Configuration, symbols: Sequence[sp.Symbol]) -> tuple[sp.Symbol, ...]:
    """The coordinates that are components of the mass centre of several particles."""
    points = [p for p in configuration.points if p.mass != 0]
    if len(points) < 2 or configuration.rotations:
        return ()
    total = sp.Add(*(p.mass for p in points))
    moment = sum((p.position.fixed() * p.mass for p in points), Vector.zero(FIXED))
    at = [(c, q) for c in moment.components for q in symbols if c.has(q)]
    return tuple(q for c, q in at if vanishes(c - total * q))


def _lines(configuration: Configuration) -> Iterator[tuple[str, str, Vector]]:
    """The lines between points: those along rods first."""
    points = configuration.points[:MOST_MEASURED_POINTS]
    slots = {*configuration.slots.coordinates}
    moving = [p for p in points if _depends(p.position, slots)]
    rigid: list[tuple[str, str, Vector]] = []
    others: list[tuple[str, str, Vector]] = []
    for n, p in enumerate(moving):
        for start in (None, *moving[:n]):
            d = _difference(p, start)
            line = ("" if start is None else start.name, p.name, d)
            (others if _depends(_square(d), slots) else rigid).append(line)
    yield from (*rigid, *others)


def _depends(value: Vector | sp.Expr, symbols: set[sp.Symbol]) -> bool:
    components = value.fixed().components if isinstance(value, Vector) else (value,)
    return any(not c.free_symbols.isdisjoint(symbols) for c in components)


def _difference(end: MassPoint, start: MassPoint | None) -> Vector:
    at = end.position.fixed()
    return (at if start is None else at - start.position.fixed()).map(textbook_form)


def _square(d: Vector) -> sp.Expr:
    return textbook_form(d.dot(d))


def _angles_of(d: Vector, start: str, end: str, symbols: Sequence[sp.Symbol]) -> Iterator[Angle]:
    for q in symbols:
        if not any(c.has(sp.sin(q), sp.cos(q)) for c in d.components):
            continue
        first, second = (_turned_to(d, q, at) for at in (sp.S.Zero, sp.pi / 2))
        turned = first * sp.cos(q) + second * sp.sin(q)
        if not all(vanishes(c) for c in (d - turned).components):
            continue
        zero, towards = _axis(first), _axis(second)
        if zero is not None and towards is not None:
            yield Angle(q, start, end, zero, towards)
        elif zero is not None and vanishes(_square(first) - _square(second)):
            yield Angle(q, start, end, zero, None)
            yield from (
                Angle(a.symbol, start, end, a.zero, a.towards, zero)
                for a in _angles_of(second, start, end, [p for p in symbols if p != q])
                if a.towards is not None and a.projected is None
            )


def _turned_to(d: Vector, q: sp.Symbol, value: sp.Expr) -> Vector:
    return d.map(lambda c: textbook_form(c.xreplace({q: value})))


def _axis(v: Vector) -> Vector | None:
    """i, j, k or one of them reversed, if a vector is along it by a factor of a known sign."""
    along = [(n, c) for n, c in enumerate(v.components) if c != 0]
    if len(along) != 1:
        return None
    [(n, c)] = along
    sign = 1 if c.is_positive else -1 if c.is_negative else 0
    units = tuple(sp.Integer(sign) if m == n else sp.S.Zero for m in range(3))
    return Vector(units, FIXED) if sign else None
