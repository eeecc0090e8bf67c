"""Stand-in for rclpy.executors: spinning returns at once."""

from __future__ import annotations

from typing import Any

from benchmarks.accuracy.oracle.sandbox import waited

from .context import get_default_context
from .task import Task


class ExternalShutdownException(Exception):
    """ROS was shut down from outside."""


class ShutdownException(Exception):
    """The executor was shut down."""


class TimeoutException(Exception):
    """It took too long."""


class ConditionReachedException(Exception):
    """Done."""


class InvalidHandle(Exception):
    """A destroyed entity was used."""


class TimeoutObject:
    """A time limit."""

    def __init__(self, timeout: float) -> None:
        self.timeout = timeout


class Executor:
    """An executor that runs nothing; what it should run is kept until the program has ended."""

    def __init__(self, *_: object, context: Any = None, **__: object) -> None:
        self._context = context or get_default_context()
        self._added: list[Any] = []

    @property
    def context(self) -> Any:
        """The context."""
        return self._context

    def add_node(self, node: Any) -> bool:
        """Take a node."""
        self._added.append(node)
        node.executor = self
        return True

    def remove_node(self, node: Any) -> None:
        """Let a node go."""
        if node in self._added:
            self._added.remove(node)

    def get_nodes(self) -> list[Any]:
        """The nodes."""
        return list(self._added)

    def create_task(self, callback: Any, *args: Any, **kwargs: Any) -> Task:
        """Run it later."""
        return Task(callback, args, kwargs)

    def spin(self) -> None:
        """Return at once."""
        waited(2)

    def spin_once(self, timeout_sec: object = None) -> None:
        """Return at once."""
        waited(2)

    def spin_until_future_complete(self, future: object, timeout_sec: object = None) -> None:
        """Return at once."""
        waited(2)

    def spin_once_until_future_complete(self, future: object, timeout_sec: object = None) -> None:
        """Return at once."""
        waited(2)

    def shutdown(self, timeout_sec: object = None) -> bool:
        """Down."""
        return True

    def wake(self) -> None:
        """Awake."""

    def __enter__(self) -> Any:
        return self

    def __exit__(self, *exc: object) -> None:
        return None


class SingleThreadedExecutor(Executor):
    """One thread."""


class MultiThreadedExecutor(Executor):
    """Several threads."""


class EventsExecutor(Executor):
    """Driven by events."""


async def await_or_execute(callback: Any, *args: Any) -> Any:
    """Call it, and wait for it where that is needed."""
    result = callback(*args)
    return await result if hasattr(result, "__await__") else result
