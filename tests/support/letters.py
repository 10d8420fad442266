"""The letters that a figure has to show: lengths of what is drawn, angles of the geometry, applied forces."""

from __future__ import annotations

import re

import sympy as sp

from lagrange.core.symbols import Sign
from lagrange.core.vectors import Vector
from lagrange.document.scene import Scene
from lagrange.mechanics.results import Solution
from lagrange.pictures.poses import _angles
from lagrange.problem.model import AppliedForce


def written(scenes: list[Scene]) -> set[str]:
    """The symbols in the labels."""
    return {s.name for scene in scenes for w in scene.labels if isinstance(w.content, sp.Expr)
            for s in w.content.free_symbols if isinstance(s, sp.Symbol)}  # fmt: skip


def of_geometry(solution: Solution) -> set[str]:
    """The parameters in positions, axes, constraints, ends of springs, and sizes of shapes, but for angles."""
    configuration, figure = solution.own.configuration, solution.problem.figure
    vectors = [p.position for p in configuration.points]
    vectors += [e for link in configuration.links for e in link.ends if isinstance(e, Vector)]
    vectors += [f.point for f in configuration.loads]
    expressions = [c for v in vectors for c in v.fixed().components]
    expressions += [sp.sympify(f, strict=True) for f in configuration.finite_constraints]
    expressions += [length for shape in figure.shapes.values() for length in shape.lengths]
    expressions += [c.radius for c in (*figure.circles, *figure.pulleys.values())]
    axes = [c for r in configuration.rotations for a in r.axes for c in a.fixed().components]
    angles = {*_angles([*expressions, *axes])}
    own = {p.symbol for p in solution.problem.parameters if not isinstance(p.symbol, Sign)}
    used = set().union(*(e.free_symbols for e in map(sp.sympify, expressions))) if expressions else set()
    return {s.name for s in (used & own) - angles}


def names_of(solution: Solution) -> set[str]:
    """What a label may be made of: the names of the file and of reactions, those of vectors that a page makes of them,
    and a few words.
    """
    problem, configuration = solution.problem, solution.own.configuration
    names = {*problem.scope.names(), *problem.abbreviations, *problem.figure.points, "O", "i", "j", "k", "t"}
    names |= {q.name for c in problem.choices for q in c.coordinates} | {q.name for q in configuration.slots.velocities}
    names |= {p.name for p in configuration.points} | {f.name for f in (*problem.forces, *configuration.loads)}
    names |= {link.name for link in configuration.links} | {r.name for r in configuration.rotations}
    reactions = solution.law.newton.reactions if solution.law is not None else ()
    names |= {size.name for r in reactions for size in (r.force, r.tension) if isinstance(size, sp.Symbol)}
    names |= {f"{letter}_{name}" for letter in ("F", "R", "r") for name in {*names}} | {"f", "r"}
    names |= {axis for r in configuration.rotations for axis in (*r.angular_velocity.triad.names, "e_1", "e_2", "e_3")}
    names |= {f"e_{n}" for n in ("r", "theta", "phi", "x", "y", "z", "1", "2", "3")}
    names |= {f"{letter}{n}" for letter in "en" for n in (1, 2, 3)}  # of the only body
    return names | {"friction", "velocity", "−∇V"}


def labels_of(scenes: list[Scene]) -> set[str]:
    """The names in the labels."""
    found = {w.content for scene in scenes for w in scene.labels if isinstance(w.content, str)}
    every = {
        s
        for scene in scenes
        for w in scene.labels
        if isinstance(w.content, sp.Expr)
        for s in w.content.atoms(sp.Symbol)
    }
    return found | {re.sub(r"^(?:delta|nabla|d)\((.*)\)$", r"\1", s.name) for s in every}


def of_forces(solution: Solution) -> set[str]:
    """The letters of forces that the file gives by one letter along a direction: P, Q, W, but no resistance b v."""
    moving = {*solution.own.configuration.slots.velocities}
    own = {p.symbol for p in solution.problem.parameters} | {*solution.problem.unknowns}
    found = set()
    for force in solution.problem.forces:
        if isinstance(force, AppliedForce) and not force.vector.fixed().as_sum().free_symbols & moving:
            letters = {f for c in force.vector.fixed().components for f in sp.Mul.make_args(c) if f in own}
            found |= {s.name for s in letters if len(letters) == 1}
    return found
