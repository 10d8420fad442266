"""Wrong answers about constraints: their equations, their class, the number of degrees of freedom.

A wrong equation for a constraint: which one change makes it right.

Sine and cosine of an angle exchanged, the sign of a term, two coordinates exchanged, a factor 2. Each change is made in
the equation as it was read, and tested as the equation itself was.

Why a class or a number of degrees of freedom is wrong.

A constraint on velocities makes a system nonholonomic only if it cannot be integrated, alone or together with the
others; a system is rheonomic if time occurs in its constraints or positions, not because a force depends on it; and
every independent constraint, finite or on velocities, removes one degree of freedom. A constraint that is a vector
equation counts once for each independent component.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import chain, combinations

import sympy as sp

from lagrange.algebra.exact.expression_graph import DivisionByZeroError
from lagrange.answers.limits import MOST_CHANGES
from lagrange.core.symbols import base, differential, prime, variation
from lagrange.document.math_writer import text
from lagrange.mechanics.constraints.classification import Classification
from lagrange.mechanics.constraints.constraints import ConstraintAnalysis


def explained_constraint(
    components: Sequence[sp.Expr],
    coordinates: Sequence[sp.Symbol],
    rows: Sequence[sp.Expr],
    holds: Callable[[sp.Expr], bool],
) -> str:
    """What is wrong with an equation, in a sentence; empty if no change makes it right.

    rows  the constraints of the problem, affine in the velocities
    """
    if len(components) != 1:
        return ""
    (e,) = components
    for n, (sentence, changed) in enumerate(chain(_changes(e, coordinates), _missing(e, coordinates, rows))):
        if n >= MOST_CHANGES:
            break
        try:
            if changed != 0 and holds(changed):
                return sentence
        except DivisionByZeroError:
            continue
    return ""


def _changes(e: sp.Expr, coordinates: Sequence[sp.Symbol]) -> Iterator[tuple[str, sp.Expr]]:
    terms = sp.Add.make_args(sp.expand(e))
    if len(terms) > 1:
        for term in terms:
            yield f"one change makes it right: the sign of the term {text(term)}", e - 2 * term
    angles = sorted({w.args[0] for w in e.atoms(sp.sin, sp.cos, sp.tan)}, key=str)
    for a in angles:
        rule = {sp.sin(a): sp.cos(a), sp.cos(a): sp.sin(a), sp.tan(a): sp.cot(a)}
        exchanged = e.xreplace(rule)
        yield f"it would be right with sine and cosine of {text(a)} exchanged", exchanged
        for term in sp.Add.make_args(sp.expand(exchanged))[1:]:
            yield (
                f"it would be right with sine and cosine of {text(a)} exchanged, and one sign changed",
                exchanged - 2 * term,
            )
    used = [q for q in coordinates if any(base(s) == q or s in (differential(q), variation(q)) for s in e.free_symbols)]
    for a, b in combinations(used, 2):
        rule = {kind(x): kind(y) for x, y in ((a, b), (b, a)) for kind in (base, prime, differential, variation)}
        yield f"it would be right with {text(a)} and {text(b)} exchanged", e.xreplace(rule)
    for term in terms if len(terms) > 1 else ():
        yield f"one change makes it right: {text(2 * term)} in place of {text(term)}", e + term
        yield f"one change makes it right: {text(term / 2)} in place of {text(term)}", e - term / 2


def _missing(e: sp.Expr, coordinates: Sequence[sp.Symbol], rows: Sequence[sp.Expr]) -> Iterator[tuple[str, sp.Expr]]:
    """The equation with a term of a constraint with a coordinate that it does not have."""
    kinds = [k for k in (prime, differential, variation) if any(k(q) in e.free_symbols for q in coordinates)]
    if len(kinds) != 1:
        return
    [kind] = kinds
    written = {prime(q): kind(q) for q in coordinates}
    for row in rows:
        terms = [term.xreplace(written) for term in sp.Add.make_args(sp.expand(row))]
        for term in terms if len(terms) > 2 else ():
            if any(kind(q) in term.free_symbols and kind(q) not in e.free_symbols for q in coordinates):
                shown = text(-term if term.could_extract_minus_sign() else term)
                for sign in (1, -1):
                    yield f"one change makes it right: the term {shown} is missing", e + sign * term


# Class and degrees of freedom


def explained_degrees_of_freedom(stated: int, classification: Classification) -> str:
    """How a wrong number of degrees of freedom may have been counted; empty if that is not found."""
    coordinates, rank = classification.coordinates, classification.rank
    rows = [c.row for c in classification.constraints]
    if not rows:
        if stated < coordinates:
            return f"there are no constraints between the {coordinates} coordinates"
        return f"the position is determined by {_number(coordinates, 'coordinate')}"
    finite = sum(row.finite is not None for row in rows)
    integrable = classification.integrable_rank
    if stated == coordinates:
        return f"there are {coordinates} coordinates; the constraints between them are not subtracted"
    if stated > coordinates:
        return f"the position is determined by {_number(coordinates, 'coordinate')}, and there are constraints as well"
    if stated == coordinates - finite and finite < len(rows):
        return "the constraints on velocities are not subtracted: they restrict the displacements too"
    if integrable is not None and integrable < rank and stated == coordinates - integrable:
        return "only the constraints that can be integrated are subtracted: the others restrict the displacements too"
    if stated == coordinates - len(rows):
        return "a constraint that follows from the others is counted"
    vectors = {c.row.name.partition(".")[0] for c in classification.constraints}
    if stated == coordinates - len(vectors):
        return "a constraint that is a vector equation counts once for each of its independent components"
    equations = _number(rank, "independent equation")
    difference = stated - (coordinates - rank)
    if difference > 0:
        missing = _number(difference, "constraint")
        return f"{missing} too few {_is(difference)} subtracted: there are {coordinates} coordinates and {equations}"
    if classification.hidden.found and stated == coordinates - rank - len(classification.hidden.found):
        return "the hidden finite relation follows from the constraints, and is not subtracted once more"
    missing = _number(-difference, "constraint")
    return f"{missing} too many {_is(-difference)} subtracted: there are {coordinates} coordinates and {equations}"


def _number(n: int, what: str) -> str:
    return f"{n} {what}" if n == 1 else f"{n} {what}s"


def _is(n: int) -> str:
    return "is" if n == 1 else "are"


def explained_classes(wrong: Sequence[str], classification: Classification) -> str:
    """A sentence that says why stated classes are wrong; empty if there is no simple reason."""
    return "; ".join(filter(None, (_explained_class(word, classification) for word in wrong)))


def _explained_class(word: str, c: Classification) -> str:
    kinematic = [a for a in c.independent if a.row.finite is None]
    timely = [a.constraint.name for a in c.constraints if a.depends_on_time]
    match word:
        case "nonholonomic":
            return _holonomic(kinematic)
        case "holonomic":
            never = [a for a in kinematic if a.integrable is False]
            return f"{_list(never)} cannot be integrated" if never else "the constraints cannot be integrated together"
        case "scleronomic":
            where = [*(f"the constraint `{n}`" for n in dict.fromkeys(timely))] or [
                f"the position of `{n}`" for n in (*c.moving, *c.driven)
            ]
            return f"time occurs in {' and '.join(where[:2])}" if where else ""
        case "rheonomic":
            besides = ", and forces do not count" if c.forced else ""
            return f"time occurs neither in a constraint nor in a position{besides}"
        case "catastatic":
            drifting = [a for a in c.constraints if a.catastatic is False]
            return f"{_list(drifting)} cannot hold with all velocities zero" if drifting else ""
        case "acatastatic":
            return "all velocities may be zero: no constraint forces the system to move"
    return ""


def _holonomic(kinematic: Sequence[ConstraintAnalysis]) -> str:
    """Why a system is holonomic."""
    if not kinematic:
        return "no constraint is one on velocities: all are relations between coordinates"
    alone = [a for a in kinematic if a.integrable]
    if len(alone) == len(kinematic):
        it = "it" if len(alone) == 1 else "them"
        return f"{_list(alone)} can be integrated: velocities in {it} do not make the system nonholonomic"
    never = [a for a in kinematic if a.integrable is False]
    return f"{_list(never)} cannot be integrated alone, but all constraints together can"


def explained_integrability(wrong: Mapping[str, bool], classification: Classification) -> str:
    """Why statements about what can be integrated are wrong; `wrong` has what was stated."""
    by_name = {c.constraint.name: c for c in classification.constraints}
    parts, failing = [], []
    for name, stated in wrong.items():
        analysis = by_name.get(name)
        if analysis is None:
            continue
        if not stated and analysis.row.finite is not None:
            parts.append(f"`{name}` is a relation between coordinates already")
        elif not stated:
            exact = analysis.exactness.exact
            how = "its form is exact" if exact else "its form has an integrating factor"
            parts.append(f"`{name}` can be integrated: {how}" if exact or analysis.factor else "")
        elif analysis.frobenius:
            failing.append(analysis)
    if failing:
        fail = "fails" if len(failing) == 1 else "fail"
        parts.append(f"{_list(failing)} {fail} Frobenius' test: ω ∧ dω is not zero")
    return "; ".join(filter(None, parts))


def _list(constraints: Sequence[ConstraintAnalysis]) -> str:
    *others, last = dict.fromkeys(f"`{a.constraint.name}`" for a in constraints)
    return f"{', '.join(others)} and {last}" if others else last
