"""Orbits in the field of a centre, as functions of the angle.

Where r² φ' = h is constant and r'' = c r φ'² + F(r), the second derivative of u = 1/r by φ is −c u − F(1/u)/(h² u²)
(Binet). For attractions like 1/r², like 1/r³ and their sums this is α − k u, which is solved in closed form:

    u = α/k + (u_0 − α/k) cos(√k ψ) + (w_0/√k) sin(√k ψ) ,    ψ = φ − φ_0 ,    w_0 = du/dφ at the start = −r_0'/h

with the hyperbolic functions for k < 0, and a polynomial for k = 0. The state follows from it at any angle,
r' = −h du/dφ and φ' = h u². The solution is substituted back.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import permutations

import sympy as sp

from lagrange.algebra.closed_forms.polynomial_roots import factored_quotient, square_root
from lagrange.algebra.closed_forms.shortest_form import shortest_form
from lagrange.algebra.closed_forms.signs import SignCondition, more_than_zero
from lagrange.algebra.exact.zero_test import DivisionByZeroError, is_zero
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import base, prime, t
from lagrange.mechanics.questions.limits import LONGEST_INTEGRATED
from lagrange.mechanics.questions.results import InverseRadius
from lagrange.mechanics.questions.times import times

Symbols = Mapping[sp.Symbol, sp.Expr]
SignIn = Callable[[sp.Expr], int | None]


@record
class Orbit:
    """1/r as a function of φ.

    inverse   u, with its equation
    slope     du/dφ
    start     φ_0
    momentum  h = r² φ'
    """

    inverse: InverseRadius
    slope: sp.Expr
    start: sp.Expr
    momentum: sp.Expr

    @property
    def angle(self) -> sp.Symbol:
        """φ."""
        return self.inverse.angle

    @property
    def state(self) -> dict[sp.Symbol, sp.Expr]:
        """r, r' and φ' as functions of φ."""
        r, u = self.inverse.radius, self.inverse.value
        return {
            r: self.written(1 / u),
            prime(r): self.written(-self.momentum * self.slope),
            prime(self.angle): self.written(self.momentum * u**2),
        }

    @staticmethod
    def written(value: sp.Expr) -> sp.Expr:
        """A value in the form in which it is printed."""
        return shortest_form(factored_quotient(value))

    def values(
        self, quantity: sp.Expr, when: sp.Expr, by_angle: bool, sign: SignIn
    ) -> Iterator[tuple[sp.Expr, Symbols, tuple[SignCondition, ...]]]:
        """A quantity where a condition holds, or as a function of the angle, each with the state and its conditions."""
        quantity = quantity.xreplace(self.state)
        if by_angle:
            yield self.written(quantity), self.state, ()
            return
        for place, conditions in self.places(when, sign) or ():
            at = {self.angle: place}
            state = {s: e.xreplace(at) for s, e in self.state.items()} | at
            yield self.written(quantity.xreplace(at)), state, conditions

    def places(self, when: sp.Expr, sign: SignIn) -> list[tuple[sp.Expr, tuple[SignCondition, ...]]] | None:
        """The angles at which a condition on the state holds first, with the conditions under which the orbit gets
        there; None if they are not found.
        """
        sense = sign(self.momentum)
        if sense not in (1, -1):
            return None
        on_orbit = when.xreplace(self.state)
        roots = times(on_orbit.xreplace({self.angle: self.start + sense * t}))
        found = [(self.start + sense * r.value, r.conditions) for r in roots or ()]
        lasting = [(place, conditions, self.lasts(place, sign)) for place, conditions in found]
        if not lasting or any(more is None for _, _, more in lasting):
            return None
        return [(place, (*conditions, *(more or ()))) for place, conditions, more in lasting]

    def lasts(self, end: sp.Expr, sign: SignIn) -> tuple[SignCondition, ...] | None:
        """The conditions under which the orbit gets to an angle; None if it does not, or that is not known."""
        sense = sign(self.momentum)
        if sense not in (1, -1) or sign(end - self.start) != sense:
            return None
        u, places = self.inverse, ({self.angle: self.start}, {self.angle: end})
        first, there = (factored_quotient(u.value.xreplace(at)) for at in places)
        slopes = [sign(factored_quotient(sense * self.slope.xreplace(at))) for at in places]
        is_wave = sign(u.stiffness) == 1
        if is_wave:
            margin = 2 * u.constant * first - u.stiffness * first**2 - self.slope.xreplace(places[0]) ** 2
            if sign(u.constant) == 1 and sign(factored_quotient(margin)) == 1:
                return ()  # bound: u has no zero at any angle
            if sign(sp.pi - sense * (end - self.start) * square_root(u.stiffness)) not in (0, 1):
                return None
        # Over half a period u has one extreme at most: without a minimum on the way it is smallest at an end.
        has_no_minimum = slopes[0] in (0, 1) or (slopes[0] == -1 and slopes[1] in (0, -1))
        if not has_no_minimum and (is_wave or sign(u.constant) != 0):
            return None
        known = sign(there)
        return None if known in (0, -1) else () if known == 1 else (more_than_zero(there),)


def orbit(accelerations: Symbols, initial: Symbols, coordinates: Sequence[sp.Symbol], sign: SignIn) -> Orbit | None:
    """The orbit of a motion in a plane round a centre; None if it is no such motion, or no such field."""
    for r, phi in permutations(coordinates, 2):
        found = _orbit(r, phi, accelerations, initial, sign)
        if found is not None:
            return found
    return None


def _orbit(r: sp.Symbol, phi: sp.Symbol, accelerations: Symbols, initial: Symbols, sign: SignIn) -> Orbit | None:
    radial, around = accelerations.get(prime(r, 2)), accelerations.get(prime(phi, 2))
    v, w, state = prime(r), prime(phi), {r, phi, prime(r), prime(phi)}
    if radial is None or around is None or not state <= initial.keys() or t in radial.free_symbols:
        return None
    if any(count_operations(e) > LONGEST_INTEGRATED for e in (radial, around)):
        return None
    if is_zero(around * r + 2 * v * w) is not True or not radial.is_polynomial(w):
        return None
    turning = sp.cancel(radial.coeff(w, 2) / r) if radial.is_Add else sp.cancel(sp.expand(radial).coeff(w, 2) / r)
    force = sp.cancel(sp.expand(radial - turning * r * w**2))
    others = {s for s in (force.free_symbols | turning.free_symbols) if _moves(s, accelerations)}
    if not others <= {r} or turning.free_symbols & {r}:
        return None
    momentum = factored_quotient(initial[r] ** 2 * initial[w])
    u = sp.Dummy("u", positive=True)
    if is_zero(momentum) is not False:
        return None
    bending = sp.cancel(-turning * u - force.xreplace({r: 1 / u}) / (momentum**2 * u**2))
    if not bending.is_polynomial(u) or sp.degree(bending, u) > 1:
        return None
    constant, k = (factored_quotient(way * sp.expand(bending).coeff(u, n)) for n, way in ((0, 1), (1, -1)))
    ends = initial[phi], 1 / initial[r], factored_quotient(-initial[v] / momentum)
    inverse = _solved(constant, k, phi, ends, sign(k))
    if inverse is None:
        return None
    slope = inverse.diff(phi)
    speed = momentum * inverse**2
    residuals = (
        -momentum * slope.diff(phi) * speed - (turning * r * speed**2 + force).xreplace({r: 1 / inverse}),
        inverse.xreplace({phi: initial[phi]}) - ends[1],
        slope.xreplace({phi: initial[phi]}) - ends[2],
    )
    try:
        if any(is_zero(e) is not True for e in residuals):
            return None
    except DivisionByZeroError:
        return None
    return Orbit(InverseRadius(r, phi, constant, k, inverse), slope, initial[phi], momentum)


def _moves(s: sp.Symbol, accelerations: Symbols) -> bool:
    return prime(base(s), 2) in accelerations


def _solved(
    constant: sp.Expr, k: sp.Expr, phi: sp.Symbol, ends: tuple[sp.Expr, sp.Expr, sp.Expr], sense: int | None
) -> sp.Expr | None:
    """The solution of d²u/dφ² = α − k u; None if the sign of k is not known.

    ends  φ_0, u_0 and du/dφ there
    """
    start, first, slope = ends
    angle = phi - start
    if sense is None:
        return None
    if sense == 0:
        return first + slope * angle + constant * angle**2 / 2
    rate = square_root(sense * k)
    wave, other = (sp.cos, sp.sin) if sense == 1 else (sp.cosh, sp.sinh)
    mean = factored_quotient(constant / k)
    size, share = factored_quotient(first - mean), factored_quotient(slope / rate)
    return mean + size * wave(rate * angle) + share * other(rate * angle)
