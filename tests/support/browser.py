"""A page in a real browser, without a window: what does not fit, and what is not drawn.

The page is put into a frame of the width asked for, because a window has a least width; a script in the page around it
measures. Chromium must be installed; `CHROMIUM` is None where it is not.
"""

from __future__ import annotations

import html
import json
import re
import shutil
import subprocess
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import TypedDict

CHROMIUM = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
_SCRIPT = """
addEventListener("load", () => {
  const found = [...document.querySelectorAll("iframe")].map(e => measured(e.contentWindow)), out = document.createElement("pre");
  out.id = "out";
  out.textContent = JSON.stringify(found);
  document.body.append(out);
});
function measured(frame) {
  const page = frame.document, root = page.documentElement;
  const faults = [], say = e => (e.getAttribute("aria-label") || e.textContent).slice(0, 80);
  if (root.scrollWidth > root.clientWidth) faults.push("the page is " + root.scrollWidth + " wide");
  page.querySelectorAll(".equation, td, th, table, p, li, h1, h2").forEach(e => {
    if (e.scrollWidth > e.clientWidth + 1 && e.clientWidth > 0 && frame.getComputedStyle(e).display != "inline")
      faults.push(e.scrollWidth + " in " + e.clientWidth + ": " + say(e));
  });
  let drawn = 0;
  page.querySelectorAll("math").forEach(e => {
    const box = e.getBoundingClientRect(), hidden = e.closest(".label, .phone, .desk, thead");
    if (box.width > 0 && box.height > 0) drawn += 1;
    else if (!hidden) faults.push("not drawn: " + say(e));
  });
  return {width: root.clientWidth, drawn: drawn, faults: faults};
}
"""


class Measured(TypedDict):
    """The width of the page, how many formulas are drawn, and what is wrong."""

    width: int
    drawn: int
    faults: list[str]


def measured(page: str, width: int) -> Measured:
    """Opens a page in a column of `width` pixels."""
    [found] = all_measured([(page, width)])
    return found


def all_measured(pages: Sequence[tuple[str, int]]) -> list[Measured]:
    """Opens pages, each in a column of its width, in one browser."""
    frames = "".join(
        f'<iframe srcdoc="{html.escape(page)}" style="width:{width}px;height:900px;border:0"></iframe>'
        for page, width in pages
    )
    widest = max(width for _, width in pages)
    around = f"<!DOCTYPE html><meta charset=utf-8><body>{frames}<script>{_SCRIPT}</script>"
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "page.html")
        file.write_text(around, encoding="utf-8")
        assert CHROMIUM is not None
        flags = ["--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={folder}/profile"]
        call = [CHROMIUM, *flags, f"--window-size={widest + 100},1000", "--dump-dom", file.as_uri()]
        done = subprocess.run(call, capture_output=True, text=True, timeout=300, check=False)
    found = re.search(r'<pre id="out">(.*?)</pre>', done.stdout, re.DOTALL)
    if found is None:
        raise RuntimeError(f"the browser said nothing: {done.stderr[-2000:]}")

    result: list[Measured] = json.loads(html.unescape(found[1]))
    return result
