"""How many random points decide: is it zero, what is the rank, do two systems agree?

An expression of degree d that is not zero vanishes at a random point of F_p with a probability of d/p at most
(Schwartz 1980, Zippel 1979). With p > 2^88, and more than 2^54 points of the circle for an angle, that is

    2^-88 d  for symbols,      2^-53 d  for an angle (sin nθ has at most 2n zeros).

So two points suffice where nothing has a sign. More are needed only where a value has several branches: a root is
taken either way at random, |a| is a at half of the points, a surface such as x² = y² has two components. What is wrong
on a share s of the branches is missed by n points with the probability (1 − s)^n; all the larger numbers below follow
from that. Real points are a second opinion, exact to a number of digits and never a proof of zero. States of motion
in the diagnosis of an answer are counted by the same probabilities in `answers/limits.py`.
"""

# Zero and rank (`zero_test.Surface`). For d = 100 two points are wrong with a probability below 2^-90: docs/checks.md.
ZERO_POINTS = 2
# With two components of the surface, what vanishes on one of them only passes with the probability 2^-10.
ZERO_POINTS_AFTER_ROOTS = 10
# Real points that must all have the value zero, or the same rank, where the field leaves the question open.
ZERO_REAL_POINTS = 12

# Real numbers have 80 digits. With |x| < 60 for every e^x (10^26), rounding stays below 10^-54: a value above 10^-42 is
# certainly not zero. One below 10^-60 counts as zero, which is agreement to sixty digits; the gap between is undecided.
REAL_DIGITS = 80
ZERO_DIGITS = 60
NONZERO_DIGITS = 42

# Signs (`sampler.Branches`). Of k signs at most 20·2^k points are taken, until all patterns have been met: one
# pattern is missed with the probability (1 − 2^-k)^(20·2^k), about e^-20. Two points only, half of which are on the
# right branch, called √(a² + 2ab + b²) − a − b not zero (zero at 19 points of 40 in the first trials).
POINTS_PER_SIGN_PATTERN = 20
# Bounds the points of one question to 20·2^5 = 640; further signs are not met in all combinations.
MOST_COMBINED_SIGNS = 5

# Places where a sign changes that are visited by real points, and the points each is sought from. A zero that holds for
# all small values, |x − 1000| + x − 1000, is refuted there and nowhere else.
WALLS_VISITED = 6
STARTS_PER_WALL = 4

# A denominator that vanished at the first four points is zero: each is wrong with the probability d/p. Where it has
# signs, one that vanishes on half of the branches only passes with 2^-40.
ZERO_DIVISIONS = 4
ZERO_DIVISIONS_WITH_SIGNS = 40

# Agreement of two systems, answers and equations (`zero_test.agreed`): below 2^-130 for d = 100 (docs/checks.md).
AGREEMENT_POINTS = 3
# The least number where there are signs. Six points alone called |φ'| instead of φ' equivalent once in a hundred runs
# (commit c1adfcc), so that points are taken until each sign has been met both ways.
AGREEMENT_POINTS_WITH_SIGNS = 6
# Up to three signs are met in every combination, with 80 points at most. Of three signs one of the eight patterns is
# missed by all 80 with a probability below 2·10^-4, of two with one below 10^-9.
FEW_SIGNS = 3
MOST_POINTS_FOR_FEW_SIGNS = 80
# Of more signs each is met both ways, missed with the probability 2^-19: a term of a sum depends on its own sign, and
# all 2^9 patterns of nine absolute values would take hundreds of points (commit 415cf95).
POINTS_FOR_MANY_SIGNS = 20
# Real points that must agree with those of the field, where these agree among themselves.
AGREEMENT_REAL_POINTS = 2
# Where they differ, real points decide alone. What is wrong where two signs are negative is so at a quarter of them:
# (3/4)^48 = 10^-6. With 16 a verdict for r > 0 passed for all r once in a hundred runs (commit da054b1).
REAL_POINTS_WHERE_SIGNS_DIFFER = 48

# Frobenius' condition and the derived flag (`forms.charts.agreed_on_surface`), at points whose ranks must agree.
FLAG_POINTS = 2
# All on one of two components of the surface with the probability 2^-7.
FLAG_POINTS_AFTER_ROOTS = 8
# All with the same sign with the probability 2^-19.
FLAG_POINTS_WITH_SIGNS = 20
FLAG_REAL_POINTS_WITH_SIGNS = 4
# An opaque function (atan, log) may hide an identity in the field: one real point is the second opinion.
FLAG_REAL_POINTS = 1
