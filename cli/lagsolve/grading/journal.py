"""What has been graded so far, so that a batch that was interrupted can go on.

One line of JSON for each submission, added when its row is known and its page is written: a key and the row. The key
is a hash of everything on which the row depends, so that what has changed in the meantime is graded again. A line that
cannot be read, the last one of a process that was killed, is left out. A batch that is complete takes its journal away.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterable
from dataclasses import asdict
from pathlib import Path
from typing import Any

from lagrange.answers.equations import Verdict
from lagrange.answers.grading import Submission
from lagsolve.grading.rows import Row


def key(submission: Submission, *of_batch: object) -> str:
    """The hash of a submission and of what is the same in the whole batch: problem, version, limits."""
    parts: Iterable[bytes] = (
        repr((*of_batch, submission.name, submission.notes)).encode(),
        *(part for name, content in submission.files for part in (name.encode(), content)),
    )
    digest = hashlib.sha256()
    for part in parts:
        digest.update(len(part).to_bytes(8) + part)
    return digest.hexdigest()


class Journal:
    """The rows of a batch by key; without a path it keeps nothing."""

    def __init__(self, path: Path | None) -> None:
        self._path = path
        self._known = dict(_read(path)) if path is not None else {}
        self._file = path.open("a", encoding="utf-8") if path is not None else None
        if self._file is not None and self._known:
            self._file.write("\n")  # the last line may be half a line

    @property
    def path(self) -> Path | None:
        """Where it is."""
        return self._path

    def row(self, of: str) -> Row | None:
        """What was found before under a key."""
        return self._known.get(of)

    def add(self, under: str, row: Row) -> None:
        """Notes a row, at once."""
        if self._file is not None:
            self._file.write(json.dumps({"key": under, "row": asdict(row)}) + "\n")
            self._file.flush()

    def close(self, complete: bool) -> None:
        """Ends the journal; takes it away where it has served its purpose."""
        if self._file is None or self._path is None:
            return
        self._file.close()
        if complete or not self._path.stat().st_size:
            self._path.unlink(missing_ok=True)


def _read(path: Path) -> Iterable[tuple[str, Row]]:
    try:
        lines = path.read_text(encoding="utf-8", errors="replace").splitlines()
    except FileNotFoundError:
        return
    for line in lines:
        entry = _entry(line)
        if entry is not None:
            yield entry


def _entry(line: str) -> tuple[str, Row] | None:
    try:
        found: dict[str, Any] = json.loads(line)
        return str(found["key"]), Row(**found["row"] | {"verdict": Verdict(found["row"]["verdict"])})
    except (ValueError, KeyError, TypeError):
        return None
