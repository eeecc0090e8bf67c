"""Nodes that escape: whoever has one may create, declare and spin what nobody here can see.

Reading an attribute of a node, calling its methods and calling what is followed are no escapes.  Everything else that
lets a node escape is one, for the node itself and for whatever holds it: a container, an object that keeps it,
a partial.  An object that has escaped once takes along what is put into it later.

What all code of a module can reach (its variables, attributes of its classes, containers that it makes once) is no
escape by itself: only where a function that the program is not seen to call uses it (:func:`settle`).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from archlint.finding import Place
from archlint.interpreter import growing
from archlint.interpreter.values import (
    ENTRIES,
    ITEMS,
    ApiMethod,
    BoundMethod,
    ClassValue,
    DictValue,
    External,
    FunctionValue,
    Instance,
    ListValue,
    ModuleValue,
    OneOf,
    Partial,
    Unknown,
    Value,
)
from archlint.libraries.rclpy import escaped_functions, nodes, threads
from archlint.libraries.rclpy import names as rclpy_names
from archlint.libraries.state import Escape, Root, Shared
from archlint.libraries.uses import class_variables, unseen_use, variables
from archlint.libraries.values import ExecutorValue, NodeValue
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint import model
    from archlint.interpreter.modules import Module
    from archlint.libraries.run import Run

_CARRIERS = (
    Instance,
    NodeValue,
    ListValue,
    DictValue,
    OneOf,
    Partial,
    ApiMethod,
    FunctionValue,
    BoundMethod,
    ExecutorValue,
    ClassValue,
)
"""Kinds of values that can lead to a node."""
_OWN = (
    *("rclpy.", "tf2_", "message_filters.", "logging.", "types.SimpleNamespace", "argparse.Namespace"),
    *("rclcpp.AsyncParametersClient", "rclcpp.SyncParametersClient", "rclcpp.ParameterEvent", "rclcpp.TimeSource"),
    *("image_transport.TransportHints", "image_transport.ImageTransport", "camera_info_manager."),
)
"""Libraries that do nothing with a node which the tables do not say, and plain bags of attributes."""
_LOGS = frozenset({"debug", "info", "warn", "warning", "error", "fatal", "critical", "exception", "log"})
_HARMLESS_METHODS = ("destroy_", "get_name", "get_fully", "get_clock", "get_logger", "resolve_", "wait_for_")


def carries(values: Iterable[object]) -> list[Value]:
    """Those of some values that can lead to a node."""
    return [value for value in values if isinstance(value, _CARRIERS)]


def is_own(path: str) -> bool:
    """Whether a foreign function or class, by its dotted name, is known to leave nodes alone."""
    return path.startswith(_OWN)


def to_call(run: Run, values: Iterable[Value], what: str, expression: facts.Call | None) -> None:
    """Something is given to a call that is not followed: ``what`` is its name, as far as it has one."""
    values = list(values)
    name = what or _name(expression)
    is_log = name.rpartition(".")[2] in _LOGS
    if run.activations and run.activation.module.file.kind == "cpp" and not is_log:
        growing.may_be_filled(run, values)  # such a function mostly takes a reference
    given = carries(values)
    if not given:
        return
    threads.run_escaped_spins(run, given, expression)
    if not is_log:
        escape(run, given, f"it is passed to {name}(), which is not followed" if name else _UNFOLLOWED, expression)


_UNFOLLOWED = "it is passed to a call that is not followed"


def _name(expression: facts.Call | None) -> str:
    """What a call calls, as it is written: ``a.b.c``; empty where that is no name."""
    if expression is None:
        return ""
    written = expression.func.dotted
    return written or _attributes(expression.func)


def _attributes(expression: facts.Expr) -> str:
    """The attributes in a row that an expression ends with: ``a.b`` of ``make().a.b``."""
    names: list[str] = []
    while isinstance(expression, facts.Attribute):
        names.append(expression.attr)
        expression = expression.value
    return ".".join(reversed(names))


def lost(run: Run, result: Value, values: Iterable[Value], how: str) -> Value:
    """``result``; where it is unknown, what it was made from escapes."""
    if isinstance(result, Unknown):
        given = carries(values)
        if given:
            escape(run, given, f"{how}, which is not followed")
    return result


def escape(run: Run, values: Iterable[Value], reason: str, expression: facts.Call | None = None) -> None:
    """Values are passed to code that is not followed."""
    _spread(run, values, Escape(_place(run, expression), reason))


def _spread(run: Run, values: Iterable[Value], how: Escape) -> None:
    functions: list[Value] = []
    for value in _reached(run, values, how):
        node = nodes.known_node(run, value)
        if node is not None:
            mark(node, how)
            continue
        match value:
            case ClassValue():
                nodes.note_escaped_class(run, value)
            case ExecutorValue(use=use):
                use.astray = True
                for served in use.nodes:
                    mark(served, how)
            case FunctionValue() | BoundMethod() | Partial():
                functions.append(value)
    for function in functions:
        callee = function.callee
        if isinstance(callee, FunctionValue):
            run.callers.setdefault(id(callee.ir), set()).add(None)
    escaped_functions.note_escaped(run, functions)


def mark(node: model.Blueprint, how: Escape) -> None:
    """Note that a node has escaped; the first place says it."""
    if node.escapes:
        return
    node.escapes = True
    node.complete = False
    node.gaps.append((how.place, f"the node escapes: {how.reason}"))


def _place(run: Run, expression: facts.Call | None) -> Place:
    if expression is not None and run.activations:
        return run.place(expression.span)
    for activation in reversed(run.activations):
        statement = activation.statement
        span = getattr(statement, "span", None)
        if span is not None:
            return activation.place(span)
    return run.context.place


def _reached(run: Run, values: Iterable[Value], how: Escape | None) -> Iterator[Value]:
    """What can be got at from some values.  With ``how``, the objects on the way have escaped from now on, and those
    that had before are passed by."""
    waiting = list(values)
    seen: set[int] = set()
    while waiting:
        value = waiting.pop()
        match value:
            case OneOf(values=options):
                waiting.extend(options)
                continue
            case ApiMethod(self_value=owner):
                waiting += [owner] if _creates(value) else []
                continue
            case Partial(args=given, keywords=named) if not _is_followed(value):
                waiting += carries([*given, *(argument for _, argument in named)])
                continue
            case _ if not carries((value,)):
                continue
        key = value.heap_key
        if key is not None:
            if key in seen or (how is not None and key in run.escapes.objects):
                continue
            seen.add(key)
            if how is not None and not isinstance(value, ClassValue):
                run.escapes.objects[key] = how
            waiting.extend(_inside(run, value, key))
        yield value


def _creates(method: ApiMethod) -> bool:
    """Whether a method of a node lets whoever has it create or declare something.  An attribute that rclpy's nodes do
    not have is none: some other method of the class sets it to what is not seen yet."""
    owner, _, name = method.path.rpartition(".")
    if rclpy_names.is_missing_method(method.path):
        return False
    return owner in rclpy_names.NODE_CLASSES and not name.startswith(_HARMLESS_METHODS)


def _is_followed(value: Partial) -> bool:
    """Whether a partial ends in a function that is here: that one is run."""
    return isinstance(value.callee, FunctionValue)


def _inside(run: Run, value: Value, key: int) -> Iterator[Value]:
    """What a container or an object holds."""
    if isinstance(value, (ListValue, DictValue)):
        items, entries = run.store.get(key, ITEMS), run.store.get(key, ENTRIES)
        if items is not None:
            yield from carries(items.values)
        if entries is not None:
            for name, item in entries.entries.values():
                yield from carries((name, item))
        return
    for slot in run.store.holds(key):
        yield from carries((run.store.get(key, slot),))


# ------------------------------------------------------------------------------------------- what is kept


def kept(run: Run, key: int, values: Iterable[Value], name: str | None = None) -> None:
    """Something is put into a container or an object (as its attribute ``name``) that is followed."""
    given = carries(values)
    if not given:
        return
    if name is not None:
        run.store.note_reference(key, name)
    how = run.escapes.objects.get(key)
    if how is not None:
        _spread(run, given, how)
    root = run.store.shared.get(key)
    if isinstance(root, Root):
        run.escapes.shared.append(Shared(root, tuple(given), _place(run, None)))


def assigned(run: Run, target: Value, name: str, value: Value) -> None:
    """``target.name = value``, where the target may be anything."""
    if not carries((value,)):
        return
    if isinstance(target, ClassValue):
        run.store.note_reference(target.key, name)
        root = Root(target.scope.module, name, target.ir.name)
        run.escapes.shared.append(Shared(root, (value,), _place(run, None)))
        return
    key = target.heap_key
    if key is not None:
        kept(run, key, (value,), name)
        foreign = target.cls.dotted if isinstance(target, Instance) else ""
        if not foreign or is_own(foreign):
            return
    escape(run, (value,), f"it is stored as '{name}' of {_what(target)}, whose uses are not followed")


def _what(target: Value) -> str:
    match target:
        case ModuleValue(module=module):
            return f"the module {module.name}"
        case External(path=path):
            return path
        case Instance(cls=External(path=path)):
            return f"an object of {path}"
    return "something"


def _holds_nodes(value: object) -> bool:
    """Whether a variable with this value may be how code gets at a node."""
    return isinstance(value, (Instance, NodeValue, ListValue, DictValue, OneOf, Partial))


def named(run: Run, module: Module, name: str, value: Value) -> None:
    """A variable of a module is set."""
    if _holds_nodes(value):
        run.escapes.shared.append(Shared(Root(module, name), (value,), _place(run, None)))


def share(run: Run, module: Module) -> None:
    """Note how the objects that a module has made while it was imported are got at."""
    scope = module.scope
    for name in sorted(variables(module)) if scope is not None else ():
        assert scope is not None
        value = run.store.get(scope.key, name)
        _note_shared(run, value, Root(module, name))
        if isinstance(value, ClassValue) and value.scope.module is module:
            for attribute in sorted(class_variables(value.ir)):
                _note_shared(run, run.store.get(value.key, attribute), Root(module, attribute, value.ir.name))


def _note_shared(run: Run, value: object, root: Root) -> None:
    for reached in _reached(run, carries((value,)), None) if _holds_nodes(value) else ():
        if reached.heap_key is not None:
            run.store.shared.setdefault(reached.heap_key, root)


def settle(run: Run) -> None:
    """At the end of a program: what a module shares has escaped where a function uses it that nothing calls."""
    verdicts: dict[Root, str | None] = {}
    for shared in run.escapes.shared if run.nodes.by_key else ():
        shared_nodes = (nodes.known_node(run, value) for value in _reached(run, shared.values, None))
        for node in [node for node in shared_nodes if node is not None and not node.escapes]:
            if shared.root not in verdicts:
                verdicts[shared.root] = unseen_use(run, shared.root)
            how = verdicts[shared.root]
            if how is not None:
                mark(node, Escape(shared.place, f"it is stored in '{shared.root.name}': {how}"))


def holders(run: Run, instance: Instance, names: Iterable[str]) -> frozenset[str]:
    """Which of these attributes of an object lead to a node."""
    return frozenset(name for name in names if _leads_to_node(run, run.store.get(instance.key, name)))


def _leads_to_node(run: Run, value: object) -> bool:
    reached = _reached(run, carries((value,)), None) if _holds_nodes(value) else ()
    return any(nodes.known_node(run, item) is not None for item in reached)


__all__ = ["Escape", "Shared", "assigned", "escape", "holders", "kept", "lost", "named", "settle", "share", "to_call"]
