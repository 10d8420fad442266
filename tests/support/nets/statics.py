"""Statics: what is printed of equilibria, their stability, reactions and small oscillations, against places of rest in numbers.

Each statement is tested as it is written: relations and conditions are evaluated with numbers for the parameters. Points of each branch
are sampled from its relations alone, and must be in equilibrium; each place of rest must satisfy a branch.
"""

from __future__ import annotations

import math
import random
import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from tests.support.nets.evaluate import VECTORS, NotReadError, evaluate, holds, names_in, python_name, sides
from tests.support.nets.rest import (
    Rest,
    imbalance,
    is_kink,
    is_pole,
    is_singular,
    newton,
    rests,
    rests_at_pole,
    start_in,
)
from tests.support.nets.run import Finding, Printed, printed, wrong_names
from tests.support.nets.statics_systems import random_system
from tests.support.nets.system import System, turned
from tests.support.nets.taylor import Taylor, variables

Array = Any
DRAWS = 2
"""Values of the parameters that are tried."""
SAMPLES = 10
"""Places from which points of a branch are sought."""


def findings(seed: int) -> list[Finding]:
    """One random system, and the same written in another way."""
    rng = random.Random(seed)
    system = random_system(rng)
    found = check_system(system, random.Random(seed), checking=seed % 3 == 0)
    if seed % 4 == 1:
        other = rewritten(system, rng)
        found += [
            replace(f, kind=f"{f.kind} (rewritten)") for f in check_system(other, random.Random(seed), checking=False)
        ]
    return found


def check_system(system: System, rng: random.Random, checking: bool = True) -> list[Finding]:
    """All that is not true of what is printed for a system. checking: whether `check` is asked of the list as well."""
    shown = printed(system.text)
    if isinstance(shown, Finding):
        return [shown]
    found = wrong_names(shown)
    draws = [{p: rng.uniform(0.4, 3) * (rng.choice([-1, 1]) if p in system.real else 1) for p in system.parameters}
             for _ in range(DRAWS if system.parameters else 1)]  # fmt: skip
    places = [r for parameters in draws for r in rests(system, parameters, rng)]
    places = [
        r for r in places if not is_singular(system, r.q, r.parameters) and not is_kink(system, r.q, r.parameters)
    ]
    places = [r for r in places if not _is_of_chart(system, r)]
    try:
        found += _compared(system, shown, places, draws, rng)
        for name, (chart, _) in system.choices.items():
            in_chart = [r for parameters in draws for r in rests(chart, parameters, rng)]
            in_chart = [r for r in in_chart if not _is_of_chart(chart, r)]
            found += _compared(chart, shown.in_choice(name), in_chart, draws, rng, system)
        if checking:
            found += list(_judged(system, shown, draws, rng))
    except NotReadError as error:
        found.append(Finding("not read back", str(error), "what is printed can be read", shown.text))
    return list({f.kind: replace(f, text=system.text) for f in reversed(found)}.values())


def _is_of_chart(system: System, r: Rest) -> bool:
    return is_pole(system, r.q, r.parameters) is not None and not rests_at_pole(system, r.q, r.parameters)


def _compared(
    system: System, shown: Printed, places: Sequence[Rest], draws: Sequence[dict[str, float]], rng: random.Random,
    file: System | None = None,
) -> list[Finding]:  # fmt: skip
    """file: the system in the coordinates of the file, where `system` is that in a choice."""
    if shown.json.get("equilibrium") is None:  # given up, which is said
        return []
    branches = list(zip(shown.json["equilibrium"], shown.json["equilibrium_conditions"], strict=True))
    named_singular = "coordinates are singular there" in shown.page()
    open_existence = "whether there is one is left open" in shown.page()
    found = [f for branch in branches for f in _points(system, branch, draws, rng, named_singular, open_existence)]
    for r in places:
        if not any(satisfies(system, r, *b) for b in branches):
            said = "; ".join(" and ".join(b) for b, _ in branches) or "no equilibrium"
            found.append(Finding("missing equilibrium", said, f"also {_where(system, r)}", ""))
            break
    if not system.forms:
        found += _stability(system, shown, branches, places)
        found += _oscillations(system, shown, places)
    return found + _reactions(system, file or system, shown, branches, places)


# Places


def _where(system: System, r: Rest) -> str:
    values = dict(zip(system.coordinates, (float(x) for x in r.q), strict=True)) | r.parameters
    return ", ".join(f"{n} = {v:.6g}" for n, v in values.items())


def _residual(system: System, text: str, names: dict[str, Any]) -> Any:
    """Left minus right side; of an angle, modulo 2π."""
    left, _, right = sides(text)
    value = evaluate(left, names) - evaluate(right, names)
    if left in system.angles:
        plain = value.value if isinstance(value, Taylor) else value
        if math.isfinite(plain):
            value = value - (plain - turned(plain))
    return value


def satisfies(system: System, r: Rest, relations: Sequence[str], conditions: Sequence[str]) -> bool:
    """Whether a place of rest is one of a branch; where all coordinates may be turned together, in any of its turns."""
    turns = (0, -1, 1) if system.turns_as_a_whole else (0,)
    return any(_satisfies(system, r, r.q + 2 * math.pi * n, relations, conditions) for n in turns)


def _satisfies(system: System, r: Rest, q: Array, relations: Sequence[str], conditions: Sequence[str]) -> bool:
    names = system.scope(q, r.parameters)
    tolerance = 3e-3 if r.degenerate else 1e-5
    varied = system.names(variables(q, 1), r.parameters)
    if any("lambda_" in text for text in relations):  # where the conditions are not solved for the coordinates alone
        solved = multipliers(system, q, r.parameters)
        names, varied = names | solved, varied | solved
    zero = varied[system.coordinates[0]] * 0
    for text in relations:
        left = sides(text)[0]
        size = 1.0 if left in system.angles else 1 + abs(evaluate(left, names))
        residual = zero + _residual(system, text, varied)
        # A polynomial with large coefficients is large very near its root.
        if not abs(residual.value) <= tolerance * (size + float(np.abs(residual.gradient).max())):
            return False
    return all(holds(c, names, 1e-5) is not False for c in conditions)


def multipliers(system: System, q: Array, parameters: dict[str, float]) -> dict[str, float]:
    """λ of the finite constraints at a place of rest: Σ λ ∂f/∂q = ∂V/∂q."""
    rows = np.array([f.gradient for f in system.finite(q, parameters)])
    solved = np.linalg.lstsq(rows.T, system.energy(q, parameters).gradient, rcond=None)[0]
    return {m: float(x) for m, x in zip(multiplier_names(system), solved, strict=True)}


def multiplier_names(system: System) -> list[str]:
    """λ of the finite constraints as they are printed."""
    return [python_name(f"lambda_{c}") for c in system.constraints]


def sampled(
    system: System, relations: Sequence[str], parameters: dict[str, float], rng: random.Random, samples: int = SAMPLES
) -> Iterator[Array]:
    """Points that satisfy the relations of a branch, and nothing else of the system; multipliers are unknowns too."""
    n = len(system.coordinates)
    unknown = [m for m in multiplier_names(system) if any(m in names_in(t) for t in relations)]

    def at(q: Array) -> tuple[Array, Array]:
        varied = variables(q, 1)
        names = system.names(varied[:n], parameters) | dict(zip(unknown, varied[n:], strict=True))
        zero = varied[0] * 0
        values = [zero + _residual(system, t, names) for t in relations]
        return np.array([v.value for v in values]), np.array([v.gradient for v in values]).reshape(len(values), len(q))

    for _ in range(samples):
        start = np.array([*start_in(system, rng), *(rng.gauss(0, 3) for _ in unknown)])
        result = newton(at, start, steps=40) if relations else (start, None)
        if result is not None:
            yield result[0][:n]


def _points(
    system: System, branch: tuple[list[str], list[str]], draws: Sequence[dict[str, float]], rng: random.Random,
    named_singular: bool, open_existence: bool,
) -> Iterator[Finding]:  # fmt: skip
    """Points of a branch that are in no equilibrium; a branch without points.

    named_singular  whether poles are named as such
    open_existence  whether the page says that unsolved equations may have no real solution
    """
    relations, conditions = branch
    said = " and ".join(relations) + (f" where {', '.join(conditions)}" if conditions else "")
    any_point = outside = False
    for parameters in draws:
        for q in sampled(system, relations, parameters, rng):
            scope = system.scope(q, parameters)
            # Near an excluded place Newton's method converges slowly, and its points say nothing.
            if any(holds(c, scope, 1e-4 if " != " in c else 1e-7) in (False, None) for c in conditions):
                outside = True
                continue
            any_point = True
            force, broken = imbalance(system, q, parameters)
            where = ", ".join(f"{n} = {float(v):.6g}" for n, v in scope.items())
            if broken > 1e-5:
                yield Finding("breaks a constraint", said, f"at {where} a constraint is off by {broken:.3g}")
                return
            if not force < 1e7:
                if all(abs(x) < 50 for x in q):
                    yield Finding("no force there", said, f"at {where} a force has no value or direction")
                    return
                continue
            size = 1 + float(np.abs(system.energy(q, parameters).gradient).max())
            if force > 1e-5 * size:
                yield Finding("false equilibrium", said, f"at {where} a force {force:.4g} remains")
                return
            if named_singular:
                continue
            if is_pole(system, q, parameters) is not None and not rests_at_pole(system, q, parameters):
                yield Finding(
                    "pole of a chart", said, f"at {where} the coordinates are singular, and there is no equilibrium"
                )
                return
    solvable = any(n in system.coordinates for t in relations for n in names_in(t))
    if open_existence and not all(SOLVED.match(t) for t in relations):
        return
    if any(names_in(t).isdisjoint({*system.coordinates, *multiplier_names(system)}) for t in relations):
        return  # a relation between parameters alone, which the draws do not satisfy
    if not solvable or any_point or outside or any(c.split()[-2] != "!=" for c in conditions):
        return
    if not any(True for parameters in draws for _ in sampled(system, relations, parameters, rng, 40)):
        yield Finding("no point", said, "no real point found that satisfies it")


# Stability

SOLVED = re.compile(r"(\w+|\w+\(\w+\)) = ")
STABLE_WHERE = re.compile(r"(?<!un)stable where (.*?)(?:, unstable where|; elsewhere|\.(?:\s|\"|$))")


def conditions_of_stability(shown: Printed, n: int) -> list[str] | None:
    """The conditions on the page under which the n-th equilibrium is stable; None if they are not found there."""
    label = f"At [equilibrium{shown.choice and '-' + shown.choice}-{n}]"
    for step in shown.json["steps"]:
        if step["rule"] != "equilibrium":
            continue
        for block in step["body"]:
            for sentence in re.split(r"(?=At \[equilibrium-)", str(block.get("prose", ""))):
                if sentence.startswith(label) and (match := STABLE_WHERE.search(sentence + " ")):
                    return [c for c in re.split(r", (?![^(]*\))| and ", match[1]) if c]
    return None


def _stability(
    system: System, shown: Printed, branches: Sequence[tuple[list[str], list[str]]], places: Sequence[Rest]
) -> list[Finding]:
    found = []
    for n, verdict in enumerate(shown.json.get("stability", [])):
        at = [r for r in places if satisfies(system, r, *branches[n])]
        said = f"{' and '.join(branches[n][0])}: {verdict}"
        conditions = conditions_of_stability(shown, n + 1) if verdict == "conditional" else None
        unstable = shown.json["stability_conditions"][n].get("unstable_where")
        found += _judged_stability(system, at, verdict, conditions, said, "stability", unstable)
    return found


def _judged_stability(
    system: System, places: Sequence[Rest], verdict: str, conditions: list[str] | None, said: str, kind: str,
    unstable: list[list[str]] | None = None,
) -> list[Finding]:  # fmt: skip
    """One verdict against the numbers at each of its places. Undecided is no fault where equations are left unsolved.

    unstable  conditions of an undecided verdict: where all of one list hold it is unstable
    """
    solved = all(SOLVED.match(part) for part in said.removesuffix(f": {verdict}").split(" and "))
    truths = {r.stable for r in places}
    for r in places:
        if r.stable is None:
            continue
        true = f"{'stable' if r.stable else 'unstable'} at {_where(system, r)} (lowest eigenvalue {r.lowest:.3g} of the largest)"
        if verdict in ("stable", "unstable") and (verdict == "stable") != r.stable:
            return [Finding(kind, said, true)]
        if verdict == "conditional" and conditions is not None:
            each = [holds(c, system.scope(r.q, r.parameters)) for c in conditions]
            if None not in each and all(each) != r.stable:
                return [Finding(f"condition of {kind}", f"{said}, stable where {' and '.join(conditions)}", true)]
        holding = [
            all(holds(c, system.scope(r.q, r.parameters)) for c in alternative) for alternative in unstable or ()
        ]
        if r.stable and any(holding):
            return [Finding(f"condition of {kind}", f"{said}, unstable where {unstable}", true)]
    if verdict == "undecided" and not unstable and solved and len(truths) == 1 and None not in truths:
        return [
            Finding(
                f"undecided {kind}", said, f"{'stable' if True in truths else 'unstable'} at all {len(places)} places"
            )
        ]
    return []


def _oscillations(system: System, shown: Printed, places: Sequence[Rest]) -> list[Finding]:
    found = []
    for entry in shown.json.get("linearization", []):
        at = [r for r in places if satisfies(system, r, entry["equilibrium"], entry.get("conditions", []))]
        at = [r for r in at if r.squares is not None and is_pole(system, r.q, r.parameters) is None]
        verdict = entry.get("stability")
        said = " and ".join(entry["equilibrium"])
        if verdict:
            found += _judged_stability(
                system, at, verdict, entry.get("stable_where"), f"{said}: {verdict}", "linear stability",
                entry.get("unstable_where"),
            )  # fmt: skip
        frequencies = entry.get("frequencies") or []
        if verdict is None or any(f["squared"] is None for f in frequencies):
            continue
        for r in at:
            scope = system.scope(r.q, r.parameters)
            stated = sorted(evaluate(f["squared"], scope) for f in frequencies for _ in range(f["multiplicity"]))
            true = r.squares or []
            if not r.degenerate and not _agree(stated, true):
                found.append(
                    Finding("frequencies", f"{said}: ω² = {_listed(stated)}", f"{_listed(true)} at {_where(system, r)}")
                )
                break
    return found


def _listed(values: Sequence[float]) -> str:
    return ", ".join(f"{v:.6g}" for v in values)


def _agree(a: Sequence[float], b: Sequence[float]) -> bool:
    size = max((abs(x) for x in b), default=1.0) + 1e-9
    return len(a) == len(b) and all(abs(x - y) < 1e-4 * size for x, y in zip(a, b, strict=True))


# Reactions


def _reactions(
    system: System, file: System, shown: Printed, branches: Sequence[tuple[list[str], list[str]]],
    places: Sequence[Rest],
) -> list[Finding]:  # fmt: skip
    """The forces of each finite constraint on each particle: λ ∂f/∂r, where the positions are the coordinates themselves.

    Σ λ ∂f/∂q = ∂V/∂q is solved in the file's coordinates, also for what is printed in a choice.
    """
    stated = shown.json.get("reactions", {})
    for n, r in [(n, r) for n in range(len(branches)) for r in places]:
        given = {c: entries[n] for c in file.constraints if (entries := stated.get(c, {}).get("at_equilibrium"))}
        if r.degenerate or not any(given.values()) or not satisfies(system, r, *branches[n]):
            continue
        q = _in_file(system, file, shown.choice, r)
        gradients = dict(zip(file.constraints, (f.gradient for f in file.finite(q, r.parameters)), strict=True))
        rows = np.array([*gradients.values()])
        if np.linalg.svd(rows)[1][-1] < 1e-6:
            continue
        solved = multipliers(file, q, r.parameters)
        scope = VECTORS | system.scope(r.q, r.parameters) | solved
        for (c, gradient), multiplier in zip(gradients.items(), solved.values(), strict=True):
            for said, value, true in _stated_reaction(given.get(c), file, gradient * multiplier, multiplier, scope):
                errors = [abs(x - y) / (1 + abs(y)) for x, y in zip(value, true, strict=False) if not math.isnan(y)]
                if not all(e < 1e-4 for e in errors):
                    return [Finding("reaction", f"{c}, {said} = {value} at {_where(system, r)}", f"{true}")]
    return []


def _in_file(system: System, file: System, choice: str, r: Rest) -> Array:
    """The file's coordinates at a place of rest of a choice."""
    if system is file:
        return r.q
    substitute, names = file.choices[choice][1], system.names([float(x) for x in r.q], r.parameters)
    return np.array([evaluate(substitute.get(x, x), names) for x in file.coordinates])


def _stated_reaction(
    given: dict[str, Any] | None, file: System, total: Array, multiplier: float, scope: dict[str, Any]
) -> Iterator[tuple[str, list[float], list[float]]]:
    """What is printed of one reaction, its value, and the true one; nan where a coordinate is not one of a particle."""
    if not given:
        return
    if given.get("multiplier") is not None:
        yield f"λ: {given['multiplier']}", [evaluate(given["multiplier"], scope)], [float(multiplier)]
    forces = {p: evaluate(text, scope) + np.zeros(3) for p, text in given.get("on", {}).items()}
    for particle, force in forces.items():
        own = [file.coordinates.index(x) if x in file.coordinates else None for x in file.particles[particle][1]]
        true = [float(total[k]) if k is not None else math.nan for k in own]
        yield f"on {particle}: {given['on'][particle]}", [*map(float, force)], true
    if forces and given.get("force") is not None and given.get("direction") is not None:
        along = evaluate(given["force"], scope) * (evaluate(given["direction"], scope) + np.zeros(3))
        yield (
            f"N n: ({given['force']}) ({given['direction']})",
            [*map(float, along)],
            [*map(float, next(iter(forces.values())))],
        )


# What `check` says of the list


def _judged(system: System, shown: Printed, draws: Sequence[dict[str, float]], rng: random.Random) -> Iterator[Finding]:
    """The program's own list is equivalent, and with a branch dropped or moved it is not."""
    branches = shown.json.get("equilibrium", [])
    if not branches or not all(branches) or shown.json.get("equilibrium_exists") is not True:
        return
    conditions = shown.json["equilibrium_conditions"]
    verdict = _safely(lambda: shown.verdict(branches))
    if verdict not in ("equivalent", "undecided"):
        yield Finding("own list", f"`check` calls {branches} {verdict}", "equivalent: it is what the program prints")
    n = rng.randrange(len(branches))
    rest = [b for k, b in enumerate(branches) if k != n]
    if rest and verdict == "equivalent" and _is_needed(system, branches, conditions, n, draws, rng):
        dropped = _safely(lambda: shown.verdict(rest))
        if dropped == "equivalent":
            yield Finding("dropped branch", f"`check` calls {rest} equivalent", f"{branches[n]} is missing")
    left, _, right = sides(branches[n][0])
    if left in system.coordinates and verdict == "equivalent":
        moved = [f"{left} = {right} + 1/7", *branches[n][1:]]
        if not any(_balanced(system, q, p) for p in draws for q in sampled(system, moved, p, rng, 4)):
            judged = _safely(lambda: shown.verdict([*rest, moved]))
            if judged == "equivalent":
                yield Finding(
                    "moved branch", f"`check` calls {[*rest, moved]} equivalent", f"{moved} is no equilibrium"
                )


def _safely(verdict: Callable[[], str]) -> str:
    try:
        return verdict()
    except Exception as error:
        return f"{type(error).__name__}: {error}"[:200]


def _balanced(system: System, q: Array, parameters: dict[str, float]) -> bool:
    force, broken = imbalance(system, q, parameters)
    return not (force > 1e-5 or broken > 1e-5)


def _is_needed(
    system: System, branches: Sequence[list[str]], conditions: Sequence[list[str]], n: int, draws: Sequence[dict[str, float]],
    rng: random.Random,
) -> bool:  # fmt: skip
    """Whether a branch has a point of equilibrium that no other has."""
    for parameters in draws:
        for q in sampled(system, branches[n], parameters, rng, 4):
            r = Rest(q, np.zeros(0), parameters, None, None, False)
            if (
                _balanced(system, q, parameters)
                and all(holds(c, system.scope(q, parameters)) for c in conditions[n])
                and not any(satisfies(system, r, b, []) for k, b in enumerate(branches) if k != n)
            ):
                return True
    return False


# The same written in another way


def rewritten(system: System, rng: random.Random) -> System:
    """Other order of coordinates; constraints with other signs, factors and sides; kinematic ones with a factor."""
    order = system.coordinates[:]
    rng.shuffle(order)
    constraints = {}
    for name, equation in system.constraints.items():
        left, _, right = sides(equation)
        constraints[name] = rng.choice(
            [f"{right} = {left}", f"-2*({left}) + 2*({right}) = 0", f"({left} - ({right}))/3 = 0"]
        )
    items = [*constraints.items()]
    rng.shuffle(items)
    forms = {name: {q: f"-3*({a})" for q, a in reversed(form.items())} for name, form in system.forms.items()}
    return replace(system, coordinates=order, constraints=dict(items), forms=forms)
