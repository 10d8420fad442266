"""Every equation that is printed as plain text or in LaTeX can be read again, and those that name vectors say what is true."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.answers.equations import Verdict
from lagrange.answers.references import reference_of_solution
from lagrange.answers.submissions import equations_in_file
from lagrange.answers.written.names import printed_names
from lagrange.answers.written.notation.latex import rewritten_latex
from lagrange.core.diagnostics import Fragment, ProblemError, Source
from lagrange.core.symbols import differential, t, variation
from lagrange.core.vectors import Vector
from lagrange.document.derivation import Display, Mathematics
from lagrange.document.math_writer import latex
from lagrange.document.math_writer import text as plain_text
from lagrange.explain.report import Report, report
from lagrange.expressions.latex_layout import piece
from lagrange.expressions.reader import EquationRead, Scope, read_equation
from lagrange.mechanics.rewriting.factors import SIGN_OF_ROOT
from lagrange.mechanics.supports import supports
from lagrange.problem.loader import load
from lagrange.render.json import as_object
from lagrange.render.latex import body
from tests.support.printed_equations import equations_in, unreadable
from tests.support.shared import SHIPPED, reported


@pytest.fixture(scope="module", params=SHIPPED)
def solved(request: pytest.FixtureRequest) -> Report:
    return reported(request.param)


def read(text: str, result: Report) -> EquationRead:
    return read_equation(Fragment.of(text), _scope(result))


def _scope(result: Report) -> Scope:
    """Made once for all equations of a problem."""
    if result is not _last[0]:
        _last[:] = result, reference_of_solution(result.solution).scope
    scope: Scope = _last[1]
    return scope


_last: list[Any] = [None, None]


def holds(text: str, result: Report, carried: bool = False) -> bool:
    """Whether an equation between vectors is an identity; with `carried`, for dq = δq + w dt."""
    equation = read(text, result)
    assert isinstance(equation.lhs, Vector)
    assert isinstance(equation.rhs, Vector)
    difference = equation.lhs - equation.rhs
    if carried:
        solution = result.solution
        rates = zip(solution.problem.slots.coordinates, solution.transport_rates, strict=True)
        difference = difference.xreplace({differential(q): variation(q) + w * differential(t) for q, w in rates})
    return all(is_zero(c) is True for c in difference.components)


def test_it_passes_its_own_checks_and_agrees_with_its_answers(solved: Report) -> None:
    assert [c.name for c in solved.solution.checks if c.passed is not True] == []
    assert [a.name for a in solved.answers if a.verdict is not Verdict.EQUIVALENT] == []
    assert all(c.integrable is not None or not c.pfaffian for c in solved.solution.classification.constraints)
    assert solved.holds, solved.shortcomings


def test_equations_can_be_read_again(solved: Report) -> None:
    found = as_object(solved)
    texts = list(equations_in(found))
    assert len(texts) > 3
    reference = reference_of_solution(solved.solution)
    abbreviations = {name: sp.Symbol(name, real=True) for name in found.get("definitions", ())}
    sign = {SIGN_OF_ROOT.name: SIGN_OF_ROOT}  # of two roots in one line, which says what it is
    scope = replace(reference.scope, scalars={**sign, **reference.scope.scalars, **abbreviations})
    reference = replace(reference, scope=scope)
    faults = [fault for text in texts for fault in unreadable(text, reference)]
    # The constraints of a large system, written out, are longer than any text that is read.
    assert [fault for fault in faults if not (abbreviations and "write it shorter" in fault)] == []


def test_what_cannot_be_read_is_found(solved: Report) -> None:
    reference = reference_of_solution(solved.solution)
    assert unreadable("x = nonsense", reference)
    assert len(unreadable("nonsense = 0 = rubbish", reference)) == 2
    found = {"a": [{"equations": ["1 = 1"]}], "steps": [{"body": [{"equations": [{"text": "2 = 2"}, {"form": "3"}]}]}]}
    assert list(equations_in(found)) == ["1 = 1", "2 = 2"]


def test_positions_forces_and_differentials_are_what_they_are_called(solved: Report) -> None:
    """r_P, F_P, d(r_P) and δr_P have meanings of their own, so these equations are identities."""
    said = [e for s in as_object(solved)["steps"] for b in s["body"] for e in b.get("equations", ())]
    own = {f"{kind}-{p.name}" for p in solved.solution.own.configuration.points for kind in ("position", "force")}
    equations = [e["text"] for e in said if e.get("label") in own or e.get("text", "").startswith("d(r_")]
    points = solved.solution.own.configuration.points
    assert equations or all(p.position.is_zero for p in points)  # of what turns about O nothing else is said
    assert points or not equations
    for text in equations:
        first, *others = text.split(" = ")
        carried = first.startswith("d(r_")
        assert all(holds(f"{first} = {other}", solved, carried) for other in others), text


def in_latex(code: str, result: Report) -> EquationRead:
    whole, scope = Fragment.of(f"{code} = 0"), _scope(result)
    fragment = piece(whole, 0, len(whole.text))
    if any(re.search(rf"{re.escape(f)}'", code) for f in scope.functions):  # f' of one argument, as answers are read
        fragment = rewritten_latex(fragment, scope)
    return read_equation(fragment, scope, latex=True)


def differs(side: Mathematics, result: Report) -> str:
    """What is wrong with one side of an equation, read in LaTeX and as plain text; empty if they mean the same."""
    code = latex(side, result.notation)
    try:
        plain = read(f"{plain_text(side, result.notation)} = 0", result).lhs
    except ProblemError:
        return ""  # forms and their products have no text that is read
    try:
        found = in_latex(code, result).lhs
    except ProblemError as error:
        declared = "d" in result.solution.problem.scope.names() and "`d` is declared" in str(error)
        return "" if declared else f"{code}: {error}"
    if isinstance(found, Vector) and isinstance(plain, Vector):
        return "" if all(is_zero(c) is True for c in (found - plain).components) else code
    if isinstance(found, Vector) or isinstance(plain, Vector):
        return code
    return "" if is_zero(found - plain) is True else code


def test_equations_in_latex_mean_the_same(solved: Report) -> None:
    """Every side of every displayed equation, as it is printed in LaTeX; final equations are among them."""
    equations = [
        e
        for step in solved.derivation.steps
        for block in step.body
        if isinstance(block, Display)
        for e in block.equations
        if e.relation == "="
    ]
    assert len(equations) > 3
    assert [fault for e in equations for side in e.sides if (fault := differs(side, solved))] == []


def test_boxed_equations_of_a_document_can_be_read_again(solved: Report) -> None:
    """From the LaTeX of the whole derivation, as if it were an answer: rows, labels and line breaks too."""
    document = body(solved.derivation, solved.notation)
    boxed = [
        display
        for display in re.findall(
            r"\\begin\{(?:align|equation)\*?\}.*?\\end\{(?:align|equation)\*?\}", document, re.DOTALL
        )
        if "=" in display  # conditions of rest are inequalities
        and (
            "boxed" in display or document[: document.index(display)].rstrip().endswith(r"\vspace{-\abovedisplayskip}")
        )
    ]
    reference = reference_of_solution(solved.solution)
    abbreviations = {"Delta": sp.Symbol("Delta", real=True)} if re.search(r"\\Delta &?= ", document) else {}
    if constant := re.search(r"with a constant \$(\w)\$", document):  # of integration
        abbreviations[constant[1]] = sp.Symbol(constant[1], real=True)
    if borne := supports(solved.solution):  # forces that the page names
        abbreviations |= {f"N_{s.point}": sp.Symbol(f"N_{s.point}", real=True) for s in borne.at}
    spins = [v for name, v in reference.scope.vectors.items() if name.startswith("omega_")]
    named = reference.scope.scalar("omega") is not None  # a parameter or a speed of the file
    turned = {  # the moment on the only body, and its axes, are printed without its name
        re.sub(r"([123])$", r"_\1", name.rpartition("_")[0]): v
        for name, v in reference.scope.vectors.items()
        if len(spins) == 1 and re.match(r"(Gamma|[en][123])_", name)
    }
    scope = replace(
        reference.scope,
        scalars={**printed_names(reference), **abbreviations, **reference.scope.scalars},
        vectors={**({"omega": spins[0]} if len(spins) == 1 and not named else {}), **turned, **reference.scope.vectors},
    )
    for display in boxed:
        rows = equations_in_file(Source("answer.tex", display), ".tex")
        assert rows
        for row in rows:
            # Laws in vectors that name a gradient, or R and δr without a body, are not in the language of problem files.
            if (
                not re.search(r"\\text\{|\\[lg]e(?![a-z])|\\nabla|\\mathbf\{R\}|\\delta \\mathbf\{r\}", row.text)
                and row.text.count("=") == 1
            ):
                read_equation(row, scope, limit=10_000, latex=True)
    moving = solved.solution.own.motion is not None
    assert boxed or not moving


DRIVEN = """\
title: A driven ring
parameters: [R, m]
functions: {u: [t]}
coordinates: [r, phi]
frame: {type: polar, coordinates: [r, phi]}
particles: {P: {mass: m, position: r*e_r + (u + R*t)*k}}
"""


def test_differentials_of_vectors(tmp_path: Path) -> None:
    (tmp_path / "ring.yaml").write_text(DRIVEN, encoding="utf-8")
    result = report(load(tmp_path / "ring.yaml"))
    assert holds("delta(r_P) = delta(r)*e_r + r*delta(phi)*e_phi", result)
    assert holds("d(r_P) = d(r)*e_r + r*d(phi)*e_phi + (u' + R)*d(t)*k", result)
    assert holds("delta(r_P - 2*r_P) = -delta(r_P)", result)
    assert not holds("d(r_P) = delta(r_P)", result)
    product = read("dot(m*r_P'', d(r_P)) = 0", result).lhs
    assert isinstance(product, sp.Expr)
    assert product.has(differential(t))
    with pytest.raises(ProblemError, match="is not declared"):
        read("delta(r_Q) = 0", result)


def test_a_name_of_the_file_keeps_its_meaning(tmp_path: Path) -> None:
    text = DRIVEN.replace("[R, m]", "[R, m, F_P]") + "gravity: R*k\n"
    (tmp_path / "ring.yaml").write_text(text, encoding="utf-8")
    result = report(load(tmp_path / "ring.yaml"))
    [declared] = (p.symbol for p in result.solution.problem.parameters if p.symbol.name == "F_P")
    assert read("F_P = 0", result).lhs == declared


def test_the_differential_of_an_abbreviation(tmp_path: Path) -> None:
    """V is the given potential energy, in the derivation and when it is read again: δV = m R r δr + sin φ δφ."""
    text = DRIVEN + "forces: {field: {potential: m*R*r^2/2 - cos(phi)}}\n"
    (tmp_path / "ring.yaml").write_text(text, encoding="utf-8")
    result = report(load(tmp_path / "ring.yaml"))
    identity = read("delta(V) = m*R*r*delta(r) + sin(phi)*delta(phi)", result)
    assert is_zero(identity.lhs - identity.rhs)
    assert is_zero(read("d(V) = m*R*r*delta(r)", result).lhs) is False
    with pytest.raises(ProblemError):
        read("delta(m) = 0", result)
