"""API002: attributes that a constructor reads before it assigns them."""

from __future__ import annotations

import pytest

from checks.judging import Judge

NODE = """
from rclpy.node import Node
from std_msgs.msg import String


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
{body}

    def start(self):
        {start}
"""


def _node(*lines: str, start: str = "pass") -> str:
    return NODE.format(body="\n".join(f"        {line}" for line in lines), start=start)


def test_a_read_above_the_assignment(judge: Judge):
    (finding,) = judge(
        "API002",
        _node(
            "self.timer = self.create_timer(self.period, self.start)  # here",
            "self.period = 1.0",
        ),
    )
    assert finding.message == "Talker assigns self.period only later: this line fails with an AttributeError"
    assert finding.help == "assign self.period before this line"
    assert [(row.place.line, row.message) for row in finding.related] == [(9, "it gets its first value here")]


def test_all_that_a_class_reads_too_early_is_one_finding(judge: Judge):
    (finding,) = judge(
        "API002", _node("self.all = [self.first, self.second]  # here", "self.first = 1", "self.second = 2")
    )
    assert finding.message.endswith("; another attribute of the class is read too early")


def test_a_method_that_the_constructor_calls_too_early(judge: Judge):
    (finding,) = judge(
        "API002",
        _node("self.start()", "self.period = 1.0", start="self.create_timer(self.period, self.start)  # here"),
    )
    assert finding.message == (
        "Talker assigns self.period only after its __init__() has called start(), which fails here with an "
        "AttributeError"
    )
    assert finding.help == "assign self.period before the call of start()"
    assert [row.place.line for row in finding.related] == [9, 8]


@pytest.mark.parametrize(
    "lines",
    [
        ("self.count += 1  # here", "self.count = 0"),
        ("if self.count:  # here", "    self.start()", "self.count = 0"),
        ("self.names['a'] = 1  # here", "self.names = {}"),
        ("self.names = [name for name in self.names]  # here",),
        ("text = f'{self.count}'  # here", "self.count = len(text)"),
    ],
)
def test_every_way_to_read_it(judge: Judge, lines: tuple[str, ...]):
    judge("API002", _node(*lines))


@pytest.mark.parametrize(
    "lines",
    [
        ("self.period = 1.0", "self.timer = self.create_timer(self.period, self.start)"),
        ("self.timer = self.create_timer(1.0, lambda: print(self.period))", "self.period = 1.0"),
        ("if self.has_parameter('x'):", "    self.period = 2.0", "print(self.period)", "self.period = 1.0"),
        ("for _ in range(2):", "    if _:", "        print(self.period)", "    self.period = 1.0"),
        ("if hasattr(self, 'period'):", "    print(self.period)", "self.period = 1.0"),
        ("print(getattr(self, 'period', 0))", "self.period = 1.0"),
        ("try:", "    print(self.period)", "except AttributeError:", "    pass", "self.period = 1.0"),
        ("with open('a') as self.file:", "    print(self.file)"),
        ("for self.index in range(3):", "    print(self.index)"),
        ("def start():", "    self.period = 1.0", "start()", "print(self.period)", "self.period = 2.0"),
        ("self.period: float", "self.period = 1.0"),
        ("print(self.start)", "self.start = None"),
        ("print(self.handle, self._clock)", "self._clock = None"),
    ],
)
def test_what_has_a_value_when_it_is_read(judge: Judge, lines: tuple[str, ...]):
    judge("API002", _node(*lines))


@pytest.mark.parametrize("call", ["self.start()", "self.create_timer(1.0, self.start)", "prepare(self)"])
def test_a_value_that_something_called_before_may_set(judge: Judge, call: str):
    prepare = "def prepare(node):\n    node.period = 1.0\n"
    judge(
        "API002",
        _node(call, "print(self.period)", "self.period = 2.0", start="self.period = 1.0") + "\n\n" + prepare,
    )


def test_a_method_that_need_not_read_it(judge: Judge):
    start = "print(self.ready and self.period)"
    judge("API002", _node("self.ready = False", "self.start()", "self.period = 1.0", start=start))
    start = "self.create_timer(1.0, lambda: self.period)"
    judge("API002", _node("self.start()", "self.period = 1.0", start=start))


BASE = """
from rclpy.node import Node


class Base(Node):
    {attribute}

    def __init__(self):
        super().__init__('talker')
        {line}

    def prepare(self):
        pass


class Talker(Base):
    def __init__(self):
        {before}
        super().__init__()
        print(self.period){mark}
        self.period = 2.0

    def prepare(self):
        {inside}
"""


@pytest.mark.parametrize(
    "parts",
    [
        {"attribute": "period = 1.0"},
        {"line": "self.period = 1.0"},
        {"line": "self.prepare()", "inside": "self.period = 1.0"},
        {"before": "self.period = 1.0"},
        {"mark": "  # here"},
    ],
)
def test_what_a_base_class_gives(judge: Judge, parts: dict[str, str]):
    nothing = {"attribute": "pass", "line": "pass", "before": "pass", "inside": "pass", "mark": ""}
    judge("API002", BASE.format(**nothing | parts))


def test_a_class_that_others_derive_from_and_one_of_unknown_bases(judge: Judge):
    derived = """

class Loud(Talker):
    def __init__(self):
        self.period = 3.0
        super().__init__()
"""
    early = _node("print(self.period)", "self.period = 1.0")
    judge("API002", early + derived)
    judge("API002", early.replace("from rclpy.node", "from somewhere") + "\n\nimport rclpy\nrclpy.init()\n")


SINGLETON = """
import rclpy


class Manager:
    _instance = None

    {new}

    def __init__(self):
        if self.ready:{here}
            return
        self.ready = True


Manager()
"""


@pytest.mark.parametrize(
    ("new", "here"),
    [
        (
            "def __new__(cls):\n        if cls._instance is None:\n            cls._instance = super().__new__(cls)\n"
            "            cls._instance.ready = False\n        return cls._instance",
            "",
        ),
        ("pass", "  # here"),
    ],
)
def test_one_object_for_all_calls(judge: Judge, new: str, here: str):
    """``__new__()`` has given it what its constructor reads."""
    judge("API002", SINGLETON.replace("{new}", new).replace("{here}", here))
