"""Limits of the Fourier ring and of the textbook form: beyond them an expression is left as it is, never wrong.

All bound the time of one step or the length of what is printed. A number in brackets is the largest value met in the
129 shipped problems, read off when the limits were gathered; "beyond" counts the times that a limit was exceeded there.
"""

# Terms of a result for a unit of work (`core.effort`), and products of two terms, which are looked up and added.
TERMS_PER_UNIT = 2
PRODUCTS_PER_UNIT = 20
# Terms that are divided by a cosine and by a sine (`product_to_sum`), and terms of a polynomial of half angles, each of
# which takes several products (`linear_systems`), for a unit of work.
TRIED_IN_A_UNIT = 5
MULTIPLIED_IN_A_UNIT = 5
# From here on a term costs four times as much, for the memory: sin sin ... sin x, twenty deep, filled 900 MB.
MANY_TERMS = 20_000

# Powers read into the ring (`ring`): terms of a power multiplied out [45], and the highest multiple of an angle, or
# power of a sum, that is one [10]. cos^60 has 31 terms; cos(10^6 θ) becomes an angle of its own (test_trigonometry).
LONGEST_POWER = 20_000
HIGHEST_MULTIPLE = 64
# Primes by which a number under a root is divided, those that SymPy tries for its own roots.
LARGEST_TRIAL_DIVISOR = 2**15

# Exact division (`division`): terms of dividend times divisor [392; 4 beyond, up to 1,139], and length of one chain
# e^{i(v + 2kw)} when a sine or cosine is divided out [5].
LARGEST_DIVISION = 400
LONGEST_CHAIN = 64
# Rounds in which fractions are joined, as one may expose another; each must change something [2].
MOST_JOINING_ROUNDS = 8

# Sums as products (`product_to_sum`): terms of a sum in which all pairs are joined, else only the first pair of equal
# coefficient [155 beyond, up to 18]; angles and degree of a polynomial in single sines and cosines [3; 8], of which
# 2^angles forms are compared.
LONGEST_SEARCHED = 4
# Frequencies, or terms, of which all pairs are tried for a common factor, or joined: 1,150 sums [18].
LONGEST_PAIRED = 24
MOST_SEPARATED_ANGLES = 3
HIGHEST_SEPARATED = 12

# Terms of a sum that is factored or grouped (`textbook_form`, `terms`) [24; 3 beyond, up to 47]. A longer one is
# printed as it is (test_textbook: a sum of forty squares).
LONGEST_FACTORED = 24

# Quotients in lowest terms: terms of numerator or denominator [99; 1 beyond], the highest multiple of an
# angle in them [6; 1 beyond, 12], terms in the half-angle tangents [430] (four links of a chain have thousands, commit
# 868d2ca), and operations of a quotient whose common factors are sought [674].
LONGEST_CANCELLED = 120
HIGHEST_HALF_ANGLE = 8
MOST_HALF_ANGLE_TERMS = 600
MOST_QUOTIENT_OPERATIONS = 800

# Linear systems (`linear_systems`). Operations of an entry before it is tidied [349; 8 beyond]: the equations are given
# up, because a result that fills pages is of no use.
MOST_ENTRY_OPERATIONS = 400
# Operations of all entries together, each counted whenever it is tidied [2,412; 2 beyond].
MOST_WORK = 2500
# Operations of a quotient that is still brought to lowest terms with its sines as they are [108; 53 beyond].
MOST_CANCELLED = 120
# Unknowns coupled by entries that vary [3]: of a chain of six links no tension fits on a page. One of the bounds that
# took a chain of eight links from 30 s to 2 (commit 95098ff).
MOST_COUPLED = 5
# Unknowns found by Cramer's rule [2; 4 systems beyond]; determinants of three rows would have six products each.
MOST_BY_DETERMINANTS = 2

# Cleaning up after vector products (`vector_cleanup`): nodes of an expression [309], and terms that any part of it has
# when multiplied out [42]; (x + y + z)^20 has 231 (commit 7900170).
LARGEST_CLEANED = 600
MOST_CLEANED_TERMS = 60
# Angles that an expression may always have, and waves, as a product of rotations, of one that has more [40]: the
# vectors of a bicycle's front wheel have 352, and took seconds each.
FEW_ANGLES = 4
MOST_CLEANED_WAVES = 40

# Generators of a ring that many expressions share: a monomial is one number of as many digits.
MOST_SHARED_GENERATORS = 40

LARGEST_COUNT = 1e9
"""Terms of a product, multiplied out, are counted up to this: more are never multiplied out."""
# Steps (`core.effort`) for each letter of the name of an angle: SymPy writes a hundred thousand letters a second, and
# angles of nested sines have hundreds of them.
STEPS_OF_A_LETTER = 5

PAIRS_IN_A_UNIT = 10
"""Pairs of frequencies whose sum and difference are formed for a unit of work."""
