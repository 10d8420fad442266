"""The program: `lagsolve` and `python -m lagsolve`. Ctrl-C ends it without a traceback from its first line on."""

import sys


def run() -> None:
    """Runs the command line."""
    try:
        from lagsolve.main import main

        main(prog_name="lagsolve")
    except KeyboardInterrupt:
        sys.stderr.write("interrupted\n")
        sys.exit(130)  # status.INTERRUPTED, which may not be there yet


if __name__ == "__main__":
    run()
