r"""Equations between column vectors in LaTeX, `\begin{pmatrix} ... \end{pmatrix}`, as one equation for each row.

A side is a sum of columns, each with a sign and a factor before it, or a matrix times a column:

    \begin{pmatrix} a & b \\ c & d \end{pmatrix} \begin{pmatrix} x \\ y \end{pmatrix}
        = \begin{pmatrix} p \\ q \end{pmatrix}

is (a)(x) + (b)(y) = (p) and (c)(x) + (d)(y) = (q).

Matrices may have names, `M \ddot q + h = \tau` with `M = \begin{pmatrix} ...`; a bold letter that is not defined, whose
second derivative occurs, is the column of the coordinates.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence

_MATRIX = re.compile(
    r"\\begin\s*\{(?P<kind>[pbvBV]?matrix|smallmatrix)\}(?P<inside>.*?)\\end\s*\{(?P=kind)\}", re.DOTALL
)
_ROW = re.compile(r"\\\\\*?(?:\[[0-9a-z. ]{1,20}\])?")
_EQUALS = re.compile(r"&?\s*=\s*&?")
_SPACE = re.compile(r"\\(?:cdot|,|;|:|!|left\s*[(\[.]|right\s*[)\].]|quad)|[~\s]")
_BOLD = r"\\(?:mathbf|boldsymbol|bm|pmb|vec|underline|mathsf|mathbb)"
_NAME = r"(?:\\[A-Za-z]+|[A-Za-z])(?:_\{?[A-Za-z0-9]{1,4}\}?)?"
_DEFINITION = re.compile(
    rf"[\s$&]*(?:{_BOLD}\s*\{{?\s*)?(?P<name>{_NAME})\s*\}}?\s*(?:\([^()=]{{0,30}}\))?\s*:?=\s*"
    r"(?P<value>(?:[^=\\{}&$]|\\[dt]?frac\s*\{[^{}]{0,20}\}\s*\{[^{}]{0,20}\}|\\(?!begin)[A-Za-z]+){0,40}"
    r"\\begin\s*\{(?P<kind>[pbvBV]?matrix)\}(?:(?!\\end).)*\\end\s*\{(?P=kind)\})[\s$.,;]*\Z",
    re.DOTALL,
)
_DERIVED = re.compile(
    rf"\\(?P<dots>d{{1,2}})ot\s*(?:\{{\s*(?:(?P<bold>{_BOLD})\s*\{{?\s*)?(?P<name>{_NAME})\s*\}}?\s*\}}|(?:(?P<bold2>{_BOLD})\s*\{{?\s*)?(?P<name2>{_NAME})\}}?)"
)
_MOST = 6
"""Rows of a column."""

Matrix = list[list[str]]


def with_named_matrices(texts: Sequence[str], sets: Sequence[Sequence[str]]) -> list[str | None]:
    """Equations between named matrices with these written out; None for a definition of one of them.

    sets  the coordinates, in each set
    """
    defined = {m["name"]: m["value"] for text in texts if has_matrix(text) and (m := _DEFINITION.match(text))}
    if not defined:
        return [*texts]
    size = max(len(_rows(value)) for value in defined.values())
    columns = {name: [r[0] for r in rows] for name, v in defined.items() if (rows := _rows(v)) and len(rows[0]) == 1}
    fitting = [[in_latex(q) for q in s] for s in [*sets[1:], *sets[:1]] if len(s) == size]
    made: list[str | None] = []
    used = False
    for text in texts:
        if _DEFINITION.match(text):
            made.append(None)
        elif any(
            m["bold"] or m["bold2"] or (m["name"] or m["name2"]) in (*columns, "q") for m in _DERIVED.finditer(text)
        ):
            made.append(_written_out(text, defined, columns, fitting[0] if fitting else []))
            used = True
        else:
            made.append(text)
    return made if used else [*texts]


def in_latex(name: str) -> str:
    """A coordinate in LaTeX: x1 as x_{1}."""
    stem, digits = re.fullmatch(r"(.*?)_?([0-9]*)", name).groups()  # type: ignore[union-attr]
    letter = f"\\{stem}" if len(stem) > 1 and "_" not in stem else stem
    return f"{letter}_{{{digits}}}" if digits else letter


def _rows(value: str) -> Matrix:
    match = _MATRIX.search(value)
    return [r.split("&") for r in _ROW.split(match["inside"]) if r.strip()] if match else []


def _written_out(text: str, defined: Mapping[str, str], columns: Mapping[str, list[str]], own: Sequence[str]) -> str:
    def column(entries: Iterable[str]) -> str:
        return r"\begin{pmatrix}" + r"\\".join(entries) + r"\end{pmatrix}"

    def derived(match: re.Match[str]) -> str:
        name = match["name"] or match["name2"]
        entries = columns.get(name) or own
        return column(rf"\{match['dots']}ot{{{e.strip()}}}" for e in entries) if entries else match[0]

    text = re.sub(r"\([^()=]{0,10}\\dot[^()=]{0,20}\)|\((?:\\mathbf\s*\{?)?q\}?\)", "", text)
    text = _DERIVED.sub(derived, text)
    for name, value in defined.items():
        escaped = re.escape(name)
        bold_name = rf"{_BOLD}\s*(?:\{{\s*{escaped}\s*\}}|{escaped})"
        token = rf"(?:{bold_name}|(?<![A-Za-z\\{{_]){escaped})(?![A-Za-z_])"
        text = _outside(text, token, value)
    bold = [n for n in re.findall(rf"{_BOLD}\s*\{{?\s*({_NAME})\s*\}}?", _MATRIX.sub("", text)) if n not in defined]
    if bold and own and len({*bold}) == 1:
        text = re.sub(rf"{_BOLD}\s*\{{?\s*{re.escape(bold[0])}\s*\}}?", lambda _: column(own), text)
    return text


def _outside(text: str, token: str, value: str) -> str:
    """Replace a name outside matrices."""
    pieces, at = [], 0
    for match in _MATRIX.finditer(text):
        pieces += [re.sub(token, lambda _: value, text[at : match.start()]), match[0]]
        at = match.end()
    return "".join([*pieces, re.sub(token, lambda _: value, text[at:])])


def has_matrix(text: str) -> bool:
    """Whether there is a matrix in a text."""
    return "matrix}" in text


def rows_of_matrices(text: str) -> list[str]:
    """The equations of the rows; none where the text is no equation between columns."""
    matrices = list(_MATRIX.finditer(text))
    blank = _MATRIX.sub(lambda m: "\x00" * len(m[0]), text)
    signs = list(_EQUALS.finditer(blank))
    if len(signs) != 1 or not matrices:
        return []
    left = _side(text, 0, signs[0].start(), matrices)
    right = _side(text, signs[0].end(), len(text), matrices)
    number = max(len(left or ()), len(right or ()))
    if left is None or right is None or not 0 < number <= _MOST:
        return []
    left, right = (side or ["0"] * number for side in (left, right))
    return [f"{a} = {b}" for a, b in zip(left, right, strict=True)] if len(left) == len(right) else []


def _side(text: str, start: int, end: int, matrices: list[re.Match[str]]) -> list[str] | None:
    """The rows of one side; empty if it is 0, and None if it cannot be understood."""
    inside = [m for m in matrices if start <= m.start() < end]
    if not inside:
        return [] if re.sub(r"[\\{}\s$.,;]|vec|mathbf|mathbb", "", text[start:end]) == "0" else None
    terms: list[tuple[str, list[Matrix]]] = []
    at = start
    for m in inside:
        before = _SPACE.sub(" ", text[at : m.start()]).strip(" $&")
        matrix = [[c.strip() or "0" for c in row.split("&")] for row in _ROW.split(m["inside"]) if row.strip()]
        if before or not terms:
            terms.append((before, [matrix]))
        else:
            terms[-1][1].append(matrix)
        at = m.end()
    if _SPACE.sub("", text[at:end]).strip("$&.,;"):
        return None
    columns = [_column(factor, product) for factor, product in terms]
    if any(c is None for c in columns):
        return None
    known = [c for c in columns if c is not None]
    if len({len(c) for c in known}) != 1:
        return None
    return [" ".join(parts) for parts in zip(*known, strict=True)]


def _column(factor: str, product: list[Matrix]) -> list[str] | None:
    sign = "-" if factor.startswith("-") else "+"
    factor = factor.lstrip("+- ")
    *first, column = product
    if len(first) > 1 or any(len(row) != 1 for row in column) or re.search(r"[+\-=]", factor):
        return None
    scaled = f"({factor})" if factor else ""
    if not first:
        return [f"{sign} {scaled}({row[0]})" for row in column]
    if any(len(row) != len(column) for row in first[0]):
        return None
    return [
        f"{sign} {scaled}(" + " + ".join(f"({a})({b[0]})" for a, b in zip(row, column, strict=True)) + ")"
        for row in first[0]
    ]
