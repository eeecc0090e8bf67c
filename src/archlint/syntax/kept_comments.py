"""The comments of a description of a robot that xacro hands on, and that are no YAML.

Source: xacro 2.1.1 drops the comments in front of its own elements and hands on the others; in a plain text of YAML a
colon or a ``#`` beside a blank means something (both were tried with PyYAML 6).
"""

from __future__ import annotations

import re
from xml.parsers import expat

_NO_YAML = re.compile(r":\s|\s#")
_XACRO = "xacro:"


def comment_that_is_no_yaml(text: str) -> tuple[int, str] | None:
    """The first such comment that is certainly handed on: the line and the ``:`` or ``#`` in it.  None where there is
    none, and of what is no XML."""
    reader = _Reader()
    try:
        reader.parser.Parse(text, True)
    except (expat.ExpatError, ValueError, LookupError):
        return None
    return reader.kept[0] if reader.kept else None


class _Reader:
    """Collects comments outside of xacro's elements once something else than such an element follows."""

    def __init__(self) -> None:
        self.parser = expat.ParserCreate()
        self.parser.StartElementHandler = self._start
        self.parser.EndElementHandler = self._end
        self.parser.CommentHandler = self._comment
        self.parser.StartDoctypeDeclHandler = self._doctype
        self.kept: list[tuple[int, str]] = []
        self._waiting: list[tuple[int, str]] = []
        self._around: list[str] = []

    def _doctype(self, *_: object) -> None:
        raise ValueError("a document type is not read here")

    def _start(self, tag: str, _: dict[str, str]) -> None:
        if not tag.startswith(_XACRO):
            self.kept += self._waiting
        self._waiting = []
        self._around.append(tag)

    def _end(self, _: str) -> None:
        self.kept += self._waiting
        self._waiting = []
        self._around.pop()

    def _comment(self, text: str) -> None:
        match = _NO_YAML.search(text)
        if match is None or _XACRO in text or any(tag.startswith(_XACRO) for tag in self._around):
            return  # what stands in a macro or a condition may not be handed on
        line = self.parser.CurrentLineNumber + text.count("\n", 0, match.start())
        self._waiting.append((line, match[0].strip()))


__all__ = ["comment_that_is_no_yaml"]
