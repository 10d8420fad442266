"""The program: `lagsolve` and `python -m lagsolve`. Ctrl-C ends it without a traceback from its first line on.

What is imported here, before the current folder is off the path, is part of the interpreter or loaded when it starts:
not even `__future__` and `typing` may be, for a folder of submissions may have a `re.py`, which `typing` imports.
"""

import gc
import os
import sys


def run() -> None:
    """Runs the command line."""
    _import_nothing_from_here()
    try:
        _refuse_another_lagrange()
        from lagrange.core.part_of_sympy import leave_tensors_out

        leave_tensors_out()
        gc.disable()  # nothing that is imported becomes garbage
        from lagsolve.main import main

        gc.freeze()
        gc.enable()
        main(prog_name="lagsolve")
    except KeyboardInterrupt:
        if sys.stderr is not None:
            sys.stderr.write("interrupted\n")
        sys.exit(130)  # command_group.INTERRUPTED, which may not be imported yet
    except SystemExit as end:
        _leave_at_once(end.code)
        raise


def _import_nothing_from_here() -> None:
    """Takes the current folder off the path: a folder of submissions may have a `sympy.py` in it.

    `python -m lagsolve` puts it there, and so does an empty entry of PYTHONPATH. It stays where this program itself
    lies in it, as in its sources.
    """
    package = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    own = {os.path.realpath(package), os.path.realpath(os.path.dirname(package))}
    try:
        here = os.path.realpath(os.getcwd())
    except OSError:  # it has been removed
        return
    if here not in own:
        sys.path[:] = [p for p in sys.path if p and os.path.realpath(p) != here]


def _refuse_another_lagrange() -> None:
    """Exits if `lagrange` is not ours: the package index has another one, for interpolation."""
    import lagrange

    if "loads" in getattr(lagrange, "__all__", ()):
        return
    where = getattr(lagrange, "__file__", None) or "another folder"
    sys.stderr.write(
        f"error[another-lagrange]: `lagrange` in {where} is not the package of lagsolve\n"
        "  = help: another package of this name is installed over it, or lies before it on the path; install lagsolve "
        "into an environment of its own, or: pip uninstall lagrange, then pip install --force-reinstall lagsolve\n"
    )
    sys.exit(2)


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
