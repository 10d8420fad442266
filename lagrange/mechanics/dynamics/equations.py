"""Equations of motion from d'Alembert's principle.

Where the δq_k are independent, each D_k vanishes. Where the constraints bind them, A δq = 0 gives the dependent ones,
δq_D = B δq_I, and what multiplies each independent δq_k vanishes:

    D_k + Σ_d B_dk D_d = 0 ,      together with the constraints.

Without elimination, each of the coordinates has an equation with multipliers:

    D_k = Σ_j λ_j a_jk .

Denominators are multiplied out and factors common to all terms divided out; both are recorded, because what is divided
by must not vanish.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field
from functools import cached_property
from typing import Any

import sympy as sp

from lagrange.algebra.exact.exact import NoPointError, Point, UnsupportedError
from lagrange.algebra.fourier.textbook import Factor, Textbook, common_factor, normalised
from lagrange.algebra.fourier.trigonometry import Element, Ring
from lagrange.core.diagnostics import Diagnostic, ProblemError, Span, UndecidedError
from lagrange.core.records import record
from lagrange.core.symbols import prime, variation
from lagrange.mechanics.constraints.displacements import Elimination
from lagrange.mechanics.constraints.kinematics import Configuration, Row
from lagrange.mechanics.dynamics.balance import Balance
from lagrange.mechanics.dynamics.principle import Principle


@record
class EquationOfMotion:
    """expression = 0, which multiplies the virtual displacement of `coordinate`.

    factor    what has been divided out: its numerator divided by, its denominator multiplied by
    reversed  whether the sign has been changed too
    """

    coordinate: sp.Symbol
    expression: sp.Expr
    factor: Factor
    reversed: bool


@record
class Closed:
    """The equations of a choice with velocities and accelerations put in that constraints on velocities give.

    velocities  each of these velocities, by the others
    rates       these velocities and their accelerations
    equations   of motion, all that is put in included; a factor is what was divided out after that
    used        the names of the constraints that the velocities come from
    rows        the constraints that complete the equations
    """

    velocities: Mapping[sp.Symbol, sp.Expr]
    rates: Mapping[sp.Symbol, sp.Expr]
    equations: tuple[EquationOfMotion, ...]
    used: tuple[str, ...]
    rows: tuple[Row, ...]


@record
class EquationsOfMotion:
    """The equations of one configuration; the rows of the configuration complete them.

    principle    what they follow from
    elimination  of the dependent virtual displacements
    equations    in all coordinates of the configuration, as they come from the principle
    closed       the same in the chosen coordinates, where some are known through their velocities only
    """

    configuration: Configuration
    principle: Balance
    elimination: Elimination
    equations: tuple[EquationOfMotion, ...]
    closed: Closed | None = field(default=None, kw_only=True)

    @property
    def expressions(self) -> tuple[sp.Expr, ...]:
        """Each of these is zero."""
        return tuple(e.expression for e in self.equations)

    @property
    def conditions(self) -> tuple[sp.Expr, ...]:
        """What has been divided by and may vanish: these equations are good where none of it does."""
        return excluded(self.elimination.pivots, (*self.equations, *(self.closed.equations if self.closed else ())))

    @property
    def final(self) -> tuple[EquationOfMotion, ...]:
        """The equations in which the derivation ends."""
        return self.closed.equations if self.closed else self.equations

    @property
    def completing(self) -> tuple[Row, ...]:
        """The constraints that complete these."""
        return self.closed.rows if self.closed else self.configuration.rows


@record
class WithMultipliers:
    """D_k and Σ_j λ_j a_jk, which it equals, for each coordinate."""

    multipliers: tuple[sp.Symbol, ...]
    equations: tuple[tuple[sp.Expr, sp.Expr], ...]


def excluded(pivots: Sequence[sp.Expr], equations: Sequence[EquationOfMotion]) -> tuple[sp.Expr, ...]:
    """The pivots and the factors that have been divided by, each once."""
    return tuple(dict.fromkeys((*pivots, *(f for e in equations for f in e.factor.nonzero))))


def equations_with_multipliers(principle: Balance, multipliers: Mapping[str, sp.Symbol]) -> WithMultipliers:
    """The equations in which nothing is eliminated; `multipliers` are λ_j by name of the constraint."""
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

    independent  shape (f,): what multiplies each independent δq
    """

    principle: Principle
    independent: tuple[Element, ...]

    @cached_property
    def reduced(self) -> sp.Expr:
        """Σ over the independent δq: the principle with the dependent ones put in, in textbook form."""
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


def of_independent(d: Sequence[Element], ring: Ring, elimination: Elimination) -> list[Element]:
    """D_k + Σ_d B_dk D_d for each independent k."""
    found = []
    for column, k in enumerate(elimination.independent):
        shares = (
            ring.from_sympy(row[column]) * d[dependent]
            for dependent, row in zip(elimination.dependent, elimination.solution, strict=True)
            if row[column] != 0
        )
        found.append(ring.total([d[k], *shares]))
    return found


def divided(textbook: Textbook, coordinate: sp.Symbol, coefficient: Element) -> EquationOfMotion:
    """The equation without common factors and common denominators, its leading acceleration positive."""
    expression = textbook.form(coefficient)
    factor = common_factor(expression)
    kept = factor.divide(expression)
    if any(f.is_Add for f, _ in factor.denominator.powers):
        shorter = factor.numerator.divide(expression)
        if shorter.count_ops() < kept.count_ops():  # what is gained by multiplying out is lost in length
            kept, factor = shorter, factor.numerator
    if factor.denominator.powers:
        kept = textbook.form(kept)
    leading = normalised(kept, [prime(coordinate, 2)])
    return EquationOfMotion(coordinate, leading, factor, leading != kept)


def check_inertia(result: EquationsOfMotion, span: Span | None = None) -> None:
    """Refuses a system whose equations do not determine the accelerations: a coordinate without inertia.

    Raises ProblemError naming the coordinate, UndecidedError where no generic point was found.
    """
    configuration = result.configuration
    slots = configuration.slots
    forms = [row.coefficients for row in configuration.rows]

    def idle_motions(point: Point) -> list[list[Any]]:
        inertia = point.affine(result.expressions, slots.accelerations)
        assert inertia is not None
        return point.nullspace([*(r[:-1] for r in inertia), *point.matrix(forms)], len(slots.coordinates))

    try:
        kernels = configuration.states.sampled(idle_motions, 2)
    except (NoPointError, UnsupportedError):
        raise UndecidedError("whether every coordinate has inertia", span) from None
    kernel = min(kernels, key=len)
    if not kernel:
        return
    idle = [q for k, q in enumerate(slots.coordinates) if any(v[k] != 0 for v in kernel)]
    listed = ", ".join(f"`{q}`" for q in idle)
    message = (
        f"{listed} can change without moving any mass"
        if len(idle) == 1
        else f"{listed} can change together without moving any mass"
    )
    help_ = "give a mass to what moves with it, or remove the coordinate; with `find: equilibrium` no mass is needed"
    raise ProblemError(Diagnostic("no-inertia", message, span, help=help_))
