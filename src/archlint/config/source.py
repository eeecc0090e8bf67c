"""A configuration file, its keys, and how a mistake in it is reported: with its line."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import field
from pathlib import Path

from archlint.config.toml_places import KeyPath, headers, locate
from archlint.place import Place
from archlint.records import dataclass

Reader = Callable[[Path], bytes]
"""Gives the bytes of a configuration file; raises ``OSError``."""


class ConfigurationError(Exception):
    """A configuration that cannot be used.  ``str()`` is the message with place and the line at fault."""

    def __init__(self, message: str, file: str = "", frame: str = "", line: int | None = None) -> None:
        place = file + (f":{line}" if line is not None else "")
        super().__init__(": ".join(part for part in (place, message) if part) + (f"\n{frame}" if frame else ""))
        self.message, self.file, self.line = message, file, line


@dataclass(frozen=True)
class Source:
    """A configuration file: its path as shown, its text, and the table in which archlint's keys stand."""

    path: Path
    text: str
    table: KeyPath
    foreign: bool = False
    """Whether it lies outside of the repository: then no line of it is shown, for it may be no configuration."""
    read: Reader | None = field(default=None, compare=False, repr=False)
    """Gives the bytes of the files that it builds on, if not the disk."""

    @property
    def shown(self) -> str:
        try:
            return self.path.relative_to(Path.cwd()).as_posix()
        except ValueError:
            return self.path.as_posix()

    def error(self, message: str, path: KeyPath = (), element: str | None = None, after: int = 0) -> ConfigurationError:
        """An error about a key (the first one after a line), or about a string in its value, with the line in a
        frame."""
        place = locate(self.text, self.table + path, element, after) if path else None
        return self.error_at(message, *place) if place else ConfigurationError(message, self.shown)

    def error_at(self, message: str, line: int, column: int, end: int) -> ConfigurationError:
        if self.foreign:
            return ConfigurationError(message, self.shown, line=line)
        lines = self.text.splitlines()
        text = lines[line - 1] if line <= len(lines) else ""
        margin = " " * len(str(line))
        marks = " " * (column - 1) + "^" * max(end - column, 1)
        frame = f"{margin} |\n{line} | {text}\n{margin} | {marks}"
        return ConfigurationError(message, self.shown, frame, line)

    def line_of(self, path: KeyPath) -> str:
        place = locate(self.text, self.table + path)
        return f"{self.shown}:{place[0]}" if place else self.shown


@dataclass(frozen=True)
class Key:
    """A key of a configuration file, and where it stands."""

    path: KeyPath
    source: Source
    after: int = 0
    """The line of the header that it stands under, where several tables have the same path."""

    def __str__(self) -> str:
        return ".".join(self.path)

    @property
    def base(self) -> str:
        """The folder of the file."""
        return self.source.path.parent.as_posix()

    def at(self, key: str) -> Key:
        """A key of the table that this one holds."""
        return Key((*self.path, key), self.source, self.after)

    def header(self, number: int) -> Place:
        """Where a table of a list stands: its header, or the key of an inline list."""
        path, text = self.source.table + self.path, self.source.text
        spans = headers(text, path)
        span = spans[number] if number < len(spans) else locate(text, path)
        line, column, end = span or (1, 1, 1)
        return Place(self.source.shown, line, column, line, end)

    def under_header(self, number: int) -> Key:
        """The key as it is in one table of a list."""
        return Key(self.path, self.source, after=self.header(number).line)

    def error(self, message: str, element: str | None = None) -> ConfigurationError:
        """An error about what the key holds, or about a string in it."""
        return self.source.error(message, self.path, element, self.after)

    def wrong(self, wanted: str, value: object) -> ConfigurationError:
        """An error that says what the key must hold, in words, and what kind of value it holds."""
        return self.error(f"`{self}` must be {wanted}, not {_kind(value)}")


def _kind(value: object) -> str:
    match value:
        case [first, *_]:
            odd = next((item for item in value if type(item) is not str), first)
            return f"a list with {_kind(odd)}"
        case bool():
            return "a boolean"
        case int() | float():
            return "a number"
        case str():
            return "a string"
        case dict():
            return "a table"
        case list() | tuple():
            return "a list"
    return "a date or time"
