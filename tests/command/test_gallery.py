"""The gallery: a few problems, links that lead somewhere, a search that works in a real browser without a network."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

import pytest

from lagsolve import shipped
from lagsolve.gallery import Card, build, index_page
from tests.support.browser import CHROMIUM
from tests.support.paths import ROOT
from tests.support.processes import PATIENCE

NAMES = ("chapter6/ex05-ice-skate", "ex11-ideal-pendulum", "constraints/form-in-two-variables")


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("gallery")
    cards = list(build(folder, NAMES))
    assert [c.failed for c in cards] == ["", "", ""]
    assert [bool(c.figure) for c in cards] == [True, True, False]
    return folder


def test_every_link_leads_to_a_page_and_back(site: Path) -> None:
    index = (site / "index.html").read_text(encoding="utf-8")
    links = re.findall(r'href="([^"#]+)"', index)
    assert sorted(links) == [
        "chapter6/ex05-ice-skate.html",
        "chapter6/ex11-ideal-pendulum.html",
        "constraints/form-in-two-variables.html",
    ]
    for link in links:
        assert 'href="../index.html"' in (site / link).read_text(encoding="utf-8")
    assert not re.search(r"(?:src|href)=\"(?:https?:)?//", index)
    assert index.count("<svg") == 2
    assert index.index("The eighteen examples") < index.index("Constraints, and which")


def test_texts_are_escaped_and_failures_named() -> None:
    entry = shipped.Entry("a/b", "<i>&", 'x"y', ("motion",), "<script>")
    page = index_page([Card(entry, "d", "", "it failed")])
    assert page.count("<script>") == 1
    assert "&lt;i&gt;&amp;" in page
    assert "it failed" in page
    assert "<a href" not in page


@pytest.mark.skipif(CHROMIUM is None, reason="there is no Chromium")
def test_the_search_hides_what_has_not_the_words(site: Path, tmp_path: Path) -> None:
    assert CHROMIUM is not None
    page = (site / "index.html").read_text(encoding="utf-8")
    typed = '<script>box.value = "Pendulum CHAPTER"; box.dispatchEvent(new Event("input"));</script></main>'
    file = tmp_path / "index.html"
    file.write_text(page.replace("</main>", typed), encoding="utf-8")
    flags = ["--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={tmp_path}/profile", "--dump-dom"]
    call = [CHROMIUM, *flags, file.as_uri()]
    seen = subprocess.run(call, capture_output=True, text=True, timeout=PATIENCE, check=False).stdout
    hidden = re.findall(r'<li class="card" data-text="(\S+)[^>]*?(hidden="")?>', seen)
    assert {name: bool(gone) for name, gone in hidden} == {
        "chapter6/ex05-ice-skate": True,
        "chapter6/ex11-ideal-pendulum": False,
        "constraints/form-in-two-variables": True,
    }
    assert "1 problem</span>" in seen


def test_the_demo_says_what_to_do_next() -> None:
    """In the Makefile alone: a page that is handed out does not."""
    [demo] = re.findall(r"^demo:.*\n((?:\t.*\n)+)", (ROOT / "Makefile").read_text(encoding="utf-8"), re.MULTILINE)
    assert "What to do next" in demo
    for command in ("new mine.yaml", "list", "check ex11 -e"):
        assert f"$(BIN)/lagsolve {command}" in demo
