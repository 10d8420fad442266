"""The problems of `problems/constraints`, against forms and finite relations typed from the drawing.

The reference of a problem is its forms Σ a_i dq_i + a_t dt, written down or derived here without the program: velocities
of points by differentiating positions, angular velocities from rotation matrices. What follows from them is worked out
twice: the derived flag by brackets of vector fields, whose last rank bounds the number of finite relations from
above, and the relations themselves, typed, whose differentials must lie in the span of the forms, which bounds it from
below. The program has to agree with both, and with `ω ∧ dω ∧ df` at a real point for every form alone.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache

import pytest
import sympy as sp
from sympy import Matrix, atan2, cos, exp, log, sin, tan

from lagrange.answers.equations import Verdict
from lagrange.core.symbols import t
from tests.support.exterior import concrete, flag_by_brackets, is_frobenius, rank, real_point
from tests.support.paths import PROBLEMS
from tests.support.shared import reported

FOLDER = PROBLEMS / "constraints"
Form = Mapping[sp.Symbol, sp.Expr]


def coordinates(names: str) -> tuple[sp.Symbol, ...]:
    return sp.symbols(names, real=True, seq=True)


def constants(names: str) -> tuple[sp.Symbol, ...]:
    return sp.symbols(names, positive=True, seq=True)


@dataclass(frozen=True)
class Known:
    """What is known of one problem.

    q           the coordinates, in the order of the file
    forms       name of the constraint -> its form, by the coordinate whose differential each coefficient multiplies
    geometric   name -> function that vanishes; its differential counts as a form
    integrable  whether each of the forms is a finite relation where the geometric constraints hold
    flag        the ranks of the derived flag
    relations   independent functions that stay constant, as many as there are
    freedom     number of independent virtual displacements
    words       what the system is, beside holonomic or not
    """

    q: tuple[sp.Symbol, ...]
    forms: Mapping[str, Form]
    integrable: Mapping[str, bool]
    flag: tuple[int, ...]
    freedom: int
    relations: tuple[sp.Expr, ...] = ()
    words: str = "scleronomic catastatic"
    geometric: Mapping[str, sp.Expr] | None = None
    redundant: tuple[str, ...] = ()

    @property
    def variables(self) -> tuple[sp.Symbol, ...]:
        return (*self.q, t)

    @property
    def finite(self) -> Mapping[str, sp.Expr]:
        return self.geometric or {}

    def row(self, form: Form) -> list[sp.Expr]:
        assert set(form) <= set(self.variables)
        return [sp.sympify(form.get(v, 0)) for v in self.variables]

    def gradient(self, f: sp.Expr) -> list[sp.Expr]:
        return [sp.diff(f, v) for v in self.variables]

    @property
    def rows(self) -> list[list[sp.Expr]]:
        return [*map(self.gradient, self.finite.values()), *map(self.row, self.forms.values())]

    def place(self, seed: int, more: Sequence[Sequence[sp.Expr]] = ()) -> Mapping[sp.Symbol, sp.Expr]:
        """Values of all symbols where the geometric constraints hold."""
        used = set(self.variables).union(*(sp.sympify(e).free_symbols for r in (*self.rows, *more) for e in r))
        used |= set().union(*(f.free_symbols for f in self.finite.values()))
        return real_point(list(self.finite.values()), self.solved_for, list(used), seed)

    @property
    def solved_for(self) -> list[sp.Symbol]:
        """A coordinate for each geometric constraint, the last ones that occur."""
        chosen: list[sp.Symbol] = []
        for f in self.finite.values():
            chosen.append(next(v for v in reversed(self.q) if f.has(v) and v not in chosen))
        return chosen


def velocity_form(function: sp.Expr, q: Sequence[sp.Symbol], rates: Sequence[sp.Symbol]) -> Form:
    """The form of a condition that is linear in the rates."""
    expanded = sp.expand(function)
    form = {v: expanded.coeff(r) for v, r in zip(q, rates, strict=True)}
    return {**form, t: expanded.subs(dict.fromkeys(rates, 0))}


def rate_of(vector: Matrix, q: Sequence[sp.Symbol], rates: Sequence[sp.Symbol]) -> Matrix:
    return vector.jacobian(list(q)) * Matrix(rates)


def rotation(phi: sp.Symbol, theta: sp.Symbol, psi: sp.Symbol) -> Matrix:
    """Body to space, about the third, first and third axis; the columns are e1, e2, e3."""

    def about_third(a: sp.Symbol) -> Matrix:
        return Matrix([[cos(a), -sin(a), 0], [sin(a), cos(a), 0], [0, 0, 1]])

    first = Matrix([[1, 0, 0], [0, cos(theta), -sin(theta)], [0, sin(theta), cos(theta)]])
    return about_third(phi) * first * about_third(psi)


def rolling(centre: Matrix, angles: tuple[sp.Symbol, ...], to_contact: Matrix, q: tuple[sp.Symbol, ...]) -> list[Form]:
    """The velocity of the material point at the contact, C' + A' Aᵀ (r_Q − r_C), component by component."""
    rates = sp.symbols(f"v:{len(q)}")
    a = rotation(*angles)
    turning = sum((a.diff(s) * r for s, r in zip(q, rates, strict=True)), sp.zeros(3, 3)) * a.T
    slip = (rate_of(centre, q, rates) + turning * to_contact).applyfunc(sp.trigsimp)
    return [velocity_form(c, q, rates) for c in slip]


def sideways(point: Matrix, heading: sp.Expr, q: tuple[sp.Symbol, ...]) -> Form:
    """The velocity of a point of the plane across a heading."""
    rates = sp.symbols(f"v:{len(q)}")
    return velocity_form(rate_of(point, q, rates).dot(Matrix([sin(heading), -cos(heading)])), q, rates)


def wheel_on_a_line() -> Known:
    x, phi = coordinates("x phi")
    (radius,) = constants("R")
    return Known((x, phi), {"rolling": {x: 1, phi: -radius}}, {"rolling": True}, (1,), 1, (x - radius * phi,))


def upright_disc() -> Known:
    x, y, theta, phi = coordinates("x y theta phi")
    (radius,) = constants("R")
    forms = {
        "rolling_east": {x: 1, phi: -radius * cos(theta)},
        "rolling_north": {y: 1, phi: -radius * sin(theta)},
    }
    return Known((x, y, theta, phi), forms, dict.fromkeys(forms, False), (2, 1, 0), 2)


def disc_on_a_fixed_heading() -> Known:
    known = upright_disc()
    x, y, theta, phi = known.q
    (radius,) = constants("R")
    return Known(
        known.q,
        {**known.forms, "heading": {theta: 1}},
        {**known.integrable, "heading": True},
        (3,),
        1,
        (theta, x - radius * phi * cos(theta), y - radius * phi * sin(theta)),
    )


def rolling_ball() -> Known:
    x, y, phi, theta, psi = q = coordinates("x y phi theta psi")
    (radius,) = constants("R")
    slip = rolling(Matrix([x, y, 0]), (phi, theta, psi), Matrix([0, 0, -radius]), q)
    forms = {"no_slip.1": slip[0], "no_slip.2": slip[1]}
    return Known(q, forms, dict.fromkeys(forms, False), (2, 0), 3)


def ball_without_spin() -> Known:
    """The growth 2, 3, 5 of the directions is Cartan's."""
    known = rolling_ball()
    _, _, phi, theta, psi = known.q
    a = rotation(phi, theta, psi)
    spin = {v: sp.trigsimp((a.diff(v) * a.T)[1, 0]) for v in (phi, theta, psi)}
    forms = {"no_slip_x": known.forms["no_slip.1"], "no_slip_y": known.forms["no_slip.2"], "no_spin": spin}
    return Known(known.q, forms, dict.fromkeys(forms, False), (3, 2, 0), 2)


def rolling_coin() -> Known:
    x, y, z, phi, theta, psi = q = coordinates("x y z phi theta psi")
    (radius,) = constants("R")
    axis = rotation(phi, theta, psi)[:, 2]
    up = Matrix([0, 0, 1])
    uphill = (up - axis * cos(theta)) / sin(theta)  # in the plane of the coin, at right angles to its horizontal line
    slip = rolling(Matrix([x, y, z]), (phi, theta, psi), -radius * uphill, q)
    forms = {f"no_slip.{n}": form for n, form in enumerate(slip, start=1)}
    integrable = {"no_slip.1": False, "no_slip.2": False, "no_slip.3": True}
    return Known(q, forms, integrable, (3, 2, 1), 3, (z - radius * sin(theta),))


def cylinder_in_a_cylinder() -> Known:
    r, phi, psi = coordinates("r phi psi")
    big, a = constants("R a")
    return Known(
        (r, phi, psi),
        {"no_slip": {phi: r, psi: a}},
        {"no_slip": True},
        (2,),
        1,
        (r, (big - a) * phi + a * psi),
        geometric={"contact": r - big + a},
    )


def skate_on_a_turntable() -> Known:
    """The condition of the skate in coordinates that turn with the ice, which is at rest there."""
    x, y, theta = q = coordinates("x y theta")
    turn = sp.Symbol("Omega", real=True)
    rates, along = sp.symbols("v:3"), cos(turn * t)
    across = sin(turn * t)
    there = Matrix([x * along + y * across, -x * across + y * along])
    velocity = rate_of(there, q, rates) + there.diff(t)
    heading = theta - turn * t
    form = velocity_form(velocity.dot(Matrix([sin(heading), -cos(heading)])), q, rates)
    return Known(q, {"blade": form}, {"blade": False}, (1, 0), 2, words="scleronomic acatastatic")


def skate_on_a_floe() -> Known:
    x, y, theta = q = coordinates("x y theta")
    drift = concrete(sp.Symbol("u'", real=True), (sp.Symbol("u", real=True),))
    form = {x: sin(theta), y: -cos(theta), t: -drift * sin(theta)}
    return Known(q, {"blade": form}, {"blade": False}, (1, 0), 2, words="rheonomic acatastatic")


def steered_blade() -> Known:
    x, y = q = coordinates("x y")
    (omega,) = constants("omega")
    forms = {"blade": {x: -sin(omega * t), y: cos(omega * t)}}
    return Known(q, forms, {"blade": False}, (1, 0), 1, words="rheonomic catastatic")


def chaplygin_sleigh() -> Known:
    x, y, theta = q = coordinates("x y theta")
    (a,) = constants("a")
    edge = Matrix([x - a * cos(theta), y - a * sin(theta)])
    return Known(q, {"knife_edge": sideways(edge, theta, q)}, {"knife_edge": False}, (1, 0), 2)


def towed_blade() -> Known:
    """The tractrix: with a − x = l cos χ and y = l sin χ, da = −l dχ/sin χ."""
    a, x, y = coordinates("a x y")
    (length,) = constants("l")
    return Known(
        (a, x, y),
        {"blade": {y: x - a, x: -y}},
        {"blade": True},
        (2,),
        1,
        ((x - a) ** 2 + y**2, a + length * log(tan(atan2(y, a - x) / 2))),
        geometric={"rod": (x - a) ** 2 + y**2 - length**2},
    )


def three_wheels_in_line() -> Known:
    x, y, theta = q = coordinates("x y theta")
    a, b = constants("a b")
    ahead = Matrix([cos(theta), sin(theta)])
    middle = Matrix([x, y])
    forms = {
        "middle": sideways(middle, theta, q),
        "front": sideways(middle + a * ahead, theta, q),
        "rear": sideways(middle - b * ahead, theta, q),
    }
    relations = (theta, x * sin(theta) - y * cos(theta))
    return Known(q, forms, dict.fromkeys(forms, False), (2,), 1, relations, redundant=("rear",))


def car() -> Known:
    x, y, theta, phi = q = coordinates("x y theta phi")
    (length,) = constants("l")
    rear = Matrix([x, y])
    front = rear + length * Matrix([cos(theta), sin(theta)])
    forms = {"rear_wheels": sideways(rear, theta, q), "front_wheels": sideways(front, theta + phi, q)}
    return Known(q, forms, dict.fromkeys(forms, False), (2, 1, 0), 2)


def car_with_trailer() -> Known:
    x, y, phi, theta, psi = q = coordinates("x y phi theta psi")
    length, d = constants("l d")
    rear = Matrix([x, y])
    front = rear + length * Matrix([cos(theta), sin(theta)])
    trailer = rear - d * Matrix([cos(psi), sin(psi)])
    forms = {
        "rear_wheels": sideways(rear, theta, q),
        "front_wheels": sideways(front, theta + phi, q),
        "trailer": sideways(trailer, psi, q),
    }
    return Known(q, forms, dict.fromkeys(forms, False), (3, 2, 1, 0), 2)


def bicycle() -> Known:
    x1, y1, x2, y2, psi = q = coordinates("x1 y1 x2 y2 psi")
    (length,) = constants("l")
    frame = (x2 - x1) ** 2 + (y2 - y1) ** 2
    forms = {
        "rear_wheel": {x1: y2 - y1, y1: x1 - x2},
        "front_wheel": sideways(Matrix([x2, y2]), psi, q),
    }
    return Known(q, forms, dict.fromkeys(forms, False), (3, 2, 1), 2, (frame,), geometric={"frame": frame - length**2})


def two_wheels_on_an_axle() -> Known:
    x, y, theta, phi1, phi2 = q = coordinates("x y theta phi1 phi2")
    radius, b = constants("R b")
    forms = {
        "sideways": {x: sin(theta), y: -cos(theta)},
        "right_wheel": {x: cos(theta), y: sin(theta), theta: b, phi1: -radius},
        "left_wheel": {x: cos(theta), y: sin(theta), theta: -b, phi2: -radius},
    }
    return Known(q, forms, dict.fromkeys(forms, False), (3, 2, 1), 2, (radius * (phi1 - phi2) - 2 * b * theta,))


def south_pointing_chariot() -> Known:
    """The arm keeps its direction θ + ψ in space."""
    axle = two_wheels_on_an_axle()
    x, y, theta, phi1, phi2 = axle.q
    (psi,) = coordinates("psi")
    radius, b = constants("R b")
    forms = {**axle.forms, "gear": {psi: 2 * b, phi2: -radius, phi1: radius}}
    return Known(
        (x, y, theta, phi1, phi2, psi),
        forms,
        {**axle.integrable, "gear": True},
        (4, 3, 2),
        2,
        (*axle.relations, theta + psi),
    )


def differential_hoist() -> Known:
    """Half the difference of the radii lifts the load: y = (R − r) φ/2."""
    y, phi, psi = q = coordinates("y phi psi")
    big, small, a = constants("R r a")
    forms = {"large_side": {y: 1, psi: a, phi: -big}, "small_side": {y: 1, psi: -a, phi: small}}
    relations = (2 * y - (big - small) * phi, 2 * a * psi - (big + small) * phi)
    return Known(q, forms, dict.fromkeys(forms, True), (2,), 1, relations)


def rocking_plane() -> Known:
    x, _, z = q = coordinates("x y z")
    alpha = concrete(sp.Symbol("alpha", real=True), (sp.Symbol("alpha", real=True),))
    plane = z * cos(alpha) - x * sin(alpha)
    return Known(q, {}, {}, (1,), 2, (plane,), "rheonomic acatastatic", {"plane": plane})


def pursuit() -> Known:
    """The velocity of the dog is parallel to the line of sight from (x, y) to (0, u)."""
    x, y = q = coordinates("x y")
    u = concrete(sp.Symbol("u", real=True), (sp.Symbol("u", real=True),))
    rates = sp.symbols("v:2")
    sight = Matrix([[-x, u - y], list(rates)]).det()
    return Known(
        q, {"sight": velocity_form(sight, q, rates)}, {"sight": False}, (1, 0), 1, words="rheonomic catastatic"
    )


def form_in_two_variables() -> Known:
    """With the factor x."""
    x, y = q = coordinates("x y")
    forms = {"slope": {x: 3 * x * y + y**2, y: x**2 + x * y}}
    return Known(q, forms, {"slope": True}, (1,), 1, (x**3 * y + x**2 * y**2 / 2,))


def form_in_three_variables() -> Known:
    x, y, z = q = coordinates("x y z")
    forms = {"surface": {x: y * z, y: 2 * x * z, z: 3 * x * y}}
    return Known(q, forms, {"surface": True}, (1,), 2, (x * y**2 * z**3,))


def dipole_field_line() -> Known:
    """Lines of force r = c sin²θ."""
    r, theta = q = coordinates("r theta")
    forms = {"drift": {r: sin(theta), theta: -2 * r * cos(theta)}}
    return Known(q, forms, {"drift": True}, (1,), 1, (r / sin(theta) ** 2,))


def servo() -> Known:
    """The solution of the linear equation: x = v t − v/κ + c exp(−κ t)."""
    (x,) = coordinates("x")
    kappa, v = constants("kappa v")
    forms = {"servo": {x: 1, t: -kappa * (v * t - x)}}
    return Known(
        (x,), forms, {"servo": True}, (1,), 0, ((x - v * t + v / kappa) * exp(kappa * t),), "rheonomic acatastatic"
    )


def contact_form() -> Known:
    x, y, z = q = coordinates("x y z")
    return Known(q, {"slope": {z: 1, x: -y}}, {"slope": False}, (1, 0), 2)


def contact_form_with_fixed_slope() -> Known:
    x, y, z = q = coordinates("x y z")
    forms = {"slope": {z: 1, x: -y}, "held": {y: 1}}
    return Known(q, forms, {"slope": False, "held": True}, (2,), 1, (y, z - x * y))


def sphere_in_disguise() -> Known:
    x, y, z = q = coordinates("x y z")
    forms = {"law": {x: x / z**2, y: y / z**2, z: 1 / z}}
    return Known(q, forms, {"law": True}, (1,), 2, (x**2 + y**2 + z**2,))


KNOWN: dict[str, Callable[[], Known]] = {
    function.__name__.replace("_", "-"): function
    for function in (
        wheel_on_a_line, upright_disc, disc_on_a_fixed_heading, rolling_ball, ball_without_spin, rolling_coin,
        cylinder_in_a_cylinder, skate_on_a_turntable, skate_on_a_floe, steered_blade, chaplygin_sleigh, towed_blade,
        three_wheels_in_line, car, car_with_trailer, bicycle, two_wheels_on_an_axle, south_pointing_chariot,
        differential_hoist, rocking_plane, pursuit, form_in_two_variables, form_in_three_variables, dipole_field_line,
        servo, contact_form, contact_form_with_fixed_slope, sphere_in_disguise,
    )
}  # fmt: skip


@cache
def known(name: str) -> Known:
    return KNOWN[name]()


def test_every_problem_has_its_reference() -> None:
    assert {p.stem for p in FOLDER.iterdir()} == KNOWN.keys()


@pytest.mark.parametrize("name", KNOWN)
def test_the_constraints_are_those_of_the_drawing(name: str) -> None:
    """The forms of the program and of the reference, one by one, are multiples of one another at real points."""
    reference, problem = known(name), reported(name).solution.problem
    assert problem.slots.coordinates == reference.q
    expected = {n: reference.gradient(f) for n, f in reference.finite.items()}
    expected |= {n: reference.row(f) for n, f in reference.forms.items()}
    rows = {r.name: r for r in reported(name).solution.classification.rows}
    assert rows.keys() == expected.keys()
    for key, row in rows.items():
        found = [concrete(a, problem.slots.prescribed) for a in (*row.coefficients, row.drift)]
        for seed in (1, 2):
            place = reference.place(seed, [found])
            assert rank([expected[key]], place) == 1
            assert rank([expected[key], found], place) == 1, key


@pytest.mark.parametrize("name", KNOWN)
def test_the_derived_flag_by_brackets(name: str) -> None:
    reference = known(name)
    assert flag_by_brackets(reference.rows, reference.variables) == reference.flag
    assert reported(name).solution.classification.flag.ranks == reference.flag
    assert reported(name).solution.classification.integrable_rank == reference.flag[-1]


@pytest.mark.parametrize("name", KNOWN)
def test_the_finite_relations_are_as_many_as_the_flag_says(name: str) -> None:
    """Their differentials are independent, and combinations of the forms where the geometric constraints hold."""
    reference = known(name)
    gradients = [reference.gradient(f) for f in reference.relations]
    assert len(gradients) == reference.flag[-1]
    for seed in (1, 2, 3):
        place = reference.place(seed, gradients)
        assert rank([*reference.rows, *gradients], place) == rank(reference.rows, place) == reference.flag[0]
        assert not gradients or rank(gradients, place) == len(gradients)


@pytest.mark.parametrize("name", KNOWN)
def test_each_form_alone(name: str) -> None:
    reference = known(name)
    assert reference.integrable.keys() == reference.forms.keys()
    found = {c.row.name: c.integrable for c in reported(name).solution.classification.constraints}
    for key, form in reference.forms.items():
        finite = list(reference.finite.values())
        by_hand = {
            is_frobenius(reference.row(form), reference.variables, finite, reference.solved_for, seed)
            for seed in (1, 2)
        }
        assert by_hand == {reference.integrable[key]}, key
        assert found[key] is reference.integrable[key], key
    assert all(found[key] for key in reference.finite)


@pytest.mark.parametrize("name", KNOWN)
def test_freedom_and_classification(name: str) -> None:
    reference, found = known(name), reported(name).solution.classification
    place = reference.place(1)
    still = [row[:-1] for row in reference.rows]
    assert len(reference.q) - rank(still, place) == reference.freedom == found.degrees_of_freedom
    assert found.configuration_dimension == len(reference.q) - reference.flag[-1]
    assert found.holonomic is (len(reference.relations) == reference.flag[0])
    assert found.scleronomic is ("scleronomic" in reference.words.split())
    assert found.catastatic is ("catastatic" in reference.words.split())
    assert found.catastatic is (rank([[row[-1]] for row in reference.rows], place) == 0)
    assert found.redundant == reference.redundant


@pytest.mark.parametrize("name", KNOWN)
def test_the_answers_of_the_file_say_the_same(name: str) -> None:
    """What the file claims is the reference's, and the run confirms it."""
    reference, result = known(name), reported(name)
    key = result.solution.problem.answers
    assert key is not None
    assert key.degrees_of_freedom == reference.freedom
    word = "holonomic" if len(reference.relations) == reference.flag[0] else "nonholonomic"
    assert set(key.classification) == {word, *reference.words.split()}
    assert dict(key.integrable) == {**dict.fromkeys(reference.finite, True), **reference.integrable}
    assert [a.name for a in result.answers] == ["degrees_of_freedom", "classification", "integrable"]
    assert {a.verdict for a in result.answers} == {Verdict.EQUIVALENT}
    assert result.holds
    assert not result.notes
