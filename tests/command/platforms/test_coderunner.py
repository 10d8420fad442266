"""The grader of CodeRunner."""

from __future__ import annotations

import json

from lagsolve.platforms.coderunner import result
from tests.command.platforms.test_gradescope import PENDULUM, RIGHT, WRONG


def test_coderunner() -> None:
    right, wrong = (json.loads(result(PENDULUM, answer, 2)) for answer in (RIGHT, WRONG))
    assert (right["fraction"], wrong["fraction"]) == (1, 0)
    assert "Look at a force term" in wrong["epiloguehtml"]
    assert set(wrong) <= {"fraction", "prologuehtml", "epiloguehtml", "instructorhtml", "testresults", "columnformats"}
    faulty = json.loads(result("title: <b>\n", RIGHT))
    assert faulty["fraction"] == 0
    assert "coordinates" in faulty["instructorhtml"]
    assert "coordinates" not in faulty["epiloguehtml"]
