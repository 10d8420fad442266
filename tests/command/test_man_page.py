"""The manual page, from the help of the command."""

from __future__ import annotations

import re
import shutil
import subprocess

import pytest

from lagsolve.command_group import COMMANDS
from lagsolve.main import main
from lagsolve.man_page import escape, man_page
from tests.support.processes import PATIENCE


def test_the_manual_page_has_every_command_and_option() -> None:
    page = man_page()
    for name in COMMANDS:
        assert f".SH {'SOLVING' if name == 'solve' else escape(name.upper())}\n" in page
        for option in main.commands[name].params:
            for written in (o for o in option.opts if o.startswith("--")):
                assert escape(written) in page
    assert "\b" not in page
    assert not re.search(r"^'", page, re.MULTILINE)


@pytest.mark.skipif(shutil.which("man") is None or shutil.which("groff") is None, reason="there is no groff")
def test_groff_reads_the_manual_page() -> None:
    done = subprocess.run(
        ["groff", "-man", "-ww", "-Tutf8"],
        input=man_page(),
        capture_output=True,
        text=True,
        timeout=PATIENCE,
        check=True,
    )
    assert done.stderr == ""
