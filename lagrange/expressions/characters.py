"""Characters normalized to what they look like: `ẍ` is an x with two dots, `−` a minus, `ｘ` and `𝑥` an x.

Letters of mathematical alphabets and full-width forms count as the letters that they show; dots, precomposed or
combining, follow their letter one by one; spaces of any width are spaces. Invisible characters (control and zero-width
ones) are errors, for they could change the meaning unseen. Superscripts, subscripts and primes are kept: `x²` is not
`x2`.
"""

from __future__ import annotations

import unicodedata
from collections.abc import Sequence
from functools import lru_cache

from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError
from lagrange.core.records import record

DOT = "\u0307"
"""A dot over the letter before it."""

GREEK = {
    "α": "alpha", "β": "beta", "γ": "gamma", "δ": "delta", "ε": "epsilon", "ϵ": "epsilon", "ζ": "zeta",
    "η": "eta", "θ": "theta", "ϑ": "vartheta", "ι": "iota", "κ": "kappa", "λ": "lambda", "μ": "mu", "ν": "nu",
    "ξ": "xi", "ο": "omicron", "π": "pi", "ρ": "rho", "ϱ": "varrho", "σ": "sigma", "ς": "varsigma",
    "τ": "tau", "υ": "upsilon", "φ": "phi", "ϕ": "phi", "χ": "chi", "ψ": "psi", "ω": "omega", "Γ": "Gamma",
    "Δ": "Delta", "Θ": "Theta", "Λ": "Lambda", "Ξ": "Xi", "Π": "Pi", "Σ": "Sigma", "Υ": "Upsilon",
    "Φ": "Phi", "Ψ": "Psi", "Ω": "Omega", "ℓ": "ell",
}  # fmt: skip
"""Greek letters and their names; ℓ is `l` where no `ell` is declared."""

ABOUT = r"(?:≈|≃|≅|\\(?:approx|simeq|cong|thickapprox)(?![A-Za-z]))"
"""The pattern of a sign that says `approximately equal`, in plain text and in LaTeX."""

VARIANTS = {
    "vartheta": "theta",
    "varphi": "phi",
    "varrho": "rho",
    "varsigma": "sigma",
    "varepsilon": "epsilon",
    "ell": "l",
}
"""Variants of letters; a variant means the plain letter where only that one is declared."""

PRIMES = {"'": 1, "′": 1, "’": 1, "ʹ": 1, "″": 2, "‴": 3, "⁗": 4}
SUPERSCRIPTS = dict(zip("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-", strict=True))
SUBSCRIPTS = dict(zip("₀₁₂₃₄₅₆₇₈₉ₐₑₒₓₕₖₗₘₙₚₛₜᵢⱼᵣᵤᵥ", "0123456789aeoxhklmnpstijruv", strict=True))
FRACTIONS = {
    "½": "1/2", "⅓": "1/3", "⅔": "2/3", "¼": "1/4", "¾": "3/4", "⅕": "1/5", "⅖": "2/5", "⅗": "3/5",
    "⅘": "4/5", "⅙": "1/6", "⅚": "5/6", "⅛": "1/8", "⅜": "3/8", "⅝": "5/8", "⅞": "7/8",
}  # fmt: skip

_DOTS = {DOT: 1, "\u0308": 2, "\u20db": 3}
_SAME = {
    "−": "-", "–": "-", "‐": "-", "‑": "-", "‒": "-", "·": "*", "×": "*", "⋅": "*", "∗": "*", "∙": "*",
    "÷": "/", "∕": "/", "⁄": "/", "∆": "Δ", "µ": "μ",
}  # fmt: skip
_SPACES = " \t\r\n"
_INVISIBLE = ("Cc", "Cf", "Cs", "Co", "Cn", "Zl", "Zp")
_BLANK = (0x34F, 0x115F, 0x1160, 0x2800, 0x3164, 0xFFA0, *range(0xFE00, 0xFE10), *range(0xE0100, 0xE01F0))
"""Characters that are shown as nothing, though Unicode counts them as letters, marks or signs."""
_LOOK_ALIKES = dict(
    zip(
        "аеорсухіјѕԁһкмтАВЕКМНОРСТХІЈЅΑΒΕΖΗΙΚΜΝΟΡΤΧ",
        "aeopcyxijsdhkmtABEKMHOPCTXIJSABEZHIKMNOPTX",
        strict=True,
    )
)
_SUGGESTIONS = {
    "#": "comments go on lines of their own",
    ";": "write one equation at a time",
    '"': "primes are written with apostrophes: `theta''`",
    "“": "primes are written with apostrophes: `theta''`",
    "”": "primes are written with apostrophes: `theta''`",
    "‘": "primes are written with apostrophes: `theta'`",
    "´": "primes are written with apostrophes: `theta'`",
    "`": "primes are written with apostrophes: `theta'`",
    "\\": "LaTeX is read in answers only: write `theta` without a backslash",
    "$": "LaTeX is read in answers only: write the expression without `$`",
    "{": "group with parentheses",
    "}": "group with parentheses",
    ":": "an equation is written with `=`",
    "≈": "an equation is written with `=`",
    "≡": "an equation is written with `=`",
    "_": "a name begins with a letter",
    "%": "write a percentage as a fraction: `10/100`",
    "!": "there are no factorials; write the number",
    "—": "a minus is written `-`",
    "±": "declare a sign: `parameters: {sigma: sign}` is +1 or -1",
    "∓": "declare a sign: `parameters: {sigma: sign}` is +1 or -1",
    "∛": "write `x^(1/3)`",
    "∜": "write `x^(1/4)`",
    "∞": "numbers are finite",
    "∂": "a partial derivative is written `diff(e, x)`",
    "∇": "a derivative is written `diff(e, x)`",
    "∑": "write the terms out",
    "∏": "write the factors out",
    "∫": "there are no integrals in an expression",
    "•": "a product is written `*`",
    "ϖ": "write `pi` for the number, or another name",
}
_DEFAULT_SUGGESTION = "write it with numbers, declared names, `+ - * / ^ =` and parentheses"


@record
class NormalizedText:
    """A normalized text. Its character n comes from position `places[n]` of the text as it was written."""

    text: str
    places: Sequence[int]

    def written(self, start: int, end: int) -> tuple[int, int]:
        """The place of characters `start` to `end` (exclusive) in the text as it was written."""
        return self.places[start], max(self.places[end], self.places[start] + 1)


def normalized(fragment: Fragment) -> NormalizedText:
    """Normalize a text. Raises ProblemError at an invisible character."""
    text = fragment.text
    if text.isascii() and text.isprintable():
        return NormalizedText(text, range(len(text) + 1))
    shown: list[str] = []
    places: list[int] = []
    for index, char in enumerate(text):
        look = _look(char)
        if not look:
            name = unicodedata.name(char, f"U+{ord(char):04X}")
            message = f"an invisible character ({name})"
            span = fragment.span(index, index + 1)
            raise ProblemError(Diagnostic("invisible-character", message, span, help="delete it"))
        shown.append(look)
        places.extend([index] * len(look))
    return NormalizedText("".join(shown), [*places, len(text)])


def suggestion_for_character(char: str) -> str:
    """A suggestion what to write instead of a character that has no meaning."""
    if char in _LOOK_ALIKES:
        return f"this is {unicodedata.name(char)}; write the Latin letter `{_LOOK_ALIKES[char]}`"
    if char in _SUGGESTIONS:
        return _SUGGESTIONS[char]
    category = unicodedata.category(char)
    if category.startswith("M"):
        return "dots over a letter are time derivatives; other accents mean nothing"
    if category.startswith("L"):
        return "names consist of letters a to z, digits, `_` and Greek letters"
    return _DEFAULT_SUGGESTION


@lru_cache(maxsize=4096)
def _look(char: str) -> str:
    """The character that this one looks like, followed by the dots over it; empty if it is invisible."""
    if char in _SPACES:
        return " "
    if char in _DOTS:
        return DOT * _DOTS[char]
    if (char.isascii() and char.isprintable()) or char in GREEK:
        return char
    category = unicodedata.category(char)
    if category in _INVISIBLE or ord(char) in _BLANK:
        return ""
    if category == "Zs" and char != "\N{OGHAM SPACE MARK}":
        return " "
    kind, _, code = unicodedata.decomposition(char).rpartition(" ")
    if code and kind in ("<font>", "<wide>", "<narrow>", ""):
        return _look(chr(int(code, 16)))
    base, *marks = list(unicodedata.normalize("NFD", char))
    if marks and all(m in _DOTS for m in marks) and (base.isascii() or base in GREEK):
        return base + DOT * sum(_DOTS[m] for m in marks)
    return _SAME.get(char, char)
