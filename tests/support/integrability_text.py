"""The prose of a derivation on the integrability of constraints between x, y and z."""

from __future__ import annotations

from collections.abc import Callable

from lagrange.explain.report import report
from lagrange.problem.model import Problem
from lagrange.render.json import as_object

HEAD = "title: T\nparameters: [a, k, omega, l]\ncoordinates: [x, y, z]\nfind: constraints\nconstraints: "


def words(problem: Callable[[str], Problem], text: str) -> str:
    step = next(s for s in as_object(report(problem(HEAD + text)))["steps"] if s["rule"] == "integrability")
    lines = []
    for block in step["body"]:
        lines.append(block.get("prose") or " ".join(e.get("text", "") for e in block["equations"]))
    return "\n".join(lines)
