"""Methods that objects of the workspace's own classes do not have, and classes that a service or an action does not.

The class of an object is known where one call of the class is all that its variable, or its attribute of ``self``, is
ever assigned.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.place import Place
from archlint.python_code.class_chains import ClassInFile, chain_of, classes_of, files_with, methods_of, targets_of
from archlint.python_code.offered_names import MAKES_NAMES
from archlint.python_code.own_calls import assigned_attributes, bindings_of, class_meant_by
from archlint.python_code.tried_code import tried_for
from archlint.python_code.unassigned_attributes import may_get, members_of
from archlint.suggestions import nearest
from archlint.syntax import facts
from archlint.syntax.parts import Itself, everything_in, once_for

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_OF_INTERFACES = {
    "srv": frozenset({"Event", "Request", "Response"}),
    "action": frozenset({"Feedback", "Goal", "Impl", "Result"}),
}


@dataclass(frozen=True)
class AbsentMember:
    """``owner`` has no ``name``; ``near`` is what it has of almost the same name.  Where the class of a message was
    written and an object of it is meant, ``near`` is the variable that holds one, if there is any."""

    place: Place
    owner: str
    name: str
    near: str
    called: bool
    of_message: bool = False
    """Whether an object of the class is meant: something is looked for in it."""
    methods: tuple[str, ...] = ()
    """What an object of a class of the workspace can be called for, in the order of the source."""


def absent_members(workspace: WorkspaceIndex) -> Iterator[AbsentMember]:
    """Every such use in the files that were asked for, but for test code."""
    for path in workspace.python_files():
        for row in _of_interfaces(workspace, path) or ():
            if workspace.interfaces is None or workspace.interfaces.get(row.owner) is None:
                continue
            yield AbsentMember(Place(path, *row.span), row.owner, row.name, row.near, False, row.of_message)
        for called in _calls(workspace, path) or ():
            absent = _absent(workspace, path, called)
            if absent is not None:
                yield absent


# --------------------------------------------------------------------------------------------------- services, actions


@dataclass(frozen=True)
class _OfInterface:
    span: facts.Span
    owner: str
    name: str
    near: str
    of_message: bool


@kept_for_each_file
def _of_interfaces(code: facts.Facts) -> list[_OfInterface]:
    kinds: dict[str, tuple[str, frozenset[str]]] = {}
    for statement in everything_in(code.body, facts.ImportFrom):
        has = _OF_INTERFACES.get(statement.module.rpartition(".")[2])
        for name, bound in statement.names if has and "." in statement.module else ():
            if bindings_of(code)[bound] == 1:
                kinds[bound] = (f"{statement.module.replace('.', '/')}/{name}", has or frozenset())
    rows = []
    for part in everything_in(code.body, facts.Attribute) if kinds else ():
        owner, has = kinds.get(part.value.variable, ("", frozenset()))
        if owner and part.attr not in has and not part.attr.startswith("_"):
            of_message = Itself[facts.Base](part) in _looked_into(code)
            near = next((name for name in has if name.lower() == part.attr.lower()), "")
            if of_message:
                near = part.attr if Itself[facts.Base](part) in _beside_variables(code) else ""
            rows.append(_OfInterface(part.span, owner, part.attr, near, of_message))
    return rows


@once_for
def _looked_into(code: facts.Facts) -> frozenset[Itself[facts.Base]]:
    """What the code takes an attribute of."""
    return frozenset(Itself[facts.Base](part.value) for part in everything_in(code.body, facts.Attribute))


@once_for
def _beside_variables(code: facts.Facts) -> frozenset[Itself[facts.Base]]:
    """The attributes that stand in a function which has a parameter, or a variable, of the very name."""
    rows: set[Itself[facts.Base]] = set()
    for function in everything_in(code.body, facts.Function):
        names = {param.name for param in function.params}
        names.update(target.variable for target in targets_of(function.body) if target.variable)
        attributes = everything_in(function.body, facts.Attribute)
        rows.update(Itself[facts.Base](part) for part in attributes if part.attr in names)
    return frozenset(rows)


# ------------------------------------------------------------------------------------------------ the workspace's own


@dataclass(frozen=True)
class _Called:
    """A method that is called on an object which one call makes."""

    span: facts.Span
    name: str
    made_by: str
    """The class that makes it, as it is written."""
    attribute: str
    """The attribute of ``self`` that holds it; empty where it is a variable."""


@kept_for_each_file
def _calls(code: facts.Facts) -> list[_Called]:
    if not MAKES_NAMES.isdisjoint(code.names):
        return []
    variables = _made(code)
    forgiven = tried_for(code.body, {"AttributeError"})
    rows: list[tuple[facts.Attribute, str, str]] = []
    for call in everything_in(code.body, facts.Call):
        match call.func:
            case facts.Attribute(value=facts.Name(id=name)) as part if name in variables:
                if bindings_of(code)[name] == 1:
                    rows.append((part, variables[name], ""))
    for cls in classes_of(code):
        attributes = _made_for(cls)
        for call in everything_in(cls.body, facts.Call) if attributes else ():
            match call.func:
                case facts.Attribute(value=facts.Attribute(value=facts.Name(id="self"), attr=attr)) as part:
                    if attr in attributes:
                        rows.append((part, attributes[attr], attr))
    return [
        _Called(part.span, part.attr, made_by, attribute)
        for part, made_by, attribute in rows
        if Itself[facts.Base](part) not in forgiven
    ]


def _made(code: facts.Facts) -> dict[str, str]:
    """The variables that a call of a plain name makes, and that name."""
    return {
        statement.targets[0].variable: statement.value.func.variable
        for statement in everything_in(code.body, facts.Assign)
        if len(statement.targets) == 1 and statement.targets[0].variable
        if isinstance(statement.value, facts.Call) and statement.value.func.variable
    }


def _made_for(cls: facts.Class) -> dict[str, str]:
    """The attributes of ``self`` that the methods of a class assign once, to what a call of a plain name makes."""
    times = [target.attribute for target in targets_of(cls.body) if target.attribute]
    makers = {}
    for statement in everything_in(cls.body, facts.Assign):
        match statement:
            case facts.Assign(
                targets=[facts.Attribute(value=facts.Name(id="self"), attr=attr)],
                value=facts.Call(func=facts.Name(id=name)),
            ) if times.count(attr) == 1:
                makers[attr] = name
    return makers


def _absent(workspace: WorkspaceIndex, file: str, called: _Called) -> AbsentMember | None:
    cls = class_meant_by(workspace, file, called.made_by)
    if cls is None or (called.attribute and _is_given_elsewhere(workspace, file, called.attribute)):
        return None
    return absent_of(workspace, cls, called.name, Place(file, *called.span))


def absent_of(
    workspace: WorkspaceIndex, cls: ClassInFile, name: str, place: Place, called: bool = True
) -> AbsentMember | None:
    """What is to say of an attribute that is read of an object of a class; None where it may have it."""
    chain = chain_of(workspace, cls)
    members = members_of(workspace, chain)
    if members is None or any(name in names for names in members) or may_get(workspace, cls, name):
        return None
    if any(method.name == "__new__" for own in chain.own for method in methods_of(own.code)):
        return None  # a call of the class may make something else
    own = {each for names in members for each in names if not each.startswith("__")}
    methods = dict.fromkeys(method.name for each in chain.own for method in methods_of(each.code))
    offered = tuple(method for method in methods if not method.startswith("_"))
    near = nearest(name, own) or ""
    return AbsentMember(place, f"class {cls.code.name}", name, near, called, methods=offered)


def _is_given_elsewhere(workspace: WorkspaceIndex, file: str, attribute: str) -> bool:
    """Whether another class of the file, or another file, assigns an attribute of that name: it may be the same one."""
    rows = 0
    for path in dict.fromkeys((file, *files_with(workspace, attribute))):
        assigned = assigned_attributes(workspace, path)
        if assigned is None:
            return True
        rows += assigned.get(attribute, 0)
    return rows != 1


__all__ = ["AbsentMember", "absent_members", "absent_of"]
