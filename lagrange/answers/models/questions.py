"""Wrong answers to questions about a motion with one velocity: what was lost between the energy and the reaction.

Such a question is answered from the energy integral, which gives v² at a position, and from a reaction N = A + B v². So

    T_0 − ΔU = ½ M v² ,     N = A(q) + B(q) v² ,     `when` ,     quantity ,

and the usual losses are the potential energy or the ½ in the first, A or B v² in the second, or v taken as zero. An
answer is substituted into these equations with one of them changed: if they hold, that change explains it.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import combinations, permutations, product
from random import Random

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError, NoPointError, UnsupportedError, is_zero
from lagrange.answers.limits import MOST_ASKED_TERMS, MOST_IN_RATIO, MOST_LETTERS_IN_A_VALUE, VANISHING_DIGITS
from lagrange.core.records import record
from lagrange.core.symbols import base, prime, t
from lagrange.document.math_writer import text
from lagrange.document.names import Notation
from lagrange.mechanics.questions.results import Asked, IntegralKind

Substitution = dict[sp.Basic, sp.Basic]
NO_DEPENDENCE = "the right answer does not depend on"


@record
class _Change:
    """The omission: factors of T, ΔU, A and B v², whether v is treated as zero, a different T_0, and a factor of v²."""

    said: str
    kinetic: sp.Expr = sp.S.One
    potential: sp.Expr = sp.S.One
    resting: sp.Expr = sp.S.One
    moving: sp.Expr = sp.S.One
    still: bool = False
    start: sp.Expr | None = None
    square: sp.Expr = sp.S.One


_HALF = sp.Rational(1, 2)
_MOVING = "the part of {{reaction}} with the square of the velocity"
_OF_REACTION = (
    _Change(f"{_MOVING} is missing: it is that of a body at rest", moving=sp.S.Zero),
    _Change(f"only {_MOVING} is there: what the forces contribute is missing", resting=sp.S.Zero),
    _Change(f"{_MOVING} has the wrong sign", moving=sp.S.NegativeOne),
    _Change("what the forces contribute to {{reaction}} has the wrong sign", resting=sp.S.NegativeOne),
)
_OF_ENERGY = (
    _Change("the velocity is taken as zero there", still=True),
    _Change("the potential energy is missing: the velocity is taken as at the start", potential=sp.S.Zero),
    _Change("the potential energy has the wrong sign in the energy", potential=sp.S.NegativeOne),
    _Change("{less}", kinetic=sp.Integer(2)),
    _Change("{more}", kinetic=_HALF),
    _Change(
        "the square of the velocity there is half as large as it should be: is the 1/2 of T missing?", square=_HALF
    ),
    _Change("the square of the velocity there is twice as large as it should be", square=sp.Integer(2)),
)
_FROM_REST = {
    "less": "the square of the velocity is half as large as it should be: is the 1/2 of T missing?",
    "more": "the square of the velocity is twice as large as it should be",
}
_OF_A_REACTION = {
    "less": "the part of {reaction} with the square of the velocity is half as large as it should be",
    "more": "the part of {reaction} with the square of the velocity is twice as large as it should be",
}
_THROWN = {
    "less": "the kinetic energy is twice as large as it should be, or the change of the potential energy half as large",
    "more": "the kinetic energy is half as large as it should be, or the change of the potential energy twice as large",
}


def explained_answer(asked: Asked, claim: sp.Expr, of: sp.Expr | None = None, before: sp.Expr | None = None) -> str:
    """What was lost in a wrong value of the quantity asked for, or `of` a function of it; empty if not found.

    before  the kinetic energy just before an impact with which the motion begins
    """
    try:
        setting = _Setting.of(asked)
        if setting is None:
            return ""
        quantity = asked.question.quantity if of is None else of
        # Of a place or a parameter, the velocity at `when` decides; of the reaction itself, its two parts do.
        own = setting.reaction is not None and quantity.has(setting.reaction)
        changes = _OF_REACTION if setting.reaction is not None else ()
        for change in (*changes, *_OF_ENERGY) if own else (*_OF_ENERGY[:1], *changes, *_OF_ENERGY[1:]):
            if setting.gives(change, claim, quantity):
                words = _OF_A_REACTION if own else _FROM_REST if setting.start == 0 else _THROWN
                said: str = change.said.format(**words).format(reaction=setting.reaction)
                return said
        if before is not None and setting.gives(_Change("", start=before), claim, quantity):
            return "the kinetic energy is taken to be conserved in the impact, and some of it is lost there"
        if why := _of_the_force(setting, claim, quantity):
            return why
        if not setting.is_place(quantity) and (place := setting.other_place(claim, quantity)) is not None:
            return f"this is the value where {base(setting.velocity)} = {_written(place)}"
    except (DivisionByZeroError, NoPointError, UnsupportedError):
        pass
    return ""


def explained_by_energy(asked: Asked, claim: sp.Expr, of: sp.Expr | None = None) -> str:
    """Whether one part of the potential energy is lost in a wrong value, or only its value at one end counts."""
    quantity = asked.question.quantity if of is None else of
    try:
        setting = _Setting.of(asked)
        if setting is None or (setting.reaction is not None and quantity.has(setting.reaction)):
            return ""
        settings = [setting]
        q = base(setting.velocity)
        places = [dict(s)[q] for b in asked.branches for s in b.states if q in dict(s)]
        if places and not setting.is_place(quantity):  # at the right place, with a wrong velocity there
            settings.append(replace(setting, zeros=(), place={q: places[0]}))
        return next(filter(None, (_of_the_energy(s, claim, quantity) for s in settings)), "")
    except (DivisionByZeroError, NoPointError, UnsupportedError):
        return ""


def _of_the_energy(setting: _Setting, claim: sp.Expr, quantity: sp.Expr) -> str:
    q = base(setting.velocity)
    start = setting.change - sp.expand(setting.whole)
    ways = [
        (change, said)
        for sign in (1, -1)
        for change, said in (
            (
                sign * setting.whole,
                "the potential energy at the end is taken for its change: that at the start is missing",
            ),
            (sign * start, "the potential energy at the start is taken for its change: that at the end is missing"),
        )
    ]
    terms = sp.Add.make_args(sp.expand(setting.whole))
    for term in terms if 1 < len(terms) <= MOST_ASKED_TERMS else ():
        lost = term - term.xreplace({q: setting.origin})
        ways.append((setting.change - lost, f"the part {_written(_unsigned(term))} of the energy is missing"))
        ways.append(
            (setting.change - 2 * lost, f"the part {_written(_unsigned(term))} of the energy has the wrong sign")
        )
        ways.append((setting.change + lost, f"the part {_written(_unsigned(term))} of the energy is counted twice"))
        ways.append(
            (setting.change - lost / 2, f"only half of the part {_written(_unsigned(term))} of the energy is there")
        )
    for change, said in ways:
        if change != setting.change and replace(setting, change=change).gives(_Change(""), claim, quantity):
            return said
    return ""


def _of_the_force(setting: _Setting, claim: sp.Expr, quantity: sp.Expr) -> str:
    """Whether the work of a force that changes is that of a constant one, or begins at zero; a sentence, or empty."""
    q = base(setting.velocity)
    start, end = setting.origin, setting.place.get(q, claim if quantity == q else None)
    force = -sp.diff(setting.change, q)
    if end is None or q not in force.free_symbols:
        return ""
    first, last = (force.xreplace({q: place}) for place in (start, end))
    whole = "is taken for the whole way, and it changes"
    ways = [
        (-last * (q - start), f"the force at the end {whole}"),
        (-first * (q - start), f"the force at the start {whole}"),
        (-last / 2 * (q - start), "half of the force at the end is taken as its mean, and it is not zero at the start"),
        (
            setting.change.xreplace({q: q - start}) - setting.change.xreplace({q: sp.S.Zero}),
            f"the way from the start stands where {q} belongs in the potential energy",
        ),
    ]
    for change, said in ways:
        usual = said.startswith("half") and first == 0  # the mean of a linear force from zero
        if (
            not usual
            and change != setting.change
            and replace(setting, change=change).gives(_Change(""), claim, quantity)
        ):
            return said
    return ""


@record
class _Setting:
    """The equations of a question.

    velocity  q'
    inertia   M
    start     T_0
    change    ΔU
    reaction  N, and what it is; None if the question has none
    zeros     `when`: each is zero
    place     the coordinates that `when` fixes
    origin    q at the start
    whole     U
    """

    velocity: sp.Symbol
    inertia: sp.Expr
    start: sp.Expr
    change: sp.Expr
    reaction: sp.Symbol | None
    force: sp.Expr
    zeros: tuple[sp.Expr, ...]
    place: Mapping[sp.Basic, sp.Basic]
    origin: sp.Expr = sp.S.Zero
    whole: sp.Expr = sp.S.Zero

    @classmethod
    def of(cls, asked: Asked) -> _Setting | None:
        """The setting of a question that is answered from the energy alone; None if it is another."""
        energies = [i for i in asked.integrals if i.kind is not IntegralKind.IMPULSE and i.factor == 1]
        reactions = [u for u in asked.used if not u.symbol.name.endswith("'")]
        if len(energies) != 1 or len(asked.integrals) != 1 or len(reactions) > 1 or len(reactions) < len(asked.used):
            return None
        initial = {s.symbol: s.value for s in asked.initial}
        whole = sp.expand(energies[0].expression)
        velocities = sorted((s for s in whole.free_symbols if s.name.endswith("'")), key=str)
        if len(velocities) != 1:
            return None
        [v] = velocities
        inertia, rest = 2 * whole.coeff(v, 2), whole.coeff(v, 0)
        if inertia == 0 or whole.coeff(v, 1) != 0 or inertia.has(v) or base(v) not in initial or v not in initial:
            return None
        start = inertia.xreplace(initial) * initial[v] ** 2 / 2
        zeros = tuple(c.lhs - c.rhs for c in asked.question.when)
        reaction = reactions[0].symbol if reactions else None
        states = [dict(s) for b in asked.branches for s in b.states]
        fixed = [
            z
            for z in zeros
            if z.free_symbols & {base(v)} and v not in z.free_symbols and reaction not in z.free_symbols
        ]
        place: Substitution = {base(v): states[0][base(v)]} if fixed and states and base(v) in states[0] else {}
        force = reactions[0].value if reactions else sp.S.Zero
        return cls(
            v, inertia, start, rest - rest.xreplace(initial), reaction, force, zeros, place, initial[base(v)], rest
        )

    def is_place(self, quantity: sp.Expr) -> bool:
        """Whether a quantity depends on the position alone, or on parameters."""
        return not quantity.has(self.velocity, *([self.reaction] if self.reaction is not None else []))

    def other_place(self, claim: sp.Expr, quantity: sp.Expr) -> sp.Expr | None:
        """Another place where the quantity has a value that was stated; None if none of the likely ones is it."""
        q = base(self.velocity)
        if q in claim.free_symbols or not self.change.has(sp.sin, sp.cos):
            return None
        for place in (sp.S.Zero, sp.pi / 2, sp.pi, -sp.pi / 2):
            there = replace(self, place={q: place}, zeros=())
            if self.place.get(q) != place and there.gives(_Change(""), claim, quantity):
                return place
        return None

    def gives(self, change: _Change, claim: sp.Expr, quantity: sp.Expr) -> bool:
        """Whether the equations with a change hold for a value of the quantity, or of a function of it."""
        v = self.velocity
        start = self.start if change.start is None else change.start
        square = (
            sp.S.Zero if change.still else 2 * (start - change.potential * self.change / change.kinetic) / self.inertia
        ) * change.square
        force = sp.expand(self.force)
        resting = force.xreplace({v: sp.S.Zero})
        force = change.resting * resting + change.moving * (force - resting)
        stated: Substitution = {quantity: claim} if self.is_place(quantity) else {}
        known = self.place if not quantity.has(base(v)) else {}
        residuals = [z for z in self.zeros if not (z.free_symbols & {base(v)} and known)]
        if change.still:  # the condition on the reaction is replaced by v = 0
            if stated and self.reaction is not None:
                residuals = [2 * (self.start - self.change)]
            elif not self.reaction:
                return False
        if not stated:
            residuals.append(quantity - claim if v not in quantity.free_symbols else quantity**2 - claim**2)
        if not residuals:
            return False
        of_function = bool(stated) and not quantity.is_Symbol
        rule: Substitution = {} if self.reaction is None else {self.reaction: force}
        tested = not stated
        for residual in residuals:
            whole = sp.expand(residual.xreplace(rule))
            if whole.coeff(v, 0) == 0 and whole.coeff(v, 1) != 0:
                whole = sp.expand(whole**2)
            odd = whole.coeff(v, 1)
            if odd != 0 or whole.coeff(v, 0).has(v):
                return False
            reduced = whole.coeff(v, 0) + whole.coeff(v, 2) * square + whole.coeff(v, 4) * square**2
            tested |= bool(stated) and reduced.has(*quantity.free_symbols)
            if stated and is_zero(reduced) is True:
                return False  # it would hold for every value
            for more in (known, stated):
                reduced = reduced.xreplace(more)
            if reduced.has(v) or (of_function and reduced.has(base(v))) or is_zero(reduced) is not True:
                return False
        there = sp.factor(square.xreplace(dict(known)).xreplace(stated)) if stated and quantity.is_Symbol else square
        return tested and there.is_negative is not True  # v² is negative at no place


def explained_by_constant_velocity(claim: sp.Expr, asked: Asked, others: Sequence[Asked]) -> str:
    """Whether a distance is the time multiplied by the velocity at its start or end, or a time the distance divided by
    it, in a sentence; empty if not.

    others  all questions, of which one may be for the time
    """
    q = asked.question.quantity
    initial = {s.symbol: s.value for s in asked.initial}
    if q == t:
        return _of_constant_velocity(claim, asked, initial)
    if not q.is_Symbol or base(q) != q or initial.get(q, sp.S.Zero) != 0:
        return ""
    when = [c.lhs - c.rhs for c in asked.question.when]
    timed = [a for a in others if a.question.quantity == t and [c.lhs - c.rhs for c in a.question.when] == when]
    times = [v for a in timed for b in a.branches for v in b.values]
    ends = [s.get(prime(q)) for b in asked.branches for s in b.states]
    for velocity, place in ((initial.get(prime(q)), "at the start"), *((v, "at the end") for v in ends)):
        if velocity is not None and velocity != 0 and any(_same(claim, velocity * time) for time in times):
            return f"the velocity {place} {_FOR_THE_WHOLE_WAY}"
    return ""


_FOR_THE_WHOLE_WAY = "is taken for the whole way, and it changes"


def _of_constant_velocity(claim: sp.Expr, asked: Asked, initial: Mapping[sp.Symbol, sp.Expr]) -> str:
    """Whether a time is the way to the place at which it is asked for, divided by a velocity."""
    for c in asked.question.when:
        if not c.lhs.is_Symbol or c.lhs not in initial or c.rhs.has(t, c.lhs, prime(c.lhs)):
            continue
        q, way = c.lhs, c.rhs - initial[c.lhs]
        ends = [s.get(prime(q)) for b in asked.branches for s in b.states]
        for velocity, place in ((initial.get(prime(q)), "at the start"), *((v, "at the end") for v in ends)):
            if velocity is not None and velocity != 0 and _same(claim * velocity, way):
                return f"the velocity {place} {_FOR_THE_WHOLE_WAY}"
    return ""


def explained_value(claim: sp.Expr, right: sp.Expr, fixed: set[sp.Symbol], lengths: Collection[sp.Basic] = ()) -> str:
    """How a wrong value differs from the right one: the case of a parameter that is zero, a term, a factor.

    fixed    symbols that are no parameters; empty if nothing simple is found
    lengths  letters of the geometry, which are forgotten less often than others
    """
    try:
        return next(_differences(claim, right, fixed, lengths), "")
    except (DivisionByZeroError, NoPointError, UnsupportedError):
        return ""


def _differences(claim: sp.Expr, right: sp.Expr, fixed: set[sp.Symbol], lengths: Collection[sp.Basic]) -> Iterator[str]:
    """What would have to be changed, the likeliest first."""
    from lagrange.answers.models.one_place import of_arguments, of_one_place

    yield from _of_forgotten_parameters(claim, right, fixed, lengths)
    if right.is_Add:  # one of its terms is missing, which says more than that another letter is large
        yield from _of_terms(claim, right)
    yield from _of_large_parameters(claim, right, fixed, lengths)
    yield from _of_right_angles(claim, right)
    yield from _of_terms(claim, right)
    if claim.func is right.func and isinstance(right, sp.acos | sp.asin | sp.atan):
        yield from _differences(claim.args[0], right.args[0], fixed, lengths)
        return
    yield from of_arguments(claim, right)
    yield from _of_one_term(claim, right)
    yield from _of_sums(claim, right)
    ratio = _plain_ratio(claim, right)
    if ratio is not None:
        yield from _of_ratio(ratio, claim, opposite=_same(claim, -ratio * right))
        if _is_odd_number(ratio):
            return  # what follows would be another number
    yield from _of_exchanged_letters(claim, right, fixed)
    yield from of_one_place(claim, right, fixed)
    yield from _of_complements(claim, right)
    more = sorted(claim.free_symbols - right.free_symbols - fixed, key=str)
    if more:
        yield f"{NO_DEPENDENCE} {', '.join(map(str, more))}"


def _of_forgotten_parameters(
    claim: sp.Expr, right: sp.Expr, fixed: set[sp.Symbol], lengths: Collection[sp.Basic]
) -> Iterator[str]:
    """Parameters that are 0 in the answer."""
    for p in sorted(right.free_symbols - claim.free_symbols - fixed, key=lambda p: (p in lengths, str(p))):
        special = _without(sp.together(right), p)
        if special.has(sp.nan, sp.zoo, sp.oo):
            special = claim if _tends_to(right, p, claim) else sp.nan
        if special.is_finite is not False and not special.has(sp.nan, sp.zoo) and _same(claim, special):
            yield f"this is the answer without {p}, as if {p} = 0"


def _of_large_parameters(
    claim: sp.Expr, right: sp.Expr, fixed: set[sp.Symbol], lengths: Collection[sp.Basic]
) -> Iterator[str]:
    """Parameters that are very large in the answer."""
    for p in sorted(right.free_symbols - claim.free_symbols - fixed, key=str):
        if (
            p not in lengths
            and right.is_rational_function(p)
            and _same(claim, sp.cancel(sp.together(right.xreplace({p: 1 / p}))).xreplace({p: sp.S.Zero}))
        ):
            yield f"this is the answer in the limit of a very large {p}"


def _without(value: sp.Expr, p: sp.Symbol) -> sp.Expr:
    """The value for p = 0; not a number where it has none."""
    try:
        return value.xreplace({p: sp.S.Zero})
    except TypeError:  # sympy compares the argument of a tanh, which is infinite, with numbers
        return sp.nan


def _of_right_angles(claim: sp.Expr, right: sp.Expr) -> Iterator[str]:
    legs = sp.Add.make_args(sp.expand(right**2))
    if len(legs) == 2:
        sides = [sp.sqrt(leg) for leg in legs]
        if any(_same(claim, a * sides[0] + b * sides[1]) for a, b in product((1, -1), repeat=2)):
            yield "two parts at right angles are added as if they had one direction: it is the root of their squares"


def _of_terms(claim: sp.Expr, right: sp.Expr) -> Iterator[str]:
    """One term with another factor, in the answer or in a form of it."""
    for form, where in _FORMS:
        stated, derived = sp.expand(form(claim)), sp.expand(form(right))
        terms = sp.Add.make_args(derived)
        if not 1 < len(terms) <= MOST_ASKED_TERMS:
            continue
        for term in terms:
            for factor, how in _HOW:
                if _same(stated, derived + factor * term):
                    shown = sp.expand(_of_denominator(term, form(right)) if "denominator" in where else term)
                    yield how.format(f"the term {_written(_unsigned(shown))}{where}")


def _of_denominator(term: sp.Expr, inverse: sp.Expr) -> sp.Expr:
    """A term of the inverse of a value as a term of its denominator; of a sum among its factors, if that is one."""
    above, below = sp.fraction(sp.factor(inverse))
    share = sp.cancel(term * below)
    sums = [f for f in sp.Mul.make_args(above) if f.is_Add]
    parts = [sp.cancel(share * f / above) for f in sums]
    return next((p for f, p in zip(sums, parts, strict=True) if p in f.args), share)


def _plain_ratio(claim: sp.Expr, right: sp.Expr) -> sp.Expr | None:
    """The answer over the right one, up to its sign, if that is a product of few plain factors."""
    ratio = sp.powsimp(sp.powdenest(sp.sqrt(sp.factor(sp.expand(claim**2) / sp.expand(right**2))), force=True))
    if not all(map(_is_plain, sp.Mul.make_args(ratio))):
        ratio = sp.factor(sp.cancel(sp.together(claim / right)))
    factors = sp.Mul.make_args(ratio)
    if len(factors) > 3 or not all(map(_is_plain, factors)):
        return None
    return ratio if _same(claim, -ratio * right) or _same(claim, ratio * right) else None


def _is_odd_number(ratio: sp.Expr) -> bool:
    """Whether a ratio is a number whose numerator and denominator both differ from 1: 2/3."""
    above, below = sp.fraction(ratio)
    return bool(ratio.is_number and 1 not in (above**2, below**2))


def _of_ratio(ratio: sp.Expr, claim: sp.Expr, *, opposite: bool) -> Iterator[str]:
    above, below = sp.fraction(ratio)
    if _is_odd_number(ratio):
        size = abs(below / above)
        only = "its sign is wrong, and a number" if opposite else "only a number is wrong in it"
        if _is_short(size):
            yield f"{only}: it has to be {_written(size)} times as large"
        elif _is_short(size**2):
            yield f"{only}: its square has to be {_written(size**2)} times as large"
        return
    parts = ["its sign is wrong"] if opposite else []
    parts += [f"a factor {_written(below)} is missing"] if below != 1 else []
    if above != 1:
        there = above.free_symbols <= claim.free_symbols
        parts.append(
            f"there is a factor {_written(above)} too many" if there else f"it is not divided by {_written(above)}"
        )
    if parts:
        yield " and ".join(parts)


def _of_exchanged_letters(claim: sp.Expr, right: sp.Expr, fixed: set[sp.Symbol]) -> Iterator[str]:
    for p, q in combinations(sorted(right.free_symbols & claim.free_symbols - fixed, key=str), 2):
        exchanged = right.xreplace({p: q, q: p})
        if _same(claim, exchanged) and not _same(right, exchanged):  # sqrt(p^2 + q^2) is no other answer
            yield f"this is the answer with {p} and {q} exchanged"


def _of_complements(claim: sp.Expr, right: sp.Expr) -> Iterator[str]:
    for angle in sorted({a for w in claim.atoms(sp.sin, sp.cos, sp.tan) for a in w.free_symbols}, key=str):
        if _same(claim.xreplace({angle: sp.pi / 2 - angle}), right):
            yield f"this is the answer for {angle} measured from the perpendicular direction (sine and cosine)"


def _tends_to(value: sp.Expr, p: sp.Symbol, claim: sp.Expr) -> bool:
    """Whether a value tends to a claim as p → 0, judged at two random states with a very small p."""
    draw = Random(1)
    for _ in range(2):
        state = {s: sp.Rational(draw.randint(200, 900), 500) for s in sorted(value.free_symbols, key=str)}
        state[p] = sp.Rational(1, 10**VANISHING_DIGITS)
        difference = (value - claim).xreplace(state).evalf(3 * VANISHING_DIGITS)
        size = abs(claim.xreplace(state).evalf(20))
        if not difference.is_number or not bool(abs(difference) <= size * sp.Float(10) ** (-VANISHING_DIGITS // 4)):
            return False
    return True


def _of_sums(claim: sp.Expr, right: sp.Expr) -> Iterator[str]:
    """One of two masses or lengths for both together, or their sum or difference for one of them."""
    for stated, derived, said in (
        (claim, right, "this is the answer with {part} in place of {whole}"),
        (right, claim, "this is the answer with {whole} in place of {part}"),
    ):
        for form in dict.fromkeys((derived, sp.Add(*map(sp.factor, sp.Add.make_args(derived))))):
            for whole in sorted(form.atoms(sp.Add), key=str):
                parts = [a.as_coeff_Mul()[1] for a in whole.args]
                if len(parts) == 2 and all(p.is_Symbol for p in parts):
                    for part in parts:
                        if _same(stated, form.xreplace({whole: part})):
                            yield said.format(part=part, whole=_written(whole))
    letters = sorted(claim.free_symbols & right.free_symbols, key=str)
    if len(letters) > MOST_LETTERS_IN_A_VALUE:
        return
    for p, q in permutations(letters, 2):
        if _same(claim.xreplace({p: p + q}), right):
            yield f"this is the answer with {p} in place of {_written(p + q)}"


def _of_one_term(claim: sp.Expr, right: sp.Expr) -> Iterator[str]:
    """A factor that is missing in one term of a sum, or too many there."""
    own, other = ({*sp.Add.make_args(sp.expand(e))} for e in (claim, right))
    if not 1 < len(other) <= MOST_ASKED_TERMS or len(own - other) != 1 or len(other - own) != 1:
        return
    [stated], [term] = own - other, other - own
    above, below = sp.fraction(sp.powsimp(stated / term))
    if not all(map(_is_plain, sp.Mul.make_args(above * below))):
        return
    if above.is_number and below.is_number and 1 not in (above**2, below**2):
        return  # some other number: no factor was forgotten
    parts = [f"a factor {_written(below)} is missing"] if below not in (1, -1) else []
    if above not in (1, -1):
        there = above.free_symbols <= stated.free_symbols
        parts.append(f"there is a factor {_written(above)} too many" if there else f"no division by {_written(above)}")
    if parts and stated != -term:
        yield f"{' and '.join(parts)} in the term {_written(_unsigned(stated))}"


def _is_short(number: sp.Expr) -> bool:
    """Whether a number is a ratio of small numbers, and not 1."""
    return bool(number.is_Rational and number != 1 and max(number.p, number.q) <= MOST_IN_RATIO)


def _is_plain(factor: sp.Expr) -> bool:
    """Whether a factor can be named: a number, a letter, a sine, a sum of two letters."""
    inner = factor.as_base_exp()[0]
    if inner.is_Add:
        return len(inner.args) == 2 and all(a.is_Symbol for a in inner.args)
    return bool(factor.is_number or inner.is_Symbol or inner.func in (sp.sin, sp.cos, sp.tan))


_FORMS: tuple[tuple[Callable[[sp.Expr], sp.Expr], str], ...] = (
    (lambda e: e, ""),
    (lambda e: e**2, " under the root"),
    (lambda e: 1 / e, " in the denominator"),
    (lambda e: 1 / e**2, " in the denominator under the root"),
)
_HOW = (
    (sp.S.NegativeOne, "{} is missing"),
    (-sp.Integer(2), "the sign of {} is wrong"),
    (-_HALF, "only half of {} is there"),
    (sp.S.One, "{} is counted twice"),
)


def _unsigned(term: sp.Expr) -> sp.Expr:
    """A term without its sign."""
    return -term if term.could_extract_minus_sign() else term


def _same(a: sp.Expr, b: sp.Expr) -> bool:
    """Whether two values agree; a change after which one of them divides by zero is no explanation."""
    try:
        return is_zero(a - b) is True
    except DivisionByZeroError:
        return False


def _written(e: sp.Expr) -> str:
    return text(e, Notation())
