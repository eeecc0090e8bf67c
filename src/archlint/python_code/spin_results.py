"""What ``spin_until_future_complete()`` returns, where code asks for it: None, whatever becomes of the future.

Source: rclpy/__init__.py and rclpy/executors.py of humble, jazzy and rolling; in rclcpp it returns a code.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.kept import once_for_each_file
from archlint.place import Place
from archlint.syntax import facts
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_NAME = "spin_until_future_complete"


def tested_spins(workspace: WorkspaceIndex) -> Iterator[Place]:
    """The calls whose result decides something, outside of test code."""
    for file, _ in workspace.code.asked_for():
        path = file.relative
        if path.endswith(".py") and not workspace.roles.is_test(path) and workspace.code.mentions(path, _NAME):
            yield from (Place(path, *span) for span in _tested(workspace, path) or ())


@once_for_each_file
def _tested(file_facts: facts.Facts) -> list[facts.Span]:
    imports = [row for row in everything_in(file_facts.body, facts.ImportFrom) if row.module == "rclpy"]
    own = {bound for row in imports for name, bound in row.names if name == _NAME}
    spans = {
        call.span: None
        for test in _tests(file_facts.body)
        for call in _decisive(test)
        if isinstance(call, facts.Call) and _is_of_rclpy(call, own)
    }
    return list(spans)


def _tests(body: list[facts.Stmt]) -> Iterator[facts.Expr]:
    for part in everything_in(body):
        match part:
            case facts.If(test=test) | facts.While(test=test) | facts.Conditional(test=test) | facts.Assert(test=test):
                yield test


def _decisive(test: facts.Expr) -> Iterator[facts.Expr]:
    """The parts of a condition whose values decide it."""
    match test:
        case facts.Boolean(values=values):
            for value in values:
                yield from _decisive(value)
        case facts.Unary(op="not", operand=operand):
            yield from _decisive(operand)
        case facts.Compare(left=left, comparators=comparators):
            yield from (left, *comparators)
        case facts.Assigned(value=value):
            yield from _decisive(value)
        case _:
            yield test


def _is_of_rclpy(call: facts.Call, own: set[str]) -> bool:
    match call.func:
        case facts.Name(id=name):
            return name in own
        case facts.Attribute(value=owner, attr=name) if name == _NAME:
            return owner.variable == "rclpy" or "executor" in owner.last_name
    return False


__all__ = ["tested_spins"]
