"""The limits of numerical work: how many digits, how many boxes."""

from __future__ import annotations

WORKING_DIGITS = 30
"""Digits to which constants are evaluated; SymPy raises its working precision until they are correct."""

SPARE_DIGITS = 20
"""Digits beyond those printed, so that rounding them is not decided by an error."""

MOST_BOXES = 3_000
"""Boxes of one search for roots. One unknown takes 20 to 200, two take 200 to 2,000; a box takes about 0.2 ms."""

MOST_OPERATIONS = 400_000
"""Operations of the equations and their derivatives in all boxes of a search: 1 s."""

LARGEST_IN_NUMBERS = 2_000
"""Operations of an expression that is given in numbers: a longer one is not shown in full anyway."""

SMALLEST_BOX = 1e-9
"""Part of the width of the search at which a box that is neither excluded nor confirmed is given up."""

MOST_UNDECIDED = 20
"""Boxes given up after which a search with three unknowns and more ends."""

MOST_STEPS = 20
"""Steps of Newton's iteration from one start."""

MOST_DEGREES = 8
"""The highest degree of p whose roots are looked for."""

LARGEST_COEFFICIENT = 9
"""A larger number in front of a term may hide a quantity with a unit: 10 m for a weight."""

INFLATION = 0.05
CUT = 0.4871
"""What a box is widened by before Newton's test, relative to its width; where a box is cut, never in the middle, where
roots are."""

STARTS = (0.13, 0.37, 0.62, 0.88)
"""Where Newton's iteration starts, as parts of the width of the search."""
