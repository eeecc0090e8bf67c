"""Nodes that the program works with itself: it calls their callbacks, or it asks them for a step between two spins."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.execution.spins import is_spin_call
from archlint.model import Role
from archlint.syntax import facts
from archlint.syntax.misspelt_constructor import CONSTRUCTOR
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import called_name, calls_in, statements_of

if TYPE_CHECKING:
    from archlint.analysis.source_code import SourceCode
    from archlint.model import Blueprint, Creation, Program


def left_to_executor(code: SourceCode, node: Blueprint, served: Sequence[Creation]) -> list[Creation]:
    """What of a node needs an executor, without that of which the function that makes the node calls each callback::

    node = Monitor()
    for _ in range(100):
        node.on_timer()
    """
    called = {name for _, name in _called(code, node)}
    return [creation for creation in served if not _callbacks(creation) <= called]


def is_command(code: SourceCode, file: str) -> bool:
    """Whether whoever starts a program in a terminal says there what it is to do, or its constructor is all there is of
    it: code that reads a word of its command line, ``sys.argv[1]``, or a constructor that calls ``exit()``."""
    file_facts = code.facts_at(file)
    if file_facts is None:
        return False
    words = everything_in(file_facts.body, facts.Subscript)
    if any(word.value.dotted == "sys.argv" and isinstance(word.index, facts.Literal) for word in words):
        return True
    functions = (each for each in everything_in(file_facts.body, facts.Function) if each.name == CONSTRUCTOR)
    lines = (line for each in functions for line in each.body if isinstance(line, facts.Expression))
    return any(isinstance(line.value, facts.Call) and called_name(line.value) == "exit" for line in lines)


def is_driven_by_hand(code: SourceCode, program: Program, node: Blueprint) -> bool:
    """Whether a program has nothing but one node, for which the loop that makes a step of it spins now and then::

    node = Planner()
    while rclpy.ok():
        node.plan_once()
        rclpy.spin_once(node, timeout_sec=0.05)
    """
    spins = [call for call in program.calls if is_spin_call(call)]
    if not program.executable or len(program.nodes) != 1:
        return False
    if not all(call.api in _FOR_A_MOMENT and call.context.role == Role.MAIN for call in spins):
        return False
    if not any(call.api == "rclpy.spin_once" and call.looped for call in spins):
        return False
    return any(in_loop and name in _own_methods(code, node) for in_loop, name in _called(code, node))


_FOR_A_MOMENT = ("rclpy.spin_once", "rclpy.spin_until_future_complete")


def _own_methods(code: SourceCode, node: Blueprint) -> set[str]:
    """The methods that the classes of a node define."""
    names: set[str] = set()
    for own in node.classes:
        file_facts = code.facts_at(own.place.file)
        for cls in everything_in([] if file_facts is None else file_facts.body, facts.Class):
            if cls.name == own.name.rpartition(".")[2]:
                names.update(statement.name for statement in cls.body if isinstance(statement, facts.Function))
    return names


def _callbacks(creation: Creation) -> set[str]:
    return {callback.name.rpartition(".")[2] for callback in creation.callbacks.values()}


def _called(code: SourceCode, node: Blueprint) -> set[tuple[bool, str]]:
    """The methods that the function which makes a node calls on the variable it assigns the node to, and whether it
    does so in a loop."""
    place = node.made_at or node.place
    body = list(code.body_at(place))
    variables = {
        target.variable
        for assignment in statements_of(body, facts.Assign)
        if isinstance(assignment.value, facts.Call) and assignment.value.span == place.span
        for target in assignment.targets
        if target.variable
    }
    looped = {
        call.span for loop in (facts.While, facts.For) for each in statements_of(body, loop) for call in calls_in(each)
    }
    return {
        (call.span in looped, call.func.attr)
        for call in calls_in(body)
        if isinstance(call.func, facts.Attribute) and call.func.value.variable in variables
    }


__all__ = ["is_command", "is_driven_by_hand", "left_to_executor"]
