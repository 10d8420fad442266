"""Writing files in one step: no reader finds half of one, and the old one stays if anything goes wrong.

The text goes into a draft in the same folder, which is renamed once it is complete; the permissions of an old file are
kept. Where no draft can be made next to it, because the folder is not writable or the file is a mount of its own, an
old file is overwritten in place, as its permissions allow. Anything that is not a regular file (a pipe, `/dev/stdout`)
is written to directly.
"""

from __future__ import annotations

import errno
import os
import secrets
import stat
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path

from lagrange.core.diagnostics import Diagnostic, ProblemError

_NO_DRAFT = (errno.EACCES, errno.EPERM, errno.EROFS)
_NO_RENAMING = (errno.EBUSY, errno.EXDEV)
_NEW = os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_BINARY", 0)


def write_file(path: Path, text: str | bytes, *, follow: bool = True) -> None:
    """Writes a text, or the bytes of a picture. Raises ProblemError if that is impossible.

    follow  whether the user named this very file, so that a link is followed and a pipe written to; in a folder that
            others may write to they are replaced
    """
    data = text if isinstance(text, bytes) else text.encode("utf-8", "replace")
    try:
        target = os.path.realpath(path) if follow else os.fspath(path)
        old = _status(target)
        if follow and _is_special(path):  # /dev/stdout is a link to a pipe without a name of its own
            _write_through(os.fspath(path), data)
        elif old is not None and stat.S_ISREG(old.st_mode) and not os.access(target, os.W_OK):
            raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))
        else:
            _replace(target, data, old)
    except (OSError, ValueError) as error:  # ValueError: a NUL in the name
        raise unwritable(str(path), error) from None


def write_figures(folder: Path, files: Mapping[str, str]) -> None:
    """Writes the figures of a page beside it. Raises ProblemError for a file that lagsolve did not write."""
    from lagrange.render.svg import MARK

    for name in files:
        if not _is_ours(folder / name, MARK):
            message = f"{folder / name} would be overwritten, and it is no figure that lagsolve has written"
            help_ = "give the page another name with -o, or move that file: the figures are called after the page"
            raise ProblemError(Diagnostic("cannot-write", message, help=help_))
    for name, text in files.items():
        write_file(folder / name, text)


def _is_ours(path: Path, mark: str) -> bool:
    """Whether a file may be replaced: it is not there, or begins with the mark."""
    try:
        if not stat.S_ISREG(path.stat().st_mode):  # a pipe could keep whoever opens it waiting
            return False
        with path.open(encoding="utf-8", errors="replace") as file:
            return file.read(len(mark)) in (mark, "")
    except FileNotFoundError:
        return True
    except OSError:
        return False


def unwritable(what: str, error: Exception) -> ProblemError:
    """The error for something that cannot be written."""
    reason = getattr(error, "strerror", None) or str(error) or type(error).__name__
    return ProblemError(Diagnostic("cannot-write", f"{what} cannot be written: {reason}"))


def _is_special(path: Path) -> bool:
    """Whether it is there, and no regular file: a pipe, a device, a folder."""
    try:
        return not stat.S_ISREG(os.stat(path).st_mode)
    except FileNotFoundError:
        return False


def _status(target: str) -> os.stat_result | None:
    try:
        return os.lstat(target)
    except FileNotFoundError:
        return None


def _replace(target: str, data: bytes, old: os.stat_result | None) -> None:
    """Writes a draft and renames it; `old` is the status of what it replaces."""
    regular = old is not None and stat.S_ISREG(old.st_mode)
    draft = os.path.join(os.path.dirname(target), f".lagsolve-{os.getpid()}-{secrets.token_hex(4)}")
    try:
        file = os.open(draft, _NEW, 0o666)
    except OSError as error:
        if regular and error.errno in _NO_DRAFT:
            _write_in_place(target, data)
            return
        raise
    try:
        with open(file, "wb") as opened:
            opened.write(data)
            if regular and old is not None:
                _as_before(opened.fileno(), old)
        os.replace(draft, target)
    except BaseException as error:
        with suppress(OSError):
            os.unlink(draft)
        if regular and isinstance(error, OSError) and error.errno in _NO_RENAMING:
            _write_in_place(target, data)
            return
        raise


def _as_before(file: int, old: os.stat_result) -> None:
    """Gives a draft the owner and the permissions of the old file, as far as the system allows."""
    with suppress(OSError, AttributeError):
        os.fchown(file, old.st_uid, old.st_gid)
    with suppress(OSError, AttributeError):
        os.fchmod(file, stat.S_IMODE(old.st_mode) & 0o777)


def _write_in_place(target: str, data: bytes) -> None:
    with open(target, "r+b") as file:
        file.write(data)
        file.truncate()


def _write_through(target: str, data: bytes) -> None:
    try:
        opened = os.open(target, os.O_WRONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0))
    except OSError as error:
        if error.errno == errno.ENXIO:  # otherwise it would be waited for, for ever
            raise OSError(errno.ENXIO, "no program reads from this pipe") from None
        raise
    if hasattr(os, "O_NONBLOCK"):
        os.set_blocking(opened, True)
    with open(opened, "wb") as file:
        file.write(data)
