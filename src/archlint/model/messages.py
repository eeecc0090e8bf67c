"""What programs do with messages: the fields that they use, and interfaces that are not there."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal

from archlint.records import dataclass
from archlint.string_enum import StringEnum

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.model.nodes import Blueprint, Creation
    from archlint.ros.interfaces import InterfaceKind, MessageClass


Access = Literal["read", "write", "keyword", "constant"]
"""How code names a field: ``constant`` is what looks like one and is read from the class."""


@dataclass(frozen=True)
class Passed:
    """One hop of a message that a function is called with."""

    call: Place
    helper: str
    """Qualified name of the function."""
    function: Place


@dataclass(frozen=True)
class FieldUse:
    """A field of a message that the code names.

    ``type`` and ``section_name`` (``Request``, ``Goal`` …; empty for a plain message) are those of the message.
    ``exists`` is None where its definition is not known; where it is False, ``fields`` are those that the message
    has, and ``inside`` is the one whose own message has the name; for a constant the class of the same service or
    action that has it.
    """

    place: Place
    type: str
    section_name: MessageClass
    name: str
    access: Access
    exists: bool | None
    fields: tuple[str, ...] = ()
    node: Blueprint | None = None
    delivered: Creation | None = None
    """What calls with the message, where this use of it certainly is reached whatever its type."""
    inside: str | None = None
    passed: tuple[Passed, ...] = ()
    """The calls that pass the message, or what it is in, to where it is used; the last of them first."""
    certain: bool = False
    """Whether a message that is passed certainly comes to this use, whatever its type."""
    client: Creation | None = None
    """Of a response: the client that it was sent to, where that is known."""


@dataclass(frozen=True)
class UnknownInterface:
    """An interface that is imported from a package which does not define it; ``others`` are what was perhaps
    meant, with the kind where that is another."""

    place: Place
    package: str
    kind: InterfaceKind
    name: str
    others: tuple[str, ...] = ()
    left_out: bool = False
    """True where its file is there, but the package does not generate it."""
    elsewhere: tuple[str, ...] = ()
    """The packages of the workspace that define an interface of that kind and name."""
    in_function: bool = False
    """Whether a function imports it, when it runs."""


class ValueEffect(StringEnum):
    """What becomes of a value that a field does not take, in the distributions after humble: their messages check
    nothing (humble's raise an AssertionError), so that it depends on how the value is kept and sent."""

    SET = "raises when it is set"
    SENT = "raises when it is sent"
    CHANGED = "something else is sent"
    FALSE = "False is sent"
    CRASH = "the process dies when it is sent"
    NONE = "none"


@dataclass(frozen=True)
class WrongValue:
    """A value that a field of a message does not take; ``name`` is empty where a constructor is given it without one.

    ``wanted``, ``given`` and ``cure`` are in the words of a finding.
    """

    place: Place
    type: str
    section_name: MessageClass
    name: str
    wanted: str
    given: str
    effect: ValueEffect
    cure: str
    node: Blueprint | None = None
    checked: bool = True
    """Whether humble's messages raise AssertionError, too."""
    called_at: Place | None = None
    """The call of the function around that gives it the value, where others may give it another."""
