"""Integrating factors: forms of textbooks, each relation differentiated numerically; traps; forms made from random F and μ."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import combinations

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from lagrange.algebra.forms.frobenius import is_integrable
from lagrange.algebra.forms.integrating_factors import IntegratingFactor, integrating_factor
from lagrange.core.symbols import Slots, Unspecified, prime, t
from lagrange.explain.report import report
from lagrange.mechanics.solution import solve
from lagrange.problem.model import Problem
from lagrange.render.json import as_object
from tests.support.chance import examples
from tests.support.exterior import concrete, real_point
from tests.support.integrability_text import HEAD, words

x, y, z, w, r, theta, phi = sp.symbols("x y z w r theta phi", real=True)
a, b, length, omega, k = sp.symbols("a b l omega k", positive=True)
c, n = sp.symbols("c n", real=True)
u = sp.Symbol("u", real=True)
sin, cos, tan, exp, log, sqrt = sp.sin, sp.cos, sp.tan, sp.exp, sp.log, sp.sqrt
f = Unspecified.of("f", "XYZ", x, y, z)
fx, fy, fz = (f.partial(i) for i in range(3))

VARIABLES = (x, y, z, w, r, theta, phi, t)
SLOTS = Slots(VARIABLES[:-1], (u,))
Form = dict[sp.Symbol, object]


def coefficients(form: Form) -> list[sp.Expr]:
    return [sp.sympify(form.get(v, 0)) for v in VARIABLES]


def found(form: Form) -> IntegratingFactor | None:
    return integrating_factor(coefficients(form), VARIABLES, SLOTS)


# -- the second route: numbers, no derivative of the program's, nothing of a prime field -------------------------


def numerical_gradient(e: sp.Expr, point: dict[sp.Symbol, sp.Expr]) -> list[sp.Float]:
    """Central differences of fifty digits."""
    h = sp.Rational(1, 10**14)

    def at(v: sp.Symbol, step: sp.Expr) -> sp.Float:
        return sp.N(e.xreplace({**point, v: point[v] + step}), 50)

    return [(at(v, h) - at(v, -h)) / (2 * h) for v in VARIABLES]


def points(symbols: set[sp.Symbol], *expressions: sp.Expr) -> list[dict[sp.Symbol, sp.Expr]]:
    """Four real points at which the expressions are real."""
    chosen = []
    for seed in range(1, 40):
        point = dict(real_point((), (), list(symbols), seed))
        if all(sp.N(e.xreplace(point), 20).is_real for e in expressions):
            chosen.append(point)
        if len(chosen) == 4:
            return chosen
    raise AssertionError("no real points")


def parallel(first: Sequence[sp.Expr], second: Sequence[sp.Expr]) -> bool:
    size = max(abs(x) for x in first) * max(abs(x) for x in second)
    pairs = combinations(range(len(first)), 2)
    return size > 0 and all(abs(first[i] * second[j] - first[j] * second[i]) < size * 10**-20 for i, j in pairs)


def assert_relation(integral: sp.Expr, form: Sequence[sp.Expr], factor: sp.Expr | None = None) -> None:
    """dF ∧ ω = 0 and dF ≠ 0 at real points, and dF = C μω with one constant C for parameters that stay."""
    e = concrete(integral, (u,))
    omega_ = [concrete(g, (u,)) for g in form]
    mu = None if factor is None else concrete(factor, (u,))
    symbols = {*VARIABLES}.union(e.free_symbols, *(g.free_symbols for g in omega_))
    fixed = real_point((), (), sorted(symbols - {*VARIABLES}, key=str), 77)
    ratios = []
    for at_random in points(symbols, e.xreplace(dict(fixed)), *(() if mu is None else (mu.xreplace(dict(fixed)),))):
        point = {**at_random, **fixed}
        gradient = numerical_gradient(e, point)
        values = [sp.N(g.xreplace(point), 50) for g in omega_]
        assert parallel(gradient, values)
        if mu is not None:
            largest = max(range(len(values)), key=lambda i: abs(values[i]))
            ratios.append(gradient[largest] / (values[largest] * sp.N(mu.xreplace(point), 50)))
    assert all(abs(q / ratios[0] - 1) < 10**-18 for q in ratios)


# -- forms --------------------------------------------------------------------------------------------------------

WRITTEN: list[tuple[Form, object, sp.Expr]] = [
    ({x: y, y: -x}, x**-2, y / x),
    ({x: y * z, y: 2 * x * z, z: 3 * x * y}, y * z**2, x * y**2 * z**3),
    ({r: sin(theta), theta: 2 * r * cos(theta)}, sin(theta), r * sin(theta) ** 2),
    ({x: 1, t: -x}, exp(-t), x * exp(-t)),
    ({x: 1, t: -k * x}, exp(-k * t), x * exp(-k * t)),
    ({x: 1, t: -(x + t)}, exp(-t), (t + x + 1) * exp(-t)),
    ({x: a * y, y: b * x}, x ** (a - 1) * y ** (b - 1), x**a * y**b),
    ({x: x * sin(theta), theta: (x**2 + 1) * cos(theta)}, sin(theta), (x**2 + 1) * sin(theta) ** 2),
    ({x: cos(theta), theta: x * sin(theta) - 1}, cos(theta) ** -2, x / cos(theta) - tan(theta)),
    ({x: y**2 + y * z, y: x * z + z**2, z: y**2 - x * y}, (y + z) ** -2, y * (x + z) / (y + z)),
    ({x: x * fx, y: x * fy, z: x * fz}, 1 / x, f),
    ({x: u, t: 2 * prime(u) * x}, u, u**2 * x),
    ({x: prime(u), t: -x * prime(u, 2)}, x**-2, prime(u) / x),
    ({x: 1, t: prime(u) * x}, exp(u), x * exp(u)),
    ({x: y * (x**2 + y**2), y: -x * (x**2 + y**2)}, 1 / (x**2 * (x**2 + y**2)), y / x),
    ({x: omega * y, y: -omega * x, t: omega * (x**2 + y**2)}, 1 / (x**2 + y**2), t + sp.atan2(x, y)),
    ({x: x, y: y, t: -k * (x**2 + y**2)}, exp(-2 * k * t), (x**2 + y**2) * exp(-2 * k * t)),
    ({x: cos(theta) ** 2, y: 1 - sin(theta) ** 2}, cos(theta) ** -2, x + y),
    ({x: 2 * x * z, y: 2 * y * z, z: -(x**2) - y**2}, z**-2, (x**2 + y**2) / z),
    ({x: sqrt(x**2 + y**2) * x, y: sqrt(x**2 + y**2) * y}, 1 / sqrt(x**2 + y**2), x**2 + y**2),
]


@pytest.mark.parametrize(("form", "factor", "integral"), WRITTEN, ids=[str(c[2]) for c in WRITTEN])
def test_as_a_person_writes_it(form, factor, integral):
    result = found(form)
    assert result is not None
    assert result.factor == factor
    assert result.integral == integral


BOOKS: list[Form] = [
    # two variables: homogeneous, linear, Bernoulli's, exact up to a function of one variable, of x y, of x + y
    {x: 3 * x * y + y**2, y: x**2 + x * y},
    {x: x**2 + y**2 + x, y: x * y},
    {x: x**2 + y**2, y: -x * y},
    {x: y * (1 + x * y), y: x * (1 - x * y)},
    {x: x * y - 1, y: x**2 - x * y},
    {x: y**2 * cos(x) - y, y: x + y**2},
    {x: 2 * x * y**2 + y, y: -x - y**3},
    {x: 3 * x**2 * y + 2 * x * y + y**3, y: x**2 + y**2},
    {x: y, y: 2 * x - y * exp(y)},
    {x: 1, y: exp(y) - x},
    {x: y, y: -x + y**2 * log(y)},
    {x: log(y), y: 3 * x / y},
    {x: y * cos(x) + 2 * y**2, y: 2 * sin(x) + 6 * x * y},
    {x: x + y + 1, y: -(x - y + 3)},
    {x: -y - sqrt(x**2 + y**2), y: x},
    {x: -(y**2) - x**-2, y: 1},
    {x: -sin(x + y), y: 1},
    {x: -cos(x - y), y: 1},
    {x: x**2 + y, y: -x},
    {x: 1 + y**2, y: x - sp.atan(y)},
    {x: sqrt(y), y: sqrt(x)},
    {x: exp(x + y), y: exp(x - y)},
    {x: sp.cosh(y), y: 2 * x * sp.sinh(y)},
    {x: x * exp(y), y: x**2},
    {x: x**2 * y**3, y: x**3 * y**2 + x**2 * y**2},
    {x: 2 * a * x * y, y: b * x**2 + k},
    # with t
    {x: 1, t: x / t - x**2},
    {x: 1, t: 2 * t * x - t},
    {x: 1, t: -k * x - a * cos(omega * t)},
    {x: cos(omega * t), t: omega * x * sin(omega * t)},
    {x: t, t: -n * x},
    {x: sin(t) * y, y: sin(t) * x},
    {x: 2 * y, y: 3 * x, t: 5 * x * y / t},
    {theta: 1, t: -omega * sin(theta)},
    # angles
    {r: 1, theta: -r / tan(theta)},
    {r: 2 * sin(theta) ** 2, theta: r * sin(2 * theta)},
    {theta: cos(phi), phi: sin(theta)},
    {theta: x, x: tan(theta)},
    {x: 1, theta: -x * tan(theta)},
    # Pfaffian forms of three and four variables
    {x: y * z, y: -x * z, z: x**2 + y**2},
    {x: y * z + z**2, y: -x * z, z: x * y},
    {x: z * (1 - z**2), y: z, z: -(x + y + x * z**2)},
    {x: 2 * y * z, y: z * x, z: -x * y * (1 + z)},
    {x: y * z * (y + z), y: x * z * (x + z), z: x * y * (x + y)},
    {x: y**2 * z, y: x**2 * z, z: -(x**2) * y**2},
    {x: a * y * z, y: b * x * z, z: k * x * y},
    {x: y, y: -x, z: x**2},
    {x: x, y: y, z: -sqrt(x**2 + y**2)},
    {x: y * z * w, y: x * z * w, z: x * y * w, w: 2 * x * y * z},
    {x: (y + z) * w, y: (z + x) * w, z: (x + y) * w, w: -(x * y + y * z + z * x)},
    {x: y * z * t, y: x * z * t, z: x * y * t, t: 2 * x * y * z},
    # undefined functions, prescribed motions, bars
    {x: f, y: y * f},
    {x: y * fx, y: y * fy + f, z: y * fz},
    {x: u**2, t: -u * prime(u) * x},
    {x: u, y: u * x},
    {x: sp.Abs(y), y: x},
]

SOLVED = [form for form, _, _ in WRITTEN] + BOOKS


def test_the_table_is_large():
    assert len(SOLVED) >= 60
    assert sum(len(form) > 2 for form in SOLVED) >= 12


@pytest.mark.parametrize("form", SOLVED, ids=str)
def test_a_factor_and_a_relation_are_found(form):
    result = found(form)
    assert result is not None
    assert result.integral is not None
    assert_relation(result.integral, coefficients(form), result.factor)
    assert result.exactness.exact is True


@pytest.mark.parametrize("form", SOLVED, ids=str)
def test_the_form_that_is_shown_is_the_multiplied_form(form):
    result = found(form)
    shown, given_ = [concrete(e, (u,)) for e in result.form], [concrete(e, (u,)) for e in coefficients(form)]
    factor = concrete(result.factor, (u,))
    symbols = {*VARIABLES}.union(*(e.free_symbols for e in (*shown, *given_)))
    for point in points(symbols, factor):
        for e, g in zip(shown, given_, strict=True):
            assert abs(sp.N((e - factor * g).xreplace(point), 40)) < sp.Float(10) ** -30


@pytest.mark.parametrize("form", SOLVED[:30], ids=str)
def test_the_factor_is_finite_and_not_zero_where_it_is_said_to_be_valid(form):
    """At a point where nothing that is named vanishes; and with a named thing at zero it is 0 or has no value."""
    result = found(form)
    for g in result.nonzero:
        moving = [v for v in VARIABLES if v in g.free_symbols and g.is_polynomial(v) and sp.degree(g, v) == 1]
        if moving and g.is_rational_function():
            there = {moving[0]: sp.solve(g, moving[0])[0]}
            value = sp.together(result.factor).subs(there)
            assert value == 0 or value.has(sp.zoo, sp.nan, sp.oo)


@pytest.mark.parametrize("form", SOLVED, ids=str)
def test_time_occurs_in_the_relation_just_when_the_form_has_a_dt(form):
    e = concrete(found(form).integral, (u,))
    symbols = {*VARIABLES, *e.free_symbols}
    rates = [abs(numerical_gradient(e, point)[VARIABLES.index(t)]) for point in points(symbols, e)]
    assert bool(max(rates) > 10**-15) is (sp.sympify(form.get(t, 0)) != 0)


TRAPS: list[Form] = [
    {x: sin(theta), y: -cos(theta), theta: 0},
    {z: 1, x: -y},
    {x: y, y: z, z: x},
    {x: -sin(omega * t), y: cos(omega * t)},
    {x: y**2 * z, y: z**2 * x, z: x**2 * y},
    {x: 1, y: t},
    {x: y, y: -x, z: 1},
    {x: exp(y), y: x * exp(y) * z},
    {x: fx, y: fz, z: fy},
    {x: sin(u), y: -cos(u)},
]


@pytest.mark.parametrize("form", TRAPS, ids=str)
def test_what_is_not_integrable_has_no_factor(form):
    assert is_integrable(coefficients(form), SLOTS) is False
    assert found(form) is None


NOT_FOUND: list[Form] = [
    {y: 1, x: -(x**2) - y**2},  # Riccati: Bessel functions
    {y: 1, x: -sin(x * y)},
    {x: 1, t: -(u * x) - sin(x)},
    {y: 1, x: -exp(x * y) - x},
]


@pytest.mark.parametrize("form", NOT_FOUND, ids=str)
def test_integrable_and_not_found(form):
    assert is_integrable(coefficients(form), SLOTS) is True
    assert found(form) is None


def test_a_factor_without_a_finite_form():
    """x' = u x with a prescribed u: 1/x, and ∫ u dt is not known."""
    result = found({x: 1, t: -u * x})
    assert result is not None
    assert (result.factor, result.integral) == (1 / x, None)


def test_where_it_is_valid():
    assert found({x: y * z, y: 2 * x * z, z: 3 * x * y}).nonzero == (y, z)
    assert found({x: a * y, y: b * x}).positive == (x, y)
    assert found({x: 1, t: -k * x}).nonzero == ()


def test_zero_and_one_variable():
    assert found({}) is None
    assert found({x: x**2 + 1}).integral == x


LARGE: list[Form] = [
    {v: sum(p**3 * q for p in VARIABLES for q in VARIABLES) for v in VARIABLES},
    {v: v * sum(p * q for p, q in combinations(VARIABLES, 2)) + 1 for v in VARIABLES[:6]},
    {x: (x + y + z + 1) ** 12, y: (x - y) ** 11 + z, z: (x + z) ** 9},
    {x: sin(sin(sin(x * y))), y: exp(exp(x) + y)},
    {x: sum(sin(i * x + y) * cos(i * y) for i in range(1, 9)), y: sum(cos(i * x) for i in range(1, 9))},
    {x: sqrt(x + sqrt(y + sqrt(x * y))), y: sqrt(y) + x ** sp.Rational(1, 3)},
    {x: x**a * y**b + k * x**b * y, y: x**b * y**a + omega * y**length},
]


@pytest.mark.parametrize("form", LARGE, ids=range(len(LARGE)))
def test_what_is_large_is_given_up(form):
    """Nothing to be found; the point is that it ends (see the time limit of the whole run)."""
    assert found(form) is None


# -- laws ---------------------------------------------------------------------------------------------------------

whole = st.integers(-2, 2)
terms = st.sampled_from(
    [x, y, z, x * y, y * z, x**2 * z, x * cos(theta), exp(x) * y, x**2 + y**2, y * sin(theta), z * t, 1 / z]
)


@st.composite
def functions(draw: Callable[..., object]) -> sp.Expr:
    """A product of powers, or a sum of two terms, in three or four variables."""
    if draw(st.booleans()):
        e = x ** draw(whole) * y ** draw(whole) * z ** draw(whole) * cos(theta) ** draw(st.integers(0, 2))
    else:
        e = draw(st.integers(1, 3)) * draw(terms) + draw(st.sampled_from([1, -2, a])) * draw(terms)
    return e


@st.composite
def factors(draw: Callable[..., object]) -> sp.Expr:
    e = x ** draw(whole) * y ** draw(whole) * exp(draw(st.integers(-1, 1)) * t) * cos(theta) ** draw(st.integers(-1, 1))
    return e * draw(st.sampled_from([1, x**2 + y**2, x + y, 1 / (x + z), exp(x * y)]))


@settings(max_examples=examples(40), deadline=None)
@given(functions(), factors())
def test_a_differential_divided_by_a_factor_is_recognised(e, mu):
    form = [sp.cancel(sp.diff(e, v) / mu) for v in VARIABLES]
    if not any(form):
        return
    result = integrating_factor(form, VARIABLES, SLOTS)
    assert result is not None
    assert result.integral is not None
    assert_relation(result.integral, form, result.factor)
    for point in points({*VARIABLES, a}, result.integral, e):
        assert parallel(numerical_gradient(result.integral, point), numerical_gradient(sp.sympify(e), point))


@settings(max_examples=10, deadline=None)
@given(st.permutations([x, y, z]), st.sampled_from(SOLVED[:10]))
def test_names_do_not_matter(order, form):
    new = dict(zip((x, y, z), order, strict=True))
    renamed = {new.get(v, v): sp.sympify(g).xreplace(new) for v, g in form.items()}
    result = found(renamed)
    assert result is not None
    assert_relation(result.integral, coefficients(renamed), result.factor)


# -- the stages ---------------------------------------------------------------------------------------------------


def of_constraint(problem: Callable[[str], Problem], text: str, last: str) -> dict[str, object]:
    result = as_object(report(problem(HEAD + text)))
    assert all(check["passed"] for check in result["checks"])
    return next(c for c in result["constraints"] if c["name"] == last)


@pytest.mark.parametrize(
    ("text", "factor", "integral", "timed"),
    [
        ("{c: \"y*x' - x*y' = 0\"}", "1/x^2", "y/x", False),
        ('{c: "x\' - k*x = 0"}', "exp(-k*t)", "x*exp(-k*t)", True),
        ("{c: \"sin(omega*t)*(y*x' + x*y') = 0\"}", "1/sin(omega*t)", "x*y", False),
        ("{c: \"x' - a*y' = 0\"}", "1", "x - a*y", False),
        ("{s: z = sin(omega*t), c: \"x' + (z - sin(omega*t))*y' = 0\"}", "1", "x", False),
        ("{s: z = a, c: \"x' + z*y' + (z - a)*t = 0\"}", "1", "x + a*y", False),
        ("{s: x^2 + y^2 = l^2, c: \"x*y' - y*x' - a*z' = 0\"}", "1", None, False),
    ],
)
def test_factor_and_integral_of_a_constraint(problem, text, factor, integral, timed):
    found_ = of_constraint(problem, text, "c")
    assert found_["integrable"] is True
    assert found_["integrating_factor"] == factor
    assert found_["depends_on_time"] is timed
    assert "integral" in found_
    assert integral is None or found_["integral"] == integral


def test_no_factor_where_none_is_known(problem):
    skate = of_constraint(problem, "{c: \"x' - z*y' = 0\"}", "c")
    assert (skate["integrable"], "integrating_factor" in skate, "integral" in skate) == (False, False, False)
    riccati = of_constraint(problem, "{c: \"y' - (x^2 + y^2)*x' = 0\"}", "c")
    assert (riccati["integrable"], "integrating_factor" in riccati) == (True, False)


def test_the_derivation_shows_factor_form_pairs_relation_and_validity(problem):
    said = words(problem, "{c: \"y*z*x' + 2*x*z*y' + 3*x*y*z' = 0\"}")
    assert "integrating factor is y*z^2" in said
    assert "y^2*z^3*d(x) + 2*x*y*z^3*d(y) + 3*x*y^2*z^2*d(z) = 0" in said
    assert "diff(y^2*z^3, y) = 2*y*z^3 = diff(2*x*y*z^3, x)" in said
    assert "x*y^2*z^3 = const" in said
    assert "valid where y ≠ 0 and z ≠ 0" in said
    assert "A form may be integrable without being exact" in said


def test_the_derivation_says_when_none_was_found(problem):
    said = words(problem, "{c: \"y' - (x^2 + y^2)*x' = 0\"}")
    assert "A factor exists but was not found" in said


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("{c: \"y*x' - x*y' = 0\"}", "the factor makes the form of the c constraint exact"),
        (
            "{c: \"y*x' - x*y' = 0\"}",
            "the finite relation has a differential proportional to the form of the c constraint",
        ),
        (
            "{c: \"x' - a*y' = 0\"}",
            "the finite relation has a differential proportional to the form of the c constraint",
        ),
    ],
)
def test_the_checks(problem, text, name):
    [check] = [c for c in solve(problem(HEAD + text)).checks if c.name == name]
    assert check.passed is True
