"""Statics: conditions of equilibrium, solutions, stability, what is refused, and verdicts on answers."""

from __future__ import annotations

import math
from collections.abc import Callable

import pytest
import sympy as sp

from lagrange.answers.equations import Verdict
from lagrange.answers.examiner import check_answer
from lagrange.answers.verdicts import Judgement
from lagrange.core.diagnostics import Fragment, NotCoveredError, ProblemError, Source
from lagrange.document.derivation import Display, Prose, Rule
from lagrange.explain.report import report
from lagrange.explain.rest.equilibrium import explain_virtual_work
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium
from lagrange.mechanics.equilibrium.stability import StabilityVerdict as Stable
from lagrange.mechanics.results import Solution
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import read_problem
from lagrange.problem.model import Problem
from lagrange.render.json import as_object
from tests.support.shared import solved
from tests.support.statics_texts import (
    ATWOOD,
    BEAD,
    CHAIN,
    FOUR_BAR,
    LEVER,
    PENDULUM,
    POLE,
    PUSHED_LINKAGE,
    SKATE,
    SPRING_ON_CIRCLE,
    SPRINGS,
    STRAIGHT_SPRING,
)

Read = Callable[[str], Problem]


def read(text: str) -> Problem:
    return read_problem(Source("problem.yaml", text))


def relations(found: Equilibrium | None) -> list[dict[str, str]]:
    assert found is not None
    return [{str(r.lhs): str(r.rhs) for r in b.relations} for b in found.branches]


def symbols(names: str, **assumptions: bool) -> tuple[sp.Symbol, ...]:
    return tuple(sp.Symbol(n, **assumptions) for n in names.split())


# What is found


def test_virtual_work_and_the_condition() -> None:
    a, b = symbols("a b", positive=True)
    theta = sp.Symbol("theta", real=True)
    found = solve(read(BEAD)).own.equilibrium
    assert found is not None
    [force] = found.work.forces
    assert sp.expand(force - (a * sp.sin(theta) * sp.cos(theta) - b * sp.sin(theta))) == 0
    [condition] = found.conditions
    assert sp.expand(condition.expression**2 - force**2) == 0
    assert relations(found) == [{"theta": "0"}, {"theta": "pi"}, {"cos(theta)": "b/a"}]
    [condition] = found.branches[2].conditions
    assert (condition.lhs, condition.relation, condition.rhs) == (a, "≥", b)


def test_what_may_vanish_is_not_divided_out() -> None:
    [condition] = solve(read(BEAD)).own.equilibrium.conditions  # type: ignore[union-attr]
    assert condition.factor.nonzero == ()
    assert condition.expression.xreplace({sp.Symbol("theta", real=True): sp.S.Zero}) == 0


def test_dependent_coordinates_and_choices() -> None:
    solution = solve(read(PENDULUM))
    assert relations(solution.own.equilibrium) == [{"x": "0", "y": "l"}, {"x": "0", "y": "-l"}]
    angle, depth = solution.choices
    assert relations(angle.equilibrium) == [{"theta": "0"}, {"theta": "pi"}]
    assert depth.equilibrium is not None
    assert depth.equilibrium.exists is False
    assert solution.holds


def test_a_pivot_loses_no_equilibrium() -> None:
    """δx = −(y/x) δy is divided by x, which is zero at both equilibria."""
    solution = solve(read(PENDULUM))
    assert sp.Symbol("x", real=True) in solution.own.elimination.pivots
    assert len(relations(solution.own.equilibrium)) == 2


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
    found = solution.own.equilibrium
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
    """The moment of the supports of a bridge is a multiple of cos θ; ½ is left out of it, and of no other condition."""
    found = solved("lorry-on-a-bridge").own.equilibrium
    assert found is not None
    theta = sp.Symbol("theta", real=True)
    assert found.presupposed == (sp.cos(theta),)
    assert relations(found) == [{"P": "B/2 + W*(-b/l + 1)", "Q": "B/2 + W*b/l"}]
    words = words_about(found)
    assert "For a given position, where …, this determines … and …:" in words
    assert any(w.endswith("must vanish (without the factor …):") for w in words)


def words_about(found: Equilibrium) -> list[str]:
    """The sentences about virtual work, `…` for each formula in them."""
    return [
        "".join(part if isinstance(part, str) else "…" for part in block.parts)
        for block in explain_virtual_work(found, None).body
        if isinstance(block, Prose)
    ]


def test_a_half_is_not_divided_by_but_two_multiplied_by() -> None:
    found = solve(
        read("""
title: Weight on two soft springs
parameters: [k, W]
coordinates: [x]
particles: {P: {position: x*i}}
forces: {load: {on: P, vector: W*i}, springs: {potential: k*x^2/4}}
find: equilibrium
""")
    ).own.equilibrium
    assert relations(found) == [{"x": "2*W/k"}]
    assert found is not None
    assert any(w.endswith("must vanish (multiplying by …):") for w in words_about(found))


def test_several_degrees_of_freedom() -> None:
    found = solve(read(CHAIN)).own.equilibrium
    assert relations(found) == [{"tan(theta)": "P/(2*W)", "tan(phi)": "P/W"}]
    assert found is not None
    assert len(found.branches[0].points) == 4


def test_unknown_force() -> None:
    found = solved("ladder").own.equilibrium
    assert relations(found) == [{"P": "W*tan(phi)/2"}]
    assert found is not None
    assert found.given


def test_more_unknown_forces_than_conditions() -> None:
    problem = read(LEVER)
    found = solve(problem).own.equilibrium
    [branch] = relations(found)
    assert branch in ({"P": "(W*a - R*c)/b"}, {"R": "(W*a - P*b)/c"}, {"P": "(-R*c + W*a)/b"})
    assert found is not None
    assert [f.name for f in found.undetermined] == ["R"]
    words = [str(p) for s in report(problem).derivation.steps for x in s.body for p in getattr(x, "parts", ())]
    assert any("only these combinations are determined" in w for w in words)


def test_forces_and_positions_together() -> None:
    """Two conditions, one unknown force: the position is determined as well."""
    text = CHAIN.replace("[W, l, P]", "[W, l]").replace("coordinates:", "unknowns: [P]\ncoordinates:", 1)
    found = solve(read(text)).own.equilibrium
    assert found is not None
    assert not found.given
    for b in found.branches:
        assert {str(r.lhs) for r in b.relations} & {"P", "tan(theta)", "theta"}


def test_no_equilibrium_is_said() -> None:
    text = ATWOOD.replace("vector: -M*j", "vector: M*j")
    result = report(read(text))
    assert result.solution.own.equilibrium is not None
    assert result.solution.own.equilibrium.exists is False
    said = " ".join(str(p) for s in result.derivation.steps for b in s.body for p in getattr(b, "parts", ()))
    assert "there is no equilibrium" in said
    found = as_object(result)
    assert found["equilibrium"] == []
    assert found["equilibrium_exists"] is False


def test_balance_in_every_position() -> None:
    found = solve(read(ATWOOD)).own.equilibrium
    assert relations(found) in ([{"M": "W"}], [{"W": "M"}])
    assert found is not None
    assert found.branches[0].special


def test_every_position() -> None:
    text = ATWOOD.replace("vector: -M*j", "vector: -W*j")
    found = solve(read(text)).own.equilibrium
    assert relations(found) == [{}]


def test_what_is_not_solved_is_left() -> None:
    found = solved("rocking-plank").own.equilibrium
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
    found = solution.own.equilibrium
    assert found is not None
    assert relations(found)[0] == {"a": "0", "b": "0"}
    assert [bool(b.left) for b in found.branches] == [False, True]
    assert solution.own.stability is not None
    straight = solution.own.stability.verdicts[0]
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
    assert solution.own.equilibrium is not None
    assert solution.own.stability is not None
    assert {v.verdict for v in solution.own.stability.verdicts} == {Stable.STABLE, Stable.UNSTABLE}
    values = dict(zip(symbols("M m R r g alpha", positive=True), (2, 3, 1, 4, 10, 0.3), strict=True))
    for branch, verdict in zip(solution.own.equilibrium.branches, solution.own.stability.verdicts, strict=True):
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
    assert relations(solution.own.equilibrium) == [{"y": "0"}, {"y": "sqrt(b**2 - h**2)"}, {"y": "-sqrt(b**2 - h**2)"}]
    [spring] = solution.own.configuration.springs
    c, b, h = symbols("c b h", positive=True)
    y = sp.Symbol("y", real=True)
    assert sp.expand(spring.distance**2 - h**2 - y**2) == 0
    assert sp.expand(spring.pull - c * (spring.distance - b)) == 0
    assert solution.own.configuration.potential == spring.energy


def test_a_force_that_acts_elsewhere() -> None:
    found = solved("ex16-rod-on-two-planes")
    assert relations(found.choices[0].equilibrium) == [{"tan(theta)": "(2*k - 1)/tan(alpha)"}]
    assert [r["tan(theta)"] for r in relations(found.own.equilibrium)] == ["(2*k - 1)/tan(alpha)"]
    assert found.holds


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


DAMPED = """
title: A damped pendulum in the wind
parameters: [m, l, g, c, F, k]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
constraints: {rod: {equation: x^2 + y^2 = l^2, reaction: T}}
gravity: g*j
forces: {drag: {on: P, vector: -c*r_P'}, wind: {on: P, vector: F*i}, rub: {damper: k, between: [P, l*i]}}
generalized_coordinates: {angle: {coordinates: [theta], substitute: {x: l*sin(theta), y: l*cos(theta)}}}
"""


def test_forces_that_vanish_at_rest_beside_the_motion() -> None:
    found = solve(read(DAMPED + "find: [motion, equilibrium]\n")).choices[0]
    assert relations(found.equilibrium) == [{"tan(theta)": "F/(g*m)"}]
    assert found.reactions_at_rest is not None
    [at] = found.reactions_at_rest.at
    assert at is not None
    assert {s.name: str(v) for s, v in at.rule.items()} == {"lambda_rod": "-g*m/(2*l*cos(theta))"}


def test_a_force_without_a_value_at_rest_is_refused() -> None:
    text = DAMPED.replace("-c*r_P'", "-c*r_P'/norm(r_P')") + "find: [motion, equilibrium]\n"
    with pytest.raises(NotCoveredError, match="`drag`, which has no value"):
        solve(read(text))


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


def verdict(problem: Problem, *equations: str) -> Judgement:
    return check_answer(problem, tuple(Fragment.of(e) for e in equations))


EQUIVALENT, WRONG, INCOMPLETE, TRIVIAL = (
    Verdict.EQUIVALENT,
    Verdict.WRONG,
    Verdict.INCOMPLETE,
    Verdict.TRIVIAL,
)


def test_motion_and_equilibrium() -> None:
    problem = read(PENDULUM.replace("find: equilibrium", "find: [equilibrium, motion]"))
    solution = solve(problem)
    assert solution.own.motion is not None
    assert solution.own.equilibrium is not None
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
    assert solution.own.equilibrium is not None
    assert solution.own.stability is not None
    W, Q, l = symbols("W Q l", positive=True)
    at = {
        r.rhs: s
        for b, s in zip(solution.own.equilibrium.branches, solution.own.stability.verdicts, strict=True)
        for r in b.relations
        if r.lhs == sp.Symbol("theta", real=True)
    }
    assert sp.expand(at[sp.pi].minors[0] - (W - Q / 2) * l) == 0
    assert at[sp.pi].verdict is Stable.CONDITIONAL
    assert sp.expand(at[-sp.pi].minors[0] - (W + Q / 2) * l) == 0
    assert at[-sp.pi].verdict is Stable.STABLE
    assert report(read(HALF)).holds  # in answers angles count modulo 2π


TWO_SPRINGS = """
title: A rod on two springs
parameters: [m, a, k, g, h]
coordinates: [y, phi]
bodies: {rod: {mass: m, inertia: m*a^2/3, position: y*j, angle: phi}}
forces:
  left: {spring: k, between: [-a*i, y*j - a*e1_rod], length: h}
  right: {spring: k, between: [a*i, y*j + a*e1_rod], length: h}
gravity: g*j
find: linearization
"""


def test_what_symmetry_shows_is_found_where_the_whole_has_no_closed_form() -> None:
    """Level, each spring carries half of the weight: y = h + m g/(2 k); then 2k and 2k a² stiffen it."""
    found = solution_of(TWO_SPRINGS).own.linearization
    assert found is not None
    m, k, g, h = symbols("m k g h", positive=True)
    level = {
        sp.expand(r.rhs): at
        for b, at in zip(found.branches, found.at, strict=True)
        for r in b.relations
        if r.lhs == sp.Symbol("y", real=True)
    }
    hanging = level[h + m * g / (2 * k)]
    assert hanging is not None
    assert {f.square for f in hanging.frequencies} == {2 * k / m, 6 * k / m}


UPRIGHT = """
title: A rod held upright by two springs
parameters: [W, k, l, a]
coordinates: [theta]
let: {u: "sin(theta)*i + cos(theta)*j"}
particles: {top: {position: l*u}, mid: {position: a*u}}
forces:
  load: {on: top, vector: -W*j}
  left: {spring: k, between: [mid, "-a*i + a*j"], length: a}
  right: {spring: k, between: [mid, "a*i + a*j"], length: a}
find: equilibrium
"""


def test_what_symmetry_shows_is_verified() -> None:
    found = solution_of(UPRIGHT)
    assert found.holds
    assert relations(found.own.equilibrium)[:2] == [{"theta": "0"}, {"theta": "pi"}]


# Where a force has no value, and what is not lost


def singular(text: str) -> list[tuple[list[str], tuple[str, ...]]]:
    found = solve(read(text)).own.equilibrium
    assert found is not None
    return [([f"{r.lhs} = {r.rhs}" for r in place.branch.relations], place.springs) for place in found.singular]


@pytest.mark.parametrize(
    ("text", "places", "kept"),
    [
        (SPRING_ON_CIRCLE, [(["theta = 0"], ("tie",))], [{"theta": "pi"}, {"cos(theta)": "329/361"}]),
        (STRAIGHT_SPRING, [(["x = 0"], ("tie",))], [{"x": "F/k + l"}, {"x": "F/k - l"}]),
        (POLE, [(["theta = pi"], ())], [{"theta": "0"}, {}]),
    ],
)
def test_a_position_without_force_is_named(text: str, places: list, kept: list[dict[str, str]]) -> None:
    """A spring of length 0, on a circle and on a line, and a pole of a potential."""
    assert singular(text) == places
    assert relations(solve(read(text)).own.equilibrium) == kept
    explained = report(read(text), None, complete=False)
    words = " ".join(
        str(p) for s in explained.derivation.steps for b in s.body if isinstance(b, Prose) for p in b.parts
    )
    assert "not an equilibrium in the ordinary sense" in words


def test_with_symbols_as_with_numbers() -> None:
    """The same spring with a symbol for its stiffness: θ = 0 is named there too."""
    text = SPRING_ON_CIRCLE.replace("coordinates", "parameters: [k]\ncoordinates").replace("400", "k")
    assert singular(text) == [(["theta = 0"], ("tie",))]


def test_no_position_is_lost_by_dividing_by_a_sine() -> None:
    """A skate on a spring: x cos θ + y sin θ = 0 holds for θ = 0 or π with x = 0, for any y."""
    found = solve(read(SKATE)).own.equilibrium
    assert relations(found) == [
        {"y": "-x*cos(theta)/sin(theta)"},
        {"x": "0", "theta": "0"},
        {"x": "0", "theta": "pi"},
    ]
    assert found is not None
    assert found.needs_multipliers  # the elimination divides by sin θ


def test_an_unsolved_linkage_states_its_moments() -> None:
    """β = 0 with the two constraints alone is no equilibrium: the moments have to balance as well; no name is internal."""
    found = solve(read(FOUR_BAR)).own.equilibrium
    assert found is not None
    used = {s.name for b in found.branches for r in b.equations for s in r.residual.free_symbols}
    assert not any("of_equilibrium" in name for name in used)
    assert all(any({"M_1", "M_2"} <= {s.name for s in e.free_symbols} for e in b.left) for b in found.branches)
    for b in found.solution.branches:
        assert not any(v.has(sp.nan, sp.zoo) for p in b.points for v in p.values())


def test_beside_other_angles_an_angle_is_stated_by_both_its_functions() -> None:
    """tan α = −2 has two angles, and each belongs to two positions of the other rods."""
    found = relations(solve(read(PUSHED_LINKAGE)).own.equilibrium)
    assert [r for r in found if "tan(alpha)" in r] == []
    pairs = [("-2*sqrt(5)/5", "sqrt(5)/5"), ("2*sqrt(5)/5", "-sqrt(5)/5")]
    assert [(r["sin(alpha)"], r["cos(alpha)"]) for r in found] == [pairs[0], pairs[0], pairs[1], pairs[1]]
    for r in found:
        for angle in ("beta", "gamma"):
            numbers = (float(sp.sympify(r[f"{f}({angle})"])) for f in ("sin", "cos"))
            assert sum(x**2 for x in numbers) == pytest.approx(1)


WIRE = """
title: a bead on a curve, held by a spring
parameters: {g: positive}
coordinates: [x, y]
particles: {P: {mass: 2, position: x*i + y*j}}
constraints: {c: "0 = y - cosh(x)"}
gravity: -g*j
forces: {s: {spring: 2, between: [2*j, P]}}
find: equilibrium
"""


def test_an_unsolved_equation_has_its_multiplier_put_in() -> None:
    """V = 2 g y + x² + (y − 2)² on y = cosh x: dV/dx = 2 x + (2 g + 2 y − 4) sinh x; λ alone would leave x open."""
    found = solve(read(WIRE)).own.equilibrium
    assert found is not None
    [b] = found.branches
    assert not any(s.name == "lambda_c" for e in b.left for s in e.free_symbols)
    x, y = found.configuration.slots.coordinates
    g = next(s for e in b.left for s in e.free_symbols if s.name == "g")
    force = 2 * x + (2 * g + 2 * y - 4) * sp.sinh(x)
    assert any(sp.expand(e - force) == 0 or sp.expand(e + force) == 0 for e in b.left)


def test_places_without_a_force_are_consistent() -> None:
    """On |x| + |y| = a the slope jumps at the four corners: no list of them has both x = 0 and x = a."""
    text = """
title: a bead on a square
parameters: [m, g, a]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
constraints: {w: "abs(x) + abs(y) = a"}
gravity: -g*j
find: equilibrium
"""
    found = solve(read(text)).own.equilibrium
    assert found is not None
    stated = [[r.lhs.name for r in p.branch.relations if r.lhs.is_Symbol] for p in found.singular]
    assert stated
    assert all(len(names) == len({*names}) for names in stated)
