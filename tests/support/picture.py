"""The picture in the README: what `lagsolve ex11-ideal-pendulum --choice angle` prints, on a terminal 96 columns wide.

`make picture` writes it anew, and `test_readme` compares it with what is printed today. Steps are left out, with a mark
where they were, and nothing else is: a line of the picture is a line of the output. rich draws it; what is changed in its
drawing is that no font is fetched from elsewhere, that letters with dots are one cell wide, and that the frame is plain.
"""

from __future__ import annotations

import html
import re
from collections.abc import Iterator
from io import StringIO

from rich.cells import cell_len
from rich.console import Console
from rich.terminal_theme import TerminalTheme
from rich.text import Text

from lagrange.explain.report import report
from lagrange.problem.loader import load
from lagrange.render import terminal
from tests.support.paths import ROOT

PICTURE = ROOT / "docs" / "pictures" / "ideal-pendulum.svg"
PROBLEM = ROOT / "problems" / "chapter6" / "ex11-ideal-pendulum.yaml"
CHOICE = "angle"
COMMAND = f"lagsolve {PROBLEM.stem} --choice {CHOICE}"
WIDTH = 96

SHOWN = {
    "The constraint": 2,
    "Classification": 4,
    "D'Alembert's principle": 9,
    "Equation of motion (choice angle)": 11,
    "Checks": 12,
}
"""The steps that are shown, and how many of their lines at most."""

LEFT_OUT = Text("     ⋯", "dim")

THEME = TerminalTheme(
    (0x20, 0x24, 0x2B),
    (0xDD, 0xE1, 0xE6),
    [(0x20, 0x24, 0x2B), (0xE0, 0x6C, 0x75), (0x7F, 0xC9, 0x7F)] + [(0xDD, 0xE1, 0xE6)] * 5,
    [],
)
FONTS = "ui-monospace, 'DejaVu Sans Mono', Menlo, Consolas, 'Liberation Mono', monospace"
CELL = 12.2
"""The width of a cell: 0.61 times the height of a letter, 20, as rich has it."""

DOTS = {"\u0307": 1, "\u0308": 2}
"""Characters that put dots above the one before them."""

FORMAT = """<svg viewBox="0 0 {width} {height}" xmlns="http://www.w3.org/2000/svg">
<style>
.{unique_id}-matrix {{ font-family: FONTS; font-size: {char_height}px; white-space: pre }}
{styles}
</style>
<rect width="100%" height="100%" rx="8" fill="BACKGROUND"/>
<g class="{unique_id}-matrix" transform="translate({terminal_x}, 25)">
{matrix}
</g>
</svg>
"""


def output() -> list[Text]:
    """The lines that the command prints."""
    found = report(load(PROBLEM), CHOICE, complete=False)
    return [Text.assemble(*line.runs) for line in terminal.printed_lines(found.derivation, found.notation, WIDTH)]


def pictured() -> Iterator[Text]:
    """The lines of the picture: the command, its heading, and the steps that are shown."""
    first, *others = _steps(output())
    yield Text.assemble(("$ ", "dim"), (COMMAND, "bold"))
    yield from first[1]
    gap = False
    for title, lines in others:
        most = SHOWN.get(title, 0)
        if most:
            yield LEFT_OUT if gap else Text()
            yield from lines[:most]
        gap = len(lines) > most
    if gap:
        yield LEFT_OUT


def _steps(lines: list[Text]) -> list[tuple[str, list[Text]]]:
    """The heading, and each step under its title, without the empty lines between them."""
    found: list[tuple[str, list[Text]]] = [("", [])]
    for line in lines:
        if title := re.match(r" \d+ +(\S.*)", line.plain):
            found.append((title[1], []))
        if line.plain:
            found[-1][1].append(line)
    return found


def drawn() -> str:
    """The picture, as SVG."""
    console = Console(file=StringIO(), width=WIDTH, record=True, force_terminal=True, color_system="truecolor")
    for line in pictured():
        console.print(line, soft_wrap=True, highlight=False)
    page = FORMAT.replace("FONTS", FONTS).replace("BACKGROUND", THEME.background_color.hex)
    svg = console.export_svg(title="", theme=THEME, code_format=page, unique_id="lagsolve")
    svg = re.sub(r"<text [^>]*>\s*</text>", "", svg).replace("</text><text", "</text>\n<text")
    svg = re.sub(r" clip-path=\"url\([^\"]*\)\"", "", svg)
    return re.sub(r"<text class=\"(\S*)\" x=\"(\S*)\" y=\"(\S*)\"[^>]*>([^<]*)</text>", _piece, svg)


def _piece(found: re.Match[str]) -> str:
    """A piece of text as wide as its cells, with the dots of Greek letters as circles: few fonts can place them."""
    style, x, y, content = found.groups()
    written, dots = "", []
    for c in html.unescape(content):
        if c in DOTS and "α" <= written[-1] <= "ω":
            middle, above = float(x) + (cell_len(written) - 0.5) * CELL, float(y) - 17.5
            centres = (middle,) if DOTS[c] == 1 else (middle - 2.7, middle + 2.7)
            circles = "".join(f'<circle cx="{m:g}" cy="{above:g}" r="1.4"/>' for m in centres)
            dots.append(f'\n<g class="{style}" data-y="{y}">{circles}</g>')
        else:
            written += c
    size = f'textLength="{cell_len(written) * CELL:g}" lengthAdjust="spacingAndGlyphs"'
    shown = html.escape(written, quote=False).replace("\xa0", "&#160;")
    return f'<text class="{style}" x="{x}" y="{y}" {size}>{shown}</text>{"".join(dots)}'


def text_of(svg: str) -> list[str]:
    """The lines of text in a picture, dots included."""
    rows: dict[float, str] = {}
    for x, y, content in re.findall(r"<text [^>]*?\bx=\"(\S*)\" y=\"(\S*)\"[^>]*>([^<]*)</text>", svg):
        before = rows.get(float(y), "")
        gap = round(float(x) / CELL) - cell_len(before)
        rows[float(y)] = before + " " * gap + html.unescape(content).replace("\xa0", " ")
    for y, circles in reversed(re.findall(r"<g [^>]*data-y=\"(\S*)\">(.*?)</g>", svg)):
        centres = [float(m) for m in re.findall(r"cx=\"(\S*)\"", circles)]
        row, [mark] = rows[float(y)], [c for c, n in DOTS.items() if n == len(centres)]
        cell = int(sum(centres) / len(centres) / CELL)
        [letter] = [n for n in range(len(row)) if row[n] not in DOTS and cell_len(row[:n]) == cell]
        rows[float(y)] = f"{row[: letter + 1]}{mark}{row[letter + 1 :]}"
    height = min(b - a for a, b in zip(sorted(rows), sorted(rows)[1:], strict=False))
    lines = {round((y - min(rows)) / height): row.rstrip() for y, row in rows.items()}
    return [lines.get(n, "") for n in range(max(lines) + 1)]


if __name__ == "__main__":
    PICTURE.write_text(drawn(), encoding="utf-8", newline="\n")
    print(f"wrote {PICTURE.relative_to(ROOT)}")
