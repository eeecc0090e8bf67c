"""Loads launch files: Python through the symbolic run, XML and YAML through the frontends, includes with them."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Protocol

from archlint.faults import Faults
from archlint.finding import Place
from archlint.interpreter.heap import Store
from archlint.interpreter.modules import Module, ModuleIndex
from archlint.interpreter.values import FunctionValue, Instance, Known, ListValue, OneOf, Value, reason
from archlint.launch import actions
from archlint.launch.frontends import Frontend
from archlint.launch.model import (
    EXTERNAL,
    INSTALLED,
    MISSING,
    NOT_INSTALLED,
    UNKNOWN,
    FileReference,
    Launched,
    why_unknown,
)
from archlint.launch.run import LaunchRun
from archlint.launch.undefined import undefined_name
from archlint.syntax import facts
from archlint.syntax.launch_elements import LaunchFacts
from archlint.syntax.launch_xml import read_launch_xml
from archlint.syntax.launch_yaml import read_launch_yaml
from archlint.syntax.parameter_files import ParameterFacts, read_parameters
from archlint.workspace.installed import Installs

if TYPE_CHECKING:
    from archlint.workspace.model import SourceFile

INCLUDE_DEPTH = 24
INCLUDES = 400
"""How many includes one launch file may come to."""

FRONTENDS = (".xml", ".launch", ".yaml", ".yml")
GENERATE = "generate_launch_description"


class Tree(Protocol):
    def text(self, path: str) -> str | None: ...

    def unreadable(self, path: str) -> str | None: ...

    def is_file(self, path: str) -> bool: ...

    def is_folder(self, path: str) -> bool: ...

    def files_below(self, folder: str) -> Sequence[str]: ...


class LaunchLoader:
    """Reads launch files of one workspace; facts are read once, each launch is a run of its own."""

    def __init__(
        self,
        files: Sequence[SourceFile],
        facts_of: Callable[[SourceFile], facts.Facts | None],
        installs: Mapping[str, Installs],
        tree: Tree,
        relevant: Callable[[SourceFile], bool] = lambda file: True,
        faults: Faults | None = None,
        ros1_packages: frozenset[str] = frozenset(),
        distro: str | None = None,
    ) -> None:
        self._files = files
        self._facts_of = facts_of
        self.installs = installs
        self.tree = tree
        self.relevant = relevant
        self.ros1_packages = ros1_packages
        self.distro = distro
        self._by_path = {file.relative: file for file in files}
        self._frontend_facts: dict[str, LaunchFacts] = {}
        self._parameter_facts: dict[str, ParameterFacts] = {}
        self.index = ModuleIndex(files, facts_of)
        self.store = Store()
        self.faults = faults or Faults()
        self._tops: frozenset[str] | None = None
        self._launched: dict[str, Launched] = {}
        self.includes = 0
        self._endless: set[tuple[str, int, int, str]] = set()

    # ---------------------------------------------------------------------------------------------- files

    def launch_files(self) -> list[str]:
        """Every launch file of the workspace, sorted."""
        found = []
        for file in self._files:
            if self.index.roles.is_test(file.relative):
                continue
            if file.kind == "launch_python" or (file.kind == "python" and self._in_launch_folder(file)):
                if self.defines_launch(file.relative):
                    found.append(file.relative)
            elif file.kind in ("launch_xml", "launch_yaml") and self.frontend(file.relative).root is not None:
                found.append(file.relative)
        return sorted(found)

    def is_launch_file(self, path: str) -> bool:
        """Whether a file of the workspace can be launched."""
        if path not in self._by_path:
            return False
        return self.frontend(path).root is not None if self._is_frontend(path) else self.defines_launch(path)

    def facts_at(self, path: str) -> facts.Facts | None:
        """The facts of a Python file by its shown path."""
        file = self._by_path.get(path)
        return None if file is None else self._facts_of(file)

    @property
    def top_modules(self) -> frozenset[str]:
        """The first segments of the names under which files of the workspace are imported."""
        if self._tops is None:
            self._tops = frozenset(file.module.partition(".")[0] for file in self._files if file.module)
        return self._tops

    def python_facts(self) -> list[tuple[SourceFile, facts.Facts]]:
        """The Python files that were asked for and that can matter, with their facts."""
        rows = [(file, self._facts_of(file)) for file in self._files if self._matters(file)]
        return [(file, found) for file, found in rows if found is not None]

    def _matters(self, file: SourceFile) -> bool:
        return not file.context and (file.kind == "launch_python" or (file.kind == "python" and self.relevant(file)))

    def is_local(self, file: SourceFile, module: str) -> bool:
        """Whether an import means a file of the same package."""
        importer = self.index.module(file)
        found = None if importer is None else self.index.find(importer, module)
        return found is not None and found.file.package == file.package

    def imported(self, path: str, name: str, level: int = 0) -> facts.Facts | None:
        """The facts of the file of the workspace that a file's import of a module leads to; None for foreign ones."""
        module = self._imported(path, name, level)
        return None if module is None else module.facts

    def imported_of_package(self, path: str, name: str, level: int = 0) -> facts.Facts | None:
        """As :meth:`imported`; None for files of other packages, too."""
        file, module = self._by_path.get(path), self._imported(path, name, level)
        same = file is not None and module is not None and module.file.package == file.package
        return module.facts if same and module is not None else None

    def _imported(self, path: str, name: str, level: int) -> Module | None:
        file = self._by_path.get(path)
        importer = None if file is None else self.index.module(file)
        return None if importer is None else self.index.find(importer, name, level)

    def modules_of(self, package: str) -> dict[str, str]:
        """The modules of a package by name, with their paths."""
        return {
            file.module: file.relative
            for file in self._files
            if file.package == package and file.module and file.kind in ("python", "launch_python")
        }

    def python_files_of(self, package: str) -> list[str]:
        """The Python files of a package that are no launch files, whether they are modules or scripts."""
        return [file.relative for file in self._files if file.package == package and file.kind == "python"]

    def files_named(self, package: str, module: str) -> list[str]:
        """Files of a package whose path below the package's folder ends like a module's name."""
        tail, installs = "/" + module.replace(".", "/"), self.installs.get(package)
        ends, folder = (f"{tail}.py", f"{tail}/__init__.py"), "" if installs is None else f"{installs.folder}/"
        own = [file for file in self._files if file.package == package]
        ending = (file for file in own if f"/{file.relative.removeprefix(folder)}".endswith(ends))
        return [file.relative for file in own if file.module == module] or [file.relative for file in ending]

    def in_use(self) -> frozenset[str]:
        """The Python files that installed programs and launch files are, and all that these import."""
        starts = {file.relative for file in self._files if file.kind == "launch_python"}
        for one in (each for installs in self.installs.values() for each in installs.executables.values()):
            starts.update([one.script] if one.script else self.files_named(one.package, one.module or "?"))
        return self.reached_from(starts)

    def reached_from(self, starts: Iterable[str]) -> frozenset[str]:
        """Some Python files, and all that these import."""
        modules = (self.index.module(self._by_path[path]) for path in sorted(starts) if path in self._by_path)
        return frozenset[str]().union(*(self.index.imported_by(module) for module in modules if module is not None))

    def mentions(self, path: str, word: str) -> bool:
        """Whether a word stands anywhere in a file."""
        text = self.tree.text(path)
        return text is not None and re.search(rf"(?<!\w){re.escape(word)}(?!\w)", text) is not None

    def launched_once(self, path: str) -> Launched:
        """A launch file run on its own with its defaults; the same answer each time."""
        if path not in self._launched:
            self._launched[path] = self.launch(path)
        return self._launched[path]

    def problems(self) -> list[tuple[str, int, int, str]]:
        """``(file, line, column, message)`` of each launch file and ``setup.py`` that is broken, and of each
        parameter file that a launch file loads."""
        for file in self._files:
            if file.kind in ("launch_xml", "launch_yaml") and not file.context:
                self.frontend(file.relative)
        rows = [(path, one.problems) for path, one in self._frontend_facts.items()]
        rows += [(path, one.problems) for path, one in self._parameter_facts.items()]
        for file in self._files:
            if file.kind in ("launch_python", "setup_py") and not file.context and not self.relevant(file):
                found = self._facts_of(file)
                rows.append((file.relative, () if found is None else tuple(found.problems)))
        broken = {(path, p.line, p.column, p.message) for path, problems in rows for p in problems}
        return sorted(broken | self._endless)

    def ros1_files(self) -> list[str]:
        """The launch files that were asked for and are for ROS 1."""
        context = {file.relative for file in self._files if file.context}
        return sorted(path for path, one in self._frontend_facts.items() if one.ros1 and path not in context)

    def suppressions(self) -> dict[str, list[facts.Suppression]]:
        """What XML, YAML and parameter files suppress in place."""
        rows = [(path, one.suppressions) for path, one in self._frontend_facts.items()]
        rows += [(path, one.suppressions) for path, one in self._parameter_facts.items()]
        return {path: list(found) for path, found in rows if found}

    @staticmethod
    def _in_launch_folder(file: SourceFile) -> bool:
        return "launch" in file.relative

    def defines_launch(self, path: str) -> bool:
        file = self._by_path.get(path)
        found = None if file is None else self._facts_of(file)
        return found is not None and any(
            (isinstance(s, facts.Function) and s.name == GENERATE) or _star_import(s) for s in found.body
        )

    def frontend(self, path: str) -> LaunchFacts:
        if path not in self._frontend_facts:
            text = self.tree.text(path)
            found = LaunchFacts(problems=self._unreadable(path))
            if text is not None:
                with self.faults.contained("reading this launch file", Place(path, 1, 1, 1, 1)):
                    found = _read(path, text)
            package = self.package_of(path) if found.root is not None and not found.decided else None
            if package is not None:
                found = replace(found, ros1=package in self.ros1_packages)
            self._frontend_facts[path] = found
        return self._frontend_facts[path]

    def _is_frontend(self, path: str) -> bool:
        """Whether a launch file is XML or YAML; a ``.launch`` may be Python."""
        file = self._by_path.get(path)
        return path.endswith(FRONTENDS) and (file is None or file.kind != "launch_python")

    def parameters(self, path: str) -> ParameterFacts:
        if path not in self._parameter_facts:
            text = self.tree.text(path)
            found = ParameterFacts(problems=self._unreadable(path))
            if text is not None:
                with self.faults.contained("reading this parameter file", Place(path, 1, 1, 1, 1)):
                    found = read_parameters(text)
            self._parameter_facts[path] = found
        return self._parameter_facts[path]

    def _unreadable(self, path: str) -> tuple[facts.FileProblem, ...]:
        why = self.tree.unreadable(path)
        return () if why is None else (facts.FileProblem(1, 1, why),)

    def package_of(self, path: str) -> str | None:
        file = self._by_path.get(path)
        if file is not None:
            return file.package
        inside = [i for i in self.installs.values() if path.startswith(i.folder + "/") or i.folder == "."]
        return max(inside, key=lambda i: len(i.folder)).package if inside else None

    # ------------------------------------------------------------------------------------------- launches

    def launch(self, path: str, arguments: Mapping[str, str] | None = None) -> Launched:
        """Run a launch file as ``ros2 launch path name:=value …``; without arguments the defaults hold."""
        result = Launched(path, self.package_of(path), dict(arguments or {}))
        run = LaunchRun(self.index, self.store, self, path, result)
        self.includes = 0
        for name, value in (arguments or {}).items():
            run.launch.configurations[name] = Known(value)
        depth = self.store.depth
        self.store.push()
        try:
            self._enter(run, path)
        finally:
            self.store.cut(depth)
        if not arguments:
            self._launched.setdefault(path, result)
        return result

    def include(self, run: LaunchRun, reference: FileReference, plain: bool = False) -> None:
        """Run an included file in the same context: includes are not scoped.  A ``plain`` include gives no arguments,
        on which the included file might stop."""
        self.includes += 1
        if reference.source is None:
            if reference.status == UNKNOWN:
                run.gap(why_unknown(reference), "include", reference.place)
            return
        if reference.source in run.stack:
            run.gap(f"{reference.source} includes itself")
            circle = run.stack[run.stack.index(reference.source) :]
            if plain and not run.is_conditional and reference.source == min(circle):  # each circle once
                place = reference.place
                words = "this include never ends" if reference.source == place.file else "these includes never end"
                self._endless.add((place.file, place.line, place.column, f"{words}: {reference.source} comes again"))
            return
        if len(run.stack) >= INCLUDE_DEPTH or self.includes > INCLUDES:
            run.gap("more includes than can be followed")
            return
        run.includes.append(reference.place)
        self._enter(run, reference.source)
        run.includes.pop()

    def _enter(self, run: LaunchRun, path: str) -> None:
        kept, kept_place = run.file, run.place_now
        run.file = path
        run.place_now = Place(path, 1, 1, 1, 1)
        run.stack.append(path)
        try:
            if self._is_frontend(path):
                self._enter_frontend(run, path)
            else:
                self._enter_python(run, path)
        except Exception as error:
            run.note_fault("following this launch file", error, Place(path, 1, 1, 1, 1))
        finally:
            run.stack.pop()
            run.file, run.place_now = kept, kept_place

    def _enter_frontend(self, run: LaunchRun, path: str) -> None:
        found = self.frontend(path)
        if found.ros1:
            run.result.ros1 = run.result.ros1 or len(run.stack) == 1
            if len(run.stack) > 1:
                run.gap(f"{path} is a launch file of ROS 1")
        elif found.root is not None:
            frontend = Frontend(run, path)
            for element in found.root.children:
                for action in frontend.actions([element]):
                    actions.visit(run, action)
        else:
            why = found.problems[0].message if found.problems else "it is no launch file"
            run.gap(f"{path} cannot be read: {why}")

    def _enter_python(self, run: LaunchRun, path: str) -> None:
        file = self._by_path.get(path)
        module = None if file is None else self.index.module(file)
        if module is None:
            run.gap(f"{path} cannot be read")
            return
        lost = None if (found := self.facts_at(path)) is None else undefined_name(found, GENERATE)
        if lost is not None:
            run.result.undefined[Place(path, *lost.span)] = lost.id
            run.gap(f"{path} stops where it reads '{lost.id}', which is not defined")
            return
        with run.root(module):
            run.import_module(module)
            assert module.scope is not None
            run.activations[0].scope = module.scope
            function = run.module_attribute(module, GENERATE)
            if not isinstance(function, FunctionValue):
                run.result.is_launch_file = run.result.is_launch_file and len(run.stack) > 1
                run.gap(f"{path} has no {GENERATE}()")
                return
            description = run.call(function)
        if not isinstance(description, (Instance, ListValue, OneOf)):
            why = "it returns nothing" if isinstance(description, Known) else reason(description)
            run.gap(f"{GENERATE}() of {path} returns no launch description that is known: {why}")
        actions.visit(run, description)

    # ---------------------------------------------------------------------------------------------- paths

    def resolve(self, run: LaunchRun, kind: str, path: Value, place: Place) -> FileReference:
        """Which file of the workspace a path means."""
        conditional = run.is_conditional
        if not isinstance(path, Known) or not str(path.value):
            return FileReference(kind, None, None, UNKNOWN, None, place, reason(path), conditional)
        written = str(path.value)
        shared = _SHARE.match(written)
        if shared is not None:
            package, rest = shared[1], posixpath.normpath(shared[2].lstrip("/") or ".")
            source, status = self._in_package(package, rest)
        elif written.startswith("$(workspace)/"):
            package = self.package_of(run.file)
            source, status = self._beside(written.removeprefix("$(workspace)/"), package, run.file)
        else:
            return FileReference(kind, written, None, EXTERNAL, None, place, "a path of the machine", conditional)
        optional = conditional and posixpath.normpath(written) in run.asked_files
        return FileReference(kind, written, source, status, package, place, None, conditional, path.origin, optional)

    def _in_package(self, package: str, rest: str) -> tuple[str | None, str]:
        installs = self.installs.get(package)
        if installs is None:
            return None, EXTERNAL
        for source in installs.source_of(f"share/{package}/{rest}"):
            if self.tree.is_file(source) or self.tree.is_folder(source):
                return source, INSTALLED
        direct = posixpath.normpath(posixpath.join(installs.folder, rest))
        if self.tree.is_file(direct) or self.tree.is_folder(direct):
            return direct, INSTALLED if installs.open_files or not installs.build_files else NOT_INSTALLED
        return None, UNKNOWN if installs.open_files or not installs.build_files else MISSING

    def _beside(self, source: str, package: str | None, launch_file: str) -> tuple[str | None, str]:
        """A path that starts at the launch file itself."""
        source = posixpath.normpath(source)
        if self.tree.is_file(source):
            return source, INSTALLED
        installs = self.installs.get(package or "")
        if installs is None:
            return None, UNKNOWN
        # The launch file runs from where it is installed: the same way from there.
        way = posixpath.relpath(source, posixpath.dirname(launch_file) or ".")
        for place in (*installs.places_of(launch_file), self._beside_manifest(launch_file, installs)):
            found, status = self._in_share(posixpath.normpath(posixpath.join(posixpath.dirname(place), way)))
            if found is not None:
                return found, status
        return None, UNKNOWN if installs.open_files else MISSING

    @staticmethod
    def _beside_manifest(path: str, installs: Installs) -> str:
        """A file as if the folders of its package were installed as they are."""
        own = path if installs.folder == "." else path[len(installs.folder) + 1 :]
        return f"share/{installs.package}/{own}"

    def _in_share(self, path: str) -> tuple[str | None, str]:
        """What is installed at a path below the prefix."""
        share, _, below = path.partition("/")
        package, _, rest = below.partition("/")
        return self._in_package(package, rest or ".") if share == "share" and package else (None, MISSING)


_SHARE = re.compile(r"^\$\(find-pkg-share ([\w.-]+)\)(.*)$", re.DOTALL)


def _read(path: str, text: str) -> LaunchFacts:
    """launch tries its parsers one after the other on a file whose suffix says nothing."""
    if path.endswith((".yaml", ".yml")):
        return read_launch_yaml(text)
    if path.endswith(".launch") and not text.lstrip().startswith("<"):
        if _YAML.search(text):
            return read_launch_yaml(text)
        if GENERATE in text:
            return LaunchFacts()  # Python, for whoever runs it
    return read_launch_xml(text)


_YAML = re.compile(r"^launch\s*:", re.MULTILINE)


def _star_import(statement: facts.Stmt) -> bool:
    return isinstance(statement, facts.ImportFrom) and any(name == GENERATE for name, _ in statement.names)
