"""What the files of a package need of other packages, as far as its package.xml does not declare it."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING, Literal

from archlint.analysis.aside import is_not_installed
from archlint.analysis.kept import kept
from archlint.checks.registry import Options
from archlint.finding import Place
from archlint.launch.kinds import StartedKind
from archlint.packaging.absent_packages import is_from_nowhere
from archlint.packaging.build_dependencies import packages_to_declare
from archlint.packaging.commented_out import is_dependency_taken_out
from archlint.packaging.cpp_includes import packages_of_headers
from archlint.packaging.imports import imports_at_start
from archlint.packaging.interface_dependencies import not_handed, types_of_others
from archlint.packaging.launch_dependencies import packages_of_files, packages_of_includes, runs_of_programs
from archlint.packaging.manifests import package_around
from archlint.packaging.optional_packages import optional_packages, packages_looked_up
from archlint.packaging.other_workspaces import sources_another
from archlint.packaging.plugin_packages import packages_of_plugins
from archlint.records import dataclass
from archlint.ros import packages
from archlint.workspace.closure import closure
from archlint.workspace.folders import folders_above
from archlint.workspace.manifest import condition_holds

if TYPE_CHECKING:
    from archlint.launch.started import Started
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.model import DependencyKind, Package


How = Literal[
    "imports",
    "imports a module of",
    "starts a node of",
    "uses types of",
    "includes a launch file of",
    "takes files of",
    "looks for the folder of",
    "includes headers of",
    "runs the program",
    "loads a plugin of",
    "builds with",
    "builds its tests with",
    "tests with",
]
_IMPORTS: frozenset[How] = frozenset({"imports", "imports a module of"})
_LAUNCHES: frozenset[How] = frozenset({"starts a node of", "includes a launch file of", "takes files of"})
BUILDS: frozenset[How] = frozenset({"builds with", "builds its tests with", "includes headers of"})


@dataclass(frozen=True, order=True)
class Use:
    """A place that needs another package, and how: it ``imports``, ``starts a node of`` or ``uses types of`` it ….
    ``also`` are files on the way to it: it is enough if the package of one of them declares what is needed."""

    place: Place
    needed: str
    how: How
    also: tuple[str, ...] = ()
    unused: bool = False
    """Whether it is an import of which the file uses nothing."""


def uses_by_package(workspace: WorkspaceIndex, options: Options) -> dict[str, list[Use]]:
    """What each package (by its folder) uses and does not declare, in the order of the files."""
    key = (uses_by_package, options.external, options.ignored_in)
    return kept(workspace, key, lambda: _uses_by_package(workspace, options))


def _uses_by_package(workspace: WorkspaceIndex, options: Options) -> dict[str, list[Use]]:
    by_package: dict[str, list[Use]] = {}
    known = _Known(workspace, options)
    at_run_time = {*_imported(workspace), *_launched(workspace), *_in_interfaces(workspace), *_of_launch(workspace)}
    at_run_time |= {*_loaded(workspace), *_looked_up(workspace)}
    for use in sorted({*at_run_time, *_in_cpp(workspace), *_in_tests(workspace)}):
        package = known.home(use.place.file)
        if package is None or package.build_type == "catkin" or options.is_ignored_in(use.place.file):
            continue
        if _is_of_a_loose_file(workspace, package, use) or _is_beside_cpp(workspace, package, use):
            continue
        if any(known.declares(file, use) for file in (use.place.file, *use.also)):
            continue
        if _is_itself(workspace, package, use.needed) or _is_left_out(workspace, package, use):
            continue
        if use.how in _LAUNCHES and _is_optional(workspace, use):
            continue
        if is_dependency_taken_out(workspace, package, use.needed) or _is_of_another_workspace(workspace, use):
            continue
        if use.how == "tests with" and known.declares_for_tests(use.place.file, use.needed):
            continue
        uses = by_package.setdefault(package.relative, [])
        here = replace(use, also=())
        if here not in uses:
            uses.append(here)
    for package, asked in packages_to_declare(workspace, lambda name: brought_by(name, workspace)):
        if asked.name not in options.external and not options.is_ignored_in(asked.place.file):
            how: How = "builds its tests with" if asked.of_tests else "builds with"
            by_package.setdefault(package.relative, []).append(Use(asked.place, asked.name, how))
    return by_package


def _is_of_a_loose_file(workspace: WorkspaceIndex, package: Package, use: Use) -> bool:
    """Whether a package installs nothing but the interfaces that it makes, and a use is in anything else."""
    return use.how not in ("uses types of", "includes headers of") and _installs_nothing(workspace, package)


def _installs_nothing(workspace: WorkspaceIndex, package: Package) -> bool:
    """Whether a package is a folder of loose scripts, as far as its CMakeLists.txt goes: nothing of it is built but
    interfaces, so that nothing of it can be started with ROS."""
    installs = workspace.installs.get(package.name)
    if installs is None or installs.folder != package.relative or not installs.build_files:
        return False
    some = installs.executables or installs.files or installs.open_executables or installs.open_files
    if package.build_type != "ament_cmake" or some or installs.mentioned:
        return False
    return not any("install" in word or word == "ament_auto_package" for word in installs.words)


def _is_itself(workspace: WorkspaceIndex, package: Package, needed: str) -> bool:
    """Whether a name is one under which the package itself enters ament's index, beside that of its manifest."""
    installs = workspace.installs.get(package.name)
    return installs is not None and installs.folder == package.relative and installs.is_indexed_as(needed)


def _is_optional(workspace: WorkspaceIndex, use: Use) -> bool:
    """Whether a launch file catches that there is no such package, and goes on without it."""
    code = workspace.facts_at(use.place.file)
    return code is not None and use.needed in optional_packages(code)


def _is_of_another_workspace(workspace: WorkspaceIndex, use: Use) -> bool:
    """Whether a launch file sources the workspace, not this one, that has what it starts."""
    return use.needed not in workspace.packages and sources_another(workspace, use.place.file)


def _is_left_out(workspace: WorkspaceIndex, package: Package, use: Use) -> bool:
    """Whether an import is in a file below the installed Python code that no build installs, since its folder is no
    package of Python, and that no program reaches: it is run by hand, where it lies."""
    installs, file = workspace.installs.get(package.name), use.place.file
    code = None if installs is None else installs.python
    if installs is None or code is None or use.how not in _IMPORTS or installs.open_files or code.has(file):
        return False
    if file in workspace.code.in_use or any(installs.places_of(file)) or workspace.code.kind_of(file) != "python":
        return False
    return any(folder in code.folders for folder in folders_above(file))


def _is_beside_cpp(workspace: WorkspaceIndex, package: Package, use: Use) -> bool:
    """Whether a use is in a loose script of a package of C++ programs: no Python program of it is installed."""
    installs = workspace.installs.get(package.name)
    if package.build_type != "ament_cmake" or installs is None or use.how == "includes headers of":
        return False
    if not is_not_installed(workspace, use.place.file):
        return False
    return not any(executable.module or executable.script for executable in installs.executables.values())


class _Known:
    """What the packages around files declare, worked out once for each."""

    def __init__(self, workspace: WorkspaceIndex, options: Options) -> None:
        self._workspace = workspace
        self._external = options.external
        self._there: dict[str, frozenset[str]] = {}
        self._homes: dict[str, Package | None] = {}

    def home(self, file: str) -> Package | None:
        folder = posixpath.dirname(file) or "."
        if folder not in self._homes:
            self._homes[folder] = package_around(self._workspace, folder)
        return self._homes[folder]

    def declares(self, file: str, use: Use) -> bool:
        """Whether a package is there wherever that around a file is installed."""
        package, needed = self.home(file), use.needed
        if package is None:
            return False
        there = self._there.get(package.relative)
        if there is None:
            there = self._there[package.relative] = _there(self._workspace, package)
        return bool({needed, _ALSO.get(needed)} & there) or needed in self._external or self._of_family(needed, there)

    def declares_for_tests(self, file: str, needed: str) -> bool:
        """Whether a package is there where the tests of that around a file run."""
        package = self.home(file)
        declared = [] if package is None else [d.name for d in package.dependencies if d.kind != "doc"]
        return needed in closure(declared, lambda name: brought_by(name, self._workspace))

    def _of_family(self, needed: str, there: frozenset[str]) -> bool:
        """Whether a package of which nobody knows what it brings has the name that those of its repository begin with:
        ``arm`` is the metapackage of ``arm_msgs``, or depends on it."""
        first = (needed[:at] for at, letter in enumerate(needed) if letter == "_")
        unread = (prefix for prefix in first if prefix not in self._workspace.packages)
        return any(prefix in there and prefix not in packages.table().brings for prefix in unread)


# ------------------------------------------------------------------------------------------- what is declared

_AT_RUN_TIME: frozenset[DependencyKind] = frozenset({"depend", "exec", "run", "build_export", "buildtool_export"})
FOR_OTHERS: frozenset[DependencyKind] = frozenset({"test", "doc"})
"""What these declare is not installed where nodes run."""

_ALSO = {"tf2_ros": "tf2_ros_py", "tf2_ros_py": "tf2_ros", "launch": "launch_ros"}
"""The same thing as far as a manifest is concerned: the tutorials declare either one."""


def _there(workspace: WorkspaceIndex, package: Package) -> frozenset[str]:
    """The package itself, what it declares, what these need when they run, what that needs …: all installed, and built
    before it."""
    declared = [d for d in package.dependencies if d.kind not in FOR_OTHERS and condition_holds(d.condition)]
    there = closure([d.name for d in declared], lambda name: brought_by(name, workspace))
    return there | {package.name, *(d.name for d in declared)}


def brought_by(name: str, workspace: WorkspaceIndex) -> set[str]:
    """What a package needs when it runs, and what is installed with it therefore."""
    package = workspace.packages.get(name)
    if package is None:
        return set(packages.table().brings.get(name, ()))
    return {d.name for d in package.dependencies if d.kind in _AT_RUN_TIME and condition_holds(d.condition)}


# ----------------------------------------------------------------------------------------------- what is used

_OF_ROS2_LAUNCH = frozenset({"launch", "launch_ros", "launch_xml", "launch_yaml", "ament_index_python"})
"""What is there wherever a launch file is launched."""
_OF_DDS = "dds_"
"""The module that idlc of Cyclone DDS makes of a message, ``robot_msgs.msg.dds_``: no package of ROS has it."""


def _imported(workspace: WorkspaceIndex) -> Iterator[Use]:
    def has_module(package: str) -> bool:
        return package in workspace.packages and any(
            module == package or module.startswith(f"{package}.") for module in workspace.code.modules_of(package)
        )

    for statement in imports_at_start(workspace):
        file = statement.file
        if file.package is None or file.kind == "setup_py" or _beside_the_code(file.relative):
            continue
        of_launch = file.kind == "launch_python" or "/launch/" in f"/{file.relative}"
        needed = packages.package_of_module(statement.module, statement.names, has_module)
        if needed is None or (of_launch and needed in _OF_ROS2_LAUNCH) or _OF_DDS in statement.module.split("."):
            continue
        if not workspace.code.is_local(file, statement.module):
            how: How = "imports" if statement.module.partition(".")[0] == needed else "imports a module of"
            yield Use(statement.place, needed, how, unused=statement.unused)


_BESIDE = frozenset({"test", "tests", "doc", "docs", "example", "examples"})


def _beside_the_code(path: str) -> bool:
    """Test code, documentation and examples need not be installed with what they use."""
    return any(part in _BESIDE for part in path.split("/")) or posixpath.basename(path).startswith(
        ("test_", "conftest")
    )


def _launched(workspace: WorkspaceIndex) -> Iterator[Use]:
    for launched in workspace.launched:
        for started in launched.started:
            place = _named_at(started)
            exact = started.package.resolution == "exact" and not started.dormant
            judged = started.kind in (StartedKind.NODE, StartedKind.CONTAINER) and not _beside_the_code(place.file)
            if exact and judged and started.package.text and not _names_another_package(workspace, started):
                yield Use(place, started.package.text, "starts a node of", _on_the_way(started, place))


def _names_another_package(workspace: WorkspaceIndex, started: Started) -> bool:
    """Whether an executable is that of another package than the one that is named: LCH001 says to name that one."""
    name, named = started.executable.text, workspace.installs.get(started.package.text or "")
    if name is None or started.executable.resolution != "exact" or named is None or named.open_executables:
        return False
    if name in named.executables or name in named.mentioned or not named.build_files:
        return False
    return sum(name in installs.executables for installs in workspace.installs.values()) == 1


def _of_launch(workspace: WorkspaceIndex) -> Iterator[Use]:
    """What launch files need besides their nodes."""
    for place, needed in packages_of_includes(workspace):
        if not _beside_the_code(place.file):
            yield Use(place, needed, "includes a launch file of")
    for place, needed in packages_of_files(workspace):
        if not _beside_the_code(place.file):
            yield Use(place, needed, "takes files of")
    for place, needed in runs_of_programs(workspace):
        if not _beside_the_code(place.file):
            yield Use(place, needed, "runs the program")


def _loaded(workspace: WorkspaceIndex) -> Iterator[Use]:
    """The packages of the plugins that parameter files and descriptions name, where no package of the workspace
    declares them: they may be configured in one and started by another."""
    used = [*packages_of_plugins(workspace)]
    there = frozenset[str]().union(*(_there(workspace, package) for package in workspace.manifests.values() if used))
    for place, needed in used:
        if needed not in there and not _beside_the_code(place.file):
            yield Use(place, needed, "loads a plugin of")


def _looked_up(workspace: WorkspaceIndex) -> Iterator[Use]:
    """The packages that are nowhere and whose folders nodes look for: of others they may do without the files."""
    for file, code in workspace.code.judged():
        if file.kind == "python" and file.package is not None and not _beside_the_code(file.relative):
            for needed, span in packages_looked_up(workspace, file.relative) or ():
                if is_from_nowhere(workspace, needed) and needed not in optional_packages(code):
                    yield Use(Place(file.relative, *span), needed, "looks for the folder of")


def _in_cpp(workspace: WorkspaceIndex) -> Iterator[Use]:
    """The packages of the headers that C++ code includes."""
    for place, needed in packages_of_headers(workspace):
        yield Use(place, needed, "includes headers of")


_OF_TESTS = frozenset({"launch_testing", "launch_testing_ros", "launch_pytest"})


def _in_tests(workspace: WorkspaceIndex) -> Iterator[Use]:
    """The packages that are there for tests only."""
    for statement in imports_at_start(workspace):
        needed = packages.package_of_module(statement.module, statement.names, lambda package: False)
        if needed in _OF_TESTS and statement.file.package is not None and _beside_the_code(statement.file.relative):
            yield Use(statement.place, needed or "", "tests with")


def _in_interfaces(workspace: WorkspaceIndex) -> Iterator[Use]:
    """The types of other packages in interface files, but for those that CMake does not know of, either: PKG007."""
    lacking = {
        (row.package.name, row.needed) for row in not_handed(workspace, lambda name: brought_by(name, workspace))
    }
    for use in types_of_others(workspace):
        if (use.package.name, use.needed) not in lacking:
            yield Use(use.place, use.needed, "uses types of")


def _named_at(started: Started) -> Place:
    """Where the package of a node is named: with the launch file that calls a function that starts nodes, not in that
    function."""
    place, origin = started.places.get("package", started.place), started.package.origin
    return place if origin is None or origin.file != started.file else origin


def _on_the_way(started: Started, place: Place) -> tuple[str, ...]:
    """The other files that the name of a package passes through."""
    origin = started.package.origin
    files = {started.file, started.place.file, *(() if origin is None else (origin.file,))}
    return tuple(sorted(files - {place.file}))


__all__ = ["BUILDS", "FOR_OTHERS", "How", "Use", "brought_by", "uses_by_package"]
