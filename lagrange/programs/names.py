"""Legal names for symbols: `theta'` is `theta_dot`, `θ'` is `theta_dot`, `lambda` is `lambda_`.

A name is made of the letters A to Z, a to z, digits and underscores alone, begins with a letter, is not a keyword of
any of the languages, and belongs to one symbol. Whatever cannot be made so is `s1`, `s2`, ... Numbered names, y0, p3,
c12, take nothing from the file at all.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable

import sympy as sp

from lagrange.programs.limits import LONGEST_PROGRAM_NAME

_LEGAL = re.compile(r"[A-Za-z][A-Za-z0-9_]*")

_WORDS = """
False None True and as assert async await break class continue def del elif else except finally for from global
if import in is lambda nonlocal not or pass raise return try while with yield match case type
auto char const default do double enum extern float goto inline int long register restrict short signed sizeof
static struct switch typedef union unsigned void volatile bool asm fortran true false nullptr typeof
end function elseif otherwise parfor persistent spmd catch unwind_protect until endif endfunction endwhile endfor
begin baremodule let local macro module quote export using mutable abstract primitive where isa outer public
arguments debugger delete eval implements instanceof interface new null package private protected super this throw
var undefined NaN Infinity of get set constructor prototype
sin cos tan asin acos atan atan2 sinh cosh tanh exp log abs fabs sign sgn sqrt pow power pi Pi inf Inf nan NAN
INFINITY HUGE EOF NULL I Complex_I errno signgam j0 j1 jn y0 y1 yn gamma lgamma erf erfc main printf math Math
t y p dy dydt f out row col matrix right result solve solved state parameters names start copysign hypot fmax
OVERFLOW UNDERFLOW DOMAIN SING PLOSS TLOSS MAXFLOAT linux unix i386 M_PI ans eps e im size length zeros nargin
disp error len range list dict max min sum print rates unknowns equations defaults
"""
RESERVED = frozenset(_WORDS.split())
"""Words of Python, C, MATLAB, Octave, Julia, JavaScript, and what the programs use themselves."""


class ProgramNames:
    """Names for symbols, one for each."""

    def __init__(self, taken: Iterable[str] = ()) -> None:
        self._taken = {*RESERVED, *taken}
        self._of: dict[sp.Symbol, str] = {}

    @property
    def known(self) -> dict[sp.Symbol, str]:
        """The names given so far."""
        return self._of

    def readable(self, symbol: sp.Symbol) -> str:
        """A name that resembles that of the symbol."""
        return self._named(symbol, legal_name(symbol.name) or "s")

    def numbered(self, symbol: sp.Symbol, letter: str) -> str:
        """A name with a number: the letter is one of the program's own."""
        return self._named(symbol, letter, number=True)

    def _named(self, symbol: sp.Symbol, wanted: str, *, number: bool = False) -> str:
        if symbol not in self._of:
            name, n = f"{wanted}0" if number else wanted, 0
            if not number and name in RESERVED:
                name = f"{wanted}_"
            while name in self._taken:
                n += 1
                name = f"{wanted}{n}" if number else f"{wanted}_{n}"
            self._taken.add(name)
            self._of[symbol] = name
        return self._of[symbol]


def legal_name(name: str) -> str:
    """A name of letters, digits and underscores that begins with a letter; empty where there is none."""
    plain = name.rstrip("'")
    dots = len(name) - len(plain)
    spelled = "".join(_spelled(c) for c in plain)
    spelled = re.sub(r"[^A-Za-z0-9]+", "_", spelled).strip("_")[:LONGEST_PROGRAM_NAME]
    if not _LEGAL.fullmatch(spelled):
        return ""
    return spelled + {0: "", 1: "_dot", 2: "_ddot"}.get(dots, f"_d{dots}")


def _spelled(char: str) -> str:
    """A letter of the alphabet as it is, a Greek one by its name, anything else as an underscore."""
    if char.isascii():
        return char
    name = unicodedata.name(char, "")
    match = re.fullmatch(r"GREEK (SMALL|CAPITAL) LETTER (\w+)", name)
    if match is None:
        return "_"
    return match[2].lower() if match[1] == "SMALL" else match[2].capitalize()
