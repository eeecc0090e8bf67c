"""What parameter files give to controllers of ros2_control and the robot does not have, or the controller itself."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_aside
from archlint.analysis.kept import once
from archlint.launch_files.plugin_parameters import controllers_of
from archlint.launch_files.unloaded_parameter_files import is_superseded, parameter_files
from archlint.place import Place
from archlint.records import dataclass
from archlint.suggestions import nearest
from archlint.syntax.robot_descriptions import Component, Named, RobotDescription, read_description

if TYPE_CHECKING:
    from archlint.syntax.parameter_files import ParameterEntry, ParameterSection
    from archlint.systems.model import WorkspaceIndex

_ENDINGS = (".urdf", ".xacro", ".sdf", ".world")
_JOINTS = frozenset(
    {
        *("joints", "joint", "command_joints", "dof_names", "gpios", "left_wheel_names", "right_wheel_names"),
        *("front_wheels_names", "rear_wheels_names", "traction_joint_name", "steering_joint_name", "wheel_names"),
        *("traction_joints_names", "steering_joints_names"),
    }
)
"""The parameters of the controllers of ros2_controllers that name joints, or other components."""
_FOR_EACH = ("gains", "constraints")
"""The maps that have a key for each joint, beside those for all."""
_FOR_ALL = frozenset({"goal_time", "stopped_velocity_tolerance"})
_INTERFACES = ("command_interfaces", "state_interfaces")


@dataclass(frozen=True)
class UnknownJoint:
    """A joint of a controller that no description has, and the one that was meant."""

    place: Place
    controller: str
    parameter: str
    name: str
    meant: str


@dataclass(frozen=True)
class UnknownInterface:
    """An interface that a controller wants of joints, and those that the hardware has at the first of them."""

    place: Place
    controller: str
    joints: tuple[str, ...]
    name: str
    known: tuple[str, ...]
    """Sorted; at least one."""
    wanted: tuple[str, ...]
    """All that the same list names: a controller refuses a list that names one twice."""
    commands: bool
    is_needed: bool
    """Whether the controller refuses to do without: a trajectory of velocities or efforts alone needs both states."""


@dataclass(frozen=True)
class ForNoJoint:
    """A value for a joint that is none of the controller's."""

    place: Place
    controller: str
    parameter: str
    name: str
    joints: tuple[str, ...]


Mistake = UnknownJoint | UnknownInterface | ForNoJoint


def wrong_for_controllers(workspace: WorkspaceIndex) -> Iterator[Mistake]:
    """Everything of that kind, file by file."""
    for file, facts in parameter_files(workspace):
        types = controllers_of(facts)
        if _is_superseded(workspace, file, types):
            continue
        for section in facts.sections:
            controller = section.path[-1].rpartition("/")[2] if section.path else ""
            if controller in types:
                joints = _joints_of(section)
                yield from _unknown_joints(workspace, file, controller, section)
                yield from _for_no_joint(file, controller, section, joints)
                if not _is_of_other_robot(workspace, file, joints):
                    yield from _unknown_interfaces(workspace, file, controller, section, joints)


def _is_superseded(workspace: WorkspaceIndex, file: str, types: Collection[str]) -> bool:
    """Whether nothing names a file, and something names another of its package that has all of its controllers: it is
    what they were before."""
    rows = parameter_files(workspace)
    others = [other for other, facts in rows if types and controllers_of(facts).keys() >= set(types)]
    return is_superseded(workspace, file, others)


def _texts(value: object) -> list[str]:
    rows = value if isinstance(value, list) else [value]
    return [row for row in rows if isinstance(row, str) and row and not re.search(r"[$<{/]", row)]


def _joints_of(section: ParameterSection) -> tuple[str, ...]:
    return tuple(name for entry in section.entries if entry.name in _JOINTS for name in _texts(entry.value))


# ------------------------------------------------------------------------------------------------- joints


def _unknown_joints(
    workspace: WorkspaceIndex, file: str, controller: str, section: ParameterSection
) -> Iterator[UnknownJoint]:
    literals, from_xacro = _literals(workspace), _made_names(workspace)
    for entry in section.entries:
        if entry.name not in _JOINTS:
            continue
        for name in _texts(entry.value):
            if name not in literals and not any(row.may_be(name) for row in from_xacro):
                meant = _meant(name, literals)
                if meant is not None:
                    yield UnknownJoint(Place(file, *entry.span), controller, entry.name, name, meant)


_NUMBER = re.compile(r"\d+")
_ENDING = re.compile(r"_(?:joint|link|wheel|motor)$")


def _meant(name: str, known: Sequence[str]) -> str | None:
    """The joint that is almost called so: one with the same numbers, for two of them are two joints."""
    alike = [other for other in known if _NUMBER.findall(other) == _NUMBER.findall(name)]
    same = [other for other in alike if _ENDING.sub("", other) == _ENDING.sub("", name)]
    return same[0] if len(same) == 1 else nearest(name, alike)


@once
def _descriptions_by_file(workspace: WorkspaceIndex) -> dict[str, RobotDescription]:
    tree = workspace.tree
    files = [file for folder in sorted(workspace.manifests) for file in tree.files_below(folder)]
    wanted = [file for file in dict.fromkeys(files) if file.endswith(_ENDINGS) and not is_aside(workspace, file)]
    return {file: read_description(tree.text(file) or "") for file in wanted}


def _descriptions(workspace: WorkspaceIndex) -> Collection[RobotDescription]:
    return _descriptions_by_file(workspace).values()


@once
def _literals(workspace: WorkspaceIndex) -> list[str]:
    rows = (row for description in _descriptions(workspace) for row in description.names if row.is_literal)
    return sorted({row.name for row in rows})


@once
def _made_names(workspace: WorkspaceIndex) -> list[Named]:
    """The names that xacro makes, each once."""
    rows = (row for description in _descriptions(workspace) for row in description.names if not row.is_literal)
    return list(dict.fromkeys(rows))


# ------------------------------------------------------------------------------------------------- values for joints


def _for_no_joint(
    file: str, controller: str, section: ParameterSection, joints: tuple[str, ...]
) -> Iterator[ForNoJoint]:
    """The first such value for each name."""
    seen: set[tuple[str, str]] = set()
    for entry in section.entries:
        if len(entry.path) < 3 or entry.path[0] not in _FOR_EACH:
            continue
        kind, name = entry.path[0], ".".join(entry.path[1:-1])
        if not joints or name in joints or name in _FOR_ALL or re.search(r"[$<{/]", name) or (kind, name) in seen:
            continue
        if len(entry.path) > 3 and any(joint.startswith(f"{entry.path[1]}.") for joint in joints):
            continue
        seen.add((kind, name))
        yield ForNoJoint(Place(file, *entry.span), controller, kind, name, joints)


# ------------------------------------------------------------------------------------------------- interfaces


def _unknown_interfaces(
    workspace: WorkspaceIndex, file: str, controller: str, section: ParameterSection, joints: tuple[str, ...]
) -> Iterator[UnknownInterface]:
    commanded = {name for entry in section.entries if entry.path == ("command_interfaces",) for name in _wanted(entry)}
    needs_both = bool(commanded & {"velocity", "effort"}) and "position" not in commanded
    for entry in section.entries:
        kind = entry.path[0]
        if kind not in _INTERFACES:
            continue
        commands = kind == "command_interfaces"
        of = joints if len(entry.path) == 1 else tuple(name for name in joints if name == entry.path[1])
        known = {joint: there for joint in of if (there := _interfaces(workspace, joint, commands))}
        wanted = _wanted(entry)
        for name in dict.fromkeys(wanted):
            lacking = tuple(joint for joint, there in known.items() if name not in there)
            if lacking:
                there = known[lacking[0]]
                place = Place(file, *entry.span)
                is_needed = needs_both and not commands
                yield UnknownInterface(place, controller, lacking, name, there, tuple(wanted), commands, is_needed)


def _is_of_other_robot(workspace: WorkspaceIndex, file: str, joints: Sequence[str]) -> bool:
    """Whether the package of a file has hardware of its own, and none of it for any of these joints: nobody knows which
    robot the file goes with."""
    package = workspace.package_of(file)
    of_package = [
        row
        for path, description in _descriptions_by_file(workspace).items()
        if package is not None and workspace.package_of(path) == package
        for row in description.components
    ]
    return bool(of_package) and not any(row.name.may_be(joint) for row in of_package for joint in joints)


def _wanted(entry: ParameterEntry) -> list[str]:
    """The names of interfaces: in a list, or in a list of maps, as the documentation of gpio_controllers has them."""
    rows = entry.value if isinstance(entry.value, list) else [entry.value]
    nested = [row["interfaces"] for row in rows if isinstance(row, dict) and isinstance(row.get("interfaces"), list)]
    return _texts(entry.value) + [name for row in nested for name in _texts(row)]


def _interfaces(workspace: WorkspaceIndex, joint: str, commands: bool) -> tuple[str, ...]:
    """The interfaces that the hardware of all descriptions has for a component; empty where they are not all known."""
    matching = [row for row in _components(workspace) if row.name.may_be(joint)]
    if not any(row.name.is_literal for row in matching):
        return ()
    names: list[Named] = [name for row in matching for name in (row.commands if commands else row.states)]
    return tuple(sorted({name.name for name in names})) if all(name.is_literal for name in names) else ()


@once
def _components(workspace: WorkspaceIndex) -> list[Component]:
    return [row for description in _descriptions(workspace) for row in description.components]


__all__ = ["ForNoJoint", "Mistake", "UnknownInterface", "UnknownJoint", "wrong_for_controllers"]
