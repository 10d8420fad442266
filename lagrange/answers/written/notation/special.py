r"""Notations of names and functions that are rare in equations of motion but common in values.

m1, θ1                              m_1, theta_1, where these are declared and the others are not
∛(c/b)                              (c/b)^(1/3)
arcosh(x), acosh(x), \cosh^{-1} x   log(x + sqrt(x^2 - 1)), and so for the other inverse hyperbolic functions
v_\infty, v_{\max}                  v_{inf}, v_{max}
ω_+ = ..., \omega_- = ...           ω_plus = ..., \omega_{minus} = ...
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace

from lagrange.answers.limits import LONGEST_REPEATED
from lagrange.core.diagnostics import Fragment
from lagrange.expressions.characters import GREEK
from lagrange.expressions.edits import Draft, Edit, closings
from lagrange.expressions.latex_layout import OneEquation, is_latex
from lagrange.expressions.scope import Scope
from lagrange.expressions.syntax_tree import Role

_INDEX = re.compile(
    rf"(?:(?<![A-Za-z0-9_])(?P<name>[A-Za-z]+)|(?P<greek>[{''.join(GREEK)}]))(?P<index>[0-9]{{1,2}})(?![A-Za-z0-9_.])"
)
_CUBE_ROOT = re.compile(r"∛\s*(?:(?=\()|(?P<simple>[0-9]+|[^\W\d_]))")
_INVERSE = re.compile(
    r"(?<![A-Za-z\\])(?:ar?c?(?P<name>sinh|cosh|tanh)|(?P<power>sinh|cosh|tanh)\s*\^\s*[({]?\s*[-−]\s*1\s*[)}]?)\s*(?=\()"
)
_INVERSE_LATEX = re.compile(
    r"\\(?:operatorname\*?\s*\{\s*ar?c?(?P<named>sinh|cosh|tanh)\s*\}|(?:mathrm|text|rm)\s*\{\s*ar?c?(?P<upright>sinh|cosh|tanh)\s*\}"
    r"|ar?c?(?P<name>sinh|cosh|tanh)(?![A-Za-z])|(?P<power>sinh|cosh|tanh)\s*\^\s*\{\s*-\s*1\s*\})\s*(?:\\left|\\[bB]igg?l?)?\s*(?=\()"
)
_COMMAND_AS_INDEX = re.compile(
    r"_\s*(?:\\(?P<plain>infty|max|min|star)(?![A-Za-z])|\{\s*\\(?P<braced>infty|max|min|star)\s*\})"
)
_SIGN_AS_INDEX = re.compile(
    r"_(?:\{\s*)?(?P<sign>[+−-]|\\pm(?![A-Za-z])|±)(?:\s*\})?(?=\s*(?:\^\s*\{?2\}?|²)?\s*&?(?:=|\Z))"
)
_HALF_AS_INDEX = re.compile(r"_(?:1/2|½|\{\s*(?:1/2|½|\\[dt]?frac\s*\{?1\}?\s*\{?2\}?)\s*\})(?=\s*&?=)")
_BARE_INDEX = re.compile(r"_(max|min|tot|end|top|side|crit|res|eff)(?![A-Za-z])")
"""An index of several letters without its braces, which TeX would not print as it is meant."""
_WRITTEN_OUT = {
    "sinh": "log(({x}) + sqrt(({x})^2 + 1))",
    "cosh": "log(({x}) + sqrt(({x})^2 - 1))",
    "tanh": "(log((1 + ({x}))/(1 - ({x})))/2)",
}


def signs_as_indices(draft: Draft) -> None:
    """Name what has a sign, or a half, as its index, on the left of an equation."""
    latex = "\\" in draft.text
    draft.replace(_HALF_AS_INDEX, "_{half}" if latex else "_half")
    draft.replace(
        _SIGN_AS_INDEX,
        lambda m: ("_{%s}" if latex else "_%s") % {"+": "plus", "-": "minus", "−": "minus"}.get(m["sign"], "pm"),
    )


def special(draft: Draft, scope: Scope) -> None:
    """Rewrite the notations of plain text."""
    draft.replace(_CUBE_ROOT, lambda m: f"({m['simple']})^(1/3) " if m["simple"] else None)
    draft.apply(_cube_roots(draft.text))
    draft.apply(_inverses(draft.text, _INVERSE, _WRITTEN_OUT))
    draft.replace(_INDEX, lambda m: _with_index(m, scope))


def with_indices(fragment: Fragment, scope: Scope) -> Fragment:
    """`x1 = ...` as x_1 = ..., so that it is no definition of another name."""
    if is_latex(fragment) or not _INDEX.search(fragment.text):
        return fragment
    draft = Draft(fragment)
    draft.replace(_INDEX, lambda m: _with_index(m, scope))
    made = draft.finished()
    return replace(made, beside=getattr(fragment, "beside", "")) if isinstance(made, OneEquation) else made


def special_latex(draft: Draft) -> None:
    """Rewrite the notations of LaTeX."""
    draft.replace(_COMMAND_AS_INDEX, lambda m: f"_{{{(m['plain'] or m['braced'])[:3]}}}")
    draft.replace(_BARE_INDEX, r"_{\1}")
    in_latex = {n: e.replace("log", r"\ln").replace("sqrt((", r"\sqrt{((") for n, e in _WRITTEN_OUT.items()}
    in_latex = {n: e.replace("^2 + 1))", "^2 + 1})").replace("^2 - 1))", "^2 - 1})") for n, e in in_latex.items()}
    draft.apply(_inverses(draft.text, _INVERSE_LATEX, in_latex))


def _with_index(match: re.Match[str], scope: Scope) -> str | None:
    """`m1` as m_1."""
    name = match["name"] or GREEK[match["greek"]]
    made = f"{name}_{match['index']}"
    known = scope.role(f"{name}{match['index']}") is not Role.UNDECLARED
    return None if known or scope.role(made) is Role.UNDECLARED else f" {made}"


def _cube_roots(text: str) -> Iterator[Edit]:
    ends: dict[int, int] | None = None
    for match in _CUBE_ROOT.finditer(text):
        ends = closings(text) if ends is None else ends
        if (end := ends.get(match.end())) is not None:
            yield match.start(), match.end(), ""
            yield end + 1, end + 1, "^(1/3)"


def _inverses(text: str, pattern: re.Pattern[str], forms: dict[str, str]) -> Iterator[Edit]:
    """Inverse hyperbolic functions by logarithms."""
    ends: dict[int, int] | None = None
    for match in pattern.finditer(text):
        ends = closings(text) if ends is None else ends
        end = ends.get(match.end())
        if end is not None and end - match.end() < LONGEST_REPEATED:
            name = next(filter(None, match.groups()))
            inside = re.sub(r"\\right\s*\Z", "", text[match.end() + 1 : end])
            yield match.start(), end + 1, forms[name].replace("{x}", inside)
