"""Bounds and numbers of random states in checking answers, each with its evidence.

"Shipped" refers to the 129 problems in `problems/`, 74 of them with equations of motion. Outside these bounds nothing
is guessed: an answer is refused with a message, a diagnosis is omitted, or a condition is given without its factor.
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
was wrong in one run of a hundred: |φ'| instead of φ' passed.
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
MAX_FACTOR_LENGTHS = 3
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

MOST_OPERATIONS_LEFT = 20
"""Of what is left of an equation whose accelerations cancel, so that it can be said in a line."""

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

MOST_NUMERICAL_ROOTS = 4
"""Roots of a condition of equilibrium that a stated position in numbers is compared with."""

LETTERS_OF_STEM = 4
"""How many letters of a verb two of its forms have in common: `leaves`, `leave`."""

MOST_WORKING_FORCES = 8
"""Forces under names of its own in the working of an answer about rest."""
MOST_WAYS_TO_REST = 8
"""Sets of conditions of rest with `or` between them: three conditions with two cases each."""

MOST_LIMITS = 4
"""Limits of rest stated without a `max` or `min`: each is tried as an upper and as a lower one, 16 in all."""

MOST_FRICTION_SIGNS = 16
"""Combinations of directions in which the friction forces of an answer may be taken: four contacts."""

REST_SAMPLES = 400
"""Random states at which conditions of rest are compared with the derived ones. The limit of each has been compared
exactly; they decide whether one is missing or has the wrong sense. A difference in a share s of the states escapes
with the probability (1 - s)^400. Of the rough systems shipped with two conditions, the smallest share in which one
of them alone decides is 4.3 % (stacked-blocks): 2e-8. All states take 3 to 12 ms."""

FIRST_REST_SAMPLES = 20
"""States that may show soon that two conditions differ; what they do not show, the sign of their ratio decides."""

CLEAR_SLACK = 1e-6
"""A slack counts as positive or negative if it is larger, relative to its terms at random numbers of order one."""

BESIDE_REST = 1e-4
"""How far beside a limit the senses of two conditions are compared: the senses, not the limits, which are exact."""

MOST_FREQUENCIES = 4
"""Coordinates whose frequencies are compared with those of a mistake: determinants of numbers."""

RANDOM_ZERO_DIGITS = 20
RANDOM_DIGITS = 30
"""Digits in which values at random numbers are compared, and below which their differences are zero. Two different
expressions agree so far with a probability of about 1e-20; what cancels may cost ten digits."""

MOST_IN_RATIO = 9
"""Numerator and denominator of a wrong factor that is named: 9 takes in every moment of inertia of a table but 1/12."""

MOST_ASKED_TERMS = 8
"""Terms of a value in which one wrong term is sought."""

VANISHING_DIGITS = 40
"""A parameter that is taken to vanish is 10^-40: then what is left of its root is 10^-20."""

HIGHEST_FREQUENCY_EQUATION = 2
"""The degree in ω² of a frequency equation that is solved."""

MOST_IMPULSES = 4
"""So many names of impulses may each stand for the opposite one: 2^4 readings, each a comparison."""

ROUNDED_COEFFICIENT = 1e-9
"""What the derived numbers may differ by, relative to the largest coefficient."""

LONGEST_NUMBER_WITH_UNIT = 60
"""The most characters of a number with its unit: `-1.234567890123e-10 kg*m^2/s^2` has 30."""

EXACT_POSITION = 1e-12
"""How far an exact number may be from a position in closed form, which is evaluated in floating point: some thousands
of rounding errors."""

STABILITY_SAMPLES = 60
ENOUGH_PLACES = 30
"""Random states, and places with a clear sign that settle a claim of stability beside a position. Around each state the
claim is tried on both sides of its limit (BESIDE_LIMIT). With 10 places, none of them beside the limit, a condition
wrong by a factor of 2 passed in 9 of 20 runs; with these 30 one wrong by 10 % passed in none of 12. A place takes 2
ms."""

CLEAR_STABILITY = 1e-7
"""Smaller minors, residuals and slacks have no sign, in numbers of order one with 15 digits: a state with one does not
count."""

MOST_AT_RELEASE = 12
"""Accelerations and reactions at an initial state that an answer may be solved for: they are unknowns of one linear
system."""

MOST_IN_CHAIN = 6
"""Sides of a chain of values v = a = b = c; with more it is working, and is read elsewhere."""

MOST_LINEARIZED = 4
"""Coordinates of linear equations that an answer is compared with, as for frequencies."""

SENTENCE_SAMPLES = 20
"""Random states at which a sentence on stability without a position must be true, each with those on both sides of its
limit. With 80 states and none beside the limit, one wrong by 10 % passed in 30 % of the runs, one wrong by 2 % in 80
%; with these, none of 12 that was wrong by 10 % or more. They take 0.1 s for a right sentence, as the 80 did."""

LONGEST_RUN_OF_LETTERS = 3
"""Letters of a run that may be a product of names."""

LONGEST_COMPARED_REACTION = 100
"""Of a reaction at rest with which a wrong one is compared term by term."""

LONGEST_BALANCE = 100
"""Operations of a potential energy or a moment with which a wrong condition of equilibrium is compared."""

MOST_TAKEN_FORCES = 4
"""Forces of constraints each of which may be taken as at rest or left out: 16 systems of numbers."""

MOST_MULTIPLIED = 6
"""Parameters of which one may have been multiplied by another: each pair is a derived system."""

LONGEST_FACTORED = 60
"""Operations of an equation at rest that is factored, to find factors in which there are only parameters."""

LONGEST_SUM_OF_LENGTHS = 200
"""Operations of a velocity or force in which R − r is sought as a factor; shipped ones have up to 60."""

LONGEST_TERM_OF_LAGRANGIAN = 400
"""Operations of what a term of a Lagrangian contributes, where a parameter is taken as infinite."""

LONGEST_REACTION_OF_ONE_BODY = 500
"""Of a reaction as solved from the equations of one body by itself, in the coordinates of a choice, before any is
simplified: 200 for the lower rod of a double pendulum."""

MOST_AMPLITUDES = 4
AMPLITUDE_DRAWS = 3
"""Coordinates of a steady state that an answer is compared with, and random parameters at which it must agree, to
twenty digits at each: one would do against chance, three guard against a parameter that has no influence at one of
them."""

SECANT_STEPS = 60
"""Steps of the secant rule. It gains more than half of the digits again in each step near a root; without one it ends
after these."""

UNITS_OF_OTHER_BODIES = 200_000
"""Work (`core.effort`) for solving the problem with letters for the moments of inertia: a quarter of that of a
solve."""

MOST_OTHER_BODIES = 2
"""With more bodies whose moments of inertia may have been mistaken, none is looked for."""

MOST_CONDITION_TERMS = 8
"""Terms of a condition, multiplied out, in which one wrong term is sought."""

LIMIT_SAMPLES = 3
CLOSE_LIMIT = 1e-9
"""Random points at which a condition seems to have the limit of a mistake, before that is decided exactly: they only
save time, and whatever passes them by accident is refused by `is_zero`. They decide alone which sense an inequality
has: it is that of the mistake if the slacks have the same sign at all three, and one of the other sense has at
none."""

UNITS_OF_OTHER_CONTACTS = 200_000
"""Work for solving the problem with a coefficient for each contact, as for other bodies."""

MOST_OTHER_CONTACTS = 4
"""With more rough contacts no mistake with their coefficients is looked for."""

MOST_STRUCK = 6
"""Coordinates of an impact for which wrong equations are solved, in numbers."""

MOST_RESTING_ROWS = 2
MOST_RESTING_COORDINATES = 5
"""Constraints and coordinates of a system at rest whose equilibrium is sought with a mistake in it."""

SAMPLES_OF_A_SIDE = 8
"""Random acute values at which a stated force is compared with a root: it has the sign of the root at one of them."""

MOST_IN_SERIES = 4
"""Springs of a system with one coordinate of which every group is tried as joined end to end."""

MOST_RESTING_FORCES = 8
"""Forces of a system at rest whose contributions to a wrong answer are compared one by one."""

SHORTEST_RATIO = 6
"""Operations of a ratio of contributions at rest that may contain a length which changes: l/x, l/(x - r cos(theta))."""

RATIO_OPERATIONS = 12
"""Operations in a ratio of what a force contributes to what it should: a longer one is no single mistake."""

MOST_RESTING_FACTORS = 4
"""Factors of a plain value: one with more is no short mistake."""

TINY_RESIDUAL = 1e-62
ROUNDING_EDGE = 1 + 1e-9
FAR_SHIFT = 100
SLOW_PROGRESS = 0.9
"""How rounded decimals are shifted until an equation holds, in 80 digits: a residual that is zero, the most units of
the last digit (1 and a billionth), a shift at which the search is given up, and the least progress of a step."""

NEGLIGIBLE_PIVOT = 1e-35
"""A smaller pivot of that search is none: half of the digits."""

LONGEST_IN_WORDS = 20_000
"""Characters of a text that are searched."""

MOST_LISTED = 8
"""Values in one list `x = 1, 2, 3`: four solutions with two signs."""

LONGEST_NEW_COORDINATE = 60
"""Operations of the other side of the definition of a coordinate."""

MOST_MACROS = 60
LONGEST_MACRO = 300
"""Definitions of macros, and characters of one."""

MOST_MATRIX_ROWS = 6
"""Rows of a column."""

MOST_OPERATORS = 8
"""Operators that are applied to one another."""

MOST_STATEMENTS = 80
MOST_PROGRAM_STATES = 12
"""Statements of a program with the equations of motion, and components of its state: six degrees of freedom."""

MOST_METHOD_CALLS = 12
"""Calls of methods in one equation."""

MOST_IN_A_RATIO = 4
"""Members of a ratio, arguments of an extreme."""

LONGEST_REPEATED = 400
"""Characters of an argument that is written several times."""

LONGEST_NUMBERING = 60
"""Characters at the end of an equation that are searched for its number."""

SHORTEST_WORD = 4
"""Letters of a word of prose: three letters may be a product."""

MOST_SIDE_DEFINITIONS = 5
"""Abbreviations in a statement that are substituted in turn."""

LONGEST_LAW = 60
"""Characters of a general law, `\\sum F = m a`, with names that the problem does not declare."""

LONGEST_WRITTEN_NAME = 60
"""Characters of a side that is searched for a single name: `\\cos\\left(\\theta_{\\text{max}}\\right)` has 33."""

ROUNDING_DIGITS = 9
"""A rounded answer may be off by 1e-9 beyond half a unit of its last digit: exact values are compared as fractions."""

LONGEST_SQUARE = 40
"""Operations of the square of a frequency that is compared term by term with a wrong one."""

MOST_CHANGES = 40
"""Changes of one wrong constraint that are tried: each is compared at two random states, which takes about 1 ms. Three
terms and two coordinates make seven."""

MOST_SENSES = 4
"""Velocities for each sense of which a wrong equation is compared: a friction law has one for each rough contact."""

LONGEST_CONNECTIVE = 100
"""Characters before the end of a text in which the words that join an equation to its condition are sought; they are
removed one at a time, so that the search does not go back to the beginning for each."""

MOST_PIECEWISE = 8
"""Calls of `Piecewise` or `If` in one text that are written out as cases at once."""

ROUNDING_OF_CASES = 0.02
"""How far a number for a special case, an angle in degrees, may be from the right one: 33° for 32.6°."""

LONGEST_BEFORE_CASE = 60
"""Characters before an equation in which a word such as "for" makes it a special case: two or three words have
fewer."""

MOST_LETTERS_IN_A_VALUE = 9
"""Letters of a value of which one is tried for another, term by term: 72 pairs a term, a few milliseconds."""

MOST_NODES_OF_A_VALUE = 200
"""Nodes of a claim and a right value of which one is changed at a time: larger ones take over 50 ms in all."""

CLOSE_IN_FLOATS = 1e-9
"""Relative difference of two values in double precision that are taken to be equal, before an exact test: a value of
200 nodes loses six digits of sixteen at most."""

SAME_ANGLE = 1e-9
"""How far a stated angle may be from the principal value of its tangent, sine or cosine, in floating point."""

MOST_SHEETS = 16
"""Choices of one factor from each unsolved equation of an answer; one surface is sampled for each."""

HIGHEST_EXPANSION = 6
"""The lowest power that an expansion may neglect, `+ O(theta^6)`, for its terms to be compared."""

MOST_WRITTEN_OUT = 24
"""Fractions, roots and lists of cases of Typst and LibreOffice that are written out in one text."""

LONGEST_CLAIM = 600
"""Characters of a sentence in which a claim is looked for: longer ones are no sentences."""

MOST_CLAIMS = 120
"""Sentences of one answer in which claims are looked for."""

CLAIM_SAMPLES = 12
"""Random values of the parameters at which a claim is tried, each with those on both sides of its limit."""

DECIDED_CLAIMS = 24
"""Values with a clear outcome that settle a claim; fewer than FEWEST_DECIDED leave it open."""
FEWEST_DECIDED = 4

STARTS_TO_REST = 10
"""Random places from which a state of rest is looked for."""

LONGEST_LINEARIZED = 400
"""Operations in equations of motion that are linearized in numbers: evaluating longer ones takes over half a second."""
MOST_LINEARIZED = 4
"""Coordinates of such a system."""

GROWING = 1e-3
LASTING = 1e-6
"""Real parts of exponents, as parts of the largest, above which a motion grows, and below which it does not: in double
precision a double zero comes out as 1e-8."""

SAME_FREQUENCY = 1e-6
SAME_ROUNDED_FREQUENCY = 0.02
"""Relative differences of frequencies that are taken to be equal; of those that are given as rounded numbers."""

STATES_OF_MOTION = 80
"""Random states of motion in which an inequality for accelerations is tried."""

MOST_SOLVED = 3
"""Accelerations that are solved for by determinants, to try an inequality for them."""
