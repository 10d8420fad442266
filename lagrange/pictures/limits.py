"""Sizes and counts of pictures, each with the reason for its value. Lengths are centimetres on the page."""

# The page

WIDTH, HEIGHT = 6.2, 4.6
"""Room for the points of a system: with axes, labels and gravity a picture stays below 10 cm, two thirds of a line of
text on A4."""
LONGEST_LINE = 7.0
"""Room for a system on one line, which needs no room across."""
LARGEST_SCALE = 4.0
"""Centimetres for the unit of length: without it, a system whose points are close together would be blown up."""
TEXT_WIDTH = 14.5
"""Room for free bodies in a row: the 16 cm of a line of text on A4, less what labels may stick out."""
MOST_POINTS = 12
"""Particles and mass centres of a picture: the largest of the 129 shipped systems has five, and more than twice
as many cannot be distinguished on 6 cm."""
MOST_BODIES = 6
"""Free bodies drawn: two rows of about three. The largest of the 129 shipped systems has five."""

# Labels

LONGEST_ROD_LABEL = 12
"""Operations of a length that is written beside its rod; a longer expression would be wider than the rod."""
LONGEST_FORCE_LABEL = 4
"""Operations of a force that is written at its arrow (k (x - l), m g sin α); otherwise the arrow has the name of the
force."""

# The search for a position

TRIALS = 48
"""Positions tried. Of eleven shipped systems the best one was among the first 37; one system (two planes) allowed only
15 of 48. All 48 take 0.13 s at most."""
LEAST_GAP = 0.13
"""Least distance of two different points, as a part of the size of the system: at 6 cm there is just room for a label
between them."""
MOST_UNEQUAL = 6.0
"""How often the least length of a problem with values goes into the greatest, on the page: a sixth of the room for a
system is a centimetre."""
LARGEST_VALUE = 1e6
"""Values that can be drawn; a larger one comes from a pole (tan θ near π/2)."""
CURVE_STEP = 0.07
"""Length of the pieces of a curve: shorter than two points of type, so that it looks smooth."""
MOST_CURVE_STEPS = 900
"""Pieces of one half of a curve, 63 cm: twice the way around the largest frame, so that a longer
curve would wind inside it."""

CURVE_STEPS = 64
SURFACE_FACES = 14
"""Pieces of a curve, and of a surface in each direction."""
FACES_OF_TURN = 36
"""Faces of a surface all around an axis: at 10 degrees its rim looks round."""
PIECES_OF_PROFILE, PIECES_OF_TURN = 10, 24
"""Pieces of a surface of coordinates along a distance, and of a turn: at 15 degrees its rim looks round."""
BEYOND_PARTICLE = 1.35
"""How far such a surface goes on beyond its particle, as a part of its distance: enough to be inside it."""
NEARLY_FLAT = 0.5
"""Least difference of brightness for which a surface is shaded. The generic surface has 0.33, a bowl 0.97."""

SAME_PLACE = 1e-7
"""How far numbers of two places may differ: the constraints hold to 1e-11; a motion of another kind differs by far
more."""

SAME_SHAPE = 1e-6
"""The same for radii: looser than for positions, as errors grow in the quotient by R²."""

SAME_ON_PAGE = 1e-6
"""Centimetres by which two places on the page that are one may differ: a micrometre is invisible, and the constraints
hold to 1e-11."""

LEAST_SLOPE, STEEPEST_SLOPE = 0.07, 1.4
"""The angles of planes that are drawn at their foot, 4 to 80 degrees: a flatter plane has no room for an arc, and a
steeper one is a wall."""
SLOPE_ARC = 0.85
"""Radius of that arc, in centimetres: there the letter is clear of the hatching down to 15 degrees."""

# Letters of lengths

VARIATION = 0.17
"""By what part of themselves the values of parameters are changed to see whether a length changes with them: enough
that no two lengths stay equal, and little enough that the constraints can still be satisfied."""
MOST_PLACES = 40
"""Places between which a length is sought: 780 pairs take a few milliseconds."""
MOST_OPTIONS = 16
"""Places tried for a letter, best first; a letter for which none of them has room is left out."""
DIMENSION_ROWS = (0.35, 0.55, 0.8, 1.1)
"""Distances of a dimension line from what it measures, in centimetres: room for a letter in between, and for others."""
