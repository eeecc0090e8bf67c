"""An existing Dask cluster as a pool (``archlint[dask]``).  Nothing of Dask is imported before it is asked for."""

from __future__ import annotations

import logging
import threading
import warnings
from collections.abc import Callable, Iterator
from concurrent.futures import Future
from concurrent.futures import TimeoutError as NotInTime
from contextlib import contextmanager, suppress
from typing import Any, TypeVar

from archlint.engine.executors import ExecutorPool, PoolError
from archlint.engine.link_part import link_part

TIMEOUT = 10
"""Seconds to wait for the scheduler, and then for a worker of it."""

_GRACE = 2
"""Seconds more for a call of Dask that keeps a time limit itself, so that it can say what it waited for."""

T = TypeVar("T")


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
        width = _workers(client, address)
        with warnings.catch_warnings():
            warnings.filterwarnings("ignore", "Sending large graph", UserWarning)
            executor = _ByName(client.get_executor(pure=False))
            yield ExecutorPool(executor, link_part, width, lambda: _trouble(client, address))
    finally:
        with suppress(Exception):  # whoever is gone need not be told
            _within(1 + _GRACE, lambda: client.close(timeout=1))


def _client(address: str) -> Any:
    try:
        import dask
        import distributed
    except ImportError:
        raise PoolError("it needs Dask, which is not installed: pip install 'archlint[dask]'") from None
    for name in ("distributed", "distributed.client"):  # what goes wrong is told here
        logging.getLogger(name).setLevel(logging.CRITICAL)
    dask.config.set({"distributed.comm.timeouts.connect": f"{TIMEOUT}s"})
    client: Any = distributed.Client  # it has no types
    try:
        return _within(TIMEOUT + _GRACE, lambda: client(address, timeout=TIMEOUT, set_as_default=False))
    except NotInTime:
        raise PoolError(f"no Dask scheduler answers at {address}: nothing came within {TIMEOUT} seconds") from None
    except Exception as error:  # an address may be wrong in many ways
        why = str(error) or type(error).__name__
        raise PoolError(f"no Dask scheduler answers at {address}: {why}") from None


def _workers(client: Any, address: str) -> int:
    """How many there are, once there is one."""
    try:
        _within(TIMEOUT + _GRACE, lambda: client.wait_for_workers(1, timeout=TIMEOUT))
        return max(1, len(_within(TIMEOUT, client.nthreads)))
    except Exception:
        if _trouble(client, address) == _silent(address):
            raise PoolError(_silent(address)) from None
        raise PoolError(f"the scheduler at {address} has no worker: start one with `dask worker {address}`") from None


def _trouble(client: Any, address: str) -> str | None:
    """Why nobody works; None where somebody may."""
    try:
        workers = client.status == "running" and _within(TIMEOUT, client.nthreads)
    except Exception:
        return _silent(address)
    if client.status != "running":
        return _silent(address)
    return None if workers else f"the scheduler at {address} has no worker any more"


def _silent(address: str) -> str:
    return f"the scheduler at {address} does not answer any more"


def _within(seconds: float, call: Callable[[], T]) -> T:
    """What a call of Dask returns.  Raises :class:`NotInTime`: several of them wait for ever for a scheduler that
    takes the connection and says nothing."""
    outcome: Future[T] = Future()
    threading.Thread(target=_settle, args=(outcome, call), daemon=True).start()  # nobody waits for it at the end
    return outcome.result(seconds)


def _settle(outcome: Future[T], call: Callable[[], T]) -> None:
    try:
        outcome.set_result(call())
    except BaseException as error:
        outcome.set_exception(error)


__all__ = ["dask_cluster"]
