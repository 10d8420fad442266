"""Kinetic and potential energy, momenta, and the forces that have no potential.

    T = Σ m v·v/2 + Σ H·ω/2 ,   p_k = ∂T/∂q_k' ,   Q_k = −∂V/∂q_k + Q'_k ,   L = T − V

V is that of the springs, of the potentials that the file gives, of constant forces (−F·r), and of forces that depend on
the position only and are the gradient of something that the table of integrals has. All else is in Q'_k: dampers,
friction, forces that depend on velocities or time. With T = T2 + T1 + T0 by degree in the velocities,

    E = T + V ,     h = Σ p_k q_k' − L = T2 − T0 + V        (Jacobi) ,

which are the same where no position depends on time but through the coordinates.
Reference: Pars, A Treatise on Analytical Dynamics, §§ 6.7-6.8.
"""

from __future__ import annotations

from collections.abc import Collection
from fractions import Fraction
from functools import cached_property

import sympy as sp

from lagrange.algebra.fourier.common_factor import as_term
from lagrange.algebra.fourier.packing import unpack
from lagrange.algebra.fourier.terms import Exponent, Term, common_powers, divided, multiplied, sum_of
from lagrange.algebra.fourier.textbook import Textbook
from lagrange.algebra.fourier.trigonometry import Element, Ring
from lagrange.core.records import record
from lagrange.core.symbols import Slots, base, t
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.conservative import are_true_coordinates, dot, is_constant_force, of_the_rest


@record
class EnergyFunctions:
    """The energies of a configuration, as elements of the ring of `textbook`.

    kinetic    T
    potential  V, but for `given`
    given      the potentials of springs and of the file, as they are written
    forces     shape (n,): Q'_k
    damping    Σ c d'², where the power of the dampers is less than nothing by that; 0 where an end moves by itself
    hidden     whether some of Q' is the gradient of a potential that was not found
    """

    configuration: Configuration
    textbook: Textbook
    kinetic: Element
    potential: Element
    given: sp.Expr
    forces: tuple[Element, ...]
    damping: sp.Expr
    hidden: bool

    @property
    def ring(self) -> Ring:
        """Where the elements are."""
        return self.textbook.ring

    @property
    def slots(self) -> Slots:
        """The coordinates."""
        return self.configuration.slots

    @cached_property
    def lagrangian(self) -> Element:
        """L = T − V."""
        return self.kinetic - self._whole_potential

    @cached_property
    def are_quasi(self) -> bool:
        """Whether coordinates may be quasi-coordinates."""
        return not are_true_coordinates(self.configuration)

    @cached_property
    def momenta(self) -> tuple[Element, ...]:
        """p_k = ∂T/∂q_k', shape (n,)."""
        return tuple(self.ring.partial(v)(self.kinetic) for v in self.slots.velocities)

    @cached_property
    def powers(self) -> tuple[Element, Element]:
        """Σ p_k q_k' = 2 T2 + T1, and what it lacks of 2 T: T1 + 2 T0."""
        velocities = [self.ring.from_sympy(v) for v in self.slots.velocities]
        moved = self.ring.dot(self.momenta, velocities)
        return moved, 2 * self.kinetic - moved

    @property
    def has_motion_of_its_own(self) -> bool:
        """Whether T1 or T0 is there: positions depend on time explicitly."""
        return not self.ring.is_zero(self.powers[1])

    @cached_property
    def lagrangian_forces(self) -> tuple[Element, ...]:
        """∂L/∂q_k + Q'_k, shape (n,): what p_k' is but for the reactions."""
        slopes = (self.ring.partial(q)(self.lagrangian) for q in self.slots.coordinates)
        return tuple(a + b for a, b in zip(slopes, self.forces, strict=True))

    @cached_property
    def jacobi_rate(self) -> Element:
        """dh/dt = Σ Q'_k q_k' − ∂L/∂t, but for the reactions."""
        velocities = [self.ring.from_sympy(v) for v in self.slots.velocities]
        return self.ring.dot(self.forces, velocities) - self.ring.frozen_derivative(self.slots)(self.lagrangian)

    @cached_property
    def energy_rate(self) -> Element:
        """dE/dt = dh/dt + d(T1 + 2 T0)/dt, but for the reactions."""
        return self.jacobi_rate + self.ring.time_derivative(self.slots)(self.powers[1])

    @cached_property
    def energy(self) -> sp.Expr:
        """E = T + V as it is written down, without constants."""
        return sp.Add(self.changing(self.kinetic + self.potential), self.given)

    @cached_property
    def jacobi(self) -> sp.Expr:
        """h as it is written down, without constants."""
        return self.jacobi_less(sp.S.Zero)

    def jacobi_less(self, gauge: sp.Expr) -> sp.Expr:
        """h − G as it is written down, without constants."""
        h = self.powers[0] - self.kinetic + self.potential
        return sp.Add(self.changing(h - self.ring.from_sympy(gauge)), self.given)

    def form(self, element: Element) -> sp.Expr:
        """The textbook form, terms with the same constants in brackets: m (x'² + y'²)/2, m (x y' − y x')."""
        return _gathered(self.textbook.form(element), self._moving)

    @property
    def _moving(self) -> set[sp.Symbol]:
        """What is not constant."""
        return {*self.slots.coordinates, *self.slots.prescribed, t}

    def changing(self, element: Element) -> sp.Expr:
        """The textbook form without constants."""
        varying = _varying(element, self._moving)
        written = self.form(varying)
        doubled = _doubled(written)
        if len(varying) < len(element) and doubled:
            whole = sp.Add(*(e for e in sp.Add.make_args(self.form(element)) if _moves(e, self._moving)))
            written = written if whole.has(*doubled) else whole
        return written

    @property
    def has_potential(self) -> bool:
        """Whether V is not constant."""
        return self.given != 0 or bool(_varying(self.potential, self._moving))

    @property
    def _whole_potential(self) -> Element:
        return self.potential + self.ring.from_sympy(self.given)


def energy_functions(
    configuration: Configuration, textbook: Textbook, frictions: Collection[str] = ()
) -> EnergyFunctions:
    """The energies of a configuration.

    textbook   of d'Alembert's principle there, whose ring knows most of what is needed
    frictions  the names of forces that are friction, which has no potential even where it is constant
    """
    ring = textbook.ring
    springs = sp.Add(*(s.energy for s in configuration.springs))
    fields = configuration.potential - springs
    steady = [f for f in configuration.loads if f.name not in frictions and is_constant_force(f, configuration)]
    potential = ring.zero - ring.total(dot(f.vector, f.point, ring) for f in steady)
    loads = [f for f in configuration.loads if f not in steady]
    others, forces, hidden = of_the_rest(configuration, loads, frictions, ring)
    potential = potential + ring.from_sympy(others)
    if configuration.expressed:
        potential, fields = potential + ring.from_sympy(fields), sp.S.Zero
    return EnergyFunctions(
        configuration=configuration,
        textbook=textbook,
        kinetic=_kinetic(configuration, ring),
        potential=potential,
        given=sp.Add(springs, fields),
        forces=forces,
        damping=_damping(configuration),
        hidden=hidden,
    )


def _damping(configuration: Configuration) -> sp.Expr:
    slots = configuration.slots
    if any(slots.frozen_derivative(d.distance) != 0 for d in configuration.dampers):
        return sp.S.Zero
    return sp.Add(*(d.coefficient * d.rate**2 for d in configuration.dampers))


def _doubled(e: sp.Expr) -> list[sp.Expr]:
    """The functions of multiples of one angle, which stand for squares less constants: 2 sin² θ = 1 − cos 2θ."""
    return [f for f in e.atoms(sp.sin, sp.cos) if f.args[0].as_coeff_Mul()[0] not in (1, -1) and not f.args[0].is_Add]


def _varying(element: Element, moving: set[sp.Symbol]) -> Element:
    """The element without what is constant."""
    basis = element.basis

    def is_constant(monomial: int, frequency: int) -> bool:
        parts = [basis.generators[i].expression for i, _ in unpack(monomial)]
        parts += [basis.angles[i] for i, _ in unpack(frequency)]
        return not any(_moves(e, moving) for e in parts)

    kept = {key: value for key, value in element.terms.items() if not is_constant(*key)}
    return basis.element(kept, element.denominator)


def _moves(e: sp.Expr, moving: set[sp.Symbol]) -> bool:
    return any(base(s) in moving for s in e.free_symbols)


def _gathered(e: sp.Expr, moving: set[sp.Symbol]) -> sp.Expr:
    """Terms that have the same constants but for the sign as one product with a bracket."""
    groups: dict[tuple[Fraction, frozenset[tuple[sp.Expr, Exponent]]], list[Term]] = {}
    for summand in sp.Add.make_args(e):
        term = as_term(summand)
        constants = frozenset((f, n) for f, n in term.factors.items() if not _moves(f, moving))
        groups.setdefault((abs(term.number), constants), []).append(term)
    found = []
    for (number, constants), terms in groups.items():
        if len(terms) == 1 or not (constants or number != 1):
            found += [term.to_sympy() for term in terms]
            continue
        common = common_powers([term.factors for term in terms])
        sign = 1 if sum(1 if term.number > 0 else -1 for term in terms) > 0 else -1
        first = terms[0].number / number
        sign = sign if sum(term.number for term in terms) else int(first)
        rest = sum_of(Term(sign * term.number / number, divided(term.factors, common)) for term in terms)
        found.append(Term(sign * number, multiplied(common, {rest: 1})).to_sympy())
    return sp.Add(*found)


def _kinetic(configuration: Configuration, ring: Ring) -> Element:
    terms = [ring.from_sympy(p.mass) * dot(p.velocity, p.velocity, ring) for p in configuration.points if p.mass != 0]
    terms += [dot(r.momentum, r.angular_velocity, ring) for r in configuration.rotations if r.has_inertia]
    return ring.total(terms) / 2


def in_one_term(rate: sp.Expr) -> sp.Expr:
    """−x'² D/v − y'² D/v as −v D, with v = √(x'² + y'²); what has no root below the line as it is."""
    if not any(p.exp.is_negative and not p.exp.is_Integer for p in rate.atoms(sp.Pow)):
        return rate
    joined: sp.Expr = sp.factor_terms(rate)
    return joined if joined.count_ops() < rate.count_ops() else rate
