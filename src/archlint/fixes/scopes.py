"""What Python's tree shows of the surroundings of a call: its statement, what runs once, what is constant."""

from __future__ import annotations

import ast
import re
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from archlint.fixes.source import Source

Elsewhere = Callable[[], str]
"""The text of the other files of the package, read when it is asked for."""
Function = ast.FunctionDef | ast.AsyncFunctionDef

_NODE_BASES = frozenset({"Node", "LifecycleNode"})
_HARMLESS_BASES = frozenset({"ABC", "object"})
_MAKES_NODE = frozenset({"Node", "LifecycleNode", "create_node"})
_REPEATED = (ast.For, ast.AsyncFor, ast.While, ast.Lambda, ast.ListComp, ast.SetComp, ast.DictComp, ast.GeneratorExp)


def statement_before(source: Source, call: ast.Call) -> ast.stmt | None:
    """The statement that holds a call, so that one put in front of it runs whenever the call does, and as often;
    None in loops, lambdas and comprehensions, in the head of a block, and in a class body."""
    node: ast.AST = call
    statement: ast.stmt | None = None
    while node in source.parents:
        node = source.parents[node]
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.Module)):
            return statement
        if isinstance(node, (*_REPEATED, ast.ClassDef)):
            return None
        if isinstance(node, ast.stmt) and statement is None:
            if hasattr(node, "body") or isinstance(node, ast.Match):
                return None
            statement = node
    return None


def enclosing_function(source: Source, node: ast.AST) -> Function | None:
    """The innermost function around; None at the level of the module."""
    while node in source.parents:
        node = source.parents[node]
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            return node
    return None


def enclosing_class(source: Source, node: ast.AST) -> ast.ClassDef | None:
    while node in source.parents:
        node = source.parents[node]
        if isinstance(node, ast.ClassDef):
            return node
    return None


def block_of(source: Source, statement: ast.stmt) -> list[ast.stmt]:
    """The statement and those that follow it in its block."""
    parent = source.parents[statement]
    for name in ("body", "orelse", "finalbody"):
        block = getattr(parent, name, None)
        if isinstance(block, list) and statement in block:
            return block[block.index(statement) :]
    return [statement]


# --------------------------------------------------------------------------------------------------------- nodes


def is_node(source: Source, node: ast.expr, statement: ast.stmt, elsewhere: Elsewhere | None = None) -> bool:
    """Whether ``self`` is certainly a node, whose other parameters can be seen, here or ``elsewhere``; others must
    be, to create something."""
    if not _is_self(node):
        return True
    cls = enclosing_class(source, statement)
    return cls is not None and _is_plain_node(source, cls, set(), elsewhere)


def _is_self(node: ast.expr) -> bool:
    return isinstance(node, ast.Name) and node.id == "self"


def _is_plain_node(source: Source, cls: ast.ClassDef, seen: set[str], elsewhere: Elsewhere | None) -> bool:
    """Whether a class derives from rclpy's node, and from nothing else that is not in this file or ``elsewhere``."""
    found = False
    for base in cls.bases:
        name = base.attr if isinstance(base, ast.Attribute) else getattr(base, "id", "")
        local = _class_of(source, name)
        if name in _NODE_BASES and local is None:
            found = True
        elif local is not None and name not in seen:
            if not _is_plain_node(source, local, {*seen, name}, elsewhere) and local.bases:
                return False
            found = found or bool(local.bases)
        elif name not in _HARMLESS_BASES:
            if elsewhere is None or not _is_ours(source, name) or not _derives_plainly(name, elsewhere(), seen):
                return False
            found = True
    return found


def _is_ours(source: Source, name: str) -> bool:
    """Whether a class is imported from the package that the file is in."""
    folders = Path(source.file).resolve().parts[:-1]
    return any(
        (alias.asname or alias.name) == name and (one.level or (one.module or "").partition(".")[0] in folders)
        for one in source.of_kind(ast.ImportFrom)
        for alias in one.names
    )


def _derives_plainly(name: str, text: str, seen: set[str]) -> bool:
    """Whether a text defines a class of that name once, and it derives from rclpy's node and nothing unseen."""
    heads = re.findall(rf"^class {re.escape(name)}\(([^()]*)\):", text, re.MULTILINE)
    if len(heads) != 1 or name in seen:
        return False
    bases = [base.strip().rpartition(".")[2] for base in heads[0].split(",") if base.strip()]
    return not _NODE_BASES.isdisjoint(bases) and _NODE_BASES.union(_HARMLESS_BASES).issuperset(bases)


def has_base_elsewhere(source: Source, node: ast.expr, statement: ast.stmt) -> bool:
    """Whether ``self`` is a node only by a class of another file, which may declare parameters, too."""
    return _is_self(node) and not is_node(source, node, statement)


def _class_of(source: Source, name: str) -> ast.ClassDef | None:
    return next((one for one in source.of_kind(ast.ClassDef) if one.name == name), None)


def own_node(source: Source, node: ast.expr, statement: ast.stmt) -> bool:
    """Whether a node is ``self``, or one that the same function has just made: nobody else knows it yet."""
    if _is_self(node):
        return "automatically_declare_parameters_from_overrides" not in source.text
    function = enclosing_function(source, statement)
    made = 0
    for one in source.of_kind(ast.Assign):
        if enclosing_function(source, one) is not function:
            continue
        for target in one.targets:
            if ast.unparse(target) == ast.unparse(node):
                made += 1 if _makes_node(one.value) else 2
    return made == 1


def _makes_node(value: ast.expr) -> bool:
    if not isinstance(value, ast.Call):
        return False
    function = value.func
    name = function.attr if isinstance(function, ast.Attribute) else getattr(function, "id", "")
    return name in _MAKES_NODE and not any(
        one.arg == "automatically_declare_parameters_from_overrides" for one in value.keywords
    )


def maker_in_function(source: Source, client: ast.Name, statement: ast.stmt) -> str | None:
    """The node, a plain name, that made a client: ``node`` for ``client = node.create_client(…)`` in the function
    around and ``ActionClient(node, …)``; None where it is set in another way, or several times."""
    function = enclosing_function(source, statement)
    values = [
        one.value
        for one in source.of_kind(ast.Assign)
        if enclosing_function(source, one) is function
        and any(isinstance(target, ast.Name) and target.id == client.id for target in one.targets)
    ]
    made = values[0] if len(values) == 1 else None
    if not isinstance(made, ast.Call):
        return None
    maker: ast.expr | None = None
    if isinstance(made.func, ast.Attribute) and made.func.attr == "create_client":
        maker = made.func.value
    elif isinstance(made.func, ast.Name) and made.func.id == "ActionClient" and made.args:
        maker = made.args[0]
    return maker.id if isinstance(maker, ast.Name) else None


def runs_once(source: Source, function: Function | None) -> bool:
    """Whether a function runs once for each node: a constructor, what only a constructor calls and at one place,
    or one that is no method (which then makes the node that it works on)."""
    if function is None or function.name == "__init__":
        return True
    if not isinstance(source.parents.get(function), ast.ClassDef):
        return enclosing_class(source, function) is None
    uses = [one for one in source.of_kind(ast.Attribute) if one.attr == function.name]
    if len(uses) != 1 or source.text.count(function.name) != 2:
        return False
    call = source.parents.get(uses[0])
    if not isinstance(call, ast.Call) or call.func is not uses[0] or ast.unparse(uses[0].value) != "self":
        return False
    statement = statement_before(source, call)
    caller = None if statement is None else enclosing_function(source, statement)
    return caller is not None and caller.name == "__init__"


def is_other_method(source: Source, function: Function | None) -> bool:
    """Whether a function is a method that a derived class may call with other arguments."""
    in_class = function is not None and isinstance(source.parents.get(function), ast.ClassDef)
    return in_class and function is not None and function.name != "__init__"


# ----------------------------------------------------------------------------------------------------- constants


def is_plain(expression: ast.expr) -> bool:
    """Whether an expression is a text made of names, attributes and literals: it can be evaluated a line earlier."""
    return all(
        isinstance(
            one,
            (
                ast.Constant,
                ast.Name,
                ast.Attribute,
                ast.JoinedStr,
                ast.FormattedValue,
                ast.BinOp,
                ast.Add,
                ast.expr_context,
            ),
        )
        for one in ast.walk(expression)
    )


def is_constant(source: Source, expression: ast.expr, statement: ast.stmt) -> bool:
    """Whether a plain expression has one and the same value whenever it is evaluated: literals, imported names, and
    names that the module or the class sets once."""
    if isinstance(expression, ast.Constant):
        return True
    if isinstance(expression, ast.Attribute):
        return _is_constant_attribute(source, expression, statement)
    if isinstance(expression, ast.Name):
        return _is_constant_name(source, expression.id, statement)
    return all(
        is_constant(source, one, statement)
        for one in ast.iter_child_nodes(expression)
        if isinstance(one, (ast.Constant, ast.Name, ast.Attribute, ast.JoinedStr, ast.BinOp, ast.FormattedValue))
    )


def _is_constant_name(source: Source, name: str, statement: ast.stmt) -> bool:
    assert source.tree is not None
    bound = [one for one in _bindings(source.tree) if one[0] == name]
    return len(bound) == 1 and source.parents.get(bound[0][1]) is source.tree


def _bindings(tree: ast.Module) -> Iterator[tuple[str, ast.AST]]:
    """Each name that something binds anywhere in the file, with the statement or argument that does."""
    alone: set[ast.expr] = set()
    for node in ast.walk(tree):  # from the outside in: an assignment comes before its targets
        if isinstance(node, (ast.Import, ast.ImportFrom)):
            yield from (((alias.asname or alias.name).partition(".")[0], node) for alias in node.names)
        elif isinstance(node, (ast.Assign, ast.AnnAssign)):
            targets = node.targets if isinstance(node, ast.Assign) else [node.target]
            alone.update(targets)
            yield from ((target.id, node) for target in targets if isinstance(target, ast.Name))
        elif isinstance(node, ast.arg):
            yield node.arg, node
        elif isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)):
            yield node.name, node
        elif isinstance(node, (ast.Global, ast.Nonlocal)):
            yield from ((name, node) for name in node.names)
        elif isinstance(node, ast.ExceptHandler) and node.name:
            yield node.name, node
        elif isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store) and node not in alone:
            yield node.id, node  # in a loop, with, unpacking, := or +=


def _is_constant_attribute(source: Source, expression: ast.Attribute, statement: ast.stmt) -> bool:
    """``self.TOPIC`` or ``Robot.TOPIC`` of the class around, set once in its body; ``names.TOPIC`` of an import."""
    owner = expression.value
    if not isinstance(owner, ast.Name):
        return isinstance(owner, ast.Attribute) and _is_constant_attribute(source, owner, statement)
    cls = enclosing_class(source, statement)
    if cls is None or owner.id not in ("self", "cls", cls.name):
        return _is_constant_name(source, owner.id, statement) and is_imported(source, owner.id)
    bound = [
        one
        for one in source.of_kind(ast.Attribute)
        if one.attr == expression.attr and not isinstance(one.ctx, ast.Load)
    ]
    in_body = [
        one
        for one in cls.body
        if isinstance(one, (ast.Assign, ast.AnnAssign))
        and any(
            isinstance(target, ast.Name) and target.id == expression.attr
            for target in (one.targets if isinstance(one, ast.Assign) else [one.target])
        )
    ]
    return (
        not bound
        and len(in_body) == 1
        and not any(
            isinstance(one, ast.Name) and one.id == expression.attr and isinstance(one.ctx, ast.Store)
            for other in source.of_kind(ast.ClassDef)
            if other is not cls
            for one in ast.walk(other)
        )
    )


def is_imported(source: Source, name: str) -> bool:
    imports: list[ast.Import | ast.ImportFrom] = [*source.of_kind(ast.Import), *source.of_kind(ast.ImportFrom)]
    return any((alias.asname or alias.name).partition(".")[0] == name for one in imports for alias in one.names)
