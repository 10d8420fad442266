"""Small oscillations: equilibria, the linear equations about them, frequencies, modes, stability."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.algebra.closed_forms.eigenmodes import Frequency
from lagrange.algebra.closed_forms.single_equation import Relation
from lagrange.algebra.closed_forms.solution_sets import Branch
from lagrange.core.expression_size import count_operations
from lagrange.core.symbols import VectorSymbol, prime
from lagrange.document.derivation import (
    Block,
    Detail,
    Equation,
    EquationKind,
    Matrices,
    Part,
    Phrase,
    Prose,
    Purpose,
    Ref,
    Rule,
    Step,
    display,
    listed,
    math,
    paragraph,
    prose,
    referring_to,
    series,
)
from lagrange.explain.limits import LONGEST_CHARACTERISTIC, LONGEST_CONDITIONS, LONGEST_MODE
from lagrange.explain.rest.equilibrium import but_for_drift, full_turns, outside_ranges, singular_places, why_it_drifts
from lagrange.explain.words import (
    branch_conditions,
    capital,
    existence_left_open,
    plural,
    sign_conditions,
    suffix_of,
    title_in,
)
from lagrange.mechanics.equilibrium.damped_modes import DampedMode, DampedModes
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium
from lagrange.mechanics.equilibrium.limits import MOST_OSCILLATING
from lagrange.mechanics.equilibrium.linear_stability import Ground, VelocityTerms, has_uniform_motion
from lagrange.mechanics.equilibrium.linearization import DampedOscillation, Linearization, SmallOscillations
from lagrange.mechanics.equilibrium.stability import Stability, StabilityVerdict
from lagrange.mechanics.rewriting.readable_forms import is_linear
from lagrange.mechanics.rewriting.stable_frequencies import square_where_stable, where_defined

ZERO = sp.S.Zero
TIME = sp.Symbol("t", real=True)


def explain_linearization(linearization: Linearization, *, after: Equilibrium | None = None) -> Step:
    """The step on small oscillations in one set of coordinates; `after`: the equilibria of the step that precedes."""
    name = linearization.configuration.name
    listed_before = after is not None and linearization.is_about_all_of(after)
    body = [_as_before(linearization)] if listed_before else [*_rest(linearization)]
    if after is not None:
        said = [*singular_places(linearization.equilibrium), *outside_ranges(linearization.equilibrium)]
        body = [b for b in body if b not in said]
    if any(s is not None for s in linearization.at):
        body.append(_names(linearization))
    for n, (b, s) in enumerate(zip(linearization.branches, linearization.at, strict=True), start=1):
        if linearization.copy_of(n - 1) is None:
            body += explain_about(n, b, s, linearization)
            body += _copies(n, linearization)
    body += explain_omitted(linearization)
    if linearization.turning:
        rates = listed(math(prime(q)) for q in linearization.turning)
        body.append(prose("There are steady motions as well, in which ", *rates, " are constant and not zero."))
    if listed_before:
        suffix, numbers = suffix_of(name), range(1, len(linearization.branches) + 1)
        body = [*referring_to(body, {f"at-rest{suffix}-{n}": f"equilibrium{suffix}-{n}" for n in numbers})]
    return Step(Rule.LINEARIZATION, title_in("Small oscillations", name), tuple(body))


def _as_before(linearization: Linearization) -> Block:
    """`At rest the equation of motion is satisfied at (9) and (10).`"""
    refs = listed(
        Ref(label_about_equilibrium(linearization, "at-rest", n + 1)) for n in range(len(linearization.branches))
    )
    equation = plural(len(linearization.motion.final), "equation of motion is", "equations of motion are")
    return prose(f"At rest the {equation} satisfied at ", *refs, ".")


def explain_omitted(
    linearization: Linearization, noun: str = "equilibrium", several: str = "equilibria"
) -> Iterator[Prose]:
    """How many equilibria, or what `noun` says, are listed without their linear equations, if there are too many."""
    if number := len(linearization.omitted):
        others = plural(number, f"one more {noun}", f"{number} more {several}")
        yield prose(f"The linear equations about {others} are not worked out.", detail=Detail.BRIEF)


def _copies(n: int, linearization: Linearization) -> Iterator[Block]:
    """`The same holds about (5), and about (6) and (7) with ξ_3 reversed.`"""
    groups: dict[tuple[sp.Symbol, ...], list[int]] = {}
    for k, copy in enumerate(linearization.copies, start=1):
        if copy is not None and copy.of == n - 1:
            groups.setdefault(copy.reversed, []).append(k)
    if not groups:
        return
    places: list[tuple[Part, ...]] = []
    for turned, numbers in sorted(groups.items(), key=lambda group: len(group[0])):
        refs = listed(Ref(label_about_equilibrium(linearization, "at-rest", k)) for k in numbers)
        signs = plural(len(turned), " with the sign of ", " with the signs of ")
        end: tuple[Part, ...] = (signs, *listed(math(x) for x in turned), " reversed") if turned else ()
        places.append(("about ", *refs, *end))
    total = sum(map(len, groups.values()))
    others = plural(total, "one more equilibrium", f"{total} more equilibria")
    yield prose("The same equations, frequencies and verdict hold for ", f"{others}: ", *series(places, ", and "), ".",
                detail=Detail.BRIEF)  # fmt: skip


def label_about_equilibrium(linearization: Linearization, kind: str, n: int) -> str:
    """The label of an equation about the nth equilibrium."""
    return f"{kind}{suffix_of(linearization.configuration.name)}-{n}"


def _rest(linearization: Linearization) -> Iterator[Block]:
    """The equilibria."""
    e = linearization.equilibrium
    finite = e.configuration.finite_constraints
    cancelled = "Time appears in the positions but cancels in the equations of motion. "
    start = (cancelled if linearization.driven else "") + "At rest all velocities and accelerations are zero"
    shown = list(dict.fromkeys(c.expression for c in e.conditions))
    long = not linearization.complete and sum(count_operations(c) for c in shown) > LONGEST_CHARACTERISTIC
    if e.configuration.rows:
        start += ". Reactions balance the remaining forces" + (", and the constraints hold," if finite else "")
    elif not shown:
        yield prose(start, ", and the equations of motion hold everywhere.")
        return
    elif linearization.complete and not linearization.branches and any(c.is_number for c in shown):
        yield prose(start, ", and the equations of motion cannot hold: there is no equilibrium.")
        yield from singular_places(e)
        return
    elif long:
        start += ", and what remains of the equations of motion, a long expression, holds"
    else:
        one = len(shown) == 1
        yield prose(start, ", and the equation of motion reduces to" if one else
                    ", and the equations of motion reduce to")  # fmt: skip
        yield display(
            *(
                Equation((c, ZERO), label=label_about_equilibrium(linearization, "rest", n))
                for n, c in enumerate(shown, 1)
            )
        )
        start = "This holds"
    if not linearization.branches:
        nowhere = f"{start} nowhere: there is no equilibrium."
        yield prose(
            nowhere if linearization.complete else f"{start} at positions that were not found in closed form.",
            detail=Detail.BRIEF,
        )
        yield from singular_places(e)
        return
    listed_ = linearization.complete or linearization.branches == e.branches  # solved, or stated by their equations
    yield prose(f"{start} at" if listed_ else f"{start}, perhaps among other positions, at")
    for n, b in enumerate(linearization.branches, start=1):
        lines = [Equation((r.lhs, r.rhs)) for r in b.equations]
        if not lines:
            yield prose("every position.")
            continue
        last = lines[-1]
        lines[-1] = Equation(
            last.sides, label=label_about_equilibrium(linearization, "at-rest", n), condition=branch_conditions(b)
        )
        yield display(*lines, detail=Detail.BRIEF)
    branches = enumerate(linearization.branches, start=1)
    yield from existence_left_open((Ref(label_about_equilibrium(linearization, "at-rest", n)), b) for n, b in branches)
    yield from singular_places(e)
    yield from outside_ranges(e)
    yield from full_turns(e)


def _names(linearization: Linearization) -> Block:
    """ξ for θ − θ_0."""
    coordinates = linearization.configuration.slots.coordinates
    small = listed(math(x) for x in linearization.displacements)
    changes = plural(len(coordinates), "change", "changes")
    be = prose("Let ", *small, f" be the small {changes} of ", *listed(math(q) for q in coordinates),
               " from equilibrium.")  # fmt: skip
    [x, *others] = linearization.displacements
    quantities: tuple[Part, ...] = ("them and their rates",) if others else (math(x), " and ", math(prime(x)))
    neglected = prose("Terms of second order in ", *quantities, " are neglected.")
    if is_linear(linearization):
        return replace(be, short=be.parts)
    used = any(
        s is not None and s.judgement.stability.verdict is not StabilityVerdict.UNSTABLE for s in linearization.at
    )
    return replace(paragraph(be, neglected), short=be.parts, detail=Detail.BRIEF if used else Detail.STEPS)


def explain_about(
    n: int,
    b: Branch,
    s: SmallOscillations | None,
    linearization: Linearization,
    noun: str = "equilibrium",
    relations: Sequence[Relation] | None = None,
) -> Iterator[Block]:
    """The linear equations about one equilibrium, or whatever `noun` says; its relations are those of the branch."""
    is_stated = bool(b.equations if relations is None else relations)
    place: Part = Ref(label_about_equilibrium(linearization, "at-rest", n)) if is_stated else "any position"
    if s is None:
        if b.left or b.special or any(linearization.branches[k] is b for k in linearization.omitted):
            return
        if len(linearization.equilibrium.elimination.independent) > MOST_OSCILLATING:
            yield prose(f"Linear equations of more than {MOST_OSCILLATING} coordinates are not worked out.")
            return
        yield prose(
            "At ",
            place,
            " there are no linear equations of motion: the coordinates or the forces are singular there, so that "
            "the conditions of rest do not show whether the system can rest there.",
        )
        return
    symbols = {x for e in s.equations for x in e.free_symbols} & set(linearization.configuration.slots.coordinates)
    taken = (
        (
            ", with ",
            *listed(math(q) for q in sorted(symbols, key=str)),
            f" at {noun}," if noun == "equilibrium" else f" in the {noun},",
        )
        if symbols
        else ()
    )
    yield prose("About ", place, *taken, plural(len(s.equations), " the equation of motion becomes",
                                                " the equations of motion become"))  # fmt: skip
    hidden = s.judgement.stability.verdict is StabilityVerdict.UNSTABLE
    lines = [
        Equation((e, ZERO), label=label_about_equilibrium(linearization, f"linear-{k}", n), kind=EquationKind.LINEAR)
        for k, e in enumerate(s.equations, 1)
    ]
    yield display(*lines, boxed=not hidden, detail=Detail.STEPS if hidden else Detail.BRIEF)
    yield from _bound(s, linearization)
    yield from _matrices(s)
    yield from _characteristic(n, b, s, linearization, Detail.FULL if hidden else Detail.STEPS)
    rest = "every position of rest" if noun == "equilibrium" else f"every such {noun}"
    named = (f"the {noun} ", place) if is_stated else (rest,)
    drift = s.judgement.stability.drift
    if drift is not None:
        V = "the potential energy" if not linearization.driven else "the potential energy of the turning system"
        several = "Each root zero corresponds" if drift.several else "The root zero corresponds"
        yield prose(f"{several} to a uniform motion: ", *why_it_drifts(drift, V), ". So ", *named, " is ",
                    *but_for_drift(drift), ".", detail=Detail.BRIEF)  # fmt: skip
        return
    yield from _verdict(
        named, where_defined(s, b), label_about_equilibrium(linearization, "omega-1", n), exact=is_linear(linearization)
    )


def _bound(s: SmallOscillations, linearization: Linearization) -> Iterator[Block]:
    """The small changes that the constraints give."""
    moved = [linearization.displacements[k] for k in s.free]
    lines = [
        Equation((x, sp.Add(*(c * y for c, y in zip(row, moved, strict=True)))))
        for k, (x, row) in enumerate(zip(linearization.displacements, s.shape, strict=True))
        if k not in s.free
    ]
    if lines:
        yield prose("where, to first order and by the constraints,")
        yield display(*lines)


def _matrices(s: SmallOscillations) -> Iterator[Block]:
    system = s.system
    if len(system.mass) == 1:
        return
    named = [(VectorSymbol("M"), system.mass), (VectorSymbol("K"), system.stiffness)]
    if system.kind is not VelocityTerms.NONE:
        named.insert(1, (VectorSymbol("D"), system.damping))
    yield prose("Their matrices, before common factors are divided out, are", detail=Detail.FULL)
    yield Matrices(tuple(named), Detail.FULL)


def _characteristic(
    n: int, b: Branch, s: SmallOscillations, linearization: Linearization, detail: Detail
) -> Iterator[Block]:
    """det(K − ω² M) = 0, its roots with their modes."""
    unknown, c = s.unknown, s.characteristic
    if not s.oscillates:
        yield from _damped(n, s, linearization)
        return
    if s.long_square is not None:
        [x] = (linearization.displacements[k] for k in s.free)
        equation = Ref(label_about_equilibrium(linearization, "linear-1", n))
        yield prose("There are solutions proportional to cos(", math(unknown), " ", math(TIME), "), where ",
                    math(unknown**2), " is the coefficient of ", math(x), " in ", equation, " divided by that of ",
                    math(prime(x, 2)), ".", detail=detail)  # fmt: skip
        label = label_about_equilibrium(linearization, "omega-1", n)
        yield display(Equation((unknown**2, s.long_square), label=label), detail=Detail.FULL)
        return
    if c is None:
        yield prose("The equation for the frequencies is too long to be written out.", detail=detail)
        return
    gyroscopic = s.system.kind is VelocityTerms.GYROSCOPIC
    wave = ("exp(i " if gyroscopic else "cos(", math(unknown), " ", math(TIME), ")")
    closed = all(f.square is not None for f in s.frequencies)
    if len(s.free) > 1 and count_operations(c) <= LONGEST_CHARACTERISTIC:
        words = ", with constant amplitudes not all zero, exist if"
        yield prose("Solutions proportional to ", *wave, words, detail=detail)
        yield display(
            Equation((c, ZERO), label=label_about_equilibrium(linearization, "frequencies", n)), detail=detail
        )
        yield prose("The roots are" if closed else _not_closed(s), detail=detail)
    else:
        subject = Phrase("There are", Purpose.SUBJECT, plural(len(s.free), "It has", "They have"))
        amplitude = plural(len(s.free), ", with a constant amplitude", ", with constant amplitudes") if closed else ""
        ending = Phrase(f"{amplitude}, where", Purpose.WHERE, " with")
        purpose = Purpose.WAVES if closed else None
        yield prose(subject, " solutions proportional to ", *wave, ending, detail=detail, purpose=purpose)
    several = len(s.frequencies) > 1
    lines = []
    for k, f in enumerate(s.frequencies, start=1):
        if f.square is not None:
            omega = sp.Symbol(f"{unknown.name}_{k}", real=True) if several else unknown
            label = label_about_equilibrium(linearization, f"omega-{k}", n)
            ratios = _long_ratios(f, s, linearization)
            line = Equation((omega**2, f.square), label=label, condition=() if ratios else _mode(f, s, linearization))
            stability = s.judgement.stability
            stable = square_where_stable(f.square, b, stability)
            if stable is not None:
                where = ("where ", *sign_conditions(stability.conditions))
                line = replace(line, sides=(*line.sides, stable), condition=line.condition or where)
            lines.append(line)
            lines += ratios
        elif len(s.frequencies) > 1:
            lines.append(Equation((s.remaining(f), ZERO)))
    if lines:
        yield display(*lines, boxed=detail is Detail.STEPS, detail=Detail.BRIEF if detail is Detail.STEPS else detail)
    if several and any(f.modes for f in s.frequencies) and s.system.symmetric:
        words = "The ratios are those of the displacements in each normal mode."
        yield prose(words, detail=detail)


def _not_closed(s: SmallOscillations) -> str:
    if len(s.frequencies) == 1:
        return "This equation for the squares of the frequencies has no closed solution, or only a long one."
    return "Not all roots have a short closed form:"


def _mode(f: Frequency, s: SmallOscillations, linearization: Linearization) -> tuple[Part, ...]:
    """`twice, with ξ_1 : ξ_2 as 1 : 0 and 0 : 1`."""
    times = {1: "", 2: "twice", 3: "three times"}.get(f.multiplicity, f"{f.multiplicity} times")
    if not f.modes or len(s.free) == 1:
        return (times,) if times else ()
    modes = (math(*mode, relation=":") for mode in f.modes)
    start = f"{times}, with " if times else "with "
    ratio = (start, math(*(linearization.displacements[k] for k in s.free), relation=":"), " as ", *listed(modes))
    return (*ratio, *_presupposed(f, ", "))


def _presupposed(f: Frequency, before: str = "") -> tuple[Part, ...]:
    """`where y ≠ 0`: the divisors of the ratios."""
    return (f"{before}where ", *sign_conditions(f.presupposed)) if f.presupposed else ()


def _long_ratios(f: Frequency, s: SmallOscillations, linearization: Linearization) -> list[Equation]:
    """ξ_2/ξ_1 = ..., for a mode too long to be shown beside its frequency, where it could not be broken."""
    if len(f.modes) != 1 or f.modes[0][0] != 1 or sum(count_operations(a) for a in f.modes[0]) <= LONGEST_MODE:
        return []
    first, *others = (linearization.displacements[k] for k in s.free)
    lines = [Equation((q / first, a)) for q, a in zip(others, f.modes[0][1:], strict=True)]
    return [*lines[:-1], replace(lines[-1], condition=_presupposed(f))]


def _damped(n: int, s: SmallOscillations, linearization: Linearization) -> Iterator[Block]:
    """With damping: the characteristic equation for p; for one coordinate the frequency and the damping ratio."""
    p, c = s.unknown, s.characteristic
    wave = ("exp(", math(p), " ", math(TIME), ")")
    if c is not None and count_operations(c) <= LONGEST_CHARACTERISTIC:
        yield prose("Nonzero solutions proportional to ", *wave, " exist if")
        yield display(Equation((c, ZERO), label=label_about_equilibrium(linearization, "exponents", n)))
    if s.damped is not None:
        yield from _one_damped(n, s, s.damped, linearization)
    elif s.decaying is not None and s.judgement.stability.verdict is not StabilityVerdict.UNSTABLE:
        yield from _decaying(n, s, s.decaying, linearization)


def _one_damped(
    n: int, s: SmallOscillations, damped: DampedOscillation, linearization: Linearization
) -> Iterator[Block]:
    """Of one coordinate: its own frequency, the damping ratio, the decay rate; the three cases."""
    omega = linearization.omega
    own, ratio = sp.Symbol(f"{omega.name}_0", real=True), sp.Symbol("zeta", real=True)
    sigma = linearization.decay
    yield prose("Without damping the frequency would be ", math(own), "; the damping ratio is ", math(ratio),
                ", the decay rate ", math(sigma), ":")  # fmt: skip
    lines = [
        Equation((own**2, damped.own), label=label_about_equilibrium(linearization, "own", n)),
        Equation((ratio, damped.rate / own), label=label_about_equilibrium(linearization, "ratio", n)),
        Equation((sigma, damped.rate), label=label_about_equilibrium(linearization, "decay", n)),
        Equation(
            (omega**2, own**2 * (1 - ratio**2), damped.square), label=label_about_equilibrium(linearization, "omega", n)
        ),
    ]
    yield display(*lines, boxed=True, detail=Detail.BRIEF)
    less, more = (math(ratio, sp.S.One, relation=r) for r in ("<", ">"))
    mode = s.decaying.modes[0] if s.decaying is not None and len(s.decaying.modes) == 1 else None
    condition = mode.condition if mode is not None else None
    where: tuple[Part, ...] = (", that is, ", *sign_conditions([condition]), ",") if condition is not None else (",",)
    exponent = ("exp(−", math(sigma), " ", math(TIME), ")")
    root = sp.sqrt(sigma**2 - own**2)
    yield prose(
        "If ", less, *where, " it oscillates with the frequency ", math(omega), " and decays as ", *exponent, ". If ",
        math(ratio, sp.S.One), ", the damping is critical: both exponents are ", math(-sigma), ". If ", more,
        ", it does not oscillate: two motions decay with the rates ", math(sigma), " ± ", math(root), ".",
    )  # fmt: skip


def _decaying(n: int, s: SmallOscillations, damped: DampedModes, linearization: Linearization) -> Iterator[Block]:
    """The modes of several coordinates, each with its decay rate and, where it oscillates, its frequency."""
    if not damped.modes:
        yield prose("This equation has no roots in closed form, or only long ones.")
        return
    p, sigma, omega = s.unknown, linearization.decay, linearization.omega
    pairs = any(m.oscillates is not False for m in damped.modes)
    lead: tuple[Part, ...] = ("In each mode the motion decays as exp(−", math(sigma), " ", math(TIME), ")")
    if damped.proportional:
        lead = ("The damping is proportional, and the modes are those of the undamped system. ", *lead)
    roots = (" = −", math(sigma), " ± i ", math(omega))
    wave = (" while it oscillates with the frequency ", math(omega), ", with ", math(p), *roots) if pairs else ()
    yield prose(*lead, *wave, ":")
    lines: list[Equation] = []
    rates = [(m, r) for m in damped.modes for r in (m.decays if m.oscillates is False else (m.rate,))]
    several = len(rates) > 1
    for k, (m, rate) in enumerate(rates, start=1):
        shape = _damped_shape(m, s, linearization)
        name = sp.Symbol(f"{sigma.name}_{k}", real=True) if several else sigma
        oscillates = m.square is not None and m.oscillates is not False
        critical: tuple[Part, ...] = ("twice",) if m.is_critical else ()
        lines.append(
            Equation((name, rate), label=label_about_equilibrium(linearization, f"decay-{k}", n),
                     condition=() if oscillates else (*critical, *((", " if critical and shape else "",)), *shape))
        )  # fmt: skip
        if oscillates and m.square is not None:
            own = sp.Symbol(f"{omega.name}_{k}", real=True) if several else omega
            where = ("where ", *sign_conditions([m.condition])) if m.condition is not None else ()
            words = (*where, ", " if where and shape else "", *shape)
            lines.append(
                Equation(
                    (own**2, m.difference or m.square),
                    label=label_about_equilibrium(linearization, f"omega-{k}", n),
                    condition=words,
                )
            )
    yield display(*lines, boxed=True, detail=Detail.BRIEF)
    if idle := [f"{sigma.name}_{k}" for k, (_, rate) in enumerate(rates, start=1) if rate == 0]:
        zero = listed(math(sp.Symbol(name, real=True), ZERO) for name in idle)
        yield prose("With ", *zero, ": nothing damps ", plural(len(idle), "this mode", "these modes"),
                    ", and it goes on for ever." if len(idle) == 1 else ", and they go on for ever.")  # fmt: skip
    if any(m.condition is not None for m in damped.modes):
        root = sp.Pow(-(omega**2), sp.S.Half, evaluate=False)
        yield prose("Where ", math(omega**2, ZERO, relation="<"), " for a mode, it does not oscillate but decays with "
                    "the two rates ", math(sigma), " ± ", math(root), ".")  # fmt: skip
    if damped.left:
        yield prose("The other roots are those of")
        yield display(*(Equation((f, ZERO)) for f, _ in damped.left if count_operations(f) <= LONGEST_CHARACTERISTIC))


def _damped_shape(m: DampedMode, s: SmallOscillations, linearization: Linearization) -> tuple[Part, ...]:
    """`with ξ_1 : ξ_2 as 1 : −1`."""
    if not m.shape or sum(count_operations(a) for a in m.shape) > LONGEST_MODE:
        return ()
    moved = (linearization.displacements[k] for k in s.free)
    return ("with ", math(*moved, relation=":"), " as ", math(*m.shape, relation=":"))


def _is_sign_of_square(s: SmallOscillations) -> bool:
    """Whether it depends on the sign of the only ω², and to write the conditions out would take long."""
    one = len(s.free) == 1 and len(s.frequencies) == 1 and s.frequencies[0].square is not None
    length = sum(count_operations(c.lhs - c.rhs) for c in s.judgement.stability.conditions)
    return one and s.oscillates and length > LONGEST_CONDITIONS


def _verdict(named: tuple[Part, ...], s: SmallOscillations, square: str, *, exact: bool) -> Iterator[Prose]:
    """The verdict on stability.

    square  the label of ω², where there is one
    exact   whether the equations of motion are linear themselves
    """
    stability, ground = s.judgement.stability, s.judgement.ground
    detail = Detail.BRIEF
    firm = ground is Ground.POTENTIAL or ground is Ground.HURWITZ
    stable = "asymptotically stable" if s.judgement.asymptotic else "stable"
    stable = stable if firm or ground is None else "stable to first order"
    first, *others = named
    subject = (capital(first), *others) if isinstance(first, str) else named
    match stability.verdict:
        case StabilityVerdict.STABLE:
            yield prose(*_why(s), *named, f" is {stable}", *_presupposing(stability), ".", detail=detail)
        case StabilityVerdict.UNSTABLE:
            yield prose(*_why(s), *named, " is unstable", *_presupposing(stability), ".", detail=detail)
        case StabilityVerdict.CONDITIONAL if _is_sign_of_square(s):
            yield prose(*subject, f" is {stable} where the right side of ", Ref(square), " is positive, and unstable "
                        "where it is negative.", detail=detail)  # fmt: skip
        case StabilityVerdict.CONDITIONAL:
            where = sign_conditions(stability.conditions)
            strict = [c for c in stability.conditions if c.relation != "≠"]
            reversed_ = (
                "the opposite inequality holds" if len(stability.conditions) == 1 else "one of these is reversed"
            )
            if strict != list(stability.conditions):
                reversed_ = (
                    "the inequality with > or < is reversed" if len(strict) == 1 else "one with > or < is reversed"
                )
            contrary = (
                f", and unstable where {reversed_}."
                if strict
                else "; where the sides are equal, two frequencies coincide, and a motion may grow as the time does."
            )
            yield prose(*subject, f" is {stable} where ", *where, contrary, detail=detail)
        case StabilityVerdict.UNDECIDED if _stays_displaced(s):
            yield from _at_a_neighbour(named, s, exact=exact)
        case StabilityVerdict.UNDECIDED if stability.unstable:
            uniform = any(f.square == 0 for f in s.frequencies)
            rest = "The root zero corresponds to a uniform motion: elsewhere" if uniform else "Elsewhere"
            where = sign_conditions(stability.unstable, " or ")
            end = f". {rest} the linear equations do not decide."
            yield prose(*subject, " is unstable where ", *where, end, detail=detail)
        case StabilityVerdict.UNDECIDED if any(f.square == 0 for f in s.frequencies) and exact:
            words = "The root zero corresponds to a uniform motion. The equations of motion are linear, so it goes on "
            yield prose(words, "for ever: ", *named, " is not stable.", detail=detail)
        case StabilityVerdict.UNDECIDED if any(f.square == 0 for f in s.frequencies):
            words = "The root zero corresponds to a uniform motion: the linear equations do not decide whether "
            yield prose(words, *named, " is stable.", detail=detail)
        case StabilityVerdict.UNDECIDED:
            yield prose("The linear equations do not decide whether ", *named, " is stable.", detail=detail)


def _stays_displaced(s: SmallOscillations) -> bool:
    """Whether a root is zero and belongs to no uniform motion."""
    return any(f.square == 0 for f in s.frequencies) and has_uniform_motion(s.system) is False


def _at_a_neighbour(named: tuple[Part, ...], s: SmallOscillations, *, exact: bool) -> Iterator[Prose]:
    """The verdict where the root zero is a displacement to another position of rest and no motion."""
    zero = "The root zero corresponds to a displacement after which nothing moves"
    others = [f for f in s.frequencies if f.square != 0]
    bounded = all(f.square is not None and f.square.is_positive and f.multiplicity == 1 for f in others)
    if exact and bounded and len(others) <= 1:
        yield prose(f"{zero}. The equations of motion are linear, so a motion that begins nearby stays nearby: ",
                    *named, " is stable.", detail=Detail.BRIEF)  # fmt: skip
        return
    if unstable := s.judgement.stability.unstable:
        where = sign_conditions(unstable, " or ")
        elsewhere = ". Elsewhere the linear equations do not decide."
        yield prose(f"{zero}; ", *named, " is unstable where ", *where, elsewhere, detail=Detail.BRIEF)
        return
    yield prose(f"{zero}: the linear equations do not decide whether ", *named, " is stable.", detail=Detail.BRIEF)


def _presupposing(stability: Stability) -> tuple[Part, ...]:
    """`where a > b`: what keeps the deciding expressions from being zero."""
    return (" where ", *sign_conditions(stability.presupposed)) if stability.presupposed else ()


def _why(s: SmallOscillations) -> tuple[Part, ...]:
    """The reason, as the beginning of a sentence."""
    stability, ground = s.judgement.stability, s.judgement.ground
    one = len(s.free) == 1
    stable = stability.verdict is StabilityVerdict.STABLE
    grows = " is negative, so some motion grows exponentially: "
    long = any(count_operations(m) > LONGEST_MODE for m in stability.minors[:1])
    match ground:
        case Ground.POTENTIAL if not stable:
            return ("Some displacement produces a force that increases it: ",)
        case Ground.POTENTIAL if s.system.kind is VelocityTerms.NONE:
            return ("The square of the frequency is positive: " if one else "All roots are positive: ",)
        case Ground.POTENTIAL if one:
            return ("Every displacement produces a restoring force: ",)
        case Ground.POTENTIAL:
            return (
                "Every displacement produces restoring forces, and the velocity-dependent forces supply no energy: ",
            )
        case Ground.DETERMINANT:
            return ("The determinant of the terms without derivatives" + grows,)
        case Ground.ROOTS if stable:
            return ("The roots are positive and different: ",)
        case Ground.ROOTS if long and stability.minors[0] in [f.square for f in s.frequencies]:
            return (("The square of the frequency" if one else "One root") + grows,)
        case Ground.ROOTS if stability.minors[0] in [f.square for f in s.frequencies]:
            root: tuple[Part, ...] = ("Here ",) if one else ("One root is ",)
            return (*root, math(s.unknown**2, stability.minors[0]), "; this" + grows)
        case Ground.ROOTS:
            return ("Not all roots are positive and different: ",)
        case Ground.HURWITZ:
            return ("By Hurwitz' conditions ",)
    return ()
