"""The file of a variant: the text of the problem with the drawn values in it, and without `vary`.

The rest of the text is unchanged: comments, order, answers. Each value becomes the
`value` of its parameter, wherever that is declared: in a list of names (which becomes a mapping), as `m: positive`,
or in full. A comment at the top names the seed and the values. The result is read again before it is handed out: it
has to be the same problem with these values.
"""

from __future__ import annotations

import re
from collections.abc import Mapping

from lagrange.core.diagnostics import Diagnostic, ProblemError, Source
from lagrange.core.printable import one_line
from lagrange.core.records import record
from lagrange.problem.declarations import states_value
from lagrange.problem.diagnostic_collector import Diagnostics
from lagrange.problem.limits import LONGEST_SEED
from lagrange.problem.load_context import canonical
from lagrange.problem.loader import read_problem
from lagrange.problem.model import Problem
from lagrange.problem.variants.drawing import values_drawn
from lagrange.problem.yaml.composer import parse
from lagrange.problem.yaml.nodes import ListNode, MappingNode, Node, Scalar


@record
class _Edit:
    """Characters `start` to `end` of the text, and their replacement."""

    start: int
    end: int
    text: str


def variant_source(source: Source, seed: str) -> Source:
    """The problem file of the variant that a seed draws, under the name of the original.

    Raises ProblemError if the file has mistakes or no `vary`, where the seed is empty or too long, and where the
    values cannot be written into the file.
    """
    problem = read_problem(source)
    if not problem.vary:
        help_ = "say what varies, as `vary: {l: {from: 0.2 m, to: 1 m, step: 0.1 m}}`"
        raise ProblemError(Diagnostic("nothing-varies", f"the problem “{problem.title}” has no `vary`", help=help_))
    if not seed.strip() or len(seed) > LONGEST_SEED:
        message = f"a seed is a text of 1 to {LONGEST_SEED} characters"
        raise ProblemError(Diagnostic("bad-seed", message, help="take the name or the number of a student"))
    values = values_drawn(problem.vary, seed)
    root = parse(source, Diagnostics())
    text = source.text
    for edit in sorted(_edits(root, text, values), key=lambda e: e.start, reverse=True):
        text = text[: edit.start] + edit.text + text[edit.end :]
    variant = Source(source.name, _heading(seed, values) + text)
    _check(variant, problem, values)
    return variant


def _heading(seed: str, values: Mapping[str, str]) -> str:
    listed = ", ".join(f"{name} = {value}" for name, value in values.items())
    return f"# The variant of the seed {one_line(seed.strip())}: {one_line(listed)}\n"


def _edits(root: MappingNode, text: str, values: Mapping[str, str]) -> list[_Edit]:
    sections = {key.text: (key, value) for key, value in root.entries}
    key, node = sections["vary"]
    edits = [_removal(key, node, text)]
    declared = sections["parameters"][1]
    if isinstance(declared, ListNode):
        return [*edits, _as_mapping(declared, text, values)]
    assert isinstance(declared, MappingNode)  # otherwise it declares nothing, and nothing could vary
    for name, value in declared.entries:
        drawn = values.get(canonical(name.text, {n: n for n in values}))
        if drawn is not None:
            edits.append(_with_value(name, value, text, drawn))
    return edits


def _removal(key: Scalar, node: Node, text: str) -> _Edit:
    """Takes `vary` out, with its lines if nothing else is on them, and with its comma in a mapping in braces."""
    start, end = key.span.start, _end(node, text)
    begin = text.rfind("\n", 0, start) + 1
    line_end = text.find("\n", end)
    line_end = len(text) if line_end < 0 else line_end
    if not text[begin:start].strip():
        rest = text[end:line_end]
        behind = end + len(rest) - len(rest.lstrip())
        return _Edit(begin, behind if rest.strip() else min(line_end + 1, len(text)), "")
    comma = re.compile(r"\s*,").match(text, end)
    if comma:
        return _Edit(start, comma.end(), "")
    before = re.search(r",\s*$", text[:start])
    return _Edit(before.start() if before else start, end, "")


def _end(node: Node, text: str) -> int:
    """Where a value ends; YAML lets one without brackets go on to the next key, over the comments before it."""
    inside = (
        node.items
        if isinstance(node, ListNode)
        else [v for _, v in node.entries]
        if isinstance(node, MappingNode)
        else ()
    )
    return node.span.end if not inside or text[node.span.start] in "{[" else _end(inside[-1], text)


def _as_mapping(declared: ListNode, text: str, values: Mapping[str, str]) -> _Edit:
    """A list of names as a mapping in braces."""
    known = {name: name for name in values}
    entries = []
    for item in declared.items:
        assert isinstance(item, Scalar)  # anything else is a mistake of the file
        drawn = values.get(canonical(item.text, known))
        entries.append(f"{item.text}: {'positive' if drawn is None else f'{{value: {_scalar(drawn)}}}'}")
    written = f"{{{', '.join(entries)}}}"
    start, end = declared.span.start, _end(declared, text)
    if not text.startswith("[", start):  # a list with dashes, one a line: the mapping needs an indentation
        written = f"  {written}"
        start = text.rfind("\n", 0, start) + 1
    return _Edit(start, end, written)


def _with_value(name: Scalar, node: Node, text: str, drawn: str) -> _Edit:
    """The declaration of a parameter, with a value."""
    value = f"value: {_scalar(drawn)}"
    if isinstance(node, MappingNode):
        given = next((v for k, v in node.entries if k.text == "value"), None)
        if given is not None:
            return _Edit(given.span.start, given.span.end, _scalar(drawn))
        at = node.entries[0][0].span.start
        if text.startswith("{", node.span.start):
            return _Edit(at, at, f"{value}, ")
        indentation = " " * (at - text.rfind("\n", 0, at) - 1)
        return _Edit(at, at, f"{value}\n{indentation}")
    assert isinstance(node, Scalar)
    if states_value(node.text):
        return _Edit(node.span.start, node.span.end, f"{{{value}}}")
    if node.is_empty:
        colon = text.index(":", name.span.end) + 1
        return _Edit(colon, colon, f" {{{value}}}")
    return _Edit(node.span.start, node.span.end, f"{{assume: {node.text}, {value}}}")


def _scalar(value: str) -> str:
    """A value as YAML; in quotes where its signs mean something there."""
    plain = re.fullmatch(r"[\w.+*/^()° -]+", value) and not value.startswith(("*", "-", " "))
    return value if plain else '"{}"'.format(value.replace("\\", "\\\\").replace('"', '\\"'))


def _check(variant: Source, problem: Problem, values: Mapping[str, str]) -> None:
    """Raises ProblemError if the written file is not the problem with these values."""
    again = read_problem(variant)
    before = {p.symbol.name: p.value for p in problem.parameters}
    after = {p.symbol.name: p.value for p in again.parameters}
    same = {n: v for n, v in after.items() if n not in values} == {n: v for n, v in before.items() if n not in values}
    if not same or any(after.get(n) is None for n in values) or again.vary or again.title != problem.title:
        message = f"the values of a variant cannot be written into {variant.name}"
        help_ = "declare each parameter on a line of its own: `l: {unit: m, meaning: length}`"
        raise ProblemError(Diagnostic("variant-not-written", message, help=help_))
