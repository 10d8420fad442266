"""Small oscillations: where the system can rest, the linear equations there, frequencies, modes, stability."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import sympy as sp

from lagrange.algebra.closed_forms.eigenmodes import Frequency
from lagrange.algebra.closed_forms.signs import Condition
from lagrange.algebra.closed_forms.solution_sets import Branch
from lagrange.core.symbols import VectorSymbol
from lagrange.document.derivation import (
    Block,
    Detail,
    Equation,
    Matrices,
    Part,
    Prose,
    Ref,
    Rule,
    Step,
    display,
    listed,
    math,
    paragraph,
    prose,
)
from lagrange.explain.words import plural, spoken
from lagrange.mechanics.equilibrium.linear_stability import Ground, Kind
from lagrange.mechanics.equilibrium.linearization import MOST_EQUILIBRIA, Linearization, SmallOscillations
from lagrange.mechanics.equilibrium.stability import Verdict

ZERO = sp.S.Zero
TIME = sp.Symbol("t", real=True)
LONGEST_BESIDE = 15
"""Operations of a mode that still stands behind its frequency."""
LONGEST = 120
"""Operations of conditions, or of a characteristic equation, that are still shown."""


def explain_linearization(found: Linearization) -> Step:
    """The step on small oscillations in one set of coordinates."""
    name = found.configuration.name
    body = [*_rest(found)]
    if any(s is not None for s in found.at):
        body.append(_names(found))
    for n, (b, s) in enumerate(zip(found.branches, found.at, strict=True), start=1):
        body += _about(n, b, s, found)
    title = f"Small oscillations: {spoken(name)}" if name else "Small oscillations"
    return Step(Rule.LINEARIZATION, title, tuple(body))


def _label(found: Linearization, kind: str, n: int) -> str:
    name = found.configuration.name
    return f"{kind}{f'-{name}' if name else ''}-{n}"


def _rest(found: Linearization) -> Iterator[Block]:
    """The equilibria."""
    e = found.equilibrium
    finite = e.configuration.finite_constraints
    cancelled = "The positions contain time, and the equations of motion do not: it has cancelled. "
    start = (cancelled if found.driven else "") + "At rest all velocities and accelerations are zero"
    shown = list(dict.fromkeys(c.expression for c in e.conditions))
    long = not found.complete and sum(c.count_ops() for c in shown) > LONGEST
    if e.configuration.rows:
        start += ". Reactions balance the forces that are left" + (", and the constraints hold," if finite else "")
    elif not shown:
        yield prose(start, ", and the equations of motion hold everywhere.")
        return
    elif long:
        start += ", and what remains of the equations of motion, long here, holds"
    else:
        one = len(shown) == 1
        yield prose(start, f", and of the equation{'' if one else 's'} of motion there remain{'s' if one else ''}")
        yield display(*(Equation((c, ZERO), label=_label(found, "rest", n)) for n, c in enumerate(shown, 1)))
        start = "This holds"
    if not found.branches:
        nowhere = f"{start} nowhere: there is no equilibrium."
        yield prose(
            nowhere if found.complete else f"{start} where it is not solved in closed form.", detail=Detail.BRIEF
        )
        return
    yield prose(f"{start} at" if found.complete else f"{start}, perhaps among other places, at")
    for n, b in enumerate(found.branches, start=1):
        lines = [Equation((r.lhs, r.rhs)) for r in b.equations]
        if not lines:
            yield prose("every position.")
            continue
        last = lines[-1]
        lines[-1] = Equation(last.sides, label=_label(found, "at-rest", n), condition=_when(b))
        yield display(*lines, detail=Detail.BRIEF)


def _when(b: Branch) -> tuple[Part, ...]:
    words: list[Part] = []
    if b.conditions:
        words += ["where ", *_listed(b.conditions)]
    if b.special:
        words.append("; then in every position" if words else "then in every position")
    if b.left:
        words.append("; not solved in closed form" if words else "not solved in closed form")
    return tuple(words)


def _listed(conditions: tuple[Condition, ...]) -> tuple[Part, ...]:
    return listed(math(c.lhs, c.rhs, relation=c.relation) for c in conditions)


def _names(found: Linearization) -> Block:
    """ξ for θ − θ_0."""
    coordinates = found.configuration.slots.coordinates
    small = listed(math(x) for x in found.displacements)
    changes, rates = plural(len(coordinates), "change", "changes"), plural(len(coordinates), "its rate", "their rates")
    be = prose("Let ", *small, f" be the small {changes} of ", *listed(math(q) for q in coordinates), " from rest.")
    what = plural(len(coordinates), "it", "them")
    left_out = prose(f"What is of second order in {what} and {rates} is left out.")
    used = any(s is not None and s.judgement.stability.verdict is not Verdict.UNSTABLE for s in found.at)
    return replace(paragraph(be, left_out), short=be.parts, detail=Detail.BRIEF if used else Detail.STEPS)


def _about(n: int, b: Branch, s: SmallOscillations | None, found: Linearization) -> Iterator[Block]:
    """One equilibrium."""
    place: Part = Ref(_label(found, "at-rest", n)) if b.equations else "any position"
    if s is None:
        if n > MOST_EQUILIBRIA or b.left or b.special:
            return
        yield prose(
            "At ", place, " there are no linear equations of motion: the coordinates, or the forces, fail there."
        )
        return
    symbols = {x for e in s.equations for x in e.free_symbols} & set(found.configuration.slots.coordinates)
    taken = (", ", *listed(math(q) for q in sorted(symbols, key=str)), " being taken at rest,") if symbols else ()
    yield prose("About ", place, *taken, plural(len(s.equations), " the equation of motion becomes",
                                                " the equations of motion become"))  # fmt: skip
    hidden = s.judgement.stability.verdict is Verdict.UNSTABLE
    lines = [Equation((e, ZERO), label=_label(found, f"linear-{k}", n)) for k, e in enumerate(s.equations, 1)]
    yield display(*lines, boxed=not hidden, detail=Detail.STEPS if hidden else Detail.BRIEF)
    yield from _bound(s, found)
    yield from _matrices(s)
    yield from _characteristic(n, s, found, Detail.FULL if hidden else Detail.STEPS)
    named = ("the equilibrium ", place) if b.equations else ("every position of rest",)
    yield from _verdict(named, s)


def _bound(s: SmallOscillations, found: Linearization) -> Iterator[Block]:
    """The small changes that the constraints give."""
    moved = [found.displacements[k] for k in s.free]
    lines = [
        Equation((x, sp.Add(*(c * y for c, y in zip(row, moved, strict=True)))))
        for k, (x, row) in enumerate(zip(found.displacements, s.shape, strict=True))
        if k not in s.free
    ]
    if lines:
        yield prose("where to first order, by the constraints,")
        yield display(*lines)


def _matrices(s: SmallOscillations) -> Iterator[Block]:
    system = s.system
    if len(system.mass) == 1:
        return
    named = [(VectorSymbol("M"), system.mass), (VectorSymbol("K"), system.stiffness)]
    if system.kind is not Kind.NONE:
        named.insert(1, (VectorSymbol("D"), system.damping))
    yield prose("Their matrices, before common factors are divided out, are", detail=Detail.FULL)
    yield Matrices(tuple(named), Detail.FULL)


def _characteristic(n: int, s: SmallOscillations, found: Linearization, detail: Detail) -> Iterator[Block]:
    """det(K − ω² M) = 0, its roots with their modes."""
    unknown, c = s.unknown, s.characteristic
    amplitude = " with constant amplitudes" if len(s.free) > 1 else " with a constant amplitude"
    if not s.oscillates:
        yield from _damped(n, s, found)
        return
    if c is None:
        yield prose("The equation for the frequencies is too long to be written down.", detail=detail)
        return
    gyroscopic = s.system.kind is Kind.GYROSCOPIC
    wave = ("exp(i " if gyroscopic else "cos(", math(unknown), " ", math(TIME), ")")
    closed = all(f.square is not None for f in s.frequencies)
    if len(s.free) > 1 and c.count_ops() <= LONGEST:
        yield prose("Put proportional to ", *wave, f"{amplitude}, they have a solution if", detail=detail)
        yield display(Equation((c, ZERO), label=_label(found, "frequencies", n)), detail=detail)
        yield prose("The roots are" if closed else _not_closed(s), detail=detail)
    else:
        yield prose("It is solved by ", *wave, f"{amplitude}, where" if closed else ", where", detail=detail)
    several = len(s.frequencies) > 1
    lines = []
    for k, f in enumerate(s.frequencies, start=1):
        if f.square is not None:
            omega = sp.Symbol(f"{unknown.name}_{k}", real=True) if several else unknown
            label = _label(found, f"omega-{k}", n)
            ratios = _long_ratios(f, s, found)
            lines.append(Equation((omega**2, f.square), label=label, condition=() if ratios else _mode(f, s, found)))
            lines += ratios
        elif len(s.frequencies) > 1:
            lines.append(Equation((s.remaining(f), ZERO)))
    if lines:
        yield display(*lines, boxed=detail is Detail.STEPS, detail=Detail.BRIEF if detail is Detail.STEPS else detail)
    if several and any(f.modes for f in s.frequencies) and s.system.symmetric:
        words = "The ratios are those of the displacements in each normal mode."
        yield prose(words, detail=detail)


def _not_closed(s: SmallOscillations) -> str:
    degree = "this is an equation for the squares of the frequencies that has no solution in closed form, or a long one"
    return f"{degree[0].upper()}{degree[1:]}." if len(s.frequencies) == 1 else "Not all roots have a short closed form:"


def _mode(f: Frequency, s: SmallOscillations, found: Linearization) -> tuple[Part, ...]:
    """`with ξ_1 : ξ_2 as 1 : √2`."""
    if not f.modes or len(s.free) == 1:
        return ("twice",) if f.multiplicity == 2 else ()
    modes = (math(*mode, relation=":") for mode in f.modes)
    ratio = ("with ", math(*(found.displacements[k] for k in s.free), relation=":"), " as ", *listed(modes))
    return (*ratio, *_presupposed(f, ", "))


def _presupposed(f: Frequency, before: str = "") -> tuple[Part, ...]:
    """`where y ≠ 0`: what the ratios have been divided by."""
    return (f"{before}where ", *_listed(f.presupposed)) if f.presupposed else ()


def _long_ratios(f: Frequency, s: SmallOscillations, found: Linearization) -> list[Equation]:
    """ξ_2/ξ_1 = ..., for a mode too long to stand behind its frequency, where it could not be broken."""
    if len(f.modes) != 1 or f.modes[0][0] != 1 or sum(a.count_ops() for a in f.modes[0]) <= LONGEST_BESIDE:
        return []
    first, *others = (found.displacements[k] for k in s.free)
    lines = [Equation((q / first, a)) for q, a in zip(others, f.modes[0][1:], strict=True)]
    return [*lines[:-1], replace(lines[-1], condition=_presupposed(f))]


def _damped(n: int, s: SmallOscillations, found: Linearization) -> Iterator[Block]:
    """With damping: the characteristic equation for p; for one coordinate what is known of it."""
    p, c = s.unknown, s.characteristic
    wave = ("exp(", math(p), " ", math(TIME), ")")
    if c is not None and c.count_ops() <= LONGEST:
        yield prose("Proportional to ", *wave, plural(len(s.free), ", it has", ", they have"), " a solution if")
        yield display(Equation((c, ZERO), label=_label(found, "exponents", n)))
    if s.damped is None:
        return
    omega = found.omega
    own, ratio = sp.Symbol(f"{omega.name}_0", real=True), sp.Symbol("zeta", real=True)
    yield prose("Without damping the frequency would be ", math(own), "; the damping ratio is ", math(ratio), ":")
    lines = [
        Equation((own**2, s.damped.own), label=_label(found, "own", n)),
        Equation((ratio, s.damped.rate / own), label=_label(found, "ratio", n)),
        Equation((omega**2, own**2 * (1 - ratio**2), s.damped.square), label=_label(found, "omega", n)),
    ]
    yield display(*lines, boxed=True, detail=Detail.BRIEF)
    less, more = math(ratio, sp.S.One, relation="<"), math(ratio, sp.S.One, relation="≥")
    yield prose(
        "Where ", less, " it oscillates with the frequency ", math(omega), ", dying away; where ", more,
        " it returns without oscillating.",
    )  # fmt: skip


def _verdict(named: tuple[Part, ...], s: SmallOscillations) -> Iterator[Prose]:
    """What is said of stability."""
    stability, ground = s.judgement.stability, s.judgement.ground
    detail = Detail.BRIEF
    firm = ground is Ground.POTENTIAL or ground is Ground.HURWITZ
    stable = "stable, and the motion dies away" if s.judgement.asymptotic else "stable"
    stable = stable if firm or ground is None else "stable to first order"
    first, *others = named
    capital = (f"{first[0].upper()}{first[1:]}", *others) if isinstance(first, str) else named
    match stability.verdict:
        case Verdict.STABLE:
            yield prose(*_why(s), *named, f" is {stable}.", detail=detail)
        case Verdict.UNSTABLE:
            yield prose(*_why(s), *named, " is unstable.", detail=detail)
        case Verdict.CONDITIONAL:
            where = _listed(stability.conditions)
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
                else "; where the sides are equal, the linear equations do not decide."
            )
            yield prose(*capital, f" is {stable} where ", *where, contrary, detail=detail)
        case Verdict.UNDECIDED if stability.unstable:
            uniform = any(f.square == 0 for f in s.frequencies)
            rest = "To the root zero belongs a uniform motion: elsewhere" if uniform else "Elsewhere"
            where = listed((math(c.lhs, c.rhs, relation=c.relation) for c in stability.unstable), " or ")
            end = f". {rest} the linear equations do not decide."
            yield prose(*capital, " is unstable where ", *where, end, detail=detail)
        case Verdict.UNDECIDED if any(f.square == 0 for f in s.frequencies):
            words = "To the root zero belongs a uniform motion: the linear equations do not decide whether "
            yield prose(words, *named, " is stable.", detail=detail)
        case Verdict.UNDECIDED:
            yield prose("The linear equations do not decide whether ", *named, " is stable.", detail=detail)


def _why(s: SmallOscillations) -> tuple[Part, ...]:
    """The reason, as the beginning of a sentence."""
    stability, ground = s.judgement.stability, s.judgement.ground
    one = len(s.free) == 1
    stable = stability.verdict is Verdict.STABLE
    grows = " is negative, so that some motion grows as an exponential function: "
    long = any(m.count_ops() > LONGEST_BESIDE for m in stability.minors[:1])
    match ground:
        case Ground.POTENTIAL if not stable:
            return ("Some displacement causes a force that drives away: ",)
        case Ground.POTENTIAL if s.system.kind is Kind.NONE:
            return ("The square of the frequency is positive: " if one else "All roots are positive: ",)
        case Ground.POTENTIAL if one:
            return ("The force that a displacement causes drives back: ",)
        case Ground.POTENTIAL:
            return ("Every displacement causes forces that drive back, and those with velocities give no energy: ",)
        case Ground.DETERMINANT:
            return ("The determinant of the terms without derivatives" + grows,)
        case Ground.ROOTS if stable:
            return ("The roots are positive and different: ",)
        case Ground.ROOTS if long and stability.minors[0] in [f.square for f in s.frequencies]:
            return (("The square of the frequency" if one else "One root") + grows,)
        case Ground.ROOTS if stability.minors[0] in [f.square for f in s.frequencies]:
            root: tuple[Part, ...] = ("It is solved by ",) if one else ("One root is ",)
            return (*root, math(s.unknown**2, stability.minors[0]), "; this" + grows)
        case Ground.ROOTS:
            return ("Not all roots are positive and different: ",)
        case Ground.HURWITZ:
            return ("By Hurwitz' conditions ",)
    return ()
