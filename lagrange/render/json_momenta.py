"""Masses that vary, forced oscillations, impacts, Hamilton's function, Routh's function and steady motions in JSON."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import sympy as sp

from lagrange.core.symbols import prime
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.variable_mass import REACTIVE, validities
from lagrange.render.json_steps import condition

if TYPE_CHECKING:
    from lagrange.mechanics.constraints.kinematics import Configuration
    from lagrange.mechanics.constraints.variable_mass import VariableMass
    from lagrange.mechanics.equilibrium.response import ForcedEquations, Response
    from lagrange.mechanics.momenta.hamiltonian import Hamiltonian
    from lagrange.mechanics.momenta.impact import ImpulsiveMotion
    from lagrange.mechanics.momenta.steady_motions import SteadyMotions
    from lagrange.mechanics.nearby.linear_motion import LinearMotion, StableRange
    from lagrange.mechanics.nearby.long_equations import LongEquations, LongReactions
    from lagrange.mechanics.nearby.one_state import StateInNumbers
    from lagrange.mechanics.results import InCoordinates, Solution

Write = Callable[[Any], str]


def beside_motion(solution: Solution, write: Write) -> dict[str, Any]:
    """`variable_masses` where there are any; `steady`, `hamiltonian`, `response` and `impact` if they are asked for."""
    entries: dict[str, Any] = {}
    views = solution.views
    configuration = solution.own.configuration
    if configuration.variable_masses:
        entries["variable_masses"] = {
            m.name: variable_mass(m, configuration, write) for m in configuration.variable_masses
        }
    steady = next((v for v in reversed(views) if v.steady is not None), None)
    if steady is not None and steady.steady is not None:
        entries["steady"] = steady_motions(steady.steady, write)
    in_momenta = next((v for v in views if v.hamiltonian is not None), None)
    if in_momenta is not None and in_momenta.hamiltonian is not None:
        entries["hamiltonian"] = hamiltonian(in_momenta.hamiltonian, write) | _named(in_momenta)
    forced = next((v for v in reversed(views) if v.forced is not None), None)
    if forced is not None and forced.forced is not None:
        entries["response"] = response(forced.forced, forced.response, write) | _named(forced)
    if solution.long_equations is not None:
        entries |= long_equations(solution.long_equations, write)
    if solution.at_start is not None:
        multipliers = {name: float(x) for name, x in solution.at_start.multipliers.items()}
        entries["at_start"] = at_state(solution.at_start) | {"multipliers": multipliers}
    if solution.linear_motion is not None:
        entries["linear_motion"] = linear_motion(solution.linear_motion, write)
    if (rest := solution.rest_in_numbers) is not None:
        words = {True: "stable", False: "unstable", None: None}
        place = {"coordinates": {q.name: float(x) for q, x in rest.position.items()}, "how": "numerical"}
        forces = {"multipliers": {name: float(x) for name, x in rest.multipliers.items()}}
        entries["equilibrium_in_numbers"] = [place | {"stability": words[rest.stable]} | forces]
    if solution.long_reactions is not None:
        entries["long_reactions"] = long_reactions(solution.long_reactions, write)
    if solution.impact is not None:
        entries["impact"] = impact(solution.impact, write)
    return entries


def variable_mass(m: VariableMass, configuration: Configuration, write: Write) -> dict[str, Any]:
    """`mass` and its `rate`; whether mass `leaves`; its `velocity`, and whether that is `relative`; the reactive force;
    `valid` where the mass is positive, if that is solved for one symbol.
    """
    force = next((f.vector for f in configuration.loads if f.on == m.name and f.name == REACTIVE), Vector.zero())
    result: dict[str, Any] = {
        "mass": write(m.mass),
        "rate": write(m.rate),
        "leaves": m.leaves,
        "velocity": write(m.velocity),
        "relative": m.relative,
        "reactive_force": write(force),
    }
    for v in validities(configuration.variable_masses, configuration.slots):
        if v.name == m.name and v.symbol is not None:
            result["valid"] = f"{write(v.symbol)} {'>' if v.above else '<'} {write(v.bound)}"
    return result


def long_reactions(reactions: LongReactions, write: Write) -> dict[str, Any]:
    """Forces with a name, or multipliers, `by_accelerations`; with values as `numbers` at a `state`."""
    result: dict[str, Any] = {"by_accelerations": {name: write(e) for name, e in reactions.by_accelerations.items()}}
    if reactions.at is not None:
        result |= at_state(reactions.at)
        result["numbers"] = {name: float(x) for name, x in reactions.numbers.items()}
    return result


def at_state(state: StateInNumbers) -> dict[str, Any]:
    """`state` and `accelerations`, numbers by name."""
    return {
        "state": {s.name: float(e) for s, e in state.state.items()},
        "accelerations": {s.name.rstrip("'"): float(e) for s, e in state.accelerations.items()},
    }


def long_equations(equations: LongEquations, write: Write) -> dict[str, Any]:
    """`definitions` of abbreviations, in their order, and the `equations` with multipliers, which use them."""
    lines = [f"{write(a)} = {write(b)}" for a, b in zip(equations.left, equations.right, strict=True)]
    return {"definitions": {z.name: write(e) for z, e in equations.definitions.items()}, "equations": lines}


def _range(r: StableRange) -> dict[str, Any]:
    """`letter` between `low` and `high`, which is null where there is no end."""
    return {"letter": r.letter.name, "low": float(r.low), "high": None if r.high is sp.oo else float(r.high)}


def linear_motion(motion: LinearMotion, write: Write) -> dict[str, Any]:
    """`about`: the steady motion; `blocks` of coordinates that are coupled, with the tables of ξ'', ξ', ξ."""

    def table(rows: Sequence[Sequence[Any]]) -> list[list[str]]:
        return [[write(e) for e in row] for row in rows]

    return {
        "about": {s.name: write(e) for s, e in motion.state.items()},
        "blocks": [
            {
                "coordinates": [q.name for q in b.coordinates],
                "mass": table(b.mass),
                "damping": table(b.damping),
                "stiffness": table(b.stiffness),
                "equations": [f"{write(e)} = 0" for e in b.equations],
            }
            | ({"exponents": [str(p) for p in b.exponents]} if b.exponents else {})
            | ({"stable_for": [_range(r) for r in b.stable_ranges]} if b.stable_ranges is not None else {})
            for b in motion.blocks
        ],
        "ignorable": [q.name for q in motion.ignorable],
    }


def _named(view: InCoordinates) -> dict[str, str]:
    return {"choice": view.name} if view.name else {}


def hamiltonian(hamiltonian: Hamiltonian, write: Write) -> dict[str, Any]:
    """`momenta` by coordinate; `velocities` in terms of them; `H`; `equations`; `cyclic` coordinates and `routhian`."""
    coordinates = hamiltonian.coordinates
    pairs = [(prime(q), v) for q, v in zip(coordinates, hamiltonian.velocities, strict=True)]
    pairs += [(prime(p), rate) for p, rate in zip(hamiltonian.momenta, hamiltonian.rates, strict=True)]
    result: dict[str, Any] = {
        "momenta": {q.name: write(p) for q, p in zip(coordinates, hamiltonian.energies.momenta, strict=True)},
        "symbols": {q.name: p.name for q, p in zip(coordinates, hamiltonian.momenta, strict=True)},
        "H": write(hamiltonian.function),
        "equations": [f"{write(left)} = {write(right)}" for left, right in pairs],
        "is_energy": hamiltonian.is_energy,
        "cyclic": [coordinates[c].name for c in hamiltonian.cyclic],
    }
    if hamiltonian.routhian is not None:
        result["routhian"] = write(hamiltonian.routhian)
    return result


def response(forced: ForcedEquations, response: Response | None, write: Write) -> dict[str, Any]:
    """`linear`: the forced equations; `amplitudes`, `phases` (the lag behind the drive) and `motions` by coordinate."""
    coordinates = forced.configuration.slots.coordinates
    result: dict[str, Any] = {
        "about": [f"{write(r.lhs)} = {write(r.rhs)}" for r in forced.branch.equations],
        "linear": [f"{write(left)} = {write(right)}" for left, right in forced.sides],
    }
    if response is None:
        return result
    names = [q.name for q in coordinates]
    result |= {
        "amplitudes": {q: write(e) for q, e in zip(names, response.amplitudes, strict=True)},
        "phases": {q: None if e is None else write(e) for q, e in zip(names, response.phases, strict=True)},
        "motions": {q: write(e) for q, e in zip(names, response.motions, strict=True)},
        "drive": write(response.drive.law),
        "frequency": write(response.drive.frequency),
        "resonances": [write(e) for e in response.resonances],
        "at_rest": {q: [write(e) for e in places] for q, places in zip(names, response.rests, strict=True) if places},
    }
    return result


def impact(motion: ImpulsiveMotion, write: Write) -> dict[str, Any]:
    """`velocities` just after, by coordinate; `impulses` by constraint, `null` where they are not determined, with the
    `directions` of those that are single forces; `energy_lost`, and where; `conditions` of contact.
    """
    single = {i.name: i.reaction.single for i in motion.impulses if i.reaction.single is not None}
    result: dict[str, Any] = {
        "velocities": {q.name: write(v) for q, v in motion.all_velocities.items()},
        "before": {q.name: write(v) for q, v in zip(motion.slots.coordinates, motion.before, strict=True)},
        "position": {q.name: write(v) for q, v in motion.position.items()},
        "impulses": {i.name: None if i.value is None else write(i.value) for i in motion.impulses},
        "directions": {
            name: {"on": s.on, "direction": write(s.direction.map(motion.at))}
            for name, s in single.items()
            if s.direction is not None
        },
        "energy_lost": write(motion.energy_lost),
        "lost_at": {i.name: write(i.lost) for i in motion.impulses if i.lost is not None},
        "kinetic_energy": {"before": write(motion.kinetic[0]), "after": write(motion.kinetic[1])},
        "work_of_impulses": write(motion.work),
        "conditions": [f"{write(c.quantity)} {'>=' if c.is_impulse else '>'} 0" for c in motion.conditions],
    }
    return result | ({"choice": motion.configuration.name} if motion.configuration.name else {})


def steady_motions(steady: SteadyMotions, write: Write) -> list[dict[str, Any]]:
    """One entry for each solution of the conditions, with the linear equations about it at constant momenta."""
    entries = []
    branches = [(f, *pair) for f in steady.families for pair in zip(f.about.branches, f.about.at, strict=True)]
    for family, b, s in branches:
        entry: dict[str, Any] = {
            "cyclic": [q.name for q in steady.cyclic],
            "conditions": [f"{write(r.lhs)} = {write(r.rhs)}" for r in family.relations(b)],
            "exists_where": [condition(c, write) for c in b.conditions],
        }
        if s is not None:
            stability = s.judgement.stability
            squares = [f.square for f in s.frequencies] if s.long_square is None else [s.long_square]
            entry["linear"] = [f"{write(e)} = 0" for e in s.equations]
            entry["frequencies"] = [None if w is None else write(sp.sqrt(w)) for w in squares]
            entry["stability"] = stability.verdict.value
            where = [condition(c, write) for c in stability.conditions]
            if where:
                entry["stable_where"] = " and ".join(where)
        entries.append(entry)
    return entries
