"""How values and conditions are written: square roots of products under one root, √(2 g h) for √2 √g √h."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.algebra.closed_forms.polynomial_roots import factored_quotient
from lagrange.algebra.closed_forms.shortest_form import (
    with_differences_of_squares,
    with_whole_contents,
    without_leading_minus,
)
from lagrange.algebra.closed_forms.signs import SignCondition, always_holds, more_than_zero, not_negative, sign_of
from lagrange.algebra.exact.zero_test import is_zero
from lagrange.core.expression_size import count_operations
from lagrange.core.symbols import prime, sign_in_range, without_known_magnitudes
from lagrange.mechanics.questions.limits import LONGEST_MULTIPLIED_OUT
from lagrange.mechanics.questions.results import AnswerBranch, Asked, Substituted
from lagrange.problem.model import Problem


def rate_of(q: sp.Expr) -> sp.Expr:
    """The velocity of a coordinate, or the rate of a sum of coordinates: x_2' - x_1' of the distance x_2 - x_1."""
    return sp.Add(*(q.diff(s) * prime(s) for s in q.free_symbols)) if q.is_Add else sp.Symbol(f"{q}'", real=True)


def under_one_root(e: sp.Expr) -> sp.Expr:
    """The expression with the square roots of a product under one root. It is to be shown, not to be computed with."""
    if e.is_Atom:
        return e
    if e.is_Mul:
        return _product(e)
    if e.is_Add:
        return sp.Add(*(under_one_root(a) for a in e.args), evaluate=False)
    if e.is_Function:
        return e.func(*(under_one_root(a) for a in e.args), evaluate=False)
    if e.is_Pow and e.base.is_Function:
        return sp.Pow(under_one_root(e.base), e.exp, evaluate=False)
    return e


def without_roots_below(e: sp.Expr) -> sp.Expr:
    """A short value with roots in its denominator, multiplied out without them where that is shorter."""
    if not e.is_Mul or count_operations(e) > LONGEST_MULTIPLIED_OUT or e.is_polynomial(*e.free_symbols):
        return e
    below = sp.fraction(e)[1]
    if not any(p.exp.is_Rational and not p.exp.is_Integer and p.base.is_Add for p in below.atoms(sp.Pow)):
        return e
    other = sp.factor_terms(sp.radsimp(sp.expand(e)))
    return other if count_operations(other) < count_operations(e) and is_zero(other - e) is True else e


def with_root_as_letter(e: sp.Expr) -> sp.Expr:
    """√(w − g) for √(w² − g w)/√w with w = √(a² + g²), where that is shorter: a sum that is w² is divided by w."""
    if count_operations(e) > LONGEST_MULTIPLIED_OUT:
        return e
    roots = [p for p in e.atoms(sp.Pow) if p.base.is_Add and p.exp.is_Rational and p.exp.q in (2, 4)]
    for base in dict.fromkeys(p.base for p in roots if p.exp.q == 2):
        w = sp.Dummy(positive=True)
        lettered = e.xreplace({p: w ** (2 * p.exp) for p in roots if p.base == base})
        for s in sorted(base.free_symbols, key=str):
            lead = sp.expand(base).coeff(s, 2)
            rest = sp.expand(base - lead * s**2)
            if lead == 0 or s in lead.free_symbols | rest.free_symbols:
                continue
            other = _without_square(lettered, s, (w**2 - rest) / lead).xreplace({w: sp.sqrt(base)})
            if count_operations(other) < count_operations(e) and is_zero(other - e) is True:
                return other
    return e


def _without_square(e: sp.Expr, s: sp.Symbol, value: sp.Expr) -> sp.Expr:
    """The expression with s² = value in each sum, in factors."""
    if e.is_Add:
        return sp.factor(sp.expand(e).xreplace({s**2: value}))
    return e if e.is_Atom else e.func(*(_without_square(a, s, value) for a in e.args))


def with_factors(e: sp.Expr) -> sp.Expr:
    """A product with its sums multiplied out and factored, where that is shorter: m p (g p − v²) for what is longer."""
    above, below = (sp.Mul(*map(_factored, sp.Mul.make_args(part))) for part in sp.fraction(e))
    other = above / below
    return other if count_operations(other) < count_operations(e) else e


def _factored(f: sp.Expr) -> sp.Expr:
    base, exponent = f.as_base_exp()
    if not base.is_Add or base.has(sp.log, sp.exp) or count_operations(base) > LONGEST_MULTIPLIED_OUT:
        return f
    roots = [p for p in base.atoms(sp.Pow) if not p.exp.is_Integer]
    letters = {p: sp.Dummy(positive=True) for p in roots}  # 2n (A + C) − 2n A − 2n C beside a root: terms may cancel
    multiplied = sp.expand(base.xreplace(letters)).xreplace({letter: p for p, letter in letters.items()})
    other = multiplied if roots else sp.factor(multiplied)
    return other**exponent if count_operations(other) < count_operations(base) else f


def _product(e: sp.Expr) -> sp.Expr:
    inside: list[sp.Expr] = []
    outside: list[sp.Expr] = []
    number: sp.Expr = sp.S.One
    for f in e.args:
        base, exponent = f.as_base_exp()
        if f.is_Rational:
            number = number * f
        elif exponent in (sp.S.Half, -sp.S.Half):
            inside.append(base if exponent == sp.S.Half else 1 / base)
        elif f.is_number and f.is_positive and f.is_Pow and exponent.is_Rational and exponent.q == 4:
            inside.append(f**2)  # √(√3 g/l) for 3^(1/4) √(g/l)
        else:
            outside.append(under_one_root(f))
    if len(inside) < 2 and not (inside and inside[0].is_Rational is False and _fits(number, inside[0])):
        parts = [under_one_root(f) for f in e.args]
        return e if list(e.args) == parts else sp.Mul(*parts, evaluate=False)
    if number == 1 and outside and all(1 / b != 1 and sp.fraction(b)[0] == 1 for b in inside):
        below = sp.Pow(sp.Mul(*(1 / b for b in inside)), -sp.S.Half, evaluate=False)
        return sp.Mul(*outside, below, evaluate=False)  # m v/√((M + m) k)
    radicand = without_leading_minus(sp.Mul(*inside))
    if _fits(number, radicand):  # √(2/3 g R) for √6/3 √(g R)
        radicand, number = number**2 * radicand, sp.sign(number)
    root = sp.Pow(radicand, sp.S.Half, evaluate=False)
    factors = [*([number] if number != 1 else []), *outside, root]
    return factors[0] if len(factors) == 1 else sp.Mul(*factors, evaluate=False)


def without_roots_in_logarithms(e: sp.Expr) -> sp.Expr:
    """log √x as log(x)/2, also where the root is in a denominator."""

    def shorter(f: sp.Expr) -> sp.Expr:
        inner = f.args[0]
        if not inner.is_Mul or not inner.is_positive or inner.is_number:
            return f
        square = sp.cancel(sp.together(inner**2))
        has_root = any(p.exp.is_Rational and not p.exp.is_Integer for p in square.atoms(sp.Pow))
        return f if has_root or count_operations(square) >= count_operations(inner) else sp.log(square) / 2

    return e.replace(lambda f: isinstance(f, sp.log), shorter)


def without_waves_of_logarithms(e: sp.Expr) -> sp.Expr:
    """√(u² − 1)/u for tanh(log(u + √(u² − 1))): hyperbolic functions of logarithms are algebraic."""

    def algebraic(f: sp.Expr) -> sp.Expr:
        number, log = f.args[0].as_coeff_Mul()
        if not isinstance(log, sp.log) or not (2 * number).is_Integer or abs(number) > 1:
            return f
        grown = log.args[0]
        shrunk = sp.radsimp(1 / grown) if grown.is_Add else 1 / grown
        if is_zero(sp.expand(grown * shrunk) - 1) is not True:
            return f
        sign = 1 if number > 0 else -1
        if abs(number) == sp.S.Half:
            grown, shrunk = sp.sqrt(grown), sp.sqrt(shrunk)
        cosine, sine = (sp.expand(grown + shrunk) / 2, sign * sp.expand(grown - shrunk) / 2)
        return {sp.cosh: cosine, sp.sinh: sine, sp.tanh: sine / cosine}[f.func]

    return e.replace(lambda f: isinstance(f, sp.cosh | sp.sinh | sp.tanh) and f.has(sp.log), algebraic)


def with_exponentials_under_roots(e: sp.Expr) -> sp.Expr:
    """√(1 − exp(−2x)) for √(exp(2x) − 1) exp(−x), in a product."""
    for wave in [f for f in sp.Mul.make_args(e) if isinstance(f, sp.exp)]:
        for root in [f for f in sp.Mul.make_args(e) if f.is_Pow and f.exp == sp.S.Half and f.base.is_Add]:
            inside = sp.expand(root.base * wave**2)
            if wave in sp.Mul.make_args(e) and count_operations(inside) <= count_operations(root.base) + 1:
                e = e / wave / root * sp.sqrt(inside)
    return e


def with_whole_logarithms(form: Callable[[sp.Expr], sp.Expr], e: sp.Expr) -> sp.Expr:
    """An expression in another form in which log(a/b) has not become log a − log b, and is −log(b/a) where a < b."""
    logarithms = e.atoms(sp.log)
    letters: dict[sp.Expr, sp.Expr] = {}
    back: dict[sp.Expr, sp.Expr] = {}
    for f in logarithms:
        if not any(f in g.args[0].atoms(sp.log) for g in logarithms):
            letter, below = sp.Dummy(real=True), _is_below_one(f.args[0])
            letters[f] = -letter if below else letter
            back[letter] = sp.log(factored_quotient(1 / f.args[0] if below else f.args[0]))
    return form(e.xreplace(letters)).xreplace(back)


def with_joined_logarithms(e: sp.Expr) -> sp.Expr:
    """g log(a/b) for g log a − g log b, so that arguments of logarithms are dimensionless."""
    return e.replace(lambda f: f.is_Add and len(f.atoms(sp.log)) > 1, _joined_logarithms)


def _joined_logarithms(e: sp.Expr) -> sp.Expr:
    shares: dict[sp.Expr, list[sp.Expr]] = {}
    rest: list[sp.Expr] = []
    for term in e.args:
        logs = [f for f in sp.Mul.make_args(term) if isinstance(f, sp.log) and f.args[0].is_positive]
        share = term / logs[0] if len(logs) == 1 else sp.S.Zero
        if share == 0 or share.has(sp.log):
            rest.append(term)
        elif -share in shares:
            shares[-share].append(1 / logs[0].args[0])
        else:
            shares.setdefault(share, []).append(logs[0].args[0])
    joined = []
    for share, inner in shares.items():
        whole = factored_quotient(sp.Mul(*inner))
        below = len(inner) > 1 and _is_below_one(whole)
        joined.append(-share * sp.log(factored_quotient(1 / whole)) if below else share * sp.log(whole))
    return sp.Add(*rest, *joined)


def _is_below_one(e: sp.Expr) -> bool:
    above, below = sp.fraction(sp.together(e))
    return below != 1 and sign_of(above) == sign_of(below) == 1 and sign_of(sp.expand(below - above)) == 1


def _fits(number: sp.Expr, radicand: sp.Expr) -> bool:
    """Whether a fraction goes under a root without leaving a larger number there."""
    inner = radicand.as_coeff_Mul()[0]
    return bool(number.q > 1 and inner != 1 and (number**2 * inner).q < number.q**2)


def joined_conditions(conditions: Iterable[SignCondition]) -> tuple[SignCondition, ...]:
    """Each condition once, without what always holds; a ≥ b and a ≠ b are a > b."""
    plain = [p for c in conditions for p in _without_exponential(c)]
    kept = [c for c in dict.fromkeys(plain) if not always_holds(c)]
    different = [c for c in kept if c.relation == "≠"]
    result: list[SignCondition] = []
    for c in kept:
        if c.relation == "≠" and any(o.relation in (">", "<", "≥", "≤") and _sense(c, o) for o in kept):
            continue
        if c.relation in ("≥", "≤"):
            same = next(((o, sense) for o in different if (sense := _sense(c, o))), None)
            c = c if same is None else _strict(c, *same)
        if c not in result:
            result.append(c)
    return tuple(result)


def _strict(c: SignCondition, other: SignCondition, sense: int) -> SignCondition:
    """a > b for a ≥ b and a ≠ b, with the shorter of their sides: l² > b² sin² α for l² + b² cos² α ≥ b²."""
    relation = {"≥": ">", "≤": "<"}[c.relation]
    if count_operations(other.lhs - other.rhs) >= count_operations(c.lhs - c.rhs):
        return SignCondition(c.lhs, relation, c.rhs)
    sides = (other.lhs, other.rhs) if sense == 1 else (other.rhs, other.lhs)
    return SignCondition(sides[0], relation, sides[1])


def _sense(c: SignCondition, other: SignCondition) -> int:
    """1 where two conditions compare the same, −1 where they do with their sides exchanged, 0 where they do not."""
    first, second = _between(c), _between(other)
    if first.free_symbols != second.free_symbols:
        return 0
    return next((s for s in (1, -1) if first == s * second or is_zero(first - s * second) is True), 0)


def _without_exponential(c: SignCondition) -> tuple[SignCondition, ...]:
    """x ≥ 0 for exp(k x) ≥ 1."""
    for side, other, turned in ((c.lhs, c.rhs, False), (c.rhs, c.lhs, True)):
        if isinstance(side, sp.exp) and other == 1 and c.relation in (">", "≥", "<", "≤"):
            exponent = -side.args[0] if turned != (c.relation in ("<", "≤")) else side.args[0]
            if c.relation in (">", "<"):
                return (more_than_zero(exponent),)
            plain = not_negative(exponent)
            return (c,) if plain is None else plain
    return (c,)


def _between(c: SignCondition) -> sp.Expr:
    return sp.expand(c.lhs - c.rhs)


def with_real_roots(b: AnswerBranch) -> AnswerBranch:
    """The branch with √(a − b) for √(b − a)/i where a > b is one of its conditions."""
    if not any(e.has(sp.I) for e in (b.rhs, *b.values)):
        return b
    positive = [c.lhs - c.rhs for c in b.conditions if c.relation in (">", "≥")]
    positive += [c.rhs - c.lhs for c in b.conditions if c.relation in ("<", "≤")]

    def real(root: sp.Expr) -> sp.Expr:
        negative = any(sign_of(sp.cancel(-root.base / p)) == 1 for p in positive)
        return sp.I ** (2 * root.exp) * sp.Pow(sp.expand(-root.base), root.exp) if negative else root

    def rewritten(e: sp.Expr) -> sp.Expr:
        return e.replace(lambda f: f.is_Pow and f.exp.is_Rational and f.exp.q == 2 and f.base.is_Add, real)

    values = tuple(map(rewritten, b.values))
    if any(v.has(sp.I) for v in values):
        return b
    return replace(b, rhs=rewritten(b.rhs), values=values)


def shown(b: AnswerBranch) -> AnswerBranch:
    """The branch as it is printed."""
    b = with_real_roots(b)
    rhs = _over_positive(without_known_magnitudes(b.rhs))
    rhs = without_leading_minus(with_whole_contents(with_factors(with_root_as_letter(without_roots_below(rhs)))))
    rhs = with_number_apart(with_half_angle(with_tanh(rhs)))
    rhs = with_known_signs(with_joined_logarithms(rhs), b.conditions)
    rhs = with_exponentials_under_roots(with_common_number(rhs))
    rhs = under_one_root(rhs)
    conditions = settled(joined_conditions(b.conditions), rhs)
    return replace(b, rhs=with_differences_of_squares(rhs), conditions=conditions)


def with_common_number(e: sp.Expr) -> sp.Expr:
    """27 (R − a)/10 for 27 R/10 − 27 a/10: a number that all terms of a sum have before them."""
    parts = [term.as_coeff_Mul() for term in e.args] if e.is_Add else []
    numbers = {abs(number) for number, _ in parts}
    if len(numbers) != 1 or numbers == {sp.S.One} or any(rest == 1 for _, rest in parts):
        return e
    [number] = numbers
    return sp.Mul(number, sp.Add(*(c / number * rest for c, rest in parts)), evaluate=False)


def _over_positive(e: sp.Expr) -> sp.Expr:
    """√(2 g R/cos α) for √(2 g R cos α)/cos α with an acute angle α."""
    for f in sp.Mul.make_args(sp.fraction(e)[1]) if e.is_Mul else ():
        root = next((r for r in e.args if r.is_Pow and r.exp == sp.S.Half and f in sp.Mul.make_args(r.base)), None)
        if root is not None and sign_in_range(f) == 1:
            e = e * f / root * sp.Pow(root.base / f**2, sp.S.Half)
    return e


def with_tanh(e: sp.Expr) -> sp.Expr:
    """tanh for sinh/cosh of the same: the speed √(m g/c) tanh(√(c g/m) t) of a fall through air."""
    for sine in e.atoms(sp.sinh) if e.is_Mul else ():
        if sine in e.args and 1 / sp.cosh(sine.args[0]) in e.args:
            e = e * sp.cosh(sine.args[0]) / sine * sp.tanh(sine.args[0])
    return e


def with_half_angle(e: sp.Expr) -> sp.Expr:
    """2 arctan(F/(m g)) for arccos((m² g² − F²)/(m² g² + F²)): tan²(θ/2) = (1 − cos θ)/(1 + cos θ), a square here."""
    if (
        not isinstance(e, sp.acos)
        or not e.args[0].is_rational_function()
        or count_operations(e) > LONGEST_MULTIPLIED_OUT
    ):
        return e
    cosine = e.args[0]
    squares = sp.factor(sp.cancel((1 - cosine) / (1 + cosine)))
    tangent = sp.sqrt(squares)
    if not tangent.is_rational_function() or tangent.is_positive is not True:
        return e
    short = 2 * sp.atan(tangent)
    return short if count_operations(short) < count_operations(e) else e


def with_number_apart(e: sp.Expr) -> sp.Expr:
    """1 − m² v²/(2 (M + m)² g l) for (2 (M + m)² g l − m² v²)/(2 (M + m)² g l), where that is shorter."""
    above, below = sp.fraction(e)
    if (
        not above.is_Add
        or below.is_number
        or not e.is_rational_function()
        or count_operations(e) > LONGEST_MULTIPLIED_OUT
    ):
        return e
    terms, divisor = (sp.expand(part).as_coefficients_dict() for part in (above, below))
    numbers = {terms[m] / divisor[m] for m in divisor if m in terms}
    forms = (sp.Add(n, sp.factor(above - n * below) / below, evaluate=False) for n in numbers)
    return min((e, *forms), key=count_operations)


def with_known_signs(e: sp.Expr, conditions: Iterable[SignCondition]) -> sp.Expr:
    """A sum with −(a − b) for the factor b − a of a term where a > b is one of the conditions.

    The speed at burnout is u log(m_0/m_1) − g (m_0 − m_1)/q, since m_0 > m_1.
    """
    greater = {sp.expand(c.lhs - c.rhs) for c in conditions if c.relation in (">", "≥")}
    greater |= {sp.expand(c.rhs - c.lhs) for c in conditions if c.relation in ("<", "≤")}
    if not e.is_Add or not greater:
        return e

    def positive(term: sp.Expr) -> sp.Expr:
        for f in sp.Mul.make_args(term):
            if f.is_Add and sp.expand(-f) in greater and term != f:
                return sp.Mul(-1, term / f, sp.expand(-f), evaluate=False)
        return term

    terms = [*map(positive, e.args)]
    return e if terms == list(e.args) else sp.Add(*terms, evaluate=False)


def settled(conditions: Sequence[SignCondition], value: sp.Expr) -> tuple[SignCondition, ...]:
    """The conditions, > for ≥ of what the value is divided by, and without a ≠ that an inequality implies."""
    _, below = sp.fraction(sp.together(value))
    divisors = {f.as_base_exp()[0] for f in sp.Mul.make_args(below)}
    strict = [
        replace(c, relation={"≥": ">", "≤": "<"}[c.relation])
        if c.relation in ("≥", "≤") and {c.lhs - c.rhs, c.rhs - c.lhs} & divisors
        else c
        for c in conditions
    ]
    above = [(c.lhs - c.rhs) * (1 if c.relation == ">" else -1) for c in strict if c.relation in ("<", ">")]

    def is_implied(c: SignCondition) -> bool:
        sides = (c.lhs - c.rhs, c.rhs - c.lhs) if c.relation == "≠" else ()
        return any(sign_of(sp.expand(e - p)) in (0, 1) for e in sides for p in above)

    return without_weaker(c for c in strict if not is_implied(c))


def under(conditions: Sequence[SignCondition], asked: Asked) -> Asked:
    """The answer with further conditions in each of its branches."""
    branches = (replace(b, conditions=without_weaker((*b.conditions, *conditions))) for b in asked.branches)
    return replace(asked, branches=tuple(branches)) if conditions else asked


def without_weaker(conditions: Iterable[SignCondition]) -> tuple[SignCondition, ...]:
    """The conditions, each once, without a ≥ b if a > b is among them."""
    kept = tuple(dict.fromkeys(conditions))

    def above(c: SignCondition) -> sp.Expr:
        return sp.expand(c.lhs - c.rhs if c.relation in (">", "≥") else c.rhs - c.lhs)

    strict = {above(c) for c in kept if c.relation in ("<", ">")}

    def is_weaker(c: SignCondition) -> bool:
        return c.relation in ("≥", "≤") and above(c) in strict

    return tuple(c for c in kept if not is_weaker(c))


def given_state(problem: Problem) -> tuple[Substituted, ...]:
    """The state at t = 0 as the file gives it."""
    return tuple(Substituted(v.symbol, under_one_root(v.value), v.measured, v.hides_units) for v in problem.initial)
