"""A choice of coordinates that leaves a constraint, in fewer lines.

The full derivation states the constraint that is left for velocities, for displacements, solved for a displacement, and
solved for a velocity. Each follows from the one before at sight: the page has the first and the solved one.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import pairwise

from lagrange.core.symbols import VectorSymbol
from lagrange.document.builders import display, has_purpose, index_of, listed, math, parts_of, prose
from lagrange.document.derivation import Block, Detail, Display, Equation, Math, Part, Prose, Ref, Rule, Step
from lagrange.document.purposes import Phrase, Purpose
from lagrange.explain.limits import LONGEST_PRINCIPLE, LONGEST_PRINCIPLE_OF_BODIES, LONGEST_SOLVED_RELATION
from lagrange.explain.page.system import are_short
from lagrange.explain.words import capital, plural

_RULES = (Rule.GENERALIZED_COORDINATES, Rule.EQUATIONS_OF_MOTION)


def in_few_lines(steps: Sequence[Step]) -> Iterator[Step]:
    """The steps, those in chosen coordinates shorter."""
    shown: dict[object, str] = {}
    for step in steps:
        if step.choice and not step.folded and step.rule in _RULES:
            body = _velocities_solved(_displacements_solved(_without_announcement([*step.body])))
            step = replace(step, body=tuple(_brackets_once(_kinematics_at_once(body, shown), steps)))
        elif not step.folded:
            lines = (e for b in step.body if isinstance(b, Display) and _is_kinematic(b) for e in b.equations)
            shown |= {e.sides: e.label for e in lines if e.label}
        yield step


def _without_announcement(body: list[Block]) -> list[Block]:
    """No `ψ is eliminated through its velocity`, where the velocity is then solved for."""
    return [b for b in body if not has_purpose(b, Purpose.ELIMINATED)]


def _place(purpose: Purpose, body: Sequence[Block]) -> int | None:
    return next((n for n, b in enumerate(body) if has_purpose(b, purpose)), None)


def _displacements_solved(body: list[Block]) -> list[Block]:
    """`In a virtual displacement δψ = (1/R) δs` without the equation of which this is the solution."""
    at = _place(Purpose.VIRTUAL, body)
    if at is None or len(body) < at + 4:
        return body
    solving, solved = body[at + 2], body[at + 3]
    if not has_purpose(solving, Purpose.SOLVING) or not isinstance(solved, Display) or solved.detail is Detail.FULL:
        return body
    where = _condition(solving)
    rest = body[at + 4 :]
    if rest and has_purpose(rest[0], Purpose.FREE):
        rest = rest[1:]
    begins: tuple[Part, ...] = ("In a virtual displacement", *where)
    if len(solved.equations) == 1 and solved.operations <= LONGEST_SOLVED_RELATION:
        return [*body[:at], prose(*begins, " ", math(*solved.equations[0].sides), "."), *rest]
    return [*body[:at], prose(*begins), solved, *rest]


def _condition(solving: Prose) -> tuple[Part, ...]:
    """`, where x ≠ 0,` of `Solving for δx, where x ≠ 0, gives`."""
    at = index_of(Purpose.WHERE, solving.parts)
    return () if at is None else solving.parts[at:-1]


def _velocities_solved(body: list[Block]) -> list[Block]:
    """Velocities and accelerations side by side, or in a sentence where there is one of each."""
    at = _place(Purpose.RATES, body)
    if at is None:
        return body
    solving, rates = body[at], body[at + 1]
    assert isinstance(solving, Prose)
    assert isinstance(rates, Display)
    half = len(rates.equations) // 2
    velocities, accelerations = rates.equations[:half], rates.equations[half:]
    if len(velocities) != len(accelerations):
        return body
    pairs = [e for both in zip(velocities, accelerations, strict=True) for e in both]
    end = body[at + 2]
    if half == 1 and sum(e.operations for e in pairs) <= LONGEST_SOLVED_RELATION and isinstance(end, Prose):
        refs = [p for p in solving.parts if isinstance(p, Ref)]
        if len(refs) == 1:
            both = listed(math(*e.sides) for e in pairs)
            words = prose("By ", *refs, ", ", *both, ". ", *end.parts)
            return [*body[:at], words, *body[at + 3 :]]
    if not are_short(pairs):
        return body
    lines = (replace(v, condition=(Math(a.sides),)) for v, a in zip(velocities, accelerations, strict=True))
    return [*body[: at + 1], display(*lines), *body[at + 2 :]]


def _brackets_once(body: list[Block], steps: Sequence[Step]) -> list[Block]:
    """A long principle not written out, where nothing is left to be done but to read off its brackets."""
    at = _place(Purpose.PRINCIPLE, body)
    if at is None or len(body) < at + 4:
        return body
    reads, written, vanish, box = body[at : at + 4]
    if not isinstance(written, Display) or not isinstance(box, Display) or not box.boxed:
        return body
    [line, *more] = written.equations
    used = any(p.label == line.label for s in steps for b in s.body for p in parts_of(b) if isinstance(p, Ref))
    turning = any((e.label or "").startswith("rotation") for b in body if isinstance(b, Display) for e in b.equations)
    longest = LONGEST_PRINCIPLE_OF_BODIES if turning else LONGEST_PRINCIPLE
    if more or used or line.operations <= longest or not isinstance(vanish, Prose):
        return body
    assert isinstance(reads, Prose)
    refs = [p for p in reads.parts if isinstance(p, Ref)]
    words = prose("Substitute these in d'Alembert's principle ", *refs, ". ", *vanish.parts)
    return [*body[:at], words, box, *body[at + 4 :]]


def _kinematics_at_once(body: list[Block], before: Mapping[object, str]) -> list[Block]:
    """Accelerations, virtual displacements and rotations of bodies in one display.

    before  the labels of those that the page has shown in the file's coordinates, by their sides
    """
    places = [n for n, b in enumerate(body) if isinstance(b, Display) and _is_kinematic(b)]
    if len(places) not in (2, 3) or any(b - a != 2 for a, b in pairwise(places)):
        return body
    shown = [b for n in places if isinstance(b := body[n], Display)]
    kinds = [_kind(b) for b in shown]
    if kinds not in (["acceleration", "delta", "rotation"], ["acceleration", "rotation"]):
        return body
    lines = [e for b in shown for e in b.equations]
    if not all(_is_vector(e) for e in lines):
        return body
    first = _subject(body[places[0] - 1])
    moved = plural(len(shown[1].equations), "the virtual displacement", "the virtual displacements")
    turned = plural(len(shown[-1].equations), "the virtual rotation", "the virtual rotations")
    whats = [first, moved, turned] if len(shown) == 3 else [first, turned]
    known = [before.get(e.sides) for e in shown[0].equations]
    if all(known):
        refs = listed(Ref(label) for label in known if label)
        verb = plural(len(known), "is", "are")
        like = "formed like the angular velocity with δ for d/dt"
        are = plural(len(shown[-1].equations), "is", "are")
        begins = f"{moved} and, {like}, {turned} are" if len(shown) == 3 else f"{turned}, {like}, {are}"
        both = " and ".join(first.rsplit(", ", 1))
        given = prose(f"{capital(both)} {verb} given by ", *refs, f". {capital(begins)}")
        rest = [e for b in shown[1:] for e in b.equations]
        return [*body[: places[0] - 1], given, display(*rest), *body[places[-1] + 1 :]]
    what = f"{', '.join(whats[:-1])} and, formed like the angular velocity with δ for d/dt, {whats[-1]}"
    return [*body[: places[0] - 1], prose(f"{capital(what)} are"), display(*lines), *body[places[-1] + 1 :]]


def _subject(lead: Block) -> str:
    """`the accelerations, the rates of change of the angular momenta`, whose values follow."""
    assert isinstance(lead, Prose)
    subject = next(p for p in lead.parts if isinstance(p, Phrase) and p.purpose is Purpose.SUBJECT)
    return subject.instead


def _kind(block: Display) -> str:
    label = block.equations[0].label or ""
    return "acceleration" if label.startswith("momentum-rate") else label.partition("-")[0]


def _is_kinematic(block: Display) -> bool:
    starts = ("acceleration", "momentum-rate", "delta", "rotation")
    return all((e.label or "").startswith(starts) for e in block.equations)


def _is_vector(e: Equation) -> bool:
    return isinstance(e.sides[0], VectorSymbol)
