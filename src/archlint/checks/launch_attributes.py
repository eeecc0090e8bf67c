"""LCH005: keywords and attributes that an action of launch does not have."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.pinned import is_from_before_galactic
from archlint.checks.folding import folds, with_places
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Severity
from archlint.launch_files.launch_code import is_for_several_distros
from archlint.launch_files.old_releases import has_successor, is_for_an_old_release
from archlint.suggestions import did_you_mean, nearest

if TYPE_CHECKING:
    from archlint.launch.mistakes import UnknownAttribute
    from archlint.systems.model import System

_RENAMED = {
    "node_name": "name",
    "node_executable": "executable",
    "node_namespace": "namespace",
    "node_plugin": "plugin",
    "type": "exec",
    "ns": "namespace",
    "default": "default_value",
    "default_value": "default",
    "launch_description_sources": "launch_description_source",
}
"""What an argument is called instead, where that is one of the action's: the first name is of an older release, of
ROS 1, or of another class."""

_OF_SEVERAL = frozenset({"arguments", "parameters", "remappings", "ros_arguments"})
"""Arguments that take several values."""

_OF_ROS_1 = {"rosparam": '<param from="…"/>'}
"""Elements of ROS 1, and how ROS 2 writes them."""


@rule("LCH005", scope=Scope.LAUNCH_FILE, in_use=True)
def unknown_launch_attribute(system: System, options: Options) -> Iterator[Finding]:
    """Keywords and attributes that an action does not have."""
    every = system.launched.unknown_attributes if system.launched is not None else ()
    old = {wrong.place.file for wrong in every if _was_renamed(wrong)}
    for wrong in every:
        if is_for_several_distros(system.workspace, wrong.place.file):
            continue
        is_old = _was_renamed(wrong) and is_for_an_old_release(wrong.place.file)
        if is_old and has_successor(system.workspace, wrong.place.file):
            continue
        if _was_renamed(wrong) and is_from_before_galactic(system.workspace):
            continue  # right where it is to run
        renamed = _RENAMED.get(wrong.name)
        hint = f"; it is called '{renamed}'" if renamed in wrong.known else did_you_mean(wrong.name, wrong.known)
        since = " since Galactic" if _was_renamed(wrong) else ""
        hint = f"; write '{_OF_ROS_1[wrong.name]}'" if wrong.name in _OF_ROS_1 and "param" in wrong.known else hint
        kind = "element" if wrong.nested else "attribute" if wrong.of_element else "argument"
        why = "launch rejects this file" if wrong.of_element else "this call raises TypeError"
        meant = renamed if renamed in wrong.known else nearest(wrong.name, wrong.known)
        do = f"put its values into {meant}=" if meant in _OF_SEVERAL else f"remove it: {meant}="
        merge = f": {do}, which is given, too" if meant in wrong.given else ""
        diagnostic = finding(
            "LCH005",
            wrong.place,
            f"{wrong.action} has no {kind} '{wrong.name}'{since}{hint}",
            help=f"{why} before anything is started{merge}",
            identity=(wrong.action, wrong.name),
            group=(_OLD,) if wrong.place.file in old else (wrong.place.file,),
        )
        yield replace(diagnostic, severity=Severity.INFO) if is_old else diagnostic


_OLD = "names of an older launch_ros"
"""What all files in which such names stand have in common: they were written for the same release."""


def _was_renamed(wrong: UnknownAttribute) -> bool:
    """Whether ``Node`` took an argument under this name until Foxy, with a warning there."""
    return wrong.name.startswith("node_") and not wrong.of_element and wrong.name in _RENAMED


@folds("LCH005", across_systems=True)
def _of_one_cause(several: Sequence[Finding]) -> Finding:
    """One finding for a file, whatever its actions are given that they do not have: launch stops at the first.  Files
    that were written for an older release are one finding, too."""
    first = with_places(several)
    others = {finding.place.file for finding in several} - {first.place.file}
    if not others:
        return first
    words = "another launch file uses" if len(others) == 1 else f"{len(others)} more launch files use"
    return replace(first, message=f"{first.message}; {words} {_OLD}")
