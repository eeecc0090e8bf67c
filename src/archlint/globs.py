"""Patterns for files, as a configuration has them."""

from __future__ import annotations

import os
from fnmatch import fnmatchcase

from archlint.records import dataclass


@dataclass(frozen=True)
class Glob:
    """A pattern and the folder that it is relative to: that of the file it is written in."""

    pattern: str
    base: str
    seen_from: str = ""
    """The folder that paths are relative to; empty for the working directory."""

    def patterns(self) -> list[str]:
        """The pattern as ``fnmatch`` patterns for paths as they are shown.

        ``*`` crosses folders; a leading ``**/`` also stands for no folder at all; a pattern without a slash
        is for the name of a file or folder wherever it lies.
        """
        base = os.path.relpath(self.base, self.seen_from or os.curdir).replace(os.sep, "/")
        prefix = "" if base == "." or not self._is_anchored else f"{base}/"
        return [prefix + pattern for pattern in self._own()]

    @property
    def _is_anchored(self) -> bool:
        return "/" in self.pattern.rstrip("/")

    def _own(self) -> list[str]:
        """The same for paths relative to its own folder."""
        pattern = self.pattern.rstrip("/")
        if self._is_anchored:
            pattern = pattern.removeprefix("./").lstrip("/")
        return [pattern, *([pattern[3:]] if pattern.startswith("**/") else [])]

    def matches(self, file: str) -> bool:
        """Whether a file, by its path as it is shown, or a folder above it is meant."""
        # As seen from its own folder: `tools/*` is for the files of tools, wherever archlint is started.
        parts = os.path.relpath(os.path.join(self.seen_from, file), self.base).replace(os.sep, "/").split("/")
        above = ["/".join(parts[: end + 1]) for end in range(len(parts))] if self._is_anchored else parts
        return any(fnmatchcase(name, pattern) for pattern in self._own() for name in above)
