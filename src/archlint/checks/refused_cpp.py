"""API007: C++ code that does not compile, since rclcpp or an interface has no such thing."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.pinned import is_for_older_ros, is_from_before_galactic, is_on_focal
from archlint.checks.folding import folds, with_others
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding
from archlint.place import Place
from archlint.python_code.cpp_members import RefusedMember, built_code, refused_members
from archlint.suggestions import listed, nearest

if TYPE_CHECKING:
    from archlint.syntax.cpp_uses import RefusedUse
    from archlint.systems.model import System, WorkspaceIndex

_OLD = frozenset({"format", "no qos", "callback for qos"})
"""What Foxy, or a distribution before it, took."""
_SHOWN = 12
"""How many names a help line lists."""


@rule("API007", scope=Scope.CODE)
def refused_cpp(system: System, options: Options) -> Iterator[Finding]:
    """What a compiler stops at: members of messages, and what rclcpp is given."""
    workspace = system.workspace
    if workspace is None:
        return
    is_old = is_on_focal(workspace) or is_from_before_galactic(workspace)
    for member in refused_members(workspace):
        if not (is_old and member.kind in _OLD) and _is_known(workspace, member):
            yield _of_member(workspace, member)
    for path in built_code(workspace):
        code = workspace.code.cpp_facts_at(path)
        for use in () if code is None else code.refused_uses:
            if not (is_old and use.kind in _OLD):
                yield _of_use(path, use)


def _is_known(workspace: WorkspaceIndex, member: RefusedMember) -> bool:
    """Whether the fields are those of the distribution: in a workspace for Foxy, say, only those of its own are."""
    own = member.type.partition("/")[0] in workspace.packages
    return own or member.kind != "field" or not is_for_older_ros(workspace)


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
    return _finding(row.place, message, help, f"{row.kind} {row.type}", meant)


def _fields(workspace: WorkspaceIndex, row: RefusedMember) -> list[str]:
    section = None if workspace.interfaces is None else workspace.interfaces.section(row.type, row.section)
    return [] if section is None else [field.name for field in section.fields]


# ------------------------------------------------------------------------------------------------- what is given


def _of_use(path: str, use: RefusedUse) -> Finding:
    message, help = _words(use)
    return _finding(Place(path, *use.span), message, help, use.kind)


def _words(use: RefusedUse) -> tuple[str, str]:
    name, other = use.name, use.other
    match use.kind:
        case "format":
            return f"{name}() is given a std::string for its format", f'write {name}(…, "%s", text.c_str())'
        case "no logger":
            return f"{name}() lacks its first argument, a logger", f"write {name}(get_logger(), …)"
        case "no clock":
            return (
                f"{name}() lacks the clock behind its logger",
                f"write {name}(get_logger(), *get_clock(), 1000, …), with a number of milliseconds",
            )
        case "clock pointer":
            return f"{name}() is given a pointer to a clock, and takes the clock", f"write *{other}"
        case "no pointer to node":
            return (
                f"{name}() is given '{other}', and takes a shared pointer to a node",
                "make the node with std::make_shared<…>(…), and pass that"
                if other != "this"
                else "write shared_from_this(), outside of the constructor",
            )
        case "unique pointer":
            return f"{name}() is given a std::unique_ptr, and takes a shared pointer", "use std::make_shared<…>(…)"
        case "lifecycle node":
            return (
                f"{name}() takes no shared pointer to a LifecycleNode",
                f"write {name}({other}->get_node_base_interface())",
            )
        case "no qos":
            return f"{name}() lacks an argument: it takes a topic and a QoS", "add a QoS, such as 10"
        case "no callback":
            return f"{name}() is given no callback", "add the function to be called"
        case "callback for qos":
            return f"{name}() is given its callback where the QoS belongs", "write a QoS in front of it, such as 10"
        case "period":
            return f"{name}() is given the number {other} for its period", "give it a duration: 500ms of std::chrono"
        case "parameter":
            return (
                f"get_parameter() gives an rclcpp::Parameter, and '{name}' is of the type {other}",
                f"write get_parameter(…).{_VALUES.get(other, 'as_int')}()",
            )
        case "no method":
            return f"class '{other}' has no method '{name}'", "name a method of the class"
        case "bound arguments":
            takes, gives = other.split()
            return (
                f"std::bind() gives '{name}' {_arguments(gives)} besides the object, and it takes {takes}",
                "write a placeholder for each of its parameters: std::placeholders::_1",
            )
        case "callback arguments":
            wanted = {"create_subscription": "one: the message", "create_service": "two: request and response"}
            return (
                f"{name}() is given a callback with {other} parameters",
                f"it takes {wanted.get(name, 'none')}",
            )
        case "callback type":
            return f"the callback takes {other}, and is called with {name}", f"write {name}, or ask for the other type"
        case "published type":
            return f"a publisher of {name} is given {other}", f"publish {name}"
        case "created type":
            return f"what is made for {other} is kept in a pointer for {name}", "write the same type at both places"
        case "dot":
            return f"'{other}' is asked of the pointer '{name}' with a '.'", f"write {name}->{other}"


_VALUES = {"double": "as_double", "float": "as_double", "bool": "as_bool", "std::string": "as_string"}


def _arguments(count: str) -> str:
    return "one argument" if count == "1" else f"{count if count != '0' else 'no'} arguments"


def _finding(place: Place, message: str, help: str, kind: str, meant: str = "") -> Finding:
    hint = f"; did you mean '{meant}'?" if meant else ""
    return finding(
        "API007",
        place,
        f"{message}: this does not compile{hint}",
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
