"""JSON says what Python says."""

from __future__ import annotations

import json

import pytest

import lagrange


@pytest.fixture(scope="module")
def pendulum() -> lagrange.Result:
    return lagrange.solve(lagrange.load("ex11"))


def test_json_and_python_say_the_same(pendulum: lagrange.Result) -> None:
    found = json.loads(pendulum.render("json"))
    assert found["degrees_of_freedom"] == pendulum.degrees_of_freedom
    assert [c["name"] for c in found["choices"]] == [*pendulum.choices]
