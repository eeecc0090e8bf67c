"""Names that something outside of the workspace chooses: code here can only repeat them."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from archlint.analysis.kept import once

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.systems.nodes import Endpoint

_PRESCRIBED = (
    *("/fmu/", "/ap/", "/mavros/"),  # the firmware of drones: PX4, ArduPilot
    *("/world/", "/gazebo/", "/pause_physics", "/unpause_physics", "/reset_simulation", "/reset_world"),  # Gazebo
    *("/carla/", "/turtle1/"),  # simulators: of a town, and of the turtle that turtlesim begins with
    *("/lf/lowstate", "/lf/sportmodestate", "/lowcmd", "/lowstate", "/sportmodestate"),  # Unitree
    *("/utlidar/",),
    *("/camera/camera/",),  # the driver of RealSense cameras, for a camera that nobody gives a name
)
"""How the names begin that drivers and bridges of systems outside of ROS choose, of which one robot or one simulation
has one."""
_OF_A_MODEL = re.compile(r"/model/[^/]+/(?:joint/[^/]+/|(?:cmd_vel|odometry|pose|tf)$)")
"""What Gazebo's plugins for joints (JointController, JointPositionController, Thruster) and for driving (DiffDrive,
AckermannSteering, OdometryPublisher, PosePublisher) call the topics of a model that nobody names.

Source: gz-sim, ``src/systems``: ``/model/<model>/joint/<joint>/cmd_vel``, ``/model/<model>/odometry`` and the like.
"""
_OF_UNITREE = re.compile(r"/api/\w+/(?:request|response)$")
"""What the firmware of Unitree's robots calls the topics of its services: ``/api/sport/request``, ``/api/arm/request``.

Source: unitree_ros2, ``example/src/include/common``.
"""
_OF_AUTOWARE = (
    "/api/",
    "/awapi/",
    "/control/",
    "/localization/",
    "/perception/",
    "/planning/",
    "/sensing/",
    "/vehicle/",
)
"""How the names begin that Autoware's components have in its own launch files."""
_TYPES_OF_OTHERS = (
    *("carla_msgs/", "gazebo_msgs/srv/", "linkattacher_msgs/", "ros_gz_interfaces/srv/"),
    *("rmf_", "unitree_api/", "unitree_go/", "unitree_hg/"),
)
"""Interfaces that only such a system speaks: ``/spawn_entity`` of gazebo_ros is one for all robots, and Open-RMF's
``/robot_path_requests`` (of ``rmf_fleet_msgs``) one for the whole site.  MAVROS and PX4 are not among them: each
vehicle has a namespace, which the workspace chooses, unless the name begins as theirs do by default."""


_STARTED_OWNERS = ("_node",)
"""How the names of nodes end that a launch file of the workspace may name: ``/lidar_node/scan`` is below one."""
_OWNERS = (*_STARTED_OWNERS, "_controller", "_broadcaster", "controller_manager")
"""Those, and what ros2_control names: ``/arm_controller/commands`` is a controller's, whoever starts their manager."""


def is_foreign(workspace: WorkspaceIndex | None, endpoint: Endpoint) -> bool:
    """Whether something outside of the workspace chooses a name: a system that is no ROS, or a node below whose name
    it is."""
    name = endpoint.written or ""
    return _is_prescribed(workspace, endpoint) or _is_private_to_foreign_node(workspace, name)


def _is_prescribed(workspace: WorkspaceIndex | None, endpoint: Endpoint) -> bool:
    """Whether a system outside of ROS fixes a name: by the name, or by its type where no other node of the workspace is
    at the other end, so that it is that system which is spoken with.  A name below a namespace such as ``/robot_1`` is
    the workspace's own choice."""
    name, type_ = endpoint.written or "", endpoint.type or ""
    types = (other.type or "" for other in (endpoint, *endpoint.node.endpoints))
    if name.startswith(_OF_AUTOWARE) and any(other.startswith(("autoware_", "tier4_")) for other in types):
        return True
    if name.startswith(_PRESCRIBED) or _OF_A_MODEL.match(name) or _OF_UNITREE.match(name):
        return True
    spoken_with = type_.startswith(_TYPES_OF_OTHERS) and name.rfind("/") <= 0
    return spoken_with and (workspace is None or name not in _spoken_here(workspace))


@once
def _spoken_here(workspace: WorkspaceIndex) -> frozenset[str]:
    """The names that a node of the workspace provides and another uses."""
    return frozenset(
        connection.name
        for system in workspace.systems
        for connection in (*system.topics.values(), *system.services.values(), *system.actions.values())
        if any(
            user.node is not provider.node and not (user.external or provider.external)
            for user in connection.users
            for provider in connection.providers
        )
    )


def _is_private_to_foreign_node(workspace: WorkspaceIndex | None, name: str) -> bool:
    """Whether a name lies below that of a node (``/lidar_node/scan`` is its ``~/scan``) which no code of the workspace
    makes and no launch file starts."""
    owner, _, rest = name[1:].partition("/")
    if not owner.endswith(_OWNERS) or not rest or workspace is None:
        return False
    return not any(
        owner in (node.name or "").split("/")
        for system in workspace.systems
        for node in system.nodes
        if node.blueprint is not None or owner.endswith(_STARTED_OWNERS)
    )


__all__ = ["is_foreign"]
