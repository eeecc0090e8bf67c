"""Which nodes, topics, services and actions a view shows: a function of names and of who is tied to what."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fnmatch import fnmatchcase
from typing import TYPE_CHECKING

from archlint.records import dataclass
from archlint.ros.well_known import OF_RCLPY
from archlint.suggestions import name_meant
from archlint.systems.graph import ACTION, NODE, SERVICE, Key

if TYPE_CHECKING:
    from archlint.render.view import View

BY_DEFAULT = (
    *OF_RCLPY,
    "*/describe_parameters",
    "*/get_parameter_types",
    "*/get_parameters",
    "*/list_parameters",
    "*/set_parameters",
    "*/set_parameters_atomically",
)
"""What every node has, and what is hidden unless somebody names it."""


class NothingOfThatName(Exception):
    """A name of a view that nothing in the system has; the message is for the user."""


@dataclass(frozen=True)
class Network:
    """Who is tied to what: nodes to the topics, services and actions that they have, in both directions.

    ``matched`` are the interfaces with somebody at both ends.
    """

    ties: Mapping[Key, Sequence[Key]]
    matched: frozenset[Key]


def selected(network: Network, view: View) -> frozenset[Key]:
    """What is to be shown.  Raises :class:`NothingOfThatName`."""
    shown = frozenset(network.ties)
    if not view.everything:
        named = [*view.focus, *view.only]
        hidden = [pattern for pattern in BY_DEFAULT if not any(_means(name, pattern) for name in named)]
        shown -= _hidden(network, _matching(network, hidden, exactly=True))
    if view.style == "topics":
        shown -= {key for key in shown if key[0] in (SERVICE, ACTION)}
    if view.only:
        shown &= _with_ends(network, _found(network, view.only))
    if view.focus:
        shown &= _near(network, _found(network, view.focus), view.depth)
    if view.hide:
        shown -= _hidden(network, _matching(network, view.hide))
    if view.matched:
        shown -= {key for key in shown if key[0] != NODE and key not in network.matched}
    return shown


def _means(name: str, pattern: str) -> bool:
    return fnmatchcase(name, pattern) or fnmatchcase(f"/{name}", pattern)


def _found(network: Network, names: Iterable[str]) -> frozenset[Key]:
    keys: set[Key] = set()
    for name in names:
        matching = _matching(network, [name])
        if not matching:
            known = [key[1] for key in network.ties]
            raise NothingOfThatName(f"nothing here is called {name}{name_meant(name, known)}")
        keys |= matching
    return frozenset(keys)


def _matching(network: Network, patterns: Sequence[str], exactly: bool = False) -> frozenset[Key]:
    """What has a name of one of the patterns; without a slash in front they are for names with one, too."""
    every = patterns if exactly else [*patterns, *(f"/{pattern}" for pattern in patterns if pattern[:1] != "/")]
    return frozenset(key for key in network.ties if any(fnmatchcase(key[1], pattern) for pattern in every))


def _hidden(network: Network, hidden: frozenset[Key]) -> frozenset[Key]:
    """What is hidden, and the topics, services and actions that only hidden nodes have."""
    orphans = {
        key for key, around in network.ties.items() if key[0] != NODE and around and all(k in hidden for k in around)
    }
    return hidden | orphans


def _with_ends(network: Network, keys: frozenset[Key]) -> frozenset[Key]:
    return keys | {other for key in keys for other in network.ties[key]}


def _near(network: Network, start: frozenset[Key], depth: int) -> frozenset[Key]:
    """What can be reached over at most ``depth`` nodes, the start not counted."""
    near = set(start)
    edge = start
    for step in range(2 * depth):
        if step == 2 * depth - 1:
            edge = frozenset(key for key in edge if key[0] != NODE)  # the last step leads to nodes
        edge = frozenset(other for key in edge for other in network.ties[key]) - near
        near |= edge
    return frozenset(near)


__all__ = ["BY_DEFAULT", "Network", "NothingOfThatName", "selected"]
