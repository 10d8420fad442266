"""Spelling of mathematics in MathML, for browsers: `<mover><mi>θ</mi><mo>¨</mo></mover>`.

Only elements of MathML Core, which every browser draws. A sum is not wrapped in an element of its own, so that a long
one can be cut at its signs into several formulas, between which the browser breaks the line. Brackets around
fractions are wrapped and grow; in `WideMathML` they have a fixed size instead, and can be cut.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from html import escape
from typing import ClassVar

import sympy as sp

from lagrange.document.limits import LONG_MATHML, SHORT_MATHML
from lagrange.document.names import BREAK, END, GREEK, START, Piece, Precedence, WrittenName, plain
from lagrange.document.styles import FUNCTIONS, Unicode, figures

THIN = '<mspace width="0.17em"/>'
TIMES = "<mo>\u2062</mo>"
_SLASH = '<mo lspace="0" rspace="0">/</mo>'
_NUMBER = re.compile(r"<mn>\d+</mn>")
_APPLY = "<mo>\u2061</mo>"
_DOTS = ("", "˙", "¨", "⃛")
_TAGS = re.compile(r"<[^>]*>")
_NORMAL = '<mi mathvariant="normal">'
_SET_OFF = (
    f"{_NORMAL}d</mi>",
    "<mi>δ</mi>",
    '<mi class="v"',
    '<msub><mi class="v"',
    '<mover><mi class="v"',
    '<msub><mover><mi class="v"',
)
_WITH_INDEX = re.compile(
    r"<msub>(?P<letter><mi[^>]*>[^<]+</mi>|<mover><mi[^>]*>[^<]+</mi><mo[^>]*>[^<]+</mo></mover>)"
    r"(?P<index><(mn|mi|mtext)>[^<]+</\3>|<mrow>(?:(?!</?mrow>).)*</mrow>)</msub>"
)
"""x_1, with dots or without, in its parts."""
_WORD = re.compile(r"(?:<msup>|<msub>|<mrow>)*<mi>\w\w+</mi>")
_MIXED = re.compile(r"\d+[a-z]\Z")  # a_1t


class MathML(Unicode):
    """MathML Core: an expression is a row of elements."""

    plus = '<mo form="infix">+</mo>'
    minus = '<mo form="infix">−</mo>'
    sign = '<mo form="prefix">−</mo>'
    times = TIMES
    between_numbers = "<mo>·</mo>"
    stacked = True
    constants: ClassVar[Mapping[str, str]] = {
        "Pi": f"{_NORMAL}π</mi>",
        "Exp1": f"{_NORMAL}e</mi>",
        "Infinity": "<mi>∞</mi>",
    }

    def function(self, name: str) -> str:
        """The name of a function."""
        return f"<mi>{FUNCTIONS[name][1] if name in FUNCTIONS else escape(name)}</mi>"

    def relation(self, relation: str) -> str:
        """The sign of a relation."""
        return f'<mo form="infix">{escape(super().relation(relation))}</mo>'

    def name(self, name: str, vector: bool = False) -> Piece:
        """A symbol."""
        parts = WrittenName.of(name)
        return Piece(_name(parts, vector), tight=parts.is_letter and not parts.operator and not vector)

    def number(self, number: sp.Number) -> Piece:
        """A positive integer or float."""
        if isinstance(number, sp.Float):
            digits, exponent = figures(number)
            power = "" if exponent is None else f"<mo>·</mo><msup><mn>10</mn>{_integer(exponent)}</msup>"
            return Piece(f"<mn>{digits}</mn>{power}", tight=True)
        return Piece(f"<mn>{int(number)}</mn>", tight=True)

    def unit(self, name: str) -> Piece:
        """A unit of measurement after a number."""
        gap = "" if name == "°" else '<mspace width="0.25em"/>'
        return Piece(f"{gap}<mtext>{escape(super().unit(name).code.strip())}</mtext>")

    def coefficient(self, numerator: Piece, denominator: Piece) -> Piece:
        """A small fraction."""
        return Piece(f'<mstyle displaystyle="false">{self.fraction(numerator, denominator).code}</mstyle>')

    def between(self, before: Piece, after: Piece) -> str:
        """An invisible sign; a dot between numbers, a thin space around functions and before vectors."""
        ends = _TAGS.sub("", plain(before.code))
        begins = _TAGS.sub("", plain(after.code))
        if ends == "0" or (ends[-1:].isdigit() and begins[:1].isdigit() and before.code.endswith("</mn>")):
            return self.between_numbers
        first = plain(after.code)
        apart = Precedence.APPLICATION in (before.level, after.level) or _WORD.match(first) or _WORD.match(before.code)
        if apart or first.startswith(_SET_OFF):
            return TIMES + THIN
        return TIMES

    def applied(self, function: str, argument: str, raised: bool) -> Piece:
        """`sin θ`, `sin² θ`."""
        del raised
        return Piece(f"{function}{_APPLY}{THIN}{argument}", Precedence.APPLICATION)

    def bracketed(self, code: str) -> str:
        """Brackets that grow only around fractions."""
        return self._between_brackets(code, *_brackets(code))

    def arguments(self, codes: Sequence[str]) -> str:
        """The argument list of a function."""
        return _APPLY + self._between_brackets("<mo>,</mo>".join(codes), "(", ")")

    def _between_brackets(self, code: str, left: str, right: str) -> str:
        if is_tall(code):
            return f"<mrow><mo>{left}</mo>{plain(code)}<mo>{right}</mo></mrow>"
        return f'<mo stretchy="false">{left}</mo>{code}<mo stretchy="false">{right}</mo>'

    def fraction(self, numerator: Piece, denominator: Piece) -> Piece:
        """A fraction."""
        return Piece(f"<mfrac>{row(numerator.code)}{row(denominator.code)}</mfrac>", Precedence.PRODUCT)

    def power(self, base: str, exponent: Piece) -> Piece:
        """A power; the base has its brackets already."""
        below = row(base)
        named = _WITH_INDEX.fullmatch(below)
        if named is not None:  # index and exponent one above the other
            letter = _without_height(named["letter"])
            return Piece(
                f"<msubsup>{letter}{named['index']}{row(exponent.code)}</msubsup>", Precedence.POWER, tight=True
            )
        below = _without_height(below)
        return Piece(f"<msup>{below}{row(exponent.code)}</msup>", Precedence.POWER, tight=True)

    def exponential(self, exponent: Piece) -> Piece:
        """A power of e."""
        return Piece(f"<msup>{self.constants['Exp1']}{row(exponent.code)}</msup>", Precedence.POWER)

    def root(self, inner: Piece) -> Piece:
        """A square root."""
        return Piece(f"<msqrt>{plain(inner.code)}</msqrt>")

    def absolute(self, inner: Piece) -> Piece:
        """An absolute value."""
        bar = '<mo form="{}"' + ("" if is_tall(inner.code) else ' stretchy="false"') + ">|</mo>"
        return Piece(f"<mrow>{bar.format('prefix')}{plain(inner.code)}{bar.format('postfix')}</mrow>")

    def dot(self, a: Piece, b: Piece) -> Piece:
        """A scalar product."""
        return Piece(f"{self._operand(a)}<mo>·</mo>{self._operand(b)}", Precedence.DIVISION)

    def cross(self, a: Piece, b: Piece) -> Piece:
        """A vector product."""
        return Piece(f"{self._operand(a)}<mo>×</mo>{self._operand(b)}", Precedence.DIVISION)

    def wedge(self, forms: Sequence[Piece]) -> Piece:
        """An exterior product."""
        return Piece("<mo>∧</mo>".join(self._operand(f) for f in forms), Precedence.PRODUCT)

    def partial(self, inner: Piece, variables: Sequence[str], at: Sequence[str] = ()) -> Piece:
        """A partial derivative."""
        sign = _NORMAL + "∂</mi>"
        count = str(len(variables))
        raised = f"<msup>{sign}<mn>{count}</mn></msup>" if len(variables) > 1 else sign
        below = []
        for variable in dict.fromkeys(variables):
            code, n = self.name(variable).code, variables.count(variable)
            below.append(sign + (self.power(code, Piece(f"<mn>{n}</mn>")).code if n > 1 else code))
        if is_tall(inner.code) and not at:
            body = inner.code if inner.level >= Precedence.PRODUCT else self.bracketed(inner.code)
            return Piece(f"<mfrac>{raised}{row(''.join(below))}</mfrac>{body}", Precedence.PRODUCT)
        body = inner.code if inner.level == Precedence.ATOM else self.bracketed(inner.code)
        code = f"<mfrac>{row(raised + body)}{row(''.join(below))}</mfrac>"
        return Piece(code + (self.arguments(at) if at else ""), Precedence.PRODUCT)

    def slope(self, inner: Piece, order: int, at: Sequence[str] = ()) -> Piece:
        """A derivative of a function of one variable."""
        code = f'<mrow>{inner.code}<mo lspace="0" rspace="0">{"′″‴"[order - 1]}</mo></mrow>'  # a glyph that is raised
        return Piece(code + (self.arguments(at) if at else ""))

    def rate(self, inner: Piece) -> Piece:
        """A total time derivative."""
        above, below = f"{_NORMAL}d</mi>", f"<mrow>{_NORMAL}d</mi><mi>t</mi></mrow>"
        if inner.level == Precedence.ATOM and "<mo" not in inner.code:
            return Piece(f"<mfrac>{row(above + inner.code)}{below}</mfrac>", Precedence.PRODUCT)
        body = inner.code if inner.level >= Precedence.PRODUCT and is_tall(inner.code) else self.bracketed(inner.code)
        return Piece(f"<mfrac>{above}{below}</mfrac>{body}", Precedence.PRODUCT)

    def integral(self, body: Piece, start: Piece, end: Piece) -> Piece:
        """A definite integral."""
        sign = f"<msubsup><mo>∫</mo>{row(start.code)}{row(end.code)}</msubsup>"
        return Piece(sign + body.code, Precedence.DIVISION)

    def zero_vector(self) -> Piece:
        """The vector 0."""
        return Piece('<mn class="v">0</mn>')


class RunningMathML(MathML):
    """MathML in running text: quotients and ∂f/∂x on the line, where a fraction would be too small to read."""

    stacked = False
    within_argument = TIMES

    def fraction(self, numerator: Piece, denominator: Piece) -> Piece:
        """A quotient with a slash; of numbers alone, a small fraction."""
        if _NUMBER.fullmatch(numerator.code) and _NUMBER.fullmatch(denominator.code):
            return super().fraction(numerator, denominator)
        above = self.bracketed(numerator.code) if numerator.level <= Precedence.DIVISION else numerator.code
        below = self.bracketed(denominator.code) if denominator.level <= Precedence.PRODUCT else denominator.code
        return Piece(f"{above}{_SLASH}{below}", Precedence.DIVISION)

    def partial(self, inner: Piece, variables: Sequence[str], at: Sequence[str] = ()) -> Piece:
        """A partial derivative with a slash."""
        sign = _NORMAL + "∂</mi>"
        count = len(variables)
        raised = f"<msup>{sign}<mn>{count}</mn></msup>" if count > 1 else sign
        body = inner.code if inner.level == Precedence.ATOM else self.bracketed(inner.code)
        below = []
        for variable in dict.fromkeys(variables):
            code, n = self.name(variable).code, variables.count(variable)
            below.append(sign + (self.power(code, Piece(f"<mn>{n}</mn>")).code if n > 1 else code))
        code = f"{raised}{body}{_SLASH}{''.join(below)}"
        return Piece(code + (self.arguments(at) if at else ""), Precedence.DIVISION)


class WideMathML(MathML):
    """MathML for formulas too wide for a line: long fractions and tall brackets can be cut."""

    def _between_brackets(self, code: str, left: str, right: str) -> str:
        if is_tall(code) and BREAK in code:
            size = ' minsize="2.4em" maxsize="2.4em"'
            return f"<mo{size}>{left}</mo>{code}<mo{size}>{right}</mo>"
        return super()._between_brackets(code, left, right)

    def fraction(self, numerator: Piece, denominator: Piece) -> Piece:
        """1/b (...), and (...)/(...) where both parts are long."""
        if not {BREAK} & {*numerator.code, *denominator.code}:
            return super().fraction(numerator, denominator)
        if BREAK not in denominator.code:
            whole = plain(numerator.code)
            if len(_TAGS.sub("", whole)) <= SHORT_MATHML:
                return super().fraction(Piece(whole, numerator.level), denominator)
            reciprocal = super().fraction(Piece("<mn>1</mn>"), denominator).code
            inner = numerator.code if numerator.level > Precedence.DIVISION else self.bracketed(numerator.code)
            return Piece(f"{reciprocal}{inner}", Precedence.PRODUCT)
        if BREAK not in numerator.code and len(_TAGS.sub("", denominator.code)) < LONG_MATHML:
            return super().fraction(numerator, denominator)
        above = self.bracketed(numerator.code) if numerator.level <= Precedence.DIVISION else numerator.code
        below = self.bracketed(denominator.code) if denominator.level <= Precedence.PRODUCT else denominator.code
        return Piece(f"{START}{above}{BREAK}<mo>/</mo>{below}{END}", Precedence.DIVISION)

    def power(self, base: str, exponent: Piece) -> Piece:
        """A power of a long bracket: the exponent is attached to the closing bracket, so that the sum can be cut."""
        if BREAK not in base or not base.endswith("</mo>"):
            return super().power(base, exponent)
        at = base.rindex("<mo")
        return Piece(f"{base[:at]}<msup>{base[at:]}{row(exponent.code)}</msup>", Precedence.POWER, tight=True)

    def absolute(self, inner: Piece) -> Piece:
        """An absolute value whose bars have a fixed size."""
        if BREAK not in inner.code:
            return super().absolute(inner)
        size = ' minsize="2.4em" maxsize="2.4em"' if is_tall(inner.code) else ' stretchy="false"'
        return Piece(f'<mo form="prefix"{size}>|</mo>{inner.code}<mo form="postfix"{size}>|</mo>')

    def root(self, inner: Piece) -> Piece:
        """A power 1/2 where the root is long."""
        if BREAK not in inner.code:
            return super().root(inner)
        left, right = (f'<mo stretchy="false">{b}</mo>' for b in _brackets(inner.code))
        half = "<mrow><mn>1</mn><mo>/</mo><mn>2</mn></mrow>"
        return Piece(f"{left}{inner.code}<msup>{right}{half}</msup>", Precedence.POWER)


def _without_height(code: str) -> str:
    """A letter with dots, which would lift an exponent."""
    return f'<mpadded height="0.7em">{code}</mpadded>' if code.startswith("<mover>") else code


def is_tall(code: str) -> bool:
    """Whether brackets around the code have to grow."""
    return "<mfrac" in code


def row(code: str) -> str:
    """The code as one element, without marks: what is inside cannot be cut."""
    code = plain(code)
    tag = re.match(r"<(\w+)", code)
    single = tag is not None and code.endswith(f"</{tag[1]}>") and _is_single(code)
    return code if single else f"<mrow>{code}</mrow>"


def _is_single(code: str) -> bool:
    """Whether the code is one element and not several side by side."""
    depth = 0
    for tag in re.finditer(r"<(/?)[^>]*?(/?)>", code):
        closes, is_empty = tag.groups()
        depth += -1 if closes else 0 if is_empty else 1
        if depth == 0:
            return tag.end() == len(code)
    return False


def _brackets(code: str) -> tuple[str, str]:
    """Round brackets; square ones around a sum that has round ones, then braces."""
    text = _TAGS.sub("", code)
    if not text.startswith((START, "(", "−")) or "(" not in text:
        return "(", ")"
    return ("{", "}") if "[" in text and "{" not in text else ("[", "]")


def _integer(number: int) -> str:
    return f"<mn>{number}</mn>" if number >= 0 else f"<mrow><mo>−</mo><mn>{-number}</mn></mrow>"


def _name(name: WrittenName, bold: bool = False) -> str:
    """`<msub><mover><mi>θ</mi><mo>¨</mo></mover><mn>1</mn></msub>`."""
    letter = GREEK[name.letter][0] if name.letter in GREEK else name.letter
    bold = bold and name.operator != "nabla"
    upright = bold or (name.letter in GREEK and name.letter[0].isupper())
    kind = ' class="v" mathvariant="normal"' if bold else ' mathvariant="normal"' if upright else ""
    code = f"<mi{kind}>{escape(letter)}</mi>"
    if 0 < name.primes < len(_DOTS):
        code = f'<mover>{code}<mo stretchy="false" lspace="0" rspace="0">{_DOTS[name.primes]}</mo></mover>'
    index = "<mo>,</mo>".join(_index(i) for i in name.indices)
    if index:
        code = f"<msub>{code}{row(index)}</msub>"
    if name.primes >= len(_DOTS):
        count = f'<mo stretchy="false">(</mo><mn>{name.primes}</mn><mo stretchy="false">)</mo>'
        code = f"<msup>{code}<mrow>{count}</mrow></msup>"
    operators = {"": "", "d": f"{_NORMAL}d</mi>", "delta": "<mi>δ</mi>", "nabla": f"{_NORMAL}∇</mi>"}
    return operators[name.operator] + code


def _index(index: str) -> str:
    if index.isdigit():
        return f"<mn>{index}</mn>"
    if _MIXED.match(index):
        return f"<mn>{index[:-1]}</mn><mi>{index[-1]}</mi>"
    inner = WrittenName.of(index)
    if inner.is_letter and all(i.isdigit() or len(i) == 1 for i in inner.indices):
        return _name(inner)
    words = [word for word in re.split(r"[_.]", index) if word]
    return "<mo>,</mo>".join(
        [f"<mtext>{escape(' '.join(w for w in words if not w.isdigit()))}</mtext>"]
        + [f"<mn>{w}</mn>" for w in words if w.isdigit()]
    )
