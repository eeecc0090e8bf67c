"""The forms that a file may have, as structures that are checked when they are read.

Sources: rosbag2 ``qos.cpp`` and ``yaml.hpp`` (before version 9 profiles are a text of YAML with numbers, from then on
a list with words); ``Graph.msg``, ``NodeInfo.msg``, ``Topic.msg`` and ``QosProfile.msg`` of
rosgraph_monitor_msgs 0.2, and their successors in rosgraph_msgs; rmw ``types.h`` for the numbers of policies.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from typing import Any, Final, TypeVar

import msgspec
from msgspec import Struct, field

from archlint import model as program
from archlint.finding import Place
from archlint.observed.model import BAG, MONITOR, RECORDING, Observed, SeenEnd, SeenNode, SeenParameter, SeenTopic
from archlint.records import dataclass
from archlint.ros.qos import Durability, History, Liveliness, Qos, Reliability
from archlint.syntax.safe_yaml import YamlError, YamlReader

VERSION = 1
"""The newest version of a recording that is understood."""

_HISTORY: Final[tuple[History, ...]] = ("system_default", "keep_last", "keep_all", "unknown")
_RELIABILITY: Final[tuple[Reliability, ...]] = (
    "system_default",
    "reliable",
    "best_effort",
    "unknown",
    "best_available",
)
_DURABILITY: Final[tuple[Durability, ...]] = (
    "system_default",
    "transient_local",
    "volatile",
    "unknown",
    "best_available",
)
_LIVELINESS: Final[tuple[Liveliness, ...]] = (
    "system_default",
    "automatic",
    "manual_by_node",
    "manual_by_topic",
    "unknown",
    "best_available",
)
_UNSPECIFIED = ("system_default", "unknown", "best_available")
"""What a middleware says where it does not know, or has not decided."""
_FOREVER_S = 1e9
"""Several spellings of infinity are about; none of them is less than 30 years."""


_Form = TypeVar("_Form")
_Word = TypeVar("_Word", bound=str)


class NotOfThisForm(Exception):
    """Nothing in the file says what it is."""


class Malformed(Exception):
    """The file says what it is, and is not; ``str()`` says where."""


@dataclass(frozen=True)
class ObservedFile:
    """A file that describes a running system: its shown path, its text, and a hash of that."""

    file: str
    text: str
    digest: str


class _Duration(Struct):
    sec: int = 0
    nanosec: int = 0
    nsec: int = 0

    @property
    def seconds(self) -> float | None:
        """None for no bound."""
        length = self.sec + (self.nanosec or self.nsec) / 1e9
        return length if 0 < length < _FOREVER_S else None


class _Qos(Struct):
    """A profile in any of the forms: words or numbers, and durations as numbers or pairs."""

    reliability: str | int | None = None
    durability: str | int | None = None
    liveliness: str | int | None = None
    history: str | int | None = None
    depth: int | None = None
    deadline_s: float | None = None
    lifespan_s: float | None = None
    lease_s: float | None = None
    deadline: _Duration = field(default_factory=_Duration)
    lifespan: _Duration = field(default_factory=_Duration)
    liveliness_lease_duration: _Duration = field(default_factory=_Duration)

    def profile(self) -> Qos:
        return Qos(
            history=_policy(self.history, _HISTORY),
            depth=self.depth,
            reliability=_policy(self.reliability, _RELIABILITY),
            durability=_policy(self.durability, _DURABILITY),
            liveliness=_policy(self.liveliness, _LIVELINESS),
            deadline=self.deadline_s or self.deadline.seconds,
            lifespan=self.lifespan_s or self.lifespan.seconds,
            liveliness_lease=self.lease_s or self.liveliness_lease_duration.seconds,
        )


def _policy(given: str | int | None, words: Sequence[_Word]) -> _Word | None:
    if isinstance(given, int):
        given = words[given] if 0 <= given < len(words) else None
    return next((word for word in words if word == given and word not in _UNSPECIFIED), None)


def observed(data: Any, source: ObservedFile) -> Observed:
    """Raises :class:`NotOfThisForm` or :class:`Malformed`."""
    match data:
        case {"archlint_observed": _}:
            return _of_recording(_converted(data, _Recording), source)
        case {"rosbag2_bagfile_information": _}:
            return _of_bag(_converted(data, _BagFile).rosbag2_bagfile_information, source)
        case {"msg": dict() as message}:
            return _of_message(message, source)
    return _of_message(data, source)


def _of_message(data: Any, source: ObservedFile) -> Observed:
    match data:
        case {"nodes": list() as nodes} if "..." in nodes:
            raise Malformed("the message is truncated: use `ros2 topic echo --full-length`")
        case {"nodes": list() as nodes} if "version" not in data and all(_may_be_message(node) for node in nodes):
            return _of_monitor(_converted(data, _Graph), source)
    raise NotOfThisForm


def _converted(data: Any, type_: type[_Form]) -> _Form:
    try:
        return msgspec.convert(data, type_)
    except msgspec.ValidationError as error:
        raise Malformed(f"unexpected content: {error}") from None


# ------------------------------------------------------------------------------------------ archlint's own recorder


class _RecordedEnd(Struct):
    name: str
    type: str
    qos: _Qos | None = None


class _RecordedParameter(Struct):
    name: str
    type: str | None = None


class _RecordedNode(Struct):
    name: str
    count: int = 1
    publishers: list[_RecordedEnd] = []
    subscribers: list[_RecordedEnd] = []
    services: list[_RecordedEnd] = []
    clients: list[_RecordedEnd] = []
    action_servers: list[_RecordedEnd] = []
    action_clients: list[_RecordedEnd] = []
    parameters: list[_RecordedParameter] | None = None


class _Recording(Struct):
    archlint_observed: int
    nodes: list[_RecordedNode]
    settled: bool = True


_ALL_KINDS = (
    program.EntityKind.PUBLISHER,
    program.EntityKind.SUBSCRIBER,
    program.EntityKind.SERVICE,
    program.EntityKind.CLIENT,
    program.EntityKind.ACTION_SERVER,
    program.EntityKind.ACTION_CLIENT,
)


def _of_recording(data: _Recording, source: ObservedFile) -> Observed:
    if data.archlint_observed > VERSION:
        raise Malformed("it was recorded by a newer archlint: update archlint, or record again")
    places = _Places(source.file, source.text)
    return Observed(
        source.file,
        RECORDING,
        source.digest,
        nodes=tuple(_recorded_node(node, places) for node in data.nodes),
        kinds=frozenset(_ALL_KINDS),
        settled=data.settled,
    )


def _recorded_node(node: _RecordedNode, places: _Places) -> SeenNode:
    lists = (
        node.publishers,
        node.subscribers,
        node.services,
        node.clients,
        node.action_servers,
        node.action_clients,
    )
    ends = [
        SeenEnd(kind, end.name, end.type, end.qos.profile() if end.qos else None)
        for kind, listed in zip(_ALL_KINDS, lists, strict=True)
        for end in listed
    ]
    known = node.parameters
    asked = None if known is None else tuple(SeenParameter(parameter.name, parameter.type) for parameter in known)
    return SeenNode(node.name, tuple(ends), places.of(node.name), node.count, asked)


# ---------------------------------------------------------------------------------------------- rosbag2 metadata.yaml


class _TopicMetadata(Struct):
    name: str
    type: str
    offered_qos_profiles: str | list[_Qos] | None = None


class _BagTopic(Struct):
    topic_metadata: _TopicMetadata


class _Bag(Struct):
    topics_with_message_count: list[_BagTopic]


class _BagFile(Struct):
    rosbag2_bagfile_information: _Bag


def _of_bag(data: _Bag, source: ObservedFile) -> Observed:
    places = _Places(source.file, source.text)
    topics = [
        SeenTopic(topic.name, topic.type, tuple(qos.profile() for qos in _offered(topic)), places.of(topic.name))
        for topic in (entry.topic_metadata for entry in data.topics_with_message_count)
    ]
    return Observed(
        source.file, BAG, source.digest, topics=tuple(topics), kinds=frozenset([program.EntityKind.PUBLISHER])
    )


def _offered(topic: _TopicMetadata) -> list[_Qos]:
    given = topic.offered_qos_profiles
    if not isinstance(given, str):
        return given or []
    try:
        reader = YamlReader(given)
        value = reader.value(reader.root) if reader.root is not None else []
    except YamlError as error:
        raise Malformed(f"the offered_qos_profiles of {topic.name}: {error.message}") from None
    return _converted(value or [], list[_Qos])


# ------------------------------------------------------------------- rosgraph_monitor_msgs/Graph, rosgraph_msgs/Graph


class _TypeName(Struct):
    name: str = ""


class _Topic(Struct):
    name: str
    type: str | _TypeName = ""
    qos: _Qos | None = None


class _Service(Struct):
    """Services have ``request_type``, actions too; which type they make together, only the name says."""

    name: str
    request_type: _TypeName = field(default_factory=_TypeName)


class _Node(Struct):
    name: str
    publishers: list[_Topic] = []
    subscriptions: list[_Topic] = []
    service_servers: list[_Service] = []
    service_clients: list[_Service] = []
    action_servers: list[_Service] = []
    action_clients: list[_Service] = []


class _Graph(Struct):
    nodes: list[_Node]


def _may_be_message(node: Any) -> bool:
    match node:
        case {"name": _, "publishers": _} | {"name": _, "subscriptions": _}:
            return True
    return False


def _of_monitor(data: _Graph, source: ObservedFile) -> Observed:
    """What no node at all has of a kind, the monitor does not watch: as of 2025 it reports topics only."""
    places = _Places(source.file, source.text)
    nodes = tuple(SeenNode(node.name, tuple(_ends_of(node)), places.of(node.name)) for node in data.nodes)
    watched = {end.kind for node in nodes for end in node.ends} - {
        program.EntityKind.PUBLISHER,
        program.EntityKind.SUBSCRIBER,
    }
    return Observed(
        source.file,
        MONITOR,
        source.digest,
        nodes=nodes,
        kinds=frozenset({program.EntityKind.PUBLISHER, program.EntityKind.SUBSCRIBER, *watched}),
    )


def _ends_of(node: _Node) -> Iterable[SeenEnd]:
    for kind, topics in (
        (program.EntityKind.PUBLISHER, node.publishers),
        (program.EntityKind.SUBSCRIBER, node.subscriptions),
    ):
        for topic in topics:
            type_ = topic.type if isinstance(topic.type, str) else topic.type.name
            yield SeenEnd(kind, topic.name, type_ or None, topic.qos.profile() if topic.qos else None)
    for kind, services in (
        (program.EntityKind.SERVICE, node.service_servers),
        (program.EntityKind.CLIENT, node.service_clients),
        (program.EntityKind.ACTION_SERVER, node.action_servers),
        (program.EntityKind.ACTION_CLIENT, node.action_clients),
    ):
        for service in services:
            service_type, suffix, _ = service.request_type.name.partition("_Request")
            yield SeenEnd(kind, service.name, service_type if suffix else None)


# -------------------------------------------------------------------------------------------------------------- places


class _Places:
    """Finds the line of a file that names something."""

    def __init__(self, file: str, text: str) -> None:
        self._file = file
        self._lines: dict[str, Place] = {}
        for number, line in enumerate(text.splitlines(), 1):
            for match in re.finditer(r"""["']?name["']?\s*:\s*["']?(/[\w/]*)""", line):
                columns = (match.start(1) + 1, match.end(1) + 1)
                self._lines.setdefault(match[1], Place(file, number, columns[0], number, columns[1]))

    def of(self, name: str) -> Place:
        return self._lines.get(name, Place(self._file, 1, 1, 1, 1))
