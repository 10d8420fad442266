"""What a page shows of a result that is too long to be read. Nothing here decides what is true; JSON has all of it.

Sizes are operations (`core.expression_size`): on eight shipped pages one takes 3.3 characters, so that a line of 80
columns has room for some 20. They were chosen by reading pages; changing one changes golden files.
"""

LONGEST_SPOT = 20
"""The most numbers of a spot value that a reader may want to type."""

SHOWN_LOSSES = 4
"""Places where constraints are dependent that a page names; the others are counted."""

SHOWN_PAIRS = 3
"""Pairs of partial derivatives that a page compares; the others need --detail full."""

LONGEST_DISPLACEMENT = 40
"""Operations of a solved displacement that are still shown without being asked for."""

LONGEST_INTEGRAL = 150
"""Operations of an integral that is still shown without being asked for."""

MOST_MULTIPLES = 6
"""The most multiples of equations of motion that are named where they add up to the rate of an integral."""

LONGEST_INTERMEDIATE = 60
"""Operations of an intermediate line that is still shown without being asked for."""

UNITS_OF_A_PICTURE = 100_000
"""Work (`core.effort`) for one picture: an eighth of that of a solve."""

LONGEST_REACTIONS = 250
"""The most operations of all reactions in terms of accelerations that a page shows without --detail full."""

LONGEST_ACCELERATIONS = 250
"""The most operations of accelerations that are shown."""

MOST_LAWS = 2
"""The most bodies whose laws are written in vectors in a sentence."""

LONGEST_TITLE = 72
"""Of a question, in letters: one line of the page, its number included."""
LONGEST_IN_TEXT = 8
"""The most operations of an expression in running text."""

MOST_SHAPES = 3
"""The most coordinates for which amplitudes and phases stand in the table of damped modes."""

LONGEST_BESIDE_CHOICE = 15
"""The most operations of equations of motion in the file's coordinates that are shown beside those of a choice."""

LONGEST_BEFORE = 25
"""The most operations of a reaction in the file's coordinates that is shown beside that in the chosen ones."""

FEWEST_TOGETHER = 2
"""The fewest bodies that are introduced together."""

SHORTEST_NAMED = 12
"""The fewest operations of a denominator that gets a letter."""

LONGEST_PIVOT = 8
"""The most operations of what must not vanish so that displacements can be chosen freely: x₁ − x₂."""

LONGEST_IN_LINE = 12
"""The most operations of a product of differentials that is written in its sentence."""

MOST_LINES_TWICE = 1
"""The most stated equations that are printed at the head and again at the end."""

LONGEST_STEP = 60
"""The most operations of an intermediate expression in the answer to a question."""

LONGEST_SOLUTION = 40
"""The most operations of the dependent displacements together that are written by the free ones."""

LONGEST_FORMS = 12
"""The most operations of the conditions on virtual displacements in components; longer ones of rods are in vectors."""

SHORT_WORK = 24
"""The most operations of the virtual work of reactions that is written out where the forms have just been shown."""

MOST_MULTIPLIERS = 2
"""The most equations of motion whose multiples are named where they add up to the rate of a quantity."""

LONGEST_CONSERVED_LINE = 24
"""The most operations of a conserved quantity that is written in its sentence."""

LONGEST_SUM = 60
"""The most operations of the principle in independent displacements that is shown before the equations themselves."""

LONGEST_MULTIPLIER = 60
"""The most operations of a multiplier that is shown."""

LONGEST_RESULT = 120
"""The most operations of the equations in the result at the head."""

MOST_RESULTS = 8
"""The most equations in the result at the head."""

MOST_LINES_OF_CASES = 5
"""Conditions of rest at the head of a page, where there are several cases of which one takes more than a line."""

LONGEST_ANSWER = 30
"""The most operations of one frequency, condition or reaction there."""

LONGEST_ASKED = 45
"""The most operations of the answer to a question there: what is asked may take two lines."""

LONGEST_ANSWER_CONDITIONS = 16
"""The most operations of the conditions beside an answer to a question."""

LONGEST_FREQUENCY = 30
"""The most operations of the square of a frequency, or of a line about a steady motion."""

LONGEST_WORDS = 12
"""The most operations of the conditions of stability beside a solution."""

SHORT_SIDE = 6
"""The most operations of a side of an equation beside which another has room."""

MOST_SYMBOLS = 10
"""The most symbols that a sentence introduces; more are easier to find in a table."""

MOST_FORMULAS = 50
"""Of formulas in one text that are set; a description has two or three."""

LEAST_ROOM = 6
MOST_ROOM = 18
"""Lines of handwriting; a page of A4 has about 30."""

LINES_OF_EQUATION = 2
"""Lines of handwriting that one displayed equation takes."""

LONGEST_REACTION = 60
"""The most operations of a reaction that is shown by default where there are other coordinates."""

UNITS_OF_EXPLAINING = 250_000
"""Work (`core.effort`) for all steps, about a third of what solving may take: a step may take half of what is left.
Pictures have their own."""

UNITS_OF_A_STEP = 5_000
"""Of it, at least, for each step: half of what all steps of a shipped page take."""

RESULT_DIGITS = 4
"""The significant digits of results in numbers, where no other number is asked for."""

LONGEST_CONSTRAINT = 30
"""Operations of a constraint that is printed."""

LARGE_SYSTEM_DIGITS = 6
"""Digits of a number of a large system on its page; JSON has all that are certain."""

LONGEST_CONDITIONS = 30
"""The most operations of conditions of stability that are written out where an equation before has the same."""

LONGEST_MODE = 15
"""The most operations of a mode that is shown beside its frequency."""

LONGEST_CHARACTERISTIC = 120
"""The most operations of conditions, or of a characteristic equation, that are shown."""

LONGEST_MINORS = 30
"""The most operations of the minors of a matrix that are shown."""

DIGITS_AS_STATED = 12
"""Digits of a number that a file gives with its unit."""

SHORTER_AS_STATED = 0.8
"""A reaction is printed as the file's answer has it if that takes at most four fifths of the operations."""

FEWEST_WITHOUT_SUMS = 4
"""The reactions on each of so many bodies are not added up before the laws, which have them again."""

DECIMALS = 10**6
"""A rational initial value is printed as a decimal if that has at most six places, 0.7: more are no longer read."""

MOST_PARTS_OF_PI = 12
"""An angle that is a multiple of π/12 is printed so: 15° and its multiples."""

SHORTEST_OF_MANY = 9
"""The fewest operations of a denominator that gets a letter where three equations or more share it."""

MOST_NAMED = 3
"""The most bodies that are named where reactions do work on each of them; then they are counted."""

LONGER_ACCELERATIONS = 3
"""Constant accelerations are the result at the head if they are at most so many times as long as the equations with
constraints from which they follow."""

LONGEST_ACCELERATION = 20
"""The most operations of a constant acceleration at the head; a longer one is left to the equations that it solves."""

LONGEST_RADICAND = 10
"""The most operations of a radicand in equations of motion at the head, where small oscillations are asked for."""

LONGEST_INTEGRATED_RELATION = 10
"""The most operations of a finite relation, integrated at sight, that is written in its sentence."""

LONGEST_SOLVED_RELATION = 8
"""The most operations of a relation between old and chosen coordinates that is written in its sentence."""

LONGEST_PRINCIPLE = 45
"""The most operations of the principle that is written out although its brackets are the equations that follow."""

LONGEST_PRINCIPLE_OF_BODIES = 30
"""The same for bodies that turn: their principle in vectors takes two lines before it."""

SHORTER_IN_ACCELERATIONS = 3
"""Forces are written in terms of constant accelerations if that makes them so many times shorter."""

LONGEST_FREE_LAWS = 120
"""The most operations of the laws of motion that are written for all positions, where the coordinates are held."""

LONGEST_RESONANCE = 24
"""The most operations of the square of a frequency of resonance that is written out."""

LONGEST_PLAIN_FORCES = 30
"""The most operations of forces, in terms of accelerations, of which nothing is said but what they are."""

SHORTEST_REPEATED_LENGTH = 10
"""The fewest operations of the length of a spring that is a letter from its second appearance on."""

MOST_PLACES = 4
"""Equilibria of which all are named beside a frequency that they share; of more only the first."""
LONGER_SOLVED = 2
"""Equations solved for the accelerations may take so many times the operations of equations with exceptions."""

LONGEST_IN_A_SENTENCE = 10
"""The most operations of Newton's law along one reaction that is written in its sentence."""

LONGEST_VARIATION = 12
"""Operations of the variation δV of the potential energy, as far as the principle says in a sentence what it is. Of two
masses on springs it has 9.
"""

LONGEST_BESIDE_REST = 12
"""Operations of the motions of the other coordinates at the frequency at which one is at rest. One of a vibration
absorber has 6.
"""
