"""A derivation as a web page: one file that needs nothing from the network.

The only script on it is that of the moving figures (`moving`), if there are any.

Mathematics is MathML. Browsers do not break a formula, so a long equation is several formulas in a row, between which
they break the line (see `mathml`). One style sheet serves light and dark screens, phones, desks and paper; a table that
is wider than a phone is moved sideways there, its first column staying. Screen readers get headings in order, header
cells, and each displayed equation in the language of problem files as its label.

Derivations in the output of a notebook's cell: a piece of HTML that needs nothing else, without scripts.

The mathematics and the pictures are those of a web page. Its style sheet is confined to the output, takes letters and
colours from the notebook, and follows the notebook's theme where that says whether it is a dark one (JupyterLab and
VS Code mark it on the page's body).
"""

from __future__ import annotations

import base64
import hashlib
import re
from collections.abc import Iterable, Iterator, Sequence
from functools import cache
from itertools import groupby

from lagrange.animation.figure import MovingFigure, Still
from lagrange.core.printable import printable
from lagrange.document.derivation import (
    CheckMark,
    Derivation,
    Detail,
    Display,
    Emphasis,
    Equation,
    Math,
    Matrices,
    Part,
    Picture,
    Prose,
    Ref,
    Table,
    Task,
)
from lagrange.document.math_writer import UNICODE, Writer
from lagrange.document.names import Notation
from lagrange.document.scene import Scene, StrokeKind
from lagrange.render.escape import html_text as escape
from lagrange.render.escape import slug
from lagrange.render.limits import LONG_DISPLAY
from lagrange.render.mathml import Formulas
from lagrange.render.selection import Emitter, block_lines, entry_by_entry, shown
from lagrange.render.svg import figure

CSS = """
:root { color-scheme: light dark; --ink: #1c1b1a; --paper: #fffefb; --quiet: #6b6862; --line: #d9d5cb;
  --accent: #7a2e1d; --good: #2c6e3f; --bad: #b3261e; --box: #f7f3e8; }
@media (prefers-color-scheme: dark) { :root { --ink: #e8e4da; --paper: #1a1917; --quiet: #a19c91; --line: #45423c;
  --accent: #e0a48f; --good: #86c79a; --bad: #f2a59d; --box: #24221e; } }
* { box-sizing: border-box; }
html { -webkit-text-size-adjust: 100%; }
body { margin: 0; background: var(--paper); color: var(--ink); line-height: 1.55;
  font: 1.0625rem/1.55 "Palatino Linotype", Palatino, "Book Antiqua", "TeX Gyre Pagella", Georgia, serif; }
main { max-width: 46rem; margin: 0 auto; padding: 2rem 1.25rem 4rem; }
article + article { margin-top: 4rem; border-top: 1px solid var(--line); padding-top: 2rem; }
h1 { font-size: 1.7rem; line-height: 1.2; margin: 0; font-weight: 600; }
h2 { font-size: 1.12rem; margin: 2.2rem 0 .6rem; font-weight: 600; border-top: 1px solid var(--line);
  padding-top: .8rem; break-after: avoid; }
h2 .count { color: var(--accent); display: inline-block; min-width: 1.9rem; }
p { margin: .6rem 0; overflow-wrap: break-word; }
details { margin-top: 2.2rem; border-top: 1px solid var(--line); padding-top: .8rem; }
summary { cursor: pointer; font-weight: 600; }
.source { color: var(--quiet); font-style: italic; margin: .25rem 0 0; }
nav ol { padding-left: 1.5rem; }
a { color: var(--accent); text-decoration: none; }
a:hover, a:focus-visible { text-decoration: underline; }
math { font-family: "STIX Two Math", "Latin Modern Math", "Cambria Math", "TeX Gyre Pagella Math", math;
  font-size: 1.1em; }
mover > mo { font-size: 1.15em; }
.v { font-weight: bold; font-style: normal; }
.together, p math, li math, td math, th math { white-space: nowrap; }
.display { margin: .7rem 0; display: grid; grid-template-columns: 1fr auto; column-gap: 1rem; row-gap: .35rem;
  align-items: baseline; break-inside: avoid; }
.display.long { break-inside: auto; }
.display.aligned { grid-template-columns: auto 1fr auto; column-gap: .25rem; }
.display.aligned > .number { padding-left: .75rem; }
.display > .equation { padding-left: 3.2rem; text-indent: -1.6rem; min-width: 0; overflow-x: auto;
  overflow-y: hidden; padding-block: .12rem; }
.display.aligned > .left { padding-left: 1.6rem; text-align: right; }
.display.aligned > .equation { padding-left: 1.6rem; }
.display math { text-indent: 0; }
.term { display: inline-block; max-width: 100%; text-indent: -1em; padding-left: 1em;
  baseline-source: first; }
.condition { text-indent: 0; padding-left: 1em; display: inline-block; }
.number { color: var(--quiet); font-variant-numeric: tabular-nums; }
.result { border: 1px solid var(--accent); border-radius: 4px; background: var(--box); padding: .6rem .8rem .6rem 0; }
.scroll { margin: .8rem 0; overflow-x: auto; overflow-y: hidden; }
.task { break-inside: avoid; }
table { border-collapse: collapse; margin-left: 1.6rem; font-size: .98em; }
th, td { text-align: left; padding: .25rem .9rem .25rem 0; vertical-align: baseline; font-weight: normal; }
thead th { border-bottom: 1px solid var(--ink); color: var(--quiet); }
.phone { display: none; }
ul.checks { list-style: none; padding: 0; margin: .6rem 0; }
ul.checks li { padding-left: 1.6rem; text-indent: -1.6rem; margin: .2rem 0; }
.mark { display: inline-block; width: 1.6rem; text-indent: 0; font-weight: bold; }
.held { color: var(--good); } .failed { color: var(--bad); } .open { color: var(--quiet); }
.how { color: var(--quiet); }
figure { margin: 1.2rem 0; text-align: center; break-inside: avoid; }
figure svg { max-width: 100%; height: auto; }
figcaption { color: var(--quiet); font-size: .95em; margin-top: .3rem; }
.picture path { fill: none; stroke: currentColor; stroke-width: 1.3; stroke-linejoin: round; stroke-linecap: round; }
.picture .rod { stroke-width: 2.2; }
.picture .guide { stroke: var(--quiet); stroke-width: .9; stroke-dasharray: 4 4; }
.picture .axis, .picture .curve { stroke: var(--quiet); }
.picture .reference { stroke: var(--quiet); stroke-width: .9; stroke-dasharray: 4 4; }
.picture .ground { stroke-width: 1.6; }
.picture .hatch, .picture .grid { stroke: var(--quiet); stroke-width: .7; }
.picture .angle, .picture .dimension { stroke-width: 1; }
.picture .face { stroke: none; }
.picture .s1 { fill: var(--paper); }
.picture .s2 { fill: color-mix(in srgb, var(--ink) 6%, var(--paper)); }
.picture .s3 { fill: color-mix(in srgb, var(--ink) 13%, var(--paper)); }
.picture .s4 { fill: color-mix(in srgb, var(--ink) 22%, var(--paper)); }
.picture .force { stroke-width: 2; }
.picture .reaction { stroke: var(--accent); stroke-width: 2; }
.picture path.tip { fill: currentColor; stroke: none; }
.picture path.axis.tip { fill: var(--quiet); }
.picture path.reaction.tip { fill: var(--accent); }
.picture circle { fill: currentColor; }
.picture .hinge { fill: var(--paper); stroke: currentColor; stroke-width: 1.3; }
.picture text { font: 15px "STIX Two Text", "Latin Modern Roman", "TeX Gyre Pagella", Georgia, serif;
  fill: currentColor; text-anchor: middle; }
.picture .i { font-style: italic; }
.picture .b { font-weight: bold; }
.unseen { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); white-space: nowrap; }
@media (max-width: 40rem) {
  body { font-size: 1rem; }
  main { padding: 1.25rem 1rem 3rem; }
  .phone { display: inline; }
  .desk { display: none; }
  .display { column-gap: .5rem; }
  .display math { font-size: 1em; }
  .display > .equation { padding-left: 1rem; text-indent: -.6rem; }
  .display.aligned > .left { padding-left: .6rem; }
  .display.aligned > .equation { padding-left: 1.2rem; }
  .term { text-indent: -.4em; padding-left: .4em; }
  table { margin-left: 0; }
  th[scope=row] { position: sticky; left: 0; background: var(--paper); }
}
@media print {
  :root { --ink: #000; --paper: #fff; --quiet: #444; --line: #bbb; --accent: #000; --good: #000; --bad: #000;
    --box: #fff; }
  main { max-width: none; padding: 0; }
  article + article { break-before: page; border: 0; }
  h2, p:has(+ .display), p:has(+ figure) { break-after: avoid; }
}
""".strip()


MARKS = {True: ("✓", "held", "held"), False: ("✗", "failed", "did not hold"), None: ("?", "open", "undecided")}
CLOSING = re.compile(r"[).,:;]+")
OPENING = ("(", "[")


def render(
    derivations: Sequence[tuple[Derivation, Notation]],
    detail: Detail = Detail.STEPS,
    moving: Sequence[MovingFigure | Still | None] = (),
) -> str:
    """A page with these derivations; `moving`: the figure of each that moves, or why it does not."""
    figures = (*moving, *(None for _ in derivations[len(moving) :]))
    articles = [
        _Article(d, n, detail, _prefix(d, k, derivations), k, figures[k]) for k, (d, n) in enumerate(derivations)
    ]
    titles = [escape(a.derivation.title) for a in articles]
    bodies = [line for a in articles for line in a.all()]
    styles, scripts = [f"\n{CSS}\n"], []
    if any(a.moving_figure for a in articles):
        from lagrange.render.moving import call, resource

        styles.append(f"\n{resource('moving.css')}\n")
        scripts = [f"\n{resource('moving.js')}\n", *(call(a.place, f) for a in articles if (f := a.moving_figure))]
    lines = [
        "<!DOCTYPE html>",
        '<html lang="en">',
        "<head>",
        '<meta charset="utf-8">',
        policy(scripts, styles),
        '<meta name="viewport" content="width=device-width, initial-scale=1">',
        f"<title>{', '.join(titles)}</title>",
        *(f"<style>{style}</style>" for style in styles),
        "</head>",
        "<body>",
        "<main>",
    ]
    if len(articles) > 1:
        items = (f'<li><a href="#{a.prefix}">{title}</a></li>' for a, title in zip(articles, titles, strict=True))
        lines += ['<nav aria-label="Contents">', "<ol>", *items, "</ol>", "</nav>"]
    lines += [*bodies, "</main>", *(f"<script>{script}</script>" for script in scripts), "</body>", "</html>"]
    return "\n".join(lines) + "\n"


def fragment(derivation: Derivation, notation: Notation, detail: Detail = Detail.STEPS, prefix: str = "") -> str:
    """What one derivation contributes to a page; its ids begin with `prefix`, by default the slug of its title."""
    return "\n".join(_Article(derivation, notation, detail, prefix or slug(derivation.title)).all()) + "\n"


def policy(scripts: Sequence[str], styles: Sequence[str]) -> str:
    """The element that forbids everything but these scripts and styles."""

    def hashes(texts: Sequence[str]) -> str:
        digests = (base64.b64encode(hashlib.sha256(text.encode()).digest()).decode() for text in texts)
        return " ".join(f"'sha256-{d}'" for d in digests) or "'none'"

    rules = f"default-src 'none'; script-src {hashes(scripts)}; style-src {hashes(styles)}; base-uri 'none'"
    return f'<meta http-equiv="Content-Security-Policy" content="{rules}; form-action \'none\'">'


def _prefix(derivation: Derivation, place: int, derivations: Sequence[tuple[Derivation, Notation]]) -> str:
    """The prefix of the ids of a derivation: its title, and its place where several titles are alike."""
    name = slug(derivation.title)
    alike = sum(slug(d.title) == name for d, _ in derivations) > 1
    return f"{name}-{place + 1}" if alike else name


class _Article(Emitter[str]):
    """One derivation."""

    def __init__(
        self,
        derivation: Derivation,
        notation: Notation,
        detail: Detail,
        prefix: str,
        place: int = 0,
        figure: MovingFigure | Still | None = None,
    ) -> None:
        self.derivation, self.notation, self.place, self.figure = derivation, notation, place, figure
        self.placed = False
        self.formulas = Formulas.of(notation)
        self.in_pictures = Writer(UNICODE, notation, on_page=True)
        self.content = shown(derivation, detail, pictures=True)
        self.prefix = prefix

    def all(self) -> Iterator[str]:
        yield f'<article id="{self.prefix}">'
        if self.derivation.title:
            yield f"<h1>{escape(self.derivation.title)}</h1>"
        if self.derivation.source:
            yield f'<p class="source">{escape(self.derivation.source)}</p>'
        number = 0
        for folded, steps in groupby(self.content.steps, key=lambda step: step.folded):
            if folded:
                yield f"<details><summary>{self.prose(folded)}</summary>"
            for step in steps:
                if step.title:
                    number += 1
                    yield f'<h2><span class="count">{number}</span>{escape(step.title)}</h2>'
                yield from block_lines(step.body, self)
            if folded:
                yield "</details>"
        yield from self.moving(self.derivation.title)
        yield "</article>"

    @property
    def moving_figure(self) -> MovingFigure | None:
        """The figure that moves, if there is one."""
        return self.figure if isinstance(self.figure, MovingFigure) else None

    def moving(self, alt: str) -> Iterator[str]:
        """The figure that moves, or a line that says why there is none; once on the page."""
        figure = self.figure
        if self.placed or figure is None:
            return
        self.placed = True
        if isinstance(figure, Still):
            if figure.reason:
                yield f'<p class="unmoved">This figure does not move: {escape(figure.reason)}.</p>'
            return
        from lagrange.render.moving import moving_lines

        yield from moving_lines(figure, self.place, self.notation, alt)

    # Words

    def paragraphs(self, run: Sequence[Prose]) -> Iterator[str]:
        return (f"<p>{self.prose(block.parts)}</p>" for block in run)

    def prose(self, parts: Iterable[Part]) -> str:
        """Words and formulas; punctuation stays on the line of the formula before it."""
        code = ""
        for part in parts:
            # A browser may break a line between </math> and a comma, so the last formula and the comma share a box.
            if isinstance(part, str) and (closing := CLOSING.match(part)):
                if code.endswith("</math>"):
                    start = code.rindex("<math")
                    code = f'{code[:start]}<span class="together">{code[start:]}{escape(closing[0])}</span>'
                    part = part[closing.end() :]
                elif code.endswith("</math></span>"):
                    code = f"{code.removesuffix('</span>')}{escape(closing[0])}</span>"
                    part = part[closing.end() :]
            written = self.part(part)
            if code.endswith(OPENING) and written.startswith("<math"):
                first, end, rest = written.partition("</math>")
                code, written = code[:-1], f'<span class="together">{code[-1]}{first}{end}</span>{rest}'
            code += written
        return code

    def part(self, part: Part) -> str:
        match self.content.resolved(part):
            case Math(sides=sides, relation=relation):
                return self.formulas.equation(sides, relation)
            case Ref(label=label):
                return f'<a href="#{self.id(label)}">({self.content.numbers[label]})</a>'
            case Emphasis(word=word):
                return f"<em>{escape(word)}</em>"
            case str(text):
                return escape(text)

    def id(self, label: str) -> str:
        return f"{self.prefix}-{re.sub(r'[^A-Za-z0-9-]+', '-', label)}"

    # Equations

    def display(self, block: Display) -> Iterator[str]:
        equations = block.equations
        aligned = len(equations) > 1 and all(len(e.sides) > 1 and self.formulas.is_short(e.sides[0]) for e in equations)
        kinds = [
            "display",
            *["aligned"] * aligned,
            *["result"] * block.boxed,
            *["long"] * (len(equations) > LONG_DISPLAY),
        ]
        yield f'<div class="{" ".join(kinds)}">'
        for e in equations:
            if aligned:
                yield f'<div class="left">{self.formulas.left(e.sides[0])}</div>'
            body = self.formulas.equation(e.sides, e.relation, displayed=True, first=int(aligned)) + self.condition(e)
            spoken = self.formulas.text(e.sides, e.relation)
            yield f'<div class="equation" role="math" aria-label="{spoken}">{body}</div>'
            yield f'<div class="number"{self.anchor(e)}>{self.content.number(e)}</div>'
        yield "</div>"

    def condition(self, equation: Equation) -> str:
        if not equation.condition:
            return ""
        parts = [self.content.resolved(part) for part in equation.condition]
        shown = (
            self.formulas.equation(p.sides, p.relation, displayed=True) if isinstance(p, Math) else self.prose((p,))
            for p in parts
        )
        return f' <span class="condition">{"".join(shown)}</span>'

    def anchor(self, equation: Equation) -> str:
        return f' id="{self.id(equation.label)}"' if equation.label else ""

    # Pictures, matrices, tables and checks

    def picture(self, block: Picture) -> Iterator[str]:
        scene = block.draw()
        replaced = self.moving_figure is not None and not self.placed
        if replaced and scene is not None and _shows_more(scene, self.moving_figure):
            replaced = False
        elif replaced:
            yield from self.moving(block.alt)
        if scene is not None:
            yield '<figure class="still">' if replaced else "<figure>"
            yield from figure(scene, printable(block.alt), self.in_pictures.plain)
            yield f"<figcaption>{self.prose(block.caption)}</figcaption>"
            yield "</figure>"
        yield from self.moving(block.alt)

    def task(self, block: Task) -> Iterator[str]:
        yield '<div class="task">'
        yield f"<p>{self.prose(block.parts)}</p>"
        # Lines, because the policy of the page forbids heights that are written into elements.
        yield f"<div aria-hidden='true'>{'<br>' * (block.lines + 1)}</div>"
        yield "</div>"

    def matrices(self, block: Matrices) -> Iterator[str]:
        """Those that fit on a line side by side, the others entry by entry."""
        codes = [self.formulas.matrix(name, rows) for name, rows in block.named]
        if any(codes):
            yield '<div class="scroll">' + " ".join(filter(None, codes)) + "</div>"
        for code, (name, rows) in zip(codes, block.named, strict=True):
            if code is None:
                yield from block_lines(entry_by_entry(name, rows), self)

    def table(self, block: Table) -> Iterator[str]:
        header = [self.part(part) for part in block.header]
        yield '<div class="scroll" tabindex="0"><table>'
        yield "<thead><tr>" + "".join(f'<th scope="col">{h}</th>' for h in header) + "</tr></thead>"
        yield "<tbody>"
        for row in block.rows:
            first, *others = (self.part(part) for part in row)
            cells = "".join(f"<td>{c}</td>" for c in others)
            yield f'<tr><th scope="row">{first}</th>{cells}</tr>'
        yield "</tbody></table></div>"

    def checks(self, run: Sequence[CheckMark]) -> Iterator[str]:
        yield '<ul class="checks">'
        for check in run:
            sign, kind, outcome = MARKS[check.passed]
            how = f' <span class="how">{escape(check.how)}</span>' if check.how else ""
            mark = f'<span class="mark {kind}" aria-hidden="true">{sign}</span><span class="unseen">{outcome}: </span>'
            yield f"<li>{mark}{self.prose(check.name)}{how}</li>"
        yield "</ul>"


_SOLID = frozenset({"capsule", "cone", "disc", "face", "oval", "round", "sphere", "surface", "tool"})
"""Elements of a moving figure that are bodies or surfaces."""
_LINKS = frozenset({"capsule", "line", "string"})
"""Those that are rods or strings."""


def _shows_more(scene: Scene, moving: MovingFigure | None) -> bool:
    """Whether a drawing has bodies, surfaces, rods or strings that the moving figure has not: both are shown then."""
    elements = [item["k"] for item in moving.data["items"]] if moving is not None else []
    drawn = [line.kind for line in scene.lines]
    links = sum(kind in (StrokeKind.ROD, StrokeKind.STRING) for kind in drawn)
    solids = StrokeKind.BODY in drawn or StrokeKind.FACE in drawn
    return links > sum(e in _LINKS for e in elements) or (solids and not _SOLID & {*elements})


# In a notebook


NAME = ".lagsolve"
NO_TEX = "tex2jax_ignore mathjax_ignore"
"""Classes that keep MathJax, which notebooks run over their outputs, from reading a file's dollars as TeX."""
_PAGE = {":root", "html", "body", "main"}
_DARK = ('[data-jp-theme-light="false"]', '[data-vscode-theme-kind*="dark"]')
_OWN = f"""
{NAME} {{ color-scheme: inherit; color: inherit; background: none; font: inherit; line-height: 1.5; max-width: 46rem;
  margin: 0; padding: 0 .2rem .2rem; --ink: currentColor; --line: color-mix(in srgb, currentColor 25%, transparent);
  --paper: var(--jp-layout-color0, var(--vscode-editor-background, Canvas));
  --box: color-mix(in srgb, currentColor 4%, transparent);
  --quiet: color-mix(in srgb, currentColor 70%, transparent); }}
{NAME} h1 {{ font-size: 1.4em; }}
{NAME} h2 {{ font-size: 1.1em; }}
{NAME} table {{ font-size: 1em; }}
{", ".join(f"{theme} {NAME}" for theme in _DARK)} {{ --accent: #e0a48f; --good: #86c79a; --bad: #f2a59d; }}
""".strip()


def cell(derivation: Derivation, notation: Notation, detail: Detail = Detail.STEPS) -> str:
    """A derivation as the output of a cell."""
    body = fragment(derivation, notation, detail)
    return f'<div class="{NAME[1:]} {NO_TEX}">\n<style>\n{style_sheet()}\n</style>\n{body}</div>\n'


@cache
def style_sheet() -> str:
    """The style sheet of web pages, confined to the output of a cell."""
    return f"{re.sub(r'([^{}]+){', _confined, CSS)}\n{_OWN}"


def _confined(match: re.Match[str]) -> str:
    """The beginning of a rule, with selectors that match only inside of the output; `@media` stays."""
    before, selectors = re.fullmatch(r"(\s*)(.*?)\s*", match[1], re.DOTALL).groups()  # type: ignore[union-attr]
    if selectors.startswith("@"):
        return match[0]
    inside = (NAME if s.strip() in _PAGE else f"{NAME} {s.strip()}" for s in selectors.split(","))
    return f"{before}{', '.join(inside)} {{"
