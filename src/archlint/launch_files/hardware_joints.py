"""Joints below ``<ros2_control>`` that the robot of the description does not have.

Source: ``parse_control_resources_from_urdf`` of hardware_interface since Jazzy: "Joint 'x' not found in URDF", at which
the controller manager ends.
"""

from __future__ import annotations

import posixpath
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_aside
from archlint.launch_files.robot_trees import expansion_of, place_of, robot_of
from archlint.place import Place
from archlint.records import dataclass
from archlint.suggestions import nearest
from archlint.syntax.xacro_expressions import may_be_same, shown

if TYPE_CHECKING:
    from archlint.syntax.xacro_expansion import Made
    from archlint.systems.model import WorkspaceIndex

_ENDINGS = (".urdf", ".xacro")
_SYSTEM = "ros2_control"
_OF_JOINTS = frozenset({"position", "velocity", "effort"})
"""The interfaces of what moves: a driver may call values of another kind a joint, too."""


@dataclass(frozen=True)
class JointOfNoRobot:
    """The ``name`` of a joint that the ``robot`` in a description has not, and the one that was meant."""

    place: Place
    name: str
    robot: str
    meant: str


def joints_of_no_robot(workspace: WorkspaceIndex) -> Iterator[JointOfNoRobot]:
    """Every such joint of a description that a launch file names and no other includes, where all joints of the robot
    are known."""
    expansions = {file: expansion for file in _files(workspace) if (expansion := expansion_of(workspace, file))}
    included = {inner for file, expansion in expansions.items() for inner in expansion.files if inner != file}
    for file, expansion in expansions.items():
        robot = robot_of(expansion)
        if file in included or robot.open or not robot.joints or not _is_launched(workspace, file):
            continue
        known = [joint.name for joint in robot.joints]
        for element in (row for system in expansion.children if system.tag == _SYSTEM for row in system.children):
            name = element.attributes.get("name") if element.tag == "joint" else None
            if name is None or not _moves(element) or any(may_be_same(name, other) for other in known):
                continue
            near = nearest(shown(name), [shown(other) for other in known]) or ""
            yield JointOfNoRobot(place_of(element), shown(name), file, near)


def _is_launched(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether a launch file has the name of a description: another one may be left over from an earlier robot."""
    name = posixpath.basename(file)
    return any(workspace.code.mentions(path, name) for path in workspace.launch_files.all())


def _files(workspace: WorkspaceIndex) -> list[str]:
    """The descriptions of a workspace; none where no file of them is about hardware."""
    tree = workspace.tree
    files = {file for folder in sorted(workspace.manifests) for file in tree.files_below(folder)}
    wanted = sorted(file for file in files if file.endswith(_ENDINGS) and not is_aside(workspace, file))
    return wanted if any(f"<{_SYSTEM}" in (tree.text(file) or "") for file in wanted) else []


def _moves(joint: Made) -> bool:
    return any(row.attributes.get("name") in _OF_JOINTS for row in joint.children if row.tag.endswith("_interface"))


__all__ = ["JointOfNoRobot", "joints_of_no_robot"]
