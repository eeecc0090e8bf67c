"""What LCH008 says of what stands among actions and is none, and of an action in a condition."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from typing import TYPE_CHECKING

from archlint.checks.registry import finding

if TYPE_CHECKING:
    from archlint.finding import Finding
    from archlint.launch.mistakes import NoAction
    from archlint.launch.model import Launched


def no_actions_told(launched: Launched) -> Iterator[Finding]:
    """The findings about them."""
    declared = {row.name for row in launched.declared}
    return (_told(wrong, declared) for wrong in launched.no_actions)


def _told(wrong: NoAction, declared: Collection[str]) -> Finding:
    if wrong.among:
        message = f"this {wrong.class_name} stands among actions, and is none: launch stops with an AttributeError"
        help = _instead(wrong, declared)
    else:
        message = (
            f"this {wrong.class_name} is given a DeclareLaunchArgument, which has no value: a TypeError stops launch"
        )
        help = f"write {wrong.class_name}(LaunchConfiguration('{wrong.name or '…'}')), of launch.substitutions"
    return finding(
        "LCH008",
        wrong.place,
        message,
        help=help,
        identity=(wrong.class_name, wrong.name),
        group=(wrong.place.file, "no action", wrong.class_name),
    )


def _instead(wrong: NoAction, declared: Collection[str]) -> str:
    if wrong.class_name.startswith("Composable"):
        return "put it into composable_node_descriptions= of a ComposableNodeContainer or of LoadComposableNodes"
    if wrong.name and wrong.name not in declared:
        return f"put the DeclareLaunchArgument of '{wrong.name}' into the list in place of it"
    return "take it out of the list: a substitution is for the arguments of actions"


__all__ = ["no_actions_told"]
