"""Names of ROS's C++ libraries, in the words of their Python ones.

A node of C++ is lowered to what the same node is with rclpy: what creates an endpoint, what spins and what an executor
is called differ in the name alone.  What rclpy lacks, the builders of a QoS say, keeps its own name.
Source: ``rclcpp/rclcpp.hpp``, ``rclcpp_action/rclcpp_action.hpp``, ``rclcpp_lifecycle/lifecycle_node.hpp``.
"""

from __future__ import annotations

LIBRARIES = frozenset(
    {
        *("rclcpp", "rclcpp_action", "rclcpp_lifecycle", "rclcpp_components", "std", "message_filters", "boost"),
        *(
            "image_transport",
            "camera_info_manager",
            "tf2_ros",
            "tf2",
            "fmt",
            "nav2_util",
            "nav2_ros_common",
            "Eigen",
            "cv",
            "pcl",
            "YAML",
        ),
        *("diagnostic_updater", "controller_interface", "hardware_interface", "point_cloud_transport", "rcutils"),
        *("nav2_costmap_2d", "nav2_core", "moveit", "rviz_common", "rqt_gui_cpp", "lifecycle_msgs", "ament_index_cpp"),
        *("autoware_utils", "autoware", "BT", "rosbag2_cpp", "rosbag2_transport", "pluginlib", "urdf", "KDL", "Ogre"),
    }
)
"""Namespaces that are not the workspace's own, unless it says otherwise."""

IN_PYTHON = {
    "rclcpp.Node": "rclpy.node.Node",
    "rclcpp_lifecycle.LifecycleNode": "rclpy.lifecycle.node.LifecycleNode",
    "rclcpp.init": "rclpy.init",
    "rclcpp.shutdown": "rclpy.shutdown",
    "rclcpp.ok": "rclpy.ok",
    "rclcpp.spin": "rclpy.spin",
    "rclcpp.spin_some": "rclpy.spin_once",
    "rclcpp.spin_until_future_complete": "rclpy.spin_until_future_complete",
    "rclcpp.executors.SingleThreadedExecutor": "rclpy.executors.SingleThreadedExecutor",
    "rclcpp.executors.StaticSingleThreadedExecutor": "rclpy.executors.SingleThreadedExecutor",
    "rclcpp.executors.MultiThreadedExecutor": "rclpy.executors.MultiThreadedExecutor",
    "rclcpp.experimental.executors.EventsExecutor": "rclpy.executors.SingleThreadedExecutor",
    "rclcpp.Parameter": "rclpy.parameter.Parameter",
    "rclcpp_action.create_server": "rclpy.action.server.ActionServer",
    "rclcpp_action.create_client": "rclpy.action.client.ActionClient",
    "message_filters.Subscriber": "message_filters.Subscriber",
    "tf2_ros.Buffer": "tf2_ros.buffer_h.Buffer",
    "tf2_ros.TransformBroadcaster": "tf2_ros.transform_broadcaster.TransformBroadcaster",
    "tf2_ros.StaticTransformBroadcaster": "tf2_ros.static_transform_broadcaster.StaticTransformBroadcaster",
    "tf2_ros.TransformListener": "tf2_ros.transform_listener.TransformListener",
    "std.string": "str",
    "std.string_view": "str",
    "std.to_string": "str",
    "rclcpp.ParameterEventHandler": "rclpy.parameter_event_handler.ParameterEventHandler",
    "rclcpp.AsyncParametersClient": "rclpy.parameter_client.AsyncParameterClient",
    **{
        f"rclcpp.{scope}PARAMETER_{name}": f"rclpy.parameter.Parameter.Type.{name}"
        for scope in ("", "ParameterType.")
        for name in (
            *("BOOL", "INTEGER", "DOUBLE", "STRING"),
            *("BYTE_ARRAY", "BOOL_ARRAY", "INTEGER_ARRAY", "DOUBLE_ARRAY", "STRING_ARRAY"),
        )
    },
}

RMW_PROFILES = {
    "rmw_qos_profile_default": "rclpy.qos.qos_profile_default",
    "rmw_qos_profile_sensor_data": "rclpy.qos.qos_profile_sensor_data",
    "rmw_qos_profile_services_default": "rclpy.qos.qos_profile_services_default",
    "rmw_qos_profile_parameters": "rclpy.qos.qos_profile_parameters",
    "rmw_qos_profile_parameter_events": "rclpy.qos.qos_profile_parameter_events",
    "rmw_qos_profile_system_default": "rclpy.qos.qos_profile_system_default",
}

OPENED = {
    "std": frozenset(
        {
            *("string", "to_string", "make_shared", "make_unique", "make_pair", "make_tuple", "bind", "move", "ref"),
            *("vector", "list", "deque", "set", "array", "map", "unordered_map", "shared_ptr", "unique_ptr", "chrono"),
            *("stringstream", "ostringstream", "static_pointer_cast", "dynamic_pointer_cast", "getline"),
        }
    ),
    "rclcpp": frozenset(
        {
            *("Node", "NodeOptions", "QoS", "KeepLast", "KeepAll", "SensorDataQoS", "SystemDefaultsQoS", "ServicesQoS"),
            *("ParametersQoS", "QoSInitialization", "Parameter", "executors", "init", "ok", "shutdown", "spin"),
            *("spin_some", "create_publisher", "create_subscription", "create_service", "create_client"),
        }
    ),
}
"""Names of libraries that many use without their namespace, behind ``using namespace``."""
UNLIKE_METHODS = frozenset({"init", "ok", "shutdown", "spin", "spin_some", "move", "set"}) | {
    *("create_publisher", "create_subscription", "create_service", "create_client"),
}
"""Those of them that methods are called, too: in a method of a class they mean these."""

POINTERS = frozenset(
    {
        *("SharedPtr", "ConstSharedPtr", "UniquePtr", "ConstUniquePtr", "WeakPtr", "ConstWeakPtr", "Ptr", "ConstPtr"),
        *("SharedConstPtr",),
    }
)
"""What is said of a class for a pointer to it."""

INTERFACE_KINDS = frozenset({"msg", "srv", "action"})

THREADS = frozenset({"std.jthread", "std.thread"})
"""Classes whose constructor takes a function and what it is to be called with, as ``std::bind`` does."""

SAME = frozenset(
    {
        *("std.move", "std.forward", "std.ref", "std.cref", "std.static_pointer_cast", "std.dynamic_pointer_cast"),
        *(
            "std.const_pointer_cast",
            "std.as_const",
            "std.make_optional",
            "rclcpp.ParameterValue",
            "std.chrono.duration_cast",
        ),
        *("std.reference_pointer_cast", "static_cast", "dynamic_cast", "const_cast", "reinterpret_cast"),
    }
)
"""Functions that give what they are given, as far as names are concerned."""

MAKERS = frozenset({"std.make_shared", "std.make_unique", "std.allocate_shared", "boost.make_shared"})
"""Functions that make an object of their template argument."""

DURATIONS = {
    "std.chrono.hours": 3600.0,
    "std.chrono.minutes": 60.0,
    "std.chrono.seconds": 1.0,
    "std.chrono.milliseconds": 1e-3,
    "std.chrono.microseconds": 1e-6,
    "std.chrono.nanoseconds": 1e-9,
}
"""In seconds."""

RATIOS = {"ratio<1>": 1.0, "ratio<60>": 60.0, "milli": 1e-3, "micro": 1e-6, "nano": 1e-9}
"""What ``std::chrono::duration`` counts, by its second template argument: in seconds."""

PAIRS_MADE_BY = frozenset({"std.make_pair", "std.make_tuple", "std.pair", "std.tuple"})
CHANGING = {
    **{f"std.{name}": 0 for name in ("replace", "replace_if", "remove", "remove_if", "fill", "generate", "reverse")},
    **{"std.transform": 2, "std.copy": 2, "std.getline": 1},
    **{
        f"boost.{scope}{name}": 0
        for scope in ("", "algorithm.")
        for name in ("replace_all", "replace_first", "replace_last", "erase_all", "to_lower", "to_upper", "trim")
    },
}
"""Functions that change what they are given, or what the iterator they are given points to: which argument that is."""
PAIRS = "std.pairs"
"""The function that gives the pairs of a map, and any other container as it is; the standard library has none."""
FIELDS = "__fields__"
"""The method that gives the fields of a class their first values."""
FIELD, MEMBER, OBJECT = "std.__field__", "std.__member__", "std.__object__"
"""The functions that give a member which is an object: before anything makes it, and made with arguments; and a
variable that is one, made without any."""
DECLARED = "std.__declared__"
"""The function that gives what is declared in one place and defined in another."""
ITSELF = "std.__itself__"
"""The function that gives the object, or the class, whose method is called by the name of its class."""
SETTLED = "std.__settled__"
"""The function that gives a text that a loop changes: not known where it may not be."""
COPY = "std.__copy__"
"""The function that gives a copy of an object that is no pointer."""
ITEM = "std.__item__"
"""The function that makes what is put into a container that is a field, of what stands in braces."""
CALLER = "std.__caller__"
"""The function that gives the object of the method that a macro is used in."""
PARTS = "std.__parts__"
"""The function that gives what ``auto [a, b]`` takes of a value."""
PUT, SUBSTRING, TYPE_OF, VALUE_OR = "std.__put__", "std.__substring__", "std.__type_of__", "std.__value_or__"
"""The functions that put something into a container, and give a part of a text, the type of a value, and what an
optional value holds."""
NUMBER = "std.__number__"
"""The function that gives the number of a type that a value is made to."""
GIVEN = "std.__given__"
"""The function that gives what a field holds after an object was made of values."""
TEMPLATE_ARGUMENT = "std.template_argument"
"""The function that gives what a template argument of a class is for one of its objects."""
SEQUENCES = frozenset({"vector", "list", "deque", "set", "unordered_set", "array", "initializer_list"})
MAPS = frozenset({"map", "unordered_map", "multimap"})
STREAMS = frozenset({"stringstream", "ostringstream"})

OF_DOUBLES = frozenset({"vector<double>", "vector<float>"})
PARAMETER_TYPES = {
    **{"string": "STRING", "bool": "BOOL"},
    **dict.fromkeys(("float", "double", "float_t", "double_t"), "DOUBLE"),
    **dict.fromkeys(
        ("int", "long", "longlong", "short", "unsigned", "unsignedint", "unsignedlong", "size_t"), "INTEGER"
    ),
    **{f"{sign}int{bits}_t": "INTEGER" for sign in ("", "u") for bits in (8, 16, 32, 64)},
    "vector<std::string>": "STRING_ARRAY",
    "vector<double>": "DOUBLE_ARRAY",
    "vector<int64_t>": "INTEGER_ARRAY",
    "vector<bool>": "BOOL_ARRAY",
}
"""The types of parameters by those of C++, without ``std::`` in front and without blanks."""


__all__ = [
    "CALLER",
    "CHANGING",
    "COPY",
    "DECLARED",
    "DURATIONS",
    "FIELD",
    "FIELDS",
    "GIVEN",
    "INTERFACE_KINDS",
    "IN_PYTHON",
    "ITEM",
    "ITSELF",
    "LIBRARIES",
    "MAKERS",
    "MAPS",
    "MEMBER",
    "NUMBER",
    "OBJECT",
    "OF_DOUBLES",
    "OPENED",
    "PAIRS",
    "PAIRS_MADE_BY",
    "PARAMETER_TYPES",
    "PARTS",
    "POINTERS",
    "PUT",
    "RATIOS",
    "RMW_PROFILES",
    "SAME",
    "SEQUENCES",
    "SETTLED",
    "STREAMS",
    "SUBSTRING",
    "TEMPLATE_ARGUMENT",
    "TYPE_OF",
    "UNLIKE_METHODS",
    "VALUE_OR",
]
