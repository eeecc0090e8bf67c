"""LCH005: keywords and attributes that an action of launch does not have."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.launch_code import is_for_several_distros
from archlint.checks.folding import folds
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Related, Severity
from archlint.suggestions import did_you_mean, distance

if TYPE_CHECKING:
    from archlint.systems.model import System

_RENAMED = {
    "node_name": "name",
    "node_executable": "executable",
    "node_namespace": "namespace",
    "node_plugin": "plugin",
    "type": "exec",
    "ns": "namespace",
    "launch_description_sources": "launch_description_source",
}

_OF_ROS_1 = {"rosparam": '<param from="…"/>'}
"""Elements of ROS 1, and how ROS 2 writes them."""


@rule("LCH005", scope=Scope.LAUNCH_FILE, in_use=True)
def unknown_launch_attribute(system: System, options: Options) -> Iterator[Finding]:
    """Keywords and attributes that an action does not have."""
    for wrong in system.launched.unknown_attributes if system.launched is not None else ():
        if is_for_several_distros(system.workspace, wrong.place.file):
            continue
        renamed = _RENAMED.get(wrong.name)
        hint = f"; it is called '{renamed}'" if renamed in wrong.known else did_you_mean(wrong.name, wrong.known)
        hint = f"; write '{_OF_ROS_1[wrong.name]}'" if wrong.name in _OF_ROS_1 and "param" in wrong.known else hint
        kind = "element" if wrong.nested else "attribute" if wrong.of_element else "argument"
        why = "launch rejects this file" if wrong.of_element else "this call raises TypeError"
        diagnostic = finding(
            "LCH005",
            wrong.place,
            f"{wrong.action} has no {kind} '{wrong.name}'{hint}",
            help=f"{why} before anything is started",
            identity=(wrong.action, wrong.name),
            group=(wrong.place.file,),
        )
        is_old = wrong.name.startswith("node_") and _is_for_an_old_release(wrong.place.file)
        yield replace(diagnostic, severity=Severity.INFO) if is_old else diagnostic


_OLD_RELEASES = ("dashing", "eloquent", "foxy")
"""The releases whose ``Node`` took ``node_name`` and the like."""
_LONG = 7
"""Letters of a name that is still itself with one of them wrong."""


def _is_for_an_old_release(file: str) -> bool:
    """Whether a file is called after one of them, be it with a slip."""
    words = re.findall("[a-z]+", posixpath.basename(file))
    return any(distance(word, name, 1) <= int(len(name) >= _LONG) for word in words for name in _OLD_RELEASES)


@folds("LCH005")
def _of_one_file(several: Sequence[Finding]) -> Finding:
    """One finding for a file, whatever its actions are given that they do not have: launch stops at the first."""
    others = tuple(Related(other.place, other.message) for other in several[1:])
    return replace(several[0], related=others)
