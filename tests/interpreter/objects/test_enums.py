"""Enums: their members, values and names, held against Python itself."""

from __future__ import annotations

import pytest

from interpreting import OUTSIDE, WITH_LIBRARIES, assert_like_python, in_python, interpret

KINDS = """
from enum import Enum, Flag, IntEnum, IntFlag, StrEnum, auto

class Mode({base}):
{body}
values = [mode.value for mode in Mode]
names = [mode.name for mode in Mode]
"""


def enum(base: str, *lines: str) -> str:
    return KINDS.format(base=base, body="".join(f"    {line}\n" for line in lines))


@pytest.mark.parametrize(
    ("base", "lines"),
    [
        ("Enum", ["IDLE = auto()", "BUSY = auto()"]),
        ("Enum", ["IDLE = 5", "BUSY = auto()", "DONE = auto()"]),
        ("IntEnum", ["IDLE = 0", "BUSY = auto()"]),
        ("Flag", ["LEFT = auto()", "RIGHT = auto()", "BACK = auto()"]),
        ("IntFlag", ["LEFT = 4", "RIGHT = auto()"]),
        ("StrEnum", ["LEFT = auto()", "RIGHT = 'r'"]),
        ("StrEnum", ["LEFT = 'l'", "FarRight = auto()"]),
    ],
)
def test_what_auto_stands_for(base: str, lines: list[str]):
    assert_like_python(enum(base, *lines), WITH_LIBRARIES)


@pytest.mark.parametrize(
    "lines",
    [
        ["A = 'a'", "B = auto()"],
        ["A = 2", "B = 1", "C = auto()"],
        ["A = outside.value()", "B = auto()"],
    ],
)
def test_what_auto_stands_for_after_other_values_is_not_said(lines: list[str]):
    found = interpret(f"{OUTSIDE}{enum('Enum', *lines)}last = list(Mode)[-1].value", WITH_LIBRARIES)
    assert not found.is_known("last")
    assert found.constant("names") == [line.partition(" ")[0] for line in lines]


def test_methods_and_properties_of_members():
    assert_like_python(
        """
        from enum import Enum

        class Topic(Enum):
            SCAN = 'scan'
            ODOM: str = 'odom'

            def full(self):
                return '/robot/' + self.value

            @classmethod
            def first(cls):
                return cls.SCAN

            @property
            def letter(self):
                return self.name.lower()[0]

        full = [topic.full() for topic in Topic]
        first = Topic.first().value
        letter = Topic.ODOM.letter
        through_a_member = Topic.SCAN.first().full()
        """
    )


def test_a_base_without_members_gives_its_methods():
    assert_like_python(
        """
        from enum import Enum

        class Named(Enum):
            def low(self):
                return self.name.lower()

        class Mode(Named):
            IDLE = 1
            BUSY = 2

        low = [mode.low() for mode in Mode]
        """
    )


def test_members_as_keys_and_in_choices():
    assert_like_python(
        """
        from enum import Enum

        class Mode(Enum):
            IDLE = 1
            BUSY = 2

        speeds = {Mode.IDLE: 0.0, Mode.BUSY: 1.5}
        speed = speeds[Mode.BUSY]
        of_all = {mode.name: speeds[mode] for mode in Mode}
        among = Mode.BUSY in (Mode.IDLE, Mode.BUSY), Mode.IDLE in (Mode.BUSY,)
        chosen = 'slow' if Mode.IDLE == Mode.BUSY else 'fast'
        other = Mode.IDLE != Mode.BUSY, Mode.IDLE is Mode.IDLE
        """
    )


@pytest.mark.parametrize("asked", ["Mode(2)", "Mode['BUSY']", "Mode.BUSY", "Mode(Mode.BUSY.value)", "Mode('two')"])
def test_each_way_to_a_member(asked: str):
    source = (
        f"from enum import Enum\nclass Mode(Enum):\n    IDLE = 1\n    BUSY = {2 if 'two' not in asked else 'two'!r}\n"
    )
    source += f"it = {asked}.name, {asked} is Mode.BUSY"
    found = interpret(source)
    assert found.constant("it") == in_python(source)["it"]


def test_a_value_that_two_names_have_belongs_to_the_first():
    assert_like_python(
        """
        from enum import Enum

        class Mode(Enum):
            IDLE = 'idle'
            REST = 'idle'

        name = Mode('idle').name
        by_name = Mode['REST'].name
        count = len(Mode)
        """
    )


def test_a_value_that_no_member_has_leaves_them_all():
    """Python raises there; a program that goes on has one of the members."""
    found = interpret("from enum import Enum\nclass Mode(Enum):\n    IDLE = 1\n    BUSY = 2\nit = Mode(7).name")
    assert found.options("it") == {"IDLE", "BUSY"}


def test_a_name_that_is_not_known_may_be_each_member():
    source = "class Mode(Enum):\n    IDLE = 1\n    BUSY = 2\nit = Mode(outside.number()).name"
    assert interpret(f"{OUTSIDE}from enum import Enum\n{source}").options("it") == {"IDLE", "BUSY"}


def test_an_enum_without_members_has_none_to_give():
    found = interpret("from enum import Enum\nclass Mode(Enum):\n    pass\nit = Mode(1)")
    assert not found.is_known("it")


def test_names_that_are_no_members():
    assert_like_python(
        """
        from enum import Enum

        class Mode(Enum):
            IDLE = 1
            hint: str

            def limit(self):
                return 3

        names = [mode.name for mode in Mode]
        limit = Mode.IDLE.limit()
        """
    )


def test_members_that_are_texts_or_numbers():
    assert_like_python(
        """
        from enum import Enum, IntEnum

        class Topic(str, Enum):
            SCAN = 'scan'

        class Depth(IntEnum):
            LOW = 1
            HIGH = 10

        topic = f'/robot/{Topic.SCAN.value}'
        joined = '/robot/' + Topic.SCAN
        depths = [depth.value * 2 for depth in Depth]
        """
    )


@pytest.mark.parametrize("bases", ["Enum", "IntEnum", "int, Enum", "str, Enum"])
@pytest.mark.parametrize("test", ["Mode.IDLE == 1", "1 != Mode.IDLE", "Mode.IDLE.value == 1", "Mode.IDLE == None"])
def test_whether_a_member_equals_what_it_stands_for(bases: str, test: str):
    """It does where its class is one of numbers or texts, too; what is not followed there is not said."""
    source = f"""
from enum import Enum, IntEnum

class Mode({bases}):
    IDLE = {"'1'" if "str" in bases else 1}

it = 'yes' if {test} else 'no'
"""
    found = interpret(source, WITH_LIBRARIES)
    assert in_python(source)["it"] in found.options("it")
    if bases == "Enum":
        assert_like_python(source, WITH_LIBRARIES)
