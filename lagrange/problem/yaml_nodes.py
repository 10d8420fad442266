"""Bytes -> text -> the mapping that a problem file is, as nodes that know where they stand."""

from __future__ import annotations

import yaml

from lagrange.core.diagnostics import Diagnostic, ProblemError, Source
from lagrange.problem.findings import Findings
from lagrange.problem.nodes import Mapping, Scalar
from lagrange.problem.yaml_composer import Composer
from lagrange.problem.yaml_mistakes import unreadable_character, yaml_mistake

MAX_BYTES = 1 << 20

_TEMPLATE = "a problem needs at least `title: ...` and `coordinates: [...]`"


def decode(data: bytes, name: str) -> Source:
    """The text of a file.

    Raises ProblemError where it is too large, or no UTF-8 text.
    """
    if len(data) > MAX_BYTES:
        raise ProblemError(_too_large(name))
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        utf16 = data[:2] in (b"\xff\xfe", b"\xfe\xff")
        what = "it is UTF-16" if utf16 else f"byte {error.start + 1:,} belongs to no character"
        help_ = "save the file as UTF-8; a problem is a plain text file"
        raise ProblemError(Diagnostic("not-text", f"{name} is not UTF-8 text: {what}", help=help_)) from None
    return Source(name, text.replace("\r\n", "\n").replace("\r", "\n"))


def parse(source: Source, findings: Findings, what: str = "a problem file", needs: str = _TEMPLATE) -> Mapping:
    """The mapping that a file is; `needs` says what it has at least. Mistakes that leave the rest readable are noted.

    Raises ProblemError with the place where the text is not the YAML that is accepted here.
    """
    if len(source.text) > MAX_BYTES:
        raise ProblemError(_too_large(source.name))
    if not source.text.strip():
        raise ProblemError(Diagnostic("empty-file", f"{source.name} is empty", help=needs))
    unreadable = unreadable_character(source)
    if unreadable:
        raise ProblemError(unreadable)
    try:
        root = Composer(source, findings).document()
    except yaml.YAMLError as error:
        raise ProblemError(yaml_mistake(source, error)) from None
    if root is None or (isinstance(root, Scalar) and root.is_empty):
        message = f"{source.name} holds nothing but comments"
        raise ProblemError(Diagnostic("empty-file", message, help=needs))
    if not isinstance(root, Mapping):
        message = f"{what} is a mapping: lines `key: value`"
        help_ = "a colon needs a space after it" if isinstance(root, Scalar) and ":" in root.text else needs
        raise ProblemError(Diagnostic("not-a-mapping", message, root.span, help=help_))
    return root


def _too_large(name: str) -> Diagnostic:
    message = f"{name} is larger than {MAX_BYTES:,} bytes (1 MiB)"
    return Diagnostic("file-too-large", message, help="is this the file you meant? A problem is a page of text")
