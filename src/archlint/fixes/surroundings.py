"""What fixes read beside their findings: the texts of files, each once."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from archlint.fixes.source import Source, read

_MOST_FILES = 1_000
"""How many files of a package are looked through for names in use."""


class Surroundings:
    """The texts of files; ``files`` are the Python files of the workspace."""

    def __init__(self, files: Sequence[str] = ()) -> None:
        self._files = files
        self._sources: dict[str, Source | None] = {}
        self._texts: dict[Path, dict[str, str]] = {}

    def source(self, file: str) -> Source | None:
        if file not in self._sources:
            self._sources[file] = read(file)
        return self._sources[file]

    def elsewhere(self, source: Source) -> str:
        """The text of the other Python files of a file's package, and the names that fixes bring into them."""
        file = Path(source.file).resolve()
        root = next((folder for folder in file.parents if (folder / "package.xml").is_file()), file.parent)
        if root not in self._texts:
            inside = sorted(
                {path for path in (Path(file_name).resolve() for file_name in self._files) if root in path.parents}
            )
            texts = ((str(path), read(str(path))) for path in inside[:_MOST_FILES])
            self._texts[root] = {name: read_source.text for name, read_source in texts if read_source is not None}
        taken = (name for other in self._sources.values() if other not in (None, source) for name in other.taken)
        return "\n".join((*(t for name, t in self._texts[root].items() if name != str(file)), *sorted(taken)))
