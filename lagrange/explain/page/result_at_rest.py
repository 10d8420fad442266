"""The lines of the result about rest and steady motion: equilibria, rest with friction, small oscillations.

Each solution is followed by its conditions and its stability, as far as they are short.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.algebra.closed_forms.signs import SignCondition
from lagrange.algebra.closed_forms.solution_sets import Branch
from lagrange.core.expression_size import count_operations
from lagrange.core.symbols import UnitSymbol
from lagrange.document.derivation import Equation, Math, Mathematics, Part, Rule, listed, math, series
from lagrange.explain.limits import (
    LONGEST_FREQUENCY,
    LONGEST_WORDS,
    MOST_LINES_OF_CASES,
    MOST_PLACES,
    MOST_RESULTS,
    RESULT_DIGITS,
)
from lagrange.explain.page.conclusions.positions import stability_of
from lagrange.explain.reactions import reaction_lines
from lagrange.explain.rest.equilibrium import stability_in_short
from lagrange.explain.words import WITH_VALUES, branch_conditions, sign_conditions
from lagrange.mechanics.consequences.limits_of_a_load import for_one_load
from lagrange.mechanics.dynamics.newton import Newton
from lagrange.mechanics.equilibrium.friction.conditions_of_rest import RestCondition
from lagrange.mechanics.equilibrium.friction.friction_at_rest import AtRest
from lagrange.mechanics.equilibrium.in_numbers import EquilibriaInNumbers, Position
from lagrange.mechanics.equilibrium.linear_stability import Ground, StabilityJudgement
from lagrange.mechanics.equilibrium.linearization import Linearization
from lagrange.mechanics.equilibrium.loads import load_parameters
from lagrange.mechanics.equilibrium.stability import StabilityVerdict
from lagrange.mechanics.equilibrium.static_reactions import ReactionsAtRest, possible
from lagrange.mechanics.momenta.steady_motions import SteadyMotions
from lagrange.mechanics.results import InCoordinates
from lagrange.mechanics.rewriting.cases_of_rest import rate_or_square, strictest_cases
from lagrange.mechanics.rewriting.readable_forms import divisors
from lagrange.mechanics.rewriting.stable_frequencies import square_where_stable
from lagrange.values.quantities import Quantity, Values, degrees, with_unit


def result_at_rest(
    view: InCoordinates,
    values: Mapping[sp.Symbol, sp.Expr],
    newton: Newton | None,
    *,
    held: bool = False,
    sought: Collection[sp.Symbol] = (),
) -> Iterator[tuple[Rule, list[Equation]]]:
    """Everything about rest and steady motion in one set of coordinates.

    held    whether the constraints leave no degree of freedom: then the forces are what is sought
    sought  the unknown forces of the file
    """
    forces = () if view.reactions_at_rest is None else view.reactions_at_rest.at
    kept = range(len(forces)) if newton is None else possible(forces, newton, values)  # of all, the page says why not
    excluded = {*range(len(forces))} - {*kept}
    yield Rule.EQUILIBRIUM, [*_equilibria(view, excluded, newton if held and len(kept) > 1 else None)]
    if newton is not None and excluded and len(kept) == 1 and (only := forces[kept[0]]) is not None:
        yield Rule.SOLVED_REACTIONS, _named_reactions(only, newton)
    conditions = [*_friction(view, values)]
    yield Rule.FRICTION_AT_REST, conditions
    if view.at_rest is not None:
        forces_there = [*_forces(view.at_rest)]
        all_of_them = held or not conditions
        yield Rule.SOLVED_REACTIONS, [e for e in forces_there if all_of_them or e.sides[0] in sought]
    elif newton is not None and sought:
        yield Rule.SOLVED_REACTIONS, [*_at_the_limit(view, newton)]
    if view.steady is not None:
        lines = [*_steady(view.steady), *_about_steady(view.steady)]
        yield Rule.STEADY, [e for e in lines if e.operations <= LONGEST_FREQUENCY]
    if view.linearization is not None:
        stated = view.equilibrium is not None
        lines = [*_frequencies(view.linearization, view.in_numbers, existence_stated=stated)]
        numbers = [] if view.in_numbers is None else [*_only_in_numbers(view.linearization, view.in_numbers)]
        damped = [*_damped(view.linearization), *_damped_modes(view.linearization)]
        yield Rule.LINEARIZATION, [*lines, *damped, *numbers]


def _equilibria(
    view: InCoordinates, excluded: Collection[int] = (), newton: Newton | None = None
) -> Iterator[Equation]:
    """The equilibria, each with its stability; `or` between them where one takes several lines.

    excluded  branches, by index, at which a contact would have to pull or a string to push
    newton    where the named reactions are stated at each of them: in positions that the constraints hold
    """
    if view.equilibrium is None:
        return
    groups: list[list[Equation]] = []
    unsolved = False
    reactions = view.reactions_at_rest.at if view.reactions_at_rest is not None else ()
    forces_at = [_named_reactions(r, newton) if r is not None and newton is not None else [] for r in reactions]
    if len({tuple(e.sides for e in forces) for forces in forces_at}) == 1:  # they are stated once, after the positions
        forces_at = []
    branches = view.equilibrium.branches
    verdicts = view.stability.verdicts if view.stability is not None else (None,) * len(branches)
    numbers, linearization = view.in_numbers, view.linearization
    presupposed = () if view.equilibrium is None else view.equilibrium.presupposed
    if linearization is not None and [b.relations for b in linearization.branches] != [b.relations for b in branches]:
        numbers = None
    for n, (b, verdict) in enumerate(zip(branches, verdicts, strict=True)):
        if n in excluded or (numbers is not None and n in numbers.absent and len(numbers.absent) < len(branches)):
            continue
        places = [] if numbers is None or not b.left else [p for p in numbers.positions if p.branch is None]
        if places:  # of all branches that are not in closed form together
            if not any(other.left for other in branches[:n]):
                found = [_found(p, numbers) for p in places]
                groups += (
                    found
                    if sum(map(len, found)) <= MOST_RESULTS
                    else map(_in_a_line, _by_place(found, len(places[0].coordinates)))
                )
                if numbers is not None and numbers.numerical is not None and not numbers.numerical.complete:
                    *first, last = groups[-1]
                    more = ("; " if last.condition else "", "there may be others")
                    groups[-1] = [*first, replace(last, condition=(*last.condition, *more))]
            continue
        words: tuple[Part, ...] = ()
        is_open = bool(b.conditions) or verdict is None or verdict.verdict is StabilityVerdict.CONDITIONAL
        is_open = is_open or bool(verdict is not None and (verdict.presupposed or verdict.unstable))
        known = _with_values(numbers, n) if is_open else ()
        if verdict is not None:
            said = (*b.conditions, *verdict.conditions, *verdict.presupposed, *verdict.unstable)
            compared = {c.lhs - c.rhs for c in said}  # a > b beside a ≥ b is read at a glance
            is_short = sum(map(count_operations, compared)) <= LONGEST_WORDS
            if not b.left and is_short and not (known and _lack_units(said, numbers)):
                words = stability_in_short(verdict)
        words = (*words, *(("; ",) if words and known else ()), *known)
        contact = _contact(reactions[n]) if reactions else ()
        words = (*contact, *(("; ",) if words and contact else ()), *words)
        stated = {c.lhs - c.rhs for c in b.conditions if c.relation == "≠"}
        divided = [f for f in presupposed if f not in stated and -f not in stated]
        if divided and not words:
            words = ("where ", *listed(math(f, sp.S.Zero, relation="≠") for f in divided))
        forces = forces_at[n] if n < len(forces_at) else []
        own = [r for r in b.relations if all(r not in o.relations for o in branches if o is not b)]
        if forces and own:  # a position that the constraints hold is given; its forces are sought
            angles = view.equilibrium.solution.letters.angles
            place = min(own, key=lambda r: r.lhs not in angles)
            groups.append([replace(e, condition=("at ", math(place.lhs, place.rhs), *e.condition)) for e in forces])
            continue
        lines = _branch(b, *words)
        if b.left and sum(e.operations for e in lines) > LONGEST_FREQUENCY and not all(o.left for o in branches):
            unsolved = True
            continue
        groups.append(lines)
    groups = [lines for lines in groups if lines]
    if unsolved and groups:
        *before, last = groups[-1]
        words = ("; " if last.condition else "", "others, if any, are not solved in closed form")
        groups[-1] = [*before, replace(last, condition=(*last.condition, *words))]
    coordinates = {*view.configuration.slots.coordinates}
    left = (e.sides[0] for lines in groups for e in lines if isinstance(e.sides[0], sp.Expr))
    unknowns = {frozenset(side.free_symbols & coordinates) for side in left}
    are_systems = any(len(lines) > 1 for lines in groups) or len(unknowns) > 1
    for n, (*first, last) in enumerate(groups, start=1):
        yield from first
        beside = (*last.condition, ", or" if last.condition else "or")
        yield replace(last, condition=beside) if are_systems and n < len(groups) else last


def _named_reactions(there: ReactionsAtRest, newton: Newton) -> list[Equation]:
    named = {r.given for r in newton.reactions}
    return [e for e in reaction_lines(there.reactions, newton, "") if e.sides[0] in named]


def _contact(there: ReactionsAtRest | None) -> tuple[Part, ...]:
    """`in contact where sin θ ≥ 0`, `taut where z > 0`; nothing where no reaction may act backwards."""
    if there is None or not there.contact:
        return ()
    acts = "taut" if there.contact.keys() <= there.reactions.tensions.keys() else "in contact"
    return (f"{acts} where ", *sign_conditions([*dict.fromkeys(there.contact.values())]))


def _found(p: Position, among: EquilibriaInNumbers | None) -> list[Equation]:
    """An equilibrium that was found numerically, with its stability; of several, each with the reactions there."""
    lines = [
        Equation((q, x.shown(RESULT_DIGITS), *_degrees(x)) if x.formula != 0 else (q, sp.S.Zero),
                 relation="≈" if x.formula != 0 else "=")
        for q, x in p.coordinates.items()
    ]  # fmt: skip
    words = (p.stability.value,) if p.stability in (StabilityVerdict.STABLE, StabilityVerdict.UNSTABLE) else ()
    alone = among is None or len(among.positions) == 1
    forces = [] if alone else [_force_found(name, x) for name, x in p.forces.items()]
    return [*lines[:-1], replace(lines[-1], condition=words), *forces]


def _by_place(found: Sequence[list[Equation]], coordinates: int) -> list[list[Equation]]:
    """Positions with one of the coordinates first that has another value in each of them, if there is one."""
    telling = [n for n in range(coordinates) if len({lines[n].sides for lines in found}) == len(found)]
    last = telling[-1] if telling else 0
    return [[lines[last], *lines[:last], *lines[last + 1 :]] for lines in found]


def _in_a_line(lines: list[Equation]) -> list[Equation]:
    """A position on one line: `θ ≈ 11.17° with x = 0, y ≈ −0.2905 m and T ≈ 80.69 N; unstable`."""
    first, *others = lines
    words = [part for e in lines for part in e.condition]
    beside = ("with ", *listed(math(*e.sides, relation=e.relation) for e in others)) if others else ()
    return [replace(first, condition=(*beside, *(("; ",) if beside and words else ()), *words))]


def _force_found(name: sp.Symbol, x: Quantity) -> Equation:
    return Equation((name, x.shown(RESULT_DIGITS)), relation="≈")


def _degrees(x: Quantity) -> tuple[sp.Expr, ...]:
    """An angle in degrees, beside radians."""
    return (degrees(x.formula, RESULT_DIGITS),) if x.unit == "rad" else ()


def reactions_of_only_root(view: InCoordinates) -> list[Equation]:
    """The named reactions at the only equilibrium, where that was found in numbers and they are not."""
    stated = view.reactions_at_rest is not None and any(there is not None for there in view.reactions_at_rest.at)
    if view.in_numbers is None or stated or len(view.in_numbers.positions) != 1:
        return []
    [only] = view.in_numbers.positions
    return [_force_found(name, x) for name, x in only.forces.items()]


def _with_values(numbers: EquilibriaInNumbers | None, branch: int) -> tuple[Part, ...]:
    """What the given values decide of a branch: `with the given values unstable`; empty if they leave it open.

    A condition in letters beside a number would leave the comparison to the reader.
    """
    if numbers is None:
        return ()
    if branch in numbers.absent:
        return (WITH_VALUES, "no such position")
    verdicts = {p.stability for p in numbers.positions if p.branch == branch}
    for decided in (StabilityVerdict.STABLE, StabilityVerdict.UNSTABLE):
        if verdicts == {decided}:
            return (WITH_VALUES, decided.value)
    return ()


def _lack_units(conditions: Iterable[SignCondition], numbers: EquilibriaInNumbers | None) -> bool:
    """Whether one compares a bare number with what has a unit, as 160 > m g: what the values decide says more."""
    from lagrange.values.dimensions import has_bare_number

    known = {} if numbers is None else numbers.units
    return any(has_bare_number((c.lhs, c.rhs), known) for c in conditions)


def with_units_of_numbers(e: Equation, values: Values) -> Equation:
    """The line with a unit after a bare number in its conditions, W < 160 N, where the other side has a known one."""

    def written(part: Part) -> Part:
        if not isinstance(part, Math) or len(part.sides) != 2:
            return part
        sides = [s for s in part.sides if isinstance(s, sp.Expr)]
        numbers = [s for s in sides if s.is_number and s != 0]
        if len(numbers) != 1 or len(sides) != 2 or numbers[0].has(UnitSymbol):
            return part
        [other] = [s for s in sides if s is not numbers[0]]
        unit = values.unit_of(other)
        if unit in ("", "rad"):
            return part
        return replace(part, sides=tuple(with_unit(s, unit) if s is numbers[0] else s for s in part.sides))

    return replace(e, condition=tuple(map(written, e.condition)))


def _friction(view: InCoordinates, values: Mapping[sp.Symbol, sp.Expr]) -> Iterator[Equation]:
    """Where a system with friction can be at rest, or rolls without slipping; where it is about to slip."""
    rest = view.at_rest
    bounds: list[set[Mathematics]] = []
    if rest is not None and rest.cases:
        yield from (Equation(pair) for pair in rest.relations)
        loads = tuple(load_parameters(view.configuration))
        cases = [for_one_load(tuple(case), loads) for case in strictest_cases(rest.cases, values)]
        stated = [*_cases(cases)]
        yield from stated
        bounds = [{*e.sides} for e in stated]
    if view.rolling is not None:
        yield from _cases(view.rolling.cases[:1])
    branches = [b for m in view.impending or () for b in m.equilibrium.branches]
    for b in branches:
        lines = _branch(b)
        if b.special:  # the forces at the limit, and not where the constraints hold the system anyhow
            moving = {*view.configuration.slots.coordinates}
            forces = [e for e in lines if not any(moving & s.free_symbols for s in e.sides if isinstance(s, sp.Expr))]
            lines = [replace(e, condition=()) for e in forces] or lines
        lines = [e for e in lines if {*e.sides} not in bounds]  # a bound with = is that at the limit
        if rest is not None and rest.always is not None:
            c = rest.always
            lines = [replace(e, condition=("for ", math(c.right, c.left, relation="<"))) for e in lines]
        if rest is not None:  # each of them, since in general the forces have other values
            lines = [replace(e, condition=("at the limit", *((", ", *e.condition) if e.condition else ())))
                     for e in lines]  # fmt: skip
        yield from lines


def _at_the_limit(view: InCoordinates, newton: Newton) -> Iterator[Equation]:
    """The named reactions where slip impends, if it does in one way, and in whatever position."""
    motions = view.impending or ()
    if len(motions) != 1 or len(motions[0].equilibrium.branches) != 1:
        return
    [m] = motions
    pressed = m.pressed_with(m.equilibrium.branches[0])
    coordinates = {*view.configuration.slots.coordinates}
    for r in newton.reactions:
        if r.given is not None and pressed[r.name].free_symbols.isdisjoint(coordinates):
            yield Equation((r.force, pressed[r.name]))


def _forces(rest: AtRest) -> Iterator[Equation]:
    """Friction and normal forces, where the balance determines them and rest is possible."""
    undetermined = {*rest.open}
    for force, value in rest.forces.items() if rest.cases else ():
        if force not in undetermined and value.free_symbols.isdisjoint(undetermined):
            yield Equation((force, value))


def _steady(steady: SteadyMotions) -> Iterator[Equation]:
    """The steady motions, each with its stability."""
    for family in steady.families:
        for b, s in zip(family.about.branches, family.about.at, strict=True):
            words = () if s is None else _in_a_word(s.judgement, [r.rhs for r in family.relations(b)])
            rates = [Equation(rate_or_square(v, value)) for v, value in family.rates.items()]
            if not b.equations:
                lines = [Equation((r.lhs, r.rhs)) for r in family.relations(b)]  # φ'² = 2 a g: it may turn either way
                yield from ([*lines[:-1], replace(lines[-1], condition=words)] if lines else ())
                continue
            given = (*listed(math(*e.sides) for e in rates), ": " if words else "") if rates else ()
            yield from _branch(b, *(("with ",) if given else ()), *given, *words)


def _about_steady(steady: SteadyMotions) -> Iterator[Equation]:
    """The single frequency of small oscillations about the only steady motion, or about each place that is a number.

    About an unstable one there are none.
    """
    branches = [
        (family, b, s)
        for family in steady.families
        for b, s in zip(family.about.branches, family.about.at, strict=True)
    ]
    for family, b, s in branches:
        relations = family.relations(b)
        is_place = bool(relations) and all(r.rhs.is_number for r in relations)
        if s is None or len(s.frequencies) != 1 or not (is_place or len(branches) == 1):
            continue
        [f] = s.frequencies
        if s.judgement.stability.verdict is StabilityVerdict.UNSTABLE or f.square is None or f.square == 0:
            continue
        where = ("it",) if len(branches) == 1 else listed(math(r.lhs, r.rhs) for r in relations)
        yield Equation((family.about.omega**2, f.square), condition=("of small oscillations about ", *where))


def _in_a_word(judgement: StabilityJudgement, values: Sequence[sp.Expr]) -> tuple[Part, ...]:
    """`stable`, `unstable where a > b`, `stable to first order where c > d`; nothing if it is undecided or long.

    What the values of the coordinates divide by differs from zero anyhow.
    """
    s = judgement.stability
    conditions = s.conditions if s.verdict is StabilityVerdict.CONDITIONAL else s.presupposed
    conditions = tuple(c for c in conditions if c.relation != "≠" or c.lhs not in divisors(values))
    if sum(count_operations(c.lhs) for c in conditions) > LONGEST_WORDS:
        return ()
    where = ("where ", *sign_conditions(conditions)) if conditions else ()
    match s.verdict:
        case StabilityVerdict.STABLE | StabilityVerdict.UNSTABLE:
            return (s.verdict.value, " ", *where) if where else (s.verdict.value,)
        case StabilityVerdict.CONDITIONAL if where:
            firm = judgement.ground in (Ground.POTENTIAL, Ground.HURWITZ)
            return ("stable " if firm else "stable to first order ", *where)
    return ()


def _frequencies(
    linearization: Linearization, numbers: EquilibriaInNumbers | None, *, existence_stated: bool = False
) -> Iterator[Equation]:
    """The squares of the frequencies, `about θ = 0`; equal ones about several equilibria in one line.

    existence_stated  whether the conditions for the equilibria stand beside them already
    """
    found: dict[tuple[tuple[tuple[sp.Symbol, sp.Expr], ...], tuple[Part, ...]], list[tuple[Part, ...]]] = {}
    for squares, place, words in _frequencies_about(linearization, numbers, existence_stated):
        found.setdefault((squares, words), []).append(place)
    for (squares, words), places in found.items():
        joined = series(places, " and " if all(len(p) == 1 for p in places) else ", and about ")
        about: tuple[Part, ...] = ("about ", *joined) if any(places) else ()
        condition = (*about, ", " if about and words else "", *words)
        for n, (name, square) in enumerate(squares, start=1):
            yield Equation((name**2, square), condition=condition if n == len(squares) else ())


def _frequencies_about(
    linearization: Linearization, numbers: EquilibriaInNumbers | None, existence_stated: bool
) -> Iterator[tuple[tuple[tuple[sp.Symbol, sp.Expr], ...], tuple[Part, ...], tuple[Part, ...]]]:
    """The frequencies, the place and the words about stability of each equilibrium that is not unstable."""
    for k, (b, at) in enumerate(zip(linearization.branches, linearization.at, strict=True)):
        first = linearization.copy_of(k)
        if first is not None:
            at = linearization.at[first.of] if len(linearization.branches) <= MOST_PLACES else None
        if numbers is not None and k in numbers.absent:
            continue
        if at is None or not at.oscillates or at.judgement.stability.verdict is StabilityVerdict.UNSTABLE:
            continue
        squares = [f.square for f in at.frequencies]
        if any(s is None or count_operations(s) > LONGEST_FREQUENCY for s in squares):
            continue
        about = tuple(listed(math(r.lhs, r.rhs) for r in b.equations))
        stability = at.judgement.stability
        squares = [None if s is None else square_where_stable(s, b, stability) or s for s in squares]
        words = stability_of(at)
        known = _with_values(numbers, k)
        open_ = stability.conditions or stability.presupposed
        implied = {(c.lhs, c.rhs) for c in open_} >= {(c.lhs, c.rhs) for c in b.conditions}
        if b.conditions and not existence_stated and not known and not (implied and words):
            short = [c for c in b.conditions if count_operations(c.lhs - c.rhs) <= LONGEST_WORDS]
            about = (*about, *((" where ", *sign_conditions(short)) if short else ()))
        known = known if open_ or not words else ()
        words = () if known and _lack_units(open_, numbers) else words
        words = (*words, *(("; ",) if words and known else ()), *known)
        several = len(squares) > 1
        names = [f"{at.unknown.name}_{n}" if several else at.unknown.name for n in range(1, len(squares) + 1)]
        lines = [(sp.Symbol(name, real=True), x) for name, x in zip(names, squares, strict=True) if x is not None]
        yield tuple(lines), about, words


def _only_in_numbers(linearization: Linearization, numbers: EquilibriaInNumbers) -> Iterator[Equation]:
    """The frequencies about an equilibrium whose squares have no closed form, or only long ones."""
    for k, (b, at) in enumerate(zip(linearization.branches, linearization.at, strict=True)):
        squares = () if at is None or not at.oscillates else [f.square for f in at.frequencies]
        there = [p.oscillations for p in numbers.positions if p.branch == k]
        if len(there) != 1 or all(s is not None and count_operations(s) <= LONGEST_FREQUENCY for s in squares):
            continue
        about = ("about ", *listed(math(r.lhs, r.rhs) for r in b.equations)) if b.equations else ()
        name = linearization.omega.name
        for n, o in enumerate(there[0], start=1):
            letter = sp.Symbol(f"{name}_{n}" if len(there[0]) > 1 else name, real=True)
            last = n == len(there[0])
            yield Equation((letter, o.frequency.shown(RESULT_DIGITS)), relation="≈", condition=about if last else ())


def _damped(linearization: Linearization) -> Iterator[Equation]:
    """The decay rate and the square of the frequency of one damped coordinate, about each equilibrium."""
    for b, at in zip(linearization.branches, linearization.at, strict=True):
        if at is None or at.damped is None or at.judgement.stability.verdict is StabilityVerdict.UNSTABLE:
            continue
        lines = [Equation((linearization.decay, at.damped.rate)), Equation((linearization.omega**2, at.damped.square))]
        if max(e.operations for e in lines) > LONGEST_FREQUENCY:
            continue
        words = stability_of(at)
        about = ("about ", *listed(math(r.lhs, r.rhs) for r in b.equations)) if b.equations else ()
        yield lines[0]
        yield replace(lines[1], condition=(*about, ", " if about and words else "", *words))


def _damped_modes(linearization: Linearization) -> Iterator[Equation]:
    """The frequencies of several modes about the only equilibrium, each with its decay rate: `ω₁² = c/m, undamped`."""
    at = linearization.at[0] if len(linearization.at) == 1 else None
    damped = None if at is None else at.decaying
    if damped is None or not damped.complete or len(damped.modes) < 2:
        return
    for k, m in enumerate(damped.modes, start=1):
        omega, sigma = (sp.Symbol(f"{s.name}_{k}", real=True) for s in (linearization.omega, linearization.decay))
        if m.difference is None or m.oscillates is False or count_operations(m.difference) > LONGEST_FREQUENCY:
            return
        words: tuple[Part, ...] = ("undamped",) if m.rate == 0 else ("with the decay rate ", math(sigma, m.rate))
        words = (*words, *((", where ", *sign_conditions([m.condition])) if m.condition is not None else ()))
        yield Equation((omega**2, m.difference), condition=words)


def _branch(b: Branch, *more: Part) -> list[Equation]:
    """The equations of a solution, with its conditions next to the last of them, then `more`."""
    condition = branch_conditions(b)
    words = (*condition, "; " if condition else "", *more) if more else condition
    lines = [Equation((r.lhs, r.rhs)) for r in b.equations]
    return [*lines[:-1], replace(lines[-1], condition=words)] if lines else []


def _cases(cases: Sequence[Sequence[RestCondition]]) -> Iterator[Equation]:
    """Inequalities of which all hold; of several cases, if these are short, with `and` and `or` between them."""
    if len(cases) > 1 and any(len(case) > 1 for case in cases) and sum(map(len, cases)) > MOST_LINES_OF_CASES:
        return
    for n, case in enumerate(cases, start=1):
        for m, c in enumerate(case, start=1):
            beside = ("and",) if len(cases) > 1 and m < len(case) else ("or",) if n < len(cases) else ()
            yield Equation((c.left, c.right), relation=c.relation, condition=beside)
