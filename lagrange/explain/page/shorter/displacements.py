"""Virtual displacements without a list of their own, where it would repeat that of the forms with δ for d.

Time does not appear in A dq = 0, so that virtual displacements satisfy A δq = 0: one sentence under the forms says it,
and what referred to the second list refers to the first.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from lagrange.document.builders import has_purpose, index_of, listed, paragraph, parts_of, prose
from lagrange.document.derivation import Block, Display, Equation, Part, Prose, Ref, Rule, Step
from lagrange.document.purposes import Phrase, Purpose


def with_one_list(steps: Sequence[Step]) -> Iterator[Step]:
    """The steps, without a list of conditions on virtual displacements that repeats the forms."""
    at = next((n for n, s in enumerate(steps) if s.rule is Rule.DISPLACEMENTS and not s.folded and not s.choice), None)
    labels = [] if at is None else _repeated(steps, steps[at], [*steps[at + 1 :]])
    before = {e.label: n for n, s in enumerate(steps[:at]) for e in _equations(s) if not s.folded}
    forms = [f"form-{name}" for name in labels]
    if any(form not in before for form in forms):
        forms = [f"constraint-{name}" for name in labels]  # on velocities, as they stand
    if at is None or not labels or any(form not in before for form in forms):
        yield from steps
        return
    rule = {f"virtual-{name}": form for name, form in zip(labels, forms, strict=True)}
    last = max(before[form] for form in forms)
    shown = {e.label: e for s in steps[:at] for e in _equations(s)}
    how = ", with δ in place of d:"
    if not forms[0].startswith("form-"):
        plain = all(shown[form].sides[-1] == 0 for form in forms)
        how = how.replace("d:", "d/dt:") if plain else ", the right sides taken to the left, and δ in place of d/dt:"
    for n, step in enumerate(steps):
        if n == at:
            continue
        yield _referring(_with_sentence(step, forms) if n == last else step, rule, how)


def _repeated(steps: Sequence[Step], step: Step, after: Sequence[Step]) -> list[str]:
    """The names of the constraints whose forms a step repeats, if it does nothing else that the page needs."""
    if len(step.body) < 2:
        return []
    first, shown, *rest = step.body
    if not has_purpose(first, Purpose.TIMELESS) or not isinstance(shown, Display):
        return []
    labels = [e.label or "" for e in shown.equations]
    if not labels or not all(label.startswith("virtual-") for label in labels):
        return []
    if rest and not (_are_used_later(after) and not _referred(rest, steps)):
        return []
    return [label.removeprefix("virtual-") for label in labels]


def _are_used_later(after: Sequence[Step]) -> bool:
    """Whether displacements follow again where they are used: in coordinates that are chosen."""
    shown = [s for s in after if not s.folded]
    again = any(s.choice and any(_is_delta(e) for e in _equations(s)) for s in shown)
    return again or any(s.rule is Rule.FRICTION_AT_REST for s in shown)


def _is_delta(e: Equation) -> bool:
    return (e.label or "").startswith("delta")


def _referred(blocks: Sequence[Block], steps: Sequence[Step]) -> bool:
    """Whether anything refers to an equation of these blocks, or uses what they solve for."""
    labels = {e.label for b in blocks if isinstance(b, Display) for e in b.equations if e.label}
    return any(p.label in labels for s in steps for b in s.body for p in parts_of(b) if isinstance(p, Ref))


def _equations(step: Step) -> Iterator[Equation]:
    yield from (e for b in step.body if isinstance(b, Display) for e in b.equations)


def _with_sentence(step: Step, forms: Sequence[str]) -> Step:
    """The step with the forms, and that virtual displacements satisfy them too."""
    refs = listed(map(Ref, forms))
    *body, last = step.body
    if isinstance(last, Prose) and index_of(Purpose.NO_TIME, last.parts[-1:]) is not None:
        *parts, end = last.parts
        assert isinstance(end, Phrase)
        so = (f"{end.instead}, so virtual displacements satisfy ", *refs, " with δ in place of d/dt.")
        return replace(step, body=(*body, prose(*parts, *so, purpose=last.purpose)))
    words = prose("Since time does not appear, virtual displacements satisfy ", *refs, " with δ in place of d.")
    return replace(step, body=(*body, paragraph(last, words)) if isinstance(last, Prose) else (*body, last, words))


def _referring(step: Step, rule: dict[str, str], how: str) -> Step:
    """The step with references to other labels; `how` their sides are meant where these are multiplied."""

    def part(p: Part) -> Part:
        return Ref(rule[p.label]) if isinstance(p, Ref) and p.label in rule else p

    def block(b: Block) -> Block:
        if isinstance(b, Prose):
            parts = tuple(map(part, b.parts))
            if parts != b.parts and index_of(Purpose.LEFT_SIDES, parts[-1:]) is not None:
                parts = (*parts[:-1], how)  # it is a left side with d, or with velocities, now
            return replace(b, parts=parts, short=tuple(map(part, b.short)))
        if isinstance(b, Display):
            return replace(b, equations=tuple(replace(e, condition=tuple(map(part, e.condition))) for e in b.equations))
        return b

    return replace(step, body=tuple(map(block, step.body)))
