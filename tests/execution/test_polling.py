"""Loops that ask a service as fast as they can."""

from __future__ import annotations

import textwrap

import pytest

from api_calls import call_in
from archlint.execution.polling import is_unguarded, is_unpaced
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


# ---------------------------------------------------------------------------------------- what decides a request


def decided_by_readiness(source: str) -> bool:
    """Whether nothing else decides about the call of ``ask()`` in a function."""
    return is_unguarded(*call_in("def tick(self):\n" + textwrap.indent(source, "    "), "ask"))


UNGUARDED = {
    "nothing in front": "ask()",
    "only if the service is there": "if client.service_is_ready():\n    ask()",
    "left where the service is not there": "if not client.service_is_ready():\n    return\nask()",
    "left while the last answer is missing": (
        "if self.future is not None and not self.future.done():\n    return\nask()"
    ),
    "in a with": "with lock:\n    ask()",
    "in a try": "try:\n    ask()\nexcept ValueError:\n    pass",
    "behind an if that both ways pass": "if moved:\n    log()\nask()",
    "in the test": "if ask():\n    log()",
    "each round of a loop": "while True:\n    ask()",
}


@pytest.mark.parametrize("source", UNGUARDED.values(), ids=UNGUARDED)
def test_only_readiness_decides_about_a_request(source: str) -> None:
    assert decided_by_readiness(source)


GUARDED = {
    "only if something moved": "if moved:\n    ask()",
    "left where nothing moved": "if not moved:\n    return\nask()",
    "left in a try": "try:\n    if not moved:\n        return\nfinally:\n    log()\nask()",
    "left in a nested branch": ("if not moved:\n    if tired:\n        return\n    raise ValueError\nask()"),
    "once for each item": "for item in items:\n    log()\n    if item:\n        ask()",
    "only after an error": "try:\n    log()\nexcept ValueError:\n    ask()",
    "next round first": "while True:\n    if not moved:\n        continue\n    ask()",
}


@pytest.mark.parametrize("source", GUARDED.values(), ids=GUARDED)
def test_something_else_decides_about_a_request(source: str) -> None:
    assert not decided_by_readiness(source)


@pytest.mark.parametrize(("way", "expected"), [("self.send()", True), ("if moved:\n        self.send()", False)])
def test_the_caller_may_decide(way: str, expected: bool) -> None:
    source = f"def tick(self):\n    {way}\n\ndef send(self):\n    ask()"
    assert is_unguarded(*call_in(source, "ask", "send")) is expected
