"""Small oscillations: the equations of motion to first order about their equilibria.

At an equilibrium q' = q'' = 0 solves the equations of motion: the forces balance, including the inertial forces of a
prescribed rotation. With q = q_0 + ξ and terms of second order neglected,

    M ξ'' + D ξ' + K ξ = 0 ,    M_kj = ∂D_k/∂q_j'' ,  D_kj = ∂D_k/∂q_j' ,  K_kj = ∂D_k/∂q_j − Σ_i λ_i ∂a_ik/∂q_j ,

all taken at q_0; the D_k on the right are those of d'Alembert's principle, λ the multipliers that balance them there,
and a_ik the constraints. If constraints bind the coordinates, then A ξ = 0 with A at q_0, and ξ = N η with independent
η leaves Nᵀ M N, Nᵀ D N, Nᵀ K N: the constraint is needed to second order, which the terms with λ provide. A kinematic
constraint gives A ξ' = 0; only displacements with A ξ = 0 are studied, since the others lead from one equilibrium to a
neighbouring one. D is symmetric where it damps, antisymmetric where it is gyroscopic.

Small oscillations are ξ = a cos ωt, with damping a e^{pt}: `eigenmodes` has frequencies and modes, `linear_stability`
the verdict. Reference: Lagrange 1788, part 2, section 6; Whittaker, Analytical Dynamics, ch. 7 and 8.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import field, replace
from functools import cache, cached_property
from itertools import product

import sympy as sp

from lagrange.algebra.closed_forms.eigenmodes import (
    Frequency,
    Matrix,
    determinant,
    frequencies,
    letter_factors,
    without_minus,
)
from lagrange.algebra.closed_forms.solution_sets import Branch
from lagrange.algebra.closed_forms.unit_circle import NotAlgebraicError
from lagrange.algebra.exact.zero_test import DivisionByZeroError, Surface, is_zero, kept_surface
from lagrange.algebra.fourier.textbook_form import common_factor, normalised, textbook_form
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import never_vanishes, partial, prime
from lagrange.mechanics.constraints.constrained_system import Row
from lagrange.mechanics.constraints.displacements import eliminate
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.equations import EquationsOfMotion
from lagrange.mechanics.dynamics.matrix_form import MatrixForm, matrix_form
from lagrange.mechanics.equilibrium.damped_modes import DampedModes, damped_modes
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium
from lagrange.mechanics.equilibrium.limits import (
    LONGEST_COEFFICIENT,
    MOST_COMPARED_EQUILIBRIA,
    MOST_EQUILIBRIA,
    MOST_OSCILLATING,
)
from lagrange.mechanics.equilibrium.linear_stability import (
    LinearSystem,
    StabilityJudgement,
    VelocityTerms,
    judged,
    kind_of,
)
from lagrange.mechanics.equilibrium.relative_equilibrium import (
    branches_at_rest,
    equilibria_of_motion,
    is_time,
    require_possible_rest,
    without_time,
)
from lagrange.mechanics.equilibrium.searched.places import with_search
from lagrange.mechanics.equilibrium.stability import StabilityVerdict, on_branch

ZERO = sp.S.Zero
DELTA = sp.Symbol("delta", real=True)


@record
class DampedOscillation:
    """One coordinate with damping, ξ'' + 2σ ξ' + ω₀² ξ = 0: ω₀², σ = ζ ω₀, and ω² = ω₀² (1 − ζ²)."""

    own: sp.Expr
    rate: sp.Expr
    square: sp.Expr


@record
class SmallOscillations:
    """The linear equations at one equilibrium.

    free            the coordinates whose small changes are independent, by index
    shape           (n, f): ξ = N η, the small changes of all coordinates
    system          M, D, K of the independent ones, shape (f, f), and the frequencies
    equations       each zero, common factors divided out
    characteristic  the polynomial in ω or, with damping, in the exponent p, in factors; None: too large
    unknown         ω or p
    judgement       the verdict on stability
    damped          if a single coordinate is damped, and stable
    decaying        with damping, the modes as decay rates and frequencies; None: the polynomial is too large
    """

    free: tuple[int, ...]
    shape: Matrix
    system: LinearSystem
    equations: tuple[sp.Expr, ...]
    characteristic: sp.Expr | None
    unknown: sp.Symbol
    judgement: StabilityJudgement
    damped: DampedOscillation | None = None
    decaying: DampedModes | None = None

    @property
    def oscillates(self) -> bool:
        """Whether the characteristic equation is one for ω²."""
        return self.system.kind is not VelocityTerms.DAMPED

    @property
    def frequencies(self) -> tuple[Frequency, ...]:
        """The roots ω²; none with damping."""
        return self.system.frequencies

    @property
    def long_square(self) -> sp.Expr | None:
        """K/M, the ω² of one coordinate without damping, where it is too long to be a root in closed form."""
        if len(self.free) > 1 or not self.oscillates or any(f.square is not None for f in self.frequencies):
            return None
        return self.system.stiffness[0][0] / self.system.mass[0][0]

    def remaining(self, f: Frequency) -> sp.Expr:
        """The polynomial in ω with this frequency as a root, each coefficient in factors."""
        return _in_powers(f.factor, f.letter).xreplace({f.letter: self.unknown**2})


@record
class Copy:
    """An equilibrium with the linear equations of an earlier one, by index, where the signs of some ξ are reversed."""

    of: int
    reversed: tuple[sp.Symbol, ...]


@record
class Linearization:
    """The linear equations about all equilibria of the equations of motion, in one set of coordinates.

    equilibrium   of the equations of motion: its forces are those equations at rest
    branches      its branches, without long unsolved equations
    complete      whether these are all equilibria
    displacements ξ, one for each coordinate
    omega         the letter for a frequency
    exponent      the letter p
    decay         the letter σ for a decay rate
    driven        whether positions contain time, which cancels
    at            for each branch; None if the mass matrix is singular there, or nothing in closed form was found
    copies        for each branch the earlier one with the same linear equations up to the signs of some ξ; or None
    omitted       the branches whose linear equations are not worked out because there are too many, by index
    """

    motion: EquationsOfMotion
    equilibrium: Equilibrium
    branches: tuple[Branch, ...]
    complete: bool
    displacements: tuple[sp.Symbol, ...]
    omega: sp.Symbol
    exponent: sp.Symbol
    driven: bool
    at: tuple[SmallOscillations | None, ...]
    copies: tuple[Copy | None, ...] = ()
    decay: sp.Symbol = field(default=DELTA)
    omitted: tuple[int, ...] = ()

    def square_where_stable(self, branch: Branch, s: SmallOscillations) -> sp.Expr | None:
        """The only ω² about a branch, with its value at the points at which it is stable, if that is the same."""
        square = s.frequencies[0].square if len(s.frequencies) == 1 else None
        if square is None:
            return None
        read = self.equilibrium.solution.letters.read
        try:
            conditions = [(read(c.lhs - c.rhs), c.relation == ">") for c in s.judgement.stability.conditions]
            value = read(square)
        except NotAlgebraicError:
            return square
        points = [p for p in branch.points if all((e.xreplace(dict(p)) > 0) == above for e, above in conditions)]
        values = {sp.factor_terms(value.xreplace(dict(p))) for p in points}
        return values.pop() if len(values) == 1 else square

    def copy_of(self, n: int) -> Copy | None:
        """The earlier equilibrium that the nth one, counted from 0, is a copy of."""
        return self.copies[n] if self.copies else None

    def is_about_all_of(self, equilibrium: Equilibrium) -> bool:
        """Whether its equilibria, all of them known, are those of the principle of virtual work, in the same order."""
        same = self.complete and self.branches == equilibrium.branches
        return same and bool(self.branches) and all(b.equations for b in self.branches)

    @property
    def originals(self) -> tuple[SmallOscillations, ...]:
        """The linear equations that are known, without copies."""
        return tuple(s for n, s in enumerate(self.at) if s is not None and self.copy_of(n) is None)

    @property
    def configuration(self) -> Configuration:
        """The configuration."""
        return self.motion.configuration

    @property
    def turning(self) -> tuple[sp.Symbol, ...]:
        """The coordinates of which the equations of motion have the velocities only: in steady motions these stay."""
        occurring = {s for e in self.motion.expressions for s in e.free_symbols}
        return tuple(q for q in self.configuration.slots.coordinates if q not in occurring and prime(q) in occurring)


def linearization(motion: EquationsOfMotion, taken: frozenset[str]) -> Linearization:
    """Small oscillations about the equilibria of the equations of motion.

    taken  names that the letters ξ, ω, p must not use

    Raises NotCoveredError if the equations depend on time, or rest is not possible.
    """
    require_possible_rest(motion.configuration)
    rows = [r for n, r in enumerate(motion.configuration.rows) if n not in motion.elimination.unused]
    configuration = replace(motion.configuration, constrained=motion.configuration.constrained.with_rows(rows))
    motion = replace(motion, configuration=configuration, elimination=replace(motion.elimination, unused=()))
    form = matrix_form(motion)
    resting = with_search(equilibria_of_motion(form, motion))
    names = displacement_names(configuration.slots.coordinates, taken)
    omega, exponent = letters_of(taken)
    branches, complete = branches_at_rest(resting)
    places = (c for p in configuration.points for c in p.position.fixed().components)
    driven = any(is_time(s, configuration) for c in places for s in c.free_symbols)
    about = _About(form, resting, names, omega, exponent)
    for b in branches:
        about.add(b)
    at, copies, omitted = tuple(about.at), tuple(about.copies), tuple(about.omitted)
    decay = decay_letter(taken)
    return Linearization(
        motion, resting, branches, complete, names, omega, exponent, driven, at, copies, decay, omitted
    )


def letters_of(taken: frozenset[str]) -> tuple[sp.Symbol, sp.Symbol]:
    """The letters for a frequency, ω, and for an exponent, p."""
    omega = _letter(("omega", "Omega", "nu", "varpi"), taken)
    return sp.Symbol(omega, real=True), sp.Symbol(_letter(("p", "s", "sigma", "zeta"), taken), real=True)


def decay_letter(taken: frozenset[str]) -> sp.Symbol:
    """The letter for a decay rate, σ: δ is the sign of a virtual displacement."""
    return sp.Symbol(_letter(("sigma", "kappa", "gamma", "alpha"), taken), real=True)


def _letter(letters: Sequence[str], taken: frozenset[str]) -> str:
    """The first letter that no name uses, with or without an index."""
    stems = {n.split("_")[0].rstrip("'0123456789") for n in taken}
    return next((n for n in letters if n not in stems), letters[-1])


def displacement_names(coordinates: Sequence[sp.Symbol], taken: frozenset[str]) -> tuple[sp.Symbol, ...]:
    """ξ for one coordinate, ξ_1, ξ_2, ... for several."""
    letter = _letter(("xi", "eta", "zeta", "chi"), taken)
    if len(coordinates) == 1:
        return (sp.Symbol(letter, real=True),)
    return tuple(sp.Symbol(f"{letter}_{n}", real=True) for n, _ in enumerate(coordinates, start=1))


class _About:
    """The linear equations about one branch after the other; those of a copy are taken from its original."""

    def __init__(
        self,
        form: MatrixForm,
        resting: Equilibrium,
        names: Sequence[sp.Symbol],
        omega: sp.Symbol,
        exponent: sp.Symbol,
    ) -> None:
        self.form, self.resting = form, resting
        self.names, self.letters = names, (omega, exponent)
        self.branches: list[Branch] = []
        self.at: list[SmallOscillations | None] = []
        self.copies: list[Copy | None] = []
        self.omitted: list[int] = []
        self.worked_out = 0

    @cached_property
    def derivatives(self) -> tuple[Table, Table, Table]:
        """M, D and K at any place: those about each branch are their values there."""
        return _derivatives(self.form, self.resting)

    def add(self, b: Branch) -> None:
        """The next branch; its linear equations are worked out unless it is a copy or one of too many."""
        s, copy = self._of(b) if not b.left and not b.special else (None, None)
        self.branches.append(b)
        self.at.append(s)
        self.copies.append(copy)

    def _of(self, b: Branch) -> tuple[SmallOscillations | None, Copy | None]:
        """None if it is not in closed form, or the coordinates fail there, or there are too many."""
        if len(self.branches) >= MOST_COMPARED_EQUILIBRIA:
            self.omitted.append(len(self.branches))
            return None, None
        try:
            matrices = matrices_on(b, self.form, self.resting, self.derivatives)
        except (DivisionByZeroError, ZeroDivisionError):
            return None, None
        if matrices is None:
            return None, None
        free, shape, *reduced = matrices
        if len(free) > MOST_OSCILLATING or not free:
            return None, None
        mass, damping, stiffness = reduced
        for n, (other, s) in enumerate(zip(self.branches, self.at, strict=True)):
            if s is None or s.free != free or self.copies[n] is not None:
                continue
            if restrictions(other) == restrictions(b):
                signs = _mirror(s.system, (mass, damping, stiffness), {*self.resting.solution.unknowns})
                if signs is not None:
                    moved = [self.names[k] for k in free]
                    copied = _mirrored(s, shape, (mass, damping, stiffness), signs, moved)
                    return copied, Copy(n, tuple(x for x, sign in zip(moved, signs, strict=True) if sign < 0))
        if self.worked_out == MOST_EQUILIBRIA:
            self.omitted.append(len(self.branches))
            return None, None
        self.worked_out += 1
        return oscillations(free, shape, (mass, damping, stiffness), b, self.resting, self.names, *self.letters), None


def restrictions(b: Branch) -> set[tuple[str, frozenset[sp.Expr] | tuple[sp.Expr, sp.Expr]]]:
    """What restricts the parameters on a branch: a ≠ b is b ≠ a."""
    return {
        (c.relation, frozenset((c.lhs, c.rhs)) if c.relation == "≠" else (c.lhs, c.rhs))
        for c in (*b.conditions, *b.implied)
    }


def _mirror(s: LinearSystem, matrices: tuple[Matrix, ...], unknowns: set[sp.Symbol]) -> tuple[int, ...] | None:
    """The signs of the ξ with which M, D, K become other matrices, fewest reversed; None: there are none.

    Only where all are functions of parameters: then frequencies, modes and stability are those of one linear system.
    """
    size = len(s.mass)
    pairs = [*zip((s.mass, s.damping, s.stiffness), matrices, strict=True)]
    if any(e.free_symbols & unknowns for pair in pairs for x in pair for row in x for e in row):
        return None
    ratios: dict[tuple[int, int], int] = {}
    for x, y in pairs:
        for i, j in product(range(size), repeat=2):
            a, b = x[i][j], y[i][j]
            sign = 1 if a == b else -1 if is_zero(a + b) is True else 1 if is_zero(a - b) is True else None
            if sign is None or (i == j and sign < 0):
                return None
            if a != 0 and ratios.setdefault((min(i, j), max(i, j)), sign) != sign:
                return None
    signs = [0] * size
    for start in range(size):
        if signs[start]:
            continue
        linked, signs[start] = [start], 1
        for i in linked:
            for (m, n), sign in ratios.items():
                if m != n and i in (m, n):
                    other = n if i == m else m
                    if signs[other] not in (0, sign * signs[i]):
                        return None
                    linked += [] if signs[other] else [other]
                    signs[other] = sign * signs[i]
    return tuple(signs)


def _mirrored(
    s: SmallOscillations, shape: Matrix, matrices: tuple[Matrix, ...], signs: Sequence[int], moved: Sequence[sp.Symbol]
) -> SmallOscillations:
    """The small oscillations of a system whose ξ have other signs."""
    mass, damping, stiffness = matrices

    def mode(v: tuple[sp.Expr, ...]) -> tuple[sp.Expr, ...]:
        lead = next(sign for a, sign in zip(v, signs, strict=True) if a != 0)
        return tuple(lead * sign * a for a, sign in zip(v, signs, strict=True))

    frequencies = tuple(replace(f, modes=tuple(map(mode, f.modes))) for f in s.system.frequencies)
    system = replace(s.system, mass=mass, damping=damping, stiffness=stiffness, frequencies=frequencies)
    equations = tuple(_equations(mass, damping, stiffness, moved))
    decaying = s.decaying
    if decaying is not None:
        shapes = (replace(m, shape=mode(m.shape) if m.shape else ()) for m in decaying.modes)
        decaying = replace(decaying, modes=tuple(shapes))
    return replace(s, shape=shape, system=system, equations=equations, decaying=decaying)


def oscillations(
    free: tuple[int, ...],
    shape: Matrix,
    matrices: tuple[Matrix, Matrix, Matrix],
    b: Branch,
    resting: Equilibrium,
    names: Sequence[sp.Symbol],
    omega: sp.Symbol,
    exponent: sp.Symbol,
) -> SmallOscillations | None:
    """The linear equations with M, D, K, their frequencies and stability; None if M is singular."""
    mass, damping, stiffness = matrices
    try:
        if kept_surface().rank(mass) != len(mass):
            return None
    except (DivisionByZeroError, ZeroDivisionError):
        return None
    symmetric = all(is_zero(stiffness[i][j] - stiffness[j][i]) is True for i in range(len(free)) for j in range(i))
    kind = kind_of(damping, symmetric)
    damped = kind is VelocityTerms.DAMPED
    letter = exponent if damped else sp.Dummy("omega_squared", real=True)
    polynomial = _characteristic(mass, damping, stiffness, kind, letter)
    written, coefficients = None, None
    roots: tuple[Frequency, ...] = ()
    if polynomial is not None:
        pieces = letter_factors(polynomial, letter)
        written = sp.Mul(*(_in_powers(f, letter) ** n for f, n in pieces))
        written = written if damped else written.xreplace({letter: omega**2})
        coefficients = tuple(sp.Poly(polynomial, letter).all_coeffs())
        roots = () if damped else frequencies(mass, stiffness, pieces, letter, with_modes=kind is VelocityTerms.NONE)
    system = LinearSystem(mass, damping, stiffness, kind, symmetric, coefficients, roots)
    equations = tuple(_equations(mass, damping, stiffness, tuple(names[k] for k in free)))
    unknown = exponent if damped else omega
    judgement = judged(system, b, resting)
    modes = damped_modes(matrices, polynomial, letter) if damped and polynomial is not None else None
    return SmallOscillations(
        free, shape, system, equations, written, unknown, judgement, _damped(system, judgement), modes
    )


def _in_powers(f: sp.Expr, letter: sp.Symbol) -> sp.Expr:
    """A polynomial in a letter, with short coefficients in factors."""
    terms = sp.Poly(f, letter).terms()
    return sp.Add(
        *((sp.factor(c) if count_operations(c) <= LONGEST_COEFFICIENT else c) * letter**n for (n,), c in terms)
    )


def _damped(system: LinearSystem, judgement: StabilityJudgement) -> DampedOscillation | None:
    """The constants of a single damped coordinate, if it is stable."""
    if (
        system.kind is not VelocityTerms.DAMPED
        or len(system.mass) > 1
        or judgement.stability.verdict is not StabilityVerdict.STABLE
    ):
        return None
    [[m]], [[d]], [[k]] = system.mass, system.damping, system.stiffness
    own = sp.factor(k / m)
    return DampedOscillation(own, sp.factor(d / (2 * m)), without_minus(sp.factor(own - d**2 / (4 * m**2))))


Table = tuple[tuple[sp.Expr, ...], ...]


def _derivatives(form: MatrixForm, resting: Equilibrium) -> tuple[Table, Table, Table]:
    """M, and the derivatives −∂Q/∂q' and −∂(Q + Aᵀ λ)/∂q at rest, at any place.

    K is minus the derivative of Q + Aᵀ λ at constant λ: without λ the curvature of the constraints would be missing,
    and a pendulum in x, y would have no stiffness.
    """
    slots = form.configuration.slots
    rows = [r for r in form.configuration.rows if not r.is_identity]
    at_rest = dict.fromkeys(slots.velocities, sp.S.Zero)
    reactions = (
        sp.Add(*(m * r.coefficients[k] for m, r in zip(resting.multipliers, rows, strict=True)))
        for k in range(len(form.force))
    )
    still = [f.xreplace(at_rest) + reaction for f, reaction in zip(form.force, reactions, strict=True)]

    def slope(f: sp.Expr, s: sp.Symbol) -> sp.Expr:
        """With the δ functions at jumps, by which a place on a jump is known (`_is_smooth`)."""
        return f.diff(s) if f.has(sp.sign) else partial(f, s)

    def written(table: Iterable[Iterable[sp.Expr]]) -> Table:
        return tuple(tuple(without_time(e, form.configuration) for e in row) for row in table)

    return (
        written(form.mass),
        written((-slope(f, v).xreplace(at_rest) for v in slots.velocities) for f in form.force),
        written((-slope(f, q) for q in slots.coordinates) for f in still),
    )


def matrices_on(
    b: Branch, form: MatrixForm, resting: Equilibrium, derivatives: tuple[Table, Table, Table]
) -> tuple[tuple[int, ...], Matrix, Matrix, Matrix, Matrix] | None:
    """The free coordinates, N, and the reduced M, D, K on a branch; None if they cannot be written in closed form."""
    slots = form.configuration.slots
    rows = [r for r in form.configuration.rows if not r.is_identity]
    constraints = [[on_branch(b, a, resting) for a in r.coefficients] for r in rows]

    @cache  # M is symmetric, and many entries are zero
    def value(e: sp.Expr) -> sp.Expr | None:
        return on_branch(b, e, resting, in_parameters=True)

    mass, damping, stiffness = ([[value(e) for e in row] for row in table] for table in derivatives)
    known = [*constraints, *mass, *damping, *stiffness]
    if any(e is None or not _is_smooth(e, form.configuration) for row in known for e in row):
        return None
    fixed = [Row(r.name, tuple(row), ZERO) for r, row in zip(rows, constraints, strict=True)]
    displacements = eliminate(fixed, len(slots.coordinates), Surface())
    if len(displacements.independent) != len(resting.elimination.independent):
        return None  # here the constraints leave more or fewer displacements free than elsewhere
    shape = displacements.shape(len(slots.coordinates))
    reduced = [_reduced(matrix, shape, value) for matrix in (mass, damping, stiffness)]
    if any(r is None for r in reduced):
        return None
    m, d, k = (r for r in reduced if r is not None)
    return displacements.independent, shape, m, d, k


def _is_smooth(e: sp.Expr, configuration: Configuration) -> bool:
    """Whether an entry is a finite function of parameters: no 1/0, no derivative of a jump, no time."""
    bad = e.has(sp.zoo, sp.nan, sp.oo, sp.DiracDelta, sp.Heaviside, sp.Derivative)
    return not bad and not any(is_time(s, configuration) for s in e.free_symbols)


def _reduced(
    matrix: list[list[sp.Expr | None]], shape: Matrix, value: Callable[[sp.Expr], sp.Expr | None]
) -> Matrix | None:
    """Nᵀ X N on a branch, where an expression has a value; of free coordinates N is 1."""
    n = sp.Matrix(shape)
    written = matrix
    if not n.is_Identity:
        product = n.T * sp.Matrix(matrix) * n
        written = [[value(e) for e in product.row(k)] for k in range(product.rows)]
    if any(e is None for row in written for e in row):
        return None
    return tuple(tuple(_shorter(e) for e in row if e is not None) for row in written)


def _shorter(e: sp.Expr) -> sp.Expr:
    formed = textbook_form(e)
    return formed if count_operations(formed) <= count_operations(e) else e


def _equations(mass: Matrix, damping: Matrix, stiffness: Matrix, moved: Sequence[sp.Symbol]) -> Iterator[sp.Expr]:
    """M ξ'' + D ξ' + K ξ, each row without common factors."""
    for ms, ds, ks in zip(mass, damping, stiffness, strict=True):
        total = sp.Add(*(m * prime(x, 2) + d * prime(x) + k * x for m, d, k, x in zip(ms, ds, ks, moved, strict=True)))
        formed = textbook_form(sp.fraction(sp.together(total))[0])
        yield normalised(common_factor(formed).only(never_vanishes).divide(formed))


def _characteristic(
    mass: Matrix, damping: Matrix, stiffness: Matrix, kind: VelocityTerms, letter: sp.Symbol
) -> sp.Expr | None:
    """det(K − ω² M), det(K − ω² M + iω G) as a polynomial in ω², or det(K + p D + p² M)."""
    if kind is VelocityTerms.NONE:
        return determinant(_sum_of((stiffness, sp.S.One), (mass, -letter)))
    p = sp.Dummy("p", real=True) if kind is VelocityTerms.GYROSCOPIC else letter
    polynomial = determinant(_sum_of((stiffness, sp.S.One), (damping, p), (mass, p**2)))
    if polynomial is None or kind is VelocityTerms.DAMPED:
        return polynomial
    # Even in p for symmetric K, because transposing reverses the sign of the antisymmetric D only: p² = −ω².
    terms = sp.Poly(polynomial, p).terms()
    return sp.expand(sp.Add(*(c * (-letter) ** (n // 2) for (n,), c in terms)))


def _sum_of(*terms: tuple[Matrix, sp.Expr]) -> list[list[sp.Expr]]:
    size = len(terms[0][0])
    return [[sp.Add(*(x[i][j] * c for x, c in terms)) for j in range(size)] for i in range(size)]
