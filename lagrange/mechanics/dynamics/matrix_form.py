"""The equations of motion in matrix form, and solved for the accelerations.

D'Alembert's principle gives for each coordinate an expression D_k that is linear in the accelerations. With the
constraints, differentiated until accelerations occur,

    M q'' = f + Aᵀ λ ,      A q'' = b .

M is the symmetric matrix of the kinetic energy T = ½ q'ᵀ M q' + ...; f contains the applied forces and the inertial
terms with velocities. If the coordinates are independent, there is no A, and q'' = M⁻¹ f.

Shapes: M (n, n), f (n,), A (m, n), b (m,).
"""

from __future__ import annotations

import sympy as sp

from lagrange.algebra.fourier.elements import Element
from lagrange.algebra.fourier.linear_systems import solved_linear
from lagrange.core.records import record
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.equations import EquationsOfMotion
from lagrange.mechanics.dynamics.limits import MOST_FREE
from lagrange.mechanics.dynamics.reactions import over_one_denominator


@record
class MatrixForm:
    """M, f, A, b; A and b are empty if the coordinates are independent."""

    configuration: Configuration
    mass: tuple[tuple[sp.Expr, ...], ...]
    force: tuple[sp.Expr, ...]
    constraint_matrix: tuple[tuple[sp.Expr, ...], ...]
    constraint_vector: tuple[sp.Expr, ...]


def matrix_form(motion: EquationsOfMotion) -> MatrixForm:
    """The matrices of the equations of motion, before factors are divided out."""
    configuration, principle = motion.configuration, motion.principle
    slots = configuration.slots
    form = principle.textbook.form
    written: dict[Element, sp.Expr] = {}  # M is symmetric: most of its entries occur twice
    mass, force = [], []
    for element in principle.coefficients:
        coefficients, rest = principle.ring.linear(element, slots.accelerations)
        written |= {c: form(c) for c in coefficients if c not in written}
        mass.append(tuple(written[c] for c in coefficients))
        force.append(form(-rest))
    no_acceleration = dict.fromkeys(slots.accelerations, sp.S.Zero)
    rates = (rate.xreplace(no_acceleration) for rate in configuration.accelerated_constraints)
    return MatrixForm(
        configuration,
        tuple(mass),
        tuple(force),
        tuple(r.coefficients for r in configuration.rows),
        tuple(form(-rate) for rate in rates),
    )


def may_be_solved(configuration: Configuration) -> bool:
    """Whether the accelerations can be written as functions of the state: few coordinates, and no constraints."""
    return not configuration.rows and len(configuration.slots.coordinates) <= MOST_FREE


def solved_accelerations(form: MatrixForm) -> dict[sp.Symbol, sp.Expr]:
    """q'' = M⁻¹ f of independent coordinates; empty if there are constraints, or if it is too large."""
    slots = form.configuration.slots
    if not may_be_solved(form.configuration):
        return {}
    solved = solved_linear(form.mass, form.force, form.configuration.states)
    if solved is None or None in solved:
        return {}
    pairs = zip(slots.accelerations, solved, strict=True)
    return {a: over_one_denominator(e) for a, e in pairs if e is not None}
