"""Futures that code takes for the answers that they will hold."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.model.nodes import Callback, Creation


@dataclass(frozen=True)
class MistakenFuture:
    """A future of a request that is used as the answer itself.

    ``api`` is the call that gives it (``rclpy.client.Client.call_async``), ``sent`` the place of that call, where it is
    known, and ``client`` the client that it is made on.
    """

    place: Place
    attribute: str
    """What is read of it; empty where a service handler returns it."""
    api: str
    client: Creation
    context: Callback
    """What runs."""
    sent: Place | None = None
    uncalled: bool = False
    """Whether it is read of its method ``result``, which is not called."""
    has_attribute: bool | None = None
    """Whether the answer has the attribute; None where that is not known."""


__all__ = ["MistakenFuture"]
