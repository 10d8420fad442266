"""Pages whose figures move, played in a real browser without a window: several pages in one start of it.

Each page is put into a frame; a script around them works its controls, as a reader would, and reads what it shows.
"""

from __future__ import annotations

import html
import json
import re
import subprocess
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from tests.support.browser import CHROMIUM

_SCRIPT = """
const wait = milliseconds => new Promise(done => setTimeout(done, milliseconds));
addEventListener("load", async () => {
  const found = [];
  for (const e of document.querySelectorAll("iframe")) {
    const errors = [], frame = e.contentWindow, page = frame.document;
    frame.addEventListener("error", m => errors.push(m.message));
    const figure = page.querySelector("[data-moving]");
    if (!figure) { found.push({moves: false}); continue; }
    const play = seconds => { figure.dispatchEvent(new frame.CustomEvent("lagsolve-run", {detail: {seconds}})); return {...figure.dataset}; };
    const read = name => (figure.querySelector(`[data-out="${name}"]`) || {}).textContent;
    const slide = (kind, k, value) => { const i = figure.querySelector(`input[data-${kind}="${k}"]`); i.value = value; i.dispatchEvent(new frame.Event("input", {bubbles: true})); };
    const one = {moves: !figure.hidden, start: play(0)};
    const drawn = () => [...figure.querySelectorAll("g.lines path")].map(p => p.getAttribute("d")).join(" ");
    DRIVE
    one.errors = errors;
    found.push(one);
  }
  const out = document.createElement("pre");
  out.id = "out";
  out.textContent = JSON.stringify(found);
  document.body.append(out);
});
"""

DRIVE = """
    const before = drawn();
    one.run = play(20);
    one.redrawn = drawn() != before;
    one.message = read("message");
    one.shown = {E: read("E"), drift: read("drift"), error: read("error"), t: read("t"), R: read("R0")};
"""
"""Twenty seconds of motion, and what is shown after them."""


def played(pages: Sequence[str], drive: str = DRIVE, width: int = 900) -> list[dict[str, Any]]:
    """Opens pages and works their controls; `drive` is a script that fills `one`, the result for a page."""
    frames = "".join(
        f'<iframe srcdoc="{html.escape(page)}" style="width:{width}px;height:900px;border:0"></iframe>'
        for page in pages
    )
    around = f"<!DOCTYPE html><meta charset=utf-8><body>{frames}<script>{_SCRIPT.replace('DRIVE', drive)}</script>"
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "page.html")
        file.write_text(around, encoding="utf-8")
        assert CHROMIUM is not None
        flags = ["--headless", "--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking"]
        flags += ["--disable-component-update", "--disable-sync", f"--user-data-dir={folder}/profile"]
        call = [CHROMIUM, *flags, f"--window-size={width + 100},1000", "--virtual-time-budget=20000", "--dump-dom"]
        done = subprocess.run([*call, file.as_uri()], capture_output=True, text=True, timeout=250, check=False)
    found = re.search(r'<pre id="out">(.*?)</pre>', done.stdout, re.DOTALL)
    if found is None:
        raise RuntimeError(f"the browser said nothing: {done.stderr[-2000:]}")
    result: list[dict[str, Any]] = json.loads(html.unescape(found[1]))
    return result
