"""The headers that C++ code includes and that no package makes: of interfaces by names of their own, and of ROS 1.

Source: rosidl_generator_cpp writes ``package/msg/joint_state.hpp`` for ``JointState``
(``convert_camel_case_to_lower_case_underscore`` of rosidl_pycommon); what ROS 1 made was ``package/JointState.h``.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from archlint.packaging.cpp_includes import includes_of, is_of_workspace
from archlint.place import Place
from archlint.python_code.cpp_members import built_code
from archlint.records import dataclass
from archlint.ros.interfaces import InterfaceTable, header_stem
from archlint.suggestions import nearest
from archlint.syntax.interfaces import KIND_OF_SUFFIX

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.installed import Installs

_OF_INTERFACE = re.compile(r"([a-z][a-z0-9_]*)/(msg|srv|action)/(\w+)\.(hpp|h)")
_OF_ROS_1 = re.compile(r"([a-z][a-z0-9_]*)/([A-Z]\w*)\.h")
_OF_MESSAGES = ("_msgs", "_interfaces", "_srvs")
_OF_BUILDS_OF_ROS_1 = frozenset({"catkin", "catkin_package", "roscpp"})
_MOVED: Mapping[str, str] = {
    "ros/ros.h": "rclcpp/rclcpp.hpp",
    "ros/console.h": "rclcpp/logging.hpp",
    "tf/tf.h": "tf2/utils.h",
    "tf/transform_broadcaster.h": "tf2_ros/transform_broadcaster.h",
    "tf/transform_listener.h": "tf2_ros/transform_listener.h",
    "actionlib/client/simple_action_client.h": "rclcpp_action/rclcpp_action.hpp",
    "actionlib/server/simple_action_server.h": "rclcpp_action/rclcpp_action.hpp",
    "nodelet/nodelet.h": "rclcpp_components/register_node_macro.hpp",
}
"""Headers of ROS 1, and those of ROS 2 that have their place."""


@dataclass(frozen=True)
class UnmadeHeader:
    """A header that is included and that there is not, and the one that was perhaps meant."""

    place: Place
    header: str
    meant: str
    of_ros1: bool = False
    is_case: bool = False
    """Whether it is only written in another way than the one that there is: this is so in every distribution."""


def unmade_headers(workspace: WorkspaceIndex) -> Iterator[UnmadeHeader]:
    """Each of them, in code that is built."""
    table = workspace.interfaces
    for path in () if table is None else built_code(workspace):
        own = workspace.packages.get(workspace.package_of(path) or "")
        if own is None or own.ros1 or own.build_type != "ament_cmake" or "ros1" in own.name:
            continue
        beside_ros1 = _is_beside_ros1(workspace.installs.get(own.name))
        for header, line in includes_of(workspace.tree.text(path) or ""):
            row = None if table is None else _judged(table, header, Place(path, line, 1, line, 1))
            if row is not None and not (row.of_ros1 and beside_ros1) and not is_of_workspace(workspace, header):
                yield row


def _is_beside_ros1(installs: Installs | None) -> bool:
    """Whether a build looks for ROS 1, too, as that of a bridge does."""
    words = frozenset[str]() if installs is None else installs.words
    return any("ros1" in word.lower() or word in _OF_BUILDS_OF_ROS_1 for word in words)


def _judged(table: InterfaceTable, header: str, place: Place) -> UnmadeHeader | None:
    if header in _MOVED:
        return UnmadeHeader(place, header, _MOVED[header], of_ros1=True, is_case=True)
    of_interface = _OF_INTERFACE.fullmatch(header)
    if of_interface is not None:
        return _of_interface(table, header, place, of_interface)
    old = _OF_ROS_1.fullmatch(header)
    if old is None:
        return None
    package, name = old.groups()
    kinds = [kind for kind in KIND_OF_SUFFIX.values() if name in table.of_package(package, kind)]
    if not kinds or not table.is_known(package):
        return None
    return UnmadeHeader(place, header, f"{package}/{kinds[0]}/{header_stem(name)}.hpp", of_ros1=True, is_case=True)


def _of_interface(table: InterfaceTable, header: str, place: Place, of_interface: re.Match[str]) -> UnmadeHeader | None:
    package, kind, stem, _ = of_interface.groups()
    of_kind = KIND_OF_SUFFIX[kind]
    if "__" in stem:
        return None
    if stem != stem.lower():
        is_of_messages = package.endswith(_OF_MESSAGES) or table.is_known(package)
        wanted = f"{package}/{kind}/{header_stem(stem)}.hpp"
        return UnmadeHeader(place, header, wanted, is_case=True) if is_of_messages else None
    if not table.is_known(package) or table.is_of_workspace(package):
        return None
    stems = [header_stem(name) for name in table.of_package(package, of_kind)]
    if stem in stems:
        return None
    meant = nearest(stem, stems)
    return UnmadeHeader(place, header, "" if meant is None else f"{package}/{kind}/{meant}.hpp")


__all__ = ["UnmadeHeader", "unmade_headers"]
