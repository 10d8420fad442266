"""Limits of figures that move."""

MOST_COORDINATES = 16
"""Sliders that a page can hold; the largest of the shipped systems has ten coordinates."""
MOST_OPERATIONS = 60_000
"""Of all expressions together. A page must be written in a moment, and a step in the browser is to take less than a
millisecond; the longest of the shipped systems has a tenth."""
LONGEST_PROGRAM = 400_000
"""Characters of JavaScript: a page stays below a megabyte."""
