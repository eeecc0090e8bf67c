"""EXE005: endpoints and timers that a callback creates anew each time it runs."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.reach import calls_of, creations_of, node_name, one_for_each_place
from archlint.analysis.taken_down import is_taken_down
from archlint.checks.folding import folds, with_other_places
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.connections.lessons import is_lesson
from archlint.connections.unsent_topics import is_sent_by_nobody
from archlint.execution.callback_roles import callback_words, runs_in_executor
from archlint.execution.early_lookups import early_lookups
from archlint.finding import Finding, Related
from archlint.model import (
    EntityKind,
    Role,
)

if TYPE_CHECKING:
    from archlint.model import Callback, Creation, Frame, Program
    from archlint.systems.model import System

_ENDS = (
    "rclpy.timer.Timer.cancel",
    "rclpy.action.client.ActionClient.destroy",
    *(f"rclpy.node.Node.destroy_{kind}" for kind in ("publisher", "subscription", "client", "service", "timer")),
)
_LEAVES = tuple(
    f"rclpy.{kind}.{kind.title()}.destroy" for kind in ("publisher", "subscription", "client", "service", "timer")
)
"""What ends an endpoint and leaves it on its node, which rclpy warns of: it piles up, and of publishers and
subscriptions the next spin raises."""
_LISTENER = "tf2_ros.transform_listener.TransformListener"
_PASSING = frozenset({"rclpy.wait_for_message.wait_for_message"})
"""Calls that take away what they create."""
_AGAIN_AND_AGAIN = frozenset(
    {Role.SUBSCRIPTION, Role.TIMER, Role.SERVICE, Role.EXECUTE, Role.GOAL, Role.CANCEL, Role.ACCEPTED, Role.FILTER}
)
"""Roles of callbacks that run as often as somebody likes; a done callback may be one step of a start-up."""


@rule("EXE005", scope=Scope.CODE)
def entity_created_in_callback(system: System, options: Options) -> Iterator[Finding]:
    """Create calls that a callback reaches each time it runs.  In a lesson, whoever tries a callback sends the message
    by hand."""
    lesson = is_lesson(system)
    ended, left = _given_to(system, _ENDS), _given_to(system, _LEAVES)
    listening = {(lookup.call.function, id(lookup.call.context)) for lookup in early_lookups(system)}
    yield from one_for_each_place(
        _created(system, creation, creation.context, id(creation) in left)
        for program in system.programs
        for node in program.nodes
        for creation in node.creations
        if creation.context is not None and _each_time(system, creation, creation.context, program, ended, left)
        # That a new listener has heard nothing yet is told at the lookup.
        if creation.api != _LISTENER or (creation.function, id(creation.context)) not in listening
        if lesson or not is_sent_by_nobody(system, creation.context)
    )


def _each_time(
    system: System, creation: Creation, callback: Callback, program: Program, ended: set[int], left: set[int]
) -> bool:
    return (
        callback.role in _AGAIN_AND_AGAIN
        and runs_in_executor(callback)
        and not system.roles.is_test(creation.place.file)
        and creation.api not in _PASSING
        and (creation.guard == "arguments" or not (creation.conditional or creation.guard))
        and not creation.destroyed
        and id(creation) not in ended
        # A name that data decides is another endpoint each time.
        and (creation.kind == EntityKind.TIMER or creation.name.resolution in ("exact", "parameter"))
        and (callback.creation is None or id(callback.creation) not in ended | left)
        and not program.exhausted
        and not is_taken_down(system, creation)
    )


def _given_to(system: System, ends: Sequence[str]) -> set[int]:
    """What somebody cancels or destroys: it does not pile up, and its callback runs once."""
    ended: set[int] = set()
    for _, call in calls_of(system, ends):
        given = [call.receiver, *call.arguments.values()]
        ended.update(id(creation) for value in given for creation in creations_of(value))
    return ended


def _created(system: System, creation: Creation, callback: Callback, left: bool) -> Finding:
    function = creation.api.rpartition(".")[2]
    # Where data decides the name as well, it is one of many.
    varies = any(other.place == creation.place and other.name != creation.name for other in creation.node.creations)
    named = creation.name.text and creation.kind != EntityKind.TIMER and not varies
    what = f"'{creation.name.text}'" if named else ""
    words = {"client": "client of", "service": "service", "publisher": "publisher of", "subscriber": "subscription to"}
    entity = f"{words.get(creation.kind, creation.kind.replace('_', ' '))} {what}".rstrip()
    entity = entity if what else entity.removesuffix(" of").removesuffix(" to")
    gets = "reaches this line" if creation.guard else "runs"
    end = "the old one is never destroyed"
    if left:
        raises = (
            ", and the next spin raises InvalidHandle"
            if creation.kind in (EntityKind.PUBLISHER, EntityKind.SUBSCRIBER)
            else ""
        )
        end = f"destroy() does not remove the old one from the node{raises}"
    article = "an" if entity[0] == "a" else "a"
    makes = next((frame for frame in creation.chain if frame.callee.endswith(_CONSTRUCTOR)), None)
    if makes is not None:
        if makes.callee.removesuffix(_CONSTRUCTOR).rpartition(".")[2] == creation.node.class_name and not left:
            end = "nothing destroys the old node: it lasts until Python's garbage collector finds it"
        return _of_object(system, creation, callback, makes, f"{article} {entity}, each time it {gets}, and {end}")
    return finding(
        "EXE005",
        creation.place,
        f"{callback_words(callback)} creates {article} {entity} each time it {gets}, and {end}",
        help=_once(creation, function, varies),
        related=[
            Related(callback.place, f"{callback.name} runs repeatedly"),
            *(Related(frame.place, f"{frame.caller} calls {frame.callee} here") for frame in creation.chain),
        ],
        node=node_name(system, creation.node),
        identity=(callback.name, creation.kind, creation.name.text or ""),
        group=(creation.place.file, creation.function, creation.kind, callback.place.file, str(callback.place.line)),
    )


_CONSTRUCTOR = ".__init__"


def _of_object(system: System, creation: Creation, callback: Callback, makes: Frame, entity: str) -> Finding:
    """What the constructor of an object creates that the callback makes: the object is to be made once."""
    kind = makes.callee.removesuffix(_CONSTRUCTOR).rpartition(".")[2]
    owner = callback.name.rpartition(".")[0]
    where = f"in the constructor of {owner}" if owner.isidentifier() else "where the node is made"
    return finding(
        "EXE005",
        makes.place,
        f"{callback_words(callback)} makes {'an' if kind[0] in 'AEIO' else 'a'} {kind}, which creates {entity}",
        help=f"make the {kind} once, {where}, and keep it",
        related=[
            Related(callback.place, f"{callback.name} runs repeatedly"),
            *(
                Related(each.place, f"{each.caller} calls {each.callee} here")
                for each in creation.chain
                if each != makes
            ),
            Related(creation.place, "it is created here"),
        ],
        node=node_name(system, creation.node),
        identity=(callback.name, creation.kind, creation.name.text or ""),
        group=(makes.place.file, makes.caller, kind, callback.place.file, str(callback.place.line)),
    )


def _once(creation: Creation, function: str, varies: bool) -> str:
    if creation.kind == EntityKind.TIMER:
        return "create it once in the constructor, cancel() it there and reset() it here"
    if varies:
        return (
            f"store the result of {function}() in a dict by name, and call it only for names that are not in the "
            "dict yet"
        )
    return f"call {function}() once in the constructor, and store the result"


@folds("EXE005")
def _of_one_function(findings: Sequence[Finding]) -> Finding:
    """The finding for all that a function creates each time: one change mends it."""
    return with_other_places(findings, "another one is created here each time")
