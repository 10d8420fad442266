"""What a name on the command line means."""

from __future__ import annotations

from pathlib import Path

import pytest

from lagsolve.new_file import TEMPLATE
from tests.command.test_problem_commands import run


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("pearl", "did you mean `pearl.yaml`?"),
        ("bed.yaml", "did you mean `bead.yaml`?"),
        ("./bed.yaml", "did you mean `bead.yaml`?"),
        ("folder/woool.yaml", "did you mean `folder/wool.yaml`?"),
        ("ex11.yaml", "did you mean `ex11`, which is a problem of the library?"),
        ("nowhere/x.yaml", "check the name"),
        ("statics", "`lagsolve list statics` shows its problems"),
        ("statics/", "`lagsolve list statics` shows its problems"),
    ],
)
def test_what_a_name_may_mean(name: str, said: str, here: Path) -> None:
    (here / "folder").mkdir()
    for file in ("bead.yaml", "pearl.yaml", "folder/wool.yaml"):
        (here / file).write_text(TEMPLATE)
    result = run(name)
    assert (result.exit_code, result.stdout) == (2, "")
    assert said in result.stderr


def test_a_file_whose_name_is_that_of_a_shipped_problem(here: Path) -> None:
    """A name without extension is that of a bundled problem, and standard error says that the file was not used."""
    (here / "ex11.yaml").write_text(TEMPLATE)
    (here / "bead.yml").write_text(TEMPLATE)
    shipped = run("ex11", "--detail", "brief")
    assert shipped.exit_code == 0
    assert "note[file-beside]: `ex11` is the problem `ex11-ideal-pendulum` of the library" in shipped.stderr
    assert "write `ex11.yaml`" in shipped.stderr
    for name in ("ex11.yaml", "./ex11.yaml", "ex12"):
        assert "file-beside" not in run(name, "--detail", "brief").stderr
    several = run("bead")
    assert (several.exit_code, several.stdout) == (2, "")
    assert several.stderr.endswith("write the whole name, or `bead.yml` for the file of that name\n")
