"""The principle of virtual work, the conditions of equilibrium, their solutions, stability."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import sympy as sp

from lagrange.algebra.closed_forms.signs import Condition
from lagrange.algebra.closed_forms.solution_sets import Branch
from lagrange.core.symbols import Dot, VectorSymbol, variation
from lagrange.document.derivation import (
    Block,
    Detail,
    Equation,
    Part,
    Ref,
    Rule,
    Step,
    display,
    listed,
    math,
    paragraph,
    prose,
)
from lagrange.explain.displacements import of_points, solved_displacements
from lagrange.explain.words import plural, spoken
from lagrange.mechanics.constraints.coordinates import GeneralizedCoordinates
from lagrange.mechanics.constraints.displacements import virtual_displacement
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium
from lagrange.mechanics.equilibrium.stability import SecondVariation, Stability, Verdict

ZERO = sp.S.Zero


def explain_virtual_work(found: Equilibrium, stability: SecondVariation | None, workless: bool = False) -> Step:
    """The principle, written out in the file's own coordinates, and what follows from it there.

    workless  whether it has been shown that the reactions do no virtual work
    """
    configuration = found.configuration
    body: list[Block] = [
        prose(
            "In a virtual displacement the reactions do no work. So the system, at rest, is in equilibrium exactly "
            "where the applied forces do none either, whatever the virtual displacement. This is the principle of "
            "virtual work:"
            if workless
            else "The constraints are ideal: in a virtual displacement their reactions do no work. The system, at "
            "rest, is in equilibrium exactly where the applied forces do none either, whatever the virtual "
            "displacement. This is the principle of virtual work:"
            if configuration.rows
            else "The system, at rest, is in equilibrium exactly where the applied forces do no work in any virtual "
            "displacement. This is the principle of virtual work:"
        ),
        display(Equation((_principle(configuration), ZERO), label="principle-of-virtual-work")),
        prose("Written out, it reads"),
        display(Equation((found.work.statement, ZERO), label="work-written-out")),
    ]
    if configuration.rows:
        body += _with_the_solved(found)
    body += _conclusion(found)
    body += _results(found)
    body += _stability(found, stability)
    return Step(Rule.EQUILIBRIUM, "The principle of virtual work", tuple(body))


def explain_equilibrium_in_choice(
    coordinates: GeneralizedCoordinates, found: Equilibrium, stability: SecondVariation | None
) -> Step:
    """The virtual work and the equilibria in a choice of coordinates."""
    configuration = found.configuration
    body: list[Block] = []
    if configuration.rows:
        rows = (virtual_displacement(r, configuration.slots) for r in configuration.rows)
        body += [prose("In a virtual displacement"), display(*(Equation((row, ZERO)) for row in rows))]
        body += solved_displacements(found.elimination, configuration)
    body += [
        *of_points(configuration, found.elimination, "-at-rest"),
        prose("and the principle of virtual work ", Ref("principle-of-virtual-work"), " reads"),
        display(Equation((found.work.statement, ZERO), label=f"work-written-out{_suffix(configuration)}")),
    ]
    if configuration.rows:
        body += _with_the_solved(found)
    body += _conclusion(found)
    body += _results(found, coordinates.radicands)
    body += _stability(found, stability)
    return Step(Rule.EQUILIBRIUM, f"Equilibrium: {spoken(coordinates.choice.name)}", tuple(body))


def _suffix(configuration: Configuration) -> str:
    return f"-{configuration.name}" if configuration.name else ""


def _principle(configuration: Configuration) -> sp.Expr:
    """Σ F·δr + Σ M·δπ, less δV where there is a potential."""
    loads = configuration.loads
    free = [p for p in configuration.points if not configuration.is_pinned(p)]
    acting = [p.name for p in free if any(f.on == p.name and not f.elsewhere for f in loads)]
    acting += [f.name for f in loads if f.elsewhere]
    terms = [Dot(VectorSymbol(f"F_{name}"), VectorSymbol(f"delta(r_{name})")) for name in acting]
    turned = [r.name for r in configuration.rotations if configuration.moments_on(r.name)]
    terms += [Dot(VectorSymbol(f"M_{name}"), VectorSymbol(f"delta(pi_{name})")) for name in turned]
    potential = variation(sp.Symbol("V", real=True)) if configuration.potential != 0 else ZERO
    return sp.Add(*terms, -potential)


def _with_the_solved(found: Equilibrium) -> list[Block]:
    """The virtual work with the dependent displacements put in."""
    configuration, suffix = found.configuration, _suffix(found.configuration)
    solved = [variation(configuration.slots.coordinates[d]) for d in found.elimination.dependent]
    if not found.elimination.independent or found.needs_multipliers:
        return []
    return [
        prose("With ", *listed(math(d) for d in solved), " put in, ", Ref(f"work-written-out{suffix}"), " becomes"),
        display(Equation((found.reduced, ZERO), label=f"work-reduced{suffix}")),
    ]


def _conclusion(found: Equilibrium) -> list[Block]:
    """The independent δq are arbitrary, so each bracket vanishes; what is divided by."""
    slots = found.configuration.slots
    free = [math(variation(slots.coordinates[k])) for k in found.elimination.independent]
    if not free:
        return [prose("No displacement is free: the constraints alone determine the position.")]
    if not found.conditions:
        return [prose("The virtual work vanishes whatever the position is.")]
    if found.needs_multipliers:
        return _with_multipliers(found)
    arbitrary = (
        " is arbitrary, so what multiplies it vanishes"
        if len(free) == 1
        else " are independent, so what multiplies each of them vanishes"
    )
    numbers = [c.factor.denominator.expression for c in found.conditions if c.factor.expression.is_number]
    above = [(c.factor.numerator if c.factor.expression.is_number else c.factor).expression for c in found.conditions]
    below = [*(c.below.expression for c in found.conditions), *numbers]
    divided, multiplied = ([math(e) for e in es if e != 1] for es in (above, below))
    steps: list[tuple[Part, ...]] = []
    if multiplied:
        steps.append(("multiplying by ", *listed(dict.fromkeys(multiplied))))
    if divided:
        said = "" if all(e.is_number for e in above) else ", which is not zero"
        steps.append(("dividing by ", *listed(dict.fromkeys(divided)), said))
    dividing = (" (", *steps[0], *((" and ", *steps[1]) if len(steps) > 1 else ()), ")") if steps else ()
    return [prose(*listed(free), arbitrary, *dividing, ":"), _shown(found)]


def _with_multipliers(found: Equilibrium) -> list[Block]:
    """The constraints added with multipliers, where dividing by a pivot could lose an equilibrium."""
    slots = found.configuration.slots
    rows = found.binding
    numbers = [r.multiplier for r in rows]
    added = (n * virtual_displacement(r, slots) for n, r in zip(numbers, rows, strict=True))
    put_in = listed(math(variation(slots.coordinates[d])) for d in found.elimination.dependent)
    divisors = listed(math(p) for p in found.elimination.pivots)
    one = len(rows) == 1
    return [
        prose(
            "To express ", *put_in, " by the other displacements one divides by ", *divisors, ", which may vanish at "
            "an equilibrium. So that no position is lost, ",
            "the constraint is added with a number " if one else "the constraints are added with numbers ",
            *listed(math(n) for n in numbers), " instead: the virtual work vanishes in every virtual displacement "
            "exactly where, for some ", "value of it," if one else "values of them,",
        ),
        display(Equation((sp.Add(found.work.statement, *added), ZERO),
                         label=f"work-with-multipliers{_suffix(found.configuration)}")),
        prose("whatever ", *listed(math(variation(q)) for q in slots.coordinates), " are, that is, where"),
        _shown(found),
    ]  # fmt: skip


def _stated(found: Equilibrium) -> list[tuple[str, sp.Expr]]:
    """Label and left side of each condition, as it is shown."""
    suffix = _suffix(found.configuration)
    if not found.needs_multipliers:
        return [(f"condition{suffix}-{c.coordinate.name}", c.expression) for c in found.conditions]
    balance = found.balance([r.multiplier for r in found.binding])
    stated = zip(found.configuration.slots.coordinates, balance, strict=True)
    return [(f"condition{suffix}-{q.name}", e) for q, e in stated if e != 0]


def _shown(found: Equilibrium) -> Block:
    return display(*(Equation((e, ZERO), label=label) for label, e in _stated(found)))


def _results(found: Equilibrium, radicands: Sequence[sp.Expr] = ()) -> Iterator[Block]:
    """The solutions, each in a box."""
    if not found.branches:
        yield from _none(found, radicands)
        return
    if all(not b.relations and not b.left for b in found.branches):
        yield prose("Every position is one of equilibrium.", detail=Detail.BRIEF)
        return
    yield _introduction(found)
    suffix = _suffix(found.configuration)
    for n, b in enumerate(found.branches, start=1):
        equations = b.equations
        condition = _conditions(b)
        label = f"equilibrium{suffix}-{n}"
        lines = [
            Equation(
                (r.lhs, r.rhs),
                label=label if k == len(equations) - 1 else None,
                condition=condition if k == len(equations) - 1 else (),
            )
            for k, r in enumerate(equations)
        ]
        yield display(*lines, boxed=True, detail=Detail.BRIEF)
    yield from _remarks(found)


def _none(found: Equilibrium, radicands: Sequence[sp.Expr]) -> Iterator[Block]:
    """That there is no equilibrium."""
    names = listed(Ref(label) for label, _ in _stated(found))
    start: tuple[Part, ...] = ("No real position satisfies ", *names, ": there is no equilibrium")
    if radicands:
        start = (*start, " in these coordinates, which serve where ",
                 *listed(math(r, ZERO, relation=">") for r in radicands))  # fmt: skip
    yield prose(*start, ".", detail=Detail.BRIEF)


def _introduction(found: Equilibrium) -> Block:
    words: list[Part] = []
    if found.given:
        forces = listed(math(f) for f in found.forces)
        nonzero = listed(math(f, ZERO, relation="≠") for f in found.presupposed)
        words += ["For a given position", *((", where ", *nonzero, ", ") if nonzero else (" ",)),
                  "this gives of " if found.undetermined else "this determines ", *forces, ":"]  # fmt: skip
    elif len(found.branches) == 1:
        words.append("The solution is" if found.solution.solved else "This is not solved in closed form:")
    else:
        products = "A product vanishes where one of its factors does. " if _splits(found) else ""
        words.append(f"{products}The solutions are")
    return prose(*words)


def _splits(found: Equilibrium) -> bool:
    return any(sp.factor_terms(e).is_Mul for _, e in _stated(found))


def _conditions(b: Branch) -> tuple[Part, ...]:
    """`where b ≤ a`; what is special or left open."""
    words: list[Part] = []
    if b.conditions:
        words += ["where ", *listed(_condition(c) for c in b.conditions)]
    if b.special:
        words.append("; then every such position is one of equilibrium" if words else "then in every position")
    if b.left:
        words.append("; not solved in closed form" if words else "not solved in closed form")
    return tuple(words)


def _condition(c: Condition) -> Part:
    return math(c.lhs, c.rhs, relation=c.relation)


def _remarks(found: Equilibrium) -> Iterator[Block]:
    if found.undetermined:
        names = listed(math(f) for f in found.undetermined)
        fewer = plural(len(found.conditions), "There is one condition", f"There are {len(found.conditions)} conditions")
        words = f"{fewer} for {len(found.forces)} unknown forces: only these combinations are determined, and "
        yield prose(words, *names, plural(len(found.undetermined), " stays free.", " stay free."))


def _stability(found: Equilibrium, second: SecondVariation | None) -> Iterator[Block]:
    """The second variation at each equilibrium."""
    if second is None or all(not s.minors for s in second.verdicts):
        return
    start = "The forces have a potential V, and an equilibrium is stable where V has a strict minimum. "
    one = len(second.coordinates) == 1
    turned = any(s.minors and s.free for s in second.verdicts)
    if all(s.free for s in second.verdicts if s.minors):
        yield prose(start.removesuffix(" "))
    elif one:
        [q] = second.coordinates
        yield prose(start, "Its second derivative by ", math(q), " is ", math(second.matrix[0][0]), ".")
    else:
        yield prose(
            start, "So it is where the leading minors of the matrix of its second derivatives are positive, and it is "
            "unstable where the second variation takes negative values."
        )  # fmt: skip
    if turned:
        yield prose(
            "Where one may not divide to express the dependent displacements, the second variation is that of V less "
            "the constraints, each times its multiplier, for the displacements that are free there."
        )
    suffix = _suffix(found.configuration)
    sentences = (
        prose("At ", Ref(f"equilibrium{suffix}-{n}"), *_freely(s), " ", *_said(s, one))
        for n, s in enumerate(second.verdicts, start=1)
        if s.minors
    )
    yield paragraph(*sentences)


def _freely(s: Stability) -> tuple[Part, ...]:
    """`, δx being free,` where other displacements are free than elsewhere."""
    if not s.free:
        return ()
    return (", ", *listed(math(variation(q)) for q in s.free), " being free,")


LONGEST = 30
"""Operations of the minors of a matrix that are still shown."""


def _said(s: Stability, one: bool) -> tuple[Part, ...]:
    long = not one and sum(m.count_ops() for m in s.minors) > LONGEST
    values = listed(math(m) for m in s.minors)
    what: tuple[Part, ...] = ("it is ", *values) if one else ("they", *(() if long else (" are ", *values)))
    if s.order > 2:
        sign = "odd" if s.order % 2 else "even, and positive" if s.verdict is Verdict.STABLE else "even, and negative"
        order = f", of order {s.order}, {sign}: {s.verdict.value}."
        return ("it is zero, and the first derivative that is not is ", *values, order)
    match s.verdict:
        case Verdict.STABLE if long:
            return ("all of them are positive: stable.",)
        case Verdict.STABLE:
            return (*what, ", positive: stable." if one else ", all positive: stable.")
        case Verdict.UNSTABLE if long:
            return ("they exclude a minimum: unstable.",)
        case Verdict.UNSTABLE:
            return (*what, ", negative: unstable." if one else ": unstable.")
        case Verdict.CONDITIONAL:
            where = listed(_condition(c) for c in s.conditions)
            contrary = ", and unstable where the contrary holds." if one else "."
            if long:
                return ("the equilibrium is stable where ", *where, ".")
            return (*what, ": stable where ", *where, contrary)
        case Verdict.UNDECIDED if s.unstable:
            where = listed((_condition(c) for c in s.unstable), " or ")
            return (*what, ": unstable where ", *where, "; elsewhere the second variation does not decide.")
        case Verdict.UNDECIDED:
            return (*what, ": the second variation does not decide.") if not long else ("they do not decide.",)
