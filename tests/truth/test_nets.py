"""Random systems at rest, in motion and of constraints, against numbers; `python -m tests.support.nets` runs any number, `--times` more of these.

A seed that finds something fails with the problem file, what is said of it, and what is true.
"""

from __future__ import annotations

from dataclasses import dataclass

import pytest

from tests.support.chance import times
from tests.support.nets import constraint_systems, motions, statics, units
from tests.support.nets.run import Finding

NETS = {"statics": (statics, 40), "motions": (motions, 40), "constraint_systems": (constraint_systems, 20)}
NETS |= {"units": (units, 18)}
FIRST = 1000
MENDED = {"statics": (1, 108, 147, 153)}
"""Seeds beside the run that found something once."""

SOFT = ("undecided stability", "undecided linear stability")
"""No false statements, but questions that numbers decide; the command counts them."""


@dataclass(frozen=True)
class Open:
    """A known fault: the kind of finding, the family in which it occurs, a seed that shows it, and what it is.

    `always`: whether each run shows it, or only some, with the random points that are drawn.
    """

    kind: str
    family: str
    seed: int
    reason: str
    always: bool = True


OPEN = [
    Open(
        "refused",
        "four-bar linkage",
        1021,
        "links that can fold: a point on another component of the constraints is drawn, where a divisor is zero",
        always=False,
    )
]


def plain(f: Finding) -> str:
    return f.kind.removesuffix(" (rewritten)")


def is_open(f: Finding) -> bool:
    return any(plain(f) == known.kind and f"title: {known.family}\n" in f.text for known in OPEN)


@pytest.mark.parametrize(
    ("net", "seed"),
    [
        (net, seed)
        for net, (_, number) in NETS.items()
        for seed in (*range(FIRST, FIRST + times(number)), *MENDED.get(net, ()))
    ],
)
def test_what_is_printed_is_true(net: str, seed: int) -> None:
    found = NETS[net][0].findings(seed)
    assert [str(f) for f in found if plain(f) not in SOFT and not is_open(f)] == []


@pytest.mark.parametrize(
    "known",
    [
        pytest.param(k, marks=pytest.mark.xfail(reason=k.reason, strict=k.always), id=f"{k.kind}-{k.family}")
        for k in OPEN
    ],
)
def test_known_faults(known: Open) -> None:
    """When one of these passes, it is mended: it is taken from the list, and the net holds it."""
    assert [str(f) for f in statics.findings(known.seed) if plain(f) == known.kind] == []
