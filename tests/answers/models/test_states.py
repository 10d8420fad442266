"""The equations of a changed system at one state.

Mistakes in one equation alone, and answers of which no cause is known.
"""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.answers.models.mechanics import Inertia, Mechanics
from lagrange.answers.models.states import ModelState
from lagrange.core.symbols import partial, prime
from lagrange.mechanics.dynamics.comparison import affine_rows
from tests.answers.models.slips import WrongAnswer, answers_by, assert_named, name_of
from tests.answers.models.test_mechanics import candidates


def kinetic_energy(part: Inertia, m: Mechanics) -> sp.Expr:
    """½ Σ g_ij q_i' q_j', with the factors of the products, from the vectors alone."""
    rates = [*m.slots.velocities, sp.S.One]
    factors = dict(part.pairs)
    terms = []
    for i in part.moving:
        for j in part.moving:
            g = sum(w * a * b for w, a, b in zip(part.weights, part.columns[i], part.columns[j], strict=True))
            terms.append(factors.get((min(i, j), max(i, j)), 1) * g * rates[i] * rates[j] / 2)
    return part.factor * sp.Add(*terms)


def lagrange(energy: sp.Expr, m: Mechanics) -> list[sp.Expr]:
    slots = m.slots
    return [slots.time_derivative(partial(energy, prime(q))) - partial(energy, q) for q in slots.coordinates]


@pytest.mark.parametrize("name", ["ex17-spherical-pendulum", "pole-on-cart", "heavy-top", "foucault-pendulum"])
def test_a_changed_kinetic_energy_gives_what_its_symbolic_derivatives_give(name: str) -> None:
    *_, candidate = candidates(name)
    m = candidate.models.mechanics
    assert m is not None
    at: ModelState = candidate.models.states(())[0]
    for part in m.inertias:
        changed = [part, *map(part.without, part.moving)]
        changed += [part.times({p: sp.Integer(3)}) for p in part.products]
        for one in changed:
            assert at.share(one) == affine_rows(at.point, lagrange(kinetic_energy(one, m), m), at.unknowns)


# Groups


@pytest.mark.parametrize("answer", answers_by("groups"), ids=name_of)
def test_the_cause_is_named(answer: WrongAnswer) -> None:
    assert_named(answer)
