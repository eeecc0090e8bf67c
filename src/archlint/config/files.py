"""Which file is the configuration, and what TOML makes of it."""

from __future__ import annotations

import importlib
import os
import re
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

from archlint.config.source import ConfigurationError, Reader, Source
from archlint.disk import read_regular

FILE_NAMES = (".archlint.toml", "archlint.toml", "pyproject.toml")
"""In the order in which they are looked for in a folder."""

MAX_BYTES = 1_000_000
"""A larger file is no configuration."""


def find(start: Path, read: Reader | None = None) -> Source | None:
    """The configuration file that counts for ``start``, a folder or a file; ``read`` gives the bytes of files, if not
    the disk."""
    for folder in (start, *start.parents):
        for name in FILE_NAMES:
            path = folder / name
            source = read_source(path, read=read) if path.is_file() else None
            if source is None:
                continue
            if not is_within(path, repository_of(folder)):
                raise ConfigurationError("leads out of the repository: name it with --config", source.shown)
            return source
    return None


def repository_of(folder: Path) -> Path:
    """The repository that a folder is in; the folder itself where it is in none."""
    folders = (folder, *folder.parents)
    return next((parent for parent in folders if os.path.lexists(parent / ".git")), folder).resolve()


def is_within(path: Path, folder: Path) -> bool:
    return path.resolve().is_relative_to(folder)


def read_source(path: Path, named: bool = False, foreign: bool = False, read: Reader | None = None) -> Source | None:
    """A configuration file's text; None for a ``pyproject.toml`` without the table, unless it was named."""
    shown = Source(path, "", ()).shown
    try:
        content = read_regular(path, MAX_BYTES) if read is None else read(path)
    except OSError as error:
        raise ConfigurationError(f"cannot be read: {error.strerror}", shown) from None
    in_pyproject = path.name == "pyproject.toml"
    if in_pyproject and b"archlint" not in content and not named:
        return None
    try:
        table = ("tool", "archlint") if in_pyproject else ()
        source = Source(path, content.decode("utf-8-sig"), table, foreign, read)
    except UnicodeDecodeError:
        raise ConfigurationError("is not UTF-8", shown) from None
    foreign = foreign or not (named or is_within(path, repository_of(path.parent)))
    source = replace(source, foreign=foreign)
    if in_pyproject and own_table(source) is None and not named:
        return None
    return source


def own_table(source: Source) -> dict[str, Any] | None:
    document = _parse(source)
    if not source.table:
        return document
    match document:
        case {"tool": {"archlint": dict() as table}}:
            return table
    return None


def _parse(source: Source) -> dict[str, Any]:
    toml = importlib.import_module("tomllib" if sys.version_info >= (3, 11) else "tomli")
    try:
        document: dict[str, Any] = toml.loads(source.text)
    except (ValueError, RecursionError) as error:
        place = re.search(r"\(at line (\d+), column (\d+)\)", str(error))
        why = str(error).partition(" (at ")[0] or "nested too deeply"
        message = "not valid TOML" if source.foreign else f"not valid TOML: {why}"
        lines = source.text.splitlines() or [""]
        line, column = (int(place[1]), int(place[2])) if place else (len(lines), len(lines[-1]))
        raise source.error_at(message, line, column, column + 1) from None
    return document
