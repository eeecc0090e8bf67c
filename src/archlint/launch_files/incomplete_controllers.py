"""Controllers that a parameter file gives some parameters, and not those without which they cannot be configured.

Source: ``on_configure`` and the parameter files of ros2_controllers, branches humble, jazzy and master: each of these
is empty by default, and refused if it is.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_aside
from archlint.analysis.kept import once
from archlint.launch_files.plugin_parameters import controllers_of
from archlint.launch_files.unloaded_parameter_files import is_template, parameter_files
from archlint.place import Place
from archlint.records import dataclass
from archlint.syntax.moveit_controllers import MANAGER, passed_over

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_GROUPS = {"position": "Position", "velocity": "Velocity", "effort": "Effort"}
_NEEDED = {
    "joint_trajectory_controller/JointTrajectoryController": ("command_interfaces", "state_interfaces"),
    "diff_drive_controller/DiffDriveController": ("left_wheel_names", "right_wheel_names"),
    "forward_command_controller/ForwardCommandController": ("joints", "interface_name"),
    **{f"{kind}_controllers/JointGroup{name}Controller": ("joints",) for kind, name in _GROUPS.items()},
    **{f"{kind}_controllers/GripperActionController": ("joint",) for kind in ("position", "effort")},
}


@dataclass(frozen=True)
class IncompleteController:
    """A controller of a class, the names of what it lacks, and where its parameters stand.  ``kind`` is empty for one
    that MoveIt is to know."""

    place: Place
    controller: str
    kind: str
    lacking: tuple[str, ...]


def incomplete_controllers(workspace: WorkspaceIndex) -> Iterator[IncompleteController]:
    """All such controllers, file by file."""
    for file, facts in parameter_files(workspace):
        types = controllers_of(facts)
        for section in facts.sections:
            controller = section.path[-1].rpartition("/")[2] if section.path else ""
            needed = _NEEDED.get(types.get(controller, ""), ())
            names = _given(workspace).get(controller, frozenset())
            lacking = tuple(name for name in needed if name not in names | _given(workspace).get("*", frozenset()))
            if lacking and any(entry.path[-1] != "type" for entry in section.entries):
                yield IncompleteController(Place(file, *section.span), controller, types[controller], lacking)


def passed_over_by_moveit(workspace: WorkspaceIndex) -> Iterator[IncompleteController]:
    """The controllers that a file names for MoveIt, and of which it does not say all that it has to."""
    for folder in sorted(workspace.manifests):
        files = [] if workspace.manifests[folder].ros1 else workspace.tree.files_below(folder)
        for file in (file for file in files if file.endswith((".yaml", ".yml")) and not is_aside(workspace, file)):
            text = workspace.tree.text(file) if workspace.code.mentions(file, MANAGER) else None
            for row in () if text is None or is_template(text) else passed_over(text):
                yield IncompleteController(Place(file, *row.span), row.name, "", row.lacking)


@once
def _given(workspace: WorkspaceIndex) -> Mapping[str, frozenset[str]]:
    """The names of the parameters that any file gives a controller, by its name; for several of them by ``*``."""
    names: dict[str, set[str]] = {}
    for _, facts in parameter_files(workspace):
        for section in facts.sections:
            node = section.path[-1].rpartition("/")[2] if section.path else "*"
            key = "*" if "*" in node else node
            names.setdefault(key, set()).update(entry.name.partition(".")[0] for entry in section.entries)
    return {node: frozenset(given) for node, given in names.items()}


__all__ = ["IncompleteController", "incomplete_controllers", "passed_over_by_moveit"]
