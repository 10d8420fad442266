"""A reference system that a file gives outright under `equations`, to check answers against.

It is trusted, except for faults that would make every answer right, or none: each equation must be linear in the
accelerations and unknown forces and contain one of them, and there must be a solution at a random state that satisfies
the constraints,

    rank [A | b] = rank A .

Multipliers, reactions and unknown forces that occur in it are unknowns in addition to the accelerations; unknowns that
only an answer has are eliminated from the answer. In each choice of coordinates the same system is rewritten.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError, NoPointError, Point, UnsupportedError
from lagrange.answers.readings import read_answer
from lagrange.answers.references import Reference, ReferenceCandidate, declared_names, occurring
from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError
from lagrange.core.symbols import base
from lagrange.mechanics.constraints.classification import classify
from lagrange.mechanics.constraints.constrained_system import ConstrainedSystem
from lagrange.mechanics.constraints.coordinates import GeneralizedCoordinates, generalized_coordinates
from lagrange.mechanics.constraints.kinematics import Configuration, file_configuration
from lagrange.mechanics.dynamics.comparison import System, agreed_in_motion
from lagrange.problem.model import Problem
from lagrange.problem.values import units_of


def reference_of_equations(problem: Problem) -> Reference:
    """The reference system of a file.

    Raises ProblemError if an equation cannot be read or is no equation of motion, or if they contradict one another.
    """
    constrained = classify(problem).constrained if problem.constraints else ConstrainedSystem(problem.slots, ())
    configuration = file_configuration(problem, constrained)
    chosen = [generalized_coordinates(c, configuration) for c in problem.choices]
    signs = {s.name: s for c in chosen for s in c.signs}
    new = (q for c in chosen for q in c.configuration.slots.coordinates)
    slots = replace(problem.slots, coordinates=tuple(dict.fromkeys((*problem.slots.coordinates, *new))))
    scope = replace(problem.scope, scalars={**problem.scope.scalars, **signs}, slots=slots)
    expressions: list[sp.Expr] = []
    errors: list[Diagnostic] = []
    for fragment in problem.equations:
        reading = read_answer(fragment, scope)
        expressions += reading.components
        errors += reading.error.diagnostics if reading.error else ()
        errors += _foreign(reading.components, fragment, problem)
    if errors:
        raise ProblemError(errors)
    forces = (*problem.unknowns, *(c.reaction for c in problem.constraints))
    unknowns = occurring(forces, tuple(expressions))
    system = System(configuration, tuple(expressions), unknowns)
    values = problem.given_values
    candidates = (
        ReferenceCandidate("", configuration, forces, lambda: system, values=values),
        *(_rewritten(system, c, forces, values) for c in chosen),
    )
    _check(candidates[0].system, problem)
    declared = declared_names(problem) | {*signs}
    parameters = {p.symbol.name: p.symbol for p in problem.parameters}
    return Reference(scope, candidates, values, forces, units_of(problem), declared=declared, parameters=parameters)


def _rewritten(
    system: System,
    chosen: GeneralizedCoordinates,
    forces: tuple[sp.Symbol, ...],
    values: dict[sp.Symbol, sp.Rational],
) -> ReferenceCandidate:
    """The system in a choice of coordinates."""
    configuration: Configuration = chosen.configuration

    def build() -> System:
        return System(configuration, tuple(map(configuration.rewritten, system.equations)), system.multipliers)

    return ReferenceCandidate(chosen.choice.name, configuration, forces, build, values=values)


def _foreign(components: Sequence[sp.Expr], fragment: Fragment, problem: Problem) -> Iterator[Diagnostic]:
    """The error that an equation contains coordinates of a choice."""
    own = {*problem.slots.coordinates, *problem.slots.prescribed}
    others = {q for c in problem.choices for q in c.coordinates} - own
    used = sorted({base(s) for e in components for s in e.free_symbols} & others, key=str)
    if used:
        message = f"the reference system is in the coordinates of the file, and `{used[0]}` belongs to a choice"
        help_ = "declare it under `coordinates`, or write the equation without it"
        yield Diagnostic("reference-coordinates", message, fragment.whole, help=help_)


def _check(system: System, problem: Problem) -> None:
    """Raises ProblemError at a fault that would make every answer right, or none."""
    unknowns = (*system.multipliers, *system.configuration.slots.accelerations)
    places = [f for f in problem.equations for _ in read_answer(f, problem.scope).components] or problem.equations
    try:
        fault = agreed_in_motion(
            system.configuration,
            lambda moving: _fault(moving, system, unknowns),
            (*system.equations, *system.accelerated_constraints),
        )
    except DivisionByZeroError as error:
        message = f"the reference system divides by `{error.denominator}`, which is exactly zero"
        raise ProblemError(Diagnostic("division-by-zero", message, places[0].whole)) from None
    except (NoPointError, UnsupportedError):
        fault = None
    if fault is None or fault == _NONE:
        return
    if fault == _CONTRADICTION:
        message = "the equations of the reference system contradict one another, or the constraints"
        help_ = "give as many as there are accelerations and unknown forces, each true of the motion"
        raise ProblemError(Diagnostic("reference-contradictory", message, places[0].whole, help=help_))
    place = places[min(fault, len(places) - 1)].whole
    message = "an equation of a reference system is linear in accelerations and unknown forces, and has one of them"
    help_ = "differentiate a first integral; put what holds between coordinates and velocities under `constraints`"
    raise ProblemError(Diagnostic("reference-not-linear", message, place, help=help_))


_NONE, _CONTRADICTION = -1, -2


def _fault(moving: Point, system: System, unknowns: Sequence[sp.Symbol]) -> int:
    """The number of the first equation that is no equation of motion; otherwise `_CONTRADICTION` or `_NONE`."""
    constraints = system.accelerated_constraints
    rows = []
    for n, e in enumerate(system.equations):
        row = moving.affine([e], unknowns)
        if row is None or all(moving.arithmetic.vanishes(a) for a in row[0][:-1]):
            return n
        rows += row
    rows += moving.affine(constraints, unknowns) or []
    return _NONE if moving.rank(rows) == moving.rank([r[:-1] for r in rows]) else _CONTRADICTION
