"""An existing Dask cluster as a pool (``archlint[dask]``).  Nothing of Dask is imported before it is asked for."""

from __future__ import annotations

import logging
import warnings
from collections.abc import Callable, Iterator
from concurrent.futures import Future
from contextlib import contextmanager
from typing import Any

from archlint.engine.executors import ExecutorPool, PoolError
from archlint.engine.link_part import link_part

TIMEOUT = 10
"""Seconds to wait for the scheduler, and then for a worker of it."""


class _ByName:
    """An executor of Dask that sends functions by their names: the scheduler itself would resolve a reference to one,
    and it has no need of archlint."""

    def __init__(self, executor: Any) -> None:
        self._executor = executor

    def submit(self, function: Callable[[str, bytes], bytes], /, *arguments: object) -> Future[bytes]:
        call = lambda module, name, *given: getattr(__import__(module, fromlist=[name]), name)(*given)  # noqa: E731
        future: Future[bytes] = self._executor.submit(call, function.__module__, function.__qualname__, *arguments)
        return future


@contextmanager
def dask_cluster(address: str) -> Iterator[ExecutorPool]:
    """The workers of a scheduler.  Raises :class:`~archlint.engine.executors.PoolError`."""
    client = _client(address)
    try:
        client.wait_for_workers(1, timeout=TIMEOUT)
    except Exception:
        client.close(timeout=1)
        raise PoolError(f"the scheduler at {address} has no worker: start one with `dask worker {address}`") from None
    try:
        with warnings.catch_warnings():
            warnings.filterwarnings("ignore", "Sending large graph", UserWarning)
            executor, width = _ByName(client.get_executor(pure=False)), max(1, len(client.nthreads()))
            yield ExecutorPool(executor, link_part, width, lambda: _trouble(client, address))
    finally:
        client.close(timeout=1)


def _client(address: str) -> Any:
    try:
        import dask
        import distributed
    except ImportError:
        raise PoolError("it needs Dask, which is not installed: pip install 'archlint[dask]'") from None
    logging.getLogger("distributed").setLevel(logging.CRITICAL)  # what goes wrong is told here
    dask.config.set({"distributed.comm.timeouts.connect": f"{TIMEOUT}s"})
    client: Any = distributed.Client  # it has no types
    try:
        return client(address, timeout=TIMEOUT, set_as_default=False)
    except Exception as error:  # an address may be wrong in many ways
        why = str(error) or type(error).__name__
        raise PoolError(f"no Dask scheduler answers at {address}: {why}") from None


def _trouble(client: Any, address: str) -> str | None:
    """Why nobody works; None where somebody may."""
    try:
        if client.status == "running" and client.nthreads():
            return None
    except Exception:
        return f"the scheduler at {address} does not answer any more"
    gone = "does not answer any more" if client.status != "running" else "has no worker any more"
    return f"the scheduler at {address} {gone}"


__all__ = ["dask_cluster"]
