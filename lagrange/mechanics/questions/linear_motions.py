"""Linear equations of motion solved in time: coupled ones with constant coefficients, and single ones.

Coupled linear equations of motion with constant coefficients, solved in time by Laplace's transformation.

    q'' + C q' + K q = f + Σ f_c cos Ωt + f_s sin Ωt ,      (s² + C s + K) X(s) = s q_0 + q'_0 + C q_0 + F(s)

Cramer's rule gives each X(s) as N(s)/D(s). Where D has only linear and quadratic factors, or biquadratic ones s⁴ + a s²
+ b that split into (s² + w_1²)(s² + w_2²), the partial fractions have elementary originals. Two oscillators, a charge
in uniform fields and a pendulum on the turning Earth are of this kind. The caller substitutes the solution back.

Shapes: C, K (n, n); q_0, q'_0, f (n,).

Motions q'' = A(t) + B(t) q', as of a rocket, whose mass is a function of time.

The equation is linear in the speed v = q'. With the integrating factor μ = exp(−∫ B dt), μ(0) = 1,

    v = (v_0 + ∫_0^t μ A dt)/μ ,     q = q_0 + ∫_0^t v dt .

The antiderivatives come from the table, with real logarithms of what is positive at t = 0: log X(t) is written as
log (X(t)/X(0)), so that a rocket has v = u log (m_0/m) − g t. They hold until X vanishes.

Where B = −c/X with X = X_0 + s t, as with drag beside the jet, μ is a power of R = X/X_0, and with κ = c/s

    ∫ R^p dt = X_0 (R^(p+1) − 1)/(s (p + 1)) .
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import sympy as sp

from lagrange.algebra.closed_forms.limits import HIGHEST_RATIONAL_DEGREE
from lagrange.algebra.closed_forms.polynomial_roots import factored_quotient, square_root
from lagrange.algebra.closed_forms.signs import SignCondition, more_than_zero, sign_of
from lagrange.algebra.forms.antiderivatives import antiderivative
from lagrange.core.expression_size import count_operations
from lagrange.core.symbols import prime, t
from lagrange.mechanics.questions.limits import MOST_COUPLED
from lagrange.mechanics.questions.states import SymbolValues

_S = sp.Dummy("s", real=True)
Original = tuple[sp.Expr, tuple[SignCondition, ...]]


def coupled_with(q: sp.Symbol, accelerations: SymbolValues) -> list[sp.Symbol]:
    """The coordinates whose equations of motion depend on each other, starting from one."""
    coordinates = {s for a in accelerations for s in [sp.Symbol(a.name.rstrip("'"), real=True)]}
    group, waiting = [q], [q]
    while waiting:
        a = accelerations.get(prime(waiting.pop(), 2), sp.S.Zero)
        new = [c for c in sorted(coordinates, key=str) if c not in group and {c, prime(c)} & a.free_symbols]
        group += new
        waiting += new
    return sorted(group, key=str)


def coupled_solutions(
    group: Sequence[sp.Symbol], accelerations: SymbolValues, initial: SymbolValues
) -> dict[sp.Symbol, Original]:
    """The coordinates of a group as functions of time, each with its conditions; empty if they are not found."""
    system = _system(group, accelerations)
    needed = [s for q in group for s in (q, prime(q))]
    if system is None or len(group) > MOST_COUPLED or any(s not in initial for s in needed):
        return {}
    damping, stiffness, forcing = system
    n = len(group)
    places, speeds = [initial[q] for q in group], [initial[prime(q)] for q in group]
    matrix = sp.eye(n) * _S**2 + damping * _S + stiffness
    right = [
        _S * places[j] + speeds[j] + sp.Add(*(damping[j, k] * places[k] for k in range(n))) + forcing[j]
        for j in range(n)
    ]
    below = _with_unit_squares(sp.expand(matrix.det(method="berkowitz")))
    solutions: dict[sp.Symbol, Original] = {}
    for k, q in enumerate(group):
        replaced = matrix.copy()
        for j in range(n):
            replaced[j, k] = right[j]
        original = _original(_with_unit_squares(sp.expand(replaced.det(method="berkowitz"))), below)
        if original is None:
            return {}
        solutions[q] = original
    return solutions


def _with_unit_squares(e: sp.Expr) -> sp.Expr:
    """A polynomial with sin² α = 1 − cos² α, where that is shorter: Ω² of the components Ω cos α and Ω sin α."""
    for sine in sorted(e.atoms(sp.sin), key=str):
        square = 1 - sp.cos(sine.args[0]) ** 2
        rule = {sine**n: square ** (n // 2) * sine ** (n % 2) for n in range(2, HIGHEST_RATIONAL_DEGREE + 1)}
        other = sp.expand(e.xreplace(rule))
        e = other if count_operations(other) < count_operations(e) else e
    return e


def _system(
    group: Sequence[sp.Symbol], accelerations: SymbolValues
) -> tuple[sp.Matrix, sp.Matrix, list[sp.Expr]] | None:
    """C, K and the transform of the forcing; None if the equations are not linear with constant coefficients."""
    rows = [accelerations.get(prime(q, 2)) for q in group]
    state = {s for q in group for s in (q, prime(q))}
    still = dict.fromkeys(state, sp.S.Zero)
    damping, stiffness = [], []
    forcing: list[sp.Expr] = []
    for a in rows:
        if a is None:
            return None
        damping.append([-a.diff(prime(q)) for q in group])
        stiffness.append([-a.diff(q) for q in group])
        if any(c.free_symbols & {*state, t} for c in (*damping[-1], *stiffness[-1])):
            return None
        transform = _transform(sp.expand(a.xreplace(still)))
        if transform is None:
            return None
        forcing.append(transform)
    return sp.Matrix(damping), sp.Matrix(stiffness), forcing


def _transform(forcing: sp.Expr) -> sp.Expr | None:
    """Laplace's transform of a sum of constants, cosines and sines of Ωt."""
    total = sp.S.Zero
    for term in sp.Add.make_args(forcing):
        share, wave = term.as_independent(t, as_Add=False)
        if t not in term.free_symbols:
            total += term / _S
            continue
        if not isinstance(wave, sp.cos | sp.sin) or wave.args[0].xreplace({t: sp.S.Zero}) != 0:
            return None
        w = wave.args[0].diff(t)
        if t in w.free_symbols:
            return None
        total += share * (_S if isinstance(wave, sp.cos) else w) / (_S**2 + w**2)
    return total


def _original(above: sp.Expr, below: sp.Expr) -> Original | None:
    """The function of time whose transform is a quotient of polynomials; None if it is not elementary."""
    above, below = sp.fraction(sp.cancel(sp.together(above / below)))
    if not below.is_polynomial(_S):
        return None
    pairs = list(_factors(below))
    factors = [(f, m) for f, m in pairs if f is not None]
    if len(factors) < len(pairs):
        return None
    leading = sp.LC(sp.Poly(below, _S))
    parts: list[sp.Expr] = []
    conditions: list[SignCondition] = []
    for f, m in factors:
        rest = leading * sp.Mul(*(h**k for h, k in factors if h != f))
        part = _partial(above, rest, f, m)
        if part is None:
            return None
        parts.append(part[0])
        conditions += [c for c in part[1] if c not in conditions]
    return sp.Add(*parts), tuple(conditions)


def _factors(below: sp.Expr) -> Iterator[tuple[sp.Expr | None, int]]:
    """Monic factors of degree 1 or 2 with their multiplicities; None among them where there are others."""
    for f, m in sp.factor_list(below, _S)[1]:
        poly = sp.Poly(f, _S).monic()
        if poly.degree() <= 2:
            yield poly.as_expr(), m
        elif poly.degree() == 4 and poly.coeff_monomial(_S**3) == 0 == poly.coeff_monomial(_S) and m == 1:
            squares = _two_squares(sp.factor(poly.coeff_monomial(_S**2)), sp.factor(poly.coeff_monomial(1)))
            if squares is None:
                yield None, m
                return
            yield from ((_S**2 + w, 1) for w in squares)
        else:
            yield None, m
            return


def _two_squares(a: sp.Expr, b: sp.Expr) -> tuple[sp.Expr, sp.Expr] | None:
    """w_1², w_2² with sum a and product b: (√(a + 2√b) ± √(a − 2√b))²/4 where b is a square, or with one root."""
    product = square_root(b)
    total = sp.factor(a + 2 * product)
    difference = sp.factor(a - 2 * product)
    if not any(p.is_Pow and not p.exp.is_Integer for p in product.atoms(sp.Pow)) and sign_of(difference) == 1:
        larger, smaller = _root(total), _root(difference)
        return sp.expand((larger + smaller) / 2) ** 2, sp.expand((larger - smaller) / 2) ** 2
    discriminant = sp.factor(a**2 - 4 * b)
    if sign_of(b) != 1 or sign_of(a) != 1:
        return None
    root = square_root(discriminant)
    return (a + root) / 2, (a - root) / 2


def _partial(above: sp.Expr, rest: sp.Expr, f: sp.Expr, m: int) -> Original | None:
    """The original of the partial fraction with the factor f^m of above/(rest f^m)."""
    poly = sp.Poly(f, _S)
    if poly.degree() == 1:
        pole = -poly.coeff_monomial(1)
        return _of_pole(above / rest, pole, m), ()
    if m != 1:
        return None
    p, q = poly.coeff_monomial(_S), f.xreplace({_S: sp.S.Zero})
    (a, b), (c, d) = (_remainder(e, p, q) for e in (above, rest))
    norm = c**2 * q - c * d * p + d**2
    # (a s + b)(−c s + d − c p)/norm modulo s² + p s + q
    slope, offset = _remainder(sp.expand((a * _S + b) * (-c * _S + d - c * p)), p, q)
    slope, offset = (factored_quotient(e / norm) for e in (slope, offset))
    return _of_pair(slope, offset, p, q)


def _remainder(e: sp.Expr, p: sp.Expr, q: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """The coefficients of a polynomial modulo s² + p s + q."""
    slope, offset = sp.S.Zero, sp.S.Zero
    for c in sp.Poly(sp.expand(e), _S).all_coeffs():  # Horner: (a s + b) s + c
        slope, offset = sp.expand(offset - slope * p), sp.expand(c - slope * q)
    return slope, offset


def _of_pole(quotient: sp.Expr, pole: sp.Expr, m: int) -> sp.Expr:
    value = sp.S.Zero
    for k in range(m):
        coefficient = sp.diff(quotient, _S, k).xreplace({_S: pole}) / sp.factorial(k)
        value += factored_quotient(coefficient) * t ** (m - 1 - k) / sp.factorial(m - 1 - k)
    return value * sp.exp(pole * t)


def _of_pair(slope: sp.Expr, offset: sp.Expr, p: sp.Expr, q: sp.Expr) -> Original | None:
    """The original of (slope s + offset)/(s² + p s + q): an oscillation, damped where p > 0."""
    square = q - p**2 / 4
    w = _root(square)
    sign = 1 if w.is_positive else sign_of(sp.factor(square))
    if sign in (0, -1):
        return None
    conditions = () if sign == 1 else (more_than_zero(sp.factor(square)),)
    inner = factored_quotient((offset - slope * p / 2) / w)
    return sp.exp(-p * t / 2) * (slope * sp.cos(w * t) + inner * sp.sin(w * t)), conditions


def _root(square: sp.Expr) -> sp.Expr:
    """√ of an expression, simplified if the expression is a square."""
    base, exponent = square.as_base_exp()
    if exponent == 2:
        return base
    number, rest = sp.factor(square).as_coeff_Mul()
    return sp.sqrt(number) * square_root(rest) if number > 0 else square_root(square)


# One equation, with coefficients of time


def of_rates_in_time(q: sp.Symbol, a: sp.Expr, place: sp.Expr, speed: sp.Expr) -> tuple[sp.Expr, sp.Expr] | None:
    """q(t) and q'(t) for q'' = a, from q_0 and q'_0; None if a is not of this kind, or an integral not in the table."""
    v = prime(q)
    if t not in a.free_symbols or q in a.free_symbols or not a.is_polynomial(v) or sp.degree(a, v) > 1:
        return None
    factor = a.diff(v)
    source = a.xreplace({v: sp.S.Zero})
    integral = since_start(-factor)
    if integral is None:
        return None
    if (powers := _in_powers(factor, source, place, speed)) is not None:
        return powers
    mu = sp.powsimp(sp.exp(sp.logcombine(integral))) if integral != 0 else sp.S.One
    driven = since_start(mu * source)
    if driven is None:
        return None
    rate = (speed + driven) / mu
    way = since_start(rate)
    if way is None:
        return None
    return place + _with_ratios(way), sp.factor(rate) if rate.is_rational_function(t) else _with_ratios(rate)


def _in_powers(b: sp.Expr, a: sp.Expr, place: sp.Expr, speed: sp.Expr) -> tuple[sp.Expr, sp.Expr] | None:
    """q(t) and q'(t) where −B = c/X with X linear in t, κ = c/s no number, and A a sum of powers of X."""
    c, x = sp.fraction(sp.cancel(-b))
    if t in c.free_symbols or not x.is_polynomial(t) or sp.degree(x, t) != 1:
        return None
    slope, start = x.diff(t), x.xreplace({t: sp.S.Zero})
    kappa = sp.cancel(c / slope)
    if kappa.is_number or sign_of(start) not in (1, -1):
        return None
    letter = sp.Dummy("x", real=True)
    above, below = sp.fraction(sp.cancel(a.xreplace({t: (letter - start) / slope})))
    if not above.is_polynomial(letter) or len(sp.Poly(below, letter).terms()) != 1:
        return None
    [((power,), scale)] = sp.Poly(below, letter).terms()
    shares = [(n - power, share / scale) for (n,), share in sp.Poly(above, letter).terms() if share != 0]
    ratio = sp.expand(x / start)

    def power_since_start(p: sp.Expr) -> sp.Expr | None:
        """∫_0^t R^p dt; None where p + 1 may vanish."""
        higher = sp.cancel(p + 1)
        if higher == 0:
            return start / slope * sp.log(ratio)
        return sp.cancel(start / (slope * higher)) * (ratio**higher - 1) if sign_of(higher) in (1, -1) else None

    way, rate = power_since_start(-kappa), speed * ratio ** (-kappa)
    total = place if way is None else place + speed * way
    for n, share in shares:
        further, divisor = power_since_start(sp.Integer(n + 1)), sp.factor(kappa + n + 1)
        if way is None or further is None or sign_of(divisor) not in (1, -1):
            return None
        amount = sp.cancel(share * start ** (n + 1) / (slope * divisor))
        rate += amount * (ratio ** (n + 1) - ratio ** (-kappa))
        total += amount * (further - way)
    return total, rate


def since_start(e: sp.Expr) -> sp.Expr | None:
    """∫_0^t e dt; None if it is not in the table, or a logarithm is not real at t = 0."""
    if e == 0:
        return sp.S.Zero
    if e.is_rational_function(t):
        e = sp.cancel(e)
        if max(sp.degree(part, t) for part in sp.fraction(e)) > HIGHEST_RATIONAL_DEGREE:
            return None
        e = sp.apart(e, t)
    else:
        e = sp.expand(e, log=False, power_exp=False)
    integral = antiderivative(e, t)
    if integral is None:
        return None
    integral = integral.replace(sp.Abs, lambda x: x)
    rule = {}
    for x in integral.atoms(sp.log):
        sign = sign_of(x.args[0].xreplace({t: sp.S.Zero}))
        if t in x.free_symbols and sign not in (1, -1):
            return None
        rule[x] = sp.log(sp.expand(-x.args[0])) if sign == -1 else x
    integral = integral.xreplace(rule)
    return integral - integral.xreplace({t: sp.S.Zero})


def _with_ratios(e: sp.Expr) -> sp.Expr:
    """log (X(t)/X(0)), or −log (X(0)/X(t)) where X decreases, instead of log X(0) and log X(t); each once."""
    written: dict[sp.Symbol, sp.Expr] = {}
    for x in sorted((x for x in e.atoms(sp.log) if t in x.free_symbols), key=str):
        inside, start = x.args[0], sp.factor(x.args[0].xreplace({t: sp.S.Zero}))
        constant, ratio = sp.Dummy("c", real=True), sp.Dummy("R", real=True)
        grows = sign_of(inside.diff(t).xreplace({t: sp.S.Zero})) == 1
        put = sp.expand(
            e.xreplace({sp.log(x.args[0].xreplace({t: sp.S.Zero})): constant}).xreplace(
                {x: constant + (ratio if grows else -ratio)}
            )
        )
        if sp.cancel(put.diff(constant)) == 0:
            e = put.xreplace({constant: sp.S.Zero})
            written[ratio] = sp.log(inside / start if grows else start / inside)
    rest = e.xreplace(dict.fromkeys(written, sp.S.Zero))
    if rest.is_polynomial(t):
        rest = sp.Add(*(sp.factor(share) * power for power, share in sp.collect(rest, t, evaluate=False).items()))
    elif rest.is_rational_function(t):
        rest = sp.factor(rest)
    return sp.Add(rest, *(sp.factor(e.diff(r)) * log for r, log in written.items()))
