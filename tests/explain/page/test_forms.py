"""The box of the derivation has the form that the head of the page has."""

from __future__ import annotations

import re

import pytest

from lagrange.document.derivation import Detail
from lagrange.render import terminal
from tests.support.shared import reported


def printed(name: str, detail: Detail = Detail.STEPS) -> list[str]:
    r = reported(name)
    return terminal.text(r.derivation, r.notation, 200, detail).splitlines()


@pytest.mark.parametrize(
    ("name", "equation", "why"),
    [
        ("ex11-ideal-pendulum", "θ̈ + (g/l) sin θ = 0", "must vanish (dividing by m l²):"),
        (
            "bead-on-lemniscate",
            "a (1 + sin²s) s̈ − a ṡ² sin s cos s + g (1 − 3 sin²s) = 0",
            "must vanish (multiplying by (1 + sin²s)² and dividing by m a):",
        ),
        ("relativistic-oscillator", "m ẍ/(1 − ẋ²/c²)^(3/2) = −k x", "Lagrange's equation (2) is therefore"),
    ],
)
def test_one_form(name: str, equation: str, why: str) -> None:
    lines = printed(name)
    assert sum(equation in line for line in lines) == 2  # at the head, and with its number
    assert why in " ".join(" ".join(lines).split())
    assert not any("In short" in line for line in lines)


def test_the_full_derivation_stays_as_it_was() -> None:
    assert any("│  l θ̈ + g sin θ = 0 " in line for line in printed("ex11-ideal-pendulum", Detail.FULL))


def test_a_root_is_the_coordinate_at_rest() -> None:
    text = " ".join(" ".join(printed("hill-moon")).split())
    assert "with r at equilibrium, the equations of motion become ξ̈₁ − 2n r ξ̇₂ − 9n² ξ₁ = 0" in text
    assert "r ξ̈₂ + 2n ξ̇₁ + 3n² r ξ₂ = 0" in text


def test_the_bead_on_a_figure_of_eight() -> None:
    """On the wire the length of the gradient has one short root; the crossing is excepted; both lowest points alike."""
    text = " ".join(" ".join(printed("bead-on-lemniscate")).split())
    assert "[x (2x² + 2y² − a²) N/(a² √(x² + y²))] 𝐢" in text
    assert "δ𝐫 = −[a (3 − sin²s) sin s/(1 + sin²s)²] δs 𝐢" in text
    assert "N = m sgn(cos s) [g (2 + cos²s) sin s − 3a ṡ² cos s]/(1 + sin²s)^(3/2) where cos s ≠ 0" in text
    assert text.count("Small motion: ω² = 3√2 g/(2a) where it is stable.") == 1


def test_rolling_is_put_in_before_the_equations_are_written() -> None:
    text = " ".join(" ".join(printed("cylinder-on-rough-incline")).split())
    text = re.sub(r"\(\d+\)", "()", text)
    assert "Substitute for δθ in (); by (), θ̇ = ẋ/R and θ̈ = ẍ/R. δx is arbitrary" in text
    assert "2ẍ + R θ̈" not in text
    assert "Energy: (3/2) m ẋ times () integrates to ¾ m ẋ² − m g x sin α = const." in text
