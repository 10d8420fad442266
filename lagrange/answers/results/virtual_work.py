"""Wrong positions of rest from slips in the virtual work itself: in a differential, or in one of the equations.

The displacements that a constraint f(q) = 0 leaves satisfy Σ_k (∂f/∂q_k) δq_k = 0, and f is a sum of terms: of one of
them the derivative may have the wrong sign, lack a factor, or be forgotten. With such a row in place of the right one
the stated forces balance, and that is one exact test for each term.

A reaction may be taken from the balance along its own direction, as if no other reaction had a component there: the
normal force as W cos α where a second plane, a wall or a rope acts as well.

A force may be forgotten in one of the equations and counted in the others: in the balance of forces from which a
reaction was found, and not in that of moments.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import combinations, product
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError, NoPointError, UnsupportedError, is_zero
from lagrange.answers.limits import MOST_CONDITION_TERMS, MOST_RESTING_FACTORS
from lagrange.answers.models.forces import name_of
from lagrange.answers.models.mechanics import ForceShare, Mechanics, Variation, written
from lagrange.core.vectors import Vector
from lagrange.problem.model import Problem

if TYPE_CHECKING:
    from lagrange.mechanics.constraints.kinematics import Configuration
    from lagrange.mechanics.dynamics.newton import Newton
    from lagrange.mechanics.equilibrium.equilibrium import Equilibrium

_SLIPS = (
    (-sp.Integer(2), "has the wrong sign"),
    (-sp.S.One, "is missing"),
    (-sp.Rational(1, 2), "is half as large as it should be"),
    (sp.S.One, "is twice as large as it should be"),
)


def of_differential(
    balanced: Callable[[Sequence[Sequence[sp.Expr]]], bool], equilibrium: Equilibrium, problem: Problem
) -> str:
    """The term of a constraint whose derivative is wrong in the displacements that an answer implies, in a sentence.

    balanced  whether the forces balance at the stated places with these rows in place of the constraints' own
    """
    slots = equilibrium.configuration.slots
    right = [row.coefficients for row in equilibrium.binding]
    for j, row in enumerate(equilibrium.binding):
        constraint = next((c for c in problem.constraints if c.name == row.name), None)
        if constraint is None or constraint.kinematic:
            continue
        try:
            for terms in _sums(constraint.function, problem, {*slots.coordinates}):
                own = [sp.Add(*(x.diff(q) for x in terms)) for q in slots.coordinates]
                if any(is_zero(a - b) is not True for a, b in zip(own, row.coefficients, strict=True)):
                    continue
                for (factor, how), term, (k, q) in product(_SLIPS, terms, enumerate(slots.coordinates)):
                    slope = term.diff(q)
                    if slope == 0 or slope == own[k]:
                        continue
                    changed = [own[i] + factor * slope if i == k else a for i, a in enumerate(own)]
                    if balanced([*right[:j], changed, *right[j + 1 :]]):
                        shown = written(-term if term.could_extract_minus_sign() else term, slots)
                        where = f"in the differential of the constraint `{row.name}`"
                        return f"{where}, the derivative of {shown} with respect to {q} {how}"
        except (DivisionByZeroError, NoPointError, UnsupportedError):
            continue
    return ""


def _sums(function: sp.Expr, problem: Problem, coordinates: set[sp.Symbol]) -> Iterator[tuple[sp.Expr, ...]]:
    """A constraint as sums of terms: as it is, and, for a distance that is given, as the squares of its components."""
    places = [Vector.zero(), *(p.position for p in problem.particles), *(b.position for b in problem.bodies)]
    for one, other in combinations(places[:MOST_CONDITION_TERMS], 2):
        way = (other - one).fixed().components
        squares = tuple(c**2 for c in way if c != 0)
        rest = function - sp.Add(*squares)
        if len(squares) > 1 and all(is_zero(rest.diff(q)) is True for q in sorted(coordinates, key=str)):
            yield squares
    terms = sp.Add.make_args(function)
    if len(terms) <= MOST_CONDITION_TERMS and {s for x in terms for s in x.free_symbols} & coordinates:
        yield terms


def of_one_displacement(forces: Sequence[ForceShare], rule: Mapping[sp.Expr, sp.Expr]) -> str:
    """Which of two forces that balance is taken to move by a multiple, as the end of a sentence; empty: neither.

    rule  a wrong answer, with which their virtual work has the ratio −r:  r times as much would balance
    """
    if len(forces) != 2:
        return ""
    first, second = ((f.factor * f.shares[0]).xreplace(dict(rule)) for f in forces)
    ratio = sp.cancel(sp.together(-_by_sines(first) / _by_sines(second))) if second != 0 else sp.S.Zero
    if not ratio.is_Rational or ratio in (0, 1) or ratio < 0 or max(ratio.p, ratio.q) > MOST_RESTING_FACTORS:
        return ""
    one, other = (f"`{f.on[0]}`" for f in forces)
    return f"with the displacement of {one} {1 / ratio} times as large as it is, or that of {other} {ratio} times"


def _by_sines(e: sp.Expr) -> sp.Expr:
    return e.replace(sp.tan, lambda x: sp.sin(x) / sp.cos(x))


def in_one_equation_only(m: Mechanics) -> Iterator[Variation]:
    """One force is forgotten in one of the equations in which it counts."""
    for f in m.forces:
        counting = [k for k, s in enumerate(f.shares) if s != 0]
        for k in counting if len(counting) > 1 else ():
            q = m.slots.coordinates[k]
            shares = tuple(sp.S.Zero if i == k else s for i, s in enumerate(f.shares))
            changed = m.force(lambda g, f=f, shares=shares: replace(g, shares=shares) if g == f else g)  # type: ignore[misc]
            yield Variation(f"without {name_of(f)} in the equation of {q} alone", f"the equation of {q}", changed)


def of_the_direction_alone(zero: sp.Expr, newton: Newton, configuration: Configuration) -> str:
    """Whether a stated reaction balances the components of the applied forces along it, in a sentence; empty if not.

    zero  which vanishes, in the multipliers and the coordinates of the configuration
    """
    stated = [r for r in newton.reactions if r.multiplier in zero.free_symbols]
    if len(stated) != 1 or len(newton.reactions) < 2:
        return ""
    [reaction] = stated
    for name, direction in (reaction.directions or {}).items():
        along = direction.fixed().map(configuration.rewritten)
        loads = [f for f in configuration.loads if f.on == name]
        square = along.dot(along)
        if not loads or square == 0:
            continue
        total = sp.Add(*(f.vector.fixed().map(configuration.rewritten).dot(along) for f in loads))
        try:
            if total != 0 and is_zero(zero.xreplace({reaction.multiplier: -total / square})) is True:
                what = "the applied forces" if len(loads) > 1 else "the weight" if loads[0].name == "weight" else ""
                what = what or f"`{loads[0].name}`"
                return (
                    f"this balances the component of {what} along it, as if no other reaction had a component in "
                    "that direction"
                )
        except (DivisionByZeroError, NoPointError, UnsupportedError):
            continue
    return ""
