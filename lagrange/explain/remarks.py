"""Notes on a problem that can be solved but may not be what was meant."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from lagrange.core.diagnostics import Diagnostic
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.motion import Method
from lagrange.mechanics.results import Solution
from lagrange.problem.model import Find, Friction, Problem


def remarks(solution: Solution, method: Method) -> tuple[Diagnostic, ...]:
    """Notes on angles and friction, and if a method was chosen but no equations of motion are asked for."""
    problem = solution.problem
    found = (*_below_kinetic(problem), *_in_radians(problem, solution.own.configuration))
    if method is Method.DALEMBERT or Find.MOTION in problem.find:
        return found
    message = f"`--method {method}` makes no difference here: no equations of motion are asked for"
    help_ = "equilibrium is found by the principle of virtual work; `find: motion` asks for equations of motion"
    return (*found, Diagnostic("method-without-motion", message, help=help_).as_note())


def _below_kinetic(problem: Problem) -> Iterator[Diagnostic]:
    """A note on each friction that is smaller at rest than in motion, as far as the file gives values."""
    values = {p.symbol: p.value for p in problem.parameters if p.value is not None}
    for f in problem.forces:
        if not isinstance(f, Friction) or f.static is None:
            continue
        if (f.coefficient - f.static).xreplace(values).is_positive:
            message = f"the friction `{f.name}` is smaller at rest than in motion"
            help_ = "`static:` is usually the larger coefficient; have the two been exchanged?"
            yield Diagnostic("static-below-kinetic", message, f.span, help=help_).as_note()


def _in_radians(problem: Problem, configuration: Configuration) -> Iterator[Diagnostic]:
    """A note on each bare number above 2π that occurs in sines and cosines only: degrees were probably meant."""
    large = [p for p in problem.parameters if p.value is not None and not p.measured and abs(p.value) > 2 * sp.pi]
    if not large:
        return
    vectors = [p.position for p in configuration.points] + [f.vector for f in configuration.loads]
    written = [c for v in vectors for c in v.fixed().components]
    written += [e for r in configuration.rows for e in (*r.coefficients, r.finite) if e is not None]
    arguments = {w for e in written for w in e.atoms(sp.sin, sp.cos, sp.tan)}
    outside = {s for e in written for s in e.xreplace({w: sp.Dummy() for w in arguments}).free_symbols}
    for p in large:
        if p.symbol not in outside and any(w.args[0] == p.symbol for w in arguments):
            message = f"the angle `{p.symbol.name}` is {p.value} radians: a bare number is in units of SI"
            help_ = f"if degrees are meant, write `{p.symbol.name}: {p.value} deg`"
            yield Diagnostic("angle-in-radians", message, p.value_span, help=help_).as_note()
