"""Imports from packages that are nowhere, where another name was meant: that of the package of the workspace that has
these interfaces, of the module of ROS that has these names, or a known module's of which one letter differs."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator, Sequence
from functools import cache
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.libraries.module_names import is_module, modules_with
from archlint.packaging.absent_packages import is_wanted_from_elsewhere
from archlint.packaging.optional_packages import LOOK_UPS
from archlint.packaging.renamed_packages import is_unknown, modules_imported
from archlint.ros import packages, python_modules
from archlint.suggestions import distance
from archlint.syntax.interfaces import INTERFACE_KINDS

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.model import SourceFile

_LONG = 8
"""From how many letters on a name that differs in one of them from a known one is no name of its own."""
_SHORTEST = 5
"""The same for two letters that have changed places."""


def interfaces_of(workspace: WorkspaceIndex, file: SourceFile, module: str, names: Sequence[str]) -> str | None:
    """The module of the one package of the workspace that defines all interfaces which a file imports from a package
    that is nowhere, and all that others import from it."""
    package, _, kind = module.partition(".")
    if workspace.interfaces is None or kind not in INTERFACE_KINDS or not names:
        return None
    if not is_unknown(workspace, file, module) or is_wanted_from_elsewhere(workspace, package):
        return None
    imported = modules_imported(workspace).get(package, set())
    if any(other.partition(".")[2] != kind for other in imported):
        return None
    owners = [workspace.interfaces.packages_with(kind, name) for name in names]
    having = set(owners[0]).intersection(*owners[1:])
    return f"{next(iter(having))}.{kind}" if len(having) == 1 else None


def kind_left_out(workspace: WorkspaceIndex, file: SourceFile, package: str, name: str) -> str | None:
    """The module of interfaces that has a name which a file imports from their package itself: what is generated there
    is empty.  None where the package may have Python code of that name besides."""
    if workspace.interfaces is None or package in workspace.code.modules:
        return None
    if workspace.code.path_of_import(file.relative, package) is not None:
        return None
    installs = workspace.installs.get(package)
    if installs is not None and not _INSTALL_PYTHON.isdisjoint(installs.words):
        return None
    kinds = [kind for kind in INTERFACE_KINDS if workspace.interfaces.defines(package, kind, name)]
    return f"{package}.{kinds[0]}" if len(kinds) == 1 else None


_INSTALL_PYTHON = frozenset({"PYTHON_INSTALL_DIR", "ament_python_install_module", "ament_python_install_package"})


def near_module(workspace: WorkspaceIndex, file: SourceFile, module: str) -> str | None:
    """The module that was meant by one whose top-level name is nowhere and a known one but for a slip."""
    top, dot, rest = module.partition(".")
    if len(top) < _SHORTEST or not is_unknown(workspace, file, module):
        return None
    near = {*_one_letter_off(top), *(own for own in _of_workspace(workspace) if distance(top, own, 1) == 1)}
    slips = [other for other in sorted(near) if _is_slip(top, other)]
    return f"{slips[0]}{dot}{rest}" if len(slips) == 1 and _is_at_hand(workspace, slips[0]) else None


def _is_at_hand(workspace: WorkspaceIndex, top: str) -> bool:
    """Whether anything says that a workspace has a module, or wants it: it comes with Python or ROS, is one of its own,
    or a package.xml or another import names it.  Any other is of somebody else, whose name is near by chance."""
    if top in sys.stdlib_module_names | {"rclpy"} or top in _of_workspace(workspace):
        return True
    if top in modules_imported(workspace):
        return True
    names = {top, python_modules.key_of(top)} - {None}
    packages_here = workspace.packages.values()
    return any(dependency.name in names for package in packages_here for dependency in package.dependencies)


_NO_MODULES = frozenset({"ament_cmake", "ament_index", "ament_index_cpp", "ament_python"})
"""Packages and types of builds that no module of Python has the name of."""
_OF_LAUNCH = ("launch", "launch_ros")
_OF_INDEX = frozenset({"PackageNotFoundError", *LOOK_UPS})


def module_of_ros(workspace: WorkspaceIndex, file: SourceFile, module: str, names: Sequence[str]) -> str | None:
    """The module of ament's index, or for a launch file of launch, that has all names which are imported from a
    package that is nowhere."""
    top = module.partition(".")[0]
    if not names or not (top in _NO_MODULES or is_unknown(workspace, file, module)):
        return None
    if workspace.code.path_of_import(file.relative, module) is not None or top in workspace.code.modules:
        return None
    if _OF_INDEX.issuperset(names):
        return "ament_index_python.packages"
    if file.kind != "launch_python":
        return None  # a Node of a module that is nowhere is none of launch_ros
    if any(is_module(f"{package}.{name}") for package in _OF_LAUNCH for name in names):
        return None  # a word such as ``actions``, which others have for theirs, too
    having = [modules_with(name, "launch") for name in names]
    common = [path for path in having[0] if all(path in others for others in having)]
    return next((path for path in common if path.partition(".")[0] in _OF_LAUNCH), None)


def _is_slip(name: str, other: str) -> bool:
    """Whether a name is another one by mistake: letters have changed places, or it is long and has one wrong inside.
    Names of families begin or end otherwise, or have other digits: ``gpytorch``, ``turtlebot3_msgs``."""
    if name.replace("_", "") == other.replace("_", ""):
        return False
    if sorted(name) == sorted(other):
        return True
    has_same_ends = (name[0], name[-1]) == (other[0], other[-1])
    return len(name) >= _LONG and has_same_ends and _DIGIT.findall(name) == _DIGIT.findall(other)


_DIGIT = re.compile(r"\d")


@once
def _of_workspace(workspace: WorkspaceIndex) -> frozenset[str]:
    return frozenset(module for module in workspace.code.modules if "." not in module)


def _one_letter_off(name: str) -> Iterator[str]:
    """The known modules of which a letter is wrong, missing or too much in a name, or has changed places with the
    next."""
    half = (len(name) - _CHANGED) // 2
    start, end = name[:half], name[-half:]
    for length in (len(name) - 1, len(name), len(name) + 1):
        for other in _by_length().get(length, ()):
            if (other.startswith(start) or other.endswith(end)) and distance(name, other, 1) == 1:
                yield other


_CHANGED = 2
"""How many letters are not as they were, at most, and next to each other: half of the others are before or behind."""


@cache
def _by_length() -> dict[int, list[str]]:
    """The known modules by how many letters they have."""
    by_length: dict[int, list[str]] = {}
    for module in sys.stdlib_module_names | python_modules.names() | packages.table().names:
        if len(module) >= _SHORTEST:
            by_length.setdefault(len(module), []).append(module)
    return by_length


__all__ = ["interfaces_of", "kind_left_out", "module_of_ros", "near_module"]
