"""What the machine knows of Python's own library: as Python has it."""

from __future__ import annotations

import pytest

from interpreting import WITH_LIBRARIES, assert_like_python, in_python, interpret


def test_partial_functions():
    assert_like_python(
        """
        from functools import partial

        def f(a, b, c=0):
            return [a, b, c]

        half = partial(f, 1, c=3)
        results = half(2), half(2, c=4), partial(half, 5)(c=1)
        """,
        WITH_LIBRARIES,
    )


@pytest.mark.parametrize(
    "source",
    [
        "from collections import defaultdict\nit = defaultdict(list)\nit['a'].append(1)\nx = it['a'], len(it)",
        "from collections import OrderedDict\nit = OrderedDict()\nit['a'] = 1\nx = it['a']",
    ],
)
def test_collections_of_other_kinds(source: str):
    assert interpret(source, WITH_LIBRARIES).constant("x") == in_python(source)["x"]


@pytest.mark.parametrize(
    ("base", "values"),
    [
        ("Enum", "A = 5\n    B = auto()\n    C = auto()"),
        ("Enum", "A = auto()\n    B = auto()"),
        ("IntFlag", "A = auto()\n    B = auto()\n    C = auto()"),
        ("Flag", "A = 4\n    B = auto()"),
    ],
)
def test_members_of_enums_that_count(base: str, values: str):
    assert_like_python(
        f"""
        from enum import Enum, Flag, IntFlag, auto

        class It({base}):
            {values.replace(chr(10), chr(10) + "        ")}

        held = [It.A.value, It.B.value]
        names = It.A.name, It['B'].name
        again = It(It.B.value) is It.B
        count = len(list(It))
        true = bool(It.A), bool(It.B)
        """,
        WITH_LIBRARIES,
    )


def test_dataclasses():
    assert_like_python(
        """
        from dataclasses import dataclass, field

        @dataclass
        class Point:
            x: int
            y: int = 2
            tags: list = field(default_factory=list)
            label: str = field(default='none')

            def __post_init__(self):
                self.sum = self.x + self.y

        @dataclass
        class Place(Point):
            name: str = 'here'

        first, second = Point(1), Point(x=3, y=4, tags=['t'])
        first.tags.append('own')
        fields = first.x, first.y, first.tags, first.label, first.sum
        others = second.x, second.y, second.tags, second.sum
        place = Place(1, 2, [], 'l', 'there').name, Place(9).name, Place(9).sum
        """,
        WITH_LIBRARIES,
    )


def test_environment_variables_that_each_process_of_ros_has():
    found = interpret("import os\nversion = os.environ['ROS_VERSION']\nhome = os.environ['HOME']", WITH_LIBRARIES)
    assert found.constant("version") == "2"
    assert found.reason("home") == "the environment variable HOME"


def test_what_curses_calls_with_its_screen():
    source = """
    import curses

    def run(screen, rate, depth=1):
        return [rate, depth]

    it = curses.wrapper(run, 5, depth=2)
    """
    assert interpret(source, WITH_LIBRARIES).constant("it") == [5, 2]
