"""Runs any number of random cases of one net, or of all, and writes each finding with its problem file.

python -m tests.support.nets --kind statics --number 500 --seed 1 --processes 1 [--folder FOLDER]
"""

from __future__ import annotations

import argparse
import statistics
from collections import Counter
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

from tests.support.nets.cases import case
from tests.support.nets.run import Finding

KINDS = ("statics", "further_statics", "motions", "questions", "constraint_systems", "units")


def cases(kinds: list[str], seeds: range, processes: int) -> Iterator[tuple[str, int, float, list[Finding]]]:
    """All cases, in processes if there are to be several."""
    asked = [(kind, seed) for seed in seeds for kind in kinds]
    if processes == 1:
        yield from (case(*c) for c in asked)
        return
    with ProcessPoolExecutor(processes, max_tasks_per_child=50) as pool:
        yield from pool.map(case, *zip(*asked, strict=True))


def main() -> int:
    """Prints every finding, and a count of them; 1 if there are any."""
    parser = argparse.ArgumentParser(prog="python -m tests.support.nets", description=__doc__)
    parser.add_argument("--kind", choices=[*KINDS, "all"], default="all")
    parser.add_argument("--number", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--processes", type=int, default=1)
    parser.add_argument("--folder", type=Path, help="write each finding's problem file into this folder")
    options = parser.parse_args()
    kinds = list(KINDS) if options.kind == "all" else [options.kind]
    counts: Counter[str] = Counter()
    seconds, wrong = [], 0
    for kind, seed, took, found in cases(kinds, range(options.seed, options.seed + options.number), options.processes):
        seconds.append(took)
        wrong += bool(found)
        for n, f in enumerate(found):
            counts[f"{kind}: {f.kind}"] += 1
            print(f"[{kind} {seed}] {f}", flush=True)
            if options.folder:
                options.folder.mkdir(parents=True, exist_ok=True)
                head = "".join(f"# {line}\n" for line in f"{f.kind}\nsaid: {f.said}\ntrue: {f.true}".splitlines())
                (options.folder / f"{kind}-{seed}-{n}.yaml").write_text(head + f.text, encoding="utf-8")
    print(
        f"{len(seconds)} cases, {wrong} with findings; median {statistics.median(seconds):.2f} s, longest {max(seconds):.1f} s"
    )
    for name, number in counts.most_common():
        print(f"{number:6d}  {name}")
    return bool(wrong)


if __name__ == "__main__":
    raise SystemExit(main())
