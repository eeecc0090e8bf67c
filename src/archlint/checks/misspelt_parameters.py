"""What PRM004 says of names that are almost that of a parameter which every node has, and which of others it leaves to
other findings."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import lru_cache
from typing import TYPE_CHECKING, Final

from archlint.analysis.declared_parameters import declared_by
from archlint.checks.parameter_reads import undeclared_reads
from archlint.checks.registry import finding
from archlint.finding import Finding
from archlint.suggestions import distance, nearest
from archlint.systems.overrides import settings_of

if TYPE_CHECKING:
    from archlint.launch.started import Started
    from archlint.systems.model import System
    from archlint.systems.nodes import Node

_OF_EVERY_NODE: Final = "use_sim_time"
"""The one parameter that every node has, of C++ or of Python, and that is set from outside."""
MISSPELT: Final = "misspelt"
"""The group of what a node does not declare and that is almost the name of something it declares."""
_SLIP = 2
"""By how many letters a name may differ from it, without being another one."""


@lru_cache(maxsize=10_000)
def is_misspelt(name: str) -> bool:
    """Whether a name is almost that of the parameter."""
    return name != _OF_EVERY_NODE and distance(name, _OF_EVERY_NODE, _SLIP) <= _SLIP


def misspelt_section(name: str, declared: Iterable[str]) -> tuple[str, str] | None:
    """The section of a dotted name, and that of a declared one which is near and has the same parameter."""
    section, _, last = name.rpartition(".")
    sections = (other.rpartition(".")[0] for other in declared if other.rpartition(".")[2] == last)
    near = nearest(section, filter(None, sections)) if section else None
    return None if near is None else (section, near)


def is_told_otherwise(system: System, node: Node, name: str) -> bool:
    """Whether another finding is about a name that a node does not declare: it is misspelt for every node, or the node
    reads it all the same, and a declaration mends both (PRM003)."""
    return is_misspelt(name) or any(name == read for _, read, _ in undeclared_reads(system, node))


def misspelt_for_every_node(system: System) -> Iterator[Finding]:
    """Settings of ``use_sime_time`` and the like, whether the source of the node is here or not."""
    if system.launched is None or system.workspace is None:
        return
    seen = set()
    for started in system.launched.started:
        for setting in settings_of(started, system.workspace.parameters_of):
            name = setting.name
            if not is_misspelt(name):
                continue
            if (setting.place, name) in seen or _is_declared(system, started, name):
                continue
            seen.add((setting.place, name))
            yield finding(
                "PRM004",
                setting.place,
                f"no node has a parameter '{name}'; did you mean '{_OF_EVERY_NODE}', which every node has?",
                help=f"write '{_OF_EVERY_NODE}': until then the node goes by the time of the machine",
                identity=(setting.key, name),
                group=("no node has", name),
                meant=_OF_EVERY_NODE,
            )


def _is_declared(system: System, started: Started, name: str) -> bool:
    """Whether a node of the process whose source is here declares the name itself, or may."""
    nodes = [node for node in system.entries if node.started is started and not node.external]
    return any((declared := declared_by(node)) is None or name in declared for node in nodes)


__all__ = ["MISSPELT", "is_misspelt", "is_told_otherwise", "misspelt_for_every_node", "misspelt_section"]
