"""A solved problem in one set of coordinates, for Python programs: SymPy objects of known shapes, and numbers.

There are n coordinates, of which k are independent, and m constraints that they do not satisfy identically. Nothing is
calculated here that `solve` has not found, except numbers.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import field
from functools import cached_property
from types import MappingProxyType
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.api.notebook import Equations, Formula, coordinates_in_html, equation_of, formula
from lagrange.api.numerical import RightHandSide, Values
from lagrange.api.time_functions import TIME, Given, in_functions_of_time
from lagrange.core.diagnostics import Diagnostic, ProblemError
from lagrange.core.mime import Shown
from lagrange.core.records import record
from lagrange.document.derivation import Picture
from lagrange.document.names import Notation
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.motion import Motion
from lagrange.mechanics.dynamics.reactions import Reactions
from lagrange.mechanics.results import InCoordinates
from lagrange.problem.model import Assumption, Parameter, Problem

if TYPE_CHECKING:
    from lagrange.core.vectors import Vector
    from lagrange.mechanics.constraints.variable_mass import VariableMass
    from lagrange.mechanics.dynamics.conservation import Integral
    from lagrange.mechanics.dynamics.equations import WithMultipliers
    from lagrange.mechanics.dynamics.quasi_equations import QuasiVelocityForm
    from lagrange.mechanics.dynamics.spot_values import SpotValue
    from lagrange.mechanics.equilibrium.equilibrium import Equilibrium
    from lagrange.mechanics.equilibrium.linearization import Linearization
    from lagrange.mechanics.equilibrium.response import Response
    from lagrange.mechanics.equilibrium.stability import SecondVariation
    from lagrange.mechanics.momenta.hamiltonian import Hamiltonian
    from lagrange.mechanics.momenta.steady_motions import SteadyMotions


@record
class Formulation(Shown):
    """The problem in one set of coordinates: the file's own, or those of a choice.

    Velocities and accelerations are symbols named `theta'` and `theta''`; `in_time` replaces them by derivatives of
    functions of time. What was not asked for is empty or None.

    problem   the problem that was solved
    notation  how symbols are written
    view      the solution in these coordinates
    figure    finds the picture of the system in them
    """

    problem: Problem
    notation: Notation
    view: InCoordinates
    figure: Callable[[], Picture | None] = field(default=lambda: None, compare=False)

    @property
    def name(self) -> str:
        """The name of the choice; empty for the file's own coordinates."""
        return self.view.name

    @property
    def configuration(self) -> Configuration:
        """Positions, velocities, forces and constraints in these coordinates."""
        return self.view.configuration

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
        """Each replaced coordinate of the file in terms of the present ones."""
        return MappingProxyType(dict(self.configuration.expressed))

    @property
    def signs(self) -> tuple[sp.Symbol, ...]:
        """The signs ±1 of square roots that these coordinates leave open."""
        return self.view.signs

    @property
    def constraints(self) -> Equations:
        """The constraints on these coordinates, each zero, shape (m,): g(q, t), or φ(q, q', t)."""
        slots, rows = self.configuration.slots, self.configuration.rows
        return Equations((r.velocity_form(slots) if r.finite is None else r.finite for r in rows), self.notation)

    @property
    def equations(self) -> Equations:
        """The equations of motion, each zero, shape (k,); `constraints` complete them."""
        final = () if self.view.motion is None else self.view.motion.final
        return Equations((e.expression for e in final), self.notation)

    @property
    def conditions(self) -> tuple[sp.Expr, ...]:
        """The divisors that may vanish, shape (c,): the equations of motion hold where none of them does."""
        return () if self.view.motion is None else self.view.motion.conditions

    @property
    def equations_with_multipliers(self) -> Equations:
        """D_k = Σ λ_j a_jk for each coordinate, shape (n,); empty if no constraint is left."""
        pairs = () if self._with_multipliers is None else self._with_multipliers.equations
        return Equations((sp.Eq(a, b, evaluate=False) for a, b in pairs), self.notation)

    @property
    def multipliers(self) -> tuple[sp.Symbol, ...]:
        """λ of the constraints that are left, shape (m,)."""
        form = self._with_multipliers
        return () if form is None else form.multipliers

    @property
    def mass_matrix(self) -> sp.ImmutableMatrix:
        """M of M q'' = f + Aᵀ λ, shape (n, n), symmetric. Raises ProblemError if no motion was asked for."""
        return sp.ImmutableMatrix(self._dynamics.matrices.mass)

    @property
    def force_vector(self) -> sp.ImmutableMatrix:
        """f, shape (n, 1): applied forces and velocity terms of the inertia."""
        return sp.ImmutableMatrix(self._dynamics.matrices.force)

    @property
    def constraint_matrix(self) -> sp.ImmutableMatrix:
        """A of A q'' = b, shape (m, n); m is 0 if the coordinates are independent."""
        rows = self._dynamics.matrices.constraint_matrix
        return sp.ImmutableMatrix(len(rows), len(self.coordinates), [a for row in rows for a in row])

    @property
    def constraint_vector(self) -> sp.ImmutableMatrix:
        """b, shape (m, 1)."""
        vector = self._dynamics.matrices.constraint_vector
        return sp.ImmutableMatrix(len(vector), 1, list(vector))

    @property
    def solved(self) -> Mapping[sp.Symbol, sp.Expr]:
        """q'' in terms of q, q' and t; empty if that would be long. `right_hand_side` does not need it."""
        return MappingProxyType(dict(self.view.dynamics.accelerations) if self.view.dynamics else {})

    @property
    def reactions(self) -> Mapping[str, sp.Expr | None]:
        """The multiplier of each constraint of the file in q, q' and t; None if it is too long to be written."""
        return MappingProxyType(dict(self._reactions.multipliers) if self._reactions else {})

    @property
    def tensions(self) -> Mapping[str, sp.Expr]:
        """The tension of each constraint that keeps a length, positive if it pulls."""
        return MappingProxyType(dict(self._reactions.tensions) if self._reactions else {})

    @property
    def reaction_forces(self) -> Mapping[str, Mapping[str, Vector]]:
        """The force of each constraint on each particle and body: a `Vector`, with `components` of shape (3,)."""
        return MappingProxyType(dict(self._reactions.forces) if self._reactions else {})

    @property
    def conserved(self) -> tuple[Integral, ...]:
        """First integrals: each with its `expression` in q, q' and t, its `quantity`, and `because`."""
        return self.view.conserved.integrals if self.view.conserved else ()

    @property
    def equilibrium(self) -> Equilibrium | None:
        """Positions of equilibrium: `branches`, each with `equations` and `conditions`."""
        return self.view.equilibrium

    @property
    def stability(self) -> SecondVariation | None:
        """Their stability: `verdicts`, one for each branch."""
        return self.view.stability

    @property
    def hamiltonian(self) -> Hamiltonian | None:
        """Hamilton's function and equations, if the problem asks for them."""
        return self.view.hamiltonian

    @property
    def steady(self) -> SteadyMotions | None:
        """Steady motions, if the problem asks for them: `families`, each with its conditions and `about`."""
        return self.view.steady

    @property
    def response(self) -> Response | None:
        """The steady state under a harmonic drive: `amplitudes`, `phases` and `motions`, shape (n,) each."""
        return self.view.response

    @property
    def variable_masses(self) -> tuple[VariableMass, ...]:
        """The particles of variable mass: `name`, `mass`, `rate`, and the `velocity` of the exchanged mass."""
        return self.configuration.variable_masses

    @property
    def linearization(self) -> Linearization | None:
        """Small oscillations."""
        return self.view.linearization

    @property
    def in_speeds(self) -> QuasiVelocityForm | None:
        """The kinematic equations and the equations of motion in the quasi-velocities of the file."""
        return self.view.in_speeds

    @property
    def spot(self) -> SpotValue | None:
        """Numbers in, accelerations out: `values` and `accelerations`."""
        return self.view.spot

    def formula(self, *sides: object) -> Formula:
        """a = b = c in the notation of the problem, which a notebook shows: `formula(angle.tensions["rod"])`.

        Sides are expressions, vectors or numbers; one `Eq` is a formula too. Raises TypeError at anything else.
        """
        return formula(sides, self.notation)

    def in_time(self, expression: sp.Expr, time: sp.Symbol = TIME) -> sp.Expr:
        """An expression with functions of time: `theta''` as `Derivative(theta(t), (t, 2))`; t is `Symbol("t")`.

        That is what `sympy.physics.mechanics.dynamicsymbols` makes. Multipliers stay symbols.
        """
        return in_functions_of_time(expression, self.configuration.slots, time)

    def equations_in_time(self, time: sp.Symbol = TIME) -> tuple[sp.Eq, ...]:
        """The equations of motion, then the constraints, in functions of time, shape (k + m,)."""
        expressions = (*self.equations, *self.constraints)
        return tuple(sp.Eq(self.in_time(e, time), sp.S.Zero, evaluate=False) for e in expressions)

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
        functions   undefined functions, prescribed motions and unknown forces by name (`time_functions`)
        speeds      in quasi-velocities: y = (q, u), of shape (n + k,)
        stabilised  α, with which violations of the constraints decay like exp(−α t); 0: these are only differentiated
        module      "math", or "numpy" for arrays, if that is installed

        Constraints that are left are differentiated, and their multipliers eliminated numerically. Raises ValueError if
        a number or a function is missing or not admissible, ProblemError if there are no equations of motion.
        """
        from lagrange.api.numerical import in_coordinates
        from lagrange.programs.first_order import in_speeds

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
        if self.view.dynamics is None:
            message = "the problem asks for no motion: there are no equations of motion"
            raise ProblemError(
                Diagnostic("no-equations", message, help="give the problem masses, and leave `find` out")
            )
        return self.view.dynamics

    @property
    def _open_signs(self) -> tuple[Parameter, ...]:
        """The signs that the coordinates or friction leave open, as parameters."""
        branches = (Parameter(s, Assumption.SIGN, meaning="+1 or -1: the branch of a square root") for s in self.signs)
        senses = (
            Parameter(s, Assumption.SIGN, meaning=f"+1 or -1: the sign of {e}") for s, e in self._dynamics.signs.items()
        )
        return (*branches, *senses)

    @property
    def _with_multipliers(self) -> WithMultipliers | None:
        return self.view.dynamics.with_multipliers if self.view.dynamics else None

    @property
    def _reactions(self) -> Reactions | None:
        return self.view.dynamics.reactions if self.view.dynamics else None

    def __repr__(self) -> str:
        listed = ", ".join(q.name for q in self.coordinates)
        where = f"choice {self.name}" if self.name else "the file's own coordinates"
        return f"<Formulation in {listed}: {where}>"

    def _repr_html_(self) -> str:
        """The figure, the coordinates that are replaced, the equations of motion and the constraints."""
        equations = [equation_of(e) for e in (*self.equations, *self.constraints)]
        title = f"{self.problem.title}: {self.name}" if self.name else self.problem.title
        return coordinates_in_html(title, self.notation, self.substitution.items(), equations, self.figure())

    def _repr_latex_(self) -> str | None:
        return Equations((*self.equations, *self.constraints), self.notation)._repr_latex_()

    def _repr_markdown_(self) -> str:
        """The equations of motion and the constraints, where a notebook shows neither HTML nor TeX."""
        from lagrange.document.math_writer import latex

        expressions = (*self.equations, *self.constraints)
        return "\n\n".join(f"$$\n{latex(e, self.notation)} = 0\n$$" for e in expressions) or repr(self)


def _check_names(functions: Mapping[str, Given], problem: Problem) -> None:
    """Raises ValueError at a function that the problem does not declare."""
    known = [*(f.name for f in problem.functions), *(u.name for u in (*problem.slots.prescribed, *problem.unknowns))]
    for name in functions:
        if name not in known:
            listed = f"those of the problem are {', '.join(known)}" if known else "the problem has none"
            raise ValueError(f"there is no function `{name}`; {listed}")
