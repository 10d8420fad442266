"""Stability of equilibria."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.algebra.closed_forms.signs import SignCondition
from lagrange.answers.examiner import check_answer
from lagrange.answers.verdicts import Judgement
from lagrange.core.diagnostics import Fragment, Source
from lagrange.explain.report import report
from lagrange.mechanics.equilibrium.stability import Stability
from lagrange.mechanics.equilibrium.stability import StabilityVerdict as Stable
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import read_problem
from lagrange.problem.model import Problem
from lagrange.render.json import as_object
from tests.support.statics_texts import ATWOOD, BEAD, CHAIN, PENDULUM, SPRINGS


def read(text: str) -> Problem:
    return read_problem(Source("problem.yaml", text))


def symbols(names: str, **assumptions: bool) -> tuple[sp.Symbol, ...]:
    return tuple(sp.Symbol(n, **assumptions) for n in names.split())


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
    stability = solve(read(text)).own.stability
    assert stability is not None
    assert [s.verdict for s in stability.verdicts] == verdicts


def test_stability_conditions() -> None:
    a, b = symbols("a b", positive=True)
    stability = solve(read(BEAD)).own.stability
    assert stability is not None
    [c] = stability.verdicts[0].conditions
    assert (c.lhs, c.relation, c.rhs) == (b, ">", a)


TORUS = """
title: a particle on a torus, pushed up
parameters: [m, g, F]
coordinates: [theta, phi]
particles: {P: {mass: m, position: (2 + cos(phi))*cos(theta)*i + (2 + cos(phi))*sin(theta)*j + sin(phi)*k}}
gravity: -g*k
forces: {up: {on: P, vector: F*k}}
find: equilibrium
"""


def test_conditions_of_stability_in_json() -> None:
    """At the top of a torus every turn about its axis is neutral: F > m g leaves the question open."""
    found = as_object(report(read(TORUS)))
    assert found["equilibrium"][:2] == [["phi = pi/2"], ["phi = -pi/2"]]
    assert found["stability"][:2] == ["undecided", "undecided"]
    top, bottom, indifferent = found["stability_conditions"]
    assert top == {"unstable_where": [["F < m*g"]]}
    assert bottom == {"unstable_where": [["F > m*g"]]}
    assert indifferent == {}
    stated = as_object(report(read(BEAD)))["stability_conditions"]
    assert stated == [{"stable_where": ["b > a"]}, {}, {"stable_where": ["a > b"]}]


def test_stability_in_a_choice() -> None:
    angle = solve(read(PENDULUM)).choices[0]
    assert angle.stability is not None
    assert [s.verdict for s in angle.stability.verdicts] == [Stable.STABLE, Stable.UNSTABLE]


def test_no_stability_without_a_potential() -> None:
    """A force that turns with the last rod has no potential."""
    text = CHAIN.replace("vector: P*i", "vector: P*cos(phi)*i + P*sin(phi)*j")
    assert solve(read(text)).own.stability is None


def verdict(problem: Problem, *equations: str) -> Judgement:
    return check_answer(problem, tuple(Fragment.of(e) for e in equations))


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
    stability = solve(read(text)).own.stability
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
    assert solution.own.equilibrium is not None
    assert solution.own.stability is not None
    m, a, b, g = symbols("m a b g", positive=True)
    for branch, s in zip(solution.own.equilibrium.branches, solution.own.stability.verdicts, strict=True):
        below = {str(r.lhs): r.rhs for r in branch.relations}["y"] == -b
        assert s.verdict is (Stable.STABLE if below else Stable.UNSTABLE)
        assert [str(q) for q in s.free] == ["x"]
        assert sp.cancel(s.minors[0] - (1 if below else -1) * m * g * b / a**2) == 0


def test_a_higher_derivative_that_is_a_square_must_not_vanish() -> None:
    a, b = symbols("a b", positive=True)
    s, *_ = stability_of("(a - b)^2*x^4", "x")
    assert (s.verdict, s.order, s.presupposed) == (Stable.STABLE, 4, (SignCondition(a, "≠", b),))


def stability_of(potential: str, coordinates: str = "x, y", constraint: str = "") -> tuple[Stability, ...]:
    text = f"title: v\nparameters: [k, a, b, F]\ncoordinates: [{coordinates}]\nfind: equilibrium\n"
    text += f"forces: {{v: {{potential: '{potential}'}}}}\n" + (
        f"constraints: {{c: {constraint}}}\n" if constraint else ""
    )
    found = solve(read(text)).own.stability
    assert found is not None
    return found.verdicts


@pytest.mark.parametrize(
    ("potential", "verdict"),
    [
        ("k*x*y", Stable.UNSTABLE),  # minors 0, −k²
        ("(k - a)*x^2/2 + (a - k)*y^2/2", Stable.UNSTABLE),  # one of them is negative, whatever the signs
        ("(k - a)*x^2/2 - b*x*y", Stable.UNSTABLE),  # k − a, −b²: the first is open, the second decides
        ("k*x^2/2 + a*x*y + b*y^2/2", Stable.CONDITIONAL),
        ("k*x^2/2 + k*x*y + k*y^2/2", Stable.UNDECIDED),  # never negative, zero along x = −y
        ("(k - a)*x^2/2 + (a - k - b)*y^2/2", Stable.UNSTABLE),  # k > a and a > k + b exclude each other
    ],
)
def test_signs_of_minors_in_two_coordinates(potential: str, verdict: Stable) -> None:
    assert [s.verdict for s in stability_of(potential)] == [verdict]


def test_a_principal_minor_decides_where_the_leading_ones_do_not() -> None:
    """Leading minors 0, 0, 0; the block of x and z is regular and indefinite."""
    k = sp.Symbol("k", positive=True)
    [s] = stability_of("k*x*z + 0*y", "x, y, z")
    assert s.verdict is Stable.UNSTABLE
    assert s.minors == (0, 0, 0)
    assert s.principal == -(k**2)


def test_a_principal_minor_that_is_always_negative_decides_before_one_that_may_vanish() -> None:
    """V = a x²/2 + c x y − b z²/2 + y z with a real c: the leading minor −c² may be 0, and −b is negative."""
    text = """
title: a saddle
parameters: {a: positive, b: positive, c: real}
coordinates: [x, y, z]
forces: {field: {potential: "a*x^2/2 + c*x*y - b*z^2/2 + z*y"}}
"""
    stability = solve(read(text)).own.stability
    assert stability is not None
    [s] = stability.verdicts
    assert (s.verdict, s.presupposed) == (Stable.UNSTABLE, ())


def test_a_sign_that_follows_from_a_product() -> None:
    """A repelled mass on a spring: x = (d k − F)/(c − k) is negative by its condition, and V'' = k − c there."""
    text = """
title: a spring with a length, on a line
parameters: [k, d, F, c]
coordinates: [x]
particles: {P: {position: x*i}}
forces: {s: {spring: k, between: [0*i, P], length: d}, f: {potential: -c*x^2/2 - F*x}}
"""
    stability = solve(read(text)).own.stability
    assert stability is not None
    assert sorted(s.verdict for s in stability.verdicts) == [Stable.CONDITIONAL, Stable.STABLE]


def test_a_zero_minor_with_a_determinant_of_open_sign() -> None:
    """V = k x y + (a − b) z²/2 takes negative values; so does (a − b) x y, unless a = b."""
    assert stability_of("k*x*y + (a - b)*z^2/2", "x, y, z")[0].verdict is Stable.UNSTABLE
    [s] = stability_of("(a - b)*x*y")
    a, b = symbols("a b", positive=True)
    assert s.verdict is Stable.UNSTABLE
    assert s.presupposed == (SignCondition(a, "≠", b),)


def test_a_negative_minor_decides_beside_one_of_open_sign() -> None:
    """V = k (φ − ψ)²/2 + a F sin φ at φ = ψ = π/2: the minors are k − a F and −a F k."""
    verdicts = stability_of("k*(phi - psi)^2/2 + a*F*sin(phi)", "phi, psi")
    assert [s.verdict for s in verdicts] == [Stable.UNSTABLE, Stable.STABLE]


DOUBLE_PENDULUM = """
title: Double pendulum
axes: {i: right, j: up}
parameters: [m, M, g, a, b]
coordinates: [x, y, X, Y]
particles: {P: {mass: m, position: x*i + y*j}, Q: {mass: M, position: X*i + Y*j}}
constraints: {upper: x^2 + y^2 = a^2, lower: (X - x)^2 + (Y - y)^2 = b^2}
gravity: -g*j
find: equilibrium
"""


def test_a_double_pendulum_is_stable_only_if_it_hangs() -> None:
    """With the upper rod up and the lower one down the minors are (M a − (M + m) b) g/(a b) and a negative one."""
    own = solve(read(DOUBLE_PENDULUM)).own
    assert own.stability is not None
    assert own.equilibrium is not None
    a, b = symbols("a b", positive=True)
    height = sp.Symbol("y", real=True), sp.Symbol("Y", real=True)
    for branch, s in zip(own.equilibrium.branches, own.stability.verdicts, strict=True):
        at = {r.lhs: r.rhs for r in branch.relations}
        hangs = sp.expand(at[height[0]] + a) == 0 and sp.expand(at[height[1]] + a + b) == 0
        assert s.verdict is (Stable.STABLE if hangs else Stable.UNSTABLE)


def test_a_branch_is_not_called_stable_where_it_ends() -> None:
    """cos θ = b/a exists where a ≥ b; at a = b its second derivative (a² − b²)/a vanishes."""
    a, b = symbols("a b", positive=True)
    stability = solve(read(BEAD)).own.stability
    assert stability is not None
    assert stability.verdicts[2].verdict is Stable.STABLE
    assert stability.verdicts[2].presupposed == (SignCondition(a, ">", b),)


def test_no_condition_says_what_another_one_implies() -> None:
    """A pendulum in its angles under a force F i: at tan θ = F/(m g), φ = 0 it is stable where cos θ > 0, and cos θ is
    not zero there in any case."""
    theta = sp.Symbol("theta", real=True)
    text = "title: v\nparameters: [m, l, g, F]\ncoordinates: [theta, phi]\nfind: equilibrium\n"
    potential = "-m*g*l*cos(theta) - F*l*sin(theta)*cos(phi)"
    found = solve(read(text + f"forces: {{v: {{potential: '{potential}'}}}}\n")).own
    assert found.stability is not None
    first = found.stability.verdicts[0]
    assert first.verdict is Stable.CONDITIONAL
    assert first.conditions == (SignCondition(sp.cos(theta), ">", sp.S.Zero),)


def test_the_second_derivative_of_a_modulus_is_shown_without_its_jump() -> None:
    """V = k |x − a| + c x²: V'' = 2 c where x ≠ a; a Dirac delta stood on the page."""
    text = (
        "title: Modulus\nparameters: [k, a, c]\ncoordinates: [x]\n"
        "forces: {f: {potential: k*abs(x - a) + c*x^2}}\nfind: equilibrium\n"
    )
    found = solve(read(text))
    second = found.own.stability
    assert second is not None
    assert not any(v.has(sp.DiracDelta) for row in second.matrix for v in row)
    assert len(second.jumps) == 1


def test_an_equilibrium_of_a_sinusoidal_potential_is_judged_without_a_condition() -> None:
    """V = a sin θ + b cos θ: with tan θ = a/b, V'' = −b/cos θ, whatever a and b are in detail."""
    text = (
        "title: Plank\nparameters: {a: positive, b: positive, c: positive}\n"
        "coordinates: {theta: {range: [-90 deg, 90 deg]}}\nparticles: {P: {position: [0, 0]}}\n"
        "forces: {field: {potential: SIGN((a - c)*sin(theta) + b*cos(theta))}}\nfind: equilibrium\n"
    )
    for sign, verdict in (("", Stable.UNSTABLE), ("-", Stable.STABLE)):
        stability = solve(read(text.replace("SIGN", sign))).own.stability
        assert stability is not None
        [found] = stability.verdicts
        assert (found.verdict, found.presupposed) == (verdict, ())


def test_what_keeps_a_sine_from_vanishing_is_stated_in_parameters() -> None:
    """cos θ = [a + √(a² + 32R²)]/(8R) exists for a ≤ 2R, and for a = 2R the rod lies flat on the rim: sin θ = 0."""
    found = solve(
        read(
            "title: Rod in a bowl\nparameters: {W: positive, R: positive, a: positive}\n"
            "coordinates: {theta: {range: [0, pi/2]}}\n"
            "particles: {G: {mass: 0, "
            'position: "(-R*cos(2*theta) + a*cos(theta))*i + (-R*sin(2*theta) + a*sin(theta))*j"}}\n'
            "forces: {weight: {on: G, vector: -W*j}}\nfind: equilibrium\n"
        )
    )
    assert found.own.stability is not None
    [stability] = found.own.stability.verdicts
    assert [(str(c.lhs), c.relation, str(c.rhs)) for c in stability.presupposed] == [("2*R", ">", "a")]


def test_an_equilibrium_beside_equations_that_are_not_solved() -> None:
    """Three links on top of each other, with springs at the joints: K = [c − 2P/l, P/l; P/l, c − 2P/l]."""
    column = read("""title: Column of three links
parameters: [P, l, c]
coordinates: [x, y]
particles: {top: {position: (sqrt(l^2 - x^2) + sqrt(l^2 - (y - x)^2) + sqrt(l^2 - y^2))*j}}
forces: {load: {on: top, vector: -P*j}, springs: {potential: c*(x^2 + y^2)/2}}
find: equilibrium
""")
    stability = solve(column).own.stability
    assert stability is not None
    assert [s.verdict for s in stability.verdicts] == [Stable.CONDITIONAL, Stable.UNDECIDED]
    [condition] = stability.verdicts[0].conditions
    load, length, stiffness = symbols("P l c", positive=True)
    assert (condition.lhs, condition.relation, condition.rhs) == (load, "<", stiffness * length / 3)


@pytest.mark.parametrize(
    ("coordinates", "beside"),
    [
        ("{theta: {range: [0, 90 deg]}}", ""),
        ("{theta: {range: [0, 90 deg]}, u: {}}", '  spring: {potential: "c*u^2/2"}\n'),
        ("{u: {}, theta: {range: [0, 90 deg]}}", '  spring: {potential: "c*u^2/2"}\n'),
    ],
    ids=["alone", "the first of two minors", "the second minor"],
)
def test_an_equilibrium_that_exists_only_where_it_is_unstable_is_unstable(coordinates: str, beside: str) -> None:
    """A drawbridge: sin θ = 1 − 2Q²/W² with θ ≥ 0 needs W ≥ √2 Q, and V'' = L (Q² − W²)/(2W) is negative there."""
    text = """title: Drawbridge
parameters: {W: positive, L: positive, Q: positive, c: positive, b: positive}
coordinates: COORDINATES
particles:
  G: {position: L/2*cos(theta)*i + L/2*sin(theta)*j}
  B: {position: L*cos(theta)*i + L*sin(theta)*j}
forces:
  weight: {on: G, vector: -W*j}
  cable: {potential: Q*norm(r_B - L*j)}
BESIDEfind: equilibrium
""".replace("COORDINATES", coordinates).replace("BESIDE", beside)
    own = solve(read_problem(Source("bridge", text))).own
    assert own.stability is not None
    [verdict] = own.stability.verdicts
    assert (verdict.verdict, verdict.conditions) == (Stable.UNSTABLE, ())
