"""What kind of topic several nodes publish: a command that one at a time can be obeyed, a value, a bus for all."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.systems.nodes import key_of

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.systems.model import WorkspaceIndex
    from archlint.systems.nodes import Connection, Endpoint, Node

COMMANDS = frozenset(
    {
        "ackermann_msgs/msg/AckermannDrive",
        "ackermann_msgs/msg/AckermannDriveStamped",
        "control_msgs/msg/JointJog",
        "geometry_msgs/msg/Twist",
        "geometry_msgs/msg/TwistStamped",
        "mavros_msgs/msg/AttitudeTarget",
        "mavros_msgs/msg/GlobalPositionTarget",
        "mavros_msgs/msg/ManualControl",
        "mavros_msgs/msg/OverrideRCIn",
        "mavros_msgs/msg/PositionTarget",
        "px4_msgs/msg/TrajectorySetpoint",
        "trajectory_msgs/msg/JointTrajectory",
        "trajectory_msgs/msg/MultiDOFJointTrajectory",
    }
)
"""Of these, one at a time can be obeyed."""
_TO_COMMAND = frozenset({"cmd", "cmds", "command", "commands", "setpoint", "setpoints"})
_STATES = frozenset({"mode", "state"})
_TO_LOOK_AT = frozenset({"debug"})
_SWITCH = "std_msgs/msg/Bool"
_WORDS = frozenset({"std_msgs/msg/Empty", "std_msgs/msg/String"})
"""Messages that each stand for themselves, unless the topic's name says that they are a state."""
_WHO = (
    *("agent", "boat", "car", "device", "drone", "node", "resource", "robot", "sender", "source"),
    *("uav", "unit", "vehicle"),
)
SENDERS = ("id", "node", "sender", "source", *(f"{who}_{what}" for who in _WHO for what in ("id", "name")))
"""Fields that say whose a message is, or of what: such messages add up."""
_MANY = 4
_OVERRIDING = frozenset(
    {
        *("goal", "goals", "target", "targets", "waypoint", "waypoints"),
        *("speed", "speeds", "steering", "throttle", "torque", "vel", "velocity", "velocities"),
    }
)
"""Words for what a machine is to reach, and for what it drives with: the last one counts, as with a command."""
_TO_DEVICES = re.compile(r"(?:can|i2c|modbus|queue|serial|spi|tx|uart)\d*")
"""Words for what takes each message as it comes and sends it on to a device."""
_FRAMES = frozenset({"can_msgs/msg/Frame", "std_msgs/msg/ByteMultiArray", "std_msgs/msg/UInt8MultiArray"})
_OCTETS = frozenset({"byte", "char", "int8", "octet", "uint8"})


def _are_commands(connection: Connection, owners: Sequence[Endpoint]) -> bool:
    """Whether a machine is commanded, by the type of the messages or the last part of the topic's name."""
    if any(end.type in COMMANDS for end in owners):
        return True
    return not are_words(owners) and is_named_a_command(connection.name)


def is_named_a_command(topic: str) -> bool:
    """Whether a topic is called a command: ``cmd_vel``."""
    return not _TO_COMMAND.isdisjoint(_last_words(topic))


def are_words(owners: Sequence[Endpoint]) -> bool:
    """Whether all that is said is a text, or nothing but that it is said."""
    return all(end.type in _WORDS for end in owners)


def overrides(connection: Connection, owners: Sequence[Endpoint]) -> bool:
    """Whether a message takes back the one before, whoever sent that: a command, a goal, a switch or a state."""
    if _are_commands(connection, owners) or is_state(connection.name):
        return True
    return any(end.type == _SWITCH for end in owners) or not _OVERRIDING.isdisjoint(_last_words(connection.name))


def _are_frames(workspace: WorkspaceIndex | None, connection: Connection, owners: Sequence[Endpoint]) -> bool:
    """Whether each message is a frame for a device, by its type, which has nothing but octets, or by the name of the
    topic, and no command or state: what writes frames to a bus writes all of them."""
    if is_named_a_command(connection.name) or is_state(connection.name):
        return False
    if any(_TO_DEVICES.fullmatch(word) for word in _last_words(connection.name)):
        return True
    return all(end.type in _FRAMES or _is_of_octets(workspace, end.type) for end in owners)


def _is_of_octets(workspace: WorkspaceIndex | None, type_: str | None) -> bool:
    section = None
    if workspace is not None and workspace.interfaces is not None and type_ is not None:
        section = workspace.interfaces.section(type_, "")
    kinds = [] if section is None else [field.type for field in section.fields]
    return bool(kinds) and all(kind.array and kind.name in _OCTETS for kind in kinds)


def is_state(topic: str) -> bool:
    """Whether a topic's name says that it reports how something is, so that the last message is what counts."""
    return not _STATES.isdisjoint(_last_words(topic))


def is_bus(workspace: WorkspaceIndex | None, connection: Connection, owners: Sequence[Endpoint]) -> bool:
    """Whether so many nodes publish a topic, or different ones with the help of one class, or just those that listen to
    it, too, that it is evidently there for all of them; or its messages say whose they are, or it is there for people
    to look at.  Who listens to what he publishes knows of the others.  Of commands that is never so."""
    if any(end.type in COMMANDS for end in owners):
        return False
    listening = {id(user.node) for user in connection.users}
    if _are_frames(workspace, connection, owners):
        return True
    if all(id(end.node) in listening for end in owners) or not _TO_LOOK_AT.isdisjoint(connection.name.split("/")):
        return True
    if not _are_commands(connection, owners) and all(_says_whose(workspace, end.type) for end in owners):
        return True
    if sum(id(end.node) not in listening for end in owners) < 2 or _is_for_instances(connection, owners):
        return True
    classes = {end.node.blueprint.class_name for end in owners if end.node.blueprint is not None}
    helped = len({end.place for end in owners}) == 1 and len(classes) > 1
    return helped or _is_for_packages(owners) or len({end.node.name for end in owners}) >= _MANY


def _is_for_packages(owners: Sequence[Endpoint]) -> bool:
    """Whether one line creates the publishers of several packages: a helper that is there for whoever uses it, whoever
    else publishes the topic without it."""
    packages: dict[Place, set[str]] = {}
    for end in owners:
        if end.node.package is not None:
            packages.setdefault(end.place, set()).add(end.node.package)
    return any(len(names) > 1 for names in packages.values())


def _is_for_instances(connection: Connection, owners: Sequence[Endpoint]) -> bool:
    """Whether several nodes of one class publish a topic, and several of one class listen to it: each robot of a fleet
    tells all the others."""
    return all(
        are_of_one_class(ends) and len({end.node.name for end in ends}) > 1 for ends in (owners, connection.users)
    )


def are_of_one_class(ends: Sequence[Endpoint]) -> bool:
    """Whether these are ends of several instances of one node."""
    return len({_class_of(end.node) for end in ends}) == 1


def say_the_same(ends: Sequence[Endpoint]) -> bool:
    """Whether a launch file loads one component several times and gives none of them anything but a name: what they
    send is the same, as where a lesson shows that this can be done."""
    starts = [end.node.started for end in ends]
    alike = all(
        start is not None and start.container is not None and not (start.remaps or start.parameters or start.namespace)
        for start in starts
    )
    return alike and are_of_one_class(ends) and len({end.place for end in ends}) == 1


def _class_of(node: Node) -> object:
    return node if node.blueprint is None else key_of(node.blueprint)


def _says_whose(workspace: WorkspaceIndex | None, type_: str | None) -> bool:
    if workspace is None or workspace.interfaces is None or type_ is None:
        return False
    return any(workspace.interfaces.has(type_, "", field) for field in SENDERS)


def _last_words(topic: str) -> list[str]:
    return topic.rpartition("/")[2].lower().split("_")


__all__ = [
    "COMMANDS",
    "SENDERS",
    "are_of_one_class",
    "are_words",
    "is_bus",
    "is_named_a_command",
    "is_state",
    "overrides",
    "say_the_same",
]
