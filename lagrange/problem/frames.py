"""The frames of a textbook: polar, cylindrical and spherical unit vectors.

    polar, cylindrical   e_r = cos φ i + sin φ j,   e_φ = −sin φ i + cos φ j,   ω = φ' k
    spherical            e_r = sin θ (cos φ i + sin φ j) + cos θ k   (θ from +k, φ from i to j),
                         e_θ = ∂e_r/∂θ,   e_φ = −sin φ i + cos φ j,   ω = θ' e_φ + φ' k

The unit vectors are named after the coordinates that the file gives them.
"""

from __future__ import annotations

from collections.abc import Callable
from enum import StrEnum

import sympy as sp

from lagrange.core.vectors import FIXED, Triad

ZERO, ONE = sp.S.Zero, sp.S.One


class FrameType(StrEnum):
    """The frames that a file may name."""

    CARTESIAN = "cartesian"
    POLAR = "polar"
    CYLINDRICAL = "cylindrical"
    SPHERICAL = "spherical"


def polar(r: sp.Symbol, phi: sp.Symbol) -> Triad:
    """e_r and e_φ in the plane of i and j, and k."""
    return _turning_about_k((f"e_{r.name}", f"e_{phi.name}", "k"), phi)


def cylindrical(rho: sp.Symbol, phi: sp.Symbol, z: sp.Symbol) -> Triad:
    """e_ρ, e_φ and e_z = k."""
    return _turning_about_k((f"e_{rho.name}", f"e_{phi.name}", f"e_{z.name}"), phi)


def spherical(r: sp.Symbol, theta: sp.Symbol, phi: sp.Symbol) -> Triad:
    """e_r, e_θ, e_φ."""
    (st, ct), (sf, cf) = (sp.sin(theta), sp.cos(theta)), (sp.sin(phi), sp.cos(phi))
    directions = sp.ImmutableMatrix([[st * cf, st * sf, ct], [ct * cf, ct * sf, -st], [-sf, cf, 0]])
    names = (f"e_{r.name}", f"e_{theta.name}", f"e_{phi.name}")
    return Triad(names, directions, ((theta, (ZERO, ZERO, ONE)), (phi, (ct, -st, ZERO))))


def cartesian(*_coordinates: sp.Symbol) -> Triad:
    """i, j, k."""
    return FIXED


FRAMES: dict[FrameType, tuple[int, Callable[..., Triad]]] = {
    FrameType.CARTESIAN: (0, cartesian),
    FrameType.POLAR: (2, polar),
    FrameType.CYLINDRICAL: (3, cylindrical),
    FrameType.SPHERICAL: (3, spherical),
}


def _turning_about_k(names: tuple[str, str, str], phi: sp.Symbol) -> Triad:
    s, c = sp.sin(phi), sp.cos(phi)
    directions = sp.ImmutableMatrix([[c, s, 0], [-s, c, 0], [0, 0, 1]])
    return Triad(names, directions, ((phi, (ZERO, ZERO, ONE)),))
