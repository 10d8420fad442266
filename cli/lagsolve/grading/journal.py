"""The journal of a batch: what has been graded so far, so that an interrupted batch can continue.

It has one line of JSON for each submission, added once its row is known and its page written: a key and the row. The
key is a hash of everything on which the row depends, so that whatever has changed in the meantime is graded again. A
line that cannot be read (the last one of a process that was killed) is ignored. A complete batch deletes its journal.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterable
from dataclasses import asdict
from pathlib import Path
from typing import Any

from lagrange.answers.submissions import Submission
from lagrange.answers.verdicts import Verdict
from lagsolve.grading.table import TableRow


def key(submission: Submission, *of_batch: object) -> str:
    """The hash of a submission and of what the whole batch has in common: problem, version, limits."""
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
        """The file of the journal; None where there is none."""
        return self._path

    def row(self, of: str) -> TableRow | None:
        """The row of a key; None where it is not known."""
        return self._known.get(of)

    def add(self, under: str, row: TableRow) -> None:
        """Adds a row, written at once."""
        if self._file is not None:
            self._file.write(json.dumps({"key": under, "row": asdict(row)}) + "\n")
            self._file.flush()

    def close(self, complete: bool) -> None:
        """Closes the journal, and deletes it if the batch is complete."""
        if self._file is None or self._path is None:
            return
        self._file.close()
        if complete or not self._path.stat().st_size:
            self._path.unlink(missing_ok=True)


def _read(path: Path) -> Iterable[tuple[str, TableRow]]:
    try:
        lines = path.read_text(encoding="utf-8", errors="replace").splitlines()
    except FileNotFoundError:
        return
    for line in lines:
        entry = _entry(line)
        if entry is not None:
            yield entry


def _entry(line: str) -> tuple[str, TableRow] | None:
    try:
        entry: dict[str, Any] = json.loads(line)
        return str(entry["key"]), TableRow(**entry["row"] | {"verdict": Verdict(entry["row"]["verdict"])})
    except (ValueError, KeyError, TypeError):
        return None
