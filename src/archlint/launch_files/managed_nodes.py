"""The nodes that the lifecycle managers of a launch know by their names."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.launch.parameter_sources import ParameterSetting, files_among

if TYPE_CHECKING:
    from archlint.launch.model import Launched
    from archlint.systems.model import WorkspaceIndex

_WORD = re.compile(r"[\w/]+")
NODE_NAMES = "node_names"
"""The parameter in which nav2_lifecycle_manager gets the names of its nodes."""


def managed_nodes(workspace: WorkspaceIndex, launched: Launched) -> frozenset[str]:
    """The names, without namespaces, that a lifecycle manager of a launch is given, be it in the launch file or in a
    parameter file."""
    return frozenset(
        name.rpartition("/")[2] for value in _lists(workspace, launched) for name in _WORD.findall(str(value))
    )


def _lists(workspace: WorkspaceIndex, launched: Launched) -> Iterator[object]:
    for started in launched.started:
        for setting in started.parameters:
            if isinstance(setting, ParameterSetting) and setting.name == NODE_NAMES:
                yield setting.value
        for use in files_among(started.parameters):
            sections = () if use.reference.source is None else workspace.parameters_of(use.reference.source).sections
            yield from (entry.value for section in sections for entry in section.entries if entry.name == NODE_NAMES)
