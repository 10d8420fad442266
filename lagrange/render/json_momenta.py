"""Hamilton's function, the canonical equations, Routh's function and steady motions in JSON."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import sympy as sp

from lagrange.core.symbols import prime

if TYPE_CHECKING:
    from lagrange.mechanics.momenta.hamiltonian import Hamiltonian
    from lagrange.mechanics.momenta.steady_motions import SteadyMotions

Write = Callable[[Any], str]


def hamiltonian(found: Hamiltonian, write: Write) -> dict[str, Any]:
    """`momenta` by coordinate; `velocities` in terms of them; `H`; `equations`; `cyclic` coordinates and `routhian`."""
    coordinates = found.coordinates
    pairs = [(prime(q), v) for q, v in zip(coordinates, found.velocities, strict=True)]
    pairs += [(prime(p), rate) for p, rate in zip(found.momenta, found.rates, strict=True)]
    result: dict[str, Any] = {
        "momenta": {q.name: write(p) for q, p in zip(coordinates, found.energies.momenta, strict=True)},
        "symbols": {q.name: p.name for q, p in zip(coordinates, found.momenta, strict=True)},
        "H": write(found.function),
        "equations": [f"{write(left)} = {write(right)}" for left, right in pairs],
        "is_energy": found.is_energy,
        "cyclic": [coordinates[c].name for c in found.cyclic],
    }
    if found.routhian is not None:
        result["routhian"] = write(found.routhian)
    return result


def steady_motions(found: SteadyMotions, write: Write) -> list[dict[str, Any]]:
    """One entry for each solution of the conditions, with the linear equations about it at constant momenta."""
    entries = []
    branches = [(f, *pair) for f in found.families for pair in zip(f.about.branches, f.about.at, strict=True)]
    for family, b, s in branches:
        entry: dict[str, Any] = {
            "cyclic": [q.name for q in found.cyclic],
            "conditions": [f"{write(r.lhs)} = {write(r.rhs)}" for r in family.relations(b)],
            "exists_where": [f"{write(c.lhs)} {c.relation} {write(c.rhs)}" for c in b.conditions],
        }
        if s is not None:
            stability = s.judgement.stability
            squares = [f.square for f in s.frequencies]
            entry["linear"] = [f"{write(e)} = 0" for e in s.equations]
            entry["frequencies"] = [None if w is None else write(sp.sqrt(w)) for w in squares]
            entry["stability"] = stability.verdict.value
            where = [f"{write(c.lhs)} {c.relation} {write(c.rhs)}" for c in stability.conditions]
            if where:
                entry["stable_where"] = " and ".join(where)
        entries.append(entry)
    return entries
