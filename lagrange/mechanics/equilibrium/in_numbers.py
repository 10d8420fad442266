"""Equilibria, their stability and their frequencies in numbers, where the parameters have values.

A branch such as cos θ = g/(l ω²) is a set of points, and the values of all letters are known at each of them; so each
point becomes a position when the values are substituted, θ = ±1.047. One at which a coordinate is not real, or a
condition of the branch fails, is absent with these values. Conclusions on stability that depended on open signs are
settled by the values; where a minor is too small to have a certain sign, no claim is made.

Critical values: a condition in which all parameters but one have values, solved for that one.

An equilibrium that is stable where k l > P is so for P < 100 N if k and l are given. The condition is solved where the
parameter occurs in one power, a p^n + b; a bound that the sign of the parameter makes idle is omitted.
"""

from __future__ import annotations

from collections.abc import Callable, Container, Iterable, Iterator, Mapping, Sequence
from dataclasses import field, replace

import mpmath
import sympy as sp

from lagrange.algebra.closed_forms.eigenmodes import Frequency
from lagrange.algebra.closed_forms.signs import SignCondition, sign_of
from lagrange.algebra.closed_forms.single_equation import Relation
from lagrange.algebra.closed_forms.single_equation import Values as Letters
from lagrange.algebra.closed_forms.solution_sets import Branch, parameters_given
from lagrange.algebra.closed_forms.unit_circle import NotAlgebraicError
from lagrange.algebra.exact.expression_graph import DivisionByZeroError
from lagrange.core.records import record
from lagrange.core.symbols import Bounded
from lagrange.core.units import Dimension, unit_called
from lagrange.mechanics.equilibrium.admissible_positions import CIRCLE, angles_with, as_measured, distances
from lagrange.mechanics.equilibrium.damped_modes import exponents_in_numbers
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium
from lagrange.mechanics.equilibrium.limits import MOST_ANGLES, MOST_OSCILLATING_IN_NUMBERS, SAME_IN_MODES
from lagrange.mechanics.equilibrium.linearization import Linearization, SmallOscillations
from lagrange.mechanics.equilibrium.numerical_equilibria import NumericalEquilibria, numerical_equilibria
from lagrange.mechanics.equilibrium.stability import SecondVariation, Stability, StabilityVerdict
from lagrange.problem.model import Range
from lagrange.values.limits import WORKING_DIGITS
from lagrange.values.quantities import NotRealError, Quantity, Values, real_value

Evaluate = Callable[[sp.Expr], sp.Expr]
"""An expression at a point, with the values substituted."""

CERTAIN = sp.Float(10) ** (10 - WORKING_DIGITS)
"""A number that is smaller than this part of the others has no certain sign."""


@record
class Oscillation:
    """A frequency ω in numbers, and the period 2π/ω; `root` is the index of the root that it belongs to.

    mode  the amplitudes of the free coordinates relative to the first, or the largest where that is at rest; empty for
          one coordinate, for equal frequencies, and for many coordinates
    """

    root: int
    frequency: Quantity
    period: Quantity
    mode: tuple[float, ...] = ()


@record
class Decay:
    """A damped mode in numbers: δ, ω (None: it does not oscillate), and amplitude and phase of each free coordinate."""

    rate: Quantity
    frequency: Quantity | None
    amplitudes: tuple[float, ...]
    phases: tuple[float, ...]


@record
class Position:
    """An equilibrium in numbers.

    branch        of the equilibria in closed form, by index; None if it was found numerically
    coordinates   the coordinates and unknown forces that have one value there
    stability     None if nothing was asked or can be said
    oscillations  about it; empty if they are not asked, or it is not stable
    decays        with damping: the modes about it, likewise
    forces        the named reactions there, if it was found numerically (`searched.reactions_found`)
    """

    branch: int | None
    coordinates: Mapping[sp.Symbol, Quantity]
    stability: StabilityVerdict | None = None
    oscillations: tuple[Oscillation, ...] = ()
    decays: tuple[Decay, ...] = ()
    forces: Mapping[sp.Symbol, Quantity] = field(default_factory=dict)


@record
class EquilibriaInNumbers:
    """The equilibria of one set of coordinates in numbers.

    unknowns   the coordinates and unknown forces, in their order
    absent     the branches, by index, that have no point with these values
    numerical  the search for those that are not in closed form; its roots are among the positions
    units      the dimensions that are known
    slack      its roots at which a contact would have to pull, or a string to push, which are not
    """

    unknowns: tuple[sp.Symbol, ...]
    angles: frozenset[sp.Symbol]
    positions: tuple[Position, ...]
    absent: tuple[int, ...] = ()
    numerical: NumericalEquilibria | None = None
    units: Mapping[sp.Symbol, Dimension] = field(default_factory=dict)
    slack: tuple[Position, ...] = ()


def equilibria_in_numbers(e: Equilibrium, second: SecondVariation | None, values: Values) -> EquilibriaInNumbers | None:
    """The equilibria in numbers; None if a parameter of theirs has no value, or only forces are to be found."""
    held = not e.conditions and not any(b.left for b in e.branches)  # by constraints, at places that are known
    if e.given or held or not values.covers(*e.expressions):
        return None
    verdicts = second.verdicts if second is not None else (None,) * len(e.branches)
    positions: list[Position] = []
    absent: list[int] = []
    for n, (b, stability) in enumerate(zip(e.branches, verdicts, strict=True)):
        if b.left or b.special:
            continue
        there = [*_positions(n, b, stability, e, values)]
        positions += there
        absent += [] if there else [n]
    return _ordered(e, positions, absent, numerical_equilibria(e, second, values), values)


def oscillations_in_numbers(
    linear: Linearization, values: Values, resting: Equilibrium | None = None, second: SecondVariation | None = None
) -> EquilibriaInNumbers | None:
    """The equilibria of the equations of motion in numbers, with the frequencies about them.

    resting, second  the equilibria by virtual work, if there are such, and their stability: where V has a strict
                     minimum the equilibrium is stable, although a frequency is zero and the linear equations decide
                     nothing
    """
    e = linear.equilibrium
    by_energy = (
        {}
        if resting is None or second is None
        else dict(zip((b.relations for b in resting.branches), second.verdicts, strict=True))
    )
    used = [*e.expressions, *(x for s in linear.at if s is not None for x in s.equations)]
    if not values.covers(*used):
        return None
    positions: list[Position] = []
    absent: list[int] = []
    for n, (b, s) in enumerate(zip(linear.branches, linear.at, strict=True)):
        if b.left or b.special:
            continue
        stability = None if s is None else s.judgement.stability
        energy = by_energy.get(b.relations)
        if stability is not None and stability.verdict is StabilityVerdict.UNDECIDED and energy is not None:
            stability = energy if energy.is_always_stable else stability
        there = [*_positions(n, b, stability, e, values, s)]
        positions += there
        absent += [] if there else [n]
    return _ordered(e, positions, absent, numerical_equilibria(e, None, values), values)


def _ordered(
    e: Equilibrium,
    positions: Sequence[Position],
    absent: Sequence[int],
    numerical: NumericalEquilibria | None,
    values: Values,
) -> EquilibriaInNumbers | None:
    if not positions and not absent and numerical is None:
        return None
    known = [p.coordinates for p in positions]
    circles = {u for u, s in numerical.searched.items() if s.is_circle} if numerical is not None else set()
    for root in numerical.found if numerical is not None else ():
        if not any(_is_same(root.coordinates, k, circles) for k in known):
            positions = [*positions, Position(None, root.coordinates, root.stability)]
    if numerical is not None and numerical.is_exhaustive and all(p.branch is not None for p in positions):
        absent = [*absent, *(n for n, b in enumerate(e.branches) if b.left)]
    unknowns = (*e.configuration.slots.coordinates, *e.forces)
    angles = frozenset(u for u in unknowns if u in e.solution.letters.angles)
    return EquilibriaInNumbers(unknowns, angles, tuple(positions), tuple(absent), numerical, values.units)


def _is_same(
    root: Mapping[sp.Symbol, Quantity], known: Mapping[sp.Symbol, Quantity], circles: Container[sp.Symbol]
) -> bool:
    """Whether a root is a position in closed form: to twenty digits, both being roots of the same equations.

    circles  angles that are the same up to full turns
    """
    if root.keys() != known.keys():
        return False
    differences = {u: (root[u].formula - known[u].formula).evalf(30) for u in root}
    turned = (d - 2 * sp.pi.evalf(30) * round(d / (2 * sp.pi)) if u in circles else d for u, d in differences.items())
    return all(abs(d) < sp.Float(10) ** -20 for d in turned)


def _positions(
    n: int,
    b: Branch,
    stability: Stability | None,
    e: Equilibrium,
    values: Values,
    oscillations: SmallOscillations | None = None,
) -> Iterator[Position]:
    """The points of a branch that exist with the values."""
    for point in b.points:

        def at(x: sp.Expr, point: Letters = point) -> sp.Expr:
            return values.put_in(e.solution.at(point, x))

        try:
            if not all(condition_holds(c, at) is not False for c in b.conditions):
                continue
            coordinates = _coordinates(b, e, values, at)
            if any(_is_outside(q, coordinates, e, values) for q in e.configuration.ranges):
                continue
            if any(_is_beyond(x, r, at) for x, r in e.configuration.bounded):
                continue
            verdict = _verdict(stability, at)
            modes = () if oscillations is None else _oscillations(oscillations, at, values)
            decays = () if oscillations is None else _decays(oscillations, at, values)
        except (NotRealError, NotAlgebraicError, DivisionByZeroError, ZeroDivisionError):
            continue
        if verdict is StabilityVerdict.UNSTABLE:
            modes, decays = (), ()
        yield Position(n, coordinates, verdict, modes, decays)


def _coordinates(b: Branch, e: Equilibrium, values: Values, at: Evaluate) -> dict[sp.Symbol, Quantity]:
    """The coordinates and forces at a point. Raises NotRealError."""
    measured: dict[sp.Symbol, Quantity] = {}
    for u in (*e.configuration.slots.coordinates, *e.forces):
        angle = e.solution.letters.angles.get(u)
        if angle is None:
            value = at(u)
            unit = _unit(u, b, values)
        else:
            cosine, sine = (at(f(angle.measure)) for f in (sp.cos, sp.sin))
            if not cosine.is_number:
                continue
            value = sp.sympify(u / angle.measure, strict=True) * _angle(real_value(cosine), real_value(sine))
            unit = "rad"
        if value.is_number:
            real_value(value)
            measured[u] = Quantity(value, unit)
    return measured


def _is_outside(q: sp.Symbol, measured: Mapping[sp.Symbol, Quantity], e: Equilibrium, values: Values) -> bool:
    """Whether a coordinate is outside of its range."""
    if q not in measured:
        return False
    tested, complement = distances(
        *as_measured(q, e.configuration.ranges[q], e.solution), q in e.solution.letters.angles
    )
    numbers = [values.put_in(x).xreplace({q: measured[q].formula}) for x in tested]
    if any(not x.is_number for x in numbers):
        return False
    signs = [real_value(x) for x in numbers]
    return all(x > CERTAIN for x in signs) if complement and signs else any(x < -CERTAIN for x in signs)


def _is_beyond(x: sp.Expr, limits: Range, at: Evaluate) -> bool:
    """Whether a coordinate that the choice has replaced is outside of its range."""
    margins = [at(sp.expand_trig(m)) for m in (x - limits.low, limits.high - x)]
    return any(m.is_number and real_value(m) < -CERTAIN for m in margins)


def angles_of_branch(
    b: Branch, conditions: Sequence[SignCondition], ranges: Mapping[sp.Symbol, Range], values: Values
) -> Iterator[tuple[Relation, list[sp.Expr], int]]:
    """Relations such as tan θ = 3/4 with the angles, at most two, and how many of them fulfil conditions; these first.

    Of several relations for one angle the first has it, so that the others agree.
    """
    waves = [r for r in b.relations if isinstance(r.lhs, sp.sin | sp.cos | sp.tan) and r.lhs.args[0].is_Symbol]
    done: set[sp.Expr] = set()
    for r in waves:
        q = r.lhs.args[0]
        limits = ranges.get(q, CIRCLE)
        ends = Range(values.put_in(limits.low), values.put_in(limits.high))
        if q in done or not (ends.low.is_number and ends.high.is_number):
            continue
        others = [o for o in waves if o.lhs.args[0] == q]
        found = [a for a in angles_with(r.lhs, values.put_in(r.rhs), ends) if limits != CIRCLE or a != ends.low]
        found = [a for a in found if all(_agrees(o.lhs - o.rhs, q, a, values) for o in others)]
        kept = [a for a in found if conditions and all(_admits(c, q, a, values) for c in conditions)]
        if 0 < len(found) <= MOST_ANGLES:
            done.add(q)
            yield r, [*kept, *(a for a in found if a not in kept)], len(kept)


def acute_parameters(resting: Equilibrium, values: Values) -> Iterator[tuple[Relation, sp.Symbol, sp.Expr]]:
    """Relations between parameters, tan α = μ, with the acute angle that has no value, and its value by the others'."""
    for r in (r for b in resting.branches for r in b.relations):
        _, given = parameters_given([values.put_in(r.residual)], resting.configuration.slots.coordinates)
        yield from ((r, s, value) for s, value in given.items() if isinstance(s, Bounded) and value.is_number)


def _agrees(e: sp.Expr, q: sp.Symbol, angle: sp.Expr, values: Values) -> bool:
    """Whether an expression vanishes at an angle, judged only if it is a number there."""
    value = values.put_in(e.xreplace({q: angle}))
    return not value.is_number or abs(real_value(value)) < CERTAIN


def _admits(c: SignCondition, q: sp.Symbol, angle: sp.Expr, values: Values) -> bool:
    """Whether a condition admits an angle, judged only if it contains nothing but this angle and numbers."""
    apart = c.lhs - c.rhs if c.relation in (">", "≥") else c.rhs - c.lhs
    value = values.put_in(apart.xreplace({q: angle}))
    return c.relation == "≠" or q not in apart.free_symbols or not value.is_number or real_value(value) > 0


def _unit(u: sp.Symbol, b: Branch, values: Values) -> str:
    """The unit of a coordinate: the one that the file gives, or that of the expression for it."""
    if u in values.units:
        return unit_called(values.units[u])
    stated = next((r.rhs for r in b.relations if r.lhs == u), None)
    return "" if stated is None else values.unit_of(stated)


def _angle(cosine: sp.Float, sine: sp.Float) -> sp.Expr:
    """The angle in (−π, π]."""
    if sine.is_zero:
        return sp.S.Zero if cosine > 0 else sp.pi
    if cosine.is_zero:
        return sp.pi / 2 if sine > 0 else -sp.pi / 2
    with mpmath.workdps(WORKING_DIGITS):
        return sp.Float(mpmath.atan2(mpmath.mpf(str(sine)), mpmath.mpf(str(cosine))), WORKING_DIGITS)


def condition_holds(c: SignCondition, at: Evaluate) -> bool | None:
    """Whether a condition holds; None if it has open symbols, or the sides are too close."""
    difference = at(c.lhs) - at(c.rhs)
    if not difference.is_number:
        return None
    value = real_value(difference)
    if value.is_zero:
        return c.relation in ("≥", "≤", "=")
    if abs(value) < CERTAIN:
        return None
    if c.relation == "=":
        return False
    return c.relation == "≠" or bool(value > 0) is (c.relation in ("≥", ">"))


def _verdict(stability: Stability | None, at: Evaluate) -> StabilityVerdict | None:
    """The verdict with the values."""
    if stability is None:
        return None
    if all(condition_holds(c, at) for c in stability.presupposed):
        if stability.verdict in (StabilityVerdict.STABLE, StabilityVerdict.UNSTABLE):
            return stability.verdict
    elif stability.verdict is not StabilityVerdict.CONDITIONAL:
        return StabilityVerdict.UNDECIDED
    if stability.verdict is StabilityVerdict.CONDITIONAL:
        held = [condition_holds(c, at) for c in stability.conditions]
        if all(held):
            return StabilityVerdict.STABLE
        if stability.at_limit is not None and real_value(at(stability.minors[0])).is_zero:
            return stability.at_limit.verdict
        if stability.order == 2 and any(_is_negative(m, at) for m in stability.minors):
            return StabilityVerdict.UNSTABLE
        return StabilityVerdict.UNDECIDED
    if any(condition_holds(c, at) for c in stability.unstable):
        return StabilityVerdict.UNSTABLE
    return StabilityVerdict.UNDECIDED


def _is_negative(minor: sp.Expr, at: Evaluate) -> bool:
    value = at(minor)
    return real_value(value) < -CERTAIN if value.is_number else sign_of(value) == -1  # without a value for W, say


def _oscillations(s: SmallOscillations, at: Evaluate, values: Values) -> tuple[Oscillation, ...]:
    """The frequencies at a point, each as often as it occurs."""
    if not s.oscillates:
        return ()
    squares = [(w, k) for k, f in enumerate(s.frequencies) for w in [*_squares(f, at)] * f.multiplicity]
    known = bool(values.units)
    modes = _modes(s, at)
    oscillations = []
    for w, k in sorted(squares):
        if w > CERTAIN:
            omega = sp.sqrt(w)
            period = Quantity(2 * sp.pi / omega, "s" if known else "")
            near = [mode for square, mode in modes if abs(square - float(w)) < SAME_IN_MODES * float(w)]
            mode = near[0] if len(near) == 1 else ()
            oscillations.append(Oscillation(k, Quantity(omega, "rad/s" if known else ""), period, mode))
    return tuple(oscillations)


def _modes(s: SmallOscillations, at: Evaluate) -> list[tuple[float, tuple[float, ...]]]:
    """ω² with the amplitudes of each normal mode, from (K − ω² M) a = 0; none for one coordinate or for many."""
    if not 1 < len(s.free) <= MOST_OSCILLATING_IN_NUMBERS:
        return []
    tables = []
    for table in (s.system.mass, s.system.stiffness):
        numbers = [[at(e) for e in row] for row in table]
        if any(not e.is_number for row in numbers for e in row):
            return []
        tables.append(mpmath.matrix([[mpmath.mpf(str(real_value(e))) for e in row] for row in numbers]))
    mass, stiffness = tables
    try:
        squares, vectors = mpmath.eig(mass**-1 * stiffness)
    except (ZeroDivisionError, mpmath.NoConvergence):
        return []
    modes = []
    for k, square in enumerate(squares):
        vector = [vectors[n, k] for n in range(len(s.free))]
        largest = max(vector, key=abs)
        scale = vector[0] if abs(vector[0]) > SAME_IN_MODES * abs(largest) else largest
        amplitudes = [complex(x / scale) for x in vector]
        if all(abs(x.imag) < SAME_IN_MODES * max(1, abs(x)) for x in amplitudes):
            modes.append(
                (float(mpmath.re(square)), tuple(x.real if abs(x) > SAME_IN_MODES else 0.0 for x in amplitudes))
            )
    return modes


def _decays(s: SmallOscillations, at: Evaluate, values: Values) -> tuple[Decay, ...]:
    """The damped modes at a point."""
    if s.oscillates or len(s.free) > MOST_OSCILLATING_IN_NUMBERS:
        return ()
    known = bool(values.units)
    with mpmath.workdps(2 * WORKING_DIGITS):
        tables = []
        for table in (s.system.mass, s.system.damping, s.system.stiffness):
            numbers = [[at(e) for e in row] for row in table]
            if any(not e.is_number for row in numbers for e in row):
                return ()
            digits = 2 * WORKING_DIGITS
            tables.append(mpmath.matrix([[mpmath.mpf(str(real_value(e, digits))) for e in row] for row in numbers]))
        try:
            exponents = exponents_in_numbers(*tables)
        except (ZeroDivisionError, mpmath.NoConvergence):
            return ()
        return tuple(
            Decay(
                Quantity(sp.Float(e.rate, WORKING_DIGITS), "1/s" if known else ""),
                Quantity(sp.Float(e.frequency, WORKING_DIGITS), "rad/s" if known else "") if e.frequency else None,
                tuple(float(a) for a in e.amplitudes),
                tuple(float(a) for a in e.phases),
            )
            for e in exponents
        )


def _squares(f: Frequency, at: Evaluate) -> Iterator[sp.Expr]:
    """The values of ω², in closed form or as roots of a polynomial with numbers as coefficients."""
    if f.square is not None:
        value = at(f.square)
        if value.is_number:
            yield real_value(value)
        return
    coefficients = [at(c) for c in sp.Poly(f.factor, f.letter).all_coeffs()]
    if any(not c.is_number for c in coefficients):
        return
    with mpmath.workdps(2 * WORKING_DIGITS):
        numbers = [mpmath.mpf(str(real_value(c, 2 * WORKING_DIGITS))) for c in coefficients]
        roots = mpmath.polyroots(numbers, maxsteps=200, extraprec=400)
        yield from (
            sp.Float(r.real, WORKING_DIGITS) for r in roots if abs(r.imag) < mpmath.mpf(10) ** -WORKING_DIGITS * abs(r)
        )


# Critical values


REVERSED = {">": "<", "<": ">", "≥": "≤", "≤": "≥", "≠": "≠"}


@record
class CriticalValue:
    """The condition, and what it says of a parameter with the values: parameter relation bound."""

    condition: SignCondition
    parameter: sp.Symbol
    relation: str
    bound: Quantity


def critical_values(
    e: Equilibrium | None, second: SecondVariation | None, linear: Linearization | None, values: Values
) -> tuple[CriticalValue, ...]:
    """All critical values of the equilibria of one set of coordinates, each once."""
    conditions: list[SignCondition] = []
    branches = linear.branches if linear is not None else e.branches if e is not None else ()
    conditions += [c for b in branches for c in b.conditions]
    verdicts = [*(second.verdicts if second is not None else ())]
    verdicts += [s.judgement.stability for s in linear.at if s is not None] if linear is not None else []
    conditions += [c for s in verdicts for c in (*s.conditions, *s.presupposed, *s.unstable)]
    return tuple(_each(dict.fromkeys(conditions), values))


def _each(conditions: Iterable[SignCondition], values: Values) -> Iterator[CriticalValue]:
    for c in conditions:
        difference = c.lhs - c.rhs
        missing = (difference.free_symbols & values.parameters) - values.numbers.keys()
        others = difference.free_symbols - values.parameters
        if len(missing) == 1 and not others and len(difference.free_symbols) > 1:
            [p] = missing
            solved = _solved(c, p, values)
            if solved is not None:
                yield solved


def _solved(c: SignCondition, p: sp.Symbol, values: Values) -> CriticalValue | None:
    difference = sp.expand(c.lhs - c.rhs)
    if not difference.is_polynomial(p):
        return None
    powers = [k for (k,), _ in sp.Poly(difference, p).terms() if k]
    if len(powers) != 1 or (powers[0] > 1 and not p.is_positive):
        return None
    [n] = powers
    a, b = difference.coeff(p, n), difference.coeff(p, 0)
    ratio = -b / a
    try:
        bound, slope = real_value(values.put_in(ratio)), real_value(values.put_in(a))
    except NotRealError:
        return None
    if slope.is_zero or (p.is_positive and bound <= 0):
        return None
    root = ratio ** sp.Rational(1, n)
    quantity = values.quantity(root, is_angle=p in values.angles)
    if quantity is None:
        return None
    return CriticalValue(c, p, c.relation if slope > 0 else REVERSED[c.relation], quantity)


def without_known_conditions(e: Equilibrium, values: Values) -> Equilibrium:
    """The equilibria without conditions on parameters that the values fulfil: 3, 4 and 5 are a triangle."""
    branches = tuple(_without_known(b, values) for b in e.branches)
    return e if branches == e.branches else replace(e, branches=branches)


def _without_known(b: Branch, values: Values) -> Branch:
    """A branch with the conditions that the values leave open, or violate; the others become implied ones."""
    left = open_conditions(b.conditions, values)
    known = tuple(c for c in b.conditions if c not in left)
    return replace(b, conditions=left, implied=(*b.implied, *known)) if known else b


def open_conditions(conditions: Iterable[SignCondition], values: Values) -> tuple[SignCondition, ...]:
    """The conditions that the values do not fulfil."""
    return tuple(c for c in conditions if not _is_fulfilled(c, values))


def _is_fulfilled(condition: SignCondition, values: Values) -> bool:
    try:
        return condition_holds(condition, values.put_in) is True
    except NotRealError:
        return False
