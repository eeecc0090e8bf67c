"""``[owners]``, ``[layers]`` and ``[[contracts]]`` as the configuration has them, checked and with their places."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from archlint.architecture import (
    CONNECTIONS,
    FORBID,
    INDEPENDENT,
    KINDS,
    NUMBERS,
    PACKAGE,
    POLICIES,
    QOS,
    REQUIRE,
    TYPES,
    Contract,
    Globs,
    Layers,
)
from archlint.config.toml_places import headers, locate
from archlint.config.values import Value, one_of, string, strings, table, typed, unknown_key
from archlint.finding import Place
from archlint.suggestions import did_you_mean

if TYPE_CHECKING:
    from archlint.config.values import ConfigurationError

_NODES = ("from", "to", "publisher", "subscriber", "server", "client", "through", "nodes")
"""The keys of a contract that name nodes."""
_KEYS = ("name", "kind", *_NODES, *CONNECTIONS, "types", *POLICIES, *NUMBERS)
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


_AMOUNTS: Any = int | float | list[int | float]
_TEXTS: Any = str | list[str]


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
    TYPES: tuple(_Form((one, "types")) for one in CONNECTIONS),
    QOS: (_Form(("topic",), (*POLICIES, *NUMBERS), ("publisher", "subscriber")),),
}


def owners(value: Value) -> dict[str, Globs]:
    for name in table(value):
        _check_pattern(value.at(name), name, of_nodes=False)
    return {name: _nodes(given) for name, given in table(value).items()}


def layers(value: Value) -> Layers:
    given = table(value)
    if "order" not in given:
        raise value.source.error("`layers` needs `order`, the names of the layers from top to bottom", value.path)
    order = strings(given.pop("order"))
    for at, name in enumerate(order):
        if name in order[:at]:
            raise value.source.error(f"`order` has the layer `{name}` twice", (*value.path, "order"), name)
        if name not in given:
            raise value.source.error(f"`layers` does not say which nodes are in `{name}`", (*value.path, "order"), name)
    for name, one in given.items():
        if name not in order:
            raise value.source.error(unknown_key(name, dict.fromkeys(order), "`order` does not have"), one.path)
    return Layers(order, {name: _nodes(one) for name, one in given.items()})


def contracts(value: Value) -> tuple[Contract, ...]:
    tables = typed(value, list[dict[str, Any]], "a list of tables, each headed by [[contracts]]")
    return tuple(_contract(value, at) for at in range(len(tables)))


def _contract(value: Value, at: int) -> Contract:
    place = _place(value, at)
    fields = {
        key: Value(one, (*value.path, key), value.source, after=place.line) for key, one in value.value[at].items()
    }

    def fault(message: str) -> ConfigurationError:
        return value.source.error_at(message, place.line, place.column, place.end_column)

    for key in fields:
        if key not in _KEYS:
            raise fields[key].error(unknown_key(key, dict.fromkeys(_KEYS), "unknown key of a contract"))
    for key in ("name", "kind"):
        if key not in fields:
            raise fault(f"this contract has no `{key}`")
    kind = one_of(KINDS)(fields["kind"])
    given = {key for key in fields if key not in ("name", "kind")}
    if not any(form.fits(given) for form in _FORMS[kind]):
        raise fault(f"a contract of kind `{kind}` has {'; or '.join(str(form) for form in _FORMS[kind])}")
    connection = next((key for key in CONNECTIONS if key in given), None)
    found = Contract(
        string(fields["name"]),
        kind,
        place,
        connection=connection,
        names=_names(fields[connection]) if connection else (),
        policies=tuple((key, _policy(fields[key])) for key in (*POLICIES, *NUMBERS) if key in given),
        given=tuple((key, value.value[at][key]) for key in _KEYS if key in fields),
        **{field: _globs_of(fields[key]) for key, field in _FIELDS.items() if key in given},
    )
    if kind == INDEPENDENT and len(found.nodes) < 2:
        raise fields["nodes"].wrong("a list of two groups or more")
    return found


def _globs_of(value: Value) -> Globs:
    return _globs(value) if value.path[-1] == "types" else _nodes(value)


def _policy(value: Value) -> tuple[str | float, ...]:
    """The values that are allowed for a policy: one, or a list of them."""
    key = value.path[-1]
    if key in NUMBERS:
        unit = "messages" if key == "depth" else "seconds"
        wanted = f"a number of {unit}, or a list of numbers"
        amounts = _several(typed(value, _AMOUNTS, wanted))
        if not amounts or not all(amount >= 0 for amount in amounts):
            raise value.wrong(wanted)
        return amounts
    values = _several(value.value)
    for one in values or [None]:
        if one not in POLICIES[key]:
            near = did_you_mean(str(one), POLICIES[key], quote="")
            raise value.error(f"`{'.'.join(value.path)}` must be {' or '.join(POLICIES[key])}{near}")
    return values


def _several(value: Any) -> tuple[Any, ...]:
    """A list of TOML as a tuple; a single value as one, too."""
    match value:
        case list():
            return tuple(value)
    return (value,)


def _nodes(value: Value) -> Globs:
    found = _globs(value)
    for one in found:
        _check_pattern(value, one, of_nodes=True)
    return found


def _names(value: Value) -> Globs:
    found = _globs(value)
    for one in found:
        _check_pattern(value, one, of_nodes=False)
    return found


def _check_pattern(value: Value, pattern: str, *, of_nodes: bool) -> None:
    """Names have no colon: what looks like a prefix is ``package:``, which goes for nodes only."""
    prefix, colon, rest = pattern.partition(":")
    if not pattern:
        raise value.error(f"`{'.'.join(value.path)}` has an empty pattern, which matches nothing")
    if colon and not (of_nodes and prefix + colon == PACKAGE and rest):
        allowed = f"a node's name, or `{PACKAGE}NAME` for the nodes of a package" if of_nodes else "a name"
        raise value.error(f"`{'.'.join(value.path)}` has {pattern!r}; a pattern is {allowed}")


def _globs(value: Value) -> Globs:
    return _several(typed(value, _TEXTS, "a string or a list of strings"))


def _place(value: Value, at: int) -> Place:
    """Where a contract stands in its file: its header, or the key of an inline list."""
    path = value.source.table + value.path
    found = headers(value.source.text, path)
    span = found[at] if at < len(found) else locate(value.source.text, path)
    line, column, end = span or (1, 1, 1)
    return Place(value.source.shown, line, column, line, end)
