"""Data classes and named tuples: what their constructors set, held against Python itself."""

from __future__ import annotations

import pytest

from interpreting import OUTSIDE, WITH_LIBRARIES, assert_like_python, interpret


def test_fields_by_place_by_name_and_by_default():
    assert_like_python(
        """
        from dataclasses import dataclass

        @dataclass
        class Topic:
            name: str
            depth: int = 10
            latched: bool = False

        plain = Topic('scan')
        by_place = Topic('scan', 5, True)
        by_name = Topic(latched=True, name='map')
        plain_fields = plain.name, plain.depth, plain.latched
        place_fields = by_place.name, by_place.depth, by_place.latched
        name_fields = by_name.name, by_name.depth, by_name.latched
        """
    )


def test_each_object_has_a_collection_of_its_own():
    assert_like_python(
        """
        from dataclasses import dataclass, field

        def start():
            return {'x': 0}

        @dataclass
        class Path:
            points: list = field(default_factory=list)
            origin: dict = field(default_factory=start)
            frames: list = field(default_factory=lambda: ['map'])
            closed: bool = field(default=False)

        one, other = Path(), Path(points=[9])
        one.points.append(1)
        one.origin['x'] = 5
        one.frames.append('odom')
        of_one = one.points, one.origin, one.frames, one.closed
        of_other = other.points, other.origin, other.frames, other.closed
        """,
        WITH_LIBRARIES,
    )


def test_fields_of_base_classes_come_first():
    assert_like_python(
        """
        from dataclasses import dataclass

        @dataclass
        class Named:
            space: str = 'a'
            number: int = 0

        @dataclass
        class Topic(Named):
            name: str = 't'
            space: str = 'z'

        class Plain(Topic):
            pass

        given, plain, default = Topic('r', 2, 'q'), Plain('s', name='n'), Topic()
        of_given = given.space, given.number, given.name
        of_plain = plain.space, plain.number, plain.name
        of_default = default.space, default.number, default.name
        """
    )


def test_what_is_set_after_the_fields():
    assert_like_python(
        """
        from dataclasses import dataclass

        @dataclass(frozen=True)
        class Topic:
            space: str
            name: str = 'scan'

            def __post_init__(self):
                object.__setattr__(self, 'full', f'/{self.space}/{self.name}')

            @property
            def depth(self):
                return len(self.full)

        topic = Topic('robot')
        full, depth = topic.full, topic.depth
        """
    )


def test_a_constructor_of_its_own_is_what_is_called():
    assert_like_python(
        """
        from dataclasses import dataclass

        @dataclass
        class Size:
            wide: int
            high: int

            def __init__(self, both):
                self.wide = self.high = both

        size = Size(4)
        sides = size.wide, size.high
        """
    )


@pytest.mark.parametrize(
    "declared",
    ["x: int", "x: int = field()", "x: int = field(default=outside.value())", "x: int = outside.value()"],
)
def test_a_field_that_nothing_gives_a_value_is_not_known(declared: str):
    found = interpret(
        f"{OUTSIDE}from dataclasses import dataclass, field\n@dataclass\nclass It:\n    {declared}\nx = It().x",
        WITH_LIBRARIES,
    )
    assert not found.is_known("x")


def test_names_that_are_passed_on_may_fill_each_field():
    found = interpret(
        f"{OUTSIDE}from dataclasses import dataclass\n@dataclass\nclass Point:\n    x: int = 1\n    y: int = 2\n"
        "point = Point(**outside.value())\nnamed = Point(y=3, **outside.value())\n"
        "x, y, kept = point.x, point.y, named.y"
    )
    assert not found.is_known("x")
    assert not found.is_known("y")
    assert found.constant("kept") == 3


def test_a_named_tuple_is_its_fields_in_their_order():
    assert_like_python(
        """
        from typing import NamedTuple

        class Goal(NamedTuple):
            frame: str
            x: float = 0.0
            y: float = 0.0

            def text(self):
                return f'{self.frame}:{self.x}'

        goal = Goal('map', y=2.5)
        frame, x, y = goal
        text = goal.text()
        ends = goal[0], goal[-1], goal[2]
        listed, count = list(goal), len(goal)
        pairs = [(number, value) for number, value in enumerate(goal)]
        """
    )


def test_there_is_no_item_behind_the_last_field():
    found = interpret(
        "from typing import NamedTuple\nclass Goal(NamedTuple):\n    x: int\n    y: int\nit = Goal(1, 2)[5]"
    )
    assert found.reason("it") == "the item does not exist"
