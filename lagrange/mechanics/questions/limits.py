"""Limits of answering questions: beyond them a question stays unanswered, and the derivation says so."""

# Operations of an equation, after accelerations and reactions were substituted, that is handed to the solver.
LONGEST_EQUATION = 400
# Unknowns that are eliminated together.
MOST_UNKNOWNS = 12
# Points of all branches at which a quantity is evaluated.
MOST_POINTS = 40
# Operations of an equation of motion that is integrated in closed form.
LONGEST_INTEGRATED = 120
# Terms of a forcing that is a sum of waves and powers of t.
MOST_FORCING_TERMS = 6
# Sets of values for the parameters at which answers are checked, and digits of these checks: a wrong value agrees to so
# many digits at none of them; three guard against a set at which what is wrong has no weight.
SAMPLES = 3
DIGITS = 30
# Numerical solution: steps of time that are tried, the longest in the unit of time of the file, and the evaluations of
# the equations of motion in one search.
HORIZONS = (1.0, 10.0, 100.0, 1000.0)
MOST_EVALUATIONS = 200_000
# Cases of a solution in closed form: signs of discriminants, resonance.
MOST_CASES = 6
# Sets of values that are tried for the conditions of an answer to hold, and states of an answer that are checked.
SAMPLES_TRIED = 12
MOST_SAMPLED_STATES = 4
# A zero of a condition before this share of the horizon is that of the initial state.
SMALLEST_TIME = 1e-9
# What a finite constraint may be off zero after an integration in dependent coordinates.
LARGEST_DRIFT = 1e-6
# Coordinates of coupled linear equations that are solved in time.
MOST_COUPLED = 3
# Numbers whose difference is smaller count as equal.
SMALLEST_DIFFERENCE = 1e-9
# Operations of a value whose denominator is freed of roots.
LONGEST_MULTIPLIED_OUT = 60
# Signs of values that are remembered: the branches of several questions are compared with the same places.
MOST_SIGNS = 2048
# Functions of one coordinate whose zeros are remembered.
MOST_FUNCTIONS = 128

NODE_DIGITS = 40
"""Digits to which an integrand is evaluated: near a place of rest it is 1/√ of a difference that cancels."""

ACCURATE = 1e-8
"""The relative error up to which a time integrated numerically counts."""

# Velocities at t = 0 that the constraints determine only together; their equations are reduced in plain SymPy.
MOST_TOGETHER = 6

TIMES_ASKED = 3
"""How often it is asked whether a solution that is put back gives zero: each time at other points of another field."""

MOST_TURNS = 16
"""Right angles on the way to a state at which a contact is looked at: four turns of a loop, all of them alike."""

SHARE_DIGITS = 6
"""Digits of a number in front of letters, as of a time found numerically alone: more than a page shows."""

CLOSE = 1e-6
"""The relative difference up to which an exact value is that of an integration."""

STEPS_OF_HALF_TURN = 2000
"""The steps in which a place is looked for along an angle, from an unstable equilibrium."""

MOST_ANGLES = 2
"""Angles of a position that are looked for among those that the file gives, of which it may give as many."""

LONGEST_CONDITION = 16
"""Operations of a condition that a place is reached at all; a longer one tells the reader nothing."""
