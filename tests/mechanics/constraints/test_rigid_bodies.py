"""Rigid bodies, springs and dampers: orientations, what is refused, what is shown, and that the second route is one.

The motion of many systems is in `test_textbook_systems`; here are the twelve sequences of rotations, and the same top in
three representations.

Quasi-coordinates: a constraint with α' of ω = α' i + β' j + γ' k is judged by how the body is turned.
"""

from __future__ import annotations

import random
from collections.abc import Callable

import pytest
import sympy as sp
from mpmath import mp, mpf

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.answers.references import reference_of_solution
from lagrange.core.diagnostics import Fragment, ProblemError
from lagrange.core.vectors import Vector, turned_axes
from lagrange.document.derivation import Detail
from lagrange.explain.report import report
from lagrange.expressions.reader import read_equation
from lagrange.mechanics.constraints.classification import Classification, classify
from lagrange.mechanics.constraints.rigid_bodies import quasi_coordinates
from lagrange.mechanics.dynamics.comparison import System, compare
from lagrange.mechanics.results import Solution
from lagrange.mechanics.solution import solve
from lagrange.problem.model import Problem
from lagrange.render import latex
from lagrange.render.json import as_object
from tests.support import shared
from tests.support.second_route import (
    Rigid,
    Route,
    accelerations,
    affine,
    constants,
    literature,
    moving,
    number,
    rotation,
    slots,
    solved,
    states,
    t,
)

Read = Callable[[str], Problem]
SEQUENCES = ("121", "123", "131", "132", "212", "213", "231", "232", "312", "313", "321", "323")

BODY = """
title: A body about a fixed point
parameters: [m, g, A, B, C, a, b, c]
coordinates: [phi, theta, psi]
bodies:
  B:
    mass: m
    inertia: [{inertia}]
    position: a*e1_B + b*e2_B + c*e3_B
    orientation: {{axes: {sequence}, angles: [phi, theta, psi]}}
gravity: g*i
"""


def matrix(sequence: str, angles: tuple[sp.Expr, ...]) -> sp.Matrix:
    turned = sp.eye(3)
    for axis, angle in zip(sequence, angles, strict=True):
        turned = turned * rotation("xyz"[int(axis) - 1], angle)
    return turned


def route_of(sequence: str, inertia: tuple[sp.Expr, ...] | sp.Matrix) -> Route:
    """Euler's equations about the fixed point, J w' + w x J w = arm x R^T F, in components of the body."""
    angles = moving("phi theta psi")
    m, g, *arm = constants("m g a b c")
    turned = matrix(sequence, angles)
    skew = turned.T * sp.diff(turned, t)
    w, arm = sp.Matrix([skew[2, 1], skew[0, 2], skew[1, 0]]), sp.Matrix(arm)
    tensor = inertia if isinstance(inertia, sp.Matrix) else sp.diag(*inertia)
    about_point = tensor + m * (arm.dot(arm) * sp.eye(3) - arm * arm.T)
    moment = arm.cross(turned.T * sp.Matrix([m * g, 0, 0]))
    momentum = about_point * w
    return literature("phi theta psi", sp.diff(momentum, t) + w.cross(momentum) - moment)


def same_motion(solution: Solution, route: Route, seed: int) -> None:
    equations = solution.own.motion.expressions
    unknowns = [a.name for a in solution.own.configuration.slots.accelerations]
    names = {s.name for e in equations for s in e.free_symbols} - set(unknowns)
    for state in states(route, names, {}, seed, 2):
        expected = accelerations(route, state).values
        found = solved(affine(list(equations), unknowns, state), unknowns).values
        for u in unknowns:
            assert abs(expected[u] - found[u]) < mpf(10) ** -30 * (1 + abs(expected[u]))


# -- orientations ------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("sequence", SEQUENCES)
def test_every_sequence_against_newton_and_euler(problem: Read, sequence: str) -> None:
    solution = solve(problem(BODY.format(sequence=sequence, inertia="A, B, C")))
    assert solution.holds
    same_motion(solution, route_of(sequence, constants("A B C")), int(sequence))


def test_products_of_inertia_against_newton_and_euler(problem: Read) -> None:
    """A body whose axes are no principal axes; with A = B its triad must take part in the last rotation all the same."""
    text = BODY.replace("[{inertia}]", "[[A, F, E], [F, A, D], [E, D, C]]").replace("A, B, C, a", "A, C, D, E, F, a")
    solution = solve(problem(text.format(sequence="313")))
    assert solution.holds
    A, C, D, E, F = constants("A C D E F")
    same_motion(solution, route_of("313", sp.Matrix([[A, F, E], [F, A, D], [E, D, C]])), 313)


UNBALANCED = """
title: A rotor that turns uniformly
parameters: {J: positive, C: positive, E: real, D: real, Omega: real}
coordinates: [alpha, beta]
bodies:
  rotor:
    inertia: [[J, 0, E], [0, J, D], [E, D, C]]
    position: 0*i
    orientation: {axes: 123, angles: [alpha, beta, Omega*t]}
constraints: {x: {equation: alpha = 0, reaction: M_x}, y: {equation: beta = 0, reaction: M_y}}
"""


def test_the_couple_of_the_bearings_of_an_unbalanced_rotor(problem: Read) -> None:
    """dH/dt of H = Ω (E e_1 + D e_2 + C e_3), which turns with the rotor: Ω² (E e_2 − D e_1)."""
    shown = report(problem(UNBALANCED))
    assert shown.holds
    statement, *_ = as_object(shown)["steps"]
    assert {"matrices": {"J_rotor": [["J", "0", "E"], ["0", "J", "D"], ["E", "D", "C"]]}} in statement["body"]
    E, D, Omega, time = (sp.Symbol(n, real=True) for n in ("E", "D", "Omega", "t"))
    turned = Omega * time
    wanted = {
        "x": -(Omega**2) * (E * sp.sin(turned) + D * sp.cos(turned)),
        "y": Omega**2 * (E * sp.cos(turned) - D * sp.sin(turned)),
    }
    dynamics = shown.solution.own.dynamics
    assert dynamics is not None
    found = dynamics.reactions.multipliers
    level = {sp.Symbol(n, real=True): sp.S.Zero for n in ("alpha", "beta")}
    assert all(is_zero(found[n].xreplace(level) - wanted[n]) for n in wanted)


def test_a_tensor_must_be_constant_in_the_axes_that_are_given(problem: Read) -> None:
    text = TURNED.replace("[{inertia}]", "[[A, B, 0], [B, A, 0], [0, 0, C]]")
    with pytest.raises(ProblemError, match="its tensor of inertia about them does not stay constant"):
        solve(problem(text.format(spin="psi'*k")))


@pytest.mark.parametrize("sequence", ["313", "212", "121", "132"])
def test_two_equal_moments_about_the_last_axis(problem: Read, sequence: str) -> None:
    """The triad leaves the last rotation out, and the motion is that of Newton and Euler all the same."""
    moments = ["A", "A", "A"]
    moments[int(sequence[-1]) - 1] = "C"
    given = problem(BODY.format(sequence=sequence, inertia=", ".join(moments)))
    assert given.slots.coordinates[2] not in given.bodies[0].orientation(given.slots).triad.directions.free_symbols
    solution = solve(given)
    assert solution.holds
    same_motion(solution, route_of(sequence, tuple(constants(" ".join(moments)))), int(sequence))


@pytest.mark.parametrize("sequence", SEQUENCES)
@pytest.mark.parametrize("inertia", ["A, B, C", "A, A, C", "A, B, A", "A, B, B", "A, A, A"])
def test_axes_and_angular_velocity(problem: Read, sequence: str, inertia: str) -> None:
    """The axes are the columns of the rotation; ω and the turning of the triad follow from R' R^T."""
    given = problem(BODY.format(sequence=sequence, inertia=inertia))
    found = given.bodies[0].orientation(given.slots)
    angles = moving("phi theta psi")
    turned = matrix(sequence, angles)
    spin = Rigid(sp.S.One, (0, 0, 0), turned, (1, 1, 1)).omega
    real = {s: sp.Symbol(s.name, real=True) for e in [*turned, *spin] for s in slots(e).free_symbols}
    for n, name in enumerate(("e1_B", "e2_B", "e3_B")):
        column = [slots(e).xreplace(real) for e in turned[:, n]]
        assert all(is_zero(a - b) for a, b in zip(found.vectors[name].fixed().components, column, strict=True))
    wanted = [slots(e).xreplace(real) for e in spin]
    assert all(is_zero(a - b) for a, b in zip(found.angular_velocity.fixed().components, wanted, strict=True))


def test_derivatives_in_a_turning_triad_are_those_in_fixed_axes(problem: Read) -> None:
    given = problem(BODY.format(sequence="231", inertia="A, B, C"))
    found = given.bodies[0].orientation(given.slots)
    for vector in (found.angular_velocity, *found.vectors.values()):
        here, there = vector.time_derivative(given.slots).fixed(), vector.fixed().time_derivative(given.slots)
        assert all(is_zero(c) for c in (here - there).components)


def test_rotations_are_about_the_axes_of_the_body() -> None:
    """A quarter turn about e3 takes e1 to j; one about that, right-handed, takes e2 = -i to k and e3 = k to i."""
    quarter = sp.pi / 2
    first, second, third = turned_axes(((3, quarter), (1, quarter)))
    assert [v.components for v in (first, second, third)] == [(0, 1, 0), (0, 0, 1), (1, 0, 0)]


# -- the same top in three representations -----------------------------------------------------------------------------


def solution_of(name: str) -> Solution:
    return shared.solved(name)


def angular_acceleration(
    solution: Solution, sequence: str, names: str, angles: list[mpf], rates: list[mpf], constants_: dict[str, mpf]
) -> list[mpf]:
    """d omega/dt in fixed components, with the accelerations that the program's equations give."""
    listed = names.split()
    state = constants_ | dict(zip(listed, angles, strict=True))
    state |= {f"{n}'": v for n, v in zip(listed, rates, strict=True)}
    unknowns = [f"{n}''" for n in listed]
    state |= solved(affine(list(solution.own.motion.expressions), unknowns, state), unknowns).values
    turned = matrix(sequence, moving(names))
    omega = Rigid(sp.S.One, (0, 0, 0), turned, (1, 1, 1)).omega
    return [number(slots(sp.diff(w, t)), state) for w in omega]


def test_euler_and_cardan_angles_give_the_same_angular_acceleration() -> None:
    """One physical state, in the angles 313 and 123."""
    source = random.Random(7)
    given = {n: mpf(source.randint(3, 20)) / 7 for n in ("m", "g", "l", "A", "C")}
    with mp.workdps(60):
        euler = [mpf(source.randint(4, 9)) / 11 for _ in range(3)]
        euler_rates = [mpf(source.randint(-9, 9)) / 5 for _ in range(3)]
        state = dict(zip(("phi", "theta", "psi"), euler, strict=True))
        state |= dict(zip(("phi'", "theta'", "psi'"), euler_rates, strict=True))
        turned = matrix("313", moving("phi theta psi"))
        r = [[number(slots(turned[a, b]), state) for b in range(3)] for a in range(3)]
        omega = Rigid(sp.S.One, (0, 0, 0), turned, (1, 1, 1)).omega
        w = mp.matrix([number(slots(c), state) for c in omega])
        cardan = [mp.atan2(-r[1][2], r[2][2]), mp.asin(r[0][2]), mp.atan2(-r[0][1], r[0][0])]
        sa, ca, sb, cb = mp.sin(cardan[0]), mp.cos(cardan[0]), mp.sin(cardan[1]), mp.cos(cardan[1])
        jacobian = mp.matrix([[1, 0, sb], [0, ca, -sa * cb], [0, sa, ca * cb]])
        cardan_rates = list(mp.lu_solve(jacobian, w))
        one = angular_acceleration(solution_of("heavy_top"), "313", "phi theta psi", euler, euler_rates, given)
        two = angular_acceleration(
            solution_of("heavy_top_cardan"), "123", "alpha beta gamma", cardan, cardan_rates, given
        )
        assert max(map(abs, one)) > 0.01
        assert all(abs(a - b) < mpf(10) ** -40 for a, b in zip(one, two, strict=True))


def test_a_ball_on_a_turning_table_runs_in_circles() -> None:
    """x'' = -(2/7) Omega y', y'' = (2/7) Omega x', exactly, whatever the spin of the ball."""
    solution = solution_of("ball_on_turntable")
    scope = reference_of_solution(solution).scope
    system = System(solution.own.configuration, solution.own.motion.expressions)
    for factor, agrees in ((sp.Rational(2, 7), True), (sp.Rational(2, 5), False)):
        texts = [f"x'' = -{factor}*Omega*y'", f"y'' = {factor}*Omega*x'"]
        read = [read_equation(Fragment.of(e), scope) for e in texts]
        result = compare([e.lhs - e.rhs for e in read], system)
        assert result is not None
        assert all(s.name == "FOLLOWS" for s in result.standings) is agrees


# -- what is refused -----------------------------------------------------------------------------------------------------

TURNED = """
title: A wheel in axes of its fork
parameters: [m, A, B, C]
coordinates: [phi, psi]
let: {{e1: cos(phi)*i + sin(phi)*j, e2: -sin(phi)*i + cos(phi)*j}}
bodies:
  B: {{inertia: [{inertia}], position: 0*i, axes: [e1, e2, k], angular_velocity: {spin}}}
"""


@pytest.mark.parametrize(
    ("inertia", "spin", "constant"),
    [
        ("A, A, C", "2*phi'*k", True),
        ("A, B, B", "phi'*k + psi'*e1", True),
        ("A, A, A", "phi'*k + psi'*(e1 + 2*e2 + k)", True),
        ("A, B, A", "phi'*k + psi'*e2", True),
        ("A, B, C", "phi'*k", True),
        ("A, B, C", "phi'*k + psi'*k", False),
        ("A, A, C", "phi'*k + psi'*e1", False),
        ("A, B, B", "phi'*k + psi'*e2", False),
        ("A, A, C", "psi'*k + phi'*e2", False),
        ("2*m, 2*m, m", "2*phi'*k", True),
        ("2*m, 3*m, m", "psi'*k", False),
    ],
)
def test_moments_must_be_constant_in_the_axes(problem: Read, inertia: str, spin: str, constant: bool) -> None:
    text = TURNED.format(inertia=inertia, spin=spin)
    if "psi'" not in spin:
        text = text.replace("[phi, psi]", "[phi]")
    if constant:
        assert solve(problem(text)).holds
        return
    with pytest.raises(ProblemError) as refused:
        solve(problem(text))
    [found] = refused.value.diagnostics
    assert found.code == "varying-inertia"


def test_constant_where_the_constraints_make_it_so(problem: Read) -> None:
    """Quasi-coordinates: the axes are those of the body because the constraint says that they turn with it."""
    text = TURNED.format(inertia="A, B, C", spin="psi'*k")
    with pytest.raises(ProblemError, match="stay constant"):
        solve(problem(text))
    assert solve(problem(text + "constraints: {with_it: psi' = phi'}\n")).holds


def test_what_does_not_depend_on_an_idle_rotation_is_named(problem: Read) -> None:
    text = """
title: A point mass with three angles
parameters: [m, l, g]
coordinates: [phi, theta, psi]
bodies:
  bob: {mass: m, inertia: [0, 0, 0], position: -l*e3_bob, orientation: {axes: 313, angles: [phi, theta, psi]}}
gravity: -g*k
find: motion
"""
    with pytest.raises(ProblemError) as refused:
        solve(problem(text))
    assert "`phi` and `theta` do not depend on it" in str(refused.value.diagnostics[0].help)
    assert solve(problem(text.replace("[phi, theta, psi]}}", "[phi, theta, 0]}}").replace(", psi]", "]"))).holds


def test_a_body_without_inertia_needs_something_that_moves_mass(problem: Read) -> None:
    text = """
title: Massless crank
parameters: [m, l, g]
coordinates: [theta]
bodies: {{crank: {{mass: {mass}, inertia: 0, position: l*e1_crank, angle: theta}}}}
gravity: g*i
find: motion
"""
    with pytest.raises(ProblemError) as refused:
        solve(problem(text.format(mass=0)))
    [found] = refused.value.diagnostics
    assert found.code == "no-inertia"
    assert "`crank` then turns about an axis about which it has no moment of inertia" in found.message
    assert found.span is not None
    solution = solve(problem(text.format(mass="m")))
    assert solution.holds
    theta = sp.Symbol("theta", real=True)
    g, l = (next(p.symbol for p in solution.problem.parameters if p.symbol.name == n) for n in "gl")
    wanted = l * sp.Symbol("theta''", real=True) + g * sp.sin(theta)
    assert is_zero(solution.own.motion.expressions[0] - wanted)


def test_a_position_may_use_the_axes_of_its_body_but_not_itself(problem: Read) -> None:
    text = "title: T\nparameters: [m, a]\ncoordinates: [q]\nbodies: {{B: {{mass: m, inertia: m, position: {at}, angle: q}}}}\n"
    assert problem(text.format(at="a*e1_B")).bodies[0].position.fixed().components[0].has(sp.cos)
    with pytest.raises(ProblemError) as refused:
        problem(text.format(at="a*e1_B + r_B"))
    assert [d.code for d in refused.value.diagnostics] == ["circular-definition"]


def test_all_mistakes_of_a_body_are_reported_once(problem: Read) -> None:
    text = "title: T\ncoordinates: [x]\nbodies: {B: {mass: mm, inertia: [x, 1, 1], position: yy*i, orientation: 3}}\n"
    with pytest.raises(ProblemError) as refused:
        problem(text)
    found = [str(d.message) for d in refused.value.diagnostics]
    assert len(found) == len(set(found))
    for word in ("mm", "yy", "moment of inertia"):
        assert any(word in message for message in found), word


# -- what is shown -------------------------------------------------------------------------------------------------------

TRUE_BY_ITSELF = (
    "position",
    "force",
    "moment",
    "spin",
    "momentum",
    "momentum-rate",
    "rotation",
    "delta",
    "acceleration",
)


@pytest.mark.parametrize(
    "name",
    ["heavy_top", "heavy_top_without_spin", "free_top", "rolling_disc", "pushed_plate", "braced_rods", "driven_plate"],
)
def test_equations_between_vectors_are_identities(name: str) -> None:
    """ω, H, dH/dt, M and δπ are read back with meanings of their own."""
    found = shared.reported(name)
    scope = reference_of_solution(found.solution).scope
    names = {r.name for r in found.solution.own.configuration.rotations}
    own = {f"{kind}-{n}" for kind in TRUE_BY_ITSELF for n in names}
    shown = [e for s in as_object(found)["steps"] for b in s["body"] for e in b.get("equations", ())]
    said = [e["text"] for e in shown if e.get("label") in own]
    assert len(said) >= 5
    for text in said:
        first, *others = text.split(" = ")
        for other in others:
            equation = read_equation(Fragment.of(f"{first} = {other}"), scope)
            assert isinstance(equation.lhs, Vector)
            assert isinstance(equation.rhs, Vector)
            assert all(is_zero(c) for c in (equation.lhs - equation.rhs).components), text


def test_time_in_an_orientation_is_said() -> None:
    solution = solution_of("driven_wheel")
    assert solution.classification.driven == ("wheel",)
    assert solution.classification.moving == ()
    assert solution.classification.scleronomic is False


# -- statics -------------------------------------------------------------------------------------------------------------

HELD = """
title: A rod held by a moment and a pull
parameters: [m, g, a, M_0]
coordinates: [theta]
unknowns: [P]
bodies: {{rod: {{mass: m, inertia: m*a^2/3, position: a*e1_rod, angle: theta}}}}
forces:
  motor: {{on: rod, moment: {moment}}}
  pull: {{on: rod, vector: -P*j, at: 2*a*e1_rod}}
gravity: g*i
find: equilibrium
answers: {{equilibrium: [P = (M_0 - m*g*a*sin(theta))/(2*a*cos(theta))]}}
"""


def test_a_body_in_equilibrium(problem: Read) -> None:
    """Moments about the pin: M_0 = m g a sin(theta) + P 2 a cos(theta)."""
    found = report(problem(HELD.format(moment="M_0*k")))
    assert found.holds
    assert {a.name: a.verdict.value for a in found.answers}["equilibrium"] == "equivalent"
    assert not report(problem(HELD.format(moment="2*M_0*k"))).holds


def test_a_moment_that_depends_on_the_motion_has_no_place_in_statics(problem: Read) -> None:
    with pytest.raises(ProblemError) as refused:
        solve(problem(HELD.format(moment="(M_0 - m*theta')*k")))
    assert [d.code for d in refused.value.diagnostics] == ["force-of-motion"]


# Quasi coordinates


BALL = """
title: A ball on a plane
parameters: [m, R, I]
coordinates: [x, y, alpha, beta, gamma]
bodies:
  ball: {mass: m, inertia: [I, I, I], position: x*i + y*j + R*k, axes: [i, j, k],
         angular_velocity: "alpha'*i + beta'*j + gamma'*k"}
constraints:
"""
ROLLING = '  rolling: "r_ball\' + cross(omega_ball, -R*k) = 0"\n'
EULER = """
title: The same ball with angles
parameters: [m, R, I]
coordinates: [x, y, phi, theta, psi]
bodies:
  ball: {mass: m, inertia: [I, I, I], position: x*i + y*j + R*k, orientation: {axes: 313, angles: [phi, theta, psi]}}
constraints:
"""


def ranks(c: Classification) -> tuple[int, int | None, bool | None]:
    return c.rank, c.integrable_rank, c.holonomic


@pytest.mark.parametrize(
    ("constraints", "rank", "integrable"),
    [
        (ROLLING, 2, 0),
        (ROLLING + '  no_pivot: "dot(omega_ball, k) = 0"\n', 3, 0),
        ('  spin: "dot(omega_ball, i) = dot(omega_ball, j)"\n', 1, 0),
        ('  still: "omega_ball = 0"\n', 3, 3),
        (ROLLING + '  groove: "y\' = 0"\n', 3, 1),
    ],
)
def test_a_ball_is_classified_as_with_angles(problem: Read, constraints: str, rank: int, integrable: int) -> None:
    """A rolling ball can be brought to any place, turned in any way: it is nonholonomic."""
    quasi, angles = (classify(problem(text + constraints)) for text in (BALL, EULER))
    assert ranks(quasi) == ranks(angles) == (rank, integrable, rank == integrable)
    if integrable < rank:  # ω = 0 has its components along other axes in the other file
        assert [c.integrable for c in quasi.constraints] == [c.integrable for c in angles.constraints]
    assert not any(q.name in str(c.integral) for c in quasi.constraints for q in c.quasi)


def test_what_is_said_and_checked(problem: Read) -> None:
    found = report(problem(BALL + ROLLING))
    assert found.holds
    assert "is exact" not in latex.render([(found.derivation, found.notation)])
    text = latex.render([(found.derivation, found.notation)], detail=Detail.FULL)
    assert "a quasi-coordinate: the time integral of a component of an angular velocity, which determines no" in text
    complete = latex.render([(found.derivation, found.notation)], detail=Detail.FULL)
    assert "is exact" not in complete
    assert "Frobenius' condition fails for the rolling 1 constraint" in complete


@pytest.mark.parametrize(
    ("spin", "constraints", "rank", "integrable", "reachable"),
    [
        ("alpha'*i + beta'*j", ROLLING, 2, 0, 5),
        ("beta'*j + alpha'*k", ROLLING, 2, 1, 4),  # y' = 0
        ("alpha'*(i + k) + beta'*(j - k)", ROLLING, 2, 0, 5),
        ("alpha'*i + beta'*j", '  turned: "alpha\' = 0"\n', 1, 1, 3),
        ("alpha'*i + beta'*j", "  turned: \"alpha' = 2*beta'\"\n", 1, 1, 3),
        ("alpha'*i + beta'*j", "  turned: \"alpha' = y*beta'\"\n", 1, 0, 5),
        ("alpha'*i + beta'*j", '  line: "x = y"\n', 1, 1, 4),
        ("alpha'*i + beta'*j", ROLLING + '  groove: "y\' = 0"\n', 3, 3, 1),
        ("alpha'*i + beta'*j", ROLLING + '  groove: "y = x"\n', 3, 3, 1),
        ("alpha'*i + beta'*j", ROLLING + '  groove: "y = x^2"\n', 3, 3, 1),
        ("alpha'*(cos(x)*i + sin(x)*j)", '  driven: "alpha\' = x\'"\n  line: "y\' = 0"\n', 2, 2, 1),
        ("alpha'*(cos(x)*i + sin(x)*j)", "  driven: \"alpha' = y'\"\n", 1, 0, 5),
    ],
)
def test_fewer_than_three_restrict_the_rotation(
    problem: Read, spin: str, constraints: str, rank: int, integrable: int, reachable: int
) -> None:
    """Compared with ranks found by hand, in three angles with the constraints that the angular velocity states.

    With one component of ω zero, a rolling ball still reaches every place and orientation (Chow): 2 + 3 dimensions.
    """
    text = BALL.replace("alpha'*i + beta'*j + gamma'*k", spin).replace(", gamma", "")
    text = text if "beta" in spin else text.replace(", beta", "")
    found = classify(problem(text + constraints))
    assert ranks(found) == (rank, integrable, rank == integrable)
    if found.further_angles:
        assert found.reachable_dimension == reachable
    assert None not in [c.integrable for c in found.constraints]


def test_words_on_a_restricted_rotation(problem: Read) -> None:
    text = (BALL + ROLLING).replace(" + gamma'*k", "").replace(", gamma", "")
    known = report(problem(text))
    assert known.holds
    page = latex.render([(known.derivation, known.notation)], detail=Detail.FULL)
    assert "the constraint implies no finite relation: it is" in page
    assert "has dimension 5, the orientation of a body counted with three angles" in page


@pytest.mark.parametrize(
    "spin", ["phi'*k + theta'*(cos(phi)*i + sin(phi)*j)", "phi'*k", "0.5*t*k + phi'*k", "theta'*j"]
)
def test_angles_are_no_quasi_coordinates(problem: Read, spin: str) -> None:
    text = EULER.replace(
        "orientation: {axes: 313, angles: [phi, theta, psi]}", f'axes: [i, j, k], angular_velocity: "{spin}"'
    )
    assert quasi_coordinates(problem(text + "  turned: \"phi' = theta'\"\n")) is None
