"""Data that goes from one callback of a node to another through attributes and global variables."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.source_code import source_code
from archlint.dataflow.attributes import Use, class_around, class_at, concerns, root_of, use_of
from archlint.dataflow.model import How, Step
from archlint.dataflow.runs import SCRIPT, SENDS
from archlint.model import Role
from archlint.place import Place

if TYPE_CHECKING:
    from archlint.analysis.source_code import FunctionFacts, SourceCode
    from archlint.dataflow.builder import Builder
    from archlint.dataflow.runs import Run
    from archlint.python_code.class_chains import ClassInFile
    from archlint.systems.model import WorkspaceIndex
    from archlint.systems.nodes import Node

_Key = tuple[object, str, bool]
"""Whose variable it is, its name, and whether it is a global variable."""
_Users = dict[_Key, list[Step]]


def link_variables(builder: Builder) -> None:
    """Link what sets variables of a node with what reads them; variables that the same callbacks set and read are one
    step."""
    workspace = builder.system.workspace
    if workspace is None:
        return
    for node in builder.system.entries:
        setters: _Users = {}
        readers: _Users = {}
        for run in builder.runs_on(node):
            if run.callback.role != Role.INIT:  # before anything has arrived
                step = builder.step_of(run)
                for key, is_set in _variables(builder, workspace, node, run):
                    (setters if is_set else readers).setdefault(key, []).append(step)
        _link(builder, node, setters, readers)


def _link(builder: Builder, node: Node, setters: _Users, readers: _Users) -> None:
    by_object: dict[tuple[object, str], list[_Key]] = {}
    for key in readers:
        by_object.setdefault(_object(key), []).append(key)
    together: dict[tuple[object, ...], list[_Key]] = {}
    users: dict[tuple[object, ...], tuple[list[Step], list[Step]]] = {}
    for key, setting in setters.items():
        concerned = [other for other in by_object.get(_object(key), ()) if concerns(key[1], other[1])]
        reading = list({id(step): step for other in concerned for step in readers[other]}.values())
        if any(setter is not reader for setter in setting for reader in reading):
            alike = (key[0], *map(id, setting), "read by", *map(id, reading))
            together.setdefault(alike, []).append(key)
            users[alike] = setting, reading
    for alike, keys in sorted(together.items(), key=lambda row: min(map(_name, row[1]))):
        kept = builder.kept(node, sorted(map(_name, keys)))
        for step in users[alike][0]:
            builder.link(step, kept, How.SET)
        for step in users[alike][1]:
            builder.link(kept, step, How.READ)


def _name(key: _Key) -> str:
    """How a variable is shown."""
    return key[1] if key[2] else f"self.{key[1]}"


def _object(key: _Key) -> tuple[object, str]:
    """Whose variable it is, and the first of its names: ``a`` of ``a.b``."""
    return key[0], key[1].partition(".")[0]


def _variables(builder: Builder, workspace: WorkspaceIndex, node: Node, run: Run) -> Iterator[tuple[_Key, bool]]:
    """The variables that a callback uses, each with whether it sets it."""
    functions = _functions(source_code(builder.system), run)
    if not functions:
        return
    file, first = functions[0]
    cls = class_around(workspace, file, first)
    owner: object = None
    if cls is not None:
        owner = root_of(workspace, cls)
        cls = _class_of(workspace, node, cls)
    use = use_of(workspace, file, [function for path, function in functions if path == file], cls)
    yield from _keys(use, owner, file)


def _keys(use: Use, owner: object, file: str) -> Iterator[tuple[_Key, bool]]:
    for variables, is_set in ((use.sets, True), (use.reads, False)):
        for kind, name in sorted(variables):
            if kind == "global":
                yield (file, name, True), is_set
            elif owner is not None:
                yield (owner, name, False), is_set


def _functions(code: SourceCode, run: Run) -> list[tuple[str, FunctionFacts]]:
    """The function of a callback, and those in which it comes to a call; of ``main`` only what sends again and again:
    the rest of it sets the node up."""
    is_main = run.callback.role in SCRIPT
    own = None if is_main else code.function(run.callback)
    functions = [] if own is None or run.callback.function is None else [(run.callback.function.place.file, own)]
    for call in run.calls:
        function = code.function_at(call.place) if not is_main or (call.looped and call.api in SENDS) else None
        if function is not None and all(function is not known for _, known in functions):
            functions.append((call.place.file, function))
    return functions


def _class_of(workspace: WorkspaceIndex, node: Node, around: ClassInFile) -> ClassInFile:
    """The class of the object that a method runs on: the node's own, where the method is one of its bases."""
    place = Place.of(around.file, around.code.name_span)
    for blueprint in node.blueprints:
        if any(cls.place == place for cls in blueprint.classes):
            return class_at(workspace, blueprint.classes[0].place) or around
    return around


__all__ = ["link_variables"]
