"""What callbacks do with the whole message that they are given, as if it were the value in it: ``if msg == 'stop'``.

Source: rosidl_generator_py makes plain objects of messages, with an attribute for each field, and no operators but
``==`` with another message.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.analysis.source_code import source_code
from archlint.model import Role
from archlint.place import Place
from archlint.python_code.field_operations import deeds_in, goes_wrong
from archlint.python_code.handed_functions import handed_elsewhere
from archlint.python_code.unassigned_attributes import called_in
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.bindings import names_bound
from archlint.syntax.parts import once_for

if TYPE_CHECKING:
    from archlint.model import Callback
    from archlint.ros.interfaces import MessageClass
    from archlint.systems.model import System, WorkspaceIndex

_GIVEN: dict[Role, tuple[MessageClass, ...]] = {Role.SUBSCRIPTION: ("",), Role.SERVICE: ("Request", "Response")}
"""The messages that a callback is called with, in order."""
_TIMES = frozenset({"builtin_interfaces/msg/Time", "builtin_interfaces/msg/Duration"})
"""What API001 judges, with the times of rclpy."""


@dataclass(frozen=True)
class MessageOperation:
    """``msg[0]``, where ``msg`` is the message of a subscription, or the request or response of a service."""

    place: Place
    callback: Callback
    name: str
    type: str
    section_name: MessageClass
    deed: str
    other: str
    by: str
    """The operator or the function."""
    kept: bool = False
    """Whether an attribute holds the message since that came."""


@dataclass(frozen=True)
class Delivered:
    """A function of Python that is called as a callback alone, with messages under some of its ``names``."""

    file: str
    function: facts.Function
    callback: Callback
    type: str
    names: Mapping[str, MessageClass]


def message_operations(system: System) -> Iterator[MessageOperation]:
    """Each such piece of Python code, where every caller passes such a message."""
    for row in delivered(system):
        for deed, other, by, name, span in _rows(row.function):
            if name in row.names:
                place = Place(row.file, *span)
                yield MessageOperation(place, row.callback, name, row.type, row.names[name], deed, other, by)


@once
def delivered(system: System) -> list[Delivered]:
    """The callbacks of which every caller passes messages, outside of test code."""
    of_function: dict[Place, list[Callback]] = {}
    for callback in system.callbacks:
        if callback.function is not None and not system.roles.is_test(callback.file):
            of_function.setdefault(callback.function.place, []).append(callback)
    rows = (_delivered(system, place.file, of_function[place]) for place in sorted(of_function))
    return [row for row in rows if row is not None]


def _delivered(system: System, file: str, callbacks: Sequence[Callback]) -> Delivered | None:
    first, workspace = callbacks[0], system.workspace
    function = source_code(system).definition(first)
    if workspace is None or function is None or not _is_only_a_callback(workspace, file, function):
        return None
    roles = {callback.role for callback in callbacks}
    at = {callback.bound_arguments for callback in callbacks}
    types = {_type_of(callback) for callback in callbacks}
    if len(roles) != 1 or len(at) != 1 or None in types or any(callback.bound_keywords for callback in callbacks):
        return None
    positional = [param.name for param in function.params if param.kind in ("positional_only", "normal")]
    given = dict(zip(positional[first.bound_arguments :], _GIVEN.get(first.role, ()), strict=False))
    type_name = _type_of(first)
    if not given or type_name is None or type_name in _TIMES:
        return None
    return Delivered(file, function, first, type_name, given)


def _type_of(callback: Callback) -> str | None:
    """The interface whose messages a callback gets; None where it gets bytes, or that is not known."""
    creation = callback.creation
    return None if creation is None or creation.raw else creation.type


def _is_only_a_callback(workspace: WorkspaceIndex, file: str, function: facts.Function) -> bool:
    """Whether no code of its file calls a function or gives it to others that may, and it is one of Python."""
    called, handed = called_in(workspace, file), handed_elsewhere(workspace, file)
    if called is None or handed is None or workspace.code.kind_of(file) != "python":
        return False
    return function.name not in called | handed


@once_for
def _rows(function: facts.Function) -> list[tuple[str, str, str, str, facts.Span]]:
    """What a function does with its parameters that no message stands, by their names, but for those that it binds
    again."""
    params = {param.name for param in function.params}.difference(names_bound(function.body))
    return [
        (deed, other, by, value.variable, span)
        for deed, other, by, value, span in deeds_in(function)
        if value.variable in params and goes_wrong("message", deed, other, by)
    ]


__all__ = ["Delivered", "MessageOperation", "delivered", "message_operations"]
