"""Methods of a node that a class overwrites with what one of them returns, and calls again.

``self.create_subscription = self.create_subscription(…)`` leaves a subscription where the method was.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.libraries.api_signatures import signatures_of
from archlint.libraries.rclpy.names import NODE_CLASSES
from archlint.place import Place
from archlint.python_code.block_bindings import after
from archlint.python_code.class_chains import ClassInFile, chain_of, classes_of, kept_for_each_class, methods_of
from archlint.python_code.methods_at_work import INIT, methods_at_work, of_self
from archlint.python_code.tried_code import tried_for
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.control_flow import graph_of
from archlint.syntax.parts import Itself, everything_in, parts_of

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_NODE = "rclpy.node.Node"
_MAKES = ("create_", "get_", "declare_")
"""How the methods begin whose results nobody can call."""


@dataclass(frozen=True)
class OverwrittenMethod:
    """Such an assignment, and the call that fails for it."""

    place: Place
    cls: str
    name: str
    called: Place


def overwritten_methods(workspace: WorkspaceIndex) -> Iterator[OverwrittenMethod]:
    """Every such assignment in the classes of the files that were asked for, but for test code."""
    for path in workspace.python_files():
        code = workspace.facts_at(path)
        for number in () if code is None else range(len(classes_of(code))):
            assert code is not None
            cls = ClassInFile(path, classes_of(code)[number])
            rows = _rows(workspace, cls)
            if rows and not NODE_CLASSES.isdisjoint(chain_of(workspace, cls).foreign):
                for name, span, called in rows:
                    yield OverwrittenMethod(Place(path, *span), cls.code.name, name, Place(path, *called))


@kept_for_each_class
def _rows(code: facts.Class) -> list[tuple[str, facts.Span, facts.Span]]:
    own = {function.name for function in methods_of(code)}
    rows: list[tuple[str, facts.Span, facts.Span]] = []
    for function in methods_of(code):
        for statement in parts_of(function.body, facts.Assign):
            match statement:
                case facts.Assign(targets=[facts.Attribute(attr=name) as target], value=facts.Call() as value):
                    makes = of_self(value.func) or ""
                    if of_self(target) != name or name in own or not _is_of_node(name):
                        continue
                    if makes.startswith(_MAKES) and _is_of_node(makes) and makes not in own:
                        called = _called_again(code, function, statement, name)
                        rows += [] if called is None else [(name, target.span, called)]
    return rows


def _is_of_node(name: str) -> bool:
    return bool(signatures_of(f"{_NODE}.{name}"))


def _called_again(
    code: facts.Class, function: facts.Function, assignment: facts.Assign, name: str
) -> facts.Span | None:
    """A call of the method that runs after the assignment: behind it, or in a method that runs only later."""
    graph = graph_of(function.body)
    later = after(graph.at(assignment))
    for block in graph.blocks:
        called = _call_in(block.fact, name) if block in later else None
        if called is not None:
            return called
    if function.name != INIT:
        return None
    work = methods_at_work(code)
    early = work.after([INIT])
    for other in methods_of(code):
        expecting = tried_for(other.body, {"TypeError"})
        if other.name not in early:
            for call in everything_in(other.body, facts.Call):
                if of_self(call.func) == name and Itself[facts.Base](call) not in expecting:
                    return call.span
    return None


def _call_in(fact: facts.Base | None, name: str) -> facts.Span | None:
    calls = parts_of(fact, facts.Call) if fact is not None else ()
    return next((call.span for call in calls if of_self(call.func) == name), None)


__all__ = ["OverwrittenMethod", "overwritten_methods"]
