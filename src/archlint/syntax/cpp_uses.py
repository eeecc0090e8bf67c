"""What C++ code asks of values whose types it writes, and what it gives rclcpp: for what a compiler would say of it."""

from __future__ import annotations

from typing import Literal

from archlint.syntax.expressions import Base, Span

Holder = Literal["", "shared", "unique", "raw", "list", "future"]
"""What stands around a value: nothing, a pointer, a container of such values, or a future of a pointer."""

Role = Literal["", "format", "value"]

ITEM = "[]"
"""The member that stands for an item of a container."""
CALLED = "()"
"""How the name of a member ends that is called."""


class MemberUse(Base, frozen=True):
    """Members that are asked for one after the other, ``msg->pose.x``: each with its operator, as ``->pose``.

    ``type`` is that of the variable, ``["nav_msgs", "msg", "Odometry"]``, a service's with ``"Request"`` behind it; of
    a field whose class another file defines it is empty, and ``owner`` and ``field`` are the class and the field.
    ``role`` says that the value is a format, or fills one in.
    """

    type: list[str]
    holder: Holder
    members: list[tuple[str, Span]]
    owner: str = ""
    field: str = ""
    role: Role = ""


class TypedField(Base, frozen=True):
    """A field of a class whose type is an interface."""

    owner: str
    name: str
    type: list[str]
    holder: Holder


RefusalOfCpp = Literal[
    "format",
    "no logger",
    "no clock",
    "clock pointer",
    "no pointer to node",
    "unique pointer",
    "lifecycle node",
    "no qos",
    "no callback",
    "callback for qos",
    "period",
    "parameter",
    "no method",
    "bound arguments",
    "callback arguments",
    "callback type",
    "published type",
    "created type",
    "dot",
    "value",
    "pointer name",
    "no node",
    "literal",
    "placeholder",
]


class RefusedUse(Base, frozen=True):
    """What rclcpp or the compiler refuses at a place; ``name`` and ``other`` are the words that a message needs."""

    kind: RefusalOfCpp
    span: Span
    name: str = ""
    other: str = ""


__all__ = ["CALLED", "ITEM", "Holder", "MemberUse", "RefusalOfCpp", "RefusedUse", "Role", "TypedField"]
