"""Controllers that a launch file spawns, held against those whose type the controller manager beside it is given.

Source: ``controller_manager`` in ros2_control: a controller is loaded by its ``type``, a parameter of the manager that
``--controller-type`` or the file of ``--param-file`` may bring, too.
"""

from __future__ import annotations

import posixpath
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.launch.kinds import FileKind, GapKind, StartedKind
from archlint.launch.parameter_sources import ParameterFileUse, ParameterSetting
from archlint.launch_files.simulated_managers import simulated_manager, words_of_yaml
from archlint.place import Place
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.launch.started import Started
    from archlint.systems.model import System, WorkspaceIndex

_MANAGER = ("controller_manager", "ros2_control_node")
_SPAWNERS = frozenset({("controller_manager", "spawner"), ("controller_manager", "spawner.py")})
_WITH_VALUE = frozenset(
    {"-c", "--controller-manager", "-n", "--namespace", "--controller-manager-timeout", "--switch-timeout"}
    | {"--service-call-timeout", "--controller-ros-args"}
)
"""Options of the spawner that a word follows."""
_WITHOUT_VALUE = frozenset(
    {
        "--inactive",
        "--stopped",
        "--load-only",
        "--unload-on-kill",
        "--activate-as-group",
        "-u",
    }
)
_COMMAND = ("control", "load_controller")
_LAST = ".type"


@dataclass(frozen=True)
class UnknownController:
    """A controller of whose type the manager knows nothing; ``known`` are those of which it does."""

    place: Place
    name: str
    known: tuple[str, ...]
    manager: Place
    named_at: Place | None = None
    """Where the configuration of MoveIt names it, if a launch file spawns what that names."""
    simulated: bool = False
    """Whether the manager is in a simulator: then ``manager`` is where the description of a robot names its file."""


def unknown_controllers(system: System) -> Iterator[UnknownController]:
    """Every such controller of a system with one manager, of whose parameters all are known."""
    workspace = system.workspace
    started = system.launched.started if system.launched is not None else ()
    managers = [process for process in started if (process.package.text, process.executable.text) == _MANAGER]
    if workspace is not None and not managers:
        yield from _unknown_in_simulation(system, workspace)
    if workspace is None or len(managers) != 1 or managers[0].dormant:
        return
    [manager] = managers
    known = _controllers(workspace, manager)
    if known is None:
        return
    without_type = frozenset[str]() if known or manager.may_read_arguments_for_ros else _sections(workspace, manager)
    for process in started:
        if _is_spawner(process) and process.branch_arms >= manager.branch_arms:
            for name in _names(process):
                if name not in known and (known or name in without_type):
                    place = process.places.get("arguments", process.place)
                    named = _named_at(workspace, place, name)
                    yield UnknownController(place, name, tuple(sorted(known)), manager.place, named)


_SIMULATORS = frozenset({"gazebo_ros", "ros_gz_sim", "ros_ign_gazebo", "ros_gz_bridge", "ros_ign_bridge"})
"""Packages whose launch files start no controller manager by themselves."""


def _unknown_in_simulation(system: System, workspace: WorkspaceIndex) -> Iterator[UnknownController]:
    """Controllers of which no file of the workspace says anything, where a simulator has its manager from there."""
    launched, manager = system.launched, None
    if launched is not None and any(map(_is_spawner, launched.started)):
        manager = simulated_manager(workspace)
    if launched is None or manager is None:
        return
    included = [row for row in launched.references if row.kind is FileKind.LAUNCH]
    known_files = all(row.source is not None or row.package in _SIMULATORS for row in included)
    if not known_files or any(gap.kind is GapKind.INCLUDE for gap in launched.gaps):
        return
    for process in filter(_is_spawner, launched.started):
        for name in _names(process):
            if name not in manager.known and name not in words_of_yaml(workspace):
                place, known = process.places.get("arguments", process.place), tuple(sorted(manager.known))
                yield UnknownController(place, name, known, manager.place, simulated=True)


def _is_spawner(process: Started) -> bool:
    is_node = (process.package.text, process.executable.text) in _SPAWNERS
    return (is_node or _is_command(process)) and not process.dormant


def _is_command(process: Started) -> bool:
    """Whether a process is ``ros2 control load_controller``, which does what the spawner does."""
    is_ros2 = process.kind is StartedKind.PROCESS and process.executable.text == "ros2"
    return is_ros2 and process.arguments[: len(_COMMAND)] == [*_COMMAND]


_OF_MOVEIT = "config/moveit_controllers.yaml"
"""Where a package for MoveIt names the controllers that ``generate_spawn_controllers_launch()`` spawns."""


def _named_at(workspace: WorkspaceIndex, spawned: Place, name: str) -> Place | None:
    """Where the configuration of MoveIt has a controller that a launch file spawns and does not name itself."""
    if name in (workspace.tree.text(spawned.file) or ""):
        return None
    file = posixpath.normpath(posixpath.join(posixpath.dirname(spawned.file), "..", _OF_MOVEIT))
    for number, line in enumerate((workspace.tree.text(file) or "").splitlines(), 1):
        if line.strip().removeprefix("-").strip("'\" ") == name:
            return Place(file, number, 1, number, len(line) + 1)
    return None


def _sections(workspace: WorkspaceIndex, manager: Started) -> frozenset[str]:
    """The names of the nodes that the parameter files of a manager are for, if it is one of them itself: so its types
    would be there, too."""
    files = (given.reference.source for given in manager.parameters if isinstance(given, ParameterFileUse))
    read = [workspace.parameters_of(file) for file in files if file is not None]
    keys = frozenset(section.key.rpartition("/")[2] for facts in read for section in facts.sections)
    return keys if _MANAGER[0] in keys else frozenset()


def _controllers(workspace: WorkspaceIndex, manager: Started) -> set[str] | None:
    """The controllers that have a type; None where there may be others."""
    known: set[str] = set()
    for given in manager.parameters:
        match given:
            case ParameterSetting(name=str(name)):
                if name.endswith(_LAST):
                    known.add(name.removesuffix(_LAST))
            case ParameterFileUse(changes=()) if given.reference.source is not None:
                for section in workspace.parameters_of(given.reference.source).sections:
                    if "*" in section.key and section.key not in ("/**", "/**/controller_manager"):
                        return None
                    for entry in section.entries:
                        if entry.name == "type":
                            known.add(section.key.rpartition("/")[2])
                        elif entry.name.endswith(_LAST):
                            known.add(entry.name.removesuffix(_LAST))
            case _:
                return None
    return known


def _names(spawner: Started) -> list[str]:
    """The controllers that a spawner names; none where it may have their types, or their names, from elsewhere."""
    if not spawner.knows_all_arguments or spawner.ros_arguments or spawner.parameters:
        return []
    names: list[str] = []
    is_command = _is_command(spawner)
    words = iter(spawner.arguments[len(_COMMAND) :] if is_command else spawner.arguments)
    for word in words:
        if word is None or (is_command and names and not word.startswith("-")):
            return []  # the second word of the command is a file with the type
        if word in (_WITH_VALUE | {"--set-state"} if is_command else _WITH_VALUE):
            next(words, None)
        elif word.startswith("-") and word not in _WITHOUT_VALUE:
            return []  # the type, a file with it, or an option that is not known
        elif not word.startswith("-"):
            names.append(word)
    return names


__all__ = ["UnknownController", "unknown_controllers"]
