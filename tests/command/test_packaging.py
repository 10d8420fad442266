"""The wheel: what is in it, and that it works where nothing else is.

The command is run from another folder, in an environment of its own. The dependencies are borrowed from where the tests
run; with CI=true they come from the package index, and the build is isolated, as for a user who installs.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import sysconfig
import tomllib
import zipfile
from pathlib import Path

import pytest

from tests.support.paths import PROBLEMS, ROOT
from tests.support.processes import PATIENCE

FOR_REAL = os.environ.get("CI") == "true"
LEFT_OUT = (".git", ".venv", "build", "dist", "*.egg-info", "__pycache__", ".*_cache", ".hypothesis", "actual")


def run(*command: str | Path, folder: Path) -> str:
    kept = {k: v for k, v in os.environ.items() if not k.startswith("PYTHON") and k not in ("VIRTUAL_ENV", "COLUMNS")}
    done = subprocess.run(
        command, cwd=folder, env=kept, capture_output=True, text=True, encoding="utf-8", check=False, timeout=PATIENCE
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@pytest.fixture(scope="module")
def checkout(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The files that git knows, or would take; all files where there is no git."""
    copy = tmp_path_factory.mktemp("checkout") / "lagsolve"
    command = ["git", "-c", "safe.directory=*", "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
    listed = None
    if shutil.which("git") and (ROOT / ".git").exists():
        listed = (
            subprocess.run(command, cwd=ROOT, capture_output=True, check=True, timeout=PATIENCE)
            .stdout.decode()
            .split("\0")
        )
    if listed is None:
        shutil.copytree(ROOT, copy, ignore=shutil.ignore_patterns(*LEFT_OUT))
        return copy
    for name in filter(None, listed):
        if (ROOT / name).is_file():
            (copy / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(ROOT / name, copy / name)
    return copy


@pytest.fixture(scope="module")
def wheel(checkout: Path) -> Path:
    options = ["--no-deps", "--quiet", "--wheel-dir", "wheels"]
    if not FOR_REAL:
        options += ["--no-build-isolation", "--no-index"]
    run(sys.executable, "-m", "pip", "--disable-pip-version-check", "wheel", ".", *options, folder=checkout)
    [built] = (checkout / "wheels").glob("*.whl")
    return built


@pytest.fixture(scope="module")
def contents(wheel: Path) -> set[str]:
    with zipfile.ZipFile(wheel) as archive:
        return set(archive.namelist())


@pytest.fixture(scope="module")
def installed(wheel: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The `bin` of an environment that has the wheel."""
    home = tmp_path_factory.mktemp("environment")
    if FOR_REAL:
        run(sys.executable, "-m", "venv", "venv", folder=home)
        run(home / "venv/bin/python", "-m", "pip", "install", "--quiet", wheel, folder=home)
        return home / "venv/bin"
    run(sys.executable, "-m", "venv", "--without-pip", "venv", folder=home)
    python = home / "venv/bin/python"
    pip = [sys.executable, "-m", "pip", "--disable-pip-version-check", "--python", python]
    run(*pip, "install", "--no-deps", "--no-index", "--quiet", wheel, folder=home)
    its = Path(run(python, "-c", "import site; print(site.getsitepackages()[0])", folder=home).strip())
    for name in ("sympy", "mpmath", "click", "rich", "pygments", "markdown_it", "mdurl", "yaml", "_yaml"):
        (its / name).symlink_to(Path(sysconfig.get_path("purelib")) / name)
    return home / "venv/bin"


def test_only_the_two_packages_are_at_the_top(contents: set[str]) -> None:
    top = {name.split("/")[0] for name in contents}
    assert {name for name in top if not name.endswith(".dist-info")} == {"lagrange", "lagsolve"}
    assert len(top) == 3


def test_the_modules_and_their_types_are_in_it(contents: set[str], checkout: Path) -> None:
    for folder in (checkout / "lagrange", checkout / "cli" / "lagsolve"):
        modules = {str(p.relative_to(folder.parent)) for p in folder.rglob("*.py")}
        assert len(modules) > 5
        assert modules | {f"{folder.name}/py.typed"} <= contents


def test_the_problems_are_data_of_the_command(contents: set[str], checkout: Path) -> None:
    shipped = {f"lagsolve/problems/{p.relative_to(checkout / 'problems')}" for p in checkout.glob("problems/**/*.yaml")}
    assert shipped
    assert {name for name in contents if name.endswith(".yaml")} == shipped


def test_its_metadata(wheel: Path, contents: set[str]) -> None:
    with zipfile.ZipFile(wheel) as archive:
        [entry] = (name for name in contents if name.endswith("entry_points.txt"))
        [metadata] = (name for name in contents if name.endswith(".dist-info/METADATA"))
        assert "lagsolve = lagsolve.__main__:run" in archive.read(entry).decode()
        lines = archive.read(metadata).decode().splitlines()
    dependencies = [line.partition(": ")[2] for line in lines if line.startswith("Requires-Dist: ")]
    assert {d.split(">")[0] for d in dependencies if "extra ==" not in d} == {
        "sympy",
        "mpmath",
        "click",
        "rich",
        "pyyaml",
    }
    assert "Requires-Python: >=3.11" in lines
    assert "License-File: LICENSE" in lines


def test_the_licence_goes_with_it(wheel: Path, contents: set[str], checkout: Path) -> None:
    with zipfile.ZipFile(wheel) as archive:
        [licence] = (name for name in contents if name.endswith("/LICENSE"))
        text = archive.read(licence).decode()
    assert text == (checkout / "LICENSE").read_text(encoding="utf-8")
    assert text.startswith("MIT License\n\nCopyright (c) 2026 The lagsolve authors\n")
    with (checkout / "pyproject.toml").open("rb") as file:
        settings = tomllib.load(file)
    assert settings["project"]["license"] == {"text": "MIT"}
    assert "LICENSE" in settings["tool"]["hatch"]["build"]["targets"]["sdist"]["include"]


def test_the_command_works_elsewhere(installed: Path, tmp_path: Path) -> None:
    where = run(installed / "python", "-c", "import lagsolve, lagrange; print(lagsolve.__file__)", folder=tmp_path)
    assert where.startswith(str(installed.parent))
    assert (installed / "lagsolve").read_text().startswith(f"#!{installed}/python")
    names = [line.split()[0] for line in run(installed / "lagsolve", "list", folder=tmp_path).splitlines()]
    assert names == sorted(str(p.relative_to(PROBLEMS).with_suffix("")) for p in PROBLEMS.glob("*/*.yaml"))
    solved = json.loads(run(installed / "lagsolve", "ex11-ideal-pendulum", "--format", "json", folder=tmp_path))
    assert solved["degrees_of_freedom"] == 1
    assert all(check["passed"] for check in solved["checks"])
    assert "Ideal pendulum" in run(installed / "python", "-m", "lagsolve", "ex11", "--detail", "brief", folder=tmp_path)
    assert "lagsolve, version" in run(installed / "lagsolve", "--version", folder=tmp_path)
