"""How long a course takes: 1,000 submissions of the double pendulum, on all cores. `python tests/bench/grading_speed.py`

Half of them are right, in different forms; the others lack an equation, have a wrong sign or cannot be read.
"""

from __future__ import annotations

import random
import resource
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

FIRST = "(m1 + m2)*l1*phi1'' + m2*l2*phi2''*cos(phi1 - phi2) + m2*l2*phi2'^2*sin(phi1 - phi2) + (m1 + m2)*g*sin(phi1)"
SECOND = "l2*phi2'' + l1*phi1''*cos(phi1 - phi2) - l1*phi1'^2*sin(phi1 - phi2) + g*sin(phi2)"
EXPANDED = (
    "(m1 + m2)*l1*phi1'' + m2*l2*phi2''*(cos(phi1)*cos(phi2) + sin(phi1)*sin(phi2))"
    " + m2*l2*phi2'^2*(sin(phi1)*cos(phi2) - cos(phi1)*sin(phi2)) + (m1 + m2)*g*sin(phi1)"
)


def submission(chance: random.Random) -> str:
    """The text of one submission: two equations, mostly."""
    a, b, n = chance.randint(2, 9), chance.randint(2, 9), chance.randint(2, 30)
    right = [
        f"{FIRST} = 0\n{SECOND} = 0\n",
        f"{EXPANDED} = 0\n{n}*m2*l2*({SECOND}) = 0\n",
        f"{a}*({FIRST}) = {b}*({SECOND})\n{SECOND} = 0\n",
        f"# with factors\n({FIRST})*{n}/l1 = 0\n({SECOND})*cos(phi1) = ({FIRST})*{a}/{b}\n",
        f"{FIRST} = {n}*m1*({SECOND})\n0 = {SECOND}\n",
    ]
    others = [
        f"{FIRST} = 0\n",
        f"{n}*m1*({FIRST}) = 0\n{a}*({SECOND.replace(' - l1', ' + l1')}) = 0\n",
        f"{FIRST.replace('g*sin', f'{n}*g*sin')} = 0\n{SECOND} = 0\n",
        f"{FIRST} = 0\n{SECOND.replace('phi2', 'phi_two')} = 0\n",
        f"{FIRST} = \n{SECOND} = 0\n",
        "I did not finish this one, sorry.\n",
    ]
    return chance.choice(right if chance.random() < 0.5 else others)


def write(folder: Path, number: int, seed: int = 1) -> None:
    """Writes that many submissions, always the same."""
    chance = random.Random(seed)
    for n in range(number):
        (folder / f"student{n:04}.txt").write_text(submission(chance), encoding="utf-8")


def memory(pid: int) -> Iterator[int]:
    """Kilobytes in use by a process and its children, where /proc tells."""
    for status in Path("/proc").glob("[0-9]*/status"):
        try:
            lines = dict(line.split(":", 1) for line in status.read_text().splitlines() if ":" in line)
        except OSError:
            continue
        if str(pid) in (lines["Pid"].strip(), lines["PPid"].strip()) and "VmRSS" in lines:
            yield int(lines["VmRSS"].split()[0])


def main() -> None:
    """Grades them as a user would, and prints seconds and the most memory."""
    number = int(sys.argv[1]) if len(sys.argv) > 1 else 1000
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "answers").mkdir()
        write(folder / "answers", number)
        command = [sys.executable, "-m", "lagsolve", "grade", "ex18", str(folder / "answers"), *sys.argv[2:]]
        command += ["--csv", str(folder / "marks.csv"), "--feedback", str(folder / "pages")]
        start, most = time.monotonic(), 0
        with (folder / "table").open("wb") as table, subprocess.Popen(command, stdout=table) as process:
            while process.poll() is None:
                most = max(most, sum(memory(process.pid)))
                time.sleep(0.25)
        summary = (folder / "table").read_text(encoding="utf-8").splitlines()[-1]
        used = resource.getrusage(resource.RUSAGE_CHILDREN)
        print(summary)
        print(
            f"{time.monotonic() - start:.1f} s, processor {used.ru_utime + used.ru_stime:.1f} s, {most / 1024:.0f} MB"
        )


if __name__ == "__main__":
    main()
