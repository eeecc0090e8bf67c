"""Whether a header that a C++ file includes may open a namespace for it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.analysis.kept import kept
from archlint.packaging.cpp_includes import headers_with, includes_of, is_of_workspace

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_OPEN_NOTHING = frozenset(
    {"rclcpp", "rclcpp_action", "rclcpp_components", "rclcpp_lifecycle", "std_srvs", "tf2", "tf2_ros"}
)
_OF_MESSAGES = ("_msgs", "_interfaces")
"""Packages whose headers open no namespace, and have no placeholders of Boost's."""


def may_be_opened(workspace: WorkspaceIndex, path: str, word: str) -> bool:
    """Whether any header that a file includes, or that such a one includes, may have a word: one of the workspace that
    has it, or opens all of ``std``, or one of which nothing is known."""
    names = [header for header, _ in includes_of(workspace.tree.text(path) or "")]
    for header in names:
        top, slash, _ = header.partition("/")
        if is_of_workspace(workspace, header):
            if kept(workspace, (may_be_opened, word), lambda: headers_with(workspace, word)):
                return True
        elif "." in header and not (slash and (top in _OPEN_NOTHING or top.endswith(_OF_MESSAGES))):
            return True
    return False


__all__ = ["may_be_opened"]
