"""The limits of reading a problem file: no file may exhaust memory or time, and no genuine problem comes near them.

The largest of the shipped files has, for comparison, 2.7 kB, 229 values on 6 levels, 37 names of at most 20
characters, and abbreviations that amount to 486 parts where they are used.
"""

# -- variants ----------------------------------------------------------------------------------------------------------

MOST_VARIED_VALUES = 10_000
"""That a range of `vary` has; a course has fewer students."""

LONGEST_SEED = 200
"""Characters; a name and a number have fewer."""

# -- the text ----------------------------------------------------------------------------------------------------------

MAX_BYTES = 1 << 20
"""Bytes of a file: 400 times the largest shipped one. More is not read at all."""

READINGS = 3
"""Readings of a file that is written to meanwhile, before it is refused: half an old text and half a new one."""

MAX_DEPTH = 20
"""Levels of lists and mappings, the scalar inside counted too. The keys need 6."""

MAX_NODES = 20_000
"""Values; those of an alias count each time it is used. This many take 2 s to compose."""

MAX_ALIASES = 50
"""`*name` in a file. No shipped file has any; nested ones multiply, which MAX_NODES bounds."""

MOST_REJOINED = 40
"""Parts of a list in brackets in which a parenthesis that YAML has split at commas is looked for."""

# -- names -------------------------------------------------------------------------------------------------------------

MAX_NAME_LENGTH = 60
"""Characters; three times the longest in the shipped files."""

MAX_WORDS_LENGTH = 60
"""Characters of `name:`, the words for a particle or body, which stand in the middle of sentences."""

MAX_NAMES = 1_000
"""Declared in a file. Every name is compared with the others when a misspelling is explained."""

MOST_SIGNS = 20
"""Signs sigma_1, sigma_2, ... that answers may name; the shipped ones name 2."""

# -- diagnostics -------------------------------------------------------------------------------------------------------

MOST_COLLECTED = 300
"""Errors and notes after which reading stops: a file so wrong is not a problem file."""

MOST_SHOWN = 100
"""Errors printed; a reader fixes the first before reading more."""

MOST_ALTERNATIVES_SHOWN = 4
"""Alternatives of a nonlinear constraint that a message writes out: two squares of either sign have four."""

# -- expressions -------------------------------------------------------------------------------------------------------

MAX_WRITTEN_OUT = 1_000_000
"""Parts that all abbreviations of a file amount to where they are used, derivatives counted as four times as large.

Two thousand times the largest shipped file: abbreviations of abbreviations grow exponentially with their number.
"""

UNITS_OF_READING = 100_000
"""Units of work (`core.effort`) for a whole file."""

MOST_TESTED = 400
"""Parts of an expression that is tested for zero while reading; of all together, five times as many.

The exact test of 600 parts takes 0.05 s. The largest in the shipped files has 309 (axes of a body).
"""

MOST_REDUCED = 150
"""Parts of a nonlinear constraint that is taken apart; of all together, ten times as many.

Factoring one of 149 parts, a product of four forms written out, takes 1 s. The largest in the shipped files has 15.
"""
# Questions of a file: each is solved for, which may take seconds.
MOST_QUESTIONS = 20

# Parts of `figure`: each is drawn, a surface with some hundred pieces.
MOST_DRAWN = 60

LONGEST_PLACE = 100
"""Operations of an expression whose dimension is looked at: longer ones are multiplied out too slowly."""
