"""The files of archlint itself: what they say is part of what every result depends on."""

from __future__ import annotations

import os
from collections.abc import Iterator
from functools import cache
from pathlib import Path

from archlint.rulebook import pages_folder


@cache
def own_code() -> list[tuple[str, int, int]]:
    """Name, time and size of archlint's own modules: an edited rule must not be answered from the cache."""
    return sorted(
        (entry.path, entry.stat().st_mtime_ns, entry.stat().st_size) for entry in _own_entries() if _is_code(entry)
    )


def own_places() -> list[str]:
    """The paths of archlint's own modules, and of the folders that they lie in."""
    return [*_own_folders(), *(entry.path for entry in _own_entries())]


def _own_folders() -> list[str]:
    return [str(Path(__file__).parents[1]), str(pages_folder())]


def _own_entries() -> Iterator[os.DirEntry[str]]:
    """The modules and the folders below :func:`_own_folders`."""
    folders = _own_folders()
    while folders:
        with os.scandir(folders.pop()) as listed:
            for entry in listed:
                if _is_code(entry):
                    yield entry
                elif entry.name != "__pycache__" and entry.is_dir():
                    folders.append(entry.path)
                    yield entry


def _is_code(entry: os.DirEntry[str]) -> bool:
    return entry.name.endswith((".py", ".md", ".json"))
