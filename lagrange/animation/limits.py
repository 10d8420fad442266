"""Limits of figures that move."""

MOST_COORDINATES = 16
"""Sliders that a reader can find their way in."""
MOST_OPERATIONS = 20_000
"""Different parts of all expressions together: the page is written in a moment, and a step takes milliseconds."""
LONGEST_PROGRAM = 400_000
"""Characters of JavaScript, so that a page stays below a megabyte. The pages of all shipped problems have less than
300,000 characters, the derivation included."""
MOST_ROWS = 600
"""Rows of a computed motion on a page, which interpolates between them."""
GROUND_REACH = 3.5
"""Half the length of a piece of ground, in centimetres: what moves on it stays in the figure."""
