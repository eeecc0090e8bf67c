"""The members that C++ code asks messages for, held against the interfaces.

Source: rosidl makes a struct of each message, with its fields and constants as members and no methods but
``set__field()``; a field that is a message is such a struct, and an array a container of them.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Literal

from archlint.place import Place
from archlint.python_code.refused_by_rclcpp import is_judged
from archlint.records import dataclass
from archlint.ros.interfaces import InterfaceTable, MessageClass
from archlint.syntax.cpp_uses import CALLED, ITEM

if TYPE_CHECKING:
    from archlint.syntax.cpp_uses import Holder, MemberUse, TypedField
    from archlint.systems.model import WorkspaceIndex

WrongMember = Literal["field", "method", "arrow", "dot", "number", "format", "value"]

_CLASSES: dict[str, MessageClass] = {
    "": "",
    "Request": "Request",
    "Response": "Response",
    "Goal": "Goal",
    "Result": "Result",
    "Feedback": "Feedback",
}
_SETS = "set__"
_TEXTS = frozenset({"string"})
_NO_CLASSES = frozenset({"string", "wstring"})


@dataclass(frozen=True)
class RefusedMember:
    """A member that a message of a type does not have, or not in this way; ``name`` is what is asked for."""

    kind: WrongMember
    place: Place
    name: str
    type: str
    """The message, ``nav_msgs/msg/Odometry``; of a number its own."""
    section: MessageClass = ""


def refused_members(workspace: WorkspaceIndex) -> Iterator[RefusedMember]:
    """Each of them once, by its place."""
    table = workspace.interfaces
    if table is None:
        return
    fields: dict[tuple[str, str], list[TypedField]] | None = None
    for path in built_code(workspace):
        code = workspace.code.cpp_facts_at(path)
        told = set[Place]()
        for use in () if code is None else code.member_uses:
            if use.owner and fields is None:
                fields = _fields_of_classes(workspace)
            start = _start(use, fields or {})
            row = None if start is None else _judged(table, path, use, *start)
            if row is not None and row.place not in told:
                told.add(row.place)
                yield row


def built_code(workspace: WorkspaceIndex) -> Sequence[str]:
    """The C++ sources that are built in any case, and the headers beside them, as far as they are for one
    distribution."""
    built = {source for installs in workspace.installs.values() for source in installs.sources}
    building = {workspace.package_of(source) for source in built}
    paths = workspace.code.cpp_files()
    seen = [p for p in paths if p in built or (_is_header(p) and workspace.package_of(p) in building)]
    return [path for path in seen if is_judged(workspace, path)]


def _is_header(path: str) -> bool:
    return path.endswith((".hpp", ".h", ".hxx", ".hh"))


def _fields_of_classes(workspace: WorkspaceIndex) -> dict[tuple[str, str], list[TypedField]]:
    """The fields of the classes of all files that are messages, by the names of the class and the field."""
    rows: dict[tuple[str, str], list[TypedField]] = {}
    for path in workspace.code.cpp_files():
        code = workspace.code.cpp_facts_at(path)
        for row in () if code is None else code.typed_fields:
            rows.setdefault((row.owner, row.name), []).append(row)
    return rows


def _start(use: MemberUse, fields: dict[tuple[str, str], list[TypedField]]) -> tuple[Sequence[str], Holder] | None:
    """The type of what is asked first."""
    if not use.owner:
        return use.type, use.holder
    rows = fields.get((use.owner, use.field), [])
    return (rows[0].type, rows[0].holder) if len(rows) == 1 else None


def _judged(
    table: InterfaceTable, path: str, use: MemberUse, type_: Sequence[str], holder: Holder
) -> RefusedMember | None:
    """The first member that is wrong."""
    name, section = "/".join(type_[:3]), _CLASSES.get(type_[3] if len(type_) > 3 else "")
    if section is None or holder == "future":
        return None
    state: Literal["message", "pointer", "list"] = (
        "message" if not holder else "list" if holder == "list" else "pointer"
    )
    for at, (written, span) in enumerate(use.members):
        place = Place(path, *span)
        if written == ITEM:
            if state != "list":
                return None
            state = "message"
            continue
        arrow, own = written.startswith("->"), written.removeprefix("->").removeprefix(".")
        is_called, own = own.endswith(CALLED), own.removesuffix(CALLED)
        if state == "list":
            return None
        has = table.has(name, section, own)
        if is_called:
            of_pointer = state == "pointer" and not arrow
            if has is not False or of_pointer or own.startswith(_SETS):
                return None
            return RefusedMember("method", place, own, name, section)
        if (state == "pointer") != arrow:
            return RefusedMember("dot" if arrow else "arrow", place, own, name, section) if has else None
        if has is False:
            return RefusedMember("field", place, own, name, section)
        kind = table.field_type(name, section, own) if has else None
        if kind is None:
            return None
        last = at + 1 == len(use.members)
        if kind.is_primitive:
            if use.role and last and not kind.array and kind.name in _TEXTS:
                return RefusedMember(use.role, place, own, name, section)
            if last or kind.array or kind.name in _NO_CLASSES:
                return None
            after, after_span = use.members[at + 1]
            if after == ITEM:
                return None
            member = after.removeprefix("->").removeprefix(".").removesuffix(CALLED)
            return RefusedMember("number", Place(path, *after_span), member, kind.name)
        name, section = kind.name, ""
        state = "list" if kind.array else "message"
    return None


__all__ = ["RefusedMember", "built_code", "refused_members"]
