"""A solved problem in JSON, version 1, for other programs: the results by name, and the derivation in steps.

Expressions are text in the language of problem files, so that they can be read back. A result that does not apply is
omitted, an undecided one is null. One problem makes an object, several make a list. The keys and their order are a
contract: a change of their meaning needs a new version.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import sympy as sp

from lagrange.core.printable import json_text
from lagrange.document.math_writer import TEXT, Writer
from lagrange.mechanics.constraints.displacements import possible_displacement, virtual_displacement
from lagrange.mechanics.dynamics.equations import LagrangeMotion
from lagrange.problem.values import no_values
from lagrange.render.json_momenta import beside_motion, hamiltonian
from lagrange.render.json_numbers import (
    add_oscillations,
    answered_question,
    condition_of_rest,
    critical,
    damped_modes,
    equations_in_numbers,
    impending_in_numbers,
    position,
    quantity,
    rest_in_numbers,
    searched,
)
from lagrange.render.json_steps import block, condition, side_as_sum, stability_conditions

if TYPE_CHECKING:
    from lagrange.algebra.closed_forms.solution_sets import Branch
    from lagrange.explain.report import Report
    from lagrange.mechanics.constraints.constraints import ConstraintAnalysis
    from lagrange.mechanics.dynamics.conservation import Conserved
    from lagrange.mechanics.dynamics.equations import EquationsOfMotion
    from lagrange.mechanics.dynamics.motion import Motion
    from lagrange.mechanics.dynamics.newton import Newton, WorkOfReaction
    from lagrange.mechanics.dynamics.quasi_equations import QuasiVelocityForm
    from lagrange.mechanics.dynamics.reactions import Reactions
    from lagrange.mechanics.dynamics.spot_values import SpotValue
    from lagrange.mechanics.equilibrium.equilibrium import Equilibrium
    from lagrange.mechanics.equilibrium.friction.friction_at_rest import AtRest
    from lagrange.mechanics.equilibrium.friction.rolling import Rolling
    from lagrange.mechanics.equilibrium.in_numbers import EquilibriaInNumbers
    from lagrange.mechanics.equilibrium.linearization import Linearization, SmallOscillations
    from lagrange.mechanics.equilibrium.stability import SecondVariation
    from lagrange.mechanics.equilibrium.static_reactions import ReactionsAtRest, StaticReactions
    from lagrange.mechanics.results import InCoordinates, Solution
    from lagrange.values.quantities import Values

VERSION = 1
Write = Callable[[Any], str]


def render(reports: Sequence[Report | None]) -> str:
    """The reports as JSON text: an object for one problem; a list for several, with null for one without a solution."""
    objects = [r and as_object(r) for r in reports]
    return json_text(objects[0] if len(objects) == 1 else objects, indent=1) + "\n"


def as_object(report: Report) -> dict[str, Any]:
    """One report as the object of version 1."""
    solution, notation = report.solution, report.notation
    problem, classification, own = solution.problem, solution.classification, solution.own
    write = Writer(TEXT, notation).plain
    entries: dict[str, Any] = {
        "version": VERSION,
        "problem": {"title": problem.title, "source": problem.source},
        "coordinates": [q.name for q in problem.slots.coordinates],
        "constraints": [_constraint(c, report, write) for c in classification.constraints],
        "classification": {
            "holonomic": classification.holonomic,
            "scleronomic": classification.scleronomic,
            "catastatic": classification.catastatic,
            "rank": classification.rank,
            "integrable_rank": classification.integrable_rank,
            "hidden": [write(r.function) for r in classification.hidden.found],
            "redundant": list(classification.redundant),
        },
        "degrees_of_freedom": classification.degrees_of_freedom,
        "configuration_dimension": classification.configuration_dimension,
        "possible_displacements": [
            f"{write(possible_displacement(r, problem.slots))} = 0" for r in classification.rows
        ],
        "virtual_displacements": [f"{write(virtual_displacement(r, problem.slots))} = 0" for r in classification.rows],
        "choices": [_choice(c, report.values, write) for c in solution.choices],
    }
    if own.equilibrium is not None:
        entries |= _statics(own.equilibrium, own.stability, own.in_numbers, write)
    if solution.law is not None:
        entries |= _newton(solution.law.newton, write, counted=own.motion is not None or not problem.unknowns)
    if own.dynamics is not None and isinstance(own.dynamics.written, LagrangeMotion):
        entries["method"] = "lagrange"
    entries |= _motion(own, report.values, write)
    if own.dynamics is not None and own.dynamics.reactions is not None:
        entries |= _reactions(solution, own.dynamics.reactions, report.values, write)
    if own.conserved is not None:
        entries["conserved"] = integrals(own.conserved, write)
    entries |= beside_motion(solution, write)
    if own.reactions_at_rest is not None:
        moving = entries.get("reactions", {})
        entries |= _reactions_at_rest(own.reactions_at_rest, solution.works, moving, report.values, write)
    if solution.asked:
        entries["asked"] = [
            answered_question(a, report.values or no_values(solution.problem), write) for a in solution.asked
        ]
    if solution.from_start is not None:
        entries["from_start"] = [
            {
                "solutions": {q.name: write(e) for q, e in m.solutions.items()},
                "conditions": [condition(c, write) for c in m.conditions],
            }
            for m in solution.from_start.motions
        ]
    entries |= _with_friction(solution, report.values, write)
    entries["checks"] = [{"name": _named(c.name, c.choice), "passed": c.passed, "how": c.how} for c in solution.checks]
    spots = [v.spot for v in solution.views]
    first = next((s for s in spots if s is not None), None)
    if first is not None:
        entries["spot"] = _spot(first, write)
    if solution.given_up:
        entries["given_up"] = solution.given_up
    entries["answers"] = [{"name": a.name, "verdict": a.verdict.value} for a in report.answers]
    entries["steps"] = [
        {
            "rule": s.rule.value,
            "title": s.title,
            "body": [written for b in s.body if (written := block(b, write))],
        }
        for s in report.derivation.steps
    ]
    return entries


def _with_friction(solution: Solution, values: Values | None, write: Write) -> dict[str, Any]:
    """Rest with friction and impending motion, in a choice of coordinates if there is one."""
    rests = [v.at_rest for v in reversed(solution.views)] + [v.rolling for v in reversed(solution.views)]
    resting = next((r for r in rests if r is not None), None)
    motions = next((v.impending for v in reversed(solution.views) if v.impending is not None), None)
    entries: dict[str, Any] = {}
    if resting is not None:
        entries["rest"] = _rest(resting, write) | rest_in_numbers(resting.cases, values, write)
    if motions is not None:
        entries["equilibrium"] = [_relations(b, write) for m in motions for b in m.equilibrium.branches]
        entries["impending"] = [
            {
                "slip": {c.name: write(side_as_sum(c.tangents[0] * sp.Integer(-m.senses[c.name]))) for c in m.contacts},
                "reactions": {name: write(force) for name, force in m.pressed.items()},
                "equilibrium": [_relations(b, write) for b in m.equilibrium.branches],
                "conditions": [_sign_conditions(b, write) for b in m.equilibrium.branches],
            } | impending_in_numbers(m, values, write)
            for m in motions
        ]  # fmt: skip
    return entries


def _relations(branch: Branch, write: Write) -> list[str]:
    return [f"{write(r.lhs)} = {write(r.rhs)}" for r in branch.equations]


def _sign_conditions(branch: Branch, write: Write) -> list[str]:
    return [condition(c, write) for c in branch.conditions]


def _rest(resting: AtRest | Rolling, write: Write) -> dict[str, Any]:
    """Conditions, all of which hold; where there are several cases, those of each are in `cases`."""
    from lagrange.mechanics.equilibrium.friction.friction_at_rest import AtRest

    equations = [f"{write(left)} = {write(right)}" for left, right in resting.relations]
    cases = [[*equations, *(condition_of_rest(c, write) for c in case)] for case in resting.cases]
    common = [c for c in cases[0] if all(c in case for case in cases)] if cases else equations
    friction = {name: [write(f) for f in forces] for name, forces in resting.friction.items()}
    result: dict[str, Any] = {
        "possible": bool(cases),
        "conditions": common,
        "friction": {name: f[0] if len(f) == 1 else f for name, f in friction.items()},
    }
    if isinstance(resting, AtRest):
        along = {c.name: write(side_as_sum(c.tangents[0])) for c in resting.contacts if len(c.tangents) == 1}
        forces = {u.name: write(f) for u, f in resting.forces.items() if u not in resting.open}
        where = [f"{write(c.left)} < {write(c.right)}" for c in resting.where]
        result |= {"directions": along, "forces": forces} | ({"where": where} if where else {})
        result |= {"unexamined": [f"{write(e)} = 0" for e in resting.unexamined]} if resting.unexamined else {}
    if len(cases) > 1:
        result["cases"] = cases
    if resting.open:
        result["open"] = [u.name for u in resting.open]
    return result | ({"assumed": [f"{write(e)} > 0" for e in resting.assumed]} if resting.assumed else {})


def _named(name: str, choice: str) -> str:
    return f"{choice}: {name}" if choice else name


def _constraint(c: ConstraintAnalysis, report: Report, write: Write) -> dict[str, Any]:
    constraint, row = c.constraint, c.row
    coordinates = report.solution.problem.slots.coordinates
    result: dict[str, Any] = {
        "name": constraint.name,
        "equation": f"{write(constraint.function)} = 0",
        "kind": "kinematic" if constraint.kinematic else "geometric",
    }
    if constraint.side is not None:
        result["one_sided"] = f"{write(constraint.function)} {'>=' if constraint.side > 0 else '<='} 0"
    if constraint.given is not None:
        result["given"] = f"{write(constraint.given.lhs)} = {write(constraint.given.rhs)}"
    if c.pfaffian:
        form = {q.name: write(a) for q, a in zip(coordinates, row.coefficients, strict=True)}
        result |= {"pfaffian": form | {"t": write(row.drift)}, "exact": c.exactness.exact}
    result["integrable"] = c.integrable
    if c.factor is not None:
        result["integrating_factor"] = write(c.factor)
    if c.integral is not None:
        result["integral"] = write(c.integral)
    return result | {"depends_on_time": c.depends_on_time, "catastatic": c.catastatic}


def _choice(c: InCoordinates, values: Values | None, write: Write) -> dict[str, Any]:
    coordinates = c.coordinates
    entries: dict[str, Any] = {
        "name": c.name,
        "coordinates": [q.name for q in coordinates.choice.coordinates],
        "independent": True,  # otherwise it would have been refused
        "branches": coordinates.branches,
    }
    if c.equilibrium is not None:
        entries |= _statics(c.equilibrium, c.stability, c.in_numbers, write)
    if c.dynamics is not None:
        slots = coordinates.configuration.slots
        forces = zip(slots.coordinates, c.dynamics.written.principle.forces, strict=True)
        entries["generalized_forces"] = {q.name: write(f) for q, f in forces}
    entries |= _motion(c, values, write)
    if c.dynamics is not None and c.dynamics.reactions is not None and c.dynamics.reactions.multipliers:
        reactions = c.dynamics.reactions
        entries["reactions"] = {
            name: {"multiplier": None if value is None else write(value)} | _single(name, reactions, values, write)
            for name, value in reactions.multipliers.items()
        }
    if c.conserved is not None:
        entries["conserved"] = integrals(c.conserved, write)
    if c.hamiltonian is not None:
        entries["hamiltonian"] = hamiltonian(c.hamiltonian, write)
    if c.reactions_at_rest is not None:
        entries |= _reactions_at_rest(c.reactions_at_rest, (), entries.get("reactions", {}), values, write)
    if c.spot is not None:
        entries["spot"] = _spot(c.spot, write)
    return entries


def _motion(view: InCoordinates, values: Values | None, write: Write) -> dict[str, Any]:
    """The equations of motion in one set of coordinates, in every form in which they were found."""
    entries: dict[str, Any] = {}
    if view.dynamics is not None:
        entries |= motion(view.dynamics, write)
        entries |= equations_in_numbers(view.dynamics.written, values, write)
        entries |= by_lagrange(view.dynamics.written, write)
        entries |= matrices(view.dynamics, write)
    if view.in_speeds is not None:
        entries["speeds"] = speeds(view.in_speeds, write)
    if view.linearization is not None:
        entries["linearization"] = linearized(view.linearization, write)
        if view.in_numbers is not None:
            add_oscillations(entries["linearization"], view.in_numbers)
    if view.equilibrium is not None or view.linearization is not None:
        entries |= critical(view, values)
    return entries


def _newton(newton: Newton, write: Write, counted: bool) -> dict[str, Any]:
    """Newton's law, and the count of unknowns; empty if the coordinates give no free bodies."""
    if newton.equations is None or newton.before is None or newton.after is None:
        return {}
    directed = {"count": newton.after.unknowns, "equations": newton.after.equations}
    counts = {"count": newton.before.unknowns, "equations": newton.before.equations, "with_directions": directed}
    equations = {"newton": [f"{write(a)} = {write(b)}" for a, b in newton.equations]}
    return equations | ({"unknowns": counts} if counted else {})


def _reactions(solution: Solution, reactions: Reactions, values: Values | None, write: Write) -> dict[str, Any]:
    """The reactions; omitted where they are too large, or not determined.

    A reaction that is too large in the file's coordinates is given in those of a choice, which is named.
    """
    entries: dict[str, Any] = {}
    if solution.works:
        there = [("", reactions)]
        there += [(c.name, c.dynamics.reactions) for c in solution.choices if c.dynamics and c.dynamics.reactions]
        entries["reactions"] = {w.reaction.name: _reaction(w, there, values, write) for w in solution.works}
    return entries


def _reaction(
    work: WorkOfReaction, there: Sequence[tuple[str, Reactions]], values: Values | None, write: Write
) -> dict[str, Any]:
    name = work.reaction.name
    entries: dict[str, Any] = {}
    choice, reactions = next(((c, r) for c, r in there if r.multipliers.get(name) is not None), there[0])
    value = reactions.multipliers.get(name)
    if value is not None:
        entries["multiplier"] = write(value)
    entries |= _single(name, reactions, values, write)
    if name in reactions.forces:
        entries["on"] = {p: write(side_as_sum(force)) for p, force in reactions.forces[name].items()}
    if name in reactions.moments:
        entries["moment_on"] = {b: write(side_as_sum(moment)) for b, moment in reactions.moments[name].items()}
    if choice:
        entries["choice"] = choice
    work_done = "0" if work.vanishes else None
    return entries | {"virtual_work": work_done, "possible_work": write(work.possible)}


def _single(name: str, reactions: Reactions, values: Values | None, write: Write) -> dict[str, Any]:
    """A reaction that is a single force: `force`, with the unit vector along which it acts on the first body of `on`.

    `tension` repeats the force where it is one; `contact` says how long a one-sided constraint acts. `number` is the
    force, or the multiplier, with the values.
    """
    contact = {"contact": f"{write(reactions.contacts[name])} >= 0"} if name in reactions.contacts else {}
    if name not in reactions.sizes:
        return contact | quantity(reactions.multipliers.get(name), values, write)
    size = write(reactions.sizes[name])
    result: dict[str, Any] = {"tension": size} if name in reactions.pulling else {}
    result["force"] = size
    if name in reactions.units:
        result["direction"] = write(side_as_sum(reactions.units[name]))
    number = quantity(reactions.sizes[name], values, write)
    return result | contact | number | ({"unit": "N"} if number and values is not None and values.units else {})


def _reactions_at_rest(
    static: StaticReactions,
    works: Sequence[WorkOfReaction],
    moving: dict[str, Any],
    values: Values | None,
    write: Write,
) -> dict[str, Any]:
    """The reactions: `at_equilibrium` has an entry for each alternative of `equilibrium`.

    Where there is only one alternative, its entry is repeated beside that list. Where reactions are not determined one
    by one, `reactions_determined` has the combinations that are.
    """
    names = [w.reaction.name for w in works] or [
        *dict.fromkeys(n for r in static.at if r for n in r.reactions.multipliers)
    ]
    reactions: dict[str, Any] = {}
    for name in names:
        at_rest = [r and _at_rest(name, r, values, write) for r in static.at]
        reactions[name] = dict(moving.get(name, (len(at_rest) == 1 and at_rest[0]) or {}))
        if name not in moving:
            reactions[name] |= next(
                ({"virtual_work": "0" if w.vanishes else None, "possible_work": write(w.possible)}
                 for w in works if w.reaction.name == name), {}
            )  # fmt: skip
        reactions[name]["at_equilibrium"] = at_rest
    determined = [
        [
            f"{write(sp.Add(*(share * symbol for share, symbol in c.terms)))} = {write(c.value)}"
            for c in (r.reactions.combinations if r else ())
        ]
        for r in static.at
    ]
    return {"reactions": reactions} | ({"reactions_determined": determined} if any(determined) else {})


def _at_rest(name: str, at_rest: ReactionsAtRest, values: Values | None, write: Write) -> dict[str, Any]:
    """One reaction at one equilibrium; what is not determined is omitted."""
    reactions = at_rest.reactions
    value = reactions.multipliers.get(name)
    result: dict[str, Any] = {} if value is None else {"multiplier": write(value)}
    result |= _single(name, reactions, values, write)
    if name in reactions.forces:
        result["on"] = {p: write(side_as_sum(force)) for p, force in reactions.forces[name].items()}
    return result


def _statics(
    equilibrium: Equilibrium,
    stability: SecondVariation | None,
    in_numbers: EquilibriaInNumbers | None,
    write: Write,
) -> dict[str, Any]:
    """Generalized forces and equilibria: one system of equations for each alternative, with its conditions."""
    coordinates = equilibrium.configuration.slots.coordinates
    result: dict[str, Any] = {
        "generalized_forces": {q.name: write(f) for q, f in zip(coordinates, equilibrium.work.forces, strict=True)},
        "equilibrium": [_relations(b, write) for b in equilibrium.branches],
        "equilibrium_conditions": [_sign_conditions(b, write) for b in equilibrium.branches],
        "equilibrium_exists": equilibrium.exists,
    }
    if any(equilibrium.pulls):
        result["spring_forces"] = [{name: write(f) for name, f in pulls.items()} for pulls in equilibrium.pulls]
    if equilibrium.outside:
        outside = [[f"{write(r.lhs)} = {write(r.rhs)}" for r in b.equations] for b in equilibrium.outside]
        result["equilibrium_outside_ranges"] = outside
    if stability is not None:
        result["stability"] = [s.verdict.value for s in stability.verdicts]
        result["stability_conditions"] = [stability_conditions(s, write) for s in stability.verdicts]
    if in_numbers is not None:
        result["equilibrium_in_numbers"] = [position(p) for p in in_numbers.positions]
        if in_numbers.numerical is not None:
            result["equilibrium_searched"] = searched(in_numbers.numerical)
    return result


def _spot(spot: SpotValue, write: Write) -> dict[str, Any]:
    return {
        "values": {s.name: _figures(v, write) for s, v in spot.values.items()},
        "accelerations": {s.name.rstrip("'"): _figures(v, write) for s, v in spot.accelerations.items()},
    }


def _figures(value: Any, write: Write) -> str:
    """A number to six figures; exact ones as they are."""
    return f"{float(value):.6g}" if value.is_Float else write(value)


def matrices(dynamics: Motion, write: Write) -> dict[str, Any]:
    """M and f, with A and b where constraints remain; the accelerations, all of them or none."""
    form = dynamics.matrices
    result: dict[str, Any] = {
        "mass_matrix": matrix(form.mass, write),
        "force_vector": [write(e) for e in form.force],
    }
    if form.constraint_matrix:
        result["constraint_matrix"] = matrix(form.constraint_matrix, write)
        result["constraint_vector"] = [write(e) for e in form.constraint_vector]
    solved = dynamics.accelerations
    if len(solved) == len(form.mass):
        result["accelerations"] = {s.name.rstrip("'"): write(v) for s, v in solved.items()}
    return result


def matrix(rows: Sequence[Sequence[Any]], write: Write) -> list[list[str]]:
    """A matrix as a list of its rows."""
    return [[write(e) for e in row] for row in rows]


def linearized(linearization: Linearization, write: Write) -> list[dict[str, Any]]:
    """One entry for each equilibrium; where there are no linear equations, the equilibrium alone."""
    coordinates = linearization.configuration.slots.coordinates
    entries = []
    for b, s in zip(linearization.branches, linearization.at, strict=True):
        entry: dict[str, Any] = {
            "equilibrium": [f"{write(r.lhs)} = {write(r.rhs)}" for r in b.equations],
            "conditions": [condition(c, write) for c in b.conditions],
        }
        oscillations = {"stable": None} if s is None else _oscillations(s, linearization, coordinates, write)
        entries.append(entry | oscillations)
    return entries


def _oscillations(
    s: SmallOscillations, linearization: Linearization, coordinates: Sequence[sp.Symbol], write: Write
) -> dict[str, Any]:
    """`displacements` gives every small displacement in terms of the independent ones, to which the matrices refer."""
    moved = [linearization.displacements[k] for k in s.free]
    shape = [sp.Add(*(c * x for c, x in zip(row, moved, strict=True))) for row in s.shape]
    stability = s.judgement.stability
    result: dict[str, Any] = {
        "displacements": {q.name: write(e) for q, e in zip(coordinates, shape, strict=True)},
        "mass_matrix": matrix(s.system.mass, write),
        "damping_matrix": matrix(s.system.damping, write),
        "stiffness_matrix": matrix(s.system.stiffness, write),
        "equations": [f"{write(e)} = 0" for e in s.equations],
        "characteristic": None if s.characteristic is None else f"{write(s.characteristic)} = 0",
    }
    if s.oscillates:
        result["frequencies"] = [
            {"squared": None if f.square is None else write(f.square), "equation": f"{write(s.remaining(f))} = 0"}
            | {"multiplicity": f.multiplicity, "modes": [[write(a) for a in mode] for mode in f.modes]}
            for f in s.frequencies
        ]
    if s.decaying is not None:
        result["damped_modes"] = damped_modes(s.decaying, write)
    decided = {"stable": True, "unstable": False}
    result |= {"stable": decided.get(stability.verdict.value), "stability": stability.verdict.value}
    return result | stability_conditions(stability, write)


def motion(dynamics: Motion, write: Write) -> dict[str, Any]:
    """The equations, what must not vanish, and the equations with multipliers where constraints remain."""
    result: dict[str, Any] = {
        "equations": _equations(dynamics.written, write),
        "conditions": _nonzero(dynamics.written.conditions, write),
    }
    if dynamics.written.closed is not None:
        velocities = dynamics.written.closed.velocities
        result["through_velocities"] = {v.name: write(e) for v, e in velocities.items()}
    if dynamics.with_multipliers is not None:
        result["equations_with_multipliers"] = [
            f"{write(a)} = {write(b)}" for a, b in dynamics.with_multipliers.equations
        ]
    return result


def _nonzero(excluded: Sequence[sp.Expr], write: Write) -> list[str]:
    return [f"{write(e)} != 0" for e in excluded]


def _equations(motion: EquationsOfMotion, write: Write) -> list[str]:
    """The equations of motion and the constraints that complete them."""
    slots = motion.configuration.slots
    rows = (r.velocity_form(slots) if r.finite is None else r.finite for r in motion.completing)
    return [f"{write(e)} = 0" for e in (*(e.expression for e in motion.final), *rows)]


def speeds(form: QuasiVelocityForm, write: Write) -> dict[str, Any]:
    """The quasi-velocities, the kinematic equations, what must not vanish, the equations of motion in them.

    `kinematic` has q' and `rates` has u', by name. Where the quasi-velocities are too few, `completed_by` names the
    coordinates whose velocities complete them.
    """
    quasi, equations = form.velocities, form.equations
    result: dict[str, Any] = {
        "definitions": {u.name: write(e) for u, e in quasi.definitions.items()},
        "kinematic": {v.name.rstrip("'"): write(e) for v, e in quasi.kinematic.items()},
        "conditions": _nonzero(equations.conditions if equations else quasi.pivots, write),
    }
    if quasi.completing:
        result["completed_by"] = [q.name for q in quasi.completing]
    if equations is not None:
        result["equations"] = [f"{write(e)} = 0" for e in equations.expressions]
        if equations.rates is not None:
            result["rates"] = {u.name.rstrip("'"): write(value) for u, value in equations.rates.items()}
    return result


def by_lagrange(motion: EquationsOfMotion, write: Write) -> dict[str, Any]:
    """T, V, p_k, and the Q_k of forces outside V; empty where Lagrange's equations are not the method."""
    if not isinstance(motion, LagrangeMotion):
        return {}
    principle, coordinates = motion.principle, motion.configuration.slots.coordinates

    def each(values: Sequence[sp.Expr]) -> dict[str, str]:
        return {q.name: write(v) for q, v in zip(coordinates, values, strict=True)}

    result: dict[str, Any] = {
        "kinetic_energy": write(principle.kinetic),
        "potential_energy": write(principle.potential),
        "momenta": each(principle.momenta),
        "generalized_forces": each(principle.applied),
    }
    if principle.has_quasi_coordinates:
        result["quasi_coordinate_terms"] = each(principle.quasi)
    if any(s != 0 for s in principle.of_masses):
        result["variable_mass_terms"] = each(principle.of_masses)
    if principle.moving != 0:
        result["lagrangian"] = write(principle.lagrangian)
    return {"lagrange": result}


def integrals(conserved: Conserved, write: Write) -> list[dict[str, Any]]:
    """The integrals; last the energy with its rate if it is not conserved (null: undecided)."""
    entries: list[dict[str, Any]] = []
    for i in conserved.integrals:
        entry: dict[str, Any] = {"kind": i.quantity.value}
        if i.coordinate is not None:
            entry["coordinate"] = i.coordinate.name
        entry |= {"expression": write(i.expression), "because": i.because.value}
        if i.displacement:
            entry["displacement"] = {q.name: write(x) for q, x in i.displacement.items()}
        if i.multipliers:
            entry["multipliers"] = [write(m) for m in i.multipliers]
        entries.append(entry)
    if conserved.energy is not None:
        rate = conserved.energy.rate
        expression = write(conserved.energy.expression)
        entries.append({"kind": "energy", "expression": expression, "rate": None if rate is None else write(rate)})
    return entries
