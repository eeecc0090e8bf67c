"""What only rclpy makes, as values of a run: nodes, entities, executors, futures, messages."""

from __future__ import annotations

from collections.abc import Callable, Hashable
from dataclasses import field
from typing import TYPE_CHECKING, ClassVar

from archlint.interpreter.values import ForeignValue, Value
from archlint.records import dataclass
from archlint.syntax.parts import Itself

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.model import Blueprint, Creation, ExecutorUse
    from archlint.ros.interfaces import MessageClass


@dataclass(frozen=True, slots=True, eq=False)
class EntityValue(ForeignValue):
    """What a create call returned.  ``creations`` are several where the name has alternatives."""

    is_hashable: ClassVar[bool] = True

    creations: tuple[Creation, ...]
    path: str
    """Canonical class: ``rclpy.client.Client`` …"""
    key: int

    @property
    def heap_key(self) -> int:
        return self.key

    def kind(self) -> Hashable:
        return ("", *map(Itself, self.creations))


@dataclass(frozen=True, slots=True, eq=False)
class NodeValue(ForeignValue):
    """A node made without a class of the workspace: ``create_node``, ``Node('x')``, or one that a helper class
    or function gets from nobody we can see."""

    blueprint: Blueprint
    key: int

    @property
    def heap_key(self) -> int:
        return self.key

    @property
    def class_names(self) -> frozenset[str]:
        return frozenset({"LifecycleNode" if self.blueprint.lifecycle else "Node"})


@dataclass(frozen=True, slots=True, eq=False)
class ExecutorValue(ForeignValue):
    """An executor; of the attribute ``executor`` of a node, one that may be missing."""

    may_be_none: ClassVar[bool] = True

    use: ExecutorUse
    path: str
    key: int

    @property
    def heap_key(self) -> int:
        return self.key


@dataclass(frozen=True, slots=True)
class FutureValue(ForeignValue):
    """The future of a pending answer, and the client it is awaited from."""

    creations: tuple[Creation, ...]
    api: str
    place: Place | None = field(default=None, compare=False)
    result: Value | None = field(default=None, compare=False)

    def identity(self, key_of: Callable[[Value], Hashable]) -> tuple[Hashable, ...]:
        result = None if self.result is None else key_of(self.result)
        return (tuple(map(Itself, self.creations)), self.api, self.place, result)

    def kind(self) -> Hashable:
        return (self.api, *map(Itself, self.creations))

    @property
    def inner(self) -> tuple[Value, ...]:
        return () if self.result is None else (self.result,)


@dataclass(frozen=True, slots=True)
class MessageValue(ForeignValue):
    """An object of an interface class: ``type`` is ``package/msg/Name``, with ``_Request`` and the like kept in
    ``part`` (``""``, ``Request``, ``Response``, ``Goal``, ``Result``, ``Feedback``; ``FeedbackMessage`` and
    ``GetResultResponse``, which a client gets these in)."""

    has_content: ClassVar[bool] = True

    type: str
    section_name: MessageClass = ""
    key: int = 0

    @property
    def heap_key(self) -> int:
        return self.key

    def identity(self, key_of: Callable[[Value], Hashable]) -> tuple[Hashable, ...]:
        return (self,)

    def kind(self) -> Hashable:
        return (self.type, self.section_name)


def creations_of(value: Value | None) -> tuple[Creation, ...]:
    """The create calls that an entity, or what is awaited from it, comes from."""
    return value.creations if isinstance(value, (EntityValue, FutureValue)) else ()


__all__ = ["EntityValue", "ExecutorValue", "FutureValue", "MessageValue", "NodeValue", "creations_of"]
