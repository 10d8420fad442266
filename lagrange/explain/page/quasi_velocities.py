"""Pages that end with quasi-velocities, without the long equations in the file's coordinates.

D'Alembert's principle is stated in vectors and written out once, in the quasi-velocities. Multipliers of constraints
that are not single forces say little: for a single body the whole reaction is R = m r'' − F, with the acceleration
known. Energies and reactions are written in the quasi-velocities where that is shorter: what the constraints make zero
is gone then, and (M + 2m) (y'' cos θ − x'' sin θ) is (M + 2m) v ω.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.core.operations import count_operations
from lagrange.core.symbols import DotProduct, TimeDerivative, VectorSymbol, prime
from lagrange.core.vectors import Vector
from lagrange.document.builders import display, listed, math, prose
from lagrange.document.derivation import (
    Block,
    Display,
    Emphasis,
    Equation,
    Math,
    Mathematics,
    Part,
    Prose,
    Ref,
    Rule,
    Step,
)
from lagrange.explain.displacements import solved_displacements
from lagrange.explain.limits import LONGEST_MULTIPLIER
from lagrange.explain.words import plural, the
from lagrange.mechanics.dynamics.equations import DalembertMotion
from lagrange.mechanics.path_reaction import reaction_along
from lagrange.mechanics.results import Solution
from lagrange.mechanics.rewriting.factors import with_common_factor
from lagrange.mechanics.rewriting.in_speeds import rates_by_speeds, substituted
from lagrange.problem.model import Problem

if TYPE_CHECKING:
    from lagrange.mechanics.dynamics.quasi_equations import QuasiVelocityForm


def ends_with_speeds(solution: Solution) -> bool:
    """Whether the equations of motion in quasi-velocities are those of the page."""
    own = solution.own
    written = own.dynamics.written if own.dynamics is not None else None
    equations = own.in_speeds.equations if own.in_speeds is not None else None
    return equations is not None and isinstance(written, DalembertMotion) and not solution.choices


def in_speeds_only(solution: Solution, steps: Iterable[Step]) -> Iterator[Step]:
    """The steps without the principle written out in the file's coordinates, and what else is not needed then."""
    for step in steps:
        if step.rule is Rule.PRINCIPLE:
            yield replace(step, body=step.body[:2])
        elif step.rule is Rule.DISPLACEMENTS:
            unused = solved_displacements(solution.own.elimination, solution.own.configuration)
            yield replace(step, body=tuple(b for b in step.body if b not in unused))
        elif step.rule is Rule.SOLVED_REACTIONS and _are_long(solution):
            continue
        elif step.rule is Rule.QUASI_VELOCITIES:
            yield replace(step, body=tuple(_without_rates(solution, b) for b in step.body))
        else:
            yield step


_AFTER_MOTION = (Rule.RESULT, Rule.SOLVED_REACTIONS, Rule.CONSERVED, Rule.MEANING)


def short_in_speeds(solution: Solution, steps: Iterable[Step]) -> Iterator[Step]:
    """The steps with energies and reactions in the quasi-velocities and their rates, where that is shorter."""
    form = solution.own.in_speeds
    rule = {} if form is None or not ends_with_speeds(solution) else rates_by_speeds(solution.problem.slots, form)

    known: set[str] = set()  # of the head, which comes before the quasi-velocities are defined

    def side(value: Mathematics) -> Mathematics:
        if not isinstance(value, sp.Expr) or not value.has(*rule) or count_operations(value) > LONGEST_MULTIPLIER:
            return value
        if isinstance(value, TimeDerivative):
            return TimeDerivative(side(value.args[0]))
        shorter = substituted(value, rule)
        new = {s.name.rstrip("'") for s in shorter.free_symbols - value.free_symbols}
        return shorter if count_operations(shorter) < count_operations(value) and not new - known else value

    def block(b: Block) -> Block:
        if isinstance(b, Display):
            return replace(b, equations=tuple(replace(e, sides=tuple(map(side, e.sides))) for e in b.equations))
        if isinstance(b, Prose):
            parts = (replace(p, sides=tuple(map(side, p.sides))) if isinstance(p, Math) else p for p in b.parts)
            return replace(b, parts=tuple(parts))
        return b

    speeds = set() if form is None else {u.name for u in form.velocities.symbols}
    for step in steps:
        known |= _names(step) if step.rule is Rule.RESULT else speeds
        after = rule and step.rule in _AFTER_MOTION and not step.folded
        yield replace(step, body=tuple(map(block, step.body))) if after else step


def _names(step: Step) -> set[str]:
    """The letters in the equations of a step, of u' that of u."""
    sides = [s for b in step.body if isinstance(b, Display) for e in b.equations for s in e.sides]
    return {s.name.rstrip("'") for side in sides if isinstance(side, sp.Expr) for s in side.free_symbols}


def _are_long(solution: Solution) -> bool:
    """Whether the multipliers are no single forces, and long: then the page has no room for them."""
    dynamics, law = solution.own.dynamics, solution.law
    if dynamics is None or dynamics.reactions is None or law is None:
        return False
    nameless = all(r.single is None and r.given is None for r in law.newton.reactions)
    values = [v for v in dynamics.reactions.multipliers.values() if v is not None]
    return (
        nameless
        and reaction_as_a_whole(solution) is None
        and any(count_operations(v) > LONGEST_MULTIPLIER for v in values)
    )


def _without_rates(solution: Solution, block: Block) -> Block:
    """The boxed equations without the kinematic ones, which stand above."""
    form = solution.own.in_speeds
    if not isinstance(block, Display) or not block.boxed or form is None:
        return block
    kinematic = {*form.velocities.kinematic.items()}
    lines = [e for e in block.equations if e.sides not in kinematic]
    if len(kinematic) < 3 or len(lines) == len(block.equations):
        return block
    lines[-1] = replace(lines[-1], condition=("with the kinematic equations",))  # no reference: a brief page has none
    return replace(block, equations=tuple(lines))


def reaction_as_a_whole(solution: Solution) -> Step | None:
    """R = m r'' − F of the only body; None where the multipliers say more, or another force is not in F."""
    own, law = solution.own, solution.law
    configuration = own.configuration
    if law is None or own.dynamics is None or len(configuration.points) != 1 or not configuration.rotations:
        return None
    if solution.long_reactions is not None or configuration.generalized:
        return None
    if configuration.links or configuration.potential != 0 or law.all_frictions or solution.choices:
        return None
    if any(r.single is not None for r in law.newton.reactions) or solution.problem.unknowns:
        return None
    reactions = own.dynamics.reactions
    if reactions is not None and any(
        r.given and reactions.multipliers.get(r.name) is not None for r in law.newton.reactions
    ):
        return None  # what the file has a name for is shown
    [point] = configuration.points
    if configuration.is_pinned(point) or any(f.elsewhere for f in configuration.loads):
        return None
    force = sum((f.vector for f in configuration.loads), Vector.zero())
    reaction, moved = VectorSymbol(f"R_{point.name}"), point.mass * VectorSymbol(f"r_{point.name}''")
    shown = moved - (VectorSymbol(f"F_{point.name}") if not force.is_zero else 0)
    sides = (reaction, shown) if force.is_zero else (reaction, shown, moved - force.as_sum())
    in_speeds = own.in_speeds.equations if own.in_speeds is not None else None
    known: tuple[Part, ...] = ()
    if in_speeds is not None and point.name in in_speeds.accelerations:
        known = ("with ", Ref(f"changed-in-speeds-r_{point.name}''"))
    words = f"By Newton's law the total reaction on {the(point.name)} is"
    line = Equation(sides, label=f"total-reaction-{point.name}", condition=known)
    body: list[Block] = [prose(words), display(line, boxed=True)]
    body += _across(solution, reaction)
    return Step(Rule.SOLVED_REACTIONS, "The reaction", tuple(body))


def _across(solution: Solution, reaction: VectorSymbol) -> Iterator[Block]:
    """The vertical component, where there is gravity."""
    gravity = solution.problem.gravity
    along = [n for n, c in enumerate(gravity.fixed().components) if c != 0] if gravity is not None else []
    if len(along) != 1:
        return
    [n] = along
    unit = Vector.zero().triad.units[n]
    x, y, z = (sp.Integer(k == n) for k in range(3))
    value = reaction_along(Vector((x, y, z)), solution.own.configuration)
    yield prose("Its vertical component is")
    yield display(Equation((DotProduct(reaction, unit), with_common_factor(value)), label="vertical-reaction"))


# -- by quadratures -----------------------------------------------------------------------------------------------


def by_quadrature(problem: Problem, form: QuasiVelocityForm | None) -> Iterator[Block]:
    """`Motion: v̇ contains the time only, so v = v₀ + ..., and from ẋ = v cos Ωt`, with the coordinates."""
    if form is None:
        return
    from lagrange.mechanics.integrated_speed import integrated_speed

    motion = integrated_speed(form, problem.scope.names())
    if motion is None:
        return
    lines = [Equation((s, value), label=f"quadrature-{s.name}") for s, value in motion.values.items()]
    whole = plural(len(lines), "a constant ", "constants ")
    yield prose(Emphasis("Motion"), ": ", math(prime(motion.speed)), f" contains the time only. With {whole}",
                *listed(map(math, motion.constants)), ", integration gives")  # fmt: skip
    yield display(*lines)
