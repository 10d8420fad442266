"""Steady motions against known results, and against the motion itself in numbers.

The stated frequency is compared with that of a small disturbance: the equations of motion, written down here a second
time, are integrated from a state close to the steady one with the same momenta, and the time between two passages of
the coordinate through its constant value is measured.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import cos, pi, sin, sqrt, tan

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import solve_ivp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.core.diagnostics import NotCoveredError, ProblemError
from lagrange.explain.report import report
from lagrange.explain.rest.steady_motions import explain_steady
from lagrange.mechanics.equilibrium.stability import StabilityVerdict
from lagrange.mechanics.momenta.steady_motions import SteadyMotions
from lagrange.mechanics.solution import solve
from lagrange.render import terminal
from lagrange.render.json import as_object
from lagrange.render.json_momenta import steady_motions as steady_in_json
from tests.support.problem_texts import read

AROUND = 'position: "l*sin(theta)*cos(phi)*i + l*sin(theta)*sin(phi)*j - l*cos(theta)*k"'
CONICAL = f"coordinates: [theta, phi]\nparameters: [m, l, g]\nparticles: {{P: {{mass: m, {AROUND}}}}}\ngravity: -g*k\n"
ORBIT = """coordinates: [r, phi]
parameters: [m, K]
particles: {P: {mass: m, position: "r*cos(phi)*i + r*sin(phi)*j"}}
forces: {V: {potential: "-m*K/r"}}
"""
CONE = """coordinates: [r, phi]
parameters: {m: positive, g: positive, alpha: acute}
particles: {P: {mass: m, position: "r*sin(alpha)*cos(phi)*i + r*sin(alpha)*sin(phi)*j + r*cos(alpha)*k"}}
gravity: -g*k
"""
TOP = """coordinates: [alpha, beta, psi]
parameters: [m, g, l, A, C]
bodies: {top: {mass: m, inertia: [A, A, C], position: 0*i, orientation: {axes: 123, angles: [alpha, beta, psi]}}}
forces: {weight: {potential: m*g*l*cos(alpha)*cos(beta)}}
"""


def found_in(text: str) -> SteadyMotions:
    solution = solve(read(f"title: T\n{text}find: steady\n"))
    assert solution.holds
    assert solution.own.steady is not None
    return solution.own.steady


def number(e: sp.Expr, **values: float) -> float:
    return float(e.xreplace({s: sp.Float(values[s.name.replace("'", "_")]) for s in e.free_symbols}))


def period(rates: Callable[[float, np.ndarray], list[float]], start: list[float], rest: float) -> float:
    """The time between two upward passages of the first coordinate through its constant value."""

    def passage(_: float, y: np.ndarray) -> float:
        return y[0] - rest

    passage.direction = 1  # type: ignore[attr-defined]
    motion = solve_ivp(rates, (0, 20), start, events=passage, rtol=1e-11, atol=1e-13)
    first, *_, last = motion.t_events[0]
    return (last - first) / (len(motion.t_events[0]) - 1)


def test_the_conical_pendulum() -> None:
    found = found_in(CONICAL)
    [branch] = found.families[0].about.branches
    [relation] = branch.equations
    l, g, turn = 0.9, 9.8, 4.1
    rest = float(sp.acos(sp.Float(number(relation.rhs, l=l, g=g, phi_=turn))))
    assert cos(rest) == pytest.approx(g / (l * turn**2))
    momentum = sin(rest) ** 2 * turn

    def rates(_: float, y: np.ndarray) -> list[float]:
        around = momentum / sin(y[0]) ** 2
        return [y[1], around**2 * sin(y[0]) * cos(y[0]) - g / l * sin(y[0])]

    [frequency] = found.families[0].about.at[0].frequencies
    stated = sqrt(number(frequency.square, l=l, g=g, phi_=turn))
    assert stated == pytest.approx(turn * sqrt(1 + 3 * cos(rest) ** 2))  # Whittaker, § 56
    assert period(rates, [rest + 1e-4, 0.0], rest) == pytest.approx(2 * pi / stated, rel=1e-4)
    assert found.families[0].about.at[0].judgement.stability.verdict is StabilityVerdict.STABLE
    assert len(found.general.poles) == 2  # θ = 0 and π, where φ has no meaning


def test_an_orbit_closes() -> None:
    found = found_in(ORBIT)
    [branch] = found.families[0].about.branches
    assert str(branch.equations[0].lhs) == "r**3"  # Kepler's third law
    [frequency] = found.families[0].about.at[0].frequencies
    assert frequency.square == sp.Symbol("phi'", real=True) ** 2


def test_a_particle_in_a_cone() -> None:
    found = found_in(CONE)
    g, alpha, turn = 9.8, 0.5, 3.0
    rest = number(found.families[0].about.branches[0].equations[0].rhs, g=g, alpha=alpha, phi_=turn)
    assert rest == pytest.approx(g / (turn**2 * sin(alpha) * tan(alpha)))
    momentum = rest**2 * turn

    def rates(_: float, y: np.ndarray) -> list[float]:
        return [y[1], momentum**2 / y[0] ** 3 * sin(alpha) ** 2 - g * cos(alpha)]

    [frequency] = found.families[0].about.at[0].frequencies
    stated = sqrt(number(frequency.square, g=g, alpha=alpha, phi_=turn))
    assert period(rates, [rest * 1.0001, 0.0], rest) == pytest.approx(2 * pi / stated, rel=1e-4)


def test_the_sleeping_top_is_stable_where_it_spins_fast() -> None:
    found = found_in(TOP)
    upright = [
        s
        for b, s in zip(found.families[0].about.branches, found.families[0].about.at, strict=True)
        if s is not None and all(r.rhs == 0 for r in b.equations)
    ]
    [s] = upright
    conditions = [c for c in s.judgement.stability.conditions if c.relation == ">"]
    m, g, l, A, C = sp.symbols("m g l A C", positive=True)
    spin = sp.Symbol("psi'", real=True)
    [condition] = conditions
    assert sp.expand(condition.lhs - condition.rhs - (C**2 * spin**2 - 4 * A * m * g * l)) == 0


DISC = """coordinates: {x: x, y: y, phi: heading, theta: {meaning: tilt, range: [0, pi]}, psi: spin}
parameters: [m, R, g]
bodies:
  disc: {mass: m, inertia: [m*R^2/4, m*R^2/4, m*R^2/2], position: x*i + y*j + R*sin(theta)*k,
         orientation: {axes: 313, angles: [phi, theta, psi]}}
constraints: {rolling: "r_disc' + cross(omega_disc, -R*n2_disc) = 0"}
gravity: -g*k
"""


def wobble(tilt: float, turn: float, spin: float) -> float:
    """The frequency of small wobbles of a rolling disc, R = g = 1, from the equations of Neimark and Fufaev."""

    def rates(_: float, y: np.ndarray) -> list[float]:
        theta, rate, across, about = y  # θ, θ', φ' sin θ, ψ' + φ' cos θ; m R² = 4, A = 1, C = 2, m g R = 4
        along = across / tan(theta)  # φ' cos θ
        return [
            rate,
            (across * along - 6 * about * across - 4 * cos(theta)) / 5,
            -rate * along + 2 * rate * about,
            4 * rate * across / 6,
        ]

    def turns(_: float, y: np.ndarray) -> float:
        return y[1]

    turns.direction = 1  # type: ignore[attr-defined]
    start = [tilt + 1e-7, 0.0, turn * sin(tilt), spin + turn * cos(tilt)]
    motion = solve_ivp(rates, (0, 40), start, events=turns, rtol=1e-12, atol=1e-15)
    first, *_, last = motion.t_events[0][1:]
    return 2 * pi * (len(motion.t_events[0]) - 2) / (last - first)


def test_a_disc_rolls_in_a_circle_or_straight_on() -> None:
    circle, straight = found_in(DISC).families
    turn, spin = (sp.Symbol(f"{q}'", real=True) for q in ("phi", "psi"))
    assert {*circle.rates} == {spin}
    assert straight.rates == {turn: 0}
    [of_straight] = straight.about.at
    [condition] = of_straight.judgement.stability.conditions
    R, g = (sp.Symbol(name, positive=True) for name in "Rg")
    assert sp.expand(3 * R * spin**2 - g - (condition.lhs - condition.rhs)) == 0  # Routh, § 244
    [frequency] = of_straight.frequencies
    assert wobble(pi / 2, 0.0, 1.7) == pytest.approx(sqrt(number(frequency.square, R=1, g=1, psi_=1.7)), rel=1e-4)
    [of_circle] = circle.about.at
    tilt, rate = 1.2, 0.8
    turned = number(circle.rates[spin], R=1, g=1, theta=tilt, phi_=rate)
    [frequency] = of_circle.frequencies
    stated = number(frequency.square, R=1, g=1, theta=tilt, phi_=rate)
    assert wobble(tilt, rate, turned) == pytest.approx(sqrt(stated), rel=1e-4)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("coordinates: [x, y]\nparameters: [m, Omega]\nparticles: {P: {mass: m, position: x*i + y*j}}\n"
         "constraints: {pace: x'^2 + y'^2 = Omega^2}\n", "not linear"),
        ("coordinates: [x, y]\nparameters: [m]\nparticles: {P: {mass: m, position: x*i + y*j}}\n"
         "constraints: {blade: x' = (1 + x^2 + y^2)*y'}\n", "depends on `[xy]`"),
        ("coordinates: [x, y]\nparameters: [m, l]\nparticles: {P: {mass: m, position: x*i + y*j}}\n"
         "constraints: {rod: x^2 + y^2 = l^2}\n", "not free"),
        ("coordinates: [x, y]\nparameters: [m, k, w]\nparticles: {P: {mass: m, position: x*i + y*j}}\n"
         "forces: {push: {on: P, vector: k*cos(w*t)*i}}\n", "time"),
    ],
)  # fmt: skip
def test_what_is_refused(text: str, said: str) -> None:
    with pytest.raises(NotCoveredError, match=said):
        solve(read(f"title: T\n{text}find: steady\n"))


def test_a_coordinate_along_which_a_force_acts_is_not_cyclic() -> None:
    text = CONICAL.replace("[m, l, g]", "[m, l, g, c]") + 'forces: {drag: {on: P, vector: "-c*phi\'*(0*i)"}}\n'
    assert [q.name for q in found_in(text).cyclic] == ["phi"]
    text = CONICAL + "forces: {push: {on: P, vector: -m*g*sin(phi)*i + m*g*cos(phi)*j}}\n"
    with pytest.raises(ProblemError, match="`theta`, and the equation of motion of `phi` does not hold"):
        found_in(text)


def test_in_a_paraboloid_one_rate_is_steady_at_every_radius() -> None:
    """z = r²/(2a): φ'² = g/a, and with r² φ' = h the radial equation has (1 + r²/a²) ξ'' + 4 (g/a) ξ = 0."""
    height = "r^2/(2*a)*k"
    found = found_in(
        "coordinates: [r, phi]\nparameters: [m, a, g]\ngravity: -g*k\n"
        f'particles: {{P: {{mass: m, position: "r*cos(phi)*i + r*sin(phi)*j + {height}"}}}}\n'
    )
    [family] = found.families
    [relation] = family.relations(family.about.branches[0])
    assert (str(relation.lhs), str(relation.rhs)) == ("phi'**2", "g/a")
    [frequency] = family.about.at[0].frequencies
    a, g, r = 2.0, 9.8, 0.7
    assert number(frequency.square, a=a, g=g, r=r) == pytest.approx(4 * g / a / (1 + r**2 / a**2))


def test_a_ball_circles_on_a_turntable() -> None:
    """Two sevenths of the rate of the table, wherever the centre of the circle is (Milne, Vectorial Mechanics)."""
    found = found_in("""coordinates: [r, phi, alpha, beta, gamma]
parameters: [m, R, Omega]
frame: {type: polar, coordinates: [r, phi]}
bodies:
  ball: {mass: m, inertia: [2/5*m*R^2, 2/5*m*R^2, 2/5*m*R^2], position: r*e_r, axes: [i, j, k],
         angular_velocity: "alpha'*i + beta'*j + gamma'*k"}
constraints: {rolling: "r_ball' + cross(omega_ball, -R*k) = cross(Omega*k, r*e_r)"}
""")
    [family] = found.families
    omega = sp.Symbol("Omega", positive=True)
    assert [*family.rates.values()] == [2 * omega / 7]
    assert [f.square for f in family.about.at[0].frequencies] == [4 * omega**2 / 49]


def test_a_ball_that_rolls_inside_an_upright_cylinder_goes_up_and_down() -> None:
    """The spin about the normal carries the weight, and the height oscillates with √(2/7) φ' (Neimark and Fufaev)."""
    found = found_in("""coordinates: [phi, z, alpha, beta, gamma]
parameters: [m, R, a, g]
let: {er: cos(phi)*i + sin(phi)*j, ep: -sin(phi)*i + cos(phi)*j}
bodies:
  ball: {mass: m, inertia: [2/5*m*a^2, 2/5*m*a^2, 2/5*m*a^2], position: (R - a)*er + z*k, axes: [er, ep, k],
         angular_velocity: "alpha'*er + beta'*ep + gamma'*k"}
constraints:
  along: "dot(r_ball' + cross(omega_ball, a*er), ep) = 0"
  up: "dot(r_ball' + cross(omega_ball, a*er), k) = 0"
gravity: -g*k
""")
    assert [q.name for q in found.cyclic] == ["phi", "alpha"]
    [family] = [f for f in found.families if f.about.branches]
    [(rate, value)] = family.rates.items()
    [frequency] = family.about.at[0].frequencies
    a, g, spin = 0.3, 9.81, -7.0
    turning = number(value, a=a, g=g, alpha_=spin)
    assert rate.name == "phi'"
    assert turning == pytest.approx(-5 * g / (2 * a * spin))

    def rates(_: float, s: np.ndarray) -> list[float]:  # z, z', α' of the law 7 z'' = −5 g − 2 a φ' α', a α'' = φ' z'
        return [s[1], (-5 * g - 2 * a * turning * s[2]) / 7, turning * s[1] / a]

    measured = 2 * pi / period(rates, [0.0, 0.01, spin], 0.0)
    assert measured == pytest.approx(sqrt(number(frequency.square, a=a, g=g, alpha_=spin)), rel=1e-5)


SPRUNG = f"""coordinates: {{theta: {{range: [0, 90 deg]}}, phi: {{}}}}
parameters: [m, l, g, c, b]
particles: {{P: {{mass: m, {AROUND}}}}}
gravity: -g*k
forces: {{spring: {{spring: c, between: [P, -l*cos(theta)*k], length: b}}}}
"""


def test_a_condition_without_a_closed_position_gives_the_square_of_the_rate() -> None:
    """A conical pendulum that a spring of free length b holds to the axis, against V_eff'' at constant momentum."""
    found = found_in(SPRUNG)
    [family] = found.families
    [value] = family.rates.values()
    [frequency] = family.about.at[0].frequencies
    m, l, g, c, b, theta = 1.3, 0.9, 9.81, 40.0, 0.2, 0.7
    given = {"m": m, "l": l, "g": g, "c": c, "b": b, "theta": theta}
    rate = number(value, **given)
    spring = c * (l * sin(theta) - b) * l * cos(theta)
    assert m * l**2 * rate**2 * sin(theta) * cos(theta) == pytest.approx(m * g * l * sin(theta) + spring)
    momentum = m * l**2 * sin(theta) ** 2 * rate

    def effective(x: float) -> float:
        return momentum**2 / (2 * m * l**2 * sin(x) ** 2) - m * g * l * cos(x) + c * (l * sin(x) - b) ** 2 / 2

    h = 1e-4
    curvature = (effective(theta + h) - 2 * effective(theta) + effective(theta - h)) / h**2
    assert number(frequency.square, **given) == pytest.approx(curvature / (m * l**2), rel=1e-5)
    assert found.complete


SATELLITE = """coordinates: [r, phi, theta]
parameters: [m, K]
let: {A: 1/20, B: 1/5}
bodies: {sat: {mass: m, inertia: 11/50, position: "r*cos(phi)*i + r*sin(phi)*j", angle: phi + theta}}
forces:
  field: {potential: "-K*m/r - K/(2*r^3)*(A + B + 11/50 - 3*(A*cos(theta)^2 + B*sin(theta)^2))"}
"""


def test_a_satellite_points_to_the_earth_on_its_orbit() -> None:
    """The rate, and the exponents of small deviations, against the motion at constant momentum, differentiated."""
    found = found_in(SATELLITE)
    [family] = found.families
    radial = next(n for n, b in enumerate(family.about.branches) if not b.special and b.relations[0].rhs == 0)
    m, K, A, B, C, r = 1.3, 2.1, 0.05, 0.2, 0.22, 1.1
    given = {"m": m, "K": K, "A": A, "B": B, "C": C, "r": r}
    [square] = [x.rhs for x in family.relations(family.about.branches[radial]) if x.lhs.is_Pow]
    rate = sqrt(number(square, **given))
    assert m * r * rate**2 == pytest.approx(K * m / r**2 + 1.5 * K / r**4 * (B + C - 2 * A))
    momentum = (m * r**2 + C) * rate

    def acceleration(state: np.ndarray) -> np.ndarray:
        r, theta, out, turning = state
        rate = (momentum - C * turning) / (m * r**2 + C)
        inward = K * m / r**2 + 1.5 * K / r**4 * (A + B + C - 3 * (A * cos(theta) ** 2 + B * sin(theta) ** 2))
        couple = -3 * K / r**3 * (B - A) * sin(theta) * cos(theta)
        faster = (-couple - 2 * m * r * out * rate) / (m * r**2)
        return np.array([out, turning, r * rate**2 - inward / m, couple / C - faster])

    h, at = 1e-5, np.array([r, 0, 0, 0])
    slopes = np.array([(acceleration(at + h * e) - acceleration(at - h * e)) / (2 * h) for e in np.eye(4)]).T
    of_radial = family.about.at[radial]
    assert of_radial is not None
    tables = (of_radial.system.mass, of_radial.system.damping, of_radial.system.stiffness)
    M, D, S = (np.array([[number(e, **given) for e in row] for row in x]) for x in tables)
    first = np.block([[np.zeros((2, 2)), np.eye(2)], [-np.linalg.solve(M, S), -np.linalg.solve(M, D)]])
    assert np.poly(first) == pytest.approx(np.poly(slopes), rel=1e-6, abs=1e-6)
    assert not [b for b in family.about.branches if b.left]


GIMBALS = """coordinates: [phi, theta, psi]
parameters: [g]
bodies:
  rotor: {mass: 2, inertia: [3, 3, 1], position: 1/2*e3_rotor, orientation: {axes: 313, angles: [phi, theta, psi]}}
  ring: {mass: 0, inertia: [1, 1, 1], position: 0*i, orientation: {axes: 313, angles: [phi, 0, 0]}}
gravity: -g*k
"""


def test_a_gyroscope_asleep_in_gimbals_does_so_at_any_rate() -> None:
    """With sin θ = 0 the condition holds whatever φ' and ψ' are: a solution divided by sin θ loses it.

    About θ = 0, (A + m l²) ξ'' + [C φ' (φ' + ψ') − (A + m l²) φ'² − m g l] ξ = 0.
    """
    found = found_in(GIMBALS)
    inclined, upright = found.families
    assert len(inclined.rates) == 1
    assert [str(r.rhs) for b in upright.about.branches for r in upright.relations(b)] == ["0", "pi"]
    s = upright.about.at[0]
    assert s is not None
    A, C, m, l, g, f, n = 3, 1, 2, 0.5, 9.8, 1.5, 20.0
    expected = (C * f * (f + n) - (A + m * l**2) * f**2 - m * g * l) / (A + m * l**2)
    assert number(s.frequencies[0].square, g=g, phi_=f, psi_=n) == pytest.approx(expected)


def test_a_frequency_too_long_for_a_root_is_a_quotient() -> None:
    """It is given by two coefficients of the linear equation, and in JSON."""
    found = found_in(CONICAL)
    about = found.families[0].about
    [s] = about.at
    assert s is not None
    assert s.long_square is None
    [f] = s.frequencies
    long = replace(s, system=replace(s.system, frequencies=(replace(f, square=None),)))
    assert sp.simplify(long.long_square - f.square) == 0
    family = replace(found.families[0], about=replace(about, at=(long,)))
    assert "divided by that of" in str(explain_steady(replace(found, families=(family,))).body)
    [entry] = steady_in_json(replace(found, families=(family,)), str)
    assert entry["frequencies"] == [str(sp.sqrt(long.long_square))]


@pytest.mark.parametrize("asked", ["steady", "linearization"])
def test_a_particle_that_falls_has_none_and_no_equation_without_sense_is_printed(asked: str) -> None:
    text = "title: T\nparameters: [m, g]\ncoordinates: [x, y]\nparticles: {P: {mass: m, position: x*i + y*j}}\n"
    found = report(read(f"{text}gravity: -g*j\nfind: {asked}\n"))
    page = " ".join(terminal.text(found.derivation, found.notation, 200).split())
    assert "1 = 0" not in page
    assert ("there are no steady motions." if asked == "steady" else "there is no equilibrium.") in page


def test_where_the_coordinates_fail_is_said_of_the_angle_that_fails() -> None:
    text = (
        "title: A top in Cardan angles\nparameters: [A, C, m, g, l]\ncoordinates: [alpha, beta, psi]\n"
        "bodies: {top: {mass: m, inertia: [A, A, C], position: l*e3_top, orientation: {axes: 123, "
        "angles: [alpha, beta, psi]}}}\ngravity: -g*k\nfind: steady\n"
    )
    found = solve(read(text)).own.steady
    assert found is not None
    assert {str(r.lhs) for b in found.general.poles for r in b.relations} == {"beta"}


def test_a_distance_in_a_steady_motion_gives_the_rate() -> None:
    """φ'² = F(r) for beads on a turning rod: about r = G(φ'²) the linear equation would be three times as long."""
    found = solve(
        read(
            "title: Beads on a rod\nparameters: {m: positive, k: positive, l: positive, I: positive}\n"
            "coordinates: [r, phi]\nlet: {u: cos(phi)*i + sin(phi)*j}\n"
            "particles: {A: {mass: m, position: r*u}, B: {mass: m, position: -r*u}}\n"
            "bodies: {rod: {inertia: I, position: 0*i, angle: phi}}\n"
            'forces: {spring: {potential: "2*k*(r - l)^2"}}\nfind: steady\n'
        )
    )
    assert found.own.steady is not None
    [family] = found.own.steady.families
    [value] = family.rates.values()
    at = {"k": 3, "l": 2, "m": 1, "r": 4}
    assert value.xreplace({s: sp.Integer(at[s.name]) for s in value.free_symbols}) == sp.sqrt(3)  # 2·3 (4 − 2)/4
    [small] = family.about.originals
    [frequency] = small.frequencies
    at["I"] = 5
    square = frequency.square.xreplace({s: sp.Integer(at[s.name]) for s in frequency.square.free_symbols})
    # by hand, V'' of the effective potential p²/(2 (2 m r² + I)) + 2 k (r − l)² over the mass 2 m
    p, r = (2 * 16 + 5) * sp.sqrt(3), sp.Symbol("r")
    by_hand = (p**2 / (2 * (2 * r**2 + 5)) + 6 * (r - 2) ** 2).diff(r, 2).subs(r, 4) / 2
    assert sp.simplify(square - by_hand) == 0


def test_a_force_of_any_power_of_the_distance() -> None:
    """Goldstein: φ'² = K r^(n − 1)/m, ω² = (n + 3) φ'²."""
    text = ORBIT.replace("[m, K]", "{m: positive, K: positive, n: real}").replace("-m*K/r", "K*r^(n + 1)/(n + 1)")
    motions = solve(read("title: Orbit\n" + text + "find: steady\n")).views[0].steady
    assert motions is not None
    [oscillations] = motions.families[0].about.at
    assert oscillations is not None
    [frequency] = oscillations.frequencies
    assert frequency.square is not None
    r, n, k, m = (next(s for s in frequency.square.free_symbols if s.name == name) for name in ("r", "n", "K", "m"))
    assert is_zero(frequency.square - (n + 3) * k * r ** (n - 1) / m) is True


def test_a_screened_field_that_does_not_exist_at_the_centre() -> None:
    """V = -K exp(-r/a)/r: m r phi'^2 = K exp(-r/a) (1/r^2 + 1/(a r)); "division by zero" was reported at r = 0."""
    found = as_object(
        report(
            read("""title: Circular orbit in the screened Coulomb field
parameters: [m, K, a]
coordinates: [r, phi]
frame: {type: polar, coordinates: [r, phi]}
particles: {P: {mass: m, position: r*e_r}}
forces: {field: {potential: -K/r*exp(-r/a)}}
find: steady
answers: {steady: ["m*r*phi'^2 = K*exp(-r/a)*(1/r^2 + 1/(a*r))"]}
""")
        )
    )
    assert [a["verdict"] for a in found["answers"]] == ["equivalent"]


@pytest.mark.parametrize(
    ("force", "where"),
    [
        ("K/r^2*exp(-r/b)", "b > r"),
        ("K/r^2 + K*b^2/r^4", "r > b"),
        ("K*r^n", "n + 3 > 0"),
        ("K*(1/r^2 + 1/(b*r))*exp(-r/b)", "b*(b + r) > r**2"),
    ],
)
def test_a_circular_orbit_has_a_positive_radius(force: str, where: str) -> None:
    """It is stable where 3 + r F'/F > 0: screened, 1 > r/b; of a power, n > −3; 1/r² + b²/r⁴ only outside r = b.

    In Yukawa's potential φ'² > 0 does not imply r > 0, and it is stable where b² + b r > r².
    """
    text = f"""title: Orbit
parameters: {{m: positive, K: positive, b: positive, n: real}}
coordinates: [r, phi]
frame: {{type: polar, coordinates: [r, phi]}}
particles: {{P: {{mass: m, position: r*e_r}}}}
forces: {{centre: {{on: P, vector: "-({force})*e_r"}}}}
find: steady
"""
    motions = solve(read(text)).own.steady
    assert motions is not None
    [family] = [f for f in motions.families if f.rates]
    [at] = [s for s in family.about.at if s is not None]
    where_stable = at.judgement.stability.conditions
    said = " and ".join(f"{c.lhs} {c.relation} {c.rhs}" for c in where_stable)
    assert said == where
