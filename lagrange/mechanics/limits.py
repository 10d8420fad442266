"""The work allowed for one problem, in units of `core.effort`."""

UNITS_OF_SOLVING = 800_000
"""Ten to twenty seconds; 32 links of a chain take most of it, a bicycle half, other shipped problems an eighth."""
LONGEST_RATIO = 80
"""The most operations of two equations of which one may be a constant times the other."""
LONGEST_IN_DIRECTIONS = 120
"""The most operations of a vector that is written by unit vectors with names."""
LONGEST_SPOT_FORMULA = 30
"""The most operations of an acceleration that is written before its value."""
LONGEST_SOLVED = 4 * LONGEST_SPOT_FORMULA
"""The most operations of an equation that is solved for it: one of 3,000 takes more than ten seconds."""
MOST_STATED_NAMES = 12
"""The most quantities with names that are looked for in stated equations: each is compared with every sum in them."""

LONGEST_INTEGRATED = 40
"""The most operations of what is integrated."""

LONGEST_WITH_LIMITS = 60
"""Of equations whose limits are sought."""

LONGEST_LIMIT = 18
"""The most operations of an equation in a limit that is worth showing."""

LONGEST_WITH_UNITS = 1000
"""The most operations of an equation whose terms are compared in their units; it is multiplied out for that."""

MOST_LIMITS = 2
"""The most limits of one problem."""

LONGEST_CONSTANT = 120
"""The most operations of accelerations that are constant."""

LONGEST_PART = 10
"""The most operations of the parts of a reaction."""

LONGEST_FACTORED = 60
"""The most operations of a result that is factored."""

LONGEST_NONLINEAR = 400
"""The most operations of a Lagrangian and of the equation for the root."""

MOST_VANISHING_TERMS = 2
"""The most terms of a factor whose zero is worth a sentence."""

LONGEST_TURNING = 60
"""The most operations of the equations of motion, all together, in which turning is sought."""

LONGEST_TURNING_RATE = 12
"""The most operations of the rate and of the stiffness."""

MOST_CHOICES_OF_DEPENDENT = 10
"""Choices of dependent coordinates that are compared for the fewest left in T: those of three of five."""

LONGEST_CANCELLED = 400
"""Nodes of an expression that is cancelled for a shorter page: those of the shipped problems have a few dozen, and a
direction that is a function taken twenty times of itself, over a thousand, is multiplied out for half a minute."""

MOST_EXPANDED_TERMS = 2_000
"""Terms of a form whose common number is sought: forms in books have a dozen, an arc tangent taken twenty times of
itself a million."""

SHORTER_ALONG_AXES = 0.7
"""Reactions are added up along unit vectors that turn if that takes at most so much of the operations: below this the
vector of a coin or of a disc is the form of the textbooks, above it one list has just been replaced by another."""

SHORTEST_BY_VELOCITY = 7
"""A velocity of fewer operations is written out and not as a multiple of another: m v/((M + m) l) has four."""
