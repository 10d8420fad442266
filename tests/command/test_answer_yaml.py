"""Answers to all questions of a problem in a YAML file, through the command line."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from tests.command.test_main import PENDULUM, run

RIGHT = """
degrees_of_freedom: 1
classification: [holonomic, scleronomic]
integrable: {rod: true}
equations: ["theta'' + g/l*sin(theta) = 0"]
reactions: {rod: "-m*g*cos(theta)/(2*l) - m*theta'^2/2"}
"""


def checked(here: Path, text: str, *arguments: str, problem: str = PENDULUM) -> tuple[int, dict[str, Any]]:
    (here / "a.yaml").write_text(text, encoding="utf-8")
    result = run("check", problem, "a.yaml", *arguments, "--format", "json")
    assert "Traceback" not in result.output
    return result.exit_code, json.loads(result.stdout) if result.stdout else {}


def test_right_answers_to_all_questions(here: Path) -> None:
    for text in (RIGHT, "answers:\n" + "".join(f"  {line}\n" for line in RIGHT.splitlines())):
        status, found = checked(here, text)
        assert (status, found["verdict"]) == (0, "equivalent")
        assert [(a["name"], a["verdict"]) for a in found["answers"]] == [
            ("degrees_of_freedom", "equivalent"),
            ("classification", "equivalent"),
            ("integrable", "equivalent"),
            ("reactions", "equivalent"),
        ]
        assert [e["verdict"] for e in found["equations"]] == ["equivalent"]


@pytest.mark.parametrize(
    ("right", "wrong", "part"),
    [
        ("degrees_of_freedom: 1", "degrees_of_freedom: 2", "degrees_of_freedom"),
        ("scleronomic", "rheonomic", "classification"),
        ("rod: true", "rod: false", "integrable"),
        ("theta'^2/2", "theta'^2/3", "reactions"),
    ],
)
def test_each_answer_has_its_own_verdict(right: str, wrong: str, part: str, here: Path) -> None:
    assert right in RIGHT
    status, found = checked(here, RIGHT.replace(right, wrong))
    assert (status, found["verdict"]) == (1, "wrong")
    assert {a["name"] for a in found["answers"] if a["verdict"] == "wrong"} == {part}
    assert [e["verdict"] for e in found["equations"]] == ["equivalent"]


def test_what_is_wrong_in_a_classification_is_named(here: Path) -> None:
    _, found = checked(here, "classification: [holonomic, rheonomic]")
    assert found["answers"] == [
        {
            "name": "classification",
            "verdict": "wrong",
            "diagnosis": "not right: rheonomic; time occurs neither in a constraint nor in a position",
        }
    ]


def test_equations_on_the_command_line_are_judged_with_the_others(here: Path) -> None:
    status, found = checked(here, "degrees_of_freedom: 1", "-e", "theta'' = 0")
    assert (status, found["verdict"]) == (1, "wrong")
    assert [e["verdict"] for e in found["equations"]] == ["wrong"]
    status, found = checked(here, 'equations: ["x^2 + y^2 = l^2"]', "-e", "theta'' = -g*sin(theta)/l")
    assert (status, [e["verdict"] for e in found["equations"]]) == (0, ["equivalent", "equivalent"])


def test_an_equation_that_cannot_be_read_leaves_the_others_judged(here: Path) -> None:
    text = (
        "equations: [\"theta'' + q = 0\", \"l*theta'' = -g*sin(theta)\"]\nreactions: {rod: q}\ndegrees_of_freedom: 1\n"
    )
    status, found = checked(here, text)
    assert (status, found["verdict"]) == (2, "unreadable")
    assert [e["verdict"] for e in found["equations"]] == ["unreadable", "equivalent"]  # where they were written
    assert {a["name"]: a["verdict"] for a in found["answers"]} == {
        "degrees_of_freedom": "equivalent",
        "reactions": "unreadable",
    }
    (here / "a.yaml").write_text(text, encoding="utf-8")
    assert " --> a.yaml:1:24" in run("check", PENDULUM, "a.yaml").stderr


def test_equilibrium_and_reactions_at_rest(here: Path) -> None:
    status, found = checked(
        here, 'equilibrium: ["tan(theta) = (2*k - 1)/tan(alpha)"]', problem="ex16-rod-on-two-planes"
    )
    assert (status, found["verdict"]) == (0, "equivalent")
    status, found = checked(
        here, 'equilibrium: ["tan(theta) = (2*k + 1)/tan(alpha)"]', problem="ex16-rod-on-two-planes"
    )
    assert (status, found["verdict"]) == (1, "wrong")
    assert [e["verdict"] for e in found["answers"][0]["equations"]] == ["wrong"]
    status, found = checked(here, "equilibrium: [theta = 0]")
    assert (status, found["verdict"]) == (3, "undecided")


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("", "empty-file"),
        ("# nothing\n", "empty-file"),
        ("{}", "no-answer"),
        ("answers: {}", "no-answer"),
        ("hello", "not-a-mapping"),
        ("[1, 2]", "not-a-mapping"),
        ("equation: x = 0", "unknown-key"),
        ("title: x", "unknown-key"),
        ("degrees_of_freedom: many", "not-a-number"),
        ("degrees_of_freedom: yes", "not-a-number"),
        ("degrees_of_freedom: [1]", "wrong-kind"),
        ("degrees_of_freedom: 1\ndegrees_of_freedom: 2", "duplicate-key"),
        ("integrable: {rope: true}", "unknown-name"),
        ("integrable: {rod: perhaps}", "not-a-truth-value"),
        ("classification: [nice]", "unknown-class"),
        ("equations: [[1, 2]]", "wrong-kind"),
        ("equations: {a: b}", "wrong-kind"),
        ("equations: !!python/object/apply:os.system [id]", "tag"),
        ("equations: &a [*a]", ""),
        ("a: &a [x,x,x,x,x,x,x,x,x]\nb: &b [*a,*a,*a,*a,*a,*a,*a,*a]\nequations: [*b,*b,*b,*b,*b,*b,*b,*b]", ""),
        ("equations: [\"theta'' = 0\"", ""),
    ],
)
def test_mistakes_of_the_file_are_errors(text: str, code: str, here: Path) -> None:
    (here / "a.yaml").write_text(text, encoding="utf-8")
    result = run("check", PENDULUM, "a.yaml")
    assert (result.exit_code, result.stdout) == (2, "")
    assert f"error[{code}" in result.stderr


@pytest.mark.parametrize("data", [b"\xff\xfee\x00q\x00", b"equations: [\xff]", b"x" * (1 << 20) + b"x", b"a: \x00"])
def test_what_is_no_text_is_an_error(data: bytes, here: Path) -> None:
    (here / "a.yaml").write_bytes(data)
    result = run("check", PENDULUM, "a.yaml")
    assert (result.exit_code, result.stdout) == (2, "")
    assert result.stderr.startswith("error[")


@pytest.mark.parametrize("value", ["no", "1e3", "0x10", "12:30", "null", "~", "yes", "3"])
def test_words_of_yaml_are_no_equations(value: str, here: Path) -> None:
    (here / "a.yaml").write_text(f"equations: [{value}]\n", encoding="utf-8")
    result = run("check", PENDULUM, "a.yaml")
    assert result.exit_code == 2
    assert "error[" in result.stderr


@pytest.mark.parametrize("width", ["40", "60", "80", "120"])
def test_what_is_printed_fits(width: str, here: Path) -> None:
    text = "".join(f"{line}\n" for line in RIGHT.splitlines() if "equations" not in line)
    (here / "a.yaml").write_text(text.replace("rod: true", "rod: false"), encoding="utf-8")
    result = run("check", PENDULUM, "a.yaml", "-e", "theta'*(l*theta'' + g sin theta) = 0", env={"COLUMNS": width})
    assert max(map(len, result.stdout.splitlines())) <= int(width)
    assert " ".join(result.stdout.split()).startswith(
        "wrong: not all of the answers agree with the derivation ✓ degrees"
    )
    assert "valid where theta' != 0" in " ".join(result.stdout.split())
