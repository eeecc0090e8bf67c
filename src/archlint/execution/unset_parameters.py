"""Code that a callback comes to only where a parameter has another value than its default, which nobody sets::

self.declare_parameter('delay', 0.0)
self.delay = self.get_parameter('delay').value
...
if self.delay > 0.0:
    time.sleep(self.delay)
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING

from archlint.analysis.kept import once_for_each_file
from archlint.analysis.kept_defaults import truth_of_constants
from archlint.analysis.order import paths_to
from archlint.analysis.source_code import source_code
from archlint.syntax import facts
from archlint.syntax.control_flow import graph_of
from archlint.syntax.flow_facts import outcome
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import called_name, calls_in

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.model import ApiCall, Blueprint
    from archlint.systems.model import System, WorkspaceIndex

_READS = frozenset({"get_parameter", "declare_parameter"})
_CONVERTS = frozenset({"bool", "int", "float", "str", "get_parameter_value"})


def is_off_by_default(system: System, call: ApiCall, may_be_set: Callable[[Blueprint, str], bool]) -> bool:
    """Whether every way to a call of a callback needs another value of a parameter than its default, and nothing may
    set that."""
    node, workspace = call.context.node, system.workspace
    if node is None or workspace is None:
        return False
    defaults = {name: value for name, value in _defaults(node).items() if not may_be_set(node, name)}
    return bool(defaults) and all(
        any(_is_shut(system, workspace, place, defaults) for place in path) for path in paths_to(call)
    )


def _defaults(node: Blueprint) -> dict[str, facts.Literal]:
    """The parameters of a node, each declared once and with a plain value that is known."""
    declared = [row.name.text for row in node.parameters]
    if None in declared:
        return {}
    return {
        row.name.text: facts.Literal(row.default, row.place.span)
        for row in node.parameters
        if row.name.text is not None
        and declared.count(row.name.text) == 1
        and row.known
        and not (row.dynamic or row.without_default or row.given)
        and isinstance(row.default, (str, int, float))
    }


def _is_shut(system: System, workspace: WorkspaceIndex, place: Place, defaults: Mapping[str, facts.Literal]) -> bool:
    """Whether a function gets to a place only where a parameter has not its default."""
    kept = _kept_in(workspace, place.file) or {}
    values = {name: defaults[of] for name, of in kept.items() if of in defaults}
    graph = graph_of(source_code(system).body_at(place))
    return bool(values) and any(
        edge.test is not None and outcome(edge.test, lambda part: truth_of_constants(part, values)) is (not edge.holds)
        for edge in graph.outcomes(graph.evaluating(place.span))
    )


@once_for_each_file
def _kept_in(file_facts: facts.Facts) -> dict[str, str]:
    """The attributes of ``self`` that are what a parameter says, and that nothing else assigns, each with its
    parameter."""
    values: dict[str, list[facts.Expr | None]] = {}
    for statement in everything_in(file_facts.body):
        for target in statement.assigned:
            for part in everything_in([target], facts.Attribute):
                value = statement.value if isinstance(statement, facts.Assign) and part is target else None
                values.setdefault(part.dotted, []).append(value)
    names = {name: _parameter_in(rows[0]) for name, rows in values.items() if len(rows) == 1 and rows[0] is not None}
    return {name: of for name, of in names.items() if of is not None and name.startswith("self.")}


def _parameter_in(value: facts.Expr | None) -> str | None:
    """The parameter that a value is: ``float(self.get_parameter('delay').value)``."""
    calls = list(calls_in(value))
    reads = [call for call in calls if called_name(call) in _READS]
    if len(reads) != 1 or not all(call is reads[0] or called_name(call) in _CONVERTS for call in calls):
        return None
    plain = not any(
        isinstance(part, (facts.Compare, facts.Unary, facts.Binary, facts.Boolean, facts.Conditional))
        for part in everything_in(() if value is None else [value])
    )
    return reads[0].args[0].value.text if plain and reads[0].args else None


__all__ = ["is_off_by_default"]
