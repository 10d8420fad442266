"""Random systems at rest, in motion and of constraints, against numbers; `python -m tests.support.nets` runs any number, `--times` more of these.

A seed that finds something fails with the problem file, what was printed, and what is true.
"""

from __future__ import annotations

import pytest

from tests.support.chance import times
from tests.support.nets import constraint_systems, further_statics, motions, questions, statics, units
from tests.support.nets.run import Finding

NETS = {"statics": (statics, 30), "motions": (motions, 30), "constraint_systems": (constraint_systems, 15)}
NETS |= {"units": (units, 12), "further_statics": (further_statics, 12), "questions": (questions, 20)}
FIRST = 1000
MENDED = {"statics": (1, 108, 147, 153, 20122), "further_statics": (32,)}
"""Seeds beside the run that found something once."""

SOFT = ("undecided stability", "undecided linear stability")
"""No false statements, but questions that numbers decide; the command counts them."""


def plain(f: Finding) -> str:
    return f.kind.removesuffix(" (rewritten)")


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
    assert [str(f) for f in found if plain(f) not in SOFT] == []
