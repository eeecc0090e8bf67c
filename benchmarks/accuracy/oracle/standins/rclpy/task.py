"""Stand-in for rclpy.task: what an executor would run later is kept for later."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from benchmarks.accuracy.oracle.record import recorder


class Future:
    """A result that may come; what is answered from outside is answered at once."""

    def __init__(self, *, executor: object = None) -> None:
        self._finished = False
        self._cancelled = False
        self._result: Any = None
        self._failure: BaseException | None = None
        self._callbacks: list[Callable[[Any], Any]] = []

    def done(self) -> bool:
        """Whether there is a result."""
        return self._finished or self._cancelled

    def cancelled(self) -> bool:
        """Whether it was cancelled."""
        return self._cancelled

    def cancel(self) -> None:
        """Cancel."""
        self._cancelled = not self._finished

    def result(self) -> Any:
        """The result, or None."""
        if self._failure is not None:
            raise self._failure
        return self._result

    def exception(self) -> BaseException | None:
        """The exception, or None."""
        return self._failure

    def set_result(self, result: Any) -> None:
        """Answer."""
        self._result, self._finished = result, True
        for callback in self._callbacks:
            recorder.tasks.append((callback, (self,)))
        self._callbacks.clear()

    def set_exception(self, exception: BaseException) -> None:
        """Answer with a failure."""
        self._failure, self._finished = exception, True

    def add_done_callback(self, callback: Callable[[Any], Any]) -> None:
        """Call back once answered."""
        if self._finished:
            recorder.tasks.append((callback, (self,)))
        else:
            self._callbacks.append(callback)

    def remove_done_callback(self, callback: Callable[[Any], Any]) -> bool:
        """Do not call back."""
        if callback in self._callbacks:
            self._callbacks.remove(callback)
            return True
        return False

    def __await__(self) -> Iterator[Any]:
        return self.result()
        yield  # a generator that ends at once

    def __bool__(self) -> bool:
        return True


class Task(Future):
    """A callable that an executor runs later."""

    def __init__(self, handler: Any, args: Any = None, kwargs: Any = None, executor: object = None) -> None:
        super().__init__()
        self._handler = handler
        recorder.tasks.append((self._run, (args or (), kwargs or {})))

    def __call__(self) -> None:
        return None

    def _run(self, args: Any, kwargs: Any) -> Any:
        result = self._handler(*args, **kwargs) if callable(self._handler) else self._handler
        if not hasattr(result, "__await__"):
            self.set_result(result)
        return result
