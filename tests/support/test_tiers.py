"""The list of slow tests names what is there."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.support import tiers
from tests.support.paths import ROOT
from tests.support.tiers import ALWAYS, SECONDS, TIERS, representatives, tier_of


@pytest.mark.parametrize(
    "name", [*(name for slow in TIERS.values() for name in slow), *sorted(SECONDS.keys() | ALWAYS)]
)
def test_what_is_named_is_there(name: str) -> None:
    path, _, function = name.partition("::")
    there = ROOT / "tests" / path
    assert there.is_dir() if path.endswith("/") else f"def {function}" in there.read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("test", "tier"),
    [
        ("truth/test_laws.py::test_energy_is_conserved", "truth"),
        ("command/grading/test_run.py::test_a_device_has_no_journal", "process"),
        ("render/test_tikz.py::test_pictures_compile", "process"),
        ("algebra/closed_forms/test_branching.py::test_systems[x-y]", "slow"),
        ("algebra/closed_forms/test_branching.py::test_systems_of_one", None),
        ("explain/test_constraints.py::test_a_form_has_a_name_that_nothing_else_has[pulley]", None),
        ("golden/test_golden.py::test_output_is_as_it_was[ex11-ideal-pendulum-80.txt]", None),
    ],
)
def test_tier(test: str, tier: str | None) -> None:
    assert tier_of(test) == tier


def test_what_took_long_altogether_is_slow(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(tiers, "MEASURED", tmp_path / "slow_tests.txt")
    tiers.renew({"a.py::b[1]": 0.6, "a.py::b[2]": 0.6, "a.py::c": 0.2, "truth/d.py::e": 5})
    assert tiers.MEASURED.read_text(encoding="utf-8") == "a.py::b 1.2\ntruth/d.py::e 5.0\n"


def test_a_slow_function_is_represented_by_its_first_test_where_that_is_short(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(
        tiers, "SECONDS", {"a.py::many": 1.0, "a.py::long": 1.0, "a.py::single": 0.1, "truth/t.py::t": 1.0}
    )
    many, long = [f"a.py::many[{n}]" for n in range(9)], [f"a.py::long[{n}]" for n in range(2)]
    laws = [f"truth/t.py::t[{n}]" for n in range(9)]
    assert representatives([*many, *long, "a.py::single", *laws, "a.py::quick[1]"]) == {"a.py::many[0]"}
