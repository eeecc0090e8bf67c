"""A system held against what a running one says of itself.

Nothing is said of what the source leaves open: a name that is known in part, a node whose code was not all followed,
what only a branch or a callback creates.  History and depth are not compared, for they do not go over the network.
What ROS makes for every node is no difference, nor are the nodes and names that its tools hide.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence, Set
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.comparable import is_complete_node, place_of, what_is_compared
from archlint.analysis.comparison_of_ends import Ends, ends_of
from archlint.analysis.comparison_of_topics import topics_of
from archlint.launch.kinds import StartedKind
from archlint.observed.model import BAG, MISSING, UNEXPECTED, Comparison, Difference, Observed, SeenNode
from archlint.ros.names import is_hidden, pattern_matches
from archlint.suggestions import did_you_mean

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.systems.model import System
    from archlint.systems.nodes import Node

_OF_TOOLS = re.compile(r"/(launch_ros_\d+|rosbag2_recorder|(.*/)?transform_listener_impl_[0-9a-f]+)")
"""Nodes that launch and tf2 start for themselves, under a name that is new each time, and what records a bag."""

IsExternal = Callable[[str], bool]


def compare(
    system: System, observed: Observed, is_external: IsExternal = lambda name: False, context: Set[str] = frozenset()
) -> Comparison:
    """``is_external`` knows the names that the configuration says something outside provides; of what is written in
    ``context`` files, which were not asked for, no difference is reported."""
    if observed.form == BAG:
        comparison = topics_of(system, observed, is_external)
    else:
        comparison = _Comparing(system, observed, is_external).result()
    return replace(
        comparison,
        differences=tuple(difference for difference in comparison.differences if difference.place.file not in context),
    )


class _Comparing:
    """One comparison of nodes while it goes on."""

    def __init__(self, system: System, observed: Observed, is_external: IsExternal) -> None:
        self.system = system
        self.observed = observed
        self.is_external = is_external
        self.seen = {node.name: node for node in observed.nodes if not _is_of_tools(node.name)}
        self.expected: dict[str, list[Node]] = {}
        for node in system.nodes:
            if not node.test and node.name is not None and node.resolution in ("exact", "parameter"):
                self.expected.setdefault(node.name, []).append(node)
        self.left_open: list[str] = []

    def result(self) -> Comparison:
        differences: list[Difference] = []
        nodes = ends = 0
        for name, seen in sorted(self.seen.items()):
            candidates = self.expected.get(name, [])
            if not candidates:
                differences += self._unexpected(seen)
                continue
            nodes += 1
            differences += self._too_many(seen, candidates)
            compared = self._ends(seen, candidates)
            differences += compared.differences
            ends += compared.same
            self.left_open += compared.left_open
        for name, candidates in sorted(self.expected.items()):
            if name not in self.seen:
                differences += self._missing(name, candidates)
        return Comparison(
            self.observed,
            what_is_compared(self.system),
            tuple(differences),
            nodes,
            ends,
            tuple(self.left_open),
            tuple(self._notes()),
        )

    def _notes(self) -> Iterator[str]:
        if not self.observed.settled:
            file = self.observed.file
            yield f"{file}: nodes were still starting when the recording ended; missing ones may only be late"

    def _ends(self, seen: SeenNode, candidates: Sequence[Node]) -> Ends:
        """Of several nodes that could be meant, the comparison that leaves the fewest differences."""
        every = [
            ends_of(self.system, node, seen, self.observed, is_complete_node(self.system, node)) for node in candidates
        ]
        return min(every, key=lambda ends: (len(ends.differences), -ends.same))

    # ------------------------------------------------------------------------------------------------------- missing

    def _missing(self, name: str, candidates: Sequence[Node]) -> Iterator[Difference]:
        node = candidates[0]
        if is_hidden(name) or not any(map(_is_started, candidates)) or self.is_external(name):
            return
        launched = self.system.launched is not None or self.system.closed
        where = f"{self.system.name} starts it" if self.system.launched is not None else "the source has it"
        running = [other for other in self.seen if other not in self.expected]
        moved = [other for other in running if other.rpartition("/")[2] == name.rpartition("/")[2]]
        near = (
            f"; {moved[0]} runs: is that the same node in another namespace?" if moved else did_you_mean(name, running)
        )
        yield Difference(
            MISSING,
            "node",
            name,
            name,
            f"{name} does not run, and {where}{near}",
            "check its log for why it ended, and record again when it runs"
            if launched
            else "use --launch to say which launch file started the running system",
            place_of(node),
            expected=name,
            related=_class_of(node),
            doubtful=not launched,
        )

    # ---------------------------------------------------------------------------------------------------- unexpected

    def _unexpected(self, seen: SeenNode) -> Iterator[Difference]:
        if self.is_external(seen.name):
            return
        why = self._may_be(seen.name)
        if why is not None:
            self.left_open.append(f"{seen.name} runs; {why}")
            return
        launched = self.system.launched is not None
        who = f"{self.system.name} does not start it" if launched else "no node here has this name"
        missing = [name for name in self.expected if name not in self.seen]
        yield Difference(
            UNEXPECTED,
            "node",
            seen.name,
            seen.name,
            f"{seen.name} runs, and {who}{did_you_mean(seen.name, missing)}",
            "stop it, or list its name under `external` in the configuration if it belongs there",
            seen.place,
            observed=seen.name,
            seen=seen,
            doubtful=not launched,
        )

    def _may_be(self, name: str) -> str | None:
        """Why a running node that no known one is called may still belong to the system; None if nothing says so."""
        for node in self.system.nodes:
            if node.name is None and not node.test:
                return f"{_called(node)} has a name that is not known"
            if node.resolution == "partial" and node.name is not None and pattern_matches(node.name, name):
                return f"it may be {node.name}"
        launched = self.system.launched
        if launched is None:
            return None
        for gap in launched.not_followed():
            return f"{gap.place.file}:{gap.place.line} may start it: {gap.reason}"
        for started in launched.started:
            if started.kind == StartedKind.PROCESS and not started.dormant:
                return f"the process that {started.place.file}:{started.place.line} starts may be it"
        return None

    def _too_many(self, seen: SeenNode, candidates: Sequence[Node]) -> Iterator[Difference]:
        if seen.count <= len(candidates):
            return
        yield Difference(
            UNEXPECTED,
            "node",
            seen.name,
            seen.name,
            f"{seen.count} nodes with the name {seen.name} run, but the source has "
            f"{'one' if len(candidates) == 1 else len(candidates)} of that name",
            "look for a leftover process of an earlier run, and stop it",
            place_of(candidates[0]),
            expected=str(len(candidates)),
            observed=str(seen.count),
            doubtful=self.system.launched is None,
        )


def _is_of_tools(name: str) -> bool:
    return is_hidden(name) or _OF_TOOLS.fullmatch(name) is not None


def _is_started(node: Node) -> bool:
    """Whether nothing but its own failure keeps a node from running."""
    if node.condition is not None or node.alternatives or node.error is not None or node.unfollowed is not None:
        return False
    return all(
        not blueprint.branch_arms and blueprint.until is None and not blueprint.caller_unknown
        for blueprint in node.blueprints
    )


def _class_of(node: Node) -> tuple[tuple[Place, str], ...]:
    if node.launch_place is None or node.blueprint is None:
        return ()
    return ((node.blueprint.place, "it is written here"),)


def _called(node: Node) -> str:
    if node.blueprint is not None:
        return node.blueprint.class_name
    return f"{node.package}/{node.executable}"
