r"""Equations between column vectors in LaTeX, `\begin{pmatrix} ... \end{pmatrix}`, as one equation for each row.

A side is a sum of columns, each with a sign and a factor before it, or a matrix times a column:

    \begin{pmatrix} a & b \\ c & d \end{pmatrix} \begin{pmatrix} x \\ y \end{pmatrix}
        = \begin{pmatrix} p \\ q \end{pmatrix}

is (a)(x) + (b)(y) = (p) and (c)(x) + (d)(y) = (q).
"""

from __future__ import annotations

import re

_MATRIX = re.compile(
    r"\\begin\s*\{(?P<kind>[pbvBV]?matrix|smallmatrix)\}(?P<inside>.*?)\\end\s*\{(?P=kind)\}", re.DOTALL
)
_ROW = re.compile(r"\\\\\*?(?:\[[0-9a-z. ]{1,20}\])?")
_EQUALS = re.compile(r"&?\s*=\s*&?")
_SPACE = re.compile(r"\\(?:cdot|,|;|:|!|left\s*[(\[.]|right\s*[)\].]|quad)|[~\s]")
_MOST = 6
"""Rows of a column."""

Matrix = list[list[str]]


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
