"""Classes of messages that a later import hides, so that rclpy gets another class: ``from nav_msgs.msg import Path``,
and then ``from pathlib import Path``."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.place import Place
from archlint.python_code.own_calls import bindings_of
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import given_to

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_INTERFACES = (".msg", ".srv", ".action")
_TYPES = {
    "create_publisher": ("msg_type", 0),
    "create_subscription": ("msg_type", 0),
    "create_client": ("srv_type", 0),
    "create_service": ("srv_type", 0),
    "ActionClient": ("action_type", 1),
    "ActionServer": ("action_type", 1),
}
"""What takes a type, and where."""


@dataclass(frozen=True)
class HiddenMessage:
    """A ``call`` that takes a type and gets ``name`` of ``module``, where the import of ``interface`` is hidden."""

    place: Place
    call: str
    parameter: str
    name: str
    module: str
    interface: str
    hiding: Place
    hidden: Place


_Row = tuple[facts.Span, str, str, str, str, str, facts.Span, facts.Span]


def hidden_messages(workspace: WorkspaceIndex) -> Iterator[HiddenMessage]:
    """Every such call in the files that use rclpy, outside of test code."""
    for path in workspace.python_files(mentioning="rclpy"):
        for span, call, parameter, name, module, interface, hiding, hidden in _rows(workspace, path) or ():
            places = Place(path, *hiding), Place(path, *hidden)
            yield HiddenMessage(Place(path, *span), call, parameter, name, module, interface, *places)


@kept_for_each_file
def _rows(code: facts.Facts) -> list[_Row]:
    hidden = _hidden(code)
    rows: list[_Row] = []
    for call in everything_in(code.body, facts.Call) if hidden else ():
        parameter, at = _TYPES.get(call.func.last_name, ("", 0))
        given = given_to(call, parameter, at) if parameter else None
        if given is not None and given.variable in hidden:
            first, second = hidden[given.variable]
            name, ends = call.func.last_name, (second.span, first.span)
            rows.append((call.span, name, parameter, given.variable, second.module, first.module, *ends))
    return rows


def _hidden(code: facts.Facts) -> dict[str, tuple[facts.ImportFrom, facts.ImportFrom]]:
    """The names that the top level of a file imports twice and binds nowhere else: first an interface, and then
    something from a module that has none."""
    imports: dict[str, list[facts.ImportFrom]] = {}
    for statement in code.body:
        match statement:
            case facts.ImportFrom(names=names, level=0):
                for _, bound in names:
                    imports.setdefault(bound, []).append(statement)
    return {
        name: (rows[0], rows[1])
        for name, rows in imports.items()
        if len(rows) == 2 and bindings_of(code)[name] == 2 and _hides(rows[0].module, rows[1].module)
    }


def _hides(first: str, second: str) -> bool:
    packages = first.partition(".")[0], second.partition(".")[0]
    return first.endswith(_INTERFACES) and not second.endswith(_INTERFACES) and packages[0] != packages[1]


__all__ = ["HiddenMessage", "hidden_messages"]
