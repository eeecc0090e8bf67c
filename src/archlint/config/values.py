"""What the values of a configuration mean, beyond their types."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from archlint.config.files import is_within, repository_of
from archlint.finding import Severity
from archlint.globs import Glob
from archlint.rulebook import may_be_rule, suggestion
from archlint.suggestions import did_you_mean, meant

if TYPE_CHECKING:
    from archlint.config.source import Key


def selectors(given: tuple[str, ...], key: Key) -> tuple[str, ...]:
    for selector in given:
        if not may_be_rule(selector):
            raise key.error(unknown_rule(selector), selector)
    return given


def unknown_rule(selector: str) -> str:
    return f"unknown rule `{selector}`{suggestion(selector)}"


def globs(patterns: tuple[str, ...], key: Key) -> tuple[Glob, ...]:
    return tuple(Glob(pattern, key.base) for pattern in patterns)


def ignores_by_glob(table: Mapping[str, tuple[str, ...]], key: Key) -> dict[Glob, tuple[str, ...]]:
    return {Glob(glob, key.base): selectors(codes, key.at(glob)) for glob, codes in table.items()}


def ignores_by_name(table: Mapping[str, tuple[str, ...]], key: Key) -> dict[str, tuple[str, ...]]:
    return {name: selectors(codes, key.at(name)) for name, codes in table.items()}


def severities(table: Mapping[str, str], key: Key) -> dict[str, Severity]:
    for selector in table:
        if not may_be_rule(selector):
            raise key.at(selector).error(unknown_rule(selector))
    return {selector: Severity.parse(level) for selector, level in table.items()}


def folder(path: str, key: Key) -> str:
    return (Path(key.base) / home_of(path, key)).as_posix()


def file_in_repository(path: str, key: Key) -> str:
    return _in_repository(path, key)


def folder_in_repository(path: str, key: Key) -> str:
    return _in_repository(path, key, "; name such a folder with --cache-dir")


def _in_repository(path: str, key: Key, advice: str = "") -> str:
    """Where archlint may read and write: a repository must not choose another place."""
    absolute = folder(path, key)
    if not is_within(Path(absolute), repository_of(Path(key.base))):
        raise key.error(f"`{key}` leads out of the repository: {path}{advice}", path)
    return absolute


def home_of(path: str, key: Key) -> Path:
    """A path with ``~`` and ``~user`` as folders.  Raises :class:`ConfigurationError` for what is no path."""
    if "\0" in path:
        raise key.error(f"`{key.path[-1]}` contains a character that is not allowed in a path")
    try:
        return Path(path).expanduser()
    except RuntimeError:
        raise key.error(f"`{key.path[-1]}` names a user whose home is not known: {path}") from None


def unknown_key(key: str, known: Mapping[str, object], words: str = "unknown key") -> str:
    dashed = key.replace("_", "-")
    near = meant(f"`{dashed}`") if dashed in known else did_you_mean(dashed, known, quote="`")
    return f"{words} `{key}`{near}"
