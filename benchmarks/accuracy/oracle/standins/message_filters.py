"""Stand-in for message_filters."""

from __future__ import annotations

from typing import Any

from benchmarks.accuracy.oracle.later import nobody
from benchmarks.accuracy.oracle.record import recorder
from benchmarks.accuracy.oracle.unknown import Unknown
from rclpy.qos import QoSProfile


class SimpleFilter:
    """Calls back what is registered; once, after the program."""

    def __init__(self, *_: object, **__: object) -> None:
        self._messages = 1

    def registerCallback(self, cb: Any, *args: Any) -> int:
        """Call back later with as many messages as filters feed it."""
        messages = tuple(Unknown("message") for _ in range(self._messages))
        recorder.tasks.append((cb, messages + args))
        return 0

    def signalMessage(self, *_: object) -> None:
        """Nothing."""


class Subscriber(SimpleFilter):
    """Record a subscription."""

    def __init__(self, node: Any, msg_type: Any, topic: Any, qos_profile: Any = None, **kwargs: Any) -> None:
        super().__init__()
        self.node, self.topic = node, topic
        self.sub = node.create_subscription(msg_type, topic, nobody, qos_profile or QoSProfile(depth=10), **kwargs)

    def getTopic(self) -> Any:
        """The topic as it was written."""
        return self.topic

    get_topic = getTopic


class _Synchronizer(SimpleFilter):
    def __init__(self, fs: Any, *_: object, **__: object) -> None:
        super().__init__()
        self._messages = len(fs) if hasattr(fs, "__len__") else 1


class TimeSynchronizer(_Synchronizer):
    """Creates nothing."""


class ApproximateTimeSynchronizer(_Synchronizer):
    """Creates nothing."""


class LatestTimeSynchronizer(_Synchronizer):
    """Creates nothing."""


class Cache(SimpleFilter):
    """Creates nothing."""

    def __getattr__(self, name: str) -> Any:
        return Unknown(f"Cache.{name}")


class Chain(Cache):
    """Creates nothing."""


class TimeSequencer(SimpleFilter):
    """Record a timer on the node that it is given."""

    def __init__(
        self, input_filter: Any, delay: Any, update_rate: Any, queue_size: Any, node: Any = None, *_: object
    ) -> None:
        super().__init__()
        if node is not None:
            node.create_timer(0.1, nobody)
