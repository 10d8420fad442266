"""Steady states against numbers: a linear system solved with complex numbers, and a motion followed until it is steady.

M, D, K and the force are typed from the drawing of each shipped problem; numpy solves (K − w² M + iwD) z = f.
"""

from __future__ import annotations

from math import hypot

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import solve_ivp

from lagrange.core.diagnostics import ProblemError
from lagrange.explain.report import report
from lagrange.mechanics.equilibrium.response import Response, limiting_amplitudes
from lagrange.mechanics.solution import solve
from lagrange.render import terminal
from lagrange.render.json import as_object
from tests.support.problem_texts import read
from tests.support.shared import reported, solved

m, M, c, b, F, w, e, a, l, g = 1.3, 2.9, 4.7, 0.8, 2.2, 1.7, 0.4, 0.6, 2.1, 9.81
m_1, m_2, c_1, c_2 = 1.1, 0.7, 3.9, 2.3
VALUES = {"m": m, "M": M, "c": c, "b": b, "F": F, "w": w, "e": e, "a": a, "l": l, "g": g, "m_1": m_1, "m_2": m_2,
          "c_1": c_1, "c_2": c_2}  # fmt: skip

SYSTEMS = {  # M, D, K, and f of f e^{iwt}
    "damped-oscillator": ([[m]], [[b]], [[c]], [F]),
    "rotating-unbalance": ([[M + m]], [[b]], [[c]], [m * e * w**2]),
    "shaken-support": ([[m]], [[b]], [[c]], [a * (c + 1j * b * w)]),
    "dynamic-absorber": ([[m_1, 0], [0, m_2]], [[0, 0], [0, 0]], [[c_1 + c_2, -c_2], [-c_2, c_2]], [F, 0]),
    "pendulum-on-a-shaken-pivot": ([[l]], [[0]], [[g]], [a * w**2]),
}


def number(expression: sp.Expr) -> float:
    return float(expression.xreplace({s: sp.Float(VALUES[s.name]) for s in expression.free_symbols}).evalf())


def test_with_damping_in_its_own_support_no_coordinate_stays_at_rest() -> None:
    """(k − m w²)² + (c w)² vanishes nowhere: the frequencies at which a mass rests without damping are none with it."""
    solution = solve(
        read("""title: T
parameters: [m, k, c, F, w]
coordinates: [x, y]
particles: {A: {mass: m, position: x*i}, B: {mass: m, position: y*i}}
forces:
  springs: {potential: k*x^2/2 + k*(y - x)^2/2}
  damper: {damper: c, between: [A, B]}
  drive: {vector: F*cos(w*t)*i, on: A}
find: response
""")
    )
    assert solution.holds  # the second route has a value where the ends of the damper meet
    assert solution.own.response.rests == ((), ())


def response_of(name: str) -> Response:
    found = reported(name).solution.own.response
    assert found is not None
    return found


@pytest.mark.parametrize("name", SYSTEMS)
def test_amplitudes_agree_with_complex_numbers(name: str) -> None:
    report = reported(name)
    assert report.holds, report.shortcomings
    mass, damping, stiffness, force = (np.array(x, complex) for x in SYSTEMS[name])
    z = np.linalg.solve(stiffness - w**2 * mass + 1j * w * damping, force)
    found = response_of(name)
    assert [number(x) for x in found.amplitudes] == pytest.approx(np.abs(z), rel=1e-9)


def test_the_lag_and_the_resonance_of_a_damped_oscillator() -> None:
    found = response_of("damped-oscillator")
    assert found.phases[0] is not None
    z = 1 / (c - m * w**2 + 1j * b * w)
    assert number(found.phases[0]) == pytest.approx(-np.angle(z))
    [square] = found.resonances
    at = number(square)

    def amplitude(s: float) -> float:
        return 1 / hypot(c - m * s, b * s**0.5)

    assert amplitude(at) > max(amplitude(at * 1.01), amplitude(at * 0.99))


def test_the_absorber_stands_still_at_its_own_frequency() -> None:
    found = response_of("dynamic-absorber")
    assert [[number(s) for s in places] for places in found.rests] == [[pytest.approx(c_2 / m_2)], []]
    roots = np.linalg.eigvals(np.linalg.solve([[m_1, 0], [0, m_2]], [[c_1 + c_2, -c_2], [-c_2, c_2]]))
    assert sorted(number(s) for s in found.resonances) == pytest.approx(sorted(roots))


PUSHED = """
parameters: [m, l, g, b, a, w]
coordinates: [theta]
particles: {P: {mass: m, position: "(a*sin(w*t) + l*sin(theta))*i - l*cos(theta)*j"}}
gravity: -g*j
forces: {air: {generalized: {theta: "-b*theta'"}}}
find: response
"""


def test_a_pendulum_followed_until_it_is_steady() -> None:
    found = solve(read(f"title: T\n{PUSHED}")).own.response
    assert found is not None
    small, rate = 1e-4, 2.3
    values = {"m": 1.0, "l": 1.5, "g": 9.81, "b": 1.2, "a": small, "w": rate}

    def rates(t: float, y: np.ndarray) -> list[float]:
        force = -9.81 * np.sin(y[0]) + small * rate**2 * np.sin(rate * t) * np.cos(y[0])
        return [y[1], force / 1.5 - 1.2 * y[1] / 1.5**2]

    end = np.linspace(60, 60 + 2 * np.pi / rate, 400)
    followed = solve_ivp(rates, (0, end[-1]), [0, 0], t_eval=end, rtol=1e-9, atol=1e-13).y[0]
    [amplitude] = found.amplitudes
    stated = amplitude.xreplace({s: sp.Float(values[s.name]) for s in amplitude.free_symbols})
    assert max(abs(followed)) == pytest.approx(float(stated.evalf()), rel=1e-3)


def test_linearization_of_a_driven_system_keeps_its_forced_equations() -> None:
    text = PUSHED.replace("find: response", "find: linearization").replace("a*sin(w*t)", "u").replace(", a, w", "")
    solution = solve(read(f"title: T\nfunctions: {{u: [t]}}\n{text.lstrip()}"))
    assert solution.holds
    forced = solution.own.forced
    assert forced is not None
    [(left, right)] = forced.sides
    mass, length, gravity, air = (sp.Symbol(n, positive=True) for n in "mlgb")
    xi = [sp.Symbol("xi" + "'" * k, real=True) for k in range(3)]
    assert sp.expand(left - mass * length**2 * xi[2] - air * xi[1] - mass * gravity * length * xi[0]) == 0
    assert sp.expand(right + mass * length * sp.Symbol("u''", real=True)) == 0
    assert solution.own.response is None


BEAM = """
parameters: [m, k, l, a, w]
coordinates: [phi]
bodies: {beam: {mass: m, inertia: m*l^2/12, position: "(a*cos(w*t) + l/2*sin(phi))*j + l/2*cos(phi)*i", angle: phi}}
forces: {spring: {potential: "k*phi^2/2"}}
find: response
"""


ON_A_LINE = """title: On an inclined line
parameters: [m, M, b, c, k, F, w, alpha]
coordinates: [x, y{more}]
let: {{u: "cos(alpha)*i + sin(alpha)*j"}}
particles: {{A: {{mass: M, position: x*u}}, B: {{mass: m, position: y*u}}{last}}}
forces: {{tie: {{potential: "k*x^2/2 + c*(x - y)^2/2{energy}"}}, drive: {{on: A, vector: F*cos(w*t)*u}}{damper}}}
find: response
"""


def test_a_damped_absorber_never_stops_the_machine_and_its_ends_may_meet_at_rest() -> None:
    damper = ", rub: {damper: b, between: [A, B]}"
    solution = solve(read(ON_A_LINE.format(more="", last="", energy="", damper=damper)))
    assert all(check.passed for check in solution.checks)
    assert solution.own.response is not None
    assert solution.own.response.rests == ((), ())


def test_a_place_of_rest_is_no_frequency_of_resonance() -> None:
    """Three equal masses: in the mode (1, 0, -1) the middle one is at rest, but nothing is steady there."""
    text = ON_A_LINE.format(more=", z", last=", C: {mass: M, position: z*u}", energy=" + c*(y - z)^2/2 + k*z^2/2",
                            damper="").replace("mass: m", "mass: M")  # fmt: skip
    found = solve(read(text)).own.response
    assert found is not None
    k = 1.9
    stiff = np.array([[k + c, -c, 0], [-c, 2 * c, -c], [0, -c, k + c]])
    zeros = [sorted(number(s.subs(sp.Symbol("k", positive=True), k)) for s in places) for places in found.rests]
    assert zeros == [pytest.approx(sorted(np.linalg.eigvals(stiff[1:, 1:] / M))), [], []]


def test_an_equilibrium_that_is_found_without_sines() -> None:
    solution = solve(read(f"title: T\n{BEAM.lstrip()}"))
    assert solution.holds
    assert solution.own.response is not None
    [amplitude] = solution.own.response.amplitudes
    assert "phi" not in {s.name for s in amplitude.free_symbols}


def test_the_phase_of_the_drive_does_not_change_amplitudes() -> None:
    plain, turned = (
        solve(read(f"title: T\n{text.lstrip()}")).own.response
        for text in (BEAM, BEAM.replace("cos(w*t)", "cos(w*t + pi/6)"))
    )
    assert plain is not None
    assert turned is not None
    assert sp.cancel(plain.amplitudes[0] ** 2 - turned.amplitudes[0] ** 2) == 0
    mass, stiffness, length, amplitude, rate = (sp.Symbol(n, positive=True) for n in ("m", "k", "l", "a", "w"))
    expected = mass * length * amplitude * rate**2 / 2 / (stiffness - mass * length**2 * rate**2 / 3)
    assert sp.cancel(plain.amplitudes[0] ** 2 - expected**2) == 0


def test_json() -> None:
    found = as_object(reported("damped-oscillator"))["response"]
    assert found["amplitudes"].keys() == found["phases"].keys() == {"x"}
    assert found["drive"] == "cos(w*t)"


REFUSED = [
    ("parameters: [m]\ncoordinates: [x]\nparticles: {P: {mass: m, position: x*i}}\nfind: response\n", "nothing drives"),
    (PUSHED.replace("a*sin(w*t)", "a*t^2"), "not harmonic"),
    (PUSHED.replace("a*sin(w*t)", "a*sin(w*t) + a*sin(2*w*t)"), "several frequencies"),
    (PUSHED.replace("coordinates", "functions: {u: [t]}\ncoordinates").replace("a*sin(w*t)", "u"), "no law"),
    (
        PUSHED.replace("a*sin(w*t) + l*sin(theta)", "(l + a*cos(w*t))*sin(theta)").replace(
            "- l*cos(theta)", "- (l + a*cos(w*t))*cos(theta)"
        ),
        "inertia",
    ),
]


@pytest.mark.parametrize(("text", "said"), REFUSED)
def test_what_has_no_steady_state_is_refused_with_the_reason(text: str, said: str) -> None:
    with pytest.raises(ProblemError, match=said):
        solve(read(f"title: T\n{text.lstrip()}"))


@pytest.mark.parametrize(
    ("name", "ends"),
    [
        ("damped-oscillator", ("F/c", "0")),
        ("rotating-unbalance", ("0", "m*e/(M + m)")),
        ("shaken-support", ("a", "0")),
        ("pendulum-on-a-shaken-pivot", ("0", "a/l")),
        ("dynamic-absorber", (None, None)),
    ],
)
def test_what_the_amplitude_tends_to_at_low_and_at_high_frequency(
    name: str, ends: tuple[str | None, str | None]
) -> None:
    found = reported(name).solution.own.response
    assert found is not None
    for value, expected in zip(limiting_amplitudes(found), ends, strict=True):
        assert (value is None) == (expected is None)
        if value is not None and expected is not None:
            symbols = {s.name: s for s in found.amplitudes[0].free_symbols}
            assert sp.simplify(value - sp.sympify(expected, locals=symbols)) == 0


def test_amplitudes_are_collected_in_powers_of_the_frequency() -> None:
    found = reported("rotating-unbalance").solution.own.response
    assert found is not None
    M, m, c, w = (next(s for s in found.amplitudes[0].free_symbols if s.name == n) for n in ("M", "m", "c", "w"))
    sums = found.amplitudes[0].atoms(sp.Add)
    assert any(s in (c - (M + m) * w**2, (M + m) * w**2 - c) for s in sums)


def test_a_car_on_a_wavy_road_resonates_at_a_composed_frequency() -> None:
    """w = 2π v/L; the amplitude over that of the road is √((c² + b² w²)/((c − m w²)² + b² w²)), greatest at √w²."""
    found = solve(
        read(
            "title: Car\ncoordinates: [y]\nparameters: [m, c, b, a, v, L]\nparticles: {P: {mass: m, position: y*j}}\n"
            "let: {s: a*sin(2*pi*v*t/L)}\nforces: {spring: {potential: c*(y - s)^2/2}, "
            "damper: {on: P, vector: \"-b*(y' - s')*j\"}}\nfind: response\n"
        )
    ).own.response
    assert found is not None
    values = {"m": m, "c": c, "b": b, "a": a, "L": 2.0}

    def amplitude(w: float) -> float:
        given = values | {"v": w * 2.0 / (2 * np.pi)}
        [e] = found.amplitudes
        return float(e.xreplace({s: sp.Float(given[s.name]) for s in e.free_symbols}))

    [square] = found.resonances
    top = float(sp.sqrt(square.xreplace({s: sp.Float(values[s.name]) for s in square.free_symbols})))
    assert amplitude(w) == pytest.approx(a * hypot(c, b * w) / hypot(c - m * w**2, b * w))
    assert amplitude(top) > max(amplitude(0.99 * top), amplitude(1.01 * top))


@pytest.mark.parametrize("names", ["m M K F", "M m K F", "m_1 m_2 c F"])
def test_a_factor_has_one_sign_in_motion_and_amplitudes(names: str) -> None:
    """Two free masses on a spring: with every |A| of the amplitudes, no −A in the motion."""
    one, two, stiffness, force = names.split()
    text = f"""
title: T
parameters: [{one}, {two}, {stiffness}, {force}, w]
coordinates: [x, y]
particles: {{A: {{mass: {one}, position: x*i}}, B: {{mass: {two}, position: y*i}}}}
forces: {{one: {{potential: "{stiffness}*(y-x)^2/2"}}, push: {{on: A, vector: {force}*cos(w*t)*i}}}}
find: response
"""
    found = solve(read(text)).own.response
    assert found is not None
    moduli = {m.args[0] for e in found.amplitudes for m in e.atoms(sp.Abs)}
    factors = {f.as_base_exp()[0] for e in found.cosines for f in sp.Mul.make_args(e) if f.as_base_exp()[0].is_Add}
    assert factors == moduli


def test_the_frequency_at_resonance_with_its_number() -> None:
    """A trailer on a road with the wavelength L: 2π v/L = √(2k/m) = √80 s⁻¹."""
    text = """title: Trailer
parameters: {m: 250 kg, k: 10 kN/m, d: 40 mm, L: 5 m, v: 50 km/h}
coordinates: {y: {unit: m}}
particles: {P: {mass: m, position: y*j}}
forces: {springs: {potential: 2*k*(y - d*sin(2*pi*v/L*t))^2/2}}
find: response
"""
    found = report(read(text), complete=False)
    response = solve(read(text)).own.response
    assert response is not None
    [(drive, value)] = response.at_resonance
    numbers = {"m": 250, "k": 10000, "d": 0.04, "L": 5, "v": 50 / 3.6}
    assert float(value.subs({s: numbers[s.name] for s in value.free_symbols})) == pytest.approx(80**0.5)
    assert float(drive.subs({s: numbers[s.name] for s in drive.free_symbols})) == pytest.approx(
        2 * np.pi * 50 / 3.6 / 5
    )
    page = terminal.text(found.derivation, found.notation, 80)
    assert "2π v/L = √(2k/m)    at resonance, that is 2π v/L ≈ 8.944 s⁻¹" in page


def test_how_the_absorber_moves_where_the_mass_rests() -> None:
    """With x = 0 its spring balances the force: c_2 y = −F cos ωt."""
    response = solved("dynamic-absorber").own.response
    assert response is not None
    [rest] = response.rests[0]
    [(q, motion)] = response.beside(rest).items()
    values = {"F": 6, "c_2": 4, "w": 0, "t": 0}
    assert q.name == "y"
    assert motion.xreplace({s: sp.Integer(values[s.name]) for s in motion.free_symbols}) == sp.Rational(-3, 2)


def test_the_frequency_of_an_absorber_lies_between_the_resonances() -> None:
    """Δ = (c_1 + c_2 − m_1 w²)(c_2 − m_2 w²) − c_2² is −c_2² < 0 at w² = c_2/m_2, and positive at 0 and far above."""
    response = solved("dynamic-absorber").chosen.response
    assert response is not None
    [rest] = response.rests[0]
    assert response.is_between_resonances(rest)
    assert not response.is_between_resonances(4 * rest + sum(response.resonances))
