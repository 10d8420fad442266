"""A wrong value that differs from the right one in a single place: a letter, a factor, a function, an argument.

    sqrt((m g l/2 + c l^2)/(m l^2/3))     l for a in one term of a sum, wherever the sum stands
    m g/k (1 - cos(sqrt(m/k) t))          the reciprocal of the frequency in an argument
    sqrt(c/(m_1 + m_2))                   the sum of two masses for the reduced mass m_1 m_2/(m_1 + m_2)

The right value is an expression whose nodes have numbers at a random state. A change of one node changes the number of
the whole, which is compared with that of the claim: microseconds a change. What agrees at two states is tested exactly
before it is said.
"""

from __future__ import annotations

import cmath
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import permutations
from random import Random

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError, NoPointError, UnsupportedError, is_zero
from lagrange.answers.limits import (
    CLOSE_IN_FLOATS,
    LONGEST_SQUARE,
    MOST_ASKED_TERMS,
    MOST_IN_RATIO,
    MOST_LETTERS_IN_A_VALUE,
    MOST_NODES_OF_A_VALUE,
)
from lagrange.answers.readings import Reading
from lagrange.document.math_writer import text
from lagrange.document.names import Notation

_State = Mapping[sp.Basic, complex]
_FUNCTIONS: dict[type, Callable[[complex], complex]] = {
    sp.sin: cmath.sin, sp.cos: cmath.cos, sp.tan: cmath.tan, sp.exp: cmath.exp, sp.log: cmath.log,
    sp.asin: cmath.asin, sp.acos: cmath.acos, sp.atan: cmath.atan, sp.Abs: abs,
    sp.sinh: cmath.sinh, sp.cosh: cmath.cosh, sp.tanh: cmath.tanh,
}  # fmt: skip
_OTHER_WAVE = {sp.sin: sp.cos, sp.cos: sp.sin}


def of_arguments(claim: sp.Expr, right: sp.Expr) -> Iterator[str]:
    """What is wrong inside one function: its argument, or that it is another one."""
    tested = _Tested.of(claim, right)
    if tested is None:
        return
    for wave in sorted(right.atoms(sp.sin, sp.cos, sp.tan, sp.exp, sp.log), key=str):
        inside = wave.args[0]
        for other, said in _other_functions(wave):
            if tested.is_claim(wave, other):
                yield said
        rate, rest = inside.as_independent(*_moving(inside)) if _moving(inside) else (sp.S.One, inside)
        for factor, how in (
            (sp.Integer(2), "twice as large as it should be"),
            (sp.Rational(1, 2), "half as large as it should be"),
        ):
            if tested.is_claim(wave, wave.func(factor * inside)):
                yield f"the argument of {wave.func.__name__} is {how}"
        if rate not in (0, 1) and not rate.is_number and tested.is_claim(wave, wave.func(rest / rate)):
            yield f"the factor {_written(rate)} in the argument of {wave.func.__name__} is the other way round"


def of_one_place(claim: sp.Expr, right: sp.Expr, fixed: Collection[sp.Basic] = ()) -> Iterator[str]:
    """Which single letter or factor of a term is wrong.

    fixed  symbols that are no parameters
    """
    letters = sorted((claim.free_symbols | right.free_symbols) - {*fixed}, key=str)
    if len(letters) > MOST_LETTERS_IN_A_VALUE:
        return
    for form in (right, sp.together(right)):
        tested = _Tested.of(claim, form)
        if tested is None:
            continue
        yield from _reduced_masses(tested, letters)
        for letter in (s for s in letters if s in form.free_symbols):
            for sign, how in ((1, "has to be added to it"), (-1, "has to be subtracted from it")):
                if tested.is_sum(-sign * letter):
                    yield f"{letter} {how}"
        waves = sorted({w for e in (claim, form) for w in e.atoms(sp.sin, sp.cos, sp.tan)}, key=str)
        for whole in sorted((a for a in form.atoms(sp.Add) if len(a.args) <= MOST_ASKED_TERMS), key=str):
            for term in whole.args:
                for other, said in _other_terms(term, letters, waves):
                    if tested.is_claim(whole, whole - term + other):
                        yield said
        for term in form.args if form.is_Add else ():
            if (ratio := tested.ratio(term)) is not None and tested.is_claim(form, form + (ratio - 1) * term):
                yield f"the term {_written(ratio * term)} has to be {_written(1 / ratio)} times as large"


def wrong_square(square: sp.Expr, right: Sequence[sp.Expr], values: Mapping[sp.Symbol, sp.Expr]) -> str:
    """In which place the square of a frequency differs from one of several right ones; a sentence, or empty."""
    for other in (sp.expand(sp.cancel(r)) for r in right if sp.count_ops(r) <= LONGEST_SQUARE):
        if why := next(of_one_place(sp.expand(square).xreplace(dict(values)), other.xreplace(dict(values))), ""):
            return f"in omega^2 = {_written(square)}, {why}" if len(right) > 1 else f"in omega^2, {why}"
    return ""


def of_damping(claim: sp.Expr, right: sp.Expr, *, squared: bool) -> str:
    """Which single place is wrong in the square of a damped frequency, or in a decay rate; a sentence, or empty."""
    claim, right = sp.expand(claim), sp.expand(right)
    what = "omega^2" if squared else "the decay rate"
    if not squared and claim != 0 and right != 0 and (ratio := sp.cancel(claim / right)).is_Rational and ratio != 1:
        return f"the decay rate {_written(claim)} has to be {_written(1 / ratio)} times as large"
    why = next(of_one_place(claim, right), "")
    return f"in {what} = {_written(claim)}, {why}" if why else ""


def _other_terms(
    term: sp.Expr, letters: Sequence[sp.Symbol], waves: Sequence[sp.Expr]
) -> Iterator[tuple[sp.Expr, str]]:
    shown = _written(-term if term.could_extract_minus_sign() else term)
    for p in (s for s in letters if s in term.free_symbols):
        for q in letters:
            if q != p:
                other = term.xreplace({p: q})
                yield other, f"{q} stands where {p} belongs in the term {_written(other)}"
    for factor in (*waves, *letters):
        present = factor in term.atoms(sp.Symbol, sp.sin, sp.cos, sp.tan)
        if present:
            yield term / factor, f"a factor {_written(factor)} is missing in the term {_written(term / factor)}"
        yield term * factor, f"there is a factor {_written(factor)} too many in the term {_written(term * factor)}"
    for number, how in (
        (sp.Integer(2), "twice"),
        (sp.Rational(1, 2), "half"),
        (sp.Integer(4), "four times"),
        (sp.Rational(1, 4), "a quarter of"),
    ):
        yield term * number, f"{how} the term {shown} is there"
    yield -term, f"the sign of the term {shown} is wrong"
    yield sp.S.Zero, f"the term {shown} is missing"


def _reduced_masses(tested: _Tested, letters: Sequence[sp.Symbol]) -> Iterator[str]:
    """The sum of two masses, or one of them, for the reduced mass, and the other way round: ω² or a force."""
    above, below = sp.fraction(sp.together(tested.right**2))
    both = above.free_symbols & below.free_symbols  # 1/m_1 + 1/m_2 has them above and below
    for a, b in permutations([s for s in letters if s in both], 2):
        for first, second in ((a, b), (2 * a, b)):
            reduced = first * second / (first + second)
            whole = _written(reduced)
            for other in (first + second, *((first, second) if first != a or str(a) < str(b) else ())):
                for power in (1, -1, sp.Rational(1, 2), sp.Rational(-1, 2)):
                    if tested.is_times((other / reduced) ** power):
                        yield f"{_written(other)} stands where the reduced mass {whole} belongs"
                        return


def _other_functions(wave: sp.Expr) -> Iterator[tuple[sp.Expr, str]]:
    other = _OTHER_WAVE.get(wave.func)
    inside = wave.args[0]
    if other is not None:
        yield other(inside), f"sine and cosine are exchanged in {_written(wave)}"
    if isinstance(wave, sp.sin | sp.tan):
        yield inside, f"{_written(inside)} stands where {_written(wave)} belongs, as for a small angle"
    if isinstance(wave, sp.exp):
        yield 1 + inside, f"{_written(1 + inside)} stands where {_written(wave)} belongs"
        yield sp.exp(-inside), f"the sign of the exponent in {_written(wave)} is wrong"


def other_waves(
    wrong: Sequence[Sequence[Reading]], angles: Collection[sp.Symbol]
) -> Iterator[tuple[str, list[tuple[Reading, ...]]]]:
    """One equation with sine and cosine exchanged, or with an angle that occurs alone replaced by its sine."""
    if [len(r.components) for a in wrong for r in a] != [1]:
        return
    [[reading]] = wrong
    [e] = reading.components
    waves = sorted(e.atoms(sp.sin, sp.cos), key=str)
    for wave in waves:
        other = _OTHER_WAVE[wave.func](wave.args[0])
        changed = replace(reading, components=(e.xreplace({wave: other}),))
        yield f"{_written(wave)} stands where {_written(other)} belongs", [(changed,)]
    letters = {w: sp.Dummy() for w in waves}
    plain = e.xreplace(letters)
    back = {letter: w for w, letter in letters.items()}
    for q in sorted((s for s in plain.free_symbols if s in angles), key=str):
        changed = replace(reading, components=(plain.xreplace({q: sp.sin(q)}).xreplace(back),))
        yield f"{q} stands where sin({q}) belongs, as for a small angle", [(changed,)]


def _moving(inside: sp.Expr) -> set[sp.Symbol]:
    """The letter in which an argument is linear: t in ω t."""
    return {s for s in inside.free_symbols if isinstance(s, sp.Symbol) and s.name == "t"}


class _Tested:
    """A right value and a claim at two random states."""

    def __init__(self, claim: sp.Expr, right: sp.Expr, states: Sequence[_State], claimed: Sequence[complex]) -> None:
        self.claim, self.right = claim, right
        self.states, self.claimed = states, claimed

    @classmethod
    def of(cls, claim: sp.Expr, right: sp.Expr) -> _Tested | None:
        """None for expressions that are too large, or have functions without numbers."""
        if sum(1 for e in (claim, right) for _ in sp.preorder_traversal(e)) > MOST_NODES_OF_A_VALUE:
            return None
        draw, states = Random(1), []
        for _ in range(2):
            state: dict[sp.Basic, complex] = {}
            for s in sorted(claim.free_symbols | right.free_symbols, key=str):
                state[s] = draw.uniform(0.3, 1.3)
            states.append(state)
        try:
            return cls(claim, right, states, [_number(claim, s) for s in states])
        except (KeyError, ZeroDivisionError, OverflowError, ValueError):
            return None

    def is_claim(self, node: sp.Expr, other: sp.Expr) -> bool:
        """Whether the claim is the right value with another expression for a node."""
        try:
            for state, wanted in zip(self.states, self.claimed, strict=True):
                value = _number(self.right, {**state, node: _number(other, state)})
                if abs(value - wanted) > CLOSE_IN_FLOATS * (abs(value) + abs(wanted)):
                    return False
        except (KeyError, ZeroDivisionError, OverflowError, ValueError):
            return False
        return self._exact(self.right.xreplace({node: other}))

    def is_times(self, factor: sp.Expr) -> bool:
        """Whether the claim is the right value multiplied by a factor that is not one."""
        try:
            for state, wanted in zip(self.states, self.claimed, strict=True):
                value = _number(factor, state) * _number(self.right, state)
                if abs(value - wanted) > CLOSE_IN_FLOATS * (abs(value) + abs(wanted)):
                    return False
        except (KeyError, ZeroDivisionError, OverflowError, ValueError):
            return False
        return self._exact(factor * self.right)

    def ratio(self, term: sp.Expr) -> sp.Rational | None:
        """The small ratio that a term of the sum would have to have in the claim; None if it has none."""
        found = []
        for state, wanted in zip(self.states, self.claimed, strict=True):
            share = _number(term, state)
            found.append((wanted - _number(self.right, state) + share) / share if share else 0j)
        first = Fraction(found[0].real).limit_denominator(MOST_IN_RATIO)
        small = (
            first not in (0, 1)
            and abs(first) <= MOST_IN_RATIO
            and all(abs(f - float(first)) < CLOSE_IN_FLOATS for f in found)
        )
        return sp.Rational(first.numerator, first.denominator) if small else None

    def is_sum(self, more: sp.Expr) -> bool:
        """Whether the claim is the right value with another term."""
        try:
            for state, wanted in zip(self.states, self.claimed, strict=True):
                value = _number(more, state) + _number(self.right, state)
                if abs(value - wanted) > CLOSE_IN_FLOATS * (abs(value) + abs(wanted)):
                    return False
        except (KeyError, ZeroDivisionError, OverflowError, ValueError):
            return False
        return self._exact(more + self.right)

    def _exact(self, changed: sp.Expr) -> bool:
        try:
            # Of roots the squares may be decided where the values are not; the signs agree at two states.
            return is_zero(self.claim - changed) is True or is_zero(self.claim**2 - changed**2) is True
        except (DivisionByZeroError, NoPointError, UnsupportedError):
            return False


def _number(e: sp.Expr, state: _State) -> complex:
    """The value of an expression at a state, in which nodes may have values of their own. Raises KeyError."""
    known = state.get(e)
    if known is not None:
        return known
    if e.is_Add:
        return sum(_number(a, state) for a in e.args)
    if e.is_Mul:
        product: complex = 1
        for a in e.args:
            product *= _number(a, state)
        return product
    if e.is_Pow:
        return _number(e.base, state) ** _number(e.exp, state)
    if e.is_number and not e.args:
        return float(e)
    return _FUNCTIONS[type(e)](_number(e.args[0], state))


def _written(e: sp.Expr) -> str:
    return text(e, Notation())
