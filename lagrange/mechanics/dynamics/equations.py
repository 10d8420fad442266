"""Equations of motion from the balance Σ_k D_k δq_k = 0, with or without multipliers.

    D_k = Σ_j λ_j a_jk                     with multipliers, one equation for each coordinate
    D_k + Σ_d B_dk D_d = 0                 after eliminating δq_D = B δq_I by A δq = 0, together with the constraints

Independent coordinates have D_k = 0. Denominators are multiplied out and common factors divided out; both are recorded,
because what is divided by must not vanish.

From Lagrange's equations, L_k = Σ_j λ_j a_jk, the multipliers are found from those of the dependent coordinates,
Σ_j a_jd λ_j = L_d, and substituted into the others: the minor of A that must not vanish is that of the displacements.
Where it is too large to invert, or friction contains an |λ| that is not yet known, the equations are combined as
Σ_k L_k δq_k = 0 instead, from which the reactions drop out. Multipliers of redundant constraints are omitted: they are
not determined, and add no new direction.

A choice may know some coordinates q_e only through their velocities (R φ' = y'). These are eliminated at the end:

    q_e' = B q_c' + b ,      q_e'' = d/dt (B q_c' + b)

are substituted. If neither B, b nor the equations contain the q_e, an equation in the chosen coordinates alone remains;
otherwise (a spiral spring turned by φ) those constraints complete the equations. Nothing is substituted where an
unsolved finite relation contains a q_e: it would be eliminated in name only.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import field, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any, TypeVar

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError, NoPointError, Point, UnsupportedError, kept_surface
from lagrange.algebra.fourier.linear_systems import solved_linear
from lagrange.algebra.fourier.ring import Element, FourierRing
from lagrange.algebra.fourier.terms import is_acceleration
from lagrange.algebra.fourier.textbook_form import (
    CommonFactor,
    Textbook,
    common_factor,
    common_factor_of,
    normalised,
    textbook_form,
)
from lagrange.core.diagnostics import Diagnostic, ProblemError, UndecidedError
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import partial, prime, variation
from lagrange.mechanics.constraints.constrained_system import Row
from lagrange.mechanics.constraints.displacements import Elimination, TooLongError, eliminate
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.limits import INERTIA_POINTS, LONGEST_RATES, MOST_LONGER
from lagrange.mechanics.dynamics.principle import Balance, Principle
from lagrange.mechanics.dynamics.reactions import over_one_denominator
from lagrange.problem.model import Body

if TYPE_CHECKING:
    from lagrange.mechanics.dynamics.energies import Energies


@record
class EquationOfMotion:
    """expression = 0, the coefficient of the virtual displacement of `coordinate`.

    factor    the factor that has been divided out: its numerator divided by, its denominator multiplied by
    reversed  whether the sign has been changed as well
    written   its sides, where it is not written as expression = 0
    """

    coordinate: sp.Symbol
    expression: sp.Expr
    factor: CommonFactor
    reversed: bool
    written: tuple[sp.Expr, ...] = ()

    @property
    def sides(self) -> tuple[sp.Expr, ...]:
        """As it is displayed."""
        return self.written or (self.expression, sp.S.Zero)


@record
class WithEliminatedRates:
    """The equations of a choice after substituting the velocities and accelerations given by kinematic constraints.

    velocities  each of these velocities, in terms of the others
    rates       these velocities and their accelerations
    equations   of motion after the substitution; a factor is one divided out after it
    used        the names of the constraints that give the velocities
    rows        the constraints that complete the equations
    at_once     whether the equations before the substitution are not written down
    """

    velocities: Mapping[sp.Symbol, sp.Expr]
    rates: Mapping[sp.Symbol, sp.Expr]
    equations: tuple[EquationOfMotion, ...]
    used: tuple[str, ...]
    rows: tuple[Row, ...]
    at_once: bool = False


@record
class EquationsOfMotion:
    """The equations of one configuration; the rows of the configuration complete them.

    principle    the balance that they follow from
    elimination  of the dependent virtual displacements
    equations    in all coordinates of the configuration, as they follow from the principle
    closed       the same in the chosen coordinates, if some are known through their velocities only
    """

    configuration: Configuration
    principle: Balance
    elimination: Elimination
    equations: tuple[EquationOfMotion, ...]
    closed: WithEliminatedRates | None = field(default=None, kw_only=True)

    @property
    def expressions(self) -> tuple[sp.Expr, ...]:
        """Each of these is zero."""
        return tuple(e.expression for e in self.equations)

    @property
    def conditions(self) -> tuple[sp.Expr, ...]:
        """The factors divided by that may vanish: the equations are valid where none of them does."""
        return excluded(self.elimination.pivots, (*self.equations, *(self.closed.equations if self.closed else ())))

    @property
    def final(self) -> tuple[EquationOfMotion, ...]:
        """The equations in which the derivation ends."""
        return self.closed.equations if self.closed else self.equations

    @property
    def completing(self) -> tuple[Row, ...]:
        """The constraints that complete the final equations."""
        return self.closed.rows if self.closed else self.configuration.rows


@record
class WithMultipliers:
    """The equations D_k = Σ_j λ_j a_jk, as pairs, for each coordinate."""

    multipliers: tuple[sp.Symbol, ...]
    equations: tuple[tuple[sp.Expr, sp.Expr], ...]


def excluded(pivots: Sequence[sp.Expr], equations: Sequence[EquationOfMotion]) -> tuple[sp.Expr, ...]:
    """The pivots and the factors that have been divided by, each once."""
    return tuple(dict.fromkeys((*pivots, *(f for e in equations for f in e.factor.nonzero))))


def equations_with_multipliers(principle: Balance, multipliers: Mapping[str, sp.Symbol]) -> WithMultipliers:
    """The equations without any elimination; `multipliers` are λ_j by name of the constraint."""
    rows = principle.configuration.rows
    used = tuple(multipliers[row.name] for row in rows)
    equations = (
        (principle.textbook.form(d), sp.Add(*(s * row.coefficients[k] for s, row in zip(used, rows, strict=True))))
        for k, d in enumerate(principle.coefficients)
    )
    return WithMultipliers(used, tuple(equations))


@record
class DalembertMotion(EquationsOfMotion):
    """The equations from d'Alembert's principle.

    independent  shape (f,): the coefficient of each independent δq
    """

    principle: Principle
    independent: tuple[Element, ...]

    @cached_property
    def reduced(self) -> sp.Expr:
        """Σ over the independent δq: the principle after substituting the dependent ones, in textbook form."""
        coordinates = self.configuration.slots.coordinates
        free = [variation(coordinates[k]) for k in self.elimination.independent]
        return self.principle.written(free, self.independent)


def equations_of_motion(principle: Principle, elimination: Elimination) -> DalembertMotion:
    """The equations of motion of a configuration, the dependent virtual displacements eliminated."""
    configuration = principle.configuration
    coordinates = configuration.slots.coordinates
    coefficients = of_independent(principle.coefficients, principle.ring, elimination)
    pairs = zip(elimination.independent, coefficients, strict=True)
    equations = tuple(divided(principle.textbook, coordinates[k], d) for k, d in pairs)
    return DalembertMotion(configuration, principle, elimination, equations, tuple(coefficients))


def of_independent(d: Sequence[Element], ring: FourierRing, elimination: Elimination) -> list[Element]:
    """D_k + Σ_d B_dk D_d for each independent k."""
    coefficients = []
    for column, k in enumerate(elimination.independent):
        shares = (
            ring.from_sympy(row[column]) * d[dependent]
            for dependent, row in zip(elimination.dependent, elimination.solution, strict=True)
            if row[column] != 0
        )
        coefficients.append(ring.total([d[k], *shares]))
    return coefficients


def divided(textbook: Textbook, coordinate: sp.Symbol, coefficient: Element) -> EquationOfMotion:
    """The equation without common factors and common denominators, its leading acceleration positive."""
    terms = textbook.summands(coefficient)
    if terms is not None:  # as is usual: no expression need be made of them, and taken apart, before they are divided
        factor = common_factor_of(terms)
        if len(factor.nonzero) < 2 and not factor.denominator.powers:
            return _with_sign(coordinate, factor.divide_terms(terms), factor)
    expression = textbook.form(coefficient)
    factor = common_factor(expression)
    kept = factor.divide(expression)
    if any(f.is_Add for f, _ in factor.denominator.powers):
        shorter = factor.numerator.divide(expression)
        if count_operations(shorter) < count_operations(kept):  # multiplying out would make the equation longer
            kept, factor = shorter, factor.numerator
    if factor.denominator.powers:
        kept = textbook.form(kept)
    return _with_sign(coordinate, kept, factor)


def _with_sign(coordinate: sp.Symbol, kept: sp.Expr, factor: CommonFactor) -> EquationOfMotion:
    leading = normalised(kept, [prime(coordinate, 2)])
    return EquationOfMotion(coordinate, leading, factor, leading != kept)


def check_inertia(result: EquationsOfMotion, bodies: Sequence[Body] = ()) -> None:
    """Refuse a system whose equations do not determine the accelerations: a coordinate without inertia.

    Raises ProblemError naming the coordinate, and the body that it turns about an axis without moment of inertia;
    UndecidedError if no generic point was found.
    """
    configuration = result.configuration
    slots = configuration.slots
    forms = [row.coefficients for row in configuration.rows]
    turning = {r.name: [*zip(*(w.components for w in r.partials), strict=True)] for r in configuration.rotations}

    def idle_motions(point: Point) -> tuple[list[list[Any]], list[str]]:
        inertia = point.affine(result.expressions, slots.accelerations)
        assert inertia is not None
        rows = [*(r[:-1] for r in inertia), *point.matrix(forms)]
        kernel = point.nullspace(rows, len(slots.coordinates))
        turned = (n for n, w in turning.items() if kernel)
        return kernel, [
            n for n in turned if len(point.nullspace([*rows, *point.matrix(turning[n])], len(kernel[0]))) < len(kernel)
        ]

    try:
        kernels = configuration.states.sampled(idle_motions, INERTIA_POINTS)
    except (NoPointError, UnsupportedError):
        raise UndecidedError("whether every coordinate has inertia") from None
    kernel, turned = min(kernels, key=lambda sample: len(sample[0]))
    if not kernel:
        return
    idle = [q for k, q in enumerate(slots.coordinates) if any(v[k] != 0 for v in kernel)]
    listed = ", ".join(f"`{q}`" for q in idle)
    message = f"{listed} can change {'' if len(idle) == 1 else 'together '}without moving any mass"
    help_ = "give a mass to what moves with it, or remove the coordinate; with `find: equilibrium` no mass is needed"
    span = next((b.span for b in bodies if b.name in turned), None)
    if turned:
        name = turned[0]
        message += f": `{name}` then turns about an axis about which it has no moment of inertia"
        help_ = (
            f"this rotation stays undetermined: give `{name}` that moment of inertia, or one angle fewer (a number in "
            "its place); what is no larger than a point is a particle"
        )
    contained = {s for e in result.expressions for s in e.free_symbols}
    rest = [f"`{q}`" for q in slots.coordinates if q not in idle]
    if turned and rest and contained.isdisjoint({d for q in idle for d in (q, prime(q), prime(q, 2))}):
        it, depend = "it" if len(idle) == 1 else "them", "does" if len(rest) == 1 else "do"
        help_ += f"; {' and '.join(rest)} {depend} not depend on {it}, so that the motion is then found"
    raise ProblemError(Diagnostic("no-inertia", message, span, help=help_))


def excluding(motion: EquationsOfMotion) -> tuple[sp.Expr, ...]:
    """The conditions of the final equations that matter: where one vanishes, motion is no longer determined.

    With B the matrix of the accelerations in the equations and in the differentiated constraints,
    det B = p_1^n_1 p_2^n_2 ... D, where the p are what was divided by, and D, the determinant of the mass matrix
    restricted to the virtual displacements times that of A Aᵀ, does not vanish. So p is harmless if B is regular at a
    point with p = 0. Whether it is is decided exactly; undecided conditions are kept.
    """
    configuration = motion.configuration
    as_they_are = motion.closed is not None or any(r.nonlinear is not None for r in configuration.rows)
    if as_they_are or not motion.conditions:
        return motion.conditions
    accelerations = configuration.slots.accelerations
    inertia = [[partial(e.expression, a) for a in accelerations] for e in motion.equations]
    matrix = [*inertia, *(list(r.coefficients) for r in configuration.rows)]

    def is_harmless(pivot: sp.Expr) -> bool:
        there = kept_surface([*configuration.finite_constraints, pivot], configuration.slots.coordinates)
        try:
            return there.rank(matrix) == len(accelerations)
        except DivisionByZeroError:
            return False

    return tuple(p for p in motion.conditions if not is_harmless(p))


M = TypeVar("M", bound=EquationsOfMotion)

_NOTHING = CommonFactor(sp.S.One, ())


def closed(motion: M, through_rates: Sequence[sp.Symbol]) -> M:
    """The equations of motion after substituting the velocities and accelerations of the coordinates `through_rates`.

    They stay as they are if the constraints on velocities do not give these velocities in terms of the others, or if
    the equations would become much longer.
    """
    configuration = motion.configuration
    used = [r for r in configuration.rows if _mentions(r, configuration, through_rates)]
    velocities = _velocities(configuration, used, through_rates)
    if not velocities:
        return motion
    slots = configuration.slots
    accelerations = [textbook_form(slots.time_derivative(v).xreplace(velocities)) for v in velocities.values()]
    rule = {**velocities, **{prime(v): a for v, a in zip(velocities, accelerations, strict=True)}}
    equations = tuple(_substituted(e, rule, motion.principle.textbook) for e in motion.equations)
    if _length(equations) > MOST_LONGER * _length(motion.equations) + LONGEST_RATES:
        return motion
    rows = [r for r in configuration.rows if r not in used]
    if any(not e.expression.free_symbols.isdisjoint(through_rates) for e in equations):
        rows = list(configuration.rows)
    return replace(
        motion, closed=WithEliminatedRates(velocities, rule, equations, tuple(r.name for r in used), tuple(rows))
    )


def _mentions(row: Row, configuration: Configuration, through_rates: Sequence[sp.Symbol]) -> bool:
    """Whether such a coordinate or its velocity occurs in a constraint."""
    symbols = row.velocity_form(configuration.slots).free_symbols | (
        row.finite.free_symbols if row.finite is not None else set()
    )
    return any(q in symbols or prime(q) in symbols for q in through_rates)


def _velocities(
    configuration: Configuration, rows: Sequence[Row], through_rates: Sequence[sp.Symbol]
) -> dict[sp.Symbol, sp.Expr]:
    """Their velocities in terms of those of the chosen coordinates; empty if the constraints give other ones."""
    if not through_rates or any(r.finite is not None or r.nonlinear is not None for r in rows):
        return {}
    slots = configuration.slots
    indices = [slots.coordinates.index(q) for q in through_rates]
    try:
        solved = eliminate(rows, len(slots.coordinates), configuration.states, indices, LONGEST_RATES)
    except TooLongError:
        return {}
    if set(solved.dependent) != set(indices):
        return {}
    rates = {
        slots.velocities[d]: sp.Add(
            *(b * slots.velocities[k] for b, k in zip(row, solved.independent, strict=True)), drift
        )
        for d, row, drift in zip(solved.dependent, solved.solution, solved.drift, strict=True)
    }
    return {prime(q): rates[prime(q)] for q in through_rates}


def _substituted(equation: EquationOfMotion, rule: dict[sp.Symbol, sp.Expr], textbook: Textbook) -> EquationOfMotion:
    """The equation after the substitution, in textbook form; unchanged if there is nothing to substitute."""
    before = equation.expression
    if before.free_symbols.isdisjoint(rule):
        return replace(equation, factor=_NOTHING, reversed=False)
    ring = textbook.ring
    after = divided(textbook, equation.coordinate, ring.from_sympy(before.xreplace(rule)))
    scale = (-1 if after.reversed else 1) / after.factor.expression
    expression = after.expression
    for a in sorted((s for s in expression.free_symbols if is_acceleration(s)), key=str):
        # The coefficient of q'' is a sum of contributions, which may be shorter factored one by one than as a sum.
        shares = [before.diff(a), *(before.diff(e) * value.diff(a) for e, value in rule.items() if is_acceleration(e))]
        parts = sp.Add(*(textbook.form(ring.from_sympy(s * scale)) for s in shares if s != 0))
        if count_operations(parts) < count_operations(expression.diff(a)):
            expression = expression.xreplace({a: sp.S.Zero}) + parts * a
    return replace(after, expression=expression)


def _length(equations: Sequence[EquationOfMotion]) -> int:
    return sum(count_operations(e.expression) for e in equations)


@record
class LagrangeMotion(EquationsOfMotion):
    """The equations of motion of a configuration from its Lagrange equations.

    principle    T, V and the equations with multipliers
    used         indices of the rows that have a multiplier
    multipliers  of these, in textbook form, containing accelerations; None if they are too long
    right        Q_k + S_k + Σ λ_j a_jk, shape (n,), with named tensions instead of their multipliers
    forces       the values of `multipliers` in the same way: of the tension where the file names one
    """

    principle: Energies
    used: tuple[int, ...]
    multipliers: tuple[sp.Expr, ...] | None
    right: tuple[sp.Expr, ...] = ()
    forces: tuple[sp.Expr, ...] | None = None


def lagrange_motion(
    energies: Energies, elimination: Elimination, unknown: Collection[sp.Symbol] = ()
) -> LagrangeMotion:
    """Lagrange's equations of a configuration without multipliers; friction may contain those in `unknown`."""
    configuration = energies.configuration
    used = tuple(n for n in range(len(configuration.rows)) if n not in elimination.unused)
    forces = None if _has(energies.applied, unknown) else _multipliers(energies, elimination, used)
    if forces is None:
        equations = _combined(energies, elimination)
    else:
        free = (_without(energies, k, used, forces) for k in elimination.independent)
        equations = _equations(energies, elimination, free)
        if any(_is_split(e.expression) for e in equations):
            equations = tuple(map(_tidier, equations, _combined(energies, elimination)))
    return LagrangeMotion(
        configuration=configuration,
        principle=energies,
        elimination=elimination,
        equations=equations,
        used=used,
        multipliers=None if forces is None else tuple(over_one_denominator(energies.textbook.form(f)) for f in forces),
    )


def _equations(energies: Energies, elimination: Elimination, free: Iterable[Element]) -> tuple[EquationOfMotion, ...]:
    """The equations of the independent coordinates, divided by the common factors of their terms."""
    coordinates = energies.configuration.slots.coordinates
    pairs = zip(elimination.independent, free, strict=True)
    return tuple(divided(energies.textbook, coordinates[k], e) for k, e in pairs)


def _combined(energies: Energies, elimination: Elimination) -> tuple[EquationOfMotion, ...]:
    """The equations of motion from Σ_k L_k δq_k = 0."""
    return _equations(energies, elimination, of_independent(energies.coefficients, energies.ring, elimination))


def _is_split(expression: sp.Expr) -> bool:
    """Whether sums remain in denominators."""
    return any(p.base.is_Add and p.exp.could_extract_minus_sign() for p in expression.atoms(sp.Pow))


def _tidier(first: EquationOfMotion, second: EquationOfMotion) -> EquationOfMotion:
    """The shorter form of an equation: with the multipliers substituted, or combined, which may share a denominator."""
    forms = (first.expression, second.expression)
    split, other = (_is_split(e) for e in forms)
    if split != other:
        return second if split else first
    return second if count_operations(forms[1]) < count_operations(forms[0]) else first


def _has(forces: Iterable[sp.Expr], unknown: Collection[sp.Symbol]) -> bool:
    """Whether the forces contain an |λ|."""
    return any(not f.free_symbols.isdisjoint(unknown) for f in forces)


def _without(energies: Energies, k: int, used: Sequence[int], forces: Sequence[Element]) -> Element:
    """L_k − Σ_j λ_j a_jk, with the λ_j substituted."""
    ring, rows = energies.ring, energies.configuration.rows
    shares = (
        f * ring.from_sympy(rows[n].coefficients[k])
        for n, f in zip(used, forces, strict=True)
        if rows[n].coefficients[k] != 0
    )
    return energies.coefficients[k] - ring.total(shares)


def _multipliers(energies: Energies, elimination: Elimination, used: Sequence[int]) -> list[Element] | None:
    """The λ_j from Σ_j a_jd λ_j = L_d; None if they are too large."""
    if not used:
        return []
    rows, ring = energies.configuration.rows, energies.ring
    matrix = [[rows[n].coefficients[d] for n in used] for d in elimination.dependent]
    placeholders = [sp.Dummy(f"L_{d}", real=True) for d in elimination.dependent]
    solved = solved_linear(matrix, placeholders, energies.configuration.states)
    if solved is None:
        return None
    values: Mapping[sp.Symbol, Element] = {
        p: energies.coefficients[d] for p, d in zip(placeholders, elimination.dependent, strict=True)
    }
    forces = []
    for value in solved:
        if value is None:
            return None
        shares = ((ring.from_sympy(sp.diff(value, p)), left) for p, left in values.items() if value.has(p))
        forces.append(ring.total(share * left for share, left in shares))
    return forces
