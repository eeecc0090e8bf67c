"""Where C++ code that a compiler refuses is noted."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from archlint.syntax.cpp.kinds import Kind
from archlint.syntax.cpp.kinds_of_values import Kinds
from archlint.syntax.cpp_uses import RefusalOfCpp, RefusedUse, Role

if TYPE_CHECKING:
    from tree_sitter import Node

    from archlint.syntax.cpp.source import SourceText


class Refusals:
    """Notes what is refused; ``ask`` takes what is given for a format and is a member of a message."""

    def __init__(self, source: SourceText, kinds: Kinds, ask: Callable[[Kind, Role], None]) -> None:
        self.found: list[RefusedUse] = []
        self._source, self._kinds, self._ask = source, kinds, ask

    def _note(self, kind: RefusalOfCpp, node: Node, name: str = "", other: str = "") -> None:
        self.found.append(RefusedUse(kind, self._source.span(node), name, other))

    def _text(self, node: Node) -> str:
        return self._source.text(node)

    def _is_node(self, path: tuple[str, ...]) -> bool:
        return bool(self._node_kind(path))

    def _node_kind(self, path: tuple[str, ...]) -> str:
        if path == ("rclcpp", "Node"):
            return "node"
        if path == ("rclcpp_lifecycle", "LifecycleNode"):
            return "lifecycle"
        return self._kinds.node_kind(path[-1]) if len(path) == 1 else ""


__all__ = ["Refusals"]
