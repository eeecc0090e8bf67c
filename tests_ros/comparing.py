"""Holds what archlint says of nodes (``graph --format json --all``) against what running ones are, entity by entity."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field
from fnmatch import fnmatchcase
from typing import Any

from tests_ros.reading import Entity
from tests_ros.running import Observed

ENDS = ("publishers", "subscribers", "services", "clients", "action_servers", "action_clients")
SAID = ("exact", "parameter")
"""Resolutions with one name: it must be the running one's."""

OF_EVERY_NODE = {"use_sim_time", "start_type_description_service"}
"""Parameters that rclpy declares for every node."""


@dataclass
class Comparison:
    """What came of one comparison.

    ``compared``, by kind: nodes, endpoints, timers and parameters that both sides have, with all that is known equal;
    ``left_open``: running ones that archlint lists without a name (a pattern, or unknown); ``never_ran``: what archlint
    lists at a line that this run did not come to; ``differences``: everything else, a sentence each.
    """

    compared: Counter[str] = field(default_factory=Counter)
    left_open: int = 0
    never_ran: list[str] = field(default_factory=list)
    differences: list[str] = field(default_factory=list)


def compare(nodes: list[Entity], observed: Observed) -> Comparison:
    """Holds ``nodes`` of archlint's graph, with files relative to the root of the run, against what was observed."""
    result = Comparison()
    for name in sorted(observed.nodes):
        candidates = [node for node in nodes if node["name"] == name] or [
            node for node in nodes if may_be(node["name"], name)
        ]
        if not candidates:
            result.differences.append(f"{name} runs, and is not in the graph")
            continue
        result.compared["nodes"] += 1
        _compare_node(name, candidates, observed, result)
    for node in nodes:
        if not any(may_be(node["name"], name) for name in observed.nodes):
            _never_run(node, observed, result)
    _from_outside(observed, result)
    return result


def may_be(pattern: str | None, name: str) -> bool:
    """Whether a name that archlint gives, with ``*`` where it is not known, is that of a running entity."""
    return pattern is None or fnmatchcase(name, pattern)


def _compare_node(name: str, nodes: list[Entity], observed: Observed, result: Comparison) -> None:
    running, outside = observed.nodes[name], (observed.graph or {}).get(name, {})
    for kind in ENDS:
        listed = [end for node in nodes for end in node[kind] if "/_action/" not in (end["name"] or "")]
        seen = [tuple(end[:2]) for end in running[kind]]
        seen += [one for one in dict.fromkeys(tuple(end[:2]) for end in outside.get(kind, [])) if one not in seen]
        profiles = {(one, type_): [q for n, t, q in running[kind] if (n, t) == (one, type_)] for one, type_ in seen}
        for (one, type_), count in sorted(Counter(seen).items()):
            if "/_action/" not in one:
                what = f"{name}: {kind[:-1]} {one} {type_}"
                _compare_end(kind, what, one, type_, count, profiles[one, type_], listed, result)
        for end in listed:
            there = any(may_be(end["name"], one) and may_be(end["type"], type_) for one, type_ in seen)
            if not there and end["error"]:
                result.compared[kind] += 1  # refused by both
            elif not there and not ((running["gone"] or observed.graph is None) and end["name"] in _by_rcl(name)):
                _not_there(f"{name}: {kind[:-1]} {end['name']} {end['type']}", end, observed, result)
    _compare_timers(name, [timer for node in nodes for timer in node["timers"]], running["timers"], observed, result)
    _compare_parameters(
        name, [one for node in nodes for one in node["parameters"]], running["parameters"], observed, result
    )


def _by_rcl(node: str) -> tuple[str, ...]:
    """What rcl makes for a node without rclpy's knowing: to be seen from outside only."""
    return "/rosout", f"{node}/get_type_description", f"{node}/transition_event"


def _compare_end(
    kind: str,
    what: str,
    name: str,
    type_: str,
    count: int,
    profiles: list[Entity | None],
    listed: list[Entity],
    result: Comparison,
) -> None:
    exact = [end for end in listed if end["name"] == name and end["type"] == type_ and end["resolution"] in SAID]
    if not exact:
        if any(_leaves_open(end, name, type_) for end in listed):
            result.left_open += count
        else:
            result.differences.append(f"{what} runs, and is not in the graph")
        return
    for profile in profiles or [None]:
        if profile is None or any(_same_qos(end["qos"], profile) for end in exact):
            result.compared[kind] += 1
        else:
            result.differences.append(f"{what} has {profile}, the graph says {[end['qos'] for end in exact]}")


def _leaves_open(said: Entity, name: str, type_: str) -> bool:
    """Whether an endpoint of the graph, of which something is not known, may be a running one."""
    if said["type"] is None:
        return may_be(said["name"], name)
    return said["type"] == type_ and said["resolution"] not in SAID and may_be(said["name"], name)


def _same_qos(said: Entity | None, profile: Entity) -> bool:
    """Whether all policies that archlint knows are the running ones."""
    return said is None or all(said.get(key) in (None, value) for key, value in profile.items())


def _not_there(what: str, entity: Entity, observed: Observed, result: Comparison) -> None:
    """Notes an entity of the graph that does not run: by right, if it may not, or if its line was not come to."""
    place = f"{entity['file']}:{entity['line']}"
    lines = range(entity["line"], entity.get("end_line", entity["line"]) + 1)
    ran = any((entity["file"], line) in observed.lines for line in lines)
    if entity["conditional"]:
        return
    if not ran:
        result.never_ran.append(f"{place} {what}")
    elif entity.get("resolution", "exact") in SAID:
        result.differences.append(f"{what} is in the graph ({place}), and does not run")


def _never_run(node: Entity, observed: Observed, result: Comparison) -> None:
    for kind in (*ENDS, "timers", "parameters"):
        for entity in node[kind]:
            if (entity["file"], entity["line"]) != (node["file"], node["line"]):
                what = f"{node['name']}: {kind[:-1]} {entity.get('name', entity.get('period_s'))}"
                ran = (entity["file"], entity["line"]) in observed.lines
                if entity["conditional"]:
                    continue
                if ran and node["name"] is not None and "*" not in node["name"]:
                    result.differences.append(f"{what} ran, under another node ({entity['file']}:{entity['line']})")
                else:
                    result.never_ran.append(f"{entity['file']}:{entity['line']} {what}")


def _compare_timers(
    name: str, listed: list[Entity], running: list[float], observed: Observed, result: Comparison
) -> None:
    known = Counter(_shown(timer["period_s"]) for timer in listed if timer["period_s"] is not None)
    unknown = sum(timer["period_s"] is None for timer in listed)
    for period, count in sorted(Counter(_shown(one) for one in running).items()):
        result.compared["timers"] += min(count, known[period])
        if count > known[period] and unknown:
            result.left_open += count - known[period]
        elif count > known[period]:
            result.differences.append(f"{name}: {count} timers of {period} s run, {known[period]} are in the graph")
    for timer in listed:
        if timer["period_s"] is not None and _shown(timer["period_s"]) not in [_shown(one) for one in running]:
            _not_there(f"{name}: timer {timer['period_s']}", timer, observed, result)


def _shown(period_s: float) -> float:
    """rclpy cuts a period off after the nanoseconds."""
    return round(period_s, 6)


def _compare_parameters(
    name: str, listed: list[Entity], running: list[list[Any]], observed: Observed, result: Comparison
) -> None:
    for parameter, type_, value in running:
        of_node = parameter in OF_EVERY_NODE or parameter.startswith("qos_overrides.")
        said = [one for one in listed if one["name"] == parameter]
        if not said:
            if any(one["name"] is None or may_be(one["name"], parameter) for one in listed):
                result.left_open += 1
            elif not of_node:
                result.differences.append(f"{name}: parameter {parameter} runs, and is not in the graph")
            continue
        if any(_same_parameter(one, type_.lower(), value) for one in said):
            result.compared["parameters"] += 1
        else:
            shown = [(one["type"], one["default"], one.get("override")) for one in said]
            result.differences.append(
                f"{name}: parameter {parameter} is {type_.lower()} {value!r}, the graph says {shown}"
            )
    names = [one[0] for one in running]
    for one in listed:
        if not any(may_be(one["name"], there) for there in names):
            _not_there(f"{name}: parameter {one['name']}", one, observed, result)


def _same_parameter(said: Entity, type_: str, value: Any) -> bool:
    wanted = said.get("override", said["default"])
    return said["type"] in (type_, None) and (wanted is None or wanted == value)


def _from_outside(observed: Observed, result: Comparison) -> None:
    """What a node has of itself must be what the others see of it, and a policy that goes over the wire the same."""
    for name, kinds in sorted(observed.nodes.items()):
        if kinds["gone"] or observed.graph is None:
            continue
        if name not in observed.graph:
            result.differences.append(f"{name} cannot be seen from outside")
            continue
        for kind in ENDS:
            outside = {tuple(end[:2]): end[2:] for end in observed.graph[name][kind]}
            for one, type_, profile in kinds[kind]:
                if (one, type_) not in outside:
                    result.differences.append(f"{name}: {kind[:-1]} {one} {type_} cannot be seen from outside")
                elif profile is not None and not _on_the_wire(profile, outside[one, type_]):
                    result.differences.append(
                        f"{name}: {kind[:-1]} {one} has {profile}, from outside {outside[one, type_]}"
                    )


def _on_the_wire(profile: Entity, seen: list[Any]) -> bool:
    asked = [one for profiles in seen for one in profiles]
    return not asked or any(
        all(profile[key] in (value, "system_default") for key, value in one.items()) for one in asked
    )
