"""``[[external-nodes]]``: what nodes offer whose source is not in the workspace."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.ros.external_nodes import EndKind, ExternalEnd, ExternalNode, ExternalParameter, OpenQuestion

if TYPE_CHECKING:
    from archlint.config.schema import ExternalNodeTable
    from archlint.config.source import Key

_KINDS: tuple[tuple[str, EndKind], ...] = (
    ("publishers", "publisher"),
    ("subscribers", "subscriber"),
    ("services", "service"),
    ("clients", "client"),
    ("action_servers", "action_server"),
    ("action_clients", "action_client"),
)
_INTERFACE_KINDS = {"service": "srv", "client": "srv", "action_server": "action", "action_client": "action"}
_NOT_ALL = OpenQuestion("the configuration does not say that it has nothing else (`complete`)")


def external_nodes(tables: Sequence[ExternalNodeTable], key: Key) -> tuple[ExternalNode, ...]:
    """The nodes as the table of well-known ones has them."""
    return tuple(_node(table, key.under_header(number)) for number, table in enumerate(tables))


def _node(table: ExternalNodeTable, key: Key) -> ExternalNode:
    executables = (table.executable,) if isinstance(table.executable, str) else table.executable
    if not executables:
        raise key.at("executable").error("`executable` names no executable")
    ends = [end for field, kind in _KINDS for end in _ends(getattr(table, field) or {}, kind, key.at(field))]
    return ExternalNode(
        table.package,
        tuple(executables),
        table.name or executables[0].rpartition("::")[2],
        source=key.source.path.name,
        ends=tuple(ends),
        parameters=tuple(ExternalParameter(name, kind) for name, kind in (table.parameters or {}).items()),
        open=() if table.complete else (_NOT_ALL,),
        takes_any_parameter=not table.complete,
    )


def _ends(types: dict[str, str], kind: EndKind, key: Key) -> list[ExternalEnd]:
    ends = []
    for name, type_name in types.items():
        wanted = _INTERFACE_KINDS.get(kind, "msg")
        package, _, rest = type_name.partition(f"/{wanted}/")
        if not package or not rest or "/" in package + rest:
            raise key.at(name).error(f"`{name}` must have a type such as `package/{wanted}/Name`, not '{type_name}'")
        ends.append(ExternalEnd(kind, name, type_name))
    return ends


__all__ = ["external_nodes"]
