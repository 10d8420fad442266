"""Forces one after another from single laws of motion, by the accelerations: F = m (g + a), then F₂ = F − (I/R) α''.

Of the laws Σ_j λ_j a_jk = D_k one with a single unknown λ gives it; with that known, others have a single unknown, and
so on, always the simplest first. Each value is compared with that of the general solution, in which the accelerations
are eliminated.
"""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from lagrange.algebra.exact.zero_test import kept_surface
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.operations import count_operations
from lagrange.core.symbols import prime
from lagrange.mechanics.dynamics.motion import NewtonLaw
from lagrange.mechanics.dynamics.newton import Reaction
from lagrange.mechanics.results import InCoordinates


def forces_in_turn(
    law: NewtonLaw, own: InCoordinates, view: InCoordinates, accelerations: Mapping[sp.Symbol, sp.Expr]
) -> dict[sp.Symbol, sp.Expr] | None:
    """The forces by accelerations and by forces before them; None where no law has a single unknown, or they differ.

    own            the file's coordinates, in which the laws are
    view           those in which the forces are wanted
    accelerations  there, constant
    """
    reactions = None if view.dynamics is None else view.dynamics.reactions
    steps = _in_turn(law, own)
    if reactions is None or steps is None:
        return None
    slots = view.configuration.slots
    expressed = view.configuration.expressed
    rule: dict[sp.Basic, sp.Expr] = {
        prime(q, 2): slots.time_derivative(slots.time_derivative(e)) for q, e in expressed.items()
    }
    values = {**expressed, **rule}
    written: dict[sp.Symbol, sp.Expr] = {}
    numbers: dict[sp.Basic, sp.Expr] = {}
    for r, e in steps:
        form = _shorter(textbook_form(e.xreplace(values)))
        size = reactions.sizes.get(r.name, reactions.multipliers.get(r.name))
        number = form.xreplace(dict(accelerations)).xreplace(numbers)
        if size is None or kept_surface().is_zero(number - size) is not True:
            return None
        written[r.force], numbers[r.force] = form, size
    return written


def _in_turn(law: NewtonLaw, own: InCoordinates) -> list[tuple[Reaction, sp.Expr]] | None:
    """Each force with its value, in an order in which each needs only the ones before it."""
    configuration = own.configuration
    size, accelerations = len(configuration.slots.coordinates), configuration.slots.accelerations
    laws = [row[:size] for row in law.system.rows[:size]]
    shares = [[-e for e in row[size:]] for row in law.system.rows[:size]]
    balance = [
        sp.Add(*(m * a for m, a in zip(row, accelerations, strict=True)), -b)
        for row, b in zip(laws, law.system.right, strict=False)
    ]
    unknown, steps = [*range(len(law.used))], list[tuple[Reaction, sp.Expr]]()
    forces = [r.force * r.per_force for r in law.used]
    while unknown:
        ready = [(k, left[0]) for k in range(size) if len(left := [j for j in unknown if shares[k][j] != 0]) == 1]
        if not ready:
            return None
        k, j = min(ready, key=lambda pair: (_length(shares[pair[0]]), count_operations(balance[pair[0]])))
        others = sp.Add(*(forces[i] * a for i, a in enumerate(shares[k]) if i != j))
        r = law.used[j]
        steps.append((r, (balance[k] - others) / (shares[k][j] * r.per_force)))
        unknown.remove(j)
    return steps


def _length(row: list[sp.Expr]) -> int:
    return sum(e != 0 for e in row)


def _shorter(e: sp.Expr) -> sp.Expr:
    """Over one denominator, where that is shorter."""
    return min(e, sp.together(e), key=count_operations)
