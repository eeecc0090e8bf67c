"""NME001: take a name from a parameter whose default is the name as it was."""

from __future__ import annotations

import ast
import re
from typing import TYPE_CHECKING

from archlint.finding import Edit, Fix

if TYPE_CHECKING:
    from archlint.finding import Finding
    from archlint.fixes.source import Source

_KIND = {
    "create_publisher": "topic",
    "create_lifecycle_publisher": "topic",
    "create_subscription": "topic",
    "create_client": "service",
    "create_service": "service",
    "ActionClient": "action",
    "ActionServer": "action",
}


def declare_parameter(finding: Finding, source: Source) -> Fix | None:
    """Declare a parameter in front of the create call and read the name from it.

    Only in a constructor, where it is declared once, and only for a name that is written in the call.
    """
    literal = source.node_at(finding.place, ast.Constant)
    if not isinstance(literal, ast.Constant) or not isinstance(literal.value, str):
        return None
    call = source.parents.get(literal)
    if isinstance(call, ast.keyword):
        call = source.parents.get(call)
    if not isinstance(call, ast.Call):
        return None
    node, kind = _node_and_kind(call)
    statement = _statement(source, call)
    if node is None or statement is None:
        return None
    line = source.line(statement.lineno)
    indent = line[: len(line) - len(line.lstrip())]
    at = source.span(statement)[0]
    if source.text[at - len(indent) : at] != indent or line[: len(indent)].strip():
        return None
    name = _free_name(source, literal.value, kind)
    receiver = ast.unparse(node)
    old = source.text[slice(*source.span(literal))]
    lines = (
        f"{receiver}.declare_parameter('{name}', {old}){source.newline}{indent}"
        f"{name} = {receiver}.get_parameter('{name}').value{source.newline}{indent}"
    )
    edits = (Edit(source.place(at, at), lines), Edit(source.place(*source.span(literal)), name))
    return Fix("unsafe", edits, f"take the name from the parameter '{name}'")


def _node_and_kind(call: ast.Call) -> tuple[ast.expr | None, str]:
    """The node that a create call is made on, where it is a plain name such as ``self`` or ``self.node``."""
    function = call.func
    name = function.attr if isinstance(function, ast.Attribute) else getattr(function, "id", "")
    if name not in _KIND:
        return None, ""
    node: ast.expr | None = None
    if _KIND[name] == "action":
        node = call.args[0] if call.args else None
    elif isinstance(function, ast.Attribute):
        node = function.value
    plain = isinstance(node, ast.Name) or (isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name))
    return (node if plain else None), _KIND[name]


def _statement(source: Source, call: ast.Call) -> ast.stmt | None:
    """The statement of a constructor that holds the call; None in loops, nested functions and comprehensions."""
    node: ast.AST = call
    statement: ast.stmt | None = None
    while node in source.parents:
        node = source.parents[node]
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            return statement if node.name == "__init__" else None
        if isinstance(node, (ast.For, ast.AsyncFor, ast.While, ast.Lambda, ast.comprehension, ast.ListComp)):
            return None
        if isinstance(node, ast.stmt) and statement is None:
            if isinstance(node, (ast.If, ast.With, ast.Try)):
                return None
            statement = node
    return None


def _free_name(source: Source, topic: str, kind: str) -> str:
    """A name for the parameter and the variable that the file does not use yet: of the last part of the topic,
    else of the last two, and so on."""
    parts = [re.sub(r"\W+", "_", part).strip("_").lower() for part in topic.split("/")]
    parts = [part for part in parts if part] or [kind]
    names = [_base("_".join(parts[-count:]), kind) for count in range(1, len(parts) + 1)]
    names += [f"{names[0]}_{number}" for number in range(2, 1_000)]
    name = next(one for one in names if one not in source.taken and not _used(one, source))
    source.taken.add(name)
    return name


def _base(words: str, kind: str) -> str:
    base = words if words.endswith(kind) else f"{words}_{kind}"
    return base if base[0].isalpha() else f"{kind}_{words}"


def _used(name: str, source: Source) -> bool:
    """Whether the file uses a name as a variable or in a text; attributes are in nobody's way."""
    return re.search(rf"(?<![\w.]){name}\b", source.text) is not None
