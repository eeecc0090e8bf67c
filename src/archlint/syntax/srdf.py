"""SRDF, which says of a robot's description what MoveIt needs: here, which frames its virtual joints connect."""

from __future__ import annotations

from typing import NamedTuple
from xml.parsers import expat

_OF_XACRO = ("xacro", "$")
"""What stands in a document that xacro makes another one of."""


class VirtualJoint(NamedTuple):
    """A joint between the world and the robot: MoveIt publishes the transform between its frames."""

    parent_frame: str
    child_link: str


class _Refused(Exception):
    """A document that nobody needs, and that can do harm."""


def virtual_joints(text: str) -> list[VirtualJoint] | None:
    """The virtual joints, in their order; None of a text that xacro changes, and of one that is no XML."""
    if any(words in text for words in _OF_XACRO):
        return None
    joints: list[VirtualJoint] = []
    depth = 0

    def start(tag: str, attributes: dict[str, str]) -> None:
        nonlocal depth
        if depth == 1 and tag == "virtual_joint":
            joints.append(VirtualJoint(attributes.get("parent_frame", ""), attributes.get("child_link", "")))
        depth += 1

    def end(_: str) -> None:
        nonlocal depth
        depth -= 1

    def refuse(*_: object) -> None:
        raise _Refused

    parser = expat.ParserCreate()
    parser.StartElementHandler = start
    parser.EndElementHandler = end
    parser.StartDoctypeDeclHandler = refuse
    try:
        parser.Parse(text, True)
    except (expat.ExpatError, _Refused):
        return None
    return joints


__all__ = ["VirtualJoint", "virtual_joints"]
