"""What C++ code asks rclcpp for that none of the distributions has that are maintained: it does not compile there.

Sources: the headers of rclcpp, Foxy to Rolling.  The namespaces ``executor`` and ``callback_group`` went with Galactic;
with Humble went the ``Duration`` that is made of a number of nanoseconds, and ``declare_parameter`` of a name alone.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_aside
from archlint.analysis.given_nodes import given_nodes
from archlint.place import Place
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import Itself, everything_in, once_for, parts_of

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_MOVED: Mapping[str, str] = {
    "rclcpp.executor.FutureReturnCode": "rclcpp::FutureReturnCode",
    "rclcpp.executor.Executor": "rclcpp::Executor",
    "rclcpp.executor.ExecutorArgs": "rclcpp::ExecutorOptions",
    "rclcpp.callback_group.CallbackGroup": "rclcpp::CallbackGroup",
    "rclcpp.callback_group.CallbackGroupType": "rclcpp::CallbackGroupType",
}
_DURATION = "rclcpp.Duration"
_DECLARES = "declare_parameter"
_OF_VERSIONS = (
    *("FOXY", "GALACTIC", "HUMBLE", "ROS_DISTRO", "ROS_FOXY", "ROS2_FOXY", "ROS_GALACTIC", "ROS_HUMBLE"),
    *("RCLCPP_VERSION_GTE", "RCLCPP_VERSION_MAJOR"),
)
"""Words of files that hold code for several distributions."""
_ASKS_VERSION = r"^[ \t]*#[ \t]*(?:if|ifdef|ifndef|elif)\b.*(?:FOXY|GALACTIC|HUMBLE|IRON|JAZZY|KILTED|ROLLING)"
"""A condition of the preprocessor that does, whatever its macro is called: ``#ifdef POST_FOXY``."""


@dataclass(frozen=True)
class MovedName:
    """A name that rclcpp had in a namespace that is gone, and what it is called since."""

    place: Place
    name: str
    wanted: str


@dataclass
class _Asked:
    moved: list[tuple[str, facts.Span]]
    durations: list[facts.Span]
    declared: list[facts.Span]
    on_parameters: set[facts.Span]
    """Those of ``declared`` that are called on a parameter of a function that is a node."""


def moved_names(workspace: WorkspaceIndex) -> Iterator[MovedName]:
    """Every use of such a name."""
    for path in _files(workspace, "rclcpp"):
        for name, span in _asked(workspace, path).moved:
            shown = name.removeprefix("rclcpp.").replace(".", "::")
            yield MovedName(Place(path, *span), shown, _MOVED[name])


def numbers_as_durations(workspace: WorkspaceIndex) -> Iterator[Place]:
    """Every ``rclcpp::Duration`` that is made of one whole number."""
    for path in _files(workspace, "Duration"):
        yield from (Place(path, *span) for span in _asked(workspace, path).durations)


def declared_by_name_alone(workspace: WorkspaceIndex, of_nodes: Collection[Place]) -> Iterator[Place]:
    """Every call that gives ``declare_parameter`` nothing but a name: it is among the declarations of the known nodes,
    or on what a function takes for a node."""
    for path in _files(workspace, _DECLARES):
        asked = _asked(workspace, path)
        for span in asked.declared:
            place = Place(path, *span)
            if span in asked.on_parameters or place in of_nodes:
                yield place


def _files(workspace: WorkspaceIndex, word: str) -> list[str]:
    return [path for path in workspace.code.cpp_files_that_mention(word) if is_judged(workspace, path)]


def is_judged(workspace: WorkspaceIndex, path: str) -> bool:
    """Whether a file is code that is in use, and that is for one distribution alone."""
    if workspace.roles.is_test(path) or is_aside(workspace, path):
        return False
    if any(workspace.code.mentions(path, word) for word in _OF_VERSIONS):
        return False
    return not workspace.tree.lines_with(path, _ASKS_VERSION)


def _asked(workspace: WorkspaceIndex, path: str) -> _Asked:
    code = workspace.code.cpp_facts_at(path)
    return _Asked([], [], [], set()) if code is None else _asked_in(code)


@once_for
def _asked_in(code: facts.Facts) -> _Asked:
    """What a file asks for, outside of what a condition of the preprocessor may leave out."""
    asked = _Asked([], [], [], set(_on_parameters(code)))
    conditional = _under_conditions(code)
    for part in everything_in(code.body, facts.Attribute):
        if part.dotted in _MOVED and Itself[facts.Base](part) not in conditional:
            asked.moved.append((part.dotted, part.span))
    for call in everything_in(code.body, facts.Call):
        if len(call.args) != 1 or call.args[0].star or Itself[facts.Base](call) in conditional:
            continue
        if isinstance(call.func, facts.Attribute) and call.func.attr == _DECLARES:
            asked.declared.append(call.span)
        # A number of seconds, as in ``Duration(5s)``, is kept as one with a point.
        elif call.func.dotted == _DURATION and _is_whole(call.args[0].value):
            asked.durations.append(call.span)
    return asked


def _on_parameters(code: facts.Facts) -> Iterator[facts.Span]:
    for function in everything_in(code.body, facts.Function):
        nodes = given_nodes(function)
        for call in parts_of(function.body, facts.Call) if nodes else ():
            match call.func:
                case facts.Attribute(value=facts.Name(id=name), attr="declare_parameter") if name in nodes:
                    yield call.span


def _is_whole(value: facts.Expr) -> bool:
    return isinstance(value, facts.Literal) and type(value.value) is int


def _under_conditions(code: facts.Facts) -> set[Itself[facts.Base]]:
    branches = [part for part in everything_in(code.body, facts.If) if isinstance(part.test, facts.Opaque)]
    bodies = [body for branch in branches for body in (branch.body, branch.orelse)]
    return {
        Itself[facts.Base](part)
        for body in bodies
        for kind in (facts.Attribute, facts.Call)
        for part in everything_in(body, kind)
    }


__all__ = ["MovedName", "declared_by_name_alone", "is_judged", "moved_names", "numbers_as_durations"]
