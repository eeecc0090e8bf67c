"""Stand-in for rclpy.node: a Node that records what it is asked to create."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from contextlib import suppress
from typing import Any

import yaml
from benchmarks.accuracy.oracle.interfaces import InterfaceType, interface, ros_type_of
from benchmarks.accuracy.oracle.names import NameError_, Remapping, UnknownSubstitution, expand, node_identity
from benchmarks.accuracy.oracle.record import recorder
from benchmarks.accuracy.oracle.sandbox import waited
from benchmarks.accuracy.oracle.unknown import Unknown, UnknownType, make

from . import qos as _qos
from .callback_groups import MutuallyExclusiveCallbackGroup
from .clock import ROSClock
from .context import get_default_context
from .entities import Client, GuardCondition, Publisher, Rate, Service, Subscription, Timer
from .exceptions import (
    InvalidNamespaceException,
    InvalidNodeNameException,
    InvalidServiceNameException,
    InvalidTopicNameException,
    RCLError,
    RCLInvalidROSArgsError,
)
from .logging import get_logger
from .parameter import Parameter
from .parameters import ParameterStore
from .qos import QoSProfile, qos_profile_parameter_events, qos_profile_services_default

HIDDEN_NODE_PREFIX = "_"


class Node(ParameterStore):
    """A node; entities that rclpy makes for every node are not recorded."""

    PARAM_REL_TOL = 1e-6
    _lifecycle = False

    def __init__(
        self,
        node_name: str,
        *,
        context: Any = None,
        cli_args: Any = None,
        namespace: Any = None,
        use_global_arguments: bool = True,
        enable_rosout: Any = True,
        rosout_qos_profile: Any = None,
        start_parameter_services: bool = True,
        parameter_overrides: Any = None,
        allow_undeclared_parameters: bool = False,
        automatically_declare_parameters_from_overrides: bool = False,
        enable_logger_service: bool = False,
    ) -> None:
        name, space = _as_text(node_name), _as_text(namespace) if namespace else ""
        if name is None:
            raise RCLError("node name argument is null")
        try:
            remapping = self._oracle_remapping = Remapping(cli_args)
        except NameError_ as error:
            raise RCLInvalidROSArgsError(str(error)) from None
        try:
            name, space = node_identity(name, space)
            name = remapping.special("__node", name) or name
            self._oracle_name, self._oracle_namespace = node_identity(name, remapping.special("__ns", name) or space)
        except NameError_ as error:
            kind = InvalidNodeNameException if "node name" in error.reason else InvalidNamespaceException
            raise kind(str(error)) from None
        self._oracle_entities: dict[str, list[Any]] = {}
        self._oracle_context = context or get_default_context()
        self._oracle_group = MutuallyExclusiveCallbackGroup()
        self._oracle_clock = ROSClock()
        self._clock, self._logger = self._oracle_clock, get_logger(name)  # some nodes look at these
        self.executor: Any = None
        recorder.node(self, lifecycle=self._lifecycle)
        given = [Parameter(key, value=yaml.safe_load(value)) for key, value in remapping.parameters]
        self._start_parameters(
            [*given, *(parameter_overrides or ())],
            allow_undeclared_parameters,
            automatically_declare_parameters_from_overrides,
        )

    # What it is ----------------------------------------------------------------------------------
    def get_name(self) -> str:
        """The name without the namespace."""
        return self._oracle_name

    def get_namespace(self) -> str:
        """The namespace."""
        return self._oracle_namespace

    def get_fully_qualified_name(self) -> str:
        """Namespace and name."""
        return f"{self._oracle_namespace.rstrip('/')}/{self._oracle_name}"

    def get_logger(self) -> Any:
        """A silent logger."""
        return get_logger(self._oracle_name)

    def get_clock(self) -> ROSClock:
        """The node's clock."""
        return self._oracle_clock

    @property
    def context(self) -> Any:
        """The context."""
        return self._oracle_context

    @property
    def default_callback_group(self) -> Any:
        """The node's one mutually exclusive group."""
        return self._oracle_group

    @property
    def handle(self) -> Any:
        """Unknown."""
        return Unknown("node.handle")

    # What it creates -----------------------------------------------------------------------------
    def create_publisher(
        self,
        msg_type: Any,
        topic: Any,
        qos_profile: Any,
        *,
        callback_group: Any = None,
        event_callbacks: Any = None,
        qos_overriding_options: Any = None,
        publisher_class: Any = Publisher,
    ) -> Any:
        """Record a publisher."""
        name = self._oracle_record("publisher", msg_type, topic, qos_profile)
        made = Publisher(msg_type=msg_type, topic=topic, topic_name=name, qos_profile=qos_profile)
        return self._oracle_keep("publishers", made)

    def create_subscription(
        self,
        msg_type: Any,
        topic: Any,
        callback: Any,
        qos_profile: Any,
        *,
        callback_group: Any = None,
        event_callbacks: Any = None,
        qos_overriding_options: Any = None,
        raw: bool = False,
        content_filter_options: Any = None,
        acceptable_buffer_backends: Any = None,
    ) -> Any:
        """Record a subscription."""
        name = self._oracle_record("subscriber", msg_type, topic, qos_profile, callback)
        made = Subscription(msg_type=msg_type, topic=topic, topic_name=name, callback=callback, qos_profile=qos_profile)
        return self._oracle_keep("subscriptions", made)

    def create_client(
        self,
        srv_type: Any,
        srv_name: Any,
        *,
        qos_profile: Any = qos_profile_services_default,
        callback_group: Any = None,
    ) -> Any:
        """Record a service client."""
        name = self._oracle_record("client", srv_type, srv_name, qos_profile)
        return self._oracle_keep("clients", Client(srv_type=srv_type, srv_name=srv_name, service_name=name))

    def create_service(
        self,
        srv_type: Any,
        srv_name: Any,
        callback: Any,
        *,
        qos_profile: Any = qos_profile_services_default,
        callback_group: Any = None,
    ) -> Any:
        """Record a service."""
        name = self._oracle_record("service", srv_type, srv_name, qos_profile, callback)
        made = Service(srv_type=srv_type, srv_name=srv_name, service_name=name, callback=callback)
        return self._oracle_keep("services", made)

    def create_timer(
        self,
        timer_period_sec: Any,
        callback: Any,
        callback_group: Any = None,
        clock: Any = None,
        autostart: bool = True,
    ) -> Any:
        """Record a timer."""
        period = None if isinstance(timer_period_sec, Unknown) else int(float(timer_period_sec) * 1e9) / 1e9
        if period is not None and period < 0:
            raise RCLError("failed to create timer: timer period must be non-negative")
        recorder.entity("timer", self, callback=callback, period=period)
        made = Timer(callback=callback, timer_period_ns=int((period or 0) * 1e9), clock=clock or self._oracle_clock)
        return self._oracle_keep("timers", made)

    def create_rate(self, frequency: Any, clock: Any = None) -> Rate:
        """A rate that does not wait."""
        if not isinstance(frequency, Unknown) and frequency <= 0:
            raise ValueError("frequency must be > 0")
        return Rate()

    def create_guard_condition(self, callback: Any, callback_group: Any = None) -> GuardCondition:
        """A guard condition."""
        return GuardCondition(callback=callback)

    def _oracle_record(self, kind: str, type_: Any, written: Any, profile: Any, callback: Any = None) -> str:
        if kind == "subscriber":
            _check_callback(callback)
        form = _qos.normal_form(profile, of_service=kind in ("service", "client"))
        return record(self, kind, type_, written, form, callback)

    def _oracle_keep(self, what: str, entity: Any) -> Any:
        self._oracle_entities.setdefault(what, []).append(entity)
        return entity

    # What it holds -------------------------------------------------------------------------------
    @property
    def publishers(self) -> Any:
        """The publishers."""
        return iter(self._oracle_entities.get("publishers", []))

    @property
    def subscriptions(self) -> Any:
        """The subscriptions."""
        return iter(self._oracle_entities.get("subscriptions", []))

    @property
    def clients(self) -> Any:
        """The clients."""
        return iter(self._oracle_entities.get("clients", []))

    @property
    def services(self) -> Any:
        """The services."""
        return iter(self._oracle_entities.get("services", []))

    @property
    def timers(self) -> Any:
        """The timers."""
        return iter(self._oracle_entities.get("timers", []))

    @property
    def guards(self) -> Any:
        """The guard conditions."""
        return iter(())

    @property
    def waitables(self) -> Any:
        """The waitables."""
        return iter(())

    def _oracle_callbacks(self) -> list[tuple[Callable[..., Any], tuple[Any, ...]]]:
        """Each callback of this node with arguments that fit it."""
        calls: list[tuple[Callable[..., Any], tuple[Any, ...]]] = []
        for entity in self._oracle_entities.get("subscriptions", []):
            calls.append((entity.callback, (_instance(entity.msg_type),)))
        for entity in self._oracle_entities.get("timers", []):
            calls.append((entity.callback, ()))
        for entity in self._oracle_entities.get("services", []):
            request, response = (
                getattr(entity.srv_type, "Request", None),
                getattr(entity.srv_type, "Response", None),
            )
            calls.append((entity.callback, (_instance(request), _instance(response))))
        return [(callback, arguments) for callback, arguments in calls if callback is not None]

    def add_waitable(self, waitable: object) -> None:
        """Nothing waits."""

    def remove_waitable(self, waitable: object) -> None:
        """Nothing waits."""

    def _destroy(self, *_: object) -> bool:
        return True

    destroy_publisher = destroy_subscription = destroy_client = destroy_service = destroy_timer = _destroy
    destroy_rate = destroy_guard_condition = _destroy

    def destroy_node(self) -> None:
        """It was there."""

    def __enter__(self) -> Any:
        return self

    def __exit__(self, *exc: object) -> None:
        return None

    # What it sees of the others ------------------------------------------------------------------
    def _nothing(self, *_: object, **__: object) -> list[Any]:
        waited(2)
        return []

    get_topic_names_and_types = get_service_names_and_types = get_node_names = _nothing
    get_node_names_and_namespaces = get_node_names_and_namespaces_with_enclaves = _nothing
    get_publisher_names_and_types_by_node = get_subscriber_names_and_types_by_node = _nothing
    get_service_names_and_types_by_node = get_client_names_and_types_by_node = _nothing
    get_publishers_info_by_topic = get_subscriptions_info_by_topic = _nothing
    get_clients_info_by_service = get_servers_info_by_service = _nothing

    def _one(self, *_: object, **__: object) -> int:
        waited(2)
        return 1

    count_publishers = count_subscribers = count_clients = count_services = _one

    def wait_for_node(self, *_: object, **__: object) -> bool:
        """It is there."""
        return True

    def resolve_topic_name(self, topic: str, *, only_expand: bool = False) -> str:
        """The fully qualified name of a topic."""
        return expand(topic, *self._oracle_identity()) if only_expand else qualified(self, "publisher", topic)

    def resolve_service_name(self, service: str, *, only_expand: bool = False) -> str:
        """The fully qualified name of a service."""
        return expand(service, *self._oracle_identity()) if only_expand else qualified(self, "service", service)

    def _oracle_identity(self) -> tuple[str, str]:
        return self.get_name(), self.get_namespace()

    def assert_liveliness(self) -> None:
        """Alive."""


BaseNode = Node


def record(
    node: Node, kind: str, type_: Any, written: Any, profile: dict[str, object] | None, callback: Any = None
) -> str:
    """Note one named entity of a node, and give its fully qualified name."""
    if not isinstance(type_, (Unknown, InterfaceType, UnknownType)):
        raise AttributeError(f"{type_!r} has no attribute '_TYPE_SUPPORT'")
    _check_kind(kind, ros_type_of(type_))
    if written is None:
        by_kind = {"publisher": RCLError, "subscriber": RCLError, "service": TypeError, "client": TypeError}
        raise by_kind.get(kind, ValueError)("topic_name argument is null")
    name = qualified(node, kind, _as_text(written))
    recorder.entity(
        kind,
        node,
        written=_as_text(written),
        name=name,
        type_=ros_type_of(type_),
        qos=profile,
        callback=callback,
    )
    return name


def _check_callback(callback: Any) -> None:
    """rclpy calls back with the message, or with the message and what came with it."""
    for count in (1, 2):
        with suppress(TypeError):
            inspect.signature(callback).bind(*[None] * count)
            return
    raise RuntimeError("callback should be either be callable with one argument or two")


def _check_kind(kind: str, ros_type: str | None) -> None:
    expected = {"publisher": "msg", "subscriber": "msg", "service": "srv", "client": "srv"}.get(kind, "action")
    if ros_type and f"/{expected}/" not in ros_type and "/action/" not in ros_type:
        raise RuntimeError(f"expected a type of kind {expected}, got {ros_type}")


def qualified(node: Any, kind: str, written: str) -> str:
    """The fully qualified name; the exceptions are rclpy's."""
    try:
        name, namespace = node.get_name(), node.get_namespace()
        full = expand(written, name, namespace)
        return full if kind.startswith("action") else node._oracle_remapping.apply(kind, full, name, namespace)
    except NameError_ as error:
        recorder.refusal(kind, written, error.reason)
        wrong: type[Exception] = ValueError
        if not kind.startswith("action") and not isinstance(error, UnknownSubstitution):
            wrong = InvalidServiceNameException if kind in ("service", "client") else InvalidTopicNameException
        raise wrong(str(error)) from None


def _as_text(value: Any) -> Any:
    return str(value) if isinstance(value, Unknown) else value


def _instance(cls: Any) -> Any:
    try:
        return cls()
    except Exception:
        return make("message")


__all__ = [
    "HIDDEN_NODE_PREFIX",
    "BaseNode",
    "Node",
    "QoSProfile",
    "interface",
    "qos_profile_parameter_events",
]
