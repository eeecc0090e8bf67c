"""Methods of which code takes an item instead of calling them: ``self.drive_to[2]``, ``self.get_parameter['rate']``."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.libraries.api_signatures import signatures_of
from archlint.place import Place
from archlint.python_code.class_chains import (
    ClassInFile,
    classes_asked_for,
    derived_from,
    kept_for_each_class,
    methods_of,
)
from archlint.python_code.methods_at_work import of_self
from archlint.python_code.methods_looked_into import has_its_own, is_node_class
from archlint.python_code.own_calls import method_meant
from archlint.python_code.tried_code import tried_for
from archlint.python_code.unassigned_attributes import attributes_of_self, has_self, names_of_body
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import Itself, everything_in

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex


@dataclass(frozen=True)
class IndexedMethod:
    """``self.method[…]``; a method of the workspace has a place where it is ``defined``, one of a node has none."""

    place: Place
    method: str
    defined: Place | None


def indexed_methods(workspace: WorkspaceIndex) -> Iterator[IndexedMethod]:
    """Every such use in the files that were asked for, but for test code."""
    for cls in classes_asked_for(workspace):
        for name, span in _indexed(workspace, cls):
            place, own = Place(cls.file, *span), method_meant(workspace, cls, name)
            if own is not None and not _is_replaced_below(workspace, cls, name):
                yield IndexedMethod(place, name, Place(own.file, *own.code.name_span))
            elif own is None and _is_of_node(workspace, cls, name):
                yield IndexedMethod(place, name, None)


@kept_for_each_class
def _indexed(code: facts.Class) -> list[tuple[str, facts.Span]]:
    """The attributes of ``self`` of which the methods of a class take an item."""
    expecting = tried_for(code.body, {"TypeError", "Exception", ""})
    rows = []
    for function in methods_of(code):
        own = {Itself[facts.Base](part) for part in attributes_of_self(function.body)} if has_self(function) else set()
        for part in everything_in(function.body, facts.Subscript):
            name = of_self(part.value)
            if name is not None and Itself[facts.Base](part.value) in own and Itself[facts.Base](part) not in expecting:
                rows.append((name, part.span))
    return rows


def _is_replaced_below(workspace: WorkspaceIndex, cls: ClassInFile, name: str) -> bool:
    """Whether the body of a derived class gives the name another meaning."""
    return any(name in names_of_body(derived.code) for derived in derived_from(workspace, cls))


def _is_of_node(workspace: WorkspaceIndex, cls: ClassInFile, name: str) -> bool:
    """Whether a name is that of a method which the objects of a class have of rclpy's nodes."""
    signatures = signatures_of(f"rclpy.node.Node.{name}")
    return bool(signatures) and is_node_class(workspace, cls) and not has_its_own(workspace, cls, name)


__all__ = ["IndexedMethod", "indexed_methods"]
