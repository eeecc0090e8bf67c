"""The limits of joints that a file for MoveIt sets.

Source: ``RobotModelLoader::configure`` of moveit_ros_planning, branches humble to main: the largest and the smallest
position are read whatever stands beside them, the other values where their ``has_…_limits`` is true.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from archlint.syntax.facts import Span
from archlint.syntax.safe_yaml import YamlError, YamlReader, span_of

_KEY = "joint_limits"
_SWITCHES = {f"max_{kind}": f"has_{kind}_limits" for kind in ("velocity", "acceleration", "jerk")}
_ALWAYS = ("max_position", "min_position")


class JointLimit(NamedTuple):
    """A value that is read, and where it stands."""

    joint: str
    name: str
    value: object
    span: Span


def read_limits(text: str) -> list[JointLimit]:
    """Those of a file; none where it cannot be read."""
    try:
        return list(_limits(YamlReader(text)))
    except (YamlError, RecursionError):
        return []


def _limits(reader: YamlReader) -> Iterator[JointLimit]:
    if reader.root is None:
        return
    for key, _, limits in reader.pairs(reader.root, 0):
        for joint, _, values in reader.pairs(limits, 1) if key == _KEY else ():
            rows = {name: node for name, _, node in reader.pairs(values, 2)}
            for name, node in rows.items():
                switch = rows.get(_SWITCHES.get(name, ""))
                if name in _ALWAYS or (switch is not None and reader.value(switch) is True):
                    yield JointLimit(joint, name, reader.value(node), span_of(node))


__all__ = ["JointLimit", "read_limits"]
