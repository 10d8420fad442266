r"""Equations between column vectors in LaTeX, `\begin{pmatrix} ... \end{pmatrix}`, as one equation for each row.

A side is a sum of columns, each with a sign and a factor before it, or a matrix times a column:

    \begin{pmatrix} a & b \\ c & d \end{pmatrix} \begin{pmatrix} x \\ y \end{pmatrix}
        = \begin{pmatrix} p \\ q \end{pmatrix}

is (a)(x) + (b)(y) = (p) and (c)(x) + (d)(y) = (q).

Matrices may have names, `M \ddot q + h = \tau` with `M = \begin{pmatrix} ...`; a bold letter that is not defined, whose
second derivative occurs, is the column of the coordinates.

In plain text a matrix is a list of rows, `[[a, b], [c, d]]`, `{{a, b}, {c, d}}`, `[a, b; c, d]`,
`Matrix([[a, b], [c, d]])` or Word's `(■(a&b@c&d))`, and a list of several entries is a column. Between a matrix and a
column there may be `*`, `·`, `@` or `.`. These may have names, too.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence

from lagrange.answers.limits import MOST_MATRIX_ROWS
from lagrange.core.records import record
from lagrange.expressions.edits import closings, cuts

_MATRIX = re.compile(
    r"\\begin\s*\{(?P<kind>[pbvBV]?matrix|smallmatrix)\}(?P<inside>.*?)\\end\s*\{(?P=kind)\}", re.DOTALL
)
_BRACKETED_ARRAY = re.compile(
    r"\\left\s*[\[(]\s*\\begin\s*\{array\}\s*\{[lcr|\s]{1,12}\}(?P<inside>(?:(?!\\(?:begin|end)\s*\{array\}).)*)"
    r"\\end\s*\{array\}\s*\\right\s*[\])]",
    re.DOTALL,
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

_WRAPPER = re.compile(
    r"(?:(?:sp|sympy|sym|np|numpy)\.)?(?:[Mm]atrix|[Aa]rray|[Vv]ector|asarray|asmatrix|transpose)\s*\(\s*\Z"
)
_AFTER = re.compile(r"\s*(?:\^\s*\{?\s*[T⊤]\s*\}?|\.T(?![A-Za-z])|ᵀ)")
_OF_WORD = re.compile(r"\s*■\s*")
_BETWEEN = "*·⋅∙@ "
_CELLS_OF_MATLAB = re.compile(r"(?<![-+*/^(\s])\s+(?![-+*/^)\s](?:\s|\Z)|[*/^)])")

WrittenMatrix = list[list[str]]


@record
class _Written:
    """A matrix in a text: where it begins and ends, and its entries."""

    start: int
    end: int
    rows: WrittenMatrix


def with_bracketed_arrays(text: str) -> str:
    r"""`\left[\begin{array}{cc} ... \end{array}\right]`, as handwriting is recognised, as a matrix as long."""

    def matrix(match: re.Match[str]) -> str:
        before, after = match.start("inside") - match.start(), match.end() - match.end("inside")
        return r"\begin{bmatrix}".ljust(before) + match["inside"] + r"\end{bmatrix}".ljust(after)

    return _BRACKETED_ARRAY.sub(matrix, text) if "{array}" in text else text


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


def _rows(value: str) -> WrittenMatrix:
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
    """The equations of the rows; none if the text is no equation between columns."""
    return _equations(
        text,
        [
            _Written(
                m.start(),
                m.end(),
                [[c.strip() or "0" for c in row.split("&")] for row in _ROW.split(m["inside"]) if row.strip()],
            )
            for m in _MATRIX.finditer(text)
        ],
    )


def rows_of_lists(text: str) -> list[str]:
    """The equations of the rows of lists in plain text; none if the text is no equation between columns."""
    if not any(sign in text for sign in ("[", "{", "■")) or text.count("=") != 1 + text.count("=="):
        return []
    matrices = _lists(text.replace("==", "= "))
    return _equations(text.replace("==", "= "), matrices) if len(matrices) > 1 or _is_zero_after(text) else []


_SOLVED = re.compile(
    r"\s*(?:(?P<list>[\[{][^=]{1,200}[\]}])|(?P<name>[A-Za-z]\w{0,12}))\s*=\s*(?P<matrix>[A-Za-z]\w{0,12})\s*\\\s*(?P<column>[A-Za-z]\w{0,12})[\s;.]*\Z"
)
_NAMED_ACCELERATION = re.compile(r"\w{0,6}dd\w{0,4}|acc\w{0,10}|a|[A-Za-z]pp|D2\w{1,3}", re.IGNORECASE)


def _multiplied(text: str, values: Mapping[str, str]) -> str:
    r"""`qdd = A\b` of MATLAB, where both have values, as A*[...] = b; the accelerations are those of the state."""
    match = _SOLVED.match(text)
    if match is None or not {match["matrix"], match["column"]} <= values.keys():
        return text
    if (unknown := match["list"]) is None:
        if not _NAMED_ACCELERATION.fullmatch(match["name"]):
            return text
        size = len(_lists(values[match["column"]])[0].rows)
        unknown = f"[{'; '.join(f'state_{n}{chr(39) * 2}' for n in range(1, size + 1))}]"
    return f"{match['matrix']}*{unknown} = {match['column']}"


_NAMED = re.compile(r"\s*(?P<name>[A-Za-z]\w{0,12})\s*(?:\([^()=]{0,20}\))?\s*:?=(?!=)\s*(?P<value>[^=]+?)[\s;.]*\Z")


def rows_with_names(texts: Sequence[str]) -> list[list[str] | None]:
    """The rows of each equation between lists of which some have names, none for their definitions; None: unchanged."""
    values: dict[str, str] = {}
    for text in texts:
        match = _NAMED.match(text) if "[" in text or "{" in text else None
        lists = _lists(match["value"]) if match else []
        if match and len(lists) == 1 and (lists[0].start, lists[0].end) == (0, len(match["value"])):
            values[match["name"]] = match["value"]
    unchanged: list[list[str] | None] = [None] * len(texts)
    if not values or len(values) > MOST_MATRIX_ROWS:
        return unchanged
    token = re.compile(
        rf"(?<![A-Za-z0-9_'.])(?:{'|'.join(map(re.escape, values))})(?![A-Za-z0-9_'])(?:\([^()=]{{0,20}}\))?"
    )
    made: list[list[str] | None] = []
    for written in texts:
        text = _multiplied(written, values)
        match = _NAMED.match(text)
        if match and match["name"] in values and match["value"] == values[match["name"]]:
            made.append([])
        else:
            rows = (
                rows_of_lists(token.sub(lambda m: values[re.split(r"\(", m[0])[0]], text)) if token.search(text) else []
            )
            made.append(rows or None)
    return made if any(made) else unchanged


def _is_zero_after(text: str) -> bool:
    return text.rpartition("=")[2].strip(" .;,") == "0"


def _lists(text: str) -> list[_Written]:
    """The outermost lists of several entries."""
    lists: list[_Written] = []
    ends = closings(text)
    at = 0
    for start in sorted(ends):
        if start < at:
            continue
        word = _OF_WORD.match(text, start + 1) if text[start] in "([" else None
        if text[start] == "(" and word is None:
            continue
        before = text[:start].rstrip()[-1:]
        wrapper = _WRAPPER.search(text, max(0, start - 30), start)
        if wrapper is None and word is None and (before.isalnum() or before in ("_", "'")):
            continue  # theta[t]
        inside = text[start + 1 : ends[start]]
        rows = _rows_of_word(inside) if word else _rows_of_list(inside)
        if rows is None or (len(rows) < 2 and not lists):
            continue
        end = ends[start] + 1
        if wrapper is not None:
            close = re.compile(r"\s*\)").match(text, end)
            end, start = (close.end() if close else end), wrapper.start()
        if transposed := _AFTER.match(text, end):
            end = transposed.end()
        lists.append(_Written(start, end, rows))
        at = end
    return lists


def _rows_of_word(inside: str) -> WrittenMatrix | None:
    """The rows of Word's `■(a&b@c&d)`."""
    opening = inside.index("(") if "(" in inside else -1
    end = closings(inside).get(opening)
    if end is None or inside[end + 1 :].strip():
        return None
    rows = [
        [row[c:d].strip() for c, d in cuts(row, re.compile("&"))]
        for row in (
            inside[opening + 1 + a : opening + 1 + b] for a, b in cuts(inside[opening + 1 : end], re.compile("@"))
        )
    ]
    return rows if all(all(row) for row in rows) else None


def _rows_of_list(inside: str) -> WrittenMatrix | None:
    """The rows of `[a, b], [c, d]`, of `a, b; c, d` and of a column `a, b` or `a; b`; None if it is no list."""
    ends = closings(inside)
    pieces = [inside[a:b].strip() for a, b in cuts(inside, re.compile("[,;]"))]
    if not all(pieces):
        return None
    if all(p[0] in "[{" and closings(p).get(0) == len(p) - 1 for p in pieces):
        return [[p[1:-1][a:b].strip() for a, b in cuts(p[1:-1], re.compile(","))] for p in pieces]
    if any(p[0] in "[{" for p in pieces):
        return None
    by_rows = [inside[a:b].strip() for a, b in cuts(inside, re.compile(";"))]
    if len(by_rows) == 1 and len(pieces) > 1:
        return [[p] for p in pieces]
    if len(by_rows) == 1:
        cells = _cells(inside) if ends or not re.search(r"\s[-+*/]", inside) else [inside]
        return [[c] for c in cells] if len(cells) > 1 else None
    rows = [[r[a:b].strip() for a, b in cuts(r, re.compile(","))] for r in by_rows]
    if all(len(row) == 1 for row in rows):
        spaced = [_cells(row[0]) for row in rows]
        rows = spaced if len({len(row) for row in spaced}) == 1 and len(spaced[0]) == len(spaced) else rows
    return rows if all(all(row) for row in rows) else None


def _cells(row: str) -> list[str]:
    """The entries of a row of MATLAB, which spaces separate."""
    return [row[a:b].strip() for a, b in cuts(row.strip(), _CELLS_OF_MATLAB)]


def _equations(text: str, matrices: Sequence[_Written]) -> list[str]:
    """The equations of the rows of an equation between matrices."""
    blank = text
    for m in reversed(matrices):
        blank = f"{blank[: m.start]}{chr(0) * (m.end - m.start)}{blank[m.end :]}"
    signs = list(_EQUALS.finditer(blank))
    if len(signs) != 1 or not matrices:
        return []
    left = _side(text, 0, signs[0].start(), matrices)
    right = _side(text, signs[0].end(), len(text), matrices)
    number = max(len(left or ()), len(right or ()))
    if left is None or right is None or not 0 < number <= MOST_MATRIX_ROWS:
        return []
    left, right = (side or ["0"] * number for side in (left, right))
    return [f"{a} = {b}" for a, b in zip(left, right, strict=True)] if len(left) == len(right) else []


def _side(text: str, start: int, end: int, matrices: Sequence[_Written]) -> list[str] | None:
    """The rows of one side; empty if it is 0, and None if it cannot be understood."""
    inside = [m for m in matrices if start <= m.start < end]
    if not inside:
        return [] if re.sub(r"[\\{}\s$.,;]|vec|mathbf|mathbb", "", text[start:end]) == "0" else None
    terms: list[tuple[str, list[WrittenMatrix]]] = []
    at = start
    for m in inside:
        before = _SPACE.sub(" ", text[at : m.start]).strip(" $&")
        joint = before.strip(_BETWEEN) if "\\" not in text else before
        if (joint not in ("", ".")) or not terms:
            terms.append((before.rstrip(_BETWEEN), [m.rows]))
        else:
            terms[-1][1].append(m.rows)
        at = m.end
    if _SPACE.sub("", text[at:end]).strip("$&.,;"):
        return None
    columns = [_column(factor, product) for factor, product in terms]
    if any(c is None for c in columns):
        return None
    known = [c for c in columns if c is not None]
    if len({len(c) for c in known}) != 1:
        return None
    return [" ".join(parts).removeprefix("+ ") for parts in zip(*known, strict=True)]


def _column(factor: str, product: list[WrittenMatrix]) -> list[str] | None:
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
    sums = [" + ".join(f"({a})({b[0]})" for a, b in zip(row, column, strict=True)) for row in first[0]]
    return [f"{sign} {scaled}({e})" if scaled or sign == "-" else f"{sign} {e}" for e in sums]
