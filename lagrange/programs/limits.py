"""Limits of programs and simulations."""

# Unknowns of a mass matrix that is eliminated in symbols; a larger one is solved by a routine with pivoting.
LARGEST_ELIMINATED = 4

# Operations of all expressions of a program. The largest of a shipped problem has about 2,000.
LONGEST_PROGRAM = 200_000
