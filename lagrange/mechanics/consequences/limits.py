"""What is not looked for in equations that are too long: each consequence has to be worth a line of a page."""

LONGEST_FOLLOWED = 200
"""The most operations of all equations of motion together of which it is asked whether something follows from them."""

LONGEST_CONSEQUENCE = 30
"""The most operations of a consequence that is worth showing."""

LONGEST_RATE = 24
"""The most operations of an equation in quasi-velocities whose motion in the limit is looked for."""
