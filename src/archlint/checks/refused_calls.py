"""API001 and API002: calls that rclpy refuses, and of what it does not have."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.reach import judged_notes
from archlint.checks.absent_imports import (
    OF_MODULE,
    OF_NODES,
    absent_import_findings,
    absent_in_python_findings,
)
from archlint.checks.argument_words import cure_of_keywords, keywords_meant, quoted, what_does_not_fit
from archlint.checks.attributes import (
    LEVELS,
    LOG_WITH,
    LOGS,
    OF_CLASS,
    UNASSIGNED,
    attribute_findings,
    called_property,
)
from archlint.checks.early_reads import TOO_EARLY, early_read_findings
from archlint.checks.folding import folds, with_others
from archlint.checks.late_attributes import TOO_LATE, late_attribute_findings
from archlint.checks.methods_meant import asks_for_action, cure_of_absent, getter_meant, is_of_node
from archlint.checks.nodes_at_hand import cure_of_spin
from archlint.checks.own_calls import COMPARED, NOT_CALLED, own_call_findings
from archlint.checks.refused_by_rclcpp import OF_RCLCPP, moved_name_findings, refused_by_rclcpp_findings
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.checks.seconds_instead import cure_of_duration
from archlint.checks.time_operators import OPERATOR, time_operator_findings
from archlint.checks.uncalled import unless_uncalled
from archlint.checks.unported import (
    OF_ROS_1,
    functions_of_rospy,
    is_left_in_ros_1,
    is_of_ros_1,
    is_of_rospy,
    of_one_port,
)
from archlint.checks.used_values import NOTHING, PLAIN, TEXT, misused_kind_findings, used_value_findings
from archlint.finding import Finding
from archlint.libraries.api_signatures import signatures_of
from archlint.model import Misuse, RefusedCall
from archlint.python_code.given_to_libraries import may_have
from archlint.python_code.logged_values import logged_values
from archlint.python_code.logger_calls import GET_LOGGER, LOGGER, refused_logger_calls
from archlint.python_code.object_members import CalledProperty
from archlint.ros.distros import DISTROS

if TYPE_CHECKING:
    from archlint.systems.model import System

_AS_NEWEST = "kilted"
"""The distribution whose signatures stand for those of newer ones."""
_OF_OTHER_RULES = frozenset({Misuse.ABSENT, Misuse.BEFORE_INIT, Misuse.EARLY, Misuse.VALUE})
_NEWER = frozenset(DISTROS[DISTROS.index(_AS_NEWEST) + 1 :])


@rule("API001", scope=Scope.CODE, by_program=True)
def refused_call(system: System, options: Options) -> Iterator[Finding]:
    """Calls that rclpy, message_filters or tf2_ros refuse, and operators between times that rclpy does."""
    loggers = [] if system.workspace is None else [*refused_logger_calls(system.workspace), *logged_values(system)]
    judged = list(judged_refusals(system))
    unported = functions_of_rospy(judged)
    for call in (*judged, *loggers):
        slip = call.api == "rclpy.spin" and call.misuse is Misuse.MISSING and call.place.file in unported
        of_rospy = slip or is_of_ros_1(unported, call.place.file)  # API002 says to port it
        if call.misuse not in _OF_OTHER_RULES and not of_rospy and _is_refused(call, options.distros):
            yield from unless_uncalled(system, _finding(system, call))
    yield from time_operator_findings(system)
    yield from own_call_findings(system)
    yield from used_value_findings(system)
    yield from refused_by_rclcpp_findings(system)


@rule("API002", scope=Scope.CODE)
def unknown_attribute(system: System, options: Options) -> Iterator[Finding]:
    """Calls of functions and methods that rclpy does not have, and attributes that a class does not have or take."""
    judged_calls = list(judged_refusals(system))
    absent = [call for call in judged_calls if call.misuse is Misuse.ABSENT]
    yield from (_called_value(call) for call in judged_calls if call.misuse is Misuse.VALUE)
    named = [(call, (call.parameters or ("",))[0]) for call in absent]
    judged = [row for row in named if not may_have(system, row[0].place, row[1], of_library=_is_open(row[0]))]
    told = {(call.place.file, call.place.line, name) for call, name in judged}
    for diagnostic in attribute_findings(system, {(file, name) for file, _, name in told}):
        # A class of the workspace and the node that it is lack the same.
        if (diagnostic.place.file, diagnostic.place.line, diagnostic.identity[-1]) not in told:
            yield diagnostic
    yield from early_read_findings(system)
    yield from late_attribute_findings(system)
    yield from misused_kind_findings(system)
    yield from moved_name_findings(system)
    yield from absent_in_python_findings(system)
    unported = functions_of_rospy(absent)
    left = {file for file in unported if is_of_ros_1(unported, file) and is_left_in_ros_1(system, file)}
    for diagnostic in absent_import_findings(system, {(call.place.file, call.place.line) for call in absent}):
        file = diagnostic.place.file
        of_rospy = is_of_ros_1(unported, file) or (file in unported and diagnostic.identity[0].startswith("rclpy.ROS"))
        if not of_rospy:
            yield diagnostic
        elif file not in left:
            yield replace(diagnostic, group=(OF_ROS_1, file))
    for call, name in judged:
        if call.place.file in left or _is_of_action(call, name, judged_calls):
            continue
        logs = name in LEVELS and is_of_node(call)
        diagnostic = finding(
            "API002",
            call.place,
            f"{call.given.rpartition('.')[2]} has no {name}()",
            help=_in_place_of_absent(system, call, name, logs),
            identity=(call.api,),
            group=(OF_ROS_1, call.place.file) if is_of_ros_1(unported, call.place.file) else _group(call, name, logs),
            meant=call.wanted,
            fails=True,
        )
        yield from [diagnostic] if call.wanted else unless_uncalled(system, diagnostic)


def _is_of_action(call: RefusedCall, name: str, refused: Iterable[RefusedCall]) -> bool:
    """Whether a client for services lacks what one for actions has, and API001 says that its file makes it for an
    action."""
    if not asks_for_action(call, name):
        return False
    return any(_is_made_for_action(other) for other in refused if other.place.file == call.place.file)


def _is_made_for_action(call: RefusedCall) -> bool:
    return call.misuse is Misuse.KIND and call.api.endswith(".create_client") and call.given.startswith(_THE_ACTION)


def _in_place_of_absent(system: System, call: RefusedCall, name: str, logs: bool) -> str:
    if logs:
        return LOG_WITH.format(name)
    return f"use {call.wanted}" if call.wanted else cure_of_absent(system, call, name)


_CREATES = {
    "clients": "create_client(…)",
    "publishers": "create_publisher(…)",
    "services": "create_service(…)",
    "subscriptions": "create_subscription(…)",
    "timers": "create_timer(…)",
}
"""What makes the things that a property of a node goes through."""


def _called_value(call: RefusedCall) -> Finding:
    owner, _, name = call.api.rpartition(".")
    cure = f"write {_CREATES[name]}, or {name} without parentheses" if name in _CREATES and is_of_node(call) else ""
    return called_property(CalledProperty(call.place, owner.rpartition(".")[2], name, cure))


def _group(call: RefusedCall, name: str, logs: bool) -> tuple[str, ...]:
    """What a finding has in common with others of its file: a slip, a class without several methods of its own, or the
    name."""
    if logs:
        return (LOGS, call.place.file)
    if is_of_rospy(call):
        return (OF_ROS_1, call.place.file)
    undefined = is_of_node(call) and not call.wanted and not getter_meant(call, name)
    return (UNDEFINED, call.place.file) if undefined else (call.place.file, call.api)


UNDEFINED = "undefined"
"""The group of findings about methods that the classes of a file call and do not have."""


def _is_open(call: RefusedCall) -> bool:
    return is_of_node(call) and not call.wanted


@folds("API002")
def absent_in_one_file(findings: Sequence[Finding]) -> Finding:
    """The first call of a file for all of the same name, its first line that asks a module for one, or the first
    line of a class that assigns a property."""
    if findings[0].group[0] == OF_RCLCPP:
        return with_others(findings, "another line does", "more lines do", "the same")
    if findings[0].group[0] == OF_CLASS:
        return with_others(findings, "another line of the class does", "more lines of the class do", "the same")
    if findings[0].group[0] == UNASSIGNED:
        return with_others(
            findings, "another attribute of the class is", "more attributes of the class are", "like that"
        )
    if findings[0].group[0] in (TOO_EARLY, TOO_LATE):
        return with_others(
            findings, "another attribute of the class is read", "more attributes of the class are read", "too early"
        )
    if findings[0].group[0] in (LOGS, UNDEFINED):
        return with_others(findings, "another call in this file is", "more calls in this file are", "like that")
    if findings[0].group[0] == OF_ROS_1:
        return of_one_port(findings)
    if findings[0].group[-1] == OF_NODES:
        return with_others(findings, "another line of the file asks", "more lines of the file ask", "for such")
    if findings[0].group[0] == OF_MODULE:
        return with_others(findings, "another line of the file does", "more lines of the file do", "the same")
    return with_others(findings, "another call in this file does", "more calls in this file do", "the same")


def judged_refusals(system: System) -> Iterator[RefusedCall]:
    """The refused calls outside of test code, in the order of the source."""
    noted = judged_notes(system, lambda program: program.refused_calls)
    calls = {(call.place, call.api): call for call in noted}
    return (calls[key] for key in sorted(calls))


def _is_refused(call: RefusedCall, distros: tuple[str, ...]) -> bool:
    """Whether all of the distributions to judge for refuse a call: one that works in some of them may be meant for
    those."""
    refusing = {*call.distros}
    if call.api.endswith("TransformBroadcaster.sendTransform"):
        return True  # none takes what ROS 1 took
    known = [distro for distro in DISTROS if distro in signatures_of(call.api)]
    if _AS_NEWEST in refusing:
        refusing |= _NEWER
    elif call.misuse is Misuse.MISSING and known and known[-1] in refusing:
        # What a library needs in the newest distribution that the table has of it, it needs in later ones.
        refusing.update(DISTROS[DISTROS.index(known[-1]) :])
    return refusing.issuperset(distros)


_FAILS = "fails"
_WHATEVER_IS_GIVEN = frozenset({Misuse.MISSING, Misuse.TOO_MANY, Misuse.TWICE, Misuse.UNKNOWN_KEYWORD})
"""What is wrong with a call as it is written: another way to it may bring other values, but no other arguments."""


def _finding(system: System, call: RefusedCall) -> Finding:
    name = name_of_call(call.api)
    inherited = _is_inherited_constructor(call)
    no_node = call.misuse is Misuse.KIND and call.parameters == ("node",)
    of_node = cure_of_spin(system, name, call)
    outcome = "starts nothing" if _is_called_for_thread(call) else _FAILS
    return finding(
        "API001",
        call.place,
        f"{_subject(name, call)} {outcome}: {_what_is_wrong(call)}",
        help=of_node or cure_of_duration(system, call) or _cure(name, call),
        identity=(call.api, str(call.misuse), *call.parameters),
        # What is no node is none for all calls, and who gives one level of a logger too much does so to the others.
        group=(
            call.place.file,
            call.given if no_node or inherited else LOGGER if call.api.startswith(LOGGER) else call.api,
            str(call.misuse),
            *call.parameters,
            of_node,
        ),
        fails=outcome == _FAILS and call.misuse in _WHATEVER_IS_GIVEN,
    )


@folds("API001")
def of_one_file(findings: Sequence[Finding]) -> Finding:
    """The first call of a file for all that are wrong in the same way."""
    if findings[0].group[0] == OF_RCLCPP:
        return with_others(findings, "another line does", "more lines do", "the same")
    if findings[0].group[1] in (COMPARED, NOT_CALLED, NOTHING, PLAIN, TEXT):
        return with_others(findings, "another line in this file does", "more lines in this file do", "the same")
    if findings[0].group[1] == OPERATOR:
        return with_others(findings, "another operator in this file does", "more operators in this file do", "the same")
    return with_others(findings, "another call in this file fails", "more calls in this file fail", "in the same way")


def _is_called_for_thread(call: RefusedCall) -> bool:
    """Whether a thread is given what a function returns: without a target it ends at once."""
    return call.api.startswith("threading.") and call.parameters != ("args",) and call.given.endswith("None")


def name_of_call(api: str) -> str:
    """How code calls it: ``create_timer``, ``QoSProfile``."""
    owner, _, name = api.rpartition(".")
    return owner.rpartition(".")[2] if name == "__init__" else name


def _subject(name: str, call: RefusedCall) -> str:
    if call.misuse is Misuse.NO_FUNCTION:
        return f"calling {call.given}"
    return f"{call.given}()" if _is_inherited_constructor(call) else f"{name}()"


def _is_inherited_constructor(call: RefusedCall) -> bool:
    """Whether it is a class of the workspace that is called, and has no constructor of its own."""
    return call.misuse is Misuse.MISSING and call.api.endswith(".__init__") and bool(call.given)


def _what_is_wrong(call: RefusedCall) -> str:
    names = quoted(call.parameters)
    match call.misuse:
        case Misuse.MISSING if _is_inherited_constructor(call) and call.wanted:
            return f"{names} is missing, as {call.wanted}() is no constructor"
        case Misuse.TOO_MANY if not call.takes and _by_name(call):
            return "it takes no argument by position"
        case Misuse.MISSING | Misuse.TOO_MANY | Misuse.UNKNOWN_KEYWORD | Misuse.TWICE:
            return what_does_not_fit(call.misuse, call.parameters, call.takes)
        case Misuse.ABSENT | Misuse.VALUE:
            return f"there is no {names}"
        case Misuse.BEFORE_INIT | Misuse.EARLY:
            return "the node is not initialised"
        case Misuse.NO_FUNCTION:
            return "it is no function"
        case Misuse.SWAPPED:
            return f"{names} are swapped"
        case Misuse.KIND:
            return f"{names} takes {call.wanted}, not {call.given}"


_THE_ACTION = "the action "
_OF_ACTIONS = {"create_client": "ActionClient", "create_service": "ActionServer"}
"""What makes for an action what these make for a service."""
_ONCE = frozenset({"once", "one_shot", "oneshot"})
"""What a timer of ROS 1 takes so that it runs once."""


def _cure(name: str, call: RefusedCall) -> str:
    if call.api == GET_LOGGER:
        return "write get_logger().info(…)"
    if call.api.startswith(LOGGER):
        return _cure_of_logger(name, call)
    if call.misuse is Misuse.NO_FUNCTION:
        return f"call its {call.wanted}"
    if call.api.endswith(".Future.result"):
        return "result() never waits: continue in a done callback, where the future has its result"
    if call.api.endswith(".create_timer") and not _ONCE.isdisjoint(call.parameters):
        return f"write {name}({', '.join(call.signature)}), and end the callback with the timer's cancel()"
    if _is_inherited_constructor(call) and call.wanted:
        return f"rename {call.wanted}() to __init__()"
    if _is_inherited_constructor(call):
        return f"give {call.given} an __init__() that calls super().__init__({', '.join(call.signature)})"
    if call.misuse is Misuse.KIND:
        if call.api.startswith("threading.") and call.parameters == ("args",):
            return "put a comma behind it, which makes the tuple: args=(…,)"
        if call.parameters == ("type_",):
            return "give the value by name, value=…: the type comes before it"
        if call.parameters == ("executor",) and call.api.endswith("spin_until_future_complete"):
            return "give the timeout by name, timeout_sec=…: the executor comes before it"
        if call.given.startswith(_THE_ACTION) and name in _OF_ACTIONS:
            return f"use {_OF_ACTIONS[name]} of rclpy.action"
        called = call.given.startswith("what ")
        return "pass the function itself, without parentheses" if called else f"pass {call.wanted}"
    if call.misuse is Misuse.UNKNOWN_KEYWORD:
        known = {*_by_name(call), *(name for row in signatures_of(call.api).values() for name in row.positional)}
        return cure_of_keywords(call.parameters, keywords_meant(call.parameters, sorted(known)))
    if call.misuse is Misuse.TOO_MANY and call.api == "message_filters.Subscriber":
        return f"give the profile by name, {call.parameters[0]}=…: here it takes the place of the callback"
    if call.misuse is Misuse.TOO_MANY and not call.takes and _by_name(call):
        return f"give it by name: {name}({_by_name(call)[0]}=…)"
    return f"write {name}({', '.join(call.signature)})"


def _by_name(call: RefusedCall) -> list[str]:
    """The parameters that go by name alone, in the order of the newest distribution that has them."""
    return [*dict.fromkeys(name for row in [*signatures_of(call.api).values()][::-1] for name in row.by_name)]


def _cure_of_logger(name: str, call: RefusedCall) -> str:
    """A logger of ROS takes one text, and what Python's own makes of its arguments has to be made of them before."""
    if call.misuse is Misuse.TOO_MANY and call.given == "self":
        return f"take self out: {name}(…)"
    if call.misuse is Misuse.TOO_MANY:
        return f"put the values into the text: {name}(f'… {{value}}')"
    if "exc_info" in call.parameters:
        return "put traceback.format_exc() into the text"
    return f"write {name}({', '.join(call.signature)})"
