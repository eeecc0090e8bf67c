"""Entries of the file that a bridge between ROS and Gazebo reads, and of which it makes no bridge.

Source: ros_gz_bridge, ``parseEntry`` of ``bridge_config.cpp``, which leaves an entry out that lacks a type or has a
direction it does not know; for a pair of types ``get_factory``, as for arguments.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.launch_files.refused_bridges import RefusedBridge, refused_pair
from archlint.place import Place
from archlint.suggestions import nearest
from archlint.syntax.bridge_files import BridgeEntry, bridge_entries

if TYPE_CHECKING:
    from archlint.systems.model import System

_SIMULATORS = ("gz", "ign")
_WAYS = ("GZ_TO_ROS", "ROS_TO_GZ", "BIDIRECTIONAL")
_OLD_WAYS = ("IGN_TO_ROS", "ROS_TO_IGN")
"""What the bridge of Ignition says for the first two."""


def refused_entries(system: System) -> Iterator[RefusedBridge]:
    """All such entries of the files that a launch file gives to bridges."""
    workspace, launched = system.workspace, system.launched
    if workspace is None or launched is None:
        return
    for file in dict.fromkeys(started.bridge_file for started in launched.started if started.bridge_file is not None):
        for entry in bridge_entries(workspace.tree.text(file) or ""):
            if not any("service" in key or "req_type" in key for key in entry.texts):
                yield from _refused(file, entry)


def _refused(file: str, entry: BridgeEntry) -> Iterator[RefusedBridge]:
    """The first thing that is wrong with an entry."""
    texts = entry.texts
    simulator = next((name for name in _SIMULATORS if any(key.startswith(f"{name}_") for key in texts)), "gz")
    ros_key, gz_key, own_key = "ros_type_name", f"{simulator}_type_name", f"{simulator}_topic_name"
    name = texts.get("ros_topic_name") or texts.get("topic_name") or texts.get(own_key)
    if not name:
        return
    whole = Place(file, *entry.span)
    for key in (ros_key, gz_key):
        if not texts.get(key):
            yield RefusedBridge(whole, name, f"it has no {key}", help=f"add {key} to this entry")
            return
    way = texts.get("direction")
    if way is not None and way not in (*_WAYS, *_OLD_WAYS):
        right = nearest(way.upper(), _WAYS)
        help = f"write {right}" if right is not None else "write GZ_TO_ROS, ROS_TO_GZ or BIDIRECTIONAL"
        yield RefusedBridge(Place(file, *entry.spans["direction"]), name, f"'{way}' is no direction", help=help)
        return
    pair = refused_pair(Place(file, *entry.spans[gz_key]), texts[ros_key], texts[gz_key])
    if pair is not None:
        key = ros_key if "/" in pair.instead else gz_key
        yield replace(pair, argument=name, place=Place(file, *entry.spans[key]), instead=f"{key}: {pair.instead}")


__all__ = ["refused_entries"]
