"""SymPy without its tensors, until somebody asks for them: a twentieth of the time of a short run.

Only the process of the command calls this: `import lagrange`, and the processes that grade, import SymPy as it is.
"""

from __future__ import annotations

import sys
from importlib import import_module
from types import ModuleType
from typing import Any

TENSORS = "sympy.tensor.tensor"


def leave_tensors_out() -> None:
    """Spares `sympy.tensor.tensor` and `sympy.combinatorics`.

    The first sum imports them, only to ask of each term whether it is a tensor, and here none is. Whoever wants more of
    that module than these two names gets the module itself.
    """
    stand_in: Any = ModuleType(TENSORS)
    stand_in.TensExpr, stand_in.TensAdd = (type(n, (), {"__module__": TENSORS}) for n in ("TensExpr", "TensAdd"))

    def wanted(attribute: str) -> object:
        if attribute.startswith("__"):
            raise AttributeError(attribute)
        if sys.modules.get(TENSORS) is stand_in:
            del sys.modules[TENSORS]
        return getattr(import_module(TENSORS), attribute)

    stand_in.__getattr__ = wanted
    sys.modules.setdefault(TENSORS, stand_in)
