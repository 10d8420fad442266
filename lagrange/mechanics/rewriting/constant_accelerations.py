"""Constant accelerations, as in Atwood's machine: the equations of motion then give one value for each.

With dependent coordinates the constraints, differentiated twice, join the equations; a nonlinear constraint gives the
square of one velocity by the others, which may leave the parameters alone.

Forces one after another from single laws of motion, by the accelerations: F = m (g + a), then F₂ = F − (I/R) α''.

Of the laws Σ_j λ_j a_jk = D_k one with a single unknown λ gives it; with that known, others have a single unknown, and
so on, always the simplest first. Each value is compared with that of the general solution, in which the accelerations
are eliminated.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp

from lagrange.algebra.exact.zero_test import kept_surface
from lagrange.algebra.fourier.linear_systems import solved_linear
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.expression_size import count_operations
from lagrange.core.symbols import Unspecified, prime, t
from lagrange.mechanics.dynamics.motion import NewtonLaw
from lagrange.mechanics.dynamics.newton import Reaction
from lagrange.mechanics.limits import LONGEST_CONSTANT
from lagrange.mechanics.results import InCoordinates
from lagrange.mechanics.rewriting.quasi_velocities import squares_by_constraints
from lagrange.mechanics.rewriting.sums_of_products import in_products


def constant_accelerations(view: InCoordinates) -> dict[sp.Symbol, sp.Expr]:
    """The accelerations, if the equations determine them by parameters alone and do not say them already."""
    motion = view.motion
    assert motion is not None
    slots = view.configuration.slots
    moving = {*slots.coordinates, *slots.velocities, *slots.prescribed, *(prime(u) for u in slots.prescribed), t}
    if any(r.nonlinear is not None for r in view.configuration.rows) and view.dynamics is not None:
        rules = squares_by_constraints(view.configuration.rows, slots)
        values = {a: _reduced(e, rules) for a, e in view.dynamics.accelerations.items()}
        return {a: e for a, e in values.items() if not e.free_symbols & moving and not e.atoms(Unspecified)}
    equations = [e.expression for e in motion.final]
    equations += view.configuration.constrained.accelerated_constraints
    if len(equations) != len(slots.accelerations):
        return {}
    if len(equations) == 1 and equations[0].coeff(slots.accelerations[0]).is_number:
        return {}  # it says so already
    if any(e.free_symbols & moving or e.atoms(Unspecified) for e in equations):
        return {}
    rows = [[e.diff(a) for a in slots.accelerations] for e in equations]
    right = [-e.xreplace(dict.fromkeys(slots.accelerations, sp.S.Zero)) for e in equations]
    accelerations = solved_linear(rows, right, kept_surface())
    if accelerations is None or any(x is None for x in accelerations):
        return {}
    pairs = zip(slots.accelerations, accelerations, strict=True)
    solved = {a: _in_one_fraction(x) for a, x in pairs if x is not None}
    solved = _shorter(solved, _one_by_one(equations, slots.accelerations))
    solved = {a: in_products(x) for a, x in solved.items()}
    return solved if sum(count_operations(x) for x in solved.values()) <= LONGEST_CONSTANT else {}


def _one_by_one(equations: Sequence[sp.Expr], unknown: Sequence[sp.Symbol]) -> dict[sp.Symbol, sp.Expr]:
    """Each acceleration from an equation in which it is the last one that is not known: as its factors are written."""
    values: dict[sp.Symbol, sp.Expr] = {}
    for _ in unknown:
        for e in equations:
            left = [a for a in unknown if a in e.free_symbols and a not in values]
            if len(left) == 1:
                rest = sp.factor_terms(e.xreplace({left[0]: sp.S.Zero}).xreplace(values))
                values[left[0]] = -rest / e.diff(left[0])
    return values


def _shorter(solved: dict[sp.Symbol, sp.Expr], others: dict[sp.Symbol, sp.Expr]) -> dict[sp.Symbol, sp.Expr]:
    """The second if it has the same values, in fewer operations; in the order of the first."""
    before, after = (sum(map(count_operations, values.values())) for values in (solved, others))
    if {*others} != {*solved} or after >= before:
        return solved
    same = all(kept_surface().are_equal(value, others[a]) is True for a, value in solved.items())
    return {a: others[a] for a in solved} if same else solved


def _reduced(e: sp.Expr, rules: Sequence[tuple[sp.Symbol, sp.Expr]]) -> sp.Expr:
    """An acceleration under the constraints: above and below, x'^2 by the other velocities."""
    above, below = (sp.expand(part).xreplace({v**2: s for v, s in rules}) for part in sp.fraction(sp.together(e)))
    return e if below == 0 else sp.factor(sp.cancel(above / below))


def _in_one_fraction(x: sp.Expr) -> sp.Expr:
    """A sum of fractions as a single fraction, with a nonnegative denominator where its sign is known."""
    above, below = sp.fraction(sp.together(x))
    if not x.is_Add or above.is_number or below.is_number:
        return x
    negative = sum(1 for term in sp.Add.make_args(below) if term.could_extract_minus_sign())
    if 2 * negative > len(sp.Add.make_args(below)):
        above, below = -above, -below
    one = sp.factor(above) / below
    return one if count_operations(one) <= count_operations(x) else x


# Forces in turn


def forces_in_turn(
    law: NewtonLaw, own: InCoordinates, view: InCoordinates, accelerations: Mapping[sp.Symbol, sp.Expr]
) -> dict[sp.Symbol, sp.Expr] | None:
    """The forces by accelerations and by forces before them; None if no law has a single unknown, or they differ.

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
        form = _over_one_denominator(textbook_form(e.xreplace(values)))
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


def _over_one_denominator(e: sp.Expr) -> sp.Expr:
    """Over one denominator, where that is shorter."""
    return min(e, sp.together(e), key=count_operations)
