"""Loops that wait for a server: what else may end them."""

from __future__ import annotations

import textwrap

import pytest

from archlint.execution.wait_loops import only_the_server_ends
from archlint.syntax import facts
from archlint.syntax.python.lowering import lower


def ends_by_server_alone(source: str) -> bool:
    [*_, loop] = lower(textwrap.dedent(source)).body
    assert isinstance(loop, (facts.While, facts.For))
    return only_the_server_ends(loop)


@pytest.mark.parametrize(
    "source",
    [
        "while not client.wait_for_service(timeout_sec=1.0):\n    pass",
        "while not self.client.wait_for_service(1.0):\n    self.get_logger().info(f'waiting {name}')",
        "while client.wait_for_service(1.0) == False:\n    print('waiting')",
        "while not (client.service_is_ready() and other.server_is_ready()):\n    time.sleep(1)",
        "while not (there := client.wait_for_server(1.0)):\n    continue",
        "while True:\n    if client.wait_for_service(1.0):\n        break\n    print('waiting')",
        "while 1:\n    if not client.service_is_ready():\n        time.sleep(1)\n    else:\n        return",
        "while not ready:\n    ready = client.wait_for_service(1.0)",
        "while not client.service_is_ready():\n    for _ in range(3):\n        break\n    rclpy.spin_once(node)",
        "while not client.service_is_ready():\n    count += 1",
        "while True:\n    with lock:\n        if client.service_is_ready():\n            break",
        "while True:\n    if not client.service_is_ready():\n        continue\n    break",
    ],
)
def test_only_the_server_ends(source: str) -> None:
    assert ends_by_server_alone(source)


@pytest.mark.parametrize(
    "source",
    [
        "while rclpy.ok() and not client.wait_for_service(1.0):\n    pass",
        "while client.wait_for_service(1.0):\n    pass",
        "while not client.wait_for_service(1.0):\n    if stop:\n        break",
        "while not client.wait_for_service(1.0):\n    if stop:\n        return",
        "while not client.wait_for_service(1.0):\n    raise RuntimeError",
        "while not client.wait_for_service(1.0):\n    check()",  # it may raise
        "while not client.wait_for_service(1.0):\n    try:\n        print('waiting')\n    finally:\n        pass",
        "while not client.wait_for_service(1.0):\n    assert count < 3",
        "while not client.wait_for_service(1.0):\n    for _ in tries():\n        pass",
        "while True:\n    client.wait_for_service(1.0)",
        "while True:\n    if client.wait_for_service(1.0):\n        print('there')",
        "while True:\n    if client.wait_for_service(1.0):\n        break\n    if stop:\n        break",
        "while not ready:\n    ready = client.wait_for_service(1.0) or stop",
        "while not ready:\n    pass",
        "for _ in range(3):\n    if client.wait_for_service(1.0):\n        break",
    ],
)
def test_something_else_may_end_it(source: str) -> None:
    assert not ends_by_server_alone(source)
