"""The examples of chapter 6: what MECHANICS' table and the chapter say must come out.

Equations are compared as solution sets, with SymPy's own LagrangesMethod (which shares nothing with this program) or
with equations typed from the chapter; never as printed text.
"""

from __future__ import annotations

import pytest
import sympy as sp
from sympy.physics.mechanics import LagrangesMethod, Particle, Point, ReferenceFrame, dynamicsymbols

from lagrange.answers.equations import Verdict, check_equations
from lagrange.answers.reactions import check_reaction
from lagrange.answers.references import reference_of_solution
from lagrange.core.diagnostics import Fragment
from lagrange.core.symbols import Unspecified
from lagrange.explain.report import Report
from tests.support.shared import SHIPPED, reported


def solved(name: str) -> Report:
    [found] = [n for n in SHIPPED if n.startswith(name)]
    return reported(found)


def verdict(name: str, *equations: str) -> Verdict:
    reference = reference_of_solution(solved(name).solution)
    return check_equations([Fragment.of(e) for e in equations], reference).verdict


@pytest.mark.parametrize(
    ("name", "holonomic", "scleronomic", "rank", "integrable_rank", "freedom", "dimension"),
    [
        ("ex01", True, True, 1, 1, 2, 2),
        ("ex02", True, True, 1, 1, 2, 2),
        ("ex03", True, True, 2, 2, 2, 2),
        ("ex04", True, True, 1, 1, 5, 5),
        ("ex05", False, True, 1, 0, 2, 3),
        ("ex06", False, True, 4, 3, 2, 3),
        ("ex07", True, False, 1, 1, 1, 1),
        ("ex08", True, True, 1, 1, 2, 2),
        ("ex09", True, False, 1, 1, 2, 2),
        ("ex10", True, True, 2, 2, 2, 2),
        ("ex12", True, True, 1, 1, 2, 2),
        ("ex13", True, False, 1, 1, 2, 2),
        ("ex14", True, True, 1, 1, 5, 5),
        ("ex15-rough-surface", True, True, 1, 1, 2, 2),
        ("ex15-rough-incline", True, True, 1, 1, 1, 1),
        ("ex11", True, True, 1, 1, 1, 1),
        ("ex17", True, False, 1, 1, 2, 2),
        ("ex18", True, True, 2, 2, 2, 2),
    ],
)
def test_classification(
    name: str, holonomic: bool, scleronomic: bool, rank: int, integrable_rank: int, freedom: int, dimension: int
) -> None:
    found = solved(name).solution.classification
    assert (found.holonomic, found.scleronomic) == (holonomic, scleronomic)
    assert (found.rank, found.integrable_rank) == (rank, integrable_rank)
    assert (found.degrees_of_freedom, found.configuration_dimension) == (freedom, dimension)


@pytest.mark.parametrize("name", [n for n, p in SHIPPED.items() if p.parent.name == "chapter6"])
def test_every_check_holds_and_the_answers_agree(name: str) -> None:
    result = solved(name)
    assert result.solution.checks
    assert all(c.passed is True for c in result.solution.checks)
    assert result.answers
    assert all(a.verdict is Verdict.EQUIVALENT for a in result.answers)


@pytest.mark.parametrize(
    ("equations", "expected"),
    [
        (("m*x'' = F_x", "m*y'' = F_y"), Verdict.EQUIVALENT),
        (("m*x'' = F_x", "m*y'' = F_y", "z'' = 0"), Verdict.EQUIVALENT),
        (("m*x'' = F_x",), Verdict.INCOMPLETE),
        (("m*x'' = F_x", "m*y'' = F_x"), Verdict.WRONG),
        (("m*x'' = F_x", "m*y'' = F_y", "m*z'' = F_z"), Verdict.WRONG),
    ],
)
def test_ex01_two_components_of_newtons_law(equations: tuple[str, ...], expected: Verdict) -> None:
    """The third component is balanced by the plane, and no equation of motion."""
    assert verdict("ex01", *equations) is expected


def gradient_of(name: str) -> tuple[sp.Expr, ...]:
    """∂f/∂X, ∂f/∂Y, ∂f/∂Z of the surface of a problem, where it is taken there."""
    [constraint] = solved(name).solution.problem.constraints
    [f] = constraint.lhs.atoms(Unspecified)
    return tuple(f.partial(k) for k in range(3))


@pytest.mark.parametrize("name", ["ex02", "ex08"])
def test_the_form_of_a_fixed_surface_is_its_gradient(name: str) -> None:
    """f_x dx + f_y dy + f_z dz = 0, exact; one component of the gradient must not vanish."""
    classification = solved(name).solution.classification
    [row], [surface] = classification.rows, classification.constraints
    assert row.coefficients == gradient_of(name)
    assert row.drift == 0
    assert surface.exactness.exact is True
    [pivot] = solved(name).solution.own.elimination.pivots
    assert pivot in gradient_of(name)


@pytest.mark.parametrize(
    ("equations", "expected"),
    [
        (
            ("cross(m*r_P'' - (F_x*i + F_y*j + F_z*k), diff(f, x)*i + diff(f, y)*j + diff(f, z)*k) = 0",),
            Verdict.EQUIVALENT,
        ),
        (
            (
                "(m*x'' - F_x)*diff(f, y) = (m*y'' - F_y)*diff(f, x)",
                "(m*y'' - F_y)*diff(f, z) = (m*z'' - F_z)*diff(f, y)",
            ),
            Verdict.EQUIVALENT,
        ),
        (
            (
                "m*x'' = F_x + lambda_surface*diff(f, x)",
                "m*y'' = F_y + lambda_surface*diff(f, y)",
                "m*z'' = F_z + lambda_surface*diff(f, z)",
            ),
            Verdict.EQUIVALENT,
        ),
        (("m*x'' = F_x", "m*y'' = F_y"), Verdict.WRONG),
    ],
    ids=["a vector", "components", "reaction along the gradient", "as if there were no surface"],
)
def test_ex02_what_is_left_over_is_along_the_gradient(equations: tuple[str, ...], expected: Verdict) -> None:
    assert verdict("ex02", *equations) is expected


def test_ex04_mass_centre_and_angles_are_independent() -> None:
    """x_C m = m1 x1 + m2 x2, and the rod along (sin θ cos φ, sin θ sin φ, cos θ), differentiated at a rational point."""
    [choice] = solved("ex04").solution.choices
    assert choice.coordinates.satisfied == ("rod",)
    assert choice.configuration.rows == ()
    expressed = choice.configuration.expressed
    m1, m2, length = sp.symbols("m1 m2 l", positive=True)
    x1, x2, z1, z2 = sp.symbols("x1 x2 z1 z2", real=True)
    x_c, theta, phi = sp.symbols("x_C theta phi", real=True)
    assert sp.expand(m1 * expressed[x1] + m2 * expressed[x2] - (m1 + m2) * x_c).simplify() == 0
    assert (expressed[z2] - expressed[z1] - length * sp.cos(theta)).simplify() == 0
    assert (expressed[x2] - expressed[x1] - length * sp.sin(theta) * sp.cos(phi)).simplify() == 0
    new = sp.Matrix(choice.configuration.slots.coordinates)
    place = {m1: 2, m2: 3, length: 1, theta: sp.Rational(2, 3), phi: sp.Rational(1, 5)}
    assert sp.Matrix(list(expressed.values())).jacobian(new).xreplace(place).rank() == 5


def test_ex07_integral() -> None:
    """a11 x1 + a12 x2 + a1t t = c."""
    [rates] = solved("ex07").solution.classification.constraints
    a11, a12, a1t, x1, x2, t = sp.symbols("a_11 a_12 a_1t x1 x2 t", real=True)
    assert rates.exactness.exact is True
    assert rates.integral is not None
    assert sp.expand(rates.integral - a11 * x1 - a12 * x2 - a1t * t) == 0


def test_ex09_the_drift_is_that_of_the_surface() -> None:
    """dr·∇f = u ∂f/∂X dt, δr·∇f = 0; so dr = δr + u dt i is possible for every virtual δr."""
    solution = solved("ex09").solution
    [row] = solution.classification.rows
    u = sp.Symbol("u", real=True)
    gradient = gradient_of("ex09")
    assert row.coefficients == gradient
    assert row.drift == -u * gradient[0]
    dt, *dr = sp.symbols("dt dx dy dz")
    [pivot] = solution.own.elimination.dependent
    delta = dict(zip((k for k in range(3) if k != pivot), dr[1:], strict=True))
    [solved_row] = solution.own.elimination.solution
    delta[pivot] = sum(c * delta[k] for c, k in zip(solved_row, solution.own.elimination.independent, strict=True))
    assert sp.simplify(sum(gradient[k] * delta[k] for k in range(3))) == 0
    possible = [delta[0] + u * dt, delta[1], delta[2]]
    assert sp.simplify(sum(a * d for a, d in zip(row.coefficients, possible, strict=True)) + row.drift * dt) == 0


def test_ex03_angles_satisfy_both_rods_identically() -> None:
    [choice] = solved("ex03").solution.choices
    assert set(choice.coordinates.satisfied) == {"upper_rod", "lower_rod"}
    assert choice.configuration.rows == ()


def test_ex05_frobenius_form_of_the_skate() -> None:
    """ω ∧ dω = −dx ∧ dy ∧ dθ, worked out by hand: dω = cos θ dθ ∧ dx + sin θ dθ ∧ dy."""
    [blade] = solved("ex05").solution.classification.constraints
    x, y, theta = sp.symbols("x y theta", real=True)
    assert blade.exactness.exact is False
    assert blade.integrable is False
    [component] = blade.frobenius
    assert component.variables == (x, y, theta)
    assert component.coefficient == -1


def test_ex06_table_of_coefficients() -> None:
    """The 4 x 6 table of the chapter, its constraint #3 doubled (the gradient of the squared length)."""
    x1, y1, z1, x2, y2, z2 = sp.symbols("x1 y1 z1 x2 y2 z2", real=True)
    rows = solved("ex06").solution.classification.rows
    table = sp.Matrix([r.coefficients for r in rows])
    expected = sp.Matrix(
        [
            [0, 0, 1, 0, 0, 0],
            [0, 0, 0, 0, 0, 1],
            [2 * (x1 - x2), 2 * (y1 - y2), 2 * (z1 - z2), 2 * (x2 - x1), 2 * (y2 - y1), 2 * (z2 - z1)],
            [y2 - y1, -(x2 - x1), 0, y2 - y1, -(x2 - x1), 0],
        ]
    )
    assert sp.expand(table - expected) == sp.zeros(4, 6)
    assert all(r.drift == 0 for r in rows)


def test_ex06_the_pair_that_the_chapter_compares() -> None:
    """∂a_41/∂q_2 = −1 ≠ 1 = ∂a_42/∂q_1."""
    x1, y1 = sp.symbols("x1 y1", real=True)
    blade = solved("ex06").solution.classification.constraints[3]
    pair = next(c for c in blade.exactness.comparisons if c.variables == (x1, y1))
    assert pair.derivatives == (-1, 1)
    assert pair.equal is False
    exact = [c.exactness.exact for c in solved("ex06").solution.classification.constraints]
    assert exact == [True, True, True, False]


def test_ex06_heading_keeps_the_blade() -> None:
    [choice] = solved("ex06").solution.choices
    assert [r.name for r in choice.configuration.rows] == ["blade"]
    assert set(choice.coordinates.satisfied) == {"plane1", "plane2", "rod"}


def symbols(names: str) -> tuple[sp.Symbol, ...]:
    return sp.symbols(names, real=True, seq=True)


def test_ex10_newtons_equations_as_the_chapter_has_them() -> None:
    """T2 pulls A towards B and B towards A, T1 pulls A towards O."""
    m, l, g = sp.symbols("m l g", positive=True)
    x1, y1, x2, y2, t1, t2 = symbols("x1 y1 x2 y2 T1 T2")
    wanted = [
        t2 * (x2 - x1) / l - t1 * x1 / l,
        t2 * (y2 - y1) / l - t1 * y1 / l + m * g,
        -t2 * (x2 - x1) / l,
        -t2 * (y2 - y1) / l + m * g,
    ]
    law = solved("ex10").solution.law
    assert law is not None
    assert law.newton.equations is not None
    left = [a for a, _ in law.newton.equations]
    assert left == [m * a for a in symbols("x1'' y1'' x2'' y2''")]
    assert [sp.expand(b - w) for (_, b), w in zip(law.newton.equations, wanted, strict=True)] == [0] * 4


@pytest.mark.parametrize(
    ("name", "before", "after"),
    [("ex10", (8, 6), (6, 6)), ("ex11", (4, 3), (3, 3)), ("ex14", (12, 7), (7, 7)), ("ex17", (6, 4), (4, 4))],
)
def test_unknowns_and_equations(name: str, before: tuple[int, int], after: tuple[int, int]) -> None:
    """As many equations are missing as there are degrees of freedom; directions close the system."""
    solution = solved(name).solution
    assert solution.law is not None
    first, last = solution.law.newton.before, solution.law.newton.after
    assert first is not None
    assert last is not None
    assert (first.unknowns, first.equations) == before
    assert (last.unknowns, last.equations) == after
    assert first.missing == solution.classification.degrees_of_freedom


def test_ex10_wrong_tensions() -> None:
    right = ["m*x1'' = T2*(x2 - x1)/l - T1*x1/l", "m*y1'' = T2*(y2 - y1)/l - T1*y1/l + m*g"]
    lower = ["m*x2'' = -T2*(x2 - x1)/l", "m*y2'' = -T2*(y2 - y1)/l + m*g"]
    assert verdict("ex10", *right, *lower) is Verdict.EQUIVALENT
    assert verdict("ex10", *right, "m*x2'' = T2*(x2 - x1)/l", lower[1]) is Verdict.WRONG
    assert verdict("ex10", *right) is Verdict.INCOMPLETE


@pytest.mark.parametrize("name", ["ex10", "ex11", "ex12", "ex13", "ex14", "ex15-rough-surface", "ex17", "ex18"])
def test_constraints_are_workless(name: str) -> None:
    works = solved(name).solution.works
    assert works
    assert [w.vanishes for w in works] == [True] * len(works)


def test_ex13_work_in_a_possible_displacement() -> None:
    """R·dr = λ u ∂f/∂X dt, and none on a surface at rest."""
    [work] = solved("ex13").solution.works
    u, dt, x, y, z, t = symbols("u d(t) x y z t")
    slope = Unspecified.of("f", ("X", "Y", "Z"), x - u * t, y, z).partial(0)
    assert sp.expand(work.possible - work.reaction.multiplier * u * slope * dt) == 0
    assert [w.possible for w in solved("ex12").solution.works] == [0]


def test_ex14_the_rod() -> None:
    """R1 = −R2 along the rod; each does virtual work, both together none."""
    solution = solved("ex14").solution
    assert solution.law is not None
    [reaction] = solution.law.newton.reactions
    x1, y1, z1, x2, y2, z2 = symbols("x1 y1 z1 x2 y2 z2")
    first, second = reaction.on("P1"), reaction.on("P2")
    assert first is not None
    assert second is not None
    assert (first + second).map(sp.expand).is_zero
    assert first.components == (2 * x1 - 2 * x2, 2 * y1 - 2 * y2, 2 * z1 - 2 * z2)
    [work] = solution.works
    assert set(work.working) == {"P1", "P2"}
    assert work.vanishes is True


@pytest.mark.parametrize("equation", ["x'' = g*sin(alpha) - mu*g*cos(alpha)", "m*x'' + mu*N = m*g*sin(alpha)"])
def test_ex15_block_on_the_rough_incline(equation: str) -> None:
    assert verdict("ex15-rough-incline", equation) is Verdict.EQUIVALENT
    assert verdict("ex15-rough-incline", equation.replace("mu", "2*mu")) is Verdict.WRONG


def test_ex15_friction_on_any_surface_at_one_state() -> None:
    """f = z − x²/2 and F = (1, 2, −3) at x = 1: the accelerations by hand, m r'' = F + λ∇f − μ|λ||∇f| v/|v|."""
    solution = solved("ex15-rough-surface").solution
    assert solution.own.dynamics is not None
    reactions = solution.own.dynamics.reactions
    assert reactions is not None
    mass, mu = sp.Integer(2), sp.Rational(1, 5)
    gradient, force, v = sp.Matrix([-1, 0, 1]), sp.Matrix([1, 2, -3]), sp.Matrix([2, 1, 2])
    multiplier = -(gradient.dot(force) / mass - v[0] ** 2) * mass / gradient.dot(gradient)
    friction = -mu * abs(multiplier) * gradient.norm() * v / v.norm()
    wanted = (force + multiplier * gradient + friction) / mass
    numbers = {"m": mass, "mu": mu, "x": 1, "y": 0, "z": sp.Rational(1, 2), "x'": 2, "y'": 1, "z'": 2}

    def number(e: sp.Expr) -> sp.Expr:
        slopes = {(1, 0, 0): -1, (0, 0, 1): 1, (2, 0, 0): -1}
        functions = {"F_x": 1, "F_y": 2, "F_z": -3}
        rule = {f: functions[f.name] if f.name in functions else slopes.get(f.orders, 0) for f in e.atoms(Unspecified)}
        plain = e.xreplace({f: sp.Integer(n) for f, n in rule.items()})
        return plain.xreplace({s: sp.sympify(numbers[s.name]) for s in plain.free_symbols}).evalf(30)

    found = reactions.multipliers["surface"]
    assert found is not None
    assert abs(number(found) - multiplier) < 1e-25
    for name, expected in zip("xyz", wanted, strict=True):
        value = reactions.accelerations[sp.Symbol(f"{name}''", real=True)]
        assert value is not None
        assert abs(number(value) - expected.evalf(30)) < 1e-25


@pytest.mark.parametrize(
    ("name", "reaction", "formula"),
    [
        ("ex11", "rod", "T_rod = m*g*cos(theta) + m*l*theta'^2"),
        ("ex17", "length", "lambda_length = m*(r'' - r*theta'^2 - r*phi'^2*sin(theta)^2) + m*g*cos(theta)"),
        ("ex17", "length", "lambda_length = m*(-b*omega^2*cos(omega*t) - r*theta'^2 - r*phi'^2*sin(theta)^2) + m*g*cos(theta)"),
    ],
)  # fmt: skip
def test_reactions_of_the_chapter(name: str, reaction: str, formula: str) -> None:
    solution = solved(name).solution
    assert solution.law is not None
    [found] = [r for r in solution.law.newton.reactions if r.name == reaction]
    reference = reference_of_solution(solution)
    right = check_reaction(Fragment.of(formula), found, reference)
    wrong = check_reaction(Fragment.of(formula.replace("cos(theta)", "sin(theta)")), found, reference)
    assert right is not None
    assert wrong is not None
    assert (right.verdict, wrong.verdict) == (Verdict.EQUIVALENT, Verdict.WRONG)


@pytest.mark.parametrize(
    "equations",
    [
        ("x*(y'' - g) - y*x'' = 0",),
        ("theta'' + g/l*sin(theta) = 0",),
        ("m*l^2*theta'' = -m*g*l*sin(theta)",),
        ("m*x'' = 2*x*lambda_rod", "m*y'' = m*g + 2*y*lambda_rod"),
        ("l*theta'' + g*sin(theta) = 0", "2*l*lambda_rod = -m*g*cos(theta) - m*l*theta'^2"),
    ],
    ids=["chapter, in x and y", "chapter, in the angle", "moments", "with the multiplier", "angle and multiplier"],
)
def test_ex11_equations_of_the_chapter(equations: tuple[str, ...]) -> None:
    assert verdict("ex11", *equations) is Verdict.EQUIVALENT


@pytest.mark.parametrize(
    "equation",
    [
        "theta'' - g/l*sin(theta) = 0",
        "theta'' + g/l*cos(theta) = 0",
        "x*(y'' + g) - y*x'' = 0",
        "theta'' + g/l*theta = 0",
    ],
)
def test_ex11_wrong_equations(equation: str) -> None:
    assert verdict("ex11", equation) is Verdict.WRONG


def test_ex11_second_branch_of_the_depth() -> None:
    choice = solved("ex11").solution.choices[1]
    assert choice.coordinates.branches == 2
    length, y = sp.Symbol("l", positive=True), sp.Symbol("y", real=True)
    [sign] = choice.signs
    [value] = choice.configuration.expressed.values()
    assert value == sign * sp.sqrt(length**2 - y**2)


def test_ex17_virtual_displacement_and_drift() -> None:
    """δr = r δθ e_θ + r sin θ δφ e_φ; dr = −b ω sin ωt dt belongs to possible displacements only."""
    solution = solved("ex17").solution
    [row] = solution.classification.rows
    b, omega, t = sp.Symbol("b", positive=True), sp.Symbol("omega", positive=True), sp.Symbol("t", real=True)
    assert row.coefficients == (1, 0, 0)
    assert row.drift == b * omega * sp.sin(omega * t)
    assert solution.own.elimination.dependent == (0,)
    assert solution.own.elimination.solution == ((0, 0),)


def test_ex18_against_sympy_lagranges_method() -> None:
    """The accelerations that SymPy's LagrangesMethod gives at a rational state, to 40 digits."""
    m1, m2, l1, l2, g = sp.symbols("m1 m2 l1 l2 g", positive=True)
    phi1, phi2 = dynamicsymbols("phi1 phi2")
    frame = ReferenceFrame("N")
    origin = Point("O")
    origin.set_vel(frame, 0)
    first = origin.locatenew("A", l1 * (sp.sin(phi1) * frame.x + sp.cos(phi1) * frame.y))
    second = first.locatenew("B", l2 * (sp.sin(phi2) * frame.x + sp.cos(phi2) * frame.y))
    particles = []
    for point, mass in ((first, m1), (second, m2)):
        point.set_vel(frame, point.pos_from(origin).dt(frame))
        particles.append(Particle(point.name, point, mass))
    kinetic = sum(p.kinetic_energy(frame) for p in particles)
    potential = -g * sum(p.mass * p.point.pos_from(origin).dot(frame.y) for p in particles)
    method = LagrangesMethod(kinetic - potential, [phi1, phi2])
    method.form_lagranges_equations()
    t = dynamicsymbols._t
    numbers = {m1: 2, m2: 3, l1: sp.Rational(7, 5), l2: sp.Rational(3, 4), g: sp.Rational(49, 5)}
    state = {
        "phi1": sp.Rational(2, 3),
        "phi2": sp.Rational(-5, 4),
        "phi1'": sp.Rational(3, 7),
        "phi2'": sp.Rational(8, 5),
    }
    rates = {phi1.diff(t): state["phi1'"], phi2.diff(t): state["phi2'"]}
    place = {phi1: state["phi1"], phi2: state["phi2"]}
    matrix, forcing = (e.subs(rates).subs(place).subs(numbers).evalf(50) for e in (method.mass_matrix, method.forcing))
    theirs = matrix.LUsolve(forcing)

    motion = solved("ex18").solution.choices[0].motion
    assert motion is not None
    given = {sp.Symbol(n, real=True): v for n, v in state.items()} | numbers
    unknown = sp.symbols("phi1'' phi2''", real=True)
    rows = [e.xreplace(given) for e in motion.expressions]
    ours = (
        sp.Matrix([[r.coeff(u) for u in unknown] for r in rows])
        .evalf(50)
        .LUsolve(sp.Matrix([-r.xreplace(dict.fromkeys(unknown, sp.S.Zero)) for r in rows]).evalf(50))
    )
    assert all(abs(a - b) < sp.Float(10) ** -40 for a, b in zip(ours, theirs, strict=True))
