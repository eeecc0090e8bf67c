"""Which file an import means.

Python finds modules on ``sys.path``; in a ROS 2 workspace that is every installed package, and for a script
the folder it lies in.  Both are looked up by the dotted names that the find floor gave the files.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Literal

from archlint.syntax.facts import Class, Facts, Function, Import, ImportFrom, Stmt
from archlint.syntax.walk import statements_of
from archlint.workspace.closure import closure
from archlint.workspace.test_code import FileRoles

if TYPE_CHECKING:
    from archlint.workspace.model import Link, SourceFile


ScopeKind = Literal["module", "class", "function", "comprehension"]
ModuleState = Literal["new", "running", "done"]

_OF_ROS = frozenset(
    {
        *("ament_index_python", "launch", "launch_ros", "launch_testing", "launch_xml", "launch_yaml"),
        *("message_filters", "rclpy", "rosidl_runtime_py", "tf2_ros"),
    }
)
"""ROS's own Python packages.  A folder of such a name with an ``__init__.py`` in it, often ``launch``, is no such."""


@dataclass(frozen=True, slots=True, eq=False)
class Scope:
    """Where names live: one frame of a function, a class body or a module; ``key`` is its store identity.

    ``locals`` are the names that the function binds; None for modules and class bodies.
    """

    key: int
    parent: Scope | None
    module: Module
    kind: ScopeKind
    qualified: str
    bound: frozenset[str] | None = None
    outer: frozenset[str] = frozenset()
    """Names declared ``nonlocal`` or ``global``."""


@dataclass(eq=False)
class Module:
    """One Python file as a module; ``state`` says how far its top level has run."""

    file: SourceFile
    name: str
    facts: Facts
    scope: Scope | None = None
    state: ModuleState = "new"
    star_externals: list[str] = field(default_factory=list)
    """Foreign packages that this module star-imports from."""

    @property
    def path(self) -> str:
        return self.file.relative

    @property
    def is_package(self) -> bool:
        return self.file.path.replace("\\", "/").endswith("/__init__.py")

    @property
    def package_name(self) -> str:
        """The dotted name that relative imports start from."""
        return self.name if self.is_package else self.name.rpartition(".")[0]


class ModuleIndex:
    """Finds modules by name, compiling on demand what the screen left out."""

    def __init__(self, files: Iterable[SourceFile], facts_of: Callable[[SourceFile], Facts | None]) -> None:
        files = list(files)
        self.roles = FileRoles.of(file.relative for file in files)
        self._facts_of = facts_of
        self._modules: dict[str, Module | None] = {}
        self._by_name: dict[str, list[SourceFile]] = {}
        self._by_path: dict[str, SourceFile] = {}
        self._by_tail: dict[str, list[SourceFile]] = {}
        self._imported: dict[str, frozenset[str]] = {}
        for file in files:
            if file.kind not in ("python", "launch_python", "setup_py"):
                continue
            path = file.path.replace("\\", "/")
            self._by_path[path] = file
            for named in _names_of(file):
                self._by_path.setdefault(named.path.replace("\\", "/"), file)
                if named.module and file not in self._by_name.setdefault(named.module, []):
                    self._by_name[named.module].append(file)
            stem = path.removesuffix("/__init__.py").removesuffix(".py")
            self._by_tail.setdefault(stem.rpartition("/")[2], []).append(file)

    def module(self, file: SourceFile) -> Module | None:
        """The module of a file; None where it could not be compiled."""
        if file.path not in self._modules:
            facts = self._facts_of(file)
            name = file.module or file.path.rpartition("/")[2].removesuffix(".py")
            self._modules[file.path] = None if facts is None else Module(file, name, facts)
        return self._modules[file.path]

    def loaded(self) -> list[Module]:
        """The modules that some program has imported, in the order of their paths."""
        return sorted((m for m in self._modules.values() if m is not None and m.state == "done"), key=lambda m: m.path)

    def find(self, importer: Module, name: str, level: int = 0) -> Module | None:
        """The module called ``name`` for an import in ``importer``; None for foreign ones."""
        if level:
            return self._relative(importer, name, level)
        file = self._absolute(importer, name)
        return None if file is None else self.module(file)

    def imported_by(self, module: Module) -> frozenset[str]:
        """The shown paths of a module and of all that its imports lead to, wherever they stand in it."""
        if module.path not in self._imported:
            self._imported[module.path] = frozenset(other.path for other in closure([module], self._imports_of))
        return self._imported[module.path]

    def _imports_of(self, module: Module) -> Iterator[Module]:
        for part in _imports(module.facts.body):
            if isinstance(part, Import):
                names = [".".join(part.module.split(".")[:end]) for end in range(1, part.module.count(".") + 2)]
                level = 0
            else:
                names = [part.module, *(f"{part.module}.{name}".lstrip(".") for name, _ in part.names)]
                level = part.level
            for name in names:
                imported = self.find(module, name, level) if name or level else None
                if imported is not None:
                    yield imported

    def absolute_name(self, importer: Module, name: str, level: int) -> str:
        """The dotted name that a relative import stands for."""
        if not level:
            return name
        base = importer.package_name.split(".") if importer.package_name else []
        base = base[: len(base) - (level - 1)] if level > 1 else base
        return ".".join((*base, *([name] if name else [])))

    def _relative(self, importer: Module, name: str, level: int) -> Module | None:
        for named in _names_of(importer.file):
            folder = named.path.replace("\\", "/").rpartition("/")[0]
            for _ in range(level - 1):
                folder = folder.rpartition("/")[0]
            file = self._at("/".join((folder, *name.split("."))) if name else folder)
            if file is not None:
                return self.module(file)
        return None

    def _at(self, stem: str) -> SourceFile | None:
        return self._by_path.get(stem + ".py") or self._by_path.get(stem + "/__init__.py")

    def _absolute(self, importer: Module, name: str) -> SourceFile | None:
        candidates = self._by_name.get(name, [])
        top = name.partition(".")[0]
        if top in _OF_ROS:
            candidates = [file for file in candidates if file.package == top]
            return _nearest(importer, candidates) if candidates else None
        same = [file for file in candidates if file.package == importer.file.package]
        if same:
            return _nearest(importer, same)
        folder = importer.file.path.replace("\\", "/").rpartition("/")[0]
        beside = self._at("/".join((folder, *name.split("."))))
        if beside is not None and beside.path != importer.file.path:
            return beside
        if candidates:
            return _nearest(importer, candidates)
        return self._by_suffix(importer, name)

    def _by_suffix(self, importer: Module, name: str) -> SourceFile | None:
        """A dotted name below some folder of the same package that is put on the path by other means."""
        if "." not in name:
            return None
        tail = "/" + name.replace(".", "/")
        candidates = [
            file
            for file in self._by_tail.get(name.rpartition(".")[2], [])
            if file.package == importer.file.package
            and file.path.replace("\\", "/").removesuffix("/__init__.py").removesuffix(".py").endswith(tail)
        ]
        return _nearest(importer, candidates) if candidates else None


def _names_of(file: SourceFile) -> tuple[SourceFile | Link, ...]:
    """The file and the symbolic links that lead to it: each gives it a path, and perhaps a name to import it by."""
    return (file, *file.links)


def _imports(body: Sequence[Stmt]) -> Iterator[Import | ImportFrom]:
    """The imports of a module, those inside functions and classes included."""
    for statement in statements_of(body):
        if isinstance(statement, (Import, ImportFrom)):
            yield statement
        elif isinstance(statement, (Function, Class)):
            yield from _imports(statement.body)


def _nearest(importer: Module, files: list[SourceFile]) -> SourceFile:
    """The file that shares most of its path with the importer."""

    def shared(file: SourceFile) -> int:
        count = 0
        for one, other in zip(file.path.split("/"), importer.file.path.split("/"), strict=False):
            if one != other:
                break
            count += 1
        return count

    return min(files, key=lambda file: (-shared(file), file.path))
