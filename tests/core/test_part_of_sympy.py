"""SymPy without its tensors: that they are not imported, and that nobody notices who asks for them."""

from __future__ import annotations

import subprocess
import sys

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
