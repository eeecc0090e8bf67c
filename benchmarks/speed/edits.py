"""Edits of Python files of a workspace, as a developer makes them: a comment, another name for a topic."""

from __future__ import annotations

import ast
import hashlib
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

_CREATES = {"create_publisher": 1, "create_subscription": 1}
"""Methods that take the name of a topic, and at which position."""


@dataclass(frozen=True)
class Topic:
    """A file with the name of a topic: the line, from 0, and the bytes of it that hold the literal."""

    file: Path
    line: int
    start: int
    end: int


def topics_below(folder: Path) -> list[Topic]:
    """One literal name of a topic of each file, in an order that is always the same and has nothing to do with where
    the files lie."""
    topics = [topic for file in folder.rglob("*.py") for topic in _topics_in(file)]
    first = {topic.file: topic for topic in reversed(topics)}
    return sorted(
        first.values(), key=lambda topic: hashlib.sha256(str(topic.file.relative_to(folder)).encode()).digest()
    )


def _topics_in(file: Path) -> Iterator[Topic]:
    try:
        tree = ast.parse(file.read_bytes())
    except (SyntaxError, ValueError):
        return
    for call in ast.walk(tree):
        match call:
            case ast.Call(func=ast.Attribute(attr=method), args=[_, ast.Constant(value=str()) as name, *_]):
                if method in _CREATES and name.lineno == name.end_lineno and name.end_col_offset is not None:
                    yield Topic(file, name.lineno - 1, name.col_offset, name.end_col_offset)


def append_comment(topic: Topic, number: int) -> None:
    with topic.file.open("ab") as stream:
        stream.write(f"\n# edit {number}\n".encode())


def rename(topic: Topic, number: int) -> None:
    """Give the topic another name."""
    lines = topic.file.read_bytes().splitlines(keepends=True)
    line = lines[topic.line]
    literal = f'"renamed_{number}"'.encode()
    lines[topic.line] = line[: topic.start] + literal + line[topic.end :]
    topic.file.write_bytes(b"".join(lines))
