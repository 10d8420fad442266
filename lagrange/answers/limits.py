"""Bounds and numbers of random states in checking answers, each with its evidence.

"Shipped" refers to the 129 problems in `problems/`, 74 of them with equations of motion. Outside these bounds nothing
is guessed: an answer is refused with a message, a diagnosis is left out, or a condition is given without its factor.
"""

# What an answer may be

MAX_EQUATIONS = 12
"""Equations in an answer. The longest shipped answer has 6 (six degrees of freedom, problems/motion/aircraft.yaml)."""

MAX_LINES = 80
"""Equations in a whole solution, with its definitions, values and energies: some three pages by hand."""

MAX_SIGNS = 1_000
MAX_MARKS = 50_000
"""Signs of equality, and of brackets, commas and commands, in a file: a record is made of each. A thesis with its
appendix has as many; a file of 262,000 equations took 46 s and 2.2 GB before it was refused."""

MAX_FILE_LINES = 20_000
"""Lines of a file, of which the places are kept: 300 pages. A megabyte of empty lines took 3 s and 130 MB."""

MAX_ALTERNATIVES = 32
"""Alternatives in an answer about equilibria: five equations with two solutions each. The shipped maximum is 4."""

# Random states

STATES = 2
"""States at which a diagnosis or a recognised form is tested: the first to find it, the second to confirm it.

A wrong one passes the second with a probability of degree/p ≈ 10^-24 (Schwartz 1980), as p ≈ 2^89.
"""

BRANCHING_STATES = 12
"""States in a prime field if there are roots or absolute values, whose branches are random at each state (7 of 74).

A change that is right on one branch only passes with probability 2^-12. With six states and two real ones, a verdict
was wrong in one run of a hundred: |φ'| in place of φ' passed.
"""

REAL_STATES = 4
"""Real states in addition, at which the branches have their true signs."""

# The search for one change that makes an equation right

MAX_TERMS = 60
"""Terms of an equation, multiplied out. The largest shipped equation has 16 (problems/motion/aircraft.yaml)."""

MAX_CLEARED_SIZE = 400
"""Nodes of an equation that is cleared of denominators. Shipped answers with sums in denominators have up to 103."""

MAX_NUMERATOR = 2000
"""Numerator and denominator of a wrong factor, so that 9.81 = 981/100 and 0.333 are included.

There are 5·10^6 such fractions among 6·10^26 residues: none occurs by chance.
"""

MAX_FACTOR_PARAMETERS = 9
MAX_FACTOR_COORDINATES = 4
MAX_FACTOR_ANGLES = 4
"""Symbols of which wrong factors are composed: 127 shipped problems have no more parameters, 110 no more coordinates.

The number of factors grows with the square; in shipped problems there are up to 1,500.
"""

MAX_SCALE_OPERATIONS = 12
"""Operations in the ratio of a term of the answer to a derived one, as a scale: m l² sin θ cos θ has 6."""

# Recognising equations that are not equations of motion

MAX_POWER = 20
"""Highest recognised power of a right equation: two evaluations each; the tests have cubes."""

MAX_ANGLES = 6
"""Coordinates beside a radius, of which one or two are turned: in 72 ways, each with an exact test of all positions."""

# Where an answer is valid

MAX_EXPANDED_TERMS = 24
"""Terms, multiplied out, of a factor that is brought to textbook form. With 81 terms that takes eight times as long as
with 16 (products of sums of cosines)."""

MAX_NAMED_SIZE = 60
"""Nodes of a factor that is named in a remark: about a line of text. A longer one is mentioned without its formula."""

MAX_DETERMINANT = 4
"""Rows of a determinant that is expanded symbolically: 4! = 24 products, or 5! = 120 for the derived equations."""

MAX_KEPT_FACTORS = 500
"""Expressions whose factors are kept for the answers after this one; an answer brings some ten of its own."""

MAX_CONDITIONS = 8
"""Factors of one equation that are tested for real zeros: each may take a run of Newton's iteration."""

UNITS_OF_CHECKING = 200_000
"""Of work (`core.effort`) for one answer, with its diagnosis."""

UNITS_OF_EXPLAINING = 8_000
"""Of work for what a wrong position of equilibrium is instead, about a second: each model is solved and compared."""

MOST_MEANINGS = 100
"""Readings of the names of reactions in one answer: three names of four meanings each have 63 besides the usual one."""

# Text

WIDEST = 100
"""Characters in a line of a verdict: longer lines are hard to read."""

MAX_SHOWN_CHARACTERS = 1000
"""Characters of an equation that are shown. An answer may have 2,000; the longest shipped equation has 177."""

# Decimals

MAX_DECIMALS = 12
"""Decimals in one equation whose rounding is followed: twice as many as an equation in numbers usually has."""

DECIMAL_STATES = 8
"""States at which an equation with decimals must hold, apart from the one that confirms it: one row each at least, so
that with as many decimals no more are left open than the form of the equation leaves."""

NEWTON_STEPS_OF_DECIMALS = 40
"""Steps to eighty digits. Each doubles the digits, and decimals that stand outside functions need one; the first ones
gain less where two frequencies are close at a random state (up to 20 steps in 200 runs)."""

MAX_PROJECTIONS = 60
"""Projections in turn on the intervals and on the solutions, where the decimals are not determined."""

# Models of a wrong answer

MAX_MODEL_WORK = 20_000
"""Numbers in the rows of changed equations that are compared with one answer. Two equations of two coordinates have 6,
so that all variations of most problems fit; a rigid body with rolling constraints has 40, and 500 are tried."""

MAX_FIRST_MISTAKES = 40
"""Likely mistakes of which two are combined: a problem with four bodies has some sixty."""

MAX_OF_ONE_KIND = 6
"""Of these, those of one kind: otherwise moments of inertia, of which there are 26 a body, would leave no room."""

MAX_PAIR_WORK = 1_500
"""Numbers in the rows of equations changed by two mistakes: 250 pairs for two coordinates, each made once a problem."""

MAX_BESIDE = 150
"""Terms times squared parameters of an equation in which one change is sought although a model explains it: a
pendulum's two terms with three parameters. The number of possible factors grows with that square, and the search takes
the longest."""

MAX_RESTING_MODELS = 60
"""Changed problems that are tried for wrong positions of equilibrium."""

MAX_LETTER_VARIATIONS = 24
"""Other meanings of letters that are tried for a wrong equilibrium, reaction or frequency: each is compared in full."""

MAX_SIDE_FACTORS = 8
"""Factors that are tried on a side of a wrong condition of equilibrium, each compared in full."""

# Conditions that are tried at random numbers

BESIDE_LIMIT = 1e-3
BESIDE_ROUNDED_LIMIT = 0.06
"""How far beside the limit of a stated condition of stability it is tried, and beside one that is written as a decimal:
two digits are rounded by 5 % at most. A limit that is wrong by more is found at every state."""
