"""One case of one net, as the processes of the command run it."""

from __future__ import annotations

import importlib
import time

from tests.support.nets.run import Finding


def case(kind: str, seed: int) -> tuple[str, int, float, list[Finding]]:
    """One case: its findings, and the seconds of processor time."""
    net = importlib.import_module(f"tests.support.nets.{kind}")
    start = time.process_time()
    try:
        found = net.findings(seed)
    except Exception as error:
        found = [Finding("the net itself", f"seed {seed}: {type(error).__name__}: {error}", "no exception")]
    return kind, seed, time.process_time() - start, found
