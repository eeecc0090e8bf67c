"""What is said of files that were not ported from ROS 1: they ask rclpy for functions of rospy, or name rospy itself.
Once for each file, and nothing where no program of the workspace comes to it."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_loose_module, is_not_installed
from archlint.analysis.reach import judged_notes
from archlint.checks.folding import with_others
from archlint.finding import Related
from archlint.libraries.absent_names import instead_of

if TYPE_CHECKING:
    from archlint.finding import Finding
    from archlint.model import RefusedCall
    from archlint.systems.model import System

OF_ROS_1 = "rospy"
"""The group of findings about functions of rospy that a file asks rclpy for: it was not ported."""
_SEVERAL = 2
"""How many functions of rospy no longer are one slip."""


def functions_of_rospy(calls: Iterable[RefusedCall]) -> dict[str, set[str]]:
    """The functions of rospy that files ask rclpy for, by file."""
    functions: dict[str, set[str]] = defaultdict(set)
    for call in calls:
        if is_of_rospy(call):
            functions[call.place.file].add(call.api)
    return functions


def is_of_rospy(call: RefusedCall) -> bool:
    """Whether a refused call is one of a function that rospy has."""
    return call.given == "rclpy" and bool(instead_of(call.api))


def told_of_rospy(system: System) -> dict[str, set[str]]:
    """The functions of rospy for which API002 says that files ask rclpy, by file."""
    return functions_of_rospy(judged_notes(system, lambda program: program.refused_calls))


def is_part_of_port(system: System, functions: Mapping[str, Collection[str]], file: str, *, of_ros_1: bool) -> bool:
    """Whether a name that a file does not define is part of what its port is about: all names of a file that asks for
    several functions of rospy; ``of_ros_1``, one of rospy itself, where API002 says so of the file, or no program comes
    to it."""
    return is_of_ros_1(functions, file) or (of_ros_1 and (file in functions or is_left_in_ros_1(system, file)))


def is_of_ros_1(functions: Mapping[str, Collection[str]], file: str) -> bool:
    """Whether a file asks for several functions of rospy, so that who ports it writes the rest anew, too."""
    return len(functions.get(file, ())) >= _SEVERAL


def is_left_in_ros_1(system: System, file: str) -> bool:
    """Whether no program of the workspace comes to a file: nobody ports what nobody starts."""
    workspace = system.workspace
    if workspace is None or not workspace.manifests:
        return False
    return is_not_installed(workspace, file) or is_loose_module(workspace, file)


def of_one_port(findings: Sequence[Finding]) -> Finding:
    """The first of the calls of a file for all of them, with what each of the others is in rclpy."""
    several = len({told.identity for told in findings}) > 1
    if not several:
        return with_others(findings, "another call in this file does", "more calls in this file do", "the same")
    first = with_others(findings, "another call in this file is", "more calls in this file are", "of rospy, too")
    own = len(findings[0].related)
    rows = [Related(other.place, f"{other.message}: {other.help}") for other in findings[1:]]
    return replace(
        first,
        help=f"port the file, which is written for ROS 1; here {findings[0].help}",
        related=(*first.related[:own], *rows),
    )


__all__ = [
    "OF_ROS_1",
    "functions_of_rospy",
    "is_left_in_ros_1",
    "is_of_ros_1",
    "is_of_rospy",
    "is_part_of_port",
    "of_one_port",
    "told_of_rospy",
]
