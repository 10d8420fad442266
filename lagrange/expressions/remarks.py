"""What is said of a text while it gets its meaning: errors and notes, each at the place of a tree."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from lagrange.core.diagnostics import Diagnostic, Fragment, Level, ProblemError
from lagrange.expressions.constants import RefusedError
from lagrange.expressions.lexicon import OPERATIONS
from lagrange.expressions.scope import Scope
from lagrange.expressions.spelling import help_for_function, help_for_symbol
from lagrange.expressions.trees import Call, Name, Tree


class Remarks:
    """What is said of one text. `notes` says where a reading could surprise."""

    def __init__(self, fragment: Fragment, scope: Scope) -> None:
        self.fragment = fragment
        self.scope = scope
        self.notes: list[Diagnostic] = []

    def undeclared(self, tree: Name | Call) -> Diagnostic:
        """The finding that nothing has this name."""
        if isinstance(tree, Call):
            name, end = tree.name, tree.name_end
            code, message = (
                "unknown-function",
                f"`{_short(name)}` is neither a function nor a declared symbol",
            )
            help_ = help_for_function(name, self.scope)
        else:
            name, end = tree.text, tree.end
            code, message = "unknown-symbol", f"`{_short(name)}` is not declared"
            if name in OPERATIONS:
                code, message = "no-argument", f"`{name}` has no argument"
            help_ = help_for_symbol(name, self.scope)
        return Diagnostic(code, message, self.fragment.span(tree.start, end), help=help_)

    def mistake(self, code: str, message: str, tree: Tree, help_: str) -> ProblemError:
        """An error at the place of a tree."""
        return ProblemError(Diagnostic(code, message, self.fragment.span(tree.start, tree.end), help=help_))

    @contextmanager
    def blaming(self, tree: Tree) -> Iterator[None]:
        """What is refused inside is an error at the place of a tree."""
        try:
            yield
        except RefusedError as refused:
            text = _short(" ".join(self.fragment.text[tree.start : tree.end].split()))
            raise self.mistake(refused.code, refused.message.format(text), tree, refused.help.format(text)) from None

    def note(self, message: str, tree: Tree, help_: str) -> None:
        """Says once how something was read."""
        if message not in (n.message for n in self.notes):
            span = self.fragment.span(tree.start, tree.end)
            self.notes.append(Diagnostic("read-as", message, span, help=help_, level=Level.NOTE))


def _short(text: str) -> str:
    return text if len(text) <= 40 else text[:37] + "..."
