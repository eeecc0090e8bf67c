"""Functions for whose truth a condition asks, as it does not call them: ``while rclpy.ok:``, ``if self.is_ready:``.

Any function is true.  So are the methods of a future and of a client.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping
from itertools import chain, pairwise
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.place import Place
from archlint.python_code.annotations import imported_as
from archlint.python_code.class_chains import ClassInFile, classes_of, files_with, methods_of, targets_of
from archlint.python_code.own_calls import method_meant
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.bindings import names_bound
from archlint.syntax.flow_facts import conditions_of
from archlint.syntax.parts import Itself, everything_in, parts_of
from archlint.syntax.walk import blocks_of, is_none

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_FUNCTIONS = frozenset({"rclpy.ok"})
_OF_CLIENTS = frozenset({"service_is_ready", "server_is_ready", "wait_for_server", "wait_for_service"})
"""Methods that no other class has by that name, and that no class has as a value."""
_OF_FUTURES = frozenset({"cancelled", "done"})
_NEVER_FALSE = frozenset({"lookup_transform", "lookup_transform_full"})
"""Methods of a buffer of tf2 that give a transform or raise an error."""
_GIVE_FUTURES = frozenset({"call_async", "get_result_async", "send_goal_async"})


@dataclass(frozen=True)
class TestedMethod:
    """Such a condition, and what it names."""

    written: str
    place: Place
    takes_arguments: bool
    """Whether it cannot be called without any."""
    called: bool = False
    """Whether it is called, and what it gives is always true."""
    just_sent: bool = False
    """Whether it asks for the response in the line after its request, when it cannot be there."""


@dataclass(frozen=True)
class _Row:
    written: str
    span: facts.Span
    cls: int | None = None
    """For a method of ``self``: its class, by its position in the file."""
    called: bool = False
    just_sent: bool = False


def tested_methods(workspace: WorkspaceIndex) -> Iterator[TestedMethod]:
    """Such conditions in the files that use rclpy, but for test code."""
    for path in workspace.python_files(mentioning="rclpy"):
        for row in _rows(workspace, path) or ():
            needed = False
            if row.called and _has_own(workspace, row.written.rpartition(".")[2]):
                continue
            if row.cls is not None:
                code = workspace.facts_at(path)
                cls = None if code is None else ClassInFile(path, classes_of(code)[row.cls])
                meant = None if cls is None else method_meant(workspace, cls, row.written.rpartition(".")[2])
                if meant is None:
                    continue
                needed = any(param.default is None for param in meant.code.params[meant.bound :])
            yield TestedMethod(row.written, Place(path, *row.span), needed, row.called, row.just_sent)


def _has_own(workspace: WorkspaceIndex, name: str) -> bool:
    """Whether the workspace defines a function or a method of that name, which may return anything."""
    read = (workspace.facts_at(path) for path in files_with(workspace, name))
    return any(
        code is None or any(function.name == name for function in everything_in(code.body, facts.Function))
        for code in read
    )


@kept_for_each_file
def _rows(code: facts.Facts) -> list[_Row]:
    if not {"setattr", "__dict__"}.isdisjoint(code.names):
        return []
    methods = _methods(code)
    futures, early = _futures(code), _asked_at_once(code)
    rows = []
    for part in everything_in(code.body):
        for test in _tested(part):
            match test:
                case facts.Call(func=facts.Attribute(attr=name) as looked_up) if name in _NEVER_FALSE:
                    rows.append(_Row(looked_up.dotted or name, test.span, called=True))
                case facts.Attribute(value=owner, attr=name) if test.dotted:
                    of_future = name in _OF_FUTURES and Itself[facts.Base](test) in futures
                    if imported_as(code, test.dotted) in _FUNCTIONS or name in _OF_CLIENTS or of_future:
                        rows.append(_Row(test.dotted, test.span, just_sent=(Itself(part), owner.dotted) in early))
                    elif (
                        owner.variable == "self"
                        and Itself[facts.Base](test) in methods
                        and not _calls(part, test.dotted)
                    ):
                        rows.append(_Row(test.dotted, test.span, methods[Itself[facts.Base](test)]))
    return rows


def _methods(code: facts.Facts) -> Mapping[Itself[facts.Base], int]:
    """What names a plain method of its own class in the methods of that class, with the position of the class."""
    rows: dict[Itself[facts.Base], int] = {}
    for number, cls in enumerate(classes_of(code)):
        plain = {method.name for method in methods_of(cls) if not method.decorators}
        for method in methods_of(cls):
            for part in everything_in(method.body, facts.Attribute):
                if part.attr in plain:
                    rows[Itself(part)] = number
    return rows


def _futures(code: facts.Facts) -> frozenset[Itself[facts.Base]]:
    """What is looked for in variables, and attributes of ``self``, that hold nothing but the future of a request."""
    rows: set[Itself[facts.Base]] = set()
    held = Counter(target.attribute for target in targets_of(code.body) if target.attribute)
    futures_or_none = Counter(
        target.attribute
        for each in everything_in(code.body, facts.Assign)
        if _gives_future(each.value) or is_none(each.value)
        for target in each.targets
        if target.attribute
    )
    futures = {
        target.attribute
        for each in everything_in(code.body, facts.Assign)
        if _gives_future(each.value)
        for target in each.targets
    }
    attributes = {name for name in futures - {""} if held[name] == futures_or_none[name]}
    for part in everything_in(code.body, facts.Attribute):
        if part.value.attribute in attributes:
            rows.add(Itself(part))
    for function in everything_in(code.body, facts.Function):
        times = Counter(names_bound(function))
        given = Counter(
            target.variable
            for each in parts_of(function.body, facts.Assign)
            if _gives_future(each.value)
            for target in each.targets
            if target.variable
        )
        for part in parts_of(function.body, facts.Attribute) if given else ():
            name = part.value.variable
            if name and given[name] and given[name] == times[name]:
                rows.add(Itself(part))
    return frozenset(rows)


def _asked_at_once(code: facts.Facts) -> set[tuple[Itself[facts.Base], str]]:
    """The branches that stand right behind a request, with what holds its future."""
    functions = everything_in(code.body, facts.Function)
    pairs = (pair for function in functions for block in blocks_of(function.body) for pair in pairwise(block))
    return {
        (Itself[facts.Base](branch), target.dotted)
        for sent, branch in pairs
        if isinstance(branch, facts.If) and isinstance(sent, facts.Assign) and _gives_future(sent.value)
        for target in sent.targets
    }


def _gives_future(value: facts.Expr) -> bool:
    return isinstance(value, facts.Call) and value.func.attribute in _GIVE_FUTURES


def _tested(part: facts.Base) -> Iterator[facts.Expr]:
    """The expressions of whose truth a piece of code makes a condition."""
    match part:
        case facts.If(test=test) | facts.While(test=test) | facts.Assert(test=test) | facts.Conditional(test=test):
            yield from conditions_of(test)
        case facts.Comprehension(generators=generators):
            for generator in generators:
                yield from chain.from_iterable(map(conditions_of, generator.conditions))


def _calls(part: facts.Base, dotted: str) -> bool:
    """Whether code that a condition decides about calls what it asks for: it is sure that this is there."""
    return any(call.func.dotted == dotted for call in everything_in([part], facts.Call))


__all__ = ["TestedMethod", "tested_methods"]
