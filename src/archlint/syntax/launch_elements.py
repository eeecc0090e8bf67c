"""What an XML or YAML launch file says: a tree of elements, the same for both."""

from __future__ import annotations

from dataclasses import field
from typing import Union

from archlint.records import dataclass
from archlint.syntax.facts import FileProblem, Span, Suppression

Scalar = Union[str, int, float, bool, None]
Plain = Union[Scalar, "list[Scalar]"]

ELEMENTS = 50_000
"""How many elements a launch file may have, aliases counted each time."""
DEPTH = 100


class TooLarge(Exception):
    """A file with more elements, or nested deeper, than a launch file has."""


@dataclass(frozen=True)
class Attribute:
    """A value as written; YAML keeps its type, in XML it is always text."""

    value: Plain
    span: Span


@dataclass(frozen=True)
class Element:
    """``<tag name="value">children</tag>``; ``span`` covers the tag's start."""

    tag: str
    attributes: dict[str, Attribute]
    children: tuple[Element, ...]
    span: Span

    def text(self, name: str) -> str | None:
        attribute = self.attributes.get(name)
        return None if attribute is None or isinstance(attribute.value, list) else str(attribute.value)

    def of(self, *tags: str) -> list[Element]:
        return [child for child in self.children if child.tag in tags]


@dataclass(frozen=True)
class LaunchFacts:
    """``root`` is None where the file is broken (``problems`` say how) or no launch file at all."""

    root: Element | None = None
    ros1: bool = False
    """Whether it is for ROS 1; where nothing in it decides that, its package does."""
    decided: bool = True
    problems: tuple[FileProblem, ...] = ()
    suppressions: tuple[Suppression, ...] = field(default=())


def failed(line: int, column: int, message: str) -> LaunchFacts:
    return LaunchFacts(problems=(FileProblem(line, column, message),))
