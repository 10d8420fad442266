"""Relative equilibria: the equilibria of the equations of motion.

With q' = q'' = 0 the equations of motion become conditions for q_0: the forces balance, including the inertial forces
of a prescribed uniform rotation. A bead on a hoop rotating at ω has m R² ω² sin θ cos θ besides its weight; these are
the forces of an effective potential. Positions may contain time as long as it cancels from the equations.

Only rest in the coordinates is meant; steady motions, in which a coordinate grows at a constant rate, are found in
`momenta.steady_motions`.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product

import sympy as sp

from lagrange.algebra.closed_forms.single_equation import Relation
from lagrange.algebra.closed_forms.solution_sets import Branch
from lagrange.algebra.closed_forms.unit_circle import NotAlgebraicError
from lagrange.algebra.exact.zero_test import DivisionByZeroError, is_zero
from lagrange.algebra.fourier.ring import FourierRing
from lagrange.algebra.fourier.textbook_form import Textbook
from lagrange.core.diagnostics import NotCoveredError
from lagrange.core.expression_size import count_operations
from lagrange.core.symbols import base, t, variation
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.equations import EquationsOfMotion
from lagrange.mechanics.dynamics.matrix_form import MatrixForm
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium, VirtualWork, equilibrium, is_balanced
from lagrange.mechanics.equilibrium.limits import LONGEST_UNSOLVED, MOST_TRIVIAL_COORDINATES

ZERO = sp.S.Zero
_RELATIVE = (
    "give coordinates that go along with it: `generalized_coordinates: {relative: {coordinates: [x], "
    "substitute: {phi: Omega*t}}}`"
)


def equilibria_of_motion(form: MatrixForm, motion: EquationsOfMotion) -> Equilibrium:
    """The equilibria; the forces of the result are the equations of motion at rest, −D_k.

    Raises NotCoveredError if the equations depend on time.
    """
    return equilibrium(motion.configuration, motion.elimination, work=_forces_at_rest(form))


def branches_at_rest(resting: Equilibrium) -> tuple[tuple[Branch, ...], bool]:
    """The branches, and whether they are all; instead of long unsolved conditions the trivial ones at 0 and π."""
    long = [b for b in resting.branches if sum(count_operations(e) for e in b.left) > LONGEST_UNSOLVED]
    if not long:
        return resting.branches, resting.solution.solved
    kept = [b for b in resting.branches if b not in long]
    stated = [set(b.relations) for b in kept]
    trivial = [b for b in _at_zero(resting) if not any(s <= set(b.relations) for s in stated)]
    return (*kept, *trivial), False


def _at_zero(resting: Equilibrium) -> Iterator[Branch]:
    """The equilibria of independent coordinates with each coordinate 0 or, for an angle, π."""
    letters = resting.solution.letters
    coordinates = resting.configuration.slots.coordinates
    if resting.configuration.rows or len(coordinates) > MOST_TRIVIAL_COORDINATES:
        return
    angles = {q for q in coordinates if q in letters.angles and letters.angles[q].measure == q}
    # The conditions were multiplied by lengths of springs, which may vanish; where they do, forces have no value.
    divisors = {p.base for q in resting.work.forces for p in q.atoms(sp.Pow) if p.exp.is_negative}
    for place in product(*(((ZERO, sp.pi) if q in angles else (ZERO,)) for q in coordinates)):
        point: dict[sp.Symbol, sp.Expr] = {}
        for q, value in zip(coordinates, place, strict=True):
            if q in angles:
                point |= {letters.angles[q].cosine: sp.cos(value), letters.angles[q].sine: ZERO}
            point |= {q: value}
        try:
            regular = all(is_zero(resting.solution.at(point, d)) is False for d in divisors)
            holds = is_balanced(resting, lambda e, p=point: resting.solution.at(p, e))  # type: ignore[misc]
        except (NotAlgebraicError, DivisionByZeroError):
            continue
        if regular and holds:
            relations = tuple(Relation(q, value) for q, value in zip(coordinates, place, strict=True))
            yield Branch(relations, (), (point,), point)


def require_possible_rest(configuration: Configuration) -> None:
    """Refuse constraints that exclude rest or are not linear in the velocities."""
    for row in configuration.rows:
        if row.nonlinear is not None:
            raise NotCoveredError(f"small oscillations with `{row.name}`, which is not linear in the velocities,")
        symbols = {s for e in row.form for s in e.free_symbols}
        if row.drift != 0 or any(is_time(s, configuration) for s in symbols):
            what = f"small oscillations in coordinates that the moving constraint `{row.name}` binds"
            raise NotCoveredError(what, cure=_RELATIVE)


def is_time(symbol: sp.Symbol, configuration: Configuration) -> bool:
    """Whether a symbol is t or a prescribed motion."""
    return symbol == t or base(symbol) in configuration.slots.prescribed


def _forces_at_rest(form: MatrixForm) -> VirtualWork:
    """The equations of motion at rest, −D_k, as the virtual work of forces. Raises NotCoveredError."""
    configuration = form.configuration
    slots = configuration.slots
    at_rest = dict.fromkeys(slots.velocities, sp.S.Zero)
    forces = [without_time(f.xreplace(at_rest), configuration) for f in form.force]
    ring = FourierRing()
    textbook = Textbook(ring)
    coefficients = tuple(ring.from_sympy(f) for f in forces)
    displacements = [ring.from_sympy(variation(q)) for q in slots.coordinates]
    statement = ring.total(q * v for q, v in zip(coefficients, displacements, strict=True))
    return VirtualWork(coefficients, tuple(textbook.form(q) for q in coefficients), textbook.form(statement), textbook)


def without_time(e: sp.Expr, configuration: Configuration) -> sp.Expr:
    """An expression after cancelling time. Raises NotCoveredError if it does not cancel."""
    if any(s != t and is_time(s, configuration) for s in e.free_symbols):
        raise NotCoveredError("small oscillations under a prescribed motion that is not uniform")
    if t not in e.free_symbols:
        return e
    if not configuration.surface.is_zero(e.diff(t)):
        raise NotCoveredError("small oscillations where the equations of motion contain time")
    return e.xreplace({t: ZERO})
