"""What a launch file says of nodes whose source is not here: the names that it remaps to."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from archlint.ros import names
from archlint.ros.names import InvalidName

if TYPE_CHECKING:
    from archlint.model import Text
    from archlint.systems.model import System
    from archlint.systems.nodes import Node


def remapped_names(node: Node) -> Iterator[tuple[str, str]]:
    """``(source as written, full target)`` of each remapping of names whose target is known, in the order in
    which ROS tries them."""
    if node.started is None:
        return
    namespace, own = _where(node)
    for remap in node.started.remaps:
        source, target = _known(remap.source), _known(remap.target)
        if source is None or target is None or source.startswith("__"):
            continue
        if not target.startswith("/") and (namespace is None or (own is None and names.uses_node_name(target))):
            continue
        full = names.expand(target, own or "_", namespace or "/")
        if not isinstance(full, InvalidName):
            yield source, full


def connections_of_externals(system: System) -> list[tuple[Node, str]]:
    """External nodes with the full names that they are remapped to, where somebody else has the name, too.

    Which end of the name they are, and of what kind, only their source says.
    """
    links = [
        (node, name)
        for node in system.nodes
        if node.is_stranger
        for _, name in remapped_names(node)
        if all(end.name != name for end in node.endpoints)
    ]
    links = list(dict.fromkeys(links))
    users: dict[str, set[int]] = {}
    for node, name in links:
        users.setdefault(name, set()).add(id(node))
    known = {endpoint.name for endpoint in system.endpoints}
    return [(node, name) for node, name in links if name in known or len(users[name]) > 1]


_BETWEEN = re.compile(r"[^\w/~]+|:=")


class UsedNames:
    """The names that external nodes may use, looked up once for all of them: a system can have very many of both."""

    def __init__(self, nodes: Iterable[Node]) -> None:
        self._full: set[str] = set()
        self._endings: set[str] = set()
        for node in nodes:
            self._full.update(full for _, full in remapped_names(node))
            words = [] if node.started is None else [word for word in node.started.arguments if word is not None]
            texts = {*_texts_of(node), *(part for word in words for part in _BETWEEN.split(word))}
            self._endings.update(text.lstrip("/~") for text in texts)
        self._endings.discard("")

    def holds(self, name: str) -> bool:
        """Whether a node is given a name: by a remapping, as (the end of) a text among its parameters, or on its
        command line, where the bridges to simulators have it (``/scan@sensor_msgs/msg/LaserScan``)."""
        starts = (at for at, letter in enumerate(f"/{name}", 1) if letter == "/")
        return name in self._full or any(f"/{name}"[start:] in self._endings for start in starts)


def may_use(node: Node, name: str) -> bool:
    """The same of one node and one name."""
    return UsedNames([node]).holds(name)


def _texts_of(node: Node) -> Iterator[str]:
    """The texts among the values that a launch file sets on an external node."""
    for setting in node.settings:
        match setting.value:
            case str(text):
                yield text
            case list(values):
                yield from (text for text in values if isinstance(text, str))


def _where(node: Node) -> tuple[str | None, str | None]:
    """The namespace and the own name of an external node, as far as they are known."""
    if node.name is not None:
        namespace, _, own = node.name.rpartition("/")
        return namespace or "/", own
    given = node.started.namespace if node.started is not None else None
    return ("/" if given is None else _known(given)), None


def _known(text: Text) -> str | None:
    return text.text if text.resolution in ("exact", "parameter") else None
