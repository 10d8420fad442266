"""Values of parameters: on the command line, and whether their units fit the problem."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.diagnostics import Fragment, ProblemError, Source
from lagrange.problem.loader import read_problem
from lagrange.problem.model import Problem
from lagrange.problem.values import values_of
from tests.support.problem_texts import mistakes, places, read

PENDULUM = """title: T
parameters: {m: {value: 2 kg}, l: {unit: cm}, g: {value: 9.81 m/s^2}, s: sign}
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
constraints: {rod: x^2 + y^2 = l^2}
gravity: g*j
"""


def with_settings(*settings: str) -> Problem:
    return read_problem(Source("problem.yaml", PENDULUM), [Fragment.of(s, "--set") for s in settings])


def values(problem: Problem) -> dict[str, sp.Expr | None]:
    return {p.symbol.name: p.value for p in problem.parameters}


@pytest.mark.parametrize(
    ("written", "value", "unit"),
    [
        ('"2*pi rad/s"', 2 * sp.pi, "rad/s"),
        ("1/2 m", sp.Rational(1, 2), "m"),
        ("2 sqrt(3) kN", None, ""),
        ("2*sqrt(3) kN", 2000 * sp.sqrt(3), "N"),
        ("9.81*m/s^2", sp.Rational(981, 100), "m/s^2"),
        ("pi/4", sp.pi / 4, ""),
        ("(1 + 2)/4 ft", sp.Rational(3, 4) * sp.Rational("0.3048"), "m"),
        ("1 slug", sp.Rational("0.45359237") * sp.Rational("9.80665") / sp.Rational("0.3048"), "kg"),
    ],
)
def test_values_may_be_exact_arithmetic(written: str, value: sp.Expr | None, unit: str) -> None:
    text = f"title: T\ncoordinates: [x]\nparameters: {{l: {{value: {written}}}}}\n"
    if value is None:
        assert [code for code, *_ in places(text)] == ["unknown-unit"]
        return
    [parameter] = read(text).parameters
    assert parameter.value is not None
    assert sp.expand(parameter.value - value) == 0
    assert parameter.unit == unit


@pytest.mark.parametrize("written", ["2 kg", "0.5", ".5", "1/2", "3/4 ft", "9.81 m/s^2"])
def test_a_value_alone_declares_a_positive_parameter(written: str) -> None:
    alone, spelt_out = (
        read(f"title: T\ncoordinates: [x]\nparameters: {{m: {declaration}}}\n").parameters
        for declaration in (written, f"{{value: {written}}}")
    )
    assert (alone[0].symbol, alone[0].value, alone[0].unit) == (
        spelt_out[0].symbol,
        spelt_out[0].value,
        spelt_out[0].unit,
    )


def test_a_value_alone_with_a_mistake() -> None:
    assert places("title: T\ncoordinates: [x]\nparameters: {m: 2 kgg}\n") == [("unknown-unit", 3, 17)]


def test_settings_give_and_replace_values() -> None:
    found = values(with_settings("l=30", "m = 500 g", "m=250 g", "s=-1"))
    assert found == {"m": sp.Rational(1, 4), "l": sp.Rational(3, 10), "g": sp.Rational(981, 100), "s": -1}
    assert values(with_settings("l=0.3 m"))["l"] == sp.Rational(3, 10)


@pytest.mark.parametrize(
    ("setting", "code"),
    [
        ("l", "bad-setting"), ("l=", "bad-setting"), ("=3", "bad-setting"), ("q=3", "unknown-parameter"),
        ("x=3", "unknown-parameter"), ("l=3 kg", "unit-mismatch"), ("m=3 furlong", "unknown-unit"),
        ("m=-1", "value-against-assumption"), ("m=abc", "not-a-number"), ("m=1/0", "division-by-zero"),
        ("s=2", "value-against-assumption"), ("m=inf", "not-a-number"),
    ],
)  # fmt: skip
def test_settings_that_cannot_be_used(setting: str, code: str) -> None:
    with pytest.raises(ProblemError) as caught:
        with_settings(setting)
    [finding] = caught.value.diagnostics
    assert finding.code == code
    assert finding.span is not None
    assert finding.span.source.name == "--set"


HANGING = "coordinates: [x, theta]\naxes: {j: down}\n"


@pytest.mark.parametrize(
    ("parameters", "rest", "fits"),
    [
        ("m: {value: 3 s}", "particles: {P: {mass: m, position: x*i}}", False),
        ("m: {value: 3 kg}", "particles: {P: {mass: m, position: x*i}}", True),
        ("m: {value: 3 lb}", "particles: {P: {mass: m, position: x*i}}", False),
        ("m: {value: 3 slug}", "particles: {P: {mass: m, position: x*i}}", True),
        ("m: {value: 3 s}", "particles: {P: {mass: 10*m, position: x*i}}", True),  # 10 may have a unit
        ("l: {value: 3 kg}", "particles: {P: {mass: 1, position: l*sin(theta)*i}}", False),
        ("l: {value: 30 deg}", "particles: {P: {mass: 1, position: l*sin(theta)*i}}", False),
        ("l: {value: 3 ft}", "particles: {P: {mass: 1, position: (l/2 + x)*sin(theta)*i}}", True),
        ("g: {value: 9.81 m/s}", "gravity: g*j\nparticles: {P: {mass: 1, position: x*i}}", False),
        ("m: {value: 1 kg}, l: {value: 1 m}", "bodies: {B: {mass: m, inertia: m*l^2/12, position: x*i, angle: theta}}", True),
        ("m: {value: 1 kg}, l: {value: 1 s}", "bodies: {B: {mass: m, inertia: m*l^2/12, position: x*i, angle: theta}}", False),
        ("k: {value: 5 N}", "particles: {P: {mass: 1, position: x*i}}\n"
         "forces: {s: {spring: k, between: [P, 0*i]}}", False),
        ("F: {value: 5 N}, a: {value: 2 1/s}", "particles: {P: {mass: 1, position: x*i}}\n"
         "forces: {s: {on: P, vector: F*cos(a*t)*i}}", True),
        ("F: {value: 5 N m}", "particles: {P: {mass: 1, position: x*i}}\nforces: {s: {on: P, vector: F*i}}", False),
        ("mu: {value: 5 N}", "coordinates: [x, y]\nparticles: {P: {mass: 1, position: x*i + y*j}}\n"
         "constraints: {c: y = 0}\nforces: {s: {friction: mu, constraint: c, on: P}}", False),
        ("k: {value: 5 N/m}", "particles: {P: {mass: 1, position: x*i}}\nforces: {s: {potential: k*x^2/2}}", True),
        ("k: {value: 5 N}", "particles: {P: {mass: 1, position: x*i}}\nforces: {s: {potential: k*x^2/2}}", False),
        ("c: {value: 5 m/s}, m: {value: 1}", "particles: {P: {mass: m, position: x*i}}", True),
        ("mu: {value: 5 N}", "coordinates: [x, y]\nparticles: {P: {mass: 1, position: x*i + y*j}}\n"
         "constraints: {c: y = 0}\nforces: {s: {friction: 0.1, static: mu, constraint: c, on: P}}", False),
        ("e: {value: 2 m}", "particles: {P: {mass: 1, position: x*i}}\nfind: impact\n"
         "impact: {constraints: {c: x = 0}, restitution: {c: e}}", False),
        ("J: {value: 2 N}", "particles: {P: {mass: 1, position: x*i}}\nfind: impact\n"
         "impact: {impulses: {b: {on: P, vector: J*i}}}", False),
        ("J: {value: 2 N s}", "particles: {P: {mass: 1, position: x*i}}\nfind: impact\n"
         "impact: {impulses: {b: {on: P, vector: J*i}}}", True),
    ],
)  # fmt: skip
def test_a_unit_fits_the_place_of_its_parameter(parameters: str, rest: str, fits: bool) -> None:
    head = "" if rest.startswith("coordinates") else HANGING
    text = f"title: T\nparameters: {{{parameters}}}\n{head}{rest}\n"
    if fits:
        read(text)
        return
    [(code, line, _)] = places(text)
    assert (code, line) == ("unit-mismatch", 2)


SLOPE = """title: T
parameters: {alpha: 30 deg, W: 2 N, k: 1 rpm}
coordinates: [x]
forces: {f: {potential: W*x*cos(alpha)*k}}
"""


def test_an_angle_is_acute_by_its_value_unless_the_file_says_what_it_is() -> None:
    def assumed(text: str, *settings: str) -> dict[str, str]:
        found = read_problem(Source("problem.yaml", text), [Fragment.of(s, "--set") for s in settings])
        return {p.symbol.name: p.assume for p in found.parameters}

    assert assumed(SLOPE) == {"alpha": "acute", "W": "positive", "k": "positive"}
    assert assumed(SLOPE, "alpha=120 deg")["alpha"] == "positive"
    assert assumed(SLOPE.replace("30 deg", "120 deg"), "alpha=40 deg")["alpha"] == "acute"
    assert assumed(SLOPE.replace("30 deg", "{assume: positive, value: 30 deg}"))["alpha"] == "positive"
    assert assumed(SLOPE.replace("30 deg", "0.5"))["alpha"] == "positive"
    assert assumed(SLOPE + "vary: {alpha: [30 deg, 120 deg]}\n")["alpha"] == "acute"


@pytest.mark.parametrize("declaration", ["12 lb", "{value: 12 lb, unit: kg}"])
def test_a_weight_for_a_mass_has_a_cure(declaration: str) -> None:
    [found] = mistakes(
        f"title: T\ncoordinates: [x]\nparameters: {{m: {declaration}}}\nparticles: {{P: {{mass: m, position: x*i}}}}\n"
    )
    assert found.code == "unit-mismatch"
    assert "mass: W/g" in found.help


@pytest.mark.parametrize(
    ("inertia", "noted"), [("m*l/2", True), ("m*l^3", True), ("m*l^2/12", False), ("I", False), ("2", False)]
)
def test_a_moment_of_inertia_of_another_dimension_is_noted(inertia: str, noted: bool) -> None:
    text = "title: T\ncoordinates: [x, theta]\nparameters: [m, l, I]\n"
    body = f"bodies: {{B: {{mass: m, inertia: {inertia}, position: l*sin(theta)*i + x*j, angle: theta}}}}\n"
    assert ("inertia-dimension" in [n.code for n in read(text + body).notes]) is noted


def test_a_parameter_that_is_not_used_is_noted() -> None:
    text = "title: T\ncoordinates: [x]\nparameters: [m, k, c, h]\nparticles: {P: {mass: m, position: x*i}}\n"
    found = read(text + "forces: {s: {spring: k, between: [O, P]}}\nask: {v: {quantity: x', when: x = h}}\n").notes
    assert [(n.code, n.message) for n in found] == [("unused-parameter", "`c` is not used")]


def test_units_alone_and_written_as_one_word() -> None:
    """`m: kg` is `m: {unit: kg}`; 600 Ns/m are 600 kg/s, and 2 kWh 7.2 MJ."""
    problem = read("title: T\ncoordinates: [x]\nparameters: {m: kg, L: m, c: 600 Ns/m, E: 2 kWh, J: 3 Nms}\n")
    assert [p.unit for p in problem.parameters][:2] == ["kg", "m"]
    assert all(p.symbol.is_positive for p in problem.parameters)
    assert [p.value for p in problem.parameters] == [None, None, 600, 7200000, 3]


def test_quasi_velocities_have_units() -> None:
    problem = read("""title: Sleigh
parameters: {m: 10 kg, I: 0.4 kg m^2, a: 0.2 m}
coordinates: [x, y, theta]
bodies: {sleigh: {mass: m, inertia: I, position: x*i + y*j + a*e1_sleigh, angle: theta}}
constraints: {blade: "y'*cos(theta) = x'*sin(theta)"}
speeds: {u: "x'*cos(theta) + y'*sin(theta)", omega: theta'}
""")
    found = values_of(problem)
    assert found is not None
    assert [found.unit_of(s.symbol) for s in problem.speeds] == ["m/s", "rad/s"]
