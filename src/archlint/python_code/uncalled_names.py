"""Lines that name a function and do not call it: ``node.destroy_node``, ``rclpy.shutdown``, ``main``.

Python evaluates such a line to the function itself, and drops that.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.place import Place
from archlint.python_code.annotations import imported_as
from archlint.python_code.class_chains import classes_of, methods_of
from archlint.python_code.own_calls import bindings_of
from archlint.syntax import facts
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_METHODS = frozenset(
    {"abort", "add_node", "call_async", "canceled", "cancel", "destroy", "destroy_client", "destroy_node"}
    | {"destroy_publisher", "destroy_service", "destroy_subscription", "destroy_timer", "publish", "send_goal_async"}
    | {"shutdown", "spin", "spin_once", "succeed", "wait_for_server", "wait_for_service"}
)
"""Methods of rclpy's objects that are called for what they do, and that no class has as a property."""

_FUNCTIONS = frozenset({"rclpy.init", "rclpy.shutdown", "rclpy.spin", "rclpy.spin_once", "rclpy.try_shutdown"})


def uncalled_names(workspace: WorkspaceIndex) -> Iterator[tuple[str, Place]]:
    """What such lines name, and where, in the files that use rclpy, outside of test code."""
    for path in workspace.python_files(mentioning="rclpy"):
        for name, span in _uncalled(workspace, path) or ():
            yield name, Place(path, *span)


@kept_for_each_file
def _uncalled(code: facts.Facts) -> list[tuple[str, facts.Span]]:
    functions = {part.name for part in code.body if isinstance(part, facts.Function) and not part.decorators}
    functions = {name for name in functions if bindings_of(code)[name] == 1}
    own = {id(line): methods for line, methods in _in_methods(code)}
    rows: list[tuple[str, facts.Span]] = []
    for statement in everything_in(code.body, facts.Expression):
        match statement.value:
            case facts.Name(id=name) if name in functions:
                rows.append((name, statement.value.span))
            case facts.Attribute(attr=name) as value if value.dotted:
                of_rclpy = imported_as(code, value.dotted) in _FUNCTIONS
                of_self = value.dotted == f"self.{name}" and name in own.get(id(statement), ())
                if of_rclpy or of_self or name in _METHODS:
                    rows.append((value.dotted, value.span))
    return rows


def _in_methods(code: facts.Facts) -> Iterator[tuple[facts.Expression, frozenset[str]]]:
    """The lines of methods that are one expression, with the plain methods of their class that can be called without an
    argument: the bare name of another is there so that no linter calls what is given away unused."""
    for cls in classes_of(code):
        plain = frozenset(
            method.name for method in methods_of(cls) if not method.decorators and not _needs_arguments(method)
        )
        for method in methods_of(cls):
            for line in everything_in(method.body, facts.Expression):
                yield line, plain


def _needs_arguments(method: facts.Function) -> bool:
    """Whether a method takes more than the object, and has no default for it."""
    plain = [param for param in method.params if param.kind not in ("star", "double_star")]
    return any(param.default is None for param in plain[1:])


__all__ = ["uncalled_names"]
