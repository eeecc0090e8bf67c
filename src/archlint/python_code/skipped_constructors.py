"""Base classes whose constructor never runs, as the class of nodes stands before them.

Source: ``Node.__init__`` in rclpy/node.py calls no other constructor, so ``super().__init__('name')`` of a class
``Robot(Node, Machine)`` ends there.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.place import Place
from archlint.python_code.class_chains import (
    Chain,
    ClassInFile,
    chain_of,
    class_named,
    classes_asked_for,
    derived_from,
    methods_of,
    targets_of,
)
from archlint.python_code.methods_at_work import of_self
from archlint.python_code.unassigned_attributes import (
    attributes_of_self,
    has_self,
    members_of,
    names_of_body,
)
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_NODE = "rclpy.node.Node"
_INIT = "__init__"


@dataclass(frozen=True)
class SkippedConstructor:
    """The base of a class of nodes whose constructor does not run, and an attribute that is missing then."""

    place: Place
    """Of the base, in the line of the class."""
    cls: str
    base: str
    attribute: str
    read: Place


def skipped_constructors(workspace: WorkspaceIndex) -> Iterator[SkippedConstructor]:
    """Every such base whose constructor alone gives the object an attribute that its methods read."""
    for cls in classes_asked_for(workspace):
        given = (base.value for base in cls.code.bases if base.keyword is None and not base.star)
        bases = [base for base in given if isinstance(base, (facts.Name, facts.Attribute))]
        if len(bases) < 2 or len(bases) < len(cls.code.bases):
            continue
        meant = [class_named(workspace, cls.file, base.dotted) for base in bases]
        if _NODE not in meant or _may_call_others(workspace, cls):
            continue
        for base, other in [*zip(bases, meant, strict=True)][meant.index(_NODE) + 1 :]:
            row = _missing(workspace, cls, other) if isinstance(other, ClassInFile) else None
            if row is not None:
                yield SkippedConstructor(Place(cls.file, *base.span), cls.code.name, base.last_name, *row)


def _may_call_others(workspace: WorkspaceIndex, cls: ClassInFile) -> bool:
    """Whether a class, or one derived from it, calls a constructor otherwise than by ``super().__init__()``."""
    return any(_calls_others(each.code) for each in (cls, *derived_from(workspace, cls)))


def _calls_others(code: facts.Class) -> bool:
    for attribute in everything_in(code.body, facts.Attribute):
        if attribute.attr == _INIT:
            match attribute.value:
                case facts.Call(func=facts.Name(id="super"), args=[]):
                    continue
            return True
    return False


def _missing(workspace: WorkspaceIndex, cls: ClassInFile, base: ClassInFile) -> tuple[str, Place] | None:
    """The first attribute that only the constructor of a base would give an object of a class, and where it is read."""
    chain, own = chain_of(workspace, cls), chain_of(workspace, base)
    if members_of(workspace, chain) is None or own.foreign or len(own.own) != 1:
        return None
    constructor = next((method for method in methods_of(base.code) if method.name == _INIT), None)
    given = _given_by(constructor.body) if constructor is not None and has_self(constructor) else set()
    others = _given_elsewhere(workspace, cls, chain, constructor) if given else set()
    for each in (base, cls):
        for method in methods_of(each.code):
            if method is constructor or not has_self(method):
                continue
            for part in attributes_of_self(method.body):
                if part.attr in given - others:
                    return part.attr, Place(each.file, *part.span)
    return None


def _given_by(body: Sequence[facts.Stmt]) -> set[str]:
    """The attributes that code gives ``self``, but for what it makes of their own value: ``self.on = not self.on``."""
    names: set[str] = set()
    for target in targets_of(body):
        names |= {name for name in (of_self(target),) if name is not None}
    plain: set[str] = set()
    changed: set[str] = set()
    for assignment in everything_in(body, facts.Assign):
        read = {of_self(part) for part in everything_in([assignment.value], facts.Attribute)}
        for target in assignment.targets:
            name = of_self(target)
            if name is not None:
                (changed if name in read else plain).add(name)
    return names - (changed - plain)


def _given_elsewhere(
    workspace: WorkspaceIndex, cls: ClassInFile, chain: Chain, constructor: facts.Function | None
) -> set[str]:
    """What other methods and the bodies of all its classes give an object, and code of its file that has it in a
    variable."""
    names: set[str] = set()
    for each in (*chain.own, *derived_from(workspace, cls)):
        names.update(names_of_body(each.code))
        for method in methods_of(each.code):
            names |= set() if method is constructor else _given_by(method.body)
    file = workspace.facts_at(cls.file)
    others = () if file is None else targets_of(file.body)
    return names | {target.attribute for target in others if of_self(target) is None}


__all__ = ["SkippedConstructor", "skipped_constructors"]
