"""What can be asked about (a topic, a parameter, an executable …), and where files mention it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal

from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.place import Place
    from archlint.systems.nodes import Endpoint, Node

SubjectKind = Literal[
    "topic", "service", "action", "parameter", "node", "executable", "package", "file", "interface", "unnamed"
]
"""``unnamed`` is an endpoint of which only the create call is known."""

Role = Literal[
    "call", "argument", "literal", "remap source", "remap target", "declare", "get", "set", "value", "start", "entry"
]
"""What a mention does.

``call`` is a whole call that creates or declares something, ``argument`` what such a call is given as the name, and
``literal`` where the text of the name stands, if that is elsewhere.  ``value`` is the value of a parameter that is a
name.  ``start`` is in a launch file, ``entry`` where a package installs an executable.
"""


@dataclass(frozen=True, order=True)
class Subject:
    """What is mentioned.  ``name`` of a topic, service, action or node is the full one, of an interface
    ``package/msg/Name``, of a file its shown path.  ``owner`` of a parameter says which node's it is, of an executable
    which package's."""

    kind: SubjectKind
    name: str
    owner: str = ""


@dataclass(frozen=True, eq=False)
class Mention:
    """One place at which a subject is mentioned, in one system.

    ``written`` is the name as it stands there; None where it is computed.  ``rank`` says how much a system counts: 0 of
    what a launch file starts, 1 of a launch file that others include, 2 of what no launch file has started.
    """

    place: Place
    subject: Subject
    role: Role
    rank: int
    written: str | None = None
    end: Endpoint | None = None
    node: Node | None = None

    @property
    def sort_key(self) -> tuple[Place, Subject, Role, int]:
        return self.place, self.subject, self.role, self.rank


__all__ = ["Mention", "Role", "Subject", "SubjectKind"]
