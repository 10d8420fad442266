"""Which stage is running, on standard error, where something takes longer than two seconds on a terminal.

Nothing in the library reports where it is: a thread that wakes up after two seconds looks at what the main thread is
carrying out, and says the stage that the innermost known module belongs to. What is done sooner costs a thread that
sleeps; without a terminal there is not even that. The line is taken away when the work is done.
"""

from __future__ import annotations

import os
import shutil
import sys
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from types import FrameType

PATIENCE, PERIOD = 2.0, 0.25
"""Seconds before something is said, and between two looks."""

STAGES = {
    "lagrange.problem.loader": "reading the problem",
    "lagrange.mechanics.constraints.constraints": "classifying the constraints",
    "lagrange.mechanics.constraints.classification": "classifying the constraints",
    "lagrange.mechanics.constraints.displacements": "displacements",
    "lagrange.mechanics.constraints.coordinates": "choices of coordinates",
    "lagrange.mechanics.dynamics.newton": "free bodies",
    "lagrange.mechanics.dynamics.principle": "d'Alembert's principle",
    "lagrange.mechanics.dynamics.equations": "equations of motion",
    "lagrange.mechanics.dynamics.multipliers": "equations of motion",
    "lagrange.mechanics.dynamics.motion": "equations of motion",
    "lagrange.mechanics.dynamics.lagrangian": "Lagrange's equations",
    "lagrange.mechanics.dynamics.energies": "Lagrange's equations",
    "lagrange.mechanics.dynamics.matrix_form": "equations of motion in matrix form",
    "lagrange.mechanics.dynamics.reactions": "reactions",
    "lagrange.mechanics.dynamics.friction": "friction",
    "lagrange.mechanics.dynamics.quasi_equations": "equations in quasi-velocities",
    "lagrange.mechanics.dynamics.conservation": "what is conserved",
    "lagrange.mechanics.equilibrium.equilibrium": "equilibria",
    "lagrange.mechanics.equilibrium.stability": "stability",
    "lagrange.mechanics.equilibrium.static_reactions": "reactions at rest",
    "lagrange.mechanics.equilibrium.relative_equilibrium": "equilibria of the equations of motion",
    "lagrange.mechanics.equilibrium.linearization": "small oscillations",
    "lagrange.mechanics.dynamics.verification": "checks",
    "lagrange.mechanics.dynamics.quasi_verification": "checks",
    "lagrange.mechanics.dynamics.spot_values": "a value to try",
    "lagrange.answers.examiner": "comparing answers",
    "lagrange.answers.diagnosis": "looking for what is wrong",
    "lagrange.explain.illustrated": "pictures",
    "lagrange.render.terminal": "writing it down",
    "lagrange.render.latex": "writing it down",
    "lagrange.render.markdown": "writing it down",
    "lagrange.render.html": "writing it down",
    "lagrange.render.json": "writing it down",
}
"""Modules, and what is said while one of their functions is being carried out."""

Wait = Callable[[float], bool]
"""Waits for so many seconds, or until the work is done; whether it is."""


@contextmanager
def stage_shown() -> Iterator[None]:
    """While the block runs: after two seconds a line on a terminal says what it is at. The line goes with the block."""
    if sys.stderr is None or not sys.stderr.isatty() or os.environ.get("TERM") == "dumb":
        yield
        return
    done = threading.Event()
    thread = threading.Thread(target=_follow, args=(threading.get_ident(), done.wait, sys.stderr.write), daemon=True)
    thread.start()
    try:
        yield
    finally:
        done.set()
        thread.join()


def _follow(watched: int, wait: Wait, write: Callable[[str], object]) -> None:
    """Says what a thread is at until the work is done; nothing where that is soon."""
    started = time.monotonic()
    if wait(PATIENCE):
        return
    while True:
        frame = sys._current_frames().get(watched)
        width = shutil.get_terminal_size().columns
        write(f"\r\x1b[K{line(modules(frame), time.monotonic() - started)[: width - 1]}")
        sys.stderr.flush()
        if wait(PERIOD):
            break
    write("\r\x1b[K")
    sys.stderr.flush()


def modules(frame: FrameType | None) -> list[str]:
    """The modules of the functions that are being carried out, the innermost first."""
    found = []
    while frame is not None:
        found.append(str(frame.f_globals.get("__name__", "")))
        frame = frame.f_back
    return found


def line(running: Sequence[str], seconds: float) -> str:
    """What is said of a thread that is in these modules."""
    stage = next((STAGES[m] for m in running if m in STAGES), "starting" if seconds < 2 * PATIENCE else "working")
    return f"{stage} ... {seconds:.0f} s"
