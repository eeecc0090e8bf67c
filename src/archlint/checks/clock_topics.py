"""TOP008: clocks that nobody hears, and nodes that wait for a clock."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.coexistence import certain, in_source_order
from archlint.analysis.kept import once
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.checks.sight import is_complete
from archlint.finding import Finding, Related
from archlint.launch_files.set_parameters import set_nodes
from archlint.model import EntityKind

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.systems.model import System
    from archlint.systems.nodes import Endpoint, Node

_TYPE = "rosgraph_msgs/msg/Clock"
_CLOCK = "/clock"
_SIMULATED = "use_sim_time"


@rule("TOP008", scope=Scope.SYSTEM)
def clock_topic(system: System, options: Options) -> Iterator[Finding]:
    """Publishers of a clock on another topic, and nodes of a closed system that wait for a clock nobody publishes."""
    for connection in system.topics.values():
        ends = in_source_order(
            [end for end in connection.providers if end.type == _TYPE and certain(end) and not end.external]
        )
        heard = [end for end in ends if end.place in _places_of_clocks(system)]
        if ends and not heard and not connection.users and _is_elsewhere(system, options, connection.name):
            yield _elsewhere(ends[0])
    waiting = sorted(_waiting(system), key=lambda row: row[1])
    if waiting and is_complete(system) and not options.is_external(_CLOCK) and not _has_clock(system):
        yield _nobody(waiting)


@once
def _places_of_clocks(system: System) -> frozenset[Place]:
    """Where the publishers are created that a launch file of the workspace gives the right name, for a system that none
    starts."""
    systems = [] if system.workspace is None or system.launched is not None else system.workspace.systems
    clocks = (other.topics[_CLOCK] for other in systems if other.launched is not None and _CLOCK in other.topics)
    return frozenset(end.place for clock in clocks for end in clock.providers)


def _is_elsewhere(system: System, options: Options, name: str) -> bool:
    """Whether nothing in sight makes a topic the one that nodes take their time from: no remap rule for a clock."""
    return name != _CLOCK and not options.is_external(name) and not _remaps_clock(system)


def _remaps_clock(system: System) -> bool:
    remaps = (remap for node in system.nodes if node.started is not None for remap in node.started.remaps)
    rules = (rule for node in system.nodes for rule in node.rules)
    sources = [*(remap.source.text for remap in remaps), *(rule.match for rule in rules)]
    return any(source is None or source.lstrip("/") == _CLOCK.lstrip("/") for source in sources)


def _elsewhere(end: Endpoint) -> Finding:
    return finding(
        "TOP008",
        end.place,
        f"{end.node.shown} publishes a clock on '{end.name}', and nodes with use_sim_time listen to '{_CLOCK}'",
        help=f"publish it on '{_CLOCK}'",
        node=end.node.name,
        identity=(end.name or "",),
    )


def _waiting(system: System) -> Iterator[tuple[Node, Place]]:
    """The nodes that take their time from a clock, and where they are told to."""
    for node, settings in set_nodes(system):
        for setting in settings:
            if setting.name == _SIMULATED and setting.value is True and node.condition is None:
                yield node, setting.value_place or setting.place


def _has_clock(system: System) -> bool:
    """Whether something publishes the clock, or may do so under a name that is not known."""
    return any(
        end.type in (_TYPE, None) and (not end.resolved or end.name == _CLOCK or end.type == _TYPE)
        for end in system.all_endpoints
        if end.kind == EntityKind.PUBLISHER
    )


def _nobody(waiting: list[tuple[Node, Place]]) -> Finding:
    (node, place), *others = waiting
    also = "" if not others else f", as {len(others)} other{'s do' if len(others) > 1 else ' does'}"
    return finding(
        "TOP008",
        place,
        f"{node.shown} takes its time from '{_CLOCK}'{also}, and no node publishes that: its time stays 0, and its "
        "timers never fire",
        help=f"start what publishes '{_CLOCK}', or leave out {_SIMULATED}",
        related=[Related(other, f"{row.shown} does, too") for row, other in others if other != place],
        node=node.name,
        identity=(_CLOCK,),
    )
