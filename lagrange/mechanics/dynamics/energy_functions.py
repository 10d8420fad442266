"""Kinetic and potential energy, momenta, and the forces without a potential.

    T = Σ m v·v/2 + Σ H·ω/2 ,   p_k = ∂T/∂q_k' ,   Q_k = −∂V/∂q_k + Q'_k ,   L = T − V

V is the potential of the springs, of the given potentials, of constant forces at points that move with their body
(−F·r), and of the part of every other force that depends on neither velocity nor time, if ∂Q_i/∂q_k = ∂Q_k/∂q_i and the
table of integrals contains it: a magnetic force is separated from an electric one. Everything else is in Q'_k: dampers,
friction (even where it is constant), constant moments (no potential with one value at each position), forces that
depend on velocities or time.
With T = T2 + T1 + T0 by degree in the velocities,

    E = T + V ,     h = Σ p_k q_k' − L = T2 − T0 + V        (Jacobi) ,

which are equal if positions depend on time through the coordinates only.
Reference: Pars, A Treatise on Analytical Dynamics, §§ 6.7-6.8.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from fractions import Fraction
from functools import cache, cached_property
from itertools import combinations

import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.algebra.forms.exact_forms import potential_of, varies
from lagrange.algebra.fourier.polynomials import unpack
from lagrange.algebra.fourier.ring import Element, FourierRing
from lagrange.algebra.fourier.terms import (
    Exponent,
    PowerProduct,
    as_term,
    common_powers,
    multiplied,
    quotient_of_powers,
    sum_of,
)
from lagrange.algebra.fourier.textbook_form import Textbook
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import Slots, base, t
from lagrange.mechanics.constraints.kinematics import Configuration, Load
from lagrange.mechanics.constraints.variable_mass import REACTIVE
from lagrange.mechanics.dynamics.principle import dot


def are_true_coordinates(configuration: Configuration) -> bool:
    """Whether H·(ω_k' − ∂ω/∂q_k) = 0 for bodies with a given ω, components along the axes differentiated.

    Otherwise coordinates are quasi-coordinates, for which Lagrange's equations do not hold.
    """
    slots = configuration.slots
    for r in configuration.rotations:
        if not r.given:
            continue
        spin = r.angular_velocity.fixed()
        along = [spin.dot(e) for e in r.axes]
        for q, v in zip(slots.coordinates, slots.velocities, strict=True):
            part = spin.map(lambda c, v=v: c.diff(v)).time_derivative(slots)  # type: ignore[misc]
            momenta = r.inertia.times(along)
            bending = (h * (part.dot(e) - w.diff(q)) for h, w, e in zip(momenta, along, r.axes, strict=True))
            if configuration.states.is_zero(sp.Add(*bending)) is not True:
                return False
    return True


def is_constant_force(load: Load, configuration: Configuration, ring: FourierRing) -> bool:
    """Whether a force has the potential −F·r: it is constant, acts at a point that is a function of true coordinates,
    and −∂(F·r)/∂q_k is its generalized force.

    That fails where the point of application is not one of the body's own: a cord that leaves a disc at R i, however
    the disc is turned, has F·r = const, and Q_φ = R F.
    """
    moving = {*configuration.slots.coordinates, *configuration.slots.prescribed, t}
    if any(base(s) in moving for c in load.vector.fixed().components for s in c.free_symbols):
        return False
    turning = next((r for r in configuration.rotations if r.name == load.on), None)
    if turning is None:
        return True
    if turning.given:
        [centre] = (p.position for p in configuration.points if p.name == load.on)
        return (load.point - centre).is_zero
    slopes = (dot(load.vector, load.point.partial(q), ring) for q in configuration.slots.coordinates)
    forces = _generalized(load, configuration, ring)
    return all(ring.is_zero(slope - force) for slope, force in zip(slopes, forces, strict=True))


def of_the_rest(
    configuration: Configuration, loads: Sequence[Load], frictions: Collection[str], ring: FourierRing
) -> tuple[sp.Expr, tuple[Element, ...], bool]:
    """The potential of position-dependent loads, Q'_k of the rest, and whether the rest hides a potential not found.

    Loads without a potential one by one may have one together, and are tried again as a sum. A constant moment has no
    potential with one value at each position.
    """
    coordinates = configuration.slots.coordinates
    n = len(coordinates)
    varying = {m.name for m in configuration.variable_masses if t in m.mass.free_symbols}
    powerless = [f.name in frictions or (f.name == "weight" and f.on in varying) for f in loads]
    each = [_generalized(f, configuration, ring) for f, without in zip(loads, powerless, strict=True) if not without]
    without_potential = [
        _generalized(f, configuration, ring) for f, without in zip(loads, powerless, strict=True) if without
    ]
    for moment in configuration.torques:
        [turning] = (r for r in configuration.rotations if r.name == moment.on)
        q = tuple(dot(moment.vector, partial, ring) for partial in turning.partials)
        steady = all(ring.free_symbols(f).isdisjoint(coordinates) for f in q)
        (without_potential if steady else each).append(q)
    potential, hidden = sp.S.Zero, False
    waiting: list[tuple[Element, ...]] = []
    for q in each:
        static, rest = _apart(q, configuration, ring)
        without_potential.append(rest)
        v = _potential(static, configuration, ring)
        if v is None:
            waiting.append(static)
        else:
            potential += v
    together = _sum(waiting, n, ring)
    if waiting and _is_closed(together, configuration, ring):
        v = _potential(together, configuration, ring)
        potential, hidden = (potential, True) if v is None else (potential + v, False)
        without_potential += [together] if v is None else []
    else:
        without_potential.append(together)
    without_potential += [
        tuple(-(ring.from_sympy(d.pull) * ring.from_sympy(d.distance.diff(q))) for q in coordinates)
        for d in configuration.dampers
    ]
    return potential, _sum(without_potential, n, ring), hidden


def _apart(
    forces: tuple[Element, ...], configuration: Configuration, ring: FourierRing
) -> tuple[tuple[Element, ...], tuple[Element, ...]]:
    """The part that depends on neither velocities nor time, and the rest."""
    slots = configuration.slots
    static = []
    for f in forces:
        kept = ring.zero
        for part in f.by_monomial().values():
            symbols = ring.free_symbols(part)
            if all(s != t and base(s) == s and s not in slots.prescribed for s in symbols):
                kept = kept + part
        static.append(kept)
    return tuple(static), tuple(f - k for f, k in zip(forces, static, strict=True))


def _sum(parts: list[tuple[Element, ...]], size: int, ring: FourierRing) -> tuple[Element, ...]:
    return tuple(ring.total(p[k] for p in parts) for k in range(size))


def _generalized(load: Load, configuration: Configuration, ring: FourierRing) -> tuple[Element, ...]:
    """F·∂r/∂q_k, and on a body F·∂r_G/∂q_k + (arm × F)·ω_k, shape (n,)."""
    coordinates = configuration.slots.coordinates
    turning = next((r for r in configuration.rotations if r.name == load.on), None)
    if turning is None:
        return tuple(dot(load.vector, load.point.partial(q), ring) for q in coordinates)
    [centre] = (p for p in configuration.points if p.name == load.on)
    moment = (load.point - centre.position).cross(load.vector)
    return tuple(
        dot(load.vector, centre.partials[k], ring) + dot(moment, turning.partials[k], ring)
        for k in range(len(coordinates))
    )


def _is_closed(forces: tuple[Element, ...], configuration: Configuration, ring: FourierRing) -> bool:
    """Whether ∂Q_i/∂q_k = ∂Q_k/∂q_i, for functions Q of the position."""
    if any(forces) and not are_true_coordinates(configuration):
        return False
    coordinates = configuration.slots.coordinates
    if any(f.to_sympy().has(sp.sign, sp.Abs) for f in forces):
        return _is_closed_across_jumps([f.to_sympy() for f in forces], coordinates)
    return all(
        ring.is_zero(ring.partial(b)(forces[k]) - ring.partial(a)(forces[n]))
        for k, a in enumerate(coordinates)
        for n, b in enumerate(coordinates[:k])
    )


def _is_closed_across_jumps(forces: Sequence[sp.Expr], coordinates: Sequence[sp.Symbol]) -> bool:
    """Whether forces with signs and moduli are closed: −c sgn(x − y) and c sgn(x − y) are, c sgn y and 0 are not.

    The derivative of sgn u has 2 δ(u) u', whose coefficients must agree as well.
    """
    for (k, a), (n, b) in combinations(enumerate(coordinates), 2):
        difference = forces[k].diff(b) - forces[n].diff(a)
        signs = {e.args[0]: sp.Dummy() for e in difference.atoms(sp.sign, sp.Abs)}
        letters: dict[sp.Basic, sp.Expr] = {sp.sign(u): s for u, s in signs.items()}
        letters |= {sp.Abs(u): u * s for u, s in signs.items()}
        letters |= {jump: sp.Dummy() for jump in difference.atoms(sp.DiracDelta)}
        if is_zero(difference.xreplace(letters)) is not True:
            return False
    return True


def _potential(forces: tuple[Element, ...], configuration: Configuration, ring: FourierRing) -> sp.Expr | None:
    """V with −∂V/∂q_k = Q_k; None if the Q_k are not a gradient, or V is not found."""
    if not any(forces):
        return sp.S.Zero
    if not _is_closed(forces, configuration, ring):
        return None
    slots = configuration.slots
    return potential_of([-f.to_sympy() for f in forces], slots.coordinates, slots)


@record
class EnergyFunctions:
    """The energies of a configuration, as elements of the ring of `textbook`.

    kinetic    T
    moving     what L has beside T − V: terms with velocities
    potential  V without `given`
    given      the potentials of springs and of the file, as they are written
    forces     shape (n,): Q'_k
    damping    Σ c d'², if that is the power dissipated by the dampers; 0 if an end has a prescribed motion
    hidden     whether part of Q' is the gradient of a potential that was not found
    """

    configuration: Configuration
    textbook: Textbook
    kinetic: Element
    moving: Element
    potential: Element
    given: sp.Expr
    forces: tuple[Element, ...]
    damping: sp.Expr
    hidden: bool

    @property
    def ring(self) -> FourierRing:
        """The ring of the elements."""
        return self.textbook.ring

    @property
    def slots(self) -> Slots:
        """The coordinates."""
        return self.configuration.slots

    @cached_property
    def lagrangian(self) -> Element:
        """L = T − V, and the terms with velocities."""
        return self.kinetic + self.moving - self._total_potential

    @cached_property
    def are_quasi(self) -> bool:
        """Whether coordinates may be quasi-coordinates."""
        return not are_true_coordinates(self.configuration)

    @cached_property
    def momenta(self) -> tuple[Element, ...]:
        """p_k = ∂L/∂q_k', shape (n,)."""
        return tuple(self.ring.partial(v)(self.kinetic + self.moving) for v in self.slots.velocities)

    @cached_property
    def moving_energy(self) -> Element:
        """Σ q_k' ∂X/∂q_k' − X of the terms X with velocities: their share of the energy, 0 where X is linear in q'."""
        slopes = [self.ring.partial(v)(self.moving) for v in self.slots.velocities]
        return self.ring.dot(slopes, [self.ring.from_sympy(v) for v in self.slots.velocities]) - self.moving

    @cached_property
    def powers(self) -> tuple[Element, Element]:
        """Σ (∂T/∂q_k') q_k' = 2 T2 + T1, and 2 T minus that: T1 + 2 T0."""
        try:
            degrees = self.ring.by_degree(self.kinetic, self.slots.velocities)
        except ValueError:
            velocities = [self.ring.from_sympy(v) for v in self.slots.velocities]
            momenta = [self.ring.partial(v)(self.kinetic) for v in self.slots.velocities]
            power = self.ring.dot(momenta, velocities)
        else:
            power = self.ring.total(degree * part for degree, part in degrees.items())  # Euler's theorem
        return power, 2 * self.kinetic - power

    @property
    def has_motion_of_its_own(self) -> bool:
        """Whether T contains T1 or T0: positions depend on time explicitly."""
        return not self.ring.is_zero(self.powers[1])

    @cached_property
    def lagrangian_forces(self) -> tuple[Element, ...]:
        """∂L/∂q_k + Q'_k, shape (n,): p_k' without the reactions."""
        slopes = (self.ring.partial(q)(self.lagrangian) for q in self.slots.coordinates)
        return tuple(a + b for a, b in zip(slopes, self.forces, strict=True))

    @cached_property
    def forces_at_rest(self) -> tuple[Element, ...]:
        """The terms of ∂L/∂q_k + Q'_k without velocities, shape (n,): few where those with velocities are thousands.

        Raises ValueError if a velocity occurs under a root, in a denominator or in a function.
        """
        ring, velocities = self.ring, self.slots.velocities
        at_rest, *forces = (ring.by_degree(e, velocities).get(0, ring.zero) for e in (self.lagrangian, *self.forces))
        return tuple(ring.partial(q)(at_rest) + f for q, f in zip(self.slots.coordinates, forces, strict=True))

    def is_cyclic(self, coordinate: int) -> bool:
        """Whether ∂L/∂q_k + Q'_k is zero."""
        try:
            if self.forces_at_rest[coordinate]:
                return False
        except ValueError:
            pass
        return not self.lagrangian_forces[coordinate]

    @cached_property
    def jacobi_rate(self) -> Element:
        """dh/dt = Σ Q'_k q_k' − ∂L/∂t, without the reactions."""
        velocities = [self.ring.from_sympy(v) for v in self.slots.velocities]
        return self.ring.dot(self.forces, velocities) - self.ring.frozen_derivative(self.slots)(self.lagrangian)

    @cached_property
    def energy_rate(self) -> Element:
        """dE/dt = dh/dt + d(T1 + 2 T0)/dt, without the reactions."""
        return self.jacobi_rate + self.ring.time_derivative(self.slots)(self.powers[1])

    @cached_property
    def energy(self) -> sp.Expr:
        """E = T + V in the form printed, without constants; with velocities in potentials, their share."""
        return sp.Add(self.changing(self.kinetic + self.moving_energy + self.potential), self.given)

    @cached_property
    def jacobi(self) -> sp.Expr:
        """h in the form printed, without constants."""
        return self.jacobi_less(sp.S.Zero)

    def jacobi_less(self, gauge: sp.Expr) -> sp.Expr:
        """h − G in the form printed, without constants."""
        h = self.powers[0] - self.kinetic + self.moving_energy + self.potential
        return sp.Add(self.changing(h - self.ring.from_sympy(gauge)), self.given)

    def form(self, element: Element) -> sp.Expr:
        """The textbook form, terms with the same constants in brackets: m (x'² + y'²)/2, m (x y' − y x')."""
        return _gathered(self.textbook.form(element), self._moving)

    @property
    def _moving(self) -> set[sp.Symbol]:
        """The symbols that are not constant."""
        return {*self.slots.coordinates, *self.slots.prescribed, t}

    def changing(self, element: Element) -> sp.Expr:
        """The textbook form without constants."""
        varying = _varying(element, self._moving)
        written = self.form(varying)
        doubled = _doubled(written)
        if len(varying) < len(element) and doubled:
            # 1 − cos 2θ without its constant would be −cos 2θ; with it, it is written 2 sin² θ.
            with_constants = sp.Add(*(e for e in sp.Add.make_args(self.form(element)) if varies(e, self._moving)))
            written = written if with_constants.has(*doubled) else with_constants
        return written

    @property
    def has_potential(self) -> bool:
        """Whether V is not constant."""
        return self.given != 0 or bool(_varying(self.potential, self._moving))

    @property
    def _total_potential(self) -> Element:
        return self.potential + self.ring.from_sympy(self.given)


def energy_functions(
    configuration: Configuration, textbook: Textbook, frictions: Collection[str] = ()
) -> EnergyFunctions:
    """The energies of a configuration.

    textbook   of d'Alembert's principle, whose ring already contains most expressions needed
    frictions  the names of the friction forces, which have no potential even if they are constant
    """
    ring = textbook.ring
    frictions = {*frictions, *(REACTIVE for _ in configuration.variable_masses[:1])}
    springs = sp.Add(*(s.energy for s in configuration.springs))
    fields = configuration.potential - springs
    steady = [f for f in configuration.loads if f.name not in frictions and is_constant_force(f, configuration, ring)]
    potential = ring.zero - ring.total(dot(f.vector, f.point, ring) for f in steady)
    loads = [f for f in configuration.loads if f not in steady]
    others, forces, hidden = of_the_rest(configuration, loads, frictions, ring)
    potential = potential + ring.from_sympy(others)
    if configuration.expressed:
        potential, fields = potential + ring.from_sympy(fields), sp.S.Zero
    if configuration.generalized:
        forces = tuple(f + ring.from_sympy(q) for f, q in zip(forces, configuration.generalized, strict=True))
    if configuration.mass_terms:
        forces = tuple(f + ring.from_sympy(q) for f, q in zip(forces, configuration.mass_terms, strict=True))
    return EnergyFunctions(
        configuration=configuration,
        textbook=textbook,
        kinetic=_kinetic(configuration, ring),
        moving=ring.from_sympy(configuration.velocity_part),
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
    return sp.Add(*(d.pull * d.rate for d in configuration.dampers))


def _doubled(e: sp.Expr) -> list[sp.Expr]:
    """The sines and cosines of multiples of an angle, which may be squares up to a constant: 2 sin² θ = 1 − cos 2θ."""
    return [f for f in e.atoms(sp.sin, sp.cos) if f.args[0].as_coeff_Mul()[0] not in (1, -1) and not f.args[0].is_Add]


def _varying(element: Element, moving: set[sp.Symbol]) -> Element:
    """The element without its constant terms."""
    basis = element.basis

    @cache
    def turns(index: int) -> bool:
        return varies(basis.angles[index], moving)

    @cache
    def moves(index: int) -> bool:
        return varies(basis.generators[index].expression, moving)

    def is_constant(monomial: int, frequency: int) -> bool:
        return not any(turns(i) for i, _ in unpack(frequency)) and not any(moves(i) for i, _ in unpack(monomial))

    kept = {key: value for key, value in element.terms.items() if not is_constant(*key)}
    return basis.element(kept, element.denominator)


def _gathered(e: sp.Expr, moving: set[sp.Symbol]) -> sp.Expr:
    """Terms with the same constants, up to the sign, as one product with a bracket."""
    groups: dict[tuple[Fraction, frozenset[tuple[sp.Expr, Exponent]]], list[PowerProduct]] = {}
    for summand in sp.Add.make_args(e):
        term = as_term(summand)
        constants = frozenset((f, n) for f, n in term.factors.items() if not varies(f, moving))
        groups.setdefault((abs(term.number), constants), []).append(term)
    gathered = []
    for (number, constants), terms in groups.items():
        if len(terms) == 1 or not (constants or number != 1):
            gathered += [term.to_sympy() for term in terms]
            continue
        common = common_powers([term.factors for term in terms])
        sign = 1 if sum(1 if term.number > 0 else -1 for term in terms) > 0 else -1
        first = terms[0].number / number
        sign = sign if sum(term.number for term in terms) else int(first)
        rest = sum_of(
            PowerProduct(sign * term.number / number, quotient_of_powers(term.factors, common)) for term in terms
        )
        gathered.append(PowerProduct(sign * number, multiplied(common, {rest: 1})).to_sympy())
    return sp.Add(*gathered)


def _kinetic(configuration: Configuration, ring: FourierRing) -> Element:
    terms = [ring.from_sympy(p.mass) * dot(p.velocity, p.velocity, ring) for p in configuration.points if p.mass != 0]
    terms += [dot(r.momentum, r.angular_velocity, ring) for r in configuration.rotations if r.has_inertia]
    return ring.total(terms) / 2


def in_one_term(rate: sp.Expr) -> sp.Expr:
    """−x'² D/v − y'² D/v as −v D, with v = √(x'² + y'²); unchanged without a root in a denominator."""
    if not any(p.exp.is_negative and not p.exp.is_Integer for p in rate.atoms(sp.Pow)):
        return rate
    joined: sp.Expr = sp.factor_terms(rate)
    return joined if count_operations(joined) < count_operations(rate) else rate
