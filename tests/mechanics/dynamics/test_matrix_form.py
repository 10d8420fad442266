"""M q'' = f + Aᵀ λ, A q'' = b against Lagrange's equations; matrices as they are printed."""

from __future__ import annotations

import json
import re

import pytest
import sympy as sp
from rich.cells import cell_len

from lagrange.core.diagnostics import Source
from lagrange.core.symbols import VectorSymbol
from lagrange.document.derivation import Derivation, Detail, Matrices, Rule, Step
from lagrange.document.names import Notation
from lagrange.explain.report import report
from lagrange.mechanics.dynamics.lagrangian import lagrange_equations
from lagrange.problem.loader import load, read_problem
from lagrange.render import html, latex, markdown, terminal
from lagrange.render import json as as_json
from tests.support.paths import PROBLEMS
from tests.support.shared import solved

SHIPPED = [
    "chapter6/ex11-ideal-pendulum", "chapter6/ex10-double-pendulum", "motion/sleigh", "motion/spring-pendulum",
    "motion/heavy-top", "motion/coupled-pendulums", "motion/bead-on-rotating-hoop",
]  # fmt: skip


@pytest.mark.parametrize("name", SHIPPED)
def test_the_matrices_are_those_of_lagranges_equations(name: str) -> None:
    """M q'' − f is d/dt ∂T/∂q' − ∂T/∂q − Q at every state, and A q'' − b the derivative of the constraints."""
    solution = solved(name)
    for motion in (solution.own.dynamics, *(c.dynamics for c in solution.choices)):
        assert motion is not None
        form = motion.matrices
        configuration = form.configuration
        slots = configuration.slots
        left = lagrange_equations(configuration).left
        for row, f, expression in zip(form.mass, form.force, left, strict=True):
            inertia = sp.Add(*(m * a for m, a in zip(row, slots.accelerations, strict=True)))
            assert configuration.states.is_zero(inertia - f - expression)
        for row, b, constraint in zip(form.constraint_matrix, form.constraint_vector, configuration.rows, strict=True):
            total = sp.Add(*(a * s for a, s in zip(row, slots.accelerations, strict=True)), -b)
            assert configuration.surface.is_zero(total - slots.time_derivative(constraint.velocity_form(slots)))
        assert not {s for row in form.mass for e in row for s in e.free_symbols} & set(slots.velocities)


def test_the_accelerations_of_a_choice_satisfy_its_equations() -> None:
    solution = solved("chapter6/ex10-double-pendulum")
    [choice] = [c for c in solution.choices if c.dynamics and len(c.dynamics.accelerations) == 2]
    assert choice.dynamics is not None
    rule = dict(choice.dynamics.accelerations)
    for e in choice.dynamics.equations.expressions:
        assert choice.configuration.surface.is_zero(e.xreplace(rule))
        assert choice.configuration.surface.is_zero(e.xreplace({k: v + 1 for k, v in rule.items()})) is False


def test_json_has_the_matrices_in_every_system() -> None:
    found = json.loads(as_json.render([report(load(PROBLEMS / "chapter6/ex11-ideal-pendulum.yaml"))]))
    assert found["mass_matrix"] == [["m", "0"], ["0", "m"]]
    assert found["force_vector"] == ["0", "m*g"]
    assert found["constraint_matrix"] == [["2*x", "2*y"]]
    assert found["constraint_vector"] == ["-2*x'^2 - 2*y'^2"]
    angle = next(c for c in found["choices"] if c["name"] == "angle")
    assert angle["mass_matrix"] == [["m*l^2"]]
    assert angle["force_vector"] == ["-m*g*l*sin(theta)"]
    assert angle["accelerations"] == {"theta": "-g*sin(theta)/l"}


def test_json_of_small_oscillations() -> None:
    found = json.loads(as_json.render([report(load(PROBLEMS / "motion/double-pendulum-small-oscillations.yaml"))]))
    assert [entry["equilibrium"] for entry in found["linearization"]] == [
        ["theta1 = 0", "theta2 = 0"], ["theta1 = 0", "theta2 = pi"],
        ["theta1 = pi", "theta2 = 0"], ["theta1 = pi", "theta2 = pi"],
    ]  # fmt: skip
    assert [entry["stable"] for entry in found["linearization"]] == [True, False, False, False]
    first = found["linearization"][0]
    assert first["mass_matrix"] == [["2*m*l^2", "m*l^2"], ["m*l^2", "m*l^2"]]
    assert first["damping_matrix"] == [["0", "0"], ["0", "0"]]
    assert first["stiffness_matrix"] == [["2*m*g*l", "0"], ["0", "m*g*l"]]
    assert [f["modes"] for f in first["frequencies"]] == [[["1", "sqrt(2)"]], [["1", "-sqrt(2)"]]]
    hoop = json.loads(as_json.render([report(load(PROBLEMS / "motion/bead-on-rotating-hoop.yaml"))]))
    [angle] = hoop["choices"]
    assert len(angle["linearization"][2]["conditions"]) == 1
    assert angle["linearization"][0]["stable"] is None
    assert angle["linearization"][0]["stability"] == "conditional"
    assert len(angle["linearization"][0]["stable_where"]) == 1


def printed(block: Matrices, width: int) -> str:
    derivation = Derivation("T", "", (Step(Rule.EQUATIONS_OF_MOTION, "S", (block,)),))
    return terminal.text(derivation, Notation(), width)


def test_matrices_on_a_terminal() -> None:
    a, b = sp.symbols("a b", real=True)
    rows = ((a, a * b, sp.S.Zero), (a * b, b, sp.S.One), (sp.S.Zero, sp.S.One, -a))
    block = Matrices(((VectorSymbol("M"), rows), (VectorSymbol("f"), ((a,), (b,), (a + b,)))))
    lines = printed(block, 60).splitlines()[-3:]
    assert [line.strip() for line in lines] == [
        "⎛  a   a b  0  ⎞        ⎛   a   ⎞",
        "𝐌 = ⎜ a b   b   1  ⎟    𝐟 = ⎜   b   ⎟",
        "⎝  0    1   −a ⎠        ⎝ a + b ⎠",
    ]
    narrow = printed(block, 34)
    assert narrow.index("𝐌 = ") < narrow.index("𝐟 = ")
    assert all(cell_len(line) <= 34 for line in narrow.splitlines())


def test_a_matrix_that_is_too_wide_is_written_entry_by_entry() -> None:
    long = sp.Add(*sp.symbols("a1:9", real=True))
    block = Matrices(((VectorSymbol("M"), ((long, sp.S.Zero), (sp.S.Zero, long))),))
    text = printed(block, 60)
    assert "𝐌₁₁ = a₁" in text
    assert "𝐌₂₂ = a₁" in text
    assert "The other entries of 𝐌 are zero." in text.replace("\n", " ")
    assert "⎛" not in text
    assert all(cell_len(line) <= 60 for line in text.splitlines())
    derivation = Derivation("T", "", (Step(Rule.EQUATIONS_OF_MOTION, "S", (block,)),))
    code = latex.render([(derivation, Notation())])
    assert "pmatrix" not in code
    assert r"\mathbf{M}_{11}" in code
    assert "The other entries of" in code


def test_matrices_in_markdown_and_on_web_pages() -> None:
    a, b = sp.symbols("a b", real=True)
    named = ((VectorSymbol("M"), ((a, b), (b, a))), (VectorSymbol("f"), ((a,), (sp.S.Zero,))))
    found = Derivation("T", "", (Step(Rule.EQUATIONS_OF_MOTION, "S", (Matrices(named),)),))
    assert r"\begin{pmatrix} a & b \\ b & a \end{pmatrix}" in markdown.render([(found, Notation())])
    page = html.render([(found, Notation())])
    assert page.count("<mtr>") == 4
    assert page.count("<mtd>") == 6
    long = sp.Add(*sp.symbols("a1:20", real=True))
    wide = Derivation("T", "", (Step(Rule.EQUATIONS_OF_MOTION, "S", (Matrices(((named[0][0], ((long, b),) * 2),)),)),))
    assert "<mtd>" not in html.render([(wide, Notation())])
    assert "pmatrix" not in markdown.render([(wide, Notation())])


def test_one_row_stands_in_round_brackets() -> None:
    a = sp.Symbol("a", real=True)
    assert "𝐌 = ( a  0 )" in printed(Matrices(((VectorSymbol("M"), ((a, sp.S.Zero),)),)), 60)


def test_full_detail_shows_the_matrix_form() -> None:
    found = report(read_problem(Source("p", (PROBLEMS / "motion/spring-pendulum.yaml").read_text(encoding="utf-8"))))
    full = terminal.text(found.derivation, found.notation, 60, Detail.FULL)
    usual = terminal.text(found.derivation, found.notation, 60)
    assert "In matrix form" in full
    assert "In matrix form" not in usual
    assert re.search(r"⎛ m +0 +⎞", full)
    assert all(cell_len(line) <= 60 for line in full.splitlines())
    assert r"\begin{pmatrix}" in latex.render([(found.derivation, found.notation)], detail=Detail.FULL)
