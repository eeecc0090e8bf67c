"""Sleeps in loops: how long all of them take, and which are the exception."""

from __future__ import annotations

import math

import pytest

from api_calls import call_in
from archlint.execution.loop_times import in_loops, watches_the_clock
from archlint.execution.retries import gives_up_loudly, is_retry, reads_until_it_has
from archlint.execution.sleeps import Stay


def seconds(source: str, each: float = 0.5) -> float:
    return in_loops(*call_in(source, "sleep"), Stay("sleep", each, "sleeps"))


@pytest.mark.parametrize(
    ("source", "expected"),
    [
        ("sleep()", 0.5),
        ("for _ in range(4):\n    sleep()", 2.0),
        ("for _ in range(1, 4):\n    sleep()", 1.5),
        ("for _ in range(2):\n    for _ in range(3):\n        sleep()", 3.0),
        ("while port.in_waiting:\n    sleep()", 0.5),
        ("while moving():\n    sleep()", math.inf),
        ("for item in items:\n    sleep()", math.inf),
        ("for _ in range(count):\n    sleep()", math.inf),
    ],
)
def test_rounds_multiply_a_sleep(source: str, expected: float) -> None:
    assert seconds(source) == expected


def test_a_tiny_pause_between_items_stays_tiny() -> None:
    assert seconds("for item in items:\n    sleep()", 0.01) == 0.01
    assert seconds("while moving():\n    sleep()", 0.01) == math.inf


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        ("if send():\n        break\n    sleep()", True),
        ("try:\n        return send()\n    except OSError:\n        sleep()", True),
        ("with lock:\n        if send():\n            break\n    sleep()", True),
        ("send()\n    sleep()", False),
        ("for item in items:\n        break\n    sleep()", False),
        ("if send():\n        continue\n    sleep()", False),
    ],
)
def test_a_for_that_success_ends_is_a_retry(body: str, expected: bool) -> None:
    assert is_retry(*call_in(f"for _ in range(3):\n    {body}", "sleep")) is expected


def test_a_while_is_no_retry() -> None:
    assert not is_retry(*call_in("while True:\n    if send():\n        break\n    sleep()", "sleep"))


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        ("if frame is not None:\n            return frame", True),
        ("if frame is None:\n            sleep()\n            continue\n        return frame", True),
        ("with lock:\n            if frame is not None:\n                return frame", True),
        ("if ready:\n            return frame", False),
        ("if frame is not None:\n            return 0", False),
        ("if frame is not None:\n            log(frame)", False),
    ],
)
def test_a_loop_that_returns_what_it_has_read(body: str, expected: bool) -> None:
    pause = "" if "sleep" in body else "\n        sleep()"
    source = f"def read(self):\n    while True:\n        frame = camera.read()\n        {body}{pause}"
    assert reads_until_it_has(*call_in(source, "sleep")) is expected


@pytest.mark.parametrize(("test", "expected"), [("time.time() < end", True), ("moving()", False), ("now()", False)])
def test_a_loop_that_compares_the_time(test: str, expected: bool) -> None:
    assert watches_the_clock(*call_in(f"while {test}:\n    sleep()", "sleep")) is expected


@pytest.mark.parametrize(
    ("test", "late", "each", "expected"),
    [
        ("time.time() > end", "raise TimeoutError", 0.001, True),
        ("time.time() > end", "break", 0.001, False),
        ("port.closed", "raise OSError", 0.001, False),
        ("time.time() > end", "raise TimeoutError", 0.5, False),
    ],
)
def test_a_loop_that_raises_once_it_is_late(test: str, late: str, each: float, expected: bool) -> None:
    text = f"while not port.ready:\n    sleep()\n    if {test}:\n        {late}"
    assert gives_up_loudly(*call_in(text, "sleep"), Stay("sleep", each, "sleeps")) is expected
