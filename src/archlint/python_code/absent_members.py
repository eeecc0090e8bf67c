"""Methods that objects of the workspace's own classes do not have, and classes that a service or an action does not."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.place import Place
from archlint.python_code.class_chains import ClassInFile, chain_of, methods_of, targets_of
from archlint.python_code.made_objects import CallOfObject, calls_of_objects, class_of_object
from archlint.python_code.own_calls import bindings_of
from archlint.python_code.unassigned_attributes import may_get, members_of
from archlint.records import dataclass
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
    of_objects: bool = False
    """Whether a class is asked for what only its objects have."""


def absent_members(workspace: WorkspaceIndex) -> Iterator[AbsentMember]:
    """Every such use in the files that were asked for, but for test code."""
    for path in workspace.python_files():
        for row in _of_interfaces(workspace, path) or ():
            if workspace.interfaces is None or workspace.interfaces.get(row.owner) is None:
                continue
            yield AbsentMember(Place(path, *row.span), row.owner, row.name, row.near, False, row.of_message)
        for called in calls_of_objects(workspace, path) or ():
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


def _absent(workspace: WorkspaceIndex, file: str, called: CallOfObject) -> AbsentMember | None:
    cls = None if "AttributeError" in called.forgiven else class_of_object(workspace, file, called)
    return None if cls is None else absent_of(workspace, cls, called.name, Place(file, *called.span))


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


__all__ = ["AbsentMember", "absent_members", "absent_of"]
