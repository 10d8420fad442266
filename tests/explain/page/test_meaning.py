"""What the result says: what descriptions promise, quasi-velocities that can change in one sense only."""

from __future__ import annotations

from pathlib import Path

import pytest

from lagrange.document.derivation import Detail
from lagrange.explain.report import report
from lagrange.problem.loader import load
from lagrange.render import terminal
from tests.support.shared import SHIPPED, reported

SLEIGH = SHIPPED["sleigh"].read_text()


def page(text: str, folder: Path) -> str:
    file = folder / "sleigh.yaml"
    file.write_text(text)
    r = report(load(str(file)), complete=False)
    return " ".join(terminal.text(r.derivation, r.notation, 400, Detail.STEPS).split())


@pytest.mark.parametrize(
    ("centre", "said"),
    [
        ("+ a*e1_sleigh", "u̇ = a ω², which is never negative: u only grows, or is constant while ω = 0."),
        ("- a*e1_sleigh", "u̇ = −a ω², which is never positive: u only falls, or is constant while ω = 0."),
    ],
)
def test_a_rate_of_one_sign(centre: str, said: str, tmp_path: Path) -> None:
    """The mass centre before the blade, and behind it."""
    text = SLEIGH.split("figure:")[0].replace("+ a*e1_sleigh", centre)
    assert said in page(text, tmp_path)


def test_a_rate_whose_sign_is_that_of_a_constant(tmp_path: Path) -> None:
    text = SLEIGH.split("figure:")[0].replace("a: {assume: positive, ", "a: {assume: real, ")
    printed = page(text, tmp_path)
    assert "u̇ = a ω², which is always of the same sign: u moves in one sense, or is constant while ω = 0." in printed
    assert printed.count("One way") == 1  # and nothing of ω̇, which has a product of two velocities


def test_a_motion_that_grows_is_given(tmp_path: Path) -> None:
    wire = """
title: Bead on a turning wire
parameters: [m, w]
coordinates: [r, phi]
frame: {type: polar, coordinates: [r, phi]}
particles: {P: {mass: m, position: r*e_r}}
constraints: {wire: {equation: phi = w*t, by: wire, reaction: N}}
generalized_coordinates: {along: {coordinates: [r]}}
"""
    assert "Motion: r = C₁ cosh(w t) + C₂ sinh(w t), where C₁ and C₂ follow from the initial state." in page(
        wire, tmp_path
    )


def shipped_page(name: str) -> str:
    r = reported(name, complete=False)
    return " ".join(terminal.text(r.derivation, r.notation, 400, Detail.STEPS).split())


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("south-pointing-chariot", "together say that ╭─────────────────────────╮ │ θ + ψ = const"),
        ("foucault-pendulum", "for axes that turn at the rate −Ω sin λ the velocities drop out, to first order in Ω"),
        ("ball-on-turntable", "turns at the constant rate 2Ω/7 and keeps its size"),
        ("ball-on-a-ball", "d/dt (𝛚·𝐨𝐮𝐭) = 0"),
        ("euler-rigid-body", "A ṗ = (B − C) q r"),
        ("ex05-ice-skate", "add up, to second order, to δx = ε² sin θ and δy = −ε² cos θ"),
        ("ex01-horizontal-surface", "d/dt (½ m (ẋ² + ẏ²)) = ẋ F_x + ẏ F_y"),
        ("ex06-two-particle-skate", "(x₁ − x₂) δx₁ + (y₁ − y₂) δy₁ + (x₂ − x₁) δx₂"),
        ("suslov-body", "which is always of the same sign: q moves in one sense, or is constant while u = 0"),
        ("governor", "φ̇² = (M + m) g/(m l cos θ)"),
        ("slide-off-a-dome", "Contact: N > 0 while θ̇² < (g/R) cos θ."),
        ("slide-off-a-dome", "/(R² (4μ² + 1)) (18)"),
        ("constant-speed", "│ v² ẍ = g ẋ ẏ │ │ v² ÿ = −g ẋ² │"),
        ("sleigh", "λ = (m I_G/(m a² + I_G)) θ̇ u"),
        ("spherical-pendulum-by-routh", "The force that keeps P on its surface is normal to the surface"),
        ("towed-blade", "x + l ln(|tan(ψ/2)|) + l cos ψ = const"),
    ],
)
def test_a_page_gives_what_its_description_promises(name: str, said: str) -> None:
    assert said in shipped_page(name)


def test_equations_that_stand_on_the_page_are_not_said_in_short() -> None:
    assert "In short" not in shipped_page("blade-from-a-lagrangian")


@pytest.mark.parametrize(
    ("name", "said", "unsaid"),
    [
        ("ball-on-a-string", "At rest: φ = 0, stable.", "φ = π"),  # a string cannot push
        ("ex11-ideal-pendulum", "θ = π, unstable", "only"),  # a rod can do both
    ],
)
def test_no_rest_where_contact_would_be_lost(name: str, said: str, unsaid: str) -> None:
    r = reported(name, complete=False)
    lines = terminal.text(r.derivation, r.notation, 200).splitlines()
    [line] = [line for line in lines if "At rest:" in line]
    assert said in line
    assert unsaid not in line


def test_a_short_momentum_has_a_sentence_beside_a_long_energy() -> None:
    printed = shipped_page("ball-on-a-ball")
    assert "integrates to m a² b φ̇ sin²θ + (2/5) m a b² γ̇ = const." in printed
    assert "the rate of change of the energy, which is constant:" in printed
