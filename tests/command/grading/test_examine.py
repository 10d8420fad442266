"""Equal submissions are graded once, and their outcomes have their own names."""

from __future__ import annotations

from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor

from lagrange.answers.submissions import Graded, Submission
from lagrange.answers.verdicts import Verdict
from lagsolve.grading.examine import outcomes

CALLS: list[str] = []


def graded(submission: Submission) -> Graded:
    CALLS.append(submission.name)
    name, content = submission.files[0]
    text = content.decode()
    return Graded(Verdict.WRONG, f"wrong: {text}", messages=(f"error[x]: no\n --> {name}:1:1\n", f"about {text}"))


def submissions(*files: tuple[str, str]) -> Iterator[Submission]:
    return (Submission(f"s{n}", ((name, text.encode()),)) for n, (name, text) in enumerate(files))


def found(*files: tuple[str, str], ahead: int = 2) -> dict[str, Graded]:
    CALLS.clear()
    with ThreadPoolExecutor(1) as executor:
        done = [o for o in outcomes(submissions(*files), executor, graded, ahead=ahead) if o is not None]
    assert len(done) == len(files)
    return {s.name: g for s, g in done}


def test_equal_files_are_graded_once() -> None:
    done = found(("a.txt", "x = 1"), ("b.txt", "x = 1"), ("c.txt", "x = 2"), ("d.txt", "x = 1"), ("e.txt", "x = 2"))
    assert CALLS == ["s0", "s2"]
    assert [g.headline for g in done.values()].count("wrong: x = 1") == 3
    assert done["s3"].messages[0] == "error[x]: no\n --> d.txt:1:1\n"


def test_other_extensions_are_other_answers() -> None:
    found(("a.txt", "x = 1"), ("b.tex", "x = 1"))
    assert CALLS == ["s0", "s1"]


def test_a_message_that_has_the_name_elsewhere_is_made_anew() -> None:
    done = found(("a.txt", "see a.txt"), ("b.txt", "see a.txt"))
    assert CALLS == ["s0", "s1"]
    assert done["s1"].messages[0] == "error[x]: no\n --> b.txt:1:1\n"


def test_however_many_are_equal_all_come_out() -> None:
    done = found(*[(f"{n}.txt", f"x = {n % 3}") for n in range(200)], ahead=4)
    assert len(done) == 200
    assert len(CALLS) == 3
