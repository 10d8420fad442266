"""The file of a variant: the values in it, nothing else changed, and a refusal where there is no answer."""

from __future__ import annotations

import pytest

from lagrange.core.diagnostics import ProblemError, Source
from lagrange.problem.loader import read_problem
from lagrange.problem.variants.writing import variant_source

REST = "particles: {P: {mass: m, position: l*sin(theta)*i + l*cos(theta)*j}}\ngravity: g*j\n"
VARY = "vary: {m: [1 kg, 2 kg], l: {from: 20 cm, to: 1 m, step: 0.1 m}}"


def text(parameters: str, vary: str = VARY, more: str = REST) -> str:
    return f"title: Pendulum   # the first\nparameters:{parameters}\ncoordinates: [theta]\n{vary}\n{more}"


def written(problem: str, seed: str = "anna") -> str:
    return variant_source(Source("p.yaml", problem), seed).text


def values(problem: str) -> dict[str, str]:
    return {p.symbol.name: f"{p.value} {p.unit}" for p in read_problem(Source("p.yaml", problem)).parameters}


@pytest.mark.parametrize(
    ("parameters", "line"),
    [
        (" [m, l, g]", "parameters: {m: {value: 2 kg}, l: {value: 40 cm}, g: positive}"),
        ("\n  - m\n  - l   # its length\n  - g", "  {m: {value: 2 kg}, l: {value: 40 cm}, g: positive}"),
        ("\n- m\n- l\n- g", "  {m: {value: 2 kg}, l: {value: 40 cm}, g: positive}"),
        (
            " {m: , l: positive, g: real}",
            "parameters: {m: {value: 2 kg} , l: {assume: positive, value: 40 cm}, g: real}",
        ),
        (" {m: 1 kg, l: 3 m, g: real}", "parameters: {m: {value: 2 kg}, l: {value: 40 cm}, g: real}"),
        (
            "\n  m: positive   # the bob\n  l: {unit: m, value: 3}\n  g:\n    unit: m/s^2",
            "  m: {assume: positive, value: 2 kg}   # the bob\n  l: {unit: m, value: 40 cm}",
        ),
        (
            "\n  m:\n    unit: kg  # a unit\n    meaning: mass\n  l: {unit: m}\n  g: positive",
            "  m:\n    value: 2 kg\n    unit: kg  # a unit\n    meaning: mass\n  l: {value: 40 cm, unit: m}",
        ),
    ],
)
def test_wherever_a_parameter_is_declared_its_value_is_written_there(parameters: str, line: str) -> None:
    found = written(text(parameters))
    assert line in found
    assert found.startswith("# The variant of the seed anna: m = 2 kg, l = 40 cm\ntitle: Pendulum   # the first\n")
    assert values(found)["m"] == "2 kg"
    assert values(found)["l"] == "2/5 m"
    assert found.endswith(f"coordinates: [theta]\n{REST}")  # `vary` is gone with its line


@pytest.mark.parametrize(
    ("vary", "left"),
    [
        (f"{VARY}   # for each\n# two", "# for each\n# two\n"),
        ("vary:\n  m: [1 kg, 2 kg]\n  l:\n    from: 20 cm\n    to: 1 m\n    step: 10 cm\n# after", "# after\n"),
    ],
)
def test_comments_stay(vary: str, left: str) -> None:
    assert written(text(" [m, l, g]", vary)).endswith(f"coordinates: [theta]\n{left}{REST}")


@pytest.mark.parametrize("order", ["{title: t, vary: {m: [2]}, ", "{vary: {m: [2]}, title: t, "])
def test_a_file_in_braces(order: str) -> None:
    body = "coordinates: [x], parameters: [m], particles: {P: {mass: m, position: x*i}}"
    assert "vary" not in written(f"{order}{body}}}")
    assert "vary" not in written(f"{{title: t, {body}, vary: {{m: [2]}}}}")


def test_the_values_of_a_range_are_exact() -> None:
    ranged = text(" [m, l, g]", "vary: {l: {from: 0.1 m, to: 1 m, step: 30 cm}}")
    assert {values(written(ranged, f"s{n}"))["l"] for n in range(60)} == {"1/10 m", "2/5 m", "7/10 m", "1 m"}
    angles = "vary: {g: {from: 10 deg, to: 30 deg, step: 10 deg}}"
    found = {
        values(written(text(" {m: , l: , g: acute}", angles, REST.replace("g*j", "10*j")), str(n)))["g"]
        for n in range(40)
    }
    assert found == {"pi/18 rad", "pi/9 rad", "pi/6 rad"}


@pytest.mark.parametrize(
    ("vary", "code"),
    [
        ("vary: {q: [1]}", "unknown-parameter"),
        ("vary: {m: []}", "empty-value"),
        ("vary: {m: 1 kg}", "wrong-kind"),
        ("vary: [m]", "wrong-kind"),
        ("vary: {m: [1 kg, 2 m]}", "unit-mismatch"),
        ("vary: {m: [-1 kg]}", "value-against-assumption"),
        ("vary: {m: [heavy]}", "not-a-number"),
        ("vary: {l: {from: 1 m, to: 2 s, step: 1 m}}", "unit-mismatch"),
        ("vary: {l: {from: 2 m, to: 1 m, step: 1 m}}", "bad-range"),
        ("vary: {l: {from: 1 m, to: 2 m, step: 0 m}}", "bad-range"),
        ("vary: {l: {from: 1 m, to: 2 m, step: 1e-9 m}}", "bad-range"),
        ("vary: {l: {from: 1 m, to: 2 m}}", "missing-key"),
        ("vary: {l: {from: sqrt(2), to: 2, step: 1}}", "bad-range"),
        ("", "nothing-varies"),
    ],
)
def test_what_cannot_be_drawn_is_an_error(vary: str, code: str) -> None:
    with pytest.raises(ProblemError) as error:
        written(text(" [m, l, g]", vary))
    assert [d.code for d in error.value.diagnostics] == [code]


@pytest.mark.parametrize("seed", ["", "  ", "x" * 201])
def test_a_seed_is_a_text_that_is_not_too_long(seed: str) -> None:
    with pytest.raises(ProblemError, match="a seed is a text"):
        written(text(" [m, l, g]"), seed)


def test_a_seed_cannot_write_into_the_file() -> None:
    found = written(text(" [m, l, g]"), "anna\ntitle: other")
    assert found.split("\n")[1] == "title: Pendulum   # the first"
