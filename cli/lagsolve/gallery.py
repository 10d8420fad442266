"""A static site of the shipped problems: an index by topic with figures and a search, and a page for each problem.

    python -m lagsolve.gallery FOLDER [NAME ...]         # `make gallery`

Any web server can serve the folder, or a browser open its `index.html` from the disk: nothing is loaded from elsewhere.
The search is a script of the index that hides problems without the words; without scripts all problems are listed.
"""

from __future__ import annotations

import gc
import sys
from collections.abc import Iterable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from html import escape
from itertools import groupby
from pathlib import Path

from lagrange.core.records import record
from lagsolve import shipped
from lagsolve.written_files import write_file

STYLE = """
main { max-width: 76rem; }
input { font: inherit; width: 100%; max-width: 30rem; padding: .4rem .6rem; margin: 1rem 0 0; color: inherit;
  background: var(--box); border: 1px solid var(--line); border-radius: 4px; }
.cards { display: grid; grid-template-columns: repeat(auto-fill, minmax(16rem, 1fr)); gap: 1rem; padding: 0; }
.card { list-style: none; border: 1px solid var(--line); border-radius: 6px; padding: .8rem 1rem; }
.card a { font-weight: 600; }
.card figure { margin: .2rem 0 .6rem; height: 11rem; display: flex; justify-content: center; align-items: center; }
.card svg { max-height: 11rem; width: auto; }
.card p { font-size: .92em; margin: .3rem 0 0; }
"""
SCRIPT = """
const box = document.getElementById("search"), said = document.getElementById("said");
const cards = [...document.querySelectorAll(".card")], topics = [...document.querySelectorAll("section")];
function search() {
  const words = box.value.toLowerCase().split(/\\s+/).filter(word => word);
  let found = 0;
  for (const card of cards) {
    card.hidden = !words.every(word => card.dataset.text.includes(word));
    found += !card.hidden;
  }
  for (const topic of topics) topic.hidden = !topic.querySelector(".card:not([hidden])");
  said.textContent = words.length ? found + (found == 1 ? " problem" : " problems") : "";
}
box.parentElement.hidden = false;
box.addEventListener("input", search);
"""


@record
class Card:
    """One problem in the index.

    figure  an `svg` element; empty if there is nothing to draw
    failed  why there is no page; empty if there is one
    """

    entry: shipped.Entry
    description: str
    figure: str
    failed: str = ""


def build(folder: Path, names: Sequence[str] = (), processes: int = 1) -> Iterator[Card]:
    """Writes the site, and yields each problem when its page is written; only these problems, if any are named."""
    entries = [e for e in shipped.containing(()) if not names or e.name in names or e.name.split("/")[-1] in names]
    made = []
    written = partial(write_page, folder)
    if processes > 1:
        with ProcessPoolExecutor(processes) as pool:
            for card in pool.map(written, entries):
                made.append(card)
                yield card
    else:
        for card in map(written, entries):
            made.append(card)
            yield card
    write_file(folder / "index.html", index_page(made))


def write_page(folder: Path, entry: shipped.Entry) -> Card:
    """Solves one problem and writes its page."""
    from lagrange.core.diagnostics import ProblemError
    from lagrange.document.derivation import Picture, Rule
    from lagrange.document.math_writer import UNICODE, Writer
    from lagrange.explain.report import report
    from lagrange.problem.library import path_of
    from lagrange.problem.loader import load
    from lagrange.render import html, svg

    try:
        problem = load(path_of(entry.name))
        explained = report(problem, complete=False)
    except ProblemError as error:
        return Card(entry, "", "", " ".join(error.show().split()))
    derivation, notation = explained.derivation, explained.notation
    page = html.render([(derivation, notation)])
    back = '<main>\n<nav><a href="../index.html">All problems</a></nav>'
    path = folder / f"{entry.name}.html"
    path.parent.mkdir(parents=True, exist_ok=True)
    write_file(path, page.replace("<main>", back, 1))
    statement = (b for s in derivation.page if s.rule is Rule.STATEMENT for b in s.body if isinstance(b, Picture))
    picture = next(statement, None)
    scene = None if picture is None else picture.draw()
    write = Writer(UNICODE, notation).plain
    drawn = "" if picture is None or scene is None else "\n".join(svg.figure(scene, picture.alt, write))
    gc.collect()
    return Card(entry, problem.description, drawn)


def index_page(cards: Iterable[Card]) -> str:
    """The index: topics in their order, and the problems of each."""
    from lagrange.render.html import CSS

    of = shipped.index()
    order = [*of.topics]
    known = sorted(cards, key=lambda c: order.index(c.entry.topic) if c.entry.topic in order else len(order))
    lines = [
        "<!DOCTYPE html>",
        '<html lang="en">',
        "<head>",
        '<meta charset="utf-8">',
        '<meta name="viewport" content="width=device-width, initial-scale=1">',
        "<title>Problems of analytical mechanics</title>",
        f"<style>\n{CSS}\n{STYLE.strip()}\n</style>",
        "</head>",
        "<body>",
        "<main>",
        "<h1>Problems of analytical mechanics</h1>",
        f"<p>{len(known)} problems, each derived step by step and checked by lagsolve.</p>",
        '<p hidden><input id="search" type="search" placeholder="Search: pendulum, rolling, Goldstein" '
        'aria-label="Search the problems"> <span id="said" aria-live="polite"></span></p>',
    ]
    for topic, members in groupby(known, key=lambda c: c.entry.topic):
        lines += ["<section>", f"<h2>{escape(of.topics.get(topic, topic))}</h2>", '<ul class="cards">']
        lines += [line for card in members for line in _card(card)]
        lines += ["</ul>", "</section>"]
    return "\n".join([*lines, f"<script>{SCRIPT}</script>", "</main>", "</body>", "</html>"]) + "\n"


def _card(card: Card) -> Iterator[str]:
    e = card.entry
    searched = " ".join(f"{e.name} {e.title} {e.source} {e.exercises} {card.description} {' '.join(e.asked)}".split())
    yield f'<li class="card" data-text="{escape(searched.lower())}">'
    yield f"<figure>{card.figure}</figure>"
    title = escape(e.title)
    yield title if card.failed else f'<a href="{escape(e.name)}.html">{title}</a>'
    yield f'<p class="source">{escape(e.source)}</p>' if e.source else ""
    yield f"<p>{escape(card.failed or e.exercises)}</p>"
    yield "</li>"


def main() -> None:
    """`python -m lagsolve.gallery FOLDER [NAME ...]`."""
    from lagsolve.grading.pool import available_cores

    if len(sys.argv) < 2:
        sys.exit("python -m lagsolve.gallery FOLDER [NAME ...]")
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    failed = 0
    for n, card in enumerate(build(folder, sys.argv[2:], available_cores()), start=1):
        failed += bool(card.failed)
        sys.stderr.write(f"{n:4} {card.entry.name}{': ' + card.failed if card.failed else ''}\n")
    sys.stdout.write(f"{folder / 'index.html'}\n")
    sys.exit(3 if failed else 0)


if __name__ == "__main__":
    main()
