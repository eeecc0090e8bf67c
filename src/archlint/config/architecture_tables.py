"""``[owners]``, ``[layers]`` and ``[[contracts]]`` as the configuration has them, checked and with their places."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from archlint.architecture import (
    CONNECTIONS,
    FORBID,
    INDEPENDENT,
    NUMBERS,
    PACKAGE,
    POLICIES,
    QOS,
    REQUIRE,
    TYPES,
    Contract,
    Globs,
    Layers,
    Policy,
)
from archlint.config.conversion import converted
from archlint.config.values import unknown_key
from archlint.suggestions import did_you_mean

if TYPE_CHECKING:
    from archlint.config.schema import ContractTable, OneOrMore
    from archlint.config.source import Key

_FIELDS = {
    "from": "source",
    "to": "target",
    "publisher": "provider",
    "server": "provider",
    "subscriber": "user",
    "client": "user",
    "through": "through",
    "nodes": "nodes",
    "types": "types",
}


@dataclass(frozen=True)
class _Form:
    """Keys that a contract may have beside ``name`` and ``kind``: all of ``needed``, at least one of ``some`` where
    there are any, and any of ``free``, of which it has at most ``most``."""

    needed: tuple[str, ...]
    some: tuple[str, ...] = ()
    free: tuple[str, ...] = ()
    most: int = 9

    def fits(self, given: set[str]) -> bool:
        rest = given - set(self.needed)
        return (
            given >= set(self.needed)
            and rest <= {*self.some, *self.free}
            and (not self.some or bool(rest & set(self.some)))
            and len(rest & set(self.free)) <= self.most
        )

    def __str__(self) -> str:
        words = " and ".join(f"`{key}`" for key in self.needed)
        if self.some:
            words += f" with {_listed(self.some)}"
        return f"{words} (and may have {_listed(self.free)})" if self.free else words


def _listed(keys: tuple[str, ...]) -> str:
    return ", ".join(f"`{key}`" for key in keys[:-1]) + f" or `{keys[-1]}`"


_FORMS = {
    FORBID: (_Form(("from", "to"), free=CONNECTIONS, most=1),),
    REQUIRE: (
        _Form(("from", "to"), free=CONNECTIONS, most=1),
        _Form(("topic",), ("publisher", "subscriber")),
        _Form(("service",), ("server", "client")),
        _Form(("action",), ("server", "client")),
        _Form(("topic", "through")),
    ),
    INDEPENDENT: (_Form(("nodes",)),),
    TYPES: tuple(_Form((connection, "types")) for connection in CONNECTIONS),
    QOS: (_Form(("topic",), (*POLICIES, *NUMBERS), ("publisher", "subscriber")),),
}


def owners(table: Mapping[str, OneOrMore], key: Key) -> dict[str, Globs]:
    for name in table:
        _check_pattern(key.at(name), name, of_nodes=False)
    return {name: _nodes(patterns, key.at(name)) for name, patterns in table.items()}


def layers(table: Mapping[str, OneOrMore], key: Key) -> Layers:
    members = dict(table)
    if "order" not in members:
        raise key.error("`layers` needs `order`, the names of the layers from top to bottom")
    order = _order(members.pop("order"), members, key.at("order"))
    for name in members:
        if name not in order:
            raise key.at(name).error(unknown_key(name, dict.fromkeys(order), "`order` does not have"))
    return Layers(order, {name: _nodes(patterns, key.at(name)) for name, patterns in members.items()})


def _order(given: OneOrMore, members: Mapping[str, object], key: Key) -> tuple[str, ...]:
    """The names of the layers, each once and with members."""
    order = converted(given, tuple[str, ...], key)
    for at, name in enumerate(order):
        if name in order[:at]:
            raise key.error(f"`order` has the layer `{name}` twice", name)
        if name not in members:
            raise key.error(f"`layers` does not say which nodes are in `{name}`", name)
    return order


def contracts(tables: Sequence[ContractTable], key: Key) -> tuple[Contract, ...]:
    return tuple(_contract(table, key, number) for number, table in enumerate(tables))


def _contract(table: ContractTable, key: Key, number: int) -> Contract:
    """Where a contract stands is its header."""
    here, given = key.under_header(number), table.given()
    keys = [name for name in given if name not in ("name", "kind")]
    forms = _FORMS[table.kind]
    if not any(form.fits(set(keys)) for form in forms):
        raise here.error(f"a contract of kind `{table.kind}` has {'; or '.join(map(str, forms))}")
    if table.kind == INDEPENDENT and len(_several(table.nodes)) < 2:
        raise here.at("nodes").wrong("a list of two groups or more", table.nodes)
    connection = next((name for name in CONNECTIONS if name in given), None)
    policies: tuple[Policy, ...] = (*POLICIES, *NUMBERS)
    return Contract(
        table.name,
        table.kind,
        key.header(number),
        connection=connection,
        names=_names(given[connection], here.at(connection)) if connection else (),
        policies=tuple((name, _policy(name, given[name], here.at(name))) for name in policies if name in given),
        given=tuple(given.items()),
        **{field: _globs(given[name], here.at(name)) for name, field in _FIELDS.items() if name in given},
    )


def _globs(given: OneOrMore, key: Key) -> Globs:
    return _several(given) if key.path[-1] == "types" else _nodes(given, key)


def _policy(policy: Policy, given: Any, key: Key) -> tuple[str | float, ...]:
    """The values that are allowed for a policy: one, or a list of them."""
    values = _several(given)
    words = POLICIES.get(policy, ())
    for value in () if policy in NUMBERS else values or [None]:
        if value not in words:
            near = did_you_mean(str(value), words, quote="")
            raise key.error(f"`{key}` must be {' or '.join(words)}{near}")
    return values


def _several(given: Any) -> tuple[Any, ...]:
    """What may be one or more, as more."""
    match given:
        case tuple():
            return given
    return (given,)


def _nodes(given: OneOrMore, key: Key) -> Globs:
    return _checked(given, key, of_nodes=True)


def _names(given: OneOrMore, key: Key) -> Globs:
    return _checked(given, key, of_nodes=False)


def _checked(given: OneOrMore, key: Key, *, of_nodes: bool) -> Globs:
    patterns = _several(given)
    for pattern in patterns:
        _check_pattern(key, pattern, of_nodes=of_nodes)
    return patterns


def _check_pattern(key: Key, pattern: str, *, of_nodes: bool) -> None:
    """Names have no colon: what looks like a prefix is ``package:``, which goes for nodes only."""
    prefix, colon, rest = pattern.partition(":")
    if not pattern:
        raise key.error(f"`{key}` has an empty pattern, which matches nothing")
    if colon and not (of_nodes and prefix + colon == PACKAGE and rest):
        allowed = f"a node's name, or `{PACKAGE}NAME` for the nodes of a package" if of_nodes else "a name"
        raise key.error(f"`{key}` has {pattern!r}; a pattern is {allowed}")
