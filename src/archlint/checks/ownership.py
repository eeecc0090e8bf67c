"""OWN001: topics that more than one node publishes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_disused
from archlint.checks.folding import folds
from archlint.checks.owner_findings import all_of, finding_for_owners
from archlint.checks.registry import Options, rule
from archlint.checks.scope import Scope
from archlint.connections.arbitration import take_turns
from archlint.connections.echoes import is_driven, repeats
from archlint.connections.hand_overs import hand_over
from archlint.connections.happenings import are_events, are_requests
from archlint.connections.lessons import is_lesson
from archlint.connections.owners import several_owners, some_coexist
from archlint.connections.sharing import (
    are_of_one_class,
    are_words,
    is_bus,
    is_named_a_command,
    is_state,
    overrides,
    say_the_same,
)
from archlint.connections.streams import is_at_it_all_the_time, sends_again_and_again, waits_for_nobody
from archlint.connections.switched_off import switch_of
from archlint.connections.taken_in import ask_with_true, say_whose
from archlint.finding import Finding, Related, Severity
from archlint.ros.well_known import BY_CLICK, OF_MANY_PUBLISHERS, TYPES_OF_MANY_PUBLISHERS

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.launch.started import Remap
    from archlint.systems.model import System
    from archlint.systems.nodes import Connection, Endpoint


_EMPTY = "std_msgs/msg/Empty"


@rule("OWN001", scope=Scope.SYSTEM, texts=False, occasions=False)
def multiple_publishers(system: System, options: Options) -> Iterator[Finding]:
    """Topics with publishers in several nodes that run together; what a launch file starts that is put aside runs no
    more.  Texts that stand for themselves count in a lesson and with ``texts``, and so do with ``occasions`` nodes of
    which one alone publishes whatever happens."""
    lesson = is_lesson(system)
    texts, occasions = options.flag("texts") or lesson, options.flag("occasions") or lesson
    if system.launched is not None and is_disused(system.workspace, system.launched.file):
        return
    findings = [
        _of_topic(system, connection, owners)
        for connection in system.topics.values()
        if not _is_shared(connection, options)
        for owners in several_owners(system, connection)
        if not _is_meant(system, connection, owners)
        and (texts or _is_obeyed(connection, owners))
        and (occasions or _all_insist(system, owners))
    ]
    gravest: dict[tuple[str, ...], Severity] = {}
    for finding in findings:
        nodes = finding.identity[2:]
        gravest[nodes] = max(gravest.get(nodes, finding.severity), finding.severity)
    for finding in findings:  # what the same nodes publish beside a command is reported along with it
        yield replace(finding, severity=gravest[finding.identity[2:]])


def _is_meant(system: System, connection: Connection, owners: list[Endpoint]) -> bool:
    """Whether several nodes are there to publish a topic, or do not do so at once."""
    if is_bus(system.workspace, connection, owners) or say_whose(system, owners) or say_the_same(owners):
        return True
    if any(end.node.program is not None and end.node.program.exhausted for end in owners):
        return True  # the run ended before all that it publishes was seen, and on which occasions
    if all(end.type == _EMPTY for end in owners):
        return True  # it only says that something is to be done: no message takes back another
    if are_events(system, owners) or are_requests(connection) or ask_with_true(system, connection):
        return True
    add_up = are_words(owners) and not is_state(connection.name)
    if add_up and (_says_what_happens(connection.name) or are_of_one_class(owners)):
        return True  # each text stands for itself
    speaking = [end for end in owners if not is_driven(system, end, owners) and not repeats(system, end)]
    if len({id(end.node) for end in speaking}) < 2:
        return True
    if sum(switch_of(system, end) is None and not waits_for_nobody(system, end) for end in owners) < 2:
        return True  # as started here, one of them says something
    if not any(sends_again_and_again(system, end) for end in owners):
        return True  # each speaks on an occasion: who sent last is meant to be obeyed
    if not overrides(connection, owners) and sum(is_at_it_all_the_time(system, end) for end in owners) < 2:
        return True  # what is said on request beside a stream of values takes nothing back
    if not some_coexist(system, owners):
        return True  # alternatives, or started by hand by somebody who knows what else runs
    return hand_over(owners) or take_turns(system, owners)


def _all_insist(system: System, owners: list[Endpoint]) -> bool:
    """Whether two of several nodes publish whatever happens, or all run the same code: a condition or a word from
    elsewhere may be what lets one of them speak at a time."""
    return are_of_one_class(owners) or sum(sends_again_and_again(system, end) for end in owners) > 1


def _of_topic(system: System, connection: Connection, owners: list[Endpoint]) -> Finding:
    switches = {end.node.name: switch for end in owners if (switch := switch_of(system, end)) is not None}
    finding = finding_for_owners(
        "OWN001",
        owners,
        f"{all_of(owners)} publish the topic '{connection.name}'{_if_set(switches)}",
        f"publishes '{connection.name}' here",
        "give each its own topic and let one node arbitrate, or list the topic under shared-topics if it is meant "
        "to be shared",
    )
    remapped_at = _remapped_at(owners)
    if remapped_at is not None:
        finding = _at_the_remapping(finding, owners, remapped_at)
    return finding if _is_obeyed(connection, owners) else replace(finding, severity=Severity.INFO)


def _remapped_at(owners: list[Endpoint]) -> Place | None:
    """The remapping that gives the last of several nodes its topic, where all of them run the same line of code: what
    is wrong is not there."""
    last = owners[-1]
    if last.node.started is None or len({end.place for end in owners}) > 1 or last.written == last.name:
        return None
    remaps = [remap for remap in last.node.started.remaps if _is_to(remap, last.name)]
    return remaps[0].place if len(remaps) == 1 else None


def _is_to(remap: Remap, name: str | None) -> bool:
    return remap.target.resolution == "exact" and remap.target.text == name


def _at_the_remapping(finding: Finding, owners: list[Endpoint], place: Place) -> Finding:
    """The finding where the launch file makes one topic of those of several nodes."""
    others = [
        Related(remap.place, f"{end.node.shown} is given '{end.name}' here")
        for end in owners[:-1]
        for remap in (() if end.node.started is None else end.node.started.remaps)
        if _is_to(remap, end.name)
    ]
    code = Related(finding.place, f"{finding.node} publishes it here")
    help = "remap each to a topic of its own, or list the topic under shared-topics if it is meant to be shared"
    return replace(finding, place=place, help=help, related=(*others, code))


def _if_set(switches: Mapping[str | None, str]) -> str:
    """What must be set for some of the nodes to publish."""
    conditions = [f"{node} if its parameter '{switches[node]}' is set" for node in sorted(switches, key=str)]
    return f" ({', '.join(conditions)})" if conditions else ""


def _is_obeyed(connection: Connection, owners: list[Endpoint]) -> bool:
    """Whether the last message is what counts: a command or a value, and no text that stands for itself."""
    return not are_words(owners) or is_state(connection.name)


def _is_shared(connection: Connection, options: Options) -> bool:
    return (
        connection.name in OF_MANY_PUBLISHERS | BY_CLICK
        or options.is_shared(connection.name)
        or (bool(connection.types) and TYPES_OF_MANY_PUBLISHERS.issuperset(connection.types))
    )


_TELLING = frozenset({"alert", "alerts", "console", "debug", "event", "events", "heartbeat", "heartbeats"}) | {
    *("log", "logs", "notification", "notifications", "say", "speech", "status", "statuses", "tts"),
}
"""Words for what many nodes have to say on one topic."""


def _says_what_happens(topic: str) -> bool:
    """Whether a topic is for what any node may have to say: a log, events."""
    return not _TELLING.isdisjoint(topic.rpartition("/")[2].lower().split("_"))


@folds("OWN001", across_systems=True)
def _of_one_node(findings: Sequence[Finding]) -> Finding:
    """What one node publishes beside others, on all its topics and in all launch files: the finding for the most nodes
    says which, that for a command if there is one; what else is so is related."""
    most = max(findings, key=_weight)
    same = [finding for finding in findings if finding.identity[2:] == most.identity[2:]]
    topics = list(dict.fromkeys(finding.identity[1] for finding in (most, *same)))
    rest = [Related(finding.place, f"{finding.node} publishes '{finding.identity[1]}' here") for finding in findings]
    rows = [row for finding in (most, *findings) for row in finding.related] + rest
    return replace(
        most,
        message=most.message.replace(f"the topic '{topics[0]}'", _topics(topics)),
        related=tuple(row for row in dict.fromkeys(rows) if row.place != most.place or row not in rest),
    )


def _weight(finding: Finding) -> tuple[bool, int, bool]:
    return finding.condition is None, len(finding.identity), is_named_a_command(finding.identity[1])


_NAMED = 4


def _topics(names: Sequence[str]) -> str:
    if len(names) == 1:
        return f"the topic '{names[0]}'"
    quoted = [f"'{name}'" for name in names]
    if len(names) > _NAMED:
        quoted = [*quoted[: _NAMED - 1], f"{len(names) - _NAMED + 1} more"]
    return f"the topics {', '.join(quoted[:-1])} and {quoted[-1]}"
