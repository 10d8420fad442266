"""The text of a problem or an answer: bytes are decoded as UTF-8, line ends become `\\n`, and the size is limited."""

from __future__ import annotations

import errno
import os
import re
import stat
from collections.abc import Callable
from pathlib import Path

from lagrange.core.diagnostics import Diagnostic, ProblemError, Source
from lagrange.problem.limits import MAX_BYTES, READINGS


def read_source(path: Path) -> Source:
    """The text of a file. Raises ProblemError if it cannot be read.

    What is no regular file is refused: reading a pipe that has no writer would never end. Only what the caller of the
    program has opened for it is read whatever it is: `/dev/stdin`, and `/dev/fd/63`, which a shell makes of `<(...)`.
    """
    try:
        return decode(_opened_by_caller(path) or _content(path), str(path))
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


_DESCRIPTOR = re.compile(r"/dev/stdin|/dev/fd/[0-9]+|/proc/(?:self|[0-9]+)/fd/[0-9]+")
_KINDS: tuple[tuple[Callable[[int], bool], str], ...] = (
    (stat.S_ISFIFO, "it is a pipe; `-` reads standard input"),
    (stat.S_ISSOCK, "it is a socket"),
)


def _opened_by_caller(path: Path) -> bytes:
    """The bytes of a descriptor that is no regular file; none if the path is something else."""
    if not _DESCRIPTOR.fullmatch(os.fspath(path)) or stat.S_ISREG(os.stat(path).st_mode):
        return b""
    with path.open("rb") as file:
        return file.read(MAX_BYTES + 1)


def _content(path: Path) -> bytes:
    """The bytes of a regular file, as they were at one time. Raises OSError."""
    flags = os.O_RDONLY | sum(getattr(os, f, 0) for f in ("O_NONBLOCK", "O_NOCTTY", "O_CLOEXEC", "O_BINARY"))
    _refuse_special(os.stat(path))
    for _ in range(READINGS):
        with open(os.open(path, flags), "rb") as file:
            before = os.fstat(file.fileno())
            _refuse_special(before)
            data = file.read(MAX_BYTES + 1)
            after = os.fstat(file.fileno())
        if (before.st_mtime_ns, before.st_size) == (after.st_mtime_ns, after.st_size):
            return data
    raise OSError(errno.EAGAIN, "it changes while it is read")


def _refuse_special(status: os.stat_result) -> None:
    if stat.S_ISDIR(status.st_mode):
        raise IsADirectoryError
    if not stat.S_ISREG(status.st_mode):
        reasons = (reason for is_it, reason in _KINDS if is_it(status.st_mode))
        raise OSError(errno.EINVAL, next(reasons, "it is a device"))


def decode(data: bytes, name: str) -> Source:
    """The text that bytes are. Raises ProblemError if they are too many, or not UTF-8."""
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
