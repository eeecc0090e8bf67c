"""PRM012: joints and interfaces of controllers that the robot does not have, or that they are not given, and values for
joints of others."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.checks.folding import folds, with_other_places, with_others
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.counted import counted
from archlint.finding import Finding, Severity
from archlint.launch_files.controlled_joints import (
    ForNoJoint,
    UnknownInterface,
    UnknownJoint,
    wrong_for_controllers,
)
from archlint.launch_files.hardware_joints import JointOfNoRobot, joints_of_no_robot
from archlint.launch_files.incomplete_controllers import (
    IncompleteController,
    incomplete_controllers,
    passed_over_by_moveit,
)
from archlint.launch_files.unloaded_parameter_files import has_no_reader
from archlint.suggestions import listed, meant, nearest

if TYPE_CHECKING:
    from archlint.launch_files.controlled_joints import Mistake
    from archlint.systems.model import System


@rule("PRM012", scope=Scope.WORKSPACE)
def joint_of_no_robot(system: System, options: Options) -> Iterator[Finding]:
    """What parameter files give to controllers in vain."""
    workspace = system.workspace
    if workspace is None:
        return
    lacking = (*incomplete_controllers(workspace), *passed_over_by_moveit(workspace))
    for told in (*map(_told, wrong_for_controllers(workspace)), *map(_incomplete, lacking)):
        yield replace(told, severity=Severity.INFO) if has_no_reader(workspace, told.place.file) else told
    yield from map(_of_hardware, joints_of_no_robot(workspace))


def _of_hardware(row: JointOfNoRobot) -> Finding:
    """What stands below ``<ros2_control>``; the same file may be of several robots."""
    robot = posixpath.basename(row.robot)
    near = row.meant and f"'{row.meant}'"
    return finding(
        "PRM012",
        row.place,
        f"<ros2_control> has a joint '{row.name}', and the robot in '{robot}' has none{meant(near)}: since Jazzy the "
        "controller manager refuses such a description; before, no link moves with it",
        help=f"write {near}" if near else "give it the name of a joint of the robot, or remove it",
        identity=(_HARDWARE, row.name),
        group=(row.place.file, _HARDWARE, robot, row.name),
    )


_HARDWARE = "ros2_control"


def _incomplete(row: IncompleteController) -> Finding:
    """What a controller lacks is in the group of its file and its own, apart from what it is given in vain."""
    kind = row.kind.rpartition("/")[2]
    effect = f"without which {kind} cannot be configured" if kind else "without which MoveIt passes over it"
    return finding(
        "PRM012",
        row.place,
        f"'{row.controller}' is given no {' and no '.join(row.lacking)}, {effect}",
        help=f"add {' and '.join(row.lacking)} {'below its ros__parameters' if kind else 'to its entry'}",
        identity=(row.controller, *row.lacking),
        group=(row.place.file, row.controller, "incomplete", ""),
    )


def _told(row: Mistake) -> Finding:
    kind = ""
    match row:
        case UnknownJoint(place=place, controller=controller, parameter=parameter, name=name, meant=near):
            message = f"no robot description here has '{name}', which '{controller}' is given as one of its {parameter}"
            message, help = f"{message}{meant(repr(near))}", f"write '{near}'"
            kind = parameter
        case UnknownInterface(place=place, controller=controller, name=name):
            kind = "command" if row.commands else "state"
            message, help = _interface(row, kind), _instead(row, kind)
        case ForNoJoint(place=place, controller=controller, parameter=parameter, name=name, joints=joints):
            near = nearest(name, joints) or ""
            message = f"'{controller}' has {parameter} for '{name}', which is none of its joints"
            message += meant(near and f"'{near}'")
            help = f"write '{near}'" if near else f"remove them, or name the joint; it has {listed(list(joints))}"
    group = (place.file, controller, kind or name, name)
    return finding("PRM012", place, message, help=help, identity=(controller, name), group=group)


def _interface(row: UnknownInterface, kind: str) -> str:
    more, known = len(row.joints) - 1, listed([f"'{other}'" for other in row.known])
    of_more = f" (and that of {counted(more, 'more joint')})" if more else ""
    wants = f"'{row.controller}' wants the {kind} interface '{row.joints[0]}/{row.name}'{of_more}"
    return f"{wants}, and the hardware there has {known}"


def _instead(row: UnknownInterface, kind: str) -> str:
    """What to write: none that the list has already, for a controller takes no name twice."""
    free = [name for name in row.known if name not in row.wanted]
    near = nearest(row.name, free) or (free[0] if len(row.known) == 1 and free else "")
    if near:
        return f"write '{near}'"
    there = f"add it to the joint{'s' if len(row.joints) > 1 else ''} in the description, if the hardware has it"
    if free:
        return f"write one that the description has, or {there}"
    return there if row.is_needed else f"remove '{row.name}' from {kind}_interfaces, or {there}"


@folds("PRM012", common=3)
def _of_one_cause(several: Sequence[Finding]) -> Finding:
    """One finding for a name that is wrong in one controller, wherever it stands there, and for the joints of one list
    that no robot has."""
    name = several[0].group[-1]
    first = with_other_places([told for told in several if told.group[-1] == name], "the same name is wrong here, too")
    others = list({told.group[-1]: told for told in reversed(several) if told.group[-1] != name}.values())
    in_order = sorted(others, key=lambda told: told.place)
    words = ("another name of the list is", "more names of the list are", "unknown, too")
    return with_others([first, *in_order], *words) if others else first


__all__ = ["joint_of_no_robot"]
