"""C++ parsed, without the macros that the grammar does not know."""

from __future__ import annotations

import re
from functools import cache
from typing import TYPE_CHECKING

import tree_sitter
import tree_sitter_cpp

from archlint.syntax.cpp.preprocessor import with_whole_branches

if TYPE_CHECKING:
    from tree_sitter import Parser, Tree


_EXPORT_MACRO = re.compile(
    rb"\b(?!RMW_)[A-Z][A-Z0-9_]*_(?:PUBLIC|PUBLIC_TYPE|EXPORT|EXPORTS|LOCAL|API|HIDDEN|VISIBILITY)(?=\s+[A-Za-z_~])"
)
"""``DEMO_NODES_CPP_PUBLIC``: the grammar knows no macro in front of a class or a function."""
_MACRO_OF_CLASS = re.compile(rb"\b(?:class|struct)\s+([A-Z][A-Z0-9_]{3,})\s+(?=[A-Za-z_]\w*\s*(?:final\s*)?[:{])")
_QT_MACRO = re.compile(rb"\bQ_(?:OBJECT|GADGET)\b|^[ \t]*(?:Q_SIGNALS|signals)\s*:", re.M)
_QT_SLOTS = re.compile(rb"\b(?:public|protected|private)\s+(Q_SLOTS|slots)\s*:")
_POINT_MACRO = re.compile(
    rb"\b(?:PCL_ADD_\w+|(?:EIGEN|PCL)_MAKE_ALIGNED_OPERATOR_NEW|EIGEN_ALIGN(?:16|32|64|_MAX)?)\b(?!\s*\()"
)
"""What types of points are written with, as ``EIGEN_ALIGN16`` behind the struct."""
_MODULE_MACRO = re.compile(
    rb"^[ \t]*RCLCPP_(?:SMART_PTR\w*|SHARED_PTR\w*|UNIQUE_PTR\w*|WEAK_PTR\w*|DISABLE_COPY)\([^()\n]*\)", re.M
)


@cache
def _parser() -> Parser:
    return tree_sitter.Parser(tree_sitter.Language(tree_sitter_cpp.language()))


def parse(data: bytes) -> Tree:
    """The tree of a file.  Damaged code has nodes of the type ``ERROR`` where it is not understood."""
    for pattern, group in (
        (_EXPORT_MACRO, 0),
        (_MACRO_OF_CLASS, 1),
        (_QT_MACRO, 0),
        (_QT_SLOTS, 1),
        (_POINT_MACRO, 0),
        (_MODULE_MACRO, 0),
    ):
        data = pattern.sub(lambda match, group=group: _blanked(match, group), data)  # type: ignore[misc]
    return _parser().parse(with_whole_branches(data))


def _blanked(match: re.Match[bytes], group: int) -> bytes:
    """The match with white space in place of a group, so that all places stay the same."""
    start, end = match.start(group) - match.start(), match.end(group) - match.start()
    return match[0][:start] + b" " * (end - start) + match[0][end:]


__all__ = ["parse"]
