"""docs/diagnostics.md: every code of the source has an entry, and every example prints what the page says.

`pytest tests/docs/test_diagnostics.py --renew` writes the page anew; read the difference.
"""

from __future__ import annotations

import ast
import re
from pathlib import Path

import pytest
from click.testing import CliRunner

from lagsolve.main import main
from tests.support.diagnostic_examples import EXAMPLES, Checked, Command, File
from tests.support.paths import ROOT

PAGE = ROOT / "docs" / "diagnostics.md"
SOURCES = [*ROOT.glob("lagrange/**/*.py"), *ROOT.glob("cli/**/*.py")]
CODE = re.compile(r"[a-z]+(-[a-z]+)+|tag|axes|negative|inertia|orientation|components|inequality|internal|undecided")
MAKERS = {"Diagnostic", "TooExpensiveError", "add", "error", "_mistake", "_stop", "_error", "fail", "_fail", "note"}
HEAD = """# Diagnostics

Every finding has a code, a sentence, a place, and a way out:

```
error[code]: what is wrong
 --> file:line:column
  |
n | the line
  | ^^^^^ the place
  = help: what to do
```

All mistakes of a file are reported together. Exit status 2, where nothing else is said. The examples below are run by
the tests; equations are answers to `ex11-ideal-pendulum`.
"""


def codes_of_the_source() -> set[str]:
    """The first argument of everything that makes a diagnostic."""
    found = set()
    for path in SOURCES:
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if not isinstance(node, ast.Call) or not node.args:
                continue
            name = node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "")
            first = node.args[0]
            if name in MAKERS and isinstance(first, ast.Constant) and isinstance(first.value, str):
                found |= {first.value} if CODE.fullmatch(first.value) else set()
    return found


def shown(example: str | File | Command, folder: Path) -> str:
    """What the program prints on standard error, or in its verdict."""
    runner = CliRunner(env={"COLUMNS": "80"})
    match example:
        case str():
            result = runner.invoke(main, ["check", "ex11-ideal-pendulum", "-e", example])
            found = re.search(r"^(error|note)\[.*", result.output, re.DOTALL | re.MULTILINE)
            return found[0].strip() if found else result.output
        case Command(arguments=arguments, beside=beside):
            if not beside:
                return runner.invoke(main, list(arguments)).stderr.strip()
            (folder / beside).touch()
            said = runner.invoke(main, list(arguments)).stderr.strip()
            (folder / beside).unlink()
            return said
        case File(text=text):
            path = folder / "problem.yaml"
            path.write_bytes(text if isinstance(text, bytes) else text.encode())
            command = ["check", "problem.yaml"] if isinstance(example, Checked) else ["problem.yaml"]
            return runner.invoke(main, command).stderr.strip()


def short(text: str) -> str:
    return text if len(text) <= 120 else f"{text[:60]} ... ({len(text):,} characters)"


def entry(code: str, printed: str) -> str:
    """The section of the page on a code, of whose example the program prints this."""
    cure, example = EXAMPLES[code]
    lines = [f"## {code}", "", cure, ""]
    match example:
        case None:
            return "\n".join(lines)
        case str():
            lines += ["```", short(example), "```", ""]
        case Command(arguments=arguments):
            lines += ["```", short("lagsolve " + " ".join(arguments)), "```", ""]
        case File(text=str() as text):
            lines += ["```yaml", text.rstrip("\n"), "```", ""] if text else ["(an empty file)", ""]
        case File(text=text):
            lines += ["```", short(repr(text)), "```", ""]
    return "\n".join([*lines, "```", printed, "```", ""])


def sections() -> dict[str, str]:
    """Code -> its section of the page."""
    page = PAGE.read_text(encoding="utf-8")
    assert page.startswith(f"{HEAD}\n## ")
    several = page.removeprefix(f"{HEAD}\n## ").split("\n## ")
    return {s.partition("\n")[0]: f"## {s}" for s in several}


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_every_code_has_an_entry_and_every_entry_a_code() -> None:
    assert codes_of_the_source() <= set(EXAMPLES)
    text = "".join(path.read_text(encoding="utf-8") for path in SOURCES)
    assert [code for code in EXAMPLES if f'"{code}"' not in text] == []


@pytest.mark.parametrize("code", [c for c, (_, example) in sorted(EXAMPLES.items()) if example is not None])
def test_the_example_shows_its_code(code: str, folder: Path, request: pytest.FixtureRequest) -> None:
    """It is on the page together with what is printed."""
    example = EXAMPLES[code][1]
    assert example is not None
    output = shown(example, folder)
    assert f"[{code}]" in output
    assert "Traceback" not in output
    if not request.config.getoption("--renew"):
        assert sections()[code] == entry(code, output)


def test_the_page_has_the_codes_in_their_order(folder: Path, request: pytest.FixtureRequest) -> None:
    """The text under each is compared with what is printed above."""
    if request.config.getoption("--renew"):
        examples = {code: example for code, (_, example) in EXAMPLES.items()}
        entries = (entry(c, shown(e, folder) if (e := examples[c]) is not None else "") for c in sorted(EXAMPLES))
        PAGE.write_text("\n".join([HEAD, *entries]), encoding="utf-8")
    assert [*sections()] == sorted(EXAMPLES)
    for code, (_, example) in EXAMPLES.items():
        assert example is not None or sections()[code] == entry(code, "")
