"""Steady motions in words: what is cyclic, what is neglected.

Forced oscillations in words: steady state, phase, resonance.
"""

from __future__ import annotations

import pytest

from lagrange.document.derivation import Rule
from tests.support.derivation_text import said_in


@pytest.mark.parametrize(
    ("name", "rule", "said"),
    [
        (
            "conical-pendulum",
            Rule.STEADY,
            " does not appear in the equations of motion, only its velocity does: it is cyclic.",
        ),
        (
            "disc-that-rolls-steadily",
            Rule.STEADY,
            " do not appear in the equations of motion, only their velocities do: they are cyclic.",
        ),
        ("conical-pendulum", Rule.STEADY, " leads to another steady motion nearby."),
    ],
)
def test_what_is_said_of_steady_motions(name: str, rule: Rule, said: str) -> None:
    assert said in said_in(name, rule)


# Response


@pytest.mark.parametrize(
    ("name", "rule", "said"),
    [
        (
            "damped-oscillator",
            Rule.RESPONSE,
            "The drive is small of the same order. To first order the equations of motion are",
        ),
        (
            "dynamic-absorber",
            Rule.RESPONSE,
            ": at resonance there is no steady state, and the amplitude grows without bound as it is approached.",
        ),
        ("dynamic-absorber", Rule.RESPONSE, " stays at rest, although the system is driven, at"),
    ],
)
def test_what_is_said_of_the_steady_state(name: str, rule: Rule, said: str) -> None:
    assert said in said_in(name, rule)
