"""Methods that an attribute of the same name hides, since ``__init__()`` gives the object a plain value there.

``self.heading = None`` above ``def heading(self):`` leaves ``self.heading()`` nothing that can be called.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.place import Place
from archlint.python_code.block_bindings import after
from archlint.python_code.class_chains import (
    ClassInFile,
    chain_of,
    classes_asked_for,
    derived_from,
    kept_for_each_class,
    methods_of,
)
from archlint.python_code.methods_at_work import INIT, of_self
from archlint.python_code.plain_kinds import assigned_by, kind_of, values_of_self
from archlint.python_code.tried_code import tried_for
from archlint.python_code.unassigned_attributes import may_be_set
from archlint.python_code.used_nothing import tests_in
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.bindings import bound_by
from archlint.syntax.control_flow import graph_of
from archlint.syntax.parts import Itself, everything_in, parts_of

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_WATCHES = frozenset({"__getattr__", "__getattribute__", "__setattr__", "__slots__"})


@dataclass(frozen=True)
class HiddenMethod:
    """An assignment that hides the method ``name``, and a call of it that fails for that."""

    place: Place
    cls: str
    name: str
    called: Place


@dataclass(frozen=True)
class _Row:
    name: str
    span: facts.Span
    calls: tuple[facts.Span, ...]


def hidden_methods(workspace: WorkspaceIndex) -> Iterator[HiddenMethod]:
    """Every such assignment in the classes of the files that were asked for, once for each call; not in test code."""
    for cls in classes_asked_for(workspace):
        for row in _rows(workspace, cls):
            if _is_whole(workspace, cls, row.name) and not may_be_set(workspace, cls, row.name):
                place = Place(cls.file, *row.span)
                yield from (HiddenMethod(place, cls.code.name, row.name, Place(cls.file, *call)) for call in row.calls)


def _is_whole(workspace: WorkspaceIndex, cls: ClassInFile, name: str) -> bool:
    """Whether no class of the workspace above or below one has a say in what its attribute holds.  A base that is not
    known has none: it knows neither the method nor the attribute."""
    if cls.code.decorators or any(base.keyword is not None or base.star for base in cls.code.bases):
        return False
    others = [*chain_of(workspace, cls).own[1:], *derived_from(workspace, cls)]
    bodies = [_names_of(other.code) for other in others]
    watches = any(_WATCHES & names for names in (_names_of(cls.code), *bodies))
    return not watches and not any(name in names for names in bodies)


def _names_of(code: facts.Class) -> frozenset[str]:
    """What the body of a class binds, and what its methods give their object."""
    return frozenset(name for part in code.body for name in bound_by(part)) | frozenset(values_of_self(code))


@kept_for_each_class
def _rows(code: facts.Class) -> list[_Row]:
    methods = [*methods_of(code)]
    plain = {method.name for method in methods if not method.decorators}
    constructors = [method for method in methods if method.name == INIT]
    if len(constructors) != 1:
        return []
    values = values_of_self(code)
    hidden = {
        name
        for name in plain & values.keys()
        if all(map(_is_no_function, values[name])) and [*_bound(code)].count(name) == 1
    }
    asked = _asked_in(code) if hidden else set()
    rows = []
    for statement in constructors[0].body:
        for target, _ in assigned_by(statement) if isinstance(statement, facts.Assign) else ():
            name = of_self(target)
            if name in hidden - asked and (span := getattr(target, "span", None)) is not None:
                hidden.discard(name)
                rows.append(_Row(name, span, tuple(_calls_after(code, constructors[0], statement, name))))
    return rows


def _bound(code: facts.Class) -> Iterator[str]:
    """The names that the body of a class binds, one for each time."""
    return (name for part in code.body for name in bound_by(part))


def _is_no_function(value: facts.Expr | None) -> bool:
    """Whether a value can certainly not be called."""
    match value:
        case facts.Literal():
            return True
        case facts.Call(func=facts.Attribute(value=facts.Name(id="math"))):
            return True
    return value is not None and kind_of(value, {}) is not None


def _asked_in(code: facts.Class) -> set[str]:
    """The attributes that conditions of a class look at without calling them: what hangs on these is not known."""
    tests = [test for part in everything_in(code.body) for test in tests_in(part)]
    called = {Itself[facts.Base](call.func) for call in everything_in(tests, facts.Call)}
    looked_at = (part for part in everything_in(tests, facts.Attribute) if Itself[facts.Base](part) not in called)
    return {name for part in looked_at if (name := of_self(part)) is not None}


def _calls_after(
    code: facts.Class, constructor: facts.Function, assignment: facts.Stmt, name: str
) -> Iterator[facts.Span]:
    """The calls of a method that come after the assignment: behind it, or in a method that only others start."""
    graph = graph_of(constructor.body)
    later = after(graph.at(assignment))
    yield from (span for block in graph.blocks if block in later for span in _calls_in(block.fact, name))
    early = _called_by(code, constructor)
    for method in methods_of(code):
        if method.name not in early and method is not constructor:
            yield from _calls_in_all(method.body, name)


def _called_by(code: facts.Class, constructor: facts.Function) -> set[str]:
    """The methods that a constructor calls, and those that these call: they may run before the assignment."""
    methods = {method.name: method for method in methods_of(code)}
    reached: set[str] = set()
    left = [constructor]
    while left:
        names = {of_self(call.func) for call in everything_in(left.pop().body, facts.Call)}
        new = {name for name in names if name is not None and name in methods} - reached
        reached |= new
        left += [methods[name] for name in new]
    return reached


def _calls_in(fact: facts.Base | None, name: str) -> Iterator[facts.Span]:
    calls = () if fact is None else parts_of(fact, facts.Call)
    return (call.span for call in calls if of_self(call.func) == name)


def _calls_in_all(body: Sequence[facts.Stmt], name: str) -> Iterator[facts.Span]:
    expecting = tried_for([*body], {"TypeError", "Exception", ""})
    for call in everything_in(body, facts.Call):
        if of_self(call.func) == name and Itself[facts.Base](call) not in expecting:
            yield call.span


__all__ = ["HiddenMethod", "hidden_methods"]
