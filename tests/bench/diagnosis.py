"""How many wrong answers are explained, and how fast: `make bench`, or `python tests/bench/diagnosis.py`.

The table of tests/answers/test_diagnosis.py, and every term's sign, factor, omission and function in the equations of every
shipped problem of motion. Explained: one change is named that makes the equation right; rightly: it is the one that was made.

Then the answers of tests/answers/models/slips.txt, derived from wrong models. Helped: the physical cause is named;
useless: none is; misleading: another one is. All times are processor times. A check is of a whole wrong answer, its verdict
included; over the time to solve, it is the first one, for which models are derived.
"""

from __future__ import annotations

import statistics
import sys
import time
from collections import Counter
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from lagrange.answers.diagnosis import diagnosed
from lagrange.answers.examiner import Examiner
from lagrange.answers.readings import read_answer
from lagrange.core.diagnostics import Fragment
from lagrange.mechanics.dynamics.comparison import Standing, compare
from tests.answers.models.slips import helps, wrong_answers, wrong_parts
from tests.answers.test_diagnosis import TABLE, system
from tests.support.mutations import best_system, mutations
from tests.support.shared import asking, loaded, solved


def derived_from_wrong_models() -> None:
    """Prints how many answers derived from wrong models are helped."""
    counts: Counter[str] = Counter()
    checks: list[float] = []
    ratios: list[float] = []
    examiners: dict[str, Examiner] = {}
    for answer in wrong_answers():
        started = time.process_time()
        is_first = answer.problem not in examiners
        if is_first:
            examiners[answer.problem] = Examiner.of(loaded(answer.problem))
            assert examiners[answer.problem].reference.candidates
        solving = time.process_time() - started
        judgement = examiners[answer.problem].check(tuple(map(Fragment.of, answer.equations)))
        checks.append(time.process_time() - started - solving)
        if is_first:
            ratios.append(checks[-1] / solving)
        named = any(e.model for e in wrong_parts(judgement))
        counts["helped" if helps(answer, judgement) else "misleading" if named else "useless"] += 1
        if not helps(answer, judgement):
            print(f"    {answer.problem}: {answer.mistake}: {[e.model for e in wrong_parts(judgement)]}")
    print(f"from wrong models: {counts['helped']} of {counts.total()} helped, {counts['useless']} true but useless, "
          f"{counts['misleading']} misleading")  # fmt: skip
    print(f"    a check of a wrong answer: median {1000 * statistics.median(checks):.0f} ms, longest {max(checks):.2f} s; "
          f"over the time to solve its problem: median {statistics.median(ratios):.2f}, most {max(ratios):.2f}")  # fmt: skip


def main() -> None:
    """Prints the shares and the times."""
    derived_from_wrong_models()
    seconds: list[float] = []
    right = asked = 0
    for key, equation, slip, *_ in TABLE:
        if slip is None:
            continue
        [candidate] = system(key).candidates
        wrong = candidate.read(read_answer(Fragment.of(equation), system(key).scope).components[0])
        started = time.process_time()
        change = diagnosed(wrong, candidate.system)
        seconds.append(time.process_time() - started)
        asked += 1
        right += change is not None and change.slip is slip
    print(f"the table: {right} of {asked} explained rightly; median {1000 * statistics.median(seconds):.0f} ms")
    counts: Counter[tuple[str, str]] = Counter()
    seconds = []
    for name in asking("motion"):
        found = best_system(solved(name))
        for m in mutations(found[0]) if found else ():
            assert found is not None
            result = compare([m.equation], found[1].system)
            if result is None or result.standings[0] is not Standing.CONTRADICTS:
                continue
            started = time.process_time()
            change = diagnosed(m.equation, found[1].system)
            seconds.append(time.process_time() - started)
            said = "none" if change is None or change.slip is None else "true" if change.slip is m.slip else "other"
            counts[m.slip.name.lower(), said] += 1
    total = sum(counts.values())
    true, other = (sum(n for (_, said), n in counts.items() if said == what) for what in ("true", "other"))
    print(f"mutations of shipped problems: {total}; explained {true + other} ({(true + other) / total:.1%}), "
          f"by the change that was made {true} ({true / total:.1%})")  # fmt: skip
    for slip in sorted({slip for slip, _ in counts}):
        print(f"    {slip:10}" + "".join(f"{what} {counts[slip, what]:5}   " for what in ("true", "other", "none")))
    print(f"    a diagnosis: median {1000 * statistics.median(seconds):.0f} ms, longest {max(seconds):.2f} s")


if __name__ == "__main__":
    main()
