"""Nodes that escape: whoever has one may create, declare and spin what nobody here can see.

Reading an attribute of a node, calling its methods and calling what is followed are no escapes.  Everything else that
takes a node out of sight is one, for the node itself and for whatever holds it: a container, an object that keeps it,
a partial.  An object that has escaped once takes along what is put into it later.

What all code of a module can reach (its variables, attributes of its classes, containers that it makes once) is no
escape by itself: only where a function that the program is not seen to call uses it (:func:`settle`).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from archlint.finding import Place
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
from archlint.libraries.rclpy import callbacks, nodes
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
_OWN = ("rclpy.", "tf2_", "message_filters.", "logging.", "types.SimpleNamespace", "argparse.Namespace")
"""Libraries that do nothing with a node which the tables do not say, and plain bags of attributes."""
_LOGS = frozenset({"debug", "info", "warn", "warning", "error", "fatal", "critical", "exception", "log"})
_HARMLESS_METHODS = ("destroy_", "get_name", "get_fully", "get_clock", "get_logger", "resolve_", "wait_for_")


def carries(values: Iterable[Value]) -> list[Value]:
    """Those of some values that can lead to a node."""
    return [value for value in values if isinstance(value, _CARRIERS)]


def is_own(path: str) -> bool:
    """Whether a foreign function or class, by its dotted name, is known to leave nodes alone."""
    return path.startswith(_OWN)


def to_call(run: Run, values: Iterable[Value], what: str, expression: facts.Call | None) -> None:
    """Something is given to a call that is not followed: ``what`` is its name, as far as it has one."""
    given = carries(values)
    if not given:
        return
    callbacks.run_handed_spins(run, given, expression)
    name = what or _name(expression)
    if name.rpartition(".")[2] not in _LOGS:
        escape(run, given, f"it is passed to {name}(), which is not followed" if name else _UNFOLLOWED, expression)


_UNFOLLOWED = "it is passed to a call that is not followed"


def _name(expression: facts.Call | None) -> str:
    """What a call calls, as it is written: ``a.b.c``; empty where that is no name."""
    parts: list[str] = []
    item: facts.Expr | None = None if expression is None else expression.func
    while isinstance(item, facts.Attribute):
        parts.append(item.attr)
        item = item.value
    if isinstance(item, facts.Name):
        parts.append(item.id)
    return ".".join(reversed(parts))


def lost(run: Run, result: Value, values: Iterable[Value], how: str) -> Value:
    """``result``; where it is unknown, what it was made from is out of sight."""
    if isinstance(result, Unknown):
        given = carries(values)
        if given:
            escape(run, given, f"{how}, which is not followed")
    return result


def escape(run: Run, values: Iterable[Value], reason: str, expression: facts.Call | None = None) -> None:
    """Values get into the hands of code that is not followed."""
    _spread(run, values, Escape(_place(run, expression), reason))


def _spread(run: Run, values: Iterable[Value], how: Escape) -> None:
    functions: list[Value] = []
    for value in _reached(run, values, how):
        node = nodes.known_node(run, value)
        if node is not None:
            mark(node, how)
        elif isinstance(value, ClassValue):
            nodes.hand_out_class(run, value)
        elif isinstance(value, ExecutorValue):
            for one in value.use.nodes:
                mark(one, how)
        elif isinstance(value, (FunctionValue, BoundMethod, Partial)):
            functions.append(value)
    for function in functions:
        while isinstance(function, (BoundMethod, Partial)):
            function = function.function
        if isinstance(function, FunctionValue):
            run.callers.setdefault(id(function.ir), set()).add(None)
    callbacks.hand_out(run, functions)


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
        if isinstance(value, OneOf):
            waiting.extend(value.values)
            continue
        if isinstance(value, ApiMethod):
            if _creates(value) and value.self_value is not None:
                waiting.append(value.self_value)
            continue
        if isinstance(value, Partial) and not _is_followed(value):
            waiting.extend(carries([*value.args, *(given for _, given in value.keywords)]))
            continue
        if not isinstance(value, _CARRIERS):
            continue
        key = value.heap_key
        if isinstance(key, int):
            if key in seen or (how is not None and key in run.escapes.objects):
                continue
            seen.add(key)
            if how is not None and not isinstance(value, ClassValue):
                run.escapes.objects[key] = how
            waiting.extend(_inside(run, value, key))
        yield value


def _creates(method: ApiMethod) -> bool:
    """Whether a method of a node lets whoever has it create or declare something."""
    owner, _, name = method.path.rpartition(".")
    return owner in rclpy_names.NODE_CLASSES and not name.startswith(_HARMLESS_METHODS)


def _is_followed(value: Partial) -> bool:
    """Whether a partial ends in a function that is here: that one is run."""
    inner: Value = value
    while isinstance(inner, Partial):
        inner = inner.function
    return isinstance(inner, (FunctionValue, BoundMethod))


def _inside(run: Run, value: Value, key: int) -> Iterator[Value]:
    """What a container or an object holds."""
    if isinstance(value, (ListValue, DictValue)):
        items, entries = run.store.get(key, ITEMS), run.store.get(key, ENTRIES)
        if items is not None:
            yield from carries(items.values)
        if entries is not None:
            for name, held in entries.entries.values():
                yield from carries((name, held))
        return
    for slot in run.store.held.get(key, ()):
        held_value = run.store.get(key, slot)
        if isinstance(held_value, _CARRIERS):
            yield held_value


# ------------------------------------------------------------------------------------------- what is kept


def kept(run: Run, key: int, values: Iterable[Value], name: str | None = None) -> None:
    """Something is put into a container or an object (as its attribute ``name``) that is followed."""
    given = carries(values)
    if not given:
        return
    if name is not None:
        run.store.held.setdefault(key, {})[name] = None
    how = run.escapes.objects.get(key)
    if how is not None:
        _spread(run, given, how)
    root = run.store.shared.get(key)
    if isinstance(root, Root):
        run.escapes.shared.append(Shared(root, tuple(given), _place(run, None)))


def assigned(run: Run, target: Value, name: str, value: Value) -> None:
    """``target.name = value``, where the target may be anything."""
    if not isinstance(value, _CARRIERS):
        return
    if isinstance(target, ClassValue):
        run.store.held.setdefault(target.key, {})[name] = None
        root = Root(target.scope.module, name, target.ir.name)
        run.escapes.shared.append(Shared(root, (value,), _place(run, None)))
        return
    key = target.heap_key
    if isinstance(key, int):
        kept(run, key, (value,), name)
        if not isinstance(target, Instance) or isinstance(target.cls, ClassValue) or is_own(target.cls.path):
            return
    escape(run, (value,), f"it is stored as '{name}' of {_what(target)}, whose uses are not followed")


def _what(target: Value) -> str:
    if isinstance(target, ModuleValue):
        return f"the module {target.module.name}"
    if isinstance(target, External):
        return target.path
    if isinstance(target, Instance) and isinstance(target.cls, External):
        return f"an object of {target.cls.path}"
    return "something"


_NAMED = (Instance, NodeValue, ListValue, DictValue, OneOf, Partial)


def named(run: Run, module: Module, name: str, value: Value) -> None:
    """A variable of a module is set."""
    if isinstance(value, _NAMED):
        run.escapes.shared.append(Shared(Root(module, name), (value,), _place(run, None)))


def share(run: Run, module: Module) -> None:
    """Note how the objects that a module has made while it was imported are got at."""
    scope = module.scope
    for name in sorted(variables(module)) if scope is not None else ():
        assert scope is not None
        value = run.store.get(scope.key, name)
        if isinstance(value, _NAMED):
            _note_shared(run, value, Root(module, name))
        elif isinstance(value, ClassValue) and value.scope.module is module:
            for attribute in sorted(class_variables(value.ir)):
                held = run.store.get(value.key, attribute)
                if isinstance(held, _NAMED):
                    _note_shared(run, held, Root(module, attribute, value.ir.name))


def _note_shared(run: Run, value: Value, root: Root) -> None:
    for one in _reached(run, (value,), None):
        key = one.heap_key
        if isinstance(key, int):
            run.store.shared.setdefault(key, root)


def settle(run: Run) -> None:
    """At the end of a program: what a module shares has escaped where a function uses it that nothing calls."""
    verdicts: dict[Root, str | None] = {}
    for shared in run.escapes.shared if run.nodes.by_key else ():
        found = (nodes.known_node(run, value) for value in _reached(run, shared.values, None))
        for node in [node for node in found if node is not None and not node.escapes]:
            if shared.root not in verdicts:
                verdicts[shared.root] = unseen_use(run, shared.root)
            how = verdicts[shared.root]
            if how is not None:
                mark(node, Escape(shared.place, f"it is kept in '{shared.root.name}': {how}"))


def holders(run: Run, instance: Instance, names: Iterable[str]) -> frozenset[str]:
    """Which of these attributes of an object lead to a node."""
    return frozenset(name for name in names if _leads_to_node(run, run.store.get(instance.key, name)))


def _leads_to_node(run: Run, value: object) -> bool:
    if not isinstance(value, _NAMED):
        return False
    return any(nodes.known_node(run, one) is not None for one in _reached(run, (value,), None))


__all__ = ["Escape", "Shared", "assigned", "escape", "holders", "kept", "lost", "named", "settle", "share", "to_call"]
