"""Where a system can rest and how it moves nearby, in a few lines: positions, stability, periods or frequencies."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.core.expression_size import count_operations
from lagrange.document.derivation import Block, Emphasis, Part, Purpose, listed, math, prose
from lagrange.explain.limits import LONGEST_FREQUENCY, LONGEST_WORDS
from lagrange.explain.page.conclusions.limiting import period_of
from lagrange.explain.rest.equilibrium import but_for_drift
from lagrange.explain.words import in_words, sign_conditions
from lagrange.mechanics.equilibrium.linear_stability import Ground
from lagrange.mechanics.equilibrium.stability import StabilityVerdict

if TYPE_CHECKING:
    from lagrange.algebra.closed_forms.solution_sets import Branch
    from lagrange.mechanics.equilibrium.linearization import Linearization, SmallOscillations


def explain_rest(small: Linearization) -> Iterator[Block]:
    """`At rest: θ = 0, stable; θ = π, unstable. Small motion: θ = ξ, ..., with the period 2π √(l/g).`

    Of several coordinates the stable positions only, with their frequencies; nothing if a position has conditions.
    """
    places: list[tuple[tuple[Part, ...], str]] = []
    motions: list[Block] = []
    for branch, at in zip(small.branches, small.at, strict=True):
        words = None if at is None else stability_of(at)
        if at is None or not words or branch.left or not _is_implied(branch, at) or _is_long(at):
            return
        place = listed(math(r.lhs, r.rhs) for r in branch.relations)
        verdict = stability_word(at)
        if verdict is None and len(small.displacements) > 1:
            return
        places.append(((*place, ", ", *words), verdict or ""))
        motions += _motion(small, branch, at)
    if not places:
        return
    unstable = [p for p, verdict in places if verdict == "unstable"]
    shown = [p for p, _ in places]
    rest: tuple[Part, ...] = ()
    if len(small.displacements) > 1 and len(unstable) > 1:
        shown = [p for p, verdict in places if verdict != "unstable"]
        others = "others" if shown else "positions"
        rest = ("; " if shown else "", f"{in_words(len(unstable), '').split()[0]} {others} are unstable")
    called = "At rest in the turning system" if small.driven else "At rest"
    yield prose(Emphasis(called), ": ", *_joined(shown), *rest, ".", purpose=Purpose.AT_REST)
    yield from dict.fromkeys(motions)


def _is_implied(branch: Branch, at: SmallOscillations) -> bool:
    """Whether a position exists wherever it is said to be stable or not: k ≠ m Ω² where k > m Ω²."""
    stability = at.judgement.stability
    said = {(c.lhs, c.rhs) for c in (*stability.conditions, *stability.presupposed)}
    return all((c.lhs, c.rhs) in said for c in branch.conditions)


def _is_long(at: SmallOscillations) -> bool:
    stability = at.judgement.stability
    return sum(count_operations(c.lhs) for c in (*stability.conditions, *stability.presupposed)) > LONGEST_WORDS


def _motion(small: Linearization, branch: Branch, at: SmallOscillations) -> Iterator[Block]:
    if len(small.displacements) == 1:
        period = _period(at)
        if period is None:
            yield from _where_stable(small, branch, at)
        if period is None or len(branch.relations) != 1:
            return
        [xi], [relation] = small.displacements, branch.relations
        q = relation.lhs
        near = math(q, relation.rhs + xi) if isinstance(q, sp.Symbol) else math(q, relation.rhs)
        motion = (": ", near, ", ", math(at.equations[0], sp.S.Zero), ", with the period ")
        yield prose(Emphasis("Small motion"), *motion, math(period), ".", purpose=Purpose.SMALL_MOTION)
        return
    squares = [f.square for f in at.frequencies]
    if not at.oscillates or stability_word(at) == "unstable" or any(s is None or not s.is_positive for s in squares):
        return
    if any(s is not None and count_operations(s) > LONGEST_FREQUENCY for s in squares):
        return
    names = [sp.Symbol(f"{at.unknown.name}_{n}", real=True) for n in range(1, len(squares) + 1)]
    values = listed(math(name**2, s) for name, s in zip(names, squares, strict=True) if s is not None)
    about = listed(math(r.lhs, r.rhs) for r in branch.relations)
    words = (" about ", *about, ": the frequencies are given by ", *values, ".")
    yield prose(Emphasis("Small motion"), *words, purpose=Purpose.SMALL_MOTION)


def _where_stable(small: Linearization, branch: Branch, at: SmallOscillations) -> Iterator[Block]:
    """`Small motion: ω² = (k − m Ω²)/m where it is stable`, of a frequency in terms of parameters."""
    conditional = at.judgement.stability.verdict is StabilityVerdict.CONDITIONAL and at.oscillates
    square = small.square_where_stable(branch, at) if conditional else None
    moving = {*small.configuration.slots.coordinates}
    if square is not None and not square.free_symbols & moving and count_operations(square) <= LONGEST_FREQUENCY:
        omega = math(small.omega**2, square)
        yield prose(Emphasis("Small motion"), ": ", omega, " where it is stable.", purpose=Purpose.SMALL_MOTION)


def _joined(items: Sequence[tuple[Part, ...]]) -> tuple[Part, ...]:
    parts: list[Part] = []
    for n, item in enumerate(items):
        parts += ["; " if n else "", *item]
    return tuple(parts)


def stability_word(at: SmallOscillations) -> str | None:
    """`stable` or `unstable`; None if this needs qualification."""
    verdict = at.judgement.stability.verdict
    if at.judgement.stability.presupposed or at.judgement.stability.conditions:
        return None
    if verdict is StabilityVerdict.STABLE and at.judgement.ground in (Ground.POTENTIAL, Ground.HURWITZ):
        return "asymptotically stable" if at.judgement.asymptotic else "stable"
    return "unstable" if verdict is StabilityVerdict.UNSTABLE else None


def _period(at: SmallOscillations) -> sp.Expr | None:
    """2π/ω, where the motion is an oscillation with a positive ω²."""
    if not at.oscillates or at.judgement.stability.verdict is not StabilityVerdict.STABLE or len(at.frequencies) != 1:
        return None
    square = at.frequencies[0].square
    if square is None or not square.is_positive:
        return None
    return period_of(square)


def stability_of(at: SmallOscillations) -> tuple[Part, ...]:
    """`stable where a > b`, `stable to first order where c > d`, `stable apart from a uniform motion of X`."""
    stability = at.judgement.stability
    if stability.drift is not None:
        drift = stability.drift
        return ("stable apart from a uniform motion",) if len(drift.coordinates) > 1 else but_for_drift(drift)
    firm = at.judgement.ground in (Ground.POTENTIAL, Ground.HURWITZ)
    if stability.conditions:
        return ("stable where " if firm else "stable to first order where ", *sign_conditions(stability.conditions))
    if stability.presupposed and firm and stability.verdict is StabilityVerdict.STABLE:
        return ("stable where ", *sign_conditions(stability.presupposed))
    verdict = stability_word(at)
    return (verdict,) if verdict else ()
