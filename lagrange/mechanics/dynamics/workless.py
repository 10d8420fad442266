"""The work of the reactions, in a virtual displacement and in a possible one.

    δW = Σ_P R_P·δr_P ,      R_P = Σ_j λ_j g_jP ,      δr_P = Σ_k (∂r_P/∂q_k) δq_k ,

and Γ_B·δπ_B of each body besides, Γ being the moment of the reactions about its mass centre.

The dependent δq are put in as the constraints give them, and what is left is tested for zero on the constraint surface:
that the constraints are workless is a result. The share of one particle need not be zero. In a possible displacement
dr = Σ (∂r/∂q) dq + (∂r/∂t) dt the constraints give Σ a_k dq_k = −a_t dt, so that a reaction may do work where its
constraint moves: a lift works on its passengers.
"""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from lagrange.algebra.fourier.textbook import textbook_form
from lagrange.core.records import record
from lagrange.core.symbols import differential, t, variation
from lagrange.mechanics.constraints.displacements import Elimination, virtual_displacement
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.newton import Newton, Reaction


@record
class WorkOfReaction:
    """The work of one reaction.

    virtual    Σ_P R_P·δr_P for a force 1 (`Reaction.force`) before the dependent δq are put in
    shares     R_P·δr_P of each particle, the same way; empty where directions are not known
    vanishes   whether the whole is zero in every virtual displacement; None: undecided
    working    particles on which it does virtual work
    possible   its work in a possible displacement
    """

    reaction: Reaction
    virtual: sp.Expr
    shares: Mapping[str, sp.Expr]
    vanishes: bool | None
    working: tuple[str, ...]
    possible: sp.Expr


def works_of_reactions(newton: Newton, configuration: Configuration, elimination: Elimination) -> list[WorkOfReaction]:
    """The works of all reactions of a configuration."""
    return [_work(r, configuration, elimination) for r in newton.reactions]


def _work(reaction: Reaction, configuration: Configuration, elimination: Elimination) -> WorkOfReaction:
    slots, surface = configuration.slots, configuration.states
    shares: dict[str, sp.Expr] = {}
    drift = -reaction.row.drift * reaction.per_force
    for p in configuration.points:
        direction = reaction.per_unit(p.name)
        if direction is not None:
            partials = zip(slots.coordinates, p.partials, strict=True)
            shares[p.name] = sp.Add(
                *(textbook_form(direction.dot(along)) * variation(q) for q, along in partials if not along.is_zero)
            )
            drift = drift + direction.dot(p.position.frozen_derivative(slots))
    for r in configuration.rotations:
        moment = reaction.moment_per_unit(r.name)
        if moment is not None:
            turned = zip(slots.coordinates, r.partials, strict=True)
            work = (textbook_form(moment.dot(about)) * variation(q) for q, about in turned if not about.is_zero)
            shares[r.name] = sp.Add(shares.get(r.name, sp.S.Zero), *work)
            drift = drift + moment.dot(r.angular_velocity - r.virtual(slots.velocities))
    loose = sp.Add(*(a * variation(q) for q, a in reaction.others.items()))
    known = reaction.directions is not None and (shares or loose != 0)
    virtual = sp.Add(*shares.values(), loose) if known else virtual_displacement(reaction.row, slots)
    solved = dict(elimination.solved(slots))

    def vanishes(work: sp.Expr) -> bool | None:
        return surface.is_zero(work.xreplace(solved))  # the independent δq have values of their own at every point

    working = tuple(name for name, work in shares.items() if vanishes(work) is False)
    possible = textbook_form(drift) * reaction.force * differential(t)
    return WorkOfReaction(
        reaction=reaction,
        virtual=virtual,
        shares=shares,
        vanishes=vanishes(virtual),
        working=working,
        possible=sp.S.Zero if surface.is_zero(drift) else possible,
    )
