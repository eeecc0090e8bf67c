"""Launch files that are installed where ``ros2 launch`` does not look: outside of the share folder of their package.

Source: ``get_share_file_path_from_package`` of ros2launch.
"""

from __future__ import annotations

import posixpath
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.packaging.absent_packages import is_nowhere
from archlint.packaging.uninstalled_files import (
    LaunchFilesLeftOut,
    mended_at,
    own_launch_files,
    paths_below,
    understood,
)

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.installed import Installs

_LAUNCH = "launch"


def launch_files_astray(workspace: WorkspaceIndex) -> Iterator[LaunchFilesLeftOut]:
    """The launch files in the folder ``launch`` of a package that installs them all, and all in a folder that is not
    below its share folder, nor below that of another package."""
    for installs in understood(workspace).values():
        place = mended_at(workspace, installs)
        own = own_launch_files(workspace, installs)
        targets = {file: [*installs.places_of(file)] for file in own}
        every = [target for row in targets.values() for target in row]
        if place is None or not every or not all(targets.values()):
            continue
        if not any(_is_in_a_share_folder(workspace, installs, target) for target in every):
            folder = posixpath.dirname(every[0])
            yield LaunchFilesLeftOut(installs.package, place, tuple(paths_below(installs, own)), instead=folder)


def _is_in_a_share_folder(workspace: WorkspaceIndex, installs: Installs, target: str) -> bool:
    """Whether a path below the prefix may be in the share folder of a package: this one, or another that is known."""
    top, _, below = target.partition("/")
    if top != "share":
        return target.startswith("..") or posixpath.isabs(target) or "$" in target
    name = below.partition("/")[0]
    if name == _LAUNCH and name not in workspace.packages:
        return False  # the package of that name is no place for launch files of others
    return name == installs.package or "$" in name or installs.is_indexed_as(name) or not is_nowhere(workspace, name)


__all__ = ["launch_files_astray"]
