"""What the virtual displacements of a configuration are multiplied by, whichever way it is derived.

    Σ_k D_k δq_k = 0   for every virtual displacement,      D_k = Σ_j λ_j a_jk   with multipliers.

D'Alembert's principle gives D_k as inertia less force (`principle.py`), Lagrange's equations as
d/dt ∂T/∂q_k' − ∂T/∂q_k − Q_k (`energies.py`). What follows needs to know only that there is such a list.
"""

from __future__ import annotations

import sympy as sp

from lagrange.algebra.fourier.textbook import Textbook
from lagrange.algebra.fourier.trigonometry import Element, Ring
from lagrange.core.records import record
from lagrange.mechanics.constraints.kinematics import Configuration


@record
class Balance:
    """The balance of inertia and applied forces in the coordinates of a configuration.

    coefficients  shape (n,): D_k, as ring elements
    forces        shape (n,): Q_k of all applied forces, in textbook form
    textbook      what writes ring elements down
    """

    configuration: Configuration
    coefficients: tuple[Element, ...]
    forces: tuple[sp.Expr, ...]
    textbook: Textbook

    @property
    def ring(self) -> Ring:
        """The ring of the coefficients."""
        return self.textbook.ring
