"""A Python file with what the choice of sites asks of it.  It is read with ``ast``, not with archlint: what
archlint does not see is planted all the same."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cached_property

Function = ast.FunctionDef | ast.AsyncFunctionDef


@dataclass(frozen=True)
class Edit:
    """Replace the bytes from ``start`` to ``end`` of a file."""

    file: str
    start: int
    end: int
    text: bytes


@dataclass(frozen=True)
class Lines:
    """Where a finding is expected: lines of a file, both included."""

    file: str
    first: int
    last: int


@dataclass(eq=False)
class PythonSource:
    file: str
    data: bytes
    tree: ast.Module
    parents: dict[ast.AST, ast.AST] = field(default_factory=dict)

    @classmethod
    def of(cls, file: str, data: bytes) -> PythonSource | None:
        try:
            data.decode("utf-8")
            tree = ast.parse(data)
        except (SyntaxError, ValueError, RecursionError):
            return None
        made = cls(file, data, tree)
        for parent in ast.walk(tree):
            for child in ast.iter_child_nodes(parent):
                made.parents[child] = parent
        return made

    @property
    def is_launch(self) -> bool:
        return b"generate_launch_description" in self.data

    @cached_property
    def starts(self) -> list[int]:
        """Offset of each line."""
        found = [0]
        for line in self.data.splitlines(keepends=True):
            found.append(found[-1] + len(line))
        return found

    @cached_property
    def calls(self) -> list[ast.Call]:
        found = [node for node in ast.walk(self.tree) if isinstance(node, ast.Call)]
        return sorted(found, key=lambda call: (call.lineno, call.col_offset))

    @cached_property
    def imported(self) -> dict[str, tuple[str, str]]:
        """Local name to module and name, of ``from module import name``."""
        found: dict[str, tuple[str, str]] = {}
        for node in ast.walk(self.tree):
            if isinstance(node, ast.ImportFrom) and node.module and not node.level:
                found.update({alias.asname or alias.name: (node.module, alias.name) for alias in node.names})
        return found

    def offsets(self, node: ast.expr | ast.stmt) -> tuple[int, int]:
        assert node.end_lineno is not None and node.end_col_offset is not None
        return (
            self.starts[node.lineno - 1] + node.col_offset,
            self.starts[node.end_lineno - 1] + node.end_col_offset,
        )

    def text(self, node: ast.expr | ast.stmt) -> bytes:
        start, end = self.offsets(node)
        return self.data[start:end]

    def replaced(self, node: ast.expr | ast.stmt, text: str) -> Edit:
        """Put other text in the place of a node; no line below it moves."""
        start, end = self.offsets(node)
        new = text.encode()
        missing = self.data[start:end].count(b"\n") - new.count(b"\n")
        if missing > 0:
            new = b"(" + new + b"\n" * missing + b")"
        return Edit(self.file, start, end, new)

    def inserted(self, at: int, text: str) -> Edit:
        return Edit(self.file, at, at, text.encode())

    def lines(self, node: ast.expr | ast.stmt) -> Lines:
        return Lines(self.file, node.lineno, node.end_lineno or node.lineno)

    def around(self, node: ast.AST, kind: type[ast.AST] | tuple[type[ast.AST], ...]) -> ast.AST | None:
        """The innermost ancestor of a kind."""
        above = self.parents.get(node)
        while above is not None and not isinstance(above, kind):
            above = self.parents.get(above)
        return above

    def class_of(self, node: ast.AST) -> ast.ClassDef | None:
        found = self.around(node, ast.ClassDef)
        return found if isinstance(found, ast.ClassDef) else None

    def method(self, cls: ast.ClassDef | None, name: str) -> Function | None:
        for item in cls.body if cls is not None else ():
            if isinstance(item, (ast.FunctionDef, ast.AsyncFunctionDef)) and item.name == name:
                return item
        return None

    def with_import(self, statement: str) -> Edit | None:
        """An import before the first one of the module, on its line."""
        for node in self.tree.body:
            if isinstance(node, (ast.Import, ast.ImportFrom)) and getattr(node, "module", "") != "__future__":
                return self.inserted(self.offsets(node)[0], f"{statement}; ")
        return None


def called(call: ast.Call) -> str:
    """The last word of what is called."""
    function = call.func
    if isinstance(function, ast.Attribute):
        return function.attr
    return function.id if isinstance(function, ast.Name) else ""


def argument(call: ast.Call, position: int, *names: str) -> ast.expr | None:
    """An argument by position or name."""
    for keyword in call.keywords:
        if keyword.arg in names:
            return keyword.value
    given = call.args[: position + 1]
    if any(isinstance(one, ast.Starred) for one in given) or len(given) <= position:
        return None
    return given[position]


def literal(node: ast.expr | None) -> str | None:
    """The text of a plain one-line string literal."""
    plain = isinstance(node, ast.Constant) and isinstance(node.value, str) and node.lineno == node.end_lineno
    return node.value if plain and isinstance(node, ast.Constant) and isinstance(node.value, str) else None


def own_attribute(node: ast.expr | None) -> str | None:
    """``name`` of ``self.name``."""
    of_self = isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and node.value.id == "self"
    return node.attr if of_self and isinstance(node, ast.Attribute) else None


def misspelt(word: str) -> str | None:
    """A word with another letter in the middle of its longest part; None where it has no letters."""
    best: tuple[int, int] | None = None
    start = 0
    for at in range(len(word) + 1):
        if at == len(word) or not word[at].isalpha():
            if at > start and (best is None or at - start > best[1] - best[0]):
                best = (start, at)
            start = at + 1
    if best is None:
        return None
    middle = (best[0] + best[1]) // 2
    other = "x" if word[middle] in "qQ" else "Q" if word[middle].isupper() else "q"
    return word[:middle] + other + word[middle + 1 :]


def misspelt_literal(source: PythonSource, node: ast.expr) -> Edit | None:
    """The same for a string literal, its last part if it is a path."""
    text = literal(node)
    head, slash, last = (text or "").rpartition("/")
    wrong = misspelt(last)
    written = source.text(node).decode()
    if text is None or wrong is None or text not in written:
        return None
    return source.replaced(node, written.replace(text, head + slash + wrong))


def in_order(nodes: Iterator[ast.expr]) -> list[ast.expr]:
    return sorted(nodes, key=lambda node: (node.lineno, node.col_offset))
