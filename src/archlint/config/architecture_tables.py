"""``[owners]`` and ``[layers]`` as the configuration has them, checked and with their places."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from archlint.architecture import Globs, Layers
from archlint.config.conversion import converted
from archlint.config.name_globs import check_pattern, node_globs
from archlint.config.values import unknown_key

if TYPE_CHECKING:
    from archlint.config.schema import OneOrMore
    from archlint.config.source import Key


def owners(table: Mapping[str, OneOrMore], key: Key) -> dict[str, Globs]:
    for name in table:
        check_pattern(key.at(name), name, of_nodes=False)
    return {name: node_globs(patterns, key.at(name)) for name, patterns in table.items()}


def layers(table: Mapping[str, OneOrMore], key: Key) -> Layers:
    members = dict(table)
    if "order" not in members:
        raise key.error("`layers` needs `order`, the names of the layers from top to bottom")
    order = _order(members.pop("order"), members, key.at("order"))
    for name in members:
        if name not in order:
            raise key.at(name).error(unknown_key(name, dict.fromkeys(order), "`order` does not have"))
    return Layers(order, {name: node_globs(patterns, key.at(name)) for name, patterns in members.items()})


def _order(given: OneOrMore, members: Mapping[str, object], key: Key) -> tuple[str, ...]:
    """The names of the layers, each once and with members."""
    order = converted(given, tuple[str, ...], key)
    for at, name in enumerate(order):
        if name in order[:at]:
            raise key.error(f"`order` has the layer `{name}` twice", name)
        if name not in members:
            raise key.error(f"`layers` does not say which nodes are in `{name}`", name)
    return order
