"""TOP006: messages that are published before anybody can receive them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.left_over import is_dead, is_never_made
from archlint.analysis.reach import node_name, one_for_each_place
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.connections.lost_publications import LostPublication, lost_publications
from archlint.finding import Finding, Related
from archlint.model import EntityKind, Role

if TYPE_CHECKING:
    from archlint.model import Creation
    from archlint.systems.model import System
    from archlint.systems.nodes import Endpoint


@rule("TOP006", scope=Scope.CODE)
def lost_publication(system: System, options: Options) -> Iterator[Finding]:
    """Messages that are sent once, as soon as their publisher is created."""
    yield from one_for_each_place(
        _finding(system, lost)
        for lost in lost_publications(system)
        if not is_dead(system.workspace, lost.program, lost.call) and not is_never_made(system.workspace, lost.call)
        # That a subscription asks for what it missed, and does not get it, QOS002 tells.
        if not any(user.qos is not None and user.qos.durability == "transient_local" for user in _users(system, lost))
    )


def _users(system: System, lost: LostPublication) -> Iterator[Endpoint]:
    """The subscriptions that are meant to get the message."""
    for connection in system.topics.values():
        if any(end.creation is lost.publisher for end in connection.providers):
            yield from connection.users


def _finding(system: System, lost: LostPublication) -> Finding:
    call, publisher = lost.call, lost.publisher
    topic = f"'{publisher.name.text}'" if publisher.name.text else "its topic"
    in_node = call.context.role == Role.INIT or call.function.endswith(".__init__")
    there = _other_publisher(publisher)
    on_or_of = f"on {topic}" if there is None else f"of this publisher of {topic}"
    help = f"publish it {'in a timer, ' if in_node else ''}once get_subscription_count() is above 0"
    related = [Related(publisher.place, "the publisher is created here")]
    if there is not None:
        help = "publish it with the publisher of that topic which the node has already"
        related.append(Related(there.place, "it is created here"))
    return finding(
        "TOP006",
        call.place,
        f"this is the only message {on_or_of}, and it is sent as soon as its publisher is created: subscriptions that "
        "have not matched by then never get it",
        help=help,
        related=related,
        node=node_name(system, publisher.node),
        identity=(call.function, publisher.name.text or ""),
    )


def _other_publisher(publisher: Creation) -> Creation | None:
    """Another publisher that the node has for the same topic."""
    node, topic = publisher.node, publisher.name.text
    rows = () if node is None or topic is None else node.creations
    return next(
        (
            row
            for row in rows
            if row.kind == EntityKind.PUBLISHER and row.name.text == topic and row.place != publisher.place
        ),
        None,
    )
