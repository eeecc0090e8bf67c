"""What a row of the API tables says of one call."""

from __future__ import annotations

from functools import cached_property
from typing import Literal

from archlint.model import EntityKind, ExecutorKind, Role
from archlint.records import dataclass

EffectName = Literal[
    "none",
    # nodes and what is created on them
    "initialise",
    "create_node",
    "node_init",
    "destroy_node",
    "endpoint",
    "timer",
    "rate",
    "transform_listener",
    "static_transform_listener",
    "transform_buffer",
    "parameter_client",
    "destroy",
    # callbacks, answers and executors
    "callbacks",
    "thread",
    "submit",
    "submit_each",
    "wait_answer",
    "call_async",
    "future_result",
    "spin",
    "executor",
    "executor_spin",
    "add_node",
    "remove_node",
    # parameters and names
    "declare_parameter",
    "declare_parameters",
    "get_parameter",
    "get_parameters",
    "get_parameter_or",
    "get_parameters_by_prefix",
    "has_parameter",
    "set_parameters",
    "parameter",
    "get_name",
    "get_namespace",
    "get_fully_qualified_name",
    "resolve_name",
    # what create calls are given
    "qos_profile",
    "qos_preset",
    "duration",
    "get_interface",
    # Python's own
    "import_module",
    "partial",
    "path_join",
    "asks_for_file",
    "environment",
    "argument_parser",
    # launch's, whose tables and effects are its own
    "launch_object",
    "launch_description",
    "package_share",
    "package_prefix",
    "search_paths",
]
"""What the run does with a call: each is a function, which :mod:`archlint.libraries.offers` puts together."""

DefaultQos = Literal[
    "", "services_default", "default", "1", "parameter_events", "tf", "tf_static", "tf_static_listener"
]
"""The profile of a call that is given none; empty where it must be given one."""


@dataclass(frozen=True)
class Api:
    """One callable.  ``effect`` names what the run does with a call; the other fields say which parameter
    plays which part for that effect."""

    path: str
    """Where it is defined: ``rclpy.node.Node.create_timer``."""
    signature: str = ""
    """Its parameters in any distribution, separated by spaces; ``*`` starts those that go by keyword alone."""
    effect: EffectName = "none"
    kind: EntityKind | None = None
    """What it creates."""
    makes: str = ""
    """The class of launch that it makes, or the kind of the interfaces that it gives where a name says none."""
    lifecycle: bool = False
    """True of what makes a lifecycle node."""
    executor: ExecutorKind | None = None
    """The executor that it makes."""
    node: str | None = None
    """Parameter that is the node; None: the object the method is called on."""
    type: str | None = None
    type_as_text: bool = False
    """True where the type is given as a text, ``'std_msgs/msg/String'``, and not as a class."""
    name: str | None = None
    qos: str | None = None
    group: str | None = None
    callbacks: tuple[tuple[str, Role], ...] = ()
    """``(parameter, role)``."""
    default_qos: DefaultQos = ""
    fixed_name: str | None = None
    fixed_type: str | None = None
    returns: str | None = None
    """Canonical class of what the call returns."""
    watched: bool = False
    """True where checks want to see each call."""
    waits_for_io: bool = False
    """True of what waits for the network, a process or a file: nothing of ROS."""

    @property
    def creates(self) -> bool:
        """Whether a call makes an endpoint or a timer."""
        return self.effect in ("endpoint", "timer")

    @cached_property
    def params(self) -> tuple[str, ...]:
        return tuple(self.signature.split())

    @cached_property
    def positional(self) -> tuple[str, ...]:
        return self.params[: self.params.index("*")] if "*" in self.params else self.params


__all__ = ["Api", "DefaultQos", "EffectName"]
