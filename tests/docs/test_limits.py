"""Limits stand in one module a package, `limits.py`, each with its reason; so do the numbers of random points of the algebra.

This is the test of every module `limits.py`.
"""

from __future__ import annotations

import ast
import re
from pathlib import Path

import pytest

from tests.support.paths import ROOT

ALGEBRA = ROOT / "lagrange" / "algebra"
PACKAGES = (ROOT / "lagrange", ROOT / "cli" / "lagsolve")
GATHERED = sorted([*(p for k in PACKAGES for p in k.rglob("limits.py")), ALGEBRA / "exact" / "points_needed.py"])
MODULES = sorted(p for k in PACKAGES for p in k.rglob("*.py") if p not in GATHERED)

NO_LIMITS = {
    # what a representation is made of: bits of a packed exponent, the circle of a field, marks
    "exact/expression_graph": {"OPAQUE", "SIGNED"},
    "exact/prime_field": {"M", "_BITS", "_PARTS", "_WINDOW"},
    "forms/jets": {"BITS", "REAL_WEIGHT"},
    "fourier/elements": {"UNIT"},
    "fourier/polynomials": {"LARGEST", "WIDTH"},
    "document/names": {"_BOLD"},
    "document/ordering": {"_END"},
    "questions/frequencies": {"_ZERO"},
    "answers/reference_systems": {"_CONTRADICTION", "_NONE"},
    "render/escape": {"_LATIN"},
    "render/json": {"VERSION"},
    "lagsolve/exit_statuses": {"BROKEN_PIPE", "INTERRUPTED", "OK", "UNDECIDED", "UNREADABLE", "WRONG"},
    # numbers at which something is evaluated
    "questions/checks": {"_PRIMES"},
    "questions/at_rest": {"_PRIMES"},
    "programs/defaults": {"AMPLITUDE", "FREQUENCY", "GRAVITY", "ROLLING_SPIN", "SLOWER", "SPEED", "SPIN"},
    "programs/integrator": {"_LARGEST_FACTOR", "_LEAST_FACTOR", "_ORDER", "_SAFETY"},
    "special/orbits": {"_AXES"},
    # sizes of drawings and of letters
    "document/scene": {"MARGIN"},
    "pictures/blocks": {"BOARD", "HIGH", "WIDE"},
    "implied/body_shapes": {"_NEUTRAL", "_RIM"},
    "implied/directions": {"LENGTH", "_FORESHORTENED"},
    "implied/lengths": {"_SHORTEST"},
    "implied/nested_pulleys": {"_DEPTHS"},
    "implied/rods_at_rest": {"HALF", "INSIDE", "PEG", "_BEYOND"},
    "implied/springs_of_potentials": {"_SHOWN"},
    "implied/turning_guides": {"HALF", "_BEYOND", "_RIM"},
    "pictures/coordinate_drawings": {"ARC"},
    "pictures/free_bodies": {"LARGEST", "LARGEST_WHEEL", "LENGTH"},
    "pictures/bearings": {"_CORNERS", "_SLOT"},
    "pictures/inferred": {"BEARING", "CORNER", "GAP", "LARGE_PULLEY", "PULLEY"},
    "pictures/loads": {"ARROW", "MOMENT", "NOWHERE", "TURN_OF_MOMENT", "_SOMEWHERE"},
    "pictures/poses": {"_ANGLES", "_STEPS"},
    "pictures/sketch": {
        *("APART", "BAR", "CLEAR", "HATCH", "HEIGHT", "HINGE", "LETTER", "NEAR"),
        *("PARTICLE", "SMALL_LETTER", "SPACE", "REACHES"),
    },
    "pictures/solids": {"LIGHT", "MEDIUM"},
    "pictures/springs_dampers": {"COIL"},
    "pictures/surfaces": {"_HALF", "_HALF_PATCH", "_LONG", "_PIECES_OF_PATCH", "_PLACE", "_SHIFT", "_STEPS", "_TURNS"},
    "pictures/system_drawing": {"ELLIPSOID"},
    "pictures/views": {"_DOWN", "_LEFT", "_RIGHT", "_UP"},
    "render/latex": {"LARGE"},
    "render/svg": {"CENTIMETRE", "TIP"},
    "render/frames": {"TALLEST", "WIDEST"},
    # widths of lines and tables, digits that are printed, seconds of a progress line
    "api/classroom": {"WIDTH"},
    "programs/languages": {"WIDTH"},
    "programs/tables": {"DIGITS"},
    "render/terminal": {"COLUMNS", "HEIGHT"},
    "render/terminal_layout": {"COLUMN_GAP", "MATRIX_GAP"},
    "values/quantities": {"DIGITS"},
    "lagsolve/new_file": {"WIDTH"},
    "lagsolve/progress_line": {"PATIENCE", "PERIOD"},
    "lagsolve/shipped": {"INDENT"},
    "lagsolve/simulation_report": {"DIGITS"},
}
"""Numbers that bound nothing, by module."""


def numbers(path: Path) -> dict[str, int]:
    """The constants of a module that are numbers, or tuples of them, with their lines."""
    lines = {}
    for node in ast.parse(path.read_text(encoding="utf-8")).body:
        if isinstance(node, ast.Assign | ast.AnnAssign) and node.value is not None and _is_number(node.value):
            targets = node.targets if isinstance(node, ast.Assign) else [node.target]
            names = [n.id for t in targets for n in ast.walk(t) if isinstance(n, ast.Name)]
            lines |= {name: node.lineno for name in names if name.isupper()}
    return lines


def _is_number(value: ast.expr) -> bool:
    parts = [*ast.walk(value)]
    constants = [n.value for n in parts if isinstance(n, ast.Constant)]
    plain = not any(isinstance(n, ast.Name | ast.Call | ast.Attribute | ast.Dict | ast.Set) for n in parts)
    return plain and bool(constants) and all(type(c) in (int, float) for c in constants)


def name_of(path: Path) -> str:
    return f"{path.parent.name}/{path.stem}"


@pytest.mark.parametrize("path", MODULES, ids=name_of)
def test_no_other_module_has_a_limit(path: Path) -> None:
    assert {*numbers(path)} == NO_LIMITS.get(name_of(path), set())


def test_the_search_for_limits_finds_them(tmp_path: Path) -> None:
    module = tmp_path / "module.py"
    module.write_text("MOST = 3\n_A, _B = 1.5, -2\nC: int = 10**3\nD = f(3)\nE = 2 * C\nF = True\nG = 'a'\nh = 3\n")
    assert numbers(module) == {"MOST": 1, "_A": 2, "_B": 2, "C": 3}


@pytest.mark.parametrize("path", GATHERED, ids=lambda p: p.relative_to(ROOT).as_posix())
def test_every_limit_has_its_reason(path: Path) -> None:
    """A comment above, or a docstring below, for one limit or for several that belong together, with no empty line."""
    lines = path.read_text(encoding="utf-8").splitlines()
    for name, place in numbers(path).items():
        above, below = lines[:place][::-1], [*lines[place - 1 :], ""]
        paragraph = [*above[: above.index("")], *below[: below.index("")]]
        assert any(line.startswith(("#", '"""')) for line in paragraph), name


def test_every_limit_is_used() -> None:
    texts = [p.read_text(encoding="utf-8") for k in PACKAGES for p in k.rglob("*.py") if p not in GATHERED]
    used = {*re.findall(r"\w+", "\n".join(texts))}
    assert [name for path in GATHERED for name in numbers(path) if name not in used] == []
