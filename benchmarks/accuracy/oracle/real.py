"""The real rclpy in the place of its stand-in, under the same recorder.

Nodes, publishers, parameters and so on are made by rclpy, rcl and the middleware: names, types, QoS, values and
refusals are theirs. What would wait, be sent or end the run is not done, as in the stand-in, so that the same lines
run. Only what rclpy cannot be given is replaced: an unknown value, or an interface that is not installed.
"""

from __future__ import annotations

import importlib
import inspect
import sys
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Any

from . import unknown
from .interfaces import InterfaceType
from .later import finished, nobody, received
from .names import NameError_, expand
from .record import recorder
from .sandbox import still_up, waited
from .unknown import Unknown, UnknownType, is_tainted, is_uncertain, mask

WITHOUT_WHEEL = (
    "message_filters", "tf2_py", "tf2_ros", "rosidl_runtime_py", "resource_retriever", "nav2_simple_commander",
    "ament_index_python",
)  # fmt: skip
"""Libraries whose stand-ins are used beside the real rclpy; ament_index_python to find the repository's own files."""

SUBSTITUTES = {
    "msg": ("std_msgs.msg", "Empty"),
    "srv": ("std_srvs.srv", "Empty"),
    "action": ("test_msgs.action", "Fibonacci"),
}
"""What rclpy gets for an interface that is not installed, or not known; the type is not recorded then."""

lenient = False
"""Whether a node without an initialised context gets one: it is constructed by the run, not by a program."""

_OWN = ("node.py", "time_source.py", "parameter_service.py", "type_description_service.py", "logging_service.py")
_INTERFACE_KINDS = {"publisher": "msg", "subscriber": "msg", "service": "srv", "client": "srv"}
_NAMES = {"publisher": "topic_name", "subscriber": "topic_name", "service": "service_name", "client": "service_name"}


def install() -> None:
    """Import rclpy, and wrap what is recorded and what would wait; once for a process."""
    for name in ("rclpy", "rclpy.action", "rclpy.lifecycle", "rclpy.executors", "rclpy.wait_for_message"):
        importlib.import_module(name)
    for name in ("std_msgs.msg", "std_srvs.srv", "test_msgs.action", "geometry_msgs.msg", "sensor_msgs.msg"):
        importlib.import_module(name)  # types that most programs use: imported once for all of them
    _wrap_nodes()
    _wrap_parameters()
    _wrap_creations()
    _wrap_actions()
    _do_not_wait()
    _do_not_send()
    _do_not_end()


def _module(name: str) -> Any:
    return sys.modules[name]


def _node() -> Any:
    return _module("rclpy.node").Node


# Nodes -------------------------------------------------------------------------------------------
def _wrap_nodes() -> None:
    node, mixin = _node(), _module("rclpy.lifecycle").LifecycleNodeMixin
    original, signature = node.__init__, inspect.signature(node.__init__)

    def init(self: Any, *arguments: Any, **keywords: Any) -> None:
        given = signature.bind(self, *arguments, **keywords).arguments
        if lenient and given.get("context") is None and not _module("rclpy").utilities.get_default_context().ok():
            _module("rclpy").init()
        written = {name: _as_text(given[name]) for name in ("node_name", "namespace") if given.get(name) is not None}
        given.update({name: mask(text) if is_tainted(text) else text for name, text in written.items()})
        original(**given)
        self._oracle_written = {name: text for name, text in written.items() if is_tainted(text)}
        self._oracle_callbacks_of_run = []
        recorder.node(self, lifecycle=isinstance(self, mixin))

    node.__init__ = init
    for method, argument in (("get_name", "node_name"), ("get_namespace", "namespace")):
        setattr(node, method, _telling(getattr(node, method), argument))
    node.get_fully_qualified_name = lambda self: f"{self.get_namespace().rstrip('/')}/{self.get_name()}"
    node._oracle_callbacks = lambda self: self._oracle_callbacks_of_run
    mixin._oracle_transitions = lambda self: [self.on_configure, self.on_activate]


def _telling(original: Callable[[Any], str], argument: str) -> Callable[[Any], str]:
    """A node's name or namespace, unknown where it was made with something unknown."""

    def get(self: Any) -> str:
        plain: str = original(self)
        text = vars(self).get("_oracle_written", {}).get(argument)
        if text is None or mask(text).lstrip("/") != plain.lstrip("/"):
            return plain
        return text if text.startswith("/") or argument == "node_name" else f"/{text}"

    return get


def _as_text(value: Any) -> Any:
    return str(value) if isinstance(value, Unknown) else value


# Parameters --------------------------------------------------------------------------------------
def _wrap_parameters() -> None:
    node, parameter = _node(), _module("rclpy.parameter").Parameter
    original, as_message = node.declare_parameters, parameter.get_parameter_value
    descriptor = _module("rcl_interfaces.msg").ParameterDescriptor

    def declare(self: Any, namespace: str, parameters: Any, ignore_override: bool = False) -> list[Any]:
        known, unknown_values = [], {}
        for index, (name, *rest) in enumerate(parameters):
            if rest and isinstance(rest[0], Unknown):
                unknown_values[index] = rest[0]
                rest = [None, descriptor(dynamic_typing=True)]
            elif rest and isinstance(rest[0], bool) and _is_recorded(self):
                rest[0] ^= unknown.other_way
            known.append((name, *rest))
        declared = original(self, namespace, known, ignore_override)
        for index, value in unknown_values.items():
            declared[index]._value = value
        for each in declared if _is_recorded(self) else ():
            if not (each.type_.value or self._descriptors[each.name].dynamic_typing):
                # Declared with a type alone: somebody has to give the value, and nobody knows which.
                each._type_, each._value = parameter.Type(self._descriptors[each.name].type), Unknown(each.name)
            recorder.parameter(self, each.name, each.type_.name, each.value)
        return declared

    node.declare_parameters = declare
    parameter.get_parameter_value = lambda self: self._value if isinstance(self._value, Unknown) else as_message(self)


def _is_recorded(node: Any) -> bool:
    """Whether what a node is making is the program's, not what rclpy makes for every node, or for itself."""
    if "_oracle_callbacks_of_run" not in vars(node):
        return False
    frame: Any = sys._getframe(2)
    if _file(frame) == "node.py" and frame.f_code.co_name in ("declare_parameter", "create_lifecycle_publisher"):
        return _file(frame.f_back) != "qos_overriding_options.py"
    return _file(frame) not in (*_OWN, "qos_overriding_options.py")


def _file(frame: Any) -> str | None:
    """The name of a frame's file, if it is one of rclpy's."""
    path = Path(frame.f_code.co_filename)
    return path.name if "rclpy" in path.parts[:-1] and not path.is_relative_to(recorder.root) else None


# Endpoints ---------------------------------------------------------------------------------------
def _wrap_creations() -> None:
    node = _node()
    for kind, method, type_, name in (
        ("publisher", "create_publisher", "msg_type", "topic"),
        ("subscriber", "create_subscription", "msg_type", "topic"),
        ("service", "create_service", "srv_type", "srv_name"),
        ("client", "create_client", "srv_type", "srv_name"),
    ):
        setattr(node, method, _creating(kind, getattr(node, method), type_, name))
    create_timer = node.create_timer
    signature = inspect.signature(create_timer)

    def timer(self: Any, *arguments: Any, **keywords: Any) -> Any:
        given = signature.bind(self, *arguments, **keywords).arguments
        period = given["timer_period_sec"]
        if isinstance(period, Unknown):
            given["timer_period_sec"] = 1.0
        made = create_timer(**given)
        if _is_recorded(self):
            known = None if isinstance(period, Unknown) else made.timer_period_ns / 1e9
            recorder.entity("timer", self, callback=given["callback"], period=known)
            self._oracle_callbacks_of_run.append((given["callback"], ()))
        return made

    node.create_timer = timer


def _creating(kind: str, original: Callable[..., Any], type_name: str, name: str) -> Callable[..., Any]:
    signature = inspect.signature(original)

    def create(self: Any, *arguments: Any, **keywords: Any) -> Any:
        if not _is_recorded(self):
            return original(self, *arguments, **keywords)
        bound = signature.bind(self, *arguments, **keywords)
        bound.apply_defaults()
        given = bound.arguments
        type_, written, profile = given[type_name], _as_text(given[name]), given["qos_profile"]
        given[type_name], ros_type = _installed(type_, _INTERFACE_KINDS[kind])
        given[name] = mask(written) if is_tainted(written) else written
        if isinstance(profile, Unknown):
            given["qos_profile"] = 10 if kind in ("publisher", "subscriber") else _services_default()
        made = _or_refused(kind, written, lambda: original(*bound.args, **bound.kwargs))
        recorder.entity(
            kind,
            self,
            written=written,
            name=_final(self, written, getattr(made, _NAMES[kind])),
            type_=ros_type,
            qos=_policies(made.qos_profile, known=not isinstance(profile, Unknown)),
            callback=given.get("callback"),
        )
        if "callback" in given:
            self._oracle_callbacks_of_run.append((given["callback"], _arguments(kind, type_)))
        return made

    return create


def _services_default() -> Any:
    return _module("rclpy.qos").qos_profile_services_default


def _or_refused(kind: str, written: Any, create: Callable[[], Any]) -> Any:
    exceptions = _module("rclpy.exceptions")
    try:
        return create()
    except (exceptions.InvalidTopicNameException, exceptions.InvalidServiceNameException) as error:
        recorder.refusal(kind, written, str(error).splitlines()[0])
        raise
    except ValueError as error:  # of actions, and of substitutions
        if isinstance(written, str) and "name" in str(error):
            recorder.refusal(kind, written, str(error).splitlines()[0])
        raise


def _final(node: Any, written: Any, real: str) -> str:
    """The name that an endpoint got; where something unknown went into it, the name that says so."""
    if not (is_tainted(written) or vars(node)["_oracle_written"]):
        return real
    try:
        full = expand(written, node.get_name(), node.get_namespace())
    except NameError_:
        return real
    return full if is_uncertain(full) else real


def _installed(type_: Any, kind: str) -> tuple[Any, str | None]:
    """The class that rclpy gets, and the type to record: what was given, unless it is not of an installed package."""
    if not isinstance(type_, (InterfaceType, Unknown, UnknownType)):
        return type_, ros_type_of(type_)
    if isinstance(type_, InterfaceType) and type_.ros_type.count("/") == 2 and f"/{kind}/" in type_.ros_type:
        package, _, name = type_.ros_type.split("/")
        with suppress(ImportError):
            real = getattr(importlib.import_module(f"{package}.{kind}"), name, None)
            if isinstance(real, type) and not isinstance(real, InterfaceType):
                return real, type_.ros_type
    module, name = SUBSTITUTES[kind]
    return getattr(_module(module), name), None


def ros_type_of(class_: Any) -> str | None:
    """The ROS type name of a generated class."""
    words = getattr(class_, "__module__", "").split(".")
    return f"{words[0]}/{words[1]}/{class_.__name__}" if len(words) > 1 else None


def _policies(profile: Any, *, known: bool) -> dict[str, object]:
    values = {
        "history": profile.history.name.lower(),
        "depth": int(profile.depth),
        "reliability": profile.reliability.name.lower(),
        "durability": profile.durability.name.lower(),
    }
    return values if known else dict.fromkeys(values)


def _arguments(kind: str, type_: Any) -> tuple[Any, ...]:
    if kind == "subscriber":
        return (received(type_),)
    request, response = getattr(type_, "Request", None), getattr(type_, "Response", None)
    return (received(request), response() if isinstance(response, type) else Unknown("response"))


# Actions -----------------------------------------------------------------------------------------
def _wrap_actions() -> None:
    action = _module("rclpy.action")
    for kind, class_ in (("action_server", action.ActionServer), ("action_client", action.ActionClient)):
        class_.__init__ = _making(kind, class_.__init__)


def _making(kind: str, original: Callable[..., Any]) -> Callable[..., Any]:
    signature = inspect.signature(original)

    def init(self: Any, *arguments: Any, **keywords: Any) -> None:
        bound = signature.bind(self, *arguments, **keywords)
        bound.apply_defaults()
        given = bound.arguments
        node, type_, written = given["node"], given["action_type"], _as_text(given["action_name"])
        given["action_type"], ros_type = _installed(type_, "action")
        given["action_name"] = mask(written) if is_tainted(written) else written
        before = _actions(kind, node)
        _or_refused(kind, written, lambda: original(*bound.args, **bound.kwargs))
        new = sorted(_actions(kind, node) - before)
        real = new[0] if new else expand(mask(written), mask(node.get_name()), mask(node.get_namespace()))
        execute = given.get("execute_callback")
        recorder.entity(
            kind,
            node,
            written=written,
            name=_final(node, written, real),
            type_=ros_type,
            callback=execute,
        )
        if kind == "action_server":
            _run_goal_later(given, getattr(type_, "Goal", None))

    return init


def _actions(kind: str, node: Any) -> set[str]:
    """The names of a node's actions, as rcl's graph has them."""
    ask = getattr(_module("rclpy.action"), f"get_{kind}_names_and_types_by_node")
    plain = [mask(text) for text in (node.get_name(), node.get_namespace())]
    return {name for name, _ in ask(node, *plain)}


def _run_goal_later(given: dict[str, Any], goal_type: Any) -> None:
    goal = received(goal_type) if isinstance(goal_type, type) else Unknown("goal")
    handle = Unknown("goal_handle")
    handle.request, handle.is_active, handle.is_cancel_requested, handle.status = goal, True, False, 2
    for name, argument in (("goal_callback", goal), ("handle_accepted_callback", handle), ("execute_callback", handle)):
        if given.get(name) is not None:
            recorder.tasks.append((given[name], (argument,)))


# What would wait, be sent or end -----------------------------------------------------------------
def _do_not_wait() -> None:
    rclpy, executors = _module("rclpy"), _module("rclpy.executors")

    def at_once(result: Any = None) -> Callable[..., Any]:
        def return_at_once(*_: object, **__: object) -> Any:
            waited(2)
            return result

        return return_at_once

    for name in ("spin", "spin_once", "spin_until_future_complete"):
        setattr(rclpy, name, at_once())
    spinning = ("spin", "spin_once", "spin_until_future_complete", "spin_once_until_future_complete")
    for class_ in _subclasses(executors.Executor):
        for name in spinning:
            if name in vars(class_):
                setattr(class_, name, at_once())
    executors.Executor.create_task = lambda self, callback, *arguments, **keywords: _task(callback, arguments, keywords)
    _module("rclpy.client").Client.wait_for_service = at_once(True)
    _module("rclpy.action").ActionClient.wait_for_server = at_once(True)
    _module("rclpy.timer").Rate.sleep = at_once()
    _module("rclpy.clock").Clock.sleep_until = _module("rclpy.clock").Clock.sleep_for = at_once(True)
    node = _node()
    node.wait_for_node = at_once(True)
    for name in ("count_publishers", "count_subscribers", "count_clients", "count_services"):
        setattr(node, name, at_once(1))
    _module("rclpy.publisher").Publisher.get_subscription_count = at_once(1)
    _module("rclpy.publisher").Publisher.wait_for_all_acked = at_once(True)
    _module("rclpy.wait_for_message").wait_for_message = _wait_for_message


def _subclasses(class_: type) -> list[type]:
    return [class_, *(each for inner in class_.__subclasses__() for each in _subclasses(inner))]


def _wait_for_message(
    msg_type: Any, node: Any, topic: Any, *, qos_profile: Any = 1, time_to_wait: Any = -1
) -> tuple[bool, Any]:
    node.create_subscription(msg_type, topic, nobody, qos_profile)
    return True, received(msg_type)


def _task(callback: Any, arguments: Any, keywords: Any) -> Any:
    recorder.tasks.append((callback, (arguments, keywords)) if callable(callback) else (lambda: callback, ()))
    return _module("rclpy.task").Future()


def _answered(type_: Any, part: str) -> Any:
    """A part of an interface that came in; unknown where the interface is only a substitute."""
    substitutes = [getattr(_module(module), name) for module, name in SUBSTITUTES.values()]
    return Unknown(part) if type_ in substitutes else received(getattr(type_, part))


def _do_not_send() -> None:
    client, action_client = _module("rclpy.client").Client, _module("rclpy.action").ActionClient
    _module("rclpy.publisher").Publisher.publish = lambda self, msg: None
    _module("rclpy.impl.rcutils_logger").RcutilsLogger.log = lambda *_, **__: True
    client.service_is_ready = action_client.server_is_ready = lambda self: True

    def answer(self: Any) -> Any:
        return _answered(self.srv_type, "Response")

    client.call = lambda self, request, timeout_sec=None: answer(self)
    client.call_async = lambda self, request: finished(answer(self))

    def accepted(self: Any) -> Any:
        handle, response = Unknown("goal_handle"), Unknown("result response")
        response.status, response.result = 4, _answered(self._action_type, "Result")
        handle.accepted, handle.status = True, 4
        handle.get_result, handle.get_result_async = lambda: response, lambda: finished(response)
        handle.cancel_goal_async = lambda: finished(Unknown("cancel response"))
        return handle

    def send_goal_async(self: Any, goal: object, feedback_callback: Any = None, goal_uuid: object = None) -> Any:
        if feedback_callback is not None:
            recorder.tasks.append((feedback_callback, (Unknown("feedback"),)))
        return finished(accepted(self))

    action_client.send_goal_async = send_goal_async
    action_client.send_goal = lambda self, goal, **_: accepted(self).get_result()
    future = _module("rclpy.task").Future
    add_done_callback = future.add_done_callback

    def later_if_done(self: Any, callback: Any) -> None:
        if self.done():
            recorder.tasks.append((callback, (self,)))
        else:
            add_done_callback(self, callback)

    future.add_done_callback = later_if_done


def _do_not_end() -> None:
    """What was shut down or destroyed stays, since callbacks run after the program."""
    rclpy, context = _module("rclpy"), _module("rclpy.context").Context
    ok, init = context.ok, context.init
    ended: list[Any] = []

    def still_ok(self: Any) -> bool:
        real: bool = ok(self)
        return real and (not sys._getframe(1).f_code.co_filename.startswith(recorder.root) or still_up())

    def init_again(self: Any, *arguments: Any, **keywords: Any) -> None:
        if self in ended:
            ended.remove(self)
        else:
            init(self, *arguments, **keywords)

    def end(self: Any) -> None:
        ended.append(self)

    context.ok, context.init = still_ok, init_again
    context.shutdown = context.try_shutdown = end
    rclpy.ok = _module("rclpy.utilities").ok = lambda *, context=None: (
        ok(context or _module("rclpy.utilities").get_default_context()) and still_up()
    )
    _node().destroy_node = lambda self: None
    _module("rclpy.executors").Executor.shutdown = lambda self, *_, **__: True
