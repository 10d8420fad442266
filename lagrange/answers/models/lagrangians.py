"""Mistakes with a given Lagrangian, or with a potential that depends on velocities.

With X the part of L that depends on velocities, and p_k = ∂X/∂q_k',

    E_k = d/dt p_k − ∂X/∂q_k + ... ,      d/dt p_k = Σ_j (∂p_k/∂q_j') q_j'' + Σ_j (∂p_k/∂q_j) q_j' + ∂p_k/∂t .

Any of these parts may be lost, or d/dt be carried out for the velocity q_k' alone, p_k = μ q_k' with μ taken as
constant; or a term of L has a wrong sign or factor. A formula that is right in the limit in which a parameter is
infinite, such as the velocity of light, is that of another mechanics.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.answers.limits import LONGEST_TERM_OF_LAGRANGIAN
from lagrange.answers.models.mechanics import AppliedForceKind, ForceShare, Mechanics, Variation, called
from lagrange.core.symbols import base, prime, t


def term_changed(m: Mechanics) -> Iterator[Variation]:
    """A term of the Lagrangian is omitted, or has the wrong sign or another factor."""
    terms = m.of_kind(AppliedForceKind.LAGRANGIAN)
    for factor, how in _FACTORS:
        for f in terms if len(terms) > 1 else ():
            term = f"the term {called(f.name)} of the Lagrangian"
            yield Variation(how.format(term), term, m.scaled([f], factor))


_FACTORS = (
    (sp.S.NegativeOne, "with the wrong sign of {}"),
    (sp.S.Zero, "without {}"),
    (sp.Integer(2), "with twice {}"),
    (sp.Rational(1, 2), "with half of {}"),
)


def part_of_derivative_left_out(m: Mechanics) -> Iterator[Variation]:
    """A part of d/dt ∂X/∂q' − ∂X/∂q is omitted."""
    X = m.configuration.velocity_part
    if X == 0:
        return
    slots = m.slots
    momenta = [sp.diff(X, v) for v in slots.velocities]
    accelerated = [sp.Add(*(sp.diff(p, v) * prime(v) for v in slots.velocities)) for p in momenta]
    carried = [slots.time_derivative(p) - a for p, a in zip(momenta, accelerated, strict=True)]
    slopes = [sp.diff(X, q) for q in slots.coordinates]
    of = "" if m.configuration.is_outright else f" of the potential {called(_moving_force(m))}"
    function = "L" if m.configuration.is_outright else "U"
    gradient, momentum = f"d{function}/dq", f"d{function}/dq'"

    def without(part: Sequence[sp.Expr], share: sp.Expr = sp.S.One) -> Mechanics:
        # A force that takes out what enters E_k with these signs.
        more = ForceShare(AppliedForceKind.LAGRANGIAN, "derivative", tuple(share * p for p in part), False)
        return replace(m, forces=(*m.forces, more))

    if any(s != 0 for s in slopes):
        yield Variation(f"without {gradient}{of}", gradient, without([-s for s in slopes]))
        yield Variation(f"with the wrong sign of {gradient}{of}", gradient, without([-2 * s for s in slopes]))
    rates = [a + c for a, c in zip(accelerated, carried, strict=True)]
    if any(c != 0 for c in carried):
        clause = f"if d/dt of {momentum}{of} is carried out for the velocities alone, and not for their coefficients"
        yield Variation(clause, f"d/dt of {momentum}", without(carried))
    if not m.configuration.is_outright:
        yield Variation(f"without d/dt of {momentum}{of}", f"d/dt of {momentum}", without(rates))
        yield Variation(f"with the wrong sign of d/dt of {momentum}{of}", momentum, without(rates, sp.Integer(2)))
    of_own = [_of_own_velocity(p, v) for p, v in zip(momenta, slots.velocities, strict=True)]
    if all(c is not None for c in of_own):
        kept = [c * prime(v) for c, v in zip(of_own, slots.velocities, strict=True) if c is not None]
        lost = [r - k for r, k in zip(rates, kept, strict=True)]
        clause = (
            f"if d/dt of {momentum}{of} is carried out for the factor q' alone, as if the other factor were constant"
        )
        yield Variation(clause, f"d/dt of {momentum}", without(lost))


def _of_own_velocity(momentum: sp.Expr, velocity: sp.Symbol) -> sp.Expr | None:
    """μ of p_k = μ q_k', where q_k' is a factor of p_k; None if it is not."""
    factor = sp.Mul(*(f for f in sp.Mul.make_args(momentum) if f != velocity))
    return factor if factor * velocity == momentum else None


def _moving_force(m: Mechanics) -> str:
    forces = [f for f in m.of_kind(AppliedForceKind.FORCE, AppliedForceKind.VELOCITY_POTENTIAL) if not f.on]
    return forces[0].name if forces else ""


def parameter_infinite(m: Mechanics) -> Iterator[Variation]:
    """A parameter as large as one likes: the velocity of light in a Newtonian formula."""
    if m.configuration.velocity_part == 0 or (m.inertias and not _moving_force(m)):
        return
    moving = {*m.slots.coordinates, *m.slots.prescribed, t}
    letters = {s for f in m.forces for e in f.shares for s in e.free_symbols if base(s) not in moving}
    for a in sorted(letters, key=str):
        small = sp.Dummy("small", positive=True)
        shares = {f: tuple(_at_infinity(s, a, small) for s in f.shares) for f in m.forces}
        limits = {f: tuple(s for s in own if s is not None) for f, own in shares.items()}
        if all(len(limits[f]) == len(f.shares) for f in m.forces) and any(limits[f] != f.shares for f in m.forces):
            changed = m.force(lambda f, of=limits: replace(f, shares=of[f]))  # type: ignore[misc]
            yield Variation(f"for an infinite {a}", f"what depends on {a}", changed)


def _at_infinity(share: sp.Expr, a: sp.Symbol, small: sp.Symbol) -> sp.Expr | None:
    """The limit of an expression for a → ∞; None if it has none, or is long."""
    if a not in share.free_symbols:
        return share
    if sp.count_ops(share) > LONGEST_TERM_OF_LAGRANGIAN:
        return None
    value = share.xreplace({a: 1 / small}).xreplace({small: sp.S.Zero})
    return None if value.has(sp.nan, sp.zoo, sp.oo) else value
