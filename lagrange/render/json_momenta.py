"""Hamilton's function, the canonical equations and Routh's function in JSON."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from lagrange.core.symbols import prime

if TYPE_CHECKING:
    from lagrange.mechanics.momenta.hamiltonian import Hamiltonian

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
