"""Forced oscillations: the steady state of the linear equations under a harmonic force or motion of a support.

About an equilibrium q_0 of the system without the drive, and to first order in the displacements ξ and the drive,

    M ξ'' + D ξ' + K ξ = f(t) ,      f(t) = F cos ωt + G sin ωt .

Once the free oscillations have died out, or beside them where nothing damps them, the system follows with the frequency
of the drive,

    ξ = Re Z e^{iωt} ,      (K − ω² M + iω D) Z = F − iG ,

with the amplitudes |Z_k|. A drive proportional to cos ωt, or to sin ωt, alone gives ξ_k = |Z_k| cos(ωt − φ_k), or the
sine, and φ_k is the lag behind the drive. Without damping the amplitudes are unbounded at det(K − ω² M) = 0, the
frequencies of free oscillations: resonance. Where Z_k = 0, coordinate k is at rest: an absorber.

Reference: Rayleigh, The Theory of Sound, §§ 46, 104; den Hartog, Mechanical Vibrations, chs. 2, 3.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp

from lagrange.algebra.closed_forms.shortest_form import without_leading_minus
from lagrange.algebra.closed_forms.signs import sign_of
from lagrange.algebra.closed_forms.solution_sets import Branch
from lagrange.algebra.exact.zero_test import Surface, is_zero
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.diagnostics import NotCoveredError
from lagrange.core.records import all_hold, record
from lagrange.core.symbols import base, free_letter, prime, t
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.checks import Check
from lagrange.mechanics.dynamics.lagrangian import lagrange_equations
from lagrange.mechanics.dynamics.principle import dalembert
from lagrange.mechanics.equilibrium.drives import Drive
from lagrange.mechanics.equilibrium.limits import MOST_FORCED
from lagrange.mechanics.equilibrium.linear_stability import LinearSystem
from lagrange.mechanics.equilibrium.linearization import Linearization, SmallOscillations
from lagrange.mechanics.equilibrium.stability import StabilityVerdict, on_branch

ZERO = sp.S.Zero


@record
class ForcedEquations:
    """The forced linear equations about one equilibrium.

    linearization  of the system without the drive
    number         of the equilibrium among its branches
    forces         shape (n,): f(t)
    """

    linearization: Linearization
    number: int
    forces: tuple[sp.Expr, ...]

    @property
    def branch(self) -> Branch:
        """The equilibrium."""
        return self.linearization.branches[self.number]

    @property
    def free(self) -> SmallOscillations:
        """The equations without the drive."""
        oscillations = self.linearization.at[self.number]
        assert oscillations is not None  # only such an equilibrium is chosen
        return oscillations

    @property
    def configuration(self) -> Configuration:
        """The system without the drive."""
        return self.linearization.configuration

    @property
    def sides(self) -> tuple[tuple[sp.Expr, sp.Expr], ...]:
        """M ξ'' + D ξ' + K ξ, and f(t), of each equation."""
        system, moved = self.free.system, self.linearization.displacements
        rows = zip(system.mass, system.damping, system.stiffness, strict=True)
        left = [
            sp.Add(*(m * prime(x, 2) + d * prime(x) + k * x for m, d, k, x in zip(ms, ds, ks, moved, strict=True)))
            for ms, ds, ks in rows
        ]
        return tuple((textbook_form(e), f) for e, f in zip(left, self.forces, strict=True))


@record
class Response:
    """The steady state under one drive.

    cosines, sines  shape (n,): ξ = A cos ωt + B sin ωt
    amplitudes      shape (n,): √(A² + B²), with the modulus of what may be negative
    phases          shape (n,): the lag φ behind the drive; None if the drive has both a sine and a cosine
    resonances      ω² at which an undamped amplitude is unbounded, or that of a single damped coordinate is greatest
    rests           for each coordinate the ω² at which it is at rest
    is_damped       whether there is damping
    letters         shape (n,): the symbols of the amplitudes
    lags            shape (n,): those of the φ_k
    """

    forced: ForcedEquations
    drive: Drive
    cosines: tuple[sp.Expr, ...]
    sines: tuple[sp.Expr, ...]
    amplitudes: tuple[sp.Expr, ...]
    phases: tuple[sp.Expr | None, ...]
    resonances: tuple[sp.Expr, ...]
    rests: tuple[tuple[sp.Expr, ...], ...]
    is_damped: bool
    letters: tuple[sp.Symbol, ...]
    lags: tuple[sp.Symbol, ...]

    @property
    def motions(self) -> tuple[sp.Expr, ...]:
        """ξ(t), shape (n,)."""
        c, s = sp.cos(self.drive.frequency * t), sp.sin(self.drive.frequency * t)
        return tuple(a * c + b * s for a, b in zip(self.cosines, self.sines, strict=True))

    def is_between_resonances(self, rest: sp.Expr) -> bool:
        """Whether of two resonances one is below `rest` and one above it: (ω_1² − rest) (ω_2² − rest) < 0."""
        if self.is_damped or len(self.resonances) != 2:
            return False
        first, second = self.resonances
        between = sp.cancel(sp.expand((first - rest) * (second - rest)))
        return sign_of(between) == -1 and sign_of(sp.cancel(sp.expand(first * second))) == 1

    def beside(self, rest: sp.Expr) -> dict[sp.Symbol, sp.Expr]:
        """How the other coordinates oscillate where one is at rest, at ω² = `rest`: −(F/c_2) cos ωt of an absorber."""
        w = self.drive.frequency
        if not w.is_Symbol or not rest.is_positive:
            return {}
        c, s, root = sp.cos(w * t), sp.sin(w * t), {w: sp.sqrt(rest)}
        states = zip(self.forced.configuration.slots.coordinates, self.cosines, self.sines, strict=True)
        there = {q: tuple(sp.cancel(sp.together(e.xreplace(root))) for e in pair) for q, *pair in states}
        return {q: a * c + b * s for q, (a, b) in there.items() if (a, b) != (0, 0)}

    @property
    def at_resonance(self) -> tuple[tuple[sp.Expr, sp.Expr], ...]:
        """Without damping, the frequency of the drive at each resonance, or its square where a root would be long."""
        w = self.drive.frequency
        squares = () if self.is_damped else self.resonances
        return tuple((w, sp.sqrt(e)) if e.is_positive and not e.atoms(sp.Add) else (w**2, e) for e in squares)

    @property
    def greatest_at(self) -> sp.Expr:
        """The ω² at which the amplitude of a single damped coordinate is greatest, without a minus sign in front."""
        return without_leading_minus(self.resonances[0])

    @property
    def by_coordinate(self) -> Mapping[sp.Symbol, sp.Expr]:
        """The amplitude of each coordinate."""
        return dict(zip(self.forced.configuration.slots.coordinates, self.amplitudes, strict=True))


def forced_equations(
    linear: Linearization, moved: Configuration, small: Mapping[sp.Symbol, sp.Expr]
) -> ForcedEquations:
    """The forced linear equations about the first equilibrium that is stable, or else the first.

    linear  small oscillations without the drive
    moved   the system with the drive as prescribed motions
    small   the slots of these, and what they are as functions of time

    Raises NotCoveredError if the drive changes the inertia, or no equilibrium is known in closed form.
    """
    if moved.rows or linear.configuration.rows:
        raise NotCoveredError("forced oscillations in coordinates that are not free")
    known = [k for k, at in enumerate(linear.at) if at is not None]
    if not known:
        raise NotCoveredError("forced oscillations without an equilibrium in closed form")

    def is_stable(k: int) -> bool:
        at = linear.at[k]
        return at is not None and at.judgement.stability.verdict is StabilityVerdict.STABLE

    number = next((k for k in known if is_stable(k)), known[0])
    principle = dalembert(moved)
    slots = moved.slots
    still = {**dict.fromkeys(slots.velocities, ZERO), **dict.fromkeys(slots.accelerations, ZERO)}
    off = dict.fromkeys(small, ZERO)
    forces = []
    for element in principle.coefficients:
        balance = principle.textbook.form(element)
        if any(sp.diff(balance, a).has(*small) for a in slots.accelerations):
            raise NotCoveredError("forced oscillations where the motion that drives them changes the inertia")
        drives = {base(u) for u in small}
        if any(base(s) in drives and s not in small for s in balance.free_symbols):
            raise NotCoveredError("forced oscillations with derivatives of the drive beyond the third")
        terms = []
        for s, law in small.items():
            slope = sp.diff(balance, s).xreplace(still).xreplace(off)
            value = _at_rest(linear, number, slope)
            if value is None:
                raise NotCoveredError("forced oscillations whose forces have no closed form")
            terms.append(-value * law)
        forces.append(sp.Add(*terms))
    if all(f == 0 for f in forces):  # of second order beside the motion: a parametric drive, or none of this coordinate
        raise NotCoveredError("small oscillations under a prescribed motion that acts to second order only")
    return ForcedEquations(linear, number, tuple(forces))


def _at_rest(linear: Linearization, number: int, e: sp.Expr) -> sp.Expr | None:
    """An expression at an equilibrium; a condition may be linear in an angle, φ = 0, whose cosine is no letter."""
    branch, coordinates = linear.branches[number], linear.configuration.slots.coordinates
    stated = {r.lhs: r.rhs for r in branch.equations if r.lhs in coordinates and not r.rhs.has(*coordinates)}
    return on_branch(branch, e.xreplace(stated), linear.equilibrium, in_parameters=True)


def response(forced: ForcedEquations, drive: Drive, taken: frozenset[str]) -> Response:
    """The steady state. Raises NotCoveredError if it is too long, or resonance is identical.

    taken  names that the letters of amplitudes and lags must not use
    """
    system = forced.free.system
    n = len(forced.forces)
    w, given, meant = _as_letter(drive.frequency, system)
    if n > MOST_FORCED:
        raise NotCoveredError(f"the steady state of more than {MOST_FORCED} coordinates in symbols")
    c, s = sp.cos(drive.frequency * t), sp.sin(drive.frequency * t)
    parts = [(sp.expand(f).coeff(c).xreplace(given), sp.expand(f).coeff(s).xreplace(given)) for f in forced.forces]
    dynamic = sp.Matrix(n, n, lambda i, j: system.stiffness[i][j] - w**2 * system.mass[i][j])
    damping = sp.Matrix(n, n, lambda i, j: w * system.damping[i][j])
    is_damped = any(is_zero(e) is not True for e in damping)
    matrix = dynamic + sp.I * damping if is_damped else dynamic
    determinant = sp.expand(matrix.det(method="berkowitz"))
    if is_zero(sp.re(determinant) if not is_damped else _squared(determinant)) is True:
        raise NotCoveredError("a steady state at a frequency that is always one of resonance")
    right = sp.Matrix([f - sp.I * g for f, g in parts])
    numerators = [sp.expand(e) for e in matrix.adjugate() * right]
    scale = _squared(determinant)
    cosines, sines, amplitudes, phases = [], [], [], []
    of_cosine = not any(g != 0 for _, g in parts)
    of_sine = not any(f != 0 for f, _ in parts)
    for z in numerators:
        real, imaginary = _parts(sp.expand(z * _conjugate(determinant)))
        a, b = (_over_squares(_short(e / scale), determinant) for e in (real, -imaginary))
        if not is_damped:
            up, down = _parts(z)
            a, b = _short(up / determinant), _short(-down / determinant)
        cosines.append(_by_powers(a, w))
        sines.append(_by_powers(b, w))
        amplitudes.append(_by_powers(_amplitude(z, determinant, is_damped), w))
        lag = _lag(real, imaginary, of_cosine, of_sine)
        lag = lag if is_damped else _lag_without_damping(z, determinant, of_cosine, of_sine)
        phases.append(None if lag is None else _by_powers(lag, w))
    cosines, sines, amplitudes = _with_one_sign(cosines, sines, amplitudes)
    magnitudes = tuple(amplitudes)
    resonances = _resonances(determinant, magnitudes, w, is_damped)
    rests = tuple(_rests(z, determinant, w) if n > 1 else () for z in numerators)
    names = [q.name for q in forced.configuration.slots.coordinates]
    amplitude = free_letter("A", "C", "Amp", taken=taken, of=names)
    lag = free_letter("phi", "psi", "delta", "epsilon", taken=taken, of=names)
    letters, lags = (tuple(sp.Symbol(f"{k}_{n}", real=True) for n in names) for k in (amplitude, lag))
    cosines, sines, amplitudes = ([e.xreplace(meant) for e in of] for of in (cosines, sines, amplitudes))
    lagging = tuple(None if e is None else e.xreplace(meant) for e in phases)
    states = tuple(cosines), tuple(sines), tuple(amplitudes)
    return Response(forced, drive, *states, lagging, resonances, rests, is_damped, letters, lags)


def _as_letter(
    frequency: sp.Expr, system: LinearSystem
) -> tuple[sp.Expr, dict[sp.Symbol, sp.Expr], dict[sp.Symbol, sp.Expr]]:
    """A letter for a frequency such as 2π v/L, by which v is given, and what the letter means.

    Resonance is then found for the frequency as a whole. A frequency that is one letter, or a number, stays as it is.
    """
    fixed = {s for table in (system.mass, system.damping, system.stiffness) for row in table for e in row
             for s in e.free_symbols}  # fmt: skip
    for s in sorted(frequency.free_symbols - fixed, key=str) if not frequency.is_Symbol else ():
        slope = sp.diff(frequency, s)
        if s not in slope.free_symbols and sp.expand(frequency - slope * s) == 0:
            letter = sp.Dummy("w", real=True, positive=frequency.is_positive)
            return letter, {s: letter / slope}, {letter: frequency}
    return frequency, {}, {}


def _over_squares(e: sp.Expr, determinant: sp.Expr) -> sp.Expr:
    """A quotient by |determinant|², with Re² + Im² in its denominator instead of the sum multiplied out."""
    above, below = sp.fraction(e)
    return above / _root(below, determinant) ** 2


def _by_powers(e: sp.Expr, w: sp.Expr) -> sp.Expr:
    """An expression whose sums are collected in powers of ω: c − (M + m) ω² for c − M ω² − m ω²."""
    if not w.is_Symbol or not e.has(w) or not e.args:
        return e
    if not e.is_Add or not e.is_polynomial(w):
        return e.func(*(_by_powers(a, w) for a in e.args))
    if any(a.is_Pow and a.base.is_Add for term in e.args for a in sp.Mul.make_args(term)):
        return sp.Add(*(_by_powers(a, w) for a in e.args))  # Re² + Im²
    terms = sp.Poly(e, w).terms()
    return sp.Add(*(sp.Mul(_in_front(c), w**k) for (k,), c in terms))


def _with_one_sign(*groups: Sequence[sp.Expr]) -> tuple[list[sp.Expr], ...]:
    """The results with one sign of each factor: where |k − m ω²| is an amplitude, no m ω² − k in the motion."""
    moduli = dict.fromkeys(m.args[0] for group in groups for e in group for m in sorted(e.atoms(sp.Abs), key=str))
    chosen: list[sp.Expr] = []
    for f in moduli:
        if all(sp.expand(f - c) != 0 and sp.expand(f + c) != 0 for c in chosen):
            chosen.append(f)

    def written(factor: sp.Expr) -> tuple[sp.Expr, ...]:
        base_, exponent = factor.as_base_exp()
        inside = base_.args[0] if isinstance(base_, sp.Abs) else base_
        if not inside.is_Add or not exponent.is_Integer:
            return (factor,)
        for c in chosen:
            same, opposite = (sp.expand(inside - c) == 0, sp.expand(inside + c) == 0)
            if same or opposite:
                if isinstance(base_, sp.Abs):
                    return (sp.Abs(c) ** exponent,)
                return (sp.S.NegativeOne**exponent if opposite else sp.S.One, c**exponent)
        return (factor,)

    return tuple([sp.Mul(*(w for f in sp.Mul.make_args(e) for w in written(f))) for e in group] for group in groups)


def _in_front(coefficient: sp.Expr) -> sp.Expr:
    """A coefficient with a sign, and what its terms have in common, in front: −[m₁ c₂ + m₂ (c₁ + c₂)]."""
    together = textbook_form(coefficient)
    minus = [a.could_extract_minus_sign() for a in sp.Add.make_args(together)]
    return sp.Mul(-1, -together, evaluate=False) if together.is_Add and all(minus) else together


def limiting_amplitudes(response: Response) -> tuple[sp.Expr | None, sp.Expr | None]:
    """What the amplitude of the only coordinate tends to as ω → 0 and as ω → ∞; None if it has no limit."""
    w = response.drive.frequency
    if len(response.amplitudes) != 1 or not w.is_Symbol:
        return None, None
    above, below = sp.fraction(sp.cancel(sp.together(response.amplitudes[0] ** 2)))
    if not above.is_polynomial(w) or not below.is_polynomial(w):
        return None, None
    (low, up), (lowest, top) = ((min(p.monoms())[0], p.degree()) for p in (sp.Poly(e, w) for e in (above, below)))
    numerator, denominator = sp.Poly(above, w), sp.Poly(below, w)

    def root(k: int, n: int) -> sp.Expr:
        ratio = sp.factor(numerator.coeff_monomial(w**k) / denominator.coeff_monomial(w**n))
        return sp.sqrt(ratio) if ratio.is_number else sp.Mul(*(_half(f) for f in sp.Mul.make_args(ratio)))

    at_zero = None if low < lowest else ZERO if low > lowest else root(low, lowest)
    at_infinity = None if up > top else ZERO if up < top else root(up, top)
    return at_zero, at_infinity


def _half(factor: sp.Expr) -> sp.Expr:
    """The root of a factor of a square."""
    base_, exponent = factor.as_base_exp()
    if factor.is_number:
        return sp.sqrt(factor)
    return _modulus(base_) ** (exponent / 2) if (exponent / 2).is_Integer else sp.sqrt(factor)


def _conjugate(e: sp.Expr) -> sp.Expr:
    return e.xreplace({sp.I: -sp.I})


def _parts(e: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """The real and the imaginary part of a polynomial in i."""
    expanded = sp.expand(e)
    imaginary = expanded.coeff(sp.I)
    return sp.expand(expanded - sp.I * imaginary), imaginary


def _squared(e: sp.Expr) -> sp.Expr:
    """|e|²."""
    real, imaginary = _parts(e)
    return sp.Add(real**2, imaginary**2)


def _short(e: sp.Expr) -> sp.Expr:
    """A quotient in lowest terms, in factors."""
    return sp.factor(sp.cancel(sp.together(e)))


def _amplitude(numerator: sp.Expr, determinant: sp.Expr, is_damped: bool) -> sp.Expr:
    """|numerator/determinant|, without common factors."""
    if is_zero(_squared(numerator)) is True:
        return ZERO
    if not is_damped:
        up, down = _parts(numerator)
        if up != 0 and down != 0:
            return sp.sqrt(_short(up**2 + down**2)) / sp.Abs(sp.factor(determinant))
        above, below = sp.fraction(_short((up if down == 0 else down) / determinant))
        return sp.Mul(_modulus(above), 1 / sp.Mul(*(sp.Abs(f) for f in sp.Mul.make_args(below))))  # as in ξ itself
    ratio = sp.cancel(sp.together(_squared(numerator) / _squared(determinant)))
    above, below = (sp.factor(e) for e in sp.fraction(ratio))
    factors, under = _root(above, numerator), _root(below, determinant)
    return factors / under


def _modulus(e: sp.Expr) -> sp.Expr:
    """|e|, with positive factors outside and the sign that begins with a positive term inside."""
    outside, inside = [], []
    for f in sp.Mul.make_args(sp.factor(e)):
        outside.append(sp.Abs(f)) if f.is_nonnegative or f.is_number else inside.append(f)
    rest = sp.Mul(*inside)
    if rest == 1:
        return sp.Mul(*outside)
    leading = sorted(sp.Add.make_args(sp.expand(rest)), key=lambda e: e.could_extract_minus_sign())
    rest = -rest if 2 * sum(e.could_extract_minus_sign() for e in leading) > len(leading) else rest
    return sp.Mul(*outside, sp.Abs(rest))


def _root(square: sp.Expr, value: sp.Expr) -> sp.Expr:
    """√square, as √(Re² + Im²) of `value` where that has the same square up to a constant factor."""
    real, imaginary = _parts(value)
    outside: sp.Expr = sp.S.One
    inside: sp.Expr = sp.S.One
    for f in sp.Mul.make_args(square):
        base, exponent = f.as_base_exp()
        if base.is_nonnegative and not base.is_Add:
            outside *= base ** (exponent / 2)
        elif exponent.is_Integer and exponent % 2 == 0:
            outside *= sp.Abs(base) ** (exponent / 2)
        else:
            inside *= f
    if inside == 1:
        return outside
    root = sp.sqrt(sp.cancel(_squared(value) / inside))  # what Re and Im have in common beside `outside`
    if root.free_symbols <= {s for s in root.free_symbols if s.is_positive} and root.is_rational_function():
        re, im = _short(real / root), _short(imaginary / root)
        inside = sp.Add(re**2, im**2) if is_zero(re**2 + im**2 - inside) is True else inside
    return outside * sp.sqrt(inside)


def _lag_without_damping(numerator: sp.Expr, determinant: sp.Expr, of_cosine: bool, of_sine: bool) -> sp.Expr | None:
    """0 below a resonance and π above it: atan2(0, x), x having the sign of Z times the drive."""
    real, imaginary = _parts(numerator)
    value = -imaginary if of_sine else real if of_cosine else None
    if value is None:
        return None
    above, below = sp.fraction(_short(value / determinant))
    signs = [f for f in sp.Mul.make_args(sp.factor(above)) + sp.Mul.make_args(sp.factor(below)) if not f.is_positive]
    product = sp.Mul(*signs)
    return ZERO if product.is_positive or above == 0 else sp.pi if product.is_negative else sp.atan2(0, product)


def _lag(real: sp.Expr, imaginary: sp.Expr, of_cosine: bool, of_sine: bool) -> sp.Expr | None:
    """φ with Z = |Z| e^{−iφ} times the drive, from Z times a positive number."""
    if of_sine:  # Z = −i |Z| e^{−iφ}
        real, imaginary = -imaginary, real
    elif not of_cosine:
        return None
    common = sp.gcd(real, imaginary)
    positive = [f for f in sp.Mul.make_args(sp.factor(common)) if f.is_positive]
    shared = sp.Mul(*positive)
    x, y = sp.factor(sp.cancel(real / shared)), sp.factor(sp.cancel(-imaginary / shared))
    for f in sp.Mul.make_args(sp.gcd(x, y)):  # squares, which are positive where they do not vanish
        if f.is_Pow and f.exp.is_Integer and f.exp % 2 == 0:
            x, y = sp.cancel(x / f), sp.cancel(y / f)
    if y == 0 and x == 0:
        return ZERO
    return ZERO if y == 0 and x.is_positive else sp.atan2(y, x)


def _resonances(
    determinant: sp.Expr, amplitudes: Sequence[sp.Expr], w: sp.Expr, is_damped: bool
) -> tuple[sp.Expr, ...]:
    """ω² at which the amplitude is unbounded or, of one damped coordinate, greatest."""
    if not is_damped:
        return _zeros(determinant, w)
    if not w.is_Symbol or len(amplitudes) != 1 or amplitudes[0] == 0:
        return ()
    return tuple(v for v in _zeros(sp.fraction(sp.together(sp.diff(amplitudes[0] ** 2, w)))[0], w) if v != 0)


def _rests(numerator: sp.Expr, determinant: sp.Expr, w: sp.Expr) -> tuple[sp.Expr, ...]:
    """ω² at which a coordinate is at rest: both its sine and its cosine vanish, and the others have a steady state."""
    common = sp.gcd(*_parts(numerator))
    return _zeros(sp.cancel(common / sp.gcd(common, sp.gcd(*_parts(determinant)))), w)


def _zeros(e: sp.Expr, w: sp.Expr) -> tuple[sp.Expr, ...]:
    """The nonzero values of ω² where a polynomial in ω vanishes, if they are found in closed form."""
    if not w.is_Symbol:
        return ()
    square = sp.Dummy("square", positive=True)
    zeros: list[sp.Expr] = []
    for f in sp.Mul.make_args(sp.factor(sp.expand(e))):
        base = f.as_base_exp()[0]
        if not base.has(w):
            continue
        try:
            polynomial = sp.Poly(base, w)
        except sp.PolynomialError:
            return ()
        if base == w or any(k % 2 for (k,), _ in polynomial.terms()):
            continue
        p = sp.Poly(sp.Add(*(c * square ** (k // 2) for (k,), c in polynomial.terms())), square)
        if p.degree() == 1:
            a, b = p.all_coeffs()
            zeros.append(sp.factor(-b / a))
        elif p.degree() == 2:
            a, b, c = p.all_coeffs()
            inner = sp.factor(b**2 - 4 * a * c)
            zeros += [sp.factor_terms((-b + sign * sp.sqrt(inner)) / (2 * a)) for sign in (-1, 1)]
    return tuple(v for v in zeros if not v.is_nonpositive)


def check_response(response: Response) -> list[Check]:
    """The real steady state substituted into the linear equations, and into Lagrange's equations to first order."""
    forced, drive = response.forced, response.drive
    w, system = drive.frequency, forced.free.system
    surface = Surface()
    residuals = []
    for i, f in enumerate(forced.forces):
        left = sp.Add(
            *(
                system.mass[i][j] * sp.diff(x, t, 2) + system.damping[i][j] * sp.diff(x, t) + system.stiffness[i][j] * x
                for j, x in enumerate(response.motions)
            )
        )
        difference = sp.expand(left - f)
        c, s = sp.cos(w * t), sp.sin(w * t)
        residuals += [difference.coeff(c), difference.coeff(s), difference.xreplace({c: ZERO, s: ZERO})]
    holds = all_hold(surface.is_zero(e) for e in residuals)
    squares = [
        surface.is_zero(a**2 - p**2 - q**2)
        for a, p, q in zip(response.amplitudes, response.cosines, response.sines, strict=True)
    ]
    name = forced.configuration.name
    how = "exact, by substitution"
    return [
        Check("the steady state satisfies the linear equations", holds, how, name),
        Check("the amplitudes are those of the sine and the cosine together", all_hold(squares), how, name),
    ]


def check_forced(forced: ForcedEquations, moved: Configuration, small: Mapping[sp.Symbol, sp.Expr]) -> list[Check]:
    """The forced equations against Lagrange's equations of the driven system: the terms of first order of these."""
    slots, linear = moved.slots, forced.linearization
    moving = (*slots.velocities, *slots.accelerations)
    still = dict.fromkeys((*moving, *small), ZERO)
    steps: dict[sp.Symbol, sp.Expr] = dict(small)
    for q, x in zip(slots.coordinates, linear.displacements, strict=True):
        steps |= {q: x, prime(q): prime(x), prime(q, 2): prime(x, 2)}
    verdicts: list[bool | None] = []
    for e, (left, force) in zip(lagrange_equations(moved).left, forced.sides, strict=True):
        slopes = {s: _at_rest(linear, forced.number, sp.diff(e, s).xreplace(still)) for s in steps}
        if None in slopes.values():
            verdicts.append(None)
            continue
        first = sp.Add(*(slope * steps[s] for s, slope in slopes.items() if slope is not None))
        verdicts.append(Surface().is_zero(first - left + force))
    name = "Lagrange's equations give the same forced equations"
    return [Check(name, all_hold(verdicts), "exact, the terms of first order", forced.configuration.name)]
