"""The events of YAML -> nodes, with its traps closed and its size limited.

Duplicate keys, tags, merged mappings and documents after the first are mistakes; so is a list that YAML has split at a
comma inside parentheses, and a colon without the space after it that makes a key out of key and value. These are
reported and mended, so that reading goes on. Depth, aliases and the number of values are limited while the text is
read: no file can exhaust memory.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

import yaml

from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError, Source, Span
from lagrange.core.records import record
from lagrange.problem.findings import Findings
from lagrange.problem.nodes import Mapping, Node, Scalar, Sequence
from lagrange.problem.yaml_text import ScalarText

MAX_DEPTH = 20
MAX_NODES = 20_000
MAX_ALIASES = 50

_Loader = getattr(yaml, "CSafeLoader", yaml.SafeLoader)


@record
class _Anchored:
    """A node that aliases may repeat, with the number of its parts and its depth."""

    node: Node
    parts: int
    depth: int


class Composer:
    """Builds nodes from the events of YAML, counting what it builds, aliased parts as often as they are repeated."""

    def __init__(self, source: Source, findings: Findings) -> None:
        self.source = source
        self.findings = findings
        self.events: Iterator[yaml.Event] = yaml.parse(source.text, Loader=_Loader)
        self.anchors: dict[str, _Anchored] = {}
        self.parts = 0
        self.aliases = 0
        self.deepest = 0

    def document(self) -> Node | None:
        """The first document; None where there is none."""
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
            help_ = "write the value alone; text that begins with `!` stands in quotes"
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
            message = f"nothing is marked `&{event.anchor}`, which `*{event.anchor}` repeats in YAML"
            help_ = "put a value that begins with `*` in quotes"
            self.findings.report(Diagnostic("unknown-alias", message, span, help=help_))
            self.findings.mute(span)
            return Scalar("", span, Fragment("", span), quoted=True)
        self._count(anchored.parts, depth + anchored.depth, event)
        return anchored.node

    def _count(self, parts: int, depth: int, event: yaml.Event) -> None:
        self.parts += parts
        self.deepest = max(self.deepest, depth)
        if depth > MAX_DEPTH:
            help_ = "a problem file has four levels at most; a bracket may be missing"
            self._stop("nested-too-deep", f"lists or mappings nest deeper than {MAX_DEPTH}", event, help_)
        if self.parts > MAX_NODES:
            help_ = "is this the file you meant? A problem is a page of text"
            self._stop("too-many-values", f"the file has more than {MAX_NODES:,} values", event, help_)

    def _sequence(self, event: yaml.SequenceStartEvent, depth: int) -> Sequence:
        items = []
        end: yaml.Event = event
        for end in self.events:
            if isinstance(end, yaml.SequenceEndEvent):
                break
            items.append(self._node(end, depth + 1))
        if event.flow_style:
            items = self._rejoined(items, 1)
        return Sequence(tuple(items), self._span(event, end))

    def _mapping(self, event: yaml.MappingStartEvent, depth: int) -> Mapping:
        parts = []
        end: yaml.Event = event
        for end in self.events:
            if isinstance(end, yaml.MappingEndEvent):
                break
            parts.append(self._node(end, depth + 1))
        if event.flow_style:
            parts = self._rejoined(parts, 2)
        pairs = list(zip(parts[::2], parts[1::2], strict=True))
        return Mapping(tuple(self._entries(pairs)), self._span(event, end))

    def _entries(self, pairs: list[tuple[Node, Node]]) -> Iterator[tuple[Scalar, Node]]:
        """The entries whose keys are good, each key once."""
        seen: dict[str, Scalar] = {}
        for key, value in pairs:
            if not isinstance(key, Scalar) or key.is_empty:
                help_ = "write `name: value`; text with brackets stands in quotes"
                self.findings.report(Diagnostic("key-not-a-name", "a key must be a name", key.span, help=help_))
            elif key.text == "<<" and not key.quoted:
                help_ = "write the keys out"
                self.findings.report(Diagnostic("merge-key", "`<<` does not merge mappings here", key.span, help=help_))
            elif key.text in seen:
                line, _ = self.source.position(seen[key.text].span.start)
                message = f"`{key.text}` stands here twice"
                help_ = "keep one of the two"
                self.findings.report(Diagnostic("duplicate-key", message, key.span, f"first on line {line}", help_))
            else:
                seen[key.text] = key
                yield self._spaced(key, value)

    def _spaced(self, key: Scalar, value: Node) -> tuple[Scalar, Node]:
        """`{x:1}`, which YAML reads as a key `x:1` without a value."""
        glued = re.fullmatch(r"([^\s:]+):(.+)", key.text)
        if glued is None or key.quoted or not (isinstance(value, Scalar) and value.is_empty):
            return key, value
        span, colon = key.span, key.span.start + len(glued[1])
        message = "a space is missing behind this `:`"
        help_ = f"write `{glued[1]}: {glued[2]}`"
        self.findings.report(Diagnostic("missing-space", message, Span(span.source, colon, colon + 1), help=help_))
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
            joined.append(parts[at] if last == at else self._whole(parts[at], parts[last]))
            at = last + (1 if last == at else step)
        return joined

    def _whole(self, first: Node, last: Node) -> Scalar:
        """What stands from the beginning of one part to the end of another."""
        whole = self._plain(first.span.start, last.span.end)
        message = "YAML has split this at the comma inside the parentheses"
        help_ = f'put it in quotes: `"{whole.text}"`' if len(whole.text) <= 60 else "put it in quotes"
        self.findings.report(Diagnostic("split-at-comma", message, whole.span, help=help_))
        return whole

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
        for found in _ESCAPES.finditer(raw):
            if found[1] is None:
                continue
            place = Span(self.source, span.start + found.start(), span.start + found.end())
            message = f"in double quotes, `{found[0][:2]}` of `{found[0]}` means a control character"
            self.findings.report(Diagnostic("escaped-latex", message, place, help="put LaTeX in single quotes"))
            self.findings.mute(span)
            return

    def _plain(self, start: int, end: int) -> Scalar:
        """A scalar as it stands in the text."""
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
        self.findings.report(Diagnostic(code, message, self._span(event), help=help_))

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
    for n in range(first + 1, min(first + 40 * step, len(parts) - step + 1), step):
        opened += _opened(parts[n])
        if opened <= 0:
            return n
    return first


def _opened(node: Node) -> int:
    """How many more parentheses are opened than closed in a scalar without quotes."""
    if not isinstance(node, Scalar) or node.quoted:
        return 0
    return node.text.count("(") - node.text.count(")")
