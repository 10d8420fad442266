"""Newton's law and the work of the reactions, as a page puts them."""

from __future__ import annotations

import pytest

from lagrange.document.derivation import Rule
from tests.support.derivation_text import said_in


@pytest.mark.parametrize(
    ("name", "rule", "said"),
    [
        ("ex10-double-pendulum", Rule.REACTIONS, ", and its reaction acts along it. With the tensions "),
        ("ex10-double-pendulum", Rule.WORKLESS, " work: what one loses, the other gains."),
        ("ball-on-a-ball", Rule.WORKLESS, "In a virtual displacement the work of the reactions is the sum of "),
    ],
)
def test_what_is_said_of_reactions(name: str, rule: Rule, said: str) -> None:
    assert said in said_in(name, rule, on_page=True)
