"""Members that an enum of the workspace, or another class, does not have: ``State.IDEL``, ``self.State.IDEL``.

What an enum has stands in its body alone: no code adds a member later.  One with bases beside those of ``enum`` is left
out, and so is one whose body asks for its own names.  Another class has what its bodies bind, and what any code assigns
to something else than ``self``.
"""

from __future__ import annotations

import enum
from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.place import Place
from archlint.python_code.absent_members import AbsentMember
from archlint.python_code.class_chains import (
    ClassInFile,
    chain_of,
    classes_of,
    derived_from,
    kept_for_each_class,
    targets_of,
)
from archlint.python_code.early_attribute_reads import gives
from archlint.python_code.own_calls import class_meant_by
from archlint.python_code.tried_code import tried_for
from archlint.python_code.unassigned_attributes import may_get, members_of, names_of_body
from archlint.records import dataclass
from archlint.suggestions import nearest
from archlint.syntax import facts
from archlint.syntax.parts import Itself, everything_in, once_for

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_ENUMS = frozenset({"enum.Enum", "enum.Flag", "enum.IntEnum", "enum.IntFlag", "enum.StrEnum"})
_PLAIN = frozenset({"object", "abc.ABC"})
_OF_ALL = frozenset(dir(enum.IntFlag)).union(dir(enum.EnumMeta), dir(enum.Enum), dir(str))
_MAKES_NAMES = frozenset({"exec", "locals", "setattr", "vars"})


@dataclass(frozen=True)
class _Read:
    """``owner.name``, or ``self.owner.name``, as code has it."""

    span: facts.Span
    owner: str
    name: str


def absent_enum_members(workspace: WorkspaceIndex) -> Iterator[AbsentMember]:
    """Every such use in the files that were asked for, but for test code; the first one of each member in a file."""
    for path in workspace.python_files():
        for read in _by_name(workspace, path) or ():
            cls = class_meant_by(workspace, path, read.owner)
            if cls is not None:
                yield from _judged(workspace, path, read, cls)
        file_facts = workspace.facts_at(path)
        for code in classes_of(file_facts) if file_facts is not None else ():
            for nested, read in _of_self(workspace, ClassInFile(path, code)):
                if not _has_another(workspace, ClassInFile(path, code), read.owner):
                    yield from _judged(workspace, path, read, ClassInFile(path, nested))


def _judged(workspace: WorkspaceIndex, path: str, read: _Read, cls: ClassInFile) -> Iterator[AbsentMember]:
    file_facts = workspace.facts_at(path)
    if file_facts is None or read.name in _texts_in(file_facts):
        return
    has, kind = _members(workspace, cls), "enum"
    if has is None:
        has, kind = _of_plain_class(workspace, cls, read.name), "class"
    elif read.name in _assigned_in(file_facts):
        return
    if has is None or read.name in has:
        return
    of_objects = kind == "class" and any(read.name in gives(each.code) for each in chain_of(workspace, cls).own)
    near = "" if of_objects else nearest(read.name, sorted(has)) or ""
    owner = f"{kind} {cls.code.name}"
    yield AbsentMember(Place(path, *read.span), owner, read.name, near, False, of_objects=of_objects)


def _of_plain_class(workspace: WorkspaceIndex, cls: ClassInFile, name: str) -> frozenset[str] | None:
    """What a class itself has, which its objects have besides what their methods assign; None where it may have more,
    or some code may give it the name."""
    chain = chain_of(workspace, cls)
    foreign = members_of(workspace, replace(chain, own=[]))
    if any(not (path in _PLAIN or path.startswith("rclpy.")) for path in chain.foreign) or foreign is None:
        return None
    if members_of(workspace, chain) is None or may_get(workspace, cls, name):
        return None
    if any(each.code.decorators or _has_metaclass(each.code) for each in chain.own):
        return None
    return frozenset(dir(type)).union(*foreign, *(names_of_body(each.code) for each in chain.own))


def _has_metaclass(code: facts.Class) -> bool:
    return any(base.keyword or base.star for base in code.bases)


def _members(workspace: WorkspaceIndex, cls: ClassInFile) -> frozenset[str] | None:
    """What the body of an enum gives it; None where it is no enum, or may have more."""
    chain = chain_of(workspace, cls)
    if not chain.complete or not chain.foreign or not _ENUMS.issuperset(chain.foreign):
        return None
    bodies = [_of_body(each.code) for each in chain.own]
    return None if any(names is None for names in bodies) else frozenset[str]().union(*filter(None, bodies))


@once_for
def _of_body(code: facts.Class) -> frozenset[str] | None:
    if any(part.last_name in _MAKES_NAMES for part in everything_in(code.body, facts.Name)):
        return None
    return frozenset(names_of_body(code))


@kept_for_each_file
def _by_name(code: facts.Facts) -> list[_Read]:
    """The attributes that a file reads of a name that begins as those of classes do."""
    forgiven = tried_for(code.body, ("AttributeError",))
    rows: dict[tuple[str, str], _Read] = {}
    for part in everything_in(code.body, facts.Attribute):
        owner = part.value.variable
        if owner and owner[:1].isupper() and _is_asked(part) and Itself[facts.Base](part) not in forgiven:
            rows.setdefault((owner, part.attr), _Read(part.span, owner, part.attr))
    return list(rows.values())


@kept_for_each_class
def _of_self(code: facts.Class) -> list[tuple[facts.Class, _Read]]:
    """The attributes that the methods of a class read of a class inside of it, by ``self``."""
    nested = {each.name: each for each in code.body if isinstance(each, facts.Class)}
    forgiven = tried_for(code.body, ("AttributeError",)) if nested else set()
    assigned = {target.attribute for target in targets_of(code.body)}
    rows: dict[tuple[str, str], tuple[facts.Class, _Read]] = {}
    for part in everything_in(code.body, facts.Attribute) if nested else ():
        match part.value:
            case facts.Attribute(value=facts.Name(id="self"), attr=owner) if owner in nested and owner not in assigned:
                if _is_asked(part) and Itself[facts.Base](part) not in forgiven:
                    rows.setdefault((owner, part.attr), (nested[owner], _Read(part.span, owner, part.attr)))
    return list(rows.values())


def _is_asked(part: facts.Attribute) -> bool:
    return not part.attr.startswith("_") and part.attr not in _OF_ALL


def _has_another(workspace: WorkspaceIndex, cls: ClassInFile, name: str) -> bool:
    """Whether a class derived from one has its own enum of that name."""
    return any(name in names_of_body(derived.code) for derived in derived_from(workspace, cls))


@once_for
def _texts_in(file_facts: facts.Facts) -> frozenset[str]:
    """The texts of a file, which ``hasattr()`` may ask for."""
    texts = (part.value for part in everything_in(file_facts.body, facts.Literal) if isinstance(part.value, str))
    return frozenset(texts)


@once_for
def _assigned_in(file_facts: facts.Facts) -> frozenset[str]:
    """The attributes that a file assigns."""
    return frozenset(target.attr for target in targets_of(file_facts.body) if isinstance(target, facts.Attribute))


__all__ = ["absent_enum_members"]
