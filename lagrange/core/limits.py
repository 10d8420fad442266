"""Limits of the vocabulary: what is counted, remembered, printed."""

LARGEST_SIZE = 10**9
"""Sizes of expressions are counted up to a billion, so that those of nested powers stay numbers."""

MOST_REMEMBERED_COUNTS = 2048
"""Expressions whose operations are remembered: a page asks several times for each of its equations."""

MOST_IN_A_LINE = 4_000
"""Characters of a sentence: twice the longest equation of an answer, which a message may repeat."""

HIGHEST_POWER_OF_UNIT = 20
"""Of a unit: no quantity has a higher one, and 1e9^9999 takes memory."""
