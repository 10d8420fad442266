"""`lagsolve simulate` and `lagsolve export`: what they print and write, their exit status, their errors."""

from __future__ import annotations

import json
import math
import re
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from lagrange.programs import prepared as preparing
from lagsolve.main import main


def run(*arguments: str, text: str | None = None) -> Result:
    result = CliRunner().invoke(main, arguments, input=text)
    assert result.exception is None or isinstance(result.exception, SystemExit)
    return result


def test_a_pendulum_is_simulated() -> None:
    result = run("simulate", "ex11", "--until", "2", "--set", "theta=30 deg", "--set", "l=0.5")
    assert result.exit_code == 0
    assert "0 to 2 s, in theta (choice angle)" in result.stdout
    assert re.search(r"^  l +0.5 m$", result.stdout, re.MULTILINE)
    assert re.search(r"^  m +[\d.]+ kg +assumed$", result.stdout, re.MULTILINE)
    assert re.search(r"^  theta +0.5236 ", result.stdout, re.MULTILINE)
    assert re.search(r"^  energy +\d\.\de-\d\d$", result.stdout, re.MULTILINE)


@pytest.mark.parametrize(
    ("ending", "begin"), [("svg", b"<?xml"), ("png", b"\x89PNG"), ("pdf", b"%PDF"), ("csv", b"t (s),")]
)
def test_files_are_what_their_endings_say(ending: str, begin: bytes, tmp_path: Path) -> None:
    path = tmp_path / f"motion.{ending}"
    assert run("simulate", "ex11", "--until", "1", "-o", str(path)).exit_code == 0
    assert path.read_bytes().startswith(begin)


def test_a_page_begins_with_the_command_line(tmp_path: Path) -> None:
    path = tmp_path / "x.html"
    settings = [f"--set={s}" for s in ("phi1=60 deg", "phi2'=0.5", "l1=0.7")]
    result = run("simulate", "ex18", "--choice", "angles", *settings, "--until", "2", "-o", str(path))
    assert result.exit_code == 0
    page = path.read_text()
    [data] = re.findall(r'<script type="application/json">(.*?)</script>', page)
    found = json.loads(data)
    assert found["y"][0] == pytest.approx(math.pi / 3, rel=1e-15)
    assert found["y"][2:] == [0, 0.5, 0]
    assert found["p"].count(0.7) == 1
    assert found["motion"][-1][-1] == 2
    table = run("simulate", "ex18", "--choice", "angles", *settings, "--until", "2", "-o", "-").stdout.splitlines()
    first, last = ([float(x) for x in line.split(",")] for line in (table[1], table[-1]))
    assert found["y"][:4] == pytest.approx(first[1:5], rel=1e-11)
    assert found["motion"][-1][:4] == pytest.approx(last[1:5], rel=1e-8)


def test_a_title_of_a_file_is_not_set_as_mathematics(tmp_path: Path) -> None:
    problem = tmp_path / "p.yaml"
    problem.write_text(
        "title: 'A $\\frac{ title'\nparameters: [m]\ncoordinates: [x]\nparticles: {P: {mass: m, position: x*i}}"
    )
    assert run("simulate", str(problem), "--until", "1", "-o", str(tmp_path / "a.svg")).exit_code == 0


def test_the_table_goes_to_standard_output_alone() -> None:
    result = run("simulate", "ex11", "--until", "1", "--samples", "11", "-o", "-")
    assert len(result.stdout.splitlines()) == 12
    assert "Ideal pendulum" in result.stderr


def test_a_motion_that_cannot_be_followed_has_status_3() -> None:
    result = run("simulate", "escape-from-a-planet", "--set", "v=1")
    assert result.exit_code == 3
    assert "cannot be followed any further" in result.stdout


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("--until", "-1"), "not a positive time"),
        (("--until", "nan"), "not a positive time"),
        (("-o", "motion.doc"), "is not one of .csv .svg .png .pdf"),
        (("--choice", "angel"), "did you mean `angle`?"),
        (("--set", "theta=x^"), "--set:1:"),
        (("--set", "lenght=2"), "unknown-parameter"),
        (("--set", "l=-2"), "contradicts"),
    ],
)
def test_mistakes_have_status_2(arguments: tuple[str, ...], said: str) -> None:
    result = run("simulate", "ex11", *arguments)
    assert result.exit_code == 2
    assert said in result.stderr


def test_functions_that_nobody_has_given_are_assumed_and_printed() -> None:
    result = run("simulate", "pole-on-cart", "--until", "1")
    assert result.exit_code == 0
    assert "F(t) = 0.5 + 0.3*sin(2*t)    assumed; --set changes it" in result.stdout
    given = run("simulate", "pole-on-cart", "--until", "1", "--set", "F=0")
    assert re.search(r"F\(t\) = 0$", given.stdout, re.MULTILINE)


def test_an_event_is_told_once_and_numbers_of_the_start_are_named() -> None:
    result = run("simulate", "ball-with-backspin")
    assert re.search(r"rolls: t = 0\.\d+ s$", result.stdout, re.MULTILINE)
    assert re.search(r"^  w +2 rad/s +assumed$", result.stdout, re.MULTILINE)
    assert "the slip that the file gives ends; the equations no longer" in result.stdout


def test_what_is_missing_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(preparing, "find_spec", lambda name: None if name == "scipy" else object())
    result = run("simulate", "ex11")
    assert result.exit_code == 2
    assert "error[missing-extra]" in result.stderr
    assert 'pip install "lagsolve[sim]"' in result.stderr


def test_a_problem_is_exported(tmp_path: Path) -> None:
    result = run("export", "ex11", "--to", "python")
    assert result.exit_code == 0
    assert "def f(t, y, p=PARAMETERS):" in result.stdout
    path = tmp_path / "pendulum.m"
    assert run("export", "ex11", "-o", str(path)).exit_code == 0
    assert path.read_text().startswith("function out = pendulum(t, y, p)")
    assert run("export", "ex11").exit_code == 2
    assert run("export", "ex11", "--to", "fortran").exit_code == 2
    assert run("export", "ex05", "--to", "c").exit_code == 2
