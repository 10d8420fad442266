"""Hamilton's function and the canonical equations, and Routh's function.

With the generalized momenta p_k = ∂L/∂q_k', solved for the velocities,

    H(q, p, t) = Σ p_k q_k' − L ,      q_k' = ∂H/∂p_k ,      p_k' = −∂H/∂q_k + Q_k ,

where Q_k are the forces without potential. T = ½ q'ᵀ M q' + b·q' + T0 makes p = M q' + b, and

    H = ½ (p − b)ᵀ M⁻¹ (p − b) − T0 + V .

The quadratic form is written as books write it, as a sum of squares u²/(2d). With u = p − b and a pivot d = M_kk,
u_k²/(2d) is split off, the other u_i become u_i − (M_ik/d) u_k, and M is reduced accordingly. The cheapest pivots come
first: for a top, p_ψ²/(2C) + (p_φ − p_ψ cos θ)²/(2A sin² θ).

A coordinate is cyclic if H does not contain it, and no force Q acts along it: its momentum is constant. With the cyclic
velocities eliminated,

    R = L − Σ p_c q_c'      (cyclic c only)

is the Lagrangian of the other coordinates, the p_c in it being constants. Reference: Whittaker, §§ 38, 109.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import field, replace

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError, Surface
from lagrange.algebra.fourier.linear_systems import solved_linear, tidy_quotient
from lagrange.algebra.fourier.ring import FourierRing
from lagrange.algebra.fourier.textbook_form import Textbook, textbook_form
from lagrange.core.diagnostics import NotCoveredError
from lagrange.core.expression_size import count_operations
from lagrange.core.records import all_hold, record
from lagrange.core.symbols import free_letter, partial, prime, t
from lagrange.mechanics.constraints.displacements import Elimination, eliminate
from lagrange.mechanics.constraints.kinematics import Configuration, substituted_configuration
from lagrange.mechanics.dynamics.checks import Check, at_random_states
from lagrange.mechanics.dynamics.comparison import System, compare
from lagrange.mechanics.dynamics.energies import Energies, energies
from lagrange.mechanics.dynamics.equations import EquationsOfMotion
from lagrange.mechanics.dynamics.reactions import over_one_denominator
from lagrange.mechanics.equilibrium.relative_equilibrium import is_time
from lagrange.mechanics.limits import LONGEST_NONLINEAR
from lagrange.mechanics.momenta.reduced_form import rates_of_dependent

ZERO = sp.S.Zero


@record
class KineticSquare:
    """u²/(2 d), a term of the kinetic energy in terms of the momenta."""

    root: sp.Expr
    divisor: sp.Expr

    @property
    def expression(self) -> sp.Expr:
        """u²/(2 d)."""
        return sp.Mul(sp.Rational(1, 2), self.root**2, 1 / self.divisor)

    def derivative(self, symbol: sp.Symbol) -> sp.Expr:
        """∂/∂symbol, as (u/d) ∂u or, where d varies too, u (d ∂u − u ∂d/2)/d²."""
        u, d = self.root, self.divisor
        rate, change = partial(u, symbol), partial(d, symbol)
        if change == 0:
            return _factored(rate) * u / d if rate != 0 else ZERO
        return over_one_denominator(u * (_factored(d * rate - u * change / 2) / d**2))


@record
class Hamiltonian:
    """Hamilton's function of one set of free coordinates.

    motion      the equations of motion
    energies    T, V, p_k = ∂L/∂q_k' and Q_k
    momenta     shape (n,): the symbols p_k
    velocities  shape (n,): q_k' in terms of q, p, t
    squares     of the kinetic energy
    rest        V − T0, a function of q and t; all of H where the momenta are not linear in the velocities
    applied     shape (n,): Q_k in terms of q, p, t
    is_energy   whether H is T + V; None: undecided
    cyclic      the coordinates whose momenta are constant, by index
    routhian    R, if some coordinates are cyclic and others are not
    integrated  coordinates that constraints on velocities give, up to constants that occur nowhere
    """

    motion: EquationsOfMotion
    energies: Energies
    momenta: tuple[sp.Symbol, ...]
    velocities: tuple[sp.Expr, ...]
    squares: tuple[KineticSquare, ...]
    rest: sp.Expr
    applied: tuple[sp.Expr, ...]
    is_energy: bool | None
    cyclic: tuple[int, ...]
    routhian: sp.Expr | None
    integrated: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)

    @property
    def configuration(self) -> Configuration:
        """The configuration."""
        return self.motion.configuration

    @property
    def coordinates(self) -> tuple[sp.Symbol, ...]:
        """q_k."""
        return self.configuration.slots.coordinates

    @property
    def function(self) -> sp.Expr:
        """H."""
        return sp.Add(*(s.expression for s in self.squares), self.rest)

    @property
    def rates(self) -> tuple[sp.Expr, ...]:
        """p_k' = −∂H/∂q_k + Q_k, shape (n,)."""
        return tuple(
            sp.Add(*(-s.derivative(q) for s in self.squares), -textbook_form(partial(self.rest, q)), force)
            for q, force in zip(self.coordinates, self.applied, strict=True)
        )

    @property
    def depends_on_time(self) -> bool:
        """Whether H contains t or a prescribed motion."""
        return bool(self.function.free_symbols & {t, *_prescribed(self.configuration)})

    @property
    def is_conservative(self) -> bool:
        """Whether all forces have a potential."""
        return all(force == 0 for force in self.applied)


def hamiltonian(motion: EquationsOfMotion, taken: Collection[str]) -> Hamiltonian:
    """Hamilton's function of a motion in free coordinates.

    taken  names that momenta must not use

    Raises NotCoveredError if the coordinates are not free, or the momenta cannot be solved for the velocities.
    """
    known: Mapping[sp.Symbol, sp.Expr] = {}
    if motion.configuration.rows:
        names = ", ".join(f"`{r.name}`" for r in motion.configuration.rows)
        canonical = integrated(motion)
        if canonical is None:
            raise NotCoveredError(
                f"Hamilton's function in coordinates that are not free: {names} still acts on them, so it"
            )
        motion, known = canonical
    configuration = motion.configuration
    stated = energies(configuration)
    if stated.has_quasi_coordinates:
        raise NotCoveredError("Hamilton's function in quasi-coordinates")
    slots = configuration.slots
    letter = free_letter("p", "P", "p_gen", taken=taken, of=[q.name for q in slots.coordinates])
    momenta = tuple(sp.Symbol(f"{letter}_{q.name}", real=True) for q in slots.coordinates)
    mass = [[textbook_form(partial(p, v)) for v in slots.velocities] for p in stated.momenta]
    if any(not e.free_symbols.isdisjoint(slots.velocities) for row in mass for e in row):
        return _of_nonlinear_momenta(motion, stated, momenta, known)
    at_rest = dict.fromkeys(slots.velocities, ZERO)
    shifts = [textbook_form(p.xreplace(at_rest)) for p in stated.momenta]
    moved = [textbook_form(p - b) for p, b in zip(momenta, shifts, strict=True)]
    squares = completed_squares(mass, moved, configuration.states)
    solved = solved_linear(mass, moved, configuration.states)
    if squares is None or solved is None or None in solved:
        raise NotCoveredError("momenta that cannot be solved for the velocities: Hamilton's function")
    by_squares = (sp.Add(*(s.derivative(p) for s in squares)) for p in momenta)
    by_inverse = (over_one_denominator(v) for v in solved if v is not None)
    velocities = tuple(
        min(pair, key=lambda v: count_operations(v)) for pair in zip(by_squares, by_inverse, strict=True)
    )
    in_momenta = dict(zip(slots.velocities, velocities, strict=True))
    rest = sp.Add(stated.potential, -textbook_form(stated.kinetic.xreplace(at_rest)))
    applied = tuple(tidy_quotient(q.xreplace(in_momenta)) if q != 0 else ZERO for q in stated.applied)
    contained = sp.Add(*(s.expression for s in squares), rest).free_symbols
    cyclic = tuple(k for k, q in enumerate(slots.coordinates) if q not in contained and applied[k] == 0)
    function = sp.Add(*(s.expression for s in squares), rest)
    by_momenta = dict(zip(momenta, stated.momenta, strict=True))
    energy = sp.Add(stated.kinetic, stated.potential, stated.moving_energy)
    return Hamiltonian(
        motion,
        stated,
        momenta,
        velocities,
        squares,
        rest,
        applied,
        is_energy=configuration.states.is_zero(function.xreplace(by_momenta) - energy),
        cyclic=cyclic,
        routhian=_routhian(stated, momenta, mass, moved, cyclic) if 0 < len(cyclic) < len(momenta) else None,
        integrated=known,
    )


def _of_nonlinear_momenta(
    motion: EquationsOfMotion,
    stated: Energies,
    momenta: tuple[sp.Symbol, ...],
    known: Mapping[sp.Symbol, sp.Expr],
) -> Hamiltonian:
    """Hamilton's function of a Lagrangian with a root of the velocities, without squares."""
    slots, states = motion.configuration.slots, motion.configuration.states
    inverted = velocities_by_root(stated.lagrangian, stated.momenta, slots.velocities, momenta, states)
    if inverted is None:
        raise NotCoveredError(
            "Hamilton's function where the momenta are not linear in the velocities",
            cure="`find: motion` gives the equations of motion; velocities under one square root, as of a fast "
            "particle, can be solved for",
        )
    velocities, function = inverted
    in_momenta = dict(zip(slots.velocities, velocities, strict=True))
    applied = tuple(textbook_form(q.xreplace(in_momenta)) if q != 0 else ZERO for q in stated.applied)
    cyclic = tuple(k for k, q in enumerate(slots.coordinates) if q not in function.free_symbols and applied[k] == 0)
    energy = sp.Add(stated.kinetic, stated.potential, stated.moving_energy)
    by_momenta = dict(zip(momenta, stated.momenta, strict=True))
    is_energy = states.is_zero(function.xreplace(by_momenta) - energy)
    return Hamiltonian(
        motion, stated, momenta, velocities, (), function, applied, is_energy, cyclic, routhian=None, integrated=known
    )


def completed_squares(
    mass: Sequence[Sequence[sp.Expr]], roots: Sequence[sp.Expr], surface: Surface
) -> tuple[KineticSquare, ...] | None:
    """The quadratic form ½ uᵀ M⁻¹ u as a sum of squares, for a symmetric M; None if M is singular, or undecided.

    roots  shape (n,): u
    """
    left = [*range(len(roots))]
    m, u = [list(row) for row in mass], [*roots]
    squares = []
    while left:

        def cost(k: int) -> tuple[int, int]:
            return sum(m[k][i] != 0 for i in left), count_operations(m[k][k])

        k = min(left, key=cost)
        if not m[k][k].is_positive and surface.is_zero(m[k][k]) is not False:
            return None
        left.remove(k)
        squares.append((k, KineticSquare(u[k], _factored(m[k][k]))))
        for i in left:
            if m[i][k] != 0:
                share = tidy_quotient(m[i][k] / m[k][k])
                u[i] = u[i] - share * u[k]
                for j in left:
                    m[i][j] = tidy_quotient(m[i][j] - share * m[k][j])
    return tuple(s for _, s in sorted(squares, key=lambda pair: pair[0]))


def _routhian(
    stated: Energies,
    momenta: Sequence[sp.Symbol],
    mass: Sequence[Sequence[sp.Expr]],
    moved: Sequence[sp.Expr],
    cyclic: Sequence[int],
) -> sp.Expr | None:
    """R: L without the cyclic velocities, less ½ wᵀ M_cc⁻¹ w with w = p_c − b_c − Σ M_ck q_k' over the others."""
    configuration = stated.configuration
    velocities = configuration.slots.velocities
    others = [k for k in range(len(momenta)) if k not in cyclic]
    roots = [moved[c] - sp.Add(*(mass[c][k] * velocities[k] for k in others)) for c in cyclic]
    squares = completed_squares([[mass[c][d] for d in cyclic] for c in cyclic], roots, configuration.states)
    if squares is None:
        return None
    without = sp.Add(stated.kinetic, stated.moving).xreplace({velocities[c]: ZERO for c in cyclic})
    return sp.Add(textbook_form(without), -stated.potential, *(-s.expression for s in squares))


def check_hamiltonian(hamiltonian: Hamiltonian) -> list[Check]:
    """By Lagrange's p_k = ∂L/∂q_k': ∂H/∂p_k is q_k', the canonical equations are those of motion, R is L − Σ p_c q_c'.

    None of this uses M⁻¹ or the squares.
    """
    configuration, stated = hamiltonian.configuration, hamiltonian.energies
    slots, states, name = configuration.slots, configuration.states, configuration.name
    how = at_random_states(configuration)
    by_momenta = dict(zip(hamiltonian.momenta, stated.momenta, strict=True))
    H = hamiltonian.function
    differences = [
        side.xreplace(by_momenta) - v
        for v, p, printed in zip(slots.velocities, hamiltonian.momenta, hamiltonian.velocities, strict=True)
        for side in (partial(H, p), printed)
    ]
    canonical = [
        slots.time_derivative(p) + partial(H, q).xreplace(by_momenta) - force
        for q, p, force in zip(slots.coordinates, stated.momenta, stated.applied, strict=True)
    ]
    printed = [
        slots.time_derivative(p) - rate.xreplace(by_momenta)
        for p, rate in zip(stated.momenta, hamiltonian.rates, strict=True)
    ]
    system = System(configuration, hamiltonian.motion.expressions)
    checks = [
        Check("∂H/∂p_k are the velocities", _all_vanish(differences, states), how, name),
        Check(
            "Hamilton's equations are the equations of motion",
            _all_agree((canonical, printed), system),
            how,
            name,
        ),
    ]
    if hamiltonian.routhian is not None:
        work = sp.Add(*(stated.momenta[c] * slots.velocities[c] for c in hamiltonian.cyclic))
        lagrangian = stated.lagrangian - work
        holds = _all_vanish([hamiltonian.routhian.xreplace(by_momenta) - lagrangian], states)
        checks.append(Check("Routh's function is L − Σ p q' of the cyclic coordinates", holds, how, name))
    return checks


def _all_vanish(expressions: Sequence[sp.Expr], surface: Surface) -> bool | None:
    return all_hold(surface.is_zero(e) for e in expressions)


def _all_agree(systems: Sequence[Sequence[sp.Expr]], system: System) -> bool | None:
    try:
        comparisons = [compare(equations, system) for equations in systems]
    except DivisionByZeroError:
        return None
    return None if None in comparisons else all(c is not None and c.agree for c in comparisons)


def _factored(expression: sp.Expr) -> sp.Expr:
    """One product, where it is a sum with common factors: m l² (M + m sin² θ)."""
    ring = FourierRing()
    element = ring.from_sympy(expression)
    return ZERO if ring.is_zero(element) else Textbook(ring).product(element).to_sympy()


def _prescribed(configuration: Configuration) -> list[sp.Symbol]:
    return [prime(u, order) if order else u for u in configuration.slots.prescribed for order in range(3)]


# -- Constraints on velocities with constant coefficients, integrated: s' + R θ' = 0 is s + R θ = const ----------------
#
# Where the coordinates that they determine appear nowhere else, neither does the constant, and the other coordinates
# are
# free: the system then has a Lagrangian and Hamilton's function of these alone. That L may be formed with the
# velocities
# substituted is so only because the constraints can be integrated.


def integrated(motion: EquationsOfMotion) -> tuple[EquationsOfMotion, Mapping[sp.Symbol, sp.Expr]] | None:
    """The motion in free coordinates, and the others in terms of them, up to constants; None if this is not so."""
    configuration = motion.configuration
    slots, rows = configuration.slots, configuration.rows
    if any(r.finite is not None or r.nonlinear is not None or r.drift != 0 for r in rows):
        return None
    in_rows = {s for r in rows for a in r.coefficients for s in a.free_symbols}
    if any(s in slots.coordinates or is_time(s, configuration) for s in in_rows):
        return None
    stated = energies(configuration)
    used = {s for e in (stated.kinetic, stated.potential, stated.moving, *stated.applied) for s in e.free_symbols}
    absent = [k for k, q in enumerate(slots.coordinates) if q not in used]
    solved = eliminate(rows, len(slots.coordinates), configuration.states, absent)
    if solved.unused or any(k not in absent for k in solved.dependent):
        return None
    dependent = [slots.coordinates[k] for k in solved.dependent]
    free = [slots.coordinates[k] for k in solved.independent]
    expressed = {
        q: sp.Add(*(b * x for b, x in zip(row, free, strict=True)))
        for q, row in zip(dependent, solved.solution, strict=True)
    }
    reduced = substituted_configuration(configuration, configuration.name, tuple(free), expressed, ())
    rates = rates_of_dependent(solved, slots)
    equations = tuple(replace(e, expression=e.expression.xreplace(rates)) for e in motion.final)
    elimination = Elimination(tuple(range(len(free))), (), (), (), (), ())
    return replace(motion, configuration=reduced, elimination=elimination, equations=equations, closed=None), expressed


# -- Momenta that contain a root of a function of the velocities: p = m v/√(1 − v²/c²) of a fast particle --------------
#
# Where all momenta contain one root only, S = √B(q, q'), they are linear in the velocities except for S,
#
#     p_k − b_k = Σ m_kj(q, S) q_j' ,     which gives     q' = M(q, S)⁻¹ (p − b) .
#
# With these velocities S² = B is an equation for S² alone. Where that is linear, a S² + c = 0, the velocities follow
# in
# closed form, S = √(−c/a) being positive: of the fast particle S = m c/√(m² c² + p²). Reference: Goldstein, § 8.4.


def velocities_by_root(
    lagrangian: sp.Expr,
    stated: Sequence[sp.Expr],
    velocities: Sequence[sp.Symbol],
    momenta: Sequence[sp.Symbol],
    surface: Surface,
) -> tuple[tuple[sp.Expr, ...], sp.Expr] | None:
    """The velocities in terms of the momenta, and Σ p_k q_k' − L; None if they are not found.

    stated  shape (n,): ∂L/∂q_k'
    """
    moving = {*velocities}
    powers = {p for e in (lagrangian, *stated) for p in e.atoms(sp.Pow) if _is_root(p) and p.base.free_symbols & moving}
    if not powers or count_operations(lagrangian) > LONGEST_NONLINEAR:
        return None
    base, S = min((p.base for p in powers), key=count_operations), sp.Dummy("S", positive=True)
    shares = {p: sp.cancel(p.base / base) for p in powers}  # c² of c² − v² to 1 − v²/c²
    if any(not e.is_positive or e.free_symbols & moving for e in shares.values()):
        return None
    with_letter = {p: e**p.exp * S ** (2 * p.exp) for p, e in shares.items()}
    written = [sp.expand(e.xreplace(with_letter)) for e in stated]
    mass = [[partial(e, v) for v in velocities] for e in written]
    if any(e.free_symbols & moving for row in mass for e in row) or not base.is_polynomial(*velocities):
        return None
    still = dict.fromkeys(velocities, sp.S.Zero)
    shifts = [e.xreplace(still) for e in written]
    moved = [sp.Dummy(p.name, real=True) if b != 0 else p for p, b in zip(momenta, shifts, strict=True)]  # p − b
    meant = {u: p - b for u, p, b in zip(moved, momenta, shifts, strict=True) if u != p}
    solved = solved_linear(mass, moved, surface)
    if solved is None or any(e is None for e in solved):
        return None
    inverted = {v: e for v, e in zip(velocities, solved, strict=True) if e is not None}
    root = _root_of(base.xreplace(inverted) - S**2, S)
    if root is None:
        return None
    work = sp.Add(*((u + b if u in meant else u) * v for u, b, v in zip(moved, shifts, velocities, strict=True)))
    function = (work - lagrangian.xreplace(with_letter)).xreplace(inverted)
    in_momenta = [_with_root(e, S, root).xreplace(meant) for e in (*(inverted[v] for v in velocities), function)]
    return tuple(in_momenta[:-1]), in_momenta[-1]


def _is_root(p: sp.Expr) -> bool:
    return bool(p.exp.is_Rational and p.exp.q == 2)


def _root_of(equation: sp.Expr, S: sp.Symbol) -> tuple[sp.Expr, sp.Expr] | None:
    """a and b with S² = a/b, from an equation that is linear in S²."""
    above = sp.fraction(sp.cancel(sp.together(equation)))[0]
    if not above.is_polynomial(S) or count_operations(above) > LONGEST_NONLINEAR:
        return None
    terms: Mapping[tuple[int, ...], sp.Expr] = sp.Poly(above, S).as_dict()
    degrees = sorted(k for (k,) in terms)
    if len(degrees) != 2 or degrees[1] - degrees[0] != 2:
        return None
    a, b = sp.fraction(sp.factor(-terms[(degrees[0],)] / terms[(degrees[1],)]))
    if a.could_extract_minus_sign() and b.could_extract_minus_sign():
        a, b = -a, -b
    squares = sp.Mul(*(f for f in sp.Mul.make_args(a) if f.is_Pow and f.exp == 2 and not f.base.is_positive))
    return a / squares, sp.expand(b / squares)  # p_r² + p_φ²/r² + m² c² instead of this times r²


def _with_root(e: sp.Expr, S: sp.Symbol, root: tuple[sp.Expr, sp.Expr]) -> sp.Expr:
    """An expression with S = √(a/b): what is even in S, and what is odd, where b cancels if it can."""
    a, b = root
    even, odd = sp.S.Zero, sp.S.Zero
    for power, coefficient in sp.collect(sp.expand(e), S, evaluate=False).items():
        n = int(sp.degree(power, S)) if power.is_polynomial(S) else -int(sp.degree(1 / power, S))
        if n % 2:
            odd += coefficient * (a / b) ** ((n - 1) // 2)
        else:
            even += coefficient * (a / b) ** (n // 2)
    factor = sp.factor(sp.cancel(sp.together(odd)))
    without = sp.factor(sp.cancel(sp.together(odd / b)))
    shorter = count_operations(without) < count_operations(factor)
    return sp.Add(without * sp.sqrt(a) * sp.sqrt(b) if shorter else factor * sp.sqrt(a) / sp.sqrt(b), even)
