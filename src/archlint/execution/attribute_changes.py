"""What changes an attribute of an object: the callbacks that do, where nothing else can."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.finding import Place
from archlint.syntax import facts
from archlint.syntax.parts import everything_in, names_in, parts_of

if TYPE_CHECKING:
    from archlint.model import Blueprint, Callback, Program
    from archlint.systems.model import System

_CHANGES = frozenset(
    {"append", "appendleft", "add", "clear", "extend", "insert", "pop", "popleft", "put", "put_nowait", "remove", "set"}
    | {"update", "setdefault", "notify", "notify_all", "release"}
)
"""Methods that change what an attribute holds."""
_BY_TEXT = frozenset({"setattr", "__setattr__", "__dict__", "vars"})
"""What changes an attribute by its name as a text."""


def changing_callbacks(
    system: System,
    program: Program,
    node: Blueprint,
    file: str,
    attribute: str,
    own: Collection[Place],
) -> list[Callback] | None:
    """The callbacks of a node that change an attribute of an object after its constructor; None where something else
    may change it. ``file`` waits for that; ``own`` are the classes of the object, none where they are not known."""
    workspace = system.workspace
    if workspace is None or not node.complete:
        return None
    callbacks: dict[Place, list[Callback]] = {}
    for callback in program.callbacks:
        if callback.function is not None:
            callbacks.setdefault(callback.place, []).append(callback)
    changing: list[Callback] = []
    classes = (cls.file for cls in sorted(own))
    for path in dict.fromkeys((file, *classes, *workspace.code.files_that_mention(attribute))):
        code = workspace.facts_at(path)
        functions = None if code is None else _changing_functions(code, path, attribute, own)
        if functions is None:
            return None
        for function in functions:
            registered = callbacks.get(Place.of(path, function.name_span), [])
            if not registered or any(callback.node is not node for callback in registered):
                return None
            changing += registered
    return changing


def _changing_functions(
    code: facts.Facts, path: str, attribute: str, own: Collection[Place]
) -> list[facts.Function] | None:
    """The functions of a file that may change an attribute of an object, but for constructors; None where what is no
    function may do so."""
    others = set(_of_other_objects(code, path, own)) if own else set()
    by_text = not _BY_TEXT.isdisjoint(names_in(code.body))

    def changes(part: facts.Base) -> bool:
        return any(id(changed) not in others for changed in _changed(part, attribute, by_text))

    if any(map(changes, parts_of(code.body))):
        return None
    functions = []
    for function in everything_in(code.body, facts.Function):
        parts = list(everything_in(function.body))
        if function.name == "__init__":
            parts = [inside for part in parts if isinstance(part, facts.Lambda) for inside in everything_in(part)]
            if any(map(changes, parts)):
                return None
        elif any(map(changes, parts)):
            functions.append(function)
    return functions


def is_used_otherwise(
    system: System, file: str, attribute: str, methods: Collection[str], own: Collection[Place]
) -> bool:
    """Whether code does anything with an attribute but assign it and call some methods of what it holds."""
    workspace = system.workspace
    if workspace is None:
        return True
    paths = dict.fromkeys((file, *(cls.file for cls in sorted(own)), *workspace.code.files_that_mention(attribute)))
    return any(_uses_otherwise(workspace.facts_at(path), path, attribute, methods, own) for path in paths)


def _uses_otherwise(
    code: facts.Facts | None, path: str, attribute: str, methods: Collection[str], own: Collection[Place]
) -> bool:
    if code is None or not _BY_TEXT.isdisjoint(names_in(code.body)):
        return True
    known = set(_of_other_objects(code, path, own)) if own else set()
    for part in everything_in(code.body):
        match part:
            case facts.Call(func=facts.Attribute(value=facts.Attribute(attr=name) as held, attr=method)):
                if name == attribute and method in methods:
                    known.add(id(held))
            case facts.Assign():
                known.update(id(target) for target in part.targets)
            case facts.WithItem(value=value, target=None):
                known.add(id(value))
    mentions = everything_in(code.body, facts.Attribute)
    return any(id(part) not in known for part in mentions if part.attr == attribute)


def _of_other_objects(code: facts.Facts, path: str, own: Collection[Place]) -> Iterator[int]:
    """The ids of the attributes of ``self`` in classes that are none of the object's."""
    for cls in everything_in(code.body, facts.Class):
        if Place.of(path, cls.name_span) in own:
            continue
        for method in cls.body:
            if isinstance(method, facts.Function) and method.params and not method.decorators:
                self_name = method.params[0].name
                yield from (
                    id(part) for part in everything_in(method.body, facts.Attribute) if part.value.variable == self_name
                )


def _changed(part: facts.Base, attribute: str, by_text: bool) -> Iterator[facts.Base]:
    """The attributes of that name that a piece of code assigns, or of which it changes what they hold; a text that
    names it."""
    match part:
        case facts.Assign() | facts.Augmented() | facts.Annotated() | facts.With() | facts.For() | facts.Delete():
            yield from _stored(getattr(part, "assigned", getattr(part, "targets", ())), attribute)
        case facts.Call(func=facts.Attribute(value=facts.Attribute(attr=name) as changed, attr=method)):
            if name == attribute and method in _CHANGES:
                yield changed
        case facts.Literal(text=text) if by_text and text == attribute:
            yield part


def _stored(targets: Sequence[facts.Base], attribute: str) -> Iterator[facts.Base]:
    for target in targets:
        yield from (part for part in everything_in(target, facts.Attribute) if part.attr == attribute)


__all__ = ["changing_callbacks", "is_used_otherwise"]
