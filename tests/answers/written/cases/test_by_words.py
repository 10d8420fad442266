"""The sense of a motion by a word, or by a sign alone."""

from __future__ import annotations

import pytest

from lagrange.answers.written.cases.by_words import with_senses

READ = [
    ("m x'' = ∓ a", "m x'' = - sign(x')* a"),
    (r"m \ddot{x} = \mp a", r"m \ddot{x} = - \operatorname{sgn}\left(\dot{x}\right)\cdot  a"),
    ("m x'' = -a (moving right)", "m x'' = -a (x' > 0)"),
    ("m x'' = a, moving to the left", "m x'' = a, x' < 0"),
]
KEPT = [
    "m x'' = ± a",
    "m x'' = ∓ a (upper sign for x' > 0)",
    "m x'' = ∓ a, M y'' = 0",
    "theta = ∓ pi/2",
    "m x'' = -a while it slides to the right (x' > 0)",
]


@pytest.mark.parametrize(("text", "read"), [*READ, *((t, t) for t in KEPT)])
def test_the_sense_of_a_motion(text: str, read: str) -> None:
    assert with_senses(text) == read
