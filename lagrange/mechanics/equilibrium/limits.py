"""Limits of statics and small oscillations: beyond them nothing is claimed, "undecided" or no result.

Sizes are operations (`core.expression_size`). A number in brackets is the largest value met in the 129
shipped problems, measured when the limits were gathered; "beyond" is how often a limit was exceeded there.
"""

# Free coordinates whose leading minors are worked out [3]; of larger matrices of stiffness the other principal minors
# are worked out up to two rows.
MOST_MINORS = 4
# Order of the derivatives of V, where V'' vanishes in one coordinate: x⁶ is the highest that is recognised as stable.
HIGHEST_ORDER = 6
# Where it vanishes in one direction of several: coordinates, and operations of a derivative at the equilibrium. Three
# coordinates have 56 derivatives of each force.
MOST_IN_A_VALLEY = 3
LONGEST_DEGENERATE = 60

# Points of one branch of equilibria for which reactions are sought [2]: each is a root of its own, and every zero test
# is made at all of them.
MOST_BRANCH_POINTS = 12

# Unsolved conditions of equilibrium that are still shown [1 beyond, 324 operations], and coordinates of a system for
# which 0 and π are tried instead [2]: 2^4 places.
LONGEST_UNSOLVED = 60
MOST_TRIVIAL_COORDINATES = 4

# Small oscillations: equilibria whose linear equations are worked out [3], and that are compared with them, as copies
# take little; independent coordinates [3] (a chain of 20 masses takes 5 s), those of a damped
# system whose modes are found numerically, operations of a coefficient of the characteristic polynomial that is
# factored [9].
MOST_EQUILIBRIA = 16
MOST_COMPARED_EQUILIBRIA = 200
MOST_OSCILLATING = 20
MOST_OSCILLATING_IN_NUMBERS = 8
LONGEST_COEFFICIENT = 200
# Points of one equilibrium at which the check compares the linear equations.
MOST_COMPARED_POINTS = 4

# Sampled checks: parameters drawn for one point of a branch, and how many of them must be in the region where it is
# stated to be stable and in that where it is stated to be unstable; draws until one of them is of use [30]. What is
# wrong in a share s of a region passes with (1 − s)^8: 0.4 % for a half, 43 % for a tenth. The conditions are
# derived exactly; what these samples find is a sign or a case that is wrong as a whole. Rows of a determinant of which
# the frequencies are the roots [3].
MOST_DRAWS = 40
MOST_DRAWS_FOR_ONE = 400
SAMPLES_PER_SIDE = 8
# Where the second variation vanishes V is followed in numbers: points for each verdict, directions around a circle and
# near the one in which V rises least, the smaller of two steps (V of the sixth order rises with the rate 10⁻²⁵, far
# above the 10⁻⁴² that rounding leaves, and above what counts as no rate), and how far the logarithm of the ratio of two
# rates may be from an integer; how far directions near the least are from it, in radians.
POINTS_OF_A_VALLEY = 2
DIRECTIONS_OF_A_VALLEY = 16
DIRECTIONS_NEAR_THE_LEAST = 8
STEP_IN_A_VALLEY = 1e-5
NO_RATE = 1e-40
INTEGER_ORDER = 0.2
WIDEST_SPREAD = 0.2
MOST_EXPANDED_ROWS = 4

# Random parameters at which each branch of equilibria is tried as it is stated: forces that do not balance do so to 25
# digits at none of them; a branch that is wrong at a share s of its points passes with (1 − s)². Then draws until its
# conditions hold; places from which its positions are sought numerically; unsolved equations of a branch on whose
# surface points are sought, which takes seconds with more.
STATED_SAMPLES = 2
MOST_STATED_DRAWS = 200
MOST_STATED_PLACES = 40
MOST_UNSOLVED = 2

# Friction at rest. Inequalities at once, and signs of coefficients that are taken one by one: two contacts have five
# inequalities, and the shipped problems need no cases. Operations of an expression whose sign is asked in several
# forms.
MOST_INEQUALITIES = 60
# Cases that are compared with one another, each pair of conditions by a quotient.
MOST_MERGED = 4
MOST_CASES = 3
# Orders in which the forces of one-sided constraints are eliminated: the last ones remain open.
MOST_ORDERS = 6
LONGEST_SLACK = 400
# Coordinates among which those are sought that grow together in a displacement of the whole: 255 sums of derivatives.
MOST_SHIFTED = 8
# Static friction entries of a problem: each open sense doubles the cases of impending motion.
MOST_ROUGH_CONTACTS = 6
# Units of work (`core.effort`) for friction at rest [750]. Of a wedge with three rough faces only impending motion is
# found.
UNITS_OF_REST = 45_000
# Units for the lowest terms of V in one branch where V'' vanishes in some directions, a second or two; the tests of it
# need 611 at most.
UNITS_OF_LOWEST_FORM = 20_000

# Search for lost equilibria: unknowns, multipliers among them; places from which the iteration starts for each choice
# of parameters; operations of all of them together, about a tenth of a second; angles that may be turned, each by
# itself. Of eight branches of six shipped systems, each removed from its list and sought with six seeds, 42 of 48 were
# missed from the list with 2 starts, 46 with 16 and with 32, where the work ends the search first.
MOST_SEARCHED_UNKNOWNS = 10
SEARCHED_STARTS = 16
SEARCHED_OPERATIONS = 300_000
MOST_TURNED = 3

# Points of equilibria without a closed form at which an answer is tried: all of them are on one of the two ways to
# assemble a linkage with the probability 2^-7.
UNSOLVED_POINTS = 8

# Limits of one force between several rough contacts: sets of bounds that are tried [of three contacts 20], and draws
# of numbers. A case that a share s of them leads to is overlooked with (1 − s)^60, 4.6 % for a twentieth; it is then
# missing as a case, and the limits of the others hold under their conditions. Last, contacts from which on limits are
# sought so, instead of eliminating forces one by one.
MOST_BOUND_SETS = 1000
DRAWS_OF_LIMITS = 60
CONTACTS_OF_LIMITS = 3
# Cases of these limits, by how often the drawn numbers lead to them.
MOST_REGIMES = 3

MOST_FORCED = 4
"""The most coordinates for which a steady state is written in symbols."""

MOST_UNKNOWNS = 4
MOST_CHARTS = 2
"""Unknowns of equilibria in numbers, and choices of rows for the elimination of multipliers that are tried until the
list is complete: the boxes of the search grow with 2^n."""

USUAL_SIZE = 10
WITHOUT_LENGTHS = 100
"""Lengths are searched up to so many times the sum of the lengths in the problem; up to this where it has none."""

BEYOND_PI = 3.3
"""Angles are searched between -3.3 and 3.3: a little more than a turn, so that no root at π is lost on the edge."""

NEWTON_STEPS = 40
STILL = 1e-10
"""Steps of Newton's method from one place, and the residual of a place of rest, in floating point."""

SMALL_PIVOT = 1e-6
"""A pivot below this part of the largest entry is none: the rank drops where zeros fill a curve."""

SEARCH_DIGITS = 60
CONFIRMING_DIGITS = 45
CONFIRMING_STEPS = 7
"""A place of rest counts if its residual is below 1e-45, reached in so many steps with 60 digits: Newton's method
doubles the ten digits of the search in each, and a multiple root is not confirmed."""

SPREADS = (1, 1, 2)
"""Parameters are drawn so many times, between 2^−spread and 2^spread."""

FARTHEST = 60.0
"""A search that goes farther is given up: nothing is expected at infinity."""

AGREES = 1e-18
DIFFERS = 1e-9
"""Relations hold to so many digits at a confirmed place of rest; conditions fail by so much, or they hold."""

LONGEST_RANGE_CONDITION = 30
"""Operations of an expression that becomes a condition: a longer one would not be read."""

SMALL_BOUND = 1e-9
"""A minor or a rate of bounds, compared at drawn numbers of order one with 16 digits, that counts as zero. The numbers
only choose the bounds that decide; the result is proved in letters."""

BOX = 2.5
"""Coordinates that are no angles are searched between −BOX and BOX: most lengths are drawn between 1/2 and 2."""

LONGEST_LINK = 60
"""Operations of a constraint whose squares are completed, for the reach of its links: a rod between two moving points
in space has 10."""

CONDITION_MARGIN = 1e-6
BALANCED = 1e-25
"""Positions of a stated branch, found in 60 digits: a condition holds by this margin, and the forces balance if their
sum is below 1e-25; they do not if it is above `DIFFERS`, and in between no claim is made."""

# Operations of the second derivatives of V, all together, in which a displacement is sought that leaves V as it is:
# three masses in a line have 4. With those of two springs in a plane, 154, the elimination took half a minute.
LONGEST_SECOND_VARIATION = 60

MOST_ANGLES = 2
"""Angles that a sine, cosine or tangent stands for: more, within several turns, are not listed."""

SAME_IN_MODES = 1e-9
"""The relative difference below which an amplitude is zero, or the square of a frequency the same, in numbers."""

LONGEST_POTENTIAL = 25
"""Operations of a potential energy that is written out beside its second derivative."""

MOST_BOUNDS = 4
"""Bounds of the only open force of a statically indeterminate system that a page writes down."""
