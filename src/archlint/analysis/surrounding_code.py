"""What the code around a call shows: the statement it is in, whose node it works on, what runs once, what is constant.

For fixes, which must know more than a rule does: code that is moved has to mean the same where it comes to stand.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.kept import once, once_for_each_file
from archlint.place import Place
from archlint.syntax import facts
from archlint.syntax.parts import once_for
from archlint.syntax.tree import Tree
from archlint.syntax.walk import called_name

if TYPE_CHECKING:
    from archlint.model import NodeClass
    from archlint.systems.model import WorkspaceIndex

_MAKES_NODE = frozenset({"Node", "LifecycleNode", "create_node"})
_DECLARES_ITSELF = "automatically_declare_parameters_from_overrides"


@once_for_each_file
def tree_of(file_facts: facts.Facts) -> Tree:
    return Tree(file_facts)


def statement_before(tree: Tree, call: facts.Call) -> facts.Stmt | None:
    """The statement that holds a call, so that one put in front of it runs whenever the call does, and as often;
    None in loops, lambdas and comprehensions, in the head of a block, and in a class body."""
    statement: facts.Stmt | None = None
    for outer in tree.around(call):
        match outer:
            case facts.Function():
                return statement
            case facts.For() | facts.While() | facts.Lambda() | facts.Comprehension() | facts.Class():
                return None
            case facts.If() | facts.With() | facts.Try() | facts.Match() if statement is None:
                return None
            case (
                facts.Assign() | facts.Annotated() | facts.Augmented() | facts.Expression() | facts.Return()
                | facts.Raise() | facts.Delete() | facts.Assert()
            ) if statement is None:  # fmt: skip
                statement = outer
    return statement


# --------------------------------------------------------------------------------------------------------- nodes


def node_class_around(workspace: WorkspaceIndex, file: str, tree: Tree, at: facts.Base) -> NodeClass | None:
    """The class around a piece of code, if it is just an rclpy node: ``self`` is one there for certain, and what else
    it has can be seen."""
    cls = tree.class_around(at)
    return None if cls is None else _just_rclpy(workspace).get(Place.of(file, cls.name_span))


@once
def _just_rclpy(workspace: WorkspaceIndex) -> dict[Place, NodeClass]:
    """The classes that are just rclpy nodes, by where their names are written."""
    systems = (each for system in workspace.systems for each in (system, *(other for _, other in system.alternatives)))
    programs = {id(program): program for system in systems for program in system.programs}
    classes = [cls for program in programs.values() for node in program.nodes for cls in node.classes]
    others = {cls.place for cls in classes if not cls.just_rclpy}
    return {cls.place: cls for cls in classes if cls.place not in others}


def own_node(tree: Tree, node: facts.Expr, statement: facts.Stmt) -> bool:
    """Whether a node is ``self``, or one that the same function has just made: nobody else knows it yet."""
    name = node.dotted
    if name == "self":
        return not _has_declaring_calls(tree)
    function = tree.function_around(statement)
    values = [value for target, value in _assigned_in(tree, function) if target.dotted == name]
    return len(values) == 1 and _makes_node(values[0])


@once_for
def _has_declaring_calls(tree: Tree) -> bool:
    return any(_declares_itself(call) for call in tree.of_kind(facts.Call))


def _assigned_in(tree: Tree, function: facts.Function | None) -> Iterator[tuple[facts.Expr, facts.Expr]]:
    """What a function, or the module, sets by plain assignments, with the values."""
    for assignment in tree.of_kind(facts.Assign):
        if tree.function_around(assignment) is function:
            yield from ((target, assignment.value) for target in assignment.targets)


def _makes_node(value: facts.Expr) -> bool:
    match value:
        case facts.Call():
            return called_name(value) in _MAKES_NODE and not _declares_itself(value)
    return False


def _declares_itself(call: facts.Call) -> bool:
    return any(given.keyword == _DECLARES_ITSELF for given in call.args)


def maker_in_function(tree: Tree, client: str, statement: facts.Stmt) -> str | None:
    """The node, a plain name, that made a client: ``node`` for ``client = node.create_client(…)`` in the function
    around and ``ActionClient(node, …)``; None where it is set in another way, or several times."""
    function = tree.function_around(statement)
    values = [value for target, value in _assigned_in(tree, function) if target.dotted == client]
    match values:
        case [facts.Call(func=facts.Attribute(attr="create_client", value=facts.Name(id=node)))]:
            return node
        case [
            facts.Call(
                func=facts.Name(id="ActionClient"), args=[facts.Argument(value=facts.Name(id=node)) as node_, *_]
            )
        ]:
            return node if node_.keyword is None and not node_.star else None
    return None


def is_method(tree: Tree, function: facts.Function | None) -> bool:
    cls = None if function is None else tree.class_around(function)
    return cls is not None and any(function is member for member in cls.body)


def runs_once(tree: Tree, function: facts.Function | None) -> bool:
    """Whether a function runs once for each node: a constructor, what only a constructor calls and at one place,
    or one that is no method (which then makes the node that it works on)."""
    if function is None or function.name == "__init__":
        return True
    if not is_method(tree, function):
        return tree.class_around(function) is None
    uses = [attribute for attribute in tree.of_kind(facts.Attribute) if attribute.attr == function.name]
    if len(uses) != 1 or uses[0].value.dotted != "self":
        return False
    match tree.parent(uses[0]):
        case facts.Call(func=func) as call if func is uses[0]:
            caller = tree.function_around(call) if statement_before(tree, call) is not None else None
            return caller is not None and caller.name == "__init__"
    return False


# ----------------------------------------------------------------------------------------------------- constants


def as_code(expression: facts.Expr) -> str | None:
    """A text made of names, attributes and literals, in one form; None for anything that cannot be evaluated a line
    earlier."""
    match expression:
        case facts.Literal(value=value):
            return repr(value)
        case facts.Name() | facts.Attribute():
            return expression.dotted or None
        case facts.Binary(op="+", left=left, right=right):
            return _joined("+", left, right)
        case facts.FormatString(parts=parts):
            texts = [_part_as_code(part) for part in parts]
            return None if None in texts else f"f{texts}"
    return None


def _joined(op: str, left: facts.Expr, right: facts.Expr) -> str | None:
    texts = as_code(left), as_code(right)
    return None if None in texts else f"({texts[0]} {op} {texts[1]})"


def _part_as_code(part: str | facts.Field) -> str | None:
    match part:
        case facts.Field(value=value, conversion=conversion, spec=spec):
            text = as_code(value)
            return None if text is None else f"{{{text}!{conversion}:{spec}}}"
        case _:
            return repr(part)


def is_constant(tree: Tree, expression: facts.Expr, statement: facts.Stmt) -> bool:
    """Whether a plain expression has one and the same value whenever it is evaluated: literals, imported names, and
    names that the module or the class sets once."""
    match expression:
        case facts.Literal():
            return True
        case facts.Attribute():
            return _is_constant_attribute(tree, expression, statement)
        case facts.Name(id=name):
            return _is_constant_name(tree, name)
        case facts.Binary(left=left, right=right):
            return is_constant(tree, left, statement) and is_constant(tree, right, statement)
        case facts.FormatString(parts=parts):
            return all(part is None or is_constant(tree, part, statement) for part in map(_value_of_part, parts))
    return False


def _value_of_part(part: str | facts.Field) -> facts.Expr | None:
    match part:
        case facts.Field(value=value):
            return value
    return None


def _is_constant_name(tree: Tree, name: str) -> bool:
    binding = [fact for bound, fact in _bindings(tree) if bound == name]
    return len(binding) == 1 and any(binding[0] is statement for statement in tree.body)


def _bindings(tree: Tree) -> Iterator[tuple[str, facts.Base]]:
    """Each name that something binds anywhere in the file, with what does: the statement of a plain assignment."""
    yield from (
        ((statement.alias or statement.module).partition(".")[0], statement) for statement in tree.of_kind(facts.Import)
    )
    yield from ((bound, statement) for statement in tree.of_kind(facts.ImportFrom) for _, bound in statement.names)
    for holder, target in tree.stored:
        match target:
            case facts.Name(id=name):
                yield name, holder if _sets_alone(holder, target) else target
    yield from ((param.name, param) for param in tree.of_kind(facts.Param))
    yield from ((function.name, function) for function in tree.of_kind(facts.Function))
    yield from ((cls.name, cls) for cls in tree.of_kind(facts.Class))
    yield from ((name, statement) for statement in tree.of_kind(facts.Global) for name in statement.names)
    yield from ((handler.name, handler) for handler in tree.of_kind(facts.Handler) if handler.name)


def _sets_alone(holder: facts.Base, target: facts.Expr) -> bool:
    """Whether a statement is a plain assignment to a name, not one that takes a value apart."""
    match holder:
        case facts.Assign(targets=targets):
            return any(assigned is target for assigned in targets)
        case facts.Annotated():
            return True
    return False


def _is_constant_attribute(tree: Tree, expression: facts.Attribute, statement: facts.Stmt) -> bool:
    """``self.TOPIC`` or ``Robot.TOPIC`` of the class around, set once in its body; ``names.TOPIC`` of an import."""
    match expression.value:
        case facts.Attribute() as owner:
            return _is_constant_attribute(tree, owner, statement)
        case facts.Name(id=name):
            cls = tree.class_around(statement)
            if cls is not None and name in ("self", "cls", cls.name):
                return _is_set_once(tree, cls, expression.attr)
            return _is_constant_name(tree, name) and is_imported(tree, name)
    return False


def _is_set_once(tree: Tree, cls: facts.Class, name: str) -> bool:
    """Whether the body of a class sets a name, and neither another class nor an assignment to an attribute does."""
    in_body = 0
    for holder, target in tree.stored:
        match target:
            case facts.Attribute(attr=attr) if attr == name:
                return False
            case facts.Name(id=id_) if id_ == name:
                if any(outer is not cls for outer in tree.classes_around(target)):
                    return False
                in_body += tree.parent(holder) is cls and _sets_alone(holder, target)
    return in_body == 1


def is_imported(tree: Tree, name: str) -> bool:
    plain = ((statement.alias or statement.module).partition(".")[0] for statement in tree.of_kind(facts.Import))
    named = (bound for statement in tree.of_kind(facts.ImportFrom) for _, bound in statement.names)
    return name in plain or name in named
