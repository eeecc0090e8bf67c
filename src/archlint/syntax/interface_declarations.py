"""``interface.yaml``: what a file declares of a node, each entry with its place.

Sources: ros-tooling/rosgraph, ``docs/ROSGRAPH.md`` 3.2; nineyards-robotics/jig, ``schemas/interface.schema.yaml``;
parameters as in ``generate_parameter_library``, where a map without a ``type`` holds further parameters.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any, Literal

from archlint.records import dataclass
from archlint.syntax.facts import Span
from archlint.syntax.safe_yaml import YamlError, YamlReader, span_of

if TYPE_CHECKING:
    import yaml

FILE_NAME = "interface.yaml"

EndKey = Literal["publishers", "subscribers", "services", "service_clients", "actions", "action_clients"]
END_KEYS: tuple[EndKey, ...] = (
    "publishers",
    "subscribers",
    "services",
    "service_clients",
    "actions",
    "action_clients",
)
_COMPUTED = "${"
"""What begins a reference to a parameter."""


@dataclass(frozen=True)
class EndEntry:
    """An end that is declared; ``name`` is as written, ``qos`` what the file says of it."""

    key: EndKey
    name: str
    type: str | None
    qos: Mapping[str, object]
    span: Span


@dataclass(frozen=True)
class ParameterEntry:
    """A parameter that is declared; ``default`` is a tuple of its value, or empty."""

    name: str
    type: str | None
    default: tuple[object, ...]
    span: Span


@dataclass(frozen=True)
class InterfaceDocument:
    """What one document declares of a node.  ``open_keys`` are the lists that hold what only a parameter decides."""

    name: str
    package: str | None
    span: Span
    ends: tuple[EndEntry, ...]
    parameters: tuple[ParameterEntry, ...]
    open_keys: frozenset[str]
    has_qos: bool = True
    """Whether a publisher or subscription can be declared with its QoS only."""


def read_interface_documents(text: str) -> tuple[InterfaceDocument, ...]:
    """The documents that name a node; nothing of a file that is no YAML or declares none."""
    try:
        reader = YamlReader(text, several=True)
        return tuple(document for root in reader.roots if (document := _document(reader, root)) is not None)
    except YamlError:
        return ()


def _document(reader: YamlReader, root: yaml.Node) -> InterfaceDocument | None:
    parts = {key: (at, value) for key, at, value in reader.pairs(root, 0)}
    if "node" not in parts:
        return None
    at, about = parts["node"]
    node = reader.value(about)
    name = node.get("name") if isinstance(node, dict) else None
    package = node.get("package") if isinstance(node, dict) else None
    if not isinstance(name, str) or _COMPUTED in name:
        return None
    open_keys: set[str] = set()
    ends = tuple(end for key in END_KEYS if key in parts for end in _ends(reader, key, parts[key][1], open_keys))
    parameters = tuple(_parameters(reader, parts["parameters"][1], "", open_keys, 1)) if "parameters" in parts else ()
    known = package if isinstance(package, str) and _COMPUTED not in package else None
    return InterfaceDocument(name, known, span_of(at), ends, parameters, frozenset(open_keys))


def _ends(reader: YamlReader, key: EndKey, listed: yaml.Node, open_keys: set[str]) -> Iterator[EndEntry]:
    items: Any = getattr(listed, "value", None)
    for item in items if isinstance(items, list) else ():
        entry = None if isinstance(item, tuple) else reader.value(item, 2)
        name = entry.get("topic", entry.get("name")) if isinstance(entry, dict) else None
        if not isinstance(entry, dict) or not isinstance(name, str) or _COMPUTED in name:
            open_keys.add(key)
            continue
        type_, qos = entry.get("type"), entry.get("qos")
        known = qos if isinstance(qos, dict) else {}
        yield EndEntry(key, name, type_ if isinstance(type_, str) else None, known, span_of(item))


def _parameters(
    reader: YamlReader, held: yaml.Node, prefix: str, open_keys: set[str], depth: int
) -> Iterator[ParameterEntry]:
    for name, at, value in reader.pairs(held, depth):
        full = f"{prefix}{name}"
        entry = {key: node for key, _, node in reader.pairs(value, depth + 1)}
        if name.startswith("__map_"):
            open_keys.add("parameters")
        elif isinstance(getattr(entry.get("type"), "value", None), str):
            type_ = reader.value(entry["type"])
            default = (reader.value(entry["default_value"]),) if "default_value" in entry else ()
            yield ParameterEntry(full, type_ if isinstance(type_, str) else None, default, span_of(at))
        elif entry:
            yield from _parameters(reader, value, f"{full}.", open_keys, depth + 1)
        else:
            open_keys.add("parameters")


__all__ = [
    "END_KEYS",
    "FILE_NAME",
    "EndEntry",
    "EndKey",
    "InterfaceDocument",
    "ParameterEntry",
    "read_interface_documents",
]
