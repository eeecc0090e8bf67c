"""The launch files and parameter files of a workspace, each read once."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import field, replace
from typing import TYPE_CHECKING, NamedTuple

from archlint.faults import Faults
from archlint.finding import Place
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.launch_elements import LaunchFacts
from archlint.syntax.launch_templates import has_placeholders
from archlint.syntax.launch_xml import read_launch_xml, sounds_like_ros1
from archlint.syntax.launch_yaml import read_launch_yaml
from archlint.syntax.parameter_files import ParameterFacts, read_parameters
from archlint.syntax.workspace_files import NO_WORKSPACE, WorkspaceFiles
from archlint.workspace.model import LAUNCH_TEXT_KINDS
from archlint.workspace.owners import FileOwners
from archlint.workspace.test_code import FileRoles

if TYPE_CHECKING:
    from archlint.workspace.model import SourceFile

FRONTENDS = (".xml", ".launch", ".yaml", ".yml")
GENERATE = "generate_launch_description"


class Problem(NamedTuple):
    """What is wrong with a file, and where; ``internal`` where it is archlint's own fault."""

    file: str
    line: int
    column: int
    message: str
    internal: bool = False


"""``(file, line, column, message)``"""


@dataclass
class ReadFiles:
    """What was read for a launch, and the includes without end in it."""

    frontends: dict[str, None] = field(default_factory=dict)
    parameters: dict[str, None] = field(default_factory=dict)
    endless: dict[Problem, None] = field(default_factory=dict)


class LaunchFiles:
    """What launch files and the parameter files that they load say, without running anything."""

    def __init__(
        self,
        files: WorkspaceFiles = NO_WORKSPACE,
        owners: FileOwners | None = None,
        roles: FileRoles | None = None,
        faults: Faults | None = None,
        ros1_packages: frozenset[str] = frozenset(),
    ) -> None:
        self._files = files.files
        self._by_path = {file.relative: file for file in files.files}
        self._facts_of = files.facts_of
        self._relevant = files.relevant
        self._tree = files.tree
        self._owners = owners or FileOwners()
        self._roles = roles or FileRoles()
        self._faults = faults or Faults()
        self._ros1_packages = ros1_packages
        self._frontend_facts: dict[str, LaunchFacts] = {}
        self._parameter_facts: dict[str, ParameterFacts] = {}
        self._endless: set[Problem] = set()
        self._read = ReadFiles()
        """What is read now."""

    # ----------------------------------------------------------------------------------------- which there are

    def all(self) -> list[str]:
        """Every launch file of the workspace, sorted."""
        paths = []
        for file in self._files:
            if self._roles.is_test(file.relative):
                continue
            if file.kind == "launch_python" or (file.kind == "python" and "launch" in file.relative):
                if self._defines_launch(file):
                    paths.append(file.relative)
            elif self._may_be_launch_text(file) and self.frontend(file.relative).root is not None:
                paths.append(file.relative)
        return sorted(paths)

    def _may_be_launch_text(self, file: SourceFile) -> bool:
        """Whether a file is a launch file in XML or YAML by its name, or lies in a folder ``launch`` and says
        ``launch:``: ``ros2 launch`` takes a YAML file of any name."""
        if file.kind in LAUNCH_TEXT_KINDS:
            return True
        beside_launch_files = file.kind == "parameters" and "launch" in file.relative.split("/")[:-1]
        return beside_launch_files and self._says_launch(file)

    def _says_launch(self, file: SourceFile) -> bool:
        """Whether a line of a YAML file is the key ``launch``."""
        return _YAML.search(self._tree.text(file.relative) or "") is not None

    def of_tests(self) -> list[str]:
        """The launch files of test code, which are not among :meth:`all`."""
        kinds = {"launch_python", *LAUNCH_TEXT_KINDS}
        return sorted(
            file.relative for file in self._files if file.kind in kinds and self._roles.is_test(file.relative)
        )

    def can_be_launched(self, path: str) -> bool:
        """Whether a file of the workspace is a launch file."""
        file = self._by_path.get(path)
        if file is None:
            return False
        if not self.is_frontend(path):
            return self._defines_launch(file)
        # A parameter file is never read as a launch file: what only launch refuses of its YAML is no error there.
        return (file.kind != "parameters" or self._says_launch(file)) and self.frontend(path).root is not None

    def _defines_launch(self, file: SourceFile) -> bool:
        module_facts = self._facts_of(file)
        return module_facts is not None and any(map(_makes_description, module_facts.body))

    def is_frontend(self, path: str) -> bool:
        """Whether a launch file is XML or YAML; a ``.launch`` may be Python."""
        file = self._by_path.get(path)
        return path.endswith(FRONTENDS) and (file is None or file.kind != "launch_python")

    # --------------------------------------------------------------------------------------- what is in them

    def source_file(self, path: str) -> SourceFile | None:
        """A Python file by its shown path."""
        return self._by_path.get(path)

    def python(self, path: str) -> facts.Facts | None:
        """The facts of a Python file by its shown path."""
        file = self._by_path.get(path)
        return None if file is None else self._facts_of(file)

    def frontend(self, path: str) -> LaunchFacts:
        """The elements of a launch file in XML or YAML."""
        self._read.frontends[path] = None
        self._tree.read_again(path)
        if path not in self._frontend_facts:
            text = self._tree.text(path)
            launch_facts = LaunchFacts(problems=self._unreadable(path))
            if text is not None:
                with self._faults.contained("reading this launch file", Place(path, 1, 1, 1, 1)):
                    launch_facts = launch_facts_of(path, text)
            if self._is_for_others(path, text or "", launch_facts):
                launch_facts = LaunchFacts()
            package = (
                self._owners.package_of(path) if launch_facts.root is not None and not launch_facts.decided else None
            )
            if package is not None:
                launch_facts = replace(launch_facts, ros1=package in self._ros1_packages)
            self._frontend_facts[path] = launch_facts
        return self._frontend_facts[path]

    def _is_for_others(self, path: str, text: str, launch_facts: LaunchFacts) -> bool:
        """Whether ``ros2 launch`` is never meant to read a file: a template; what is malformed and put aside or written
        for ROS 1."""
        if launch_facts.root is not None:
            return has_placeholders(launch_facts.root)
        aside = "templates" in path.split("/")[:-1] or self._roles.is_put_aside(path)
        return bool(launch_facts.problems) and (aside or sounds_like_ros1(text))

    def parameters(self, path: str) -> ParameterFacts:
        """What a parameter file sets."""
        self._read.parameters[path] = None
        self._tree.read_again(path)
        if path not in self._parameter_facts:
            text = self._tree.text(path)
            parameter_facts = ParameterFacts(problems=self._unreadable(path))
            if text is not None:
                with self._faults.contained("reading this parameter file", Place(path, 1, 1, 1, 1)):
                    parameter_facts = read_parameters(text)
            self._parameter_facts[path] = parameter_facts
        return self._parameter_facts[path]

    def _unreadable(self, path: str) -> tuple[facts.FileProblem, ...]:
        why = self._tree.unreadable(path)
        return () if why is None else (facts.FileProblem(1, 1, why),)

    # --------------------------------------------------------------------------------------- what is wrong with them

    def note_endless(self, place: Place, message: str) -> None:
        """An include leads back to its own file, and nothing ends that."""
        problem = Problem(place.file, place.line, place.column, message)
        self._read.endless[problem] = None
        self._endless.add(problem)

    @contextmanager
    def reading(self) -> Iterator[ReadFiles]:
        """What is read inside."""
        before, self._read = self._read, ReadFiles()
        try:
            yield self._read
        finally:
            self._read = before

    def read_for(self, files: ReadFiles) -> None:
        """A launch is known, and so it is not run: read what it would have read."""
        for path in files.frontends:
            self.frontend(path)
        for path in files.parameters:
            self.parameters(path)
        self._endless.update(files.endless)

    def problems(self) -> list[Problem]:
        """What is wrong with each launch file and ``setup.py`` that is broken, and with each parameter file that a
        launch file loads."""
        for file in self._files:
            if file.kind in LAUNCH_TEXT_KINDS and not file.context:
                self.frontend(file.relative)
        rows = [(path, launch_facts.problems) for path, launch_facts in self._frontend_facts.items()]
        rows += [(path, parameter_facts.problems) for path, parameter_facts in self._parameter_facts.items()]
        for file in self._files:
            if file.kind in ("launch_python", "setup_py") and not file.context and not self._relevant(file):
                file_facts = self._facts_of(file)
                rows.append((file.relative, () if file_facts is None else tuple(file_facts.problems)))
        broken = {Problem(path, p.line, p.column, p.message, p.internal) for path, problems in rows for p in problems}
        return sorted(broken | self._endless)

    def of_ros1(self) -> list[str]:
        """The launch files that were asked for and are for ROS 1."""
        context = {file.relative for file in self._files if file.context}
        return sorted(
            path for path, launch_facts in self._frontend_facts.items() if launch_facts.ros1 and path not in context
        )

    def suppressions(self) -> dict[str, list[facts.Suppression]]:
        """What XML, YAML and parameter files suppress in place."""
        rows = [(path, launch_facts.suppressions) for path, launch_facts in self._frontend_facts.items()]
        rows += [(path, parameter_facts.suppressions) for path, parameter_facts in self._parameter_facts.items()]
        return {path: list(suppressions) for path, suppressions in rows if suppressions}


def launch_facts_of(path: str, text: str) -> LaunchFacts:
    """What a launch file in XML or YAML says.  launch tries its parsers one after the other on a file whose suffix says
    nothing."""
    if path.endswith((".yaml", ".yml")):
        return read_launch_yaml(text)
    if path.endswith(".launch") and not text.lstrip().startswith("<"):
        if _YAML.search(text):
            return read_launch_yaml(text)
        if GENERATE in text:
            return LaunchFacts()  # Python, for whoever runs it
    return read_launch_xml(text)


_YAML = re.compile(r"^launch\s*:", re.MULTILINE)


def _makes_description(statement: facts.Stmt) -> bool:
    """Whether a statement of a module gives it what launch calls, by its own definition or by an import."""
    match statement:
        case facts.Function(name=name):
            return name == GENERATE
        case facts.ImportFrom(names=names):
            return any(name == GENERATE for name, _ in names)
    return False
