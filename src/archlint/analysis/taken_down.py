"""Endpoints and timers that their class takes down again, wherever in the class that is."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.analysis.source_code import source_code
from archlint.finding import Place
from archlint.model import EntityKind
from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import statements_of

if TYPE_CHECKING:
    from archlint.model import Blueprint, Creation
    from archlint.systems.model import System

_DESTROYED_BY = {
    EntityKind.PUBLISHER: "destroy_publisher",
    EntityKind.SUBSCRIBER: "destroy_subscription",
    EntityKind.CLIENT: "destroy_client",
    EntityKind.SERVICE: "destroy_service",
    EntityKind.TIMER: "destroy_timer",
}
"""The method of a node that takes down what it is given."""
_ENDED_BY = {EntityKind.TIMER: "cancel", EntityKind.ACTION_CLIENT: "destroy"}
"""The method of the endpoint itself that does so and leaves nothing behind."""


def is_taken_down(system: System, creation: Creation) -> bool:
    """Whether the class that keeps an endpoint in an attribute destroys what that attribute holds: the handler that
    starts something when a request says so, and stops it when the next one does not; or whether the node goes with
    its object."""
    if _goes_with_its_object(system, creation.node):
        return True
    statement = source_code(system).statement_at(creation.place)
    attributes = {target.dotted for target in statement.assigned if _is_own(target)} if statement is not None else set()
    cls = _class_around(system, creation.place) if attributes else None
    return cls is not None and any(_ends(call, creation.kind, attributes) for call in everything_in(cls, facts.Call))


def _goes_with_its_object(system: System, node: Blueprint) -> bool:
    """Whether ``__del__`` of a class of the node destroys it, and with it all that is created on it."""
    for place in (row.place for row in node.classes):
        file_facts = None if system.workspace is None else system.workspace.facts_at(place.file)
        for cls in everything_in([] if file_facts is None else file_facts.body, facts.Class):
            if cls.name_span == place.span and any(map(_destroys_itself, statements_of(cls.body, facts.Function))):
                return True
    return False


def _destroys_itself(method: facts.Function) -> bool:
    return method.name == "__del__" and any(
        call.func.dotted == "self.destroy_node" for call in everything_in(method, facts.Call)
    )


def _is_own(target: facts.Expr) -> bool:
    return bool(target.attribute) and bool(target.dotted) and target.dotted.startswith("self.")


def _ends(call: facts.Call, kind: EntityKind, attributes: set[str]) -> bool:
    match call.func:
        case facts.Attribute(value=owner, attr=name):
            given = {argument.value.dotted for argument in call.args}
            return (name == _DESTROYED_BY.get(kind) and not given.isdisjoint(attributes)) or (
                name == _ENDED_BY.get(kind) and owner.dotted in attributes
            )
    return False


def _class_around(system: System, place: Place) -> facts.Class | None:
    """The innermost class that holds a place."""
    file_facts = None if system.workspace is None else system.workspace.facts_at(place.file)
    classes = everything_in([] if file_facts is None else file_facts.body, facts.Class)
    around = [cls for cls in classes if cls.span[:2] <= place.span[:2] and place.span[2:] <= cls.span[2:]]
    return max(around, key=lambda cls: cls.span[:2], default=None)


__all__ = ["is_taken_down"]
