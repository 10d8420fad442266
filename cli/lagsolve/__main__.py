"""The program: `lagsolve` and `python -m lagsolve`. Ctrl-C ends it without a traceback from its first line on."""

import os
import sys


def run() -> None:
    """Runs the command line."""
    try:
        from lagsolve.main import main

        main(prog_name="lagsolve")
    except KeyboardInterrupt:
        sys.stderr.write("interrupted\n")
        sys.exit(130)  # command_group.INTERRUPTED, which may not be imported yet
    except SystemExit as end:
        _leave_at_once(end.code)
        raise


def _leave_at_once(status: object) -> None:
    """Ends the process where only memory remains to be freed, which with SymPy takes a twentieth of the whole time."""
    threading = sys.modules.get("threading")
    if not isinstance(status, int) or (threading and threading.active_count() > 1):
        return
    try:
        sys.stdout.flush()
        sys.stderr.flush()
    except (OSError, AttributeError, ValueError):
        return
    os._exit(status)


if __name__ == "__main__":
    run()
