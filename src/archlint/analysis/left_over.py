"""What nothing uses: publishers that nothing publishes with, and methods that nothing calls."""

from __future__ import annotations

import posixpath
import re
from collections import Counter
from collections.abc import Collection, Mapping, Sequence
from itertools import chain
from typing import TYPE_CHECKING

from archlint.analysis.cpp_nodes import is_never_used
from archlint.analysis.kept import kept_for_each_file
from archlint.analysis.own_names import BY_NAME
from archlint.analysis.source_code import code_of
from archlint.model import (
    EntityKind,
    Role,
)
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.model import ApiCall, Program
    from archlint.systems.model import WorkspaceIndex
    from archlint.systems.nodes import Endpoint


def is_left_over(workspace: WorkspaceIndex | None, endpoint: Endpoint) -> bool:
    """Whether a publisher is kept in an attribute of ``self`` that its file names again at most in methods that nothing
    calls, and no other file of the package that does not set an attribute of that name itself: it says nothing on its
    topic."""
    if workspace is None or endpoint.kind != EntityKind.PUBLISHER:
        return False
    if is_never_used(workspace, endpoint.place):
        return True
    package = endpoint.node.package
    return package is not None and _is_kept_unused(workspace, endpoint.place, workspace.code.files_of(package))


def is_kept_unused(workspace: WorkspaceIndex, place: Place) -> bool:
    """Whether what the call at a place creates is kept in an attribute of ``self`` that nothing which runs uses, in any
    file of the workspace."""
    attribute = _kept_as(workspace, place)
    return attribute is not None and _is_kept_unused(workspace, place, workspace.code.files_that_mention(attribute[0]))


def _is_kept_unused(workspace: WorkspaceIndex, place: Place, files: Collection[str]) -> bool:
    code, attribute = workspace.code, _kept_as(workspace, place)
    if attribute is None:
        return False
    name, methods = attribute
    others = [other for other in files if other != place.file]
    if any(code.mentions(other, method) for other in others for method in methods):
        return False
    return not any(code.mentions(other, name) and not _sets_itself(workspace, other, name) for other in others)


def is_dead(workspace: WorkspaceIndex | None, program: Program, call: ApiCall) -> bool:
    """Whether a call is in a method of a program that no Python file here names: that code does not run.  What a
    library offers is for programs that are not here."""
    callback = call.context
    if workspace is None or callback.role != Role.METHOD or not program.executable:
        return False
    if callback.node is None or callback.node.escapes:
        return False
    code, file, function = workspace.code, callback.place.file, code_of(workspace).definition(callback)
    uses = _uses(workspace, file)
    if uses is None or function is None:
        return False
    name = function.name
    others = [other for other in code.files_that_mention(name) if other != file]
    if workspace.package_of(file) is None:
        module = posixpath.basename(file).removesuffix(".py")
        others = [other for other in others if code.mentions(other, module)]  # others have a method of that name, too
    return not uses.by_name and name in uses.idle and not others


def is_never_made(workspace: WorkspaceIndex | None, call: ApiCall) -> bool:
    """Whether a call is in a method of a class, no node itself, that no Python file here names but to define it: no
    object of it is ever made, whatever its annotations say of the node that would be passed to it."""
    owner, _, method = call.function.rpartition(".")
    node, name = call.context.node, owner.rpartition(".")[2]
    if workspace is None or not name.isidentifier() or not method.isidentifier():
        return False
    code, file = workspace.code, call.file
    file_facts, uses = workspace.facts_at(file), _uses(workspace, file)
    package = workspace.package_of(file)
    if file_facts is None or uses is None or package is None or (node is not None and node.class_name == owner):
        return False
    if uses.by_name or name in uses.names or name in uses.count or not _defines(file_facts, name):
        return False
    return all(other == file for other in code.files_that_mention(name))


def _defines(file_facts: facts.Facts, name: str) -> bool:
    """Whether a file defines a class, and gives it no decorator, which may note it somewhere."""
    classes = [
        statement for statement in file_facts.body if isinstance(statement, facts.Class) and statement.name == name
    ]
    return len(classes) == 1 and not classes[0].decorators and not classes[0].bases


def is_left_unmade(workspace: WorkspaceIndex | None, file: str, cls: str) -> bool:
    """Whether a file that uses others of its classes never names this one again, and neither does another file, but for
    those that define a class of that name themselves: no object of it is made."""
    uses = None if workspace is None else _uses(workspace, file)
    if workspace is None or uses is None or uses.by_name or cls in uses.names or not cls.isidentifier():
        return False
    classes = _classes(workspace.facts_at(file))
    if cls not in classes or classes.isdisjoint(uses.names):
        return False
    others = (other for other in workspace.code.files_that_mention(cls) if other != file)
    return all(cls in _classes(workspace.facts_at(other)) for other in others)


def unmade_class(workspace: WorkspaceIndex | None, place: Place) -> str | None:
    """The name of the class at the top of a file that holds a place, where no object of it is made, though the file
    makes some of its other classes; None for any other place."""
    code = None if workspace is None else workspace.facts_at(place.file)
    classes = [part for part in (() if code is None else code.body) if isinstance(part, facts.Class)]
    plain = [part for part in classes if all(base.value.last_name in _PLAIN_BASES for base in part.bases)]
    around = [part for part in plain if part.span[0] <= place.line <= part.span[2] and not part.decorators]
    return next((part.name for part in around if is_left_unmade(workspace, place.file, part.name)), None)


def _classes(code: facts.Facts | None) -> set[str]:
    return set() if code is None else {each.name for each in code.body if isinstance(each, facts.Class)}


def _sets_itself(workspace: WorkspaceIndex, file: str, name: str) -> bool:
    """Whether a file keeps the result of a call in an attribute of that name; of one that Python cannot read, by its
    lines."""
    uses, code = _uses(workspace, file), workspace.facts_at(file)
    if uses is None or code is None or code.problems:
        return bool(workspace.tree.lines_with(file, rf"^\s*self\.{re.escape(name)}\s*=\s*\w[\w.]*\("))
    return name in uses.kept.values()


def _kept_as(workspace: WorkspaceIndex, place: Place) -> tuple[str, frozenset[str]] | None:
    """The attribute of ``self`` that the call at a place is assigned to, if nothing else in the file uses it but
    methods that the file does not name: these too."""
    uses = _uses(workspace, place.file)
    if uses is None:
        return None
    name = uses.kept.get((place.line, place.column))
    if name is None or uses.by_name:
        return None
    idle = {method: inside[name] for method, inside in uses.idle.items() if name in inside}
    return (name, frozenset(idle)) if uses.count.get(name, 0) == 1 + sum(idle.values()) else None


def kept_calls(workspace: WorkspaceIndex, file: str) -> dict[tuple[int, int], str]:
    """The attributes of ``self`` that calls of a file are kept in, by the line and column of the call."""
    uses = _uses(workspace, file)
    return {} if uses is None else uses.kept


def idle_methods(workspace: WorkspaceIndex, file: str) -> frozenset[str]:
    """The methods that a file defines and does not name again."""
    uses = _uses(workspace, file)
    return frozenset() if uses is None else frozenset(uses.idle)


def idle_callers(workspace: WorkspaceIndex, file: str, method: str) -> frozenset[str]:
    """An idle method of a file, and the others there that lead to it: who calls one of them calls it, too."""
    uses, reached = _uses(workspace, file), {method}
    for _ in range(_HOPS if uses is not None else 0):
        assert uses is not None
        reached |= {name for name, named in uses.idle.items() if not reached.isdisjoint(named)}
    return frozenset(reached)


@dataclass(frozen=True)
class _Uses:
    """The attributes that a file names: how often each, and which calls are kept in one of ``self``."""

    count: dict[str, int]
    names: frozenset[str]
    kept: dict[tuple[int, int], str]
    """The attributes of ``self`` that calls are kept in, by the line and column of the call."""
    by_name: bool
    """Whether code asks for attributes by names that are not written out."""
    idle: dict[str, dict[str, int]]
    """The methods that nothing names but each other, with the attributes that they use and how often."""


@kept_for_each_file
def _uses(code: facts.Facts) -> _Uses:
    every = [*everything_in(code.body)]
    names = [use.id for use in every if isinstance(use, facts.Name)]
    attributes = [use.attr for use in every if isinstance(use, facts.Attribute)]
    count = Counter(attributes)
    kept: dict[tuple[int, int], str] = {}
    unwritten = sum(name in BY_NAME for name in chain(names, attributes))
    for part in every:
        match part:
            case facts.Call(args=[_, facts.Argument(value=facts.Literal(str(asked))), *_]) if (
                part.func.variable == "getattr"
            ):  # a literal that ``getattr`` is given is written out
                count[asked] += 1
                unwritten -= 1
            case facts.Assign(targets=[facts.Attribute(value=facts.Name(), attr=name)], value=facts.Call(span=span)):
                kept[span[0], span[1]] = name
    uses_of = {method.name: _attributes(method) for method in _methods(every) if _may_be_idle(method, names)}
    return _Uses(dict(count), frozenset(names), kept, unwritten > 0, _idle(uses_of, count))


def _idle(uses_of: Mapping[str, dict[str, int]], count: Mapping[str, int]) -> dict[str, dict[str, int]]:
    """Those of some methods that nothing names but each other, or the method itself: it may pass on to another object
    what it is asked for."""
    idle: dict[str, dict[str, int]] = {}
    for _ in range(_HOPS):
        named = Counter[str]()
        for uses in idle.values():
            named.update(uses)
        own = {name: uses.get(name, 0) for name, uses in uses_of.items() if name not in idle}
        idle |= {name: uses for name, uses in uses_of.items() if count.get(name, 0) == named[name] + own.get(name, 0)}
    return idle


def _methods(every: Sequence[facts.Base]) -> list[facts.Function]:
    """The methods of classes whose bases, if any, do not call methods of their own accord."""
    classes = [part for part in every if isinstance(part, facts.Class)]
    plain = [cls for cls in classes if all(base.value.last_name in _PLAIN_BASES for base in cls.bases)]
    methods = [item for cls in plain for item in cls.body if isinstance(item, facts.Function)]
    times = Counter(method.name for method in methods)
    return [method for method in methods if times[method.name] == 1]


def _may_be_idle(method: facts.Function, names: Collection[str]) -> bool:
    called = method.name.startswith("__") or method.name == "destroy_node" or bool(method.decorators)
    return not called and method.name not in names


_HOPS = 3
"""Through how many methods that call each other it is looked for one that something calls."""

_PLAIN_BASES = frozenset({"Node", "object"})
"""Bases that call no method of their own accord.  Whether a class is just an rclpy node is another question
(:attr:`archlint.model.NodeClass.just_rclpy`): a LifecycleNode is, and calls ``on_configure`` and the like."""


def _attributes(method: facts.Function) -> dict[str, int]:
    return dict(Counter(part.attr for part in everything_in(method.body, facts.Attribute)))
