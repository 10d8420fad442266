"""Sines and cosines as letters: an angle is a point (C, S) of the unit circle, C² + S² = 1.

Conditions of equilibrium become polynomials when cos θ and sin θ are two letters C and S: cos(θ − α) is C c + S s,
tan θ is S/C, cos 2θ is C² − S². The angles of parameters have letters too. A square root that contains an unknown is a
letter R, with R² = its radicand and R ≥ 0. Where θ/n occurs, it is that angle which has letters. An unknown that occurs
beside its own sine and cosine (k θ = m g l sin θ) keeps its own symbol as well.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import lcm

import sympy as sp

from lagrange.algebra.closed_forms.limits import HIGHEST_MULTIPLE
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import sign_in_range

CIRCULAR = (sp.sin, sp.cos, sp.tan, sp.cot, sp.sec, sp.csc)

Pair = tuple[sp.Expr, sp.Expr]
_SIGNS = {1: "positive", -1: "negative"}


class NotAlgebraicError(Exception):
    """An expression is no algebraic function of the letters."""


@record
class LetteredAngle:
    """An angle with letters; `measure` is θ, or θ/2 where that occurs."""

    measure: sp.Expr
    cosine: sp.Symbol
    sine: sp.Symbol

    @property
    def letters(self) -> tuple[sp.Symbol, sp.Symbol]:
        """C and S."""
        return self.cosine, self.sine


class TrigLetters:
    """The letters of the expressions of one problem.

    unknowns  the symbols that are to be found
    angles    by the symbol (or product of parameters) that they measure
    roots     the radicand of each root letter, in letters
    """

    def __init__(self, expressions: Iterable[sp.Expr], unknowns: Iterable[sp.Symbol]) -> None:
        self.unknowns = tuple(unknowns)
        self.angles: dict[sp.Expr, LetteredAngle] = {}
        self.roots: dict[sp.Symbol, sp.Expr] = {}
        # Equations of motion repeat few sines and cosines many times, and are read at every equilibrium.
        self._known: dict[sp.Expr, sp.Expr] = {}
        self._pairs: dict[sp.Expr, Pair] = {}
        # Where θ/2 occurs beside θ, the letters are those of θ/2, and cos θ is C² − S².
        parts: dict[sp.Expr, int] = {}
        for e in expressions:
            for f in e.atoms(*CIRCULAR):
                for monomial, c in _terms(f.args[0]):
                    parts[monomial] = lcm(parts.get(monomial, 1), int(c.q))
        for monomial, d in parts.items():
            self._angle(monomial, d)

    def copy(self) -> TrigLetters:
        """An independent copy: expressions read with it add no angles or roots to the original."""
        other = TrigLetters((), self.unknowns)
        other.angles, other.roots = dict(self.angles), dict(self.roots)
        return other

    def angle_of(self, unknown: sp.Symbol) -> LetteredAngle | None:
        """The angle of an unknown that occurs in sines and cosines."""
        return self.angles.get(unknown)

    @property
    def of_unknowns(self) -> dict[sp.Symbol, sp.Symbol]:
        """The unknown that each letter belongs to; an unknown itself is a letter too."""
        owner = {u: u for u in self.unknowns}
        for u in self.unknowns:
            if u in self.angles:
                owner |= dict.fromkeys(self.angles[u].letters, u)
        return owner

    def unknowns_in(self, e: sp.Expr) -> frozenset[sp.Symbol]:
        """The unknowns on which an expression in letters depends."""
        owner = self.of_unknowns
        unknowns: set[sp.Symbol] = set()
        for s in e.free_symbols:
            if s in owner:
                unknowns.add(owner[s])
            elif s in self.roots:
                unknowns |= self.unknowns_in(self.roots[s])
        return frozenset(unknowns)

    def read(self, e: sp.Expr) -> sp.Expr:
        """An expression in letters. Raises NotAlgebraicError."""
        if e.is_Number or e.is_Symbol or not e.args:
            return e
        known = self._known.get(e)
        if known is None:
            known = self._known[e] = self._read(e)
        return known

    def _read(self, e: sp.Expr) -> sp.Expr:
        if e.is_Add or e.is_Mul:
            return e.func(*(self.read(a) for a in e.args))
        if isinstance(e, CIRCULAR):
            return self._circular(e)
        if e.is_Pow and e.exp.is_Integer:
            return self.read(e.base) ** e.exp
        if e.is_Pow and e.exp.is_Rational and e.exp.q == 2 and self._has_unknown(e.base):
            return self.root(self.read(e.base)) ** e.exp.p
        if not self._has_unknown(e):
            return e
        if isinstance(e, sp.Abs):
            return self.root(self.read(e.args[0]) ** 2)
        if isinstance(e, sp.sign):
            inner = self.read(e.args[0])
            return inner / self.root(inner**2)
        raise NotAlgebraicError

    def write(self, e: sp.Expr) -> sp.Expr:
        """An expression in letters with sines, cosines and roots again."""
        # A radicand may contain root letters itself.
        occurring = e.free_symbols
        for _ in range(3):
            if occurring.isdisjoint(self.roots):
                break
            e = e.xreplace({r: sp.sqrt(radicand) for r, radicand in self.roots.items()})
            occurring = e.free_symbols
        functions = {
            letter: function(a.measure)
            for a in self.angles.values()
            for letter, function in ((a.cosine, sp.cos), (a.sine, sp.sin))
            if letter in occurring
        }
        return e.xreplace(functions) if functions else e

    def reduced(self, e: sp.Expr, keep: str = "cosine") -> sp.Expr:
        """A polynomial reduced by S² = 1 − C² (or C² = 1 − S², `keep="sine"`) and expanded. Zero becomes 0.

        Radicands are reduced separately, and the roots are then coefficients.
        """
        e = sp.expand(e)
        masks = {p: sp.Dummy("root") for p in self._roots_of_letters(e)}
        if masks:
            back = {mask: self.reduced(p.base, keep) ** p.exp for p, mask in masks.items()}
            return sp.expand(self.reduced(e.xreplace(masks), keep).xreplace(back))
        symbols = e.free_symbols
        for a in self.angles.values():
            other, kept = (a.sine, a.cosine) if keep == "cosine" else a.letters
            if other in symbols:
                e = with_square(e, other, 1 - kept**2)
        for root, radicand in self.roots.items():
            if root in e.free_symbols:
                e = with_square(e, root, radicand)
        return e

    def shortest(self, e: sp.Expr) -> sp.Expr:
        """The shortest of a polynomial's forms on the circles: a² for a² C² + a² S²."""
        return min((e, self.reduced(e), self.reduced(e, "sine")), key=lambda f: count_operations(f))

    def _roots_of_letters(self, e: sp.Expr) -> list[sp.Expr]:
        """The roots of polynomials in letters of angles, such as √(C² + S²/4)."""
        letters = {s for a in self.angles.values() for s in a.letters}
        roots = (p for p in e.atoms(sp.Pow) if not p.exp.is_Integer and p.base.free_symbols & letters)
        return [p for p in roots if p.base.is_polynomial(*letters)]

    def _has_unknown(self, e: sp.Expr) -> bool:
        return any(u in e.free_symbols for u in self.unknowns)

    def root(self, radicand: sp.Expr) -> sp.Expr:
        """√radicand, as a multiple of a letter."""
        radicand = self.reduced(radicand) if radicand.is_polynomial(*radicand.free_symbols) else radicand
        for letter, known in self.roots.items():
            # √(4 l² − 4 x²) is a multiple of the letter for √(l² − x²), so that the two cancel.
            ratio = sp.cancel(radicand / known)
            if ratio.is_positive and not self.unknowns_in(ratio):
                return sp.sqrt(ratio) * letter
        letter = sp.Symbol(f"root_{len(self.roots) + 1}", nonnegative=True)
        self.roots[letter] = radicand
        return letter

    def _angle(self, monomial: sp.Expr, denominator: int) -> LetteredAngle:
        name = str(monomial / denominator)
        measure = monomial / denominator
        signs = ((f"{f.__name__}({name})", sign_in_range(f(measure))) for f in (sp.cos, sp.sin))
        letters = (
            sp.Symbol(letter, **{_SIGNS[sign]: True}) if sign is not None else sp.Symbol(letter, real=True)
            for letter, sign in signs
        )
        self.angles[monomial] = angle = LetteredAngle(measure, *letters)
        return angle

    def _circular(self, e: sp.Expr) -> sp.Expr:
        c, s = self.pair(e.args[0])
        forms = {sp.sin: s, sp.cos: c, sp.tan: s / c, sp.cot: c / s, sp.sec: 1 / c, sp.csc: 1 / s}
        return forms[e.func]

    def pair(self, angle: sp.Expr) -> Pair:
        """Cosine and sine of an angle. Raises NotAlgebraicError."""
        if angle not in self._pairs:
            self._pairs[angle] = self._pair(angle)
        return self._pairs[angle]

    def _pair(self, angle: sp.Expr) -> Pair:
        total: Pair = (sp.S.One, sp.S.Zero)
        rest = sp.expand(angle)
        for monomial, c in _terms(rest):
            rest -= c * monomial
            known = self.angles.get(monomial) or self._angle(monomial, int(c.q))
            multiple = c * monomial / known.measure
            if not multiple.is_Integer or abs(multiple) > HIGHEST_MULTIPLE:
                raise NotAlgebraicError
            total = _sum(total, _multiple((known.cosine, known.sine), int(multiple)))
        for u in self.unknowns:  # θ φ or √θ under a sine
            if any(u in m.free_symbols and m != u for m, _ in _terms(angle)):
                raise NotAlgebraicError
        return _sum(total, (sp.cos(rest), sp.sin(rest)))


def is_in_circular(u: sp.Symbol, expressions: Iterable[sp.Expr]) -> bool:
    """Whether an unknown occurs in sines and cosines."""
    return any(u in f.free_symbols for e in expressions for f in e.atoms(*CIRCULAR))


def is_outside_circular(u: sp.Symbol, expressions: Iterable[sp.Expr]) -> bool:
    """Whether an unknown occurs outside sines and cosines."""
    outside = (e.xreplace({f: sp.Dummy() for f in e.atoms(*CIRCULAR)}) for e in expressions)
    return any(u in e.free_symbols for e in outside)


def parts_of_angles(expressions: Sequence[sp.Expr], angles: frozenset[sp.Symbol]) -> int:
    """The largest n for which θ/n occurs."""
    letters = TrigLetters(expressions, tuple(angles))
    return max((int((u / letters.angles[u].measure)) for u in angles if u in letters.angles), default=1)


def with_square(e: sp.Expr, letter: sp.Symbol, square: sp.Expr) -> sp.Expr:
    """A polynomial with letter² replaced, expanded."""
    poly = sp.Poly(e, letter)
    parts = [c * square ** (n // 2) * letter ** (n % 2) for (n,), c in poly.terms()]
    return sp.expand(sp.Add(*parts))


def _terms(angle: sp.Expr) -> list[tuple[sp.Expr, sp.Rational]]:
    """The terms of an angle that are not numbers, as monomials with rational coefficients."""
    terms = []
    for term in sp.Add.make_args(sp.expand(angle)):
        c, monomial = term.as_coeff_Mul()
        if term.free_symbols:
            terms.append((monomial, c) if c.is_Rational else (term, sp.S.One))
    return terms


def _sum(a: Pair, b: Pair) -> Pair:
    return sp.expand(a[0] * b[0] - a[1] * b[1]), sp.expand(a[1] * b[0] + a[0] * b[1])


def _multiple(a: Pair, n: int) -> Pair:
    if n < 0:
        c, s = _multiple(a, -n)
        return c, -s
    total: Pair = (sp.S.One, sp.S.Zero)
    for _ in range(n):
        total = _sum(total, a)
    return total
