"""Limits of linear equations in numbers."""

# Parameters without values, and the degree in them: M, D, K are quadratic in velocities and linear in forces.
MOST_LETTERS = 2
HIGHEST_DEGREE = 2
# Further values at which the polynomials are tried.
SPARE_VALUES = 2
# A value below it, beside others of order 1, is zero: numbers have eighty digits, of which fifty are certain.
CLEARLY_ZERO = 1e-40
# Digits of a number that is no short fraction.
SHOWN_DIGITS = 15
