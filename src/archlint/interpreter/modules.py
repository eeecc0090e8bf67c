"""Which file an import means.

Python finds modules on ``sys.path``; in a ROS 2 workspace that is every installed package, and for a script
the folder it lies in.  Both are looked up by the dotted names that the find floor gave the files.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import field
from typing import TYPE_CHECKING, Literal

from archlint.interpreter.imported_names import imported_names
from archlint.interpreter.reads import Reads
from archlint.interpreter.search_path import changes_search_path
from archlint.place import Place
from archlint.records import dataclass
from archlint.syntax.facts import Facts, Span
from archlint.workspace.closure import closure
from archlint.workspace.importable import ANYWHERE, Importable

if TYPE_CHECKING:
    from archlint.workspace.model import SourceFile
    from archlint.workspace.tree import Question


ScopeKind = Literal["module", "class", "function", "comprehension"]
ModuleState = Literal["new", "running", "done"]


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
    includes: list[Module] = field(default_factory=list)
    """Of a file of C++, what it includes, in this order."""
    includers: list[Module] = field(default_factory=list)
    """The files that have included it so far."""
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

    def __init__(
        self, files: Importable | Iterable[SourceFile], facts_of: Callable[[SourceFile], Facts | None]
    ) -> None:
        self.importable = files if isinstance(files, Importable) else Importable(files)
        """Which file an import means."""
        self.roles = self.importable.roles
        self._facts_of = facts_of
        self._modules: dict[str, Module | None] = {}
        self._imported: dict[str, tuple[frozenset[Module], Reads]] = {}
        self._readers: list[Reads] = []
        """Who reads: a program, or a module whose import it has led to."""
        self._importing: list[str] | None = None
        """The modules that one import has led to so far."""
        self.scopes: set[int] = set()
        """The keys of the scopes of all modules that ran here."""
        self._written: dict[str, set[int]] = {}
        """The keys of objects of other modules that the import of a module has written, by its path."""
        self._known_changes: dict[str, frozenset[str]] = {}
        """The paths of these modules where only that is known of the import, which has not run here."""
        self._changed: dict[str, tuple[int, frozenset[str]]] = {}
        """The paths of the modules whose objects those are, and how many keys that is known of: a module that runs
        later has later keys."""
        self.imported: set[str] = set()
        """The paths of the modules that some program has imported."""
        self.import_earlier: Callable[[Module], None] | None = None
        """Imports a module that a program imported whose result was kept."""
        self.import_all_earlier: Callable[[], None] | None = None
        """Imports all of these."""
        self.overloads: dict[tuple[int, str], list[object]] = {}  # see overloads.py
        self.definitions: dict[tuple[int, str], dict[str, Scope]] = {}
        """The files that define a name which a file of C++ declares (declared.py), by their paths."""
        self.defaults: dict[tuple[int, str], list[object]] = {}
        """The default arguments of functions of C++ that stand in a declaration, by the key of class or file."""
        self.running = 0
        """How many modules run their top level, each imported by the one before."""
        self.including: dict[str, tuple[dict[str, list[Module]], Reads]] = {}  # see implementations.py
        self.unlinked: list[Module] = []
        """Modules that have run, and whose C++ sources have not been looked for."""

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
        modules = (self.module(file) for path in self.imported if (file := self.importable.at(path)) is not None)
        return sorted((module for module in modules if module is not None), key=lambda module: module.path)

    def in_process(self, start: Module) -> list[Module]:
        """The modules that a program which begins with a module has in its process, in the order of their paths: those
        that it was seen to import, and those that its imports lead to."""
        by_imports = {module.file.path for module in self._modules_imported_by(start)}
        reads = self._readers[-1].with_imports(self.reads_of) if self._readers else Reads()
        paths = by_imports | reads.used
        modules = (self.module(file) for path in paths if (file := self.importable.at(path)) is not None)
        return sorted((module for module in modules if module is not None), key=lambda module: module.path)

    def find(self, importer: Module, name: str, level: int = 0) -> Module | None:
        """The module called ``name`` for an import in ``importer``; None for foreign ones."""
        level = ANYWHERE if not level and changes_search_path(importer.facts) else level
        file = self.importable.meant(importer.file, name, level)
        if self._readers:
            self._readers[-1].lookups[importer.file.path, name, level] = None if file is None else file.path
        return None if file is None else self.module(file)

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
        writing = [path for path, keys in self._written.items() if keys]
        writing += [path for path in self._known_changes if path not in self._written]
        return frozenset(path for path in writing if not self.changed_by(path).isdisjoint(used))

    def changed_by(self, path: str) -> frozenset[str]:
        """The modules whose objects the import of another has changed."""
        if path not in self._written:
            return self._known_changes[path]
        keys = self._written[path]
        count, changed = self._changed.get(path, (0, frozenset()))
        if count != len(keys):
            starts = {module.scope.key: of for of, module in self._modules.items() if module and module.scope}
            ordered = sorted(starts)
            changed = frozenset(starts[ordered[at - 1]] for key in keys if (at := bisect_right(ordered, key)))
            self._changed[path] = len(keys), changed
        return changed

    def note_changes(self, changes: Mapping[str, Collection[str]]) -> None:
        """The imports of these modules are known, and have changed objects of those."""
        self._known_changes.update((path, frozenset(changed)) for path, changed in changes.items())

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
            if self._readers:  # the program, also where a header has led to a source of its own
                self._readers[0].imports.append(self._importing)
        self._importing.append(module.file.path)
        self.running += 1
        try:
            with self.reading(module.reads):
                yield
        finally:
            self.running -= 1
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
