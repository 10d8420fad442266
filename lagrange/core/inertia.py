"""The tensor of inertia of a rigid body about its mass centre, in axes in which it is constant.

    J_aa = ∫ (r² − x_a²) dm      moments of inertia
    J_ab = −∫ x_a x_b dm         the elements off the diagonal; the products of inertia ∫ x_a x_b dm have the other sign

With ω in components along these axes the angular momentum is H = J ω, and the kinetic energy of rotation is ½ ω·J ω.
In principal axes the J_ab vanish. Every distribution of mass has a matrix ∫ x_a x_b dm = ½ (tr J) 1 − J that is
positive semidefinite, and every such matrix belongs to some distribution. In principal axes this is the triangle
inequality A + B ≥ C, and it implies that J is positive semidefinite.
Reference: Goldstein, Classical Mechanics, §§ 5.3 and 5.4.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations

import sympy as sp

from lagrange.core.records import record

ZERO = sp.S.Zero
Three = tuple[sp.Expr, sp.Expr, sp.Expr]
NO_PRODUCTS = (ZERO, ZERO, ZERO)


@record
class InertiaTensor:
    """J: its diagonal, and its off-diagonal elements J_23, J_31, J_12."""

    moments: Three
    products: Three = NO_PRODUCTS

    @property
    def is_zero(self) -> bool:
        """Whether no element is different from 0."""
        return all(e == 0 for e in (*self.moments, *self.products))

    @property
    def is_principal(self) -> bool:
        """Whether the axes are principal axes."""
        return all(e == 0 for e in self.products)

    @property
    def is_isotropic(self) -> bool:
        """Whether every axis is a principal axis with the same moment."""
        return self.is_principal and len(set(self.moments)) == 1

    @property
    def symmetry_axis(self) -> int:
        """The number of the axis about which the moments of a body of revolution are equal; 2 for any other body."""
        a, b, c = self.moments
        return 1 if a == c != b else 0 if b == c != a else 2

    @property
    def rows(self) -> tuple[Three, Three, Three]:
        """The matrix."""
        (a, b, c), (d, e, f) = self.moments, self.products
        return (a, f, e), (f, b, d), (e, d, c)

    def times(self, w: Sequence[sp.Expr]) -> Three:
        """J w."""
        a, b, c = (sp.Add(*(j * x for j, x in zip(row, w, strict=True))) for row in self.rows)
        return a, b, c

    def form(self, u: Sequence[sp.Expr], w: Sequence[sp.Expr]) -> sp.Expr:
        """u·J w."""
        return sp.Add(*(x * y for x, y in zip(u, self.times(w), strict=True)))

    def energy(self, w: Sequence[sp.Expr]) -> sp.Expr:
        """½ w·J w, squares first: ½ A w_1² + ... + J_23 w_2 w_3 + ..."""
        squares = (moment * x**2 / 2 for moment, x in zip(self.moments, w, strict=True) if moment != 0)
        (d, e, f), (x, y, z) = self.products, w
        return sp.Add(*squares, *(j * p for j, p in ((d, y * z), (e, z * x), (f, x * y)) if j != 0))

    def turned_with(self, w: Sequence[sp.Expr]) -> tuple[sp.Expr, ...]:
        """The six elements of dJ/dt = [w] J − J [w], for a body that turns with w relative to the axes."""
        x, y, z = w
        cross = sp.Matrix([[0, -z, y], [z, 0, -x], [-y, x, 0]])
        matrix = sp.Matrix(self.rows)
        changed = cross * matrix - matrix * cross
        return tuple(changed[m, n] for m in range(3) for n in range(m, 3))

    def completed(self) -> tuple[Three, tuple[Three, Three, Three]] | None:
        """d and L with J = Lᵀ diag(d) L, L with ones on its diagonal and zeros below: ½ Σ d_a (L w)_a². None: singular.

        Squares completed as Lagrange does, without taking roots.
        """
        rest = sp.Matrix(self.rows)
        lower, weights = sp.eye(3), []
        for k in range(3):
            pivot = sp.together(rest[k, k])
            weights.append(pivot)
            for n in range(k + 1, 3):
                if rest[k, n] == 0:
                    continue
                if pivot == 0:
                    return None
                lower[k, n] = sp.together(rest[k, n] / pivot)
            for m in range(k + 1, 3):
                for n in range(k + 1, 3):
                    rest[m, n] = sp.together(rest[m, n] - lower[k, m] * pivot * lower[k, n])
        a, b, c = weights
        first, second, third = ((lower[k, 0], lower[k, 1], lower[k, 2]) for k in range(3))
        return (a, b, c), (first, second, third)


def principal_minors(matrix: sp.Matrix) -> Iterator[sp.Expr]:
    """All principal minors, the short ones first: a symmetric matrix is positive semidefinite if none is negative."""
    for size in range(1, matrix.rows + 1):
        for kept in combinations(range(matrix.rows), size):
            yield sp.expand(matrix.extract(list(kept), list(kept)).det(method="berkowitz"))


def moments_of_mass(inertia: InertiaTensor) -> sp.Matrix:
    """∫ x_a x_b dm, shape (3, 3)."""
    matrix = sp.Matrix(inertia.rows)
    return sp.eye(3) * matrix.trace() / 2 - matrix
