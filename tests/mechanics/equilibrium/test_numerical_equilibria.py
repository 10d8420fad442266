"""Equilibria without a closed form, against the potential energy in plain Python.

How far rods reach, and their angles.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import pairwise
from typing import Any

import pytest
import sympy as sp

from lagrange.core.diagnostics import Source
from lagrange.explain.report import Report, report
from lagrange.mechanics.equilibrium.numerical_equilibria import angles_of_links, reach_of_links, two_lengths
from lagrange.mechanics.equilibrium.stability import StabilityVerdict
from lagrange.problem.loader import read_problem
from lagrange.render import terminal
from lagrange.render.json import as_object
from lagrange.values import numerical_roots

TORSION = """title: Inverted pendulum with a torsion spring
axes: {i: right, j: up}
parameters: {W: {value: 30 N}, l: {value: 50 cm}, c: {value: 5 N m}}
coordinates: [theta]
particles: {A: {position: l*sin(theta)*i + l*cos(theta)*j}}
forces: {load: {on: A, vector: -W*j}, spring: {potential: c*theta^2/2}}
find: equilibrium
"""
ROD = """title: Rod with a spring to a point
axes: {i: right, j: down}
parameters: {W: {value: 20 N}, l: {value: 1 m}, k: {value: 30 N/m}, d: {value: 60 cm}}
coordinates: [theta]
particles: {A: {position: l*sin(theta)*i + l*cos(theta)*j}}
forces: {load: {on: A, vector: W*j}, s: {spring: k, between: [A, 2*l*i], length: d}}
find: equilibrium
"""
BARS = """title: Two bars with torsion springs
axes: {i: right, j: up}
parameters: {W: {value: 30 N}, F: {value: 3 N}, l: {value: 50 cm}, c: {value: 5 N m}}
coordinates: {a: {range: [-3, 3]}, b: {range: [-3.5, 3.5]}}
particles: {B: {position: l*(sin(a) + sin(b))*i + l*(cos(a) + cos(b))*j}}
forces: {load: {on: B, vector: -W*j + F*i}, s1: {potential: c*a^2/2}, s2: {potential: c*(b - a)^2/2}}
find: equilibrium
"""


def reported(text: str) -> Report:
    return report(read_problem(Source("p.yaml", text)))


def positions(result: Report) -> list[dict[str, Any]]:
    found: list[dict[str, Any]] = as_object(result)["equilibrium_in_numbers"]
    return found


def rod(v: float) -> float:
    length = math.hypot(2 - math.sin(v), math.cos(v))
    return -20 * math.cos(v) + 30 * (length - 0.6) ** 2 / 2


@pytest.mark.parametrize(
    ("text", "potential", "limit", "searched"),
    [
        (TORSION, lambda v: 5 * v * v / 2 + 15 * math.cos(v), 4 * math.pi, [-4 * math.pi, 4 * math.pi]),
        (TORSION.replace("[theta]", "{theta: {range: [-1, 3]}}"), None, 3, [-1, 3]),
        (ROD, rod, math.pi, [-math.pi, math.pi]),
    ],
)
def test_one_unknown(
    text: str, potential: Callable[[float], float] | None, limit: float, searched: list[float]
) -> None:
    result = reported(text)
    assert result.holds
    found = positions(result)
    information = as_object(result)["equilibrium_searched"]
    assert information["complete"]
    assert information["between"]["theta"] == pytest.approx(searched)
    if potential is None:
        assert sorted(p["coordinates"]["theta"]["number"] for p in found) == pytest.approx([0, 2.2788626600758284])
        return
    step = 1e-4
    grid = [-limit + 2 * limit * (n + 0.37) / 9001 for n in range(9001)]
    slopes = [(potential(v + step) - potential(v - step)) / (2 * step) for v in grid]
    expected = [
        (v, "stable" if b > a else "unstable") for v, a, b in zip(grid, slopes, slopes[1:], strict=False) if a * b < 0
    ]
    listed = sorted((p["coordinates"]["theta"]["number"], p["stability"]) for p in found)
    assert [s for _, s in listed] == [s for _, s in expected]
    assert [v for v, _ in listed] == pytest.approx([v for v, _ in expected], abs=2 * limit / 9001)
    assert "numerical" in terminal.text(result.derivation, result.notation, 100)


def test_multipliers_are_no_unknowns() -> None:
    """A particle on a sphere, in Cartesian coordinates: the gradient of V is normal to the sphere at each position."""
    text = """title: Particle on a sphere, with a spring
parameters: {m: {value: 1 kg}, g: {value: 9.81 m/s^2}, R: {value: 1 m}, c: {value: 20 N/m}}
coordinates: [x, y, z]
particles: {P: {mass: m, position: x*i + y*j + z*k}}
constraints: {sphere: x^2 + y^2 + z^2 = R^2}
gravity: -g*k
forces: {s: {spring: c, between: [P, 2*R*i], length: R/2}}
find: equilibrium
"""
    found = as_object(reported(text))
    assert found["equilibrium_searched"]["complete"]

    def pull(angle: float) -> float:
        """The force along the circle y = 0 at x = cos φ, z = sin φ."""
        x, z = math.cos(angle), math.sin(angle)
        length = math.hypot(2 - x, z)
        tension = 20 * (length - 0.5) / length
        return -tension * (2 - x) * z - (tension * z + 9.81) * x

    signs = []
    for n in range(360):
        a, b = (math.radians(d) for d in (n - 180.5, n - 179.5))
        if pull(a) * pull(b) <= 0:
            signs.append((math.cos((a + b) / 2), "stable" if pull(a) > pull(b) else "unstable"))
    shown = [(p["coordinates"]["x"]["number"], p["stability"]) for p in found["equilibrium_in_numbers"]]
    assert [s for _, s in shown] == [s for _, s in sorted(signs)] == ["unstable", "stable"]
    assert all(abs(a - b) < 0.02 for (a, _), (b, _) in zip(shown, sorted(signs), strict=True))


def test_two_unknowns() -> None:
    result = reported(BARS)
    found = positions(result)

    def energy(a: float, b: float) -> float:
        return 15 * (math.cos(a) + math.cos(b)) - 1.5 * (math.sin(a) + math.sin(b)) + 2.5 * (a * a + (b - a) ** 2)

    assert [p["stability"] for p in found].count("stable") >= 1
    assert as_object(result)["equilibrium_searched"]["complete"]
    for p in found:
        a, b = (p["coordinates"][q]["number"] for q in "ab")
        h = 1e-4
        slope = (energy(a + h, b) - energy(a - h, b)), (energy(a, b + h) - energy(a, b - h))
        assert slope == pytest.approx((0, 0), abs=1e-9)
        aa, bb = (
            (energy(a + s * h, b + t * h) - 2 * energy(a, b) + energy(a - s * h, b - t * h)) / h**2
            for s, t in ((1, 0), (0, 1))
        )
        ab = (energy(a + h, b + h) - energy(a + h, b - h) - energy(a - h, b + h) + energy(a - h, b - h)) / (4 * h * h)
        assert (p["stability"] == "stable") == (aa > 0 and aa * bb > ab * ab)


def test_without_values_nothing_is_searched() -> None:
    result = reported(TORSION.replace("W: {value: 30 N}", "W: positive"))
    assert "equilibrium_searched" not in as_object(result)


OVER_A_CYLINDER = """title: Rod over a cylinder
axes: {i: right, j: up}
parameters: {W: N, a: {value: 0.5 m}, r: {value: 0.2 m}}
coordinates: {theta: {range: [0, 89 deg]}}
particles: {G: {position: a*cos(theta)*i + (r/cos(theta) - a*sin(theta))*j}}
forces: {weight: {on: G, vector: -W*j}}
find: equilibrium
"""


@pytest.mark.parametrize(
    "text",
    [
        OVER_A_CYLINDER,
        OVER_A_CYLINDER.replace("{theta: {range: [0, 89 deg]}}", "{theta: {range: [0, 89 deg]}, y: {}}")
        .replace("r/cos(theta)", "y")
        .replace("forces:", "constraints: {touch: y*cos(theta) = r}\nforces:"),
    ],
)
def test_a_load_without_a_value_changes_no_position(text: str) -> None:
    """r sin θ = a cos³ θ, whatever W is."""
    [place] = positions(reported(text))
    at = place["coordinates"]["theta"]["number"]
    assert 0.2 * math.sin(at) == pytest.approx(0.5 * math.cos(at) ** 3)
    assert place["stability"] == "stable"


def test_a_load_without_a_value_beside_another_force_is_no_reason_to_leave_a_place_out() -> None:
    text = OVER_A_CYLINDER.replace("W: N,", "W: N, F: N,").replace(
        "coordinates: {", "coordinates: {phi: {range: [-30 deg, 30 deg]}, "
    ).replace("forces: {", "forces: {field: {potential: -F*cos(phi)}, ")  # fmt: skip
    result = reported(text)
    [place] = positions(result)
    assert place["coordinates"]["theta"]["number"] == pytest.approx(0.83961, abs=1e-5)
    assert place["coordinates"]["phi"]["number"] == 0
    equilibrium = result.solution.own.equilibrium
    assert equilibrium is not None
    assert len(equilibrium.branches) == 1, "φ = π is outside of the range, although θ is not found in closed form"


def test_conditions_without_parameters() -> None:
    result = reported("""title: t
coordinates: [x]
particles: {P: {position: x*i}}
forces: {f: {potential: x^2/2 + cos(2*x)}}
find: equilibrium
""")
    found = sorted(p["coordinates"]["x"]["number"] for p in positions(result))
    assert len(found) == 3
    assert [2 * math.sin(2 * v) for v in found] == pytest.approx(found)


def test_a_bounded_search_says_that_it_may_be_incomplete(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(numerical_roots, "MOST_BOXES", 10)
    result = reported(TORSION)
    assert not as_object(result)["equilibrium_searched"]["complete"]
    assert "may be incomplete" in " ".join(terminal.text(result.derivation, result.notation, 300).split())


# Reach of links


x, y, u, v = sp.symbols("x y u v", real=True)
UPPER = x**2 + y**2 - sp.Rational(1, 4)
LOWER = (u - x) ** 2 + (v - y) ** 2 - 1


def test_points_on_a_chain_of_rods_reach_as_far_as_the_rods() -> None:
    half, both = sp.Rational(1, 2), sp.Rational(3, 2)
    assert reach_of_links([LOWER, UPPER], [x, y, u, v]) == {x: half, y: half, u: both, v: both}
    swapped = reach_of_links([-LOWER, -3 * UPPER], [x, y, u, v])  # l² = x² + y²
    assert swapped == {x: half, y: half, u: both, v: both}
    assert reach_of_links([x**2 - y**2 - 1, x * y - 1], [x, y]) == {}


def test_the_constraints_hold_for_all_angles_of_the_rods() -> None:
    places = angles_of_links([LOWER, UPPER], [x, y, u, v])
    assert places is not None
    assert [sp.simplify(e.xreplace(places)) for e in (UPPER, LOWER)] == [0, 0]
    assert angles_of_links([UPPER, x + u - 1], [x, y, u, v]) is None
    assert angles_of_links([x**2 + 2 * y**2 - 1], [x, y]) is None


SWINGING = """title: A spring along a rod that swings
parameters: {m: {value: 2 kg}, M: {value: 0.5 kg}, b: {value: 0.6 m}, k: {value: 80 N/m}, l_0: {value: 0.5 m}}
coordinates: {r: {}, theta: {range: [-3, 3]}}
let: {u: "sin(theta)*i - cos(theta)*j"}
particles: {bead: {position: r*u}, rod: {position: b*u}}
forces:
  coil: {spring: k, between: [O, bead], length: l_0}
  load: {on: bead, vector: -9.81*M*j}
  weight: {on: rod, vector: -9.81*m*j}
  turn: {potential: 2*theta^2}
find: equilibrium
"""
"""With g = 9.81 m/s² put in."""


def test_a_sign_that_jumps_parts_the_search() -> None:
    result = reported(SWINGING)
    found = [(f["coordinates"]["r"]["number"], f["coordinates"]["theta"]["number"]) for f in positions(result)]

    def moment(turned: float, side: int) -> float:
        r = side * 0.5 + 0.5 * 9.81 * math.cos(turned) / 80
        return 9.81 * (0.5 * r + 1.2) * math.sin(turned) + 4 * turned

    grid = [n / 1000 + 0.0005 for n in range(-3000, 3000)]
    roots = [(s, a) for s in (1, -1) for a, b in pairwise(grid) if moment(a, s) * moment(b, s) < 0]
    assert len(found) == len(roots)
    for side, turned in roots:
        assert any(r * side > 0 and abs(at - turned) < 0.002 for r, at in found)
    assert "excludes the rest of this range" in " ".join(terminal.text(result.derivation, result.notation, 80).split())


def test_angles_a_full_turn_apart_are_one_place() -> None:
    """(x − 1)(x⁵ + x + 3) sin θ: x = 1 is found in closed form, and with θ = π again by search."""
    text = """title: Two independent balances
parameters: {W: {value: 2}}
coordinates: [x, theta]
forces: {wave: {potential: W*cos(theta) + x^7/7 - x^6/6 + x^3/3 + x^2 - 3*x}}
find: equilibrium
"""
    assert sorted(f["how"] for f in positions(reported(text))) == ["exact", "exact", "numerical", "numerical"]


STRING = """title: Two weights on a string
axes: {i: right, j: down}
parameters: {W: {value: 80 N}, a: {value: 50 cm}, b: {value: 60 cm}, d: {value: 120 cm}}
coordinates: {x_1: {unit: m}, y_1: {unit: m}, x_2: {unit: m}, y_2: {unit: m}}
particles: {B: {position: x_1*i + y_1*j}, C: {position: x_2*i + y_2*j}}
constraints:
  AB: {equation: norm(r_B) <= a, reaction: T_1}
  BC: {equation: norm(r_C - r_B) <= b, reaction: T_2}
  CD: {equation: norm(r_C - d*i) <= a, reaction: T_3}
forces: {left: {on: B, vector: W*j}, right: {on: C, vector: W*j}}
find: equilibrium
"""
NAIL = """title: Uneven rod slung over a nail
axes: {i: right, j: up}
parameters: {W: {value: 80 N}, a: {value: 40 cm}, b: {value: 20 cm}, L: {value: 90 cm}}
coordinates: {x: {unit: m}, y: {unit: m}, theta: {}}
bodies: {rod: {position: x*i + y*j, angle: theta}}
constraints:
  string: {equation: norm(r_rod - a*e1_rod) + norm(r_rod + b*e1_rod) <= L, reaction: T, by: string}
forces: {weight: {on: rod, vector: -W*j}}
find: equilibrium
"""


def test_a_chain_of_strings_between_two_pegs() -> None:
    """The polygon with slopes 4/3, 0, −4/3: T = W/0.8 in the outer strings, 0.6 of that between the weights."""
    numbers = reported(STRING).solution.own.in_numbers
    assert numbers is not None
    [only] = numbers.positions
    assert [round(float(x.formula), 12) for x in only.coordinates.values()] == [0.3, 0.4, 0.9, 0.4]
    assert only.stability is StabilityVerdict.STABLE
    assert {str(f): round(float(x.formula), 9) for f, x in only.forces.items()} == {"T_1": 100, "T_2": 60, "T_3": 100}
    assert all(x.formula < 0 for p in numbers.slack for f, x in p.forces.items() if str(f) in ("T_1", "T_3"))


def test_a_rod_slung_over_a_nail() -> None:
    """Oblique with OA = L a/(a + b), unstable; upright with either end below, stable with T = W/2.

    OA = 0.6 m and OB = 0.3 m, so OG² = OA·OB − a b, and T = W/(2 cos φ) with cos 2φ = 1/4 at the nail.
    """
    explained = reported(NAIL)
    numbers = explained.solution.own.in_numbers
    assert numbers is not None
    found = {
        (*(round(float(x.formula), 6) for x in (*p.coordinates.values(), *p.forces.values())), p.stability)
        for p in numbers.positions
    }
    depth, turn = math.sqrt(0.6 * 0.3 - 0.4 * 0.2), math.pi / 2
    inclined = math.asin((0.6**2 - 0.4**2 - depth**2) / (2 * 0.4 * depth))
    expected = [
        (0, -depth, inclined, 40 / math.sqrt(0.625), StabilityVerdict.UNSTABLE),
        (0, -depth, math.pi - inclined, 40 / math.sqrt(0.625), StabilityVerdict.UNSTABLE),
        (0, -0.35, turn, 40, StabilityVerdict.STABLE),
        (0, -0.55, -turn, 40, StabilityVerdict.STABLE),
    ]
    assert found == {(*(round(x, 6) for x in place), verdict) for *place, verdict in expected}
    page = terminal.text(explained.derivation, explained.notation, 90)
    assert "with x = 0, y ≈ −0.5500 m and T ≈ 40.00 N; stable" in " ".join(page.split())


def test_two_lengths_with_a_given_sum() -> None:
    """√A + √B = L with L² = 9 for A = 1 and B = 4: both follow from L and A − B."""
    x, y = sp.symbols("x y", real=True)
    two = two_lengths(sp.sqrt(x) + sp.sqrt(y) - 3, (x, y))
    assert two is not None
    at = {x: 1, y: 4}
    assert [v.xreplace(at) for v in two.values.values()] == [1, 2]
    assert two.square.xreplace(at) == 0
    assert [b.xreplace(at) for b in two.bounds] == [-8, -5]
    assert two_lengths(sp.sqrt(x) + x * sp.sqrt(y) - 3, (x, y)) is None
