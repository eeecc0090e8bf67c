"""What callbacks can be called with."""

from __future__ import annotations

import pytest

from archlint.python_code.signatures import Signature
from archlint.syntax import facts
from archlint.syntax.python.lowering import lower


def signature(params: str, bound: int = 0, given: str = "") -> Signature:
    """The signature of ``def f(params)``, with so many arguments bound in front and those ``given`` by name."""
    [function] = lower(f"def f({params}):\n    pass\n").body
    assert isinstance(function, facts.Function)
    return Signature(tuple(function.params), bound, frozenset(given.split()))


@pytest.mark.parametrize(
    ("params", "bound", "given", "counts"),
    [
        ("", 0, "", [0]),
        ("msg", 0, "", [1]),
        ("self, msg", 1, "", [1]),
        ("self, msg, info=None", 1, "", [1, 2]),
        ("self, *args", 1, "", [0, 1, 2, 3]),
        ("*args, topic", 0, "", []),
        ("*args, topic", 0, "topic", [0, 1, 2, 3]),
        ("msg, *, topic='/a'", 0, "", [1]),
        ("msg, topic", 0, "topic", [1]),
        ("msg, **more", 0, "", [1]),
        ("msg, /", 0, "", [1]),
        ("", 1, "", []),
    ],
)
def test_how_many_arguments_it_takes(params: str, bound: int, given: str, counts: list[int]) -> None:
    asked = signature(params, bound, given)
    assert [count for count in range(4) if asked.takes(count)] == counts


def test_what_is_left_of_it() -> None:
    asked = signature("self, msg, topic, *, node, depth=3", 1, "topic")
    assert asked.names == ["msg"]
    assert asked.needed_by_name == ["node"]
    assert asked.open_count == 4
    assert not asked.lacks_self


def test_a_method_that_does_not_take_self() -> None:
    assert signature("", 1).lacks_self
    assert not signature("self", 1).lacks_self


@pytest.mark.parametrize(
    ("params", "wants"),
    [
        ("self, info: TimerInfo", True),
        ("self, info: rclpy.timer.TimerInfo", True),
        ("self, info: 'TimerInfo'", False),
        ("self, info", False),
        ("self, TimerInfo: int", False),
    ],
)
def test_whether_it_wants_to_know_of_its_timer(params: str, wants: bool) -> None:
    assert signature(params, 1).wants_timer_info is wants
