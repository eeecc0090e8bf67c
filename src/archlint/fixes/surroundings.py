"""What fixes read beside their findings: the texts of files, each once."""

from __future__ import annotations

import os
from collections.abc import Callable, Collection, Sequence
from functools import cache, cached_property
from pathlib import Path

from archlint.disk import lies_in
from archlint.fixes.source import Source, read

_MOST_FILES = 1_000
"""How many files of a package are looked through for names in use."""


class Surroundings:
    """The texts of files; ``files`` are the Python files of the workspace.  ``given`` has the bytes of those that are
    not on the disk; paths are relative to ``folder``.  No fix changes what lies, through links, outside of ``inside``
    (:func:`archlint.disk.lies_in`)."""

    def __init__(
        self,
        files: Sequence[str] = (),
        given: Callable[[str], bytes | None] = lambda file: None,
        folder: Path = Path(),
        inside: Collection[str] = (),
    ) -> None:
        self._files = files
        self._given = given
        self._folder = folder
        self._inside = inside
        self._sources: dict[str, Source | None] = {}
        self._texts: dict[str, dict[str, str]] = {}

    def source(self, file: str) -> Source | None:
        if file not in self._sources:
            mine = lies_in(self._folder / file, self._inside)
            self._sources[file] = read(file, self._given(file), self._folder) if mine else None
        return self._sources[file]

    def elsewhere(self, source: Source) -> list[str]:
        """The texts of the other Python files of a file's package, and the names that fixes bring into them."""
        file = (self._folder / source.file).resolve()
        root = next((folder for folder in file.parents if self._is_package(folder)), file.parent)
        texts = self._texts_below(os.path.join(root, ""))
        others = (other for other in self._sources.values() if other is not None and other is not source)
        taken = (name for other in others for name in other.taken)
        return [*(text for path, text in texts.items() if path != str(file)), *sorted(taken)]

    def _is_package(self, folder: Path) -> bool:
        manifest = folder / "package.xml"
        given = self._given(str(manifest))
        return manifest.is_file() if given is None else bool(given)

    def _texts_below(self, root: str) -> dict[str, str]:
        """The texts of the Python files below a folder by their paths."""
        if root not in self._texts:
            inside = [path for path in self._real_paths if path.startswith(root)][:_MOST_FILES]
            sources = ((path, read(path, self._given(path))) for path in inside)
            self._texts[root] = {path: source.text for path, source in sources if source is not None}
        return self._texts[root]

    @cached_property
    def _real_paths(self) -> list[str]:
        """The paths of the files without symbolic links, in the order of their parts."""
        real_folder = cache(os.path.realpath)  # asked once for each folder: it looks at all folders around it
        paths = (os.path.join(real_folder(folder), name) for folder, name in map(os.path.split, self._files))
        real = {os.path.realpath(path) if os.path.islink(path) else path for path in paths}
        return sorted(real, key=lambda path: path.split(os.sep))
