"""CONTRIBUTING.md names what is there: files, targets, functions."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from tests.support.paths import ROOT

PAGE = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
IN_EXAMPLES = {"mass_centre", "outline", "test_outline", "name-in-words"}
FILES = sorted({f for f in re.findall(r"`([\w/.-]+\.(?:py|yaml|md))`", PAGE) if Path(f).stem not in IN_EXAMPLES})
FOLDERS = [ROOT, ROOT / "lagrange"]


def text_of(name: str) -> str:
    [path] = [f / name for f in FOLDERS if (f / name).is_file()]
    return path.read_text(encoding="utf-8")


@pytest.mark.parametrize("name", [f for f in FILES if f != "problems/index.yaml"])
def test_files_are_there(name: str) -> None:
    assert text_of(name)


def test_links_lead_somewhere() -> None:
    for target in re.findall(r"\]\(([^)#]+)\)", PAGE):
        assert (ROOT / target).exists(), target


def test_targets_are_there() -> None:
    made = re.findall(r"^make (\w+)", PAGE, re.MULTILINE)
    assert len(made) == 10
    for target in made:
        assert re.search(rf"^{target}:", text_of("Makefile"), re.MULTILINE)


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("cli/lagsolve/main.py", "FORMATS ="),
        ("cli/lagsolve/output.py", "ENDINGS ="),
        ("cli/lagsolve/output.py", "def _text("),
        ("tests/golden/test_golden.py", "FORMATS ="),
        ("tests/golden/test_golden.py", "PAGES ="),
        ("tests/truth/shipped_systems.py", "SHIPPED:"),
        ("lagrange/explain/report.py", "def _steps("),
        ("lagrange/render/json.py", "def as_object("),
        ("lagrange/document/derivation.py", "class Rule("),
        ("lagrange/mechanics/results.py", "class InCoordinates:"),
        ("lagrange/problem/model.py", "Force ="),
        ("lagrange/problem/keys.py", "FORCES ="),
        ("lagrange/problem/forces.py", "_READERS:"),
        ("lagrange/mechanics/constraints/definedness.py", "def _of_force("),
        ("lagrange/problem/values.py", "def _places("),
        ("lagrange/mechanics/equilibrium/checks.py", "def _forces("),
        ("lagrange/render/selection.py", "class Emitter("),
        ("lagrange/render/selection.py", "def block_lines("),
        ("lagrange/mechanics/constraints/kinematics.py", "class Load:"),
        ("lagrange/mechanics/constraints/kinematics.py", "class Torque:"),
        ("tests/support/second_route.py", "def newton("),
        ("tests/support/second_route.py", "def kane("),
        ("tests/support/second_route.py", "def lagrange("),
        ("tests/support/second_route.py", "def literature("),
    ],
)
def test_what_is_to_be_changed_is_there(name: str, words: str) -> None:
    assert words in text_of(name)
    assert re.findall(r"\w+", words)[-1] in PAGE
