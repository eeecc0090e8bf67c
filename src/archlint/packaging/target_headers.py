"""The headers that the sources of a CMake target include, held against the packages that CMake gives the target.

Source: since Humble the packages of ROS install their headers into ``include/PACKAGE``, so that the headers of one are
not in the folder of another one; a package of the workspace has a folder of its own anyway.
"""

from __future__ import annotations

import posixpath
import re
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_disused
from archlint.analysis.pinned import may_be_on_focal
from archlint.packaging.cmake_packages import cmake_packages
from archlint.packaging.cpp_includes import has_header, includes_of
from archlint.place import Place
from archlint.programs.built_targets import TYPE_SUPPORT
from archlint.records import dataclass
from archlint.ros import packages
from archlint.workspace.closure import closure

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.installed import BuiltTarget, Installs

Brings = Callable[[str], set[str]]
"""What the headers of a package may need, too: all that it depends on."""


@dataclass(frozen=True)
class HeaderNotGiven:
    """A target whose sources include a header of a ``package`` that nothing gives it, first ``at`` a place; of its own
    package it is one that is made of an interface file."""

    target: BuiltTarget
    package: str
    header: str
    at: Place
    is_found: bool
    """Whether a ``find_package()`` looks for the package."""


def headers_not_given(workspace: WorkspaceIndex, brought_by: Brings) -> Iterator[tuple[Installs, HeaderNotGiven]]:
    """Each package of which a target lacks the headers."""
    for _, installs in cmake_packages(workspace):
        if any(not named.package for named in installs.names_of_nothing):
            continue  # what a misspelt target is given, another lacks
        judge = _Judge(workspace, installs, brought_by)
        for target in installs.built:
            yield from ((installs, row) for row in judge.of(target))


class _Judge:
    def __init__(self, workspace: WorkspaceIndex, installs: Installs, brought_by: Brings) -> None:
        self._workspace, self._installs, self._brought_by = workspace, installs, brought_by
        self._targets = {target.name: target for target in installs.built}
        self._is_old = may_be_on_focal(workspace)

    def of(self, target: BuiltTarget) -> Iterator[HeaderNotGiven]:
        there = self._there(target)
        if there is None:
            return
        told: set[str] = set()
        for source in target.sources:
            if is_disused(self._workspace, source) or not self._workspace.tree.is_file(source):
                continue
            for header, line in includes_of(self._workspace.tree.text(source) or ""):
                package = header.partition("/")[0]
                if package not in told and package not in there and self._is_needed(package, header, there):
                    told.add(package)
                    at = Place(source, line, 1, line, 1)
                    yield HeaderNotGiven(target, package, header, at, package in self._installs.looked_for)

    def _there(self, target: BuiltTarget) -> frozenset[str] | None:
        """All whose headers a target sees; None where that is not known."""
        names = closure([target.name], lambda name: self._targets[name].given if name in self._targets else ())
        own = names & self._targets.keys()
        others = names - own - {TYPE_SUPPORT, *self._types_of_own()}
        if any(self._targets[name].open for name in own) or not all(map(self._is_read, others)):
            return None
        brought = closure(others, self._leads_to)
        if TYPE_SUPPORT in names:
            brought |= {self._installs.package, *self._installs.looked_for}
        return brought | {self._installs.package} if not self._generates() else brought

    def _types_of_own(self) -> set[str]:
        return {self._installs.package} if self._generates() else set()

    def _generates(self) -> bool:
        return self._installs.generated_at is not None and not _GENERATED & self._installs.words

    def _is_read(self, name: str) -> bool:
        """Whether it is known what a name brings: a package of which all is known, or a library of the system."""
        if name in self._workspace.packages or name in packages.table().brings or name in _BRING_NO_MORE:
            return True
        if name in packages.table().names or name in self._installs.targets:
            return False
        return name not in self._installs.looked_for or name != name.lower() or name in _OF_SYSTEM

    def _leads_to(self, name: str) -> set[str]:
        installs = self._workspace.installs.get(name)
        return self._brought_by(name) | ({*installs.looked_for} if installs is not None else set())

    def _is_needed(self, package: str, header: str, there: frozenset[str]) -> bool:
        """Whether nothing but the package has a header, wherever others of the build are installed."""
        workspace = self._workspace
        if package == self._installs.package:
            return self._generates() and _OF_INTERFACE.match(header) is not None and self._makes(header)
        if has_header(workspace, self._installs.package, header):
            return False
        if package in workspace.packages:
            in_same_folder = not (there - {self._installs.package}).isdisjoint(workspace.packages)
            of_types = _OF_INTERFACE.match(header) is not None and workspace.packages[package].is_interface_package
            return of_types or (not in_same_folder and has_header(workspace, package, header))
        if self._is_old:
            return False
        brings = packages.table().brings.get(package, ())
        of_types = _RUNTIME in brings and _OF_INTERFACE.match(header) is not None
        return of_types or package in _IN_FOLDERS_OF_THEIR_OWN

    def _makes(self, header: str) -> bool:
        """Whether the package has the file of an interface whose header is included."""
        _, kind, name = header.split("/", 2)
        wanted = posixpath.splitext(name)[0].replace("_", "")
        words = self._installs.generated or ()
        return any(posixpath.basename(word).lower() == f"{wanted}.{kind}" for word in words)


_OF_INTERFACE = re.compile(r"[a-z0-9_]+/(?:msg|srv|action)/[a-z0-9_]+\.hpp$")
_RUNTIME = "rosidl_default_runtime"
_GENERATED = frozenset({"rosidl_generator_cpp", "rosidl_cmake"})
"""Words with which a CMake file may lead to the headers of its own interfaces by itself."""
_OF_SYSTEM = frozenset({"yaml-cpp", "fmt", "glfw3", "spdlog", "tinyxml2", "nlohmann_json", "libserial", "ament_cmake"})
"""What ``find_package()`` finds under names in lower case, and that brings no package of ROS."""
_BRING_NO_MORE = frozenset({"px4_msgs"})
"""Packages from elsewhere that need no more than every package of interfaces."""
_IN_FOLDERS_OF_THEIR_OWN = frozenset(
    {"ament_index_cpp", "cv_bridge", "image_transport", "message_filters", "pluginlib", "rclcpp", "rclcpp_action"}
    | {"rclcpp_components", "rclcpp_lifecycle", "tf2", "tf2_geometry_msgs", "tf2_ros"}
)
"""Packages whose headers are in ``include/PACKAGE/PACKAGE`` in all distributions since Humble."""

__all__ = ["HeaderNotGiven", "headers_not_given"]
