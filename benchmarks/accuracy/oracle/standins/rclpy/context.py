"""Stand-in for rclpy.context."""

from __future__ import annotations

from typing import Any

from benchmarks.accuracy.oracle.sandbox import still_up


class Context:
    """A context that is always up."""

    def __init__(self, *_: object, **__: object) -> None:
        self._callbacks: list[Any] = []
        self._up = False
        self.handle = self

    def init(self, *_: object, **__: object) -> None:
        """Up; twice without an end in between is refused."""
        if self._up:
            raise RuntimeError("Context.init() must only be called once")
        self._up = True

    def ok(self) -> bool:
        """Up, a few times at each place."""
        return still_up()

    def shutdown(self) -> None:
        """Down; nothing depends on it, but that it may be up again."""
        self._up = False

    try_shutdown = shutdown

    def on_shutdown(self, callback: Any) -> None:
        """Nothing is shut down."""

    def track_node(self, node: object) -> None:
        """Nothing."""

    def untrack_node(self, node: object) -> None:
        """Nothing."""

    def get_domain_id(self) -> int:
        """The default domain."""
        return 0

    def __enter__(self) -> Any:
        return self

    def __exit__(self, *exc: object) -> None:
        return None


_default = Context()


def get_default_context(*, shutting_down: bool = False) -> Context:
    """The one context."""
    return _default
