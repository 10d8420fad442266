"""JSON, version 1: what a solution has found, for other programs.

Expressions are text of the language of problem files, so that they can be read back. What does not apply is left out,
what is undecided is null. Several problems make a list.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING, Any

import sympy as sp

from lagrange.core.symbols import FormSymbol, Wedge
from lagrange.core.vectors import Vector
from lagrange.document.derivation import (
    Block,
    CheckMark,
    Display,
    Equation,
    Math,
    Matrices,
    Part,
    Picture,
    Prose,
    Ref,
    Table,
    Term,
)
from lagrange.document.math_writer import TEXT, Writer
from lagrange.mechanics.constraints.displacements import possible_displacement, virtual_displacement
from lagrange.mechanics.dynamics.multipliers import LagrangeMotion
from lagrange.render.json_linear import linearized, matrices, matrix
from lagrange.render.json_motion import by_lagrange, integrals, motion, speeds

if TYPE_CHECKING:
    from lagrange.explain.report import Report
    from lagrange.mechanics.constraints.constraints import ConstraintAnalysis
    from lagrange.mechanics.dynamics.newton import Newton
    from lagrange.mechanics.dynamics.reactions import Reactions
    from lagrange.mechanics.dynamics.spot_values import Spot
    from lagrange.mechanics.dynamics.workless import WorkOfReaction
    from lagrange.mechanics.equilibrium.equilibrium import Equilibrium
    from lagrange.mechanics.equilibrium.stability import SecondVariation
    from lagrange.mechanics.equilibrium.static_reactions import ReactionsAtRest, StaticReactions
    from lagrange.mechanics.solution import ChoiceSolution, Solution

VERSION = 1

Write = Callable[[Any], str]


def render(reports: Sequence[Report | None]) -> str:
    """The reports as JSON text: an object for one problem; a list for several, with null for one that is not solved."""
    found = [r and as_object(r) for r in reports]
    return json.dumps(found[0] if len(found) == 1 else found, ensure_ascii=False, indent=1) + "\n"


def as_object(report: Report) -> dict[str, Any]:
    """One report as the object of version 1."""
    solution, notation = report.solution, report.notation
    problem, classification = solution.problem, solution.classification
    write = Writer(TEXT, notation).plain
    found: dict[str, Any] = {
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
        "choices": [_choice(c, write) for c in solution.choices],
    }
    if solution.equilibrium is not None:
        found |= _statics(solution.equilibrium, solution.stability, write)
    if solution.law is not None:
        found |= _newton(solution.law.newton, write, counted=solution.motion is not None or not problem.unknowns)
    if solution.dynamics is not None and isinstance(solution.dynamics.written, LagrangeMotion):
        found["method"] = "lagrange"
    if solution.dynamics is not None:
        found |= motion(solution.dynamics, write)
        found |= by_lagrange(solution.dynamics.written, write)
        found |= matrices(solution.dynamics, write)
    if solution.in_speeds is not None:
        found["speeds"] = speeds(solution.in_speeds, write)
    if solution.linearization is not None:
        found["linearization"] = linearized(solution.linearization, write)
    if solution.dynamics is not None and solution.dynamics.reactions is not None:
        found |= _reactions(solution, solution.dynamics.reactions, write)
    if solution.conserved is not None:
        found["conserved"] = integrals(solution.conserved, write)
    if solution.reactions_at_rest is not None:
        found |= _reactions_at_rest(solution.reactions_at_rest, solution.works, found.get("reactions", {}), write)
    found["checks"] = [{"name": _named(c.name, c.choice), "passed": c.passed, "how": c.how} for c in solution.checks]
    spots = [solution.spot, *(c.spot for c in solution.choices)]
    first = next((s for s in spots if s is not None), None)
    if first is not None:
        found["spot"] = _spot(first, write)
    found["answers"] = [{"name": a.name, "verdict": a.verdict.value} for a in report.answers]
    found["steps"] = [
        {
            "rule": s.rule.value,
            "title": s.title,
            "body": [block for b in s.body if (block := _block(b, write))],
        }
        for s in report.derivation.steps
    ]
    return found


def _named(name: str, choice: str) -> str:
    return f"{choice}: {name}" if choice else name


def _constraint(c: ConstraintAnalysis, report: Report, write: Write) -> dict[str, Any]:
    constraint, row = c.constraint, c.row
    coordinates = report.solution.problem.slots.coordinates
    found: dict[str, Any] = {
        "name": constraint.name,
        "equation": f"{write(constraint.function)} = 0",
        "kind": "kinematic" if constraint.kinematic else "geometric",
    }
    if constraint.given is not None:
        found["given"] = f"{write(constraint.given.lhs)} = {write(constraint.given.rhs)}"
    if c.pfaffian:
        form = {q.name: write(a) for q, a in zip(coordinates, row.coefficients, strict=True)}
        found |= {"pfaffian": form | {"t": write(row.drift)}, "exact": c.exactness.exact}
    found["integrable"] = c.integrable
    if c.factor is not None:
        found["integrating_factor"] = write(c.factor)
    if c.integral is not None:
        found["integral"] = write(c.integral)
    return found | {"depends_on_time": c.depends_on_time, "catastatic": c.catastatic}


def _choice(c: ChoiceSolution, write: Write) -> dict[str, Any]:
    coordinates = c.coordinates
    found: dict[str, Any] = {
        "name": c.name,
        "coordinates": [q.name for q in coordinates.choice.coordinates],
        "independent": True,  # otherwise it would have been refused
        "branches": coordinates.branches,
    }
    if c.equilibrium is not None:
        found |= _statics(c.equilibrium, c.stability, write)
    if c.dynamics is not None:
        slots = coordinates.configuration.slots
        forces = zip(slots.coordinates, c.dynamics.written.principle.forces, strict=True)
        found["generalized_forces"] = {q.name: write(f) for q, f in forces}
        found |= motion(c.dynamics, write)
        found |= by_lagrange(c.dynamics.written, write)
        found |= matrices(c.dynamics, write)
    if c.in_speeds is not None:
        found["speeds"] = speeds(c.in_speeds, write)
    if c.linearization is not None:
        found["linearization"] = linearized(c.linearization, write)
    if c.dynamics is not None and c.dynamics.reactions is not None and c.dynamics.reactions.multipliers:
        values = c.dynamics.reactions.multipliers
        tensions = c.dynamics.reactions.tensions
        found["reactions"] = {
            name: {"multiplier": None if value is None else write(value)}
            | ({"tension": write(tensions[name])} if name in tensions else {})
            for name, value in values.items()
        }
    if c.conserved is not None:
        found["conserved"] = integrals(c.conserved, write)
    if c.reactions_at_rest is not None:
        found |= _reactions_at_rest(c.reactions_at_rest, (), found.get("reactions", {}), write)
    if c.spot is not None:
        found["spot"] = _spot(c.spot, write)
    return found


def _newton(newton: Newton, write: Write, counted: bool) -> dict[str, Any]:
    """Newton's law, and the count of unknowns; left out where the coordinates give no free bodies."""
    if newton.equations is None or newton.before is None or newton.after is None:
        return {}
    directed = {"count": newton.after.unknowns, "equations": newton.after.equations}
    counts = {"count": newton.before.unknowns, "equations": newton.before.equations, "with_directions": directed}
    equations = {"newton": [f"{write(a)} = {write(b)}" for a, b in newton.equations]}
    return equations | ({"unknowns": counts} if counted else {})


def _reactions(solution: Solution, reactions: Reactions, write: Write) -> dict[str, Any]:
    """The reactions; left out where they are too large, or not determined.

    A reaction that is too large in the file's coordinates is given in those of a choice, which is named.
    """
    found: dict[str, Any] = {}
    if solution.works:
        there = [("", reactions)]
        there += [(c.name, c.dynamics.reactions) for c in solution.choices if c.dynamics and c.dynamics.reactions]
        found["reactions"] = {w.reaction.name: _reaction(w, there, write) for w in solution.works}
    return found


def _reaction(work: WorkOfReaction, there: Sequence[tuple[str, Reactions]], write: Write) -> dict[str, Any]:
    name = work.reaction.name
    found: dict[str, Any] = {}
    choice, reactions = next(((c, r) for c, r in there if r.multipliers.get(name) is not None), there[0])
    value = reactions.multipliers.get(name)
    if value is not None:
        found["multiplier"] = write(value)
    if name in reactions.tensions:
        found["tension"] = write(reactions.tensions[name])
    if name in reactions.forces:
        found["on"] = {p: write(_shown(force)) for p, force in reactions.forces[name].items()}
    if name in reactions.moments:
        found["moment_on"] = {b: write(_shown(moment)) for b, moment in reactions.moments[name].items()}
    if choice:
        found["choice"] = choice
    work_done = "0" if work.vanishes else None
    return found | {"virtual_work": work_done, "possible_work": write(work.possible)}


def _reactions_at_rest(
    found: StaticReactions, works: Sequence[WorkOfReaction], moving: dict[str, Any], write: Write
) -> dict[str, Any]:
    """The reactions: `at_equilibrium` goes with the alternatives of `equilibrium`; those of the only one stand outside.

    Of reactions that are not determined one by one `reactions_determined` has the combinations that are.
    """
    names = [w.reaction.name for w in works] or [
        *dict.fromkeys(n for r in found.at if r for n in r.reactions.multipliers)
    ]
    reactions: dict[str, Any] = {}
    for name in names:
        there = [r and _at_rest(name, r, write) for r in found.at]
        reactions[name] = dict(moving.get(name, (len(there) == 1 and there[0]) or {}))
        if name not in moving:
            reactions[name] |= next(
                ({"virtual_work": "0" if w.vanishes else None, "possible_work": write(w.possible)}
                 for w in works if w.reaction.name == name), {}
            )  # fmt: skip
        reactions[name]["at_equilibrium"] = there
    determined = [
        [
            f"{write(sp.Add(*(share * symbol for share, symbol in c.terms)))} = {write(c.value)}"
            for c in (r.reactions.combinations if r else ())
        ]
        for r in found.at
    ]
    return {"reactions": reactions} | ({"reactions_determined": determined} if any(determined) else {})


def _at_rest(name: str, found: ReactionsAtRest, write: Write) -> dict[str, Any]:
    """One reaction at one equilibrium; what is not determined is left out."""
    reactions = found.reactions
    value = reactions.multipliers.get(name)
    result: dict[str, Any] = {} if value is None else {"multiplier": write(value)}
    if name in reactions.tensions:
        result["tension"] = write(reactions.tensions[name])
    if name in reactions.forces:
        result["on"] = {p: write(_shown(force)) for p, force in reactions.forces[name].items()}
    return result


def _statics(found: Equilibrium, stability: SecondVariation | None, write: Write) -> dict[str, Any]:
    """Generalized forces and equilibria: alternatives, each a system of equations, its conditions beside it."""
    coordinates = found.configuration.slots.coordinates
    result: dict[str, Any] = {
        "generalized_forces": {q.name: write(f) for q, f in zip(coordinates, found.work.forces, strict=True)},
        "equilibrium": [[f"{write(r.lhs)} = {write(r.rhs)}" for r in b.equations] for b in found.branches],
        "equilibrium_conditions": [
            [f"{write(c.lhs)} {c.relation} {write(c.rhs)}" for c in b.conditions] for b in found.branches
        ],
        "equilibrium_exists": found.exists,
    }
    if stability is not None:
        result["stability"] = [s.verdict.value for s in stability.verdicts]
    return result


def _spot(spot: Spot, write: Write) -> dict[str, Any]:
    return {
        "values": {s.name: _figures(v, write) for s, v in spot.values.items()},
        "accelerations": {s.name.rstrip("'"): _figures(v, write) for s, v in spot.accelerations.items()},
    }


def _figures(value: Any, write: Write) -> str:
    """A number to six figures; exact ones as they are."""
    return f"{float(value):.6g}" if value.is_Float else write(value)


def _block(block: Block, write: Write) -> dict[str, Any]:
    match block:
        case Prose(parts=parts):
            return {"prose": _sentence(parts, write)}
        case Display(equations=equations, boxed=boxed):
            return {"equations": [_equation(e, write) for e in equations], "result": boxed}
        case Table(header=header, rows=rows):
            cells = [[_sentence((cell,), write) for cell in row] for row in rows]
            return {"table": {"header": [_sentence((h,), write) for h in header], "rows": cells}}
        case Matrices(named=named):
            return {"matrices": {name.name: matrix(rows, write) for name, rows in named}}
        case CheckMark(name=name, passed=passed, how=how):
            return {"check": _sentence(name, write), "passed": passed, "how": how}
        case Picture():
            return {}  # it says nothing that is not said in words


def _equation(equation: Equation, write: Write) -> dict[str, Any]:
    """An equation; `text` can be read back. An equation between exterior forms cannot, and is called `form`."""
    of_forms = any(isinstance(s, sp.Expr) and s.has(Wedge, FormSymbol) for s in equation.sides)
    written = f" {equation.relation} ".join(write(_shown(s)) for s in equation.sides)
    found: dict[str, Any] = {"form" if of_forms else "text": written}
    if equation.label:
        found["label"] = equation.label
    if equation.condition:
        found["condition"] = _sentence(equation.condition, write)
    return found


def _shown(side: Any) -> Any:
    return side.as_sum() if isinstance(side, Vector) else side


def _sentence(parts: Sequence[Part], write: Write) -> str:
    return "".join(_words(parts, write))


def _words(parts: Sequence[Part], write: Write) -> Iterator[str]:
    for part in parts:
        match part:
            case str():
                yield part
            case Math(sides=sides, relation=relation):
                yield f" {relation} ".join(write(_shown(s)) for s in sides)
            case Ref(label=label):
                yield f"[{label}]"
            case Term(word=word):
                yield word
