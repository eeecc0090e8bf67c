"""The elements of a file in XML, each with the place where it begins."""

from __future__ import annotations

from dataclasses import field
from xml.parsers import expat

from archlint.records import dataclass

_LARGEST = 1_000_000
"""Characters of what people write by hand."""


@dataclass(frozen=True)
class Element:
    """An element: ``line`` and ``column`` are those of its ``<``."""

    tag: str
    attributes: dict[str, str]
    line: int
    column: int
    children: list[Element] = field(default_factory=list)


def read_elements(text: str) -> Element | None:
    """The outermost element; None of what is no XML, has a document type, or is too large.  Never raises."""
    if len(text) > _LARGEST or "<!DOCTYPE" in text:
        return None
    top = Element("", {}, 1, 1)
    inside = [top]
    parser = expat.ParserCreate()

    def start(tag: str, attributes: dict[str, str]) -> None:
        element = Element(tag, attributes, parser.CurrentLineNumber, parser.CurrentColumnNumber + 1)
        inside[-1].children.append(element)
        inside.append(element)

    def end(tag: str) -> None:
        inside.pop()

    parser.StartElementHandler = start
    parser.EndElementHandler = end
    try:
        parser.Parse(text, True)
    except (expat.ExpatError, ValueError, LookupError):
        return None
    return top.children[0]


__all__ = ["Element", "read_elements"]
