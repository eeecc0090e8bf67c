"""Python that is written differently and means the same, with where each line has gone."""

from __future__ import annotations

import ast
import io
import tokenize
from collections import Counter
from collections.abc import Mapping, Sequence

Lines = Mapping[int, int]
"""The line of now, by the line before; both from 1."""


def spaced(text: str, every: int) -> tuple[str, Lines]:
    """With an empty line and a comment before each ``every``-th line that begins a statement, and comments behind."""
    lines = text.splitlines(keepends=True)
    starts = [line for line in _statement_starts(text) if line % every == 0]
    made: list[str] = []
    now: dict[int, int] = {}
    for number, line in enumerate(lines, 1):
        if number in starts:
            made += ["\n", "    # said here\n"]
        made.append(line)
        now[number] = len(made)
    return "".join(made), now


def _statement_starts(text: str) -> list[int]:
    """The lines on which a logical line begins that has a statement; not those behind a decorator."""
    starts: list[int] = []
    fresh = True
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type == tokenize.NEWLINE:
            fresh = True
        elif fresh and token.type not in (
            tokenize.NL,
            tokenize.COMMENT,
            tokenize.INDENT,
            tokenize.DEDENT,
            tokenize.ENDMARKER,
        ):
            starts.append(token.start[0])
            fresh = False
    return starts


def renamed(text: str) -> str:
    """With another name for each local variable of a function that nothing else could mean."""
    tree = ast.parse(text)
    lines = text.encode().splitlines(keepends=True)
    edits: list[tuple[int, int, str]] = []
    taken = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name)}
    for function in _outermost_functions(tree):
        edits += [edit for name in _own_locals(function) for edit in _uses(function, name, _free(name, taken))]
    for line, column, name in sorted(edits, reverse=True):
        row = lines[line - 1]
        end = column + len(name.encode()) - len(_SUFFIX)
        lines[line - 1] = row[:column] + name.encode() + row[end:]
    return b"".join(lines).decode()


_SUFFIX = "_too"


def _free(name: str, taken: set[str]) -> str:
    return name if name + _SUFFIX in taken else name + _SUFFIX


def _outermost_functions(tree: ast.AST) -> list[ast.FunctionDef]:
    """Functions and methods that lie in no other function, and have none inside."""
    found = [node for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)]
    scopes = (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda, ast.ClassDef)
    return [one for one in found if not any(isinstance(node, scopes) for node in ast.walk(one) if node is not one)]


def _own_locals(function: ast.FunctionDef) -> list[str]:
    nodes = list(ast.walk(function))
    if any(isinstance(node, (ast.Global, ast.Nonlocal, ast.Import, ast.ImportFrom, ast.MatchAs)) for node in nodes):
        return []
    calls = {node.func.id for node in nodes if isinstance(node, ast.Call) and isinstance(node.func, ast.Name)}
    in_texts = {
        part.id
        for node in nodes
        if isinstance(node, ast.JoinedStr)
        for part in ast.walk(node)
        if isinstance(part, ast.Name)
    }
    given = {node.arg for node in nodes if isinstance(node, ast.arg)}
    caught = {node.name for node in nodes if isinstance(node, ast.ExceptHandler)}
    if calls & {"locals", "vars", "eval", "exec", "dir", "globals"}:
        return []
    names = Counter(node.id for node in nodes if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store))
    return sorted(name for name in names if name not in given | caught | in_texts and not name.startswith("__"))


def _uses(function: ast.FunctionDef, name: str, new: str) -> list[tuple[int, int, str]]:
    if name == new:
        return []
    nodes = [node for node in ast.walk(function) if isinstance(node, ast.Name) and node.id == name]
    return [(node.lineno, node.col_offset, new) for node in nodes]


def reordered(text: str) -> tuple[str, Lines]:
    """With the methods of each class the other way around, where nothing else stands between them."""
    lines = text.splitlines(keepends=True)
    order = list(range(1, len(lines) + 1))
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.ClassDef) and (blocks := _movable(node)):
            moved = [line for block in reversed(blocks) for line in block]
            order[blocks[0][0] - 1 : blocks[-1][-1]] = moved
    if not lines or not lines[-1].endswith("\n"):
        return text, {line: line for line in order}
    return "".join(lines[line - 1] for line in order), {line: number for number, line in enumerate(order, 1)}


def _movable(node: ast.ClassDef) -> Sequence[Sequence[int]]:
    """The lines of each method, with what stands between it and the next one."""
    methods = [part for part in node.body if isinstance(part, (ast.FunctionDef, ast.AsyncFunctionDef))]
    last = node.body[-len(methods) :] if methods else []
    plain = last == methods and not any(method.decorator_list or method.args.defaults for method in methods)
    nested = any(isinstance(part, ast.ClassDef) for part in ast.walk(node) if part is not node)
    if len(methods) < 2 or not plain or nested or len({method.name for method in methods}) < len(methods):
        return ()
    starts = [method.lineno for method in methods]
    ends = [*(start - 1 for start in starts[1:]), methods[-1].end_lineno or starts[-1]]
    return [range(start, end + 1) for start, end in zip(starts, ends, strict=True)]
