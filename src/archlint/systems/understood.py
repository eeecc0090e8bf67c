"""Launched nodes that were not understood: a launch file names much that their code does not seem to have.

One remapping that meets nothing is a mistake of the launch file.  When all of several do, or all parameters of a node
that creates nothing, it is more likely that what the node does was not seen: the code reads it from data, or makes it
in a way that is not followed.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.systems.instances import instantiate

if TYPE_CHECKING:
    from archlint.launch.started import Started
    from archlint.systems.nodes import Node
    from archlint.systems.overrides import Setting

SEVERAL = 2
"""How many remappings of a process without any endpoint are no coincidence."""
MANY = 4
"""How many, where it has endpoints and none of them is remapped."""
SETTINGS = 3
"""How many parameters of a node that creates and declares nothing."""


def doubt(started: Started, nodes: Sequence[Node], settings: Sequence[Setting]) -> str | None:
    """Why the nodes of a process that is here were perhaps not understood; None where nothing says so."""
    remaps = [remap for remap in started.remaps if not remap.group and remap.source.text != remap.target.text]
    created = any(node.endpoints for node in nodes)
    if len(remaps) >= (MANY if created else SEVERAL) and not any(_is_remapped(node, started) for node in nodes):
        return f"none of its {len(remaps)} remappings matches a name in its code"
    own = [setting for setting in settings if not setting.shared]
    declared = any(node.parameters for node in nodes)
    if len(own) >= SETTINGS and not created and not declared:
        return f"{len(own)} parameters are set, but its code does not seem to declare or create anything"
    return None


def _is_remapped(node: Node, started: Started) -> bool:
    if node.blueprint is None:
        return False
    plain = instantiate(node.blueprint, node.program, name=started.name, namespace=started.namespace)
    return sorted(e.name or "" for e in plain.endpoints) != sorted(e.name or "" for e in node.endpoints)
