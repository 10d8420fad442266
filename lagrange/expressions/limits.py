"""The limits of the expression language: whatever a text says, reading it takes a bounded time and memory.

Those of the first group are part of the file format and are documented there; each has an error of its own. The rest
bound the work of SymPy on what the first group still admits. "Largest in use" is the maximum over the expressions and
stated answers of the 129 problems of the library, measured in November 2026.
"""

# -- the format --------------------------------------------------------------------------------------------------------

MAX_CHARACTERS = 10_000
"""Characters of an expression. Lexing and parsing are linear in them; largest in use: 97."""

MAX_ANSWER_CHARACTERS = 2_000
"""Characters of a student's equation: a batch has thousands of them, from unknown authors. In use: 177."""

MAX_NESTING = 60
"""Depth of brackets, exponents and functions. The LaTeX lexer recurses most, with seven or eight Python frames a level:
60 levels stay within Python's limit of 1,000 frames, so that `((((...` is refused at its place. In use: 4."""

MAX_DIGITS = 30
"""Digits of a number as it is written. In use: 2."""

MAX_POWER_OF_TEN = 40
"""The power of ten behind a number: `1e999999` would be a million digits; the mass of the electron has e-31."""

MAX_EXPONENT = 20
"""Numbers in an exponent: stops `9**9**9` and `theta''^(10^10)` before SymPy multiplies anything out. In use: 3."""

MAX_NESTED_EXPONENT = 40
"""The product of nested exponents: `((x^20)^20)^20` is x^8000 with three admissible exponents. In use: 4."""

MAX_NAME = 60
"""Characters of a name; it bounds the search for a similar name too. In use: 15."""

HIGHEST_RATE = 2
"""Time derivatives of a coordinate: equations of motion are of second order."""

HIGHEST_PRESCRIBED_RATE = 4
"""Time derivatives of a prescribed motion u(t): the acceleration of a point at u'' has u''''."""

# -- SymPy -------------------------------------------------------------------------------------------------------------

MAX_WORK = 6_000
"""Work on one text in units of about 0.1 ms: 0.6 s, for a hostile text has to fail within a second. In use: 570."""

MAX_WORK_OF_FILE = 60_000
"""Work on all texts of a file: 6 s. Without it, 600 kB of admissible texts took two minutes. In use: 1,908."""

MAX_SIZE = 12_000
"""Nodes of an expression, shared parts counted each time: abbreviations that double (`b: a + a^2`, `c: b + b^2`, ...)
reach 2^60 nodes in a short file. In use: 309."""

MAX_LAYERS = 70
"""Nodes on a path from the root to a leaf: SymPy and the stages recurse over them. A text nests to `MAX_NESTING`;
abbreviations of abbreviations go further. In use: 11."""

MAX_TERMS = 20_000
"""Terms when an expression, or a part of it, is multiplied out, as the derivation does. In use: 34."""

SMALL_POWER = 2
MAX_TERMS_OF_PRODUCTS = 100_000_000
"""Terms of products of numeric powers up to this one, nested ones multiplied: successive rotations, of which the
front wheel of a bicycle has five, and which the derivation leaves as they are."""

MAX_BITS = 4_400
"""Bits of an integer: 30 digits to the power 40 have 3,987. In use: 6."""

MAX_DENOMINATOR = 1_000
"""Denominator of a rational exponent: `x^0.333`, with three decimals, is a thousandth root. In use: 2."""

MAX_EXPANDED_DIVISOR = 200
"""Terms of a divisor up to which it is expanded, to see whether it is 0. Expansion costs one unit a term."""

# -- constants ---------------------------------------------------------------------------------------------------------

CONSTANT_DIGITS = 80
"""Digits to which constants such as sqrt(2) - pi/3 are evaluated; half of them decide whether one is 0."""

MAX_CONSTANT_SIZE = 150
"""Nodes of a constant, each of which is evaluated to all digits. In use: 7."""

MAX_LOGARITHM = 3_000
"""Natural logarithm of the absolute value of a constant: e^3000 has 4,329 bits, which `MAX_BITS` admits."""

MAX_ANGLE_DIGITS = 31
"""Integer digits of the argument of a sine: 80 - 31 remain after reduction by 2π, more than the 40 that are needed, and
a number of `MAX_DIGITS` digits is admissible."""

# -- suggestions and LaTeX ---------------------------------------------------------------------------------------------

MAX_SPLIT = 24
"""Letters of an unknown name that is split into declared ones for a suggestion: the search is quadratic."""

MAX_LISTED = 30
"""Declared names that a message lists."""

MAX_LETTER_RUN = 60
"""Letters of a run in LaTeX that is split into declared names: as long as a name may be; the search is quadratic."""

MAX_SUBSCRIPTS = 4
"""Parts of a subscript in LaTeX whose spellings are tried: each is joined with `_` or without, 2^4 spellings."""
