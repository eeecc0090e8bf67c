"""Methods of a node that code looks into instead of calling them: ``self.get_logger.info('…')``.

Source: ``Node`` in rclpy/node.py and ``Clock`` in rclpy/clock.py; a method of Python has no attributes but those that
begin with two underscores.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.libraries.api_signatures import signatures_of
from archlint.libraries.rclpy.names import NODE_CLASSES
from archlint.place import Place
from archlint.python_code.class_chains import (
    ClassInFile,
    chain_of,
    classes_asked_for,
    derived_from,
    files_with,
    kept_for_each_class,
    methods_of,
    targets_of,
)
from archlint.python_code.tried_code import tried_for
from archlint.python_code.unassigned_attributes import attributes_of_self, has_self, members_of, names_of_body
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import Itself, everything_in, once_for

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex


@dataclass(frozen=True)
class LookedInto:
    """``self.method.name``, where ``method`` is one of a node; ``owner`` is ``self`` as it is written, and empty where
    that is no plain name."""

    place: Place
    owner: str
    method: str
    name: str
    needs: bool
    """Whether the method cannot be called without arguments."""
    of_clock: bool = False


def methods_looked_into(workspace: WorkspaceIndex) -> Iterator[LookedInto]:
    """Every such use, but for test code: of an object of a class that is certainly a node and has no method of its own
    under that name, and of anything where only nodes have such a method."""
    looked = {row.place: row for row in (*_of_classes(workspace), *_of_anything(workspace))}
    yield from (looked[place] for place in sorted(looked))


_ONLY_NODES = ("get_logger", "get_clock")
"""What no other object has, unless a file gives it one."""
_CLOCK = "now"


def _of_anything(workspace: WorkspaceIndex) -> Iterator[LookedInto]:
    for method in _ONLY_NODES:
        if any(_gives_its_own(workspace, path) is not False for path in files_with(workspace, method)):
            continue
        for path in workspace.python_files(mentioning=method):
            for row in _read_of_methods(workspace, path) or ():
                if method in (row.method, row.asked):
                    of_clock = row.method == _CLOCK
                    yield LookedInto(Place(path, *row.span), row.owner, row.method, row.name, False, of_clock)


@dataclass(frozen=True)
class _Row:
    span: facts.Span
    owner: str
    method: str
    name: str
    asked: str
    """``get_clock`` where the method is one of a clock."""


@kept_for_each_file
def _read_of_methods(code: facts.Facts) -> list[_Row]:
    expecting = tried_for(code.body, {"AttributeError"})
    modules = [part.module for part in everything_in(code.body, facts.Import)]
    modules += [part.module for part in everything_in(code.body, facts.ImportFrom)]
    if not any(module.partition(".")[0] == "rclpy" for module in modules):
        return []
    rows = []
    for part in everything_in(code.body, facts.Attribute):
        match part.value:
            case facts.Attribute(attr="get_logger" | "get_clock" as method, value=owner):
                if owner.dotted == "self":  # what that is, its class says
                    continue
                row = _Row(part.span, owner.dotted, method, part.attr, "")
            case facts.Attribute(
                attr="now", value=facts.Call(func=facts.Attribute(attr="get_clock") as asked, args=[])
            ):
                row = _Row(part.span, f"{asked.dotted}()" if asked.dotted else "", _CLOCK, part.attr, "get_clock")
            case _:
                continue
        if not part.attr.startswith("__") and Itself[facts.Base](part) not in expecting:
            rows.append(row)
    return rows


@kept_for_each_file
def _gives_its_own(code: facts.Facts) -> bool:
    """Whether a file gives an object such an attribute, or makes a property of one."""
    functions = (part for part in everything_in(code.body, facts.Function) if part.decorators)
    if any(function.name in (*_ONLY_NODES, _CLOCK) for function in functions):
        return True
    return any(target.last_name in _ONLY_NODES for target in targets_of(code.body))


def _of_classes(workspace: WorkspaceIndex) -> Iterator[LookedInto]:
    for cls in classes_asked_for(workspace):
        rows = _looked_into(workspace, cls)
        if rows and is_node_class(workspace, cls):
            yield from (row for row in _of_node(cls, rows) if not has_its_own(workspace, cls, row.method))


@kept_for_each_class
def _looked_into(code: facts.Class) -> list[tuple[str, str, facts.Span]]:
    """What the methods of a class read of an attribute of ``self`` that begins like a method."""
    rows = []
    for function in methods_of(code):
        if not has_self(function):
            continue
        readers = {Itself[facts.Base](part.value): part for part in everything_in(function.body, facts.Attribute)}
        for part in attributes_of_self(function.body):
            reader = readers.get(Itself[facts.Base](part))
            if reader is not None and not reader.attr.startswith("__"):
                rows.append((part.attr, reader.attr, reader.span))
    return rows


def _of_node(cls: ClassInFile, rows: list[tuple[str, str, facts.Span]]) -> Iterator[LookedInto]:
    for method, name, span in rows:
        signatures = signatures_of(f"rclpy.node.Node.{method}")
        if signatures:
            needs = any(signature.mismatch(0, (), True) is not None for signature in signatures.values())
            yield LookedInto(Place(cls.file, *span), "self", method, name, needs)


def is_node_class(workspace: WorkspaceIndex, cls: ClassInFile) -> bool:
    """Whether a class is certainly one of nodes, of which all bases are known."""
    chain = chain_of(workspace, cls)
    return members_of(workspace, chain) is not None and not NODE_CLASSES.isdisjoint(chain.foreign)


def has_its_own(workspace: WorkspaceIndex, cls: ClassInFile, method: str) -> bool:
    """Whether a class of the object, or one derived from it, gives the name another meaning."""
    chains = [chain_of(workspace, cls), *(chain_of(workspace, derived) for derived in derived_from(workspace, cls))]
    return any(method in _given_by(each.code) for chain in chains for each in chain.own)


@once_for
def _given_by(code: facts.Class) -> frozenset[str]:
    """The names that a class and its methods give an object."""
    return frozenset(names_of_body(code)).union(
        target.attribute for target in targets_of(code.body) if target.attribute
    )


__all__ = ["LookedInto", "has_its_own", "is_node_class", "methods_looked_into"]
