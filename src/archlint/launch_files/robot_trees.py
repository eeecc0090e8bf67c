"""Descriptions of robots that no reader takes, where a launch file names them: links and joints that are no tree.

Source: ``parseURDF`` and ``ModelInterface::initTree`` and ``initRoot`` of urdfdom: "link 'x' is not unique.", "parent
link [x] of joint [y] not found", "Two root links found".  robot_state_publisher then ends with "Unable to initialize
urdf::model from robot description".
"""

from __future__ import annotations

import posixpath
from collections.abc import Iterator
from dataclasses import field
from enum import Enum
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_aside
from archlint.analysis.kept import kept
from archlint.place import Place
from archlint.records import dataclass
from archlint.suggestions import nearest
from archlint.syntax.xacro_expansion import Expansion, Made, Stop, expand
from archlint.syntax.xacro_expressions import may_be_same, shown

if TYPE_CHECKING:
    from archlint.systems.model import System, WorkspaceIndex

_ENDINGS = (".urdf", ".xacro")
_FIND = "$(find "


class Flaw(Enum):
    """What a reader says of a description that it refuses."""

    TWICE = "twice"
    NO_LINK = "no link"
    ROOTS = "roots"


@dataclass(frozen=True)
class RefusedTree:
    """What is wrong with the ``name`` of a ``kind``, a link or a joint, in a description at ``robot``."""

    flaw: Flaw
    place: Place
    kind: str
    name: str
    robot: str
    other: str = ""
    """The other root, or the link that was meant; the joint where ``joint`` is said."""
    joint: str = ""
    there: Place | None = None


@dataclass(frozen=True)
class _Joint:
    name: str
    parent: str
    child: str
    element: Made


@dataclass(frozen=True)
class Robot:
    """The links and joints; whether there may be more, or names that are not known."""

    links: list[tuple[str, Made]] = field(default_factory=list)
    joints: list[_Joint] = field(default_factory=list)
    open: bool = False


def expansion_of(workspace: WorkspaceIndex, file: str) -> Expansion | None:
    """What xacro makes of a description of the workspace."""

    def read(path: str, within: str) -> tuple[str, str] | None:
        package, _, rest = path.removeprefix(_FIND).partition(")")
        if path.startswith(_FIND):
            folder = workspace.packages[package].relative if package in workspace.packages else None
            inner = rest.lstrip("/")
        else:
            folder, inner = (None if path.startswith("/") else posixpath.dirname(within)), path
        file_read = None if folder is None else posixpath.normpath(posixpath.join(folder, inner))
        text = workspace.tree.text(file_read) if file_read and workspace.tree.is_file(file_read) else None
        return None if file_read is None or text is None else (file_read, text)

    return kept(workspace, ("expansion", file), lambda: expand(file, workspace.tree.text(file) or "", read))


def named_descriptions(system: System) -> list[str]:
    """The descriptions that the launch file itself names; not those that they include."""
    launched, workspace = system.launched, system.workspace
    if launched is None or workspace is None or launched.ros1:
        return []
    named = {
        row.source
        for row in launched.references
        if row.source is not None and not row.dormant and not row.place.file.endswith(_ENDINGS)
    }
    return sorted(file for file in named if file.endswith(_ENDINGS) and not is_aside(workspace, file))


def stops_at_calls(system: System) -> Iterator[Stop]:
    """The calls of macros at which xacro stops, in the descriptions that a launch file names."""
    for file in named_descriptions(system):
        expansion = None if system.workspace is None else expansion_of(system.workspace, file)
        if expansion is not None and expansion.stop is not None:
            yield expansion.stop


def refused_trees(system: System) -> Iterator[RefusedTree]:
    """What is wrong with the descriptions that a launch file names."""
    workspace = system.workspace
    for file in named_descriptions(system):
        expansion = None if workspace is None else expansion_of(workspace, file)
        if expansion is not None:
            yield from _flaws(file, robot_of(expansion))


def robot_of(expansion: Expansion) -> Robot:
    """The links and joints in what xacro has made."""
    links: list[tuple[str, Made]] = []
    joints: list[_Joint] = []
    is_open = expansion.open
    for element in expansion.children:
        name = element.attributes.get("name")
        if element.tag == "link":
            is_open |= name is None
            links += [(name, element)] if name is not None else []
        elif element.tag == "joint":
            parent, child = _link(element, "parent"), _link(element, "child")
            is_open |= name is None or parent is None or child is None
            if name is not None:
                joints.append(_Joint(name, parent or "", child or "", element))
    return Robot(links, joints, is_open)


def _link(joint: Made, end: str) -> str | None:
    return next((row.attributes.get("link") for row in joint.children if row.tag == end), None)


def _flaws(file: str, robot: Robot) -> Iterator[RefusedTree]:
    yield from _twice(file, "link", robot.links)
    yield from _twice(file, "joint", [(joint.name, joint.element) for joint in robot.joints])
    if robot.open or not robot.links:
        return
    links = [name for name, _ in robot.links]
    missing = False
    for joint in robot.joints:
        for end in (joint.parent, joint.child):
            if not any(may_be_same(end, link) for link in links):
                missing = True
                near = nearest(end, links) or ""
                kind = "parent" if end == joint.parent else "child"
                place = place_of(joint.element)
                if not joint.element.perhaps:
                    yield RefusedTree(Flaw.NO_LINK, place, kind, shown(end), file, shown(near), shown(joint.name))
    children = [joint.child for joint in robot.joints]
    roots = [row for row in robot.links if not any(may_be_same(row[0], child) for child in children)]
    certain = [(name, element) for name, element in roots if not element.perhaps]
    if not missing and len(certain) > 1:
        (name, _), (other, element) = certain[0], certain[1]
        yield RefusedTree(
            Flaw.ROOTS, place_of(element), "link", shown(other), file, shown(name), there=place_of(certain[0][1])
        )


def _twice(file: str, kind: str, rows: list[tuple[str, Made]]) -> Iterator[RefusedTree]:
    first: dict[str, Made] = {}
    for name, element in rows:
        if element.perhaps:
            continue
        if name in first:
            yield RefusedTree(Flaw.TWICE, place_of(element), kind, shown(name), file, there=place_of(first[name]))
        first.setdefault(name, element)


def place_of(element: Made) -> Place:
    """Where an element begins."""
    return Place(element.file, element.line, element.column, element.line, element.column + len(element.tag) + 1)


__all__ = [
    "Flaw",
    "RefusedTree",
    "Robot",
    "Stop",
    "expansion_of",
    "named_descriptions",
    "place_of",
    "refused_trees",
    "robot_of",
]
