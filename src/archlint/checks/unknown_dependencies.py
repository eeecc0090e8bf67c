"""PKG008: dependencies in a package.xml that are neither packages nor keys of rosdep, where one is that was meant."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_aside
from archlint.analysis.pinned import is_on_focal
from archlint.checks.dependency_uses import FOR_OTHERS
from archlint.checks.folding import folds, with_others, with_the_same_cause
from archlint.checks.packages import workspace_of
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.connections.parts_elsewhere import is_fetched
from archlint.finding import Finding, Place, Severity
from archlint.packaging.absent_packages import has_a_rule_for_rosdep, is_a_key_of_some_file
from archlint.packaging.idle_dependencies import is_idle
from archlint.packaging.library_imports import imports_beside_nodes
from archlint.ros import packages, rosdep
from archlint.ros.mistaken_dependencies import Mistake, Mistaken, mistaken, modules_of_pip, of_python_2
from archlint.suggestions import distance
from archlint.workspace.manifest import condition_holds, is_up_to_the_machine

if TYPE_CHECKING:
    from archlint.systems.model import System, WorkspaceIndex
    from archlint.workspace.model import Dependency, Package

_BUILD_TYPE = "ament_python"
"""A build type that many declare like a package."""


@rule("PKG008", scope=Scope.WORKSPACE)
def unknown_dependency(system: System, options: Options) -> Iterator[Finding]:
    """Names that rosdep cannot find, each with the one that was meant."""
    workspace = workspace_of(system)
    if workspace is None:
        return
    for folder in sorted(workspace.manifests):
        yield from _of_manifest(workspace, workspace.manifests[folder], options)


def _mistake(diagnostic: Finding) -> tuple[str, str]:
    """What several manifests have in common that name the same unknown key: it, and what is to be done about it."""
    return diagnostic.identity[1], diagnostic.help


def _of_manifest(workspace: WorkspaceIndex, package: Package, options: Options) -> Iterator[Finding]:
    if package.ros1 or package.build_type == "catkin" or is_aside(workspace, package.manifest.relative):
        return
    there = packages.table().names | workspace.packages.keys()
    known = there.union(rosdep.keys(), options.external)
    asked = (d for d in reversed(package.dependencies) if condition_holds(d.condition))
    first = {d.name: d for d in asked if not is_up_to_the_machine(d.condition)}
    for dependency in sorted(first.values(), key=lambda d: d.line):
        outdated = of_python_2(dependency.name)
        if dependency.name not in known:
            yield from _unknown(workspace, package, dependency, there, options)
        elif outdated is not None and dependency.name not in there.union(options.external):
            told = _mistaken(package, dependency, outdated)
            yield replace(told, message=_ON_FOCAL.format(dependency.name)) if is_on_focal(workspace) else told


_ON_FOCAL = "'{}' is for Python 2, with which nothing of ROS 2 runs"
"""What rosdep still installs on Ubuntu 20.04."""


def names_meant(workspace: WorkspaceIndex, package: Package, options: Options) -> set[str]:
    """What a manifest means by names that nobody knows, but for tests: the finding about such a name says to write
    these instead."""
    told = {diagnostic.identity[1]: diagnostic.meant for diagnostic in _of_manifest(workspace, package, options)}
    return {told[d.name] for d in package.dependencies if d.kind not in FOR_OTHERS and told.get(d.name)}


def _unknown(
    workspace: WorkspaceIndex, package: Package, dependency: Dependency, there: frozenset[str], options: Options
) -> Iterator[Finding]:
    name = dependency.name
    if has_a_rule_for_rosdep(workspace, name):
        return
    if name == _BUILD_TYPE:
        yield _finding(package, dependency, "", _instead_of_build_type(workspace, package, dependency))
        return
    is_python = _is_of_python(workspace, package, name)
    successor = _successor(workspace, name)
    meant = rosdep.meant_by(name, there, is_python=is_python) or successor
    if meant in there and successor is None and _is_from_elsewhere(workspace, package, name):
        return
    meant = meant or _imported(workspace, package, name, there)
    meant = _PYTHON if meant == _CPP and _is_rclpy(workspace, package, dependency) else meant
    meant = "python3-opencv" if is_python and meant == "libopencv-dev" else meant
    is_python = is_python or (
        imports_beside_nodes(workspace, package, name) and not _by_cmake(workspace, package, name)
    )
    wrong = None if meant is not None else mistaken(name, there, is_python=is_python)
    if wrong is not None and not is_a_key_of_some_file(workspace, name):
        yield _mistaken(package, dependency, wrong)
    if meant is not None and _has_already(package, dependency, meant):
        yield _finding(package, dependency, meant, f"remove the line: '{meant}' is declared already")
    elif meant is not None:
        own = f", and add find_package({name} REQUIRED) to CMakeLists.txt, which takes its packages from here, and a "
        own += "target_link_libraries() for what uses it"
        needed = _is_found_by_name(workspace, package, dependency)
        yield _finding(package, dependency, meant, f"write '{meant}' instead{own if needed else ''}")
    elif wrong is None and is_idle(workspace, package, name, there.union(rosdep.keys(), options.external)):
        yield _idle(package, dependency, is_linked=_is_linked(workspace, package, name))


def _imported(workspace: WorkspaceIndex, package: Package, name: str, there: frozenset[str]) -> str | None:
    """The only package that is a letter away from a name, be that short, which Python code of the package has a word
    for and package.xml lacks."""
    lacking = there - {other.name for other in package.dependencies}
    near = [other for other in lacking if abs(len(other) - len(name)) <= 1 and distance(name, other, 1) <= 1]
    files = workspace.code.files_of(package.name) if near else ()
    used = [other for other in near if any(workspace.code.mentions(path, other) for path in files)]
    return used[0] if len(used) == 1 else None


def _is_from_elsewhere(workspace: WorkspaceIndex, package: Package, name: str) -> bool:
    """Whether a name that nobody knows, and that another resembles, is that of a package which is not here: code of the
    package has it as it is, ``#include <gpsr_msgs/msg/…>``, or a ``.repos`` file brings it."""
    used = workspace.code.cpp_files_that_mention(name)
    by_cpp = any(workspace.package_of(path) == package.name for path in used)
    by_python = any(workspace.code.mentions(path, name) for path in workspace.code.files_of(package.name))
    return by_cpp or by_python or is_fetched(workspace, name)


_CPP, _PYTHON = "rclcpp", "rclpy"


def _is_rclpy(workspace: WorkspaceIndex, package: Package, dependency: Dependency) -> bool:
    """Whether a name that is as near to rclpy as to rclcpp stands for rclpy: Python code of the package imports that,
    package.xml lacks it, and C++ code does not ask for the other one, which it would need for its build."""
    if distance(dependency.name, _PYTHON, 1) > 1 or any(other.name == _PYTHON for other in package.dependencies):
        return False
    sources = workspace.code.cpp_files_that_mention(_CPP) if dependency.kind != "exec" else ()
    if any(workspace.package_of(path) == package.name for path in sources):
        return False
    return any(workspace.code.mentions(path, _PYTHON) for path in workspace.code.files_of(package.name))


def _has_already(package: Package, dependency: Dependency, name: str) -> bool:
    """Whether package.xml declares a name for the same use: catkin_pkg refuses to read one that does so twice."""
    kinds = {other.kind for other in package.dependencies if other.name == name and condition_holds(other.condition)}
    return bool(kinds) and (dependency.kind == "depend" or not kinds.isdisjoint({"depend", dependency.kind}))


_SUCCEEDED = frozenset({"rosbag", "rviz"})
"""Packages of ROS 1 whose successors are called like them, with a 2 behind it."""


def _successor(workspace: WorkspaceIndex, name: str) -> str | None:
    """The package for ROS 2 that goes by a name with a 2 behind it: of ROS itself, or of the workspace."""
    newer = f"{name}2"
    return newer if name in _SUCCEEDED or newer in workspace.packages else None


_FINDS_DEPENDENCIES = "ament_auto_find_build_dependencies"
_WHEN_BUILDING = frozenset({"depend", "build", "build_export", "buildtool", "buildtool_export"})


def _is_found_by_name(workspace: WorkspaceIndex, package: Package, dependency: Dependency) -> bool:
    """Whether CMake looks for a package by the name that package.xml has for it, and by no other line."""
    installs = workspace.installs.get(package.name)
    if installs is None or _FINDS_DEPENDENCIES not in installs.words:
        return False
    asked_for = {required.name for required in installs.required}
    return dependency.kind in _WHEN_BUILDING and dependency.name not in asked_for


_BY_CMAKE = "ament_cmake"
_INSTALLS_PYTHON = "ament_cmake_python"


def _instead_of_build_type(workspace: WorkspaceIndex, package: Package, dependency: Dependency) -> str:
    if package.build_type == _BUILD_TYPE:
        return "remove the line: the build type in <export> is enough"
    installs = workspace.installs.get(package.name)
    if installs is not None and installs.words.isdisjoint({_INSTALLS_PYTHON, "ament_python_install_package"}):
        if _BY_CMAKE in installs.looked_for and all(other.name != _BY_CMAKE for other in package.dependencies):
            return f"write '{_BY_CMAKE}' instead, with which CMakeLists.txt builds: it installs no Python package"
        return "remove the line: CMakeLists.txt installs no Python package"
    if _has_already(package, dependency, _INSTALLS_PYTHON):
        return f"remove the line: '{_INSTALLS_PYTHON}' is declared already"
    both = installs is not None and installs.looked_for >= {_BY_CMAKE, _INSTALLS_PYTHON}
    if both and all(other.name != _BY_CMAKE for other in package.dependencies):
        return f"write '{_BY_CMAKE}' instead, and add '{_INSTALLS_PYTHON}': CMakeLists.txt asks for both"
    return f"write '{_INSTALLS_PYTHON}' instead, the package with ament_python_install_package()"


def _is_of_python(workspace: WorkspaceIndex, package: Package, name: str) -> bool:
    """Whether Python code of a package has a name in it, and its CMake files do not."""
    if _by_cmake(workspace, package, name):
        return False
    if "opencv" in name.lower() and package.build_type == "ament_python":
        return True  # whether or not its code uses that already
    words = {name, "cv2"} if "opencv" in name.lower() else modules_of_pip(name)
    return name.startswith("python") or any(
        workspace.code.mentions(path, word) for path in workspace.code.files_of(package.name) for word in words
    )


def _by_cmake(workspace: WorkspaceIndex, package: Package, name: str) -> bool:
    """Whether CMake files of a package have a name in them, or look for it as CMake writes it: ``OpenCV``."""
    installs = workspace.installs.get(package.name)
    looked_for = [] if installs is None else [other.lower() for other in installs.looked_for]
    return installs is not None and (name in installs.words or name.lower() in looked_for)


def _mistaken(package: Package, dependency: Dependency, wrong: Mistaken) -> Finding:
    """The finding about a name of which it is known what it is."""
    name, instead = dependency.name, wrong.instead
    help = f"write '{instead}' instead" if instead else "remove the line"
    if instead and _has_already(package, dependency, instead):
        help = f"remove the line: '{instead}' is declared already"
    if wrong.mistake is Mistake.OF_ROS_1:
        message = f"'{name}' is a package of ROS 1, which rosdep does not find for ROS 2"
    elif wrong.mistake is Mistake.OF_PYTHON_2:
        message = f"'{name}' is for Python 2, which Ubuntu has no packages of since 22.04: rosdep stops here"
    elif wrong.mistake is Mistake.OF_PYTHON:
        message = f"'{name}' is a module of Python itself, and no key of rosdep, which stops here"
    elif wrong.mistake is Mistake.NOT_FILLED_IN:
        message = f"'{name}' is no name of a package: rosdep stops here"
        help = "write the name of the package instead"
        if "::" in name:
            help = "a target of CMake: write the name of the package that has it, or remove the line if none has it"
    elif instead:
        return _finding(package, dependency, instead, help)
    else:
        message = f"'{name}' is no key of rosdep, which stops here"
        help = "remove the line, and install it in another way: rosdep has no rule of that name"
    return _told(package, dependency, instead, message, help)


def _finding(package: Package, dependency: Dependency, meant: str, help: str) -> Finding:
    hint = f": '{meant}' was probably meant" if meant else ": it is a build type"
    message = f"'{dependency.name}' is neither a ROS package nor a key of rosdep, which stops here{hint}"
    return _told(package, dependency, meant, message, help)


_OF_A_PACKAGE = frozenset({"driver", "drivers", "ros", "ros2"})
"""Words of names that only a package has, which is built from its source where it is not released."""


def _is_linked(workspace: WorkspaceIndex, package: Package, name: str) -> bool:
    """Whether the CMake files of a package name a library like it: ``libdome_motor.a`` is one of ``dome-motor``."""
    installs = workspace.installs.get(package.name)
    words = frozenset[str]() if installs is None else installs.words
    plain = _of_library(name)
    return any(_of_library(word.partition(".")[0]) == plain for word in words)


def _of_library(name: str) -> str:
    return name.lower().replace("-", "_").removeprefix("lib")


def _idle(package: Package, dependency: Dependency, *, is_linked: bool) -> Finding:
    message = f"'{dependency.name}' is neither a ROS package nor a key of rosdep, which stops here"
    if is_linked:
        help = (
            "give rosdep a rule for it, in a file of yours that its sources.list.d names, or install it in another way"
        )
        told = _told(package, dependency, "", message, f"{help} and remove the line")
        return replace(told, severity=Severity.INFO, group=("linked",))
    message += ", and nothing uses it"
    help = "remove the line, unless a package from elsewhere is meant"
    if not _OF_A_PACKAGE.isdisjoint(dependency.name.split("_")):
        help = "bring its source into the workspace, as with a .repos file, or remove the line if nothing needs it"
    told = _told(package, dependency, "", message, help)
    return replace(told, severity=Severity.INFO, group=("idle",))


def _told(package: Package, dependency: Dependency, meant: str, message: str, help: str) -> Finding:
    file, line = package.manifest.relative, dependency.line
    return finding(
        "PKG008",
        Place(file, line, 1, line, 1),
        message,
        help=help,
        identity=(package.name, dependency.name),
        group=("unknown",),
        meant=meant,
    )


def _by_cause(findings: Sequence[Finding]) -> Iterable[Sequence[Finding]]:
    return with_the_same_cause(findings, _mistake)


@folds("PKG008", across_workspaces=True, rows=_by_cause)
def _of_one_cause(findings: Sequence[Finding]) -> Finding:
    """One finding for all unknown names of a package.xml, or for one that several of these have."""
    if len({diagnostic.place.file for diagnostic in findings}) > 1:
        name = findings[0].identity[1]
        return with_others(findings, "another package.xml has", "more package.xml files have", "it, too", f"'{name}'")
    return with_others(findings, "another dependency of the file is", "more dependencies of the file are", "unknown")


__all__ = ["names_meant", "unknown_dependency"]
