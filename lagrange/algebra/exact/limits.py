"""Limits of the exact algebra: sizes beyond which a question stays undecided, and draws before giving up.

None of them decides what is true: beyond a limit the answer is "undecided" or "no point". How many points a decision
needs is in `points_needed`. A number in brackets is the largest value met in the 129 shipped problems, read off when
the limits were gathered: [831] of 100,000.
"""

# Graph (`expression_graph`). Bounds memory and time of a hostile input [831 nodes, 33 symbols].
MOST_NODES = 100_000
MOST_SYMBOLS = 1_000
# Nodes evaluated at a point for a unit of work (`core.effort`).
NODES_PER_UNIT = 10
# Steps besides for each of them where its value is a number of fifty digits and not a residue: it takes three times as
# long.
STEPS_OF_A_DECIMAL = 2
# Terms of an angle or exponent that is multiplied out [3]; a product of forty sums would have 2^40.
MOST_ANGLE_TERMS = 200
# Operations of an angle with a quotient of sums that is cancelled first, which takes a polynomial gcd.
LARGEST_CANCELLED_ANGLE = 40
# Numbers above 23 that must be squares in the field [0]: each halves the primes, so that twelve take 2^12 draws.
MOST_WANTED_SQUARES = 12
# Nested opaque functions, log(log x): each level is resolved by one more differentiation, of all symbols.
DERIVATIVE_DEPTH = 4

# Angles of marked value compared with earlier ones (`field_points`), and the largest whole numbers of a ratio. A random
# ratio is taken for such a fraction with a probability of 10^6/2^88 at most.
MOST_COMPARED_ANGLES = 40
LARGEST_ANGLE_RATIO = 720

# Real points (`real_points`). Arguments and powers beyond these make a point inadmissible: e^60 = 10^26 leaves 54 of
# eighty digits, an angle of 10^6 costs six, a power of 10^4 takes no time [3].
LARGEST_REAL_ANGLE = 10**6
LARGEST_REAL_EXPONENT = 60
HIGHEST_REAL_POWER = 10**4
# Argument of an undefined function that is still rounded to a whole multiple of 10^-42, the key of its value.
LARGEST_ROUNDED = 10**100
# Newton's iteration doubles the digits in each step once it converges: after 30 steps it does not.
NEWTON_STEPS = 30
# Constraints from which on its steps are taken in sixteen digits, and the pivots, beside the squares of a row, with
# which these can be trusted: each step gains ten digits at least.
FEWEST_ROUGH_STEPS = 6
LEAST_ROUGH_PIVOT = 1e-6

# Fields and points (`sampler`). Points of one field share its primes' chance of error, and drawing a prime costs more
# than drawing a point: four points a field, eight fields in turn.
FIELDS = 8
POINTS_PER_FIELD = 4
# Points that are kept with all their values; a question with signs asks for up to 50 in the shipped problems.
KEPT_POINTS = 40
# Draws of a point of the surface, and inadmissible points in a row [4], before there counts as none.
DRAWS = 200
# The same for a real point, which costs more, before another way is tried.
REAL_DRAWS = 30
NEWTON_STARTS = 8
# Draws of the symbols under a root that does not exist: k independent roots in turn take about 2k.
REDRAWS = 60
# Tries in a row, of all these draws, without an admissible point: no point is, as where exp(exp(exp x)) overflows
# everywhere. 60 rounds of 50 redraws find 25 independent roots.
MOST_TRIES = 3_000
# Points without success before the surface counts as having none.
MOST_MISSING_POINTS = 3
# Random reals are e^s with |s| < SPREAD, 0.14 ... 7.4. Later points are wide, 6·10^-6 ... 1.6·10^5, because a sign may
# change far away; they come last, as e^x of a large x is inadmissible. On a surface lengths must fit together.
SPREAD = 2
WIDE_SPREAD = 12
FIRST_WIDE_POINT = 6
SPREAD_ON_SURFACE = 1

# Triangular order (`triangular`). Draws at which a block is tried. A root exists at half of the points, and is the
# value of a positive symbol at half of these: 100 draws all fail with (3/4)^100, and with two such roots (15/16)^100.
BLOCK_TRIALS = 100
# Points at which all trials of a block with symbols of its own failed, before the block counts as unsolvable: with two
# roots of positive symbols (15/16)^1200. A block without such symbols has one trial at each point, and all `DRAWS`.
MOST_FAILED_BLOCKS = 12
# Blocks tried in one search [73], constraints solved together [4], choices of unknowns for them. Blocks of more than
# four are not looked for among the constraints; all that remain are still tried at once [8].
MOST_TRIED_BLOCKS = 400
# Sets of so many constraints looked at: all fours of fifty.
MOST_COMBINATIONS = 230_000
LARGEST_BLOCK = 4
# Lengths s = √(x² + ...) of the same coordinates, as of the six legs of a platform: beyond, points are real, where the
# roots exist, and not of a field, where 2^6 draws find one.
MOST_SHARED_ROOTS = 3
CHOICES_OF_UNKNOWNS = 20
# Operations of a rule x = R(θ + φ) that is substituted in angles [32].
LONGEST_RULE = 60
# Powers of an unknown, multiples of an angle and degrees of a root in a block [2].
HIGHEST_BLOCK_POWER = 8

# Places where a sign changes (`sampler`): secant steps along a line, the parameter beyond which it is left, lines
# along one symbol each, and rounds of parabolas towards an extremum.
SECANT_STEPS = 40
FARTHEST_WALL = 10**7
LINES_PER_WALL = 3
PARABOLA_ROUNDS = 3

# Nodes of the expressions evaluated on one kept surface [a textbook problem has some hundred]; a new one is taken then.
MOST_KEPT_NODES = 4000
