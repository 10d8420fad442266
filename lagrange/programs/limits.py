"""Limits of programs and simulations."""

# Unknowns of a mass matrix that is eliminated in symbols; a larger one is solved by a routine with pivoting.
LARGEST_ELIMINATED = 4

# Different parts of all expressions of a program. The largest of a shipped problem, the bicycle's, has 2,300.
LONGEST_PROGRAM = 20_000

# Different parts of the expressions in which equal parts of sums and products are searched for too.
LONGEST_SEARCHED = 500

# Steps of one integration, and the shortest, as a share of the time: beyond, the motion has come to a singular place.
MOST_STEPS = 2_000_000
SMALLEST_STEP = 1e-13
# So many steps must bring a motion on by this share of its time; with less it would take a hundred times MOST_STEPS.
PACE, SLOWEST_PACE = 20_000, 1e-4

# Iterations that bring a state to the constraints, and what is left of them there, relative to the size of the state.
MOST_PROJECTIONS = 40
NEGLIGIBLE = 1e-13
# A change that is no more than rounding, relative to the numbers.
ROUNDING = 1e-15
# What is left of an initial state's conditions, relative to the size of the state, when they contradict each other.
LARGEST_CONTRADICTION = 1e-8
# How far from an equilibrium a motion starts that would otherwise stay there, in SI units.
PUSH = 1e-3
# The angular velocity of a default orbit, relative to that of a circle.
NEARLY_CIRCULAR = 0.9
# Relative tolerance of a step; components smaller than 1 count as 1.
TOLERANCE = 1e-10
# How much larger the tolerance of a motion is with which one is compared that conserves nothing.
REPEATED = 10
# A determinant that is so many times larger or smaller than elsewhere on the way belongs to a pole of the coordinates.
POLE = 1e4
# Above this drift of what is conserved, or error in the constraints, a simulation counts as failed.
LARGEST_DRIFT = 1e-6
# Times at which a motion is given: so many a second, but no fewer and no more than these.
SAMPLES_A_SECOND, LEAST_SAMPLES, MOST_SAMPLES = 50, 1000, 10_000
# Changes of the sense of friction in one simulation.
MOST_FLIPS = 200
# Slips that are zero at the start: each may begin in two senses.
MOST_AT_REST = 4
# A slip in a plane that has become so much slower than it was, or than so much, in m/s, has ended.
ENDED_SLIP, SLOWEST_REFERENCE = 1e-6, 1e-3
# Directions in a plane that are tried for a slip that begins, and its speed there, in m/s.
DIRECTIONS, SLOW = 24, 1e-8
# A reaction that is more negative than this, relative to 1 + its size at the start, has the wrong sign.
WRONG_SIGN = 1e-9
# The width to which the time of an event is found.
NARROW = 1e-12
# A particle with so small a part of its first mass has none left.
NEXT_TO_NOTHING = 1e-6
# Seconds that a motion is followed if neither the user nor the motion says how long.
DEFAULT_TIME = 10.0
# Operations of a conserved quantity that is multiplied out, so that its terms can be weighed.
LONGEST_EXPANDED = 200
# Speeds that are tried for a state in which everything slips that is to slip, and the slowest slip, in m/s.
MOST_TRIED = 3
SLOWEST_SLIP = 0.1

LONGEST_PROGRAM_NAME = 40
"""Characters of a name in a program: MATLAB has 63."""

MOST_PLANES = 4
"""Phase planes in one plot, one a coordinate."""

LARGEST_WHOLE = 10**15
"""Larger integers are written as floats: a double holds 15 digits."""

ORBIT_STEP = 1e-5
ROUNDED_SPEED = 1e-12
"""The step of central differences along an orbit, whose error is then some 1e-10; and the share of the largest speed
below which one is zero."""
