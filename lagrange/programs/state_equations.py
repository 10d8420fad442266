"""The equations of motion as first-order equations for the state y = (q, s).

The speeds s are the velocities q', or the quasi-velocities u of the file. With the multipliers λ of the constraints
that the coordinates do not satisfy identically,

    q' = r(q, s, t) ,     M s' − Aᵀ λ = f ,     A s' = b ,

where b contains the time derivatives of the coefficients: the constraints A s + a_t = 0, differentiated once. Finite
relations g(q, t) = 0 among them have A = ∂g/∂q. In independent coordinates, and in quasi-velocities, there is no A.

An integration keeps the differentiated constraints up to its errors; to be exact, positions are brought back to g = 0,
speeds to A s + a_t = 0. Energy, conserved quantities, reactions and multipliers are expressions of the state.

Shapes: n coordinates, p speeds, m multipliers; r (n,), M (p, p), f (p,), A (m, p), a_t (m,), b (m,).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import field, replace
from functools import cached_property

import sympy as sp

from lagrange.core.diagnostics import Diagnostic, NotCoveredError, ProblemError
from lagrange.core.expression_size import distinct_parts
from lagrange.core.records import record
from lagrange.core.symbols import Sign, Slots, Unspecified, base, prime, t
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.conservation import Conserved, conserved
from lagrange.mechanics.dynamics.motion import Motion, NewtonLaw, motion
from lagrange.mechanics.dynamics.newton import Reaction
from lagrange.mechanics.results import InCoordinates, Solution
from lagrange.problem.model import Assumption, Parameter, Problem
from lagrange.programs.contacts import Contact, contacts
from lagrange.programs.first_order import FirstOrderEquations, in_coordinates, in_speeds, long_energy, long_first_order


@record
class StateEquations:
    """A motion as first-order equations, with what can be calculated along it.

    view        the coordinates, the file's own or those of a choice
    equations   in symbols
    parameters  those that occur, signs that the derivation leaves open among them
    functions   names of the undefined functions and prescribed motions that occur: they must be given
    energy      T + V; None if there is no potential
    conserved   what stays constant, by name: `energy`, `p_theta`, ...
    reactions   forces of constraint by the names of the page, in state, parameters and multipliers
    contacts    the reactions that are watched
    exchanges   by name of a particle: the mass that joins or leaves per time, positive as long as the equations hold
    masses      by name of a particle whose mass varies: its mass, positive as long as the equations hold
    slips       speeds of slip, positive in the sense for which the file has written its friction
    plane_slips of what slips in a plane, the components of the velocities of slip
    signs       each open sign of a reaction, with the expression whose sign it is
    branches    the signs of square roots that the coordinates leave open
    given       expressions that have taken the place of undefined functions and prescribed motions, by name
    before      the equations before these took their place
    idle        of the reactions that are always zero, by name: the force, its multiplier, and the rate of the
                constraint, whose product with the multiplier is a power
    """

    problem: Problem
    view: InCoordinates
    configuration: Configuration
    equations: FirstOrderEquations
    energy: sp.Expr | None = None
    conserved: Mapping[str, sp.Expr] = field(default_factory=dict)
    reactions: Mapping[str, sp.Expr] = field(default_factory=dict)
    contacts: tuple[Contact, ...] = ()
    slips: tuple[sp.Expr, ...] = ()
    plane_slips: tuple[tuple[sp.Expr, ...], ...] = ()
    exchanges: Mapping[str, sp.Expr] = field(default_factory=dict)
    masses: Mapping[str, sp.Expr] = field(default_factory=dict)
    signs: Mapping[Sign, sp.Expr] = field(default_factory=dict)
    branches: tuple[Sign, ...] = ()
    given: Mapping[str, sp.Expr] = field(default_factory=dict)
    before: StateEquations | None = None
    idle: Mapping[str, tuple[sp.Expr, sp.Symbol, sp.Expr]] = field(default_factory=dict)

    @property
    def open(self) -> StateEquations:
        """The equations with the undefined functions and prescribed motions of the file."""
        return self if self.before is None else self.before

    @property
    def name(self) -> str:
        """The name of the choice of coordinates; empty for the file's own."""
        return self.view.name

    @property
    def state(self) -> tuple[sp.Symbol, ...]:
        """The components of y."""
        return self.equations.state

    @cached_property
    def expressions(self) -> tuple[sp.Expr, ...]:
        """All that a program has to evaluate for dy/dt, and to keep the constraints."""
        e = self.equations
        flat = (entry for row in e.matrix for entry in row)
        return (*e.rates, *flat, *e.right, *e.kept)

    @cached_property
    def parameters(self) -> tuple[Parameter, ...]:
        """The parameters that occur, in the order of the file; then open signs and unknown forces."""
        watched = (*(c.value for c in self.contacts), *self.exchanges.values(), *self.masses.values())
        more = (*self.conserved.values(), *self.reactions.values(), *watched)
        used = _symbols((*self.expressions, *more, *([self.energy] if self.energy is not None else [])))
        declared = [p for p in self.problem.parameters if p.symbol in used]
        signs = [Parameter(s, Assumption.SIGN, meaning="+1 or -1") for s in (*self.branches, *self.signs) if s in used]
        forces = [Parameter(s, Assumption.REAL, meaning="a force") for s in self.problem.unknowns if s in used]
        return (*declared, *signs, *forces)

    @cached_property
    def functions(self) -> tuple[str, ...]:
        """The names of undefined functions f(X, Y) and prescribed motions u(t) that occur."""
        occurring = {f.name for f in distinct_parts(self.expressions) if isinstance(f, Unspecified)}
        names = [f.name for f in self.problem.functions if f.name in occurring]
        prescribed = {*self.equations.slots.prescribed}
        moved = {base(s).name: None for s in sorted(_symbols(self.expressions), key=str) if base(s) in prescribed}
        return (*names, *moved)

    def in_state(self, expression: sp.Expr) -> sp.Expr:
        """An expression of the file (its coordinates, velocities and named reactions) in the present state."""
        e = self.equations
        written = filled(self.configuration.rewritten(expression), self.given, e.slots, self.problem)
        return written.xreplace(dict(zip(e.slots.velocities, e.rates, strict=True)))

    def with_functions(self, given: Mapping[str, sp.Expr]) -> StateEquations:
        """The equations after substitution of expressions in t, or in the names of their arguments, for functions."""
        if not given:
            return self
        e = self.equations

        def put(x: sp.Expr) -> sp.Expr:
            return filled(x, given, e.slots, self.problem)

        equations = replace(
            e,
            rates=tuple(map(put, e.rates)),
            mass=tuple(tuple(map(put, row)) for row in e.mass),
            force=tuple(map(put, e.force)),
            constraint_matrix=tuple(tuple(map(put, row)) for row in e.constraint_matrix),
            bias=tuple(map(put, e.bias)),
            finite=tuple(map(put, e.finite)),
            velocity_forms=tuple(map(put, e.velocity_forms)),
        )
        return replace(
            self,
            equations=equations,
            energy=None if self.energy is None else put(self.energy),
            conserved={n: put(x) for n, x in self.conserved.items()},
            reactions={n: put(x) for n, x in self.reactions.items()},
            contacts=tuple(replace(c, value=put(c.value)) for c in self.contacts),
            slips=tuple(map(put, self.slips)),
            plane_slips=tuple(tuple(map(put, slip)) for slip in self.plane_slips),
            exchanges={n: put(x) for n, x in self.exchanges.items()},
            masses={n: put(x) for n, x in self.masses.items()},
            signs={s: put(x) for s, x in self.signs.items()},
            given={**self.given, **given},
            before=self.open,
        )


def filled(e: sp.Expr, given: Mapping[str, sp.Expr], slots: Slots, problem: Problem) -> sp.Expr:
    """An expression after substitution for functions f(X, Y), prescribed motions u(t), and their derivatives."""
    if not given:
        return e
    names = {f.name: f.arguments for f in problem.functions}

    def put(f: Unspecified) -> sp.Expr:
        if f.name not in given:
            return f
        value = given[f.name]
        places = [t if n == "t" else sp.Symbol(n, real=True) for n in names.get(f.name, f.argument_names)]
        for place, order in zip(places, f.orders, strict=True):
            value = value.diff(place, order) if order else value
        return value.xreplace(dict(zip(places, f.arguments, strict=True)))

    e = e.replace(lambda a: isinstance(a, Unspecified), put) if e.has(Unspecified) else e
    rule: dict[sp.Basic, sp.Expr] = {}
    for u in slots.prescribed:
        if u.name in given:
            rule |= {prime(u, n) if n else u: given[u.name].diff(t, n) if n else given[u.name] for n in range(4)}
    return e.xreplace(rule) if rule else e


def _symbols(expressions: Iterable[sp.Expr]) -> set[sp.Symbol]:
    return {s for s in distinct_parts(expressions) if isinstance(s, sp.Symbol)}


def state_equations(solution: Solution, choice: str | None = None) -> StateEquations:
    """The equations in a choice of coordinates; without one, in those in which they are best integrated.

    Independent coordinates come first: those of a choice that leaves no constraint and no root with two signs, then
    quasi-velocities, then the file's own coordinates with their constraints. `""` is the file's own coordinates.

    Raises ProblemError if there is no such choice, or nothing moves.
    """
    if solution.long_equations is not None:
        return _of_long(solution)
    views = [v for v in solution.views if v.dynamics is not None]
    if solution.law is None or not views:
        message = "there are no equations of motion"
        help_ = "a motion needs masses, and a problem that is solved to its end"
        raise ProblemError(Diagnostic("no-equations", message, help=help_))
    if choice is not None:
        views = [v for v in views if v.name == choice]
        if not views:
            raise KeyError(choice)
    return _of_view(min(views, key=_difficulty), solution.law, solution.problem)


def _difficulty(view: InCoordinates) -> tuple[bool, int, int, bool]:
    """Roots with two signs, constraints that are left, coordinates that are not needed; the file's own come last."""
    quasi = view.in_speeds is not None and view.in_speeds.equations is not None
    left = len(view.configuration.finite_constraints) if quasi else len(view.configuration.rows)
    return bool(view.signs), left, len(view.configuration.slots.coordinates), view.is_own


def _of_view(view: InCoordinates, law: NewtonLaw, problem: Problem) -> StateEquations:
    dynamics = view.dynamics
    assert dynamics is not None
    if dynamics.reactions is None and law.used:
        dynamics = motion(law, view.coordinates.configuration, view.elimination)
    quasi = view.in_speeds.equations if view.in_speeds is not None else None
    equations = in_coordinates(dynamics) if quasi is None else in_speeds(quasi)
    integrals = view.conserved or conserved(dynamics, law.newton.multipliers_by_name, {f.name for f in law.frictions})
    rates = dict(zip(equations.slots.velocities, equations.rates, strict=True)) if quasi is not None else {}

    def here(e: sp.Expr) -> sp.Expr:
        return e.xreplace(rates)

    reactions = {n: (r, here(e)) for n, r, e in _reactions(dynamics, law, equations)}
    watched = contacts(dynamics, law.newton.reactions, equations.multipliers)
    states = StateEquations(
        problem=problem,
        view=view,
        configuration=dynamics.equations.configuration,
        equations=equations,
        energy=_energy(integrals, here),
        conserved={name: here(e) for name, e in _named(integrals)},
        reactions={n: e for n, (_, e) in reactions.items()},
        contacts=tuple(replace(c, value=here(c.value)) for c in watched),
        slips=tuple(map(here, dynamics.slips)),
        plane_slips=tuple(
            tuple(map(here, f.slip.fixed().components)) for f in dynamics.friction_forces if f.speed is None
        ),
        exchanges={m.name: here(m.exchanged) for m in dynamics.shown.variable_masses if m.has_one_sense},
        masses={m.name: here(m.mass) for m in dynamics.shown.variable_masses},
        signs={s: here(e) for s, e in dynamics.signs.items()},
        branches=view.signs,
        idle={n: _idle(n, r, law) for n, (r, e) in reactions.items() if e == 0},
    )
    _refuse_accelerations(states)
    return states


def _of_long(solution: Solution) -> StateEquations:
    """The equations in the file's coordinates, too long to be printed; without reactions other than multipliers."""
    energy = long_energy(solution)
    return StateEquations(
        problem=solution.problem,
        view=solution.own,
        configuration=solution.own.configuration,
        equations=long_first_order(solution),
        energy=energy,
        conserved={} if energy is None else {"energy": energy},
    )


def _energy(conserved: Conserved, here: Callable[[sp.Expr], sp.Expr]) -> sp.Expr | None:
    kept: Iterator[sp.Expr] = (i.expression for i in conserved.integrals if i.quantity == "energy")
    total = next(kept, None)
    if total is None and conserved.energy is not None and not conserved.energy.hidden:
        total = conserved.energy.expression
    return None if total is None else here(total)


def _named(conserved: Conserved) -> Iterator[tuple[str, sp.Expr]]:
    """The conserved quantities under names: energy, p_theta, and numbers for the rest."""
    names: set[str] = set()
    for n, integral in enumerate(conserved.integrals, start=1):
        name = f"p_{integral.coordinate.name}" if integral.coordinate is not None else str(integral.quantity)
        name = name if name not in names else f"{name}_{n}"
        names.add(name)
        yield name, integral.expression


def _reactions(
    dynamics: Motion, law: NewtonLaw, equations: FirstOrderEquations
) -> Iterator[tuple[str, Reaction, sp.Expr]]:
    """The reactions in state and multipliers, under the names that the page has; those too long to write are solved."""
    known = dynamics.reactions
    for r in law.newton.reactions:
        size = None if known is None else known.sizes.get(r.name)
        value = size if size is not None else (known.multipliers.get(r.name) if known is not None else None)
        name = _name_of(r, size is not None)
        if r.multiplier in equations.multipliers and (value is None or value.has(r.multiplier)):
            yield r.force.name if not r.named else r.multiplier.name, r, r.multiplier
        elif value is not None:
            yield name, r, value


def _name_of(reaction: Reaction, is_size: bool) -> str:
    symbol = (reaction.symbol or reaction.multiplier) if is_size else reaction.multiplier
    return str(symbol.name)


def _idle(name: str, reaction: Reaction, law: NewtonLaw) -> tuple[sp.Expr, sp.Symbol, sp.Expr]:
    is_force = name != reaction.multiplier.name and reaction.single is not None
    factor = reaction.single.factor if is_force and reaction.single is not None else sp.S.One
    return factor * reaction.multiplier, reaction.multiplier, reaction.row.velocity_form(law.configuration.slots)


def _refuse_accelerations(states: StateEquations) -> None:
    """Raises NotCoveredError if a force depends on accelerations, so that the equations are not of first order."""
    accelerations = {prime(v) for v in states.equations.slots.velocities}
    if not accelerations.isdisjoint(_symbols(states.expressions)):
        raise NotCoveredError("a motion whose forces depend on accelerations")
