"""Limits of kinematics: beyond them an expression is left as it is, a place not looked for; nothing becomes wrong.

Sizes are operations (`core.expression_size`), nodes or terms. A number in brackets is the largest value met in the
129 shipped problems, measured when the limits were gathered; "beyond" is how often a limit was exceeded there.
"""

# Solving constraints for coordinates (`coordinates`): nodes of an equation that is solved [23], and terms that it or
# the radicand of its root may have when multiplied out [10]. Roots of roots grow without end, and SymPy's time to
# differentiate and expand them with it (commit 6be2d5c).
LONGEST_SOLVED = 3000
MOST_SOLVED_TERMS = 1000
# Nodes of an equation that is multiplied out to see whether it is a polynomial [23]; a longer one has to be a
# polynomial as it is.
LONGEST_EXPANDED = 60

# Solved displacements (`displacements`): terms, when multiplied out, of an expression that is still cancelled or
# factored [192, in the bicycle]; (x + y + z + w)^20 has 1771.
MOST_CANCELLED_TERMS = 200
# Symbols of a pivot or quotient that is factored [6]; the time of `sp.factor` grows steeply with their number.
MOST_FACTORED_SYMBOLS = 8
# Operations of a quotient that is factored [20; 2 beyond, up to 26]. Beyond, factors rarely make it shorter.
LONGEST_FACTORED = 20
# Eliminations tried for the displacement of moving constraints that is simplest to write: one for each coordinate that
# the moving constraints contain.
MOST_DRIFTS = 8

# Places where the rank drops (`degeneracies`): rows [4] and operations [16] of a minor that is worked out, and
# coefficients of one form that must vanish together [3].
MOST_MINOR_ROWS = 4
LONGEST_MINOR = 80
MOST_CONDITIONS = 4
# Choices of a factor from each of those expressions: four products of two factors have 16, the axes of x y z have 8.
MOST_CASES = 16

# Terms of a squared distance that is factored, to see whether it is a square [3].
MOST_SQUARE_TERMS = 20

# Points at which the rank of the second fundamental form has to agree (`constraints.bending_rank`). A single point of
# the field may lie where the rank drops by accident; if the points disagree, the question is undecided.
CURVATURE_POINTS = 3

# Operations of all entries together on the way to the displacements solved for. Beyond, as for a bicycle, it is only
# found which are independent.
LONGEST_DISPLACEMENTS = 3000

# The first coordinates of which each pair is tried as turning with a moving constraint [3].
MOST_TURNED = 6

LONGEST_SHOWN = 25
"""The most operations of what a constraint becomes that an error shows."""

MOST_MEASURED_POINTS = 6
"""The most points whose differences are looked at for what an angle measures: 15 pairs."""
