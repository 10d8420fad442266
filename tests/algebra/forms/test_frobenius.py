"""One form at a time: a table of forms with known classification, each decided by a slow second route too."""

from __future__ import annotations

import random
from dataclasses import dataclass, field

import pytest
import sympy as sp

from lagrange.algebra.exact.zero_test import Surface, is_zero
from lagrange.algebra.forms.exact_forms import exactness
from lagrange.algebra.forms.frobenius import frobenius_form, is_integrable
from lagrange.core.symbols import Sign, Slots, Unspecified, prime, t
from tests.support.exterior import Form, concrete, d, is_frobenius, wedge

x, y, z, w, r, theta, phi = sp.symbols("x y z w r theta phi", real=True)
x1, y1, x2, y2 = sp.symbols("x1 y1 x2 y2", real=True)
a, b, length, omega = sp.symbols("a b l omega", positive=True)
k, c = sp.symbols("k c", real=True)
u = sp.Symbol("u", real=True)
sin, cos, exp, sqrt, log = sp.sin, sp.cos, sp.exp, sp.sqrt, sp.log
f = Unspecified.of("f", "XYZ", x, y, z)
fx, fy, fz = (f.partial(n) for n in range(3))
moving = Unspecified.of("f", "XYZ", x - u, y, z)


@dataclass(frozen=True)
class Case:
    """A form Σ a_i dq_i + a_t dt by coefficients, and what it is; `on` are geometric constraints."""

    name: str
    form: dict[sp.Symbol, object]
    exact: bool | None
    integrable: bool | None
    on: tuple[sp.Expr, ...] = ()
    solved: tuple[sp.Symbol, ...] = ()
    prescribed: tuple[sp.Symbol, ...] = ()
    more: tuple[sp.Symbol, ...] = field(default=())

    @property
    def coordinates(self) -> tuple[sp.Symbol, ...]:
        used = {s for e in self.on for s in e.free_symbols} | {*self.form, *self.more}
        for e in self.form.values():
            used |= sp.sympify(e).free_symbols
        known = (x, y, z, w, r, theta, phi, x1, y1, x2, y2)
        return tuple(q for q in known if q in used)

    @property
    def variables(self) -> tuple[sp.Symbol, ...]:
        return (*self.coordinates, t)

    @property
    def coefficients(self) -> list[sp.Expr]:
        return [sp.sympify(self.form.get(v, 0)) for v in self.variables]

    @property
    def slots(self) -> Slots:
        return Slots(self.coordinates, self.prescribed)


radius = sqrt(x**2 + y**2)

PLAIN = [
    Case("circle", {x: 2 * x, y: 2 * y}, True, True),
    Case("constants", {x: a, y: b, t: c}, True, True),
    Case("product", {x: 2 * x * y + z, y: x**2, z: x}, True, True),
    Case("driven point", {x: sin(omega * t), t: omega * x * cos(omega * t)}, True, True),
    Case("rolling wheel", {x: 1, theta: -a}, True, True),
    Case("distance", {x: x / radius, y: y / radius}, True, True),
    Case("angle", {x: -y / radius**2, y: x / radius**2}, True, True),
    Case("rod", {x1: x1 - x2, x2: x2 - x1, y1: y1 - y2, y2: y2 - y1}, True, True),
    Case("undefined function", {x: fx, y: fy, z: fz}, True, True),
    Case("prescribed motion", {x: 1, t: -prime(u)}, True, True, prescribed=(u,)),
    Case("prescribed product", {x: sin(u), t: x * cos(u) * prime(u)}, True, True, prescribed=(u,)),
    Case(
        "moving surface",
        {x: moving.partial(0), y: moving.partial(1), z: moving.partial(2), t: -prime(u) * moving.partial(0)},
        True,
        True,
        prescribed=(u,),
    ),
    Case(
        "exponential",
        {x: exp(-k * t) * cos(y), y: -exp(-k * t) * x * sin(y), t: -k * exp(-k * t) * x * cos(y)},
        True,
        True,
    ),
    Case("logarithm", {x: log(y), y: x / y}, True, True),
    Case("arc tangent", {x: sp.atan(y), y: x / (1 + y**2)}, True, True),
    Case("skate", {x: sin(theta), y: -cos(theta)}, False, False, more=(theta,)),
    Case("contact", {z: 1, x: -y}, False, False),
    Case("helix", {z: 1, x: y, y: -x}, False, False),
    Case("trailer", {x: sin(theta), y: -cos(theta), theta: -length}, False, False),
    Case("rolling disc, one row", {x: 1, phi: -a * cos(theta)}, False, False, more=(theta,)),
    Case("middle of a rod", {x1: y2 - y1, x2: y2 - y1, y1: x1 - x2, y2: x1 - x2}, False, False),
    Case("cyclic", {x: y, y: z, z: x}, False, False),
    Case("swapped partials", {x: fx, y: fz, z: fy}, False, False),
    Case("acatastatic skate", {x: sin(theta), y: -cos(theta), t: -k}, False, False, more=(theta,)),
]

TRAPS = [
    Case("area: a factor x^-2", {x: y, y: -x}, False, True),
    Case("pursuit at frozen t", {x: -sin(omega * t), y: cos(omega * t)}, False, False),
    Case("the same, frozen", {x: -sin(omega * a), y: cos(omega * a)}, True, True),
    Case("a drift that grows", {x: 1, t: -x}, False, True),
    Case("a drift that cannot", {x: 1, y: t}, False, False),
    Case("Pfaff with factor xyz", {x: y * z, y: 2 * x * z, z: 3 * x * y}, False, True),
    Case("polar", {r: sin(theta), theta: 2 * r * cos(theta)}, False, True),
    Case("factor cos^-2", {x: cos(theta), theta: x * sin(theta) - 1}, False, True),
    Case("three variables, factor exp", {x: exp(y), y: x * exp(y) * z, z: 0}, False, False),
    Case("factor f", {x: f * fx, y: f * fy, z: f * fz}, True, True),
    Case("factor x before df", {x: x * fx, y: x * fy, z: x * fz}, False, True),
    Case("factor sin t", {x: sin(t) * y, y: sin(t) * x}, False, True),
    Case("trigonometric cover", {x: cos(theta) ** 2, y: 1 - sin(theta) ** 2}, False, True, more=(theta,)),
    Case("zero in disguise", {x: 1, y: z * (cos(2 * x) - 2 * cos(x) ** 2 + 1)}, True, True),
    Case("Riccati, two variables", {y: 1, x: -(x**2 + y**2)}, False, True),
    Case("prescribed factor", {x: u, y: u * x}, False, True, prescribed=(u,)),
    Case("prescribed direction", {x: sin(u), y: -cos(u)}, False, False, prescribed=(u,)),
    Case("the same with constant u", {x: sin(u), y: -cos(u)}, True, True),
    Case("prescribed drift", {x: 1, t: -u * x}, False, True, prescribed=(u,)),
    Case("absolute value", {x: sp.Abs(y), y: x}, False, True),
    Case("absolute value, three", {x: sp.Abs(y), z: x}, False, False),
    Case("nonzero only with t", {x: y, z: t}, False, False),
    Case("zero form", {x: 0, y: 0}, True, True, more=(x, y)),
]

ON_SURFACES = [
    Case("dx + y z du on z = 0", {x: 1, w: y * z}, False, True, (z,), (z,)),
    Case("dx + y z du off it", {x: 1, w: y * z}, False, False),
    Case("contact on a sphere", {x: y, y: -x, z: 1}, False, True, (x**2 + y**2 + z**2 - length**2,), (z,)),
    Case("contact beside a sphere", {w: 1, x: y}, False, False, (x**2 + y**2 + z**2 - length**2,), (z,)),
    Case("helix on a cylinder", {x: -y, y: x, z: -a}, False, True, (x**2 + y**2 - length**2,), (y,)),
    Case("a factor that vanishes there", {x: 1, y: z * (x + y - w)}, False, True, (x + y - w,), (w,)),
    Case("vanishes there", {x: x - y, z: y**2 - x**2}, False, True, (x - y,), (y,)),
    Case("on a surface that moves", {x: 1, y: z}, False, False, (z - sin(omega * t),), (z,)),
    Case("on one that stands", {x: 1, y: z}, False, True, (z - sin(omega * a),), (z,)),
    Case("on one driven by u", {x: 1, y: z}, False, False, (z - u,), (z,), (u,)),
    Case("on f = c", {x: y, y: -x, z: 1}, False, True, (f - c,), (c,)),
    Case("beside f = c", {w: 1, x: w * x}, False, True, (f - c,), (c,)),
    Case("contact beside f = c", {w: 1, x: y}, False, False, (f - c,), (c,)),
    Case("two planes", {x: 1, w: y * z}, False, True, (y - 1, z - a), (y, z)),
    Case("angle on the surface", {x: sin(theta), y: -cos(theta)}, False, False, (z - sin(theta),), (z,)),
    Case(
        "heading held by a constraint",
        {x: sin(theta), y: -cos(theta)},
        False,
        True,
        (theta - a * x,),
        (theta,),
    ),
]

ALL = PLAIN + TRAPS + ON_SURFACES
cases = pytest.mark.parametrize("case", ALL, ids=lambda case: case.name)


def test_the_table_is_large_and_has_traps():
    assert len(ALL) >= 40
    assert 3 * len(TRAPS + ON_SURFACES) >= len(ALL)
    assert len({case.name for case in ALL}) == len(ALL)


@cases
def test_exactness(case):
    assert exactness(case.coefficients, case.variables, case.slots).exact is case.exact


@cases
def test_integrable(case):
    assert is_integrable(case.coefficients, case.slots, case.on) is case.integrable


@cases
def test_the_table_by_exterior_algebra_at_real_points(case):
    form = [concrete(e, case.prescribed) for e in case.coefficients]
    on = [concrete(e, case.prescribed) for e in case.on]
    verdicts = [is_frobenius(form, case.variables, on, case.solved, seed) for seed in (1, 2)]
    assert verdicts == [case.integrable] * 2


@cases
def test_exact_implies_integrable(case):
    assert not (case.exact and case.integrable is False)


@cases
def test_a_nonvanishing_factor_changes_nothing(case):
    factor = exp(case.coordinates[0]) * (2 + cos(case.coordinates[-1]))
    scaled = [factor * e for e in case.coefficients]
    assert is_integrable(scaled, case.slots, case.on) is case.integrable


@cases
def test_relabelling_changes_nothing(case):
    order = list(case.coordinates)
    random.Random(case.name).shuffle(order)
    new = dict(zip(case.coordinates, order, strict=True))
    named = {new.get(v, v): e.xreplace(new) for v, e in zip(case.variables, case.coefficients, strict=True)}
    form = [named[v] for v in case.variables]
    on = [e.xreplace(new) for e in case.on]
    assert is_integrable(form, case.slots, on) is case.integrable
    assert exactness(form, case.variables, case.slots).exact is case.exact


@pytest.mark.parametrize("case", PLAIN + TRAPS, ids=lambda case: case.name)
def test_other_coordinates_change_nothing(case):
    """q_1 = p_1 + p_2³, q_n = p_n + p_1 t: exactness and integrability are geometric."""
    p, last = case.coordinates, case.coordinates[-1]
    old = {p[0]: p[0] + p[len(p) // 2] ** 3 if len(p) > 2 else p[0] + t, last: last + p[0] * t}
    old = {q: e for q, e in old.items() if q != p[0] or e != q}
    substituted = {v: old.get(v, v) for v in case.variables}
    moved = [concrete_free(e, old) for e in case.coefficients]
    form = [
        sum(e * case_derivative(substituted[v], new, case.slots) for v, e in zip(case.variables, moved, strict=True))
        for new in case.variables
    ]
    assert is_integrable(form, case.slots) is case.integrable


def concrete_free(e: sp.Expr, old: dict[sp.Symbol, sp.Expr]) -> sp.Expr:
    return e.subs(old, simultaneous=True)


def case_derivative(e: sp.Expr, v: sp.Symbol, slots: Slots) -> sp.Expr:
    return slots.frozen_derivative(e) if v == t else sp.diff(e, v)


def test_the_surface_may_be_given_instead_of_its_constraints():
    slots = Slots((x, y, z, w))
    form = [sp.S.One, sp.S.Zero, sp.S.Zero, y * z, sp.S.Zero]
    assert is_integrable(form, slots, Surface([z], slots.coordinates)) is True
    assert is_integrable(form, slots, Surface()) is False


def test_a_surface_without_points_in_a_prime_field():
    """x + sin x + y + e^y + z + sin z = 0 is solved in real numbers."""
    f = x + sin(x) + y + exp(y) + z + sin(z)
    slots = Slots((x, y, z, w))
    assert not Surface([f], slots.coordinates).exact
    relative = [1 + cos(x), 1 + exp(y), sp.S.Zero, w * f, sp.S.Zero]
    assert is_integrable(relative, slots, [f]) is True
    assert is_integrable(relative, slots) is False
    assert is_integrable([sp.S.One, sp.S.Zero, sp.S.Zero, y, sp.S.Zero], slots, [f]) is False


UNDECIDED = [
    ("on one branch of a root only", [1, z * (sqrt(x**2 + 2 * a * x + a**2) - x - a), 0, 0], ()),
    ("at positive x only", [1, z * (sp.Abs(x) - x), 0, 0], ()),
    ("no series", [1, sp.Max(x, z), 0, 0], ()),
    ("piecewise", [1, sp.Piecewise((0, x > 0), (z, True)), 0, 0], ()),
    ("a double plane is not regular", [1, z, 0, 0], ((x - y) ** 2,)),
    ("no real point, none in a field", [1, z, 0, 0], (exp(x) + exp(y) + exp(z),)),
]


@pytest.mark.parametrize(("form", "on"), [case[1:] for case in UNDECIDED], ids=[case[0] for case in UNDECIDED])
def test_undecided_is_none_and_never_a_guess(form, on):
    assert is_integrable(form, Slots((x, y, z)), on) is None


def test_an_identity_of_logarithms_is_not_missed():
    """log(ab) - log a - log b has random values in a prime field; real numbers object."""
    hidden = log(a * b) - log(a) - log(b)
    assert is_integrable([1, z * hidden, 0, 0], Slots((x, y, z))) is not False
    assert is_integrable([1, z * log(a * b), 0, 0], Slots((x, y, z))) is False


def test_a_sign_is_both():
    sigma = Sign("sigma")
    assert is_integrable([1 + sigma, z, 0, 0], Slots((x, y, z))) is None
    assert is_integrable([sigma * y, x, 0, 0], Slots((x, y, z))) is True


def test_the_skate_as_on_the_page():
    """∂a_x/∂θ = cos θ against ∂a_θ/∂x = 0, and ω ∧ dω = -dx ∧ dy ∧ dθ."""
    slots, variables = Slots((x, y, theta)), (x, y, theta, t)
    form = [sin(theta), -cos(theta), sp.S.Zero, sp.S.Zero]
    pairs = exactness(form, variables, slots)
    assert len(pairs.comparisons) == 5  # of the six pairs that of dθ and dt is 0 and 0
    assert [(c.variables, c.derivatives) for c in pairs.differing] == [
        ((x, theta), (cos(theta), 0)),
        ((y, theta), (sin(theta), 0)),
    ]
    [component] = frobenius_form(form, variables, slots)
    assert component.variables == (x, y, theta)
    assert component.coefficient == -1
    assert component.nonzero is True


def test_the_sixth_example():
    """∂a_41/∂q_2 = -1 and ∂a_42/∂q_1 = 1."""
    slots = Slots((x1, y1, x2, y2))
    form = [y2 - y1, -(x2 - x1), y2 - y1, -(x2 - x1), sp.S.Zero]
    first = exactness(form, (x1, y1, x2, y2, t), slots).comparisons[0]
    assert first.variables == (x1, y1)
    assert first.derivatives == (-1, 1)
    assert first.equal is False


def test_time_is_a_variable_of_exactness():
    slots = Slots((x, y))
    pairs = exactness([-sin(omega * t), cos(omega * t), sp.S.Zero], (x, y, t), slots)
    assert [c.variables for c in pairs.differing] == [(x, t), (y, t)]
    assert pairs.differing[0].derivatives == (-omega * cos(omega * t), 0)
    assert exactness([-sin(omega * t), cos(omega * t)], (x, y), slots).exact is True


def test_an_undecided_pair_leaves_exactness_open():
    slots = Slots((x, y))
    pairs = exactness([sp.Max(x, y), sp.S.Zero], (x, y), slots)
    assert pairs.exact is None
    differing = exactness([sp.Max(x, y), sp.S.Zero, y], (x, y, z), Slots((x, y, z)))
    assert differing.exact is False


@pytest.mark.parametrize("case", [c for c in ALL if not c.prescribed], ids=lambda case: case.name)
def test_frobenius_components_are_those_of_exterior_algebra(case):
    form: Form = {(v,): e for v, e in zip(case.variables, case.coefficients, strict=True)}
    product = wedge(form, d(form, case.variables))
    found = {c.variables: c for c in frobenius_form(case.coefficients, case.variables, case.slots)}
    for key, expected in product.items():
        triple = tuple(v for v in case.variables if v in key)
        inversions = sum(str(triple[i]) > str(triple[j]) for i in range(3) for j in range(i + 1, 3))
        component = found.pop(triple, None)
        if component is None:
            assert is_zero(expected)
        else:
            assert is_zero(component.coefficient - (-1) ** inversions * expected)
            assert component.nonzero is not is_zero(expected)
    assert not found
    if case.on == () and case.integrable is not None:
        nonzero = [c.nonzero for c in frobenius_form(case.coefficients, case.variables, case.slots)]
        assert (True in nonzero) is not case.integrable


def test_frobenius_components_are_tidy():
    slots = Slots((x, y, theta))
    form = [length * sin(theta), -length * cos(theta), a * length, sp.S.Zero]
    [component] = frobenius_form(form, (x, y, theta, t), slots)
    assert component.coefficient == -(length**2)
