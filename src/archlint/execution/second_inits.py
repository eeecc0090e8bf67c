"""Nodes that are never made, since their constructor calls ``rclpy.init()`` in a program that has done so before.

Source: ``Context.init`` in rclpy/context.py raises a RuntimeError the second time ("must only be called once").
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.syntax import facts
from archlint.syntax.flow_facts import covers
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from archlint.model import Blueprint, Program
    from archlint.systems.model import WorkspaceIndex

_INIT = "rclpy.init"


def initialises_again(workspace: WorkspaceIndex, program: Program, node: Blueprint) -> bool:
    """Whether the constructor of a node calls ``rclpy.init()`` whatever happens, and so does its program outside of
    the class."""
    defined, started = workspace.facts_at(node.place.file), workspace.facts_at(program.file)
    if defined is None or started is None:
        return False
    classes = [each for each in everything_in(defined.body, facts.Class) if each.name == node.class_name]
    constructors = [
        item
        for cls in classes
        for item in cls.body
        if isinstance(item, facts.Function) and item.name == "__init__" and any(map(_is_init, item.body))
    ]
    own = constructors if program.file == node.place.file else []
    calls = [call for call in everything_in(started.body, facts.Call) if call.func.dotted == _INIT]
    return bool(constructors) and any(not any(covers(each, call.span) for each in own) for call in calls)


def _is_init(statement: facts.Stmt) -> bool:
    return (
        isinstance(statement, facts.Expression)
        and isinstance(statement.value, facts.Call)
        and statement.value.func.dotted == _INIT
    )


__all__ = ["initialises_again"]
