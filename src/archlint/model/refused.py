"""Calls of a library that it refuses."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.records import dataclass
from archlint.string_enum import StringEnum

if TYPE_CHECKING:
    from archlint.finding import Place


class Misuse(StringEnum):
    """What is wrong with the arguments of a call."""

    MISSING = "missing"
    TOO_MANY = "too many"
    UNKNOWN_KEYWORD = "unknown keyword"
    TWICE = "twice"
    """One parameter is given by position and by keyword."""
    KIND = "kind"
    """One parameter is given something else than it takes."""
    EARLY = "early"
    """The object that it is called on is not initialised yet."""
    BEFORE_INIT = "before init"
    """It makes a node, and ``rclpy.init()`` comes later."""
    ABSENT = "absent"
    """There is no function or method of that name."""
    SWAPPED = "swapped"
    """Two parameters are given what the other takes."""
    NO_FUNCTION = "no function"
    """An object is called that has methods for that."""
    VALUE = "value"
    """It is a value that an object has, and no method."""


@dataclass(frozen=True)
class RefusedCall:
    """A call of a library that ends in an exception, whatever the values are that archlint does not know."""

    place: Place
    api: str
    """Canonical name: ``rclpy.node.Node.create_timer``."""
    misuse: Misuse
    parameters: tuple[str, ...] = ()
    """Those that it is about; where arguments are too many, those that go by keyword alone."""
    takes: int = 0
    """How many arguments it takes by position, where they are too many."""
    given: str = ""
    """What is given, in words, where its kind is wrong; the class that is called, where the constructor is one that it
    inherits."""
    wanted: str = ""
    """What the parameter takes, in words, where the kind is wrong; what there is instead, where there is no such
    function; the method that was to be the constructor, where one is missing."""
    signature: tuple[str, ...] = ()
    """The parameters that may not be left out."""
    distros: tuple[str, ...] = ()
    """The distributions in which it is refused, of those whose signatures are known, oldest first."""


__all__ = ["Misuse", "RefusedCall"]
