"""Sizes at which mathematics is written in another way, each with the reason for its value."""

LONGEST_LIST = 3
"""Arguments of an undefined function that are written at each occurrence: f(x, y, t) is read at a glance, F_x of seven
arguments is not."""
MOST_PRIMES = 3
"""Primes that are counted at a glance, f‴; beyond, a derivative has a number."""
LONG_LATEX = 120
"""Characters of LaTeX in a denominator or under a root that is too long to stay in one piece: about 19 em, half a line
(6.2 characters an em, counted in the rows of twelve shipped problems)."""
LONG_MATHML = 12
"""Letters of a denominator that is too long to stay in one piece: about half of what a phone shows on a line."""
LONGEST_EXPONENT = 20
"""Characters of an exponent behind e^ in a terminal; exp(...) of a longer one is easier to read."""
LONGEST_RATE = 8
"""Characters below which a quantity is written dp_θ/dt, and from which on d/dt (...)."""
SHORT_MATHML = 20
"""The most characters of a numerator that stays above its line in a formula that is cut."""

USUAL_DIGITS = 6
"""Significant digits of a float that is not rounded already: one with the precision of a float or more."""
