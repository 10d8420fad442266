"""Systems of constraints: ranks of derived flags that are known, and the same by symbolic Lie brackets."""

from __future__ import annotations

import math
import random
from dataclasses import dataclass
from functools import cache
from itertools import pairwise

import pytest
import sympy as sp

from lagrange.algebra.forms.derived_flag import derived_flag, manoeuvre
from lagrange.core.symbols import Slots, Unspecified, prime, t
from tests.support.exterior import flag_by_brackets

x, y, z, w, theta, phi, psi = sp.symbols("x y z w theta phi psi", real=True)
p, q, phi1, phi2 = sp.symbols("p q phi1 phi2", real=True)
x1, y1, z1, x2, y2, z2 = ends = sp.symbols("x1 y1 z1 x2 y2 z2", real=True)
u = sp.Symbol("u", real=True)
R, b, length, omega = sp.symbols("R b l omega", positive=True)
sin, cos = sp.sin, sp.cos

Row = dict[sp.Symbol, object]


@dataclass(frozen=True)
class System:
    name: str
    coordinates: tuple[sp.Symbol, ...]
    rows: tuple[Row, ...]
    ranks: tuple[int, ...]
    on: tuple[sp.Expr, ...] = ()
    prescribed: tuple[sp.Symbol, ...] = ()
    symbolic: bool = True

    @property
    def variables(self) -> tuple[sp.Symbol, ...]:
        return (*self.coordinates, t)

    @property
    def slots(self) -> Slots:
        return Slots(self.coordinates, self.prescribed)

    @property
    def forms(self) -> list[list[sp.Expr]]:
        return [[sp.sympify(row.get(v, 0)) for v in self.variables] for row in self.rows]


def trailers(n: int) -> System:
    """A car's rear axle and n trailers, each hitched to the axle before it: no axle moves sideways."""
    angles = sp.symbols(f"theta0:{n + 1}", real=True)
    lengths = sp.symbols(f"l1:{n + 1}", positive=True)
    coordinates = (x, y, *angles)
    rows: list[Row] = []
    px, py = x, y
    for k, angle in enumerate(angles):
        if k:
            px, py = px - lengths[k - 1] * cos(angle), py - lengths[k - 1] * sin(angle)
        rows.append({v: sin(angle) * sp.diff(px, v) - cos(angle) * sp.diff(py, v) for v in coordinates})
    name = f"car with {n} trailers"
    return System(name, coordinates, tuple(rows), tuple(range(n + 1, -1, -1)), symbolic=n < 2)


def rolling_ball(spinning: bool) -> System:
    """A ball on a plane, Euler angles ψ (about k), θ, φ (Neimark and Fufaev, Nonholonomic Systems)."""
    turning_x = {theta: cos(psi), phi: sin(theta) * sin(psi)}
    turning_y = {theta: sin(psi), phi: -sin(theta) * cos(psi)}
    rows: list[Row] = [
        {x: 1, **{v: -R * c for v, c in turning_y.items()}},
        {y: 1, **{v: R * c for v, c in turning_x.items()}},
    ]
    if not spinning:
        rows.append({psi: 1, phi: cos(theta)})
    ranks = (2, 0) if spinning else (3, 2, 0)
    return System(f"ball, spinning {spinning}", (x, y, theta, phi, psi), tuple(rows), ranks)


SKATE: Row = {x: sin(theta), y: -cos(theta)}
DISC: tuple[Row, ...] = ({x: 1, phi: -R * cos(theta)}, {y: 1, phi: -R * sin(theta)})
MIDDLE: Row = {x1: y2 - y1, x2: y2 - y1, y1: x1 - x2, y2: x1 - x2}
ROD: Row = {x1: x1 - x2, x2: x2 - x1, y1: y1 - y2, y2: y2 - y1, z1: z1 - z2, z2: z2 - z1}
f = Unspecified.of("f", "XYZ", x, y, z)

SYSTEMS = [
    System("skate", (x, y, theta), (SKATE,), (1, 0)),
    System("pursuit at frozen t", (x, y), ({x: -sin(omega * t), y: cos(omega * t)},), (1, 0)),
    System("{dz - y dx, dy}", (x, y, z), ({z: 1, x: -y}, {y: 1}), (2,)),
    System("disc kept on its heading", (x, y, phi, theta), (*DISC, {theta: 1}), (3,)),
    System("upright disc", (x, y, phi, theta), DISC, (2, 1, 0)),
    System(
        "car",
        (x, y, theta, phi),
        (SKATE, {x: sin(theta + phi), y: -cos(theta + phi), theta: -b * cos(phi)}),
        (2, 1, 0),
    ),
    System(
        "two wheels on an axle",
        (x, y, theta, phi1, phi2),
        (
            SKATE,
            {x: cos(theta), y: sin(theta), theta: b, phi1: -R},
            {x: cos(theta), y: sin(theta), theta: -b, phi2: -R},
        ),
        (3, 2, 1),
    ),
    System("Ex. 6, all by forms", ends, ({z1: 1}, {z2: 1}, ROD, MIDDLE), (4, 3), symbolic=False),
    System(
        "Ex. 6, with finite relations",
        ends,
        ({z1: 1}, {z2: 1}, ROD, MIDDLE),
        (4, 3),
        on=(z1, z2, (x1 - x2) ** 2 + (y1 - y2) ** 2 + (z1 - z2) ** 2 - length**2),
    ),
    rolling_ball(True),
    rolling_ball(False),
    System(
        "Hilbert and Cartan, (2, 3, 5)",
        (x, y, z, p, q),
        ({y: 1, x: -p}, {p: 1, x: -q}, {z: 1, x: -(q**2)}),
        (3, 2, 0),
    ),
    System("Engel", (x, y, z, w), ({y: 1, x: -z}, {z: 1, x: -w}), (2, 1, 0)),
    System("contact in five", (x, y, z, p, q), ({z: 1, x: -p, y: -q},), (1, 0)),
    System("two contact forms and a pencil", (x, y, z, w), ({x: 1, w: -z}, {y: 1, w: z}), (2, 1)),
    System("time drives two", (x, y, z), ({x: 1, t: -z}, {y: 1, t: -x}), (2, 1, 0)),
    System(
        "rotating table with a groove",
        (x, y),
        ({x: sin(omega * t), y: -cos(omega * t), t: -omega * x},),
        (1, 0),
    ),
    System("redundant rows", (x, y, z), ({x: 1}, {x: y, y: 0}, {x: 2, z: 0}), (1,)),
    System("only together", (x, y, z, w), ({z: 1, x: -y}, {y: 1, x: -w}, {w: 1}), (3,)),
    System("prescribed heading", (x, y), ({x: sin(u), y: -cos(u)},), (1, 0), prescribed=(u,), symbolic=False),
    System(
        "prescribed motion",
        (x, y, z),
        ({x: 1, t: -prime(u)}, {y: 1, t: -u}),
        (2,),
        prescribed=(u,),
        symbolic=False,
    ),
    System("nothing", (x, y), (), (0,)),
    System("geometric only", (x, y), ({x: x, y: y},), (1,), on=(x**2 + y**2 - length**2,)),
    System("dx + y z du on z = 0", (x, y, z, w), ({x: 1, w: y * z},), (2,), on=(z,)),
    System("skate on f = c", (x, y, z, theta), (SKATE,), (2, 1), on=(f - R,), symbolic=False),
    System("heading held to the place", (x, y, theta), (SKATE,), (2,), on=(theta - x / R,)),
    System("redundant finite relations", (x, y, z), ({z: x},), (2,), on=(x - y, 2 * x - 2 * y)),
    System("rod on a moving guide", (x, y, theta), ({x: 1, theta: -y},), (2, 1), on=(y - sin(omega * t),)),
]
SYSTEMS += [trailers(n) for n in range(5)]
every_system = pytest.mark.parametrize("system", SYSTEMS, ids=lambda s: s.name)


def flag(system: System, forms: list[list[sp.Expr]] | None = None):
    return derived_flag(system.forms if forms is None else forms, system.slots, system.on)


@every_system
def test_known_ranks(system):
    found = flag(system)
    assert found.ranks == system.ranks
    assert found.integrable_rank == found.bound == system.ranks[-1]
    assert found.reason == ""


@pytest.mark.parametrize("system", [s for s in SYSTEMS if s.symbolic and s.rows], ids=lambda s: s.name)
def test_ranks_by_symbolic_brackets(system):
    gradients = [[sp.diff(g, v) for v in system.variables] for g in system.on]
    if system.on and system.name.startswith("dx + y z du"):
        assert flag_by_brackets([*system.forms, *gradients], system.variables) != system.ranks
        return
    assert flag_by_brackets([*system.forms, *gradients], system.variables) == system.ranks


@every_system
def test_mixing_and_scaling_rows_changes_nothing(system):
    rng = random.Random(system.name)
    s = system.coordinates
    rows = system.forms
    for _ in range(3):
        if len(rows) < 2:
            break
        i, j = rng.sample(range(len(rows)), 2)
        factor = rng.choice([s[0], cos(s[-1]), sp.Integer(rng.randrange(2, 9)), s[1] ** 2])
        rows[i] = [a + factor * c for a, c in zip(rows[i], rows[j], strict=True)]
    scales = [2 + sin(rng.choice(s)) for _ in rows]
    rows = [[c * a for a in row] for c, row in zip(scales, rows, strict=True)]
    rng.shuffle(rows)
    assert flag(system, rows).ranks == system.ranks


@every_system
def test_a_redundant_row_changes_nothing(system):
    if system.rows:
        sum_of_all = [
            sp.Add(*(system.coordinates[0] * a for a in column)) for column in zip(*system.forms, strict=True)
        ]
        assert flag(system, [*system.forms, sum_of_all]).ranks == system.ranks


@every_system
def test_an_independent_finite_relation_adds_one_to_every_rank(system):
    extra = sp.Symbol("s_extra", real=True)
    slots = Slots((*system.coordinates, extra), system.prescribed)
    rows = [[*row[:-1], sp.S.Zero, row[-1]] for row in system.forms]
    new = [*(sp.diff(extra**3 + x * extra, v) for v in slots.coordinates), sp.S.Zero]
    found = derived_flag([*rows, new], slots, system.on)
    assert found.ranks == tuple(r + 1 for r in system.ranks)
    finite = derived_flag(rows, slots, (*system.on, extra**3 + x * extra + 1))
    assert finite.ranks == found.ranks


@every_system
def test_order_of_coordinates_changes_nothing(system):
    places = list(range(len(system.coordinates)))
    random.Random(system.name).shuffle(places)
    slots = Slots(tuple(system.coordinates[k] for k in places), system.prescribed)
    rows = [[*(row[k] for k in places), row[-1]] for row in system.forms]
    assert derived_flag(rows, slots, system.on).ranks == system.ranks


@every_system
def test_ranks_fall(system):
    ranks = flag(system).ranks
    assert all(a > c for a, c in pairwise(ranks))


# Six constraints in twelve coordinates: two finite relations, an upright disc, two skates.

many = sp.symbols("q1:13", real=True)


@cache
def six_constraints() -> System:
    q1, q2, q3, q4, q5, q6, q7, q8, q9, q10, q11, q12 = many
    rows: tuple[Row, ...] = (
        {q1: q2, q2: q1},
        {q2: 1, q3: -cos(q3), q1: 2 * q1},
        {q3: 1, q5: -R * cos(q6)},
        {q4: 1, q5: -R * sin(q6)},
        {q7: sin(q9), q8: -cos(q9)},
        {q10: 1, q11: -q12},
    )
    return System("sparse", many, rows, (6, 3, 2))


def mixed(rows: list[list[sp.Expr]]) -> list[list[sp.Expr]]:
    """Rows multiplied by a unipotent matrix of functions, twice, so that all are full."""
    rows = [list(row) for row in rows]
    for shift in (1, 2):
        for n in range(len(rows)):
            other = rows[(n + shift) % len(rows)]
            factor = sin(many[(5 * n + shift) % 12]) + many[(3 * n + 2 * shift) % 12]
            rows[n] = [a + factor * c for a, c in zip(rows[n], other, strict=True)]
    return rows


def in_other_coordinates(rows: list[list[sp.Expr]]) -> list[list[sp.Expr]]:
    """q_k = r_k + r_{k+1} r_{k+5} or r_k + r_{k+4}³, with the letters kept."""
    bent = [many[(k + 4) % 12] ** 3 if k % 3 == 0 else many[(k + 1) % 12] * many[(k + 5) % 12] for k in range(12)]
    old = [v + e for v, e in zip(many, bent, strict=True)]
    substitution = dict(zip(many, old, strict=True))
    result = []
    for row in rows:
        moved = [a.xreplace(substitution) for a in row[:12]]
        new = [sp.Add(*(a * sp.diff(e, v) for a, e in zip(moved, old, strict=True))) for v in many]
        result.append([*new, sp.S.Zero])
    return result


@pytest.mark.parametrize(
    "change", [list, mixed, lambda rows: in_other_coordinates(mixed(rows))], ids=["sparse", "mixed", "moved"]
)
def test_six_constraints_in_twelve_coordinates(change):
    system = six_constraints()
    assert flag(system, change(system.forms)).ranks == (6, 3, 2)


def test_angles_inside_angles_are_compared_with_a_real_point():
    """sin(x + sin y) is outside the exact class; the skate with heading θ = ψ + sin ψ is still a skate."""
    heading = psi + sin(psi)
    slots = Slots((x, y, psi))
    assert derived_flag([[sin(heading), -cos(heading), 0, 0]], slots).ranks == (1, 0)
    assert derived_flag([[sin(heading), cos(psi), 0, 0]], slots).ranks == (1, 0)
    assert derived_flag([[sin(heading), 0, cos(psi), 0]], slots).ranks == (1,)


# What is not decided.


def test_the_limit_on_the_order_leaves_a_bound():
    system = trailers(4)
    found = derived_flag(system.forms, system.slots, highest_order=2)
    assert found.integrable_rank is None
    assert found.ranks == (5, 4, 3)
    assert found.bound == 3
    assert "levels" in found.reason


def test_the_limit_on_work_leaves_what_is_known():
    system = trailers(3)
    full = derived_flag(system.forms, system.slots)
    found = derived_flag(system.forms, system.slots, work_limit=1000)
    assert found.integrable_rank is None
    assert 1 <= len(found.ranks) < len(full.ranks)
    assert full.ranks[: len(found.ranks)] == found.ranks
    assert "large" in found.reason
    nothing = derived_flag(system.forms, system.slots, work_limit=1)
    assert (nothing.ranks, nothing.bound) == ((), None)


@pytest.mark.parametrize(
    ("entry", "on", "reason"),
    [
        (sp.Max(x, z), (), "Taylor"),
        (sp.Piecewise((0, x > 0), (z, True)), (), "Taylor"),
        (z, ((x - y) ** 2,), "regular"),
        (z, (sp.exp(x) + sp.exp(y),), "no point"),
        (z * (sp.Abs(x) - x), (), "different"),
    ],
    ids=["Max", "Piecewise", "double plane", "no real point", "on one side only"],
)
def test_reasons(entry, on, reason):
    found = derived_flag([[sp.S.One, entry, sp.S.Zero, sp.S.Zero]], Slots((x, y, z)), on)
    assert found.integrable_rank is None
    assert found.bound is None
    assert reason in found.reason


# -- What two displacements and both back leave, against going there step by step --------------------------------------


x, y, theta = sp.symbols("x y theta", real=True)


def test_a_skate_that_turns_and_comes_back_has_moved_sideways() -> None:
    found = manoeuvre((sp.sin(theta), -sp.cos(theta), sp.S.Zero), (x, y, theta))
    assert found is not None
    assert found.first == (sp.cos(theta), sp.sin(theta), 0)
    assert found.second == (0, 0, 1)
    epsilon, heading = 1e-3, 0.7
    # forward, turn, back along the new heading, turn back
    end = (
        epsilon * (math.cos(heading) - math.cos(heading + epsilon)),
        epsilon * (math.sin(heading) - math.sin(heading + epsilon)),
    )
    expected = [float(e.subs(theta, heading)) * epsilon**2 for e in found.left_over]
    assert end == pytest.approx(expected[:2], rel=2e-3)
    assert expected[2] == 0


def test_nothing_is_said_of_forms_with_three_coefficients() -> None:
    assert manoeuvre((x, y, theta), (x, y, theta)) is None
