"""Options of a setup.cfg that are written with a dash, in the sections in which ROS packages have some.

Source: ``Distribution._enforce_underscore`` of setuptools, which warns of them since 54.1 and announces their end;
78.0.0 and 78.0.1 refused them, and all until 84.2.1 take them again.
"""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_aside
from archlint.analysis.kept import once
from archlint.analysis.pinned import names_no_distro
from archlint.finding import Place
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_SECTION = re.compile(r"\[(\w[\w.:-]*)\]")
_OPTION = re.compile(r"([a-z]+(?:-[a-z]+)+)\s*[=:]")
_JUDGED = frozenset(
    {
        *("metadata", "options", "options.packages.find"),
        *("develop", "install", "install_data", "install_lib", "install_scripts"),
        *("build", "build_ext", "build_py", "build_scripts", "egg_info", "sdist", "bdist_wheel"),
    }
)
"""The sections that setuptools reads itself and that have names of options: its own tables and its commands.  The names
in ``options.extras_require`` and the like are those of packages and extras."""


@dataclass(frozen=True)
class DashedOption:
    """One option of a file, as it is written."""

    name: str
    place: Place


def dashed_options(workspace: WorkspaceIndex) -> Iterator[DashedOption]:
    """Those of the packages that setuptools builds."""
    for folder in sorted(workspace.manifests):
        package = workspace.manifests[folder]
        path = posixpath.normpath(posixpath.join(folder, "setup.cfg"))
        text = workspace.tree.text(path) if workspace.tree.is_file(path) else None
        if text is None or package.ros1 or is_aside(workspace, package.manifest.relative):
            continue
        if package.build_type == "ament_cmake" and not _reads_table(workspace, package.name):
            continue
        if names_no_distro(workspace) and not _has_later(workspace) and _has(workspace, folder, _ALL_OF_OLD_TEMPLATE):
            continue
        if _pins_old_setuptools(workspace, folder):
            continue
        section = ""
        for number, line in enumerate(text.splitlines(), 1):
            head, option = _SECTION.match(line), _OPTION.match(line)
            section = head[1] if head is not None else section
            if option is not None and section in _JUDGED:
                yield DashedOption(option[1], Place(path, number, 1, number, len(option[1]) + 1))


_PIN = re.compile(r"\bsetuptools\s*(?:==|~=|<=?)\s*(\d+)")
_WARNS_SINCE = 54


def _pins_old_setuptools(workspace: WorkspaceIndex, folder: str) -> bool:
    """Whether a package asks for a setuptools that does not warn yet."""
    paths = (posixpath.normpath(posixpath.join(folder, name)) for name in ("setup.cfg", "setup.py", "requirements.txt"))
    return any(
        int(pin) < _WARNS_SINCE for path in paths for pin in _PIN.findall(workspace.tree.text(path) or "") if pin
    )


_ALL_OF_OLD_TEMPLATE = re.compile(r"\bpackages=\[package_name\],")
_ALL_OF_LATER_TEMPLATE = re.compile(r"\bpackages=find_packages\(exclude=\['test'\]\),")
"""What ``ros2 pkg create`` writes: of Foxy, which lists the one package by name, and since Humble.  Where nothing names
a distribution and all packages are of the first kind, the workspace may be for Foxy, whose setuptools says nothing.

Source: ros2pkg/resource/ament_python/setup.py.em.
"""


@once
def _has_later(workspace: WorkspaceIndex) -> bool:
    """Whether a package of a workspace was made with Humble or later: then all of them are built there."""
    return any(_has(workspace, folder, _ALL_OF_LATER_TEMPLATE) for folder in workspace.manifests)


def _has(workspace: WorkspaceIndex, folder: str, template: re.Pattern[str]) -> bool:
    text = workspace.tree.text(posixpath.normpath(posixpath.join(folder, "setup.py")))
    return text is not None and template.search(text) is not None


def _reads_table(workspace: WorkspaceIndex, package: str) -> bool:
    """Whether the CMake files of a package may hand its setup.cfg to setuptools.

    Source: ``_ament_cmake_python_install_package`` copies one that is named there, or the one beside the Python
    package, where it installs scripts.
    """
    installs = workspace.installs.get(package)
    return installs is not None and not installs.words.isdisjoint({"SETUP_CFG", "SCRIPTS_DESTINATION"})


__all__ = ["DashedOption", "dashed_options"]
