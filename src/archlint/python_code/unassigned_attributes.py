"""Attributes of ``self`` that nothing ever assigns, and properties of a node that nobody can.

Source: ``Node`` in rclpy/node.py; all distributions refuse the same properties.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.libraries.api_signatures import attributes_of
from archlint.libraries.rclpy.names import NODE_CLASSES
from archlint.place import Place
from archlint.python_code.class_chains import (
    Chain,
    ClassInFile,
    chain_of,
    classes_asked_for,
    derived_from,
    files_with,
    kept_for_each_class,
    methods_of,
    targets_of,
)
from archlint.python_code.given_to_libraries import gives_itself_to_library
from archlint.python_code.message_variables import given_to_others
from archlint.python_code.unshared_objects import asked_in, may_be_given
from archlint.records import dataclass
from archlint.suggestions import distance, nearest
from archlint.syntax import facts
from archlint.syntax.parts import Itself, everything_in, once_for
from archlint.syntax.walk import called_name, statements_of

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

READ_ONLY = frozenset(
    {"clients", "context", "default_callback_group", "guards", "handle", "publishers", "services", "subscriptions"}
    | {"timers", "waitables"}
)
"""The properties of a node that refuse to be assigned."""
_NODE = "rclpy.node.Node"
_PLAIN = frozenset({"object", "abc.ABC"})
"""Foreign bases that bring nothing that code would ask for."""
_OF_ALL = frozenset(dir(object))
_SLIP = 2
"""By how many letters a name with one word more may differ from the one that was meant."""
_ANY_NAME = frozenset({"setattr", "vars", "__dict__", "__getattr__", "__getattribute__"})
"""What may give an object an attribute of any name."""
_BY_TEXT = ("setattr", "__setattr__", "__dict__", "vars")
"""What may make an attribute of any text."""


@dataclass(frozen=True)
class Overwritten:
    """``self.publishers = []`` in a node."""

    place: Place
    cls: str
    name: str


@dataclass(frozen=True)
class Unassigned:
    """A read of an attribute that the class does not have.  ``near`` is one that it has, assigned at a place; a
    ``local`` variable or parameter of the method may have the very name."""

    place: Place
    cls: str
    name: str
    near: str | None = None
    near_at: Place | None = None
    local: bool = False
    of_node: bool = False
    """Whether it is a method of a node, and this class is none."""
    is_node: bool = False
    """Whether the class is a node, and the attribute that of a class that has one."""

    @property
    def is_slip(self) -> bool:
        """Whether the near name is probably the one that was meant: it has the same words, or is off by a letter."""
        if self.near is None:
            return False
        alike = self.name.count("_") == self.near.count("_")
        return alike or distance(self.name, self.near, _SLIP) <= _SLIP


def overwritten_properties(workspace: WorkspaceIndex) -> Iterator[Overwritten]:
    """Every such assignment in a class that is certainly a node of rclpy."""
    for cls in classes_asked_for(workspace):
        properties = _set_on_self(workspace, cls)
        if not properties:
            continue
        chain = chain_of(workspace, cls)
        known = chain.complete and all(_of_foreign(path) is not None for path in chain.foreign)
        if not known or NODE_CLASSES.isdisjoint(chain.foreign):
            continue
        own = frozenset[str]().union(*(_taken_by(each.code) for each in chain.own))
        for name, span in properties:
            if name not in own:
                yield Overwritten(Place(cls.file, *span), cls.code.name, name)


def unassigned_attributes(workspace: WorkspaceIndex) -> Iterator[Unassigned]:
    """Every read of an attribute that no class of the object gives it, where an almost equal one is there or the
    workspace makes objects of that very class."""
    for cls in classes_asked_for(workspace):
        chain = chain_of(workspace, cls)
        members = members_of(workspace, chain)
        if members is None:
            continue
        missing = [read for read in _reads(workspace, cls) if not any(read.name in names for names in members)]
        assigned = _assigned_in(chain) if missing else {}
        for read in missing:
            near = nearest(read.name, _candidates(assigned, read))
            if (near is None and not _is_made(workspace, cls)) or may_get(workspace, cls, read.name):
                continue
            at = None if near is None else assigned[near].place
            in_node = not NODE_CLASSES.isdisjoint(chain.foreign)
            of_node = read.called and read.name in (attributes_of(_NODE) or ()) and not in_node
            is_node = in_node and read.name in ("_node", "node")
            place = Place(cls.file, *read.span)
            yield Unassigned(place, cls.code.name, read.name, near, at, read.local, of_node, is_node)


@once_for
def _taken_by(code: facts.Class) -> frozenset[str]:
    """The names that the body of a class gives its objects, and the properties that it takes in a way of its own: all
    of them, with ``__setattr__``."""
    names = frozenset(names_of_body(code))
    return names | READ_ONLY if "__setattr__" in names else names


@kept_for_each_class
def _set_on_self(code: facts.Class) -> list[tuple[str, facts.Span]]:
    """The properties of a node that methods of a class assign to ``self``."""
    rows = []
    for function in methods_of(code):
        written = {Itself(target) for target in targets_of(function.body)} if has_self(function) else set()
        of_self = attributes_of_self(function.body) if written else ()
        parts = (part for part in of_self if part.attr in READ_ONLY and Itself[facts.Base](part) in written)
        rows += [(part.attr, part.span) for part in parts]
    return rows


# ------------------------------------------------------------------------------------------------ what a class has


def members_of(workspace: WorkspaceIndex, chain: Chain) -> list[frozenset[str]] | None:
    """All that an object of a class has, by what gives it that; None where it may have more."""
    foreign = [_of_foreign(path) for path in chain.foreign]
    if not chain.complete or any(names is None for names in foreign):
        return None
    own = [_of_class(workspace, cls) for cls in chain.own]
    if any(names is None for names in own) or gives_itself_to_library(workspace, chain):
        return None
    return [_OF_ALL, *filter(None, foreign), *filter(None, own)]


def _of_foreign(path: str) -> frozenset[str] | None:
    return frozenset() if path in _PLAIN else attributes_of(path)


@kept_for_each_class
def _of_class(code: facts.Class) -> frozenset[str] | None:
    """The names that the body of a class and its methods give an object; None where they may give any."""
    if any(part.last_name in _ANY_NAME for part in everything_in(code.body, facts.Name)):
        return None
    if any(part.attr in _ANY_NAME for part in everything_in(code.body, facts.Attribute)):
        return None
    names = {*names_of_body(code)}
    if names & _ANY_NAME:
        return None
    return frozenset(names.union(target.attribute for target in targets_of(code.body) if target.attribute))


def names_of_body(code: facts.Class) -> Iterator[str]:
    """The names that the body of a class binds."""
    for statement in statements_of(code.body):
        match statement:
            case facts.Function(name=name) | facts.Class(name=name):
                yield name
            case facts.Import(module=module, alias=alias):
                yield alias or module.partition(".")[0]
            case facts.ImportFrom(names=names):
                yield from (bound for _, bound in names)
            case _:
                yield from (target.variable for target in targets_of([statement]) if target.variable)


@dataclass(frozen=True)
class _Member:
    """What a class has, and where it first gets it."""

    place: Place
    is_method: bool = False


def _assigned_in(chain: Chain) -> dict[str, _Member]:
    """What the methods of a class assign to ``self``, and its methods."""
    assigned: dict[str, _Member] = {}
    for cls in chain.own:
        for name, (span, is_method) in _assigned_by(cls.code).items():
            assigned.setdefault(name, _Member(Place(cls.file, *span), is_method))
    return assigned


@once_for
def _assigned_by(code: facts.Class) -> dict[str, tuple[facts.Span, bool]]:
    """The same of one class, by its text: where each name first gets its value, and whether that is a method."""
    assigned: dict[str, tuple[facts.Span, bool]] = {}
    for function in methods_of(code):
        assigned.setdefault(function.name, (function.name_span, True))
        for target in targets_of(function.body):
            match target:
                case facts.Attribute(value=facts.Name(id="self"), attr=name):
                    assigned.setdefault(name, (target.span, False))
    return assigned


# ------------------------------------------------------------------------------------------------ what code reads


@dataclass(frozen=True)
class _Read:
    """A read of ``self.name``.

    One that is ``looked_into`` (``self.name.x``, ``self.name[0]``) is that of no method, and one that is ``called``
    hardly that of data.  ``local`` says whether the method has a variable or parameter of that name.
    """

    name: str
    span: facts.Span
    looked_into: bool
    called: bool
    local: bool


def _candidates(assigned: Mapping[str, _Member], read: _Read) -> list[str]:
    """What may have been meant."""
    return [
        name
        for name, member in assigned.items()
        if not (read.looked_into if member.is_method else read.called and _count(name) != _count(read.name))
    ]


def _count(name: str) -> int:
    """Of how many words a name is."""
    return name.strip("_").count("_")


@kept_for_each_class
def _reads(code: facts.Class) -> list[_Read]:
    """The attributes of ``self`` that the methods of a class read, or call; the first read of each name."""
    seen: set[str] = set()
    reads = []
    for function in methods_of(code):
        if not has_self(function):
            continue
        written = {Itself(target) for target in targets_of(function.body)}
        owners = {Itself(owner) for owner in _owners(function.body)}
        called = {Itself(call.func) for call in everything_in(function.body, facts.Call)}
        variables = {target.variable for target in targets_of(function.body)} | {p.name for p in function.params}
        for part in attributes_of_self(function.body):
            key = Itself[facts.Base](part)
            if key not in written and part.attr not in seen and not part.attr.startswith("__"):
                seen.add(part.attr)
                reads.append(_Read(part.attr, part.span, key in owners, key in called, part.attr in variables))
    return reads


def _owners(body: Sequence[facts.Stmt]) -> Iterator[facts.Base]:
    """What code looks for attributes or items in."""
    for part in everything_in(body):
        match part:
            case facts.Attribute(value=owner) | facts.Subscript(value=owner):
                yield owner


def has_self(function: facts.Function) -> bool:
    """Whether the first parameter of a method is the object, of no type that is said."""
    if any(decorator.last_name in ("staticmethod", "classmethod") for decorator in function.decorators):
        return False
    match function.params:
        case [facts.Param(name="self", annotation=None), *_]:
            return True
    return False


def attributes_of_self(body: Sequence[facts.Base]) -> Iterator[facts.Attribute]:
    """The attributes of ``self`` in a method.  What has a ``self`` of its own is left out, and what is tried in case
    that an attribute is missing."""
    stack = list(reversed(body))
    while stack:
        part = stack.pop()
        match part:
            case facts.Class() | facts.Delete():
                continue
            case facts.Function(params=params) | facts.Lambda(params=params) if any(p.name == "self" for p in params):
                continue
            case facts.Try(handlers=handlers, orelse=orelse, final=final) if any(
                "AttributeError" in handler.caught for handler in handlers
            ):
                stack += reversed([*handlers, *orelse, *final])
                continue
            case facts.Attribute(value=facts.Name(id="self")):
                yield part
        stack += reversed(part.children())


# ------------------------------------------------------------------------------------- what else gives an attribute


def _is_made(workspace: WorkspaceIndex, cls: ClassInFile) -> bool:
    """Whether code of the workspace calls a class by its name: it is no base for others alone."""
    files = files_with(workspace, cls.code.name)
    return any(cls.code.name in (called_in(workspace, file) or ()) for file in files)


@kept_for_each_file
def called_in(file_facts: facts.Facts) -> frozenset[str]:
    """The last names of all that a file calls."""
    return frozenset(called_name(call) for call in everything_in(file_facts.body, facts.Call))


def may_get(workspace: WorkspaceIndex, cls: ClassInFile, name: str) -> bool:
    """Whether a class that derives from one, or another base of such a class, has a name; or any code of the workspace
    assigns it to an object that is not ``self``, or may give it by a text.  Code that
    cannot have the object is left out."""
    for derived in derived_from(workspace, cls):
        members = members_of(workspace, chain_of(workspace, derived))
        if members is None or any(name in names for names in members):
            return True
    return may_be_set(workspace, cls, name)


def may_be_set(workspace: WorkspaceIndex, cls: ClassInFile, name: str) -> bool:
    """Whether code of the workspace that may have an object of a class gives it an attribute from outside."""
    variables = _variables_of(workspace, cls.file)
    if variables is None or cls.code.name in variables:
        return True  # another class under its name
    given = may_be_given(workspace, cls, name)
    if given is not None:
        return given
    texts = any(workspace.code.files_that_mention(word) for word in _BY_TEXT)
    files = (cls.file, *files_with(workspace, name))
    return any(_gives(workspace, file, name, texts) for file in files)


def _gives(workspace: WorkspaceIndex, file: str, name: str, texts: bool) -> bool:
    file_facts, given = workspace.facts_at(file), given_to_others(workspace, file)
    if file_facts is None or given is None or name in given | asked_in(file_facts):
        return True
    return texts and name in _texts_of(file_facts)


@kept_for_each_file
def _variables_of(file_facts: facts.Facts) -> frozenset[str]:
    """The variables that a file assigns anywhere."""
    return frozenset(name for target in targets_of(file_facts.body) if (name := target.variable) is not None)


@once_for
def _texts_of(file_facts: facts.Facts) -> frozenset[str]:
    literals = everything_in(file_facts.body, facts.Literal)
    return frozenset(literal.value for literal in literals if isinstance(literal.value, str))


__all__ = [
    "READ_ONLY",
    "Overwritten",
    "Unassigned",
    "attributes_of_self",
    "called_in",
    "has_self",
    "may_be_set",
    "may_get",
    "members_of",
    "names_of_body",
    "overwritten_properties",
    "unassigned_attributes",
]
