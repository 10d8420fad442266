"""Of SymPy only what a derivation needs, until more is asked for: a tenth of the time of a short run.

Only the process of the command calls this: `import lagrange`, and the processes that grade, import SymPy as it is.
"""

from __future__ import annotations

import builtins
import os
import sys
from contextlib import nullcontext
from functools import partial
from importlib import import_module
from importlib.machinery import ModuleSpec, PathFinder
from types import ModuleType
from typing import Any

TENSORS = "sympy.tensor.tensor"


def import_a_part_of_sympy() -> None:
    """Has `import sympy` import a part of it, from now on in this process."""
    leave_tensors_out()
    sys.meta_path.insert(0, PartOfSymPy())


def leave_tensors_out() -> None:
    """Spares `sympy.tensor.tensor` and `sympy.combinatorics`, a thirtieth of a short run.

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


class PartOfSymPy:
    """A finder of modules that imports of SymPy what most derivations need, and the rest as soon as it is asked for.

    SymPy's own initializer runs, but passes over the packages that those in `FIRST` have not imported by then (series,
    sums, integrals, solvers, geometry, plots). A name of theirs that is looked up in `sympy`, or the import of a
    further module, has the initializer run again and in full: whoever needs what first, SymPy is imported in its own
    order, on which its modules depend. Only those in `BY_THEMSELVES` are imported without the rest. What the modules
    ask of one another differs from version to version: other versions than `TRIED` are imported as they are.
    """

    TRIED = ("1.13", "1.14")
    FIRST = ("core", "core.cache", "release", "logic", "assumptions", "polys")
    STAND_INS = {  # noqa: RUF012, a constant, as the next
        "calculus": ("AccumBounds", "AccumulationBounds"),
        "calculus.accumulationbounds": ("AccumBounds", "AccumulationBounds"),
        "concrete.products": ("Product",),
        "concrete.summations": ("Sum",),
        "integrals.integrals": ("Integral",),
        "sets.setexpr": ("SetExpr",),
        "simplify": (),
        "simplify.simplify": (),
    }
    BY_THEMSELVES = {  # noqa: RUF012
        "assumptions.wrapper": (),
        "printing.str": ("sstr",),
        "simplify.fu": (),
        "simplify.powsimp": ("powdenest", "powsimp"),
        "simplify.radsimp": ("collect", "denom", "fraction", "numer", "radsimp"),
        "simplify.sqrtdenest": ("sqrtdenest",),
    }

    def __init__(self) -> None:
        self.loader: Any = None  # SymPy's own
        self.module: ModuleType | None = None  # SymPy, as long as only a part of it has been imported
        self.placed: list[str] = []  # the stand-ins
        self.replaced: dict[str, dict[str, Any]] = {}  # what those had that have made room

    def find_spec(self, name: str, path: Any = None, target: Any = None) -> ModuleSpec | None:
        """How SymPy is imported; everything of it, where a module is asked for that has not been."""
        if name == "sympy":
            spec = PathFinder.find_spec(name, path, target)
            if spec is not None and spec.loader is not None:
                self.loader, spec.loader = spec.loader, self  # type: ignore[assignment]
            return spec
        if self.module is None or not name.startswith("sympy.") or name[6:] in self.BY_THEMSELVES:
            return None
        self.complete()
        return ModuleSpec(name, _Imported(sys.modules[name])) if name in sys.modules else None  # type: ignore[arg-type]

    def create_module(self, spec: ModuleSpec) -> ModuleType | None:  # noqa: ARG002
        """None: a module as usual."""
        return None

    def exec_module(self, module: ModuleType) -> None:
        """Runs SymPy's initializer without what is not needed at first."""
        module.__loader__ = self.loader
        if module.__spec__:
            module.__spec__.loader = self.loader
        if not import_module("sympy.release").__version__.startswith(self.TRIED):
            self._run_in_full(module)
            return
        self._stand_in("printing")
        module.__dict__["__builtins__"] = vars(builtins) | {"__import__": self._imported}
        try:
            self.loader.exec_module(module)
        except ImportError:  # a SymPy that is built otherwise
            for name in [n for n in sys.modules if n.startswith("sympy.") and n != TENSORS]:
                del sys.modules[name]
            self._run_in_full(module)
            return
        for name in [n for n, value in vars(module).items() if value is _MISSING]:
            delattr(module, name)
        module.__dict__.update(__builtins__=builtins, __getattr__=self._name)
        self.module = module

    def _imported(self, name: str, *rest: Any) -> Any:
        """What the initializer imports: `from .series import ...` has the level 1 at the end."""
        passed_over = name not in self.FIRST and (f"sympy.{name}" not in sys.modules or f"sympy.{name}" in self.placed)
        if rest[-1] != 1 or not passed_over:
            return import_module(f".{name}" if rest[-1] else name, "sympy")
        for stand_in in self.STAND_INS:
            self._stand_in(stand_in, *self.STAND_INS[stand_in])
        return _MISSING

    def _stand_in(self, name: str, *classes: str) -> None:
        """Puts a module in place of one that SymPy asks for classes only to find that nothing belongs to them."""
        full_name = f"sympy.{name}"
        if full_name in sys.modules:
            return
        module: Any = ModuleType(full_name)
        if "." not in name:
            module.__path__ = [os.path.join(path, name) for path in sys.modules["sympy"].__path__]
        for each in classes:
            setattr(module, each, _Unmade(each, (), {"home": partial(self._in_full, full_name)}))
        if name == "simplify.simplify":
            module.signsimp = self._with_signs
        module.__getattr__ = partial(self._attribute, full_name)
        sys.modules[full_name] = module
        self.placed.append(full_name)

    def _attribute(self, module: str, name: str) -> Any:
        """A name of a module that has a stand-in; the import system itself asks for `__path__`."""
        if name.startswith("__"):
            raise AttributeError(name)
        return self._found_by_itself(name) or getattr(self._in_full(module), name)

    def _name(self, name: str) -> Any:
        """A name that `sympy` does not have yet."""
        if name == "Integral":  # of which it is asked whether something is one
            return getattr(sys.modules["sympy.integrals.integrals"], name)
        module = self.module
        if name.startswith("__") or module is None:
            raise AttributeError(f"module 'sympy' has no attribute {name!r}")
        found = self._found_by_itself(name)
        if found:
            setattr(module, name, found)
            return found
        self.complete()
        return getattr(module, name)

    def _found_by_itself(self, name: str) -> Any:
        home = next((module for module, names in self.BY_THEMSELVES.items() if name in names), None)
        return getattr(import_module(f"sympy.{home}"), name) if home else None

    def _with_signs(self, expression: Any, evaluate: Any = None) -> Any:
        """SymPy's `signsimp`, which every absolute value calls; a symbol or a number it leaves as it is."""
        if getattr(expression, "is_Atom", False):
            return expression
        return self._in_full("sympy.simplify.simplify").signsimp(expression, evaluate)

    def _in_full(self, name: str) -> Any:
        if self.module is not None:
            self.complete()
        elif name in self.placed:  # SymPy itself needs more of it, while it is imported
            self.placed.remove(name)
            del sys.modules[name]
        return import_module(name)

    def complete(self) -> None:
        """Imports the rest of SymPy, which is no work for the problem at hand.

        Where that ends with an exception, because time or memory is used up, the next name that is asked for has it
        continue.
        """
        module, self.module = self.module, None
        assert module is not None
        for name in self.placed:
            self.replaced.setdefault(name, vars(sys.modules.pop(name)))
        self.placed = []
        allowed = getattr(sys.modules.get("lagrange.core.effort"), "allowed", None)
        try:
            with allowed(float("inf")) if allowed else nullcontext():
                self._run_in_full(module)
                for name, attributes in self.replaced.items():  # modules that had been imported by themselves
                    for attribute, value in attributes.items():
                        if isinstance(value, ModuleType):
                            vars(import_module(name)).setdefault(attribute, value)
        except BaseException:
            self.module = module
            raise
        del module.__dict__["__getattr__"]
        sys.meta_path[:] = [finder for finder in sys.meta_path if finder is not self]

    def _run_in_full(self, module: ModuleType) -> None:
        module.__dict__["__builtins__"] = builtins
        self.loader.exec_module(module)


class _Missing:
    """What is imported from a package that is passed over."""

    def __getattr__(self, name: str) -> _Missing:
        return self


_MISSING = _Missing()


class _Unmade(type):
    """A class to which nothing belongs yet: whatever is done with it is done with SymPy's own."""

    home: Any

    def __call__(cls, *args: Any, **named: Any) -> Any:
        return getattr(cls.home(), cls.__name__)(*args, **named)

    def __getattr__(cls, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        return getattr(getattr(cls.home(), cls.__name__), name)


class _Imported:
    """The loader of a module that has been imported while it was looked for."""

    def __init__(self, module: ModuleType) -> None:
        self.module, self.spec = module, module.__spec__

    def create_module(self, spec: ModuleSpec) -> ModuleType:  # noqa: ARG002
        """The module as it is."""
        return self.module

    def exec_module(self, module: ModuleType) -> None:
        """Nothing is left to be done."""
        module.__spec__ = self.spec
