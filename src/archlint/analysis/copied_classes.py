"""Classes of ROS itself that a workspace holds a copy of: what they do is the work of those who maintain them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import statements_of

if TYPE_CHECKING:
    from archlint.model import ApiCall
    from archlint.systems.model import System

_OF_ROS: Mapping[str, frozenset[str]] = {
    "BasicNavigator": frozenset({"cancelTask", "getResult", "goToPose", "isTaskComplete", "waitUntilNav2Active"}),
}
"""Their names, with methods that a copy keeps.  Source: ``robot_navigator.py`` of nav2_simple_commander."""


def is_in_copied_class(system: System, call: ApiCall) -> bool:
    """Whether a call stands in a method that such a copy has of the original: of a class with its name and methods."""
    name, _, _ = call.function.rpartition(".")
    kept = _OF_ROS.get(name)
    file_facts = None if system.workspace is None or kept is None else system.workspace.facts_at(call.file)
    if file_facts is None or kept is None:
        return False
    return any(
        code.name == name and kept <= {method.name for method in statements_of(code.body, facts.Function)}
        for code in everything_in(file_facts.body, facts.Class)
    )


__all__ = ["is_in_copied_class"]
