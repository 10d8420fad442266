"""Any number of broken inputs: problem files by mutation and by grammar, answers, journals.

python -m tests.support.fuzzers --kind problems --number 1000 --seed 1

Every input ends in a result or in an error of the project's own. Prints how many ended in what, and what is at fault.
"""

from __future__ import annotations

import argparse
from collections import Counter

from tests.support.fuzzers.kinds import KINDS


def main() -> int:
    """1 if an input ended in anything else."""
    parser = argparse.ArgumentParser(prog="python -m tests.support.fuzzers", description=__doc__)
    parser.add_argument("--kind", choices=KINDS, required=True)
    parser.add_argument("--number", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    outcomes: Counter[str] = Counter()
    for seed in range(options.seed, options.seed + options.number):
        try:
            outcomes[KINDS[options.kind](seed)] += 1
        except Exception as error:
            outcomes["fault"] += 1
            print(f"[{options.kind} {seed}] {type(error).__name__}: {error}"[:300], flush=True)
    print(dict(outcomes.most_common()))
    return bool(outcomes["fault"])


if __name__ == "__main__":
    raise SystemExit(main())
