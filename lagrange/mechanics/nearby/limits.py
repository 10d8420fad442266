"""Limits of linear equations in numbers."""

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
