"""The ROS packages that CMake files ask for, held against package.xml.

Source: ``find_package(… REQUIRED)`` of CMake stops a build without the package; colcon builds what package.xml names
first, be it needed to run alone (``get_recursive_dependencies`` of colcon-core asks for direct dependencies of all
categories, and for those of these that are needed to run), and rosdep installs no more than that.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_aside
from archlint.ros import packages, rosdep
from archlint.workspace.closure import closure
from archlint.workspace.comments import without_comments
from archlint.workspace.installed import FoundPackage
from archlint.workspace.manifest import condition_holds

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.installed import Installs
    from archlint.workspace.model import Package

_CMAKE = "ament_cmake"
_CMAKE_OF_ROS = "ament_cmake_ros"
"""It exports ament_cmake (``buildtool_export_depend`` of its package.xml), which the table of packages leaves open."""
_MODULE = "_cmake_module"
"""How packages are called that are there for the CMake files of others, such as ``eigen3_cmake_module``: whoever has
Eigen in its headers exports it, as ``px4_ros2_cpp`` does, and of a package from elsewhere nobody knows that."""
_BUILD_TYPES = frozenset({"ament_cmake", "cmake"})
_LETTERS = re.compile(r"[^a-z0-9]+")


def packages_to_declare(
    workspace: WorkspaceIndex, brought_by: Callable[[str], set[str]]
) -> Iterator[tuple[Package, FoundPackage]]:
    """Each package that a build stops without and that nothing declares; ``brought_by`` says what a package brings
    along."""
    known = packages.table().names | workspace.packages.keys()
    for folder in sorted(workspace.manifests):
        package = workspace.manifests[folder]
        installs = workspace.installs.get(package.name)
        if installs is None or installs.folder != folder or package.build_type not in _BUILD_TYPES or package.ros1:
            continue
        if is_aside(workspace, package.manifest.relative) or not installs.required:
            continue
        declared = {
            d.name for d in package.dependencies if d.kind != "doc" and condition_holds(d.condition) is not False
        }
        if _CMAKE_OF_ROS in declared:
            declared.add(_CMAKE)
        there = closure([package.name, *declared], brought_by)
        asked_for = [*installs.required, *_generators(installs)]
        own = [asked for asked in asked_for if folder == "." or asked.place.file.startswith(f"{folder}/")]
        for asked in own:
            if asked.of_tests and _builds_no_tests(workspace, asked.place.file):
                continue
            before = there
            if asked.name == _CMAKE and not _may_bring_cmake(workspace, declared, brought_by):
                before = frozenset(declared)
            if asked.name not in known or asked.name in before or _is_of_system(asked.name, declared - known):
                continue
            if asked.name.endswith(_MODULE) and there - known - rosdep.keys():
                continue
            yield package, asked


_NO_TESTS = re.compile(r"^[ \t]*set[ \t]*\([ \t]*BUILD_TESTING[ \t]+(?:OFF|NO|FALSE|0)\b", re.MULTILINE | re.IGNORECASE)


def _may_bring_cmake(workspace: WorkspaceIndex, declared: set[str], brought_by: Callable[[str], set[str]]) -> bool:
    """Whether a package that is declared may be there to build others with ament_cmake.  What others need when they run
    is no tool to build with, though it may need one itself."""
    of_ros, rosdep_keys = packages.table().names, rosdep.keys()
    for name in declared:
        known = name in of_ros or name in workspace.packages or name in rosdep_keys
        if not known or "cmake" in name or (name in workspace.packages and _CMAKE in brought_by(name)):
            return True
    return False


def _builds_no_tests(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether a CMake file turns its own tests off, so that nothing of them is asked for."""
    return _NO_TESTS.search(without_comments(workspace.tree.text(file) or "")) is not None


_GENERATORS = "rosidl_default_generators"


def _generators(installs: Installs) -> Iterator[FoundPackage]:
    """What a package that generates interfaces needs, where ``ament_auto_find_build_dependencies()`` has to find it by
    package.xml: without it there is no ``rosidl_generate_interfaces()``."""
    words = installs.words
    by_manifest = "ament_auto_find_build_dependencies" in words and words.isdisjoint({_GENERATORS, "rosidl_cmake"})
    if by_manifest and installs.generated_at is not None:
        yield FoundPackage(_GENERATORS, installs.generated_at)


def _is_of_system(name: str, declared: set[str]) -> bool:
    """Whether a package of the system has a name that contains that of one of ROS: ``liburdfdom-dev``."""
    letters = _LETTERS.sub("", name.lower())
    return any(letters in _LETTERS.sub("", other.lower()) for other in declared)


__all__ = ["packages_to_declare"]
