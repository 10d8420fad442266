"""YAML text -> the mapping that a problem file is, as nodes with places; with the traps of YAML closed, within limits.

Duplicate keys, tags, merged mappings and documents after the first are mistakes; so are a list that YAML has split at a
comma inside parentheses, and a colon without the space after it, which makes one key of key and value. They are
reported and repaired, so that reading goes on. Depth, aliases and the number of values are limited while the text is
read: no file can exhaust memory. Nodes are built from the events of YAML, because an alias must be counted, and a split
list joined again, before anything is built on it.

Where a text is not YAML, the library reports where it gave up and what it expected; the mistake is often earlier: a
quote that is not closed, a colon without a space. `yaml_mistake` finds its place and explains it to those who do not
know YAML. The two implementations of the library (C and Python) word their messages differently; both are understood.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator

import yaml

from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError, Source, Span
from lagrange.core.records import record
from lagrange.problem.diagnostic_collector import Diagnostics
from lagrange.problem.limits import MAX_ALIASES, MAX_BYTES, MAX_DEPTH, MAX_NODES, MOST_REJOINED
from lagrange.problem.sources import too_large
from lagrange.problem.yaml.nodes import ListNode, MappingNode, Node, Scalar, ScalarText

_UNREADABLE = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x9f\u2028\u2029\ud800-\udfff\ufeff\ufffe\uffff]")
_QUOTES_HELP = "put the whole value in quotes"
_TAB = ("a tab is used where spaces belong", "indent with spaces, never with tabs")


def unreadable_character(source: Source) -> Diagnostic | None:
    """The first character that plain text does not have: YAML would refuse it, or begin a line that no editor shows."""
    unreadable = _UNREADABLE.search(source.text)
    if unreadable is None:
        return None
    code = ord(unreadable[0])
    span = Span(source, unreadable.start(), unreadable.end())
    binary = "this is not plain text but a binary file, or it is UTF-16; save it as UTF-8"
    help_ = "delete it" if code else binary
    message = f"the character U+{code:04X} is not allowed in a problem file"
    return Diagnostic("control-character", message, span, help=help_)


def yaml_mistake(source: Source, error: yaml.YAMLError) -> Diagnostic:
    """The diagnostic for a text that the YAML library refuses."""
    if not isinstance(error, yaml.MarkedYAMLError):
        return Diagnostic("not-yaml", "this is not YAML", Span(source, 0, 1), help=_QUOTES_HELP)
    problem = str(error.problem or error.context or "")
    marks = [m.index if m else None for m in (error.problem_mark, error.context_mark)]
    at = next((m for m in marks if m is not None), 0)
    place = _Place(source.text, at, marks[1] if marks[1] is not None else at, f"{error.context or ''}; {problem}")
    for sign, explain in _EXPLANATIONS:
        if re.search(sign, place.explanation):
            mistake = explain(place)
            break
    else:
        mistake = _Mistake(at, f"this is not YAML: {problem}", _QUOTES_HELP)
    help_ = _no_break_space(source, mistake.at) or mistake.help
    start = min(mistake.at, max(len(source.text.rstrip()) - 1, 0))
    return Diagnostic("not-yaml", mistake.message, Span(source, start, start + max(1, mistake.length)), help=help_)


@record
class _Place:
    """Where the library gave up, where the part that it was reading had begun, and its explanation."""

    text: str
    at: int
    began: int
    explanation: str

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
        return _Mistake(p.at, f"`{p.char}` cannot close the `{opening}`", f"write `{closing}`")
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
        glued = re.compile(r"[ ]*([A-Za-z_]\w*):(?=[^\s:/])").match(p.text, line_start)
        if glued and glued.end() <= p.at:
            return _Mistake(glued.end() - 1, "missing space after this `:`", f"write `{glued[1]}: ...`")
    return None


def _no_colon(p: _Place) -> _Mistake:
    line = p.text[p.began :].split("\n", 1)[0]
    glued = re.match(r"([A-Za-z_]\w*):(?=\S)", line)
    if glued:
        return _Mistake(p.began + glued.end() - 1, "missing space after this `:`", f"write `{glued[1]}: ...`")
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
        return _after_bracket(p, before)
    if re.search(r"[:,\[{-] *\*[^\s,]*$", before):
        return _Mistake(len(before) - len(before.split()[-1]), "a value cannot begin with `*`", _QUOTES_HELP)
    return _Mistake(p.at, "this line is indented differently from those it belongs to", "indent them equally")


def _after_bracket(p: _Place, before: str) -> _Mistake:
    """`[x]]`, and `[x, y] = ...`, which YAML takes for a list with something after it."""
    if p.char in "]}":
        return _Mistake(p.at, f"this `{p.char}` closes nothing", "remove it, or open it before")
    return _Mistake(p.at, f"the value ends at the `{before[-1]}` before this", _QUOTES_HELP)


def _outdented(p: _Place) -> _Mistake:
    return _Mistake(p.at, "this line does not belong to what is before it", "begin every section in the first column")


def _dash(p: _Place) -> _Mistake:
    return _Mistake(p.at, "a value cannot begin with `- `", f"{_QUOTES_HELP}, or write `-x` without the space")


def _reserved(p: _Place) -> _Mistake:
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
    ("block scalar", _reserved),
    ("scanning an (alias|anchor)", _reserved),
    ("a tag;|tag handle", _bad_tag),
    ("directive|incompatible YAML", _directive),
    ("document start", _outdented),
    ("node content", _no_content),
    ("expected key|block end|expected '-'", _no_key),
)


def _no_break_space(source: Source, at: int) -> str:
    """The help where this line, or the one before it, is indented or spaced by no-break spaces; otherwise empty."""
    number, _ = source.position(at)
    for n in (number, number - 1):
        if n >= 1 and re.search("(^ *|:)[\xa0\u2000-\u200a\u202f\u205f\u3000]", source.line(n)):
            return f"line {n} has a no-break space (U+00A0) or the like; replace it by an ordinary space"
    return ""


_Loader = getattr(yaml, "CSafeLoader", yaml.SafeLoader)


@record
class _Anchored:
    """A node that aliases may repeat, with the number of its parts and its depth."""

    node: Node
    parts: int
    depth: int


class Composer:
    """Builds nodes from the events of YAML, counting what it builds, aliased parts as often as they are repeated."""

    def __init__(self, source: Source, diagnostics: Diagnostics, end: int | None = None) -> None:
        """end    where the text is cut off; None: nowhere"""
        self.source = source
        self.diagnostics = diagnostics
        self.events: Iterator[yaml.Event] = yaml.parse(source.text[:end], Loader=_Loader)
        self.anchors: dict[str, _Anchored] = {}
        self.parts = 0
        self.aliases = 0
        self.deepest = 0

    def document(self) -> Node | None:
        """The first document; None if there is none."""
        root: Node | None = None
        for event in self.events:
            if isinstance(event, yaml.DocumentStartEvent) and root is not None:
                message = "a second document begins here; one file holds one problem"
                self._mistake("several-documents", message, event, "remove it, or put it in a file of its own")
                break
            if isinstance(event, yaml.NodeEvent):
                root = self._node(event, 1)
        return root

    def _node(self, event: yaml.Event, depth: int) -> Node:
        self._count(1, depth, event)
        if isinstance(event, yaml.AliasEvent):
            return self._alias(event, depth)
        assert isinstance(event, yaml.ScalarEvent | yaml.CollectionStartEvent)  # nothing else begins a node
        before, outer = self.parts, self.deepest
        self.deepest = depth
        if event.tag is not None:
            help_ = "write the value alone; put text that begins with `!` in quotes"
            tag = event.tag.replace("tag:yaml.org,2002:", "!!")
            self._mistake("tag", f"the YAML tag `{tag}` is not accepted", event, help_)
        match event:
            case yaml.SequenceStartEvent():
                node: Node = self._sequence(event, depth)
            case yaml.MappingStartEvent():
                node = self._mapping(event, depth)
            case yaml.ScalarEvent():
                node = self._scalar(event)
        if event.anchor is not None:
            self.anchors[event.anchor] = _Anchored(node, self.parts - before + 1, self.deepest - depth)
        self.deepest = max(outer, self.deepest)
        return node

    def _alias(self, event: yaml.AliasEvent, depth: int) -> Node:
        self.aliases += 1
        if self.aliases > MAX_ALIASES:
            help_ = "write the values out"
            self._stop("too-many-aliases", f"the file has more than {MAX_ALIASES} aliases (`*name`)", event, help_)
        anchored = self.anchors.get(str(event.anchor))
        if anchored is None:
            span = self._span(event)
            message = f"there is no anchor `&{event.anchor}` for the alias `*{event.anchor}` of YAML"
            help_ = "put a value that begins with `*` in quotes"
            self.diagnostics.report(Diagnostic("unknown-alias", message, span, help=help_))
            self.diagnostics.mute(span)
            return Scalar("", span, Fragment("", span), quoted=True)
        self._count(anchored.parts, depth + anchored.depth, event)
        return anchored.node

    def _count(self, parts: int, depth: int, event: yaml.Event) -> None:
        self.parts += parts
        self.deepest = max(self.deepest, depth)
        if depth > MAX_DEPTH:
            help_ = "a problem file has five levels at most; a bracket may be missing"
            self._stop("nested-too-deep", f"lists or mappings nest deeper than {MAX_DEPTH}", event, help_)
        if self.parts > MAX_NODES:
            help_ = "is this the file you meant? A problem is a page of text"
            self._stop("too-many-values", f"the file has more than {MAX_NODES:,} values", event, help_)

    def _sequence(self, event: yaml.SequenceStartEvent, depth: int) -> ListNode:
        items = []
        end: yaml.Event = event
        for end in self.events:
            if isinstance(end, yaml.SequenceEndEvent):
                break
            items.append(self._node(end, depth + 1))
        if event.flow_style:
            items = self._rejoined(items, 1)
        return ListNode(tuple(items), self._span(event, end))

    def _mapping(self, event: yaml.MappingStartEvent, depth: int) -> MappingNode:
        parts = []
        end: yaml.Event = event
        for end in self.events:
            if isinstance(end, yaml.MappingEndEvent):
                break
            parts.append(self._node(end, depth + 1))
        if event.flow_style:
            parts = self._rejoined(parts, 2)
        pairs = list(zip(parts[::2], parts[1::2], strict=True))
        return MappingNode(tuple(self._entries(pairs)), self._span(event, end))

    def _entries(self, pairs: list[tuple[Node, Node]]) -> Iterator[tuple[Scalar, Node]]:
        """The entries whose keys are valid, each key once."""
        seen: dict[str, Scalar] = {}
        for key, value in pairs:
            if not isinstance(key, Scalar) or key.is_empty:
                help_ = "write `name: value`, and put text with brackets in quotes"
                self.diagnostics.report(Diagnostic("key-not-a-name", "a key must be a name", key.span, help=help_))
            elif key.text == "<<" and not key.quoted:
                help_ = "write the keys out"
                self.diagnostics.report(
                    Diagnostic("merge-key", "`<<` does not merge mappings here", key.span, help=help_)
                )
            elif key.text in seen:
                line, _ = self.source.position(seen[key.text].span.start)
                message = f"duplicate key `{key.text}`"
                help_ = "keep one of the two"
                self.diagnostics.report(Diagnostic("duplicate-key", message, key.span, f"first on line {line}", help_))
            else:
                seen[key.text] = key
                yield self._spaced(key, value)

    def _spaced(self, key: Scalar, value: Node) -> tuple[Scalar, Node]:
        """`{x:1}`, which YAML reads as a key `x:1` without a value."""
        glued = re.fullmatch(r"([^\s:]+):(.+)", key.text)
        if glued is None or key.quoted or not (isinstance(value, Scalar) and value.is_empty):
            return key, value
        span, colon = key.span, key.span.start + len(glued[1])
        message = "missing space after this `:`"
        help_ = f"write `{glued[1]}: {glued[2]}`"
        self.diagnostics.report(Diagnostic("missing-space", message, Span(span.source, colon, colon + 1), help=help_))
        return self._plain(span.start, colon), self._plain(colon + 1, span.end)

    def _rejoined(self, parts: list[Node], step: int) -> list[Node]:
        """The parts of a list in brackets, where YAML has split one at a comma inside parentheses.

        step    1: the parts are items; 2: keys and values in turn, where a piece split off is a key without a value
        """
        joined: list[Node] = []
        at = 0
        while at < len(parts):
            is_value = step == 1 or len(joined) % 2 == 1
            last = _closing(parts, at, step) if is_value else at
            joined.append(parts[at] if last == at else self._joined(parts[at], parts[last]))
            at = last + (1 if last == at else step)
        return joined

    def _joined(self, first: Node, last: Node) -> Scalar:
        """The text from the beginning of one part to the end of another."""
        joined = self._plain(first.span.start, last.span.end)
        message = "YAML has split this at the comma inside the parentheses"
        help_ = f'put it in quotes: `"{joined.text}"`' if len(joined.text) <= 60 else "put it in quotes"
        self.diagnostics.report(Diagnostic("split-at-comma", message, joined.span, help=help_))
        return joined

    def _scalar(self, event: yaml.ScalarEvent) -> Scalar:
        text = self.source.text
        start, end = _place(event)
        marked = _PROPERTIES.match(text, start, end)
        start = marked.end() if marked else start
        end = start + len(text[start:end].rstrip())
        style: str = event.style or ""
        span = Span(self.source, start, end)
        if style == '"':
            self._refuse_latex(span)
        if not style and text[start:end] == event.value:
            fragment = Fragment(event.value, span, start)
        elif style in ("'", '"') and text[start + 1 : end - 1] == event.value:
            fragment = Fragment(event.value, span, start + 1)
        else:
            fragment = ScalarText(event.value, span, style=style)
        return Scalar(event.value, span, fragment, bool(style))

    def _refuse_latex(self, span: Span) -> None:
        """`"\\theta"` is a tab and `heta` in YAML: nobody means that."""
        raw = self.source.text[span.start : span.end]
        for escape in _ESCAPES.finditer(raw):
            if escape[1] is None:
                continue
            place = Span(self.source, span.start + escape.start(), span.start + escape.end())
            message = f"in double quotes, `{escape[0][:2]}` of `{escape[0]}` means a control character"
            self.diagnostics.report(Diagnostic("escaped-latex", message, place, help="put LaTeX in single quotes"))
            self.diagnostics.mute(span)
            return

    def _plain(self, start: int, end: int) -> Scalar:
        """A plain scalar, from its place in the text."""
        text = self.source.text[start:end]
        start += len(text) - len(text.lstrip())
        span = Span(self.source, start, end)
        value = " ".join(text.split())
        fragment = Fragment(value, span, start) if value == text.strip() else ScalarText(value, span)
        return Scalar(value, span, fragment, quoted=False)

    def _span(self, event: yaml.Event, last: yaml.Event | None = None) -> Span:
        start, end = _place(event)[0], _place(last or event)[1]
        return Span(self.source, start, start + max(1, len(self.source.text[start:end].rstrip())))

    def _mistake(self, code: str, message: str, event: yaml.Event, help_: str) -> None:
        self.diagnostics.report(Diagnostic(code, message, self._span(event), help=help_))

    def _stop(self, code: str, message: str, event: yaml.Event, help_: str) -> None:
        raise ProblemError(Diagnostic(code, message, self._span(event), help=help_))


_PROPERTIES = re.compile(r"(?:[&!]\S*(?:\s+|$))+")
"""An anchor and a tag before a scalar."""

_ESCAPES = re.compile(
    r"\\\\|\\(alpha|b(?:eta|egin|ar|ig[lr]?|oldsymbol|inom)|e(?:ta|psilon|quiv|nd)|f(?:rac|box)|n(?:u|abla|eq|onumber)"
    r"|r(?:ho|ight|m)|t(?:heta|au|imes|anh?|ext|frac)|v(?:ar[a-z]+|ec))(?![a-z])"
)
"""A backslash in double quotes: an escaped one, or one that begins a LaTeX command but is an escape to YAML."""


def _place(event: yaml.Event) -> tuple[int, int]:
    assert event.start_mark is not None
    assert event.end_mark is not None
    return event.start_mark.index, event.end_mark.index


def _closing(parts: list[Node], first: int, step: int) -> int:
    """The part in which the parentheses close that one opens; the same part where they do not."""
    opened = _opened(parts[first])
    if opened <= 0:
        return first
    for n in range(first + 1, min(first + MOST_REJOINED * step, len(parts) - step + 1), step):
        opened += _opened(parts[n])
        if opened <= 0:
            return n
    return first


def _opened(node: Node) -> int:
    """How many more parentheses are opened than closed in a scalar without quotes."""
    if not isinstance(node, Scalar) or node.quoted:
        return 0
    return node.text.count("(") - node.text.count(")")


def _first_document(source: Source, diagnostics: Diagnostics) -> Node | None:
    """The first document; None if there is none.

    Since libyaml 0.2.6 the C library has a limit of its own for nesting. As it looks ahead for the colon of a key, it
    can give up before the event that is too deep for a problem file: the text up to there is read to find that place.
    """
    try:
        return Composer(source, diagnostics).document()
    except yaml.MarkedYAMLError as error:
        if error.problem_mark is None or "maximum nesting" not in str(error.problem):
            raise
        return Composer(source, diagnostics, error.problem_mark.index).document()


_TEMPLATE = "a problem needs at least `title: ...` and `coordinates: [...]`"


def parse(
    source: Source, diagnostics: Diagnostics, what: str = "a problem file", needs: str = _TEMPLATE
) -> MappingNode:
    """The mapping that a file is; `needs` is the help where it is empty.

    Mistakes that leave the rest readable are collected. Raises ProblemError with the place where the text is not the
    YAML that is accepted here.
    """
    if len(source.text) > MAX_BYTES:
        raise ProblemError(too_large(source.name))
    if not source.text.strip():
        raise ProblemError(Diagnostic("empty-file", f"{source.name} is empty", help=needs))
    unreadable = unreadable_character(source)
    if unreadable:
        raise ProblemError(unreadable)
    try:
        root = _first_document(source, diagnostics)
    except yaml.YAMLError as error:
        raise ProblemError(yaml_mistake(source, error)) from None
    if root is None or (isinstance(root, Scalar) and root.is_empty):
        message = f"{source.name} contains nothing but comments"
        raise ProblemError(Diagnostic("empty-file", message, help=needs))
    if not isinstance(root, MappingNode):
        message = f"{what} is a mapping: lines `key: value`"
        help_ = "a colon needs a space after it" if isinstance(root, Scalar) and ":" in root.text else needs
        raise ProblemError(Diagnostic("not-a-mapping", message, root.span, help=help_))
    return root
