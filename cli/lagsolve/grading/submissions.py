r"""Submissions: the files and folders that the command line names, found and read without trusting them.

Every file of a folder is a submission, and so is every folder in it: the files of one student, whose equations together
are the answer. Deeper folders and hidden files are ignored. Links are not followed, and nothing is opened that is not a
regular file, or is larger than an answer can be. A name can contain nearly any character; it is shown with invisible
ones written out, `\x1b`.

The parts of a submission: which of the problems of an assignment a file, a section or a key answers.

A part is found by the first of these that applies.

    a key of a YAML file     `ex11: {equations: [...]}`, or `ex11: ["..."]`, equations alone
    a heading                `## Problem 2`, `\section*{Ex. 11}`, `**Ideal pendulum**`, `2)` on a line of its own, and
                             `Problem 2: x'' = 0` with the answer after it
    the name of the file     `ex11.tex`, `problem2.txt`, `anna-2.md`

A problem is called by its label (`ex11`), the name of its file, its title, its number if it has one (`Exercise 11`), or
by its place in the assignment: `Problem 2`, `part b`. Lines keep their numbers, so that messages name the right ones.
"""

from __future__ import annotations

import os
import re
import stat
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import islice
from pathlib import Path, PurePath

from lagrange.answers.limits import MAX_FILE_LINES
from lagrange.answers.submissions import Submission
from lagrange.answers.written.notation.documents import text_of_html
from lagrange.core.diagnostics import Diagnostic, ProblemError, Source
from lagrange.core.printable import is_hidden
from lagrange.core.records import record
from lagrange.problem.diagnostic_collector import Diagnostics, EnoughError
from lagrange.problem.limits import MAX_BYTES
from lagrange.problem.sources import decode
from lagrange.problem.yaml.composer import parse
from lagrange.problem.yaml.nodes import MappingNode
from lagsolve.limits import LONGEST_HEADING, MOST_FILES

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

    Raises ProblemError if something does not exist, or where there are none.
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
    """The file or folder that a command line names, as one submission. Raises ProblemError if there are several."""
    if len(named) != 1:
        message = f"{len(named)} files or folders are named, but this format takes a single submission"
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
    """The bytes of a regular file. Raises UnreadSubmissionError if it is not one, or has more than `room` bytes."""
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


# Division


_WORDS = r"problem|exercise|ex|question|task|part|assignment|q|p"
_MARKUP = re.compile(r"\\(?:sub)*(?:section|paragraph|part|chapter|textbf|item)\*?|[#>{}*_\[\]$]|^\s*-\s")
_NUMBERED = re.compile(rf"\s*(?:{_WORDS})\b\.?\s*(?:#\s*)?(?P<which>[0-9]{{1,3}}|[a-z])(?![\w'′’^(])", re.IGNORECASE)
_JOINED = re.compile(rf"(?:{_WORDS})?(?P<which>[0-9]{{1,3}}|[a-z])", re.IGNORECASE)
_BARE = re.compile(r"\s*\(?(?P<which>[0-9]{1,2}|[a-z])[.):]\s*", re.IGNORECASE)
_BEHIND = re.compile(r"\s*[:.)–—-]\s*")
_OWN_NUMBER = re.compile(r"[a-z]+[-_ ]?0*([0-9]+)(?![0-9])", re.IGNORECASE)

NO_HEADING = "no heading, file name or key says which problem it answers"


@record
class AssignedProblem:
    """A problem of an assignment. `label` is its short name: that of the library, or of its file."""

    label: str
    title: str
    source: Source

    @property
    def names(self) -> frozenset[str]:
        """What it is called, in letters and digits alone."""
        stem = PurePath(self.source.name).stem
        return frozenset(filter(None, (_letters(name) for name in (self.label, stem, self.title))))

    @property
    def number(self) -> int | None:
        """Its number in a book, where its name has one: 11 for `ex11`."""
        named = _OWN_NUMBER.match(self.label)
        return int(named[1]) if named else None


def divided(submission: Submission, asked: Sequence[AssignedProblem]) -> tuple[Submission, ...] | str:
    """The part of a submission for each problem, without files where there is none; or why it cannot be divided."""
    if len(asked) == 1:
        return (submission,)
    parts: list[list[tuple[str, bytes]]] = [[] for _ in asked]
    notes = list(submission.notes)
    for name, content in submission.files:
        pieces = _pieces(name, content, asked)
        if pieces is None:
            notes.append(f"{name}: {NO_HEADING}")
        for problem, piece in pieces or ():
            parts[problem].append(piece)
    if not any(parts):
        listed = ", ".join(f"`{a.label}`" for a in asked)
        return f"{NO_HEADING}: {listed}, or `Problem 1`, `Problem 2`, ..."
    return tuple(
        replace(submission, files=tuple(files), notes=tuple(notes), problem=n) for n, files in enumerate(parts)
    )


def _pieces(name: str, content: bytes, asked: Sequence[AssignedProblem]) -> list[tuple[int, tuple[str, bytes]]] | None:
    """The problems that a file answers, each with what the file has for it; None if nothing says which."""
    ending = PurePath(name).suffix.lower()
    try:
        source = decode(content, name)
        if source.text.count("\n") > MAX_FILE_LINES:
            return [(n, (name, content)) for n in range(len(asked))]  # which is refused
        keyed = _by_key(source, asked) if ending in (".yaml", ".yml") else None
    except (ProblemError, EnoughError):
        return [(n, (name, content)) for n in range(len(asked))]  # the verdict on each says what is wrong with it
    if keyed:
        return [(n, (name, text.encode())) for n, text in keyed]
    if ending not in (".yaml", ".yml"):
        text = text_of_html(source.text) if ending in (".html", ".htm") else source.text
        called = f"{PurePath(name).stem}.txt" if ending in (".html", ".htm") else name
        sections = _by_heading(text, asked)
        if sections:
            return [(n, (called, part.encode())) for n, part in sections.items()]
    problem = _of_file_name(PurePath(name).stem, asked)
    return None if problem is None else [(problem, (name, content))]


def _by_key(source: Source, asked: Sequence[AssignedProblem]) -> list[tuple[int, str]]:
    """The entries of a YAML file whose keys are problems, each as a file of answers of its own."""
    root = parse(source, Diagnostics(), what="an answer file", needs="each key is a problem")
    entries = []
    for key, value in root.entries:
        problem = _named(key.text, asked)
        if problem is not None:
            begin = "answers" if isinstance(value, MappingNode) else "equations"
            before = source.text.count("\n", 0, key.span.start)
            entries.append((problem, "\n" * before + begin + source.text[key.span.end : value.span.end] + "\n"))
    return entries


def _by_heading(text: str, asked: Sequence[AssignedProblem]) -> dict[int, str]:
    """The sections of a text by problem, each with as many lines as the text; empty if it has no heading."""
    lines = text.split("\n")
    headings = [_heading(line, asked) for line in lines]
    if not any(headings):
        headings = [_bare_heading(line, asked) for line in lines]
    sections: dict[int, list[str]] = {}
    current: int | None = None
    for number, (line, heading) in enumerate(zip(lines, headings, strict=True)):
        if heading is not None:
            current, end = heading
            line = " " * end + line[end:]
        if current is not None:
            section = sections.setdefault(current, [""] * len(lines))
            section[number] = line
    return {n: "\n".join(section) for n, section in sections.items()}


def _heading(line: str, asked: Sequence[AssignedProblem]) -> tuple[int, int] | None:
    """The problem that a line is the heading of, and how far the heading goes; None if it is none."""
    plain = _MARKUP.sub(lambda mark: " " * len(mark[0]), line)
    for end in _ends(plain):
        problem = _named(plain[:end], asked)
        if problem is not None:
            return problem, end
    numbered = _NUMBERED.match(plain)
    if numbered is None:
        return None
    rest = plain[numbered.end() :]
    behind = _BEHIND.match(rest)
    problem = _placed(numbered["which"], asked)
    if problem is None or (rest.strip() and behind is None and "=" in rest):
        return None
    if "=" in rest and behind is not None:
        return problem, numbered.end() + behind.end()
    return (problem, len(line)) if len(line) <= LONGEST_HEADING else None


def _ends(plain: str) -> Iterator[int]:
    """Where the name of a problem may end in a line: at its end, or at a colon before an answer."""
    if "=" not in plain and len(plain) <= LONGEST_HEADING:
        yield len(plain)
    colon = plain.find(":")
    if 0 < colon <= LONGEST_HEADING and plain[colon : colon + 2] != ":=":
        yield colon + 1


def _bare_heading(line: str, asked: Sequence[AssignedProblem]) -> tuple[int, int] | None:
    """The same for a number or a letter on a line of its own."""
    bare = _BARE.fullmatch(_MARKUP.sub(" ", line))
    problem = _placed(bare["which"], asked) if bare else None
    return None if problem is None else (problem, len(line))


def _named(text: str, asked: Sequence[AssignedProblem]) -> int | None:
    """The problem that a text is a name of: label, file, title, or `problem2`."""
    letters = _letters(text)
    numbers = [n for n, a in enumerate(asked) if letters in a.names]
    if numbers or not letters:
        return numbers[0] if numbers else None
    joined = _JOINED.fullmatch(letters)
    worded = joined is not None and len(letters) > len(joined["which"])
    return _placed(joined["which"], asked) if joined is not None and worded else None


def _of_file_name(stem: str, asked: Sequence[AssignedProblem]) -> int | None:
    """The problem that the name of a file, or its last word, is a name of."""
    words = re.split(r"[\W_]+", stem)
    for last in range(len(words)):
        named = _named("".join(words[last:]), asked)
        if named is not None:
            return named
    return _placed(words[-1], asked)


def _placed(which: str, asked: Sequence[AssignedProblem]) -> int | None:
    """The problem with a number, or at a place of the assignment: 2 and b are the second."""
    if which.isascii() and which.isdigit():
        by_number = [n for n, a in enumerate(asked) if a.number == int(which)]
        place = by_number[0] if by_number else int(which) - 1
    elif len(which) == 1 and "a" <= which.lower() <= "z":
        place = ord(which.lower()) - ord("a")
    else:
        return None
    return place if 0 <= place < len(asked) else None


def _letters(text: str) -> str:
    """The letters and digits of a text, in lower case."""
    return re.sub(r"[\W_]+", "", text).casefold()
