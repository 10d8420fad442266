"""Results in numbers on the page and in JSON, against what is computed here in floating point."""

from __future__ import annotations

import json
import math
import subprocess
import sys
from collections.abc import Callable
from typing import Any

import pytest

from lagrange.core.diagnostics import Fragment, Source
from lagrange.explain.report import Report, report
from lagrange.problem.loader import read_problem
from lagrange.problem.model import Problem
from lagrange.render import html, latex, markdown, terminal
from lagrange.render.json import render
from tests.support.paths import PROBLEMS, ROOT

PENDULUM = """title: Pendulum
axes: {i: right, j: down}
parameters: {m: {value: 2 kg}, l: {value: 30 cm}, g: {value: 9.81 m/s^2}}
coordinates: [theta]
particles: {P: {mass: m, position: l*sin(theta)*i + l*cos(theta)*j}}
gravity: g*j
find: linearization
"""
COLUMN = """title: Column
axes: {j: up}
parameters: {k: {value: 200 N/m}, l: {value: 50 cm}, P: {value: 30 N}}
coordinates: [theta]
particles: {A: {position: l*sin(theta)*i + l*cos(theta)*j}}
forces: {load: {on: A, vector: -P*j}, spring: {potential: k*l^2*sin(theta)^2/2}}
find: equilibrium
"""
HOOP = """title: Hoop
parameters: {m: {value: 100 g}, R: {value: 0.2 m}, g: {value: 9.81 m/s^2}, Omega: {value: 90 rpm}}
coordinates: [theta]
particles:
  P: {mass: m, position: "R*sin(theta)*cos(Omega*t)*i + R*sin(theta)*sin(Omega*t)*j - R*cos(theta)*k"}
gravity: -g*k
find: linearization
"""
CHAIN = """title: Two masses, three springs
parameters: {m: {value: 1 kg}, M: {value: 3 kg}, k: {value: 100 N/m}, c: {value: 70 N/m}}
coordinates: [x, y]
particles: {P: {mass: m, position: x*i}, Q: {mass: M, position: y*i}}
forces: {a: {potential: k*x^2/2}, b: {potential: c*(x - y)^2/2}, d: {potential: k*y^2/2}}
find: linearization
"""


def reported(text: str, *settings: str, digits: int = 4) -> Report:
    problem = read_problem(Source("p.yaml", text), [Fragment.of(s, "--set") for s in settings])
    return report(problem, digits=digits)


def page(result: Report, width: int = 100) -> str:
    return terminal.text(result.derivation, result.notation, width)


def as_json(result: Report) -> dict[str, Any]:
    found: dict[str, Any] = json.loads(render([result]))
    return found


def test_a_pendulum_in_every_format() -> None:
    result = reported(PENDULUM)
    text = page(result)
    assert "0.3θ̈ + 9.81 sin θ = 0" in text
    assert "5.718 rad/s" in text
    assert "1.099 s" in text
    assert "3.142 rad = 180°" in text
    pages = [(result.derivation, result.notation)]
    assert r"0.3\ddot{\theta} + 9.81 \sin\theta = 0" in latex.render(pages)
    assert r"5.718 \,\mathrm{rad/s}" in latex.render(pages)
    assert "5.718" in markdown.render(pages)
    assert "<mn>5.718</mn>" in html.render(pages)
    found = as_json(result)
    assert found["equations_in_numbers"] == ["0.3*theta'' + 9.81*sin(theta) = 0"]
    [frequency] = found["linearization"][0]["frequencies"]
    assert math.isclose(frequency["number"], math.sqrt(9.81 / 0.3), rel_tol=1e-14)
    assert math.isclose(frequency["period"]["number"], 2 * math.pi / math.sqrt(9.81 / 0.3), rel_tol=1e-14)
    assert (frequency["unit"], frequency["period"]["unit"]) == ("rad/s", "s")


def test_digits() -> None:
    assert f"{math.sqrt(9.81 / 0.3):.10g} rad/s" in page(reported(PENDULUM, digits=10), 200)
    assert "6 rad/s" in page(reported(PENDULUM, digits=1))


@pytest.mark.parametrize("left_out", ["l", "g"])
def test_without_all_values_there_are_no_numbers(left_out: str) -> None:
    value = {"l": "{value: 30 cm}", "g": "{value: 9.81 m/s^2}"}[left_out]
    result = reported(PENDULUM.replace(f"{left_out}: {value}", f"{left_out}: positive"))
    assert "given values" not in page(result)
    assert "equations_in_numbers" not in as_json(result)


@pytest.mark.parametrize("load", [10.0, 30.0, 99.0, 101.0, 500.0])
def test_equilibria_of_a_column(load: float) -> None:
    k, l = 200.0, 0.5
    there = as_json(reported(COLUMN, f"P={load} N"))["equilibrium_in_numbers"]
    angles = [math.pi, 0.0] + ([math.acos(load / (k * l)), -math.acos(load / (k * l))] if load < k * l else [])
    found = {p["coordinates"]["theta"]["number"]: p["stability"] for p in there}
    assert sorted(found) == pytest.approx(sorted(angles), abs=1e-14)
    for angle, verdict in found.items():
        # V = k l² sin²θ/2 + P l cos θ, differentiated by hand
        assert k * l**2 * math.sin(angle) * math.cos(angle) - load * l * math.sin(angle) == pytest.approx(0, abs=1e-12)
        second = k * l**2 * math.cos(2 * angle) - load * l * math.cos(angle)
        assert verdict == ("stable" if second > 0 else "unstable")


def test_branches_that_do_not_exist_with_the_values_are_named() -> None:
    text = page(reported(COLUMN, "P=101 N"))
    assert "has no real position with these values" in text
    assert "rad = 72.54°" in page(reported(COLUMN))
    assert "−72.54°" in page(reported(COLUMN))


def test_the_critical_load_itself_is_not_called_stable() -> None:
    there = as_json(reported(COLUMN, "P=100 N"))["equilibrium_in_numbers"]
    assert {p["stability"] for p in there if p["coordinates"]["theta"]["number"] == 0} == {"undecided"}


def test_a_hoop_turns_past_its_critical_speed() -> None:
    omega, g, r = 3 * math.pi, 9.81, 0.2
    found = as_json(reported(HOOP))["linearization"]
    tilted = [p for e in found for p in e["in_numbers"] if 0.1 < abs(p["coordinates"]["theta"]["number"]) < 3]
    assert [p["coordinates"]["theta"]["number"] for p in tilted] == pytest.approx(
        [math.acos(g / (r * omega**2)), -math.acos(g / (r * omega**2))]
    )
    for p in tilted:
        [frequency] = p["frequencies"]
        assert frequency["number"] == pytest.approx(omega * math.sin(math.acos(g / (r * omega**2))))


def test_frequencies_of_two_masses() -> None:
    m, big, k, c = 1.0, 3.0, 100.0, 70.0
    # det(K − w M) = 0 with K = [[k + c, −c], [−c, k + c]]
    a, b, d = m * big, -(k + c) * (m + big), (k + c) ** 2 - c**2
    roots = sorted((-b + s * math.sqrt(b * b - 4 * a * d)) / (2 * a) for s in (1, -1))
    [there] = as_json(reported(CHAIN))["linearization"]
    [position] = there["in_numbers"]
    assert [f["number"] for f in position["frequencies"]] == pytest.approx([math.sqrt(w) for w in roots])


def test_the_shapes_of_modes_have_numbers() -> None:
    """(K − w M) a = 0: the ratio of the second displacement to the first is (k + c − w m)/c."""
    m, k, c = 1.0, 100.0, 70.0
    [there] = as_json(reported(CHAIN))["linearization"]
    text = page(reported(CHAIN))
    for f in there["in_numbers"][0]["frequencies"]:
        ratio = (k + c - f["number"] ** 2 * m) / c
        assert f"1 : {ratio:.4g}".replace("-", "−") in text


DAMPED = """
title: Damped vibration
parameters: {m: 8 kg, k: 800 N/m, c: 40 kg/s, F: 5 N, w: 12 rad/s}
coordinates: {x: displacement}
particles: {P: {mass: m, position: x*i}}
forces: {spring: {spring: k, between: [O, P]}, dashpot: {damper: c, between: [O, P]}}
find: linearization
"""


def test_a_damped_vibration_has_its_ratio_and_decrement() -> None:
    text = page(reported(DAMPED))
    assert "that is σ = 2.5 s⁻¹" in text
    assert "about x = 0, asymptotically stable, that is ω ≈ 9.682 rad/s" in " ".join(text.replace("│", " ").split())
    assert f"{2 * math.pi * 2.5 / math.sqrt(100 - 2.5**2):.4g}" in text  # 2π σ/ω
    assert "0.2500" in text  # c/(2 √(k m))


def test_a_phase_lag_is_an_angle() -> None:
    driven = DAMPED.replace("forces: {", "forces: {drive: {on: P, vector: F*cos(w*t)*i}, ")
    lag = math.degrees(math.atan2(40 * 12, 800 - 8 * 144))
    head, _, below = page(reported(driven.replace("find: linearization", "find: response"))).partition(" 1  The system")
    for part in (head, below):
        assert f"≈ {lag:.4g}°" in part


def test_reactions_have_numbers() -> None:
    text = (PROBLEMS / "chapter6" / "ex11-ideal-pendulum.yaml").read_text(encoding="utf-8")
    result = reported(text, "m=2 kg", "l=30 cm", "g=9.81 m/s^2")
    assert "T = 0.6θ̇² + 19.62 cos θ" in page(result)
    [angle] = [c for c in as_json(result)["choices"] if c["name"] == "angle"]
    assert angle["reactions"]["rod"]["number"] == "0.6*theta'^2 + 19.62*cos(theta)"


def test_a_force_at_rest_has_its_unit() -> None:
    result = reported("""title: Lamp
axes: {i: right, j: up}
parameters: {W: {value: 50 N}, a: {value: 30 deg}}
unknowns: [T]
coordinates: [x, y]
particles: {lamp: {position: x*i + y*j}}
forces: {weight: {on: lamp, vector: -W*j}, cord: {on: lamp, vector: T*sin(a)*j + T*cos(a)*i},
         wall: {on: lamp, vector: "-T*cos(a)*i"}}
""")
    assert "T = 100 N" in page(result)


def test_a_run_without_values_loads_nothing_for_them() -> None:
    code = (
        "import sys; from lagrange.problem.loader import load; from lagrange.explain.report import report;"
        "report(load('problems/chapter6/ex11-ideal-pendulum.yaml'));"
        "print([m for m in sys.modules if m in ('lagrange.values.quantities', 'lagrange.explain.numbers',"
        "'lagrange.mechanics.equilibrium.in_numbers')])"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=True, timeout=120
    )
    assert done.stdout.strip() == "[]"


@pytest.mark.parametrize(
    ("text", "left_out", "shown", "critical"),
    [
        (COLUMN, "P: {value: 30 N}", "P < 100 N", ("P", "<", 100.0, "N")),
        (COLUMN, "k: {value: 200 N/m}", "k > 60 N/m", ("k", ">", 60.0, "N/m")),
        (HOOP, "Omega: {value: 90 rpm}", "Ω < 7.004 s⁻¹", ("Omega", "<", math.sqrt(9.81 / 0.2), "s^-1")),
        (HOOP, "R: {value: 0.2 m}", "R < 0.1104 m", ("R", "<", 9.81 / (3 * math.pi) ** 2, "m")),
    ],
)
def test_critical_values(text: str, left_out: str, shown: str, critical: tuple[str, str, float, str]) -> None:
    result = reported(text.replace(left_out, f"{left_out.partition(':')[0]}: positive"))
    assert shown in " ".join(page(result, 200).split())
    found = [(c["name"], c["relation"], c["number"], c.get("unit")) for c in as_json(result)["critical"]]
    name, relation, number, unit = critical
    assert (name, relation, pytest.approx(number), unit) in found


def test_a_critical_value_stands_beside_its_condition_at_the_head() -> None:
    head = page(reported(COLUMN.replace("P: {value: 30 N}", "P: positive")), 200).partition("1  The system")[0]
    assert "that is P < 100 N" in head


def test_given_values_stand_in_the_statement() -> None:
    text = PENDULUM.replace("find:", "forces: {wind: {generalized: {theta: m*g*l*sin(alpha)}}}\nfind:")
    text = text.replace("parameters: {", "parameters: {alpha: 30 deg, ")
    found = report(read_problem(Source("p.yaml", text)))
    page = " ".join(terminal.text(found.derivation, found.notation, 120).split())
    assert "Given: α = 30°, g = 9.81 m/s², l = 0.3 m and m = 2 kg." in page


def test_what_has_no_formula_stands_as_a_number_alone(problem: Callable[[str], Problem]) -> None:
    """The fall of a pendulum from the horizontal: √(l/(2g)) ∫ dθ/√cos θ = 2.6220576 √(l/(2g))."""
    text = (
        "title: Fall\nparameters: {m: {value: 1 kg}, l: {value: 0.9 m}, g: {value: 9.81 m/s^2}}\ncoordinates: [theta]\n"
        "particles: {P: {mass: m, position: l*sin(theta)*i - l*cos(theta)*j}}\ngravity: -g*j\n"
        "initial: {theta: 90 deg, theta': 0}\nask: {time: {quantity: t, when: theta = 0}}\n"
    )
    told = report(problem(text), complete=False)
    page = terminal.text(told.derivation, told.notation, 100)
    assert page.count("t ≈ 0.5616 s") == 2  # at the head and in its step; 2.6220576 √(0.9/19.62) = 0.56158
    assert "t = 0.56" not in page


def test_a_rate_of_mass_stays_in_kilograms_a_second() -> None:
    rocket = """title: Rocket
axes: {j: up}
parameters: {m_0: 1200 kg, q: 15 kg/s, u: 2400 m/s, c: 3 N s/m}
coordinates: [y]
particles: {rocket: {mass: m_0 - q*t, position: y*j, leaves: {relative: -u*j}}}
forces: {drag: {on: rocket, vector: "-c*y'*j"}}
"""
    explained = report(read_problem(Source("rocket.yaml", rocket)))
    page = terminal.text(explained.derivation, explained.notation, 100)
    assert "q = 15 kg/s" in page
    assert "c = 3 N s/m" in page


def test_or_between_positions_comes_after_their_numbers() -> None:
    text = """title: Two cords to one point
parameters: {W: {value: 10 N}, a: {value: 3 m}, b: {value: 5 m}}
coordinates: [x, y]
particles: {P: {position: x*i + y*j}}
constraints: {left: (x + a)^2 + y^2 = b^2, right: (x - a)^2 + y^2 = b^2}
forces: {weight: {on: P, vector: -W*j}}
find: equilibrium
"""
    head = page(reported(text)).split("1  The system")[0]
    assert "or, that is" not in head
    assert "that is y = 4 m, or" in head or "that is y = −4 m, or" in head, head
