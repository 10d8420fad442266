"""What a notebook shows: problems, results, one set of coordinates, and equations, as formulas with their figure.

Jupyter asks an object for HTML and for TeX (`_repr_html_`, `_repr_latex_`). The HTML is that of a web page, without
scripts; every text of a file is escaped.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import Any

import sympy as sp

from lagrange.core.diagnostics import ProblemError
from lagrange.core.mime import Shown
from lagrange.core.records import record
from lagrange.core.vectors import Vector
from lagrange.document.derivation import (
    Block,
    Derivation,
    Detail,
    Equation,
    Mathematics,
    Picture,
    Rule,
    Step,
    display,
    prose,
)
from lagrange.document.math_writer import LATEX, Notation, Writer
from lagrange.explain.report import report
from lagrange.explain.words import plural, spoken
from lagrange.problem.model import Find, Problem
from lagrange.render.html import cell


class Equations(Shown, tuple[Any, ...]):
    """Equations, a tuple that a notebook shows as formulas: SymPy's `Eq`s, and expressions that vanish."""

    notation: Notation

    def __new__(cls, members: Iterable[Any], notation: Notation) -> Equations:
        """The equations, and how their symbols are written."""
        made = super().__new__(cls, members)
        made.notation = notation
        return made

    def __getnewargs__(self) -> tuple[tuple[Any, ...], Notation]:
        """The arguments from which a copy is made."""
        return tuple(self), self.notation

    def _repr_html_(self) -> str | None:
        return in_html((display(*map(equation_of, self)),), self.notation) if self else None

    def _repr_latex_(self) -> str | None:
        return in_latex([equation_of(e).sides for e in self], self.notation) if self else None


@record
class Formula(Shown):
    """a = b = c in the notation of a problem; a notebook shows it, `str` is its LaTeX.

    sides     expressions or vectors
    notation  how symbols are written
    """

    sides: tuple[Mathematics, ...]
    notation: Notation

    def __str__(self) -> str:
        return Writer(LATEX, self.notation).relation(self.sides, "=")

    def __repr__(self) -> str:
        return f"<Formula {self}>"

    def _repr_html_(self) -> str:
        return in_html((display(Equation(self.sides)),), self.notation)

    def _repr_latex_(self) -> str:
        return in_latex([self.sides], self.notation)


def formula(sides: Sequence[object], notation: Notation) -> Formula:
    """A formula of expressions, vectors, numbers or one `Eq`. Raises TypeError at anything else."""
    if len(sides) == 1 and isinstance(sides[0], sp.Equality):
        sides = sides[0].args
    if not sides:
        raise TypeError("a formula has at least one side")
    return Formula(tuple(map(_side, sides)), notation)


def _side(value: object) -> Mathematics:
    if isinstance(value, Vector):
        return value
    if isinstance(value, sp.Expr | int | float) and not isinstance(value, bool):
        return sp.sympify(value, strict=True)
    raise TypeError(f"a side of a formula is an expression, a vector or a number, and not {type(value).__name__}")


def equation_of(member: Any) -> Equation:
    """An `Eq`, or an expression that vanishes, as a displayed equation."""
    return Equation((member.lhs, member.rhs) if isinstance(member, sp.Equality) else (member, sp.S.Zero))


def in_latex(rows: Sequence[Sequence[Mathematics]], notation: Notation) -> str:
    """Equations as one formula of TeX, aligned where there are several."""
    codes = [Writer(LATEX, notation).relation(sides, "=") for sides in rows]
    if len(codes) == 1:
        return rf"$\displaystyle {codes[0]}$"
    aligned = " \\\\\n".join(code.replace(" = ", " &= ", 1) for code in codes)
    return f"$\\displaystyle \\begin{{aligned}}\n{aligned}\n\\end{{aligned}}$"


def in_html(blocks: Sequence[Block], notation: Notation, title: str = "") -> str:
    """A few blocks as the output of a cell."""
    return cell(Derivation(title, "", (Step(Rule.STATEMENT, "", tuple(blocks)),)), notation)


def problem_in_html(problem: Problem) -> str:
    """The statement of a problem, with the figure of the system; its heading alone where that cannot be worked out.

    Only the constraints are solved: neither equations of motion nor equilibria.
    """
    asked = replace(problem, find=(Find.CONSTRAINTS,), questions=(), initial=(), speeds=(), answers=None)
    try:
        shown = report(asked, complete=False)
        [statement] = [s for s in shown.derivation.at(Detail.STEPS) if s.rule is Rule.STATEMENT]
    except (ProblemError, ValueError):
        described = (prose(problem.description),) if problem.description else (prose(repr(problem)),)
        return in_html(described, Notation(), problem.title)
    constraints = [
        Equation(((c.given or c).lhs, (c.given or c).rhs), None, c.relation, (f"({spoken(c.name)})",))
        for c in problem.constraints
    ]
    named = plural(len(constraints), "The constraint is", "The constraints are")
    more = (prose(named), display(*constraints)) if constraints else ()
    steps = (replace(statement, title="", body=(*statement.body, *more)),)
    return cell(Derivation(problem.title, problem.source, steps), shown.notation)


def figure_of(derivation: Derivation, choice: str) -> Picture | None:
    """The picture of the system in a choice of coordinates; the picture for the file's own if it has none."""
    pictures: dict[str, Picture] = {}
    for step in derivation.steps:
        if step.rule in (Rule.STATEMENT, Rule.GENERALIZED_COORDINATES):
            for block in step.body:
                if isinstance(block, Picture) and block.draw() is not None:
                    pictures.setdefault(step.choice, block)
    return pictures.get(choice, pictures.get(""))


def coordinates_in_html(
    title: str,
    notation: Notation,
    substitution: Iterable[tuple[sp.Symbol, sp.Expr]],
    equations: Sequence[Equation],
    figure: Picture | None,
) -> str:
    """One set of coordinates: the figure, what they replace, the equations."""
    blocks: list[Block] = [figure] if figure is not None else []
    replaced = [Equation((q, e)) for q, e in substitution]
    blocks += [prose("The coordinates of the file are"), display(*replaced)] if replaced else []
    blocks += [display(*equations, boxed=True)] if equations else []
    return in_html(blocks, notation, title)
