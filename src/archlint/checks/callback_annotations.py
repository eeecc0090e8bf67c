"""MSG004: callbacks whose parameter is annotated with another interface than they get."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from archlint.analysis.annotations import interface_of
from archlint.analysis.reach import node_name
from archlint.analysis.signatures import signature_of
from archlint.analysis.source_code import source_code
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Place, Related
from archlint.model import Callback, Creation, Role
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.ros.interfaces import MessageClass
    from archlint.systems.model import System

_DELIVERED: dict[Role, tuple[MessageClass, ...]] = {Role.SUBSCRIPTION: ("",), Role.SERVICE: ("Request", "Response")}
"""Which classes of the interface a callback is called with, in order."""
_CALLS = {Role.SUBSCRIPTION: "subscription", Role.SERVICE: "service"}


@dataclass(frozen=True)
class _Annotated:
    """A parameter of a callback whose annotation names an interface, and what it is called with."""

    callback: Callback
    creation: Creation
    name: str
    place: Place
    says: tuple[str, MessageClass]
    gets: tuple[str, MessageClass]

    @property
    def differs(self) -> bool:
        """Whether the annotation means another message: the service itself may stand for its request."""
        return self.says[0] != self.gets[0] or (self.says[1] != self.gets[1] and self.says[1] != "")


@rule("MSG004", scope=Scope.CODE)
def callback_annotation(system: System, options: Options) -> Iterator[Finding]:
    """Annotations that name another type than any subscription or service passes."""
    parameters: dict[Place, list[_Annotated]] = {}
    unclear: set[Place] = set()
    for callback in system.callbacks:
        if callback.role in _DELIVERED and not system.roles.is_test(callback.file):
            for place, row in _parameters(system, callback):
                if row is None:
                    unclear.add(place)
                else:
                    parameters.setdefault(place, []).append(row)
    for place in sorted(parameters.keys() - unclear):
        rows = parameters[place]
        if all(row.differs for row in rows):
            yield _finding(system, rows[0])


def _parameters(system: System, callback: Callback) -> Iterator[tuple[Place, _Annotated | None]]:
    """The annotated parameters of a callback that the message is passed by; None where its type is not known."""
    signature, function = signature_of(system, callback), callback.function
    code = None if function is None else source_code(system).facts_at(function.place.file)
    if signature is None or function is None or code is None:
        return
    by_name = {param.name: param for param in signature.params}
    creation = callback.creation
    for name, part in zip(signature.names, _DELIVERED[callback.role], strict=False):
        annotation = by_name[name].annotation
        says = None if annotation is None else interface_of(code, annotation)
        if annotation is None or says is None:
            continue
        place = Place(function.place.file, *_span(annotation))
        known = creation is not None and creation.type is not None
        yield place, _row(callback, creation, name, place, says, part) if known and creation is not None else None


def _row(
    callback: Callback, creation: Creation, name: str, place: Place, says: tuple[str, MessageClass], part: MessageClass
) -> _Annotated:
    return _Annotated(callback, creation, name, place, says, (creation.type or "", part))


def _span(annotation: facts.Expr) -> facts.Span:
    assert isinstance(annotation, (facts.Name, facts.Attribute))
    return annotation.span


def _finding(system: System, row: _Annotated) -> Finding:
    word, text = _CALLS[row.callback.role], row.creation.name.text
    by = f"its {word}" if text is None else f"the {word} of '{text}'"
    gets, says = _words(*row.gets), _words(*row.says)
    return finding(
        "MSG004",
        row.place,
        f"'{row.name}' is annotated as {says}, but {by} passes {gets}",
        help=f"annotate it as {gets.rpartition('/')[2]} if the {word} is right",
        related=[Related(row.creation.place, f"{gets} comes from here")],
        node=node_name(system, row.callback.node),
        identity=(row.callback.name, row.name, says, gets),
    )


def _words(interface: str, section_name: MessageClass) -> str:
    return f"{interface}.{section_name}" if section_name else interface
