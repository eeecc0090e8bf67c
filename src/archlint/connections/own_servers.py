"""Clients of what their own node serves."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import takewhile
from typing import TYPE_CHECKING

from archlint.model import SERVER_OF

if TYPE_CHECKING:
    from archlint.model import Creation


def is_served_by_its_node(client: Creation) -> bool:
    """Whether the node of a client has made the server itself, and before the client."""
    return any(_serves(server, client) for server in _made_before(client))


def _made_before(client: Creation) -> Iterator[Creation]:
    return takewhile(lambda creation: creation is not client, client.node.creations)


def _serves(server: Creation, client: Creation) -> bool:
    name = client.name
    return (
        server.kind is SERVER_OF.get(client.kind)
        and name.text is not None
        and name.resolution == server.name.resolution == "exact"
        and name.text == server.name.text
        and not (server.conditional or server.branch_arms or server.destroyed)
    )


__all__ = ["is_served_by_its_node"]
