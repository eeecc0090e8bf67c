"""PKG001: what the files of a package use and its package.xml does not declare."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator, Mapping, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Literal

from archlint.analysis.aside import is_not_installed
from archlint.analysis.ignored import words_ignored_at
from archlint.analysis.imports import imports_at_start
from archlint.analysis.interface_dependencies import not_handed, types_of_others
from archlint.analysis.kept import kept
from archlint.analysis.manifests import package_around
from archlint.analysis.skipped_packages import skipped_packages
from archlint.checks.packages import workspace_of
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.edit_sites import MissingDependencies, Sites
from archlint.finding import Finding, Place, Related
from archlint.launch.kinds import StartedKind
from archlint.ros import packages
from archlint.rulebook import rules
from archlint.suggestions import distance, meant, nearest
from archlint.workspace.closure import closure
from archlint.workspace.manifest import condition_holds

if TYPE_CHECKING:
    from archlint.launch.started import Started
    from archlint.systems.model import System, WorkspaceIndex
    from archlint.workspace.model import DependencyKind, Package


@dataclass(frozen=True, order=True)
class Use:
    """A place that needs another package, and how: it ``imports``, ``starts a node of`` or ``uses types of`` it.
    ``also`` are files on the way to it: it is enough if the package of one of them declares what is needed."""

    place: Place
    needed: str
    how: Literal["imports", "starts a node of", "uses types of"]
    also: tuple[str, ...] = ()


@rule("PKG001", scope=Scope.WORKSPACE)
def undeclared_dependency(system: System, options: Options) -> Iterator[Finding]:
    """ROS packages that are imported or launched and that package.xml does not name: one finding a package."""
    workspace = workspace_of(system)
    if workspace is None:
        return
    by_package = uses_by_package(workspace, options)
    used: dict[str, set[str]] = {}
    for folder, uses in by_package.items():
        used.setdefault(workspace.manifests[folder].name, set()).update(use.needed for use in uses)
    for folder, uses in sorted(by_package.items()):
        hidden = [use for use in uses if _is_hidden(workspace, use)]
        # What a comment allows is a finding of its own, for the comment to hide.
        shown = [use for use in uses if use not in hidden and not _closes_circle(use, workspace, folder, used)]
        for group in (shown, *([use] for use in hidden)):
            if group:
                yield _undeclared(workspace, workspace.manifests[folder], group)


def _closes_circle(use: Use, workspace: WorkspaceIndex, folder: str, used: Mapping[str, AbstractSet[str]]) -> bool:
    """Whether to declare it would close a circle of packages, which colcon refuses: PKG003 reports that.  ``used``
    is what each package uses and does not declare: if all follow the advice, they declare it."""
    return workspace.manifests[folder].name in _reachable(use.needed, workspace, used)


def _is_hidden(workspace: WorkspaceIndex, use: Use) -> bool:
    """Whether a comment hides what the rule says of a place."""
    names = {"PKG001", rules()["PKG001"].name.upper()}
    return any(word.upper() in names for word in words_ignored_at(workspace, use.place))


def uses_by_package(workspace: WorkspaceIndex, options: Options) -> dict[str, list[Use]]:
    """What each package (by its folder) uses and does not declare, in the order of the files."""
    key = (uses_by_package, options.external, options.ignored_in)
    return kept(workspace, key, lambda: _uses_by_package(workspace, options))


def _uses_by_package(workspace: WorkspaceIndex, options: Options) -> dict[str, list[Use]]:
    by_package: dict[str, list[Use]] = {}
    known = _Known(workspace, options)
    for use in sorted({*_imported(workspace), *_launched(workspace), *_in_interfaces(workspace)}):
        package = known.home(use.place.file)
        if package is None or package.build_type == "catkin" or options.is_ignored_in(use.place.file):
            continue
        if _installs_nothing(workspace, package) or _is_beside_cpp(workspace, package, use.place.file):
            continue
        if any(known.declares(file, use.needed) for file in (use.place.file, *use.also)):
            continue
        uses = by_package.setdefault(package.relative, [])
        here = replace(use, also=())
        if here not in uses:
            uses.append(here)
    return by_package


def _installs_nothing(workspace: WorkspaceIndex, package: Package) -> bool:
    """Whether a package is a folder of loose scripts, as far as its CMakeLists.txt goes: nothing of it is built, so
    that nothing of it can be started with ROS."""
    installs = workspace.installs.get(package.name)
    if installs is None or installs.folder != package.relative or not installs.build_files:
        return False
    some = installs.executables or installs.files or installs.open_executables or installs.open_files
    some = some or installs.generated_at is not None
    if package.build_type != "ament_cmake" or some or installs.mentioned:
        return False
    return not any("install" in word or word == "ament_auto_package" for word in installs.words)


def _is_beside_cpp(workspace: WorkspaceIndex, package: Package, file: str) -> bool:
    """Whether a file is a loose script of a package of C++ programs: no Python program of it is installed."""
    installs = workspace.installs.get(package.name)
    if package.build_type != "ament_cmake" or installs is None or not is_not_installed(workspace, file):
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

    def declares(self, file: str, needed: str) -> bool:
        """Whether a package is there wherever that around a file is installed."""
        package = self.home(file)
        if package is None:
            return False
        if package.relative not in self._there:
            self._there[package.relative] = _there(self._workspace, package)
        there = self._there[package.relative]
        return bool({needed, _ALSO.get(needed)} & there) or needed in self._external or self._of_family(needed, there)

    def _of_family(self, needed: str, there: frozenset[str]) -> bool:
        """Whether a package of which nobody knows what it brings has the name that those of its repository begin with:
        ``arm`` is the metapackage of ``arm_msgs``, or depends on it."""
        first = (needed[:at] for at, letter in enumerate(needed) if letter == "_")
        unread = (prefix for prefix in first if prefix not in self._workspace.packages)
        return any(prefix in there and prefix not in packages.table().brings for prefix in unread)


# ------------------------------------------------------------------------------------------- what is declared

_AT_RUN_TIME: frozenset[DependencyKind] = frozenset({"depend", "exec", "run", "build_export", "buildtool_export"})
_FOR_OTHERS: frozenset[DependencyKind] = frozenset({"test", "doc"})
"""What these declare is not installed where nodes run."""

_ALSO = {"tf2_ros": "tf2_ros_py", "tf2_ros_py": "tf2_ros", "launch": "launch_ros"}
"""The same thing as far as a manifest is concerned: the tutorials declare either one."""


def _there(workspace: WorkspaceIndex, package: Package) -> frozenset[str]:
    """The package itself, what it declares, what these need when they run, what that needs …: all installed."""
    declared = [d for d in package.dependencies if d.kind not in _FOR_OTHERS and condition_holds(d.condition)]
    return closure([package.name, *(d.name for d in declared)], lambda name: brought_by(name, workspace))


def brought_by(name: str, workspace: WorkspaceIndex) -> set[str]:
    """What a package needs when it runs, and what is installed with it therefore."""
    package = workspace.packages.get(name)
    if package is None:
        return set(packages.table().brings.get(name, ()))
    return {d.name for d in package.dependencies if d.kind in _AT_RUN_TIME and condition_holds(d.condition)}


# ----------------------------------------------------------------------------------------------- what is used

_OF_ROS2_LAUNCH = frozenset({"launch", "launch_ros", "launch_xml", "launch_yaml", "ament_index_python"})
"""What is there wherever a launch file is launched."""


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
        if needed is None or (of_launch and needed in _OF_ROS2_LAUNCH):
            continue
        if not workspace.code.is_local(file, statement.module):
            yield Use(statement.place, needed, "imports")


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
            if exact and judged and started.package.text:
                yield Use(place, started.package.text, "starts a node of", _on_the_way(started, place))


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


# -------------------------------------------------------------------------------------------------- the finding

_NAMED = 12
"""How many packages a message lists."""


def _undeclared(workspace: WorkspaceIndex, package: Package, uses: Sequence[Use]) -> Finding:
    """The finding for a package."""
    by_needed: dict[str, list[Use]] = {}
    for use in uses:
        by_needed.setdefault(use.needed, []).append(use)
    needed = sorted(by_needed)
    return finding(
        "PKG001",
        uses[0].place,
        _message(workspace, package, uses[0], needed),
        help=_help(package, needed),
        related=[
            *(related for related in _related(by_needed) if related.place != uses[0].place),
            *_misplaced(package, needed),
            *_left_out(workspace, needed),
        ],
        identity=(package.name, *needed),
        sites=_sites(workspace, package, needed),
    )


def _message(workspace: WorkspaceIndex, package: Package, first: Use, needed: Sequence[str]) -> str:
    declared = {d.name for d in package.dependencies if d.kind == "test" and condition_holds(d.condition)}
    for_tests = [name for name in needed if name in declared]
    if len(needed) == 1:
        verb = "declares for tests only" if for_tests else "does not declare"
        what = f"package '{package.name}' {first.how} '{first.needed}', which its package.xml {verb}"
        return what + _hint(workspace, package, first)
    more = f" and {len(needed) - _NAMED} more" if len(needed) > _NAMED else ""
    listed = ", ".join(needed[:_NAMED]) + more
    tests = f" ({', '.join(for_tests[:_NAMED])}: for tests only)" if for_tests else ""
    what = f"package '{package.name}' uses {len(needed)} packages that its package.xml does not declare"
    return f"{what}: {listed}{tests}"


def _hint(workspace: WorkspaceIndex, package: Package, use: Use) -> str:
    """The declared name that was meant, if no package is called so."""
    there = packages.table().names | workspace.packages.keys()
    declared = {d.name for d in package.dependencies} - there - {use.needed}
    near = nearest(use.needed, declared)
    is_slip = near is not None and distance(use.needed, near, 2) <= 2
    return meant(f"'{use.needed}' by '{near}'") if is_slip else ""


def _help(package: Package, needed: Sequence[str]) -> str:
    if not package.in_export.keys().isdisjoint(needed):
        return f"declare {'it' if len(needed) == 1 else 'each'} outside of <export>: entries inside it do not count"
    manifest, line = package.manifest.relative, f"<{_tag(package)}>{needed[0]}</{_tag(package)}>"
    return f"add {line} to {manifest}" if len(needed) == 1 else f"add a line like {line} for each to {manifest}"


def _related(by_needed: Mapping[str, Sequence[Use]]) -> Iterator[Related]:
    """The first use of each package; that of the primary place is in the message."""
    for name, uses in sorted(by_needed.items()):
        first = _FIRST[uses[0].how].format(name)
        more = len(uses) - 1
        yield Related(uses[0].place, first + (f" and at {more} more place{'s' * (more > 1)}" if more else ""))


_FIRST = {
    "imports": "'{}' is imported here",
    "starts a node of": "a node of '{}' is started here",
    "uses types of": "a type of '{}' is used here",
}


def _misplaced(package: Package, needed: Sequence[str]) -> Iterator[Related]:
    """Where the manifest has a dependency inside ``<export>``."""
    for name in needed:
        line = package.in_export.get(name)
        if line is not None:
            place = Place(package.manifest.relative, line, 1, line, 1)
            yield Related(place, f"'{name}' is inside <export> here, where it does not count")


def _left_out(workspace: WorkspaceIndex, needed: Sequence[str]) -> Iterator[Related]:
    """Where a script leaves packages of the workspace out of a build."""
    here = [name for name in needed if name in workspace.packages]
    for name, place in ((name, skipped_packages(workspace).get(name)) for name in here):
        if place is not None:
            yield Related(place, f"'{name}' is left out of a build here: one that depends on it would fail")


def _reachable(name: str, workspace: WorkspaceIndex, used: Mapping[str, AbstractSet[str]]) -> frozenset[str]:
    """The packages of this workspace that one of them may need, directly or not, itself included."""

    def needs(dependent: str) -> set[str]:
        package = workspace.packages.get(dependent)
        declared = [] if package is None else [d for d in package.dependencies if d.kind not in _FOR_OTHERS]
        named = {d.name for d in declared if condition_holds(d.condition)} | used.get(dependent, set())
        return named & workspace.packages.keys()

    return closure([name], needs)


def _tag(package: Package) -> str:
    """How a dependency for run time is called in the format of a package.xml."""
    return "run_depend" if package.format == 1 else "exec_depend"


def _sites(workspace: WorkspaceIndex, package: Package, needed: Sequence[str]) -> Sites | None:
    """What a fix adds to the manifest: only packages that are known, of this workspace or of rosdistro.  Format 1
    refuses one that is declared for tests, too; and who leaves a package out of a build decides what depends on it."""
    taken = {d.name for d in package.dependencies if package.format == 1}
    known = workspace.packages.keys() | packages.table().names
    names = tuple(name for name in needed if name in known and name not in taken and name not in package.in_export)
    here = any(name in workspace.packages for name in names)
    names = tuple(name for name in names if not here or name not in skipped_packages(workspace))
    if not names:
        return None
    return Sites(dependencies=(MissingDependencies(package.manifest.relative, _tag(package), names),))
