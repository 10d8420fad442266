"""Small oscillations against numbers from hand-written Lagrangians: nothing of the program takes part in those.

Each system has its problem file, and L(q, v) with the generalized forces Q(q, v) of what has no potential, written by
hand in coordinates that need no constraints. The second derivatives of L are taken numerically at the equilibrium, also
given by hand, at random values of the parameters; det(M p² + D p + K) = 0 is solved in numbers.
"""

from __future__ import annotations

from itertools import pairwise

import pytest
import sympy as sp
from mpmath import diff, matrix, mp, mpc, mpf, polyroots

from lagrange.algebra.closed_forms.signs import SignCondition
from lagrange.algebra.closed_forms.solution_sets import Branch
from lagrange.core.diagnostics import NotCoveredError
from lagrange.explain.rest.oscillations import explain_omitted
from lagrange.mechanics.equilibrium import linearization as linearizations
from lagrange.mechanics.equilibrium.linearization import restrictions
from lagrange.mechanics.equilibrium.stability import StabilityVerdict
from lagsolve.exit_statuses import status_of_error
from tests.support import shared
from tests.support.linearized_systems import (
    CART,
    DOUBLE,
    HOOP,
    IN_X_AND_Y,
    PENDULUM,
    ROD,
    SPHERE,
    SPRING_PENDULUM,
    SYSTEMS,
    Numbers,
    System,
    at_numbers,
    linear_equations,
    numbers,
    of,
    solved,
    there,
)

SEEDS = range(4)


def exponents(system: System, p: Numbers) -> tuple[list[mpc], int]:
    """The roots of det(M p² + D p + K), from the Lagrangian in numbers, and their number."""
    q0 = system.place(p)
    n = len(q0)
    at = [*q0, *[mpf(0)] * n]

    def second(i: int, j: int) -> mpf:
        order = [0] * (2 * n)
        order[i] += 1
        order[j] += 1
        return diff(lambda *s: system.lagrangian(s[:n], s[n:], p), tuple(at), tuple(order))

    def of_force(i: int, j: int) -> mpf:
        if system.force is None:
            return mpf(0)
        order = [0] * (2 * n)
        order[j] = 1
        return diff(lambda *s: system.force(s[:n], s[n:], p)[i], tuple(at), tuple(order))

    mass = matrix(n, n)
    rate = matrix(n, n)
    stiff = matrix(n, n)
    for i in range(n):
        for j in range(n):
            mass[i, j] = second(n + i, n + j)
            rate[i, j] = second(n + i, j) - second(i, n + j) - of_force(i, n + j)
            stiff[i, j] = -second(i, j) - of_force(i, j)
    nodes = [mpf(k) for k in range(-n, n + 1)]
    values = [mp.det(mass * x**2 + rate * x + stiff) for x in nodes]
    powers = matrix([[x**k for k in range(2 * n, -1, -1)] for x in nodes])
    coefficients = list(mp.lu_solve(powers, matrix(values)))
    cleaned = [c if abs(c) > mpf(10) ** -12 else mpf(0) for c in coefficients]
    return polyroots(cleaned, maxsteps=500, extraprec=400), 2 * n


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("name", SYSTEMS)
def test_frequencies_and_stability_are_those_of_the_numbers(name: str, seed: int) -> None:
    system = SYSTEMS[name]
    found = of(system)
    p = numbers(system, seed)
    if not system.exists(p):
        p["Omega"] *= 12
    s = there(found, system, p)
    wanted, number = exponents(system, p)
    values = p | system.coordinates(p)

    polynomial = sp.Poly(s.characteristic, s.unknown)
    assert polynomial.degree() == number
    scale = sum(abs(at_numbers(c, values)) for c in polynomial.all_coeffs())
    for root in wanted:
        unknown = mpc(0, -1) * root if s.oscillates else root
        at = sum(at_numbers(c, values) * unknown**k for (k,), c in polynomial.terms())
        assert abs(at) < scale * (1 + abs(unknown)) ** number * mpf(10) ** -9

    closed = [f for f in s.frequencies if f.square is not None]
    if s.oscillates and len(closed) == len(s.frequencies):
        stated = sorted((at_numbers(f.square, values).real for f in closed for _ in range(f.multiplicity)), key=float)
        squares = sorted((-(r**2) for r in wanted), key=lambda z: float(z.real))[::2]
        for a, b in zip(stated, squares, strict=True):
            if abs(b.imag) < mpf(10) ** -8:
                assert abs(a - b.real) < mpf(10) ** -6 * (1 + abs(b))

    grows = max(r.real for r in wanted) > mpf(10) ** -6
    judged = s.judgement.stability
    if judged.verdict is StabilityVerdict.CONDITIONAL:
        holds = all(
            at_numbers(c.lhs - c.rhs, values).real * (1 if c.relation == ">" else -1) > 0 for c in judged.conditions
        )
        assert holds == (not grows)
    elif judged.verdict is not StabilityVerdict.UNDECIDED:
        assert grows == (judged.verdict is StabilityVerdict.UNSTABLE)
    if s.judgement.asymptotic and judged.verdict is StabilityVerdict.STABLE:
        assert max(r.real for r in wanted) < 0


def test_both_regimes_were_met() -> None:
    """The conditions of the tests above are true at some of their values and false at others."""
    for name in ("hoop-bottom", "parabola", "rod", "magnet"):
        found = of(SYSTEMS[name])
        met = set()
        for seed in range(12):
            p = numbers(SYSTEMS[name], seed)
            s = there(found, SYSTEMS[name], p)
            assert s.judgement.stability.verdict is StabilityVerdict.CONDITIONAL
            met.add(all(at_numbers(c.lhs - c.rhs, p).real * (1 if c.relation == ">" else -1) > 0
                        for c in s.judgement.stability.conditions))  # fmt: skip
        assert met == {True, False}, name


# Modes, verdicts, answers, what is refused


def test_the_second_variation_says_the_same() -> None:
    """Stability from `stability`, by statics, at every equilibrium of systems at rest that do not turn."""
    for text in (PENDULUM, DOUBLE, CART, SPRING_PENDULUM, ROD, IN_X_AND_Y.replace("forces", "answers: {}\n#")):
        solution = solved(text, "find: [equilibrium, linearization]")
        found = linear_equations(solution)
        assert solution.own.equilibrium is not None
        assert solution.own.stability is not None
        assert [b.relations for b in solution.own.equilibrium.branches] == [b.relations for b in found.branches]
        for by_variation, s in zip(solution.own.stability.verdicts, found.at, strict=True):
            if s is not None and by_variation.verdict is not StabilityVerdict.UNDECIDED:
                assert by_variation.verdict is s.judgement.stability.verdict
                assert {str(c) for c in by_variation.conditions} == {str(c) for c in s.judgement.stability.conditions}


NONHOLONOMIC = """
parameters: [m, J, c, k]
coordinates: [x, y, theta]
bodies: {skate: {mass: m, inertia: J, position: x*i + y*j, angle: theta}}
constraints: {blade: "x'*sin(theta) = y'*cos(theta)"}
forces: {springs: {potential: c*x^2/2 + k*theta^2/2}}
"""


def test_a_kinematic_constraint() -> None:
    """A skate at rest along the x axis: across the blade it stays, along it and about it there are springs."""
    found = linear_equations(solved(NONHOLONOMIC))
    [s] = [s for s in found.at if s is not None]
    assert [found.configuration.slots.coordinates[k].name for k in s.free] == ["x", "theta"]
    assert {str(f.square) for f in s.frequencies} == {"c/m", "k/J"}


PULLED = NONHOLONOMIC.replace("k]", "k, f]").replace("c*x^2/2", "c*(x - y)^2/2 - f*y")


def test_a_reaction_that_turns_with_the_body() -> None:
    """At rest the blade bears λ = f; turned by ξ_3 it pushes the skate along: m ξ_1'' + c ξ_1 − f ξ_3 = 0."""
    [s] = [s for s in linear_equations(solved(PULLED)).at if s is not None]
    c, k, f = sp.symbols("c k f", positive=True)
    stiffness = sp.Matrix(s.system.stiffness)
    assert stiffness == sp.Matrix([[c, -f], [0, k]])
    assert not s.system.symmetric


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (PENDULUM.replace("gravity: -g*j", "unknowns: [N]\nforces: {push: {on: P, vector: N*i}}"), "unknown forces"),
        (HOOP.replace("gravity: -g*k", "forces: {wind: {on: P, vector: g*cos(Omega*t)*k}}"), "changes the inertia"),
        (HOOP.replace("Omega*t", "u").replace("coordinates", "functions: {u: [t]}\ncoordinates"), "prescribed motion"),
        (SPHERE.replace("rod: x^2", "rod: (x - m*t)^2"), "moving constraint `rod`"),
        (SPHERE.replace("rod: x^2 + y^2 + z^2 = l^2", "rate: x'^2 + y'^2 = l^2"), "not linear in the velocities"),
        (IN_X_AND_Y.replace("{air:", "{rub: {friction: b, constraint: rod, on: P}, air:"), "dry friction"),
    ],
)
def test_what_is_refused(text: str, said: str) -> None:
    with pytest.raises(NotCoveredError, match=said) as caught:
        solved(text)
    assert status_of_error(caught.value) == 3


def test_modes_of_a_follower_force_and_what_they_presuppose() -> None:
    """(2c − l P) (l P − 2c) once stood below the line."""
    found = shared.solved("ziegler-column").own.linearization
    assert found is not None
    [s] = [s for s in found.at if s is not None]
    for f in s.frequencies:
        [(first, second)] = f.modes
        assert first == 1
        assert sp.fraction(second)[1].count_ops() <= 5
        assert [(c.relation, str(c.lhs), str(c.rhs)) for c in f.presupposed] == [("≠", "2*c", "P*l")]


POLAR_SPRING = """
parameters: [m, c, l, g]
coordinates: [r, phi]
frame: {type: polar, coordinates: [r, phi]}
particles: {P: {mass: m, position: r*e_r}}
gravity: g*i
forces: {spring: {spring: c, between: [0*i, P], length: l}}
"""


def test_the_sign_in_a_spring_has_a_derivative_away_from_its_jump() -> None:
    """The spring's length is |r|; at r = l + m g/c, φ = 0 small motions have ω² = c/m and g/(l + m g/c)."""
    found = linear_equations(solved(POLAR_SPRING))
    m, c, l, g = sp.symbols("m c l g", positive=True)
    assert all(s is not None for s in found.at)
    r = sp.Symbol("r", real=True)
    [lowest] = [
        s
        for b, s in zip(found.branches, found.at, strict=True)
        if any(sp.cancel(x.rhs - l - m * g / c) == 0 for x in b.relations if x.lhs == r)
    ]
    assert lowest is not None
    assert {sp.cancel(f.square) for f in lowest.frequencies if f.square is not None} == {c / m, c * g / (m * g + c * l)}
    assert lowest.judgement.stability.verdict is StabilityVerdict.STABLE


def test_gyroscopic_beside_circulatory_forces() -> None:
    """D antisymmetric, K not symmetric: det(K + p D + p² M) has a term in p, and is no polynomial in ω².

    The numbers are m = k = B = 1 and p = 1/10, where s⁴ + 3s² − s/5 + 101/100 has roots with positive real parts.
    """
    found = solved(
        "parameters: [m, k, p, B]\ncoordinates: [x, y]\nparticles: {P: {mass: m, position: x*i + y*j}}\n"
        "forces: {f: {on: P, vector: \"(-k*x - p*y + B*y')*i + (-k*y + p*x - B*x')*j\"}}\n"
    )
    [oscillation] = found.own.linearization.at  # type: ignore[union-attr]
    assert oscillation is not None
    values = {"m": 1, "k": 1, "B": 1, "p": sp.Rational(1, 10)}
    polynomial = oscillation.characteristic.xreplace(  # type: ignore[union-attr]
        {s: sp.sympify(values[s.name]) for s in oscillation.characteristic.free_symbols if s.name in values}  # type: ignore[union-attr]
    )
    s = oscillation.unknown
    matrix = sp.Matrix([[s**2 + 1, sp.Rational(1, 10) - s], [s - sp.Rational(1, 10), s**2 + 1]])
    assert sp.expand(polynomial - matrix.det()) == 0
    assert max(sp.re(root) for root in sp.Poly(matrix.det(), s).nroots()) > 0
    assert oscillation.judgement.stability.verdict is StabilityVerdict.UNSTABLE


EGG_CRATE = """
parameters: [m, c]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
forces: {crate: {potential: c*cos(x)*cos(y)}}
"""


def test_copies_of_an_equilibrium_are_worked_out_once() -> None:
    """Two tops, two bottoms and four saddles, of which two slope the other way: ξ_2 is reversed."""
    solution = solved(EGG_CRATE)
    assert solution.holds
    linear = linear_equations(solution)
    known = [(s, linear.copy_of(n)) for n, s in enumerate(linear.at) if s is not None]
    assert (len(known), len(linear.originals)) == (8, 3)
    assert [len(copy.reversed) for _, copy in known if copy is not None].count(1) == 2
    for s, copy in known:
        if copy is not None:
            original = linear.at[copy.of]
            assert original is not None
            mine, others = s.system, original.system
            signs = sp.diag(*(-1 if linear.displacements[k] in copy.reversed else 1 for k in s.free))
            for a, b in ((mine.mass, others.mass), (mine.damping, others.damping), (mine.stiffness, others.stiffness)):
                assert (sp.Matrix(a) - signs * sp.Matrix(b) * signs).expand() == sp.zeros(len(s.free))


def test_copies_under_conditions_that_are_written_the_other_way_round() -> None:
    """A ≠ C is C ≠ A, but a > b is not b > a."""
    x, y = sp.symbols("x y", positive=True)
    one, two = (Branch((), conditions=(SignCondition(*sides),)) for sides in ((x, "≠", y), (y, "≠", x)))
    assert restrictions(one) == restrictions(two)
    one, two = (Branch((), conditions=(SignCondition(*sides),)) for sides in ((x, ">", y), (y, ">", x)))
    assert restrictions(one) != restrictions(two)


def test_a_long_chain_has_linear_equations() -> None:
    """Nine masses: more than a polynomial is worked out for, and the verdict does not need it."""
    names = [f"x{n}" for n in range(1, 10)]
    springs = "+".join(f"({a} - {b})^2" for a, b in pairwise(["0", *names, "0"]))
    places = ", ".join(f"P{n}: {{mass: m, position: {n}*i}}" for n in names)
    text = f"parameters: [m, k]\ncoordinates: [{', '.join(names)}]\nparticles: {{{places}}}\n"
    solution = solved(f"{text}forces: {{springs: {{potential: k/2*({springs})}}}}\n")
    assert solution.holds
    [s] = linear_equations(solution).at
    assert s is not None
    assert (len(s.equations), s.characteristic) == (9, None)
    assert s.judgement.stability.verdict is StabilityVerdict.STABLE


def test_every_copy_is_counted_although_equilibria_are_many(monkeypatch: pytest.MonkeyPatch) -> None:
    """9 equilibria of two double wells are copies of 4; of what is beyond the limit the page says how many there are."""
    text = (
        "parameters: [m, k, a]\ncoordinates: [x, y]\nparticles:\n  P: {mass: m, position: x*i}\n"
        "  Q: {mass: 2*m, position: y*i}\nforces: {V: {potential: 'k*((x^2 - a^2)^2 + (y^2 - a^2)^2)/4'}}"
    )
    monkeypatch.setattr("lagrange.mechanics.equilibrium.linearization.MOST_EQUILIBRIA", 4)
    equations = linear_equations(solved(text))
    assert (len(equations.at), len(equations.originals), equations.omitted) == (9, 4, ())
    monkeypatch.setattr("lagrange.mechanics.equilibrium.linearization.MOST_EQUILIBRIA", 3)
    fewer = linear_equations(solved(text))
    assert (len(fewer.originals), len(fewer.omitted)) == (3, 4)
    [said] = explain_omitted(fewer)
    assert said.parts == ("The linear equations about 4 more equilibria are not worked out.",)


WINDING = """
parameters: [m, g, l, R]
coordinates: [theta]
let: {out: cos(theta)*i + sin(theta)*j, along: sin(theta)*i - cos(theta)*j}
particles: {P: {mass: m, position: R*out + (l + R*theta)*along}}
gravity: -g*j
"""


def test_an_angle_beside_its_own_sine_has_its_value_at_rest() -> None:
    """sin θ = 0 leaves θ in R θ + l open by full turns; at θ = 0 it is l, at θ = π it is l + π R."""
    solution = solved(WINDING)
    linear = solution.own.linearization
    assert linear is not None
    g, l, R = (sp.Symbol(n, positive=True) for n in "glR")
    hanging, upright = (s for s in linear.at[:2] if s is not None)
    assert [f.square for f in hanging.system.frequencies] == [g / l]
    assert [sp.simplify(f.square + g / (l + sp.pi * R)) for f in upright.system.frequencies] == [0]
    assert hanging.judgement.stability.verdict is StabilityVerdict.STABLE
    assert all(c.passed for c in solution.checks)


def test_forces_are_differentiated_once_for_all_equilibria(monkeypatch: pytest.MonkeyPatch) -> None:
    """A double pendulum has four, and two forces with two velocities and two angles."""
    taken: list[sp.Symbol] = []
    real = linearizations.partial

    def partial(e: sp.Expr, s: sp.Symbol) -> sp.Expr:
        taken.append(s)
        return real(e, s)

    monkeypatch.setattr(linearizations, "partial", partial)
    linear = solved(DOUBLE).own.linearization
    assert linear is not None
    assert len(linear.branches) == 4
    assert len(taken) == 8
