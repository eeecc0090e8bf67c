"""The packages of the plugins that ros2_control loads: the types of controllers in parameter files, and what the
descriptions of robots name.

Source: pluginlib looks a class up in the packages that are installed; the type of a class of ros2_controllers and the
like begins with the name of its package.  Gazebo looks for a library.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_aside
from archlint.analysis.kept import once
from archlint.launch_files.plugin_parameters import controllers_of
from archlint.launch_files.unloaded_parameter_files import is_named, parameter_files
from archlint.place import Place
from archlint.ros import packages
from archlint.workspace.comments import blank, blank_xml_comments, xml_comments

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_DESCRIPTIONS = (".urdf", ".xacro")
_UNDER_CONDITION = re.compile(r"<xacro:(if|unless)\b(?:(?!<xacro:(?:if|unless)\b).)*?</xacro:\1>", re.DOTALL)
_PLUGIN = re.compile(r"<plugin>\s*(\w+(?:/|::)\w+)\s*</plugin>|<plugin\b[^>]*\bfilename=[\"'](?:lib)?([\w-]+)")
_LIBRARIES = {
    "gazebo_ros2_control": "gazebo_ros2_control",
    "gz_ros2_control-system": "gz_ros2_control",
    "ign_ros2_control-system": "ign_ros2_control",
}
"""The packages of libraries that Gazebo loads, by their names without ``lib`` and an ending."""
_PREFIXES = {
    "mock_components": "hardware_interface",
    "fake_components": "hardware_interface",
    "parallel_gripper_action_controller": "parallel_gripper_controller",
}
"""The packages whose classes do not begin with their names."""
_OF_GROUPS = frozenset({"effort_controllers", "position_controllers", "velocity_controllers"})
"""Packages of which only the controllers of a group of joints are; those of grippers come with gripper_controllers."""


def packages_of_plugins(workspace: WorkspaceIndex) -> Iterator[tuple[Place, str]]:
    """The released packages of such plugins, each with the place that names one, but for those that a comment in a
    manifest names."""
    for place, named in (*_of_controllers(workspace), *_of_descriptions(workspace)):
        package = _package_of(named)
        is_released = package in packages.table().names and package not in workspace.packages
        if is_released and package not in _words_of_comments(workspace):
            yield place, package


@once
def _words_of_comments(workspace: WorkspaceIndex) -> frozenset[str]:
    """The words in the comments of all manifests: MoveIt's assistant writes what only a simulation needs into one."""
    texts = (workspace.tree.text(package.manifest.relative) or "" for package in workspace.manifests.values())
    comments = (comment for text in texts for comment in xml_comments(text))
    return frozenset(word for comment in comments for word in re.findall(r"\w+", comment))


def _package_of(named: str) -> str:
    """The package that has a class, or an own library; empty where that is not known."""
    prefix, *rest = re.split("/|::", named)
    if rest == ["GripperActionController"] and prefix in _OF_GROUPS:
        return "gripper_controllers"
    if rest and prefix in _OF_GROUPS:
        return prefix if rest[0].startswith("JointGroup") else ""
    return _PREFIXES.get(prefix, prefix)


def _of_controllers(workspace: WorkspaceIndex) -> Iterator[tuple[Place, str]]:
    for file, facts in parameter_files(workspace):
        types = frozenset(controllers_of(facts).values())
        if not types or not _is_installed(workspace, file) or not is_named(workspace, file):
            continue
        for section in facts.sections:
            for entry in section.entries:
                if entry.path[-1] == "type" and entry.value in types:
                    yield Place(file, *entry.span), str(entry.value)


def _is_installed(workspace: WorkspaceIndex, file: str) -> bool:
    installs = workspace.installs.get(workspace.package_of(file) or "")
    return installs is not None and any(True for _ in installs.places_of(file))


def _of_descriptions(workspace: WorkspaceIndex) -> Iterator[tuple[Place, str]]:
    for file in _descriptions(workspace):
        text = workspace.tree.text(file) or ""
        said = blank_xml_comments(text)
        while (without := _UNDER_CONDITION.sub(lambda block: blank(block[0]), said)) != said:
            said = without
        said = _MACRO.sub(lambda macro: macro[0] if _is_called(workspace, macro[2]) else blank(macro[0]), said)
        for plugin in _PLUGIN.finditer(said):
            named = plugin[1] or _LIBRARIES.get(plugin[2])
            if named is not None and is_named(workspace, file):
                line = said.count("\n", 0, plugin.start()) + 1
                yield Place(file, line, 1, line, 1), named


_MACRO = re.compile(r"<xacro:macro\b[^>]*?\bname=([\"'])(?:xacro:)?([\w.-]+)\1.*?</xacro:macro>", re.DOTALL)
_CALL = re.compile(r"<xacro:([\w.-]+)")
_CALL_BY_NAME = "call"
"""``<xacro:call macro="${name}"/>`` may mean any macro."""


def _is_called(workspace: WorkspaceIndex, macro: str) -> bool:
    """Whether some description of the workspace calls a macro: what is in it is not there otherwise."""
    return not {macro, _CALL_BY_NAME}.isdisjoint(_called(workspace))


@once
def _called(workspace: WorkspaceIndex) -> frozenset[str]:
    files = (file for file in workspace.tree.files_below(workspace.tree.top) if file.endswith(_DESCRIPTIONS))
    texts = (blank_xml_comments(workspace.tree.text(file) or "") for file in files)
    return frozenset(name for text in texts for name in _CALL.findall(text))


@once
def _descriptions(workspace: WorkspaceIndex) -> list[str]:
    """The descriptions of robots that are installed and load a plugin."""
    files = [file for folder in sorted(workspace.manifests) for file in workspace.tree.files_below(folder)]
    return [
        file
        for file in dict.fromkeys(files)
        if file.endswith(_DESCRIPTIONS)
        and not is_aside(workspace, file)
        and "<plugin" in (workspace.tree.text(file) or "")
        and _is_installed(workspace, file)
    ]


__all__ = ["packages_of_plugins"]
