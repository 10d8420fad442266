"""Solutions of equations of motion in closed form, for the initial state.

Of an equation for one coordinate q alone:

    q'' + c q' + k q = F(t)     with constant c and k; F a sum of constants, powers of t, cosines and sines
    q'' = A(t) + B(t) q'        as of a rocket (`linear_motions.of_rates_in_time`)
    q'' = α − β q'^2            drag with the square of the velocity: u = exp(β (q − q_0)) satisfies u'' = α β u

The first has a case for each sign of the discriminant c² − 4k where that is open, and where a frequency of F may be
the natural one, resonance is a case of its own.

Coupled linear equations are in `linear_motions`. Every solution is substituted back: it satisfies the equation and
both initial values, exactly, or is not used. A case that holds for a relation between parameters is substituted where
the relation holds.

The motion from the initial state of the file, where no question is asked.

Where the equations of motion integrate in closed form this is the solution, as functions of time; otherwise the first
integrals, each with its value at t = 0.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field
from itertools import permutations, product

import sympy as sp

from lagrange.algebra.closed_forms.polynomial_roots import factored_quotient, square_root
from lagrange.algebra.closed_forms.shortest_form import shortest_form
from lagrange.algebra.closed_forms.signs import SignCondition, different_from_zero, more_than_zero, sign_of
from lagrange.algebra.exact.zero_test import is_zero
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import Unspecified, base, prime, t
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.questions.forms import (
    given_state,
    with_whole_logarithms,
    without_roots_in_logarithms,
    without_waves_of_logarithms,
)
from lagrange.mechanics.questions.limits import LONGEST_INTEGRATED, MOST_CASES, MOST_FORCING_TERMS, TIMES_ASKED
from lagrange.mechanics.questions.linear_motions import coupled_solutions, coupled_with, of_rates_in_time, since_start
from lagrange.mechanics.questions.results import Substituted, UsedIntegral
from lagrange.mechanics.questions.setting import Setting, dependent
from lagrange.mechanics.questions.states import MotionView, SymbolValues, initial_state
from lagrange.problem.model import Problem


@record
class ClosedMotion:
    """Coordinates as functions of time, in one case.

    conditions  under which it is the solution; the relation `=` is one between parameters
    speeds      the velocities that were found before the coordinates, in the form in which they are printed
    """

    solutions: Mapping[sp.Symbol, sp.Expr]
    conditions: tuple[SignCondition, ...] = ()
    speeds: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)

    def speed(self, q: sp.Symbol) -> sp.Expr:
        """q' as a function of time."""
        return self.speeds[q] if q in self.speeds else self.solutions[q].diff(t)

    def written(self, value: sp.Expr) -> sp.Expr:
        """The value of a quantity at one time, in the form in which it is printed."""
        value = without_waves_of_logarithms(value)
        written = with_whole_logarithms(lambda e: shortest_form(factored_quotient(e)), value)
        return without_roots_in_logarithms(min(value, written, key=count_operations) if self.speeds else written)

    def at_time(self, e: sp.Expr) -> sp.Expr:
        """An expression of the state as a function of time."""
        rule: dict[sp.Symbol, sp.Expr] = {}
        for q, s in self.solutions.items():
            rule |= {q: s, prime(q): self.speed(q)}
        return e.xreplace(rule)


def closed_motions(
    accelerations: SymbolValues, initial: SymbolValues, wanted: set[sp.Symbol], rates: Sequence[sp.Expr] = ()
) -> list[ClosedMotion]:
    """The wanted coordinates as functions of time, in each case; empty if one of them is not found.

    rates  what constraints on velocities make zero
    """
    cases: list[list[ClosedMotion]] = []
    waiting = sorted(wanted, key=str)
    while waiting:
        q = waiting[0]
        group = coupled_with(q, accelerations)
        equations = [accelerations.get(prime(c, 2)) for c in group]
        if any(a is None or count_operations(a) > LONGEST_INTEGRATED for a in equations):
            return []
        if any(s not in initial for c in group for s in (c, prime(c))):
            return []
        if len(group) == 1:
            motions = _of_one(q, accelerations[prime(q, 2)], initial[q], initial[prime(q)])
        else:
            motions = _of_several(group, accelerations, initial) or _in_turn(group, accelerations, initial, rates)
        if not motions:
            return []
        cases.append(motions)
        waiting = [c for c in waiting if c not in group]
    joined = []
    for combination in product(*cases):
        solutions: dict[sp.Symbol, sp.Expr] = {}
        conditions: list[SignCondition] = []
        speeds: dict[sp.Symbol, sp.Expr] = {}
        for motion in combination:
            solutions |= motion.solutions
            speeds |= motion.speeds
            conditions += [c for c in motion.conditions if c not in conditions]
        joined.append(ClosedMotion(solutions, tuple(conditions), speeds))
    return joined if len(joined) <= MOST_CASES else []


def _of_one(q: sp.Symbol, a: sp.Expr, place: sp.Expr, speed: sp.Expr) -> list[ClosedMotion]:
    """The solutions of q'' = a, verified."""
    if a.has(Unspecified):
        return []
    motions = [*_linear(q, a, place, speed)] or [*_quadratic_drag(q, a, place, speed)]
    if not motions and (both := of_rates_in_time(q, a, place, speed)) is not None:
        motions = [ClosedMotion({q: both[0]}, speeds={q: both[1]})]
    verified = [m for m in motions if _is_solution(m, q, a, place, speed)]
    return verified if len(verified) == len(motions) else []


def _of_several(group: Sequence[sp.Symbol], accelerations: SymbolValues, initial: SymbolValues) -> list[ClosedMotion]:
    """The solution of coupled linear equations, verified."""
    solutions = coupled_solutions(group, accelerations, initial)
    if not solutions:
        return []
    conditions = tuple(dict.fromkeys(c for _, more in solutions.values() for c in more))
    motion = ClosedMotion({q: _tidy(e) for q, (e, _) in solutions.items()}, conditions)
    holds = all(_is_solution(motion, q, accelerations[prime(q, 2)], initial[q], initial[prime(q)]) for q in group)
    return [motion] if holds else []


def _in_turn(
    group: Sequence[sp.Symbol], accelerations: SymbolValues, initial: SymbolValues, rates: Sequence[sp.Expr]
) -> list[ClosedMotion]:
    """The solution where some coordinates move by themselves, θ = ω t of a blade, which makes the equations of the
    others equations in time; verified in the equations as they were.

    rates  what the constraints make zero, linear in the velocities: x' sin θ − y' cos θ gives y' by x'
    """
    motion = ClosedMotion({})
    waiting = list(group)
    known = dict(accelerations)
    while waiting:
        alone = next((q for q in waiting if coupled_with(q, known) == [q]), None)
        solved = [] if alone is None else _of_one(alone, known[prime(alone, 2)], initial[alone], initial[prime(alone)])
        if alone is None:
            solved = _of_two(waiting, known, initial, [motion.at_time(e) for e in rates])
        if len(solved) != 1 or solved[0].conditions:
            return []
        [more] = solved
        speeds = {**motion.speeds, **{q: more.speed(q) for q in more.solutions}}
        motion = ClosedMotion({**motion.solutions, **more.solutions}, (), speeds)
        known = {a: more.at_time(e) for a, e in known.items() if base(a) not in more.solutions}
        waiting = [q for q in waiting if q not in more.solutions]
    holds = all(_is_solution(motion, q, accelerations[prime(q, 2)], initial[q], initial[prime(q)]) for q in group)
    return [motion] if holds else []


def _of_two(
    waiting: Sequence[sp.Symbol], accelerations: SymbolValues, initial: SymbolValues, rates: Sequence[sp.Expr]
) -> list[ClosedMotion]:
    """Two coordinates of which a constraint gives one velocity by the other, with coefficients in time."""
    for row, (first, second) in product(rates, permutations(waiting, 2)):
        v, other = prime(first), prime(second)
        slope = row.diff(other)
        if slope == 0 or slope.free_symbols & {v, other, *waiting}:
            continue
        by = (other - row / slope).expand()
        a = textbook_form(accelerations[prime(first, 2)].xreplace({other: by}))
        share = textbook_form(by.diff(v))
        if share.free_symbols & {v, other, *waiting} or a.free_symbols & {other, *waiting}:
            continue
        both = of_rates_in_time(first, a, initial[first], initial[v])
        if both is None:
            continue
        speed = textbook_form(by.xreplace({v: both[1]}))
        way = since_start(speed)
        if way is not None:
            return [ClosedMotion({first: both[0], second: initial[second] + way}, (), {first: both[1], second: speed})]
    return []


def _is_solution(motion: ClosedMotion, q: sp.Symbol, a: sp.Expr, place: sp.Expr, speed: sp.Expr) -> bool:
    """Whether the equation and the initial values are satisfied, exactly; where a relation holds, if there is one."""
    solution, rate = motion.solutions[q], motion.speed(q)
    residuals = [
        solution.diff(t) - rate,
        rate.diff(t) - motion.at_time(a),
        solution.xreplace({t: sp.S.Zero}) - place,
        rate.xreplace({t: sp.S.Zero}) - speed,
    ]
    for c in motion.conditions:
        if c.relation == "=":
            rule = _solved_relation(c.lhs - c.rhs)
            if rule is None:
                return False
            residuals = [e.xreplace(rule) for e in residuals]
    return all(map(_is_certainly_zero, residuals))


def _is_certainly_zero(e: sp.Expr) -> bool:
    """Whether an expression is zero, asked again where nested roots as √(5k − √17 k) leave it open at drawn points."""
    return next((verdict for _ in range(TIMES_ASKED) if (verdict := is_zero(e)) is not None), False)


def _solved_relation(e: sp.Expr) -> dict[sp.Symbol, sp.Expr] | None:
    """A relation between parameters, solved for one in which it is linear."""
    above = sp.expand(sp.fraction(sp.together(e))[0])
    for s in sorted(above.free_symbols, key=str):
        slope = above.diff(s)
        if s not in slope.free_symbols and slope != 0:
            return {s: sp.cancel(-above.xreplace({s: sp.S.Zero}) / slope)}
    return None


# Linear equations with constant coefficients


def _linear(q: sp.Symbol, a: sp.Expr, place: sp.Expr, speed: sp.Expr) -> Iterator[ClosedMotion]:
    v = prime(q)
    k, c = -a.diff(q), -a.diff(v)
    if {q, v, t} & (k.free_symbols | c.free_symbols):
        return
    forcing = sp.expand(a.xreplace({q: sp.S.Zero, v: sp.S.Zero}))
    k, c = sp.factor(k), sp.factor(c)
    for particular, conditions in _particular(forcing, c, k):
        rest = (place - particular.xreplace({t: sp.S.Zero}), speed - particular.diff(t).xreplace({t: sp.S.Zero}))
        for free, more in _homogeneous(c, k, *rest):
            solution = _tidy(particular + free)
            yield ClosedMotion({q: solution}, tuple(dict.fromkeys((*conditions, *more))))


def _tidy(e: sp.Expr) -> sp.Expr:
    """The terms of a solution with the same function of time together."""
    # As letters: SymPy multiplies the denominators of a term with exp(−p t) out together with exp(p t).
    letters = {f: sp.Dummy(positive=True) for f in e.atoms(sp.exp) if f.has(t)}
    expanded = sp.expand(e.xreplace(letters), deep=False, power_exp=False, log=False)
    parts: dict[sp.Expr, sp.Expr] = {}
    for term in sp.Add.make_args(sp.expand_mul(expanded)):
        share, rest = term.as_independent(t, *letters.values(), as_Add=False)
        parts[rest] = parts.get(rest, sp.S.Zero) + share
    back = {letter: f for f, letter in letters.items()}
    return sp.Add(*(factored_quotient(share) * rest.xreplace(back) for rest, share in parts.items()))


def _homogeneous(
    c: sp.Expr, k: sp.Expr, place: sp.Expr, speed: sp.Expr
) -> Iterator[tuple[sp.Expr, tuple[SignCondition, ...]]]:
    """The solutions of q'' + c q' + k q = 0 with these initial values."""
    if k == 0 and c == 0:
        yield place + speed * t, ()
    elif k == 0:
        yield place + speed / c * (1 - sp.exp(-c * t)), ()
    else:
        yield from _by_discriminant(c, k, place, speed)


def _by_discriminant(
    c: sp.Expr, k: sp.Expr, place: sp.Expr, speed: sp.Expr
) -> Iterator[tuple[sp.Expr, tuple[SignCondition, ...]]]:
    d = sp.factor(c**2 / 4 - k)
    sign = sign_of(d)
    decay = sp.exp(-c * t / 2) if c != 0 else sp.S.One
    inner = speed + c * place / 2
    if sign in (-1, None):
        w = square_root(-d)
        yield decay * (place * sp.cos(w * t) + inner / w * sp.sin(w * t)), _if_open(sign, more_than_zero(-d))
    if sign in (0, None):
        yield decay * (place + inner * t), () if sign == 0 else (_equal(d),)
    if sign in (1, None):
        w = square_root(d)
        if c == 0 or not (w / c).is_rational_function():  # e^(−2t), e^(−3t) are shorter than with their mean
            yield decay * (place * sp.cosh(w * t) + inner / w * sp.sinh(w * t)), _if_open(sign, more_than_zero(d))
            return
        slow, fast = w - c / 2, -w - c / 2
        both = ((speed - fast * place) * sp.exp(slow * t) - (speed - slow * place) * sp.exp(fast * t)) / (2 * w)
        yield both, _if_open(sign, more_than_zero(d))


def _if_open(sign: int | None, condition: SignCondition) -> tuple[SignCondition, ...]:
    return () if sign is not None else (condition,)


def _equal(e: sp.Expr) -> SignCondition:
    """e = 0 as a relation between parameters, with the negative terms on the other side."""
    condition = more_than_zero(e)
    return SignCondition(condition.lhs, "=", condition.rhs)


def _particular(forcing: sp.Expr, c: sp.Expr, k: sp.Expr) -> Iterator[tuple[sp.Expr, tuple[SignCondition, ...]]]:
    """Solutions of q'' + c q' + k q = F, for each case of resonance."""
    terms = [f for f in sp.Add.make_args(forcing) if f != 0]
    if len(terms) > MOST_FORCING_TERMS:
        return
    steady = sp.S.Zero
    waves: list[tuple[sp.Expr, sp.Expr, bool]] = []
    decaying: list[tuple[sp.Expr, sp.Expr]] = []
    for f in terms:
        share, rest = f.as_independent(t, as_Add=False)
        power = _of_power(share, rest, c, k)
        if power is not None:
            steady += power
        elif isinstance(rest, sp.cos | sp.sin) and t not in rest.args[0].diff(t).free_symbols:
            waves.append((share, rest.args[0], isinstance(rest, sp.cos)))
        elif isinstance(rest, sp.exp) and t not in (rate := rest.args[0].diff(t)).free_symbols:
            decaying.append((share * rest, rate))
        else:
            return
    of_waves, of_decays = ([*_of_wave(*w, c, k)] for w in waves), ([*_of_exponential(*e, c, k)] for e in decaying)
    for cases in product(*of_waves, *of_decays):
        conditions = tuple(dict.fromkeys(x for _, more in cases for x in more))
        if sum(x.relation == "=" for x in conditions) <= 1:
            yield steady + sp.Add(*(e for e, _ in cases)), conditions


def _of_power(share: sp.Expr, rest: sp.Expr, c: sp.Expr, k: sp.Expr) -> sp.Expr | None:
    """The particular solution for share · t^n, n = 0, 1, 2 ..."""
    n = 0 if rest == 1 else int(rest.as_base_exp()[1]) if rest.is_Pow or rest == t else None
    if n is None or rest != t**n or not 0 <= n <= 4:
        return None
    letters = sp.symbols(f"c_0:{n + 3}")
    trial = sp.Add(*(letter * t**m for m, letter in enumerate(letters)))
    residual = sp.Poly(sp.expand(trial.diff(t, 2) + c * trial.diff(t) + k * trial - share * t**n), t)
    free = [0, 1] if k == 0 and c == 0 else [0] if k == 0 else []
    rule: dict[sp.Symbol, sp.Expr] = {letters[m]: sp.S.Zero for m in free}
    for equation in residual.all_coeffs():
        equation = equation.xreplace(rule)
        unknown = [x for x in letters if x in equation.free_symbols]
        if not unknown:
            continue
        x = unknown[-1]
        slope = equation.diff(x)
        rule[x] = sp.cancel(-equation.xreplace({x: sp.S.Zero}) / slope)
        rule = {y: e.xreplace({x: rule[x]}) for y, e in rule.items()}
    return trial.xreplace(rule).xreplace(dict.fromkeys(letters, sp.S.Zero))


def _of_wave(
    share: sp.Expr, phase: sp.Expr, cosine: bool, c: sp.Expr, k: sp.Expr
) -> Iterator[tuple[sp.Expr, tuple[SignCondition, ...]]]:
    """The particular solutions for share · cos(Ω t + φ) or sin: forced oscillation, and resonance without damping."""
    w = phase.diff(t)
    wave, other = (sp.cos(phase), sp.sin(phase)) if cosine else (sp.sin(phase), -sp.cos(phase))
    detuning = sp.factor(k - w**2)
    if c != 0:
        yield share * (detuning * wave + c * w * other) / (detuning**2 + (c * w) ** 2), ()
        return
    if detuning != 0:
        yield share * wave / detuning, different_from_zero(detuning)
    if detuning == 0 or (sign_of(detuning) is None and w != 0):
        yield share * t * other / (2 * w), () if detuning == 0 else (_equal(detuning),)


def _of_exponential(
    force: sp.Expr, rate: sp.Expr, c: sp.Expr, k: sp.Expr
) -> Iterator[tuple[sp.Expr, tuple[SignCondition, ...]]]:
    """The particular solutions for F exp(p t): p² + c p + k is not 0, or p is an exponent of the free motion."""
    value = sp.factor(rate**2 + c * rate + k)
    slope = sp.factor(rate - k / rate)  # 2 p + c where p² + c p + k = 0
    sign = sign_of(value)
    if value != 0:
        yield force / value, different_from_zero(value) if sign is None else ()
    if value == 0 or sign is None:
        at_resonance = () if value == 0 else (_equal(value),)
        if slope != 0:
            yield force * t / slope, at_resonance
        else:
            yield force * t**2 / 2, at_resonance


# Drag


def _quadratic_drag(q: sp.Symbol, a: sp.Expr, place: sp.Expr, speed: sp.Expr) -> Iterator[ClosedMotion]:
    """q'' = α − β q'²: q = q_0 + log(u)/β, u'' = α β u, u(0) = 1, u'(0) = β q'_0."""
    v = prime(q)
    if not a.is_polynomial(v) or {q, t} & a.free_symbols:
        return
    powers = dict(sp.Poly(a, v).terms())
    if set(powers) - {(0,), (2,)} or (2,) not in powers:
        return
    alpha, beta = sp.factor(powers.get((0,), sp.S.Zero)), sp.factor(-powers[(2,)])
    for u, conditions in _growth(sp.factor(alpha * beta), beta * speed):
        yield ClosedMotion({q: place + sp.log(u) / beta}, conditions)


def _growth(square: sp.Expr, rate: sp.Expr) -> Iterator[tuple[sp.Expr, tuple[SignCondition, ...]]]:
    sign = sign_of(square)
    if sign == 0:
        yield 1 + rate * t, ()
    if sign == 1:
        w = square_root(square)
        yield sp.cosh(w * t) + factored_quotient(rate / w) * sp.sinh(w * t), ()
    if sign == -1:
        w = square_root(-square)
        yield sp.cos(w * t) + factored_quotient(rate / w) * sp.sin(w * t), ()


def power_drag(q: sp.Symbol, accelerations: SymbolValues, initial: SymbolValues) -> ClosedMotion | None:
    """q'' = α q'^p with p ≠ 1 and q'_0 > 0: q' = w^(1/(1 − p)), where w = q'_0^(1 − p) + (1 − p) α t is not negative.

    A boat that √q' slows down comes to rest at w = 0, and stays there; None if it is no such equation.
    """
    v, size = prime(q), sp.Dummy("v", positive=True)
    a, start, place = accelerations.get(prime(q, 2)), initial.get(v), initial.get(q)
    if a is None or start is None or place is None or sign_of(start) != 1 or count_operations(a) > LONGEST_INTEGRATED:
        return None
    alpha, power = sp.powsimp(a.xreplace({v: size})).as_independent(size, as_Add=False)
    p = power.as_base_exp()[1]
    if power != size**p or not p.is_Rational or p in (0, 1, 2) or {q, t} & alpha.free_symbols:
        return None
    rate = (1 - p) * alpha
    w = start ** (1 - p) + rate * t
    speed, grown = w ** (1 / (1 - p)), w ** ((2 - p) / (1 - p))
    way = (grown - start ** (2 - p)) / (alpha * (2 - p))
    sign = sign_of(rate)
    lasts = () if sign == 1 else (SignCondition(t, "≤", factored_quotient(-(start ** (1 - p)) / rate)),)
    at = {t: (size - start ** (1 - p)) / rate}  # where w is a positive number, so that its powers are real
    residuals = (
        speed.diff(t).xreplace(at) - a.xreplace({v: speed.xreplace(at)}),
        way.diff(t).xreplace(at) - speed.xreplace(at),
    )
    holds = sign in (1, -1) and all(map(_is_certainly_zero, residuals))
    return ClosedMotion({q: place + way}, lasts, {q: speed}) if holds else None


# Without a question


@record
class FromStart:
    """What is known about the motion from the initial state.

    choice     the coordinates; empty for the file's own
    initial    the state at t = 0 as the file gives it
    motions    coordinates as functions of time, in each case; empty if they are not found
    integrals  with their values
    """

    choice: str
    initial: tuple[Substituted, ...]
    motions: tuple[ClosedMotion, ...] = ()
    integrals: tuple[UsedIntegral, ...] = ()


def motion_from_start(
    problem: Problem, places: Sequence[MotionView], configurations: Sequence[Configuration]
) -> FromStart | None:
    """The motion in the first place in which it is found in closed form, or the integrals in the first place of all.

    Raises ProblemError if the initial state contradicts the constraints.
    """
    initial = given_state(problem)
    settings = [Setting(place, problem, initial_state(place, problem, configurations)) for place in places]
    for setting in settings:
        rule = dependent(setting.place.configuration)
        known = {a: e.xreplace(rule) for a, e in setting.known.accelerations.items()}
        wanted = {q for q in setting.place.configuration.slots.coordinates if q not in rule and prime(q) not in rule}
        motions = [] if setting.slips else closed_motions(known, setting.initial, wanted - {*setting.fixed})
        if motions and wanted:
            return FromStart(setting.place.name, initial, tuple(motions))
    return FromStart(settings[0].place.name, initial, (), tuple(settings[0].integrals)) if settings else None
