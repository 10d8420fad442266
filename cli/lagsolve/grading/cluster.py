"""An existing Dask cluster as an executor. The extra `cluster` installs what is needed, here and on its workers.

A worker of the cluster cannot stop a task that loops, and one that runs out of memory is gone. So each of its threads
has a process of its own with the limits, and what the cluster distributes is only who waits for which.
"""

from __future__ import annotations

from collections.abc import Iterator
from concurrent.futures import Executor
from contextlib import contextmanager
from importlib.metadata import version
from typing import Any

from lagrange.core.diagnostics import Diagnostic, ProblemError

PATIENCE = 20
"""Seconds in which scheduler and workers must answer."""


@contextmanager
def cluster(address: str) -> Iterator[tuple[Executor, int]]:
    """The executor of the scheduler at an address, and the number of its threads.

    Raises ProblemError where it cannot be reached, or its workers have another lagsolve.
    """
    try:
        from distributed import Client
        from distributed.comm import get_address_host_port
    except ImportError:
        help_ = "pip install 'lagsolve[cluster]', here and on the cluster"
        raise ProblemError(Diagnostic("no-cluster", "--dask needs the package `distributed`", help=help_)) from None
    try:
        get_address_host_port(address)  # a client that begins with nonsense does not end well
        client = Client(address, timeout=PATIENCE, set_as_default=False)
    except (OSError, ValueError, TypeError) as error:
        message = f"there is no Dask scheduler at {address}: {_said(error)}"
        raise ProblemError(Diagnostic("no-cluster", message, help="an address is like tcp://host:8786")) from None
    with client:
        threads = _threads(client, address)
        executor = client.get_executor(pure=False)
        try:
            yield executor, threads
        finally:
            executor.shutdown(wait=False)  # which cancels what is still to be done


def _threads(client: Any, address: str) -> int:
    try:
        client.wait_for_workers(1, timeout=PATIENCE)
        versions = set(client.run(_version).values())
    except Exception as error:
        message = f"the workers at {address} cannot grade: {_said(error)}"
        help_ = f"they need lagsolve {version('lagsolve')} and what it needs"
        raise ProblemError(Diagnostic("no-cluster", message, help=help_)) from None
    if versions != {version("lagsolve")}:
        message = f"the workers at {address} have lagsolve {', '.join(sorted(versions))}, not {version('lagsolve')}"
        raise ProblemError(Diagnostic("no-cluster", message, help="install the same version everywhere"))
    threads: int = sum(client.nthreads().values())
    return max(1, threads)


def _version() -> str:
    return version("lagsolve")


def _said(error: Exception) -> str:
    return " ".join(f"{type(error).__name__}: {error}".split())[:200]
