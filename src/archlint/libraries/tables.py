"""The API tables: one row a call that creates something, waits, sleeps or spins.

Signatures are those of rclpy, humble to rolling: positional order is the same in every supported distro unless a
row says otherwise; ``*`` starts the keyword-only parameters, and a ``?`` ends one that may be left out where a row is
``strict``.  A new API is a new row: the words of the screen, the methods of nodes, the arguments that Python refuses
and what fixes and rules know of it follow.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from archlint import model

OUTSIDE = "outside"
"""The kind of what waits for the network, a process or a file: nothing of ROS."""


@dataclass(frozen=True)
class Api:
    """One callable.  ``effect`` names what the run does with a call; the other fields say which parameter
    plays which part for that effect."""

    path: str
    params: tuple[str, ...]
    effect: str = "none"
    kind: str = ""
    node: str | None = None
    """Parameter that is the node; None: the object the method is called on."""
    type: str | None = None
    name: str | None = None
    qos: str | None = None
    group: str | None = None
    callbacks: tuple[tuple[str, str], ...] = ()
    """``(parameter, role)``."""
    default_qos: str = ""
    fixed_name: str | None = None
    fixed_type: str | None = None
    returns: str | None = None
    """Canonical class of what the call returns."""
    extra: dict[str, str] = field(default_factory=dict)
    watched: bool = False
    """True where checks want to see each call."""
    strict: bool = False
    """True where all supported distributions take these positional arguments: Python refuses any other call."""
    optional: frozenset[str] = frozenset()
    """Positional parameters that may be left out; only a strict row says which."""

    @property
    def creates(self) -> bool:
        """Whether a call makes an endpoint or a timer."""
        return self.effect in ("endpoint", "timer")

    @property
    def positional(self) -> tuple[str, ...]:
        return self.params[: self.params.index("*")] if "*" in self.params else self.params


def _row(path: str, signature: str, **data: object) -> Api:
    words = signature.split()
    optional = frozenset(word.rstrip("?") for word in words if word.endswith("?"))
    return Api(path, tuple(word.rstrip("?") for word in words), optional=optional, **data)  # type: ignore[arg-type]


_NODE_OPTIONS = (
    "* context cli_args namespace use_global_arguments enable_rosout rosout_qos_profile "
    "start_parameter_services parameter_overrides allow_undeclared_parameters "
    "automatically_declare_parameters_from_overrides enable_logger_service"
)
_ACTION_QOS = "goal_service_qos_profile result_service_qos_profile cancel_service_qos_profile"

ROWS = [
    # ---- nodes
    _row("rclpy.create_node", f"node_name {_NODE_OPTIONS}", effect="create_node"),
    _row("rclpy.node.Node", f"node_name {_NODE_OPTIONS}", effect="create_node"),
    _row("rclpy.node.Node.__init__", f"node_name {_NODE_OPTIONS}", effect="node_init"),
    _row(
        "rclpy.lifecycle.node.LifecycleNode",
        f"node_name {_NODE_OPTIONS} enable_communication_interface",
        effect="create_node",
        kind="lifecycle",
    ),
    _row(
        "rclpy.lifecycle.node.LifecycleNode.__init__",
        f"node_name {_NODE_OPTIONS} enable_communication_interface",
        effect="node_init",
        kind="lifecycle",
    ),
    _row("rclpy.experimental.async_node.AsyncNode", f"node_name {_NODE_OPTIONS}", effect="create_node"),
    _row("rclpy.experimental.async_node.AsyncNode.__init__", f"node_name {_NODE_OPTIONS}", effect="node_init"),
    # ---- endpoints
    _row(
        "rclpy.node.Node.create_publisher",
        "msg_type topic qos_profile * callback_group event_callbacks qos_overriding_options publisher_class",
        strict=True,
        effect="endpoint",
        kind=model.PUBLISHER,
        type="msg_type",
        name="topic",
        qos="qos_profile",
        group="callback_group",
        returns="rclpy.publisher.Publisher",
    ),
    _row(
        "rclpy.lifecycle.node.LifecycleNode.create_lifecycle_publisher",
        "msg_type topic qos_profile * callback_group event_callbacks qos_overriding_options publisher_class",
        strict=True,
        effect="endpoint",
        kind=model.PUBLISHER,
        type="msg_type",
        name="topic",
        qos="qos_profile",
        group="callback_group",
        returns="rclpy.publisher.Publisher",
    ),
    _row(
        "rclpy.node.Node.create_subscription",
        "msg_type topic callback qos_profile * callback_group event_callbacks qos_overriding_options raw "
        "content_filter_options acceptable_buffer_backends",
        strict=True,
        effect="endpoint",
        kind=model.SUBSCRIBER,
        type="msg_type",
        name="topic",
        qos="qos_profile",
        group="callback_group",
        callbacks=(("callback", "subscription"),),
        returns="rclpy.subscription.Subscription",
    ),
    _row(
        "rclpy.node.Node.create_client",
        "srv_type srv_name * qos_profile callback_group",
        strict=True,
        effect="endpoint",
        kind=model.CLIENT,
        type="srv_type",
        name="srv_name",
        qos="qos_profile",
        group="callback_group",
        default_qos="services_default",
        returns="rclpy.client.Client",
    ),
    _row(
        "rclpy.node.Node.create_service",
        "srv_type srv_name callback * qos_profile callback_group",
        strict=True,
        effect="endpoint",
        kind=model.SERVICE,
        type="srv_type",
        name="srv_name",
        qos="qos_profile",
        group="callback_group",
        default_qos="services_default",
        callbacks=(("callback", "service"),),
        returns="rclpy.service.Service",
    ),
    _row(
        "rclpy.action.server.ActionServer",
        "node action_type action_name execute_callback * callback_group goal_callback "
        f"handle_accepted_callback cancel_callback {_ACTION_QOS} feedback_pub_qos_profile "
        "status_pub_qos_profile result_timeout",
        effect="endpoint",
        kind=model.ACTION_SERVER,
        node="node",
        type="action_type",
        name="action_name",
        qos="goal_service_qos_profile",
        group="callback_group",
        default_qos="services_default",
        callbacks=(
            ("execute_callback", "execute"),
            ("goal_callback", "goal"),
            ("handle_accepted_callback", "accepted"),
            ("cancel_callback", "cancel"),
        ),
        returns="rclpy.action.server.ActionServer",
    ),
    _row(
        "rclpy.action.client.ActionClient",
        f"node action_type action_name * callback_group {_ACTION_QOS} feedback_sub_qos_profile "
        "status_sub_qos_profile enable_feedback_msg_optimization",
        effect="endpoint",
        kind=model.ACTION_CLIENT,
        node="node",
        type="action_type",
        name="action_name",
        qos="goal_service_qos_profile",
        group="callback_group",
        default_qos="services_default",
        returns="rclpy.action.client.ActionClient",
    ),
    _row(
        "rclpy.node.Node.create_timer",
        "timer_period_sec callback callback_group? clock? autostart?",
        strict=True,
        effect="timer",
        kind=model.TIMER,
        group="callback_group",
        callbacks=(("callback", "timer"),),
        returns="rclpy.timer.Timer",
    ),
    _row("rclpy.node.Node.create_rate", "frequency clock?", strict=True, effect="rate", returns="rclpy.timer.Rate"),
    _row(
        "rclpy.node.Node.create_guard_condition",
        "callback callback_group",
        effect="callbacks",
        group="callback_group",
        callbacks=(("callback", "guard"),),
    ),
    # ---- helpers that create on a node
    _row(
        "message_filters.Subscriber",
        "node msg_type topic qos_profile * callback_group event_callbacks qos_overriding_options raw "
        "content_filter_options",
        effect="endpoint",
        kind=model.SUBSCRIBER,
        node="node",
        type="msg_type",
        name="topic",
        qos="qos_profile",
        group="callback_group",
        default_qos="default",
        returns="message_filters.Subscriber",
    ),
    _row(
        "tf2_ros.transform_broadcaster.TransformBroadcaster",
        "node qos",
        effect="endpoint",
        kind=model.PUBLISHER,
        node="node",
        qos="qos",
        default_qos="tf",
        fixed_name="/tf",
        fixed_type="tf2_msgs/msg/TFMessage",
        returns="tf2_ros.transform_broadcaster.TransformBroadcaster",
    ),
    _row(
        "tf2_ros.static_transform_broadcaster.StaticTransformBroadcaster",
        "node qos",
        effect="endpoint",
        kind=model.PUBLISHER,
        node="node",
        qos="qos",
        default_qos="tf_static",
        fixed_name="/tf_static",
        fixed_type="tf2_msgs/msg/TFMessage",
        returns="tf2_ros.static_transform_broadcaster.StaticTransformBroadcaster",
    ),
    _row(
        "tf2_ros.transform_listener.TransformListener",
        "buffer node * spin_thread qos static_qos tf_topic tf_static_topic static_only",
        effect="transform_listener",
        node="node",
        watched=True,
        returns="tf2_ros.transform_listener.TransformListener",
    ),
    _row(
        "tf2_ros.static_transform_listener.StaticTransformListener",
        "buffer node * spin_thread static_qos tf_static_topic",
        effect="transform_listener",
        kind="static",
        node="node",
        returns="tf2_ros.static_transform_listener.StaticTransformListener",
    ),
    _row("tf2_ros.buffer.Buffer", "cache_time node", effect="transform_buffer", node="node"),
    _row(
        "tf2_ros.buffer_client.BufferClient",
        "node ns check_frequency timeout_padding",
        effect="endpoint",
        kind=model.ACTION_CLIENT,
        node="node",
        name="ns",
        fixed_type="tf2_msgs/action/LookupTransform",
        default_qos="services_default",
        returns="tf2_ros.buffer_client.BufferClient",
    ),
    _row(
        "rclpy.parameter_client.AsyncParameterClient",
        "node remote_node_name qos_profile callback_group",
        effect="parameter_client",
        node="node",
        returns="rclpy.parameter_client.AsyncParameterClient",
    ),
    _row("rclpy.parameter_client.AsyncParameterClient.wait_for_services", "timeout_sec", watched=True),
    _row(
        "rclpy.parameter_event_handler.ParameterEventHandler",
        "node qos_profile callback_group event_callbacks qos_overriding_options raw",
        effect="endpoint",
        kind=model.SUBSCRIBER,
        node="node",
        qos="qos_profile",
        default_qos="parameter_events",
        fixed_name="/parameter_events",
        fixed_type="rcl_interfaces/msg/ParameterEvent",
        returns="rclpy.parameter_event_handler.ParameterEventHandler",
    ),
    # ---- callbacks handed over elsewhere
    *(
        _row(
            f"message_filters.{filter_}.registerCallback",
            "callback",
            effect="callbacks",
            callbacks=(("callback", "filter"),),
        )
        for filter_ in ("TimeSynchronizer", "ApproximateTimeSynchronizer", "Subscriber", "Cache")
    ),
    *(
        _row(
            f"rclpy.node.Node.add_{when}_set_parameters_callback",
            "callback",
            effect="callbacks",
            callbacks=(("callback", "parameter"),),
        )
        for when in ("on", "post", "pre")
    ),
    _row(
        "rclpy.task.Future.add_done_callback",
        "callback",
        effect="callbacks",
        callbacks=(("callback", "done"),),
        watched=True,
    ),
    _row(
        "threading.Thread",
        "group target name args kwargs * daemon",
        effect="thread",
        callbacks=(("target", "thread"),),
    ),
    _row("threading.Timer", "interval function args kwargs", effect="thread", callbacks=(("function", "thread"),)),
    # ---- clients
    _row("rclpy.client.Client.call", "request timeout_sec", effect="wait_answer", watched=True),
    _row("rclpy.client.Client.call_async", "request", effect="call_async", watched=True),
    _row("rclpy.client.Client.wait_for_service", "timeout_sec", watched=True),
    _row("rclpy.client.Client.service_is_ready", "", watched=True),
    _row("rclpy.action.client.ActionClient.wait_for_server", "timeout_sec", watched=True),
    _row("rclpy.action.client.ActionClient.server_is_ready", "", watched=True),
    _row(
        "rclpy.action.client.ActionClient.send_goal",
        "goal feedback_callback goal_uuid",
        effect="wait_answer",
        callbacks=(("feedback_callback", "feedback"),),
        watched=True,
    ),
    _row(
        "rclpy.action.client.ActionClient.send_goal_async",
        "goal feedback_callback goal_uuid",
        effect="call_async",
        callbacks=(("feedback_callback", "feedback"),),
        watched=True,
    ),
    _row("rclpy.action.client.ClientGoalHandle.get_result", "", effect="wait_answer", watched=True),
    _row("rclpy.action.client.ClientGoalHandle.get_result_async", "", effect="call_async", watched=True),
    _row("rclpy.action.client.ClientGoalHandle.cancel_goal", "", effect="wait_answer", watched=True),
    _row("rclpy.action.client.ClientGoalHandle.cancel_goal_async", "", effect="call_async", watched=True),
    _row("rclpy.action.server.ServerGoalHandle.publish_feedback", "feedback", watched=True),
    _row("rclpy.action.server.ServerGoalHandle.succeed", "response", watched=True),
    _row("rclpy.action.server.ServerGoalHandle.abort", "response", watched=True),
    _row("rclpy.action.server.ServerGoalHandle.canceled", "response", watched=True),
    _row("rclpy.task.Future.result", "", effect="future_result", watched=True),
    _row("rclpy.task.Future.done", "", watched=True),
    _row("rclpy.task.Future.set_result", "result", watched=True),
    _row("rclpy.task.Future.set_exception", "exception", watched=True),
    _row("rclpy.task.Future.cancel", "", watched=True),
    _row("rclpy.publisher.Publisher.publish", "msg", watched=True),
    # ---- spinning
    _row("rclpy.spin", "node executor", effect="spin", watched=True),
    _row("rclpy.spin_once", "node * executor timeout_sec", effect="spin", watched=True),
    _row(
        "rclpy.spin_until_future_complete",
        "node future executor timeout_sec",
        effect="spin",
        watched=True,
    ),
    _row("rclpy.executors.SingleThreadedExecutor", "* context", effect="executor", kind="single_threaded"),
    _row("rclpy.executors.MultiThreadedExecutor", "num_threads * context", effect="executor", kind="multi_threaded"),
    _row("rclpy.experimental.events_executor.EventsExecutor", "* context", effect="executor", kind="events"),
    _row("rclpy.executors.Executor", "* context", effect="executor", kind="unknown"),
    _row("rclpy.executors.Executor.add_node", "node", effect="add_node"),
    _row("rclpy.executors.Executor.spin", "", effect="executor_spin", watched=True),
    _row("rclpy.executors.Executor.spin_once", "timeout_sec", effect="executor_spin", watched=True),
    _row(
        "rclpy.executors.Executor.spin_until_future_complete",
        "future timeout_sec",
        effect="executor_spin",
        watched=True,
    ),
    _row(
        "rclpy.executors.Executor.spin_once_until_future_complete",
        "future timeout_sec",
        effect="executor_spin",
        watched=True,
    ),
    _row(
        "rclpy.executors.Executor.create_task",
        "callback",
        effect="callbacks",
        callbacks=(("callback", "task"),),
    ),
    # ---- waiting and sleeping
    _row(
        "rclpy.wait_for_message.wait_for_message",
        "msg_type node topic * qos_profile time_to_wait",
        effect="endpoint",
        kind=model.SUBSCRIBER,
        node="node",
        type="msg_type",
        name="topic",
        qos="qos_profile",
        default_qos="1",
        watched=True,
    ),
    _row("time.sleep", "seconds", watched=True),
    _row("rclpy.timer.Rate.sleep", "", watched=True),
    _row("rclpy.node.Node.wait_for_node", "fully_qualified_node_name timeout", watched=True),
    _row(
        "tf2_ros.buffer.Buffer.lookup_transform",
        "target_frame source_frame time timeout",
        watched=True,
    ),
    _row(
        "tf2_ros.buffer.Buffer.can_transform",
        "target_frame source_frame time timeout return_debug_tuple",
        watched=True,
    ),
    _row("threading.Event.wait", "timeout", watched=True),
    _row("threading.Event.set", "", watched=True),
    _row("builtins.input", "prompt", watched=True),
    *(
        _row(path, signature, kind=OUTSIDE, watched=True)
        for path, signature in (
            ("urllib.request.urlopen", "url data timeout"),
            ("urllib.request.urlretrieve", "url filename"),
            ("requests.get", "url params"),
            ("requests.post", "url data json"),
            ("requests.put", "url data"),
            ("requests.patch", "url data"),
            ("requests.delete", "url"),
            ("requests.head", "url"),
            ("requests.request", "method url"),
            ("requests.Session.get", "url"),
            ("requests.Session.post", "url data json"),
            ("subprocess.run", "args"),
            ("subprocess.call", "args"),
            ("subprocess.check_call", "args"),
            ("subprocess.check_output", "args"),
            ("subprocess.getoutput", "cmd"),
            ("subprocess.getstatusoutput", "cmd"),
            ("subprocess.Popen.wait", "timeout"),
            ("subprocess.Popen.communicate", "input timeout"),
            ("os.system", "command"),
            ("socket.create_connection", "address timeout"),
            ("fcntl.flock", "fd operation"),
            ("fcntl.lockf", "fd cmd"),
        )
    ),
    # ---- parameters
    _row(
        "rclpy.node.Node.declare_parameter",
        "name value descriptor ignore_override",
        effect="declare_parameter",
    ),
    _row(
        "rclpy.node.Node.declare_parameters",
        "namespace parameters ignore_override",
        effect="declare_parameters",
    ),
    _row("rclpy.node.Node.get_parameter", "name", strict=True, effect="get_parameter", watched=True),
    _row("rclpy.node.Node.get_parameters", "names", effect="get_parameters", watched=True),
    _row("rclpy.node.Node.get_parameter_or", "name alternative_value", effect="get_parameter_or", watched=True),
    _row("rclpy.node.Node.get_parameters_by_prefix", "prefix", effect="get_parameters_by_prefix"),
    _row("rclpy.node.Node.has_parameter", "name", strict=True, effect="has_parameter", watched=True),
    _row("rclpy.node.Node.undeclare_parameter", "name", strict=True, watched=True),
    _row("rclpy.node.Node.set_parameters", "parameter_list", effect="set_parameters", watched=True),
    _row("rclpy.node.Node.set_parameters_atomically", "parameter_list", effect="set_parameters", watched=True),
    _row("rclpy.parameter.Parameter", "name type_ value", effect="parameter"),
    # ---- names of nodes
    _row("rclpy.node.Node.get_name", "", strict=True, effect="get_name"),
    _row("rclpy.node.Node.get_namespace", "", strict=True, effect="get_namespace"),
    _row("rclpy.node.Node.get_fully_qualified_name", "", strict=True, effect="get_fully_qualified_name"),
    _row("rclpy.node.Node.resolve_topic_name", "topic * only_expand", effect="resolve_name"),
    _row("rclpy.node.Node.resolve_service_name", "service * only_expand", effect="resolve_name"),
    # ---- destroying
    _row("rclpy.node.Node.destroy_node", "", effect="destroy_node"),
    _row("rclpy.node.Node.destroy_publisher", "entity", effect="destroy", watched=True),
    _row("rclpy.node.Node.destroy_subscription", "entity", effect="destroy", watched=True),
    _row("rclpy.node.Node.destroy_client", "entity", effect="destroy", watched=True),
    _row("rclpy.node.Node.destroy_service", "entity", effect="destroy", watched=True),
    _row("rclpy.node.Node.destroy_timer", "entity", effect="destroy", watched=True),
    _row("rclpy.timer.Timer.cancel", "", watched=True),
    *(
        _row(f"rclpy.{cls}.destroy", "", watched=True)
        for cls in (
            "timer.Timer",
            "client.Client",
            "publisher.Publisher",
            "subscription.Subscription",
            "service.Service",
            "action.client.ActionClient",
        )
    ),
    # ---- quality of service
    _row(
        "rclpy.qos.QoSProfile",
        "history depth reliability durability lifespan deadline liveliness liveliness_lease_duration "
        "avoid_ros_namespace_conventions",
        effect="qos_profile",
    ),
    _row("rclpy.qos.QoSPresetProfiles.get_from_short_key", "name", effect="qos_preset"),
    _row("rclpy.duration.Duration", "* seconds nanoseconds", effect="duration"),
    # ---- interfaces by name
    _row("rosidl_runtime_py.utilities.get_message", "identifier", effect="get_interface", kind="msg"),
    _row("rosidl_runtime_py.utilities.get_service", "identifier", effect="get_interface", kind="srv"),
    _row("rosidl_runtime_py.utilities.get_action", "identifier", effect="get_interface", kind="action"),
    _row("rosidl_runtime_py.utilities.get_interface", "identifier", effect="get_interface", kind="any"),
    _row("rosidl_runtime_py.get_interface", "identifier", effect="get_interface", kind="any"),
    # ---- Python's own that matter for names
    _row("importlib.import_module", "name package", effect="import_module"),
    _row("functools.partial", "function", effect="partial"),
    _row("os.path.join", "path", effect="path_join"),
    _row("os.path.exists", "path", effect="asks_for_file"),
    _row("os.path.isfile", "path", effect="asks_for_file"),
    _row("os.getenv", "key default", effect="environment"),
    _row("os.environ.get", "key default", effect="environment"),
    _row("argparse.ArgumentParser", "prog", effect="argument_parser"),
]

TABLE: dict[str, Api] = {row.path: row for row in ROWS}

NODE_ROWS: dict[str, Api] = {
    name: row
    for row in ROWS
    for cls, _, name in [row.path.rpartition(".")]
    if cls in ("rclpy.node.Node", "rclpy.lifecycle.node.LifecycleNode") and name != "__init__"
}
"""The methods of a node, by name."""

EXECUTORS = (
    "rclpy.executors.SingleThreadedExecutor",
    "rclpy.executors.MultiThreadedExecutor",
    "rclpy.experimental.events_executor.EventsExecutor",
    "rclpy.experimental.EventsExecutor",
)


def find(path: str) -> Api | None:
    """The row of a call by its canonical name; executors share the rows of their base class."""
    row = TABLE.get(path)
    if row is not None:
        return row
    cls, _, name = path.rpartition(".")
    if cls in EXECUTORS:
        return TABLE.get(f"rclpy.executors.Executor.{name}")
    if cls in ("threading.Condition", "multiprocessing.Event", "multiprocessing.synchronize.Event"):
        return TABLE.get(f"threading.Event.{name}")
    if cls.startswith("rclpy.lifecycle.") and not name.startswith("__"):
        return TABLE.get(f"rclpy.node.Node.{name}")
    return None
