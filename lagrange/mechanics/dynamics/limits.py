"""Limits of dynamics: beyond them a result is not shown or a symmetry not found; nothing becomes wrong.

Sizes are operations (`core.expression_size`). A number in brackets is the largest value met in the 129
shipped problems, measured when the limits were gathered; "beyond" is how often a limit was exceeded there.
"""

# Coordinates of a system without constraints that is solved for the accelerations (`motion`, `matrix_form`)
# [3; 3 beyond, 6]. M⁻¹ of more of them fills pages; the matrices are given all the same.
MOST_FREE = 3
# Operations of a multiplier that is substituted into the equations of motion as friction needs it [16; 1 beyond, 39].
# A longer one stays |λ| in the equations that are shown.
LONGEST_SUBSTITUTED = 30

# Velocities of a choice known only through constraints (`equations.closed`): operations of the elimination that gives
# them, and growth of the equations, to at most three times their length plus as many operations [7].
LONGEST_RATES = 200
MOST_LONGER = 3
# Points at which the kernel of the inertia is found; the smallest counts. One point in the field may have a larger
# kernel by accident, with a chance of about 2^-61 times the degree.
INERTIA_POINTS = 2

# Quasi-velocities. Operations of all entries on the way to the kinematic equations [149], and of these themselves
# [65, the velocities of an aircraft]: beyond, kinematic equations would fill pages (commit b122de1).
LONGEST_ELIMINATION = 1500
LONGEST_KINEMATIC = 300
# Quasi-velocities whose rates are solved for [6, an aircraft], and operations of their equations [47].
MOST_SOLVED_RATES = 6
LONGEST_SOLVED_RATES = 300

# Candidates for symmetries (`noether`). Pairs of Cartesian coordinates of one point [6]; four particles in space have
# 12. With more than these, no rotations are tried.
MOST_ROTATIONS = 24
# Coordinates for gauge symmetries [6]: n (n − 1)/2 pairs of partial derivatives for each candidate.
MOST_GAUGE_COORDINATES = 12
# Virtual displacements admitted by kinematic constraints, and operations of one [12].
MOST_DISPLACEMENTS = 6
LONGEST_DISPLACEMENT = 60
# Coefficients of a combination, read off residues in the prime field: parameters whose products in pairs are tried
# (about 4 · 12²/2 monomials), and numerator and denominator of the number [2]. Two sets of parameters must agree on it.
MOST_PARAMETERS = 12
LARGEST_NUMBER = 64
# Sets of parameters that are tried, and draws after which a set without a state is given up. With some sets the
# constraints have no solution in the field: with 6 trials the momentum of a rod between beads on a ring was found in
# seven runs of eight (commit 7512be9).
PARAMETER_TRIALS = 24
FIRST_DRAWS = 40
# States of one set of parameters at which a division by zero may occur before the set is given up.
MOST_FAILED_STATES = 40
# States beyond those that give as many conditions as there are candidates: a member of the null space that is no
# identity of degree d satisfies one more state with the probability d/p at most (`points_needed`), three with its cube.
SPARE_STATES = 3

# Spot values. Digits of the numbers, of those recognised as fractions (of the 80 of the elimination), and below which a
# number is zero.
DIGITS = 30
RECOGNISED_DIGITS = 60
ZERO_DIGITS = 20
# Denominator of a fraction that is recognised; beyond, six figures are easier to type than the fraction.
LARGEST_DENOMINATOR = 1000
# Velocities of a state. Two rods in line do not admit every velocity of their end: the pivot is zero up to the last
# digits of the position, and the other velocities would be 10³².
LARGEST_VELOCITY = 10**6
# Sets of numbers that are tried for the parameters until the constraints have a real position; none decides anything.
SPOT_TRIALS = 8
# Newton's iteration: sets of dependent coordinates, of which a chain of eight links has thousands (commit 95098ff), and
# steps for each; quadratic convergence reaches 20 digits in five or six from a good start.
MOST_DEPENDENT_SETS = 24
MOST_ITERATIONS = 30
# States of motion that a system keeps for the comparisons after this one: three without branches, some forty with.
MOST_STATES_KEPT = 64

ANGLES_TO_TRY = (30, 50, 20, 40, 70, 10, 60)
"""In degrees, for a value to try on a calculator: few of them differ by what makes terms vanish."""
