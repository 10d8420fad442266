"""Widths and sizes at which the renderers change the layout, each with the reason for its value.

Cells are those of a terminal. Ems are estimates, for Computer Modern in TeX (`tex_layout.ems`) and for a mathematical
font in a browser (`mathml.width`).
"""

# What is shown

LARGEST_STEP = 2000
"""Operations of the equations of one step that are printed whole: the largest step of a chain of eight links has half
as many."""
BEGINNING = 500
"""Operations that are printed of a larger step: the first equation of a chain of sixteen links fits."""
SHORTEST_RUN = 4
"""References that become a range: "(3), (4) and (5)" is as easy to read as "(3) to (5)", and says more."""

# Terminal

WIDEST_PAGE = 100
"""Cells of a line. A book has 45 to 75 characters a line (Bringhurst, Elements of Typographic Style, 2.1.2); equations
and tables need more."""
NARROWEST_BOX = 24
"""Cells in which a box is drawn: its frame and an equation number take 14 of them."""
ALIGNED_LEFT_SIDE = 12
"""Cells of the widest left side at which relations are aligned: names and derivatives (∂L/∂θ̇) have fewer, and a longer
one would push the other equations to the right for nothing."""
UNBROKEN_FORMULA = 28
"""Cells of a formula in a paragraph that is never broken: a third of a line of 80."""
ALONE = 8
"""Cells of a word that does not stand alone on the last line of a paragraph: "work:", "vanish."."""
SHORT_SIDE = 8
"""Cells of a side of a formula that is not parted from the next one: "y", "= const"."""

# LaTeX and Markdown

LATEX_LINE = 36.0
"""Ems of an equation beside its number. A4 with margins of 25 mm has 160 mm, which are 41 em at 11 pt; the number, the
space before it and the errors of the estimate take the rest."""
TALL_BOX = 15
"""Rows of a box, which cannot be broken between pages: with fractions about half of the 247 mm of an A4 page."""
MARKDOWN_LINE = 38.0
"""Ems of an equation and its number: the column of text on GitHub on a desk."""
TEX_LEFT_SIDE = 8.0
"""Ems of the widest left side at which the rows of an equation are aligned: a quarter of a line."""

# Web pages

PHONE_PIECE = 11.0
"""Ems of a piece of a formula: what a phone of 360 pixels shows beside the number. `make sweep` opens every shipped
page at this width, and nothing may stick out."""
PHONE_LEFT_SIDE = 2.8
"""Ems of the widest left side at which relations are aligned on a phone: a quarter of a piece."""
DESK_ROW = 28.0
"""Ems of an equation, or of matrices, whose fractions and brackets keep their full size: a column of 46 rem has about
31 beside indentation and number."""
LONG_DISPLAY = 12
"""Equations of a display that a printer may break between pages; a shorter one stays whole on less than half a page."""

JSON_DIGITS = 10
"""Significant digits of the numbers in an expression."""

STEPS_OF_A_SLIDER = 400
"""Steps of a slider from end to end: about one a pixel."""

SHORT_BRACKET = 4.0
"""Ems of a bracket that no line of running text may end within: with 7 lines of two shipped pages became too long."""

SHORT_RIGHT_SIDE = 2.0
"""Ems of a right side, as in = 0, that does not begin a line of running text."""

LONG_FORMULA = 12.0
"""Ems of a formula in running text that TeX is likely to break; a shorter one stays as one would type it."""
