"""A made-up system of many nodes: packages of 25, each node with a topic of its own and two that it listens to, mostly
of its package, and every tenth with a service.  The same number gives the same system."""

from __future__ import annotations

import random

from archlint.systems.model import System
from systems.builders import Entity, client, node, publisher, service, subscriber, system

_IN_PACKAGE = 25
_FAR = 0.15
"""The share of subscriptions that reach into another package."""


def large(nodes: int) -> System:
    numbers = random.Random(1)
    packages = max(1, nodes // _IN_PACKAGE)

    def entities(number: int) -> list[Entity]:
        heard = [subscriber(f"/area{area}/topic{_in(area)}") for area in _areas(number)]
        own = [publisher(f"/area{number % packages}/topic{number}"), *heard]
        own += [subscriber("/clock", "rosgraph_msgs/msg/Clock")] if number % 3 == 0 else []
        own += [service(f"/area{number % packages}/service{number}")] if number % 10 == 0 else []
        return own + ([client(f"/area{number % packages}/service{number - packages}")] if _is_client(number) else [])

    def _areas(number: int) -> list[int]:
        own = number % packages
        return [own if numbers.random() > _FAR else numbers.randrange(packages) for _ in range(2)]

    def _in(area: int) -> int:
        return area + packages * numbers.randrange(max(1, nodes // packages))

    def _is_client(number: int) -> bool:
        return number >= packages and (number - packages) % 10 == 0

    return system(
        *(
            node(f"/area{number % packages}/node{number}", *entities(number), package=f"package{number % packages}")
            for number in range(nodes)
        )
    )


__all__ = ["large"]
