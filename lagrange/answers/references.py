"""References for answers: the derived system in every set of coordinates, and the names that answers may use.

A solved problem gives one system for the file's own coordinates and one for each choice, with the multipliers of the
constraints that remain there as unknowns. An answer in the coordinates of a choice may also use the multipliers of
constraints that these coordinates satisfy identically (the tension of a pendulum's rod, with the angle): it is compared
with the file's own equations, rewritten in the choice. Names of forces in an answer are replaced by their meanings,
T = −2 l λ; where an answer is not right with these, the other usual ones are tried (`readings`).
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import field, replace
from functools import cached_property, lru_cache
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.answers.readings import Reading, other_readings, radii, with_positive_radii
from lagrange.answers.validity import Factorizations
from lagrange.core.records import record
from lagrange.core.symbols import CONSTANT, Sign, prime, variation, velocity_before
from lagrange.core.vectors import Vector
from lagrange.expressions.reader import Scope
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.constraints.variable_mass import REACTIVE
from lagrange.mechanics.dynamics.checks import multiplier_system
from lagrange.mechanics.dynamics.comparison import System
from lagrange.mechanics.dynamics.equations import EquationsOfMotion, LagrangeMotion
from lagrange.mechanics.dynamics.newton import Newton
from lagrange.mechanics.dynamics.principle import given_forces
from lagrange.mechanics.energy_symbols import energy_symbols, letters_of_oscillations, small_displacements
from lagrange.mechanics.results import InCoordinates, Solution
from lagrange.problem.model import Problem
from lagrange.problem.values import units_of

if TYPE_CHECKING:
    from lagrange.answers.models.mechanics import Mechanics
    from lagrange.answers.models.residues import Residues
    from lagrange.answers.models.search import Models
    from lagrange.values.dimensions import Mismatch


@record
class ReferenceCandidate:
    """One system that an answer may be compared with; it is built on first use.

    choice       the choice of coordinates; empty for the file's own
    multipliers  the unknowns in addition to the accelerations
    meanings     the meanings of names of forces in terms of multipliers: T = −2 l λ
    named        names whose meanings are not multiples of multipliers
    only_for     names one of which an answer must use; otherwise this candidate differs in nothing from another
    values       the numbers that the file gives to parameters
    certain      magnitudes and signs that the file settles: |N| is N
    positive     radii that are taken as positive
    remarks      the meanings of names of forces that differ from those in the derivation, in words
    mechanics    the parts of the system, in which a model may change it; None if they are not known
    starts       what vanishes in every state after the initial one of the file, if it gives one
    """

    choice: str
    configuration: Configuration
    multipliers: tuple[sp.Symbol, ...]
    build: Callable[[], System]
    meanings: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)
    only_for: frozenset[str] = frozenset()
    named: frozenset[str] = frozenset()
    values: Mapping[sp.Symbol, sp.Rational] = field(default_factory=dict)
    certain: Mapping[sp.Expr, sp.Expr] = field(default_factory=dict)
    positive: tuple[sp.Symbol, ...] = ()
    remarks: Mapping[str, str] = field(default_factory=dict)
    mechanics: Callable[[], Mechanics] | None = None
    starts: Callable[[], sp.Expr | None] | None = None

    @cached_property
    def from_start(self) -> sp.Expr | None:
        """What vanishes in every state after the initial one; None if it is not known."""
        relation = self.starts() if self.starts is not None else None
        return None if relation is None else relation.xreplace(dict(self.values))

    def holds_from_start(self, claims: Sequence[sp.Expr], written: Sequence[sp.Expr]) -> bool:
        """Whether claims, `written` so in an answer, hold for the motion from the initial state of the file."""
        if self.from_start is None:
            return False
        from lagrange.answers.recognition import holds_from_start

        forces = {s.name for s in (*self.multipliers, *self.meanings)}
        return holds_from_start(claims, written, self.from_start, self.system, forces)

    @cached_property
    def models(self) -> Models:
        """The changed problems that a wrong answer is compared with."""
        from lagrange.answers.models.search import Models

        return Models(self.system, dict(self.values), self.parts)

    @cached_property
    def residues(self) -> Residues:
        """The states at which the terms of wrong answers are weighed."""
        from lagrange.answers.models.residues import Residues

        return Residues(self.system)

    def parts(self) -> Mechanics | None:
        """The parts of the system; None if they are not known."""
        mechanics = self.mechanics() if self.mechanics is not None else None
        if mechanics is None or not self.positive:
            return mechanics
        return mechanics.force(
            lambda f: replace(f, shares=tuple(with_positive_radii(e, self.positive) for e in f.shares))
        )

    @cached_property
    def system(self) -> System:
        """The system, with the numbers that the file gives."""
        return _with_values(self.build(), self.values) if self.values else self.build()

    @cached_property
    def factorizations(self) -> Factorizations:
        """The factors that are known of the system."""
        return Factorizations(self.system)

    @cached_property
    def known(self) -> set[str]:
        """The names of coordinates and unknowns that may occur in answers compared with it."""
        slots = self.configuration.slots
        own = (*slots.coordinates, *self.configuration.expressed, *self.multipliers)
        unknown = set(self.multipliers)
        meant = (s for s, e in self.meanings.items() if e.free_symbols & unknown)
        return {s.name for s in (*own, *meant)} | self.named

    def read(self, expression: sp.Expr) -> sp.Expr:
        """An expression of an answer in the coordinates and unknowns of the system, with the file's numbers."""
        return self.in_symbols(expression).xreplace(dict(self.values))

    def in_symbols(self, expression: sp.Expr) -> sp.Expr:
        """The same, with symbols for parameters to which the file gives numbers."""
        meant = expression.xreplace(dict(self.certain)).xreplace(dict(self.meanings))
        rewritten = self.configuration.rewritten(meant)
        return with_positive_radii(rewritten, self.positive) if self.positive else rewritten

    @cached_property
    def with_positive_radii(self) -> ReferenceCandidate | None:
        """The same for positive radii; None if their signs do not matter."""
        positive = () if self.positive else radii(self.system)
        if not positive:
            return None
        equations = tuple(with_positive_radii(e, positive) for e in self.system.equations)
        return replace(self, build=lambda: replace(self.system, equations=equations), positive=positive)

    def remarks_on(self, expressions: Iterable[sp.Expr]) -> tuple[str, ...]:
        """The remarks on the names in the expressions of an answer that is right with these meanings."""
        used = {s.name for e in expressions for s in e.free_symbols}
        return tuple(remark for name, remark in self.remarks.items() if name in used)


@record
class Reference:
    """The systems with which answers to a problem are compared.

    scope       the names that an answer may use
    candidates  the systems, those of the file's own coordinates first
    values      the numbers that the file gives to parameters
    unknowns    declared unknown forces
    units       units of parameters and coordinates, as far as the file gives them
    newton      the reactions, whose names may have other meanings in an answer; None if there are none
    declared    names that the problem declares, those of its reactions included
    letters     names that the derivation adds for its own results
    parameters  the parameters by name
    """

    scope: Scope
    candidates: tuple[ReferenceCandidate, ...]
    values: Mapping[sp.Symbol, sp.Rational]
    unknowns: tuple[sp.Symbol, ...] = ()
    units: Mapping[sp.Symbol, str] = field(default_factory=dict)
    newton: Newton | None = None
    declared: frozenset[str] = frozenset()
    letters: frozenset[str] = frozenset()
    parameters: Mapping[str, sp.Symbol] = field(default_factory=dict)

    @cached_property
    def coordinates(self) -> frozenset[str]:
        """The names of the coordinates."""
        return frozenset(q.name for q in self.scope.slots.coordinates)

    @cached_property
    def scope_of_answers(self) -> Scope:
        """The names, other than letters of the derivation, that differ from declared names only in their case.

        `omega` for a declared `Omega` is a mistake in writing, and not the frequency of small oscillations.
        """
        lower = {n.lower() for n in self.declared}
        hidden = {n for n in self.letters if n.lower() in lower and n not in self.declared}
        if not hidden:
            return self.scope
        scalars = {n: v for n, v in self.scope.scalars.items() if n not in hidden}
        coordinates = tuple(q for q in self.scope.slots.coordinates if q.name not in hidden)
        return replace(self.scope, scalars=scalars, slots=replace(self.scope.slots, coordinates=coordinates))

    @cached_property
    def of_answers(self) -> Reference:
        """The same with only the names that answers may use."""
        return self if self.scope_of_answers is self.scope else replace(self, scope=self.scope_of_answers)

    def candidates_for(self, used: Collection[str]) -> Iterator[ReferenceCandidate]:
        """The candidates for an answer with these names: as in the derivation, then for other meanings of reactions."""
        yield from self.candidates
        for reading in other_readings(self.newton, used):
            for c in self.candidates:
                other = {s: ratio * c.meanings.get(s, s) for s, ratio in reading.ratios.items()}
                certain = dict(c.certain)
                for s, ratio in reading.ratios.items():  # |N| is the same force, and so −N for the opposite N
                    certain |= {e: sp.sign(ratio) * c.certain[e] for e in (sp.Abs(s), sp.sign(s)) if e in c.certain}
                yield replace(c, meanings={**c.meanings, **other}, certain=certain, remarks=reading.remarks)

    def mismatch(self, reading: Reading) -> Mismatch | None:
        """Terms of an equation whose dimensions differ; None if they agree, or if that is not known."""
        if not self.units or not self._units_agree or len(reading.components) != 1:
            return None
        return _mismatch(reading.components[0], self.units)

    @cached_property
    def _units_agree(self) -> bool:
        """Whether the derived equations are dimensionally consistent; otherwise the units of the file are wrong."""
        systems = (c.system for c in self.candidates)
        return all(_mismatch(e, self.units) is None for s in systems for e in s.equations)

    @cached_property
    def moving(self) -> set[str]:
        """The names of all coordinates and multipliers, of which each candidate knows some."""
        return {q.name for q in self.scope.slots.coordinates}.union(*(c.known for c in self.candidates))


def _mismatch(e: sp.Expr, units: Mapping[sp.Symbol, str]) -> Mismatch | None:
    from lagrange.answers.slips import terms_of
    from lagrange.values.dimensions import mismatch

    return mismatch(terms_of(e) or (), units)


def reference_of_solution(solution: Solution) -> Reference:
    """The reference that a solved problem gives, with what was found out about it for the answers before this one."""
    return _reference_of(Identical(solution))


class Identical:
    """A solution that equals only itself: comparing two of them takes longer than judging an answer."""

    def __init__(self, solution: Solution) -> None:
        self.solution = solution

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Identical) and other.solution is self.solution

    def __hash__(self) -> int:
        return id(self.solution)


@lru_cache(maxsize=8)
def _reference_of(same: Identical) -> Reference:
    solution = same.solution
    problem = solution.problem
    signs = {s.name: s for c in solution.choices for s in c.signs}
    scope = problem.scope
    angles = [a for a in _angles_on_surfaces(solution) if a.name not in scope.names()]
    energies = _energies(solution)
    general = [energy_symbols(solution).coordinate] if energies else []
    small = [x for x in small_displacements(solution) if x.name not in scope.names()]
    of_oscillations = {s.name: s for s in letters_of_oscillations(solution)}
    new = [*(q for c in problem.choices for q in c.coordinates), *angles, *general, *small]
    coordinates = tuple(dict.fromkeys((*scope.slots.coordinates, *new)))
    wider = replace(
        scope,
        scalars={
            **of_oscillations,
            **_potential(solution),
            **_quasi_variations(solution),
            **energies,
            **_reactions(solution),
            **_of_impact(solution),
            **_of_response(solution),
            **_given(solution),
            **{a.name: a for a in angles},
            **_lengths(solution),
            **scope.scalars,
            **signs,
        },
        slots=replace(scope.slots, coordinates=coordinates),
        vectors={**_applied_forces(solution), **_reaction_forces(solution), **_of_bodies(solution), **scope.vectors},
    )
    values = problem.given_values
    certain = _settled(solution)
    plain = [replace(c, values=values, certain=certain, starts=_start_of(c, solution)) for c in _candidates(solution)]
    candidates = tuple(_with_meanings(plain, solution))
    newton = solution.law.newton if solution.law else None
    added = {**of_oscillations, **_potential(solution), **energies, **_lengths(solution)}
    letters = frozenset((*added, *(q.name for q in (*angles, *general, *small))))
    declared = declared_names(problem) | {s.name for s in signs.values()} | frozenset(_reactions(solution))
    parameters = {p.symbol.name: p.symbol for p in problem.parameters}
    units = units_of(problem)
    return Reference(wider, candidates, values, problem.unknowns, units, newton, declared, letters, parameters)


def _start_of(candidate: ReferenceCandidate, solution: Solution) -> Callable[[], sp.Expr | None] | None:
    """What vanishes after the initial state, found on first use; None if the file gives no initial state."""
    from lagrange.answers.recognition import relation_from_start

    view = next((v for v in solution.views if v.name == candidate.choice), None)
    if view is None or not solution.problem.initial:
        return None
    return lambda: relation_from_start(solution, view)


def declared_names(problem: Problem) -> frozenset[str]:
    """The names that a problem declares, and those of the coordinates of its choices."""
    scope = problem.scope
    moving = (*scope.slots.coordinates, *scope.slots.prescribed, *(q for c in problem.choices for q in c.coordinates))
    return frozenset((*scope.scalars, *scope.functions, *scope.vectors, *(s.name for s in moving), CONSTANT.name))


def _with_meanings(candidates: list[ReferenceCandidate], solution: Solution) -> Iterator[ReferenceCandidate]:
    """The candidates with the meanings that the names of forces have in the derivation.

    If friction brings in |λ|, which is not linear, λ is also replaced by its derived value.
    """
    meant = solution.law.newton.single_forces if solution.law else {}
    yield from (replace(c, meanings=meant) for c in candidates)
    yield from _with_values_of_reactions(candidates, solution)


def _with_values_of_reactions(candidates: list[ReferenceCandidate], solution: Solution) -> Iterator[ReferenceCandidate]:
    """The candidates for answers with |λ| of a reaction with friction."""
    dynamics = {v.name: v.dynamics for v in solution.views}
    for c in candidates:
        motion = dynamics[c.choice]
        if motion is None or motion.reactions is None or not motion.friction_forces:
            continue
        values = motion.reactions.values
        known = {r.reaction.multiplier: values.get(r.reaction.multiplier) for r in motion.friction_forces}
        valued = {s: v for s, v in known.items() if v is not None}
        forces = solution.law.newton.single_forces if solution.law else {}
        meant = valued | {s: e.xreplace(valued) for s, e in forces.items()}
        kept = tuple(m for m in c.multipliers if m not in valued)
        only = frozenset(s.name for s in meant if s in valued or forces[s].free_symbols & {*valued})
        yield replace(c, meanings=meant, only_for=only, named=only, multipliers=kept)


def _settled(solution: Solution) -> dict[sp.Expr, sp.Expr]:
    """The magnitudes and signs that the file settles for friction: |N| = N if the contact is declared positive.

    |N| may also be written with the value of N: then |m g cos α| is m g cos α.
    """
    settled: dict[sp.Expr, sp.Expr] = {}
    for motion in (v.dynamics for v in solution.views):
        for r in motion.friction_forces if motion is not None else ():
            if not isinstance(r.contact, Sign):
                multiplier = r.reaction.multiplier
                for unknown, sign in ((multiplier, r.contact), (r.reaction.force, r.sign_of_force)):
                    settled |= {sp.Abs(unknown): sign * unknown, sp.sign(unknown): sign}
                value = motion.reactions.values.get(multiplier) if motion and motion.reactions else None
                inside = sp.Abs(value).atoms(sp.Abs) if value is not None else set()
                settled |= {a: r.contact * value * a / sp.Abs(value) for a in inside if len(inside) == 1}
            if (r.friction.slip or r.friction.toward) is not None and r.speed is not None:
                settled |= {sp.Abs(r.speed): r.sense * r.speed, sp.sign(r.speed): r.sense}
    return settled


def _angles_on_surfaces(solution: Solution) -> Iterator[sp.Symbol]:
    """The angles with which a derivation writes forms on circles, spheres, ...; they occur in intermediate lines."""
    for c in solution.classification.constraints:
        if c.finite_form is not None and c.finite_form.restriction is not None:
            yield from (a.symbol for a in c.finite_form.restriction.angles)


def _potential(solution: Solution) -> dict[str, sp.Expr]:
    """V, the symbol of the given potential energy in a derivation."""
    potential = solution.own.configuration.potential
    return {"V": potential} if potential != 0 and "V" not in solution.problem.scope.names() else {}


def _quasi_variations(solution: Solution) -> dict[str, sp.Expr]:
    """delta(pi_u) of each quasi-velocity u."""
    problem = solution.problem
    if not problem.speeds:
        return {}
    from lagrange.mechanics.dynamics.quasi_velocities import quasi_variation

    moving = problem.slots.coordinates
    return {
        quasi_variation(u.symbol).name: sp.Add(*(u.definition.diff(prime(q)) * variation(q) for q in moving))
        for u in problem.speeds
    }


def _energies(solution: Solution) -> dict[str, sp.Expr]:
    """T, V, L, v_P, p_k, Q_k, N_k in a derivation by Lagrange's or Hamilton's equations, and H and R in the latter.

    Those of the file's coordinates prevail.
    """
    energies: dict[str, sp.Expr] = {}
    named = energy_symbols(solution)
    for dynamics in (v.dynamics for v in reversed(solution.views)):
        if dynamics is not None and isinstance(dynamics.written, LagrangeMotion):
            energies |= {s.name: e for s, e in named.meanings(dynamics.written.principle).items()}
    for hamiltonian in (v.hamiltonian for v in reversed(solution.views)):
        if hamiltonian is not None:
            energies |= {s.name: e for s, e in named.meanings(hamiltonian.energies).items()}
            by_momenta = dict(zip(hamiltonian.momenta, hamiltonian.energies.momenta, strict=True))
            functions = {named.hamiltonian: hamiltonian.function, named.routhian: hamiltonian.routhian}
            energies |= {s.name: e.xreplace(by_momenta) for s, e in functions.items() if e is not None}
    return energies


def _given(solution: Solution) -> dict[str, sp.Expr]:
    """Q_x of forces that the file gives as such, U of potentials with velocities, L where it is given outright."""
    configuration = solution.own.configuration
    pairs = zip(configuration.slots.coordinates, given_forces(configuration), strict=False)
    meant = {f"Q_{q.name}": f for q, f in pairs if f != 0}
    if configuration.is_outright:
        return meant | {"L": configuration.velocity_part - configuration.potential}
    return meant | ({"U": -configuration.velocity_part} if configuration.velocity_part != 0 else {})


def _of_response(solution: Solution) -> dict[str, sp.Expr]:
    """The letters of amplitudes and lags."""
    responses = [v.response for v in solution.views if v.response is not None]
    return {s.name: s for r in responses for s in (*r.letters, *r.lags)}


def _of_impact(solution: Solution) -> dict[str, sp.Expr]:
    """The velocities just before an impact, the impulses of its reactions, the kinetic energies before and after."""
    motion = solution.impact
    if motion is None:
        return {}
    symbols = [*(i.symbol for i in motion.impulses), *map(velocity_before, motion.slots.coordinates)]
    kinetic = energy_symbols(solution).kinetic.name
    return {s.name: s for s in symbols} | {f"{kinetic}_0": motion.kinetic[0], kinetic: motion.kinetic[1]}


def _applied_forces(solution: Solution) -> dict[str, Vector]:
    """F_P of each particle P on which forces act, its reactive force Phi_P, and F and r of a force that acts elsewhere.

    Names of the file keep their meaning.
    """
    forces: dict[str, Vector] = {}
    for load in solution.own.configuration.loads:
        name = f"F_{load.name if load.elsewhere else load.on}"
        if load.elsewhere and f"r_{load.name}" not in solution.problem.scope.names():
            forces[f"r_{load.name}"] = load.point
        if name not in solution.problem.scope.names():
            forces[name] = forces.get(name, Vector.zero()) + load.vector
        if load.name == REACTIVE and f"Phi_{load.on}" not in solution.problem.scope.names():
            forces[f"Phi_{load.on}"] = load.vector
    return forces


def _of_bodies(solution: Solution) -> dict[str, Vector]:
    """H_B, M_B and delta(pi_B) of each body B. Names of the file keep their meaning."""
    configuration = solution.own.configuration
    variations = [variation(q) for q in configuration.slots.coordinates]
    vectors: dict[str, Vector] = {}
    for r in configuration.rotations:
        vectors |= {f"H_{r.name}": r.momentum, f"M_{r.name}": configuration.moment_on(r.name)}
        vectors[f"delta(pi_{r.name})"] = r.virtual(variations)
        vectors |= {f"r_{f.name}": f.point for f in configuration.loads_beside(r.name)}
    declared = solution.problem.scope.names()
    return {name: vector for name, vector in vectors.items() if name not in declared}


def _lengths(solution: Solution) -> dict[str, sp.Expr]:
    """d_s of each spring or damper s. Names of the file keep their meaning."""
    configuration = solution.own.configuration
    declared = solution.problem.scope.names()
    lengths = {link.length_symbol.name: link.distance for link in configuration.links}
    return {name: length for name, length in lengths.items() if name not in declared}


def _reactions(solution: Solution) -> dict[str, sp.Expr]:
    """Multipliers, rod tensions, and the signs that friction leaves undetermined, by name."""
    if solution.law is None:
        return {}
    newton = solution.law.newton
    signs = solution.own.dynamics.signs if solution.own.dynamics is not None else ()
    named = (*newton.multipliers_by_name.values(), *newton.single_forces, *signs, *_friction_at_rest(solution))
    return {s.name: s for s in named}


def _friction_at_rest(solution: Solution) -> Iterator[sp.Symbol]:
    """The symbols of friction forces at rest, and in contacts that roll."""
    for view in solution.views:
        if view.at_rest is not None:
            yield from (f for c in view.at_rest.contacts for f in c.components)
        if view.rolling is not None:
            yield from (c.symbol for c in view.rolling.contacts)


def _reaction_forces(solution: Solution) -> dict[str, Vector]:
    """R_P and Gamma_B of each particle P and body B on which reactions act, as in a derivation."""
    forces: dict[str, Vector] = {}
    for r in solution.law.newton.reactions if solution.law else ():
        for name in r.acts_on:
            for kind, vector in (("R", r.per_unit(name)), ("Gamma", r.moment_per_unit(name))):
                if vector is not None:
                    sum_so_far = forces.get(f"{kind}_{name}", Vector.zero())
                    forces[f"{kind}_{name}"] = sum_so_far + vector * r.force
    taken = solution.problem.scope.names()
    return {name: force for name, force in forces.items() if name not in taken}


def _with_values(system: System, values: Mapping[sp.Symbol, sp.Rational]) -> System:
    """The system with the numbers that the file gives to parameters."""
    configuration = system.configuration
    values = dict(values)
    rows = tuple(
        replace(
            row,
            coefficients=tuple(c.xreplace(values) for c in row.coefficients),
            drift=row.drift.xreplace(values),
            finite=None if row.finite is None else row.finite.xreplace(values),
            nonlinear=None if row.nonlinear is None else row.nonlinear.xreplace(values),
        )
        for row in configuration.rows
    )
    equations = tuple(e.xreplace(values) for e in system.equations)
    constrained = configuration.constrained.with_rows(rows)
    return System(replace(configuration, constrained=constrained), equations, system.multipliers)


def _candidates(solution: Solution) -> Iterator[ReferenceCandidate]:
    """The systems of the file's coordinates and of the choices."""
    if solution.own.motion is None:
        return
    unknowns = solution.problem.unknowns
    yield _candidate(solution.own, solution.own.motion, solution)
    reactions = tuple(c.reaction for c in solution.problem.constraints)
    tensions = solution.law.newton.single_forces if solution.law else {}
    for c in solution.choices:
        if c.motion is None:
            continue
        reduced = _candidate(c, c.motion, solution)
        yield reduced
        lost = {r for r in reactions if r not in reduced.multipliers}
        configuration = c.motion.configuration

        def rewritten(configuration: Configuration = configuration) -> System:
            """The file's own equations, with all multipliers, in the coordinates of the choice."""
            own = _with_multipliers(solution.own.motion, solution)  # type: ignore[arg-type]
            equations = tuple(configuration.rewritten(e) for e in own.equations)
            return System(configuration, equations, (*reactions, *occurring(unknowns, equations)))

        # The choice satisfies some constraints identically, so their multipliers are in none of its own equations.
        if lost:
            names = {s.name for s in lost} | {s.name for s, e in tensions.items() if e.free_symbols & lost}
            yield ReferenceCandidate(
                c.name, configuration, (*reactions, *unknowns), rewritten, only_for=frozenset(names)
            )


def _candidate(view: InCoordinates, motion: EquationsOfMotion, solution: Solution) -> ReferenceCandidate:
    """The equations of one configuration, with the multipliers of the constraints that remain in it."""
    configuration = motion.configuration
    reactions = {c.name: c.reaction for c in solution.problem.constraints}
    multipliers = tuple(reactions[r.name] for r in configuration.rows)
    known = (*multipliers, *solution.problem.unknowns)

    def mechanics() -> Mechanics:
        from lagrange.answers.models.mechanics import mechanics_of

        frictions = view.dynamics.friction_forces if view.dynamics is not None else ()
        return mechanics_of(configuration, solution.problem, frictions)

    return ReferenceCandidate(
        view.name,
        configuration,
        known,
        lambda: _with_multipliers(motion, solution),
        mechanics=mechanics,
    )


def _with_multipliers(motion: EquationsOfMotion, solution: Solution) -> System:
    configuration, principle = motion.configuration, motion.principle
    reactions = {c.name: c.reaction for c in solution.problem.constraints}
    left = tuple(principle.textbook.form(d) for d in principle.coefficients)
    system = multiplier_system(configuration, left, tuple(reactions[r.name] for r in configuration.rows))
    return replace(system, multipliers=(*system.multipliers, *occurring(solution.problem.unknowns, left)))


def occurring(symbols: tuple[sp.Symbol, ...], expressions: tuple[sp.Expr, ...]) -> tuple[sp.Symbol, ...]:
    """Those of the symbols that occur in the expressions."""
    used = set().union(*(e.free_symbols for e in expressions))
    return tuple(s for s in symbols if s in used)
