"""The work allowed for one problem, in units of `core.effort`."""

UNITS_OF_SOLVING = 800_000
"""About twenty seconds; 32 links of a chain take most of it, a shipped problem less than a twentieth."""
LONGEST_IN_DIRECTIONS = 120
"""The most operations of a vector that is written by unit vectors with names."""
LONGEST_SPOT_FORMULA = 30
"""The most operations of an acceleration that is written before its value."""
LONGEST_SOLVED = 4 * LONGEST_SPOT_FORMULA
"""The most operations of an equation that is solved for it: one of 3,000 takes more than ten seconds."""
MOST_STATED_NAMES = 12
"""The most quantities with names that are looked for in stated equations: each is compared with every sum in them."""
