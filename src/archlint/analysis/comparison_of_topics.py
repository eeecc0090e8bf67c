"""The topics of a bag, held against who publishes them in the source.

A bag has what was recorded and says nothing of the rest: a topic that is not in it is not missing.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

from archlint.analysis.coexistence import certain
from archlint.analysis.comparable import is_complete_node, what_is_compared
from archlint.analysis.comparison_of_ends import contradictions, may_be_compared
from archlint.model import (
    EntityKind,
)
from archlint.observed.model import DIFFERENT, UNEXPECTED, Comparison, Difference, Observed, SeenTopic
from archlint.ros.names import is_hidden, pattern_matches
from archlint.suggestions import did_you_mean
from archlint.systems.implicit import implicit_names

if TYPE_CHECKING:
    from archlint.ros.qos import Qos
    from archlint.systems.model import System
    from archlint.systems.nodes import Connection, Endpoint


_OF_THE_RECORDER = "rosbag2_interfaces/"
"""Types of what `ros2 bag record` itself publishes, such as /events/write_split."""


def topics_of(system: System, observed: Observed, is_external: Callable[[str], bool]) -> Comparison:
    implicit = implicit_names(system)
    differences: list[Difference] = []
    left_open: list[str] = []
    same = 0
    for topic in sorted(observed.topics, key=lambda seen: seen.name):
        if is_hidden(topic.name) or topic.name in implicit or topic.type.startswith(_OF_THE_RECORDER):
            continue
        connection = system.topics.get(topic.name)
        if connection is not None and connection.providers:
            different = list(_different(system, topic, connection))
            differences += different
            same += not different
            continue
        why = _may_publish(system, topic.name)
        if is_external(topic.name) or why is not None:
            left_open.append(f"{topic.name} is in the bag; {why or 'it is declared external'}")
        else:
            differences.append(_unexpected(system, topic))
    there = {topic.name for topic in observed.topics}
    absent = [name for name, expected in system.topics.items() if expected.providers and name not in there]
    notes = (f"not recorded, so not compared: {', '.join(absent)}",) if absent else ()
    what = f"the topics that are published in {what_is_compared(system)}"
    return Comparison(observed, what, tuple(differences), 0, same, tuple(left_open), notes)


def _different(system: System, topic: SeenTopic, connection: Connection) -> Iterator[Difference]:
    ends = [end for end in connection.providers if not end.node.test]
    types = {end.type for end in ends}
    if ends and topic.type not in types:
        if None not in types and _may_publish(system, topic.name) is None:
            yield _other(topic, ends[0], ends[0].type or "", topic.type, "has the type {}, but {} in the source")
        return
    profiles = [end.qos for end in ends if end.qos is not None and may_be_compared(end.qos)]
    if len(profiles) < len(ends) or _may_publish(system, topic.name) is not None:
        return
    for offered in topic.offered:
        if all(contradictions(profile, offered, EntityKind.PUBLISHER) for profile in profiles):
            yield _other_qos(topic, ends, offered)
            return


def _other_qos(topic: SeenTopic, ends: list[Endpoint], offered: Qos) -> Difference:
    end = next((endpoint for endpoint in ends if certain(endpoint)), ends[0])
    assert end.qos is not None
    policies = contradictions(end.qos, offered, EntityKind.PUBLISHER)
    here, there = (" and ".join(words) for words in zip(*policies, strict=True))
    return _other(topic, end, here, there, "was offered with {}, but has {} in the source")


def _other(topic: SeenTopic, end: Endpoint, expected: str, observed: str, words: str) -> Difference:
    return Difference(
        DIFFERENT,
        EntityKind.PUBLISHER,
        topic.name,
        end.node.name,
        f"{topic.name} {words.format(observed, expected)}",
        "record again if the bag is older than the source, or else rebuild and restart the system",
        end.place,
        expected,
        observed,
        ((topic.place, "this is what was recorded"),),
    )


def _unexpected(system: System, topic: SeenTopic) -> Difference:
    published = [name for name, connection in system.topics.items() if connection.providers]
    return Difference(
        UNEXPECTED,
        "topic",
        topic.name,
        None,
        f"{topic.name} ({topic.type}) was recorded, but no node here publishes it{did_you_mean(topic.name, published)}",
        "list the name under `external` in the configuration if something outside publishes it",
        topic.place,
        observed=topic.type,
        doubtful=system.launched is None,
    )


def _may_publish(system: System, name: str) -> str | None:
    """Why somebody whose publishers are not all known may publish a topic; None if nobody."""
    for node in system.nodes:
        if node.test:
            continue
        if not is_complete_node(system, node):
            return f"not all that {node.name or 'one of the nodes'} publishes is known"
        for end in node.of_kind(EntityKind.PUBLISHER):
            if not end.resolved and (end.name is None or pattern_matches(end.name, name)):
                return f"it may be the publisher of {end.place.file}:{end.place.line}"
    for gap in system.launched.not_followed() if system.launched is not None else ():
        return f"{gap.place.file}:{gap.place.line} may start its publisher: {gap.reason}"
    return None
