""".gitignore, as git reads it; pathspec does the matching and is imported only where there is such a file."""

from __future__ import annotations

import os
from typing import Any


class Ignore:
    """The patterns of one folder and of those above it."""

    def __init__(self, parent: Ignore | None, folder: str, spec: Any) -> None:
        self.parent = parent
        self.folder = folder
        self.spec = spec

    def ignores(self, path: str, is_folder: bool) -> bool:
        """Whether git would ignore a path; the nearest file that has an opinion wins."""
        here: Ignore | None = self
        while here is not None:
            relative = path[len(here.folder) :].lstrip("/")
            verdict = here.spec.check_file(relative + "/" if is_folder else relative).include
            if verdict is not None:
                return bool(verdict)
            here = here.parent
        return False


def below(parent: Ignore | None, folder: str, file: str) -> Ignore | None:
    """The patterns that hold in ``folder``, with those of ``file`` added; unreadable ones do not count."""
    try:
        with open(file, encoding="utf-8", errors="replace") as stream:
            lines = stream.read().splitlines()
    except OSError:
        return parent
    if not any(line.strip() and not line.lstrip().startswith("#") for line in lines):
        return parent
    import pathspec

    try:
        spec = pathspec.GitIgnoreSpec.from_lines(lines)
    except (ValueError, TypeError):
        return parent
    return Ignore(parent, folder, spec)


def above(folder: str) -> Ignore | None:
    """The patterns of the folders above, up to the top of the git repository, and of its ``info/exclude``."""
    chain: list[str] = []
    here = folder
    while True:
        chain.append(here)
        if os.path.exists(os.path.join(here, ".git")):
            break
        parent = os.path.dirname(here)
        if parent == here:
            return None  # no repository: only the files below count
        here = parent
    found = below(None, here, os.path.join(here, ".git", "info", "exclude"))
    for place in reversed(chain[1:]):
        file = os.path.join(place, ".gitignore")
        if os.path.isfile(file):
            found = below(found, place, file)
    return found
