"""docs/python.md and the notebook are true: every block and every cell runs, and says what it says."""

from __future__ import annotations

import ast
import json
import re
from collections.abc import Iterator
from contextlib import redirect_stdout
from io import StringIO
from typing import Any

import pytest

from lagrange.answers.verdicts import Judgement
from lagrange.api.formulation import Formulation
from lagrange.api.result import Result
from tests.support.paths import ROOT

PAGE = (ROOT / "docs" / "python.md").read_text(encoding="utf-8")
NOTEBOOK = json.loads((ROOT / "docs" / "example.ipynb").read_text(encoding="utf-8"))


def ran(code: str, namespace: dict[str, Any], name: str) -> Any:
    """Runs a cell as Jupyter does; what its last line is, where that is an expression."""
    tree = ast.parse(code, name)
    last = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None
    exec(compile(tree, name, "exec"), namespace)
    return eval(compile(ast.Expression(last.value), name, "eval"), namespace) if isinstance(last, ast.Expr) else None


def test_the_page_runs_from_top_to_bottom() -> None:
    blocks = re.findall(r"```python\n(.*?)```", PAGE, re.DOTALL)
    assert len(blocks) >= 8
    namespace: dict[str, Any] = {}
    for n, block in enumerate(blocks):
        printed = StringIO()
        with redirect_stdout(printed):
            exec(compile(block, f"block {n}", "exec"), namespace)
        for (
            line
        ) in block.splitlines():  # `print(x)  # ('theta', "theta'")`: what is printed, where the comment shows it
            shown = re.fullmatch(r"print\(.*?\)\s+# (\(.*\)|Eq\(.*\)|[a-z*]+\(.*\) \+ .*|g\*m.*)", line)
            if shown and "each is zero" not in line:
                assert shown[1] in printed.getvalue()
    assert "(g*sin(theta) + l*theta'',)" in str(namespace["angle"].equations)
    assert "the sign of the term g*sin(theta)" in " ".join(str(namespace["verdict"]).split())


def test_the_page_names_every_field() -> None:
    for kind in (Result, Formulation):
        fields = {n for n, v in vars(kind).items() if not n.startswith("_") and not callable(v)} - {
            "name",
            "problem",
            "notes",
        }
        fields -= {"configuration", "signs"}
        assert {f for f in fields if f"`{f}`" not in PAGE} == set()


def test_links_lead_somewhere() -> None:
    for target in re.findall(r"\]\(([^)#]+)\)", PAGE):
        assert (ROOT / "docs" / target).exists(), target


@pytest.fixture(scope="module")
def shown() -> list[Any]:
    """What each cell of the notebook ends with."""
    return list(_shown())


def _shown() -> Iterator[Any]:
    namespace: dict[str, Any] = {"__name__": "__main__"}
    for cell in NOTEBOOK["cells"]:
        if cell["cell_type"] == "code":
            yield ran("".join(cell["source"]), namespace, cell["id"])


def test_the_notebook_runs(shown: list[Any]) -> None:
    problem, result, angles, tension_formula, mass, equation, verdict, (state, before, after), tension = shown
    assert "Double pendulum" in repr(problem)
    assert isinstance(result, Result)
    assert result._repr_markdown_().startswith("# Double pendulum")
    assert isinstance(angles, Formulation)
    assert angles._repr_markdown_().count(r"\ddot{\phi}") == 2
    assert all("<svg" in shown._repr_html_() for shown in (problem, result, angles))
    assert tension_formula._repr_latex_().startswith("$\\displaystyle T = ")
    assert mass.shape == (2, 2)
    assert "Derivative(phi(t), (t, 2))" in str(equation)
    assert isinstance(verdict, Judgement)
    assert "the sign of the term l*psi'^2*sin(phi - psi)" in " ".join(str(verdict).split())
    assert [*state] == ["phi", "psi", "phi'", "psi'"]
    assert before == pytest.approx(after, rel=1e-7)
    assert tension == pytest.approx(tension)


def test_the_notebook_is_kept_without_outputs() -> None:
    assert NOTEBOOK["nbformat"] == 4
    ids = [cell["id"] for cell in NOTEBOOK["cells"]]
    assert len(set(ids)) == len(ids)
    for cell in NOTEBOOK["cells"]:
        assert cell["cell_type"] in ("markdown", "code")
        if cell["cell_type"] == "code":
            assert (cell["outputs"], cell["execution_count"]) == ([], None)
