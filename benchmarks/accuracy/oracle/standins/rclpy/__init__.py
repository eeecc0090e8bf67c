"""A recording stand-in for rclpy: nodes are created for real, nothing is sent, nothing waits."""

from __future__ import annotations

from typing import Any

from benchmarks.accuracy.oracle.sandbox import still_up, waited

from .context import Context, get_default_context
from .executors import Executor, SingleThreadedExecutor
from .node import Node
from .parameter import Parameter
from .signals import SignalHandlerOptions
from .task import Future

_executor: Executor | None = None


class InitContextManager:
    """What `rclpy.init()` gives for use with `with`."""

    def __init__(self, context: Context) -> None:
        self.context = context

    def __enter__(self) -> Any:
        return self

    def __exit__(self, *exc: object) -> None:
        self.context.shutdown()


def init(
    *, args: Any = None, context: Any = None, domain_id: Any = None, signal_handler_options: Any = None
) -> InitContextManager:
    """Up."""
    context = context or get_default_context()
    context.init()
    return InitContextManager(context)


def ok(*, context: Any = None) -> bool:
    """Up, a few times at each place."""
    return still_up()


def shutdown(*, context: Any = None, uninstall_handlers: Any = None) -> None:
    """Down."""
    (context or get_default_context()).shutdown()


def try_shutdown(*, context: Any = None, uninstall_handlers: Any = None) -> None:
    """Down."""
    (context or get_default_context()).shutdown()


def create_node(node_name: str, **options: Any) -> Node:
    """A node by name."""
    return Node(node_name, **options)


def get_global_executor() -> Executor:
    """The one executor."""
    global _executor
    _executor = _executor or SingleThreadedExecutor()
    return _executor


def spin(node: Any, executor: Any = None) -> None:
    """Return at once."""
    waited(2)


def spin_once(node: Any, *, executor: Any = None, timeout_sec: Any = None) -> None:
    """Return at once."""
    waited(2)


def spin_until_future_complete(node: Any, future: Any, executor: Any = None, timeout_sec: Any = None) -> None:
    """Return at once."""
    waited(2)


def get_rmw_implementation_identifier() -> str:
    """The default middleware."""
    return "rmw_fastrtps_cpp"


__all__ = [
    "Context",
    "Executor",
    "Future",
    "Node",
    "Parameter",
    "SignalHandlerOptions",
    "create_node",
    "get_default_context",
    "get_global_executor",
    "init",
    "ok",
    "shutdown",
    "spin",
    "spin_once",
    "spin_until_future_complete",
    "try_shutdown",
]
