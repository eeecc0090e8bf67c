"""The controllers that a controller manager in Gazebo knows, by what the descriptions of robots say.

Source: the plugins of gz_ros2_control and gazebo_ros2_control start a controller manager in the simulator, with the
parameter files that their ``<parameters>`` name.
"""

from __future__ import annotations

import posixpath
import re
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_aside
from archlint.analysis.kept import once
from archlint.launch_files.plugin_parameters import controllers_of
from archlint.launch_files.unloaded_parameter_files import parameter_files
from archlint.place import Place
from archlint.records import dataclass
from archlint.workspace.comments import blank_xml_comments

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_ENDINGS = (".urdf", ".xacro", ".sdf", ".world", ".gazebo")
_PLUGIN = re.compile(r"<plugin\b[^>]*\b(?:gz|ign|gazebo)_ros2_control\b[^>]*>.*?</plugin>", re.DOTALL)
_PARAMETERS = re.compile(r"<parameters>(.*?)</parameters>", re.DOTALL)
_FOUND = re.compile(r"\$\(find(?:-pkg-share)?\s+([\w-]+)\)/?([\w./-]+)")


@dataclass(frozen=True)
class SimulatedManager:
    """The controllers that the parameter files of a workspace give a type, one of which a description names at
    ``place``."""

    place: Place
    known: frozenset[str]


@once
def simulated_manager(workspace: WorkspaceIndex) -> SimulatedManager | None:
    """What there is to know of it; None where it may get other files, or there is none."""
    places: list[Place] = []
    for folder in sorted(workspace.manifests):
        for file in workspace.tree.files_below(folder):
            if file.endswith(_ENDINGS) and not is_aside(workspace, file):
                named = _named_files(workspace, file)
                if named is None:
                    return None
                places += named
    known = {name for _, facts in parameter_files(workspace) for name in controllers_of(facts)}
    return SimulatedManager(places[0], frozenset(known)) if places and known else None


def _named_files(workspace: WorkspaceIndex, file: str) -> list[Place] | None:
    """Where a description names parameter files; None where one of them is not a file of the workspace."""
    text = workspace.tree.text(file) or ""
    if "ros2_control" not in text:
        return []
    said = blank_xml_comments(text)
    places = []
    for plugin in _PLUGIN.finditer(said):
        parameters = [*_PARAMETERS.finditer(plugin[0])]
        for named in parameters:
            path = _FOUND.fullmatch(named[1].strip())
            package = None if path is None else workspace.packages.get(path[1])
            if path is None or package is None:
                return None
            if not workspace.tree.is_file(posixpath.normpath(posixpath.join(package.relative, path[2]))):
                return None
            line = said.count("\n", 0, plugin.start() + named.start()) + 1
            places.append(Place(file, line, 1, line, 1))
        if not parameters:
            return None
    return places


@once
def words_of_yaml(workspace: WorkspaceIndex) -> frozenset[str]:
    """All words in the YAML files of the workspace, in which a controller may get its type in a way of its own."""
    tree = workspace.tree
    files = (file for file in tree.files_below(tree.top) if file.endswith((".yaml", ".yml")))
    return frozenset(word for file in files for word in re.findall(r"[\w-]+", tree.text(file) or ""))


__all__ = ["SimulatedManager", "simulated_manager", "words_of_yaml"]
