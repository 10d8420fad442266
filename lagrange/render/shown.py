"""What of a derivation is shown at a level of detail, and how its equations are numbered.

Numbers run through what is shown, so that they have no gaps; a reference to an equation that is not shown
is replaced by the equation itself.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from lagrange.derivation import Block, Derivation, Detail, Display, Equation, Picture, Step


@dataclass(frozen=True)
class Shown:
    """The steps with what is shown of them, the numbers of the equations, and the equations left out."""

    steps: tuple[Step, ...]
    numbers: dict[str, int]
    hidden: dict[str, Equation]


def shown(derivation: Derivation, detail: Detail, first: int = 1, *, pictures: bool = False) -> Shown:
    """Selects the blocks of a derivation; numbers begin with `first`. Pictures are drawn only where they are wanted."""
    steps = []
    for step in derivation.steps:
        body = tuple(block for block in step.body if block.detail <= detail and _has_place(block, pictures))
        if body:
            steps.append(replace(step, body=body))
    labelled = [e for e in _equations(steps) if e.label is not None]
    numbers = {e.label: n for n, e in enumerate(labelled, first) if e.label is not None}
    everything = {e.label: e for e in _equations(derivation.steps) if e.label is not None}
    hidden = {label: e for label, e in everything.items() if label not in numbers}
    return Shown(tuple(steps), numbers, hidden)


def _has_place(block: Block, pictures: bool) -> bool:
    return not isinstance(block, Picture) or (pictures and block.draw() is not None)


def _equations(steps: tuple[Step, ...] | list[Step]) -> list[Equation]:
    return [
        equation for step in steps for block in step.body if isinstance(block, Display) for equation in block.equations
    ]
