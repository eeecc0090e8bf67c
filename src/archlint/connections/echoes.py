"""Publishers that have nothing of their own to say: what they publish, or when, is another node's decision."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.analysis.source_code import SourceCode, source_code
from archlint.connections.arbitration import publishes_of
from archlint.model import EntityKind, Role
from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import is_none, statements_of

if TYPE_CHECKING:
    from archlint.systems.model import System
    from archlint.systems.nodes import Endpoint


def is_driven(system: System, owner: Endpoint, owners: Sequence[Endpoint]) -> bool:
    """Whether a node publishes only in callbacks of another one of the owners, which has made it as its helper: they
    take turns, for the other one waits until the helper has returned."""
    others = [other.node.blueprint for other in owners if other.node is not owner.node]
    calls = publishes_of(system, owner)
    return bool(calls) and all(
        call.context.node is not None
        and call.context.role in _CALLBACKS
        and call.context.node is not owner.node.blueprint
        and any(call.context.node is other for other in others)
        for call in calls
    )


_CALLBACKS = frozenset({Role.SUBSCRIPTION, Role.TIMER, Role.SERVICE})


def repeats(system: System, owner: Endpoint) -> bool:
    """Whether a node publishes on a topic only what it has received on that very topic and kept."""
    code, calls = source_code(system), publishes_of(system, owner)
    kept = _received(code, owner)
    said = [code.arguments(call) for call in calls]
    return bool(said) and all(len(arguments) == 1 and arguments[0].value.dotted in kept for arguments in said)


def _received(code: SourceCode, owner: Endpoint) -> frozenset[str]:
    """The attributes of ``self`` that hold a message of the topic which a node publishes, and nothing else: its
    callback sets them."""
    kept: dict[str, list[facts.Assign]] = {}
    for end in owner.node.of_kind(EntityKind.SUBSCRIBER):
        if end.name != owner.name:
            continue
        for callback in end.creation.callbacks.values():
            function = code.definition(callback)
            message = function.params[-1].name if function is not None and function.params else None
            for statement in [] if function is None else statements_of(function.body, facts.Assign):
                if statement.value.variable == message:
                    for target in statement.targets:
                        kept.setdefault(target.dotted or "", []).append(statement)
    file_facts = code.facts_at(owner.place.file) if kept else None
    body = [] if file_facts is None else file_facts.body
    others = [statement for statement in everything_in(body, facts.Assign) if not is_none(statement.value)]
    return frozenset(
        name
        for name, assignments in kept.items()
        if name.startswith("self.")
        and all(
            any(statement is assignment for assignment in assignments)
            for statement in others
            if any(f"{target.dotted}.".startswith(f"{name}.") for target in statement.targets)
        )
    )


__all__ = ["is_driven", "repeats"]
