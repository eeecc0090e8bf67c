"""Rows of nodes: how they are made, what they are called, how they and what they have made are destroyed."""

from __future__ import annotations

from archlint.libraries.tables.api import Api

_NODE_OPTIONS = (
    "* context cli_args namespace use_global_arguments enable_rosout rosout_qos_profile "
    "start_parameter_services parameter_overrides allow_undeclared_parameters "
    "automatically_declare_parameters_from_overrides enable_logger_service rclcpp_options"
)
"""What rclpy's nodes take, and last the ``rclcpp::NodeOptions`` that those of C++ take in its place."""

ROWS = (
    # ---- nodes
    Api("rclpy.create_node", f"node_name {_NODE_OPTIONS}", effect="create_node"),
    Api("rclpy.node.Node", f"node_name {_NODE_OPTIONS}", effect="create_node"),
    Api("rclpy.node.Node.__init__", f"node_name {_NODE_OPTIONS}", effect="node_init"),
    Api(
        "rclpy.lifecycle.node.LifecycleNode",
        f"node_name {_NODE_OPTIONS} enable_communication_interface",
        effect="create_node",
        lifecycle=True,
    ),
    Api(
        "rclpy.lifecycle.node.LifecycleNode.__init__",
        f"node_name {_NODE_OPTIONS} enable_communication_interface",
        effect="node_init",
        lifecycle=True,
    ),
    Api(
        "rclpy.lifecycle.node.LifecycleNodeMixin.__init__",
        "* enable_communication_interface callback_group",
        watched=True,
    ),
    Api("rclpy.experimental.async_node.AsyncNode", f"node_name {_NODE_OPTIONS}", effect="create_node"),
    Api("rclpy.experimental.async_node.AsyncNode.__init__", f"node_name {_NODE_OPTIONS}", effect="node_init"),
    # ---- what makes a node of C++ in the same process (moveit_py, moveit/planning.py; py_binding_tools, rclcpp.cpp)
    Api("moveit.planning.MoveItPy", "node_name", watched=True),
    Api("rclcpp.Node", "name options", watched=True),
    # ---- before there is any
    Api("rclpy.init", "* args context domain_id signal_handler_options", effect="initialise"),
    # ---- names of nodes
    Api("rclpy.node.Node.get_name", effect="get_name"),
    Api("rclpy.node.Node.get_namespace", effect="get_namespace"),
    Api("rclpy.node.Node.get_fully_qualified_name", effect="get_fully_qualified_name"),
    Api("rclpy.node.Node.resolve_topic_name", "topic * only_expand", effect="resolve_name"),
    Api("rclpy.node.Node.resolve_service_name", "service * only_expand", effect="resolve_name"),
    # ---- destroying
    Api("rclpy.node.Node.destroy_node", effect="destroy_node"),
    Api("rclpy.node.Node.destroy_publisher", "entity", effect="destroy", watched=True),
    Api("rclpy.node.Node.destroy_subscription", "entity", effect="destroy", watched=True),
    Api("rclpy.node.Node.destroy_client", "entity", effect="destroy", watched=True),
    Api("rclpy.node.Node.destroy_service", "entity", effect="destroy", watched=True),
    Api("rclpy.node.Node.destroy_timer", "entity", effect="destroy", watched=True),
    Api("rclpy.timer.Timer.cancel", watched=True),
    *(
        Api(f"rclpy.{cls}.destroy", watched=True)
        for cls in (
            "timer.Timer",
            "client.Client",
            "publisher.Publisher",
            "subscription.Subscription",
            "service.Service",
            "action.client.ActionClient",
        )
    ),
)

__all__ = ["ROWS"]
