"""The work allowed for one problem, in units of `core.effort`.

What is not looked for in equations that are too long: each consequence has to be worth a line of a page.

Limits of linear equations in numbers.
"""

from __future__ import annotations

UNITS_OF_SOLVING = 800_000
"""Ten to twenty seconds; 32 links of a chain take most of it, a bicycle half, other shipped problems an eighth."""
LONGEST_RATIO = 80
"""The most operations of two equations of which one may be a constant times the other."""
LONGEST_IN_DIRECTIONS = 120
"""The most operations of a vector that is written by unit vectors with names."""
LONGEST_SPOT_FORMULA = 30
"""The most operations of an acceleration that is written before its value."""
LONGEST_SOLVED = 4 * LONGEST_SPOT_FORMULA
"""The most operations of an equation that is solved for it: one of 3,000 takes more than ten seconds."""
MOST_STATED_NAMES = 12
"""The most quantities with names that are looked for in stated equations: each is compared with every sum in them."""

LONGEST_INTEGRATED = 40
"""The most operations of what is integrated."""

LONGEST_WITH_LIMITS = 60
"""The most operations of equations whose limits are sought; of longer ones no limit is short."""

LONGEST_LIMIT = 18
"""The most operations of an equation in a limit that is worth showing."""

LONGEST_WITH_UNITS = 1000
"""The most operations of an equation whose terms are compared in their units; it is multiplied out for that."""

LONGEST_INTEGRAL_IN_ROOTS = 40
"""The most operations of the terms of an integral that contain roots, if these are put into one fraction."""

HIGHEST_POWER_OF_UNIT = 2
"""The highest power of a base unit in a unit that is worth naming: kg m²/s² is known, kg m⁴/s⁵ is not."""

MOST_AT_REST = 2
"""The most coordinates of a system whose positions of rest are sought without being asked for."""

MOST_LETTERS_AT_REST = 3
"""The most parameters in the equations of two coordinates for this: with more, the frequencies are long roots. The
general double pendulum would take five times as long for a line."""

UNITS_AT_REST = 60_000
"""Work (`core.effort`) for them, half of what a page may take: what a page says unasked must not cost it the rest."""

LONGEST_COMBINED = 400
"""The most operations of equations of motion, constraints and stated equations of which multiples are sought."""

LONGEST_MULTIPLE = 12
"""The most operations of such a multiple."""

MOST_LIMITS = 2
"""The most limits of one problem."""

LONGEST_CONSTANT = 120
"""The most operations of accelerations that are constant."""

LONGEST_PART = 10
"""The most operations of the parts of a reaction."""

LONGEST_FACTORED = 60
"""The most operations of a result that is factored."""

LONGEST_NONLINEAR = 400
"""The most operations of a Lagrangian and of the equation for the root."""

MOST_VANISHING_TERMS = 2
"""The most terms of a factor whose zero is worth a sentence."""

LONGEST_TURNING = 60
"""The most operations of the equations of motion, all together, in which turning is sought."""

LONGEST_TURNING_RATE = 12
"""The most operations of the rate and of the stiffness."""

MOST_CHOICES_OF_DEPENDENT = 10
"""Choices of dependent coordinates that are compared for the fewest left in T: those of three of five."""

LONGEST_CANCELLED = 400
"""Nodes of an expression that is cancelled for a shorter page: those of the shipped problems have a few dozen, and a
direction that is a function taken twenty times of itself, over a thousand, is multiplied out for half a minute."""

MOST_EXPANDED_TERMS = 2_000
"""Terms of a form whose common number is sought: forms in books have a dozen, an arc tangent taken twenty times of
itself a million."""

SHORTER_ALONG_AXES = 0.7
"""Reactions are added up along unit vectors that turn if that takes at most so much of the operations: below this the
vector of a coin or of a disc is the form of the textbooks, above it one list has just been replaced by another."""

SHORTEST_BY_VELOCITY = 7
"""A velocity of fewer operations is written out and not as a multiple of another: m v/((M + m) l) has four."""


# Limits


LONGEST_FOLLOWED = 200
"""The most operations of all equations of motion together of which it is asked whether something follows from them."""

LONGEST_CONSEQUENCE = 30
"""The most operations of a consequence that is worth showing."""

LONGEST_RATE = 24
"""The most operations of an equation in quasi-velocities whose motion in the limit is looked for."""


# Limits


# Parameters without values, and the degree in them: M, D, K are quadratic in velocities and linear in forces.
MOST_LETTERS = 2
HIGHEST_DEGREE = 2
# Further values at which the polynomials are tried.
SPARE_VALUES = 2
# A value below it, beside others of order 1, is zero: numbers have eighty digits, of which fifty are certain.
CLEARLY_ZERO = 1e-40
# Digits of a number that is no short fraction: with fifteen, it would count as one that is not rounded.
SHOWN_DIGITS = 14
# The check takes a state in a distance of 10^-20: a remainder of second order is below 10^-36, and one of first order
# far above. The tables are rounded to fourteen digits, which leaves 10^-31.
CHECKED_DISTANCE = 20
CHECKED_REMAINDER = 1e-30
# Numbers of eighty digits that count as zero.
ROUNDED_TO_ZERO = 1e-55
# Steps in which the exponents of a linear system are found.
MOST_ROOT_STEPS = 200
# Steps in which a position of rest is found; none moves a coordinate by more than 1.
REST_STEPS = 60
# The denominator of a fraction that is written as one.
LARGEST_DENOMINATOR = 100
# Imaginary part of a root, beside its size, below which it is real: of roots with 28 digits.
CLEARLY_REAL = 1e-18
# Operations of a reaction in terms of accelerations.
LONGEST_BY_ACCELERATIONS = 200

LONGEST_PROJECTION = 20
"""Operations of one side of Newton's law along a reaction, beside the reaction itself."""

MOST_GROUPED_TERMS = 40
"""Terms of a polynomial that is written as a sum of products."""

LONGEST_AT_ONCE = 12
"""Operations of rates that are put into the principle without writing the equations before that."""

LONGEST_WAY = 4
"""The most operations of a length, or of a force at every steady state, that is worth a sentence: M g, R/3."""

LONGEST_INVERTED = 30
"""The most operations of an answer that is solved for a velocity: of a longer one the inverse says nothing."""

LONGEST_DRIVE = 10
"""The most operations of what changes a momentum, beside the momentum in one line."""
