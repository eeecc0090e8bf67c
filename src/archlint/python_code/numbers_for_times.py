"""Numbers where rclpy and tf2_ros take a ``Time`` or a ``Duration``, with which they calculate.

Source: ``Clock.sleep_for`` of rclpy/clock.py; ``Buffer.lookup_transform`` and ``can_transform`` of tf2_ros, and
``rosTimeConverter`` of tf2_py, of humble, jazzy and rolling.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.analysis.source_code import source_code
from archlint.place import Place
from archlint.python_code.rclpy_objects import Kind, objects_of
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import Itself, everything_in, parts_of
from archlint.syntax.walk import given_to

if TYPE_CHECKING:
    from archlint.systems.model import System, WorkspaceIndex


@dataclass(frozen=True)
class NumberForTime:
    """``call`` gets a number for ``parameter``, which takes an object of ``wanted``."""

    call: str
    parameter: str
    wanted: str
    place: Place


def numbers_for_times(workspace: WorkspaceIndex) -> Iterator[NumberForTime]:
    """Those of the Python files that were asked for, outside of test code."""
    for path in workspace.python_files():
        for call, parameter, wanted, span in _of_file(workspace, path) or ():
            yield NumberForTime(call, parameter, wanted, Place(path, *span))


_SLEEPS: Mapping[str, tuple[int, str]] = {"rel_time": (0, "Duration")}
_LOOKS_UP: Mapping[str, tuple[int, str]] = {"time": (2, "Time"), "timeout": (3, "Duration")}
"""The parameters that are no numbers, by position, and what they are."""


@kept_for_each_file
def _of_file(file_facts: facts.Facts) -> list[tuple[str, str, str, facts.Span]]:
    code = objects_of(file_facts)
    uses_tf2 = any(
        part.module.partition(".")[0] == "tf2_ros" for part in everything_in(file_facts.body, facts.ImportFrom)
    )
    uses_tf2 |= any(part.module.partition(".")[0] == "tf2_ros" for part in everything_in(file_facts.body, facts.Import))
    rows = []
    for function in everything_in(file_facts.body, facts.Function):
        scope = code.scope(function)
        for call in parts_of(function.body, facts.Call):
            parameters = _parameters(call, uses_tf2)
            if not parameters or Itself(call) in code.tried or any(argument.star for argument in call.args):
                continue
            for name, (position, wanted) in parameters.items():
                given = given_to(call, name, position)
                if given is not None and scope.kind(given) == Kind.NUMBER:
                    rows.append((call.func.attribute, name, wanted, call.span))
    return rows


def duration_given(system: System, place: Place, keyword: str) -> tuple[str, str] | None:
    """What makes the ``Duration`` that a call gets under a keyword, and the seconds of it as code writes them, if these
    are a number or a name; None where it gets anything else."""
    call = source_code(system).call_at(place)
    given = next((each.value for each in call.args if each.keyword == keyword), None) if call is not None else None
    match given:
        case facts.Call(func=func, args=arguments) if func.last_name == "Duration":
            match arguments:
                case [facts.Argument(keyword="seconds", value=facts.Literal(value=float() | int() as seconds))]:
                    return func.dotted, str(float(seconds))
                case [facts.Argument(keyword="seconds", value=seconds)]:
                    return func.dotted, seconds.dotted
            return func.dotted, ""
    return None


def _parameters(call: facts.Call, uses_tf2: bool) -> Mapping[str, tuple[int, str]]:
    match call.func:
        case facts.Attribute(value=facts.Call(func=facts.Attribute(attr="get_clock")), attr="sleep_for"):
            return _SLEEPS
        case facts.Attribute(attr="lookup_transform" | "can_transform") if uses_tf2:
            return _LOOKS_UP
    return {}


__all__ = ["NumberForTime", "duration_given", "numbers_for_times"]
