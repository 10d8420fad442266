"""Wrong answers to questions about a motion that loses energy: is it taken to be conserved?"""

from __future__ import annotations

import pytest

from tests.answers.results.diagnoses import Row, assert_explained

KEPT = "the energy is taken to be conserved, and some of it is lost"
WRONG: list[Row] = [
    # m v^2/2 = 7/10 m x'^2
    ("bowling-ball", "ask", {"speed": "v*sqrt(5/7)"}, f"{KEPT} by the friction `rub`"),
    ("ball-with-backspin", "ask", {"speed": "sqrt((5*v^2 + 2*R^2*w^2)/7)"}, f"{KEPT} by the friction `rub`"),
    # (M + rho x) x'^2/2 = M g x - rho g x^2/2
    (
        "load-that-lifts-a-chain",
        "ask",
        {"speed": "2*g*(M*x - rho*x^2/2)/(M + rho*x)"},
        f"{KEPT} in the jerks of the mass that joins",
    ),
    ("load-that-lifts-a-chain", "ask", {"lowest": "2*M/rho"}, f"{KEPT} in the jerks"),
]


@pytest.mark.parametrize(("problem", "key", "stated", "said"), WRONG)
def test_energy_that_is_lost(problem: str, key: str, stated: object, said: str) -> None:
    assert_explained(problem, key, stated, said)
