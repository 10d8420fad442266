"""Limits of the search for finite relations, integrating factors and antiderivatives.

Whatever is found is proved afterwards, so that a limit can only leave a relation unfound. A number in brackets is the
largest value met in the 129 shipped problems, read off when the limits were gathered.
"""

# Derived flag (`derived_flag`). Taylor order d, which is the number of bracket levels; a car with four trailers stays
# below it. The work grows as C(2n + d, d) in n coordinates.
HIGHEST_FLAG_ORDER = 10
# Products of coefficients, at all points together: some seconds.
FLAG_WORK = 6_000_000
# Components of ω ∧ dω are brought to textbook form up to this length [52; 6 beyond, up to 95], and only for a form that
# is itself short [40]; longer ones are unreadable (commit c6c4add).
LONGEST_TIDIED_COMPONENT = 60
LONGEST_TIDIED_FORM = 40

# Antiderivatives: levels of substitution and parts, operations of an integrand [11], terms when it is multiplied out
# [3], and waves cos(β v + ...) in a product of sines and cosines [2].
INTEGRATION_DEPTH = 5
LARGEST_INTEGRAND = 200
MOST_EXPANDED_TERMS = 500
MOST_WAVES = 64
# Different undefined functions and derivatives of them in an integrand whose terms are traded for derivatives of
# products: f(f(... x)) twenty deep is traded, level after level, for minutes.
MOST_UNDEFINED = 8

# Integrating factors (`integrating_factors`): operations [8] and variables [3] of a form, operations of a factor [3].
LARGEST_FORM = 200
MOST_FORM_VARIABLES = 8
LARGEST_FACTOR = 150
# Factors proved or refuted on one form; those without a finite relation before the first of these is taken; sets of
# exponents beside one unknown function; candidates whose exponents may contain parameters.
MOST_PROPOSED_FACTORS = 24
MOST_WITHOUT_POTENTIAL = 5
MOST_BESIDE = 3
MOST_WITH_PARAMETERS = 6
# The relation as a person writes it: rounds of simplification, factors of a product [3], exponents after clearing [3].
RELATION_STEPS = 4
MOST_RELATION_FACTORS = 8
LARGEST_RELATION_POWER = 12

# Candidates for a factor (`factor_candidates`) [15]. Variables of which all pairs are combined, x² + y² and x y.
MOST_FACTOR_CANDIDATES = 36
FEW_VARIABLES = 4
# What is factored and cancelled: operations [10], terms [5], and generators [7], because multivariate factoring grows
# exponentially with their number (commit d0ccc99).
LARGEST_FACTORED = 120
MOST_FACTORED_TERMS = 60
MOST_GENERATORS = 10
# Numerator and denominator of an exponent [3]. A random residue passes with a probability of about 10^4/2^88.
LARGEST_EXPONENT = 60

# Exponents (`factor_methods`): rows beyond the number of unknowns, each of which a wrong solution passes with 1/p;
# points that share one variable; sets of exponents proposed; ratios of parameters in an exponent.
SPARE_EXPONENT_ROWS = 5
POINTS_PER_GROUP = 3
MOST_EXPONENT_SETS = 6
MOST_PARAMETER_RATIOS = 8
# Symmetries: variables of the form (n² + n unknown coefficients), spare rows; combinations such as x y are tried in
# forms of at most three variables.
MOST_SYMMETRY_VARIABLES = 5
SPARE_SYMMETRY_ROWS = 4
MOST_COMBINATION_VARIABLES = 3

# Operations of a direction of which forward, turn, back, turn back is shown (`brackets`), and of each of two finite
# relations that are combined (`combined_relations`).
LONGEST_DIRECTION = 12
LONGEST_COMBINED_RELATION = 30

# Hidden relations (`first_integrals`): functions in the dictionary after each of its three stages.
MOST_CANDIDATES = (70, 110, 150)
# Terms integrated for it, operations of one [3], operations of a coefficient that is multiplied out [3], and entries of
# a form whose ratios are integrated [4].
MOST_INTEGRATED_TERMS = 120
LONGEST_TERM = 40
LARGEST_EXPANDED = 400
MOST_RATIO_ENTRIES = 4
# Coefficients as polynomials in the parameters: degree, unknowns of one linear system [9].
HIGHEST_CONSTANT_DEGREE = 4
MOST_CONSTANT_UNKNOWNS = 200
# Inadmissible points in a row, for each function, before a trial is given up.
MOST_FAILED_POINTS = 20

# One form as a combination of others: forms in it [2], operations of the determinants' entries [9],
# operations of the result, which is printed in a line [14].
MOST_COMBINED_FORMS = 3
LARGEST_COMBINED = 60
LONGEST_COMBINATION = 60

# Operations of a constraint that is solved for a coordinate by hand (`restrictions`) [2].
LARGEST_SOLVED_CONSTRAINT = 60

# Constraints that are not linear in the velocities (`nonlinear_constraints`, `velocity_polynomials`): rules applied
# inside one another, functions reduced for one constraint, alternatives of one function (three pairs of branches),
# symbols and functions, and terms, of a polynomial that SymPy factors; terms and degree of a polynomial in the
# velocities. Each bounds a search that grows with the number of factors; a constraint beyond them stays as it is.
DEEPEST_REDUCTION = 12
MOST_REDUCED = 60
MOST_ALTERNATIVES = 8
MOST_BRANCH_GENERATORS = 8
MOST_FACTORED_BRANCH_TERMS = 40
MOST_VELOCITY_TERMS = 60
HIGHEST_VELOCITY_DEGREE = 8
