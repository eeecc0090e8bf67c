"""The Python code of a workspace: which files there are in which package, and which of them import which."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING

from archlint.interpreter.modules import Module, ModuleIndex
from archlint.syntax.workspace_files import NO_WORKSPACE, WorkspaceFiles
from archlint.workspace.model import CODE_KINDS, PYTHON_KINDS
from archlint.workspace.words import WORD

if TYPE_CHECKING:
    from archlint.syntax.facts import Facts
    from archlint.workspace.installed import Installs
    from archlint.workspace.model import SourceFile, SourceKind


class WorkspaceCode:
    """Plain look-ups; a file is named by its shown path."""

    def __init__(
        self,
        files: WorkspaceFiles = NO_WORKSPACE,
        index: ModuleIndex | None = None,
        installs: Mapping[str, Installs] | None = None,
    ) -> None:
        self._files = files.files
        self._facts_of = files.facts_of
        self._index = index or ModuleIndex(files.importable, files.facts_of)
        self._tree = files.tree
        self._installs = installs or {}
        self._relevant = files.relevant
        self._by_path = {file.relative: file for file in files.files}

    def facts_at(self, path: str) -> Facts | None:
        """The facts of a file; None where it was not read, or is no Python."""
        file = self._by_path.get(path)
        return None if file is None or file.kind not in PYTHON_KINDS else self._facts_of(file)

    def cpp_facts_at(self, path: str) -> Facts | None:
        """The facts of a C++ file; None where it was not read, or is no C++."""
        file = self._by_path.get(path)
        return self._facts_of(file) if file is not None and file.kind == "cpp" and self._relevant(file) else None

    def cpp_files_that_mention(self, name: str) -> Sequence[str]:
        """The C++ files that can matter in which a name stands anywhere."""
        files = (file for file in self._files if file.kind == "cpp" and not file.context and self._relevant(file))
        return [file.relative for file in files if self.mentions(file.relative, name)]

    def cpp_files(self) -> Sequence[str]:
        """The C++ files that were asked for and that can matter."""
        files = (file for file in self._files if file.kind == "cpp" and not file.context)
        return [file.relative for file in files if self._relevant(file)]

    def asked_for(self) -> Sequence[tuple[SourceFile, Facts]]:
        """The files that were asked for and that can matter, with their facts."""
        return self._asked_for

    @cached_property
    def _asked_for(self) -> list[tuple[SourceFile, Facts]]:
        rows = [(file, self._facts_of(file)) for file in self._files if self._matters(file)]
        return [(file, read) for file, read in rows if read is not None]

    def judged(self) -> Sequence[tuple[SourceFile, Facts]]:
        """The same files, and the helpers that they import."""
        return self._judged

    @cached_property
    def _judged(self) -> list[tuple[SourceFile, Facts]]:
        asked_for = {file.relative for file, _ in self._asked_for}
        rows = [(file, self._facts_of(file)) for file in self._files if file.relative in asked_for | self.helpers]
        return [(file, read) for file, read in rows if read is not None]

    @cached_property
    def setup_files(self) -> list[tuple[SourceFile, Facts]]:
        """Each setup.py that was asked for."""
        setups = [file for file in self._files if file.kind == "setup_py" and not file.context]
        return [(file, read) for file in setups if (read := self._facts_of(file)) is not None]

    @cached_property
    def helpers(self) -> frozenset[str]:
        """The files of Python that those asked for import, be it through others, and that name nothing of ROS: what
        fails in them fails in the node that runs them all the same."""
        asked_for = [file.relative for file, _ in self._asked_for]
        others = {file.relative for file in self._files if file.kind == "python" and not file.context}
        return frozenset(others & self.reached_from(asked_for)).difference(asked_for)

    def _matters(self, file: SourceFile) -> bool:
        return not file.context and (file.kind == "launch_python" or (file.kind == "python" and self._relevant(file)))

    @cached_property
    def misread(self) -> frozenset[str | None]:
        """The packages, None for files outside of them, with a C++ file of which part was not understood."""
        sources = (file for file in self._files if file.kind == "cpp" and self._relevant(file))
        return frozenset(file.package for file in sources if (read := self._facts_of(file)) and read.problems)

    def kind_of(self, path: str) -> SourceKind | None:
        """What a file of the workspace is; None for one that is not among them."""
        file = self._by_path.get(path)
        return None if file is None else file.kind

    def mentions(self, path: str, word: str) -> bool:
        """Whether a word stands anywhere in a file, be it of Python or not."""
        if WORD.fullmatch(word):
            return self._tree.words.stand_in(path, word)
        if not all(self._tree.words.stand_in(path, part) for part in WORD.findall(word)):
            return False
        return bool(self._tree.lines_with(path, rf"(?<!\w){re.escape(word)}(?!\w)"))

    def files_that_mention(self, name: str) -> Sequence[str]:
        """The Python files, but for launch files, in which a name stands anywhere."""
        return self._tree.words.note(name, self._mentioning.get(name, ()))

    @cached_property
    def _mentioning(self) -> Mapping[str, Sequence[str]]:
        """The same files for each word of any of them."""
        mentioning: dict[str, list[str]] = {}
        for path in (file.relative for file in self._files if file.kind == "python"):
            for word in self._tree.words.of(path):
                mentioning.setdefault(word, []).append(path)
        return mentioning

    # ------------------------------------------------------------------------------------------ by package

    @cached_property
    def _packages(self) -> Mapping[str, Sequence[SourceFile]]:
        """The files of each package."""
        packages: dict[str, list[SourceFile]] = {}
        for file in self._files:
            if file.package is not None:
                packages.setdefault(file.package, []).append(file)
        return packages

    def modules_of(self, package: str) -> dict[str, str]:
        """The modules of a package by name, with their paths."""
        return {
            file.module: file.relative
            for file in self._packages.get(package, ())
            if file.module and file.kind in CODE_KINDS
        }

    def files_of(self, package: str) -> list[str]:
        """The Python files of a package that are no launch files, whether they are modules or scripts."""
        return [file.relative for file in self._packages.get(package, ()) if file.kind == "python"]

    def files_named(self, package: str, module: str) -> list[str]:
        """Files of a package whose path below the package's folder ends like a module's name."""
        tail, installs = "/" + module.replace(".", "/"), self._installs.get(package)
        ends, folder = (f"{tail}.py", f"{tail}/__init__.py"), "" if installs is None else f"{installs.folder}/"
        own = self._packages.get(package, ())
        ending = (file for file in own if f"/{file.relative.removeprefix(folder)}".endswith(ends))
        return [file.relative for file in own if file.module == module] or [file.relative for file in ending]

    # ------------------------------------------------------------------------------------------ by import

    @cached_property
    def top_modules(self) -> frozenset[str]:
        """The first segments of the names under which files of the workspace are imported."""
        return frozenset(file.module.partition(".")[0] for file in self._files if file.module)

    @cached_property
    def modules(self) -> Mapping[str, frozenset[str | None]]:
        """The dotted names of the modules of the workspace, and of the folders that they are in, with the packages that
        have them."""
        packages: dict[str, set[str | None]] = {}
        for file in self._files:
            for module in (file.module, *(link.module for link in file.links)):
                parts = module.split(".") if module else []
                for end in range(1, len(parts) + 1):
                    packages.setdefault(".".join(parts[:end]), set()).add(file.package)
        return {name: frozenset(having) for name, having in packages.items()}

    def is_local(self, file: SourceFile, module: str) -> bool:
        """Whether an import means a file of the same package."""
        importer = self._index.module(file)
        imported = None if importer is None else self._index.find(importer, module)
        return imported is not None and imported.file.package == file.package

    def imported(self, path: str, name: str, level: int = 0) -> Facts | None:
        """The facts of the file of the workspace that a file's import of a module leads to; None for foreign ones."""
        module = self._imported(path, name, level)
        return None if module is None else module.facts

    def _imported(self, path: str, name: str, level: int) -> Module | None:
        file = self._by_path.get(path)
        importer = None if file is None else self._index.module(file)
        return None if importer is None else self._index.find(importer, name, level)

    def path_of_import(self, path: str, name: str, level: int = 0) -> str | None:
        """The file of the workspace that a file's import of a module leads to; None for foreign ones."""
        imported = self._imported(path, name, level)
        return None if imported is None else imported.path

    def file_of_import(self, path: str, name: str, level: int = 0) -> str | None:
        """The file of the workspace that a file's import of a module leads to, if that is its name wherever it is
        imported: not one that Python finds because it lies beside a script."""
        imported = self._imported(path, name, level)
        importer = self._index.module(self._by_path[path])
        if imported is None or importer is None or imported.file.module is None:
            return None
        asked_for = self._index.absolute_name(importer, name, level)
        return imported.path if imported.file.module == asked_for else None

    @cached_property
    def installed_programs(self) -> frozenset[str]:
        """The files that installed programs start with."""
        starts: set[str] = set()
        for executable in (each for installs in self._installs.values() for each in installs.executables.values()):
            starts.update(
                [executable.script]
                if executable.script
                else self.files_named(executable.package, executable.module or "?")
            )
        return frozenset(starts)

    @cached_property
    def in_use(self) -> frozenset[str]:
        """The files that installed programs and launch files are, and all that these import."""
        launch_files = {file.relative for file in self._files if file.kind == "launch_python"}
        return self.reached_from(launch_files | self.installed_programs)

    def reached_from(self, starts: Iterable[str]) -> frozenset[str]:
        """Some files, and all that these import."""
        modules = (self._index.module(self._by_path[path]) for path in sorted(starts) if path in self._by_path)
        return self._index.imported_by_any(module for module in modules if module is not None)
