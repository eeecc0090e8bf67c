"""Publishers and subscriptions of one topic that quality of service keeps apart: no message ever gets through."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from archlint.analysis.coexistence import certain, in_source_order, meet
from archlint.ros.qos import Verdict, compatible

if TYPE_CHECKING:
    from archlint.systems.model import Connection, Endpoint, System


@dataclass(frozen=True)
class Undelivered:
    """A publisher (``offer``) and a subscription (``request``) that never connect, and the policies that say so."""

    offer: Endpoint
    request: Endpoint
    verdicts: tuple[Verdict, ...]

    @property
    def reason(self) -> str:
        """``best effort offered, reliable requested``, for each policy."""
        return "; ".join(
            f"{policy_words(one, one.offered)} offered, {policy_words(one, one.requested)} requested"
            for one in self.verdicts
        )


def undelivered(system: System) -> Iterator[Undelivered]:
    """All such pairs of a system, by topic and in source order."""
    for topic in system.topics.values():
        yield from undelivered_on(system, topic)


def undelivered_on(system: System, topic: Connection) -> Iterator[Undelivered]:
    """The pairs of one topic that exist at the same time and whose profiles are known."""
    offers = in_source_order(end for end in topic.providers if _judged(end))
    for request in in_source_order(end for end in topic.users if _judged(end)):
        for offer in offers:
            errors = tuple(_errors(offer, request)) if meet(system, offer, request) else ()
            if errors:
                yield Undelivered(offer, request, errors)


def policy_words(verdict: Verdict, value: str | float | None) -> str:
    """What one side says of a policy: ``best effort``, ``a deadline of 0.1 s``."""
    policy = verdict.policy.replace("_", " ")
    if isinstance(value, str):
        return f"{value.replace('_', ' ')} {policy}" if verdict.policy == "liveliness" else value.replace("_", " ")
    return f"a {policy} of {value:g} s" if value else f"no {policy}"


def _judged(end: Endpoint) -> bool:
    return certain(end) and end.qos is not None and not end.qos.overridable and end.qos.parameter is None


def _errors(offer: Endpoint, request: Endpoint) -> list[Verdict]:
    assert offer.qos is not None and request.qos is not None
    return [verdict for verdict in compatible(offer.qos, request.qos) if verdict.level == "error"]
