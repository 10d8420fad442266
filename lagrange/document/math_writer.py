"""Mathematics in text, Unicode, LaTeX and MathML: one walker over expressions, and a table of spellings for each style.

    text      l*theta'' + g*sin(theta)                  read back by `expressions`
    unicode   l θ̈ + g sin θ                             for the terminal
    latex     l \\ddot{\\theta} + g \\sin\\theta              as typed by hand

The expression is written as it is: nothing is expanded, collected or cancelled. The walker decides what an author
decides: the order of terms and factors and what goes above and below a fraction line (`ordering`), which factors are
a fraction in front, (g/l) sin θ, where brackets are needed, and where a long line may be broken (`names`).
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from itertools import pairwise

import sympy as sp

from lagrange.core.symbols import (
    CrossProduct,
    DotProduct,
    Partial,
    TimeDerivative,
    UnitSymbol,
    UnitVector,
    Unspecified,
    VectorSymbol,
    Wedge,
    differential,
)
from lagrange.core.vectors import Vector
from lagrange.document.derivation import Mathematics
from lagrange.document.limits import LONGEST_LIST, MOST_PRIMES
from lagrange.document.names import BREAK, END, START, Notation, Piece, Precedence, SymbolKind, WrittenName, plain
from lagrange.document.ordering import BasePower, OrderedProduct, WritingOrder, split_term
from lagrange.document.style_latex import Latex, RunningLatex, WideLatex
from lagrange.document.styles import BARE, POWERED, BoldVectors, Text, Unicode

__all__ = [
    "BOLD",
    "LATEX",
    "RUNNING_LATEX",
    "TEXT",
    "UNICODE",
    "WIDE_LATEX",
    "Notation",
    "Writer",
    "latex",
    "text",
    "unicode",
]

TEXT, UNICODE, BOLD = Text(), Unicode(), BoldVectors()
LATEX, WIDE_LATEX, RUNNING_LATEX = Latex(), WideLatex(), RunningLatex()
NOTHING = Notation()
_CONSTANT = {SymbolKind.PARAMETER, SymbolKind.SIGN}
_POSITION = {SymbolKind.COORDINATE, *_CONSTANT}
_ENDING = {SymbolKind.COORDINATE, SymbolKind.TIME}


def text(expression: Mathematics, notation: Notation = NOTHING) -> str:
    """The expression in the language of problem files."""
    return Writer(TEXT, notation).plain(expression)


def unicode(expression: Mathematics, notation: Notation = NOTHING) -> str:
    """The expression for a terminal."""
    return Writer(UNICODE, notation).plain(expression)


def latex(expression: Mathematics, notation: Notation = NOTHING) -> str:
    """The expression in LaTeX, for math mode with amsmath."""
    return Writer(LATEX, notation).plain(expression)


class Writer:
    """Writes mathematics in one style and notation, with a cache of the pieces written."""

    def __init__(self, style: Text, notation: Notation = NOTHING, *, on_page: bool = False) -> None:
        """A writer; `on_page`: with the shorter names of a printed page, which are not read back."""
        self.style = style
        self.notation = notation
        self.on_page = on_page
        self.order = WritingOrder(notation)
        self._written: dict[sp.Basic, Piece] = {}
        self._ambiguous = notation.ambiguous

    def plain(self, expression: Mathematics) -> str:
        """The expression on one line."""
        return plain(self.marked(expression))

    def marked(self, expression: Mathematics) -> str:
        """The expression with marks where it may be broken; see `names`."""
        components = expression.components if isinstance(expression, Vector) else (expression,)
        ambiguous = self.notation.ambiguous | _ambiguous(components)
        # Whether f(x) needs its arguments depends on the expression around it, so pieces are good for one such set.
        if ambiguous != self._ambiguous:
            self._ambiguous = ambiguous
            self._written.clear()
        return self.piece(expression).code

    def relation(self, sides: Iterable[Mathematics], relation: str = "=") -> str:
        """a = b = c, on one line."""
        return f" {self.style.relation(relation)} ".join(self.plain(side) for side in sides)

    def piece(self, expression: Mathematics) -> Piece:
        """The expression as a piece of code, with the precedence that tells whether it needs brackets."""
        if isinstance(expression, Vector):
            return self._vector(expression)
        piece = self._written.get(expression)
        if piece is None:
            piece = self._written[expression] = self._write(expression)
        return piece

    def _write(self, expression: sp.Expr) -> Piece:
        match expression:
            case sp.Symbol():
                return self._symbol(expression)
            case sp.Add():
                return self._sum(self.order.terms(expression.args))
            case sp.Mul() | sp.Pow() | sp.Rational() | sp.Float():
                parts = split_term(expression)
                if self.style.by_hand and parts.negative:
                    self._turn_difference(parts)
                return self._term(parts)
            case sp.NumberSymbol() | sp.core.numbers.Infinity():
                return Piece(self.style.constants.get(type(expression).__name__, str(expression)), tight=True)
            case Unspecified():
                return self._unspecified(expression)
            case DotProduct():
                a, b = (self.piece(a) for a in expression.args)
                return self.style.dot(a, b)
            case CrossProduct():
                a, b = (self.piece(a) for a in expression.args)
                return self.style.cross(a, b)
            case Wedge():
                return self.style.wedge([self.piece(a) for a in expression.args])
            case Partial():
                inner, *variables = expression.args
                return self.style.partial(self.piece(inner), [v.name for v in variables])
            case TimeDerivative():
                return self.style.rate(self.piece(expression.args[0]))
            case sp.exp() if "e" not in self.notation.scalar_names or self.style is not UNICODE:
                return self.style.exponential(self._argument(expression.args[0]))
            case sp.Abs():
                return self.style.absolute(self._argument(expression.args[0]))
            case sp.Integral():
                q, start, end = expression.limits[0]
                body = self.piece(sp.Mul(expression.function, differential(q), evaluate=False))
                return self.style.integral(body, self.piece(start), self.piece(end))
        return self._application(type(expression).__name__, expression.args)

    def _symbol(self, symbol: sp.Symbol) -> Piece:
        name = symbol.name
        if isinstance(symbol, UnitSymbol):
            return self.style.unit(name)
        if isinstance(symbol, UnitVector) and self.notation.shadows_unit_vectors:
            name = {"i": "e_x", "j": "e_y", "k": "e_z"}.get(name, name)
        if self.on_page:
            name = self.notation.on_page(name)
        return self.style.name(name, isinstance(symbol, UnitVector | VectorSymbol))

    def _vector(self, vector: Vector) -> Piece:
        parts = zip(vector.components, vector.triad.units, strict=True)
        terms = [sp.Mul(c, e, evaluate=False) for c, e in parts if c != 0]
        if not terms:
            return self.style.zero_vector()
        return self._sum(terms) if len(terms) > 1 else self._term(split_term(terms[0]))

    def _sum(self, terms: Iterable[sp.Expr]) -> Piece:
        codes = [START]
        for n, term in enumerate(terms):
            parts = split_term(term)
            negative, parts.negative = parts.negative, False
            piece = self._term(parts)
            if negative:
                codes.append(BREAK + self.style.minus if n else self.style.sign)
            elif n:
                codes.append(BREAK + self.style.plus)
            codes.append(self._inside(piece, Precedence.SUM))
        return Piece("".join(codes) + END, Precedence.SUM)

    def _inside(self, piece: Piece, level: Precedence) -> str:
        """The piece, in brackets if its precedence is `level` or lower."""
        return self.style.bracketed(piece.code) if piece.level <= level else piece.code

    # Products and fractions

    def _term(self, parts: OrderedProduct) -> Piece:
        if self.style.by_hand:
            _under_one_root(parts)
        if not parts.numbers and len(parts.above) == 1 and isinstance(parts.above[0][0], UnitSymbol):
            parts.numbers.append(sp.S.One)  # 1 m/s, not a unit alone
        above, below = self.order.factors(parts.above), self.order.factors(parts.below)
        if not below and not parts.divisors:
            piece = self._product(parts.numbers, above, is_term=True)
        elif not self.style.by_hand:
            piece = self.style.fraction(self._product(parts.numbers, above), self._product(parts.divisors, below))
        elif not below and (len(above) > 1 or (above and not _is_letter(above[0]))):
            # ½ m x'²: a fraction of numbers is a coefficient in front; but x/2 has its letter above the line.
            number = self.style.coefficient(self._product(parts.numbers, []), self._product(parts.divisors, []))
            piece = self._joined([number, *self._factors(above)])
        else:
            before, numerator, after = self._split(above, below)
            upper = self._product(parts.numbers if not before else [], numerator)
            fraction = self.style.fraction(upper, self._product(parts.divisors, below))
            leading = [self.style.number(n) for n in parts.numbers] if before else []
            pieces = [*leading, *self._factors(before), fraction, *self._factors(after)]
            piece = self._joined(pieces) if len(pieces) > 1 else fraction
        if not parts.negative:
            return piece
        return Piece(self.style.sign + self._inside(piece, Precedence.SUM), Precedence.SUM)

    def _turn_difference(self, parts: OrderedProduct) -> None:
        """v sin(β − α) for −v sin(α − β): the sine or tangent of a difference of constants takes the sign."""
        for n, (f, exponent) in enumerate(parts.above):
            angle = f.args[0] if isinstance(f, sp.sin | sp.tan) else sp.S.Zero
            if angle.is_Add and exponent == 1 and self.order.is_constant(angle):
                turned = sp.Add(*(-a for a in angle.args))
                parts.negative, parts.above[n] = False, (type(f)(turned, evaluate=False), exponent)
                return

    def _split(self, above: list[BasePower], below: list[BasePower]) -> tuple[list[BasePower], ...]:
        """The factors before a fraction, above its line, and after it: m (y/x) x'', (g/l) sin θ, x²/l².

        A textbook makes a fraction of factors that belong together: constants over constants are a coefficient of what
        moves, and ratios of positions are a slope. All else goes above the line; differentials and vectors come last.
        """
        late = {SymbolKind.DIFFERENTIAL, SymbolKind.VECTOR}
        last = [f for f in above if self.order.kinds(f[0]) & late]
        scalars = [f for f in above if f not in last]
        constant = [f for f in scalars if self._is_plain(f, _CONSTANT)]
        others = [f for f in scalars if f not in constant]
        sums = any(base.has(sp.sin, sp.cos, sp.tan) for base, _ in below)
        if below and constant and all(self.order.is_constant(base) for base, _ in below):
            if sums and others and not any(isinstance(base, sp.Add) or self._moves(base) for base, _ in others):
                return (
                    [],
                    scalars,
                    last,
                )  # m g cos α/(M + m sin²α), W sin β/sin(α + β): the coefficient would outweigh cos α
            if others and all(isinstance(base, sp.Abs) or not power.is_Integer for base, power in others):
                return [], scalars, last  # F |c − m ω²|/|Δ|, a √(...)/√(...)
            if others and all(self.order.is_constant(base) for base, _ in others) and any(map(_is_nested, constant)):
                return [], scalars, last  # v [√(2g h + v² sin²α) + v sin α] cos α/g
            fixed = [f for f in others if isinstance(f[0], sp.exp) and self.order.is_constant(f[0])]
            above_line = [f for f in scalars if f in constant or f in fixed]  # M exp(μ β)/(...): a constant as well
            return [], above_line, [f for f in others if f not in fixed] + last
        positions = [f for f in others if self._is_plain(f, _POSITION)]
        moving = [f for f in others if f not in positions]
        letters = (isinstance(f[0], sp.Symbol) and self._is_plain(f, _POSITION) for f in below)
        if positions and moving and all(letters):
            return constant, positions, moving + last
        return [], scalars, last

    def _moves(self, base: sp.Expr) -> bool:
        """Whether it depends on more than position and time."""
        return not self.order.kinds(base) <= {*_POSITION, SymbolKind.TIME}

    def _is_plain(self, factor: BasePower, kinds: set[SymbolKind]) -> bool:
        """Whether it is a number, a symbol of these kinds, or a sum of such."""
        base, exponent = factor
        if isinstance(base, sp.Number | sp.NumberSymbol):
            return True
        rational = isinstance(base, sp.Symbol | sp.Add) and exponent.is_Integer
        return bool(rational) and self.order.kinds(base) <= kinds

    def _product(self, numbers: list[sp.Number], factors: list[BasePower], is_term: bool = False) -> Piece:
        pieces = [self.style.number(n) for n in numbers]
        if len(pieces) > 1:
            pieces = [Piece(self.style.between_numbers.join(p.code for p in pieces), Precedence.PRODUCT)]
        pieces += self._unmistakable(factors) if is_term and len(pieces) + len(factors) > 1 else self._factors(factors)
        if is_term and len(pieces) > 1 and isinstance(factors[-1][0], Wedge) and BREAK in pieces[-2].code:
            return self._broken_before(pieces)
        if self.style.by_hand and len(pieces) > 1:
            pieces = self._not_applied(pieces, [False] * (len(pieces) - len(factors)) + [*map(_is_slope, factors)])
        if not pieces:
            return self.style.number(sp.S.One)
        return pieces[0] if len(pieces) == 1 else self._joined(pieces)

    def _not_applied(self, pieces: list[Piece], are_slopes: Sequence[bool]) -> list[Piece]:
        """The factors with brackets around slopes before brackets: ∂f/∂x (a + b) and f′ (a + b) are slopes at a + b."""
        after = [*(piece.level <= Precedence.DIVISION for piece in pieces[1:]), False]
        return [
            Piece(self.style.bracketed(piece.code), Precedence.POWER) if is_slope and bracket else piece
            for piece, is_slope, bracket in zip(pieces, are_slopes, after, strict=True)
        ]

    def _factors(self, factors: list[BasePower]) -> list[Piece]:
        return [self._power(base, exponent) for base, exponent in factors]

    def _unmistakable(self, factors: list[BasePower]) -> list[Piece]:
        """The factors of a term: ∂f/∂X dx and u ∂f/∂X cannot be misread without brackets, (∂f/∂X) x' can."""
        pieces = self._factors(factors)
        slopes = [n for n, (base, _) in enumerate(factors) if isinstance(base, Unspecified) and any(base.orders)]
        if len(slopes) == 1 and factors[slopes[0]][1] == 1:
            [n] = slopes
            if all(self.order.kinds(base) == {SymbolKind.DIFFERENTIAL} for base, _ in factors[n + 1 :]):
                pieces[n] = replace(pieces[n], level=Precedence.PRODUCT)
        return pieces

    def _broken_before(self, pieces: list[Piece]) -> Piece:
        """A product that may be broken before its last factor: (a long sum) dx ∧ dy ∧ dz."""
        *front, last = pieces
        ahead = self._joined(front).code if len(front) > 1 else self._inside(front[0], Precedence.DIVISION)
        return Piece(f"{START}{ahead}{BREAK}{self.style.between(front[-1], last)}{last.code}{END}", Precedence.PRODUCT)

    def _joined(self, pieces: list[Piece]) -> Piece:
        codes = [
            pieces[0].code if pieces[0].level is Precedence.PRODUCT else self._inside(pieces[0], Precedence.DIVISION)
        ]
        for before, after in pairwise(pieces):
            codes.append(self.style.between(before, after))
            codes.append(self._inside(after, Precedence.DIVISION))
        return Piece("".join(codes), Precedence.PRODUCT, tight=pieces[0].tight)

    # Powers and functions

    def _power(self, base: sp.Expr, exponent: sp.Expr) -> Piece:
        if exponent == 1:
            return self.piece(base)
        if exponent == sp.Rational(1, 2):
            return self.style.root(self.piece(base))
        raised = self._exponent(exponent)
        name = type(base).__name__
        if self.style.by_hand and name in POWERED and exponent.is_Integer:
            return self._application(name, base.args, raised)
        piece = self.piece(base)
        if self.style.by_hand and self.order.kinds(base) == {SymbolKind.DIFFERENTIAL}:
            piece = replace(piece, level=Precedence.PRODUCT)  # δx² is the variation of x²
        return self.style.power(self._inside(piece, Precedence.POWER), raised)

    def _exponent(self, exponent: sp.Expr) -> Piece:
        if isinstance(exponent, sp.Rational) and not exponent.is_Integer:
            return Piece(f"{exponent.p}/{exponent.q}", Precedence.DIVISION)
        return self.piece(exponent)

    def _application(self, name: str, arguments: tuple[sp.Expr, ...], power: Piece | None = None) -> Piece:
        head = self.style.function(name)
        if power is not None:
            head = self.style.power(head, power).code
        if self.style.by_hand and name in _OF_ANGLES and (angle := _in_degrees(arguments[0])) is not None:
            return self.style.applied(head, self.piece(angle).code, power is not None)
        codes = [self._argument(a).code for a in arguments]
        bare = self._bare(arguments[0]) if self.style.by_hand and name in BARE else None
        if bare is None:
            return Piece(head + self.style.arguments(codes))
        return self.style.applied(head, bare, power is not None)

    def _argument(self, argument: sp.Expr) -> Piece:
        if isinstance(argument, sp.Add):
            return self._sum(self.order.terms(argument.args, argument=True))
        return self.piece(argument)

    def _bare(self, argument: sp.Expr) -> str | None:
        """The argument of sin without parentheses: θ, 2θ, ωt; None if it needs them, as a number does in sin(2) x."""
        parts = split_term(argument)
        if (
            parts.negative
            or argument.is_Number
            or len(parts.numbers) > 1
            or isinstance(argument, sp.Add)
            or any(e != 1 for _, e in parts.above)
        ):
            return None
        above, below = self.order.factors(parts.above), self.order.factors(parts.below)
        if (parts.divisors or below) and not self.style.stacked:
            return None
        if self.style.stacked and self._is_one_fraction(parts, above, below):
            return self.piece(argument).code
        symbols = [base for base, _ in (*below, *above)]
        if not all(isinstance(s, sp.Symbol | sp.NumberSymbol) for s in symbols) or self._ends_within(symbols):
            return None
        if self.style.stacked or not symbols:
            return self.piece(argument).code
        if not all(WrittenName.of(s.name).is_tight for s in symbols[:-1] if isinstance(s, sp.Symbol)):
            return None
        numbers = (self.style.number(n).code for n in parts.numbers)
        return self.style.within_argument.join([*numbers, *(self.piece(s).code for s in symbols)])

    def _is_one_fraction(self, parts: OrderedProduct, above: list[BasePower], below: list[BasePower]) -> bool:
        """Whether nothing is written before or after its line: x/2 and x/l, not ½ x y or (g/l) t."""
        if below:
            before, _, after = self._split(above, below)
            return not before and not after
        return bool(parts.divisors) and len(above) == 1 and _is_letter(above[0])

    def _ends_within(self, symbols: list[sp.Expr]) -> bool:
        """Whether a reader would end the argument within it: sin θφ is taken as φ sin θ, sin ωẋ as ẋ sin ω."""
        *first, last = symbols or [sp.S.One]
        moving = any(isinstance(s, sp.Symbol) and self.notation.kind(s) in _ENDING for s in first)
        return moving or (bool(first) and isinstance(last, sp.Symbol) and last.name.endswith("'"))

    def _unspecified(self, function: Unspecified) -> Piece:
        head = self.style.name(function.name)
        codes = [self._argument(a).code for a in function.arguments]
        variables = [n for n, k in zip(function.argument_names, function.orders, strict=True) for _ in range(k)]
        if not variables and self.style.by_hand and self._is_known(function):
            return head
        if not variables:
            return Piece(head.code + self.style.arguments(codes))
        at = codes if function.name in self._ambiguous else ()
        if self.style.by_hand and len(function.orders) == 1 and len(variables) <= MOST_PRIMES:
            return self.style.slope(head, len(variables), at)
        return self.style.partial(head, variables, at)

    def _is_known(self, function: Unspecified) -> bool:
        """Whether its long list of arguments is the declared one and can be omitted: F_x for F_x(x, y, x', t)."""
        declared = tuple(str(a) for a in function.arguments) == function.argument_names
        return declared and len(function.arguments) > LONGEST_LIST and function.name not in self._ambiguous


_OF_ANGLES = frozenset({"sin", "cos", "tan", "cot", "sec", "csc"})


def _in_degrees(angle: sp.Expr) -> sp.Expr | None:
    """20° for π/9, which has no sine in roots that anybody writes; None for what is no whole number of degrees."""
    degrees = 180 * angle / sp.pi if angle.is_number else sp.S.NaN
    return sp.Mul(degrees, UnitSymbol("°", positive=True), evaluate=False) if degrees.is_Integer else None


def _ambiguous(expressions: Iterable[sp.Basic]) -> frozenset[str]:
    """The undefined functions that occur with several lists of arguments."""
    lists: dict[str, set[tuple[sp.Expr, ...]]] = {}
    for expression in expressions:
        for function in expression.atoms(Unspecified):
            lists.setdefault(function.name, set()).add(function.arguments)
    return frozenset(name for name, arguments in lists.items() if len(arguments) > 1)


def _is_nested(factor: BasePower) -> bool:
    """Whether it is a sum with roots or functions: in front of the line of a fraction it would need braces."""
    base, _ = factor
    return isinstance(base, sp.Add) and any(
        a.is_Function or (a.is_Pow and not a.exp.is_Integer) for a in base.atoms(sp.Pow, sp.Function)
    )


def _is_slope(factor: BasePower) -> bool:
    """Whether it is a derivative of an undefined function, to the first power."""
    base, exponent = factor
    return isinstance(base, Unspecified) and any(base.orders) and exponent == 1


def _under_one_root(parts: OrderedProduct) -> None:
    """√(l/g) for √l/√g, √(a b) for √a √b, where of the factors at most one may be negative, above."""
    over = [b for b, e in parts.above if e == sp.S.Half]
    under = [b for b, e in parts.below if e == sp.S.Half and b.is_nonnegative]
    if len(over) + len(under) < 2 or not over or sum(not b.is_nonnegative for b in over) > 1:
        return
    quotient = sp.Mul(*over, *(sp.Pow(b, -1) for b in under), evaluate=False)
    parts.above = [(b, e) for b, e in parts.above if e != sp.S.Half] + [(quotient, sp.S.Half)]
    parts.below = [(b, e) for b, e in parts.below if e != sp.S.Half or b not in under]


def _is_letter(factor: BasePower) -> bool:
    """Whether half of it is x/2, and not ½ x²."""
    base, exponent = factor
    return isinstance(base, sp.Number) or (isinstance(base, sp.Symbol | sp.NumberSymbol) and exponent == 1)
