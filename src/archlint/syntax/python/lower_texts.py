"""Texts of a libcst tree lowered to facts: strings, f-strings, and several in a row."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import libcst as cst

from archlint.syntax import facts
from archlint.syntax.facts import Expr, Span
from archlint.syntax.python.string_literals import format_text, split_prefix, string_value


class TextLowering:
    """Lowers texts; what is in the fields of f-strings is lowered by ``lower``."""

    def __init__(self, lower: Callable[[cst.CSTNode], Expr], span: Callable[[cst.CSTNode], Span]) -> None:
        self.lower = lower
        self.span = span

    def plain(self, node: cst.SimpleString) -> Expr:
        prefix, content = split_prefix(node.value)
        if "b" in prefix:
            return facts.Opaque("bytes", self.span(node))
        try:
            return facts.Literal(string_value(prefix, content), self.span(node))
        except ValueError as error:
            return facts.Opaque(_string_problem(error), self.span(node))

    def joined(self, node: cst.ConcatenatedString | cst.FormattedString) -> Expr:
        parts: list[str | facts.Field] = []
        try:
            for piece in _pieces(node):
                match piece:
                    case cst.FormattedString():
                        self._add_fields(piece, parts)
                    case cst.SimpleString():
                        prefix, content = split_prefix(piece.value)
                        if "b" in prefix:
                            return facts.Opaque("bytes", self.span(node))
                        _add_text(string_value(prefix, content), parts)
                    case _:
                        return facts.Opaque("template string", self.span(node))
        except ValueError as error:
            return facts.Opaque(_string_problem(error), self.span(node))
        match parts:
            case []:
                return facts.Literal("", self.span(node))
            case [str(text)]:
                return facts.Literal(text, self.span(node))
        return facts.FormatString(parts, self.span(node))

    def _add_fields(self, node: cst.FormattedString, parts: list[str | facts.Field]) -> None:
        prefix = node.start.rstrip("'\"").lower()
        for part in node.parts:
            match part:
                case cst.FormattedStringText():
                    _add_text(format_text(prefix, part.value), parts)
                case cst.FormattedStringExpression():
                    _add_text(_self_documenting_text(part), parts)
                    parts.append(self._field(part))

    def _field(self, part: cst.FormattedStringExpression) -> facts.Field:
        spec = None if part.format_spec is None else "".join(map(_code, part.format_spec))
        conversion = part.conversion
        if part.equal is not None and conversion is None and spec is None:
            conversion = "r"
        return facts.Field(self.lower(part.expression), conversion, spec)


def _pieces(node: cst.BaseExpression) -> Iterator[cst.BaseExpression]:
    while isinstance(node, cst.ConcatenatedString):
        yield node.left
        node = node.right
    yield node


def _add_text(text: str, parts: list[str | facts.Field]) -> None:
    if not text:
        return
    if parts and isinstance(parts[-1], str):
        parts[-1] += text
    else:
        parts.append(text)


def _code(node: cst.CSTNode) -> str:
    return cst.Module([]).code_for_node(node)


def _self_documenting_text(part: cst.FormattedStringExpression) -> str:
    """What ``f"{value = }"`` prints before the value; nothing where there is no ``=``."""
    if part.equal is None:
        return ""
    return "".join(map(_code, (part.whitespace_before_expression, part.expression, part.equal)))


def _string_problem(error: ValueError) -> str:
    return "string with a lone surrogate" if isinstance(error, UnicodeError) else f"string with {error}"


__all__ = ["TextLowering"]
