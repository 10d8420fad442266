"""SymPy in part: what is imported, and that nobody notices who asks for more."""

from __future__ import annotations

import os
import subprocess
import sys

import pytest

from tests.support.paths import ROOT
from tests.support.processes import PATIENCE


def test_tensors_are_imported_only_when_needed() -> None:
    """The first sum would import them, and `sympy.combinatorics` with them."""
    program_text = """
import sys
from lagrange.core.part_of_sympy import leave_tensors_out
leave_tensors_out()
import sympy
assert sympy.Symbol("x") + 1 != 0 and "sympy.combinatorics" not in sys.modules
from sympy.tensor.tensor import TensorHead, TensorIndexType, tensor_indices
kind = TensorIndexType("L")
a = TensorHead("A", [kind])(tensor_indices("i", kind))
print(a + a)
"""
    done = subprocess.run([sys.executable, "-c", program_text], capture_output=True, timeout=PATIENCE, check=False)
    assert done.stdout.strip() == b"2*A(i)", done.stderr


def run_with_a_part_of_sympy(program_text: str) -> bytes:
    start = """
import sys
from lagrange.core.part_of_sympy import PartOfSymPy, import_a_part_of_sympy
import_a_part_of_sympy()
"""
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(map(str, (ROOT, ROOT / "cli")))}
    called = [sys.executable, "-c", start + program_text]
    done = subprocess.run(called, env=environment, capture_output=True, timeout=PATIENCE, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout.strip()


def test_a_short_solve_imports_a_part_of_sympy_only() -> None:
    program_text = """
from lagsolve.main import main
try:
    main(["ex18"])
finally:
    print(*[n for n in ("series", "solvers", "geometry", "printing.latex") if "sympy." + n in sys.modules], "in part")
"""
    assert run_with_a_part_of_sympy(program_text).endswith(b"\nin part")


@pytest.mark.parametrize(
    ("asked_for", "printed"),
    [
        ("sp.integrate(x, x)", "x**2/2"),
        ("sp.Sum(x, (x, 1, 3)).evalf()", "6.00000000000000"),
        ("sp.Integral(x, (x, 0, 1)).n()", "0.500000000000000"),
        ("sp.sin(sp.oo)", "AccumBounds(-1, 1)"),
        ("sp.simplify(sp.sin(x)**2 + sp.cos(x)**2)", "1"),
        ("sp.fraction(x/2)", "(x, 2)"),
        ("sp.latex(sp.sqrt(x))", r"\sqrt{x}"),
        ("sp.Abs(-x**2 - 1)", "Abs(x**2 + 1)"),
        ("sp.plotting.__name__", "sympy.plotting"),
        ("__import__('sympy.solvers.inequalities').solve(x - 1, x)", "[1]"),
        ("__import__('sympy.stats').stats.Die('D', 6).symbol", "D"),
        ("isinstance(sp.Integral(x, x), sp.Integral) and not isinstance(x, sp.Integral)", "True"),
        ("[n for n in sp.__all__ if not hasattr(sp, n)]", "[]"),
    ],
)
def test_the_rest_of_sympy_is_there_when_it_is_asked_for(asked_for: str, printed: str) -> None:
    """As in a process that imports all of it, and evaluates with the same classes."""
    program_text = f"import sympy as sp\nx = sp.Symbol('x')\nassert (x + 1)**2 != x\nprint({asked_for})"
    assert run_with_a_part_of_sympy(program_text).decode() == printed


def test_what_is_kept_from_a_part_of_sympy_is_of_the_whole() -> None:
    program_text = """
import sympy as sp
x = sp.Symbol("x")
fraction, kept, number = sp.fraction, sp.powsimp, sp.pi.evalf(5)
module = sys.modules["sympy.simplify"]
assert "sympy.series" not in sys.modules
sp.solve(x, x)
assert fraction is sp.fraction is module.fraction and kept is sp.powsimp and "sympy.series" in sys.modules
assert sys.modules["sympy.simplify"] is not module and sys.modules["sympy.simplify"].cse_main
assert sp.Integral is sys.modules["sympy.integrals.integrals"].Integral
assert sp.Integral in sys.modules["sympy.core.evalf"].evalf_table
"""
    run_with_a_part_of_sympy(program_text)


@pytest.mark.parametrize("missing", ["sympy.solvers.solveset", "sympy.printing.rcode"])
def test_an_interrupted_import_of_the_rest_is_continued(missing: str) -> None:
    """When time or memory is used up meanwhile, what was found is printed, and may need more of SymPy."""
    program_text = f"""
import sympy as sp
x = sp.Symbol("x")
class Full:
    def find_spec(self, name, path=None, target=None):
        if name == {missing!r}:
            sys.meta_path.remove(self)
            raise MemoryError
sys.meta_path.insert(0, Full())
try:
    sp.solve(x, x)
except MemoryError:
    print(sp.solve(x - 1, x), sp.latex(x), [n for n in sp.__all__ if not hasattr(sp, n)])
"""
    assert run_with_a_part_of_sympy(program_text) == b"[1] x []"


def test_a_version_that_has_not_been_tried_is_imported_as_it_is() -> None:
    program_text = """
PartOfSymPy.TRIED = ("0.7",)
import sympy as sp
assert "sympy.series" in sys.modules
assert not any(hasattr(sys.modules[n], "__getattr__") for n in ("sympy", "sympy.simplify"))
"""
    run_with_a_part_of_sympy(program_text)


def test_no_module_keeps_a_stand_in() -> None:
    """A class of a stand-in would be another than SymPy's, and nothing would ever belong to it."""
    program_text = """
from lagrange.core import part_of_sympy
import sympy as sp
x = sp.Symbol("x")
assert sp.Abs(x - 1) != sp.sqrt(2).evalf() and sp.Matrix([[x, 1], [2, 3]]).det()
sp.solve(x, x)
for name in [n for n in sys.modules if n.startswith("sympy")]:
    for attribute, value in vars(sys.modules[name]).items():
        if isinstance(value, (part_of_sympy._Unmade, part_of_sympy._Missing)):
            print(name, attribute)
"""
    assert run_with_a_part_of_sympy(program_text) == b""
