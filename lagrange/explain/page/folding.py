"""What a page that derives a motion, an impact or rest shows only on request: why its constraints are not integrable.

The question of integrability is a subject of its own where a problem asks about constraints. On the way to a motion
the answer suffices: no constraint on velocities is a relation between coordinates. The differential forms are then
the constraints themselves with dx for ẋ; the virtual displacements satisfy them with δx.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from lagrange.document.builders import has_purpose, index_of, listed, prose
from lagrange.document.derivation import Block, Display, Prose, Ref, Rule, Step
from lagrange.document.purposes import Purpose
from lagrange.explain.words import plural
from lagrange.mechanics.results import Solution

TITLE = "Differential forms and integrability"
_TESTED = (Rule.PFAFFIAN_FORM, Rule.INTEGRABILITY)


def without_test(solution: Solution, steps: Sequence[Step]) -> tuple[list[Step], list[Step]]:
    """The steps of the page, and those on integrability, to be folded."""
    if not _is_beside_the_point(solution):
        return [*steps], []
    tested = [s for s in steps if s.rule in _TESTED]
    forms = {f"form-{c.row.name}" for c in solution.classification.constraints}
    if any(forms & _referred(s) for s in steps if s.rule not in (*_TESTED, Rule.DISPLACEMENTS)):
        tested = [s for s in tested if s.rule is Rule.INTEGRABILITY]
    if any(forms & _referred(s) and not _is_of_same(s) for s in steps if s.rule is Rule.DISPLACEMENTS):
        tested = [s for s in tested if s.rule is Rule.INTEGRABILITY]
    hidden = [b for s in tested for b in _hidden(s)]
    kept: list[Step] = []
    for s in steps:
        if s.rule is Rule.CLASSIFICATION:
            kept.append(replace(s, body=(_by_theorem(s.body[0]), *s.body[1:], *hidden)))
        elif s.rule is Rule.DISPLACEMENTS and _is_of_same(s) and len(tested) > 1:
            kept.append(replace(s, body=(_with_variations(solution), *s.body[1:])))
        elif s not in tested:
            kept.append(s)
    folded = (TITLE,) if len(tested) > 1 else ("Integrability",)
    return kept, [replace(s, folded=folded) for s in tested]


def _is_beside_the_point(solution: Solution) -> bool:
    """Whether more than constraints is asked, and each one on velocities is no relation between coordinates."""
    own = solution.own
    derived = own.dynamics is not None or own.equilibrium is not None or solution.impact is not None
    rows = [c for c in solution.classification.constraints if c.row.finite is None]
    return derived and bool(rows) and all(c.integrable is False and c.pfaffian for c in rows)


def _is_of_same(step: Step) -> bool:
    return bool(step.body) and has_purpose(step.body[0], Purpose.TIMELESS)


def _referred(step: Step) -> set[str]:
    return {p.label for b in step.body if isinstance(b, Prose) for p in b.parts if isinstance(p, Ref)} | {
        p.label for b in step.body if isinstance(b, Display) for e in b.equations for p in e.condition
        if isinstance(p, Ref)
    }  # fmt: skip


def _hidden(step: Step) -> Iterator[Block]:
    """The finite relations that no single constraint shows, with the sentence before them."""
    for before, block in zip(step.body, step.body[1:], strict=False):
        if isinstance(block, Display) and any((e.label or "").startswith("hidden-") for e in block.equations):
            yield before
            yield block


def _by_theorem(block: Block) -> Block:
    """`..., so the system is nonholonomic`, with the name of the theorem that says so."""
    if not isinstance(block, Prose):
        return block
    why = index_of(Purpose.CONCLUSION, block.parts)
    if why is None:
        return block
    return replace(block, parts=(*block.parts[:why], " (Frobenius' theorem)", *block.parts[why:]))


def _with_variations(solution: Solution) -> Prose:
    """With time frozen, δx takes the place of ẋ."""
    rows = solution.own.configuration.rows
    refs = listed(Ref(f"constraint-{r.name}") for r in rows)
    return prose("Time does not appear in ", *refs, ". Virtual displacements satisfy ", plural(len(rows), "it", "them"),
                 " with δ in place of d/dt:", purpose=Purpose.TIMELESS)  # fmt: skip
