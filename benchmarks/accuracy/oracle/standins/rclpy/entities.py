"""Stand-ins for what the create methods of a node return."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from benchmarks.accuracy.oracle.later import finished
from benchmarks.accuracy.oracle.sandbox import waited
from benchmarks.accuracy.oracle.unknown import Unknown

from .task import Future


class Entity:
    """Anything that a node holds."""

    def __init__(self, **attributes: Any) -> None:
        vars(self).update(attributes)

    def destroy(self) -> None:
        """Destroyed or not, it was created."""

    def __enter__(self) -> Any:
        return self

    def __exit__(self, *exc: object) -> None:
        return None

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        return Unknown(f"{type(self).__name__}.{name}")


class Publisher(Entity):
    """Swallows what is published."""

    def publish(self, msg: object) -> None:
        """Nobody listens."""

    def get_subscription_count(self) -> int:
        """Somebody listens, or a loop would wait."""
        return 1

    def assert_liveliness(self) -> None:
        """Alive."""

    def wait_for_all_acked(self, *_: object, **__: object) -> bool:
        """All is acknowledged."""
        return True


class Subscription(Entity):
    """Receives nothing."""

    def get_publisher_count(self) -> int:
        """Somebody talks, or a loop would wait."""
        return 1


class Service(Entity):
    """Is never called."""


class Client(Entity):
    """Gets its answers at once; what they hold is unknown."""

    def service_is_ready(self) -> bool:
        """The server is there."""
        return True

    def wait_for_service(self, timeout_sec: object = None) -> bool:
        """The server is there."""
        waited(2)
        return True

    def call(self, request: object, timeout_sec: object = None) -> Any:
        """An answer."""
        return self._answer()

    def call_async(self, request: object) -> Future:
        """An answer."""
        return finished(self._answer())

    def remove_pending_request(self, future: object) -> None:
        """Nothing is pending."""

    def _answer(self) -> Any:
        response = getattr(self.srv_type, "Response", None)
        return response() if callable(response) else Unknown("response")


class Timer(Entity):
    """Never fires of itself."""

    def cancel(self) -> None:
        """Stop."""

    def reset(self) -> None:
        """Start again."""

    def is_canceled(self) -> bool:
        """Not cancelled."""
        return False

    def is_ready(self) -> bool:
        """Ready."""
        return True

    def call(self) -> None:
        """Nothing happens."""

    def time_until_next_call(self) -> int:
        """At once."""
        return 0

    def time_since_last_call(self) -> int:
        """Just now."""
        return 0


class Rate(Entity):
    """Does not wait."""

    def sleep(self) -> None:
        """Do not wait."""
        waited(2)


class GuardCondition(Entity):
    """Never triggered."""

    def trigger(self) -> None:
        """Nothing happens."""


ClientCallback = Callable[..., Any]
