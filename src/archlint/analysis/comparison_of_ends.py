"""What one running node has, held against the endpoints and parameters of its source."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import field
from typing import TYPE_CHECKING

from archlint import model as program
from archlint.analysis.coexistence import certain, named_by_library
from archlint.observed.model import DIFFERENT, MISSING, UNEXPECTED, Difference, Observed, SeenEnd, SeenNode
from archlint.records import dataclass
from archlint.ros.names import is_hidden, pattern_matches
from archlint.systems.implicit import implicit_names

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.model import EntityKind
    from archlint.observed.model import Status
    from archlint.ros.qos import Qos
    from archlint.systems.model import System
    from archlint.systems.nodes import Endpoint, Node

VERBS = {
    program.EntityKind.PUBLISHER: ("publishes", "publisher"),
    program.EntityKind.SUBSCRIBER: ("subscribes to", "subscription"),
    program.EntityKind.SERVICE: ("serves", "service"),
    program.EntityKind.CLIENT: ("has a client of", "client"),
    program.EntityKind.ACTION_SERVER: ("serves the action", "action server"),
    program.EntityKind.ACTION_CLIENT: ("has a client of the action", "action client"),
}
"""By kind: what a node does there, and what the end is called."""
_AT_THE_START = (program.Role.INIT, program.Role.MAIN, program.Role.MODULE)
_OTHER_BUILD = "rebuild and restart it: what runs may be older than the source, or started with other arguments"
_TOLERANCE_S = 1e-6


@dataclass
class Ends:
    """What came of one node: ``same`` counts the ends that both sides have."""

    differences: list[Difference] = field(default_factory=list)
    same: int = 0
    left_open: list[str] = field(default_factory=list)


def ends_of(system: System, node: Node, seen: SeenNode, observed: Observed, complete: bool) -> Ends:
    """``complete`` says that all that the node's source creates was seen.  Of a node whose source is not here nothing
    is known, and nothing is said."""
    result = Ends()
    if node.blueprint is None:
        return result
    for kind in VERBS:
        if kind in observed.kinds:
            _Kind(system, node, seen, kind, complete, result).compare()
    result.differences += _parameters(node, seen)
    return result


def _parameters(node: Node, seen: SeenNode) -> Iterator[Difference]:
    """Declared parameters that have another type when the node runs; what it has beside them is not judged, for
    launch files and libraries declare, too."""
    there = {parameter.name: parameter.type for parameter in seen.parameters or ()}
    for declaration in node.parameters:
        name, type_ = declaration.name.text, None if declaration.dynamic else declaration.type
        running = there.get(name or "")
        if declaration.name.resolution != "exact" or name is None or type_ is None or running in (None, type_):
            continue
        yield Difference(
            DIFFERENT,
            "parameter",
            name,
            node.name,
            f"the parameter {name} of {node.name} is of type {running} when it runs, but {type_} in the source",
            _OTHER_BUILD,
            declaration.place,
            type_,
            running or "",
            ((seen.place, "this is what was observed"),),
            seen,
        )


class _Kind:
    """All ends of one kind of one node."""

    def __init__(
        self, system: System, node: Node, seen: SeenNode, kind: EntityKind, complete: bool, result: Ends
    ) -> None:
        self.system, self.node, self.seen_node, self.kind, self.complete = system, node, seen, kind, complete
        self.result = result
        self.expected: dict[str, list[Endpoint]] = {}
        self.open: list[Endpoint] = []
        for end in node.of_kind(kind):
            if end.resolved and end.name is not None and end.error is None:
                self.expected.setdefault(end.name, []).append(end)
            elif end.error is None:
                self.open.append(end)
        self.seen: dict[str, list[SeenEnd]] = {}
        for seen_end in seen.ends:
            if seen_end.kind == kind:
                self.seen.setdefault(seen_end.name, []).append(seen_end)

    def compare(self) -> None:
        for name in sorted(self.expected.keys() & self.seen.keys()):
            self._types(name, self.expected[name], self.seen[name])
        missing = [name for name in sorted(self.expected.keys() - self.seen.keys()) if self._must_be_there(name)]
        extra = [name for name in sorted(self.seen.keys() - self.expected.keys()) if self._is_of_the_node(name)]
        for name, other in self._renamed(missing, extra):
            missing.remove(name)
            extra.remove(other)
            self.result.differences.append(self._under_another_name(name, other))
        self.result.differences += (self._missing(name) for name in missing)
        for name in extra:
            self._extra(name)

    # ----------------------------------------------------------------------------------------- which names are there

    def _must_be_there(self, name: str) -> bool:
        """Whether the node has an end of this name as soon as it has started, whatever else happens."""
        return not is_hidden(name) and any(_is_made_at_the_start(end) for end in self.expected[name])

    def _is_of_the_node(self, name: str) -> bool:
        """Whether the node's own code must have made it, and not rclpy."""
        return not is_hidden(name) and name not in implicit_names(self.system)

    def _renamed(self, missing: Sequence[str], extra: Sequence[str]) -> Iterator[tuple[str, str]]:
        """Pairs of a missing name and one that is there instead: the only ones of their type."""
        for name in list(missing):
            type_ = self.expected[name][0].type
            alike = [other for other in extra if self.seen[other][0].type == type_]
            rivals = [other for other in missing if self.expected[other][0].type == type_]
            if type_ is not None and len(alike) == 1 and len(rivals) == 1 and not self.open:
                yield name, alike[0]

    def _extra(self, name: str) -> None:
        seen = self.seen[name][0]
        verb, noun = VERBS[self.kind]
        may_be = [end for end in self.open if end.name is None or pattern_matches(end.name, name)]
        if may_be:
            place = may_be[0].place
            said = f"{self.node.name} {verb} {name}; it may be the {noun} of {place.file}:{place.line}"
            self.result.left_open.append(said)
        elif not self.complete:
            said = f"{self.node.name} {verb} {name}; not all of the node's code could be followed"
            self.result.left_open.append(said)
        else:
            self.result.differences.append(self._unexpected(name, seen))

    # --------------------------------------------------------------------------------------------------- differences

    @property
    def _by_hand(self) -> bool:
        """Whether no launch file is known, so that the node may have been started with any remapping."""
        return self.system.launched is None

    def _missing(self, name: str) -> Difference:
        end = self.expected[name][0]
        noun = VERBS[self.kind][1]
        return self._difference(
            MISSING,
            name,
            f"{self.node.name} runs without its {noun} {name}",
            _OTHER_BUILD,
            end,
            expected=end.type or "",
            doubtful=self._by_hand,
        )

    def _unexpected(self, name: str, seen: SeenEnd) -> Difference:
        verb, _ = VERBS[self.kind]
        type_ = f" ({seen.type})" if seen.type else ""
        return self._difference(
            UNEXPECTED,
            name,
            f"{self.node.name} {verb} {name}{type_} when it runs, but its source does not",
            _OTHER_BUILD,
            None,
            observed=seen.type or "",
            seen=seen,
            doubtful=self._by_hand,
        )

    def _under_another_name(self, name: str, other: str) -> Difference:
        end = self.expected[name][0]
        verb, _ = VERBS[self.kind]
        return self._difference(
            DIFFERENT,
            name,
            f"{self.node.name} {verb} {other} when it runs, but {name} in the source",
            "look for a remapping or a parameter that it was started with, or rebuild and restart it",
            end,
            expected=name,
            observed=other,
            seen=self.seen[other][0],
            doubtful=self._by_hand,
        )

    def _types(self, name: str, expected: Sequence[Endpoint], seen: Sequence[SeenEnd]) -> None:
        known = {end.type for end in expected}
        there = {seen_end.type for seen_end in seen}
        self.result.same += 1
        if None in known or None in there:
            return
        wrong = sorted(type_ for type_ in there - known if type_ is not None)
        if wrong:
            lost = [end for end in expected if end.type not in there] or list(expected)
            self.result.same -= 1
            self.result.differences.append(self._other_type(name, lost[0], wrong[0], seen))
            return
        if self.kind in (program.EntityKind.PUBLISHER, program.EntityKind.SUBSCRIBER):
            for type_ in sorted(known & there, key=str):
                self._qos(name, [e for e in expected if e.type == type_], [s for s in seen if s.type == type_])

    def _other_type(self, name: str, end: Endpoint, type_: str, seen: Sequence[SeenEnd]) -> Difference:
        noun = VERBS[self.kind][1]
        return self._difference(
            DIFFERENT,
            name,
            f"the {noun} {name} of {self.node.name} has the type {type_} when it runs, but {end.type} in the source",
            _OTHER_BUILD,
            end,
            expected=end.type or "",
            observed=type_,
            seen=next(seen_end for seen_end in seen if seen_end.type == type_),
        )

    def _qos(self, name: str, expected: Sequence[Endpoint], seen: Sequence[SeenEnd]) -> None:
        profiles = [seen_end.qos for seen_end in seen if seen_end.qos is not None]
        wanted = [(end, end.qos) for end in expected if end.qos is not None and may_be_compared(end.qos)]
        if not profiles or len(wanted) < len(expected):
            return
        for end, qos in wanted:
            if not certain(end) or any(not contradictions(qos, profile, self.kind) for profile in profiles):
                continue
            lone = [
                profile for profile in profiles if all(contradictions(other, profile, self.kind) for _, other in wanted)
            ]
            policies = contradictions(qos, (lone or profiles)[0], self.kind)
            self.result.same -= 1
            self.result.differences.append(self._other_qos(name, end, policies))
            return

    def _other_qos(self, name: str, end: Endpoint, policies: Sequence[tuple[str, str]]) -> Difference:
        noun = VERBS[self.kind][1]
        there, here = (" and ".join(words) for words in zip(*((o, e) for e, o in policies), strict=True))
        return self._difference(
            DIFFERENT,
            name,
            f"the {noun} {name} of {self.node.name} is {there} when it runs, but {here} in the source",
            _OTHER_BUILD,
            end,
            expected=here,
            observed=there,
            seen=self.seen[name][0],
        )

    def _difference(
        self,
        status: Status,
        name: str,
        message: str,
        help: str,
        end: Endpoint | None,
        *,
        expected: str = "",
        observed: str = "",
        seen: SeenEnd | None = None,
        doubtful: bool = False,
    ) -> Difference:
        assert self.node.blueprint is not None
        place: Place = self.node.blueprint.place if end is None else end.place
        related = ((self.seen_node.place, "this is what was observed"),)
        return Difference(
            status,
            self.kind,
            name,
            self.node.name,
            message,
            help,
            place,
            expected,
            observed,
            related,
            seen,
            doubtful,
        )


def _is_made_at_the_start(end: Endpoint) -> bool:
    context = end.creation.context
    return (
        certain(end)
        and not named_by_library(end)
        and not end.creation.guard
        and (context is None or context.role in _AT_THE_START)
    )


def may_be_compared(qos: Qos) -> bool:
    """Whether the source alone decides a profile."""
    return not qos.overridable and qos.parameter is None


def contradictions(expected: Qos, seen: Qos, kind: EntityKind) -> list[tuple[str, str]]:
    """The policies that cannot both be true, in words: ``(expected, seen)`` of each."""
    policies = []
    for policy in ("reliability", "durability", "liveliness"):
        here, there = getattr(expected, policy), getattr(seen, policy)
        decided = here not in (None, "system_default", "best_available", "unknown")
        if decided and there is not None and here != there:
            noun = " liveliness" if policy == "liveliness" else ""
            policies.append((f"{here.replace('_', ' ')}{noun}", f"{there.replace('_', ' ')}{noun}"))
    durations = {"deadline": "deadline", "liveliness_lease": "liveliness lease"}
    if kind == program.EntityKind.PUBLISHER:
        durations["lifespan"] = "lifespan"
    for policy, words in durations.items():
        here, there = getattr(expected, policy) or 0.0, getattr(seen, policy) or 0.0
        if policy not in expected.unknown_durations and abs(here - there) > _TOLERANCE_S:
            policies.append((_bound(words, here), _bound(words, there)))
    return policies


def _bound(words: str, seconds: float) -> str:
    return f"with a {words} of {seconds:g} s" if seconds else f"without {words}"
