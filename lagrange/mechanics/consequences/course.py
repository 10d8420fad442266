"""How a motion goes on: whether friction stops it, where a released body leaves its support, rates that swing.

*Sense.* A block that slides in a known sense with a constant acceleration speeds up or is slowed down, by the sign of
that acceleration, and the sign is a condition between parameters: sin α > μ cos α, that is tan α > μ.

*Released from rest.* With the energy ½ A(q) q'² + V(q) and one coordinate, a system released from rest at q_0 has
q'² = 2 (V(q_0) − V(q))/A(q), as long as contact lasts. A force that can only push, N(q, q'²), vanishes where
N(q, 2 (V(q_0) − V(q))/A(q)) = 0. A factor of it that is linear in u = sin q or cos q gives the place: a ladder leaves
the wall at sin θ = ⅔ sin θ_0. It ends exactly there if no other factor changes its sign and every other force that can
only push is a quadratic a u² + b u + c with a > 0 and c − b²/(4 a) ≥ 0, which is never negative. Where the only heavy
point has a height in proportion to u, it has fallen by the share 1 − u/u_0 of its height.

*Rates that swing.* If b w' = c v and v' = −k w + d with constants b, c, k, d, then v'' = −(k c/b) v: v is a harmonic
oscillation, although no spring is there (a ball that rolls in a vertical pipe).
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence

import sympy as sp

from lagrange.algebra.closed_forms.signs import sign_of
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import TimeDerivative, Unspecified, base, partial, prime, t
from lagrange.mechanics.consequences.limiting_cases import from_linear_equation
from lagrange.mechanics.consequences.oscillations import between_positive_sums
from lagrange.mechanics.dynamics.conservation import ConservedQuantity
from lagrange.mechanics.limits import LONGEST_CONSEQUENCE, LONGEST_FOLLOWED
from lagrange.mechanics.results import InCoordinates, Solution
from lagrange.problem.model import Assumption


@record
class Sense:
    """What slides with `velocity` > 0 speeds up if more > less, and is slowed down otherwise."""

    velocity: sp.Symbol
    more: sp.Expr
    less: sp.Expr


def sense(solution: Solution, view: InCoordinates) -> Sense | None:
    """The sense of the motion, if one coordinate has a constant acceleration while friction has a known sense."""
    motion, slots = view.dynamics, view.configuration.slots
    if motion is None or len(slots.coordinates) != 1 or len(motion.slips) != 1 or len(motion.equations.final) != 1:
        return None
    [acceleration], [v], [slip] = slots.accelerations, slots.velocities, motion.slips
    rate = sp.cancel(slip / v)
    value = from_linear_equation(motion.equations.final[0].expression, acceleration)
    if value is None or value.free_symbols & {*slots.coordinates, v, *slots.prescribed, t} or value.has(Unspecified):
        return None
    if not (rate.is_positive or rate.is_negative) or count_operations(value) > LONGEST_CONSEQUENCE:
        return None
    forward = 1 if rate.is_positive else -1
    angles = [p.symbol for p in solution.problem.parameters if p.assume is Assumption.ACUTE]
    cosines = {a: sp.Dummy("c", positive=True) for a in angles}
    tangents = {a: sp.Dummy("tan", positive=True) for a in angles}
    acute = {sp.cos(a): cosines[a] for a in angles} | {sp.sin(a): cosines[a] * tangents[a] for a in angles}
    sides = between_positive_sums(sp.expand(forward * value).xreplace(acute))
    if sides is None:
        return None
    back = {cosines[a]: sp.cos(a) for a in angles} | {tangents[a]: sp.tan(a) for a in angles}
    more, less = (e.xreplace(back) for e in sides)
    return Sense(forward * v, more, less)


@record
class Released:
    """Released from rest at q_0, a system loses contact at the latest where `wave` = `place`; the force vanishes there.

    start     q_0
    provided  what must be positive; None if it is
    exact     whether contact lasts until then
    others    the other forces that can only push, known not to become negative before
    fallen    by which share of its height the only heavy point has fallen
    heavy     its name; empty if its height is not in proportion to `wave`
    is_body   whether it is a mass centre
    """

    force: sp.Symbol
    coordinate: sp.Symbol
    start: sp.Symbol
    wave: sp.Expr
    place: sp.Expr
    provided: sp.Expr | None
    exact: bool = False
    others: tuple[sp.Symbol, ...] = ()
    fallen: sp.Expr = sp.S.Zero
    heavy: str = ""
    is_body: bool = False


def released(
    solution: Solution, view: InCoordinates, forces: Mapping[sp.Symbol, sp.Expr], pushing: Collection[sp.Symbol]
) -> Iterator[Released]:
    """For the forces of contact of one coordinate, where the file gives no initial state."""
    slots, conserved = view.configuration.slots, view.conserved
    if len(slots.coordinates) != 1 or view.signs or slots.prescribed or view.configuration.rows:
        return
    if solution.problem.initial or solution.asked or conserved is None:
        return
    energy = next((i for i in conserved.integrals if i.quantity is ConservedQuantity.ENERGY and i.constant), None)
    [q], [v] = slots.coordinates, slots.velocities
    start = sp.Symbol(f"{q.name}_0", real=True)
    if energy is None or start.name in solution.problem.scope.names():
        return
    total = sp.expand(energy.expression)
    inertia = total.coeff(v, 2)
    potential = sp.expand(total - inertia * v**2)
    if inertia == 0 or (inertia.free_symbols | potential.free_symbols) & {v, t}:
        return
    square = (potential.xreplace({q: start}) - potential) / inertia
    pushed = {s: sp.expand(forces[s]) for s in pushing if s in forces}
    along = {s: e.xreplace({v**2: square}) for s, e in pushed.items() if not e.coeff(v, 1)}
    for force in sorted({*pushing} & {*forces}, key=str):
        value = sp.expand(forces[force])
        factor = value.coeff(v, 2)
        rest = sp.expand(value - factor * v**2)
        if rest.free_symbols & {v, t, *slots.accelerations} or value.has(Unspecified) or factor == 0:
            continue
        if count_operations(value) > LONGEST_FOLLOWED:
            continue
        for wave in (sp.sin(q), sp.cos(q)):
            place = _place(rest + factor * square, potential, wave, (q, start))
            if place is not None:
                acute = _is_acute(view, q)
                provided = None if acute else wave.xreplace({q: start})
                others = tuple(sorted({*pushing} - {force}, key=str))
                lasts = all(s in along and _is_never_negative(along[s], wave, (q, start)) for s in others)
                only = _changes_sign_once(rest + factor * square, wave, (q, start), acute)
                share, heavy = 1 - place / wave.xreplace({q: start}), _rises_with(view, wave)
                is_body = any(r.name == heavy for r in view.configuration.rotations)
                yield Released(force, q, start, wave, place, provided, lasts and only, others, share, heavy, is_body)
                break


def _place(value: sp.Expr, potential: sp.Expr, wave: sp.Expr, names: tuple[sp.Symbol, sp.Symbol]) -> sp.Expr | None:
    """ρ u_0 with a number 0 < ρ < 1, where u = sin q or cos q is there; V = k u + const with k > 0: u falls to it."""
    q, start = names
    other = sp.cos(q) if isinstance(wave, sp.sin) else sp.sin(q)
    u, u_0, w = (sp.Dummy(x, real=True) for x in ("u", "u_0", "w"))
    by_letters = {wave: u, wave.xreplace({q: start}): u_0, other: w}
    height = sp.expand(potential).xreplace(by_letters)
    slope = height.diff(u)
    if not slope.is_positive or (height - slope * u).has(u, w, q):
        return None
    numerator = sp.numer(sp.together(sp.expand(value).xreplace(by_letters)))
    if numerator.has(q, start):
        return None
    for factor in sp.Mul.make_args(sp.factor(numerator)):
        if factor.has(u) and factor.has(u_0) and not factor.has(w) and sp.Poly(factor, u).degree() == 1:
            linear = sp.Poly(factor, u)
            ratio = sp.cancel(-linear.coeff_monomial(1) / (linear.coeff_monomial(u) * u_0))
            if ratio.is_Rational and 0 < ratio < 1:
                return ratio * wave.xreplace({q: start})
    return None


def _in_waves(value: sp.Expr, wave: sp.Expr, names: tuple[sp.Symbol, sp.Symbol]) -> tuple[sp.Expr, sp.Symbol, sp.Expr]:
    """A value with a letter for u and the other function of q, without even powers of this; the letter and u_0."""
    q, start = names
    other = sp.cos(q) if isinstance(wave, sp.sin) else sp.sin(q)
    u = sp.Dummy("u", real=True)
    first = wave.xreplace({q: start})
    squared = sp.expand(sp.expand(value).xreplace({wave: u, other**2: 1 - u**2}))
    return squared, u, first


def _is_never_negative(value: sp.Expr, wave: sp.Expr, names: tuple[sp.Symbol, sp.Symbol]) -> bool:
    """Whether it is a u² + b u + c with a > 0 and c − b²/(4 a) ≥ 0, over what is positive."""
    shown, u, _ = _in_waves(value, wave, names)
    above, below = sp.fraction(sp.together(shown))
    if below.has(u) or sign_of(below) != 1 or above.has(names[0]) or not above.is_polynomial(u):
        return False
    quadratic = sp.Poly(above, u)
    if quadratic.degree() != 2:
        return False
    a, b, c = quadratic.all_coeffs()
    return sign_of(a) == 1 and sign_of(sp.expand(c - b**2 / (4 * a))) in (0, 1)


def _changes_sign_once(value: sp.Expr, wave: sp.Expr, names: tuple[sp.Symbol, sp.Symbol], acute: bool) -> bool:
    """Whether the factors of a force other than u − ρ u_0 are positive: of cos θ (3 sin θ − 2 sin θ_0) cos θ is."""
    q, start = names
    first = wave.xreplace({q: start})
    quotient = sp.factor(sp.together(sp.expand(value)))
    own = [f for f in sp.Mul.make_args(quotient) if f.has(wave) and f.has(first)]
    if len(own) != 1 or sign_of(own[0].coeff(wave, 1)) != 1:
        return False
    rest = quotient / own[0]
    known = {sp.sin(q): sp.Dummy(positive=True), sp.cos(q): sp.Dummy(positive=True)} if acute else {}
    return sign_of(rest.xreplace(known)) == 1


def _rises_with(view: InCoordinates, wave: sp.Expr) -> str:
    """The only heavy point, if its height is in proportion to u and does not depend on q otherwise; empty if not."""
    points = [p for p in view.configuration.points if p.mass != 0]
    if len(points) != 1:
        return ""
    weights = [f for f in view.configuration.loads if f.on == points[0].name and f.name == "weight"]
    if len(weights) != 1:
        return ""
    place, down = points[0].position.fixed(), weights[0].vector.fixed()
    height = sp.expand(-sum(a * b for a, b in zip(place.components, down.components, strict=True)))
    return points[0].name if sp.cancel(height / wave).is_positive else ""


def _is_acute(view: InCoordinates, q: sp.Symbol) -> bool:
    """Whether q is between 0 and π/2 by its range: then its sine and cosine are not negative."""
    span = view.configuration.ranges.get(q)
    return span is not None and bool(span.low >= 0) and bool(span.high <= sp.pi / 2)


@record
class SwingingRate:
    """v'' = −square · v along the motion; `constants`: the velocities in it that are constant."""

    rate: sp.Symbol
    square: sp.Expr
    constants: tuple[sp.Symbol, ...]

    @property
    def frequency(self) -> sp.Expr:
        """The root of the square, √(2/7) φ' and not (√14/7) φ', for positive constants."""
        number, rest = self.square.as_coeff_Mul()
        others = sp.sqrt(rest.xreplace({c: sp.Symbol(c.name, positive=True) for c in self.constants}))
        return sp.Mul(sp.Pow(number, sp.S.Half, evaluate=False), others, evaluate=False)


def swinging_rate(equations: Sequence[tuple[sp.Expr, ...]], view: InCoordinates) -> SwingingRate | None:
    """From the stated equations, each two sides: the first two rates that drive each other."""
    slots = view.configuration.slots
    pairs = [a - b for a, b, *more in equations if not more]
    still = {prime(base(e)) for e in pairs if e.is_Symbol and e in slots.accelerations}
    for derivative in sorted({d for e in pairs for d in e.atoms(TimeDerivative)}, key=str):
        w, rate = sp.Dummy("w", real=True), sp.Dummy("rate", real=True)
        written = [e.xreplace({derivative: rate}).xreplace({derivative.args[0]: w}) for e in pairs]
        for first in (e for e in written if e.has(rate)):
            changes = from_linear_equation(first, rate)
            for v in sorted({*slots.velocities} - still, key=str):
                c = None if changes is None else sp.cancel(changes / v)
                seconds = [e for e in written if prime(base(v), 2) in e.free_symbols and e is not first]
                found = None if c is None else _driven(c, seconds, (v, w), still, view)
                if found is not None:
                    return found
    return None


def _driven(
    c: sp.Expr,
    equations: Sequence[sp.Expr],
    names: tuple[sp.Symbol, sp.Symbol],
    still: Collection[sp.Symbol],
    view: InCoordinates,
) -> SwingingRate | None:
    """v'' = −(k c) v, from w' = c v and an equation v' = −k w + d."""
    v, w = names
    slots = view.configuration.slots
    moving = {*slots.coordinates, *slots.velocities, *slots.accelerations, *slots.prescribed, t, w} - {*still}
    for e in equations:
        accelerates = from_linear_equation(e, prime(base(v), 2))
        if accelerates is None:
            continue
        k, d = -partial(accelerates, w), accelerates.xreplace({w: sp.S.Zero})
        square = textbook_form(sp.cancel(k * c))
        if any(x.free_symbols & moving for x in (c, k, d)) or not _is_square(square, still):
            continue
        if count_operations(square) <= LONGEST_CONSEQUENCE:
            return SwingingRate(v, square, tuple(sorted(square.free_symbols & {*still}, key=str)))
    return None


def _is_square(square: sp.Expr, constants: Collection[sp.Symbol]) -> bool:
    """Whether it is positive for any values of the constants that are not zero."""
    signs = ({c: s * sp.Dummy(positive=True) for c in constants} for s in (1, -1))
    return square != 0 and all(bool(square.xreplace(of).is_positive) for of in signs)
