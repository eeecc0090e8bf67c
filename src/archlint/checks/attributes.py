"""What API002 says of attributes: properties that are assigned and cannot be, and names that a class does not have."""

from __future__ import annotations

from collections.abc import Iterator, Set
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.checks.registry import finding
from archlint.checks.uncalled import unless_uncalled
from archlint.finding import Finding, Related, Severity
from archlint.launch_files.launch_properties import ActionOverwritten, overwritten_actions
from archlint.place import Place
from archlint.python_code.absent_asked import AbsentAsked, absent_asked
from archlint.python_code.absent_members import AbsentMember, absent_members
from archlint.python_code.enum_members import absent_enum_members
from archlint.python_code.hidden_methods import HiddenMethod, hidden_methods
from archlint.python_code.indexed_methods import IndexedMethod, indexed_methods
from archlint.python_code.kept_in_variables import kept_in_variable
from archlint.python_code.logger_calls import AbsentOfLogger, absent_of_loggers
from archlint.python_code.methods_looked_into import LookedInto, methods_looked_into
from archlint.python_code.object_members import CalledProperty, object_members
from archlint.python_code.overwritten_methods import OverwrittenMethod, overwritten_methods
from archlint.python_code.own_objects import absent_of_objects
from archlint.python_code.parsed_arguments import absent_arguments
from archlint.python_code.policy_members import absent_policies
from archlint.python_code.unassigned_attributes import (
    Overwritten,
    Unassigned,
    overwritten_properties,
    unassigned_attributes,
)
from archlint.suggestions import listed, meant, nearest

if TYPE_CHECKING:
    from archlint.systems.model import System, WorkspaceIndex

OF_CLASS = "attribute"
"""The group of findings that are about one attribute of a class."""
LOGS = "logs"
"""The group of findings about a node that is taken for its logger."""
LEVELS = frozenset({"debug", "info", "warn", "warning", "error", "fatal"})
LOG_WITH = "write self.get_logger().{}(…)"
OF_OBJECT = "object"
"""The group of findings about what objects of a class do not have."""
UNASSIGNED = "unassigned"
"""The group of findings about attributes of one class that nothing assigns, and that are no slips."""


def attribute_findings(system: System, refused: Set[tuple[str, str]] = frozenset()) -> Iterator[Finding]:
    """The findings about attributes, but for what is said of a callback or of a call that rclpy refuses.  ``refused``
    are the files of such calls with the names."""
    if system.workspace is None:
        return
    yield from map(_overwritten, overwritten_properties(system.workspace))
    for asked in absent_asked(system.workspace):
        yield from unless_uncalled(system, _asked_for(asked))
    yield from map(_method_overwritten, overwritten_methods(system.workspace))
    hidden: dict[Place, Finding] = {}
    for method in hidden_methods(system.workspace):
        if any(unless_uncalled(system, replace(told := _method_hidden(method), place=method.called))):
            hidden.setdefault(method.place, told)
    yield from hidden.values()
    yield from map(_action_overwritten, overwritten_actions(system.workspace))
    of_objects = {absent.place: absent for absent in absent_of_objects(system)}
    of_objects.update((absent.place, absent) for absent in absent_members(system.workspace))
    unassigned = list(_unassigned_findings(system, refused))
    lacking = {(f"class {told.identity[0]}", told.identity[1]) for told in unassigned}
    asked_of: dict[tuple[str, str], list[Place]] = {}
    for absent in (*of_objects.values(), *absent_enum_members(system.workspace)):
        for diagnostic in unless_uncalled(system, _absent(absent)):
            if (absent.owner, absent.name) in lacking:  # who defines it there mends this line, too
                asked_of.setdefault((absent.owner, absent.name), []).append(absent.place)
            else:
                yield diagnostic
    for told in unassigned:
        places = asked_of.pop((f"class {told.identity[0]}", told.identity[1]), [])
        also = [Related(place, "this line asks an object of the class for it") for place in sorted(places)]
        yield replace(told, related=(*told.related, *also))
    for path in system.workspace.python_files(mentioning="ArgumentParser"):
        for name, names, span in absent_arguments(system.workspace, path) or ():
            near = nearest(name, names) or ""
            yield _absent(AbsentMember(Place(path, *span), "what parse_args() returns", name, near, called=False))
    for absent in absent_policies(system.workspace):
        yield from unless_uncalled(system, _absent(absent))
    for of_logger in absent_of_loggers(system.workspace):
        near = "" if of_logger.option else of_logger.near
        absent = AbsentMember(of_logger.place, "a logger", of_logger.name, near, called=True)
        yield from unless_uncalled(system, replace(_absent(absent), help=_cure_of_logger(of_logger)))
    for row in object_members(system):
        diagnostic = called_property(row) if isinstance(row, CalledProperty) else _absent(row)
        yield from unless_uncalled(system, diagnostic)
    for looked in methods_looked_into(system.workspace):
        yield from unless_uncalled(system, _looked_into(looked))
    for indexed in indexed_methods(system.workspace):
        yield from unless_uncalled(system, _indexed(indexed))


def _unassigned_findings(system: System, refused: Set[tuple[str, str]]) -> Iterator[Finding]:
    """The findings about attributes of ``self`` that nothing assigns."""
    assert system.workspace is not None
    told = {(callback.place.file, callback.missing) for callback in system.callbacks if callback.missing} | refused
    for read in unassigned_attributes(system.workspace):
        if (read.place.file, read.name) not in told:
            diagnostic = _unassigned(system.workspace, read)
            yield from [diagnostic] if read.local else unless_uncalled(system, diagnostic)


def _overwritten(assignment: Overwritten) -> Finding:
    return finding(
        "API002",
        assignment.place,
        f"'{assignment.name}' is a property of Node that cannot be assigned: this line fails with an AttributeError",
        help=f"give the attribute another name, such as self.my_{assignment.name}",
        identity=(assignment.cls, assignment.name),
        group=(OF_CLASS, assignment.place.file, assignment.cls, assignment.name),
        fails=True,
    )


def _asked_for(row: AbsentAsked) -> Finding:
    diagnostic = finding(
        "API002",
        row.place,
        f"nothing assigns '{row.name}' of class {row.cls}: hasattr() is always False"
        + meant(row.near and f"'{row.near}'"),
        help=f"write '{row.near}'" if row.near else f"assign self.{row.name} somewhere, or remove what asks for it",
        identity=(row.cls, row.name, "asked"),
        group=(OF_CLASS, row.place.file, row.cls, row.name),
        meant=row.near,
    )
    return replace(diagnostic, severity=Severity.WARNING)


def _method_overwritten(row: OverwrittenMethod) -> Finding:
    return finding(
        "API002",
        row.place,
        f"from here on self.{row.name} is no method of the node: calling it fails with a TypeError",
        help=f"give the attribute another name than {row.name}",
        related=[] if row.called == row.place else [Related(row.called, f"{row.name}() is called here")],
        identity=(row.cls, row.name, "method"),
        group=(OF_CLASS, row.place.file, row.cls, row.name),
    )


def _method_hidden(row: HiddenMethod) -> Finding:
    return finding(
        "API002",
        row.place,
        f"from here on self.{row.name} is no method of {row.cls}: calling it fails with a TypeError",
        help=f"give the attribute another name than {row.name}",
        related=[Related(row.called, f"{row.name}() is called here")],
        identity=(row.cls, row.name, "method"),
        group=(OF_CLASS, row.place.file, row.cls, row.name),
    )


def _action_overwritten(assignment: ActionOverwritten) -> Finding:
    return finding(
        "API002",
        assignment.place,
        f"'{assignment.name}' is a property of {assignment.action} that cannot be assigned: this line fails with an "
        "AttributeError",
        help=f"give it to the constructor: {assignment.action}(…, {assignment.name}=…)",
        identity=(assignment.action, assignment.name),
        fails=True,
    )


def _absent(row: AbsentMember) -> Finding:
    near = f"'{row.near}'" if row.near and not row.of_message else ""
    return finding(
        "API002",
        row.place,
        f"{row.owner} has no '{row.name}': this line fails with an AttributeError{meant(near)}",
        help=_cure(row),
        identity=(row.owner, row.name),
        group=(OF_OBJECT, row.place.file, row.owner, row.name),
        meant=row.near,
        fails=True,
    )


_SECONDS = "seconds"
"""What ``datetime`` calls the whole seconds, and ROS 2 nothing."""
_GOAL_HANDLE = "ServerGoalHandle"
_FEW = 4
"""So many methods of a class are named where another one is called."""


def _cure(row: AbsentMember) -> str:
    if row.of_message and row.near:
        return f"write {row.near}: {row.owner.rpartition('/')[2]} is the class, and {row.near} what is sent"
    if row.of_message:
        return f"write the variable that holds the message: {row.owner.rpartition('/')[2]} is its class"
    if row.near:
        whole = (
            "; the whole seconds alone are to_msg().sec" if row.name == _SECONDS and not row.near.isidentifier() else ""
        )
        return f"write {row.near}{whole}"
    if row.of_objects:
        return f"methods assign self.{row.name}: write the variable that holds an object of the class"
    if row.owner == _GOAL_HANDLE:
        return f"write request.{row.name} if it is a field of the goal, else correct the name"
    if not row.called:
        return "correct the name"
    cure = f"define {row.name}() in {row.owner}"
    methods = listed([f"{method}()" for method in row.methods])
    return f"{cure}, or call what it has: {methods}" if 0 < len(row.methods) <= _FEW else cure


def _cure_of_logger(row: AbsentOfLogger) -> str:
    if row.option:
        return f"write {row.near}(…, {row.option})"
    return f"write {row.near}" if row.near else "call one of its levels: debug(), info(), warning(), error(), fatal()"


def called_property(row: CalledProperty) -> Finding:
    """The finding about a value that is called like a method."""
    return finding(
        "API002",
        row.place,
        f"'{row.name}' of a {row.owner} is a value, no method: calling it fails with a TypeError",
        help=row.cure or f"write {row.name} without parentheses",
        identity=(row.owner, row.name),
        group=(OF_OBJECT, row.place.file, row.owner, row.name),
        fails=True,
    )


def _looked_into(row: LookedInto) -> Finding:
    call = f"{row.method}(…)" if row.needs else f"{row.method}()"
    return finding(
        "API002",
        row.place,
        f"'{row.method}' is a method of a {'clock' if row.of_clock else 'node'} that is not called, and has no "
        f"'{row.name}': this line fails with an AttributeError",
        help=f"write {row.owner or '…'}.{call}.{row.name}",
        identity=(row.method, row.name),
        group=(OF_OBJECT, row.place.file, row.method),
        fails=True,
    )


def _indexed(row: IndexedMethod) -> Finding:
    return finding(
        "API002",
        row.place,
        f"'{row.method}' is a method that is not called, and has no items: this line fails with a TypeError",
        help=f"write self.{row.method}(…)",
        related=[] if row.defined is None else [Related(row.defined, f"{row.method}() is defined here")],
        identity=(row.method, "item"),
        group=(OF_OBJECT, row.place.file, row.method, "item"),
        fails=True,
    )


def _unassigned(workspace: WorkspaceIndex, read: Unassigned) -> Finding:
    name = _as_written(read.name, read.cls)
    near = None if read.near is None else _as_written(read.near, read.cls)
    message = f"nothing assigns '{name}' of class {read.cls}: this line fails with an AttributeError"
    help = f"assign self.{name} in __init__(), or define it"
    related = [] if read.near_at is None else [Related(read.near_at, f"'{near}' is defined here")]
    kept = kept_in_variable(workspace, read.place, read.cls, name)
    logs = read.name in LEVELS and not read.local and not read.is_slip and not read.of_node
    if logs:
        help = LOG_WITH.format(name)
    if read.local:
        message += meant(f"the variable '{name}'")
        help = f"write {name}"
    elif near is not None and read.is_slip:
        message += meant(f"'{near}'")
        help = f"write self.{near}"
    elif read.is_node:
        help = f"write self instead of self.{name}: the object is the node itself"
    elif read.of_node:
        message = f"class {read.cls} has no '{name}', which only a node has: this line fails with an AttributeError"
        help = f"derive the class from Node, or call {name}() of a node"
    elif kept is not None and not logs:
        help = f"write self.{name} instead of {name} in {kept.method}(), where it is a variable of that method"
        related.append(Related(kept.place, f"{kept.method}() assigns the variable here"))
    return finding(
        "API002",
        read.place,
        message,
        help=help,
        related=related,
        identity=(read.cls, name),
        group=_group(read, logs),
        meant=near if near is not None and read.is_slip and not read.local else "",
        fails=True,
    )


def _group(read: Unassigned, logs: bool) -> tuple[str, ...]:
    if logs:
        return (LOGS, read.place.file)
    return () if read.local or read.is_slip else (UNASSIGNED, read.place.file, read.cls)


def _as_written(name: str, cls: str) -> str:
    """A private name without the class that Python puts before it."""
    return name.removeprefix(f"_{cls.lstrip('_')}") if "__" in name else name


__all__ = [
    "LEVELS",
    "LOGS",
    "LOG_WITH",
    "OF_CLASS",
    "UNASSIGNED",
    "attribute_findings",
    "called_property",
]
