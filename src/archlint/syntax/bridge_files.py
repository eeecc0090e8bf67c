"""What a file says that a bridge to a simulator reads: a list of topics, each with its type and its direction.

Source: ros_gz_bridge, ``bridge_config.cpp``; an entry that it refuses is left out.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

from archlint.syntax.facts import Span
from archlint.syntax.safe_yaml import YamlError, YamlReader, span_of

if TYPE_CHECKING:
    import yaml

_SIMULATORS = ("gz", "ign")
_WAYS = {
    "BIDIRECTIONAL": (True, True),
    **{f"{name.upper()}_TO_ROS": (True, False) for name in _SIMULATORS},
    **{f"ROS_TO_{name.upper()}": (False, True) for name in _SIMULATORS},
}


class BridgedTopic(NamedTuple):
    """A topic of ROS that a bridge publishes, subscribes to, or both."""

    name: str
    type: str
    publishes: bool
    subscribes: bool


def read_bridges(text: str) -> tuple[BridgedTopic, ...] | None:
    """The topics in such a file; None where something stands in it that is not known here, such as a service."""
    try:
        reader = YamlReader(text)
        entries = None if reader.root is None else reader.value(reader.root)
    except (YamlError, RecursionError):
        return None
    if not isinstance(entries, list) or any(isinstance(entry, dict) and _is_other(entry) for entry in entries):
        return None
    return tuple(topic for entry in entries if isinstance(entry, dict) and (topic := _topic(entry)) is not None)


class BridgeEntry(NamedTuple):
    """An entry of such a file, whatever it says: its texts by their keys, and where each stands."""

    texts: dict[str, str]
    spans: dict[str, Span]
    span: Span


def bridge_entries(text: str) -> list[BridgeEntry]:
    """The entries of such a file that are maps; none where it cannot be read."""
    import yaml

    try:
        root = YamlReader(text).root
    except (YamlError, RecursionError):
        return []
    if not isinstance(root, yaml.SequenceNode):
        return []
    return [_entry(node) for node in root.value if isinstance(node, yaml.MappingNode)]


def _entry(node: yaml.MappingNode) -> BridgeEntry:
    import yaml

    rows = [(str(key.value), key, value) for key, value in node.value]
    texts = {name: str(value.value) if isinstance(value, yaml.ScalarNode) else "" for name, _, value in rows}
    spans = {name: (*span_of(key)[:2], *span_of(value)[2:]) for name, key, value in rows}
    return BridgeEntry(texts, spans, span_of(node.value[0][0]) if node.value else span_of(node))


def _is_other(entry: dict[str, Any]) -> bool:
    return not any(key == "topic_name" or key.endswith("_topic_name") for key in entry)


def _topic(entry: dict[str, Any]) -> BridgedTopic | None:
    both, own, type_name = (_text(entry, key) for key in ("topic_name", "ros_topic_name", "ros_type_name"))
    other = next((name for sim in _SIMULATORS if (name := _text(entry, f"{sim}_topic_name"))), "")
    has_type = any(_text(entry, f"{sim}_type_name") for sim in _SIMULATORS)
    way = _WAYS.get(str(entry.get("direction", "BIDIRECTIONAL")))
    name = both or own or other
    if not name or (both and (own or other)) or not type_name or not has_type or way is None:
        return None
    return BridgedTopic(name, type_name, *way)


def _text(entry: dict[str, Any], key: str) -> str:
    value = entry.get(key)
    return value if isinstance(value, str) else ""


__all__ = ["BridgeEntry", "BridgedTopic", "bridge_entries", "read_bridges"]
