"""The files of generated pages: which are stale, and how they are written without touching what is not ours."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from pathlib import Path

from archlint.disk import read_regular, replace_file, walk
from archlint.records import dataclass
from archlint.render.pages import MARK

_LIMIT = 20_000_000
_MOST_FILES = 20_000
"""How many files of a folder are looked at: one with more is none of pages."""


class NotOurs(Exception):
    """A file that is in the way and was not written by archlint; ``str()`` says which, and what to do."""


@dataclass(frozen=True)
class Stale:
    """The pages of a folder that are not what they should be, by their paths in it, sorted."""

    changed: tuple[str, ...]
    missing: tuple[str, ...]
    unneeded: tuple[str, ...]
    """Pages that archlint wrote and that are about nothing any more."""

    def __bool__(self) -> bool:
        return bool(self.changed or self.missing or self.unneeded)


def stale(folder: Path, pages: Mapping[str, str]) -> Stale:
    """How a folder differs from the pages that belong there.

    Raises :class:`NotOurs` where something else has the name of a page, and ``OSError`` where a file cannot be read.
    """
    changed: list[str] = []
    missing: list[str] = []
    for page, text in pages.items():
        path = folder / page
        if not os.path.lexists(path):
            missing.append(page)
        elif _ours(path) != text.encode("utf-8"):
            changed.append(page)
    unneeded = [page for page in _written_before(folder) if page not in pages]
    return Stale(tuple(sorted(changed)), tuple(sorted(missing)), tuple(sorted(unneeded)))


def bring_up_to_date(folder: Path, pages: Mapping[str, str]) -> Stale:
    """Write what is missing or changed, and remove archlint's own pages that are not needed any more.

    Returns what there was to do.  Nothing is done where a file is in the way that is not archlint's; raises as
    :func:`stale`.
    """
    todo = stale(folder, pages)
    for page in (*todo.changed, *todo.missing):
        path = folder / page
        path.parent.mkdir(parents=True, exist_ok=True)
        replace_file(path, pages[page].encode("utf-8"), path.stat() if path.exists() else None)
    for page in todo.unneeded:
        (folder / page).unlink()
    return todo


def _ours(path: Path) -> bytes:
    """The content of a page that archlint wrote."""
    content = None if path.is_symlink() or not path.is_file() else read_regular(path, _LIMIT)
    if content is None or not _has_mark(content):
        raise NotOurs(f"{path} was not written by `archlint docs`, and is left as it is: choose another folder with -o")
    return content


def _written_before(folder: Path) -> Iterator[str]:
    """The pages in a folder that have archlint's mark; links lead elsewhere and are not followed."""
    looked_at = 0
    for parent, folders, files in walk(folder):
        folders.sort()
        for name in sorted(files):
            looked_at += 1
            path = Path(parent, name)
            if looked_at <= _MOST_FILES and name.endswith(".md") and not path.is_symlink() and path.is_file():
                try:
                    content = read_regular(path, _LIMIT)
                except OSError:
                    continue  # what cannot be read is not ours to remove
                if _has_mark(content):
                    yield path.relative_to(folder).as_posix()


def _has_mark(content: bytes) -> bool:
    return content.startswith(MARK.encode())


__all__ = ["NotOurs", "Stale", "bring_up_to_date", "stale"]
