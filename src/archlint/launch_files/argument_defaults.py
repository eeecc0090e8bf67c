"""Defaults that a launch file in Python gives its arguments where it declares and where it reads them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.syntax import facts
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex


def has_another_default(workspace: WorkspaceIndex, file: str, argument: str) -> bool:
    """Whether what reads an argument has a default that differs from the declared one: if nothing adds the declaration,
    the launch does something else today than it would with it."""
    file_facts = workspace.facts_at(file) if argument else None
    calls = [] if file_facts is None else [*everything_in(file_facts.body, facts.Call)]
    declared = {value for call in calls if (value := _default(call, "DeclareLaunchArgument", argument)) is not None}
    read = {value for call in calls if (value := _default(call, "LaunchConfiguration", argument)) is not None}
    return bool(declared and read - declared)


def _default(call: facts.Call, called: str, argument: str) -> str | None:
    """The default that a call of a class of launch gives an argument, as a text."""
    if call.func.last_name != called or not call.args or _constant(call.args[0].value) != argument:
        return None
    values = (_constant(row.value) for row in call.args if row.keyword in ("default", "default_value"))
    return next(values, None)


def _constant(value: facts.Expr) -> str | None:
    return str(value.value) if isinstance(value, facts.Literal) else None


__all__ = ["has_another_default"]
