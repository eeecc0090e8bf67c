"""What annotations tell of values that nobody here passes."""

from __future__ import annotations

import pytest

from archlint.interpreter.values import AttributeOf, ClassValue, Unknown
from interpreting import Interpreted, interpret

CLASSES = """
from typing import Annotated, Final, Optional
import names

class Arm:
    length = 1

    @property
    def hand(self):
        return self._hand

class Robot:
    arm: Arm
    count: int
"""


def meant(found: Interpreted, name: str) -> str | None:
    """The name of the class that an annotation tells of a value that is not known."""
    value = found.value(name)
    assert isinstance(value, Unknown)
    return value.annotation.ir.name if isinstance(value.annotation, ClassValue) else None


@pytest.mark.parametrize(
    ("annotation", "cls"),
    [
        ("Robot", "Robot"),
        ("'Robot'", "Robot"),
        ("Optional[Robot]", "Robot"),
        ("Optional['Robot']", "Robot"),
        ("Annotated[Robot]", "Robot"),
        ("Robot | None", "Robot"),
        ("None | Robot", "Robot"),
        ("names.Other", "Other"),
        ("'names.Other'", "Other"),
        ("list[Robot]", None),
        ("int", None),
        ("undefined", None),
        ("names.nothing", None),
        ("Robot.Inner", None),
        ("f()[0]", None),
        ("5", None),
    ],
)
def test_the_class_that_an_annotation_means(annotation: str, cls: str | None):
    source = f"{CLASSES}\ndef f(x: {annotation}):\n    return x\nit = f()\nset_: {annotation} = undefined_value\n"
    found = interpret(source, names="class Other:\n    pass")
    assert meant(found, "it") == cls
    assert meant(found, "set_") == cls


def test_what_is_known_needs_no_annotation():
    assert interpret(f"{CLASSES}\nit: Robot = 5", names="").constant("it") == 5


def test_attributes_of_what_an_annotation_tells_of():
    source = (
        f"{CLASSES}\ndef f(x: Robot):\n    return [x.arm, x.count, x.other, x.arm.hand]\n"
        "it = f()\narm, count, other, hand = it[0], it[1], it[2], it[3]\nown = Robot().arm"
    )
    found = interpret(source, names="")
    assert meant(found, "arm") == "Arm"
    assert meant(found, "own") == "Arm"
    for name, attribute in (("other", "other"), ("hand", "_hand"), ("count", "count")):
        value = found.value(name)
        assert isinstance(value, Unknown)
        assert isinstance(value.annotation, AttributeOf) or value.annotation is None
        if isinstance(value.annotation, AttributeOf):
            assert value.annotation.name == attribute
