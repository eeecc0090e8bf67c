"""Launch files that came along with a copy, and start programs of a project that is not here."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.ros.packages import table

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex


def is_of_another_project(workspace: WorkspaceIndex, package: str, file: str) -> bool:
    """Whether all that a launch file starts is of packages that are not here, that ROS does not have, and that its own
    package does not ask for, which has programs of its own and is not named there: it came along with what the package
    was copied from."""
    launches = [launched for launched in workspace.launched if launched.file == file]
    names = [started.package.text for launched in launches for started in launched.started]
    manifest, installs = workspace.packages.get(package), workspace.installs[package]
    if not names or manifest is None or not installs.executables or any(launched.included for launched in launches):
        return False
    if package in (workspace.tree.text(file) or ""):
        return False
    known = {*workspace.packages, *table().names, *(dependency.name for dependency in manifest.dependencies)}
    return all(name is not None and name not in known for name in names)


__all__ = ["is_of_another_project"]
