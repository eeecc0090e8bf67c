"""What descriptions of robots (URDF, xacro, SDF) say of joints and of the interfaces of their hardware.

xacro is not run: a name with ``${…}`` in it stands for all that it may be.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import field
from functools import lru_cache

from archlint.records import dataclass
from archlint.workspace.comments import replace_xml_comments

_TAG = re.compile(r"<(/?)([A-Za-z][\w:.-]*)((?:\s+[\w:.-]+\s*=\s*(?:\"[^\"]*\"|'[^']*'))*)\s*(/?)>")
_NAME = re.compile(r"(?<![\w:.-])name\s*=\s*(?:\"([^\"]*)\"|'([^']*)')")
_HOLE = re.compile(r"\$\{[^}]*\}|\$\([^)]*\)")
_MOST_PARTS = 5
_COMPONENTS = ("joint", "gpio", "sensor")
_INTERFACES = ("command_interface", "state_interface")
_SYSTEM = "ros2_control"


@lru_cache(maxsize=10_000)
def _pattern(name: str) -> re.Pattern[str]:
    """What a name with holes may be; anything where it is little more than holes."""
    parts = _HOLE.split(name)
    return re.compile(".*" if len(parts) > _MOST_PARTS else ".*".join(re.escape(part) for part in parts))


@dataclass(frozen=True)
class Named:
    """A name in a description, as it is written."""

    name: str

    @property
    def is_literal(self) -> bool:
        return _HOLE.search(self.name) is None

    def may_be(self, name: str) -> bool:
        return name == self.name or (not self.is_literal and _pattern(self.name).fullmatch(name) is not None)


@dataclass(frozen=True)
class Component:
    """A joint, gpio or sensor below ``<ros2_control>``, or in a macro for what is there (it has interfaces), with the
    names of these."""

    name: Named
    commands: list[Named] = field(default_factory=list)
    states: list[Named] = field(default_factory=list)


@dataclass(frozen=True)
class RobotDescription:
    """All that one file names: ``names`` are those of joints and of the components of hardware."""

    names: tuple[Named, ...]
    components: tuple[Component, ...]


def read_description(text: str) -> RobotDescription:
    """What a file says, whatever else it is.  Never raises."""
    names: dict[str, Named] = {}
    components: list[Component] = []
    within: list[Component] = []
    in_system = False
    for closing, tag, name, is_empty in _tags(text):
        if tag == _SYSTEM:
            in_system = not closing and not is_empty
        elif tag in _COMPONENTS and closing:
            within.clear()
        elif tag in _COMPONENTS and name is not None:
            names[name] = Named(name)
            component = Component(Named(name))
            if in_system:
                components.append(component)
            within[:] = [] if is_empty else [component]
        elif within and name is not None and not closing and tag in _INTERFACES:
            if not any(within[0] is component for component in components[-1:]):
                components.append(within[0])  # in a macro that <ros2_control> calls
            if tag == "command_interface":
                within[0].commands.append(Named(name))
            else:
                within[0].states.append(Named(name))
    return RobotDescription(tuple(names.values()), tuple(components))


def _tags(text: str) -> Iterator[tuple[bool, str, str | None, bool]]:
    for match in _TAG.finditer(replace_xml_comments(text, lambda comment: "")):
        named = _NAME.search(match[3])
        name = None if named is None else (named[1] if named[1] is not None else named[2])
        yield match[1] == "/", match[2], name, match[4] == "/"


__all__ = ["Component", "Named", "RobotDescription", "read_description"]
