"""Parameter packs of C++ lowered to :mod:`archlint.syntax.facts`: ``(add(names), ...)`` and ``open(names...)``."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.syntax import facts
from archlint.syntax.cpp.lower_expressions import ExpressionLowering
from archlint.syntax.cpp.names import Names

if TYPE_CHECKING:
    from tree_sitter import Node

    from archlint.syntax.cpp.source import SourceText
    from archlint.syntax.facts import Expr, Span, Stmt


class PackLowering(ExpressionLowering):
    """Lowers packs, too."""

    def __init__(self, source: SourceText, names: Names) -> None:
        super().__init__(source, names)
        self._kinds |= {"parameter_pack_expansion": self._expanded, "fold_expression": self._folded}

    def _expanded(self, node: Node, span: Span) -> Expr:
        """``names...`` among the arguments of a call."""
        pack = self._pack_in(node)
        return facts.Opaque("a parameter pack", span) if pack is None else facts.Starred(facts.Name(pack, span))

    def _folded(self, node: Node, span: Span) -> Expr:
        """``(add(names), ...)`` works out something for each of the arguments."""
        pack, inner = self._pack_in(node), node.named_children[0] if node.named_child_count == 1 else None
        if pack is None or inner is None:
            return facts.Opaque("a fold expression", span)
        whole = facts.Name(f"{pack}...", span)
        self.names.declare(whole.id)
        outer, self.before = self.before, []
        value = self.lower(inner)
        body: list[Stmt] = [*self.before, facts.Expression(value, span)]
        each = facts.Name(pack, span)
        outer += (
            facts.Assign([whole], each, span),
            facts.For(each, whole, body, [], False, span),
            facts.Assign([each], whole, span),
        )
        self.before = outer
        return facts.Opaque("a fold expression", span)

    def _pack_in(self, node: Node) -> str | None:
        """The one pack that something names; None where there is none, or several, which go side by side."""
        names = {self.source.text(part) for part in _identifiers(node) if self.names.is_pack(self.source.text(part))}
        return names.pop() if len(names) == 1 else None


def _identifiers(node: Node) -> Iterator[Node]:
    waiting = [node]
    while waiting:
        inner = waiting.pop()
        if inner.type == "identifier":
            yield inner
        waiting.extend(inner.named_children)


__all__ = ["PackLowering"]
