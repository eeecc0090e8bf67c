"""Which file of a workspace an import means: that depends on which files there are, and on nothing in them."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable
from dataclasses import astuple
from functools import cached_property
from typing import TYPE_CHECKING

from archlint.workspace.includes import Includes
from archlint.workspace.model import COMPILED_KINDS
from archlint.workspace.test_code import FileRoles

if TYPE_CHECKING:
    from archlint.workspace.model import Link, SourceFile

_OF_ROS = frozenset(
    {
        *("ament_index_python", "launch", "launch_ros", "launch_testing", "launch_xml", "launch_yaml"),
        *("message_filters", "rclpy", "rosidl_runtime_py", "tf2_ros"),
    }
)
"""ROS's own Python packages.  A folder of such a name with an ``__init__.py`` in it, often ``launch``, is no such."""

ANYWHERE = -1
"""In place of the number of dots: the absolute import of code that says itself where Python looks for modules."""


class Importable:
    """The Python files among those of a workspace, by all names under which code can import them; and those of C++."""

    def __init__(self, files: Iterable[SourceFile]) -> None:
        self.all = files if isinstance(files, tuple) else tuple(files)
        self.roles = FileRoles.of(file.relative for file in self.all)
        self._by_name: dict[str, list[SourceFile]] = {}
        self._by_path: dict[str, SourceFile] = {}
        self._by_tail: dict[str, list[SourceFile]] = {}
        self._meant: dict[tuple[str, str, int], SourceFile | None] = {}
        """What the code of a module imports, by its path: the names and their dots."""
        self.includes = Includes()
        for file in self.all:
            if file.kind not in COMPILED_KINDS:
                continue
            path = file.path.replace("\\", "/")
            self._by_path[path] = file
            if file.kind in ("cpp", "parameter_library"):
                self.includes.add(file)
            if file.kind == "cpp":
                continue
            for named in _names_of(file):
                self._by_path.setdefault(named.path.replace("\\", "/"), file)
                alike = self._by_name.setdefault(named.module, []) if named.module else [file]
                if not alike or alike[-1] is not file:  # a link may give it the same name again
                    alike.append(file)
            stem = path.removesuffix("/__init__.py").removesuffix(".py")
            self._by_tail.setdefault(stem.rpartition("/")[2], []).append(file)

    @cached_property
    def digest(self) -> str:
        """Equal for the same files of the same kinds under the same names, those included that cannot be imported."""
        rows = [
            (file.relative, file.kind, file.package, file.module, list(map(astuple, file.links))) for file in self.all
        ]
        return hashlib.sha256(repr(rows).encode()).hexdigest()

    def meant(self, importer: SourceFile, name: str, level: int = 0) -> SourceFile | None:
        """The file that an import in another means; None for what is not here."""
        key = importer.path, name, level
        if key not in self._meant and importer.kind == "cpp":
            self._meant[key] = self.includes.find(importer, name)
        if key not in self._meant:  # every attribute of what a package gives is looked up, for it may be a module
            self._meant[key] = self._found(importer, name, level)
        return self._meant[key]

    def at(self, path: str) -> SourceFile | None:
        """The file with a path."""
        return self._by_path.get(path)

    def files(self) -> list[SourceFile]:
        """All files that can be imported, by their paths."""
        return [file for path, file in sorted(self._by_path.items()) if path == file.path.replace("\\", "/")]

    def _found(self, importer: SourceFile, name: str, level: int) -> SourceFile | None:
        if level == ANYWHERE:
            return None if self._is_any_of_several(importer, name) else self._absolute(importer, name)
        return self._relative(importer, name, level) if level else self._absolute(importer, name)

    def _is_any_of_several(self, importer: SourceFile, name: str) -> bool:
        """Whether several folders of the workspace have such a module, of which none is beside the importer and none
        installed with it."""
        named = self._by_name.get(name, [])
        own = importer.package is not None and any(file.package == importer.package for file in named)
        if own or self._beside(importer, name) is not None:
            return False
        files = [*named, *self._with_tail(name)]
        return len({file.path for file in files if file.path != importer.path}) > 1

    def _relative(self, importer: SourceFile, name: str, level: int) -> SourceFile | None:
        for named in _names_of(importer):
            folder = named.path.replace("\\", "/").rpartition("/")[0]
            for _ in range(level - 1):
                folder = folder.rpartition("/")[0]
            file = self._at("/".join((folder, *name.split("."))) if name else folder)
            if file is not None:
                return file
        return None

    def _at(self, stem: str) -> SourceFile | None:
        return self._by_path.get(stem + ".py") or self._by_path.get(stem + "/__init__.py")

    def _absolute(self, importer: SourceFile, name: str) -> SourceFile | None:
        candidates = self._by_name.get(name, [])
        top = name.partition(".")[0]
        if top in _OF_ROS:
            candidates = [file for file in candidates if file.package == top]
            return _nearest(importer, candidates) if candidates else None
        same = [file for file in candidates if file.package == importer.package]
        if same:
            return _nearest(importer, same)
        beside = self._beside(importer, name)
        if beside is not None:
            return beside
        if candidates:
            return _nearest(importer, candidates)
        return self._by_suffix(importer, name)

    def _by_suffix(self, importer: SourceFile, name: str) -> SourceFile | None:
        """A dotted name below some folder of the same package that is put on the path by other means."""
        if "." not in name:
            return None
        candidates = [file for file in self._with_tail(name) if file.package == importer.package]
        return _nearest(importer, candidates) if candidates else None

    def _with_tail(self, name: str) -> list[SourceFile]:
        """The files that have a dotted name below some folder."""
        tail = "/" + name.replace(".", "/")
        return [
            file
            for file in self._by_tail.get(name.rpartition(".")[2], [])
            if file.path.replace("\\", "/").removesuffix("/__init__.py").removesuffix(".py").endswith(tail)
        ]

    def _beside(self, importer: SourceFile, name: str) -> SourceFile | None:
        """The file with a name in the folder of another."""
        folder = importer.path.replace("\\", "/").rpartition("/")[0]
        beside = self._at("/".join((folder, *name.split("."))))
        return None if beside is None or beside.path == importer.path else beside


def _names_of(file: SourceFile) -> tuple[SourceFile | Link, ...]:
    """The file and the symbolic links that lead to it: each gives it a path, and perhaps a name to import it by."""
    return (file, *file.links)


def _nearest(importer: SourceFile, files: list[SourceFile]) -> SourceFile:
    """The file that shares most of its path with the importer."""

    def shared(file: SourceFile) -> int:
        count = 0
        for first, second in zip(file.path.split("/"), importer.path.split("/"), strict=False):
            if first != second:
                break
            count += 1
        return count

    return min(files, key=lambda file: (-shared(file), file.path))
