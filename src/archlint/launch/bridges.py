"""Bridges to a simulator that read what they bridge in a file of the workspace."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter.values import Known
from archlint.launch.kinds import FileKind
from archlint.launch.parameter_sources import ParameterSetting
from archlint.launch.started import Bridged
from archlint.syntax.bridge_files import read_bridges

if TYPE_CHECKING:
    from archlint.launch.run import LaunchRun
    from archlint.launch.started import Started

_PACKAGES = ("ros_gz_bridge", "ros_ign_bridge")
_PROGRAMS = ("parameter_bridge", "bridge_node", "ros_gz_bridge::RosGzBridge")
FILE = "config_file"
"""The parameter that names the file."""


def bridged_in_file(run: LaunchRun, started: Started) -> tuple[Bridged, ...] | None:
    """What the file of a bridge says, which is noted; None for one that reads none, and where the file is not known."""
    if started.package.text not in _PACKAGES or started.executable.text not in _PROGRAMS:
        return None
    path = _path(started)
    reference = None if path is None else run.resolve(FileKind.OTHER, Known(path), started.place)
    started.bridge_file = None if reference is None else reference.source
    text = None if reference is None else run.paths.text(reference)
    rows = None if text is None else read_bridges(text)
    return None if rows is None else tuple(Bridged(*row) for row in rows)


def _path(started: Started) -> str | None:
    """The path that the last of the parameters sets, behind those of the command line."""
    settings = [row for row in started.parameters if isinstance(row, ParameterSetting) and row.name == FILE]
    if settings:
        return settings[-1].value if isinstance(settings[-1].value, str) else None
    words = [*started.arguments, "--ros-args", *started.ros_arguments]
    paths = [word.partition(":=")[2] for word in words if word is not None and word.startswith(f"{FILE}:=")]
    return paths[-1] if paths else None


__all__ = ["FILE", "bridged_in_file"]
