"""Constraints with quasi-coordinates: why partial derivatives say nothing of them, and what they are."""

from __future__ import annotations

import sympy as sp

from lagrange.core.symbols import Wedge, differential
from lagrange.document.derivation import Block, Part, Ref, Term, listed, math, prose
from lagrange.mechanics.constraints.constraints import ConstraintAnalysis


def explain_quasi(c: ConstraintAnalysis, letter: str, *, likewise: bool) -> list[Block]:
    """A form with quasi-coordinates, which is judged in angles; `likewise`: it has been said why."""
    one = len(c.quasi) == 1
    names, form, label = listed(math(q) for q in c.quasi), sp.Symbol(letter, real=True), Ref(f"form-{c.row.name}")
    stands = " stands the differential of " if one else " stand the differentials of "
    if likewise:
        words: list[Part] = ["In ", label, stands, *names,
                             ", a quasi-coordinate too" if one else ", quasi-coordinates too"]  # fmt: skip
        if c.integrable is None:
            return [prose(*words, ", and whether it is integrable could not be decided.")]
        return [prose(*words, ": written in angles, it is ", "integrable." if c.integrable else "not integrable.")]
    words = [
        "In ", label, stands, *names,
        ", a quasi-coordinate: a component" if one else ", quasi-coordinates: components",
        " of an angular velocity, integrated over time, that tell" if not one else
        " of an angular velocity, integrated over time, that tells",
        " of no position. So the partial derivatives of its coefficients do not say whether it is integrable. ",
    ]  # fmt: skip
    if c.integrable is None:
        return [prose(*words, "That could not be decided.")]
    product = Wedge(form, differential(form))
    end: list[Part] = (
        [math(product, sp.S.Zero), ": it comes to a finite relation."]
        if c.integrable
        else [math(product, sp.S.Zero, relation="≠"), ": it is ", Term("not integrable"), "."]
    )
    angles = "Written in angles that determine how the body is turned, this form, called "
    return [prose(*words, angles, math(form), ", has ", *end)]
