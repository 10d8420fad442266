"""Units: factors against SymPy's table, dimensions, what is no unit."""

from __future__ import annotations

import pytest
import sympy as sp
from sympy.physics import units as u

from lagrange.core.units import si_unit, split_number, unit_of, unit_of_dimension

KNOWN = {
    "cm": u.centimeter, "km": u.kilometer, "µm": u.micrometer, "g": u.gram, "t": u.tonne, "min": u.minute, "h": u.hour,
    "ms": u.millisecond, "kN": 1000 * u.newton, "MPa": 10**6 * u.pascal, "kJ": 1000 * u.joule, "mW": u.watt / 1000,
    "ft": u.foot, "in": u.inch, "mph": u.mile / u.hour, "lb": u.pound * u.acceleration_due_to_gravity,
    "km/h": u.kilometer / u.hour, "N m": u.newton * u.meter, "g cm^2": u.gram * u.centimeter**2,
    "J/(kg K)": u.joule / u.kilogram / u.kelvin, "m s^-2": u.meter / u.second**2, "kg·m²": u.kilogram * u.meter**2,
    "m/s/s": u.meter / u.second**2, "/s": 1 / u.second, "kg (m/s)**2": u.joule, "mT": u.tesla / 1000,
}  # fmt: skip
BASE = [u.kilogram, u.meter, u.second, u.ampere, u.kelvin]


@pytest.mark.parametrize("text", KNOWN)
def test_factors_and_dimensions(text: str) -> None:
    unit = unit_of(text)
    assert unit is not None
    expected = u.convert_to(KNOWN[text], BASE)
    assert (
        sp.nsimplify(expected - unit.factor * sp.Mul(*(b**n for b, n in zip(BASE, unit.dimension, strict=True)))) == 0
    )


def test_angles() -> None:
    for text, factor, si in (("deg", sp.pi / 180, "rad"), ("rev", 2 * sp.pi, "rad"), ("rpm", sp.pi / 30, "rad/s")):
        unit = unit_of(text)
        assert unit is not None
        assert (unit.factor, si_unit(unit)) == (factor, si)


def test_a_slug_is_accelerated_by_a_pound_at_a_foot_per_second_squared() -> None:
    assert unit_of("slug ft/s^2") == unit_of("lb")


@pytest.mark.parametrize(
    "text", ["", "furlong", "m/", "m//s", "kg^x", "m^", "m^99", "(m", "m)", "J/kg K", "3 m", "m,s", "cmin", "kkg"]
)
def test_what_is_no_unit(text: str) -> None:
    assert unit_of(text) is None


@pytest.mark.parametrize(
    ("text", "parts"),
    [
        ("30 cm", ("30", "cm")),
        ("30cm", ("30", "cm")),
        ("-1.5e-3 N/m", ("-1.5e-3", "N/m")),
        ("2/3 m", ("2/3", "m")),
        ("50 1/s", ("50", "1/s")),
        ("1/2 1/s", ("1/2", "1/s")),
        ("2 /s", ("2", "/s")),
        ("30°", ("30", "°")),
        ("1e3", None),
        ("1/2", None),
        ("2*3", None),
        ("12:30", None),
        ("pi", None),
    ],
)
def test_numbers_with_units(text: str, parts: tuple[str, str] | None) -> None:
    assert split_number(text) == parts


def test_dimensions_are_written() -> None:
    texts = ("N", "1", "m/(s)", "N s/m", "1/s")
    assert [unit_of_dimension(unit.dimension) for text in texts if (unit := unit_of(text))] == [
        "kg m/s^2", "1", "m/s", "kg/s", "1/s",
    ]  # fmt: skip
