"""Calls of functions and methods that rclpy does not have: those of ROS 1, and misspelt ones."""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING

from archlint import model, suggestions
from archlint.libraries.api_signatures import attributes_of, distros, own_names_of
from archlint.libraries.rclpy import names, refusals
from archlint.syntax.misspelt_constructor import is_misspelt_call

if TYPE_CHECKING:
    from archlint.interpreter.call_site import CallSite
    from archlint.interpreter.values import Value
    from archlint.libraries.run import Run

_OF_ROS_1 = {
    "rclpy.AsyncSpinner": "an executor of rclpy.executors",
    "rclpy.Publisher": "create_publisher() of a node",
    "rclpy.Rate": "create_rate() of a node",
    "rclpy.Service": "create_service() of a node",
    "rclpy.ServiceProxy": "create_client() of a node",
    "rclpy.Subscriber": "create_subscription() of a node",
    "rclpy.Time.now": "get_clock().now() of a node",
    "rclpy.Timer": "create_timer() of a node",
    "rclpy.delete_param": "undeclare_parameter() of a node",
    "rclpy.get_caller_id": "get_fully_qualified_name() of a node",
    "rclpy.get_param": "get_parameter() of a node",
    "rclpy.get_published_topics": "get_topic_names_and_types() of a node",
    "rclpy.get_rostime": "get_clock().now() of a node",
    "rclpy.get_time": "get_clock().now() of a node",
    "rclpy.has_param": "has_parameter() of a node",
    "rclpy.init_node": "create_node()",
    "rclpy.is_shutdown": "ok()",
    "rclpy.logdebug": "get_logger().debug() of a node",
    "rclpy.logerr": "get_logger().error() of a node",
    "rclpy.logfatal": "get_logger().fatal() of a node",
    "rclpy.loginfo": "get_logger().info() of a node",
    "rclpy.logwarn": "get_logger().warning() of a node",
    "rclpy.myargv": "rclpy.utilities.remove_ros_args(args=sys.argv)",
    "rclpy.on_shutdown": "get_default_context().on_shutdown()",
    "rclpy.set_param": "set_parameters() of a node",
    "rclpy.signal_shutdown": "shutdown()",
    "rclpy.sleep": "time.sleep()",
    "rclpy.wait_for_service": "wait_for_service() of a client",
}
"""What rospy has and rclpy has not, in any distribution, and what rclpy has instead."""
_LOGS = {"debug": "debug", "info": "info", "warn": "warning", "err": "error", "fatal": "fatal"}
"""What ``rospy.loginfo`` and its like end in, and the method of a logger."""
_INSTEAD = {
    "rclpy.action.client.ActionClient.cancel_all_goals": "cancel_goal_async() of the goal handle",
    "rclpy.action.client.ActionClient.cancel_goal": "cancel_goal_async() of the goal handle",
    "rclpy.action.client.ActionClient.cancel_goal_async": "cancel_goal_async() of the goal handle",
    "rclpy.action.client.ActionClient.get_result": "get_result_async() of the goal handle",
    "rclpy.action.client.ActionClient.get_state": "status of the goal handle",
    "rclpy.action.client.ActionClient.wait_for_result": "get_result_async() of the goal handle",
    "rclpy.action.server.ActionServer.is_preempt_requested": "is_cancel_requested of the goal handle",
    "rclpy.action.server.ActionServer.publish_feedback": "publish_feedback() of the goal handle",
    "rclpy.action.server.ActionServer.set_aborted": "abort() of the goal handle",
    "rclpy.action.server.ActionServer.set_preempted": "canceled() of the goal handle",
    "rclpy.action.server.ActionServer.set_succeeded": "succeed() of the goal handle",
    "rclpy.client.Client.call_sync": "call()",
    "rclpy.executors.Executor.submit": "create_task()",
    "rclpy.node.Node.create_server": "create_service()",
    "rclpy.node.Node.create_subscriber": "create_subscription()",
    "rclpy.node.Node.destroy": "destroy_node()",
    "rclpy.node.Node.destroy_server": "destroy_service()",
    "rclpy.node.Node.destroy_subscriber": "destroy_subscription()",
    "rclpy.node.Node.get_name_space": "get_namespace()",
    "rclpy.node.Node.get_param": "get_parameter()",
    **{f"rclpy.node.Node.log{name}": f"get_logger().{level}()" for name, level in _LOGS.items()},
    "rclpy.node.Node.get_subscription_names_and_types_by_node": "get_subscriber_names_and_types_by_node()",
    "rclpy.node.Node.has_param": "has_parameter()",
    "rclpy.node.Node.set_param": "set_parameters()",
    "rclpy.publisher.Publisher.get_num_connections": "get_subscription_count()",
    "rclpy.publisher.Publisher.unregister": "destroy_publisher() of the node",
    "rclpy.subscription.Subscription.unregister": "destroy_subscription() of the node",
    "rclpy.task.Future.get_result": "result()",
    "tf2_ros.buffer.Buffer.canTransform": "can_transform()",
    "tf2_ros.buffer.Buffer.lookupTransform": "lookup_transform()",
    "tf2_ros.buffer.Buffer.waitForTransform": "can_transform() with a timeout",
    "tf2_ros.buffer.Buffer.wait_for_transform": "can_transform() with a timeout",
    "rclpy.task.Future.get": "result()",
    "rclpy.task.Future.is_done": "done()",
    "rclpy.timer.Timer.cancelled": "is_canceled()",
    "rclpy.timer.Timer.shutdown": "cancel()",
    "rclpy.timer.Timer.stop": "cancel()",
}
"""Methods that people expect, most of them from rospy and actionlib, and what there is."""


_OF_NODES = frozenset().union(*filter(None, map(attributes_of, (names.NODE, names.LIFECYCLE_NODE))))


_OF_BUFFER = frozenset(own_names_of(names.BUFFER)) | {
    "all_frames_as_string",
    "all_frames_as_yaml",
    "can_transform_core",
    "can_transform_full_core",
    "clear",
    "get_latest_common_time",
    "lookup_transform_core",
    "lookup_transform_full_core",
    "registration",
    "transform",
}
"""What a buffer of tf2 has; part of it is that of a class which is not of Python."""


def instead_of(path: str) -> str:
    """What rclpy has instead of a function that rospy has, in words; empty for any other name."""
    return _OF_ROS_1.get(path, "")


def note_function(run: Run, path: str, site: CallSite) -> None:
    """Note a call of a function of rospy in rclpy's name."""
    if path in _OF_ROS_1:
        _note(run, path, _OF_ROS_1[path], site)


def note_method(run: Run, path: str, receiver: Value, site: CallSite) -> None:
    """Note a call of a method that no distribution has; what else gives an object a method of that name is for the
    rule to find."""
    owner, _, name = path.rpartition(".")
    if name in _VALUES.get(names.NODE if owner in names.NODE_CLASSES else owner, ()):
        if refusals.is_of_rclpy(receiver):
            _note(run, path, "", site, model.Misuse.VALUE)
        return
    known = _known(owner)
    if known is not None and name not in known and refusals.is_of_rclpy(receiver):
        misspelt = site.expression is not None and is_misspelt_call(site.expression)
        _note(run, path, "super().__init__(…)" if misspelt else _instead_of_method(path), site)


def _known(owner: str) -> frozenset[str] | None:
    """The attributes that a class has in some distribution; None of one that is not known."""
    if owner == names.BUFFER:
        return _OF_BUFFER
    return _OF_NODES if owner in names.NODE_CLASSES else attributes_of(owner)


@lru_cache(maxsize=10_000)
def _instead_of_method(path: str) -> str:
    """What rclpy has instead of a method, in words; empty where nothing is near.  C++ asks this at every step: rclcpp
    has other methods."""
    owner, _, name = path.rpartition(".")
    expected = f"rclpy.executors.Executor.{name}" if owner.startswith("rclpy.executors.") else path
    near = suggestions.nearest(name, [other for other in _known(owner) or () if not other.startswith("_")])
    if owner in names.NODE_CLASSES and near in _PROPERTIES:
        return f"{near}, which has no parentheses and gives one after the other: list(self.{near})"
    return _INSTEAD.get(expected) or (f"{near}()" if near else "")


_PROPERTIES = frozenset({"clients", "guards", "publishers", "services", "subscriptions", "timers", "waitables"})
"""What a node has made: properties that are iterated over."""


_VALUES = {
    names.NODE: _PROPERTIES | {"context", "default_callback_group", "handle"},
    "rclpy.action.client.ClientGoalHandle": frozenset({"accepted", "goal_id", "stamp", "status"}),
    "rclpy.client.Client": frozenset({"srv_name", "srv_type"}),
    "rclpy.timer.Timer": frozenset({"timer_period_ns"}),
}
"""What objects have as a value, and is no function."""


def _note(run: Run, path: str, instead: str, site: CallSite, misuse: model.Misuse = model.Misuse.ABSENT) -> None:
    place = refusals.place_of(run, site)
    if place is None:
        return
    owner, _, name = path.rpartition(".")
    refusals.keep(
        run,
        place,
        path,
        model.RefusedCall(place, path, misuse, (name,), given=owner, wanted=instead, distros=distros()),
    )


__all__ = ["instead_of", "note_function", "note_method"]
