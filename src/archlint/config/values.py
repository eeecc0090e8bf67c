"""The values of a configuration file, read with their types checked and their places known."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeVar

from archlint.config.toml_places import KeyPath, locate
from archlint.finding import Severity
from archlint.globs import Glob
from archlint.rulebook import codes_of, suggestion
from archlint.suggestions import did_you_mean

_Kind = TypeVar("_Kind")
_NUMBER: Any = int | float


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
class Value:
    """A value as TOML gives it, and where it stands."""

    value: Any
    path: KeyPath
    source: Source
    after: int = 0
    """The line of the header that it stands under, where several tables have the same path."""

    @property
    def base(self) -> str:
        return self.source.path.parent.as_posix()

    def wrong(self, wanted: str) -> ConfigurationError:
        return self.error(f"`{'.'.join(self.path)}` must be {wanted}, not {_kind(self.value)}")

    def error(self, message: str) -> ConfigurationError:
        return self.source.error(message, self.path, after=self.after)

    def at(self, key: str) -> Value:
        return Value(self.value[key], (*self.path, key), self.source)


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
        case list():
            return "a list"
    return "a date or time"


def typed(value: Value, kind: type[_Kind], wanted: str) -> _Kind:
    """The value as what it has to be; ``wanted`` says that in words."""
    import msgspec  # small commands read no configuration, and do without

    try:
        return msgspec.convert(value.value, kind)
    except msgspec.ValidationError:
        raise value.wrong(wanted) from None


def string(value: Value) -> str:
    return typed(value, str, "a string")


def boolean(value: Value) -> bool:
    return typed(value, bool, "true or false")


def number(value: Value) -> int | float:
    given: int | float = typed(value, _NUMBER, "a number")
    return given


def strings(value: Value, wanted: str = "a list of strings") -> tuple[str, ...]:
    return typed(value, tuple[str, ...], wanted)


def table(value: Value) -> dict[str, Value]:
    return {key: value.at(key) for key in typed(value, dict[str, Any], "a table")}


def selectors(value: Value) -> tuple[str, ...]:
    selectors = strings(value)
    for selector in selectors:
        if not codes_of(selector):
            raise value.source.error(unknown_rule(selector), value.path, selector)
    return selectors


def unknown_rule(selector: str) -> str:
    return f"unknown rule `{selector}`{suggestion(selector)}"


_Word = TypeVar("_Word", bound=str)


def one_of(words: tuple[_Word, ...]) -> Callable[[Value], _Word]:
    def read(value: Value) -> _Word:
        for word in words:
            if value.value == word:
                return word
        near = did_you_mean(str(value.value), words, quote="")
        raise value.error(f"`{'.'.join(value.path)}` must be one of {', '.join(words)}{near}")

    return read


def globs(value: Value) -> tuple[Glob, ...]:
    return tuple(Glob(pattern, value.base) for pattern in strings(value))


def ignores_by_glob(value: Value) -> dict[Glob, tuple[str, ...]]:
    return {Glob(glob, value.base): selectors(codes) for glob, codes in table(value).items()}


def ignores_by_name(value: Value) -> dict[str, tuple[str, ...]]:
    return {name: selectors(codes) for name, codes in table(value).items()}


def severities(value: Value) -> dict[str, Severity]:
    levels = tuple(severity.label for severity in Severity)
    for selector in table(value):
        if not codes_of(selector):
            raise value.source.error(unknown_rule(selector), (*value.path, selector))
    return {selector: Severity.parse(one_of(levels)(level)) for selector, level in table(value).items()}


def folder(value: Value) -> str:
    return (Path(value.base) / home_of(value.source, string(value), value.path)).as_posix()


def home_of(source: Source, path: str, key: KeyPath) -> Path:
    """A path with ``~`` and ``~user`` as folders.  Raises :class:`ConfigurationError` for what is no path."""
    if "\0" in path:
        raise source.error(f"`{key[-1]}` contains a character that is not allowed in a path", key)
    try:
        return Path(path).expanduser()
    except RuntimeError:
        raise source.error(f"`{key[-1]}` names a user whose home is not known: {path}", key) from None


def unknown_key(key: str, known: Mapping[str, object], words: str = "unknown key") -> str:
    dashed = key.replace("_", "-")
    near = f"; did you mean `{dashed}`?" if dashed in known else did_you_mean(dashed, known, quote="`")
    return f"{words} `{key}`{near}"
