"""What is wrong with a text that is not YAML, said for those who do not know YAML.

A YAML library says where it gave up and what it had expected; the mistake is often earlier: a quote that is not closed,
a colon without a space. `yaml_mistake` finds the place, says what stands there, and gives a way out. The library's two
implementations (C and Python) word their messages differently; both are understood.
"""

from __future__ import annotations

import re
from collections.abc import Callable

import yaml

from lagrange.core.diagnostics import Diagnostic, Source, Span
from lagrange.core.records import record

_UNREADABLE = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x9f\u2028\u2029\ud800-\udfff\ufeff\ufffe\uffff]")
_QUOTES_HELP = "put the whole value in quotes"
_TAB = ("a tab stands where spaces belong", "indent with spaces, never with tabs")


def unreadable_character(source: Source) -> Diagnostic | None:
    """The first character that no text has: YAML would refuse it, or begin a line there that no editor shows."""
    found = _UNREADABLE.search(source.text)
    if found is None:
        return None
    code = ord(found[0])
    span = Span(source, found.start(), found.end())
    binary = "this is no plain text but a binary file, or one in UTF-16; save it as UTF-8"
    help_ = "delete it" if code else binary
    message = f"the character U+{code:04X} cannot stand in a problem file"
    return Diagnostic("control-character", message, span, help=help_)


def yaml_mistake(source: Source, error: yaml.YAMLError) -> Diagnostic:
    """The diagnostic for what the YAML library has refused."""
    if not isinstance(error, yaml.MarkedYAMLError):
        return Diagnostic("not-yaml", "this is not YAML", Span(source, 0, 1), help=_QUOTES_HELP)
    problem = str(error.problem or error.context or "")
    marks = [m.index if m else None for m in (error.problem_mark, error.context_mark)]
    at = next((m for m in marks if m is not None), 0)
    place = _Place(source.text, at, marks[1] if marks[1] is not None else at, f"{error.context or ''}; {problem}")
    for sign, explain in _EXPLANATIONS:
        if re.search(sign, place.said):
            found = explain(place)
            break
    else:
        found = _Mistake(at, f"this is not YAML: {problem}", _QUOTES_HELP)
    help_ = _no_break_space(source, found.at) or found.help
    start = min(found.at, max(len(source.text.rstrip()) - 1, 0))
    return Diagnostic("not-yaml", found.message, Span(source, start, start + max(1, found.length)), help=help_)


@record
class _Place:
    """Where the library gave up, where what it was reading had begun, and what it said."""

    text: str
    at: int
    began: int
    said: str

    @property
    def char(self) -> str:
        return self.text[self.at : self.at + 1]

    @property
    def line_start(self) -> int:
        return self.text.rfind("\n", 0, self.at) + 1

    @property
    def before(self) -> str:
        """The line up to the place."""
        return self.text[self.line_start : self.at]


@record
class _Mistake:
    at: int
    message: str
    help: str
    length: int = 1


def _cannot_begin(p: _Place) -> _Mistake:
    if p.char == "\t":
        return _Mistake(p.at, *_TAB)
    shown = "a backtick" if p.char == "`" else f"`{p.char}`"
    return _Mistake(p.at, f"a value cannot begin with {shown}", _QUOTES_HELP)


def _tab(p: _Place) -> _Mistake:
    return _Mistake(p.at, *_TAB)


def _unclosed_quote(p: _Place) -> _Mistake:
    quote = p.text[p.began]
    help_ = f"close it with `{quote}`"
    if quote == "'":
        help_ += "; an apostrophe inside is written twice, so primes are easier in double quotes"
    return _Mistake(p.began, "this quote is not closed", help_)


def _bracket(p: _Place) -> _Mistake:
    opening = p.text[p.began]
    closing = {"[": "]", "{": "}"}.get(opening, "]")
    if not p.text[p.at :].strip():
        return _Mistake(p.began, f"this `{opening}` is not closed", f"add `{closing}`")
    if "\n" in p.text[p.began : p.at]:
        return _Mistake(p.began, f"this `{opening}` is not closed before the next line", f"add `{closing}`")
    if p.char in "]}":
        return _Mistake(p.at, f"`{p.char}` stands where `{closing}` must close the `{opening}`", f"write `{closing}`")
    if p.char == ":":
        return _Mistake(p.at, "a second `:` in one entry", "put a value that contains `: ` in quotes")
    help_ = f"a comma or `{closing}` is missing; put a value that contains brackets or quotes in quotes as a whole"
    return _Mistake(p.at, f"`{p.char}` cannot follow here", help_)


def _mapping_value(p: _Place) -> _Mistake:
    glued = _glued_key_before(p)
    if glued:
        return glued
    if re.search(r":\s", p.before):
        return _Mistake(p.at, "a second `: ` on this line", "put a value that contains `: ` in quotes")
    indent = len(p.before) - len(p.before.lstrip())
    message = "this line is read as part of the value before it"
    help_ = "give every key of a section the same indentation, and close quotes and brackets"
    return _Mistake(p.line_start + indent, message, help_, len(p.before) - indent)


def _glued_key_before(p: _Place) -> _Mistake | None:
    """`title:Foo` on the line before, or at the beginning of this one."""
    start = p.text.rfind("\n", 0, max(p.line_start - 1, 0)) + 1
    for line_start in (start, p.line_start):
        found = re.compile(r"[ ]*([A-Za-z_]\w*):(?=[^\s:/])").match(p.text, line_start)
        if found and found.end() <= p.at:
            return _Mistake(found.end() - 1, "a space is missing behind this `:`", f"write `{found[1]}: ...`")
    return None


def _no_colon(p: _Place) -> _Mistake:
    line = p.text[p.began :].split("\n", 1)[0]
    found = re.match(r"([A-Za-z_]\w*):(?=\S)", line)
    if found:
        return _Mistake(p.began + found.end() - 1, "a space is missing behind this `:`", f"write `{found[1]}: ...`")
    return _Mistake(p.began, "this line has no key", "write `key: value`", len(line.rstrip()))


def _no_key(p: _Place) -> _Mistake:
    before = p.text[: p.at].rstrip(" ")
    if before.endswith(("'", '"')):
        return _Mistake(
            p.at,
            f"the value ends at the {'quote' if before[-1] == chr(34) else 'apostrophe'} before this",
            f"{_QUOTES_HELP}: primes go into double quotes, \"theta'' = 0\"",
        )
    if before.endswith(("]", "}")) and p.text[p.line_start : p.at].strip():
        return _behind_bracket(p, before)
    if re.search(r"[:,\[{-] *\*[^\s,]*$", before):
        return _Mistake(len(before) - len(before.split()[-1]), "a value cannot begin with `*`", _QUOTES_HELP)
    return _Mistake(p.at, "this line is indented differently from those it belongs to", "indent them equally")


def _behind_bracket(p: _Place, before: str) -> _Mistake:
    """`[x]]`, and `[x, y] = ...`, which YAML takes for a list with something behind it."""
    if p.char in "]}":
        return _Mistake(p.at, f"this `{p.char}` closes nothing", "remove it, or open it before")
    return _Mistake(p.at, f"the value ends at the `{before[-1]}` before this", _QUOTES_HELP)


def _outdented(p: _Place) -> _Mistake:
    return _Mistake(p.at, "this line does not belong to what is before it", "begin every section in the first column")


def _dash(p: _Place) -> _Mistake:
    return _Mistake(p.at, "a value cannot begin with `- `", f"{_QUOTES_HELP}, or write `-x` without the space")


def _block_scalar(p: _Place) -> _Mistake:
    return _Mistake(p.began, f"a value cannot begin with `{p.text[p.began]}`", _QUOTES_HELP)


def _anchor(p: _Place) -> _Mistake:
    return _Mistake(p.began, f"a value cannot begin with `{p.text[p.began]}`", _QUOTES_HELP)


def _escape(p: _Place) -> _Mistake:
    at = p.at if p.char == "\\" else p.at - 1
    message = f"`{p.text[at : at + 2]}` has no meaning in double quotes"
    return _Mistake(at, message, "put text with a backslash in single quotes", 2)


def _no_content(p: _Place) -> _Mistake:
    return _Mistake(p.at, f"a value is missing before this `{p.char}`", "write the value, or put it in quotes")


def _bad_tag(p: _Place) -> _Mistake:
    return _Mistake(p.began, "a value cannot begin with `!`", _QUOTES_HELP)


def _directive(p: _Place) -> _Mistake:
    return _Mistake(p.line_start if p.char != "%" else p.at, "a line cannot begin with `%`", "remove this line")


_EXPLANATIONS: tuple[tuple[str, Callable[[_Place], _Mistake]], ...] = (
    ("tab character that violates", _tab),
    ("cannot start any token", _cannot_begin),
    ("quoted scalar.*(unexpected end|document (separator|indicator))", _unclosed_quote),
    ("quoted scalar.*escape|quoted scalar.*hexadecimal|quoted scalar.*Unicode", _escape),
    ("expected ',' or", _bracket),
    ("mapping values are not allowed", _mapping_value),
    ("could not find expected ':'", _no_colon),
    ("entries are not allowed", _dash),
    ("block scalar", _block_scalar),
    ("scanning an (alias|anchor)", _anchor),
    ("a tag;|tag handle", _bad_tag),
    ("directive|incompatible YAML", _directive),
    ("document start", _outdented),
    ("node content", _no_content),
    ("expected key|block end|expected '-'", _no_key),
)


def _no_break_space(source: Source, at: int) -> str:
    """What to do where the line, or the one before it, is indented or spaced by no-break spaces."""
    number, _ = source.position(at)
    for n in (number, number - 1):
        if n >= 1 and re.search("(^ *|:)[\xa0\u2000-\u200a\u202f\u205f\u3000]", source.line(n)):
            return f"line {n} has a no-break space (U+00A0) or the like; replace it by an ordinary space"
    return ""
