"""The graph of data in a system: what runs, what it sends, and what it leaves for others of its node."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import field
from functools import cached_property
from typing import TYPE_CHECKING

from archlint.records import dataclass
from archlint.string_enum import StringEnum

if TYPE_CHECKING:
    from archlint.model import ApiCall, Callback, Program
    from archlint.place import Place
    from archlint.systems.model import System
    from archlint.systems.nodes import Connection, Node

NOT_KNOWN = "?"
"""The name of a step whose name is not known."""


class StepKind(StringEnum):
    """What a piece of data comes through."""

    TOPIC = "topic"
    SERVICE = "service"
    """The requests of a service; what comes back is its :attr:`ANSWER`."""
    ANSWER = "answer"
    ACTION = "action"
    """The goals of an action; feedback and results are its :attr:`RESULT`."""
    RESULT = "result"
    CALLBACK = "callback"
    """Code of a node that an executor, a thread or the program itself runs."""
    FRAME = "frame"
    """A coordinate frame of tf2: where it is, as the transforms say of which it is the child."""
    KEPT = "kept"
    """Attributes of an object in which a callback leaves something for another."""
    UNKNOWN = "unknown"
    """Code of a node that sends or takes something, and is not known."""
    STRANGER = "stranger"
    """A node whose source is not here."""


class How(StringEnum):
    """What a link does, in the direction of the data."""

    SEND = "send"
    """A callback publishes, calls a service, sends a goal, answers."""
    ARRIVE = "arrive"
    """A callback gets a message, a request, a goal, an answer, a result."""
    SET = "set"
    """A callback leaves something in attributes."""
    READ = "read"
    """A callback reads these, or looks up a transform."""
    MAY = "may"
    """A stranger may be at either end."""


@dataclass(frozen=True, eq=False)
class Step:
    """One thing that data comes through.  ``name`` is that of a connection, of a callback, of attributes (``self.a,
    self.b``) or of a stranger."""

    kind: StepKind
    name: str
    node: Node | None = None
    """Whose callback, attributes or unknown code it is; the stranger itself."""
    callback: Callback | None = None
    program: Program | None = None
    """The program that runs the callback."""
    place: Place | None = None
    calls: tuple[ApiCall, ...] = ()
    """What the callback calls of ROS, and where it waits."""
    connection: Connection | None = None
    topic: str = ""
    """Of a frame: the topic that brings its transforms."""
    reason: str = ""
    """Of unknown code and of a name that is not known: why."""

    def __repr__(self) -> str:
        return f"<{self.kind} {self.name}>"


@dataclass(frozen=True, eq=False)
class Link:
    """Data goes from ``tail`` to ``head``.  ``doubt`` says why it perhaps does not; ``broken`` why it never does."""

    tail: Step
    head: Step
    how: How
    place: Place | None = None
    doubt: str = ""
    conditional: bool = False
    """Whether a branch of the code decides that it does."""
    broken: str = ""

    def __repr__(self) -> str:
        return f"<{self.tail!r} {self.how} {self.head!r}>"


@dataclass(frozen=True, eq=False)
class Flow:
    """The steps of a system and how data goes between them, both in the order of nodes and source."""

    system: System
    steps: Sequence[Step]
    links: Sequence[Link]
    kept: dict[object, object] = field(default_factory=dict, init=False, repr=False)
    """What analyses found of it (:func:`archlint.analysis.kept.once`)."""

    @cached_property
    def _into(self) -> Mapping[int, Sequence[Link]]:
        return _by_step(self.links, lambda link: link.head)

    @cached_property
    def _out_of(self) -> Mapping[int, Sequence[Link]]:
        return _by_step(self.links, lambda link: link.tail)

    def into(self, step: Step) -> Sequence[Link]:
        """The links that lead to a step."""
        return self._into.get(id(step), ())

    def out_of(self, step: Step) -> Sequence[Link]:
        """The links that lead on from a step."""
        return self._out_of.get(id(step), ())


def _by_step(links: Sequence[Link], end: Callable[[Link], Step]) -> dict[int, list[Link]]:
    rows: dict[int, list[Link]] = {}
    for link in links:
        rows.setdefault(id(end(link)), []).append(link)
    return rows


__all__ = ["NOT_KNOWN", "Flow", "How", "Link", "Step", "StepKind"]
