"""Limits of closed-form solving: beyond them an equation stays in its branch, and is reported as unsolved.

A number in brackets is the largest value met in the 129 shipped problems, read off when the limits were gathered.
"""

# Branchings of one search [11]; a system that branches more is given back unsolved (`branching`).
MOST_BRANCHINGS = 300
# Operations of one search (`core.effort`) [3,800]: beyond, as of two rods with a spring, the system is given back
# unsolved, and its solutions can be found numerically.
UNITS_OF_SOLUTIONS = 15_000
# Points of a branch that are verified one by one, seven independent signs of roots: 2^7. With more, whether all of them
# satisfy the equations is undecided.
MOST_BRANCH_POINTS = 130
# Unknowns of which all combinations of 0 and π are tried (`single_equation`) [2]: at most 2^4 points.
MOST_TRIVIAL_UNKNOWNS = 4
# Multiples of an angle expanded in its cosine and sine (`unit_circle`).
HIGHEST_MULTIPLE = 12

# Polynomials (`polynomial_roots`): operations [123] and symbols [10] of one that is factored, degree of one whose roots
# are sought [3]. Twice to four times as much is still brought over one denominator, which is cheaper.
LARGEST_FACTORED = 400
MOST_FACTORED_SYMBOLS = 14
HIGHEST_DEGREE = 8
# Operations of an expression that is factored to find its sign (`signs`) [45].
LARGEST_SIGNED = 300
# Operations from which on the sign of an expression is first looked at in numbers, and at how many points.
SHORTEST_TRIED = 12
TRIED_POINTS = 24
# Operations of a value of which several forms are compared (`solution_sets`) [75].
LONGEST_REWRITTEN = 150

# Characteristic equations (`eigenmodes`): rows [3], operations of all entries [53] and symbols [6] of a matrix whose
# determinant is worked out.
MOST_MATRIX_ROWS = 6
LARGEST_MATRIX = 400
MOST_MATRIX_SYMBOLS = 12
# Operations of a factor whose roots are sought [20] and of a root that is written down [22]; longer ones fill lines.
LONGEST_SOLVED_FACTOR = 80
LONGEST_ROOT = 80

# Whether equations that are not solved have a real solution (`existence`): the degree of a polynomial of which the
# real roots are counted, unknowns of a box, boxes tried, about 0.1 ms each, and places on either side of 0 between
# which a sign may change; quarter turns at which a function of an angle, and of its sine and cosine, is evaluated.
HIGHEST_COUNTED_DEGREE = 40
MOST_BOXED_UNKNOWNS = 3
MOST_BOXES = 3000
SCANNED = 60
QUARTER_TURNS = 8

# Conditions that are reduced together, the degree in one monomial of those that become intervals, and multiples of
# conditions of which another one is the sum (`conditions`).
MOST_CONDITIONS = 8
HIGHEST_CONDITION_DEGREE = 12
MOST_COMBINED = 4
# The degree of a rational function of t that is taken apart: a rocket's mass is of the first.
HIGHEST_RATIONAL_DEGREE = 12
# Operations of a denominator whose zeros are sought, where an equation divides by it.
LONGEST_DENOMINATOR = 30
# Operations of an equation that is compared with others of the same squares, as of three spheres.
LONGEST_SPHERE = 60
# The square of a length where a polynomial vanishes: terms of either, and variables whose orders are all tried.
MOST_REDUCED_TERMS = 40
MOST_REDUCED_VARIABLES = 3
# So many equations with the same squares are subtracted: of two circles the solution in letters is long.
SPHERES = 3

CIRCULAR_ERROR = 1e-14
"""What bounds of sines and cosines in floating point are widened by: fifty rounding errors."""

INNER_FRACTION = 4
"""As many operations is a fraction within a fraction as hard to read."""

LIBRARY_ERROR = 1e-15
"""Relative error of sin, cos, exp and log in floating point: more than four units in the last place, where good
libraries have one."""

LARGEST_ANGLE = 1e6
"""A sine of a larger angle is anything between −1 and 1."""
