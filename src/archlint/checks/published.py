"""TOP005: what is published, called with or sent as a goal is of another type than the endpoint's."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Final

from archlint.analysis.kept import once
from archlint.analysis.reach import creations_of, is_given_a_literal
from archlint.analysis.source_code import SourceCode, source_code
from archlint.checks.folding import folds, with_others
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.checks.uncalled import unless_uncalled
from archlint.finding import Finding, Place, Related
from archlint.libraries.rclpy.names import canonical, interface_and_section
from archlint.model.given import (
    Collection,
    Constant,
    Duration,
    ForeignClass,
    Future,
    Given,
    GoalHandle,
    Message,
    Node,
    Object,
    PlainValue,
)
from archlint.python_code.next_uses import is_next_use

if TYPE_CHECKING:
    from archlint.model import ApiCall, Creation, WrongValue
    from archlint.ros.interfaces import MessageClass
    from archlint.systems.model import System

_SENDS: Final[dict[str, tuple[str, MessageClass]]] = {
    "rclpy.publisher.Publisher.publish": ("msg", ""),
    "rclpy.client.Client.call": ("request", "Request"),
    "rclpy.client.Client.call_async": ("request", "Request"),
    "rclpy.action.client.ActionClient.send_goal": ("goal", "Goal"),
    "rclpy.action.client.ActionClient.send_goal_async": ("goal", "Goal"),
    "rclpy.action.server.ServerGoalHandle.publish_feedback": ("feedback", "Feedback"),
    "rclpy.action.server.ServerGoalHandle.succeed": ("response", "Result"),
    "rclpy.action.server.ServerGoalHandle.abort": ("response", "Result"),
    "rclpy.action.server.ServerGoalHandle.canceled": ("response", "Result"),
}
"""By API: the argument that is sent, and which section of the endpoint's interface it must be."""


@rule("TOP005", scope=Scope.CODE, by_program=True)
def published_type_mismatch(system: System, options: Options) -> Iterator[Finding]:
    """Arguments of ``publish`` and its kin that are certainly not of the endpoint's type."""
    for _, diagnostic in _wrong_calls(system):
        yield from unless_uncalled(system, diagnostic)


@once
def _wrong_calls(system: System) -> list[tuple[ApiCall, Finding]]:
    """The calls that send something of another type, with what is said of each."""
    code = source_code(system)
    unknown = (interface for run in system.programs for interface in run.unknown_interfaces)
    nowhere = frozenset(f"{interface.package}/{interface.kind}/{interface.name}" for interface in unknown)
    sites: dict[Place, list[tuple[ApiCall, Finding | None]]] = {}
    for call in system.calls:
        if call.api in _SENDS:
            sites.setdefault(call.place, []).append((call, _judge(code, call, nowhere)))
    rows: list[tuple[ApiCall, Finding]] = []
    for place in sorted(sites):
        call, diagnostic = sites[place][0]
        # A call that serves several publishers, or is made in several ways, is wrong where each of them is.
        if diagnostic is not None and all(told is not None for _, told in sites[place]):
            rows.append((call, diagnostic))
    return rows


def is_told_where_it_is_sent(system: System, value: WrongValue) -> bool:
    """Whether the message that is given a wrong value is next sent where another type is wanted: the message is what
    is wrong, and not the value."""
    given = ((call, call.arguments.get(_SENDS[call.api][0])) for call, _ in _wrong_calls(system))
    return any(
        isinstance(sent, Message)
        and sent.type == value.type
        and is_next_use(source_code(system), value.place, call.place)
        for call, sent in given
    )


def _judge(code: SourceCode, call: ApiCall, nowhere: frozenset[str]) -> Finding | None:
    """The finding for one call, but for an endpoint of a type in ``nowhere``: the import that fails is the mistake."""
    argument, section_name = _SENDS[call.api]
    creation = _sender(call)
    given = call.arguments.get(argument)
    if creation is None or creation.type is None or given is None or creation.type in nowhere:
        return None
    nothing = isinstance(given, Constant) and given.value is None
    if nothing and (section_name == "Result" or not is_given_a_literal(code, call)):
        return None  # no result given, or an attribute that is None until some other callback has set it
    wrong = _wrong(given, creation.type, section_name)
    return None if wrong is None else _finding(call, creation, argument, section_name, wrong)


def _sender(call: ApiCall) -> Creation | None:
    """The one endpoint that sends; for a goal handle the server whose callback is given it."""
    if isinstance(call.receiver, GoalHandle):
        server = call.context.creation
        return server if server is not None and server.type == call.receiver.action else None
    creations = creations_of(call.receiver)
    return creations[0] if len(creations) == 1 else None


def _wrong(given: Given, type_: str, section_name: MessageClass) -> str | None:
    """What is given, in words, if it is certainly not what is wanted."""
    match given:
        case Message():
            fits = (given.type, given.section_name) == (type_, section_name)
            return None if fits else _words(given.type, given.section_name)
        case ForeignClass():
            interface, of = interface_and_section(canonical(given.path))
            return None if interface is None else f"the class {_words(interface, of)} itself"
        case Constant(value=bytes()) if not section_name:
            return None
        case Constant():
            return repr(given.value)
        case Collection():
            return f"a {given.kind}"
        case PlainValue(of_class=name):
            return _PLAIN[name]
    return _object_of_rclpy(given)


_PLAIN = {"bool": "a bool", "float": "a float", "int": "an int", "str": "a string"}


def _object_of_rclpy(given: Given) -> str | None:
    """What rclpy makes and what is no message, in words."""
    match given:
        case Object(foreign_class=str(path)) if path.startswith("rclpy."):
            return f"an object of {path}"
        case Future():
            return "a future"
        case Node():
            return "a node"
        case Duration():
            return "a Duration of rclpy"
    return None


def _finding(call: ApiCall, creation: Creation, argument: str, section_name: MessageClass, given: str) -> Finding:
    method = call.api.rpartition(".")[2]
    wanted = _words(creation.type or "", section_name)
    message = f"{method}() is called with {given}, but expects {wanted}"
    help = f"rclpy raises TypeError when this line runs; pass an object of {wanted}"
    if section_name and given == creation.type:
        # Source: the classes that rosidl generates for services and actions, whose __init__ raises it.
        name = given.rpartition("/")[2]
        message = f"{name}() raises NotImplementedError, before {method}() is called: nothing makes objects of {given}"
        help = f"write {name}.{section_name}()"
    return finding(
        "TOP005",
        call.argument_places.get(argument, call.place),
        message,
        help=help,
        related=[Related(creation.place, f"the {creation.kind.replace('_', ' ')} is created here")],
        node=creation.node.name.text,
        identity=(creation.kind, creation.name.text or "", given),
        group=(call.place.file, method, wanted),
    )


@folds("TOP005")
def _of_one_file(findings: Sequence[Finding]) -> Finding:
    """The finding for all calls of a file that pass the wrong type for the same one, from before it was ported say."""
    return with_others(findings, "another call is", "more calls are", "wrong in the same way")


def _words(type_: str, section_name: MessageClass) -> str:
    return f"{type_}.{section_name}" if section_name else type_
