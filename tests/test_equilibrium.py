"""Statics: conditions of equilibrium, solutions, stability, what is refused, and verdicts on somebody's answers."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache

import pytest
import sympy as sp
from conftest import PROBLEMS

from lagrange.answers.equations import Verdict
from lagrange.answers.examiner import CheckedAnswer, check_answer, check_own_answers
from lagrange.core.diagnostics import Fragment, ProblemError, Source
from lagrange.document.derivation import Display, Prose, Rule
from lagrange.explain.report import report
from lagrange.explain.statics import explain_virtual_work
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium
from lagrange.mechanics.equilibrium.stability import Verdict as Stable
from lagrange.mechanics.solution import Solution, solve
from lagrange.problem.loader import load, read_problem
from lagrange.problem.model import Problem
from lagrange.render.json import as_object

Read = Callable[[str], Problem]

BEAD = """
title: Bead in a potential
parameters: [a, b]
coordinates: [theta]
forces: {field: {potential: "-a*sin(theta)^2/2 - b*cos(theta)"}}
"""
PENDULUM = """
title: Pendulum
axes: {i: right, j: down}
parameters: [m, l, g]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
constraints: {rod: x^2 + y^2 = l^2}
gravity: g*j
find: equilibrium
generalized_coordinates:
  angle: {coordinates: [theta], substitute: {x: l*sin(theta), y: l*cos(theta)}}
  depth: {coordinates: [y]}
"""
CHAIN = """
title: Two rods pulled sideways
parameters: [W, l, P]
coordinates: [theta, phi]
particles:
  A: {position: l*sin(theta)*i - l*cos(theta)*j}
  B: {position: r_A + l*sin(phi)*i - l*cos(phi)*j}
forces: {w: {on: A, vector: -W*j}, v: {on: B, vector: -W*j}, pull: {on: B, vector: P*i}}
"""
TOGGLE = """
title: Two rods as a toggle against a spring
parameters: [a, k, W]
coordinates: [theta]
particles: {Q: {position: a*cos(theta)*i + a*sin(theta)*j}}
forces:
  load: {on: Q, vector: -W*j}
  spring: {potential: "k*(2*a*cos(theta) - 2*a)^2/2"}
"""
LEVER = """
title: Two forces on a lever
parameters: [W, a, b, c]
unknowns: [P, R]
coordinates: [theta]
particles:
  A: {position: -a*cos(theta)*i - a*sin(theta)*j}
  B: {position: b*cos(theta)*i + b*sin(theta)*j}
  C: {position: c*cos(theta)*i + c*sin(theta)*j}
forces: {w: {on: A, vector: -W*j}, p: {on: B, vector: -P*j}, r: {on: C, vector: -R*j}}
"""
ATWOOD = """
title: Two weights on a string
parameters: [W, M, L]
coordinates: [x]
particles: {A: {position: -x*j}, B: {position: (x - L)*j}}
forces: {w: {on: A, vector: -W*j}, v: {on: B, vector: -M*j}}
"""
SPRINGS = """
title: Spring between two points
parameters: [c, b, h, W]
coordinates: [y]
particles: {P: {position: "[h, y]"}}
forces: {s: {spring: c, between: [P, "[0, 0]"], length: b}}
"""


def read(text: str) -> Problem:
    return read_problem(Source("problem.yaml", text))


@cache
def shipped(name: str) -> Problem:
    [path] = PROBLEMS.rglob(f"{name}.yaml")
    return load(path)


def relations(found: Equilibrium | None) -> list[dict[str, str]]:
    assert found is not None
    return [{str(r.lhs): str(r.rhs) for r in b.relations} for b in found.branches]


def symbols(names: str, **assumptions: bool) -> tuple[sp.Symbol, ...]:
    return tuple(sp.Symbol(n, **assumptions) for n in names.split())


# What is found


def test_virtual_work_and_the_condition() -> None:
    a, b = symbols("a b", positive=True)
    theta = sp.Symbol("theta", real=True)
    found = solve(read(BEAD)).equilibrium
    assert found is not None
    [force] = found.work.forces
    assert sp.expand(force - (a * sp.sin(theta) * sp.cos(theta) - b * sp.sin(theta))) == 0
    [condition] = found.conditions
    assert sp.expand(condition.expression**2 - force**2) == 0
    assert relations(found) == [{"theta": "0"}, {"theta": "pi"}, {"cos(theta)": "b/a"}]
    [condition] = found.branches[2].conditions
    assert (condition.lhs, condition.relation, condition.rhs) == (a, "≥", b)


def test_what_may_vanish_is_not_divided_out() -> None:
    [condition] = solve(read(BEAD)).equilibrium.conditions  # type: ignore[union-attr]
    assert condition.factor.nonzero == ()
    assert condition.expression.xreplace({sp.Symbol("theta", real=True): sp.S.Zero}) == 0


def test_dependent_coordinates_and_choices() -> None:
    solution = solve(read(PENDULUM))
    assert relations(solution.equilibrium) == [{"x": "0", "y": "l"}, {"x": "0", "y": "-l"}]
    angle, depth = solution.choices
    assert relations(angle.equilibrium) == [{"theta": "0"}, {"theta": "pi"}]
    assert depth.equilibrium is not None
    assert depth.equilibrium.exists is False
    assert solution.holds


def test_a_pivot_loses_no_equilibrium() -> None:
    """δx = −(y/x) δy is divided by x, which is zero at both equilibria."""
    solution = solve(read(PENDULUM))
    assert sp.Symbol("x", real=True) in solution.elimination.pivots
    assert len(relations(solution.equilibrium)) == 2


ON_THE_CUT = """
title: A bead on the circle that a plane cuts out of a sphere
parameters: [m, g, a]
coordinates: [x, y, z]
particles: {A: {mass: m, position: x*i + y*j + z*k}}
constraints: {ball: x^2 + y^2 + z^2 = a^2, cut: x + y = z}
gravity: -g*k
find: equilibrium
"""


@pytest.mark.parametrize("text", [PENDULUM, ON_THE_CUT], ids=["one constraint", "two constraints"])
def test_conditions_that_are_shown_hold_where_a_pivot_vanishes(text: str) -> None:
    """With some multipliers every equation that the page states holds at every solution that it gives."""
    solution = solve(read(text))
    found = solution.equilibrium
    assert found is not None
    assert len(found.branches) == 2
    shown = [
        e.sides[0]
        for block in explain_virtual_work(found, None).body
        if isinstance(block, Display)
        for e in block.equations
        if e.label is not None and e.label.startswith("condition-")
    ]
    numbers = sorted({s for e in shown for s in e.free_symbols if s.name.startswith("lambda_")}, key=str)
    assert len(numbers) == len(found.configuration.rows)
    for b in found.branches:
        for at in b.points:
            there = [e.xreplace(at) for e in shown]
            assert len(there) > len(numbers)
            assert len(sp.linsolve(there, numbers)) == 1


def test_what_forces_at_a_given_position_presuppose_and_how_they_are_written() -> None:
    """The moment of the supports of a bridge is a multiple of cos θ; ½ is not divided by, but 2 multiplied by."""
    [path] = PROBLEMS.rglob("lorry-on-a-bridge.yaml")
    found = solve(load(str(path))).equilibrium
    assert found is not None
    theta = sp.Symbol("theta", real=True)
    assert found.presupposed == (sp.cos(theta),)
    assert relations(found) == [{"P": "B/2 + W*(-b/l + 1)", "Q": "(B*l + 2*W*b)/(2*l)"}]
    words = [
        "".join(part if isinstance(part, str) else "…" for part in block.parts)
        for block in explain_virtual_work(found, None).body
        if isinstance(block, Prose)
    ]
    assert "For a given position, where …, this determines … and …:" in words
    assert any(w.endswith("vanishes (multiplying by …):") for w in words)


def test_several_degrees_of_freedom() -> None:
    found = solve(read(CHAIN)).equilibrium
    assert relations(found) == [{"tan(theta)": "P/(2*W)", "tan(phi)": "P/W"}]
    assert found is not None
    assert len(found.branches[0].points) == 4


def test_unknown_force() -> None:
    found = solve(shipped("ladder")).equilibrium
    assert relations(found) == [{"P": "W*tan(phi)/2"}]
    assert found is not None
    assert found.given


def test_more_unknown_forces_than_conditions() -> None:
    problem = read(LEVER)
    found = solve(problem).equilibrium
    [branch] = relations(found)
    assert branch in ({"P": "(W*a - R*c)/b"}, {"R": "(W*a - P*b)/c"}, {"P": "(-R*c + W*a)/b"})
    assert found is not None
    assert [f.name for f in found.undetermined] == ["R"]
    words = [str(p) for s in report(problem).derivation.steps for x in s.body for p in getattr(x, "parts", ())]
    assert any("only these combinations are determined" in w for w in words)


def test_forces_and_positions_together() -> None:
    """Two conditions, one unknown force: the position is determined as well."""
    text = CHAIN.replace("[W, l, P]", "[W, l]").replace("coordinates:", "unknowns: [P]\ncoordinates:", 1)
    found = solve(read(text)).equilibrium
    assert found is not None
    assert not found.given
    for b in found.branches:
        assert {str(r.lhs) for r in b.relations} & {"P", "tan(theta)", "theta"}


def test_no_equilibrium_is_said() -> None:
    text = ATWOOD.replace("vector: -M*j", "vector: M*j")
    result = report(read(text))
    assert result.solution.equilibrium is not None
    assert result.solution.equilibrium.exists is False
    said = " ".join(str(p) for s in result.derivation.steps for b in s.body for p in getattr(b, "parts", ()))
    assert "there is no equilibrium" in said
    found = as_object(result)
    assert found["equilibrium"] == []
    assert found["equilibrium_exists"] is False


def test_balance_in_every_position() -> None:
    found = solve(read(ATWOOD)).equilibrium
    assert relations(found) in ([{"M": "W"}], [{"W": "M"}])
    assert found is not None
    assert found.branches[0].special


def test_every_position() -> None:
    text = ATWOOD.replace("vector: -M*j", "vector: -W*j")
    found = solve(read(text)).equilibrium
    assert relations(found) == [{}]


def test_what_is_not_solved_is_left() -> None:
    found = solve(shipped("rocking-plank")).equilibrium
    assert found is not None
    assert not found.solution.solved
    assert relations(found)[0] == {"theta": "0"}
    assert len(found.branches[1].left) == 1
    assert found.exists


COLUMN = """
title: Two bars with torsion springs under a load
parameters: [l, c, P]
coordinates: [a, b]
forces: {springs: {potential: c*a^2/2 + c*(b - a)^2/2}, load: {potential: P*l*(cos(a) + cos(b))}}
"""


def test_rest_at_zero_is_seen_in_equations_that_are_not_solved() -> None:
    """c (2a − b) = P l sin a and c (b − a) = P l sin b: the straight column, and perhaps bent ones.

    det K = c² − 3 c P l + P² l² > 0, so that the smaller root, P l = (3 − √5)/2 c, is the load at which it buckles.
    """
    solution = solve(read(COLUMN))
    found = solution.equilibrium
    assert found is not None
    assert relations(found)[0] == {"a": "0", "b": "0"}
    assert [bool(b.left) for b in found.branches] == [False, True]
    assert solution.stability is not None
    straight = solution.stability.verdicts[0]
    assert straight.verdict is Stable.CONDITIONAL
    for push, stable in ((sp.Rational(38, 100), True), (sp.Rational(39, 100), False), (3, False)):
        values = dict(zip(symbols("l c P", positive=True), (1, 1, push), strict=True))
        held = [(c.lhs - c.rhs).subs(values) > 0 for c in straight.conditions if c.relation == ">"]
        assert len(held) == len(straight.conditions)
        assert all(held) is stable


LOADED_WHEEL = """
title: A wheel with a weight on its rim, on an incline
parameters: [M, m, R, r, g, alpha]
coordinates: [phi]
particles:
  C: {mass: M, position: R*phi*i}
  Q: {mass: m, position: (R*phi + r*sin(phi))*i + r*cos(phi)*j}
gravity: g*sin(alpha)*i - g*cos(alpha)*j
find: [equilibrium, linearization]
"""


def test_angles_given_by_an_angle_of_the_parameters() -> None:
    """m r sin(φ + α) = −(M + m) R sin α; V'' = −m g r cos(φ + α) is of either sign, and no sin²α + cos²α is left."""
    solution = solve(read(LOADED_WHEEL))
    assert solution.equilibrium is not None
    assert solution.stability is not None
    assert {v.verdict for v in solution.stability.verdicts} == {Stable.STABLE, Stable.UNSTABLE}
    values = dict(zip(symbols("M m R r g alpha", positive=True), (2, 3, 1, 4, 10, 0.3), strict=True))
    for branch, verdict in zip(solution.equilibrium.branches, solution.stability.verdicts, strict=True):
        point = {str(r.lhs): r.rhs for r in branch.relations}
        assert max(e.count_ops() for e in point.values()) < 40
        sine, cosine = (float(point[f"{f}(phi)"].subs(values)) for f in ("sin", "cos"))
        assert math.isclose(sine**2 + cosine**2, 1)
        assert math.isclose(12 * (sine * math.cos(0.3) + cosine * math.sin(0.3)), -5 * math.sin(0.3))
        second = -120 * (cosine * math.cos(0.3) - sine * math.sin(0.3))
        assert (second > 0) is (verdict.verdict is Stable.STABLE)


def test_a_spring_between_two_points() -> None:
    """V = c (√(h² + y²) − b)²/2: y = 0, and y = ±√(b² − h²) where the spring is slack."""
    solution = solve(read(SPRINGS))
    assert relations(solution.equilibrium) == [{"y": "0"}, {"y": "sqrt(b**2 - h**2)"}, {"y": "-sqrt(b**2 - h**2)"}]
    [spring] = solution.configuration.springs
    c, b, h = symbols("c b h", positive=True)
    y = sp.Symbol("y", real=True)
    assert sp.expand(spring.distance**2 - h**2 - y**2) == 0
    assert sp.expand(spring.pull - c * (spring.distance - b)) == 0
    assert solution.configuration.potential == spring.energy


def test_a_force_that_acts_elsewhere() -> None:
    found = solve(shipped("ex16-rod-on-two-planes"))
    assert relations(found.choices[0].equilibrium) == [{"tan(theta)": "(2*k - 1)/tan(alpha)"}]
    assert [r["tan(theta)"] for r in relations(found.equilibrium)] == ["(2*k - 1)/tan(alpha)"]
    assert found.holds


# Stability


@pytest.mark.parametrize(
    ("text", "verdicts"),
    [
        (BEAD, [Stable.CONDITIONAL, Stable.UNSTABLE, Stable.STABLE]),
        (CHAIN, [Stable.CONDITIONAL]),
        (ATWOOD, [Stable.UNDECIDED]),
        (SPRINGS, [Stable.CONDITIONAL, Stable.STABLE, Stable.STABLE]),
    ],
    ids=["bead", "chain", "atwood", "spring"],
)
def test_stability(text: str, verdicts: list[Stable]) -> None:
    stability = solve(read(text)).stability
    assert stability is not None
    assert [s.verdict for s in stability.verdicts] == verdicts


def test_stability_conditions() -> None:
    a, b = symbols("a b", positive=True)
    stability = solve(read(BEAD)).stability
    assert stability is not None
    [c] = stability.verdicts[0].conditions
    assert (c.lhs, c.relation, c.rhs) == (b, ">", a)


def test_stability_in_a_choice() -> None:
    angle = solve(read(PENDULUM)).choices[0]
    assert angle.stability is not None
    assert [s.verdict for s in angle.stability.verdicts] == [Stable.STABLE, Stable.UNSTABLE]


def test_no_stability_without_a_potential() -> None:
    """A force that turns with the last rod has no potential."""
    text = CHAIN.replace("vector: P*i", "vector: P*cos(phi)*i + P*sin(phi)*j")
    assert solve(read(text)).stability is None


# What is refused


@pytest.mark.parametrize(
    ("more", "code", "says"),
    [
        ('forces: {drag: {on: P, vector: "-m*x\'*i"}}', "force-of-motion", "velocity `x'`"),
        ("forces: {shake: {on: P, vector: m*sin(t)*i}}", "force-of-motion", "depends on time"),
        ("functions: {u: [t]}\nforces: {shake: {on: P, vector: m*u*i}}", "force-of-motion", "depends on time"),
        ("forces: {field: {potential: m*t*x}}", "force-of-motion", "depends on time"),
        ("forces: {rub: {damper: m, between: [P, '[0, 0]']}}", "force-of-motion", "no force at rest"),
        ("forces: {s: {spring: m, between: [P, '[t, 0]']}}", "force-of-motion", "depends on time"),
    ],
)
def test_forces_that_depend_on_the_motion(more: str, code: str, says: str) -> None:
    text = f"title: Particle\nparameters: [m]\ncoordinates: [x]\nparticles: {{P: {{position: x*i}}}}\n{more}\n"
    with pytest.raises(ProblemError) as caught:
        solve(read(text + "find: equilibrium\n"))
    [found] = caught.value.diagnostics
    assert found.code == code
    assert says in found.message
    assert found.span is not None


def test_nothing_acts() -> None:
    text = "title: Particle\ncoordinates: [x]\nparticles: {P: {position: x*i}}\nfind: equilibrium\n"
    with pytest.raises(ProblemError, match="no force acts") as caught:
        solve(read(text))
    assert caught.value.diagnostics[0].code == "no-forces"


@pytest.mark.parametrize(
    ("old", "new"), [("x^2 + y^2 = l^2", "x = l*t"), ("position: x*i + y*j", "position: x*i + (y + l*t)*j")]
)
def test_what_moves_by_itself(old: str, new: str) -> None:
    text = PENDULUM.split("generalized_coordinates")[0].replace(old, new)
    with pytest.raises(ProblemError) as caught:
        solve(read(text))
    assert caught.value.diagnostics[0].code == "moving-constraint"


# Answers


def verdict(problem: Problem, *equations: str) -> CheckedAnswer:
    return check_answer(problem, tuple(Fragment.of(e) for e in equations))


EQUIVALENT, WRONG, INCOMPLETE, TRIVIAL = Verdict.EQUIVALENT, Verdict.WRONG, Verdict.INCOMPLETE, Verdict.TRIVIAL

ANSWERS = [
    ("ex16-rod-on-two-planes", ["tan(theta) = (2*k - 1)/tan(alpha)"], EQUIVALENT),
    ("ex16-rod-on-two-planes", ["sin(alpha)*cos(alpha - theta)/sin(2*alpha) = k*cos(theta)"], EQUIVALENT),
    ("ex16-rod-on-two-planes", ["k = (1 + tan(theta)*tan(alpha))/2"], EQUIVALENT),
    ("ex16-rod-on-two-planes", ["tan(alpha) = (2*k - 1)/tan(theta)"], EQUIVALENT),
    ("ex16-rod-on-two-planes", ["theta = atan((2*k - 1)/tan(alpha))"], EQUIVALENT),
    ("ex16-rod-on-two-planes", ["tan(theta) = (2*k - 1)*tan(alpha)"], WRONG),
    ("ex16-rod-on-two-planes", ["tan(theta) = (1 - 2*k)/tan(alpha)"], WRONG),
    ("ex16-rod-on-two-planes", ["theta = 0"], WRONG),
    ("ex16-rod-on-two-planes", ["sin(theta)*(tan(theta)*tan(alpha) - 2*k + 1) = 0"], WRONG),
    ("ex16-rod-on-two-planes", ["l*sin(theta) = (z_B - z_A)*sin(alpha)"], INCOMPLETE),
    ("ex16-rod-on-two-planes", ["k = 1/2"], INCOMPLETE),
    ("ex16-rod-on-two-planes", ["k = 1/2", "theta = 0"], INCOMPLETE),
    ("ex16-rod-on-two-planes", ["sin(theta)^2 + cos(theta)^2 = 1"], TRIVIAL),
    (BEAD, ["sin(theta)*(a*cos(theta) - b) = 0"], EQUIVALENT),
    (BEAD, ["a*sin(2*theta) = 2*b*sin(theta)"], EQUIVALENT),
    (BEAD, ["theta = 0 or theta = pi or cos(theta) = b/a"], EQUIVALENT),
    (BEAD, ["sin(theta) = 0 or cos(theta) = b/a"], EQUIVALENT),
    (BEAD, ["theta = 2*pi or theta = -pi or theta = acos(b/a) or theta = -acos(b/a)"], EQUIVALENT),
    (BEAD, ["theta = 0 or theta = pi or theta = acos(b/a)"], EQUIVALENT),
    (BEAD, ["theta = 0 or theta = pi or a = b/cos(theta)"], EQUIVALENT),
    (BEAD, ["theta = 0 or theta = pi or sin(theta)^2 = 1 - b^2/a^2"], WRONG),
    (BEAD, ["theta = 0 or theta = pi"], INCOMPLETE),
    (BEAD, ["cos(theta) = b/a"], INCOMPLETE),
    (BEAD, ["theta = 0"], INCOMPLETE),
    (BEAD, ["theta = 0", "theta = pi"], WRONG),
    (BEAD, ["theta = 0 or cos(theta) = a/b"], WRONG),
    (BEAD, ["tan(theta/2) = 0 or theta = pi or cos(theta) = b/a"], EQUIVALENT),
    # W cos θ = 4 k a (cos θ − 1) sin θ is of the fourth degree, and has no solution in closed form
    (TOGGLE, ["W = 4*k*a*(sin(theta) - tan(theta))"], EQUIVALENT),
    (TOGGLE, ["W = 4*k*a*(tan(theta) - sin(theta))"], WRONG),
    (TOGGLE, ["theta = 0"], WRONG),
    (CHAIN, ["tan(theta) = P/(2*W)", "tan(phi) = P/W"], EQUIVALENT),
    (CHAIN, ["P*cos(phi) = W*sin(phi)", "2*tan(theta) = tan(phi)"], EQUIVALENT),
    (CHAIN, ["P = 2*W*tan(theta)", "P = W*tan(phi)"], EQUIVALENT),
    (CHAIN, ["tan(theta) = P/(2*W)"], INCOMPLETE),
    (CHAIN, ["2*tan(theta) = tan(phi)"], INCOMPLETE),
    (CHAIN, ["tan(theta) = P/W", "tan(phi) = P/W"], WRONG),
    ("ladder", ["P = W/2*tan(phi)"], EQUIVALENT),
    ("ladder", ["W = 2*P/tan(phi)"], EQUIVALENT),
    ("ladder", ["tan(phi) = 2*P/W"], EQUIVALENT),
    ("ladder", ["2*P*l*cos(phi) = W*l*sin(phi)"], EQUIVALENT),
    ("ladder", ["P = W*tan(phi)"], WRONG),
    ("ladder", ["P = W/2*cos(phi)/sin(phi)"], WRONG),
    (PENDULUM, ["x = 0"], EQUIVALENT),
    (PENDULUM, ["theta = 0 or theta = pi"], EQUIVALENT),
    (PENDULUM, ["x = 0", "y = l"], INCOMPLETE),
    (PENDULUM, ["x = 0", "y = l or y = -l"], EQUIVALENT),
    (PENDULUM, ["y = 0"], WRONG),
    (PENDULUM, ["x^2 + y^2 = l^2"], INCOMPLETE),
    ("three-weights", ["y^2*(4*P^2 - W^2) = b^2*W^2"], WRONG),  # y < 0 as well
    ("three-weights", ["y = b*W/sqrt(4*P^2 - W^2)"], EQUIVALENT),
    ("three-weights", ["2*P*y = W*sqrt(b^2 + y^2)"], EQUIVALENT),
    ("rod-over-peg", ["cos(theta) = (c/b)^(1/3)"], EQUIVALENT),
    ("rod-over-peg", ["b*cos(theta)^3 = c"], EQUIVALENT),
    ("rod-over-peg", ["b*cos(theta)^2 = c"], WRONG),
    ("rocking-plank", ["theta = 0 or R*theta = h*tan(theta)"], EQUIVALENT),
    ("rocking-plank", ["h*sin(theta) = R*theta*cos(theta)"], EQUIVALENT),
    ("rocking-plank", ["theta = 0"], INCOMPLETE),
    ("balanced-lamp", ["theta = 0 or theta = pi"], EQUIVALENT),
    (ATWOOD, ["W = M"], EQUIVALENT),
    (ATWOOD, ["W = 2*M"], WRONG),
    (LEVER, ["b*P + c*R = a*W"], EQUIVALENT),
    (LEVER, ["P = a*W/b"], WRONG),
]


@pytest.mark.parametrize(
    ("problem", "equations", "expected"),
    ANSWERS,
    ids=[f"{p.split(chr(10))[1] if chr(10) in p else p}: {'; '.join(e)}" for p, e, _ in ANSWERS],
)
def test_answers(problem: str, equations: list[str], expected: Verdict) -> None:
    asked = read(problem) if "\n" in problem else shipped(problem)
    found = verdict(asked, *equations)
    assert found.verdict is expected, found.equations
    assert found.statics


HELD = """
title: A bead held on a ring, P for every position
coordinates: [x, y]
parameters: [W, l]
particles: {A: {position: "[x, y]"}}
constraints: {ring: x^2 + y^2 = l^2}
forces: {weight: {on: A, vector: -W*j}, pull: {on: A, vector: P*i}}
unknowns: [P]
find: equilibrium
"""


@pytest.mark.parametrize(
    ("equation", "expected"),
    [
        ("P = -W*x/y", EQUIVALENT),  # moments about the centre: P y + W x = 0
        ("P*y = -W*x", EQUIVALENT),
        ("P*y*(x^2 + y^2) = -W*x*l^2", EQUIVALENT),  # with the ring put in
        ("P = W*x/y", WRONG),
        ("P = -2*W*x/y", WRONG),
        ("P^2 = W^2*x^2/y^2", WRONG),  # has the other sign too
        ("x^2 + y^2 = l^2", INCOMPLETE),
    ],
)
def test_a_force_for_every_position_of_a_constraint(equation: str, expected: Verdict) -> None:
    assert verdict(read(HELD), equation).verdict is expected


def test_unreadable_answers() -> None:
    assert verdict(read(BEAD), "theta = 1 or zeta = 3").verdict is Verdict.UNREADABLE
    assert verdict(read(BEAD), "cos(theta) = b/(a - a)").verdict is Verdict.UNREADABLE


def test_what_is_said_of_an_answer() -> None:
    found = verdict(shipped("ex16-rod-on-two-planes"), "theta = atan((2*k - 1)/tan(alpha))")
    assert found.equations.equations[0].remarks
    found = verdict(read(BEAD), "theta = 0 or theta = pi or sin(theta)^2 = 1 - b^2/a^2")
    assert any("no equilibrium" in e.diagnosis for e in found.equations.equations)
    assert "positions of equilibrium" in verdict(read(BEAD), "sin(theta)*(a*cos(theta) - b) = 0").headline
    assert verdict(read(BEAD), "theta = 0").equations.missing == 2


def test_answers_of_the_file() -> None:
    good = BEAD + 'answers: {equilibrium: [["theta = 0"], ["theta = pi"], ["cos(theta) = b/a"]]}\n'
    assert check_own_answers(read(good)).verdict is EQUIVALENT
    assert report(read(good)).holds
    bad = good.replace('["theta = pi"], ', "")
    assert check_own_answers(read(bad)).verdict is INCOMPLETE
    assert not report(read(bad)).holds


def test_numbers_of_the_file_count() -> None:
    text = BEAD.replace("[a, b]", "{a: {assume: positive, value: 2}, b: {assume: positive, value: 1}}")
    assert verdict(read(text), "theta = 0 or theta = pi or cos(theta) = 1/2").verdict is EQUIVALENT
    assert verdict(read(text), "theta = 0 or theta = pi or theta = pi/3 or theta = -pi/3").verdict is EQUIVALENT
    assert verdict(read(text), "theta = 0 or theta = pi or cos(theta) = 1/3").verdict is WRONG


def test_motion_and_equilibrium() -> None:
    problem = read(PENDULUM.replace("find: equilibrium", "find: [equilibrium, motion]"))
    solution = solve(problem)
    assert solution.motion is not None
    assert solution.equilibrium is not None
    assert verdict(problem, "theta = 0 or theta = pi").verdict is EQUIVALENT
    assert verdict(problem, "l*theta'' + g*sin(theta) = 0").verdict is EQUIVALENT


def test_no_reactions_are_found_where_there_are_none() -> None:
    text = BEAD + "find: [motion, equilibrium]\n"
    problem = read(text.replace("forces:", "particles: {P: {mass: a, position: b*sin(theta)*i}}\nforces:"))
    steps = report(problem).derivation.steps
    assert any(step.rule is Rule.EQUILIBRIUM for step in steps)
    assert not any(step.rule is Rule.SOLVED_REACTIONS for step in steps)


def solution_of(text: str) -> Solution:
    return solve(read(text))


HALF = """
title: A pendulum pulled over a pulley above it
parameters: [W, Q, l]
coordinates: [theta]
forces: {weights: {potential: W*l*cos(theta) + 2*Q*l*sin(theta/2)}}
answers:
  equilibrium: [["theta = pi"], ["sin(theta/2) = Q/(2*W)"]]
"""


def test_half_angles_tell_a_position_from_the_same_a_turn_later() -> None:
    """V'' = −W l cos θ − ½ Q l sin(θ/2) is (W − Q/2) l at π and (W + Q/2) l at −π."""
    solution = solve(read(HALF))
    assert solution.equilibrium is not None
    assert solution.stability is not None
    W, Q, l = symbols("W Q l", positive=True)
    at = {
        r.rhs: s
        for b, s in zip(solution.equilibrium.branches, solution.stability.verdicts, strict=True)
        for r in b.relations
        if r.lhs == sp.Symbol("theta", real=True)
    }
    assert sp.expand(at[sp.pi].minors[0] - (W - Q / 2) * l) == 0
    assert at[sp.pi].verdict is Stable.CONDITIONAL
    assert sp.expand(at[-sp.pi].minors[0] - (W + Q / 2) * l) == 0
    assert at[-sp.pi].verdict is Stable.STABLE
    assert report(read(HALF)).holds  # in answers angles count modulo 2π


@pytest.mark.parametrize(
    ("potential", "verdict", "order"),
    [
        ("a*theta^2/2 + a*cos(theta)", Stable.STABLE, 4),
        ("-a*theta^2/2 - a*cos(theta)", Stable.UNSTABLE, 4),
        ("a*theta - a*sin(theta)", Stable.UNSTABLE, 3),
        ("a*theta^2/2 + a*cos(theta) - a*theta^4/24", Stable.UNSTABLE, 6),
        ("b*(1 - cos(theta))^4", Stable.UNDECIDED, 2),
    ],
)
def test_higher_derivatives_where_the_second_is_zero(potential: str, verdict: Stable, order: int) -> None:
    text = f"title: v\nparameters: [a, b]\ncoordinates: [theta]\nforces: {{v: {{potential: '{potential}'}}}}\n"
    stability = solve(read(text)).stability
    assert stability is not None
    assert (stability.verdicts[0].verdict, stability.verdicts[0].order) == (verdict, order)


WIRE = """
title: Bead on an elliptic wire
parameters: [m, a, b, g]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
constraints: {wire: x^2/a^2 + y^2/b^2 = 1}
gravity: -g*j
find: equilibrium
"""


def test_stability_where_other_displacements_are_free() -> None:
    """δx = −(a² y/(b² x)) δy fails at x = 0, where y = ∓b (1 − x²/(2a²)) gives V'' = ± m g b/a²."""
    solution = solve(read(WIRE))
    assert solution.equilibrium is not None
    assert solution.stability is not None
    m, a, b, g = symbols("m a b g", positive=True)
    for branch, s in zip(solution.equilibrium.branches, solution.stability.verdicts, strict=True):
        below = {str(r.lhs): r.rhs for r in branch.relations}["y"] == -b
        assert s.verdict is (Stable.STABLE if below else Stable.UNSTABLE)
        assert [str(q) for q in s.free] == ["x"]
        assert sp.cancel(s.minors[0] - (1 if below else -1) * m * g * b / a**2) == 0
