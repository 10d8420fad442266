"""Several hundred random systems at rest, in motion and of constraints, against numbers; `python -m tests.support.nets` runs any number.

A seed that finds something fails with the problem file, what is said of it, and what is true. `OPEN` has the faults that are known.
"""

from __future__ import annotations

import pytest

from tests.support.nets import constraint_systems, motions, statics

OPEN: dict[tuple[str, int], str] = {}
"""Known faults: (net, seed) and the reason. Strict, so that a seed that is mended is taken from here."""

SOFT = ("undecided stability", "undecided linear stability")
"""No false statement; the command counts them, and a test elsewhere holds what must be decided."""

NETS = {"statics": (statics, 160), "motions": (motions, 100), "constraint_systems": (constraint_systems, 60)}


def _cases() -> list[object]:
    return [
        pytest.param(
            name, seed, marks=[pytest.mark.xfail(reason=OPEN[name, seed], strict=True)] if (name, seed) in OPEN else []
        )
        for name, (_, number) in NETS.items()
        for seed in range(1000, 1000 + number)
    ]


@pytest.mark.parametrize(("net", "seed"), _cases())
def test_what_is_printed_is_true(net: str, seed: int) -> None:
    found = NETS[net][0].findings(seed)
    assert [str(f) for f in found if f.kind.removesuffix(" (rewritten)") not in SOFT] == []
