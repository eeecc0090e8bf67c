"""Where the code of a C++ file cannot be right, or creates something and was not understood.

The grammar goes on behind what it does not understand, and most of that is good code: macros, attributes, extensions
of compilers.  So it is told only where brackets do not match, where nothing but a slip is left (``slips.py``), and
where a create call or a class of a node stands in code of which nothing was kept.
"""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.syntax import facts
from archlint.syntax.cpp.calls import GENERIC, METHODS
from archlint.syntax.cpp.macro_heads import macro_in_front
from archlint.syntax.cpp.preprocessor import with_whole_branches
from archlint.syntax.cpp.slips import slip_in
from archlint.syntax.facts import FileProblem
from archlint.syntax.parts import everything_in
from archlint.workspace.merge_marks import UNMERGED, merge_in

if TYPE_CHECKING:
    from tree_sitter import Node

    from archlint.syntax.cpp.source import SourceText

_NAMES = frozenset({"identifier", "field_identifier", "namespace_identifier", "type_identifier"})
_STATEMENTS = ("_statement", "declaration", "_definition", "translation_unit")
_DEFINITIONS = ("function_definition", "lambda_expression")
_SCOPES = frozenset({"translation_unit", "declaration_list", "field_declaration_list"})
_NODE = re.compile(rb"\b(?:Lifecycle)?Node\b")
_CREATES = re.compile(rb"\b(?:" + "|".join(sorted({*METHODS, *GENERIC})).encode() + rb")\b")
_CREATED = frozenset({name for name, *_ in METHODS.values()} | {*GENERIC, *GENERIC.values()})
_TOKEN = re.compile(
    rb"""//(?:\\\r?\n|[^\n])*|/\*.*?(?:\*/|\Z)|R"(?P<mark>[^()\\\s]{0,16})\(.*?(?:\)(?P=mark)"|\Z)"""
    rb"""|"(?:[^"\\\n]|\\.)*"?|(?<=[0-9A-Fa-f])'(?=[0-9A-Fa-f])|'(?:[^'\\\n]|\\.)*'?"""
    rb"""|^[ \t]*\#[ \t]*define\b(?:\\\r?\n|[^\n])*|[()\[\]{}]""",
    re.DOTALL | re.MULTILINE,
)
_CLOSES = {b")": b"(", b"]": b"[", b"}": b"{"}
_SCOPE = re.compile(rb"\b(?:namespace\b[\w:\s]*|extern\s*\"C\"\s*)\Z")
_CLASS = re.compile(rb"\b(?:class|struct)\s[^;{}()]*\Z")
_HEAD = 300
"""Bytes in front of a bracket in which it is looked for what it opens."""


def problems_of(source: SourceText, root: Node, body: Sequence[facts.Stmt]) -> list[FileProblem]:
    """What is to be told of a file whose tree has errors."""
    if not root.has_error:
        return []
    merge = merge_in(source.data.decode("latin-1")) if b"<<<<<<< " in source.data else None
    if merge is not None:
        return [_problem(source, merge, f"{UNMERGED}: it does not compile", partly=False)]
    bracket = _bracket_without_partner(with_whole_branches(source.data))
    if bracket is not None:
        start, what = bracket
        return [_problem(source, start, f"'{chr(source.data[start])}' {what}", partly=False)]
    slip = slip_in(root, source.data)
    if slip is not None:
        return [_problem(source, slip[0], f"{slip[1]}: this does not compile", partly=False)]
    missing = sorted({*_lost_calls(source, root, body), *_lost_classes(source, root)})
    if not missing:
        return []
    (start, what), *others = missing
    more = f" ({len(others)} more of this file, too)" if others else ""
    return [_problem(source, start, f"{what} is missing from the graph{more}: the code there is not understood")]


def _problem(source: SourceText, start: int, message: str, partly: bool = True) -> FileProblem:
    before = source.data[:start]
    column = len(before.rpartition(b"\n")[2].decode("utf-8", "replace")) + 1
    return FileProblem(before.count(b"\n") + 1, column, message, partly=partly)


def _bracket_without_partner(code: bytes) -> tuple[int, str] | None:
    """Where a bracket is that nothing closes, or that closes nothing, in words; None where all have a partner.

    What a header opens a source may close: nothing is said of the bracket of a namespace, as long as those of the
    classes in it are closed as classes are, with a semicolon, and nothing of one that closes something else.
    """
    waiting: list[tuple[bytes, int]] = []
    doubtful: int | None = None
    for match in _TOKEN.finditer(code):
        token = match[0]
        if token in _CLOSES.values():
            waiting.append((token, match.start()))
        elif token in _CLOSES:
            after = code[match.end() : match.end() + _HEAD].lstrip()[:1]
            if not waiting and (token != b"}" or after == b";"):
                return match.start(), "closes nothing"
            opening, start = waiting.pop() if waiting else (_CLOSES[token], 0)
            if opening != _CLOSES[token]:
                return start, "is never closed"
            if token == b"}" and doubtful is None and after in _NEVER_BEHIND_CLASSES:
                doubtful = start if _CLASS.search(_head(code, start)) else None
    others = [start for _, start in waiting if not _SCOPE.search(_head(code, start))]
    last = others[-1] if others else doubtful if waiting else None
    return None if last is None else (last, "is never closed")


_NEVER_BEHIND_CLASSES = (b"", b"}", b"/", b"#")


def _head(code: bytes, start: int) -> bytes:
    return code[max(0, start - _HEAD) : start]


def _lost_calls(source: SourceText, root: Node, body: Sequence[facts.Stmt]) -> Iterator[tuple[int, str]]:
    """The create calls in code that was not understood, of which nothing was kept."""
    known = sorted(call.span for call in everything_in(body, facts.Call) if call.func.last_name in _CREATED)
    starts = [span[:2] for span in known]
    for match in _CREATES.finditer(source.data):
        name = root.descendant_for_byte_range(*match.span())
        if name is None or name.type not in _NAMES or (name.parent and name.parent.type == "function_declarator"):
            continue
        if _is_outside(name):
            yield match.start(), f"the call of {match[0].decode()}"
        if not _is_damaged(name):
            continue
        line, column, *_ = source.span(name)
        last = bisect_right(starts, (line, column))
        if not any((line, column) <= span[2:] for span in known[max(0, last - _NESTED) : last]):
            yield match.start(), f"the call of {match[0].decode()}"


_NESTED = 10
"""As many calls that begin in front of a place are looked at: one of them is around it, or none."""


def _is_outside(name: Node) -> bool:
    """Whether a name stands in a statement outside of all functions, where C++ has none but the braces of a function
    whose head a macro writes."""
    node = name
    while node.parent is not None and not node.type.endswith(_DEFINITIONS):
        if node.type.endswith("_statement") and node.parent.type in _SCOPES:
            return macro_in_front(node) is None
        node = node.parent
    return False


def _is_damaged(name: Node) -> bool:
    """Whether the statement that a name stands in has an error, or is one."""
    node: Node | None = name
    while node is not None and not node.type.endswith(_STATEMENTS):
        if node.type == "ERROR":
            return True
        node = node.parent
    return node is not None and (node.has_error or (node.parent is not None and node.parent.type == "ERROR"))


def _lost_classes(source: SourceText, root: Node) -> Iterator[tuple[int, str]]:
    """The heads of classes that derive from a node and have no body that was understood."""
    waiting = [root]
    while waiting:
        node = waiting.pop()
        if node.type == "ERROR":
            for before, bases in zip(node.named_children, node.named_children[1:], strict=False):
                if bases.type == "base_class_clause" and _NODE.search(bases.text or b""):
                    yield before.start_byte, f"the class {source.text(before)}"
            for parameter in node.named_children:
                if parameter.type == "parameter_declaration":
                    yield from _class_as_type(source, parameter)
        waiting += [child for child in node.named_children if child.has_error]


def _class_as_type(source: SourceText, parameter: Node) -> Iterator[tuple[int, str]]:
    """The class of a node that is defined as the type of a parameter, which C++ does not have: behind ``template <``
    without an end all that follows is taken for parameters."""
    cls = parameter.child_by_field_name("type")
    name = None if cls is None else cls.child_by_field_name("name")
    if cls is None or name is None:
        return
    for bases in cls.named_children:
        if bases.type == "base_class_clause" and _NODE.search(bases.text or b""):
            yield name.start_byte, f"the class {source.text(name)}"


__all__ = ["problems_of"]
