"""API007: C++ code that does not compile, since rclcpp or an interface has no such thing."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.pinned import is_for_older_ros, is_from_before_humble, knows_interfaces_of
from archlint.checks.folding import folds, with_others
from archlint.checks.refused_cpp_words import NO_ERROR, words_for
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding
from archlint.packaging.opened_names import may_be_opened
from archlint.packaging.unmade_headers import UnmadeHeader, unmade_headers
from archlint.place import Place
from archlint.python_code.cpp_members import RefusedMember, refused_members
from archlint.python_code.refused_cpp_uses import refused_uses
from archlint.suggestions import listed, nearest

if TYPE_CHECKING:
    from archlint.systems.model import System, WorkspaceIndex

_OLD = frozenset({"format", "no qos", "callback for qos"})
"""What Foxy, or a distribution before it, took."""
_OF_OTHERS = {"literal": "literals", "placeholder": "placeholders"}
"""What a header may bring, by a word that it has then."""
_SHOWN = 12
"""How many names a help line lists."""


@rule("API007", scope=Scope.CODE)
def refused_cpp(system: System, options: Options) -> Iterator[Finding]:
    """What a compiler stops at: members of messages, and what rclcpp is given."""
    workspace = system.workspace
    if workspace is None:
        return
    is_old = is_from_before_humble(workspace)
    for member in refused_members(workspace):
        if not (is_old and member.kind in _OLD) and _is_known(workspace, member):
            yield _of_member(workspace, member)
    is_older = is_for_older_ros(workspace)
    for row in unmade_headers(workspace):
        if row.is_case or not is_older:
            yield _of_header(row)
    for place, use in refused_uses(workspace):
        if is_old and use.kind in _OLD:
            continue
        word = _OF_OTHERS.get(use.kind)
        if word is None or not may_be_opened(workspace, place.file, word):
            message, help = words_for(use)
            yield _finding(place, message, help, use.kind)


def _is_known(workspace: WorkspaceIndex, member: RefusedMember) -> bool:
    return member.kind != "field" or knows_interfaces_of(workspace, member.type.partition("/")[0])


# --------------------------------------------------------------------------------------------- members of messages


def _of_member(workspace: WorkspaceIndex, row: RefusedMember) -> Finding:
    of = row.type.replace("/", "::") + (f"::{row.section}" if row.section else "")
    meant, help = "", ""
    match row.kind:
        case "field":
            fields = _fields(workspace, row)
            meant = nearest(row.name, fields) or ""
            message = f"{of} has no member '{row.name}'"
            help = f"its fields are {listed(fields, shown=_SHOWN)}" if fields else "it has no fields"
        case "method":
            message, help = f"{of} has no method '{row.name}'", "a message has fields and no methods"
        case "arrow":
            message = f"'{row.name}' is asked of a pointer to a message with a '.'"
            help = f"write ->{row.name}"
        case "dot":
            message = f"'{row.name}' is asked of a message with '->', and it is no pointer"
            help = f"write .{row.name}"
        case "number":
            message, help = f"a {row.type} has no member '{row.name}'", "the field before it is the value"
        case "format":
            message = f"a logging macro is given the text '{row.name}' of a message for its format"
            help = f'write "%s" in front, and {row.name}.c_str()'
        case "value":
            message = f"a logging macro is given the text '{row.name}' of a message as it is"
            help = f"write {row.name}.c_str(): what fills in a %s is no std::string"
    return _finding(row.place, message, help, f"{row.kind} {row.type}", meant)


def _fields(workspace: WorkspaceIndex, row: RefusedMember) -> list[str]:
    section = None if workspace.interfaces is None else workspace.interfaces.section(row.type, row.section)
    return [] if section is None else [field.name for field in section.fields]


def _of_header(row: UnmadeHeader) -> Finding:
    what = "is one of ROS 1" if row.of_ros1 else "is a header that its package does not have"
    message = f"<{row.header}> {what}"
    help = f"write {row.meant}" if row.meant else "include the header of an interface that there is"
    return _finding(row.place, message, help, "header", "" if row.of_ros1 else row.meant)


def _finding(place: Place, message: str, help: str, kind: str, meant: str = "") -> Finding:
    hint = f"; did you mean '{meant}'?" if meant else ""
    outcome = (
        "GCC passes its address, and garbage is logged" if kind.split()[0] in NO_ERROR else "this does not compile"
    )
    return finding(
        "API007",
        place,
        f"{message}: {outcome}{hint}",
        help=help,
        identity=(message,),
        group=(place.file, kind),
        meant=meant,
    )


@folds("API007")
def _of_one_kind(findings: Sequence[Finding]) -> Finding:
    """One finding for all that is wrong in the same way in a file."""
    return with_others(findings, "another line is", "more lines are", "refused, too")


__all__ = ["refused_cpp"]
