"""MSG004: callbacks whose parameter is annotated with another interface than they get."""

from __future__ import annotations

from collections.abc import Iterator, Sequence, Set
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.analysis.reach import node_name
from archlint.checks.folding import folds, with_others
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Related
from archlint.model import Callback, Creation, FieldUse, Role
from archlint.python_code.annotations import AnnotatedMessage, annotated_messages
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.ros.interfaces import MessageClass
    from archlint.systems.model import System

_DELIVERED: dict[Role, tuple[MessageClass, ...]] = {Role.SUBSCRIPTION: ("",), Role.SERVICE: ("Request", "Response")}
"""Which classes of the interface a callback is called with, in order."""
_CALLS = {Role.SUBSCRIPTION: "subscription", Role.SERVICE: "service"}


@dataclass(frozen=True)
class _Annotated:
    """A parameter of a callback whose annotation names an interface, and what passes it what."""

    message: AnnotatedMessage
    callback: Callback
    creation: Creation
    type: str
    section_name: MessageClass

    @property
    def differs(self) -> bool:
        """Whether the annotation means another message: the service itself may stand for its request."""
        message = self.message
        return message.interface != self.type or message.section_name not in ("", self.section_name)


@rule("MSG004", scope=Scope.CODE)
def callback_annotation(system: System, options: Options) -> Iterator[Finding]:
    """Annotations that name another type than any subscription or service passes; where a topic's publishers send a
    third one, neither is right, and the annotation is the least of it; so it is where a field is read that is missing.
    """
    parameters: dict[Place, list[_Annotated | None]] = {}
    unknown = (interface for run in system.programs for interface in run.unknown_interfaces)
    nowhere = frozenset(f"{interface.package}/{interface.kind}/{interface.name}" for interface in unknown)
    for callback in system.callbacks:
        parts = _DELIVERED.get(callback.role, ())
        if parts and not system.roles.is_test(callback.file):
            for message in annotated_messages(system, callback):
                if message.position < len(parts):
                    row = _annotated(message, callback, parts[message.position])
                    parameters.setdefault(message.place, []).append(row)
    for place in sorted(parameters):
        rows = [row for row in parameters[place] if row is not None and row.differs]
        # Of a type that is nowhere defined, MSG002 speaks: whoever removes the import mends the annotation, too.
        if len(rows) < len(parameters[place]) or rows[0].message.interface in nowhere:
            continue
        if any(_is_read_as_annotated(system, row) for row in rows):
            continue  # MSG001 tells the first field that what is passed does not have: who mends it mends this, too
        sent = _types_sent(system).get(rows[0].creation.place, frozenset())
        if not sent or not sent.isdisjoint((rows[0].type, rows[0].message.interface)):
            yield _finding(system, rows[0], sent)


def _is_read_as_annotated(system: System, row: _Annotated) -> bool:
    """Whether the code asks what it is passed for a field that the annotation means, and that this has not."""
    workspace, message = system.workspace, row.message
    interfaces = None if workspace is None else workspace.interfaces
    if interfaces is None:
        return False
    section = message.section_name or row.section_name
    return any(
        (use.type, use.section_name) == (row.type, row.section_name)
        and interfaces.has(message.interface, section, use.name)
        for use in _absent_fields(system).get(row.creation.place, ())
    )


@once
def _absent_fields(system: System) -> dict[Place, list[FieldUse]]:
    """The uses of fields that a message does not have, by what delivers it."""
    uses: dict[Place, list[FieldUse]] = {}
    for use in (use for program in system.programs for use in program.field_uses):
        if use.exists is False and use.delivered is not None:
            uses.setdefault(use.delivered.place, []).append(use)
    return uses


@once
def _types_sent(system: System) -> dict[Place, frozenset[str]]:
    """The types that the topics of subscriptions are published with, where they are known for all publishers."""
    sent: dict[Place, set[str | None]] = {}
    for connection in system.topics.values():
        types = {end.type for end in connection.providers}
        for end in connection.users:
            sent.setdefault(end.creation.place, set()).update(types)
    return {
        place: frozenset(name for name in types if name is not None)
        for place, types in sent.items()
        if None not in types
    }


def _annotated(message: AnnotatedMessage, callback: Callback, part: MessageClass) -> _Annotated | None:
    """None where the type that is passed is not known."""
    creation = callback.creation
    if creation is None or creation.type is None:
        return None
    return _Annotated(message, callback, creation, creation.type, part)


def _finding(system: System, row: _Annotated, sent: Set[str]) -> Finding:
    """``sent`` are the types that are known to be published, which say what is wrong."""
    word, text = _CALLS[row.callback.role], row.creation.name.text
    by = f"its {word}" if text is None else f"the {word} of '{text}'"
    gets = _words(row.type, row.section_name)
    says = _words(row.message.interface, row.message.section_name)
    meant = row.message.interface.rpartition("/")[2]
    help = f"annotate it as {gets.rpartition('/')[2]} if the {word} is right, else give the {word} {meant}"
    if sent:
        published = f"give the {word} {meant}, which is published there"
        help = f"annotate it as {gets.rpartition('/')[2]}" if row.type in sent else published
    return finding(
        "MSG004",
        row.message.place,
        f"'{row.message.name}' is annotated as {says}, but {by} passes {gets}",
        help=help,
        related=[Related(row.creation.place, f"{gets} comes from here")],
        node=node_name(system, row.callback.node),
        identity=(row.callback.name, row.message.name, says, gets),
        group=(row.message.place.file, row.callback.name, row.message.interface, row.type),
    )


@folds("MSG004")
def _of_one_signature(findings: Sequence[Finding]) -> Finding:
    """One finding for the request and the response of one service."""
    return with_others(findings, "another parameter is", "more parameters are", "of that service, too")


def _words(interface: str, section_name: MessageClass) -> str:
    return f"{interface}.{section_name}" if section_name else interface
