"""Derivations in the output of a notebook's cell: a piece of HTML that needs nothing else, without scripts.

The mathematics and the pictures are those of a web page. Its style sheet is confined to the output, takes letters and
colours from the notebook, and follows the notebook's theme where that says whether it is a dark one (JupyterLab and
VS Code mark it on the page's body).
"""

from __future__ import annotations

import re
from functools import cache

from lagrange.document.derivation import Derivation, Detail
from lagrange.document.math_writer import Notation
from lagrange.render import html

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
    body = html.fragment(derivation, notation, detail)
    return f'<div class="{NAME[1:]} {NO_TEX}">\n<style>\n{style_sheet()}\n</style>\n{body}</div>\n'


@cache
def style_sheet() -> str:
    """The style sheet of web pages, confined to the output of a cell."""
    return f"{re.sub(r'([^{}]+){', _confined, html.CSS)}\n{_OWN}"


def _confined(match: re.Match[str]) -> str:
    """The beginning of a rule, with selectors that match only inside of the output; `@media` stays."""
    before, selectors = re.fullmatch(r"(\s*)(.*?)\s*", match[1], re.DOTALL).groups()  # type: ignore[union-attr]
    if selectors.startswith("@"):
        return match[0]
    inside = (NAME if s.strip() in _PAGE else f"{NAME} {s.strip()}" for s in selectors.split(","))
    return f"{before}{', '.join(inside)} {{"
