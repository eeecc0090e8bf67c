"""Publishers that a parameter keeps silent, as long as nobody sets it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.opened_guards import asked_before
from archlint.analysis.source_code import source_code
from archlint.connections.arbitration import publishes_with
from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import called_name, calls_in

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.model import ApiCall
    from archlint.systems.model import System
    from archlint.systems.nodes import Endpoint

_READS = frozenset({"get_parameter", "declare_parameter"})


def switch_of(system: System, owner: Endpoint) -> str | None:
    """The parameter that must be set for a publisher to say anything: its default is false, nothing here sets it, and
    each publish() stands behind ``if self.on:`` where ``self.on`` is what the parameter says::

        self.on = bool(self.get_parameter('publish_estop').value)
    """
    off = _off(owner)
    calls = publishes_with(owner) if off else []
    switches = [frozenset(_asked(system, call)) & off for call in calls]
    return min(frozenset.intersection(*switches), default=None) if switches else None


def _off(owner: Endpoint) -> frozenset[str]:
    """The parameters of a publisher's node that are false as it starts."""
    node = owner.node
    declared = [] if node.blueprint is None else node.blueprint.parameters
    return frozenset(
        declaration.name.text
        for declaration in declared
        if declaration.name.text is not None
        and declaration.default is False
        and not node.overrides.get(declaration.name.text)
    )


def _asked(system: System, call: ApiCall) -> Iterator[str]:
    """The parameters that are asked on the way to a call."""
    code = source_code(system)
    asked = {name for place in (call.place, *(frame.place for frame in call.chain)) for name in _names(system, place)}
    file_facts = code.facts_at(call.file)
    assigns = list(everything_in(() if file_facts is None else file_facts.body, facts.Assign))
    for name in asked:
        values = [
            assignment.value for assignment in assigns if any(target.dotted == name for target in assignment.targets)
        ]
        if len(values) == 1 and name.startswith("self."):
            yield from _parameters_in(values[0])


def _names(system: System, place: Place) -> Iterator[str]:
    return asked_before(source_code(system).body_at(place), place)


def _parameters_in(value: facts.Expr) -> Iterator[str]:
    """The parameter that a value is: ``bool(self.get_parameter('on').value)``, and no comparison with it."""
    if any(everything_in([value], facts.Compare)) or any(everything_in([value], facts.Unary)):
        return
    for call in calls_in(value):
        if called_name(call) in _READS and call.args and call.args[0].value.text is not None:
            yield call.args[0].value.text


__all__ = ["switch_of"]
