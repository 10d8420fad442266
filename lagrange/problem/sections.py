"""Reading the parts of a problem file: keys that are known, values of the right kind.

A `Section` is a mapping of the file with the keys that it may have. A key that is none is reported with the nearest
one that is, and its value is taken for that one's, so that the same mistake is not reported a second time as a missing
key or as names that are not declared; nothing is said of the value itself, which may be meant otherwise.
"""

from __future__ import annotations

from lagrange.core.diagnostics import Diagnostic, ProblemError, Span, nearest, suggestion
from lagrange.problem.findings import Findings
from lagrange.problem.nodes import Mapping, Node, Scalar
from lagrange.problem.nodes import Sequence as ListNode


class Section:
    """A mapping whose keys are known.

    what     what the mapping is, for messages: "the particle `P`"
    keys     the keys that it may have
    strange  the values of other keys that were not taken for one of them
    """

    def __init__(self, node: Mapping, what: str, keys: tuple[str, ...], findings: Findings) -> None:
        self.node = node
        self.what = what
        self.findings = findings
        self.strange: list[Node] = []
        self._values = {key.text: (key, value) for key, value in node.entries if key.text in keys}
        for key, value in node.entries:
            if key.text not in keys:
                self._unknown(key, value, keys)

    def _unknown(self, key: Scalar, value: Node, keys: tuple[str, ...]) -> None:
        message = f"`{key.text}` is not a key of {self.what}"
        help_ = suggestion(key.text, keys, "keys")
        self.findings.report(Diagnostic("unknown-key", message, key.span, help=help_))
        self.findings.mute(value.span)
        meant = nearest(key.text, keys)
        if meant is None or meant in self._values:
            self.strange.append(value)
        else:
            self._values[meant] = (key, value)

    def get(self, key: str) -> Node | None:
        """The value of a key; None where it is absent. A key without a value is reported, and counts as absent."""
        found = self._values.get(key)
        if found is None:
            return None
        name, value = found
        if isinstance(value, Scalar) and value.is_empty:
            help_ = f"write `{key}: ...`, or remove the key"
            self.findings.report(Diagnostic("empty-value", f"`{key}` has no value", name.span, help=help_))
            return None
        return value

    def section(self, key: str) -> Node | None:
        """The value of a key that may be left empty, as a section whose entries are all commented out is."""
        found = self._values.get(key)
        if found is None or (isinstance(found[1], Scalar) and found[1].is_empty):
            return None
        return found[1]

    def required(self, key: str, span: Span, example: str) -> Node:
        """The value of a key that must be there; `span` is what to blame where it is not."""
        value = self.get(key)
        if value is not None:
            return value
        if key in self._values:
            raise ProblemError(())  # it has no value, and that has been said
        message = f"{self.what} has no `{key}`"
        raise ProblemError(Diagnostic("missing-key", message, span, help=f"add `{key}: {example}`"))

    def has(self, key: str) -> bool:
        """Whether the key is there."""
        return key in self._values

    def span_of(self, key: str) -> Span:
        """Where a key stands."""
        return self._values[key][0].span

    def text(self, key: str) -> str:
        """A value that is text, on one line; empty where the key is absent."""
        value = self.section(key)
        if value is None:
            return ""
        scalar = self.findings.attempt(lambda: scalar_of(value, f"`{key}`"))
        return " ".join(scalar.text.split()) if scalar else ""


def scalar_of(node: Node, what: str) -> Scalar:
    """The node as one value. Raises ProblemError where it is none."""
    if isinstance(node, Scalar):
        if node.is_empty:
            raise ProblemError(Diagnostic("empty-value", f"{what} is empty", node.span, help="write its value"))
        return node
    raise ProblemError(wrong_kind(node, f"{what} is one value", "write one value"))


def items_of(node: Node, what: str, example: str) -> tuple[Node, ...]:
    """The node as a list. Raises ProblemError where it is none."""
    if isinstance(node, ListNode):
        return node.items
    raise ProblemError(wrong_kind(node, f"{what} is a list", f"write `{example}`"))


def entries_of(node: Node, what: str, example: str) -> tuple[tuple[Scalar, Node], ...]:
    """The node as a mapping of names. Raises ProblemError where it is none."""
    return mapping_of(node, what, example).entries


def mapping_of(node: Node, what: str, example: str) -> Mapping:
    """The node as a mapping. Raises ProblemError where it is none."""
    if isinstance(node, Mapping):
        return node
    raise ProblemError(wrong_kind(node, f"{what} is a mapping", f"write `{example}`"))


def wrong_kind(node: Node, message: str, help: str) -> Diagnostic:
    """The diagnostic for a list where a value belongs, and the like."""
    match node:
        case Scalar():
            label = "this is one value"
        case ListNode():
            label = "this is a list"
        case _:
            label = "this is a mapping"
    return Diagnostic("wrong-kind", message, node.span, label, help)
