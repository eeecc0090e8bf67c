"""Which code of a workspace is not for rclpy as ROS 2 has it, so that it is passed over, and what is said of it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.engine.inputs import catkin_files, is_input, python_files
from archlint.engine.looked_at import for_own_rclpy, for_ros1
from archlint.engine.request import NothingToDo
from archlint.workspace.test_code import FileRoles

if TYPE_CHECKING:
    from archlint.launch.files import LaunchFiles
    from archlint.syntax.files import FactsOfFiles
    from archlint.workspace.model import SourceFile, Workspace

_RCLPY = "rclpy"


def skipped_files(workspace: Workspace) -> list[SourceFile]:
    """The files that are passed over whatever they import: those that catkin builds, and the Python files of a
    workspace that has an rclpy of its own."""
    files = catkin_files(workspace)
    return [*files, *python_files(workspace)] if own_rclpy(workspace) is not None else files


def own_rclpy(workspace: Workspace) -> SourceFile | None:
    """The ``rclpy/__init__.py`` that programs of a workspace get in place of the one of ROS 2: an implementation of its
    own, of which nothing is known.  None where there is none, or where a package depends on the one of ROS 2: it stands
    in for that then, as in a test.  The one of ROS 2 itself lies in a package of its name."""
    packages = workspace.packages
    if any(_RCLPY in (package.name, *(row.name for row in package.dependencies)) for package in packages):
        return None
    own = [file for file in workspace.of_kind("python") if file.relative.split("/")[-2:] == [_RCLPY, "__init__.py"]]
    roles = FileRoles.of(file.relative for file in workspace.files) if own else None
    return next((file for file in own if roles is not None and not _stands_in(roles, file)), None)


def _stands_in(roles: FileRoles, file: SourceFile) -> bool:
    """Whether tests or type checkers alone get it."""
    return roles.is_trial(file.relative) or "typings" in file.relative.split("/")


def passed_over(
    workspace: Workspace, asked: tuple[str, ...], facts: FactsOfFiles, launch_files: LaunchFiles
) -> Iterator[str]:
    """What is reported of such files; raises :class:`NothingToDo` where there are no others."""
    python = [file.relative for file in python_files(workspace) if not file.context and facts.is_ros1(file)]
    launch, own = launch_files.of_ros1(), own_rclpy(workspace)
    given = {file.relative for file in workspace.files if is_input(file)}
    if given and given <= {*python, *launch}:
        of_what = "ROS 1" if own is None else f"the rclpy of {own.relative}"
        raise NothingToDo(
            f"nothing to check in {', '.join(asked)}: all of it is for {of_what}, such as {min((*python, *launch))}, "
            "and archlint reads ROS 2"
        )
    yield from for_ros1([] if own is not None else python, launch)
    if own is not None:
        yield from for_own_rclpy(python, own.relative)


__all__ = ["own_rclpy", "passed_over", "skipped_files"]
