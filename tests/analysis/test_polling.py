"""Loops that ask a service as fast as they can."""

from __future__ import annotations

import pytest

from archlint.analysis.polling import is_unpaced
from archlint.syntax import facts
from archlint.syntax.python.lowering import lower


def unpaced(source: str) -> bool:
    [loop] = lower(source).body
    assert isinstance(loop, (facts.While, facts.For))
    return is_unpaced(loop)


@pytest.mark.parametrize(
    "source",
    [
        "while True:\n    client.call(request)",
        "while rclpy.ok():\n    client.call(request)",
        "while not client.service_is_ready():\n    client.call(request)",
        "while True:\n    for item in items:\n        if item:\n            break\n    client.call(request)",
        "while True:\n    if ready:\n        continue\n    client.call(request)",
    ],
)
def test_nothing_but_the_request_waits(source: str) -> None:
    assert unpaced(source)


@pytest.mark.parametrize(
    "source",
    [
        "while True:\n    client.call(request)\n    time.sleep(1.0)",
        "while True:\n    client.call(request)\n    rate.sleep()",
        "while True:\n    client.call(queue.get())",
        "while count < 3:\n    client.call(request)",
        "while rclpy.ok() and more():\n    client.call(request)",
        "while True:\n    client.call(request)\n    if done:\n        break",
        "while True:\n    client.call(request)\n    if done:\n        return",
        "while True:\n    client.call(request)\n    if failed:\n        raise RuntimeError",
        "for _ in range(3):\n    client.call(request)",
    ],
)
def test_something_paces_it_or_ends_it(source: str) -> None:
    assert not unpaced(source)
