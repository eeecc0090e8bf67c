"""Archlint's dataclasses do what those of ``dataclasses`` do, except that nothing refuses a write at run time."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from dataclasses import field
from threading import Barrier, Thread
from typing import Any, ClassVar

import pytest

from archlint import records

Decorator = Callable[..., Any]


def _classes(dataclass: Decorator) -> dict[str, Any]:
    """One class of each kind."""

    @dataclass(frozen=True)
    class Point:
        x: int
        y: int = 0

    @dataclass(frozen=True, order=True)
    class Ordered:
        first: int
        second: str = field(default="b", compare=False)

    @dataclass(frozen=True, slots=True)
    class Slotted:
        x: int
        y: list[int] = field(default_factory=list, hash=False)

    @dataclass
    class Changing:
        names: list[str] = field(default_factory=list)
        secret: int = field(default=1, repr=False)

    @dataclass(frozen=True, eq=False)
    class Itself:
        x: int

    @dataclass(frozen=True, kw_only=True)
    class Keywords:
        x: int

    @dataclass(frozen=True)
    class Empty:
        kind: ClassVar[str] = "none"

    @dataclass(frozen=True)
    class Below(Point):
        z: int = 3

        def __post_init__(self) -> None:
            object.__setattr__(self, "z", self.z + 1)

    @dataclass(frozen=True)
    class Own:
        x: int

        def __eq__(self, other: object) -> bool:
            return isinstance(other, Own)

        def __hash__(self) -> int:
            return 1

        def __repr__(self) -> str:
            return "own"

    every = (Point, Ordered, Slotted, Changing, Itself, Keywords, Empty, Below, Own)
    return {cls.__name__: cls for cls in every}


OBJECTS: dict[str, Callable[[dict[str, Any]], Any]] = {
    "a point": lambda classes: classes["Point"](1),
    "a point with all its fields": lambda classes: classes["Point"](1, y=2),
    "one with an order": lambda classes: classes["Ordered"](2, "x"),
    "one with slots": lambda classes: classes["Slotted"](2, [3]),
    "one that changes": lambda classes: classes["Changing"](["a"], 2),
    "one with a list of its own": lambda classes: classes["Changing"](),
    "one by keywords": lambda classes: classes["Keywords"](x=1),
    "one without fields": lambda classes: classes["Empty"](),
    "one of a class below": lambda classes: classes["Below"](1, 2),
    "one that says it itself": lambda classes: classes["Own"](1),
}

QUESTIONS: dict[str, Callable[[Any], object]] = {
    "repr": lambda value: repr(value).rpartition("<locals>.")[2],
    "fields": lambda value: [field.name for field in dataclasses.fields(value)],
    "as a dict": dataclasses.asdict,
    "equal to another": lambda value: value == dataclasses.replace(value),
    "equal to one of another class": lambda value: value == object(),
    "a list of its own": lambda value: (
        getattr(value, "names", None) is getattr(type(value)(), "names", 1)
        if type(value).__name__ == "Changing"
        else None
    ),
    "hashable": lambda value: type(value).__hash__ is not None and isinstance(hash(value), int),
    "one of a set": lambda value: (
        type(value).__hash__ is not None and len({value, dataclasses.replace(value)})
        if "list" not in str(dataclasses.asdict(value)) and type(value).__name__ not in ("Changing", "Slotted")
        else None
    ),
    "positions in a pattern": lambda value: type(value).__match_args__,
    "has a dict": lambda value: hasattr(value, "__dict__"),
    "first": lambda value: value < dataclasses.replace(value) if type(value).__name__ == "Ordered" else None,
}


@pytest.mark.parametrize("question", QUESTIONS.values(), ids=QUESTIONS)
@pytest.mark.parametrize("made", OBJECTS.values(), ids=OBJECTS)
def test_it_is_what_dataclasses_make(made: Callable[[dict[str, Any]], Any], question: Callable[[Any], object]):
    assert question(made(_classes(records.dataclass))) == question(made(_classes(dataclasses.dataclass)))


def test_objects_of_a_class_without_comparison_are_equal_to_themselves_only():
    cls = _classes(records.dataclass)["Itself"]
    assert (first := cls(1)) == first
    assert first != cls(1)


def test_an_order_by_the_fields_that_count():
    cls = _classes(records.dataclass)["Ordered"]
    assert sorted([cls(3, "a"), cls(1, "c"), cls(2, "b")], reverse=True) == [cls(3), cls(2), cls(1)]
    assert cls(1) <= cls(1, "z") >= cls(0)
    with pytest.raises(TypeError):
        _ = cls(1) < 1


def test_a_field_that_is_not_given_is_refused():
    cls = _classes(records.dataclass)["Point"]
    with pytest.raises(TypeError, match="x"):
        cls()


def test_the_fields_of_a_class_of_which_there_is_no_object_yet():
    cls = _classes(records.dataclass)["Below"]
    assert dataclasses.is_dataclass(cls)
    assert [field.name for field in dataclasses.fields(cls)] == ["x", "y", "z"]


def test_a_pattern_asks_before_there_is_an_object():
    Point = _classes(records.dataclass)["Point"]
    match 1:
        case Point(_, _):
            pytest.fail("1 is no point")
    match Point(1, 2):
        case Point(x, y):
            assert (x, y) == (1, 2)
        case _:
            pytest.fail("the fields have no positions")


def test_a_class_below_one_of_which_there_is_no_object_yet():
    classes = _classes(records.dataclass)

    class Further(classes["Below"]):
        pass

    assert repr(Further(1, 2, 3)).endswith("Further(x=1, y=2, z=4)")


def test_several_threads_make_the_first_object():
    cls = _classes(records.dataclass)["Below"]
    start = Barrier(8)
    made: list[object] = []

    def make() -> None:
        start.wait()
        made.append(cls(1, 2))

    threads = [Thread(target=make) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert made == [cls(1, 2)] * 8
