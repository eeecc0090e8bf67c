"""PKG012: names in a CMakeLists.txt that nothing has."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.checks.dependency_uses import brought_by
from archlint.checks.folding import folds, with_others, with_places
from archlint.checks.packages import workspace_of
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding
from archlint.packaging.cmake_packages import cmake_packages
from archlint.packaging.cpp_includes import includes_any_of
from archlint.packaging.left_over_targets import left_over_targets
from archlint.ros import packages
from archlint.suggestions import did_you_mean, listed, nearest
from archlint.workspace.closure import closure

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.systems.model import System, WorkspaceIndex
    from archlint.workspace.installed import FoundPackage, Installs, MisspeltCommand, NameInCMake


@rule("PKG012", scope=Scope.WORKSPACE)
def unknown_cmake_name(system: System, options: Options) -> Iterator[Finding]:
    """Targets, packages and commands that are not there, where CMake stops, and packages that nothing registers."""
    workspace = workspace_of(system)
    if workspace is None:
        return
    for package, installs in cmake_packages(workspace):
        yield from (_variable(installs, named) for named in installs.unset_variables)
        yield from map(_command, installs.misspelt)
        if installs.unregistered_at is not None:
            yield _unregistered(installs, installs.unregistered_at)
        if installs.unbrought_at is not None and not _is_part(workspace, installs.unbrought_at.file, package.name):
            yield _unbrought(installs, installs.unbrought_at)
        if installs.names_of_nothing:
            yield from _of_build(workspace, installs, options)
        yield from (_of_python(installs, asked) for asked in installs.required if _is_of_python(workspace, asked.name))
        yield from (_itself(installs, asked) for asked in installs.required if _is_itself(installs, asked))
        yield from _misspelt_packages(workspace, installs, {row.name for row in package.dependencies}, options)


_PYTHON_PACKAGES = frozenset(
    {"ament_index_python", "joint_state_publisher", "joint_state_publisher_gui", "launch", "launch_ros", "launch_xml"}
    | {"launch_yaml", "nav2_simple_commander", "teleop_twist_keyboard", "tf_transformations"}
)
"""Packages of ROS with a setup.py and no CMakeLists.txt."""


def _is_of_python(workspace: WorkspaceIndex, name: str) -> bool:
    """Whether a package has nothing that ``find_package()`` finds: setup.py alone installs it, and no file of CMake."""
    package, installs = workspace.packages.get(name), workspace.installs.get(name)
    if package is None:
        return name in _PYTHON_PACKAGES
    cmake = installs is None or installs.open_files or any("cmake" in row.destination for row in installs.files)
    return package.build_type == "ament_python" and not cmake


def _of_python(installs: Installs, asked: FoundPackage) -> Finding:
    return finding(
        "PKG012",
        asked.place,
        f"find_package() is given '{asked.name}', a package of Python, which has no file for CMake: the build stops",
        help="remove the line: an <exec_depend> in package.xml is enough",
        identity=(installs.package, "find_package", asked.name),
        group=(asked.place.file, "python", asked.name),
    )


def _is_itself(installs: Installs, asked: FoundPackage) -> bool:
    """Whether a package that generates interfaces, which the build installs at its end, looks for itself before."""
    return asked.name == installs.package and bool(installs.generated) and "CMAKE_MODULE_PATH" not in installs.words


def _itself(installs: Installs, asked: FoundPackage) -> Finding:
    return finding(
        "PKG012",
        asked.place,
        f"find_package() is given '{asked.name}', this package itself, which is not installed yet: a clean build stops",
        help="remove the line: a target gets the types of its own package with rosidl_get_typesupport_target()",
        identity=(installs.package, "find_package", asked.name),
        group=(asked.place.file, "itself", asked.name),
    )


def _misspelt_packages(
    workspace: WorkspaceIndex, installs: Installs, declared: AbstractSet[str], options: Options
) -> Iterator[Finding]:
    """Packages that are nowhere, where package.xml declares one of almost the name that CMake never looks for."""
    known = packages.table().names | workspace.packages.keys()
    others = (declared & known) - {row.name for row in installs.required} - installs.looked_for
    for asked in installs.required:
        unknown = asked.name not in known | declared | SYSTEM | {*options.external} and asked.name.islower()
        meant = nearest(asked.name, others) if unknown else None
        if meant is not None:
            yield finding(
                "PKG012",
                asked.place,
                f"find_package() is given '{asked.name}', which is nowhere: the build stops; did you mean '{meant}'?",
                help=f"write {meant}, as package.xml does",
                identity=(installs.package, "find_package", asked.name),
                group=(asked.place.file, "misspelt", asked.name),
                meant=meant,
            )


def _command(misspelt: MisspeltCommand) -> Finding:
    return finding(
        "PKG012",
        misspelt.place,
        f"there is no command {misspelt.name}(): the build stops; did you mean {misspelt.meant}()?",
        help=f"write {misspelt.meant}",
        identity=(misspelt.place.file, "command", misspelt.name),
        group=(misspelt.place.file, "command", misspelt.name),
    )


def _unregistered(installs: Installs, last: Place) -> Finding:
    return finding(
        "PKG012",
        last,
        f"nothing calls ament_package(): ros2 run and launch do not find the package '{installs.package}'",
        help="write ament_package() at the end of this file",
        identity=(installs.package, "ament_package"),
        group=(last.file, "ament_package"),
    )


def _is_part(workspace: WorkspaceIndex, file: str, package: str) -> bool:
    """Whether the build of another package reads a CMake file, and may have found what it needs."""
    return any(file in other.build_files for name, other in workspace.installs.items() if name != package)


def _unbrought(installs: Installs, call: Place) -> Finding:
    return finding(
        "PKG012",
        call,
        "nothing brings the command ament_package(): the build stops, for no find_package() finds ament_cmake",
        help="add find_package(ament_cmake REQUIRED) below project()",
        identity=(installs.package, "ament_cmake"),
        group=(call.file, "ament_cmake"),
    )


def _of_build(workspace: WorkspaceIndex, installs: Installs, options: Options) -> Iterator[Finding]:
    known = packages.table().names | workspace.packages.keys()
    there = closure(installs.looked_for, lambda name: found_with(workspace, name))
    unknown = there - SYSTEM - known
    all_known = not unknown
    lacking = known - there - {*options.external} if all_known else frozenset[str]()
    left_over = left_over_targets(workspace, installs)
    for named in installs.names_of_nothing:
        if named.target in left_over:
            continue
        halves = _halves(named.name, known)
        if named.command == _PROJECT:
            yield _project(installs, named)
        elif not named.package:
            yield _target(installs, named, named.name in left_over)
        elif named.name in installs.targets and named.command == _TAKES_A_TARGET:
            yield _target_as_package(installs, named)
        elif named.name not in known and halves is not None:
            yield _two_names(installs, named, halves)
        elif named.command in (_TAKES_A_TARGET, _GENERATES) and (
            named.name in lacking
            or (named.name not in known | {*options.external} and _isfound_with_none(named.name, unknown))
        ):
            yield _package(workspace, installs, named)
        elif named.name not in known and named.name in _interfaces_of(installs) and named.command == _TAKES_A_TARGET:
            yield _interface(installs, named)


def _isfound_with_none(name: str, unknown: AbstractSet[str]) -> bool:
    """Whether none of the packages of which nobody knows what they find, too, may find one of interfaces: they have
    other names."""
    if _OF_MESSAGES.fullmatch(name) is None:
        return False
    words = {*name.split("_")}
    return all(words.isdisjoint(re.split(r"[\W_]+", other.lower())) for other in unknown)


def found_with(workspace: WorkspaceIndex, name: str) -> set[str]:
    """What ``find_package`` of a package finds, too: the packages that it exports."""
    installs = workspace.installs.get(name)
    return brought_by(name, workspace) | ({*installs.looked_for} if installs is not None else set())


SYSTEM = frozenset({"Boost", "Eigen3", "GTest", "OpenCV", "OpenMP", "PkgConfig", "Python3", "Threads"})
"""What CMake finds that finds no package of ROS with it."""
_PROJECT = "project"
_TAKES_A_TARGET = "ament_target_dependencies"
_GENERATES = "rosidl_generate_interfaces"
_OF_MESSAGES = re.compile(r"[a-z0-9_]+_(?:msgs|interfaces|srvs)")
"""How packages of interfaces are called: no package of the system is, which one that is found may find with it."""
_KINDS = frozenset({"action", "msg", "srv"})


def _variable(installs: Installs, named: NameInCMake) -> Finding:
    if "{" in named.name or "$" in named.name:
        message = f"CMake takes '{named.name}' as it is written: no variable is read"
        help = "write ${PROJECT_NAME} with a '$' and braces"
        return _finding(installs, named, message, help, "as written")
    message = f"nothing sets the variable '{named.name}', so that there is nothing in its place here"
    help = "write '${PROJECT_NAME}'"
    if named.name.startswith("CATKIN_"):
        folder = "lib" if "BIN" in named.name else "share"
        help = f"catkin of ROS 1 sets it: write {folder}/${{PROJECT_NAME}}"
    return _finding(installs, named, message, help, "variable")


def _project(installs: Installs, named: NameInCMake) -> Finding:
    names = f"the project is called '{named.name}', and this is package '{installs.package}'"
    message = f"{names}: ament_package() stops the build"
    return _finding(installs, named, message, f"write project({installs.package})", "project")


def _target(installs: Installs, named: NameInCMake, is_left_over: bool) -> Finding:
    near, hint = nearest(named.name, installs.targets), did_you_mean(named.name, installs.targets)
    help = f"write '{near}'" if near is not None else "add the add_executable() or add_library() that makes it"
    if is_left_over:
        there = [target.name for target in installs.built]
        instead = f", or write a target that there is: {listed(there)}" if 0 < len(there) <= _FEW else ""
        help = f"remove it{instead}; the package has no source left for another one"
    return _finding(
        installs,
        named,
        f"{named.command}() is given '{named.name}', a target that there is not: the build stops{hint}",
        help,
        _LEFT_OVER if is_left_over else "target",
    )


_LEFT_OVER = "left over"
_FEW = 3
"""How many targets are worth naming."""


def _target_as_package(installs: Installs, named: NameInCMake) -> Finding:
    message = f"'{named.name}' is a target, and {named.command}() takes one target and then packages: the build stops"
    return _finding(installs, named, message, f"call {named.command}() for '{named.name}', too", "both")


def _package(workspace: WorkspaceIndex, installs: Installs, named: NameInCMake) -> Finding:
    message = f"{named.command}() is given '{named.name}', which no find_package() has found: the build stops"
    help = f"add find_package({named.name} REQUIRED)"
    package = workspace.packages.get(installs.package)
    is_declared = package is not None and any(row.name == named.name for row in package.dependencies)
    wanted = is_declared or named.command != _TAKES_A_TARGET
    if not wanted and not includes_any_of(workspace, installs.package, named.name):
        help = f"take it off, for no source here includes a header of it; or {help}"
    return _finding(installs, named, message, help, "package")


def _interfaces_of(installs: Installs) -> frozenset[str]:
    """The names of the interfaces that a package generates."""
    files = (posixpath.basename(word) for word in installs.generated or ())
    return frozenset(name for name, dot, kind in (file.rpartition(".") for file in files) if dot and kind in _KINDS)


def _interface(installs: Installs, named: NameInCMake) -> Finding:
    message = f"'{named.name}' is an interface of this package, and {named.command}() takes packages: the build stops"
    help = "take it off: a target gets the types of its own package with rosidl_get_typesupport_target()"
    return _finding(installs, named, message, help, "interface")


def _two_names(installs: Installs, named: NameInCMake, halves: tuple[str, str]) -> Finding:
    message = f"{named.command}() is given '{named.name}', which is no package, but the names of two"
    help = f"write '{halves[0]}' and '{halves[1]}', with a space between them"
    return _finding(installs, named, message, help, "two names")


def _halves(name: str, known: frozenset[str]) -> tuple[str, str] | None:
    """The two packages whose names were written without a space."""
    pairs = ((name[:at], name[at:]) for at in range(2, len(name) - 1))
    return next((pair for pair in pairs if known.issuperset(pair)), None)


def _finding(installs: Installs, named: NameInCMake, message: str, help: str, kind: str) -> Finding:
    identity = (installs.package, named.command, named.name)
    cause = kind if kind == _LEFT_OVER else f"{kind} {named.name}"
    return finding("PKG012", named.place, message, help=help, identity=identity, group=(named.place.file, cause))


@folds("PKG012")
def _of_one_cause(findings: Sequence[Finding]) -> Finding:
    """One finding for a name, however many commands are given it, and one for all targets that were left over."""
    name = findings[0].identity[-1]
    others = [row for row in findings if row.identity[-1] != name]
    if not others:
        return with_others(findings, "another command is", "more commands are", "given it, too")
    names = listed([f"'{each}'" for each in dict.fromkeys(row.identity[-1] for row in others)])
    more = f"so it is with {names}"
    first = with_places(findings)
    return replace(first, message=f"{first.message}; {more}", help=(first.help or "").replace("it", "them", 1))


__all__ = ["SYSTEM", "found_with", "unknown_cmake_name"]
