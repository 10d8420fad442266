"""Acute angles and ranges: what they decide, and which equilibria they leave out.

Poles of a chart: the azimuth at the pole of a sphere moves nothing.

tan θ = ρ θ beside θ = 0: where it has roots, and the sign of the slope there, against numbers.
"""

from __future__ import annotations

import itertools
import math

import pytest
import sympy as sp

from lagrange.algebra.closed_forms.signs import SignCondition
from lagrange.algebra.closed_forms.solution_sets import Branch
from lagrange.core.diagnostics import Source
from lagrange.document.derivation import Detail, Prose
from lagrange.explain.report import Report, report
from lagrange.explain.rest.equilibrium import explain_virtual_work
from lagrange.mechanics.constraints.classification import classify
from lagrange.mechanics.constraints.kinematics import file_configuration
from lagrange.mechanics.equilibrium.admissible_positions import (
    angles_with,
    beside_zero,
    place_as_drawn,
    slope,
    tangent_coefficients,
)
from lagrange.mechanics.equilibrium.stability import StabilityVerdict
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import read_problem
from lagrange.problem.model import Range
from lagrange.render import terminal
from lagrange.render.json import as_object
from tests.support import shared
from tests.support.problem_texts import places
from tests.support.statics_texts import CHAIN, CROSS_WIND, POLES_OF_A_CHOICE

PENDULUM = """title: Pendulum
axes: {{i: right, j: down}}
parameters: {{m: positive, l: positive, g: positive{more}}}
coordinates: {{theta: {{range: {range}}}}}
particles: {{P: {{mass: m, position: l*sin(theta)*i + l*cos(theta)*j}}}}
gravity: g*j
forces: {forces}
find: equilibrium
"""
SPRING = """title: Mass on a spring
axes: {{j: down}}
parameters: {{m: {{value: 1 kg}}, g: {{value: 10 m/s^2}}, k: {{value: {k}}}, a: {{value: 1 m}}}}
coordinates: {{x: {{range: {range}, unit: m}}}}
particles: {{P: {{mass: m, position: x*j}}}}
gravity: g*j
forces: {{s: {{potential: k*x^2/2}}}}
find: equilibrium
"""


def solved(text: str) -> Report:
    result = report(read_problem(Source("p.yaml", text)))
    assert result.holds, result.shortcomings
    return result


def equilibria(result: Report) -> list[list[str]]:
    found: list[list[str]] = as_object(result)["equilibrium"]
    return found


@pytest.mark.parametrize(
    ("limits", "inside"),
    [
        ("[-90 deg, 90 deg]", ["theta = 0"]),
        ("[90 deg, 270 deg]", ["theta = pi"]),
        ("[-180 deg, 180 deg]", ["theta = 0", "theta = pi"]),
        ("[-pi/3, 4*pi/3]", ["theta = 0", "theta = pi"]),
        ("[10 deg, 200 deg]", ["theta = pi"]),
        ("[-3, 3]", ["theta = 0"]),
        ("[1, 2]", []),
        ("[0, pi]", ["theta = 0", "theta = pi"]),
        ("[2*pi, 3*pi]", ["theta = 0", "theta = pi"]),  # modulo 2π
    ],
)
def test_equilibria_outside_of_the_range_are_left_out(limits: str, inside: list[str]) -> None:
    result = solved(PENDULUM.format(more="", range=limits, forces="{}").replace("forces: {}\n", ""))
    assert [e for [e] in equilibria(result)] == inside
    text = terminal.text(result.derivation, result.notation, 200, Detail.FULL)
    assert ("outside of the range" in text) == (len(inside) < 2)
    left_out = as_object(result).get("equilibrium_outside_ranges", [])
    assert len(left_out) + len(inside) == 2


@pytest.mark.parametrize(
    ("limits", "stated"),
    [
        ("[0, pi/2]", "theta = pi/4"),
        ("[-pi, 0]", "theta = -3*pi/4"),
        ("[-pi, pi]", "tan(theta) = 1"),  # two positions
        ("[pi, 2*pi]", "tan(theta) = 1"),  # 5π/4 is said modulo 2π
    ],
)
def test_the_one_angle_of_a_range_is_a_share_of_pi(limits: str, stated: str) -> None:
    text = PENDULUM.format(more="", range=limits, forces="{push: {on: P, vector: m*g*i}}")
    found = equilibria(solved(text))
    assert [e for [e] in found] == [stated]


ROD = """title: Rod in two slots, held by a spring
parameters: {{W: positive, k: positive, l: positive}}
coordinates: {{theta: {{range: {range}}}}}
particles: {{B: {{position: l*sin(theta)*i}}, G: {{position: l/2*cos(theta)*j}}}}
forces: {{weight: {{on: G, vector: {force}}}, spring: {{spring: k, between: [O, B]}}}}
find: equilibrium
"""


@pytest.mark.parametrize(
    ("limits", "force", "relation", "where"),
    [
        ("[0, 60 deg]", "-W*j", "cos(theta) = W/(2*k*l)", {"2*k*l >= W", "W >= k*l"}),
        ("[-60 deg, 60 deg]", "-W*j", "cos(theta) = W/(2*k*l)", {"2*k*l >= W", "W >= k*l"}),
        ("[0, 90 deg]", "-W*j", "cos(theta) = W/(2*k*l)", {"2*k*l >= W"}),
        ("[45 deg, 80 deg]", "-W*j", "cos(theta) = W/(2*k*l)", {"sqrt(2)*k*l >= W", "W >= 2*k*l*cos(4*pi/9)"}),
    ],
)
def test_the_range_of_an_angle_bounds_its_functions(limits: str, force: str, relation: str, where: set[str]) -> None:
    """By hand: W/2 = k l cos θ, and cos θ falls from 1 to 1/2 between 0 and 60°."""
    resting = solved(ROD.format(range=limits, force=force)).solution.own.equilibrium
    assert resting is not None
    [branch] = [b for b in resting.branches if b.conditions]
    assert [str(r.lhs) + " = " + str(r.rhs) for r in branch.relations] == [relation]
    assert {f"{c.lhs} {c.relation} {c.rhs}".replace("≥", ">=") for c in branch.conditions} == where


HALF = """title: A pendulum upright on an elastic cord
parameters: {m: positive, g: positive, l: positive, k: positive, s: positive}
coordinates: {theta: {range: [0, 180 deg]}}
particles: {P: {mass: m, position: l*sin(theta)*i + l*cos(theta)*j}}
gravity: -g*j
forces: {cord: {potential: k/2*(2*l*sin(theta/2) - s)^2}}
find: equilibrium
"""


def test_the_range_bounds_the_functions_of_half_an_angle() -> None:
    """By hand: l cos(θ/2) (2 (k l − m g) sin(θ/2) − k s) = 0, and sin(θ/2) lies between 0 and 1."""
    result = solved(HALF)
    resting, second = result.solution.own.equilibrium, result.solution.own.stability
    assert resting is not None
    assert second is not None
    [(branch, verdict)] = [(b, v) for b, v in zip(resting.branches, second.verdicts, strict=True) if b.conditions]
    m, g, l, k, s = (sp.Symbol(name, positive=True) for name in "mglks")
    assert [(c.lhs, c.relation, c.rhs) for c in branch.conditions] == [(2 * k * l, "≥", 2 * g * m + k * s)]
    assert verdict.verdict is StabilityVerdict.STABLE


def test_what_depends_on_the_one_angle_has_a_value() -> None:
    text = """title: two weights on a ring
parameters: {m: positive, g: positive, R: positive}
coordinates: {theta: {range: [0, pi/2]}, phi: {range: [0, pi/2]}}
particles:
  A: {mass: m, position: R*cos(theta)*i + R*sin(theta)*j}
  B: {mass: m, position: -R*cos(phi)*i + R*sin(phi)*j}
constraints: {rod: theta + phi = pi/2}
gravity: -g*j
find: [equilibrium]
"""
    assert equilibria(solved(text)) == [["theta = pi/4", "phi = pi/4"]]


def test_a_range_settles_the_stability() -> None:
    text = PENDULUM.format(more=", F: positive", range="[-90 deg, 90 deg]", forces="{push: {on: P, vector: F*i}}")
    result = solved(text)
    assert result.solution.own.stability is not None
    [verdict] = result.solution.own.stability.verdicts
    assert verdict.verdict is StabilityVerdict.STABLE
    without = solved(text.replace("{theta: {range: [-90 deg, 90 deg]}}", "[theta]"))
    assert without.solution.own.stability is not None
    assert without.solution.own.stability.verdicts[0].verdict is StabilityVerdict.CONDITIONAL


@pytest.mark.parametrize(("k", "limits", "number"), [("50 N/m", "[0, a]", 1), ("5 N/m", "[0, a]", 0),
                                                     ("50 N/m", "[0, 10 cm]", 0), ("5 N/m", "[1, 3]", 1)])  # fmt: skip
def test_lengths_within_their_range(k: str, limits: str, number: int) -> None:
    result = solved(SPRING.format(k=k, range=limits))
    found = as_object(result).get("equilibrium_in_numbers", [])
    assert len(found) == number
    if found:
        assert math.isclose(found[0]["coordinates"]["x"]["number"], 10 / float(k.split()[0]))


def test_a_range_that_depends_on_a_parameter_is_a_condition() -> None:
    result = solved(SPRING.format(k="50 N/m", range="[0, a]"))
    assert as_object(result)["equilibrium_conditions"] == [["a*k >= m*g"]]


def test_the_sign_of_a_cosine_in_its_range_is_a_condition() -> None:
    """cos x = k R/(2 (k R - W)) within 80 deg of 0 needs k R > W, and so k R >= 2 W; there V'' = 4 R (k R - W) sin(x)^2."""
    text = """title: collar on a vertical hoop
parameters: [W, k, R]
coordinates: {x: {range: [-80 deg, 80 deg]}}
particles: {P: {position: 2*R*cos(x)*(sin(x)*i - cos(x)*j)}}
forces:
  weight: {on: P, vector: -W*j}
  spring: {spring: k, between: [O, P], length: R}
"""
    result = as_object(solved(text))
    assert result["equilibrium_conditions"] == [[], ["k*R >= 2*W"]]
    assert result["stability"] == ["conditional", "stable"]


def test_the_conditions_of_a_branch_tell_on_which_side_it_lies() -> None:
    """On a table that turns, (k − m w²) r = k l for r > 0; k l/(m w² − k) has r < 0 where k > m w²."""
    result = solved("""title: Mass on a turning table
parameters: {m: positive, k: positive, l: positive, w: positive}
coordinates: {r: {range: [0, 10]}}
particles: {P: {mass: m, position: r*cos(w*t)*i + r*sin(w*t)*j}}
forces: {s: {spring: k, between: [O, P], length: l}}
find: linearization
""")
    [branch] = result.solution.own.linearization.branches
    assert [str(r.rhs) for r in branch.relations] == ["k*l/(k - m*w**2)"]
    conditions = {f"{c.lhs} {c.relation} {c.rhs}" for c in branch.conditions}
    assert conditions == {"10*k ≥ k*l + 10*m*w**2"}  # which implies k > m w²


@pytest.mark.parametrize("assume", ["acute", "{range: [1 deg, 89 deg]}"])
def test_an_acute_angle_needs_no_conditions(assume: str) -> None:
    text = f"""title: Block on a wedge
axes: {{i: right, j: up}}
parameters: {{m: positive, g: positive, mu: positive, alpha: {assume}}}
coordinates: [s, n]
particles: {{P: {{mass: m, position: "(s*cos(alpha) + n*sin(alpha))*i + (n*cos(alpha) - s*sin(alpha))*j"}}}}
constraints: {{plane: {{equation: n = 0, reaction: N}}}}
gravity: -g*j
forces: {{rub: {{friction: mu, constraint: plane, on: P}}}}
"""
    page = terminal.text(*(lambda r: (r.derivation, r.notation))(solved(text)), 100)
    assert "|cos α|" not in page
    assert "|cos α|" in terminal.text(
        *(lambda r: (r.derivation, r.notation))(solved(text.replace(assume, "positive"))), 100
    )


@pytest.mark.parametrize(
    ("declared", "code"),
    [
        ("parameters: {a: {range: [1]}}\ncoordinates: [x]", "bad-range"),
        ("parameters: {a: {range: [2, 1]}}\ncoordinates: [x]", "bad-range"),
        ("parameters: {a: {range: [-2, -1], assume: positive}}\ncoordinates: [x]", "bad-range"),
        ("parameters: {a: {range: [0 m, 1 kg], unit: m}}\ncoordinates: [x]", "unit-mismatch"),
        ("parameters: {a: {range: [0, 1], value: 2}}\ncoordinates: [x]", "value-against-assumption"),
        ("parameters: {a: {assume: acute, value: 100 deg}}\ncoordinates: [x]", "value-against-assumption"),
        ("parameters: [l]\ncoordinates: {x: {range: [0, q]}}", "unknown-symbol"),
        ("parameters: {l: acut}\ncoordinates: [x]", "unknown-assumption"),
    ],
)
def test_ranges_that_cannot_be_used(declared: str, code: str) -> None:
    assert [found for found, *_ in places(f"title: T\n{declared}\n")] == [code]


def test_an_answer_in_letters_is_right_whatever_the_values() -> None:
    """With P = 150 N > k l the stated branch has no position, and the answer in letters is right all the same."""
    solved(
        "title: Column\naxes: {j: up}\ncoordinates: [theta]\nfind: equilibrium\n"
        "parameters: {k: {value: 200 N/m}, l: {value: 50 cm}, P: {value: 150 N}}\n"
        "particles: {A: {position: l*sin(theta)*i + l*cos(theta)*j}}\n"
        "forces: {load: {on: A, vector: -P*j}, spring: {potential: k*l^2*sin(theta)^2/2}}\n"
        'answers: {equilibrium: [["theta = 0"], ["theta = pi"], ["cos(theta) = P/(k*l)"]]}\n'
    )


# Chart poles


CYLINDRICAL = """
title: A force in cylindrical coordinates
parameters: [F, k]
coordinates: [rho, phi]
particles: {P: {mass: 1, position: rho*cos(phi)*i + rho*sin(phi)*j}}
forces:
  centre: {potential: k*rho^2/2}
  push: {on: P, vector: F*i}
find: equilibrium
"""
SPHERICAL = """
title: Spherical pendulum
parameters: [m, g, l]
coordinates: [theta, phi]
particles: {P: {mass: m, position: l*sin(theta)*cos(phi)*i + l*sin(theta)*sin(phi)*j - l*cos(theta)*k}}
gravity: -g*k
find: equilibrium
"""
TORSION = "forces: {spring: {potential: m*g*l*(phi - 1)^2}}"
CRANK = """
title: Crank and slider pushed towards the axis
parameters: [F, l, r]
coordinates: [phi, psi]
particles:
  A: {position: l*cos(phi)*i}
  B: {position: r*cos(psi)*i}
forces: {push: {on: A, vector: -F*i}, pull: {on: B, vector: F*i}}
"""


def idle(text: str) -> list[str]:
    e = solve(read_problem(Source("problem.yaml", text))).own.equilibrium
    assert e is not None
    return [" ".join(map(str, names)) for names in e.idle]


@pytest.mark.parametrize(
    ("text", "names"),
    [
        (CYLINDRICAL, ["", ""]),  # ρ = ±F/k; and ρ = 0 with φ = ±π/2 is no equilibrium
        (SPHERICAL, ["phi", "phi"]),
        (SPHERICAL + TORSION, ["phi", "phi"]),
        (CROSS_WIND, ["", ""]),
        (CHAIN, [""]),
        (CRANK, ["", "", "", ""]),  # dead centres: δφ moves nothing at φ = 0, but φ has a position of its own
    ],
)
def test_coordinates_that_move_nothing(text: str, names: list[str]) -> None:
    assert idle(text) == names


def words(text: str) -> str:
    e = solve(read_problem(Source("problem.yaml", text))).own.equilibrium
    assert e is not None
    blocks = explain_virtual_work(e, None).body
    return " ".join(p for b in blocks if isinstance(b, Prose) for p in b.parts if isinstance(p, str))


def test_it_is_said() -> None:
    """Without a horizontal force every φ serves at the pole; with one the pole is no equilibrium of a free particle."""
    assert "the coordinates are singular there" in words(SPHERICAL)
    assert "fixed by other means" not in words(SPHERICAL)
    assert "no equilibri" in words(CYLINDRICAL)
    assert "fixed by other means" in words(SPHERICAL + TORSION)
    assert "singular" not in words(CHAIN)


BOWL = """
title: A bowl
parameters: [k, c]
coordinates: [{coordinates}]
let: {{X: {X}, Y: {Y}}}
particles: {{P: {{mass: 1, position: X*i + Y*j{more}}}}}
forces: {{field: {{potential: {potential}}}}}
find: equilibrium
"""
POLAR = {"coordinates": "rho, phi", "X": "rho*cos(phi)", "Y": "rho*sin(phi)", "more": ""}
CARTESIAN = {"coordinates": "x, y", "X": "x", "Y": "y", "more": ""}
ON_A_CART = {"coordinates": "z, rho, phi", "X": "rho*cos(phi)", "Y": "rho*sin(phi)", "more": " + z*k"}
CARTESIAN_ON_A_CART = {"coordinates": "z, x, y", "X": "x", "Y": "y", "more": " + z*k"}


def verdict_at_rest(chart: dict[str, str], potential: str) -> tuple[str, set[str]]:
    """The verdict on the place where all but an azimuth vanishes, and the conditions, without their sides."""
    solution = solve(read_problem(Source("problem.yaml", BOWL.format(potential=potential, **chart))))
    e, second = solution.own.equilibrium, solution.own.stability
    assert e is not None
    assert second is not None
    [found] = [s for b, s in zip(e.branches, second.verdicts, strict=True) if all(r.rhs == 0 for r in b.relations)]
    assert solution.holds
    return found.verdict.value, {str(abs(sp.factor(c.lhs - c.rhs).subs({"k": 1, "c": 3}))) for c in found.conditions}


@pytest.mark.parametrize(
    "potential",
    [
        "k*X^2/2 + k*Y^2/2",
        "-k*X^2/2 - c*Y^2/2",
        "k*X^2/2 - c*Y^2/2",
        "k*X^2 + k*Y^2 + c*X*Y",
        "k*X^2 + c*Y^2 + (k + c)*X*Y",
    ],
)
def test_stability_at_a_pole_is_that_in_cartesian_coordinates(potential: str) -> None:
    assert verdict_at_rest(POLAR, potential) == verdict_at_rest(CARTESIAN, potential)


@pytest.mark.parametrize("potential", ["k*X^2 + k*Y^2 + k*z^2 - k*z*X", "k*X^2 + k*Y^2 + k*z^2 - 3*k*z*X"])
def test_stability_at_a_pole_beside_another_coordinate(potential: str) -> None:
    assert verdict_at_rest(ON_A_CART, potential) == verdict_at_rest(CARTESIAN_ON_A_CART, potential)


def test_without_all_directions_nothing_is_decided() -> None:
    """With Y = X φ no displacement along j is among the δX, and V = k X² would seem to have a strict minimum."""
    fan = {"coordinates": "x, phi", "X": "x", "Y": "x*phi", "more": ""}
    assert verdict_at_rest(fan, "k*X^2")[0] == "undecided"


def test_the_poles_of_a_choice_are_no_equilibria_where_the_forces_do_not_balance() -> None:
    """At θ = 0, φ = ±π/2 Q_θ and Q_φ vanish, but nothing balances the force along i."""
    solution = solve(read_problem(Source("problem.yaml", POLES_OF_A_CHOICE)))
    [choice] = solution.choices
    e = choice.equilibrium
    assert e is not None
    assert [len(e.branches), len(e.poles)] == [2, 4]
    assert all(r.lhs.has(sp.tan) or r.lhs.name == "phi" for b in e.branches for r in b.relations)
    assert solution.holds
    said = " ".join(
        p for b in explain_virtual_work(e, None).body if isinstance(b, Prose) for p in b.parts if isinstance(p, str)
    )
    assert "no equilibri" in said


def test_without_a_horizontal_force_the_poles_of_a_choice_are_equilibria() -> None:
    text = POLES_OF_A_CHOICE.replace("vector: F*i", "vector: -F*k")
    [choice] = solve(read_problem(Source("problem.yaml", text))).choices
    assert choice.equilibrium is not None
    assert [len(choice.equilibrium.branches), len(choice.equilibrium.poles)] == [2, 0]


SLIDER = """
title: A slider, with an angle for its place
parameters: [a, k, F]
coordinates: [x]
particles: {P: {position: x*i}}
forces: {push: {on: P, vector: F*i}, spring: {potential: k*x^2/2}}
generalized_coordinates: {angle: {coordinates: [theta], substitute: {x: a*cos(theta)}}}
find: equilibrium
"""


def test_the_edge_of_a_choice_is_no_equilibrium() -> None:
    """x = a cos θ has no displacement at θ = 0 and π, where F = k x does not hold."""
    solution = solve(read_problem(Source("problem.yaml", SLIDER)))
    assert all(c.passed for c in solution.checks)
    [view] = solution.choices
    assert view.equilibrium is not None
    assert [str(r.lhs) for b in view.equilibrium.branches for r in b.relations] == ["cos(theta)"]
    assert [str(r.rhs) for b in view.equilibrium.poles for r in b.relations] == ["0", "pi"]


def test_a_dead_centre_is_named() -> None:
    """In the file's own coordinate θ may be the angle of a crank: then any force balances at θ = 0."""
    crank = SLIDER[: SLIDER.index("generalized")].replace("coordinates: [x]", "coordinates: [theta]")
    crank = crank.replace("x*i", "a*cos(theta)*i").replace("k*x^2/2", "k*a^2*cos(theta)^2/2")
    told = report(read_problem(Source("problem.yaml", crank + "find: equilibrium\n")))
    assert told.solution.own.equilibrium is not None
    assert told.solution.own.equilibrium.dead_centres == (0, 1)
    page = " ".join(terminal.text(told.derivation, told.notation, 100).split())
    assert "moves nothing to first order, so any forces balance there: a dead centre" in page


# Tangent equation


q = sp.Symbol("theta", real=True)
R, h = sp.symbols("R h", positive=True)


def branch(e: sp.Expr) -> Branch:
    return Branch((), (SignCondition(q, "≠", sp.S.Zero),), left=(e,))


def test_roots_exist_under_a_condition() -> None:
    found = beside_zero(branch(h * sp.sin(q) - R * q * sp.cos(q)), q)
    assert found is not None
    assert found.occupied
    assert found.conditions == (SignCondition(R, ">", h), SignCondition(q, "≠", sp.S.Zero))


@pytest.mark.parametrize("ratio", [sp.Rational(1, 2), sp.S.One, sp.Rational(11, 10), sp.Integer(4), -sp.S.One])
@pytest.mark.parametrize("a", [2, -3])
def test_numbers(ratio: sp.Rational, a: int) -> None:
    e = a * (sp.sin(q) - ratio * q * sp.cos(q))
    value = sp.lambdify(q, e, "math")
    grid = [0.001 * n for n in range(1, 1571)]
    changes = [x for x, y in itertools.pairwise(grid) if value(x) * value(y) < 0]
    found = beside_zero(branch(e), q)
    assert (found is not None) == bool(changes)
    for x in changes:
        rise, sign = slope(e, q) or (sp.S.Zero, 0)
        assert math.copysign(1, value(x + 0.01) - value(x - 0.01)) == sign
        assert float(rise.subs(q, x)) == pytest.approx((value(x + 1e-4) - value(x - 1e-4)) / 2e-4, rel=0.05)


@pytest.mark.parametrize("e", [sp.sin(q) - q, h * sp.sin(2 * q) - R * q * sp.cos(q), sp.sin(q) - q**2 * sp.cos(q)])
def test_other_equations_are_left_as_they_are(e: sp.Expr) -> None:
    assert tangent_coefficients(e, q) is None
    assert beside_zero(branch(e), q) == branch(e)


@pytest.mark.parametrize(
    ("wave", "value", "low", "high", "angles"),
    [
        (sp.cos, "1/2", "0", "pi", {"pi/3"}),
        (sp.cos, "1/2", "-pi/2", "pi/2", {"pi/3", "-pi/3"}),
        (sp.cos, "1/2", "3*pi/2", "2*pi", {"5*pi/3"}),
        (sp.cos, "-1", "0", "pi", {"pi"}),
        (sp.sin, "1/2", "0", "pi/2", {"pi/6"}),
        (sp.sin, "1/2", "0", "pi", {"pi/6", "5*pi/6"}),
        (sp.sin, "1", "0", "pi", {"pi/2"}),
        (sp.tan, "-1", "0", "pi", {"3*pi/4"}),
        (sp.tan, "1", "0", "2*pi", {"pi/4", "5*pi/4"}),
        (sp.sin, "3/2", "0", "pi", set()),
        (sp.cos, "x", "0", "pi", set()),
    ],
)
def test_all_angles_in_a_range(wave: type[sp.Function], value: str, low: str, high: str, angles: set[str]) -> None:
    of = sp.sympify
    found = angles_with(wave(sp.Symbol("q")), of(value), Range(of(low), of(high)))
    assert len(found) == len(angles)
    assert {*found} == {*map(of, angles)}


def test_places_are_told_in_degrees_one_or_two_as_the_range_admits() -> None:
    text = """
title: A bracket
parameters: {W: {value: 120 N}, l: {value: 1.5 m}, h: {value: 0.8 m}, c: {value: 1.5 m}}
coordinates: {theta: {range: LIMITS}}
particles: {B: {position: l*sin(theta)*i + l*cos(theta)*j}}
constraints: {cable: {equation: norm(r_B - h*j) = c, by: string, reaction: T}}
forces: {load: {on: B, vector: -W*j}}
find: equilibrium
"""
    for limits, both in (("[0, pi]", False), ("[-pi/2, pi/2]", True)):  # cos theta = 4/15
        made = report(read_problem(Source("bracket.yaml", text.replace("LIMITS", limits))))
        page = terminal.text(made.derivation, made.notation, 100)
        assert "θ ≈ 74.53°" in page
        assert ("θ ≈ −74.53°" in page) is both
        assert "cos θ ≈ 0.2667" in page


def test_half_an_angle_tells_a_position_from_that_a_turn_away() -> None:
    """With θ/2 in the forces θ = −π is not θ = π: it is outside of 0 ≤ θ ≤ π."""
    text = """
title: Ring on a hoop, drawn to the top
parameters: [P, Q, R]
coordinates: {theta: {range: [0, pi]}}
particles:
  ring: {position: R*sin(theta)*i + R*cos(theta)*j}
  load: {position: 2*R*sin(theta/2)*j}
forces: {w1: {on: ring, vector: -P*j}, w2: {on: load, vector: -Q*j}}
find: equilibrium
"""
    solved = report(read_problem(Source("ring.yaml", text))).solution.own.equilibrium
    assert solved is not None
    theta = sp.Symbol("theta", real=True)
    assert [r.rhs for b in solved.branches for r in b.relations if r.lhs == theta] == [sp.pi]


HUNG = """title: Beam on two strings
parameters: [a, b, c, W, P]
coordinates: [x, y, theta]
bodies: {beam: {position: x*i + y*j, angle: theta}}
constraints:
  one: {equation: norm(r_beam - b*e1_beam + b*i - H) = a, reaction: T_1}
  two: {equation: norm(r_beam + b*e1_beam - b*i - H) = a, reaction: T_2}
forces: {weight: {on: beam, vector: -W*j}, load: {on: beam, vector: -P*j, at: r_beam + c*e1_beam}}
find: equilibrium
"""


@pytest.mark.parametrize(("place", "zero"), [("a*j", ("x", "y", "sin(theta)")), ("0*j", ("sin(theta)",))])
def test_the_position_in_which_a_beam_is_drawn(place: str, zero: tuple[str, ...]) -> None:
    """Level at x = y = 0 below the points (∓b, a); about the points themselves only θ = 0 is known beforehand."""
    problem = read_problem(Source("hung.yaml", HUNG.replace("H", place)))
    [tried] = place_as_drawn(file_configuration(problem, classify(problem).constrained))
    assert tuple(map(str, tried)) == zero


def test_the_range_of_a_replaced_coordinate_bounds_the_equilibria() -> None:
    """A rod of length 2a reaches the rim where 2r cos θ ≤ 2a: with 4r cos² θ − a cos θ − 2r = 0, where a ≥ √(2/3) r."""
    for branches in (v.equilibrium.branches for v in shared.solved("rod-in-bowl").views if v.equilibrium is not None):
        [b] = branches
        for a, exists in ((0.5, False), (0.81, False), (0.82, True), (1.9, True), (2.1, False)):
            values = {s: a if s.name == "a" else 1 for c in b.conditions for s in (c.lhs - c.rhs).free_symbols}
            assert all((c.lhs - c.rhs).xreplace(values) >= 0 for c in b.conditions) is exists
