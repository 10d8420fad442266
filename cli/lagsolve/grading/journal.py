"""The journal of a batch: what has been graded so far, so that an interrupted batch can continue.

It has one line of JSON for each submission, added once its row is known and its page written: a key and the row. The
key is a hash of everything on which the row depends, so that whatever has changed in the meantime is graded again. The
journal lies in a folder that others may write to: it is opened without following links, a line that is not one of ours
is ignored and counted, and half a line, the last one of a process that was killed, is removed. A complete batch deletes
its journal.
"""

from __future__ import annotations

import errno
import hashlib
import json
import os
import stat
from collections.abc import Iterable
from contextlib import suppress
from dataclasses import asdict
from io import FileIO
from pathlib import Path
from typing import Any

from lagrange.answers.submissions import Submission
from lagrange.answers.verdicts import Verdict
from lagrange.core.printable import one_line
from lagsolve.grading.table import TableRow
from lagsolve.limits import MAX_JOURNAL_LINE, MOST_COUNTED


def key(submission: Submission, *of_batch: object) -> str:
    """The hash of a submission and of what the whole batch has in common: problem, version, limits."""
    parts: Iterable[bytes] = (
        repr((*of_batch, submission.name, submission.notes, submission.problem, submission.seed)).encode(),
        *(part for name, content in submission.files for part in (name.encode(), content)),
    )
    digest = hashlib.sha256()
    for part in parts:
        digest.update(len(part).to_bytes(8) + part)
    return digest.hexdigest()


class Journal:
    """The rows of a batch by key; without a path it keeps nothing.

    ignored  how many lines were found in it that are no rows

    Raises OSError if the file cannot be opened, or is not a regular file; a link is not followed.
    """

    def __init__(self, path: Path | None) -> None:
        self._path = path
        self._known: dict[str, TableRow] = {}
        self.ignored = 0
        self._file = _opened(path) if path is not None else None
        if self._file is not None:
            self._read(self._file)

    def _read(self, file: FileIO) -> None:
        """The rows of an earlier run. Half a line at its end, of a process that was killed, is removed."""
        end = 0
        with open(file.fileno(), "rb", closefd=False) as lines:
            while line := lines.readline(MAX_JOURNAL_LINE):
                if line.endswith(b"\n"):
                    end = lines.tell()
                    entry = _entry(line)
                    if entry is not None:
                        self._known[entry[0]] = entry[1]
                    elif line.strip():
                        self.ignored += 1
        file.truncate(end)

    @property
    def path(self) -> Path | None:
        """The file of the journal; None if there is none."""
        return self._path

    def row(self, of: str) -> TableRow | None:
        """The row of a key; None if it is not known."""
        return self._known.get(of)

    def add(self, under: str, row: TableRow) -> None:
        """Adds a row, written at once. Raises OSError."""
        if self._file is not None:
            line = (json.dumps({"key": under, "row": asdict(row)}) + "\n").encode()
            if self._file.write(line) != len(line):
                raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    def close(self, complete: bool) -> None:
        """Closes the journal, and deletes it if the batch is complete."""
        if self._file is None or self._path is None:
            return
        with suppress(OSError):
            empty = not os.fstat(self._file.fileno()).st_size
            self._file.close()
            if complete or empty:
                self._path.unlink(missing_ok=True)


def _opened(path: Path) -> FileIO:
    """The file, to be read from its beginning and written at its end."""
    flags = os.O_RDWR | os.O_CREAT | os.O_APPEND
    flags |= sum(getattr(os, f, 0) for f in ("O_NOFOLLOW", "O_NONBLOCK", "O_NOCTTY", "O_CLOEXEC", "O_BINARY"))
    try:
        number = os.open(path, flags, 0o666)
    except OSError as error:
        if error.errno == errno.ELOOP and os.path.islink(path):
            raise OSError(errno.ELOOP, "it is a link, which is not followed") from None
        raise
    if not stat.S_ISREG(os.fstat(number).st_mode):
        os.close(number)
        raise OSError(errno.EINVAL, "it is not a regular file")
    return FileIO(number, "r+b")


def _entry(line: bytes) -> tuple[str, TableRow] | None:
    """Key and row of a line; None if it is not one that `add` writes."""
    try:
        entry: Any = json.loads(line)
        name = entry["key"]
        row = TableRow(**entry["row"] | {"verdict": Verdict(entry["row"]["verdict"])})
    except (ValueError, KeyError, TypeError, RecursionError):
        return None
    return (name, row) if isinstance(name, str) and _is_row(row) else None


def _is_row(row: TableRow) -> bool:
    """Whether each value is one that a row can have."""
    texts = (row.submission, row.remark, row.feedback, row.mistakes, row.problem)
    if not all(isinstance(t, str) and t == one_line(t) for t in texts) or type(row.seconds) not in (int, float):
        return False
    counts = (row.right, row.required, row.missing)
    if not all(c is None or (type(c) is int and 0 <= c <= MOST_COUNTED) for c in counts):
        return False
    amounts = (row.points, row.possible)
    if not all(a is None or (type(a) in (int, float) and 0 <= a <= MOST_COUNTED) for a in amounts):
        return False
    if row.student or row.attempt is not None or row.submitted or row.late or row.counts:
        return False  # known only when the batch is complete
    difference = None if row.right is None or row.required is None else row.required - row.right
    return 0 <= row.seconds < float("inf") and row.missing == difference and row.submission != ""
