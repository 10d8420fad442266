"""The principle of virtual work, the conditions of equilibrium, their solutions, stability."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import sympy as sp

from lagrange.algebra.closed_forms.shortest_form import reading_length
from lagrange.core.expression_size import count_operations
from lagrange.core.symbols import DotProduct, VectorSymbol, free_letter, variation
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
    series,
)
from lagrange.explain.displacements import displacements_in_choice, of_points
from lagrange.explain.limits import LONGEST_MINORS
from lagrange.explain.words import (
    branch_conditions,
    brief,
    constraints_called,
    existence_left_open,
    must_vanish,
    plural,
    qualified,
    sign_conditions,
    substituting,
    suffix_of,
    title_in,
)
from lagrange.mechanics.consequences.at_rest import dead_centres
from lagrange.mechanics.constraints.coordinates import GeneralizedCoordinates
from lagrange.mechanics.constraints.displacements import virtual_displacement
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.equilibrium.degenerate import LowestForm, UniformMotion
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium
from lagrange.mechanics.equilibrium.loads import potential_of_all
from lagrange.mechanics.equilibrium.stability import SecondVariation, Stability, StabilityVerdict
from lagrange.mechanics.rewriting.factors import has_common_factor, with_common_factor

ZERO = sp.S.Zero


def explain_virtual_work(equilibrium: Equilibrium, stability: SecondVariation | None, workless: bool = False) -> Step:
    """The principle, written out in the file's own coordinates, and what follows from it there.

    workless  whether it has been shown that the reactions do no virtual work
    """
    applied = "is therefore in equilibrium if and only if the applied forces, too, do no work"
    if workless:
        start = f"In a virtual displacement the reactions do no work. The system, at rest, {applied}"
    elif equilibrium.configuration.rows:
        start = "The constraints are ideal: in a virtual displacement their reactions do no work. The system, at rest, "
        start += applied
    else:
        start = "The system, at rest, is in equilibrium if and only if the applied forces do no work"
    body = [
        prose(f"{start} in any virtual displacement. This is the principle of virtual work:"),
        display(Equation((_principle(equilibrium.configuration), ZERO), label="principle-of-virtual-work")),
        prose("Written out, it reads"),
        *_derived(equilibrium, stability),
    ]
    return Step(Rule.EQUILIBRIUM, "The principle of virtual work", tuple(body))


def explain_equilibrium_in_choice(
    coordinates: GeneralizedCoordinates, equilibrium: Equilibrium, stability: SecondVariation | None
) -> Step:
    """The virtual work and the equilibria in a choice of coordinates."""
    body = [
        *displacements_in_choice(equilibrium.elimination, equilibrium.configuration),
        *of_points(equilibrium.configuration, equilibrium.elimination, "-at-rest"),
        prose("and the principle of virtual work ", Ref("principle-of-virtual-work"), " reads"),
        *_derived(equilibrium, stability, coordinates.radicands),
    ]
    return Step(Rule.EQUILIBRIUM, title_in("Equilibrium", coordinates.choice.name), tuple(body))


def _derived(
    equilibrium: Equilibrium, stability: SecondVariation | None, radicands: Sequence[sp.Expr] = ()
) -> list[Block]:
    """From the virtual work, written out, to the equilibria and their stability."""
    label = f"work-written-out{suffix_of(equilibrium.configuration.name)}"
    return [
        display(Equation((equilibrium.work.statement, ZERO), label=label)),
        *_reduced(equilibrium),
        *_conclusion(equilibrium),
        *_results(equilibrium, radicands),
        *_spring_forces(equilibrium),
        *_stability(equilibrium, stability),
    ]


def _principle(configuration: Configuration) -> sp.Expr:
    """Σ F·δr + Σ M·δπ, minus δV if there is a potential."""
    loads = configuration.loads
    free = [p for p in configuration.points if not configuration.is_pinned(p)]
    acting = [p.name for p in free if any(f.on == p.name and not f.elsewhere for f in loads)]
    acting += [f.name for f in loads if f.elsewhere]
    terms = [DotProduct(VectorSymbol(f"F_{name}"), VectorSymbol(f"delta(r_{name})")) for name in acting]
    turned = [r.name for r in configuration.rotations if configuration.moments_on(r.name)]
    terms += [DotProduct(VectorSymbol(f"M_{name}"), VectorSymbol(f"delta(pi_{name})")) for name in turned]
    potential = variation(configuration.potential_letter) if configuration.potential != 0 else ZERO
    return sp.Add(*terms, -potential)


def _reduced(equilibrium: Equilibrium) -> list[Block]:
    """The virtual work after substituting for the dependent displacements."""
    configuration, suffix = equilibrium.configuration, suffix_of(equilibrium.configuration.name)
    if not configuration.rows or not equilibrium.elimination.independent or equilibrium.needs_multipliers:
        return []
    solved = (math(variation(configuration.slots.coordinates[d])) for d in equilibrium.elimination.dependent)
    return [
        substituting(solved, Ref(f"work-written-out{suffix}")),
        display(Equation((equilibrium.reduced, ZERO), label=f"work-reduced{suffix}")),
    ]


def _conclusion(equilibrium: Equilibrium) -> list[Block]:
    """The independent δq are arbitrary, so each bracket vanishes; the divisors."""
    slots = equilibrium.configuration.slots
    free = [math(variation(slots.coordinates[k])) for k in equilibrium.elimination.independent]
    if not free:
        return [prose("No displacement is free: the constraints alone determine the position.")]
    if not equilibrium.conditions:
        return [prose("The virtual work vanishes in every position.")]
    if equilibrium.needs_multipliers:
        return _with_multipliers(equilibrium)
    reduced = [c for c in equilibrium.conditions if not c.expression.is_number]
    numbers = [c.factor.denominator.expression for c in reduced if c.factor.expression.is_number]
    above = [(c.factor.numerator if c.factor.expression.is_number else c.factor).expression for c in reduced]
    below = [*(c.below.expression for c in reduced), *numbers]
    divided, multiplied = ([math(e) for e in es if e != 1] for es in (above, below))
    taken = dict.fromkeys(c.factor.expression / c.below.expression for c in reduced)
    steps: list[tuple[Part, ...]] = []
    if len(taken) > 1 and all(e.is_number for e in taken):  # no step is that of every condition
        numbers = [e for e in taken if e != 1]
        steps.append((f"without the {plural(len(numbers), 'factor', 'factors')} ", *listed(map(math, numbers))))
        divided = multiplied = []
    if multiplied:
        steps.append(("multiplying by ", *listed(dict.fromkeys(multiplied))))
    if divided:
        nonzero = plural(len({*divided}), ", which is not zero", ", which are not zero")
        steps.append(
            ("dividing by ", *listed(dict.fromkeys(divided)), "" if all(e.is_number for e in above) else nonzero)
        )
    return [must_vanish(free, series(steps)), _shown(equilibrium)]


def _with_multipliers(equilibrium: Equilibrium) -> list[Block]:
    """The constraints added with multipliers, where dividing by a pivot could lose an equilibrium."""
    slots = equilibrium.configuration.slots
    rows = equilibrium.binding
    numbers = [r.multiplier for r in rows]
    added = (n * virtual_displacement(r, slots) for n, r in zip(numbers, rows, strict=True))
    dependent = listed(math(variation(slots.coordinates[d])) for d in equilibrium.elimination.dependent)
    divisors = listed(math(p) for p in equilibrium.elimination.pivots)
    one = len(rows) == 1
    return [
        prose(
            "Expressing ", *dependent, " in terms of the other displacements requires division by ", *divisors,
            ", which may vanish at an equilibrium. So that no position is lost, ",
            "the constraint is added with a multiplier " if one else "the constraints are added with multipliers ",
            *listed(math(n) for n in numbers), " instead: the virtual work vanishes in every virtual displacement if "
            "and only if, for some ", "value of it," if one else "values of them,",
        ),
        display(Equation((sp.Add(equilibrium.work.statement, *added), ZERO),
                         label=f"work-with-multipliers{suffix_of(equilibrium.configuration.name)}")),
        prose("for arbitrary ", *listed(math(variation(q)) for q in slots.coordinates), ", that is, where"),
        _shown(equilibrium),
    ]  # fmt: skip


def _stated(equilibrium: Equilibrium) -> list[tuple[str, sp.Expr]]:
    """Label and left side of each condition, as it is shown: m g = 0, which nothing satisfies, and not 1 = 0."""
    suffix = suffix_of(equilibrium.configuration.name)
    if not equilibrium.needs_multipliers:
        return [
            (f"condition{suffix}-{c.coordinate.name}",
             c.expression * c.factor.expression / c.below.expression if c.expression.is_number else c.expression)
            for c in equilibrium.conditions
        ]  # fmt: skip
    balance = equilibrium.balance([r.multiplier for r in equilibrium.binding])
    stated = zip(equilibrium.configuration.slots.coordinates, balance, strict=True)
    return [(f"condition{suffix}-{q.name}", e) for q, e in stated if e != 0]


def _shown(equilibrium: Equilibrium) -> Block:
    """The conditions, with a factor that several terms share before a bracket: cos θ [l (2Q − B) − 2b W] = 0."""
    stated = ((label, min(e, with_common_factor(e), key=reading_length)) for label, e in _stated(equilibrium))
    return display(*(Equation((e, ZERO), label=label) for label, e in stated))


def _results(equilibrium: Equilibrium, radicands: Sequence[sp.Expr] = ()) -> Iterator[Block]:
    """The solutions, each in a box."""
    if not equilibrium.branches:
        yield from _none(equilibrium, radicands)
        yield from singular_places(equilibrium)
        yield from outside_ranges(equilibrium)
        return
    if all(not b.relations and not b.left for b in equilibrium.branches):
        yield prose("Every position is an equilibrium.", detail=Detail.BRIEF)
        return
    yield _introduction(equilibrium)
    suffix = suffix_of(equilibrium.configuration.name)
    for n, b in enumerate(equilibrium.branches, start=1):
        equations = b.equations
        condition = branch_conditions(b)
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
    places = ((Ref(f"equilibrium{suffix}-{n}"), b) for n, b in enumerate(equilibrium.branches, start=1))
    yield from existence_left_open(places)
    yield from _remarks(equilibrium)
    yield from singular_places(equilibrium)
    yield from outside_ranges(equilibrium)
    yield from full_turns(equilibrium)
    yield from _dead_centres(equilibrium)
    yield from _without_balance(equilibrium)
    yield from _poles(equilibrium)


def _none(equilibrium: Equilibrium, radicands: Sequence[sp.Expr]) -> Iterator[Block]:
    """That there is no equilibrium."""
    names = listed(Ref(label) for label, _ in _stated(equilibrium))
    start: tuple[Part, ...] = ("No real position satisfies ", *names, ": there is no equilibrium")
    if radicands:
        start = (*start, " in these coordinates, which are valid where ",
                 *listed(math(r, ZERO, relation=">") for r in radicands))  # fmt: skip
    yield prose(*start, ".", detail=Detail.BRIEF)


def _introduction(equilibrium: Equilibrium) -> Block:
    words: list[Part] = []
    if equilibrium.given:
        forces = listed(math(f) for f in equilibrium.forces)
        nonzero = listed(math(f, ZERO, relation="≠") for f in equilibrium.presupposed)
        words += ["For a given position", *((", where ", *nonzero, ", ") if nonzero else (" ",)),
                  "this gives for " if equilibrium.undetermined else "this determines ", *forces, ":"]  # fmt: skip
    elif len(equilibrium.branches) == 1:
        words.append("The solution is" if equilibrium.solution.solved else "This is not solved in closed form:")
    else:
        products = "A product vanishes if one of its factors does. " if _splits(equilibrium) else ""
        words.append(f"{products}The solutions are")
    return prose(*words)


def _splits(equilibrium: Equilibrium) -> bool:
    return any(has_common_factor(e) for _, e in _stated(equilibrium))


def _remarks(equilibrium: Equilibrium) -> Iterator[Block]:
    if equilibrium.undetermined:
        names = listed(math(f) for f in equilibrium.undetermined)
        fewer = plural(
            len(equilibrium.conditions), "There is one condition", f"There are {len(equilibrium.conditions)} conditions"
        )
        words = f"{fewer} for {len(equilibrium.forces)} unknown forces: only these combinations are determined, and "
        yield prose(words, *names, plural(len(equilibrium.undetermined), " remains free.", " remain free."))


def singular_places(equilibrium: Equilibrium) -> Iterator[Block]:
    """The positions at which a force is undefined, and why."""
    alike: dict[tuple[str, ...], list[tuple[Part, ...]]] = {}
    for place in equilibrium.singular:
        alike.setdefault(place.springs, []).append(listed(math(r.lhs, r.rhs) for r in place.branch.equations))
    for springs, alternatives in alike.items():
        where: tuple[Part, ...] = ("Where ", *series(alternatives, " or "), ", ")
        if springs:
            called = listed(f"the {qualified('spring', name)}" for name in springs)
            one = len(springs) == 1
            what = (
                *called,
                " has length 0 and its force" if one else " have length 0 and their forces",
                " no direction",
            )
        else:
            what = ("a force has no value",)
        yield prose(*where, *what, ": not an equilibrium in the ordinary sense.", detail=Detail.BRIEF)
    if equilibrium.poles:
        places = (listed(math(r.lhs, r.rhs) for r in pole.equations) for pole in equilibrium.poles)
        none = plural(len(equilibrium.poles), "it is no equilibrium.", "they are no equilibria.")
        yield prose(
            "The conditions hold as well where ",
            *series(places, " or "),
            f". The coordinates are singular there, and the forces do work in other displacements: {none}",
            detail=Detail.BRIEF,
        )


def outside_ranges(equilibrium: Equilibrium) -> Iterator[Block]:
    """The equilibria that are omitted."""
    if equilibrium.outside:
        places = [listed(math(r.lhs, r.rhs) for r in b.equations) for b in equilibrium.outside]
        listing: list[Part] = [part for n, place in enumerate(places) for part in ("; " if n else "", *place)]
        words = "The conditions hold as well outside of the range of the coordinates, where "
        yield prose(words, *listing, ".", detail=Detail.FULL)
    ranges = equilibrium.configuration.ranges
    several = {s for b in equilibrium.branches for r in b.relations if len(b.points) < 2
               and r.lhs.has(sp.cos, sp.sin, sp.tan) for s in r.lhs.free_symbols if s in ranges}  # fmt: skip
    if several and not equilibrium.outside:
        meant = listed(math(r.low, s, r.high, relation="≤") for s, r in ranges.items() if s in several)
        yield prose("Only angles with ", *meant, " are meant.", detail=Detail.FULL)


def full_turns(equilibrium: Equilibrium) -> Iterator[Block]:
    """That an angle occurs outside of sines and cosines too, where the conditions hold at all its turns."""
    turned = list(dict.fromkeys(q for b in equilibrium.branches for q in equilibrium.turned(b)))
    if turned:
        words = "The conditions also hold after any number of full turns; the statements below are about "
        yield prose(words, *listed(math(q) for q in turned), " as stated.", detail=Detail.BRIEF)


def _dead_centres(equilibrium: Equilibrium) -> Iterator[Block]:
    """Where the only coordinate moves nothing to first order, so that any forces balance."""
    if equilibrium.dead_centres:
        suffix = suffix_of(equilibrium.configuration.name)
        places = listed(Ref(f"equilibrium{suffix}-{n + 1}") for n in equilibrium.dead_centres)
        [q] = equilibrium.configuration.slots.coordinates
        yield prose(
            "At ", *places, " ", math(variation(q)), " moves nothing to first order, so any forces balance there: a "
            "dead centre, if ", math(q), " is the angle of a crank. If it only says where something is, its range ends "
            "there, and this is no equilibrium.",
            detail=Detail.BRIEF,
        )  # fmt: skip


def _without_balance(equilibrium: Equilibrium) -> Iterator[Block]:
    """`Where sin θ = 0, the constraint leaves δx = 0: P does no work, and no value of it gives equilibrium.`"""
    for wave, x, force in dead_centres(equilibrium):
        constraint = constraints_called([equilibrium.configuration.rows[0].name])
        yield prose("Where ", math(wave, ZERO), f", at a dead centre, {constraint} leaves ", math(variation(x), ZERO),
                    ": ", math(force), " does no work, and no value of it gives equilibrium.",
                    detail=Detail.BRIEF)  # fmt: skip


def _spring_forces(equilibrium: Equilibrium) -> Iterator[Block]:
    """With what force each spring pulls, or pushes, at the equilibria."""
    suffix = suffix_of(equilibrium.configuration.name)
    for name in dict.fromkeys(name for pulls in equilibrium.pulls for name in pulls):
        forces: dict[sp.Expr, list[Part]] = {}
        for n, pulls in enumerate(equilibrium.pulls, start=1):
            if name in pulls and count_operations(pulls[name]) <= LONGEST_MINORS:
                forces.setdefault(pulls[name], []).append(Ref(f"equilibrium{suffix}-{n}"))
        if forces:
            sizes = series((math(f), " at ", *listed(places)) for f, places in forces.items())
            yield prose(f"The {qualified('spring', name)} pulls its ends together with the force ", *sizes, ".")


def _poles(equilibrium: Equilibrium) -> Iterator[Block]:
    """The equilibria at which the coordinates are singular."""
    suffix = suffix_of(equilibrium.configuration.name)
    groups: dict[tuple[tuple[sp.Symbol, ...], bool], list[Part]] = {}
    for n, (b, idle) in enumerate(zip(equilibrium.branches, equilibrium.idle, strict=False), start=1):
        bound = any(r.residual.has(*idle) for r in b.equations) if idle else False
        groups.setdefault((idle, bound), []).append(Ref(f"equilibrium{suffix}-{n}"))
    for (idle, bound), places in groups.items():
        if not idle:
            continue
        names = listed(math(q) for q in idle)
        words: list[Part] = ["At ", *listed(places), " the position is the same for every value of ", *names]
        words.append(": the coordinates are singular there.")
        if bound:
            words += [" The conditions hold for particular values of ", *names, " only, so the forces do work in other "
                      "displacements from this position: it is an equilibrium only if ", *names,
                      plural(len(idle), " is", " are"), " fixed by other means."]  # fmt: skip
        yield prose(*words, detail=Detail.BRIEF)


def _stability(equilibrium: Equilibrium, second: SecondVariation | None) -> Iterator[Block]:
    """The second variation at each equilibrium."""
    if second is None or all(not s.minors for s in second.verdicts):
        return
    configuration, one = equilibrium.configuration, len(second.coordinates) == 1
    letter, stated = configuration.potential_letter, configuration.potential
    whole = potential_of_all(configuration, equilibrium.independent_forces[0]) if one else None
    if whole is not None and stated not in (ZERO, whole):  # that of the springs alone has this letter
        others = {s.name for s in (*whole.free_symbols, letter)}
        letter = sp.Symbol(free_letter("U", "Pi", "V_all", taken=others), real=True)
    V = math(letter)
    given: tuple[Part, ...] = (
        ("a potential ", V, ", and") if whole is None else ("the potential ", math(letter, whole), ";")
    )
    together = "All forces together" if letter != configuration.potential_letter else "The forces"
    start = (f"{together} have ", *given, " an equilibrium is stable if ", V, " has a strict minimum there.")
    turned = any(s.minors and s.free for s in second.verdicts)
    if all(s.free for s in second.verdicts if s.minors):
        yield prose(*start)
    elif one:
        [q] = second.coordinates
        away = listed(math(jump, sp.S.Zero, relation="≠") for jump in second.jumps)
        where: tuple[Part, ...] = (", where ", *away) if second.jumps else ()
        value = math(second.matrix[0][0])
        yield prose(*start, " Its second derivative with respect to ", math(q), " is ", value, *where, ".")
    else:
        yield prose(
            *start, " This is so if the leading minors of the matrix of its second derivatives are positive; the "
            "equilibrium is unstable if the second variation takes negative values, as it does if a principal minor is "
            "negative."
        )  # fmt: skip
    if turned:
        yield prose(
            "Where that division is impossible, the second variation is that of V minus the constraints, each times "
            "its multiplier, in the displacements that are free there."
        )
    for theta, phi in dict.fromkeys(s.pole for s in second.verdicts if s.minors and s.pole):
        yield prose(
            "Where the coordinates are singular, every displacement is made up of ", math(variation(theta)), " at ",
            math(phi, sp.S.Zero), " and at ", math(phi, sp.pi / 2), "; the minors there are those for these two",
            *(() if len(second.coordinates) == 2 else (" and the other coordinates",)), "."
        )  # fmt: skip
    suffix = suffix_of(equilibrium.configuration.name)
    judged = [(Ref(f"equilibrium{suffix}-{n}"), s) for n, s in enumerate(second.verdicts, start=1) if s.minors]
    alike: dict[tuple[Part, ...], list[Ref]] = {}
    for place, s in judged:
        alike.setdefault((*_freely(s), " ", *_verdict(s, one, V)), []).append(place)
    sentences = paragraph(*(prose("At ", *listed(places), *words) for words, places in alike.items()))
    short = paragraph(*(prose("Equilibrium ", place, ": ", *_in_brief(s), ".") for place, s in judged))
    yield brief(sentences, short)


def _in_brief(s: Stability) -> tuple[Part, ...]:
    """The stability in short; of long conditions only that there are some."""
    said = (*s.conditions, *s.presupposed, *s.unstable)
    if sum(count_operations(c.lhs - c.rhs) for c in said) > LONGEST_MINORS:
        return ("its stability depends on the parameters",)
    return stability_in_short(s)


def stability_in_short(s: Stability) -> tuple[Part, ...]:
    """`stable`, `unstable where a > b`, `stability undecided`; nothing if it was not asked."""
    if not s.minors:
        return ()
    match s.verdict:
        case StabilityVerdict.CONDITIONAL:
            return ("stable where ", *sign_conditions(s.conditions))
        case StabilityVerdict.UNDECIDED if s.unstable and s.drift is None:
            return ("unstable where ", *sign_conditions(s.unstable, " or "))
        case StabilityVerdict.UNDECIDED if s.drift is not None:
            return but_for_drift(s.drift)
        case StabilityVerdict.UNDECIDED:
            return ("stability undecided",)
    where = (" where ", *sign_conditions(s.presupposed)) if s.presupposed else ()
    return (s.verdict.value, *where)


def but_for_drift(drift: UniformMotion) -> tuple[Part, ...]:
    """`stable apart from a uniform motion of X`, `of x_1 and x_2 together`, `where k > m g`."""
    together = " together" if len(drift.coordinates) > 1 and not drift.several else ""
    motion = "uniform motions of " if drift.several else "a uniform motion of "
    where = (" where ", *sign_conditions(drift.conditions)) if drift.conditions else ()
    return (f"stable apart from {motion}", *listed(math(q) for q in drift.coordinates), together, *where)


def why_it_drifts(drift: UniformMotion, V: Part) -> tuple[Part, ...]:
    """`V does not contain X, and has a strict minimum in s`, as the beginning of a sentence."""
    others = listed(math(q) for q in drift.others)
    if len(drift.coordinates) > 1 and not drift.several:
        moved = listed(math(q) for q in drift.coordinates)
        return (V, " stays the same when ", *moved, " change together, and has otherwise a strict minimum")
    return (V, " does not contain ", *listed(math(q) for q in drift.coordinates), ", and has a strict minimum in ",
            *others)  # fmt: skip


def _freely(s: Stability) -> tuple[Part, ...]:
    """`, δx being free,` where other displacements are free than elsewhere."""
    if not s.free:
        return ()
    return (", ", *listed(math(variation(q)) for q in s.free), " being free,")


def _verdict(s: Stability, one: bool, V: Part) -> tuple[Part, ...]:
    long = not one and sum(count_operations(m) for m in s.minors) > LONGEST_MINORS
    values = listed(math(m) for m in s.minors)
    what: tuple[Part, ...] = ("it is ", *values) if one else ("they", *(() if long else (" are ", *values)))
    where = (" where ", *sign_conditions(s.presupposed)) if s.presupposed else ()
    if s.lowest is not None:
        return _by_lowest_form(s, s.lowest, () if long or not s.minors else what)
    if s.order > 2:
        sign = "positive" if s.verdict is StabilityVerdict.STABLE else "negative"
        parity = "odd" if s.order % 2 else f"even, and {sign}"
        order = f", of order {s.order}, {parity}"
        if s.valley is not None:
            valley = ("the second variation is positive except in one direction. Along the valley of V in that "
                      "direction, where its other derivatives vanish, the first nonzero derivative with "
                      "respect to ")  # fmt: skip
            return (valley, math(s.valley), " is ", *values, order, *where, f": {s.verdict.value}.")
        return ("it is zero, and the first nonzero derivative is ", *values, order, *where, f": {s.verdict.value}.")
    if s.even_powers:
        return (
            *(() if long else (*what, "; but ")),
            "V rises from there as a sum of even powers with positive coefficients, a strict minimum: stable.",
        )
    match s.verdict:
        case StabilityVerdict.STABLE if long:
            return ("all of them are positive", *where, ": stable.")
        case StabilityVerdict.STABLE:
            return (*what, ", positive" if one else ", all positive", *where, ": stable.")
        case StabilityVerdict.UNSTABLE if s.principal is not None:
            if long or count_operations(s.principal) > LONGEST_MINORS:
                return ("another principal minor is negative", *where, ": unstable.")
            return (*what, "; another principal minor is ", math(s.principal), *where, ": unstable.")
        case StabilityVerdict.UNSTABLE if long:
            return ("they exclude a minimum", *where, ": unstable.")
        case StabilityVerdict.UNSTABLE:
            return (*what, *((", negative",) if one else ()), *where, ": unstable.")
        case StabilityVerdict.CONDITIONAL:
            return _conditional(s, one, () if long else what)
        case StabilityVerdict.UNDECIDED if s.drift is not None:
            return (*why_it_drifts(s.drift, V), ": ", *but_for_drift(s.drift), ".")
        case StabilityVerdict.UNDECIDED if s.unstable:
            where = sign_conditions(s.unstable, " or ")
            return (*what, ": unstable where ", *where, "; elsewhere the second variation does not decide.")
        case StabilityVerdict.UNDECIDED:
            return (*what, ": the second variation does not decide.") if not long else ("they do not decide.",)


def _by_lowest_form(s: Stability, lowest: LowestForm, what: tuple[Part, ...]) -> tuple[Part, ...]:
    """What the lowest terms of V say where the second variation vanishes in several directions."""
    where = (" where ", *sign_conditions(s.presupposed)) if s.presupposed else ()
    named = listed(math(q) for q in lowest.symbols)
    begun = (*what, "; but") if what else ("the second variation does not decide, but",)
    valley = " and along its valley" if len(s.minors) > len(lowest.symbols) else ""
    terms = (*begun, " the terms of V of lowest order in ", *named, f", measured from there{valley}, are ",
             math(lowest.form), ", ")  # fmt: skip
    match s.verdict:
        case StabilityVerdict.STABLE:
            return (*terms, "positive in every direction", *where, ": stable.")
        case StabilityVerdict.CONDITIONAL:
            given = sign_conditions(s.conditions)
            return (*terms, "positive in every direction where ", *given, ", stable; unstable where the opposite "
                    "inequality holds.")  # fmt: skip
        case _:
            return (*terms, "negative in some direction", *where, ": unstable.")


def _conditional(s: Stability, one: bool, what: tuple[Part, ...]) -> tuple[Part, ...]:
    """Stable where conditions hold; with one condition on one coordinate unstable where it is reversed."""
    where = sign_conditions(s.conditions)
    if one and [(c.lhs, c.relation, c.rhs) for c in s.conditions] == [(s.minors[0], ">", ZERO)]:
        return ("its sign decides: positive means stable, negative unstable.",)
    if not what:
        return ("the equilibrium is stable where ", *where, ".")
    alone = one and len(s.conditions) == 1 and s.conditions[0].relation != "≠"
    contrary = ", unstable where the opposite inequality holds." if alone else "."
    limit = _at_limit(s, s.at_limit) if alone and s.at_limit is not None else ()
    return (*what, ": stable where ", *where, contrary, *limit)


def _at_limit(s: Stability, there: Stability) -> tuple[Part, ...]:
    """What holds where a condition is an equality: `Where k = m g l, the first nonzero derivative is ...: stable.`"""
    sign = "positive" if there.verdict is StabilityVerdict.STABLE else "negative"
    parity = "odd" if there.order % 2 else f"even, and {sign}"
    [c], values = s.conditions, listed(math(m) for m in there.minors)
    words = f", of order {there.order}, {parity}: {there.verdict.value}."
    return (" Where ", math(c.lhs, c.rhs), ", it is zero, and the first nonzero derivative is ", *values, words)
