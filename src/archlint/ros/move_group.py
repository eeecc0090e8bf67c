"""The services and actions of one node that many workspaces ask: ``move_group`` of MoveIt 2.

Source: ``capability_names.hpp`` of moveit_ros_move_group, whose capabilities a launch file starts by default.
"""

from __future__ import annotations

_OF_MOVE_GROUP = frozenset(
    {"apply_planning_scene", "check_state_validity", "clear_octomap", "compute_cartesian_path", "compute_fk"}
    | {"compute_ik", "execute_trajectory", "get_planner_params", "get_planning_scene", "move_action"}
    | {"plan_kinematic_path", "query_planner_interface", "set_planner_params"}
)


def namespace_of_move_group(name: str) -> str | None:
    """The namespace of the ``move_group`` that a name of a service or an action is of, relative or not: one node has
    all names of one namespace.  None where the name is of another node."""
    namespace, _, last = name.strip("/").rpartition("/")
    return namespace if last in _OF_MOVE_GROUP else None


__all__ = ["namespace_of_move_group"]
