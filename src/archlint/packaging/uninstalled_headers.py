"""Headers that the C++ code of other packages includes, and that their own package does not install."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_disused
from archlint.packaging.cpp_includes import has_header, headers_of, includes_of
from archlint.packaging.uninstalled_files import mended_at, understood
from archlint.place import Place
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.installed import Installs

_INSTALL_MORE = frozenset({"ament_auto_package", "catkin", "catkin_package", "FILE_SET", "PUBLIC_HEADER"})
"""Words of CMake files that install headers without their names, or are for ROS 1."""


_EXPORT = frozenset(
    {"ament_export_include_directories", "ament_export_interfaces", "ament_export_targets", "CONFIG_EXTRAS"}
    | {"CONFIG_EXTRAS_POST", "configure_package_config_file", "EXPORT", "ament_cmake_auto"}
)
"""Words with which a CMake file tells others of its folders, or may."""


@dataclass(frozen=True)
class HeaderLeftOut:
    """A header of a ``package``, by its path below the folder of that, with the place that includes it; ``place`` is
    where it should be installed."""

    package: str
    file: str
    included_at: Place
    place: Place
    installed: bool = False
    """Whether it is installed, and the folder that it comes to is not exported."""


def headers_left_out(workspace: WorkspaceIndex) -> Iterator[HeaderLeftOut]:
    """Each such header, once for each package that includes it."""
    for name, installs in understood(workspace).items():
        if ".." in installs.words:
            continue  # it may look into the folders of others
        seen = {name}
        for source in sorted(installs.sources):
            if is_disused(workspace, source) or not workspace.tree.is_file(source):
                continue
            for header, line in includes_of(workspace.tree.text(source) or ""):
                owner = header.partition("/")[0]
                if owner in seen or header in seen or owner not in workspace.packages:
                    continue
                seen.add(header)
                if has_header(workspace, name, header):
                    continue
                yield from _left_out(workspace, owner, header, Place(source, line, 1, line, 1))


def _left_out(workspace: WorkspaceIndex, owner: str, header: str, at: Place) -> Iterator[HeaderLeftOut]:
    installs, package = understood(workspace).get(owner), workspace.packages[owner]
    place = None if installs is None else mended_at(workspace, installs)
    if installs is None or place is None or package.build_type != "ament_cmake":
        return
    files = headers_of(workspace, owner, header)
    if not files or not _INSTALL_MORE.isdisjoint(installs.words) or any(map(installs.may_install, files)):
        return
    installed = any(_is_installed(installs, file) for file in files)
    if not installed or _EXPORT.isdisjoint(installs.words):
        yield HeaderLeftOut(owner, files[0], at, place, installed)


def _is_installed(installs: Installs, file: str) -> bool:
    path = posixpath.normpath(posixpath.join(installs.folder, file))
    return any(True for _ in installs.places_of(path))


__all__ = ["HeaderLeftOut", "headers_left_out"]
