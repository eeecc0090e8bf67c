"""Which file an ``#include`` means."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.workspace.kinds import CPP_SOURCES
from archlint.workspace.test_code import common_folder

if TYPE_CHECKING:
    from archlint.workspace.model import SourceFile


SOURCE = "#source "
"""With a number: the so manyth source of the package, which nobody can include under this name."""


class Includes:
    """The C++ files of a workspace, as the preprocessor finds them.

    A build may search any folder, so a file is found by the end of its path: the one beside the includer first, then
    one of its package, then the nearest.
    """

    def __init__(self) -> None:
        self._by_name: dict[str, list[SourceFile]] = {}
        self._sources: dict[str, list[SourceFile]] = {}
        self._generated: dict[str, list[SourceFile]] = {}
        """What headers are generated from, by their names as they are included: with the package, and without."""

    def add(self, file: SourceFile) -> None:
        if file.kind == "parameter_library":
            for module in file.modules:
                package, _, target = module.rpartition(".")
                for name in (f"{package}/{target}.hpp", f"{target}.hpp"):
                    self._generated.setdefault(name, []).append(file)
            return
        path = file.path.replace("\\", "/")
        self._by_name.setdefault(path.rpartition("/")[2], []).append(file)
        if path.rpartition(".")[2] in CPP_SOURCES:
            self._sources.setdefault(_home(file), []).append(file)

    def find(self, importer: SourceFile, name: str) -> SourceFile | None:
        """The file that an include in another means; None for what is not here."""
        if name.startswith(SOURCE):
            return self._source(importer, name.removeprefix(SOURCE))
        return self._written(importer, name) or self._generated_from(importer, name)

    def _generated_from(self, importer: SourceFile, name: str) -> SourceFile | None:
        """What a header is generated from; without its package in front, that of the own package counts."""
        files = self._generated.get(name, [])
        own = [file for file in files if file.package == importer.package]
        if not own and "/" not in name:
            return None
        return min(own or files, key=lambda file: file.path, default=None)

    def _written(self, importer: SourceFile, name: str) -> SourceFile | None:
        """The header that is there."""
        candidates = self._by_name.get(name.rpartition("/")[2], [])
        if not candidates:
            return None
        own = importer.path.replace("\\", "/")
        beside = f"{own.rpartition('/')[0]}/{name}"
        tail = "/" + name.lstrip("./")
        fitting = [file for file in candidates if file.path.replace("\\", "/").endswith(tail) and file is not importer]
        if not fitting:
            return None

        def rank(file: SourceFile) -> tuple[bool, bool, int, str]:
            path = file.path.replace("\\", "/")
            near = len(common_folder([path, own]))
            return path != beside, file.package != importer.package, -near, path

        return min(fitting, key=rank)

    def _source(self, importer: SourceFile, number: str) -> SourceFile | None:
        """The so manyth source; None where a file writes such a name itself, with anything for a number."""
        sources = self.sources_beside(importer)
        if not number.isdecimal() or len(number) > len(str(len(sources))):
            return None
        return sources[int(number)] if int(number) < len(sources) else None

    def is_header(self, file: SourceFile) -> bool:
        """Whether a file is a header of C++."""
        return file.kind == "cpp" and file.path.rpartition(".")[2] not in CPP_SOURCES

    def sources_beside(self, file: SourceFile) -> list[SourceFile]:
        """The C++ sources of the package of a file."""
        return self._sources.get(_home(file), [])


def _home(file: SourceFile) -> str:
    return file.package if file.package is not None else file.path.replace("\\", "/").rpartition("/")[0]


__all__ = ["Includes"]
