"""Somebody else's equilibria: are they right, and all of them?

An answer is one system of equations or several, alternatives of one another: nested lists in a file, `theta = 0 or
theta = pi` in one equation. It stands for the positions (and unknown forces) that satisfy one of them. It is tried in
the file's coordinates and in every choice, and the best verdict counts.

The principal value in θ = atan(u) is read as it stands, and where that is not all, as tan θ = u.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import product

import sympy as sp

from lagrange.answers.answer_readings import Reading, read_answer
from lagrange.answers.equations import AnswerVerdict, EquationVerdict, Verdict
from lagrange.answers.equilibrium_comparison import EquilibriumComparison
from lagrange.answers.references import Reference
from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError
from lagrange.expressions.latex_layout import ALTERNATIVE, is_latex, piece
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium

MAX_ALTERNATIVES = 32
MAX_EQUATIONS = 12
_INVERSE: dict[type, Callable[[sp.Expr], sp.Expr]] = {sp.atan: sp.tan, sp.acos: sp.cos, sp.asin: sp.sin}


def alternatives_of(answer: Sequence[Fragment]) -> list[tuple[Fragment, ...]]:
    """The alternatives of a flat list in which an equation may read `theta = 0 or theta = pi`."""
    parts = [_split(f) for f in answer]
    total = 1
    for p in parts:
        total *= len(p)
    if total > MAX_ALTERNATIVES:
        message = f"an answer may have {MAX_ALTERNATIVES} alternatives, and this one has {total}"
        raise ProblemError(Diagnostic("too-many-equations", message, answer[0].whole))
    return [tuple(choice) for choice in product(*parts)]


def _split(fragment: Fragment) -> list[Fragment]:
    latex = is_latex(fragment)
    found, start = [], 0
    for match in [*re.finditer(ALTERNATIVE if latex else r"(?<![\w\\])or(?![\w'])", fragment.text), None]:
        end = match.start() if match else len(fragment.text)
        begin = None if fragment.start is None else fragment.start + start
        text = fragment.text[start:end].strip()
        found.append(piece(fragment, start, end) if latex else replace(fragment, text=text, start=begin))
        start = match.end() if match else end
    return found


def check_equilibria(
    alternatives: Sequence[Sequence[Fragment]], equilibria: Sequence[Equilibrium], reference: Reference
) -> AnswerVerdict:
    """The verdict on an answer; `equilibria` are those in the file's coordinates and in each choice."""
    flat = [f for a in alternatives for f in a]
    if not flat:
        raise ProblemError(
            Diagnostic("no-answer", "there is no equation to check", help="give equations with -e, or in a file")
        )
    if len(alternatives) > MAX_ALTERNATIVES or any(len(a) > MAX_EQUATIONS for a in alternatives):
        message = f"an answer may have {MAX_EQUATIONS} equations"
        raise ProblemError(Diagnostic("too-many-equations", message, flat[0].whole))
    readings = [tuple(read_answer(f, reference.scope) for f in a) for a in alternatives]
    notes = tuple(n for a in readings for r in a for n in r.notes)
    errors = tuple(d for a in readings for r in a if r.error for d in r.error.diagnostics)
    if errors:
        return _unreadable(readings, errors, notes)
    somewhere = [e for e in equilibria if e.branches] or equilibria
    tried = [v for e in somewhere if (v := _tried(readings, e, reference)) is not None]
    if not tried:
        diagnosis = "it mixes coordinates of several choices; use the file's coordinates and those of one choice"
        found = tuple(EquationVerdict(r.text, Verdict.UNREADABLE, diagnosis) for a in readings for r in a)
        return AnswerVerdict(Verdict.UNREADABLE, found, notes=notes)
    return replace(max(tried, key=lambda v: _QUALITY.index(v.verdict)), notes=notes)


_QUALITY = (
    Verdict.UNREADABLE,
    Verdict.WRONG,
    Verdict.UNDECIDED,
    Verdict.TRIVIAL,
    Verdict.INCOMPLETE,
    Verdict.EQUIVALENT,
)


def _unreadable(
    readings: Sequence[Sequence[Reading]], errors: tuple[Diagnostic, ...], notes: tuple[Diagnostic, ...]
) -> AnswerVerdict:
    found = tuple(
        EquationVerdict(
            r.text,
            Verdict.UNREADABLE if r.error else Verdict.UNDECIDED,
            r.error.diagnostics[0].message if r.error else "not judged beside an unreadable equation",
        )
        for a in readings
        for r in a
    )
    return AnswerVerdict(Verdict.UNREADABLE, found, unreadable=errors, notes=notes)


def _tried(
    readings: Sequence[Sequence[Reading]], equilibrium: Equilibrium, reference: Reference
) -> AnswerVerdict | None:
    """The verdict in one set of coordinates; None where the answer uses others."""
    configuration = equilibrium.configuration
    used = {s.name for a in readings for r in a for e in r.components for s in e.free_symbols}
    known = {s.name for s in (*configuration.slots.coordinates, *configuration.expressed)}
    if not used & {q.name for q in reference.scope.slots.coordinates} <= known:
        return None
    values = dict(reference.values)
    systems = [[tuple(configuration.rewritten(e).xreplace(values) for e in r.components) for r in a] for a in readings]
    literal = EquilibriumComparison(equilibrium, values, systems).verdict(readings, systems)
    wider = [[tuple(_widened(e) for e in es) for es in a] for a in systems]
    if literal.verdict is Verdict.EQUIVALENT or wider == systems:
        return literal
    read_wider = EquilibriumComparison(equilibrium, values, wider).verdict(readings, wider)
    if _QUALITY.index(read_wider.verdict) <= _QUALITY.index(literal.verdict):
        return literal
    remark = "of the angles with this tangent, sine or cosine one is named; all of them are meant"
    equations = tuple(
        replace(v, remarks=(*v.remarks, remark)) if old != new else v
        for v, old, new in zip(
            read_wider.equations,
            [es for a in systems for es in a],
            [es for a in wider for es in a],
            strict=True,
        )
    )
    return replace(read_wider, equations=equations)


def _widened(e: sp.Expr) -> sp.Expr:
    """θ − atan(u) as tan θ − u."""
    terms = sp.Add.make_args(e)
    if len(terms) != 2:
        return e
    for angle, other in (terms, terms[::-1]):
        c, inverse = other.as_coeff_Mul()
        d, theta = angle.as_coeff_Mul()
        function = _INVERSE.get(type(inverse))
        if theta.is_Symbol and function is not None and abs(c) == abs(d):
            return function(theta) - function(-c / d * inverse)
    return e
