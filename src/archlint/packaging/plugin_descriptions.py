"""Classes that a description of plugins names otherwise than the C++ code of its package registers them.

Source: ``PLUGINLIB_EXPORT_CLASS`` registers a class under the very text that it is given, and ``ClassLoader`` of
pluginlib asks the library for the ``type`` of the description: "MultiLibraryClassLoader: Could not create object".
"""

from __future__ import annotations

import html
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_aside
from archlint.analysis.cpp_nodes import CPP_SOURCES, without_cpp_comments
from archlint.place import Place
from archlint.records import dataclass
from archlint.suggestions import nearest
from archlint.workspace.comments import replace_xml_comments

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.installed import Installs

_REGISTERED = re.compile(r"\b(?:PLUGINLIB_EXPORT_CLASS|CLASS_LOADER_REGISTER_CLASS)\s*\(([^()]+),([^(),]+)\)")
_COMPONENT = re.compile(r"\bRCLCPP_COMPONENTS_REGISTER_NODE\s*\(([^()]+)()\)")
_MACRO, _OF_COMPONENTS = "_CLASS", "RCLCPP_COMPONENTS_REGISTER_NODE"
_CLASS = re.compile(r"<class\s([^>]*)>", re.DOTALL)
_ATTRIBUTE = re.compile(r"\b(type|base_class_type)\s*=\s*(\"[^\"]*\"|'[^']*')")
_OF_PLUGINS = "base_class_type"


@dataclass(frozen=True)
class MisnamedPlugin:
    """The ``type`` of a class in a description, and the one under which the code registers it, at ``registered_at``."""

    place: Place
    name: str
    registered: str
    registered_at: Place
    base: str


@dataclass(frozen=True)
class _Class:
    name: str
    base: str
    place: Place


def misnamed_plugins(workspace: WorkspaceIndex) -> Iterator[MisnamedPlugin]:
    """Each class of a description that is not registered, where one of its base is and stands in no description."""
    for name in sorted(workspace.installs):
        installs = workspace.installs[name]
        package = workspace.manifests.get(installs.folder)
        if package is None or package.ros1 or is_aside(workspace, package.manifest.relative):
            continue
        described = [row for row in _described(workspace, installs) if not is_aside(workspace, row.place.file)]
        registered = _registered(workspace, installs) if described else []
        names, listed = {row.name for row in registered}, {row.name for row in described}
        left = [row for row in registered if row.name not in listed]
        for row in described:
            same = {other.name: other for other in left if other.base == row.base}
            if row.name not in names and (meant := _meant(row.name, list(same))) is not None:
                yield MisnamedPlugin(row.place, row.name, meant, same[meant].place, row.base)


def misnamed_components(workspace: WorkspaceIndex) -> Iterator[MisnamedPlugin]:
    """Each component that ``rclcpp_components_register_node`` makes a program for and that the code registers under
    another name: the program looks it up by the text that CMake has."""
    for name in sorted(workspace.installs):
        installs = workspace.installs[name]
        package = workspace.manifests.get(installs.folder)
        if package is None or package.ros1 or is_aside(workspace, package.manifest.relative):
            continue
        asked = {row.plugin: row for row in installs.executables.values() if row.plugin and "$" not in row.plugin}
        registered = _registered(workspace, installs, _COMPONENT) if asked else []
        left = {row.name: row for row in registered if row.name not in asked}
        for plugin, row in asked.items():
            known = plugin in {other.name for other in registered}
            if not known and (meant := _meant(plugin, list(left))) is not None:
                yield MisnamedPlugin(row.place, plugin, meant, left[meant].place, "rclcpp_components")


def _meant(name: str, names: list[str]) -> str | None:
    """The class that was meant: the only one, one of the same name in another namespace, or one of almost that name."""
    last = name.rpartition("::")[2]
    same = [other for other in names if other.rpartition("::")[2] == last]
    if len(same) == 1:
        return same[0]
    return names[0] if len(names) == 1 else nearest(name, names)


def _described(workspace: WorkspaceIndex, installs: Installs) -> Iterator[_Class]:
    for file in workspace.tree.files_below(installs.folder):
        if not file.endswith(".xml") or workspace.package_of(file) != installs.package:
            continue
        text = workspace.tree.text(file) or ""
        if _OF_PLUGINS not in text:
            continue
        for element in _CLASS.finditer(replace_xml_comments(text, lambda comment: " " * len(comment))):
            rows = {row[1]: row for row in _ATTRIBUTE.finditer(element[1])}
            if rows.keys() >= {"type", "base_class_type"}:
                own = rows["type"]
                base = html.unescape(rows["base_class_type"][2][1:-1]).strip()
                place = _place(file, text, element.start(1) + own.start(2) + 1, len(own[2]) - 2)
                yield _Class(html.unescape(own[2][1:-1]).strip(), base, place)


def _registered(workspace: WorkspaceIndex, installs: Installs, macro: re.Pattern[str] | None = None) -> list[_Class]:
    rows = []
    for file in workspace.tree.files_below(installs.folder):
        text = workspace.tree.text(file) or "" if file.endswith(CPP_SOURCES) else ""
        if (_MACRO if macro is None else _OF_COMPONENTS) in text:
            for call in (macro or _REGISTERED).finditer(without_cpp_comments(text)):
                place = _place(file, text, call.start(), len(call[0].splitlines()[0]))
                rows.append(_Class("".join(call[1].split()), "".join((call[2] or "").split()), place))
    return rows


def _place(file: str, text: str, at: int, length: int) -> Place:
    line, start = text.count("\n", 0, at) + 1, text.rfind("\n", 0, at) + 1
    return Place(file, line, at - start + 1, line, at - start + 1 + length)


__all__ = ["MisnamedPlugin", "misnamed_components", "misnamed_plugins"]
