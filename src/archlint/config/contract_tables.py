"""``[[contracts]]`` as the configuration has them, checked and with their places."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from archlint.architecture import CONNECTIONS, INDEPENDENT, NUMBERS, POLICIES, Contract, Globs, Policy
from archlint.config.contract_forms import FORMS
from archlint.config.name_globs import name_globs, node_globs, several
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


def contracts(tables: Sequence[ContractTable], key: Key) -> tuple[Contract, ...]:
    return tuple(_contract(table, key, number) for number, table in enumerate(tables))


def _contract(table: ContractTable, key: Key, number: int) -> Contract:
    """Where a contract stands is its header."""
    here, given = key.under_header(number), table.given()
    keys = [name for name in given if name not in ("name", "kind")]
    forms = FORMS[table.kind]
    if not any(form.fits(set(keys)) for form in forms):
        raise here.error(f"a contract of kind `{table.kind}` has {'; or '.join(map(str, forms))}")
    if table.kind == INDEPENDENT and len(several(table.nodes)) < 2:
        raise here.at("nodes").wrong("a list of two groups or more", table.nodes)
    connection = next((name for name in CONNECTIONS if name in given), None)
    policies: tuple[Policy, ...] = (*POLICIES, *NUMBERS)
    return Contract(
        table.name,
        table.kind,
        key.header(number),
        connection=connection,
        names=name_globs(given[connection], here.at(connection)) if connection else (),
        policies=tuple((name, _policy(name, given[name], here.at(name))) for name in policies if name in given),
        given=tuple(given.items()),
        **{field: _globs(given[name], here.at(name)) for name, field in _FIELDS.items() if name in given},
    )


def _globs(given: OneOrMore, key: Key) -> Globs:
    return several(given) if key.path[-1] == "types" else node_globs(given, key)


def _policy(policy: Policy, given: Any, key: Key) -> tuple[str | float, ...]:
    """The values that are allowed for a policy: one, or a list of them."""
    values = several(given)
    words = POLICIES.get(policy, ())
    for value in () if policy in NUMBERS else values or [None]:
        if value not in words:
            near = did_you_mean(str(value), words, quote="")
            raise key.error(f"`{key}` must be {' or '.join(words)}{near}")
    return values
