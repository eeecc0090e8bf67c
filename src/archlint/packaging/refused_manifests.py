"""The package.xml files with which colcon cannot build what they describe."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_aside
from archlint.analysis.kept import once
from archlint.packaging.generated_files import is_ignored
from archlint.place import Place
from archlint.records import dataclass
from archlint.suggestions import nearest
from archlint.workspace.comments import replace_xml_comments
from archlint.workspace.refused_manifests import Refusal, refusals

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.model import Package

_PROJECTS = {"CMakeLists.txt": "plain CMake", "setup.py": "plain Python"}
"""What else colcon takes a folder for, by a file of it."""


@dataclass(frozen=True)
class RefusedManifest:
    """A mistake in a manifest, and what colcon does with the folder therefore: ``builds`` it as something else, or
    passes over it (empty)."""

    package: Package
    refusal: Refusal
    builds: str


@dataclass(frozen=True)
class Untyped:
    """A package without a ``<build_type>``, which colcon takes for one of catkin, and the type that it has."""

    package: Package
    build_type: str
    has_export: bool
    """Whether the manifest has the element that the type belongs in."""


def untyped_manifests(workspace: WorkspaceIndex) -> Iterator[Untyped]:
    """Each package of ROS 2 whose manifest says nothing of how it is built.

    Source: ``Package.get_build_type`` of catkin_pkg, which says ``catkin`` then.
    """
    for package in _judged(workspace):
        text = workspace.tree.text(package.manifest.relative) or ""
        build_type = _built_with(workspace, package)
        says_nothing = package.build_type == "catkin" and "<build_type" not in text and "catkin" not in text
        if says_nothing and build_type and not refusals(text):
            said = replace_xml_comments(text, lambda comment: "")
            yield Untyped(package, build_type, _EXPORT.search(said) is not None)


_EXPORT = re.compile(r"<export\s*/?>")
_AMENT = re.compile(r"^\s*ament_(?:auto_)?package\s*\(", re.MULTILINE)


def _built_with(workspace: WorkspaceIndex, package: Package) -> str:
    """How the build files of a folder want to be built; empty where that is not certain."""
    cmake, setup = (
        workspace.tree.text(posixpath.normpath(posixpath.join(package.relative, file))) for file in _PROJECTS
    )
    is_python = setup is not None and "catkin_pkg" not in setup
    if cmake is not None and not (is_python and _asks_for_python(package)):
        return "ament_cmake" if _AMENT.search(cmake) and "find_package(catkin" not in cmake else ""
    return "ament_python" if is_python else ""


@dataclass(frozen=True)
class Mistyped:
    """A package whose ``<build_type>`` is not that of its build files: the ``written`` one, and the right one.  The
    build file that is ``missing`` for the written one is empty where there is no such type."""

    package: Package
    written: str
    build_type: str
    missing: str
    place: Place


_TYPES = {"ament_cmake": "CMakeLists.txt", "ament_python": "setup.py"}
_OTHER_TYPES = frozenset({"ament_cargo", "ament_gradle", "ament_meson", "bazel", "cargo", "catkin", "cmake", "meson"})
_TYPE = re.compile(r"<build_type\b[^>]*>\s*([^<\s]+)\s*</build_type>")


def mistyped_manifests(workspace: WorkspaceIndex) -> Iterator[Mistyped]:
    """Each package that colcon cannot build with the type that its manifest has.

    Source: the build tasks of colcon-ros are named after the types that there are, and look for that build file.
    """
    for package in _judged(workspace):
        text = workspace.tree.text(package.manifest.relative) or ""
        types = [*_TYPE.finditer(replace_xml_comments(text, lambda comment: " " * len(comment)))]
        right = _built_with(workspace, package)
        if len(types) != 1 or not right or right == types[0][1] or refusals(text):
            continue
        written = types[0][1]
        path = posixpath.normpath(posixpath.join(package.relative, _TYPES.get(written, "")))
        of_another = written in _TYPES and not workspace.tree.is_file(path) and not is_ignored(workspace, path)
        no_type = written.startswith(tuple(_TYPES)) or nearest(written, _TYPES) is not None
        if of_another or (written not in {*_TYPES, *_OTHER_TYPES} and no_type):
            line = text.count("\n", 0, types[0].start()) + 1
            place = Place(package.manifest.relative, line, 1, line, 1)
            yield Mistyped(package, written, right, _TYPES.get(written, ""), place)


@once
def mistyped_packages(workspace: WorkspaceIndex) -> frozenset[str]:
    """The names of those packages: of what they install there is nothing before their manifest is mended."""
    return frozenset(row.package.name for row in mistyped_manifests(workspace))


def _asks_for_python(package: Package) -> bool:
    """Whether a package is to be built with ament_python, as its dependencies say, and not with CMake."""
    tools = {dependency.name for dependency in package.dependencies if dependency.kind == "buildtool"}
    return "ament_python" in tools and not any(tool.startswith("ament_cmake") for tool in tools)


def is_passed_over(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether a file is the setup.py of a package without a build type beside a CMakeLists.txt, which colcon runs
    instead."""
    folder, name = posixpath.split(file)
    package = workspace.manifests.get(folder or ".")
    untyped = name in ("setup.py", "setup.cfg") and package is not None and package.build_type == "catkin"
    return untyped and workspace.tree.is_file(posixpath.join(folder, "CMakeLists.txt"))


def refused_manifests(workspace: WorkspaceIndex) -> Iterator[RefusedManifest]:
    """Each mistake in the manifests of ROS 2."""
    for package in _judged(workspace):
        for refusal in refusals(workspace.tree.text(package.manifest.relative) or ""):
            yield RefusedManifest(package, refusal, _instead(workspace, package))


def _instead(workspace: WorkspaceIndex, package: Package) -> str:
    """What colcon takes the folder for: it knows projects of CMake and Python, too."""
    files = {posixpath.normpath(posixpath.join(package.relative, file)): kind for file, kind in _PROJECTS.items()}
    return next((kind for path, kind in files.items() if workspace.tree.is_file(path)), "")


def _judged(workspace: WorkspaceIndex) -> Iterator[Package]:
    for folder in sorted(workspace.manifests):
        package = workspace.manifests[folder]
        if not package.ros1 and not is_aside(workspace, package.manifest.relative):
            yield package


__all__ = [
    "Mistyped",
    "RefusedManifest",
    "Untyped",
    "is_passed_over",
    "mistyped_manifests",
    "mistyped_packages",
    "refused_manifests",
    "untyped_manifests",
]
