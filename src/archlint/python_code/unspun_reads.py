"""Attributes that only a callback assigns, and that a function reads of an object which it has just made.

``node = Asker()`` and then ``node.future``: nothing has spun the node yet, so no callback has run.  Only what stands in
one block counts, with nothing between the two that is given the object or calls a method that leads to the assignment.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file, once
from archlint.place import Place
from archlint.python_code.class_chains import ClassInFile, classes_of, targets_of
from archlint.python_code.early_attribute_reads import caught_in
from archlint.python_code.late_attributes import LateSetter, gets_it_nowhere_else, set_by_callbacks
from archlint.python_code.methods_at_work import MethodsAtWork, methods_at_work
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import Itself, everything_in
from archlint.syntax.walk import blocks_of

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_OF_NODE = frozenset({"get_clock", "get_logger", "get_name", "get_namespace"})
"""The methods of a node that run no callback."""


@dataclass(frozen=True)
class UnspunRead:
    """A read of ``variable.name`` before any callback has run; ``setter`` is a method that assigns it."""

    place: Place
    cls: str
    name: str
    variable: str
    setter: str
    assigned: Place


@dataclass(frozen=True)
class _Row:
    """The same by the text of the file; ``number`` is that of the class among those of the file."""

    number: int
    name: str
    variable: str
    span: facts.Span
    setter: str
    assigned: facts.Span


@once
def unspun_reads(workspace: WorkspaceIndex) -> list[UnspunRead]:
    """Every such read in the files that were asked for, but for test code."""
    return [*_all(workspace)]


def _all(workspace: WorkspaceIndex) -> Iterator[UnspunRead]:
    for file, file_facts in workspace.code.asked_for():
        if workspace.roles.is_test(file.relative):
            continue
        classes, at = [*classes_of(file_facts)], partial(Place, file.relative)
        for row in _of_file(workspace, file.relative) or ():
            cls = ClassInFile(file.relative, classes[row.number])
            if gets_it_nowhere_else(workspace, cls, row.name):
                yield UnspunRead(at(*row.span), cls.code.name, row.name, row.variable, row.setter, at(*row.assigned))


@kept_for_each_file
def _of_file(file_facts: facts.Facts) -> list[_Row]:
    late = {
        code.name: _LateClass(number, code, setters)
        for number, code in enumerate(classes_of(file_facts))
        if (setters := set_by_callbacks(code))
    }
    if not late:
        return []
    bodies = [file_facts.body, *(function.body for function in everything_in(file_facts.body, facts.Function))]
    return [row for body in bodies for block in blocks_of(body) for row in _in_block(body, block, late)]


@dataclass(frozen=True)
class _LateClass:
    """A class, its number among those of its file, and its attributes that only callbacks assign."""

    number: int
    code: facts.Class
    setters: Mapping[str, LateSetter]


_Late = Mapping[str, _LateClass]
"""Such classes by their names."""


def _in_block(body: Sequence[facts.Stmt], block: Sequence[facts.Stmt], late: _Late) -> Iterator[_Row]:
    """The first such read of each object that a block makes, the block being part of the body of a function."""
    for index, statement in enumerate(block):
        match statement:
            case facts.Assign(targets=[facts.Name(id=variable)], value=facts.Call(func=facts.Name(id=name))) if (
                name in late and sum(target.variable == variable for target in targets_of(body)) == 1
            ):
                yield from _first_read(late[name], variable, block[index + 1 :], caught_in(body))


def _first_read(
    cls: _LateClass, variable: str, statements: Sequence[facts.Stmt], caught: set[Itself[facts.Base]]
) -> Iterator[_Row]:
    """What of an object in a variable some statements read first, if nothing gives it a value before."""
    work = methods_at_work(cls.code)
    for statement in statements:
        read = _read_in(statement, variable, cls.setters)
        if read is not None and Itself[facts.Base](statement) not in caught:
            setter = cls.setters[read.attr]
            yield _Row(cls.number, read.attr, variable, read.span, setter.method, setter.span)
        if read is not None or not _leaves_alone(statement, variable, work, cls.setters):
            return


def _read_in(statement: facts.Stmt, variable: str, setters: Mapping[str, LateSetter]) -> facts.Attribute | None:
    """The attribute that a statement reads before it does anything with the object."""
    match statement:
        case facts.Expression(value=value) | facts.Assign(value=value):
            part = value
        case facts.If(test=test) | facts.While(test=test):
            part = test
        case _:
            return None
    every = [*everything_in([part])]
    read = next((each for each in every if _of(each, variable) in setters), None)
    if not isinstance(read, facts.Attribute):
        return None
    for each in every:
        around = any(inner is read for inner in everything_in([each]))
        if around and isinstance(each, _MAY_NOT_READ):
            return None
        if not around and isinstance(each, facts.Call) and _has(each, variable) and each.func.last_name not in _OF_NODE:
            return None
    return read


_MAY_NOT_READ = (facts.Boolean, facts.Conditional, facts.Lambda, facts.Comprehension)


def _of(part: facts.Base, variable: str) -> str | None:
    """The name of an attribute of a variable."""
    match part:
        case facts.Attribute(value=facts.Name(id=owner), attr=name) if owner == variable:
            return name
    return None


def _has(part: facts.Base, variable: str) -> bool:
    return any(name.id == variable for name in everything_in([part], facts.Name))


def _leaves_alone(statement: facts.Stmt, variable: str, work: MethodsAtWork, setters: Mapping[str, LateSetter]) -> bool:
    """Whether no callback of an object can run in a statement, nor a method that assigns one of its attributes."""
    every = [*everything_in([statement])]
    named = sum(isinstance(part, facts.Name) and part.id == variable for part in every)
    asked = [name for part in every if (name := _of(part, variable)) is not None]
    own = {name for name in asked if name in work.methods}
    if named > len(asked) or any(name not in own | _OF_NODE for name in asked):
        return False
    return work.after(own).isdisjoint(method for setter in setters.values() for method in setter.methods)


__all__ = ["UnspunRead", "unspun_reads"]
