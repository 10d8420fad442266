"""Equations that are marked as expansions in a small coordinate: do they agree with the equations of motion so far?

    theta'' = -g/l*theta + g/(6*l)*theta^3 + O(theta^5)        for small theta: theta'' = -g/l*theta

With the accelerations that the derived equations give, the equation is put at ε θ, ε θ'; what is left must vanish in
all powers of ε below the order that is neglected, which is the second where none is stated.
"""

from __future__ import annotations

import re

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError, is_zero
from lagrange.answers.limits import HIGHEST_EXPANSION, MOST_LINEARIZED
from lagrange.answers.readings import GivenEquation
from lagrange.answers.references import Reference, ReferenceCandidate
from lagrange.answers.written.decimals import as_written
from lagrange.core.diagnostics import Fragment
from lagrange.core.symbols import prime
from lagrange.expressions.characters import GREEK

ORDER = "expanded to O({})"
"""What is noted beside an equation whose neglected term was left out."""
_ORDER = re.compile(
    r"expanded to O\(\s*(?P<name>\\?[^\W\d]\w{0,12})\s*(?:\^\s*\{?\s*(?P<power>[1-9])\s*\}?|(?P<digit>[²³⁴⁵⁶]))?\s*\)"
)
_SMALL = re.compile(r"\bsmall\s+(?:angles?\s+|values?\s+of\s+|displacements?\s+)?\$?\\?(?P<name>[^\W\d]\w{0,12})")
_ELSE_TOO = re.compile(r"≪|≫|<<|>>|\\ll|\\gg|neglect|limit", re.IGNORECASE)
_DIGITS = {"²": 2, "³": 3, "⁴": 4, "⁵": 5, "⁶": 6}
NOT_EXPANDED = "it is marked as an approximation, but differs from the equations of motion in terms of order {} in {}"


def contradiction_in_expansion(equation: Fragment, reference: Reference) -> str:
    """The first order in which an expansion differs from the derived equations, in words; empty if none is known."""
    if not isinstance(equation, GivenEquation) or len(equation.reading.components) != 1:
        return ""
    stated = _order_in(equation.beside)
    if stated is None:
        return ""
    name, below = stated
    e = as_written(equation.reading.components[0])
    differing: set[int] = set()
    for c in reference.candidates:
        order = _first_difference(e, name, below, c)
        if order == below:
            return ""
        if order is not None:
            differing.add(order)
    return NOT_EXPANDED.format(max(differing), name) if differing else ""


def _order_in(beside: str) -> tuple[str, int] | None:
    """The coordinate in which an equation is expanded, and the lowest power that is neglected."""
    match = _ORDER.search(beside)
    if match is not None:
        power = int(match["power"] or _DIGITS.get(match["digit"] or "", 1))
    elif (match := _SMALL.search(beside)) is not None and not _ELSE_TOO.search(beside):
        power = 2
    else:
        return None
    written = match["name"].lstrip("\\")
    name = "".join(GREEK.get(c, c) for c in written)
    return (name.removeprefix("var"), power) if power <= HIGHEST_EXPANSION else None


def _first_difference(e: sp.Expr, name: str, below: int, candidate: ReferenceCandidate) -> int | None:
    """The first power in which e differs, `below` if none smaller does; None if that is not known."""
    system, slots = candidate.system, candidate.configuration.slots
    small = next((q for q in slots.coordinates if q.name == name), None)
    accelerations = slots.accelerations
    if small is None or candidate.configuration.rows or system.multipliers or len(accelerations) > MOST_LINEARIZED:
        return None
    if len(system.equations) != len(accelerations):
        return None
    claim = candidate.read(e)
    if not {*accelerations} & claim.free_symbols:
        return None
    zero = dict.fromkeys(accelerations, sp.S.Zero)
    own = [claim.diff(a) for a in accelerations]
    mass = sp.Matrix([[eq.diff(a) for a in accelerations] for eq in system.equations])
    if any(not {*accelerations}.isdisjoint(x.free_symbols) for x in (*own, *mass)):
        return None
    rest = sp.Matrix([eq.xreplace(zero) for eq in system.equations])
    residual = claim.xreplace(zero) * mass.det(method="berkowitz") - (sp.Matrix([own]) * mass.adjugate() * rest)[0]
    scale = sp.Dummy("epsilon")
    residual = residual.xreplace({small: scale * small, prime(small): scale * prime(small)})
    for order in range(below):
        try:
            vanishes = is_zero(sp.expand(residual.xreplace({scale: sp.S.Zero})))
        except DivisionByZeroError:
            return None
        if not vanishes:
            return order if vanishes is False else None
        residual = residual.diff(scale)
    return below
