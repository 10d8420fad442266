"""Which files test a module: `python -m tests.support.tests_of triangular`.

Those with its name or that import it, under its package if there are any there. Otherwise those of the modules that
import it, in its own package first, and so on: it is tested through them.
"""

from __future__ import annotations

import re
import sys
from functools import cache
from pathlib import Path

from tests.docs.test_architecture import FILES, imports_of
from tests.support.paths import ROOT

TESTS = ROOT / "tests"
_IMPORT = re.compile(r"^ *from (\S+) import (?:\(([^)]*)\)|(.*))", re.MULTILINE)


@cache
def _imports_of_tests() -> dict[Path, frozenset[str]]:
    return {p: frozenset(_imported(p.read_text(encoding="utf-8"))) for p in sorted(TESTS.rglob("test_*.py"))}


def _imported(text: str) -> set[str]:
    found = set()
    for base, names, others in _IMPORT.findall(text):
        found |= {base, *(f"{base}.{n}" for n in re.findall(r"\w+", names or others))}
    return found


def tests_of(module: str) -> list[Path]:
    """The test files of a module, the nearest ones; none for a package."""
    reached, seen = [module], {module}
    while reached:
        if found := [p for p in _imports_of_tests() if any(_is_about(p, m) for m in reached)]:
            home = [p for p in found if p.parent == named_test(module).parent]
            return sorted(home or found, key=lambda p: (p != named_test(module), p))
        reached = [m for m in FILES if m not in seen and not imports_of(m).isdisjoint(reached)]
        reached = [m for m in reached if m.rpartition(".")[0] == module.rpartition(".")[0]] or reached
        seen |= {*reached}
    return []


def _is_about(test: Path, module: str) -> bool:
    return test == named_test(module) or module in _imports_of_tests()[test]


def named_test(module: str) -> Path:
    """The test file with the name of a module, in the folder that its package has among the tests."""
    if module.endswith(".limits"):
        return TESTS / "docs" / "test_limits.py"
    *folder, name = module.split(".")[1:]
    return (TESTS / "command" if module.startswith("lagsolve") else TESTS).joinpath(*folder, f"test_{name}.py")


def main(name: str) -> None:
    """Prints the test files of every module with this name, or path."""
    wanted = name.removesuffix(".py").replace("/", ".").removeprefix("cli.")
    for module in FILES:
        if f".{module}".endswith(f".{wanted}"):
            print(module, *(f"  {p.relative_to(ROOT)}" for p in tests_of(module)), sep="\n")


if __name__ == "__main__":
    main(sys.argv[1])
