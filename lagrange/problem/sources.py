"""The text of a problem or an answer: bytes are decoded as UTF-8, line ends become `\\n`, and the size is limited."""

from __future__ import annotations

from pathlib import Path

from lagrange.core.diagnostics import Diagnostic, ProblemError, Source
from lagrange.problem.limits import MAX_BYTES


def read_source(path: Path) -> Source:
    """The text of a file. Raises ProblemError where it cannot be read."""
    try:
        with path.open("rb") as file:
            return decode(file.read(MAX_BYTES + 1), str(path))
    except FileNotFoundError:
        help_ = "check the name; `-` reads standard input"
        unread = Diagnostic("no-such-file", f"there is no file {path}", help=help_)
    except IsADirectoryError:
        unread = Diagnostic("is-a-folder", f"{path} is a folder", help="name a problem file in it")
    except (OSError, ValueError) as error:  # ValueError: a NUL in the name
        reason = getattr(error, "strerror", None) or str(error)
        help_ = "check the name, and that you may read it"
        unread = Diagnostic("unreadable-file", f"{path} cannot be read: {reason}", help=help_)
    raise ProblemError(unread)


def decode(data: bytes, name: str) -> Source:
    """The text that bytes are. Raises ProblemError where they are too many, or not UTF-8."""
    if len(data) > MAX_BYTES:
        raise ProblemError(too_large(name))
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        utf16 = data[:2] in (b"\xff\xfe", b"\xfe\xff")
        what = "it is UTF-16" if utf16 else f"byte {error.start + 1:,} belongs to no character"
        help_ = "save the file as UTF-8; a problem is a plain text file"
        raise ProblemError(Diagnostic("not-text", f"{name} is not UTF-8 text: {what}", help=help_)) from None
    return Source(name, text.replace("\r\n", "\n").replace("\r", "\n"))


def too_large(name: str) -> Diagnostic:
    """The diagnostic for a text that is larger than MAX_BYTES."""
    message = f"{name} is larger than {MAX_BYTES:,} bytes (1 MiB)"
    return Diagnostic("file-too-large", message, help="is this the file you meant? A problem is a page of text")
