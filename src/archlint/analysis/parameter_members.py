"""Which member of a ``ParameterValue`` code reads, held against the type of the parameter.

Source: ``rcl_interfaces/msg/ParameterValue`` has a member for each type, of which only the one that ``type`` names is
set; the others keep what a new message has.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Final

from archlint.analysis.cpp_parameter_reads import wrong_accessors
from archlint.analysis.declared_parameters import declared_by
from archlint.analysis.kept import once_for_each_file
from archlint.model.given import Constant
from archlint.place import Place
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.workspace.kinds import is_cpp

if TYPE_CHECKING:
    from archlint.model import ParameterDeclaration
    from archlint.ros.parameter_types import ParameterType
    from archlint.systems.model import System
    from archlint.systems.nodes import Node

EMPTY: Final = {
    "bool_value": "False",
    "integer_value": "0",
    "double_value": "0.0",
    "string_value": "''",
    "byte_array_value": "empty",
    "bool_array_value": "empty",
    "integer_array_value": "empty",
    "double_array_value": "empty",
    "string_array_value": "empty",
}
"""The members by name, with what they are where the parameter has another type."""
_READ = "rclpy.node.Node.get_parameter"


@dataclass(frozen=True)
class WrongMember:
    """``get_parameter('count').get_parameter_value().double_value`` of a parameter that is an integer."""

    place: Place
    node: Node
    name: str
    member: str
    type: ParameterType
    declared_at: Place
    default: object = None
    """The value that the code declares it with; None where that is not known."""
    right: str = ""
    """In C++, where the wrong method throws: the one for the type."""


def wrong_members(system: System) -> Iterator[WrongMember]:
    """Each such read whose parameter has one type for certain."""
    for node in system.nodes:
        declared = declared_by(node)
        if declared is None or node.program is None:
            continue
        reads = [call for call in node.program.calls if call.node is node.blueprint and call.api == _READ]
        read_at = [(call.place, call.arguments.get("name")) for call in reads]
        at = [(place, name.value) for place, name in read_at if isinstance(name, Constant) and not name.parameters]
        at += [(row.place, name) for name, rows in declared.items() for row in rows]
        for place, name in at:
            rows = declared.get(name, []) if isinstance(name, str) else []
            types = {None if row.dynamic else row.type for row in rows}
            if len(types) == 1 and (kind := types.pop()) is not None:
                if is_cpp(place.file):
                    for wrong in wrong_accessors(system, place, kind):
                        declared_at = rows[0].place
                        yield WrongMember(
                            wrong.place, node, str(name), wrong.called, kind, declared_at, right=wrong.right
                        )
                    continue
                for read in _member_reads(system, place):
                    if read.attr in EMPTY and read.attr != f"{kind}_value" and not _is_as_empty(rows, read.attr):
                        whole = Place(place.file, *read.span)
                        yield WrongMember(whole, node, str(name), read.attr, kind, rows[0].place, rows[0].default)


def _is_as_empty(rows: Sequence[ParameterDeclaration], member: str) -> bool:
    """Whether a list is read of a parameter that is declared with an empty one, which rclpy takes for a byte array: it
    is empty, as the default is, and what sets a list of another type is refused (PRM002)."""
    of_nothing = all(row.type == "byte_array" and not row.without_default for row in rows)
    return of_nothing and member.endswith("_array_value")


def _member_reads(system: System, place: Place) -> list[facts.Attribute]:
    """The members that are read of a call's parameter in the same expression."""
    members = None if system.workspace is None else _members_by_call(system.workspace, place.file)
    return [] if members is None else members.get((place.line, place.column), [])


@once_for_each_file
def _members_by_call(file_facts: facts.Facts) -> dict[tuple[int, int], list[facts.Attribute]]:
    """What is read of ``….get_parameter_value()``, by where the call that gives the parameter begins."""
    members: dict[tuple[int, int], list[facts.Attribute]] = {}
    for part in everything_in(file_facts.body, facts.Attribute):
        match part.value:
            case facts.Call(func=facts.Attribute(attr="get_parameter_value", value=facts.Call(span=span))):
                members.setdefault(span[:2], []).append(part)
    return members


__all__ = ["EMPTY", "WrongMember", "wrong_members"]
