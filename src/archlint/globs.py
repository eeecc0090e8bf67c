"""Patterns for files, as a configuration has them."""

from __future__ import annotations

import os
from dataclasses import dataclass
from fnmatch import fnmatchcase


@dataclass(frozen=True)
class Glob:
    """A pattern and the folder that it is relative to: that of the file it is written in."""

    pattern: str
    base: str

    def patterns(self) -> list[str]:
        """The pattern as ``fnmatch`` patterns for paths relative to the working directory.

        ``*`` crosses folders; a leading ``**/`` also stands for no folder at all; a pattern without a slash
        is for the name of a file or folder wherever it lies.
        """
        pattern = self.pattern.rstrip("/")
        if "/" not in pattern:
            return [pattern]
        base = os.path.relpath(self.base).replace(os.sep, "/")
        prefix = "" if base == "." else f"{base}/"
        pattern = pattern.removeprefix("./").lstrip("/")
        return [prefix + pattern, *([prefix + pattern[3:]] if pattern.startswith("**/") else [])]

    def matches(self, file: str) -> bool:
        """Whether a file, by its path relative to the working directory, or a folder above it is meant."""
        parts = file.split("/")
        above = ["/".join(parts[: end + 1]) for end in range(len(parts))]
        return any(
            fnmatchcase(name, pattern) for pattern in self.patterns() for name in (above if "/" in pattern else parts)
        )
