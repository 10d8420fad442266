"""The problem in one set of coordinates, as Python wants it: SymPy objects with known shapes, and numbers.

All that is here has been found by `solve`; n coordinates, of which k are independent, m constraints that are left.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from types import MappingProxyType
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.api.given_functions import Given
from lagrange.api.numerical import RightHandSide, Values
from lagrange.api.time_functions import TIME, in_functions_of_time
from lagrange.core.diagnostics import Diagnostic, ProblemError
from lagrange.core.records import record
from lagrange.document.notation import Notation
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.motion import Motion
from lagrange.mechanics.dynamics.reactions import Reactions
from lagrange.mechanics.solution import ChoiceSolution, Solution
from lagrange.problem.model import Assumption, Parameter, Problem

if TYPE_CHECKING:
    from lagrange.core.vectors import Vector
    from lagrange.mechanics.dynamics.conservation import Integral
    from lagrange.mechanics.dynamics.quasi_verification import InSpeeds
    from lagrange.mechanics.dynamics.spot_values import Spot
    from lagrange.mechanics.equilibrium.equilibrium import Equilibrium
    from lagrange.mechanics.equilibrium.linearization import Linearization
    from lagrange.mechanics.equilibrium.stability import SecondVariation


@record
class Formulation:
    """The problem in one set of coordinates: the file's own, or those of a choice.

    Velocities and accelerations are symbols that are called `theta'` and `theta''`; `in_time` writes functions of time
    and their derivatives for them. What was not asked for is empty or None.

    problem   what was solved
    notation  how symbols are written
    found     the part of the solution that this is
    """

    problem: Problem
    notation: Notation
    found: Solution | ChoiceSolution

    @property
    def name(self) -> str:
        """The name of the choice; empty for the file's own coordinates."""
        return self.found.name if isinstance(self.found, ChoiceSolution) else ""

    @property
    def configuration(self) -> Configuration:
        """Positions, velocities, forces and constraints in these coordinates."""
        return (
            self.found.coordinates.configuration if isinstance(self.found, ChoiceSolution) else self.found.configuration
        )

    @property
    def coordinates(self) -> tuple[sp.Symbol, ...]:
        """q, shape (n,)."""
        return self.configuration.slots.coordinates

    @property
    def velocities(self) -> tuple[sp.Symbol, ...]:
        """q', shape (n,)."""
        return self.configuration.slots.velocities

    @property
    def accelerations(self) -> tuple[sp.Symbol, ...]:
        """q'', shape (n,)."""
        return self.configuration.slots.accelerations

    @property
    def substitution(self) -> Mapping[sp.Symbol, sp.Expr]:
        """Each coordinate of the file that is replaced, in the present ones."""
        return MappingProxyType(dict(self.configuration.expressed))

    @property
    def signs(self) -> tuple[sp.Symbol, ...]:
        """The signs ±1 of square roots that these coordinates leave open."""
        return self.found.coordinates.signs if isinstance(self.found, ChoiceSolution) else ()

    @property
    def constraints(self) -> tuple[sp.Expr, ...]:
        """What the coordinates still have to satisfy, each zero, shape (m,): g(q, t), or φ(q, q', t)."""
        slots = self.configuration.slots
        return tuple(r.velocity_form(slots) if r.finite is None else r.finite for r in self.configuration.rows)

    @property
    def equations(self) -> tuple[sp.Expr, ...]:
        """The equations of motion, each zero, shape (k,); `constraints` complete them."""
        return () if self.found.motion is None else tuple(e.expression for e in self.found.motion.final)

    @property
    def conditions(self) -> tuple[sp.Expr, ...]:
        """What has been divided by and may vanish: the equations are good where none of it does."""
        return () if self.found.motion is None else self.found.motion.conditions

    @property
    def equations_with_multipliers(self) -> tuple[sp.Eq, ...]:
        """D_k = Σ λ_j a_jk for each coordinate, shape (n,); empty where no constraint is left."""
        found = self.found.dynamics.with_multipliers if self.found.dynamics else None
        return () if found is None else tuple(sp.Eq(a, b, evaluate=False) for a, b in found.equations)

    @property
    def multipliers(self) -> tuple[sp.Symbol, ...]:
        """λ of the constraints that are left, shape (m,)."""
        found = self.found.dynamics.with_multipliers if self.found.dynamics else None
        return () if found is None else found.multipliers

    @property
    def mass_matrix(self) -> sp.ImmutableMatrix:
        """M of M q'' = f + Aᵀ λ, shape (n, n), symmetric. Raises ProblemError where no motion was asked for."""
        return sp.ImmutableMatrix(self._dynamics.matrices.mass)

    @property
    def force_vector(self) -> sp.ImmutableMatrix:
        """f, shape (n, 1): applied forces, and the terms of the inertia with velocities."""
        return sp.ImmutableMatrix(self._dynamics.matrices.force)

    @property
    def constraint_matrix(self) -> sp.ImmutableMatrix:
        """A of A q'' = b, shape (m, n); m is 0 where the coordinates are independent."""
        rows = self._dynamics.matrices.constraint_matrix
        return sp.ImmutableMatrix(len(rows), len(self.coordinates), [a for row in rows for a in row])

    @property
    def constraint_vector(self) -> sp.ImmutableMatrix:
        """b, shape (m, 1)."""
        vector = self._dynamics.matrices.constraint_vector
        return sp.ImmutableMatrix(len(vector), 1, list(vector))

    @property
    def solved(self) -> Mapping[sp.Symbol, sp.Expr]:
        """q'' -> its value in q, q' and t; empty where that would be long. `right_hand_side` does without."""
        return MappingProxyType(dict(self.found.dynamics.accelerations) if self.found.dynamics else {})

    @property
    def reactions(self) -> Mapping[str, sp.Expr | None]:
        """The multiplier of each constraint of the file in q, q' and t; None where it is too long to be written."""
        return MappingProxyType(dict(self._reactions.multipliers) if self._reactions else {})

    @property
    def tensions(self) -> Mapping[str, sp.Expr]:
        """The tension of each constraint that is a rod: positive where it pulls."""
        return MappingProxyType(dict(self._reactions.tensions) if self._reactions else {})

    @property
    def reaction_forces(self) -> Mapping[str, Mapping[str, Vector]]:
        """The force of each constraint on each particle and body: a `Vector`, with `components` of shape (3,)."""
        return MappingProxyType(dict(self._reactions.forces) if self._reactions else {})

    @property
    def conserved(self) -> tuple[Integral, ...]:
        """First integrals: each with its `expression` in q, q' and t, its `quantity`, and `because`."""
        return self.found.conserved.integrals if self.found.conserved else ()

    @property
    def equilibrium(self) -> Equilibrium | None:
        """Positions of equilibrium: `branches`, each with `equations` and `conditions`."""
        return self.found.equilibrium

    @property
    def stability(self) -> SecondVariation | None:
        """Their stability: `verdicts`, one a branch."""
        return self.found.stability

    @property
    def linearization(self) -> Linearization | None:
        """Small oscillations."""
        return self.found.linearization

    @property
    def in_speeds(self) -> InSpeeds | None:
        """The kinematic equations and the equations of motion in the quasi-velocities of the file."""
        return self.found.in_speeds

    @property
    def spot(self) -> Spot | None:
        """Numbers in, accelerations out: `values` and `accelerations`."""
        return self.found.spot

    def in_time(self, expression: sp.Expr, time: sp.Symbol = TIME) -> sp.Expr:
        """An expression with functions of time: `theta''` as `Derivative(theta(t), (t, 2))`; t is `Symbol("t")`.

        That is what `sympy.physics.mechanics.dynamicsymbols` makes. Multipliers stay symbols.
        """
        return in_functions_of_time(expression, self.configuration.slots, time)

    def equations_in_time(self, time: sp.Symbol = TIME) -> tuple[sp.Eq, ...]:
        """The equations of motion, then the constraints, in functions of time, shape (k + m,)."""
        whole = (*self.equations, *self.constraints)
        return tuple(sp.Eq(self.in_time(e, time), sp.S.Zero, evaluate=False) for e in whole)

    def right_hand_side(
        self,
        values: Values = MappingProxyType({}),
        *,
        functions: Mapping[str, Given] = MappingProxyType({}),
        speeds: bool = False,
        stabilised: float = 0.0,
        module: str = "math",
    ) -> RightHandSide:
        """The equations of motion as a function dy/dt = f(t, y), with y = (q, q') of shape (2 n,).

        values      a number for each parameter, by name or symbol; a `value` of the problem file need not be repeated
        functions   what undefined functions, prescribed motions and unknown forces are, by name (`given_functions`)
        speeds      in quasi-velocities: y = (q, u), of shape (n + k,)
        stabilised  α: what the constraints are off by dies out like exp(−α t); 0: they are only differentiated
        module      "math", or "numpy" for arrays, where that is installed

        Constraints that are left are differentiated, and their multipliers eliminated in numbers. Raises ValueError
        where a number or a function is missing or not admitted, ProblemError where there are no equations of motion.
        """
        from lagrange.api.first_order import in_coordinates, in_speeds

        if stabilised < 0:
            raise ValueError(f"`stabilised` is a rate, 0 or more, and not {stabilised!r}")
        _check_names(functions, self.problem)
        if not speeds:
            equations = in_coordinates(self._dynamics, stabilised)
        elif self.in_speeds is None or self.in_speeds.equations is None:
            raise ValueError("there are no quasi-velocities here: the problem declares them under `speeds`")
        elif stabilised:
            raise ValueError("`stabilised` goes with coordinates and their velocities, not with quasi-velocities")
        else:
            equations = in_speeds(self.in_speeds.equations)
        parameters = (*self.problem.parameters, *self._open_signs)
        return RightHandSide(equations, parameters, values, functions, module, self.problem.unknowns)

    @cached_property
    def _dynamics(self) -> Motion:
        if self.found.dynamics is None:
            message = "the problem asks for no motion: there are no equations of motion"
            raise ProblemError(
                Diagnostic("no-equations", message, help="give the problem masses, and leave `find` out")
            )
        return self.found.dynamics

    @property
    def _open_signs(self) -> tuple[Parameter, ...]:
        """The signs that the coordinates or friction leave open, as parameters."""
        branches = (Parameter(s, Assumption.SIGN, meaning="+1 or -1: the branch of a square root") for s in self.signs)
        senses = (
            Parameter(s, Assumption.SIGN, meaning=f"+1 or -1: the sign of {e}") for s, e in self._dynamics.signs.items()
        )
        return (*branches, *senses)

    @property
    def _reactions(self) -> Reactions | None:
        return self.found.dynamics.reactions if self.found.dynamics else None

    def __repr__(self) -> str:
        listed = ", ".join(q.name for q in self.coordinates)
        where = f"choice {self.name}" if self.name else "the file's own coordinates"
        return f"<Formulation in {listed}: {where}>"

    def _repr_markdown_(self) -> str:
        """What a notebook shows: the equations of motion and the constraints."""
        from lagrange.document.math_writer import latex

        whole = (*self.equations, *self.constraints)
        return "\n\n".join(f"$$\n{latex(e, self.notation)} = 0\n$$" for e in whole) or repr(self)


def _check_names(functions: Mapping[str, Given], problem: Problem) -> None:
    """Refuses a function for which the problem has no name."""
    known = [*(f.name for f in problem.functions), *(u.name for u in (*problem.slots.prescribed, *problem.unknowns))]
    for name in functions:
        if name not in known:
            listed = f"those of the problem are {', '.join(known)}" if known else "the problem has none"
            raise ValueError(f"there is no function `{name}`; {listed}")
