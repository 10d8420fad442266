"""Submissions: the files and folders that the command line names, found and read without trusting them.

Every file of a folder is a submission, and so is every folder in it: the files of one student, whose equations together
are the answer. Deeper folders and hidden files are ignored. Links are not followed, and nothing is opened that is not a
regular file, or is larger than an answer can be. A name can contain nearly any character; it is shown with invisible
ones written out, `\\x1b`.
"""

from __future__ import annotations

import os
import stat
from collections import Counter
from collections.abc import Iterator, Sequence
from itertools import islice
from pathlib import Path

from lagrange.answers.submissions import Submission
from lagrange.core.diagnostics import Diagnostic, ProblemError
from lagrange.core.printable import is_hidden
from lagrange.core.records import record
from lagrange.problem.limits import MAX_BYTES
from lagsolve.limits import MOST_FILES

EXTENSIONS = ("", ".txt", ".md", ".tex", ".html", ".htm", ".yaml", ".yml")
"""Extensions of the files in a student's folder that are answers. A file on its own may have any extension."""

KINDS = {
    stat.S_IFLNK: "is a link, which is not followed",
    stat.S_IFIFO: "is a pipe, which is not opened",
    stat.S_IFSOCK: "is a socket, which is not opened",
    stat.S_IFDIR: "is a folder",
}


class UnreadSubmissionError(Exception):
    """A submission that cannot be read. The message completes `it ...`."""


@record
class UnreadSubmission:
    """A submission that has not been read yet.

    name  unique in the batch, and safe to print
    """

    name: str
    path: Path

    def read(self) -> Submission:
        """Its files. Raises UnreadSubmissionError."""
        try:
            if _is_folder(self.path):
                return self._of_folder()
            return Submission(self.name, ((printable_name(self.path.name), _content(self.path, MAX_BYTES)),))
        except OSError as error:
            raise UnreadSubmissionError(f"cannot be read: {error.strerror}") from None

    def _of_folder(self) -> Submission:
        names = sorted(islice(_names(self.path), MOST_FILES + 1))
        if len(names) > MOST_FILES:
            raise UnreadSubmissionError(f"has more than {MOST_FILES} files")
        answers = [n for n in names if Path(n).suffix.lower() in EXTENSIONS and not _is_folder(self.path / n)]
        others = [n for n in names if n not in answers]
        if not answers:
            raise UnreadSubmissionError(
                f"has no answer in it: a file that ends with {' '.join(e for e in EXTENSIONS if e)}"
            )
        files: list[tuple[str, bytes]] = []
        room = MAX_BYTES
        for name in answers:
            try:
                content = _content(self.path / name, room)
            except UnreadSubmissionError as error:
                raise UnreadSubmissionError(f"has a file {printable_name(name)} that {error}") from None
            room -= len(content)
            files.append((printable_name(name), content))
        notes = (f"not looked into: {', '.join(map(printable_name, others))}",) if others else ()
        return Submission(self.name, tuple(files), notes)


def named_submissions(named: Sequence[str], excluded: Sequence[Path]) -> list[UnreadSubmission]:
    """The submissions that a command line names, sorted; `excluded` are files and folders of the grading itself.

    Raises ProblemError where something does not exist, or where there are none.
    """
    own = {real for p in excluded for real in (os.path.realpath(p), _place(p))}
    names: dict[str, tuple[str, str]] = {}  # place: the short name, and the long one
    for name in named:
        for path in _members(name):
            if (place := _place(path)) not in own:
                names.setdefault(place, (path.name, os.path.normpath(path)))
    if not names:
        message = f"there is no submission in {', '.join(map(printable_name, named))}"
        help_ = "name a folder in which every file, or every folder, is a submission"
        raise ProblemError(Diagnostic("no-submissions", message, help=help_))
    times = Counter(name for name, _ in names.values())
    listed = [
        UnreadSubmission(printable_name(n if times[n] == 1 else path), Path(place))
        for place, (n, path) in names.items()
    ]
    return sorted(listed, key=lambda e: e.name)


def one_entry(named: Sequence[str]) -> UnreadSubmission:
    """The file or folder that a command line names, as one submission. Raises ProblemError where there are several."""
    if len(named) != 1:
        message = f"{len(named)} files or folders are named, and this format is about one submission"
        help_ = "name the folder with the files of one student"
        raise ProblemError(Diagnostic("several-submissions", message, help=help_))
    path = Path(named[0])
    if not os.path.lexists(path):
        message = f"{printable_name(named[0])} cannot be read: there is no such file or folder"
        raise ProblemError(Diagnostic("unreadable-file", message, help="name the folder of the submission"))
    return UnreadSubmission(printable_name(path.name or path.absolute().name), Path(_place(path)))


def _place(path: Path) -> str:
    """The place of a file or folder: links on the way are followed, but not the last one."""
    return os.path.join(os.path.realpath(path.parent), path.name)


def _is_folder(path: Path) -> bool:
    return stat.S_ISDIR(os.lstat(path).st_mode)


def _members(name: str) -> Iterator[Path]:
    """The submissions that one argument names: those in a folder, or a file. A link is not followed."""
    path = Path(name)
    try:
        if not _is_folder(path):
            yield path
            return
        inside = sorted(_names(path))
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        message = f"{printable_name(name)} cannot be read: {reason}"
        raise ProblemError(Diagnostic("unreadable-file", message, help="name files or folders of answers")) from None
    yield from (path / n for n in inside)


def _names(folder: Path) -> Iterator[str]:
    """The names in a folder, without the hidden ones."""
    with os.scandir(folder) as inside:
        yield from (e.name for e in inside if not e.name.startswith("."))


def _content(path: Path, room: int) -> bytes:
    """The bytes of a regular file. Raises UnreadSubmissionError where it is not one, or has more than `room` bytes."""
    before = os.lstat(path)
    if not stat.S_ISREG(before.st_mode):
        raise UnreadSubmissionError(KINDS.get(stat.S_IFMT(before.st_mode), "is a device, which is not opened"))
    if before.st_size > room:
        raise UnreadSubmissionError(f"has {before.st_size:,} bytes; {MAX_BYTES:,} are the most that is read")
    flags = os.O_RDONLY | sum(getattr(os, f, 0) for f in ("O_NOFOLLOW", "O_NONBLOCK", "O_CLOEXEC", "O_BINARY"))
    with open(os.open(path, flags), "rb") as file:
        now = os.fstat(file.fileno())
        if (now.st_dev, now.st_ino) != (before.st_dev, before.st_ino):
            raise UnreadSubmissionError("was replaced while it was read")
        content = file.read(room + 1)
        after = os.fstat(file.fileno())
        if (now.st_mtime_ns, now.st_size) != (after.st_mtime_ns, after.st_size):
            raise UnreadSubmissionError("was changed while it was read")
    if len(content) > room:
        raise UnreadSubmissionError(f"has more than {MAX_BYTES:,} bytes, which are the most that is read")
    return content


def printable_name(name: str) -> str:
    """A name as printable text, with invisible characters written out. Different names stay different."""
    return "".join(_visible(c) for c in name)


def _visible(char: str) -> str:
    if char == "\\":
        return "\\\\"
    if not is_hidden(char):
        return char
    code = ord(char)
    if 0xDC80 <= code <= 0xDCFF:  # a byte that is no text
        return f"\\x{code - 0xDC00:02x}"
    return f"\\x{code:02x}" if code < 0x100 else f"\\u{code:04x}" if code < 0x10000 else f"\\U{code:08x}"
