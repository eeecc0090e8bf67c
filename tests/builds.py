"""Files that exist only here, for what reads CMake files."""

from __future__ import annotations

from collections.abc import Mapping


class Build:
    """Texts by shown path."""

    def __init__(self, files: Mapping[str, str]) -> None:
        self.files = dict(files)

    def text(self, path: str) -> str | None:
        return self.files.get(path)

    def is_file(self, path: str) -> bool:
        return path in self.files

    def files_below(self, folder: str) -> list[str]:
        return sorted(path for path in self.files if folder == "." or path.startswith(f"{folder}/"))
