"""The architecture that a team declares: who owns a name, which connections must or must not be, layers."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fnmatch import fnmatchcase
from typing import TYPE_CHECKING

from archlint.config_values import one_of, string, strings, table, unknown_key
from archlint.finding import Place
from archlint.toml_places import headers, locate

if TYPE_CHECKING:
    from archlint.config_values import Value

Globs = tuple[str, ...]

FORBID, REQUIRE, INDEPENDENT, TYPES = "forbid", "require", "independent", "types"
KINDS = (FORBID, REQUIRE, INDEPENDENT, TYPES)

_OF_A_PACKAGE = "package:"


@dataclass(frozen=True)
class Contract:
    """One ``[[contracts]]`` entry.  Nodes and topics are globs over full names; ``package:NAME`` stands for the
    nodes of a package.

    ``forbid`` has ``source`` and ``target``; ``require`` these too, or ``topic`` with ``publisher`` or
    ``subscriber`` (or both); ``independent`` has ``nodes``, no two of which are connected; ``types`` has
    ``topic`` and the types that it may have.
    """

    name: str
    kind: str
    place: Place
    source: Globs = ()
    target: Globs = ()
    topic: Globs = ()
    publisher: Globs = ()
    subscriber: Globs = ()
    nodes: Globs = ()
    types: Globs = ()

    def as_table(self) -> dict[str, str | Globs]:
        """The keys and values as the configuration has them."""
        globs = {key: getattr(self, name) for key, name in _FIELDS.items()}
        return {"name": self.name, "kind": self.kind, **{key: one for key, one in globs.items() if one}}


@dataclass(frozen=True)
class Layers:
    """``[layers]``: the nodes of each layer, from top to bottom."""

    order: tuple[str, ...]
    members: Mapping[str, Globs]

    def of(self, node: str, package: str | None) -> list[int]:
        """The positions of the layers that a node is in."""
        return [at for at, layer in enumerate(self.order) if matches(self.members[layer], node, package)]


def matches(globs: Globs, name: str, package: str | None = None) -> bool:
    """Whether a node (of a package) or a topic is meant."""
    return any(
        package is not None and fnmatchcase(package, glob.removeprefix(_OF_A_PACKAGE))
        if glob.startswith(_OF_A_PACKAGE)
        else fnmatchcase(name, glob)
        for glob in globs
    )


# ------------------------------------------------------------------------------------------------ reading


def owners(value: Value) -> dict[str, Globs]:
    return {name: _globs(given) for name, given in table(value).items()}


def layers(value: Value) -> Layers:
    given = table(value)
    if "order" not in given:
        raise value.source.error("`layers` needs `order`, the names of the layers from top to bottom", value.path)
    order = strings(given.pop("order"))
    for name in order:
        if name not in given:
            raise value.source.error(f"`layers` does not say which nodes are in `{name}`", (*value.path, "order"), name)
    for name, one in given.items():
        if name not in order:
            raise value.source.error(unknown_key(name, dict.fromkeys(order), "`order` does not have"), one.path)
    return Layers(order, {name: _globs(one) for name, one in given.items()})


_FIELDS = {
    "from": "source",
    "to": "target",
    "topic": "topic",
    "publisher": "publisher",
    "subscriber": "subscriber",
    "nodes": "nodes",
    "types": "types",
}
_KEYS = {
    FORBID: (("from", "to"),),
    REQUIRE: (("from", "to"), ("topic", "publisher"), ("topic", "subscriber"), ("topic", "publisher", "subscriber")),
    INDEPENDENT: (("nodes",),),
    TYPES: (("topic", "types"),),
}
"""The sets of keys that a contract of each kind may have beside ``name`` and ``kind``."""


def contracts(value: Value) -> tuple[Contract, ...]:
    if not isinstance(value.value, list) or not all(isinstance(one, dict) for one in value.value):
        raise value.wrong("a list of tables, each headed by [[contracts]]")
    return tuple(_contract(value, at) for at in range(len(value.value)))


def _contract(value: Value, at: int) -> Contract:
    from archlint.config_values import Value as Given

    place = _place(value, at)
    fields = {key: Given(one, (*value.path, key), value.source) for key, one in value.value[at].items()}

    def fault(message: str) -> Exception:
        return value.source.error_at(message, place.line, place.column, place.end_column)

    for key in fields:
        if key not in ("name", "kind", *_FIELDS):
            known = dict.fromkeys(("name", "kind", *_FIELDS))
            raise fault(unknown_key(key, known, "unknown key of a contract"))
    for key in ("name", "kind"):
        if key not in fields:
            raise fault(f"this contract has no `{key}`")
    kind = one_of(KINDS)(fields["kind"])
    given = {key for key in fields if key in _FIELDS}
    if given not in [set(keys) for keys in _KEYS[kind]]:
        wanted = "; or ".join(" and ".join(f"`{key}`" for key in keys) for keys in _KEYS[kind])
        raise fault(f"a contract of kind `{kind}` has {wanted}")
    globs = {_FIELDS[key]: _globs(fields[key]) for key in given}
    return Contract(string(fields["name"]), kind, place, **globs)


def _globs(value: Value) -> Globs:
    return (value.value,) if isinstance(value.value, str) else strings(value)


def _place(value: Value, at: int) -> Place:
    """Where a contract stands in its file: its header, or the key of an inline list."""
    path = value.source.table + value.path
    found = headers(value.source.text, path)
    span = found[at] if at < len(found) else locate(value.source.text, path)
    line, column, end = span or (1, 1, 1)
    return Place(value.source.shown, line, column, line, end)
