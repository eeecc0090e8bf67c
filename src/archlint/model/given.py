"""What is known of what a call is given: its arguments, and the object that a method is called on.

No more than what analyses ask.  Each kind answers for itself; the base says that nothing is known.
"""

from __future__ import annotations

from dataclasses import field
from typing import TYPE_CHECKING, Literal

from archlint.origins import OriginKind
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.model.executors import ExecutorUse
    from archlint.model.nodes import Blueprint, Creation
    from archlint.ros.interfaces import MessageClass


@dataclass(frozen=True, slots=True)
class Given:
    """Something of which nothing is known that anybody asks for."""

    @property
    def alternatives(self) -> tuple[Given, ...]:
        """What it may be; which of them, the source does not decide."""
        return (self,)

    @property
    def creations(self) -> tuple[Creation, ...]:
        """The create calls of the entity that it is, or that it is awaited from."""
        return ()

    @property
    def seconds(self) -> float | None:
        """The time that it stands for, where a timeout or a period is wanted."""
        return None

    @property
    def executor(self) -> ExecutorUse | None:
        """The executor that it is."""
        return None


@dataclass(frozen=True, slots=True)
class Constant(Given):
    """A constant of Python: ``parameters`` are those whose defaults or overrides it was made from, ``origin`` is where
    it is written, and ``origin_kind`` as for :class:`archlint.model.texts.Text`."""

    value: str | int | float | bool | bytes | None
    parameters: frozenset[str] = frozenset()
    origin: Place | None = None
    origin_kind: OriginKind = "other"

    @property
    def seconds(self) -> float | None:
        return float(self.value) if isinstance(self.value, (int, float)) else None


@dataclass(frozen=True, slots=True)
class PlainValue(Given):
    """A value of one of Python's own classes, of which no more is known: the text in a field of a message."""

    of_class: str


@dataclass(frozen=True, slots=True)
class OneOf(Given):
    """One of several."""

    values: tuple[Given, ...]

    @property
    def alternatives(self) -> tuple[Given, ...]:
        return self.values

    @property
    def creations(self) -> tuple[Creation, ...]:
        return tuple(creation for value in self.values for creation in value.creations)


@dataclass(frozen=True, slots=True)
class Entity(Given):
    """What a create call made: an endpoint, a timer, or what these return, such as the handle of a goal."""

    made_by: tuple[Creation, ...]

    @property
    def creations(self) -> tuple[Creation, ...]:
        return self.made_by


@dataclass(frozen=True, slots=True)
class Future(Given):
    """The future of an answer, and the clients that it is awaited from."""

    clients: tuple[Creation, ...]
    api: str = ""
    """The full name of the method that gave it; empty where none is known."""

    @property
    def creations(self) -> tuple[Creation, ...]:
        return self.clients


@dataclass(frozen=True, slots=True)
class Node(Given):
    """A node that is no object of a class of the workspace."""

    blueprint: Blueprint


@dataclass(frozen=True, slots=True)
class Executor(Given):
    """An executor."""

    use: ExecutorUse

    @property
    def executor(self) -> ExecutorUse | None:
        return self.use


Content = Literal["constants", "measures"]
"""What the code sets in a message: constants and nothing else, or among the rest a floating-point number that is not
constant, such as a speed or a coordinate."""


@dataclass(frozen=True, slots=True)
class Message(Given):
    """A message; ``section_name`` is ``Request``, ``Goal`` … for the part of a service or an action.

    ``content`` is known of requests and goals that are sent; None where what they carry is not known.
    """

    type: str
    section_name: MessageClass
    content: Content | None = None


@dataclass(eq=False)
class Process:
    """A program as it runs: it has objects of its own."""


@dataclass(frozen=True, slots=True)
class Object(Given):
    """An object: ``key`` sets it apart from others of its process, ``foreign_class`` is the dotted name of a class from
    elsewhere."""

    key: int
    foreign_class: str | None
    place: Place | None
    process: Process = field(repr=False)
    """The process that has it."""

    @property
    def identity(self) -> ObjectIdentity:
        """What sets it apart from all others, also from those of other processes."""
        return self.process, self.key


@dataclass(frozen=True, slots=True)
class GoalHandle(Given):
    """The handle of a goal that an action server got; ``action`` is the type of the action, where that is known."""

    action: str | None


@dataclass(frozen=True, slots=True)
class Duration(Given):
    """A duration; ``length`` in seconds, where that is known."""

    length: float | None

    @property
    def seconds(self) -> float | None:
        return self.length


@dataclass(frozen=True, slots=True)
class ForeignClass(Given):
    """A class or function from elsewhere itself, by its dotted name."""

    path: str


CollectionKind = Literal["list", "tuple", "set", "dict", "generator"]


@dataclass(frozen=True, slots=True)
class Collection(Given):
    """Several values."""

    kind: CollectionKind


ObjectIdentity = tuple["Process", int]
"""A process, and the key of an object in it."""

UNKNOWN = Given()

__all__ = [
    "UNKNOWN",
    "Collection",
    "Constant",
    "Content",
    "Duration",
    "Entity",
    "Executor",
    "ForeignClass",
    "Future",
    "Given",
    "GoalHandle",
    "Message",
    "Node",
    "Object",
    "ObjectIdentity",
    "OneOf",
    "Process",
]
