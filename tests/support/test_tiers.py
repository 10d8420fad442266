"""The list of slow tests names what is there."""

from __future__ import annotations

import pytest

from tests.support.paths import ROOT
from tests.support.tiers import TIERS, tier_of


@pytest.mark.parametrize("name", [name for slow in TIERS.values() for name in slow])
def test_what_is_named_is_there(name: str) -> None:
    path, _, function = name.partition("::")
    there = ROOT / "tests" / path
    assert there.is_dir() if path.endswith("/") else f"def {function}" in there.read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("test", "tier"),
    [
        ("truth/test_laws.py::test_energy_is_conserved", "truth"),
        ("command/test_grade.py::test_a_device_has_no_journal", "process"),
        ("render/test_tikz.py::test_pictures_compile", "process"),
        ("algebra/closed_forms/test_branching.py::test_systems[x-y]", "truth"),
        ("algebra/closed_forms/test_branching.py::test_systems_of_one", None),
        ("golden/test_golden.py::test_output_is_as_it_was[ex11-ideal-pendulum-80.txt]", None),
    ],
)
def test_tier(test: str, tier: str | None) -> None:
    assert tier_of(test) == tier
