"""Which file an import means.

Python finds modules on ``sys.path``; in a ROS 2 workspace that is every installed package, and for a script
the folder it lies in.  Both are looked up by the dotted names that the find floor gave the files.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Collection, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Literal

from archlint.interpreter.imported_names import imported_names
from archlint.interpreter.includes import Includes
from archlint.interpreter.reads import Reads
from archlint.place import Place
from archlint.syntax.facts import Facts, Span
from archlint.workspace.closure import closure
from archlint.workspace.model import COMPILED_KINDS
from archlint.workspace.test_code import FileRoles

if TYPE_CHECKING:
    from archlint.workspace.model import Link, SourceFile
    from archlint.workspace.tree import Question


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
    reads: Reads = field(default_factory=Reads)
    """What its import has read."""
    places: dict[Span, Place] = field(default_factory=dict)
    """The places in it that were asked for so far."""

    @property
    def path(self) -> str:
        return self.file.relative

    def place(self, span: Span) -> Place:
        """A place in the file; code that runs again and again asks for the same ones."""
        place = self.places.get(span)
        if place is None:
            place = self.places[span] = Place(self.path, *span)
        return place

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
        self._meant: dict[tuple[str, str, int], SourceFile | None] = {}
        """What the code of a module imports, by its path: the names and their dots."""
        self._imported: dict[str, tuple[frozenset[Module], Reads]] = {}
        self._readers: list[Reads] = []
        """Who reads: a program, or a module whose import it has led to."""
        self._importing: list[str] | None = None
        """The modules that one import has led to so far."""
        self.scopes: set[int] = set()
        """The keys of the scopes of all modules that ran here."""
        self._written: dict[str, set[int]] = {}
        """The keys of objects of other modules that the import of a module has written, by its path."""
        self._changed: dict[str, tuple[int, frozenset[str]]] = {}
        """The paths of the modules whose objects those are, and how many keys that is known of: a module that runs
        later has later keys."""
        self.imported: set[str] = set()
        """The paths of the modules that some program has imported."""
        self.import_earlier: Callable[[Module], None] | None = None
        """Imports a module that a program imported whose result was kept."""
        self.import_all_earlier: Callable[[], None] | None = None
        """Imports all of these."""
        self.includes = Includes()
        for file in files:
            if file.kind not in COMPILED_KINDS:
                continue
            path = file.path.replace("\\", "/")
            self._by_path[path] = file
            if file.kind == "cpp":
                self.includes.add(file)
                continue
            for named in _names_of(file):
                self._by_path.setdefault(named.path.replace("\\", "/"), file)
                alike = self._by_name.setdefault(named.module, []) if named.module else [file]
                if not alike or alike[-1] is not file:  # a link may give it the same name again
                    alike.append(file)
            stem = path.removesuffix("/__init__.py").removesuffix(".py")
            self._by_tail.setdefault(stem.rpartition("/")[2], []).append(file)

    def asked_for(self) -> list[str]:
        """The shown paths of the modules that anybody has asked for."""
        return [module.path for module in self._modules.values() if module is not None]

    def module(self, file: SourceFile) -> Module | None:
        """The module of a file; None where it could not be compiled."""
        if self._readers:
            self._readers[-1].files.add(file.path)
        if file.path not in self._modules:
            facts = self._facts_of(file)
            name = file.module or file.path.rpartition("/")[2].removesuffix(".py")
            self._modules[file.path] = None if facts is None else Module(file, name, facts)
        return self._modules[file.path]

    def loaded(self) -> list[Module]:
        """The modules that some program has imported, in the order of their paths."""
        if self._readers:
            self._readers[-1].everything = True
        modules = (self.module(self._by_path[path]) for path in self.imported)
        return sorted((module for module in modules if module is not None), key=lambda module: module.path)

    def in_process(self, start: Module) -> list[Module]:
        """The modules that a program which begins with a module has in its process, in the order of their paths: those
        that it was seen to import, and those that its imports lead to."""
        by_imports = {module.file.path for module in self._modules_imported_by(start)}
        reads = self._readers[-1].with_imports(self.reads_of) if self._readers else Reads()
        modules = (self.module(self._by_path[path]) for path in by_imports | reads.used)
        return sorted((module for module in modules if module is not None), key=lambda module: module.path)

    def find(self, importer: Module, name: str, level: int = 0) -> Module | None:
        """The module called ``name`` for an import in ``importer``; None for foreign ones."""
        file = self.file_of(importer.file, name, level)
        if self._readers:
            self._readers[-1].lookups[importer.file.path, name, level] = None if file is None else file.path
        return None if file is None else self.module(file)

    def file_of(self, importer: SourceFile, name: str, level: int = 0) -> SourceFile | None:
        """The file that an import in another means; None for what is not here."""
        key = importer.path, name, level
        if key not in self._meant and importer.kind == "cpp":
            self._meant[key] = self.includes.find(importer, name)
        if key not in self._meant:  # every attribute of what a package gives is looked up, for it may be a module
            self._meant[key] = self._relative(importer, name, level) if level else self._absolute(importer, name)
        return self._meant[key]

    def at(self, path: str) -> SourceFile | None:
        """The file with a path."""
        return self._by_path.get(path)

    def files(self) -> list[SourceFile]:
        """All files that can be imported, by their paths."""
        return [file for path, file in sorted(self._by_path.items()) if path == file.path.replace("\\", "/")]

    def import_all(self) -> None:
        """Have all modules here that some program has imported."""
        if self._readers:
            self._readers[-1].everything = True
        if self.import_all_earlier is not None:
            self.import_all_earlier()

    # ------------------------------------------------------------------------------------------- what is read

    @contextmanager
    def reading(self, reads: Reads) -> Iterator[Reads]:
        """What is read inside is noted."""
        self._readers.append(reads)
        try:
            yield reads
        finally:
            self._readers.pop()

    def reads_of(self, path: str) -> Reads | None:
        """What the import of a module has read; None where it was not imported."""
        module = self._modules.get(path)
        return None if module is None or module.state == "new" else module.reads

    def note_writes(self, module: Module, older: set[int]) -> None:
        """The import of a module writes objects of others: their keys come to be in ``older``."""
        self._written[module.file.path] = older

    def all_read(self, reads: Reads) -> Reads:
        """What a program has read, with what the modules have read that it used, and those that changed their
        objects."""
        while True:
            every = reads.with_imports(self.reads_of)
            if self.writers(every.used) <= every.used:
                return every
            reads.used |= self.writers(every.used)

    def writers(self, used: Collection[str]) -> frozenset[str]:
        """The modules whose imports have changed objects of these modules: registered something with them, say."""
        writing = (path for path, keys in self._written.items() if keys)
        return frozenset(path for path in writing if not self._changed_by(path).isdisjoint(used))

    def _changed_by(self, path: str) -> frozenset[str]:
        """The modules whose objects the import of another has changed."""
        keys = self._written[path]
        count, changed = self._changed.get(path, (0, frozenset()))
        if count != len(keys):
            starts = {module.scope.key: of for of, module in self._modules.items() if module and module.scope}
            ordered = sorted(starts)
            changed = frozenset(starts[ordered[at - 1]] for key in keys if (at := bisect_right(ordered, key)))
            self._changed[path] = len(keys), changed
        return changed

    def writes(self, path: str) -> bool:
        """Whether the import of a module has changed objects of others."""
        return bool(self._written.get(path))

    def note_answer(self, question: Question, answer: str | None) -> None:
        """Something is asked of the disk."""
        if self._readers:
            self._readers[-1].answers[question] = answer

    def note_use(self, module: Module) -> None:
        """A module is imported, perhaps not for the first time."""
        if self._readers:
            self._readers[-1].used.add(module.file.path)

    @contextmanager
    def first_import(self, module: Module) -> Iterator[None]:
        """While the body of a module runs."""
        outermost = self._importing is None
        if self._importing is None:
            self._importing = []
            if self._readers:
                self._readers[-1].imports.append(self._importing)
        self._importing.append(module.file.path)
        try:
            with self.reading(module.reads):
                yield
        finally:
            self.imported.add(module.file.path)
            if module.scope is not None:
                self.scopes.add(module.scope.key)
            if outermost:
                self._importing = None

    @contextmanager
    def aside(self) -> Iterator[None]:
        """What is imported inside is nobody's."""
        readers, importing = self._readers, self._importing
        self._readers, self._importing = [], None
        try:
            yield
        finally:
            self._readers, self._importing = readers, importing

    def imported_by(self, module: Module) -> frozenset[str]:
        """The shown paths of a module and of all that its imports lead to, wherever they are in it."""
        return frozenset(imported.path for imported in self._modules_imported_by(module))

    def imported_by_any(self, modules: Iterable[Module]) -> frozenset[str]:
        """As :meth:`imported_by`, of several modules: what they share is followed once."""
        return frozenset(imported.path for imported in closure(modules, self._imports_of))

    def _modules_imported_by(self, module: Module) -> frozenset[Module]:
        if module.path not in self._imported:
            with self.reading(Reads()) as reads:
                self._imported[module.path] = closure([module], self._imports_of), reads
        modules, reads = self._imported[module.path]
        if self._readers:
            self._readers[-1].add(reads)
        return modules

    def _imports_of(self, module: Module) -> Iterator[Module]:
        for name, level in imported_names(module.facts):
            imported = self.find(module, name, level)
            if imported is not None:
                yield imported

    def absolute_name(self, importer: Module, name: str, level: int) -> str:
        """The dotted name that a relative import stands for."""
        if not level:
            return name
        base = importer.package_name.split(".") if importer.package_name else []
        base = base[: len(base) - (level - 1)] if level > 1 else base
        return ".".join((*base, *([name] if name else [])))

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
        folder = importer.path.replace("\\", "/").rpartition("/")[0]
        beside = self._at("/".join((folder, *name.split("."))))
        if beside is not None and beside.path != importer.path:
            return beside
        if candidates:
            return _nearest(importer, candidates)
        return self._by_suffix(importer, name)

    def _by_suffix(self, importer: SourceFile, name: str) -> SourceFile | None:
        """A dotted name below some folder of the same package that is put on the path by other means."""
        if "." not in name:
            return None
        tail = "/" + name.replace(".", "/")
        candidates = [
            file
            for file in self._by_tail.get(name.rpartition(".")[2], [])
            if file.package == importer.package
            and file.path.replace("\\", "/").removesuffix("/__init__.py").removesuffix(".py").endswith(tail)
        ]
        return _nearest(importer, candidates) if candidates else None


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
