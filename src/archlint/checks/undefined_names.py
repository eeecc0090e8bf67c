"""API005: names that nothing defines."""

from __future__ import annotations

import builtins
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.source_code import code_of, source_code
from archlint.checks.folding import folds, with_others
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.checks.uncalled import unless_uncalled
from archlint.checks.unported import is_part_of_port, told_of_rospy
from archlint.finding import Finding, Place, Related, Severity
from archlint.packaging.missing_imports import missing_imports
from archlint.python_code.how_imported import defined_beside, idle_import_with, import_of, interface_meant
from archlint.python_code.names_meant import (
    EVERYDAY,
    exception_meant,
    first_use,
    functions_to_call,
    node_class_meant,
    node_spun,
)
from archlint.python_code.published_types import is_published_as_another
from archlint.python_code.stray_methods import StrayMethod, stray_methods
from archlint.python_code.unbound_locals import UnboundLocal, unbound_locals
from archlint.python_code.undefined_beside import stops_a_launch
from archlint.python_code.undefined_names import Undefined, statements_of_module, undefined_names
from archlint.suggestions import listed, meant, nearest

if TYPE_CHECKING:
    from archlint.systems.model import System, WorkspaceIndex

_SHORT = 4
"""Names of fewer letters resemble too many others."""
_BUILT_IN = frozenset(dir(builtins))


@rule("API005", scope=Scope.CODE)
def undefined_name(system: System, options: Options) -> Iterator[Finding]:
    """Names that code reads and that neither the file nor Python defines."""
    if system.workspace is not None:
        leaders: dict[tuple[str, object], str] = {}
        stray, unported = stray_methods(system.workspace), told_of_rospy(system)
        yield from map(_outside_of_classes, stray)
        misspelt = {
            (row.place.file, row.near.partition(".")[0]) for row in missing_imports(system.workspace) if row.near
        }
        names = list(undefined_names(system.workspace))
        unbound = [(local, _of_unbound(system.workspace, local)) for local in unbound_locals(system.workspace)]
        lacks_global = {
            _function_around(system.workspace, local): told.group
            for local, told in unbound
            if told.group[2:3] == (_GLOBAL,)
        }
        of_ros_1 = {_function_around(system.workspace, read) for read in names if read.name in _OF_ROS_1} - {None}
        for read in names:
            if of_ros_1 and read.name not in _OF_ROS_1 and _function_around(system.workspace, read) in of_ros_1:
                continue  # who ports the function to rclpy writes the rest anew, too
            if (read.place.file, read.name) in misspelt:
                continue  # API006 tells the slip in the import of that name
            if stops_a_launch(system.workspace, read):
                continue  # LCH008 tells all names of that statement
            if any(method.holds(read.place) for method in stray):
                continue  # what such a method lacks, its class and the imports of that have
            if is_part_of_port(system, unported, read.place.file, of_ros_1=read.name in _OF_ROS_1):
                continue  # API002 says to port the file, or nobody does
            told = _finding(system.workspace, read)
            statement = getattr(source_code(system).statement_at(read.place), "span", None)
            imports = told.group == (read.place.file, _IMPORTS)
            if statement is not None and (imports or told.group == (read.place.file, read.name)):
                # A statement fails at the first of its names, which tells the rest, and so does all of a file that
                # Python loads no further.
                stops = statement in statements_of_module(system.workspace, read.place.file)
                statement = None if stops else statement
                leader = _IMPORTS if imports and not stops else read.name
                told = replace(told, group=(read.place.file, leaders.setdefault((read.place.file, statement), leader)))
            function = code_of(system.workspace).function_at(read.place) if _is_added_to(read) else None
            if told.group[-1] == _ADDED and function is not None:  # one statement declares all of a function
                around = _function_around(system.workspace, read)
                leader = leaders.setdefault((read.place.file, (_ADDED, around)), read.name)
                own = (read.place.file, leader, _ADDED, function.name)
                told = replace(told, group=lacks_global.get(around, own))
            yield from unless_uncalled(system, told)
        for local, told in unbound:
            if told.group[-1] == _EARLY:  # a statement fails at the first of its names, which tells the rest
                span = getattr(source_code(system).statement_at(local.place), "span", None)
                leader = leaders.setdefault((local.place.file, (_EARLY, span)), local.name)
                told = replace(told, group=(local.place.file, leader, _EARLY))
            if local.branch is None or any(unless_uncalled(system, replace(told, place=local.branch))):
                yield from unless_uncalled(system, told)


def _function_around(workspace: WorkspaceIndex, read: Undefined | UnboundLocal) -> Place | None:
    """The function in which a name is read, by its place."""
    function = code_of(workspace).function_at(read.place)
    return None if function is None else Place.of(read.place.file, function.span)


def _outside_of_classes(method: StrayMethod) -> Finding:
    return finding(
        "API005",
        method.call,
        f"super() fails here with a RuntimeError: {method.name}() stands outside of every class",
        help=f"move {method.name}() into the class that it was written for, or delete it",
        related=[Related(method.definition, f"{method.name}() begins here")],
        identity=(method.name, "stray"),
        group=(method.call.file, method.name, "stray"),
        fails=True,
    )


def _of_unbound(workspace: WorkspaceIndex, read: UnboundLocal) -> Finding:
    if read.caught is not None:
        return _past_handler(read, read.caught)
    return _too_early(workspace, read) if read.branch is None else _past_branch(read, read.branch)


def _too_early(workspace: WorkspaceIndex, read: UnboundLocal) -> Finding:
    if read.hidden:
        return _hiding(read)
    function = code_of(workspace).function_at(read.place) if read.of_file else None
    if function is not None:
        return replace(
            _without_value(read),
            help=_declare([read.name], function.name),
            identity=(read.name, _EARLY, function.name),
            group=(read.place.file, f"{function.name}:{function.span[0]}", _GLOBAL, function.name),
        )
    return _without_value(read)


def _declare(names: Sequence[str], function: str) -> str:
    return f"write `global {', '.join(names)}` at the beginning of {function}()"


def _without_value(read: UnboundLocal) -> Finding:
    if read.own_assignment:
        return _in_own_assignment(read)
    elsewhere = (read.assigned.line, read.assigned.column) < (read.place.line, read.place.column)
    reason = "gets a value only in another branch of" if elsewhere else "gets a value only later in"
    return finding(
        "API005",
        read.place,
        f"'{read.name}' {reason} this function: this line fails with an UnboundLocalError",
        help=f"give {read.name} a value in this branch, too" if elsewhere else f"give {read.name} a value before",
        related=[Related(read.assigned, "it makes the name a variable of this function, wherever else it has a value")],
        identity=(read.name, _EARLY),
        group=(read.place.file, read.name, _EARLY),
        fails=True,
    )


def _in_own_assignment(read: UnboundLocal) -> Finding:
    """``first = first[0]``, with nothing before it."""
    return finding(
        "API005",
        read.place,
        f"nothing gives '{read.name}' a value before this line, which reads it first: it fails with an "
        "UnboundLocalError",
        help=f"give {read.name} a value before",
        identity=(read.name, _EARLY),
        group=(read.place.file, read.name, _EARLY),
        fails=True,
    )


def _hiding(read: UnboundLocal) -> Finding:
    """A variable with the name of a class of the file, ``Driver = Driver()``: in all of the function it is meant."""
    return finding(
        "API005",
        read.place,
        f"'{read.name}' is a variable in this function and has no value yet: this line fails with an UnboundLocalError",
        help=f"give the variable another name: it hides the {read.hidden} {read.name} of this file",
        related=[Related(read.assigned, "it makes the name a variable of this function, wherever else it has a value")],
        identity=(read.name, _EARLY),
        group=(read.place.file, read.name, _EARLY),
        fails=True,
    )


def _past_handler(read: UnboundLocal, caught: Place) -> Finding:
    """A variable that has no value where what an ``except`` handles has happened."""
    cause = f"where line {read.failing} has failed, since the except on line {caught.line} goes on"
    cure = f"{read.way_out} in that except, or give {read.name} a value there"
    return _without_value_then(read, caught, cause, cure)


def _past_branch(read: UnboundLocal, branch: Place) -> Finding:
    """A variable to which one branch of an ``if`` gives no value."""
    cause = f"where line {branch.line} has run, since that branch goes on"
    return _without_value_then(read, branch, cause, f"give {read.name} a value in that branch, or before the if")


def _without_value_then(read: UnboundLocal, past: Place, cause: str, cure: str) -> Finding:
    """A variable that has no value where something has run that leads past its assignment."""
    told = finding(
        "API005",
        read.place,
        f"'{read.name}' has no value here {cause}: this line fails with an UnboundLocalError then",
        help=cure,
        related=[
            Related(read.assigned, "this is where it would have got one"),
            Related(past, "it goes on to that line"),
        ],
        identity=(read.name, "caught"),
        group=(read.place.file, str(past.line), PAST_HANDLER),
    )
    return replace(told, severity=Severity.WARNING)


_WITHOUT_SELF = "no self"
"""The group of findings in a method whose author forgot ``self``."""
_IMPORTS = "imports"
"""The group of findings about what a file has to import: all that it lacks there is one finding."""
_EARLY = "early"
"""The group of findings about a variable of a function that is read before it has a value."""
_GLOBAL = "global"
"""The group of findings about variables of the file that one function assigns without declaring them ``global``."""
_ADDED = "local"
"""The group of findings about a variable that ``+=`` makes one of the function."""
PAST_HANDLER = "caught"
"""The group of findings about what one ``except``, or one branch, leaves without a value."""


def _finding(workspace: WorkspaceIndex, read: Undefined) -> Finding:
    if read.without_self:
        return _without_self(read)
    return _unbound_local(workspace, read) if read.added else _undefined(workspace, read)


def _without_self(read: Undefined) -> Finding:
    """A method whose author forgot ``self``: whatever it reads of its object is not there."""
    error = "an UnboundLocalError" if read.added else "a NameError"
    cure = "" if read.name == "self" else f", and write self.{read.name}"
    return finding(
        "API005",
        read.place,
        f"nothing defines '{read.name}': this line fails with {error}; {read.without_self}() has no parameter 'self'",
        help=f"write `def {read.without_self}(self):`{cure}",
        identity=(read.name,),
        group=(read.place.file, read.without_self, _WITHOUT_SELF),
        fails=True,
    )


def _is_added_to(read: Undefined) -> bool:
    """Whether the file has a variable of the name: where ``+=`` makes it one of the function, that one is meant."""
    return not read.of_self and read.name in read.known


def _unbound_local(workspace: WorkspaceIndex, read: Undefined) -> Finding:
    """A variable that ``+=`` makes a local one, so that one of the file or of the class is not meant: the function
    fails where it reads it first."""
    function = code_of(workspace).function_at(read.place)
    return finding(
        "API005",
        first_use(workspace, read.place, read.name),
        f"nothing gives '{read.name}' a value in this function: this line fails with an UnboundLocalError"
        + meant(f"'self.{read.name}'" if read.of_self else ""),
        help=_declare([read.name], function.name) if function is not None and _is_added_to(read) else _cure_of(read),
        identity=(read.name, _ADDED),
        group=(read.place.file, read.name, _ADDED),
        fails=True,
    )


def _cure_of(read: Undefined) -> str:
    return f"write self.{read.name}" if read.of_self else f"give {read.name} a value before"


def _undefined(workspace: WorkspaceIndex, read: Undefined) -> Finding:
    near, statement = "", ""
    in_launch_file = read.place.file in workspace.launch_files.all()
    if read.of_self:
        near = f"self.{read.name}"
    elif meant_part := interface_meant(workspace, read.place.file, read.name):
        near = meant_part
    else:
        statement = import_of(
            workspace, read.name, file=read.place.file, in_launch_file=in_launch_file, called=read.called
        )
    if ".msg " in statement and is_published_as_another(workspace, read.place, read.name):
        statement = ""  # whatever the publisher sends, it is no message of that type
    if not near and not statement and len(read.name) >= _SHORT and not in_launch_file:
        statement = defined_beside(workspace, read.place.file, read.name)
    if read.name in EVERYDAY and statement and statement.split()[1].partition(".")[0] in workspace.code.modules:
        statement = ""
    if not near and not statement and len(read.name) >= _SHORT:
        around = code_of(workspace).function_at(read.place)
        ruled_out = _BUILT_IN if around is None else _BUILT_IN | {around.name}  # to call itself would never end
        known = (name for name in read.known if name not in ruled_out and not _is_one_a_class(name, read.name))
        near = nearest(read.name, known) or idle_import_with(workspace, read.place.file, read.name) or ""
    node = node_class_meant(workspace, read.place)
    if node is not None and (not statement or ".msg " in statement):
        near, statement = near or node, ""  # no message is spun, whatever package has one of the name
    if spun := node_spun(workspace, read.place):
        near, statement = spun, ""
    if read.caught or read.name in _OF_ROS_1:
        near, statement = "", ""
    if read.name in _OTHERWISE_CALLED and not read.of_self:
        near, statement = _OTHERWISE_CALLED[read.name], ""
    cure = (
        exception_meant(workspace, read.place.file, read.name)
        if read.caught
        else f"write `{statement}`"
        if statement
        else f"write {near}"
        if near
        else _OF_ROS_1.get(read.name) or _define(workspace, read)
    )
    hint = meant(f"'{near}'" if near else "")
    return finding(
        "API005",
        read.place,
        f"nothing defines '{read.name}': this line fails with a NameError{hint}",
        help=cure,
        identity=(read.name,),
        group=(read.place.file, _IMPORTS if statement else read.name),
        meant=near,
        fails=True,
    )


def _define(workspace: WorkspaceIndex, read: Undefined) -> str:
    """What is advised of a name that nothing known resembles: one of the file's own functions may be meant."""
    own = functions_to_call(workspace, read.place.file) if read.called and read.name in EVERYDAY else []
    instead = f", or call what the file has: {listed([f'{name}()' for name in own])}" if own else ", or remove the line"
    return f"define it{instead}"


_OF_ROS_1 = dict.fromkeys(("roslib", "rospy"), "port the file to rclpy: it is written for ROS 1")
"""What is advised of modules that ROS 2 does not have."""
_OTHERWISE_CALLED = {
    **{"basestring": "str", "long": "int", "raw_input": "input", "unichr": "chr", "unicode": "str", "xrange": "range"},
    **{"double": "float", "false": "False", "null": "None", "nullptr": "None", "true": "True"},
}
"""What Python 2 and C++ call what Python 3 calls otherwise.  Source: docs.python.org/3/whatsnew/3.0.html."""


def _is_one_a_class(known: str, name: str) -> bool:
    """Whether one name is that of a class and the other is not: ``Node`` and ``node``, ``Duration``, ``direction``."""
    return known[:1].isupper() is not name[:1].isupper()


@folds("API005", common=3)
def undefined_in_one_file(findings: Sequence[Finding]) -> Finding:
    """The first read of a name in a file, for all of them, and for the other names of its statement; and of what has no
    value after one ``except``."""
    if PAST_HANDLER in findings[0].group:
        return with_others(findings, "another variable has", "more variables have", "none, either")
    if findings[0].group[2:3] == (_GLOBAL,):
        return _of_globals(findings)
    if findings[0].group[2:3] == (_ADDED,):
        return _of_added(findings)
    if _EARLY in findings[0].group and len({told.identity[0] for told in findings}) > 1:
        return with_others(findings, "another variable has", "more variables have", "none, either")
    if findings[0].group[-1] == _IMPORTS:
        return _of_imports(findings)
    if _WITHOUT_SELF not in findings[0].group and len({told.identity[0] for told in findings}) > 1:
        return with_others(findings, "another name is", "more names are", "not defined, either")
    return with_others(findings, "another line of the file does", "more lines of the file do", "the same")


def _of_globals(findings: Sequence[Finding]) -> Finding:
    """The first of the variables of the file that a function assigns as its own, with one cure for all."""
    names = dict.fromkeys(told.identity[0] for told in findings)
    whole = with_others(findings, "another variable has", "more variables have", "none, either")
    return replace(whole, help=_declare([*names], findings[0].group[3]))


def _of_added(findings: Sequence[Finding]) -> Finding:
    """The first variable of the file that a function adds to as its own, for all others of that function and for the
    same ones of other functions."""
    names = dict.fromkeys(told.identity[0] for told in findings)
    if len(names) == 1:
        return with_others(findings, "another line of the file does", "more lines of the file do", "the same")
    whole = with_others(findings, "another variable has", "more variables have", "none, either")
    return replace(whole, help=_declare([*names], findings[0].group[3])) if len(findings[0].group) > 3 else whole


def _of_imports(findings: Sequence[Finding]) -> Finding:
    """The first of the names that a file does not import, with the import of each other where it is read first."""
    first: dict[str, Finding] = {}
    for told in findings:
        first.setdefault(told.identity[0], told)
    if len(first) == 1:
        return with_others(findings, "another line of the file does", "more lines of the file do", "the same")
    names = list(first.values())
    whole = with_others(names, "another name is", "more names are", "not defined, either")
    rows = (Related(told.place, f"nothing defines '{told.identity[0]}': {told.help}") for told in names[1:])
    return replace(whole, related=(*names[0].related, *rows))


__all__ = ["undefined_in_one_file", "undefined_name"]
