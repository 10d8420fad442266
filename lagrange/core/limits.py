"""Limits of the vocabulary: what is counted, remembered, printed."""

LARGEST_SIZE = 10**9
"""Sizes of expressions are counted up to a billion, so that those of nested powers stay numbers."""

MOST_REMEMBERED_COUNTS = 2048
"""Expressions whose operations are remembered: a page asks several times for each of its equations."""

MOST_IN_A_LINE = 4_000
"""Characters of a sentence: twice the longest equation of an answer, which a message may repeat."""

HIGHEST_POWER_OF_UNIT = 20
"""The highest power of a unit: no quantity has a higher one, and 1e9^9999 takes memory."""

STEPS_PER_UNIT = 10
"""Looks at the parts of a node for a unit of work: a walk takes half a microsecond for each."""

STEPS_PER_UNIT_OF_A_SEARCH = 150
"""Where signs are asked for most of the time: the searches of shipped problems take up to 110 steps a unit."""

STEPS_AT_ONCE = 2_500
"""Steps that are counted before they are taken from the allowance: a hundred units."""

UNITS_BETWEEN_LOOKS = 2_000
"""Units of work after which the memory in use is looked at, which takes 40 µs."""

MOST_BLOCKS = 4_000_000
"""Blocks of memory, about 80 bytes each."""

STEPS_OF_A_NUMBER = 8
"""Steps for each node of a number that is evaluated."""

STEPS_OF_A_QUESTION = 8
"""Steps for each assumption that is tried: is it real, is it positive?"""

BITS_PER_STEP = 256
"""Bits of a long number that count as one step: four words are multiplied in the time of a look."""
